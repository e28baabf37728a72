//! Text as outlines: from a string to a path and its extent in pixels.

use crate::text::{FONTS, chinese_font, with_minus};
use glam::DVec2;
use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, GlyphId, MetadataProvider};
use std::sync::OnceLock;
use tiny_skia::{Path, PathBuilder, Transform};

/// Size of a subscript or a superscript, in the size of the text.
const SMALL_SIZE: f32 = 0.68;
/// Subscripts and superscripts, the ordinary characters, and their rise above the baseline, in the size of the text.
const SMALL: [(&str, &str, f32); 2] = [
    ("₀₁₂₃₄₅₆₇₈₉", "0123456789", -0.16),
    ("⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ⁻", "0123456789n−", 0.36),
];

/// A line of text as an outline, its origin at the left end of the baseline, y downwards.
#[derive(Clone, Debug)]
pub(crate) struct Lettering {
    path: Option<Path>,
    /// Top left corner of the ink, pixels from the origin.
    pub min: DVec2,
    /// Bottom right corner of the ink.
    pub max: DVec2,
    /// Position of the next letter.
    pub width: f64,
}

impl Lettering {
    /// Lays out `text` at `size` pixels an em, small digits by [`Set`]; a character in none of the fonts leaves a gap.
    pub fn new(text: &str, size: f64) -> Self {
        let mut pen = Pen {
            builder: PathBuilder::new(),
            x: 0.0,
            y: 0.0,
        };
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

    /// Returns the outline with its origin, the left end of its baseline, at `origin`; none for a text without ink.
    pub fn placed(&self, origin: DVec2) -> Option<Path> {
        self.path
            .clone()?
            .transform(Transform::from_translate(origin.x as f32, origin.y as f32))
    }
}

/// Returns the width and height of a text's ink at `size` pixels an em, pixels.
pub(crate) fn inked_size(text: &str, size: f64) -> DVec2 {
    let lettering = Lettering::new(text, size);
    lettering.max - lettering.min
}

/// A pen that collects glyph outlines one after another.
struct Pen {
    builder: PathBuilder,
    x: f32,
    y: f32,
}

impl Pen {
    fn set(&mut self, character: char, size: f32) {
        let Set {
            letter: character,
            size: share,
            rise,
        } = Set::of(character);
        let (size, drop) = (size * share, -size * rise);
        self.y = drop;
        let outline = glyph(character).and_then(|(font, glyph)| font.outline_glyphs().get(glyph));
        if let Some(outline) = outline {
            let settings = DrawSettings::unhinted(Size::new(size), LocationRef::default());
            // A glyph that fails to draw leaves a gap, like a missing one.
            let _ = outline.draw(settings, self);
        }
        self.x += advance(character, size);
    }
}

/// Returns a character's glyph in the first font that has it.
fn glyph(character: char) -> Option<(&'static FontRef<'static>, GlyphId)> {
    fonts()
        .iter()
        .find_map(|font| Some((font, font.charmap().map(character)?)))
}

/// Returns the distance from an ordinary character to the next, pixels.
fn advance(character: char, size: f32) -> f32 {
    let Some((font, glyph)) = glyph(character) else {
        return 0.5 * size;
    };
    font.glyph_metrics(Size::new(size), LocationRef::default())
        .advance_width(glyph)
        .unwrap_or(0.0)
}

/// Returns the width of a text at `size` pixels an em, pixels.
pub(crate) fn width_of(text: &str, size: f64) -> f64 {
    let advance = |character| {
        let set = Set::of(character);
        advance(set.letter, size as f32 * set.size)
    };
    text.chars().map(advance).sum::<f32>().into()
}

/// The setting of a character: a small one is the ordinary one scaled and shifted, since fonts may lack it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Set {
    /// The ordinary character.
    pub letter: char,
    /// Size relative to the text.
    pub size: f32,
    /// Rise above the baseline, in the size of the text.
    pub rise: f32,
}

impl Set {
    /// Returns the setting of `character`.
    pub fn of(character: char) -> Self {
        for (small, ordinary, rise) in SMALL {
            let mut pairs = small.chars().zip(ordinary.chars());
            if let Some((_, letter)) = pairs.find(|(letter, _)| *letter == character) {
                return Self {
                    letter,
                    size: SMALL_SIZE,
                    rise,
                };
            }
        }
        Self {
            letter: character,
            size: 1.0,
            rise: 0.0,
        }
    }
}

/// Formats a number in subscript digits.
pub fn lowered(number: usize) -> String {
    small(&number.to_string(), 0)
}

/// Raises the exponent n of a name, as in `(R·V)^n`, to the letter that drawings set above the line.
pub fn with_raised_n(name: &str) -> String {
    name.replace("^n", "ⁿ")
}

/// Formats a number in superscript digits.
pub fn raised(number: i32) -> String {
    small(&with_minus(&number.to_string()), 1)
}

/// Converts characters to those of a row of [`SMALL`].
fn small(text: &str, which: usize) -> String {
    let (small, ordinary, _) = SMALL[which];
    let of = |letter: char| {
        let mut pairs = ordinary.chars().zip(small.chars());
        let found = pairs.find(|(own, _)| *own == letter);
        found.map_or(letter, |(_, small)| small)
    };
    text.chars().map(of).collect()
}

/// Converts glyphs, whose y points upwards, to pictures, where it points downwards.
impl OutlinePen for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.builder.move_to(self.x + x, self.y - y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.builder.line_to(self.x + x, self.y - y);
    }

    fn quad_to(&mut self, cx0: f32, cy0: f32, x: f32, y: f32) {
        self.builder
            .quad_to(self.x + cx0, self.y - cy0, self.x + x, self.y - y);
    }

    fn curve_to(&mut self, cx0: f32, cy0: f32, cx1: f32, cy1: f32, x: f32, y: f32) {
        let (dx, dy) = (self.x, self.y);
        self.builder
            .cubic_to(dx + cx0, dy - cy0, dx + cx1, dy - cy1, dx + x, dy - y);
    }

    fn close(&mut self) {
        self.builder.close();
    }
}

/// Returns the fonts in the order of search; a web page may not have the last of them yet.
fn fonts() -> &'static [FontRef<'static>] {
    static READ: [OnceLock<Vec<FontRef<'static>>>; 2] = [const { OnceLock::new() }; 2];
    READ[usize::from(!chinese_font().is_empty())].get_or_init(|| {
        let files = FONTS.map(|(_, file)| file);
        files
            .into_iter()
            .chain([chinese_font()])
            .filter_map(|file| FontRef::new(file).ok())
            .collect()
    })
}
