//! The cases of the stability catalogue as a sheet: what the textbook, the engine and the reference make of each.

use crate::analysis::{CASE_PICTURES, CaseResult, HALF_A_CODE_VALUE};
use crate::figure::{Drawing, Text};
use crate::render::Frame;
use glam::DVec2;

/// Pixels of the sheet to one of a picture.
const SCALE: u32 = 2;
/// Pixels between pictures, and about cases.
const GAP: u32 = 10;
const MARGIN: u32 = 24;
/// Letters: pixels an em.
const EM: f64 = 21.0;
/// Heights of the title above a case and of the words below it, pixels.
const HEAD: u32 = 38;
const FOOT: u32 = 32;
const GROUND: [u8; 4] = [0x1C, 0x1D, 0x21, 255];
const WORDS: [u8; 3] = [0xF2; 3];
const WEAK: [u8; 3] = [0xA8, 0xAA, 0xB0];
const WRONG: [u8; 3] = [0xFF, 0x8A, 0x5C];

/// The cases two to a row, one alone by itself; nothing of nothing, or where the sheet has no room.
pub fn stability_sheet(results: &[CaseResult]) -> Option<Frame> {
    let side = results.first()?.pictures[0].width * SCALE;
    let columns = u32::try_from(results.len()).ok()?.min(2);
    let rows = u32::try_from(results.len()).ok()?.div_ceil(columns);
    let cell = [3 * side + 2 * GAP + MARGIN, HEAD + side + FOOT + MARGIN / 2];
    let (width, height) = (columns * cell[0] + MARGIN, rows.checked_mul(cell[1])? + MARGIN);
    let mut sheet = Frame { width, height, pixels: vec![GROUND; width as usize * height as usize] };
    let places: Vec<[u32; 2]> = (0..columns * rows)
        .map(|index| [MARGIN + (index % columns) * cell[0], MARGIN / 2 + (index / columns) * cell[1]])
        .collect();
    for (result, [x, y]) in results.iter().zip(&places) {
        for (picture, step) in result.pictures.iter().zip(0..) {
            enlarge(&mut sheet, picture, [x + step * (side + GAP), y + HEAD]);
        }
    }
    let mut drawing = Drawing::over_picture([GROUND[0], GROUND[1], GROUND[2]], 0.0);
    let mut letter = |text: &str, em: f64, [x, y]: [u32; 2], colour: [u8; 3]| {
        drawing.texts.push(Text::new(text, DVec2::new(x.into(), y.into()), em, colour));
    };
    for (result, [x, y]) in results.iter().zip(&places) {
        letter(result.case.title, EM, [*x, y + HEAD - 12], WORDS);
        for ((words, colour), step) in captions(result).into_iter().zip(0..) {
            letter(&words, 0.86 * EM, [x + step * (side + GAP), y + HEAD + side + 22], colour);
        }
    }
    drawing.draw_over(&mut sheet);
    Some(sheet)
}

/// What stands below the three pictures, and its colour.
fn captions(result: &CaseResult) -> [(String, [u8; 3]); 3] {
    let of = |name: &str, error: f64| {
        let decimals = if error < 10.0 { 2 } else { 0 };
        let colour = if error > HALF_A_CODE_VALUE { WRONG } else { WEAK };
        (format!("{name}: off by {error:.decimals$}"), colour)
    };
    let [textbook, engine, reference] = CASE_PICTURES;
    let lost = result.naive_not_finite;
    let (words, colour) = of(textbook, result.naive_error);
    let naive = if lost > 0 { (format!("{words}, {lost} lost"), WRONG) } else { (words, colour) };
    [naive, of(engine, result.robust_error), (reference.to_owned(), WEAK)]
}

/// Puts a picture on the sheet, each pixel as a square.
fn enlarge(sheet: &mut Frame, picture: &Frame, [left, top]: [u32; 2]) {
    let columns = sheet.width as usize;
    for y in 0..picture.height * SCALE {
        let from = ((y / SCALE) * picture.width) as usize;
        let to = (top + y) as usize * columns + left as usize;
        let line = &mut sheet.pixels[to..to + (picture.width * SCALE) as usize];
        for (pixel, x) in line.iter_mut().zip(0..) {
            *pixel = picture.pixels[from + x / SCALE as usize];
        }
    }
}
