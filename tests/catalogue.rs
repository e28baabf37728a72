//! The catalogue of text: both languages have the same messages with the same variables, and `src` uses each.

use fluent_bundle::FluentResource;
use shading_lab::analysis::{Format, Method, Topic, Verdict};
use shading_lab::scene::Choice;
use shading_lab::scene::parameter::Parameter;
use shading_lab::text::{CHINESE_FONT, FILES};
use skrifa::{FontRef, MetadataProvider};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The keys of a language, those of attributes as `key.attribute`, with the variables of each.
fn messages(language: usize) -> BTreeMap<String, BTreeSet<String>> {
    let mut messages = BTreeMap::new();
    for (name, file) in FILES[language] {
        FluentResource::try_new((*file).to_owned())
            .unwrap_or_else(|(_, errors)| panic!("{name}.ftl of language {language}: {errors:?}"));
        let mut id = String::new();
        let mut key = String::new();
        for line in file.lines() {
            let Some(first) = line.chars().next().filter(|first| *first != '#') else {
                continue;
            };
            let head = line.split_once('=').map(|(head, _)| head.trim());
            match head {
                Some(head) if !first.is_whitespace() => {
                    id = head.to_owned();
                    key.clone_from(&id);
                    let again = messages.insert(key.clone(), BTreeSet::new());
                    assert!(again.is_none(), "{key} stands twice, in {name}.ftl");
                }
                Some(head) if head.starts_with('.') && !head.contains(' ') => {
                    key = format!("{id}{head}");
                    messages.insert(key.clone(), BTreeSet::new());
                }
                _ => {}
            }
            let variables = messages.get_mut(&key).expect("a message begins the file");
            variables.extend(line.split('$').skip(1).map(|rest| {
                let ends = |c: char| !(c.is_ascii_alphanumeric() || c == '-' || c == '_');
                rest[..rest.find(ends).unwrap_or(rest.len())].to_owned()
            }));
        }
    }
    messages
}

fn sources(folder: &Path, found: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
    {
        if entry.is_dir() {
            sources(&entry, found);
        } else if entry.extension().is_some_and(|ending| ending == "rs") {
            let text = fs::read_to_string(&entry).expect("a source");
            found.push((entry.display().to_string(), text));
        }
    }
}

fn all_sources() -> Vec<(String, String)> {
    let mut found = Vec::new();
    sources(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("src"),
        &mut found,
    );
    found
}

/// Each `text!("key", name = …)` of a source: its key and the names of its variables.
fn uses(source: &str) -> Vec<(String, BTreeSet<String>)> {
    let mut uses = Vec::new();
    for (at, _) in source.match_indices("text!(") {
        let rest = source[at + "text!(".len()..].trim_start();
        let Some(quoted) = rest.strip_prefix('"') else {
            continue;
        };
        let Some((key, rest)) = quoted.split_once('"') else {
            continue;
        };
        // The arguments up to the parenthesis that closes the macro; a name stands right after a comma outside all others.
        let (mut depth, mut names, mut after_comma, mut in_text) =
            (0, BTreeSet::new(), false, false);
        let mut characters = rest.char_indices().peekable();
        while let Some((at, c)) = characters.next() {
            match c {
                '\\' if in_text => {
                    characters.next();
                }
                '"' => in_text = !in_text,
                _ if in_text => {}
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' if depth == 0 => break,
                ')' | ']' | '}' => depth -= 1,
                ',' if depth == 0 => after_comma = true,
                _ if after_comma && c.is_ascii_alphabetic() => {
                    after_comma = false;
                    let word: String = rest[at..]
                        .chars()
                        .take_while(|c| c.is_ascii_alphanumeric() || *c == '_')
                        .collect();
                    let next = rest[at + word.len()..].trim_start();
                    if next.starts_with('=') && !next.starts_with("==") {
                        names.insert(word);
                    }
                }
                _ => {}
            }
        }
        uses.push((key.to_owned(), names));
    }
    uses
}

#[test]
fn both_languages_have_the_same_messages_with_the_same_variables() {
    let [english, chinese] = [messages(0), messages(1)];
    let differ: Vec<_> = english
        .iter()
        .filter(|(key, variables)| chinese.get(*key) != Some(variables))
        .map(|(key, variables)| format!("{key} {variables:?} and {:?}", chinese.get(key)))
        .chain(
            chinese
                .keys()
                .filter(|key| !english.contains_key(*key))
                .map(|key| format!("{key} is Chinese alone")),
        )
        .collect();
    assert!(
        differ.is_empty(),
        "{} differ:\n{}",
        differ.len(),
        differ.join("\n")
    );
}

#[test]
fn every_message_that_is_used_is_there_with_the_variables_it_is_given() {
    let messages = messages(0);
    let mut wrong = Vec::new();
    for (file, source) in all_sources()
        .iter()
        .filter(|(file, _)| !file.ends_with("src/text.rs"))
    {
        for (key, names) in uses(source) {
            if messages.get(&key) != Some(&names) {
                wrong.push(format!(
                    "{file}: {key} with {names:?}, the catalogue has {:?}",
                    messages.get(&key)
                ));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{} wrong:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

/// Families of messages whose keys are put together from names in the code.
const DERIVED: [&str; 2] = ["parameter-", "choice-"];

/// The keys of [`DERIVED`] families, from what is there to be named.
fn derived() -> BTreeSet<String> {
    let parameters = Parameter::all().flat_map(|parameter| {
        let name = format!("parameter-{}", parameter.key.replace('.', "-"));
        ["", ".label", ".help"].map(|part| format!("{name}{part}"))
    });
    let options = Parameter::all()
        .flat_map(Parameter::options)
        .chain(Format::OPTIONS)
        .chain(Method::OPTIONS)
        .chain(Topic::OPTIONS)
        .chain(Verdict::OPTIONS)
        .flat_map(|option| option.messages.map(str::to_owned));
    parameters.chain(options).collect()
}

#[test]
fn whatever_is_named_by_a_family_has_its_messages_and_no_other_has() {
    let of_families: BTreeSet<String> = messages(0)
        .into_keys()
        .filter(|key| DERIVED.iter().any(|family| key.starts_with(family)))
        .filter(|key| key != "parameter-of-light")
        .collect();
    let derived = derived();
    let differ: Vec<_> = of_families.symmetric_difference(&derived).collect();
    assert!(differ.is_empty(), "{differ:?}");
}

#[test]
fn every_message_is_used() {
    let sources: String = all_sources()
        .into_iter()
        .map(|(_, source)| source)
        .collect();
    let unused: Vec<String> = messages(0)
        .into_keys()
        .filter(|key| !DERIVED.iter().any(|family| key.starts_with(family)))
        .filter(|key| !sources.contains(&format!("\"{key}\"")))
        .collect();
    assert!(
        unused.is_empty(),
        "{} unused:\n{}",
        unused.len(),
        unused.join("\n")
    );
}

#[test]
#[ignore = "the font is cut once the catalogue is complete"]
fn every_character_of_the_catalogue_has_a_glyph() {
    let fonts = [
        epaint_default_fonts::UBUNTU_LIGHT,
        epaint_default_fonts::HACK_REGULAR,
        CHINESE_FONT,
    ]
    .map(|font| FontRef::new(font).expect("a font"));
    let known = |character: char| {
        character.is_control()
            || fonts
                .iter()
                .any(|font| font.charmap().map(character).is_some())
    };
    let missing: BTreeSet<char> = FILES
        .iter()
        .flat_map(|files| files.iter())
        .flat_map(|(_, file)| file.chars())
        .filter(|character| !known(*character))
        .collect();
    assert!(missing.is_empty(), "no font has {missing:?}: run .ci/font");
}
