//! *Find a command*: whatever the window can do or show, found by its name in any language, typing errors forgiven.

use super::commands::{Command, SECTIONS};
use super::menu::APPEARANCE_CHOICES;
use crate::app::controls::has_row;
use crate::app::session::action::{Action, Requests, Turn};
use crate::app::session::window::WindowState;
use crate::app::views::GROUPS;
use crate::app::views::compare::VIEWS;
use crate::app::widgets::dialog::Choice;
use crate::app::widgets::focus::named;
use crate::app::widgets::theme::text_field;
use crate::app::widgets::typeset::letters;
use crate::lesson::{LESSONS, are_there};
use crate::scene::parameter::Parameter;
use crate::scene::{Symbol, presets};
use crate::text::{Language, in_language, text};
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Button, Key, Layout, Modifiers, RichText, ScrollArea, Ui};

/// The maximum number of entries on offer.
const MOST: usize = 12;
/// The distance added where a word is only in an entry's help.
const IN_HELP: usize = 1;
/// The distance added for a scene or a lesson: a setting whose help has the same word comes first.
const AFTER: usize = 1;
/// The distance added for a word with a typing error: more than any other words come to.
const MISTYPED: usize = 1000;

/// The state of the search.
#[derive(Default)]
pub struct Finder {
    /// Everything that can be found; made when the search is first opened.
    entries: Vec<Entry>,
    sought: String,
    /// The place of the chosen entry among those on offer.
    chosen: usize,
}

impl Finder {
    /// Forgets what was sought.
    pub fn leave(&mut self) {
        *self = Self::default();
    }
}

/// Something that can be found.
struct Entry {
    name: String,
    /// Its kind, or the key that does it.
    kind: String,
    /// Its names in all languages, and the same with its help, in lower case.
    names: Vec<String>,
    with_help: Vec<String>,
    action: Action,
}

impl Entry {
    /// Creates an entry from functions that return its name, its kind and its help in the current language.
    fn new(
        action: Action,
        kind: &str,
        name: impl Fn() -> String,
        help: impl Fn() -> String,
    ) -> Self {
        let in_all = |text: &dyn Fn() -> String| {
            let texts = Language::ALL
                .into_iter()
                .map(|language| in_language(language, text));
            texts.map(|text| text.to_lowercase()).collect()
        };
        Self {
            kind: kind.to_owned(),
            names: in_all(&name),
            with_help: in_all(&|| format!("{} {}", name(), help())),
            name: name(),
            action,
        }
    }

    /// Returns the distance of the entry from the words `sought`, or `None` if one of them is not in it.
    fn distance(&self, sought: &str) -> Option<usize> {
        let in_one = |text: &String| -> Option<usize> {
            let words = sought.split_whitespace();
            words.map(|word| distance(word, text)).sum()
        };
        let in_names = self.names.iter().filter_map(in_one);
        let in_help = self.with_help.iter().filter_map(in_one);
        let after = matches!(
            self.action,
            Action::OpenBuiltIn(_) | Action::Course(Turn::Open(_))
        );
        let nearest = in_names.chain(in_help.map(|far| far + IN_HELP)).min()?;
        Some(nearest + if after { AFTER } else { 0 })
    }
}

/// Returns how far `word` is from a word of `text`: 0 for the same, 1 for the beginning, 2 for a part, [`MISTYPED`] and more
/// for each letter mistyped.
fn distance(word: &str, text: &str) -> Option<usize> {
    let length = word.chars().count();
    let separate = |c: char| !c.is_alphanumeric();
    let near = |known: &str| {
        if known == word {
            return Some(0);
        }
        if known.starts_with(word) {
            return Some(1);
        }
        let mistyped = strsim::osa_distance(word, known);
        (length >= 3 && mistyped <= (length + 1) / 4).then_some(MISTYPED + mistyped)
    };
    let inside = text.contains(word).then_some(2);
    text.split(separate).filter_map(near).chain(inside).min()
}

/// Returns everything that can be found: commands, views, settings, letters, scenes and lessons.
fn entries() -> Vec<Entry> {
    let empty = String::new;
    let mut entries = Vec::new();
    let commands = SECTIONS.iter().flat_map(|section| &section.commands);
    let single = |command: &&Command| command.in_menu && command.actions.len() == 1;
    for command in commands.filter(single) {
        let (action, keys) = (command.actions[0].clone(), command.keys());
        let help = || command.does().unwrap_or_default().to_owned();
        let name = || command.name().trim_end_matches('…').to_owned();
        entries.push(Entry::new(action, keys, name, help));
    }
    for choice in &APPEARANCE_CHOICES {
        let name = || format!("{}: {}", text!(choice.setting), (choice.name)());
        let help = || text!(choice.tip).to_owned();
        let action = Action::ChangeAppearance(choice.choose);
        entries.push(Entry::new(action, text!("find-setting"), name, help));
    }
    for (view, name, help) in VIEWS {
        let name = || format!("{}: {}", text!("controls-group-compare"), text!(name));
        let help = || text!(help).to_owned();
        entries.push(Entry::new(Action::Compare(view), "", name, help));
    }
    for group in &GROUPS {
        for view in group.views {
            let (action, name) = (Action::View(view.key), || view.title().to_owned());
            let help = || format!("{} {}", group.title(), view.words());
            entries.push(Entry::new(action, text!("find-view"), name, help));
        }
    }
    for parameter in Parameter::all().filter(|parameter| has_row(parameter.key)) {
        let action = Action::Seek(parameter.key);
        let name = || match parameter.letter {
            "" => parameter.name().to_owned(),
            letter => format!("{letter} {}", parameter.name()),
        };
        let help = || parameter.help().to_owned();
        entries.push(Entry::new(action, text!("find-setting"), name, help));
    }
    // A letter whose setting has it in its name is there already.
    let is_setting = |(letter, symbol): &(String, Symbol)| {
        let mut settings = Parameter::all();
        settings.any(|one| one.letter == letter && one.symbol == Some(*symbol))
    };
    for (letter, symbol) in letters().filter(|letter| !is_setting(letter)) {
        let name = || format!("{letter} {}", symbol.meaning());
        let action = Action::SeekSymbol(symbol);
        entries.push(Entry::new(action, text!("find-letter"), name, empty));
    }
    for preset in presets::ALL {
        let action = Action::OpenBuiltIn(preset.name.to_owned());
        let (name, help) = (
            || preset.title().to_owned(),
            || format!("{} {}", preset.name, preset.sentence()),
        );
        entries.push(Entry::new(action, text!("find-scene"), name, help));
    }
    for lesson in LESSONS.iter().filter(|_| are_there()) {
        let action = Action::Course(Turn::Open(lesson.name.to_owned()));
        let name = || lesson.lesson().title.clone();
        let help = || lesson.name.to_owned();
        entries.push(Entry::new(action, text!("find-lesson"), name, help));
    }
    entries
}

/// Returns the entries that are sought, the nearest first. Typing errors are forgiven where nothing is found without.
fn ranked<'a>(entries: &'a [Entry], sought: &str) -> Vec<&'a Entry> {
    let distances = entries
        .iter()
        .filter_map(|entry| Some((entry.distance(sought)?, entry)));
    let mut found: Vec<_> = distances.collect();
    found.sort_by_key(|(distance, _)| *distance);
    if found
        .first()
        .is_some_and(|(nearest, _)| *nearest < MISTYPED)
    {
        found.retain(|(distance, _)| *distance < MISTYPED);
    }
    found.truncate(MOST);
    found.into_iter().map(|(_, entry)| entry).collect()
}

/// Shows the search. Enter or a click does what is chosen.
pub fn find_ui(ui: &mut Ui, window: &mut WindowState, requests: &mut Requests) -> Choice {
    let mut finder: Finder = window.own.take();
    if finder.entries.is_empty() {
        finder.entries = entries();
    }
    let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    let [up, down, enter] = [Key::ArrowUp, Key::ArrowDown, Key::Enter].map(pressed);
    let before = finder.sought.clone();
    let field = text_field(&mut finder.sought)
        .hint_text(text!("find-hint"))
        .desired_width(f32::INFINITY);
    let field = named(ui.add(field), Role::SearchInput, text!("find"));
    if !field.has_focus() {
        field.request_focus();
    }
    ui.add_space(6.0);
    let sought = finder.sought.trim().to_lowercase();
    let found = ranked(&finder.entries, &sought);
    if finder.sought != before {
        finder.chosen = 0;
    }
    let last = found.len().saturating_sub(1);
    finder.chosen = (finder.chosen + usize::from(down))
        .saturating_sub(usize::from(up))
        .min(last);
    let mut taken = None;
    ScrollArea::vertical().show(ui, |ui| {
        for (place, entry) in found.iter().enumerate() {
            let chosen = place == finder.chosen;
            if entry_ui(ui, entry, chosen) || chosen && enter {
                taken = Some(entry.action.clone());
            }
        }
    });
    if found.is_empty() {
        ui.label(text!("find-none", sought = finder.sought.trim()));
    }
    let choice = if let Some(action) = taken {
        requests.ask(action);
        Choice::Leave
    } else {
        Choice::Stay
    };
    window.own.put(finder);
    choice
}

/// Shows an entry, and returns whether it was clicked.
fn entry_ui(ui: &mut Ui, entry: &Entry, chosen: bool) -> bool {
    let mut kind = RichText::new(&entry.kind);
    // Weak text is not readable on the colour of the selection.
    if !chosen {
        kind = kind.weak();
    }
    ui.with_layout(Layout::top_down_justified(Align::Min), |ui| {
        let button = Button::selectable(chosen, entry.name.as_str()).right_text(kind);
        ui.add(button).clicked()
    })
    .inner
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the actions of the first three entries found.
    fn first(sought: &str) -> Vec<String> {
        let entries = entries();
        let found = ranked(&entries, sought).into_iter();
        let actions = found.map(|entry| format!("{:?}", entry.action));
        actions.take(3).collect()
    }

    #[test]
    fn names_are_found_in_both_languages_with_typing_errors() {
        for (sought, found) in [
            ("undo", "Undo"),
            ("復原", "Undo"),
            ("udno", "Undo"),
            ("exprot picture", "Export"),
            ("fog", "Seek(\"depth_cueing.by\")"),
            ("mist", "Seek(\"depth_cueing.by\")"),
            ("fgo", "Seek(\"depth_cueing.by\")"),
            ("fogg", "Seek(\"depth_cueing.by\")"),
            ("exponent", "Seek(\"material.n\")"),
            ("normal", "SeekSymbol(Normal)"),
            ("單位法向量", "SeekSymbol(Normal)"),
            ("teapot", "OpenBuiltIn(\"teapot\")"),
            ("茶壺", "OpenBuiltIn(\"teapot\")"),
            ("reset scene", "ResetScene"),
            ("flat", "mode: Flat"),
            ("gouraud", "mode: Gouraud"),
            ("wipe", "Compare(Wipe)"),
            ("line profile", "View(Profile)"),
            ("intensity along a line", "View(Profile)"),
            ("亮度曲線", "View(Profile)"),
            ("scan conversion", "View(ScanLine)"),
        ] {
            let actions = first(sought);
            let is_there = actions.iter().any(|action| action.contains(found));
            assert!(is_there, "{sought}: {actions:?}");
        }
    }

    #[test]
    fn themes_and_languages_are_found_by_the_words_of_either_language() {
        let entries = entries();
        let name = |sought: &str| {
            let found = ranked(&entries, sought);
            found.first().map(|entry| entry.name.clone())
        };
        for (sought, wanted) in [
            ("dark", "Theme: Dark"),
            ("light theme", "Theme: Light"),
            ("深色", "Theme: Dark"),
            ("chinese", "Language: 繁體中文"),
            ("中文", "Language: 繁體中文"),
            ("english", "Language: English"),
        ] {
            assert_eq!(name(sought).as_deref(), Some(wanted), "{sought}");
        }
        assert!(name("language").is_some_and(|name| name.starts_with("Language")));
    }

    #[test]
    fn what_is_nowhere_is_not_found() {
        for sought in ["xyzzy", "undo xyzzy", "qqqqqqqq"] {
            assert!(first(sought).is_empty(), "{sought}");
        }
    }

    #[test]
    fn nothing_that_resembles_stands_beside_what_was_meant() {
        let entries = entries();
        let found = ranked(&entries, "fog");
        assert!(matches!(found[0].action, Action::Seek(_)));
        for entry in found {
            let texts = entry.with_help.concat();
            assert!(texts.contains("fog"), "{:?}", entry.action);
        }
    }
}
