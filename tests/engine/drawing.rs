//! Drawings: clipping, positions of labels, pixels, SVG text, letters and the round numbers of axes.

use glam::DVec2;
use shading_lab::figure::palette::{Rgb8, contrast};
use shading_lab::figure::{
    Area, Axis, Drawing, Paper, Placer, Plot, PlotKind, PlotStyle, Run, Shape, Text, Wish,
    can_be_filled, clipped, lay_out, round_up, short, ticks,
};
use tiny_skia::Pixmap;

const AREA: Area = Area {
    min: DVec2::ZERO,
    max: DVec2::splat(10.0),
};
const BOUNDS: Area = Area {
    min: DVec2::ZERO,
    max: DVec2::splat(100.0),
};
const RED: Rgb8 = [255, 0, 0];

fn points<const N: usize>(points: [(f64, f64); N]) -> Vec<DVec2> {
    points.map(|(x, y)| DVec2::new(x, y)).to_vec()
}

#[test]
fn a_line_that_leaves_and_returns_is_two_lines() {
    let runs = clipped(
        points([(0.0, 5.0), (4.0, -5.0), (8.0, 5.0), (9.0, 5.0)]),
        &AREA,
    );
    assert_eq!(runs.len(), 2, "{runs:?}");
    assert_eq!(
        (runs[0].points[1], runs[1].points[0]),
        (DVec2::new(2.0, 0.0), DVec2::new(6.0, 0.0))
    );
    assert_eq!((runs[0].start, runs[1].points.len()), (0.0, 3));
    assert!(
        (runs[1].start - 1.5 * 116.0_f64.sqrt()).abs() < 1e-9,
        "{}",
        runs[1].start
    );
}

#[test]
fn whatever_the_numbers_what_is_left_is_inside() {
    let numbers = [
        0.0,
        5.0,
        -7.0,
        1e18,
        -1e30,
        1e300,
        f64::MAX,
        -f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    let all = || {
        numbers
            .iter()
            .flat_map(|x| numbers.iter().map(move |y| (*x, *y)))
    };
    for (a, b) in all().flat_map(|a| all().map(move |b| (a, b))) {
        for run in clipped(points([a, b, (5.0, 5.0)]), &AREA) {
            let inside = |p: &DVec2| AREA.holds(&Area { min: *p, max: *p });
            assert!(run.points.iter().all(inside), "{a:?} {b:?}: {run:?}");
        }
    }
}

#[test]
fn a_segment_to_an_end_far_away_keeps_its_direction() {
    for far in [1e6, 1e18, 1e300] {
        let seen = clipped(points([(5.0, 5.0), (5.0, far)]), &AREA);
        assert_eq!(
            seen,
            [Run {
                points: points([(5.0, 5.0), (5.0, 10.0)]),
                start: 0.0
            }]
        );
    }
}

#[test]
fn a_shape_beyond_all_proportion_is_not_filled() {
    let triangle = |size: f64| [DVec2::ZERO, DVec2::new(size, 0.0), DVec2::new(0.0, size)];
    assert!(can_be_filled(&triangle(20.0), &AREA));
    for size in [1e9, f64::INFINITY, f64::NAN] {
        assert!(!can_be_filled(&triangle(size), &AREA), "{size}");
    }
    assert!(
        !can_be_filled(&triangle(2.0).map(|point| point - 50.0), &AREA),
        "out of sight"
    );
}

#[test]
fn the_covered_length_of_a_segment() {
    for (from, to, length) in [
        ((-5.0, 5.0), (5.0, 5.0), 5.0),
        ((-5.0, 15.0), (5.0, 15.0), 0.0),
        ((0.0, 0.0), (10.0, 0.0), 0.0),
        ((-3.0, -4.0), (3.0, 4.0), 5.0),
    ] {
        assert!(
            (AREA.covers(DVec2::from(from), DVec2::from(to)) - length).abs() < 1e-12,
            "{from:?} {to:?}"
        );
    }
}

fn placer(shapes: &[Shape]) -> Placer {
    Placer::new(BOUNDS, 10.0, shapes, vec![])
}

fn wish(x: f64, y: f64) -> Wish {
    Wish {
        anchor: DVec2::new(x, y),
        direction: DVec2::X,
        size: DVec2::new(20.0, 10.0),
        clearance: 2.0,
    }
}

#[test]
fn a_label_stands_where_it_wants_when_there_is_room() {
    let place = Area::about(DVec2::new(62.0, 50.0), DVec2::new(20.0, 10.0));
    assert_eq!(placer(&[]).place(&wish(50.0, 50.0)), Some(place));
    let area = Placer::new(BOUNDS, 10.0, &[], vec![place])
        .place(&wish(50.0, 50.0))
        .expect("room enough");
    assert!(!area.overlaps(&place));
}

#[test]
fn a_label_avoids_a_line() {
    let line = Shape::line(points([(50.0, 50.0), (100.0, 50.0)]), 1.0, [0; 3]);
    let area = placer(&[line])
        .place(&wish(50.0, 50.0))
        .expect("room enough");
    assert!(area.max.y <= 50.0 || area.min.y >= 50.0, "{area:?}");
}

#[test]
fn labels_fill_the_picture_without_overlap_and_then_give_up() {
    let mut placer = placer(&[]);
    let placed: Vec<Area> = (0..100)
        .map_while(|_| placer.place(&wish(95.0, 5.0)))
        .collect();
    assert!(
        (10..=50).contains(&placed.len()),
        "{} labels of 200 pixels in 10000",
        placed.len()
    );
    for (i, a) in placed.iter().enumerate() {
        assert!(BOUNDS.holds(a));
        assert!(placed.iter().skip(i + 1).all(|b| !a.overlaps(b)));
    }
}

#[test]
fn a_label_larger_than_the_picture_is_left_out() {
    let large = Wish {
        size: DVec2::splat(101.0),
        ..wish(50.0, 50.0)
    };
    assert_eq!(placer(&[]).place(&large), None);
}

fn drawn(width: u32, height: u32, shapes: &[Shape]) -> Pixmap {
    let mut pixmap = Pixmap::new(width, height).expect("not empty");
    let mut drawing = Drawing::over_picture([0, 0, 255], 2.0);
    drawing.shapes = shapes.to_vec();
    drawing.draw(&mut pixmap.as_mut());
    pixmap
}

/// Formats the pixels as rows of `#` for the shape's colour, `+` for the halo's and `.` for neither; coverage below half a pixel
/// counts as none.
fn ascii(pixmap: &Pixmap) -> Vec<String> {
    let symbol = |p: &tiny_skia::PremultipliedColorU8| match (p.red() > 127, p.blue() > 127) {
        (true, _) => '#',
        (false, true) => '+',
        (false, false) => '.',
    };
    pixmap
        .pixels()
        .chunks(pixmap.width() as usize)
        .map(|row| row.iter().map(symbol).collect())
        .collect()
}

#[test]
fn a_dashed_line_lies_in_one_halo() {
    let line = Shape::line(points([(4.0, 5.0), (20.0, 5.0)]), 2.0, RED).dashed(&[2.0, 1.0]);
    let expected = [
        "........................",
        "........................",
        "...++++++++++++++++++...",
        "..++++++++++++++++++++..",
        ".+++####++####++####+++.",
        ".+++####++####++####+++.",
        "..++++++++++++++++++++..",
        "...++++++++++++++++++...",
        "........................",
        "........................",
    ];
    assert_eq!(ascii(&drawn(24, 10, &[line])), expected);
}

#[test]
fn a_line_from_far_outside_keeps_its_dashes_in_step() {
    let from =
        |x: f64| [Shape::line(points([(x, 5.0), (60.0, 5.0)]), 2.0, RED).dashed(&[4.5, 1.5])];
    // A shift by whole periods of twelve pixels cannot be seen.
    assert_eq!(
        ascii(&drawn(64, 10, &from(-89_981.0))),
        ascii(&drawn(64, 10, &from(-41.0)))
    );
}

#[test]
fn a_line_that_leaves_and_returns_is_drawn_in_both_parts() {
    let line = points([(5.0, 5.0), (5.0, -500.0), (35.0, -500.0), (35.0, 5.0)]);
    let row = ascii(&drawn(40, 10, &[Shape::line(line, 2.0, RED)])).swap_remove(2);
    assert_eq!(row.matches("##").count(), 2, "{row}");
}

#[test]
fn what_is_outside_leaves_no_trace() {
    let far = DVec2::new(1e6, -1e6);
    let shapes = [
        Shape::ring(far, 10.0, 2.0, RED),
        Shape::line(vec![far, far * 2.0], 2.0, RED),
        Shape {
            width: 2.0,
            ..Shape::area(vec![far, far * 2.0, far + 1.0], RED)
        },
    ];
    assert!(drawn(20, 20, &shapes).data().iter().all(|byte| *byte == 0));
}

fn svg(title: &str, text: &str, at: DVec2, size: f64) -> String {
    let mut drawing = Drawing::new(DVec2::splat(100.0), [0; 3]);
    drawing.texts.push(Text::new(text, at, size, RED));
    drawing.to_svg(title)
}

#[test]
fn numbers_are_brief_and_text_is_escaped() {
    let text = svg("a < b & \"c\"", "x", DVec2::new(0.126, -0.001), 2.5);
    assert!(
        text.contains("<title>a &lt; b &amp; &quot;c&quot;</title>"),
        "{text}"
    );
    assert!(
        text.contains("<text x=\"0.13\" y=\"0\" font-size=\"2.5\" fill=\"#ff0000\""),
        "{text}"
    );
    assert!(
        svg("", "x", DVec2::new(1.0, 100.0), 9.0).contains("x=\"1\" y=\"100\" font-size=\"9\"")
    );
}

#[test]
fn a_raised_letter_comes_back_to_the_line() {
    let expected = ">cos<tspan dy=\"-3.6\" font-size=\"6.8\">n</tspan><tspan dy=\"3.6\" font-size=\"10\"> </tspan>φ</text>";
    let text = svg("", "cosⁿ φ", DVec2::ZERO, 10.0);
    assert!(text.contains(expected), "{text}");
}

/// Returns the first and the last row that a text inks, drawn at a size of 100 pixels with its baseline at row 200.
fn inked_rows(text: &str) -> Option<[usize; 2]> {
    let mut drawing = Drawing::new(DVec2::splat(300.0), [0; 3]);
    drawing
        .texts
        .push(Text::new(text, DVec2::new(20.0, 200.0), 100.0, [255; 3]));
    let frame = drawing.to_frame().expect("a picture");
    let rows = || frame.pixels.chunks(300);
    let inked = |row: &[[u8; 4]]| row.iter().any(|pixel| pixel[0] > 127);
    Some([rows().position(inked)?, rows().rposition(inked)?])
}

#[test]
fn every_character_of_the_overlays_has_a_glyph() {
    for character in "NLRVHT0123456789θφ·°()−.ⁿ∞²⁻⁰⁷αηπ=’".chars() {
        assert!(
            inked_rows(&character.to_string()).is_some(),
            "{character} has no outline"
        );
    }
}

#[test]
fn a_capital_stands_on_the_baseline_and_a_subscript_hangs_below_it() {
    let [top, bottom] = inked_rows("L").expect("ink");
    assert!(
        bottom.abs_diff(200) < 5 && (60..80).contains(&(200 - top)),
        "{top} to {bottom}"
    );
    let [_, low] = inked_rows("L₁").expect("ink");
    assert!((210..230).contains(&low), "{low}");
    let text = |text| Text::new(text, DVec2::ZERO, 100.0, RED);
    assert!(text("L₁").width() > text("L").width());
    assert_eq!(
        (inked_rows(""), inked_rows(" "), text("").width()),
        (None, None, 0.0)
    );
}

#[test]
fn contrast_of_black_on_white_is_21() {
    assert!((contrast([0; 3], [255; 3]) - 21.0).abs() < 1e-9);
}

#[test]
fn text_is_broken_at_spaces_only_where_it_must_be() {
    let axis = || Axis::new("", 0.0, 1.0);
    let style = PlotStyle {
        paper: Paper::LIGHT,
        text: 10.0,
        titled: false,
    };
    let lines = |note: &str, width: f64| -> Vec<String> {
        let plot = Plot::new(PlotKind::Profile, "", note, [axis(), axis()], vec![]);
        let texts = lay_out(&plot, DVec2::new(width, 10.0), &style).texts;
        texts.into_iter().map(|text| text.text).collect()
    };
    assert_eq!(lines("one two", 1000.0), ["one two"]);
    assert_eq!(lines("one two", 1.0), ["one", "two"]);
    assert!(lines("", 10.0).is_empty());
}

fn labels(axis: &Axis, room: f64) -> Vec<String> {
    ticks(axis, room)
        .into_iter()
        .map(|(_, text)| text)
        .collect()
}

#[test]
fn ticks_are_round_numbers_within_the_axis() {
    assert_eq!(
        labels(&Axis::new("", 0.0, 1.0), 6.0),
        ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]
    );
    assert_eq!(labels(&Axis::new("", 0.0, 3.7), 5.0), ["0", "1", "2", "3"]);
    assert_eq!(
        labels(&Axis::new("", 0.0, 0.031), 4.0),
        ["0", "0.01", "0.02", "0.03"]
    );
    assert_eq!(
        labels(&Axis::new("", 0.0, 2e7), 3.0),
        ["0", "1.0×10⁷", "2.0×10⁷"]
    );
    assert_eq!(
        labels(&Axis::degrees("", -90.0, 90.0), 8.0),
        ["−90°", "−60°", "−30°", "0°", "30°", "60°", "90°"]
    );
}

#[test]
fn decades_are_divided_as_far_as_there_is_room() {
    let axis = Axis::decades("", -1.1, 1.2);
    assert_eq!(
        labels(&axis, 7.0),
        ["0.1", "0.2", "0.5", "1", "2", "5", "10"]
    );
    assert_eq!(labels(&axis, 5.0), ["0.1", "0.3", "1", "3", "10"]);
    assert_eq!(labels(&axis, 3.0), ["0.1", "1", "10"]);
    assert_eq!(
        labels(&Axis::decades("", -5.5, -2.5), 3.0),
        ["10⁻⁵", "10⁻⁴", "10⁻³"]
    );
    assert_eq!(
        labels(&Axis::decades("", -6.0, 6.0), 6.0),
        ["10⁻⁶", "10⁻⁴", "10⁻²", "1", "10²", "10⁴", "10⁶"]
    );
}

#[test]
fn an_axis_without_extent_has_no_ticks() {
    for (low, high) in [
        (1.0, 1.0),
        (0.0, f64::INFINITY),
        (0.0, f64::NAN),
        (2.0, 1.0),
    ] {
        assert!(ticks(&Axis::new("", low, high), 5.0).is_empty());
    }
}

#[test]
fn any_number_is_rounded_up_by_less_than_a_factor_of_two_and_a_half() {
    for value in [1e-9, 0.2, 0.21, 1.0, 3.3, 9.99, 10.0, 1.7e12] {
        let round = round_up(value);
        assert!(
            (0.999_999..2.51).contains(&(round / value)),
            "{value}: {round}"
        );
    }
}

#[test]
fn numbers_keep_three_digits() {
    let texts = [0.0, 1.0, -0.123_46, 12.345, 1005.0, 0.001_234, 1e-7, 4e18].map(short);
    assert_eq!(
        texts,
        [
            "0",
            "1.00",
            "−0.123",
            "12.3",
            "1005",
            "0.00123",
            "1.0×10⁻⁷",
            "4.0×10¹⁸"
        ]
    );
}
