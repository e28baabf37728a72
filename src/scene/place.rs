//! Places in the picture that stay the same in a picture of another size: offsets from its middle to the right and down, in
//! units of its shorter side.

use glam::DVec2;

/// Converts a place to pixels, in a picture of `size` pixels.
pub(crate) fn place_to_pixel(place: DVec2, size: DVec2) -> DVec2 {
    size / 2.0 + place * size.min_element()
}

/// Converts pixels to a place, in a picture of `size` pixels.
pub(crate) fn pixel_to_place(pixel: DVec2, size: DVec2) -> DVec2 {
    (pixel - size / 2.0) / size.min_element()
}
