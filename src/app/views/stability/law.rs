//! The scene's own law in the view of stability: where it loses digits, and the operation that loses them.

use crate::analysis::stability::{LawStability, StabilityQuestion};
use crate::app::engine::{Engine, image_of};
use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::window::WindowState;
use crate::app::views::report::{Offer, Pending, export_ui};
use crate::scene::ReflectionModel;
use crate::text::text;
use eframe::egui::{Image, RichText, TextureHandle, TextureOptions, Ui, vec2};

/// Maximum width and height of the picture, in points.
const PICTURE: f32 = 320.0;

/// State of the examination.
#[derive(Default)]
pub struct LawView {
    asking: Pending<StabilityQuestion>,
    /// The picture with its marked pixels.
    shown: Option<TextureHandle>,
}

/// Shows the examination of the law, if the scene has one of its own.
pub fn law_ui(
    ui: &mut Ui,
    view: &mut LawView,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let model = session.shown.scene.reflection.model;
    if model != ReflectionModel::Formula || engine.size.contains(&0) {
        return;
    }
    view.asking.receive();
    ui.label(RichText::new(text!("engine-law-heading")).strong());
    let offer = Offer {
        about: text!("engine-law-about"),
        start: text!("engine-law-examine"),
        problem: None,
        stale: view.asking.is_stale(&session.shown, |a, b| a == b),
    };
    if view.asking.state_ui(ui, &offer) {
        let question = StabilityQuestion {
            law: true,
            ..StabilityQuestion::default()
        };
        view.asking
            .start(ui.ctx(), &session.shown, engine.size, question);
    }
    if view.asking.work.progress().is_some() {
        view.shown = None;
    } else if let Some(law) = view
        .asking
        .work
        .answer()
        .and_then(|found| found.law.as_ref())
    {
        picture_ui(ui, &mut view.shown, law);
        view.asking.view.ui(ui);
        export_ui(ui, session, window, requests, "stability", || {
            view.asking.latest()
        });
    }
    ui.separator();
}

/// Shows the picture with its marked pixels.
fn picture_ui(ui: &mut Ui, shown: &mut Option<TextureHandle>, law: &LawStability) {
    let texture = shown.get_or_insert_with(|| {
        ui.ctx()
            .load_texture("law", image_of(&law.picture), TextureOptions::NEAREST)
    });
    let most = PICTURE.min(ui.available_width());
    let picture = Image::new(&*texture)
        .max_size(vec2(most, PICTURE))
        .alt_text(text!("engine-law-picture"));
    ui.add(picture).on_hover_text(text!("engine-law-picture"));
}
