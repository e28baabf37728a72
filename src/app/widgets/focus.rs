//! Keyboard focus: Tab moves from stop to stop, a ring marks the focused widget, and widgets have names for screen
//! readers.
//!
//! Every widget of the panels is a stop of Tab, in the order in which it is shown, except those taken out by [`aside`],
//! such as a slider beside its field. A group ([`one_stop`]) is a single stop; the arrow keys move on from there.

use eframe::egui::accesskit::{Live, Node, Role};
use eframe::egui::style::ScrollAnimation;
use eframe::egui::{
    Context, Event, FocusDirection, Id, Key, LayerId, Modifiers, Rect, Response, Stroke,
    StrokeKind, Ui, WidgetInfo, WidgetRect,
};

/// Width of the ring, and its distance from the widget; points.
const RING: [f32; 2] = [2.0, 2.0];

/// Frames for which egui counts a field among those that have just lost the focus.
const ESCAPE: u8 = 2;

/// The widgets that Tab skips in a frame.
#[derive(Clone, Debug, Default)]
struct Passed {
    /// Widgets beside a stop.
    aside: Vec<Id>,
    /// The rectangle of each group, and the clip rectangle of the panel around it.
    groups: Vec<[Rect; 2]>,
}

/// Focus state kept from one frame to the next.
#[derive(Clone, Debug, Default)]
struct FocusMemory {
    last: Passed,
    now: Passed,
    /// True if a key last moved the focus; only then does the picture have its ring.
    by_key: bool,
    /// True if a key moved the focus in this frame.
    moved: bool,
    /// Height of the window, points.
    height: f32,
    /// True if the window has just become lower while a field is being edited: the on-screen keyboard of a phone takes
    /// half of the screen.
    lower: bool,
    /// Frames since Escape was pressed, as long as a field that lost the focus may still commit its text.
    escaped: Option<u8>,
    /// True if the row with the focus is to be reset.
    reset: bool,
}

/// Returns the widget ID of the picture.
pub fn picture_id() -> Id {
    Id::unique("picture")
}

fn with<R>(ctx: &Context, change: impl FnOnce(&mut FocusMemory) -> R) -> R {
    ctx.data_mut(|data| change(data.get_temp_mut_or_default(Id::unique("focus"))))
}

/// Gives a widget its name for screen readers.
pub fn named(response: Response, role: Role, name: &str) -> Response {
    response.widget_info(|| WidgetInfo::labeled(role, response.enabled(), name));
    response
}

/// Gives a toggle button its name and state for screen readers.
pub fn switch_named(response: Response, role: Role, on: bool, name: &str) -> Response {
    response.widget_info(|| WidgetInfo::selected(role, response.enabled(), on, name));
    response
}

/// Shows a heading, which screen readers know as one.
pub fn heading(ui: &mut Ui, words: &str) -> Response {
    let response = ui.heading(words);
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_role(Role::Heading);
        node.set_label(words);
    });
    response
}

/// Has screen readers announce the text of a widget whenever it changes.
pub fn live(response: &Response) {
    let set = |node: &mut Node| node.set_live(Live::Polite);
    response.ctx.accesskit_node_builder(response.id, set);
}

/// Removes a widget beside a stop from the order of Tab.
pub fn aside(response: &Response) {
    with(&response.ctx, |focus| focus.now.aside.push(response.id));
}

/// Makes all widgets within `rect` a single stop of Tab, at the first of them.
pub fn one_stop(ui: &Ui, rect: Rect) {
    let seen = ui.clip_rect();
    with(ui.ctx(), |focus| focus.now.groups.push([rect, seen]));
}

/// Returns the widgets of the panels in the order in which they were shown, and whether each is a stop.
fn stops(ctx: &Context) -> Vec<(Id, bool)> {
    let passed = with(ctx, |focus| focus.last.clone());
    let mut entered = vec![false; passed.groups.len()];
    let mut is_stop = |widget: &WidgetRect| {
        let centre = widget.rect.center();
        let mut groups = passed.groups.iter().zip(&mut entered);
        // A widget scrolled out of sight may lie behind other groups without belonging to them.
        let seen = widget.interact_rect.is_positive();
        let group = groups
            .find(|([group, clip], _)| group.contains(centre) && (seen || !clip.contains(centre)));
        !passed.aside.contains(&widget.id)
            && group.is_none_or(|(_, entered)| !std::mem::replace(entered, true))
    };
    ctx.viewport(|viewport| {
        let all = viewport.prev_pass.widgets.get_layer(LayerId::background());
        all.filter(|widget| widget.enabled && widget.sense.is_focusable())
            .map(|widget| (widget.id, is_stop(widget)))
            .collect()
    })
}

/// Returns the stop after the focused widget, or before it if `back`; wraps around at both ends.
fn next(stops: &[(Id, bool)], focused: Option<Id>, back: bool) -> Option<Id> {
    let count = stops.len();
    let place = focused.and_then(|focused| stops.iter().position(|(id, _)| *id == focused));
    let step = |steps: usize| match (place, back) {
        (Some(place), false) => (place + steps) % count,
        (Some(place), true) => (place + count - steps) % count,
        (None, false) => steps - 1,
        (None, true) => count - steps,
    };
    let (id, _) = (1..=count)
        .map(|steps| stops[step(steps)])
        .find(|(_, is_stop)| *is_stop)?;
    Some(id)
}

/// Handles Tab at the beginning of a frame: moves the focus to the next stop, with Shift to the previous one. While
/// something is `in_front` of the panels, egui's own order applies.
pub fn listen(ctx: &Context, in_front: bool) {
    let (pointed, escape) =
        ctx.input(|input| (input.pointer.any_pressed(), input.key_pressed(Key::Escape)));
    let (height, typing) = (ctx.content_rect().height(), ctx.text_edit_focused());
    with(ctx, |focus| {
        focus.last = std::mem::take(&mut focus.now);
        focus.lower = typing && height < focus.height;
        focus.height = height;
        (focus.moved, focus.by_key) = (false, focus.by_key && !pointed);
        focus.escaped = match focus.escaped {
            _ if escape => Some(0),
            Some(frames) if frames < ESCAPE => Some(frames + 1),
            _ => None,
        };
    });
    if in_front || !ctx.input(|input| input.key_pressed(Key::Tab)) {
        return;
    }
    let focused = ctx.memory(|memory| memory.focused());
    let widget = focused.and_then(|id| placed(ctx, id));
    if widget.is_some_and(|widget| widget.layer_id != LayerId::background()) {
        return;
    }
    // Read from the event: by the end of a slow frame, Shift may have been released.
    let back = ctx.input(|input| {
        input.events.iter().any(|event| {
            matches!(event, Event::Key { key: Key::Tab, pressed: true, modifiers, .. } if modifiers.shift)
        })
    });
    let held = if back {
        Modifiers::SHIFT
    } else {
        Modifiers::NONE
    };
    if !ctx.input_mut(|input| input.consume_key(held, Key::Tab)) {
        return;
    }
    if let Some(next) = next(&stops(ctx), focused, back) {
        take(ctx, next);
    }
}

/// Gives a widget the focus as a key does.
pub fn take(ctx: &Context, id: Id) {
    ctx.memory_mut(|memory| {
        memory.request_focus(id);
        memory.move_focus(FocusDirection::None);
    });
    with(ctx, |focus| (focus.moved, focus.by_key) = (true, true));
}

/// Gives a field the focus if no widget has it.
pub fn take_if_free(field: &Response) {
    if field.ctx.memory(|memory| memory.focused().is_none()) {
        field.request_focus();
    }
}

/// Gives the focus to the first stop of the window, the menus.
pub fn take_first(ctx: &Context) {
    if let Some(first) = next(&stops(ctx), None, false) {
        take(ctx, first);
    }
}

/// Returns whether Tab leaves a page at the focused widget: with nothing behind it, or before it if `back`. The focus is
/// given up then.
#[cfg(target_arch = "wasm32")]
pub fn leaves(ctx: &Context, back: bool) -> bool {
    let stops = stops(ctx);
    let focused = ctx.memory(|memory| memory.focused());
    let Some(place) = stops.iter().position(|(id, _)| Some(*id) == focused) else {
        return false;
    };
    let beyond = if back {
        &stops[..place]
    } else {
        &stops[place + 1..]
    };
    let leaves = !beyond.iter().any(|(_, is_stop)| *is_stop);
    if leaves {
        ctx.memory_mut(|memory| memory.surrender_focus(stops[place].0));
        ctx.request_repaint();
    }
    leaves
}

/// Gives the focus to the first stop, or to the last one if `back`, unless a widget has it.
#[cfg(target_arch = "wasm32")]
pub fn enter(ctx: &Context, back: bool) {
    if ctx.memory(|memory| memory.focused()).is_some() {
        return;
    }
    if let Some(stop) = next(&stops(ctx), None, back) {
        take(ctx, stop);
        ctx.request_repaint();
    }
}

/// Returns whether Escape has just taken the focus from a field, so that the typed text is discarded.
pub fn escaped(ctx: &Context) -> bool {
    with(ctx, |focus| focus.escaped.is_some())
}

/// Requests that the row with the focus resets its value in the next frame.
pub fn ask_reset(ctx: &Context) {
    with(ctx, |focus| focus.reset = true);
}

/// Returns where a widget is, in this frame or the one before. Its response is not asked for: that takes the focus from
/// a field to which a click elsewhere has just given it.
fn placed(ctx: &Context, id: Id) -> Option<WidgetRect> {
    ctx.viewport(|viewport| {
        let passes = [&viewport.this_pass, &viewport.prev_pass];
        passes.iter().find_map(|pass| pass.widgets.get(id).copied())
    })
}

/// Returns the rectangle of the focused widget, if it is in `rect`.
fn focused_in(ui: &Ui, rect: Rect) -> Option<Rect> {
    let id = ui.memory(|memory| memory.focused())?;
    let widget = placed(ui.ctx(), id)?;
    let inside = widget.layer_id == ui.layer_id() && rect.contains(widget.rect.center());
    inside.then_some(widget.rect)
}

/// Returns whether the keyboard resets the row in `rect`, and clears the request.
pub fn resets(ui: &Ui, rect: Rect) -> bool {
    let reset = with(ui.ctx(), |focus| focus.reset) && focused_in(ui, rect).is_some();
    if reset {
        with(ui.ctx(), |focus| focus.reset = false);
    }
    reset
}

/// Scrolls to the focused widget, at the end of a scroll area, if a key has just moved the focus or the window has
/// become lower.
pub fn keep_in_sight(ui: &Ui) {
    let (moved, lower) = with(ui.ctx(), |focus| (focus.moved, focus.lower));
    let Some(rect) = focused_in(ui, ui.min_rect()).filter(|_| moved || lower) else {
        return;
    };
    if lower {
        // In this very frame: a browser hides its keyboard when the field is not drawn.
        ui.scroll_to_rect_animation(rect, None, ScrollAnimation::none());
        ui.ctx().request_discard("keep-in-sight");
    } else {
        ui.scroll_to_rect(rect, None);
    }
}

/// Draws a ring around the focused widget at the end of a frame; around the picture only if a key gave it the focus.
pub fn show(ctx: &Context) {
    let by_key = with(ctx, |focus| focus.by_key);
    let Some(id) = ctx.memory(|memory| memory.focused()) else {
        return;
    };
    let by_pointer = id == picture_id() && !by_key;
    let Some(widget) = placed(ctx, id).filter(|_| !by_pointer) else {
        return;
    };
    let [width, gap] = RING;
    let painter = ctx.layer_painter(widget.layer_id);
    let stroke = Stroke::new(width, ctx.global_style().visuals.hyperlink_color);
    let rect = widget.interact_rect;
    if rect.is_positive() {
        painter.rect_stroke(rect.expand(gap), 6.0, stroke, StrokeKind::Middle);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tab_goes_round_the_stops_and_passes_over_the_rest() {
        let id = |number: u32| Id::unique(("widget", number));
        let stops = [(id(0), true), (id(1), false), (id(2), true), (id(3), false)];
        for (focused, back, expected) in [
            (None, false, 0),
            (None, true, 2),
            (Some(0), false, 2),
            (Some(1), false, 2),
            (Some(3), false, 0),
            (Some(3), true, 2),
            (Some(0), true, 2),
            (Some(9), false, 0),
        ] {
            assert_eq!(
                next(&stops, focused.map(id), back),
                Some(id(expected)),
                "{focused:?} {back}"
            );
        }
        assert_eq!(next(&[(id(1), false)], None, false), None);
        assert_eq!(next(&[], Some(id(1)), true), None);
    }
}
