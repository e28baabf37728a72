//! `defects`: the five defects of interpolated shading, as numbers.

use super::failure::Failure;
use super::input::{SceneArguments, inside_picture, parse_pixel, parse_size};
use super::output::{print, print_json, progress_bar};
use super::sheet::{ending, figure_name, write_plots, write_text};
use super::telling::telling_pixel;
use clap::Args;
use serde_json::json;
use shading_lab::analysis::{Defects, Finding, defect_plots, defects_with_progress};
use shading_lab::render::Renderer;
use shading_lab::scene::{Interpolation, Scene};
use shading_lab::table::Table;
use std::fmt::Write;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

#[derive(Args)]
pub struct DefectsCommand {
    #[command(flatten)]
    scene: SceneArguments,
    /// The pixel whose point is followed while the picture turns; otherwise a lit one near the middle
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pixel: Option<[u32; 2]>,
    /// Width and height in pixels, instead of the scene's
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// The curves (the point while the picture turns, both sides of the edge) as a plot, or as a table
    #[arg(short, long, value_name = "FILE.png|.svg|.csv", value_parser = figure_name())]
    output: Option<PathBuf>,
    /// Light lines on a dark ground
    #[arg(long)]
    dark: bool,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

/// Pixels of the sheet of plots.
const SHEET: [u32; 2] = [1600, 900];

impl DefectsCommand {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let mut loaded = self.scene.load(earlier)?;
        let scene = &mut loaded.scene;
        scene.image.size = self.size.unwrap_or(scene.image.size);
        if let Some(pixel) = self.pixel {
            inside_picture("--pixel", pixel, scene.image.size)?;
        }
        let mut renderer = Renderer::default();
        renderer.set_model(loaded.model);
        let pixel = self.pixel.unwrap_or_else(|| {
            renderer.render(scene);
            telling_pixel(&mut renderer, scene).pixel
        });
        let measured = measured(&mut renderer, scene, pixel);
        if let Some(path) = &self.output {
            if ending(path) == "csv" {
                write_text(path, &csv(&measured))?;
            } else {
                let plots = defect_plots(&measured);
                if plots.is_empty() {
                    return Err(Failure::input("nothing to plot: neither of the two curves can be measured here"));
                }
                write_plots(path, &plots, SHEET, self.dark, scene)?;
            }
        }
        if self.json {
            return print_json(
                &json!({ "scene": loaded.name, "size": scene.image.size, "pixel": pixel, "defects": measured }),
            );
        }
        if self.output.is_some() { Ok(()) } else { print(&text(&loaded.name, scene.image.size, &measured)) }
    }
}

/// Measures, with a bar for how far it is.
fn measured(renderer: &mut Renderer, scene: &Scene, pixel: [u32; 2]) -> Defects {
    let bar = progress_bar(100, "measuring");
    let mut progress = |share: f32| bar.set_position((100.0 * share) as u64);
    let never = AtomicBool::new(false);
    let measured = defects_with_progress(renderer, scene, pixel, &mut progress, &never);
    bar.finish_and_clear();
    measured
}

/// The samples of the curves, one table after the other in columns of their own.
fn csv(measured: &Defects) -> String {
    let mut table = Table::new("curve,x,first,second");
    if let Ok(orientation) = &measured.orientation {
        for turned in &orientation.samples {
            let value = |value: Option<f64>| value.map_or_else(String::new, |v| v.to_string());
            let (along, across) = (value(turned.scanline), value(turned.barycentric));
            table.row(&[&"orientation", &turned.angle, &along, &across]);
        }
    }
    if let Ok(shared) = &measured.shared_vertices {
        for [place, without, with] in &shared.samples {
            table.row(&[&"shared-vertices", place, without, with]);
        }
    }
    table.into_csv()
}

fn text(name: &str, [width, height]: [u32; 2], measured: &Defects) -> String {
    let mut text = format!("{name}: {width}×{height}; linear intensity, 1 is white\n\n");
    let mut line = |title: &str, words: String| {
        let _ = writeln!(text, "{title:32}{words}");
    };
    line(
        "polygonal silhouette",
        said(&measured.silhouette, |s| {
            format!("{:.2} pixels from the true outline, at {:.0},{:.0}", s.greatest, s.polygon.x, s.polygon.y)
        }),
    );
    line(
        "perspective distortion",
        said(&measured.perspective, |p| {
            let what = match p.interpolation {
                Interpolation::Scanline => "scan-line",
                _ => "affine",
            };
            let at = p.error.at.map_or_else(String::new, |[x, y]| format!(", at {x},{y}"));
            let (mean, greatest) = (p.error.mean, p.error.greatest);
            format!("{what} against perspective-correct: mean {mean:.5}, greatest {greatest:.5}{at}")
        }),
    );
    line(
        "dependence on orientation",
        said(&measured.orientation, |o| {
            let [scanline, barycentric] = o.spread;
            format!(
                "{scanline:.5} along the scan line while the picture turns, {barycentric:.5} with barycentric weights"
            )
        }),
    );
    line(
        "vertices that are not shared",
        said(&measured.shared_vertices, |s| {
            let edges = s.edges_in_words();
            format!("{edges}; greatest jump {:.5}, at {:.0},{:.0}", s.greatest, s.at.x, s.at.y)
        }),
    );
    line(
        "unrepresentative vertex normals",
        said(&measured.vertex_normals, |v| {
            let (angle, contrast, truth) = (v.greatest_angle, v.contrast, v.true_contrast);
            format!("up to {angle:.1}° off the polygon's; contrast {contrast:.4}, true {truth:.4}")
        }),
    );
    text
}

fn said<T>(finding: &Finding<T>, words: impl Fn(&T) -> String) -> String {
    match finding {
        Ok(measured) => words(measured),
        Err(why) => format!("- ({why})"),
    }
}
