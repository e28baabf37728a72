//! How finely the object is made of polygons, by one number, and what it then consists of.

use crate::app::plan::grouped;
use crate::app::row::{About, NumberRow, SliderRange, number};
use crate::app::symbol::{Lit, Symbol};
use crate::geometry::{divisions_for, triangles};
use crate::render::Report;
use crate::scene::Object;
use eframe::egui::{RichText, Ui};

/// The most triangles that the slider reaches, and the most that can be typed: more than a gigabyte of polygons.
const SLIDER: f64 = 1e6;
const MOST: f64 = 4e6;

/// One slider for segments and rings together.
pub fn triangles_ui(ui: &mut Ui, lit: &mut Lit, idle: Option<&str>, object: &mut Object) {
    let plain = Object { segments: lit.opened.object.segments, rings: lit.opened.object.rings, ..object.clone() };
    let [segments, rings] = divisions_for(object.kind, 0);
    let least = triangles(&Object { segments, rings, ..object.clone() }) as f64;
    let about = About {
        label: "Triangles",
        tip: "Sets segments and rings together, so that polygons are about as wide as high. The slider reaches a \
              million; up to four million can be typed.",
        symbol: Some(Symbol::Normal),
        idle,
        ..About::default()
    };
    let range = SliderRange { limits: least..=MOST, decimals: 0, ..SliderRange::logarithmic(least..=SLIDER) };
    let (now, default) = (triangles(object) as f64, triangles(&plain) as f64);
    let mut wanted = now;
    number(ui, lit, &NumberRow { about, range, default }, &mut wanted);
    if wanted == now {
        return;
    }
    [object.segments, object.rings] = if wanted == default {
        [plain.segments, plain.rings]
    } else {
        // Not negative, within the limits.
        divisions_for(object.kind, wanted.round() as u64)
    };
}

/// What the mesh that is drawn consists of.
pub fn counts_ui(ui: &mut Ui, report: &Report) {
    let Report { faces, vertices, triangles, .. } = report;
    let text = format!("{} polygons, {} vertices", grouped(*faces), grouped(*vertices));
    let tip = format!("Drawn as {} triangles; a vertex is a point with one normal.", grouped(*triangles));
    ui.label(RichText::new(text).weak()).on_hover_text(tip);
}
