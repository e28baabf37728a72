//! The picture in the middle: drawn pixel for pixel, turned, zoomed and probed by hand.

use super::action::Action;
use super::defects;
use super::engine::Engine;
use super::focus;
use super::handles::{self, Handle, Placed};
use super::orbit;
use super::panes::{self, PanePlace};
use super::place::Place;
use super::points::ProbePoint;
use super::profile::{self, Profiles};
use super::scan;
use super::state::{AppState, Drag};
use crate::scene::View;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Color32, CursorIcon, EventFilter, Painter, PointerButton, Rect, Response, Sense, Stroke, TextStyle, Ui, WidgetInfo,
    pos2,
};
use glam::DVec2;

/// Degrees that the camera turns when the pointer travels the picture's height.
const DEGREES_PER_HEIGHT: f64 = 180.0;
/// How fast the wheel zooms: the logarithm of the factor a point of scrolling makes.
const ZOOM_PER_POINT: f64 = 0.0025;
/// How near the pointer must be to take hold of something, points.
const REACH: f32 = 14.0;
/// How near it must be to a vertex to light up its faces, points.
const NEAR_VERTEX: f32 = 12.0;

/// The room of the picture and of one of its panes, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    pub whole: [u32; 2],
    pub pane: [u32; 2],
}

/// Shows the picture, or the panes of a comparison, and does what the pointer asks for.
pub fn picture_ui(ui: &mut Ui, state: &mut AppState, engine: &mut Engine) -> Room {
    let whole = Place::of(ui);
    let response = ui.interact(whole.rect, focus::picture_id(), Sense::click_and_drag());
    describe(ui, state, &response);
    keep_arrows(ui, &response);
    // What the panels changed is shown by every pane.
    state.commit();
    let panes = panes::places(state, whole);
    let place = pointed(ui, state, &response, &panes).unwrap_or(whole);
    let view = View::new(&state.shown.scene.camera, place.size);
    let handles = handles::place(state, &view, place);
    gesture(ui, state, &response, place, whole, &view, &handles);
    wheel(ui, state, &response, place, &view, &handles);
    state.commit();
    engine.update(ui.ctx(), state, place.size);
    point_at_vertex(ui, state, engine, &response, place);
    let panes = panes::places(state, whole);
    for pane in &panes {
        paint(ui, state, engine, pane);
    }
    panes::paint(ui, state, engine, &panes, whole);
    Room { whole: whole.size, pane: place.size }
}

/// Lights up the faces of the vertex that the pointer is on, where normals are shown.
fn point_at_vertex(ui: &Ui, state: &mut AppState, engine: &mut Engine, response: &Response, place: Place) {
    let pointer = response.hover_pos().filter(|_| state.drag == Drag::Nothing).map(|at| place.pixel(at));
    let clicked = response.clicked() && !response.double_clicked();
    engine.point_at(ui.ctx(), state, pointer, f64::from(NEAR_VERTEX * place.pixels_per_point), clicked);
}

/// Where the pane is that the pointer is about: under it, or the active one while it drags. A press makes a pane active.
fn pointed(ui: &Ui, state: &mut AppState, response: &Response, panes: &[PanePlace]) -> Option<Place> {
    let pressed = response.is_pointer_button_down_on() && ui.input(|input| input.pointer.any_pressed());
    let origin = ui.input(|input| input.pointer.press_origin()).filter(|_| pressed);
    if let Some(at) = origin
        && !panes::on_wipe(state, panes, at, REACH)
        && let Some(pane) = panes::pane_at(panes, state.panes.active, at)
    {
        state.activate(pane.pane);
    }
    let hover = response.hover_pos().filter(|_| state.drag == Drag::Nothing);
    let hovered = hover.and_then(|at| panes::pane_at(panes, state.panes.active, at));
    let active = || panes.iter().find(|pane| pane.pane == state.panes.active).or(panes.first()).copied();
    hovered.or_else(active).map(|pane| pane.place)
}

fn describe(ui: &Ui, state: &AppState, response: &Response) {
    let mode = format!("{:?}", state.shown.scene.shading.mode).to_lowercase();
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(Role::Image, enabled, format!("Picture, {mode} shading")));
}

/// With the focus on the picture the arrow keys are the probe's.
fn keep_arrows(ui: &Ui, response: &Response) {
    if response.clicked() || response.drag_started() {
        response.request_focus();
    }
    if response.has_focus() {
        let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    }
}

/// What a drag that begins at `at` would move.
fn under(state: &AppState, place: Place, view: &View, handles: &[Placed], at: eframe::egui::Pos2) -> Drag {
    if let Some((end, there)) = handles::line::end_at(state, place, at, REACH) {
        return Drag::LineEnd { end, grab: place.pixel(there) - place.pixel(at) };
    }
    if handles::turn::near(state, place, at, REACH) {
        return Drag::Roll;
    }
    let vertex = handles::vertex::nearest(state, view, place, at, REACH);
    let light = handles::nearest(handles, at, REACH);
    let vertex = vertex.filter(|(_, there)| light.is_none_or(|light| there.distance(at) < light.at.distance(at)));
    if let Some((vertex, there)) = vertex {
        return Drag::Vertex { vertex, grab: place.pixel(there) - place.pixel(at) };
    }
    if let Some(placed) = light {
        let (index, grab) = (placed.index, place.pixel(placed.at) - place.pixel(at));
        return match placed.handle {
            Handle::Aim { front } => Drag::Aim { index, grab, front },
            Handle::Rim(_) => Drag::Rim { index, grab },
            _ => Drag::Light { index, grab },
        };
    }
    let probe = place.point(probe_centre(state, place));
    if probe.distance(at) <= REACH {
        return Drag::Probe;
    }
    if panes::on_wipe(state, &panes::places(state, place), at, REACH) { Drag::Wipe } else { Drag::Orbit }
}

fn probe_centre(state: &AppState, place: Place) -> DVec2 {
    let [x, y] = state.probe.pixel(place.size);
    DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5)
}

fn gesture(
    ui: &Ui,
    state: &mut AppState,
    response: &Response,
    place: Place,
    whole: Place,
    view: &View,
    handles: &[Placed],
) {
    let shift = ui.input(|input| input.modifiers.shift);
    if response.drag_started() {
        let at = ui.input(|input| input.pointer.press_origin()).unwrap_or(place.rect.center());
        let middle = response.dragged_by(PointerButton::Middle) || response.dragged_by(PointerButton::Secondary);
        state.drag = match under(state, place, view, handles, at) {
            Drag::Light { index, .. } if shift => Drag::LightDepth { index },
            Drag::Vertex { vertex, .. } if shift => Drag::VertexDepth { vertex },
            Drag::Orbit if shift || middle => Drag::Pan,
            drag => drag,
        };
        if let Drag::Light { index, .. } | Drag::LightDepth { index } = state.drag {
            state.light = index;
        }
        if let Drag::Vertex { vertex, .. } | Drag::VertexDepth { vertex } = state.drag {
            state.vertex = vertex as usize;
        }
    }
    if response.dragged() {
        drag(ui, state, response, place, whole, view);
    }
    if response.drag_stopped() {
        state.drag = Drag::Nothing;
    }
    if let Some(at) = response.interact_pointer_pos().filter(|_| response.double_clicked()) {
        put_probe(state, place, at);
    }
    if response.clicked() && !response.double_clicked() {
        let hit = response.interact_pointer_pos().and_then(|at| handles::nearest(handles, at, REACH));
        state.light = hit.map_or(state.light, |placed| placed.index);
        let at = response.interact_pointer_pos();
        let hit = at.and_then(|at| handles::vertex::nearest(state, view, place, at, REACH));
        state.vertex = hit.map_or(state.vertex, |(vertex, _)| vertex as usize);
    }
    cursor(ui, state, response, place, view, handles, shift);
}

fn put_probe(state: &mut AppState, place: Place, at: eframe::egui::Pos2) {
    let pixel = place.pixel(at);
    let inside = |value: f64, side: u32| value.clamp(0.0, f64::from(side.saturating_sub(1))) as u32;
    state.probe = ProbePoint::at([inside(pixel.x, place.size[0]), inside(pixel.y, place.size[1])], place.size);
}

fn drag(ui: &Ui, state: &mut AppState, response: &Response, place: Place, whole: Place, view: &View) {
    let Some(at) = response.interact_pointer_pos() else { return };
    let delta = response.drag_delta() / place.rect.height().max(1.0);
    let (dx, dy) = (f64::from(delta.x), f64::from(delta.y));
    let camera = &mut state.shown.scene.camera;
    match state.drag {
        Drag::Nothing => {}
        Drag::Orbit => {
            // What is under the pointer follows it, whichever way the picture is turned.
            let way = View::without_roll(DVec2::new(-dx, dy) * DEGREES_PER_HEIGHT, camera.roll);
            orbit::orbit(camera, way.x, way.y);
        }
        Drag::Pan => orbit::pan(camera, -dx, dy),
        Drag::Probe => put_probe(state, place, at),
        Drag::Wipe => {
            let share = whole.pixel(at).x / f64::from(whole.size[0].max(1));
            state.document.scene.compare.wipe = (share.clamp(0.0, 1.0) * 1000.0).round() / 1000.0;
        }
        Drag::Roll => handles::turn::drag_to(state, place, at),
        Drag::LineEnd { end, grab } => state.line.put(end, place.pixel(at) + grab, place.size),
        Drag::Light { index, grab } => handles::drag_to(state, index, view, place.pixel(at) + grab),
        Drag::Vertex { vertex, grab } => handles::vertex::drag_to(state, vertex, view, place.pixel(at) + grab),
        Drag::VertexDepth { vertex } => handles::vertex::push(state, vertex, view, -dy * 2.0),
        Drag::LightDepth { index } => handles::push(state, index, view, -dy * 2.0),
        Drag::Aim { index, grab, front } => handles::aim_at(state, index, view, place.pixel(at) + grab, front),
        Drag::Rim { index, grab } => handles::open_to(state, index, view, place.pixel(at) + grab),
    }
    ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
}

fn cursor(ui: &Ui, state: &AppState, response: &Response, place: Place, view: &View, handles: &[Placed], shift: bool) {
    let hover = response.hover_pos().filter(|_| !response.dragged());
    let Some(at) = hover else { return };
    let icon = match under(state, place, view, handles, at) {
        Drag::Light { .. } | Drag::Vertex { .. } if shift => CursorIcon::ResizeVertical,
        Drag::Light { .. } | Drag::Vertex { .. } | Drag::Aim { .. } | Drag::LineEnd { .. } | Drag::Roll => {
            CursorIcon::Grab
        }
        Drag::Rim { .. } => rim_cursor(handles),
        Drag::Probe => CursorIcon::Crosshair,
        Drag::Wipe => CursorIcon::ResizeHorizontal,
        _ if shift => CursorIcon::Move,
        _ => CursorIcon::AllScroll,
    };
    ui.ctx().set_cursor_icon(icon);
}

fn rim_cursor(handles: &[Placed]) -> CursorIcon {
    let way = handles.iter().find_map(|placed| match placed.handle {
        Handle::Rim(way) => Some(way),
        _ => None,
    });
    way.map_or(CursorIcon::Grab, handles::cursor)
}

fn wheel(ui: &Ui, state: &mut AppState, response: &Response, place: Place, view: &View, handles: &[Placed]) {
    let Some(at) = response.hover_pos() else { return };
    let (scroll, pinch) = ui.input(|input| (f64::from(input.smooth_scroll_delta().y), f64::from(input.zoom_delta())));
    if scroll == 0.0 && pinch == 1.0 {
        return;
    }
    let factor = (-scroll * ZOOM_PER_POINT).exp() / pinch;
    match under(state, place, view, handles, at) {
        Drag::Light { index, .. } => handles::push(state, index, view, -factor.ln()),
        _ => state.ask(Action::Zoom(factor)),
    }
}

fn paint(ui: &Ui, state: &AppState, engine: &Engine, pane: &PanePlace) {
    let place = pane.place;
    let painter = ui.painter().with_clip_rect(pane.seen);
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    let active = pane.pane == state.panes.active;
    let overlay = engine.overlay().filter(|_| active);
    let perceived = state.own.get().and_then(Profiles::perceived).filter(|_| active && profile::shows_perceived(state));
    let picture = perceived.or(engine.difference()).or(engine.picture(pane.pane));
    let [needles, lit] = engine.normals().map(|texture| texture.filter(|_| active));
    for texture in [picture, needles, overlay, lit].into_iter().flatten() {
        painter.image(texture.id(), place.rect, whole, Color32::WHITE);
    }
    let view = View::new(&state.shown.scene.camera, place.size);
    if state.look.overlay.vectors {
        probe_ui(&painter, place.point(probe_centre(state, place)), state.drag == Drag::Probe);
    }
    handles::paint(&painter, state, &view, place);
    handles::line::paint(&painter, state, place, active);
    handles::turn::paint(&painter, state, place);
    if active {
        defects::paint(&painter, state, place, &TextStyle::Body.resolve(ui.style()));
    }
    let pointer = ui.input(|input| input.pointer.hover_pos());
    handles::vertex::paint(&painter, state, &view, place, pointer);
    scan::paint(&painter, state, place);
    for placed in handles::place(state, &view, place) {
        Handle::paint(&painter, &placed, state.light == placed.index);
    }
}

/// A ring round the probed pixel, light on dark on light, so that it shows on any picture.
fn probe_ui(painter: &Painter, at: eframe::egui::Pos2, held: bool) {
    let radius = if held { 8.0 } else { 6.0 };
    painter.circle_stroke(at, radius, Stroke::new(3.5, Color32::from_black_alpha(150)));
    painter.circle_stroke(at, radius, Stroke::new(1.5, Color32::WHITE));
}
