//! An even choice of needles where there are more than a picture can show.
//!
//! Needles keep a distance in the world, not in the picture, so that towards an outline they close up as the surface does,
//! and those on the outline stay.

use crate::analysis::SeenNormal;
use glam::DVec3;
use std::collections::HashMap;

/// More needles than this are never drawn.
const MOST: usize = 2000;
/// More normals than this are not looked at one by one: by chance as many are.
const LOOKED_AT: usize = 24_000;
/// Edges shorter than this, in letters, leave no room for needles at every one.
const CROWDED: f64 = 0.5;
/// Least distance between needles, in letters, where they are crowded; elsewhere in median edges: a shape has parts that
/// are finer than the rest.
const APART: f64 = 0.8;
const APART_IN_EDGES: f64 = 0.3;
/// The distance from needles of the other kind, where they are crowded, in that between needles.
const OTHERS: f64 = 0.3;

/// What of the needles is drawn.
pub struct Choice {
    pub shown: Vec<SeenNormal>,
    /// How far they are kept apart where they are crowded, world units.
    pub apart: f64,
    /// Whether some are left out that nothing hides.
    pub thinned: bool,
}

/// As many needles that are not `hidden` as keep a distance from each other and from `others`, in the order of the mesh.
/// `edge` is the polygons' and `letter` the size of the type, both in world units.
pub fn thinned(
    seen: &[SeenNormal],
    edge: f64,
    letter: f64,
    others: &[DVec3],
    hidden: impl Fn(&SeenNormal) -> bool,
) -> Choice {
    let crowded = seen.len() > MOST || edge < CROWDED * letter;
    let (mut apart, others) = if crowded { (APART * letter, others) } else { (APART_IN_EDGES * edge, &[][..]) };
    let one_in = seen.len().div_ceil(LOOKED_AT) as u64;
    let looked_at: Vec<SeenNormal> =
        seen.iter().filter(|one| scattered(one.index).is_multiple_of(one_in)).copied().collect();
    loop {
        let (shown, dropped) = kept_apart(&looked_at, apart, others, &hidden);
        // Where a letter has no size either, no distance would ever be enough.
        let grows = apart.is_finite() && (apart > 0.0 || letter > 0.0);
        if shown.len() <= MOST || !grows {
            let apart = if crowded { apart } else { 0.0 };
            return Choice { shown, apart, thinned: dropped || one_in > 1 };
        }
        // From nothing, where all edges have no length, the next is a letter's.
        apart = (1.25 * apart).max(APART * letter);
    }
}

/// A number that has nothing to do with those beside it (the finaliser of SplitMix64, Steele et al. 2014).
fn scattered(index: u32) -> u64 {
    let mut x = u64::from(index).wrapping_add(0x9E37_79B9_7F4A_7C15);
    x = (x ^ (x >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    x ^ (x >> 31)
}

/// Cells as wide as the distance: what is too near lies in a cell or in one beside it.
struct Grid {
    cell: f64,
    feet: HashMap<[i64; 3], Vec<DVec3>>,
}

impl Grid {
    fn of(cell: f64, feet: &[DVec3]) -> Self {
        let mut grid = Self { cell: cell.max(f64::MIN_POSITIVE), feet: HashMap::new() };
        feet.iter().for_each(|foot| grid.add(*foot));
        grid
    }

    fn place(&self, foot: DVec3) -> [i64; 3] {
        (foot / self.cell).floor().to_array().map(|x| x as i64)
    }

    fn add(&mut self, foot: DVec3) {
        self.feet.entry(self.place(foot)).or_default().push(foot);
    }

    /// Whether nothing is nearer to `foot` than a cell is wide.
    fn free(&self, foot: DVec3) -> bool {
        if self.feet.is_empty() {
            return true;
        }
        let near = |other: &DVec3| other.distance_squared(foot) < self.cell * self.cell;
        let taken = |place: [i64; 3]| self.feet.get(&place).is_some_and(|feet| feet.iter().any(near));
        let [x, y, z] = self.place(foot);
        // Most of what is not free is told by its own cell.
        if taken([x, y, z]) {
            return false;
        }
        let beside = |x: i64| x.saturating_sub(1)..=x.saturating_add(1);
        !beside(x).any(|x| beside(y).any(|y| beside(z).any(|z| taken([x, y, z]))))
    }
}

/// Those that are kept, and whether another was left out that nothing hides.
fn kept_apart(
    seen: &[SeenNormal],
    apart: f64,
    others: &[DVec3],
    hidden: &impl Fn(&SeenNormal) -> bool,
) -> (Vec<SeenNormal>, bool) {
    let others = Grid::of(OTHERS * apart, others);
    let mut own = Grid::of(apart, &[]);
    let mut shown: Vec<SeenNormal> = Vec::new();
    let mut dropped = false;
    for one in seen {
        if !own.free(one.point) || !others.free(one.point) {
            // Several normals at one point are several vertices.
            let upon = shown.last().is_some_and(|last| last.point == one.point && last.normal != one.normal);
            if !upon {
                dropped = dropped || !hidden(one);
                continue;
            }
        }
        if !hidden(one) {
            own.add(one.point);
            shown.push(*one);
        }
    }
    (shown, dropped)
}
