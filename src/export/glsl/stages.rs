//! What the two stages read, hand on and write.

use super::super::number::{float, said};
use super::cue::Cue;
use crate::scene::{
    Camera, Encoding, Interpolation, NormalSource, Object, ObjectKind, Overflow, Projection, Scene, ShadingMode, View,
};
use glam::{DMat4, DVec4};

/// Radius about the origin that holds every built-in shape: √2 for the corners of the plane, a little more for rounding.
const SHAPES: f64 = 1.42;

/// Room before the nearest and behind the farthest of a scene's own polygons.
const MARGIN: f64 = 1.01;

/// What is nearer than this many camera distances is not drawn, nor what is farther than its inverse.
const NEAR: f64 = 1e-3;

/// What the program around the shaders has to do.
pub(super) fn host(scene: &Scene) -> String {
    let normals = match (scene.shading.mode, scene.object.normals) {
        (ShadingMode::Interpolated, _) | (_, NormalSource::Facet) => "each polygon's own, so that no vertex is shared",
        (_, NormalSource::Averaged) => "the mean of the polygons' at the vertex",
        (_, NormalSource::Exact) => "the true surface's",
        (_, NormalSource::File) => "the file's",
    };
    let provoking = match scene.shading.mode {
        ShadingMode::Flat => " glProvokingVertex(GL_FIRST_VERTEX_CONVENTION) takes the shade of the first vertex.",
        _ => "",
    };
    let background = scene.image.background.to_array().map(|v| said(encoded(v, scene.display.encoding))).join(", ");
    let [width, height] = scene.image.size;
    format!(
        "The program around them gives positions and unit normals ({normals}), enables GL_DEPTH_TEST and clears a picture \
         of {width}x{height} pixels to ({background}).{provoking}"
    )
}

/// What the display makes of a linear intensity, 0 to 1.
fn encoded(v: f64, encoding: Encoding) -> f64 {
    let v = v.clamp(0.0, 1.0);
    match encoding {
        Encoding::Srgb if v > 0.003_130_8 => 1.055 * v.powf(1.0 / 2.4) - 0.055,
        Encoding::Srgb => 12.92 * v,
        Encoding::Raw => v,
    }
}

/// What the vertex shader reads.
pub(super) fn inputs(scene: &Scene) -> String {
    let clip = clip_from_world(&scene.camera, scene.image.size, &scene.object);
    let column = |v: DVec4| format!("    {}", v.to_array().map(float).join(", "));
    let columns = [clip.x_axis, clip.y_axis, clip.z_axis, clip.w_axis].map(column).join(",\n");
    format!(
        "layout(location = 0) in vec3 vertex_position; // world
layout(location = 1) in vec3 vertex_normal; // N, unit, world

// The camera, by columns: another picture's width and height, or another camera, is set from outside.
uniform mat4 clip_from_world = mat4(
{columns}
);

"
    )
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
        DVec4::new(-view.right.dot(view.eye), -view.up.dot(view.eye), view.forward.dot(view.eye), 1.0),
    );
    let (third, fourth) = match view.projection {
        Projection::Perspective => {
            (DVec4::new(0.0, 0.0, -(far + near) / span, -1.0), DVec4::new(0.0, 0.0, -2.0 * far * near / span, 0.0))
        }
        Projection::Orthographic => {
            (DVec4::new(0.0, 0.0, -2.0 / span, 0.0), DVec4::new(0.0, 0.0, -(far + near) / span, 1.0))
        }
    };
    DMat4::from_cols(DVec4::X * x, DVec4::Y * y, third, fourth) * eye_from_world
}

/// The depths that are drawn: those of the unit sphere, of the scene's polygons, or of all that a model may be.
fn planes(camera: &Camera, view: &View, object: &Object) -> [f64; 2] {
    let unit = camera.distance();
    let (nearest, farthest) = (NEAR * unit, unit / NEAR);
    if object.kind == ObjectKind::Obj && !object.fit {
        return [nearest, farthest];
    }
    let reach = match object.kind {
        ObjectKind::Polygons => {
            object.polygons().vertices.iter().map(|vertex| vertex.length()).fold(0.0, f64::max) * MARGIN
        }
        _ => SHAPES,
    };
    let middle = -view.eye.dot(view.forward);
    let near = (middle - reach).max(nearest);
    [near, (middle + reach).max(2.0 * near)]
}

pub(super) fn per_pixel(scene: &Scene) -> bool {
    matches!(scene.shading.mode, ShadingMode::Phong | ShadingMode::Exact)
}

/// How what the vertices carry comes to the pixels.
fn qualifier(scene: &Scene) -> &'static str {
    match (scene.shading.mode, scene.shading.interpolation) {
        (ShadingMode::Flat, _) => "flat ",
        (ShadingMode::Exact, _) => "",
        (_, Interpolation::Affine) => "noperspective ",
        _ => "",
    }
}

pub(super) fn vertex(scene: &Scene) -> String {
    let how = qualifier(scene);
    let cue = Cue::of(scene);
    let here = "dot(depth_from_world, vec4(vertex_position, 1.0))";
    let (mut carried, mut given) = if per_pixel(scene) {
        (
            format!("out vec3 position;\n{how}out vec3 normal;"),
            "position = vertex_position;\n    normal = vertex_normal;".to_owned(),
        )
    } else {
        (format!("{how}out vec3 intensity;"), "intensity = illuminate(vertex_position, vertex_normal);".to_owned())
    };
    match cue {
        Cue::None => {}
        Cue::Intensity => {
            given = format!("intensity = fade(illuminate(vertex_position, vertex_normal), s0_at({here}));");
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
    let declared = cue.in_vertex(scene);
    format!(
        "{declared}{carried}

void main() {{
    {given}
    gl_Position = clip_from_world * vec4(vertex_position, 1.0);
}}
"
    )
}

pub(super) fn fragment(scene: &Scene) -> String {
    let how = qualifier(scene);
    let renormalise = scene.shading.renormalise || scene.shading.mode == ShadingMode::Exact;
    let normal = if renormalise { "normalize(normal)" } else { "normal" };
    let (mut carried, mut intensity) = if per_pixel(scene) {
        (format!("in vec3 position;\n{how}in vec3 normal;"), format!("illuminate(position, {normal})"))
    } else {
        (format!("{how}in vec3 intensity;"), "intensity".to_owned())
    };
    let cue = Cue::of(scene);
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
    let declared = cue.in_fragment(scene);
    format!(
        "{declared}{carried}
out vec4 pixel;

{}void main() {{
    vec3 I = {intensity};
    pixel = vec4(display(I), 1.0);
}}
",
        display(scene)
    )
}

fn display(scene: &Scene) -> String {
    let mark = match scene.display.overflow {
        Overflow::Mark => {
            let height = float(f64::from(scene.image.size[1]));
            format!(
                "    // The picture's rows are counted from its top.
    float stripe = floor((floor(gl_FragCoord.x) + {height} - 1.0 - floor(gl_FragCoord.y)) / 3.0);
    if (any(greaterThan(I, vec3(1.0)))) return vec3(mod(stripe, 2.0));
"
            )
        }
        _ => String::new(),
    };
    let (what, encode) = match scene.display.encoding {
        Encoding::Raw => ("the framebuffer stores 255*I, rounded", "    return clamp(I, 0.0, 1.0);\n"),
        Encoding::Srgb => (
            "the transfer function of IEC 61966-2-1",
            "    vec3 v = clamp(I, 0.0, 1.0);
    vec3 high = 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055;
    return mix(high, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
",
        ),
    };
    format!("// From a linear intensity to what is stored: {what}.\nvec3 display(vec3 I) {{\n{mark}{encode}}}\n\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn a_point_appears_where_the_view_has_it() {
        let size = [640, 480];
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let camera = Camera { eye: DVec3::new(1.0, 2.0, 3.0), roll: 25.0, projection, ..Camera::default() };
            let clip = clip_from_world(&camera, size, &Object::default());
            let point = DVec3::new(0.3, -0.4, 0.5);
            let placed = clip * point.extend(1.0);
            let x = (placed.x / placed.w * 0.5 + 0.5) * 640.0;
            let y = (0.5 - placed.y / placed.w * 0.5) * 480.0;
            let (pixel, _) = View::new(&camera, size).project(point).expect("in front of the eye");
            assert!((pixel.x - x).abs() < 1e-9 && (pixel.y - y).abs() < 1e-9, "{projection:?}: {pixel} {x} {y}");
            assert!((placed.z / placed.w).abs() < 1.0);
        }
    }
}
