//! The terms of the equation as products: their factors multiply to the probe's terms, which add up to the pixel.

use shading_lab::analysis::probe::{Here, Product, clearest_pixel, digits, digits_below, probe};
use shading_lab::render::Renderer;
use shading_lab::scene::{Choice, PatternKind, Rgb, Scene, ShadingMode, presets};

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
    assert!(
        (made - value).abs().max_element() <= 1e-9 * (1.0 + value.max_element()),
        "{what}: {made} and {value}"
    );
}

/// Checks the terms of every built-in scene, in every shading mode, at a few pixels.
#[test]
fn the_columns_multiply_to_the_terms_and_the_terms_add_up_to_the_pixel() {
    for preset in presets::ALL {
        let mut scene = preset.scene();
        scene.image.size = [32, 32];
        (scene.object.segments, scene.object.rings) = (12, 6);
        let mut renderer = Renderer::default();
        for &mode in ShadingMode::VALUES {
            scene.shading.mode = mode;
            for [x, y] in [[16, 16], [19, 13], [12, 18], [16, 24]] {
                let Some(hit) = probe(&mut renderer, &scene, x, y).hit else {
                    continue;
                };
                check(
                    Here {
                        scene: &hit.scene_of(&scene),
                        hit: &hit,
                    },
                    &format!("{} {mode:?} {x},{y}", preset.name),
                );
            }
        }
    }
}

fn check(here: Here<'_>, what: &str) {
    assert_makes_its_value(&here.ambient(), &format!("{what} ambient"));
    let mut sum = here.hit.ambient;
    for light in here.lights() {
        if let Some(product) = light.by_law() {
            assert_makes_its_value(&product, &format!("{what} law"));
            assert_eq!(light.terms.specular, Rgb::ZERO, "{what}");
        } else if light.terms.why_nothing().is_none() {
            assert_makes_its_value(&light.diffuse(), &format!("{what} diffuse"));
            assert_makes_its_value(&light.specular(), &format!("{what} specular"));
        }
        sum += light.terms.diffuse + light.terms.specular;
    }
    assert!(
        (sum.max(Rgb::ZERO) - here.hit.reflected)
            .abs()
            .max_element()
            < 1e-9,
        "{what}: {sum}"
    );
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
    let hit = probe(&mut Renderer::default(), &scene, 16, 16)
        .hit
        .expect("the sphere");
    let here = Here {
        scene: &scene,
        hit: &hit,
    };
    let light = here.lights().next().expect("a light");
    let factors = |product: Product| {
        product
            .columns
            .into_iter()
            .flat_map(|c| c.factors)
            .collect::<Vec<_>>()
    };
    assert_eq!(
        factors(light.diffuse()),
        ["{Ip}", "{Kd}", "{Od}", "({N}·{L})"]
    );
    assert_eq!(factors(light.specular()), ["{Ip}", "{Ks}", "({R}·{V})^n"]);
}

#[test]
fn a_column_has_one_number_of_decimals_and_chosen_numbers_keep_their_few_digits() {
    for (values, texts) in [
        ([0.12, 0.28, 1.0], ["0.12", "0.28", "1.00"]),
        ([0.125, 0.5, 2.0], ["0.125", "0.500", "2.000"]),
        ([0.812_345, 0.5, 0.25], ["0.812", "0.500", "0.250"]),
        ([0.812_345, 0.012_345, 0.0], ["0.8123", "0.0123", "0.0000"]),
        ([12.3456, 0.333_333, 1.0], ["12.35", "0.33", "1.00"]),
    ] {
        assert_eq!(digits_below(Rgb::from_array(values)), texts);
    }
}

#[test]
fn very_small_and_very_large_numbers_have_a_power_of_ten() {
    for (value, text) in [
        (0.000_012_34, "1.2×10⁻⁵"),
        (-1.5e20, "−1.5×10²⁰"),
        (0.0, "0.0000"),
        (-0.0, "0.0000"),
        (0.554_4, "0.5544"),
        (153.0, "153.0"),
        (f64::INFINITY, "∞"),
    ] {
        assert_eq!(digits(value), text);
    }
}

#[test]
fn without_a_pixel_one_is_found_whose_vectors_are_apart() {
    for name in ["sphere", "teapot", "torus", "three-lights"] {
        let scene = presets::find(name).expect("a scene").scene();
        let hit = clearest_pixel(&mut Renderer::default(), &scene)
            .hit
            .expect("the object");
        let light = hit
            .lights
            .iter()
            .find(|light| light.n_dot_l > 0.0)
            .expect("a light that shines");
        for angle in [light.theta, light.phi, hit.normal.angle_between(hit.view)] {
            assert!(
                (15.0..=65.0).contains(&angle.to_degrees()),
                "{name}: {angle}"
            );
        }
    }
    let mut dark = Scene {
        lights: vec![],
        ..Scene::default()
    };
    dark.image.size = [3, 2];
    assert!(
        clearest_pixel(&mut Renderer::default(), &dark)
            .hit
            .is_some()
    );
    dark.camera.target = dark.camera.eye * 2.0;
    let missed = clearest_pixel(&mut Renderer::default(), &dark);
    assert_eq!((missed.pixel, missed.hit.is_none()), ([1, 1], true));
}

/// Checks what is said of a pixel beside the object: the floor, up to its horizon or the wall that stands on it.
#[test]
fn beside_the_object_are_the_floor_and_the_background() {
    let mut scene = presets::find("shadows").expect("a scene").scene();
    scene.image.size = [120, 90];
    let mut renderer = Renderer::default();
    let mut beside = |scene: &Scene, x: u32, y: u32| {
        let probe = probe(&mut renderer, scene, x, y);
        assert!(probe.hit.is_none(), "{x}, {y}");
        probe.beside_is_floor(scene)
    };
    assert!(beside(&scene, 60, 86) && beside(&scene, 4, 60));
    scene.camera.target.y = 3.0;
    assert!(!beside(&scene, 60, 4), "above the horizon");
    let mut low = |scene: &Scene| (0..90).rev().find(|y| !beside(scene, 4, *y));
    let horizon = low(&scene).expect("a horizon");
    scene.backdrop.pattern = PatternKind::Checker;
    scene.backdrop.distance = 0.5;
    let wall = low(&scene).expect("a wall");
    assert!(wall > horizon, "{wall}, {horizon}");
    scene.backdrop.pattern = PatternKind::None;
    scene.ground.visible = false;
    assert!(!beside(&scene, 60, 86));
}
