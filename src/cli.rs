//! The command line: what was asked for, done by one file a command.
//!
//! Exit status 0 when it is done, 2 for bad input, 1 for a failure. Errors take a line each on stderr, with the file and
//! the line that they are about.

mod analyse;
mod input;
mod output;
mod render;
mod simple;

use analyse::{Analyse, Catalogued};
use clap::{Parser, Subcommand};
use input::SceneArguments;
use output::Failure;
use shading_lab::analysis::Analysis;
use std::process::ExitCode;

/// A laboratory for local illumination and polygon shading.
///
/// Without a command it opens the window. SCENE is a scene file (.toml), a model (.obj), a picture that this program
/// exported (.png), or the name of a built-in scene (`shading-lab scenes`).
#[derive(Parser)]
#[command(version, disable_help_subcommand = true)]
struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    /// Draw a scene into a PNG file, without a window.
    Render(render::Render),
    #[command(about = asks("probe"))]
    Probe(Analyse<analyse::Probe>),
    /// Slopes are per pixel; all values are linear and before rounding. Without a file it prints a row for each sample, values
    /// separated by commas.
    #[command(about = asks("profile"))]
    Profile(Analyse<analyse::Profile>),
    /// Differences are those of linear intensities before they are encoded and rounded; where the display clamps, what is above
    /// 1 counts as 1. `study` has the errors without the clamp as well.
    #[command(about = asks("compare"))]
    Compare(Analyse<analyse::Compare>),
    #[command(about = asks("normals"))]
    Normals(Analyse<analyse::Normals>),
    #[command(about = asks("defects"))]
    Defects(Analyse<analyse::Defects>),
    #[command(about = asks("conditions"))]
    Conditions(Analyse<analyse::Conditions>),
    /// Times are medians of whole frames drawn anew, in turn by the plan and with everything left in that can be; shares are of the
    /// stages' sum. After the changes that `bench` makes it names the stages that run again.
    #[command(about = asks("explain"))]
    Explain(Analyse<analyse::Explain>),
    /// Active edges, P and Q with their α, and each pixel's value. Without a file it prints the scan line of the step with its
    /// formulas filled in.
    #[command(about = asks("scanline"))]
    Scanline(Analyse<analyse::Scanline>),
    /// Every way of shading at several tessellations against the exact picture. Errors are those of the linear intensities
    /// before the display, values above 1 in full; “shown” are those of the values clamped to 1 where the display clamps, as
    /// `compare` has them.
    #[command(about = asks("study"))]
    Study(Analyse<analyse::Study>),
    /// Where the textbook's way fails, by how much, and that the engine does not. The reference computes with 106 bits. It ends
    /// with status 1 if the engine is off by more than half a code value anywhere.
    #[command(about = asks("stability"))]
    Stability(Catalogued<analyse::Stability>),
    /// Write a scene as OpenGL calls or as GLSL shaders, to copy; what they cannot express is printed on stderr.
    Code(simple::Code),
    /// f(d), the family of powers of a cosine, W(θ), and the lobe. Without a file it prints what the plots say in words and
    /// numbers.
    #[command(about = asks("curves"))]
    Curves(Analyse<analyse::Curves>),
    /// List the built-in scenes.
    Scenes(simple::List),
    /// List the named materials of the OpenGL tradition, for --material.
    Materials(simple::List),
    /// List every key of the scene file with its default, limits and meaning.
    Parameters(simple::List),
    /// Read a scene, a model or a picture, and say what is wrong with it.
    Check(simple::Check),
    /// A frame of `full` is transformed, covered, shaded and displayed anew; the tessellation is kept, as a graphics card
    /// keeps it in its buffers. In a frame of `changes` one thing differs from the frame before: the place of the first
    /// light, n, ka, the eye on an orbit, or the number of segments.
    #[command(about = asks("bench"))]
    Bench(Analyse<analyse::Bench>),
}

/// What the analysis of that name asks.
fn asks(name: &str) -> &'static str {
    Analysis::find(name).map_or("", |analysis| analysis.asks)
}

impl Command {
    /// The name of a command that takes no scene.
    fn without_scene(&self) -> Option<&'static str> {
        match self {
            Self::Scenes(_) => Some("scenes"),
            Self::Materials(_) => Some("materials"),
            Self::Parameters(_) => Some("parameters"),
            Self::Stability(_) => Some("stability"),
            _ => None,
        }
    }
}

/// Does what the command line asks for, reports what goes wrong, and says how the process should end.
pub fn run() -> ExitCode {
    match perform(Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

fn perform(arguments: Arguments) -> Result<(), Failure> {
    let Arguments { scene, command } = arguments;
    let earlier = scene.overrides();
    if let Some(name) = command
        .as_ref()
        .and_then(Command::without_scene)
        .filter(|_| !earlier.is_empty())
    {
        return Err(Failure::input(format!(
            "--set without a scene, expected `{name}` alone"
        )));
    }
    match command {
        None => open_window(&scene),
        Some(_) if scene.source.is_some() => Err(Failure::input(
            "a scene before the command, expected it after: shading-lab COMMAND SCENE",
        )),
        Some(Command::Render(render)) => render.run(&earlier),
        Some(Command::Probe(probe)) => probe.run(&earlier),
        Some(Command::Profile(profile)) => profile.run(&earlier),
        Some(Command::Compare(compare)) => compare.run(&earlier),
        Some(Command::Normals(normals)) => normals.run(&earlier),
        Some(Command::Defects(defects)) => defects.run(&earlier),
        Some(Command::Conditions(conditions)) => conditions.run(&earlier),
        Some(Command::Explain(explain)) => explain.run(&earlier),
        Some(Command::Scanline(scanline)) => scanline.run(&earlier),
        Some(Command::Code(code)) => code.run(&earlier),
        Some(Command::Curves(curves)) => curves.run(&earlier),
        Some(Command::Check(check)) => check.run(&earlier),
        Some(Command::Bench(bench)) => bench.run(&earlier),
        Some(Command::Study(study)) => study.run(&earlier),
        Some(Command::Scenes(list)) => list.scenes(),
        Some(Command::Materials(list)) => list.materials(),
        Some(Command::Parameters(list)) => list.parameters(),
        Some(Command::Stability(stability)) => stability.run_alone(),
    }
}

/// Opens the window on a scene, or on the default one.
fn open_window(arguments: &SceneArguments) -> Result<(), Failure> {
    let loaded = arguments.load(&[])?;
    #[cfg(feature = "app")]
    return shading_lab::app::run(loaded).map_err(Failure::work);
    #[cfg(not(feature = "app"))]
    {
        drop(loaded);
        Err(Failure::work(
            "built without a window, expected a command: see shading-lab --help",
        ))
    }
}
