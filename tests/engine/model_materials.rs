//! Models whose faces have materials of their own: the same pictures as with each material alone, in every mode and variant.

use crate::common::dice::Dice;
use crate::common::simd::levels;
use glam::{DVec3, Vec3};
use shading_lab::analysis::probe::{HitMaterial, probe};
use shading_lab::analysis::study::{Method, StudyQuestion};
use shading_lab::analysis::{Question, Subject, unwatched};
use shading_lab::geometry::{Mesh, ModelMaterial, NO_MATERIAL, tessellate};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Choice, Interpolation, MaterialSource, ObjectKind, Rgb, Scene, ShadingMode,
};
use std::sync::Arc;

/// Returns six materials that differ in every number, with highlights of both forms, without one, and without diffuse light.
fn six() -> Vec<ModelMaterial> {
    let material = |name: &str, ka, kd, ks, n| ModelMaterial {
        name: name.to_owned(),
        ka: Some(Rgb::from_array(ka)),
        kd: Some(Rgb::from_array(kd)),
        ks: Some(Rgb::from_array(ks)),
        n: Some(n),
        ..ModelMaterial::default()
    };
    vec![
        material(
            "red",
            [0.1, 0.0, 0.0],
            [0.7, 0.1, 0.1],
            [0.4, 0.4, 0.4],
            12.0,
        ),
        material(
            "green",
            [0.0, 0.1, 0.0],
            [0.1, 0.6, 0.2],
            [0.3, 0.5, 0.3],
            200.0,
        ),
        material(
            "blue",
            [0.0, 0.0, 0.1],
            [0.1, 0.2, 0.8],
            [0.0, 0.0, 0.0],
            3.0,
        ),
        material(
            "white",
            [0.2, 0.2, 0.2],
            [0.5, 0.5, 0.5],
            [0.6, 0.6, 0.6],
            1.0,
        ),
        material(
            "mirror",
            // Without any other light a kernel may leave out highlights too faint for single precision.
            [0.02, 0.02, 0.02],
            [0.01, 0.01, 0.01],
            [0.9, 0.8, 0.7],
            40.0,
        ),
        material(
            "dark",
            [0.01, 0.02, 0.03],
            [0.05, 0.04, 0.03],
            [0.1, 0.1, 0.1],
            64.0,
        ),
    ]
}

/// Returns a mesh of `kind` whose faces have the materials that `of` gives them.
pub fn model(kind: ObjectKind, segments: u32, of: impl Fn(usize) -> u16) -> Arc<Mesh> {
    let mut scene = Scene::default();
    (scene.object.kind, scene.object.segments, scene.object.rings) =
        (kind, segments, segments / 2 + 1);
    let mut mesh = tessellate(&scene.object);
    mesh.materials = six();
    mesh.face_materials = (0..mesh.face_count()).map(of).collect();
    Arc::new(mesh)
}

/// Returns a cube with a material on each side.
pub fn cube() -> Arc<Mesh> {
    let mut cube = Scene::default();
    (cube.object.kind, cube.object.segments, cube.object.rings) = (ObjectKind::Cube, 3, 2);
    let mesh = tessellate(&cube.object);
    model(ObjectKind::Cube, 3, |face| {
        let normal = mesh.face_normal(face);
        let axis = normal.abs().max_position();
        (2 * axis + usize::from(normal[axis] < 0.0)) as u16
    })
}

pub fn scene(set: &[&str]) -> Scene {
    let mut scene = Scene::default();
    (scene.object.kind, scene.object.path) = (ObjectKind::Obj, Some("cube.obj".into()));
    scene.image.size = [72, 60];
    scene.camera.eye = DVec3::new(2.3, 1.9, 2.6);
    scene.with_overrides(set).expect("sound overrides")
}

pub fn linear(renderer: &mut Renderer, scene: &Scene) -> (Vec<[u32; 4]>, Vec<[u8; 4]>) {
    renderer.keep_linear(true);
    let stored = renderer.render(scene).pixels.clone();
    let bits = renderer
        .linear()
        .iter()
        .map(|pixel| pixel.map(f32::to_bits));
    (bits.collect(), stored)
}

pub const VARIANTS: [&[&str]; 16] = [
    &[],
    &[
        "light=[{position=[3,3,1]}, {kind=\"directional\", direction=[-1,-3,-2], color=[0.3,0.4,0.9]}, {kind=\"spot\", position=[1,2,3], direction=[-1,-2,-3], cone=20}]",
    ],
    &[
        "light=[{position=[3,0.4,0.2], color=[1,0,0]}]",
        "reflection.model=blinn",
    ],
    &[
        "shading.shadows=true",
        "ground.visible=true",
        "light=[{position=[3,3,1]}, {position=[-1,4,2], color=[0.2,0.3,0.4]}]",
    ],
    &[
        "light=[{kind=\"area\", samples=9, position=[2,3,2]}]",
        "shading.shadows=true",
        "ground.visible=true",
    ],
    &["ambient.source=bounce", "ground.visible=true"],
    &[
        "ambient.source=split",
        "ground.visible=true",
        "shading.shadows=true",
    ],
    &["pattern.kind=checker"],
    &[
        "pattern={kind=\"rings\", scale=0.3}",
        "ambient.source=bounce",
        "ground.visible=true",
    ],
    &["reflection.model=cook-torrance"],
    &[
        "reflection.backfacing=flip",
        "light.0.position=[0.2,0.1,0.3]",
        "shading.shadows=true",
    ],
    &[
        "camera.projection=orthographic",
        "camera.viewer=infinite",
        "display.encoding=srgb",
    ],
    &["shading.interpolation=scanline", "object.normals=averaged"],
    &[
        "shading.interpolation=affine",
        "object.normals=averaged",
        "shading.renormalise=false",
    ],
    &[
        "depth_cueing={by=\"vertex\", front=2, back=5, color=[0.2,0.1,0.4]}",
        "shading.flat_at=vertex-mean",
    ],
    &[
        "transparency.kt=0.4",
        "backdrop.pattern=checker",
        "depth_cueing={by=\"pixel\", front=2, back=5}",
        "shading.flat_at=provoking-vertex",
    ],
];

/// Compares every pixel of a picture of `mesh` with the picture in which the material of its face is the scene's for all.
pub fn equal_to_each_alone(
    mesh: &Arc<Mesh>,
    scene: &Scene,
    renderer: impl Fn() -> Renderer,
    what: &str,
) {
    let mut whole = renderer().with_model(Some(Arc::clone(mesh)));
    let (picture, stored) = linear(&mut whole, scene);
    let [width, height] = scene.image.size;
    let faces: Vec<Option<u32>> = (0..width * height)
        .map(|pixel| probe(&mut whole, scene, pixel % width, pixel / width).hit)
        .map(|hit| hit.and_then(|hit| hit.face))
        .collect();
    let mut seen = 0;
    for (number, own) in mesh.materials.iter().enumerate() {
        let shown = |face: &Option<u32>| {
            face.is_some_and(|face| usize::from(mesh.face_material(face as usize)) == number)
        };
        if !faces.iter().any(shown) {
            continue;
        }
        seen += 1;
        let mut alone = scene.clone();
        own.face_material().replace_in(&mut alone);
        alone.material.source = MaterialSource::Scene;
        let mut renderer = renderer().with_model(Some(Arc::clone(mesh)));
        let (one, one_stored) = linear(&mut renderer, &alone);
        for (pixel, face) in faces.iter().enumerate().filter(|(_, face)| shown(face)) {
            let place = [pixel as u32 % width, pixel as u32 / width];
            assert_eq!(
                picture[pixel], one[pixel],
                "{what}: {place:?}, face {face:?}, {}",
                own.name
            );
            assert_eq!(
                stored[pixel], one_stored[pixel],
                "{what}: {place:?}, {}",
                own.name
            );
        }
    }
    assert!(seen >= 3, "{what}: {seen} materials are seen");
}

#[test]
fn a_cube_of_six_materials_is_six_cubes_of_one_to_the_bit_in_every_mode() {
    let mesh = cube();
    assert!((0..6).all(|own| mesh.face_materials.contains(&own)));
    for (index, variant) in VARIANTS.iter().enumerate() {
        for mode in ShadingMode::VALUES {
            let mut scene = scene(variant);
            scene.shading.mode = *mode;
            if index % 2 == 1 {
                scene.camera.eye = DVec3::new(-2.4, -1.5, -2.6);
                scene.ground.height = -3.0;
            }
            let what = format!("{mode:?} {variant:?}");
            equal_to_each_alone(&mesh, &scene, Renderer::default, &what);
        }
    }
}

#[test]
fn every_level_shades_materials_alike_and_scattered_ones_too() {
    // Materials that change from face to face, so that a band's pixels of one material lie apart.
    let mesh = model(ObjectKind::Sphere, 24, |face| (face * 7 % 6) as u16);
    for level in levels() {
        for mode in ShadingMode::VALUES {
            let mut scene = scene(&["shading.shadows=true", "ground.visible=true"]);
            scene.shading.mode = *mode;
            let renderer = || Renderer::default().with_level(level);
            equal_to_each_alone(&mesh, &scene, renderer, &format!("{level:?} {mode:?}"));
        }
    }
}

#[test]
fn nothing_left_out_changes_nothing() {
    let mesh = cube();
    for variant in VARIANTS {
        for mode in ShadingMode::VALUES {
            let mut scene = scene(variant);
            scene.shading.mode = *mode;
            let pictures = [false, true].map(|nothing| {
                let mut renderer = Renderer::default().with_model(Some(Arc::clone(&mesh)));
                renderer.leave_nothing_out(nothing);
                renderer.render(&scene).pixels.clone()
            });
            let [planned, all] = pictures;
            assert!(planned == all, "{mode:?} {variant:?}");
        }
    }
}

#[test]
fn the_probe_sees_what_the_picture_shows_with_the_faces_material() {
    let mut dice = Dice(35);
    let mut asked = 0;
    while asked < 1000 {
        let kind = dice.of(&[
            ObjectKind::Sphere,
            ObjectKind::Torus,
            ObjectKind::Cube,
            ObjectKind::Cone,
        ]);
        let step = dice.of(&[1, 2, 3, 5]);
        let mesh = model(kind, 12, |face| match face * step % 7 {
            6 => NO_MATERIAL,
            own => own as u16,
        });
        let variant = dice.of(&VARIANTS);
        let mut scene = scene(variant);
        scene.shading.mode = dice.of(ShadingMode::VALUES);
        let mut renderer = Renderer::default().with_model(Some(Arc::clone(&mesh)));
        let (picture, _) = linear(&mut renderer, &scene);
        let [width, height] = scene.image.size;
        for _ in 0..40 {
            let [x, y] = [width, height].map(|side| dice.between(0.0, side.into()) as u32);
            let Some(hit) = probe(&mut renderer, &scene, x, y).hit else {
                continue;
            };
            asked += 1;
            let face = hit.face.expect("a model has faces") as usize;
            let own = mesh.materials.get(usize::from(mesh.face_material(face)));
            let expected = own.map(|own| HitMaterial {
                name: own.name.clone(),
                numbers: own.face_material(),
            });
            assert_eq!(hit.material, expected, "{x}, {y}");
            let shown =
                picture[(y * width + x) as usize].map(|bits| f64::from(f32::from_bits(bits)));
            for (a, b) in hit.sum.to_array().into_iter().zip(shown) {
                assert!(
                    (a - b).abs() < 2e-3 * (1.0 + b.abs()),
                    "{kind:?} {variant:?} {:?} {x}, {y}: {a}, {b}",
                    scene.shading.mode
                );
            }
        }
    }
}

#[test]
fn a_change_in_the_scene_is_that_of_the_model_and_the_scenes_material_is_for_all_who_ask() {
    let mesh = cube();
    let drawn = |mesh: &Arc<Mesh>, scene: &Scene| {
        let mut renderer = Renderer::default().with_model(Some(Arc::clone(mesh)));
        renderer.render(scene).pixels.clone()
    };
    let plain = scene(&[]);
    let changed = scene(&[
        "object.material=[{name=\"red\", kd=[0.1,0.7,0.3], n=90}, {name=\"nobody\", ka=1}]",
    ]);
    let mut own = Mesh::clone(&mesh);
    (own.materials[0].kd, own.materials[0].n) = (Some(Rgb::new(0.1, 0.7, 0.3)), Some(90.0));
    for mode in ShadingMode::VALUES {
        let [plain, changed] = [&plain, &changed].map(|scene| {
            let mut scene = scene.clone();
            scene.shading.mode = *mode;
            scene
        });
        assert!(
            drawn(&mesh, &changed) == drawn(&Arc::new(own.clone()), &plain),
            "{mode:?}"
        );
        assert!(drawn(&mesh, &changed) != drawn(&mesh, &plain), "{mode:?}");
        // The scene's material for all is a model without materials.
        let mut all = changed.clone();
        all.material.source = MaterialSource::Scene;
        let mut bare = Mesh::clone(&mesh);
        (bare.materials, bare.face_materials) = (vec![], vec![]);
        assert!(
            drawn(&mesh, &all) == drawn(&Arc::new(bare), &plain),
            "{mode:?}"
        );
    }
}

#[test]
fn a_renderer_keeps_nothing_of_a_material_that_has_changed() {
    let mesh = cube();
    for mode in ShadingMode::VALUES {
        let mut renderer = Renderer::default().with_model(Some(Arc::clone(&mesh)));
        for set in [
            &[][..],
            &["object.material=[{name=\"red\", kd=0.2}]"],
            &[
                "object.material=[{name=\"red\", kd=0.2}]",
                "material.source=scene",
            ],
            &["ambient.source=bounce", "ground.visible=true"],
            &[
                "ambient.source=bounce",
                "ground.visible=true",
                "object.material=[{name=\"white\", ka=0.9}]",
            ],
            &[],
        ] {
            let mut scene = scene(set);
            scene.shading.mode = *mode;
            let kept = renderer.render(&scene).pixels.clone();
            let mut fresh = Renderer::default().with_model(Some(Arc::clone(&mesh)));
            assert!(kept == fresh.render(&scene).pixels, "{mode:?} {set:?}");
        }
    }
}

#[test]
fn changes_are_refused_with_their_place() {
    let refused = |text: &str| Scene::parse(text, "a.toml").expect_err(text).to_string();
    for (text, line, words) in [
        ("[[object.material]]\nka = 1\n", 1, "name"),
        (
            "[[object.material]]\nname = \"a\"\n[[object.material]]\nname = \"a\"\n",
            4,
            "earlier",
        ),
        ("[[object.material]]\nname = \"a\"\nka = -1\n", 3, "-1"),
        (
            "[[object.material]]\nname = \"a\"\nn = \"many\"\n",
            3,
            "many",
        ),
        ("[[object.material]]\nname = \"a\"\nshine = 4\n", 3, "shine"),
        (
            "[[object.material]]\nname = \"a\"\nreflectance = \"tin\"\n",
            3,
            "tin",
        ),
        ("[material]\nsource = \"file\"\n", 2, "model"),
        ("[object]\nmaterial = 3\n", 2, "material"),
    ] {
        let error = refused(text);
        assert!(
            error.starts_with(&format!("a.toml:{line}:")) && error.contains(words),
            "{text:?}: {error}"
        );
    }
    let many: String = (0..=512)
        .map(|k| format!("[[object.material]]\nname = \"m{k}\"\n"))
        .collect();
    assert!(refused(&many).contains("512"));
}

#[test]
fn changes_go_through_files_settings_and_links() {
    let scene = scene(&[
        "object.material=[{name=\"red plastic\", ka=0.5, kd=[0.1,0.2,0.3]}, {name=\"紅\", n=inf}]",
    ]);
    assert_eq!(
        Scene::parse(&scene.to_toml(), "again.toml").expect("a sound file"),
        scene
    );
    // A key that is taken back is the model's again.
    let back = scene
        .with_override("object.material.0.ka=model")
        .expect("a sound override");
    assert_eq!(back.object.materials[0].ka, None);
    let plain = Scene {
        object: shading_lab::scene::Object {
            materials: vec![],
            ..scene.object.clone()
        },
        ..scene.clone()
    };
    for (from, to) in [
        (&scene, &back),
        (&back, &scene),
        (&plain, &scene),
        (&scene, &plain),
    ] {
        let settings = to.settings_from(from);
        let again = from.with_overrides(&settings).expect("sound settings");
        assert_eq!(&again, to);
    }
}

#[test]
fn the_plan_counts_the_evaluations_with_each_material() {
    let mesh = cube();
    for mode in ShadingMode::VALUES {
        let mut scene = scene(&["shading.flat_at=centre"]);
        scene.shading.mode = *mode;
        let mut renderer = Renderer::default().with_model(Some(Arc::clone(&mesh)));
        renderer.render(&scene);
        let counts = renderer.material_counts();
        let sum: u64 = counts.iter().map(|(_, count)| count).sum();
        let terms = renderer.terms();
        let count = |name: &str| {
            let term = terms.iter().find(|term| term.name.to_string() == name);
            term.expect(name).evaluations
        };
        assert_eq!((counts.len(), count("light 1: N·L")), (6, sum), "{mode:?}");
        // Blue has no highlight, so that it is evaluated for the others only.
        let blue = counts
            .iter()
            .find(|(name, _)| name == "blue")
            .expect("blue")
            .1;
        assert_eq!(count("light 1: specular"), sum - blue, "{mode:?}");
        scene.material.source = MaterialSource::Scene;
        renderer.render(&scene);
        assert_eq!(renderer.material_counts(), []);
    }
}

#[test]
fn a_study_draws_materials_by_scalar_methods_too_and_refuses_one_exponent_for_all() {
    let mut subject = Subject::new(scene(&["image.size=[24, 20]"]));
    subject.model = Some(cube());
    let question = |methods: &[Method], n: &[f64]| StudyQuestion {
        methods: methods.to_vec(),
        segments: vec![],
        n: n.to_vec(),
        repeats: 1,
        ..StudyQuestion::default()
    };
    let exponents = question(&[Method::Flat], &[5.0]);
    let refused = exponents
        .answer(&subject, &unwatched)
        .expect_err("exponents");
    assert!(refused.contains("material.source=scene"), "{refused}");
    let all = [
        Method::Phong,
        Method::PhongScalar,
        Method::Taylor,
        Method::Angular,
    ];
    let study = question(&all, &[]).answer(&subject, &unwatched);
    let study = study.expect("a study");
    let error = |method: Method| {
        let mut rows = study.rows.iter();
        let row = rows.find(|row| {
            let interpolation = row.setting.interpolation;
            row.setting.method == method && interpolation != Some(Interpolation::Affine)
        });
        row.map(|row| (row.error_rms, row.interior_pixels))
    };
    let [phong, scalar] =
        [Method::Phong, Method::PhongScalar].map(|method| error(method).expect("a row"));
    assert!(
        phong.1 > 50 && (phong.0 - scalar.0).abs() < 1e-5,
        "{phong:?} {scalar:?}"
    );
    // Colours of vertices are a carried value more.
    let mut tinted = Mesh::clone(&cube());
    (tinted.colors, tinted.corner_colors) = (vec![Vec3::X], vec![0; tinted.corners.len()]);
    subject.model = Some(Arc::new(tinted));
    let scalar = question(&[Method::PhongScalar], &[]);
    assert!(scalar.answer(&subject, &unwatched).is_err());
    subject.scene.material.source = MaterialSource::Scene;
    assert!(
        exponents.answer(&subject, &unwatched).is_ok()
            && scalar.answer(&subject, &unwatched).is_ok()
    );
}
