//! `probe`: the equation at one pixel, filled in.

use super::analyse::Asks;
use super::failure::Failure;
use super::input::{inside_picture, parse_pixel};
use clap::Args;
use shading_lab::analysis::ProbeQuestion;
use shading_lab::scene::Scene;

#[derive(Args)]
pub struct Probe {
    /// The pixel, (0,0) top left
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: [u32; 2],
}

impl Asks for Probe {
    type Question = ProbeQuestion;
    const NAME: &'static str = "probe";

    fn question(&self, scene: &mut Scene) -> Result<ProbeQuestion, Failure> {
        let [x, y] = self.pixel;
        inside_picture(&format!("--pixel {x},{y}"), self.pixel, scene.image.size)?;
        Ok(ProbeQuestion { pixel: self.pixel })
    }
}
