//! Newell's teapot as data: control points and patches, placed in the unit sphere.

use super::bezier::Patch;
use glam::DVec3;
use std::sync::LazyLock;

/// The published list, see `assets/teapot/README.md`.
const LISTING: &str = include_str!("../../assets/teapot/newell.txt");

/// The middle of the pot's bounding box; with `RADIUS`, a sphere about it that holds the pot. In the units and axes (z up)
/// of the list.
const CENTRE: DVec3 = DVec3::new(0.217, 0.0, 1.575);
const RADIUS: f64 = 3.35;

/// A group of patches: patches in different shells share no points, even where they touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Shell {
    /// Rim, body and bottom.
    Body,
    Handle,
    Spout,
    Lid,
}

/// The control points, and the sixteen of them that make each patch.
pub(crate) struct Teapot {
    /// The control points: y up, spout towards +x, within the unit sphere.
    pub points: Vec<DVec3>,
    /// The patches: rows of u (along the shape), columns of v (round it); ∂S/∂v × ∂S/∂u points outwards.
    pub patches: Vec<[u16; 16]>,
}

/// The teapot, read at first use.
pub(crate) static TEAPOT: LazyLock<Teapot> = LazyLock::new(Teapot::from_listing);

impl Teapot {
    fn from_listing() -> Self {
        let mut teapot = Self {
            points: Vec::new(),
            patches: Vec::new(),
        };
        for line in LISTING.lines() {
            if let Some(numbers) = line.strip_prefix("p ") {
                let [x, y, z] = parsed::<f64, 3>(numbers);
                // A quarter turn about x brings z up to y up.
                let p = (DVec3::new(x, y, z) - CENTRE) / RADIUS;
                teapot.points.push(DVec3::new(p.x, p.z, -p.y));
            } else if let Some(numbers) = line.strip_prefix("b ") {
                teapot.patches.push(parsed(numbers));
            }
        }
        teapot
    }

    pub fn patch(&self, patch: usize) -> Patch<DVec3> {
        Patch {
            points: self.patches[patch].map(|point| self.points[point as usize]),
        }
    }

    /// Returns the shell of a patch, by its place in the list.
    pub fn shell(patch: usize) -> Shell {
        match patch {
            12..16 => Shell::Handle,
            16..20 => Shell::Spout,
            20..28 => Shell::Lid,
            _ => Shell::Body,
        }
    }
}

/// Parses the N numbers of a line of the listing.
///
/// # Panics
/// If there are not N, which only a change of the listing can cause.
fn parsed<T: std::str::FromStr, const N: usize>(line: &str) -> [T; N] {
    let numbers: Vec<T> = line
        .split_whitespace()
        .filter_map(|word| word.parse().ok())
        .collect();
    numbers.try_into().unwrap_or_else(|_| {
        panic!("the listing of the teapot has a line without {N} numbers: {line}")
    })
}
