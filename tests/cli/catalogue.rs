//! The message catalogue: both languages have the same messages with the same variables, and `src` uses each.

use fluent_bundle::FluentResource;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use shading_lab::analysis::Format;
use shading_lab::analysis::stability::{Topic, Verdict, stability_cases};
use shading_lab::analysis::study::Method;
use shading_lab::lesson::LESSONS;
use shading_lab::scene::Choice;
use shading_lab::scene::parameter::Parameter;
use shading_lab::scene::{materials, presets};
use shading_lab::text::{FILES, Language, chinese_font};
use skrifa::{FontRef, MetadataProvider};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Returns the keys of a language with their variables; an attribute's key is `key.attribute`.
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

/// Finds each `text!("key", name = …)` and `limit!(…)` of a source; returns its key and the names of its variables.
fn uses(source: &str) -> Vec<(String, BTreeSet<String>)> {
    let mut uses = Vec::new();
    let macros = ["text!(", "limit!("];
    let found = macros.map(|call| source.match_indices(call).collect::<Vec<_>>());
    for (at, call) in found.concat() {
        let rest = source[at + call.len()..].trim_start();
        let Some(quoted) = rest.strip_prefix('"') else {
            continue;
        };
        let Some((key, rest)) = quoted.split_once('"') else {
            continue;
        };
        // The arguments up to the parenthesis that closes the macro; a name follows directly after a comma outside nested
        // parentheses.
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

/// Families of messages whose keys are composed of names in the code.
const DERIVED: [&str; 9] = [
    "parameter-",
    "choice-",
    "scene-",
    "topic-",
    "material-",
    "engine-case-",
    COMMAND_LINE,
    // Commands check theirs where they are defined.
    "controls-command-",
    "controls-group-",
];

/// Prefix of the command line's help; `src/cli/help.rs` has a test of its own.
const COMMAND_LINE: &str = "cli-help-";

/// Returns the keys of the [`DERIVED`] families, composed of the existing names.
fn derived() -> BTreeSet<String> {
    // The keys of a model's materials are called as those of the scene's own.
    let named =
        |key: &str| !key.starts_with("object.material.N") || key == "object.material.N.name";
    let parameters = Parameter::all().filter(|parameter| named(parameter.key));
    let parameters = parameters.flat_map(|parameter| {
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
    let scenes = presets::ALL.iter().flat_map(|preset| {
        let name = format!("scene-{}", preset.name);
        [
            format!("{name}.sentence"),
            name,
            format!("topic-{}", preset.topic),
        ]
    });
    let materials = materials::NAMED.iter();
    let materials = materials.map(|material| format!("material-{}", material.name));
    let cases = stability_cases().flat_map(|case| {
        let name = format!("engine-case-{}", case.name);
        ["", ".naive", ".engine"].map(|part| format!("{name}{part}"))
    });
    parameters
        .chain(options)
        .chain(scenes)
        .chain(materials)
        .chain(cases)
        .collect()
}

#[test]
fn whatever_is_named_by_a_family_has_its_messages_and_no_other_has() {
    let of_families: BTreeSet<String> = messages(0)
        .into_keys()
        .filter(|key| DERIVED.iter().any(|family| key.starts_with(family)))
        .filter(|key| key != "parameter-of-light")
        .filter(|key| !key.starts_with(COMMAND_LINE) && !key.starts_with("controls-"))
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
fn every_character_of_the_catalogue_has_a_glyph() {
    let fonts = [
        epaint_default_fonts::UBUNTU_LIGHT,
        epaint_default_fonts::HACK_REGULAR,
        chinese_font(),
    ]
    .map(|font| FontRef::new(font).expect("a font"));
    let known = |character: char| {
        character.is_control()
            || fonts
                .iter()
                .any(|font| font.charmap().map(character).is_some())
    };
    let lessons = LESSONS
        .iter()
        .flat_map(|lesson| Language::ALL.map(|language| lesson.lesson_in(language).source));
    let missing: BTreeSet<char> = FILES
        .iter()
        .flat_map(|files| files.iter())
        .map(|(_, file)| (*file).to_owned())
        .chain(lessons)
        .flat_map(|file| file.chars().collect::<Vec<_>>())
        .filter(|character| !known(*character))
        .collect();
    assert!(missing.is_empty(), "no font has {missing:?}: run .ci/font");
}

/// Files whose literals are in another language: exported programs, markup.
const CODE: [&str; 18] = [
    "src/class/events.rs",
    "src/class/files.rs",
    "src/class/page",
    "src/class/routes.rs",
    "src/cli/examples.rs",
    "src/export/",
    "src/expression/functions.rs",
    "src/figure/svg.rs",
    "src/figure/typed.rs",
    "src/lesson/class_sheet.rs",
    "src/lesson/html.rs",
    "src/lesson/kinds.rs",
    "src/lesson/kinds/formula/engine.rs",
    "src/lesson/page.rs",
    "src/lesson/worksheet.rs",
    "src/scene/law.rs",
    "src/text.rs",
    "src/scene/format/",
];

/// Macros and methods whose literals only programmers read.
const UNREAD: [&str; 14] = [
    "attribute",
    "class",
    "expect",
    "debug_struct",
    "text",
    "unreachable",
    "panic",
    "assert",
    "assert_eq",
    "assert_ne",
    "debug_assert",
    "debug_assert_eq",
    "env",
    "include_str",
];

/// Collects the literals of a token stream that people read.
fn read_by_people(tokens: TokenStream, found: &mut Vec<String>) {
    let mut tokens = tokens.into_iter().peekable();
    let (mut test_follows, mut before) = (false, String::new());
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(mark) if mark.as_char() == '#' => {
                if matches!(tokens.peek(), Some(TokenTree::Punct(mark)) if mark.as_char() == '!') {
                    tokens.next();
                }
                if let Some(TokenTree::Group(group)) = tokens.peek()
                    && group.delimiter() == Delimiter::Bracket
                {
                    test_follows |= group.stream().to_string() == "cfg (test)";
                    tokens.next();
                }
            }
            TokenTree::Punct(mark) => {
                if mark.as_char() == ';' {
                    test_follows = false;
                }
                if mark.as_char() != '!' {
                    before.clear();
                }
            }
            TokenTree::Ident(ident) => before = ident.to_string(),
            TokenTree::Group(group) => {
                let tested = test_follows && group.delimiter() == Delimiter::Brace;
                test_follows &= !tested;
                if !tested && !UNREAD.contains(&before.as_str()) {
                    read_by_people(group.stream(), found);
                }
                before.clear();
            }
            TokenTree::Literal(literal) => {
                if let Ok(text) = syn::parse_str::<syn::LitStr>(&literal.to_string())
                    && is_prose(&text.value())
                {
                    found.push(text.value());
                }
            }
        }
    }
}

/// Returns whether a literal contains words rather than names, keys, letters of formulas or numbers.
fn is_prose(text: &str) -> bool {
    let mut bare = String::new();
    let mut depth = 0;
    for c in text.chars() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ if depth == 0 => bare.push(c),
            _ => {}
        }
    }
    let words = bare
        .split(|c: char| !c.is_alphabetic())
        .filter(|word| word.chars().count() > 2)
        .count();
    let is_name = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || "_.-:/=#*".contains(c);
    let is_constant = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
    let trimmed = bare.trim();
    words > 0 && !trimmed.chars().all(is_name) && !trimmed.chars().all(is_constant)
}

#[test]
fn no_text_that_people_read_is_left_in_the_sources() {
    let mut left = Vec::new();
    for (file, source) in all_sources() {
        let name = file.trim_start_matches(concat!(env!("CARGO_MANIFEST_DIR"), "/"));
        if CODE.iter().any(|code| name.starts_with(code)) {
            continue;
        }
        let mut found = Vec::new();
        read_by_people(source.parse().expect("tokens"), &mut found);
        found.retain(|text| !KEPT.contains(&text.as_str()) && !is_keys(text));
        left.extend(found.into_iter().map(|text| format!("{name}: {text:?}")));
    }
    assert!(
        left.is_empty(),
        "{} are left:\n{}",
        left.len(),
        left.join("\n")
    );
}

/// Names that are the same in every language, keys of the keyboard aside: [`is_keys`] recognises those.
const KEPT: [&str; 39] = [
    // The name of the standard input.
    "<stdin>",
    // Names of people, of letters and of this program.
    "Phong",
    "Blinn",
    "Irefl",
    "Itrans",
    "Idc",
    "{name}{mark} — shading-lab",
    // Text that programs read.
    "Next:",
    " at line 1 ",
    "# A scene of shading-lab\nversion = {}\n",
    "# Unsaved work of shading-lab, from ",
    "light = []\n",
    "light.N.name",
    "sqrt(",
    "square units",
    "diffuse + specular",
    "sRGB",
    "Software",
    "y,x,p_x,q_x,alpha_p,alpha_q,alpha,value_r,value_g,value_b,barycentric_r,barycentric_g,barycentric_b",
    "libX11.so.6",
    "libX11-xcb.so.1",
    "libXcursor.so.1",
    "libXi.so.6",
    // Options before an error.
    "--set {}: ",
    "--from {} --to {}: {error}",
    "--overlay profile: {error}",
    // Formulas.
    "   seen: {s0} I + (1 − {s0}) {Idc}",
    "f = min(1, 1/({c1} + {c2} d + {c3} d²))",
    "{sign}{{N}}·{{L}} = {sign}{length}cos {theta:.2}°{}",
    "cos^{{{n}}} {:.2}°",
    "cosⁿ{letter}",
    // Names that programmers read.
    "Job",
    "Background",
    "Access",
    "Chinese",
    "shadingLab",
    "StabilityView",
    "Case",
    "Token",
];

/// Returns whether a text consists of keys of the keyboard, whose names are engraved on it.
fn is_keys(text: &str) -> bool {
    const NAMES: [&str; 12] = [
        "Ctrl", "Shift", "Tab", "Esc", "Space", "Home", "End", "PageUp", "PageDown", "Page", "up",
        "down",
    ];
    let mut parts = text.split_whitespace();
    parts.all(|part| part.chars().count() == 1 || NAMES.contains(&part))
}
