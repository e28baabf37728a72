//! Commands that analyse nothing: `scenes`, `materials` and `parameters` list the built-in ones, `code` writes a
//! scene as OpenGL calls or as shaders.

use super::input::{SceneArguments, output_file};
use super::output::{Failure, note, print, print_json, spinner, widest};
use clap::{Args, ValueEnum};
use serde_json::{Value, json};
use shading_lab::document::{Loaded, STDOUT, save_code};
use shading_lab::export::{Export, Part, glsl_330_of_model, opengl_c, opengl_c_snippet};
use shading_lab::geometry::tessellate;
use shading_lab::render::check_memory_for;
use shading_lab::scene::materials::{NAMED, NamedMaterial};
use shading_lab::scene::parameter::{Kind, Parameter};
use shading_lab::scene::presets::{self, Preset};
use shading_lab::scene::{Rgb, Scene};
use shading_lab::text::{Language, in_language, text};
use std::path::{Path, PathBuf};
use std::sync::Arc;

#[derive(Args)]
pub struct List {
    #[arg(long)]
    json: bool,
}

impl List {
    pub fn scenes(self) -> Result<(), Failure> {
        let width = widest(presets::ALL.iter().map(|preset| preset.name));
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
        let width = widest(NAMED.iter().map(|named| named.name));
        // Three numbers as in a scene file, in columns.
        let triple = |value: Rgb| {
            let [r, g, b] = value.to_array();
            format!("{:30}", format!("[{r}, {g}, {b}]"))
        };
        let line = |named: &NamedMaterial| {
            let NamedMaterial { ka, kd, ks, n, .. } = *named;
            let [ka, kd, ks] = [ka, kd, ks].map(triple);
            let title = named.title();
            format!(
                "{:width$}  ka {ka}  kd {kd}  ks {ks}  n {n:<10}  {title}\n",
                named.name
            )
        };
        let object = |named: &NamedMaterial| {
            json!({
                "name": named.name, "title": named.title(), "ka": named.ka.to_array(), "kd": named.kd.to_array(),
                "ks": named.ks.to_array(), "n": named.n,
            })
        };
        self.print("materials", NAMED, line, object)
    }

    pub fn parameters(self) -> Result<(), Failure> {
        let all: Vec<&'static Parameter> = Parameter::all().collect();
        let key = widest(all.iter().map(|parameter| parameter.key));
        let default = widest(all.iter().map(|parameter| parameter.default_text()));
        let line = |parameter: &&'static Parameter| {
            let (name, letter) = (parameter.key, parameter.letter);
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

    /// Prints a line or an object for each of `all`.
    fn print<T>(
        &self,
        name: &str,
        all: &[T],
        line: impl Fn(&T) -> String,
        object: impl Fn(&T) -> Value,
    ) -> Result<(), Failure> {
        match self.json {
            true => print_json(&in_language(Language::English, || {
                let objects: Vec<_> = all.iter().map(object).collect();
                format!("{:#}\n", json!({ name: objects }))
            })),
            false => print(&all.iter().map(line).collect::<String>()),
        }
    }
}

#[derive(Args)]
pub struct Code {
    #[command(flatten)]
    scene: SceneArguments,
    #[arg(long, value_enum, default_value_t = Target::CSnippet)]
    target: Target,
    #[arg(short, long, value_name = "FILE", value_parser = output_file())]
    output: Option<PathBuf>,
    #[arg(long, conflicts_with = "output")]
    json: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Target {
    C,
    CSnippet,
    Glsl,
}

impl Code {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let Loaded {
            scene, model, name, ..
        } = self.scene.load(earlier)?;
        if self.target != Target::Glsl {
            check_memory_for(&scene, model.as_deref(), 1).map_err(Failure::work)?;
        }
        let working = spinner(text!("cli-working"));
        let mesh = || {
            model
                .clone()
                .unwrap_or_else(|| Arc::new(tessellate(&scene.object)))
        };
        let export = match self.target {
            Target::C => opengl_c(&scene, &mesh())
                .map_err(|error| Failure::input(format!("{name}: {error}")))?,
            Target::CSnippet => opengl_c_snippet(&scene, &mesh()),
            Target::Glsl => glsl_330_of_model(&scene, model.as_deref()),
        };
        if self.json {
            drop(working);
            return print_json(&format!("{:#}\n", object(self.target, &export)));
        }
        let file = self.output.filter(|path| path != Path::new(STDOUT));
        match file {
            None => {
                let text = joined(&export);
                drop(working);
                print(&text)?;
            }
            Some(target) => save_code(&target, &export)?,
        }
        for limit in &export.limits {
            note(&limit.to_string());
        }
        Ok(())
    }
}

/// Returns the code as an object for programs: its parts, and the features that the target cannot express.
fn object(target: Target, export: &Export) -> Value {
    in_language(Language::English, || {
        let part = |part: &Part| json!({ "title": part.title.text(), "ending": part.ending, "text": part.text });
        let parts: Vec<_> = export.parts.iter().map(part).collect();
        let limits: Vec<_> = export.limits.iter().map(ToString::to_string).collect();
        let target = target.to_possible_value();
        let target = target.map(|value| value.get_name().to_owned());
        json!({ "target": target, "parts": parts, "limits": limits })
    })
}

/// Returns all parts one after the other, each of several under its title.
fn joined(export: &Export) -> String {
    let [part] = &export.parts[..] else {
        let titled = |part: &Part| {
            let title = in_language(Language::English, || part.title.text());
            format!("// ---- {title} (.{}) ----\n{}", part.ending, part.text)
        };
        return export.parts.iter().map(titled).collect();
    };
    part.text.clone()
}
