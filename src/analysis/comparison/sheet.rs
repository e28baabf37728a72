//! The panes of a comparison on one sheet: side by side, on either side of a dividing line, or as their difference,
//! with the scale that explains its colours.

use super::{ErrorFigures, LinearPicture, PaneFigures, brightest, error_figures};
use crate::analysis::perception::luminance;
use crate::figure::palette::{Rgb8, Vector, mixed};
use crate::figure::{Area, Drawing, Shape, Text, with_raised_n};
use crate::render::{Frame, Renderer};
use crate::scene::{CompareView, DifferenceKind, Rgb, Scene};
use crate::text;
use glam::DVec2;
use rayon::prelude::*;

/// Gap between two panes in pixels, except on a tiny sheet.
const GAP: u32 = 2;
/// Colour between panes, and where a row has no further pane.
const BETWEEN: [u8; 4] = [0x80, 0x80, 0x80, 255];
const EMPTY: [u8; 4] = [0x26, 0x27, 0x2B, 255];
/// Colour where neither picture shows the object.
const OUTSIDE: Rgb8 = [0x26, 0x27, 0x2B];
/// Colour of no difference, where the scale has two sides.
const NONE: Rgb8 = [0xF4, 0xF4, 0xF2];
/// Ten even steps of cividis, which colour blindness leaves alike (Nuñez, Anderton and Renslow 2018).
const CIVIDIS: [Rgb8; 10] = [
    [0x00, 0x20, 0x4D],
    [0x00, 0x33, 0x6F],
    [0x39, 0x48, 0x6B],
    [0x57, 0x5C, 0x6D],
    [0x70, 0x71, 0x73],
    [0x8A, 0x87, 0x79],
    [0xA6, 0x9D, 0x75],
    [0xC4, 0xB5, 0x6C],
    [0xE4, 0xCF, 0x5B],
    [0xFF, 0xEA, 0x46],
];
/// Number of colours along the drawn scale.
const STEPS: u32 = 128;

/// A rectangle of whole pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PaneArea {
    /// Top left pixel.
    pub min: [u32; 2],
    /// Width and height.
    pub size: [u32; 2],
}

/// Returns the areas of `count` equal panes in a picture of `size`, such that a square object is seen largest, with a
/// penalty for empty space. A last row that is not full is centred.
pub fn pane_areas(count: usize, size: [u32; 2]) -> Vec<PaneArea> {
    let count = u32::try_from(count.max(1)).unwrap_or(1);
    let gap = if size[0].min(size[1]) < 64 { 0 } else { GAP };
    let side = |total: u32, parts: u32| (total.saturating_sub((parts - 1) * gap) / parts).max(1);
    let cell = |columns: u32| {
        [
            side(size[0], columns),
            side(size[1], count.div_ceil(columns)),
        ]
    };
    let worth = |columns: u32| {
        let used = f64::from(count) / f64::from(columns * count.div_ceil(columns));
        let [width, height] = cell(columns).map(f64::from);
        [used * width.min(height), width * height]
    };
    let order = |a: &u32, b: &u32| {
        let ([seen, area], [other, beside]) = (worth(*a), worth(*b));
        seen.total_cmp(&other).then(area.total_cmp(&beside))
    };
    // Of equal ones the fewest columns: a pane that is wider than tall cuts nothing off.
    let columns = (1..=count).rev().max_by(order).unwrap_or(1);
    let [width, height] = cell(columns);
    let place = |index: u32| {
        let row = index / columns;
        let missing = columns - (count - row * columns).min(columns);
        let left = missing * (width + gap) / 2;
        PaneArea {
            min: [
                left + (index % columns) * (width + gap),
                row * (height + gap),
            ],
            size: [width, height],
        }
    };
    (0..count).map(place).collect()
}

/// A pane that has been drawn.
#[derive(Clone, Debug)]
pub struct DrawnPane {
    /// The picture as stored.
    pub frame: Frame,
    /// The picture before the display; empty where nothing is compared.
    pub linear: Vec<[f32; 4]>,
    /// The picture before the display with one sample at each pixel's centre, from which figures are taken. (A mean of several
    /// samples is one of values that the display has clamped.)
    pub measured: Vec<[f32; 4]>,
    /// True if the display clamps at 1; see [`LinearPicture`](super::LinearPicture).
    pub clamps: bool,
    /// Index of the pane.
    pub pane: usize,
    /// Name of the pane.
    pub name: String,
    /// True if the others are measured against it.
    pub reference: bool,
}

impl DrawnPane {
    /// Returns the picture before the display.
    pub fn linear(&self) -> LinearPicture<'_> {
        self.picture(&self.linear)
    }

    /// Returns the picture that figures are taken from.
    pub fn measured(&self) -> LinearPicture<'_> {
        self.picture(&self.measured)
    }

    fn picture<'p>(&self, pixels: &'p [[f32; 4]]) -> LinearPicture<'p> {
        LinearPicture {
            width: self.frame.width,
            pixels,
            clamps: self.clamps,
        }
    }
}

/// Returns the figures for the panes' captions.
pub fn pane_figures(panes: &[DrawnPane]) -> Vec<PaneFigures> {
    let reference = panes.iter().find(|pane| pane.reference).or(panes.last());
    let figures = |pane: &DrawnPane| {
        let others = reference.filter(|reference| !std::ptr::eq(*reference, pane));
        PaneFigures {
            pane: pane.pane,
            name: pane.name.clone(),
            brightest: brightest(pane.measured()),
            error: others.map(|reference| error_figures(pane.measured(), reference.measured())),
        }
    };
    panes.iter().map(figures).collect()
}

/// Formats the brightest value and the error of a pane, beside those of the reference among `all`, if there is one.
pub fn caption(figures: &PaneFigures, all: &[PaneFigures]) -> Vec<String> {
    let mut words = Vec::new();
    if figures.error.is_none() {
        words.push(text!("picture-reference").to_owned());
    }
    let reference = all.iter().find(|one| one.error.is_none());
    if let Some(brightest) = figures.brightest {
        let value = format!("{:.3}", brightest.value);
        let truth = reference
            .and_then(|reference| reference.brightest)
            .filter(|_| figures.error.is_some());
        words.push(match truth {
            Some(truth) => {
                let truth = format!("{:.3}", truth.value);
                text!("picture-brightest-of", value = value, truth = truth)
            }
            None => text!("picture-brightest", value = value),
        });
    }
    if let Some(error) = figures.error {
        words.push(text!(
            "picture-rms-error",
            value = format!("{:.4}", error.rms)
        ));
    }
    words
}

/// Formats the error of a difference picture in one line.
pub fn error_line(error: &ErrorFigures) -> String {
    text!(
        "picture-error-line",
        mean = format!("{:.4}", error.mean),
        rms = format!("{:.4}", error.rms),
        greatest = format!("{:.4}", error.greatest)
    )
}

/// Returns the indices of the panes on a sheet of the scene's size, with the size of each.
pub fn panes_on_sheet(scene: &Scene) -> Vec<(usize, [u32; 2])> {
    let shown = scene.shown_panes();
    let size = match scene.compare.view {
        CompareView::Panes => pane_areas(shown.len(), scene.image.size)
            .first()
            .map(|area| area.size),
        _ => None,
    };
    shown
        .into_iter()
        .map(|index| (index, size.unwrap_or(scene.image.size)))
        .collect()
}

/// Draws panes of a valid scene, given by their indices with the size of each; `over` may draw over each, with the
/// renderer that drew it and its scene, and its errors are returned. `progress` receives the number of samples drawn so
/// far in all panes and returns whether to continue.
pub fn draw_panes<E>(
    renderer: &mut Renderer,
    scene: &Scene,
    which: &[(usize, [u32; 2])],
    samples: u32,
    progress: &mut dyn FnMut(u32) -> bool,
    mut over: impl FnMut(&mut Frame, &mut Renderer, &Scene) -> Result<(), E>,
) -> Result<Vec<DrawnPane>, E> {
    let mut panes = Vec::new();
    for (&(index, size), done) in which.iter().zip(0..) {
        let mut shown = scene.pane(index).unwrap_or_else(|_| scene.clone());
        shown.image.size = size;
        // A drawing over a pane may have changed this; a single picture is not compared.
        let compared = scene.compare.view != CompareView::Single || which.len() > 1;
        renderer.keep_linear(compared);
        let centres = (compared && samples > 1).then(|| renderer.linear_picture(&shown));
        let mut frame =
            renderer.render_supersampled(&shown, samples, &mut |n| progress(done * samples + n));
        let linear = renderer.linear().to_vec();
        let measured = centres.unwrap_or_else(|| linear.clone());
        over(&mut frame, renderer, &shown)?;
        panes.push(DrawnPane {
            frame,
            linear,
            measured,
            clamps: shown.clamps(),
            pane: index,
            name: scene.pane_name(index),
            reference: index == scene.reference_pane(),
        });
    }
    renderer.keep_linear(false);
    Ok(panes)
}

/// The captions of the panes on a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Captions {
    /// No captions.
    None,
    /// The names alone.
    Names,
    /// The names with the figures.
    Figures,
}

/// Places panes drawn by [`draw_panes`] on one sheet.
pub fn comparison_sheet(scene: &Scene, panes: &[DrawnPane], captions: Captions) -> Frame {
    let (Some(first), Some(last)) = (panes.first(), panes.last()) else {
        return Frame::default();
    };
    let (compare, areas) = (&scene.compare, pane_areas(panes.len(), scene.image.size));
    let mut sheet = match compare.view {
        CompareView::Single => return first.frame.clone(),
        CompareView::Panes => side_by_side(scene.image.size, panes, &areas),
        CompareView::Wipe => wiped(&first.frame, &last.frame, compare.wipe),
        CompareView::Difference => difference_picture(
            first.linear(),
            last.linear(),
            compare.difference,
            compare.gain,
        ),
    };
    let [width, height] = scene.image.size.map(f64::from);
    let size = 0.032 * width.min(height);
    let mut em = size.clamp(11.0, 60.0);
    let mut drawing = Drawing::over_picture([0x10; 3], (0.1 * size).max(1.2));
    if compare.view == CompareView::Wipe {
        let ends = [0.0, height]
            .map(|y| DVec2::new(compare.wipe * width, y))
            .to_vec();
        drawing.shapes.push(Shape::line(ends, 0.1 * em, [255; 3]));
    }
    let mut letter = |text: &str, em: f64, at: DVec2, align: f64| {
        let text = Text::new(with_raised_n(text), at, em, [255; 3]).aligned(align);
        drawing.texts.push(text.haloed(drawing.breadth));
    };
    match compare.view {
        _ if captions == Captions::None => {}
        CompareView::Single => {}
        CompareView::Panes => {
            // Smaller in small panes: a caption is about half a pane wide.
            em = areas
                .first()
                .map_or(em, |area| em.min(0.05 * f64::from(area.size[0])).max(9.0));
            let figures = pane_figures(panes);
            for (pane, area) in figures.iter().zip(&areas) {
                let corner = DVec2::from_array(area.min.map(f64::from));
                letter(&pane.name, em, corner + DVec2::new(0.8, 1.4) * em, 0.0);
                if captions == Captions::Figures {
                    let below = DVec2::new(0.8 * em, f64::from(area.size[1]) - 0.8 * em);
                    let measured = caption(pane, &figures).join("   ");
                    letter(&measured, 0.9 * em, corner + below, 0.0);
                }
            }
        }
        CompareView::Wipe => {
            letter(&first.name, em, DVec2::new(em, 1.5 * em), 0.0);
            letter(&last.name, em, DVec2::new(width - em, 1.5 * em), 1.0);
        }
        CompareView::Difference => {
            let names = format!("{} − {}", first.name, last.name);
            letter(&names, em, DVec2::new(em, 1.5 * em), 0.0);
            if captions == Captions::Figures {
                let words = error_line(&error_figures(first.measured(), last.measured()));
                letter(&words, em, DVec2::new(em, 3.0 * em), 0.0);
            }
        }
    }
    drawing.draw_over(&mut sheet);
    if captions != Captions::None && compare.view == CompareView::Difference {
        let size = [sheet.width, sheet.height];
        difference_scale(size, compare.difference, compare.gain, em).draw_over(&mut sheet);
    }
    sheet
}

/// Combines the left of one picture with the right of another of the same size.
fn wiped(left: &Frame, right: &Frame, wipe: f64) -> Frame {
    let mut sheet = left.clone();
    let width = left.width.max(1) as usize;
    let line = ((wipe * f64::from(left.width)).round() as usize).min(width);
    for (row, other) in sheet
        .pixels
        .chunks_mut(width)
        .zip(right.pixels.chunks(width))
    {
        row[line..].copy_from_slice(&other[line..]);
    }
    sheet
}

/// Draws panes with borders as wide as the gaps.
fn side_by_side([width, height]: [u32; 2], panes: &[DrawnPane], areas: &[PaneArea]) -> Frame {
    let mut sheet = Frame {
        width,
        height,
        pixels: vec![EMPTY; width as usize * height as usize],
    };
    let width = width as usize;
    for area in areas {
        let [x0, y0] = area.min.map(|v| v.saturating_sub(GAP) as usize);
        let [x1, y1] = [0, 1].map(|axis| (area.min[axis] + area.size[axis] + GAP) as usize);
        for row in sheet.pixels.chunks_mut(width.max(1)).take(y1).skip(y0) {
            row[x0.min(width)..x1.min(width)].fill(BETWEEN);
        }
    }
    for (pane, area) in panes.iter().zip(areas) {
        let columns = pane.frame.width.max(1) as usize;
        for (row, pixels) in pane.frame.pixels.chunks(columns).enumerate() {
            let from = (area.min[1] as usize + row) * width + area.min[0] as usize;
            // A sheet of fewer pixels than panes cannot hold all of them.
            if let Some(place) = sheet.pixels.get_mut(from..from + columns) {
                place.copy_from_slice(pixels);
            }
        }
    }
    sheet
}

/// Computes `picture` less `reference`, times `gain`, in the colours of `kind`. Both are linear and of the same size.
pub fn difference_picture(
    picture: LinearPicture<'_>,
    reference: LinearPicture<'_>,
    kind: DifferenceKind,
    gain: f64,
) -> Frame {
    let width = picture.width.max(1);
    let seen = |index: usize| picture.pixels[index][3] > 0.0 || reference.pixels[index][3] > 0.0;
    let pixel = |index: usize| {
        let [r, g, b] = if seen(index) {
            let (a, b) = (picture.color(index), reference.color(index));
            colour(
                kind,
                std::array::from_fn(|channel| gain * (a[channel] - b[channel])),
            )
        } else {
            OUTSIDE
        };
        [r, g, b, 255]
    };
    let count = picture.pixels.len().min(reference.pixels.len());
    let pixels: Vec<[u8; 4]> = (0..count).into_par_iter().map(pixel).collect();
    Frame {
        width,
        height: (count as u64 / u64::from(width)) as u32,
        pixels,
    }
}

fn colour(kind: DifferenceKind, difference: [f64; 3]) -> Rgb8 {
    match kind {
        DifferenceKind::Signed => signed(luminance(Rgb::from_array(difference))),
        DifferenceKind::Absolute => difference.map(|channel| code(255.0 * channel.abs())),
        DifferenceKind::FalseColor => cividis(
            difference
                .iter()
                .fold(0.0, |most, channel| channel.abs().max(most)),
        ),
    }
}

/// Returns a colour from blue at −1 to orange at 1.
fn signed(share: f64) -> Rgb8 {
    let end = if share < 0.0 {
        Vector::N.colour()
    } else {
        Vector::L.colour()
    };
    mixed(NONE, end, share.abs().clamp(0.0, 1.0))
}

/// Returns a colour of the scale for a share from 0 to 1.
fn cividis(share: f64) -> Rgb8 {
    let steps = (CIVIDIS.len() - 1) as f64;
    let place = (share.clamp(0.0, 1.0) * steps).min(steps - 1e-9);
    let index = place as usize;
    mixed(CIVIDIS[index], CIVIDIS[index + 1], place - index as f64)
}

/// Rounds a value to a code value.
fn code(value: f64) -> u8 {
    value.round().clamp(0.0, 255.0) as u8
}

/// Draws the scale of a difference picture at its lower right, with letters of `em` pixels; nothing where it does not
/// fit.
pub fn difference_scale(size: [u32; 2], kind: DifferenceKind, gain: f64, em: f64) -> Drawing {
    let size = DVec2::from_array(size.map(f64::from));
    let mut drawing = Drawing::over_picture([0x10; 3], 0.12 * em);
    let (length, breadth) = ((14.0 * em).min(0.6 * size.x), 0.8 * em);
    let corner = size - DVec2::new(length + 2.6 * em, breadth + 2.2 * em);
    if corner.min_element() < 0.0 || length < 8.0 * em {
        return drawing;
    }
    let two_sided = kind == DifferenceKind::Signed;
    let step = length / f64::from(STEPS);
    let bar = (0..STEPS).map(|i| {
        let share = (f64::from(i) + 0.5) / f64::from(STEPS);
        let value = if two_sided { 2.0 * share - 1.0 } else { share };
        let right = corner.x + f64::from(i + 1) * step + 0.5;
        let part = Area {
            min: DVec2::new(corner.x + f64::from(i) * step, corner.y),
            max: DVec2::new(right.min(corner.x + length), corner.y + breadth),
        };
        Shape::area(part.corners(), colour(kind, [value; 3])).plain()
    });
    drawing.shapes.extend(bar);
    let whole = Area {
        min: corner,
        max: corner + DVec2::new(length, breadth),
    };
    drawing
        .shapes
        .push(Shape::outline(whole.corners(), 0.08 * em, [255; 3]));
    let least = if two_sided { -1.0 } else { 0.0 };
    for value in [least, 0.5 * (least + 1.0), 1.0] {
        let x = corner.x + length * (value - least) / (1.0 - least);
        let at = DVec2::new(x, corner.y + breadth + 1.1 * em);
        let text = Text::new(tick(value / gain, two_sided), at, em, [255; 3]).aligned(0.5);
        drawing.texts.push(text.haloed(drawing.breadth));
    }
    drawing
}

/// Formats a number of the scale with at most four decimals.
fn tick(value: f64, signed: bool) -> String {
    let digits = format!("{:.4}", value.abs());
    let digits = digits.trim_end_matches('0').trim_end_matches('.');
    match (signed, value) {
        (true, v) if v > 0.0 => format!("+{digits}"),
        (true, v) if v < 0.0 => format!("−{digits}"),
        _ => digits.to_owned(),
    }
}
