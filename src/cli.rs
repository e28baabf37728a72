//! The command line: the same engine without a window.
//!
//! Exit status 0 means done, 2 bad input, 1 any other failure; errors go to stderr, a line each.

mod bench;
mod check;
mod failure;
mod output;
mod probe;
mod render;
mod scenes;

use crate::document::{Loaded, load_with};
use crate::scene::presets;
use clap::{Args, Parser, Subcommand};
use failure::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// A laboratory for local illumination and polygon shading.
///
/// Without a command it opens the window.
#[derive(Debug, Parser)]
#[command(version, args_conflicts_with_subcommands = true)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    scene: SceneArguments,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Draws a scene into a PNG file, without a window
    Render(render::Arguments),
    /// Evaluates the illumination equation at one pixel
    Probe(probe::Arguments),
    /// Measures the time of a frame and of its stages
    Bench(bench::Arguments),
    /// Lists the built-in scenes
    Scenes(scenes::Arguments),
    /// Says whether a scene file, a model or an exported picture is sound
    Check(check::Arguments),
}

/// Which scene, and what is changed in it.
#[derive(Debug, Args)]
struct SceneArguments {
    /// A scene file (.toml), a model (.obj), a picture exported by this program (.png), or a built-in scene's name
    #[arg(default_value = presets::DEFAULT)]
    scene: PathBuf,
    /// Overrides one key of the scene, for example material.n=1005 or light.0.position=[2,2,3]; repeatable
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Size of the picture in pixels
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
}

impl SceneArguments {
    fn load(&self) -> Result<Loaded, Failure> {
        let mut overrides = self.set.clone();
        if let Some([width, height]) = self.size {
            overrides.push(format!("image.size=[{width},{height}]"));
        }
        load(&self.scene, &overrides)
    }
}

/// Opens a scene with a progress bar while a model is read.
fn load(scene: &Path, overrides: &[String]) -> Result<Loaded, Failure> {
    let bar = progress_bar("reading");
    let loaded = load_with(scene, overrides, &mut |read, total| {
        bar.set_length(total);
        bar.set_position(read);
    });
    bar.finish_and_clear();
    Ok(loaded?)
}

/// A bar on stderr, drawn only when that is a terminal and the work takes a moment.
fn progress_bar(what: &'static str) -> ProgressBar {
    const PATTERN: &str = "{msg} {wide_bar} {percent} %";
    let style = ProgressStyle::with_template(PATTERN).unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(0).with_style(style).with_message(what)
}

/// A size as `WxH`.
fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let parsed = text.split_once(['x', 'X']).and_then(|(w, h)| Some([w.trim().parse().ok()?, h.trim().parse().ok()?]));
    parsed.ok_or_else(|| "expected WIDTHxHEIGHT in pixels, for example 1024x768".to_owned())
}

/// Nanoseconds since the first call.
fn nanoseconds() -> u64 {
    static START: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    u64::try_from(START.get_or_init(Instant::now).elapsed().as_nanos()).unwrap_or(u64::MAX)
}

/// Runs the program with the process's own arguments.
pub fn main() -> ExitCode {
    let result = match Arguments::try_parse() {
        Ok(arguments) => run(&arguments),
        Err(error) => failure::usage(&error),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.command {
        Some(Command::Render(arguments)) => render::run(arguments),
        Some(Command::Probe(arguments)) => probe::run(arguments),
        Some(Command::Bench(arguments)) => bench::run(arguments),
        Some(Command::Scenes(arguments)) => scenes::run(arguments),
        Some(Command::Check(arguments)) => check::run(arguments),
        None => open_window(arguments.scene.load()?),
    }
}

#[cfg(feature = "app")]
fn open_window(loaded: Loaded) -> Result<(), Failure> {
    crate::app::run(Some(loaded)).map_err(|error| Failure::other(&error))
}

#[cfg(not(feature = "app"))]
fn open_window(_: Loaded) -> Result<(), Failure> {
    Err(Failure::other(&"this program was built without its window, expected a command; see --help"))
}
