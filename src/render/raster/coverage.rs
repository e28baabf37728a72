//! A covered picture: which triangle each pixel sees, and what it was brought.

use super::cover::Band;
use super::fragments::{Block, Fragment, fragment};
use super::grid::{BAND, BandPlace};
use rayon::prelude::*;

/// Rows of a band.
pub const ROWS: usize = BAND as usize;

/// The bands of a picture from the top, with their fragments where these are kept.
#[derive(Clone, Copy)]
pub struct Coverage<'a> {
    pub size: [u32; 2],
    pub bands: &'a [Band],
    pub fragments: &'a [Block],
}

impl<'a> Coverage<'a> {
    /// The bands one by one, each with its fragments.
    pub fn parts(self) -> impl IndexedParallelIterator<Item = (BandPlace, &'a Band, &'a [Block])> {
        let [width, height] = self.size;
        let share = ROWS * Block::count(width);
        self.bands.par_iter().enumerate().map(move |(index, band)| {
            let first_row = index as u32 * BAND;
            let fragments = &self.fragments[(index * share).min(self.fragments.len())..];
            let place = BandPlace { first_row, rows: BAND.min(height.saturating_sub(first_row)), width };
            (place, band, &fragments[..share.min(fragments.len())])
        })
    }

    /// The fragment of a pixel, where they are kept.
    pub fn fragment_at(self, [x, y]: [u32; 2]) -> Option<Fragment> {
        let count = Block::count(self.size[0]);
        let line = self.fragments.get(y as usize * count..(y as usize + 1) * count)?;
        (x < self.size[0]).then(|| fragment(line, x as usize))
    }

    /// The triangle that a pixel sees.
    pub fn triangle_at(self, [x, y]: [u32; 2]) -> Option<u32> {
        let runs = &self.bands.get((y / BAND) as usize)?.runs;
        let sees = |run: &&super::cover::Run| {
            u32::from(run.row) == y % BAND && (u32::from(run.x0)..u32::from(run.x1)).contains(&x)
        };
        runs.iter().find(sees).map(|run| run.triangle)
    }
}
