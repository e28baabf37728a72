//! What can be asked of the window. Menus, buttons and keys all ask here, so that each does the same by every way.

use super::look::NumbersTab;
use super::theme::ThemeChoice;
use crate::analysis::{Format, ScanLevel};
use crate::scene::{CompareView, ShadingMode};
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
    /// Asks where to save the answer of the analysis of this name, in this format.
    SaveAnswer(&'static str, Format),
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
    /// RGB values where coefficients have one number otherwise.
    Channels,
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
