//! A curve over the directions above a surface: the angle from N and the distance from the point.

use super::axes::round_up;
use super::canvas::PlotCanvas;
use super::data::{Axis, Direction};
use crate::figure::area::Area;
use crate::figure::drawing::{Scale, Shape};
use crate::figure::palette::Vector;
use glam::DVec2;

/// Degrees between the spokes.
const SPOKES: [i32; 7] = [-90, -60, -30, 0, 30, 60, 90];
/// Minimum number of rings.
const RINGS: f64 = 4.0;
/// Minimum radius, in ems.
const LEAST: f64 = 3.0;
/// Length of an arrow, in the outermost ring's radius.
const REACH: f64 = 0.94;
/// Opacity of the lobe's area, and of the body below the surface.
const OPAQUE: [f64; 2] = [0.2, 0.5];
/// Half the angle that an arrow's letter must keep free, degrees.
const APART: f64 = 12.0;

/// Draws rings, the lobe and the vectors in `bounds`.
pub fn draw(canvas: &mut PlotCanvas<'_>, bounds: Area) {
    let (em, plot) = (canvas.em, canvas.plot);
    let space = bounds.max - bounds.min - DVec2::new(2.0 * 2.2 * em, 1.5 * em + 2.0 * em);
    let radius = (0.5 * space.x).min(space.y);
    if radius < LEAST * em || !Axis::can_span(0.0, plot.y.high) {
        return;
    }
    let slack = space.y - radius;
    let centre = DVec2::new(
        0.5 * (bounds.min.x + bounds.max.x),
        bounds.min.y + 1.5 * em + radius + 0.4 * slack,
    );
    let step = round_up(plot.y.high / RINGS * 0.8);
    let rings = (plot.y.high / step * (1.0 - 1e-9)).ceil().max(1.0);
    let scale = Scale::Polar {
        centre,
        radius,
        scale: radius / (rings * step),
    };
    ground(canvas, &scale, rings as u32, step);
    for curve in &plot.curves {
        let places: Vec<DVec2> = curve
            .points
            .iter()
            .map(|point| scale.place(*point))
            .collect();
        let at = canvas.drawing.shapes.len();
        canvas.curve(curve, &places);
        if curve.emphasised {
            let line = &canvas.drawing.shapes[at];
            let lobe =
                Shape::area([&[centre][..], &line.points].concat(), line.colour).faded(OPAQUE[0]);
            canvas.drawing.shapes.insert(at, lobe);
        }
    }
    for direction in &plot.directions {
        arrow(canvas, direction, centre, radius);
    }
    canvas.drawing.scales.push(scale);
}

/// Draws the body below the surface, rings with their values, spokes with their angles.
fn ground(canvas: &mut PlotCanvas<'_>, scale: &Scale, rings: u32, step: f64) {
    let (em, paper) = (canvas.em, canvas.paper);
    let high = f64::from(rings) * step;
    let at = |angle: f64, value: f64| scale.place([angle, value]);
    let (below, [left, right]) = (
        DVec2::new(0.0, 0.45 * em),
        [-90.0, 90.0].map(|angle| at(angle, high)),
    );
    canvas.push(
        Shape::area(vec![left, right, right + below, left + below], paper.weak).faded(OPAQUE[1]),
    );
    for spoke in SPOKES {
        let end = at(spoke.into(), high);
        canvas.axis(at(0.0, 0.0), end, paper.grid);
        let out = (end - at(0.0, 0.0)).normalize_or_zero();
        let middle = end + out * DVec2::new(1.25, 0.8) * em;
        canvas.text(
            format!("{}°", spoke.abs()),
            middle + DVec2::new(0.0, 0.3 * em),
            0.92,
            paper.weak,
            0.5,
        );
    }
    // Values that would crowd are omitted, but never the last.
    let apart = (2.6 * em / (at(90.0, step).x - at(90.0, 0.0).x))
        .ceil()
        .max(1.0) as u32;
    let under = DVec2::new(0.0, 1.65 * em);
    for ring in 1..=rings {
        let value = f64::from(ring) * step;
        canvas.line(
            (-45..=45).map(|i| at(f64::from(i) * 2.0, value)).collect(),
            0.08,
            paper.grid,
        );
        if (rings - ring).is_multiple_of(apart) {
            let decimals = (-(step * 1.000_001).log10().floor()).clamp(0.0, 6.0) as usize;
            canvas.text(
                format!("{value:.decimals$}"),
                at(90.0, value) + under,
                0.92,
                paper.weak,
                0.5,
            );
        }
    }
    canvas.text("I = 0", at(0.0, 0.0) + under, 0.92, paper.weak, 0.5);
    canvas.axis(left, right, paper.weak);
}

fn arrow(canvas: &mut PlotCanvas<'_>, direction: &Direction, centre: DVec2, radius: f64) {
    let em = canvas.em;
    let (sine, cosine) = direction.angle.to_radians().sin_cos();
    let along = DVec2::new(sine, -cosine);
    let tip = centre + along * (REACH * radius * direction.length);
    let colour = canvas.paper.line(direction.ink);
    let head = 0.85 * em;
    let vector = Vector::ALL
        .into_iter()
        .find(|vector| vector.letter() == direction.letter);
    canvas
        .line(vec![centre, tip - along * 0.8 * head], 0.15, colour)
        .dashes = vector.map_or(&[], Vector::dashes);
    let (base, side) = (tip - along * head, along.perp() * 0.38 * head);
    canvas.push(Shape::area(vec![tip, base + side, base - side], colour));
    // Where another arrow is close, the letter is placed on the opposite side.
    let close = canvas.plot.directions.iter().find(|other| {
        other.letter != direction.letter
            && (other.angle - direction.angle).abs() < APART
            && other.length > 0.5
    });
    let clockwise = close.map_or(direction.angle >= 0.0, |other| {
        other.angle < direction.angle
    });
    let aside = if clockwise {
        along.perp()
    } else {
        -along.perp()
    };
    let middle = tip - along * 0.5 * em + aside * 0.85 * em;
    let at = middle + DVec2::new(0.0, 0.36 * em);
    canvas
        .over_lines(
            direction.letter,
            at,
            1.1,
            canvas.paper.letters(direction.ink),
            0.5,
        )
        .strong = true;
}
