//! What actions do, as far as it concerns the state alone.

use super::action::{Action, Shown};
use super::document::Document;
use super::handles;
use super::look::NumbersTab;
use super::numbers::TABS;
use super::orbit;
use super::scan::ScanView;
use super::state::AppState;
use super::theme::{PROJECTOR_TEXT, SCALES, TEXT};
use crate::scene::{Camera, Light, Scene};

impl AppState {
    /// Does what concerns the state alone; returns what needs the window, files or the clipboard.
    ///
    /// `size` is the picture's, in pixels.
    pub fn perform(&mut self, action: Action, size: [u32; 2]) -> Option<Action> {
        match action {
            Action::New => self.open(Document::default()),
            Action::Undo => self.history.undo(&mut self.document),
            Action::Redo => self.history.redo(&mut self.document),
            Action::ResetCamera => self.reset_camera(),
            Action::Shade { mode, renormalise } => {
                self.shown.scene.shading.mode = mode;
                self.shown.scene.shading.renormalise = renormalise;
            }
            Action::Compare(view) => self.compare(view),
            Action::NextView => self.compare(self.next_view()),
            Action::Activate(pane) => self.activate(pane),
            Action::NextPane => {
                let shown = self.document.scene.shown_panes();
                let place = shown.iter().position(|pane| *pane == self.panes.active).unwrap_or(0);
                self.activate(shown[(place + 1) % shown.len()]);
            }
            Action::AddLight => self.add_light(Light::default(), size),
            Action::DuplicateLight(index) => {
                if let Some(light) = self.shown.scene.lights.get(index).cloned() {
                    self.add_light(light, size);
                }
            }
            Action::RemoveLight(index) => self.remove_light(index),
            Action::MoveProbe(by) => self.probe = self.probe.moved(by, size),
            Action::Orbit(by) => orbit::orbit(&mut self.shown.scene.camera, by[0], by[1]),
            Action::Pan(by) => orbit::pan(&mut self.shown.scene.camera, by[0], by[1]),
            Action::Zoom(factor) => orbit::zoom(&mut self.shown.scene.camera, factor),
            Action::Show(shown) => {
                let flag = self.flag(shown);
                *flag = !*flag;
            }
            Action::Normals => {
                let overlay = &mut self.look.overlay;
                let on = !overlay.normals();
                (overlay.face_normals, overlay.vertex_normals) = (on, on);
            }
            Action::SwitchTab => {
                let tabs = TABS.map(|tab| tab.key);
                let place = tabs.iter().position(|key| *key == self.look.tab).unwrap_or(0);
                let next = if self.look.numbers { tabs[(place + 1) % tabs.len()] } else { NumbersTab::Curves };
                self.show_tab(next);
            }
            Action::Scan(walk) => self.own.change(|view: &mut ScanView| view.walk(walk)),
            Action::Tab(tab) => self.show_tab(tab),
            Action::Theme(theme) => self.look.theme = theme,
            Action::Larger => self.look.scale = *SCALES.iter().find(|s| **s > self.look.scale + 0.01).unwrap_or(&2.5),
            Action::Smaller => {
                self.look.scale = *SCALES.iter().rev().find(|s| **s < self.look.scale - 0.01).unwrap_or(&0.8);
            }
            Action::OrdinarySize => self.look.scale = 1.0,
            Action::Projector => {
                let large = PROJECTOR_TEXT / TEXT;
                let enter = self.look.scale < large - 0.01;
                self.look.scale = if enter { large } else { 1.0 };
                // Large type leaves no room for the picture between two panels; F5 brings the numbers back.
                self.look.numbers = !enter;
            }
            other => return Some(other),
        }
        None
    }

    /// The switch that shows or hides something.
    pub fn flag(&mut self, shown: Shown) -> &mut bool {
        let look = &mut self.look;
        match shown {
            Shown::Controls => &mut look.controls,
            Shown::Numbers => &mut look.numbers,
            Shown::Stages => &mut look.stages,
            Shown::PictureAlone => &mut self.picture_alone,
            Shown::Vectors => &mut look.overlay.vectors,
            Shown::Angles => &mut look.overlay.angles,
            Shown::Construction => &mut look.overlay.construction,
            Shown::SideView => &mut look.overlay.side_view,
            Shown::Lobe => &mut look.overlay.lobe,
            Shown::HalfVector => &mut look.overlay.half_vector,
            Shown::Handles => &mut look.overlay.handles,
            Shown::FaceNormals => &mut look.overlay.face_normals,
            Shown::VertexNormals => &mut look.overlay.vertex_normals,
            Shown::Channels => &mut look.channels,
        }
    }

    fn reset_camera(&mut self) {
        let Camera { eye, target, up, roll, fov_y, height, .. } = self.saved.scene.camera.clone();
        let camera = &mut self.shown.scene.camera;
        (camera.eye, camera.target, camera.up, camera.roll) = (eye, target, up, roll);
        (camera.fov_y, camera.height) = (fov_y, height);
    }

    /// Adds a light like this one where it is seen and no other is.
    fn add_light(&mut self, light: Light, size: [u32; 2]) {
        let Scene { lights, camera, .. } = &mut self.shown.scene;
        if lights.len() >= Scene::MAX_LIGHTS {
            self.notice = Some(format!("a scene has at most {} lights", Scene::MAX_LIGHTS));
            return;
        }
        let light = handles::apart(light, lights, camera, size);
        lights.push(light);
        self.light = lights.len() - 1;
    }

    fn remove_light(&mut self, index: usize) {
        let lights = &mut self.shown.scene.lights;
        if index < lights.len() {
            lights.remove(index);
            self.light = self.light.min(lights.len().saturating_sub(1));
        }
    }
}
