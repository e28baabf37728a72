//! Light through the surface.

use crate::app::palette::vector_text;
use crate::app::row::{About, NumberRow, Rail, choice, number};
use crate::app::state::AppState;
use crate::app::symbol::Symbol;
use crate::figure::palette::Vector;
use crate::scene::{Through, Transparency};
use eframe::egui::Ui;

pub fn transparency_ui(ui: &mut Ui, state: &mut AppState) {
    let (default, AppState { document, lit, .. }) = (Transparency::default(), state);
    let tint = Some(vector_text(ui.visuals(), Vector::T));
    let transparency = &mut document.scene.transparency;
    let about = About {
        letter: "Kt",
        tint,
        label: "transmits",
        name: "Kt",
        tip: "Kt, the part of the light that comes from behind: I = (1 − Kt)·Irefl + Kt·Itrans. No unit, 0 (opaque) to 1.",
        symbol: Some(Symbol::Kt),
        ..About::default()
    };
    let rail = Rail { limits: 0.0..=1.0, ..Rail::linear(0.0..=1.0) };
    number(ui, lit, &NumberRow { about, rail, default: default.kt }, &mut transparency.kt);
    let idle = (transparency.kt == 0.0).then_some("Kt is 0: nothing is seen through the surface");
    let symbol = Some(Symbol::Transmitted);
    let about = About {
        letter: "η",
        tint,
        label: "index",
        name: "η relative index",
        tip: "η, the index of refraction inside, relative to that outside: by Snell's law sin θ = η·sin θt. No unit, 0.1 to 10; 1 bends nothing.",
        symbol,
        idle,
    };
    let rail = Rail { limits: Transparency::IOR, ..Rail::linear(0.5..=3.0) };
    number(ui, lit, &NumberRow { about, rail, default: default.ior }, &mut transparency.ior);
    let tip = "How far the light that is seen is followed back.";
    let about = About { label: "Through", name: "Transmitted through", tip, symbol, idle, ..About::default() };
    let choices = [
        (
            Through::Surface,
            "one surface",
            "Bent once, where it is seen: what lies behind is inside the material as well",
        ),
        (Through::Solid, "a solid", "Bent on its way in and out, and reflected inside where it cannot leave"),
    ];
    choice(ui, lit, &about, default.through, &choices, &mut transparency.through);
}
