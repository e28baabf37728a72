//! From a parsed TOML document to a [`Scene`]: a serde deserializer that keeps the place and the key of what it objects
//! to, and collects unknown keys instead of stopping at the first.

use super::super::Scene;
use super::super::problem::{Cause, quoted};
use serde::de::value::StrDeserializer;
use serde::de::{
    self, Deserialize, DeserializeSeed, Deserializer, Expected, IntoDeserializer, MapAccess, SeqAccess, Unexpected,
    Visitor,
};
use serde::forward_to_deserialize_any;
use std::cell::RefCell;
use std::fmt;
use toml::Spanned;
use toml::de::{DeFloat, DeInteger, DeTable, DeValue};

/// Something to object to, at a byte of the text.
#[derive(Debug)]
pub struct Finding {
    pub offset: usize,
    pub key: String,
    pub cause: Cause,
}

/// Reads a document: the scene, unless a value could not be read, and everything found on the way. Ranges are not
/// looked at.
pub fn read(document: &DeTable<'_>) -> (Option<Scene>, Vec<Finding>) {
    if let Some(finding) = wrong_version(document) {
        return (None, vec![finding]);
    }
    let unknown = RefCell::new(Vec::new());
    let reader = TableReader { table: document, key: "", unknown: &unknown };
    let scene = Scene::deserialize(reader);
    let mut findings = unknown.into_inner();
    match scene {
        Ok(scene) => (Some(scene), findings),
        Err(ReadError { offset, key, cause }) => {
            findings.push(Finding { offset, key: key.unwrap_or_default(), cause });
            (None, findings)
        }
    }
}

/// Another version's keys mean nothing here, so its number is all that is reported.
fn wrong_version(document: &DeTable<'_>) -> Option<Finding> {
    let (key, value) = document.get_key_value("version")?;
    let DeValue::Integer(number) = value.get_ref() else { return None };
    if integer(number) == Some(i64::from(Scene::VERSION)) {
        return None;
    }
    let cause = Cause::Version { found: number.to_string() };
    Some(Finding { offset: key.span().start, key: "version".into(), cause })
}

/// A table as a struct.
#[derive(Clone, Copy)]
struct TableReader<'a, 'i> {
    table: &'a DeTable<'i>,
    key: &'a str,
    unknown: &'a RefCell<Vec<Finding>>,
}

impl TableReader<'_, '_> {
    fn inner_key(&self, name: &str) -> String {
        if self.key.is_empty() { name.to_owned() } else { format!("{}.{name}", self.key) }
    }
}

impl<'de> Deserializer<'de> for TableReader<'_, '_> {
    type Error = ReadError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_map(Entries { reader: self, entries: self.table.iter(), known: None, value: None })
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        known: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        visitor.visit_map(Entries { reader: self, entries: self.table.iter(), known: Some(known), value: None })
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}

struct Entries<'a, 'i, I> {
    reader: TableReader<'a, 'i>,
    entries: I,
    known: Option<&'static [&'static str]>,
    value: Option<ValueReader<'a, 'i>>,
}

impl<'de, 'a, 'i: 'a, I> MapAccess<'de> for Entries<'a, 'i, I>
where
    I: Iterator<Item = (&'a Spanned<toml::de::DeString<'i>>, &'a Spanned<DeValue<'i>>)>,
{
    type Error = ReadError;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, ReadError> {
        for (name, value) in self.entries.by_ref() {
            let (offset, key) = (name.span().start, self.reader.inner_key(name.get_ref()));
            if let Some(known) = self.known
                && !known.contains(&name.get_ref().as_ref())
            {
                self.reader.unknown.borrow_mut().push(Finding { offset, key, cause: Cause::UnknownKey { known } });
                continue;
            }
            self.value = Some(ValueReader { value: value.get_ref(), offset, key, unknown: self.reader.unknown });
            let name: StrDeserializer<'_, ReadError> = name.get_ref().as_ref().into_deserializer();
            return seed.deserialize(name).map(Some);
        }
        Ok(None)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, ReadError> {
        let value = self.value.take().ok_or_else(|| <ReadError as de::Error>::custom("a value without a key"))?;
        seed.deserialize(value)
    }
}

/// A value of any type.
struct ValueReader<'a, 'i> {
    value: &'a DeValue<'i>,
    offset: usize,
    key: String,
    unknown: &'a RefCell<Vec<Finding>>,
}

impl ValueReader<'_, '_> {
    fn table(&self) -> Option<TableReader<'_, '_>> {
        let table = self.value.as_table()?;
        Some(TableReader { table, key: &self.key, unknown: self.unknown })
    }

    fn visit<'de, V: Visitor<'de>>(&self, visitor: V) -> Result<V::Value, ReadError> {
        match self.value {
            DeValue::String(text) => visitor.visit_str(text),
            DeValue::Boolean(value) => visitor.visit_bool(*value),
            DeValue::Integer(number) => match integer(number) {
                Some(whole) => visitor.visit_i64(whole),
                None => visitor.visit_f64(number.as_str().parse().map_err(|_| too_large(&number.to_string()))?),
            },
            DeValue::Float(number) => visitor.visit_f64(float(number)?),
            DeValue::Datetime(_) => Err(de::Error::invalid_type(Unexpected::Other("a date"), &visitor)),
            DeValue::Array(_) => self.visit_array(visitor),
            DeValue::Table(table) => {
                TableReader { table, key: &self.key, unknown: self.unknown }.deserialize_any(visitor)
            }
        }
    }

    fn visit_array<'de, V: Visitor<'de>>(&self, visitor: V) -> Result<V::Value, ReadError> {
        let list = self.value.as_array().map_or(&[][..], |list| list.iter().as_slice());
        let expected = expectation(&visitor);
        let mut elements = Elements { reader: self, list, next: 0 };
        let value = visitor.visit_seq(&mut elements)?;
        if elements.next < list.len() {
            let cause = Cause::Value { found: format!("a list of {}", list.len()), expected };
            return Err(ReadError { offset: self.offset, key: Some(self.key.clone()), cause });
        }
        Ok(value)
    }

    fn placed(&self, error: ReadError) -> ReadError {
        match error.key {
            Some(_) => error,
            None => ReadError { offset: self.offset, key: Some(self.key.clone()), ..error },
        }
    }
}

impl<'de> Deserializer<'de> for ValueReader<'_, '_> {
    type Error = ReadError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        self.visit(visitor).map_err(|error| self.placed(error))
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_some(self)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        known: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        match self.table() {
            Some(table) => table.deserialize_struct(name, known, visitor),
            None => {
                let cause = Cause::Value { found: found(self.value), expected: "a table of keys".into() };
                Err(self.placed(cause.into()))
            }
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        known: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        let cause = match self.value {
            DeValue::String(word) if known.contains(&word.as_ref()) => {
                let word: StrDeserializer<'_, ReadError> = word.as_ref().into_deserializer();
                return visitor.visit_enum(word).map_err(|error| self.placed(error));
            }
            DeValue::String(word) => Cause::UnknownWord { word: word.to_string(), known },
            other => Cause::Value { found: found(other), expected: format!("one of {}", known.join(", ")) },
        };
        Err(self.placed(cause.into()))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct
        newtype_struct seq tuple tuple_struct map identifier ignored_any
    }
}

struct Elements<'a, 'i> {
    reader: &'a ValueReader<'a, 'i>,
    list: &'a [Spanned<DeValue<'i>>],
    next: usize,
}

impl<'de> SeqAccess<'de> for &mut Elements<'_, '_> {
    type Error = ReadError;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, ReadError> {
        let Some(element) = self.list.get(self.next) else { return Ok(None) };
        let key = format!("{}.{}", self.reader.key, self.next);
        self.next += 1;
        let unknown = self.reader.unknown;
        let reader = ValueReader { value: element.get_ref(), offset: element.span().start, key, unknown };
        seed.deserialize(reader).map(Some)
    }
}

/// What ended the reading. The key and its place are added on the way out.
#[derive(Debug)]
struct ReadError {
    offset: usize,
    key: Option<String>,
    cause: Cause,
}

impl From<Cause> for ReadError {
    fn from(cause: Cause) -> Self {
        Self { offset: 0, key: None, cause }
    }
}

impl std::error::Error for ReadError {}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.cause)
    }
}

impl de::Error for ReadError {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Cause::Other(message.to_string()).into()
    }

    fn invalid_type(unexpected: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Cause::Value { found: described(&unexpected), expected: expectation(expected) }.into()
    }

    fn invalid_value(unexpected: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Self::invalid_type(unexpected, expected)
    }

    fn invalid_length(length: usize, expected: &dyn Expected) -> Self {
        Cause::Value { found: format!("a list of {length}"), expected: expectation(expected) }.into()
    }
}

/// What a type expects, in the words of a scene's author.
fn expectation(expected: &dyn Expected) -> String {
    let words = expected.to_string();
    match words.as_str() {
        "f64" => "a number",
        "u32" => "a whole number, 0 or more",
        "a boolean" => "true or false",
        "a sequence" => "a list of tables",
        "path string" => "a path in quotation marks",
        "a sequence of 3 f64 values" => "a list of three numbers",
        "an array of length 2" => "a list of two whole numbers",
        _ => return words,
    }
    .to_owned()
}

fn described(unexpected: &Unexpected<'_>) -> String {
    match unexpected {
        Unexpected::Bool(value) => value.to_string(),
        Unexpected::Signed(number) => number.to_string(),
        Unexpected::Float(number) => format!("{number:?}"),
        Unexpected::Str(text) => quoted(text),
        Unexpected::Seq => "a list".to_owned(),
        Unexpected::Map => "a table of keys".to_owned(),
        Unexpected::Other(what) => (*what).to_owned(),
        other => other.to_string(),
    }
}

fn found(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => quoted(text),
        DeValue::Integer(number) => number.to_string(),
        DeValue::Float(number) => number.to_string(),
        DeValue::Boolean(value) => value.to_string(),
        DeValue::Datetime(_) => "a date".to_owned(),
        DeValue::Array(_) => "a list".to_owned(),
        DeValue::Table(_) => "a table of keys".to_owned(),
    }
}

fn integer(number: &DeInteger<'_>) -> Option<i64> {
    i64::from_str_radix(number.as_str(), number.radix()).ok()
}

fn float(number: &DeFloat<'_>) -> Result<f64, ReadError> {
    let text = number.as_str();
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() || text.ends_with("inf") || text.ends_with("nan") => Ok(value),
        _ => Err(too_large(text)),
    }
}

fn too_large(text: &str) -> ReadError {
    Cause::Value { found: text.to_owned(), expected: "a number below 1.8e308 (or inf)".into() }.into()
}
