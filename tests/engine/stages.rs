//! Incremental rendering: a change re-runs only the stages that read it, and reused results give the same picture as a new
//! renderer.

use crate::common::dice::Dice;
use crate::common::tries::tries;
use shading_lab::render::{DrawTime, Renderer, Stage, coarser_size};
use shading_lab::scene::{
    Choice, Interpolation, ObjectKind, ReflectionModel, Scene, ShadingMode, Viewer, presets,
};

fn scene(mode: ShadingMode) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [160, 120];
    scene.shading.mode = mode;
    scene
}

fn ran(renderer: &Renderer) -> Vec<Stage> {
    renderer
        .report()
        .stages
        .iter()
        .filter(|run| run.ran)
        .map(|run| run.stage)
        .collect()
}

#[test]
fn nothing_moved_nothing_runs() {
    for &mode in ShadingMode::VALUES {
        let mut renderer = Renderer::default();
        renderer.render(&scene(mode));
        renderer.render(&scene(mode));
        assert_eq!(ran(&renderer), [], "{mode:?}");
    }
}

#[test]
fn a_light_or_an_exponent_touches_neither_geometry_nor_coverage() {
    for &mode in ShadingMode::VALUES {
        let mut renderer = Renderer::default();
        let mut scene = scene(mode);
        renderer.render(&scene);
        scene.lights[0].position.x -= 1.0;
        renderer.render(&scene);
        let expected: &[Stage] = match mode {
            ShadingMode::Flat => &[Stage::VertexShading, Stage::Display],
            ShadingMode::Interpolated | ShadingMode::Gouraud => {
                &[Stage::VertexShading, Stage::Interpolation, Stage::Display]
            }
            ShadingMode::Phong | ShadingMode::Exact => &[Stage::PixelShading, Stage::Display],
        };
        assert_eq!(ran(&renderer), expected, "light, {mode:?}");
        scene.material.n = 7.0;
        renderer.render(&scene);
        assert_eq!(ran(&renderer), expected, "exponent, {mode:?}");
    }
}

#[test]
fn the_camera_leaves_the_geometry_alone() {
    let mut renderer = Renderer::default();
    let mut scene = scene(ShadingMode::Phong);
    renderer.render(&scene);
    scene.camera.eye.x += 1.0;
    renderer.render(&scene);
    assert!(!ran(&renderer).contains(&Stage::Geometry));
    assert!(ran(&renderer).contains(&Stage::Coverage));
}

/// Makes changes of every kind in turn, and compares with a renderer that has never seen the scene before.
#[test]
fn what_is_kept_is_what_would_be_drawn() {
    type Change = (&'static str, fn(&mut Scene));
    let changes: [Change; 16] = [
        ("light", |s| s.lights[0].position.x = -1.0),
        ("gouraud", |s| s.shading.mode = ShadingMode::Gouraud),
        ("kd", |s| s.material.kd *= 0.5),
        ("flat", |s| s.shading.mode = ShadingMode::Flat),
        ("n", |s| s.material.n = 100.0),
        ("camera", |s| s.camera.eye.y = 2.0),
        ("torus", |s| s.object.kind = ObjectKind::Torus),
        ("phong", |s| s.shading.mode = ShadingMode::Phong),
        ("affine", |s| {
            s.shading.interpolation = Interpolation::Affine;
        }),
        ("no renormalisation", |s| s.shading.renormalise = false),
        ("scan line", |s| {
            s.shading.interpolation = Interpolation::Scanline;
        }),
        ("exact", |s| s.shading.mode = ShadingMode::Exact),
        ("size", |s| s.image.size = [121, 77]),
        ("background", |s| s.image.background.y = 0.5),
        ("mark", |s| {
            s.display.overflow = shading_lab::scene::Overflow::Mark;
        }),
        ("srgb", |s| {
            s.display = shading_lab::scene::Display {
                overflow: shading_lab::scene::Overflow::Clamp,
                encoding: shading_lab::scene::Encoding::Srgb,
            }
        }),
    ];
    let mut renderer = Renderer::default();
    let mut scene = scene(ShadingMode::Phong);
    for (name, change) in changes {
        change(&mut scene);
        let kept = renderer.render(&scene).clone();
        let fresh = Renderer::default().render(&scene).clone();
        assert!(kept.pixels == fresh.pixels, "after the change of {name}");
    }
}

/// Makes any change after any other, there and back.
#[test]
fn what_is_kept_is_what_would_be_drawn_on_any_way() {
    const CHANGES: [&[&str]; 23] = [
        &[
            "shading.mode=flat",
            "shading.mode=gouraud",
            "shading.mode=phong",
            "shading.mode=phong",
            "shading.mode=exact",
        ],
        &[
            "material.n=0",
            "material.n=20",
            "material.n=300",
            "material.n=1e8",
            "material.n=inf",
        ],
        &["material.ka=0", "material.ka=0.3"],
        &["material.kd=0", "material.kd=0.7"],
        &["material.ks=0", "material.ks=0.5", "material.ks=1.5"],
        &["material.color=[1, 0, 0.5]", "material.color=[0.2, 0.9, 1]"],
        &[
            "light.0.color=[1, 1, 1]",
            "light.0.color=[0, 0, 0]",
            "light.0.color=[0.2, 0.9, 0.4]",
        ],
        &["light.1.mute=true", "light.1.mute=false"],
        &["light.1.position=[-3, 1, 2]", "light.1.position=[0, -4, 2]"],
        &[
            "shading.interpolation=affine",
            "shading.interpolation=perspective",
            "shading.interpolation=scanline",
        ],
        &["shading.renormalise=true", "shading.renormalise=false"],
        &["shading.shadows=true", "shading.shadows=false"],
        &["ground.visible=true", "ground.visible=false"],
        &[
            "display.overflow=clamp",
            "display.overflow=mark",
            "display.overflow=scale",
        ],
        &["display.encoding=raw", "display.encoding=srgb"],
        &[
            "depth_cueing.by=off",
            "depth_cueing.by=vertex",
            "depth_cueing.by=pixel",
        ],
        &["pattern.kind=none", "pattern.kind=checker"],
        &["transparency.kt=0", "transparency.kt=0.4"],
        &[
            "reflection.model=phong",
            "reflection.model=blinn",
            "reflection.model=cook-torrance",
        ],
        &["camera.viewer=local", "camera.viewer=infinite"],
        &[
            "camera.eye=[0, 1, 3]",
            "camera.eye=[2, 1, 3]",
            "camera.eye=[0, 0, 60000]",
        ],
        &[
            "object.kind=sphere",
            "object.kind=torus",
            "object.kind=cube",
        ],
        &["image.size=[47, 33]", "image.size=[40, 40]"],
    ];
    let mut scene = scene(ShadingMode::Phong);
    (scene.object.segments, scene.object.rings) = (9, 6);
    scene.lights.push(scene.lights[0].clone());
    compare_kept(scene, &CHANGES, 3000);
}

#[test]
fn a_bounce_that_is_kept_is_what_would_be_gathered() {
    const CHANGES: [&[&str]; 15] = [
        &[
            "ambient.source=constant",
            "ambient.source=bounce",
            "ambient.source=split",
        ],
        &["reflection.backfacing=clamp", "reflection.backfacing=flip"],
        &[
            "light.0.position=[2, 3, 1]",
            "light.0.position=[0.3, -0.6, 0.8]",
            "light.0.position=[0, 1, -4]",
        ],
        &["light.0.color=[1, 1, 1]", "light.0.color=[0.2, 0.9, 0.4]"],
        &["light.0.mute=true", "light.0.mute=false"],
        &[
            "ground.visible=true",
            "ground.visible=true",
            "ground.visible=false",
        ],
        &["ground.height=-1", "ground.height=-0.4"],
        &["ground.kd=0.9", "ground.kd=0.3"],
        &["backdrop.pattern=none", "backdrop.pattern=checker"],
        &["backdrop.distance=1", "backdrop.distance=3"],
        &["material.kd=0.2", "material.kd=0.7"],
        &["pattern.kind=none", "pattern.kind=checker"],
        &[
            "shading.mode=flat",
            "shading.mode=phong",
            "shading.mode=exact",
        ],
        &["camera.eye=[0, 1, 3]", "camera.eye=[2, 1, 3]"],
        &[
            "object.kind=sphere",
            "object.kind=torus",
            "object.kind=plane",
        ],
    ];
    let mut scene = scene(ShadingMode::Phong);
    (scene.object.segments, scene.object.rings) = (9, 6);
    compare_kept(scene, &CHANGES, 400);
}

/// Asserts that a scene is drawn after each of some changes as a renderer draws it that has never seen it.
fn compare_kept(mut scene: Scene, changes: &[&[&str]], count: u64) {
    let mut renderer = Renderer::default();
    let mut dice = Dice(99);
    let mut way = std::collections::VecDeque::new();
    for _ in 0..tries(count) {
        let choices = dice.of(changes);
        let change = dice.of(choices);
        scene = scene.with_override(change).expect(change);
        way.push_back(change);
        if way.len() > 12 {
            way.pop_front();
        }
        if scene.validate().is_err() {
            continue;
        }
        let kept = renderer.render(&scene).clone();
        let fresh = Renderer::default().render(&scene).clone();
        assert!(
            kept.pixels == fresh.pixels,
            "the last changes: {way:#?}\n{}",
            scene.to_toml()
        );
    }
}

/// Switches settings that change neither coverage nor the equation's coefficients.
#[test]
fn switches_of_the_shading_are_noticed() {
    let mut renderer = Renderer::default();
    let mut scene = scene(ShadingMode::Phong);
    (scene.object.segments, scene.object.rings, scene.material.n) = (6, 4, 20.0);
    for renormalise in [true, false, true] {
        scene.shading.renormalise = renormalise;
        let kept = renderer.render(&scene).clone();
        assert!(
            kept.pixels == Renderer::default().render(&scene).pixels,
            "renormalise = {renormalise}"
        );
    }
    let mut glass = scene.clone();
    (glass.object.kind, glass.transparency.kt) = (ObjectKind::Torus, 0.4);
    (glass.object.segments, glass.object.rings) = (48, 24);
    (glass.camera.eye, glass.shading.renormalise) = (glam::DVec3::new(0.0, 1.0, 3.0), true);
    glass.lights[0].position = glam::DVec3::new(-3.0, 1.0, 2.0);
    let shadowed = [true, false, true].map(|shadows| {
        glass.shading.shadows = shadows;
        let kept = renderer.render(&glass).clone();
        assert!(
            kept.pixels == Renderer::default().render(&glass).pixels,
            "shadows = {shadows}"
        );
        kept.pixels
    });
    assert!(shadowed[0] != shadowed[1]);
    let model = std::sync::Arc::new(shading_lab::geometry::tessellate(&scene.object));
    scene.object.kind = ObjectKind::Obj;
    renderer.set_model(Some(model));
    renderer.render(&scene);
    scene.shading.mode = ShadingMode::Exact;
    renderer.render(&scene);
    assert!(
        ran(&renderer).contains(&Stage::PixelShading),
        "a model's exact picture is evaluated in double precision"
    );
}

#[test]
fn an_infinite_viewer_and_far_lights_change_the_picture() {
    let mut renderer = Renderer::default();
    let mut scene = scene(ShadingMode::Phong);
    let local = renderer.render(&scene).clone();
    scene.camera.viewer = Viewer::Infinite;
    let infinite = renderer.render(&scene).clone();
    assert!(local.pixels != infinite.pixels);
    scene.reflection.model = ReflectionModel::Blinn;
    assert!(renderer.render(&scene).pixels != infinite.pixels);
}

/// Checks that a picture is drawn only as coarsely during a drag as it must be to keep up, and never too coarsely to be
/// recognised.
#[test]
fn a_picture_that_keeps_up_is_drawn_whole() {
    let factors = |fixed: u64, whole: &[u64]| -> Vec<u32> {
        let ms = |ms: u64| ms * 1_000_000;
        let time = |whole: &u64| DrawTime {
            whole: ms(*whole),
            fixed: ms(fixed),
        };
        whole.iter().map(|whole| time(whole).coarseness()).collect()
    };
    assert_eq!(
        factors(0, &[0, 5, 8, 9, 32, 33, 288, 100_000]),
        [1, 1, 1, 2, 2, 3, 6, 8]
    );
    // Of 6 ms that stay, 2 are left for the pixels. Of 16 there is no time, and a quarter more is little beside them.
    assert_eq!(factors(6, &[6, 8, 9, 14, 15]), [1, 1, 2, 2, 3]);
    assert_eq!(factors(16, &[16, 20, 21, 32, 33, 1000]), [1, 1, 2, 2, 3, 8]);
    assert_eq!(coarser_size([641, 480], 2), [321, 240]);
    assert_eq!(coarser_size([3, 1], 8), [1, 1]);
}

#[test]
fn a_coarser_picture_tells_what_does_not_depend_on_the_resolution() {
    let whole = 60_000_000;
    let time = DrawTime { whole, fixed: 0 };
    for (fixed, coarser) in [(0, 2), (15_000_000, 2), (15_000_000, 3), (60_000_000, 8)] {
        let pixels = u64::from(coarser * coarser);
        let learned = time.after(coarser, fixed + (whole - fixed) / pixels);
        assert!(learned.fixed.abs_diff(fixed) < 100, "{learned:?}");
        assert_eq!(learned.whole, whole);
    }
    // Faster than its pixels alone, and slower than the whole picture: both are noise.
    assert_eq!(time.after(2, 1_000_000).fixed, 0);
    let slower = time.after(2, 70_000_000);
    assert_eq!((slower.whole, slower.fixed), (70_000_000, 70_000_000));
    assert_eq!(slower.coarseness(), 1);
}

#[test]
fn a_bounce_is_gathered_at_fewer_points_while_something_is_dragged() {
    let mut scene = presets::find("one-bounce").expect("a scene").scene();
    scene.image.size = coarser_size([1280, 800], 5);
    let whole = Renderer::default().render(&scene).clone();
    let drawn = |coarser| {
        let mut renderer = Renderer::default();
        renderer.stand_in(coarser);
        let pixels = &renderer.render(&scene).pixels;
        let apart = pixels.iter().zip(&whole.pixels).map(|(a, b)| {
            let apart = (0..3).map(|k| a[k].abs_diff(b[k]));
            f64::from(apart.max().unwrap_or(0))
        });
        apart.sum::<f64>() / whole.pixels.len() as f64
    };
    assert_eq!(drawn(1), 0.0);
    let apart = drawn(5);
    assert!(apart > 0.0 && apart < 1.5, "{apart} code values");
}
