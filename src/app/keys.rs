//! The keys, in one table: what the window does on them is what Help shows.

use super::action::{Action, Shown, Walk};
use super::focus;
use super::look::NumbersTab;
use super::state::AppState;
use crate::analysis::ScanLevel;
use crate::scene::ShadingMode;
use eframe::egui::{Context, Event, Key, Modifiers};

/// One line of the table of keys.
pub struct Binding {
    pub section: &'static str,
    /// As shown in Help and in the menus.
    pub keys: &'static str,
    pub does: &'static str,
    /// The keys themselves and what each asks for.
    pub on: &'static [(Modifiers, Key, Action)],
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

const fn shade(mode: ShadingMode, renormalise: bool) -> Action {
    Action::Shade { mode, renormalise }
}

/// Every key of the window.
pub const BINDINGS: &[Binding] = &[
    Binding {
        section: "Shading",
        keys: "1 – 5",
        does: "flat, interpolated, Gouraud, Phong, exact",
        on: &[
            (PLAIN, Key::Num1, shade(ShadingMode::Flat, true)),
            (PLAIN, Key::Num2, shade(ShadingMode::Interpolated, true)),
            (PLAIN, Key::Num3, shade(ShadingMode::Gouraud, true)),
            (PLAIN, Key::Num4, shade(ShadingMode::Phong, true)),
            (PLAIN, Key::Num5, shade(ShadingMode::Exact, true)),
        ],
    },
    Binding {
        section: "Shading",
        keys: "6",
        does: "Phong that forgets to make normals unit vectors again",
        on: &[(PLAIN, Key::Num6, shade(ShadingMode::Phong, false))],
    },
    Binding {
        section: "Comparison",
        keys: "K",
        does: "one picture, panes, wipe, difference, in turn",
        on: &[(PLAIN, Key::K, Action::NextView)],
    },
    Binding {
        section: "Comparison",
        keys: "N",
        does: "the next pane: its settings are in the controls",
        on: &[(PLAIN, Key::N, Action::NextPane)],
    },
    Binding {
        section: "Probe",
        keys: "← → ↑ ↓",
        does: "moves the probe by a pixel",
        on: &[
            (PLAIN, Key::ArrowLeft, Action::MoveProbe([-1, 0])),
            (PLAIN, Key::ArrowRight, Action::MoveProbe([1, 0])),
            (PLAIN, Key::ArrowUp, Action::MoveProbe([0, -1])),
            (PLAIN, Key::ArrowDown, Action::MoveProbe([0, 1])),
        ],
    },
    Binding {
        section: "Probe",
        keys: "Shift + ← → ↑ ↓",
        does: "moves the probe by ten pixels",
        on: &[
            (SHIFT, Key::ArrowLeft, Action::MoveProbe([-STRIDE, 0])),
            (SHIFT, Key::ArrowRight, Action::MoveProbe([STRIDE, 0])),
            (SHIFT, Key::ArrowUp, Action::MoveProbe([0, -STRIDE])),
            (SHIFT, Key::ArrowDown, Action::MoveProbe([0, STRIDE])),
        ],
    },
    Binding { section: "Probe", keys: "Double click", does: "puts the probe there", on: &[] },
    Binding {
        section: "Camera",
        keys: "A D W S",
        does: "turns the camera left, right, up, down",
        on: &[
            (PLAIN, Key::A, Action::Orbit([-TURN, 0.0])),
            (PLAIN, Key::D, Action::Orbit([TURN, 0.0])),
            (PLAIN, Key::W, Action::Orbit([0.0, TURN])),
            (PLAIN, Key::S, Action::Orbit([0.0, -TURN])),
        ],
    },
    Binding {
        section: "Camera",
        keys: "Shift + A D W S",
        does: "shifts the camera left, right, up, down",
        on: &[
            (SHIFT, Key::A, Action::Pan([-SHIFTED, 0.0])),
            (SHIFT, Key::D, Action::Pan([SHIFTED, 0.0])),
            (SHIFT, Key::W, Action::Pan([0.0, SHIFTED])),
            (SHIFT, Key::S, Action::Pan([0.0, -SHIFTED])),
        ],
    },
    Binding {
        section: "Camera",
        keys: "+ −",
        does: "nearer, farther",
        on: &[
            (PLAIN, Key::Plus, Action::Zoom(NEARER)),
            (PLAIN, Key::Equals, Action::Zoom(NEARER)),
            (PLAIN, Key::Minus, Action::Zoom(1.0 / NEARER)),
        ],
    },
    Binding { section: "Camera", keys: "0", does: "resets the camera", on: &[(PLAIN, Key::Num0, Action::ResetCamera)] },
    Binding {
        section: "Camera",
        keys: "Drag",
        does: "turns the camera; a light, its arrow, its cone, a vertex or the probe follows the pointer",
        on: &[],
    },
    Binding {
        section: "Camera",
        keys: "Shift or middle drag",
        does: "shifts the camera; a light or a vertex moves in depth",
        on: &[],
    },
    Binding { section: "Camera", keys: "Wheel", does: "nearer, farther; over a light, moves it in depth", on: &[] },
    Binding {
        section: "Shown",
        keys: "V",
        does: "the vectors at the probe",
        on: &[(PLAIN, Key::V, Action::Show(Shown::Vectors))],
    },
    Binding {
        section: "Shown",
        keys: "L",
        does: "the handles of lights and vertices",
        on: &[(PLAIN, Key::L, Action::Show(Shown::Handles))],
    },
    Binding {
        section: "Shown",
        keys: "B",
        does: "the lobe of reflection at the probe",
        on: &[(PLAIN, Key::B, Action::Show(Shown::Lobe))],
    },
    Binding {
        section: "Shown",
        keys: "M",
        does: "the normals of polygons and vertices; a click keeps a vertex' faces lit",
        on: &[(PLAIN, Key::M, Action::Normals)],
    },
    Binding {
        section: "Shown",
        keys: "C",
        does: "the equation in numbers, its curves, a profile, or the scan line",
        on: &[(PLAIN, Key::C, Action::SwitchTab)],
    },
    Binding {
        section: "Shown",
        keys: "F4",
        does: "the panel of controls",
        on: &[(PLAIN, Key::F4, Action::Show(Shown::Controls))],
    },
    Binding {
        section: "Shown",
        keys: "F5",
        does: "the panel of numbers",
        on: &[(PLAIN, Key::F5, Action::Show(Shown::Numbers))],
    },
    Binding {
        section: "Shown",
        keys: "F6",
        does: "the bar of stages",
        on: &[(PLAIN, Key::F6, Action::Show(Shown::Stages))],
    },
    Binding {
        section: "Shown",
        keys: "F11",
        does: "the picture alone, on the whole screen",
        on: &[(PLAIN, Key::F11, Action::Show(Shown::PictureAlone))],
    },
    Binding {
        section: "Shown",
        keys: "F9",
        does: "projector size and back",
        on: &[(PLAIN, Key::F9, Action::Projector)],
    },
    Binding {
        section: "Shown",
        keys: "Ctrl + + − 0",
        does: "larger, smaller, ordinary size",
        on: &[
            (CTRL, Key::Plus, Action::Larger),
            (CTRL, Key::Equals, Action::Larger),
            (CTRL, Key::Minus, Action::Smaller),
            (CTRL, Key::Num0, Action::OrdinarySize),
        ],
    },
    Binding {
        section: "Scan line, while its tab is shown",
        keys: ", .",
        does: "a pixel back, a pixel forwards",
        on: &[
            (PLAIN, Key::Comma, Action::Scan(Walk::Back(ScanLevel::Pixel))),
            (PLAIN, Key::Period, Action::Scan(Walk::Forward(ScanLevel::Pixel))),
        ],
    },
    Binding {
        section: "Scan line, while its tab is shown",
        keys: "[ ]",
        does: "an edge back, an edge forwards",
        on: &[
            (PLAIN, Key::OpenBracket, Action::Scan(Walk::Back(ScanLevel::Edge))),
            (PLAIN, Key::CloseBracket, Action::Scan(Walk::Forward(ScanLevel::Edge))),
        ],
    },
    Binding {
        section: "Scan line, while its tab is shown",
        keys: "Page up, Page down",
        does: "a line back, a line forwards",
        on: &[
            (PLAIN, Key::PageUp, Action::Scan(Walk::Back(ScanLevel::Line))),
            (PLAIN, Key::PageDown, Action::Scan(Walk::Forward(ScanLevel::Line))),
        ],
    },
    Binding {
        section: "Scan line, while its tab is shown",
        keys: "Home, End",
        does: "the first step, the last",
        on: &[(PLAIN, Key::Home, Action::Scan(Walk::First)), (PLAIN, Key::End, Action::Scan(Walk::Last))],
    },
    Binding {
        section: "Scan line, while its tab is shown",
        keys: "Space",
        does: "plays and pauses",
        on: &[(PLAIN, Key::Space, Action::Scan(Walk::Play))],
    },
    Binding {
        section: "File",
        keys: "Ctrl + O",
        does: "opens a scene, model or picture",
        on: &[(CTRL, Key::O, Action::Open)],
    },
    Binding { section: "File", keys: "Ctrl + S", does: "saves the scene", on: &[(CTRL, Key::S, Action::Save)] },
    Binding {
        section: "File",
        keys: "Ctrl + Shift + S",
        does: "saves the scene under another name",
        on: &[(CTRL_SHIFT, Key::S, Action::SaveAs)],
    },
    Binding { section: "File", keys: "Ctrl + E", does: "exports the picture", on: &[(CTRL, Key::E, Action::Export)] },
    Binding { section: "File", keys: "Ctrl + Q", does: "closes the window", on: &[(CTRL, Key::Q, Action::Quit)] },
    Binding { section: "Edit", keys: "Ctrl + Z", does: "undoes", on: &[(CTRL, Key::Z, Action::Undo)] },
    Binding {
        section: "Edit",
        keys: "Ctrl + Shift + Z",
        does: "redoes; also Ctrl + Y",
        on: &[(CTRL_SHIFT, Key::Z, Action::Redo), (CTRL, Key::Y, Action::Redo)],
    },
    Binding {
        section: "Edit",
        keys: "Ctrl + C",
        does: "copies the picture",
        on: &[(CTRL, Key::C, Action::CopyPicture)],
    },
    Binding {
        section: "Edit",
        keys: "Ctrl + U",
        does: "shows the scene as OpenGL calls and shaders",
        on: &[(CTRL, Key::U, Action::Code)],
    },
    Binding { section: "Help", keys: "F1", does: "this table", on: &[(PLAIN, Key::F1, Action::Keys)] },
    Binding { section: "Edit", keys: "Tab", does: "goes to the next field, with Shift to the one before", on: &[] },
    Binding { section: "Help", keys: "Esc", does: "leaves a dialog, a field or the picture alone", on: &[] },
];

/// The keys that the table gives for `action`, for menus.
pub fn of(action: &Action) -> &'static str {
    let single = BINDINGS.iter().find(|binding| binding.on.first().is_some_and(|(_, _, asked)| asked == action));
    single.map_or("", |binding| binding.keys)
}

/// Turns the keys pressed in this frame into actions. What has the focus keeps its keys, digits as well, unless it is the
/// picture: they may be meant for a field. Function keys and those with Ctrl are always the window's, but for those that
/// fields know too.
pub fn listen(ctx: &Context, state: &mut AppState) {
    let free = ctx.memory(|memory| memory.focused().is_none_or(|focused| focused == focus::picture_id()));
    let editing = ctx.text_edit_focused();
    let scanning = state.shows(NumbersTab::ScanLine);
    let mut asked = Vec::new();
    ctx.input_mut(|input| {
        input.events.retain(|event| {
            let action = match event {
                // The window's back end turns Ctrl + C into this.
                Event::Copy if !editing => Some(Action::CopyPicture),
                Event::Key { key, pressed: true, modifiers, .. } => {
                    let wanted = find(*key, *modifiers).filter(|_| allowed(*key, *modifiers, free, editing));
                    wanted.filter(|action| scanning || !matches!(action, Action::Scan(_)))
                }
                _ => None,
            };
            asked.extend(action.clone());
            action.is_none()
        });
    });
    if ctx.input(|input| input.key_pressed(Key::Escape)) && state.picture_alone {
        asked.push(Action::Show(Shown::PictureAlone));
    }
    state.asked.extend(asked);
}

fn find(key: Key, modifiers: Modifiers) -> Option<Action> {
    let entries = BINDINGS.iter().flat_map(|binding| binding.on);
    // Plus is a shifted key on many keyboards.
    let plain = if matches!(key, Key::Plus | Key::Equals | Key::Minus) {
        Modifiers { shift: false, ..modifiers }
    } else {
        modifiers
    };
    entries
        .clone()
        .find(|(wanted, k, _)| *k == key && plain.matches_exact(*wanted))
        .map(|(_, _, action)| action.clone())
}

fn allowed(key: Key, modifiers: Modifiers, free: bool, editing: bool) -> bool {
    let function = matches!(key, Key::F1 | Key::F4 | Key::F5 | Key::F6 | Key::F9 | Key::F11);
    let field_wants = editing && matches!(key, Key::Z | Key::Y | Key::C | Key::U);
    function || (modifiers.command && !field_wants) || free
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_is_given_twice() {
        let mut seen: Vec<(Modifiers, Key)> = Vec::new();
        for (modifiers, key, _) in BINDINGS.iter().flat_map(|binding| binding.on) {
            assert!(!seen.contains(&(*modifiers, *key)), "{modifiers:?} {key:?}");
            seen.push((*modifiers, *key));
        }
    }

    #[test]
    fn what_has_the_focus_keeps_its_keys() {
        assert!(allowed(Key::Num3, PLAIN, true, false));
        for (key, editing) in [(Key::V, true), (Key::ArrowLeft, false), (Key::Num3, false), (Key::Num3, true)] {
            assert!(!allowed(key, PLAIN, false, editing), "{key:?}");
        }
        assert!(allowed(Key::F11, PLAIN, false, true));
        assert!(!allowed(Key::Z, CTRL, false, true));
    }

    #[test]
    fn menus_find_their_keys() {
        assert_eq!(of(&Action::Undo), "Ctrl + Z");
        assert_eq!(of(&Action::About), "");
    }
}
