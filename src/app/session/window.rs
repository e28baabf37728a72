//! What a window remembers of how the session is looked at.

use super::appearance::{Appearance, ViewName};
use super::place::{ProbePoint, ProfileLine};
use crate::figure::Area;
use eframe::egui::Vec2;
use glam::{DVec2, DVec3};
use std::any::{Any, TypeId};
use std::collections::HashMap;

/// How the session is looked at.
#[derive(Default)]
pub struct WindowState {
    /// The window's looks, which are written to disk between two starts.
    pub appearance: Appearance,
    /// The pixel that is probed.
    pub probe: ProbePoint,
    /// Whether the probe is to be put beside the highlight, once the picture is drawn.
    pub seek_highlight: bool,
    /// Where the profile is taken.
    pub line: ProfileLine,
    /// The vertex whose faces are lit up, while normals are shown.
    pub pointed: PointedVertex,
    /// What is being dragged in the picture.
    pub drag: Option<Drag>,
    /// What handles and captions cover in the active pane, in its pixels: the letters of vectors keep off it.
    pub covered: Vec<Area>,
    /// Shows the open view alone.
    pub enlarged: bool,
    /// The controls that the window shows as a figure in another page, by the words of the link.
    pub embedded: Option<Vec<String>>,
    /// Whether the first start's card is shown.
    pub welcome: bool,
    /// Shows the picture alone.
    pub picture_alone: bool,
    /// Size of the picture with all its panes, pixels.
    pub room: [u32; 2],
    /// What views and dialogs remember for themselves.
    pub own: ViewStates,
}

impl WindowState {
    /// Whether a view is in sight.
    pub fn shows(&self, view: ViewName) -> bool {
        self.appearance.views && !self.picture_alone && self.appearance.view == view
    }

    /// Opens a view, and the panel.
    pub fn show_view(&mut self, view: ViewName) {
        (self.appearance.views, self.appearance.view) = (true, view);
    }
}

/// The vertex that the pointer is on, or was clicked on, in the active pane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PointedVertex {
    /// The vertex that is lit up, by its number among those with normals.
    pub lit: Option<u32>,
    /// The point of the mesh that was clicked on: its vertex stays lit when the pointer is elsewhere, whichever normals are
    /// chosen.
    pub kept: Option<u32>,
}

/// What the pointer drags in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    pub grip: Grip,
    /// From the pointer to the middle of what it holds, pixels.
    pub grab: DVec2,
    /// A light changes its distance, a vertex moves towards the viewer and away; the camera moves along the picture's plane.
    pub deep: bool,
    /// Where the light was that it holds.
    pub start: LightStart,
}

/// Where a light was when a drag of it began.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LightStart {
    /// From the object's middle towards the light, world.
    pub offset: DVec3,
    /// Its handle, in the picture's pixels.
    pub pixel: DVec2,
    /// Whether the handle was where the light is, not at the picture's edge.
    pub in_picture: bool,
}

/// What the pointer can take hold of in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grip {
    /// An end of the profile's line.
    LineEnd(usize),
    /// The knob by which the picture is turned.
    Roll,
    /// A light, by its index.
    Light(usize),
    /// The head of the chosen light's axis, on the viewer's side of the light or beyond.
    Aim {
        front: bool,
    },
    /// The edge of the chosen spot light's cone; the unit vector points away from its axis.
    Rim(Vec2),
    /// A vertex of the scene's own polygons, by its number.
    Vertex(u32),
    Probe,
    /// The place that is marked as the answer to a question.
    Mark,
    /// The line of a wipe.
    Wipe,
    /// The camera about its target.
    Camera,
}

/// What each view and dialog remembers, kept by its type, so that the window's state need not know them.
#[derive(Debug, Default)]
pub struct ViewStates(HashMap<TypeId, Box<dyn Any>>);

impl ViewStates {
    /// The value, if there is one yet.
    pub fn get<T: 'static>(&self) -> Option<&T> {
        self.0.get(&TypeId::of::<T>())?.downcast_ref()
    }

    /// Takes the value out, to be put back; its default if there is none yet.
    pub fn take<T: Default + 'static>(&mut self) -> T {
        let value = self
            .0
            .remove(&TypeId::of::<T>())
            .and_then(|value| value.downcast().ok());
        value.map(|value| *value).unwrap_or_default()
    }

    /// Puts a value in its place.
    pub fn put<T: 'static>(&mut self, value: T) {
        self.0.insert(TypeId::of::<T>(), Box::new(value));
    }

    /// Changes the value.
    pub fn change<T: Default + 'static>(&mut self, change: impl FnOnce(&mut T)) {
        let mut value = self.take();
        change(&mut value);
        self.put(value);
    }
}
