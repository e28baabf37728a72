//! The lights' handles in the picture: their positions, their appearance, and dragging.
//!
//! A light keeps its distance while it is dragged: it moves on the sphere through it about the object's
//! centre, and dragged past the sphere's rim it moves to the other side. A directional light has no position,
//! and a light behind the viewer or outside the picture none that is seen: the handle of either slides on a sphere
//! in the picture, in the direction of the light, filled on the side that faces the viewer, hollow on the other.

use super::beam::{self, MARGIN, on_sphere};
use crate::app::session::Session;
use crate::app::session::place::{Place, tidy};
use crate::app::session::window::{Grip, LightStart, WindowState};
use crate::app::widgets::letter::letter;
use crate::app::widgets::lines::{area, exact, line, outline};
use crate::app::widgets::palette;
use crate::app::widgets::swatch::display_colour;
use crate::app::widgets::theme::TEXT;
use crate::figure::palette::Vector;
use crate::figure::{Area, Placer, Wish};
use crate::scene::{CompareView, Light, LightKind, ObjectKind, Scene, View};
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2, pos2, vec2};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;
use std::ops::RangeInclusive;

/// The radius of the sphere on which the handles of directional and of far lights slide, as a fraction of the picture's
/// shorter side at the depth of its centre.
const SPHERE: f64 = 0.42;
/// The radius of a handle, in points.
const RADIUS: f32 = 8.0;
/// The maximum distance at which the pointer grabs a handle, in points.
pub const REACH: f32 = 14.0;
/// The height of a pane's caption, in points.
const CAPTION: f32 = 34.0;
/// The width of the figures of a difference, in points.
const FIGURES: f32 = 300.0;
/// The number of points of the outline of a sphere.
const ROUND: u32 = 96;
/// The distances from the object's centre to which lights can be moved by hand, in world units.
const DISTANCES: RangeInclusive<f64> = 1e-3..=1e6;

/// The marker that represents a light in the picture.
#[derive(Clone, Copy)]
enum Marker {
    /// A light with a position in the picture.
    Point,
    /// A directional light; `front` if it is on the viewer's side of the sphere.
    Directional { front: bool },
    /// A light outside the picture, likewise on the sphere, with the unit vector that points to it.
    Far { front: bool, way: Vec2 },
}

/// Returns the centre of the object, about which lights are dragged: that of the unit sphere, or of the
/// scene's own polygons. If it is behind the viewer, or for a model at its file's own position, returns the
/// camera's target.
fn middle(scene: &Scene, view: &View) -> DVec3 {
    let object = &scene.object;
    let own = match object.kind {
        ObjectKind::Obj if !object.fit => scene.camera.target,
        ObjectKind::Polygons => {
            let vertices = object.polygons().vertices;
            let ends = vertices
                .iter()
                .copied()
                .fold(None, |ends: Option<[DVec3; 2]>, at| {
                    Some(ends.map_or([at; 2], |[low, high]| [low.min(at), high.max(at)]))
                });
            ends.map_or(DVec3::ZERO, |[low, high]| 0.5 * low + 0.5 * high)
        }
        _ => DVec3::ZERO,
    };
    if view.project(own).is_some() {
        own
    } else {
        scene.camera.target
    }
}

/// Draws the line from the light that is dragged or pointed at to the object's centre.
pub fn paint_stem(
    painter: &Painter,
    session: &Session,
    window: &WindowState,
    view: &View,
    place: Place,
) {
    let scene = &session.shown.scene;
    let middle = middle(scene, view);
    let pointer = painter.ctx().input(|input| input.pointer.hover_pos());
    let near = |at: Pos2| pointer.is_some_and(|pointer| pointer.distance(at) <= REACH);
    let Some((foot, _)) = view.project(middle) else {
        return;
    };
    for (index, light) in scene.lights.iter().enumerate() {
        let (at, marker) = marker(light, view, middle, place, held_far(window, index));
        let dragged = window.drag.map(|drag| drag.grip == Grip::Light(index));
        if dragged == Some(true) {
            let radius = match marker {
                Marker::Point => light.position.distance(middle),
                Marker::Directional { .. } | Marker::Far { .. } => sphere_radius(view, middle),
            };
            paint_arc(painter, view, place, middle, radius);
        }
        if dragged.unwrap_or_else(|| near(at)) {
            let ends = [exact(at), place.exact_point(foot)];
            for (width, colour) in [
                (3.5, Color32::from_black_alpha(110)),
                (1.2, palette::vector(Vector::L)),
            ] {
                line(painter, ends, Stroke::new(width, colour), &[]);
            }
            painter.circle_filled(place.point(foot), 2.5, palette::vector(Vector::L));
        }
    }
}

/// Draws the outline of the sphere on which a light is dragged.
fn paint_arc(painter: &Painter, view: &View, place: Place, middle: DVec3, radius: f64) {
    let points = (0..ROUND).map(|k| {
        let (sine, cosine) = (f64::from(k) / f64::from(ROUND) * TAU).sin_cos();
        let at = middle + (view.right * cosine + view.up * sine) * radius;
        place.exact_seen(view, at)
    });
    if let Some(points) = points.collect::<Option<Vec<_>>>() {
        for (width, colour) in [
            (3.0, Color32::from_black_alpha(90)),
            (1.0, palette::vector(Vector::L).gamma_multiply(0.7)),
        ] {
            outline(painter, &points, Stroke::new(width, colour));
        }
    }
}

/// Returns whether light `index` is being dragged from outside the picture. Its handle stays on the sphere meanwhile.
fn held_far(window: &WindowState, index: usize) -> bool {
    window
        .drag
        .is_some_and(|drag| drag.grip == Grip::Light(index) && !drag.start.in_picture)
}

/// Draws the lights' handles; the chosen light is emphasised, and lights that are off look unlit.
pub fn paint(
    painter: &Painter,
    session: &Session,
    window: &WindowState,
    view: &View,
    place: Place,
) {
    let scene = &session.shown.scene;
    let (middle, soloing) = (middle(scene, view), scene.soloing());
    let lights = scene.lights.iter().enumerate();
    let markers: Vec<(Pos2, Marker)> = lights
        .map(|(index, light)| marker(light, view, middle, place, held_far(window, index)))
        .collect();
    for (index, (light, (at, marker))) in scene.lights.iter().zip(&markers).enumerate() {
        let colour = light.shines(soloing).then(|| display_colour(light.color));
        paint_light(painter, *at, *marker, colour, index == session.light);
    }
    if let Some(beam) = beam::chosen(session, view) {
        beam.paint_grips(painter, view, place);
    }
    let foot = place.exact_seen(view, middle);
    paint_numbers(painter, session, place, &markers, foot);
}

impl Marker {
    /// Returns the direction and the distance of the light's number from its handle at `at`, clear of the
    /// line to the object's centre, which is at `foot`.
    fn number(self, at: Pos2, foot: Option<DVec2>) -> (Vec2, f32) {
        let away = foot
            .and_then(|foot| (exact(at) - foot).try_normalize())
            .map_or(vec2(0.0, 1.0), |away| vec2(away.x as f32, away.y as f32));
        match self {
            Self::Point => (away, RADIUS + 2.0),
            Self::Directional { .. } => (away, RADIUS + 7.0),
            Self::Far { .. } => (away, RADIUS + 14.0),
        }
    }
}

/// Returns the area that each handle covers with its number, in points.
pub fn covered(scene: &Scene, view: &View, place: Place) -> Vec<Area> {
    let middle = middle(scene, view);
    let foot = place.exact_seen(view, middle);
    let covered = |light| {
        let (at, marker) = marker(light, view, middle, place, false);
        let (way, clearance) = marker.number(at, foot);
        let handle = Rect::from_center_size(at, Vec2::splat(2.0 * RADIUS + 4.0));
        let number = Rect::from_center_size(at + way * (clearance + TEXT * 0.6), vec2(20.0, TEXT));
        area(handle.union(number))
    };
    scene.lights.iter().map(covered).collect()
}

/// Returns the areas that the captions of panes cover, in points.
pub fn captions(session: &Session, place: Place) -> Vec<Area> {
    let (rect, view) = (place.rect, session.document().scene.compare.view);
    if view == CompareView::Single {
        return Vec::new();
    }
    let size = vec2(0.6 * rect.width(), CAPTION);
    let top = match view {
        // The figures are longer, and in a narrow picture they are below the names.
        CompareView::Difference => vec2(rect.width().min(FIGURES), 1.6 * CAPTION),
        _ => size,
    };
    let bottom = rect.left_bottom() - vec2(0.0, CAPTION);
    let mut covered = vec![
        Rect::from_min_size(rect.min, top),
        Rect::from_min_size(bottom, size),
    ];
    if view == CompareView::Wipe {
        let size = vec2(0.3 * rect.width(), CAPTION);
        let right = rect.right_top() - vec2(size.x, 0.0);
        covered.push(Rect::from_min_size(right, size));
    }
    covered.into_iter().map(area).collect()
}

/// Writes the lights' numbers beside their handles, inside the picture, without overlap with one another or
/// with the captions of panes.
fn paint_numbers(
    painter: &Painter,
    session: &Session,
    place: Place,
    markers: &[(Pos2, Marker)],
    foot: Option<DVec2>,
) {
    let mut taken: Vec<Area> = markers
        .iter()
        .map(|(at, _)| area(Rect::from_center_size(*at, Vec2::splat(2.0 * RADIUS))))
        .collect();
    taken.extend(captions(session, place));
    let orange = palette::readable(palette::vector(Vector::L), Color32::BLACK);
    let mut placer = Placer::new(area(place.rect.shrink(2.0)), f64::from(TEXT), &[], taken);
    for (index, (at, marker)) in markers.iter().enumerate() {
        let font = FontId::proportional(if index == session.light { 15.0 } else { 14.0 });
        let text = format!("L{}", index + 1);
        let size = painter
            .layout_no_wrap(text.clone(), font.clone(), orange)
            .size();
        let (direction, clearance) = marker.number(*at, foot);
        let wish = Wish {
            anchor: exact(*at),
            direction: DVec2::new(f64::from(direction.x), f64::from(direction.y)),
            size: DVec2::new(f64::from(size.x), f64::from(size.y)),
            clearance: f64::from(clearance),
        };
        if let Some(room) = placer.place(&wish) {
            let [x, y] = room.centre().to_array().map(|place| place as f32);
            let (at, align) = (pos2(x, y), Align2::CENTER_CENTER);
            letter(painter, at, align, &text, &font, orange);
        }
    }
}

/// Returns the offset from the object's centre towards a light.
fn offset(light: &Light, middle: DVec3) -> DVec3 {
    if light.kind == LightKind::Directional {
        -light.direction
    } else {
        light.position - middle
    }
}

/// Returns the positions of the lights' handles.
pub fn places(scene: &Scene, view: &View, place: Place) -> Vec<Pos2> {
    let middle = middle(scene, view);
    let at = |light| marker(light, view, middle, place, false).0;
    scene.lights.iter().map(at).collect()
}

/// Returns the position and the marker of a light's handle; a `far` light's is on the sphere wherever it is.
fn marker(light: &Light, view: &View, middle: DVec3, place: Place, far: bool) -> (Pos2, Marker) {
    let inner = place.rect.shrink(MARGIN * 0.5);
    let directional = light.kind == LightKind::Directional;
    if !directional && !far {
        let at = place.seen(view, light.position);
        if let Some(at) = at.filter(|at| inner.contains(*at)) {
            return (at, Marker::Point);
        }
    }
    let towards = offset(light, middle).normalize_or(DVec3::Y);
    let handle = place.seen(view, middle + towards * sphere_radius(view, middle));
    let at = handle.unwrap_or(place.rect.center());
    let at = at.max(inner.min).min(inner.max);
    let front = towards.dot(view.forward) <= 0.0;
    if directional {
        return (at, Marker::Directional { front });
    }
    let way = place
        .seen(view, middle)
        .map_or(Vec2::ZERO, |foot| at - foot);
    let way = if way.length() > 1.0 {
        way.normalized()
    } else {
        vec2(0.0, -1.0)
    };
    (at, Marker::Far { front, way })
}

/// Returns `light` moved, or turned if it is directional, so that it is seen at `pixel`: halfway between the viewer and the
/// camera's target, so that the target is lit.
pub fn put_light(light: Light, scene: &Scene, view: &View, pixel: DVec2) -> Light {
    let depth = 0.5 * scene.camera.distance();
    let position = tidy(view.unproject(pixel, depth), view.world_per_pixel(depth));
    if light.kind == LightKind::Directional {
        Light {
            direction: middle(scene, view) - position,
            ..light
        }
    } else {
        Light { position, ..light }
    }
}

/// Returns `light` moved, or turned if it is directional, so that its handle is as far as possible from those
/// of the scene's lights: in the upper part of the picture and halfway between the viewer and the camera's
/// target, so that the target is lit.
pub fn apart(light: Light, scene: &Scene, size: [u32; 2]) -> Light {
    let Scene { lights, camera, .. } = scene;
    let view = View::new(camera, size);
    let middle = middle(scene, &view);
    let [width, height] = size.map(f64::from);
    let rect = Rect::from_min_size(Pos2::ZERO, vec2(width as f32, height as f32));
    let place = Place {
        rect,
        size,
        pixels_per_point: 1.0,
    };
    let handle = |light: &Light| marker(light, &view, middle, place, false).0;
    let taken: Vec<Pos2> = lights.iter().map(handle).collect();
    let moved = |pixel: DVec2| put_light(light.clone(), scene, &view, pixel);
    // More positions than lights, so that some are free.
    let count = 4 + (f64::from(u32::try_from(lights.len()).unwrap_or(u32::MAX))).sqrt() as u32;
    let share = |index: u32| (f64::from(index) + 0.5) / f64::from(count);
    let places = (0..count * count).map(|index| {
        DVec2::new(
            width * (0.1 + 0.8 * share(index % count)),
            height * (0.1 + 0.5 * share(index / count)),
        )
    });
    let room = |light: &Light| {
        taken
            .iter()
            .map(|at| at.distance(handle(light)))
            .fold(f32::INFINITY, f32::min)
    };
    let found = places.map(moved).min_by(|a, b| room(b).total_cmp(&room(a)));
    found
        .filter(|light| light.position.is_finite() && light.direction.is_finite())
        .unwrap_or(light.clone())
}

fn sphere_radius(view: &View, middle: DVec3) -> f64 {
    let depth = (middle - view.eye).dot(view.forward);
    SPHERE * 2.0 * view.centre.min_element() * view.world_per_pixel(depth)
}

/// Returns the state of light `index` at the start of a drag.
pub fn start(scene: &Scene, index: usize, view: &View, place: Place) -> LightStart {
    let middle = middle(scene, view);
    let Some(light) = scene.lights.get(index) else {
        return LightStart::default();
    };
    let (at, marker) = marker(light, view, middle, place, false);
    LightStart {
        offset: offset(light, middle),
        pixel: place.pixel(at),
        in_picture: matches!(marker, Marker::Point),
    }
}

/// Moves light `index` about the object's centre so that its handle is at `pixel`. The light keeps the
/// distance at which the drag began, and its side of the object or, past the sphere's rim, changes to the
/// other.
pub fn drag_light(scene: &mut Scene, index: usize, view: &View, start: &LightStart, pixel: DVec2) {
    let middle = middle(scene, view);
    let Some(light) = scene.lights.get_mut(index) else {
        return;
    };
    let front = start.offset.dot(view.forward) < 0.0;
    let reach = start.offset.length();
    let radius = if start.in_picture {
        reach
    } else {
        sphere_radius(view, middle)
    };
    let way = on_sphere(view, pixel, middle, radius, front);
    if !way.is_finite() || way.length() < 0.5 {
        return;
    }
    if light.kind == LightKind::Directional {
        light.direction = tidy(-way, 1e-3);
    } else if (middle + way * reach).is_finite() {
        light.position = tidy(middle + way * reach, reach * 1e-3);
    }
}

/// Multiplies the distance of light `index` from the object's centre. Does nothing for a directional light.
pub fn scale_light(scene: &mut Scene, index: usize, view: &View, factor: f64) {
    let middle = middle(scene, view);
    let Some(light) = scene
        .lights
        .get_mut(index)
        .filter(|light| light.kind.has_position())
    else {
        return;
    };
    let offset = (light.position - middle) * factor;
    let moved = middle + offset;
    if moved.is_finite() && DISTANCES.contains(&offset.length()) {
        light.position = tidy(moved, offset.length() * 1e-3);
    }
}

/// Draws a handle; without a `colour`, the light is off, and the handle is hollow and crossed.
fn paint_light(painter: &Painter, at: Pos2, marker: Marker, colour: Option<Color32>, chosen: bool) {
    let orange = palette::vector(Vector::L);
    let rim = colour.map_or(Color32::from_gray(175), |_| orange);
    let ring = if chosen {
        Stroke::new(2.5, rim)
    } else {
        Stroke::new(1.5, rim.gamma_multiply(0.8))
    };
    let halo = Stroke::new(ring.width + 2.5, Color32::from_black_alpha(150));
    let hollow = Color32::from_black_alpha(120);
    let fill = colour.unwrap_or(hollow);
    match marker {
        Marker::Point => {
            painter.circle_stroke(at, RADIUS, halo);
            painter.circle(at, RADIUS, fill, ring);
        }
        Marker::Directional { front } => {
            // The rays of a sun.
            for stroke in [halo, ring] {
                for k in 0..8u8 {
                    let way = Vec2::angled(f32::from(k) * std::f32::consts::FRAC_PI_4);
                    painter.line_segment(
                        [at + way * (RADIUS + 1.5), at + way * (RADIUS + 6.0)],
                        stroke,
                    );
                }
            }
            painter.circle_stroke(at, RADIUS - 1.5, halo);
            let fill = if front { fill } else { hollow };
            painter.circle(at, RADIUS - 1.5, fill, ring);
        }
        Marker::Far { front, way } => {
            let (foot, side) = (at + way * (RADIUS + 3.0), way.rot90() * 5.5);
            let points = vec![at + way * (RADIUS + 12.0), foot + side, foot - side];
            painter.add(Shape::closed_line(points.clone(), halo));
            painter.add(Shape::convex_polygon(points, rim, Stroke::NONE));
            painter.circle_stroke(at, RADIUS - 1.5, halo);
            let fill = if front { fill } else { hollow };
            painter.circle(at, RADIUS - 1.5, fill, ring);
        }
    }
    if colour.is_none() {
        let across = vec2(RADIUS, -RADIUS) * 1.1;
        painter.line_segment([at - across, at + across], halo);
        painter.line_segment([at - across, at + across], Stroke::new(1.5, rim));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Camera;
    use eframe::egui::Pos2;

    const SIZE: [u32; 2] = [800, 600];

    fn place() -> Place {
        Place {
            rect: Rect::from_min_size(Pos2::ZERO, vec2(800.0, 600.0)),
            size: SIZE,
            pixels_per_point: 1.0,
        }
    }

    fn view() -> View {
        View::new(&Camera::default(), SIZE)
    }

    fn with(kind: LightKind, at: DVec3) -> Scene {
        let light = Light {
            kind,
            position: at,
            direction: -at,
            ..Light::default()
        };
        Scene {
            lights: vec![light],
            ..Scene::default()
        }
    }

    fn handle(scene: &Scene) -> DVec2 {
        place().pixel(places(scene, &view(), place())[0])
    }

    #[test]
    fn a_light_keeps_its_distance_and_follows_the_pointer() {
        for from in [DVec3::new(1.0, 0.6, 0.4), DVec3::new(-0.7, 0.9, -0.8)] {
            let mut scene = with(LightKind::Point, from);
            let start = start(&scene, 0, &view(), place());
            assert!(start.in_picture);
            for wanted in [[400.0, 300.0], [500.0, 250.0], [430.0, 400.0]].map(DVec2::from_array) {
                drag_light(&mut scene, 0, &view(), &start, wanted);
                let at = scene.lights[0].position;
                assert!((at.length() - from.length()).abs() < 2e-3, "{at}");
                assert!((handle(&scene) - wanted).length() < 2.0, "{wanted}");
                assert_eq!(at.z > 0.0, from.z > 0.0, "it stays on its side");
            }
            // Past the rim it moves to the other side, and comes back.
            drag_light(&mut scene, 0, &view(), &start, DVec2::new(760.0, 300.0));
            assert!((scene.lights[0].position.length() - from.length()).abs() < 2e-3);
            assert_eq!(scene.lights[0].position.z > 0.0, from.z < 0.0);
            drag_light(&mut scene, 0, &view(), &start, start.pixel);
            assert!((scene.lights[0].position - from).length() < 5e-3);
        }
    }

    #[test]
    fn a_directional_light_past_the_rim_goes_behind() {
        for side in [1.0, -1.0] {
            let mut scene = with(LightKind::Directional, DVec3::new(0.3, 0.2, side));
            let start = start(&scene, 0, &view(), place());
            let towards = |scene: &Scene| -scene.lights[0].direction.normalize();
            drag_light(&mut scene, 0, &view(), &start, DVec2::new(500.0, 250.0));
            assert!((handle(&scene) - DVec2::new(500.0, 250.0)).length() < 2.0);
            assert!(towards(&scene).z * side > 0.0, "{side}");
            drag_light(&mut scene, 0, &view(), &start, DVec2::new(790.0, 300.0));
            assert!(
                towards(&scene).z * side < -0.1,
                "{side}: {}",
                towards(&scene)
            );
        }
    }

    #[test]
    fn a_light_outside_the_picture_follows_the_pointer_at_its_distance() {
        let from = DVec3::new(2.4, 3.0, 3.2);
        let mut scene = with(LightKind::Point, from);
        let start = start(&scene, 0, &view(), place());
        assert!(!start.in_picture);
        drag_light(&mut scene, 0, &view(), &start, start.pixel);
        assert!((scene.lights[0].position - from).length() < 0.02, "no jump");
        for by in [[-113.0, 33.0], [12.0, -4.0], [-200.0, 120.0]].map(DVec2::from_array) {
            drag_light(&mut scene, 0, &view(), &start, start.pixel + by);
            let moved = handle(&scene) - start.pixel;
            assert!((moved - by).length() < 2.0, "{by} moved it {moved}");
            assert!((scene.lights[0].position.length() - from.length()).abs() < 0.02);
        }
        // Past the rim it moves to the other side, as a light in the picture does.
        let past = start.pixel + DVec2::new(150.0, -50.0);
        drag_light(&mut scene, 0, &view(), &start, past);
        assert!(scene.lights[0].position.z < 0.0);
        assert!((scene.lights[0].position.length() - from.length()).abs() < 0.02);
        drag_light(&mut scene, 0, &view(), &start, DVec2::new(400.0, 300.0));
        let at = scene.lights[0].position.normalize();
        assert!(at.z > 0.99, "the middle is towards the viewer: {at}");
    }

    #[test]
    fn the_distance_changes_along_the_same_direction_and_is_bounded() {
        let from = DVec3::new(1.0, 0.6, 0.4);
        let mut scene = with(LightKind::Point, from);
        scale_light(&mut scene, 0, &view(), 2.0);
        assert!((scene.lights[0].position - from * 2.0).length() < 0.01);
        (0..1000).for_each(|_| scale_light(&mut scene, 0, &view(), 0.5));
        let least = scene.lights[0].position.length();
        assert!((1e-4..1e-2).contains(&least), "{least}");
        (0..1000).for_each(|_| scale_light(&mut scene, 0, &view(), 2.0));
        assert!(scene.lights[0].position.length() <= 1e6);
        assert_eq!(scene.validate(), Ok(()));
    }
}
