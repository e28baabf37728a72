//! The axes of a curve on a phone, in which a finger draws.

use crate::figure::{Drawing, Paper, PlotStyle};
use crate::lesson::{
    CURVE_POINTS, Curve, CurveAxes, Element, Html, abscissa, element, short_number, with_unit,
};
use crate::text::text;
use glam::DVec2;

/// The size of the plot in CSS pixels, that of a phone held upright, and of its letters.
const SIZE: DVec2 = DVec2::new(358.0, 270.0);
const LETTERS: f64 = 13.0;
/// Every so many points of the curve there is a field for its value.
const STRIDE: usize = 8;
/// The colour of the right curve; the style sheet has its own for a dark page.
const RIGHT: [u8; 3] = [0x1b, 0x7a, 0x3a];

/// The axes of a question about a curve.
pub struct CurvePlot<'q> {
    curve: &'q Curve,
    axes: CurveAxes,
    names: [String; 2],
    drawing: Drawing,
}

impl<'q> CurvePlot<'q> {
    pub fn new(curve: &'q Curve) -> Self {
        let names = [&curve.x_name, &curve.y_name].map(|name| name.plain());
        let axes = CurveAxes::new([curve.x, curve.y], [&names[0], &names[1]]);
        let style = PlotStyle {
            paper: Paper::LIGHT,
            text: LETTERS,
            titled: false,
        };
        let drawing = axes.lay_out(SIZE, &style);
        Self {
            curve,
            axes,
            names: names.map(|name| name.trim().replace(['$', '`'], "")),
            drawing,
        }
    }

    /// Returns the axes as SVG, with the right curve in them once that may be seen.
    pub fn html(&self, right: Option<&[[f64; 2]]>) -> Element {
        let mut drawing = self.drawing.clone();
        if let Some(right) = right {
            drawing.draw_curve(right.iter().copied(), 2.5, RIGHT, 1.0);
        }
        let place = |x: f64, y: f64| self.drawing.place([x, y]).unwrap_or_default().0;
        let ([from, to], [low, high]) = (self.curve.x, self.curve.y);
        let (start, end) = (place(from, low), place(to, high));
        let svg = Html::made(drawing.to_svg(&self.axes.words()));
        element("div")
            .class("plot")
            .attribute(
                "data-area",
                format!("{:.2} {:.2} {:.2} {:.2}", start.x, start.y, end.x, end.y),
            )
            .attribute("data-y", format!("{low} {high}"))
            .attribute("data-points", CURVE_POINTS)
            .with(svg)
    }

    /// Returns fields for the values at some places: what those use who do not draw.
    pub fn fields(&self) -> Element {
        let [x_name, y_name] = &self.names;
        let [low, high] = self.curve.y;
        let places = (0..CURVE_POINTS).step_by(STRIDE);
        let fields = places.map(|index| {
            let x = short_number(abscissa(self.curve.x, index));
            let x = with_unit(&x, &self.curve.unit);
            let input = element("input")
                .attribute("type", "text")
                .attribute("inputmode", if low < 0.0 { "text" } else { "decimal" })
                .attribute("autocomplete", "off")
                .attribute("data-at", index);
            let words = text!(
                "phone-value-at",
                y = y_name.as_str(),
                x_name = x_name.as_str(),
                x = x.as_str()
            );
            let input = input.attribute("aria-label", words);
            element("label").with(element("span").with(x)).with(input)
        });
        let range = text!(
            "phone-values-range",
            from = short_number(low),
            to = short_number(high)
        );
        let summary = element("summary").with(text!("phone-values"));
        let details = element("details").class("values").broken().line(summary);
        let about = element("p").class("quiet").with(range);
        let grid = fields.fold(element("div").class("grid").broken(), Element::line);
        details.line(about).line(grid)
    }
}
