//! The program's own documentation: the help of a command, completions for shells, and manual pages.

use super::examples::examples;
use super::help::{line_width, worded};
use super::output::{Failure, print, write_text};
use clap::{Args, Command};
use clap_complete::Shell;
use clap_mangen::Man;
use shading_lab::scene::did_you_mean;
use shading_lab::text::{excerpt, text};
use std::path::PathBuf;

#[derive(Args)]
pub struct Help {
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
}

#[derive(Args)]
pub struct Completions {
    #[arg(value_enum, value_name = "SHELL")]
    shell: Shell,
}

#[derive(Args)]
pub struct Manual {
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
    #[arg(short, long, value_name = "FOLDER", conflicts_with = "command")]
    output: Option<PathBuf>,
}

impl Help {
    pub fn run(self, program: Command) -> Result<(), Failure> {
        let mut program = worded(program, Some(line_width()));
        program.build();
        Ok(named(program, self.command.as_deref())?.print_long_help()?)
    }
}

impl Completions {
    pub fn run(self, program: Command) -> Result<(), Failure> {
        let mut program = worded(program, None);
        let name = program.get_name().to_owned();
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut program, &name, &mut script);
        let script = String::from_utf8_lossy(&script);
        // clap_complete 4.6 writes a name with a hyphen in one way where it looks for the command and in another
        // where it answers.
        let (expected, generated) = (name.replace('-', "__"), name.replace('-', "__subcmd__"));
        print(&script.replace(&generated, &expected))
    }
}

impl Manual {
    pub fn run(self, program: Command) -> Result<(), Failure> {
        let mut program = worded(program, None);
        program.build();
        let Some(folder) = &self.output else {
            return print(&page(&named(program, self.command.as_deref())?)?);
        };
        for command in std::iter::once(&program).chain(program.get_subcommands()) {
            let path = folder.join(Man::new(command.clone()).get_filename());
            write_text(&path, &page(command)?)?;
        }
        Ok(())
    }
}

/// Returns the command of a name, or the program itself.
fn named(program: Command, name: Option<&str>) -> Result<Command, Failure> {
    let Some(name) = name else {
        return Ok(program);
    };
    let found = program.find_subcommand(name).cloned();
    found.ok_or_else(|| no_command(&program, name))
}

/// Returns the error for an unknown command, with the one that was probably meant.
pub fn no_command(program: &Command, name: &str) -> Failure {
    let known = program.get_subcommands().map(Command::get_name);
    let meant = did_you_mean(name, known);
    let name = excerpt(name);
    Failure::input(text!("cli-no-command", name = name, meant = meant))
}

/// Returns a manual page, its headings in the chosen language.
fn page(command: &Command) -> Result<String, Failure> {
    let mut page = Vec::new();
    let man = Man::new(command.clone())
        .manual(text!("cli-manual"))
        .source(concat!("shading-lab ", env!("CARGO_PKG_VERSION")));
    man.render(&mut page)?;
    let page = String::from_utf8_lossy(&page);
    let mut out = String::new();
    for line in page.lines() {
        let heading = line.strip_prefix(".SH ").unwrap_or_default();
        let heading = match heading {
            "NAME" => text!("cli-manual-name"),
            "SYNOPSIS" => text!("cli-manual-synopsis"),
            "DESCRIPTION" => {
                out += &example_section(command.get_name());
                text!("cli-manual-description")
            }
            "SUBCOMMANDS" => text!("cli-manual-commands"),
            "VERSION" => text!("cli-manual-version"),
            // Headings of the help end in a colon.
            other => other.trim_matches('"').trim_end_matches([':', '：']),
        };
        if heading.is_empty() {
            out += line;
        } else {
            out += &format!(".SH \"{heading}\"");
        }
        out.push('\n');
    }
    Ok(out)
}

/// Formats the examples of a command's help, as they are typed.
fn example_section(name: &str) -> String {
    let heading = text!("cli-manual-examples");
    let line = |example: &&str| example.replace('\\', "\\e").replace('-', "\\-") + "\n";
    let lines: String = examples(name).iter().map(line).collect();
    format!(".SH \"{heading}\"\n.nf\n{lines}.fi\n")
}
