//! The question for the catalogue of cases, and its report.

use super::{
    CaseResult, HALF_A_CODE_VALUE, LawStability, Verdict, case_pictures, law_stability, stability,
    stability_cases,
};
use crate::analysis::codec::Codec;
use crate::analysis::report::{
    Answer, Column, Figure, Part, Report, ReportContext, Section, Table, as_it_is, table_of,
};
use crate::analysis::{Question, Subject, Watch};
use crate::figure::{Drawing, Paper, Text, magnitude};
use crate::render::Frame;
use crate::scene::Choice;
use crate::text::text;
use glam::DVec2;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Value, json};
use std::sync::Arc;

/// The question for the stiff and extreme cases, or for the scene's own law.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct StabilityQuestion {
    /// Names of the cases to run; empty for all.
    pub cases: Vec<String>,
    /// True to examine the scene's own law in place of the cases.
    pub law: bool,
}

/// The results of the cases, or of the examination of the scene's own law.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Catalogue {
    /// The stability of the scene's own law, if that was the question.
    pub law: Option<LawStability>,
    /// One result for each case that has been run, in the catalogue's order.
    #[serde(serialize_with = "each", deserialize_with = "shared")]
    pub results: Vec<Arc<CaseResult>>,
}

fn each<S: Serializer>(results: &[Arc<CaseResult>], into: S) -> Result<S::Ok, S::Error> {
    into.collect_seq(results.iter().map(|result| &**result))
}

fn shared<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<Arc<CaseResult>>, D::Error> {
    let results: Vec<CaseResult> = Deserialize::deserialize(from)?;
    Ok(results.into_iter().map(Arc::new).collect())
}

impl Question for StabilityQuestion {
    type Answer = Catalogue;

    const CODEC: Option<Codec<Catalogue>> = Some(Codec::plain());

    fn answer(&self, subject: &Subject, watch: &dyn Watch<Catalogue>) -> Result<Catalogue, String> {
        if self.law {
            let goes_on = |share: f32| watch.progress(share);
            let law = law_stability(&mut subject.renderer(), &subject.scene, &goes_on)?;
            return Ok(Catalogue {
                law: Some(law),
                ..Catalogue::default()
            });
        }
        let wanted =
            |name: &str| self.cases.is_empty() || self.cases.iter().any(|case| case == name);
        let cases: Vec<_> = stability_cases().filter(|case| wanted(case.name)).collect();
        let (mut renderer, mut found) = (subject.renderer(), Catalogue::default());
        for case in &cases {
            found.results.push(Arc::new(stability(&mut renderer, case)));
            watch.found(&found);
            if !watch.progress(found.results.len() as f32 / cases.len() as f32) {
                break;
            }
        }
        Ok(found)
    }
}

impl CaseResult {
    /// Adds the description of the case.
    pub fn describe(&self, section: &mut Section) {
        section.line(text!("engine-says-naive", text = self.case.naive()));
        section.line(text!("engine-says-engine", text = self.case.engine()));
        section.note(text!(
            "engine-errors",
            error = error(self.naive_error),
            engine = error(self.robust_error)
        ));
        if self.naive_not_finite > 0 {
            section.note(text!("engine-lost", count = self.naive_not_finite));
        }
        if let Some(condition) = self.case.condition {
            section.note(text!(
                "engine-condition-number",
                number = condition.to_string(),
                of = condition.of.text()
            ));
        }
    }

    /// Returns the figures of the case for programs.
    fn value(&self) -> Value {
        let case = self.case;
        json!({
            "name": case.name, "title": case.title(), "topic": case.topic, "wrong": case.naive(), "robust": case.engine(),
            "condition": case.condition, "naive_error": self.naive_error, "robust_error": self.robust_error,
            "verdict": self.verdict, "pixels": self.pixels, "naive_off": self.naive_off,
            "naive_not_finite": self.naive_not_finite, "robust_not_finite": self.robust_not_finite,
        })
    }
}

/// Formats an error in code values: two decimals, since rounding to a stored pixel makes more meaningless.
pub(super) fn error(value: f64) -> String {
    format!("{value:.2}")
}

fn rows(results: &[Arc<CaseResult>]) -> Table {
    table_of! { result in results;
        Column::shown(text!("engine-case"), as_it_is) => result.case.title();
        Column::key("name") => result.case.name;
        Column::key("topic") => result.case.topic.label();
        Column::both("condition", text!("engine-condition"), magnitude).extra() => result.case.condition.map(|c| c.value);
        Column::both("naive_error", text!("engine-naive-short"), error) => result.naive_error;
        Column::both("robust_error", text!("engine-this-short"), error) => result.robust_error;
        Column::key("verdict") => result.verdict.label();
        Column::key("pixels") => result.pixels;
        Column::both("naive_off", text!("engine-pixels-off"), as_it_is).extra() => result.naive_off;
        Column::both("naive_not_finite", text!("engine-not-finite"), as_it_is).extra() => result.naive_not_finite;
    }
}

impl Answer for Catalogue {
    fn report(&self, about: &ReportContext<'_>) -> Report {
        if let Some(law) = &self.law {
            return law.report(about);
        }
        let mut report = Report::new(text!("engine-stability-title"));
        for results in self.results.chunk_by(|a, b| a.case.topic == b.case.topic) {
            report
                .section(results[0].case.topic.label())
                .push(Part::Table(rows(results).to_choose()));
        }
        if let [result] = &self.results[..] {
            result.describe(report.section(result.case.title()));
        }
        let results = self.results.iter();
        let failed = results.filter(|result| result.verdict == Verdict::Fails);
        let (failed, all) = (failed.count(), self.results.len());
        report.failure =
            (failed > 0).then(|| text!("engine-stability-failed", count = failed, all = all));
        report
    }

    fn table(&self) -> Option<Table> {
        Some(match &self.law {
            Some(law) => law.table(),
            None => rows(&self.results),
        })
    }

    fn figure(&self, about: &ReportContext<'_>, _: Option<[u32; 2]>, _: Paper) -> Option<Figure> {
        if let Some(law) = &self.law {
            return Some(Figure::Picture {
                frame: law.picture.clone(),
                scene: Some(Box::new(about.scene.clone())),
            });
        }
        let scene = match &self.results[..] {
            [one] => one.scene.clone().map(Box::new),
            _ => None,
        };
        Some(Figure::Picture {
            frame: stability_sheet(&self.results)?,
            scene,
        })
    }

    fn value(&self, _: &ReportContext<'_>) -> Value {
        let mut value = json!({
            "cases": self.results.iter().map(|result| result.value()).collect::<Vec<_>>(),
        });
        if let Some(law) = &self.law {
            value["law"] = law.value();
        }
        value
    }
}

/// Pixels of the sheet per pixel of a picture.
const SCALE: u32 = 2;
/// Pixels between pictures, and around cases.
const GAP: u32 = 10;
const MARGIN: u32 = 24;
/// Size of the letters, pixels an em.
const EM: f64 = 21.0;
/// Heights of the title above a case and of the text below it, pixels.
const HEAD: u32 = 38;
const FOOT: u32 = 32;
const GROUND: [u8; 4] = [0x1C, 0x1D, 0x21, 255];
const WORDS: [u8; 3] = [0xF2; 3];
const WEAK: [u8; 3] = [0xA8, 0xAA, 0xB0];
const WRONG: [u8; 3] = [0xFF, 0x8A, 0x5C];

/// Draws the cases two to a row; none if there are no results, or more than a sheet can hold.
fn stability_sheet(results: &[Arc<CaseResult>]) -> Option<Frame> {
    let side = results.first()?.pictures[0].width * SCALE;
    let count = u32::try_from(results.len()).ok()?;
    let columns = count.min(2);
    let rows = count.div_ceil(columns);
    let cell = [3 * side + 2 * GAP + MARGIN, HEAD + side + FOOT + MARGIN / 2];
    let width = columns * cell[0] + MARGIN;
    let height = rows.checked_mul(cell[1])? + MARGIN;
    let mut sheet = Frame {
        width,
        height,
        pixels: vec![GROUND; width as usize * height as usize],
    };
    let place = |index: u32| {
        let [column, row] = [index % columns, index / columns];
        [MARGIN + column * cell[0], MARGIN / 2 + row * cell[1]]
    };
    let places: Vec<[u32; 2]> = (0..columns * rows).map(place).collect();
    for (result, [x, y]) in results.iter().zip(&places) {
        for (picture, step) in result.pictures.iter().zip(0..) {
            enlarge(&mut sheet, picture, [x + step * (side + GAP), y + HEAD]);
        }
    }
    let mut drawing = Drawing::over_picture([GROUND[0], GROUND[1], GROUND[2]], 0.0);
    let mut letter = |text: &str, em: f64, [x, y]: [u32; 2], colour: [u8; 3]| {
        let at = DVec2::new(x.into(), y.into());
        drawing.texts.push(Text::new(text, at, em, colour));
    };
    for (result, [x, y]) in results.iter().zip(&places) {
        letter(result.case.title(), EM, [*x, y + HEAD - 12], WORDS);
        for ((words, colour), step) in captions(result).into_iter().zip(0..) {
            let below = [x + step * (side + GAP), y + HEAD + side + 22];
            letter(&words, 0.86 * EM, below, colour);
        }
    }
    drawing.draw_over(&mut sheet);
    Some(sheet)
}

/// Returns the captions of a case's pictures, each with its colour.
fn captions(result: &CaseResult) -> [(String, [u8; 3]); 3] {
    let of = |name: &str, error: f64| {
        let decimals = if error < 10.0 { 2 } else { 0 };
        let wrong = error > HALF_A_CODE_VALUE;
        let colour = if wrong { WRONG } else { WEAK };
        let error = format!("{error:.decimals$}");
        (text!("engine-caption", name = name, error = error), colour)
    };
    let [naive, engine, reference] = case_pictures();
    let mut naive = of(naive, result.naive_error);
    let lost = result.naive_not_finite;
    if lost > 0 {
        let words = text!("engine-caption-lost", caption = naive.0, count = lost);
        naive = (words, WRONG);
    }
    let engine = of(engine, result.robust_error);
    [naive, engine, (reference.to_owned(), WEAK)]
}

/// Draws a picture on the sheet, each pixel as a square.
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
