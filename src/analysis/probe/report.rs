//! The probe's question and report.

use super::digits::{digits, triple};
use super::filled::{FilledPart, law_text, law_words};
use super::letters::{attenuation_law, equation_letters, exponent, plain_formula};
use super::overlay::{VectorsShown, draw_vectors};
use super::products::{Here, LightHere, Product};
use super::{CueTerms, HitMaterial, Probe, ProbeHit, probe};
use crate::analysis::report::{
    Answer, Cell, Column, Figure, Part, Report, ReportContext, Section, Table, cells,
};
use crate::analysis::sampling::{REFERENCE_SAMPLES, SamplingError, sampling_error};
use crate::analysis::{Question, Subject, Watch};
use crate::figure::palette::Vector;
use crate::figure::{Paper, PlotStyle};
use crate::scene::{Choice, FaceMaterial, Material, Rgb};
use crate::text::{fixed, text};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::f64::consts::FRAC_PI_2;

/// Side of the figure of the vectors, in pixels.
const SIDE: u32 = 960;

/// The question for the equation at one pixel.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ProbeQuestion {
    /// The pixel inside the picture, with (0, 0) top left.
    pub pixel: [u32; 2],
}

/// The probe, with the error of each area light's points over the picture.
#[derive(Clone, Debug)]
pub struct Probed {
    /// The result of the probe.
    pub probe: Probe,
    /// Sampling error for each light; none unless it is an area light that shines.
    pub sampling: Vec<Option<SamplingError>>,
    /// The light whose vectors the figure shows; without one, the first that the point faces.
    pub light: Option<usize>,
}

impl Probed {
    /// Creates the answer without sampling errors; its figure shows the vectors of `light`.
    pub fn of(probe: Probe, light: usize) -> Self {
        let lights = probe.hit.as_ref().map_or(0, |hit| hit.lights.len());
        Self {
            probe,
            sampling: vec![None; lights],
            light: Some(light),
        }
    }
}

impl Question for ProbeQuestion {
    type Answer = Probed;

    fn answer(&self, subject: &Subject, _: &dyn Watch<Probed>) -> Result<Probed, String> {
        let (mut renderer, [x, y]) = (subject.renderer(), self.pixel);
        let probe = probe(&mut renderer, &subject.scene, x, y);
        let lights = probe.hit.as_ref().map_or(0, |hit| hit.lights.len());
        let sampling = (0..lights)
            .map(|light| sampling_error(&mut renderer, &subject.scene, light))
            .collect();
        Ok(Probed {
            probe,
            sampling,
            light: None,
        })
    }
}

/// Returns the names of the channels of a colour.
pub fn channels() -> [&'static str; 3] {
    [
        text!("point-red"),
        text!("point-green"),
        text!("point-blue"),
    ]
}

impl Answer for Probed {
    fn report(&self, about: &ReportContext<'_>) -> Report {
        let (scene, [x, y]) = (about.scene, self.probe.pixel);
        let Some(hit) = &self.probe.hit else {
            return Report::new(if self.probe.beside_is_floor(scene) {
                text!("point-report-background.floor", x = x, y = y)
            } else {
                text!("point-report-background", x = x, y = y)
            });
        };
        let depth = format_number(hit.depth);
        let mut report = Report::new(match hit.face {
            Some(face) => text!(
                "point-report-face",
                x = x,
                y = y,
                face = face.to_string(),
                depth = depth
            ),
            None => text!("point-report-surface", x = x, y = y, depth = depth),
        });
        let own = hit.scene_of(scene);
        let scene = &*own;
        if let Some(HitMaterial { name, numbers }) = &hit.material {
            report.section("").line(text!(
                "point-report-material",
                name = name,
                numbers = numbers_of(numbers)
            ));
        }
        let here = Here { scene, hit };
        vectors(report.section(""), &here.vectors());
        let letters: String = equation_letters(scene)
            .into_iter()
            .flatten()
            .map(|(formula, ..)| formula)
            .collect();
        let section = report.section("").line(plain_formula(&letters));
        if let Some(places) = here.places() {
            section.note(text!("point-report-places", places = places));
        }
        let mut flat = Section::default();
        for part in here.filled() {
            match part {
                FilledPart::Line(line) if !line.parts.is_empty() => {
                    let light = line.light.and_then(|index| here.lights().nth(index));
                    let title = light.map_or_else(
                        || format!("{}: {}", line.name, line.value.words()),
                        light_title,
                    );
                    let section = report.section(title);
                    light
                        .into_iter()
                        .for_each(|light| light_rows(section, light));
                    line.parts.into_iter().for_each(|part| say(section, part));
                    let sampling = line
                        .light
                        .and_then(|index| self.sampling.get(index).copied().flatten());
                    if let Some(SamplingError { rms, greatest }) = sampling {
                        let [rms, greatest] = [rms, greatest].map(format_number);
                        let note = text!(
                            "point-report-sampling",
                            rms = rms,
                            greatest = greatest,
                            samples = REFERENCE_SAMPLES.to_string()
                        );
                        section.note(format!("  {note}"));
                    }
                }
                part => say(&mut flat, part),
            }
        }
        report.sections.push(flat);
        report
            .section(text!("point-report-stored"))
            .push(Part::Table(stored(hit)));
        if let Some(fit) = self.probe.ambient_fit {
            let [r, g, b] = fit.to_array().map(format_number);
            report
                .section("")
                .note(text!("point-report-fit", r = r, g = g, b = b));
        }
        report
    }

    fn figure(
        &self,
        about: &ReportContext<'_>,
        size: Option<[u32; 2]>,
        paper: Paper,
    ) -> Option<Figure> {
        let (scene, hit) = (about.scene, self.probe.hit.as_ref()?);
        let own = hit.scene_of(scene);
        let here = Here { scene: &own, hit };
        let lit = || {
            here.lights()
                .position(|light| light.terms.theta < FRAC_PI_2)
        };
        let light = self.light.or_else(lit).unwrap_or(0);
        let size = size.unwrap_or([SIDE; 2]);
        let style = PlotStyle::of(size, 1, paper);
        let width = f64::from(size[0].min(size[1]));
        let drawing = draw_vectors(here, light, VectorsShown::Angles, width, &style)?;
        let [x, y] = self.probe.pixel;
        let title = text!(
            "point-report-surface",
            x = x,
            y = y,
            depth = format_number(hit.depth)
        );
        Some(Figure::Drawing { drawing, title })
    }

    fn value(&self, _: &ReportContext<'_>) -> Value {
        let Probe {
            pixel,
            hit,
            ambient_fit,
        } = &self.probe;
        let Some(hit) = hit else {
            return json!({ "pixel": pixel, "hit": false });
        };
        let mut object = json!(hit);
        object["pixel"] = json!(pixel);
        for (index, error) in self.sampling.iter().enumerate() {
            if let Some(SamplingError { rms, greatest }) = error {
                object["lights"][index]["sampling"] = json!({ "rms": rms, "greatest": greatest });
            }
        }
        if let Some(fit) = ambient_fit {
            object["ambient_fit"] = json!(fit);
        }
        if let Some(CueTerms { scale, kept, veil }) = &hit.cue {
            object["depth_cue"] =
                json!({ "intensity": hit.intensity, "s0": scale, "kept": kept, "veil": veil });
        }
        object
    }
}

/// Returns the heading of a light's section: its number, name, kind and attenuation.
fn light_title(light: LightHere<'_>) -> String {
    let source = light.source;
    let name = if source.name.is_empty() {
        String::new()
    } else {
        format!(" “{}”", source.name)
    };
    text!(
        "point-report-light",
        number = light.index + 1,
        name = name,
        kind = source.kind.label(),
        law = attenuation_law(source)
    )
}

/// Returns the numbers of a material in the equation, in a line.
fn numbers_of(own: &FaceMaterial) -> String {
    let FaceMaterial {
        material,
        kt,
        relative_ior,
    } = own;
    let Material {
        ka,
        kd,
        ks,
        n,
        color,
        specular_color,
        ..
    } = *material;
    let through = [("Kt", *kt), ("η", *relative_ior)]
        .map(|(letter, value)| format!("{letter} = {}", format_number(value)));
    let through = through.into_iter().filter(|_| *kt > 0.0);
    let mut numbers = vec![("Ka", ka), ("Kd", kd), ("Ks", ks)];
    let others = [("Od", color), ("Os", specular_color)];
    numbers.extend(others.into_iter().filter(|(_, color)| *color != Rgb::ONE));
    let numbers = numbers
        .iter()
        .map(|(letter, value)| format!("{letter} = {}", triple(*value)));
    let n = format!("n = {}", exponent(n));
    let numbers: Vec<String> = numbers.chain([n]).chain(through).collect();
    numbers.join(", ")
}

/// Adds the vectors and angles of a light that shines.
fn light_rows(section: &mut Section, light: LightHere<'_>) {
    if light.source.shines(light.here.scene.soloing()) {
        vectors(section, &light.vectors());
        for (name, value) in light.angles() {
            section.quantity(value, name);
        }
        for worked in light.construction() {
            let formula = plain_formula(worked.formula);
            section.line(format!("  {formula} = {}", worked.numbers.join(" = ")));
        }
    }
}

/// Adds a part of the filled-in equation.
fn say(section: &mut Section, part: FilledPart) {
    match part {
        FilledPart::Note(text) => _ = section.note(text),
        FilledPart::Evaluated(over) => _ = section.note(text!("point-evaluated", over = over)),
        FilledPart::Formula(formula) => _ = section.line(format!("  {}", plain_formula(&formula))),
        FilledPart::OfLaw(line) => {
            _ = section.line(format!("  {} = {}", law_text(&line), law_words(&line)));
        }
        FilledPart::Heading { name, share, .. } => {
            section.line(match share {
                Some(share) => text!("point-report-share", name = name, share = share),
                None => name.to_owned(),
            });
        }
        FilledPart::Product { product, .. } => {
            _ = section.push(Part::Table(product_table(&product)));
        }
        FilledPart::Line(line) => {
            let value = line.value.words();
            _ = section.line(format!("{:1} {}: {value}", line.sign, line.name));
        }
        FilledPart::Rule => {}
    }
}

fn product_table(product: &Product) -> Table {
    let mut columns = vec![Column::shown("", format_number)];
    for (index, column) in product.columns.iter().enumerate() {
        let sign = match (index, column.added) {
            (0, _) => "",
            (_, true) => "+ ",
            (_, false) => "· ",
        };
        let formula = plain_formula(&column.formula());
        let formula = if column.mean {
            text!("point-mean-of", formula = formula)
        } else {
            formula
        };
        columns.push(Column::shown(format!("{sign}{formula}"), format_number));
    }
    columns.push(Column::shown("=", format_number));
    let mut table = Table::new(columns);
    for (c, name) in channels().into_iter().enumerate() {
        let mut row = cells![name];
        row.extend(
            product
                .columns
                .iter()
                .map(|column| Cell::from(column.values[c])),
        );
        row.push(product.value[c].into());
        table.rows.push(row);
    }
    table
}

fn stored(hit: &ProbeHit) -> Table {
    let mut columns = vec![
        Column::both("channel", "", format_number),
        Column::key("ambient"),
        Column::both("sum", text!("point-sum"), format_number),
        Column::both("stored", text!("point-stored"), format_number),
    ];
    for index in 0..hit.lights.len() {
        columns.extend(
            ["diffuse", "specular"].map(|term| Column::key(format!("light{index}_{term}"))),
        );
    }
    let mut table = Table::new(columns);
    for (c, name) in channels().into_iter().enumerate() {
        let mut row = cells![name, hit.ambient[c], hit.sum[c], u32::from(hit.stored[c])];
        row.extend(
            hit.lights
                .iter()
                .flat_map(|light| [light.diffuse[c], light.specular[c]].map(Cell::from)),
        );
        table.rows.push(row);
    }
    table
}

fn vectors(section: &mut Section, rows: &[(Option<Vector>, &str, DVec3)]) {
    let mut table = Table::new(["", "x", "y", "z"].map(|head| Column::shown(head, format_number)));
    for (vector, what, v) in rows {
        let letter = vector.map_or("P", Vector::letter);
        table
            .rows
            .push(cells![format!("{letter}  {what}"), v.x, v.y, v.z]);
    }
    section.push(Part::Table(table));
}

/// Formats a number with four decimals, or in scientific form where those say too little.
fn format_number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || (1e-3..1e5).contains(&size) || !size.is_finite() {
        fixed(value, 4)
    } else {
        digits(value)
    }
}
