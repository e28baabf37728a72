//! The scene in fixed-function OpenGL 1.x: the computation before there were shaders.
//!
//! In: a scene and its polygons. Out: C that sets up camera, lights and material, and with it a whole program that
//! draws the polygons off screen.

mod concave;
mod lights;

use super::limit::{Limit, holding, limit};
use super::sources::{Materials, flat, interpolation, surroundings};
use super::text::{c_double, c_float, c_four, c_three, filled, head, said};
use super::{Export, ExportError, Part, export_mesh};
use crate::geometry::{Mesh, VertexMesh};
use crate::illumination::{Index, SpecularForm, blinn_from_phong};
use crate::scene::{
    Backfacing, Camera, CuedBy, DepthCueing, Encoding, Framing, Overflow, PatternKind, Projection,
    ReflectionModel, Rgb, Scene, ShadingMode, View,
};
use crate::text::Message;
use concave::Concave;
use glam::{DVec3, Vec3};
use lights::{GREATEST_EXPONENT, light_limits, lights};

/// Maximum number of triangles written as C: about 100 MB of text.
pub const MAX_PROGRAM_TRIANGLES: usize = 1_000_000;

/// Minimum distance of drawn points, in camera distances.
const NEAR: f64 = 1e-3;

/// Margin in front of the nearest and behind the farthest vertex.
const MARGIN: f64 = 1.01;

const SNIPPET: [&str; 4] = [
    "A scene of shading-lab in fixed-function OpenGL. Call, with a context current and in this order:",
    "    set_up_camera(width, height); set_up_lights(); set_up_material();",
    "Then draw polygons with unit normals, counter-clockwise from outside. The equation, per channel:",
    "    I = Ka*Od*Ia + sum over the lights of f*Ip*[Kd*Od*(N.L) + Ks*Os*(N.H)^n], where N.L > 0",
];

const PROGRAM: [&str; 4] = [
    "A scene of shading-lab in fixed-function OpenGL: a whole program, which draws off screen.",
    "    cc -std=c99 -Wall -Wextra scene.c -o scene -lEGL -lGL && ./scene picture.ppm",
    "(Debian: apt install libegl-dev libgl-dev libgl1-mesa-dri.) The equation, per channel:",
    "    I = Ka*Od*Ia + sum over the lights of f*Ip*[Kd*Od*(N.L) + Ks*Os*(N.H)^n], where N.L > 0",
];

/// Returns the reusable part: `set_up_camera(width, height)`, `set_up_lights()` and `set_up_material()` in C99, to be
/// called in this order with an OpenGL context current. The mesh determines the distances that the depth buffer
/// spans.
pub fn opengl_c_snippet(scene: &Scene, mesh: &Mesh) -> Export {
    let mesh = export_mesh(scene, mesh);
    let mut limits = limits(scene, &mesh);
    limits.push(limit!("export-limit-vertex-clamp"));
    let head = head(&SNIPPET, &limits, " * ");
    let functions = functions(scene, &mesh);
    let text = format!("/*\n{head} */\n\n#include <GL/gl.h>\n\n{functions}");
    in_c(text, limits)
}

/// Returns a whole program in C99: the functions of [`opengl_c_snippet`], the polygons and a `main` that draws them
/// off screen through EGL and writes a binary PPM picture to a given path.
///
/// # Examples
/// ```
/// use shading_lab::export::opengl_c;
/// use shading_lab::geometry::tessellate;
/// use shading_lab::scene::Scene;
///
/// let scene = Scene::default();
/// let export = opengl_c(&scene, &tessellate(&scene.object))?;
/// assert!(export.parts[0].text.contains("glLightfv"));
/// for limit in &export.limits {
///     println!("{limit:?}"); // what OpenGL cannot express
/// }
/// # Ok::<(), shading_lab::export::ExportError>(())
/// ```
///
/// # Errors
/// A mesh of more than [`MAX_PROGRAM_TRIANGLES`] triangles.
pub fn opengl_c(scene: &Scene, mesh: &Mesh) -> Result<Export, ExportError> {
    let triangles = mesh.triangle_count();
    if triangles > MAX_PROGRAM_TRIANGLES {
        return Err(ExportError::MeshTooLarge { triangles });
    }
    let mesh = export_mesh(scene, mesh);
    let limits = limits(scene, &mesh);
    let head = head(&PROGRAM, &limits, " * ");
    let includes = include_str!("fixed/includes.c");
    let (functions, main) = (functions(scene, &mesh), main(scene, &mesh));
    let text = format!("/*\n{head} */\n\n{includes}\n{functions}\n{main}");
    Ok(in_c(text, limits))
}

fn in_c(text: String, limits: Vec<Limit>) -> Export {
    Export {
        parts: vec![Part {
            title: Message("export-c"),
            ending: "c",
            text,
        }],
        limits,
    }
}

fn functions(scene: &Scene, mesh: &VertexMesh) -> String {
    format!(
        "{}\n{}\n{}",
        camera(scene, mesh),
        lights(scene, mesh),
        material(scene, mesh)
    )
}

/// Returns the features that fixed-function OpenGL cannot express.
fn limits(scene: &Scene, mesh: &VertexMesh) -> Vec<Limit> {
    let (materials, _) = Materials::of(scene, Some(mesh));
    let mut limits = surroundings(scene, &materials);
    let shading = match scene.shading.mode {
        ShadingMode::Phong => Some(limit!("export-limit-phong")),
        ShadingMode::Exact => Some(limit!("export-limit-exact")),
        ShadingMode::Flat => flat(scene),
        ShadingMode::Interpolated | ShadingMode::Gouraud => interpolation(scene, false),
    };
    limits.extend(shading);
    let specular = materials.each(scene, |scene| match SpecularForm::of(scene) {
        SpecularForm::None => vec![],
        _ => specular_limits(scene),
    });
    for limit in specular.into_iter().flatten() {
        if !limits.contains(&limit) {
            limits.push(limit);
        }
    }
    limits.extend(holding([
        (
            scene.pattern.kind != PatternKind::None,
            limit!("export-limit-pattern"),
        ),
        (
            // A law of the scene's own turns no N.
            scene.reflection.backfacing == Backfacing::Flip && !scene.reflection.is_own_law(),
            limit!("export-limit-two-side"),
        ),
    ]));
    limits.extend(light_limits(scene, mesh));
    limits.extend(fog_limits(scene, mesh));
    limits.extend(holding([
        (
            scene.display.overflow == Overflow::Scale,
            limit!("export-limit-scale"),
        ),
        (
            scene.display.overflow == Overflow::Mark,
            limit!("export-limit-hatching"),
        ),
        (
            scene.display.encoding == Encoding::Srgb,
            limit!("export-limit-srgb"),
        ),
    ]));
    limits
}

fn specular_limits(scene: &Scene) -> Vec<Limit> {
    let n = exponent(scene);
    let mut limits = Vec::new();
    match scene.reflection.model {
        ReflectionModel::Blinn => {}
        ReflectionModel::Formula => {
            let n = said(n.min(GREATEST_EXPONENT));
            return vec![limit!("export-limit-own-law", n = n)];
        }
        ReflectionModel::Phong => limits.push(limit!(
            "export-limit-phong-lobe",
            blinn = said(n),
            phong = said(scene.material.n)
        )),
        ReflectionModel::CookTorrance => {
            limits.push(limit!("export-limit-microfacets", n = said(n)));
        }
    }
    if n > GREATEST_EXPONENT {
        limits.push(limit!("export-limit-shininess", n = said(n)));
    }
    if index(scene).is_some() {
        limits.push(limit!("export-limit-reflectance"));
    }
    limits
}

/// Writes the camera as two matrices: from the world to the eye, and from the eye to the picture.
fn camera(scene: &Scene, mesh: &VertexMesh) -> String {
    let camera = &scene.camera;
    let view = View::new(camera, scene.image.size);
    let [near, far] = planes(camera, &view, mesh).map(c_double);
    let [eye, target] =
        [camera.eye, camera.target].map(|place| place.to_array().map(said).join(", "));
    let (scale, scale_means, third, fourth) = match camera.projection {
        Projection::Perspective => (
            1.0 / (0.5 * camera.fov_y.to_radians()).tan(),
            format!("cot(fov_y/2), fov_y = {} degrees", said(camera.fov_y)),
            "-(z_far + z_near) / (z_far - z_near), -1.0",
            "-2.0 * z_far * z_near / (z_far - z_near), 0.0",
        ),
        Projection::Orthographic => (
            2.0 / camera.height,
            format!(
                "2/height, {} units are seen across the span",
                said(camera.height)
            ),
            "-2.0 / (z_far - z_near), 0.0",
            "-(z_far + z_near) / (z_far - z_near), 1.0",
        ),
    };
    let [span, across, upwards] = match camera.framing {
        Framing::Height => ["", "height", "scale"],
        Framing::Whole => [
            "    const double span = width < height ? width : height; /* the shorter side */\n",
            "span",
            "scale * span / height",
        ],
    };
    let column = |v: DVec3, w: &str| {
        let seen = [v.dot(view.right), v.dot(view.up), v.dot(-view.forward)];
        format!("        {}, {w}", seen.map(c_double).join(", "))
    };
    let columns = [
        column(DVec3::X, "0.0"),
        column(DVec3::Y, "0.0"),
        column(DVec3::Z, "0.0"),
        column(-view.eye, "1.0"),
    ];
    filled(
        include_str!("fixed/camera.c"),
        &[
            ("eye", &eye),
            ("target", &target),
            ("near", &near),
            ("far", &far),
            ("scale", &c_double(scale)),
            ("scale_means", &scale_means),
            ("span", span),
            ("across", across),
            ("upwards", upwards),
            ("third", third),
            ("fourth", fourth),
            ("columns", &columns.join(",\n")),
            ("fog", &fog(&scene.depth_cueing)),
        ],
    )
}

/// Returns the depths of the vertices.
fn depths(mesh: &VertexMesh, view: &View) -> impl Iterator<Item = f64> {
    mesh.positions
        .iter()
        .map(move |p| (mesh.origin + p.as_dvec3() - view.eye).dot(view.forward))
}

/// Returns the depths that the depth buffer spans: those of the vertices in front of the eye.
fn planes(camera: &Camera, view: &View, mesh: &VertexMesh) -> [f64; 2] {
    let nearest = NEAR * camera.distance();
    let (min, max) = depths(mesh, view).fold((f64::INFINITY, 0.0_f64), |(low, high), depth| {
        (low.min(depth), high.max(depth))
    });
    let near = if min.is_finite() {
        (min / MARGIN).max(nearest)
    } else {
        nearest
    };
    [near, (max * MARGIN).max(2.0 * near)]
}

/// Writes depth cueing as OpenGL's linear fog, which mixes with f = (end − z)/(end − start), clamped to 0..1, at
/// every pixel. So a ramp of s0 from 1 to 0 is expressed exactly; any other one only where the object does not leave
/// it.
fn fog(cueing: &DepthCueing) -> String {
    let DepthCueing {
        front,
        back,
        front_scale,
        back_scale,
        ..
    } = *cueing;
    let fall = front_scale - back_scale;
    if cueing.by == CuedBy::Off || fall == 0.0 {
        return String::new();
    }
    // The depth at which the ramp of s0 has a value.
    let depth_of = |s0: f64| front + (front_scale - s0) / fall * (back - front);
    filled(
        include_str!("fixed/fog.c"),
        &[
            ("color", &c_four(cueing.color, 1.0)),
            ("start", &c_float(depth_of(1.0))),
            ("end", &c_float(depth_of(0.0))),
            ("front", &said(front)),
            ("back", &said(back)),
            ("front_scale", &said(front_scale)),
            ("back_scale", &said(back_scale)),
        ],
    )
}

/// Returns the features of depth cueing that fog does not express.
fn fog_limits(scene: &Scene, mesh: &VertexMesh) -> Vec<Limit> {
    let cueing = &scene.depth_cueing;
    let DepthCueing {
        front,
        back,
        front_scale,
        back_scale,
        ..
    } = *cueing;
    if cueing.by == CuedBy::Off || [front_scale, back_scale] == [1.0; 2] {
        return Vec::new();
    }
    let whole = |s0: f64| s0 == 0.0 || s0 == 1.0;
    let leaves = depths(mesh, &View::new(&scene.camera, scene.image.size)).any(|depth| {
        (depth < front && !whole(front_scale)) || (depth > back && !whole(back_scale))
    });
    let flat = front_scale == back_scale;
    holding([
        (flat, limit!("export-limit-cueing-constant")),
        (!flat && leaves, limit!("export-limit-cueing-beyond")),
        (
            !flat && cueing.by == CuedBy::Vertex,
            limit!("export-limit-cueing-vertices"),
        ),
        (
            !flat && cueing.color.max_element() > 1.0,
            limit!("export-limit-cueing-colour"),
        ),
    ])
}

/// Returns the n of `(N·H)^n` that is nearest to the scene's highlight.
fn exponent(scene: &Scene) -> f64 {
    let material = &scene.material;
    match scene.reflection.model {
        ReflectionModel::Blinn | ReflectionModel::Formula => material.n,
        ReflectionModel::Phong => blinn_from_phong(material.n),
        // The inverse of m = √(2/(n + 2)).
        ReflectionModel::CookTorrance => {
            (2.0 / (material.roughness * material.roughness) - 2.0).max(0.0)
        }
    }
}

/// Returns the index of refraction that W depends on, if it does: a law of the scene's own has no W.
fn index(scene: &Scene) -> Option<Index> {
    Index::of(&scene.material).filter(|_| !scene.reflection.is_own_law())
}

/// Writes the four coefficients of a material: of each, its array in C and its meaning.
fn coefficients(scene: &Scene) -> [(String, String); 4] {
    let material = &scene.material;
    let index = index(scene);
    let head_on = index.map_or(Rgb::ONE, |index| index.reflectance(1.0));
    let n_means = match scene.reflection.model {
        _ if SpecularForm::of(scene) == SpecularForm::None => {
            "n, of no effect: no specular light".to_owned()
        }
        ReflectionModel::Blinn | ReflectionModel::Formula => "n of (N.H)^n".to_owned(),
        ReflectionModel::Phong => format!(
            "as wide as (R.V)^n with n = {}, up to 128",
            said(material.n)
        ),
        ReflectionModel::CookTorrance => format!(
            "as wide as roughness {}, up to 128",
            said(material.roughness)
        ),
    };
    let specular_means = match index {
        Some(_) => "Ks*Os, times W at normal incidence",
        None => "Ks*Os",
    };
    let specular = material.ks * material.specular_color * head_on;
    [
        (
            c_four(material.ka * material.color, 1.0),
            "Ka*Od".to_owned(),
        ),
        (
            c_four(material.kd * material.color, 1.0),
            "Kd*Od".to_owned(),
        ),
        (c_four(specular, 1.0), specular_means.to_owned()),
        (c_float(exponent(scene).min(GREATEST_EXPONENT)), n_means),
    ]
}

/// Writes `use_material()`, where there are several materials.
fn use_material(scene: &Scene, materials: &Materials) -> String {
    if materials.all.len() == 1 {
        return String::new();
    }
    let rows = materials.each(scene, |scene| {
        coefficients(scene).map(|(numbers, _)| numbers)
    });
    let row = |(index, row): (usize, &[String; 4])| {
        format!(
            "    {{{}}}, /* {index}: {} */\n",
            row.join(", "),
            materials.name(index)
        )
    };
    let rows: String = rows.iter().enumerate().map(row).collect();
    filled(include_str!("fixed/materials.c"), &[("rows", &rows)]) + "\n"
}

/// Writes `set_up_material()`: `glMaterial*`, the shading of polygons and the culling of their faces.
fn material(scene: &Scene, mesh: &VertexMesh) -> String {
    let (materials, _) = Materials::of(scene, Some(mesh));
    let own = if materials.all.len() == 1 {
        let [coefficients] = &materials.each(scene, coefficients)[..] else {
            return String::new();
        };
        let [ambient, diffuse, specular, n] = coefficients;
        let values: [(&str, &str); 8] = [
            ("ambient", &ambient.0),
            ("ambient_means", &ambient.1),
            ("diffuse", &diffuse.0),
            ("diffuse_means", &diffuse.1),
            ("specular", &specular.0),
            ("specular_means", &specular.1),
            ("n", &n.0),
            ("n_means", &n.1),
        ];
        filled(include_str!("fixed/coefficients.c"), &values)
    } else {
        include_str!("fixed/first.c").to_owned()
    };
    let (model, model_means) = match scene.shading.mode {
        ShadingMode::Flat => ("GL_FLAT", "the shade of each triangle's last vertex"),
        ShadingMode::Interpolated => (
            "GL_SMOOTH",
            "intensities interpolated, between vertices with the polygon's N",
        ),
        _ => (
            "GL_SMOOTH",
            "Gouraud's: intensities interpolated between vertices",
        ),
    };
    let eye_outside = (scene.camera.eye - mesh.origin).length() > mesh.radius() * 1.01;
    let culling = if mesh.closed && eye_outside {
        "    glCullFace(GL_BACK);\n    glEnable(GL_CULL_FACE); /* a closed solid hides its back faces */"
    } else {
        "    glDisable(GL_CULL_FACE); /* it can be seen from behind */"
    };
    let front = match scene.reflection.backfacing {
        Backfacing::Clamp => "counter-clockwise polygons are seen from outside",
        Backfacing::Flip => "clockwise polygons are seen from behind: there N is turned",
    };
    use_material(scene, &materials)
        + &filled(
            include_str!("fixed/material.c"),
            &[
                ("own", &own),
                ("model", model),
                ("model_means", model_means),
                ("front", front),
                ("culling", culling),
            ],
        )
}

/// Writes the polygons as arrays, and off-screen drawing. For flat shading each is a fan from its first vertex, which
/// comes last, since OpenGL takes the shade from there.
fn main(scene: &Scene, mesh: &VertexMesh) -> String {
    let [width, height] = scene.image.size.map(|side| side.to_string());
    let flat = scene.shading.mode == ShadingMode::Flat;
    let row = |[a, b, c]: [u32; 3]| {
        if flat {
            format!("    {{{b}, {c}, {a}}},\n")
        } else {
            format!("    {{{a}, {b}, {c}}},\n")
        }
    };
    let (materials, face_materials) = Materials::of(scene, Some(mesh));
    let several = materials.all.len() > 1;
    let concave = if flat {
        Concave::of(mesh, several.then_some(&face_materials))
    } else {
        Concave::default()
    };
    let mut faces: Vec<usize> = (0..mesh.face_count())
        .filter(|f| !concave.has(*f))
        .collect();
    let own = |f: &usize| face_materials.of_face(*f as u32);
    faces.sort_by_key(own);
    let run = |faces: &[usize]| {
        let triangles: usize = faces.iter().map(|f| mesh.face_triangles(*f).len()).sum();
        format!("    {{{}, {triangles}}},\n", own(&faces[0]))
    };
    let runs: String = faces.chunk_by(|a, b| own(a) == own(b)).map(run).collect();
    let (declared, runs, draw) = if several {
        let runs = if runs.is_empty() {
            "    {0, 0},"
        } else {
            &runs
        };
        (
            "    const GLuint *from = triangles[0];\n    size_t i;\n\n",
            filled(include_str!("fixed/runs.c"), &[("runs", runs)]) + "\n",
            include_str!("fixed/draw_runs.c"),
        )
    } else {
        ("", String::new(), include_str!("fixed/draw_all.c"))
    };
    let triangles: Vec<[u32; 3]> = faces
        .into_iter()
        .flat_map(|f| mesh.face_triangles(f))
        .collect();
    let order = match (flat, mesh.cut.is_empty()) {
        (true, true) => ", which gives the shade and so comes last",
        (true, false) => ", which gives the shade and so comes last; some concave ones follow",
        (false, true) => "",
        (false, false) => ", or other triangles where it is concave",
    };
    let count = triangles.len().to_string();
    let triangles: String = triangles.into_iter().map(row).collect();
    let list = |vectors: &[Vec3]| -> String {
        let vectors = if vectors.is_empty() {
            &[Vec3::ZERO]
        } else {
            vectors
        };
        vectors
            .iter()
            .map(|v| format!("    {{{}}},\n", c_three(v.as_dvec3())))
            .collect()
    };
    filled(
        include_str!("fixed/main.c"),
        &[
            ("width", &width),
            ("height", &height),
            ("count", &count),
            ("background", &c_three(scene.image.background)),
            ("origin", &mesh.origin.to_array().map(c_double).join(", ")),
            ("positions", &list(&mesh.positions)),
            ("normals", &list(&mesh.normals)),
            ("order", order),
            ("runs", &runs),
            ("draw", draw),
            ("declared", declared),
            ("concave", &concave.text()),
            ("draw_concave", concave.draw()),
            ("stencil", concave.stencil()),
            (
                "triangles",
                if triangles.is_empty() {
                    "    {0, 0, 0},"
                } else {
                    &triangles
                },
            ),
        ],
    )
}
