//! Opening the window as a web page.

use crate::analysis::bench::BenchQuestion;
use crate::analysis::defects::DefectsQuestion;
use crate::analysis::profile::ProfileQuestion;
use crate::analysis::stability::StabilityQuestion;
use crate::analysis::study::StudyQuestion;
use crate::app::controls::materials::Spheres;
use crate::app::controls::sampling::AreaLight;
use crate::app::controls::scenes::Thumbnails;
use crate::app::course::{Likeness, Marking, Prepare, Target};
use crate::app::engine::Supersampled;
use crate::app::shell::dialog::Dialog;
use crate::app::shell::files::{Exported, Filmed};
use crate::app::views::profile::Perceived;
use crate::app::{App, system};
use crate::document::{Loaded, load_scene};
use crate::jobs::{Request, Served, serve, served};
use crate::link;
use crate::render::check_mesh_memory;
use crate::scene::presets;
use crate::text::{Language, language, set_language, text};
use eframe::egui::Context;
use std::panic;
use std::path::Path;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::spawn_local;
use web_sys::HtmlCanvasElement;

/// The ID of the page's canvas element.
const CANVAS: &str = "shading-lab";

/// Opens the window on the page's canvas. Errors are logged to the console, and the page says that something failed.
pub fn run() {
    if serve(workers()) {
        console_error_panic_hook::set_once();
        return;
    }
    panic::set_hook(Box::new(|info| {
        console_error_panic_hook::hook(info);
        system::show("stopped");
    }));
    let canvas = web_sys::window()
        .and_then(|window| window.document())
        .and_then(|document| document.get_element_by_id(CANVAS));
    let Some(canvas) = canvas else { return };
    spawn_local(start(canvas.unchecked_into()));
}

async fn start(canvas: HtmlCanvasElement) {
    // Before the first sentence; the window then follows the choice of an earlier run.
    set_language(Language::of_system());
    if language() == Language::TraditionalChinese {
        let _ = system::fetch_chinese_text().await;
    }
    let open = |cc: &eframe::CreationContext<'_>| -> Box<dyn eframe::App> {
        let (page, link) = address();
        let open = |link: &str| -> Result<Loaded, String> {
            let loaded = load_scene(Path::new(link)).map_err(|error| error.to_string())?;
            let small = check_mesh_memory(&loaded.scene, loaded.model.as_deref());
            small.map(|()| loaded).map_err(|error| error.to_string())
        };
        let linked = link::is_link(&link).then(|| open(&link));
        let (loaded, problem) = match linked {
            Some(Ok(loaded)) => (Some(loaded), None),
            Some(Err(error)) => (None, Some(error)),
            None => (None, None),
        };
        let loaded = loaded
            .unwrap_or_else(|| load_scene(Path::new(presets::DEFAULT)).expect("a built-in scene"));
        let shown = loaded.shown.clone();
        let mut app = App::new(cc, loaded).with_welcome().with_page(Some(page));
        reduce_motion(&cc.egui_ctx);
        if shown.embed || system::has_mark("data-embed") {
            app = app.embedded(&shown.controls);
            if let Some(figure) = &mut app.state.window.embedded {
                figure.problem = problem;
            }
            return Box::new(app);
        }
        if let Some(problem) = problem {
            app.state.dialog = Some(Dialog::message(text!("link-not-opened"), problem));
            return Box::new(app);
        }
        Box::new(app.with_recovery(Path::new("")))
    };
    let runner = eframe::WebRunner::new();
    let options = eframe::WebOptions {
        should_prevent_default: Box::new(system::takes),
        ..eframe::WebOptions::default()
    };
    if let Err(error) = runner
        .start(canvas, options, Box::new(move |cc| Ok(open(cc))))
        .await
    {
        system::show("stopped");
        wasm_bindgen::throw_val(error);
    }
}

/// Returns the kinds of work that workers do.
fn workers() -> Vec<Served> {
    vec![
        served::<Request<AreaLight>>(),
        served::<Request<BenchQuestion>>(),
        served::<Request<DefectsQuestion>>(),
        served::<Request<ProfileQuestion>>(),
        served::<Request<StabilityQuestion>>(),
        served::<Request<StudyQuestion>>(),
        served::<Exported>(),
        served::<Filmed>(),
        served::<Likeness>(),
        served::<Perceived>(),
        served::<Prepare>(),
        served::<Marking>(),
        served::<Spheres>(),
        served::<Supersampled>(),
        served::<Target>(),
        served::<Thumbnails>(),
    ]
}

/// Returns the page's address, and the link in it.
fn address() -> (String, String) {
    let location = || {
        let location = web_sys::window()?.location();
        let page = location.origin().ok()? + &location.pathname().ok()?;
        Some((page, location.search().ok()? + &location.hash().ok()?))
    };
    location().unwrap_or_default()
}

/// Disables animations if the user prefers reduced motion.
fn reduce_motion(ctx: &Context) {
    if system::has_mark("data-motion") {
        ctx.all_styles_mut(|style| style.animation_time = 0.0);
    }
}
