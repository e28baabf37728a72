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

#[cfg(test)]
mod tests {
    use super::{TEAPOT, Teapot};
    use glam::DVec3;

    #[test]
    fn the_listing_is_whole() {
        assert_eq!((TEAPOT.points.len(), TEAPOT.patches.len()), (306, 32));
        assert!(
            TEAPOT
                .patches
                .iter()
                .flatten()
                .all(|&point| (point as usize) < TEAPOT.points.len())
        );
    }

    fn same(a: &[DVec3; 16], b: &[DVec3; 16]) -> bool {
        a.iter().zip(b).all(|(a, b)| a.distance(*b) < 1e-12)
    }

    /// Turns points about the axis of body and lid, which in placed coordinates is not x = 0.
    fn about_the_axis(points: [DVec3; 16], turn: impl Fn(DVec3) -> DVec3) -> [DVec3; 16] {
        let axis = DVec3::X * (-super::CENTRE.x / super::RADIUS);
        points.map(|p| turn(p - axis) + axis)
    }

    #[test]
    fn body_and_lid_have_fourfold_symmetry() {
        for (first, sense) in [
            (0, 1.0),
            (4, 1.0),
            (8, 1.0),
            (20, 1.0),
            (24, 1.0),
            (28, -1.0),
        ] {
            for k in 0..3 {
                let quarter_turn = |p: DVec3| DVec3::new(-sense * p.z, p.y, sense * p.x);
                let turned = about_the_axis(TEAPOT.patch(first + k).points, quarter_turn);
                assert!(
                    same(&turned, &TEAPOT.patch(first + k + 1).points),
                    "patch {}",
                    first + k
                );
            }
        }
    }

    #[test]
    fn handle_and_spout_are_mirrored_in_the_plane_between_their_halves() {
        for first in [12, 14, 16, 18] {
            let mirrored = TEAPOT
                .patch(first)
                .points
                .map(|p| DVec3::new(p.x, p.y, -p.z));
            let mut other = TEAPOT.patch(first + 1).points;
            other.chunks_mut(4).for_each(<[DVec3]>::reverse);
            assert!(same(&mirrored, &other), "patch {first}");
        }
    }

    #[test]
    fn every_patch_belongs_to_the_shell_that_its_points_are_in() {
        for patch in 0..TEAPOT.patches.len() {
            for other in 0..TEAPOT.patches.len() {
                let shared = TEAPOT.patches[patch]
                    .iter()
                    .filter(|p| TEAPOT.patches[other].contains(p))
                    .count();
                let one_shell = Teapot::shell(patch) == Teapot::shell(other);
                // Handle and body touch in one listed point; the lid's knob has a pole of four equal entries.
                assert!(
                    one_shell || shared <= 1,
                    "patches {patch} and {other} share {shared} points"
                );
            }
        }
    }
}
