//! Models that light passes in part: each face by its own Kt and η, in every mode, and what is seen behind it.

use crate::model_materials::{VARIANTS, cube, equal_to_each_alone, linear, scene};
use glam::{DVec2, DVec3};
use shading_lab::analysis::probe::probe;
use shading_lab::geometry::Mesh;
use shading_lab::render::Renderer;
use shading_lab::scene::{Choice, FaceMaterial, MaterialSource, Rgb, Scene, ShadingMode, View};
use std::sync::Arc;

/// Returns the cube of six materials, three of which let light through: those on the sides of +x, +y and −z.
fn glass() -> Arc<Mesh> {
    let mut mesh = Mesh::clone(&cube());
    for (number, dissolve, ior) in [(0, 0.25, 1.5), (2, 0.6, 1.2), (5, 0.0, 1.1)] {
        let own = &mut mesh.materials[number];
        (own.dissolve, own.ior) = (Some(dissolve), Some(ior));
    }
    Arc::new(mesh)
}

#[test]
fn a_cube_of_glass_and_other_materials_is_each_of_them_alone_to_the_bit() {
    // Refracted once, a ray does not meet the object again.
    let mesh = glass();
    for (index, variant) in VARIANTS.iter().enumerate() {
        for mode in ShadingMode::VALUES {
            let mut scene = scene(variant);
            scene = scene
                .with_overrides(&["transparency.through=surface", "backdrop.pattern=stripes"])
                .expect("sound overrides");
            scene.shading.mode = *mode;
            if index % 2 == 1 {
                scene.camera.eye = DVec3::new(2.6, 1.5, -2.4);
                scene.ground.height = -3.0;
            }
            let what = format!("{mode:?} {variant:?}");
            equal_to_each_alone(&mesh, &scene, Renderer::default, &what);
        }
    }
}

#[test]
fn faces_without_a_material_are_as_transparent_as_the_scene() {
    let mut mesh = Mesh::clone(&glass());
    for own in &mut mesh.face_materials {
        if *own == 4 {
            *own = shading_lab::geometry::NO_MATERIAL;
        }
    }
    let mut shown = scene(&["transparency.kt=0.5", "ground.visible=true"]);
    shown.camera.eye = DVec3::new(1.0, 1.0, 3.5);
    let kt = |scene: &Scene, name: &str| {
        let mut renderer = Renderer::default().with_model(Some(Arc::new(mesh.clone())));
        let [width, height] = scene.image.size;
        let pixels = (0..width * height).map(|pixel| [pixel % width, pixel / width]);
        let hits = pixels.filter_map(|[x, y]| probe(&mut renderer, scene, x, y).hit);
        let mut of = hits.filter(|hit| {
            let own = hit.material.as_ref().map(|own| own.name.as_str());
            own.unwrap_or_default() == name
        });
        let hit = of.next().expect("a pixel shows it");
        assert_eq!(
            hit.transmission.is_some(),
            hit.scene_of(scene).transparency.kt > 0.0
        );
        hit.scene_of(scene).transparency.kt
    };
    assert_eq!(
        [kt(&shown, ""), kt(&shown, "red"), kt(&shown, "blue")],
        [0.5, 0.75, 0.4]
    );
    let changed = shown
        .with_override(
            "object.material=[{name=\"red\", kt=0.1, relative_ior=1.9}, {name=\"blue\", kt=0}]",
        )
        .expect("a sound override");
    assert_eq!(
        [kt(&changed, ""), kt(&changed, "red"), kt(&changed, "blue")],
        [0.5, 0.1, 0.0]
    );
    let refused = shown.with_override("object.material=[{name=\"red\", kt=1.5}]");
    assert!(refused.is_err_and(|error| error.to_string().contains("1.5")));
}

/// The cube's light followed through it, written anew: a box met by slabs, Snell's law in angles, Phong's equation of a
/// directional light.
struct Traced<'a> {
    scene: &'a Scene,
    materials: [FaceMaterial; 6],
    half: f64,
}

impl Traced<'_> {
    /// Returns the number of the side where a ray leaves or enters the box, and its distance.
    fn slabs(&self, from: DVec3, along: DVec3, inside: bool) -> Option<(usize, f64)> {
        let (mut enter, mut leave) = ((0, f64::NEG_INFINITY), (0, f64::INFINITY));
        for axis in 0..3 {
            if along[axis] == 0.0 {
                if from[axis].abs() > self.half {
                    return None;
                }
                continue;
            }
            let side = |sign: f64| (sign * self.half - from[axis]) / along[axis];
            let (near, far) = if along[axis] > 0.0 {
                (-1.0, 1.0)
            } else {
                (1.0, -1.0)
            };
            let number = |sign: f64| 2 * axis + usize::from(sign < 0.0);
            if side(near) > enter.1 {
                enter = (number(near), side(near));
            }
            if side(far) < leave.1 {
                leave = (number(far), side(far));
            }
        }
        if inside {
            return Some(leave);
        }
        (enter.1 <= leave.1 && enter.1 > 0.0).then_some(enter)
    }

    fn normal(side: usize) -> DVec3 {
        let sign = if side.is_multiple_of(2) { 1.0 } else { -1.0 };
        DVec3::AXES[side / 2] * sign
    }

    /// Returns Phong's equation on a side, seen from `v`.
    fn reflected(&self, side: usize, n: DVec3, v: DVec3) -> Rgb {
        let own = &self.materials[side].material;
        let light = &self.scene.lights[0];
        let l = -light.direction.normalize();
        let mut sum = own.ka * own.color * self.scene.ambient.color;
        if n.dot(l) > 0.0 {
            let r = 2.0 * n.dot(l) * n - l;
            let highlight = r.dot(v).max(0.0).powf(own.n);
            sum += light.color * (own.kd * own.color * n.dot(l) + own.ks * highlight);
        }
        sum
    }

    /// Returns the direction behind a surface whose normal faces the ray, by the angles of Snell's law; `None` for a total
    /// reflection.
    fn bent(along: DVec3, n: DVec3, eta: f64) -> Option<DVec3> {
        let incident = (-along.dot(n)).clamp(-1.0, 1.0).acos();
        let sine = incident.sin() / eta;
        if sine > 1.0 {
            return None;
        }
        let across = (along + n * incident.cos()).normalize_or_zero();
        let angle = sine.asin();
        Some(across * angle.sin() - n * angle.cos())
    }

    /// Returns the light from along a ray of the eye.
    fn seen(&self, eye: DVec3, mut along: DVec3) -> Option<Rgb> {
        let (mut side, distance) = self.slabs(eye, along, false)?;
        let mut at = eye + along * distance;
        let first = &self.materials[side];
        let mut sum = self.reflected(side, Self::normal(side), -along) * (1.0 - first.kt);
        let mut left = first.kt;
        if left == 0.0 {
            return Some(sum);
        }
        along = Self::bent(along, Self::normal(side), first.relative_ior)?;
        for _ in 0..15 {
            let (met, distance) = self.slabs(at, along, true)?;
            at += along * distance;
            let (own, n) = (&self.materials[met], Self::normal(met));
            if met != side {
                sum += self.reflected(met, -n, -along) * (left * (1.0 - own.kt));
                left *= own.kt;
                side = met;
            }
            if left == 0.0 {
                return Some(sum);
            }
            match Self::bent(along, -n, 1.0 / own.relative_ior) {
                Some(_) => return Some(sum + self.scene.image.background * left),
                None => along -= 2.0 * along.dot(n) * n,
            }
        }
        Some(sum)
    }
}

#[test]
fn what_is_behind_glass_is_seen_as_another_program_sees_it() {
    let mesh = glass();
    let half = f64::from(mesh.positions.iter().map(|p| p.x).fold(0.0, f32::max));
    let mut shown = scene(&[
        "light=[{kind=\"directional\", direction=[-1,-2,-1.5], color=[1,0.9,0.8]}]",
        "image.background=[0.2,0.3,0.5]",
        "object.normals=file",
        "image.size=[90,80]",
    ]);
    for eye in [
        DVec3::new(2.3, 1.9, 2.6),
        DVec3::new(2.6, 1.5, -2.4),
        DVec3::new(-0.4, 3.0, -2.0),
    ] {
        for mode in ShadingMode::VALUES {
            (shown.camera.eye, shown.shading.mode) = (eye, *mode);
            // One evaluation of a constant L and V a face: flat shading is exact with the viewer at infinity, whatever the mode.
            shown = shown
                .with_override("camera.viewer=infinite")
                .expect("sound");
            let mut renderer = Renderer::default().with_model(Some(Arc::clone(&mesh)));
            let (picture, _) = linear(&mut renderer, &shown);
            let materials = std::array::from_fn(|k| mesh.materials[k].face_material());
            let traced = Traced {
                scene: &shown,
                materials,
                half,
            };
            let view = View::new(&shown.camera, shown.image.size);
            let towards = (eye - shown.camera.target).normalize();
            let (mut compared, mut glassy) = (0, 0);
            for (pixel, value) in picture.iter().enumerate() {
                let place = DVec2::new((pixel % 90) as f64 + 0.5, (pixel / 90) as f64 + 0.5);
                let (origin, along) = view.ray(place);
                let Some((side, _)) = traced.slabs(origin, along, false) else {
                    continue;
                };
                // The surface itself is seen from the constant V; what is behind, along the ray.
                let own = traced.reflected(side, Traced::normal(side), towards);
                let along_ray = traced.reflected(side, Traced::normal(side), -along);
                let Some(expected) = traced.seen(origin, along) else {
                    continue;
                };
                let expected = expected + (own - along_ray) * (1.0 - traced.materials[side].kt);
                let found = value.map(|bits| f64::from(f32::from_bits(bits)));
                if found[3] == 0.0 {
                    continue;
                }
                let far = (0..3).any(|c| (found[c] - expected[c]).abs() > 1e-3);
                // Beside an edge, the ray may leave on either side of it.
                compared += usize::from(!far);
                glassy += usize::from(!far && traced.materials[side].kt > 0.0);
                let [x, y] = [pixel as u32 % 90, pixel as u32 / 90];
                let near_edge = || {
                    [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y]
                        .into_iter()
                        .any(|by| {
                            let (origin, along) = view.ray(place + by * 0.05);
                            let beside = traced.seen(origin, along);
                            beside.is_none_or(|beside| {
                                (beside
                                    - traced
                                        .seen(view.ray(place).0, view.ray(place).1)
                                        .unwrap_or_default())
                                .abs()
                                .max_element()
                                    > 1e-2
                            })
                        })
                };
                assert!(
                    !far || near_edge(),
                    "{mode:?} {x}, {y}: {found:?}, {expected}"
                );
                if pixel % 7 > 0 {
                    continue;
                }
                let hit = probe(&mut renderer, &shown, x, y).hit.expect("the cube");
                assert!(
                    (hit.sum - Rgb::new(found[0], found[1], found[2]))
                        .abs()
                        .max_element()
                        < 1e-3
                );
            }
            assert!(
                compared > 800 && glassy > 200,
                "{mode:?}: {compared}, {glassy}"
            );
        }
    }
}

#[test]
fn another_object_behind_glass_is_seen_and_one_of_the_same_material_is_passed() {
    // Two squares, one behind the other, that do not bend the light.
    let square = |z: f64| format!("v -1 -1 {z}\nv 1 -1 {z}\nv 1 1 {z}\nv -1 1 {z}\n");
    let obj = format!(
        "mtllib a.mtl\n{}{}usemtl pane\nf 1 2 3 4\nusemtl wall\nf 5 6 7 8\n",
        square(0.5),
        square(-0.5)
    );
    let drawn = |mtl: &str, set: &[&str]| {
        let mesh =
            shading_lab::geometry::read_model(obj.as_bytes(), &mut |_| {}, &mut |_| Ok(mtl.into()));
        let mut shown = scene(set);
        shown.camera.eye = DVec3::new(0.0, 0.0, 4.0);
        shown.camera.target = DVec3::ZERO;
        let mut renderer = Renderer::default().with_model(Some(Arc::new(mesh.expect("a model"))));
        let (picture, _) = linear(&mut renderer, &shown);
        let [width, height] = shown.image.size;
        picture[(height / 2 * width + width / 2) as usize]
            .map(|bits| f64::from(f32::from_bits(bits)))
    };
    let light = "light=[{kind=\"directional\", direction=[0,0,-1]}]";
    let pane = "newmtl pane\nKa 0\nKd 0 0 1\nd 0.25\nillum 1\n";
    let wall = "newmtl wall\nKa 0\nKd 1 0 0\nillum 1\n";
    let near = |found: [f64; 4], expected: [f64; 3]| {
        let same = (0..3).all(|c| (found[c] - expected[c]).abs() < 1e-5);
        assert!(same, "{found:?}, not {expected:?}");
    };
    near(drawn(&format!("{pane}{wall}"), &[light]), [0.75, 0.0, 0.25]);
    // The pane's shadow falls on the wall, as that of whatever lets light through.
    near(
        drawn(&format!("{pane}{wall}"), &[light, "shading.shadows=true"]),
        [0.0, 0.0, 0.25],
    );
    // A wall of half its light lets the background through.
    let half = format!("{pane}{wall}d 0.5\n");
    near(
        drawn(&half, &[light, "image.background=[0,1,0]"]),
        [0.375, 0.375, 0.25],
    );
    // Behind a single surface there is nothing but the surroundings.
    near(
        drawn(
            &half,
            &[
                light,
                "image.background=[0,1,0]",
                "transparency.through=surface",
            ],
        ),
        [0.0, 0.75, 0.25],
    );
    // All of one material: the second surface adds nothing.
    let one = obj.replace("usemtl wall", "usemtl pane");
    assert!(one != obj);
    let mesh =
        shading_lab::geometry::read_model(one.as_bytes(), &mut |_| {}, &mut |_| Ok(pane.into()));
    let mut shown = scene(&[light, "image.background=[0,1,0]"]);
    (shown.camera.eye, shown.camera.target) = (DVec3::new(0.0, 0.0, 4.0), DVec3::ZERO);
    let mut renderer = Renderer::default().with_model(Some(Arc::new(mesh.expect("a model"))));
    let (own, _) = linear(&mut renderer, &shown);
    let mut alone = shown.clone();
    renderer_material(&mut alone, pane);
    let mut bare = Renderer::default().with_model(renderer_model(&one));
    assert!(own == linear(&mut bare, &alone).0);
}

/// Gives a scene the only material of a library for all faces.
fn renderer_material(scene: &mut Scene, mtl: &str) {
    let text = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl pane\nf 1 2 3\n";
    let mesh =
        shading_lab::geometry::read_model(text.as_bytes(), &mut |_| {}, &mut |_| Ok(mtl.into()));
    mesh.expect("a model").materials[0]
        .face_material()
        .replace_in(scene);
    scene.material.source = MaterialSource::Scene;
}

fn renderer_model(obj: &str) -> Option<Arc<Mesh>> {
    let mesh = shading_lab::geometry::read_obj(obj.as_bytes(), &mut |_| {});
    Some(Arc::new(mesh.expect("a model")))
}
