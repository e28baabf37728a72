//! The commands of the window: one table read by the keys, the menus and Help, and the effect of each command
//! on the state.

use crate::analysis::scan::ScanLevel;
use crate::app::course::Course;
use crate::app::picture::{handles, orbit};
#[cfg(feature = "class")]
use crate::app::session::action::ClassAction;
use crate::app::session::action::{Action, Requests, Turn, Walk};
use crate::app::session::appearance::{Appearance, ViewName};
use crate::app::session::notice::Notice;
use crate::app::session::place::ProbePoint;
use crate::app::session::window::WindowState;
use crate::app::shell::state::AppState;
use crate::app::system;
use crate::app::views::after;
use crate::app::views::scan::ScanView;
use crate::app::widgets::focus;
#[cfg(feature = "class")]
use crate::class::Command as ClassCommand;
use crate::link::is_link;
use crate::scene::{Light, Scene, ShadingMode};
use crate::text;
use eframe::egui::{Context, Event, Key, Modifiers, Popup};
use std::mem;
use std::sync::LazyLock;

/// The sections that are menus, in the order of the bar; "compare" is a submenu of "view".
#[cfg(feature = "class")]
pub const MENUS: [&str; 6] = ["file", "edit", "view", "scene", "course", "help"];
#[cfg(not(feature = "class"))]
pub const MENUS: [&str; 5] = ["file", "edit", "view", "scene", "help"];

/// A group of commands: a menu, a part of Help, or both.
pub struct Section {
    /// The name in the catalogue, `controls-group-KEY`.
    pub key: &'static str,
    pub commands: Vec<Command>,
}

/// A command, or several similar ones.
#[derive(Default)]
pub struct Command {
    /// The name in the catalogue, `controls-command-KEY`: the text in the menu, and with `.does` the text in
    /// Help. Empty for a line between the items of a menu, and for further keys of a command.
    pub key: &'static str,
    /// The modifiers, then each key, separated by spaces.
    keys: &'static str,
    /// True for an item of the menu.
    pub in_menu: bool,
    /// The action of each key; none for gestures. The menu uses the first.
    pub actions: Vec<Action>,
}

impl Command {
    /// Returns the text in the menu.
    pub fn name(&self) -> &'static str {
        text!(&format!("controls-command-{}", self.key))
    }

    /// Returns the text in Help, if the command appears there.
    pub fn does(&self) -> Option<&'static str> {
        let stands = !self.key.is_empty() && (self.actions.is_empty() || !self.keys.is_empty());
        stands.then(|| text!(&format!("controls-command-{}.does", self.key)))
    }

    /// Returns the keys, or the gesture, as Help and the menus show them.
    pub fn keys(&self) -> &'static str {
        if self.keys.is_empty() && self.actions.is_empty() {
            text!(&format!("controls-command-{}.gesture", self.key))
        } else {
            self.keys
        }
    }

    /// Returns whether this is a line between the items of a menu.
    pub fn is_line(&self) -> bool {
        self.key.is_empty() && self.actions.is_empty()
    }

    /// Returns the keys with their actions.
    fn bindings(&self) -> impl Iterator<Item = (Modifiers, Key, &Action)> {
        let (command, keys) = held("Ctrl + ", self.keys);
        let (shift, keys) = held("Shift + ", keys);
        let modifiers = Modifiers {
            command,
            shift,
            ..Modifiers::NONE
        };
        keys.split(' ')
            .filter_map(key)
            .zip(&self.actions)
            .map(move |(key, action)| (modifiers, key, action))
    }
}

/// Returns whether the keys begin with the modifier `name`, and the rest of them.
fn held(name: &str, keys: &'static str) -> (bool, &'static str) {
    keys.strip_prefix(name)
        .map_or((false, keys), |rest| (true, rest))
}

fn key(name: &str) -> Option<Key> {
    match name {
        "←" => Some(Key::ArrowLeft),
        "→" => Some(Key::ArrowRight),
        "↑" => Some(Key::ArrowUp),
        "↓" => Some(Key::ArrowDown),
        _ => Key::from_name(name),
    }
}

impl Section {
    fn new(key: &'static str) -> Self {
        Self {
            key,
            commands: vec![],
        }
    }

    /// Returns the title in the menu and in Help.
    pub fn title(&self) -> &'static str {
        text!(&format!("controls-group-{}", self.key))
    }

    fn with(mut self, command: Command) -> Self {
        self.commands.push(command);
        self
    }

    /// Adds an item of the menu; without keys it does not appear in Help.
    fn item(self, key: &'static str, keys: &'static str, action: Action) -> Self {
        self.with(Command {
            key,
            keys,
            in_menu: true,
            actions: vec![action],
        })
    }

    /// Adds keys that appear only in Help.
    fn keys(
        self,
        key: &'static str,
        keys: &'static str,
        actions: impl IntoIterator<Item = Action>,
    ) -> Self {
        self.with(Command {
            key,
            keys,
            actions: actions.into_iter().collect(),
            ..Command::default()
        })
    }

    /// Adds a gesture.
    fn gesture(self, key: &'static str) -> Self {
        self.keys(key, "", [])
    }

    /// Adds a line between the items of a menu.
    fn line(self) -> Self {
        self.with(Command::default())
    }
}

/// The degrees that one key press turns the camera.
const TURN: f64 = 5.0;
/// The distance that one key press shifts the camera, in heights of the picture.
const SHIFTED: f64 = 0.05;
/// The factor by which one key press multiplies the distance.
const NEARER: f64 = 0.9;
/// The steps of the arrow keys left, right, up and down, in pixels; ten times as long with the shift key.
const ARROWS: [[i32; 2]; 4] = [[-1, 0], [1, 0], [0, -1], [0, 1]];
/// The directions of the camera: left, right, up and down.
const WAYS: [[f64; 2]; 4] = [[-1.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];

fn walk(level: ScanLevel) -> [Action; 2] {
    [Walk::Back(level), Walk::Forward(level)].map(Action::Scan)
}

/// All commands. In a section that is a menu, they are in the order of its items.
pub static SECTIONS: LazyLock<Vec<Section>> = LazyLock::new(|| {
    vec![
        file(),
        edit(),
        view(),
        compare(),
        scene(),
        probe(),
        camera(),
        scan(),
        course(),
        help(),
    ]
});

fn file() -> Section {
    let section = Section::new("file")
        .item("open", "Ctrl + O", Action::Open)
        .item("scenes", "F2", Action::Scenes)
        .line()
        .item("save", "Ctrl + S", Action::Save)
        .item("save-as", "Ctrl + Shift + S", Action::SaveAs)
        .item("export", "Ctrl + E", Action::Export)
        .item("hand-in", "", Action::HandIn)
        .item("set-target", "", Action::SetTarget)
        .line()
        .item("copy-link", "Ctrl + Shift + L", Action::CopyLink);
    // A web page has an address of its own, and the browser closes it.
    if system::PAGE {
        return section;
    }
    section
        .item("page", "", Action::Page)
        .line()
        .item("quit", "Ctrl + Q", Action::Quit)
}

fn edit() -> Section {
    Section::new("edit")
        .item("undo", "Ctrl + Z", Action::Undo)
        .item("redo", "Ctrl + Shift + Z", Action::Redo)
        .keys("", "Ctrl + Y", [Action::Redo])
        .line()
        .item("copy", "Ctrl + C", Action::CopyPicture)
        .item("code", "Ctrl + U", Action::Code)
        .line()
        .item("reset-scene", "", Action::ResetScene)
        .item("reset-all", "", Action::ResetAll)
        .keys("reset-row", "Ctrl + R", [Action::ResetRow])
        .keys("next-field", "Tab", [])
        .keys("leave", "Esc", [])
}

fn view() -> Section {
    let (show, change) = (Action::Show, Action::ChangeAppearance);
    Section::new("view")
        .item("controls", "F4", show(|shown| &mut shown.controls))
        .item("views", "F5", show(|shown| &mut shown.views))
        .item("stages", "F6", show(|shown| &mut shown.stages))
        .item("next-view", "C", change(next_view))
        .line()
        .item("vectors", "V", show(|shown| &mut shown.overlay.vectors))
        .item("angles", "", show(|shown| &mut shown.overlay.angles))
        .item(
            "construction",
            "",
            show(|shown| &mut shown.overlay.construction),
        )
        .item("side-view", "", show(|shown| &mut shown.overlay.side_view))
        .item(
            "side-view-where-needed",
            "",
            show(|shown| &mut shown.overlay.side_view_where_needed),
        )
        .item("lobe", "B", show(|shown| &mut shown.overlay.lobe))
        .item(
            "half-vector",
            "",
            show(|shown| &mut shown.overlay.half_vector),
        )
        .item("handles", "L", show(|shown| &mut shown.overlay.handles))
        .item("normals", "M", change(Appearance::switch_normals))
        .item(
            "face-normals",
            "",
            show(|shown| &mut shown.overlay.face_normals),
        )
        .item(
            "vertex-normals",
            "",
            show(|shown| &mut shown.overlay.vertex_normals),
        )
        .item("channels", "", show(|shown| &mut shown.channels))
        .item("smooth-edges", "", show(|shown| &mut shown.smooth_edges))
        .line()
        .item("picture-alone", "F11", Action::PictureAlone)
        .item("projector", "F9", change(Appearance::projector))
        .item("link-code", "Q", Action::ShowCode)
        .item("larger", "Ctrl + +", change(Appearance::larger))
        .item("smaller", "Ctrl + −", change(Appearance::smaller))
        .item(
            "ordinary-size",
            "Ctrl + 0",
            change(Appearance::ordinary_size),
        )
        .item("reset-layout", "", Action::ResetLayout)
}

fn compare() -> Section {
    Section::new("compare")
        .item("next-comparison", "K", Action::NextComparison)
        .item("next-pane", "N", Action::NextPane)
        .line()
        .item("all-modes", "", Action::AllModes)
        .item("panes", "", Action::View(ViewName::Compare))
        .item("defects", "", Action::View(ViewName::Defects))
}

fn scene() -> Section {
    let shade = |mode, renormalise| Action::Shade { mode, renormalise };
    Section::new("scene")
        .item("flat", "1", shade(ShadingMode::Flat, true))
        .item("interpolated", "2", shade(ShadingMode::Interpolated, true))
        .item("gouraud", "3", shade(ShadingMode::Gouraud, true))
        .item("phong", "4", shade(ShadingMode::Phong, true))
        .item("exact", "5", shade(ShadingMode::Exact, true))
        .item("unnormalised", "6", shade(ShadingMode::Phong, false))
        .line()
        .gesture("next-scene")
        .item("add-light", "", Action::AddLight(Light::default()))
        .item("reset-camera", "0", Action::ResetCamera)
}

fn probe() -> Section {
    let stride = ARROWS.map(|way| Action::MoveProbe(way.map(|pixels| 10 * pixels)));
    Section::new("probe")
        .keys("take-probe", "F3", [Action::TakeProbe])
        .keys("probe-pixel", "← → ↑ ↓", ARROWS.map(Action::MoveProbe))
        .keys("probe-stride", "Shift + ← → ↑ ↓", stride)
        .gesture("probe-here")
}

fn camera() -> Section {
    let orbit = WAYS.map(|way| Action::Orbit(way.map(|part| TURN * part)));
    let pan = WAYS.map(|way| Action::Pan(way.map(|part| SHIFTED * part)));
    Section::new("camera")
        .keys("orbit", "A D W S", orbit)
        .keys("pan", "Shift + A D W S", pan)
        .keys("zoom", "+ −", [NEARER, 1.0 / NEARER].map(Action::Zoom))
        .gesture("drag")
        .gesture("deep-drag")
        .gesture("wheel")
}

fn scan() -> Section {
    let ends = [Walk::First, Walk::Last].map(Action::Scan);
    Section::new("scan")
        .keys("scan-pixel", ", .", walk(ScanLevel::Pixel))
        .keys("scan-edge", "[ ]", walk(ScanLevel::Edge))
        .keys("scan-line", "PageUp PageDown", walk(ScanLevel::Line))
        .keys("scan-ends", "Home End", ends)
        .keys("scan-play", "Space", [Action::Scan(Walk::Play)])
}

fn course() -> Section {
    let section = Section::new("course");
    #[cfg(feature = "class")]
    let section = section
        .item("lessons", "", Action::View(ViewName::Course))
        .item("teach", "", Action::Class(ClassAction::Teach))
        .item("class", "", Action::View(ViewName::Class))
        .gesture("class-step");
    section.gesture("course-step")
}

fn help() -> Section {
    Section::new("help")
        .item("find", "Ctrl + K", Action::Find)
        .item("manual", "", Action::Manual)
        .item("keys", "F1", Action::Keys)
        .keys("menus", "F10", [Action::Menus])
        .item("about", "", Action::About)
}

/// Shows the next view of the rail, or the curves if the panel is closed.
fn next_view(appearance: &mut Appearance) {
    appearance.view = if appearance.views {
        after(appearance.view)
    } else {
        ViewName::Curves
    };
    appearance.views = true;
}

/// Turns the keys pressed in this frame into actions. A focused widget other than the picture keeps its keys,
/// including digits: they may be meant for a field. Function keys and those with Ctrl always belong to the
/// window, except for those that fields use too.
pub fn listen(ctx: &Context, window: &mut WindowState, course: &Course, requests: &mut Requests) {
    let free = ctx.memory(|memory| {
        memory
            .focused()
            .is_none_or(|focused| focused == focus::picture_id())
    });
    let editing = ctx.text_edit_focused();
    let scanning = window.shows(ViewName::ScanLine);
    let lesson = course.open.is_some();
    ctx.input_mut(|input| {
        input.events.retain(|event| {
            let action = match event {
                // The window's back end turns Ctrl + C into this event.
                Event::Copy if !editing => Some(Action::CopyPicture),
                Event::Paste(text) if !editing && is_link(text) => {
                    Some(Action::OpenLink(text.clone()))
                }
                Event::Key {
                    key,
                    pressed: true,
                    modifiers,
                    ..
                } => {
                    let turns = modifiers.is_none() && (lesson || free && !scanning);
                    match key {
                        Key::PageUp if turns => Some(page_turn(course, -1)),
                        Key::PageDown if turns => Some(page_turn(course, 1)),
                        _ => find(*key, *modifiers)
                            .filter(|_| allowed(*key, *modifiers, free, editing))
                            .filter(|action| scanning || !matches!(action, Action::Scan(_))),
                    }
                }
                _ => None,
            };
            let taken = action.is_some();
            requests.extend(action);
            !taken
        });
    });
    // Escape leaves what was opened last.
    if !editing && ctx.input(|input| input.key_pressed(Key::Escape)) && !Popup::is_any_open(ctx) {
        let enlarged = mem::take(&mut window.appearance.overlay.side_view_enlarged);
        if window.picture_alone && !enlarged {
            requests.ask(Action::PictureAlone);
        }
    }
}

/// Returns the action of a key of a presenter's remote, which works anywhere in the window while a lesson is open.
fn page_turn(course: &Course, by: isize) -> Action {
    if let Some(action) = class_step(course, by) {
        action
    } else if course.open.is_some() {
        Action::Course(Turn::Step(by))
    } else {
        Action::NextScene(by)
    }
}

/// Returns the action of such a key while a live class is running.
#[cfg(feature = "class")]
fn class_step(course: &Course, by: isize) -> Option<Action> {
    let class = course.class.as_ref()?;
    let action = match by {
        1 if class.joining => ClassAction::Begin,
        1 => ClassAction::Onward,
        _ => ClassAction::Perform(ClassCommand::Back),
    };
    Some(Action::Class(action))
}

#[cfg(not(feature = "class"))]
fn class_step(_: &Course, _: isize) -> Option<Action> {
    None
}

fn find(key: Key, modifiers: Modifiers) -> Option<Action> {
    // Plus is a shifted key on many keyboards, often that of the equals sign.
    let key = if key == Key::Equals { Key::Plus } else { key };
    let shift = modifiers.shift && !matches!(key, Key::Plus | Key::Minus);
    let modifiers = Modifiers { shift, ..modifiers };
    let mut all = SECTIONS
        .iter()
        .flat_map(|section| &section.commands)
        .flat_map(Command::bindings);
    let (.., action) = all.find(|(wanted, k, _)| *k == key && modifiers.matches_exact(*wanted))?;
    Some(action.clone())
}

fn allowed(key: Key, modifiers: Modifiers, free: bool, editing: bool) -> bool {
    let function = matches!(
        key,
        Key::F1 | Key::F2 | Key::F3 | Key::F4 | Key::F5 | Key::F6 | Key::F9 | Key::F10 | Key::F11
    );
    let field_wants = editing && matches!(key, Key::Z | Key::Y | Key::C | Key::U);
    function || (modifiers.command && !field_wants) || free
}

impl AppState {
    /// Performs the actions that concern the state alone, and returns those that need the window, files or
    /// the clipboard.
    ///
    /// `size` is the picture's, in pixels.
    pub fn perform(&mut self, action: Action, size: [u32; 2]) -> Option<Action> {
        if action.waits() && self.session.lock.is_some() {
            self.session.say_locked();
            return None;
        }
        let camera = &mut self.session.shown.scene.camera;
        match action {
            Action::MoveProbe(by) if self.course.asks_point() => {
                let mark = ProbePoint(self.course.mark().unwrap_or_default());
                self.course.put_mark(mark.moved(by, size).0);
            }
            Action::Undo => {
                self.session.undo();
                self.follow_document();
            }
            Action::Redo => {
                self.session.redo();
                self.follow_document();
            }
            Action::ResetCamera => {
                let opened = self.session.opened().clone();
                orbit::reset(&mut self.session.shown, &opened, size);
            }
            Action::ResetScene => {
                let opened = self.session.opened().clone();
                let changed = self.session.document().scene != opened;
                self.session.put_scene(opened);
                self.session.notice = Some(if changed {
                    Notice::undoable(text!("window-scene-reset"))
                } else {
                    text!("window-scene-reset").into()
                });
            }
            Action::Shade { mode, renormalise } => {
                self.session.shown.scene.shading.mode = mode;
                self.session.shown.scene.shading.renormalise = renormalise;
            }
            Action::Compare(view) => self.session.compare(view),
            Action::NextComparison => self.session.compare(self.session.next_comparison()),
            Action::Activate(pane) => self.session.activate(pane),
            Action::NextPane => {
                let shown = self.session.document().scene.shown_panes();
                let place = shown
                    .iter()
                    .position(|pane| *pane == self.session.panes.active)
                    .unwrap_or(0);
                self.session.activate(shown[(place + 1) % shown.len()]);
            }
            Action::AllModes => self.session.rearrange(0, |scene| {
                scene.compare_all_modes();
                Ok(())
            }),
            Action::MovePane(from, to) => self
                .session
                .rearrange(to, |scene| scene.move_pane(from, to)),
            Action::RemovePane(pane) => {
                let active = self.session.panes.active;
                let active = active - usize::from(active >= pane && active > 0);
                self.session
                    .rearrange(active, |scene| scene.remove_pane(pane));
            }
            Action::Reference(pane) => self.session.edit(|scene, _| scene.set_reference(pane)),
            Action::AddLight(light) => self.add_light(light, size),
            Action::MoveProbe(by) => self.window.probe = self.window.probe.moved(by, size),
            Action::Orbit([right, up]) => orbit::orbit(camera, right, up),
            Action::Pan([right, up]) => orbit::pan(camera, right, up),
            Action::Zoom(factor) => orbit::zoom(camera, factor),
            Action::Show(switch) => {
                let shown = switch(&mut self.window.appearance);
                *shown = !*shown;
            }
            Action::ChangeAppearance(change) => change(&mut self.window.appearance),
            Action::Scan(walk) => self
                .window
                .own
                .change(|view: &mut ScanView| view.walk(walk)),
            Action::View(view) => self.window.show_view(view),
            Action::Course(turn) => self.turn(turn),
            Action::ShowAnswer => self.show_answer(),
            Action::SetTarget => self.set_as_target(),
            other => return Some(other),
        }
        None
    }

    /// Adds a light like `light` at a visible position away from the other lights.
    fn add_light(&mut self, light: Light, size: [u32; 2]) {
        let scene = &mut self.session.shown.scene;
        if scene.lights.len() >= Scene::MAX_LIGHTS {
            let text = text!("controls-most-lights", most = Scene::MAX_LIGHTS);
            self.session.notice = Some(text.into());
            return;
        }
        let light = handles::apart(light, scene, size);
        scene.lights.push(light);
        self.session.light = scene.lights.len() - 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::{Language, has, in_language};

    #[test]
    fn every_command_is_called_something_in_every_language() {
        for (language, section) in Language::ALL
            .into_iter()
            .flat_map(|language| SECTIONS.iter().map(move |section| (language, section)))
        {
            let named = |key: &str| in_language(language, || assert!(has(key), "{key}"));
            named(&format!("controls-group-{}", section.key));
            for command in section
                .commands
                .iter()
                .filter(|command| !command.key.is_empty())
            {
                let key = format!("controls-command-{}", command.key);
                if command.in_menu {
                    named(&key);
                }
                if command.does().is_some() {
                    named(&format!("{key}.does"));
                }
                if command.actions.is_empty() && command.keys.is_empty() {
                    named(&format!("{key}.gesture"));
                }
            }
        }
        assert!(
            MENUS
                .iter()
                .all(|menu| SECTIONS.iter().any(|section| section.key == *menu))
        );
    }

    #[test]
    fn every_action_has_a_key_and_no_key_is_given_twice() {
        let mut seen: Vec<(Modifiers, Key)> = Vec::new();
        for command in SECTIONS
            .iter()
            .flat_map(|section| &section.commands)
            .filter(|command| !command.keys.is_empty())
        {
            assert_eq!(
                command.bindings().count(),
                command.actions.len(),
                "{}",
                command.keys
            );
            for (modifiers, key, _) in command.bindings() {
                assert!(!seen.contains(&(modifiers, key)), "{modifiers:?} {key:?}");
                seen.push((modifiers, key));
            }
        }
        assert!(matches!(
            find(Key::Equals, Modifiers::SHIFT),
            Some(Action::Zoom(NEARER))
        ));
    }

    #[test]
    fn what_has_the_focus_keeps_its_keys() {
        let plain = |key, free, editing| allowed(key, Modifiers::NONE, free, editing);
        assert!(plain(Key::Num3, true, false) && plain(Key::F11, false, true));
        for (key, editing) in [
            (Key::V, true),
            (Key::ArrowLeft, false),
            (Key::Num3, false),
            (Key::Num3, true),
        ] {
            assert!(!plain(key, false, editing), "{key:?}");
        }
        assert!(!allowed(Key::Z, Modifiers::COMMAND, false, true));
    }
}
