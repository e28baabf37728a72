//! `normals`: the faces that a vertex normal comes from, and their weights.

use super::analyse::Asks;
use super::failure::Failure;
use super::input::{inside_picture, parse_pixel};
use super::overlay::parse_vertex;
use clap::Args;
use shading_lab::analysis::NormalsQuestion;
use shading_lab::scene::Scene;

#[derive(Args)]
pub struct Normals {
    /// The vertex, by its number from 0
    #[arg(long, value_name = "I", value_parser = parse_vertex, conflicts_with = "pixel", allow_hyphen_values = true)]
    vertex: Option<u32>,
    /// The seen vertex next to this pixel; with neither it is the one next to the picture's middle
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: Option<[u32; 2]>,
}

impl Asks for Normals {
    type Question = NormalsQuestion;
    const NAME: &'static str = "normals";

    fn question(&self, scene: &mut Scene) -> Result<NormalsQuestion, Failure> {
        self.pixel.map_or(Ok(()), |pixel| inside_picture("--pixel", pixel, scene.image.size))?;
        Ok(NormalsQuestion { vertex: self.vertex, pixel: self.pixel })
    }
}
