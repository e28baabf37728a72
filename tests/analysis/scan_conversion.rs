//! One polygon converted to pixels: against the picture, the probe and the formulas.

use glam::Vec3;
use glam::{DVec2, DVec3};
use shading_lab::analysis::probe::probe;
use shading_lab::analysis::scan::{
    Grid, Rule, Scan, ScanError, ScanLevel, ScanLine, ScanPixel, ScanSpan, ScanStep, ScanStop,
    corner_name, face_at, scan, scan_in_grid,
};
use shading_lab::analysis::{Answer, ReportContext};
use shading_lab::geometry::{Corner, Mesh, NO_NORMAL};
use shading_lab::render::Renderer;
use shading_lab::scene::{Choice, Interpolation, NormalSource, ObjectKind, Projection, presets};
use shading_lab::scene::{Scene, ShadingMode};
use std::sync::Arc;

const MODES: [ShadingMode; 4] = [
    ShadingMode::Flat,
    ShadingMode::Interpolated,
    ShadingMode::Gouraud,
    ShadingMode::Phong,
];

/// Returns a scene whose object is one polygon in the plane z = 0.
fn polygon(points: &[[f32; 2]]) -> (Renderer, Scene) {
    let positions: Vec<Vec3> = points.iter().map(|[x, y]| Vec3::new(*x, *y, 0.0)).collect();
    let corners: Vec<Corner> = (0..points.len())
        .map(|i| Corner {
            position: i as u32,
            normal: NO_NORMAL,
        })
        .collect();
    let mesh = Mesh {
        positions,
        starts: vec![0, points.len() as u32],
        corners,
        ..Mesh::default()
    };
    let mut scene = Scene::default();
    scene.image.size = [80, 60];
    scene.object.kind = ObjectKind::Obj;
    scene.object.normals = NormalSource::Averaged;
    scene.shading.mode = ShadingMode::Gouraud;
    let renderer = Renderer::default().with_model(Some(Arc::new(mesh)));
    (renderer, scene)
}

const TRIANGLE: [[f32; 2]; 3] = [[-1.0, -0.7], [0.9, -0.3], [0.1, 0.8]];
const QUADRILATERAL: [[f32; 2]; 4] = [[-0.9, -0.5], [0.6, -0.8], [0.9, 0.4], [-0.5, 0.9]];
/// A letter M: its upper scan lines have two spans. A fan from its first corner does not cover it, which matters to triangles
/// only.
const LETTER_M: [[f32; 2]; 5] = [
    [-0.9, -0.8],
    [0.9, -0.8],
    [0.8, 0.8],
    [0.0, -0.2],
    [-0.8, 0.8],
];

fn pixels(scan: &Scan) -> impl Iterator<Item = (&ScanLine, &ScanSpan, &ScanPixel)> {
    let spans = scan
        .lines
        .iter()
        .flat_map(|line| line.spans.iter().map(move |span| (line, span)));
    spans.flat_map(|(line, span)| span.pixels.iter().map(move |pixel| (line, span, pixel)))
}

#[test]
fn on_a_triangle_the_scan_line_is_affine_interpolation() {
    let (mut renderer, mut scene) = polygon(&TRIANGLE);
    scene.shading.interpolation = Interpolation::Affine;
    scene.camera.eye = DVec3::new(1.5, 0.8, 3.0);
    for mode in MODES {
        scene.shading.mode = mode;
        let scan = scan(&mut renderer, &scene, 0, 32).expect("a triangle in sight");
        let mut count = 0;
        for (_, _, pixel) in pixels(&scan) {
            assert!(
                (pixel.intensity - pixel.barycentric).abs().max_element() < 1e-9,
                "{mode:?} {pixel:?}"
            );
            count += 1;
        }
        assert!(count > 200, "{mode:?}: {count} pixels");
    }
}

#[test]
fn on_a_quadrilateral_it_is_the_formula_of_the_course() {
    let (mut renderer, scene) = polygon(&QUADRILATERAL);
    let scan = scan(&mut renderer, &scene, 0, 24).expect("a quadrilateral in sight");
    let corners = &scan.corners;
    let mut differs = false;
    for (line, span, pixel) in pixels(&scan) {
        // The corners run counter-clockwise from the lower left: P lies on one of the left edges, Q on a right one.
        let on = |a: usize, b: usize| {
            let (from, to) = (corners[a].place, corners[b].place);
            let share = (line.centre_y() - from.y) / (to.y - from.y);
            (0.0..1.0).contains(&share).then(|| {
                (
                    from.x + share * (to.x - from.x),
                    corners[a].value * (1.0 - share) + corners[b].value * share,
                )
            })
        };
        let mut found: Vec<_> = [(0, 1), (1, 2), (2, 3), (3, 0)]
            .into_iter()
            .filter_map(|(a, b)| on(a, b))
            .collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let [(x_p, p), (x_q, q)] = found[..] else {
            panic!("{} crossings in line {}", found.len(), line.y)
        };
        let share = (f64::from(pixel.x) + 0.5 - x_p) / (x_q - x_p);
        let expected = p * (1.0 - share) + q * share;
        assert!((pixel.intensity - expected).abs().max_element() < 1e-12);
        assert!((span.p.x - x_p).abs() < 1e-9 && (0.0..1.0).contains(&pixel.alpha));
        differs |= (pixel.intensity - pixel.barycentric).abs().max_element() > 1e-3;
    }
    assert!(
        differs,
        "with four corners it is not the triangles' interpolation"
    );
}

/// Compares the values with the engine's own picture, pixel by pixel, in every mode.
#[test]
fn the_values_are_those_of_the_picture() {
    for name in ["sphere", "torus", "teapot", "cube", "shadows"] {
        let mut scene = presets::find(name).expect("a built-in scene").scene();
        scene.image.size = [120, 90];
        (scene.object.segments, scene.object.rings) = (7, 5);
        scene.shading.interpolation = Interpolation::Scanline;
        for mode in MODES {
            scene.shading.mode = mode;
            let mut renderer = Renderer::default();
            let face = [43, 60, 70]
                .into_iter()
                .find_map(|y| face_at(&mut renderer, &scene, 57, y))
                .expect("the object");
            if scene.shading.shadows && mode == ShadingMode::Phong {
                continue;
            }
            let grid = Grid {
                columns: 120,
                rows: 90,
                scale: DVec2::ONE,
                origin: DVec2::ZERO,
            };
            let scan = scan_in_grid(&renderer, &scene, face, grid).expect("a face in sight");
            let (mut compared, mut inside) = (0, 0);
            for (line, _, pixel) in pixels(&scan) {
                inside += 1;
                let Some(hit) = probe(&mut renderer, &scene, pixel.x, line.y)
                    .hit
                    .filter(|h| h.face == Some(face))
                else {
                    continue;
                };
                compared += 1;
                let what = format!("{name} {mode:?} at {}, {}", pixel.x, line.y);
                let off = (hit.sum - pixel.intensity).abs().max_element();
                assert!(off < 1e-9, "{what}: {} is not {}", pixel.intensity, hit.sum);
                let codes = hit.stored.iter().zip(pixel.stored);
                assert!(
                    codes.clone().all(|(a, b)| a.abs_diff(b) <= 1),
                    "{what}: {codes:?}"
                );
            }
            assert!(
                compared > 20 && compared * 10 >= inside * 6,
                "{name} {mode:?}: {compared} of {inside}"
            );
        }
    }
}

#[test]
fn perspective_correct_interpolation_is_the_pictures_too() {
    let (mut renderer, mut scene) = polygon(&QUADRILATERAL);
    scene.camera.eye = DVec3::new(2.0, 0.5, 1.5);
    for (interpolation, compared) in [
        (Interpolation::Perspective, Rule::Perspective),
        (Interpolation::Affine, Rule::Affine),
    ] {
        scene.shading.interpolation = interpolation;
        renderer.render(&scene);
        let grid = Grid {
            columns: 80,
            rows: 60,
            scale: DVec2::ONE,
            origin: DVec2::ZERO,
        };
        let scan = scan_in_grid(&renderer, &scene, 0, grid).expect("a face in sight");
        assert_eq!(scan.compared, compared);
        for (line, _, pixel) in pixels(&scan) {
            let Some(hit) = probe(&mut renderer, &scene, pixel.x, line.y).hit else {
                continue;
            };
            let off = (hit.sum - pixel.barycentric).abs().max_element();
            assert!(off < 1e-6, "{compared:?} at {}, {}: {off}", pixel.x, line.y);
        }
    }
}

#[test]
fn a_concave_polygon_has_its_crossings_paired() {
    let (mut renderer, scene) = polygon(&LETTER_M);
    let scan = scan(&mut renderer, &scene, 0, 32).expect("a polygon in sight");
    let spans: Vec<usize> = scan.lines.iter().map(|line| line.spans.len()).collect();
    assert_eq!((spans[0], spans[spans.len() - 1]), (2, 1));
    assert!(
        spans.is_sorted_by(|a, b| a >= b),
        "two spans above, one below: {spans:?}"
    );
    for line in &scan.lines {
        let xs: Vec<f64> = line
            .spans
            .iter()
            .flat_map(|span| [span.p.x, span.q.x])
            .collect();
        assert!(xs.is_sorted(), "{xs:?}");
        assert_eq!(line.active.len(), 2 * line.spans.len());
    }
}

#[test]
fn walking_forwards_and_back_visits_the_same_states() {
    let (mut renderer, scene) = polygon(&LETTER_M);
    let scan = scan(&mut renderer, &scene, 0, 16).expect("a polygon in sight");
    for level in [ScanLevel::Pixel, ScanLevel::Edge, ScanLevel::Line] {
        let mut there = vec![0];
        while *there.last().expect("a step") < scan.last() {
            there.push(scan.forward(there[there.len() - 1], level));
        }
        let mut back = vec![scan.last()];
        while *back.last().expect("a step") > 0 {
            back.push(scan.back(back[back.len() - 1], level));
        }
        back.reverse();
        assert_eq!(there, back, "{level:?}");
        assert!(there.is_sorted_by(|a, b| a < b));
    }
    assert_eq!(scan.forward(scan.last(), ScanLevel::Pixel), scan.last());
    assert_eq!(scan.back(0, ScanLevel::Line), 0);
    assert_eq!(scan.filled(scan.last()).count(), pixels(&scan).count());
    assert_eq!(scan.filled(0).count(), 0);
    let [first, last] = scan.steps_of_line(9).expect("a line of the polygon");
    assert!(matches!(scan.steps[first], ScanStep::Line { .. }) && scan.at(last).pixel.is_some());
    assert_eq!(scan.steps_of_line(99), None);
}

#[test]
fn a_step_is_found_again_in_another_grid() {
    let (mut renderer, scene) = polygon(&QUADRILATERAL);
    let small = scan(&mut renderer, &scene, 0, 16).expect("a polygon in sight");
    let large = scan(&mut renderer, &scene, 0, 32).expect("a polygon in sight");
    for step in (0..=small.last()).step_by(7) {
        assert_eq!(small.step_like(&small, step), step);
        let there = large.step_like(&small, step);
        assert_eq!(large.steps[there].level(), small.steps[step].level());
        assert!(
            large.at(there).line.y.abs_diff(2 * small.at(step).line.y) <= 3,
            "{step}"
        );
    }
    let near = small.step_near(DVec2::new(8.5, 8.5));
    assert_eq!(
        (
            small.at(near).line.y,
            small.at(near).pixel.map(|pixel| pixel.x)
        ),
        (8, Some(8))
    );
}

#[test]
fn what_cannot_be_scanned_is_refused_in_a_sentence() {
    let (mut renderer, mut scene) = polygon(&QUADRILATERAL);
    let refused = |renderer: &mut Renderer, scene: &Scene, face, rows| {
        scan(renderer, scene, face, rows).err()
    };
    assert_eq!(
        refused(&mut renderer, &scene, 1, 16),
        Some(ScanError::NoFace { face: 1, count: 1 })
    );
    assert_eq!(
        refused(&mut renderer, &scene, 0, 7),
        Some(ScanError::Rows { rows: 7 })
    );
    assert_eq!(
        refused(&mut renderer, &scene, 0, 65),
        Some(ScanError::Rows { rows: 65 })
    );
    for &projection in Projection::VALUES {
        scene.camera.projection = projection;
        scene.camera.eye = DVec3::new(4.0, 0.0, 0.0);
        assert_eq!(
            refused(&mut renderer, &scene, 0, 16),
            Some(ScanError::EdgeOn { face: 0 })
        );
        scene.camera.eye = DVec3::new(0.5, 0.0, 0.02);
        scene.camera.target = DVec3::new(0.0, 0.0, 0.01);
        assert_eq!(
            refused(&mut renderer, &scene, 0, 16),
            Some(ScanError::BehindTheEye { face: 0 })
        );
        scene.camera.target = DVec3::ZERO;
    }
    renderer.set_model(None);
    assert_eq!(
        refused(&mut renderer, &scene, 0, 16),
        Some(ScanError::Empty)
    );
    assert_eq!(
        ScanError::NoFace { face: 9, count: 6 }.to_string(),
        english!("line-scan-error-no-face", face = 9, last = 5)
    );
}

/// Checks that nearly edge-on, many-sided, huge and tiny polygons yield numbers or a sentence.
#[test]
fn any_face_of_any_scene_gives_numbers() {
    for preset in presets::ALL {
        let mut scene = preset.scene();
        scene.image.size = [40, 30];
        (scene.object.segments, scene.object.rings) = (9, 4);
        for mode in [ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Exact] {
            scene.shading.mode = mode;
            let mut renderer = Renderer::default();
            for face in 0..20 {
                let Ok(scan) = scan(&mut renderer, &scene, face, 8) else {
                    continue;
                };
                for (_, _, pixel) in pixels(&scan) {
                    assert!(
                        pixel.intensity.is_finite() && pixel.barycentric.is_finite(),
                        "{} {face}",
                        preset.name
                    );
                    assert!(pixel.x < scan.grid.columns && (0.0..1.0).contains(&pixel.alpha));
                }
                for step in 0..=scan.last() {
                    assert!(!scan.caption(step).is_empty());
                }
            }
        }
    }
}

/// Checks that exact mode scans the polygon that stands for the visible surface as Phong shading does.
#[test]
fn exact_shading_finds_the_polygon_under_the_pixel() {
    let mut scene = Scene::default();
    scene.image.size = [64, 64];
    let mut renderer = Renderer::default();
    for pixel in [[32, 32], [20, 41], [45, 25]] {
        scene.shading.mode = ShadingMode::Phong;
        let seen = face_at(&mut renderer, &scene, pixel[0], pixel[1]);
        scene.shading.mode = ShadingMode::Exact;
        assert_eq!(face_at(&mut renderer, &scene, pixel[0], pixel[1]), seen);
        let face = seen.expect("the sphere");
        assert_eq!(
            scan(&mut renderer, &scene, face, 16).map(|scan| scan.mode),
            Ok(ShadingMode::Phong)
        );
    }
    assert_eq!(face_at(&mut renderer, &scene, 0, 0), None);
}

#[test]
fn the_formula_is_filled_in_as_the_course_writes_it() {
    let (mut renderer, scene) = polygon(&QUADRILATERAL);
    let scan = scan(&mut renderer, &scene, 0, 16).expect("a polygon in sight");
    let step = scan.step_near(DVec2::new(8.5, 8.5));
    let point = scan.at(step);
    let p = point.p.expect("a pixel's step");
    let [mix, _, pixel] = &scan.found(step)[..] else {
        panic!("P, Q and the pixel")
    };
    assert_eq!(mix.formula("I"), "I(P) = (1−α)·I(P₄) + α·I(P₁)");
    let alpha = mix.alpha_text();
    assert!(alpha.starts_with("α = (8.50 − "), "{alpha}");
    assert!(
        mix.row(0).ends_with(&format!("= {:.4}", p.value.x)),
        "{}",
        mix.row(0)
    );
    assert_eq!(pixel.formula("I"), "I = (1−α)·I(P) + α·I(Q)");
    assert_eq!(corner_name(11), "P₁₂");
    let count = pixels(&scan).count();
    let (answer, about) = (
        ScanStop { step, scan },
        ReportContext {
            name: "",
            scene: &scene,
        },
    );
    let answer: &dyn Answer = &answer;
    let text = answer.text(&about);
    assert!(
        text.contains(english!("line-scan-active")) && text.contains("I = (1−α)·I(P) + α·I(Q)"),
        "{text}"
    );
    let csv = answer.csv(&about);
    assert_eq!(csv.lines().count(), 1 + count);
    assert!(csv.lines().all(|row| row.split(',').count() == 13));
}
