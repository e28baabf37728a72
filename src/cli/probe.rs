//! `probe`: the equation at one pixel, filled in.

mod text;

use super::failure::Failure;
use super::input::{SceneArguments, inside_picture, parse_pixel};
use super::output::{print, print_json};
use clap::Args;
use glam::DVec3;
use serde::Serialize;
use shading_lab::analysis::{
    CueTerms, LightTerms, Probe, ProbeHit, SamplingError, ZeroCauses, probe, sampling_error_with,
};
use shading_lab::render::{Renderer, Transmission};
use shading_lab::scene::{LightKind, Rgb};

#[derive(Args)]
pub struct ProbeCommand {
    #[command(flatten)]
    scene: SceneArguments,
    /// The pixel, (0,0) top left
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: [u32; 2],
    /// Print one JSON object; angles in degrees, vectors in the world
    #[arg(long)]
    json: bool,
}

impl ProbeCommand {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let loaded = self.scene.load(earlier)?;
        let [x, y] = self.pixel;
        inside_picture(&format!("--pixel {x},{y}"), self.pixel, loaded.scene.image.size)?;
        let mut renderer = Renderer::default();
        renderer.set_model(loaded.model);
        let probe = probe(&mut renderer, &loaded.scene, x, y);
        let lights = if probe.hit.is_some() { loaded.scene.lights.len() } else { 0 };
        let sampling: Vec<Option<SamplingError>> =
            (0..lights).map(|light| sampling_error_with(&mut renderer, &loaded.scene, light)).collect();
        if !self.json {
            return print(&text::describe(&probe, &loaded.scene, &sampling));
        }
        let Probe { pixel, hit, ambient_fit } = probe;
        match hit {
            Some(hit) => print_json(&PrintedHit::new(pixel, hit, ambient_fit, sampling)),
            None => print_json(&PrintedBackground { pixel, hit: false }),
        }
    }
}

/// A pixel that shows the background, as printed.
#[derive(Serialize)]
struct PrintedBackground {
    pixel: [u32; 2],
    hit: bool,
}

/// A pixel that shows the object, as printed, its keys in the order of the equation.
#[derive(Serialize)]
struct PrintedHit {
    pixel: [u32; 2],
    position: DVec3,
    normal: DVec3,
    view: DVec3,
    depth: f64,
    face: Option<u32>,
    ambient: Rgb,
    /// Whether `ambient` is light from other surfaces.
    bounced: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    ambient_fit: Option<Rgb>,
    lights: Vec<PrintedLight>,
    reflected: Rgb,
    #[serde(skip_serializing_if = "Option::is_none")]
    transmission: Option<PrintedTransmission>,
    #[serde(skip_serializing_if = "Option::is_none")]
    depth_cue: Option<PrintedCue>,
    sum: Rgb,
    /// What the display divides the sum by.
    divisor: f64,
    /// The pixel of the scene's own picture, which panes beside it do not make smaller.
    stored: [u8; 3],
}

#[derive(Serialize)]
struct PrintedTransmission {
    /// Nothing where all light is reflected.
    t: Option<DVec3>,
    refractions: u32,
    total_reflections: u32,
    seen: Rgb,
}

/// Depth cueing: the sum is `kept + veil`.
#[derive(Serialize)]
struct PrintedCue {
    /// I before it fades.
    intensity: Rgb,
    s0: f64,
    /// s0·I.
    kept: Rgb,
    /// (1 − s0)·Idc.
    veil: Rgb,
}

impl From<Transmission> for PrintedTransmission {
    fn from(Transmission { t, refractions, total_reflections, seen }: Transmission) -> Self {
        Self { t, refractions, total_reflections, seen }
    }
}

#[derive(Serialize)]
struct PrintedLight {
    kind: LightKind,
    l: DVec3,
    r: DVec3,
    h: DVec3,
    n_dot_l: f64,
    /// Degrees, as phi.
    theta: f64,
    phi: f64,
    attenuation: f64,
    /// The part that a spot light sends this way.
    spot: f64,
    /// W per channel, and the angle of incidence it depends on, degrees.
    w: Rgb,
    incidence: f64,
    /// The part of the light that is not in shadow.
    reached: f64,
    diffuse: Rgb,
    specular: Rgb,
    /// Why the term is 0: no cause where it adds something, several where one holds here and another there.
    diffuse_zero: ZeroCauses,
    specular_zero: ZeroCauses,
    /// The error of an area light's samples over the picture.
    #[serde(skip_serializing_if = "Option::is_none")]
    sampling: Option<PrintedSampling>,
}

/// The difference to 4096 samples, in linear intensity.
#[derive(Serialize)]
struct PrintedSampling {
    rms: f64,
    greatest: f64,
}

impl From<SamplingError> for PrintedSampling {
    fn from(SamplingError { rms, greatest }: SamplingError) -> Self {
        Self { rms, greatest }
    }
}

impl PrintedHit {
    fn new(pixel: [u32; 2], hit: ProbeHit, ambient_fit: Option<Rgb>, sampling: Vec<Option<SamplingError>>) -> Self {
        let ProbeHit {
            position,
            normal,
            view,
            depth,
            face,
            ambient,
            bounced,
            lights,
            reflected,
            sum,
            divisor,
            stored,
            ..
        } = hit;
        let transmission = hit.transmission.map(PrintedTransmission::from);
        let cue = |CueTerms { scale: s0, kept, veil }| PrintedCue { intensity: hit.intensity, s0, kept, veil };
        let depth_cue = hit.cue.map(cue);
        let errors = sampling.into_iter().map(|error| error.map(PrintedSampling::from));
        let lights = lights.into_iter().zip(errors);
        let lights = lights.map(|(terms, sampling)| PrintedLight { sampling, ..PrintedLight::from(terms) }).collect();
        Self {
            pixel,
            position,
            normal,
            view,
            depth,
            face,
            ambient,
            bounced,
            ambient_fit,
            lights,
            reflected,
            transmission,
            depth_cue,
            sum,
            divisor,
            stored,
        }
    }
}

impl From<LightTerms> for PrintedLight {
    fn from(terms: LightTerms) -> Self {
        let LightTerms { kind, l, r, h, n_dot_l, theta, phi, attenuation, spot, reached, diffuse, specular, .. } =
            terms;
        let (theta, phi, incidence) = (theta.to_degrees(), phi.to_degrees(), terms.incidence.to_degrees());
        let (w, diffuse_zero, specular_zero) = (terms.reflectance, terms.diffuse_zero, terms.specular_zero);
        Self {
            kind,
            l,
            r,
            h,
            n_dot_l,
            theta,
            phi,
            attenuation,
            spot,
            w,
            incidence,
            reached,
            diffuse,
            specular,
            diffuse_zero,
            specular_zero,
            sampling: None,
        }
    }
}
