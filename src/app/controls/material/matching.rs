//! The n or m of the other models that makes a highlight as wide as the present one.

use crate::app::row::{About, display, row};
use crate::app::symbol::{Lit, Symbol};
use crate::illumination::{blinn_from_phong, phong_from_blinn, roughness_from_exponent};
use crate::scene::material::no_highlight;
use crate::scene::{Distribution, Material, ReflectionModel, Scene};
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, Ui, WidgetInfo};

/// Another model with the number that matches.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Match {
    Phong { n: f64 },
    Blinn { n: f64 },
    CookTorrance { m: f64 },
}

impl Match {
    /// What matches the highlight of `scene`.
    fn of(scene: &Scene) -> Vec<Self> {
        let Material { n, roughness: m, .. } = scene.material;
        let all = match scene.reflection.model {
            ReflectionModel::Phong => {
                let blinn = blinn_from_phong(n);
                vec![Self::Blinn { n: blinn }, Self::CookTorrance { m: roughness_from_exponent(blinn) }]
            }
            ReflectionModel::Blinn => {
                vec![Self::Phong { n: phong_from_blinn(n) }, Self::CookTorrance { m: roughness_from_exponent(n) }]
            }
            ReflectionModel::CookTorrance => {
                // The inverse of m = √(2/(n + 2)).
                let n = 2.0 / (m * m) - 2.0;
                vec![Self::Phong { n: phong_from_blinn(n) }, Self::Blinn { n }]
            }
        };
        all.into_iter().filter(|found| found.exists()).collect()
    }

    /// Phong's lobe is never wider than 90° to each side, and microfacets are never perfectly smooth here.
    fn exists(self) -> bool {
        match self {
            Self::Phong { n } => n > 0.0,
            Self::Blinn { n } => n >= 0.0,
            Self::CookTorrance { m } => Material::ROUGHNESS.contains(&m),
        }
    }

    fn text(self) -> String {
        match self {
            Self::Phong { n } => format!("Phong n {}", display(n, 2)),
            Self::Blinn { n } => format!("Blinn n {}", display(n, 2)),
            Self::CookTorrance { m } => format!("m {}", display(m, 3)),
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Phong { .. } => "Match with Phong's n",
            Self::Blinn { .. } => "Match with Blinn's n",
            Self::CookTorrance { .. } => "Match with a roughness",
        }
    }

    const fn tip(self) -> &'static str {
        match self {
            Self::Phong { .. } => "Takes Phong's model with the n that makes its highlight as wide",
            Self::Blinn { .. } => "Takes Blinn's model with the n that makes its highlight as wide",
            Self::CookTorrance { .. } => {
                "Takes Cook and Torrance's model with Beckmann's m that makes its highlight as narrow"
            }
        }
    }

    fn apply(self, scene: &mut Scene) {
        let (reflection, material) = (&mut scene.reflection, &mut scene.material);
        match self {
            Self::Phong { n } => (reflection.model, material.n) = (ReflectionModel::Phong, n),
            Self::Blinn { n } => (reflection.model, material.n) = (ReflectionModel::Blinn, n),
            Self::CookTorrance { m } => {
                (reflection.model, reflection.distribution) = (ReflectionModel::CookTorrance, Distribution::Beckmann);
                material.roughness = m;
            }
        }
    }
}

/// A button for each other model.
pub fn matching_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    // GGX has no width that the others could have: its tail is longer.
    let tailed = scene.reflection.distribution == Distribution::Ggx;
    let found = Match::of(scene);
    if found.is_empty() || (tailed && scene.reflection.model == ReflectionModel::CookTorrance) {
        return;
    }
    let about = About {
        label: "Equivalent",
        name: "Matching highlights",
        tip: "The exponent or roughness of the other models that gives an equally wide highlight, to half its height in the plane of incidence. A click sets model and number together.",
        symbol: Some(Symbol::Reflected),
        idle: no_highlight(scene, 0),
        ..About::default()
    };
    let mut chosen = None;
    row(ui, lit, &about, false, |ui| {
        ui.spacing_mut().button_padding.x = 6.0;
        for found in &found {
            let response = ui.add(Button::new(found.text()));
            let enabled = ui.is_enabled();
            response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, found.name()));
            if response.on_hover_text(found.tip()).clicked() {
                chosen = Some(*found);
            }
        }
    });
    if let Some(found) = chosen {
        found.apply(scene);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn going_to_another_model_and_back_keeps_the_number() {
        let mut scene = Scene::default();
        let before = scene.clone();
        for next in [|m: &Match| matches!(m, Match::Blinn { .. }), |m: &Match| matches!(m, Match::CookTorrance { .. })]
        {
            let found = Match::of(&scene).into_iter().find(next).expect("a match");
            found.apply(&mut scene);
            assert_eq!(scene.validate(), Ok(()));
        }
        let back = Match::of(&scene).into_iter().find(|m| matches!(m, Match::Phong { .. })).expect("a match");
        back.apply(&mut scene);
        assert_eq!(scene.reflection.model, before.reflection.model);
        assert!((scene.material.n / before.material.n - 1.0).abs() < 1e-9, "{}", scene.material.n);
    }

    #[test]
    fn what_has_no_match_offers_none() {
        let mut scene = Scene::default();
        scene.material.n = f64::INFINITY;
        assert_eq!(Match::of(&scene), [Match::Blinn { n: f64::INFINITY }]);
        scene.reflection.model = ReflectionModel::Blinn;
        scene.material.n = 0.5;
        assert!(!Match::of(&scene).iter().any(|m| matches!(m, Match::Phong { .. })), "no Phong lobe is as wide");
    }
}
