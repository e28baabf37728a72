//! The scene's own law, typed as a formula, beside the laws that are built in.

mod counted;

use counted::{Counted, counted};
use glam::DVec3;
use shading_lab::analysis::probe::probe;
use shading_lab::illumination::{Equation, V3};
use shading_lab::render::{Frame, Per, Renderer, Stage, Term};
use shading_lab::scene::{
    Backfacing, Choice, Encoding, FlatAt, Interpolation, Overflow, Projection, Reflectance,
    Reflection, ReflectionModel, Rgb, Scene, ShadingMode, presets,
};

const PHONG: &str = Reflection::PHONG;
/// Blinn's law as a textbook writes it; the built-in one has no highlight behind the surface.
const BLINN: &str =
    "h = normalize(L + V)\nkd * od * max(N·L, 0) + ks * os * max(dot(N, h), 0)^n * (N·L > 0)";
const LAMBERT: &str = "kd * od * max(N·L, 0)";
/// Phong's law with the reflectance W of glass, by Fresnel's formulas for light that is not polarised.
const FRESNEL: &str = "\
c = N·L
s = 1 - c^2
a = sqrt(eta^2 - s)
w = ((a - c)/(a + c))^2 * (1 + ((c*a - s)/(c*a + s))^2)/2
kd * od * max(c, 0) + ks * os * w * max(R·V, 0)^n * (c > 0)";
/// Phong's law of a surface that turns N towards the light; R is the same for −N.
const TWO_SIDED: &str = "kd * od * abs(N·L) + ks * os * max(R·V, 0)^n";

/// The scenes of Phong's, Blinn's and Lambert's laws whose law is a formula of that text.
fn typed() -> impl Iterator<Item = (&'static str, Scene, Scene)> {
    presets::ALL.iter().filter_map(|preset| {
        let mut built_in = preset.scene();
        built_in.image.size = [96, 96];
        let is_glass = built_in.material.reflectance == Reflectance::Glass;
        let two_sided = built_in.reflection.backfacing == Backfacing::Flip;
        let formula = match built_in.reflection.model {
            ReflectionModel::Phong if is_glass => FRESNEL,
            ReflectionModel::Phong if two_sided => TWO_SIDED,
            ReflectionModel::Phong if built_in.material.ks == Rgb::ZERO => LAMBERT,
            ReflectionModel::Phong => PHONG,
            ReflectionModel::Blinn => BLINN,
            ReflectionModel::CookTorrance | ReflectionModel::Formula => return None,
        };
        let mut own = built_in.clone();
        own.reflection.model = ReflectionModel::Formula;
        own.reflection.formula = formula.to_owned();
        if is_glass {
            own.material.ior = Rgb::new(1.51432, 1.51872, 1.52668);
        }
        own.validate().expect("a law");
        Some((preset.name, built_in, own))
    })
}

/// Returns the number of pixels that differ by more than one code value, and the largest difference.
fn difference(a: &Frame, b: &Frame) -> (usize, u8) {
    let apart = |(a, b): (&[u8; 4], &[u8; 4])| {
        let channels = a.iter().zip(b).map(|(a, b)| a.abs_diff(*b));
        channels.max().unwrap_or(0)
    };
    let all: Vec<u8> = a.pixels.iter().zip(&b.pixels).map(apart).collect();
    let wrong = all.iter().filter(|apart| **apart > 1).count();
    (wrong, all.into_iter().max().unwrap_or(0))
}

#[test]
fn a_typed_law_draws_what_the_built_in_one_draws() {
    let mut renderer = Renderer::default();
    let mut wrong = vec![];
    let mut count = 0;
    for (name, built_in, own) in typed() {
        for &mode in ShadingMode::VALUES {
            let draw = |renderer: &mut Renderer, scene: &Scene| {
                let mut scene = scene.clone();
                scene.shading.mode = mode;
                renderer.render(&scene).clone()
            };
            let (a, b) = (draw(&mut renderer, &built_in), draw(&mut renderer, &own));
            let (pixels, most) = difference(&a, &b);
            count += 1;
            if pixels > 0 {
                wrong.push(format!("{name} {mode:?}: {pixels} pixels, up to {most}"));
            }
        }
    }
    assert_eq!(count % 5, 0, "all modes");
    assert!(count > 5 * 40, "{count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Returns a cube of half-edge 1/√3 with a light at that height over the plane of its face towards x, and a law that shows the sign
/// of N·L.
fn cube_lit_along_a_face(height: f64) -> Scene {
    let mut scene = presets::find("cube").expect("a scene").scene();
    scene.image.size = [96, 96];
    scene.lights[0].position = DVec3::new(3.0_f64.sqrt().recip() + height, 0.3, 1.7);
    scene.reflection.model = ReflectionModel::Formula;
    scene.reflection.formula = "(N·L > 0)".to_owned();
    scene
}

#[test]
fn rounding_decides_no_step_where_the_light_is_in_the_plane_of_a_surface() {
    let mut renderer = Renderer::default();
    for mode in [
        ShadingMode::Flat,
        ShadingMode::Gouraud,
        ShadingMode::Phong,
        ShadingMode::Exact,
    ] {
        let mut draw = |height: f64| {
            let mut scene = cube_lit_along_a_face(height);
            scene.shading.mode = mode;
            renderer.render(&scene).clone()
        };
        let [below, within, above] = [-0.01, 0.0, 0.01].map(&mut draw);
        assert!(below.pixels == within.pixels, "{mode:?}");
        assert!(difference(&within, &above).0 > 500, "{mode:?}");
    }
}

#[test]
fn a_law_of_nothing_and_one_without_a_value_draw_the_ambient_term() {
    let mut renderer = Renderer::default();
    let (_, mut scene, mut own) = typed().next().expect("a scene");
    scene.lights.clear();
    let dark = renderer.render(&scene).clone();
    for formula in ["0", "1/0", "log(-1)", "(N·L - N·L)/0"] {
        own.reflection.formula = formula.to_owned();
        assert!(renderer.render(&own).pixels == dark.pixels, "{formula}");
    }
    own.reflection.formula = "N·L".to_owned();
    assert!(renderer.render(&own).pixels != dark.pixels);
}

/// Returns the code value of an intensity.
fn code(scene: &Scene, linear: f64) -> f64 {
    let v = linear.clamp(0.0, 1.0);
    let encoded = match scene.display.encoding {
        Encoding::Raw => v,
        _ if v <= 0.003_130_8 => 12.92 * v,
        _ => 1.055 * v.powf(1.0 / 2.4) - 0.055,
    };
    255.0 * encoded
}

#[test]
fn the_probe_has_the_numbers_of_the_picture() {
    let mut renderer = Renderer::default();
    let mut compared = 0;
    // Where a pixel overflows, a mark is stored instead.
    let typed = typed().filter(|(_, _, own)| own.display.overflow != Overflow::Mark);
    for (name, _, own) in typed {
        for [x, y] in [[48, 48], [40, 30], [60, 50]] {
            let Some(hit) = probe(&mut renderer, &own, x, y).hit else {
                continue;
            };
            let encoded = (hit.sum / hit.divisor)
                .to_array()
                .map(|linear| code(&own, linear));
            compared += 1;
            for (channel, stored) in encoded.into_iter().zip(hit.stored) {
                assert!(
                    (channel - f64::from(stored)).abs() <= 1.5,
                    "{name} {x} {y}: {channel} {stored}"
                );
            }
        }
    }
    assert!(compared > 60, "{compared}");
}

/// Returns the terms in the plan of a picture with their names, which may be equal.
fn terms(scene: &Scene) -> Vec<(String, Term)> {
    let mut renderer = Renderer::default();
    renderer.render(scene);
    let named = |term: Term| (term.name.to_string(), term);
    renderer.terms().into_iter().map(named).collect()
}

/// Returns the operations of the law in the plan of a picture: once, for each light, and at its points.
fn planned(scene: &Scene) -> [u64; 3] {
    let mut plain = scene.clone();
    plain.reflection.formula = "0".to_owned();
    let others = terms(&plain);
    let mut own = terms(scene);
    own.retain(|(name, _)| others.iter().all(|(other, _)| name != other));
    own.iter()
        .fold([0; 3], |[once, light, point], (_, term)| match term.per {
            Per::Frame => [once + term.evaluations, light, point],
            Per::Light => [once, light + term.evaluations, point],
            _ => [once, light, point + term.evaluations],
        })
}

/// Returns the operations of the law at one point, for all lights, as a number that counts finds them: what is done besides is
/// done for a law of nothing as well, the distance to the light for one that names it.
fn done_at_a_point(scene: &Scene) -> u64 {
    let count = |formula: &str| {
        let mut scene = scene.clone();
        scene.reflection.formula = formula.to_owned();
        let equation = Equation::<f64>::new(&scene);
        let number = |[x, y, z]: [f64; 3]| V3::new(Counted(x), Counted(y), Counted(z));
        let site = equation.site(number([0.1, 0.05, -0.8]), number([0.0, 0.6, 0.8]));
        counted(|| equation.illuminate(&site, None))
    };
    let formula = &scene.reflection.formula;
    let mut names = formula.split(|letter: char| !letter.is_alphanumeric());
    let nothing = if names.any(|name| name == "d") {
        "distance = d\n0"
    } else {
        "0"
    };
    // N·L of a law that compares is 0 where rounding decides its sign: an absolute value and a comparison, one operation.
    let compared = if formula.contains('>') {
        scene.lights.len() as i64
    } else {
        0
    };
    (count(formula) - count(nothing) - compared) as u64
}

#[test]
fn the_plan_lists_the_operations_that_a_number_counts() {
    let mut scene = presets::find("three-lights").expect("a scene").scene();
    scene.reflection.model = ReflectionModel::Formula;
    scene.image.size = [64, 64];
    let lights = scene.lights.len() as u64;
    for mode in [ShadingMode::Phong, ShadingMode::Gouraud, ShadingMode::Flat] {
        scene.shading.mode = mode;
        for formula in [PHONG, BLINN, "max(N·L, 0)", "d * phi + theta", "ks^2 * N·V"] {
            scene.reflection.formula = formula.to_owned();
            let mut renderer = Renderer::default();
            renderer.render(&scene);
            let report = renderer.report();
            let points = match mode {
                ShadingMode::Phong => report.covered,
                _ => report.points,
            };
            let [_, _, planned] = planned(&scene);
            let done = done_at_a_point(&scene);
            assert!(done > 0, "{formula}");
            assert_eq!(planned, points * done, "{mode:?} {formula}");
        }
    }
    // Cosines of one point are not computed again for each light.
    scene.shading.mode = ShadingMode::Phong;
    let at_a_point = |scene: &mut Scene, formula: &str| {
        scene.reflection.formula = formula.to_owned();
        done_at_a_point(scene)
    };
    assert_eq!(at_a_point(&mut scene, "N·V"), 3);
    assert_eq!(at_a_point(&mut scene, "N·L"), 3 * lights);
    assert_eq!(at_a_point(&mut scene, "N·L + N·V"), 3 + 4 * lights);
}

#[test]
fn what_is_the_same_everywhere_is_computed_once_for_a_light() {
    let mut scene = presets::find("infinite").expect("a scene").scene();
    scene.reflection.model = ReflectionModel::Formula;
    scene.reflection.formula = BLINN.to_owned();
    scene.camera.eye = DVec3::new(1.0, 1.5, 4.0);
    let lights = scene.lights.len() as u64;
    assert!(lights > 0 && scene.lights.iter().all(|light| !light.kind.has_position()));
    // L + V, its length and three quotients.
    let [_, once, pixel] = planned(&scene);
    assert_eq!(once, (3 + 3 + 1 + 3) * lights);
    let mut near = scene.clone();
    near.camera.viewer = shading_lab::scene::Viewer::Local;
    let [_, none, more] = planned(&near);
    assert!(none == 0 && more > pixel, "{none} {more} {pixel}");
    // The picture is that of the model that is built in.
    let mut built_in = scene.clone();
    built_in.reflection.model = ReflectionModel::Blinn;
    let mut renderer = Renderer::default();
    let (a, b) = (
        renderer.render(&built_in).clone(),
        renderer.render(&scene).clone(),
    );
    assert_eq!(difference(&a, &b).0, 0);
}

#[test]
fn parts_without_effect_are_left_out_and_say_why() {
    let mut scene = presets::find("sphere").expect("a scene").scene();
    scene.reflection.model = ReflectionModel::Formula;
    scene.reflection.formula = PHONG.to_owned();
    scene.material.ks = Rgb::ZERO;
    scene.image.size = [32, 32];
    let terms = terms(&scene);
    let find = |name: &str| {
        let found = terms.iter().find(|(own, _)| own == name);
        let (_, term) = found.unwrap_or_else(|| panic!("{name} in {terms:#?}"));
        term
    };
    for (name, why) in [
        ("ks * os * spot^n", "render-why-changes-nothing"),
        ("spot^n", "render-why-unused"),
        ("max(R·V, 0)", "render-why-unused"),
    ] {
        assert_eq!(find(name).omitted.map(|why| why.0), Some(why), "{name}");
        assert_eq!(
            (find(name).per, find(name).evaluations),
            (Per::None, 0),
            "{name}"
        );
    }
    assert!(find("max(N·L, 0)").omitted.is_none() && find("max(N·L, 0)").evaluations > 0);
}

#[test]
fn parts_of_a_law_are_shown_with_all_their_parentheses() {
    let (_, _, mut own) = typed().next().expect("a scene");
    own.reflection.formula =
        "a = (N·L + 1) * (N·V)\n(a - 0.2) * ks * (N·L > 0) # a (comment".to_owned();
    let terms = terms(&own);
    for part in [
        "(N·L + 1) * (N·V)",
        "(a - 0.2) * ks",
        "(a - 0.2) * ks * (N·L > 0)",
        "N·L > 0",
    ] {
        assert!(
            terms.iter().any(|(name, _)| name == part),
            "{part} in {terms:#?}"
        );
    }
    let hit = probe(&mut Renderer::default(), &own, 48, 48)
        .hit
        .expect("the object");
    let law = hit.lights[0].law.as_ref().expect("the lines of the law");
    let lines: Vec<&str> = law.lines.iter().map(|line| line.formula.as_str()).collect();
    assert_eq!(lines, ["(N·L + 1) * (N·V)", "(a - 0.2) * ks * (N·L > 0)"]);
}

#[test]
fn a_light_is_kept_whatever_the_coefficients_are_and_shines_on_backs() {
    let mut scene = presets::find("sphere").expect("a scene").scene();
    scene.reflection.model = ReflectionModel::Formula;
    (scene.material.kd, scene.material.ks) = Default::default();
    scene.image.size = [64, 64];
    let mut renderer = Renderer::default();
    let mut lit = |scene: &Scene, formula: &str| {
        let mut scene = scene.clone();
        scene.reflection.formula = formula.to_owned();
        let ambient = renderer
            .render(&Scene {
                lights: vec![],
                ..scene.clone()
            })
            .clone();
        let frame = renderer.render(&scene);
        let differ = |(a, b): &(&[u8; 4], &[u8; 4])| a != b;
        frame
            .pixels
            .iter()
            .zip(&ambient.pixels)
            .filter(differ)
            .count()
    };
    assert!(lit(&scene, "max(N·L, 0)") > 100);
    let back = "max(-(N·L), 0)";
    assert!(lit(&scene, back) > 20);
    // The solid stands between its own back and the light; on polygons, N is turned away a little before the polygon is.
    scene.shading.shadows = true;
    scene.shading.mode = ShadingMode::Exact;
    assert_eq!(lit(&scene, back), 0);
    assert!(lit(&scene, "max(N·L, 0)") > 100);
}

#[test]
fn shadows_of_a_convex_solid_are_left_out_where_the_law_ends_behind_the_surface() {
    let mut scene = presets::find("sphere").expect("a scene").scene();
    scene.reflection.model = ReflectionModel::Formula;
    scene.shading.shadows = true;
    scene.image.size = [48, 48];
    let mut renderer = Renderer::default();
    let mut drawn = |formula: &str| {
        scene.reflection.formula = formula.to_owned();
        let pixels = renderer.render(&scene).pixels.clone();
        let stages = &renderer.report().stages;
        (pixels, stages.iter().any(|run| run.stage == Stage::Rays))
    };
    for text in [
        PHONG,
        BLINN,
        "max(N·L, 0)",
        "c = clamp(dot(L, N), 0, 1)\nc^2 + sqrt(c) * V.x",
        "max(kd * N·L, 0) * acos(N·L)",
        "(0 < N·L) * od",
        "0",
    ] {
        let (pixels, traced) = drawn(text);
        assert!(!traced, "{text}");
        // The same law, of which it is not known where it ends; what is turned away a little may still be lit.
        let (others, traced) = drawn(&format!("{text} + 1e-9 * N·L"));
        assert!(traced, "{text}");
        let apart = |(a, b): (&[u8; 4], &[u8; 4])| (0..3).any(|k| a[k].abs_diff(b[k]) > 1);
        let apart = pixels.iter().zip(&others).filter(|&pair| apart(pair));
        assert_eq!(apart.count(), 0, "{text}");
    }
    for text in [
        "N·L",
        "abs(N·L)",
        "(N·L)^2",
        "max(-N·L, 0)",
        "max(N·L, -0.1)",
        "max(N·L + 0.1, 0)",
        "max(N·L, 0) + 0.1",
        "max(N·V, 0)",
        "(N·L >= 0)",
        "(N·L > -0.1)",
        "max(theta, 0)",
        "max(N·L, 0)^0",
        "1 - max(N·L, 0)",
        // They are 0 behind the surface, where they are undefined.
        "max(N·L, 0) / max(N·L, 0)",
        "max(N·L, 0) * log(N·L)",
    ] {
        assert!(drawn(text).1, "{text}");
    }
}

#[test]
fn colours_of_a_pattern_are_od_in_the_law() {
    let mut scene = presets::find("checker").expect("a scene").scene();
    scene.image.size = [64, 64];
    let mut own = scene.clone();
    own.reflection.model = ReflectionModel::Formula;
    own.reflection.formula = "max(N·L, 0) * (0.25 + od*od)".to_owned();
    // The same law with Kd in place of Od, for a surface without a pattern of one colour, then of the other.
    let mut renderer = Renderer::default();
    let patterned = renderer.render(&own).clone();
    let plain: Vec<_> = [scene.material.color, scene.pattern.color]
        .map(|color| {
            let mut plain = own.clone();
            plain.pattern.kind = shading_lab::scene::PatternKind::None;
            plain.material.color = color;
            renderer.render(&plain).clone()
        })
        .into();
    let same = |index: usize, frame: &Frame| {
        let pair = frame.pixels[index].iter().zip(&patterned.pixels[index]);
        pair.map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0) <= 1
    };
    let count = patterned.pixels.len();
    let one = (0..count)
        .filter(|index| plain.iter().any(|frame| same(*index, frame)))
        .count();
    assert_eq!(one, count);
    for frame in &plain {
        assert!((0..count).filter(|index| same(*index, frame)).count() < count);
    }
}

/// A law that is undefined where N·L is below ½, with values between 0.4 and 0.8 for a light of Ip = 1, and one that is ½
/// there and 0 elsewhere.
const UNDEFINED: [&str; 2] = ["0.4 + 0.5 * sqrt(N·L - 0.5)", "0.5 * (0.5 > N·L)"];

#[test]
fn pixels_where_a_law_is_undefined_are_counted_and_hatched() {
    let mut renderer = Renderer::default();
    let as_it_is: fn(&mut Scene) = |_| ();
    let from_afar: fn(&mut Scene) = |scene| {
        scene.camera.projection = Projection::Orthographic;
        scene.camera.eye *= 1e5;
    };
    for (name, mode, change) in [
        ("sphere", ShadingMode::Phong, as_it_is),
        ("sphere", ShadingMode::Exact, as_it_is),
        ("infinite", ShadingMode::Phong, as_it_is),
        ("torus", ShadingMode::Phong, as_it_is),
        ("torus", ShadingMode::Flat, as_it_is),
        ("torus", ShadingMode::Flat, from_afar),
        ("torus", ShadingMode::Gouraud, as_it_is),
        ("torus", ShadingMode::Gouraud, from_afar),
        ("torus", ShadingMode::Gouraud, |scene| {
            scene.shading.interpolation = Interpolation::Scanline;
        }),
        ("torus", ShadingMode::Interpolated, as_it_is),
        ("torus", ShadingMode::Flat, |scene| {
            scene.shading.flat_at = FlatAt::ProvokingVertex;
        }),
        ("balls", ShadingMode::Flat, as_it_is),
        ("cube", ShadingMode::Gouraud, as_it_is),
        ("balls", ShadingMode::Phong, as_it_is),
        ("vertex-normals", ShadingMode::Exact, as_it_is),
    ] {
        let mut scene = presets::find(name).expect("a scene").scene();
        scene.image.size = [97, 80];
        (scene.shading.mode, scene.shading.shadows) = (mode, true);
        change(&mut scene);
        scene.ground.visible = false;
        // No pixel of the object is as black as the hatching.
        (scene.material.ka, scene.material.color) = (Rgb::ONE, Rgb::ONE);
        (scene.ambient.color, scene.image.background) = (Rgb::splat(0.01), Rgb::ZERO);
        scene.display.encoding = Encoding::Raw;
        scene.lights.truncate(1);
        scene.lights[0].color = Rgb::ONE;
        scene.reflection.model = ReflectionModel::Formula;
        let mut draw = |law: &str, overflow: Overflow| {
            let mut scene = scene.clone();
            scene.reflection.formula = law.to_owned();
            scene.display.overflow = overflow;
            scene.validate().expect("a scene");
            let frame = renderer.render(&scene).clone();
            (frame, renderer.report().overflowing)
        };
        let (clamped, counted) = draw(UNDEFINED[0], Overflow::Clamp);
        let (marked, same) = draw(UNDEFINED[0], Overflow::Mark);
        let (there, none) = draw(UNDEFINED[1], Overflow::Clamp);
        let (_, never) = draw("0.4 + 0.5 * sqrt(max(N·L - 0.5, 0))", Overflow::Clamp);
        assert_eq!((none, never, same), (0, 0, counted), "{name} {mode:?}");
        let pixels = clamped.pixels.iter().zip(&marked.pixels);
        let hatched: Vec<bool> = pixels.map(|(a, b)| a != b).collect();
        let all = hatched.iter().filter(|hatched| **hatched).count() as u64;
        assert_eq!(all, counted, "{name} {mode:?}");
        // The other law is drawn by another way; beside the line N·L = ½, both may round. Models have ambient light of their own.
        // Where vertices carry intensities, a part of the other law's value shows where it is not 0 at a corner.
        let at_corners = matches!(mode, ShadingMode::Gouraud | ShadingMode::Interpolated);
        let least = if at_corners { 3 } else { 100 };
        let expected = there.pixels.iter().map(|[r, ..]| *r > least);
        let apart = hatched.iter().zip(expected).filter(|(a, b)| **a != *b);
        let apart = apart.count();
        assert!(
            all > 30 && apart <= if at_corners { 20 } else { 3 },
            "{name} {mode:?}: {all}, {apart}"
        );
    }
}

#[test]
fn a_law_that_is_undefined_everywhere_marks_the_whole_object() {
    let mut renderer = Renderer::default();
    for name in ["depth-cueing", "glass-ball", "one-bounce", "cone"] {
        let mut scene = presets::find(name).expect("a scene").scene();
        scene.image.size = [97, 80];
        scene.shading.shadows = false;
        scene.reflection.model = ReflectionModel::Formula;
        let modes = [ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong];
        let overflows = [Overflow::Mark, Overflow::Clamp];
        for (mode, overflow) in modes
            .into_iter()
            .flat_map(|mode| overflows.map(|own| (mode, own)))
        {
            (scene.shading.mode, scene.display.overflow) = (mode, overflow);
            let mut marked = |law: &str| {
                scene.reflection.formula = law.to_owned();
                renderer.render(&scene);
                let report = renderer.report();
                (report.overflowing, report.covered)
            };
            let (before, covered) = marked("0.1 * (N·L > 0)");
            let (all, same) = marked("0.1 * (N·L > 0) + sqrt(N·L - 2)");
            assert!(covered > 500 && same == covered, "{name}: {covered}");
            assert_eq!((before, all), (0, covered), "{name} {mode:?} {overflow:?}");
        }
    }
}
