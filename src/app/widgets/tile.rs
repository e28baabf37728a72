//! Pictures, and buttons with a picture or a sign over their name.

use super::sign::Sign;
use eframe::egui::{
    Align2, Atom, Button, ContainerAtom, Direction, Image, Rect, Response, RichText, Sense,
    TextWrapMode, TextureHandle, Ui, Vec2,
};

/// Padding of a tile, and radius of the corners of a missing picture, in points.
const PAD: f32 = 4.0;

/// Shows a picture, or its background while there is none.
pub fn picture_ui(ui: &mut Ui, texture: Option<&TextureHandle>, size: Vec2) -> Response {
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    paint_picture(ui, texture, rect);
    response
}

fn paint_picture(ui: &Ui, texture: Option<&TextureHandle>, rect: Rect) {
    match texture {
        Some(texture) => Image::from_texture(texture).paint_at(ui, rect),
        None => {
            _ = ui
                .painter()
                .rect_filled(rect, PAD, ui.visuals().extreme_bg_color);
        }
    }
}

/// Shows a button with a picture over its name; the pictures of tiles in a row are level.
pub fn picture_tile(
    ui: &mut Ui,
    (texture, picture): (Option<&TextureHandle>, Vec2),
    name: RichText,
    size: Vec2,
    on: bool,
) -> Response {
    let picture = Atom::paint(picture, |ui, args| paint_picture(ui, texture, args.rect));
    let content = ContainerAtom::new((picture, name))
        .min_size(size - 2.0 * Vec2::splat(PAD))
        .align2(Align2::CENTER_TOP);
    tile_ui(ui, content, size, on, Vec2::splat(PAD))
}

/// Shows a button with a sign over its name.
pub fn sign_tile(ui: &mut Ui, sign: Sign, name: &str, size: Vec2, on: bool) -> Response {
    let sign = Atom::paint(Vec2::splat(18.0), move |ui, args| {
        sign.paint(ui.painter(), args.rect, args.fallback_text_color);
    });
    let content = ContainerAtom::new((sign, RichText::new(name).size(12.0)));
    tile_ui(ui, content, size, on, Vec2::ZERO)
}

fn tile_ui(ui: &mut Ui, content: ContainerAtom<'_>, size: Vec2, on: bool, pad: Vec2) -> Response {
    // A container does not take over the button's colour.
    let visuals = ui.visuals();
    let colour = if on {
        visuals.selection.stroke.color
    } else {
        visuals.text_color()
    };
    let content = content
        .direction(Direction::TopDown)
        .gap(3.0)
        .wrap_mode(TextWrapMode::Wrap)
        .fallback_text_color(colour);
    // No scope of its own: it would not begin a new row of wrapped tiles.
    let spacing = ui.spacing_mut();
    let before = (spacing.button_padding, spacing.interact_size);
    (spacing.button_padding, spacing.interact_size) = (pad, size);
    let response = ui.add_sized(size, Button::selectable(on, Atom::container(content)));
    let spacing = ui.spacing_mut();
    (spacing.button_padding, spacing.interact_size) = before;
    response
}
