//! Text for people, from one catalogue in two languages: `assets/text/LANGUAGE/*.ftl`, in the syntax of Project
//! Fluent. Data for programs (JSON, CSV keys, scene files) is not text and never changes with the language.

mod foreign;
mod nearest;
mod number;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Borrow;
use std::cell::Cell;
use std::collections::{BTreeSet, HashMap};
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{LazyLock, PoisonError, RwLock};
use unic_langid::LanguageIdentifier;

/// Returns a message of the catalogue: `text!("key")` is a `&'static str`, `text!("key", name = value)` a `String`
/// with the variables filled in (strings or numbers). An attribute is written `key.attribute`.
#[macro_export]
macro_rules! text {
    ($key:expr) => {
        $crate::text::message($key)
    };
    ($key:expr, $($name:ident = $value:expr),+ $(,)?) => {
        $crate::text::filled($key, &[$((stringify!($name), $crate::text::Value::from($value))),+])
    };
}
pub use crate::text;
pub use fluent_bundle::FluentValue as Value;
pub use foreign::{escaped, escaped_json, excerpt, turns, with_short_names};
pub use nearest::{did_you_mean, nearest};
pub use number::{fixed, with_minus};

/// A language of the catalogue.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Language {
    /// English.
    #[default]
    #[serde(rename = "en")]
    English,
    /// Chinese in traditional characters, with the usage of Taiwan.
    #[serde(rename = "zh-Hant")]
    TraditionalChinese,
}

impl Language {
    /// All languages, English first.
    pub const ALL: [Self; 2] = [Self::English, Self::TraditionalChinese];

    /// Returns its BCP 47 tag, the value of `--language`.
    pub fn tag(self) -> &'static str {
        ["en", "zh-Hant"][self as usize]
    }

    /// Returns the language of a tag of [`Self::tag`], in any case.
    pub fn from_tag(tag: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|language| language.tag().eq_ignore_ascii_case(tag))
    }

    /// Returns its name in that language.
    pub fn name(self) -> &'static str {
        ["English", "繁體中文"][self as usize]
    }

    /// Returns the language for a locale such as `zh_TW.UTF-8` or `en-GB`: Chinese for any Chinese, English for
    /// anything else.
    pub fn from_locale(locale: &str) -> Self {
        let language = locale.split(['-', '_', '.']).next().unwrap_or_default();
        if language.eq_ignore_ascii_case("zh") {
            Self::TraditionalChinese
        } else {
            Self::English
        }
    }

    /// Returns the language of the system's locale.
    pub fn of_system() -> Self {
        sys_locale::get_locale().map_or(Self::English, |locale| Self::from_locale(&locale))
    }
}

/// The language of the process, an index of [`Language::ALL`].
static CHOSEN: AtomicU8 = AtomicU8::new(0);

thread_local! {
    static OVERRIDE: Cell<Option<Language>> = const { Cell::new(None) };
}

/// Returns the current language.
pub fn language() -> Language {
    OVERRIDE
        .get()
        .unwrap_or(Language::ALL[usize::from(CHOSEN.load(Ordering::Relaxed))])
}

/// Sets the language of the process, and that of this thread independently of later choices of other threads, so that
/// each of several windows keeps its own.
pub fn set_language(language: Language) {
    CHOSEN.store(language as u8, Ordering::Relaxed);
    OVERRIDE.set(Some(language));
}

/// Runs `work` with this thread's text in `language`; data for programs is written in English in this way.
pub fn in_language<T>(language: Language, work: impl FnOnce() -> T) -> T {
    struct Restore(Option<Language>);
    impl Drop for Restore {
        fn drop(&mut self) {
            OVERRIDE.set(self.0);
        }
    }
    let _restore = Restore(OVERRIDE.replace(Some(language)));
    work()
}

/// A message without variables, put into words where it is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Message(pub &'static str);

impl Message {
    /// Returns the message in the current language.
    pub fn text(self) -> &'static str {
        message(self.0)
    }
}

/// Serializes the text for people, and the key for programs of this kind.
impl Serialize for Message {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let readable = serializer.is_human_readable();
        serializer.serialize_str(if readable { self.text() } else { self.0 })
    }
}

impl<'de> Deserialize<'de> for Message {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer).map(|key| Self(interned(&key)))
    }
}

/// Returns the one copy of a key that came from elsewhere.
pub fn interned(key: &str) -> &'static str {
    static KEYS: RwLock<BTreeSet<&'static str>> = RwLock::new(BTreeSet::new());
    let mut keys = KEYS.write().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = keys.get(key) {
        return known;
    }
    let key: &'static str = key.to_owned().leak();
    keys.insert(key);
    key
}

macro_rules! files {
    ($($(#[$where:meta])* $name:literal)*) => {
        const ENGLISH: &[(&str, &str)] =
            &[$($(#[$where])* ($name, include_str!(concat!("../assets/text/en/", $name, ".ftl")))),*];

        /// Files of the catalogue by language: name and content.
        #[cfg(not(target_arch = "wasm32"))]
        pub const FILES: [&[(&str, &str)]; 2] =
            [ENGLISH, &[$(($name, include_str!(concat!("../assets/text/zh-Hant/", $name, ".ftl")))),*]];
    };
}

files! {
    "parameters" "scenes" "problems" "render" "export" "document" "report" "point" "line" "picture" "engine"
    "controls" "lights" "files" "window" "links" "lesson" "course" "class" "animation"
    #[cfg(not(target_arch = "wasm32"))] "live"
    #[cfg(not(target_arch = "wasm32"))] "phone"
    #[cfg(not(target_arch = "wasm32"))] "wall"
    #[cfg(not(target_arch = "wasm32"))] "cli"
}

/// Fonts of all text except Chinese, by name.
#[cfg(not(target_arch = "wasm32"))]
pub const FONTS: [(&str, &[u8]); 2] = [
    ("Ubuntu-Light", epaint_default_fonts::UBUNTU_LIGHT),
    ("Hack", epaint_default_fonts::HACK_REGULAR),
];

/// Fonts of all text except Chinese, by name, reduced by `.ci/font`: the browser draws other letters.
#[cfg(target_arch = "wasm32")]
pub const FONTS: [(&str, &[u8]); 2] = [
    (
        "Ubuntu-Light",
        include_bytes!("../assets/fonts/Ubuntu-Light-subset.ttf"),
    ),
    (
        "Hack",
        include_bytes!("../assets/fonts/Hack-Regular-subset.ttf"),
    ),
];

/// Returns a font with the Chinese characters of the catalogue: Noto Sans CJK TC, reduced by `.ci/font`. A web page
/// fetches it when that language is chosen; until then it is empty.
#[cfg(not(target_arch = "wasm32"))]
pub fn chinese_font() -> &'static [u8] {
    include_bytes!("../assets/fonts/NotoSansTC-subset.otf")
}

#[cfg(target_arch = "wasm32")]
pub use fetched::{chinese_font, chinese_text, set_chinese_font, set_chinese_text};

/// The files that a web page fetches when Chinese is chosen.
#[cfg(target_arch = "wasm32")]
mod fetched {
    use std::sync::OnceLock;

    static FONT: OnceLock<Vec<u8>> = OnceLock::new();
    static TEXT: OnceLock<String> = OnceLock::new();

    /// Returns the font, empty until it has been fetched.
    pub fn chinese_font() -> &'static [u8] {
        FONT.get().map_or(&[], Vec::as_slice)
    }

    /// Sets the fetched font, the first time only.
    pub fn set_chinese_font(font: Vec<u8>) {
        let _ = FONT.set(font);
    }

    /// Returns the messages, empty until they have been fetched; text is English until then.
    pub fn chinese_text() -> &'static str {
        TEXT.get().map_or("", String::as_str)
    }

    /// Sets the fetched messages, the first time only.
    pub fn set_chinese_text(text: String) {
        let _ = TEXT.set(text);
    }
}

/// Returns the contents of the files of the catalogue, empty as long as they have not been fetched.
#[cfg(not(target_arch = "wasm32"))]
fn files(language: Language) -> Vec<&'static str> {
    FILES[language as usize]
        .iter()
        .map(|(_, file)| *file)
        .collect()
}

#[cfg(target_arch = "wasm32")]
fn files(language: Language) -> Vec<&'static str> {
    match language {
        Language::English => ENGLISH.iter().map(|(_, file)| *file).collect(),
        Language::TraditionalChinese => vec![chinese_text()],
    }
}

struct Catalogue {
    bundle: FluentBundle<FluentResource>,
    /// Messages without variables that have been requested.
    known: RwLock<HashMap<String, &'static str>>,
}

static CATALOGUES: [LazyLock<Catalogue>; 2] = [
    LazyLock::new(|| Catalogue::read(Language::English)),
    LazyLock::new(|| Catalogue::read(Language::TraditionalChinese)),
];

impl Catalogue {
    fn read(language: Language) -> Self {
        let locale: LanguageIdentifier = language.tag().parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![locale]);
        // Isolation marks are for text of mixed directions; both languages run from left to right.
        bundle.set_use_isolating(false);
        for file in files(language) {
            // A message with an error is omitted, and so is the second of two with one key; a test finds both.
            let resource = FluentResource::try_new(file.to_owned());
            let _ = bundle.add_resource(resource.unwrap_or_else(|(resource, _)| resource));
        }
        Self {
            bundle,
            known: RwLock::default(),
        }
    }

    fn fill(&self, key: &str, values: Option<&FluentArgs<'_>>) -> Option<String> {
        let (id, attribute) = key
            .split_once('.')
            .map_or((key, None), |(id, attribute)| (id, Some(attribute)));
        let message = self.bundle.get_message(id)?;
        let pattern = match attribute {
            Some(attribute) => message.get_attribute(attribute)?.value(),
            None => message.value()?,
        };
        let mut errors = Vec::new();
        let text = self.bundle.format_pattern(pattern, values, &mut errors);
        Some(text.into_owned())
    }
}

fn catalogue() -> &'static Catalogue {
    #[cfg(target_arch = "wasm32")]
    if chinese_text().is_empty() {
        return &CATALOGUES[Language::English as usize];
    }
    &CATALOGUES[language() as usize]
}

/// Returns whether the catalogue has a message.
pub fn has(key: &str) -> bool {
    catalogue().fill(key, None).is_some()
}

/// Returns a message without variables; its key if there is none, which a test finds.
pub fn message(key: &str) -> &'static str {
    let catalogue = catalogue();
    let known = catalogue
        .known
        .read()
        .unwrap_or_else(PoisonError::into_inner);
    if let Some(text) = known.get(key) {
        return text;
    }
    drop(known);
    let text = catalogue.fill(key, None);
    let text: &'static str = text.unwrap_or_else(|| key.to_owned()).leak();
    let mut known = catalogue
        .known
        .write()
        .unwrap_or_else(PoisonError::into_inner);
    known.entry(key.to_owned()).or_insert(text)
}

/// Joins words by the commas of the current language.
pub fn listed(words: impl IntoIterator<Item: Borrow<str>>) -> String {
    let words: Vec<_> = words.into_iter().collect();
    words.join(message("comma"))
}

/// Returns a message with its variables filled in.
pub fn filled(key: &str, values: &[(&'static str, Value<'_>)]) -> String {
    let mut variables = FluentArgs::with_capacity(values.len());
    for (name, value) in values {
        variables.set(*name, value.clone());
    }
    let text = catalogue().fill(key, Some(&variables));
    text.unwrap_or_else(|| key.to_owned())
}
