//! A study as a table, for reading and as CSV.

use shading_lab::analysis::{Fit, Study, StudyRow};
use shading_lab::scene::{Interpolation, Scene};
use shading_lab::table::Table;
use std::fmt::{Display, Write};

/// A row for each setting.
pub fn csv(found: &Study) -> String {
    let mut table = Table::new(
        "method,segments,rings,interpolation,n,spacing,error_rms,error_max,error_p99,interior_pixels,\
         outline_pixels,outline_rms,time_ms,spread_ms,samples,evaluations,pareto,scalar,error_rms_shown,\
         error_max_shown",
    );
    for row in &found.rows {
        let StudyRow { setting, spacing, error_rms, error_max, error_p99, interior_pixels, .. } = row;
        let StudyRow { outline_pixels, outline_rms, time_ms, spread_ms, samples, evaluations, .. } = row;
        let StudyRow { pareto, scalar, error_rms_shown, error_max_shown, .. } = row;
        let (method, how, n) = (setting.method.name(), word(setting.interpolation), setting.n);
        let (segments, rings) = (&setting.segments, &setting.rings);
        let errors: [&dyn Display; 6] = [&how, &n, spacing, error_rms, error_max, error_p99];
        let outline: [&dyn Display; 3] = [interior_pixels, outline_pixels, outline_rms];
        let work: [&dyn Display; 6] = [time_ms, spread_ms, samples, evaluations, pareto, scalar];
        let shown: [&dyn Display; 2] = [error_rms_shown, error_max_shown];
        table.row(&[&[&method as &dyn Display, segments, rings][..], &errors, &outline, &work, &shown].concat());
    }
    table.into_csv()
}

fn word(interpolation: Option<Interpolation>) -> &'static str {
    match interpolation {
        Some(Interpolation::Perspective) => "perspective",
        Some(Interpolation::Affine) => "affine",
        Some(Interpolation::Scanline) => "scanline",
        None => "none",
    }
}

/// The table with the orders below it.
pub fn table(found: &Study, name: &str, scene: &Scene, threads: usize) -> String {
    let [width, height] = scene.image.size;
    let mut text = format!(
        "{name}: {width}×{height}, {threads} threads; errors inside (N·V ≥ 0.2) against the exact picture in code values, \
         1/255 of linear intensity, before the display: values above 1 count in full; “shown” with them clamped to 1 where the \
         display clamps, as compare has it; * on the front of Pareto\n\n\
         {:19} {:12} {:>7} {:>10} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>8} {:>11}\n",
        "method",
        "interpolated",
        "n",
        "polygons",
        "RMS",
        "99 %",
        "greatest",
        "shown",
        "outline",
        "ms",
        "IQR ms",
        "evaluations"
    );
    for row in &found.rows {
        let setting = &row.setting;
        let codes = [row.error_rms, row.error_p99, row.error_max, row.error_rms_shown]
            .map(|error| format!("{:8.3}", 255.0 * error));
        let _ = writeln!(
            text,
            "{:19} {:12} {:>7} {:>10} {} {:>8} {:9.3} {:8.3} {:>11}{}",
            setting.method.name(),
            word(setting.interpolation),
            setting.n,
            format!("{}×{}", setting.segments, setting.rings),
            codes.join(" "),
            row.outline_pixels,
            row.time_ms,
            row.spread_ms,
            row.evaluations,
            if row.pareto { " *" } else { "" }
        );
    }
    text.push('\n');
    orders(&mut text, found);
    for omitted in &found.omitted {
        let how = word(omitted.interpolation);
        let _ = writeln!(text, "not measured: {} ({how}): {}", omitted.method.name(), omitted.reason);
    }
    text.push_str(
        "phong-scalar, taylor and angular are scalar text in one thread: compare their times with each other\n",
    );
    text
}

fn orders(text: &mut String, found: &Study) {
    let told =
        |fit: Option<Fit>| fit.map_or_else(|| "-".to_owned(), |f| format!("{:.2} ± {:.2}", f.slope, f.confidence));
    if found.series.iter().all(|series| series.order.is_none()) {
        return;
    }
    let _ = writeln!(
        text,
        "order in the spacing of the vertices (± 95 %)\n{:19} {:12} {:>7} {:>14} {:>14}",
        "method", "interpolated", "n", "greatest", "RMS"
    );
    for series in &found.series {
        let _ = writeln!(
            text,
            "{:19} {:12} {:>7} {:>14} {:>14}",
            series.method.name(),
            word(series.interpolation),
            series.n,
            told(series.order),
            told(series.order_rms)
        );
    }
    text.push('\n');
}
