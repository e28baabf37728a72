//! The keyboard's focus: Tab goes from field to field, and a ring shows what has it. Names for screen readers.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Context, FocusDirection, Id, InputState, Key, Modifiers, Response, Stroke, StrokeKind,
    WidgetInfo,
};

/// Width of the ring, and its distance from what it surrounds; points.
const RING: [f32; 2] = [2.0, 2.0];

/// The fields in the order in which they are shown.
#[derive(Clone, Debug, Default)]
struct Fields {
    /// All of the last frame.
    last: Vec<Id>,
    /// Those of this frame so far.
    now: Vec<Id>,
}

/// The identity of the picture.
pub fn picture_id() -> Id {
    Id::unique("the picture")
}

fn id() -> Id {
    Id::unique("fields")
}

/// Gives a widget its name for screen readers.
pub fn named(response: Response, role: Role, name: &str) -> Response {
    response.widget_info(|| WidgetInfo::labeled(role, response.enabled(), name));
    response
}

/// Gives a button that is on or off its name.
pub fn switch_named(response: Response, role: Role, on: bool, name: &str) -> Response {
    response.widget_info(|| WidgetInfo::selected(role, response.enabled(), on, name));
    response
}

/// Adds a field to those that Tab goes through.
pub fn register(field: &Response) {
    if field.enabled() {
        field.ctx.data_mut(|data| {
            data.get_temp_mut_or_default::<Fields>(id())
                .now
                .push(field.id);
        });
    }
}

/// At the beginning of a frame: Tab in a field goes to the next one, with Shift to the one before, whatever lies between.
pub fn listen(ctx: &Context) {
    let fields = ctx.data_mut(|data| {
        let fields = data.get_temp_mut_or_default::<Fields>(id());
        fields.last = std::mem::take(&mut fields.now);
        fields.last.clone()
    });
    let place = ctx
        .memory(|memory| memory.focused())
        .and_then(|focused| fields.iter().position(|id| *id == focused));
    let Some(place) = place else { return };
    let next = if ctx.input(|input| input.modifiers.shift) {
        place.checked_sub(1)
    } else {
        place.checked_add(1)
    };
    // Past the last field and before the first the toolkit's own order goes on.
    let Some(next) = next.and_then(|next| fields.get(next)) else {
        return;
    };
    let tab = |input: &mut InputState| {
        [Modifiers::NONE, Modifiers::SHIFT].map(|held| input.consume_key(held, Key::Tab))
    };
    if ctx.input_mut(tab).contains(&true) {
        ctx.memory_mut(|memory| {
            memory.request_focus(*next);
            memory.move_focus(FocusDirection::None);
        });
    }
}

/// At the end of a frame: a ring round what has the focus; the picture does without.
pub fn show(ctx: &Context) {
    let focused = ctx
        .memory(|memory| memory.focused())
        .filter(|focused| *focused != picture_id());
    let Some(response) = focused.and_then(|id| ctx.read_response(id)) else {
        return;
    };
    let [width, gap] = RING;
    let painter = ctx.layer_painter(response.layer_id);
    let stroke = Stroke::new(width, ctx.global_style().visuals.strong_text_color());
    let rect = response.interact_rect;
    if rect.is_positive() {
        painter.rect_stroke(rect.expand(gap), 4.0, stroke, StrokeKind::Middle);
    }
}
