//! `parameters`: every key of the scene file.

use super::failure::Failure;
use super::output::{print, print_json};
use clap::Args;
use serde_json::{Value, json};
use shading_lab::scene::Scene;
use shading_lab::scene::parameter::{Kind, Parameter};

#[derive(Args)]
pub struct Parameters {
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

impl Parameters {
    pub fn run(self) -> Result<(), Failure> {
        if self.json {
            return print_json(&json!({"parameters": Parameter::all().map(object).collect::<Vec<_>>()}));
        }
        let rows: Vec<[String; 4]> = Parameter::all()
            .map(|parameter| {
                [parameter.key.to_owned(), parameter.default_text(), parameter.range_text(), meaning(parameter)]
            })
            .collect();
        let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let (key, default) = (width(0), width(1));
        let line = |[name, value, range, meaning]: &[String; 4]| {
            format!("{name:key$}  {value:default$}  {range}\n    {meaning}\n")
        };
        print(&rows.iter().map(line).collect::<String>())
    }
}

/// Its letter, if it has one, and its help.
fn meaning(parameter: &Parameter) -> String {
    let Parameter { letter, help, .. } = parameter;
    if letter.is_empty() { (*help).to_owned() } else { format!("{letter}: {help}") }
}

fn object(parameter: &'static Parameter) -> Value {
    let Parameter { key, letter, name, unit, help, .. } = parameter;
    let limits = match (&parameter.kind, parameter.limits(&Scene::default())) {
        (Kind::Other(.., limits), _) => json!(limits),
        // Infinity becomes null: no limit.
        (_, Some(limits)) => json!([limits.least, limits.greatest]),
        _ => Value::Null,
    };
    let choices: Vec<_> = parameter.options().iter().map(|option| option.word).collect();
    json!({
        "key": key, "symbol": letter, "name": name, "unit": unit, "kind": parameter.kind_name(), "limits": limits,
        "default": parameter.default(), "choices": choices, "help": help,
    })
}
