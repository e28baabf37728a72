//! The commands of the window: one table that the keys, the menus and Help read, and what each does to the state.

use super::action::{Action, Walk};
use super::focus;
use super::handles;
use super::look::{Look, NumbersTab};
use super::orbit;
use super::scan::ScanView;
use super::state::AppState;
use super::views::after;
use crate::analysis::ScanLevel;
use crate::scene::{Choice, Light, Scene, ShadingMode};
use eframe::egui::{Context, Event, Key, Modifiers};
use std::sync::LazyLock;

/// Commands that belong together. "File", "Edit", "View", "Compare" and "Help" are menus as well.
pub struct Section {
    pub title: &'static str,
    pub commands: Vec<Command>,
}

/// A command, or several that are alike. One without a name or keys is a line between the items of a menu.
pub struct Command {
    /// As it is called in its menu; empty where it stands in none.
    pub name: &'static str,
    /// As shown in Help and in the menus: what is held, then each key, separated by spaces.
    pub keys: &'static str,
    /// As explained in Help; empty where it does not stand there.
    pub does: &'static str,
    /// What each key asks for; none for gestures. A menu asks for the first.
    pub actions: Vec<Action>,
}

impl Command {
    /// The keys, with what each asks for.
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

/// Whether a key is held, and what follows.
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
    fn new(title: &'static str) -> Self {
        Self {
            title,
            commands: vec![],
        }
    }

    /// A command with keys, named where it stands in a menu.
    fn row(
        mut self,
        name: &'static str,
        keys: &'static str,
        does: &'static str,
        actions: impl IntoIterator<Item = Action>,
    ) -> Self {
        self.commands.push(Command {
            name,
            keys,
            does,
            actions: actions.into_iter().collect(),
        });
        self
    }

    /// An item of a menu without a key.
    fn item(self, name: &'static str, action: Action) -> Self {
        self.row(name, "", "", [action])
    }

    /// A line between the items of a menu.
    fn line(self) -> Self {
        self.row("", "", "", [])
    }
}

/// Degrees that a press of a key turns the camera.
const TURN: f64 = 5.0;
/// Heights of the picture that a press of a key shifts the camera.
const SHIFTED: f64 = 0.05;
/// What a press of a key multiplies the distance by.
const NEARER: f64 = 0.9;
/// Left, right, up and down, in pixels; ten of them with the shift key held.
const ARROWS: [[i32; 2]; 4] = [[-1, 0], [1, 0], [0, -1], [0, 1]];
/// Left, right, up and down of the camera.
const WAYS: [[f64; 2]; 4] = [[-1.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];

fn walk(level: ScanLevel) -> [Action; 2] {
    [Walk::Back(level), Walk::Forward(level)].map(Action::Scan)
}

/// Every command. Sections that are menus have them in the order of their items.
pub static SECTIONS: LazyLock<Vec<Section>> = LazyLock::new(|| {
    let shade = |mode, renormalise| Action::Shade { mode, renormalise };
    let modes = ShadingMode::VALUES.iter().map(|mode| shade(*mode, true));
    let stride = ARROWS.map(|way| Action::MoveProbe(way.map(|pixels| 10 * pixels)));
    let orbit = WAYS.map(|way| Action::Orbit(way.map(|part| TURN * part)));
    let pan = WAYS.map(|way| Action::Pan(way.map(|part| SHIFTED * part)));
    let (show, change) = (Action::Show, Action::ChangeLook);
    let sizes = [Look::larger, Look::smaller, |look: &mut Look| {
        look.scale = 1.0;
    }]
    .map(change);
    let follows =
        "turns the camera; a light, its arrow, its cone, a vertex or the probe follows the pointer";
    let normals = "the normals of polygons and vertices; a click keeps a vertex's faces lit";
    vec![
        Section::new("Shading")
            .row(
                "",
                "1 2 3 4 5",
                "flat, interpolated, Gouraud, Phong, exact",
                modes,
            )
            .row(
                "",
                "6",
                "Phong, not renormalised",
                [shade(ShadingMode::Phong, false)],
            ),
        Section::new("Compare")
            .row(
                "Next view",
                "K",
                "one picture, panes, wipe, difference, in turn",
                [Action::NextView],
            )
            .row(
                "Next pane",
                "N",
                "the next pane: its settings are in the controls",
                [Action::NextPane],
            )
            .line()
            .item("All shading modes", Action::AllModes)
            .item("Panes and figures…", Action::Tab(NumbersTab::Compare))
            .item("The five defects…", Action::Tab(NumbersTab::Defects)),
        Section::new("Probe")
            .row(
                "",
                "← → ↑ ↓",
                "moves the probe by a pixel",
                ARROWS.map(Action::MoveProbe),
            )
            .row(
                "",
                "Shift + ← → ↑ ↓",
                "moves the probe by ten pixels",
                stride,
            )
            .row("", "Double click", "puts the probe there", []),
        Section::new("Camera")
            .row(
                "",
                "A D W S",
                "turns the camera left, right, up, down",
                orbit,
            )
            .row(
                "",
                "Shift + A D W S",
                "shifts the camera left, right, up, down",
                pan,
            )
            .row(
                "",
                "+ −",
                "nearer, farther",
                [NEARER, 1.0 / NEARER].map(Action::Zoom),
            )
            .row("", "Drag", follows, [])
            .row(
                "",
                "Shift or middle drag",
                "shifts the camera; a light or a vertex moves in depth",
                [],
            )
            .row(
                "",
                "Wheel",
                "nearer, farther; over a light, moves it in depth",
                [],
            ),
        Section::new("View")
            .row(
                "Controls",
                "F4",
                "the panel of controls",
                [show(|look| &mut look.controls)],
            )
            .row(
                "Numbers",
                "F5",
                "the panel of numbers",
                [show(|look| &mut look.numbers)],
            )
            .row(
                "Stages",
                "F6",
                "the bar of stages",
                [show(|look| &mut look.stages)],
            )
            .row(
                "Vectors",
                "V",
                "the vectors at the probe",
                [show(|look| &mut look.overlay.vectors)],
            )
            .item("Angles", show(|look| &mut look.overlay.angles))
            .item(
                "Construction of R",
                show(|look| &mut look.overlay.construction),
            )
            .item("Side view", show(|look| &mut look.overlay.side_view))
            .row(
                "Lobe of reflection",
                "B",
                "the lobe of reflection at the probe",
                [show(|look| &mut look.overlay.lobe)],
            )
            .item("H always", show(|look| &mut look.overlay.half_vector))
            .row(
                "Lights' handles",
                "L",
                "the handles of lights and vertices",
                [show(|look| &mut look.overlay.handles)],
            )
            .item("Face normals", show(|look| &mut look.overlay.face_normals))
            .item(
                "Vertex normals",
                show(|look| &mut look.overlay.vertex_normals),
            )
            .row("", "M", normals, [change(Look::switch_normals)])
            .item("RGB values", show(|look| &mut look.channels))
            .item("Smooth edges", show(|look| &mut look.smooth_edges))
            .row(
                "Next tab of the numbers",
                "C",
                "the next tab of the panel of numbers",
                [change(next_tab)],
            )
            .line()
            .row(
                "Picture alone",
                "F11",
                "the picture alone, on the whole screen",
                [Action::PictureAlone],
            )
            .row(
                "Projector size",
                "F9",
                "projector size and back",
                [change(Look::projector)],
            )
            .item("Larger", change(Look::larger))
            .item("Smaller", change(Look::smaller))
            .row("", "Ctrl + + − 0", "larger, smaller, ordinary size", sizes),
        Section::new("Scan line, while its tab is shown")
            .row(
                "",
                ", .",
                "a pixel back, a pixel forwards",
                walk(ScanLevel::Pixel),
            )
            .row(
                "",
                "[ ]",
                "an edge back, an edge forwards",
                walk(ScanLevel::Edge),
            )
            .row(
                "",
                "PageUp PageDown",
                "a line back, a line forwards",
                walk(ScanLevel::Line),
            )
            .row(
                "",
                "Home End",
                "the first step, the last",
                [Walk::First, Walk::Last].map(Action::Scan),
            )
            .row("", "Space", "plays and pauses", [Action::Scan(Walk::Play)]),
        Section::new("File")
            .row(
                "Open…",
                "Ctrl + O",
                "opens a scene, model or picture",
                [Action::Open],
            )
            .row(
                "Scenes…",
                "F2",
                "opens the gallery of scenes",
                [Action::Scenes],
            )
            .line()
            .row("Save scene", "Ctrl + S", "saves the scene", [Action::Save])
            .row(
                "Save scene as…",
                "Ctrl + Shift + S",
                "saves the scene under another name",
                [Action::SaveAs],
            )
            .row(
                "Export picture…",
                "Ctrl + E",
                "exports the picture",
                [Action::Export],
            )
            .line()
            .row("Quit", "Ctrl + Q", "closes the window", [Action::Quit]),
        Section::new("Edit")
            .row("Undo", "Ctrl + Z", "undoes", [Action::Undo])
            .row(
                "Redo",
                "Ctrl + Shift + Z",
                "redoes; also Ctrl + Y",
                [Action::Redo],
            )
            .row("", "Ctrl + Y", "", [Action::Redo])
            .line()
            .row(
                "Copy picture",
                "Ctrl + C",
                "copies the picture",
                [Action::CopyPicture],
            )
            .row(
                "Code…",
                "Ctrl + U",
                "shows the scene as OpenGL calls and shaders",
                [Action::Code],
            )
            .row(
                "Reset camera",
                "0",
                "resets the camera",
                [Action::ResetCamera],
            )
            .row(
                "",
                "Tab",
                "goes to the next field, with Shift to the one before",
                [],
            ),
        Section::new("Help")
            .row("Keys and gestures", "F1", "this table", [Action::Keys])
            .item("About", Action::About)
            .row(
                "",
                "Esc",
                "leaves a dialog, a field or the picture alone",
                [],
            ),
    ]
});

/// The next tab of the numbers; the curves where the panel is closed.
fn next_tab(look: &mut Look) {
    look.tab = if look.numbers {
        after(look.tab)
    } else {
        NumbersTab::Curves
    };
    look.numbers = true;
}

/// Turns the keys pressed in this frame into actions. What has the focus keeps its keys, digits as well, unless it is the
/// picture: they may be meant for a field. Function keys and those with Ctrl are always the window's, but for those that
/// fields know too.
pub fn listen(ctx: &Context, state: &mut AppState) {
    let free = ctx.memory(|memory| {
        memory
            .focused()
            .is_none_or(|focused| focused == focus::picture_id())
    });
    let editing = ctx.text_edit_focused();
    let scanning = state.shows(NumbersTab::ScanLine);
    ctx.input_mut(|input| {
        input.events.retain(|event| {
            let action = match event {
                // The window's back end turns Ctrl + C into this.
                Event::Copy if !editing => Some(Action::CopyPicture),
                Event::Key {
                    key,
                    pressed: true,
                    modifiers,
                    ..
                } => {
                    let wanted =
                        find(*key, *modifiers).filter(|_| allowed(*key, *modifiers, free, editing));
                    wanted.filter(|action| scanning || !matches!(action, Action::Scan(_)))
                }
                _ => None,
            };
            let taken = action.is_some();
            state.asked.extend(action);
            !taken
        });
    });
    if state.picture_alone && ctx.input(|input| input.key_pressed(Key::Escape)) {
        state.ask(Action::PictureAlone);
    }
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
        Key::F1 | Key::F2 | Key::F4 | Key::F5 | Key::F6 | Key::F9 | Key::F11
    );
    let field_wants = editing && matches!(key, Key::Z | Key::Y | Key::C | Key::U);
    function || (modifiers.command && !field_wants) || free
}

impl AppState {
    /// Does what concerns the state alone; returns what needs the window, files or the clipboard.
    ///
    /// `size` is the picture's, in pixels.
    pub fn perform(&mut self, action: Action, size: [u32; 2]) -> Option<Action> {
        let camera = &mut self.shown.scene.camera;
        match action {
            Action::Undo => {
                self.history.undo(&mut self.document);
                self.return_to_origin();
            }
            Action::Redo => {
                self.history.redo(&mut self.document);
                self.return_to_origin();
            }
            Action::ResetCamera => orbit::reset(&mut self.shown, &self.opened, size),
            Action::Shade { mode, renormalise } => {
                self.shown.scene.shading.mode = mode;
                self.shown.scene.shading.renormalise = renormalise;
            }
            Action::Compare(view) => self.compare(view),
            Action::NextView => self.compare(self.next_view()),
            Action::Activate(pane) => self.activate(pane),
            Action::NextPane => {
                let shown = self.document.scene.shown_panes();
                let place = shown
                    .iter()
                    .position(|pane| *pane == self.panes.active)
                    .unwrap_or(0);
                self.activate(shown[(place + 1) % shown.len()]);
            }
            Action::AllModes => self.rearrange(0, |scene| {
                scene.compare_all_modes();
                Ok(())
            }),
            Action::MovePane(from, to) => self.rearrange(to, |scene| scene.move_pane(from, to)),
            Action::RemovePane(pane) => {
                let active = self.panes.active;
                let active = active - usize::from(active >= pane && active > 0);
                self.rearrange(active, |scene| scene.remove_pane(pane));
            }
            Action::Reference(pane) => self.document.scene.set_reference(pane),
            Action::AddLight(light) => self.add_light(light, size),
            Action::MoveProbe(by) => self.probe = self.probe.moved(by, size),
            Action::Orbit([right, up]) => orbit::orbit(camera, right, up),
            Action::Pan([right, up]) => orbit::pan(camera, right, up),
            Action::Zoom(factor) => orbit::zoom(camera, factor),
            Action::Show(switch) => {
                let shown = switch(&mut self.look);
                *shown = !*shown;
            }
            Action::ChangeLook(change) => change(&mut self.look),
            Action::Scan(walk) => self.own.change(|view: &mut ScanView| view.walk(walk)),
            Action::Tab(tab) => self.show_tab(tab),
            other => return Some(other),
        }
        None
    }

    /// Adds a light like this one where it is seen and no other is.
    fn add_light(&mut self, light: Light, size: [u32; 2]) {
        let scene = &mut self.shown.scene;
        if scene.lights.len() >= Scene::MAX_LIGHTS {
            self.notice = Some(format!("a scene has at most {} lights", Scene::MAX_LIGHTS));
            return;
        }
        let light = handles::apart(light, scene, size);
        scene.lights.push(light);
        self.light = scene.lights.len() - 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
