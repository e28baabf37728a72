//! The largest or the smallest of several values.

/// The end of a range that is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extreme {
    /// The largest value.
    Greatest,
    /// The smallest value.
    Least,
}

impl Extreme {
    /// Returns the factor that makes the wanted value the largest.
    pub fn sign(self) -> f64 {
        match self {
            Self::Greatest => 1.0,
            Self::Least => -1.0,
        }
    }
}

/// Returns whether two values are so near that one could be taken for the other.
pub fn too_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 0.02 * a.abs().max(b.abs())
}
