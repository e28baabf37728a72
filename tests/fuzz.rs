//! What other people send: scenes, models, pictures, links, lessons and handed-in answers, changed at random in ways that know
//! their structure. Each is read or refused, in bounded time and memory, and what is read survives being written.
//!
//! `FUZZ_SECONDS=3600 cargo test --release --test fuzz` goes on for an hour with each, `FUZZ_COUNT=100000` tries so many of each, and
//! `FUZZ_SEED=7` begins elsewhere. `--nocapture` prints how many were tried and how many were sound.

#[path = "common/dice.rs"]
mod dice;
#[path = "common/lessons.rs"]
mod lessons;

use dice::Dice;
use shading_lab::geometry::read_obj;
use shading_lab::lesson::{
    Answer, Answered, Grade, Handed, LESSONS, Lab, Lesson, Record, Worksheet, check, class_sheet,
    collect, hand_in_bytes, in_words, read_hand_in, worksheet,
};
use shading_lab::link;
use shading_lab::picture::{read_scene_text, write_png};
use shading_lab::render::{Frame, Renderer};
use shading_lab::scene::{ObjectKind, Scene, presets};
use shading_lab::text::Language;
use std::env;
use std::io::Cursor;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// For each format, unless the environment says otherwise.
const SECONDS: f64 = 8.0;
/// Longest that one input may take.
const PATIENCE: Duration = Duration::from_secs(10);
/// Most that the process may grow by while it reads all of them, bytes.
const MEMORY: u64 = 1 << 30;
/// Longest input, bytes.
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

/// A format: what is sound in it, its own words, and how it is read; that tells whether an input was sound.
struct Format {
    name: &'static str,
    sound: Vec<Vec<u8>>,
    words: &'static [&'static str],
    read: fn(&[u8]) -> bool,
    /// Whether inputs are PNG files, whose chunks are changed within.
    png: bool,
}

impl Format {
    fn fuzz(&self) {
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
        // Inputs that are all refused at once would test nothing but that.
        assert!(
            tried < 1000 || sound > 0 && sound < tried,
            "{}: {sound} of {tried} are sound",
            self.name
        );
    }

    /// An input with some changes.
    fn changed(&self, dice: &mut Dice) -> Vec<u8> {
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
                // A number gives way to another.
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
                // Two lines change places.
                let mut lines: Vec<&[u8]> = input.split(|byte| *byte == b'\n').collect();
                let (a, b) = (below(dice, lines.len()), below(dice, lines.len()));
                lines.swap(a, b);
                *input = lines.join(&b'\n');
            }
        }
    }

    /// Changes the content of a chunk of a PNG, whose length and check are then right again.
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

/// The chunks of a PNG with their kinds, as far as they can be followed.
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

/// The check of a chunk (PNG specification, annex D).
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
            (crc >> 1) ^ (0xedb8_8320 & (crc & 1).wrapping_neg())
        })
    })
}

/// The most memory that the process has had, bytes; 0 where the system does not say.
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.trim().strip_suffix(" kB")?.parse::<u64>().ok());
    kilobytes.unwrap_or(0) << 10
}

fn text(bytes: &[u8]) -> std::borrow::Cow<'_, str> {
    String::from_utf8_lossy(bytes)
}

#[test]
fn scenes() {
    let format = Format {
        name: "scenes",
        sound: presets::ALL
            .iter()
            .map(|preset| preset.scene().to_toml().into_bytes())
            .collect(),
        words: &[
            "[material]\n",
            "[[light]]\n",
            "[compare]\n",
            "kind = \"area\"\n",
            "samples = 4096\n",
            "segments = 4096\n",
            "n = inf\n",
            "[[compare.pane]]\n",
        ],
        read: |bytes| {
            let Ok(scene) = Scene::parse(&text(bytes), "fuzz.toml") else {
                return false;
            };
            let again = Scene::parse(&scene.to_toml(), "again.toml");
            assert_eq!(again.as_ref(), Ok(&scene), "it does not survive its file");
            draw(scene);
            true
        },
        png: false,
    };
    format.fuzz();
}

/// Draws a small picture of the scene, with less of whatever there is much of.
fn draw(mut scene: Scene) {
    if scene.object.kind == ObjectKind::Obj {
        return;
    }
    scene.image.size = [16, 12];
    scene.object.segments = scene.object.segments.min(24);
    scene.object.rings = scene.object.rings.min(24);
    scene.lights.truncate(4);
    for light in &mut scene.lights {
        light.samples = light.samples.min(8);
    }
    if scene.validate().is_ok() {
        let frame = Renderer::default().render(&scene).clone();
        assert_eq!([frame.width, frame.height], [16, 12]);
    }
}

#[test]
fn models() {
    let tower = include_bytes!("data/obj/tower.obj").to_vec();
    let small = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf -3 -2 -1\n".to_vec();
    let format = Format {
        name: "models",
        sound: vec![tower, small],
        words: &[
            "v ",
            "vn ",
            "vt ",
            "f ",
            "f 1/1/1 2/2/2 3/3/3\n",
            "o a\n",
            "g b\n",
            "usemtl m\n",
            "mtllib /etc/passwd\n",
            "s 1\n",
            "\\\n",
            "-1",
            "//",
            "1/2/3",
        ],
        read: |bytes| read_obj(Cursor::new(bytes), &mut |_| {}).is_ok(),
        png: false,
    };
    format.fuzz();
}

#[test]
fn pictures() {
    let format = Format {
        name: "pictures",
        sound: ["sphere", "three-lights", "flat-facets"]
            .map(picture_of)
            .to_vec(),
        words: &[
            "shading-lab:scene",
            "iTXt",
            "zTXt",
            "tEXt",
            "IEND",
            "version = 1\n",
            "[object]\npath = \"a.obj\"\n",
        ],
        read: |bytes| match read_scene_text(Cursor::new(bytes)) {
            Ok(text) => Scene::parse(&text, "fuzz.png").is_ok(),
            Err(_) => false,
        },
        png: true,
    };
    format.fuzz();
}

fn frame() -> Frame {
    Frame {
        width: 8,
        height: 8,
        pixels: vec![[10, 20, 30, 255]; 64],
    }
}

fn picture_of(name: &str) -> Vec<u8> {
    let scene = presets::find(name).expect("a built-in scene").scene();
    shading_lab::document::picture_bytes(&frame(), Some(&scene)).expect("a picture")
}

#[test]
fn links() {
    let written = |name: &str| {
        format!(
            "?scene={name}&set=material.n=50&set=shading.mode=gouraud&view=profile&probe=0.1,-0.2"
        )
    };
    let format = Format {
        name: "links",
        sound: presets::ALL
            .iter()
            .map(|preset| written(preset.name).into_bytes())
            .chain([
                b"?lesson=exponent&step=3".to_vec(),
                b"https://example.org/lab/?embed&controls=n,ks&scene=highlight#".to_vec(),
            ])
            .collect(),
        words: &[
            "&set=",
            "&scene=",
            "#scene=",
            "&probe=",
            "&line=",
            "&lesson=",
            "&step=",
            "%",
            "%F0%9F",
            "?embed",
            "camera.eye=[0,0,4]",
            "light.9.kind=area",
            "https://",
        ],
        read: |bytes| link::read(&text(bytes)).is_ok(),
        png: false,
    };
    format.fuzz();
}

#[test]
fn lessons() {
    let built_in = LESSONS.iter().flat_map(|lesson| {
        Language::ALL.map(|language| lesson.source(language).as_bytes().to_vec())
    });
    let format = Format {
        name: "lessons",
        sound: built_in
            .chain([include_bytes!("data/lessons/kinds.md").to_vec()])
            .collect(),
        words: &[
            "+++\n",
            "```step\n",
            "```question\n",
            "```\n",
            "## ",
            "{{ ",
            " }}",
            " | 99 }}",
            "[[option]]\n",
            "[[item]]\n",
            "kind = \"curve\"\n",
            "with(\"",
            "((((",
            "$",
        ],
        read: |bytes| Lesson::read(&text(bytes), None).is_ok(),
        png: false,
    };
    format.fuzz();
}

/// A lesson with every kind of question whose pictures are small.
const SMALL: &str = include_str!("data/lessons/kinds.md");

/// A sheet with small pictures and all answers.
const SHEET: Worksheet = Worksheet {
    answers: true,
    seed: 7,
    samples: 1,
};

/// Whether no step shows much: work is bounded, but what may be done within the bounds is too much to do thousands of times.
fn is_small(lesson: &Lesson) -> bool {
    lesson.steps.iter().all(|step| {
        step.stage.load(None).is_ok_and(|staged| {
            let [width, height] = staged.scene.image.size;
            let few = staged.scene.object.segments.max(staged.scene.object.rings) <= 64;
            width * height <= 1 << 16 && few && staged.scene.lights.len() <= 3
        })
    })
}

#[test]
fn lessons_through_to_their_pages() {
    let format = Format {
        name: "lessons through to their pages",
        sound: vec![SMALL.as_bytes().to_vec(), lessons::EVERY_KIND.into()],
        words: &[
            "x = [0, 5e-324]\n",
            "y = [-1e300, 1e300]\n",
            "tolerance = 1e-300\n",
            "from = -1e308\n",
            "answer = \"x*1e308\"\n",
            "set = [\"image.size=[1,300]\"]\n",
            "light.0.position=[0,0,0]",
            "{{ probe.sum[0] | 9 }}",
            "picture.mean",
            "<script>",
        ],
        read: |bytes| {
            let Ok(lesson) = Lesson::read(&text(bytes), None) else {
                return false;
            };
            if !is_small(&lesson) {
                return true;
            }
            // Whether each is sound or not, it ends; and what is sound for `check` is so for all.
            let checked = check(&lesson).is_ok();
            let page = worksheet(&lesson, SHEET, &mut || {});
            let words = in_words(&lesson, SHEET.seed, true);
            if checked {
                assert!(page.is_ok() && words.is_ok(), "{page:?} {words:?}");
            }
            if let Ok(page) = page {
                assert!(page.ends_with("</html>\n") && !page.contains("<script"));
            }
            collected(&lesson);
            true
        },
        png: false,
    };
    format.fuzz();
}

/// Has the right answers to a lesson, as far as there are any, handed in, collected and written.
fn collected(lesson: &Lesson) {
    let mut record = Record::new(&lesson.name, SHEET.seed);
    for (index, step) in lesson.steps.iter().enumerate() {
        let solution = step.question.as_ref().and_then(|question| {
            let staged = step.stage.load(None).ok()?;
            let lab = Lab::new(&staged);
            question.solve(lab.place(&staged), SHEET.seed).ok()
        });
        if let Some(solution) = solution {
            record.put(answered(index, Answer::right(&solution)));
        }
    }
    let bytes = hand_in_bytes(&frame(), &Scene::default(), lesson, &record, "Ada");
    let handed = Handed {
        path: PathBuf::from("fuzz.png"),
        bytes: bytes.ok(),
    };
    let class = collect(&[handed], None, true, &mut || {});
    assert_eq!(class.groups.len() + class.unreadable.len(), 1);
    let page = class_sheet(&class);
    assert!(page.ends_with("</html>\n") && !page.contains("<script"));
}

fn answered(step: usize, answer: Answer) -> Answered {
    Answered {
        step,
        prediction: answer.clone(),
        answer,
        grade: Grade::default(),
        looked_up: 0,
        tries: 1,
        seconds: 3.5,
    }
}

#[test]
fn handed_in_answers() {
    let lesson = Lesson::read(SMALL, None).expect("a lesson");
    let mut record = Record::new("kinds", 7);
    for (step, answer) in [
        (1, Answer::Choice(1)),
        (2, Answer::Value(0.5)),
        (3, Answer::Point([0.1, -0.2])),
    ] {
        record.put(answered(step, answer));
    }
    let written = |name| {
        hand_in_bytes(&frame(), &Scene::default(), &lesson, &record, name).expect("a picture")
    };
    let mut none = Vec::new();
    write_png(&mut none, &frame(), None, &[]).expect("a picture");
    assert!(read_hand_in(Cursor::new(&none)).is_err());
    let format = Format {
        name: "handed-in answers",
        sound: vec![written("Ada"), written("王小明")],
        words: &[
            "shading-lab:answers",
            "\"answers\":[",
            "\"digest\":\"",
            "{\"step\":99}",
            "null",
            "1e999",
            "\\u0000",
        ],
        read: |bytes| {
            let read = read_hand_in(Cursor::new(bytes)).is_ok();
            let handed = Handed {
                path: PathBuf::from("fuzz.png"),
                bytes: Some(bytes.to_vec()),
            };
            let class = collect(&[handed], None, true, &mut || {});
            assert!(read || class.groups.is_empty());
            class_sheet(&class).ends_with("</html>\n") && read
        },
        png: true,
    };
    format.fuzz();
}
