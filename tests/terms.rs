//! The terms of the equation as products: they multiply to what the probe has, and add up to the pixel.

use shading_lab::analysis::{Factor, Here, Product, probe};
use shading_lab::render::Renderer;
use shading_lab::scene::{Rgb, Scene, ShadingMode, presets};

const MODES: [ShadingMode; 5] =
    [ShadingMode::Flat, ShadingMode::Interpolated, ShadingMode::Gouraud, ShadingMode::Phong, ShadingMode::Exact];

fn multiplied(product: &Product) -> Rgb {
    let (mut sum, mut running) = (Rgb::ZERO, Rgb::ONE);
    for column in &product.columns {
        if column.added {
            sum += running;
            running = Rgb::ONE;
        }
        running *= column.values;
    }
    sum + running
}

fn assert_makes_its_value(product: &Product, what: &str) {
    let (made, value) = (multiplied(product), product.value);
    assert!((made - value).abs().max_element() <= 1e-9 * (1.0 + value.max_element()), "{what}: {made} and {value}");
}

/// The terms of every built-in scene, in every shading mode, at a few pixels.
#[test]
fn the_columns_multiply_to_the_terms_and_the_terms_add_up_to_the_pixel() {
    for preset in presets::ALL {
        let mut scene = preset.scene();
        scene.image.size = [32, 32];
        (scene.object.segments, scene.object.rings) = (12, 6);
        let mut renderer = Renderer::default();
        for mode in MODES {
            scene.shading.mode = mode;
            for [x, y] in [[16, 16], [19, 13], [12, 18], [16, 24]] {
                let Some(hit) = probe(&mut renderer, &scene, x, y).hit else { continue };
                check(Here { scene: &scene, hit: &hit }, &format!("{} {mode:?} {x},{y}", preset.name));
            }
        }
    }
}

fn check(here: Here<'_>, what: &str) {
    assert_makes_its_value(&here.ambient(), &format!("{what} ambient"));
    let mut sum = here.hit.ambient;
    for light in here.lights() {
        if light.terms.why_nothing().is_none() {
            assert_makes_its_value(&light.diffuse(), &format!("{what} diffuse"));
            assert_makes_its_value(&light.specular(), &format!("{what} specular"));
        }
        sum += light.terms.diffuse + light.terms.specular;
    }
    assert!((sum.max(Rgb::ZERO) - here.hit.reflected).abs().max_element() < 1e-9, "{what}: {sum}");
    if let Some(mixture) = here.mixture() {
        assert_makes_its_value(&mixture, &format!("{what} mixture"));
    }
    if let Some(fading) = here.fading() {
        assert_makes_its_value(&fading, &format!("{what} fading"));
    }
}

#[test]
fn a_factor_that_is_one_by_construction_is_left_out() {
    let mut scene = Scene::default();
    scene.image.size = [32, 32];
    let hit = probe(&mut Renderer::default(), &scene, 16, 16).hit.expect("the sphere");
    let here = Here { scene: &scene, hit: &hit };
    let light = here.lights().next().expect("a light");
    let factors = |product: Product| product.columns.into_iter().flat_map(|c| c.factors).collect::<Vec<_>>();
    assert_eq!(factors(light.diffuse()), [Factor::Ip, Factor::Kd, Factor::Od, Factor::Facing]);
    assert_eq!(factors(light.specular()), [Factor::Ip, Factor::Ks, Factor::Lobe]);
}
