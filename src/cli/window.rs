//! Without a command: the window.

use super::failure::Failure;
use super::input::SceneArguments;

/// Opens the window on a scene, or on the default one.
#[cfg(feature = "app")]
pub fn open(arguments: &SceneArguments) -> Result<(), Failure> {
    let loaded = arguments.load(&[])?;
    shading_lab::app::run(loaded).map_err(Failure::work)
}

/// Says that this program has no window.
#[cfg(not(feature = "app"))]
pub fn open(arguments: &SceneArguments) -> Result<(), Failure> {
    arguments.load(&[])?;
    Err(Failure::work("built without a window, expected a command: see shading-lab --help"))
}
