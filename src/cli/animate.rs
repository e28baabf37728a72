//! `animate`: changes a scene's numbers from one value to another, as an animated PNG, a GIF or numbered pictures.

use super::input::{SceneArguments, output_ending_in, parse_size, whole};
use super::output::{Failure, check_picture_target, progress_bar};
use clap::Args;
use shading_lab::analysis::comparison::{Captions, comparison_sheet, draw_panes, panes_on_sheet};
use shading_lab::animation::{
    Course, FilmFormat, MOST_FRAMES, Sweep, SweepError, USUAL_FRAMES, USUAL_RATE,
};
use shading_lab::document::{check_target, save_film, save_picture};
use shading_lab::render::{Frame, Renderer, check_memory_for};
use shading_lab::scene::Scene;
use shading_lab::text::text;
use std::convert::Infallible;
use std::path::{Path, PathBuf};

#[derive(Args)]
pub struct Animate {
    #[command(flatten)]
    scene: SceneArguments,
    #[arg(
        long,
        value_name = "KEY=A",
        required = true,
        allow_hyphen_values = true
    )]
    set_from: Vec<String>,
    #[arg(
        long,
        value_name = "KEY=B",
        required = true,
        allow_hyphen_values = true
    )]
    set_to: Vec<String>,
    #[arg(long, value_name = "N", default_value_t = USUAL_FRAMES, value_parser = whole::<u32>(2..=MOST_FRAMES))]
    frames: u32,
    #[arg(long)]
    logarithmic: bool,
    #[arg(long)]
    back_and_forth: bool,
    #[arg(long, value_name = "S", conflicts_with = "fps")]
    seconds: Option<f64>,
    #[arg(long, value_name = "N")]
    fps: Option<f64>,
    #[arg(short, long, value_name = "FILE", value_parser = output_ending_in(&["png", "apng", "gif"], "cli-expected-film"))]
    output: PathBuf,
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = whole::<u32>(1..=super::render::MAX_SAMPLES))]
    samples: u32,
}

impl Animate {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let mut loaded = self.scene.load(earlier)?;
        let scene = &mut loaded.scene;
        scene.image.size = self.size.unwrap_or(scene.image.size);
        let course = Course {
            frames: self.frames,
            logarithmic: self.logarithmic,
            back_and_forth: self.back_and_forth,
        };
        let sweep = Sweep::new(scene, &self.set_from, &self.set_to, course).map_err(refused)?;
        sweep
            .scenes()
            .try_for_each(|scene| check_memory_for(&scene, loaded.model.as_deref(), 1))
            .map_err(Failure::work)?;
        let mut renderer = loaded.renderer();
        let bar = progress_bar(sweep.count().into(), text!("cli-drawing"));
        let mut draw = |scene: &Scene| {
            let frame = drawn(&mut renderer, scene, self.samples);
            bar.inc(1);
            Some(frame)
        };
        if let Some(names) = Numbered::from_path(&self.output) {
            if FilmFormat::from_path(&self.output) != Some(FilmFormat::Apng) {
                return Err(Failure::input(text!("cli-expected-png")));
            }
            for (scene, number) in sweep.scenes().zip(1..) {
                let path = names.path(number);
                check_target(&path)?;
                if let Some(frame) = draw(&scene) {
                    save_picture(&path, &frame, &scene)?;
                }
            }
            return Ok(());
        }
        check_target(&self.output)?;
        check_picture_target(&self.output)?;
        let format = FilmFormat::from_path(&self.output).unwrap_or(FilmFormat::Apng);
        let rate = self.fps.unwrap_or(USUAL_RATE);
        let seconds = self.seconds.unwrap_or(f64::from(sweep.count()) / rate);
        format
            .check_seconds(sweep.count(), seconds)
            .map_err(refused)?;
        Ok(save_film(&self.output, format, &sweep, seconds, &mut draw)?)
    }
}

/// Converts an error into one that names the options.
fn refused(error: SweepError) -> Failure {
    let named = |error: &dyn ToString, option: &str| error.to_string().replace("--set ", option);
    Failure::input(match &error {
        SweepError::Beginning(cause) => named(cause, "--set-from "),
        SweepError::End(cause) => named(cause, "--set-to "),
        error => error.to_string(),
    })
}

fn drawn(renderer: &mut Renderer, scene: &Scene, samples: u32) -> Frame {
    let which = panes_on_sheet(scene);
    let nothing = |_: &mut Frame, _: &mut Renderer, _: &Scene| Ok::<(), Infallible>(());
    let Ok(panes) = draw_panes(renderer, scene, &which, samples, &mut |_| true, nothing);
    comparison_sheet(scene, &panes, Captions::Figures)
}

/// A file name with a number in it, as in `frame-%03d.png`.
struct Numbered {
    before: String,
    digits: usize,
    after: String,
}

impl Numbered {
    fn from_path(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?;
        let (before, rest) = name.split_once('%')?;
        let (digits, after) = rest.split_once('d')?;
        let digits = match digits {
            "" => 1,
            digits => digits
                .strip_prefix('0')?
                .parse()
                .ok()
                .filter(|count| *count < 10)?,
        };
        let folder = path.with_file_name(before);
        let before = if before.is_empty() {
            path.parent()?.join("").to_str()?.to_owned()
        } else {
            folder.to_str()?.to_owned()
        };
        Some(Self {
            before,
            digits,
            after: after.to_owned(),
        })
    }

    fn path(&self, number: u32) -> PathBuf {
        let digits = self.digits;
        PathBuf::from(format!("{}{number:0digits$}{}", self.before, self.after))
    }
}
