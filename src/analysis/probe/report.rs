//! What the probe says, and how it is asked.

use super::terms::{Factor, Here, LightHere, Product};
use super::{CueTerms, LightTerms, Probe, ProbeHit, probe};
use crate::analysis::report::{About, Answer, Cell, Column, Report, Section, Table};
use crate::analysis::{
    Part, Question, REFERENCE_SAMPLES, SamplingError, Subject, Watch, cells, sampling_error_with, word,
};
use crate::scene::{
    Attenuation, CuedBy, Encoding, LightKind, Overflow, Reflectance, ReflectionModel, Rgb, Scene, ShadingMode,
};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// The equation at one pixel.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ProbeQuestion {
    /// (0, 0) top left; inside the picture.
    pub pixel: [u32; 2],
}

/// The probe, with the error of each area light's points over the picture.
#[derive(Clone, Debug)]
pub struct Probed {
    pub probe: Probe,
    /// One for each light; none where it is no area light that shines.
    pub sampling: Vec<Option<SamplingError>>,
}

impl Question for ProbeQuestion {
    type Answer = Probed;

    fn answer(&self, subject: &Subject, _: &dyn Watch<Probed>) -> Result<Probed, String> {
        let (mut renderer, [x, y]) = (subject.renderer(), self.pixel);
        let probe = probe(&mut renderer, &subject.scene, x, y);
        let lights = if probe.hit.is_some() { subject.scene.lights.len() } else { 0 };
        let sampling = (0..lights).map(|light| sampling_error_with(&mut renderer, &subject.scene, light)).collect();
        Ok(Probed { probe, sampling })
    }
}

const CHANNELS: [&str; 3] = ["red", "green", "blue"];

impl Answer for Probed {
    fn report(&self, about: &About<'_>) -> Report {
        let (scene, [x, y]) = (about.scene, self.probe.pixel);
        let Some(hit) = &self.probe.hit else { return Report::new(format!("pixel ({x}, {y}) shows the background")) };
        let face = hit.face.map(|face| format!(", face {face}")).unwrap_or_default();
        let mut report = Report::new(format!("pixel ({x}, {y}){face}, depth {}", number(hit.depth)));
        let here = Here { scene, hit };
        vectors(
            report.section(""),
            &[("P  position", hit.position), ("N  normal", hit.normal), ("V  to the viewer", hit.view)],
        );
        formula(report.section(""), scene);
        let ambient =
            report.section(if hit.bounced { "ambient, from other surfaces, scattered once" } else { "ambient" });
        if hit.bounced {
            ambient.push(Part::Table(sums(&[("sum", hit.ambient)])));
        } else {
            product(ambient, &here.ambient());
        }
        for (index, light) in here.lights().enumerate() {
            light_section(&mut report, index, light, self.sampling.get(index).copied().flatten());
        }
        transmission(&mut report, here);
        fading(&mut report, here);
        stored(&mut report, hit, scene);
        if let Some(fit) = self.probe.ambient_fit {
            let [r, g, b] = fit.to_array().map(number);
            report
                .section("")
                .note(format!("the constant Ia that stands best for the bounce in this picture: {r} {g} {b}"));
        }
        report
    }

    fn json(&self, _: &About<'_>) -> Value {
        let Probe { pixel, hit, ambient_fit } = &self.probe;
        let Some(hit) = hit else { return json!({ "pixel": pixel, "hit": false }) };
        let ProbeHit { position, normal, view, depth, face, ambient, bounced, reflected, sum, divisor, stored, .. } =
            hit;
        let lights: Vec<Value> =
            hit.lights.iter().zip(&self.sampling).map(|(terms, error)| light_json(terms, *error)).collect();
        let mut object = json!({
            "pixel": pixel, "position": position, "normal": normal, "view": view, "depth": depth, "face": face,
            "ambient": ambient, "bounced": bounced, "lights": lights, "reflected": reflected, "sum": sum,
            "divisor": divisor, "stored": stored,
        });
        if let Some(fit) = ambient_fit {
            object["ambient_fit"] = json!(fit);
        }
        if let Some(through) = &hit.transmission {
            object["transmission"] = json!({
                "t": through.t, "refractions": through.refractions, "total_reflections": through.total_reflections,
                "seen": through.seen,
            });
        }
        if let Some(CueTerms { scale, kept, veil }) = &hit.cue {
            object["depth_cue"] = json!({ "intensity": hit.intensity, "s0": scale, "kept": kept, "veil": veil });
        }
        object
    }
}

/// Angles in degrees.
fn light_json(terms: &LightTerms, sampling: Option<SamplingError>) -> Value {
    let mut object = json!({
        "kind": terms.kind, "l": terms.l, "r": terms.r, "h": terms.h, "n_dot_l": terms.n_dot_l,
        "theta": terms.theta.to_degrees(), "phi": terms.phi.to_degrees(), "attenuation": terms.attenuation,
        "spot": terms.spot, "w": terms.reflectance, "incidence": terms.incidence.to_degrees(), "reached": terms.reached,
        "diffuse": terms.diffuse, "specular": terms.specular,
        "diffuse_zero": terms.diffuse_zero, "specular_zero": terms.specular_zero,
    });
    if let Some(SamplingError { rms, greatest }) = sampling {
        object["sampling"] = json!({ "rms": rms, "greatest": greatest });
    }
    object
}

/// The equation in letters, with the factors that this scene has, and where it is evaluated.
fn formula(section: &mut Section, scene: &Scene) {
    let lobe = match scene.reflection.model {
        ReflectionModel::Phong => "(R·V)^n",
        ReflectionModel::Blinn => "(N·H)^n",
        ReflectionModel::CookTorrance => "π·D·G/(4·(N·V))",
    };
    let w = if scene.material.reflectance == Reflectance::Constant { "" } else { "W·" };
    section.line(format!("I = Ka·Od·Ia + Σ f·Ip·(Kd·Od·(N·L) + Ks·Os·{w}S), S = {lobe}"));
    if scene.transparency.kt > 0.0 {
        section.line("I = (1 − Kt)·Irefl + Kt·Itrans, Irefl as above");
    }
    if scene.depth_cueing.by != CuedBy::Off {
        section.line("shown is s0·I + (1 − s0)·Idc");
    }
    match scene.shading.mode {
        ShadingMode::Flat => section.note("evaluated once for the polygon; the vectors are those at the pixel"),
        ShadingMode::Interpolated | ShadingMode::Gouraud => {
            section.note("evaluated at the polygon's vertices and interpolated; the vectors are those at the pixel")
        }
        ShadingMode::Phong | ShadingMode::Exact => section,
    };
}

fn light_section(report: &mut Report, index: usize, light: LightHere<'_>, sampling: Option<SamplingError>) {
    let (source, terms, scene) = (light.source, light.terms, light.here.scene);
    let f = match source.attenuation {
        Attenuation::None => "1",
        Attenuation::Viewer => "1/(r + k), r to the viewer",
        Attenuation::Light => "1/(r + k), r to the light",
        Attenuation::InverseSquare => "1/d²",
        Attenuation::Quadratic => "min(1, 1/(c1 + c2·d + c3·d²))",
    };
    let name = if source.name.is_empty() { String::new() } else { format!(" “{}”", source.name) };
    let section = report.section(format!("light {index}{name}, {}, f = {f}", word(&terms.kind)));
    if source.shines(scene.soloing()) {
        vectors(section, &[("L  to the light", terms.l), ("R  L mirrored", terms.r), ("H  half-way", terms.h)]);
        angles(section, scene, terms);
    }
    if let Some(why) = terms.why_nothing() {
        section.line(format!("  adds nothing: {why}"));
        return;
    }
    if source.kind == LightKind::Area {
        section.note(format!("  summed over {} samples", source.samples));
    }
    let both =
        [("diffuse", light.diffuse(), terms.why_no_diffuse()), ("specular", light.specular(), terms.why_no_specular())];
    for (term, sum, why) in both {
        match why {
            Some(why) => _ = section.line(format!("{term} adds nothing: {why}")),
            None => product(section.line(term), &sum),
        }
    }
    if let Some(SamplingError { rms, greatest }) = sampling {
        let [rms, greatest] = [rms, greatest].map(number);
        section.note(format!("  over the picture {rms} (rms), {greatest} (greatest) from {REFERENCE_SAMPLES} samples"));
    }
}

fn angles(section: &mut Section, scene: &Scene, light: &LightTerms) {
    let model = scene.reflection.model;
    let between = if model == ReflectionModel::Phong { "φ, R and V" } else { "φ, N and H" };
    let degrees = |angle: f64| format!("{:.2}°", angle.to_degrees());
    section.quantity(degrees(light.theta), "θ, N and L").quantity(degrees(light.phi), between);
    section.quantity(number(light.n_dot_l), "N·L");
    match model {
        ReflectionModel::CookTorrance => section.quantity(number(scene.material.roughness), "m"),
        ReflectionModel::Phong | ReflectionModel::Blinn => section.quantity(number(scene.material.n), "n"),
    };
    if scene.material.reflectance != Reflectance::Constant {
        let [r, g, b] = light.reflectance.to_array().map(number);
        section.quantity(degrees(light.incidence), format!("angle of W = {r} {g} {b}"));
    }
    if light.kind == LightKind::Spot {
        section.quantity(number(light.spot), "of the spot light sent this way");
    }
    if light.reached < 1.0 {
        section.quantity(number(light.reached), "not in shadow");
    }
}

fn transmission(report: &mut Report, here: Here<'_>) {
    let (Some(through), Some(mixture)) = (&here.hit.transmission, here.mixture()) else { return };
    let section = report.section(format!("transmission, η = {}", number(here.scene.transparency.ior)));
    match through.t {
        Some(t) => vectors(section, &[("T  transmitted", t)]),
        None => _ = section.line("  totally reflected: there is no T"),
    }
    section.line(format!("  {}", through_words(through.refractions, through.total_reflections)));
    product(section, &mixture);
}

/// How often a transmitted ray is bent and mirrored.
pub fn through_words(refractions: u32, total_reflections: u32) -> String {
    let counted = |count: u32, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let refracted = counted(refractions, "refraction");
    match total_reflections {
        0 => refracted,
        totals => format!("{refracted}, {}", counted(totals, "total reflection")),
    }
}

fn fading(report: &mut Report, here: Here<'_>) {
    let (Some(cue), Some(fading)) = (here.hit.cue, here.fading()) else { return };
    let cueing = &here.scene.depth_cueing;
    let found = match (cueing.by, here.scene.shading.mode) {
        (CuedBy::Vertex, ShadingMode::Phong) => "interpolated between the vertices",
        (CuedBy::Vertex, _) if !here.at_pixel() => "the mean of those where the equation is evaluated",
        _ => "by the pixel's depth",
    };
    let [front, back, s0] = [cueing.front, cueing.back, cue.scale].map(number);
    product(report.section(format!("depth cueing from depth {front} to {back}, s0 = {s0}, {found}")), &fading);
}

fn stored(report: &mut Report, hit: &ProbeHit, scene: &Scene) {
    let overflow = match scene.display.overflow {
        Overflow::Clamp => "clamped to 1",
        Overflow::Scale => &format!("divided by the picture's greatest, {}", number(hit.divisor)),
        Overflow::Mark => "marked above 1",
    };
    let encoding = match scene.display.encoding {
        Encoding::Raw => "times 255",
        Encoding::Srgb => "encoded as sRGB",
    };
    let section = report.section(format!("sum, and stored: {overflow}, {encoding}, rounded"));
    let mut columns = vec![Column::both("channel", "", number)];
    columns.extend([
        Column::key("ambient"),
        Column::both("sum", "sum", number),
        Column::both("stored", "stored", number),
    ]);
    for index in 0..hit.lights.len() {
        columns.extend(["diffuse", "specular"].map(|term| Column::key(format!("light{index}_{term}"))));
    }
    let mut table = Table::new(columns);
    for (c, name) in CHANNELS.into_iter().enumerate() {
        let mut row = cells![name, hit.ambient[c], hit.sum[c], u32::from(hit.stored[c])];
        row.extend(hit.lights.iter().flat_map(|light| [light.diffuse[c], light.specular[c]].map(Cell::from)));
        table.rows.push(row);
    }
    section.push(Part::Table(table));
}

/// A term's factors for each channel, and what they make.
fn product(section: &mut Section, product: &Product) {
    let mut columns = vec![Column::shown("", number)];
    columns.extend(product.columns.iter().enumerate().map(|(index, column)| {
        let sign = if index == 0 {
            ""
        } else if column.added {
            "+ "
        } else {
            "· "
        };
        let factors: Vec<&str> = column.factors.iter().map(|factor| letters(*factor)).collect();
        let mean = if column.mean { "mean of " } else { "" };
        Column::shown(format!("{sign}{mean}{}", factors.join("·")), number)
    }));
    columns.push(Column::shown("=", number));
    let mut table = Table::new(columns);
    for (c, name) in CHANNELS.into_iter().enumerate() {
        let factors = product.columns.iter().map(|column| Cell::from(column.values[c]));
        table.rows.push(std::iter::once(name.into()).chain(factors).chain([product.value[c].into()]).collect());
    }
    section.push(Part::Table(table));
}

fn sums(terms: &[(&'static str, Rgb)]) -> Table {
    let heads = terms.iter().map(|(name, _)| Column::shown(*name, number));
    let mut table = Table::new(std::iter::once(Column::shown("", number)).chain(heads));
    for (c, name) in CHANNELS.into_iter().enumerate() {
        table.rows.push(std::iter::once(name.into()).chain(terms.iter().map(|(_, sum)| sum[c].into())).collect());
    }
    table
}

fn letters(factor: Factor) -> &'static str {
    match factor {
        Factor::Ka => "Ka",
        Factor::Od => "Od",
        Factor::Ia => "Ia",
        Factor::Ip => "Ip",
        Factor::Kd => "Kd",
        Factor::Ks => "Ks",
        Factor::Os => "Os",
        Factor::Reflectance => "W",
        Factor::Attenuation => "f",
        Factor::Spot => "spot",
        Factor::Lit => "lit",
        Factor::Facing => "N·L",
        Factor::Lobe => "S",
        Factor::Opaque => "(1 − Kt)",
        Factor::Irefl => "Irefl",
        Factor::Kt => "Kt",
        Factor::Itrans => "Itrans",
        Factor::Kept => "s0",
        Factor::Intensity => "I",
        Factor::Gone => "(1 − s0)",
        Factor::Idc => "Idc",
    }
}

fn vectors(section: &mut Section, rows: &[(&str, DVec3)]) {
    let mut table = Table::new(["", "x", "y", "z"].map(|head| Column::shown(head, number)));
    table.rows = rows.iter().map(|(name, vector)| cells![*name, vector.x, vector.y, vector.z]).collect();
    section.push(Part::Table(table));
}

/// Four decimals, or the scientific form where those say too little.
fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || (1e-3..1e5).contains(&size) || !size.is_finite() {
        format!("{value:.4}")
    } else {
        format!("{value:.2e}")
    }
}
