//! What of a scene the exported code does not express.

use super::emitter::{Emitter, Place, emitters};
use super::fixed::material::{GREATEST_EXPONENT, exponent};
use super::fixed::{fog, lamps};
use super::holding;
use super::number::said;
use crate::geometry::VertexMesh;
use crate::illumination::{Index, SpecularForm};
use crate::scene::{
    AmbientSource, Attenuation, Backfacing, Encoding, FlatAt, Interpolation, LightKind, Overflow, PatternKind,
    Projection, ReflectionModel, Scene, ShadingMode, Viewer,
};

/// What a program that sets up the lights has to add by itself.
pub(super) const VERTEX_CLAMP: &str = "Intensities above 1 at vertices: OpenGL clamps them before interpolating, unless \
    the program calls glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE) (OpenGL 3.0, compatibility profile).";

/// Between this and its inverse, squares of lengths and products of a few of them stay within single precision.
const GREATEST_LENGTH: f64 = 1e9;

/// What neither the calls nor the shaders do: mostly what needs more than one surface at a time.
fn surroundings(scene: &Scene) -> Vec<String> {
    let unit = scene.camera.distance();
    let measured = (1.0 / GREATEST_LENGTH..GREATEST_LENGTH).contains(&unit);
    let shining = scene.lights.iter().any(|light| light.shines(scene.soloing()));
    holding([
        (scene.shading.shadows && shining, "Shadows: every light reaches every point."),
        (scene.transparency.kt > 0.0, "Transparency (Kt): the surface is drawn opaque."),
        (scene.ground.visible, "The ground: only the object is drawn."),
        (
            scene.backdrop.pattern != PatternKind::None,
            "The backdrop: only the background's colour is behind the object.",
        ),
        (scene.ambient.source != AmbientSource::Constant, "Light that other surfaces have scattered: Ia is constant."),
        (!measured, "Lengths of this size: OpenGL squares them in single precision. Scale the scene."),
    ])
}

/// What fixed-function OpenGL cannot say.
pub(super) fn fixed_function(scene: &Scene, mesh: &VertexMesh) -> Vec<String> {
    let mut limits = surroundings(scene);
    limits.extend(fixed_shading(scene));
    limits.extend(fixed_reflection(scene));
    limits.extend(fixed_lights(scene, mesh));
    limits.extend(fog::limits(scene, mesh));
    limits.extend(fixed_display(scene));
    limits
}

fn fixed_shading(scene: &Scene) -> Option<String> {
    let shading = &scene.shading;
    let flat_for_all = constant_over_a_face(scene);
    let text = match shading.mode {
        ShadingMode::Phong => {
            "Phong shading: the equation is evaluated at vertices only and the intensity interpolated (Gouraud shading). \
             A finer mesh comes nearer."
        }
        ShadingMode::Exact => {
            "Exact shading: the polygons are drawn, outline included, with the equation evaluated at vertices only."
        }
        ShadingMode::Flat => return flat(scene.shading.flat_at, flat_for_all),
        ShadingMode::Interpolated | ShadingMode::Gouraud => return interpolation(scene, false),
    };
    Some(text.to_owned())
}

fn flat(at: FlatAt, constant: bool) -> Option<String> {
    let text = match at {
        FlatAt::ProvokingVertex => return None,
        FlatAt::Centre if constant => {
            "Flat shading with the polygon's own N: GL_FLAT takes the shade of one vertex, with that vertex's N. Vertex \
             normals of the facets (object.normals = \"facet\") make them agree."
        }
        FlatAt::Centre => {
            "Flat shading at the polygon's centre: GL_FLAT takes the shade of one vertex, here the polygon's first."
        }
        FlatAt::VertexMean => {
            "Flat shading by the mean of the vertices' shades: GL_FLAT takes the shade of one, here the polygon's first."
        }
    };
    Some(text.to_owned())
}

/// L and V do not vary, so that a polygon with one normal has one shade.
fn constant_over_a_face(scene: &Scene) -> bool {
    let parallel = emitters(scene).iter().all(|emitter| matches!(emitter.place, Place::Towards(_)));
    parallel && (scene.camera.viewer == Viewer::Infinite || SpecularForm::of(scene) == SpecularForm::None)
}

/// `affine` says whether the target can interpolate in the picture.
fn interpolation(scene: &Scene, affine: bool) -> Option<String> {
    match scene.shading.interpolation {
        Interpolation::Affine if !affine && scene.camera.projection == Projection::Perspective => {
            Some("Affine interpolation: OpenGL's is perspective-correct.".to_owned())
        }
        Interpolation::Scanline => {
            Some("Interpolation along scan lines: polygons are drawn as triangles, interpolated as such.".to_owned())
        }
        _ => None,
    }
}

fn fixed_reflection(scene: &Scene) -> Vec<String> {
    let mut limits = if SpecularForm::of(scene) == SpecularForm::None { Vec::new() } else { fixed_specular(scene) };
    limits.extend(holding([
        (
            scene.pattern.kind != PatternKind::None,
            "The pattern on the surface: Od is the material's colour everywhere.",
        ),
        (
            scene.reflection.backfacing == Backfacing::Flip,
            "backfacing = \"flip\" turns N towards each light wherever N.L < 0; GL_LIGHT_MODEL_TWO_SIDE turns it on \
             polygons seen from behind, whatever the light. They agree where light and eye are on the same side.",
        ),
    ]));
    limits
}

fn fixed_specular(scene: &Scene) -> Vec<String> {
    let n = exponent(scene);
    let model = match scene.reflection.model {
        ReflectionModel::Blinn => None,
        ReflectionModel::Phong => Some(format!(
            "Phong's (R.V)^n: fixed-function lighting has Blinn's (N.H)^n (reflection.model = \"blinn\"); n = {} gives a \
             highlight as wide as n = {} does for Phong.",
            said(n),
            said(scene.material.n)
        )),
        ReflectionModel::CookTorrance => Some(format!(
            "Cook and Torrance's microfacets: Blinn's (N.H)^n stands for them, its n = {} from the roughness.",
            said(n)
        )),
    };
    let mut limits: Vec<String> = model.into_iter().collect();
    if n > GREATEST_EXPONENT {
        limits.push(format!("n = {}: GL_SHININESS goes up to 128.", said(n)));
    }
    if Index::of(&scene.material).is_some() {
        limits
            .push("W(theta), the reflectance by angle of incidence: its value at 0 degrees multiplies Ks.".to_owned());
    }
    limits
}

fn fixed_lights(scene: &Scene, mesh: &VertexMesh) -> Vec<String> {
    let emitters = emitters(scene);
    let whole = lamps::fits(&emitters);
    let mut limits: Vec<_> = emitters.iter().flat_map(|emitter| fixed_light(emitter, mesh, whole)).collect();
    if emitters.len() > lamps::MOST {
        limits.push(format!("Lights beyond the eighth: {} shine, OpenGL has {}.", emitters.len(), lamps::MOST));
    }
    limits
}

fn fixed_light(emitter: &Emitter<'_>, mesh: &VertexMesh, whole: bool) -> Vec<String> {
    let light = emitter.light;
    let at = |text: &str| format!("Light {}: {text}", emitter.index);
    let mut limits = Vec::new();
    if let (LightKind::Area, Place::Among(points)) = (light.kind, &emitter.place)
        && !whole
    {
        limits.push(at(&format!("an area of {} points, drawn as the one in its middle.", points.len())));
    }
    if light.kind == LightKind::Spot && light.softness > 0.0 {
        limits.push(at("the soft edge of its cone; GL_SPOT_CUTOFF is a hard one."));
    }
    if light.kind == LightKind::Spot && light.exponent > 128.0 {
        limits.push(at(&format!("its exponent {}; GL_SPOT_EXPONENT goes up to 128.", said(light.exponent))));
    }
    if light.attenuation == Attenuation::Viewer {
        limits.push(at("attenuation by the distance to the viewer; that of the camera's target stands for all."));
    }
    let unclamped = match (light.attenuation, emitter.constant, &emitter.place) {
        (Attenuation::Quadratic, None, Place::At(place)) => {
            let sides = lamps::reaches(light, *place, mesh);
            sides.inside && sides.outside
        }
        (Attenuation::Quadratic, None, Place::Among(_)) => light.c1 < 1.0,
        _ => false,
    };
    if unclamped {
        limits.push(at("f = min(1, ...) of its attenuation; OpenGL's f exceeds 1 near the light."));
    }
    limits
}

fn fixed_display(scene: &Scene) -> Vec<String> {
    holding([
        (scene.display.overflow == Overflow::Scale, SCALE),
        (scene.display.overflow == Overflow::Mark, "The hatching where I > 1: I is clamped."),
        (scene.display.encoding == Encoding::Srgb, "The sRGB encoding: stored values are 255*I."),
    ])
}

const SCALE: &str =
    "The division by the picture's greatest intensity, which nothing knows before all is drawn: I is clamped.";

/// What the pair of shaders does not say.
pub(super) fn shaders(scene: &Scene) -> Vec<String> {
    let mut limits = surroundings(scene);
    match scene.shading.mode {
        ShadingMode::Exact if scene.object.kind.has_surface() => limits.push(
            "Exact shading: each pixel of the polygons is shaded with its interpolated N (Phong shading); the outline is \
             theirs."
                .to_owned(),
        ),
        ShadingMode::Exact => {}
        ShadingMode::Flat => limits.extend(flat(scene.shading.flat_at, constant_over_a_face(scene))),
        _ => limits.extend(interpolation(scene, true)),
    }
    if scene.display.overflow == Overflow::Scale {
        limits.push(SCALE.to_owned());
    }
    limits
}
