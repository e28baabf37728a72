//! The lobe of reflection: the light that a point reflects in every direction from one light.

use super::perception::luminance;
use super::probe::ProbeHit;
use crate::illumination::{Equation, ShadingPoint, V3, reflect};
use crate::scene::{Backfacing, Light, LightKind, Rgb, Scene};
use glam::DVec3;
use std::f64::consts::FRAC_PI_3;

/// Sine below which an angle's plane is lost to rounding, and tolerance for a length of 1.
const UPRIGHT: f64 = 1e-9;
/// Cosine from N below which a viewer is below the surface. A viewer in the surface itself still sees it, whatever the last
/// digit is.
const BELOW: f64 = -1e-12;

/// Reflection of a light as seen from one direction, as luminance. What a scene's own law reflects is not split: all of it
/// counts as specular.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Luminance by the diffuse term, the same in every direction.
    pub diffuse: f64,
    /// Luminance by the specular term.
    pub specular: f64,
}

impl Response {
    /// Returns the sum of both terms, which a scene's own law may make negative.
    pub fn total(self) -> f64 {
        self.diffuse + self.specular
    }

    /// Returns the sum of both terms as the length of an arrow: 0 where it is negative.
    pub fn length(self) -> f64 {
        self.total().max(0.0)
    }
}

/// The reflection of one light at one point as a function of the viewer's direction:
/// `I(V) = f·Ip·(kd·Od·(N·L) + ks·W·S(V))`, or f·Ip times the scene's own law; luminance by Rec. 709. The light's own switches
/// and shadows are ignored, an area light is a point in its middle, and where f depends on the distance to the viewer, that of
/// the picture is kept.
#[derive(Clone, Debug)]
pub struct ReflectionLobe {
    equation: Equation<f64>,
    site: ShadingPoint<f64>,
    od: Rgb,
    /// True if the scene's own law takes the place of both terms.
    own_law: bool,
    /// N, a unit vector on the side of the light.
    pub n: DVec3,
    /// L, a unit vector.
    pub l: DVec3,
    /// L mirrored at N, a unit vector.
    pub r: DVec3,
    /// V of the picture.
    pub v: DVec3,
    /// Unit vector perpendicular to N and away from L: with N it spans the plane of incidence.
    pub across: DVec3,
}

impl ReflectionLobe {
    /// Returns the lobe of light `light` at `hit`; none without such a light or a normal, or for a light behind the
    /// surface.
    pub fn at(scene: &Scene, hit: &ProbeHit, light: usize) -> Option<Self> {
        let mut alone = Light {
            mute: false,
            solo: false,
            ..scene.lights.get(light)?.clone()
        };
        if alone.kind == LightKind::Area {
            alone.kind = LightKind::Point;
        }
        let equation = Equation::<f64>::new(&Scene {
            lights: vec![alone],
            ..hit.scene_of(scene).into_owned()
        })
        .without_ambient();
        let own_law = scene.reflection.is_own_law();
        let site = equation.site(
            V3::from(equation.from_world(hit.position)),
            V3::from(hit.normal),
        );
        let mut lobe = Self {
            od: equation.pattern_color(hit.position),
            equation,
            site,
            own_law,
            n: hit.normal.try_normalize()?,
            l: DVec3::ZERO,
            r: DVec3::ZERO,
            v: hit.view,
            across: DVec3::ZERO,
        };
        lobe.l = lobe
            .equation
            .sources
            .first()
            .map(|source| lobe.equation.respond_to(source, &lobe.site).l.into())?;
        let two_sided = scene.reflection.backfacing == Backfacing::Flip && !own_law;
        if two_sided && lobe.n.dot(lobe.l) < 0.0 {
            lobe.n = -lobe.n;
        }
        lobe.r = mirrored(hit.normal, lobe.l)?;
        // A light directly above has every plane for its plane of incidence; the viewer's is as good as any.
        let aside = |vector: DVec3| {
            let level = vector - lobe.n * vector.dot(lobe.n);
            (level.length() > UPRIGHT).then(|| level.normalize())
        };
        let away = aside(-lobe.l).or_else(|| aside(lobe.v));
        lobe.across = away.unwrap_or_else(|| lobe.n.any_orthonormal_vector());
        (lobe.n.dot(lobe.l) > 0.0 && lobe.l.is_finite()).then_some(lobe)
    }

    /// Returns the direction in the plane of incidence `angle` radians from N, positive on the side of R.
    pub fn in_plane(&self, angle: f64) -> DVec3 {
        let (sine, cosine) = angle.sin_cos();
        self.n * cosine + self.across * sine
    }

    /// Returns the angle from N to R, radians.
    pub fn mirror_angle(&self) -> f64 {
        self.r.dot(self.across).atan2(self.r.dot(self.n))
    }

    /// Returns whether the scene's own law takes the place of both terms.
    pub fn is_own_law(&self) -> bool {
        self.own_law
    }

    /// Returns the point as seen from the unit direction `v`.
    fn seen_from(&self, v: DVec3) -> ShadingPoint<f64> {
        ShadingPoint {
            view: V3::from(v),
            ..self.site
        }
    }

    /// Returns the reflection as seen from the unit direction `v`, per channel; zero from below the surface.
    pub fn channels_towards(&self, v: DVec3) -> Rgb {
        if v.dot(self.n) < BELOW {
            return Rgb::ZERO;
        }
        Rgb::from_array(self.equation.illuminate(&self.seen_from(v), None))
    }

    /// Returns the angle from R at which the reflection has fallen to half of that at R, within the plane of incidence and on
    /// the side where that is first, radians: to 10 %, between 10⁻⁴ and 60°. 60° for a lobe that is not highest near R.
    pub fn half_width(&self) -> f64 {
        const FINEST: f64 = 1e-4;
        let at = |angle: f64| {
            self.towards(self.in_plane(self.mirror_angle() + angle))
                .total()
        };
        let half = 0.5 * self.towards(self.r).total();
        let mut angles = std::iter::successors(Some(FINEST), |angle| Some(1.1 * angle))
            .take_while(|angle| *angle < FRAC_PI_3);
        let fallen = angles.find(|angle| at(*angle).min(at(-angle)) < half);
        fallen.unwrap_or(FRAC_PI_3)
    }

    /// Returns the reflection as seen from the unit direction `v`; zero from below the surface.
    pub fn towards(&self, v: DVec3) -> Response {
        let mut response = Response {
            diffuse: 0.0,
            specular: 0.0,
        };
        if self.own_law {
            response.specular = luminance(self.channels_towards(v));
            return response;
        }
        if v.dot(self.n) < BELOW {
            return response;
        }
        let site = self.seen_from(v);
        for source in &self.equation.sources {
            let terms = self.equation.respond_to(source, &site);
            let w = self.equation.reflectance(terms.incidence);
            response.diffuse +=
                terms.diffuse * luminance(Rgb::from_array(source.diffuse) * self.od);
            response.specular += terms.specular * luminance(Rgb::from_array(source.specular) * w);
        }
        response
    }
}

/// Computes R by the equation's own operations: a mirror reflects in that one direction, to the last digit.
fn mirrored(n: DVec3, l: DVec3) -> Option<DVec3> {
    let (n, l) = (V3::from(n), V3::from(l));
    let r = DVec3::from(reflect(n, l, n.dot(l)));
    // A normal that is not of unit length does not mirror.
    if (r.length() - 1.0).abs() < UPRIGHT {
        Some(r)
    } else {
        r.try_normalize()
    }
}
