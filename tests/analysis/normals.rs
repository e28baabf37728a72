//! Vertex normals made visible: the contributing faces with their weights against closed forms, and the positions of needles in a
//! picture.

use crate::common::mesh;
use glam::{DVec2, DVec3};
use shading_lab::analysis::normals::{
    LitVertex, NeedleKind, Needles, NormalField, NormalsQuestion, VertexNormal,
};
use shading_lab::analysis::overlay::{OverlayLayer, OverlayOptions, free_corners};
use shading_lab::analysis::{Answer, Question, ReportContext, Subject, unwatched};
use shading_lab::export::glsl_330;
use shading_lab::figure::Area;
use shading_lab::geometry::{Mesh, NormalOrigin, tessellate};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Choice, NormalSource, Object, ObjectKind, Projection, Scene, ShadingMode, View, Weighting,
    presets,
};
use std::sync::Arc;
use tiny_skia::Pixmap;

fn vertex(mesh: &Mesh, weighting: Weighting, number: u32) -> VertexNormal {
    let field = NormalField::of_mesh(Arc::new(mesh.clone()), NormalSource::Averaged, weighting);
    field.vertex(number).expect("a vertex")
}

/// Returns the total share of the faces that face `way`.
fn share_towards(vertex: &VertexNormal, way: DVec3) -> f64 {
    vertex
        .faces
        .iter()
        .filter(|face| face.normal.dot(way) > 0.999)
        .map(|face| face.share)
        .sum()
}

#[track_caller]
fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-6, "{a} against {b}");
}

/// Returns a box of edges a, b, c at the origin, its six faces as quadrilaterals.
fn cuboid([a, b, c]: [f32; 3]) -> Mesh {
    let at = |i: u32| {
        [
            a * (i & 1) as f32,
            b * (i >> 1 & 1) as f32,
            c * (i >> 2 & 1) as f32,
        ]
    };
    let positions: Vec<[f32; 3]> = (0..8).map(at).collect();
    let faces: [&[u32]; 6] = [
        &[0, 2, 3, 1],
        &[4, 5, 7, 6],
        &[0, 1, 5, 4],
        &[2, 6, 7, 3],
        &[0, 4, 6, 2],
        &[1, 3, 7, 5],
    ];
    mesh(&positions, &faces)
}

/// Returns the mesh with each face cut into two triangles by the diagonal through its first corner.
fn fanned(mesh: &Mesh) -> Mesh {
    let mut cut = Mesh {
        starts: vec![0],
        corners: vec![],
        ..mesh.clone()
    };
    for f in 0..mesh.face_count() {
        let face = mesh.face(f);
        for pair in face[1..].windows(2) {
            cut.corners.extend([face[0], pair[0], pair[1]]);
            cut.starts.push(cut.corners.len() as u32);
        }
    }
    cut
}

#[test]
fn at_a_cubes_corner_three_faces_count_a_third_each() {
    let cube = cuboid([1.0; 3]);
    for &weighting in Weighting::VALUES {
        let corner = vertex(&cube, weighting, 7);
        assert_eq!(
            (corner.origin, corner.faces.len()),
            (NormalOrigin::Averaged, 3)
        );
        for face in &corner.faces {
            close(face.share, 1.0 / 3.0);
            // The diagonal's angle with an axis.
            close(face.angle, 3f64.sqrt().recip().acos().to_degrees());
        }
        close(corner.length, 3f64.sqrt().recip());
        assert!(corner.normal.distance(DVec3::splat(3f64.sqrt().recip())) < 1e-6);
    }
    let raw = |weighting| vertex(&cube, weighting, 7).faces[0].weight;
    assert_eq!([Weighting::Equal, Weighting::Area].map(raw), [1.0, 1.0]);
    close(raw(Weighting::Angle), 90.0);
    // A unit cube of n-gons: with angle weighting, further corners on an edge change nothing.
    let built_in = tessellate(&Object {
        kind: ObjectKind::Cube,
        segments: 4,
        rings: 1,
        ..Object::default()
    });
    vertex(&built_in, Weighting::Equal, 0)
        .faces
        .iter()
        .for_each(|face| close(face.share, 1.0 / 3.0));
}

#[test]
fn angles_do_not_see_how_a_side_is_cut_and_counting_does() {
    let cut = fanned(&cuboid([1.0; 3]));
    let sides = [DVec3::X, DVec3::Y, DVec3::Z];
    for number in 0..8 {
        let by_angle = vertex(&cut, Weighting::Angle, number);
        let outwards = by_angle.position * 2.0 - 1.0;
        sides
            .iter()
            .for_each(|side| close(share_towards(&by_angle, side * outwards), 1.0 / 3.0));
    }
    // Corner 4 is where one fan begins: it has two triangles on that side, one on either other.
    let counted = vertex(&cut, Weighting::Equal, 4);
    assert_eq!(counted.faces.len(), 4);
    counted
        .faces
        .iter()
        .for_each(|face| close(face.share, 0.25));
    let shares = sides.map(|side| share_towards(&counted, side * (counted.position * 2.0 - 1.0)));
    assert_eq!(
        shares
            .iter()
            .filter(|share| (**share - 0.5).abs() < 1e-9)
            .count(),
        1,
        "{shares:?}"
    );
}

#[test]
fn area_weights_of_a_box_are_its_sides() {
    let corner = vertex(&cuboid([1.0, 2.0, 4.0]), Weighting::Area, 7);
    // 2·4, 1·4 and 1·2 of 14 together.
    for (way, area) in [(DVec3::X, 8.0), (DVec3::Y, 4.0), (DVec3::Z, 2.0)] {
        close(share_towards(&corner, way), area / 14.0);
        let face = corner
            .faces
            .iter()
            .find(|face| face.normal.dot(way) > 0.999)
            .expect("a side");
        close(face.weight, area);
    }
    close(corner.length, 84f64.sqrt() / 14.0);
    let sum = DVec3::new(8.0, 4.0, 2.0) / 14.0;
    assert!(corner.sum.distance(sum) < 1e-6 && corner.normal.distance(sum.normalize()) < 1e-6);
}

#[test]
fn angle_weights_at_a_pyramids_apex_are_its_apex_angles() {
    // Over a rectangle 2a × 2b with height h; at the apex cos of a side's angle is (h² ± …)/(h² + a² + b²).
    let (a, b, h) = (1.0f64, 0.5f64, 2.0f64);
    let (x, y, z) = (a as f32, b as f32, h as f32);
    let positions = [
        [0.0, 0.0, z],
        [-x, -y, 0.0],
        [x, -y, 0.0],
        [x, y, 0.0],
        [-x, y, 0.0],
    ];
    let pyramid = mesh(
        &positions,
        &[
            &[0, 1, 2],
            &[0, 2, 3],
            &[0, 3, 4],
            &[0, 4, 1],
            &[4, 3, 2, 1],
        ],
    );
    let squares = a * a + b * b + h * h;
    let along = |half: f64| ((squares - 2.0 * half * half) / squares).acos();
    let (wide, narrow) = (along(a), along(b));
    let apex = vertex(&pyramid, Weighting::Angle, 0);
    for (face, angle) in apex.faces.iter().zip([wide, narrow, wide, narrow]) {
        close(face.weight, angle.to_degrees());
        close(face.share, angle / (2.0 * (wide + narrow)));
    }
    assert!(apex.normal.distance(DVec3::Z) < 1e-6);
    assert_eq!(
        apex.faces.iter().map(|face| face.face).collect::<Vec<_>>(),
        [0, 1, 2, 3]
    );
}

#[test]
fn given_and_facet_normals_and_cancelled_ones_say_so() {
    let cube = Object {
        kind: ObjectKind::Cube,
        segments: 4,
        rings: 1,
        ..Object::default()
    };
    let of = |source| NormalField::of_mesh(Arc::new(tessellate(&cube)), source, Weighting::Equal);
    let exact = of(NormalSource::Exact);
    assert_eq!(exact.vertex_count(), 24);
    let corner = exact.vertex(0).expect("a vertex");
    assert_eq!(
        (corner.origin, corner.faces.len(), corner.length),
        (NormalOrigin::Given, 1, 0.0)
    );
    let facet = of(NormalSource::Facet).vertex(5).expect("a vertex");
    assert_eq!(
        (facet.origin, facet.faces.len(), facet.faces[0].share),
        (NormalOrigin::Facet, 1, 1.0)
    );
    assert_eq!(facet.faces[0].normal, facet.normal);
    assert_eq!(exact.vertex(24), None);
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let leaf = vertex(
        &mesh(&positions, &[&[0, 1, 2], &[0, 2, 1]]),
        Weighting::Area,
        0,
    );
    assert_eq!(
        (leaf.origin, leaf.length, leaf.normal),
        (NormalOrigin::FirstFace, 0.0, DVec3::Z)
    );
    leaf.faces.iter().for_each(|face| close(face.share, 0.5));
    // The same point, whichever normals are chosen.
    let averaged = of(NormalSource::Averaged);
    for vertex in 0..24 {
        let point = exact.point_of(vertex).expect("a vertex of a face");
        let other = averaged
            .vertex_at(point)
            .and_then(|vertex| averaged.vertex(vertex))
            .expect("a vertex");
        assert_eq!(
            other.position,
            exact.vertex(vertex).expect("a vertex").position
        );
    }
}

#[test]
fn what_is_shown_is_what_the_averaging_gives() {
    for kind in [
        ObjectKind::Sphere,
        ObjectKind::Teapot,
        ObjectKind::Cone,
        ObjectKind::Corrugated,
        ObjectKind::Torus,
    ] {
        let object = Object {
            kind,
            segments: 11,
            rings: 5,
            ..Object::default()
        };
        let mesh = Arc::new(tessellate(&object));
        for &weighting in Weighting::VALUES {
            let field = NormalField::of_mesh(Arc::clone(&mesh), NormalSource::Averaged, weighting);
            for number in (0..field.vertex_count() as u32).step_by(7) {
                let vertex = field.vertex(number).expect("a vertex");
                if vertex.origin == NormalOrigin::Averaged {
                    close(vertex.faces.iter().map(|face| face.share).sum(), 1.0);
                    assert!(
                        vertex.sum.normalize().distance(vertex.normal) < 1e-6,
                        "{kind:?} {number}"
                    );
                }
            }
        }
    }
}

/// Draws a scene and returns its normal field and its needles with the renderer.
fn needles(scene: &Scene, layers: &[OverlayLayer]) -> (Renderer, NormalField, Needles) {
    let mut renderer = Renderer::default();
    renderer.render(scene);
    let field = NormalField::new(&renderer, &scene.object);
    let options = OverlayOptions {
        layers: layers.to_vec(),
        ..OverlayOptions::default()
    };
    let laid = Needles::new(scene.image.size, scene, &renderer, &field, &options);
    (renderer, field, laid)
}

fn sphere(segments: u32, rings: u32) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [500, 400];
    scene.object = Object {
        segments,
        rings,
        ..Object::default()
    };
    scene
}

const BOTH: [OverlayLayer; 2] = [OverlayLayer::FaceNormals, OverlayLayer::VertexNormals];

#[test]
fn needles_stand_where_their_points_and_ends_appear() {
    for &projection in Projection::VALUES {
        let mut scene = sphere(12, 6);
        scene.camera.projection = projection;
        let (_, field, laid) = needles(&scene, &BOTH);
        let view = View::new(&scene.camera, scene.image.size);
        assert!(laid.note.is_none() && laid.needles.len() > 40);
        let faces = tessellate(&scene.object);
        for needle in &laid.needles {
            let (point, normal) = match needle.kind {
                NeedleKind::Vertex => field
                    .vertex(needle.index)
                    .map(|v| (v.position, v.normal))
                    .expect("a vertex"),
                NeedleKind::Face => {
                    let f = needle.index as usize;
                    (faces.face_centre(f), faces.face_normal(f))
                }
            };
            let at = |world: DVec3| view.project(world).expect("before the eye").0;
            assert!(needle.foot.distance(at(point)) < 1e-9);
            assert!(needle.tip.distance(at(point + normal * laid.length)) < 1e-9);
        }
        // Half a median edge, whose length is between an edge of the equator and one of a meridian.
        assert!(
            (0.5 * field.median_edge - laid.length).abs() < 1e-9
                || laid.length < 0.5 * field.median_edge
        );
    }
}

#[test]
fn back_faces_and_what_is_hidden_have_no_needles() {
    let (_, field, laid) = needles(&sphere(12, 6), &BOTH);
    for needle in &laid.needles {
        let towards = match needle.kind {
            NeedleKind::Vertex => field.vertex(needle.index).expect("a vertex").normal.z,
            NeedleKind::Face => field
                .outline(needle.index)
                .iter()
                .map(|corner| corner.z)
                .sum(),
        };
        // A vertex on the outline leans away a little.
        assert!(
            towards
                > if needle.kind == NeedleKind::Face {
                    0.0
                } else {
                    -0.3
                },
            "{needle:?}: {towards}"
        );
    }
    // Two squares, one behind the other: of eight vertices the front four are visible.
    let mut scene = sphere(3, 3);
    let square = |z: f64, side: f64| {
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]| DVec3::new(x * side, y * side, z))
    };
    scene.object.kind = ObjectKind::Polygons;
    scene.object.normals = NormalSource::Averaged;
    scene.object.vertices = [square(0.0, 1.0), square(-2.0, 0.5)].concat().into();
    scene.object.faces = vec![vec![0, 1, 2, 3].into(), vec![4, 5, 6, 7].into()].into();
    for mode in [ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong] {
        scene.shading.mode = mode;
        let (renderer, field, laid) = needles(&scene, &[OverlayLayer::VertexNormals]);
        assert_eq!(
            laid.needles
                .iter()
                .map(|needle| needle.index)
                .collect::<Vec<_>>(),
            [0, 1, 2, 3]
        );
        let view = View::new(&scene.camera, scene.image.size);
        let seen = field.facing(&view, scene.image.size);
        assert_eq!(seen.vertices.len(), 8);
        // The hidden vertex is nearer to this position, and yet not selected.
        let (pixel, _) = view
            .project(DVec3::new(0.5, 0.5, -2.0))
            .expect("before the eye");
        let near = field
            .vertex_near(&renderer, &seen, pixel, 1e9)
            .expect("one is seen");
        assert_eq!(near.index, 2);
        assert_eq!(field.vertex_near(&renderer, &seen, pixel, 3.0), None);
    }
}

#[test]
fn of_too_many_an_even_choice_is_drawn_and_said() {
    let (_, field, laid) = needles(&sphere(400, 200), &BOTH);
    let note = laid.note.clone().expect("not all are drawn");
    assert!(note.text.contains("25037"), "{}", note.text);
    assert!(
        (200..6000).contains(&laid.needles.len()),
        "{}",
        laid.needles.len()
    );
    let vertices = laid
        .needles
        .iter()
        .filter(|needle| needle.kind == NeedleKind::Vertex);
    let feet: Vec<DVec3> = vertices
        .map(|needle| field.vertex(needle.index).expect("a vertex").position)
        .collect();
    let nearest = |i: usize| {
        let others = feet
            .iter()
            .enumerate()
            .filter(|(j, _)| *j != i)
            .map(|(_, other)| other.distance(feet[i]));
        others.fold(f64::INFINITY, f64::min)
    };
    let gaps: Vec<f64> = (0..feet.len()).map(nearest).collect();
    let (least, most) = gaps.iter().fold((f64::INFINITY, 0.0f64), |(l, m), gap| {
        (l.min(*gap), m.max(*gap))
    });
    assert!(least > 0.03 && most < 2.5 * least, "{least} to {most}");
}

#[test]
fn a_lit_vertex_is_lettered_with_its_shares() {
    let mut scene = sphere(12, 6);
    scene.object.normals = NormalSource::Averaged;
    scene.object.weighting = Weighting::Area;
    let (_, field, laid) = needles(&scene, &BOTH);
    let facing = laid
        .needles
        .iter()
        .filter(|needle| needle.kind == NeedleKind::Vertex);
    let middle = DVec2::new(250.0, 200.0);
    let nearest = facing
        .min_by(|a, b| a.foot.distance(middle).total_cmp(&b.foot.distance(middle)))
        .expect("needles");
    let vertex = field.vertex(nearest.index).expect("a vertex");
    let options = OverlayOptions::default();
    let lit =
        LitVertex::new(scene.image.size, &scene, &field, &vertex, &options).expect("it appears");
    let mut texts: Vec<&str> = lit.labels.iter().map(|label| label.text.as_str()).collect();
    texts.sort_unstable();
    let mut shares: Vec<String> = vertex
        .faces
        .iter()
        .map(|face| format!("{:.2}", face.share))
        .collect();
    shares.sort();
    shares.push("N".to_owned());
    assert_eq!(texts, shares);
    assert_eq!(lit.sphere, None, "the vectors have a side view");
    // The letters stay out of what is covered.
    let n = |lit: &LitVertex| {
        let mut labels = lit.labels.iter();
        labels.find(|label| label.text == "N").expect("N").area
    };
    let covered = n(&lit);
    let others = OverlayOptions {
        covered: vec![covered],
        ..options.clone()
    };
    let beside = LitVertex::new(scene.image.size, &scene, &field, &vertex, &others);
    assert!(!n(&beside.expect("it appears")).overlaps(&covered));
    let mut pixmap = Pixmap::new(500, 400).expect("not empty");
    lit.draw(&mut pixmap.as_mut());
    let inked = pixmap
        .pixels()
        .iter()
        .filter(|pixel| pixel.alpha() > 0)
        .count();
    assert!((2000..100_000).contains(&inked), "{inked}");
    // The pole of many faces is counted.
    scene.object.segments = 64;
    let (_, field, _) = needles(&scene, &BOTH);
    let pole = (0..field.vertex_count() as u32)
        .filter_map(|v| field.vertex(v))
        .find(|v| v.faces.len() == 64);
    scene.camera.eye = DVec3::new(0.0, 4.0, 0.1);
    let lit = LitVertex::new(
        scene.image.size,
        &scene,
        &field,
        &pole.expect("a pole"),
        &options,
    )
    .expect("it appears");
    let each = english!("picture-lit-faces-each", count = 64, share = "0.016");
    assert!(
        lit.labels.iter().any(|label| label.text == each),
        "{:?}",
        lit.labels
    );
}

#[test]
fn a_lit_vertex_has_its_sphere_of_normals_in_a_free_corner() {
    let mut scene = sphere(12, 6);
    scene.object.normals = NormalSource::Averaged;
    let size = scene.image.size;
    let lit = |scene: &Scene, options: &OverlayOptions| {
        let mut renderer = Renderer::default();
        renderer.render(scene);
        let field = NormalField::new(&renderer, &scene.object);
        let place = DVec2::new(250.0, 150.0);
        let number = field.vertex_next_to(&renderer, scene, place);
        let vertex = field.vertex(number?)?;
        let options = OverlayOptions {
            free_corners: free_corners(renderer.frame()),
            ..options.clone()
        };
        LitVertex::new(size, scene, &field, &vertex, &options)
    };
    let options = OverlayOptions {
        layers: BOTH.to_vec(),
        ..OverlayOptions::default()
    };
    let shown = lit(&scene, &options).expect("a vertex");
    let pane = shown.sphere.expect("a free corner");
    let corner = pane.min.cmple(DVec2::splat(60.0)) | pane.max.cmpge(DVec2::new(440.0, 340.0));
    assert!(corner.all(), "{pane:?}");
    let inside = |text: &str| {
        let mut named = shown.labels.iter().filter(|label| label.text == text);
        named.any(|label| pane.holds(&label.area))
    };
    assert!(inside("N") && inside(english!("picture-lit-mean")));
    let share = shown
        .labels
        .iter()
        .find(|label| label.text.starts_with("0."));
    assert!(!pane.holds(&share.expect("a share").area));
    // Nothing is averaged: there is no mean.
    scene.object.normals = NormalSource::Exact;
    assert_eq!(lit(&scene, &options).expect("a vertex").sphere, None);
    // No corner is free: the one that is farthest from the vertex is covered.
    scene.object.normals = NormalSource::Averaged;
    scene.camera.eye *= 0.8;
    let pane = lit(&scene, &options).expect("a vertex").sphere;
    assert!(
        !pane
            .expect("a corner")
            .holds(&Area::about(DVec2::new(250.0, 150.0), DVec2::ONE))
    );
    // There is no room for its letters.
    let narrow = OverlayOptions {
        scale: 4.0,
        ..options
    };
    assert_eq!(lit(&scene, &narrow).expect("a vertex").sphere, None);
}

#[test]
fn a_model_without_normals_is_shaded_with_the_weighting_that_it_asks_for() {
    let corner = mesh(
        &[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        &[&[0, 2, 1], &[0, 1, 3], &[0, 3, 2], &[1, 2, 3]],
    );
    let corner = Arc::new(corner);
    let draw = |normals, weighting| {
        let mut scene = Scene::default();
        scene.object.kind = ObjectKind::Obj;
        scene.object.path = Some("model.obj".into());
        (scene.object.normals, scene.object.weighting) = (normals, weighting);
        scene.shading.mode = ShadingMode::Gouraud;
        scene.image.size = [48, 48];
        let mut renderer = Renderer::default().with_model(Some(corner.clone()));
        renderer.render(&scene).pixels.clone()
    };
    let by_angle = draw(NormalSource::Averaged, Weighting::Angle);
    assert_ne!(by_angle, draw(NormalSource::Averaged, Weighting::Equal));
    for given in [NormalSource::Exact, NormalSource::File] {
        assert!(draw(given, Weighting::Angle) == by_angle, "{given:?}");
    }
}

/// Checks that normals from a file are averaged for a built-in shape, which has no file, in the picture and in words.
#[test]
fn a_built_in_shape_has_no_normals_of_a_file() {
    let faceted = |kind: ObjectKind, normals| {
        let mut scene = Scene::default();
        (scene.object.kind, scene.object.normals) = (kind, normals);
        (scene.object.segments, scene.object.rings) = (6, 4);
        scene.object.weighting = Weighting::Angle;
        scene.image.size = [48, 48];
        scene
    };
    let shapes = ObjectKind::VALUES
        .iter()
        .copied()
        .filter(|kind| kind.has_surface());
    let mut told_apart = 0;
    for kind in shapes {
        let draw = |normals| {
            let scene = faceted(kind, normals);
            let mut renderer = Renderer::default();
            let pixels = renderer.render(&scene).pixels.clone();
            let field = NormalField::new(&renderer, &scene.object);
            assert!(field.holds(&renderer, &scene.object));
            (pixels, field.source, field.weighs())
        };
        let file = draw(NormalSource::File);
        assert!(file == draw(NormalSource::Averaged), "{kind:?}");
        told_apart += usize::from(file.0 != draw(NormalSource::Exact).0);
    }
    assert!(told_apart >= 4, "{told_apart}");
    let subject = Subject {
        scene: faceted(ObjectKind::Sphere, NormalSource::File),
        model: None,
        clock: || 0,
    };
    let question = NormalsQuestion::default();
    let about = ReportContext {
        name: "sphere",
        scene: &subject.scene,
    };
    let answer: &dyn Answer = &question.answer(&subject, &unwatched).expect("a vertex");
    let text = answer.text(&about);
    assert!(
        text.contains(english!("picture-weighted-by-angle")),
        "{text}"
    );
    let host = &glsl_330(&subject.scene).parts[0].text;
    assert!(
        host.contains("the mean of the polygons' at the vertex"),
        "{host}"
    );
}

#[test]
fn each_strip_of_a_folded_sheet_has_its_needle() {
    let scene = presets::find("vertex-normals").expect("built in").scene();
    let scene = scene
        .with_overrides(&["object.segments=6", "image.size=[790,634]"])
        .expect("settings");
    let (_, _, laid) = needles(&scene, &[OverlayLayer::FaceNormals]);
    let leaning: Vec<bool> = laid
        .needles
        .iter()
        .map(|needle| needle.tip.x > needle.foot.x)
        .collect();
    assert_eq!(leaning, [false, true, false, true, false, true]);
    assert!(laid.note.is_none());
}
