//! The shapes of a drawing as a texture, which is drawn anew only when they change: a large class gives more of them than a window paints
//! in a frame.

use crate::app::engine::{drawing, upload};
use crate::figure::Drawing;
use eframe::egui::emath::GuiRounding;
use eframe::egui::{Color32, Painter, Rect, Shape, TextureHandle, TextureOptions, pos2};

/// The shapes of a drawing as a texture.
#[derive(Default)]
pub struct Layer {
    /// The drawing that the texture shows, and its pixels per point.
    shown: Option<(Drawing, f32)>,
    texture: Option<TextureHandle>,
}

impl Layer {
    /// Returns the shapes of a drawing as one shape of the window, at the top left corner of `rect`.
    pub fn shape(&mut self, painter: &Painter, shapes: Drawing, rect: Rect) -> Shape {
        let scale = painter.pixels_per_point();
        let size = [shapes.size.x, shapes.size.y].map(|side| side * f64::from(scale));
        let size = size.map(|side| side.ceil() as u32);
        let wanted = Some((shapes, scale));
        if self.shown != wanted {
            self.shown = wanted;
            let scaled = self.shown.as_ref().map(scaled);
            let image = scaled.and_then(|scaled| drawing(size, |map| scaled.draw(map)));
            let Some(image) = image else {
                self.texture = None;
                return Shape::Noop;
            };
            let options = TextureOptions::NEAREST;
            upload(painter.ctx(), &mut self.texture, "layer", image, options);
        }
        let Some(texture) = &self.texture else {
            return Shape::Noop;
        };
        // A pixel of the texture is one of the window.
        let corner = rect.min.round_to_pixels(scale);
        let rect = Rect::from_min_size(corner, texture.size_vec2() / scale);
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        Shape::image(texture.id(), rect, whole, Color32::WHITE)
    }
}

/// Returns the shapes of a drawing in pixels.
fn scaled((drawing, scale): &(Drawing, f32)) -> Drawing {
    let scale = f64::from(*scale);
    let mut scaled = drawing.clone();
    (scaled.ground, scaled.texts) = (None, vec![]);
    scaled.breadth *= scale;
    for shape in &mut scaled.shapes {
        shape.width *= scale;
        shape.points.iter_mut().for_each(|point| *point *= scale);
    }
    scaled
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Shape;
    use eframe::egui::{Context, RawInput};
    use glam::DVec2;

    #[test]
    fn shapes_are_drawn_anew_when_they_change_and_only_then() {
        let (ctx, mut layer) = (Context::default(), Layer::default());
        let mut drawn = |shapes: &Drawing| {
            let show = |ui: &mut eframe::egui::Ui| {
                let shape = layer.shape(ui.painter(), shapes.clone(), ui.max_rect());
                assert!(shape.visual_bounding_rect().width() >= 40.0);
            };
            let mut output = ctx.run_ui(RawInput::default(), show);
            let new = output.textures_delta.set.values().flatten();
            let count = new.filter(|new| new.image.size() == [40, 30]).count();
            output.textures_delta.clear();
            count
        };
        let mut shapes = Drawing::over_picture([0; 3], 0.0);
        shapes.size = DVec2::new(40.0, 30.0);
        let disc = |x: f64| Shape::disc(DVec2::new(x, 15.0), 5.0, [200, 100, 0]);
        shapes.shapes.push(disc(10.0));
        assert_eq!([drawn(&shapes), drawn(&shapes)], [1, 0]);
        shapes.shapes.push(disc(20.0));
        assert_eq!([drawn(&shapes), drawn(&shapes)], [1, 0]);
    }

    #[test]
    fn a_layer_has_the_pixels_of_the_window() {
        let mut shapes = Drawing::over_picture([0; 3], 1.0);
        shapes.size = DVec2::new(40.0, 30.0);
        shapes
            .shapes
            .push(Shape::line(vec![DVec2::ZERO, shapes.size], 2.0, [9; 3]));
        let twice = scaled(&(shapes.clone(), 2.0));
        assert_eq!(twice.shapes[0].points[1], 2.0 * shapes.size);
        assert_eq!((twice.shapes[0].width, twice.breadth), (4.0, 2.0));
    }
}
