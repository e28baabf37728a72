//! Commands that analyse nothing: `scenes`, `materials` and `parameters` list what there is, `check` opens a file, `code` writes
//! a scene as OpenGL calls or as shaders.

use super::input::SceneArguments;
use super::output::{Failure, print};
use clap::{Args, ValueEnum};
use serde_json::{Value, json};
use shading_lab::document::{Loaded, save_code};
use shading_lab::export::{Export, Part, glsl_330, opengl_c, opengl_c_snippet};
use shading_lab::geometry::tessellate;
use shading_lab::scene::materials::{NAMED, NamedMaterial};
use shading_lab::scene::parameter::{Kind, Parameter};
use shading_lab::scene::presets::{self, Preset};
use shading_lab::scene::{Rgb, Scene};
use shading_lab::text;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;

#[derive(Args)]
pub struct List {
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

impl List {
    pub fn scenes(self) -> Result<(), Failure> {
        let width = presets::ALL
            .iter()
            .map(|preset| preset.name.len())
            .max()
            .unwrap_or(0);
        let line = |preset: &Preset| format!("{:width$}  {}\n", preset.name, preset.sentence());
        let object = |preset: &Preset| {
            json!({
                "name": preset.name, "title": preset.title(), "topic": preset.topic_title(), "description": preset.sentence(),
                "view": preset.view(),
            })
        };
        self.print("scenes", presets::ALL, line, object)
    }

    pub fn materials(self) -> Result<(), Failure> {
        let widest = |text: fn(&NamedMaterial) -> &'static str| {
            NAMED.iter().map(|named| text(named).len()).max()
        };
        let (name, title) = (
            widest(|named| named.name).unwrap_or(0),
            widest(NamedMaterial::title).unwrap_or(0),
        );
        // Three numbers as a scene file writes them, in columns.
        let triple = |value: Rgb| {
            let [r, g, b] = value.to_array();
            format!("{:30}", format!("[{r}, {g}, {b}]"))
        };
        let line = |named: &NamedMaterial| {
            let NamedMaterial { ka, kd, ks, n, .. } = *named;
            let numbers = format!(
                "ka {}  kd {}  ks {}  n {n}",
                triple(ka),
                triple(kd),
                triple(ks)
            );
            format!(
                "{:name$}  {:title$}  {numbers}\n",
                named.name,
                named.title()
            )
        };
        let object = |named: &NamedMaterial| {
            let NamedMaterial {
                name,
                ka,
                kd,
                ks,
                n,
                ..
            } = *named;
            json!({"name": name, "title": named.title(), "ka": ka.to_array(), "kd": kd.to_array(), "ks": ks.to_array(), "n": n})
        };
        self.print("materials", NAMED, line, object)
    }

    pub fn parameters(self) -> Result<(), Failure> {
        let all: Vec<&'static Parameter> = Parameter::all().collect();
        let key = all
            .iter()
            .map(|parameter| parameter.key.len())
            .max()
            .unwrap_or(0);
        let default = all
            .iter()
            .map(|parameter| parameter.default_text().chars().count())
            .max()
            .unwrap_or(0);
        let line = |parameter: &&'static Parameter| {
            let Parameter {
                key: name, letter, ..
            } = parameter;
            let help = parameter.help();
            let letter = if letter.is_empty() {
                String::new()
            } else {
                format!("{letter}: ")
            };
            let (value, range) = (parameter.default_text(), parameter.range_text());
            format!("{name:key$}  {value:default$}  {range}\n    {letter}{help}\n")
        };
        let object = |parameter: &&'static Parameter| {
            let Parameter { key, letter, .. } = parameter;
            let limits = match (&parameter.kind, parameter.limits(&Scene::default())) {
                (Kind::Other(.., limits), _) => json!(limits()),
                // Infinity becomes null: no limit.
                (_, Some(limits)) => json!([limits.least, limits.greatest]),
                _ => Value::Null,
            };
            let choices: Vec<_> = parameter
                .options()
                .iter()
                .map(|option| option.word)
                .collect();
            json!({
                "key": key, "symbol": letter, "name": parameter.name(), "unit": parameter.unit(), "kind": parameter.kind_name(),
                "limits": limits, "default": parameter.default(), "choices": choices, "help": parameter.help(),
            })
        };
        self.print("parameters", &all, line, object)
    }

    /// A line or an object for each of `all`.
    fn print<T>(
        &self,
        name: &str,
        all: &[T],
        line: impl Fn(&T) -> String,
        object: impl Fn(&T) -> Value,
    ) -> Result<(), Failure> {
        match self.json {
            true => print(&format!(
                "{:#}\n",
                text::in_language(
                    text::Language::English,
                    || json!({ name: all.iter().map(object).collect::<Vec<_>>() })
                )
            )),
            false => print(&all.iter().map(line).collect::<String>()),
        }
    }
}

#[derive(Args)]
pub struct Check {
    /// A .toml, .obj or .png file, or a built-in scene's name
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Override one key of the scene first
    #[arg(long, value_name = "KEY=VALUE", allow_hyphen_values = true)]
    set: Vec<String>,
}

impl Check {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let name = self.file.display().to_string();
        let loaded = SceneArguments {
            source: Some(self.file),
            set: self.set,
            material: None,
        }
        .load(earlier)?;
        let scene = &loaded.scene;
        let [width, height] = scene.image.size;
        let polygons = loaded
            .model
            .map(|model| format!(", {} polygons", model.starts.len().saturating_sub(1)));
        let lights = scene.lights.len();
        print(&format!(
            "{name}: ok ({:?}{}, {lights} {}, {:?} shading, {width}×{height})\n",
            scene.object.kind,
            polygons.unwrap_or_default(),
            if lights == 1 { "light" } else { "lights" },
            scene.shading.mode,
        ))
    }
}

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
        let Loaded {
            scene, model, name, ..
        } = self.scene.load(earlier)?;
        let mesh = || model.unwrap_or_else(|| Arc::new(tessellate(&scene.object)));
        let export = match self.language {
            Language::C => opengl_c(&scene, &mesh())
                .map_err(|error| Failure::input(format!("{name}: {error}")))?,
            Language::CSnippet => opengl_c_snippet(&scene, &mesh()),
            Language::Glsl => glsl_330(&scene),
        };
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

/// All parts one after the other, each of several under its title.
fn joined(export: &Export) -> String {
    let [part] = &export.parts[..] else {
        let titled = |part: &Part| {
            format!(
                "// ---- {} (.{}) ----\n{}",
                part.title, part.ending, part.text
            )
        };
        return export.parts.iter().map(titled).collect();
    };
    part.text.clone()
}
