//! `curves`: the plots of local illumination, as a figure, as data or in words.

use super::failure::Failure;
use super::input::{SceneArguments, inside_picture, parse_pixel, parse_size};
use super::output::{print, print_json};
use super::sheet::{ending, figure_name, write_plots, write_text};
use super::telling::telling_pixel;
use clap::{Args, ValueEnum};
use serde::Serialize;
use shading_lab::analysis::{Plot, PlotKind, Probe, curves, probe};
use shading_lab::document::check_target;
use shading_lab::render::Renderer;
use shading_lab::scene::Scene;
use shading_lab::table::Table;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Pixels of a figure of one plot, of two and of more, unless another size is asked for.
const SIZES: [[u32; 2]; 3] = [[1280, 800], [1920, 760], [1920, 1280]];

#[derive(Args)]
pub struct Curves {
    #[command(flatten)]
    scene: SceneArguments,
    /// Which plot; without it all that the scene has, f and W only where they vary
    #[arg(long, value_enum)]
    kind: Option<Kind>,
    /// The pixel whose values are marked, otherwise a lit one near the middle whose vectors are well apart
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: Option<[u32; 2]>,
    /// The light whose attenuation and lobe are plotted, counted from 0; otherwise the first that the point faces
    #[arg(long, value_name = "I")]
    light: Option<usize>,
    /// The figure, or the samples as .csv
    #[arg(short, long, value_name = "FILE.png|.svg|.csv", value_parser = figure_name())]
    output: Option<PathBuf>,
    /// The samples, a row each
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Print one JSON object with everything that is plotted
    #[arg(long)]
    json: bool,
    /// Width and height of the figure in pixels
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// Light lines on a dark ground
    #[arg(long)]
    dark: bool,
}

/// What can be plotted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Kind {
    Exponent,
    Attenuation,
    Reflectance,
    Lobe,
}

impl From<Kind> for PlotKind {
    fn from(kind: Kind) -> Self {
        match kind {
            Kind::Exponent => Self::Exponent,
            Kind::Attenuation => Self::Attenuation,
            Kind::Reflectance => Self::Reflectance,
            Kind::Lobe => Self::Lobe,
        }
    }
}

/// What `--json` prints.
#[derive(Serialize)]
struct Printed<'a> {
    pixel: [u32; 2],
    light: usize,
    plots: &'a [Plot],
}

impl Curves {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let loaded = self.scene.load(earlier)?;
        let scene = &loaded.scene;
        for target in [&self.output, &self.csv].into_iter().flatten() {
            check_target(target)?;
        }
        if let Some([x, y]) = self.pixel {
            inside_picture(&format!("--pixel {x},{y}"), [x, y], scene.image.size)?;
        }
        let mut renderer = Renderer::default();
        renderer.set_model(loaded.model);
        let probed = match self.pixel {
            Some([x, y]) => probe(&mut renderer, scene, x, y),
            None => telling_pixel(&mut renderer, scene),
        };
        let light = self.light(scene, &probed)?;
        let plots = self.plots(&renderer, scene, &probed, light)?;
        if let Some(output) = &self.output {
            self.write(output, &plots, scene)?;
        }
        if let Some(csv) = &self.csv {
            write_text(csv, &rows(&plots))?;
        }
        if self.json {
            return print_json(&Printed { pixel: probed.pixel, light, plots: &plots });
        }
        if self.output.is_none() && self.csv.is_none() { print(&described(&plots, &probed)) } else { Ok(()) }
    }

    /// The light asked for, or the first that the point faces.
    fn light(&self, scene: &Scene, probed: &Probe) -> Result<usize, Failure> {
        let count = scene.lights.len();
        match self.light {
            Some(light) if light >= count => {
                let expected = if count == 0 { "no light at all".into() } else { format!("0 to {}", count - 1) };
                Err(Failure::input(format!("--light {light}: no such light in the scene, which has {expected}")))
            }
            Some(light) => Ok(light),
            None => {
                let hit = probed.hit.as_ref();
                Ok(hit.and_then(|hit| hit.lights.iter().position(|terms| terms.n_dot_l > 0.0)).unwrap_or(0))
            }
        }
    }

    fn plots(&self, renderer: &Renderer, scene: &Scene, probed: &Probe, light: usize) -> Result<Vec<Plot>, Failure> {
        let plot = |kind| curves::plot(kind, renderer, scene, probed, light);
        let Some(kind) = self.kind.map(PlotKind::from) else {
            return Ok(curves::telling(scene, light).into_iter().filter_map(plot).collect());
        };
        let [x, y] = probed.pixel;
        let missing = match (kind, &probed.hit) {
            (PlotKind::Lobe, None) => format!("pixel {x},{y} shows the background, expected one that shows the object"),
            (PlotKind::Lobe, Some(_)) if light < scene.lights.len() => {
                format!("light {light} does not reach pixel {x},{y} from the front, expected one that does")
            }
            _ => "the scene has no light, expected one".to_owned(),
        };
        plot(kind).map(|plot| vec![plot]).ok_or_else(|| Failure::input(missing))
    }

    fn write(&self, path: &Path, plots: &[Plot], scene: &Scene) -> Result<(), Failure> {
        if ending(path) == "csv" {
            return write_text(path, &rows(plots));
        }
        let size = self.size.unwrap_or(SIZES[plots.len().clamp(1, 3) - 1]);
        write_plots(path, plots, size, self.dark, scene)
    }
}

/// A row for each sample of each curve.
fn rows(plots: &[Plot]) -> String {
    let mut table = Table::new("plot,curve,x,y");
    for plot in plots {
        let kind = word(plot.kind);
        for curve in &plot.curves {
            let name = curve.name.replace(", now", "");
            for [x, y] in &curve.points {
                table.row(&[&kind, &name, x, y]);
            }
        }
    }
    table.into_csv()
}

fn word(kind: PlotKind) -> String {
    serde_json::to_value(kind).ok().and_then(|word| word.as_str().map(str::to_owned)).unwrap_or_default()
}

/// What the plots say, in words and numbers.
fn described(plots: &[Plot], probed: &Probe) -> String {
    let [x, y] = probed.pixel;
    let mut text = format!("at pixel ({x}, {y})\n");
    for plot in plots {
        let _ = writeln!(text, "\n{}: {}\n  {}", word(plot.kind), plot.title, plot.note);
        let columns = |name: &str, cells: &[String]| {
            let cells: String = cells.iter().map(|cell| format!("{cell:>12}")).collect();
            format!("  {name:20}{cells}\n")
        };
        if !plot.legend.is_empty() {
            text += &columns("", &plot.legend);
            text.extend(plot.curves.iter().map(|curve| columns(&curve.name, &curve.notes)));
        }
        for mark in &plot.marks {
            let _ = writeln!(text, "  {}", mark.label);
        }
        for direction in &plot.directions {
            let _ = writeln!(text, "  {:20}{:11.1}° from N", direction.letter, direction.angle);
        }
    }
    text
}
