//! The scene as a vertex and a fragment shader in GLSL 3.30: the equation of this program, term by term.
//!
//! Phong and exact shading evaluate the equation in the fragment shader, the other modes in the vertex shader: the
//! code of the equation is the same.

mod numbers;
mod own_law;

use super::limit::limit;
use super::sources::{
    Emitter, EmitterPosition, Materials, emitters, flat, interpolation, surroundings,
};
use super::text::{filled, float, head, said, vec3};
use super::{Export, Part, export_mesh};
use crate::geometry::{Mesh, built_in};
use crate::illumination::{Index, SpecularForm};
use crate::render::srgb;
use crate::scene::{
    Attenuation, Backfacing, Camera, CuedBy, Encoding, Interpolation, Light, LightKind,
    NormalSource, Object, ObjectKind, Overflow, PatternKind, Projection, Scene, ShadingMode, View,
    Viewer,
};
use crate::text::{Language, Message, in_language};
use glam::{DMat4, DVec3, DVec4};
use numbers::{constants, own};
use own_law::OwnLaw;

/// Radius about the origin that contains every built-in shape: √2 for the corners of the plane, a little more for
/// rounding.
const SHAPES: f64 = 1.42;

/// Margin in front of the nearest and behind the farthest of a scene's own polygons.
const MARGIN: f64 = 1.01;

/// Minimum distance of drawn points, in camera distances; its inverse is the maximum.
const NEAR: f64 = 1e-3;

const EQUATION: &str =
    "    I = Ka*Od*Ia + sum over the lights of f*Ip*[Kd*Od*(N.L) + Ks*Os*W*S], where N.L > 0";

const OWN_EQUATION: &str =
    "    I = Ka*Od*Ia + sum over the lights of f*Ip*law, the scene's own law";

/// The distance of parallel rays in camera distances, as in the equation.
const FARTHEST: f64 = 1e12;

/// Code for the direction to a light; lengths get a small minimum before they are divisors.
const DIRECTION: &str = "    float d = max(length(to_light), 1e-9);\n    vec3 L = to_light / d;\n";

/// Returns a pair of shaders, `#version 330 core`, that evaluates the scene's equation where its shading mode does.
/// They need positions (location 0) and unit normals (location 1) in the world and nothing else: the uniforms have
/// the scene's values as defaults.
///
/// # Examples
/// ```
/// use shading_lab::export::glsl_330;
/// use shading_lab::scene::Scene;
///
/// let export = glsl_330(&Scene::default());
/// let [vertex, fragment] = &export.parts[..] else { unreachable!("two shaders") };
/// assert!(vertex.text.contains("#version 330 core") && fragment.text.contains("#version 330 core"));
/// ```
pub fn glsl_330(scene: &Scene) -> Export {
    glsl_330_of_model(scene, None)
}

/// Returns the shaders as [`glsl_330`] does, for the mesh of an object of kind `obj`: where its faces have several materials, a
/// uniform chooses among them.
pub fn glsl_330_of_model(scene: &Scene, model: Option<&Mesh>) -> Export {
    let given = model.filter(|_| scene.object.kind == ObjectKind::Obj);
    let model = built_in(scene.object.kind).map(|mesh| &**mesh).or(given);
    let mesh = model.map(|mesh| export_mesh(scene, mesh));
    let (materials, _) = Materials::of(scene, mesh.as_ref());
    let mut limits = surroundings(scene, &materials);
    let shading = match scene.shading.mode {
        ShadingMode::Exact if scene.object.kind.has_surface() => {
            Some(limit!("export-limit-exact-pixels"))
        }
        ShadingMode::Exact => None,
        ShadingMode::Flat => flat(scene),
        _ => interpolation(scene, true),
    };
    let scale = (scene.display.overflow == Overflow::Scale).then(|| limit!("export-limit-scale"));
    limits.extend([shading, scale].into_iter().flatten());
    let law = OwnLaw::of(scene);
    let terms = match &law {
        Some(law) => pattern(scene) + law.text(),
        None => terms(scene, &materials),
    };
    let law = law.as_ref();
    let equation = format!(
        "{}\n{terms}\n{}",
        constants(scene, &materials, law),
        lights(scene, law)
    );
    let [in_vertex, in_fragment] = if per_pixel(scene) {
        ["", equation.as_str()]
    } else {
        [equation.as_str(), ""]
    };
    let part = |title: Message, ending, text| {
        let what = in_language(Language::English, || {
            format!("A scene of shading-lab: the {} of a pair.", title.text())
        });
        let head = head(
            &[
                &what,
                &host(scene, &materials),
                "The equation, per channel:",
                law.map_or(EQUATION, |_| OWN_EQUATION),
            ],
            &limits,
            "// ",
        );
        Part {
            title,
            ending,
            text: format!("#version 330 core\n{head}\n{text}"),
        }
    };
    let parts = vec![
        part(
            Message("export-vertex-shader"),
            "vert",
            vertex(scene, in_vertex),
        ),
        part(
            Message("export-fragment-shader"),
            "frag",
            fragment(scene, in_fragment),
        ),
    ];
    Export { parts, limits }
}

/// Describes the duties of the program around the shaders.
fn host(scene: &Scene, materials: &Materials) -> String {
    let normals = match (scene.shading.mode, scene.object.normal_source()) {
        (ShadingMode::Interpolated, _) | (_, NormalSource::Facet) => {
            "each polygon's own, so that no vertex is shared"
        }
        (_, NormalSource::Averaged) => "the mean of the polygons' at the vertex",
        (_, NormalSource::Exact) => "the true surface's",
        (_, NormalSource::File) => "the file's",
    };
    let provoking = match scene.shading.mode {
        ShadingMode::Flat => {
            " glProvokingVertex(GL_FIRST_VERTEX_CONVENTION) takes the shade of the first vertex: each polygon is a fan \
             about its own, a concave one drawn through the stencil buffer."
        }
        _ => "",
    };
    let encoded = |v: f64| match scene.display.encoding {
        Encoding::Srgb => srgb(v.clamp(0.0, 1.0)),
        Encoding::Raw => v.clamp(0.0, 1.0),
    };
    let background = scene
        .image
        .background
        .to_array()
        .map(|v| said(encoded(v)))
        .join(", ");
    let [width, height] = scene.image.size;
    let chosen = match materials.all.len() {
        1 => String::new(),
        _ => format!(
            " Before the polygons of each material it sets the uniform `material` to its number: {}.",
            materials.list()
        ),
    };
    format!(
        "The program around them gives positions and unit normals ({normals}), enables GL_DEPTH_TEST and clears a picture \
         of {width}x{height} pixels to ({background}).{provoking}{chosen}"
    )
}

/// Writes the functions for the lights' contributions, and `reflected`, which combines them.
fn terms(scene: &Scene, materials: &Materials) -> String {
    let mut forms = materials.each(scene, SpecularForm::of);
    forms.retain(|form| *form != SpecularForm::None);
    let form = forms.first().copied().unwrap_or(SpecularForm::None);
    let indices: Vec<Option<Index>> = match form {
        SpecularForm::None => vec![],
        _ => (materials.all.iter())
            .map(|own| Index::of(&own.material))
            .collect(),
    };
    let by_angle = indices.iter().any(Option::is_some);
    let always = indices.iter().all(Option::is_some);
    let mut text = pattern(scene) + &specular(&forms);
    if by_angle {
        let fresnel = include_str!("glsl/fresnel.glsl");
        let of = |number: fn(&Index) -> DVec3| -> Vec<String> {
            let number = |index: &Option<Index>| vec3(index.as_ref().map_or(DVec3::ONE, number));
            indices.iter().map(number).collect()
        };
        let (eta, k) = (of(|index| index.eta), of(|index| index.k));
        text += "// The complex index of refraction, per channel.\n";
        text += &format!(
            "{}\n{}\n",
            own("vec3", "eta", &eta),
            own("vec3", "kappa", &k)
        );
        if !always {
            let flags: Vec<String> = indices
                .iter()
                .map(|index| index.is_some().to_string())
                .collect();
            text += &format!(
                "{} // whether W depends on the angle\n",
                own("bool", "by_angle", &flags)
            );
        }
        text += &format!("\n{fresnel}\n");
    }
    let turn = match scene.reflection.backfacing {
        Backfacing::Clamp => "",
        Backfacing::Flip => {
            "    if (NL < 0.0) {
        // The surface has two sides: N is turned towards the light.
        N = -N;
        NL = -NL;
    }"
        }
    };
    // |L + V|/2 is the cosine of half the angle between them.
    let cosine = if form.at_halfway() {
        "0.5 * length(L + V)"
    } else {
        "NL"
    };
    let (incidence, w) = match (by_angle, always) {
        (false, _) => (String::new(), ""),
        (true, true) => (format!("    vec3 W = reflectance({cosine});"), " * W"),
        (true, false) => (
            format!("    vec3 W = by_angle ? reflectance({cosine}) : vec3(1.0);"),
            " * W",
        ),
    };
    let specular = match form {
        SpecularForm::None => String::new(),
        _ => format!(" + Ks * Os{w} * specular_factor(N, L, V, NL)"),
    };
    let values: [(&str, &str); 3] = [
        ("turn", turn),
        ("incidence", &incidence),
        ("specular", &specular),
    ];
    text + &filled(include_str!("glsl/reflected.glsl"), &values)
}

/// Writes `specular_factor`, the S of the equation, in the forms that the materials need: up to two, where n decides.
fn specular(forms: &[SpecularForm]) -> String {
    let form = forms.first().copied().unwrap_or(SpecularForm::None);
    const PHONG: &str = "S = (R.V)^n with R = 2N(N.L) - L (Phong)";
    const BLINN: &str = "S = (N.H)^n with H = (L + V)/|L + V| (Blinn)";
    const BECKMANN: &str = "S = pi*D*G/(4*(N.V)) (Cook and Torrance, Beckmann)";
    const GGX: &str = "S = pi*D*G/(4*(N.V)) (Cook and Torrance, Walter et al.)";
    const PHONG_COSINE: &str = "power(2.0 * NL * dot(N, V) - dot(L, V))";
    const PHONG_CHORD: &str = "power(2.0 * NL * N - L, V)";
    const BLINN_COSINE: &str = "power(dot(N, normalize(L + V)))";
    const BLINN_CHORD: &str = "power(N, normalize(L + V))";
    const FACETS: &str = "facets(N, L, V, NL)";
    let by_cosine = include_str!("glsl/gap_of_cosine.glsl");
    let by_chord = include_str!("glsl/gap_of_chord.glsl");
    let power = include_str!("glsl/power_of_cosine.glsl");
    let chord = include_str!("glsl/power_of_chord.glsl");
    let beckmann = include_str!("glsl/beckmann.glsl");
    let ggx = include_str!("glsl/ggx.glsl");
    let (both, either);
    let (gap, helpers, doc, body) = match form {
        SpecularForm::None | SpecularForm::Formula => return String::new(),
        _ if forms.iter().any(|other| *other != form) => {
            let (doc, cosine, chord_of) = if form.at_halfway() {
                (BLINN, BLINN_COSINE, BLINN_CHORD)
            } else {
                (PHONG, PHONG_COSINE, PHONG_CHORD)
            };
            both = format!("{power}\n{chord}");
            either = format!(
                "n < {} ? {cosine} : {chord_of}",
                float(SpecularForm::CHORD_FROM)
            );
            ("", &*both, doc, &*either)
        }
        SpecularForm::PhongCosine => ("", power, PHONG, PHONG_COSINE),
        SpecularForm::PhongChord => ("", chord, PHONG, PHONG_CHORD),
        SpecularForm::BlinnCosine => ("", power, BLINN, BLINN_COSINE),
        SpecularForm::BlinnChord => ("", chord, BLINN, BLINN_CHORD),
        SpecularForm::Beckmann => (by_chord, beckmann, BECKMANN, FACETS),
        SpecularForm::BeckmannCosine => (by_cosine, beckmann, BECKMANN, FACETS),
        SpecularForm::Ggx => (by_chord, ggx, GGX, FACETS),
        SpecularForm::GgxCosine => (by_cosine, ggx, GGX, FACETS),
    };
    let facet = if gap.is_empty() {
        String::new()
    } else {
        filled(include_str!("glsl/facet.glsl"), &[("gap", gap)]) + "\n"
    };
    let signature = "float specular_factor(vec3 N, vec3 L, vec3 V, float NL)";
    format!("{facet}{helpers}\n// {doc}.\n{signature} {{\n    return {body};\n}}\n\n")
}

/// Writes `surface_color`, Od at a point.
fn pattern(scene: &Scene) -> String {
    let pattern = &scene.pattern;
    let around = if scene.object.kind.faces_viewer() {
        "xy"
    } else {
        "xz"
    };
    let count = match pattern.kind {
        PatternKind::None => return String::new(),
        PatternKind::Checker => "floor(p.x + 0.5) + floor(p.y + 0.5) + floor(p.z + 0.5)".to_owned(),
        PatternKind::Stripes => "floor(p.y + 0.5)".to_owned(),
        PatternKind::Rings => format!("floor(length(p.{around}) + 0.5)"),
    };
    filled(
        include_str!("glsl/pattern.glsl"),
        &[
            ("fields", &said(pattern.scale)),
            ("color", &vec3(pattern.color)),
            ("scale", &float(pattern.scale)),
            ("count", &count),
        ],
    )
}

/// Writes a function for each light, and `illuminate`, which adds them up.
fn lights(scene: &Scene, law: Option<&OwnLaw>) -> String {
    let emitters = emitters(scene);
    let farthest = FARTHEST * scene.camera.distance();
    let light = |emitter| light(emitter, law, farthest);
    let functions: String = emitters.iter().map(light).collect();
    let view = match scene.camera.viewer {
        Viewer::Local => "normalize(eye - P)",
        Viewer::Infinite => "towards_viewer",
    };
    let color = if scene.pattern.kind == PatternKind::None {
        "Od"
    } else {
        "surface_color(P)"
    };
    let call =
        |emitter: &Emitter<'_>| format!("    I += light_{}(P, N, V, color);\n", emitter.index);
    let calls: String = emitters.iter().map(call).collect();
    let values: [(&str, &str); 3] = [("view", view), ("color", color), ("lights", &calls)];
    functions + &filled(include_str!("glsl/illuminate.glsl"), &values)
}

/// Writes a light's function; the rays of one that is parallel come from the distance `farthest`.
fn light(emitter: &Emitter<'_>, law: Option<&OwnLaw>, farthest: f64) -> String {
    let index = emitter.index.to_string();
    let d = law.map_or("", OwnLaw::distance);
    let (what, direction) = match &emitter.place {
        EmitterPosition::Among(points) => return area(emitter, points, &index, d),
        EmitterPosition::Towards(l) => {
            let mut direction = format!("    const vec3 L = {};\n", vec3(*l));
            if !d.is_empty() {
                let d = float(farthest);
                direction += &format!("    const float d = {d}; // almost infinite\n");
            }
            ("L is the same everywhere", direction)
        }
        EmitterPosition::At(place) => {
            let to_light = format!("    vec3 to_light = {} - P;\n{DIRECTION}", vec3(*place));
            ("L points to its place from each point", to_light)
        }
    };
    let shine = direction + &shine(emitter, "return", d);
    filled(
        include_str!("glsl/light.glsl"),
        &[
            ("title", &emitter.title()),
            ("what", what),
            ("index", &index),
            ("Ip", &vec3(emitter.light.color)),
            ("shine", &shine),
        ],
    )
}

/// Writes an area light: the points that represent it, and a loop over them.
fn area(emitter: &Emitter<'_>, points: &[DVec3], index: &str, d: &str) -> String {
    let list: Vec<_> = points
        .iter()
        .map(|&point| format!("    {}", vec3(point)))
        .collect();
    let body = format!(
        "    vec3 to_light = points_{index}[i] - P;\n{DIRECTION}{}",
        shine(emitter, "sum +=", d)
    );
    let body: String = body.lines().map(|line| format!("    {line}\n")).collect();
    filled(
        include_str!("glsl/area.glsl"),
        &[
            ("title", &emitter.title()),
            ("index", index),
            ("count", &points.len().to_string()),
            ("points", &list.join(",\n")),
            ("Ip", &vec3(emitter.light.color)),
            ("shine", &body),
        ],
    )
}

/// Writes f, a spot light's factor, and the reflected light, which `verb` returns or adds; `d` passes the distance on.
fn shine(emitter: &Emitter<'_>, verb: &str, d: &str) -> String {
    let Light {
        attenuation,
        k,
        c1,
        c2,
        c3,
        ..
    } = *emitter.light;
    let [k, c1, c2, c3] = [k, c1, c2, c3].map(float);
    let f = match (attenuation, emitter.constant) {
        (_, Some(f)) => float(f),
        (Attenuation::Viewer, _) => format!("1.0 / max(distance(eye, P) + {k}, 1e-9)"),
        (Attenuation::Light, _) => format!("1.0 / max(d + {k}, 1e-9)"),
        (Attenuation::InverseSquare, _) => "1.0 / (d * d)".to_owned(),
        (Attenuation::Quadratic, _) => {
            format!("min(1.0, 1.0 / max({c1} + {c2} * d + {c3} * d * d, 1e-9))")
        }
        (Attenuation::None, None) => "1.0".to_owned(),
    };
    let (cone, factor) = if emitter.light.kind == LightKind::Spot {
        (cone(emitter), "f * spot * Ip")
    } else {
        (String::new(), "f * Ip")
    };
    format!("    float f = {f};\n{cone}    {verb} reflected(N, L, V, {d}color, {factor});\n")
}

/// Writes `(−L·D)^e` inside the cone, 0 outside.
fn cone(emitter: &Emitter<'_>) -> String {
    let light = emitter.light;
    let gap = |degrees: f64| 2.0 * (degrees.to_radians() * 0.5).sin().powi(2);
    let edge = gap(light.cone);
    let fade = edge - gap(light.cone * (1.0 - light.softness));
    let edge = float(edge);
    let soft = if light.softness > 0.0 {
        format!("smoothstep(0.0, 1.0, ({edge} - gap) / {})", float(fade))
    } else {
        format!("step(gap, {edge})")
    };
    filled(
        include_str!("glsl/cone.glsl"),
        &[
            ("axis", &vec3(emitter.axis())),
            ("cone", &said(light.cone)),
            ("exponent", &float(light.exponent)),
            ("soft", &soft),
        ],
    )
}

/// The stage that evaluates the s0 of depth cueing.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Cue {
    None,
    /// The vertex shader, which applies it to the intensity.
    Intensity,
    /// The vertex shader, which passes it on separately.
    Carried,
    /// The fragment shader.
    Fragment,
}

impl Cue {
    fn of(scene: &Scene) -> Self {
        let cueing = &scene.depth_cueing;
        match (cueing.by, scene.shading.mode) {
            _ if [cueing.front_scale, cueing.back_scale] == [1.0; 2] => Self::None,
            (CuedBy::Off, _) => Self::None,
            (CuedBy::Pixel, _) | (_, ShadingMode::Exact) => Self::Fragment,
            (CuedBy::Vertex, ShadingMode::Phong) => Self::Carried,
            (CuedBy::Vertex, _) => Self::Intensity,
        }
    }

    /// Returns the declarations of the vertex and the fragment shader for `s0·I + (1 − s0)·Idc`.
    fn declared(self, scene: &Scene) -> [String; 2] {
        let cueing = &scene.depth_cueing;
        let view = View::new(&scene.camera, scene.image.size);
        let row = DVec4::from((view.forward, -view.forward.dot(view.eye)))
            .to_array()
            .map(float)
            .join(", ");
        let depth = filled(include_str!("glsl/depth.glsl"), &[("row", &row)]);
        let [back, extent] = [cueing.back, cueing.back - cueing.front].map(float);
        let [front_scale, back_scale] = [cueing.front_scale, cueing.back_scale].map(float);
        let values: [(&str, &str); 4] = [
            ("back", &back),
            ("extent", &extent),
            ("front_scale", &front_scale),
            ("back_scale", &back_scale),
        ];
        let law = filled(include_str!("glsl/law.glsl"), &values);
        let fade = filled(
            include_str!("glsl/fade.glsl"),
            &[("color", &vec3(cueing.color))],
        );
        match self {
            Self::None => [String::new(), String::new()],
            Self::Intensity => [depth + &law + &fade, String::new()],
            Self::Carried => [depth + &law, fade],
            Self::Fragment => [depth, law + &fade],
        }
    }
}

fn per_pixel(scene: &Scene) -> bool {
    matches!(scene.shading.mode, ShadingMode::Phong | ShadingMode::Exact)
}

/// Returns the interpolation qualifier of the values passed from the vertices to the pixels.
fn qualifier(scene: &Scene) -> &'static str {
    match (scene.shading.mode, scene.shading.interpolation) {
        (ShadingMode::Flat, _) => "flat ",
        (ShadingMode::Exact, _) => "",
        (_, Interpolation::Affine) => "noperspective ",
        _ => "",
    }
}

fn vertex(scene: &Scene, equation: &str) -> String {
    let (how, cue) = (qualifier(scene), Cue::of(scene));
    let here = "dot(depth_from_world, vec4(vertex_position, 1.0))";
    let (mut carried, mut given) = if per_pixel(scene) {
        let carried = format!("out vec3 position;\n{how}out vec3 normal;");
        (
            carried,
            "position = vertex_position;\n    normal = vertex_normal;".to_owned(),
        )
    } else {
        (
            format!("{how}out vec3 intensity;"),
            "intensity = illuminate(vertex_position, vertex_normal);".to_owned(),
        )
    };
    match cue {
        Cue::None => {}
        Cue::Intensity => {
            given = format!(
                "intensity = fade(illuminate(vertex_position, vertex_normal), s0_at({here}));"
            );
        }
        Cue::Carried => {
            carried += &format!("\n{how}out float s0;");
            given += &format!("\n    s0 = s0_at({here});");
        }
        Cue::Fragment => {
            carried += "\nout float depth;";
            given += &format!("\n    depth = {here};");
        }
    }
    let [cueing, _] = cue.declared(scene);
    let declared = format!("{equation}{cueing}");
    let clip = clip_from_world(&scene.camera, scene.image.size, &scene.object);
    let column = |v: DVec4| format!("    {}", v.to_array().map(float).join(", "));
    let columns = [clip.x_axis, clip.y_axis, clip.z_axis, clip.w_axis]
        .map(column)
        .join(",\n");
    let values: [(&str, &str); 4] = [
        ("clip_from_world", &columns),
        ("declared", &declared),
        ("carried", &carried),
        ("given", &given),
    ];
    filled(include_str!("glsl/vertex.glsl"), &values)
}

fn fragment(scene: &Scene, equation: &str) -> String {
    let (how, cue) = (qualifier(scene), Cue::of(scene));
    let renormalise = scene.shading.renormalise || scene.shading.mode == ShadingMode::Exact;
    let normal = if renormalise {
        "normalize(normal)"
    } else {
        "normal"
    };
    let (mut carried, mut intensity) = if per_pixel(scene) {
        (
            format!("in vec3 position;\n{how}in vec3 normal;"),
            format!("illuminate(position, {normal})"),
        )
    } else {
        (format!("{how}in vec3 intensity;"), "intensity".to_owned())
    };
    match cue {
        Cue::None | Cue::Intensity => {}
        Cue::Carried => {
            carried += &format!("\n{how}in float s0;");
            intensity = format!("fade({intensity}, s0)");
        }
        Cue::Fragment => {
            carried += "\nin float depth;";
            intensity = format!("fade({intensity}, s0_at(depth))");
        }
    }
    let [_, cueing] = cue.declared(scene);
    let declared = format!("{equation}{cueing}");
    let height = float(f64::from(scene.image.size[1]));
    let mark = match scene.display.overflow {
        Overflow::Mark => filled(include_str!("glsl/mark.glsl"), &[("height", &height)]),
        _ => String::new(),
    };
    let (means, encode) = match scene.display.encoding {
        Encoding::Raw => (
            "the framebuffer stores 255*I, rounded",
            "    return clamp(I, 0.0, 1.0);",
        ),
        Encoding::Srgb => (
            "the transfer function of IEC 61966-2-1",
            include_str!("glsl/srgb.glsl"),
        ),
    };
    let values: [(&str, &str); 6] = [
        ("declared", &declared),
        ("carried", &carried),
        ("means", means),
        ("mark", &mark),
        ("encode", encode),
        ("intensity", &intensity),
    ];
    filled(include_str!("glsl/fragment.glsl"), &values)
}

fn clip_from_world(camera: &Camera, size: [u32; 2], object: &Object) -> DMat4 {
    let view = View::new(camera, size);
    let [width, height] = size.map(|side| f64::from(side.max(1)));
    let (x, y) = (2.0 * view.scale / width, 2.0 * view.scale / height);
    let [near, far] = planes(camera, &view, object);
    let span = far - near;
    let eye_from_world = DMat4::from_cols(
        DVec4::new(view.right.x, view.up.x, -view.forward.x, 0.0),
        DVec4::new(view.right.y, view.up.y, -view.forward.y, 0.0),
        DVec4::new(view.right.z, view.up.z, -view.forward.z, 0.0),
        DVec4::new(
            -view.right.dot(view.eye),
            -view.up.dot(view.eye),
            view.forward.dot(view.eye),
            1.0,
        ),
    );
    let (third, fourth) = match view.projection {
        Projection::Perspective => (
            DVec4::new(0.0, 0.0, -(far + near) / span, -1.0),
            DVec4::new(0.0, 0.0, -2.0 * far * near / span, 0.0),
        ),
        Projection::Orthographic => (
            DVec4::new(0.0, 0.0, -2.0 / span, 0.0),
            DVec4::new(0.0, 0.0, -(far + near) / span, 1.0),
        ),
    };
    DMat4::from_cols(DVec4::X * x, DVec4::Y * y, third, fourth) * eye_from_world
}

/// Returns the drawn depths: those of the unit sphere, of the scene's polygons, or of the largest possible model.
fn planes(camera: &Camera, view: &View, object: &Object) -> [f64; 2] {
    let unit = camera.distance();
    let (nearest, farthest) = (NEAR * unit, unit / NEAR);
    if object.kind == ObjectKind::Obj && !object.fit {
        return [nearest, farthest];
    }
    let reach = match object.kind {
        ObjectKind::Polygons => {
            object
                .polygons()
                .vertices
                .iter()
                .map(|vertex| vertex.length())
                .fold(0.0, f64::max)
                * MARGIN
        }
        _ => SHAPES,
    };
    let middle = -view.eye.dot(view.forward);
    let near = (middle - reach).max(nearest);
    [near, (middle + reach).max(2.0 * near)]
}
