//! The paper of a plot: its greys, the colours of curves on it, and their dashes.

use super::data::{Dash, Ink};
use crate::figure::palette::{Rgb8, Vector, readable, shading};
use glam::DVec2;

/// Minimum contrast of lines (1.4.11) and of text (1.4.3) by WCAG 2.2.
const CONTRAST: [f64; 2] = [3.0, 4.5];

/// Red, green and blue of different lightness, before they are adapted to the paper.
const CHANNELS: [Rgb8; 3] = [[0xD4, 0x2A, 0x2A], [0x12, 0x8A, 0x3E], [0x3A, 0x5F, 0xE0]];

/// Colours of the historic shading methods: two more of that palette, and a violet.
const HISTORIC: [Rgb8; 3] = [[0x7A, 0x4F, 0xB5], [0xE6, 0x9F, 0x00], [0x56, 0xB4, 0xE9]];

/// The greys of a plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Paper {
    /// Background of the plot.
    pub ground: Rgb8,
    /// Titles and emphasised texts.
    pub text: Rgb8,
    /// Explanations: axes, notes, marks.
    pub weak: Rgb8,
    /// Lines of the grid.
    pub grid: Rgb8,
}

impl Paper {
    /// Dark on white, for paper and bright rooms.
    pub const LIGHT: Self = Self {
        ground: [255; 3],
        text: [24, 26, 30],
        weak: [92, 98, 108],
        grid: [224, 227, 232],
    };
    /// Light on nearly black, for dark rooms.
    pub const DARK: Self = Self {
        ground: [20, 22, 26],
        text: [240, 242, 246],
        weak: [160, 167, 178],
        grid: [50, 54, 62],
    };

    /// Returns the colour of a line.
    pub fn line(&self, ink: Ink) -> Rgb8 {
        readable(self.colour(ink), self.ground, CONTRAST[0])
    }

    /// Returns the colour of letters.
    pub fn letters(&self, ink: Ink) -> Rgb8 {
        readable(self.colour(ink), self.ground, CONTRAST[1])
    }

    fn colour(&self, ink: Ink) -> Rgb8 {
        match ink {
            Ink::N => Vector::N.colour(),
            Ink::L => Vector::L.colour(),
            Ink::R => Vector::R.colour(),
            Ink::V => Vector::V.colour(),
            Ink::H => Vector::H.colour(),
            Ink::Channel(channel) => CHANNELS[usize::from(channel.min(2))],
            Ink::Shading(mode) => shading(mode),
            Ink::Historic(which) => HISTORIC[usize::from(which.min(2))],
            Ink::Perceived => self.text,
            Ink::Reference => self.weak,
        }
    }
}

/// Appearance of plots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlotStyle {
    /// The greys.
    pub paper: Paper,
    /// Size of the letters, in units of the drawing an em. All other sizes follow from it.
    pub text: f64,
    /// True if the plot has its title and a margin; one under its own heading needs neither.
    pub titled: bool,
}

impl PlotStyle {
    /// Returns the style of a sheet of `size` with `plots` plots that fills a screen or a page.
    pub fn of(size: [u32; 2], plots: usize, paper: Paper) -> Self {
        let cell = DVec2::from_array(size.map(f64::from)) / grid(plots, size[0] > size[1]);
        let text = (cell.x / 38.0).min(cell.y / 27.0).max(7.0);
        Self {
            paper,
            text,
            titled: true,
        }
    }
}

/// Returns the lengths of alternating dashes and gaps, in widths of the line.
pub fn dashes(dash: Dash) -> &'static [f32] {
    match dash {
        Dash::Solid => &[],
        Dash::Long => &[9.0, 3.0],
        Dash::Dashed => &[4.5, 2.5],
        Dash::DashDot => &[5.5, 2.0, 1.3, 2.0],
        Dash::Dotted => &[1.3, 1.7],
    }
}

/// Returns the columns and rows of a sheet with `plots` plots: two side by side from three on, or where it is wide.
pub fn grid(plots: usize, wide: bool) -> DVec2 {
    match plots {
        0 | 1 => DVec2::ONE,
        2 if wide => DVec2::new(2.0, 1.0),
        2 => DVec2::new(1.0, 2.0),
        _ => DVec2::new(2.0, plots.div_ceil(2) as f64),
    }
}
