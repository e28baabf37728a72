//! The keyboard: turns the keys of a frame into actions.

use super::action::{Action, Shown};
use super::commands::COMMANDS;
use super::focus;
use super::look::NumbersTab;
use super::state::AppState;
use eframe::egui::{Context, Event, Key, Modifiers};

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
    // Plus is a shifted key on many keyboards.
    let shiftless = matches!(key, Key::Plus | Key::Equals | Key::Minus);
    let modifiers = if shiftless { Modifiers { shift: false, ..modifiers } } else { modifiers };
    let mut all = COMMANDS.iter().flat_map(|command| &command.on);
    let (.., action) = all.find(|(wanted, k, _)| *k == key && modifiers.matches_exact(*wanted))?;
    Some(action.clone())
}

fn allowed(key: Key, modifiers: Modifiers, free: bool, editing: bool) -> bool {
    let function = matches!(key, Key::F1 | Key::F4 | Key::F5 | Key::F6 | Key::F9 | Key::F11);
    let field_wants = editing && matches!(key, Key::Z | Key::Y | Key::C | Key::U);
    function || (modifiers.command && !field_wants) || free
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: Modifiers = Modifiers::NONE;

    #[test]
    fn no_key_is_given_twice() {
        let mut seen: Vec<(Modifiers, Key)> = Vec::new();
        for (modifiers, key, _) in COMMANDS.iter().flat_map(|command| &command.on) {
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
        assert!(!allowed(Key::Z, Modifiers::COMMAND, false, true));
    }
}
