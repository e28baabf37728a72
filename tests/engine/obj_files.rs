//! Wavefront OBJ: the contents of real files are read, and mistakes are reported with their line.

use crate::common::properties;
use glam::{DVec2, DVec3, Vec3};
use proptest::prelude::*;
use shading_lab::geometry::{Mesh, NO_NORMAL, ObjError, read_obj};
use shading_lab::render::Renderer;
use shading_lab::scene::{Choice, NormalSource, ObjectKind, Projection, Scene, Weighting};
use shading_lab::text::{Language, in_language};
use std::io::{BufReader, Cursor};

fn read(file: impl AsRef<[u8]>) -> Result<Mesh, ObjError> {
    read_obj(Cursor::new(file), &mut |_| {})
}

fn good(file: impl AsRef<[u8]>) -> Mesh {
    let mesh = read(file).expect("the model is sound");
    assert_eq!(
        mesh.corners.len(),
        *mesh.starts.last().expect("starts has an end") as usize
    );
    assert!(
        mesh.corners
            .iter()
            .all(|c| (c.position as usize) < mesh.positions.len())
    );
    assert!(
        mesh.corners
            .iter()
            .all(|c| c.normal == NO_NORMAL || (c.normal as usize) < mesh.normals.len())
    );
    mesh
}

fn arities(mesh: &Mesh) -> Vec<usize> {
    (0..mesh.face_count()).map(|f| mesh.face(f).len()).collect()
}

/// Returns the message and the line of the error.
fn bad(file: impl AsRef<[u8]>) -> (String, Option<u64>) {
    let error = read(file).expect_err("the model is not sound");
    (error.to_string(), error.line())
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn square(rest: &str) -> String {
    format!("{SQUARE}{rest}")
}

#[test]
fn a_file_as_programs_write_it() {
    let mesh = good(std::fs::read("tests/data/obj/tower.obj").expect("the file is there"));
    assert_eq!(arities(&mesh), [vec![8], vec![4; 8], vec![3; 8]].concat());
    assert_eq!(mesh.positions.len(), 17, "the unused vertex is not there");
    assert!(mesh.closed && !mesh.convex && mesh.normals.is_empty());
    let area = 2.0 * 2f64.sqrt();
    assert!((mesh.signed_volume() - area * (2.0 + 1.0 / 3.0)).abs() < 1e-3);
}

#[test]
fn line_ends_marks_and_encodings() {
    let plain = good(square("f 1 2 3 4\n"));
    assert_eq!(arities(&plain), [4]);
    assert!(plain.face_normal(0) == DVec3::Z && !plain.closed);
    for variant in [
        square("f 1 2 3 4"),
        square("f 1 2 3 4\n").replace('\n', "\r\n"),
        format!("\u{feff}{}", square("f 1 2 3 4\n")),
        square("f 1 2 \\\n3 \\\n4\n"),
        square("f 1 2 \\\n3 4\n").replace('\n', "\r\n"),
        square("\tf  1\t2 3  4  # a face\n\n#f 9 9 9\n"),
        square("# Größe \\\nf 1 2 3 4\n"),
        square(
            "mtllib no such file.mtl\nusemtl x\ng\ns 1\no\nvp 1 2\ncurv 0 1 1 2\nf 1 2 3 4\nl 1 2\np 1\ncall x\n",
        ),
    ] {
        let mesh = good(&variant);
        assert_eq!(
            (&mesh.positions, &mesh.corners),
            (&plain.positions, &plain.corners),
            "{variant:?}"
        );
    }
    let latin_1 = [
        b"# Gr\xf6\xdfe\ng \xe9t\xe9\n".as_slice(),
        square("f 1 2 3 4\n").as_bytes(),
    ]
    .concat();
    assert_eq!(good(latin_1).positions, plain.positions);
}

#[test]
fn polygons_of_any_size() {
    for sides in 3..=40 {
        let mut file = String::new();
        for k in 0..sides {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(sides);
            file += &format!("v {} {} 0\n", angle.cos(), angle.sin());
        }
        file += "f";
        (1..=sides).for_each(|k| file += &format!(" {k}"));
        let mesh = good(file);
        assert_eq!(arities(&mesh), [sides as usize]);
        assert!(mesh.face_normal(0).distance(DVec3::Z) < 1e-6);
        assert_eq!(mesh.triangle_count(), sides as usize - 2);
    }
}

#[test]
fn numbers_of_every_form() {
    let mesh = good(square(
        "f -4 -3 -2 -1\nv 5 5 5\nf -5 -4 -3\nf +1 2/7/ 3// 4/9\n",
    ));
    assert_eq!(arities(&mesh), [4, 3, 4]);
    assert_eq!(mesh.positions.len(), 4);
    let mesh =
        good("v 1e0 .5 -2.\nv +1 1E1 0 0.1 0.2 0.3\nv 2 4 6 2\nv 0 0 0 1 0.5 0.5 0.5\nf 1 2 3\n");
    assert_eq!(
        mesh.positions,
        [
            Vec3::new(1.0, 0.5, -2.0),
            Vec3::new(1.0, 10.0, 0.0),
            Vec3::new(1.0, 2.0, 3.0)
        ]
    );
}

#[test]
fn given_normals_missing_ones_and_useless_ones() {
    let file = square(
        "f 1 2 3\nvn 0 0 5\nvn 0 0 0\nvn nan 0 1\nvn 0.6 0 0.8\n\
         f 1//1 2//-1 3//2\nf 1//3 3 4//4\n",
    );
    let mesh = good(file);
    let given: Vec<Option<Vec3>> = mesh
        .corners
        .iter()
        .map(|c| mesh.normals.get(c.normal as usize).copied())
        .collect();
    let slanted = Vec3::new(0.6, 0.0, 0.8);
    assert_eq!(
        given,
        [
            None,
            None,
            None,
            Some(Vec3::Z),
            Some(slanted),
            None,
            None,
            None,
            Some(slanted)
        ]
    );
    let vertices = mesh.with_vertex_normals(NormalSource::File, Weighting::Equal);
    assert_eq!(vertices.normals[vertices.corners[3] as usize], Vec3::Z);
    assert_eq!(vertices.normals[vertices.corners[4] as usize], slanted);
    assert_eq!(
        vertices.normals[vertices.corners[7] as usize],
        Vec3::Z,
        "averaged"
    );
    let none = good(square("f 1 2 3 4\n"));
    for source in [NormalSource::File, NormalSource::Exact] {
        assert_eq!(
            none.with_vertex_normals(source, Weighting::Area).normals,
            vec![Vec3::Z; 4]
        );
    }
}

#[test]
fn objects_share_points_at_one_place() {
    let two = format!("o a\n{SQUARE}f 1 2 3\no b\n{SQUARE}g c\nf 5 7 8\nv -0.0 0 0\nf 9 2 3\n");
    let mesh = good(two);
    assert_eq!((mesh.positions.len(), mesh.face_count()), (4, 3));
}

#[test]
fn faces_without_area_do_no_harm() {
    let mesh = good(square(
        "f 1 1 1\nf 1 2 2 3\nf 1 2 1\nf 3 1 2 3\nf 1 2 3 4\nf 1 2 3 4\nv 2 0 0\nf 1 2 5\n",
    ));
    assert_eq!(arities(&mesh), [3, 3, 4, 4, 3]);
    let vertices = mesh.with_vertex_normals(NormalSource::Averaged, Weighting::Angle);
    assert!(vertices.normals.iter().all(|n| n.is_normalized()));
}

#[test]
fn concave_polygons_stay_whole_and_are_covered_once() {
    // An arrow head whose fan from its first corner would leave it, an L, and a comb that no fan covers.
    let arrow = "v 2 0 0\nv 0 1 0\nv 0.5 0 0\nv 0 -1 0\nf 1 2 3 4\nf 2 3 4 1\n";
    let l = "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 2 3 4 5 6 1\n";
    let comb = "v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\n\
                v 0 3 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n";
    for (file, faces, area) in [
        (arrow, &[4, 4][..], 3.0),
        (l, &[6], 5.0),
        (comb, &[12], 11.0),
    ] {
        let mesh = good(file);
        assert_eq!(arities(&mesh), faces);
        let areas = (0..mesh.face_count()).flat_map(|f| doubled_areas(&mesh, f));
        let covered: f64 = areas
            .inspect(|doubled| assert!(*doubled >= 0.0, "a triangle is turned over"))
            .sum::<f64>()
            / 2.0;
        assert!((covered - area).abs() < 1e-6, "{covered} {area}");
    }
    // A corner on a straight edge is no reason to change a polygon.
    let straight = good("v 0 0 0\nv 0.1 0.1 0\nv 0.3 0.3 0\nv 0 1 0\nf 1 2 3 4\n");
    assert_eq!(
        (arities(&straight), straight.corners[0].position),
        (vec![4], 0)
    );
}

/// Returns a model of one polygon.
fn one_polygon(points: &[DVec2]) -> Mesh {
    let mut text: String = points
        .iter()
        .map(|p| format!("v {} {} 0\n", p.x, p.y))
        .collect();
    text.push('f');
    (1..=points.len()).for_each(|k| text.push_str(&format!(" {k}")));
    good(text)
}

/// Returns whether a position is inside a polygon, by the crossings of a ray; `None` if it is next to an edge.
fn is_inside(points: &[DVec2], at: DVec2, near: f64) -> Option<bool> {
    let mut inside = false;
    for (k, &a) in points.iter().enumerate() {
        let b = points[(k + 1) % points.len()];
        let t = ((at - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        if at.distance(a.lerp(b, t)) < near {
            return None;
        }
        let crosses = (a.y > at.y) != (b.y > at.y);
        inside ^= crosses && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x);
    }
    Some(inside)
}

/// Returns a bar from x = −1 to 1 with pointed teeth, or with square ones that have a corner in the middle of each straight edge.
fn comb(teeth: u32, square: bool) -> Vec<DVec2> {
    let width = 2.0 / f64::from(teeth);
    let mut points = vec![DVec2::new(-1.0, -0.9), DVec2::new(1.0, -0.9)];
    for k in (0..teeth).rev() {
        let at = |x: f64, y: f64| DVec2::new(-1.0 + (f64::from(k) + x) * width, y);
        if square {
            points.extend([
                at(1.0, 0.0),
                at(1.0, 0.4),
                at(1.0, 0.8),
                at(0.7, 0.8),
                at(0.4, 0.8),
                at(0.4, 0.4),
                at(0.4, 0.0),
                at(0.2, 0.0),
            ]);
        } else {
            points.extend([at(1.0, -0.7), at(0.5, 0.9)]);
        }
    }
    if !square {
        points.push(DVec2::new(-1.0, -0.7));
    }
    points
}

#[test]
fn a_comb_of_any_number_of_corners_is_filled_as_a_comb() {
    const SIDE: u32 = 200;
    for (points, corners) in [
        (comb(200, false), 403),
        (comb(60, true), 482),
        (comb(700, false), 1403),
    ] {
        assert_eq!(points.len(), corners);
        let mesh = one_polygon(&points);
        let area: f64 = (0..mesh.face_count())
            .flat_map(|f| doubled_areas(&mesh, f))
            .sum();
        let expected = points
            .iter()
            .zip(points.iter().cycle().skip(1))
            .map(|(a, b)| a.perp_dot(*b))
            .sum::<f64>();
        assert!(
            (area - expected).abs() < 1e-5 * expected,
            "{corners}: {area}, expected {expected}"
        );
        assert_eq!(mesh.face_count(), 1, "one polygon");
        let triangles = mesh.face_triangles(0).flatten();
        let used: std::collections::HashSet<u32> =
            triangles.map(|corner| corner.position).collect();
        assert_eq!(used.len(), corners, "each corner belongs to a triangle");
        let mut scene = Scene::default();
        (scene.object.kind, scene.object.path) = (ObjectKind::Obj, Some("comb.obj".into()));
        (scene.camera.projection, scene.camera.height) = (Projection::Orthographic, 2.2);
        scene.image.size = [SIDE; 2];
        let mut renderer = Renderer::default().with_model(Some(std::sync::Arc::new(mesh)));
        renderer.keep_linear(true);
        renderer.render(&scene);
        let pixel = 2.2 / f64::from(SIDE);
        let mut compared = 0;
        for (k, [_, _, _, covered]) in (0..).zip(renderer.linear()) {
            let centre = DVec2::new(f64::from(k % SIDE) + 0.5, f64::from(SIDE - k / SIDE) - 0.5)
                * pixel
                - 1.1;
            let Some(inside) = is_inside(&points, centre, pixel / 64.0) else {
                continue;
            };
            compared += 1;
            assert_eq!(*covered > 0.0, inside, "{corners} corners, {centre}");
        }
        assert!(compared > SIDE * SIDE / 2, "{compared} pixels");
    }
}

/// Returns twice the areas of the triangles of a face in a plane z = constant.
fn doubled_areas(mesh: &Mesh, f: usize) -> impl Iterator<Item = f64> {
    mesh.face_triangles(f).map(|triangle| {
        let [a, b, c] = triangle.map(|corner| mesh.positions[corner.position as usize].as_dvec3());
        (b - a).cross(c - a).z
    })
}

/// Checks that polygons that cross themselves, which have no correct triangulation, are still read in finite time.
#[test]
fn a_tangle_of_many_corners_is_read() {
    let golden = |k: u32, part: f64| (f64::from(k) * part).fract() * 2.0 - 1.0;
    let points: Vec<DVec2> = (0..5000)
        .map(|k| DVec2::new(golden(k, 0.618_033_988), golden(k, 0.414_213_562)))
        .collect();
    assert_eq!(one_polygon(&points).face_count(), 1);
}

#[test]
fn far_models_keep_their_digits() {
    let mesh = good(
        "v 500000.125 4000000.25 0\nv 500001.125 4000000.25 0\nv 500000.125 4000001.375 0\nf 1 2 3\n",
    );
    let world: Vec<DVec3> = mesh
        .positions
        .iter()
        .map(|p| mesh.origin + p.as_dvec3())
        .collect();
    assert_eq!(world[2], DVec3::new(500_000.125, 4_000_001.375, 0.0));
    let fitted = mesh.fitted();
    assert_eq!(fitted.origin, DVec3::ZERO);
    let farthest = fitted
        .positions
        .iter()
        .map(|p| p.length())
        .fold(0.0, f32::max);
    assert!((farthest - 1.0).abs() < 1e-6);
}

#[test]
fn many_faces_make_one_mesh_and_progress_is_told() {
    let n = 300;
    let (mut file, mut faces) = (String::new(), String::new());
    for j in 0..=n {
        for i in 0..=n {
            file += &format!("v {i} {j} 0\nvn 0 {} 1\n", j % 7);
            if i < n && j < n {
                let at = |i: usize, j: usize| j * (n + 1) + i + 1;
                let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                faces += &format!("f {}\n", corners.map(|c| format!("{c}//{c}")).join(" "));
            }
        }
    }
    file += &faces;
    let mut told = Vec::new();
    let reader = BufReader::with_capacity(1000, Cursor::new(&file));
    let mesh = read_obj(reader, &mut |bytes| told.push(bytes)).expect("the model is sound");
    assert_eq!(
        (mesh.face_count(), mesh.positions.len()),
        (n * n, (n + 1) * (n + 1))
    );
    for corner in &mesh.corners {
        let y = mesh.positions[corner.position as usize].y;
        let expected = Vec3::new(0.0, y % 7.0, 1.0).normalize();
        assert!(mesh.normals[corner.normal as usize].distance(expected) < 1e-6);
    }
    assert!(told.len() > file.len() >> 18 && told.is_sorted());
    assert_eq!(told.last(), Some(&(file.len() as u64)));
}

#[test]
fn an_index_into_a_list_of_none_or_one_is_refused_in_words_that_make_sense() {
    for (file, line, expected) in [
        (
            "f 1 2 3\nv 0 0 0\n",
            1,
            english!("obj-no-such-vertex", number = 1, count = 0),
        ),
        (
            "v 0 0 0\nf -1 -2 1\n",
            2,
            english!("obj-no-such-vertex", number = "-2", count = 1),
        ),
        (
            &square("f 1//1 2//1 3//1\nvn 0 0 1\n"),
            5,
            english!("obj-no-such-normal", number = 1, count = 0),
        ),
    ] {
        assert_eq!(bad(file), (expected, Some(line)), "{file:?}");
        let (chinese, _) = in_language(Language::TraditionalChinese, || bad(file));
        assert!(
            !chinese.contains('0') && !chinese.contains("1 到 1"),
            "{chinese}"
        );
    }
}

#[test]
fn errors_name_the_line_and_what_was_expected() {
    let vertex = |number: u32| english!("obj-no-such-vertex", number = number, count = 4);
    let normal = english!("obj-no-such-normal", number = 1, count = 0);
    let few = |count: u32| english!("obj-few-vertices", count = count);
    let not_finite = |word: &str| english!("obj-not-finite", word = word);
    let two = |key: &str| english!("obj-few-numbers", count = 2, expected = english!(key));
    let malformed = |word: &str, expected: &str| {
        english!("obj-malformed", word = word, expected = english!(expected))
    };
    let cases: &[(&str, Option<u64>, &str)] = &[
        ("f 1 2 5\n", Some(5), &vertex(5)),
        ("f 0 1 2\n", Some(5), &vertex(0)),
        ("f -5 1 2\n", Some(5), "-4 to -1"),
        (
            "f 1 2 99999999999999999999999999\n",
            Some(5),
            "99999999999999999999999999",
        ),
        (
            "f 1 2 -9223372036854775808\n",
            Some(5),
            "-9223372036854775808",
        ),
        ("\n# x\nf 1//1 2 3\n", Some(7), &normal),
        ("f 1\n", Some(5), &few(1)),
        ("f 1 2 3\nf 1 2\n", Some(6), &few(2)),
        ("f\n", Some(5), &few(0)),
        ("f 1 2 x\n", Some(5), &malformed("x", "obj-corner")),
        ("f 1 2 3/1/1/1\n", Some(5), "`3/1/1/1`"),
        ("f 1 2 3.5\n", Some(5), "`3.5`"),
        ("f 1 2 3-\n", Some(5), "`3-`"),
        ("f 1 2 \\\n3 \\\nq\nv\n", Some(5), "`q`"),
        ("v 1 2\nf 1 2 3\n", Some(5), &two("obj-three-coordinates")),
        ("v 1 2 nan\nf 1 2 3\n", Some(5), &not_finite("nan")),
        ("v 1 -inf 2\nf 1 2 3\n", Some(5), &not_finite("-inf")),
        ("v 1 1e39 2\nf 1 2 3\n", Some(5), &not_finite("1e39")),
        ("v 1 1e999 2\nf 1 2 3\n", Some(5), &not_finite("1e999")),
        ("v 1 2 3 0\nf 1 2 3\n", Some(5), english!("obj-weight-zero")),
        (
            "v 1,5 2 3\nf 1 2 3\n",
            Some(5),
            &malformed("1,5", "obj-coordinate"),
        ),
        ("vn 0 1\nf 1 2 3\n", Some(5), &two("obj-three-components")),
        (
            "vn 0 1 z\nf 1 2 3\n",
            Some(5),
            &malformed("z", "obj-normal-component"),
        ),
        ("", None, english!("obj-no-face")),
        ("l 1 2\np 1\n", None, english!("obj-no-face")),
        ("f 1 1 1\n", None, english!("obj-no-face")),
        // Cut off in the middle of a line.
        ("f 1 2 3\nf 1 2", Some(6), &few(2)),
        ("f 1 2 3\nf 1/1 2/1 3/", Some(6), "`3/`"),
        ("f 1 2 3\nf 1 2 -", Some(6), "`-`"),
        ("f 1 2 3 \\", Some(5), "`\\`"),
        ("f 1 2 3\nv 1.0 2.", Some(6), &two("obj-three-coordinates")),
        ("f 1 2 3\nv 1.0 2.0 1e", Some(6), "`1e`"),
    ];
    for (rest, line, message) in cases {
        let (found, found_line) = bad(square(rest));
        assert!(found.contains(message), "{rest:?}: {found}");
        assert_eq!(found_line, *line, "{rest:?}: {found}");
    }
}

#[test]
fn what_is_no_model_at_all_is_refused() {
    assert_eq!(bad("").1, None);
    assert!(bad("").0.contains(english!("obj-empty")));
    let binary = bad([square("").as_bytes(), b"\x7fELF\x02\x01\x01\0\0\0"].concat());
    assert!(
        binary.0.contains(english!("obj-not-text")) && binary.1 == Some(5),
        "{binary:?}"
    );
    assert!(
        bad(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")
            .0
            .contains(english!("obj-not-text"))
    );
    assert!(
        bad("f 1 2 3\n"
            .encode_utf16()
            .flat_map(u16::to_le_bytes)
            .collect::<Vec<_>>())
        .0
        .contains(english!("obj-not-text"))
    );
    let long = english!("obj-line-too-long", longest = "|");
    let long = long.split('|').next().unwrap_or_default();
    assert!(bad(vec![b'x'; 3 << 20]).0.contains(long));
    assert!(
        bad("# only a comment\n")
            .0
            .contains(english!("obj-no-face"))
    );
    let in_a_number = bad([b"v 0 0 \xff1\n".as_slice()].concat());
    assert!(in_a_number.0.contains(english!("obj-coordinate")) && in_a_number.1 == Some(1));
    let message = bad(format!("f {}\n", "9".repeat(100_000))).0;
    assert!(message.len() < 300);
}

#[test]
fn a_reader_that_fails_is_an_error() {
    struct Broken;
    impl std::io::Read for Broken {
        fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("the disk is on fire"))
        }
    }
    let error = read_obj(BufReader::new(Broken), &mut |_| {}).expect_err("nothing can be read");
    assert!(matches!(error, ObjError::Read(_)) && error.to_string().contains("on fire"));
}

proptest! {
    #![proptest_config(properties::config(file!()))]

    #[test]
    fn no_text_makes_a_panic_or_a_normal_that_is_not_unit(
        words in proptest::collection::vec(
            prop_oneof![
                Just("v 0 0 0\n"), Just("v 1 0 0\n"), Just("v 0 1e-30 0\n"), Just("v 0 3e38 -3e38\n"), Just("f 1 2 3\n"),
                Just("f -1 -2 -3 -4\n"), Just("vn 1 0 0\n"), Just("vn 0 0 0\n"), Just("f 1//1 2//-1 3\n"), Just("v"),
                Just(" 1"), Just(" 2"), Just(" 3"), Just(" -1"), Just("\n"), Just("f"), Just("/"), Just("\\\n"),
                Just("o x\n"), Just("\u{e9}"), Just("#"), Just("v 1e30 1 1\n"), Just("f 1 2 3 4 5\n"), Just("v 1 1 1 0.5\n")
            ], 0..60)
    ) {
        if let Ok(mesh) = read(words.concat()) {
            prop_assert!(mesh.face_count() > 0);
            for mesh in [mesh.clone(), mesh.fitted()] {
                prop_assert!(mesh.positions.iter().all(|p| p.is_finite()));
                for source in [NormalSource::Averaged, NormalSource::File, NormalSource::Facet] {
                    for &weighting in Weighting::VALUES {
                        let vertices = mesh.with_vertex_normals(source, weighting);
                        prop_assert!(vertices.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-5));
                        prop_assert!(vertices.radius().is_finite());
                    }
                }
            }
        }
    }

    #[test]
    fn no_bytes_make_a_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200), cut in 0usize..900) {
        let _ = read(&bytes);
        let tower = std::fs::read("tests/data/obj/tower.obj").expect("the file is there");
        let mut damaged = tower[..cut.min(tower.len())].to_vec();
        damaged.extend(bytes);
        let _ = read(damaged);
    }
}
