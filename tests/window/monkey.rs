//! A monkey at the window: random clicks, drags, turns of the wheel, keys and typed text, on every view and every dialog.
//!
//! It looks for panics on any thread, frames that do not end, unbounded memory, and drawings that are not finite or reach far out
//! of sight. An episode is a window on a random scene and some hundred steps; its number is the seed of all of it. The same seed
//! takes the same steps, unless background work finishes sooner or later.
//!
//! The monkey runs in a process of its own, in an empty folder that is also its home, without a display and without a message
//! bus: files that it saves by chance land there, and the desktop's file dialog cannot open.
//!
//! `cargo test --test window monkey` runs a fixed number of episodes, about a minute. For longer, or to repeat one episode:
//!
//! ```sh
//! MONKEY_MINUTES=60 MONKEY_SEED=1000 cargo test --test window monkey -- --nocapture   # episodes 1000, 1001, … for an hour
//! MONKEY_MINUTES=0 MONKEY_SEED=1234 cargo test --test window monkey -- --nocapture    # episode 1234, every step printed
//! ```

use crate::common::any_scene::any_scene;
use crate::common::dice::Dice;
use crate::common::fuzz::any_lesson;
use crate::common::hands;
use crate::common::monkey::act;
use eframe::egui::Shape;
use egui_kittest::Harness;
use shading_lab::app::App;
use shading_lab::document::{Loaded, load_scene};
use shading_lab::scene::{Scene, presets};
use std::path::Path;
use std::process::{Command, Stdio, abort};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Episodes of an ordinary run.
const EPISODES: u64 = 36;
/// Steps of an episode.
const STEPS: u32 = 120;
/// Time after which a frame counts as endless: far more than the slowest frame needs on the slowest machine.
const LONGEST_FRAME: Duration = Duration::from_secs(120);
/// Maximum size of the resident set, bytes.
const MOST_MEMORY: u64 = 4 << 30;
/// Maximum number of vertices of a drawing.
const MOST_VERTICES: usize = 4_000_000;
/// Maximum width and height of a line or an area, points.
const WIDEST: f32 = 20_000.0;
/// Number of polygons round an object above which slow frames are expected.
const FINE: u32 = 512;
/// Environment variables by which a program finds a display or a message bus.
const DESKTOP: [&str; 4] = [
    "DISPLAY",
    "WAYLAND_DISPLAY",
    "WAYLAND_SOCKET",
    "DBUS_SESSION_BUS_ADDRESS",
];

#[test]
fn a_monkey_at_the_window_finds_nothing() {
    let folder = std::env::temp_dir().join(format!("shading-lab-monkey-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the monkey");
    let mut command = Command::new(std::env::current_exe().expect("this program"));
    command.args(["--exact", "monkey::the_monkey", "--ignored", "--nocapture"]);
    command
        .current_dir(&folder)
        .stdin(Stdio::null())
        .env("MONKEY_CAGE", &folder);
    for name in ["HOME", "XDG_RUNTIME_DIR", "XDG_DATA_HOME", "TMPDIR"] {
        command.env(name, &folder);
    }
    for name in DESKTOP {
        command.env_remove(name);
    }
    let status = command.status().expect("the monkey starts");
    let _ = std::fs::remove_dir_all(&folder);
    assert!(
        status.success(),
        "the monkey found something, see above: {status}"
    );
}

#[test]
#[ignore = "runs in a process that the other test starts"]
fn the_monkey() {
    if std::env::var_os("MONKEY_CAGE").is_none() {
        return;
    }
    let number = |name: &str| {
        std::env::var(name)
            .ok()
            .map(|text| text.parse::<u64>().expect("a whole number"))
    };
    let (minutes, first) = (number("MONKEY_MINUTES"), number("MONKEY_SEED").unwrap_or(0));
    std::panic::set_hook(Box::new(|panic| found(&panic.to_string())));
    std::thread::spawn(watch);
    let began = Instant::now();
    let goes_on = |done: u64| match minutes {
        None => done < EPISODES,
        Some(minutes) => done == 0 || began.elapsed() < Duration::from_secs(60 * minutes),
    };
    let seeds = (0..)
        .take_while(|done| goes_on(*done))
        .map(|done| first + done);
    for seed in seeds {
        episode(seed, minutes == Some(0));
    }
}

/// The progress of the current episode, to be reported with a finding.
struct Diary {
    seed: u64,
    steps: Vec<String>,
    frame: Instant,
}

static DIARY: Mutex<Option<Diary>> = Mutex::new(None);

fn diary<T>(write: impl FnOnce(&mut Diary) -> T) -> T {
    let mut diary = DIARY
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner);
    write(diary.get_or_insert_with(|| Diary {
        seed: 0,
        steps: Vec::new(),
        frame: Instant::now(),
    }))
}

/// Prints a finding and the steps that led to it, and aborts the process: its threads may be unable to go on.
fn found(what: &str) {
    diary(|Diary { seed, steps, .. }| {
        eprintln!("episode {seed}, step {}: {what}", steps.len());
        for (number, step) in steps
            .iter()
            .enumerate()
            .skip(steps.len().saturating_sub(25))
        {
            eprintln!("  {}: {step}", number + 1);
        }
    });
    abort();
}

/// Aborts the process when a frame does not end or memory runs out.
fn watch() {
    loop {
        std::thread::sleep(Duration::from_millis(20));
        if diary(|diary| diary.frame.elapsed()) > LONGEST_FRAME {
            found(&format!(
                "a frame takes more than {} s",
                LONGEST_FRAME.as_secs()
            ));
        }
        if resident().is_some_and(|bytes| bytes > MOST_MEMORY) {
            found(&format!("more than {} MiB of memory", MOST_MEMORY >> 20));
        }
    }
}

/// Returns the bytes of the resident set, where the system reports them.
fn resident() -> Option<u64> {
    let pages = std::fs::read_to_string("/proc/self/statm").ok()?;
    Some(pages.split(' ').nth(1)?.parse::<u64>().ok()? * 4096)
}

/// Returns the scene that an episode begins with: a built-in one, or any that may be opened.
fn beginning(dice: &mut Dice, seed: u64) -> Loaded {
    let any = any_scene(seed);
    if dice.unit() < 0.3 && any.scene.validate().is_ok() && any.model.is_ok() {
        let model = any.model.ok().flatten();
        return Loaded {
            shown: Default::default(),
            scene: any.scene,
            model,
            name: format!("scene {seed}"),
            path: None,
        };
    }
    let preset = &presets::ALL[(dice.unit() * presets::ALL.len() as f64) as usize];
    load_scene(Path::new(preset.name)).expect("a built-in scene")
}

/// Returns whether drawing a scene is expected to be so slow that little else would be tried.
fn slow(scene: &Scene) -> bool {
    let samples: u64 = scene
        .lights
        .iter()
        .map(|light| u64::from(light.samples))
        .sum();
    scene.object.segments.max(scene.object.rings) > FINE || samples > 128
}

fn episode(seed: u64, told: bool) {
    let mut dice = Dice(seed.wrapping_mul(0x2545_f491_4f6c_dd1d));
    let loaded = beginning(&mut dice, seed);
    diary(|diary| {
        *diary = Diary {
            seed,
            steps: vec![format!("opens {}", loaded.name)],
            frame: Instant::now(),
        };
    });
    if told {
        eprintln!("opens {}\n{}", loaded.name, loaded.scene.to_toml());
    }
    let lesson = (dice.unit() < 0.3).then(|| any_lesson(&mut dice));
    if let Some(lesson) = &lesson {
        let what = format!("goes through the lesson:\n{}", lesson.source);
        diary(|diary| diary.steps.push(what));
    }
    let began = Instant::now();
    // A window shows a box for a letter that its fonts lack.
    let builder = Harness::builder()
        .with_size([800.0, 500.0])
        .allow_missing_glyphs()
        .renderer(hands::Nowhere);
    let mut harness =
        builder.build_eframe(|cc| App::new(cc, loaded).with_lesson(lesson, Some(seed)));
    harness.input_mut().max_texture_side = Some(16_384);
    let mut longest = (Duration::ZERO, String::new());
    for _ in 0..STEPS {
        let (what, events) = act(&mut harness, &mut dice);
        if told {
            eprintln!("{what}");
        }
        diary(|diary| diary.steps.push(what));
        for event in events.into_iter().map(Some).chain([None, None]) {
            diary(|diary| diary.frame = Instant::now());
            if let Some(event) = event {
                harness.event(event);
            }
            harness.step();
            check(&harness);
            let took = diary(|diary| diary.frame.elapsed());
            if took > longest.0 {
                longest = (
                    took,
                    diary(|diary| diary.steps.last().cloned().unwrap_or_default()),
                );
            }
        }
        if slow(hands::scene(&harness)) {
            break;
        }
    }
    let steps = diary(|diary| diary.steps.len());
    println!(
        "episode {seed}: {steps} steps in {:.1} s, {} MiB, the longest frame {:.2} s: {}",
        began.elapsed().as_secs_f64(),
        resident().unwrap_or(0) >> 20,
        longest.0.as_secs_f64(),
        longest.1,
    );
}

/// Checks that the data for the graphics card are finite, within sight, and not too large.
fn check(harness: &Harness<'_, App>) {
    let shapes = &harness.output().shapes;
    for clipped in shapes {
        if let Some(shape) = stray(&clipped.shape) {
            found(&format!("reaches too far, or is no number: {shape:?}"));
        }
    }
    let meshes = harness
        .ctx
        .tessellate(shapes.clone(), harness.ctx.pixels_per_point());
    let vertices: usize = meshes
        .iter()
        .map(|mesh| match &mesh.primitive {
            eframe::egui::epaint::Primitive::Mesh(mesh) => mesh.vertices.len(),
            eframe::egui::epaint::Primitive::Callback(_) => 0,
        })
        .sum();
    if vertices > MOST_VERTICES {
        found(&format!("{vertices} vertices in a frame"));
    }
}

/// Returns a part of a shape that is not finite or reaches far out of sight. Text may be long: it is clipped when drawn.
fn stray(shape: &Shape) -> Option<&Shape> {
    match shape {
        Shape::Vec(shapes) => shapes.iter().find_map(stray),
        Shape::Noop | Shape::Text(_) | Shape::Callback(_) => None,
        shape => {
            let points = match shape {
                Shape::LineSegment { points, .. } => &points[..],
                Shape::Path(path) => &path.points,
                _ => &[],
            };
            let bounds = shape.visual_bounding_rect();
            let fits = bounds.is_finite() && bounds.size().max_elem() <= WIDEST;
            let nothing = bounds.min.x > bounds.max.x;
            let sound = points.iter().all(|point| point.is_finite()) && (fits || nothing);
            (!sound).then_some(shape)
        }
    }
}

#[test]
fn what_strays_is_found() {
    use eframe::egui::{Color32, Stroke, pos2};
    let line = |to| Shape::line(vec![pos2(0.0, 0.0), to], Stroke::new(1.0, Color32::WHITE));
    assert!(stray(&line(pos2(10.0, 10.0))).is_none());
    for to in [
        pos2(1e6, 0.0),
        pos2(f32::NAN, 0.0),
        pos2(0.0, f32::INFINITY),
    ] {
        assert!(
            stray(&Shape::Vec(vec![line(pos2(1.0, 1.0)), line(to)])).is_some(),
            "{to:?}"
        );
    }
}
