//! `normals`: the faces that a vertex normal comes from, and their weights.

use super::failure::Failure;
use super::input::{SceneArguments, inside_picture, parse_pixel, parse_size};
use super::output::{print, print_json};
use super::overlay::{parse_vertex, vertex_of};
use super::sheet::write_text;
use clap::Args;
use glam::{DVec2, DVec3};
use serde_json::json;
use shading_lab::analysis::{NormalField, VertexNormal};
use shading_lab::geometry::NormalOrigin;
use shading_lab::render::Renderer;
use shading_lab::scene::{NormalSource, Scene, View, Weighting};
use shading_lab::table::Table;
use std::fmt::Write;
use std::path::PathBuf;

#[derive(Args)]
pub struct NormalsCommand {
    #[command(flatten)]
    scene: SceneArguments,
    /// The vertex, by its number from 0
    #[arg(long, value_name = "I", value_parser = parse_vertex, conflicts_with = "pixel", allow_hyphen_values = true)]
    vertex: Option<u32>,
    /// The seen vertex next to this pixel; with neither it is the one next to the picture's middle
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: Option<[u32; 2]>,
    /// Width and height in pixels, instead of the scene's
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// The faces, a row each
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

impl NormalsCommand {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let mut loaded = self.scene.load(earlier)?;
        let scene = &mut loaded.scene;
        scene.image.size = self.size.unwrap_or(scene.image.size);
        if let Some(pixel) = self.pixel {
            inside_picture("--pixel", pixel, scene.image.size)?;
        }
        let mut renderer = Renderer::default();
        renderer.set_model(loaded.model);
        renderer.render(scene);
        let field = NormalField::new(&renderer, &scene.object);
        let number = match self.vertex {
            Some(number) => number,
            None => seen_vertex(&field, &renderer, scene, self.pixel)?,
        };
        let vertex = vertex_of(&field, number)?;
        if let Some(path) = &self.csv {
            write_text(path, &csv(&vertex))?;
        }
        if self.json {
            return print_json(&json!({
                "scene": loaded.name,
                "normals": scene.object.normals,
                "weighting": scene.object.weighting,
                "weight_unit": unit(&field, &vertex),
                "vertices": field.vertex_count(),
                "faces": field.face_count(),
                "vertex": vertex,
            }));
        }
        if self.csv.is_some() { Ok(()) } else { print(&text(&loaded.name, &field, &vertex)) }
    }
}

/// The vertex next to a pixel's centre, or to the picture's middle.
fn seen_vertex(
    field: &NormalField,
    renderer: &Renderer,
    scene: &Scene,
    pixel: Option<[u32; 2]>,
) -> Result<u32, Failure> {
    let size = scene.image.size;
    let middle = DVec2::from_array(size.map(f64::from)) * 0.5;
    let place = pixel.map_or(middle, |pixel| DVec2::from_array(pixel.map(f64::from)) + 0.5);
    let seen = field.facing(&View::new(&scene.camera, size), size);
    let nearest = field.vertex_near(renderer, &seen, place, f64::INFINITY);
    nearest.map(|vertex| vertex.index).ok_or_else(|| {
        Failure::input("no vertex is seen in the picture, expected --vertex or a camera that sees the object")
    })
}

/// The unit of the weights; none where faces are counted or nothing is averaged.
fn unit(field: &NormalField, vertex: &VertexNormal) -> Option<&'static str> {
    match (vertex.origin, field.weighting()) {
        (NormalOrigin::Averaged | NormalOrigin::FirstFace, Weighting::Area) => Some("square units"),
        (NormalOrigin::Averaged | NormalOrigin::FirstFace, Weighting::Angle) => Some("degrees"),
        _ => None,
    }
}

fn csv(vertex: &VertexNormal) -> String {
    let mut table = Table::new("face,share,weight,angle,nx,ny,nz");
    for face in &vertex.faces {
        let DVec3 { x, y, z } = face.normal;
        table.row(&[&face.face, &face.share, &face.weight, &face.angle, &x, &y, &z]);
    }
    table.into_csv()
}

fn text(name: &str, field: &NormalField, vertex: &VertexNormal) -> String {
    let (number, count) = (vertex.vertex, field.vertex_count());
    let mut text = format!("{name}: vertex {number} of {count}, at {}\n", triple(vertex.position));
    let _ = writeln!(text, "N = {}: {}", triple(vertex.normal), origin(field, vertex));
    if vertex.length > 0.0 {
        let _ = writeln!(text, "Σ share·N = {}, of length {:.4}", triple(vertex.sum), vertex.length);
    }
    let unit = unit(field, vertex);
    let heading = match unit {
        Some("degrees") => "angle, °",
        Some(_) => "area",
        None => "weight",
    };
    let _ = writeln!(text, "\n{:>9}  {:>7}  {heading:>10}  {:>8}  normal", "face", "share", "off N, °");
    for face in &vertex.faces {
        let (share, weight) = if vertex.length > 0.0 || face.share > 0.0 {
            (format!("{:.4}", face.share), format!("{:.5}", face.weight))
        } else {
            ("-".to_owned(), "-".to_owned())
        };
        let normal = triple(face.normal);
        let _ = writeln!(text, "{:>9}  {share:>7}  {weight:>10}  {:>8.3}  {normal}", face.face, face.angle);
    }
    text
}

/// Where the normal comes from, in words.
fn origin(field: &NormalField, vertex: &VertexNormal) -> String {
    let images = if vertex.mirrored { " and their mirror images in x" } else { "" };
    let count = vertex.faces.len();
    let faces = if count == 1 { "1 face".to_owned() } else { format!("{count} faces") };
    match vertex.origin {
        NormalOrigin::Averaged => {
            let weights = match field.weighting() {
                Weighting::Equal => "weighted equally",
                Weighting::Area => "weighted by area",
                Weighting::Angle => "weighted by angle",
            };
            format!("the mean of {faces}{images}, {weights}")
        }
        NormalOrigin::Given if field.source() == NormalSource::File => "the file's own".to_owned(),
        NormalOrigin::Given => "the true surface's".to_owned(),
        NormalOrigin::Facet => "the face's own".to_owned(),
        NormalOrigin::FirstFace => format!("that of the first of {faces} whose normals cancel"),
        NormalOrigin::Nowhere => "no face here has an area".to_owned(),
    }
}

fn triple(v: DVec3) -> String {
    // Adding zero turns −0 into 0.
    let [x, y, z] = v.to_array().map(|c| (c * 1e4).round() / 1e4 + 0.0);
    format!("({x:.4}, {y:.4}, {z:.4})")
}
