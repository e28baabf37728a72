//! Golden pictures of the commands' other figures: comparisons, differences, defects, profiles, the scan line. Each is drawn by
//! its command and compared with an approved picture.
//!
//! `UPDATE_GOLDEN=1` replaces the approved pictures, and the run still fails, so that they are reviewed before they are
//! committed.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Maximum difference of a channel: machines with and without fused multiplication round differently.
const ROUNDING: u8 = 2;
/// One pixel in this many may differ by more: along the edges of letters and lines a rounding decides.
const AT_EDGES: usize = 200;

/// The figures, each as a name and a command without its output.
const FIGURES: &[(&str, &str)] = &[
    ("panes", "render highlight --size 560x420 -o"),
    (
        "wipe",
        "render flat-facets --pane shading.mode=exact --compare wipe --size 320x320 -o",
    ),
    (
        "difference-signed",
        "render silhouette --compare difference --size 360x300 -o",
    ),
    (
        "difference-absolute",
        "render silhouette --compare difference --set compare.difference=absolute --size 360x300 -o",
    ),
    (
        "difference-false-color",
        "render silhouette --compare difference --set compare.difference=false-color --set compare.gain=2 --size 360x300 -o",
    ),
    (
        "perspective",
        "render perspective-distortion --compare wipe --size 400x300 -o",
    ),
    (
        "cued-by-pixel",
        "render depth-cueing --pane depth_cueing.by=pixel --size 600x300 -o",
    ),
    (
        "silhouette",
        "render silhouette --overlay defects --size 640x320 -o",
    ),
    (
        "shared-vertices",
        "render shared-vertices --overlay defects --size 640x320 -o",
    ),
    (
        "orientation-curve",
        "defects orientation --pixel 500,300 -o",
    ),
    (
        "shared-edge-curve",
        "defects shared-vertices --pixel 500,300 -o",
    ),
    (
        "scan-line",
        "scanline orientation --rows 14 --step 40 --size 640x480 -o",
    ),
    (
        "profile-over-picture",
        "render mach-bands --overlay profile --size 400x400 -o",
    ),
    (
        "profile",
        "profile mach-bands --from 100,384 --to 668,384 --modes gouraud,phong --size 800x640 -o",
    ),
    (
        "perceived",
        "profile mach-bands --from 100,384 --to 668,384 --set image.size=[768,768] --picture",
    ),
];

fn kept(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/golden/figures")
        .join(format!("{name}.png"))
}

/// Reads the size and the bytes of a picture.
fn read(path: &Path) -> Option<([u32; 2], Vec<u8>)> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).ok()?))
        .read_info()
        .ok()?;
    let mut bytes = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut bytes).ok()?;
    bytes.truncate(info.buffer_size());
    Some(([info.width, info.height], bytes))
}

fn draw(name: &str, command: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("figures");
    fs::create_dir_all(&folder).expect("the folder is made");
    let target = folder.join(format!("{name}.png"));
    let output = Command::new(env!("CARGO_BIN_EXE_shading-lab"))
        .env_remove("LANGUAGE")
        .env("LC_ALL", "C")
        .args(command.split(' '))
        .arg(&target)
        .output()
        .expect("the program runs");
    assert!(
        output.status.success(),
        "{name}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    target
}

/// Compares a figure with the approved picture; returns a description of the difference, if any.
fn compare(name: &str, actual: &Path) -> Option<String> {
    let Some((size, expected)) = read(&kept(name)) else {
        return Some(format!("{name}: no picture is kept"));
    };
    let Some((drawn, actual)) = read(actual) else {
        return Some(format!("{name}: no picture was drawn"));
    };
    if drawn != size || actual.len() != expected.len() {
        return Some(format!("{name}: {drawn:?} instead of {size:?} pixels"));
    }
    let pixels = size.iter().map(|side| *side as usize).product::<usize>();
    let channels = (expected.len() / pixels.max(1)).max(1);
    let differs =
        |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > ROUNDING);
    let off = actual
        .chunks(channels)
        .zip(expected.chunks(channels))
        .filter(differs)
        .count();
    (off > pixels / AT_EDGES).then(|| format!("{name}: {off} of {pixels} pixels differ"))
}

#[test]
fn every_figure_is_drawn_as_it_was() {
    let update = std::env::var_os("UPDATE_GOLDEN").is_some();
    let mut wrong = Vec::new();
    for (name, command) in FIGURES {
        let drawn = draw(name, command);
        if let Some(message) = compare(name, &drawn) {
            if update {
                fs::create_dir_all(kept(name).parent().expect("a folder"))
                    .expect("the folder is made");
                fs::copy(&drawn, kept(name)).expect("copied");
            }
            wrong.push(message);
        }
    }
    assert!(
        wrong.is_empty(),
        "{}{}",
        wrong.join("\n"),
        if update {
            "\nreplaced: look at them"
        } else {
            ""
        }
    );
}

#[test]
fn no_figure_is_kept_that_is_not_drawn() {
    for entry in
        fs::read_dir(kept("panes").parent().expect("a folder")).expect("the folder of kept figures")
    {
        let name = entry
            .expect("an entry")
            .path()
            .file_stem()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        assert!(FIGURES.iter().any(|(known, _)| *known == name), "{name}");
    }
}
