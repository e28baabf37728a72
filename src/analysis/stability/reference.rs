//! The reference: a ray through each pixel's centre and the equation's own formulas, in double-double arithmetic.
//!
//! It shares no code with the engine except the operations of a typed law. Cosines and powers are computed as the textbook
//! writes them, for which 106 bits suffice: the power's error at n = 10¹² is below 10⁻¹⁸. Where a formula has no value, the
//! limit is used: a vector of length zero has no direction and is lit by nothing, and light that grazes the surface counts
//! as none.

use super::precise::{Precise, Precise3, precise};
use crate::illumination::{Incidence, LawOperations, LawSite, V3};
use crate::scene::{
    Attenuation, Light, LightKind, NormalSource, ObjectKind, Projection, ReflectionModel, Rgb,
    Scene, ShadingMode, Viewer,
};
use glam::DVec2;
use rayon::prelude::*;

/// Minimum visible distance from the eye, in camera distances, as in the engine.
const NEAR: f64 = 1e-3;

/// Half the side of the square about a pixel's centre that must see one polygon: vertices are rounded to 1/256 of a
/// pixel.
const CLEAR: f64 = 1.0 / 64.0;

/// The vector of length zero.
const NOTHING: Precise3 = Precise3([precise(0.0); 3]);

/// Remainder of 0 in 106 bits after all operations on a point: the height of a light over a tangent plane in camera
/// distances, or N·L of parallel rays.
const ROUNDING: f64 = 1e-20;

/// A pixel of the reference.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Truth {
    /// Linear intensity before the display.
    pub color: [f64; 3],
    /// True if the pixel sees the same polygon all about its centre, so that its value does not belong to an outline.
    pub clear: bool,
}

/// Draws `scene`, whose object is polygons or, in exact mode, the sphere: row by row from the top.
pub fn draw(scene: &Scene) -> Vec<Truth> {
    let [width, height] = scene.image.size;
    let reference = ReferenceScene::new(scene);
    let pixels: Vec<(u32, u32)> = (0..height)
        .flat_map(|y| (0..width).map(move |x| (x, y)))
        .collect();
    pixels
        .into_par_iter()
        .map(|(x, y)| reference.pixel(DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5)))
        .collect()
}

/// A scene with its triangles and camera in the reference's precision.
struct ReferenceScene<'a> {
    scene: &'a Scene,
    triangles: Vec<Triangle>,
    eye: Precise3,
    right: Precise3,
    up: Precise3,
    forward: Precise3,
    /// Camera distance, |target − eye|.
    distance: Precise,
    /// Pixels per unit of the picture's plane.
    scale: Precise,
    /// The law of the scene's own, if it has one.
    law: Option<LawOperations>,
}

struct Triangle {
    face: usize,
    corners: [Precise3; 3],
    normals: [Precise3; 3],
}

struct Hit {
    face: usize,
    /// Distance in units of the ray's direction.
    t: Precise,
    normal: Precise3,
}

impl<'a> ReferenceScene<'a> {
    fn new(scene: &'a Scene) -> Self {
        let camera = &scene.camera;
        let eye = Precise3::new(camera.eye);
        let ahead = Precise3::new(camera.target) - eye;
        let forward = ahead.unit();
        let right = forward.cross(Precise3::new(camera.up)).unit();
        let span = precise(camera.span(scene.image.size.map(f64::from)));
        let scale = match camera.projection {
            Projection::Perspective => {
                let (sine, cosine) = precise(camera.fov_y / 2.0).to_radians().sin_cos();
                span / (sine / cosine * 2.0)
            }
            Projection::Orthographic => span / precise(camera.height),
        };
        Self {
            scene,
            triangles: if scene.object.kind == ObjectKind::Polygons {
                triangles(scene)
            } else {
                vec![]
            },
            eye,
            right,
            up: right.cross(forward),
            forward,
            distance: ahead.length(),
            scale,
            law: LawOperations::of_model(scene),
        }
    }

    fn pixel(&self, place: DVec2) -> Truth {
        let hit = self.meet(place);
        let face = hit.as_ref().map(|(_, hit)| hit.face);
        let corners = [
            (-CLEAR, -CLEAR),
            (CLEAR, -CLEAR),
            (-CLEAR, CLEAR),
            (CLEAR, CLEAR),
        ];
        let clear = corners.into_iter().all(|(dx, dy)| {
            self.meet(place + DVec2::new(dx, dy))
                .map(|(_, hit)| hit.face)
                == face
        });
        let color = match hit {
            Some((position, hit)) => self.illuminate(position, hit.normal),
            None => self.scene.image.background.to_array(),
        };
        Truth { color, clear }
    }

    fn meet(&self, place: DVec2) -> Option<(Precise3, Hit)> {
        let [width, height] = self.scene.image.size.map(f64::from);
        let across = self.right * (precise(place.x - width / 2.0) / self.scale)
            - self.up * (precise(place.y - height / 2.0) / self.scale);
        let (origin, direction) = match self.scene.camera.projection {
            Projection::Perspective => (self.eye, self.forward + across),
            Projection::Orthographic => (self.eye + across, self.forward),
        };
        let nearest = self.distance * NEAR;
        let hit = if self.scene.object.kind == ObjectKind::Sphere {
            sphere(origin, direction, nearest)
        } else {
            let hits = self
                .triangles
                .iter()
                .filter_map(|triangle| triangle.meet(origin, direction, nearest));
            hits.reduce(|a, b| if b.t < a.t { b } else { a })
        }?;
        Some((origin + direction * hit.t, hit))
    }

    /// Computes `I = ka·Od·Ia + Σ f·Ip·(kd·Od·(N·L) + ks·S)`, per channel.
    fn illuminate(&self, point: Precise3, normal: Precise3) -> [f64; 3] {
        let scene = self.scene;
        let material = &scene.material;
        let view = match scene.camera.viewer {
            Viewer::Local => (self.eye - point).unit(),
            Viewer::Infinite => -self.forward,
        };
        let mut sum = (material.ka * material.color * scene.ambient.color)
            .to_array()
            .map(precise);
        for light in &scene.lights {
            let to_light = Precise3::new(light.position) - point;
            let travel = Precise3::new(light.direction).unit();
            let parallel = light.kind == LightKind::Directional;
            let l = if parallel { -travel } else { to_light.unit() };
            let d = to_light.length();
            let strength = || attenuation(light, d) * spot(light, -l.dot(travel));
            if let Some(law) = &self.law {
                let factors = typed(law, normal, view, (l, d));
                let ip = light.color.to_array();
                for ((channel, ip), factor) in sum.iter_mut().zip(ip).zip(factors) {
                    *channel = *channel + strength() * ip * factor;
                }
                continue;
            }
            let n_dot_l = normal.dot(l);
            let height = if parallel {
                n_dot_l
            } else {
                normal.dot(to_light) / self.distance
            };
            if height <= precise(ROUNDING) {
                continue;
            }
            let strength = strength();
            let specular = self.specular(normal, l, view, n_dot_l);
            let colors = [
                light.color,
                material.kd * material.color,
                material.ks * material.specular_color,
            ];
            let [ip, kd, ks] = colors.map(|color: Rgb| color.to_array());
            for (k, channel) in sum.iter_mut().enumerate() {
                *channel = *channel + strength * ip[k] * (n_dot_l * kd[k] + specular * ks[k]);
            }
        }
        sum.map(f64::from)
    }

    fn specular(&self, n: Precise3, l: Precise3, v: Precise3, n_dot_l: Precise) -> Precise {
        let material = &self.scene.material;
        let h = (l + v).unit();
        match self.scene.reflection.model {
            ReflectionModel::Phong => power((n * (n_dot_l * 2.0) - l).dot(v), material.n),
            ReflectionModel::Blinn => power(n.dot(h), material.n),
            ReflectionModel::CookTorrance => {
                let (n_dot_h, n_dot_v, v_dot_h) = (n.dot(h), n.dot(v), v.dot(h));
                if n_dot_h <= precise(0.0) || n_dot_v <= precise(0.0) {
                    return precise(0.0);
                }
                let (m, cosine) = (precise(material.roughness), n_dot_h * n_dot_h);
                let tangent = (precise(1.0) - cosine) / cosine;
                let spread = (-tangent / (m * m)).exp() / (m * m * cosine * cosine);
                let of = |cosine: Precise| n_dot_h * 2.0 * cosine / v_dot_h;
                let masking = precise(1.0).min(of(n_dot_v)).min(of(n_dot_l));
                spread * masking / (n_dot_v * 4.0)
            }
            // Its own law stands for both terms.
            ReflectionModel::Formula => precise(0.0),
        }
    }
}

/// Returns the factors of the scene's own law, as typed.
fn typed(
    law: &LawOperations,
    n: Precise3,
    v: Precise3,
    (l, distance): (Precise3, Precise),
) -> [Precise; 3] {
    let vector = |Precise3([x, y, z]): Precise3| V3::new(x, y, z);
    law.factors_at(&LawSite {
        normal: vector(n),
        view: vector(v),
        color: None,
        incidence: Incidence {
            l: vector(l),
            distance,
            grazing: Precise::default(),
        },
    })
}

/// Computes `max(c, 0)^n` with 0⁰ = 1; at n = ∞ only the axis itself remains.
fn power(c: Precise, n: f64) -> Precise {
    let zero = precise(0.0);
    if n == 0.0 {
        precise(1.0)
    } else if c <= zero {
        zero
    } else if n.is_infinite() {
        if (c - precise(1.0)).abs() < precise(ROUNDING) {
            precise(1.0)
        } else {
            zero
        }
    } else {
        let exponent = c.ln() * n;
        if exponent < precise(-700.0) {
            zero
        } else {
            exponent.exp()
        }
    }
}

/// Returns f at `d` world units from a light.
fn attenuation(light: &Light, d: Precise) -> Precise {
    let one = precise(1.0);
    match light.attenuation {
        // The distance to the viewer occurs in no case.
        Attenuation::None | Attenuation::Viewer => one,
        Attenuation::Light => one / (d + precise(light.k)),
        Attenuation::InverseSquare => one / (d * d),
        Attenuation::Quadratic => {
            one.min(one / (d * d * light.c3 + d * light.c2 + precise(light.c1)))
        }
    }
}

/// Returns a spot light's factor where −L·D is `cosine`: its power e within a hard edge (Warn 1983).
fn spot(light: &Light, cosine: Precise) -> Precise {
    let inside = || cosine >= precise(light.cone).to_radians().sin_cos().1;
    match light.kind {
        LightKind::Spot if inside() => power(cosine, light.exponent),
        LightKind::Spot => precise(0.0),
        _ => precise(1.0),
    }
}

impl Triangle {
    /// Returns the point of the triangle on a ray, beyond `nearest`; none where the ray lies in its plane.
    fn meet(&self, origin: Precise3, direction: Precise3, nearest: Precise) -> Option<Hit> {
        let [a, b, c] = self.corners;
        let (e1, e2, from) = (b - a, c - a, origin - a);
        let (p, q) = (direction.cross(e2), from.cross(e1));
        let determinant = e1.dot(p);
        let zero = precise(0.0);
        if determinant == zero {
            return None;
        }
        let (u, v, t) = (
            from.dot(p) / determinant,
            direction.dot(q) / determinant,
            e2.dot(q) / determinant,
        );
        let w = precise(1.0) - u - v;
        let inside = u >= zero && v >= zero && w >= zero && t > nearest;
        let [na, nb, nc] = self.normals;
        let normal = na * w + nb * u + nc * v;
        let normal = if normal.length() > precise(ROUNDING) {
            normal.unit()
        } else {
            NOTHING
        };
        inside.then_some(Hit {
            face: self.face,
            t,
            normal,
        })
    }
}

/// Returns the nearest point of the unit sphere about the origin on a ray.
fn sphere(origin: Precise3, direction: Precise3, nearest: Precise) -> Option<Hit> {
    let (a, b) = (direction.dot(direction), origin.dot(direction));
    let discriminant = b * b - a * (origin.dot(origin) - precise(1.0));
    if discriminant < precise(0.0) {
        return None;
    }
    let root = discriminant.sqrt();
    let t = [(-b - root) / a, (-b + root) / a]
        .into_iter()
        .find(|t| *t > nearest)?;
    Some(Hit {
        face: 0,
        t,
        normal: (origin + direction * t).unit(),
    })
}

/// Returns the scene's polygons as triangles with the normals at their corners.
fn triangles(scene: &Scene) -> Vec<Triangle> {
    let polygons = scene.object.polygons();
    let at = |v: u32| Precise3::new(polygons.vertices[v as usize]);
    let own: Vec<Precise3> = polygons
        .faces
        .iter()
        .map(|face| {
            // Newell's normal, about the first corner.
            let from = |k: usize| at(face[k % face.len()]) - at(face[0]);
            let edges = (0..face.len()).map(|k| from(k).cross(from(k + 1)));
            edges.reduce(|a, b| a + b).map_or(NOTHING, Precise3::unit)
        })
        .collect();
    let averaged = |v: u32| {
        let meeting = polygons
            .faces
            .iter()
            .zip(&own)
            .filter(|(face, _)| face.contains(&v));
        meeting
            .map(|(_, normal)| *normal)
            .reduce(|a, b| a + b)
            .map_or(NOTHING, Precise3::unit)
    };
    let flat =
        scene.shading.mode == ShadingMode::Flat || scene.object.normals == NormalSource::Facet;
    let normal = |face: usize, v: u32| {
        if flat {
            own[face]
        } else if scene.object.normals == NormalSource::File && !polygons.normals.is_empty() {
            Precise3::new(polygons.normals[v as usize]).unit()
        } else {
            averaged(v)
        }
    };
    let mut triangles = Vec::new();
    for (index, face) in polygons.faces.iter().enumerate() {
        for k in 1..face.len().saturating_sub(1) {
            let corners = [face[0], face[k], face[k + 1]];
            let normals = corners.map(|v| normal(index, v));
            triangles.push(Triangle {
                face: index,
                corners: corners.map(at),
                normals,
            });
        }
    }
    triangles
}
