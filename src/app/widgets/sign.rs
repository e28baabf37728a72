//! Signs on buttons, drawn as shapes since no font has all of them.

use super::focus::switch_named;
use crate::scene::LightKind;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Atom, Button, Color32, IntoAtoms, Painter, Pos2, Rect, Sense, Shape, Stroke, StrokeKind, Ui,
    Vec2, vec2,
};

/// The icon of a button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    Controls,
    Point,
    Line,
    Picture,
    Engine,
    Course,
    Close,
    Enlarge,
    Shrink,
    Below,
    Beside,
}

impl Sign {
    /// Draws the sign in a square.
    pub fn paint(self, painter: &Painter, square: Rect, colour: Color32) {
        let stroke = Stroke::new((square.width() / 11.0).max(1.2), colour);
        let at = |x: f32, y: f32| -> Pos2 { square.lerp_inside(vec2(x, y)) };
        let line = |points: &[(f32, f32)]| {
            let points = points.iter().map(|(x, y)| at(*x, *y)).collect();
            painter.line(points, stroke);
        };
        let frame = |min: (f32, f32), max: (f32, f32), stroke: Stroke| {
            let rect = Rect::from_min_max(at(min.0, min.1), at(max.0, max.1));
            painter.rect_stroke(rect, 1.5, stroke, StrokeKind::Middle);
        };
        let fill = |min: (f32, f32), max: (f32, f32)| {
            let rect = Rect::from_min_max(at(min.0, min.1), at(max.0, max.1));
            painter.rect_filled(rect, 1.0, colour);
        };
        match self {
            Self::Controls => {
                for (y, knob) in [(0.2, 0.65), (0.5, 0.3), (0.8, 0.75)] {
                    line(&[(0.05, y), (0.95, y)]);
                    painter.circle_filled(at(knob, y), 0.12 * square.width(), colour);
                }
            }
            Self::Point => {
                painter.circle_stroke(at(0.5, 0.5), 0.3 * square.width(), stroke);
                painter.circle_filled(at(0.5, 0.5), 0.08 * square.width(), colour);
                for (from, to) in [((0.5, 0.0), (0.5, 0.2)), ((0.5, 0.8), (0.5, 1.0))] {
                    line(&[from, to]);
                    line(&[(from.1, from.0), (to.1, to.0)]);
                }
            }
            Self::Line => {
                line(&[(0.05, 0.0), (0.05, 0.95), (1.0, 0.95)]);
                line(&[
                    (0.2, 0.75),
                    (0.4, 0.6),
                    (0.55, 0.2),
                    (0.7, 0.5),
                    (0.95, 0.65),
                ]);
            }
            Self::Picture => {
                frame((0.02, 0.12), (0.98, 0.88), stroke);
                line(&[(0.5, 0.12), (0.5, 0.88)]);
                painter.circle_filled(at(0.26, 0.5), 0.13 * square.width(), colour);
                painter.circle_stroke(at(0.74, 0.5), 0.13 * square.width(), stroke);
            }
            Self::Engine => {
                painter.circle_stroke(at(0.5, 0.58), 0.38 * square.width(), stroke);
                line(&[(0.4, 0.03), (0.6, 0.03)]);
                line(&[(0.5, 0.03), (0.5, 0.2)]);
                line(&[(0.5, 0.58), (0.68, 0.38)]);
            }
            Self::Course => {
                // An open book.
                line(&[(0.5, 0.25), (0.5, 0.92)]);
                for way in [-1.0, 1.0] {
                    let x = |share: f32| 0.5 + way * share;
                    line(&[
                        (x(0.0), 0.25),
                        (x(0.2), 0.14),
                        (x(0.48), 0.14),
                        (x(0.48), 0.8),
                        (x(0.2), 0.8),
                        (x(0.0), 0.92),
                    ]);
                }
            }
            Self::Close => {
                line(&[(0.15, 0.15), (0.85, 0.85)]);
                line(&[(0.85, 0.15), (0.15, 0.85)]);
            }
            Self::Enlarge => frame((0.08, 0.12), (0.92, 0.88), stroke),
            Self::Shrink => {
                frame((0.08, 0.34), (0.66, 0.88), stroke);
                line(&[
                    (0.34, 0.34),
                    (0.34, 0.12),
                    (0.92, 0.12),
                    (0.92, 0.66),
                    (0.66, 0.66),
                ]);
            }
            Self::Below => {
                frame((0.08, 0.12), (0.92, 0.88), stroke);
                fill((0.08, 0.58), (0.92, 0.88));
            }
            Self::Beside => {
                frame((0.08, 0.12), (0.92, 0.88), stroke);
                fill((0.58, 0.12), (0.92, 0.88));
            }
        }
    }
}

/// Shows a small button with a sign; returns whether it was clicked.
pub fn sign_button(ui: &mut Ui, sign: Sign, name: &str) -> bool {
    let side = ui.spacing().interact_size.y;
    let (rect, response) = ui.allocate_exact_size(vec2(side, side), Sense::click());
    let response = switch_named(response, Role::Button, false, name);
    let visuals = ui.style().interact(&response);
    if response.hovered() {
        ui.painter()
            .rect_filled(rect, visuals.corner_radius, visuals.bg_fill);
    }
    let square = Rect::from_center_size(rect.center(), vec2(13.0, 13.0));
    sign.paint(ui.painter(), square, visuals.text_color());
    response.on_hover_text(name).clicked()
}

/// Returns a button with `sign` in front of its words.
pub fn signed<'a>(on: bool, sign: Atom<'a>, words: impl IntoAtoms<'a>) -> Button<'a> {
    let mut atoms = words.into_atoms();
    atoms.push_left(sign);
    atoms.push_right(Atom::grow());
    Button::selectable(on, atoms).truncate()
}

/// Returns a disc of `colour` as the sign of a button.
pub fn disc(side: f32, colour: Color32) -> Atom<'static> {
    Atom::paint(Vec2::splat(side), move |ui, args| {
        let rim = Stroke::new(1.0, ui.visuals().weak_text_color());
        let at = args.rect.center();
        ui.painter().circle(at, 0.5 * side, colour, rim);
    })
}

/// Returns the sign of a light's kind, filled with the light's colour, or hollow while the light is off.
pub fn light_sign(side: f32, kind: LightKind, colour: Option<Color32>) -> Atom<'static> {
    Atom::paint(Vec2::splat(side), move |ui, args| {
        let (painter, at) = (ui.painter(), args.rect.center());
        let rim = Stroke::new(1.2, ui.visuals().weak_text_color());
        let fill = colour.unwrap_or(Color32::TRANSPARENT);
        match kind {
            LightKind::Point => _ = painter.circle(at, 6.0, fill, rim),
            LightKind::Directional => {
                painter.circle(at, 4.0, fill, rim);
                for k in 0..8u8 {
                    let way = Vec2::angled(f32::from(k) * std::f32::consts::FRAC_PI_4);
                    painter.line_segment([at + way * 5.5, at + way * 8.0], rim);
                }
            }
            LightKind::Spot => {
                let cone = [vec2(0.0, -7.0), vec2(6.0, 6.0), vec2(-6.0, 6.0)];
                let cone = cone.map(|corner| at + corner).to_vec();
                painter.add(Shape::convex_polygon(cone, fill, rim));
            }
            LightKind::Area => {
                let area = Rect::from_center_size(at, vec2(14.0, 9.0));
                painter.rect(area, 1.0, fill, rim, StrokeKind::Middle);
            }
        }
    })
}
