//! The texts of the command line's help, from the catalogue by the names of commands and arguments: `cli-help-render`
//! and `cli-help-render-samples`, or `cli-help-shared-size` for an argument that several commands have.

use super::examples::examples;
use super::output::{columns, is_wide};
use clap::builder::{Resettable, StyledStr};
use clap::{Arg, ArgAction, Command};
use shading_lab::text::{has, text};
use std::fmt::Write as _;

/// Maximum number of columns of the help, also used where there is no terminal.
const WIDEST: usize = 98;
/// Minimum number of columns of the help.
const NARROWEST: usize = 40;
/// Number of columns beyond which an argument has its help on the next line.
const WIDEST_ARGUMENT: usize = 28;

/// The commands grouped by purpose, each group under its heading.
const GROUPS: [(&str, &[&str]); 6] = [
    ("cli-group-draw", &["render", "animate", "compare"]),
    (
        "cli-group-explain",
        &[
            "probe",
            "profile",
            "curves",
            "normals",
            "scanline",
            "explain",
            "defects",
            "conditions",
        ],
    ),
    ("cli-group-measure", &["study", "stability", "bench"]),
    ("cli-group-teach", &["lesson", "class", "collect"]),
    (
        "cli-group-scenes",
        &["scenes", "materials", "parameters", "check", "code", "link"],
    ),
    ("cli-group-program", &["completions", "manual", "help"]),
];

pub fn line_width() -> usize {
    terminal_size::terminal_size().map_or(WIDEST, |(width, _)| {
        usize::from(width.0).clamp(NARROWEST, WIDEST)
    })
}

/// Returns `program` with its help and that of its commands in the chosen language, in lines of at most `width`
/// columns: or without a layout, for programs that have their own.
pub fn worded(program: Command, width: Option<usize>) -> Command {
    let version = Arg::new("version").short('V').long("version");
    let program = program
        .disable_version_flag(true)
        .disable_help_subcommand(true)
        .arg(version.action(ArgAction::Version));
    worded_command(program, "program", &[], width)
}

/// Returns a command with its help; `inherited` are arguments of the commands above.
fn worded_command(
    command: Command,
    name: &str,
    inherited: &[Arg],
    width: Option<usize>,
) -> Command {
    let about = format!("cli-help-{name}");
    let more = format!("{about}.long");
    let more = has(&more).then(|| text!(&more));
    let help = Arg::new("help").short('h').long("help");
    let command = command
        .disable_help_flag(true)
        .arg(help.action(ArgAction::Help))
        .mut_args(|argument| worded_argument(argument, name));
    let global = command
        .get_arguments()
        .filter(|argument| argument.is_global_set());
    let global: Vec<Arg> = inherited.iter().chain(global).cloned().collect();
    let command = command.mut_subcommands(|command| {
        let name = command.get_name().to_owned();
        worded_command(command, &name, &global, width)
    });
    let about = text!(&about);
    let Some(width) = width else {
        let long = more.map(|more| StyledStr::from(format!("{about}\n\n{more}")));
        return command
            .about(about)
            .long_about(Resettable::from(long))
            .subcommand_value_name("COMMAND");
    };
    let template = template(&command, name, inherited, width);
    let more = more.map(|more| wrapped(more, width).join("\n"));
    // The purpose of the program without a command is shown in the short help too.
    let short = more.clone().filter(|_| name == "program");
    command
        .about(wrapped(about, width).join("\n"))
        .long_about(Resettable::Reset)
        .after_help(Resettable::from(short.map(StyledStr::from)))
        .after_long_help(Resettable::from(more.map(StyledStr::from)))
        .help_template(template)
}

/// Returns an argument with its own message for the command, or with the one that commands share.
fn worded_argument(argument: Arg, command: &str) -> Arg {
    let mut help = text!(&key(&argument, command)).to_owned();
    if let Some(value) = argument.get_default_values().first() {
        let value = value.to_string_lossy().into_owned();
        help += &text!("cli-default", value = value);
    }
    let takes_values = argument.get_action().takes_values();
    let heading = text!(heading(&argument, command));
    argument
        .help(help)
        .help_heading(heading)
        .long_help(Resettable::Reset)
        .hide_default_value(takes_values)
        .hide_possible_values(takes_values)
}

fn key(argument: &Arg, command: &str) -> String {
    let name = argument.get_id().as_str().replace('_', "-");
    let own = format!("cli-help-{command}-{name}");
    if has(&own) {
        own
    } else {
        format!("cli-help-shared-{name}")
    }
}

fn heading(argument: &Arg, command: &str) -> &'static str {
    match argument.get_id().as_str() {
        "source" | "set" | "material" | "pane" => "cli-heading-scene",
        "output" | "json" | "csv" | "size" | "dark" | "picture" | "no_captions"
        | "without_answers" => "cli-heading-output",
        "language" | "help" | "version" => "cli-heading-general",
        "seed" | "url" if command == "program" => "cli-heading-window",
        _ if argument.is_positional() => "cli-arguments",
        _ => "cli-options",
    }
}

const HEADINGS: [&str; 6] = [
    "cli-arguments",
    "cli-heading-scene",
    "cli-options",
    "cli-heading-window",
    "cli-heading-output",
    "cli-heading-general",
];

/// Returns the help template: a command's purpose, its usage, and its commands and arguments under their headings.
fn template(command: &Command, name: &str, inherited: &[Arg], width: usize) -> StyledStr {
    let styles = command.get_styles();
    let (heading, literal) = (*styles.get_header(), *styles.get_literal());
    // Writing to memory cannot fail.
    let mut out = "{about-with-newline}".to_owned();
    let examples = examples(name);
    let title = match examples.len() {
        1 => text!("cli-example"),
        _ => text!("cli-examples"),
    };
    let _ = write!(out, "\n{heading}{title}{heading:#}\n");
    for example in examples {
        let _ = writeln!(out, "  {literal}{example}{literal:#}");
    }
    let _ = write!(
        out,
        "\n{heading}{}{heading:#} {{usage}}\n",
        text!("cli-usage")
    );
    let mut section = |title: &str, rows: Vec<(String, String)>| {
        let widest = rows.iter().map(|(left, _)| columns(left));
        let widest = widest.filter(|width| *width <= WIDEST_ARGUMENT).max();
        let indent = 2 + widest.unwrap_or(8) + 2;
        let _ = write!(out, "\n{heading}{title}{heading:#}\n");
        for (left, right) in rows {
            let space = indent.saturating_sub(2 + columns(&left));
            let _ = write!(out, "  {literal}{left}{literal:#}");
            let lines = wrapped(&right, width - indent);
            let gap = if space < 2 {
                format!("\n{:indent$}", "")
            } else {
                " ".repeat(space)
            };
            let _ = writeln!(out, "{gap}{}", lines.join(&format!("\n{:indent$}", "")));
        }
    };
    if command.has_subcommands() {
        for (key, names) in GROUPS {
            let commands = names
                .iter()
                .filter_map(|name| command.find_subcommand(name));
            let row = |command: &Command| {
                let about = text!(&format!("cli-help-{}", command.get_name()));
                (command.get_name().to_owned(), about.to_owned())
            };
            section(text!(key), commands.map(row).collect());
        }
    }
    let arguments: Vec<&Arg> = command.get_arguments().chain(inherited).collect();
    for key in HEADINGS {
        let under = arguments
            .iter()
            .filter(|argument| argument.get_help_heading() == Some(text!(key)));
        let rows: Vec<_> = under.map(|argument| row(argument)).collect();
        if !rows.is_empty() {
            section(text!(key), rows);
        }
    }
    // The following text begins with an empty line of its own.
    out.truncate(out.trim_end().len());
    out += "{after-help}";
    out.into()
}

fn row(argument: &Arg) -> (String, String) {
    let names = argument.get_value_names().unwrap_or_default();
    let value = names
        .iter()
        .map(|name| format!("<{name}>"))
        .collect::<Vec<_>>()
        .join(" ");
    let short = match argument.get_short() {
        Some(short) => format!("-{short}, "),
        None => " ".repeat(4),
    };
    let typed = match argument.get_long() {
        Some(long) if argument.get_action().takes_values() => format!("{short}--{long} {value}"),
        Some(long) => format!("{short}--{long}"),
        None if matches!(argument.get_action(), ArgAction::Append) => format!("{value}..."),
        None if argument.is_required_set() => value,
        None => value.replace('<', "[").replace('>', "]"),
    };
    let help = argument.get_help().map(ToString::to_string);
    (typed, help.unwrap_or_default())
}

/// Wraps a text to lines of at most `width` columns. A line may end between Chinese characters, but no punctuation
/// begins one.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    text.lines()
        .flat_map(|line| wrapped_line(line, width))
        .collect()
}

fn wrapped_line(text: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for piece in pieces(text) {
        if columns(&line) + columns(piece.trim_end()) > width && !line.is_empty() {
            lines.push(line.trim_end().to_owned());
            line.clear();
        }
        line += piece;
    }
    lines.push(line.trim_end().to_owned());
    lines
}

/// Splits a line into pieces that stay whole, with the spaces after them.
fn pieces(text: &str) -> Vec<&str> {
    let mut pieces = Vec::new();
    let (mut start, mut before) = (0, '\0');
    for (at, c) in text.char_indices() {
        let wide = is_wide(before) || is_wide(c);
        let kept =
            "，。；：、！？）」』》】".contains(c) || "（「『《【".contains(before) || c == ' ';
        if at > 0 && !kept && (before == ' ' || wide) {
            pieces.push(&text[start..at]);
            start = at;
        }
        before = c;
    }
    pieces.push(&text[start..]);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Arguments;
    use clap::CommandFactory;
    use shading_lab::lesson::find;
    use shading_lab::scene::presets;
    use shading_lab::text::{FILES, Language, in_language};
    use std::collections::BTreeSet;
    use std::path::PathBuf;

    /// Returns the messages that a command and its subcommands read.
    fn read_by(command: &Command, name: &str) -> BTreeSet<String> {
        let mut keys = BTreeSet::from([format!("cli-help-{name}")]);
        keys.extend(command.get_arguments().map(|argument| key(argument, name)));
        for command in command.get_subcommands() {
            keys.extend(read_by(command, command.get_name()));
        }
        keys
    }

    #[test]
    fn every_command_and_argument_has_its_message_and_no_message_is_left() {
        let there: BTreeSet<String> = FILES[0]
            .iter()
            .flat_map(|(_, file)| file.lines())
            .filter(|line| line.starts_with("cli-help-"))
            .filter_map(|line| line.split_once(" ="))
            .map(|(key, _)| key.to_owned())
            .collect();
        let program = worded(Arguments::command(), Some(WIDEST));
        assert_eq!(read_by(&program, "program"), there);
    }

    /// Returns the short and the long help of every command, in a language.
    fn every_help(language: Language, width: usize) -> Vec<(String, String)> {
        fn collect(command: &mut Command, all: &mut Vec<(String, String)>) {
            let name = command.get_name().to_owned();
            all.push((name.clone(), command.render_help().to_string()));
            all.push((name, command.render_long_help().to_string()));
            for command in command.get_subcommands_mut() {
                collect(command, all);
            }
        }
        in_language(language, || {
            let mut program = worded(Arguments::command(), Some(width));
            program.build();
            let mut all = Vec::new();
            collect(&mut program, &mut all);
            all
        })
    }

    /// Checks that no part of the help comes from the code, where it would be English.
    #[test]
    fn help_is_in_the_language_chosen() {
        for (_, help) in every_help(Language::TraditionalChinese, WIDEST) {
            assert!(
                help.contains("用法") && !help.contains("Options") && !help.contains("Print"),
                "{help}"
            );
        }
    }

    #[test]
    fn help_begins_with_an_example_and_is_wrapped() {
        for language in Language::ALL {
            for (name, help) in every_help(language, WIDEST) {
                for line in help.lines() {
                    assert!(columns(line) < 100, "{name}: {line}");
                    assert_eq!(line, line.trim_end(), "{name}");
                }
                let example = help
                    .lines()
                    .position(|line| line.starts_with("  shading-lab "));
                assert!(example.is_some_and(|line| line <= 5), "{name}: {help}");
            }
            // Narrow terminals: everything that can be wrapped is.
            for (name, help) in every_help(language, 60) {
                let wide = |line: &&str| columns(line) > 60;
                let prose = help.lines().filter(wide).filter(|line| line.contains(". "));
                assert_eq!(prose.count(), 0, "{name}: {help}");
            }
        }
    }

    /// Checks that every command has one heading, and each of its arguments too, including those of the program that
    /// it takes.
    #[test]
    fn everything_stands_under_a_heading() {
        let program = worded(Arguments::command(), Some(WIDEST));
        let grouped = GROUPS.iter().flat_map(|(_, names)| names.iter().copied());
        let mut grouped: Vec<&str> = grouped.collect();
        let mut there: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
        grouped.sort_unstable();
        there.sort_unstable();
        assert_eq!(grouped, there);
        let mut built = program.clone();
        built.build();
        for command in built.get_subcommands() {
            let help = command.clone().render_long_help().to_string();
            for argument in command.get_arguments().filter_map(Arg::get_long) {
                let row = format!("--{argument}");
                let rows = help.lines().filter(|line| {
                    let typed = line.get(6..).unwrap_or_default();
                    line.starts_with("  ") && typed.split(' ').next() == Some(&row)
                });
                assert_eq!(rows.count(), 1, "{row}: {help}");
            }
        }
    }

    #[test]
    fn every_example_is_understood() {
        let program = worded(Arguments::command(), Some(WIDEST));
        let mut names = vec!["program"];
        names.extend(program.get_subcommands().map(Command::get_name));
        for name in names {
            for example in examples(name) {
                let words = example.split(['|', '>']).next().unwrap_or_default();
                let found = program
                    .clone()
                    .try_get_matches_from(words.split_whitespace());
                let found = found.unwrap_or_else(|error| panic!("{example}: {error}"));
                let own = matches!(name, "program" | "materials");
                assert!(own || found.subcommand_name() == Some(name), "{example}");
                // Files that it names exist, or are the reader's own.
                let (_, found) = found.subcommand().unwrap_or((name, &found));
                let named = |id| found.try_get_one::<PathBuf>(id).ok().flatten();
                let scene = named("source").and_then(|scene| scene.to_str());
                assert!(
                    scene.is_none_or(|scene| presets::find(scene).is_some()),
                    "{example}"
                );
                let lesson = named("lesson").and_then(|lesson| lesson.to_str());
                assert!(
                    lesson.is_none_or(|lesson| find(lesson).is_some()),
                    "{example}"
                );
            }
        }
    }

    #[test]
    fn chinese_lines_end_where_they_may() {
        assert_eq!(
            wrapped("在場景旁加一個窗格，取代場景", 19),
            ["在場景旁加一個窗", "格，取代場景"]
        );
        assert_eq!(wrapped("one two three", 7), ["one two", "three"]);
        assert_eq!(wrapped("a\n\nb", 9), ["a", "", "b"]);
    }
}
