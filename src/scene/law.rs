//! The names of a law of reflection that is typed as a formula.

use super::{Reflection, ReflectionModel};
use crate::expression::{Formula, FormulaError, Names};

/// The numbers that a law may use: cosines, the distance to the light in world units, angles in degrees, and the material's.
pub const LAW_NUMBERS: [&str; 17] = [
    "N·L", "R·V", "N·H", "V·H", "N·V", "L·V", "d", "theta", "phi", "ka", "kd", "ks", "od", "os",
    "n", "m", "eta",
];

/// The unit vectors that a law may use.
pub const LAW_VECTORS: [&str; 5] = ["N", "L", "V", "R", "H"];

impl Reflection {
    /// Phong's law as a formula, the one that a scene has until another is written. The last factor leaves the highlight out behind
    /// the surface, as the model that is built in does.
    pub const PHONG: &'static str =
        "spot = max(R·V, 0)\nkd * od * max(N·L, 0) + ks * os * spot^n * (N·L > 0)";

    /// The longest formula, in characters.
    pub const MOST_CHARACTERS: usize = Formula::MOST_CHARACTERS;

    /// Returns the names that a law may use.
    pub fn law_names() -> Names {
        Names::new(&LAW_NUMBERS, &LAW_VECTORS)
    }

    /// Returns whether the model is the formula.
    pub fn is_own_law(&self) -> bool {
        self.model == ReflectionModel::Formula
    }

    /// Returns whether the model is the formula, and one of these quantities appears in it.
    pub fn law_uses(&self, quantities: &[&str]) -> bool {
        let known = LAW_NUMBERS.iter().chain(&LAW_VECTORS);
        let known: Vec<bool> = known.map(|name| quantities.contains(name)).collect();
        let is_one = |index: usize| known.get(index) == Some(&true);
        self.is_own_law() && self.law().is_ok_and(|law| law.names_any(&is_one))
    }

    /// Returns whether the model is the formula, and none of these quantities appears in it.
    pub(super) fn law_leaves_out(&self, quantities: &[&str]) -> bool {
        self.is_own_law() && !self.law_uses(quantities)
    }

    /// Reads the law; the error says where it is wrong, what was expected there, and the nearest name.
    pub fn law(&self) -> Result<Formula, FormulaError> {
        Formula::read(&self.formula, &Self::law_names())
    }
}
