//! The picture's values again, one pixel at a time in double precision.
//!
//! The modes differ only in where the equation is evaluated; so a pixel's value is a weighted sum of the equation at a few
//! sites, and [`Evaluation`] lists them: one at the face's centre, three at vertices, one at the pixel.

use super::clip::Clipped;
use super::cue::Cue;
use super::exact::meet;
use super::interpolate::SHORTEST_NORMAL;
use super::lens::{Lens, NEAR};
use super::model::Model;
use super::plan::{Cued, Per, Plan};
use super::points::CHUNK;
use super::shadow::Reach;
use crate::geometry::Surface;
use crate::illumination::{Equation, Reached};
use crate::scene::{FlatAt, Rgb, Scene, ShadingMode};
use glam::{DVec2, DVec3};

/// Where the equation is evaluated for a pixel, and with what weight each site enters.
#[derive(Clone, Debug)]
pub(crate) struct Evaluation<'a> {
    /// The point that the pixel sees, world.
    pub position: DVec3,
    /// N at the pixel, as the mode has it.
    pub normal: DVec3,
    /// Distance along the viewing direction, world units.
    pub depth: f64,
    pub face: Option<u32>,
    /// Idc, where intensities fade with the depth.
    pub cue: Option<Rgb>,
    pub sites: Vec<WeightedSite<'a>>,
}

/// A place where the equation is evaluated.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WeightedSite<'a> {
    pub weight: f64,
    /// World.
    pub point: DVec3,
    pub normal: DVec3,
    /// s0, what is left of its intensity; 1 where nothing fades.
    pub scale: f64,
    /// The lights that reach it; all of them where there are no shadows.
    pub reached: Option<Reached<'a>>,
}

impl<'a> Evaluation<'a> {
    /// I at the pixel, before the display.
    pub fn intensity(&self, equation: &Equation<f64>) -> Rgb {
        let at = |site: &WeightedSite<'a>| equation.illuminate_world(site.point, site.normal, site.reached);
        self.sites.iter().map(|site| at(site) * site.weight).sum()
    }

    /// What is left of I at the pixel: each site's share fades by its own s0.
    pub fn kept(&self, equation: &Equation<f64>) -> Rgb {
        let at = |site: &WeightedSite<'a>| equation.illuminate_world(site.point, site.normal, site.reached);
        self.sites.iter().map(|site| at(site) * (site.weight * site.scale)).sum()
    }

    /// s0 at the pixel.
    pub fn scale(&self) -> f64 {
        self.sites.iter().map(|site| site.weight * site.scale).sum()
    }

    /// What takes the place of the intensity that is gone: `(1 − s0)·Idc`.
    pub fn veil(&self) -> Rgb {
        self.cue.map_or(Rgb::ZERO, |color| color * (1.0 - self.scale()))
    }

    /// I at the pixel after depth cueing, before the display.
    pub fn shown(&self, equation: &Equation<f64>) -> Rgb {
        self.kept(equation) + self.veil()
    }
}

/// What the evaluation of a pixel reads.
#[derive(Clone, Copy)]
pub(super) struct Reference<'a> {
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    pub lens: &'a Lens,
    pub model: &'a Model,
    pub clipped: &'a Clipped,
    pub surface: Option<&'a Surface>,
    /// Which sources reach which sites, where there are shadows: pixels, faces or vertices, as the plan has it.
    pub reach: Option<&'a Reach>,
    pub cue: Option<Cue>,
}

impl<'a> Reference<'a> {
    /// The pixel whose sample lies at `place` meets the true surface.
    pub fn of_surface(&self, place: DVec2) -> Option<Evaluation<'a>> {
        let (position, hit) = meet(self.lens, self.surface?, place)?;
        let depth = (position - self.lens.eye).dot(self.lens.forward);
        let (normal, reached) = (hit.normal, self.at_pixel(place));
        let site = WeightedSite { weight: 1.0, point: position, normal, scale: self.scale(position), reached };
        Some(Evaluation { position, normal, depth, face: None, cue: self.cue_color(), sites: vec![site] })
    }

    /// The pixel whose sample lies at `place` sees `triangle`, one of the model's or of the clipper's.
    pub fn of_triangle(&self, triangle: u32, place: DVec2) -> Evaluation<'a> {
        let own = self.model.triangles.len();
        let triangle = self.clipped.parents.get((triangle as usize).wrapping_sub(own)).copied().unwrap_or(triangle);
        let vertices = self.model.triangles[triangle as usize];
        let face = self.model.faces[triangle as usize];
        let in_space = self.weights_in_space(vertices, place);
        let position = mix(&in_space, |v| self.model.position(v));
        let carried = self.weights(face, &in_space, place);
        let normal = self.pixel_normal(face, &carried);
        let depth = (position - self.lens.eye).dot(self.lens.forward);
        // s0 of the whole pixel, where it is not that of each point where the equation is evaluated.
        let whole = match self.plan.cued {
            Cued::Nowhere | Cued::AtPoints => None,
            Cued::AtPixels => Some(self.scale(position)),
            Cued::AtVertices => {
                Some(carried.iter().map(|&(v, weight)| weight * self.scale(self.model.position(v))).sum())
            }
        };
        let at_vertex = |v: u32, weight: f64| self.vertex_site(v, weight);
        let mut sites = match self.scene.shading.mode {
            ShadingMode::Phong | ShadingMode::Exact => {
                let (scale, reached) = (self.scale(position), self.at_pixel(place));
                vec![WeightedSite { weight: 1.0, point: position, normal, scale, reached }]
            }
            ShadingMode::Interpolated | ShadingMode::Gouraud => {
                carried.iter().map(|&(v, weight)| at_vertex(v, weight)).collect()
            }
            ShadingMode::Flat => self.flat_sites(face),
        };
        if let Some(scale) = whole {
            sites.iter_mut().for_each(|site| site.scale = scale);
        }
        Evaluation { position, normal, depth, face: Some(face), cue: self.cue_color(), sites }
    }

    /// s0 at a point, world.
    fn scale(&self, point: DVec3) -> f64 {
        self.cue.map_or(1.0, |cue| cue.at(point))
    }

    fn cue_color(&self) -> Option<Rgb> {
        self.cue.map(|cue| cue.law.color)
    }

    /// The corners of a face, each with the weight 1.
    pub fn corner_sites(&self, face: u32) -> Vec<WeightedSite<'a>> {
        self.model.face(face).iter().map(|&v| self.vertex_site(v, 1.0)).collect()
    }

    /// Where flat shading evaluates the equation for a face.
    pub fn flat_sites(&self, face: u32) -> Vec<WeightedSite<'a>> {
        let corners = self.model.face(face);
        #[expect(clippy::cast_precision_loss, reason = "a face has few corners")]
        let share = 1.0 / corners.len().max(1) as f64;
        match self.scene.shading.flat_at {
            FlatAt::Centre => {
                let (point, normal) = (self.model.face_centre(face), self.model.face_normal(face));
                vec![WeightedSite {
                    weight: 1.0,
                    point,
                    normal,
                    scale: self.scale(point),
                    reached: self.at_point(face),
                }]
            }
            FlatAt::VertexMean => corners.iter().map(|&v| self.vertex_site(v, share)).collect(),
            FlatAt::ProvokingVertex => corners.iter().take(1).map(|&v| self.vertex_site(v, 1.0)).collect(),
        }
    }

    fn vertex_site(&self, v: u32, weight: f64) -> WeightedSite<'a> {
        let (point, normal) = (self.model.position(v), self.model.normal(v));
        WeightedSite { weight, point, normal, scale: self.scale(point), reached: self.at_point(v) }
    }

    /// The sources that reach a pixel.
    fn at_pixel(&self, place: DVec2) -> Option<Reached<'a>> {
        let reach = self.reach.filter(|_| self.plan.per == Per::Pixel)?;
        reach.at(place.y as usize, place.x as usize)
    }

    /// The sources that reach a vertex, or a face where the equation is evaluated at faces.
    fn at_point(&self, index: u32) -> Option<Reached<'a>> {
        let reach = self.reach.filter(|_| self.plan.per != Per::Pixel)?;
        reach.at(index as usize / CHUNK, index as usize % CHUNK)
    }

    fn pixel_normal(&self, face: u32, carried: &[(u32, f64)]) -> DVec3 {
        if matches!(self.scene.shading.mode, ShadingMode::Flat | ShadingMode::Interpolated) {
            return self.model.face_normal(face);
        }
        let normal = mix(carried, |v| self.model.normal(v));
        if self.plan.renormalise { normal / normal.length().max(SHORTEST_NORMAL) } else { normal }
    }

    /// The weights by which values are carried to the pixel.
    fn weights(&self, face: u32, in_space: &[(u32, f64)], place: DVec2) -> Vec<(u32, f64)> {
        let lens = self.lens;
        let before_the_eye = |v: u32| lens.view_from_world(self.model.position(v)).z >= NEAR;
        let at = |v: u32| lens.picture_from_view(lens.view_from_world(self.model.position(v)));
        if self.plan.scanline && self.model.face(face).iter().all(|&v| before_the_eye(v)) {
            scanline_weights(self.model.face(face), at, place)
        } else if lens.perspective && !self.plan.perspective && in_space.iter().all(|&(v, _)| before_the_eye(v)) {
            let [a, b, c] = [0, 1, 2].map(|i: usize| at(in_space[i].0));
            let area = (b - a).perp_dot(c - a);
            let (w1, w2) = ((place - a).perp_dot(c - a) / area, (b - a).perp_dot(place - a) / area);
            vec![(in_space[0].0, 1.0 - w1 - w2), (in_space[1].0, w1), (in_space[2].0, w2)]
        } else {
            in_space.to_vec()
        }
    }

    /// Barycentric weights of the point of the triangle's plane that the pixel sees.
    fn weights_in_space(&self, vertices: [u32; 3], place: DVec2) -> Vec<(u32, f64)> {
        let [w1, w2] = self.lens.weights_in_space(vertices.map(|v| self.model.position(v)), place);
        vec![(vertices[0], 1.0 - w1 - w2), (vertices[1], w1), (vertices[2], w2)]
    }
}

fn mix(weights: &[(u32, f64)], value: impl Fn(u32) -> DVec3) -> DVec3 {
    weights.iter().map(|&(v, weight)| value(v) * weight).sum()
}

/// Weights over a polygon's vertices by the course's bilinear formula: α along two edges to P and Q, then along the span.
fn scanline_weights(polygon: &[u32], at: impl Fn(u32) -> DVec2, place: DVec2) -> Vec<(u32, f64)> {
    let mut crossings: Vec<(f64, u32, u32, f64)> = Vec::new();
    for (i, &from) in polygon.iter().enumerate() {
        let to = polygon[(i + 1) % polygon.len()];
        let (a, b) = (at(from), at(to));
        if (a.y <= place.y) != (b.y <= place.y) {
            let alpha = (place.y - a.y) / (b.y - a.y);
            crossings.push((a.x + alpha * (b.x - a.x), from, to, alpha));
        }
    }
    crossings.sort_by(|p, q| p.0.total_cmp(&q.0));
    let outside = |pair: &[(f64, u32, u32, f64)]| (pair[0].0 - place.x).max(place.x - pair[1].0);
    let pair = crossings.chunks_exact(2).min_by(|p, q| outside(p).total_cmp(&outside(q)));
    let Some(&[p, q]) = pair.and_then(|pair| pair.first_chunk()) else { return vec![(polygon[0], 1.0)] };
    let t = if q.0 > p.0 { ((place.x - p.0) / (q.0 - p.0)).clamp(0.0, 1.0) } else { 0.0 };
    let of =
        |(_, from, to, alpha): (f64, u32, u32, f64), share: f64| [(from, (1.0 - alpha) * share), (to, alpha * share)];
    [of(p, 1.0 - t), of(q, t)].concat()
}
