//! The scan line in slow motion, drawn: enlarged pixels, the polygon's outline, P and Q with their shares of the edges.
//!
//! A scan and one of its steps come in, a [`Drawing`] comes out. The part α of an edge or of a span, from its first end to
//! what is found on it, is thick and yellow; the rest, 1−α, is thick in the colour of text.

mod column;
mod marks;

use crate::analysis::{Scan, ScanCorner};
use crate::figure::Area;
use crate::figure::palette::{ALPHA, Rgb8, readable};
use crate::figure::{Drawing, Paper, PlotStyle, Shape, Text};
use glam::DVec2;

/// Room for letters about the outermost corners, in ems: for α at the sides, for the corners' names above and below.
const LETTERED: DVec2 = DVec2::new(2.5, 1.9);
/// Polygons of more corners have letters at their active edges only.
pub const MOST_LETTERS: usize = 12;

/// The room that the picture of `scan` takes in a width, no higher than `tallest`.
pub fn scan_room(scan: &Scan, width: f64, tallest: f64, style: &PlotStyle) -> DVec2 {
    let grid = size_of(scan);
    let cell = (width - 2.0 * pad(width / grid.x, style.text).x) / grid.x;
    DVec2::new(width, (cell * grid.y + 2.0 * pad(cell, style.text).y).min(tallest))
}

/// Columns and rows.
fn size_of(scan: &Scan) -> DVec2 {
    DVec2::new(f64::from(scan.grid.columns), f64::from(scan.grid.rows))
}

/// Room beside and above a grid whose pixels are so large: its free rows and columns hold a part of the letters.
fn pad(cell: f64, em: f64) -> DVec2 {
    (LETTERED * em - cell).max(DVec2::splat(0.3 * em))
}

/// Draws `scan` at step `step` in a room of `size`. With a title there is also a column beside or below the picture with the
/// formulas filled in.
pub fn lay_out_scan(scan: &Scan, step: usize, size: DVec2, style: &PlotStyle) -> Drawing {
    let mut drawing = Drawing::new(size, style.paper.ground);
    let mut room = Area { min: DVec2::ZERO, max: size };
    if style.titled {
        room = column::draw(&mut drawing, scan, step, room, style);
    }
    let sheet = Sheet::new(scan, room, style);
    marks::draw(&mut drawing, &sheet, step);
    drawing
}

/// Where the grid lies on the drawing, and what is drawn with.
struct Sheet<'a> {
    scan: &'a Scan,
    /// The top left corner of the grid.
    origin: DVec2,
    /// The side of a pixel.
    cell: f64,
    room: Area,
    em: f64,
    paper: Paper,
}

impl<'a> Sheet<'a> {
    fn new(scan: &'a Scan, room: Area, style: &PlotStyle) -> Self {
        let (grid, extent) = (size_of(scan), room.max - room.min);
        let natural = (extent / grid).min_element();
        let cell = ((extent - 2.0 * pad(natural, style.text)) / grid).min_element().max(0.0);
        let origin = (room.min + room.max - grid * cell) * 0.5;
        Self { scan, origin, cell, room, em: style.text, paper: style.paper }
    }

    /// Where a place of the grid is drawn.
    fn at(&self, place: DVec2) -> DVec2 {
        self.origin + place * self.cell
    }

    /// The square of a pixel.
    fn square(&self, [x, y]: [u32; 2]) -> Area {
        let min = self.at(DVec2::new(f64::from(x), f64::from(y)));
        Area { min, max: min + self.cell }
    }

    /// The colour of the share α.
    fn alpha(&self) -> Rgb8 {
        readable(ALPHA, self.paper.ground, 3.0)
    }

    /// The same for letters, which need more contrast.
    fn alpha_letters(&self) -> Rgb8 {
        readable(ALPHA, self.paper.ground, 4.5)
    }

    /// The middle of the corners.
    fn middle(&self) -> DVec2 {
        let places = self.scan.corners.iter().map(|corner: &ScanCorner| corner.place);
        #[expect(clippy::cast_precision_loss, reason = "a face has few corners")]
        let count = self.scan.corners.len().max(1) as f64;
        self.at(places.sum::<DVec2>() / count)
    }

    /// A line set off from what it crosses.
    fn cased(&self, drawing: &mut Drawing, points: Vec<DVec2>, width: f64, colour: Rgb8) {
        let casing = Shape::line(points.clone(), width + 0.16 * self.em, self.paper.ground);
        drawing.shapes.extend([casing, Shape::line(points, width, colour)]);
    }

    /// Text with its middle at the first of `places` where it stands clear of what is `taken`, on a patch of the ground and
    /// inside the room; at none where there is no such place, or at the first one all the same if it `must`.
    fn label(&self, drawing: &mut Drawing, taken: &mut Vec<Area>, label: Label, places: &[DVec2], must: bool) {
        let text = Text::new(label.text, DVec2::ZERO, label.size, label.colour).bold();
        let half = DVec2::new(0.5 * text.width() + 0.15 * self.em, 0.6 * label.size);
        let (low, high) = (self.room.min + half, self.room.max - half);
        let about = |place: &DVec2| Area::about(place.max(low).min(high.max(low)), 2.0 * half);
        let free = |area: &Area| !taken.iter().any(|other| area.overlaps(other));
        let area = places.iter().map(about).find(free).or_else(|| places.first().map(about).filter(|_| must));
        let Some(area) = area else { return };
        drawing.shapes.push(Shape::area(area.corners(), self.paper.ground).faded(0.78));
        let at = area.centre() + DVec2::new(0.0, 0.35 * label.size);
        drawing.texts.push(Text { at, ..text }.aligned(0.5));
        taken.push(area);
    }
}

/// What a label says.
struct Label {
    text: String,
    colour: Rgb8,
    size: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{face_at, scan};
    use crate::figure::Paper;
    use crate::render::Renderer;
    use crate::scene::Scene;

    #[test]
    fn the_filled_pixels_have_the_stored_colours() {
        let mut scene = Scene::default();
        scene.image.size = [96, 96];
        let mut renderer = Renderer::default();
        let face = face_at(&mut renderer, &scene, 40, 30).expect("the sphere");
        let scan = scan(&mut renderer, &scene, face, 12).expect("a polygon in sight");
        let style = PlotStyle { paper: Paper::LIGHT, text: 2.0, titled: false };
        let drawing = lay_out_scan(&scan, scan.last(), DVec2::new(600.0, 400.0), &style);
        let frame = drawing.to_frame().expect("a picture");
        let sheet = Sheet::new(&scan, Area { min: DVec2::ZERO, max: drawing.size }, &style);
        let mut found = 0;
        for (y, pixel) in scan.filled(scan.last()) {
            let place = sheet.at(DVec2::new(f64::from(pixel.x) + 0.3, f64::from(y) + 0.3));
            let seen = frame.pixel(place.x as u32, place.y as u32);
            found += usize::from(seen == Some(pixel.stored));
        }
        let all = scan.filled(scan.last()).count();
        assert!(found * 10 >= all * 7, "{found} of {all}; edges cross the others");
        assert!(drawing.to_svg("a polygon").contains("<polygon"));
    }
}
