//! A scene as code: calls of fixed-function OpenGL, or a pair of GLSL shaders.
//!
//! In: a [`Scene`] and, for the calls, its polygons. Out: an [`Export`], the text to copy and a list of what the
//! target cannot express, which also heads the text. Equal scenes give equal texts, in plain ASCII.

mod fixed;
mod glsl;
mod limit;
mod sources;
mod text;

pub use fixed::{MAX_PROGRAM_TRIANGLES, opengl_c, opengl_c_snippet};
pub use glsl::{glsl_330, glsl_330_of_model};
pub use limit::Limit;

use crate::geometry::{Mesh, VertexMesh};
use crate::render::Plan;
use crate::scene::{MaterialSource, Scene};
use crate::text::Message;
use std::path::{Path, PathBuf};

/// A scene as text in another language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Export {
    /// One or more files' worth of text, each complete.
    pub parts: Vec<Part>,
    /// Features of the scene that the text does not express; empty where it expresses everything.
    pub limits: Vec<Limit>,
}

impl Export {
    /// Returns the path of `part` when the whole is written to `target`: `target` itself, or beside it with the
    /// part's own ending if there are several.
    pub fn path_of(&self, part: &Part, target: &Path) -> PathBuf {
        match self.parts.len() {
            1 => target.to_owned(),
            _ => target.with_extension(part.ending),
        }
    }
}

/// One file of an [`Export`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Its title, a word or two.
    pub title: Message,
    /// The usual ending of the file's name, without the dot.
    pub ending: &'static str,
    /// The complete text, ASCII.
    pub text: String,
}

/// The reason why a scene has no text in the requested language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The polygons do not fit into a program's text.
    #[error("{}", crate::text!("export-too-large", triangles = *triangles, most = MAX_PROGRAM_TRIANGLES))]
    MeshTooLarge {
        /// Number of triangles; at most [`MAX_PROGRAM_TRIANGLES`] fit.
        triangles: usize,
    },
}

/// Returns the mesh with the vertex normals with which the scene's shading mode evaluates the equation.
pub fn export_mesh(scene: &Scene, mesh: &Mesh) -> VertexMesh {
    let mut vertices = mesh.with_vertex_normals(Plan::normals(scene), scene.object.weighting);
    if scene.material.source == MaterialSource::Scene {
        vertices.drop_materials();
    }
    vertices
}
