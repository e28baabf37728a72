//! Formulas as people type them: a text comes in, a tree of letters, signs and scripts comes out.
//!
//! `K_a·I_a` has letters below the line and `(R·V)^n` one above it. As in TeX, `_` and `^` take the next character,
//! command or group: `x^12` raises the 1 alone, `x^{12}` both digits. Letters side by side are one word (`cos`, `min`),
//! a Greek letter stands for itself, `\theta` is `θ`, and a group in braces may stand anywhere. The window and the
//! pages in HTML paint the same tree; [`Display`] writes it as plain text.

use std::fmt::{self, Display, Formatter};
use std::iter::Peekable;
use std::str::Chars;

/// The deepest group or script within others that is read.
const DEPTH: usize = 4;

/// Commands that stand for one sign or letter; any other is a word, as in `\cos`.
const COMMANDS: [(&str, char); 14] = [
    ("cdot", '·'),
    ("times", '×'),
    ("theta", 'θ'),
    ("phi", 'φ'),
    ("alpha", 'α'),
    ("beta", 'β'),
    ("eta", 'η'),
    ("lambda", 'λ'),
    ("pi", 'π'),
    ("sum", 'Σ'),
    ("le", '≤'),
    ("ge", '≥'),
    ("approx", '≈'),
    ("circ", '°'),
];

/// A formula: items side by side.
///
/// ```
/// use shading_lab::figure::{Base, Formula};
///
/// let formula = Formula::read("cos^{12} φ").expect("it is sound");
/// assert_eq!(formula.items[0].base, Base::Name("cos".to_owned()));
/// assert_eq!(formula.items[0].high.to_string(), "12");
/// assert_eq!(formula.to_string(), "cos^12 φ");
/// assert_eq!(Formula::read("x^"), None);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Formula {
    /// From left to right.
    pub items: Vec<Item>,
}

/// An item of a formula with its scripts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// The item itself.
    pub base: Base,
    /// Its subscript, often empty.
    pub low: Formula,
    /// Its superscript, often empty.
    pub high: Formula,
}

/// An item of a formula without its scripts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Base {
    /// A letter or a word.
    Name(String),
    /// Signs, numbers and spaces in a row; scripts belong to the last of them. Empty where a script follows nothing.
    Signs(String),
    /// A group in braces.
    Group(Formula),
}

impl Formula {
    /// Reads a formula; none where a brace, a script or a backslash is left open, where an item has two scripts of a
    /// kind, and where groups are nested too deeply.
    pub fn read(text: &str) -> Option<Self> {
        let mut rest = text.chars().peekable();
        let formula = Self::read_group(&mut rest, 0)?;
        // What is left begins with a brace that nothing opened.
        rest.next().is_none().then_some(formula)
    }

    /// Reads a formula; one that cannot be read is shown as it was typed.
    pub fn read_or_verbatim(text: &str) -> Self {
        Self::read(text).unwrap_or_else(|| Self::of(Base::Signs(text.to_owned())))
    }

    /// Returns whether the formula is empty.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    fn of(base: Base) -> Self {
        Self {
            items: vec![Item::new(base)],
        }
    }

    /// Reads to the end or to a closing brace, which is left.
    fn read_group(rest: &mut Peekable<Chars<'_>>, depth: usize) -> Option<Self> {
        let mut items: Vec<Item> = Vec::new();
        while let Some(next) = rest.next_if(|next| *next != '}') {
            if next != '_' && next != '^' {
                match (items.last_mut(), read_base(next, rest, depth)?) {
                    // Signs in a row are one item as long as it has no script.
                    (
                        Some(Item {
                            base: Base::Signs(signs),
                            low,
                            high,
                        }),
                        Base::Signs(more),
                    ) if low.is_empty() && high.is_empty() => {
                        signs.push_str(&more);
                    }
                    (_, base) => items.push(Item::new(base)),
                }
                continue;
            }
            let script = read_script(rest, depth)?;
            if items.is_empty() {
                items.push(Item::new(Base::Signs(String::new())));
            }
            let item = items.last_mut()?;
            let place = if next == '_' {
                &mut item.low
            } else {
                &mut item.high
            };
            if !place.is_empty() {
                return None;
            }
            *place = script;
        }
        Some(Self { items })
    }
}

impl Item {
    fn new(base: Base) -> Self {
        Self {
            base,
            low: Formula::default(),
            high: Formula::default(),
        }
    }
}

/// Reads the item that begins with `first`.
fn read_base(first: char, rest: &mut Peekable<Chars<'_>>, depth: usize) -> Option<Base> {
    Some(match first {
        '{' => Base::Group(read_braced(rest, depth)?),
        '\\' => {
            let name = read_word(String::new(), rest);
            match COMMANDS.iter().find(|(command, _)| *command == name) {
                Some((_, sign)) => single(*sign),
                None if name.is_empty() => return None,
                None => Base::Name(name),
            }
        }
        'a'..='z' | 'A'..='Z' => Base::Name(read_word(first.to_string(), rest)),
        sign => single(sign),
    })
}

/// Reads the script after `_` or `^`.
fn read_script(rest: &mut Peekable<Chars<'_>>, depth: usize) -> Option<Formula> {
    let script = match rest.next_if(|next| !"}_^".contains(*next) && !next.is_whitespace())? {
        '{' => read_braced(rest, depth)?,
        '\\' => Formula::of(read_base('\\', rest, depth)?),
        character => Formula::of(single(character)),
    };
    (!script.is_empty()).then_some(script)
}

/// Reads behind an opening brace, its closing one included.
fn read_braced(rest: &mut Peekable<Chars<'_>>, depth: usize) -> Option<Formula> {
    let inside = (depth < DEPTH).then(|| Formula::read_group(rest, depth + 1))??;
    rest.next_if_eq(&'}').map(|_| inside)
}

fn read_word(mut word: String, rest: &mut Peekable<Chars<'_>>) -> String {
    while let Some(letter) = rest.next_if(char::is_ascii_alphabetic) {
        word.push(letter);
    }
    word
}

/// Returns a character as a letter or a sign; a hyphen becomes a minus sign.
fn single(character: char) -> Base {
    match character {
        'a'..='z' | 'A'..='Z' | '\u{391}'..='\u{3c9}' => Base::Name(character.to_string()),
        '-' => Base::Signs('−'.to_string()),
        sign => Base::Signs(sign.to_string()),
    }
}

/// Returns whether a name is set in italics: a single letter is, a word such as `cos` and the sign of a sum are not.
pub fn is_italic(name: &str) -> bool {
    let mut letters = name.chars();
    let single = (letters.next(), letters.next());
    matches!(single, (Some('a'..='z' | 'A'..='Z' | 'α'..='ω'), None))
}

/// Plain text: `Ka·Ia`, `cos^4 α`.
impl Display for Formula {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for Item { base, low, high } in &self.items {
            match base {
                Base::Name(text) | Base::Signs(text) => f.write_str(text)?,
                Base::Group(inside) => inside.fmt(f)?,
            }
            low.fmt(f)?;
            if !high.is_empty() {
                write!(f, "^{high}")?;
            }
        }
        Ok(())
    }
}
