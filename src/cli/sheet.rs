//! Plots and tables as files.

use super::failure::Failure;
use clap::builder::{PathBufValueParser, TypedValueParser};
use glam::DVec2;
use shading_lab::analysis::Plot;
use shading_lab::document::{SaveError, WriteError, save_picture, write_whole};
use shading_lab::figure::{Drawing, Paper, PlotStyle, lay_out_sheet};
use shading_lab::scene::Scene;
use std::path::{Path, PathBuf};

/// Writes plots on one sheet of `size`, as SVG where the name says so, otherwise as PNG with the scene inside.
pub fn write_plots(path: &Path, plots: &[Plot], size: [u32; 2], dark: bool, scene: &Scene) -> Result<(), Failure> {
    let [width, height] = size;
    let paper = if dark { Paper::DARK } else { Paper::LIGHT };
    let style = PlotStyle::of(size, plots.len(), paper);
    let drawing = lay_out_sheet(plots, DVec2::new(width.into(), height.into()), &style);
    let titles: Vec<&str> = plots.iter().map(|plot| plot.title.as_str()).collect();
    write_drawing(path, &drawing, &titles.join("; "), scene)
}

/// Writes a drawing as SVG where the name says so, otherwise as PNG with the scene inside.
pub fn write_drawing(path: &Path, drawing: &Drawing, title: &str, scene: &Scene) -> Result<(), Failure> {
    if ending(path) == "svg" {
        return write_text(path, &drawing.to_svg(title));
    }
    let frame = drawing.to_frame().ok_or_else(|| Failure::work("the figure is too large"))?;
    Ok(save_picture(path, &frame, scene)?)
}

/// Writes a text whole or not at all.
pub fn write_text(path: &Path, text: &str) -> Result<(), Failure> {
    let written: Result<(), SaveError> =
        write_whole(path, |out| out.write_all(text.as_bytes()).map_err(WriteError::Io));
    Ok(written?)
}

/// What a name ends in, without its dot.
pub fn ending(path: &Path) -> String {
    path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default()
}

/// The argument that names a figure or a table.
pub fn figure_name() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| match ending(&path).as_str() {
        "png" | "svg" | "csv" => Ok(path),
        _ => Err("expected a name that ends in .png, .svg or .csv"),
    })
}

/// The argument that names a picture: its ending says PNG, or it is a device or a pipe.
pub fn picture_name() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| {
        let device = path.metadata().is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir());
        if device || ending(&path) == "png" { Ok(path) } else { Err("expected a name that ends in .png") }
    })
}
