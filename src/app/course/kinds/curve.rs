//! A curve drawn by hand, and the right one laid over it.

use super::widget::{Asked, Widget};
use crate::app::course::parts::right_colour;
use crate::app::widgets::focus::named;
use crate::app::widgets::palette::vector_text;
use crate::figure::palette::Vector;
use crate::figure::short;
use crate::lesson::{Answer, CURVE_POINTS, Curve, Kind, Question, Solution};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, CursorIcon, EventFilter, FontId, Key, Mesh, Painter, Pos2, Rect, Response,
    RichText, Sense, Shape, Stroke, TextStyle, Ui, pos2, vec2,
};

/// Height of the drawing in its width.
const ASPECT: f32 = 0.5;
/// Points that a key moves along the curve at once, and how far up or down, in its height.
const STRIDE: usize = 4;
const RISE: f64 = 0.05;

/// The field of a curve on the screen.
struct Field {
    rect: Rect,
    x: [f64; 2],
    y: [f64; 2],
}

impl Field {
    fn at(&self, index: usize, value: f64) -> Pos2 {
        let share = (value - self.y[0]) / (self.y[1] - self.y[0]);
        let along = index as f32 / (CURVE_POINTS - 1) as f32;
        let up = share.clamp(-0.05, 1.05) as f32;
        self.rect.lerp_inside(vec2(along, 1.0 - up))
    }

    /// Finds the nearest point of the curve, and the value at that height.
    fn read(&self, at: Pos2) -> (usize, f64) {
        let along = ((at.x - self.rect.min.x) / self.rect.width()).clamp(0.0, 1.0);
        let up = 1.0 - ((at.y - self.rect.min.y) / self.rect.height()).clamp(0.0, 1.0);
        let index = (along * (CURVE_POINTS - 1) as f32).round() as usize;
        (index, self.y[0] + f64::from(up) * (self.y[1] - self.y[0]))
    }
}

/// A drawing, with what is drawn in it.
pub struct CurveWidget {
    /// The value at each point, where one was drawn.
    drawn: Vec<Option<f64>>,
    /// The point that the keys are at.
    cursor: usize,
    /// The place on a profile that the pointer is on, from 0 to 1.
    along: Option<f64>,
}

impl Default for CurveWidget {
    fn default() -> Self {
        Self {
            drawn: vec![None; CURVE_POINTS],
            cursor: CURVE_POINTS / 2,
            along: None,
        }
    }
}

impl Widget for CurveWidget {
    fn take_up(&mut self, given: &Answer) {
        if let Answer::Curve(drawn) = given {
            self.drawn.clone_from(drawn);
        }
    }

    fn ui(&mut self, ui: &mut Ui, asked: &mut Asked<'_>) -> bool {
        let Kind::Curve(curve) = &asked.question.kind else {
            return false;
        };
        let (x, y, revealed) = (curve.x, curve.y, asked.revealed);
        let font = FontId::proportional(TextStyle::Body.resolve(ui.style()).size * 0.9);
        let names = [0, 1].map(|axis| {
            let name = asked.names.get(axis).map_or("", |name| name.trim());
            name.replace('$', "")
        });
        let left = y
            .map(end)
            .into_iter()
            .map(|text| {
                ui.painter()
                    .layout_no_wrap(text, font.clone(), Color32::WHITE)
                    .size()
                    .x
            })
            .fold(0.0, f32::max)
            + 8.0;
        let width = ui.available_width();
        let size = vec2(width, (width * ASPECT).min(300.0) + 2.6 * font.size);
        let (outer, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        let words = text!(
            "course-curve-area",
            x = names[0].as_str(),
            y = names[1].as_str()
        );
        let response = named(response, Role::Canvas, &words);
        let rect = Rect::from_min_max(
            pos2(outer.min.x + left, outer.min.y + 1.6 * font.size),
            pos2(outer.max.x - 8.0, outer.max.y - 1.6 * font.size),
        );
        let field = Field { rect, x, y };
        if !revealed {
            asked.changed |= self.draw(ui, &field, &response);
        }
        let pointed = response
            .hover_pos()
            .filter(|at| rect.expand(8.0).contains(*at));
        let along = pointed
            .map(|at| field.read(at).0)
            .or((response.has_focus() && !revealed).then_some(self.cursor));
        let share = along
            .map(|index| index as f64 / (CURVE_POINTS - 1) as f64)
            .filter(|_| asked.question.kind.asks().follows_line());
        if share != self.along {
            self.along = share;
            ui.ctx().request_repaint();
        }
        let painter = ui.painter_at(outer);
        axes(ui, &painter, &field, &names, &font, outer);
        let own: Vec<(usize, f64)> = points(&self.drawn);
        let own_colour = vector_text(ui.visuals(), Vector::L);
        let right: Option<Vec<f64>> = match asked.right() {
            Some(Solution::Curve(curve)) => Some(curve.iter().map(|[_, y]| *y).collect()),
            _ => None,
        };
        if let Some(right) = &right {
            between(
                &painter,
                &field,
                &own,
                right,
                own_colour.gamma_multiply(0.25),
            );
        }
        line(&painter, &field, &own, Stroke::new(2.2, own_colour));
        if let Some(right) = &right {
            let right: Vec<(usize, f64)> = right.iter().copied().enumerate().collect();
            line(&painter, &field, &right, Stroke::new(2.2, right_colour(ui)));
        }
        if let Some(index) = along {
            let x = field.at(index, y[0]).x;
            let stroke = Stroke::new(1.0, ui.visuals().weak_text_color());
            painter.vline(x, rect.y_range(), stroke);
        }
        if response.has_focus() && !revealed {
            let value = height(&self.drawn, self.cursor, y);
            let at = field.at(self.cursor, value);
            painter.circle_filled(at, 4.5, ui.visuals().strong_text_color());
        }
        if !revealed && own.is_empty() {
            ui.label(RichText::new(text!("course-curve")).weak());
        } else {
            ui.horizontal_wrapped(|ui| {
                if revealed {
                    ui.label(RichText::new(text!("course-curve-yours")).color(own_colour));
                    ui.label(RichText::new(text!("course-curve-right")).color(right_colour(ui)));
                    return;
                }
                if !Curve::is_whole(&self.drawn) {
                    ui.label(RichText::new(text!("course-curve-whole")).weak());
                }
                if ui.button(text!("course-curve-clear")).clicked() {
                    self.drawn = vec![None; CURVE_POINTS];
                    asked.changed = true;
                }
            });
        }
        response.has_focus() && ui.input(|input| input.key_pressed(Key::Enter))
    }

    fn answer(&self, _: &Question, _: &Scene) -> Option<Answer> {
        Curve::is_whole(&self.drawn).then(|| Answer::Curve(self.drawn.clone()))
    }

    fn along(&self) -> Option<f64> {
        self.along
    }
}

impl CurveWidget {
    /// Takes what the pointer draws, and the keys. Returns whether the curve has changed.
    fn draw(&mut self, ui: &Ui, field: &Field, response: &Response) -> bool {
        let mut changed = false;
        if response.hovered() {
            ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
        }
        let held = response.is_pointer_button_down_on();
        if let Some(at) = response.interact_pointer_pos().filter(|_| held) {
            let moved = ui.input(|input| input.pointer.delta());
            let (index, value) = field.read(at);
            let (from, before) = field.read(at - moved);
            let just = ui.input(|input| input.pointer.any_pressed());
            let (from, before) = if just { (index, value) } else { (from, before) };
            let steps = index.abs_diff(from).max(1);
            for step in 0..=steps {
                let share = step as f64 / steps as f64;
                let place = from as f64 + (index as f64 - from as f64) * share;
                self.drawn[place.round() as usize] = Some(before + (value - before) * share);
            }
            changed = true;
            self.cursor = index;
        }
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
        if !response.has_focus() {
            return changed;
        }
        let filter = EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let pressed = |key: Key| ui.input(|input| input.key_pressed(key));
        if pressed(Key::ArrowLeft) {
            self.cursor = self.cursor.saturating_sub(STRIDE);
        }
        if pressed(Key::ArrowRight) {
            self.cursor = (self.cursor + STRIDE).min(CURVE_POINTS - 1);
        }
        let rise = f64::from(i8::from(pressed(Key::ArrowUp)) - i8::from(pressed(Key::ArrowDown)));
        if rise != 0.0 {
            let [low, high] = field.y;
            let at = self.cursor;
            let value = height(&self.drawn, at, field.y);
            lift(
                &mut self.drawn,
                at,
                (value + rise * RISE * (high - low)).clamp(low, high),
            );
            changed = true;
        }
        changed
    }
}

/// Formats the value at an end of an axis, without the zeros behind its point.
fn end(value: f64) -> String {
    let digits = short(value);
    if !digits.contains('.') || digits.contains('×') {
        return digits;
    }
    let digits = digits.trim_end_matches('0').trim_end_matches('.');
    digits.to_owned()
}

fn points(curve: &[Option<f64>]) -> Vec<(usize, f64)> {
    let points = curve.iter().enumerate();
    points
        .filter_map(|(index, value)| Some((index, (*value)?)))
        .collect()
}

/// Returns the value of a point; of one that is not drawn that of the nearest drawn one, and the middle where nothing is drawn.
fn height(curve: &[Option<f64>], at: usize, [low, high]: [f64; 2]) -> f64 {
    let drawn = points(curve).into_iter();
    let nearest = drawn.min_by_key(|(index, _)| index.abs_diff(at));
    nearest.map_or(0.5 * (low + high), |(_, value)| value)
}

/// Puts one point where it is wanted; those up to the next stride on either side go along a straight line, and what was not
/// drawn yet goes level.
fn lift(curve: &mut [Option<f64>], at: usize, value: f64) {
    for way in [-1isize, 1] {
        let end = at
            .saturating_add_signed(way * STRIDE as isize)
            .min(curve.len() - 1);
        let there = curve[end].unwrap_or(value);
        let steps = at.abs_diff(end);
        for step in 1..=steps {
            let place = at.saturating_add_signed(way * step as isize);
            let share = step as f64 / steps as f64;
            curve[place] = Some(value + (there - value) * share);
        }
        // Beyond, to the next that was drawn.
        let mut place = end;
        while let Some(next) = place
            .checked_add_signed(way)
            .filter(|next| *next < curve.len())
        {
            if curve[next].is_some() {
                break;
            }
            curve[next] = Some(there);
            place = next;
        }
    }
    curve[at] = Some(value);
}

fn axes(
    ui: &Ui,
    painter: &Painter,
    field: &Field,
    names: &[String; 2],
    font: &FontId,
    outer: Rect,
) {
    let visuals = ui.visuals();
    let rect = field.rect;
    painter.rect_filled(rect, 2.0, visuals.extreme_bg_color);
    let grid = Stroke::new(1.0, visuals.widgets.noninteractive.bg_stroke.color);
    for share in [0.25, 0.5, 0.75, 1.0] {
        painter.hline(rect.x_range(), rect.max.y - share * rect.height(), grid);
        painter.vline(rect.min.x + share * rect.width(), rect.y_range(), grid);
    }
    let line = Stroke::new(1.2, visuals.weak_text_color());
    painter.hline(rect.x_range(), rect.max.y, line);
    painter.vline(rect.min.x, rect.y_range(), line);
    let colour = visuals.text_color();
    let text = |at: Pos2, align: Align2, text: &str| {
        painter.text(at, align, text, font.clone(), colour);
    };
    let [left, right] = field.x.map(end);
    let [low, high] = field.y.map(end);
    let below = rect.max.y + 3.0;
    text(pos2(rect.min.x, below), Align2::LEFT_TOP, &left);
    text(pos2(rect.max.x, below), Align2::RIGHT_TOP, &right);
    text(pos2(rect.center().x, below), Align2::CENTER_TOP, &names[0]);
    let beside = rect.min.x - 4.0;
    text(pos2(beside, rect.max.y), Align2::RIGHT_BOTTOM, &low);
    text(pos2(beside, rect.min.y), Align2::RIGHT_TOP, &high);
    text(pos2(rect.min.x, outer.min.y), Align2::LEFT_TOP, &names[1]);
}

fn line(painter: &Painter, field: &Field, points: &[(usize, f64)], stroke: Stroke) {
    let mut run: Vec<Pos2> = Vec::new();
    let mut last: Option<usize> = None;
    for (index, value) in points {
        if last.is_some_and(|last| last + 1 != *index) {
            painter.add(Shape::line(std::mem::take(&mut run), stroke));
        }
        run.push(field.at(*index, *value));
        last = Some(*index);
    }
    if let [only] = run[..] {
        painter.circle_filled(only, stroke.width, stroke.color);
    } else {
        painter.add(Shape::line(run, stroke));
    }
}

/// Fills the area between the drawn curve and the right one.
fn between(painter: &Painter, field: &Field, own: &[(usize, f64)], right: &[f64], colour: Color32) {
    let mut mesh = Mesh::default();
    for pair in own.windows(2) {
        let [(a, own_a), (b, own_b)] = [pair[0], pair[1]];
        let (Some(right_a), Some(right_b)) = (right.get(a), right.get(b)) else {
            continue;
        };
        let base = mesh.vertices.len() as u32;
        for at in [
            field.at(a, own_a),
            field.at(a, *right_a),
            field.at(b, *right_b),
            field.at(b, own_b),
        ] {
            mesh.colored_vertex(at, colour);
        }
        mesh.add_triangle(base, base + 1, base + 2);
        mesh.add_triangle(base, base + 2, base + 3);
    }
    painter.add(Shape::mesh(mesh));
}

#[cfg(test)]
mod tests {
    use super::{end, height, lift};

    #[test]
    fn ends_of_axes_have_no_idle_zeros() {
        let ends = [0.0, 1.0, 0.25, 0.5, 90.0, 120.0, -1.5, 1e-7];
        assert_eq!(
            ends.map(end),
            ["0", "1", "0.25", "0.5", "90", "120", "−1.5", "1.0×10⁻⁷"]
        );
    }

    #[test]
    fn a_key_goes_on_from_the_nearest_point_that_is_drawn() {
        let mut curve = vec![None; 20];
        assert_eq!(height(&curve, 7, [0.0, 3.0]), 1.5);
        curve[2] = Some(0.25);
        curve[9] = Some(2.5);
        let heights = [0, 2, 5, 6, 19].map(|at| height(&curve, at, [0.0, 3.0]));
        assert_eq!(heights, [0.25, 0.25, 0.25, 2.5, 2.5]);
        lift(&mut curve, 19, 2.6);
        assert_eq!([curve[19], curve[9], curve[2]], [2.6, 2.5, 0.25].map(Some));
        assert_eq!(curve[12], Some(2.6), "level beside what was not drawn");
    }
}
