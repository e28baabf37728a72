//! The words of the command line's help, from the catalogue by the names of commands and arguments: `cli-help-render` and
//! `cli-help-render-samples`, or `cli-help-shared-size` for an argument that several commands have.

use clap::builder::{Resettable, StyledStr};
use clap::{Arg, ArgAction, Command};
use shading_lab::text::{has, text};
use std::fmt::Write as _;

/// `program` with its help in the language chosen, and the help of its commands.
pub fn worded(program: Command) -> Command {
    let version = Arg::new("version").short('V').long("version");
    let program = program
        .disable_version_flag(true)
        .arg(version.action(ArgAction::Version));
    worded_command(program, "program")
}

fn worded_command(command: Command, name: &str) -> Command {
    let about = format!("cli-help-{name}");
    let more = format!("{about}.long");
    let short = text!(&about);
    let long = has(&more).then(|| StyledStr::from(format!("{short}\n\n{}", text!(&more))));
    let help = Arg::new("help").short('h').long("help");
    let command = command
        .about(short)
        .long_about(Resettable::from(long))
        .disable_help_flag(true)
        .arg(help.action(ArgAction::Help))
        .mut_args(|argument| worded_argument(argument, name))
        .mut_subcommands(|command| {
            let name = command.get_name().to_owned();
            worded_command(command, &name)
        });
    let template = template(&command);
    command.help_template(template)
}

/// An argument with its own message for the command, or with the one that commands share.
fn worded_argument(argument: Arg, command: &str) -> Arg {
    let mut help = text!(&key(&argument, command)).to_owned();
    if let Some(value) = argument.get_default_values().first() {
        let value = value.to_string_lossy().into_owned();
        help += &text!("cli-default", value = value);
    }
    let takes_values = argument.get_action().takes_values();
    argument
        .help(help)
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

/// What clap prints without being told, with headings from the catalogue.
fn template(command: &Command) -> StyledStr {
    let mut template = "{about-with-newline}".to_owned();
    let style = *command.get_styles().get_header();
    let mut section = |heading: &str, content: &str| {
        // Memory takes every text.
        let _ = write!(template, "\n{style}{heading}{style:#}{content}\n");
    };
    section(text!("cli-usage"), " {usage}");
    if command.has_subcommands() {
        section(text!("cli-commands"), "\n{subcommands}");
    }
    if command.get_positionals().next().is_some() {
        section(text!("cli-arguments"), "\n{positionals}");
    }
    section(text!("cli-options"), "\n{options}");
    template.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Arguments;
    use clap::CommandFactory;
    use shading_lab::text::{FILES, Language, in_language};
    use std::collections::BTreeSet;

    /// The messages that a command and those under it read.
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
        assert_eq!(read_by(&worded(Arguments::command()), "program"), there);
    }

    /// Nothing of what the help says is left over from the code, where it would be English.
    #[test]
    fn help_is_in_the_language_chosen() {
        fn check(command: &mut Command) {
            let help = command.render_long_help().to_string();
            assert!(
                help.contains("用法") && !help.contains("Options") && !help.contains("Print"),
                "{help}"
            );
            command.get_subcommands_mut().for_each(check);
        }
        in_language(Language::TraditionalChinese, || {
            let mut program = worded(Arguments::command());
            program.build();
            check(&mut program);
        });
    }
}
