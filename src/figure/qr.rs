//! A text as a QR code (ISO/IEC 18004): dark and light modules, and a drawing of them.

use super::drawing::{Drawing, Shape};
use super::palette::Rgb8;
use fast_qr::{ECL, QRBuilder};
use glam::DVec2;

/// The square of modules that encodes a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct QrCode {
    /// Number of modules on a side, without the quiet zone.
    side: usize,
    dark: Vec<bool>,
}

impl QrCode {
    /// Width in modules of the light quiet zone that readers need round the code.
    pub const QUIET: usize = 4;

    const BLACK: Rgb8 = [0; 3];
    const WHITE: Rgb8 = [255; 3];

    /// Creates the smallest code of a text, with the best error correction of that size; none for more than 2953 bytes.
    pub fn new(text: &str) -> Option<Self> {
        let code = |level| QRBuilder::new(text).ecl(level).build().ok();
        let smallest = code(ECL::L)?;
        let mut better = [ECL::H, ECL::Q, ECL::M].into_iter().filter_map(code);
        let code = better.find(|code| code.size == smallest.size);
        let code = code.unwrap_or(smallest);
        let modules = code.data.iter().take(code.size * code.size);
        Some(Self {
            side: code.size,
            dark: modules.map(|module| module.value()).collect(),
        })
    }

    /// Returns the number of modules on a side, quiet zone included.
    pub fn side(&self) -> usize {
        self.side + 2 * Self::QUIET
    }

    /// Returns the runs of dark modules: the column and the row of the first, quiet zone included, and their number.
    pub fn runs(&self) -> Vec<[usize; 3]> {
        let mut runs: Vec<[usize; 3]> = Vec::new();
        for (row, modules) in self.dark.chunks(self.side).enumerate() {
            for (column, _) in modules.iter().enumerate().filter(|(_, dark)| **dark) {
                let place = [column + Self::QUIET, row + Self::QUIET];
                match runs.last_mut() {
                    Some([x, y, count]) if [*x + *count, *y] == place => *count += 1,
                    _ => runs.push([place[0], place[1], 1]),
                }
            }
        }
        runs
    }

    /// Draws black on white with the quiet zone, each module `module` units wide.
    pub fn drawing(&self, module: f64) -> Drawing {
        let mut drawing = Drawing::new(DVec2::splat(self.side() as f64 * module), Self::WHITE);
        let area = |[x, y, count]: [usize; 3]| {
            let corner = |x: usize, y: usize| DVec2::new(x as f64, y as f64) * module;
            let right = x + count;
            let corners = [
                corner(x, y),
                corner(right, y),
                corner(right, y + 1),
                corner(x, y + 1),
            ];
            Shape::area(corners.to_vec(), Self::BLACK).plain()
        };
        drawing.shapes = self.runs().into_iter().map(area).collect();
        drawing
    }
}
