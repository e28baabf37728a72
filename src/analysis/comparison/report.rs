//! The figures of panes against the last of them.

use super::PaneFigures;
use super::{draw_panes, pane_figures};
use crate::analysis::report::{About, Answer, Cell, Column, Part, Report, Table, as_it_is, cells, fixed};
use crate::analysis::{Question, Subject, Watch};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// How far the scene's panes are from the last of them. Which panes there are is part of the scene.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ComparisonQuestion;

/// The figures, a pane each.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison(pub Vec<PaneFigures>);

impl Question for ComparisonQuestion {
    type Answer = Comparison;

    fn answer(&self, subject: &Subject, watch: &dyn Watch<Comparison>) -> Result<Comparison, String> {
        let scene = &subject.scene;
        if scene.compare.panes.is_empty() {
            return Err("nothing to compare with, expected --pane KEY=VALUE or a scene with panes".to_owned());
        }
        let which: Vec<_> = (0..scene.pane_count()).map(|index| (index, scene.image.size)).collect();
        let mut progress = |done: u32| watch.at(done as f32 / which.len() as f32);
        let nothing = |_: &mut _, _: &mut _, _: &_| Ok::<(), String>(());
        let panes = draw_panes(&mut subject.renderer(), scene, &which, 1, &mut progress, nothing)?;
        Ok(Comparison(pane_figures(&panes)))
    }
}

impl Answer for Comparison {
    fn report(&self, about: &About<'_>) -> Report {
        let reference = self.0.last().map_or("", |last| last.name.as_str());
        let mut report = Report::new(format!("{}, against {reference}", about.heading()));
        report.section("").note("Linear intensity: 1 is white, 1/255 = 0.0039 a code value");
        let mut table = Table::new([
            Column::both("pane", "pane", as_it_is),
            Column::both("brightest", "brightest", fixed::<4>),
            Column::key("brightest_x"),
            Column::key("brightest_y"),
            Column::key("pixels"),
            Column::both("mean", "mean", fixed::<5>),
            Column::both("rms", "RMS", fixed::<5>),
            Column::both("greatest", "greatest", fixed::<5>),
            Column::shown("at", as_it_is),
            Column::key("x"),
            Column::key("y"),
        ]);
        for PaneFigures { name, brightest, error } in &self.0 {
            let mut row = cells![name.as_str(), brightest.map(|b| b.value)];
            row.extend([0, 1].map(|axis| Cell::from(brightest.map(|b| b.at[axis]))));
            row.push(error.map(|e| e.pixels).into());
            row.extend([error.map(|e| e.mean), error.map(|e| e.rms), error.map(|e| e.greatest)].map(Cell::from));
            let at = error.and_then(|error| error.at);
            row.push(at.map(|[x, y]| format!("{x},{y}")).into());
            row.extend([0, 1].map(|axis| Cell::from(at.map(|at| at[axis]))));
            table.rows.push(row);
        }
        report.section("").push(Part::Table(table));
        report
    }

    fn json(&self, about: &About<'_>) -> Value {
        json!({ "scene": about.name, "size": about.scene.image.size, "panes": self.0 })
    }
}
