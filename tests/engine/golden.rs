//! Golden pictures of every built-in scene, small, each compared with an approved picture.
//!
//! A difference writes the expected picture, the actual one and their difference to `target/golden/`.

use crate::common::golden::{self, Golden};
use shading_lab::analysis::comparison::{Captions, comparison_sheet, draw_panes, panes_on_sheet};
use shading_lab::render::{Frame, Renderer};
use shading_lab::scene::presets;
use std::convert::Infallible;
use std::fs::{File, create_dir_all};
use std::io::BufWriter;
use std::path::Path;

/// Pixels along each side.
const SIDE: u32 = 96;

/// Maximum difference of a channel: machines with and without fused multiplication round differently.
const ROUNDING: u8 = 1;

/// Number of pixels that may differ by more: at an outline, the edge of a shadow or of a pattern a rounding decides.
const AT_EDGES: usize = SIDE as usize * SIDE as usize / 400;

const GOLDEN: Golden = Golden("");

fn write(path: &Path, pixels: &[[u8; 3]]) {
    create_dir_all(path.parent().expect("a folder")).expect("the folder is made");
    let mut encoder = png::Encoder::new(
        BufWriter::new(File::create(path).expect("created")),
        SIDE,
        SIDE,
    );
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().expect("written");
    writer
        .write_image_data(pixels.as_flattened())
        .expect("written");
}

fn colours(frame: &Frame) -> Vec<[u8; 3]> {
    frame.pixels.iter().map(|p| [p[0], p[1], p[2]]).collect()
}

/// Compares a scene's picture with the approved one; returns a description of the difference, if any.
fn compare(name: &str, actual: &[[u8; 3]]) -> Option<String> {
    let Some((size, bytes)) = golden::read(&GOLDEN.kept(name)) else {
        return Some(format!("{name}: no picture is kept"));
    };
    let (expected, []) = bytes.as_chunks::<3>() else {
        return Some(format!("{name}: the kept picture has other channels"));
    };
    if size != [SIDE; 2] || expected.len() != actual.len() {
        return Some(format!("{name}: the kept picture has {size:?} pixels"));
    }
    let off = |(a, b): (&[u8; 3], &[u8; 3])| (0..3).map(|c| a[c].abs_diff(b[c])).max().unwrap_or(0);
    let differences: Vec<u8> = actual.iter().zip(expected).map(off).collect();
    let edges = differences
        .iter()
        .filter(|&&difference| difference > ROUNDING)
        .count();
    if edges <= AT_EDGES {
        return None;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden");
    write(&folder.join(format!("{name}-expected.png")), expected);
    write(&folder.join(format!("{name}-actual.png")), actual);
    let shown: Vec<[u8; 3]> = differences
        .iter()
        .map(|d| [d.saturating_mul(16); 3])
        .collect();
    write(&folder.join(format!("{name}-difference.png")), &shown);
    Some(format!(
        "{name}: {edges} pixels differ, see {}",
        folder.display()
    ))
}

#[test]
fn every_built_in_scene_is_drawn_as_it_was() {
    let mut renderer = Renderer::default();
    let drawn = presets::ALL.iter().map(|preset| {
        let mut scene = preset.scene();
        scene.image.size = [SIDE, SIDE];
        let nothing = |_: &mut _, _: &mut _, _: &_| Ok::<(), Infallible>(());
        let panes = draw_panes(
            &mut renderer,
            &scene,
            &panes_on_sheet(&scene),
            1,
            &mut |_| true,
            nothing,
        );
        let sheet = comparison_sheet(&scene, &panes.unwrap_or_default(), Captions::None);
        (preset.name, colours(&sheet))
    });
    let compare = |name: &str, drawn: &Vec<_>| compare(name, drawn);
    GOLDEN.check(drawn, compare, |path, drawn| write(path, drawn));
}

#[test]
fn no_picture_is_kept_of_a_scene_that_is_gone() {
    GOLDEN.has_only(|name| presets::find(name).is_some());
}
