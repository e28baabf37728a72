//! Every pixel of a picture of polygons against an independent rasterizer in double precision. Corners are rounded to 1/256 of a
//! pixel in the picture; nothing else distinguishes it from a picture without the grid.

use crate::common::dice::Dice;
use crate::common::tries::tries;
use glam::{DVec2, DVec3};
use shading_lab::geometry::{VertexMesh, tessellate};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Choice, Framing, Interpolation, Light, NormalSource, Object, ObjectKind, Projection, Scene,
    ShadingMode, Viewer,
};
use std::collections::HashMap;

/// Grid steps per pixel.
const STEPS: f64 = 256.0;
/// Distance from the middle between two grid steps below which single precision decides to which of them a position is rounded.
const SINGLE: f64 = 1.0 / (1 << 21) as f64;
/// Error of single precision in code values, in addition to the half that is due to rounding.
const CODES: f64 = 0.55;

/// A corner in the picture.
#[derive(Clone, Copy)]
struct Corner {
    /// Unrounded position in grid steps, y downwards.
    place: DVec2,
    /// 1/depth, or −depth in parallel projection: linear in the picture.
    key: f64,
    /// For each coordinate, true if single precision may round it to the other step.
    unsure: [bool; 2],
}

/// The positions of a reference picture: rounded to the grid or not.
#[derive(Clone, Copy, PartialEq)]
enum Places {
    Rounded,
    AsTheyCome,
}

/// A scene drawn independently of the program.
struct Reference {
    scene: Scene,
    mesh: VertexMesh,
    /// Positions of the mesh's corners in space; `corners` has those in the picture.
    points: Vec<DVec3>,
    corners: Vec<Corner>,
    /// The camera's axes, unit vectors.
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    /// Pixels per unit across, at depth 1 in perspective.
    scale: f64,
    culls: bool,
}

impl Reference {
    fn new(scene: &Scene) -> Self {
        let (camera, size) = (&scene.camera, scene.image.size.map(f64::from));
        let forward = (camera.target - camera.eye).normalize();
        let right = forward.cross(camera.up).normalize();
        let up = right.cross(forward);
        let span = match camera.framing {
            Framing::Height => size[1],
            Framing::Whole => size[0].min(size[1]),
        };
        let perspective = camera.projection == Projection::Perspective;
        let scale = if perspective {
            span / 2.0 / (camera.fov_y.to_radians() / 2.0).tan()
        } else {
            span / camera.height
        };
        let normals = match scene.shading.mode {
            ShadingMode::Interpolated => NormalSource::Facet,
            _ => scene.object.normals,
        };
        let mesh = tessellate(&scene.object).with_vertex_normals(normals, scene.object.weighting);
        let points: Vec<DVec3> = mesh
            .positions
            .iter()
            .map(|p| mesh.origin + p.as_dvec3())
            .collect();
        let corner = |point: &DVec3| {
            let from_eye = *point - camera.eye;
            let depth = from_eye.dot(forward);
            let across = DVec2::new(from_eye.dot(right), -from_eye.dot(up));
            let across = if perspective { across / depth } else { across };
            let place = (DVec2::from_array(size) / 2.0 + across * scale) * STEPS;
            let bound = SINGLE * (place.abs().max_element() + STEPS * (size[0] + size[1]));
            let middle = |v: f64| ((v - v.floor()) - 0.5).abs() < bound;
            Corner {
                place,
                key: if perspective { 1.0 / depth } else { -depth },
                unsure: [middle(place.x), middle(place.y)],
            }
        };
        Self {
            corners: points.iter().map(corner).collect(),
            culls: mesh.closed,
            scene: scene.clone(),
            points,
            mesh,
            right,
            up,
            forward,
            scale,
        }
    }

    /// Returns the code values of a pixel, or `None` where no polygon is visible. `moved` replaces the grid steps of some
    /// coordinates.
    fn pixel(
        &self,
        at: [u32; 2],
        places: Places,
        moved: &HashMap<(u32, usize), f64>,
    ) -> Option<DVec3> {
        let centre = (DVec2::from_array(at.map(f64::from)) + 0.5) * STEPS;
        let place = |v: u32| {
            let corner = self.corners[v as usize].place;
            let of = |axis: usize| match (moved.get(&(v, axis)), places) {
                (Some(step), _) => *step,
                (None, Places::Rounded) => corner[axis].round_ties_even(),
                (None, Places::AsTheyCome) => corner[axis],
            };
            DVec2::new(of(0), of(1))
        };
        let mut nearest: Option<(f64, usize, [u32; 3], [f64; 3])> = None;
        for f in 0..self.mesh.face_count() {
            for triangle in self.mesh.face_triangles(f) {
                let Some(weights) = weights(triangle.map(place), centre, self.culls) else {
                    continue;
                };
                let keys = triangle.map(|v| self.corners[v as usize].key);
                let key = (0..3).map(|i| weights[i] * keys[i]).sum();
                // The program makes no depth test for a convex solid: only the grid can make two of its faces overlap.
                if self.mesh.convex || nearest.is_none_or(|(best, ..)| key > best) {
                    nearest = Some((key, f, triangle, weights));
                }
            }
        }
        let (key, face, triangle, weights) = nearest?;
        Some(self.shade(centre / STEPS, (key, face), triangle, weights))
    }

    fn shade(
        &self,
        pixel: DVec2,
        (key, face): (f64, usize),
        triangle: [u32; 3],
        weights: [f64; 3],
    ) -> DVec3 {
        let (scene, camera) = (&self.scene, &self.scene.camera);
        let perspective = camera.projection == Projection::Perspective;
        let mut shares = weights;
        if perspective && scene.shading.interpolation == Interpolation::Perspective {
            shares = [0, 1, 2].map(|i| weights[i] * self.corners[triangle[i] as usize].key / key);
        }
        let mix =
            |of: &dyn Fn(u32) -> DVec3| (0..3).map(|i| of(triangle[i]) * shares[i]).sum::<DVec3>();
        let normal = |v: u32| self.mesh.normals[v as usize].as_dvec3();
        let intensity = match scene.shading.mode {
            ShadingMode::Flat => {
                self.equation(self.mesh.face_centre(face), self.mesh.face_normal(face))
            }
            ShadingMode::Interpolated | ShadingMode::Gouraud => {
                mix(&|v| self.equation(self.points[v as usize], normal(v)))
            }
            ShadingMode::Phong | ShadingMode::Exact => {
                let size = DVec2::from_array(scene.image.size.map(f64::from));
                let off = (pixel - size / 2.0) / self.scale;
                let across = self.right * off.x - self.up * off.y;
                let point = if perspective {
                    camera.eye + (self.forward + across) / key
                } else {
                    camera.eye + across - self.forward * key
                };
                self.equation(point, mix(&normal).normalize())
            }
        };
        intensity.clamp(DVec3::ZERO, DVec3::ONE) * 255.0
    }

    /// Evaluates `Ka·Od·Ia + Σ Il·(Kd·Od·(N·L) + Ks·Os·(R·V)ⁿ)` for point lights without attenuation. A light counts from one
    /// grid step above the tangent plane, where a highlight begins abruptly; the step is measured at the distance of the camera's
    /// target.
    fn equation(&self, p: DVec3, n: DVec3) -> DVec3 {
        let Scene {
            material: m,
            ambient,
            camera,
            lights,
            ..
        } = &self.scene;
        let v = match camera.viewer {
            Viewer::Local => (camera.eye - p).normalize(),
            Viewer::Infinite => -self.forward,
        };
        let step = match camera.projection {
            Projection::Perspective => camera.eye.distance(camera.target) / self.scale / STEPS,
            Projection::Orthographic => 1.0 / self.scale / STEPS,
        };
        let mut sum = m.ka * m.color * ambient.color;
        for light in lights {
            let l = (light.position - p).normalize();
            let cosine = n.dot(l);
            if n.dot(light.position - p) > step {
                let s = (2.0 * cosine * n - l).dot(v).max(0.0).powf(m.n);
                sum += light.color * (m.kd * m.color * cosine + m.ks * m.specular_color * s);
            }
        }
        sum
    }

    /// Returns the coordinates that single precision may round differently, of triangles near a pixel's centre, each with its two
    /// steps.
    fn unsure_near(&self, at: [u32; 2]) -> Vec<((u32, usize), [f64; 2])> {
        let centre = (DVec2::from_array(at.map(f64::from)) + 0.5) * STEPS;
        let mut found = Vec::new();
        for triangle in (0..self.mesh.face_count()).flat_map(|f| self.mesh.face_triangles(f)) {
            let corners = triangle.map(|v| self.corners[v as usize].place);
            let low = corners[0].min(corners[1]).min(corners[2]) - 1.0;
            let high = corners[0].max(corners[1]).max(corners[2]) + 1.0;
            if centre.cmpge(low).all() && centre.cmple(high).all() {
                for (v, axis) in triangle.into_iter().flat_map(|v| [(v, 0), (v, 1)]) {
                    let Corner { place, unsure, .. } = self.corners[v as usize];
                    if unsure[axis] && !found.iter().any(|(known, _)| *known == (v, axis)) {
                        found.push(((v, axis), [place[axis].floor(), place[axis].ceil()]));
                    }
                }
            }
        }
        found
    }

    /// Returns whether a stored pixel is the reference's for some way in which single precision may round.
    fn agrees(&self, at: [u32; 2], stored: Option<DVec3>) -> bool {
        let same = |moved: &HashMap<_, _>| match (self.pixel(at, Places::Rounded, moved), stored) {
            (Some(expected), Some(stored)) => (expected - stored).abs().max_element() <= CODES,
            (expected, stored) => expected.is_none() && stored.is_none(),
        };
        if same(&HashMap::new()) {
            return true;
        }
        let unsure = self.unsure_near(at);
        (1..1_u32 << unsure.len().min(12)).any(|choice| {
            let moved = unsure.iter().enumerate();
            same(
                &moved
                    .map(|(k, (coordinate, steps))| {
                        (*coordinate, steps[(choice >> k & 1) as usize])
                    })
                    .collect(),
            )
        })
    }
}

/// Returns the weights of a triangle's corners at a position that it covers; its left and top edges are part of it.
fn weights([a, b, c]: [DVec2; 3], at: DVec2, culls: bool) -> Option<[f64; 3]> {
    let area = (b - a).perp_dot(c - a);
    if area == 0.0 || (culls && area > 0.0) {
        return None;
    }
    let weight = |from: DVec2, to: DVec2| {
        let edge = to - from;
        let value = edge.perp_dot(at - from) / area;
        // A position on the edge counts as if moved slightly to the right, and by less downwards.
        let beside = [-edge.y / area, edge.x / area];
        let inside = [value, beside[0], beside[1]]
            .into_iter()
            .find(|v| *v != 0.0);
        inside.is_some_and(|v| v > 0.0).then_some(value)
    };
    Some([weight(b, c)?, weight(c, a)?, weight(a, b)?])
}

/// Returns a scene of polygons over a background that no shade has.
fn scene(dice: &mut Dice, size: [u32; 2]) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = size;
    scene.object = Object {
        kind: dice.of(&[
            ObjectKind::Sphere,
            ObjectKind::Torus,
            ObjectKind::Cube,
            ObjectKind::Cone,
            ObjectKind::Plane,
            ObjectKind::Polygons,
        ]),
        segments: dice.between(4.0, 20.0) as u32,
        rings: dice.between(3.0, 9.0) as u32,
        normals: dice.of(&[NormalSource::Averaged, NormalSource::Facet]),
        ..Object::default()
    };
    let camera = &mut scene.camera;
    camera.eye = dice.direction() * dice.between(2.5, 5.0);
    camera.up = dice.direction();
    camera.projection = dice.of(Projection::VALUES);
    camera.framing = dice.of(Framing::VALUES);
    camera.viewer = dice.of(Viewer::VALUES);
    scene.shading.mode = dice.of(&[
        ShadingMode::Flat,
        ShadingMode::Interpolated,
        ShadingMode::Gouraud,
        ShadingMode::Phong,
    ]);
    scene.shading.interpolation = dice.of(&[Interpolation::Perspective, Interpolation::Affine]);
    (scene.material.n, scene.material.ka) = (dice.between(1.0, 12.0), DVec3::splat(0.3));
    scene.lights = vec![Light {
        position: dice.direction() * 3.0,
        ..Light::default()
    }];
    assert_eq!(scene.validate(), Ok(()));
    scene
}

/// Draws scenes of these sizes; returns how many pixels were compared, and how many of them differ from a picture without the
/// grid.
fn compare(seed: u64, cases: u64, mut size: impl FnMut(&mut Dice) -> [u32; 2]) -> [u32; 2] {
    let mut dice = Dice(seed);
    let mut renderer = Renderer::default();
    renderer.keep_linear(true);
    let (mut compared, mut moved) = (0, 0);
    for case in 0..cases {
        let size = size(&mut dice);
        let scene = scene(&mut dice, size);
        let reference = Reference::new(&scene);
        let frame = renderer.render(&scene).clone();
        for (k, linear) in (0..).zip(renderer.linear()) {
            let at = [k % size[0], k / size[0]];
            let stored = frame.pixel(at[0], at[1]).filter(|_| linear[3] > 0.0);
            let stored = stored.map(|codes| DVec3::from_array(codes.map(f64::from)));
            assert!(
                reference.agrees(at, stored),
                "case {case}, pixel {at:?}: {stored:?}, {scene:?}"
            );
            compared += u32::from(stored.is_some());
            let free = reference.pixel(at, Places::AsTheyCome, &HashMap::new());
            let off = match (free, stored) {
                (Some(free), Some(stored)) => (free - stored).abs().max_element(),
                (free, stored) => f64::from(u8::from(free.is_some() != stored.is_some())) * 255.0,
            };
            moved += u32::from(off > 1.5);
        }
    }
    [compared, moved]
}

#[test]
fn pictures_of_polygons_differ_from_the_textbook_by_the_grid_alone() {
    let [compared, moved] = compare(0x9e1d_0256, tries(12).max(12), |_| [48, 40]);
    assert!(compared > 4000, "{compared} pixels");
    assert!(
        moved * 100 < compared,
        "{moved} of {compared} pixels are moved by the grid"
    );
}

#[test]
fn in_pictures_a_pixel_wide_or_high_the_grid_moves_more_and_nothing_else_does() {
    let narrow = |dice: &mut Dice| {
        let long = dice.between(1.0, 60.0) as u32;
        dice.of(&[[1, long], [long, 1], [1, 1]])
    };
    let [compared, moved] = compare(0x9e1d_0001, tries(120).max(120), narrow);
    assert!(
        compared > 400 && moved > 0,
        "{moved} of {compared} pixels are moved by the grid"
    );
}
