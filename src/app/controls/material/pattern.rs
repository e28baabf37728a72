//! The pattern on the surface.

use super::colourless;
use crate::app::row::{About, Choice, NumberRow, Rail, choice, colour, number};
use crate::app::state::AppState;
use crate::app::symbol::Symbol;
use crate::scene::{Pattern, PatternKind};
use eframe::egui::Ui;

/// The patterns and what they are called.
pub const PATTERNS: [Choice<PatternKind>; 4] = [
    (PatternKind::None, "none", ""),
    (PatternKind::Checker, "checker", "Cubes, every other one coloured"),
    (PatternKind::Stripes, "stripes", "Level layers"),
    (PatternKind::Rings, "rings", "Shells about the axis"),
];

pub fn pattern_ui(ui: &mut Ui, state: &mut AppState) {
    let (default, AppState { document, lit, .. }) = (Pattern::default(), state);
    let (idle, symbol) = (colourless(&document.scene), Some(Symbol::Od));
    let pattern = &mut document.scene.pattern;
    let tip = "A second colour of the surface, laid out in space.";
    let about = About { label: "Pattern", tip, symbol, idle, ..About::default() };
    choice(ui, lit, &about, default.kind, &PATTERNS, &mut pattern.kind);
    if pattern.kind == PatternKind::None {
        return;
    }
    let about = About {
        letter: "Od",
        label: "in pattern",
        name: "Pattern colour",
        tip: "Od where the pattern lies: red, green and blue, linear. Between, the surface has its own colour.",
        symbol,
        idle,
        ..About::default()
    };
    colour(ui, lit, &about, default.color, &mut pattern.color);
    let tip = "The width of one field; world units.";
    let about = About { label: "Field width", name: "Pattern scale", tip, symbol, idle, ..About::default() };
    let rail = Rail { limits: Pattern::SCALE, ..Rail::logarithmic(0.01..=4.0) };
    number(ui, lit, &NumberRow { about, rail, default: default.scale }, &mut pattern.scale);
}
