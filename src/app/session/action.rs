//! The actions of the window. Menus, buttons and keys all request them here, so that each does the same in every way.

use super::appearance::{Appearance, ViewName};
use crate::analysis::Format;
use crate::analysis::scan::ScanLevel;
#[cfg(feature = "class")]
use crate::class::Command;
use crate::scene::{CompareView, Light, ShadingMode, Symbol};
use std::path::PathBuf;

/// A request to the window.
#[derive(Clone, Debug)]
pub enum Action {
    /// Asks for a file to open.
    Open,
    OpenFile(PathBuf),
    OpenBuiltIn(String),
    /// Shows the gallery of built-in scenes.
    Scenes,
    /// Shows the search for whatever the window can do.
    Find,
    /// Shows the row of the parameter with this key.
    Seek(&'static str),
    /// Shows the controls of a symbol of the equation.
    SeekSymbol(Symbol),
    /// Opens the built-in scene at this distance from the present one, in their order.
    NextScene(isize),
    Save,
    SaveAs,
    SaveTo(PathBuf),
    /// Shows this folder in the desktop's file manager.
    ShowFolder(PathBuf),
    Export,
    CopyPicture,
    /// Copies the link of the current view to the clipboard.
    CopyLink,
    /// Opens the current view in a web page of its own.
    OpenPage,
    /// Opens the scene of a link.
    OpenLink(String),
    /// Shows the link as a QR code.
    ShowCode,
    /// Asks for the address of the page that links begin with.
    Page,
    Code,
    /// Asks where to save the answer of the analysis of this name, in this format.
    SaveAnswer(&'static str, Format),
    Undo,
    Redo,
    ResetCamera,
    /// Restores the scene as it was opened.
    ResetScene,
    /// Restores the view and the layout of the window as at the first start.
    ResetLayout,
    /// Restores the scene as it was opened, and the view and the layout of the window.
    ResetAll,
    /// Resets the value of the focused row to that of the opened scene.
    ResetRow,
    /// Gives the picture the focus, so that the arrow keys move the probe.
    TakeProbe,
    /// Gives the menus the focus.
    Menus,
    Shade {
        mode: ShadingMode,
        renormalise: bool,
    },
    /// Adds a light like this one, at a distance from the other lights.
    AddLight(Light),
    /// Moves the probe by pixels.
    MoveProbe([i32; 2]),
    /// Orbits the camera about its target, degrees to the right and up.
    Orbit([f64; 2]),
    /// Moves the camera sideways and up, in heights of the picture.
    Pan([f64; 2]),
    /// Multiplies the distance from the target.
    Zoom(f64),
    /// Toggles a switch of the appearance.
    Show(fn(&mut Appearance) -> &mut bool),
    /// Changes the appearance in another way.
    ChangeAppearance(fn(&mut Appearance)),
    /// Toggles the view of the picture alone on the whole screen.
    PictureAlone,
    /// Shows the panes in this view.
    Compare(CompareView),
    NextComparison,
    /// Makes a pane the active one, which the controls show.
    Activate(usize),
    NextPane,
    /// Shows all shading modes side by side.
    AllModes,
    /// Moves a pane to the position of another.
    MovePane(usize, usize),
    RemovePane(usize),
    /// Makes a pane the reference that the others are compared with.
    Reference(usize),
    /// Steps through the scan of a polygon.
    Scan(Walk),
    /// Shows a view, and opens its panel if it is closed.
    View(ViewName),
    /// Moves through the course.
    Course(Turn),
    /// Starts a live class, leads it, or ends it.
    #[cfg(feature = "class")]
    Class(ClassAction),
    /// Asks for a name and a file for the answers to the lesson.
    HandIn,
    /// Makes the current scene the target of a match.
    SetTarget,
    /// Loads the scene of the open step.
    LoadStage,
    /// Shows the scene that the right answer is about.
    ShowAnswer,
    Manual,
    Keys,
    About,
    /// Closes the window; asks first if there are unsaved changes.
    Quit,
    /// Closes the window and discards unsaved changes.
    CloseUnsaved,
    /// Opens the unsaved work that a window left behind.
    Restore,
    /// Continues the restored work as this window's own.
    AdoptRestored,
    DeleteLeft,
}

impl Action {
    /// Returns whether the action would show the answer to an open question, or leave the step's picture: it waits until
    /// the question is answered. Changes of the scene that go through [`super::Session::commit`] wait there.
    pub fn waits(&self) -> bool {
        matches!(
            self,
            Self::Shade { .. }
                | Self::AddLight(_)
                | Self::Compare(_)
                | Self::NextComparison
                | Self::AllModes
                | Self::MovePane(..)
                | Self::RemovePane(_)
                | Self::Reference(_)
                | Self::Export
                | Self::Code
                | Self::SaveAnswer(..)
        )
    }
}

/// A step in the course.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Turn {
    /// The first lesson.
    Start,
    /// A built-in lesson, by its name.
    Open(String),
    /// A step of a built-in lesson, by the lesson's name and the step's index.
    OpenAt(String, usize),
    /// The lesson opened from a file.
    Own,
    /// A number of steps forwards; backwards if negative.
    Step(isize),
    To(usize),
    /// The scene of the step as it was at first.
    Again,
    /// The list of lessons.
    List,
}

/// An action on a live class.
#[cfg(feature = "class")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ClassAction {
    /// Asks for the file of the answers.
    Teach,
    /// Starts it about the open lesson, with the answers in this file.
    Start(PathBuf),
    /// Shows the step in place of the address for those who join.
    Begin,
    Perform(Command),
    /// The next thing: the answers, the explanation, or the next step.
    Onward,
    End,
}

/// A move through the steps of a scanned polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Walk {
    First,
    Back(ScanLevel),
    Forward(ScanLevel),
    Last,
    /// Plays, or pauses.
    Play,
}

/// The actions requested in this frame; they are carried out at its end.
#[derive(Debug, Default)]
pub struct Requests(Vec<Action>);

impl Requests {
    /// Requests an action.
    pub fn ask(&mut self, action: Action) {
        self.0.push(action);
    }

    /// Takes the requested actions.
    pub fn take(&mut self) -> Vec<Action> {
        std::mem::take(&mut self.0)
    }
}

impl Extend<Action> for Requests {
    fn extend<T: IntoIterator<Item = Action>>(&mut self, actions: T) {
        self.0.extend(actions);
    }
}
