//! What can be asked of the window. Menus, buttons and keys all ask here, so that each does the same by every way.

use super::document::Document;
use super::handles;
use super::orbit;
use super::scan::Walk;
use super::state::{AppState, NumbersTab};
use super::theme::{PROJECTOR_TEXT, SCALES, TEXT, ThemeChoice};
use crate::scene::{Camera, CompareView, Light, Scene, ShadingMode};
use std::path::PathBuf;

/// Something to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// The scene that the program starts with.
    New,
    /// Asks for a file to open.
    Open,
    OpenFile(PathBuf),
    OpenBuiltIn(String),
    Save,
    SaveAs,
    SaveTo(PathBuf),
    /// Asks how to export the picture.
    Export,
    CopyPicture,
    /// Shows the scene as code.
    Code,
    /// Asks where to save the profile, in the format of this ending.
    SaveProfile(&'static str),
    Undo,
    Redo,
    ResetCamera,
    Shade {
        mode: ShadingMode,
        renormalise: bool,
    },
    AddLight,
    DuplicateLight(usize),
    RemoveLight(usize),
    /// Moves the probe by pixels.
    MoveProbe([i32; 2]),
    /// Turns the camera about its target, degrees to the right and up.
    Orbit([f64; 2]),
    /// Moves the camera sideways and up, in heights of the picture.
    Pan([f64; 2]),
    /// Multiplies the distance from the target.
    Zoom(f64),
    Show(Shown),
    /// Shows the normals of polygons and of vertices, or hides both.
    Normals,
    /// Shows panes in this way.
    Compare(CompareView),
    /// The next way of showing panes.
    NextView,
    /// Makes a pane the one that the controls show.
    Activate(usize),
    /// The next pane.
    NextPane,
    /// The other tab of the panel of numbers, which opens if it is closed.
    SwitchTab,
    /// Steps through the scan of a polygon.
    Scan(Walk),
    /// A tab of the panel of numbers, which opens if it is closed.
    Tab(NumbersTab),
    Theme(ThemeChoice),
    Larger,
    Smaller,
    OrdinarySize,
    Projector,
    Keys,
    About,
    /// Closes the window; asks first where there are unsaved changes.
    Quit,
    /// Closes the window and drops unsaved changes.
    CloseUnsaved,
    /// Opens the unsaved work that a window left behind.
    Restore,
    /// Goes on with that work as this window's own.
    AdoptRestored,
    /// Removes that work.
    DeleteLeft,
}

/// What can be shown and hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    Controls,
    Numbers,
    Stages,
    PictureAlone,
    Vectors,
    Angles,
    Construction,
    SideView,
    Lobe,
    HalfVector,
    Handles,
    FaceNormals,
    VertexNormals,
}

impl Action {
    /// Whether it replaces the whole document, of whichever pane.
    pub fn concerns_document(&self) -> bool {
        matches!(self, Self::New | Self::Undo | Self::Redo)
    }
}

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
                self.document.scene.shading.mode = mode;
                self.document.scene.shading.renormalise = renormalise;
            }
            Action::Compare(view) => self.compare(view),
            Action::NextView => self.compare(self.next_view()),
            Action::Activate(pane) => self.activate(pane),
            Action::NextPane => {
                let shown = self.shared_scene().shown_panes();
                let place = shown.iter().position(|pane| *pane == self.panes.active).unwrap_or(0);
                self.activate(shown[(place + 1) % shown.len()]);
            }
            Action::AddLight => self.add_light(Light::default(), size),
            Action::DuplicateLight(index) => {
                if let Some(light) = self.document.scene.lights.get(index).cloned() {
                    self.add_light(light, size);
                }
            }
            Action::RemoveLight(index) => self.remove_light(index),
            Action::MoveProbe(by) => self.probe = self.probe.moved(by, size),
            Action::Orbit(by) => orbit::orbit(&mut self.document.scene.camera, by[0], by[1]),
            Action::Pan(by) => orbit::pan(&mut self.document.scene.camera, by[0], by[1]),
            Action::Zoom(factor) => orbit::zoom(&mut self.document.scene.camera, factor),
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
                let next = match self.look.tab {
                    NumbersTab::Equation => NumbersTab::Curves,
                    NumbersTab::Curves => NumbersTab::Profile,
                    NumbersTab::Profile => NumbersTab::ScanLine,
                    NumbersTab::ScanLine => NumbersTab::Compare,
                    NumbersTab::Compare => NumbersTab::Defects,
                    NumbersTab::Defects => NumbersTab::Plan,
                    NumbersTab::Plan => NumbersTab::Study,
                    NumbersTab::Study => NumbersTab::Stability,
                    NumbersTab::Stability => NumbersTab::Equation,
                };
                self.look.tab = if self.look.numbers { next } else { NumbersTab::Curves };
                self.look.numbers = true;
            }
            Action::Scan(walk) => self.scan.walk(walk),
            Action::Tab(tab) => {
                self.look.tab = tab;
                self.look.numbers = true;
            }
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
        }
    }

    fn reset_camera(&mut self) {
        let Camera { eye, target, up, roll, fov_y, height, .. } = self.saved.scene.camera.clone();
        let camera = &mut self.document.scene.camera;
        (camera.eye, camera.target, camera.up, camera.roll) = (eye, target, up, roll);
        (camera.fov_y, camera.height) = (fov_y, height);
    }

    /// Adds a light like this one where it is seen and no other is.
    fn add_light(&mut self, light: Light, size: [u32; 2]) {
        let Scene { lights, camera, .. } = &mut self.document.scene;
        if lights.len() >= Scene::MAX_LIGHTS {
            self.notice = Some(format!("a scene has at most {} lights", Scene::MAX_LIGHTS));
            return;
        }
        let light = handles::apart(light, lights, camera, size);
        lights.push(light);
        self.light = lights.len() - 1;
    }

    fn remove_light(&mut self, index: usize) {
        let lights = &mut self.document.scene.lights;
        if index < lights.len() {
            lights.remove(index);
            self.light = self.light.min(lights.len().saturating_sub(1));
        }
    }
}
