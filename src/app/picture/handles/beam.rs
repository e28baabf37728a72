//! The beam of a spot or area light: its axis, its cone and its outline, drawn and dragged.
//!
//! The axis ends as far from the light as the camera's target is: if the light is aimed at the target, the
//! arrow's head is on it. The head slides on the sphere about the light with that radius, and the cone's edge
//! is a circle on the same sphere, so that even a cone as wide as a half-space has one. Dragged past the
//! sphere's outline, the head moves to the other side.

use crate::app::session::Session;
use crate::app::session::place::{Place, tidy};
use crate::app::session::window::Grip;
use crate::app::widgets::lines::{line, outline};
use crate::app::widgets::palette;
use crate::figure::palette::Vector;
use crate::illumination::rectangle_axes;
use crate::scene::{AreaShape, Light, LightKind, Scene, View};
use eframe::egui::{Color32, Painter, Pos2, Stroke, Vec2};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The distance of a marker from the picture's edge, in points.
pub const MARGIN: f32 = 22.0;
/// The radius of the handles of a light's axis and edge, in points.
const SMALL: f32 = 5.0;
/// The minimum length of the axis, in camera distances: even a light at the target can be turned.
const SHORTEST: f64 = 0.25;
/// The number of points of a round outline.
const ROUND: u32 = 48;
/// The sine of the angle between the axis and the viewing direction below which the cone's edge counts as
/// seen face on.
const FACE_ON: f64 = 0.3;

/// The axis of a light, with the shapes drawn about it.
#[derive(Clone, Copy, Debug)]
pub struct Beam<'a> {
    light: &'a Light,
    /// The unit direction in which the light shines.
    axis: DVec3,
    reach: f64,
    /// The unit vector across the axis, level in the picture, that points to the handle of the cone's edge.
    aside: DVec3,
}

impl<'a> Beam<'a> {
    /// Returns the beam of a light, if it has a position and a direction.
    pub fn of(light: &'a Light, view: &View, target: DVec3) -> Option<Self> {
        if !light.kind.has_position() || !light.has_direction() {
            return None;
        }
        let axis = light.direction.try_normalize()?;
        let aside = axis.cross(view.forward);
        let across = |v: DVec3| v - axis * v.dot(axis);
        let aside = if aside.length() > FACE_ON {
            aside
        } else {
            across(view.right)
        };
        let reach = (target - light.position)
            .length()
            .max(SHORTEST * (target - view.eye).length());
        let aside = aside.try_normalize().unwrap_or(view.up);
        reach.is_finite().then_some(Self {
            light,
            axis,
            reach,
            aside,
        })
    }

    fn head(&self) -> DVec3 {
        self.light.position + self.axis * self.reach
    }

    /// Returns a point of the cone's edge, `turn` radians round the axis from the handle.
    fn edge(&self, turn: f64) -> DVec3 {
        let (sine, cosine) = self.light.cone.to_radians().sin_cos();
        let around = self.aside * turn.cos() + self.axis.cross(self.aside) * turn.sin();
        self.light.position + (self.axis * cosine + around * sine) * self.reach
    }

    /// Returns the visible handles: that of the axis, and that of a cone's edge.
    pub fn grips(&self, view: &View, place: Place) -> Vec<(Grip, Pos2)> {
        let inner = place.rect.shrink(MARGIN * 0.5);
        let seen = |world: DVec3| place.seen(view, world);
        let Some(head) = seen(self.head()) else {
            return vec![];
        };
        let mut grips = vec![(
            Grip::Aim {
                front: self.axis.dot(view.forward) < 0.0,
            },
            head,
        )];
        if let Some(edge) = seen(self.edge(0.0)).filter(|_| self.light.kind == LightKind::Spot) {
            grips.push((Grip::Rim((edge - head).normalized()), edge));
        }
        grips.retain(|(_, at)| inner.contains(*at));
        grips
    }

    /// Draws the visible handles.
    pub fn paint_grips(&self, painter: &Painter, view: &View, place: Place) {
        let halo = Stroke::new(4.0, Color32::from_black_alpha(150));
        let rim = Stroke::new(1.0, Color32::BLACK);
        for (_, at) in self.grips(view, place) {
            painter.circle_stroke(at, SMALL, halo);
            painter.circle(at, SMALL, palette::vector(Vector::L), rim);
        }
    }

    /// Draws the axis and, faintly, the cone about it.
    fn paint(&self, painter: &Painter, view: &View, place: Place) {
        let seen = |world: DVec3| place.exact_seen(view, world);
        let orange = palette::vector(Vector::L);
        if let (Some(from), Some(to)) = (seen(self.light.position), seen(self.head())) {
            let way = (to - from).normalize_or_zero();
            let shaft = [from + way * 9.0, to - way * 6.0];
            let halo = Stroke::new(3.5, Color32::from_black_alpha(110));
            let stroke = Stroke::new(1.5, orange);
            line(painter, shaft, halo, &[]);
            line(painter, shaft, stroke, &[]);
            for side in [way.perp(), -way.perp()] {
                let barb = [to - way * 6.0, to - way * 15.0 + side * 5.0];
                line(painter, barb, stroke, &[]);
            }
        }
        if self.light.kind == LightKind::Spot {
            let faint = Stroke::new(1.0, orange.gamma_multiply(0.65));
            closed(painter, faint, round().map(|turn| seen(self.edge(turn))));
            for turn in [0.0, 0.5 * TAU] {
                if let (Some(from), Some(to)) = (seen(self.light.position), seen(self.edge(turn))) {
                    line(painter, [from, to], faint, &[]);
                }
            }
        }
    }
}

/// Returns the beam of the chosen light, if it has an axis.
pub fn chosen<'a>(session: &'a Session, view: &View) -> Option<Beam<'a>> {
    let scene = &session.shown.scene;
    scene
        .lights
        .get(session.light)
        .and_then(|light| Beam::of(light, view, scene.camera.target))
}

/// Draws the outline of every area light, and the beam of the chosen light.
pub fn paint(painter: &Painter, session: &Session, view: &View, place: Place) {
    let scene = &session.shown.scene;
    for (index, light) in scene
        .lights
        .iter()
        .enumerate()
        .filter(|(_, light)| light.kind == LightKind::Area)
    {
        let strength = if index == session.light { 1.0 } else { 0.5 };
        let stroke = Stroke::new(1.5, palette::vector(Vector::L).gamma_multiply(strength));
        area(painter, light, view, place, stroke);
    }
    if let Some(beam) = chosen(session, view) {
        beam.paint(painter, view, place);
    }
}

fn area(painter: &Painter, light: &Light, view: &View, place: Place, stroke: Stroke) {
    let points: Vec<DVec3> = match light.shape {
        AreaShape::Rectangle => {
            let [across, up] = rectangle_axes(light);
            [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]
                .map(|[u, v]| across * u + up * v)
                .to_vec()
        }
        AreaShape::Sphere => round()
            .map(|turn| (view.right * turn.cos() + view.up * turn.sin()) * light.radius)
            .collect(),
    };
    let seen = |offset: DVec3| place.exact_seen(view, light.position + offset);
    closed(painter, stroke, points.into_iter().map(seen));
}

/// Returns the angles of a full circle, in radians.
fn round() -> impl Iterator<Item = f64> {
    (0..ROUND).map(|k| f64::from(k) / f64::from(ROUND) * TAU)
}

/// Draws a closed line through points, if all of them are visible.
fn closed(painter: &Painter, stroke: Stroke, points: impl Iterator<Item = Option<DVec2>>) {
    if let Some(points) = points.collect::<Option<Vec<_>>>() {
        let halo = Stroke::new(stroke.width + 2.0, Color32::from_black_alpha(110));
        outline(painter, &points, halo);
        outline(painter, &points, stroke);
    }
}

/// Turns light `index` so that the head of its axis is at `pixel`, on the side of the light where the drag
/// began.
pub fn aim_at(scene: &mut Scene, index: usize, view: &View, pixel: DVec2, front: bool) {
    let Scene { lights, camera, .. } = scene;
    let (Some(light), target) = (lights.get_mut(index), camera.target) else {
        return;
    };
    let Some(Beam { reach, .. }) = Beam::of(light, view, target) else {
        return;
    };
    let direction = on_sphere(view, pixel, light.position, reach, front);
    if direction.is_finite() && direction.length() > 0.5 {
        light.direction = tidy(direction, 1e-3);
    }
}

/// Opens the cone of light `index` so that its edge passes through `pixel`.
pub fn open_to(scene: &mut Scene, index: usize, view: &View, pixel: DVec2) {
    let Scene { lights, camera, .. } = scene;
    let (Some(light), target) = (lights.get_mut(index), camera.target) else {
        return;
    };
    let Some(beam) = Beam::of(light, view, target) else {
        return;
    };
    let (origin, along) = view.ray(pixel);
    // Seen from the side, on the plane of the axis and the handle; seen face on, on the sphere.
    let normal = beam.axis.cross(beam.aside);
    let way = if beam.axis.cross(view.forward).length() > FACE_ON {
        origin + along * ((light.position - origin).dot(normal) / along.dot(normal))
            - light.position
    } else {
        let front = beam.axis.dot(view.forward) < 0.0;
        on_sphere(view, pixel, light.position, beam.reach, front)
    };
    let angle = way
        .cross(beam.axis)
        .length()
        .atan2(way.dot(beam.axis))
        .to_degrees();
    if angle.is_finite() {
        let (least, most) = (*Light::CONE.start(), *Light::CONE.end());
        light.cone = ((angle * 10.0).round() / 10.0).clamp(least, most);
    }
}

/// Returns the unit direction from `centre` to the point seen at `pixel` on the sphere of radius `reach`, on
/// the viewer's side if `front`, else on the far one. Outside the sphere's outline, the point is on the other
/// side, and the nearer to the middle of that side the farther away `pixel` is.
pub fn on_sphere(view: &View, pixel: DVec2, centre: DVec3, reach: f64, front: bool) -> DVec3 {
    let (origin, along) = view.ray(pixel);
    let nearest = (centre - origin).dot(along);
    let offset = origin + along * nearest - centre;
    let beside = offset.length() / reach;
    if beside < 1.0 {
        let half = (1.0 - beside * beside).sqrt() * reach;
        // A sphere that contains the eye is seen from inside, on its far side only.
        let side = if front && nearest > half { -1.0 } else { 1.0 };
        return ((offset + along * half * side) / reach).normalize_or_zero();
    }
    let angle = (beside - 1.0).min(1.0) * 0.25 * TAU;
    offset.normalize_or_zero() * angle.cos() + along * angle.sin() * if front { 1.0 } else { -1.0 }
}

/// Returns the cursor over a cone's edge: arrows across the edge.
pub fn cursor(way: Vec2) -> eframe::egui::CursorIcon {
    use eframe::egui::CursorIcon::{ResizeHorizontal, ResizeNeSw, ResizeNwSe, ResizeVertical};
    let icons = [ResizeHorizontal, ResizeNwSe, ResizeVertical, ResizeNeSw];
    let eighth = (way.angle() / std::f32::consts::FRAC_PI_4)
        .round()
        .rem_euclid(4.0);
    icons[eighth as usize % 4]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Camera;
    use eframe::egui::vec2;

    const SIZE: [u32; 2] = [800, 600];

    fn spot(direction: DVec3) -> Scene {
        let light = Light {
            kind: LightKind::Spot,
            position: DVec3::new(1.5, 1.0, 1.0),
            direction,
            ..Light::default()
        };
        Scene {
            lights: vec![light],
            ..Scene::default()
        }
    }

    /// Returns the pixels of the axis' head and of the edge's handle.
    fn seen(scene: &Scene, view: &View) -> [DVec2; 2] {
        let beam = Beam::of(&scene.lights[0], view, scene.camera.target).expect("a spot light");
        [beam.head(), beam.edge(0.0)].map(|at| view.project(at).expect("before the eye").0)
    }

    #[test]
    fn the_axis_follows_the_pointer() {
        let mut scene = spot(DVec3::new(-1.5, -1.0, -0.2));
        let view = View::new(&Camera::default(), SIZE);
        for front in [true, false] {
            for wanted in [
                DVec2::new(400.0, 300.0),
                DVec2::new(500.0, 250.0),
                DVec2::new(430.0, 330.0),
            ] {
                aim_at(&mut scene, 0, &view, wanted, front);
                let [head, _] = seen(&scene, &view);
                assert!((head - wanted).length() < 2.0, "{head} instead of {wanted}");
                let away = scene.lights[0].direction.dot(view.forward);
                assert_eq!(away < 0.3, front, "{wanted}: {away}");
            }
        }
    }

    #[test]
    fn the_cone_follows_the_pointer() {
        let view = View::new(&Camera::default(), SIZE);
        for direction in [DVec3::new(-1.5, -1.0, -0.2), DVec3::NEG_Z] {
            let mut scene = spot(direction);
            for wanted in [10.0, 25.0, 50.0] {
                scene.lights[0].cone = wanted;
                let [_, edge] = seen(&scene, &view);
                scene.lights[0].cone = 33.0;
                open_to(&mut scene, 0, &view, edge);
                let cone = scene.lights[0].cone;
                assert!(
                    (cone - wanted).abs() < 0.2,
                    "{direction}: {cone} instead of {wanted}"
                );
            }
            open_to(&mut scene, 0, &view, DVec2::splat(-1e6));
            assert_eq!(scene.validate(), Ok(()));
        }
    }

    #[test]
    fn only_what_has_an_axis_has_a_beam() {
        let view = View::new(&Camera::default(), SIZE);
        let of = |light: Light| Beam::of(&light, &view, DVec3::ZERO).is_some();
        assert!(!of(Light::default()));
        assert!(!of(Light {
            kind: LightKind::Directional,
            ..Light::default()
        }));
        assert!(of(Light {
            kind: LightKind::Area,
            ..Light::default()
        }));
        assert!(!of(Light {
            kind: LightKind::Area,
            shape: AreaShape::Sphere,
            ..Light::default()
        }));
        assert!(of(Light {
            kind: LightKind::Spot,
            position: DVec3::ZERO,
            ..Light::default()
        }));
    }

    #[test]
    fn the_pointer_lies_across_the_edge() {
        use eframe::egui::CursorIcon::{ResizeHorizontal, ResizeVertical};
        assert_eq!(
            (cursor(vec2(1.0, 0.0)), cursor(vec2(-1.0, 0.0))),
            (ResizeHorizontal, ResizeHorizontal)
        );
        assert_eq!(
            (cursor(vec2(0.0, 1.0)), cursor(vec2(0.1, -1.0))),
            (ResizeVertical, ResizeVertical)
        );
    }
}
