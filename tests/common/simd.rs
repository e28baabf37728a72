//! The SIMD levels of this machine.

use fearless_simd::Level;
use shading_lab::render::SimdLevel;

/// Returns all available levels, best first.
pub fn levels() -> Vec<Level> {
    let level = |(_, level)| level;
    SimdLevel::available().into_iter().map(level).collect()
}
