//! What the window can be asked for: one table that the keys, the menus and Help read.

use super::action::{Action, Shown, Walk};
use super::look::NumbersTab;
use crate::analysis::ScanLevel;
use crate::scene::ShadingMode;
use eframe::egui::{Key, Modifiers};
use std::sync::LazyLock;

/// A command, or several that belong together.
pub struct Command {
    /// Heading in Help; "File", "Edit", "View", "Compare" and "Help" are menus as well.
    pub section: &'static str,
    /// As it is called in its menu; empty where it stands in none.
    pub name: &'static str,
    /// As shown in Help and in the menus; empty for none.
    pub keys: &'static str,
    /// As explained in Help; empty where it does not stand there.
    pub does: &'static str,
    /// The keys themselves and what each asks for. A menu asks for the first.
    pub on: Vec<(Modifiers, Key, Action)>,
    /// What the menu asks for where there is no key.
    pub action: Option<Action>,
}

const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::COMMAND };
const PLAIN: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;

/// Degrees that a press of a key turns the camera.
const TURN: f64 = 5.0;
/// Heights of the picture that a press of a key shifts the camera.
const SHIFTED: f64 = 0.05;
/// What a press of a key multiplies the distance by.
const NEARER: f64 = 0.9;
/// Pixels that an arrow key moves the probe with the shift key held.
const STRIDE: i32 = 10;

fn shade(mode: ShadingMode, renormalise: bool) -> Action {
    Action::Shade { mode, renormalise }
}

impl Command {
    /// What a menu asks for, if anything.
    pub fn asks_for(&self) -> Option<&Action> {
        self.on.first().map(|(.., action)| action).or(self.action.as_ref())
    }

    /// Whether it is a line between the items of a menu.
    pub fn is_line(&self) -> bool {
        self.keys.is_empty() && self.action.is_none()
    }
}

/// A key, which stands in Help alone.
fn key<const N: usize>(
    section: &'static str,
    keys: &'static str,
    does: &'static str,
    on: [(Modifiers, Key, Action); N],
) -> Command {
    Command { section, name: "", keys, does, on: on.into(), action: None }
}

/// What a menu calls the command.
fn named(name: &'static str, command: Command) -> Command {
    Command { name, ..command }
}

/// An item of a menu without a key.
fn item(section: &'static str, name: &'static str, action: Action) -> Command {
    Command { section, name, keys: "", does: "", on: vec![], action: Some(action) }
}

/// A line between the items of a menu.
fn line(section: &'static str) -> Command {
    Command { section, name: "", keys: "", does: "", on: vec![], action: None }
}

fn show(shown: Shown) -> Action {
    Action::Show(shown)
}

fn back(level: ScanLevel) -> Action {
    Action::Scan(Walk::Back(level))
}

fn forward(level: ScanLevel) -> Action {
    Action::Scan(Walk::Forward(level))
}

const SCAN: &str = "Scan line, while its tab is shown";

/// Every command. Sections that are menus stand here in the order of their items.
pub static COMMANDS: LazyLock<Vec<Command>> = LazyLock::new(|| {
    vec![
        key(
            "Shading",
            "1 – 5",
            "flat, interpolated, Gouraud, Phong, exact",
            [
                (PLAIN, Key::Num1, shade(ShadingMode::Flat, true)),
                (PLAIN, Key::Num2, shade(ShadingMode::Interpolated, true)),
                (PLAIN, Key::Num3, shade(ShadingMode::Gouraud, true)),
                (PLAIN, Key::Num4, shade(ShadingMode::Phong, true)),
                (PLAIN, Key::Num5, shade(ShadingMode::Exact, true)),
            ],
        ),
        key("Shading", "6", "Phong, not renormalised", [(PLAIN, Key::Num6, shade(ShadingMode::Phong, false))]),
        named(
            "Next view",
            key("Compare", "K", "one picture, panes, wipe, difference, in turn", [(PLAIN, Key::K, Action::NextView)]),
        ),
        named(
            "Next pane",
            key("Compare", "N", "the next pane: its settings are in the controls", [(PLAIN, Key::N, Action::NextPane)]),
        ),
        line("Compare"),
        item("Compare", "Panes and figures…", Action::Tab(NumbersTab::Compare)),
        item("Compare", "The five defects…", Action::Tab(NumbersTab::Defects)),
        key(
            "Probe",
            "← → ↑ ↓",
            "moves the probe by a pixel",
            [
                (PLAIN, Key::ArrowLeft, Action::MoveProbe([-1, 0])),
                (PLAIN, Key::ArrowRight, Action::MoveProbe([1, 0])),
                (PLAIN, Key::ArrowUp, Action::MoveProbe([0, -1])),
                (PLAIN, Key::ArrowDown, Action::MoveProbe([0, 1])),
            ],
        ),
        key(
            "Probe",
            "Shift + ← → ↑ ↓",
            "moves the probe by ten pixels",
            [
                (SHIFT, Key::ArrowLeft, Action::MoveProbe([-STRIDE, 0])),
                (SHIFT, Key::ArrowRight, Action::MoveProbe([STRIDE, 0])),
                (SHIFT, Key::ArrowUp, Action::MoveProbe([0, -STRIDE])),
                (SHIFT, Key::ArrowDown, Action::MoveProbe([0, STRIDE])),
            ],
        ),
        key("Probe", "Double click", "puts the probe there", []),
        key(
            "Camera",
            "A D W S",
            "turns the camera left, right, up, down",
            [
                (PLAIN, Key::A, Action::Orbit([-TURN, 0.0])),
                (PLAIN, Key::D, Action::Orbit([TURN, 0.0])),
                (PLAIN, Key::W, Action::Orbit([0.0, TURN])),
                (PLAIN, Key::S, Action::Orbit([0.0, -TURN])),
            ],
        ),
        key(
            "Camera",
            "Shift + A D W S",
            "shifts the camera left, right, up, down",
            [
                (SHIFT, Key::A, Action::Pan([-SHIFTED, 0.0])),
                (SHIFT, Key::D, Action::Pan([SHIFTED, 0.0])),
                (SHIFT, Key::W, Action::Pan([0.0, SHIFTED])),
                (SHIFT, Key::S, Action::Pan([0.0, -SHIFTED])),
            ],
        ),
        key(
            "Camera",
            "+ −",
            "nearer, farther",
            [
                (PLAIN, Key::Plus, Action::Zoom(NEARER)),
                (PLAIN, Key::Equals, Action::Zoom(NEARER)),
                (PLAIN, Key::Minus, Action::Zoom(1.0 / NEARER)),
            ],
        ),
        key(
            "Camera",
            "Drag",
            "turns the camera; a light, its arrow, its cone, a vertex or the probe follows the pointer",
            [],
        ),
        key("Camera", "Shift or middle drag", "shifts the camera; a light or a vertex moves in depth", []),
        key("Camera", "Wheel", "nearer, farther; over a light, moves it in depth", []),
        named("Controls", key("View", "F4", "the panel of controls", [(PLAIN, Key::F4, show(Shown::Controls))])),
        named("Numbers", key("View", "F5", "the panel of numbers", [(PLAIN, Key::F5, show(Shown::Numbers))])),
        named("Stages", key("View", "F6", "the bar of stages", [(PLAIN, Key::F6, show(Shown::Stages))])),
        named("Vectors", key("View", "V", "the vectors at the probe", [(PLAIN, Key::V, show(Shown::Vectors))])),
        item("View", "Angles", show(Shown::Angles)),
        item("View", "Construction of R", show(Shown::Construction)),
        item("View", "Side view", show(Shown::SideView)),
        named(
            "Lobe of reflection",
            key("View", "B", "the lobe of reflection at the probe", [(PLAIN, Key::B, show(Shown::Lobe))]),
        ),
        item("View", "H always", show(Shown::HalfVector)),
        named(
            "Lights' handles",
            key("View", "L", "the handles of lights and vertices", [(PLAIN, Key::L, show(Shown::Handles))]),
        ),
        item("View", "Face normals", show(Shown::FaceNormals)),
        item("View", "Vertex normals", show(Shown::VertexNormals)),
        key(
            "View",
            "M",
            "the normals of polygons and vertices; a click keeps a vertex's faces lit",
            [(PLAIN, Key::M, Action::Normals)],
        ),
        item("View", "RGB values", show(Shown::Channels)),
        named(
            "Next tab of the numbers",
            key("View", "C", "the next tab of the panel of numbers", [(PLAIN, Key::C, Action::SwitchTab)]),
        ),
        line("View"),
        named(
            "Picture alone",
            key(
                "View",
                "F11",
                "the picture alone, on the whole screen",
                [(PLAIN, Key::F11, show(Shown::PictureAlone))],
            ),
        ),
        named("Projector size", key("View", "F9", "projector size and back", [(PLAIN, Key::F9, Action::Projector)])),
        item("View", "Larger", Action::Larger),
        item("View", "Smaller", Action::Smaller),
        key(
            "View",
            "Ctrl + + − 0",
            "larger, smaller, ordinary size",
            [
                (CTRL, Key::Plus, Action::Larger),
                (CTRL, Key::Equals, Action::Larger),
                (CTRL, Key::Minus, Action::Smaller),
                (CTRL, Key::Num0, Action::OrdinarySize),
            ],
        ),
        key(
            SCAN,
            ", .",
            "a pixel back, a pixel forwards",
            [(PLAIN, Key::Comma, back(ScanLevel::Pixel)), (PLAIN, Key::Period, forward(ScanLevel::Pixel))],
        ),
        key(
            SCAN,
            "[ ]",
            "an edge back, an edge forwards",
            [(PLAIN, Key::OpenBracket, back(ScanLevel::Edge)), (PLAIN, Key::CloseBracket, forward(ScanLevel::Edge))],
        ),
        key(
            SCAN,
            "Page up, Page down",
            "a line back, a line forwards",
            [(PLAIN, Key::PageUp, back(ScanLevel::Line)), (PLAIN, Key::PageDown, forward(ScanLevel::Line))],
        ),
        key(
            SCAN,
            "Home, End",
            "the first step, the last",
            [(PLAIN, Key::Home, Action::Scan(Walk::First)), (PLAIN, Key::End, Action::Scan(Walk::Last))],
        ),
        key(SCAN, "Space", "plays and pauses", [(PLAIN, Key::Space, Action::Scan(Walk::Play))]),
        named("Open…", key("File", "Ctrl + O", "opens a scene, model or picture", [(CTRL, Key::O, Action::Open)])),
        line("File"),
        named("Save scene", key("File", "Ctrl + S", "saves the scene", [(CTRL, Key::S, Action::Save)])),
        named(
            "Save scene as…",
            key(
                "File",
                "Ctrl + Shift + S",
                "saves the scene under another name",
                [(CTRL_SHIFT, Key::S, Action::SaveAs)],
            ),
        ),
        named("Export picture…", key("File", "Ctrl + E", "exports the picture", [(CTRL, Key::E, Action::Export)])),
        line("File"),
        named("Quit", key("File", "Ctrl + Q", "closes the window", [(CTRL, Key::Q, Action::Quit)])),
        named("Undo", key("Edit", "Ctrl + Z", "undoes", [(CTRL, Key::Z, Action::Undo)])),
        named(
            "Redo",
            key(
                "Edit",
                "Ctrl + Shift + Z",
                "redoes; also Ctrl + Y",
                [(CTRL_SHIFT, Key::Z, Action::Redo), (CTRL, Key::Y, Action::Redo)],
            ),
        ),
        line("Edit"),
        named("Copy picture", key("Edit", "Ctrl + C", "copies the picture", [(CTRL, Key::C, Action::CopyPicture)])),
        named(
            "Code…",
            key("Edit", "Ctrl + U", "shows the scene as OpenGL calls and shaders", [(CTRL, Key::U, Action::Code)]),
        ),
        named("Reset camera", key("Edit", "0", "resets the camera", [(PLAIN, Key::Num0, Action::ResetCamera)])),
        key("Edit", "Tab", "goes to the next field, with Shift to the one before", []),
        named("Keys and gestures", key("Help", "F1", "this table", [(PLAIN, Key::F1, Action::Keys)])),
        item("Help", "About", Action::About),
        key("Help", "Esc", "leaves a dialog, a field or the picture alone", []),
    ]
});
