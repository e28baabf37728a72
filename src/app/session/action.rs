//! What can be asked of the window. Menus, buttons and keys all ask here, so that each does the same by every way.

use super::appearance::{Appearance, ViewName};
use crate::analysis::{Format, ScanLevel};
use crate::scene::{CompareView, Light, ShadingMode};
use std::path::PathBuf;

/// Something to do.
#[derive(Clone, Debug)]
pub enum Action {
    /// Asks for a file to open.
    Open,
    OpenFile(PathBuf),
    OpenBuiltIn(String),
    /// The gallery of built-in scenes.
    Scenes,
    /// The built-in scene so many places further.
    NextScene(isize),
    Save,
    SaveAs,
    SaveTo(PathBuf),
    Export,
    CopyPicture,
    /// Puts the link of what is seen on the clipboard.
    CopyLink,
    /// Opens what is seen in a page of its own.
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
    /// Takes the value of the row that has the focus back to what it was as opened.
    ResetRow,
    /// Gives the picture the focus, where the arrows move the probe.
    TakeProbe,
    /// Gives the menus the focus.
    Menus,
    Shade {
        mode: ShadingMode,
        renormalise: bool,
    },
    /// Adds a light like this one, where no other is.
    AddLight(Light),
    /// Moves the probe by pixels.
    MoveProbe([i32; 2]),
    /// Turns the camera about its target, degrees to the right and up.
    Orbit([f64; 2]),
    /// Moves the camera sideways and up, in heights of the picture.
    Pan([f64; 2]),
    /// Multiplies the distance from the target.
    Zoom(f64),
    /// Shows or hides what a switch of the look stands for.
    Show(fn(&mut Appearance) -> &mut bool),
    /// Changes how the window looks in another way.
    ChangeLook(fn(&mut Appearance)),
    /// Shows nothing but the picture, on the whole screen, and back.
    PictureAlone,
    /// Shows panes in this way.
    Compare(CompareView),
    NextComparison,
    /// Makes a pane the one that the controls show.
    Activate(usize),
    NextPane,
    /// Shows all shading modes side by side.
    AllModes,
    /// Moves a pane to the place of another.
    MovePane(usize, usize),
    RemovePane(usize),
    /// Measures the others against this pane.
    Reference(usize),
    /// Steps through the scan of a polygon.
    Scan(Walk),
    /// A view, whose panel opens if it is closed.
    View(ViewName),
    /// What is asked of the course.
    Course(Turn),
    /// Asks for a name and a file for the answers to the lesson.
    HandIn,
    /// Makes the scene in view the target of a match.
    SetTarget,
    /// Loads the scene of the step that is open.
    LoadStage,
    /// Shows the scene that the right answer is about.
    ShowAnswer,
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
    DeleteLeft,
}

/// A way through the course.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Turn {
    /// The first lesson.
    Start,
    /// A lesson of the program, by its name.
    Open(String),
    /// Opens the built-in lesson of that name at a step, from 0.
    OpenAt(String, usize),
    /// The lesson that was opened from a file.
    Own,
    /// So many steps further.
    Step(isize),
    To(usize),
    /// The scene of the step as it was at first.
    Again,
    /// All lessons.
    List,
}

/// A way through the steps of a scanned polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Walk {
    First,
    Back(ScanLevel),
    Forward(ScanLevel),
    Last,
    /// Plays, or pauses.
    Play,
}

/// What was asked for in this frame; done at its end.
#[derive(Debug, Default)]
pub struct Requests(Vec<Action>);

impl Requests {
    /// Asks for an action.
    pub fn ask(&mut self, action: Action) {
        self.0.push(action);
    }

    /// Takes what was asked for.
    pub fn take(&mut self) -> Vec<Action> {
        std::mem::take(&mut self.0)
    }
}

impl Extend<Action> for Requests {
    fn extend<T: IntoIterator<Item = Action>>(&mut self, actions: T) {
        self.0.extend(actions);
    }
}
