//! A curve drawn by hand, and the right one drawn over it.

use super::widget::{Widget, WidgetContext};
use crate::app::widgets::drawing::{paint, plot_style, rgb};
use crate::app::widgets::focus::named;
use crate::app::widgets::lines::exact;
use crate::app::widgets::palette::{right_colour, vector_text};
use crate::figure::palette::{Rgb8, Vector};
use crate::figure::{Drawing, Shape};
use crate::lesson::{
    Answer, CURVE_POINTS, Curve, CurveAxes, Kind, Question, Solution, abscissa, ordinate,
};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    CursorIcon, EventFilter, Key, Pos2, Rect, Response, RichText, Sense, Stroke, Ui, vec2,
};
use glam::DVec2;

/// The height of the plot as a fraction of its width.
const ASPECT: f32 = 0.5;
/// The height of the parts that do not grow with the plot, in text heights.
const LETTERS: f32 = 4.0;
/// The line width of curves, in points.
const LINE: f64 = 2.2;
/// The number of points that one key press moves along the curve; [`RISE`] is its step up or down, as a
/// fraction of the axis.
const STRIDE: usize = 4;
const RISE: f64 = 0.05;

/// The axes of a curve on the screen.
struct Field {
    drawing: Drawing,
    /// The top left corner of the plot.
    origin: Pos2,
    x: [f64; 2],
    y: [f64; 2],
}

impl Field {
    fn x_of(&self, index: usize) -> f64 {
        abscissa(self.x, index)
    }

    fn at(&self, index: usize, value: f64) -> Pos2 {
        let place = self.drawing.place([self.x_of(index), value]);
        let (place, _) = place.unwrap_or_default();
        self.origin + vec2(place.x as f32, place.y as f32)
    }

    fn rect(&self) -> Rect {
        let [_, top] = self.axis(CURVE_POINTS - 1);
        Rect::from_two_pos(self.at(0, self.y[0]), top)
    }

    /// Returns the vertical line at a point of the curve.
    fn axis(&self, index: usize) -> [Pos2; 2] {
        let place = self.drawing.place([self.x_of(index), self.y[0]]);
        let (_, ends) = place.unwrap_or_default();
        ends.map(|end| self.origin + vec2(end.x as f32, end.y as f32))
    }

    /// Finds the nearest point of the curve, and the value at that height.
    fn read(&self, at: Pos2) -> (usize, f64) {
        let place = exact(at) - exact(self.origin);
        let [x, y] = self.drawing.value_near(place).unwrap_or_default();
        let along = (x - self.x[0]) / (self.x[1] - self.x[0]);
        let index = (along * (CURVE_POINTS - 1) as f64).round() as usize;
        // The axis of y reaches a little beyond its maximum.
        (index, y.min(self.y[1]))
    }
}

/// A plot, with the curve drawn in it.
pub struct CurveWidget {
    /// The value at each point; `None` where nothing is drawn.
    drawn: Vec<Option<f64>>,
    /// The point that the keys move.
    cursor: usize,
    /// The position on a profile under the pointer, from 0 to 1.
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

    fn ui(&mut self, ui: &mut Ui, asked: &mut WidgetContext<'_>) -> bool {
        let Kind::Curve(curve) = &asked.question.kind else {
            return false;
        };
        let (x, y, revealed) = (curve.x, curve.y, asked.revealed);
        let style = plot_style(ui);
        let width = ui.available_width();
        let size = vec2(
            width,
            (width * ASPECT).min(300.0) + LETTERS * style.text as f32,
        );
        let (outer, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        let name = |axis: usize| asked.names.get(axis).map_or("", |name| &**name);
        let axes = CurveAxes::new([x, y], [name(0), name(1)]);
        let response = named(response, Role::Canvas, &axes.words());
        let drawing = axes.lay_out(DVec2::new(size.x.into(), size.y.into()), &style);
        let mut field = Field {
            drawing,
            origin: outer.min,
            x,
            y,
        };
        let rect = field.rect();
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
        let own: Vec<(usize, f64)> = points(&self.drawn);
        let own_colour = vector_text(ui.visuals(), Vector::L);
        let right: &[[f64; 2]] = match asked.right() {
            Some(Solution::Curve(curve)) => curve,
            _ => &[],
        };
        between(&mut field, &own, right, rgb(own_colour));
        let drawn = self.drawn.iter().enumerate();
        let drawn: Vec<[f64; 2]> = drawn
            .map(|(index, value)| [field.x_of(index), value.unwrap_or(f64::NAN)])
            .collect();
        if let Some(Solution::Curve(wrong)) = asked.wrong {
            let faint = rgb(ui.visuals().weak_text_color());
            let curve = wrong.iter().copied();
            field.drawing.draw_curve(curve, LINE, faint, 0.6);
        }
        field.drawing.draw_curve(drawn, LINE, rgb(own_colour), 1.0);
        let right_line = rgb(right_colour(ui));
        field
            .drawing
            .draw_curve(right.iter().copied(), LINE, right_line, 1.0);
        let painter = ui.painter_at(outer);
        painter.rect_filled(rect, 2.0, ui.visuals().extreme_bg_color);
        paint(&painter, &field.drawing, outer.min);
        if let Some(index) = along {
            let stroke = Stroke::new(1.0, ui.visuals().weak_text_color());
            painter.line_segment(field.axis(index), stroke);
        }
        if response.has_focus() && !revealed {
            let value = height(&self.drawn, self.cursor, y);
            let at = field.at(self.cursor, value);
            painter.circle_filled(at, 4.5, ui.visuals().strong_text_color());
        }
        if !revealed && own.is_empty() {
            let words = if asked.test {
                text!("course-curve.test")
            } else {
                text!("course-curve")
            };
            ui.label(RichText::new(words).weak());
        } else {
            ui.horizontal_wrapped(|ui| {
                if revealed {
                    ui.label(RichText::new(text!("course-curve-yours")).color(own_colour));
                    ui.label(RichText::new(text!("course-curve-right")).color(right_colour(ui)));
                    if asked.wrong.is_some() {
                        ui.label(RichText::new(text!("course-curve-wrong")).weak());
                    }
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
    /// Handles the pointer's strokes and the keys. Returns whether the curve has changed.
    fn draw(&mut self, ui: &Ui, field: &Field, response: &Response) -> bool {
        let mut changed = false;
        if response.hovered() {
            ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
        }
        let held = response.is_pointer_button_down_on();
        if let Some(at) = response.interact_pointer_pos().filter(|_| held) {
            let moved = ui.input(|input| input.pointer.delta());
            let (index, value) = field.read(at);
            let just = ui.input(|input| input.pointer.any_pressed());
            let (from, before) = field.read(if just { at } else { at - moved });
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
            let value = height(&self.drawn, at, field.y) + rise * RISE * (high - low);
            lift(&mut self.drawn, at, value.clamp(low, high));
            changed = true;
        }
        changed
    }
}

fn points(curve: &[Option<f64>]) -> Vec<(usize, f64)> {
    let points = curve.iter().enumerate();
    points
        .filter_map(|(index, value)| Some((index, (*value)?)))
        .collect()
}

/// Returns the value of a point. A point that is not drawn has the value of the nearest drawn one, or the
/// middle of the range if nothing is drawn.
fn height(curve: &[Option<f64>], at: usize, [low, high]: [f64; 2]) -> f64 {
    let drawn = points(curve).into_iter();
    let nearest = drawn.min_by_key(|(index, _)| index.abs_diff(at));
    nearest.map_or(0.5 * (low + high), |(_, value)| value)
}

/// Moves one point to `value`. The points up to the next stride on either side follow along a straight line;
/// beyond, points not drawn yet take the value at its end.
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
        // Further on, up to the next drawn point.
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

/// Fills the area between the drawn curve and the right one.
fn between(field: &mut Field, own: &[(usize, f64)], right: &[[f64; 2]], colour: Rgb8) {
    if right.is_empty() {
        return;
    }
    let pairs = own.windows(2).map(|pair| [pair[0], pair[1]]);
    for [(from, own_from), (to, own_to)] in pairs {
        let [from, to] = [from, to].map(|index| field.x_of(index));
        let inner = right.iter().filter(|[x, _]| from < *x && *x < to).copied();
        let mut corners = vec![[from, own_from], [from, ordinate(right, from)]];
        corners.extend(inner);
        corners.extend([[to, ordinate(right, to)], [to, own_to]]);
        let places = corners
            .into_iter()
            .filter_map(|corner| field.drawing.place(corner));
        let places = places.map(|(place, _)| place).collect();
        let area = Shape::area(places, colour).faded(0.25);
        field.drawing.shapes.push(area);
    }
}

#[cfg(test)]
mod tests {
    use super::{height, lift};

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
