//! The way of a packet of rays down a tree of boxes: which box is next, and which wait.

use std::ops::Index;

/// A box by its index, and the rays of the packet that enter it, a bit each.
pub type Entered = (u32, u32);

/// The boxes that wait while nearer ones are visited, at most one a level of the tree.
pub struct Descent<const DEPTH: usize> {
    waiting: [Entered; DEPTH],
    count: usize,
}

impl<const DEPTH: usize> Descent<DEPTH> {
    #[inline(always)]
    pub fn new() -> Self {
        Self {
            waiting: [(0, 0); DEPTH],
            count: 0,
        }
    }

    /// Returns the first of two children, if any ray enters it, and lets the second wait, if any ray enters that.
    #[inline(always)]
    pub fn descend(&mut self, [first, second]: [Entered; 2]) -> Option<Entered> {
        if second.1 != 0 {
            self.waiting[self.count] = second;
            self.count += 1;
        }
        (first.1 != 0).then_some(first)
    }

    /// Returns the box that has waited for the shortest time; the rays may have met something nearer meanwhile.
    #[inline(always)]
    pub fn pop(&mut self) -> Option<Entered> {
        self.count = self.count.checked_sub(1)?;
        Some(self.waiting[self.count])
    }
}

/// Puts that of two children first which the first of the rays `among` enters first; `at` has where the rays enter each.
#[inline(always)]
pub fn nearer_first<V: Index<usize, Output: PartialOrd>>(
    among: u32,
    [left, right]: [Entered; 2],
    at: &[V; 2],
) -> [Entered; 2] {
    let lead = among.trailing_zeros() as usize;
    if right.1 != 0 && (left.1 == 0 || at[0][lead] > at[1][lead]) {
        [right, left]
    } else {
        [left, right]
    }
}
