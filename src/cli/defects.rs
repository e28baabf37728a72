//! `defects`: the five defects of interpolated shading, as numbers.

use super::analyse::Asks;
use super::failure::Failure;
use super::input::{inside_picture, parse_pixel};
use clap::Args;
use shading_lab::analysis::DefectsQuestion;
use shading_lab::scene::Scene;

#[derive(Args)]
pub struct Defects {
    /// The pixel whose point is followed while the picture turns; otherwise a lit one near the middle
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pixel: Option<[u32; 2]>,
}

impl Asks for Defects {
    type Question = DefectsQuestion;
    const NAME: &'static str = "defects";

    fn question(&self, scene: &mut Scene) -> Result<DefectsQuestion, Failure> {
        self.pixel.map_or(Ok(()), |pixel| inside_picture("--pixel", pixel, scene.image.size))?;
        Ok(DefectsQuestion { pixel: self.pixel })
    }
}
