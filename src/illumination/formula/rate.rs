//! The rates at which the values of a formula change.

/// The rate at which a value changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rate {
    /// Never: a number of the formula.
    Never,
    /// Once a frame.
    Frame,
    /// Once for each light.
    Light,
    /// At each point, for all lights together.
    Point,
    /// At each point for each light.
    PointLight,
}

impl Rate {
    /// Returns how often a value changes that depends on two others.
    pub fn join(self, other: Self) -> Self {
        match (self.min(other), self.max(other)) {
            (Self::Light, Self::Point) => Self::PointLight,
            (_, larger) => larger,
        }
    }
}
