//! Drawings painted by the window.

use super::lines;
use crate::figure::{Drawing, Set, Shape, Text, can_be_filled};
use eframe::egui::accesskit::Role;
use eframe::egui::{self, Color32, FontId, Mesh, Painter, Pos2, Response, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};
use glam::DVec2;

/// Places a drawing in a panel, with `words` for those who do not see it; nothing where it is out of sight.
pub fn drawing_ui(
    ui: &mut Ui,
    drawing: &Drawing,
    sense: Sense,
    words: impl Fn() -> String,
) -> Option<(Response, Painter)> {
    let size = vec2(drawing.size.x as f32, drawing.size.y as f32);
    let (rect, response) = ui.allocate_exact_size(size, sense);
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(Role::Image, enabled, words()));
    if !ui.is_rect_visible(rect) {
        return None;
    }
    let painter = ui.painter_at(rect.expand(1.0));
    for shape in drawing.painted() {
        paint_shape(&painter, &shape, rect.min);
    }
    for text in &drawing.texts {
        paint_text(&painter, text, rect.min);
    }
    Some((response, painter))
}

pub fn screen(point: DVec2, origin: Pos2) -> Pos2 {
    origin + vec2(point.x as f32, point.y as f32)
}

pub fn colour_of([r, g, b]: [u8; 3], opacity: f64) -> Color32 {
    Color32::from_rgb(r, g, b).gamma_multiply(opacity as f32)
}

fn paint_shape(painter: &Painter, line: &Shape, origin: Pos2) {
    let colour = colour_of(line.colour, line.opacity);
    let stroke = Stroke::new(line.width as f32, colour);
    let places = line.points.iter().map(|point| lines::exact(origin) + *point);
    if line.fill {
        let points: Vec<Pos2> = line.points.iter().map(|point| screen(*point, origin)).collect();
        if !can_be_filled(&places.collect::<Vec<_>>(), &lines::window(painter)) {
            return;
        }
        if line.opacity < 1.0 {
            painter.add(egui::Shape::mesh(fan(&points, colour)));
        } else {
            painter.add(egui::Shape::convex_polygon(points, colour, Stroke::NONE));
        }
    } else {
        let dashes: Vec<f32> = line.dashes.iter().map(|dash| dash * stroke.width).collect();
        let closing = line.points.first().filter(|_| line.closed).map(|point| lines::exact(origin) + *point);
        lines::line(painter, places.chain(closing), stroke, &dashes);
    }
}

/// An area as triangles about its first point, from which all of it is seen.
fn fan(points: &[Pos2], colour: Color32) -> Mesh {
    let mut mesh = Mesh::default();
    for point in points {
        mesh.colored_vertex(*point, colour);
    }
    for i in 2..u32::try_from(points.len()).unwrap_or(0) {
        mesh.add_triangle(0, i - 1, i);
    }
    mesh
}

/// Paints a line of text, its small letters apart: the fonts have only ordinary ones.
pub fn paint_text(painter: &Painter, text: &Text, origin: Pos2) {
    let mut runs: Vec<(Set, String)> = Vec::new();
    for set in text.text.chars().map(Set::of) {
        match runs.last_mut().filter(|(last, _)| last.rise == set.rise) {
            Some((_, run)) => run.push(set.letter),
            None => runs.push((set, set.letter.to_string())),
        }
    }
    let colour = colour_of(text.colour, 1.0);
    let size = text.size as f32;
    let laid: Vec<_> = runs
        .into_iter()
        .map(|(set, run)| {
            let galley = painter.layout_no_wrap(run, FontId::proportional(size * set.size), colour);
            let baseline = galley.rows.first().and_then(|row| Some(row.pos.y + row.glyphs.first()?.pos.y));
            (baseline.unwrap_or(0.0) + size * set.rise, galley)
        })
        .collect();
    let width: f32 = laid.iter().map(|(_, galley)| galley.size().x).sum();
    let at = screen(text.at, origin);
    let mut x = at.x - width * text.align as f32;
    for (above, galley) in laid {
        let advance = galley.size().x;
        painter.galley(pos2(x, at.y - above), galley, colour);
        x += advance;
    }
}
