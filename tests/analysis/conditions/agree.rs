//! Agreement of picture, probe, profile, conditions and comparison on random scenes of concave polygons, with patterns, each
//! source of ambient light, each projection, and each place where flat shading evaluates the equation.
//!
//! `PROPTEST_CASES` sets the number of scenes; `SCENE` selects a single one.

use crate::common::textbook::{Dice, field_edge, random_light, random_scene, textbook_at};
use crate::common::tries::tries;
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use shading_lab::analysis::comparison::ComparisonQuestion;
use shading_lab::analysis::conditions::{CONDITIONS, Conditions, conditions};
use shading_lab::analysis::perception::luminance;
use shading_lab::analysis::probe::{ProbeHit, probe};
use shading_lab::analysis::profile::{Profile, ProfileQuestion, profile};
use shading_lab::analysis::{Question, Subject, unwatched};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    AmbientSource, Attenuation, Choice, CuedBy, FlatAt, Interpolation, Light, LightKind,
    NormalSource, Object, ObjectKind, Pane, PatternKind, Rgb, Scene, Shading, ShadingMode, Shared,
    Viewer,
};

/// Error of an intensity due to single precision and the picture's grid, absolute and relative.
const ROUNDING: f64 = 4e-3;
/// Value of N·L below which a point may be on either side of the terminator: in these small pictures the grid moves the weights
/// of a polygon's corners by up to 1/1024, and with them the normal.
const NEAR: f64 = 1e-3;
/// Distance from the edge of a field, in world units, below which a point may be on either side of it: the grid moves the point
/// along its ray.
const FIELD_NEAR: f64 = 1e-3;
/// Maximum distance by which the engine moves the edges of fields, so that a vertex on one is in the same field in every
/// precision.
const FIELD_MOVED: f64 = 1e-5;
/// Distance from a pixel's centre, in pixels, below which the picture's grid may put a polygon's border on either side.
const GRID: f64 = 0.02;
/// Minimum distance of corners from edges that they do not belong to.
const CLEAR: f64 = 0.04;

type Outcome = Result<Vec<&'static str>, String>;

/// Returns the corners of a random simple polygon within a square of side 2: random points with their edges untangled.
fn simple_polygon(dice: &mut Dice) -> Vec<DVec2> {
    loop {
        let count = 4 + (dice.unit() * dice.of(&[4.0, 6.0, 10.0])) as usize;
        let mut corners: Vec<DVec2> = (0..count)
            .map(|_| DVec2::new(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)))
            .collect();
        untangle(&mut corners);
        if is_clear(&corners) {
            return corners;
        }
    }
}

/// Reverses parts of a closed line until no two of its edges cross. It ends because each reversal makes the line shorter.
fn untangle(corners: &mut [DVec2]) {
    let count = corners.len();
    let side = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    let mut again = true;
    while again {
        again = false;
        for i in 0..count {
            for j in i + 2..count {
                let [a, b, c, d] = [i, i + 1, j, (j + 1) % count].map(|k| corners[k]);
                let crosses =
                    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
                if crosses {
                    corners[i + 1..=j].reverse();
                    again = true;
                }
            }
        }
    }
}

/// Returns whether every corner keeps its distance from the edges that it does not belong to.
fn is_clear(corners: &[DVec2]) -> bool {
    let count = corners.len();
    (0..count).all(|edge| {
        let (a, b) = (corners[edge], corners[(edge + 1) % count]);
        (0..count)
            .filter(|&k| k != edge && k != (edge + 1) % count)
            .all(|k| {
                let along =
                    ((corners[k] - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
                corners[k].distance(a.lerp(b, along)) > CLEAR
            })
    })
}

/// Returns one to three polygons, each in a plane of its own and with corners of its own.
fn polygons(dice: &mut Dice) -> Object {
    let (mut vertices, mut faces, mut normals) = (Vec::new(), Vec::new(), Vec::new());
    let given = dice.unit() < 0.4;
    for layer in 0..dice.of(&[1, 1, 2, 3]) {
        let normal = (dice.direction() * 0.5 + DVec3::Z).normalize();
        let (u, v) = normal.any_orthonormal_pair();
        let mut flat = simple_polygon(dice);
        if dice.unit() < 0.5 {
            flat.reverse();
        }
        let first = vertices.len() as u32;
        faces.push(Shared::from(
            (first..first + flat.len() as u32).collect::<Vec<_>>(),
        ));
        for corner in flat {
            vertices.push(u * corner.x + v * corner.y - DVec3::Z * (0.7 * f64::from(layer)));
            normals.push(normal + dice.direction() * 0.3);
        }
    }
    Object {
        kind: ObjectKind::Polygons,
        vertices: vertices.into(),
        faces: faces.into(),
        vertex_normals: if given {
            normals.into()
        } else {
            Shared::default()
        },
        ..Object::default()
    }
}

/// Returns the scene with this seed.
fn scene(seed: u64) -> Scene {
    let mut dice = Dice(seed.wrapping_mul(0xd134_2543_de82_ef95));
    let n = dice.between(1.0, 40.0);
    let mut scene = random_scene(&mut dice, n);
    let dice = &mut dice;
    scene.camera.eye = DVec3 {
        z: dice.between(2.5, 5.0),
        ..dice.direction() * 1.5
    };
    scene.camera.up = DVec3::Y;
    scene.image.size = [14.0, 14.0].map(|least| dice.between(least, 40.0) as u32);
    scene.image.background = dice.of(&[DVec3::ZERO, DVec3::new(0.1, 0.2, 0.3)]);
    scene.object = if dice.unit() < 0.75 {
        polygons(dice)
    } else {
        Object {
            kind: dice.of(&[
                ObjectKind::Plane,
                ObjectKind::Sphere,
                ObjectKind::Cylinder,
                ObjectKind::Cube,
            ]),
            segments: dice.of(&[3, 5, 8]),
            rings: dice.of(&[3, 4]),
            ..Object::default()
        }
    };
    scene.object.normals = dice.of(NormalSource::VALUES);
    // No lobe so narrow that the picture's grid shows in it.
    scene.material.roughness = scene.material.roughness.max(0.4);
    // Rings lie about another axis where a shape faces the viewer.
    scene.pattern.kind = dice.of(&[
        PatternKind::None,
        PatternKind::Checker,
        PatternKind::Stripes,
    ]);
    scene.pattern.scale = dice.between(0.15, 0.8);
    scene.lights = (0..dice.of(&[0, 1, 2, 3]))
        .map(|_| random_light(dice))
        .collect();
    for light in &mut scene.lights {
        (light.position.z, light.samples) = (light.position.z.abs() + 0.5, light.samples.min(5));
    }
    if dice.unit() < 0.3 {
        let directional = |light: &mut Light| {
            light.kind = LightKind::Directional;
            light.attenuation = Attenuation::None;
        };
        scene.lights.iter_mut().for_each(directional);
        scene.camera.viewer = Viewer::Infinite;
        scene.pattern.kind = dice.of(&[PatternKind::None, PatternKind::Stripes]);
    }
    scene.ambient.source = dice.of(&[
        AmbientSource::Constant,
        AmbientSource::Bounce,
        AmbientSource::Split,
        AmbientSource::Split,
    ]);
    scene.ground.visible = dice.unit() < 0.3;
    scene.shading = Shading {
        mode: dice.of(ShadingMode::VALUES),
        flat_at: dice.of(FlatAt::VALUES),
        interpolation: dice.of(Interpolation::VALUES),
        renormalise: dice.unit() < 0.7,
        ..Shading::default()
    };
    if dice.unit() < 0.5 {
        scene.shading.mode = ShadingMode::Flat;
    }
    scene.depth_cueing.by = dice.of(&[CuedBy::Off, CuedBy::Off, CuedBy::Vertex, CuedBy::Pixel]);
    scene
}

/// Returns whether two intensities differ by more than rounding.
fn differ(a: f64, b: f64) -> bool {
    (a - b).abs() > ROUNDING * (1.0 + a.abs().max(b.abs()))
}

/// The picture before the display.
struct Drawn {
    linear: Vec<[f32; 4]>,
    /// For each pixel, true if rounding may move its point across a step of the equation.
    steps: Vec<bool>,
}

/// Compares the picture with the probe, pixel by pixel, and flat shades with the textbook's equation.
fn picture_and_probe(
    renderer: &mut Renderer,
    scene: &Scene,
    met: &mut Vec<&'static str>,
) -> Result<Drawn, String> {
    renderer.keep_linear(true);
    let frame = renderer.render(scene).clone();
    let linear = renderer.linear().to_vec();
    let [width, height] = scene.image.size;
    let mut steps = vec![false; linear.len()];
    for (index, (x, y)) in (0..height)
        .flat_map(|y| (0..width).map(move |x| (x, y)))
        .enumerate()
    {
        let probed = probe(renderer, scene, x, y).hit;
        if probed.is_some() != (linear[index][3] > 0.0) {
            return Err(format!("{x},{y}: the object is seen by one alone"));
        }
        let Some(hit) = probed else {
            continue;
        };
        let grazes = hit.lights.iter().any(|light| light.n_dot_l.abs() < NEAR);
        steps[index] = field_edge(scene, hit.position, FIELD_NEAR) || grazes;
        if frame.pixel(x, y) != Some(hit.stored) {
            return Err(format!("{x},{y}: the probe has another pixel's value"));
        }
        let channels = linear[index]
            .into_iter()
            .zip(hit.sum.to_array())
            .zip(hit.stored);
        for ((shown, said), code) in channels {
            let shown = f64::from(shown);
            let stored = (shown.clamp(0.0, 1.0) * 255.0).round();
            if (stored - f64::from(code)).abs() > 1.0 {
                return Err(format!("{x},{y}: {shown} is stored as {code}"));
            }
            if differ(shown, said) && !steps[index] {
                return Err(format!(
                    "{x},{y}: the picture has {shown}, the probe {said}"
                ));
            }
        }
        if let Some(expected) = flat_shade(scene, &hit) {
            met.push("flat shade");
            let bounced = if hit.bounced { hit.ambient } else { Rgb::ZERO };
            let off = (hit.sum - bounced - expected).abs().max_element();
            if off > 1e-5 * (1.0 + expected.max_element()) {
                return Err(format!(
                    "{x},{y}: the shade is {}, expected {expected}",
                    hit.sum - bounced
                ));
            }
        }
    }
    Ok(Drawn { linear, steps })
}

/// Returns the shade of a flat polygon from its corners alone, without light that bounces; `None` if a corner is at the edge of a
/// field.
fn flat_shade(scene: &Scene, hit: &ProbeHit) -> Option<DVec3> {
    let object = &scene.object;
    let flat = scene.shading.mode == ShadingMode::Flat && scene.depth_cueing.by == CuedBy::Off;
    if !flat || object.kind != ObjectKind::Polygons {
        return None;
    }
    let face = object.faces.get(hit.face? as usize)?;
    let corners: Vec<DVec3> = face.iter().map(|&v| object.vertices[v as usize]).collect();
    let facing = facing(&corners);
    let given = matches!(object.normals, NormalSource::File | NormalSource::Exact)
        && !object.vertex_normals.is_empty();
    let normal = |k: usize| {
        if given {
            object.vertex_normals[face[k] as usize].normalize()
        } else {
            facing
        }
    };
    let mut scene = scene.clone();
    if hit.bounced {
        scene.material.ka = Rgb::ZERO;
    }
    let at_corner = |k: usize| textbook_at(&scene, corners[k], normal(k));
    let centre = corners.iter().sum::<DVec3>() / corners.len() as f64;
    let mut points = corners.iter().chain([&centre]);
    if points.any(|point| field_edge(&scene, *point, FIELD_MOVED)) {
        return None;
    }
    Some(match scene.shading.flat_at {
        FlatAt::Centre => textbook_at(&scene, centre, facing),
        FlatAt::VertexMean => {
            (0..corners.len()).map(at_corner).sum::<DVec3>() / corners.len() as f64
        }
        FlatAt::ProvokingVertex => at_corner(0),
    })
}

/// Returns the unit normal of a plane polygon.
fn facing(corners: &[DVec3]) -> DVec3 {
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    edges.map(|(a, b)| a.cross(*b)).sum::<DVec3>().normalize()
}

/// Compares the profile along a row with the picture, at the centres of the row's pixels.
fn profile_and_picture(
    renderer: &mut Renderer,
    scene: &Scene,
    drawn: &Drawn,
    row: u32,
) -> Result<(), String> {
    let [width, _] = scene.image.size;
    let place = |x: u32| DVec2::new(f64::from(x) + 0.5, f64::from(row) + 0.5);
    let question = ProfileQuestion {
        modes: vec![scene.shading.mode],
        ..ProfileQuestion::new(place(0), place(width - 1))
    };
    let Profile {
        samples,
        traces,
        borders,
        ..
    } = profile(renderer, scene, &question).map_err(|error| error.to_string())?;
    for (sample, found) in samples.iter().zip(&traces[0].intensity) {
        let x = sample.x - 0.5;
        if (x - x.round()).abs() > 1e-9 {
            continue;
        }
        let index = (row * width) as usize + x.round() as usize;
        let [r, g, b, _] = drawn.linear[index].map(f64::from);
        let shown = luminance(Rgb::new(r, g, b));
        let border = borders
            .iter()
            .any(|border| (border.x - sample.x).abs() < GRID);
        if differ(shown, *found) && !border && !drawn.steps[index] {
            return Err(format!(
                "{x},{row}: the picture has {shown}, the profile {found}"
            ));
        }
    }
    Ok(())
}

/// Compares the conditions' figures for flat and exact shading with a comparison of both, and with the verdicts.
fn conditions_and_comparison(
    renderer: &mut Renderer,
    scene: &Scene,
    met: &mut Vec<&'static str>,
) -> Result<(), String> {
    let found = conditions(renderer, scene);
    let mut compared = scene.clone();
    compared.shading.mode = ShadingMode::Exact;
    compared.compare.panes = vec![Pane::of(&["shading.mode=flat"])];
    let figures = ComparisonQuestion
        .answer(&Subject::new(compared), &unwatched)?
        .0
        .iter()
        .find_map(|pane| pane.error);
    if figures != Some(found.everywhere) {
        return Err(format!(
            "compare has {figures:?}, the conditions {:?}",
            found.everywhere
        ));
    }
    let Conditions {
        error, everywhere, ..
    } = &found;
    if error.pixels > everywhere.pixels || error.greatest > everywhere.greatest {
        return Err(format!("more inside than everywhere: {found:?}"));
    }
    let all_hold = CONDITIONS.iter().all(|(_, holds)| holds(&found)) && found.further.is_empty();
    if all_hold {
        met.push("all conditions hold");
        if error.greatest > ROUNDING {
            return Err(format!("all conditions hold, {found:?}"));
        }
    }
    Ok(())
}

fn examine(seed: u64) -> Outcome {
    let scene = scene(seed);
    let named = |what: String| format!("scene {seed}: {what}\n{}", scene.to_toml());
    scene.validate().map_err(|error| named(error.to_string()))?;
    let (mut renderer, mut met) = (Renderer::default(), vec!["a scene"]);
    let drawn = picture_and_probe(&mut renderer, &scene, &mut met).map_err(named)?;
    let row = (seed % u64::from(scene.image.size[1])) as u32;
    profile_and_picture(&mut renderer, &scene, &drawn, row).map_err(named)?;
    conditions_and_comparison(&mut renderer, &scene, &mut met).map_err(named)?;
    Ok(met)
}

#[test]
fn everything_says_the_same_of_a_scene() {
    let cases = tries(60);
    if let Ok(only) = std::env::var("SCENE") {
        let outcome = examine(only.parse().expect("a number"));
        return assert!(outcome.is_ok(), "{}", outcome.unwrap_err());
    }
    let outcomes: Vec<Outcome> = (0..cases).into_par_iter().map(examine).collect();
    let wrong: Vec<&String> = outcomes
        .iter()
        .filter_map(|outcome| outcome.as_ref().err())
        .collect();
    let first_lines = wrong.iter().filter_map(|what| what.lines().next());
    assert!(
        wrong.is_empty(),
        "{} of {cases} scenes are wrong:\n{}\nthe first: {}",
        wrong.len(),
        first_lines.take(20).collect::<Vec<_>>().join("\n"),
        wrong[0]
    );
    for claim in ["flat shade", "all conditions hold"] {
        let count = outcomes
            .iter()
            .flatten()
            .flatten()
            .filter(|met| **met == claim)
            .count();
        assert!(count > 0, "{claim} is not met in {cases} scenes");
    }
}
