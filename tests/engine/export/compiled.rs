//! Exported programs compile, run, and draw the same picture.

use super::{program, scene, snippet};
use crate::model_materials;
use glam::{DVec2, DVec3};
use shading_lab::export::{Limit, export_mesh, glsl_330_of_model, opengl_c};
use shading_lab::geometry::{Corner, Mesh, VertexMesh, tessellate};
use shading_lab::render::{Frame, Renderer};
use shading_lab::scene::{Encoding, ObjectKind, Scene, ShadingMode, View};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Arc, OnceLock};

/// Returns the folder where the programs are built.
fn folder() -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("export");
    fs::create_dir_all(&path).expect("a folder");
    path
}

/// Compiles `source`, a file of `folder()` or of the tests, with all warnings.
fn compile(source: &Path, program: &Path) -> std::io::Result<Output> {
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
fn succeeded(output: std::io::Result<Output>, what: &str) {
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
fn compare_c(name: &str, scene: &Scene, model: Option<&Arc<Mesh>>) {
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

/// Settings that fixed-function OpenGL can express.
const FIXED: [&str; 5] = [
    "shading.mode=gouraud",
    "reflection.model=blinn",
    "material.n=40",
    "object.segments=48",
    "object.rings=24",
];

#[test]
fn the_program_in_c_draws_the_same_picture() {
    if !mesa() {
        return;
    }
    let spot =
        "light=[{kind=\"spot\", position=[1,2,3], direction=[-1,-2,-3], cone=12, exponent=30}]";
    let rays = "light=[{kind=\"directional\", direction=[-2,-1,-2], color=[1,0.8,0.6]}, {kind=\"directional\", \
                direction=[3,1,-1], color=[0.1,0.2,0.5]}]";
    let quadratic = "light=[{attenuation=\"quadratic\", position=[1,1,2], c1=0.3, c2=0.2, c3=0.2, color=[2,2,2]}]";
    let area = "light=[{kind=\"area\", samples=6, shape=\"sphere\", radius=0.7, attenuation=\"light\", k=0.5}]";
    for (name, preset, set) in [
        (
            "spot",
            "sphere",
            &[spot, "object.segments=96", "object.rings=48"][..],
        ),
        ("directional", "torus", &[rays, "camera.viewer=infinite"]),
        ("quadratic", "sphere", &[quadratic]),
        // The back of a plane, lit from the eye's side.
        (
            "two-sided",
            "plane",
            &[
                "camera.eye=[0.6,0.9,-3.8]",
                "light.0.position=[0.4,0.7,-0.9]",
                "reflection.backfacing=flip",
            ],
        ),
        (
            "one-sided",
            "plane",
            &[
                "camera.eye=[0.6,0.9,-3.8]",
                "light.0.position=[0.4,0.7,-0.9]",
            ],
        ),
        (
            "local-viewer",
            "torus",
            &[
                "camera.viewer=local",
                "camera.fov_y=60",
                "camera.eye=[0,1,2]",
            ],
        ),
        (
            "orthographic",
            "cylinder",
            &["camera.projection=orthographic"],
        ),
        ("rolled", "torus", &["camera.roll=35"]),
        (
            "corrugated",
            "plane",
            &["object={kind=\"corrugated\", segments=6, rings=2}"],
        ),
        ("interpolated", "torus", &["shading.mode=interpolated"]),
        (
            "flat",
            "torus",
            &["shading={mode=\"flat\", flat_at=\"provoking-vertex\"}"],
        ),
        (
            "concave",
            "sphere",
            &[CONCAVE, "camera.eye=[1.5,2,3]", "shading.mode=interpolated"],
        ),
        (
            "concave-flat",
            "sphere",
            &[
                CONCAVE,
                "camera.eye=[1.5,2,3]",
                "light.0.position=[0.4,0.5,0.8]",
                "shading={mode=\"flat\", flat_at=\"provoking-vertex\"}",
            ],
        ),
        ("overflow", "sphere", &["light.0.color=[4,4,4]"]),
        ("area", "cube", &[area]),
        (
            "fog",
            "torus",
            &["depth_cueing={by=\"pixel\", front=3.4, back=4.3, color=[0.5,0.6,0.7]}"],
        ),
        (
            "thin-fog",
            "sphere",
            &[
                "depth_cueing={by=\"pixel\", front=2, back=7, front_scale=0.9, back_scale=0.2, color=[0.1,0.2,0.7]}",
                "camera.projection=orthographic",
            ],
        ),
    ] {
        let scene = small(preset, &[&FIXED[..], set].concat());
        let export = program(&scene);
        let stated = export
            .limits
            .iter()
            .all(|limit| name == "two-sided" && limit.to_string().contains("TWO_SIDE"));
        assert!(stated, "{name}: {:?}", export.limits);
        compare_c(name, &scene, None);
    }
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

#[test]
fn a_model_of_six_materials_is_drawn_by_the_program_in_c() {
    if !mesa() {
        return;
    }
    let scattered = model_materials::model(ObjectKind::Torus, 24, |face| (face % 7) as u16);
    for (name, mesh) in [("cube", &model_materials::cube()), ("torus", &scattered)] {
        for (mode, set) in [
            ("gouraud", &["shading.mode=gouraud"][..]),
            ("interpolated", &["shading.mode=interpolated"]),
            (
                "flat",
                &["shading={mode=\"flat\", flat_at=\"provoking-vertex\"}"],
            ),
            (
                "changed",
                &[
                    "shading.mode=gouraud",
                    "object.material=[{name=\"green\", n=60, kd=[0,0.9,0.9]}]",
                ],
            ),
            ("scene", &["shading.mode=gouraud", "material.source=scene"]),
        ] {
            let all = [
                "reflection.model=blinn",
                "object.material=[{name=\"green\", n=100}]",
            ];
            let scene = small_model(&[&all[..], set].concat());
            // The model has a material whose n is beyond OpenGL's 128 where the scene does not change it.
            compare_c(&format!("{name}-{mode}"), &scene, Some(mesh));
        }
    }
}

#[test]
fn a_model_of_six_materials_is_drawn_by_the_shaders() {
    if !mesa() {
        return;
    }
    let scattered = model_materials::model(ObjectKind::Torus, 24, |face| (face % 7) as u16);
    for (name, mesh) in [("cube", &model_materials::cube()), ("torus", &scattered)] {
        for (mode, set) in [
            ("phong", &[][..]),
            ("exact", &["shading.mode=exact"]),
            (
                "blinn",
                &["reflection.model=blinn", "camera.viewer=infinite"],
            ),
            ("gouraud", &["shading.mode=gouraud"]),
            (
                "flat",
                &["shading={mode=\"flat\", flat_at=\"provoking-vertex\"}"],
            ),
            ("pattern", &["pattern={kind=\"rings\", scale=0.4}"]),
            ("microfacets", &["reflection.model=cook-torrance"]),
            (
                "gold",
                &[
                    "reflection.model=cook-torrance",
                    "object.material=[{name=\"red\", reflectance=\"gold\"}]",
                ],
            ),
            ("scene", &["material.source=scene"]),
        ] {
            let name = format!("{name}-{mode}");
            compare_glsl(&name, &small_model(set), Some(mesh));
        }
    }
}

#[test]
fn the_calls_alone_compile() {
    if !mesa() {
        return;
    }
    let main =
        "int main(void) { set_up_camera(8, 8); set_up_lights(); set_up_material(); return 0; }\n";
    for name in ["teapot", "highlight", "infinite"] {
        let source = folder().join(format!("snippet-{name}.c"));
        fs::write(
            &source,
            snippet(&scene(name, &[])).parts[0].text.clone() + main,
        )
        .expect("a file");
        succeeded(
            compile(&source, &folder().join(format!("snippet-{name}"))),
            name,
        );
    }
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

/// A prism over a U, none of whose corners sees all of it, and a comb behind it.
const CONCAVE: &str = "object={kind=\"polygons\", vertices=[\
    [-0.8,0.7,0],[-0.8,-0.7,0],[0.8,-0.7,0],[0.8,0.7,0],[0.3,0.7,0],[0.3,-0.2,0],[-0.3,-0.2,0],[-0.3,0.7,0],\
    [-0.8,0.7,-1],[-0.8,-0.7,-1],[0.8,-0.7,-1],[0.8,0.7,-1],[0.3,0.7,-1],[0.3,-0.2,-1],[-0.3,-0.2,-1],[-0.3,0.7,-1],\
    [-1,-1,-0.9],[-1,1,-1.4],[-0.8,-0.6,-1],[0,1,-1.4],[0.8,-0.6,-1],[1,1,-1.4],[1,-1,-0.9]],\
    faces=[[0,1,2,3,4,5,6,7],[15,14,13,12,11,10,9,8],[0,8,9,1],[1,9,10,2],[2,10,11,3],[3,11,12,4],[4,12,13,5],\
    [5,13,14,6],[6,14,15,7],[7,15,8,0],[22,21,20,19,18,17,16]]}";

/// Polygons that reach far out of the unit sphere, towards the eye and away from it.
const POLYGONS: &str = "object={kind=\"polygons\", vertices=[[-1,-1,2],[1,-1,2],[1,1,-9],[-3,1,-9]], faces=[[0,1,2,3]]}";

#[test]
fn the_shaders_draw_the_same_picture() {
    if !mesa() {
        return;
    }
    let spot = "light=[{kind=\"spot\", position=[1,2,3], direction=[-1,-2,-3], cone=14, exponent=8, softness=0.4}]";
    let area = "light=[{kind=\"area\", samples=25, attenuation=\"inverse-square\", color=[9,9,9]}]";
    let viewer = "light=[{attenuation=\"viewer\", k=-0.0, color=[3,3,3]}, {attenuation=\"light\", k=0.5, position=[-2,1,1]}]";
    let gold = [
        "reflection.model=cook-torrance",
        "material.reflectance=gold",
    ];
    for (name, preset, set) in [
        ("phong-two-lights", "teapot", &["material.n=30"][..]),
        ("stiff", "mirror-like", &[]),
        ("blinn-spot", "sphere", &["reflection.model=blinn", spot]),
        (
            "gold",
            "torus",
            &[&gold[..], &["material.kd=0", "material.ks=1"]].concat(),
        ),
        (
            "grazing",
            "sphere",
            &[
                &gold[..],
                &["material.roughness=0.6", "light.0.position=[3,2,-2]"],
            ]
            .concat(),
        ),
        (
            "ggx",
            "sphere",
            &[
                &gold[..],
                &["reflection.distribution=ggx", "material.roughness=0.4"],
            ]
            .concat(),
        ),
        (
            "glass-phong",
            "sphere",
            &[
                "material.reflectance=glass",
                "material.ks=5",
                "material.n=8",
            ],
        ),
        ("area", "cube", &[area]),
        ("falloff", "sphere", &[viewer]),
        (
            "quadratic",
            "plane",
            &["light.0={attenuation=\"quadratic\", c1=0.1, c2=0.1, c3=0.9}"],
        ),
        (
            "flip",
            "plane",
            &[
                "reflection.backfacing=flip",
                "light.0.position=[0.4,0.7,-0.9]",
            ],
        ),
        ("infinite", "infinite", &["material.n=0.5"]),
        ("srgb", "colored-lights", &["display.encoding=srgb"]),
        (
            "cued-pixels",
            "torus",
            &["depth_cueing={by=\"pixel\", front=3.4, back=4.3, back_scale=0.2}"],
        ),
        (
            "cued-vertices",
            "plane",
            &[
                "depth_cueing={by=\"vertex\", front=3.6, back=4.3}",
                "object.segments=3",
            ],
        ),
        (
            "cued-gouraud",
            "torus",
            &[
                "depth_cueing={by=\"vertex\", front=3.4, back=4.3, color=[1,0,0]}",
                "shading.mode=gouraud",
            ],
        ),
        (
            "cued-affine",
            "plane",
            &[
                "depth_cueing.by=vertex",
                "shading.interpolation=affine",
                "object.segments=2",
                "object.rings=2",
            ],
        ),
        (
            "cued-flat",
            "cone",
            &[
                "depth_cueing={by=\"pixel\", front=3}",
                "shading={mode=\"flat\", flat_at=\"provoking-vertex\"}",
            ],
        ),
        (
            "hatching",
            "sphere",
            &["display.overflow=mark", "light.0.color=[2,2,2]"],
        ),
        (
            "forgetful",
            "sphere",
            &[
                "shading.renormalise=false",
                "object.segments=8",
                "object.rings=6",
            ],
        ),
        (
            "forgetful-facets",
            "sphere",
            &[
                "reflection.model=cook-torrance",
                "shading.renormalise=false",
                "object.segments=8",
                "object.rings=6",
            ],
        ),
        (
            "affine",
            "plane",
            &[
                "shading.interpolation=affine",
                "shading.mode=gouraud",
                "object.segments=2",
                "object.rings=2",
            ],
        ),
        (
            "gouraud",
            "torus",
            &[
                "shading.mode=gouraud",
                "object.segments=24",
                "object.rings=12",
            ],
        ),
        (
            "flat",
            "torus",
            &[
                "shading={mode=\"flat\", flat_at=\"provoking-vertex\"}",
                "object.segments=24",
                "object.rings=12",
            ],
        ),
        ("rings", "sphere", &["pattern={kind=\"rings\", scale=0.4}"]),
        ("orthographic", "cone", &["camera.projection=orthographic"]),
        ("rolled", "cube", &["camera.roll=-50"]),
        ("polygons", "plane", &[POLYGONS]),
        (
            "concave",
            "sphere",
            &[CONCAVE, "camera.eye=[1.5,2,3]", "object.normals=averaged"],
        ),
        (
            "concave-flat",
            "sphere",
            &[
                CONCAVE,
                "camera.eye=[1.5,2,3]",
                "light.0.position=[0.4,0.5,0.8]",
                "shading={mode=\"flat\", flat_at=\"provoking-vertex\"}",
            ],
        ),
    ] {
        let scene = small(preset, set);
        assert_eq!(
            glsl_330_of_model(&scene, None).limits,
            [] as [Limit; 0],
            "{name}"
        );
        compare_glsl(name, &scene, None);
    }
}
