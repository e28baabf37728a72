//! The central picture: drawn pixel for pixel; turned, zoomed and probed by hand.

mod description;
pub mod handles;
mod menu;
pub mod orbit;
pub mod panes;

use super::course;
use super::engine::Engine;
use crate::app::course::Course;
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::place::{Place, ProbePoint, from_pixel};
use crate::app::session::window::{Drag, Grip, LightStart, WindowState};
use crate::app::views::defects;
use crate::app::views::profile::{self, Profiles};
use crate::app::views::scan;
use crate::app::widgets::fingers::{Held, allow_rest, hold};
use crate::app::widgets::focus;
use crate::app::widgets::letter::letter;
use crate::figure::Area;
use crate::scene::{Camera, Choice as _, View};
use crate::text;
use description::{Described, described};
use eframe::egui::accesskit::{Live, Role};
use eframe::egui::{
    Align2, Color32, CursorIcon, EventFilter, InputState, PointerButton, Pos2, Rect, Response,
    Sense, Stroke, TextStyle, Ui, pos2, vec2,
};
use glam::DVec2;
use panes::PanePlace;

/// The degrees that the camera turns when the pointer crosses the side of the picture that the camera spans.
const DEGREES_PER_HEIGHT: f64 = 180.0;
/// The zoom speed of the wheel: the logarithm of the factor per point of scrolling.
const ZOOM_PER_POINT: f64 = 0.0025;
/// The maximum distance at which a finger grabs a handle, in points.
const FINGER: f32 = 24.0;
/// The maximum distance from the pointer to a vertex whose faces are highlighted, in points.
const NEAR_VERTEX: f32 = 12.0;

/// The size available to the picture, and to one of its panes, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    pub whole: [u32; 2],
    pub pane: [u32; 2],
}

/// Shows the picture, or the panes of a comparison, and handles the pointer's input.
pub fn picture_ui(
    ui: &Ui,
    session: &mut Session,
    window: &mut WindowState,
    course: &mut Course,
    requests: &mut Requests,
    engine: &mut Engine,
) -> Room {
    let whole = Place::of(ui);
    let response = ui.interact(whole.rect, focus::picture_id(), Sense::click_and_drag());
    let mode = session.shown.scene.shading.mode.label();
    let name = text!("picture-name", mode = mode);
    let response = focus::named(response, Role::Image, &name);
    keep_arrows(ui, &response);
    if window.embedded.is_some() {
        hold(&response, Held::Figure);
    }
    if response.is_pointer_button_down_on()
        && ui.input(InputState::any_touches)
        && !course.asks_point()
    {
        allow_rest(ui.ctx());
    }
    let panes = panes::places(session, whole);
    let place = pointed(ui, session, window, &response, &panes).unwrap_or(whole);
    let view = View::new(&session.shown.scene.camera, place.size);
    let pointed = Pointed {
        whole,
        place,
        view,
        grips: handles::grips(session, window, course, &view, place),
        side_view: engine.side_view(),
        reach: reach(ui),
    };
    gesture(ui, session, window, course, requests, &response, &pointed);
    menu::menu_ui(&response, session, window, requests, engine);
    session.commit();
    window.covered = handles::covered(session, window, &view, place);
    let smooth = window.appearance.smooth_edges && !profile::shows_perceived(window);
    engine.update(ui.ctx(), session, window, place.size, smooth);
    // Highlights the faces of the vertex under the pointer, if normals are shown.
    let reach = f64::from(NEAR_VERTEX * place.pixels_per_point);
    let pointer = response.hover_pos().filter(|_| window.drag.is_none());
    let near = pointer.map(|at| (place.pixel(at), reach));
    let clicked = response.clicked() && !response.double_clicked();
    engine.point_at(ui.ctx(), session, window, near, clicked);
    course::watch_edges(window, course, engine);
    if ui.ctx().has_accesskit_node(response.id) {
        let Described { picture, probe, .. } = described(session, window, engine);
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_description(picture);
            node.set_value(probe);
            node.set_live(Live::Polite);
        });
    }
    let panes = panes::places(session, whole);
    let active = panes.iter().find(|pane| pane.pane == session.panes.active);
    if let Some(active) = active {
        profile::watch(ui.ctx(), window, active.place, response.hover_pos());
    }
    for pane in &panes {
        paint_picture(ui, session, window, engine, pane);
    }
    for pane in panes
        .iter()
        .filter(|pane| panes::is_overlaid(session, pane.pane))
    {
        paint_over(ui, session, window, course, engine, pane.place, pane.pane);
    }
    let panes = (&panes[..], whole);
    panes::captions_ui(ui, session, window, course, requests, engine, panes);
    Room {
        whole: whole.size,
        pane: place.size,
    }
}

/// Returns the place of the pane under the pointer, or of the active pane during a drag. A press activates a
/// pane.
fn pointed(
    ui: &Ui,
    session: &mut Session,
    window: &WindowState,
    response: &Response,
    panes: &[PanePlace],
) -> Option<Place> {
    let pressed =
        response.is_pointer_button_down_on() && ui.input(|input| input.pointer.any_pressed());
    let origin = ui
        .input(|input| input.pointer.press_origin())
        .filter(|_| pressed);
    if let Some(at) = origin
        && !panes::on_wipe(session, panes, at, reach(ui))
        && let Some(pane) = panes::pane_at(panes, session.panes.active, at)
    {
        session.activate(pane.pane);
    }
    let hover = response.hover_pos().filter(|_| window.drag.is_none());
    let hovered = hover.and_then(|at| panes::pane_at(panes, session.panes.active, at));
    let active = || {
        panes
            .iter()
            .find(|pane| pane.pane == session.panes.active)
            .or(panes.first())
            .copied()
    };
    hovered.or_else(active).map(|pane| pane.place)
}

/// Reserves the arrow keys for the probe while the picture has the focus.
fn keep_arrows(ui: &Ui, response: &Response) {
    if response.clicked() || response.drag_started() {
        response.request_focus();
    }
    if response.has_focus() {
        let filter = EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    }
}

/// The pane that the pointer refers to, with its handles.
struct Pointed {
    /// The place of all panes together.
    whole: Place,
    place: Place,
    view: View,
    grips: Vec<(Grip, Pos2)>,
    /// The pane of the side view, in the active pane's pixels.
    side_view: Option<Area>,
    /// The maximum distance at which the pointer grabs a handle, in points.
    reach: f32,
}

/// Returns the maximum grabbing distance in points: a finger covers more than a pointer.
fn reach(ui: &Ui) -> f32 {
    if ui.input(InputState::any_touches) {
        FINGER
    } else {
        handles::REACH
    }
}

impl Pointed {
    fn is_in_side_view(&self, at: Pos2) -> bool {
        let at = self.place.pixel(at);
        self.side_view.is_some_and(|pane| pane.contains(at))
    }

    /// Returns the handle that a drag from `at` would move, and the offset from `at` to its centre, in
    /// pixels. Handles that belong to tabs take precedence over lights and vertices, these over the probe.
    fn under(&self, session: &Session, course: &Course, at: Pos2) -> (Grip, DVec2) {
        let rank = |grip: &Grip| match grip {
            Grip::Mark => -1,
            Grip::LineEnd(_) => 0,
            Grip::Roll => 1,
            Grip::Probe => 3,
            _ => 2,
        };
        let near = self
            .grips
            .iter()
            .filter(|(_, there)| there.distance(at) <= self.reach);
        let nearest = near.min_by(|(a, place_a), (b, place_b)| {
            rank(a)
                .cmp(&rank(b))
                .then(place_a.distance(at).total_cmp(&place_b.distance(at)))
        });
        match nearest {
            Some((grip, there)) => (*grip, self.place.pixel(*there) - self.place.pixel(at)),
            None if self.is_in_side_view(at) => (Grip::SideView, DVec2::ZERO),
            None if panes::on_wipe(
                session,
                &panes::places(session, self.place),
                at,
                self.reach,
            ) =>
            {
                (Grip::Wipe, DVec2::ZERO)
            }
            None if course.asks_point() => (Grip::Mark, DVec2::ZERO),
            None => (Grip::Camera, DVec2::ZERO),
        }
    }
}

fn gesture(
    ui: &Ui,
    session: &mut Session,
    window: &mut WindowState,
    course: &mut Course,
    requests: &mut Requests,
    response: &Response,
    pointed: &Pointed,
) {
    let (whole, place) = (pointed.whole, pointed.place);
    if let Some(fingers) = ui.input(InputState::multi_touch) {
        // Two fingers move the camera, whatever the first of them had grabbed.
        window.drag = None;
        if whole.rect.contains(fingers.start_pos) {
            let camera = &mut session.shown.scene.camera;
            let span = camera.span(place.size.map(f64::from)).max(1.0);
            let [dx, dy] = <[f32; 2]>::from(fingers.translation_delta * place.pixels_per_point);
            let way = DVec2::new(-f64::from(dx), f64::from(dy)) / span;
            if window.embedded.is_some() {
                // In a figure one finger may belong to the page around it.
                turn(camera, way);
            } else {
                orbit::pan(camera, way.x, way.y);
            }
            requests.ask(Action::Zoom(1.0 / f64::from(fingers.zoom_delta)));
        }
        return;
    }
    let shift = ui.input(|input| input.modifiers.shift);
    if response.drag_started() {
        let at = ui
            .input(|input| input.pointer.press_origin())
            .unwrap_or(place.rect.center());
        let middle = response.dragged_by(PointerButton::Middle)
            || response.dragged_by(PointerButton::Secondary);
        let (grip, grab) = pointed.under(session, course, at);
        let start = match grip {
            Grip::Light(index) => handles::start(&session.shown.scene, index, &pointed.view, place),
            _ => LightStart::default(),
        };
        window.drag = Some(Drag {
            grip,
            grab,
            start,
            deep: shift || (middle && grip == Grip::Camera),
        });
        choose(session, grip);
    }
    if let Some(at) = response.interact_pointer_pos() {
        if response.dragged() {
            drag(session, window, course, response, at, pointed);
            ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
        }
        if response.long_touched() {
            put_probe(window, place, at);
        }
        if response.secondary_clicked() && !course.asks_point() {
            menu::open(window, pointed.under(session, course, at).0, at, place);
        } else if response.clicked() && course.asks_point() {
            course.put_mark(from_pixel(place.pixel(at), place.size));
        } else if response.clicked() {
            match pointed.under(session, course, at).0 {
                Grip::Camera => put_probe(window, place, at),
                Grip::SideView => window.appearance.overlay.side_view_enlarged ^= true,
                grip => choose(session, grip),
            }
        }
    }
    if response.drag_stopped() {
        window.drag = None;
    }
    let Some(at) = response.hover_pos() else {
        return;
    };
    let (grip, _) = pointed.under(session, course, at);
    if !response.dragged() {
        ui.ctx().set_cursor_icon(cursor(grip, shift));
    }
    let (scroll, pinch) = ui.input(|input| {
        (
            f64::from(input.smooth_scroll_delta().y),
            f64::from(input.zoom_delta()),
        )
    });
    if scroll != 0.0 || pinch != 1.0 {
        let factor = (-scroll * ZOOM_PER_POINT).exp() / pinch;
        match grip {
            Grip::Light(index) => {
                handles::scale_light(&mut session.shown.scene, index, &pointed.view, factor);
            }
            _ => requests.ask(Action::Zoom(factor)),
        }
    }
}

/// Shows the controls of a light or a vertex.
fn choose(session: &mut Session, grip: Grip) {
    match grip {
        Grip::Light(index) => session.light = index,
        Grip::Vertex(vertex) => session.vertex = vertex as usize,
        _ => {}
    }
}

fn put_probe(window: &mut WindowState, place: Place, at: Pos2) {
    let pixel = place.pixel(at);
    let inside = |value: f64, side: u32| value.clamp(0.0, f64::from(side.saturating_sub(1))) as u32;
    let [width, height] = place.size;
    let pixel = [inside(pixel.x, width), inside(pixel.y, height)];
    window.probe = ProbePoint::at(pixel, place.size);
}

/// Turns the camera by `way`, a fraction of the picture's span: the point under the pointer follows it, however the picture
/// is rolled.
fn turn(camera: &mut Camera, way: DVec2) {
    let way = View::without_roll(way * DEGREES_PER_HEIGHT, camera.roll);
    orbit::orbit(camera, way.x, way.y);
}

fn drag(
    session: &mut Session,
    window: &mut WindowState,
    course: &mut Course,
    response: &Response,
    at: Pos2,
    pointed: &Pointed,
) {
    let Some(Drag {
        grip,
        grab,
        deep,
        start,
    }) = window.drag
    else {
        return;
    };
    let Pointed {
        whole, place, view, ..
    } = pointed;
    let pixel = place.pixel(at) + grab;
    let scene = &mut session.shown.scene;
    let span = scene.camera.span(place.size.map(f64::from)).max(1.0);
    let delta = response.drag_delta() * place.pixels_per_point;
    let (dx, dy) = (f64::from(delta.x) / span, f64::from(delta.y) / span);
    match grip {
        Grip::Camera if deep => orbit::pan(&mut scene.camera, -dx, dy),
        Grip::Camera => turn(&mut scene.camera, DVec2::new(-dx, dy)),
        Grip::SideView => {}
        Grip::Probe => put_probe(window, *place, at),
        Grip::Mark => course.put_mark(from_pixel(pixel, place.size)),
        Grip::Wipe => {
            let share = whole.pixel(at).x / f64::from(whole.size[0].max(1));
            let share = (share.clamp(0.0, 1.0) * 1000.0).round() / 1000.0;
            session.edit(|scene, _| scene.compare.wipe = share);
        }
        Grip::Roll => handles::turn_to(session, window, *place, at),
        Grip::LineEnd(end) => window.line.put(end, pixel, place.size),
        Grip::Light(index) if deep => handles::scale_light(scene, index, view, (-dy * 2.0).exp()),
        Grip::Light(index) => handles::drag_light(scene, index, view, &start, pixel),
        Grip::Vertex(vertex) if deep => handles::push_vertex(scene, vertex, view, -dy * 2.0),
        Grip::Vertex(vertex) => handles::drag_vertex(&mut scene.object, vertex, view, pixel),
        Grip::Aim { front } => handles::aim_at(scene, session.light, view, pixel, front),
        Grip::Rim(_) => handles::open_to(scene, session.light, view, pixel),
    }
}

fn cursor(grip: Grip, shift: bool) -> CursorIcon {
    match grip {
        Grip::Light(_) | Grip::Vertex(_) if shift => CursorIcon::ResizeVertical,
        Grip::Light(_) | Grip::Vertex(_) | Grip::Aim { .. } | Grip::LineEnd(_) | Grip::Roll => {
            CursorIcon::Grab
        }
        Grip::Rim(way) => handles::cursor(way),
        Grip::Probe | Grip::Mark => CursorIcon::Crosshair,
        Grip::Wipe => CursorIcon::ResizeHorizontal,
        Grip::SideView => CursorIcon::ZoomIn,
        Grip::Camera if shift => CursorIcon::Move,
        Grip::Camera => CursorIcon::AllScroll,
    }
}

/// The texture coordinates of a whole texture.
const WHOLE: Rect = Rect {
    min: Pos2::ZERO,
    max: pos2(1.0, 1.0),
};

fn paint_picture(
    ui: &Ui,
    session: &Session,
    window: &WindowState,
    engine: &Engine,
    pane: &PanePlace,
) {
    let painter = ui.painter().with_clip_rect(pane.seen);
    let place = pane.place;
    if let Some(texture) = engine.picture(pane.pane) {
        painter.image(texture.id(), place.rect, WHOLE, Color32::WHITE);
    }
    if pane.pane != session.panes.active || !profile::shows_perceived(window) {
        return;
    }
    let Some(profiles) = window.own.get::<Profiles>() else {
        return;
    };
    if let Some(texture) = &profiles.perceived {
        // A picture of another size keeps its own shape until the next one is ready.
        let [width, height] = texture.size();
        let size = vec2(width as f32, height as f32);
        let scale = (place.rect.size() / size).min_elem();
        let rect = Rect::from_center_size(place.rect.center(), size * scale);
        painter.rect_filled(place.rect, 0.0, ui.visuals().extreme_bg_color);
        painter.image(texture.id(), rect, WHOLE, Color32::WHITE);
    }
    if profiles.is_perceiving() {
        let font = TextStyle::Body.resolve(ui.style());
        let at = place.rect.center_top() + vec2(0.0, 10.0);
        let (align, text) = (Align2::CENTER_TOP, text!("picture-drawing"));
        letter(&painter, at, align, text, &font, Color32::WHITE);
    }
}

/// Draws the overlays of a pane's picture.
fn paint_over(
    ui: &Ui,
    session: &Session,
    window: &WindowState,
    course: &Course,
    engine: &Engine,
    place: Place,
    pane: usize,
) {
    let painter = ui.painter().with_clip_rect(place.rect);
    let font = TextStyle::Body.resolve(ui.style());
    let active = pane == session.panes.active;
    for texture in engine.overlays().into_iter().flatten().filter(|_| active) {
        painter.image(texture.id(), place.rect, WHOLE, Color32::WHITE);
    }
    let view = View::new(&session.shown.scene.camera, place.size);
    if window.appearance.overlay.vectors || course.shows_probe() {
        // A ring round the probed pixel, light on dark, so that it is visible on any picture.
        let at = place.point(window.probe.centre(place.size));
        let held = window.drag.is_some_and(|drag| drag.grip == Grip::Probe);
        let radius = if held { 8.0 } else { 6.0 };
        painter.circle_stroke(at, radius, Stroke::new(2.6, Color32::from_black_alpha(130)));
        painter.circle_stroke(at, radius, Stroke::new(1.0, Color32::WHITE));
    }
    if active {
        course::paint_edges(&painter, window, course, &view, place);
    }
    handles::paint_below(&painter, session, window, &view, place, active);
    if active {
        defects::paint(&painter, session, window, place, &font);
    }
    if handles::visible(ui.ctx(), window, place) {
        let pointer = ui.input(|input| input.pointer.hover_pos());
        handles::paint_vertices(&painter, session, window, &view, place, pointer);
    }
    scan::paint(&painter, window, place);
    handles::paint(&painter, session, window, &view, place);
    if active {
        course::paint(&painter, course, place, &font);
    }
}
