//! Random, structure-aware mutations of inputs: each is read or refused, in bounded time and memory.
//!
//! `FUZZ_SECONDS=3600 cargo test --release --test lessons fuzz` spends an hour on each format, `FUZZ_COUNT=100000` tries that
//! many inputs of each, and `FUZZ_SEED=7` starts from another seed. `--nocapture` prints how many inputs were tried and how many
//! were valid.

use super::dice::Dice;
use super::lessons::EVERY_KIND;
use shading_lab::lesson::Lesson;
use std::env;
use std::time::{Duration, Instant};

/// Seconds for each format, unless the environment says otherwise.
const SECONDS: f64 = 8.0;
/// Maximum time for one input.
const PATIENCE: Duration = Duration::from_secs(10);
/// Maximum growth of the process while it reads all inputs, bytes.
const MEMORY: u64 = 1 << 30;
/// Maximum length of an input, bytes.
const LENGTH: usize = 1 << 18;

/// Pieces that formats share, and numbers that are hard.
const PIECES: [&str; 28] = [
    "0",
    "-1",
    "1e308",
    "-1e-308",
    "1e999",
    "nan",
    "inf",
    "-0.0",
    "4294967296",
    "9223372036854775808",
    "[",
    "]",
    "{",
    "}",
    "\"",
    "'",
    "\n",
    "\r\n",
    "=",
    "#",
    "//",
    "\u{0}",
    "\u{feff}",
    "\u{202e}",
    "é",
    "𝕏",
    "true",
    " ",
];

/// A format: valid inputs, its keywords, and a reader, which returns whether an input was valid.
pub struct Format {
    pub name: &'static str,
    pub sound: Vec<Vec<u8>>,
    pub words: &'static [&'static str],
    pub read: fn(&[u8]) -> bool,
    /// True if inputs are PNG files, whose chunks are changed within.
    pub png: bool,
}

impl Format {
    pub fn fuzz(&self) {
        let set = |name: &str| env::var(name).ok()?.parse::<f64>().ok();
        let count = set("FUZZ_COUNT").map_or(u64::MAX, |count| count as u64);
        let seconds = match set("FUZZ_SECONDS") {
            Some(seconds) => seconds,
            None if count < u64::MAX => f64::INFINITY,
            None => SECONDS,
        };
        let first = set("FUZZ_SEED").unwrap_or(1.0) as u64;
        for input in &self.sound {
            assert!((self.read)(input), "{} refuses what is sound", self.name);
        }
        let (begun, before) = (Instant::now(), peak_memory());
        let (mut tried, mut sound) = (0, 0);
        while tried < count && begun.elapsed().as_secs_f64() < seconds {
            let seed = first.wrapping_mul(1 << 32).wrapping_add(tried);
            let input = self.changed(&mut Dice(seed));
            let start = Instant::now();
            let read = std::panic::catch_unwind(|| (self.read)(&input));
            let Ok(read) = read else {
                panic!(
                    "{} panics at FUZZ_SEED={first}, input {tried}: {:?}",
                    self.name,
                    String::from_utf8_lossy(&input)
                );
            };
            let took = start.elapsed();
            assert!(
                took < PATIENCE,
                "{}: input {tried} of FUZZ_SEED={first} took {took:?}",
                self.name
            );
            sound += u64::from(read);
            tried += 1;
        }
        let grown = peak_memory().saturating_sub(before);
        assert!(grown < MEMORY, "{} took {grown} bytes", self.name);
        println!(
            "{}: {tried} tried, {sound} of them sound, {} MiB",
            self.name,
            grown >> 20
        );
        // If all inputs were refused at once, nothing else would be tested.
        assert!(
            tried < 1000 || sound > 0 && sound < tried,
            "{}: {sound} of {tried} are sound",
            self.name
        );
    }

    /// Returns a valid input with some changes.
    pub fn changed(&self, dice: &mut Dice) -> Vec<u8> {
        let mut input = self.sound[below(dice, self.sound.len())].clone();
        for _ in 0..=below(dice, 5) {
            if self.png && dice.unit() < 0.8 {
                self.change_chunk(&mut input, dice);
            } else {
                self.change(&mut input, dice);
            }
        }
        input.truncate(LENGTH);
        input
    }

    fn change(&self, input: &mut Vec<u8>, dice: &mut Dice) {
        if input.is_empty() {
            return;
        }
        let at = below(dice, input.len());
        let to = (at + 1 + below(dice, 40)).min(input.len());
        match below(dice, 9) {
            0 => input[at] ^= 1 << below(dice, 8),
            1 => drop(input.drain(at..to)),
            2 => {
                let piece = input[at..to].to_vec();
                let times = if dice.unit() < 0.05 {
                    2000
                } else {
                    1 + below(dice, 3)
                };
                splice(input, at, &piece.repeat(times));
            }
            3 => splice(input, at, dice.of(&PIECES).as_bytes()),
            4 => splice(input, at, dice.of(self.words).as_bytes()),
            5 => {
                // Replaces a number by another.
                let digit = |byte: &u8| byte.is_ascii_digit();
                if let Some(start) = input[at..].iter().position(digit).map(|step| at + step) {
                    let length = input[start..].iter().take_while(|byte| digit(byte)).count();
                    input.drain(start..start + length);
                    splice(input, start, dice.of(&PIECES[..10]).as_bytes());
                }
            }
            6 => {
                let other = &self.sound[below(dice, self.sound.len())];
                let from = below(dice, other.len().max(1));
                let piece = other[from..(from + 400).min(other.len())].to_vec();
                splice(input, at, &piece);
            }
            7 => input.truncate(at),
            _ => {
                // Swaps two lines.
                let mut lines: Vec<&[u8]> = input.split(|byte| *byte == b'\n').collect();
                let (a, b) = (below(dice, lines.len()), below(dice, lines.len()));
                lines.swap(a, b);
                *input = lines.join(&b'\n');
            }
        }
    }

    /// Changes the content of a chunk of a PNG and corrects its length and checksum.
    fn change_chunk(&self, png: &mut Vec<u8>, dice: &mut Dice) {
        let mut chunks = chunks(png);
        if chunks.is_empty() {
            return;
        }
        let at = below(dice, chunks.len());
        if dice.unit() < 0.1 {
            let copy = chunks[at].clone();
            chunks.insert(below(dice, chunks.len()), copy);
        } else {
            self.change(&mut chunks[at].1, dice);
        }
        let mut out = png[..8].to_vec();
        for (kind, content) in chunks {
            out.extend((content.len() as u32).to_be_bytes());
            let from = out.len();
            out.extend(kind);
            out.extend(content);
            let check = crc(&out[from..]);
            out.extend(check.to_be_bytes());
        }
        *png = out;
    }
}

fn below(dice: &mut Dice, count: usize) -> usize {
    (dice.between(0.0, count as f64) as usize).min(count.saturating_sub(1))
}

fn splice(input: &mut Vec<u8>, at: usize, piece: &[u8]) {
    input.splice(at..at, piece.iter().copied());
}

/// Returns the chunks of a PNG with their types, as far as they can be followed.
fn chunks(png: &[u8]) -> Vec<([u8; 4], Vec<u8>)> {
    let mut found = Vec::new();
    let mut rest = png.get(8..).unwrap_or_default();
    while let Some((head, after)) = rest.split_at_checked(8) {
        let length = u32::from_be_bytes([head[0], head[1], head[2], head[3]]) as usize;
        let Some((content, after)) = after.split_at_checked(length) else {
            break;
        };
        found.push(([head[4], head[5], head[6], head[7]], content.to_vec()));
        rest = after.get(4..).unwrap_or_default();
    }
    found
}

/// Returns the checksum of a chunk (PNG specification, annex D).
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
            (crc >> 1) ^ (0xedb8_8320 & (crc & 1).wrapping_neg())
        })
    })
}

/// Returns the peak memory of the process, bytes; 0 where the system does not report it.
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.trim().strip_suffix(" kB")?.parse::<u64>().ok());
    kilobytes.unwrap_or(0) << 10
}

pub fn text(bytes: &[u8]) -> std::borrow::Cow<'_, str> {
    String::from_utf8_lossy(bytes)
}

/// Returns whether every step is cheap to draw: work is bounded, but the bound is too high to be reached thousands of times.
pub fn is_small(lesson: &Lesson) -> bool {
    lesson.steps.iter().all(|step| {
        step.stage.load(None).is_ok_and(|staged| {
            let [width, height] = staged.scene.image.size;
            let few = staged.scene.object.segments.max(staged.scene.object.rings) <= 64;
            width * height <= 1 << 16 && few && staged.scene.lights.len() <= 3
        })
    })
}

/// Returns a lesson for each question of [`EVERY_KIND`], its scene coarse enough to try thousands of mutations.
fn small_lessons() -> Vec<Vec<u8>> {
    let coarse = "\"image.size=[24,24]\", \"object.segments=8\", \"object.rings=6\"";
    let lesson = EVERY_KIND.replace("\"image.size=[96,96]\"", coarse);
    let question = lesson.find("```question").expect("a first question");
    let (beginning, questions) = lesson.split_at(question);
    let lessons = questions.split("\n## ").map(|section| {
        let (_, question) = section.split_once("```question").expect("a question");
        let lesson = format!("{beginning}```question{question}");
        let read = Lesson::read(&lesson, None).expect("a lesson");
        assert!(is_small(&read), "nothing would be gone through");
        lesson.into_bytes()
    });
    lessons.collect()
}

/// Returns the format of lessons with one step, for every kind of question.
pub fn lessons_of_every_kind(name: &'static str, read: fn(&[u8]) -> bool) -> Format {
    Format {
        name,
        sound: small_lessons(),
        words: &[
            "x = [0, 5e-324]\n",
            "y = [-1e300, 1e300]\n",
            "tolerance = 1e-300\n",
            "from = -1e308\n",
            "answer = \"x*1e308\"\n",
            "unit = \"𝕏\"\n",
            "[[wrong]]\nsays = \"{{ probe.sum[0] | 9 }}\"\n",
            "[[wrong]]\nsays = \"No.\"\nset = [\"material.kd=0\"]\n",
            "at = [8, -8]\n",
            "find = \"zero\"\n",
            "equals = \"1e308\"\n",
            "probe = [1e9, -1e9]\n",
            "line = [0, 0, 0, 0]\n",
            "set = [\"image.size=[1,300]\"]\n",
            "light.0.position=[0,0,0]",
            "{{ probe.sum[0] | 9 }}",
            "picture.mean",
            "$\\frac{$",
            "<script>",
        ],
        read,
        png: false,
    }
}

/// Returns a mutated lesson that can still be opened.
pub fn any_lesson(dice: &mut Dice) -> Lesson {
    let format = lessons_of_every_kind("lessons", |_| true);
    loop {
        let lesson = Lesson::read(&text(&format.changed(dice)), None);
        if let Some(lesson) = lesson.ok().filter(is_small) {
            return lesson;
        }
    }
}
