//! Scenes exported to OpenGL: the content of the texts, and the same pictures drawn by Mesa.
//!
//! The pictures need a C compiler, EGL and OpenGL (Debian: gcc libegl-dev libgl-dev libgl1-mesa-dri); without them those tests
//! print a message and are skipped.

mod compiled;
mod mesa;
mod own_law;

use glam::{DMat4, DVec3};
use shading_lab::export::{Export, ExportError, Limit, glsl_330, opengl_c, opengl_c_snippet};
use shading_lab::geometry::tessellate;
use shading_lab::scene::{Scene, View, presets};

/// Returns the built-in scene `name` with overrides.
fn scene(name: &str, overrides: &[&str]) -> Scene {
    let preset = presets::find(name).expect("a built-in scene");
    preset
        .scene()
        .with_overrides(overrides)
        .expect("sound overrides")
}

fn program(scene: &Scene) -> Export {
    opengl_c(scene, &tessellate(&scene.object)).expect("a mesh of moderate size")
}

fn snippet(scene: &Scene) -> Export {
    opengl_c_snippet(scene, &tessellate(&scene.object))
}

#[test]
fn every_built_in_scene_is_exported_alike_each_time() {
    for preset in presets::ALL {
        let scene = preset.scene();
        for export in [snippet(&scene), program(&scene), glsl_330(&scene)] {
            for part in &export.parts {
                assert!(
                    part.text.is_ascii() && part.text.ends_with("}\n"),
                    "{} {}",
                    preset.name,
                    part.ending
                );
                assert!(
                    part.text.lines().all(|line| line == line.trim_end()),
                    "{} {}",
                    preset.name,
                    part.ending
                );
            }
        }
        assert_eq!(snippet(&scene), snippet(&scene));
        assert_eq!(program(&scene), program(&scene));
        assert_eq!(glsl_330(&scene), glsl_330(&scene));
    }
}

#[test]
fn the_calls_carry_the_numbers_of_the_scene() {
    let set = [
        "material.n=17",
        "reflection.model=blinn",
        "material.ka=0.5",
        "material.color=[0.5, 0.25, 1]",
    ];
    let text = &snippet(&scene("sphere", &set)).parts[0].text;
    for line in [
        "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 17.0f); /* n of (N.H)^n */",
        "const GLfloat ambient[] = {0.25f, 0.125f, 0.5f, 1.0f}; /* Ka*Od */",
        "const GLfloat place[] = {2.4f, 3.0f, 3.2f, 1.0f};",
        "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    assert!(!text.contains("GL_LIGHT1"));
}

#[test]
fn silent_lights_are_left_out() {
    let mute = scene("three-lights", &["light.1.mute=true"]);
    let text = &snippet(&mute).parts[0].text;
    assert!(
        text.contains("Light 1")
            && !text.contains("Light 0")
            && !text.contains("Light 2,")
            && text.contains("Light 3")
            && !text.contains("GL_LIGHT2")
    );
    let shaders = glsl_330(&mute);
    assert!(
        shaders.parts[1].text.contains("light_2(") && !shaders.parts[1].text.contains("light_1(")
    );
    let dark = scene("sphere", &["light=[]"]);
    assert!(!snippet(&dark).parts[0].text.contains("glLightf"));
}

/// Counts the limits of `export` that have a message.
fn count(export: &Export, key: &str) -> usize {
    let limits = export.limits.iter();
    limits.filter(|limit| limit.key == key).count()
}

#[test]
fn fixed_function_names_what_it_cannot_say() {
    let plain = [
        "shading.mode=gouraud",
        "reflection.model=blinn",
        "material.n=100",
    ];
    assert_eq!(program(&scene("sphere", &plain)).limits, [] as [Limit; 0]);
    for (set, key) in [
        ("shading.mode=phong", "export-limit-phong"),
        ("shading.mode=exact", "export-limit-exact"),
        ("shading.mode=flat", "export-limit-flat-centre"),
        (
            "shading={mode=\"flat\", flat_at=\"vertex-mean\"}",
            "export-limit-flat-mean",
        ),
        ("shading.interpolation=affine", "export-limit-affine"),
        ("shading.interpolation=scanline", "export-limit-scanline"),
        ("reflection.model=phong", "export-limit-phong-lobe"),
        ("reflection.model=cook-torrance", "export-limit-microfacets"),
        ("reflection.model=formula", "export-limit-own-law"),
        ("material.n=129", "export-limit-shininess"),
        ("material.reflectance=gold", "export-limit-reflectance"),
        ("reflection.backfacing=flip", "export-limit-two-side"),
        ("pattern.kind=checker", "export-limit-pattern"),
        ("light.0.attenuation=viewer", "export-limit-light-viewer"),
        (
            "light.0={kind=\"spot\", softness=0.5}",
            "export-limit-light-soft",
        ),
        (
            "light.0={kind=\"spot\", exponent=200}",
            "export-limit-light-exponent",
        ),
        (
            "light.0={kind=\"area\", samples=9}",
            "export-limit-light-area",
        ),
        ("shading.shadows=true", "export-limit-shadows"),
        ("transparency.kt=0.5", "export-limit-transparency"),
        ("ground.visible=true", "export-limit-ground"),
        ("backdrop.pattern=checker", "export-limit-backdrop"),
        ("depth_cueing.by=vertex", "export-limit-cueing-vertices"),
        (
            "depth_cueing={by=\"pixel\", front=3.5, front_scale=0.9}",
            "export-limit-cueing-beyond",
        ),
        (
            "depth_cueing={by=\"pixel\", front_scale=0.5, back_scale=0.5}",
            "export-limit-cueing-constant",
        ),
        (
            "depth_cueing={by=\"pixel\", color=[2,0,0]}",
            "export-limit-cueing-colour",
        ),
        ("ambient.source=bounce", "export-limit-bounce"),
        ("display.overflow=scale", "export-limit-scale"),
        ("display.overflow=mark", "export-limit-hatching"),
        ("display.encoding=srgb", "export-limit-srgb"),
    ] {
        let export = program(&scene("sphere", &[&plain[..], &[set]].concat()));
        assert_eq!(count(&export, key), 1, "{set}: {:?}", export.limits);
        // Comments are broken into lines.
        let comment = export.parts[0]
            .text
            .replace("\n *  ", "")
            .replace("\n * ", " ");
        let words = export.limits.iter().find(|limit| limit.key == key);
        assert!(
            words.is_some_and(|limit| comment.contains(&limit.to_string())),
            "{set}"
        );
    }
}

#[test]
fn what_fits_is_no_limit() {
    let plain = [
        "shading.mode=gouraud",
        "reflection.model=blinn",
        "material.n=100",
    ];
    for set in [
        "light.0={kind=\"area\", samples=8}",
        "light.0={kind=\"spot\"}",
        "light.0.attenuation=light",
        "light.0.attenuation=inverse-square",
        "depth_cueing.by=pixel",
        "depth_cueing={by=\"pixel\", front=2, back=7, front_scale=0.8, back_scale=0.3}",
        "depth_cueing={by=\"vertex\", back_scale=1}",
        "shading.mode=interpolated",
        "shading={mode=\"flat\", flat_at=\"provoking-vertex\"}",
        // Only the distance from the light to the nearest vertex decides whether min(1, …) is at work.
        "light.0={attenuation=\"quadratic\", position=[0,0,3], c1=0, c2=0.51, c3=0}",
        "light.0={attenuation=\"quadratic\", position=[0,0,3], c1=0, c2=0.1, c3=0}",
    ] {
        assert_eq!(
            program(&scene("sphere", &[&plain[..], &[set]].concat())).limits,
            [] as [Limit; 0],
            "{set}"
        );
    }
    let near = "light.0={attenuation=\"quadratic\", position=[0,0,3], c1=0, c2=0.4, c3=0}";
    assert_eq!(
        count(
            &program(&scene("sphere", &[&plain[..], &[near]].concat())),
            "export-limit-light-unclamped"
        ),
        1
    );
    // The program makes OpenGL keep intensities above 1; whoever copies the calls must be told so.
    assert_eq!(
        count(
            &snippet(&scene("sphere", &plain)),
            "export-limit-vertex-clamp"
        ),
        1
    );
}

#[test]
fn more_than_eight_lights_are_too_many() {
    let list = format!("light=[{}]", ["{kind=\"point\"}"; 10].join(","));
    let export = program(&scene("sphere", &[&list]));
    assert_eq!(count(&export, "export-limit-lights"), 1);
    assert!(
        export.parts[0].text.contains("GL_LIGHT7") && !export.parts[0].text.contains("GL_LIGHT8")
    );
}

#[test]
fn shaders_name_what_they_cannot_say() {
    for name in [
        "sphere",
        "teapot",
        "blinn",
        "attenuation",
        "infinite",
        "tinted-highlight",
    ] {
        assert_eq!(
            glsl_330(&scene(name, &[])).limits,
            [] as [Limit; 0],
            "{name}"
        );
    }
    for (set, key) in [
        ("shading.mode=exact", "export-limit-exact-pixels"),
        ("shading.mode=flat", "export-limit-flat-centre"),
        ("shading.interpolation=scanline", "export-limit-scanline"),
        ("shading.shadows=true", "export-limit-shadows"),
        ("transparency.kt=0.5", "export-limit-transparency"),
        ("ground.visible=true", "export-limit-ground"),
        ("display.overflow=scale", "export-limit-scale"),
        ("camera.eye=[0,0,1e12]", "export-limit-lengths"),
    ] {
        assert_eq!(count(&glsl_330(&scene("sphere", &[set])), key), 1, "{set}");
    }
}

/// Checks that the shader's matrix projects a point as the view does.
#[test]
fn a_point_appears_where_the_view_has_it() {
    for projection in ["perspective", "orthographic"] {
        let camera = format!("camera={{eye=[1,2,3], roll=25, projection=\"{projection}\"}}");
        let scene = scene("sphere", &[&camera, "image.size=[640,480]"]);
        let text = &glsl_330(&scene).parts[0].text;
        let (_, matrix) = text
            .split_once("clip_from_world = mat4(")
            .expect("a matrix");
        let (matrix, _) = matrix.split_once(')').expect("its end");
        let numbers: Vec<f64> = matrix
            .split(',')
            .map(|number| number.trim().parse().expect("a number"))
            .collect();
        let clip = DMat4::from_cols_slice(&numbers);
        let point = DVec3::new(0.3, -0.4, 0.5);
        let placed = clip * point.extend(1.0);
        let x = (placed.x / placed.w * 0.5 + 0.5) * 640.0;
        let y = (0.5 - placed.y / placed.w * 0.5) * 480.0;
        let (pixel, _) = View::new(&scene.camera, [640, 480])
            .project(point)
            .expect("in front of the eye");
        assert!(
            (pixel.x - x).abs() < 1e-3 && (pixel.y - y).abs() < 1e-3,
            "{projection}: {pixel} {x} {y}"
        );
        assert!((placed.z / placed.w).abs() < 1.0);
    }
}

#[test]
fn a_name_cannot_end_a_comment() {
    let mut hostile = scene("sphere", &[]);
    for name in ["*/ int x; /*", "line\nbreak", "a\\", "??/", "Schlüssel"] {
        hostile.lights[0].name = name.to_owned();
        for export in [snippet(&hostile), glsl_330(&hostile)] {
            assert!(
                export.parts.iter().all(|part| !part.text.contains(name)),
                "{name}"
            );
        }
    }
    hostile.lights[0].name = "key light".to_owned();
    assert!(
        snippet(&hostile).parts[0]
            .text
            .contains("Light 1 \"key light\", a point light")
    );
}

#[test]
fn a_mesh_beyond_measure_is_refused() {
    let large = scene("sphere", &["object.segments=1024", "object.rings=1024"]);
    let error = opengl_c(&large, &tessellate(&large.object));
    assert_eq!(
        error,
        Err(ExportError::MeshTooLarge {
            triangles: 2 * 1024 * 1023
        })
    );
    assert!(!snippet(&large).parts.is_empty());
}
