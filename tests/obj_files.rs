//! OBJ files as they are met: the good ones load, the bad ones say what is wrong and where.

use shading_lab::geometry::{Mesh, read_obj};
use shading_lab::scene::{NormalSource, Weighting};
use std::fmt::Write;

fn read(text: impl AsRef<[u8]>) -> Result<Mesh, (Option<u64>, String)> {
    read_obj(text.as_ref(), &mut |_| {}).map_err(|error| (error.line(), error.to_string()))
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn good(text: impl AsRef<[u8]>) -> Mesh {
    let mesh = read(text).expect("a sound model");
    let vertices = mesh.with_vertex_normals(NormalSource::File, Weighting::Equal);
    assert!(vertices.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-4), "unit normals");
    mesh
}

fn bad(text: impl AsRef<[u8]>, line: Option<u64>, words: &str) {
    let (at, what) = read(text).expect_err("a model with an error");
    assert_eq!(at, line, "{what}");
    assert!(what.contains(words), "{what}");
}

#[test]
fn faces_keep_their_corners() {
    for corners in 3..=40_u32 {
        let mut text = String::new();
        for i in 0..corners {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(corners);
            writeln!(text, "v {} {} 0", angle.cos(), angle.sin()).expect("a string");
        }
        let list: Vec<String> = (1..=corners).map(|i| i.to_string()).collect();
        let mesh = good(format!("{text}f {}\n", list.join(" ")));
        assert_eq!((mesh.face_count(), mesh.face(0).len()), (1, corners as usize));
    }
}

#[test]
fn the_habits_of_real_files() {
    assert_eq!(good(format!("{SQUARE}f -4 -3 -2 -1\n")).face_count(), 1);
    assert_eq!(good(format!("\u{feff}{SQUARE}f 1 2 3 4\n").replace('\n', "\r\n")).positions.len(), 4);
    let mixed = good(format!("{SQUARE}vn 0 0 2\nf 1//1 2 3//1\nf 1 3 4\n"));
    let with: Vec<bool> = mixed.corners.iter().map(|c| c.normal != shading_lab::geometry::NO_NORMAL).collect();
    assert_eq!(with, [true, false, true, false, false, false]);
    assert_eq!(
        good(format!("mtllib none.mtl\no a\n{SQUARE}g one\nusemtl x\nf 1 2 3\ng two\nf 1 3 4\n")).face_count(),
        2
    );
    assert_eq!(good(format!("{SQUARE}v 9 9 9\nvt 0 0\nl 1 2\np 1\ns off\nf 1/1 2/1 3/1\n")).face_count(), 1);
    assert_eq!(good(format!("{SQUARE}f 1 2 \\\n3 4\n")).face(0).len(), 4);
    good("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 0.5 0.2 0.3\nf 1 2 3");
    good(format!("{SQUARE}f 1 2 3\nf 1 2 3\nf 1 1 2\nf 1 2 2\n"));
    let mut latin = SQUARE.as_bytes().to_vec();
    latin.extend_from_slice(b"# caf\xe9\nf 1 2 3\n");
    good(latin);
    // Faces may come before the vertices that they name.
    good("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
}

#[test]
fn a_closed_model_is_known_as_one() {
    let cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
                f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    assert!(good(cube).closed);
    assert!(!good(cube.replace("f 4 1 5 8\n", "")).closed);
}

#[test]
fn what_is_wrong_and_where() {
    bad(format!("{SQUARE}f 1 2 5\n"), Some(5), "vertex index 5 is out of range");
    bad(format!("{SQUARE}f 1 2 0\n"), Some(5), "index 0 is out of range");
    bad(format!("{SQUARE}f -5 -2 -1\n"), Some(5), "index -5 is out of range");
    bad(format!("{SQUARE}f 1//2 2//1 3//1\n"), Some(5), "normal index");
    bad(format!("{SQUARE}f 1 2 99999999999\n"), Some(5), "out of range");
    bad("v 0 0 0\nv NaN 0 0\n", Some(2), "not finite");
    bad("v 0 0 0\nv 1 0 inf\n", Some(2), "not finite");
    bad("v 0 0 1e39\n", Some(1), "not finite");
    bad("v 0 zero 0\n", Some(1), "not a number");
    bad(format!("{SQUARE}f 1 2\n"), Some(5), "a face of 2 vertices");
    bad(format!("{SQUARE}f 1\n"), Some(5), "a face of 1 vertices");
    bad(format!("{SQUARE}f 1 2 3\nv 0.5 0."), Some(6), "2 numbers, expected 3");
    bad(format!("{SQUARE}f 1 2 x\n"), Some(5), "not a corner");
    bad(SQUARE, None, "no face");
    bad("", None, "no face");
    bad(b"\x7fELF\x02\x01\x01\0\0\0\0", Some(1), "binary");
    bad("v 0 0 0\nv 1 \\\n2\nf 1 1 1\n", Some(3), "2 numbers");
}

#[test]
fn progress_is_told_while_reading() {
    let mut text = SQUARE.repeat(100_000);
    text.push_str("f 1 2 3\n");
    let mut told = Vec::new();
    read_obj(text.as_bytes(), &mut |bytes| told.push(bytes)).expect("a sound model");
    assert!(told.len() >= 3 && told.is_sorted());
    assert_eq!(told.last().copied(), Some(text.len() as u64));
}
