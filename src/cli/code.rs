//! `code`: a scene as OpenGL calls or as shaders.

use super::failure::Failure;
use super::input::SceneArguments;
use super::output::print;
use clap::{Args, ValueEnum};
use shading_lab::document::{Loaded, save_code};
use shading_lab::export::{Export, Part, glsl_330, opengl_c, opengl_c_snippet};
use shading_lab::geometry::tessellate;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;

#[derive(Args)]
pub struct Code {
    #[command(flatten)]
    scene: SceneArguments,
    /// What to write it in
    #[arg(long, value_enum, default_value_t = Language::CSnippet)]
    language: Language,
    /// The file to write instead of stdout; shaders go to two files of that name, ending in .vert and .frag
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Language {
    /// A whole program in C that draws the scene with fixed-function OpenGL, off screen
    C,
    /// Its camera, lights and material only
    CSnippet,
    /// A vertex and a fragment shader, GLSL 3.30
    Glsl,
}

impl Code {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let loaded = self.scene.load(earlier)?;
        let export = export(&loaded, self.language)?;
        match &self.output {
            None => print(&joined(&export))?,
            Some(target) => save_code(target, &export)?,
        }
        for limit in &export.limits {
            // Without stderr there is nowhere to say so.
            let _ = writeln!(io::stderr(), "note: {limit}");
        }
        Ok(())
    }
}

fn export(loaded: &Loaded, language: Language) -> Result<Export, Failure> {
    let scene = &loaded.scene;
    let mesh = || loaded.model.clone().unwrap_or_else(|| Arc::new(tessellate(&scene.object)));
    match language {
        Language::C => opengl_c(scene, &mesh()).map_err(|error| Failure::input(format!("{}: {error}", loaded.name))),
        Language::CSnippet => Ok(opengl_c_snippet(scene, &mesh())),
        Language::Glsl => Ok(glsl_330(scene)),
    }
}

/// All parts one after the other, each of several under its title.
fn joined(export: &Export) -> String {
    let [part] = &export.parts[..] else {
        let titled = |part: &Part| format!("// ---- {} (.{}) ----\n{}", part.title, part.ending, part.text);
        return export.parts.iter().map(titled).collect();
    };
    part.text.clone()
}
