//! The scan in words and numbers: formulas filled in, a line as text, all pixels as a table.

use super::{Carried, Crossing, Rule, Scan, ScanLevel, ScanLine, ScanPixel, ScanSpan};
use glam::DVec3;

/// One linear interpolation, with its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Mix {
    /// What it finds: `P`, `Q`, or nothing for the pixel.
    pub of: &'static str,
    /// The two points between which it lies, α = 0 first.
    pub ends: [String; 2],
    /// Coordinates of the first point, of what is found, and of the second one: y on an edge, x on the scan line.
    pub places: [f64; 3],
    pub alpha: f64,
    pub values: [DVec3; 2],
    pub value: DVec3,
}

impl Mix {
    /// `α = (7.50 − 2.00) / (14.00 − 2.00) = 0.458`.
    pub fn alpha_text(&self) -> String {
        let [from, here, to] = self.places.map(|place| number(place, 2));
        format!("α = ({here} − {from}) / ({to} − {from}) = {}", number(self.alpha, 3))
    }

    /// `I(P) = (1−α)·I(P₁) + α·I(P₂)`.
    pub fn formula(&self, letter: &str) -> String {
        let [a, b] = &self.ends;
        let of = if self.of.is_empty() { String::new() } else { format!("({})", self.of) };
        format!("{letter}{of} = (1−α)·{letter}({a}) + α·{letter}({b})")
    }

    /// The formula with the numbers of one component.
    pub fn row(&self, component: usize) -> String {
        let [a, b] = self.values.map(|value| bracketed(value[component]));
        let [rest, alpha] = [1.0 - self.alpha, self.alpha].map(|share| number(share, 3));
        format!("{rest}·{a} + {alpha}·{b} = {}", number(self.value[component], 4))
    }
}

/// How a corner is lettered: P₁, P₂, … in the polygon's order.
pub fn corner_name(index: usize) -> String {
    let low =
        |digit: char| digit.to_digit(10).and_then(|digit| char::from_u32(u32::from('₀') + digit)).unwrap_or(digit);
    format!("P{}", (index + 1).to_string().chars().map(low).collect::<String>())
}

impl Carried {
    /// The letter of what is carried.
    pub const fn letter(self) -> &'static str {
        if matches!(self, Self::Normal) { "N" } else { "I" }
    }

    /// What its three components are called.
    pub const fn components(self) -> [&'static str; 3] {
        if matches!(self, Self::Normal) { ["x", "y", "z"] } else { ["r", "g", "b"] }
    }
}

impl Scan {
    /// The name of an edge by its corners, the upper one first.
    pub fn edge_name(&self, edge: usize) -> String {
        self.edges[edge].corners.map(corner_name).concat()
    }

    /// How P or Q is found.
    pub fn crossing_mix(&self, line: &ScanLine, crossing: &Crossing, of: &'static str) -> Mix {
        let edge = &self.edges[crossing.edge];
        Mix {
            of,
            ends: edge.corners.map(corner_name),
            places: [edge.y_top, line.at(), edge.y_bottom],
            alpha: crossing.alpha,
            values: edge.corners.map(|corner| self.corners[corner].value),
            value: crossing.value,
        }
    }

    /// How a pixel's value is found between P and Q.
    pub fn pixel_mix(&self, span: &ScanSpan, pixel: &ScanPixel) -> Mix {
        Mix {
            of: "",
            ends: ["P".to_owned(), "Q".to_owned()],
            places: [span.p.x, f64::from(pixel.x) + 0.5, span.q.x],
            alpha: pixel.alpha,
            values: [span.p.value, span.q.value],
            value: pixel.value,
        }
    }

    /// What stands at a step, in a phrase.
    pub fn caption(&self, step: usize) -> String {
        let point = self.at(step);
        let y = point.line.y;
        match (point.level, point.pixel, point.q, point.p) {
            (_, Some(pixel), _, _) => format!("pixel ({}, {y})", pixel.x),
            (_, _, Some(q), _) => format!("scan line {y}: Q on {}", self.edge_name(q.edge)),
            (_, _, _, Some(p)) => format!("scan line {y}: P on {}", self.edge_name(p.edge)),
            (ScanLevel::Line | ScanLevel::Edge | ScanLevel::Pixel, ..) => {
                let names: Vec<_> = point.line.active.iter().map(|edge| self.edge_name(*edge)).collect();
                format!("scan line {y}: active edges {}", names.join(", "))
            }
        }
    }

    /// How a pixel comes to its intensity from what is interpolated, a line each.
    pub fn pixel_words(&self, pixel: &ScanPixel) -> Vec<String> {
        let mut lines = Vec::new();
        if self.carried == Carried::Normal {
            let length = number(pixel.value.length(), 4);
            let unit = if self.renormalise { "made 1 before" } else { "left so for" };
            lines.push(format!("|N| = {length}, {unit} the equation"));
            lines.push(format!("I = {}", triple(pixel.intensity, 4)));
        }
        lines.push(format!("{}:", self.compared_name()));
        lines.push(format!("I = {}", triple(pixel.barycentric, 4)));
        lines.push(format!("difference {}", triple(pixel.intensity - pixel.barycentric, 4)));
        let [r, g, b] = pixel.stored;
        lines.push(format!("stored {r}, {g}, {b}"));
        lines
    }

    /// What the values are compared with.
    pub fn compared_name(&self) -> &'static str {
        match self.compared {
            Rule::Affine => "barycentric, affine",
            Rule::Perspective => "barycentric, perspective-correct",
        }
    }

    /// What is carried along, in words.
    pub fn what(&self) -> &'static str {
        match self.carried {
            Carried::Constant => "one intensity for the whole polygon",
            Carried::Intensity => "the corners' intensities are interpolated",
            Carried::Normal => "the corners' normals are interpolated",
        }
    }
}

/// A number with so many decimals and a true minus sign.
pub(super) fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    // What rounds to nothing has no sign.
    let zero = text.trim_start_matches('-').chars().all(|digit| digit == '0' || digit == '.');
    if zero { text.trim_start_matches('-').to_owned() } else { text.replace('-', "−") }
}

/// A factor; a negative one in brackets.
fn bracketed(value: f64) -> String {
    let text = number(value, 4);
    if text.starts_with('−') { format!("({text})") } else { text }
}

pub(super) fn triple(value: DVec3, decimals: usize) -> String {
    value.to_array().map(|part| number(part, decimals)).join(", ")
}
