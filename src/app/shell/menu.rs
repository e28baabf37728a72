//! The commands of a menu, each with its key; a tick marks those that are on.

use super::commands::{Command, SECTIONS};
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::appearance::Appearance;
use crate::app::session::window::WindowState;
use crate::app::system;
use crate::app::widgets::focus::{named, switch_named};
use crate::app::widgets::mark::ticked;
use crate::app::widgets::theme::ThemeChoice;
use crate::scene::ShadingMode;
use crate::text::{Language, text};
use eframe::egui::accesskit::Role;
use eframe::egui::style::ScrollStyle;
use eframe::egui::{Button, ScrollArea, Ui};

/// The width of a menu, in points.
const WIDTH: f32 = 264.0;
/// The width reserved for ticks, in points.
const TICK: f32 = 16.0;
/// The space between the items of a menu, in points: the longest menu fits a window that is 800 points high.
const GAP: f32 = 2.0;
/// The height of a window that its menus leave free, for the bar and their margins, in heights of a control.
const FREE: f32 = 2.5;
/// The number of items between two lines that stay in a menu for fingers; more have a menu of their own.
const MANY: usize = 8;
/// The commands that a window without keys does not need in its menus: the rail opens the panels, and nobody presses keys.
const FOR_KEYS: [&str; 6] = [
    "controls",
    "views",
    "stages",
    "next-view",
    "projector",
    "keys",
];

/// A value of a setting of the appearance that is one of several.
pub struct AppearanceChoice {
    /// The key of the setting's name.
    pub setting: &'static str,
    pub name: fn() -> &'static str,
    /// The key of its description.
    pub tip: &'static str,
    pub choose: fn(&mut Appearance),
}

impl AppearanceChoice {
    /// Returns whether choosing it would change nothing.
    fn is_chosen(&self, appearance: &Appearance) -> bool {
        let mut chosen = appearance.clone();
        (self.choose)(&mut chosen);
        chosen == *appearance
    }
}

/// The themes and the languages.
pub const APPEARANCE_CHOICES: [AppearanceChoice; 6] = [
    AppearanceChoice {
        setting: "controls-theme",
        name: || text!("theme-system"),
        tip: "theme-system.tip",
        choose: |appearance| appearance.theme = ThemeChoice::System,
    },
    AppearanceChoice {
        setting: "controls-theme",
        name: || text!("theme-dark"),
        tip: "theme-dark.tip",
        choose: |appearance| appearance.theme = ThemeChoice::Dark,
    },
    AppearanceChoice {
        setting: "controls-theme",
        name: || text!("theme-light"),
        tip: "theme-light.tip",
        choose: |appearance| appearance.theme = ThemeChoice::Light,
    },
    AppearanceChoice {
        setting: "language",
        name: || text!("language-system"),
        tip: "language-system.tip",
        choose: |appearance| appearance.language = None,
    },
    AppearanceChoice {
        setting: "language",
        name: || Language::English.name(),
        tip: "language-english",
        choose: |appearance| appearance.language = Some(Language::English),
    },
    AppearanceChoice {
        setting: "language",
        name: || Language::TraditionalChinese.name(),
        tip: "language-chinese",
        choose: |appearance| appearance.language = Some(Language::TraditionalChinese),
    },
];

/// Shows a menu of the values of a setting of [`APPEARANCE_CHOICES`].
pub fn appearance_ui(ui: &mut Ui, window: &WindowState, requests: &mut Requests, setting: &str) {
    ui.menu_button(text!(setting), |ui| {
        let all = APPEARANCE_CHOICES.iter();
        for choice in all.filter(|choice| choice.setting == setting) {
            let chosen = choice.is_chosen(&window.appearance);
            let radio = ui.radio(chosen, (choice.name)());
            if radio.on_hover_text(text!(choice.tip)).clicked() {
                requests.ask(Action::ChangeAppearance(choice.choose));
            }
        }
    });
}

/// Shows the items of the menu named `menu`.
pub fn commands_ui(
    ui: &mut Ui,
    session: &Session,
    window: &mut WindowState,
    requests: &mut Requests,
    menu: &str,
) {
    let Some(section) = SECTIONS.iter().find(|section| section.key == menu) else {
        return;
    };
    ui.set_min_width(WIDTH);
    let fingers = system::fingers(ui.ctx());
    let without_bar = window.drawer || window.enlarged;
    let left_out = |command: &Command| {
        fingers && FOR_KEYS.contains(&command.key) || without_bar && command.key == "stages"
    };
    let mut shown = false;
    for part in section.commands.split(Command::is_line) {
        let items: Vec<&Command> = (part.iter())
            .filter(|command| command.in_menu && !left_out(command))
            .collect();
        if items.is_empty() {
            continue;
        }
        if std::mem::replace(&mut shown, true) {
            ui.separator();
        }
        if fingers && items.len() > MANY {
            ui.menu_button(text!("menu-overlays"), |ui| {
                scrolled(ui, |ui| items_ui(ui, session, window, requests, &items));
            });
        } else {
            items_ui(ui, session, window, requests, &items);
        }
    }
}

/// Shows the content of a menu. If the window is too low for it, it scrolls beside a scroll bar that is always visible.
pub fn scrolled<R>(ui: &mut Ui, content: impl FnOnce(&mut Ui) -> R) -> R {
    let most = ui.ctx().content_rect().height() - FREE * ui.spacing().interact_size.y;
    let most = most.max(0.0);
    ui.spacing_mut().item_spacing.y = GAP;
    ui.spacing_mut().scroll = ScrollStyle {
        foreground_color: true,
        ..ScrollStyle::solid()
    };
    ScrollArea::vertical()
        .max_height(most)
        .min_scrolled_height(most)
        .show(ui, content)
        .inner
}

fn items_ui(
    ui: &mut Ui,
    session: &Session,
    window: &mut WindowState,
    requests: &mut Requests,
    commands: &[&Command],
) {
    let has_ticks = commands
        .iter()
        .any(|command| is_on(command, session, window).is_some());
    for command in commands {
        item_ui(ui, session, window, requests, command, has_ticks);
    }
}

fn item_ui(
    ui: &mut Ui,
    session: &Session,
    window: &mut WindowState,
    requests: &mut Requests,
    command: &Command,
    has_ticks: bool,
) {
    let Some(action) = command.actions.first() else {
        return;
    };
    // The changes to be undone and redone are named.
    let change = match action {
        Action::Undo => Some(session.history().undoable()),
        Action::Redo => Some(session.history().redoable()),
        _ => None,
    };
    let waits = action.waits() && session.lock.is_some();
    let idle = change == Some(None) || waits;
    let name = format!(
        "{} {}",
        command.name(),
        change.flatten().unwrap_or_default()
    );
    let name = name.trim_end();
    let on = is_on(command, session, window);
    let button = if has_ticks {
        Button::new((ticked(TICK, on == Some(true)), name))
    } else {
        Button::new(name)
    };
    // Fingers have no keys to press.
    let keys = if system::fingers(ui.ctx()) {
        ""
    } else {
        command.keys()
    };
    let response = ui.add_enabled(!idle, button.shortcut_text(keys));
    let response = if waits {
        response.on_disabled_hover_text(text!("course-after-answer"))
    } else {
        response
    };
    let response = match on {
        Some(on) => switch_named(response, Role::CheckBox, on, name),
        None => named(response, Role::Button, name),
    };
    if response.clicked() {
        requests.ask(action.clone());
        if on.is_none() {
            ui.close();
        }
    }
}

/// Returns whether the setting that a command switches is on; `None` if the command is not a switch.
fn is_on(command: &Command, session: &Session, window: &mut WindowState) -> Option<bool> {
    let shading = &session.shown.scene.shading;
    match command.actions.first()? {
        Action::Show(switch) => Some(*switch(&mut window.appearance)),
        Action::Shade { mode, renormalise } => {
            let kept = *mode != ShadingMode::Phong || shading.renormalise == *renormalise;
            Some(shading.mode == *mode && kept)
        }
        Action::PictureAlone => Some(window.picture_alone),
        _ => None,
    }
}
