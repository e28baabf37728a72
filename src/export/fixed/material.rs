//! `set_up_material()`: `glMaterial*`, and how polygons are shaded and which of them are drawn.

use super::super::number::{c_float, c_four, said};
use crate::geometry::VertexMesh;
use crate::illumination::{Index, SpecularForm, blinn_from_phong};
use crate::scene::{Backfacing, Material, ReflectionModel, Rgb, Scene, ShadingMode};

/// The greatest `GL_SHININESS`.
pub(in super::super) const GREATEST_EXPONENT: f64 = 128.0;

pub(super) fn text(scene: &Scene, mesh: &VertexMesh) -> String {
    let material = &scene.material;
    let n = c_float(exponent(scene).min(GREATEST_EXPONENT));
    let specular = specular(scene);
    let reflectance = Index::of(material).map_or("", |_| ", times W at normal incidence");
    let (ambient, diffuse) = (material.ka * material.color, material.kd * material.color);
    format!(
        "void set_up_material(void) {{
    const GLfloat ambient[] = {{{}}}; /* Ka*Od */
    const GLfloat diffuse[] = {{{}}}; /* Kd*Od */
    const GLfloat specular[] = {{{}}}; /* Ks*Os{reflectance} */
    const GLfloat black[] = {{0.0f, 0.0f, 0.0f, 1.0f}};

    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, {n}); /* {} */
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, black); /* it does not shine by itself */
{}}}
",
        c_four(ambient, 1.0),
        c_four(diffuse, 1.0),
        c_four(specular, 1.0),
        exponent_means(scene),
        polygons(scene, mesh)
    )
}

/// The n of `(N·H)^n` that comes nearest to the scene's highlight.
pub(in super::super) fn exponent(scene: &Scene) -> f64 {
    let material = &scene.material;
    match scene.reflection.model {
        ReflectionModel::Blinn => material.n,
        ReflectionModel::Phong => blinn_from_phong(material.n),
        // The inverse of m = √(2/(n + 2)).
        ReflectionModel::CookTorrance => (2.0 / (material.roughness * material.roughness) - 2.0).max(0.0),
    }
}

fn exponent_means(scene: &Scene) -> String {
    match scene.reflection.model {
        _ if SpecularForm::of(scene) == SpecularForm::None => "n, of no effect: no specular light".to_owned(),
        ReflectionModel::Blinn => "n of (N.H)^n".to_owned(),
        ReflectionModel::Phong => format!("as wide as (R.V)^n with n = {}, up to 128", said(scene.material.n)),
        ReflectionModel::CookTorrance => format!("as wide as roughness {}, up to 128", said(scene.material.roughness)),
    }
}

fn specular(scene: &Scene) -> Rgb {
    let Material { ks, specular_color, .. } = scene.material;
    let head_on = Index::of(&scene.material).map_or(Rgb::ONE, |index| index.reflectance(1.0));
    ks * specular_color * head_on
}

fn polygons(scene: &Scene, mesh: &VertexMesh) -> String {
    let (model, means) = match scene.shading.mode {
        ShadingMode::Flat => ("GL_FLAT", "the shade of each triangle's last vertex"),
        ShadingMode::Interpolated => ("GL_SMOOTH", "intensities interpolated, between vertices with the polygon's N"),
        _ => ("GL_SMOOTH", "Gouraud's: intensities interpolated between vertices"),
    };
    let eye_outside = (scene.camera.eye - mesh.origin).length() > mesh.radius() * 1.01;
    let culling = if mesh.closed && eye_outside {
        "    glCullFace(GL_BACK);\n    glEnable(GL_CULL_FACE); /* a closed solid hides its back faces */\n"
    } else {
        "    glDisable(GL_CULL_FACE); /* it can be seen from behind */\n"
    };
    let front = match scene.reflection.backfacing {
        Backfacing::Clamp => "counter-clockwise polygons are seen from outside",
        Backfacing::Flip => "clockwise polygons are seen from behind: there N is turned",
    };
    format!(
        "    glShadeModel({model}); /* {means} */
    glFrontFace(GL_CCW); /* {front} */
{culling}    glEnable(GL_DEPTH_TEST);
"
    )
}
