//! Golden pictures of every built-in scene, small, each compared with an approved picture.
//!
//! A difference writes the expected picture, the actual one and their difference to `target/golden/`. `UPDATE_GOLDEN=1` replaces
//! the approved pictures, and the run still fails, so that they are reviewed before they are committed.

use shading_lab::analysis::comparison::{Captions, comparison_sheet, draw_panes, panes_on_sheet};
use shading_lab::render::{Frame, Renderer};
use shading_lab::scene::presets;
use std::convert::Infallible;
use std::fs::{File, create_dir_all};
use std::io::{BufReader, BufWriter};
use std::path::{Path, PathBuf};

/// Pixels along each side.
const SIDE: u32 = 96;

/// Maximum difference of a channel: machines with and without fused multiplication round differently.
const ROUNDING: u8 = 1;

/// Number of pixels that may differ by more: at an outline, the edge of a shadow or of a pattern a rounding decides.
const AT_EDGES: usize = SIDE as usize * SIDE as usize / 400;

fn kept(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/golden")
        .join(format!("{name}.png"))
}

fn read(path: &Path) -> Option<Vec<[u8; 3]>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).ok()?))
        .read_info()
        .ok()?;
    let mut bytes = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut bytes).ok()?;
    let sound = info.width == SIDE && info.height == SIDE && info.color_type == png::ColorType::Rgb;
    sound.then(|| bytes.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect())
}

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
    let Some(expected) = read(&kept(name)) else {
        return Some(format!("{name}: no picture is kept"));
    };
    let off = |(a, b): (&[u8; 3], &[u8; 3])| (0..3).map(|c| a[c].abs_diff(b[c])).max().unwrap_or(0);
    let differences: Vec<u8> = actual.iter().zip(&expected).map(off).collect();
    let edges = differences
        .iter()
        .filter(|&&difference| difference > ROUNDING)
        .count();
    if edges <= AT_EDGES {
        return None;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden");
    write(&folder.join(format!("{name}-expected.png")), &expected);
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
    let update = std::env::var_os("UPDATE_GOLDEN").is_some();
    let mut renderer = Renderer::default();
    let mut wrong = Vec::new();
    for preset in presets::ALL {
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
        let actual = colours(&comparison_sheet(
            &scene,
            &panes.unwrap_or_default(),
            Captions::None,
        ));
        if let Some(message) = compare(preset.name, &actual) {
            if update {
                write(&kept(preset.name), &actual);
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
fn no_picture_is_kept_of_a_scene_that_is_gone() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    for entry in std::fs::read_dir(folder).expect("the folder of kept pictures") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            continue;
        }
        let name = path
            .file_stem()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        assert!(presets::find(&name).is_some(), "{name}");
    }
}
