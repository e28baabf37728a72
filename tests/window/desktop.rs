//! The real program in a real window, under Xvfb: it draws, takes a dragged slider, exports a picture that opens again, and then
//! becomes idle. Skipped, with a message, where Xvfb, xdotool or ImageMagick is not installed.

use crate::common::screen::{Running, screen};
use shading_lab::document::load_scene;
use shading_lab::render::Renderer;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The screen, the program on it, and a folder of its own.
struct Desktop {
    program: Running,
    display: String,
    _screen: Running,
    folder: PathBuf,
}

impl Drop for Desktop {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

fn installed(tool: &str) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).any(|folder| folder.join(tool).is_file())
}

/// Waits until `condition` holds.
fn wait(what: &str, mut condition: impl FnMut() -> bool) {
    let start = Instant::now();
    while !condition() {
        assert!(
            start.elapsed() < Duration::from_secs(60),
            "waited in vain for {what}"
        );
        sleep(Duration::from_millis(100));
    }
}

impl Desktop {
    fn start(scene: &str) -> Self {
        let folder =
            std::env::temp_dir().join(format!("shading-lab-desktop-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder for the test");
        let (screen, display) = screen(&[]);
        let program = Command::new(env!("CARGO_BIN_EXE_shading-lab"))
            .env_remove("LANGUAGE")
            .env("LC_ALL", "C")
            .arg(scene)
            .current_dir(&folder)
            .env("DISPLAY", &display)
            .env_remove("WAYLAND_DISPLAY")
            .env("XDG_DATA_HOME", &folder)
            .env("LIBGL_ALWAYS_SOFTWARE", "1")
            .spawn()
            .expect("the program starts");
        let mut desktop = Self {
            program: Running(program),
            display,
            _screen: screen,
            folder,
        };
        wait("the window", || {
            let ended = desktop.program.0.try_wait().expect("the program's state");
            assert!(
                ended.is_none(),
                "the program ended before it showed a window: {ended:?}"
            );
            let search = desktop
                .command(
                    "xdotool",
                    &["search", "--onlyvisible", "--name", "shading-lab"],
                )
                .output();
            search.is_ok_and(|output| output.status.success())
        });
        let window = desktop.run(
            "xdotool",
            &["search", "--onlyvisible", "--name", "shading-lab"],
        );
        desktop.run(
            "xdotool",
            &["windowfocus", window.lines().next().unwrap_or_default()],
        );
        desktop
    }

    fn command(&self, tool: &str, words: &[&str]) -> Command {
        let mut command = Command::new(tool);
        command.args(words).env("DISPLAY", &self.display);
        command
    }

    fn run(&self, tool: &str, words: &[&str]) -> String {
        let output = self
            .command(tool, words)
            .output()
            .expect("an installed tool");
        assert!(
            output.status.success(),
            "{tool} {words:?}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
        String::from_utf8_lossy(&output.stdout).trim().to_owned()
    }

    /// Returns the screen's pixels: 1280 × 800, red, green, blue.
    fn screen(&self) -> Vec<[u8; 3]> {
        let file = self.folder.join("screen.rgb");
        self.run(
            "import",
            &[
                "-window",
                "root",
                "-depth",
                "8",
                &format!("rgb:{}", file.display()),
            ],
        );
        let bytes = std::fs::read(&file).expect("a screenshot");
        assert_eq!(bytes.len(), 1280 * 800 * 3);
        bytes.as_chunks::<3>().0.to_vec()
    }

    fn ticks(&self) -> u64 {
        let path = format!("/proc/{}/stat", self.program.0.id());
        let stat = std::fs::read_to_string(path).expect("the program runs");
        let fields: Vec<&str> = stat
            .rsplit(')')
            .next()
            .unwrap_or_default()
            .split_whitespace()
            .collect();
        fields[11].parse::<u64>().expect("user ticks")
            + fields[12].parse::<u64>().expect("system ticks")
    }

    /// Waits until the program has nothing more to do.
    fn settle(&self) {
        let mut last = u64::MAX;
        wait("the program to rest", || {
            sleep(Duration::from_millis(400));
            let now = self.ticks();
            std::mem::replace(&mut last, now) == now
        });
    }
}

/// Counts the pixels between the panels that are clearly red, as the sphere is.
fn red(screen: &[[u8; 3]]) -> usize {
    let inside = |i: usize| (300..965).contains(&(i % 1280)) && (150..755).contains(&(i / 1280));
    screen
        .iter()
        .enumerate()
        .filter(|(i, [r, g, b])| inside(*i) && *r > 60 && *r / 2 > *g && *r / 2 > *b)
        .count()
}

/// Returns the sum of the red channel over the picture's area, in millions.
fn light(screen: &[[u8; 3]]) -> f64 {
    let inside = |i: usize| (300..965).contains(&(i % 1280)) && (150..755).contains(&(i / 1280));
    let red = |(i, pixel): (usize, &[u8; 3])| if inside(i) { u64::from(pixel[0]) } else { 0 };
    screen.iter().enumerate().map(red).sum::<u64>() as f64 / 1e6
}

#[test]
fn the_window_draws_takes_a_drag_exports_and_rests() {
    if let Some(missing) = ["Xvfb", "xdotool", "import"]
        .into_iter()
        .find(|tool| !installed(tool))
    {
        eprintln!(
            "skipped: {missing} is not installed (Debian packages xvfb, xdotool, imagemagick)"
        );
        return;
    }
    let desktop = Desktop::start("sphere");
    wait("the sphere", || red(&desktop.screen()) > 50_000);
    desktop.settle();
    let first = desktop.screen();

    // The slider of Kd, below the material and Ka in the panel at the left.
    let hand: [&[&str]; 5] = [
        &["mousemove", "157", "184"],
        &["mousedown", "1"],
        &["mousemove", "140", "184"],
        &["mousemove", "122", "184"],
        &["mouseup", "1"],
    ];
    for motion in hand {
        desktop.run("xdotool", motion);
        sleep(Duration::from_millis(200));
    }
    desktop.settle();
    let darker = desktop.screen();
    assert!(
        light(&darker) < 0.9 * light(&first),
        "less Kd, less light: {} and {}",
        light(&first),
        light(&darker)
    );

    desktop.run("xdotool", &["mousemove", "650", "740", "key", "ctrl+z"]);
    sleep(Duration::from_millis(300));
    desktop.settle();
    let back = light(&desktop.screen());
    assert!(
        (back / light(&first) - 1.0).abs() < 0.01,
        "undo brings the light back: {} and {back}",
        light(&first)
    );

    export_and_compare(&desktop);

    desktop.settle();
    // The window's state is saved every half minute, which may fall into one interval but not into all.
    let rests = (0..5).any(|_| {
        let before = desktop.ticks();
        sleep(Duration::from_secs(5));
        desktop.ticks() == before
    });
    assert!(rests, "an idle window uses no processor time");
}

/// Exports by keyboard; the written file must open as the same scene, which draws the same picture.
fn export_and_compare(desktop: &Desktop) {
    let target = desktop.folder.join("exported.png");
    desktop.run("xdotool", &["key", "ctrl+e"]);
    desktop.settle();
    // Chooses the window's own size, the first in the list; then replaces the path.
    desktop.run("xdotool", &["mousemove", "434", "305", "click", "1"]);
    desktop.settle();
    desktop.run("xdotool", &["mousemove", "560", "505", "click", "1"]);
    desktop.run("xdotool", &["key", "ctrl+a"]);
    desktop.run(
        "xdotool",
        &["type", "--delay", "20", &target.display().to_string()],
    );
    desktop.run("xdotool", &["key", "Return"]);
    wait("the exported picture", || target.is_file());
    let opened = load_scene(&target).expect("an exported picture opens");
    let mut expected = load_scene(Path::new("sphere"))
        .expect("a built-in scene")
        .scene;
    expected.image.size = opened.scene.image.size;
    assert_eq!(
        opened.scene, expected,
        "the scene inside the picture is the one on the screen"
    );
    let picture = Renderer::default().render(&opened.scene).clone();
    let [width, height] = opened.scene.image.size;
    // The picture's place on the screen: panels are 330 points wide at the left, bars 162 high on top.
    let matches = |screen: &[[u8; 3]], dx: u32, dy: u32| {
        let places = (0..height)
            .step_by(7)
            .flat_map(|y| (0..width).step_by(7).map(move |x| (x, y)));
        let same = |(x, y): &(u32, u32)| {
            let at = ((y + dy) * 1280 + x + dx) as usize;
            screen.get(at).is_some_and(|seen| {
                let drawn = picture.pixel(*x, *y).unwrap_or_default();
                seen.iter().zip(drawn).all(|(a, b)| a.abs_diff(b) <= 2)
            })
        };
        let total = places.clone().count();
        places.filter(same).count() as f64 / total as f64
    };
    // Without the vectors and their side view, the handles cover a few hundredths of it, as does the dialog until it has closed.
    desktop.settle();
    desktop.run("xdotool", &["key", "v"]);
    wait("the window to show the picture that is exported", || {
        let screen = desktop.screen();
        let places = (324..338).flat_map(|dx| (140..170).map(move |dy| (dx, dy)));
        places
            .map(|(dx, dy)| matches(&screen, dx, dy))
            .fold(0.0, f64::max)
            > 0.93
    });
}
