//! Scenes of ordinary, extreme and special numbers: no panic, and no intensity that is not a finite number.

use super::Renderer;
use crate::scene::{
    AmbientSource, AreaShape, Attenuation, Backfacing, CuedBy, DepthCueing, Distribution, FlatAt, Interpolation, Light,
    LightKind, NormalSource, ObjectKind, Overflow, PatternKind, Projection, Reflectance, ReflectionModel, Scene,
    ShadingMode, Shared, Through, Viewer, Weighting,
};
use glam::DVec3;
use proptest::prelude::*;

/// A number of either sign: everyday ones most of the time, the ends of the range sometimes.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -5.0..5.0f64,
        1 => Just(0.0),
        1 => prop_oneof![Just(1e-15), Just(1e-9), Just(1e9), Just(1e15), Just(1e30), Just(-1e30), Just(-1e-30)],
    ]
}

fn vector() -> impl Strategy<Value = DVec3> {
    (number(), number(), number()).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

fn exponent() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), Just(0.3), 1.0..2000.0f64, Just(1e6), Just(1e12), Just(f64::INFINITY)]
}

fn choice<T: Copy + std::fmt::Debug + 'static>(values: &'static [T]) -> impl Strategy<Value = T> {
    (0..values.len()).prop_map(move |i| values[i])
}

/// Parts of a whole.
const PARTS: &[f64] = &[0.0, 1e-9, 0.5, 1.0];

fn light() -> impl Strategy<Value = Light> {
    const KINDS: &[LightKind] = &[LightKind::Point, LightKind::Directional, LightKind::Spot, LightKind::Area];
    const SHAPES: &[AreaShape] = &[AreaShape::Rectangle, AreaShape::Sphere];
    const CONES: &[f64] = &[0.1, 1.0, 20.0, 60.0, 90.0];
    const ATTENUATIONS: &[Attenuation] = &[
        Attenuation::None,
        Attenuation::Viewer,
        Attenuation::Light,
        Attenuation::InverseSquare,
        Attenuation::Quadratic,
    ];
    let area = (choice(SHAPES), vector(), 1..6u32, choice(CONES), choice(PARTS), choice(PARTS));
    (choice(KINDS), vector(), vector(), vector(), choice(ATTENUATIONS), number(), vector(), area).prop_map(
        |(kind, position, direction, color, attenuation, k, c, (shape, size, samples, cone, softness, power))| {
            let ([c1, c2, c3], [width, height, radius]) = (c.abs().to_array(), size.abs().to_array());
            Light {
                kind,
                position,
                direction,
                color: color.abs(),
                cone,
                exponent: power * 1e3,
                softness,
                shape,
                extent: [width, height],
                radius,
                samples,
                attenuation,
                k: k.abs(),
                c1,
                c2,
                c3,
                ..Light::default()
            }
        },
    )
}

fn scene() -> impl Strategy<Value = Scene> {
    const KINDS: &[ObjectKind] = &[
        ObjectKind::Sphere,
        ObjectKind::Torus,
        ObjectKind::Cylinder,
        ObjectKind::Cone,
        ObjectKind::Cube,
        ObjectKind::Plane,
        ObjectKind::Corrugated,
        ObjectKind::Polygons,
    ];
    const MODES: &[ShadingMode] =
        &[ShadingMode::Flat, ShadingMode::Interpolated, ShadingMode::Gouraud, ShadingMode::Phong, ShadingMode::Exact];
    const PLACES: &[FlatAt] = &[FlatAt::Centre, FlatAt::VertexMean, FlatAt::ProvokingVertex];
    const RULES: &[Interpolation] = &[Interpolation::Perspective, Interpolation::Affine, Interpolation::Scanline];
    const NORMALS: &[NormalSource] = &[NormalSource::Averaged, NormalSource::Exact, NormalSource::Facet];
    const WEIGHTS: &[Weighting] = &[Weighting::Equal, Weighting::Area, Weighting::Angle];
    const CUES: &[CuedBy] = &[CuedBy::Off, CuedBy::Vertex, CuedBy::Pixel];
    const MODELS: &[ReflectionModel] = &[ReflectionModel::Phong, ReflectionModel::Blinn, ReflectionModel::CookTorrance];
    const DISTRIBUTIONS: &[Distribution] = &[Distribution::Beckmann, Distribution::Ggx];
    const LAWS: &[Reflectance] =
        &[Reflectance::Constant, Reflectance::Glass, Reflectance::Silver, Reflectance::Gold, Reflectance::Custom];
    const PATTERNS: &[PatternKind] =
        &[PatternKind::None, PatternKind::Checker, PatternKind::Stripes, PatternKind::Rings];
    const SOURCES: &[AmbientSource] =
        &[AmbientSource::Constant, AmbientSource::Constant, AmbientSource::Bounce, AmbientSource::Split];
    const INDICES: &[f64] = &[0.1, 0.7, 1.0, 1.5, 10.0];
    const ROUGHNESSES: &[f64] = &[1e-3, 0.02, 0.3, 1.0];
    let camera = (vector(), vector(), vector(), any::<bool>(), 1.0..170.0f64, number(), any::<bool>(), number());
    let corners = prop::collection::vec(vector(), 3..6);
    let object = (choice(KINDS), 3..9u32, 3..7u32, choice(NORMALS), choice(WEIGHTS), corners);
    let material = (vector(), vector(), vector(), exponent(), choice(MODELS), any::<bool>());
    let around = (any::<[bool; 4]>(), choice(SOURCES), choice(PATTERNS), choice(INDICES), number(), choice(PARTS));
    let surface = (choice(DISTRIBUTIONS), choice(LAWS), choice(PATTERNS), choice(ROUGHNESSES), vector(), vector());
    let shading = (choice(MODES), choice(PLACES), choice(RULES), any::<bool>());
    let cueing = (choice(CUES), number(), number(), choice(PARTS), choice(PARTS));
    let lights = prop::collection::vec(light(), 0..4);
    (camera, object, material, surface, shading, lights, around, cueing).prop_map(
        |(camera, object, material, surface, shading, lights, around, cueing)| {
            let mut scene = Scene::default();
            scene.image.size = [16, 16];
            (scene.camera.eye, scene.camera.target, scene.camera.up) = (camera.0, camera.1, camera.2);
            scene.camera.projection = if camera.3 { Projection::Perspective } else { Projection::Orthographic };
            (scene.camera.fov_y, scene.camera.roll) = (camera.4, camera.7);
            scene.camera.height = camera.5.abs();
            scene.camera.viewer = if camera.6 { Viewer::Local } else { Viewer::Infinite };
            (scene.object.kind, scene.object.segments, scene.object.rings) = (object.0, object.1, object.2);
            if scene.object.kind == ObjectKind::Polygons {
                let count = u32::try_from(object.5.len()).expect("few corners");
                scene.object.vertices = object.5.into();
                // A fan of triangles, as any corners make, and the triangle itself turned about.
                scene.object.faces =
                    (2..count).map(|k| vec![0, k - 1, k]).chain([vec![0, 2, 1]]).map(Shared::from).collect();
            }
            (scene.object.normals, scene.object.weighting) = (object.3, object.4);
            (scene.material.ka, scene.material.kd, scene.material.ks) =
                (material.0.abs(), material.1.abs(), material.2.abs());
            scene.material.n = material.3;
            scene.reflection.model = material.4;
            (scene.reflection.distribution, scene.material.reflectance, scene.pattern.kind) =
                (surface.0, surface.1, surface.2);
            scene.material.roughness = surface.3;
            (scene.material.ior, scene.material.extinction) = (surface.4.abs(), surface.5.abs());
            scene.reflection.backfacing = if material.5 { Backfacing::Clamp } else { Backfacing::Flip };
            (scene.shading.mode, scene.shading.flat_at) = (shading.0, shading.1);
            (scene.shading.interpolation, scene.shading.renormalise) = (shading.2, shading.3);
            // The policy that keeps the picture as it was before the display.
            scene.display.overflow = Overflow::Scale;
            scene.lights = lights;
            let ([shadows, visible, solid, _], source, pattern, ior, height, kt) = around;
            scene.shading.shadows = shadows;
            (scene.ground.visible, scene.ground.height) = (visible, height);
            scene.transparency.through = if solid { Through::Solid } else { Through::Surface };
            (scene.transparency.ior, scene.transparency.kt) = (ior, kt);
            (scene.backdrop.pattern, scene.backdrop.distance) = (pattern, height);
            scene.ambient.source = source;
            let (by, front, beyond, front_scale, back_scale) = cueing;
            let (front, color) = (front.abs().min(1e29), surface.4.abs());
            let back = (front + beyond.abs()).clamp(front.next_up(), 1e30);
            scene.depth_cueing = DepthCueing { by, front, back, front_scale, back_scale, color };
            scene
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, max_global_rejects: 200_000, ..ProptestConfig::default() })]

    #[test]
    fn every_accepted_scene_is_drawn_in_finite_numbers(scene in scene()) {
        prop_assume!(scene.validate().is_ok());
        let mut renderer = Renderer::default();
        renderer.render(&scene);
        let finite = renderer.linear().iter().flatten().all(|v| v.is_finite());
        prop_assert!(finite, "{}", scene.to_toml());
    }
}
