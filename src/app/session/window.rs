//! The state of a window, apart from its session: what is in view, and how.

use super::appearance::{Appearance, ViewName};
use super::place::{ProbePoint, ProfileLine};
use crate::figure::Area;
use eframe::egui::Vec2;
use glam::{DVec2, DVec3};
use std::any::{Any, TypeId};
use std::collections::HashMap;

/// The state of a window, apart from its session: what is in view, and how.
#[derive(Default)]
pub struct WindowState {
    /// The window's appearance, stored on disk between two starts.
    pub appearance: Appearance,
    /// The position of the probe.
    pub probe: ProbePoint,
    /// True if the probe is to be put beside the highlight, once the picture is drawn.
    pub seek_highlight: bool,
    /// The line of the profile.
    pub line: ProfileLine,
    /// The vertex whose faces are highlighted, while normals are shown.
    pub pointed: PointedVertex,
    /// The drag in the picture, if any.
    pub drag: Option<Drag>,
    /// The areas that handles and captions cover in the active pane, in its pixels: the letters of vectors avoid them.
    pub covered: Vec<Area>,
    /// True if the open view is shown alone.
    pub enlarged: bool,
    /// True if the window is so narrow that its panels are a drawer.
    pub drawer: bool,
    /// The figure, if the window is embedded as one in another page.
    pub embedded: Option<Figure>,
    /// True if the welcome card of the first start is shown.
    pub welcome: bool,
    /// True if the picture is shown alone.
    pub picture_alone: bool,
    /// True if views hide their numbers, and what they draw over the picture, until a question is answered.
    pub hidden: bool,
    /// Size of the picture with all its panes, pixels.
    pub room: [u32; 2],
    /// The states of views and dialogs.
    pub own: ViewStates,
}

impl WindowState {
    /// Returns whether a view is visible.
    pub fn shows(&self, view: ViewName) -> bool {
        let of_course = matches!(view, ViewName::Course | ViewName::Class);
        let hidden = self.hidden && !of_course;
        self.appearance.views && !self.picture_alone && !hidden && self.appearance.view == view
    }

    /// Opens a view, and the panel.
    pub fn show_view(&mut self, view: ViewName) {
        (self.appearance.views, self.appearance.view) = (true, view);
    }

    /// Closes the welcome for good.
    pub fn end_welcome(&mut self) {
        (self.welcome, self.appearance.welcomed) = (false, true);
    }
}

/// A window as a figure in another page.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    /// The controls below the picture, by their names in the link.
    pub controls: Vec<String>,
    /// The error in the link, shown in place of the picture.
    pub problem: Option<String>,
}

/// The vertex under the pointer, or clicked on, in the active pane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PointedVertex {
    /// The highlighted vertex, by its index among those with normals.
    pub lit: Option<u32>,
    /// The point of the mesh that was clicked on: its vertex stays highlighted when the pointer is elsewhere, whichever
    /// normals are chosen.
    pub kept: Option<u32>,
}

/// A drag in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    pub grip: Grip,
    /// Offset from the pointer to the middle of the grip, pixels.
    pub grab: DVec2,
    /// True for the other mode of dragging: a light changes its distance, a vertex moves towards the viewer or away,
    /// and the camera moves along the picture's plane.
    pub deep: bool,
    /// The position of the dragged light at the start.
    pub start: LightStart,
}

/// The position of a light when a drag of it began.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LightStart {
    /// Offset from the object's middle towards the light, world.
    pub offset: DVec3,
    /// Position of the light's handle, in the picture's pixels.
    pub pixel: DVec2,
    /// True if the handle was at the light's position, not at the picture's edge.
    pub in_picture: bool,
}

/// A part of the picture that the pointer can drag.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grip {
    /// An end of the profile's line.
    LineEnd(usize),
    /// The knob that rolls the picture.
    Roll,
    /// A light, by its index.
    Light(usize),
    /// The head of the chosen light's axis, on the viewer's side of the light or beyond.
    Aim {
        front: bool,
    },
    /// The edge of the chosen spot light's cone; the unit vector points away from its axis.
    Rim(Vec2),
    /// A vertex of the scene's own polygons, by its index.
    Vertex(u32),
    Probe,
    /// The point marked as the answer to a question.
    Mark,
    /// The line of a wipe.
    Wipe,
    /// The side view of the vectors, which a click enlarges.
    SideView,
    /// The camera about its target.
    Camera,
}

/// The states of views and dialogs, keyed by type, so that the window's state need not know them.
#[derive(Debug, Default)]
pub struct ViewStates(HashMap<TypeId, Box<dyn Any>>);

impl ViewStates {
    /// Returns the value of type `T`, if there is one yet.
    pub fn get<T: 'static>(&self) -> Option<&T> {
        self.0.get(&TypeId::of::<T>())?.downcast_ref()
    }

    /// Takes the value out, to be put back; returns its default if there is none yet.
    pub fn take<T: Default + 'static>(&mut self) -> T {
        let value = self
            .0
            .remove(&TypeId::of::<T>())
            .and_then(|value| value.downcast().ok());
        value.map(|value| *value).unwrap_or_default()
    }

    /// Stores a value under its type.
    pub fn put<T: 'static>(&mut self, value: T) {
        self.0.insert(TypeId::of::<T>(), Box::new(value));
    }

    /// Changes the value of type `T`.
    pub fn change<T: Default + 'static>(&mut self, change: impl FnOnce(&mut T)) {
        let mut value = self.take();
        change(&mut value);
        self.put(value);
    }
}
