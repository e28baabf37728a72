//! `profile`: the intensity along a line, as numbers, as a plot, or as a picture of what is perceived.

use super::analyse::{Asks, picture_name};
use super::failure::Failure;
use super::input::parse_choice;
use clap::{Args, ValueEnum};
use glam::DVec2;
use shading_lab::analysis::{
    PERCEIVED_WIDTH, Perception, ProfileQuestion, ResponseModel, Subject, Viewing, perceived_picture,
};
use shading_lab::document::{check_target, save_picture};
use shading_lab::scene::{Scene, ShadingMode};
use std::path::PathBuf;

#[derive(Args)]
pub struct Profile {
    /// Where the line begins, in pixels from the top left; a pixel's centre is at +0.5
    #[arg(long, value_name = "X,Y", value_parser = parse_place, allow_hyphen_values = true)]
    from: DVec2,
    /// Where it ends
    #[arg(long, value_name = "X,Y", value_parser = parse_place, allow_hyphen_values = true)]
    to: DVec2,
    /// The ways of shading that are compared
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_mode, default_value = "flat,gouraud,phong,exact")]
    modes: Vec<ShadingMode>,
    /// The whole picture as it is perceived, in the scene's own shading
    #[arg(long, value_name = "FILE.png", value_parser = picture_name())]
    picture: Option<PathBuf>,
    #[command(flatten)]
    eye: Eye,
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

impl Profile {
    fn modes(&self) -> Vec<ShadingMode> {
        let mut modes: Vec<ShadingMode> = Vec::new();
        for mode in &self.modes {
            if !modes.contains(mode) {
                modes.push(*mode);
            }
        }
        modes
    }
}

impl Asks for Profile {
    type Question = ProfileQuestion;
    const NAME: &'static str = "profile";
    const SIZES_FIGURE: bool = true;

    fn question(&self, scene: &mut Scene) -> Result<ProfileQuestion, Failure> {
        self.picture.as_deref().map_or(Ok(()), check_target)?;
        let (viewing, perception) = self.eye.checked()?;
        let [_, surround] = perception.widths(viewing.pixels_per_degree());
        if self.picture.is_some() && surround > PERCEIVED_WIDTH {
            let expected = format!("expected at most {PERCEIVED_WIDTH} for --picture");
            return Err(Failure::input(format!("--surround {}: {surround:.0} pixels, {expected}", self.eye.surround)));
        }
        let question = ProfileQuestion { from: self.from, to: self.to, modes: self.modes(), viewing, perception };
        let place = |p: DVec2| format!("{},{}", p.x, p.y);
        let refused = |error| Failure::input(format!("--from {} --to {}: {error}", place(self.from), place(self.to)));
        question.check(scene.image.size).map_err(refused)?;
        Ok(question)
    }

    fn also(&self, subject: &Subject) -> Result<bool, Failure> {
        let Some(path) = &self.picture else { return Ok(false) };
        let (viewing, perception) = self.eye.checked()?;
        let frame = perceived_picture(&mut subject.renderer(), &subject.scene, &viewing, &perception);
        save_picture(path, &frame, &subject.scene)?;
        Ok(true)
    }
}

/// `X,Y`, any numbers.
pub fn parse_place(text: &str) -> Result<DVec2, String> {
    let expected = || "expected X,Y in pixels from the top left, as in 100.5,80.5".to_owned();
    let (x, y) = text.split_once(',').ok_or_else(expected)?;
    let coordinate = |text: &str| text.trim().parse().ok().filter(|value: &f64| value.is_finite());
    Ok(DVec2::new(coordinate(x).ok_or_else(expected)?, coordinate(y).ok_or_else(expected)?))
}

fn parse_mode(text: &str) -> Result<ShadingMode, String> {
    let modes =
        [ShadingMode::Flat, ShadingMode::Interpolated, ShadingMode::Gouraud, ShadingMode::Phong, ShadingMode::Exact];
    parse_choice(text, modes)
}
