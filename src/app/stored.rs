//! The state stored between two runs: the appearance of the window and the progress of the course.

use super::{Appearance, SavedProgress};
use eframe::Storage;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// The storage key.
const KEY: &str = "look";

/// The settings and progress stored between two runs.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Stored {
    #[serde(rename = "look")]
    pub appearance: Appearance,
    pub course: SavedProgress,
}

/// The form in which [`Stored`] goes through the storage's text. The types of which it consists are read and
/// written as JSON elsewhere too; a second format's code for each would make the page 21 KB larger.
///
/// Untagged, since RON then gives the names of variants to a type that it does not know: so it reads the text
/// that [`Stored`] itself would be.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Passed {
    Value(Value),
}

impl Stored {
    /// Reads the state that an earlier run stored; the default if it cannot be read.
    pub fn read(storage: &dyn Storage) -> Self {
        // The stored text may have been written by anybody.
        eframe::get_value(storage, KEY)
            .and_then(|Passed::Value(mut value)| {
                drop_nulls(&mut value);
                serde_json::from_value(value).ok()
            })
            .unwrap_or_default()
    }

    /// Stores the state for the next run.
    pub fn write(&self, storage: &mut dyn Storage) {
        if let Ok(value) = serde_json::to_value(self) {
            eframe::set_value(storage, KEY, &Passed::Value(value));
        }
    }
}

/// Removes null fields, which then have their defaults: `None`, and numbers that are not finite, which JSON does not have.
fn drop_nulls(value: &mut Value) {
    match value {
        Value::Object(fields) => {
            fields.retain(|_, field| !field.is_null());
            fields.values_mut().for_each(drop_nulls);
        }
        Value::Array(all) => all.iter_mut().for_each(drop_nulls),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::{Answer, Answered, CurveFault, Grade, Hint, Record, Side};
    use crate::text::Language;
    use std::collections::HashMap;

    #[derive(Default)]
    struct Memory(HashMap<String, String>);

    impl Storage for Memory {
        fn get_string(&self, key: &str) -> Option<String> {
            self.0.get(key).cloned()
        }

        fn set_string(&mut self, key: &str, value: String) {
            self.0.insert(key.to_owned(), value);
        }

        fn remove_string(&mut self, key: &str) {
            self.0.remove(key);
        }

        fn flush(&mut self) {}
    }

    /// Returns a state in which no field has its default, with every kind of answer and hint.
    fn stored() -> Stored {
        let answers = [
            (Answer::Choice(2), Hint::Beside),
            (Answer::Value(0.1), Hint::Number { high: true }),
            (
                Answer::Point([-0.3, 1.0]),
                Hint::Place {
                    side: Side::In,
                    share: Some(0.25),
                },
            ),
            (
                Answer::Curve(vec![None, Some(0.4)]),
                Hint::Curve {
                    fault: CurveFault::NotZero,
                    from: -1.0,
                    to: 2.0,
                },
            ),
            (
                Answer::Settings(3.0),
                Hint::Control {
                    control: 1,
                    high: false,
                },
            ),
            (
                Answer::Formula("a = \"N\"·L\nmax(a, 0)".to_owned()),
                Hint::Formula {
                    point: 7,
                    given: None,
                    expected: Some([0.5, 1e-300, -0.0]),
                },
            ),
            (
                Answer::Order(vec![2, 0, 1]),
                Hint::Item {
                    item: 1,
                    places: -2,
                },
            ),
            (Answer::Match(vec![0.9, 5.0]), Hint::Beside),
        ];
        let mut record = Record::new("mach-bands", u64::MAX);
        for (step, (answer, hint)) in answers.into_iter().enumerate() {
            record.put(Answered {
                step,
                prediction: answer.clone(),
                answer,
                grade: Grade {
                    right: false,
                    score: 1.0 / 3.0,
                    off: Some(0.1 + 0.2),
                    model: (step % 2 == 0).then_some(step),
                    hint: Some(hint),
                },
                looked_up: 1,
                tries: 2,
                seconds: 10.5,
            });
        }
        let mut stored = Stored::default();
        let look = &mut stored.appearance;
        (look.scale, look.language) = (1.1, Some(Language::TraditionalChinese));
        (look.views, look.page) = (!look.views, "https://example.org/lab/".to_owned());
        look.recent = vec!["/a folder/b \"c\".toml".into()];
        let course = &mut stored.course;
        course.records = vec![record];
        course.done.insert("mach-bands".to_owned());
        course.name = "李 (Ada)".to_owned();
        course.left.insert("attenuation".to_owned(), 3);
        stored
    }

    #[test]
    fn what_is_stored_is_read_as_it_was() {
        let mut memory = Memory::default();
        stored().write(&mut memory);
        assert_eq!(Stored::read(&memory), stored());
        // As the text of the types themselves.
        eframe::set_value(&mut memory, KEY, &stored());
        assert!(memory.0[KEY].starts_with("(look:("), "{}", memory.0[KEY]);
        assert_eq!(Stored::read(&memory), stored());
        // A number that is not one costs no other field.
        let mut other = stored();
        other.appearance.scale = f32::NAN;
        other.write(&mut memory);
        other.appearance.scale = Stored::default().appearance.scale;
        assert_eq!(Stored::read(&memory), other);
    }

    #[test]
    fn what_cannot_be_read_is_the_default() {
        for text in [
            "",
            "(",
            "7",
            "(look:7)",
            "{\"look\":[1]}",
            "(look:(scale:\"wide\"))",
        ] {
            let memory = Memory([(KEY.to_owned(), text.to_owned())].into());
            assert_eq!(Stored::read(&memory), Stored::default(), "{text}");
        }
    }
}
