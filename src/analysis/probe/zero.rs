//! Why a light adds nothing at a pixel, found for each of its points and at each place where the equation is evaluated.

use crate::illumination::{Equation, LightResponse, ShadingPoint, V3};
use crate::render::Evaluation;
use crate::scene::{Backfacing, PatternKind, ReflectionModel, Rgb, Scene};
use glam::DVec3;
use serde::{Serialize, Serializer};

/// What makes a term 0. The first that holds everywhere is the one that is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ZeroCause {
    /// The light is muted.
    Muted,
    /// Another light is soloed.
    NotSoloed,
    /// Ip is 0.
    Black,
    /// `Kd·Od`, or `Ks·Os·W`, is 0.
    Coefficient,
    /// No channel has both: in each, Ip or the coefficient is 0.
    NoChannel,
    /// N·L ≤ 0, or above 0 by no more than rounding.
    FacesAway,
    /// The point lies outside a spot light's cone.
    OutsideCone,
    /// Something stands between the point and the light.
    InShadow,
    /// The highlight points away from the viewer: R·V ≤ 0 or N·H ≤ 0, or for microfacets N·V ≤ −¼.
    MissesViewer,
    /// The product rounds to 0, or the highlight is below 3·10⁻¹⁰ and not evaluated.
    TooFaint,
}

impl ZeroCause {
    const ALL: [Self; 10] = [
        Self::Muted,
        Self::NotSoloed,
        Self::Black,
        Self::Coefficient,
        Self::NoChannel,
        Self::FacesAway,
        Self::OutsideCone,
        Self::InShadow,
        Self::MissesViewer,
        Self::TooFaint,
    ];

    /// In a word or two.
    pub(super) fn short(self) -> &'static str {
        match self {
            Self::Muted => "muted",
            Self::NotSoloed => "another is soloed",
            Self::Black => "black",
            Self::Coefficient | Self::NoChannel => "not reflected",
            Self::FacesAway => "behind the surface",
            Self::OutsideCone => "outside its cone",
            Self::InShadow => "in shadow",
            Self::MissesViewer => "not to the viewer",
            Self::TooFaint => "too faint",
        }
    }

    /// In a clause, for a term whose coefficient is called `coefficient`.
    fn clause(self, coefficient: &str) -> String {
        let clause = match self {
            Self::Muted => "it is muted",
            Self::NotSoloed => "another light is soloed",
            Self::Black => "its Ip is 0",
            Self::Coefficient => return format!("{coefficient} is 0"),
            Self::NoChannel => return format!("Ip and {coefficient} have no channel in common"),
            Self::FacesAway => "the light is behind the surface, N·L ≤ 0",
            Self::OutsideCone => "the point lies outside the light's cone",
            Self::InShadow => "something stands before the light",
            Self::MissesViewer => "the highlight points away from the viewer",
            Self::TooFaint => "it is too faint to differ from 0",
        };
        clause.to_owned()
    }
}

/// Causes in their order: none where a term adds something, one that holds at all places where the equation is evaluated
/// and for all points of the light, or several that hold at some each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ZeroCauses(u16);

impl ZeroCauses {
    const NONE: Self = Self(0);
    const ALL: Self = Self(u16::MAX);

    pub fn iter(self) -> impl Iterator<Item = ZeroCause> {
        ZeroCause::ALL.into_iter().filter(move |cause| self.0 & Self::from(*cause).0 != 0)
    }

    pub fn is_empty(self) -> bool {
        self == Self::NONE
    }

    /// The first alone.
    pub(super) fn first(self) -> Self {
        Self(self.0 & self.0.wrapping_neg())
    }

    fn take(&mut self, holds: bool, cause: ZeroCause) {
        if holds {
            self.0 |= Self::from(cause).0;
        }
    }

    pub(super) fn clauses(self, coefficient: &str) -> String {
        let clauses: Vec<_> = self.iter().map(|cause| cause.clause(coefficient)).collect();
        if let [clause] = &clauses[..] { clause.clone() } else { format!("in part {}", clauses.join("; in part ")) }
    }
}

impl From<ZeroCause> for ZeroCauses {
    fn from(cause: ZeroCause) -> Self {
        Self(1 << cause as u16)
    }
}

impl Serialize for ZeroCauses {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter())
    }
}

/// Why the diffuse and the specular term of a light are 0, where they are; `values` are the terms. `all` has the sources of
/// every light, `shining` those that the picture is shaded with, whose shadows are known.
pub(super) fn zero_causes(
    scene: &Scene,
    [all, shining]: [&Equation<f64>; 2],
    evaluation: &Evaluation<'_>,
    light: usize,
    values: [Rgb; 2],
) -> [ZeroCauses; 2] {
    let source = &scene.lights[light];
    let for_all = [
        (source.mute, ZeroCause::Muted),
        (!source.shines(scene.soloing()), ZeroCause::NotSoloed),
        (source.color == Rgb::ZERO, ZeroCause::Black),
    ];
    if let Some((_, cause)) = for_all.into_iter().find(|(holds, _)| *holds) {
        return [cause.into(); 2];
    }
    let (mut always, mut ever) = ([ZeroCauses::ALL; 2], [ZeroCauses::NONE; 2]);
    for site in evaluation.points.iter().filter(|site| site.weight != 0.0) {
        let mut kept = shining.sources_of(light);
        for index in all.sources_of(light) {
            let in_shadow = kept.next().zip(site.reached).is_some_and(|(kept, reached)| !reached.holds(kept));
            let place = Place { scene, equation: all, light, index, point: site.point, normal: site.normal, in_shadow };
            for (term, causes) in place.causes().into_iter().enumerate() {
                always[term].0 &= causes.0;
                ever[term].0 |= causes.first().0;
            }
        }
    }
    let both = ZeroCauses(always[0].0 & always[1].0).first();
    [0, 1].map(|term| {
        let shown = [both, always[term].first(), ever[term]].into_iter().find(|causes| !causes.is_empty());
        let shown = shown.unwrap_or(ZeroCause::TooFaint.into());
        if values[term] == Rgb::ZERO { shown } else { ZeroCauses::NONE }
    })
}

/// One source and one place where the equation is evaluated.
struct Place<'a> {
    scene: &'a Scene,
    equation: &'a Equation<f64>,
    light: usize,
    index: usize,
    point: DVec3,
    normal: DVec3,
    in_shadow: bool,
}

impl Place<'_> {
    /// Why the diffuse and the specular term are 0 here.
    fn causes(&self) -> [ZeroCauses; 2] {
        let equation = self.equation;
        let site = equation.site(V3::from(equation.from_world(self.point)), V3::from(self.normal));
        let source = &equation.sources[self.index];
        let response = equation.respond_to(source, &site);
        let material = &self.scene.material;
        let patterned = self.scene.pattern.kind != PatternKind::None;
        let od = if patterned { equation.pattern_color(self.point) } else { material.color };
        let w = equation.reflectance(response.incidence);
        let both = self.of_light(&response);
        let mut causes = [(material.kd * od, both), (material.ks * material.specular_color * w, both)];
        causes[1].1.take(self.misses_the_viewer(&site, &response), ZeroCause::MissesViewer);
        let od = equation.pattern_color(self.point);
        let values = [
            Rgb::from_array(source.diffuse) * od * response.diffuse,
            Rgb::from_array(source.specular) * w * response.specular,
        ];
        [0, 1].map(|term| {
            let (coefficient, mut causes) = causes[term];
            let ip = self.scene.lights[self.light].color;
            causes.take(coefficient == Rgb::ZERO, ZeroCause::Coefficient);
            causes.take((0..3).all(|c| ip[c] == 0.0 || coefficient[c] == 0.0), ZeroCause::NoChannel);
            causes.take(causes.is_empty(), ZeroCause::TooFaint);
            if values[term] == Rgb::ZERO || self.in_shadow { causes } else { ZeroCauses::NONE }
        })
    }
}

impl Place<'_> {
    /// What keeps the light from both terms.
    fn of_light(&self, response: &LightResponse<f64>) -> ZeroCauses {
        let mut causes = ZeroCauses::NONE;
        let arriving = response.n_dot_l * response.attenuation * response.spot;
        let turned_away = response.n_dot_l <= 0.0 || (response.diffuse == 0.0 && arriving > 0.0);
        causes.take(turned_away, ZeroCause::FacesAway);
        let outside = self.equation.sources[self.index].is_outside_cone(response.l);
        causes.take(outside, ZeroCause::OutsideCone);
        causes.take(self.in_shadow, ZeroCause::InShadow);
        causes
    }

    /// Whether the highlight points away from the viewer, so that S is 0.
    fn misses_the_viewer(&self, site: &ShadingPoint<f64>, response: &LightResponse<f64>) -> bool {
        let (l, v) = (DVec3::from(response.l), DVec3::from(site.view));
        let flips = self.scene.reflection.backfacing == Backfacing::Flip && self.normal.dot(l) < 0.0;
        let n = if flips { -self.normal } else { self.normal };
        let power = self.scene.material.n > 0.0;
        match self.scene.reflection.model {
            ReflectionModel::Phong => power && 2.0 * n.dot(l) * n.dot(v) <= l.dot(v),
            ReflectionModel::Blinn => power && n.dot(l + v) <= 0.0,
            ReflectionModel::CookTorrance => n.dot(l + v) <= 0.0 || n.dot(v) <= -0.25,
        }
    }
}
