//! Lettering as outlines: text in, a path and its extent in pixels out.

use glam::DVec2;
use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, MetadataProvider};
use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::OnceLock;
use tiny_skia::{Path, PathBuilder, Transform};

/// Size of a subscript or a superscript, in the size of the text.
const SUBSCRIPT_SIZE: f32 = 0.68;
/// How far the baselines of subscripts and of superscripts lie above the text's, in the size of the text.
const RISES: [f32; 2] = [-0.16, 0.36];

/// A line of text as an outline, its origin at the left end of the baseline, y downwards.
#[derive(Clone, Debug)]
pub(crate) struct Lettering {
    path: Option<Path>,
    /// Top left corner of what is inked, pixels from the origin.
    pub min: DVec2,
    /// Bottom right corner of what is inked.
    pub max: DVec2,
    /// Where the next letter would stand.
    pub width: f64,
}

impl Lettering {
    /// Sets `text` at `size` pixels an em. Small digits are set as [`Set`] says; a character in none of the fonts
    /// leaves a gap.
    pub fn new(text: &str, size: f64) -> Self {
        let mut pen = Pen { builder: PathBuilder::new(), x: 0.0, y: 0.0 };
        for character in text.chars() {
            pen.set(character, size as f32);
        }
        let width = f64::from(pen.x);
        let path = pen.builder.finish();
        let bounds = path.as_ref().map(Path::bounds);
        let corner = |x: f32, y: f32| DVec2::new(f64::from(x), f64::from(y));
        Self {
            min: bounds.map_or(DVec2::ZERO, |b| corner(b.left(), b.top())),
            max: bounds.map_or(DVec2::ZERO, |b| corner(b.right(), b.bottom())),
            path,
            width,
        }
    }

    /// The outline with its origin, the left end of its baseline, at `origin`; nothing for a text without ink.
    pub fn placed(&self, origin: DVec2) -> Option<Path> {
        self.path.clone()?.transform(Transform::from_translate(origin.x as f32, origin.y as f32))
    }
}

/// Width and height of what is inked of a text at `size` pixels an em, pixels.
pub(crate) fn inked_size(text: &str, size: f64) -> DVec2 {
    // A figure that is laid out again and again has the same few labels.
    const KEPT: usize = 256;
    thread_local! {
        static SIZES: RefCell<HashMap<(String, u64), DVec2>> = RefCell::default();
    }
    SIZES.with_borrow_mut(|sizes| {
        if sizes.len() >= KEPT {
            sizes.clear();
        }
        *sizes.entry((text.to_owned(), size.to_bits())).or_insert_with(|| {
            let lettering = Lettering::new(text, size);
            lettering.max - lettering.min
        })
    })
}

/// Collects glyph outlines one after another.
struct Pen {
    builder: PathBuilder,
    x: f32,
    y: f32,
}

impl Pen {
    fn set(&mut self, character: char, size: f32) {
        let Set { letter: character, size: share, rise } = Set::of(character);
        let (size, drop) = (size * share, -size * rise);
        self.y = drop;
        let Some((font, glyph)) = fonts().iter().find_map(|font| Some((font, font.charmap().map(character)?))) else {
            self.x += 0.5 * size;
            return;
        };
        let size = Size::new(size);
        if let Some(outline) = font.outline_glyphs().get(glyph) {
            // A glyph that does not draw leaves a gap, as one that is missing does.
            let _ = outline.draw(DrawSettings::unhinted(size, LocationRef::default()), self);
        }
        self.x += font.glyph_metrics(size, LocationRef::default()).advance_width(glyph).unwrap_or(0.0);
    }
}

/// How a character is set: a small one below or above the line is the ordinary one made smaller and moved, since fonts
/// may lack it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Set {
    /// The ordinary character.
    pub letter: char,
    /// Its size, in the size of the text.
    pub size: f32,
    /// How far above the line it stands, in the size of the text.
    pub rise: f32,
}

impl Set {
    /// How `character` is set.
    pub fn of(character: char) -> Self {
        let digit = |zero: char| char::from_u32(u32::from(character) - u32::from(zero) + u32::from('0'));
        let small = |letter: Option<char>, rise| {
            let letter = letter.unwrap_or(character);
            Self { letter, size: SUBSCRIPT_SIZE, rise }
        };
        match character {
            '₀'..='₉' => small(digit('₀'), RISES[0]),
            'ⁿ' => small(Some('n'), RISES[1]),
            '⁻' => small(Some('−'), RISES[1]),
            '¹' => small(Some('1'), RISES[1]),
            '²' => small(Some('2'), RISES[1]),
            '³' => small(Some('3'), RISES[1]),
            '⁰' | '⁴'..='⁹' => small(digit('⁰'), RISES[1]),
            _ => Self { letter: character, size: 1.0, rise: 0.0 },
        }
    }
}

/// Glyphs have y upwards, pictures downwards.
impl OutlinePen for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.builder.move_to(self.x + x, self.y - y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.builder.line_to(self.x + x, self.y - y);
    }

    fn quad_to(&mut self, cx0: f32, cy0: f32, x: f32, y: f32) {
        self.builder.quad_to(self.x + cx0, self.y - cy0, self.x + x, self.y - y);
    }

    fn curve_to(&mut self, cx0: f32, cy0: f32, cx1: f32, cy1: f32, x: f32, y: f32) {
        let (dx, dy) = (self.x, self.y);
        self.builder.cubic_to(dx + cx0, dy - cy0, dx + cx1, dy - cy1, dx + x, dy - y);
    }

    fn close(&mut self) {
        self.builder.close();
    }
}

/// The fonts in the order in which they are asked for a character.
fn fonts() -> &'static [FontRef<'static>] {
    static FONTS: OnceLock<Vec<FontRef<'static>>> = OnceLock::new();
    FONTS.get_or_init(|| {
        let files = [epaint_default_fonts::UBUNTU_LIGHT, epaint_default_fonts::HACK_REGULAR];
        files.into_iter().filter_map(|file| FontRef::new(file).ok()).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_character_of_the_overlays_has_a_glyph() {
        assert_eq!(fonts().len(), 2);
        for character in "NLRVHT0123456789θφ·°()−.ⁿ∞²⁻⁰⁷αηπ=’".chars() {
            let lettering = Lettering::new(&character.to_string(), 20.0);
            assert!(lettering.path.is_some(), "{character} has no outline");
        }
    }

    #[test]
    fn a_capital_stands_on_the_baseline_and_a_subscript_hangs_below_it() {
        let capital = Lettering::new("L", 100.0);
        assert!(capital.max.y.abs() < 2.0 && (60.0..80.0).contains(&-capital.min.y), "{capital:?}");
        let numbered = Lettering::new("L₁", 100.0);
        assert!((10.0..25.0).contains(&numbered.max.y), "{numbered:?}");
        assert!(numbered.max.x > capital.max.x);
    }

    #[test]
    fn text_without_ink_has_no_extent() {
        assert!(Lettering::new("", 20.0).placed(DVec2::ZERO).is_none());
        assert_eq!(Lettering::new(" ", 20.0).max, DVec2::ZERO);
    }
}
