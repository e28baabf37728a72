//! `curves`: the plots of local illumination, as a figure, as data or in words.

use super::analyse::Asks;
use super::failure::Failure;
use super::input::{inside_picture, parse_choice, parse_pixel};
use clap::Args;
use shading_lab::analysis::{CurvesQuestion, PlotKind};
use shading_lab::scene::Scene;

#[derive(Args)]
pub struct Curves {
    /// Which plot: attenuation, exponent, reflectance or lobe; without it all that the scene has, f and W only where they vary
    #[arg(long, value_parser = parse_kind)]
    kind: Option<PlotKind>,
    /// The pixel whose values are marked, otherwise a lit one near the middle whose vectors are well apart
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: Option<[u32; 2]>,
    /// The light whose attenuation and lobe are plotted, counted from 0; otherwise the first that the point faces
    #[arg(long, value_name = "I")]
    light: Option<usize>,
}

fn parse_kind(text: &str) -> Result<PlotKind, String> {
    parse_choice(text, PlotKind::ALL)
}

impl Asks for Curves {
    type Question = CurvesQuestion;
    const NAME: &'static str = "curves";
    const SIZES_FIGURE: bool = true;

    fn question(&self, scene: &mut Scene) -> Result<CurvesQuestion, Failure> {
        if let Some([x, y]) = self.pixel {
            inside_picture(&format!("--pixel {x},{y}"), [x, y], scene.image.size)?;
        }
        Ok(CurvesQuestion { kind: self.kind, pixel: self.pixel, light: self.light })
    }
}
