//! The catalogue of cases: how it is asked for, and what it says.

use super::{CASE_PICTURES, CaseResult, HALF_A_CODE_VALUE, Verdict, stability, stability_cases};
use crate::analysis::report::{
    About, Answer, Column, Figure, Part, Report, Section, Table, as_it_is, fixed,
};
use crate::analysis::{Question, Subject, Watch};
use crate::figure::{Drawing, Paper, Text};
use crate::render::Frame;
use crate::scene::Choice;
use glam::DVec2;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::sync::Arc;

/// The stiff and extreme cases.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct StabilityQuestion {
    /// Only these, by name; all where there is none.
    pub cases: Vec<String>,
}

/// What became of the cases.
#[derive(Clone, Debug, Default)]
pub struct Catalogue {
    pub results: Vec<Arc<CaseResult>>,
}

impl Question for StabilityQuestion {
    type Answer = Catalogue;

    fn answer(&self, subject: &Subject, watch: &dyn Watch<Catalogue>) -> Result<Catalogue, String> {
        let wanted =
            |name: &str| self.cases.is_empty() || self.cases.iter().any(|case| case == name);
        let cases: Vec<_> = stability_cases().filter(|case| wanted(case.name)).collect();
        let (mut renderer, mut found) = (subject.renderer(), Catalogue::default());
        for case in &cases {
            found.results.push(Arc::new(stability(&mut renderer, case)));
            watch.found(&found);
            if !watch.at(found.results.len() as f32 / cases.len() as f32) {
                break;
            }
        }
        Ok(found)
    }
}

impl CaseResult {
    /// What is said of the case.
    pub fn describe(&self, section: &mut Section) {
        let lost = self.naive_not_finite;
        if lost > 0 {
            let pixels = if lost == 1 {
                "1 pixel is"
            } else {
                &format!("{lost} pixels are")
            };
            section.note(format!("{pixels} infinite or no number, in magenta."));
        }
        section.line(format!("The textbook: {}", self.case.wrong));
        section.line(format!("This engine: {}", self.case.robust));
        if let Some(condition) = self.case.condition {
            section.note(format!("Condition number {condition}."));
        }
    }
}

impl Answer for Catalogue {
    fn report(&self, _: &About<'_>) -> Report {
        let mut report =
            Report::new("Greatest errors in code values against a reference of 106 bits");
        let condition = |value: f64| format!("{value:.1e}");
        let table = Table::of(
            &self.results,
            [
                (Column::both("name", "case", as_it_is), |result| {
                    result.case.name.into()
                }),
                (Column::key("topic"), |result| {
                    result.case.topic.label().into()
                }),
                (
                    Column::both("condition", "condition", condition),
                    |result| result.case.condition.map(|c| c.value).into(),
                ),
                (
                    Column::both("naive_error", "textbook", fixed::<3>),
                    |result| result.naive_error.into(),
                ),
                (
                    Column::both("robust_error", "this engine", fixed::<4>),
                    |result| result.robust_error.into(),
                ),
                (Column::both("verdict", "verdict", as_it_is), |result| {
                    result.verdict.label().into()
                }),
                (Column::key("pixels"), |result| result.pixels.into()),
                (
                    Column::both("naive_off", "pixels off", as_it_is),
                    |result| result.naive_off.into(),
                ),
                (
                    Column::both("naive_not_finite", "not finite", as_it_is),
                    |result| result.naive_not_finite.into(),
                ),
            ],
        );
        report.section("").push(Part::Table(table));
        if let [result] = &self.results[..] {
            result.describe(report.section(result.case.title));
        }
        let failed = self
            .results
            .iter()
            .filter(|result| result.verdict == Verdict::Fails)
            .count();
        report.failure =
            (failed > 0).then(|| format!("{failed} of {} cases fail", self.results.len()));
        report
    }

    /// Each case as the textbook, the engine and the reference draw it.
    fn figure(&self, _: &About<'_>, _: Option<[u32; 2]>, _: Paper) -> Option<Figure> {
        let results: Vec<CaseResult> = self
            .results
            .iter()
            .map(|result| CaseResult::clone(result))
            .collect();
        let scene = if let [one] = &results[..] {
            one.scene.clone().map(Box::new)
        } else {
            None
        };
        Some(Figure::Picture {
            frame: stability_sheet(&results)?,
            scene,
        })
    }

    fn json(&self, _: &About<'_>) -> Value {
        json!({ "cases": self.results.iter().map(|result| json!(**result)).collect::<Vec<_>>() })
    }
}

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
    let (width, height) = (
        columns * cell[0] + MARGIN,
        rows.checked_mul(cell[1])? + MARGIN,
    );
    let mut sheet = Frame {
        width,
        height,
        pixels: vec![GROUND; width as usize * height as usize],
    };
    let places: Vec<[u32; 2]> = (0..columns * rows)
        .map(|index| {
            [
                MARGIN + (index % columns) * cell[0],
                MARGIN / 2 + (index / columns) * cell[1],
            ]
        })
        .collect();
    for (result, [x, y]) in results.iter().zip(&places) {
        for (picture, step) in result.pictures.iter().zip(0..) {
            enlarge(&mut sheet, picture, [x + step * (side + GAP), y + HEAD]);
        }
    }
    let mut drawing = Drawing::over_picture([GROUND[0], GROUND[1], GROUND[2]], 0.0);
    let mut letter = |text: &str, em: f64, [x, y]: [u32; 2], colour: [u8; 3]| {
        drawing
            .texts
            .push(Text::new(text, DVec2::new(x.into(), y.into()), em, colour));
    };
    for (result, [x, y]) in results.iter().zip(&places) {
        letter(result.case.title, EM, [*x, y + HEAD - 12], WORDS);
        for ((words, colour), step) in captions(result).into_iter().zip(0..) {
            letter(
                &words,
                0.86 * EM,
                [x + step * (side + GAP), y + HEAD + side + 22],
                colour,
            );
        }
    }
    drawing.draw_over(&mut sheet);
    Some(sheet)
}

/// What stands below the three pictures, and its colour.
fn captions(result: &CaseResult) -> [(String, [u8; 3]); 3] {
    let of = |name: &str, error: f64| {
        let decimals = if error < 10.0 { 2 } else { 0 };
        let colour = if error > HALF_A_CODE_VALUE {
            WRONG
        } else {
            WEAK
        };
        (format!("{name}: off by {error:.decimals$}"), colour)
    };
    let [textbook, engine, reference] = CASE_PICTURES;
    let lost = result.naive_not_finite;
    let (words, colour) = of(textbook, result.naive_error);
    let naive = if lost > 0 {
        (format!("{words}, {lost} lost"), WRONG)
    } else {
        (words, colour)
    };
    [
        naive,
        of(engine, result.robust_error),
        (reference.to_owned(), WEAK),
    ]
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
