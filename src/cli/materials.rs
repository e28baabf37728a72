//! `materials`: the named materials.

use super::failure::Failure;
use super::output::{print, print_json};
use clap::Args;
use serde_json::json;
use shading_lab::scene::Rgb;
use shading_lab::scene::materials::{NAMED, NamedMaterial};

#[derive(Args)]
pub struct Materials {
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

impl Materials {
    pub fn run(self) -> Result<(), Failure> {
        if self.json {
            return print_json(&json!({"materials": NAMED.iter().map(object).collect::<Vec<_>>()}));
        }
        let wide = |text: fn(&NamedMaterial) -> &'static str| NAMED.iter().map(|named| text(named).len()).max();
        let (name, title) = (wide(|named| named.name).unwrap_or(0), wide(|named| named.title).unwrap_or(0));
        let line = |named: &NamedMaterial| {
            let NamedMaterial { ka, kd, ks, n, .. } = *named;
            let numbers = format!("ka {}  kd {}  ks {}  n {n}", triple(ka), triple(kd), triple(ks));
            format!("{:name$}  {:title$}  {numbers}\n", named.name, named.title)
        };
        print(&NAMED.iter().map(line).collect::<String>())
    }
}

fn object(named: &NamedMaterial) -> serde_json::Value {
    let NamedMaterial { name, title, ka, kd, ks, n } = *named;
    json!({"name": name, "title": title, "ka": ka.to_array(), "kd": kd.to_array(), "ks": ks.to_array(), "n": n})
}

/// Three numbers as a scene file writes them, in columns.
fn triple(value: Rgb) -> String {
    let [r, g, b] = value.to_array().map(|channel| channel.to_string());
    format!("{:30}", format!("[{r}, {g}, {b}]"))
}
