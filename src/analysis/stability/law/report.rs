//! The report on the stability of a scene's own law.

use super::{LawOperation, LawStability, PrecisionError};
use crate::analysis::report::{
    Column, Part, Report, ReportContext, Table, as_it_is, cells, grouped, table_of,
};
use crate::analysis::stability::report::error;
use crate::figure::magnitude;
use crate::text::text;
use serde_json::{Value, json};

impl LawStability {
    /// Returns the report: the errors of each precision, and the operations.
    pub(in crate::analysis::stability) fn report(&self, about: &ReportContext<'_>) -> Report {
        let title = text!("engine-law-title", heading = about.heading());
        let mut report = Report::new(title);
        let section = report.section("");
        for (name, precision) in [("f32", &self.single), ("f64", &self.double)] {
            section.line(self.sentence(name, precision));
        }
        if !self.losses.is_empty() {
            let section = report.section(text!("engine-law-losses"));
            section.push(Part::Table(losses(&self.losses)));
            section.note(text!("engine-law-losses.why"));
        }
        if !self.undefined.is_empty() {
            let section = report.section(text!("engine-law-undefined"));
            section.push(Part::Table(places(&self.undefined)));
            section.note(text!("engine-law-undefined.why"));
        }
        if self.losses.is_empty() && self.undefined.is_empty() {
            report.section("").line(text!("engine-law-sound"));
        }
        report
    }

    fn sentence(&self, name: &str, precision: &PrecisionError) -> String {
        text!(
            "engine-law-precision",
            name = name,
            off = grouped(precision.off),
            pixels = grouped(self.pixels),
            error = error(precision.error)
        )
    }

    /// Returns the operations for a file, both lists one after the other.
    pub(in crate::analysis::stability) fn table(&self) -> Table {
        let keys = [
            "kind",
            "operation",
            "line",
            "column",
            "pixels",
            "error",
            "condition",
            "x",
            "y",
        ];
        let mut table = Table::new(keys.map(Column::key));
        let lists = [
            ("loses-digits", &self.losses),
            ("undefined", &self.undefined),
        ];
        for (kind, list) in lists {
            table.rows.extend(list.iter().map(|of| {
                let numbers = [of.error, of.condition];
                let [error, condition] =
                    numbers.map(|number| (kind != "undefined").then_some(number));
                let [x, y] = of.at;
                cells![
                    kind,
                    of.operation.as_str(),
                    of.line,
                    of.column,
                    of.pixels,
                    error,
                    condition,
                    x,
                    y
                ]
            }));
        }
        table
    }

    /// Returns the object that programs read.
    pub(in crate::analysis::stability) fn value(&self) -> Value {
        let precision = |of: &PrecisionError| json!({ "off": of.off, "error": of.error });
        let place = |of: &LawOperation| {
            json!({
                "operation": of.operation, "line": of.line, "column": of.column, "pixels": of.pixels, "at": of.at,
            })
        };
        let loss = |of: &LawOperation| {
            let mut value = place(of);
            value["error"] = of.error.into();
            value["condition"] = of.condition.into();
            value
        };
        json!({
            "formula": self.formula,
            "pixels": self.pixels,
            "single": precision(&self.single),
            "double": precision(&self.double),
            "losses": self.losses.iter().map(loss).collect::<Vec<_>>(),
            "undefined": self.undefined.iter().map(place).collect::<Vec<_>>(),
        })
    }
}

fn losses(operations: &[LawOperation]) -> Table {
    table_of! { of in operations;
        Column::shown(text!("engine-law-operation"), as_it_is) => of.operation.as_str();
        Column::shown(text!("engine-law-line"), as_it_is).extra() => of.line;
        Column::shown(text!("engine-law-pixels"), as_it_is) => of.pixels;
        Column::shown(text!("engine-law-error"), error) => of.error;
        Column::shown(text!("engine-condition"), condition) => of.condition;
        Column::shown(text!("engine-law-worst"), as_it_is) => pixel(of);
    }
}

fn places(operations: &[LawOperation]) -> Table {
    table_of! { of in operations;
        Column::shown(text!("engine-law-operation"), as_it_is) => of.operation.as_str();
        Column::shown(text!("engine-law-line"), as_it_is).extra() => of.line;
        Column::shown(text!("engine-law-pixels"), as_it_is) => of.pixels;
        Column::shown(text!("engine-law-first"), as_it_is) => pixel(of);
    }
}

fn condition(value: f64) -> String {
    if value.is_infinite() {
        "∞".to_owned()
    } else {
        magnitude(value)
    }
}

fn pixel(of: &LawOperation) -> String {
    let [x, y] = of.at;
    format!("({x}, {y})")
}
