//! A curve over the directions above a surface: the angle from N and the distance from the point.

use super::axes::round_up;
use super::cartesian::thinned;
use super::data::{Direction, Plot};
use super::{PlotStyle, dashes};
use crate::figure::drawing::{Drawing, Shape, Text};
use crate::figure::labels::Area;
use crate::figure::palette::Vector;
use crate::figure::scale::Scale;
use glam::DVec2;

/// Degrees between the spokes.
const SPOKES: [i32; 7] = [-90, -60, -30, 0, 30, 60, 90];
/// Rings, at least.
const RINGS: f64 = 4.0;
/// Least radius, in ems.
const LEAST: f64 = 3.0;
/// How far an arrow reaches, in the outermost ring's radius.
const REACH: f64 = 0.94;
/// The lobe's area, and the body below the surface, are so opaque.
const OPAQUE: [f64; 2] = [0.2, 0.5];
/// Half the angle that an arrow's letter must have to itself, degrees.
const APART: f64 = 12.0;

/// Draws rings, the lobe and the vectors in `room`.
pub fn draw(drawing: &mut Drawing, plot: &Plot, room: Area, style: &PlotStyle) {
    let em = style.text;
    let space = room.max - room.min - DVec2::new(2.0 * 2.2 * em, 1.5 * em + 2.0 * em);
    let radius = (0.5 * space.x).min(space.y);
    if radius < LEAST * em || plot.y.high.is_nan() || plot.y.high <= 0.0 {
        return;
    }
    let slack = space.y - radius;
    let centre = DVec2::new(0.5 * (room.min.x + room.max.x), room.min.y + 1.5 * em + radius + 0.4 * slack);
    let step = round_up(plot.y.high / RINGS * 0.8);
    let rings = (plot.y.high / step * (1.0 - 1e-9)).ceil().max(1.0);
    let scale = Scale::Polar { centre, radius, scale: radius / (rings * step) };
    ground(drawing, &scale, rings as u32, step, style);
    lobe(drawing, plot, &scale, style);
    for direction in &plot.directions {
        arrow(drawing, direction, &plot.directions, centre, radius, style);
    }
    drawing.scales.push(scale);
}

/// The body below the surface, rings with their values, spokes with their angles.
fn ground(drawing: &mut Drawing, scale: &Scale, rings: u32, step: f64, style: &PlotStyle) {
    let (em, paper) = (style.text, &style.paper);
    let high = f64::from(rings) * step;
    let at = |angle: f64, value: f64| scale.place([angle, value]);
    let below = DVec2::new(0.0, 0.45 * em);
    let body = vec![at(-90.0, high), at(90.0, high), at(90.0, high) + below, at(-90.0, high) + below];
    drawing.shapes.push(Shape::area(body, paper.weak).faded(OPAQUE[1]));
    for spoke in SPOKES {
        let ends = vec![at(0.0, 0.0), at(spoke.into(), high)];
        drawing.shapes.push(Shape::line(ends, style.axis(), paper.grid));
        let out = (at(spoke.into(), high) - at(0.0, 0.0)).normalize_or_zero();
        let middle = at(spoke.into(), high) + out * DVec2::new(1.25, 0.8) * em;
        let label = Text::new(format!("{}°", spoke.abs()), middle + DVec2::new(0.0, 0.3 * em), 0.92 * em, paper.weak);
        drawing.texts.push(label.aligned(0.5));
    }
    // Values that would crowd are left out, the last never.
    let apart = (2.6 * em / (at(90.0, step).x - at(90.0, 0.0).x)).ceil().max(1.0) as u32;
    for ring in 1..=rings {
        let value = f64::from(ring) * step;
        let arc = (-45..=45).map(|i| at(f64::from(i) * 2.0, value)).collect();
        drawing.shapes.push(Shape::line(arc, style.axis(), paper.grid));
        if (rings - ring).is_multiple_of(apart) {
            let place = at(90.0, value) + DVec2::new(0.0, 1.65 * em);
            let decimals = (-(step * 1.000_001).log10().floor()).clamp(0.0, 6.0) as usize;
            drawing.texts.push(Text::new(format!("{value:.decimals$}"), place, 0.92 * em, paper.weak).aligned(0.5));
        }
    }
    let origin = at(0.0, 0.0) + DVec2::new(0.0, 1.65 * em);
    drawing.texts.push(Text::new("I = 0", origin, 0.92 * em, paper.weak).aligned(0.5));
    drawing.shapes.push(Shape::line(vec![at(-90.0, high), at(90.0, high)], style.axis(), paper.weak));
}

fn lobe(drawing: &mut Drawing, plot: &Plot, scale: &Scale, style: &PlotStyle) {
    for curve in &plot.curves {
        let places: Vec<DVec2> = curve.points.iter().map(|point| scale.place(*point)).collect();
        let places = thinned(&places);
        let colour = style.paper.line(curve.ink);
        let line = Shape::line(places.clone(), style.curve(curve.emphasised), colour).dashed(dashes(curve.dash));
        if curve.emphasised {
            let area = std::iter::once(scale.place([0.0, 0.0])).chain(places).collect();
            drawing.shapes.push(Shape::area(area, colour).faded(OPAQUE[0]));
        }
        drawing.shapes.push(line);
    }
}

fn arrow(
    drawing: &mut Drawing,
    direction: &Direction,
    all: &[Direction],
    centre: DVec2,
    radius: f64,
    style: &PlotStyle,
) {
    let em = style.text;
    let (sine, cosine) = direction.angle.to_radians().sin_cos();
    let along = DVec2::new(sine, -cosine);
    let tip = centre + along * (REACH * radius * direction.length);
    let (colour, width) = (style.paper.line(direction.ink), 0.15 * em);
    let head = 0.85 * em;
    let dashes =
        Vector::ALL.into_iter().find(|vector| vector.letter() == direction.letter).map_or(&[][..], Vector::dashes);
    drawing.shapes.push(Shape::line(vec![centre, tip - along * 0.8 * head], width, colour).dashed(dashes));
    let (base, side) = (tip - along * head, along.perp() * 0.38 * head);
    drawing.shapes.push(Shape::area(vec![tip, base + side, base - side], colour));
    // Where another arrow is close, the letter stands on the side away from it.
    let close = all.iter().find(|other| {
        other.letter != direction.letter && (other.angle - direction.angle).abs() < APART && other.length > 0.5
    });
    let clockwise = close.map_or(direction.angle >= 0.0, |other| other.angle < direction.angle);
    let aside = if clockwise { along.perp() } else { -along.perp() };
    let middle = tip - along * 0.5 * em + aside * 0.85 * em;
    let letter =
        Text::new(direction.letter, middle + DVec2::new(0.0, 0.36 * em), 1.1 * em, style.paper.letters(direction.ink));
    drawing.texts.push(letter.bold().with_halo().aligned(0.5));
}
