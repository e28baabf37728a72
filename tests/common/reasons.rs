//! Verification of the stated reason why a light adds nothing, by independently computed rays and angles.

use glam::DVec3;
use shading_lab::analysis::probe::{LightTerms, ProbeHit, ZeroCause, ZeroCauses};
use shading_lab::geometry::{Mesh, Ray, Surface, VertexMesh, tessellate};
use shading_lab::illumination::{Index, area_samples};
use shading_lab::scene::{
    Backfacing, FlatAt, Light, LightKind, NormalSource, PatternKind, ReflectionModel, Rgb, Scene,
    ShadingMode, Viewer,
};

/// A point with its normal.
type ShadingPoint = (DVec3, DVec3);

/// A term of a light: its value, and the causes if that is 0.
struct Term {
    specular: bool,
    value: Rgb,
    causes: ZeroCauses,
}

/// A scene with its polygons, against which stated causes are checked.
pub struct Judge<'a> {
    scene: &'a Scene,
    vertices: VertexMesh,
    surface: Option<Surface>,
}

impl<'a> Judge<'a> {
    pub fn new(scene: &'a Scene, model: Option<&Mesh>) -> Self {
        let mesh = model.map_or_else(|| tessellate(&scene.object), Mesh::clone);
        let facet = scene.shading.mode == ShadingMode::Interpolated;
        let normals = if facet {
            NormalSource::Facet
        } else {
            scene.object.normal_source()
        };
        let vertices = mesh.with_vertex_normals(normals, scene.object.weighting);
        let exact = scene.shading.mode == ShadingMode::Exact;
        Self {
            scene,
            vertices,
            surface: Surface::of(&scene.object).filter(|_| exact),
        }
    }

    /// Checks the causes stated for a light; returns those checked, or a description of a false one.
    pub fn check(
        &self,
        hit: &ProbeHit,
        light: &Light,
        terms: &LightTerms,
    ) -> Result<Vec<ZeroCause>, String> {
        let terms = [
            (false, terms.diffuse, terms.diffuse_zero),
            (true, terms.specular, terms.specular_zero),
        ];
        let mut checked = Vec::new();
        for (specular, value, causes) in terms {
            let term = Term {
                specular,
                value,
                causes,
            };
            if causes.is_empty() != (term.value != Rgb::ZERO) {
                return Err(format!("{value} with {causes:?}"));
            }
            // A picture may have several triangles about a pixel; the engine has decided for one of them.
            let judged = self
                .sites(hit)
                .iter()
                .any(|sites| self.holds(light, sites, &term));
            if !judged
                && self
                    .sites(hit)
                    .iter()
                    .all(|sites| sites.iter().all(|site| site.1 != DVec3::ZERO))
            {
                let named: Vec<_> = causes.iter().collect();
                return Err(format!("specular: {specular}, {named:?} is not the reason"));
            }
            checked.extend(causes.iter());
        }
        Ok(checked)
    }

    /// Returns the points where the equation is evaluated: several sets if they depend on how a polygon is cut.
    fn sites(&self, hit: &ProbeHit) -> Vec<Vec<ShadingPoint>> {
        let Some(face) = hit.face.map(|face| face as usize) else {
            return vec![vec![(hit.position, hit.normal)]];
        };
        let mesh = &self.vertices;
        let at = |v: u32| {
            let v = v as usize;
            (
                mesh.origin + mesh.positions[v].as_dvec3(),
                mesh.normals[v].as_dvec3(),
            )
        };
        let corners: Vec<ShadingPoint> = mesh.face(face).iter().map(|&v| at(v)).collect();
        match (self.scene.shading.mode, self.scene.shading.flat_at) {
            (ShadingMode::Phong | ShadingMode::Exact, _) => vec![vec![(hit.position, hit.normal)]],
            (ShadingMode::Flat, FlatAt::Centre) => {
                vec![vec![(mesh.face_centre(face), mesh.face_normal(face))]]
            }
            (ShadingMode::Flat, FlatAt::VertexMean) => vec![corners],
            (ShadingMode::Flat, FlatAt::ProvokingVertex) => vec![corners[..1].to_vec()],
            (ShadingMode::Gouraud | ShadingMode::Interpolated, _) => triples(&corners),
        }
    }

    /// Returns whether the causes of a term are real at these shading points: a single cause at all of them and for all points of
    /// the light, each of several causes somewhere.
    fn holds(&self, light: &Light, sites: &[ShadingPoint], term: &Term) -> bool {
        let points = if light.kind == LightKind::Area {
            area_samples(light)
        } else {
            vec![light.position]
        };
        let pairs = || {
            sites
                .iter()
                .flat_map(|site| points.iter().map(move |point| (*site, *point)))
        };
        let one = term.causes.iter().count() == 1;
        term.causes.iter().all(|cause| {
            let real = |(site, point)| self.is_real(cause, light, site, point, term.specular);
            if one {
                pairs().all(real)
            } else {
                pairs().any(real)
            }
        })
    }

    fn is_real(
        &self,
        cause: ZeroCause,
        light: &Light,
        (p, n): ShadingPoint,
        point: DVec3,
        specular: bool,
    ) -> bool {
        let scene = self.scene;
        let (l, blur) = self.towards(light, p, point);
        let lambert = n.dot(l);
        let flips = scene.reflection.backfacing == Backfacing::Flip;
        match cause {
            ZeroCause::Muted => light.mute,
            ZeroCause::NotSoloed => !light.solo && scene.lights.iter().any(|light| light.solo),
            ZeroCause::Black => light.color == Rgb::ZERO,
            ZeroCause::Coefficient => self.coefficients(specular).contains(&Rgb::ZERO),
            ZeroCause::NoChannel => self
                .coefficients(specular)
                .iter()
                .any(|coefficient| (0..3).all(|c| light.color[c] == 0.0 || coefficient[c] == 0.0)),
            ZeroCause::FacesAway => (if flips { lambert.abs() } else { lambert }) <= blur,
            ZeroCause::OutsideCone => {
                let axis = (light.direction / light.direction.abs().max_element()).normalize();
                light.kind == LightKind::Spot
                    && (-l).angle_between(axis) >= light.cone.to_radians() - 1e-6 - blur.sqrt()
            }
            ZeroCause::InShadow => scene.shading.shadows && self.is_blocked(light, (p, n), point),
            ZeroCause::MissesViewer => specular && self.lobe_cosine((p, n), l) <= blur + 1e-9,
            ZeroCause::LawIsZero => !specular && scene.reflection.model == ReflectionModel::Formula,
            ZeroCause::OneTerm => specular && scene.reflection.model == ReflectionModel::Formula,
            ZeroCause::TooFaint => {
                let strongest = self
                    .coefficients(specular)
                    .into_iter()
                    .map(|c| (c * light.color).max_element());
                let cosine = self.lobe_cosine((p, n), l).clamp(0.0, 1.0);
                let faint = scene.reflection.model == ReflectionModel::CookTorrance
                    || cosine.powf(scene.material.n) < 1e-9;
                // For the maximum and the minimum that attenuation and a cone leave.
                (specular && faint)
                    || strongest.fold(0.0, f64::max) < 1e-200
                    || light.kind == LightKind::Spot
            }
        }
    }

    /// Returns L at `p`, and the error of its cosines due to the rounding of positions.
    fn towards(&self, light: &Light, p: DVec3, point: DVec3) -> (DVec3, f64) {
        let camera = &self.scene.camera;
        let unit = |v: DVec3| (v / v.abs().max_element()).normalize_or_zero();
        if light.kind == LightKind::Directional {
            return (-unit(light.direction), 1e-9);
        }
        let (far, near) = ((point - camera.eye).length(), (point - p).length());
        if far > 1e9 * camera.distance() {
            // So far from the camera that its rays count as parallel.
            return (unit(point - camera.eye), 1e-9);
        }
        let spread =
            far + (p - camera.eye).length() + p.length() + point.length() + camera.distance();
        (unit(point - p), 1e-9 + 1e-12 * spread / near)
    }

    /// Returns Kd·Od or Ks·Os·W, for either colour of a pattern.
    fn coefficients(&self, specular: bool) -> Vec<Rgb> {
        let material = &self.scene.material;
        if specular {
            // W is 0 either at all angles or at none: only an index of 1 makes it 0.
            let w = Index::of(material).map_or(Rgb::ONE, |index| index.reflectance(0.5));
            return vec![material.ks * material.specular_color * w];
        }
        let patterned = self.scene.pattern.kind != PatternKind::None;
        let other = if patterned {
            self.scene.pattern.color
        } else {
            material.color
        };
        vec![material.kd * material.color, material.kd * other]
    }

    /// Returns R·V for Phong's model, N·H for Blinn's, and for Cook and Torrance's the smaller of N·H and N·V + ¼. If
    /// rounding decides which side a grazing light is on, returns the minimum over both.
    fn lobe_cosine(&self, (p, n): ShadingPoint, l: DVec3) -> f64 {
        let camera = &self.scene.camera;
        let from = if camera.viewer == Viewer::Infinite {
            camera.target
        } else {
            p
        };
        let v = (camera.eye - from).normalize();
        let (grazes, flips) = (
            n.dot(l).abs() < 1e-9,
            self.scene.reflection.backfacing == Backfacing::Flip,
        );
        // Rounding decides on which side a grazing light is.
        let sides = if flips && grazes {
            vec![n, -n]
        } else {
            vec![if flips && n.dot(l) < 0.0 { -n } else { n }]
        };
        let cosine = |n: DVec3| match self.scene.reflection.model {
            ReflectionModel::Phong | ReflectionModel::Formula => (n * (2.0 * n.dot(l)) - l).dot(v),
            ReflectionModel::Blinn => n.dot((l + v).normalize_or_zero()),
            ReflectionModel::CookTorrance => {
                n.dot((l + v).normalize_or_zero()).min(n.dot(v) + 0.25)
            }
        };
        sides.into_iter().map(cosine).fold(1.0, f64::min)
    }

    /// Returns whether the floor, the surface or a polygon blocks the path from a shading point to a point of the light; an
    /// obstacle within rounding error counts.
    fn is_blocked(&self, light: &Light, (p, n): ShadingPoint, point: DVec3) -> bool {
        let (way, end) = match light.kind {
            LightKind::Directional => (-light.direction, f64::INFINITY),
            _ => (point - p, 1.0 + 1e-6),
        };
        let ground = &self.scene.ground;
        let t = (ground.height - p.y) / way.y;
        if ground.visible && (-1e-6..end).contains(&t) {
            return true;
        }
        let side = n * n.dot(way).signum();
        let lifts = [-1e-6, 0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2]
            .map(|lift| p + side * (lift * self.vertices.radius()));
        lifts.into_iter().any(|start| match &self.surface {
            Some(surface) => {
                let ray = Ray {
                    origin: start,
                    direction: way,
                };
                surface.intersect(&ray, 0.0).is_some_and(|hit| hit.t <= end)
            }
            None => (0..self.vertices.face_count()).any(|face| self.is_met(face, start, way, end)),
        })
    }

    #[allow(dead_code, reason = "each test takes what it needs of it")]
    /// Returns whether a face of a convex solid is turned away from a light. If its vertex normals are not, they stand for a
    /// smooth surface that is lit there, though the face itself is not.
    pub fn turns_away(&self, light: &Light, face: u32, p: DVec3) -> bool {
        let way = match light.kind {
            LightKind::Directional => -light.direction,
            _ => light.position - p,
        };
        self.vertices.convex && self.vertices.face_normal(face as usize).dot(way) < 0.0
    }

    #[allow(dead_code, reason = "each test takes what it needs of it")]
    /// Returns whether something blocks the light of a point with its normal, whatever offset is added to the point.
    pub fn is_clearly_blocked(&self, light: &Light, (p, n): (DVec3, DVec3)) -> bool {
        // In units of the object's radius, a millionth of which `is_met` ignores.
        let unit = |v: DVec3| (v / v.abs().max_element()).normalize_or_zero();
        let radius = self.vertices.radius();
        let (way, end) = match light.kind {
            LightKind::Directional => (unit(-light.direction) * radius, f64::INFINITY),
            _ => {
                let way = light.position - p;
                (unit(way) * radius, (1.0 - 1e-3) * way.length() / radius)
            }
        };
        let side = n * n.dot(way).signum();
        [1e-4, 1e-3, 1e-2, 5e-2, 1e-1, 2e-1]
            .into_iter()
            .all(|lift| {
                let start = p + side * (lift * self.vertices.radius());
                match &self.surface {
                    Some(surface) => {
                        let ray = Ray {
                            origin: start,
                            direction: way,
                        };
                        surface.intersect(&ray, 0.0).is_some_and(|hit| hit.t <= end)
                    }
                    None => (0..self.vertices.face_count())
                        .any(|face| self.is_met(face, start, way, end)),
                }
            })
    }

    fn is_met(&self, face: usize, start: DVec3, way: DVec3, end: f64) -> bool {
        let at = |v: &u32| {
            (
                self.vertices.origin + self.vertices.positions[*v as usize].as_dvec3(),
                DVec3::ZERO,
            )
        };
        let corners: Vec<ShadingPoint> = self.vertices.face(face).iter().map(at).collect();
        triples(&corners).iter().any(|triangle| {
            let [a, b, c] = [triangle[0].0, triangle[1].0, triangle[2].0];
            let across = (b - a).cross(c - a);
            let t = (a - start).dot(across) / way.dot(across);
            let p = start + way * t;
            let inside = |from: DVec3, to: DVec3| {
                (to - from).cross(p - from).dot(across) >= -1e-6 * across.length_squared()
            };
            (-1e-6..=end).contains(&t) && inside(a, b) && inside(b, c) && inside(c, a)
        })
    }
}

/// Returns every triangle over the corners of a polygon.
fn triples(corners: &[ShadingPoint]) -> Vec<Vec<ShadingPoint>> {
    let count = corners.len();
    let mut all = Vec::new();
    for a in 0..count {
        for b in a + 1..count {
            all.extend((b + 1..count).map(|c| vec![corners[a], corners[b], corners[c]]));
        }
    }
    all
}
