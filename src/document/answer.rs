//! The answer of an analysis as a file.

use super::{SaveError, WriteError, save_frame, save_picture, write_whole};
use crate::analysis::{About, Answer, Figure, Format};
use crate::figure::Paper;
use std::path::Path;

impl Format {
    /// The format that a name's ending says.
    pub fn from_path(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_string_lossy().to_lowercase();
        Self::ALL.into_iter().find(|format| format.ending() == ending)
    }
}

/// Writes an answer; a figure in `size` and on `paper`, where it is one. A PNG of a scene has the scene inside.
///
/// # Errors
/// What cannot be written, or [`SaveError::Nothing`] where there is nothing to draw.
pub fn save_answer(
    path: &Path,
    format: Format,
    answer: &dyn Answer,
    about: &About<'_>,
    (size, paper): (Option<[u32; 2]>, Paper),
) -> Result<(), SaveError> {
    let figure = || answer.figure(about, size, paper).ok_or_else(|| SaveError::Nothing { path: path.to_owned() });
    match format {
        Format::Csv => write_text(path, &answer.csv(about)),
        Format::Json => write_text(path, &json_text(answer, about)),
        Format::Svg => match figure()? {
            Figure::Drawing { drawing, title } => write_text(path, &drawing.to_svg(&title)),
            Figure::Picture { .. } => Err(SaveError::Nothing { path: path.to_owned() }),
        },
        Format::Png => match figure()? {
            Figure::Drawing { drawing, .. } => {
                let frame = drawing.to_frame().ok_or_else(|| SaveError::TooLarge { path: path.to_owned() })?;
                save_picture(path, &frame, about.scene)
            }
            Figure::Picture { frame, scene: Some(scene) } => save_picture(path, &frame, &scene),
            Figure::Picture { frame, scene: None } => save_frame(path, &frame),
        },
    }
}

/// One JSON object. JSON has no infinity; it becomes null.
pub fn json_text(answer: &dyn Answer, about: &About<'_>) -> String {
    format!("{:#}\n", answer.json(about))
}

fn write_text(path: &Path, text: &str) -> Result<(), SaveError> {
    write_whole(path, |out| out.write_all(text.as_bytes()).map_err(WriteError::Io))
}
