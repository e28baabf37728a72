//! Exported programs compile, run, and draw the same picture.

use super::mesa::{compare_c, compare_glsl, compile, folder, mesa, small, small_model, succeeded};
use super::{program, scene, snippet};
use crate::model_materials;
use shading_lab::export::{Limit, glsl_330_of_model};
use shading_lab::scene::ObjectKind;
use std::fs;

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
