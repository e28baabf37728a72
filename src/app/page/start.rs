//! Opening the window as a web page.

use super::App;
use crate::document::load;
use crate::scene::presets;
use eframe::egui::Context;
use std::path::Path;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::spawn_local;
use web_sys::HtmlCanvasElement;

/// The canvas of the page.
const CANVAS: &str = "shading-lab";

/// Opens the window on the page's canvas; what goes wrong stands in the console, and the page says that something did.
pub fn run() {
    console_error_panic_hook::set_once();
    let canvas = web_sys::window()
        .and_then(|window| window.document())
        .and_then(|document| document.get_element_by_id(CANVAS));
    let Some(canvas) = canvas else { return };
    spawn_local(start(canvas.unchecked_into()));
}

async fn start(canvas: HtmlCanvasElement) {
    let open = |cc: &eframe::CreationContext<'_>| -> Box<dyn eframe::App> {
        let loaded = load(Path::new(presets::DEFAULT)).expect("a built-in scene");
        let app = App::new(cc, loaded).with_welcome();
        reduce_motion(&cc.egui_ctx);
        Box::new(app.with_recovery(Path::new("")))
    };
    let runner = eframe::WebRunner::new();
    let options = eframe::WebOptions::default();
    if let Err(error) = runner
        .start(canvas, options, Box::new(move |cc| Ok(open(cc))))
        .await
    {
        wasm_bindgen::throw_val(error);
    }
}

/// Moves nothing of itself where the reader wants it so.
fn reduce_motion(ctx: &Context) {
    let wanted = web_sys::window().and_then(|window| {
        window
            .document()?
            .document_element()?
            .get_attribute("data-motion")
    });
    if wanted.is_some_and(|motion| motion == "reduce") {
        ctx.all_styles_mut(|style| style.animation_time = 0.0);
    }
}
