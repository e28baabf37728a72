//! Choices: enumerations whose values have a word in the scene file, a label on screen and a meaning.

use crate::text::text;

/// One value of a choice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChoiceOption {
    /// The word in a scene file.
    pub word: &'static str,
    /// The message keys of its label and its meaning in the catalogue.
    pub messages: [&'static str; 2],
}

impl ChoiceOption {
    /// Returns the label on screen.
    pub fn label(&self) -> &'static str {
        text!(self.messages[0])
    }

    /// Returns the meaning, in a sentence.
    pub fn help(&self) -> &'static str {
        text!(self.messages[1])
    }
}

/// An enumeration whose values can be chosen.
pub trait Choice: Copy + PartialEq + 'static {
    /// Every value, in the order of menus.
    const VALUES: &'static [Self];
    /// The words and messages of the values, in the same order.
    const OPTIONS: &'static [ChoiceOption];

    /// Returns its position among the values.
    fn place(self) -> usize {
        Self::VALUES
            .iter()
            .position(|value| *value == self)
            .unwrap_or(0)
    }

    /// Returns the word in a scene file.
    fn word(self) -> &'static str {
        Self::OPTIONS[self.place()].word
    }

    /// Returns the label on screen.
    fn label(self) -> &'static str {
        Self::OPTIONS[self.place()].label()
    }

    /// Returns the meaning, in a sentence.
    fn help(self) -> &'static str {
        Self::OPTIONS[self.place()].help()
    }

    /// Returns the value of a word in a scene file.
    fn from_word(word: &str) -> Option<Self> {
        Self::OPTIONS
            .iter()
            .position(|option| option.word == word)
            .map(|place| Self::VALUES[place])
    }
}

/// Defines an enumeration whose values each have a word. For `pub enum Mode = "shading" { Flat = "flat"; }` the label is
/// the message `choice-shading-flat`, and the meaning its `.help`.
macro_rules! choices {
    ($(#[$about:meta])* pub enum $name:ident = $messages:literal {
        $($(#[$detail:meta])* $value:ident = $word:literal;)+
    }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name {
            $(
                $(#[$detail])*
                #[doc = concat!("\n\n`", $word, "` in files and on the command line.")]
                $value,
            )+
        }

        impl $crate::scene::Choice for $name {
            const VALUES: &'static [Self] = &[$(Self::$value),+];
            const OPTIONS: &'static [$crate::scene::ChoiceOption] =
                &[$($crate::scene::ChoiceOption {
                    word: $word,
                    messages: [
                        concat!("choice-", $messages, "-", $word),
                        concat!("choice-", $messages, "-", $word, ".help"),
                    ],
                }),+];
        }

        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str($crate::scene::Choice::word(*self))
            }
        }

        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let word = String::deserialize(deserializer)?;
                $crate::scene::Choice::from_word(&word).ok_or_else(|| serde::de::Error::invalid_value(serde::de::Unexpected::Str(&word), &"choice"))
            }
        }
    };
}

pub(crate) use choices;
