//! Controls of the material that are more than rows of parameters.
//!
//! The named materials are chosen by eye, from small spheres drawn in the background while their list is open. Other buttons
//! switch to another model with the n or m that makes its highlight as wide as the present one.

use super::row::{About, display, row, value_row};
use crate::analysis::Watch;
use crate::analysis::codec::Codec;
use crate::app::widgets::background::{PICTURES, Pictures};
use crate::app::widgets::focus::{named, switch_named};
use crate::app::widgets::symbol::Symbol;
use crate::app::widgets::tile::picture_tile;
use crate::illumination::{blinn_from_phong, phong_from_blinn, roughness_from_exponent};
use crate::jobs::Work;
use crate::render::Renderer;
use crate::scene::material::SPECULAR_COLOR;
use crate::scene::materials::{NAMED, NamedMaterial, OF_A_KIND, recognise};
use crate::scene::{
    Distribution, Light, Material, ObjectKind, ReflectionModel, Rgb, Scene, ShadingMode,
};
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Button, Color32, ColorImage, Grid, Popup, PopupCloseBehavior, RichText, TextureHandle, Ui,
    Vec2, vec2,
};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Side of a sphere's picture, in points.
const SPHERE: f32 = 48.0;
/// Size of a sphere with its name, in points.
const CELL: Vec2 = Vec2::new(104.0, 72.0);

/// Samples per pixel of the pictures: 2 × 2.
const SAMPLES: u32 = 4;

/// The pictures of the named materials, in the order of [`NAMED`].
pub type Gallery = Pictures<Spheres>;

/// A request for the pictures of all spheres, with their side in pixels.
#[derive(Clone, PartialEq, Serialize, Deserialize)]
pub struct Spheres(u32);

impl Work for Spheres {
    type Answer = Vec<ColorImage>;

    const CODECS: Option<(Codec<Self>, Codec<Self::Answer>)> = Some((Codec::plain(), PICTURES));

    fn run(&self, watch: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String> {
        let (mut renderer, mut pictures) = (Renderer::default(), Vec::new());
        for named in NAMED {
            pictures.push(picture(&mut renderer, named, self.0));
            watch.found(&pictures);
            if !watch.progress(pictures.len() as f32 / NAMED.len() as f32) {
                break;
            }
        }
        Ok(pictures)
    }
}

/// Returns the scene of a sphere lit as in OpenGL: N·H, a distant light from above, little ambient light.
fn scene(named: &NamedMaterial, side: u32) -> Scene {
    let mut scene = Scene {
        material: named.material(),
        lights: vec![Light {
            position: DVec3::new(-2.0, 2.5, 4.0),
            ..Light::default()
        }],
        ..Scene::default()
    };
    scene.image.size = [side, side];
    scene.image.background = Rgb::ZERO;
    scene.camera.fov_y = 33.0;
    scene.object.kind = ObjectKind::Sphere;
    scene.reflection.model = ReflectionModel::Blinn;
    scene.shading.mode = ShadingMode::Exact;
    scene.ambient.color = Rgb::splat(0.4);
    scene
}

/// Renders the sphere, cut out by its own coverage.
fn picture(renderer: &mut Renderer, named: &NamedMaterial, side: u32) -> ColorImage {
    let frame = renderer.render_supersampled(&scene(named, side), SAMPLES, &mut |_| true);
    let mut white = scene(named, side);
    white.material = Material {
        ka: Rgb::ONE,
        kd: Rgb::ZERO,
        ks: Rgb::ZERO,
        ..named.material()
    };
    white.ambient.color = Rgb::ONE;
    let coverage = renderer.render_supersampled(&white, SAMPLES, &mut |_| true);
    let pixels = frame.pixels.iter().zip(&coverage.pixels);
    // The background is black, so the colours are already premultiplied by the coverage.
    let pixels = pixels
        .map(|([r, g, b, _], [cover, ..])| Color32::from_rgba_premultiplied(*r, *g, *b, *cover));
    ColorImage::new([side as usize, side as usize], pixels.collect())
}

/// Keys of the kinds of materials, one for each column.
const KINDS: [&str; 4] = [
    "controls-stones",
    "controls-metals",
    "controls-plastics",
    "controls-rubbers",
];

/// Shows a button with the name of the present material, which opens the list of named materials.
pub fn gallery_ui(ui: &mut Ui, initial: &Material, gallery: &mut Gallery, material: &mut Material) {
    let present = recognise(material);
    let [name, tip] = [text!("controls-materials"), text!("controls-materials.tip")];
    let about = About {
        label: text!("controls-materials.label"),
        name,
        tip,
        ..About::default()
    };
    value_row(ui, &about, initial.clone(), material, |ui, material| {
        let button =
            Button::new(present.map_or(text!("controls-materials.none"), NamedMaterial::title))
                .min_size(vec2(92.0, 0.0));
        let response = named(ui.add(button), Role::Button, name).on_hover_text(tip);
        let popup = Popup::menu(&response).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        let open = popup.show(|ui| {
            let side = (SPHERE * ui.ctx().pixels_per_point()).round();
            let wanted = Spheres(side.clamp(16.0, 512.0) as u32);
            gallery.prepare(ui.ctx(), &wanted, NAMED.len());
            Grid::new("materials")
                .num_columns(KINDS.len())
                .spacing([6.0, 6.0])
                .show(ui, |ui| {
                    for kind in KINDS {
                        ui.weak(text!(kind));
                    }
                    ui.end_row();
                    for place in 0..OF_A_KIND {
                        let all = NAMED.iter().enumerate();
                        for (index, named) in all.skip(place).step_by(OF_A_KIND) {
                            let texture = gallery.textures.get(index);
                            if material_ui(ui, named, texture, present == Some(named)) {
                                *material = named.material();
                            }
                        }
                        ui.end_row();
                    }
                });
        });
        if open.is_none() {
            gallery.leave();
        }
    });
}

/// Shows a sphere of the material with its name below, and returns whether it was clicked.
fn material_ui(
    ui: &mut Ui,
    material: &NamedMaterial,
    texture: Option<&TextureHandle>,
    present: bool,
) -> bool {
    let name = RichText::new(material.title()).small();
    let picture = (texture, Vec2::splat(SPHERE));
    let response = picture_tile(ui, picture, name, CELL, present);
    let response = switch_named(response, Role::Button, present, material.title());
    let NamedMaterial { ka, kd, ks, n, .. } = *material;
    let triple = |value: Rgb| format!("{}, {}, {}", value.x, value.y, value.z);
    let numbers = format!(
        "Ka {}\nKd {}\nKs {}\nn {n}",
        triple(ka),
        triple(kd),
        triple(ks)
    );
    response.on_hover_text(numbers).clicked()
}

/// Returns the other models, each with the n or m that matches the highlight of `scene`.
///
/// Models without a match are left out: Phong's lobe is never wider than 90° to each side, and microfacets are never perfectly
/// smooth here.
fn matches(scene: &Scene) -> Vec<(ReflectionModel, f64)> {
    let Material {
        n, roughness: m, ..
    } = scene.material;
    let model = scene.reflection.model;
    let blinn = match model {
        ReflectionModel::Phong => blinn_from_phong(n),
        ReflectionModel::Blinn => n,
        // The inverse of m = √(2/(n + 2)).
        ReflectionModel::CookTorrance => 2.0 / (m * m) - 2.0,
        ReflectionModel::Formula => return vec![],
    };
    let exists = |(other, number): &(ReflectionModel, f64)| match other {
        _ if *other == model => false,
        ReflectionModel::Phong => *number > 0.0,
        ReflectionModel::Blinn => *number >= 0.0,
        ReflectionModel::CookTorrance => Material::ROUGHNESS.contains(number),
        ReflectionModel::Formula => false,
    };
    let all = [
        (ReflectionModel::Phong, phong_from_blinn(blinn)),
        (ReflectionModel::Blinn, blinn),
        (
            ReflectionModel::CookTorrance,
            roughness_from_exponent(blinn),
        ),
    ];
    all.into_iter().filter(exists).collect()
}

/// Sets the model together with its n or m.
fn take(scene: &mut Scene, model: ReflectionModel, number: f64) {
    scene.reflection.model = model;
    if model == ReflectionModel::CookTorrance {
        (scene.reflection.distribution, scene.material.roughness) =
            (Distribution::Beckmann, number);
    } else {
        scene.material.n = number;
    }
}

/// Shows a button for each other model.
pub fn matching_ui(ui: &mut Ui, scene: &mut Scene) {
    // No other model has a width that matches GGX: its tail is longer.
    let tailed = scene.reflection.distribution == Distribution::Ggx;
    let found = matches(scene);
    if found.is_empty() || (tailed && scene.reflection.model == ReflectionModel::CookTorrance) {
        return;
    }
    let about = About {
        label: text!("controls-matching.label"),
        name: text!("controls-matching"),
        tip: text!("controls-matching.tip"),
        symbol: Some(Symbol::Reflected),
        idle: SPECULAR_COLOR.idle(scene, 0),
        ..About::default()
    };
    row(ui, &about, false, |ui| {
        ui.spacing_mut().button_padding.x = 6.0;
        for (model, number) in found {
            let (text, name, tip) = if model == ReflectionModel::CookTorrance {
                let [name, tip] = [
                    text!("controls-match-roughness"),
                    text!("controls-match-roughness.tip"),
                ];
                (
                    format!("m {}", display(number, 3)),
                    name.to_owned(),
                    tip.to_owned(),
                )
            } else {
                let who = if model == ReflectionModel::Phong {
                    "Phong"
                } else {
                    "Blinn"
                };
                let name = text!("controls-match-exponent", model = who);
                let tip = text!("controls-match-exponent.tip", model = who);
                (format!("{who} n {}", display(number, 2)), name, tip)
            };
            let button = named(ui.button(text), Role::Button, &name);
            if button.on_hover_text(tip).clicked() {
                take(scene, model, number);
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_a_sphere_in_the_middle() {
        let image = picture(&mut Renderer::default(), &NAMED[10], 48);
        assert_eq!(image.size, [48, 48]);
        let at = |x: usize, y: usize| image.pixels[y * 48 + x];
        assert_eq!(at(0, 0), Color32::TRANSPARENT);
        let middle = at(24, 24);
        assert!(
            middle.a() == 255 && middle.r() > middle.g() && middle.g() > middle.b(),
            "gold: {middle:?}"
        );
        for named in NAMED {
            assert_eq!(scene(named, 48).validate(), Ok(()));
        }
    }

    #[test]
    fn going_to_another_model_and_back_keeps_the_number() {
        let mut scene = Scene::default();
        let before = scene.clone();
        for model in [
            ReflectionModel::Blinn,
            ReflectionModel::CookTorrance,
            ReflectionModel::Phong,
        ] {
            let found = matches(&scene)
                .into_iter()
                .find(|(other, _)| *other == model)
                .expect("a match");
            take(&mut scene, model, found.1);
            assert_eq!(scene.validate(), Ok(()));
        }
        assert_eq!(scene.reflection.model, before.reflection.model);
        assert!(
            (scene.material.n / before.material.n - 1.0).abs() < 1e-9,
            "{}",
            scene.material.n
        );
    }

    #[test]
    fn what_has_no_match_offers_none() {
        let mut scene = Scene::default();
        scene.material.n = f64::INFINITY;
        assert_eq!(matches(&scene), [(ReflectionModel::Blinn, f64::INFINITY)]);
        scene.reflection.model = ReflectionModel::Blinn;
        scene.material.n = 0.5;
        assert!(
            !matches(&scene)
                .iter()
                .any(|(model, _)| *model == ReflectionModel::Phong),
            "no Phong lobe is as wide"
        );
    }
}
