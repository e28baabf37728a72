//! How much coarser a picture is drawn while something is dragged.

/// A frame is to take no longer, nanoseconds: thirty of them in a second, and room for the window round the picture.
const BUDGET: u64 = 26_000_000;
/// No coarser: what is dragged must still be recognised.
pub const COARSEST: u32 = 8;

/// Downscale factor that keeps a frame of this cost within the budget; 1 for none.
pub fn coarseness(nanoseconds: u64) -> u32 {
    (1..COARSEST).find(|coarser| nanoseconds / u64::from(coarser * coarser) <= BUDGET).unwrap_or(COARSEST)
}

/// A picture's size drawn coarser.
pub fn coarser_size(size: [u32; 2], coarser: u32) -> [u32; 2] {
    size.map(|side| side.div_ceil(coarser.max(1)).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_keeps_up_is_drawn_whole_and_nothing_coarser_than_it_must() {
        let in_ms = |ms: u64| coarseness(ms * 1_000_000);
        assert_eq!([0, 5, 26, 27, 104, 105, 700, 100_000].map(in_ms), [1, 1, 1, 2, 2, 3, 6, COARSEST]);
        assert_eq!(coarser_size([641, 480], 2), [321, 240]);
        assert_eq!(coarser_size([3, 1], 8), [1, 1]);
    }
}
