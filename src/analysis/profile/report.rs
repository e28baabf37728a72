//! A profile as a table and as plots.

use super::{Profile, ProfileQuestion, profile, profile_plots};
use crate::analysis::report::{About, Answer, Cell, Column, Part, Report, Table};
use crate::analysis::{Question, Subject, Watch};
use serde_json::{Map, Value, json};

/// The profile, and how it was asked.
#[derive(Clone, Debug, PartialEq)]
pub struct TakenProfile {
    pub profile: Profile,
    pub question: ProfileQuestion,
}

impl Question for ProfileQuestion {
    type Answer = TakenProfile;

    fn answer(&self, subject: &Subject, _: &dyn Watch<TakenProfile>) -> Result<TakenProfile, String> {
        let profile = profile(&mut subject.renderer(), &subject.scene, self).map_err(|error| error.to_string())?;
        Ok(TakenProfile { profile, question: self.clone() })
    }
}

impl Answer for TakenProfile {
    fn report(&self, _: &About<'_>) -> Report {
        let Self { profile, question } = self;
        let mut report = Report::default();
        for plot in profile_plots(profile, question) {
            report.section("").push(Part::Plot(plot.into()));
        }
        let note = "Phong shading weakens Mach bands, it does not abolish them: its slope still jumps, only by less.";
        report.section("").note(note);
        report
    }

    fn table(&self) -> Option<Table> {
        Some(table(&self.profile))
    }

    fn figure_size(&self, _: usize) -> [u32; 2] {
        [1600, 1200]
    }

    fn json(&self, _: &About<'_>) -> Value {
        let Self { profile, question } = self;
        let samples = profile.samples.iter().enumerate().map(|(i, sample)| {
            let mut row = Map::new();
            row.extend(
                [("x", sample.x), ("y", sample.y), ("t", sample.t)].map(|(key, value)| (key.to_owned(), json!(value))),
            );
            for trace in &profile.traces {
                let mode = trace.word();
                row.insert(mode.to_owned(), json!(trace.intensity[i]));
                row.insert(format!("{mode}_slope"), json!(trace.slope[i]));
                row.insert(format!("{mode}_perceived"), json!(trace.perceived[i]));
            }
            Value::Object(row)
        });
        let borders = profile.borders.iter().enumerate().map(|(i, border)| {
            let mut row = json!(border);
            for trace in &profile.traces {
                row[trace.word()] = json!(trace.corners[i]);
            }
            row
        });
        json!({
            "from": question.from.to_array(),
            "to": question.to.to_array(),
            "length": profile.length,
            "modes": question.modes,
            "viewing": question.viewing,
            "perception": question.perception,
            "widths": profile.widths,
            "borders": borders.collect::<Vec<_>>(),
            "samples": samples.collect::<Vec<_>>(),
        })
    }
}

/// The samples, a row each.
fn table(profile: &Profile) -> Table {
    let of_mode = |mode: &str| [mode.to_owned(), format!("{mode}_slope"), format!("{mode}_perceived")];
    let modes = profile.traces.iter().flat_map(|trace| of_mode(trace.word()));
    let mut table = Table::new(["x", "y", "t"].into_iter().map(Column::key).chain(modes.map(Column::key)));
    for (i, sample) in profile.samples.iter().enumerate() {
        let values = profile.traces.iter().flat_map(|trace| [trace.intensity[i], trace.slope[i], trace.perceived[i]]);
        table.rows.push([sample.x, sample.y, sample.t].into_iter().chain(values).map(Cell::from).collect());
    }
    table
}
