//! A study as a plot of error over time, as tables with the orders of convergence, and as JSON.

use super::{Fit, Method, Series, Setting, Study, StudyQuestion, StudyRow, study, title};
use crate::analysis::codec::Codec;
use crate::analysis::report::{
    Answer, Column, Figure, Part, Report, ReportContext, Table, as_it_is, fixed,
};
use crate::analysis::{Question, Subject, Watch};
use crate::figure::{Axis, Curve, Dash, Ink, Paper, Plot, PlotKind, PlotStyle, Point, lay_out};
use crate::scene::{Choice, Interpolation, ShadingMode};
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
    }
    object
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
            let method = title(omitted.method, omitted.interpolation);
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
        let orders =
            |of: fn(&Series) -> Option<Fit>, value: fn(Fit) -> f64| -> Map<String, Value> {
                let one = |method: &Method| {
                    Some((
                        method.word().to_owned(),
                        json!(value(of(self.series_of(*method)?)?)),
                    ))
                };
                Method::VALUES.iter().filter_map(one).collect()
            };
        let cost = |method: &Method| {
            let names = ["additions", "multiplications", "divisions", "powers"].map(str::to_owned);
            let counts = names.into_iter().zip(method.pixel_cost().map(Value::from));
            (method.word().to_owned(), Value::Object(counts.collect()))
        };
        json!({
            "scene": about.name,
            "size": about.scene.image.size,
            "threads": self.threads,
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

fn rows(study: &Study) -> Table {
    Table::from_rows(
        &study.rows,
        [
            (Column::shown("", as_it_is), |row| {
                row.setting.title().into()
            }),
            (Column::key("method"), |row| {
                row.setting.method.word().into()
            }),
            (Column::key("segments"), |row| row.setting.segments.into()),
            (Column::key("rings"), |row| row.setting.rings.into()),
            (Column::key("interpolation"), |row| {
                row.setting
                    .interpolation
                    .map_or("none", Choice::word)
                    .into()
            }),
            (Column::both("n", "n", as_it_is).extra(), |row| {
                row.setting.n.into()
            }),
            (Column::key("spacing"), |row| row.spacing.into()),
            (
                Column::both("error_rms", text!("engine-rms"), codes),
                |row| row.error_rms.into(),
            ),
            (
                Column::both("error_max", text!("engine-greatest"), codes).extra(),
                |row| row.error_max.into(),
            ),
            (Column::both("error_p99", "99 %", codes).extra(), |row| {
                row.error_p99.into()
            }),
            (Column::key("interior_pixels"), |row| {
                row.interior_pixels.into()
            }),
            (
                Column::both("outline_pixels", text!("engine-outline"), as_it_is).extra(),
                |row| row.outline_pixels.into(),
            ),
            (Column::key("outline_rms"), |row| row.outline_rms.into()),
            (
                Column::both("time_ms", text!("engine-time-ms"), fixed::<3>),
                |row| row.time_ms.into(),
            ),
            (
                Column::both("spread_ms", text!("engine-spread"), fixed::<3>).extra(),
                |row| row.spread_ms.into(),
            ),
            (Column::key("samples"), |row| row.samples.into()),
            (
                Column::both("evaluations", text!("engine-evaluations"), as_it_is).extra(),
                |row| row.evaluations.into(),
            ),
            (Column::key("pareto"), |row| row.pareto.to_string().into()),
            (Column::key("scalar"), |row| row.scalar.to_string().into()),
            (
                Column::both("error_rms_shown", text!("engine-rms-shown"), codes).extra(),
                |row| row.error_rms_shown.into(),
            ),
            (Column::key("error_max_shown"), |row| {
                row.error_max_shown.into()
            }),
            (Column::shown("", as_it_is), |row| {
                if row.pareto { "*" } else { "" }.into()
            }),
        ],
    )
}

fn orders(study: &Study) -> Table {
    fn text(fit: Option<Fit>) -> Option<String> {
        fit.map(|fit| format!("{:.2} ± {:.2}", fit.slope, fit.confidence))
    }
    Table::from_rows(
        &study.series,
        [
            (Column::shown("", as_it_is), |series| {
                title(series.method, series.interpolation).into()
            }),
            (Column::shown("n", as_it_is), |series| series.n.into()),
            (
                Column::shown(text!("engine-order-greatest"), as_it_is),
                |series| text(series.order).into(),
            ),
            (
                Column::shown(text!("engine-order-rms"), as_it_is),
                |series| text(series.order_rms).into(),
            ),
        ],
    )
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
    let mut front: Vec<[f64; 2]> = known
        .iter()
        .filter(|(row, _)| row.pareto)
        .map(|(_, at)| *at)
        .collect();
    front.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let front = Curve::new(text!("engine-front"), front, Ink::Reference);
    let mut curves = vec![Curve {
        dash: Dash::Long,
        emphasised: false,
        ..front
    }];
    let mut points = Vec::new();
    for series in known.chunk_by(|a, b| a.0.setting.is_like(&b.0.setting)) {
        let Setting {
            method,
            interpolation,
            n,
            ..
        } = series[0].0.setting;
        let n = if several_n {
            format!(", n = {n}")
        } else {
            String::new()
        };
        let name = title(method, interpolation) + &n;
        let (ink, dash) = look(method);
        let emphasised = interpolation != Some(Interpolation::Affine);
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
                about: about_row(row),
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

fn about_row(row: &StudyRow) -> Vec<String> {
    let setting = &row.setting;
    vec![
        format!("{}, n = {}", setting.title(), setting.n),
        text!(
            "engine-study-point-error",
            rms = codes(row.error_rms),
            greatest = codes(row.error_max)
        ),
        text!(
            "engine-study-point-time",
            time = format!("{:.3}", row.time_ms),
            spread = format!("{:.3}", row.spread_ms)
        ),
        text!(if row.scalar {
            "engine-study-point-historic"
        } else {
            "engine-study-point-show"
        })
        .to_owned(),
    ]
}

/// Returns the position of a row in the plot: the logarithms to base 10 of its time in milliseconds and of its error.
pub fn study_point(row: &StudyRow) -> Option<[f64; 2]> {
    let point = [row.time_ms.log10(), row.error_rms.log10()];
    point.iter().all(|value| value.is_finite()).then_some(point)
}

fn look(method: Method) -> (Ink, Dash) {
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
