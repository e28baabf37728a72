//! The time from starting the program to its window's first picture, measured alternately with an empty window of the same
//! toolkit: `cargo bench --bench start`. It needs Xvfb and prints the measurements.
//!
//! Xvfb keeps its screen in a file, which is read every other millisecond: the times are accurate to 5 ms, reading and comparing
//! included. A window counts as shown once most of the screen's pixels have changed, and its picture once all but one pixel in a
//! hundred have their final colour.

#[path = "../common/screen.rs"]
mod screen;

use eframe::egui;
use screen::Running;
use std::path::Path;
use std::process::Command;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Measured starts of either program; one more of each warms the file caches.
const STARTS: usize = 7;
/// Time without a change after which a screen counts as finished.
const QUIET: Duration = Duration::from_millis(1500);
const LONGEST: Duration = Duration::from_secs(60);
const POLL: Duration = Duration::from_millis(2);
/// Bytes of a pixel of the screen.
const PIXEL: usize = 4;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if words.iter().any(|word| word == "--empty-window") {
        empty_window();
    } else if words.iter().any(|word| word == "--bench") {
        measure();
    }
}

/// Opens a window with nothing in it, with the program's own options.
fn empty_window() {
    let viewport = egui::ViewportBuilder::default().with_inner_size([1280.0, 800.0]);
    let options = eframe::NativeOptions {
        viewport,
        ..eframe::NativeOptions::default()
    };
    eframe::run_native("empty", options, Box::new(|_| Ok(Box::new(Empty)))).expect("a window");
}

struct Empty;

impl eframe::App for Empty {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        ui.label("");
    }
}

/// Milliseconds to the window, and to the picture in it.
#[derive(Clone, Copy)]
struct Start {
    window: f64,
    picture: f64,
}

fn measure() {
    let folder = std::env::temp_dir().join(format!("shading-lab-start-{}", std::process::id()));
    // Times the first picture, without the smoother one that follows it.
    let stored = folder.join("shading-lab");
    std::fs::create_dir_all(&stored).expect("a folder for the test");
    std::fs::write(
        stored.join("app.ron"),
        r#"{"look": "(look:(smooth_edges:false))"}"#,
    )
    .expect("a stored look");
    let own = std::env::current_exe().expect("this program");
    let mut starts: [Vec<Start>; 2] = Default::default();
    for round in 0..=STARTS {
        let mut empty = Command::new(&own);
        empty.arg("--empty-window");
        for (starts, program) in starts
            .iter_mut()
            .zip([empty, Command::new(env!("CARGO_BIN_EXE_shading-lab"))])
        {
            let start = time(program, &folder);
            if round > 0 {
                starts.push(start);
            }
        }
    }
    let _ = std::fs::remove_dir_all(&folder);
    let told = |name: &str, get: fn(&Start) -> f64| {
        let [empty, program] = starts
            .each_ref()
            .map(|starts| median(starts.iter().map(get).collect()));
        println!(
            "{name}: empty {empty:.0} ms, shading-lab {program:.0} ms, {:.2} times",
            program / empty
        );
    };
    told("window", |start| start.window);
    told("picture", |start| start.picture);
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Starts `program` on a screen of its own and times what appears there.
fn time(mut program: Command, folder: &Path) -> Start {
    let (_server, display) = screen::screen(&["-fbdir", folder.to_str().expect("a plain name")]);
    let screen = || std::fs::read(folder.join("Xvfb_screen0")).expect("Xvfb's screen");
    let before = screen();
    program
        .env("DISPLAY", display)
        .env_remove("WAYLAND_DISPLAY")
        .env("XDG_DATA_HOME", folder)
        .env("LIBGL_ALWAYS_SOFTWARE", "1");
    let began = Instant::now();
    let _program = Running(program.spawn().expect("the program starts"));
    let mut seen: Vec<(Duration, Vec<u8>)> = Vec::new();
    loop {
        let now = screen();
        let elapsed = began.elapsed();
        let last = seen.last().map_or(&before, |(_, screen)| screen);
        if now != *last {
            seen.push((elapsed, now));
        } else if seen
            .last()
            .is_some_and(|(when, screen)| most(screen, &before) && elapsed > *when + QUIET)
        {
            break;
        }
        assert!(elapsed < LONGEST, "no window appeared, or it never rests");
        sleep(POLL);
    }
    let (_, end) = seen.last().expect("something was seen");
    let first = |there: &dyn Fn(&[u8]) -> bool| {
        let (when, _) = seen
            .iter()
            .find(|(_, screen)| there(screen))
            .expect("the end at least");
        when.as_secs_f64() * 1e3
    };
    let pixels = end.len() / PIXEL;
    Start {
        window: first(&|screen| most(screen, &before)),
        picture: first(&|screen| different(screen, end) <= pixels / 100),
    }
}

fn most(screen: &[u8], before: &[u8]) -> bool {
    different(screen, before) > screen.len() / PIXEL / 2
}

/// Counts the pixels that differ.
fn different(a: &[u8], b: &[u8]) -> usize {
    a.chunks(PIXEL)
        .zip(b.chunks(PIXEL))
        .filter(|(a, b)| a != b)
        .count()
}
