//! Which source of light is seen from which point: a bit each.

use crate::illumination::Reached;

/// Points of a block where the equation is evaluated at vertices or faces.
pub const BLOCK: usize = 4096;

/// Blocks of points, each with a row of bits a source. A block is a row of pixels, or [`BLOCK`] vertices or faces.
#[derive(Default)]
pub struct Visibility {
    pub words: Vec<u64>,
    /// Words of one block.
    pub block: usize,
    /// Words of one source within a block.
    pub stride: usize,
}

impl Visibility {
    /// Room for `blocks` blocks of `points` points, none in shadow.
    pub fn clear(&mut self, blocks: usize, points: usize, sources: usize) {
        self.stride = points.div_ceil(64);
        // One word more, since bits are read two words at a time.
        self.block = sources * self.stride + 1;
        self.words.clear();
        self.words.resize(blocks * self.block, u64::MAX);
    }

    /// The bits from point `first` of a block on.
    pub fn at(&self, block: usize, first: usize) -> Option<Reached<'_>> {
        let words = self.words.get(block * self.block..(block + 1) * self.block)?;
        (self.block > 0).then_some(Reached { words, stride: self.stride, first })
    }
}
