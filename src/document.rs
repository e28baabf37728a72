//! Scenes and pictures as files: opened by path or built-in name, written whole or not at all.
//!
//! In memory the path of a model is absolute. In a scene file it is written relative to that file where the model lies
//! beside or below it, so that the two can be moved together; in a picture, which gets about alone, it stays absolute.

mod answer;
mod load;
mod save;

pub use answer::{json_text, save_answer};
pub use load::{LoadError, Loaded, Progress, load, load_model, load_with};
pub use save::{SaveError, WriteError, check_target, save_code, save_frame, save_picture, save_scene, write_whole};
