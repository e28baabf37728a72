//! What all analyses have in common on the command line: a scene, arguments that become a question, and where the answer goes.

use super::failure::Failure;
use super::input::{SceneArguments, parse_size};
use super::output::{print, progress_bar};
use clap::Args;
use clap::builder::{PathBufValueParser, TypedValueParser};
use shading_lab::analysis::{About, Analysis, Answer, Format, Question, Subject};
use shading_lab::document::{check_target, json_text, save_answer};
use shading_lab::figure::Paper;
use shading_lab::jobs::nanoseconds;
use shading_lab::scene::Scene;
use std::path::{Path, PathBuf};

/// The arguments of one analysis.
pub trait Asks: Args {
    type Question: Question;

    /// Its name in the list of analyses.
    const NAME: &'static str;

    /// Whether `--size` is the figure's and not the picture's.
    const SIZES_FIGURE: bool = false;

    /// The question, and what else the arguments change in the scene.
    fn question(&self, scene: &mut Scene) -> Result<Self::Question, Failure>;

    /// Threads of the engine; one for each core unless given.
    fn threads(&self) -> Option<u16> {
        None
    }

    /// Writes what else is asked for; returns whether there was anything.
    fn also(&self, _subject: &Subject) -> Result<bool, Failure> {
        Ok(false)
    }
}

/// A command that analyses a scene.
#[derive(Args)]
pub struct Analyse<A: Args> {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    asked: A,
    #[command(flatten)]
    output: OutputArguments,
}

impl<A: Asks> Analyse<A> {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let Self { scene: arguments, asked, mut output } = self;
        output.check(A::NAME)?;
        let loaded = arguments.load(earlier)?;
        let mut scene = loaded.scene;
        if !A::SIZES_FIGURE {
            scene.image.size = output.size.take().unwrap_or(scene.image.size);
        }
        let question = asked.question(&mut scene)?;
        let subject = Subject { scene, model: loaded.model, clock: nanoseconds };
        let answer = ask(&question, &subject, asked.threads())?;
        let silent = asked.also(&subject)?;
        deliver(&answer, &About { name: &loaded.name, scene: &subject.scene }, &output, silent)
    }
}

/// Where the answer of an analysis goes.
#[derive(Args)]
pub struct OutputArguments {
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
    /// The table, a row each
    #[arg(long, value_name = "FILE.csv")]
    pub csv: Option<PathBuf>,
    /// The figure as .png or .svg, the table as .csv, or the JSON object
    #[arg(short, long, value_name = "FILE", value_parser = output_name())]
    pub output: Option<PathBuf>,
    /// Width and height in pixels of the picture, instead of the scene's; for curves, profile and scanline of the figure
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub size: Option<[u32; 2]>,
    /// Draw the figure as light lines on a dark ground
    #[arg(long)]
    pub dark: bool,
}

impl OutputArguments {
    /// Refuses files that cannot be written, before any work is done.
    pub fn check(&self, name: &str) -> Result<(), Failure> {
        for target in [&self.output, &self.csv].into_iter().flatten() {
            check_target(target)?;
        }
        let formats = Analysis::find(name).map_or(&[][..], |analysis| analysis.formats);
        match self.output.as_deref().map(format_of) {
            Some(format) if !formats.contains(&format) => {
                let endings: Vec<_> = formats.iter().map(|format| format!(".{}", format.ending())).collect();
                let ending = format.ending();
                Err(Failure::input(format!("--output: {name} gives no .{ending}, expected {}", endings.join(" or "))))
            }
            _ => Ok(()),
        }
    }
}

/// Answers a question, with a bar on stderr.
pub fn ask<Q: Question>(question: &Q, subject: &Subject, threads: Option<u16>) -> Result<Q::Answer, Failure> {
    let bar = progress_bar(1000, "working");
    let watch = |share: f32| {
        bar.set_position((1000.0 * share) as u64);
        true
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.map_or(0, usize::from))
        .build()
        .map_err(|error| Failure::work(format!("the threads cannot be started ({error})")))?;
    let answer = pool.install(|| question.answer(subject, &watch)).map_err(Failure::input);
    bar.finish_and_clear();
    answer
}

/// Writes and prints an answer as the arguments say; in words where nothing else is asked for, unless `silent`.
pub fn deliver(answer: &dyn Answer, about: &About<'_>, output: &OutputArguments, silent: bool) -> Result<(), Failure> {
    let look = (output.size, if output.dark { Paper::DARK } else { Paper::LIGHT });
    if let Some(path) = &output.csv {
        save_answer(path, Format::Csv, answer, about, look)?;
    }
    if let Some(path) = &output.output {
        save_answer(path, format_of(path), answer, about, look)?;
    }
    if output.json {
        print(&json_text(answer, about))?;
    } else if !silent && output.csv.is_none() && output.output.is_none() {
        print(&answer.text(about))?;
    }
    answer.report(about).failure.map_or(Ok(()), |failure| Err(Failure::work(failure)))
}

/// What a name's ending says; a device or a pipe takes PNG.
fn format_of(path: &Path) -> Format {
    Format::from_path(path).unwrap_or(Format::Png)
}

fn is_device(path: &Path) -> bool {
    path.metadata().is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// The name of a figure or a table.
fn output_name() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| match Format::from_path(&path) {
        None if !is_device(&path) => Err("expected a name that ends in .json, .png, .svg or .csv"),
        _ => Ok(path),
    })
}

/// The name of a picture: its ending says PNG, or it is a device or a pipe.
pub fn picture_name() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| {
        let picture = Format::from_path(&path) == Some(Format::Png) || is_device(&path);
        if picture { Ok(path) } else { Err("expected a name that ends in .png") }
    })
}
