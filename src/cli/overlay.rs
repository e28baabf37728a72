//! Which overlays a picture gets, and where.

use super::failure::Failure;
use super::input::{inside_picture, parse_pixel};
use serde::Deserialize;
use serde::de::IntoDeserializer;
use serde::de::value::{Error, StrDeserializer};
use shading_lab::analysis::{Probe, probe};
use shading_lab::figure::{OverlayLayer, OverlayOptions, draw_overlay};
use shading_lab::render::{Frame, Renderer};
use shading_lab::scene::{Scene, nearest};
use tiny_skia::PixmapMut;

/// Without a given pixel, the one probed is sought on a grid of this many columns and rows.
const SEARCH_GRID: u32 = 64;

/// The layers of `--overlay vectors=X,Y,angles,…` and the pixel that they explain.
#[derive(Clone, Debug, PartialEq)]
pub struct OverlayList {
    layers: Vec<OverlayLayer>,
    pixel: Option<[u32; 2]>,
}

impl OverlayList {
    /// Names between commas, one of which may be followed by `=X,Y`.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut list = Self { layers: Vec::new(), pixel: None };
        let mut pieces = text.split(',');
        while let Some(piece) = pieces.next() {
            let (name, x) = piece.split_once('=').map_or((piece, None), |(name, x)| (name, Some(x)));
            list.layers.push(layer(name.trim())?);
            if let Some(x) = x {
                let pixel = parse_pixel(&format!("{x},{}", pieces.next().unwrap_or_default()))?;
                if list.pixel.is_some_and(|other| other != pixel) {
                    return Err("two pixels, expected one that all overlays explain".to_owned());
                }
                list.pixel = Some(pixel);
            }
        }
        Ok(list)
    }

    /// Refuses a pixel outside the picture.
    pub fn check(&self, scene: &Scene) -> Result<(), Failure> {
        let Some([x, y]) = self.pixel else { return Ok(()) };
        inside_picture(&format!("--overlay {x},{y}"), [x, y], scene.image.size)
    }

    /// Draws the overlays on `frame`, which is a picture of `scene`.
    pub fn draw(&self, frame: &mut Frame, renderer: &mut Renderer, scene: &Scene) -> Result<(), Failure> {
        let about_pixel = self.layers.iter().any(|layer| *layer != OverlayLayer::Lights);
        let probed = match self.pixel {
            Some([x, y]) => probe(renderer, scene, x, y),
            None => nearest_hit(renderer, scene),
        };
        if about_pixel && probed.hit.is_none() {
            let [x, y] = probed.pixel;
            let expected = "expected a pixel that shows the object";
            return Err(Failure::input(format!("--overlay {x},{y}: the background, {expected}")));
        }
        let options = OverlayOptions { layers: self.layers.clone(), ..OverlayOptions::default() };
        let (width, height) = (frame.width, frame.height);
        let mut pixmap = PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), width, height)
            .ok_or_else(|| Failure::work("the picture is too large for overlays"))?;
        draw_overlay(&mut pixmap, scene, &probed, &options);
        Ok(())
    }
}

fn layer(name: &str) -> Result<OverlayLayer, String> {
    let word: StrDeserializer<'_, Error> = name.into_deserializer();
    OverlayLayer::deserialize(word).map_err(|_| {
        let names: Vec<String> = OverlayLayer::ALL.iter().filter_map(word_of).collect();
        let meant = nearest(name, names.iter().map(String::as_str));
        let meant = meant.map(|meant| format!(" (did you mean {meant}?)")).unwrap_or_default();
        format!("expected {}{meant}", names.join(", "))
    })
}

fn word_of(layer: &OverlayLayer) -> Option<String> {
    serde_json::to_value(layer).ok()?.as_str().map(str::to_owned)
}

/// The pixel nearest to the picture's middle that shows the object, among those of a coarse grid; else the middle.
fn nearest_hit(renderer: &mut Renderer, scene: &Scene) -> Probe {
    let [width, height] = scene.image.size;
    let middle = [width / 2, height / 2];
    let middles = |side: u32| (0..SEARCH_GRID).map(move |i| (2 * i + 1) * side / (2 * SEARCH_GRID));
    let mut grid: Vec<[u32; 2]> = middles(height).flat_map(|y| middles(width).map(move |x| [x, y])).collect();
    let distance = |[x, y]: &[u32; 2]| {
        let (dx, dy) = (u64::from(x.abs_diff(middle[0])), u64::from(y.abs_diff(middle[1])));
        dx * dx + dy * dy
    };
    grid.sort_by_key(distance);
    let mut probes = grid.iter().map(|&[x, y]| probe(renderer, scene, x, y));
    let found = probes.find(|probed| probed.hit.is_some());
    found.unwrap_or(Probe { pixel: middle, hit: None })
}

#[cfg(test)]
mod tests {
    use super::*;
    use OverlayLayer::{Angles, Lights, SideView, Vectors};

    #[test]
    fn a_list_is_read_with_its_pixel() {
        let read = |text| OverlayList::parse(text).map(|list| (list.layers, list.pixel));
        assert_eq!(read("vectors"), Ok((vec![Vectors], None)));
        assert_eq!(read("vectors=10,20"), Ok((vec![Vectors], Some([10, 20]))));
        assert_eq!(read("lights, angles=1,2,side-view"), Ok((vec![Lights, Angles, SideView], Some([1, 2]))));
        for text in
            ["", "vectors,", "vectors=", "vectors=1", "vectors=1,angles", "vectors=1,2,angles=3,4", "vectors=-1,2"]
        {
            assert!(read(text).is_err(), "{text}");
        }
        assert!(read("vector").is_err_and(|message| message.contains("did you mean vectors?")));
    }

    #[test]
    fn every_layer_has_its_word() {
        for one in OverlayLayer::ALL {
            assert_eq!(layer(&word_of(&one).expect("a word")), Ok(one));
        }
    }
}
