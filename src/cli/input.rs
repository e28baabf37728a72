//! Arguments that several commands share.

use super::failure::Failure;
use super::output::progress_bar;
use clap::Args;
use serde::Serialize;
use shading_lab::analysis::word;
use shading_lab::document::{Loaded, load_with};
use shading_lab::scene::materials::{self, NamedMaterial};
use shading_lab::scene::parameter::Parameter;
use shading_lab::scene::{Image, Scene, nearest, presets};
use std::path::{Path, PathBuf};

/// Files from this many bytes on get a progress bar while they are read.
const LARGE_FILE: u64 = 4 << 20;

/// Which scene, and what is different in it.
#[derive(Args)]
pub struct SceneArguments {
    /// A .toml, .obj or .png file, or a built-in scene's name
    #[arg(value_name = "SCENE")]
    pub source: Option<PathBuf>,
    /// Override one key of the scene, as in material.n=1005 or light.0.position=[2,2,3]
    #[arg(long, value_name = "KEY=VALUE", allow_hyphen_values = true)]
    pub set: Vec<String>,
    /// Take a named material (see `materials`); --set can then change it further
    #[arg(long, value_name = "NAME", value_parser = parse_material)]
    pub material: Option<&'static NamedMaterial>,
}

impl SceneArguments {
    /// What is different in the scene: first its material, then single keys.
    pub fn overrides(&self) -> Vec<String> {
        let material = self.material.map(assignments).unwrap_or_default();
        material.into_iter().chain(self.set.iter().cloned()).collect()
    }

    /// Opens the scene, or the default one, with the overrides of both sides of the command's name.
    pub fn load(&self, earlier: &[String]) -> Result<Loaded, Failure> {
        let own = self.overrides();
        let overrides: Vec<&String> = earlier.iter().chain(&own).collect();
        let mut bar = None;
        let mut progress = |read: u64, total: u64| {
            if total >= LARGE_FILE {
                bar.get_or_insert_with(|| progress_bar(total, "reading")).set_position(read);
            }
        };
        let source = self.source.as_deref().unwrap_or(Path::new(presets::DEFAULT));
        let loaded = load_with(source, &overrides, &mut progress);
        if let Some(bar) = bar {
            bar.finish_and_clear();
        }
        Ok(loaded?)
    }
}

/// A named material as keys of a scene.
fn assignments(named: &NamedMaterial) -> Vec<String> {
    let scene = Scene { material: named.material(), ..Scene::default() };
    let keys = Parameter::all().filter(|parameter| parameter.section() == "material");
    keys.map(|parameter| format!("{}={}", parameter.key, parameter.setting(&scene, 0))).collect()
}

/// The name of a material.
pub fn parse_material(text: &str) -> Result<&'static NamedMaterial, String> {
    materials::find(text).ok_or_else(|| {
        let meant = nearest(text, materials::NAMED.iter().map(|named| named.name));
        let meant = meant.map(|meant| format!(" (did you mean {meant}?)")).unwrap_or_default();
        format!("no such material, expected a name{meant}; see `shading-lab materials`")
    })
}

/// `WxH`, in the bounds of a picture.
pub fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let expected = || format!("expected WIDTHxHEIGHT in pixels, 1 to {} each, as in 768x512", Image::MAX_SIDE);
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(expected)?;
    let side = |text: &str| text.trim().parse().ok().filter(|side| (1..=Image::MAX_SIDE).contains(side));
    let size = [side(width).ok_or_else(expected)?, side(height).ok_or_else(expected)?];
    if u64::from(size[0]) * u64::from(size[1]) > Image::MAX_PIXELS {
        return Err(format!("expected at most {} pixels in all", Image::MAX_PIXELS));
    }
    Ok(size)
}

/// One of `choices`, by its word in files.
pub fn parse_choice<T: Serialize + Copy>(text: &str, choices: impl IntoIterator<Item = T>) -> Result<T, String> {
    let choices: Vec<(String, T)> = choices.into_iter().map(|choice| (word(&choice), choice)).collect();
    choices.iter().find(|(word, _)| word == text.trim()).map(|(_, choice)| *choice).ok_or_else(|| {
        let (last, others) = choices.split_last().map_or(("", &[][..]), |((last, _), others)| (last, others));
        let others: Vec<&str> = others.iter().map(|(word, _)| word.as_str()).collect();
        format!("expected {} or {last}", others.join(", "))
    })
}

/// `X,Y`, whole numbers from the top left.
pub fn parse_pixel(text: &str) -> Result<[u32; 2], String> {
    let expected = || "expected X,Y in whole pixels from the top left, as in 100,80".to_owned();
    let (x, y) = text.split_once(',').ok_or_else(expected)?;
    let coordinate = |text: &str| text.trim().parse().map_err(|_| expected());
    Ok([coordinate(x)?, coordinate(y)?])
}

/// Refuses a pixel outside a picture of `size`; `argument` is what names it.
pub fn inside_picture(argument: &str, [x, y]: [u32; 2], [width, height]: [u32; 2]) -> Result<(), Failure> {
    if x < width && y < height {
        return Ok(());
    }
    let (right, bottom) = (width - 1, height - 1);
    Err(Failure::input(format!("{argument}: outside the picture, expected 0,0 to {right},{bottom}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_within_their_bounds() {
        assert_eq!(parse_size("768x512"), Ok([768, 512]));
        assert_eq!(parse_size("16384×8192"), Ok([16_384, 8192]));
        for text in ["", "x", "768", "0x5", "5x0", "16385x1", "-1x5", "5x5x5", "16384x8193", "99999999999x1"] {
            assert!(parse_size(text).is_err(), "{text}");
        }
    }

    #[test]
    fn a_material_by_its_name_is_that_material() {
        for named in materials::NAMED {
            let scene = Scene::default().with_overrides(&assignments(named)).expect("sound keys");
            assert_eq!(scene.material, named.material(), "{}", named.name);
        }
        assert!(parse_material("golld").is_err_and(|message| message.contains("did you mean gold?")));
    }

    #[test]
    fn pixels_are_read_and_kept_inside() {
        assert_eq!(parse_pixel("3, 4"), Ok([3, 4]));
        for text in ["", "3", "3,", "-1,2", "1.5,2", "1,2,3", "99999999999,1"] {
            assert!(parse_pixel(text).is_err(), "{text}");
        }
        assert!(inside_picture("", [2, 3], [3, 4]).is_ok());
        assert!(inside_picture("", [3, 3], [3, 4]).is_err());
        assert!(inside_picture("", [2, 4], [3, 4]).is_err());
    }
}
