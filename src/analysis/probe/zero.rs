//! Reasons why a light adds nothing at a pixel, found for each of its points and at each place where the equation is
//! evaluated.

use crate::illumination::{Equation, V3};
use crate::render::Evaluation;
use crate::scene::{Backfacing, PatternKind, ReflectionModel, Rgb, Scene};
use crate::text;
use glam::DVec3;
use serde::{Serialize, Serializer};

/// A reason why a term is 0. The first that holds everywhere is the one shown.
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
    /// R·V ≤ 0 or N·H ≤ 0, or for microfacets N·V ≤ −¼.
    MissesViewer,
    /// The scene's own law gives 0.
    LawIsZero,
    /// The scene's own law is one term.
    OneTerm,
    /// The product rounds to 0, or the highlight is below 3·10⁻¹⁰ and not evaluated.
    TooFaint,
}

/// All causes in their order, each with the keys of its name and of its clause.
const CAUSES: [(ZeroCause, &str, &str); 12] = [
    (ZeroCause::Muted, "point-zero-muted", "point-zero-muted.why"),
    (
        ZeroCause::NotSoloed,
        "point-zero-not-soloed",
        "point-zero-not-soloed.why",
    ),
    (ZeroCause::Black, "point-zero-black", "point-zero-black.why"),
    (
        ZeroCause::Coefficient,
        "point-zero-not-reflected",
        "point-zero-not-reflected.why",
    ),
    (
        ZeroCause::NoChannel,
        "point-zero-not-reflected",
        "point-zero-not-reflected.channel",
    ),
    (
        ZeroCause::FacesAway,
        "point-zero-behind",
        "point-zero-behind.why",
    ),
    (
        ZeroCause::OutsideCone,
        "point-zero-outside-cone",
        "point-zero-outside-cone.why",
    ),
    (
        ZeroCause::InShadow,
        "point-zero-in-shadow",
        "point-zero-in-shadow.why",
    ),
    (
        ZeroCause::MissesViewer,
        "point-zero-not-to-viewer",
        "point-zero-not-to-viewer.why",
    ),
    (ZeroCause::LawIsZero, "point-zero-law", "point-zero-law.why"),
    (
        ZeroCause::OneTerm,
        "point-zero-one-term",
        "point-zero-one-term.why",
    ),
    (
        ZeroCause::TooFaint,
        "point-zero-too-faint",
        "point-zero-too-faint.why",
    ),
];

/// Causes in their order: none, one that holds for all points of the light everywhere, or several that hold at some.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ZeroCauses(u16);

impl ZeroCauses {
    const NONE: Self = Self(0);
    const ALL: Self = Self(u16::MAX);

    /// Returns the causes that hold, in their order.
    pub fn iter(self) -> impl Iterator<Item = ZeroCause> {
        CAUSES
            .into_iter()
            .map(|(cause, ..)| cause)
            .filter(move |cause| self.0 & Self::from(*cause).0 != 0)
    }

    /// Returns whether no cause holds.
    pub fn is_empty(self) -> bool {
        self == Self::NONE
    }

    pub(super) fn first(self) -> Self {
        Self(self.0 & self.0.wrapping_neg())
    }

    fn take(&mut self, holds: bool, cause: ZeroCause) {
        if holds {
            self.0 |= Self::from(cause).0;
        }
    }

    /// Returns the first cause in a word or two.
    pub(super) fn short(self) -> Option<&'static str> {
        self.iter()
            .next()
            .map(|cause| text!(CAUSES[cause as usize].1))
    }

    /// Returns the causes in a clause, for a term whose coefficient is called `coefficient`; none if there are none.
    pub(super) fn clauses(self, coefficient: &str) -> Option<String> {
        let clauses: Vec<String> = self
            .iter()
            .map(|cause| text!(CAUSES[cause as usize].2, c = coefficient))
            .collect();
        match &clauses[..] {
            [] => None,
            [clause] => Some(clause.clone()),
            _ => {
                let parts = clauses
                    .iter()
                    .map(|clause| text!("point-zero-in-part", clause = &clause[..]));
                Some(parts.collect::<Vec<_>>().join(text!("point-clause-gap")))
            }
        }
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

/// Finds why the two terms of a light are 0, where their `values` are: by the sources of `all` lights, and by those
/// that the picture is shaded with, whose shadows are known.
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
            let in_shadow = kept
                .next()
                .zip(site.reached)
                .is_some_and(|(kept, reached)| !reached.holds(kept));
            let here = causes_at(
                scene,
                all,
                [light, index],
                (site.point, site.normal, site.tint),
                in_shadow,
            );
            for (term, causes) in here.into_iter().enumerate() {
                always[term].0 &= causes.0;
                ever[term].0 |= causes.first().0;
            }
        }
    }
    let both = ZeroCauses(always[0].0 & always[1].0).first();
    [0, 1].map(|term| {
        let shown = [
            both,
            always[term].first(),
            ever[term],
            ZeroCause::TooFaint.into(),
        ];
        let shown = shown
            .into_iter()
            .find(|causes| values[term] == Rgb::ZERO && !causes.is_empty());
        shown.unwrap_or(ZeroCauses::NONE)
    })
}

/// Finds why the diffuse and the specular term of a source of a light are 0 at a point with its normal.
fn causes_at(
    scene: &Scene,
    equation: &Equation<f64>,
    [light, index]: [usize; 2],
    (point, normal, tint): (DVec3, DVec3, Rgb),
    in_shadow: bool,
) -> [ZeroCauses; 2] {
    let material = &scene.material;
    let site = equation.site(V3::from(equation.from_world(point)), V3::from(normal));
    let source = &equation.sources[index];
    let response = equation.respond_to(source, &site);
    let pattern_color = equation.pattern_color(point) * tint;
    let od = if scene.pattern.kind == PatternKind::None {
        material.color * tint
    } else {
        pattern_color
    };
    let w = equation.reflectance(response.incidence);
    let ip = scene.lights[light].color;
    let mut both = ZeroCauses::NONE;
    both.take(source.is_outside_cone(response.l), ZeroCause::OutsideCone);
    both.take(in_shadow, ZeroCause::InShadow);
    if scene.reflection.model == ReflectionModel::Formula {
        return [ZeroCause::LawIsZero, ZeroCause::OneTerm].map(|own| {
            let mut causes = both;
            causes.take(true, own);
            causes
        });
    }
    let arriving = response.n_dot_l * response.attenuation * response.spot;
    let turned_away = response.n_dot_l <= 0.0 || (response.diffuse == 0.0 && arriving > 0.0);
    both.take(turned_away, ZeroCause::FacesAway);
    let mut specular = both;
    specular.take(
        misses_the_viewer(scene, normal, response.l.into(), site.view.into()),
        ZeroCause::MissesViewer,
    );
    let highlight = Rgb::from_array(source.specular) * w * response.specular;
    let terms = [
        (
            both,
            material.kd * od,
            Rgb::from_array(source.diffuse) * pattern_color * response.diffuse,
        ),
        (
            specular,
            material.ks * material.specular_color * w,
            highlight,
        ),
    ];
    terms.map(|(mut causes, coefficient, value)| {
        causes.take(coefficient == Rgb::ZERO, ZeroCause::Coefficient);
        causes.take(
            (0..3).all(|c| ip[c] == 0.0 || coefficient[c] == 0.0),
            ZeroCause::NoChannel,
        );
        causes.take(causes.is_empty(), ZeroCause::TooFaint);
        if value == Rgb::ZERO || in_shadow {
            causes
        } else {
            ZeroCauses::NONE
        }
    })
}

/// Returns whether the highlight points away from the viewer, so that S is 0.
fn misses_the_viewer(scene: &Scene, normal: DVec3, l: DVec3, v: DVec3) -> bool {
    let flips = scene.reflection.backfacing == Backfacing::Flip && normal.dot(l) < 0.0;
    let n = if flips { -normal } else { normal };
    let power = scene.material.n > 0.0;
    match scene.reflection.model {
        ReflectionModel::Phong => power && 2.0 * n.dot(l) * n.dot(v) <= l.dot(v),
        ReflectionModel::Blinn => power && n.dot(l + v) <= 0.0,
        ReflectionModel::Formula => false,
        ReflectionModel::CookTorrance => n.dot(l + v) <= 0.0 || n.dot(v) <= -0.25,
    }
}
