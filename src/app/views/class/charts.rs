//! The answers of a class over one another: curves on their axes, clicks over the picture, numbers as dots over their range.

use crate::class::Round;
use crate::figure::palette::Rgb8;
use crate::figure::{Drawing, PlotStyle, Shape};
use crate::lesson::{Answer, Curve, CurveAxes, abscissa};
use crate::scene::place_to_pixel;
use glam::DVec2;

/// The colours of answers.
#[derive(Clone, Copy, Debug)]
pub struct Colours {
    /// The colour of every answer.
    pub answer: Rgb8,
    /// The colour of the right answer.
    pub right: Rgb8,
}

/// The radius of a click and of a number's dot, in letter sizes.
const DOT: f64 = 0.38;
/// The most that a curve covers of those below it, and the least, in a large class.
const OPACITY: [f64; 2] = [0.75, 0.12];

/// Draws the curves of a round, and through them the right one.
pub fn curves(
    curve: &Curve,
    names: [&str; 2],
    round: &Round,
    right: Option<&[[f64; 2]]>,
    (size, style, colours): (DVec2, &PlotStyle, Colours),
) -> Drawing {
    let mut drawing = CurveAxes::new([curve.x, curve.y], names).lay_out(size, style);
    let line = 0.12 * style.text;
    let opacity = opacity(round.answers.len());
    for graded in &round.answers {
        if let Answer::Curve(values) = &graded.answer {
            let points = values.iter().enumerate();
            let points = points.map(|(index, y)| [abscissa(curve.x, index), y.unwrap_or(f64::NAN)]);
            drawing.draw_curve(points, line, colours.answer, opacity);
        }
    }
    if let Some(right) = right {
        // On a ground of its own, it is seen through any number of others.
        let points = || right.iter().copied();
        drawing.draw_curve(points(), 4.0 * line, style.paper.ground, 1.0);
        drawing.draw_curve(points(), 2.2 * line, colours.right, 1.0);
    }
    drawing
}

/// Returns how far lines cover one another: where many are, all of them together do.
fn opacity(count: usize) -> f64 {
    let [most, least] = OPACITY;
    (6.0 / count.max(1) as f64).clamp(least, most)
}

/// Draws the clicks of a round over a picture of this size, and the right places.
pub fn clicks(
    round: &Round,
    right: Option<&[DVec2]>,
    tolerance: f64,
    (size, letters, colours): (DVec2, f64, Colours),
) -> Drawing {
    let mut drawing = Drawing::over_picture([0x10; 3], 0.1 * letters);
    drawing.size = size;
    let side = size.min_element();
    let at = |place: DVec2| place_to_pixel(place, size);
    for graded in &round.answers {
        if let Answer::Point(place) = graded.answer {
            let place = at(DVec2::from_array(place)).clamp(DVec2::ZERO, size);
            let dot = Shape::disc(place, DOT * letters, colours.answer);
            drawing.shapes.push(dot.faded(0.8));
        }
    }
    match right {
        Some([only]) => {
            let ring = Shape::ring(at(*only), tolerance * side, 0.2 * letters, colours.right);
            drawing.shapes.push(ring);
        }
        Some(places) => drawing.shapes.extend(
            places
                .iter()
                .map(|place| Shape::disc(at(*place), 0.2 * letters, colours.right)),
        ),
        None => {}
    }
    drawing
}

/// The numbers of a question and what is right.
#[derive(Clone, Copy, Debug)]
pub struct Range<'r> {
    /// The ends of the axis.
    pub ends: [f64; 2],
    /// The name of the axis.
    pub name: &'r str,
    /// The name of the other one.
    pub count: &'r str,
    /// The right number, and how far from it is right too.
    pub right: Option<[f64; 2]>,
}

/// Draws the numbers of a round as dots over their range, one above the other; `most`: how many stand above one another at most in
/// the rounds beside it.
pub fn numbers(
    range: Range<'_>,
    values: &[f64],
    most: usize,
    (size, style, colours): (DVec2, &PlotStyle, Colours),
) -> Drawing {
    let top = most.max(4) as f64;
    let axes = CurveAxes::new([range.ends, [0.0, top]], [range.name, range.count]);
    let mut drawing = axes.lay_out(size, style);
    let place = |drawing: &Drawing, x: f64, y: f64| drawing.place([x, y]).unwrap_or_default().0;
    let [from, to] = range.ends;
    if let Some([right, tolerance]) = range.right {
        let ends = [right - tolerance, right + tolerance].map(|end| end.clamp(from, to));
        let corners = [(0, 0.0), (1, 0.0), (1, top), (0, top)];
        let corners = corners.map(|(end, y): (usize, f64)| place(&drawing, ends[end], y));
        let band = Shape::area(corners.to_vec(), colours.right).faded(0.25);
        drawing.shapes.push(band);
        let line = [0.0, top].map(|y| place(&drawing, right, y));
        let line = Shape::line(line.to_vec(), 0.15 * style.text, colours.right);
        drawing.shapes.push(line);
    }
    let rise = place(&drawing, from, 0.0).y - place(&drawing, from, 1.0).y;
    let wide = place(&drawing, to, 0.0).x - place(&drawing, from, 0.0).x;
    let radius = (DOT * style.text)
        .min(0.5 * rise)
        .min(0.5 * wide / COLUMNS as f64);
    for (column, height) in stacked(range.ends, values) {
        let x = from + (to - from) * (column as f64 + 0.5) / COLUMNS as f64;
        let at = place(&drawing, x, height as f64 + 0.5);
        drawing.shapes.push(Shape::disc(at, radius, colours.answer));
    }
    drawing
}

/// The columns that dots stand in.
const COLUMNS: usize = 40;

/// Returns the column of each number and how many stand below it.
fn stacked([from, to]: [f64; 2], values: &[f64]) -> Vec<(usize, usize)> {
    let mut heights = [0; COLUMNS];
    let column = |value: &f64| {
        let along = ((value - from) / (to - from)).clamp(0.0, 1.0);
        ((along * COLUMNS as f64) as usize).min(COLUMNS - 1)
    };
    let place = |value: &f64| {
        let column = column(value);
        heights[column] += 1;
        (column, heights[column] - 1)
    };
    values.iter().map(place).collect()
}

/// Returns how many numbers stand above one another at most.
pub fn highest(ends: [f64; 2], values: &[f64]) -> usize {
    let heights = stacked(ends, values).into_iter();
    heights.map(|(_, height)| height + 1).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::class::Graded;
    use crate::figure::Paper;
    use crate::lesson::Grade;

    const SIZE: DVec2 = DVec2::new(400.0, 300.0);
    const COLOURS: Colours = Colours {
        answer: [200, 100, 0],
        right: [0, 120, 60],
    };
    const STYLE: PlotStyle = PlotStyle {
        paper: Paper::LIGHT,
        text: 14.0,
        titled: false,
    };

    fn round(answers: &[Answer]) -> Round {
        let graded = |answer: &Answer| Graded {
            student: 1,
            answer: answer.clone(),
            grade: Grade::default(),
        };
        Round {
            answers: answers.iter().map(graded).collect(),
        }
    }

    fn of(drawing: &Drawing, colour: Rgb8) -> Vec<&Shape> {
        let shapes = drawing.shapes.iter();
        shapes.filter(|shape| shape.colour == colour).collect()
    }

    #[test]
    fn clicks_stand_where_they_were_made_and_the_right_place_only_where_it_may_be_seen() {
        let given = round(&[Answer::Point([0.0, 0.0]), Answer::Point([0.5, -0.5])]);
        let drawn = |right| clicks(&given, right, 0.1, (SIZE, 14.0, COLOURS));
        let (hidden, shown) = (drawn(None), drawn(Some(&[DVec2::ZERO][..])));
        let dots = of(&hidden, COLOURS.answer);
        let middle = |shape: &Shape| shape.points.iter().sum::<DVec2>() / shape.points.len() as f64;
        assert!(middle(dots[0]).abs_diff_eq(SIZE / 2.0, 1e-6));
        assert!(middle(dots[1]).abs_diff_eq(DVec2::new(350.0, 0.0), 1e-6));
        assert!(of(&hidden, COLOURS.right).is_empty());
        let ring = of(&shown, COLOURS.right);
        assert!((ring[0].points[0].distance(SIZE / 2.0) - 30.0).abs() < 1e-6);
    }

    #[test]
    fn equal_numbers_stand_above_one_another_and_what_is_out_of_range_at_its_ends() {
        let values = [0.5, 0.5, 0.51, 7.0, -3.0];
        assert_eq!(highest([0.0, 1.0], &values), 3);
        assert_eq!(
            stacked([0.0, 1.0], &values),
            [(20, 0), (20, 1), (20, 2), (COLUMNS - 1, 0), (0, 0)]
        );
        let range = Range {
            ends: [0.0, 1.0],
            name: "x",
            count: "n",
            right: Some([0.25, 0.05]),
        };
        let drawing = numbers(range, &values, 3, (SIZE, &STYLE, COLOURS));
        assert_eq!(of(&drawing, COLOURS.answer).len(), 5);
        assert_eq!(
            of(&drawing, COLOURS.right).len(),
            2,
            "the band and its middle"
        );
    }

    #[test]
    fn a_large_class_of_curves_is_seen_through() {
        assert!(opacity(3) > opacity(30) && opacity(30) > opacity(1000));
        assert!((opacity(1000) - OPACITY[1]).abs() < 1e-9);
    }
}
