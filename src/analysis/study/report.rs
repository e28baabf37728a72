//! A study as a plot of error over time, as tables with the orders of convergence, and as JSON.

use super::{Fit, Method, Series, Setting, Study, StudyQuestion, StudyRow, study};
use crate::analysis::codec::Codec;
use crate::analysis::report::{
    Answer, Column, Figure, Part, Report, ReportContext, Table, as_it_is, fixed, table_of,
};
use crate::analysis::{Question, Subject, Watch};
use crate::figure::{Axis, Curve, Dash, Ink, Paper, Plot, PlotKind, PlotStyle, Point, lay_out};
use crate::scene::{Choice, Interpolation, ReflectionModel, ShadingMode};
use crate::text::text;
use glam::DVec2;
use serde_json::{Map, Value, json};

/// Size of the plot and of its letters in pixels: the legend has many lines.
const SHEET: [u32; 2] = [1600, 1100];
const LETTERS: f64 = 26.0;

/// Margin of the axes beyond the points, as a share of their extent; axes span at least half a decade.
const MARGIN: f64 = 0.08;
const LEAST: f64 = 0.5;

impl Question for StudyQuestion {
    type Answer = Study;

    const CODEC: Option<Codec<Study>> = Some(Codec::plain());

    fn answer(&self, subject: &Subject, watch: &dyn Watch<Study>) -> Result<Study, String> {
        if subject.has_own_materials() && !self.n.is_empty() {
            return Err(text!("engine-study-own-materials").to_owned());
        }
        let found = study(subject, self, watch);
        match (found.rows.is_empty(), found.omitted.first()) {
            (false, _) => Ok(found),
            (true, Some(omitted)) => Err(text!(
                "engine-study-impossible",
                method = omitted.method.label(),
                reason = omitted.reason.text()
            )),
            (true, None) => Err(text!("engine-study-no-segments").to_owned()),
        }
    }
}

/// Returns a row as an object, with the keys of its setting among its own.
fn row_object(row: &StudyRow) -> Value {
    let mut object = json!(row.setting);
    if let (Value::Object(all), Value::Object(own)) = (&mut object, json!(row)) {
        all.extend(own.into_iter().filter(|(key, _)| key != "setting"));
        all.insert("operations".into(), row.operations.map(counts).into());
    }
    object
}

/// Returns counts of operations as an object.
fn counts(counts: [u32; 4]) -> Value {
    let names = ["additions", "multiplications", "divisions", "powers"].map(str::to_owned);
    Value::Object(names.into_iter().zip(counts.map(Value::from)).collect())
}

impl Answer for Study {
    fn report(&self, about: &ReportContext<'_>) -> Report {
        let mut report = Report::new(text!(
            "engine-study-title",
            about = about.heading(),
            threads = self.threads
        ));
        let section = report.section("");
        section
            .parts
            .extend(study_plot(self).map(|plot| Part::Plot(plot.into())));
        section.push(Part::Table(rows(self).to_choose()));
        section.note(text!("engine-study-note"));
        if let Some(reference) = self.reference {
            let reference = self.law_name(reference);
            section.note(text!("engine-study-law-note", reference = reference));
        }
        if self.series.iter().any(|series| series.order.is_some()) {
            let section = report.section(text!("engine-order"));
            section.push(Part::Table(orders(self)));
            section.note(text!("engine-order-note"));
        }
        let scalar = self.rows.iter().any(|row| row.scalar);
        if self.omitted.is_empty() && !scalar {
            return report;
        }
        let section = report.section(text!("engine-study-remarks"));
        for omitted in &self.omitted {
            let method = self.method_title(omitted.method, omitted.interpolation, omitted.law);
            section.note(text!(
                "engine-study-omitted",
                method = method,
                reason = omitted.reason.text()
            ));
        }
        if scalar {
            section.note(text!("engine-study-scalar"));
        }
        report
    }

    fn figure(
        &self,
        _: &ReportContext<'_>,
        size: Option<[u32; 2]>,
        paper: Paper,
    ) -> Option<Figure> {
        let plot = study_plot(self)?;
        let style = PlotStyle {
            paper,
            text: LETTERS,
            titled: true,
        };
        let size = DVec2::from_array(size.unwrap_or(SHEET).map(f64::from));
        Some(Figure::Drawing {
            drawing: lay_out(&plot, size, &style),
            title: plot.title,
        })
    }

    fn value(&self, about: &ReportContext<'_>) -> Value {
        let orders = |of: fn(&Series) -> Option<Fit>, value: fn(Fit) -> f64| {
            let one = |method: &Method| {
                let fit = of(self.series_of(*method)?)?;
                Some((method.word().to_owned(), json!(value(fit))))
            };
            Method::VALUES.iter().filter_map(one).collect::<Map<_, _>>()
        };
        let cost = |method: &Method| (method.word().to_owned(), counts(method.pixel_cost()));
        json!({
            "scene": about.name,
            "size": about.scene.image.size,
            "threads": self.threads,
            "reference": self.reference,
            "own_law": self.own_law,
            "rows": self.rows.iter().map(row_object).collect::<Vec<_>>(),
            "orders": orders(|series| series.order, |fit| fit.slope),
            "order_confidence": orders(|series| series.order, |fit| fit.confidence),
            "orders_rms": orders(|series| series.order_rms, |fit| fit.slope),
            "order_rms_confidence": orders(|series| series.order_rms, |fit| fit.confidence),
            "series": self.series,
            "omitted": self.omitted,
            "pixel_cost": Method::VALUES.iter().map(cost).collect::<Map<_, _>>(),
        })
    }
}

/// Formats an error in code values.
fn codes(error: f64) -> String {
    format!("{:.3}", 255.0 * error)
}

/// Returns the table of all settings.
fn rows(study: &Study) -> Table {
    // Where one law is measured, columns about laws are for files alone.
    let of_law = |key, head: &'static str, show| match study.reference {
        Some(_) => Column::both(key, head, show).extra(),
        None => Column::key(key),
    };
    let table = table_of! { row in &study.rows;
        Column::key("method") => row.setting.method.word();
        Column::key("segments") => row.setting.segments;
        Column::key("rings") => row.setting.rings;
        Column::key("interpolation") => row.setting.interpolation.map_or("none", Choice::word);
        Column::both("n", "n", as_it_is).extra() => row.setting.n;
        Column::key("spacing") => row.spacing;
        Column::both("error_rms", text!("engine-rms"), codes) => row.error_rms;
        Column::both("error_max", text!("engine-greatest"), codes).extra() => row.error_max;
        Column::both("error_p99", "99 %", codes).extra() => row.error_p99;
        Column::key("interior_pixels") => row.interior_pixels;
        Column::both("outline_pixels", text!("engine-outline"), as_it_is).extra() => row.outline_pixels;
        Column::key("outline_rms") => row.outline_rms;
        Column::both("time_ms", text!("engine-time-ms"), fixed::<3>) => row.time_ms;
        Column::both("spread_ms", text!("engine-spread"), fixed::<3>).extra() => row.spread_ms;
        Column::key("samples") => row.samples;
        Column::both("evaluations", text!("engine-evaluations"), as_it_is).extra() => row.evaluations;
        Column::key("pareto") => row.pareto.to_string();
        Column::key("scalar") => row.scalar.to_string();
        Column::both("error_rms_shown", text!("engine-rms-shown"), codes).extra() => row.error_rms_shown;
        Column::key("error_max_shown") => row.error_max_shown;
        Column::key("law") => row.setting.law.map(Choice::word);
        of_law("law_rms", text!("engine-law-rms"), codes) => row.law_rms;
        of_law("additions", "+", as_it_is) => row.operations.map(|[count, ..]| count);
        of_law("multiplications", "×", as_it_is) => row.operations.map(|[_, count, ..]| count);
        of_law("divisions", "÷ √", as_it_is) => row.operations.map(|[.., count, _]| count);
        of_law("powers", "x^n", as_it_is) => row.operations.map(|[.., count]| count);
        Column::shown("", as_it_is) => if row.pareto { "*" } else { "" };
    };
    let titles = study.rows.iter().map(|row| study.title(&row.setting));
    with_titles(table, titles)
}

/// Adds a first column with the titles of the rows.
fn with_titles(mut table: Table, titles: impl Iterator<Item = String>) -> Table {
    table.columns.insert(0, Column::shown("", as_it_is));
    for (row, title) in table.rows.iter_mut().zip(titles) {
        row.insert(0, title.into());
    }
    table
}

/// Returns the table of the orders of convergence.
fn orders(study: &Study) -> Table {
    fn text(fit: Option<Fit>) -> Option<String> {
        fit.map(|fit| format!("{:.2} ± {:.2}", fit.slope, fit.confidence))
    }
    let title = |own: &Series| study.method_title(own.method, own.interpolation, own.law);
    let table = table_of! { series in &study.series;
        Column::shown("n", as_it_is) => series.n;
        Column::shown(text!("engine-order-greatest"), as_it_is) => text(series.order);
        Column::shown(text!("engine-order-rms"), as_it_is) => text(series.order_rms);
    };
    with_titles(table, study.series.iter().map(title))
}

/// Plots error over time, both logarithmic: a curve for each method, and the Pareto front; none before any is known.
pub fn study_plot(study: &Study) -> Option<Plot> {
    let known: Vec<(&StudyRow, [f64; 2])> = study
        .rows
        .iter()
        .filter_map(|row| Some((row, study_point(row)?)))
        .collect();
    let first = known.first()?.0;
    let several_n = known
        .iter()
        .any(|(row, _)| row.setting.n.to_bits() != first.setting.n.to_bits());
    let front = known.iter().filter(|(row, _)| row.pareto);
    let mut front: Vec<[f64; 2]> = front.map(|(_, at)| *at).collect();
    front.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let own = known
        .iter()
        .any(|(row, _)| row.pareto && row.setting.law == Some(ReflectionModel::Formula));
    let name = if own {
        let law = study.law_name(ReflectionModel::Formula);
        text!("engine-front-law", law = law)
    } else {
        text!("engine-front").to_owned()
    };
    let mut curves = vec![Curve {
        dash: Dash::Long,
        emphasised: false,
        ..Curve::new(&name, front, Ink::Reference)
    }];
    let mut points = Vec::new();
    for series in known.chunk_by(|a, b| a.0.setting.is_like(&b.0.setting)) {
        let Setting {
            method,
            interpolation,
            n,
            law,
            ..
        } = series[0].0.setting;
        let n = if several_n {
            format!(", n = {n}")
        } else {
            String::new()
        };
        let name = study.method_title(method, interpolation, law) + &n;
        let (ink, dash) = line_style(method);
        let affine = interpolation == Some(Interpolation::Affine);
        let emphasised = !affine && (law.is_none() || law != study.reference);
        let line = series.iter().map(|(_, at)| *at).collect();
        curves.push(Curve {
            dash,
            emphasised,
            ..Curve::new(&name, line, ink)
        });
        points.extend(series.iter().enumerate().map(|(index, (row, at))| {
            let (segments, strong) = (row.setting.segments, index == 0 || row.pareto);
            let name = if strong {
                format!("{name} {segments}")
            } else {
                segments.to_string()
            };
            Point {
                at: *at,
                name,
                ink,
                hollow: row.scalar,
                strong,
                about: about_row(study, row),
            }
        }));
    }
    let axis = |name: &str, index: usize| {
        let values = known.iter().map(|(_, at)| at[index]);
        let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
            [low.min(v), high.max(v)]
        });
        let margin = ((high - low) * MARGIN).max(0.5 * (LEAST - (high - low)));
        Axis::decades(name, low - margin, high + margin)
    };
    let axes = [
        axis(text!("engine-axis-time"), 0),
        axis(text!("engine-axis-error"), 1),
    ];
    let (title, note) = (text!("engine-study-plot"), text!("engine-study-plot.note"));
    Some(Plot {
        points,
        ..Plot::new(PlotKind::Study, title, note, axes, curves)
    })
}

/// Describes a row in a few lines.
fn about_row(study: &Study, row: &StudyRow) -> Vec<String> {
    let setting = &row.setting;
    let mut lines = vec![
        format!("{}, n = {}", study.title(setting), setting.n),
        text!(
            "engine-study-point-error",
            rms = codes(row.error_rms),
            greatest = codes(row.error_max)
        ),
    ];
    if let (Some(rms), Some(reference)) = (row.law_rms, study.reference) {
        let reference = study.law_name(reference);
        lines.push(text!(
            "engine-study-point-law",
            reference = reference,
            rms = codes(rms)
        ));
    }
    lines.push(text!(
        "engine-study-point-time",
        time = format!("{:.3}", row.time_ms),
        spread = format!("{:.3}", row.spread_ms)
    ));
    if let Some([additions, multiplications, divisions, powers]) = row.operations {
        lines.push(text!(
            "engine-study-point-operations",
            additions = additions,
            multiplications = multiplications,
            divisions = divisions,
            powers = powers
        ));
    }
    let show = if row.scalar {
        text!("engine-study-point-historic")
    } else {
        text!("engine-study-point-show")
    };
    lines.push(show.to_owned());
    lines
}

/// Returns the position of a row in the plot: the logarithms to base 10 of its time in milliseconds and of its error.
pub fn study_point(row: &StudyRow) -> Option<[f64; 2]> {
    let point = [row.time_ms.log10(), row.error_rms.log10()];
    point.iter().all(|value| value.is_finite()).then_some(point)
}

/// Returns the ink and the dashes of a method's curve.
fn line_style(method: Method) -> (Ink, Dash) {
    match method {
        Method::Flat => (Ink::Shading(ShadingMode::Flat), Dash::Solid),
        Method::FlatVertexMean => (Ink::Shading(ShadingMode::Flat), Dash::Dashed),
        Method::Interpolated => (Ink::Shading(ShadingMode::Interpolated), Dash::DashDot),
        Method::Gouraud => (Ink::Shading(ShadingMode::Gouraud), Dash::Solid),
        Method::Phong => (Ink::Shading(ShadingMode::Phong), Dash::Solid),
        Method::PhongUnnormalised => (Ink::Shading(ShadingMode::Phong), Dash::Dashed),
        Method::PhongScalar => (Ink::Historic(0), Dash::Solid),
        Method::Taylor => (Ink::Historic(1), Dash::DashDot),
        Method::Angular => (Ink::Historic(2), Dash::Dotted),
    }
}
