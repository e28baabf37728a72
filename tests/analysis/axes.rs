//! Round numbers on axes of any extent.

use shading_lab::figure::{Axis, ticks};

/// Difficult numbers, with their neighbours.
const HARD: [f64; 15] = [
    0.0,
    5e-324,
    1e-308,
    1e-292,
    1e-30,
    1e-9,
    0.3,
    1.0,
    90.0,
    1e6,
    1e15,
    1e19,
    1e300,
    f64::MAX,
    f64::INFINITY,
];

#[test]
fn every_axis_has_few_ticks_and_none_is_beyond_it() {
    let signed = || {
        HARD.iter()
            .flat_map(|value| [*value, -value])
            .chain([f64::NAN])
    };
    let ends = || signed().flat_map(|value| [value, value.next_up()]);
    let rooms = [f64::NAN, -1.0, 0.0, 6.0, 1e300];
    let mut ticked = 0;
    for (low, high) in ends().flat_map(|low| ends().map(move |high| (low, high))) {
        for max_ticks in rooms {
            for axis in [
                Axis::new("", low, high),
                Axis::degrees("", low, high),
                Axis::decades("", low, high),
            ] {
                let ticks = ticks(&axis, max_ticks);
                assert!(ticks.len() <= 130, "{axis:?}: {}", ticks.len());
                assert!(
                    ticks.is_empty() || Axis::can_span(low, high),
                    "{axis:?} has ticks"
                );
                let slack = 1e-6 * (high - low);
                let inside = |value: f64| value >= low - slack && value <= high + slack;
                assert!(
                    ticks.iter().all(|(value, _)| inside(*value)),
                    "{axis:?}: {ticks:?}"
                );
                ticked += usize::from(!ticks.is_empty());
            }
        }
    }
    assert!(ticked > 1000, "{ticked} axes have ticks");
}

#[test]
fn an_axis_of_many_turns_has_round_numbers_of_right_angles() {
    let written = |high| {
        let ticks = ticks(&Axis::degrees("", 0.0, high), 5.0);
        let written: Vec<_> = ticks.into_iter().map(|(_, text)| text).collect();
        written.join(" ")
    };
    assert_eq!(written(90.0), "0° 30° 60° 90°");
    assert_eq!(written(3600.0), "0° 900° 1800° 2700° 3600°");
}
