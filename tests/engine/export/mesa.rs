//! Exported programs, compiled and run with Mesa, and their pictures beside ours.

use super::{program, scene};
use crate::model_materials;
use glam::{DVec2, DVec3};
use shading_lab::export::{export_mesh, glsl_330_of_model, opengl_c};
use shading_lab::geometry::{Corner, Mesh, VertexMesh, tessellate};
use shading_lab::render::{Frame, Renderer};
use shading_lab::scene::{Encoding, Scene, ShadingMode, View};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Arc, OnceLock};

/// Returns the folder where the programs are built.
pub fn folder() -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("export");
    fs::create_dir_all(&path).expect("a folder");
    path
}

/// Compiles `source`, a file of `folder()` or of the tests, with all warnings.
pub fn compile(source: &Path, program: &Path) -> std::io::Result<Output> {
    let warnings = ["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror"];
    Command::new("cc")
        .args(warnings)
        .arg(source)
        .arg("-o")
        .arg(program)
        .args(["-lEGL", "-lGL"])
        .output()
}

fn run(program: &Path) -> Command {
    let mut command = Command::new(program);
    command.env("LIBGL_ALWAYS_SOFTWARE", "1");
    command
}

/// Returns whether pictures can be drawn on this machine; prints a message if not.
pub fn mesa() -> bool {
    static FOUND: OnceLock<bool> = OnceLock::new();
    let found = *FOUND.get_or_init(|| {
        let (source, program) = (
            Path::new("tests/engine/export/probe.c"),
            folder().join("probe"),
        );
        compile(source, &program).is_ok_and(|output| output.status.success())
            && run(&program).status().is_ok_and(|status| status.success())
    });
    if !found {
        eprintln!("skipped: needs cc and Mesa (Debian: gcc libegl-dev libgl-dev libgl1-mesa-dri)");
    }
    found
}

#[track_caller]
pub fn succeeded(output: std::io::Result<Output>, what: &str) {
    let output = output.expect("a program that was found before");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.is_empty(), "{what}: {said}");
}

/// Returns the program that draws by a pair of shaders.
fn host() -> &'static Path {
    static BUILT: OnceLock<PathBuf> = OnceLock::new();
    BUILT.get_or_init(|| {
        let host = folder().join("host");
        let source = Path::new("tests/engine/export/host.c");
        succeeded(compile(source, &host), "host");
        host
    })
}

/// Reads the pixels of a binary PPM picture of `frame`'s size.
fn read_ppm(path: &Path, frame: &Frame) -> Vec<[u8; 3]> {
    let bytes = fs::read(path).expect("a picture");
    let head = format!("P6\n{} {}\n255\n", frame.width, frame.height);
    let pixels = bytes
        .strip_prefix(head.as_bytes())
        .expect("a picture of the size asked for");
    pixels.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect()
}

/// A background that is seldom a colour of the object.
const BACKGROUND: [u8; 3] = [32, 40, 48];

/// Returns a scene for a small picture on [`BACKGROUND`].
pub fn small(name: &str, overrides: &[&str]) -> Scene {
    let mut scene = scene(name, overrides);
    scene.image.size = [144, 128];
    // The linear values that the display encodes as these code values.
    let linear = |v: f64| match scene.display.encoding {
        Encoding::Raw => v,
        Encoding::Srgb => ((v + 0.055) / 1.055).powf(2.4),
    };
    scene.image.background =
        DVec3::from_array(BACKGROUND.map(|code| linear(f64::from(code) / 255.0)));
    scene
}

/// Returns a scene of a model for a small picture on [`BACKGROUND`].
pub fn small_model(set: &[&str]) -> Scene {
    let mut scene = small("sphere", &[]);
    let model = model_materials::scene(set);
    scene.image.size = [144, 128];
    Scene {
        image: scene.image,
        ..model
    }
}

/// The distance from an edge, pixels, within which either polygon may be drawn: both programs round corners to 1/256 pixel, so
/// that an edge of each lies at most √2/512 off.
const EDGE: f64 = 2.0 * std::f64::consts::SQRT_2 / 512.0;

/// The edges of a model's triangles in the picture of a scene.
pub struct Edges(Vec<[DVec2; 2]>);

impl Edges {
    pub fn of(scene: &Scene, mesh: &Mesh) -> Self {
        let view = View::new(&scene.camera, scene.image.size);
        let place = |corner: Corner| {
            let point = mesh.positions[corner.position as usize].as_dvec3();
            view.project(mesh.origin + point).expect("before the eye").0
        };
        let faces = (0..mesh.face_count()).flat_map(|face| mesh.face_triangles(face));
        let edges = |triangle: [Corner; 3]| {
            let [a, b, c] = triangle.map(place);
            [[a, b], [b, c], [c, a]]
        };
        Self(faces.flat_map(edges).collect())
    }

    /// Returns the distance of the nearest edge from the centre of a pixel.
    fn distance(&self, x: usize, y: usize) -> f64 {
        let centre = DVec2::new(x as f64, y as f64) + 0.5;
        let distance = |[a, b]: &[DVec2; 2]| {
            let (along, from) = (*b - *a, centre - *a);
            let share = from.dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
            (from - along * share.clamp(0.0, 1.0)).length()
        };
        self.0.iter().map(distance).fold(f64::INFINITY, f64::min)
    }

    /// Returns whether an edge touches the centre of a pixel.
    pub fn touch(&self, x: usize, y: usize) -> bool {
        self.distance(x, y) <= EDGE
    }
}

/// Checks that the pixels that either picture covers agree, and that there are enough of them: for a model all within 1 of 255
/// but for those whose centre an edge touches, else at least 99 % within 2.
#[track_caller]
fn agree(name: &str, scene: &Scene, model: Option<&Arc<Mesh>>, theirs: &Path) {
    let within = if model.is_some() { 1 } else { 2 };
    let edges = model.map(|mesh| Edges::of(scene, mesh));
    let mut renderer = Renderer::default().with_model(model.cloned());
    let frame = renderer.render(scene);
    let theirs = read_ppm(theirs, frame);
    let (mut covered, mut near, mut greatest) = (0, 0, 0);
    let width = frame.width as usize;
    for (pixel, (ours, theirs)) in frame.pixels.iter().zip(&theirs).enumerate() {
        let ours = [ours[0], ours[1], ours[2]];
        if ours == BACKGROUND && *theirs == BACKGROUND {
            continue;
        }
        let off = ours
            .iter()
            .zip(theirs)
            .map(|(&a, &b)| a.abs_diff(b))
            .max()
            .unwrap_or(0);
        covered += 1;
        near += usize::from(off <= within);
        if let Some(edges) = edges.as_ref().filter(|_| off > within) {
            let [x, y] = [pixel % width, pixel / width];
            let distance = edges.distance(x, y);
            assert!(
                distance <= EDGE,
                "{name}: {ours:?} and {theirs:?} at {x}, {y}, {distance:.4} pixels from an edge"
            );
        }
        greatest = greatest.max(off);
    }
    eprintln!("{name}: {near} of {covered} pixels within {within}, greatest difference {greatest}");
    assert!(covered > 2000, "{name}: {covered} pixels covered");
    assert!(
        near * 100 >= covered * 99,
        "{name}: {near} of {covered}, greatest difference {greatest}"
    );
}

/// Builds and runs the exported program of `scene` and compares its picture with ours.
#[track_caller]
pub fn compare_c(name: &str, scene: &Scene, model: Option<&Arc<Mesh>>) {
    let path = |ending: &str| folder().join(format!("c-{name}{ending}"));
    let (source, program_path, picture) = (path(".c"), path(""), path(".ppm"));
    let export = match model {
        Some(mesh) => opengl_c(scene, mesh).expect("a mesh of moderate size"),
        None => program(scene),
    };
    fs::write(&source, &export.parts[0].text).expect("a file");
    succeeded(compile(&source, &program_path), name);
    succeeded(run(&program_path).arg(&picture).output(), name);
    agree(name, scene, model, &picture);
}

/// Returns the fan of a face about its first vertex, triangles with the face's orientation first, and the number of these.
fn fan(mesh: &VertexMesh, f: usize) -> (Vec<[u32; 3]>, u32) {
    let at = |v: u32| mesh.positions[v as usize].as_dvec3();
    let face = mesh.face(f);
    let triangles = face[1..].windows(2).map(|pair| [face[0], pair[0], pair[1]]);
    let (mut along, against): (Vec<_>, Vec<_>) = triangles.partition(|&[a, b, c]| {
        (at(b) - at(a))
            .cross(at(c) - at(a))
            .dot(mesh.face_normal(f))
            > 0.0
    });
    let first = along.len() as u32;
    along.extend(against);
    (along, first)
}

/// Serializes a mesh for the host program. If each polygon has one shade, concave ones are separate fans.
fn bytes(mesh: &VertexMesh, flat: bool) -> Vec<u8> {
    let is_concave = |f: &usize| flat && mesh.cut.iter().any(|(face, _)| *face as usize == *f);
    let (concave, plain): (Vec<usize>, Vec<usize>) = (0..mesh.face_count()).partition(is_concave);
    let (mut plain, materials) = (plain, &mesh.face_materials);
    // The number of a material is its place among those that faces have, in their order.
    let mut order: Vec<u16> = vec![];
    for own in materials {
        if !order.contains(own) {
            order.push(*own);
        }
    }
    let place = |f: &usize| order.iter().position(|own| materials.get(*f) == Some(own));
    plain.sort_by_key(place);
    let run = |faces: &[usize]| {
        let triangles: usize = faces.iter().map(|f| mesh.face_triangles(*f).len()).sum();
        [place(&faces[0]).unwrap_or(0) as u32, triangles as u32]
    };
    let runs: Vec<[u32; 2]> = plain
        .chunk_by(|a, b| place(a) == place(b))
        .map(run)
        .collect();
    let triangles: Vec<[u32; 3]> = plain
        .into_iter()
        .flat_map(|f| mesh.face_triangles(f))
        .collect();
    let fans: Vec<_> = concave.into_iter().map(|f| fan(mesh, f)).collect();
    let mut bytes = Vec::new();
    for count in [
        mesh.positions.len(),
        triangles.len(),
        fans.len(),
        runs.len(),
    ] {
        bytes.extend(u32::try_from(count).expect("a small mesh").to_ne_bytes());
    }
    for (position, normal) in mesh.positions.iter().zip(&mesh.normals) {
        bytes.extend(
            position
                .to_array()
                .iter()
                .chain(&normal.to_array())
                .flat_map(|x| x.to_ne_bytes()),
        );
    }
    let counts = fans
        .iter()
        .flat_map(|(fan, along)| [fan.len() as u32, *along]);
    let numbers = triangles.iter().flatten().copied().chain(counts);
    let numbers = numbers.chain(
        fans.iter()
            .flat_map(|(fan, _)| fan.iter().flatten().copied()),
    );
    let numbers = numbers.chain(runs.iter().flatten().copied());
    bytes.extend(numbers.flat_map(u32::to_ne_bytes));
    bytes
}

/// Draws `scene` with its shaders; returns the picture's file.
fn draw(name: &str, scene: &Scene, model: Option<&Arc<Mesh>>) -> PathBuf {
    let path = |ending: &str| folder().join(format!("glsl-{name}.{ending}"));
    let mesh = match model {
        Some(mesh) => export_mesh(scene, mesh),
        None => export_mesh(scene, &tessellate(&scene.object)),
    };
    let flat = scene.shading.mode == ShadingMode::Flat;
    fs::write(path("mesh"), bytes(&mesh, flat)).expect("a file");
    let export = glsl_330_of_model(scene, model.map(|mesh| &**mesh));
    for part in &export.parts {
        fs::write(path(part.ending), &part.text).expect("a file");
    }
    let mut command = run(host());
    command.args([path("vert"), path("frag"), path("mesh")]);
    command.args(scene.image.size.map(|side| side.to_string()));
    command.args(BACKGROUND.map(|code| (f64::from(code) / 255.0).to_string()));
    succeeded(command.arg(path("ppm")).output(), name);
    path("ppm")
}

/// Draws `scene` with its shaders; returns the pixels of a picture of `frame`'s size.
pub fn draw_glsl(name: &str, scene: &Scene, frame: &Frame) -> Vec<[u8; 3]> {
    read_ppm(&draw(name, scene, None), frame)
}

/// Draws `scene` with its shaders and compares the picture with ours.
#[track_caller]
pub fn compare_glsl(name: &str, scene: &Scene, model: Option<&Arc<Mesh>>) {
    agree(name, scene, model, &draw(name, scene, model));
}
