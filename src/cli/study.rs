//! `study`: error against run time.

mod text;

use super::failure::Failure;
use super::input::{SceneArguments, nanoseconds, parse_size};
use super::output::{print, print_json, progress_bar};
use super::sheet::{ending, figure_name, write_drawing, write_text};
use clap::{Args, ValueEnum};
use glam::DVec2;
use serde_json::{Map, Value, json};
use shading_lab::analysis::{Fit, Method, Progress, Series, Study, StudyRequest, study, study_plot};
use shading_lab::figure::{Paper, PlotStyle, lay_out};
use shading_lab::scene::{Interpolation, Object, Scene};
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

/// Pixels of the plot, and of its letters: the legend has many lines.
const SHEET: [f64; 2] = [1600.0, 1100.0];
const LETTERS: f64 = 26.0;

/// How values between vertices are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Way {
    /// Linear on the polygon in space
    Perspective,
    /// Linear on the triangle in the picture
    Affine,
    /// Along edges and scan lines in the picture
    Scanline,
}

impl From<Way> for Interpolation {
    fn from(way: Way) -> Self {
        match way {
            Way::Perspective => Self::Perspective,
            Way::Affine => Self::Affine,
            Way::Scanline => Self::Scanline,
        }
    }
}

#[derive(Args)]
pub struct StudyCommand {
    #[command(flatten)]
    scene: SceneArguments,
    /// Ways of shading between commas, all unless given: flat, flat-vertex-mean, interpolated, gouraud, phong,
    /// phong-unnormalised; in scalar text phong-scalar, taylor (Bishop and Weimer 1986), angular (Kuijk and Blake 1989)
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_method)]
    methods: Vec<Method>,
    /// Polygons round the axis, between commas; those along it go with them
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "8,16,32,64,128,256",
          value_parser = clap::value_parser!(u32).range(3..=i64::from(Object::MAX_DIVISIONS)))]
    segments: Vec<u32>,
    /// Exponents of the highlight, between commas; the scene's own unless given
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    n: Vec<f64>,
    /// How values between vertices are found, between commas
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_enum, default_value = "perspective,affine")]
    interpolation: Vec<Way>,
    /// Width and height in pixels, instead of the scene's
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// Frames timed for each setting
    #[arg(long, value_name = "N", default_value_t = 9, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    repeats: u32,
    /// Threads of the engine; one for each core unless given. With 1 its times and those of the scalar text differ by the
    /// text alone
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// The rows as a table
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// The plot: error over time, both logarithmic, with the front of Pareto
    #[arg(short, long, value_name = "FILE.png|.svg", value_parser = figure_name())]
    output: Option<PathBuf>,
    /// Light lines on a dark ground
    #[arg(long)]
    dark: bool,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

fn parse_method(text: &str) -> Result<Method, String> {
    let names = Method::ALL.map(Method::name).join(", ");
    Method::named(text.trim()).ok_or_else(|| format!("expected one of {names}"))
}

impl StudyCommand {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        if self.output.as_deref().is_some_and(|path| ending(path) == "csv") {
            return Err(Failure::input("--output: expected a name that ends in .png or .svg; --csv writes the table"));
        }
        let mut loaded = self.scene.load(earlier)?;
        let scene = &mut loaded.scene;
        scene.image.size = self.size.unwrap_or(scene.image.size);
        self.check_exponents(scene)?;
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(self.threads.map_or(0, usize::from))
            .build()
            .map_err(|error| Failure::work(format!("the threads cannot be started ({error})")))?;
        let request = self.request();
        let bar = progress_bar(0, "measuring");
        let mut progress = |at: Progress<'_>| {
            bar.set_length(at.total);
            bar.set_position(at.done);
        };
        let never = AtomicBool::new(false);
        let found = pool.install(|| study(scene, loaded.model.clone(), &request, nanoseconds, &mut progress, &never));
        bar.finish_and_clear();
        if found.rows.is_empty() {
            return Err(Failure::input(nothing(&found)));
        }
        self.write(&found, scene)?;
        if self.json {
            return print_json(&json(&found, &loaded.name, scene, pool.current_num_threads()));
        }
        if self.output.is_some() || self.csv.is_some() {
            return Ok(());
        }
        print(&text::table(&found, &loaded.name, scene, pool.current_num_threads()))
    }

    fn request(&self) -> StudyRequest {
        StudyRequest {
            methods: if self.methods.is_empty() { Method::ALL.to_vec() } else { self.methods.clone() },
            segments: self.segments.clone(),
            interpolations: self.interpolation.iter().copied().map(Interpolation::from).collect(),
            n: self.n.clone(),
            repeats: self.repeats,
        }
    }

    fn check_exponents(&self, scene: &Scene) -> Result<(), Failure> {
        for n in &self.n {
            let mut tried = scene.clone();
            tried.material.n = *n;
            tried.validate().map_err(|error| Failure::input(format!("--n {n}: {error}")))?;
        }
        Ok(())
    }

    fn write(&self, found: &Study, scene: &Scene) -> Result<(), Failure> {
        if let Some(path) = &self.csv {
            write_text(path, &text::csv(found))?;
        }
        let Some(path) = &self.output else { return Ok(()) };
        let plot = study_plot(found)
            .ok_or_else(|| Failure::input("nothing to plot: no setting has an error above 0 inside the outline"))?;
        let paper = if self.dark { Paper::DARK } else { Paper::LIGHT };
        let style = PlotStyle { paper, text: LETTERS, titled: true };
        write_drawing(path, &lay_out(&plot, DVec2::from_array(SHEET), &style), &plot.title, scene)
    }
}

/// Why nothing was measured.
fn nothing(found: &Study) -> String {
    match found.omitted.first() {
        Some(omitted) => {
            format!("nothing to measure: {} cannot draw this scene, {}", omitted.method.name(), omitted.reason)
        }
        None => "nothing to measure: the shape takes none of these --segments".to_owned(),
    }
}

/// What `--json` prints.
fn json(found: &Study, name: &str, scene: &Scene, threads: usize) -> Value {
    let orders = |of: fn(&Series) -> Option<Fit>, value: fn(Fit) -> f64| -> Map<String, Value> {
        let one = |method: Method| Some((method.name().to_owned(), json!(value(of(found.series_of(method)?)?))));
        Method::ALL.into_iter().filter_map(one).collect()
    };
    let costs: Map<String, Value> =
        Method::ALL.into_iter().map(|method| (method.name().to_owned(), json!(method.pixel_cost()))).collect();
    json!({
        "scene": name,
        "size": scene.image.size,
        "threads": threads,
        "rows": found.rows,
        "orders": orders(|series| series.order, |fit| fit.slope),
        "order_confidence": orders(|series| series.order, |fit| fit.confidence),
        "orders_rms": orders(|series| series.order_rms, |fit| fit.slope),
        "order_rms_confidence": orders(|series| series.order_rms, |fit| fit.confidence),
        "series": found.series,
        "omitted": found.omitted,
        "pixel_cost": costs,
    })
}
