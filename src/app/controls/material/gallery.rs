//! The named materials, to choose by eye.

use crate::app::gallery::{CELL, SPHERE};
use crate::app::row::{About, row};
use crate::app::state::AppState;
use crate::scene::materials::{NAMED, NamedMaterial, OF_A_KIND, recognise};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Button, Color32, Grid, Popup, PopupCloseBehavior, Rect, Sense, TextStyle, Ui, WidgetInfo, pos2, vec2,
};

/// What each column holds.
const KINDS: [&str; 4] = ["Stones", "Metals", "Plastics", "Rubbers"];

/// A button that says which of the named materials this is, and opens all of them.
pub fn gallery_ui(ui: &mut Ui, state: &mut AppState) {
    let present = recognise(&state.shown.scene.material);
    let tip = "The 24 named materials of OpenGL's teapots (Kilgard 1994): Ka, Kd, Ks and n as published.";
    let about = About { label: "Material", name: "Materials", tip, ..About::default() };
    let AppState { shown, lit, gallery, .. } = state;
    let mut chosen = None;
    let changed = shown.scene.material != lit.opened.material;
    let reset = row(ui, lit, &about, changed, |ui| {
        let button = Button::new(present.map_or("choose…", |named| named.title)).min_size(vec2(92.0, 0.0));
        let response = ui.add(button);
        let enabled = ui.is_enabled();
        response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, "Materials"));
        let response = response.on_hover_text(tip);
        let popup = Popup::menu(&response).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        popup.show(|ui| {
            gallery.prepare(ui.ctx());
            Grid::new("materials").num_columns(KINDS.len()).spacing([6.0, 6.0]).show(ui, |ui| {
                for kind in KINDS {
                    ui.label(kind);
                }
                ui.end_row();
                for place in 0..OF_A_KIND {
                    for named in NAMED.iter().skip(place).step_by(OF_A_KIND) {
                        let texture = gallery.texture(named);
                        if material_ui(ui, named, texture, present == Some(named)) {
                            chosen = Some(named.material());
                        }
                    }
                    ui.end_row();
                }
            });
        });
    });
    if reset {
        shown.scene.material = lit.opened.material.clone();
    }
    if let Some(material) = chosen {
        shown.scene.material = material;
    }
}

/// A sphere of the material with its name below.
fn material_ui(ui: &mut Ui, named: &NamedMaterial, texture: Option<eframe::egui::TextureId>, present: bool) -> bool {
    let (rect, response) = ui.allocate_exact_size(CELL, Sense::click());
    let visuals = ui.style().interact_selectable(&response, present);
    if present || response.hovered() || response.has_focus() {
        ui.painter().rect(rect, 5.0, visuals.weak_bg_fill, visuals.bg_stroke, eframe::egui::StrokeKind::Inside);
    }
    let sphere = Rect::from_center_size(rect.center_top() + vec2(0.0, SPHERE / 2.0 + 4.0), vec2(SPHERE, SPHERE));
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    match texture {
        Some(texture) => {
            ui.painter().image(texture, sphere, whole, Color32::WHITE);
        }
        None => {
            ui.painter().circle_stroke(sphere.center(), SPHERE * 0.44, ui.visuals().window_stroke);
        }
    }
    let below = rect.center_bottom() - vec2(0.0, 3.0);
    let font = TextStyle::Small.resolve(ui.style());
    ui.painter().text(below, Align2::CENTER_BOTTOM, named.title, font, visuals.text_color());
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, present, named.title));
    let NamedMaterial { ka, kd, ks, n, .. } = *named;
    let triple = |value: crate::scene::Rgb| format!("{}, {}, {}", value.x, value.y, value.z);
    let numbers = format!("Ka {}\nKd {}\nKs {}\nn {n}", triple(ka), triple(kd), triple(ks));
    response.on_hover_text(numbers).clicked()
}
