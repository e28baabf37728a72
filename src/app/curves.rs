//! The curves where the probe stands, drawn with the window's own painter, with their values under the pointer.
//!
//! The plots are sampled when the scene, the probe or the chosen light has changed, and laid out when the panel's width or
//! the theme has; a frame in which nothing has changed only paints them.

use super::engine::Engine;
use super::lines;
use super::state::AppState;
use super::theme::TEXT;
use crate::analysis::{Plot, PlotKind};
use crate::figure::{Drawing, Paper, PlotStyle, Set, Shape as Line, Text, can_be_filled, lay_out, short};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Color32, CornerRadius, FontId, Mesh, Painter, Pos2, Rect, RichText, Sense, Shape, Stroke, StrokeKind, Ui, Vec2,
    WidgetInfo, pos2, vec2,
};
use glam::DVec2;

/// Size of letters in the plots, in that of the window's text.
pub const LETTERS: f64 = 0.9;
/// Height of the part of a plot that grows with its width: over straight axes, and of a half disc.
const ASPECT: [f64; 2] = [0.55, 0.5];
/// Height of all that does not: of labels about the plot, and of a line of the legend; in letters.
const LINES: [f64; 2] = [7.5, 1.4];

/// The plots as last sampled and laid out, and what for.
#[derive(Debug, Default)]
pub struct Curves {
    sampled: Option<(u64, usize)>,
    /// The style and the width of what is laid out.
    laid_out: Option<(PlotStyle, f32)>,
    plots: Vec<Plot>,
    drawings: Vec<Drawing>,
}

impl Curves {
    fn update(&mut self, engine: &Engine, light: usize, style: PlotStyle, width: f32) {
        let sampled = Some((engine.revision(), light));
        if self.sampled != sampled {
            self.sampled = sampled;
            self.laid_out = None;
            self.plots = engine.plots(light);
        }
        if self.laid_out != Some((style, width)) {
            self.laid_out = Some((style, width));
            let width = f64::from(width);
            let room = |plot: &Plot| DVec2::new(width, height(plot, width, style.text));
            self.drawings = self.plots.iter().map(|plot| lay_out(plot, room(plot), &style)).collect();
        }
    }
}

/// The plots for the probe, one below the other.
pub fn curves_ui(ui: &mut Ui, state: &AppState, engine: &Engine, curves: &mut Curves) {
    let scene = &state.document.scene;
    let light = state.light.min(scene.lights.len().saturating_sub(1));
    let style = PlotStyle { paper: paper(ui), text: LETTERS * f64::from(TEXT), titled: false };
    curves.update(engine, light, style, ui.available_width());
    let several = scene.lights.len() > 1;
    for (plot, drawing) in curves.plots.iter().zip(&curves.drawings) {
        let of_light = several && matches!(plot.kind, PlotKind::Attenuation | PlotKind::Lobe);
        let number = if of_light { format!(", light {}", light + 1) } else { String::new() };
        ui.label(RichText::new(format!("{}{number}", plot.title)).strong());
        plot_ui(ui, plot, drawing, &style);
        ui.add_space(12.0);
    }
    if !curves.plots.iter().any(|plot| plot.kind == PlotKind::Lobe) {
        missing_ui(ui, engine, light);
    }
}

/// Why there is no lobe.
fn missing_ui(ui: &mut Ui, engine: &Engine, light: usize) {
    let Some(probe) = engine.probed() else { return };
    let text = match &probe.hit {
        None => "The probe sees the background. Double-click the object, or drag the ring onto it.".to_owned(),
        Some(hit) if hit.lights.is_empty() => "There is no light to be reflected.".to_owned(),
        Some(hit) if hit.normal == glam::DVec3::ZERO => "The normal has no direction here.".to_owned(),
        Some(_) => format!("Light {} is behind the surface here: nothing is reflected.", light + 1),
    };
    ui.label(text);
}

pub fn paper(ui: &Ui) -> Paper {
    let visuals = ui.visuals();
    let rgb = |colour: Color32| [colour.r(), colour.g(), colour.b()];
    Paper {
        ground: rgb(visuals.panel_fill),
        text: rgb(visuals.text_color()),
        weak: rgb(visuals.weak_text_color()),
        grid: rgb(visuals.widgets.noninteractive.bg_stroke.color),
    }
}

pub fn height(plot: &Plot, width: f64, letters: f64) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "a plot has few curves and marks")]
    let lines = (plot.curves.len() + plot.marks.len()) as f64;
    width * ASPECT[usize::from(plot.kind.is_polar())] + letters * (LINES[0] + LINES[1] * lines)
}

pub fn plot_ui(ui: &mut Ui, plot: &Plot, drawing: &Drawing, style: &PlotStyle) {
    let size = vec2(drawing.size.x as f32, drawing.size.y as f32);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(Role::Image, enabled, described(plot)));
    if !ui.is_rect_visible(rect) {
        return;
    }
    let painter = ui.painter_at(rect.expand(1.0));
    for line in &drawing.shapes {
        paint_shape(&painter, line, rect.min);
    }
    for text in &drawing.texts {
        paint_text(&painter, text, rect.min);
    }
    if let Some(at) = response.hover_pos() {
        let local = at - rect.min;
        if let Some(x) = drawing.x_at(DVec2::new(local.x.into(), local.y.into())) {
            reading(ui, &painter, plot, drawing, x, (rect, at), style);
        }
    }
}

/// The plot in words, for those who do not see it.
fn described(plot: &Plot) -> String {
    let marks: Vec<&str> = plot.marks.iter().map(|mark| mark.label.as_str()).collect();
    let parts = [plot.title.as_str(), plot.note.as_str()].into_iter().chain(marks);
    parts.collect::<Vec<_>>().join("; ")
}

fn place(point: DVec2, origin: Pos2) -> Pos2 {
    origin + vec2(point.x as f32, point.y as f32)
}

fn colour_of([r, g, b]: [u8; 3], opacity: f64) -> Color32 {
    Color32::from_rgb(r, g, b).gamma_multiply(opacity as f32)
}

pub fn paint_shape(painter: &Painter, line: &Line, origin: Pos2) {
    let colour = colour_of(line.colour, line.opacity);
    let stroke = Stroke::new(line.width as f32, colour);
    let places = line.points.iter().map(|point| lines::exact(origin) + *point);
    if line.fill {
        let points: Vec<Pos2> = line.points.iter().map(|point| place(*point, origin)).collect();
        if !can_be_filled(&places.collect::<Vec<_>>(), &lines::window(painter)) {
            return;
        }
        if line.opacity < 1.0 {
            painter.add(Shape::mesh(fan(&points, colour)));
        } else {
            painter.add(Shape::convex_polygon(points, colour, Stroke::NONE));
        }
    } else {
        let dashes: Vec<f32> = line.dashes.iter().map(|dash| dash * stroke.width).collect();
        lines::line(painter, places, stroke, &dashes);
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
    let at = place(text.at, origin);
    let mut x = at.x - width * text.align as f32;
    for (above, galley) in laid {
        let advance = galley.size().x;
        painter.galley(pos2(x, at.y - above), galley, colour);
        x += advance;
    }
}

/// The values of all curves at `x`, beside the pointer and as dots.
fn reading(
    ui: &Ui,
    painter: &Painter,
    plot: &Plot,
    drawing: &Drawing,
    x: f64,
    (rect, pointer): (Rect, Pos2),
    style: &PlotStyle,
) {
    let visuals = ui.visuals();
    let Some((_, ends)) = drawing.place([x, 0.0]) else { return };
    let ends = ends.map(|end| lines::exact(rect.min) + end);
    lines::line(painter, ends, Stroke::new(1.0, visuals.text_color()), &[]);
    let unit = if plot.x.degrees { "°" } else { "" };
    let symbol = plot.x.name.split(',').next().unwrap_or_default();
    let line = |text: String, colour| Text::new(text, DVec2::ZERO, style.text, colour);
    let mut lines = vec![line(format!("{symbol} = {}{unit}", short(x)), style.paper.text)];
    for curve in &plot.curves {
        let Some(y) = curve.at(x) else { continue };
        lines.push(line(format!("{}: {}", curve.name, short(y)), style.paper.letters(curve.ink)));
        let at = drawing.place([x, y]).map(|(at, _)| place(at, rect.min));
        if let Some(at) = at.filter(|at| y <= plot.y.high && rect.contains(*at)) {
            painter.circle_filled(at, 3.0, colour_of(style.paper.line(curve.ink), 1.0));
        }
    }
    boxed(ui, painter, &lines, (rect, pointer));
}

/// Lines of text in a box beside the pointer, inside `rect`.
pub fn boxed(ui: &Ui, painter: &Painter, lines: &[Text], (rect, pointer): (Rect, Pos2)) {
    let row = lines.first().map_or(0.0, |text| 1.4 * text.size as f32);
    let width = lines.iter().map(|text| text.width() as f32).fold(0.0, f32::max);
    let size = vec2(width, row * lines.len() as f32) + Vec2::splat(12.0);
    let right = pointer.x + 14.0 + size.x <= rect.max.x;
    let x = if right { pointer.x + 14.0 } else { (pointer.x - 14.0 - size.x).max(rect.min.x) };
    let y = (pointer.y - 0.5 * size.y).clamp(rect.min.y, (rect.max.y - size.y).max(rect.min.y));
    let area = Rect::from_min_size(pos2(x, y), size);
    let visuals = ui.visuals();
    let outline = visuals.widgets.noninteractive.bg_stroke;
    painter.rect(area, CornerRadius::same(4), visuals.window_fill, outline, StrokeKind::Inside);
    for (index, text) in lines.iter().enumerate() {
        let at = area.min + vec2(6.0, 6.0 + row * (index as f32 + 0.75));
        paint_text(painter, text, at);
    }
}
