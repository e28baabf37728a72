//! Two methods of accelerating Phong shading, as they were published, beside Phong shading in the same kind of code.
//!
//! - [`Taylor`]: Bishop and Weimer, "Fast Phong Shading", SIGGRAPH 1986. N·L and the highlight's cosine are functions
//!   of the picture's x and y over a triangle; their Taylor expansions of the second order about its centre are
//!   evaluated by forward differences, two additions per pixel each. The error is of the third order in the
//!   triangle's size, and where two triangles meet their expansions do not.
//! - [`Angular`]: Kuijk and Blake, "Faster Phong shading via angular interpolation", Computer Graphics Forum 8
//!   (1989). Normals turn by equal angles along the edges and then along the span: N(i+1) = 2·cos Δ·N(i) − N(i−1), of
//!   unit length without a root. Equal angles are equal steps in the picture, so that this is affine by construction.
//!
//! All is scalar code in double precision and in one thread, unlike the engine's kernels. Times are to be compared
//! among the three of them, or as counts of operations ([`Method::pixel_cost`]), not with the engine's.

use super::Method;
use super::jet::Jet;
use crate::geometry::{Mesh, VertexMesh, angle};
use crate::illumination::{Equation, Real, V3};
use crate::render::{FaceMaterials, for_each_material, transmits};
use crate::scene::{
    AmbientSource, Backfacing, CuedBy, Interpolation, MaterialSource, PatternKind, Projection,
    Reflectance, Reflection, ReflectionModel, Rgb, Scene, View,
};
use crate::text::Message;
use glam::{DVec2, DVec3};
use std::ops::{Add, Mul, Sub};

/// Subdivisions of a pixel to which positions are rounded, as in the engine.
const SUBPIXELS: f64 = 256.0;

/// Distance from the eye, in camera distances, within which points are omitted, with their triangles.
const NEAR: f64 = 1e-3;

/// Sine below which two normals count as one: the arc between them is its chord to 10⁻¹².
const SAME: f64 = 1e-6;

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

#[derive(Clone, Copy, Debug)]
struct ScreenVertex {
    /// Position in the picture, pixels.
    at: DVec2,
    /// Depth key, linear in the picture over a flat polygon: 1/depth, or −depth without perspective; nearer is larger.
    key: f64,
    /// Unit normal.
    normal: DVec3,
}

/// A crossing of a scan line and an edge.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    /// x of the crossing, pixels.
    x: f64,
    /// The edge's ends, by their numbers in the triangle.
    from: usize,
    to: usize,
    /// Parameter along the edge, which is divided there in the ratio α : 1−α.
    alpha: f64,
}

/// The part of a scan line inside a triangle.
#[derive(Clone, Copy, Debug)]
struct Span {
    /// Centre of the first pixel.
    first: DVec2,
    ends: [Crossing; 2],
}

/// Returns the crossings at which the line at `y` enters and leaves a triangle; an edge lacks its lower end.
fn crossings(corners: [DVec2; 3], y: f64) -> Option<[Crossing; 2]> {
    let mut crossed = (0..3).filter_map(|from| {
        let to = (from + 1) % 3;
        let (a, b) = (corners[from], corners[to]);
        let alpha = (y - a.y) / (b.y - a.y);
        ((a.y <= y) != (b.y <= y)).then_some(Crossing {
            x: a.x + alpha * (b.x - a.x),
            from,
            to,
            alpha,
        })
    });
    let (p, q) = (crossed.next()?, crossed.next()?);
    Some(if p.x <= q.x { [p, q] } else { [q, p] })
}

/// A function that is linear in the picture: its value at a corner and its slopes.
#[derive(Clone, Copy, Debug, Default)]
struct Linear<T> {
    origin: DVec2,
    value: T,
    x: T,
    y: T,
}

fn linear<T>(corners: &[ScreenVertex; 3], value: impl Fn(&ScreenVertex) -> T) -> Linear<T>
where
    T: Copy + Sub<Output = T> + Mul<f64, Output = T>,
{
    let [a, b, c] = corners;
    let (u, v) = (b.at - a.at, c.at - a.at);
    let inverse = 1.0 / u.perp_dot(v);
    let origin = value(a);
    let (du, dv) = (value(b) - origin, value(c) - origin);
    Linear {
        origin: a.at,
        value: origin,
        x: du * (v.y * inverse) - dv * (u.y * inverse),
        y: dv * (u.x * inverse) - du * (v.x * inverse),
    }
}

impl<T: Copy + Add<Output = T> + Mul<f64, Output = T>> Linear<T> {
    fn at(&self, place: DVec2) -> T {
        let from = place - self.origin;
        self.value + self.x * from.x + self.y * from.y
    }
}

/// Returns normals as a linear function of the picture; divided by the depth they are linear in space.
fn carried(triangle: &[ScreenVertex; 3], perspective: bool) -> Linear<DVec3> {
    linear(triangle, |corner| {
        corner.normal * if perspective { corner.key } else { 1.0 }
    })
}

/// Returns whether values between vertices are linear in space and not in the picture.
fn carried_in_perspective(scene: &Scene) -> bool {
    scene.camera.projection == Projection::Perspective
        && scene.shading.interpolation == Interpolation::Perspective
}

/// The equation of a scene at the points that pixels see.
struct Shade {
    view: View,
    equation: Equation<f64>,
    perspective: bool,
    /// True if values between vertices are linear in space and not in the picture.
    carried_in_perspective: bool,
    reflection: Reflection,
    n: f64,
    /// World units per unit of the equation.
    unit: f64,
}

impl Shade {
    fn new(scene: &Scene) -> Self {
        Self {
            view: View::new(&scene.camera, scene.image.size),
            equation: Equation::new(scene),
            perspective: scene.camera.projection == Projection::Perspective,
            carried_in_perspective: carried_in_perspective(scene),
            reflection: scene.reflection.clone(),
            n: scene.material.n,
            unit: scene.camera.distance(),
        }
    }

    /// Returns the point seen at an offset from the picture's middle, pixels, with a key: in the equation's frame.
    fn position<R: Real<Scalar = f64>>(&self, [x, y]: [R; 2], key: R) -> V3<R> {
        let View {
            right,
            up,
            forward,
            scale,
            ..
        } = self.view;
        let axis = |axis: DVec3| V3::constant(x, axis.to_array());
        let one = x.constant(1.0);
        let depth = if self.perspective { one / key } else { -key };
        let across = axis(right).scale(x * (1.0 / scale)) - axis(up).scale(y * (1.0 / scale));
        let at = if self.perspective {
            (axis(forward) + across).scale(depth)
        } else {
            across + axis(forward).scale(depth)
        };
        at.scale(one * (1.0 / self.unit))
    }

    /// Returns I with normal `n` at a pixel.
    // Compiled once, so that the times of two methods differ only by their own work.
    #[inline(never)]
    fn illuminate(&self, place: DVec2, key: f64, n: DVec3) -> Rgb {
        let offset = place - self.view.centre;
        let p: DVec3 = self.position([offset.x, offset.y], key).into();
        self.equation
            .illuminate_world(self.view.eye + p * self.unit, n, None)
    }
}

/// A method of finding intensities along spans.
trait Kernel<'a> {
    /// True if the equation is evaluated at each pixel instead of once per triangle.
    const PER_PIXEL: bool = true;

    fn shade(&self) -> &'a Shade;
    fn begin_triangle(&mut self, triangle: &[ScreenVertex; 3]);
    fn begin_span(&mut self, span: &Span);
    /// Returns the intensity at a pixel of the span whose key is `key`.
    fn pixel(&self, place: DVec2, key: f64) -> Rgb;
    /// Advances to the pixel on the right.
    fn step(&mut self);
}

/// Phong shading: normals interpolated linearly and normalised at each pixel (Phong 1975).
struct Phong<'a> {
    shade: &'a Shade,
    perspective: bool,
    carried: Linear<DVec3>,
    normal: DVec3,
}

impl<'a> Phong<'a> {
    fn new(shade: &'a Shade) -> Self {
        Self {
            shade,
            perspective: shade.carried_in_perspective,
            carried: Linear::default(),
            normal: DVec3::ZERO,
        }
    }
}

impl<'a> Kernel<'a> for Phong<'a> {
    fn shade(&self) -> &'a Shade {
        self.shade
    }

    fn begin_triangle(&mut self, triangle: &[ScreenVertex; 3]) {
        self.carried = carried(triangle, self.perspective);
    }

    fn begin_span(&mut self, span: &Span) {
        self.normal = self.carried.at(span.first);
    }

    fn pixel(&self, place: DVec2, key: f64) -> Rgb {
        self.shade
            .illuminate(place, key, self.normal.normalize_or_zero())
    }

    fn step(&mut self) {
        self.normal += self.carried.x;
    }
}

/// Angular interpolation: normals turn by equal angles, along the edges and along the span.
struct Angular<'a> {
    shade: &'a Shade,
    normals: [DVec3; 3],
    /// The normals at this pixel and at the one on the left.
    normal: DVec3,
    before: DVec3,
    /// `2·cos Δ`, where Δ is the angle from pixel to pixel.
    twice_cosine: f64,
}

impl<'a> Angular<'a> {
    fn new(shade: &'a Shade) -> Self {
        Self {
            shade,
            normals: [DVec3::Z; 3],
            normal: DVec3::Z,
            before: DVec3::Z,
            twice_cosine: 2.0,
        }
    }
}

impl<'a> Kernel<'a> for Angular<'a> {
    fn shade(&self) -> &'a Shade {
        self.shade
    }

    fn begin_triangle(&mut self, triangle: &[ScreenVertex; 3]) {
        self.normals = triangle.map(|corner| corner.normal.normalize_or(DVec3::Z));
    }

    fn begin_span(&mut self, span: &Span) {
        let end = |crossing: &Crossing| {
            turned(
                self.normals[crossing.from],
                self.normals[crossing.to],
                crossing.alpha,
            )
        };
        let (left, right) = (end(&span.ends[0]), end(&span.ends[1]));
        let width = span.ends[1].x - span.ends[0].x;
        let t = (span.first.x - span.ends[0].x) / width;
        self.normal = turned(left, right, t);
        self.before = turned(left, right, t - 1.0 / width);
        self.twice_cosine = 2.0 * (angle(left, right) / width).cos();
    }

    fn pixel(&self, place: DVec2, key: f64) -> Rgb {
        self.shade.illuminate(place, key, self.normal)
    }

    fn step(&mut self) {
        let next = self.normal * self.twice_cosine - self.before;
        self.before = std::mem::replace(&mut self.normal, next);
    }
}

/// Returns the unit vector on the great circle from `a` to `b`, at `t` times their angle (Shoemake 1985).
fn turned(a: DVec3, b: DVec3, t: f64) -> DVec3 {
    let angle = angle(a, b);
    let sine = angle.sin();
    if sine < SAME {
        return a.lerp(b, t).normalize_or(a);
    }
    (a * ((1.0 - t) * angle).sin() + b * (t * angle).sin()) / sine
}

/// Taylor's expansion of the cosines over a triangle, by forward differences.
struct Taylor<'a> {
    shade: &'a Shade,
    perspective: bool,
    model: ReflectionModel,
    flips: bool,
    n: f64,
    /// The triangle's centre in the picture, about which the expansions are.
    centre: DVec2,
    /// N·L, the highlight's cosine, and f with a spot light's factor, for each source.
    expansions: Vec<[Jet; 3]>,
    /// Values and first differences at this pixel, and second differences.
    state: Vec<[[f64; 3]; 3]>,
}

impl<'a> Taylor<'a> {
    fn new(shade: &'a Shade) -> Self {
        Self {
            shade,
            perspective: shade.carried_in_perspective,
            model: shade.reflection.model,
            flips: shade.reflection.backfacing == Backfacing::Flip,
            n: shade.n,
            centre: DVec2::ZERO,
            expansions: Vec::new(),
            state: Vec::new(),
        }
    }
}

impl<'a> Kernel<'a> for Taylor<'a> {
    const PER_PIXEL: bool = false;

    fn shade(&self) -> &'a Shade {
        self.shade
    }

    fn begin_triangle(&mut self, triangle: &[ScreenVertex; 3]) {
        self.centre = triangle.iter().map(|corner| corner.at).sum::<DVec2>() / 3.0;
        let (normals, keys) = (
            carried(triangle, self.perspective),
            linear(triangle, |corner| corner.key),
        );
        let middle = normals.at(self.centre);
        let [x, y, z] =
            [0, 1, 2].map(|axis| Jet::linear(middle[axis], normals.x[axis], normals.y[axis]));
        let n = V3::new(x, y, z).normalised();
        let offset = self.centre - self.shade.view.centre;
        let place = [
            Jet::linear(offset.x, 1.0, 0.0),
            Jet::linear(offset.y, 0.0, 1.0),
        ];
        let position = self
            .shade
            .position(place, Jet::linear(keys.at(self.centre), keys.x, keys.y));
        let equation = &self.shade.equation;
        let site = equation.site(position, n);
        self.expansions.clear();
        for source in &equation.sources {
            let (l, f, _) = source.reach(site.position, site.inverse_distance);
            let n_dot_l = n.dot(l);
            let cosine = match self.model {
                ReflectionModel::Blinn => n.dot((l + site.view).normalised()),
                _ => n_dot_l * n.dot(site.view) * 2.0 - l.dot(site.view),
            };
            self.expansions.push([n_dot_l, cosine, f * source.spot(l)]);
        }
    }

    fn begin_span(&mut self, span: &Span) {
        let from = span.first - self.centre;
        self.state.clear();
        self.state.extend(
            self.expansions
                .iter()
                .map(|jets| jets.map(|jet| jet.differences(from))),
        );
    }

    fn pixel(&self, _: DVec2, _: f64) -> Rgb {
        let mut sum = Rgb::from_array(self.shade.equation.ambient);
        for (source, [[n_dot_l, ..], [cosine, ..], [strength, ..]]) in
            self.shade.equation.sources.iter().zip(&self.state)
        {
            let (n_dot_l, cosine) = if self.flips && *n_dot_l < 0.0 {
                (
                    -n_dot_l,
                    if self.model == ReflectionModel::Blinn {
                        -cosine
                    } else {
                        *cosine
                    },
                )
            } else {
                (*n_dot_l, *cosine)
            };
            if n_dot_l > 0.0 {
                // Beyond 1 a cosine is the expansion's error.
                let specular =
                    DVec3::from_array(source.specular) * cosine.clamp(0.0, 1.0).powf(self.n);
                sum += (DVec3::from_array(source.diffuse) * n_dot_l + specular) * *strength;
            }
        }
        sum
    }

    fn step(&mut self) {
        for [value, first, second] in self.state.iter_mut().flatten() {
            *value += *first;
            *first += *second;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Light, LightKind};

    /// Compares a span across a cylinder: its true normals turn in one plane by equal angles.
    #[test]
    fn on_a_great_circle_angular_normals_are_exact() {
        let shade = Shade::new(&Scene::default());
        let normal = |angle: f64| DVec3::new(angle.sin(), 0.0, angle.cos());
        let corner = |x: f64, y: f64, turn: f64| ScreenVertex {
            at: DVec2::new(x, y),
            key: 0.25,
            normal: normal(turn),
        };
        let mut kernel = Angular::new(&shade);
        kernel.begin_triangle(&[
            corner(0.0, 0.0, -0.9),
            corner(40.0, 0.0, 1.1),
            corner(0.0, 40.0, -0.9),
        ]);
        let left = Crossing {
            x: 0.0,
            from: 2,
            to: 0,
            alpha: 1.0,
        };
        let right = Crossing {
            x: 40.0,
            from: 0,
            to: 1,
            alpha: 1.0,
        };
        kernel.begin_span(&Span {
            first: DVec2::new(0.5, 0.0),
            ends: [left, right],
        });
        for pixel in 0..40 {
            let expected = normal(-0.9 + 2.0 * (f64::from(pixel) + 0.5) / 40.0);
            assert!(
                kernel.normal.distance(expected) < 1e-12,
                "pixel {pixel}: {} is not {expected}",
                kernel.normal
            );
            kernel.step();
        }
        assert!(
            turned(DVec3::Y, DVec3::Y, 0.3).distance(DVec3::Y) < 1e-15,
            "equal normals stay as they are"
        );
    }

    /// Compares the kernel's expansion with the closed form. Seen directly without perspective, N = (x, 0, 1)/√(1 +
    /// x²) and a light along the view give N·L = 1/√(1 + x²), whose expansion about c is known; the remainder is
    /// f‴·dx³/6.
    #[test]
    fn taylors_expansion_is_the_closed_form() {
        let mut scene = Scene::default();
        scene.camera.projection = Projection::Orthographic;
        (scene.material.ka, scene.material.ks) = (Rgb::ZERO, Rgb::ZERO);
        (scene.material.kd, scene.material.color) = (Rgb::ONE, Rgb::ONE);
        let view = View::new(&scene.camera, scene.image.size);
        scene.lights = vec![Light {
            kind: LightKind::Directional,
            direction: view.forward,
            ..Light::default()
        }];
        let shade = Shade::new(&scene);
        let mut kernel = Taylor::new(&shade);
        let slope = 0.01;
        let tilt = |x: f64| view.right * (slope * x) - view.forward;
        let corner = |x: f64, y: f64| ScreenVertex {
            at: DVec2::new(x, y),
            key: -4.0,
            normal: tilt(x),
        };
        kernel.begin_triangle(&[corner(0.0, 0.0), corner(30.0, 0.0), corner(0.0, 30.0)]);
        let edge = |x: f64| Crossing {
            x,
            from: 0,
            to: 1,
            alpha: 0.0,
        };
        kernel.begin_span(&Span {
            first: DVec2::new(0.5, 4.0),
            ends: [edge(0.0), edge(26.0)],
        });
        // f = (1+u²)^−½ with u = slope·x, about x = 10.
        let u = slope * 10.0;
        let w = 1.0 + u * u;
        let (f0, f1, f2) = (
            w.powf(-0.5),
            -u * w.powf(-1.5),
            (2.0 * u * u - 1.0) * w.powf(-2.5),
        );
        for pixel in 0..26 {
            let dx = f64::from(pixel) + 0.5 - 10.0;
            let du = slope * dx;
            let expected = f0 + f1 * du + 0.5 * f2 * du * du;
            let got = kernel.pixel(DVec2::ZERO, 0.0).x;
            assert!((got - expected).abs() < 1e-12, "{got} is not {expected}");
            let x = u + du;
            let exact = (1.0 + x * x).powf(-0.5);
            // |f‴| = |u(9 − 6u²)|·w^(−7/2), at most 9·(u + |du|) here.
            let bound = 9.0 * (u + du.abs()) * du.abs().powi(3) / 6.0 + 1e-12;
            assert!(
                (got - exact).abs() <= bound,
                "{got} is not within {bound} of {exact}"
            );
            kernel.step();
        }
    }
}
