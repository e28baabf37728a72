//! Opening the window, or reporting in a sentence why it does not open.

use crate::app::App;
#[cfg(feature = "class")]
use crate::class::Live;
use crate::document::Loaded;
use crate::lesson::Lesson;
use crate::text::{Language, text};
use eframe::egui::ViewportBuilder;
use std::path::PathBuf;

/// The libraries that the window loads at its start, each with its Debian package.
const X11_LIBRARIES: [(&str, &str); 5] = [
    ("libX11.so.6", "libx11-6"),
    ("libX11-xcb.so.1", "libx11-xcb1"),
    ("libXcursor.so.1", "libxcursor1"),
    ("libXi.so.6", "libxi6"),
    ("libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
];

/// The program's icon.
const ICON: &[u8] = include_bytes!("../../assets/web/icon-192.png");

/// The state that the window starts with.
pub struct Start {
    /// The scene.
    pub loaded: Loaded,
    /// An opened lesson from a file.
    pub lesson: Option<Lesson>,
    /// The seed of random numbers in lessons.
    pub seed: Option<u64>,
    /// The language; overrides that of the last session.
    pub language: Option<Language>,
    /// The address that links begin with; overrides that of the last session.
    pub page: Option<String>,
    /// True to read nothing that an earlier session stored, and to store nothing.
    pub fresh: bool,
    /// The live class that the window is for; it is over when the window is closed.
    #[cfg(feature = "class")]
    pub class: Option<Live>,
}

/// Opens the window and returns when it is closed.
///
/// # Errors
/// No display, or a required library is missing; in a sentence.
pub fn run(start: Start) -> Result<(), String> {
    let Start {
        loaded,
        lesson,
        seed,
        language,
        page,
        fresh,
        #[cfg(feature = "class")]
        class,
    } = start;
    check_environment()?;
    let viewport = ViewportBuilder::default()
        .with_title("shading-lab")
        .with_app_id("shading-lab")
        .with_inner_size([1280.0, 800.0])
        .with_min_inner_size([360.0, 360.0]);
    let viewport = match eframe::icon_data::from_png_bytes(ICON) {
        Ok(icon) => viewport.with_icon(icon),
        Err(_) => viewport,
    };
    let options = eframe::NativeOptions {
        viewport,
        persist_window: !fresh,
        ..eframe::NativeOptions::default()
    };
    let open = |cc: &eframe::CreationContext<'_>| -> Box<dyn eframe::App> {
        let app = App::new(cc, loaded);
        let app = if fresh { app.fresh(&cc.egui_ctx) } else { app };
        let app = app.with_welcome().in_language(language);
        #[cfg_attr(
            not(feature = "class"),
            expect(unused_mut, reason = "a class changes it")
        )]
        let mut app = app.with_page(page).with_lesson(lesson, seed);
        #[cfg(feature = "class")]
        if let Some(class) = class {
            app.teach(&cc.egui_ctx, class);
        }
        let folder = eframe::storage_dir("shading-lab").map(|folder| folder.join("recovery"));
        Box::new(match folder.filter(|_| !fresh) {
            Some(folder) => app.with_recovery(&folder),
            None => app,
        })
    };
    eframe::run_native("shading-lab", options, Box::new(|cc| Ok(open(cc)))).map_err(|error| {
        match error {
            eframe::Error::NoGlutinConfigs(..)
            | eframe::Error::Glutin(_)
            | eframe::Error::OpenGL(_) => {
                text!("no-opengl", error = error.to_string())
            }
            _ => text!("no-window", error = error.to_string()),
        }
    })
}

/// Checks for the display and the libraries, before their absence causes a panic.
fn check_environment() -> Result<(), String> {
    let set = |name: &str| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    if !cfg!(target_os = "linux") || set("WAYLAND_DISPLAY") || set("WAYLAND_SOCKET") {
        return Ok(());
    }
    if !set("DISPLAY") {
        return Err(text!("no-display").to_owned());
    }
    match X11_LIBRARIES
        .into_iter()
        .find(|(library, _)| !is_installed(library))
    {
        Some((library, package)) => Err(text!("no-library", library = library, package = package)),
        None => Ok(()),
    }
}

/// Returns whether the dynamic linker would find a library: in its cache, in its usual folders, or in those of
/// `LD_LIBRARY_PATH`. If the cache cannot be read, assumes that the library is installed.
fn is_installed(library: &str) -> bool {
    let Ok(cache) = std::fs::read("/etc/ld.so.cache") else {
        return true;
    };
    let named = |bytes: &[u8]| {
        bytes
            .windows(library.len())
            .any(|window| window == library.as_bytes())
    };
    let told = std::env::var_os("LD_LIBRARY_PATH").unwrap_or_default();
    let mut folders: Vec<_> = std::env::split_paths(&told).collect();
    folders.extend(["/lib", "/usr/lib", "/lib64", "/usr/lib64"].map(PathBuf::from));
    named(&cache) || folders.iter().any(|folder| folder.join(library).exists())
}
