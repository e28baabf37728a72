//! A study as a table with the orders of convergence, and as JSON.

use super::{Fit, Method, Series, Setting, Study, StudyQuestion, StudyRow, study, study_plot};
use crate::analysis::report::{About, Answer, Column, Figure, Part, Report, Table, as_it_is, cells, fixed};
use crate::analysis::{Question, Subject, Watch, word};
use crate::figure::{Paper, PlotStyle, lay_out};
use crate::scene::Interpolation;
use glam::DVec2;
use serde_json::{Map, Value, json};

/// Pixels of the plot, and of its letters: the legend has many lines.
const SHEET: [u32; 2] = [1600, 1100];
const LETTERS: f64 = 26.0;

impl Question for StudyQuestion {
    type Answer = Study;

    fn answer(&self, subject: &Subject, watch: &dyn Watch<Study>) -> Result<Study, String> {
        let found = study(&subject.scene, subject.model.clone(), self, subject.clock, watch);
        match (found.rows.is_empty(), found.omitted.first()) {
            (false, _) => Ok(found),
            (true, Some(omitted)) => {
                let (method, why) = (omitted.method.name(), omitted.reason);
                Err(format!("nothing to measure: {method} cannot draw this scene, {why}"))
            }
            (true, None) => Err("nothing to measure: the shape takes none of these --segments".to_owned()),
        }
    }
}

impl Setting {
    /// The setting in words.
    pub fn title(&self) -> String {
        let how = match self.interpolation {
            Some(Interpolation::Affine) => ", affine",
            Some(Interpolation::Scanline) => ", scan line",
            Some(Interpolation::Perspective) | None => "",
        };
        format!("{}{how} {}×{}", self.method.title(), self.segments, self.rings)
    }
}

impl Answer for Study {
    fn report(&self, about: &About<'_>) -> Report {
        let mut report = Report::new(format!("{}, {} threads", about.heading(), self.threads));
        let section = report.section("");
        section.parts.extend(study_plot(self).map(|plot| Part::Plot(plot.into())));
        section.note(
            "Errors inside (N·V ≥ 0.2) against the exact picture in code values, 1/255 of linear intensity, before the \
             display: values above 1 count in full; “shown” with them clamped to 1 where the display clamps, as compare has \
             it. Times in ms. * on the front of Pareto: nothing else is both faster and nearer.",
        );
        section.push(Part::Table(rows(self)));
        if self.series.iter().any(|series| series.order.is_some()) {
            let section = report.section("Order of convergence");
            section.note("The error goes as the spacing of the vertices to this power; ± 95 % by Student's t.");
            section.push(Part::Table(orders(self)));
        }
        let section = report.section("");
        for omitted in &self.omitted {
            let how = omitted.interpolation.map_or_else(String::new, |how| format!(" ({})", word(&how)));
            section.note(format!("Not measured: {}{how}: {}.", omitted.method.title(), omitted.reason));
        }
        if self.rows.iter().any(|row| row.scalar) {
            section.note("The scalar methods run in one thread: compare their times with each other.");
        }
        report
    }

    fn figure(&self, _: &About<'_>, size: Option<[u32; 2]>, paper: Paper) -> Option<Figure> {
        let plot = study_plot(self)?;
        let style = PlotStyle { paper, text: LETTERS, titled: true };
        let size = DVec2::from_array(size.unwrap_or(SHEET).map(f64::from));
        Some(Figure::Drawing { drawing: lay_out(&plot, size, &style), title: plot.title })
    }

    fn json(&self, about: &About<'_>) -> Value {
        let orders = |of: fn(&Series) -> Option<Fit>, value: fn(Fit) -> f64| -> Map<String, Value> {
            let one = |method: Method| Some((method.name().to_owned(), json!(value(of(self.series_of(method)?)?))));
            Method::ALL.into_iter().filter_map(one).collect()
        };
        let costs: Map<String, Value> =
            Method::ALL.into_iter().map(|method| (method.name().to_owned(), json!(method.pixel_cost()))).collect();
        json!({
            "scene": about.name,
            "size": about.scene.image.size,
            "threads": self.threads,
            "rows": self.rows,
            "orders": orders(|series| series.order, |fit| fit.slope),
            "order_confidence": orders(|series| series.order, |fit| fit.confidence),
            "orders_rms": orders(|series| series.order_rms, |fit| fit.slope),
            "order_rms_confidence": orders(|series| series.order_rms, |fit| fit.confidence),
            "series": self.series,
            "omitted": self.omitted,
            "pixel_cost": costs,
        })
    }
}

/// A row for each setting.
fn rows(study: &Study) -> Table {
    let codes = |error: f64| format!("{:.3}", 255.0 * error);
    let mut table = Table::new([
        Column::shown("", as_it_is),
        Column::key("method"),
        Column::key("segments"),
        Column::key("rings"),
        Column::key("interpolation"),
        Column::both("n", "n", as_it_is),
        Column::key("spacing"),
        Column::both("error_rms", "RMS", codes),
        Column::both("error_max", "greatest", codes),
        Column::both("error_p99", "99 %", codes),
        Column::key("interior_pixels"),
        Column::both("outline_pixels", "outline", as_it_is),
        Column::key("outline_rms"),
        Column::both("time_ms", "time", fixed::<3>),
        Column::both("spread_ms", "IQR", fixed::<3>),
        Column::key("samples"),
        Column::both("evaluations", "evaluations", as_it_is),
        Column::key("pareto"),
        Column::key("scalar"),
        Column::both("error_rms_shown", "shown", codes),
        Column::key("error_max_shown"),
        Column::shown("", as_it_is),
    ]);
    table.rows.extend(study.rows.iter().map(|row| {
        let StudyRow { setting, spacing, error_rms, error_max, error_p99, interior_pixels, outline_pixels, .. } = *row;
        let StudyRow { outline_rms, time_ms, spread_ms, samples, evaluations, pareto, scalar, .. } = *row;
        let Setting { method, segments, rings, interpolation, n } = setting;
        let how = interpolation.map_or_else(|| "none".to_owned(), |how| word(&how));
        cells![
            setting.title(),
            method.name(),
            segments,
            rings,
            how,
            n,
            spacing,
            error_rms,
            error_max,
            error_p99,
            interior_pixels,
            outline_pixels,
            outline_rms,
            time_ms,
            spread_ms,
            samples,
            evaluations,
            pareto.to_string(),
            scalar.to_string(),
            row.error_rms_shown,
            row.error_max_shown,
            if pareto { "*" } else { "" }
        ]
    }));
    table
}

fn orders(study: &Study) -> Table {
    let mut table =
        Table::new(["", "n", "of the greatest error", "of the RMS"].map(|head| Column::shown(head, as_it_is)));
    let text = |fit: Option<Fit>| fit.map(|fit| format!("{:.2} ± {:.2}", fit.slope, fit.confidence));
    table.rows.extend(study.series.iter().map(|series| {
        let how = match series.interpolation {
            Some(Interpolation::Affine) => ", affine",
            Some(Interpolation::Scanline) => ", scan line",
            Some(Interpolation::Perspective) | None => "",
        };
        cells![format!("{}{how}", series.method.title()), series.n, text(series.order), text(series.order_rms)]
    }));
    table
}
