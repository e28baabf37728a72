//! `profile`: the intensity along a line, as numbers, as a plot, or as a picture of what is perceived.

use super::failure::Failure;
use super::input::SceneArguments;
use super::output::{print, print_json};
use super::sheet::{ending, figure_name, picture_name, write_plots, write_text};
use clap::{Args, ValueEnum};
use glam::DVec2;
use serde::Deserialize;
use serde::de::IntoDeserializer;
use serde::de::value::{Error, StrDeserializer};
use serde_json::{Map, Value, json};
use shading_lab::analysis::{
    PERCEIVED_WIDTH, Perception, Profile, ProfileError, ProfileRequest, ResponseModel, Viewing, perceived_picture,
    profile, profile_plots,
};
use shading_lab::document::{check_target, save_picture};
use shading_lab::render::Renderer;
use shading_lab::scene::{Scene, ShadingMode};
use std::path::PathBuf;

#[derive(Args)]
pub struct ProfileCommand {
    #[command(flatten)]
    scene: SceneArguments,
    /// Where the line begins, in pixels from the top left; a pixel's centre is at +0.5
    #[arg(long, value_name = "X,Y", value_parser = parse_place, allow_hyphen_values = true)]
    from: DVec2,
    /// Where it ends
    #[arg(long, value_name = "X,Y", value_parser = parse_place, allow_hyphen_values = true)]
    to: DVec2,
    /// The ways of shading that are compared
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_mode, default_value = "flat,gouraud,phong,exact")]
    modes: Vec<ShadingMode>,
    /// The plot, or the samples as .csv
    #[arg(short, long, value_name = "FILE.png|.svg|.csv", value_parser = figure_name())]
    output: Option<PathBuf>,
    /// The samples, a row each
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Print one JSON object with the samples and what happens at each border between polygons
    #[arg(long)]
    json: bool,
    /// The whole picture as it is perceived, in the scene's own shading
    #[arg(long, value_name = "FILE.png", value_parser = picture_name())]
    picture: Option<PathBuf>,
    #[command(flatten)]
    eye: Eye,
    /// Width and height of the plot in pixels
    #[arg(long, value_name = "WxH", value_parser = super::input::parse_size, default_value = "1600x1200")]
    size: [u32; 2],
    /// Light lines on a dark ground
    #[arg(long)]
    dark: bool,
}

/// Who looks at the screen, and from where.
#[derive(Args)]
struct Eye {
    /// From the eye to the screen, millimetres
    #[arg(long, value_name = "MM", default_value_t = Viewing::default().distance)]
    viewing_distance: f64,
    /// Pixels of the screen to a millimetre; 96 to an inch are 3.78
    #[arg(long, value_name = "PER_MM", default_value_t = Viewing::default().density)]
    density: f64,
    /// The model of the response
    #[arg(long, value_enum, default_value = "lateral-inhibition")]
    response: Response,
    /// Width σ of the receptive field's centre, degrees of visual angle
    #[arg(long, value_name = "DEGREES", default_value_t = Perception::default().centre)]
    centre: f64,
    /// Width σ of its surround, greater than the centre's
    #[arg(long, value_name = "DEGREES", default_value_t = Perception::default().surround)]
    surround: f64,
    /// Strength w of the inhibition
    #[arg(long, value_name = "W", default_value_t = Perception::default().weight)]
    weight: f64,
    /// The response at which normalisation halves a channel's gain
    #[arg(long, value_name = "RHO", default_value_t = Perception::default().saturation)]
    saturation: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Response {
    LateralInhibition,
    ResponseNormalisation,
}

impl Eye {
    fn checked(&self) -> Result<(Viewing, Perception), Failure> {
        within("--viewing-distance", self.viewing_distance, Viewing::DISTANCE)?;
        within("--density", self.density, Viewing::DENSITY)?;
        within("--centre", self.centre, Perception::WIDTH)?;
        within("--surround", self.surround, Perception::WIDTH)?;
        within("--weight", self.weight, Perception::WEIGHT)?;
        within("--saturation", self.saturation, Perception::SATURATION)?;
        if self.surround <= self.centre {
            let Self { centre, surround, .. } = self;
            return Err(Failure::input(format!("--surround {surround}: expected more than the centre's {centre}")));
        }
        let model = match self.response {
            Response::LateralInhibition => ResponseModel::LateralInhibition,
            Response::ResponseNormalisation => ResponseModel::ResponseNormalisation,
        };
        let Self { centre, surround, weight, saturation, .. } = *self;
        let viewing = Viewing { distance: self.viewing_distance, density: self.density };
        Ok((viewing, Perception { model, centre, surround, weight, saturation }))
    }
}

fn within(argument: &str, value: f64, [low, high]: [f64; 2]) -> Result<(), Failure> {
    if (low..=high).contains(&value) {
        return Ok(());
    }
    Err(Failure::input(format!("{argument} {value}: expected {low} to {high}")))
}

impl ProfileCommand {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let loaded = self.scene.load(earlier)?;
        let scene = &loaded.scene;
        for target in [&self.output, &self.csv, &self.picture].into_iter().flatten() {
            check_target(target)?;
        }
        let (viewing, perception) = self.eye.checked()?;
        let [_, surround] = perception.widths(viewing.pixels_per_degree());
        if self.picture.is_some() && surround > PERCEIVED_WIDTH {
            let expected = format!("expected at most {PERCEIVED_WIDTH} for --picture");
            return Err(Failure::input(format!("--surround {}: {surround:.0} pixels, {expected}", self.eye.surround)));
        }
        let mut modes: Vec<ShadingMode> = Vec::new();
        for mode in &self.modes {
            if !modes.contains(mode) {
                modes.push(*mode);
            }
        }
        let request = ProfileRequest { from: self.from, to: self.to, modes, viewing, perception };
        let mut renderer = Renderer::default();
        renderer.set_model(loaded.model);
        let taken = profile(&mut renderer, scene, &request).map_err(|error| self.refused(error))?;
        self.write(&taken, &request, scene)?;
        if let Some(picture) = &self.picture {
            save_picture(picture, &perceived_picture(&mut renderer, scene, &viewing, &perception), scene)?;
        }
        if self.json {
            return print_json(&object(&taken, &request));
        }
        let silent = self.output.is_some() || self.csv.is_some() || self.picture.is_some();
        if silent { Ok(()) } else { print(&taken.to_csv()) }
    }

    fn refused(&self, error: ProfileError) -> Failure {
        let place = |p: DVec2| format!("{},{}", p.x, p.y);
        Failure::input(format!("--from {} --to {}: {error}", place(self.from), place(self.to)))
    }

    fn write(&self, taken: &Profile, request: &ProfileRequest, scene: &Scene) -> Result<(), Failure> {
        if let Some(csv) = &self.csv {
            write_text(csv, &taken.to_csv())?;
        }
        match &self.output {
            None => Ok(()),
            Some(path) if ending(path) == "csv" => write_text(path, &taken.to_csv()),
            Some(path) => write_plots(path, &profile_plots(taken, request), self.size, self.dark, scene),
        }
    }
}

/// What `--json` prints.
fn object(taken: &Profile, request: &ProfileRequest) -> Value {
    let samples = taken.samples.iter().enumerate().map(|(i, sample)| {
        let mut row = Map::from_iter([
            ("x".to_owned(), json!(sample.x)),
            ("y".to_owned(), json!(sample.y)),
            ("t".to_owned(), json!(sample.t)),
        ]);
        for trace in &taken.traces {
            let mode = trace.word();
            row.insert(format!("{mode}_slope"), json!(trace.slope[i]));
            row.insert(format!("{mode}_perceived"), json!(trace.perceived[i]));
            row.insert(mode.to_owned(), json!(trace.intensity[i]));
        }
        Value::Object(row)
    });
    let borders = taken.borders.iter().enumerate().map(|(i, border)| {
        let mut row = json!(border);
        for trace in &taken.traces {
            row[trace.word()] = json!(trace.corners[i]);
        }
        row
    });
    json!({
        "from": request.from.to_array(),
        "to": request.to.to_array(),
        "length": taken.length,
        "modes": request.modes,
        "viewing": request.viewing,
        "perception": request.perception,
        "widths": taken.widths,
        "borders": borders.collect::<Vec<_>>(),
        "samples": samples.collect::<Vec<_>>(),
    })
}

/// `X,Y`, any numbers.
pub fn parse_place(text: &str) -> Result<DVec2, String> {
    let expected = || "expected X,Y in pixels from the top left, as in 100.5,80.5".to_owned();
    let (x, y) = text.split_once(',').ok_or_else(expected)?;
    let coordinate = |text: &str| text.trim().parse().ok().filter(|value: &f64| value.is_finite());
    Ok(DVec2::new(coordinate(x).ok_or_else(expected)?, coordinate(y).ok_or_else(expected)?))
}

fn parse_mode(text: &str) -> Result<ShadingMode, String> {
    let word: StrDeserializer<'_, Error> = text.trim().into_deserializer();
    ShadingMode::deserialize(word).map_err(|_| "expected flat, interpolated, gouraud, phong or exact".to_owned())
}
