//! The command line, with one file per command.
//!
//! The exit status is 0 on success, 2 for bad input, 1 for a failure. Errors take one line each on stderr, with the
//! file and the line that they concern.

mod analyse;
mod animate;
mod check;
#[cfg(feature = "class")]
mod class;
mod collect;
mod errors;
mod examples;
mod handed;
mod help;
mod input;
mod inventory;
mod lesson;
mod link;
mod manual;
mod output;
mod render;
mod simple;

use analyse::{Analyse, Catalogued};
use clap::error::ErrorKind;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use input::SceneArguments;
use output::Failure;
use shading_lab::document::load_scene;
use shading_lab::lesson::Lesson;
use shading_lab::render::check_mesh_memory;
use shading_lab::scene::{nearest, presets};
use shading_lab::text::{Language, set_language, text};
use std::env;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::thread::available_parallelism;

/// Maximum number of threads that the environment may request, unless there are more cores.
const MOST_THREADS: usize = 256;

/// The arguments. The texts of the help are in the catalogue: see [`help`].
#[derive(Parser)]
#[command(version, disable_help_subcommand = true)]
struct Arguments {
    #[arg(long, global = true, value_name = "en|zh-Hant", value_parser = parse_language)]
    language: Option<Language>,
    #[command(flatten)]
    scene: SceneArguments,
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    #[arg(long, value_name = "BASE", value_parser = shading_lab::link::page)]
    url: Option<String>,
    #[arg(long)]
    fresh: bool,
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    Render(render::Render),
    Animate(animate::Animate),
    Probe(Analyse<analyse::Probe>),
    Profile(Analyse<analyse::Profile>),
    Compare(Analyse<analyse::Compare>),
    Normals(Analyse<analyse::Normals>),
    Defects(Analyse<analyse::Defects>),
    Conditions(Analyse<analyse::Conditions>),
    Explain(Analyse<analyse::Explain>),
    Scanline(Analyse<analyse::Scanline>),
    Study(Analyse<analyse::Study>),
    Stability(Catalogued<analyse::Stability>),
    Code(simple::Code),
    Link(link::Link),
    Curves(Analyse<analyse::Curves>),
    Scenes(simple::List),
    Materials(simple::List),
    Parameters(simple::List),
    Check(check::Check),
    Lesson(lesson::LessonCommand),
    #[cfg(feature = "class")]
    Class(class::ClassCommand),
    Collect(collect::Collect),
    Bench(Analyse<analyse::Bench>),
    Completions(manual::Completions),
    Manual(manual::Manual),
    Help(manual::Help),
}

/// The commands that take no scene.
const WITHOUT_SCENE: [&str; 9] = [
    "scenes",
    "materials",
    "parameters",
    "lesson",
    "class",
    "collect",
    "completions",
    "manual",
    "help",
];

/// Runs the command, reports errors, and returns the exit code of the process.
pub fn run() -> ExitCode {
    bound_threads();
    set_language(language_asked_for().unwrap_or_else(Language::of_system));
    let command = help::worded(Arguments::command(), Some(help::line_width()));
    let arguments = command.try_get_matches().and_then(|matches| {
        let name = matches.subcommand_name().map(str::to_owned);
        Ok((Arguments::from_arg_matches(&matches)?, name))
    });
    let result = match arguments {
        Ok((arguments, name)) => perform(arguments, name.as_deref()),
        Err(error) => match (misspelt_command(&error), errors::worded(&error)) {
            (Some(failure), _) => Err(failure),
            (None, Some(message)) => Err(Failure::input(message)),
            (None, None) if error.use_stderr() => Err(Failure::input(error.kind())),
            (None, None) => output::print_help(&error),
        },
    };
    result.map_or_else(|failure| failure.report(), |()| ExitCode::SUCCESS)
}

/// Starts [`MOST_THREADS`] where `RAYON_NUM_THREADS` requests more: each takes memory and time to start, a hundred
/// thousand minutes.
fn bound_threads() {
    let requested = env::var("RAYON_NUM_THREADS").ok();
    let requested = requested.and_then(|count| count.trim().parse::<usize>().ok());
    let cores = available_parallelism().map_or(1, usize::from);
    let most = cores.max(MOST_THREADS);
    if requested.is_some_and(|requested| requested > most) {
        // Another pool can exist only if something has used it before.
        let _ = rayon::ThreadPoolBuilder::new()
            .num_threads(most)
            .build_global();
    }
}

/// Returns the value of `--language`, if that is a language. It is looked up before the arguments are parsed, since
/// their help and their errors are in it.
fn language_asked_for() -> Option<Language> {
    let mut arguments = env::args_os().skip(1);
    while let Some(argument) = arguments.next() {
        let argument = argument.to_string_lossy();
        if let Some(tag) = argument.strip_prefix("--language=") {
            return Language::from_tag(tag);
        }
        if argument == "--language" {
            return Language::from_tag(&arguments.next()?.to_string_lossy());
        }
    }
    None
}

/// Returns the error of a misspelt command if arguments make no sense after a word that is neither a command nor a
/// scene: the word is then at fault.
fn misspelt_command(error: &clap::Error) -> Option<Failure> {
    if error.kind() != ErrorKind::UnknownArgument {
        return None;
    }
    let lenient = Arguments::command().ignore_errors(true);
    let matches = lenient.try_get_matches().ok()?;
    let source = matches.get_one::<PathBuf>("source")?;
    (matches.subcommand_name().is_none() && is_unknown_word(source))
        .then(|| manual::no_command(&Arguments::command(), &source.to_string_lossy()))
}

/// Returns whether a word names neither a file, by its ending or its existence, nor a scene, nor a link.
fn is_unknown_word(word: &Path) -> bool {
    word.to_str().is_some_and(|name| {
        let letter = |c: char| c.is_alphanumeric() || c == '-';
        name != "-" && name.chars().all(letter) && presets::find(name).is_none()
    }) && !word.exists()
}

fn parse_language(tag: &str) -> Result<Language, String> {
    let [first, second] = Language::ALL.map(Language::tag);
    let expected = || text!("cli-no-language", first = first, second = second);
    Language::from_tag(tag).ok_or_else(expected)
}

/// Runs the command of this `name`, or opens the window.
fn perform(arguments: Arguments, name: Option<&str>) -> Result<(), Failure> {
    let Arguments {
        language,
        scene,
        seed,
        url,
        fresh,
        command,
    } = arguments;
    let earlier = scene.overrides();
    if let Some(name) = name.filter(|name| !earlier.is_empty() && WITHOUT_SCENE.contains(name)) {
        return Err(Failure::input(text!("cli-set-without-scene", name = name)));
    }
    match command {
        None => open_window(&scene, (seed, language), url, fresh),
        Some(_) if fresh => Err(Failure::input(text!("cli-fresh-before-command"))),
        Some(_) if scene.source.is_some() => Err(Failure::input(text!("cli-scene-before-command"))),
        Some(Command::Link(link)) => link.run(&earlier, url),
        Some(_) if url.is_some() => Err(Failure::input(text!("cli-url-before-command"))),
        Some(Command::Render(render)) => render.run(&earlier),
        Some(Command::Animate(animate)) => animate.run(&earlier),
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
        Some(Command::Lesson(lesson)) => lesson.run(),
        #[cfg(feature = "class")]
        Some(Command::Class(class)) => class.run(),
        Some(Command::Collect(collect)) => collect.run(),
        Some(Command::Check(check)) => check.run(&earlier),
        Some(Command::Bench(bench)) => bench.run(&earlier),
        Some(Command::Study(study)) => study.run(&earlier),
        Some(Command::Scenes(list)) => list.scenes(),
        Some(Command::Materials(list)) => list.materials(),
        Some(Command::Parameters(list)) => list.parameters(),
        Some(Command::Stability(stability)) => stability.run_cases(&earlier),
        Some(Command::Completions(completions)) => completions.run(Arguments::command()),
        Some(Command::Manual(manual)) => manual.run(Arguments::command()),
        Some(Command::Help(help)) => help.run(Arguments::command()),
    }
}

/// Returns whether a word that names no scene is nearer to a command than to any scene.
fn nearest_is_command(word: &Path) -> bool {
    let program = Arguments::command();
    let commands = || program.get_subcommands().map(clap::Command::get_name);
    let known = commands().chain(presets::ALL.iter().map(|preset| preset.name));
    let meant = nearest(&word.to_string_lossy(), known);
    is_unknown_word(word) && meant.is_some_and(|meant| commands().any(|name| name == meant))
}

/// Opens the window on a scene or a lesson, or on the default scene; in `language`, and with `page` in its links, in
/// place of the previous session's, of which a `fresh` window knows nothing.
fn open_window(
    arguments: &SceneArguments,
    (seed, language): (Option<u64>, Option<Language>),
    page: Option<String>,
    fresh: bool,
) -> Result<(), Failure> {
    let (loaded, lesson) = match &arguments.source {
        Some(source) if Lesson::is_file(source) => {
            let lesson = Lesson::open(source).map_err(|error| Failure::input(error.to_string()))?;
            (load_scene(Path::new(presets::DEFAULT))?, Some(lesson))
        }
        Some(source) if nearest_is_command(source) => {
            return Err(manual::no_command(
                &Arguments::command(),
                &source.to_string_lossy(),
            ));
        }
        _ => (arguments.load(&[])?, None),
    };
    check_mesh_memory(&loaded.scene, loaded.model.as_deref()).map_err(Failure::work)?;
    #[cfg(feature = "app")]
    return shading_lab::app::run(shading_lab::app::Start {
        loaded,
        lesson,
        seed,
        language,
        page,
        fresh,
        #[cfg(feature = "class")]
        class: None,
    })
    .map_err(Failure::work);
    #[cfg(not(feature = "app"))]
    {
        drop((loaded, lesson, seed, language, page, fresh));
        Err(Failure::work(text!("cli-no-window")))
    }
}
