//! `scanline`: one polygon's conversion to pixels, step by step, as a figure, as data or in words.

use super::analyse::Asks;
use super::failure::Failure;
use super::input::{inside_picture, parse_pixel};
use clap::Args;
use shading_lab::analysis::{Scan, ScanQuestion, Stop};
use shading_lab::scene::Scene;

#[derive(Args)]
pub struct Scanline {
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
    #[arg(long, value_name = "K|last", value_parser = |text: &str| parse_stop(text, |k| Stop::Step(k as usize)), conflicts_with = "line")]
    step: Option<Stop>,
    /// The scan line that is shown, finished: a row of the grid, or `last`
    #[arg(long, value_name = "Y|last", value_parser = |text: &str| parse_stop(text, Stop::Line))]
    line: Option<Stop>,
}

fn parse_stop(text: &str, stop: fn(u32) -> Stop) -> Result<Stop, String> {
    match text.trim() {
        "last" => Ok(Stop::Last),
        number => number.parse().map(stop).map_err(|_| "expected a whole number from 0, or last".to_owned()),
    }
}

impl Asks for Scanline {
    type Question = ScanQuestion;
    const NAME: &'static str = "scanline";
    const SIZES_FIGURE: bool = true;

    fn question(&self, scene: &mut Scene) -> Result<ScanQuestion, Failure> {
        if let Some([x, y]) = self.pixel {
            inside_picture(&format!("--pixel {x},{y}"), [x, y], scene.image.size)?;
        }
        let stop = self.step.or(self.line).unwrap_or_default();
        Ok(ScanQuestion { face: self.face, pixel: self.pixel, rows: self.rows, stop })
    }
}
