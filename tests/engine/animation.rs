//! Animations: the content and duration of each frame, and the requests that are refused.

use crate::common::program::{Folder, pixels_of};
use shading_lab::animation::{Course, FilmFormat, Sweep, SweepError, write_film};
use shading_lab::render::{Frame, Renderer};
use shading_lab::scene::{Scene, presets};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{BufReader, ErrorKind};

const STEPS: Course = Course {
    frames: 5,
    logarithmic: false,
    back_and_forth: false,
};

fn sweep(from: &[&str], to: &[&str], course: Course) -> Result<Sweep, SweepError> {
    Sweep::new(&Scene::default(), from, to, course)
}

#[test]
fn numbers_go_in_equal_steps_or_in_equal_ratios() {
    let exponents = |course| {
        let sweep = sweep(&["material.n=1"], &["material.n=10000"], course).expect("a sweep");
        sweep
            .scenes()
            .map(|scene| scene.material.n)
            .collect::<Vec<_>>()
    };
    assert_eq!(exponents(STEPS), [1.0, 2500.75, 5000.5, 7500.25, 10000.0]);
    let ratios = exponents(Course {
        logarithmic: true,
        back_and_forth: true,
        ..STEPS
    });
    for (found, expected) in ratios
        .iter()
        .zip([1.0, 10.0, 100.0, 1e3, 1e4, 1e3, 100.0, 10.0])
    {
        assert!((found / expected - 1.0).abs() < 1e-12, "{ratios:?}");
    }
    assert_eq!((ratios.len(), ratios[0], ratios[4]), (8, 1.0, 10_000.0));
}

#[test]
fn every_kind_of_number_changes_and_several_at_once() {
    let from = [
        "light.0.position=[-2,0,4]",
        "material.color=[0,0,0]",
        "material.ks=0.2",
        "object.segments=8",
        "camera.eye=0,0,4",
    ];
    let to = [
        "light.0.position=[2,1,4]",
        "material.color=[1,0.5,0]",
        "material.ks=[0.2,0.4,0.6]",
        "object.segments=13",
        "camera.eye=0,2,6",
    ];
    let all: Vec<Scene> = sweep(&from, &to, STEPS)
        .expect("a sweep")
        .scenes()
        .collect();
    let middle = &all[2];
    assert_eq!(middle.lights[0].position.to_array(), [0.0, 0.5, 4.0]);
    assert_eq!(middle.material.color.to_array(), [0.5, 0.25, 0.0]);
    let expected = [0.2, 0.3, 0.4];
    let found = middle.material.ks.to_array();
    assert!(
        found
            .iter()
            .zip(expected)
            .all(|(a, b)| (a - b).abs() < 1e-12),
        "{found:?}"
    );
    let segments: Vec<u32> = all.iter().map(|scene| scene.object.segments).collect();
    assert_eq!(segments, [8, 9, 11, 12, 13]);
    assert_eq!(
        all[4],
        Scene::default().with_overrides(&to).expect("a scene")
    );
    // A part of a point, as `--set` takes it.
    let parts = sweep(&["camera.eye.0=1"], &["camera.eye.0=3"], STEPS).expect("a sweep");
    let eyes: Vec<f64> = parts.scenes().map(|scene| scene.camera.eye.x).collect();
    assert_eq!(eyes, [1.0, 1.5, 2.0, 2.5, 3.0]);
}

#[test]
fn what_cannot_be_swept_is_named() {
    let ratios = Course {
        logarithmic: true,
        ..STEPS
    };
    let endless = Course {
        frames: 10_001,
        ..STEPS
    };
    for (from, to, course, expected) in [
        (
            "shading.mode=flat",
            "shading.mode=phong",
            STEPS,
            &*english!("animation-no-number", key = "shading.mode"),
        ),
        (
            "material.n=5",
            "material.ks=1",
            STEPS,
            &english!("animation-one-end", key = "material.n"),
        ),
        (
            "material.n=5",
            "material.n=inf",
            STEPS,
            &english!("animation-infinite", key = "material.n"),
        ),
        (
            "material.n=0",
            "material.n=9",
            ratios,
            &english!("animation-sign", key = "material.n"),
        ),
        (
            "material.n=5",
            "material.n=5",
            STEPS,
            english!("animation-nothing"),
        ),
        (
            "material.n=5",
            "material.n=9",
            endless,
            &english!("animation-frames", most = 10000),
        ),
        (
            "camera.eye=[0,0,4]",
            "camera.eye=[0,4]",
            STEPS,
            "camera.eye",
        ),
        ("material.n=5", "material.n=-9", STEPS, "`material.n`"),
        ("material.m=5", "material.m=9", STEPS, "`material.m`"),
        // Half-way, the eye is at its target.
        (
            "camera.eye=[0,0,4]",
            "camera.eye=[0,0,-4]",
            STEPS,
            "frame 2: ",
        ),
    ] {
        let error = sweep(&[from], &[to], course)
            .expect_err("a refusal")
            .to_string();
        assert!(error.contains(expected), "{from} {to}: {error}");
    }
}

fn drawn(format: FilmFormat, seconds: f64, frames: u32) -> Vec<u8> {
    let mut scene = Scene::default();
    scene.image.size = [40, 30];
    let course = Course { frames, ..STEPS };
    let (from, to) = (["material.n=1"], ["material.n=100"]);
    let sweep = Sweep::new(&scene, &from, &to, course).expect("a sweep");
    let mut renderer = Renderer::default();
    let mut film = Vec::new();
    let mut draw = |scene: &Scene| Some(renderer.render(scene).clone());
    write_film(&mut film, format, &sweep, seconds, &mut draw).expect("a film");
    film
}

#[test]
fn a_film_takes_as_long_as_it_should_whatever_the_units() {
    let film = drawn(FilmFormat::Gif, 0.5, 15);
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(&film[..]).expect("a GIF");
    let mut delays = Vec::new();
    while let Some(frame) = decoder.read_next_frame().expect("a frame") {
        assert_eq!((frame.width, frame.height), (40, 30));
        delays.push(frame.delay);
    }
    assert_eq!((delays.len(), delays.iter().sum::<u16>()), (15, 50));
    assert!(
        delays.iter().all(|delay| (3..=4).contains(delay)),
        "{delays:?}"
    );
    assert!(FilmFormat::Gif.check_seconds(15, 0.29).is_err());
    assert!(FilmFormat::Gif.check_seconds(15, 0.3).is_ok());
    assert!(FilmFormat::Apng.check_seconds(2, 200.0).is_err());
    assert!(FilmFormat::Apng.check_seconds(2, f64::NAN).is_err());
}

#[test]
fn a_film_that_is_stopped_leaves_nothing() {
    let folder = Folder::new("film-stopped");
    let sweep = sweep(&["material.n=1"], &["material.n=9"], STEPS).expect("a sweep");
    let mut left = 2;
    let mut draw = |_: &Scene| {
        left -= 1;
        (left > 0).then(|| Frame {
            width: 2,
            height: 1,
            pixels: vec![[0, 0, 0, 255]; 2],
        })
    };
    let path = folder.0.join("a.png");
    let format = FilmFormat::Apng;
    let stopped = shading_lab::document::save_film(&path, format, &sweep, 1.0, &mut draw);
    let Err(shading_lab::document::SaveError::Unwritable { source, .. }) = stopped else {
        panic!("a film that was stopped");
    };
    assert_eq!(source.kind(), ErrorKind::Interrupted);
    assert!(folder.names().is_empty());
}

const SMALL: [&str; 11] = [
    "animate",
    "sphere",
    "--set-from",
    "material.n=5",
    "--set-to",
    "material.n=1005",
    "--size",
    "24x16",
    "--frames",
    "4",
    "-o",
];

#[test]
fn an_animated_png_shows_each_frame_as_it_is_drawn_alone() {
    let folder = Folder::new("apng");
    folder.prints(&[&SMALL[..], &["a.png", "--seconds", "0.5"]].concat());
    folder.prints(&[&SMALL[..], &["frame-%03d.png"]].concat());
    let single = [
        "frame-001.png",
        "frame-002.png",
        "frame-003.png",
        "frame-004.png",
    ];
    assert_eq!(folder.names(), [&["a.png"][..], &single].concat());
    let file = BufReader::new(File::open(folder.0.join("a.png")).expect("a film"));
    let mut reader = png::Decoder::new(file).read_info().expect("a header");
    let control = *reader.info().animation_control().expect("an animation");
    assert_eq!((control.num_frames, control.num_plays), (4, 0));
    let mut buffer = vec![0; reader.output_buffer_size().expect("a size")];
    for name in single {
        reader.next_frame(&mut buffer).expect("a frame");
        let shown = reader.info().frame_control().expect("a frame").delay_num;
        assert_eq!(shown, 125);
        assert_eq!(buffer, pixels_of(&folder.0.join(name)), "{name}");
    }
    let exponent = |name: &str| {
        let loaded = shading_lab::document::load_scene(&folder.0.join(name));
        loaded.expect("a scene").scene.material.n
    };
    assert_eq!((exponent("a.png"), exponent(single[3])), (5.0, 1005.0));
    let first = fs::read(folder.0.join(single[0])).expect("a picture");
    folder.prints(&["render", single[0], "-o", "again.png"]);
    assert_eq!(
        fs::read(folder.0.join("again.png")).expect("a picture"),
        first
    );
    // To a pipe, back and forth.
    let piped = folder
        .run(&[&SMALL[..], &["-", "--back-and-forth"]].concat())
        .stdout;
    let reader = png::Decoder::new(std::io::Cursor::new(piped)).read_info();
    let reader = reader.expect("a film");
    assert_eq!(
        reader
            .info()
            .animation_control()
            .expect("an animation")
            .num_frames,
        6
    );
}

#[test]
fn a_gif_has_the_very_colours_where_they_are_few() {
    let folder = Folder::new("gif");
    let few = [
        "a.gif",
        "--set",
        "shading.mode=flat",
        "--set",
        "object.segments=6",
    ];
    folder.prints(&[&SMALL[..], &few].concat());
    let few = [
        "f%d.png",
        "--set",
        "shading.mode=flat",
        "--set",
        "object.segments=6",
    ];
    folder.prints(&[&SMALL[..], &few].concat());
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let file = BufReader::new(File::open(folder.0.join("a.gif")).expect("a film"));
    let mut decoder = options.read_info(file).expect("a GIF");
    for number in 1..=4 {
        let frame = decoder
            .read_next_frame()
            .expect("a frame")
            .expect("a frame");
        let shown: Vec<u8> = frame
            .buffer
            .chunks(4)
            .flat_map(|p| [p[0], p[1], p[2]])
            .collect();
        assert_eq!(shown, pixels_of(&folder.0.join(format!("f{number}.png"))));
    }
}

/// Returns the frames as drawn, each with its pixels in a GIF of them.
fn through_a_gif(name: &str, size: [u32; 2]) -> Vec<(Frame, Vec<u8>)> {
    let mut scene = presets::find(name).expect("built in").scene();
    scene.image.size = size;
    let ends = (["camera.roll=0"], ["camera.roll=30"]);
    let course = Course { frames: 2, ..STEPS };
    let sweep = Sweep::new(&scene, &ends.0, &ends.1, course).expect("a sweep");
    let (mut renderer, mut film, mut drawn) = (Renderer::default(), Vec::new(), Vec::new());
    let mut draw = |scene: &Scene| {
        drawn.push(renderer.render(scene).clone());
        drawn.last().cloned()
    };
    write_film(&mut film, FilmFormat::Gif, &sweep, 1.0, &mut draw).expect("a film");
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(&film[..]).expect("a GIF");
    let mut shown = Vec::new();
    while let Some(frame) = decoder.read_next_frame().expect("a frame") {
        shown.push(frame.buffer.to_vec());
    }
    drawn.into_iter().zip(shown).collect()
}

#[test]
fn a_gif_uses_all_of_its_palette_and_is_off_by_a_few_codes() {
    // Bounds that depend on the pictures' colours: many lights have more colours than a palette can approximate.
    for (name, size, most, rms) in [
        ("sphere", [48, 48], 2, 0.3),
        ("gold", [64, 64], 4, 0.6),
        ("rings", [80, 60], 4, 0.6),
        ("shadows", [96, 72], 8, 1.5),
        ("three-lights", [96, 96], 8, 1.5),
        ("colored-lights", [160, 120], 24, 3.0),
    ] {
        let frames = through_a_gif(name, size);
        assert_eq!(frames.len(), 2);
        for (frame, shown) in frames {
            let (mut drawn, mut used) = (BTreeSet::new(), BTreeSet::new());
            let (mut greatest, mut sum) = (0, 0.0);
            for (pixel, code) in frame.pixels.iter().zip(shown.chunks(4)) {
                drawn.insert(*pixel);
                used.insert(code.to_vec());
                assert_eq!(code[3], 255, "{name}: transparent");
                for (a, b) in pixel.iter().zip(code) {
                    greatest = greatest.max(a.abs_diff(*b));
                    sum += f64::from(a.abs_diff(*b)).powi(2);
                }
            }
            let mean = (sum / (3.0 * frame.pixels.len() as f64)).sqrt();
            assert!(
                greatest <= most && mean <= rms,
                "{name}: off by {greatest} codes, RMS {mean:.2}"
            );
            // Two boxes may have the same mean, once rounded.
            assert!(
                used.len() + 8 >= drawn.len().min(256),
                "{name}: {} of {} colours",
                used.len(),
                drawn.len()
            );
        }
    }
}

#[test]
fn what_makes_no_film_is_refused() {
    let folder = Folder::new("no-film");
    let base = ["animate", "cube", "--size", "8x8", "-o", "a.gif"];
    let seconds = english!("animation-seconds", least = "", most = "|");
    let seconds = seconds.split('|').next_back().unwrap_or_default();
    for (arguments, expected) in [
        (&["--set-from", "material.n=5"][..], "--set-to"),
        (
            &["--set-from", "material.n=x", "--set-to", "material.n=9"],
            "--set-from material.n=x: `material.n` is \"x\"",
        ),
        (
            &[
                "--set-from",
                "material.n=5",
                "--set-to",
                "material.n=9",
                "--frames",
                "1",
            ],
            &english!("cli-expected-whole", low = 2, high = 10000),
        ),
        (
            &[
                "--set-from",
                "material.n=5",
                "--set-to",
                "material.n=9",
                "--fps",
                "100",
            ],
            seconds,
        ),
        (
            &[
                "--set-from",
                "material.n=5",
                "--set-to",
                "material.n=9",
                "--fps",
                "0",
            ],
            seconds,
        ),
    ] {
        folder.refuses(&[&base[..], arguments].concat(), expected);
    }
    folder.refuses(
        &[&SMALL[..], &["a.webm"]].concat(),
        english!("cli-expected-film"),
    );
    folder.refuses(
        &[&SMALL[..], &["a-%02d.gif"]].concat(),
        english!("cli-expected-png"),
    );
    assert!(folder.names().is_empty());
}
