//! The actions of a monkey: one step at a time, as the events that a desktop would send.

use super::dice::Dice;
use super::hands::named;
use eframe::egui::accesskit::{Action, ActionData, ActionRequest, Role};
use eframe::egui::{
    Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Rect, TouchPhase, Vec2, pos2, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT;
use shading_lab::app::App;

/// Roles of widgets that can be clicked, typed into or dragged.
const ROLES: [Role; 11] = [
    Role::Button,
    Role::CheckBox,
    Role::ComboBox,
    Role::DisclosureTriangle,
    Role::Image,
    Role::Link,
    Role::RadioButton,
    Role::Slider,
    Role::SpinButton,
    Role::Tab,
    Role::TextInput,
];
/// Texts to type into fields.
const TEXTS: [&str; 24] = [
    "1e300",
    "-1e300",
    "nan",
    "-0",
    "inf",
    "",
    "0",
    "1",
    "0.3",
    "-1",
    "1e-300",
    "1e30",
    "∞",
    "1,5",
    "7",
    "32",
    "1e8",
    "180",
    "360",
    "abc",
    "ça 漢字 🙂",
    "scene.toml",
    "picture.png",
    "  ",
];
/// Texts to type where a large number would be a large picture.
const SIZES: [&str; 5] = ["", "1", "17", "200", "-3"];
/// Numbers that a screen reader sets.
const NUMBERS: [f64; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    10.0,
    1e8,
    1e300,
    -1e300,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];
/// Keys that mean something to the window or to fields, in addition to random keys.
const KEYS: [Key; 40] = [
    Key::Tab,
    Key::Tab,
    Key::Tab,
    Key::Enter,
    Key::Enter,
    Key::Escape,
    Key::Escape,
    Key::Space,
    Key::Backspace,
    Key::Delete,
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::Home,
    Key::End,
    Key::PageUp,
    Key::PageDown,
    Key::C,
    Key::C,
    Key::C,
    Key::K,
    Key::K,
    Key::N,
    Key::M,
    Key::B,
    Key::V,
    Key::L,
    Key::Num1,
    Key::Num3,
    Key::Num5,
    Key::Plus,
    Key::Minus,
    Key::F1,
    Key::F4,
    Key::F5,
    Key::F9,
    Key::F11,
    Key::Z,
    Key::S,
];
/// Width and height of the window in points, and pixels per point: no picture is large enough to make every frame slow.
const WINDOWS: [[f32; 3]; 10] = [
    [800.0, 500.0, 1.0],
    [800.0, 500.0, 1.0],
    [1280.0, 800.0, 1.0],
    [720.0, 480.0, 1.5],
    [400.0, 300.0, 2.0],
    [400.0, 300.0, 0.5],
    [1500.0, 200.0, 1.0],
    [300.0, 900.0, 1.0],
    [60.0, 40.0, 1.0],
    [1.0, 1.0, 1.0],
];

/// A widget that can be clicked, typed into or dragged.
struct Widget {
    role: Role,
    label: String,
    rect: Rect,
    id: (
        eframe::egui::accesskit::NodeId,
        eframe::egui::accesskit::TreeId,
    ),
}

impl Widget {
    /// Returns a request of a screen reader.
    fn request(&self, action: Action, data: Option<ActionData>) -> Event {
        let (target_node, target_tree) = self.id;
        Event::AccessKitActionRequest(ActionRequest {
            action,
            target_node,
            target_tree,
            data,
        })
    }

    /// Returns whether the widget sets the size or the sampling of a picture.
    fn is_size(&self) -> bool {
        ["width", "height", "samples"]
            .iter()
            .any(|key| self.label == named(key))
    }
}

/// Returns the widgets that can be used at present.
fn widgets(harness: &Harness<'_, App>) -> Vec<Widget> {
    let usable = harness.root().children_recursive().filter_map(|node| {
        let it = node.accesskit_node();
        let usable = ROLES.contains(&it.role()) && !it.is_disabled() && it.bounding_box().is_some();
        let label = || it.label().unwrap_or_default();
        usable.then(|| Widget {
            role: it.role(),
            label: label(),
            rect: node.rect(),
            id: it.locate(),
        })
    });
    usable.collect()
}

/// Returns the next step: its description and its events.
pub fn act(harness: &mut Harness<'_, App>, dice: &mut Dice) -> (String, Vec<Event>) {
    let screen = harness.ctx.content_rect();
    let widgets = widgets(harness);
    let kind = dice.unit();
    // There is not much to do in a window of no size.
    if screen.width() < 100.0 && kind < 0.3 {
        return resize(harness, dice);
    }
    match kind {
        k if k < 0.30 => click(&widgets, screen, dice),
        k if k < 0.42 => type_into(&widgets, dice),
        k if k < 0.47 => set(&widgets, dice),
        k if k < 0.62 => drag(&widgets, screen, dice),
        k if k < 0.70 => wheel(screen, dice),
        k if k < 0.92 => key(dice),
        k if k < 0.95 => resize(harness, dice),
        k if k < 0.98 => other(dice),
        _ => {
            let at = anywhere(screen, dice);
            (
                format!("double click at {at:?}"),
                [press(at, dice), press(at, dice)].concat(),
            )
        }
    }
}

fn anywhere(screen: Rect, dice: &mut Dice) -> Pos2 {
    let part = |low: f32, high: f32, dice: &mut Dice| low + (high - low) * dice.unit() as f32;
    pos2(
        part(screen.min.x, screen.max.x, dice),
        part(screen.min.y, screen.max.y, dice),
    )
}

fn button(at: Pos2, button: PointerButton, pressed: bool, modifiers: Modifiers) -> Event {
    Event::PointerButton {
        pos: at,
        button,
        pressed,
        modifiers,
    }
}

/// Clicks, mostly with the primary button.
fn press(at: Pos2, dice: &mut Dice) -> Vec<Event> {
    use PointerButton::{Middle, Primary, Secondary};
    let which = dice.of(&[
        Primary, Primary, Primary, Primary, Primary, Primary, Secondary, Middle,
    ]);
    let [down, up] = [true, false].map(|pressed| button(at, which, pressed, Modifiers::NONE));
    vec![Event::PointerMoved(at), down, up]
}

fn pick<'w>(widgets: &'w [Widget], roles: &[Role], dice: &mut Dice) -> Option<&'w Widget> {
    let fitting: Vec<&Widget> = widgets
        .iter()
        .filter(|widget| roles.contains(&widget.role))
        .collect();
    if fitting.is_empty() {
        None
    } else {
        Some(dice.of(&fitting))
    }
}

/// Clicks a widget; one that is out of sight is clicked as by a screen reader.
fn click(widgets: &[Widget], screen: Rect, dice: &mut Dice) -> (String, Vec<Event>) {
    let roles = if dice.unit() < 0.2 {
        &[Role::Tab][..]
    } else {
        &ROLES
    };
    let Some(widget) = pick(widgets, roles, dice) else {
        let at = anywhere(screen, dice);
        return (format!("click at {at:?}"), press(at, dice));
    };
    let at = anywhere(widget.rect, dice);
    if screen.contains(at) && dice.unit() < 0.8 {
        return (
            format!("click on {:?} “{}” at {at:?}", widget.role, widget.label),
            press(at, dice),
        );
    }
    let events = vec![
        widget.request(Action::ScrollIntoView, None),
        widget.request(Action::Click, None),
    ];
    (
        format!("choose {:?} “{}”", widget.role, widget.label),
        events,
    )
}

/// Types into a field.
fn type_into(widgets: &[Widget], dice: &mut Dice) -> (String, Vec<Event>) {
    let Some(widget) = pick(widgets, &[Role::SpinButton, Role::TextInput], dice) else {
        return key(dice);
    };
    let text = if widget.is_size() {
        dice.of(&SIZES)
    } else {
        dice.of(&TEXTS)
    };
    let mut events = vec![
        widget.request(Action::ScrollIntoView, None),
        widget.request(Action::Focus, None),
    ];
    events.extend(stroke(Key::A, Modifiers::COMMAND));
    events.extend(text.chars().map(|letter| Event::Text(letter.into())));
    let end = dice.of(&[
        Some(Key::Enter),
        Some(Key::Enter),
        Some(Key::Tab),
        Some(Key::Escape),
        None,
    ]);
    events.extend(end.into_iter().flat_map(|key| stroke(key, Modifiers::NONE)));
    (
        format!("type “{text}” into “{}”, then {end:?}", widget.label),
        events,
    )
}

/// Sets a number as a screen reader does.
fn set(widgets: &[Widget], dice: &mut Dice) -> (String, Vec<Event>) {
    let widget =
        pick(widgets, &[Role::SpinButton, Role::Slider], dice).filter(|widget| !widget.is_size());
    let Some(widget) = widget else {
        return key(dice);
    };
    let value = dice.of(&NUMBERS);
    let request = widget.request(Action::SetValue, Some(ActionData::NumericValue(value)));
    (
        format!("set “{}” to {value:e}", widget.label),
        vec![request],
    )
}

fn drag(widgets: &[Widget], screen: Rect, dice: &mut Dice) -> (String, Vec<Event>) {
    let from = match pick(
        widgets,
        &[Role::Image, Role::Slider, Role::SpinButton],
        dice,
    ) {
        Some(widget) if dice.unit() < 0.6 => anywhere(widget.rect, dice),
        _ => anywhere(screen, dice),
    };
    let which = dice.of(&[
        PointerButton::Primary,
        PointerButton::Primary,
        PointerButton::Middle,
    ]);
    let held = dice.of(&[
        Modifiers::NONE,
        Modifiers::NONE,
        Modifiers::SHIFT,
        Modifiers::COMMAND,
    ]);
    let mut events = vec![
        Event::ModifiersChanged(held),
        Event::PointerMoved(from),
        button(from, which, true, held),
    ];
    let mut to = from;
    for _ in 0..dice.of(&[1, 2, 3, 5]) {
        to = anywhere(screen.expand(dice.of(&[0.0, 0.0, 500.0])), dice);
        events.push(Event::PointerMoved(to));
    }
    if dice.unit() < 0.95 {
        events.extend([
            button(to, which, false, held),
            Event::ModifiersChanged(Modifiers::NONE),
        ]);
    }
    (
        format!("drag with {which:?} and {held:?} from {from:?} to {to:?}"),
        events,
    )
}

fn wheel(screen: Rect, dice: &mut Dice) -> (String, Vec<Event>) {
    let at = anywhere(screen, dice);
    let delta = dice.of(&[
        vec2(0.0, 3.0),
        vec2(0.0, -3.0),
        vec2(0.0, 50.0),
        vec2(0.0, -50.0),
        vec2(5.0, 1e5),
        Vec2::ZERO,
    ]);
    let modifiers = dice.of(&[
        Modifiers::NONE,
        Modifiers::NONE,
        Modifiers::SHIFT,
        Modifiers::COMMAND,
    ]);
    let turn = Event::MouseWheel {
        unit: dice.of(&[
            MouseWheelUnit::Line,
            MouseWheelUnit::Point,
            MouseWheelUnit::Page,
        ]),
        delta,
        phase: TouchPhase::Move,
        source: eframe::egui::MouseWheelSource::Unknown,
        modifiers,
    };
    let held = |modifiers| Event::ModifiersChanged(modifiers);
    let events = vec![
        Event::PointerMoved(at),
        held(modifiers),
        turn,
        held(Modifiers::NONE),
    ];
    (
        format!("wheel by {delta:?} with {modifiers:?} at {at:?}"),
        events,
    )
}

/// Presses and releases a key, with the letter that it types.
fn stroke(key: Key, modifiers: Modifiers) -> Vec<Event> {
    let event = |pressed| Event::Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers,
    };
    let mut events = vec![Event::ModifiersChanged(modifiers), event(true)];
    let letter = key.symbol_or_name();
    if letter.len() == 1 && !modifiers.command && !modifiers.alt {
        events.push(Event::Text(if modifiers.shift {
            letter.to_owned()
        } else {
            letter.to_lowercase()
        }));
    }
    events.extend([event(false), Event::ModifiersChanged(Modifiers::NONE)]);
    events
}

fn key(dice: &mut Dice) -> (String, Vec<Event>) {
    let key = if dice.unit() < 0.7 {
        dice.of(&KEYS)
    } else {
        dice.of(Key::ALL)
    };
    let none = Modifiers::NONE;
    let modifiers = dice.of(&[
        none,
        none,
        none,
        none,
        Modifiers::SHIFT,
        Modifiers::COMMAND,
        Modifiers::ALT,
    ]);
    (
        format!("key {key:?} with {modifiers:?}"),
        stroke(key, modifiers),
    )
}

fn resize(harness: &mut Harness<'_, App>, dice: &mut Dice) -> (String, Vec<Event>) {
    let [width, height, scale] = dice.of(&WINDOWS);
    // A screen's size, whatever the zoom: at projector size a window would otherwise grow with every resize.
    harness.set_size(vec2(width, height) / harness.ctx.zoom_factor());
    for viewport in harness.input_mut().viewports.values_mut() {
        viewport.native_pixels_per_point = Some(scale);
    }
    (format!("resize to {width} × {height} at {scale}"), vec![])
}

fn other(dice: &mut Dice) -> (String, Vec<Event>) {
    let text = dice.of(&TEXTS);
    let events = [
        Event::Copy,
        Event::Cut,
        Event::Paste(text.to_owned()),
        Event::Text(text.to_owned()),
        Event::PointerGone,
        Event::WindowFocused(false),
        Event::WindowFocused(true),
        Event::Zoom(0.01),
        Event::Zoom(100.0),
    ];
    let event = events[(dice.unit() * events.len() as f64) as usize].clone();
    (format!("{event:?}"), vec![event])
}
