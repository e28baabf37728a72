//! `stability`: stiff and extreme cases in the textbook's way, the engine's and a reference's.

use super::failure::Failure;
use super::output::{print, print_json, progress_bar};
use super::sheet::{picture_name, write_text};
use clap::Args;
use serde_json::json;
use shading_lab::analysis::{Case, CaseResult, Verdict, stability, stability_cases, stability_sheet};
use shading_lab::document::{save_frame, save_picture};
use shading_lab::render::Renderer;
use shading_lab::table::Table;
use std::fmt::Write;
use std::path::PathBuf;

#[derive(Args)]
pub struct StabilityCommand {
    /// Only these cases, by name, between commas; all unless given
    #[arg(long = "case", value_name = "NAME", value_delimiter = ',', value_parser = parse_case)]
    cases: Vec<&'static Case>,
    /// The figures, a row a case
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// The pictures: each case as the textbook, the engine and the reference draw it
    #[arg(short, long, value_name = "FILE.png", value_parser = picture_name())]
    output: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

fn parse_case(text: &str) -> Result<&'static Case, String> {
    let names = || stability_cases().map(|case| case.name).collect::<Vec<_>>().join(", ");
    stability_cases().find(|case| case.name == text.trim()).ok_or_else(|| format!("expected one of {}", names()))
}

impl StabilityCommand {
    pub fn run(self) -> Result<(), Failure> {
        let asked: Vec<&'static Case> = if self.cases.is_empty() { stability_cases().collect() } else { self.cases };
        let bar = progress_bar(asked.len() as u64, "drawing");
        let mut renderer = Renderer::default();
        let draw = |case: &&'static Case| {
            let result = stability(&mut renderer, case);
            bar.inc(1);
            result
        };
        let results: Vec<CaseResult> = asked.iter().map(draw).collect();
        bar.finish_and_clear();
        if let Some(path) = &self.csv {
            write_text(path, &csv(&results))?;
        }
        if let Some(path) = &self.output {
            let sheet = stability_sheet(&results).ok_or_else(|| Failure::work("the figure is too large"))?;
            match &results[..] {
                [CaseResult { scene: Some(scene), .. }] => save_picture(path, &sheet, scene)?,
                _ => save_frame(path, &sheet)?,
            }
        }
        if self.json {
            print_json(&json!({ "cases": results }))?;
        } else if self.csv.is_none() && self.output.is_none() {
            print(&text(&results))?;
        }
        match results.iter().filter(|result| result.verdict == Verdict::Fails).count() {
            0 => Ok(()),
            failed => Err(Failure::work(format!("{failed} of {} cases fail", results.len()))),
        }
    }
}

fn csv(results: &[CaseResult]) -> String {
    let mut table = Table::new(
        "name,topic,condition,naive_error,robust_error,verdict,pixels,naive_off,\
         naive_not_finite",
    );
    for result in results {
        let CaseResult { case, naive_error, robust_error, pixels, naive_off, naive_not_finite, .. } = result;
        let condition = result.case.condition.map_or_else(String::new, |condition| condition.value.to_string());
        table.row(&[
            &case.name,
            &case.topic.title(),
            &condition,
            naive_error,
            robust_error,
            &result.verdict.words(),
            pixels,
            naive_off,
            naive_not_finite,
        ]);
    }
    table.into_csv()
}

/// A table by topic; of a single case also what is said of it.
fn text(results: &[CaseResult]) -> String {
    let mut text =
        "Greatest errors in code values against a reference of 106 bits; ∅ counts pixels that are infinite or no \
                    number\n\n"
            .to_owned();
    let _ = writeln!(
        text,
        "{:22} {:>9} {:>9} {:>7} {:>6} {:>11}  verdict",
        "case", "condition", "textbook", "pixels", "∅", "this engine"
    );
    for result in results {
        let condition =
            result.case.condition.map_or_else(|| "-".to_owned(), |condition| format!("{:.1e}", condition.value));
        let _ = writeln!(
            text,
            "{:22} {condition:>9} {:>9.3} {:>7} {:>6} {:>11.4}  {}",
            result.case.name,
            result.naive_error,
            result.naive_off,
            result.naive_not_finite,
            result.robust_error,
            result.verdict.words()
        );
    }
    if let [result] = results {
        let _ = writeln!(
            text,
            "\n{}\n  textbook: {}\n  this engine: {}",
            result.case.title, result.case.wrong, result.case.robust
        );
        if let Some(condition) = result.case.condition {
            let _ = writeln!(text, "  condition number {condition}");
        }
    }
    text
}
