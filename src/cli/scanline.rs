//! `scanline`: one polygon's conversion to pixels, step by step, as a figure, as data or in words.

use super::failure::Failure;
use super::input::{SceneArguments, inside_picture, parse_pixel, parse_size};
use super::output::{print, print_json};
use super::sheet::{ending, figure_name, write_drawing, write_text};
use super::telling::telling_pixel;
use clap::Args;
use glam::DVec2;
use serde::Serialize;
use shading_lab::analysis::{Scan, face_at, lay_out_scan, scan};
use shading_lab::document::check_target;
use shading_lab::figure::{Paper, PlotStyle};
use shading_lab::render::Renderer;
use shading_lab::scene::Scene;
use std::path::PathBuf;

/// Ems to the height of a figure: its column of formulas must fit.
const LINES: f64 = 37.0;
/// Ems to its width.
const LETTERS: f64 = 48.0;

#[derive(Args)]
pub struct Scanline {
    #[command(flatten)]
    scene: SceneArguments,
    /// The polygon that this pixel sees, otherwise one near the middle that is lit
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true, conflicts_with = "face")]
    pixel: Option<[u32; 2]>,
    /// The polygon by its index in the mesh
    #[arg(long, value_name = "F")]
    face: Option<u32>,
    /// Rows of enlarged pixels, 8 to 64
    #[arg(long, value_name = "N", default_value_t = Scan::USUAL_ROWS)]
    rows: u32,
    /// The step that is shown, counted from 0, or `last`; otherwise the pixel asked for, or one in the middle
    #[arg(long, value_name = "K|last", value_parser = parse_count, conflicts_with = "line")]
    step: Option<Count>,
    /// The scan line that is shown, finished: a row of the grid, or `last`
    #[arg(long, value_name = "Y|last", value_parser = parse_count)]
    line: Option<Count>,
    /// The figure, or the pixels as .csv
    #[arg(short, long, value_name = "FILE.png|.svg|.csv", value_parser = figure_name())]
    output: Option<PathBuf>,
    /// The pixels, a row each
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Print one JSON object with everything: the grid, the edge table, lines, pixels, and the order of the steps
    #[arg(long)]
    json: bool,
    /// Width and height of the figure in pixels
    #[arg(long, value_name = "WxH", value_parser = parse_size, default_value = "1600x1100")]
    size: [u32; 2],
    /// Light lines on a dark ground
    #[arg(long)]
    dark: bool,
}

/// Which of several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Count {
    Nth(u32),
    Last,
}

/// What `--json` prints.
#[derive(Serialize)]
struct Printed<'a> {
    step: usize,
    #[serde(flatten)]
    scan: &'a Scan,
}

impl Scanline {
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
        let (face, place) = self.face(&mut renderer, scene)?;
        let taken = scan(&mut renderer, scene, face, self.rows).map_err(|error| Failure::input(error.to_string()))?;
        let step = self.step(&taken, place)?;
        if let Some(csv) = &self.csv {
            write_text(csv, &taken.to_csv())?;
        }
        self.write(&taken, step, scene)?;
        if self.json {
            return print_json(&Printed { step, scan: &taken });
        }
        if self.output.is_none() && self.csv.is_none() { print(&taken.line_text(step)) } else { Ok(()) }
    }

    /// The polygon asked for, and the place of the picture that led to it.
    fn face(&self, renderer: &mut Renderer, scene: &Scene) -> Result<(u32, Option<DVec2>), Failure> {
        if let Some(face) = self.face {
            return Ok((face, None));
        }
        let [x, y] = self.pixel.unwrap_or_else(|| telling_pixel(renderer, scene).pixel);
        let seen = face_at(renderer, scene, x, y).ok_or_else(|| {
            Failure::input(format!("pixel {x},{y} shows the background, expected one that shows the object"))
        })?;
        Ok((seen, Some(DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5))))
    }

    fn step(&self, taken: &Scan, place: Option<DVec2>) -> Result<usize, Failure> {
        let last = taken.last();
        match (self.step, self.line) {
            (Some(Count::Last), _) | (_, Some(Count::Last)) => Ok(last),
            (Some(Count::Nth(step)), _) => {
                let step = step as usize;
                let expected = || Failure::input(format!("--step {step}: no such step, expected 0 to {last} or last"));
                if step <= last { Ok(step) } else { Err(expected()) }
            }
            (_, Some(Count::Nth(y))) => {
                let [first, end] = [taken.lines.first(), taken.lines.last()].map(|line| line.map_or(0, |line| line.y));
                let expected =
                    || format!("--line {y}: not a scan line of the polygon, expected {first} to {end} or last");
                taken.steps_of_line(y).map(|[_, end]| end).ok_or_else(|| Failure::input(expected()))
            }
            (None, None) => {
                let middle = DVec2::new(f64::from(taken.grid.columns), f64::from(taken.grid.rows)) * 0.5;
                Ok(taken.step_near(place.map_or(middle, |place| taken.grid.from_picture(place))))
            }
        }
    }

    fn write(&self, taken: &Scan, step: usize, scene: &Scene) -> Result<(), Failure> {
        let Some(path) = &self.output else { return Ok(()) };
        if ending(path) == "csv" {
            return write_text(path, &taken.to_csv());
        }
        let size = DVec2::from_array(self.size.map(f64::from));
        let paper = if self.dark { Paper::DARK } else { Paper::LIGHT };
        let text = (size.x / LETTERS).min(size.y / LINES).max(7.0);
        let drawing = lay_out_scan(taken, step, size, &PlotStyle { paper, text, titled: true });
        write_drawing(path, &drawing, &format!("The scan line in slow motion: {}", taken.caption(step)), scene)
    }
}

fn parse_count(text: &str) -> Result<Count, String> {
    match text.trim() {
        "last" => Ok(Count::Last),
        number => number.parse().map(Count::Nth).map_err(|_| "expected a whole number from 0, or last".to_owned()),
    }
}
