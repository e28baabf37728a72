//! Cosines and what is made of them: the power, the microfacets, N·L at 0, vectors that have no direction.

use super::super::{Case, Condition, Topic};
use super::{lamp, polygons, scene, sphere, square};
use crate::scene::{Light, LightKind, NormalSource, ReflectionModel, Rgb, Scene, Viewer};
use glam::DVec3;

pub const CASES: &[Case] = &[
    Case {
        name: "exponent-0",
        title: "n = 0",
        topic: Topic::Highlight,
        wrong: "Takes the power only where R·V is above 0, so that 0⁰ becomes 0: the highlight, which n = 0 spreads over all \
                that is lit, ends at a line.",
        robust: "max(R·V, 0)⁰ is 1 by definition: the value at a cosine of 0 is a constant of its own.",
        condition: None,
        subject: scene(|| {
            let mut scene = square();
            scene.material.n = 0.0;
            scene.lights = vec![lamp(0.3, 0.1, 0.1)];
            scene
        }),
    },
    Case {
        name: "exponent-1e4",
        title: "n = 10⁴ on the lobe's axis",
        topic: Topic::Highlight,
        wrong: "Takes the power of R·V, which near 1 has only the digits that single precision has there: steps of 6·10⁻⁸, \
                times n.",
        robust: "From the chord, 1 − R·V = |R − V|²/2, whose digits are all there: exp(n·ln(1 − t)).",
        condition: Some(Condition { value: 1e4, of: "of the power in R·V" }),
        subject: scene(|| lobe(1e4)),
    },
    Case {
        name: "exponent-1e6",
        title: "n = 10⁶ on the lobe's axis",
        topic: Topic::Highlight,
        wrong: "R·V takes a handful of values over the whole highlight: it comes in rings with hard edges.",
        robust: "The chord's form.",
        condition: Some(Condition { value: 1e6, of: "of the power in R·V" }),
        subject: scene(|| lobe(1e6)),
    },
    Case {
        name: "exponent-1e9",
        title: "n = 10⁹ on the lobe's axis",
        topic: Topic::Highlight,
        wrong: "All or nothing: R·V is 1, or so far below that the power vanishes.",
        robust: "Past n = 10⁷ the rounding of unit vectors alone would be seen: pixels are evaluated in double precision.",
        condition: Some(Condition { value: 1e9, of: "of the power in R·V" }),
        subject: scene(|| lobe(1e9)),
    },
    Case {
        name: "exponent-1e12",
        title: "n = 10¹² on the lobe's axis",
        topic: Topic::Highlight,
        wrong: "All or nothing; and the rays of neighbouring pixels hardly differ in single precision.",
        robust: "Double precision, and the chord's form there too.",
        condition: Some(Condition { value: 1e12, of: "of the power in R·V" }),
        subject: scene(|| lobe(1e12)),
    },
    Case {
        name: "exponent-infinite",
        title: "n = ∞, the viewer exactly in the mirrored ray",
        topic: Topic::Highlight,
        wrong: "0.99999994^∞ is 0 and 1.0000001^∞ is infinite: a mirror shows nothing, or too much.",
        robust: "A chord that is nothing but rounding counts as none.",
        condition: None,
        subject: scene(|| {
            let mut scene = square();
            (scene.camera.eye, scene.camera.viewer) = (DVec3::new(-1.1, 0.9, 2.3), Viewer::Infinite);
            let direction = DVec3::new(-1.1, 0.9, -2.3);
            scene.lights = vec![Light { kind: LightKind::Directional, direction, ..Light::default() }];
            scene.material.n = f64::INFINITY;
            scene
        }),
    },
    Case {
        name: "microfacets",
        title: "Microfacets with a slope of m = 0.001",
        topic: Topic::Highlight,
        wrong: "The angle between N and H by acos of a cosine: steps near 0, and no number where the cosine is rounded above 1.",
        robust: "1 − N·H from the chord, and tan² from that.",
        condition: Some(Condition { value: 1e6, of: "of Beckmann's D in N·H: 1/m²" }),
        subject: scene(|| {
            let mut scene = lobe(1e6);
            scene.reflection.model = ReflectionModel::CookTorrance;
            scene.material.roughness = 1e-3;
            // The peak is as 1/m².
            scene.lights[0].color = Rgb::splat(5e-6);
            scene
        }),
    },
    Case {
        name: "light-in-the-plane",
        title: "N·L = 0: the light in the surface's plane",
        topic: Topic::Cosines,
        wrong: "N·L is rounding, above 0 here and below 0 there, or the highlight is added without asking for N·L at all.",
        robust: "A light no higher over the tangent plane than the rounding of its place lights nothing.",
        condition: None,
        subject: scene(|| {
            // In the plane x + y + z = 0, all coordinates exact.
            let at = |s: f64, t: f64| [s + 0.5 * t, 0.5 * t - s, -t];
            let corners = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
            let mut scene = polygons(&corners, &[&[0, 1, 2, 3]]);
            let light = DVec3::from_array(at(0.25, 3.0));
            (scene.camera.eye, scene.camera.up) = (DVec3::from_array(at(0.0, -3.0)) + 0.75, DVec3::ONE);
            (scene.material.n, scene.material.ks) = (6.0, Rgb::splat(0.8));
            scene.lights = vec![Light { position: light, ..Light::default() }];
            scene
        }),
    },
    Case {
        name: "light-inside",
        title: "N·L < 0: a light inside the solid",
        topic: Topic::Cosines,
        wrong: "Adds the highlight wherever R·V is above 0: it shines through the solid.",
        robust: "Only what faces the light is lit, diffusely or specularly.",
        condition: None,
        subject: scene(|| {
            let mut scene = sphere();
            (scene.material.n, scene.material.ks) = (5.0, Rgb::splat(0.6));
            scene.lights = vec![lamp(0.88, 0.3, 0.12)];
            scene
        }),
    },
    Case {
        name: "opposed-normals",
        title: "Opposed vertex normals: the normal between them is zero",
        topic: Topic::Vectors,
        wrong: "Divides by the length of a vector that is zero: no number, in a whole column.",
        robust: "A normal shorter than its own rounding error is not lengthened to 1: it has no direction and no light.",
        condition: None,
        subject: scene(|| {
            let mut scene = with_normals(|x, _| DVec3::new(x, 0.0, 0.0));
            scene.lights = vec![lamp(2.0, 0.0, 1.0)];
            scene
        }),
    },
    Case {
        name: "huge-normals",
        title: "Normals of length 10²⁵",
        topic: Topic::Vectors,
        wrong: "The square of the length overflows, and what is divided by infinity is zero: no light at all.",
        robust: "Given normals are made unit vectors in double precision, where no accepted length overflows when squared.",
        condition: None,
        subject: scene(|| with_normals(|x, y| DVec3::new(x, y, 1.2) * 1e25)),
    },
    Case {
        name: "denormal-normals",
        title: "Normals of length 10⁻³⁰",
        topic: Topic::Vectors,
        wrong: "The square of the length underflows to 0, and what is divided by that is infinite.",
        robust: "Double precision likewise; shorter ones are refused.",
        condition: None,
        subject: scene(|| with_normals(|x, y| DVec3::new(x, y, 1.2) * 1e-30)),
    },
];

/// A plane seen where the lobe is, which is about half as high as the picture whatever `n`.
fn lobe(n: f64) -> Scene {
    let mut scene = square();
    scene.material.n = n;
    // The light is mirrored at the origin.
    scene.camera.eye = DVec3::new(-1.0, 0.0, 1.0);
    scene.camera.fov_y = (340.0 / n.sqrt()).clamp(1e-3, 30.0);
    scene.lights = vec![lamp(1.0, 0.0, 1.0)];
    scene
}

/// The square with a vertex normal at each corner, given as a function of x and y.
fn with_normals(normal: fn(f64, f64) -> DVec3) -> Scene {
    let mut scene = square();
    scene.object.vertex_normals = scene.object.vertices.iter().map(|v| normal(v.x, v.y)).collect();
    scene.object.normals = NormalSource::File;
    scene
}
