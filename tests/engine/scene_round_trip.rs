//! Scenes written to files and read back: nothing is lost, whatever they contain.

use crate::common::properties;
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use shading_lab::scene::{
    Ambient, AmbientSource, AreaShape, Attenuation, Backdrop, Backfacing, Camera, Choice, Compare,
    CompareView, CuedBy, DepthCueing, DifferenceKind, Display, Distribution, Encoding, FlatAt,
    Framing, Ground, Image, Interpolation, Light, LightKind, Material, NormalSource, Object,
    ObjectKind, Overflow, Pane, Pattern, PatternKind, Projection, Reflectance, Reflection,
    ReflectionModel, Scene, SceneDescription, Shading, ShadingMode, Shared, Through, Transparency,
    Viewer, Weighting,
};
use std::f64::consts::TAU;

/// Laws with what may be damaged on the way through a file, a setting or a link.
pub const LAWS: [&str; 9] = [
    "kd * N·L",
    "spot = max(R·V, 0)\nkd * N·L + ks * spot^n",
    "a = 1;\tb = N·L ; (a*b == 1)*kd",
    "# \"one\" 'two' \"\"\" ''' C:\\new\\table \\\nkd",
    "kd // the end\r\n + ks\r\n",
    "\n\n  kd\n\t\n",
    "0",
    "α = 0.5\n√(α²) × (1 − α) # 100 % + & ? #=;",
    "(N·L > 0) * (kd*od/π)",
];

fn number(least: f64, greatest: f64) -> impl Strategy<Value = f64> {
    prop_oneof![
        least..=greatest,
        Just(least),
        Just(greatest),
        Just(1.0 / 3.0)
    ]
}

fn triple(least: f64, greatest: f64) -> impl Strategy<Value = DVec3> {
    prop_oneof![
        [
            number(least, greatest),
            number(least, greatest),
            number(least, greatest)
        ]
        .prop_map(DVec3::from_array),
        number(least, greatest).prop_map(DVec3::splat),
    ]
}

fn word<T: Clone + std::fmt::Debug + 'static>(words: &'static [T]) -> impl Strategy<Value = T> {
    proptest::sample::select(words)
}

prop_compose! {
    fn light()(
        name in "\\PC{0,20}",
        kind in word(LightKind::VALUES),
        mute in any::<bool>(),
        solo in any::<bool>(),
        shape in word(AreaShape::VALUES),
        cone in number(0.1, 90.0),
        exponent in number(0.0, 1e3),
        softness in number(0.0, 1.0),
        size in triple(0.0, 1e30),
        samples in 1..=1024u32,
        attenuation in word(Attenuation::VALUES),
        position in triple(-1e30, 1e30),
        direction in triple(1.0, 1e30),
        color in triple(0.0, 1e30),
        k in number(0.0, 1e30),
        c in triple(1e-300, 1e30),
    ) -> Light {
        let [c1, c2, c3] = c.to_array();
        let (extent, radius) = ([size.x, size.y], size.z);
        Light {
            name, kind, mute, solo, position, direction, color, cone, exponent, softness, shape, extent, radius, samples,
            attenuation, k, c1, c2, c3,
        }
    }
}

prop_compose! {
    fn camera()(
        eye in triple(-1e3, 1e3),
        projection in word(Projection::VALUES),
        roll in number(-1e30, 1e30),
        fov_y in number(1e-3, 179.0),
        height in number(1e-30, 1e30),
        framing in word(Framing::VALUES),
        viewer in word(Viewer::VALUES),
    ) -> Camera {
        let target = eye + DVec3::new(1.0, 0.25, -2.0);
        Camera { eye, target, up: DVec3::new(0.1, 1.0, 0.0), roll, projection, fov_y, height, framing, viewer }
    }
}

/// Generates fans of convex polygons over the corners of a circle of any position and size, or none.
fn polygons() -> impl Strategy<Value = (Shared<DVec3>, Shared<Shared<u32>>, Shared<DVec3>)> {
    let shape = (
        0usize..6,
        3..12u32,
        triple(-1e3, 1e3),
        number(1e-6, 1e20),
        any::<bool>(),
    );
    shape.prop_map(|(count, corners, centre, size, normals)| {
        if count == 0 {
            return Default::default();
        }
        let on_circle = |k: u32| {
            DVec3::from((
                DVec2::from_angle(f64::from(k) / f64::from(corners) * TAU),
                0.25 * f64::from(k),
            ))
        };
        let vertices: Shared<DVec3> = (0..corners).map(|k| on_circle(k) * size + centre).collect();
        let faces = (0..count)
            .map(|k| (0..corners).map(|c| (c + k as u32) % corners).collect())
            .collect();
        let count = if normals { corners } else { 0 };
        (
            vertices,
            faces,
            (0..count).map(|k| on_circle(k) * size).collect(),
        )
    })
}

prop_compose! {
    fn object()(
        kind in word(&[
            ObjectKind::Sphere, ObjectKind::Torus, ObjectKind::Cylinder, ObjectKind::Cone, ObjectKind::Cube,
            ObjectKind::Plane, ObjectKind::Teapot, ObjectKind::Corrugated, ObjectKind::Balls, ObjectKind::Obj, ObjectKind::Polygons,
        ]),
        segments in 3..=4096u32,
        rings in 3..=4096u32,
        normals in word(NormalSource::VALUES),
        weighting in word(Weighting::VALUES),
        path in "[^\u{0}]{1,20}",
        named in any::<bool>(),
        fit in any::<bool>(),
        (vertices, faces, vertex_normals) in polygons(),
    ) -> Object {
        let path = (named || kind == ObjectKind::Obj).then(|| path.into());
        Object { kind, segments, rings, normals, weighting, path, fit, vertices, faces, vertex_normals, materials: vec![] }
    }
}

prop_compose! {
    fn settings()(
        model in word(ReflectionModel::VALUES),
        formula in word(&LAWS),
        distribution in word(Distribution::VALUES),
        backfacing in word(Backfacing::VALUES),
        mode in word(ShadingMode::VALUES),
        flat_at in word(FlatAt::VALUES),
        interpolation in word(Interpolation::VALUES),
        renormalise in any::<bool>(),
        shadows in any::<bool>(),
        overflow in word(Overflow::VALUES),
        encoding in word(Encoding::VALUES),
    ) -> (Reflection, Shading, Display) {
        (
            Reflection { model, formula: formula.to_owned(), distribution, backfacing },
            Shading { mode, flat_at, interpolation, renormalise, shadows },
            Display { overflow, encoding },
        )
    }
}

prop_compose! {
    fn material()(
        coefficients in [triple(0.0, 1e6), triple(0.0, 1e6), triple(0.0, 1e6), triple(0.0, 1e6)],
        specular_color in triple(0.0, 1e6),
        n in prop_oneof![0.0..1e6, Just(f64::INFINITY), Just(f64::MAX)],
        roughness in number(1e-3, 1.0),
        reflectance in word(Reflectance::VALUES),
        ior in triple(0.01, 100.0),
        extinction in triple(0.0, 100.0),
    ) -> Material {
        let [ka, kd, ks, color] = coefficients;
        Material { ka, kd, ks, n, roughness, color, specular_color, reflectance, ior, extinction, source: shading_lab::scene::MaterialSource::Model }
    }
}

prop_compose! {
    fn surroundings()(
        kinds in [
            word(PatternKind::VALUES),
            word(PatternKind::VALUES),
        ],
        colors in [triple(0.0, 1e6), triple(0.0, 1e6), triple(0.0, 1e6)],
        scale in number(1e-4, 1e4),
        kt in number(0.0, 1.0),
        ior in number(0.1, 10.0),
        through in word(Through::VALUES),
        visible in any::<bool>(),
        height in number(-1e30, 1e30),
        coefficients in [number(0.0, 1e6), number(0.0, 1e6)],
    ) -> (Pattern, Transparency, Ground, Backdrop) {
        let [ka, kd] = coefficients;
        (
            Pattern { kind: kinds[0], color: colors[0], scale },
            Transparency { kt, ior, through },
            Ground { visible, height, ka, kd, color: colors[1] },
            Backdrop { pattern: kinds[1], color: colors[2], scale, distance: height },
        )
    }
}

prop_compose! {
    fn compare()(
        view in word(&[CompareView::Panes, CompareView::Wipe, CompareView::Difference]),
        difference in word(DifferenceKind::VALUES),
        reference in 0..=6u32,
        wipe in 0.0..=1.0f64,
        gain in 1.0..=Compare::MAX_GAIN,
        name in "[a-zα-ω ]{0,9}",
        names in proptest::collection::vec("[a-zα-ω ]{0,9}", 0..=Compare::MAX_PANES),
        setting in word(&["shading.mode=exact", "material.n=inf", "material.kd=[0.1, 0.2, 0.3]", "shading.renormalise=false"]),
    ) -> Compare {
        let panes: Vec<Pane> =
            names.into_iter().map(|name| Pane { name, set: vec![setting.to_owned()] }).collect();
        let view = if panes.is_empty() { CompareView::Single } else { view };
        let reference = reference.min(panes.len() as u32 + 1);
        Compare { view, name, reference, wipe, difference, gain, panes }
    }
}

prop_compose! {
    fn depth_cueing()(
        by in word(CuedBy::VALUES),
        front in number(0.0, 1e29),
        beyond in number(0.0, 1e29),
        scales in [number(0.0, 1.0), number(0.0, 1.0)],
        color in triple(0.0, 1e30),
    ) -> DepthCueing {
        let back = (front + beyond).max(front.next_up());
        DepthCueing { by, front, back, front_scale: scales[0], back_scale: scales[1], color }
    }
}

prop_compose! {
    fn scene()(
        about in ["\\PC{0,80}", "\\PC{0,300}", "\\PC{0,80}", "[a-z-]{0,9}"]
            .prop_map(|[title, sentence, topic, view]| SceneDescription { title, sentence, topic, view }),
        camera in camera(),
        object in object(),
        (reflection, shading, display) in settings(),
        width in 1..=16_384u32,
        height in 1..=8192u32,
        background in triple(0.0, 1e30),
        material in material(),
        (pattern, transparency, ground, backdrop) in surroundings(),
        depth_cueing in depth_cueing(),
        ambient in triple(0.0, 1e30),
        source in word(AmbientSource::VALUES),
        lights in proptest::collection::vec(light(), 0..4),
        compare in compare(),
    ) -> Scene {
        let samples: u64 = lights.iter().map(|light| u64::from(light.sample_count())).sum();
        let fits = u64::from(width) * u64::from(height) * samples <= Scene::MAX_SHADOW_BITS;
        let shading = Shading { shadows: shading.shadows && fits, ..shading };
        Scene {
            version: 1,
            about,
            camera,
            image: Image { size: [width, height], background },
            object,
            material,
            pattern,
            transparency,
            reflection,
            shading,
            display,
            ground,
            backdrop,
            depth_cueing,
            ambient: Ambient { color: ambient, source },
            lights,
            compare,
        }
    }
}

#[test]
fn a_sound_scene_survives_its_file_and_its_settings() {
    let run = || {
        proptest!(|(scene in scene())| {
            prop_assert_eq!(scene.validate(), Ok(()));
            prop_assert_eq!(Scene::parse(&scene.to_toml(), "s.toml"), Ok(scene.clone()));
            let mut base = Scene::default();
            base.lights.push(Light::default());
            base.compare.panes.push(Pane::of(&["material.n=5"]));
            for base in [Scene::default(), base] {
                let settings = scene.settings_from(&base);
                let made = base.with_overrides(&settings).expect("sound settings");
                prop_assert!(made.differences(&scene).next().is_none(), "{settings:?}");
                prop_assert_eq!(made.settings_from(&scene), Vec::<String>::new());
            }
        });
    };
    // Without optimisation a whole scene's strategy needs more than the stack that a test has.
    let thread = std::thread::Builder::new()
        .stack_size(16 << 20)
        .spawn(run)
        .expect("a thread");
    assert!(thread.join().is_ok(), "a scene does not survive its file");
}

#[test]
fn a_name_without_letters_is_no_key() {
    for text in [
        ".={}",
        ".=0",
        "..=0",
        ".shading.mode=flat",
        "shading.={}",
        "light.={}",
    ] {
        let found = Scene::default().with_override(text);
        assert!(found.is_err(), "{text}");
    }
    for text in ["\"\" = {}", "[\"\".shading]\nmode = \"flat\""] {
        assert!(Scene::parse(text, "s.toml").is_err(), "{text}");
    }
}

proptest! {
    #![proptest_config(properties::config(file!()))]

    #[test]
    fn any_text_is_read_or_refused(text in ".{0,200}") {
        let _ = Scene::parse(&text, "s.toml");
        let _ = Scene::default().with_override(&text);
    }

    #[test]
    fn any_number_is_accepted_only_if_sound(
        key in word(&["camera.fov_y", "camera.height", "material.n", "light.0.k", "camera.eye.2", "material.ks"]),
        bits in any::<u64>(),
    ) {
        let value = f64::from_bits(bits);
        if let Ok(scene) = Scene::default().with_override(&format!("{key}={value:?}")) {
            prop_assert!(scene.validate().is_ok());
            prop_assert!(!value.is_nan());
        }
    }
}
