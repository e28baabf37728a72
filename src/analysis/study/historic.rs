//! Two methods of accelerating Phong shading, as they were published, beside Phong shading in the same kind of code.
//!
//! - [`Taylor`]: Taylor's expansions of the cosines over a triangle (Bishop and Weimer 1986).
//! - [`Angular`]: normals that turn by equal angles (Kuijk and Blake 1989).
//!
//! All is scalar code in double precision and in one thread, unlike the engine's kernels. Times are to be compared
//! among the three of them, or as counts of operations ([`Method::pixel_cost`]), not with the engine's.

mod angular;
mod kernel;
mod phong;
mod taylor;

use super::Method;
use crate::geometry::{Mesh, VertexMesh};
use crate::render::{FaceMaterials, for_each_material, transmits};
use crate::scene::{
    AmbientSource, CuedBy, MaterialSource, PatternKind, Reflectance, ReflectionModel, Scene,
};
use crate::text::Message;
use angular::Angular;
use glam::DVec2;
use kernel::{Kernel, ScreenVertex, Shade, Span, carried_in_perspective, crossings, linear};
use phong::Phong;
use taylor::Taylor;

/// Subdivisions of a pixel to which positions are rounded, as in the engine.
const SUBPIXELS: f64 = 256.0;

/// Distance from the eye, in camera distances, within which points are omitted, with their triangles.
const NEAR: f64 = 1e-3;

/// Returns the reason why the scalar code cannot draw a scene, which shows `model` if it is one, by `method`, if so.
pub fn cannot_draw(method: Method, scene: &Scene, model: Option<&Mesh>) -> Option<Message> {
    let rays = scene.shading.shadows
        || scene.ground.visible
        || scene.backdrop.pattern != PatternKind::None
        || transmits(scene, model)
        || scene.ambient.source != AmbientSource::Constant;
    let angular = method == Method::Angular && carried_in_perspective(scene);
    // A model's own materials have W = 1, unless the scene changes that.
    let by_angle = scene.material.reflectance != Reflectance::Constant
        || scene.object.materials.iter().any(|own| {
            own.reflectance
                .is_some_and(|law| law != Reflectance::Constant)
        });
    let powers = [ReflectionModel::Phong, ReflectionModel::Blinn];
    let two_cosines = powers.contains(&scene.reflection.model) && !by_angle;
    let tinted = scene.material.source == MaterialSource::Model
        && model.is_some_and(|mesh| !mesh.corner_colors.is_empty());
    match method {
        _ if tinted => Some(Message("engine-cannot-vertex-colours")),
        _ if rays => Some(Message("engine-cannot-rays")),
        _ if scene.depth_cueing.by != CuedBy::Off => Some(Message("engine-cannot-depth-cueing")),
        _ if angular => Some(Message("engine-cannot-perspective")),
        Method::Taylor if !two_cosines => Some(Message("engine-cannot-cosine")),
        Method::Taylor if scene.pattern.kind != PatternKind::None => {
            Some(Message("engine-cannot-pattern"))
        }
        _ => None,
    }
}

/// A picture drawn by one of the methods.
#[derive(Debug, Default)]
pub struct Historic {
    /// The linear picture, as in [`crate::render::Renderer::linear`].
    pub linear: Vec<[f32; 4]>,
    /// The stored picture, so that the time is that of a whole frame.
    stored: Vec<[u8; 3]>,
    keys: Vec<f64>,
    width: usize,
    /// Number of evaluations of the equation or, for Taylor's, of expansions.
    pub evaluations: u64,
}

impl Historic {
    /// Draws `mesh` in `scene` by the scalar method `method`.
    pub fn draw(&mut self, method: Method, scene: &Scene, mesh: &VertexMesh) {
        let [width, height] = scene.image.size.map(|side| side as usize);
        let background = scene.image.background.as_vec3().extend(0.0).to_array();
        self.width = width;
        self.linear.clear();
        self.linear.resize(width * height, background);
        self.keys.clear();
        self.keys.resize(width * height, f64::NEG_INFINITY);
        let face_materials = if scene.material.source == MaterialSource::Model {
            FaceMaterials::of(mesh)
        } else {
            FaceMaterials::default()
        };
        let materials = face_materials.materials(scene);
        let shades = for_each_material(scene, &materials, Shade::new);
        let faces = (mesh, &face_materials);
        self.evaluations = match method {
            Method::Taylor => self.run(shades.iter().map(Taylor::new), faces),
            Method::Angular => self.run(shades.iter().map(Angular::new), faces),
            _ => self.run(shades.iter().map(Phong::new), faces),
        };
        self.stored.clear();
        let code = |value: f32| (255.0 * value.clamp(0.0, 1.0) + 0.5) as u8;
        self.stored.extend(
            self.linear
                .iter()
                .map(|[r, g, b, _]| [code(*r), code(*g), code(*b)]),
        );
    }

    /// Projects and draws every triangle, each by the kernel of its material; returns the number of evaluations.
    fn run<'a, K: Kernel<'a>>(
        &mut self,
        kernels: impl Iterator<Item = K>,
        (mesh, face_materials): (&VertexMesh, &FaceMaterials),
    ) -> u64 {
        let mut kernels: Vec<K> = kernels.collect();
        let shade = kernels[0].shade();
        let near = NEAR * shade.unit;
        let corner = |(position, normal): (&glam::Vec3, &glam::Vec3)| {
            let (at, depth) = shade.view.project(mesh.origin + position.as_dvec3())?;
            let at = (at * SUBPIXELS).round() / SUBPIXELS;
            let key = if shade.perspective {
                1.0 / depth
            } else {
                -depth
            };
            (depth >= near).then(|| ScreenVertex {
                at,
                key,
                normal: normal.as_dvec3(),
            })
        };
        let corners: Vec<Option<ScreenVertex>> = mesh
            .positions
            .iter()
            .zip(&mesh.normals)
            .map(corner)
            .collect();
        // An eye inside a closed solid sees its back faces.
        let culls = mesh.closed && (shade.view.eye - mesh.origin).length() > mesh.radius();
        let mut evaluations = 0;
        for face in 0..mesh.face_count() {
            let kernel = &mut kernels[face_materials.of_face(face as u32)];
            for triangle in mesh.face_triangles(face) {
                let [a, b, c] = triangle.map(|vertex| corners[vertex as usize]);
                if let (Some(a), Some(b), Some(c)) = (a, b, c) {
                    evaluations += self.triangle(kernel, [a, b, c], culls);
                }
            }
        }
        evaluations
    }

    fn triangle<'a, K: Kernel<'a>>(
        &mut self,
        kernel: &mut K,
        corners: [ScreenVertex; 3],
        culls: bool,
    ) -> u64 {
        let [a, b, c] = corners.map(|corner| corner.at);
        // Counter-clockwise from outside is clockwise in a picture whose y points downwards.
        let area = (b - a).perp_dot(c - a);
        if area == 0.0 || (culls && area > 0.0) {
            return 0;
        }
        let (width, height) = (self.width, self.linear.len() / self.width);
        let first_from =
            |place: f64, side: usize| (place - 0.5).ceil().clamp(0.0, side as f64) as usize;
        let rows =
            first_from(a.y.min(b.y).min(c.y), height)..first_from(a.y.max(b.y).max(c.y), height);
        let keys = linear(&corners, |corner| corner.key);
        let (mut begun, mut pixels) = (false, 0);
        for row in rows {
            let y = row as f64 + 0.5;
            let Some(ends) = crossings([a, b, c], y) else {
                continue;
            };
            let columns = first_from(ends[0].x, width)..first_from(ends[1].x, width);
            if columns.is_empty() {
                continue;
            }
            if !begun {
                begun = true;
                kernel.begin_triangle(&corners);
            }
            let first = DVec2::new(columns.start as f64 + 0.5, y);
            kernel.begin_span(&Span { first, ends });
            let mut key = keys.at(first);
            for column in columns {
                let index = row * width + column;
                if key > self.keys[index] {
                    self.keys[index] = key;
                    let [r, g, b] = kernel
                        .pixel(DVec2::new(column as f64 + 0.5, y), key)
                        .as_vec3()
                        .to_array();
                    self.linear[index] = [r, g, b, 1.0];
                    pixels += 1;
                }
                key += keys.x;
                kernel.step();
            }
        }
        if K::PER_PIXEL { pixels } else { begun.into() }
    }
}
