//! Without a command: the window.

use super::failure::Failure;
use super::input::SceneArguments;

/// Opens the window on a scene, or on the default one.
pub fn open(arguments: &SceneArguments) -> Result<(), Failure> {
    let loaded = arguments.load(&[])?;
    let _ = loaded;
    Err(Failure::work("built without a window, expected a command: see shading-lab --help"))
}
