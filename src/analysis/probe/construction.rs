//! Construction of R and H from N, L and V, step by step, with the numbers of one pixel.

use super::digits::{coordinates, digits};
use super::products::LightHere;
use crate::text;
use crate::text::fixed;
use glam::DVec3;

/// A step from N, L and V to R and H.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ConstructionStep {
    /// N·L, the cosine of θ.
    Cosine,
    /// N(N·L), the projection of L onto N.
    Projection,
    /// S = N(N·L) − L, from the end of L to that of its projection.
    Across,
    /// R = N(N·L) + S.
    Mirror,
    /// H = (L + V)/|L + V|.
    Halfway,
}

impl ConstructionStep {
    /// All steps, in order.
    pub const ALL: [Self; 5] = [
        Self::Cosine,
        Self::Projection,
        Self::Across,
        Self::Mirror,
        Self::Halfway,
    ];

    /// Describes the step in a few words.
    pub fn title(self) -> &'static str {
        match self {
            Self::Cosine => text!("point-step-cosine"),
            Self::Projection => text!("point-step-projection"),
            Self::Across => text!("point-step-across"),
            Self::Mirror => text!("point-step-mirror"),
            Self::Halfway => text!("point-step-halfway"),
        }
    }
}

/// A step with its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct WorkedStep {
    /// The step.
    pub step: ConstructionStep,
    /// Formula with its letters in braces; see [`plain_formula`](super::plain_formula).
    pub formula: &'static str,
    /// The formula with numbers, from one “=” to the next.
    pub numbers: Vec<String>,
    /// Result of the step; a number lies on the first axis.
    pub result: DVec3,
}

impl LightHere<'_> {
    /// Returns N as the construction uses it: turned towards the light where the surface has two sides.
    pub(super) fn facing_normal(self) -> DVec3 {
        if self.turned() {
            -self.here.hit.normal
        } else {
            self.here.hit.normal
        }
    }

    /// Returns the construction of R and H. R needs a light in front of the surface, H one that is not directly
    /// behind the point as the viewer sees it; without them there are fewer steps.
    pub fn construction(self) -> Vec<WorkedStep> {
        let (n, l, v) = (self.facing_normal(), self.terms.l, self.here.hit.view);
        if n == DVec3::ZERO || ![n, l, v].iter().all(|vector| vector.is_finite()) {
            return vec![];
        }
        let cosine = n.dot(l);
        let products = (n * l).to_array().map(|product| fixed(product, 4));
        let mut steps = vec![WorkedStep {
            step: ConstructionStep::Cosine,
            formula: if self.turned() {
                "−{N}·{L}"
            } else {
                "{N}·{L}"
            },
            numbers: vec![products.join(" + ").replace("+ −", "− "), fixed(cosine, 4)],
            result: DVec3::X * cosine,
        }];
        if cosine > 0.0 {
            let foot = n * cosine;
            let across = foot - l;
            let mirrored = foot + across;
            let times =
                |number: f64, vector| format!("{} · {}", fixed(number, 4), coordinates(vector));
            let made = |sign: &str, a, b| format!("{} {sign} {}", coordinates(a), coordinates(b));
            steps.extend([
                WorkedStep {
                    step: ConstructionStep::Projection,
                    formula: "{N}({N}·{L})",
                    numbers: vec![times(cosine, n), coordinates(foot)],
                    result: foot,
                },
                WorkedStep {
                    step: ConstructionStep::Across,
                    formula: "S = {N}({N}·{L}) − {L}",
                    numbers: vec![made("−", foot, l), coordinates(across)],
                    result: across,
                },
                WorkedStep {
                    step: ConstructionStep::Mirror,
                    formula: "{R} = {N}({N}·{L}) + S = 2{N}({N}·{L}) − {L}",
                    numbers: vec![made("+", foot, across), coordinates(mirrored)],
                    result: mirrored,
                },
            ]);
        }
        let sum = l + v;
        if let Some(halfway) = sum.try_normalize() {
            steps.push(WorkedStep {
                step: ConstructionStep::Halfway,
                formula: "{H} = ({L} + {V})/|{L} + {V}|",
                numbers: vec![
                    format!("{}/{}", coordinates(sum), digits(sum.length())),
                    coordinates(halfway),
                ],
                result: halfway,
            });
        }
        steps
    }

    /// Describes whether R is a unit vector, which it is if N is.
    pub fn mirror_check(self) -> String {
        let (r, n) = (self.terms.r.length(), self.here.hit.normal.length());
        if (r - 1.0).abs() < UNIT {
            text!("point-check-unit", r = fixed(r, 4))
        } else {
            text!("point-check-short", r = fixed(r, 4), n = fixed(n, 4))
        }
    }
}

/// Tolerance for a length of 1.
const UNIT: f64 = 5e-5;
