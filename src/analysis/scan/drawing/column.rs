//! The title of a figure that stands alone, and its column of formulas.

use super::MOST_LETTERS;
use crate::analysis::{Carried, Mix, Scan, ScanLevel};
use crate::figure::Area;
use crate::figure::palette::Rgb8;
use crate::figure::{Drawing, PlotStyle, Shape, Text};
use crate::scene::ShadingMode;
use glam::DVec2;

/// Width of the column beside a wide figure, in ems.
const WIDTH: f64 = 19.5;
/// Height of the formulas below a narrow one.
const HEIGHT: f64 = 33.0;

/// A part of the column: a swatch where it has a colour, a heading and lines.
struct Block {
    swatch: Option<Rgb8>,
    heading: String,
    lines: Vec<String>,
}

/// Draws title and column; returns the room that is left for the picture.
pub fn draw(drawing: &mut Drawing, scan: &Scan, step: usize, room: Area, style: &PlotStyle) -> Area {
    let em = style.text;
    let mut rest = Area { min: room.min + em, max: room.max - em };
    rest.min.y += 1.2 * em;
    drawing.texts.push(Text::new(title(scan), rest.min, 1.25 * em, style.paper.text).bold());
    rest.min.y += 1.45 * em;
    drawing.texts.push(Text::new(scan.caption(step), rest.min, em, style.paper.weak));
    rest.min.y += 0.7 * em;
    let extent = rest.max - rest.min;
    let wide = extent.x > extent.y;
    let column = if wide {
        DVec2::new(rest.max.x - WIDTH * em, rest.min.y)
    } else {
        DVec2::new(rest.min.x, rest.max.y - HEIGHT * em)
    };
    let mut at = column + DVec2::new(0.0, 0.4 * em);
    for block in blocks(scan, step) {
        at.y = draw_block(drawing, &block, at, style);
    }
    if wide {
        rest.max.x = column.x - em;
    } else {
        rest.max.y = column.y - em;
    }
    rest
}

fn title(scan: &Scan) -> String {
    let mode = match scan.mode {
        ShadingMode::Flat => "flat",
        ShadingMode::Interpolated => "interpolated",
        ShadingMode::Gouraud => "Gouraud",
        ShadingMode::Phong | ShadingMode::Exact => "Phong",
    };
    format!("The scan line in slow motion: {mode} shading, face {}", scan.face)
}

/// What has been found at a step.
fn blocks(scan: &Scan, step: usize) -> Vec<Block> {
    let point = scan.at(step);
    let mut blocks = Vec::new();
    if point.level == ScanLevel::Line {
        let lines = scan.edges.iter().enumerate().take(MOST_LETTERS).map(|(index, edge)| {
            let mark = if point.line.active.contains(&index) { "active" } else { "" };
            let (name, slope) = (scan.edge_name(index), format!("{:.2}", edge.dx_dy).replace('-', "−"));
            format!("{name}  y {:.2} to {:.2}, dx/dy {slope}  {mark}", edge.y_top, edge.y_bottom)
        });
        blocks.push(Block { swatch: None, heading: "Edge table".to_owned(), lines: lines.collect() });
    }
    for (of, crossing) in [("P", point.p), ("Q", point.q)] {
        let Some(crossing) = crossing else { continue };
        let heading = format!("{of} on {}", scan.edge_name(crossing.edge));
        let lines = lines_of(scan, &scan.crossing_mix(point.line, crossing, of));
        blocks.push(Block { swatch: crossing.stored, heading, lines });
    }
    if let (Some(span), Some(pixel)) = (point.span, point.pixel) {
        let mut lines = lines_of(scan, &scan.pixel_mix(span, pixel));
        lines.extend(scan.pixel_words(pixel));
        blocks.push(Block {
            swatch: Some(pixel.stored),
            heading: format!("Pixel ({}, {})", pixel.x, point.line.y),
            lines,
        });
    }
    blocks
}

fn lines_of(scan: &Scan, mix: &Mix) -> Vec<String> {
    if scan.carried == Carried::Constant {
        return vec![mix.alpha_text(), "I is the polygon's own".to_owned()];
    }
    let mut lines = vec![mix.alpha_text(), mix.formula(scan.carried.letter())];
    let components = scan.carried.components().into_iter().enumerate();
    lines.extend(components.map(|(index, name)| format!("{name}\t{}", mix.row(index))));
    lines
}

fn draw_block(drawing: &mut Drawing, block: &Block, at: DVec2, style: &PlotStyle) -> f64 {
    let em = style.text;
    let mut y = at.y + 1.1 * em;
    let mut x = at.x;
    if let Some(colour) = block.swatch {
        let (min, max) = (DVec2::new(x, y - 0.95 * em), DVec2::new(x + 1.5 * em, y + 0.25 * em));
        let square = Area { min, max }.corners();
        drawing.shapes.push(Shape::area(square.clone(), colour));
        drawing.shapes.push(Shape::line([square, vec![min]].concat(), 0.06 * em, style.paper.weak));
        x += 2.0 * em;
    }
    drawing.texts.push(Text::new(&block.heading, DVec2::new(x, y), 1.05 * em, style.paper.text).bold());
    for line in &block.lines {
        y += 1.28 * em;
        // What stands behind a tabulator begins at the same place in every line.
        let (first, rest) = line.split_once('\t').map_or((line.as_str(), None), |(first, rest)| (first, Some(rest)));
        for (text, x) in [(Some(first), at.x), (rest, at.x + em)] {
            let text = text.map(|text| Text::new(text, DVec2::new(x, y), 0.88 * em, style.paper.text));
            drawing.texts.extend(text);
        }
    }
    y + 0.75 * em
}
