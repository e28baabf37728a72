//! The scene of a step and its view, as its block has them.

use super::reader::{Block, Reader};
use crate::lesson::stage::{OVERLAYS, Stage, view};
use crate::link::VIEWS;
use crate::text::text;
use glam::DVec2;
use serde::Deserialize;
use toml::Spanned;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawStage {
    scene: Option<String>,
    #[serde(default)]
    set: Vec<String>,
    lights: Option<usize>,
    panes: Option<Vec<String>>,
    view: Option<Spanned<String>>,
    probe: Option<[f64; 2]>,
    line: Option<[f64; 4]>,
    overlays: Option<Spanned<Vec<String>>>,
    controls: Option<Vec<String>>,
    hide: Option<bool>,
}

impl Reader<'_> {
    pub(super) fn stage(&mut self, block: &Block<'_>, stage: &mut Stage) {
        let Some(raw) = self.toml::<RawStage>(block) else {
            return;
        };
        stage.line_number = self.line(block.at);
        if let Some(scene) = raw.scene {
            *stage = Stage {
                scene,
                line_number: stage.line_number,
                hide: stage.hide,
                ..Stage::default()
            };
        }
        stage.set.extend(raw.set);
        stage.lights = raw.lights.or(stage.lights);
        stage.panes = raw.panes.or(stage.panes.take());
        stage.hide = raw.hide.unwrap_or(stage.hide);
        stage.probe = raw.probe.map(DVec2::from_array).or(stage.probe);
        let line = |[a, b, c, d]: [f64; 4]| [DVec2::new(a, b), DVec2::new(c, d)];
        stage.line = raw.line.map(line).or(stage.line);
        stage.controls = raw.controls.unwrap_or(std::mem::take(&mut stage.controls));
        if let Some(name) = raw.view {
            stage.view = view(name.get_ref());
            if stage.view.is_none() {
                let words = text!("expected-one-of", words = VIEWS.join(", "));
                let words = text!("lesson-key", key = "view", words = words);
                self.wrong(block.at + name.span().start, words);
            }
        }
        if let Some(overlays) = raw.overlays {
            let at = block.at + overlays.span().start;
            stage.overlays.clear();
            for name in overlays.into_inner() {
                match OVERLAYS.into_iter().find(|overlay| *overlay == name) {
                    Some(overlay) => stage.overlays.push(overlay),
                    None => {
                        let words = text!("expected-one-of", words = OVERLAYS.join(", "));
                        self.wrong(at, text!("lesson-key", key = "overlays", words = words));
                    }
                }
            }
        }
        if let Err(words) = stage.check() {
            self.wrong(block.at, words);
        }
    }
}
