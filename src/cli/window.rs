//! Without a command: the window.

use super::failure::Failure;
use super::input::SceneArguments;

/// Opens the window on the scene that was asked for; asked for none, the window chooses.
#[cfg(feature = "app")]
pub fn open(arguments: &SceneArguments) -> Result<(), Failure> {
    let asked = arguments.source.is_some() || !arguments.set.is_empty();
    let initial = if asked { Some(arguments.load(&[])?) } else { None };
    shading_lab::app::run(initial).map_err(Failure::work)
}

/// Says that there is no window to open a sound scene in.
#[cfg(not(feature = "app"))]
pub fn open(arguments: &SceneArguments) -> Result<(), Failure> {
    arguments.load(&[])?;
    Err(Failure::work("built without a window (the feature `app`), expected a command: see shading-lab --help"))
}
