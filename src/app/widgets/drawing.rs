//! Drawings painted in the window, and plots that show their values under the pointer.

use super::letter::runs;
use super::lines;
pub use super::palette::rgb;
use super::theme::TEXT;
use crate::figure::{Drawing, Paper, Plot, PlotStyle, Shape, Text, can_be_filled, short};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    self, Color32, CursorIcon, FontId, Mesh, Painter, Pos2, Rect, Response, Sense, Stroke,
    StrokeKind, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use glam::DVec2;

/// Size of letters in plots, relative to the window's text.
const LETTERS: f64 = 0.9;
/// Height of the part of a plot that grows with its width, relative to the width: with straight axes, and as a half
/// disc.
const ASPECT: [f64; 2] = [0.55, 0.5];
/// Height of a plot of single points with their names, relative to its width, and its maximum, points.
const POINTS: [f64; 2] = [0.85, 430.0];
/// Maximum distance from the pointer to the point that it selects, points.
const NEAR: f32 = 16.0;
/// Height of the part of a plot that does not grow with its width, in letter sizes: of the labels around the plot, and
/// of a line of the legend.
const LINES: [f64; 2] = [7.5, 1.4];

/// Returns the style of plots in a panel.
pub fn plot_style(ui: &Ui) -> PlotStyle {
    let visuals = ui.visuals();
    let paper = Paper {
        ground: rgb(visuals.panel_fill),
        text: rgb(visuals.text_color()),
        weak: rgb(visuals.weak_text_color()),
        grid: rgb(visuals.widgets.noninteractive.bg_stroke.color),
    };
    PlotStyle {
        paper,
        text: LETTERS * f64::from(TEXT),
        titled: false,
    }
}

/// Returns the height of a plot of this width in `letters` of this size, in points.
pub fn height(plot: &Plot, width: f64, letters: f64) -> f64 {
    #[expect(
        clippy::cast_precision_loss,
        reason = "a plot has few curves and marks"
    )]
    let lines = (plot.curves.len() + plot.marks.len()) as f64;
    let grows = if plot.points.is_empty() {
        width * ASPECT[usize::from(plot.kind.is_polar())]
    } else {
        (width * POINTS[0]).min(POINTS[1])
    };
    grows + letters * (LINES[0] + LINES[1] * lines)
}

/// Shows a plot. Under the pointer appear the values of all curves, in a box and as dots, or the nearest point with its
/// description. Returns the point that is clicked.
pub fn plot_ui(ui: &mut Ui, plot: &Plot, drawing: &Drawing, style: &PlotStyle) -> Option<usize> {
    // A description of the plot for screen readers.
    let words = || {
        let marks = plot.marks.iter().map(|mark| mark.label.as_str());
        [plot.title.as_str(), plot.note.as_str()]
            .into_iter()
            .chain(marks)
            .collect::<Vec<_>>()
            .join("; ")
    };
    if !plot.points.is_empty() {
        let (response, painter) = drawing_ui(ui, drawing, Sense::click(), words)?;
        return points_ui(ui, plot, (drawing, style), (&response, &painter));
    }
    let (response, painter) = drawing_ui(ui, drawing, Sense::hover(), words)?;
    let rect = response.rect;
    let pointer = response.hover_pos()?;
    let x = drawing.x_at(lines::exact(pointer) - lines::exact(rect.min))?;
    let (_, ends) = drawing.place([x, 0.0])?;
    let ends = ends.map(|end| lines::exact(rect.min) + end);
    let stroke = Stroke::new(1.0, ui.visuals().text_color());
    lines::line(&painter, ends, stroke, &[]);
    let unit = if plot.x.degrees { "°" } else { "" };
    let symbol = plot.x.name.split([',', '，']).next().unwrap_or_default();
    let line = |text: String, colour| Text::new(text, DVec2::ZERO, style.text, colour);
    let mut lines = vec![line(
        format!("{symbol} = {}{unit}", short(x)),
        style.paper.text,
    )];
    for curve in &plot.curves {
        let Some(y) = curve.at(x) else { continue };
        lines.push(line(
            format!("{}: {}", curve.name, short(y)),
            style.paper.letters(curve.ink),
        ));
        let at = drawing.place([x, y]).map(|(at, _)| screen(at, rect.min));
        if let Some(at) = at.filter(|at| y <= plot.y.high && rect.contains(*at)) {
            painter.circle_filled(at, 3.0, colour_of(style.paper.line(curve.ink), 1.0));
        }
    }
    boxed(ui, &painter, &lines, (rect, pointer));
    None
}

/// Shows the description of the point under the pointer; returns the point if it is clicked.
fn points_ui(
    ui: &Ui,
    plot: &Plot,
    (drawing, style): (&Drawing, &PlotStyle),
    (response, painter): (&Response, &Painter),
) -> Option<usize> {
    let (rect, pointer) = (response.rect, response.hover_pos()?);
    let away = |at: [f64; 2]| {
        let (at, _) = drawing.place(at)?;
        Some(screen(at, rect.min).distance(pointer))
    };
    let near = plot
        .points
        .iter()
        .enumerate()
        .filter_map(|(index, point)| Some((index, away(point.at)?)))
        .filter(|(_, away)| *away <= NEAR);
    let (index, _) = near.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let point = &plot.points[index];
    ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
    let lines: Vec<Text> = point
        .about
        .iter()
        .map(|line| Text::new(line, DVec2::ZERO, style.text, style.paper.text))
        .collect();
    boxed(ui, painter, &lines, (rect, pointer));
    response.clicked().then_some(index)
}

/// Shows lines of text in a box beside the pointer, inside `rect`.
pub fn boxed(ui: &Ui, painter: &Painter, lines: &[Text], (rect, pointer): (Rect, Pos2)) {
    let row = lines.first().map_or(0.0, |text| 1.4 * text.size as f32);
    let width = lines
        .iter()
        .map(|text| text.width() as f32)
        .fold(0.0, f32::max);
    let size = vec2(width, row * lines.len() as f32) + Vec2::splat(12.0);
    let right = pointer.x + 14.0 + size.x <= rect.max.x;
    let x = if right {
        pointer.x + 14.0
    } else {
        (pointer.x - 14.0 - size.x).max(rect.min.x)
    };
    let y = (pointer.y - 0.5 * size.y).clamp(rect.min.y, (rect.max.y - size.y).max(rect.min.y));
    let area = Rect::from_min_size(pos2(x, y), size);
    let visuals = ui.visuals();
    let (fill, outline) = (
        visuals.window_fill,
        visuals.widgets.noninteractive.bg_stroke,
    );
    painter.rect(area, 4.0, fill, outline, StrokeKind::Inside);
    for (index, text) in lines.iter().enumerate() {
        let at = area.min + vec2(6.0, 6.0 + row * (index as f32 + 0.75));
        paint_text(painter, text, at);
    }
}

/// Places a drawing in a panel, with `words` for screen readers. Returns `None` if it is out of sight.
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
    paint(&painter, drawing, rect.min);
    Some((response, painter))
}

/// Paints a drawing from its top left corner.
pub fn paint(painter: &Painter, drawing: &Drawing, origin: Pos2) {
    for shape in drawing.painted() {
        paint_shape(painter, &shape, origin);
    }
    for text in &drawing.texts {
        paint_text(painter, text, origin);
    }
}

fn screen(point: DVec2, origin: Pos2) -> Pos2 {
    origin + vec2(point.x as f32, point.y as f32)
}

pub fn colour_of([r, g, b]: [u8; 3], opacity: f64) -> Color32 {
    Color32::from_rgb(r, g, b).gamma_multiply(opacity as f32)
}

fn paint_shape(painter: &Painter, line: &Shape, origin: Pos2) {
    let colour = colour_of(line.colour, line.opacity);
    let stroke = Stroke::new(line.width as f32, colour);
    let mut places: Vec<DVec2> = line
        .points
        .iter()
        .map(|point| lines::exact(origin) + *point)
        .collect();
    if !line.fill {
        let dashes: Vec<f32> = line.dashes.iter().map(|dash| dash * stroke.width).collect();
        places.extend(places.first().copied().filter(|_| line.closed));
        lines::line(painter, places, stroke, &dashes);
        return;
    }
    if !can_be_filled(&places, &lines::window(painter)) {
        return;
    }
    let points = line.points.iter().map(|point| screen(*point, origin));
    if line.opacity < 1.0 {
        // As a fan of triangles around the first point, from which the whole shape is visible.
        let mut mesh = Mesh::default();
        points.for_each(|point| mesh.colored_vertex(point, colour));
        (2..u32::try_from(line.points.len()).unwrap_or(0))
            .for_each(|i| mesh.add_triangle(0, i - 1, i));
        painter.add(egui::Shape::mesh(mesh));
    } else {
        painter.add(egui::Shape::convex_polygon(
            points.collect(),
            colour,
            Stroke::NONE,
        ));
    }
}

/// Paints a line of text, with subscripts and superscripts set separately, since the fonts only have ordinary letters.
fn paint_text(painter: &Painter, text: &Text, origin: Pos2) {
    let colour = colour_of(text.colour, 1.0);
    let size = text.size as f32;
    let laid: Vec<_> = runs(&text.text)
        .into_iter()
        .map(|(set, run)| {
            let galley = painter.layout_no_wrap(run, FontId::proportional(size * set.size), colour);
            let baseline = galley
                .rows
                .first()
                .and_then(|row| Some(row.pos.y + row.glyphs.first()?.pos.y));
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
