//! `shading-lab probe`: the equation at one pixel, as text or as JSON.

use super::output::{print, print_json};
use super::{Failure, SceneArguments};
use crate::analysis::{LightTerms, Probe, ProbeHit, probe};
use crate::render::Renderer;
use crate::scene::{ReflectionModel, Rgb, Scene};
use clap::Args;
use glam::DVec3;
use serde_json::{Value, json};
use std::fmt::Write;

#[derive(Debug, Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// The pixel, counted from the top left
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pixel: [u32; 2],
    /// Prints JSON
    #[arg(long)]
    json: bool,
}

/// A pixel as `X,Y`.
pub(super) fn parse_pixel(text: &str) -> Result<[u32; 2], String> {
    let parsed = text.split_once(',').and_then(|(x, y)| Some([x.trim().parse().ok()?, y.trim().parse().ok()?]));
    parsed.ok_or_else(|| "expected X,Y in whole pixels, for example 384,200".to_owned())
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let loaded = arguments.scene.load()?;
    let [x, y] = arguments.pixel;
    let [width, height] = loaded.scene.image.size;
    if x >= width || y >= height {
        return Err(Failure::input(&format!(
            "--pixel {x},{y}: outside the picture, expected less than {width},{height}"
        )));
    }
    let mut renderer = Renderer::default();
    renderer.set_model(loaded.model);
    let probe = probe(&mut renderer, &loaded.scene, x, y);
    if arguments.json { print_json(&as_json(&probe)) } else { print(&as_text(&probe, &loaded.scene)) }
}

fn vector(v: DVec3) -> Value {
    json!([v.x, v.y, v.z])
}

fn as_json(probe: &Probe) -> Value {
    let Some(hit) = &probe.hit else { return json!({ "pixel": probe.pixel, "hit": false }) };
    let lights: Vec<Value> = hit.lights.iter().map(light_as_json).collect();
    json!({
        "pixel": probe.pixel,
        "hit": true,
        "position": vector(hit.position),
        "normal": vector(hit.normal),
        "view": vector(hit.view),
        "depth": hit.depth,
        "face": hit.face,
        "ambient": vector(hit.ambient),
        "lights": lights,
        "sum": vector(hit.sum),
        "stored": hit.stored,
    })
}

fn light_as_json(light: &LightTerms) -> Value {
    json!({
        "kind": light.kind,
        "l": vector(light.l),
        "r": vector(light.r),
        "h": vector(light.h),
        "n_dot_l": light.n_dot_l,
        "theta": light.theta.to_degrees(),
        "phi": light.phi.to_degrees(),
        "attenuation": light.attenuation,
        "diffuse": vector(light.diffuse),
        "specular": vector(light.specular),
    })
}

fn as_text(probe: &Probe, scene: &Scene) -> String {
    let mut text = String::new();
    let [x, y] = probe.pixel;
    // Writing to a string cannot fail.
    let _ = match &probe.hit {
        None => writeln!(text, "pixel {x},{y}: the background"),
        Some(hit) => write_hit(&mut text, [x, y], hit, scene),
    };
    text
}

fn row(text: &mut String, name: &str, v: DVec3) -> std::fmt::Result {
    writeln!(text, "  {name:<24}{:>11.6}{:>11.6}{:>11.6}", v.x, v.y, v.z)
}

fn write_hit(text: &mut String, [x, y]: [u32; 2], hit: &ProbeHit, scene: &Scene) -> std::fmt::Result {
    let face = hit.face.map_or_else(|| "the true surface".to_owned(), |face| format!("face {face}"));
    writeln!(text, "pixel {x},{y}: {face}, depth {:.6}\n", hit.depth)?;
    writeln!(text, "  {:<24}{:>11}{:>11}{:>11}", "", "x", "y", "z")?;
    row(text, "position", hit.position)?;
    row(text, "N", hit.normal)?;
    row(text, "V", hit.view)?;
    let specular = match scene.reflection.model {
        ReflectionModel::Phong => "f·Ip·Ks·(R·V)^n",
        ReflectionModel::Blinn => "f·Ip·Ks·(N·H)^n",
    };
    for (index, light) in hit.lights.iter().enumerate() {
        writeln!(text, "\nlight {index}")?;
        row(text, "L", light.l)?;
        row(text, "R = 2N(N·L) − L", light.r)?;
        row(text, "H = (L + V)/|L + V|", light.h)?;
        let (theta, phi) = (light.theta.to_degrees(), light.phi.to_degrees());
        writeln!(text, "  N·L {:.6}   θ {theta:.3}°   φ {phi:.3}°   f {:.6}", light.n_dot_l, light.attenuation)?;
    }
    writeln!(text, "\n  {:<24}{:>11}{:>11}{:>11}", "I =", "red", "green", "blue")?;
    row(text, "Ka·Od·Ia", hit.ambient)?;
    for (index, light) in hit.lights.iter().enumerate() {
        row(text, &format!("+ f·Ip·Kd·Od·(N·L)   [{index}]"), light.diffuse)?;
        row(text, &format!("+ {specular}    [{index}]"), light.specular)?;
    }
    row(text, "= sum", hit.sum)?;
    let Rgb { x: r, y: g, z: b } = Rgb::from_array(hit.stored.map(f64::from));
    writeln!(text, "  {:<24}{r:>11}{g:>11}{b:>11}", "stored")
}
