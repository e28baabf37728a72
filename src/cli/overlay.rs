//! Which overlays a picture gets, and where.

use super::failure::Failure;
use super::input::{inside_picture, parse_pixel};
use glam::DVec2;
use serde::Deserialize;
use serde::de::IntoDeserializer;
use serde::de::value::{Error, StrDeserializer};
use shading_lab::analysis::{
    LitVertex, Needles, NormalField, OverlayLayer, OverlayOptions, Profile, ProfileQuestion, clearest_pixel, defects,
    draw_defects, draw_overlay, draw_profile, probe, profile,
};
use shading_lab::render::{Frame, Renderer};
use shading_lab::scene::{Scene, nearest};
use tiny_skia::PixmapMut;

/// The layers of `--overlay vectors,angles,probe=X,Y` and the pixel that they explain.
#[derive(Clone, Debug, PartialEq)]
pub struct OverlayList {
    layers: Vec<OverlayLayer>,
    pixel: Option<[u32; 2]>,
    /// The ends of the profile's line.
    line: Option<(DVec2, DVec2)>,
    /// The vertex whose faces are lit up.
    vertex: Option<u32>,
}

impl OverlayList {
    /// Names between commas; `probe=X,Y` or any of the names followed by `=X,Y` gives the pixel.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut list = Self { layers: Vec::new(), pixel: None, line: None, vertex: None };
        let mut pieces = text.split(',');
        while let Some(piece) = pieces.next() {
            let (name, x) = piece.split_once('=').map_or((piece, None), |(name, x)| (name, Some(x)));
            match name.trim() {
                "probe" if x.is_none() => return Err("probe without its pixel, expected probe=X,Y".to_owned()),
                "probe" => {}
                name => list.layers.push(layer(name)?),
            }
            if let Some(x) = x {
                let pixel = parse_pixel(&format!("{x},{}", pieces.next().unwrap_or_default()))?;
                if list.pixel.is_some_and(|other| other != pixel) {
                    return Err("two pixels, expected one that all overlays explain".to_owned());
                }
                list.pixel = Some(pixel);
            }
        }
        if list.layers.is_empty() {
            return Err("a pixel alone, expected what to draw there, as in vectors,angles,probe=100,80".to_owned());
        }
        Ok(list)
    }

    /// Takes the ends of the profile's line; without them it is level, through the pixel or the middle.
    pub fn set_line(&mut self, from: Option<DVec2>, to: Option<DVec2>) -> Result<(), Failure> {
        self.line = from.zip(to);
        if self.line.is_some() && !self.layers.contains(&OverlayLayer::Profile) {
            return Err(Failure::input("--from and --to without a profile, expected --overlay profile"));
        }
        Ok(())
    }

    /// Takes the vertex whose faces are lit up.
    pub fn set_vertex(&mut self, vertex: Option<u32>) -> Result<(), Failure> {
        self.vertex = vertex;
        if vertex.is_some() && !self.layers.iter().any(|layer| layer.of_needles()) {
            return Err(Failure::input("--vertex without normals, expected --overlay vertex-normals"));
        }
        Ok(())
    }

    /// Refuses a pixel or a line outside a picture of `sides` pixels.
    pub fn check(&self, sides: [u32; 2]) -> Result<(), Failure> {
        if let Some((from, to)) = self.line {
            let size = DVec2::from_array(sides.map(f64::from));
            let outside = |p: &DVec2| p.min_element() < 0.0 || p.cmpgt(size).any();
            if let Some(DVec2 { x, y }) = [from, to].into_iter().find(outside) {
                let DVec2 { x: right, y: bottom } = size;
                return Err(Failure::input(format!("{x},{y}: outside the picture, expected 0,0 to {right},{bottom}")));
            }
        }
        let Some([x, y]) = self.pixel else { return Ok(()) };
        inside_picture(&format!("--overlay {x},{y}"), [x, y], sides)
    }

    /// Draws the overlays on `frame`, which is a picture of `scene`.
    pub fn draw(&self, frame: &mut Frame, renderer: &mut Renderer, scene: &Scene) -> Result<(), Failure> {
        let about_pixel = self.layers.iter().any(|layer| layer.of_point());
        let probed = match self.pixel {
            Some([x, y]) => probe(renderer, scene, x, y),
            None => clearest_pixel(renderer, scene),
        };
        if about_pixel && probed.hit.is_none() {
            let [x, y] = probed.pixel;
            let expected = "expected a pixel that shows the object";
            return Err(Failure::input(format!("--overlay {x},{y}: the background, {expected}")));
        }
        let options = OverlayOptions { layers: self.layers.clone(), ..OverlayOptions::default() };
        let taken = self.profile(renderer, scene)?;
        let measured = self.layers.contains(&OverlayLayer::Defects).then(|| defects(renderer, scene, probed.pixel));
        let (needles, lit) = self.normals(renderer, scene, &options)?.unzip();
        let (width, height) = (frame.width, frame.height);
        let mut pixmap = PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), width, height)
            .ok_or_else(|| Failure::work("the picture is too large for overlays"))?;
        if let Some(needles) = needles {
            needles.draw(&mut pixmap);
        }
        if let Some(lit) = lit.flatten() {
            lit.draw(&mut pixmap);
        }
        if let Some(taken) = &taken {
            taken.traces.iter().for_each(|trace| draw_profile(&mut pixmap, taken, trace, &options));
        }
        if let Some(measured) = &measured {
            draw_defects(&mut pixmap, measured, &options);
        }
        if self.layers.iter().any(|layer| layer.of_overlay()) {
            draw_overlay(&mut pixmap, scene, &probed, &options);
        }
        Ok(())
    }

    /// The needles, and the faces of the chosen vertex, where they are asked for.
    fn normals(
        &self,
        renderer: &Renderer,
        scene: &Scene,
        options: &OverlayOptions,
    ) -> Result<Option<(Needles, Option<LitVertex>)>, Failure> {
        if !self.layers.iter().any(|layer| layer.of_needles()) {
            return Ok(None);
        }
        let field = NormalField::new(renderer, &scene.object);
        let size = scene.image.size;
        let lit = match self.vertex {
            Some(number) => {
                LitVertex::new(size, scene, &field, &field.vertex_of(number).map_err(Failure::input)?, options)
            }
            None => None,
        };
        Ok(Some((Needles::new(size, scene, renderer, &field, options), lit)))
    }

    /// The profile in the scene's own shading, where it is asked for.
    fn profile(&self, renderer: &mut Renderer, scene: &Scene) -> Result<Option<Profile>, Failure> {
        if !self.layers.contains(&OverlayLayer::Profile) {
            return Ok(None);
        }
        let [width, height] = scene.image.size;
        let y = self.pixel.map_or(0.5 * f64::from(height), |[_, y]| f64::from(y) + 0.5);
        let (from, to) = self.line.unwrap_or((DVec2::new(0.0, y), DVec2::new(width.into(), y)));
        let request = ProfileQuestion { modes: vec![scene.shading.mode], ..ProfileQuestion::new(from, to) };
        profile(renderer, scene, &request)
            .map(Some)
            .map_err(|error| Failure::input(format!("--overlay profile: {error}")))
    }
}

/// The number of a vertex.
pub fn parse_vertex(text: &str) -> Result<u32, String> {
    text.trim().parse().map_err(|_| "expected the number of a vertex, counted from 0".to_owned())
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

#[cfg(test)]
mod tests {
    use super::*;
    use OverlayLayer::{Angles, Lights, SideView, Vectors};

    #[test]
    fn a_list_is_read_with_its_pixel() {
        let read = |text| OverlayList::parse(text).map(|list| (list.layers, list.pixel));
        assert_eq!(read("vectors"), Ok((vec![Vectors], None)));
        assert_eq!(read("vectors=10,20"), Ok((vec![Vectors], Some([10, 20]))));
        assert_eq!(read("vectors,angles,probe=10,20"), Ok((vec![Vectors, Angles], Some([10, 20]))));
        assert_eq!(read("lights, angles=1,2,side-view"), Ok((vec![Lights, Angles, SideView], Some([1, 2]))));
        for text in ["probe", "probe=1,2", "vectors,probe", "vectors,probe=1"] {
            assert!(read(text).is_err(), "{text}");
        }
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
