//! Which parameters have no effect under a law of the scene's own, beside the pictures.

use shading_lab::render::Renderer;
use shading_lab::scene::parameter::Parameter;
use shading_lab::scene::{ReflectionModel, Rgb, Scene, presets};

/// Quantities of a law that depend on a parameter, with another value of it.
const QUANTITIES: [(&str, &str); 9] = [
    ("ka", "material.ka=0.9"),
    ("kd", "material.kd=0.2"),
    ("ks", "material.ks=0.9"),
    ("od", "material.color=[0.1, 0.2, 0.9]"),
    ("os", "material.specular_color=[0.1, 0.2, 0.9]"),
    ("n", "material.n=2"),
    ("m", "material.roughness=0.9"),
    ("eta", "material.ior=[3, 3, 3]"),
    ("N·V", "camera.viewer=infinite"),
];
/// What a law takes the place of.
const REPLACED: [&str; 4] = [
    "material.reflectance=gold",
    "material.extinction=[4, 4, 4]",
    "reflection.distribution=ggx",
    "reflection.backfacing=flip",
];

fn with_law(formula: &str) -> Scene {
    let mut scene = presets::find("sphere").expect("a scene").scene();
    scene.image.size = [48, 48];
    // Without the ambient term, which has Ka and Od of its own.
    scene.ambient.color = Rgb::ZERO;
    scene.material.ka = Rgb::ZERO;
    scene.reflection.model = ReflectionModel::Formula;
    scene.reflection.formula = formula.to_owned();
    assert_eq!(scene.validate(), Ok(()));
    scene
}

/// Returns whether a parameter says that it has no effect, and whether another value of it leaves the picture as it is.
fn idle(scene: &Scene, setting: &str) -> [bool; 2] {
    let (key, _) = setting.split_once('=').expect("a setting");
    let (parameter, _) = Parameter::of_key(key).expect("a key");
    let mut renderer = Renderer::default();
    let before = renderer.render(scene).pixels.clone();
    let other = scene.with_override(setting).expect("a value");
    assert!(other != *scene, "{setting} is another value");
    [
        parameter.idle(scene, 0).is_some(),
        renderer.render(&other).pixels == before,
    ]
}

#[test]
fn a_quantity_has_an_effect_where_the_formula_has_it() {
    for (quantity, setting) in QUANTITIES {
        let used = with_law(&format!(
            "part = 0.1 + {quantity}\n0.2 * part * max(N·L, 0)"
        ));
        assert_eq!(idle(&used, setting), [false; 2], "{setting}");
        // The name of a line hides a quantity.
        let hidden = if quantity.contains('·') {
            "x"
        } else {
            quantity
        };
        let unused = with_law(&format!("{hidden} = 0.5\n{hidden} * max(N·L, 0)"));
        assert_eq!(idle(&unused, setting), [true; 2], "{setting}");
    }
    for setting in REPLACED {
        let all = with_law("kd * od + ks * os * m / eta * max(R·V, 0)^n");
        assert_eq!(idle(&all, setting), [true; 2], "{setting}");
    }
}

#[test]
fn without_a_highlight_another_model_may_be_chosen_and_a_formula_be_typed() {
    let mut scene = with_law("N·L");
    scene.material.ks = Rgb::ZERO;
    assert_eq!(idle(&scene, "reflection.model=phong"), [false; 2]);
    assert_eq!(idle(&scene, "reflection.formula=\"0.5\""), [false; 2]);
    scene.reflection.model = ReflectionModel::Phong;
    assert_eq!(idle(&scene, "reflection.formula=\"0.5\""), [true; 2]);
}
