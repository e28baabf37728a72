//! `set_up_lights()`: `glLight*` and `glLightModel*`.

use super::super::number::{c_float, c_four, c_three};
use super::lamps::{Lamp, MOST, lamps};
use crate::geometry::VertexMesh;
use crate::scene::{Backfacing, Scene, Viewer};

pub(super) fn text(scene: &Scene, mesh: &VertexMesh) -> String {
    let lamps = lamps(scene, mesh);
    let shown = &lamps[..lamps.len().min(MOST)];
    let blocks: String = shown.iter().enumerate().map(|(i, lamp)| block(i, lamp)).collect();
    let black = if shown.is_empty() { "" } else { "    const GLfloat black[] = {0.0f, 0.0f, 0.0f, 1.0f};\n" };
    format!(
        "/* To be called after set_up_camera(): places are taken as seen through the modelview matrix of the moment. */
void set_up_lights(void) {{
{black}    const GLfloat ambient[] = {{{}}}; /* Ia */

    glEnable(GL_LIGHTING);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
{}{blocks}}}
",
        c_four(scene.ambient.color, 1.0),
        model(scene)
    )
}

fn model(scene: &Scene) -> String {
    let (local, viewer) = match scene.camera.viewer {
        Viewer::Local => ("GL_TRUE", "V points to the eye, from each point"),
        Viewer::Infinite => ("GL_FALSE", "V is constant: the viewer is at infinity"),
    };
    let (two_sided, sides) = match scene.reflection.backfacing {
        Backfacing::Clamp => ("GL_FALSE", "N.L < 0 counts as 0"),
        Backfacing::Flip => ("GL_TRUE", "N is turned on polygons seen from behind"),
    };
    format!(
        "    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, {local}); /* {viewer} */
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, {two_sided}); /* {sides} */
"
    )
}

fn block(index: usize, lamp: &Lamp) -> String {
    let light = format!("GL_LIGHT{index}");
    let (w, l) = if lamp.parallel {
        (0.0, "w = 0: L, the same everywhere")
    } else {
        (1.0, "w = 1: L = (place - P)/d, d = |place - P|")
    };
    let calls = format!("{}{}", falloff(&light, lamp), spot(&light, lamp));
    let axis = lamp.spot.as_ref().map_or(String::new(), |spot| {
        format!("        const GLfloat axis[] = {{{}}}; /* D, along the cone */\n", c_three(spot.axis))
    });
    format!(
        "
    {{
        /* {}. */
        const GLfloat place[] = {{{}}}; /* {l} */
        const GLfloat intensity[] = {{{}}}; /* Ip */
{axis}
        glLightfv({light}, GL_POSITION, place);
        glLightfv({light}, GL_AMBIENT, black); /* all of Ia is in the light model */
        glLightfv({light}, GL_DIFFUSE, intensity); /* Ip of Ip*Kd*Od*(N.L) */
        glLightfv({light}, GL_SPECULAR, intensity); /* Ip of Ip*Ks*Os*(N.H)^n */
{calls}        glEnable({light});
    }}
",
        lamp.title,
        c_four(lamp.place, w),
        c_four(lamp.color, 1.0),
    )
}

fn falloff(light: &str, lamp: &Lamp) -> String {
    let [c1, c2, c3] = lamp.attenuation.map(c_float);
    let means = if lamp.parallel { "f: none at infinity" } else { "c1 of f = 1/(c1 + c2*d + c3*d^2)" };
    format!(
        "        glLightf({light}, GL_CONSTANT_ATTENUATION, {c1}); /* {means} */
        glLightf({light}, GL_LINEAR_ATTENUATION, {c2}); /* c2 */
        glLightf({light}, GL_QUADRATIC_ATTENUATION, {c3}); /* c3 */
"
    )
}

fn spot(light: &str, lamp: &Lamp) -> String {
    let Some(spot) = &lamp.spot else {
        return format!("        glLightf({light}, GL_SPOT_CUTOFF, 180.0f); /* it shines in all directions */\n");
    };
    let (cone, exponent) = (c_float(spot.cone), c_float(spot.exponent));
    format!(
        "        glLightfv({light}, GL_SPOT_DIRECTION, axis);
        glLightf({light}, GL_SPOT_CUTOFF, {cone}); /* degrees from D to the edge; nothing outside */
        glLightf({light}, GL_SPOT_EXPONENT, {exponent}); /* e of (-L.D)^e, which multiplies f */
"
    )
}
