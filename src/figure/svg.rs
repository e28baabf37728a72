//! A drawing as SVG: lines stay lines and text stays text, so that both can be edited and searched.

use super::drawing::{Drawing, Shape, Text};
use super::palette::Rgb8;
use super::text::Set;
use std::fmt::Write;

/// Font families: the program's own font first, then those that most machines have.
const FONTS: &str = "Ubuntu, 'Helvetica Neue', Helvetica, Arial, 'Noto Sans', sans-serif";

impl Drawing {
    /// Returns the text of an SVG file, one pixel per unit; `title` is for people who cannot see it.
    pub fn to_svg(&self, title: &str) -> String {
        let (width, height) = (self.size.x, self.size.y);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\">\n<title>{}</title>\n",
            escaped(title),
        );
        if let Some(ground) = self.ground {
            let _ = writeln!(
                svg,
                "<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>",
                hex(ground)
            );
        }
        svg.push_str("<g stroke-linejoin=\"round\" stroke=\"none\">\n");
        self.painted()
            .for_each(|shape| write_shape(&mut svg, &shape));
        let _ = writeln!(svg, "</g>\n<g font-family=\"{FONTS}\" stroke=\"none\">");
        for text in &self.texts {
            if text.halo > 0.0 {
                write_text(&mut svg, text, Some(self.halo));
            }
            write_text(&mut svg, text, None);
        }
        svg.push_str("</g>\n</svg>\n");
        svg
    }
}

fn write_shape(svg: &mut String, shape: &Shape) {
    let mut points = String::new();
    for point in &shape.points {
        let _ = write!(
            points,
            "{}{},{}",
            if points.is_empty() { "" } else { " " },
            brief(point.x),
            brief(point.y)
        );
    }
    let colour = hex(shape.colour);
    let width = brief(shape.width);
    let paint = match (shape.fill, shape.width > 0.0) {
        (true, false) => format!("fill=\"{colour}\""),
        (true, true) => format!("fill=\"{colour}\" stroke=\"{colour}\" stroke-width=\"{width}\""),
        (false, _) => format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\""),
    };
    let lengths: Vec<String> = shape
        .dashes
        .iter()
        .map(|dash| brief(f64::from(*dash) * shape.width))
        .collect();
    let dashes = match (shape.fill, lengths.is_empty()) {
        (true, _) => String::new(),
        (false, true) => " stroke-linecap=\"round\"".to_owned(),
        (false, false) => format!(" stroke-dasharray=\"{}\"", lengths.join(" ")),
    };
    let element = if shape.closed { "polygon" } else { "polyline" };
    let opacity = if shape.opacity < 1.0 {
        format!(" opacity=\"{}\"", shape.opacity)
    } else {
        String::new()
    };
    let _ = writeln!(
        svg,
        "<{element} points=\"{points}\" {paint}{dashes}{opacity}/>"
    );
}

/// Writes a text, or its halo as a text of its own below it: not every program paints strokes before fills.
fn write_text(svg: &mut String, text: &Text, halo: Option<Rgb8>) {
    let anchor = if text.align > 0.75 {
        " text-anchor=\"end\""
    } else if text.align > 0.25 {
        " text-anchor=\"middle\""
    } else {
        ""
    };
    let weight = if text.strong {
        " font-weight=\"500\""
    } else {
        ""
    };
    let (x, y, size) = (brief(text.at.x), brief(text.at.y), brief(text.size));
    let paint = match halo.map(hex) {
        None => format!("fill=\"{}\"", hex(text.colour)),
        Some(colour) => {
            let width = brief(2.0 * text.halo);
            format!(
                "aria-hidden=\"true\" fill=\"{colour}\" stroke=\"{colour}\" stroke-width=\"{width}\""
            )
        }
    };
    let words = lettered(&text.text, text.size);
    let _ = writeln!(
        svg,
        "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" {paint}{anchor}{weight} xml:space=\"preserve\">{words}</text>"
    );
}

/// Converts subscripts and superscripts to ordinary characters, shifted, since fonts may lack them.
fn lettered(text: &str, size: f64) -> String {
    let mut out = String::new();
    let mut shifted = 0.0;
    for set in text.chars().map(Set::of) {
        let shift = -f64::from(set.rise) * size;
        let letter = escaped(&set.letter.to_string());
        if shift == shifted && shift == 0.0 {
            out.push_str(&letter);
            continue;
        }
        let (moved, small) = (brief(shift - shifted), brief(f64::from(set.size) * size));
        let _ = write!(
            out,
            "<tspan dy=\"{moved}\" font-size=\"{small}\">{letter}</tspan>"
        );
        shifted = shift;
    }
    out
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Formats a number with at most two decimals.
fn brief(value: f64) -> String {
    let text = format!("{value:.2}");
    match text.trim_end_matches('0').trim_end_matches('.') {
        "-0" => "0".to_owned(),
        text => text.to_owned(),
    }
}

fn hex([r, g, b]: Rgb8) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}
