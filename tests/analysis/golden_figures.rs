//! Golden pictures of the commands' other figures: comparisons, differences, defects, profiles, the scan line. Each is drawn by
//! its command and compared with an approved picture.

use crate::common::golden::{self, Golden};
use std::fs;
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

const GOLDEN: Golden = Golden("figures");

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
    let Some((size, expected)) = golden::read(&GOLDEN.kept(name)) else {
        return Some(format!("{name}: no picture is kept"));
    };
    let Some((drawn, actual)) = golden::read(actual) else {
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
    let drawn = FIGURES
        .iter()
        .map(|(name, command)| (*name, draw(name, command)));
    let compare = |name: &str, drawn: &PathBuf| compare(name, drawn);
    GOLDEN.check(drawn, compare, |path, drawn| {
        fs::copy(drawn, path).expect("copied");
    });
}

#[test]
fn no_figure_is_kept_that_is_not_drawn() {
    GOLDEN.has_only(|name| FIGURES.iter().any(|(known, _)| *known == name));
}
