//! Lessons and expressions made at random: each is read or refused, and none crashes the reader.

use crate::common::dice::Dice;
use crate::common::lessons::EVERY_KIND;
use crate::common::tries::tries;
use shading_lab::expression::{self, Expression, Part, Quantities, Todo, arithmetic};
use shading_lab::lesson::Lesson;

fn below(dice: &mut Dice, count: usize) -> usize {
    (dice.between(0.0, count as f64) as usize).min(count - 1)
}

/// Pieces that mutations insert.
const PIECES: [&str; 40] = [
    "```",
    "```step\n",
    "```question\n",
    "+++\n",
    "## ",
    "# ",
    "{{",
    "}}",
    "| 99",
    "[[option]]\n",
    "[[item]]\n",
    "\"",
    "'",
    "\\",
    "[",
    "]",
    "=",
    "\n",
    "\r",
    "\0",
    "$",
    "`",
    "<!--",
    "<div>",
    "é",
    "界",
    "\u{feff}",
    "\u{202e}",
    "1e999",
    "-1",
    "nan",
    "true",
    "inf",
    "99999999999999999999",
    "~~~",
    "    ",
    "> ",
    "- ",
    "|---|\n",
    "&#x0;",
];

fn mutated(dice: &mut Dice) -> String {
    let mut text = EVERY_KIND.to_owned();
    let place = |dice: &mut Dice, text: &str| {
        let mut at = below(dice, text.len() + 1);
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    for _ in 0..=below(dice, 6) {
        let (a, b) = (place(dice, &text), place(dice, &text));
        let (from, to) = (a.min(b), a.max(b).min(a.min(b) + 400));
        let to = (to..=text.len())
            .find(|to| text.is_char_boundary(*to))
            .unwrap_or(text.len());
        match below(dice, 6) {
            0 => text.replace_range(from..to, ""),
            1 => {
                let piece = text[from..to].to_owned();
                let at = place(dice, &text);
                text.insert_str(at, &piece);
            }
            2 if from > 60 => text.truncate(from),
            _ => text.insert_str(from, dice.of(&PIECES)),
        }
    }
    text
}

#[test]
fn mutated_lessons_are_read_or_refused_with_a_line() {
    let mut dice = Dice(17);
    let (tries, mut read, mut refused) = (tries(10_000), 0, 0);
    for _ in 0..tries {
        let text = mutated(&mut dice);
        match Lesson::read(&text, None) {
            Ok(lesson) => {
                assert!(!lesson.steps.is_empty() && lesson.source == text);
                read += 1;
            }
            Err(error) => {
                assert!(!error.problems.is_empty(), "{text}");
                let lines = 1 + text.matches('\n').count() as u64;
                for problem in &error.problems {
                    assert!((1..=lines).contains(&problem.line), "{error}\n{text}");
                    assert!(!problem.words.is_empty());
                }
                refused += 1;
            }
        }
    }
    // Both must happen often, or the mutations test nothing.
    assert!(
        100 * read > tries && 10 * refused > tries,
        "{read} read, {refused} refused"
    );
}

/// Quantities for expressions under test: fixed numbers and lists, a truth value, a NaN, and one that fails.
struct Stub;

impl Quantities for Stub {
    fn quantity(&self, name: &str, parts: &[Part]) -> Result<expression::Value, String> {
        match (name, parts.len()) {
            ("probe", 0) => Ok(expression::Value::List(vec![
                expression::Value::Number(1.0),
                expression::Value::Truth(true),
            ])),
            ("scene", _) => Ok(expression::Value::Number(f64::NAN)),
            ("x", _) => Ok(expression::Value::Number(2.0)),
            ("nothing", _) => Err("nothing".to_owned()),
            _ => Ok(expression::Value::List(vec![expression::Value::Number(
                parts.len() as f64,
            )])),
        }
    }

    fn with(&self, _: &str, todo: Todo<'_>) -> Result<expression::Value, String> {
        todo(self)
    }

    fn at(&self, _: f64, _: f64, todo: Todo<'_>) -> Result<expression::Value, String> {
        todo(self)
    }
}

const WORDS: [&str; 48] = [
    "1",
    "2.5",
    "1e3",
    ".5",
    "0",
    "1e999",
    "pi",
    "inf",
    "x",
    "probe",
    "scene",
    "nothing",
    "profile.samples[*].gouraud",
    "[0]",
    "[*]",
    "[\"a b\"]",
    ".n",
    "+",
    "-",
    "*",
    "/",
    "^",
    "(",
    ")",
    "<",
    "<=",
    "==",
    "!=",
    ">",
    "and",
    "or",
    "not",
    ",",
    "abs(",
    "sqrt(",
    "min(",
    "max(",
    "mean(",
    "dot(",
    "luminance(",
    "length(",
    "with(\"a=1;b=2\",",
    "at(0,0,",
    "log(",
    "asin(",
    "\"",
    "é",
    " ",
];

#[test]
fn no_expression_takes_the_reader_down() {
    let mut dice = Dice(5);
    let (tries, mut valued) = (tries(200_000), 0);
    for _ in 0..tries {
        let words = 1 + below(&mut dice, 14);
        let text: String = (0..words).map(|_| dice.of(&WORDS)).collect();
        if let Ok(expression) = Expression::read(&text) {
            let number = expression.number(&Stub);
            assert!(number.as_ref().is_ok_and(|number| number.is_finite()) || number.is_err());
            let _ = expression.holds(&Stub);
            valued += u64::from(number.is_ok());
        }
    }
    assert!(400 * valued > tries, "{valued}");
}

#[test]
fn the_longest_and_deepest_expressions_are_read_or_refused() {
    for text in [
        "1".to_owned() + &"+1".repeat(2047),
        "1".to_owned() + &"^1".repeat(2047),
        "1".to_owned() + &"<1".repeat(2047),
        "1".to_owned() + &" or 1<0".repeat(580),
        "-".repeat(4095) + "1",
        "(".repeat(2000) + "1" + &")".repeat(2000),
        "abs(".repeat(60) + "1" + &")".repeat(60),
        "not ".repeat(1000) + "1",
        "x".to_owned() + &"[0]".repeat(1300),
        "sum(".to_owned() + &"1,".repeat(2000) + "1)",
        "1".repeat(4097),
    ] {
        if let Ok(expression) = Expression::read(&text) {
            let _ = expression.value(&Stub);
        }
    }
    assert_eq!(
        arithmetic(&("1".to_owned() + &"+1".repeat(200))),
        Some(201.0)
    );
    assert_eq!(arithmetic(&("1".to_owned() + &"+1".repeat(2000))), None);
    assert_eq!(arithmetic("max(-0 == 0, 0)"), Some(1.0));
}

/// Returns a random expression and its value as Rust computes it.
fn random(dice: &mut Dice, depth: usize) -> (String, f64) {
    if depth == 0 {
        let number = below(dice, 2000) as f64 / 100.0;
        return (format!("{number}"), number);
    }
    let (a, x) = random(dice, depth - 1);
    let shallower = below(dice, depth);
    let (b, y) = random(dice, shallower);
    match below(dice, 9) {
        0 => (format!("({a} + {b})"), x + y),
        1 => (format!("({a} - {b})"), x - y),
        2 => (format!("({a}) * ({b})"), x * y),
        3 => (format!("(({a}) / ({b}))"), x / y),
        4 => (format!("-({a})"), -x),
        5 => (format!("min({a}, {b})"), x.min(y)),
        6 => (format!("abs({a})"), x.abs()),
        7 => (format!("cos({a})"), x.to_radians().cos()),
        _ => (format!("max(({a}) < ({b}), 0)"), f64::from(u8::from(x < y))),
    }
}

#[test]
fn arithmetic_is_that_of_rust() {
    let mut dice = Dice(23);
    for _ in 0..2000 {
        let depth = 1 + below(&mut dice, 6);
        let (text, value) = random(&mut dice, depth);
        match arithmetic(&text) {
            // A division by 0, or a sum of infinities.
            None => assert!(!value.is_finite(), "{text} = {value}"),
            Some(found) => assert!(
                found == value || (found - value).abs() <= 1e-9 * value.abs().max(1.0),
                "{text} = {value}, not {found}"
            ),
        }
    }
}
