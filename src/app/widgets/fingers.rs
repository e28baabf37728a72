//! Fingers on the window: a finger that moves up or down over a slider or a field scrolls, and changes no value.
//!
//! The press on such a control is held back until the finger's way is known: sideways it is a drag of the control, upwards or
//! downwards it scrolls the panel, and a finger that is lifted at once has tapped. In a figure among the text of another page,
//! whatever goes up or down is left to that page.

use eframe::egui::{
    Context, Event, Modifiers, MouseWheelSource, MouseWheelUnit, Plugin, PointerButton, Pos2,
    RawInput, Rect, Response, TouchDeviceId, TouchId, TouchPhase, Vec2, vec2,
};
use std::collections::BTreeSet;

/// The distance after which the way of a finger is known, in points.
const DECIDED: f32 = 8.0;
/// The time after which a finger rests, in seconds.
const RESTS: f64 = 0.8;
/// Far outside of any window, in points: a press that is moved there is no click.
const OUTSIDE: Pos2 = Pos2::new(-1e4, -1e4);

/// A control whose press is held back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// A control that takes its value from where it is pressed.
    Slider,
    /// A control that is clicked or dragged.
    Field,
    /// The picture of a figure, as long as a page around it scrolls.
    Figure,
}

/// The controls of the last frame and of this one, with their visible rectangles.
#[derive(Clone, Debug, Default)]
struct Controls {
    last: Vec<(Rect, Held)>,
    now: Vec<(Rect, Held)>,
    /// True if the wheel and the fingers that go up or down scroll a page around this window.
    page_scrolls: bool,
}

impl Controls {
    /// Returns the control at a point whose press is held back.
    fn at(&self, pos: Pos2) -> Option<Held> {
        let mut hit = self
            .last
            .iter()
            .rev()
            .filter(|(rect, _)| rect.contains(pos));
        let (_, held) = hit.next()?;
        (*held != Held::Figure || self.page_scrolls).then_some(*held)
    }
}

fn controls<R>(ctx: &Context, change: impl FnOnce(&mut Controls) -> R) -> R {
    let id = eframe::egui::Id::unique("fingers");
    ctx.data_mut(|data| change(data.get_temp_mut_or_default(id)))
}

/// Holds back the press of a finger on a widget.
pub fn hold(response: &Response, held: Held) {
    let seen = response.interact_rect;
    controls(&response.ctx, |controls| controls.now.push((seen, held)));
}

/// Prepares a frame: the controls of the last one are those that a finger meets.
pub fn begin_frame(ctx: &Context, page_scrolls: bool) {
    controls(ctx, |controls| {
        controls.last = std::mem::take(&mut controls.now);
        controls.page_scrolls = page_scrolls;
    });
    click_within(ctx, f64::INFINITY);
}

/// Has a finger that rests on the pressed widget open a menu. Elsewhere a slow press is a click: not every hand is fast.
pub fn allow_rest(ctx: &Context) {
    click_within(ctx, RESTS);
}

/// Sets the duration of the longest press that is a click, in seconds.
fn click_within(ctx: &Context, seconds: f64) {
    ctx.options_mut(|options| options.input_options.max_click_duration = seconds);
}

/// The way of a finger whose press is held back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    Unknown,
    Scrolls,
    /// Nothing happens until the finger is lifted.
    Ignored,
}

/// A finger on a control.
#[derive(Clone, Copy, Debug)]
struct Finger {
    origin: Pos2,
    at: Pos2,
    control: Held,
    way: Way,
}

/// The plugin that holds presses back.
#[derive(Debug, Default)]
pub struct Fingers {
    down: BTreeSet<TouchId>,
    finger: Option<Finger>,
    /// Events for the next frame.
    later: Vec<Event>,
    /// True until the toolkit knows that there are fingers.
    unknown: bool,
}

impl Fingers {
    /// Creates the plugin. If fingers are expected, the first of them finds a window for fingers.
    pub fn new(expected: bool) -> Self {
        Self {
            unknown: expected,
            ..Self::default()
        }
    }
}

fn button(pos: Pos2, pressed: bool) -> Event {
    Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

fn wheel(phase: TouchPhase, delta: Vec2) -> Event {
    Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        delta,
        modifiers: Modifiers::NONE,
        phase,
        source: MouseWheelSource::Unknown,
    }
}

impl Plugin for Fingers {
    fn debug_name(&self) -> &'static str {
        "fingers"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        let events = std::mem::take(&mut input.events);
        input.events = std::mem::take(&mut self.later);
        if std::mem::take(&mut self.unknown) {
            // A device is known by its first event, even by one that ends a touch.
            input.events.push(Event::Touch {
                device_id: TouchDeviceId(0),
                id: TouchId(0),
                phase: TouchPhase::Cancel,
                pos: OUTSIDE,
                force: None,
            });
        }
        // The back ends report a touch before or after its press.
        let touched = events.iter().any(
            |event| matches!(event, Event::Touch { phase, .. } if *phase == TouchPhase::Start),
        );
        for event in events {
            self.count(ctx, &event, &mut input.events);
            self.filter(ctx, event, touched, &mut input.events);
        }
        if !self.later.is_empty() {
            ctx.request_repaint();
        }
    }
}

impl Fingers {
    /// Counts the fingers. A second one means both, and one that the system takes away has not clicked.
    fn count(&mut self, ctx: &Context, event: &Event, out: &mut Vec<Event>) {
        let Event::Touch { id, phase, .. } = event else {
            return;
        };
        match phase {
            TouchPhase::Start => _ = self.down.insert(*id),
            TouchPhase::Move => {}
            TouchPhase::End => _ = self.down.remove(id),
            TouchPhase::Cancel => {
                self.down.clear();
                if self.finger.take().is_none() && ctx.input(|input| input.pointer.any_down()) {
                    ctx.stop_dragging();
                    out.extend([Event::PointerMoved(OUTSIDE), button(OUTSIDE, false)]);
                }
                out.push(Event::PointerGone);
            }
        }
        if self.down.len() > 1
            && let Some(finger) = &mut self.finger
        {
            finger.way = Way::Ignored;
        }
    }

    /// Passes an event on, holds it back, or puts others in its place.
    fn filter(&mut self, ctx: &Context, event: Event, touched: bool, out: &mut Vec<Event>) {
        if let Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed: true,
            ..
        } = event
            && touched
            && self.finger.is_none()
            && let Some(control) = controls(ctx, |controls| controls.at(pos))
        {
            self.finger = Some(Finger {
                origin: pos,
                at: pos,
                control,
                way: Way::Unknown,
            });
            out.push(Event::PointerMoved(pos));
            return;
        }
        let page_scrolls = controls(ctx, |controls| controls.page_scrolls);
        match (event, &mut self.finger) {
            (Event::MouseWheel { .. } | Event::Zoom(_), _) if page_scrolls => {}
            (Event::PointerButton { pressed: true, .. }, Some(_)) => {}
            (Event::PointerMoved(at), Some(finger)) => {
                if let Some(drag) = finger.moved(at, page_scrolls, out) {
                    self.finger = None;
                    out.extend(drag);
                }
            }
            (Event::PointerButton { pressed: false, .. }, Some(finger)) => {
                match (finger.way, finger.control) {
                    (Way::Unknown, Held::Slider) => {
                        out.push(button(finger.origin, true));
                        self.later = vec![button(finger.origin, false), Event::PointerGone];
                    }
                    (Way::Unknown, _) => {
                        out.extend([true, false].map(|pressed| button(finger.origin, pressed)));
                    }
                    (Way::Scrolls, _) => out.push(wheel(TouchPhase::End, Vec2::ZERO)),
                    (Way::Ignored, _) => {}
                }
                self.finger = None;
            }
            (Event::PointerGone, Some(_)) => {}
            // A slider that is tapped is released in the next frame only.
            (Event::PointerGone, None) if !self.later.is_empty() => {}
            (event, _) => out.push(event),
        }
    }
}

impl Finger {
    /// Follows the finger. Returns the press and the move of a drag, once it is one.
    fn moved(&mut self, at: Pos2, page_scrolls: bool, out: &mut Vec<Event>) -> Option<[Event; 2]> {
        let (way, step) = (at - self.origin, at.y - self.at.y);
        self.at = at;
        if self.way == Way::Unknown && way.length() >= DECIDED {
            if way.x.abs() > way.y.abs() {
                return Some([button(self.origin, true), Event::PointerMoved(at)]);
            }
            if page_scrolls {
                self.way = Way::Ignored;
            } else {
                self.way = Way::Scrolls;
                out.push(wheel(TouchPhase::Start, Vec2::ZERO));
                out.push(wheel(TouchPhase::Move, vec2(0.0, way.y)));
                return None;
            }
        }
        if self.way == Way::Scrolls {
            out.push(wheel(TouchPhase::Move, vec2(0.0, step)));
        }
        None
    }
}
