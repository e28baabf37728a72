//! The panes of a comparison on one sheet: side by side, on either side of a line, or their difference.

use super::difference::{difference_picture, difference_scale};
use crate::analysis::{LinearPicture, PaneFigures, brightest, error_figures};
use crate::figure::{Drawing, Shape, Text};
use crate::render::{Frame, Renderer};
use crate::scene::{CompareView, Scene};
use glam::DVec2;

/// Pixels between two panes of a sheet that is not a tiny one.
const GAP: u32 = 2;
/// Panes that are narrower than this share of their height cut objects off at the sides: what is seen is as high as the pane.
const NARROWEST: f64 = 0.85;
/// What is seen between panes, and where a row has no further pane.
const BETWEEN: [u8; 4] = [0x80, 0x80, 0x80, 255];
const EMPTY: [u8; 4] = [0x26, 0x27, 0x2B, 255];

/// A rectangle of whole pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PaneArea {
    /// Top left pixel.
    pub min: [u32; 2],
    pub size: [u32; 2],
}

/// Where `count` panes stand in a picture of `size`: as large as can be without cutting objects off at the sides, all of
/// one size.
pub fn pane_areas(count: usize, size: [u32; 2]) -> Vec<PaneArea> {
    let count = u32::try_from(count.max(1)).unwrap_or(1);
    let gap = if size[0].min(size[1]) < 64 { 0 } else { GAP };
    let side = |total: u32, parts: u32| (total.saturating_sub((parts - 1) * gap) / parts).max(1);
    let cell = |columns: u32| [side(size[0], columns), side(size[1], count.div_ceil(columns))];
    let narrowest = NARROWEST.min(f64::from(size[0]) / f64::from(size[1].max(1)));
    let worth = |columns: u32| {
        let [width, height] = cell(columns).map(f64::from);
        [height.min(width / narrowest), width * height]
            .map(|v| if width < 0.99 * narrowest * height { 0.5 * v } else { v })
    };
    let order = |a: &u32, b: &u32| {
        let ([seen, area], [other, beside]) = (worth(*a), worth(*b));
        seen.total_cmp(&other).then(area.total_cmp(&beside))
    };
    let columns = (1..=count).max_by(order).unwrap_or(1);
    let [width, height] = cell(columns);
    let place = |index: u32| {
        let min = [(index % columns) * (width + gap), (index / columns) * (height + gap)];
        PaneArea { min, size: [width, height] }
    };
    (0..count).map(place).collect()
}

/// A pane as drawn.
#[derive(Clone, Debug)]
pub struct DrawnPane {
    pub frame: Frame,
    /// Before the display; empty where nothing is compared.
    pub linear: Vec<[f32; 4]>,
    pub clamps: bool,
    pub name: String,
}

impl DrawnPane {
    /// What was measured of it and of its difference from `reference`.
    pub fn linear(&self) -> LinearPicture<'_> {
        LinearPicture { width: self.frame.width, pixels: &self.linear, clamps: self.clamps }
    }
}

/// What captions say of panes; the last one is the reference.
pub fn pane_figures(panes: &[DrawnPane]) -> Vec<PaneFigures> {
    let Some((last, others)) = panes.split_last() else { return vec![] };
    let figures =
        |pane: &DrawnPane, error| PaneFigures { name: pane.name.clone(), brightest: brightest(pane.linear()), error };
    let compared = others.iter().map(|pane| figures(pane, Some(error_figures(pane.linear(), last.linear()))));
    compared.chain([figures(last, None)]).collect()
}

/// The lines of a pane's caption: its name, and its brightest value and error beside those of the `reference`.
pub fn caption(figures: &PaneFigures, reference: Option<&PaneFigures>) -> [String; 2] {
    let mut words = Vec::new();
    if let Some(brightest) = figures.brightest {
        let truth = reference.and_then(|reference| reference.brightest).filter(|_| figures.error.is_some());
        let of = truth.map_or_else(String::new, |truth| format!(" of {:.3}", truth.value));
        words.push(format!("brightest {:.3}{of}", brightest.value));
    }
    if let Some(error) = figures.error {
        words.push(format!("RMS error {:.4}", error.rms));
    }
    [figures.name.clone(), words.join("   ")]
}

/// The panes that stand on a sheet of the scene's size, by their numbers, and the size of each.
pub fn panes_on_sheet(scene: &Scene) -> Vec<(usize, [u32; 2])> {
    let shown = scene.shown_panes();
    let size = match scene.compare.view {
        CompareView::Panes => pane_areas(shown.len(), scene.image.size).first().map(|area| area.size),
        _ => None,
    };
    shown.into_iter().map(|index| (index, size.unwrap_or(scene.image.size))).collect()
}

/// Draws panes of a sound scene, given by their numbers with the size of each; `over` may draw over each, with the renderer
/// that drew it and its scene. `progress` gets the number of samples done in all panes and returns whether to go on.
///
/// # Errors
/// Whatever `over` objects to.
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
        // What is drawn over a pane may have asked for something else; one picture is compared with nothing.
        renderer.keep_linear(scene.compare.view != CompareView::Single || which.len() > 1);
        let mut frame = renderer.render_supersampled(&shown, samples, &mut |n| progress(done * samples + n));
        let linear = renderer.linear().to_vec();
        over(&mut frame, renderer, &shown)?;
        panes.push(DrawnPane { frame, linear, clamps: shown.clamps(), name: scene.pane_name(index) });
    }
    renderer.keep_linear(false);
    Ok(panes)
}

/// Puts panes, as [`draw_panes`] drew them, on one sheet. With `captions` each is named.
pub fn comparison_sheet(scene: &Scene, panes: &[DrawnPane], captions: bool) -> Frame {
    let [width, height] = scene.image.size;
    let em = (0.032 * f64::from(width.min(height))).clamp(11.0, 60.0);
    let (Some(first), Some(last)) = (panes.first(), panes.last()) else { return Frame::default() };
    let compare = &scene.compare;
    match compare.view {
        CompareView::Single => first.frame.clone(),
        CompareView::Panes => side_by_side([width, height], panes, captions.then_some(em)),
        CompareView::Wipe => {
            let mut sheet = wiped(&first.frame, &last.frame, compare.wipe);
            let line = compare.wipe * f64::from(width);
            let mut drawing = caption_drawing(&sheet);
            let ends = [0.0, f64::from(height)].map(|y| DVec2::new(line, y)).to_vec();
            drawing.shapes.push(Shape::line(ends, 0.1 * em, [255; 3]));
            if captions {
                letter(&mut drawing, &first.name, em, DVec2::new(em, 1.5 * em), 0.0);
                letter(&mut drawing, &last.name, em, DVec2::new(f64::from(width) - em, 1.5 * em), 1.0);
            }
            drawing.draw_over(&mut sheet);
            sheet
        }
        CompareView::Difference => {
            let mut sheet = difference_picture(first.linear(), last.linear(), compare.difference, compare.gain);
            if captions {
                let name = format!("{} − {}", first.name, last.name);
                let error = error_figures(first.linear(), last.linear());
                let words = format!("mean {:.4}   RMS {:.4}   greatest {:.4}", error.mean, error.rms, error.greatest);
                let mut drawing = caption_drawing(&sheet);
                letter(&mut drawing, &name, em, DVec2::new(em, 1.5 * em), 0.0);
                letter(&mut drawing, &words, em, DVec2::new(em, 3.0 * em), 0.0);
                drawing.draw_over(&mut sheet);
                let size = [sheet.width, sheet.height];
                difference_scale(size, compare.difference, compare.gain, em).draw_over(&mut sheet);
            }
            sheet
        }
    }
}

/// The left of one picture and the right of another, which is as large.
fn wiped(left: &Frame, right: &Frame, wipe: f64) -> Frame {
    let mut sheet = left.clone();
    let line = (wipe * f64::from(left.width)).round() as usize;
    let width = left.width.max(1) as usize;
    for (row, other) in sheet.pixels.chunks_mut(width).zip(right.pixels.chunks(width)) {
        row[line.min(width)..].copy_from_slice(&other[line.min(width)..]);
    }
    sheet
}

fn side_by_side(size: [u32; 2], panes: &[DrawnPane], em: Option<f64>) -> Frame {
    let [width, height] = size;
    let mut sheet = Frame { width, height, pixels: vec![EMPTY; width as usize * height as usize] };
    let areas = pane_areas(panes.len(), size);
    for area in &areas {
        separate(&mut sheet, *area);
    }
    for (pane, area) in panes.iter().zip(&areas) {
        let columns = pane.frame.width.max(1) as usize;
        for (row, pixels) in pane.frame.pixels.chunks(columns).enumerate() {
            let from = (area.min[1] as usize + row) * width as usize + area.min[0] as usize;
            // A sheet of fewer pixels than panes has not room for all.
            if let Some(place) = sheet.pixels.get_mut(from..from + columns) {
                place.copy_from_slice(pixels);
            }
        }
    }
    let Some(em) = em else { return sheet };
    // Smaller in small panes: a caption is about half a pane wide.
    let em = areas.first().map_or(em, |area| em.min(0.05 * f64::from(area.size[0])).max(9.0));
    let mut drawing = caption_drawing(&sheet);
    let figures = pane_figures(panes);
    for (pane, area) in figures.iter().zip(&areas) {
        let corner = DVec2::from_array(area.min.map(f64::from));
        let [name, measured] = caption(pane, figures.last());
        letter(&mut drawing, &name, em, corner + DVec2::new(0.8 * em, 1.4 * em), 0.0);
        let below = corner + DVec2::new(0.8 * em, f64::from(area.size[1]) - 0.8 * em);
        letter(&mut drawing, &measured, 0.9 * em, below, 0.0);
    }
    drawing.draw_over(&mut sheet);
    sheet
}

/// Lines about a pane, as wide as the gaps.
fn separate(sheet: &mut Frame, area: PaneArea) {
    let width = sheet.width as usize;
    let [x0, y0] = area.min.map(|v| v.saturating_sub(GAP) as usize);
    let [x1, y1] = [0, 1].map(|axis| (area.min[axis] + area.size[axis] + GAP) as usize);
    for row in sheet.pixels.chunks_mut(width.max(1)).take(y1).skip(y0) {
        row[x0.min(width)..x1.min(width)].fill(BETWEEN);
    }
}

/// A drawing for the captions over `frame`.
fn caption_drawing(frame: &Frame) -> Drawing {
    let em = 0.032 * f64::from(frame.width.min(frame.height));
    Drawing::over_picture([0x10; 3], (0.1 * em).max(1.2))
}

fn letter(drawing: &mut Drawing, text: &str, em: f64, at: DVec2, align: f64) {
    let text = Text::new(text, at, em, [255; 3]).aligned(align);
    drawing.texts.push(Text { halo: drawing.breadth, ..text });
}
