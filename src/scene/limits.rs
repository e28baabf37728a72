//! Limits that many parameters share.

/// Greatest coordinate and greatest length, world units: its square stays far below the greatest `f64`, and so do the
/// squares' sums.
pub const GREATEST_LENGTH: f64 = 1e30;

/// Shortest length that counts as one, world units: its square is still a normal number.
pub const LEAST_LENGTH: f64 = 1e-30;

/// Greatest intensity of a light or of the background, in units of the display's white.
pub const GREATEST_INTENSITY: f64 = 1e30;
