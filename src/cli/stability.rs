//! `stability`: stiff and extreme cases in the textbook's way, the engine's and a reference's.

use super::analyse::{OutputArguments, ask, deliver};
use super::failure::Failure;
use clap::Args;
use shading_lab::analysis::{About, StabilityQuestion, Subject, stability_cases};
use shading_lab::jobs::nanoseconds;
use shading_lab::scene::Scene;

#[derive(Args)]
pub struct Stability {
    /// Only these cases, by name, between commas; all unless given
    #[arg(long = "case", value_name = "NAME", value_delimiter = ',', value_parser = parse_case)]
    cases: Vec<String>,
    #[command(flatten)]
    output: OutputArguments,
}

fn parse_case(text: &str) -> Result<String, String> {
    let names: Vec<_> = stability_cases().map(|case| case.name).collect();
    let known = names.iter().find(|name| **name == text.trim());
    known.map(|name| (*name).to_owned()).ok_or_else(|| format!("expected one of {}", names.join(", ")))
}

impl Stability {
    pub fn run(self) -> Result<(), Failure> {
        self.output.check("stability")?;
        let subject = Subject { scene: Scene::default(), model: None, clock: nanoseconds };
        let answer = ask(&StabilityQuestion { cases: self.cases }, &subject, None)?;
        deliver(&answer, &About { name: "stability", scene: &subject.scene }, &self.output, false)
    }
}
