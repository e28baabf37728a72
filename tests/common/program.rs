//! The program in a folder of its own, as a script runs it.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A test's own folder, in which the program runs; removed when dropped.
pub struct Folder(pub PathBuf);

impl Folder {
    pub fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cli-{name}"));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.0.join(name), content).expect("a file");
    }

    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("a folder");
        let mut names: Vec<_> = entries
            .map(|entry| {
                entry
                    .expect("an entry")
                    .file_name()
                    .to_string_lossy()
                    .into_owned()
            })
            .collect();
        names.sort();
        names
    }

    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_shading-lab"));
        command
            .current_dir(&self.0)
            .env_remove("LANGUAGE")
            .env("LC_ALL", "C")
            .args(arguments)
            .stdin(Stdio::null());
        command
    }

    pub fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().expect("the program")
    }

    /// Runs the program, checks that it succeeds without errors, and returns its output.
    #[track_caller]
    pub fn prints(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(
            (output.status.code(), errors.as_str()),
            (Some(0), ""),
            "{arguments:?}"
        );
        String::from_utf8(output.stdout).expect("UTF-8")
    }

    #[track_caller]
    pub fn json(&self, arguments: &[&str]) -> Value {
        serde_json::from_str(&self.prints(arguments)).expect("JSON")
    }

    /// Checks that a run whose output nobody reads ends quietly.
    #[track_caller]
    pub fn ends_quietly(&self, arguments: &[&str]) {
        let mut command = self.command(arguments);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("the program");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("an end");
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{arguments:?}");
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
    }

    /// Checks that a run ends with `status`, prints exactly `errors` to stderr, as errors, and nothing to stdout.
    #[track_caller]
    pub fn fails(&self, arguments: &[&str], status: i32, errors: &[&str]) {
        let output = self.run(arguments);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        let said = |message: &&str| english!("cli-error", message = *message);
        let errors: Vec<_> = errors.iter().map(said).collect();
        assert_eq!(text.lines().collect::<Vec<_>>(), errors, "{arguments:?}");
        assert_eq!(output.status.code(), Some(status), "{arguments:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }

    /// Checks that a run is refused while its arguments are parsed.
    #[track_caller]
    pub fn refuses(&self, arguments: &[&str], expected: &str) {
        let output = self.run(arguments);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
        assert!(
            text.starts_with("error: ") && text.contains(expected),
            "{arguments:?}: {text}"
        );
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Returns the message about a position outside the picture.
pub fn outside(what: &str, last: &str) -> String {
    english!("cli-outside-picture", what = what, last = last)
}

/// Returns the message about a valid file that leaves every setting at its default.
pub fn sound(name: &str) -> String {
    let words = english!(
        "cli-check-sound",
        name = name,
        object = english!("choice-object-kind-sphere"),
        polygons = "",
        lights = 1,
        mode = english!("choice-shading-phong"),
        size = "768×768"
    );
    words + "\n"
}

pub fn size_of(png: &Path) -> (u32, u32) {
    let file = std::io::BufReader::new(fs::File::open(png).expect("a picture"));
    let reader = png::Decoder::new(file).read_info().expect("a header");
    reader.info().size()
}

pub fn pixels_of(png: &Path) -> Vec<u8> {
    let file = std::io::BufReader::new(fs::File::open(png).expect("a picture"));
    let mut reader = png::Decoder::new(file).read_info().expect("a header");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a small picture")];
    reader.next_frame(&mut pixels).expect("pixels");
    pixels
}
