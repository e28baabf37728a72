//! The picture itself, from the filled pixels up to the letters.

use super::{Label, MOST_LETTERS, Sheet};
use crate::analysis::{Crossing, ScanLevel, ScanPoint, corner_name};
use crate::figure::Area;
use crate::figure::{Drawing, Shape};
use glam::DVec2;

/// Of the scan line, in widths.
const LINE_DASHES: &[f32] = &[4.0, 3.0];
/// Least length of a part of an edge that is lettered, in ems.
const LETTERED_PART: f64 = 1.5;
/// Pixels larger than this, in ems, leave room for every share.
const ROOMY: f64 = 1.2;

/// Draws the state at `step`.
pub fn draw(drawing: &mut Drawing, sheet: &Sheet<'_>, step: usize) {
    let point = sheet.scan.at(step);
    fill_pixels(drawing, sheet, step);
    grid_lines(drawing, sheet);
    outline(drawing, sheet);
    scan_line(drawing, sheet, &point);
    active_edges(drawing, sheet, &point);
    span(drawing, sheet, &point);
    letters(drawing, sheet, &point);
}

fn fill_pixels(drawing: &mut Drawing, sheet: &Sheet<'_>, step: usize) {
    for (y, pixel) in sheet.scan.filled(step) {
        drawing.shapes.push(Shape::area(sheet.square([pixel.x, y]).corners(), pixel.stored));
    }
}

fn grid_lines(drawing: &mut Drawing, sheet: &Sheet<'_>) {
    let [columns, rows] = [sheet.scan.grid.columns, sheet.scan.grid.rows].map(f64::from);
    let width = (0.06 * sheet.em).min(0.12 * sheet.cell);
    let mut line = |from: [f64; 2], to: [f64; 2]| {
        let ends = [from, to].map(|place| sheet.at(DVec2::from(place))).to_vec();
        drawing.shapes.push(Shape::line(ends, width, sheet.paper.grid));
    };
    for x in 0..=sheet.scan.grid.columns {
        line([f64::from(x), 0.0], [f64::from(x), rows]);
    }
    for y in 0..=sheet.scan.grid.rows {
        line([0.0, f64::from(y)], [columns, f64::from(y)]);
    }
}

fn outline(drawing: &mut Drawing, sheet: &Sheet<'_>) {
    let mut places: Vec<DVec2> = sheet.scan.corners.iter().map(|corner| sheet.at(corner.place)).collect();
    places.extend(places.first().copied());
    sheet.cased(drawing, places, 0.12 * sheet.em, sheet.paper.weak);
}

/// The line through the centres of its pixels, with a dot at each centre of the spans.
fn scan_line(drawing: &mut Drawing, sheet: &Sheet<'_>, point: &ScanPoint<'_>) {
    let (y, columns) = (point.line.at(), f64::from(sheet.scan.grid.columns));
    let ends = [0.0, columns].map(|x| sheet.at(DVec2::new(x, y)));
    let width = if point.level == ScanLevel::Line { 0.16 } else { 0.1 } * sheet.em;
    drawing.shapes.push(Shape::line(ends.to_vec(), width + 0.12 * sheet.em, sheet.paper.ground));
    drawing.shapes.push(Shape::line(ends.to_vec(), width, sheet.paper.text).dashed(LINE_DASHES));
    if sheet.cell < 0.8 * sheet.em {
        return;
    }
    for x in 0..sheet.scan.grid.columns {
        let centre = sheet.at(DVec2::new(f64::from(x) + 0.5, y));
        drawing.shapes.push(Shape::disc(centre, 0.17 * sheet.em, sheet.paper.ground));
        drawing.shapes.push(Shape::disc(centre, 0.1 * sheet.em, sheet.paper.text));
    }
}

/// The edges that the line crosses, those of the present span divided in the ratio α : 1−α.
fn active_edges(drawing: &mut Drawing, sheet: &Sheet<'_>, point: &ScanPoint<'_>) {
    for &edge in &point.line.active {
        let [from, to] = sheet.scan.edges[edge].corners.map(|corner| sheet.at(sheet.scan.corners[corner].place));
        sheet.cased(drawing, vec![from, to], 0.24 * sheet.em, sheet.paper.text);
        let found = [point.p, point.q].into_iter().flatten().find(|crossing| crossing.edge == edge);
        if let Some(crossing) = found {
            let here = sheet.at(DVec2::new(crossing.x, point.line.at()));
            drawing.shapes.push(Shape::line(vec![from, here], 0.3 * sheet.em, sheet.alpha()));
        }
    }
}

/// The way from P to the present pixel and on to Q, and the pixel.
fn span(drawing: &mut Drawing, sheet: &Sheet<'_>, point: &ScanPoint<'_>) {
    let (Some(p), Some(q)) = (point.p, point.q) else { return };
    let place = |x: f64| sheet.at(DVec2::new(x, point.line.at()));
    let (from, to) = (place(p.x), place(q.x));
    sheet.cased(drawing, vec![from, to], 0.2 * sheet.em, sheet.paper.text);
    let Some(pixel) = point.pixel else { return };
    let here = place(f64::from(pixel.x) + 0.5);
    drawing.shapes.push(Shape::line(vec![from, here], 0.26 * sheet.em, sheet.alpha()));
    let mut square = sheet.square([pixel.x, point.line.y]).corners();
    square.extend(square.first().copied());
    sheet.cased(drawing, square, 0.2 * sheet.em, sheet.paper.text);
    drawing.shapes.push(Shape::disc(here, 0.3 * sheet.em, sheet.paper.ground));
    drawing.shapes.push(Shape::disc(here, 0.2 * sheet.em, sheet.alpha()));
}

/// P and Q, the corners, and α beside what it divides, in the order in which they take their places.
fn letters(drawing: &mut Drawing, sheet: &Sheet<'_>, point: &ScanPoint<'_>) {
    let mut taken = Vec::new();
    let place = |x: f64| sheet.at(DVec2::new(x, point.line.at()));
    if let Some(pixel) = point.pixel {
        taken.push(sheet.square([pixel.x, point.line.y]));
    }
    let found = [("P", -1.0, point.p), ("Q", 1.0, point.q)];
    for (letter, side, crossing) in found {
        let Some(crossing) = crossing else { continue };
        let at = place(crossing.x);
        drawing.shapes.push(Shape::disc(at, 0.42 * sheet.em, sheet.paper.ground));
        drawing.shapes.push(Shape::disc(at, 0.3 * sheet.em, sheet.alpha()));
        // Clear of the edge's upper part, which is the one that matters.
        let leans = side * (sheet.scan.edges[crossing.edge].x_top - crossing.x) > 0.0;
        let rise = if leans { 0.85 } else { -0.85 };
        let beside = [rise, -rise, 0.0].map(|rise| at + DVec2::new(side * 1.15, rise) * sheet.em);
        let label = Label { text: letter.to_owned(), colour: sheet.paper.text, size: 1.3 * sheet.em };
        sheet.label(drawing, &mut taken, label, &beside, true);
    }
    corner_letters(drawing, sheet, point, &mut taken);
    for (_, side, crossing) in found {
        if let Some(crossing) = crossing {
            edge_shares(drawing, sheet, crossing, place(crossing.x), side, point.pixel.is_none(), &mut taken);
        }
    }
    if let (Some(p), Some(q), Some(pixel)) = (point.p, point.q, point.pixel) {
        let (from, here, to) = (place(p.x), place(f64::from(pixel.x) + 0.5), place(q.x));
        let away = DVec2::new(0.0, 0.5 * sheet.cell + 0.8 * sheet.em);
        share(drawing, sheet, [from, here], away, pixel.alpha, true, &mut taken);
        share(drawing, sheet, [here, to], away, 1.0 - pixel.alpha, false, &mut taken);
    }
}

fn corner_letters(drawing: &mut Drawing, sheet: &Sheet<'_>, point: &ScanPoint<'_>, taken: &mut Vec<Area>) {
    let scan = sheet.scan;
    let active = |corner: usize| point.line.active.iter().any(|&edge| scan.edges[edge].corners.contains(&corner));
    let middle = sheet.middle();
    for (index, corner) in scan.corners.iter().enumerate() {
        if scan.corners.len() > MOST_LETTERS && !active(index) {
            continue;
        }
        let at = sheet.at(corner.place);
        let outwards = (at - middle).normalize_or_zero();
        let colour = if active(index) { sheet.paper.text } else { sheet.paper.weak };
        drawing.shapes.push(Shape::disc(at, 0.22 * sheet.em, colour));
        let places = [-0.0f64, 0.7, -0.7, 1.4, -1.4]
            .map(|turn| at + DVec2::from_angle(turn).rotate(outwards) * DVec2::new(1.25, 1.05) * sheet.em);
        let label = Label { text: corner_name(index), colour, size: 1.05 * sheet.em };
        sheet.label(drawing, taken, label, &places, scan.corners.len() <= MOST_LETTERS);
    }
}

/// α and 1−α beside the two parts of an edge.
fn edge_shares(
    drawing: &mut Drawing,
    sheet: &Sheet<'_>,
    crossing: &Crossing,
    at: DVec2,
    side: f64,
    latest: bool,
    taken: &mut Vec<Area>,
) {
    let [top, bottom] =
        sheet.scan.edges[crossing.edge].corners.map(|corner| sheet.at(sheet.scan.corners[corner].place));
    let along = (bottom - top).normalize_or_zero();
    // Outwards, as far as the label's own extent asks.
    let outwards = DVec2::new(side * along.y, -side * along.x);
    let aside = outwards * (1.75 * outwards.x.abs() + 0.95 * outwards.y.abs()) * sheet.em;
    share(drawing, sheet, [top, at], aside, crossing.alpha, true, taken);
    // Once pixels are shaded, small pictures have no room for more than α.
    if latest || sheet.cell > ROOMY * sheet.em {
        share(drawing, sheet, [at, bottom], aside, 1.0 - crossing.alpha, false, taken);
    }
}

/// The number of a part, beside its middle or on its other side, where it is long enough and nothing else is there.
fn share(
    drawing: &mut Drawing,
    sheet: &Sheet<'_>,
    [from, to]: [DVec2; 2],
    aside: DVec2,
    value: f64,
    alpha: bool,
    taken: &mut Vec<Area>,
) {
    if from.distance(to) < LETTERED_PART * sheet.em {
        return;
    }
    let (text, colour) = if alpha {
        (format!("α {value:.2}"), sheet.alpha_letters())
    } else {
        (format!("{value:.2}"), sheet.paper.text)
    };
    let middle = (from + to) * 0.5;
    let label = Label { text, colour, size: 0.95 * sheet.em };
    sheet.label(drawing, taken, label, &[middle + aside, middle - aside], false);
}
