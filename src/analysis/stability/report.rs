//! The catalogue of cases: how it is asked for, and what it says.

use super::{CaseResult, Verdict, stability, stability_cases, stability_sheet};
use crate::analysis::report::{About, Answer, Column, Figure, Part, Report, Section, Table, as_it_is, cells, fixed};
use crate::analysis::{Question, Subject, Watch};
use crate::figure::Paper;
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
        let wanted = |name: &str| self.cases.is_empty() || self.cases.iter().any(|case| case == name);
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
            let pixels = if lost == 1 { "1 pixel is" } else { &format!("{lost} pixels are") };
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
        let mut report = Report::new("Greatest errors in code values against a reference of 106 bits");
        let condition = |value: f64| format!("{value:.1e}");
        let mut table = Table::new([
            Column::both("name", "case", as_it_is),
            Column::key("topic"),
            Column::both("condition", "condition", condition),
            Column::both("naive_error", "textbook", fixed::<3>),
            Column::both("robust_error", "this engine", fixed::<4>),
            Column::both("verdict", "verdict", as_it_is),
            Column::key("pixels"),
            Column::both("naive_off", "pixels off", as_it_is),
            Column::both("naive_not_finite", "not finite", as_it_is),
        ]);
        table.rows.extend(self.results.iter().map(|result| {
            let CaseResult { case, naive_error, robust_error, verdict, pixels, naive_off, naive_not_finite, .. } =
                &**result;
            let (topic, condition) = (case.topic.title(), case.condition.map(|condition| condition.value));
            let verdict = verdict.words();
            cells![
                case.name,
                topic,
                condition,
                *naive_error,
                *robust_error,
                verdict,
                *pixels,
                *naive_off,
                *naive_not_finite
            ]
        }));
        report.section("").push(Part::Table(table));
        if let [result] = &self.results[..] {
            result.describe(report.section(result.case.title));
        }
        let failed = self.results.iter().filter(|result| result.verdict == Verdict::Fails).count();
        report.failure = (failed > 0).then(|| format!("{failed} of {} cases fail", self.results.len()));
        report
    }

    /// Each case as the textbook, the engine and the reference draw it.
    fn figure(&self, _: &About<'_>, _: Option<[u32; 2]>, _: Paper) -> Option<Figure> {
        let results: Vec<CaseResult> = self.results.iter().map(|result| CaseResult::clone(result)).collect();
        let scene = if let [one] = &results[..] { one.scene.clone().map(Box::new) } else { None };
        Some(Figure::Picture { frame: stability_sheet(&results)?, scene })
    }

    fn json(&self, _: &About<'_>) -> Value {
        json!({ "cases": self.results.iter().map(|result| json!(**result)).collect::<Vec<_>>() })
    }
}
