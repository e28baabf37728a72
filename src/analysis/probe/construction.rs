//! Construction of R and H from N, L and V, step by step, with the numbers of one pixel.

use super::digits::{coordinates, digits};
use super::products::LightHere;
use crate::text::{fixed, text};
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
    /// Returns the construction of R and H, without those of R where no light is in front, or of H where L is −V.
    pub fn construction(self) -> Vec<WorkedStep> {
        let (n, letters) = if self.turned() {
            (-self.here.hit.normal, "−{N}·{L}")
        } else {
            (self.here.hit.normal, "{N}·{L}")
        };
        let (l, v) = (self.terms.l, self.here.hit.view);
        if n == DVec3::ZERO || ![n, l, v].iter().all(|vector| vector.is_finite()) {
            return vec![];
        }
        let cosine = n.dot(l);
        let products = (n * l).to_array().map(|product| fixed(product, 4));
        let step = |step, formula, numbers, result| WorkedStep {
            step,
            formula,
            numbers,
            result,
        };
        let mut steps = vec![step(
            ConstructionStep::Cosine,
            letters,
            vec![products.join(" + ").replace("+ −", "− "), fixed(cosine, 4)],
            DVec3::X * cosine,
        )];
        if cosine > 0.0 {
            let foot = n * cosine;
            let across = foot - l;
            let mirrored = foot + across;
            let times = format!("{} · {}", fixed(cosine, 4), coordinates(n));
            let made = |sign: &str, a, b| format!("{} {sign} {}", coordinates(a), coordinates(b));
            let mut add = |which, formula, numbers, vector| {
                let numbers = vec![numbers, coordinates(vector)];
                steps.push(step(which, formula, numbers, vector));
            };
            add(ConstructionStep::Projection, "{N}({N}·{L})", times, foot);
            let formula = "S = {N}({N}·{L}) − {L}";
            let numbers = made("−", foot, l);
            add(ConstructionStep::Across, formula, numbers, across);
            let formula = "{R} = {N}({N}·{L}) + S = 2{N}({N}·{L}) − {L}";
            let numbers = made("+", foot, across);
            add(ConstructionStep::Mirror, formula, numbers, mirrored);
        }
        let sum = l + v;
        if let Some(halfway) = sum.try_normalize() {
            let quotient = format!("{}/{}", coordinates(sum), digits(sum.length()));
            let numbers = vec![quotient, coordinates(halfway)];
            let formula = "{H} = ({L} + {V})/|{L} + {V}|";
            steps.push(step(ConstructionStep::Halfway, formula, numbers, halfway));
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
