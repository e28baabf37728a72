//! Eyes, vertices and polygons where they hardly can be.

use super::super::{Case, Condition, Topic};
use super::{lamp, polygons, scene, sphere};
use crate::scene::{NormalSource, Scene};
use glam::DVec3;

pub const CASES: &[Case] = &[
    Case {
        name: "eye-on-the-surface",
        title: "The viewer on the surface",
        topic: Topic::Geometry,
        wrong: "The floor is a line in the picture, an area of 0 that weights are divided by; its corners behind the eye are \
                projected before it.",
        robust: "What is nearer than the near plane is clipped before anything is divided by a depth, and what has no area in \
                 the picture covers no pixel.",
        condition: None,
        subject: scene(|| room(0.0, 6.0)),
    },
    Case {
        name: "behind-the-eye",
        title: "A polygon that reaches behind the eye",
        topic: Topic::Geometry,
        wrong: "Divides by w below 0: corners behind the eye appear upside down in front of it.",
        robust: "Clipped at the near plane, in double precision.",
        condition: None,
        subject: scene(|| room(-0.7, 6.0)),
    },
    Case {
        name: "w-0",
        title: "Vertices at w = 0, in the plane of the eye",
        topic: Topic::Geometry,
        wrong: "Divides by 0: the corners are at infinity, the weights no numbers.",
        robust: "Clipped likewise.",
        condition: None,
        subject: scene(|| room(-0.7, 2.0)),
    },
    Case {
        name: "slivers",
        title: "Slivers: triangles 10⁻⁸ wide",
        topic: Topic::Geometry,
        wrong: "In single precision they have hardly an area: their normals point anywhere, and spread through the averages at \
                vertices to polygons that are sound.",
        robust: "What has no area beyond the rounding of its corners has no normal and no weight in any average. Polygons \
                 without any area in a scene are refused.",
        condition: Some(Condition { value: 1e8, of: "of the normal in the corners: length over width" }),
        subject: scene(|| {
            // In the planes of the polygons beside them.
            let (width, slope) = (1e-8, 0.25);
            let tip = |x: f64| [x * (0.875 + width), 0.0, -width * slope];
            let corners = [
                [-0.875, -0.75, 0.0],
                [0.0, -0.75, 0.875 * slope],
                [0.875, -0.75, 0.0],
                [0.875, 0.75, 0.0],
                [0.0, 0.75, 0.875 * slope],
                [-0.875, 0.75, 0.0],
                tip(-1.0),
                tip(1.0),
            ];
            polygons(&corners, &[&[0, 1, 4, 5], &[1, 2, 3, 4], &[0, 5, 6], &[3, 2, 7]])
        }),
    },
    Case {
        name: "scale-1e-15",
        title: "Coordinates of 10⁻¹⁵",
        topic: Topic::Geometry,
        wrong: "The square of a cross product of edges underflows: normals are no numbers.",
        robust: "Normals are found in double precision, and lengths measured in distances from the eye to its target.",
        condition: None,
        subject: scene(|| scaled(1e-15)),
    },
    Case {
        name: "scale-1e15",
        title: "Coordinates of 10¹⁵",
        topic: Topic::Geometry,
        wrong: "The same square overflows: normals are zero.",
        robust: "The same measure.",
        condition: None,
        subject: scene(|| scaled(1e15)),
    },
    Case {
        name: "far-from-the-origin",
        title: "A mesh 10⁷ from the origin",
        topic: Topic::Geometry,
        wrong: "Places are rounded to whole units, and the matrix adds what should cancel.",
        robust: "Differences from the eye and from the mesh's own middle are taken in double precision; only they are rounded.",
        condition: Some(Condition { value: 1e7, of: "of a difference of coordinates in them" }),
        subject: scene(|| {
            let mut scene = pyramid();
            let offset = DVec3::new(1.1e7, -0.7e7, 1.3e7);
            moved(&mut scene, |v| v + offset);
            scene
        }),
    },
    Case {
        name: "telephoto",
        title: "A sphere seen from 10⁵ radii away",
        topic: Topic::Geometry,
        wrong: "The discriminant b² − 4ac is the difference of two numbers near 10²⁰, of which single precision has seven digits.",
        robust: "The surface is met in double precision, and where the eye is 10⁴ radii away pixels are evaluated in it too.",
        condition: Some(Condition { value: 1e10, of: "of the discriminant: (distance/radius)²" }),
        subject: scene(|| {
            let mut scene = sphere();
            scene.camera.eye = DVec3::new(0.3, 0.4, 1.0) * 1e5;
            scene.camera.fov_y = 1.3e-3;
            scene
        }),
    },
    Case {
        name: "depth-fighting",
        title: "Two surfaces 10⁻⁵ of their distance apart",
        topic: Topic::Geometry,
        wrong: "Keeps z/w in single precision, most of whose range is spent next to the near plane: which surface is in front \
                changes from pixel to pixel.",
        robust: "Keeps 1/depth in camera distances, whose digits are spread over the object's depths.",
        condition: Some(Condition { value: 1e5, of: "of the difference of depths in them" }),
        subject: scene(|| {
            let gap = 4e-5;
            let at = |x: f64, y: f64, z: f64| [x, y, 0.3 * x + z];
            let one = |z: f64| [at(-1.0, -1.0, z), at(1.0, -1.0, z), at(1.0, 1.0, z), at(-1.0, 1.0, z)];
            let mut scene = polygons(&[one(0.0), one(gap)].concat(), &[&[0, 1, 2, 3], &[4, 5, 6, 7]]);
            let (behind, before) = (DVec3::new(0.9, 0.0, 0.2), DVec3::new(-0.3, 0.0, 1.0));
            scene.object.vertex_normals = (0..8).map(|v| if v < 4 { behind } else { before }).collect();
            scene.object.normals = NormalSource::File;
            scene.lights = vec![lamp(-2.0, 2.0, 3.0)];
            scene
        }),
    },
];

/// A wall at z = −3 before an eye at (0, 0, 2), and a floor `floor` units above the eye, from z = −3 to `to`.
fn room(floor: f64, to: f64) -> Scene {
    let wall = [[-1.5, -0.7, -3.0], [1.5, -0.7, -3.0], [1.5, 1.2, -3.0], [-1.5, 1.2, -3.0]];
    let floor = [[-1.5, floor, to], [1.5, floor, to], [1.5, floor, -3.0], [-1.5, floor, -3.0]];
    let mut scene = polygons(&[wall, floor].concat(), &[&[0, 1, 2, 3], &[4, 5, 6, 7]]);
    (scene.camera.eye, scene.camera.target) = (DVec3::new(0.0, 0.0, 2.0), DVec3::new(0.0, 0.0, -1.0));
    scene.lights = vec![lamp(0.8, 1.0, 0.5)];
    scene
}

/// A pyramid over a square, its point towards the eye.
fn pyramid() -> Scene {
    let corners = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.1, 0.2, 0.9]];
    let mut scene = polygons(&corners, &[&[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]]);
    scene.object.normals = NormalSource::Facet;
    scene
}

fn moved(scene: &mut Scene, to: impl Fn(DVec3) -> DVec3) {
    scene.object.vertices = scene.object.vertices.iter().map(|v| to(*v)).collect();
    (scene.camera.eye, scene.camera.target) = (to(scene.camera.eye), to(scene.camera.target));
    scene.lights.iter_mut().for_each(|light| light.position = to(light.position));
}

fn scaled(factor: f64) -> Scene {
    let mut scene = pyramid();
    moved(&mut scene, |v| v * factor);
    scene
}
