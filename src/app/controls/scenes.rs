//! The gallery of built-in scenes, with a thumbnail of each, drawn in the background while the gallery is open.

use crate::analysis::Watch;
use crate::analysis::codec::Codec;
use crate::app::engine::image_of;
use crate::app::session::action::{Action, Requests};
use crate::app::session::document::Origin;
use crate::app::session::window::WindowState;
use crate::app::widgets::background::{PICTURES, Pictures};
use crate::app::widgets::dialog::Choice;
use crate::app::widgets::focus::{heading, named, take_if_free};
use crate::app::widgets::theme::text_field;
use crate::app::widgets::tile::picture_tile;
use crate::jobs::Work;
use crate::render::Renderer;
use crate::scene::presets::{self, Preset};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{ColorImage, Key, RichText, ScrollArea, TextureHandle, Ui, Vec2, vec2};
use serde::{Deserialize, Serialize};

/// Size of a thumbnail, in points.
const PICTURE: Vec2 = Vec2::new(148.0, 111.0);
/// Size of a thumbnail with its title, in points.
const CARD: Vec2 = Vec2::new(156.0, 156.0);

/// State of the gallery.
#[derive(Default)]
pub struct Gallery {
    sought: String,
    pictures: Pictures<Thumbnails>,
}

impl Gallery {
    /// Forgets what was sought, and the thumbnails that are still being drawn.
    pub fn leave(&mut self) {
        self.sought.clear();
        self.pictures.leave();
    }
}

/// A request for the thumbnails of all scenes, with their size in pixels.
#[derive(Clone, PartialEq, Serialize, Deserialize)]
pub struct Thumbnails([u32; 2]);

impl Work for Thumbnails {
    type Answer = Vec<ColorImage>;

    const CODECS: Option<(Codec<Self>, Codec<Self::Answer>)> = Some((Codec::plain(), PICTURES));

    fn run(&self, watch: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String> {
        let mut pictures = Vec::new();
        for preset in presets::ALL {
            let mut scene = preset.scene();
            scene.image.size = self.0;
            let frame = Renderer::default().render_supersampled(&scene, 4, &mut |_| true);
            pictures.push(image_of(&frame));
            watch.found(&pictures);
            if !watch.progress(pictures.len() as f32 / presets::ALL.len() as f32) {
                break;
            }
        }
        Ok(pictures)
    }
}

/// Returns whether a scene's name matches the search text.
fn is_named(preset: &Preset, sought: &str) -> bool {
    preset.name.contains(sought) || preset.title().to_lowercase().contains(sought)
}

/// Returns the scenes that match the search text by topic, those with a matching name first, each with its index among all.
fn found(sought: &str) -> Vec<(&'static str, Vec<(usize, &'static Preset)>)> {
    let topics = presets::topics().into_iter().map(|topic| {
        let scenes = presets::ALL.iter().enumerate();
        let of_topic = scenes.filter(|(_, preset)| preset.topic == topic);
        let mut scenes: Vec<_> = of_topic
            .filter(|(_, preset)| is_sought(preset, sought))
            .collect();
        scenes.sort_by_key(|(_, preset)| !is_named(preset, sought));
        (topic, scenes)
    });
    let mut topics: Vec<_> = topics.filter(|(_, scenes)| !scenes.is_empty()).collect();
    topics.sort_by_key(|(_, scenes)| !is_named(scenes[0].1, sought));
    topics
}

/// Returns whether a scene matches the search text.
fn is_sought(preset: &Preset, sought: &str) -> bool {
    let found = |text: &str| text.to_lowercase().contains(sought);
    let words = [preset.title(), preset.sentence(), preset.topic_title()];
    found(preset.name) || words.into_iter().any(found)
}

/// Shows every scene by chapter. A click opens it.
pub fn scenes_ui(ui: &mut Ui, window: &mut WindowState, requests: &mut Requests) -> Choice {
    let mut gallery: Gallery = window.own.take();
    let size = (PICTURE * ui.ctx().pixels_per_point()).round();
    let wanted = Thumbnails([size.x as u32, size.y as u32]);
    gallery
        .pictures
        .prepare(ui.ctx(), &wanted, presets::ALL.len());
    let mut choice = Choice::Stay;
    let mut entered = false;
    ui.horizontal(|ui| {
        heading(ui, text!("scenes"));
        let field = text_field(&mut gallery.sought)
            .hint_text(text!("scenes-search"))
            .desired_width(ui.available_width() - 76.0);
        let field = named(ui.add(field), Role::SearchInput, text!("scenes-search"));
        entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        take_if_free(&field);
        if ui.button(text!("close")).clicked() {
            choice = Choice::Leave;
        }
    });
    ui.add_space(8.0);
    let sought = gallery.sought.trim().to_lowercase();
    let height = (ui.ctx().content_rect().height() - 150.0).max(160.0);
    ScrollArea::vertical()
        .max_height(height)
        .min_scrolled_height(height)
        .auto_shrink(false)
        .show(ui, |ui| {
            let topics = found(&sought);
            if topics.is_empty() {
                ui.label(text!("scenes-none", sought = gallery.sought.trim()));
            }
            for (topic, scenes) in topics {
                ui.strong(presets::topic_title(topic));
                ui.horizontal_wrapped(|ui| {
                    ui.spacing_mut().item_spacing = vec2(8.0, 8.0);
                    // Two fit side by side in a narrow window.
                    let width = (0.5 * (ui.available_width() - 8.0)).clamp(100.0, CARD.x);
                    for (index, preset) in scenes {
                        let texture = gallery.pictures.textures.get(index);
                        // Enter opens the first scene that is found.
                        if card_ui(ui, width, preset, texture) || std::mem::take(&mut entered) {
                            requests.ask(Action::OpenBuiltIn(preset.name.to_owned()));
                            choice = Choice::Leave;
                        }
                    }
                });
                ui.add_space(10.0);
            }
        });
    window.own.put(gallery);
    choice
}

/// Shows a scene's thumbnail over its title, and returns whether it was clicked.
fn card_ui(ui: &mut Ui, width: f32, preset: &Preset, texture: Option<&TextureHandle>) -> bool {
    let picture = (texture, PICTURE * ((width - 8.0) / PICTURE.x));
    let name = RichText::new(preset.title());
    let response = picture_tile(ui, picture, name, vec2(width, CARD.y), false);
    let response = named(response, Role::Button, preset.title());
    response.on_hover_text(preset.sentence()).clicked()
}

/// Returns the name of the built-in scene `step` places after the open one, wrapping around.
pub fn scene_after(origin: &Origin, step: isize) -> &'static str {
    let Origin::BuiltIn(name) = origin else {
        return presets::DEFAULT;
    };
    let place = presets::ALL.iter().position(|preset| preset.name == name);
    let count = presets::ALL.len() as isize;
    let next = (place.unwrap_or(0) as isize + step).rem_euclid(count);
    presets::ALL[next as usize].name
}
