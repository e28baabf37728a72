//! Worksheets: every lesson becomes a page that is well formed and self-contained, and no text of a lecturer becomes markup.

use glam::DVec2;
use shading_lab::document::{load_with, picture_bytes};
use shading_lab::lesson::{
    LESSONS, Lab, Lesson, Solution, Step, Worksheet, check, find, in_words, worksheet,
};
use shading_lab::render::Renderer;
use shading_lab::scene::Scene;
use shading_lab::text::{Language, in_language};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const WITH_ANSWERS: Worksheet = Worksheet {
    answers: true,
    seed: 1,
    samples: 1,
};
const WITHOUT_PICTURES: Worksheet = Worksheet {
    samples: 0,
    ..WITHOUT
};
const WITHOUT: Worksheet = Worksheet {
    answers: false,
    ..WITH_ANSWERS
};

fn written(lesson: &Lesson, sheet: Worksheet) -> String {
    worksheet(lesson, sheet, &mut || ()).unwrap_or_else(|error| panic!("{}: {error}", lesson.name))
}

/// Checks that every element is closed where it was opened, every `&` begins an entity, and nothing is loaded.
fn check_page(page: &str, name: &str) {
    let (_, body) = page.split_once("<html").expect("a page");
    let mut open: Vec<&str> = Vec::new();
    let mut rest = &page[page.len() - body.len() - "<html".len()..];
    while let Some((text, after)) = rest.split_once('<') {
        for piece in text.split('&').skip(1) {
            let entity = piece.split_once(';').map_or("", |(entity, _)| entity);
            let sound = !entity.is_empty()
                && entity
                    .chars()
                    .all(|c| c.is_ascii_alphanumeric() || c == '#');
            assert!(sound, "{name}: &{}", &piece[..piece.len().min(20)]);
        }
        assert!(
            open.contains(&"style") || !text.contains('>'),
            "{name}: > in {text}"
        );
        let (tag, behind) = after
            .split_once('>')
            .unwrap_or_else(|| panic!("{name}: open tag {after:.40}"));
        assert!(
            !tag.contains('<') && tag.matches('"').count() % 2 == 0,
            "{name}: <{tag:.80}>"
        );
        let word = tag
            .trim_start_matches('/')
            .split([' ', '/', '\n'])
            .next()
            .unwrap_or("");
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(word), "{name}: </{word}>");
        } else if !tag.ends_with('/') {
            open.push(word);
        }
        assert!(
            !["script", "iframe", "object", "link"].contains(&word),
            "{name}: {word}"
        );
        assert!(
            !tag.contains(" src=\"") || tag.contains(" src=\"data:image/png;base64,"),
            "{name}"
        );
        rest = behind;
    }
    assert!(open.is_empty(), "{name}: {open:?}");
    assert!(!page.contains("{{") && !page.contains("}}"), "{name}");
    // Nor a message key that the catalogue lacks.
    assert!(
        !page.contains("class-topic") && !page.contains(">class-"),
        "{name}"
    );
}

/// Checks that the line under each step, given to a command, yields the step's scene bit by bit, its lights and panes included.
fn check_scene_lines(lesson: &Lesson, words: &str, name: &str) {
    let lines: Vec<&str> = words
        .lines()
        .filter_map(|line| line.strip_prefix("    "))
        .collect();
    assert_eq!(lines.len(), lesson.steps.len(), "{name}");
    for (line, step) in lines.into_iter().zip(&lesson.steps) {
        let words = shell_words(line);
        let (scene, options) = words.split_first().expect("a scene");
        let settings: Vec<&String> = options
            .chunks(2)
            .map(|pair| match pair {
                [option, setting] if option == "--set" => setting,
                _ => panic!("{name}: {line}"),
            })
            .collect();
        let shown = load_with(Path::new(scene), &settings, &mut |_, _| {}).expect(line);
        let staged = step.stage.load(lesson.folder.as_deref()).expect("a scene");
        let differing: Vec<_> = shown.scene.differences(&staged.scene).collect();
        assert!(
            differing.is_empty() && shown.scene == staged.scene,
            "{name}, {}: {differing:?}",
            step.title
        );
    }
}

/// Splits a command line into words as a POSIX shell does.
fn shell_words(line: &str) -> Vec<String> {
    let (mut words, mut word, mut quoted) = (Vec::new(), String::new(), false);
    let mut characters = line.chars();
    while let Some(c) = characters.next() {
        match c {
            '\'' => quoted = !quoted,
            _ if quoted => word.push(c),
            ' ' => words.push(std::mem::take(&mut word)),
            '\\' => word.extend(characters.next()),
            _ => {
                assert!(!"[]{}()<>*?;&|$`\"#~!".contains(c), "not quoted: {line}");
                word.push(c);
            }
        }
    }
    assert!(!quoted, "{line}");
    words.push(word);
    words
}

#[test]
fn every_lesson_has_a_worksheet_in_both_languages() {
    for lesson in &LESSONS {
        for language in Language::ALL {
            in_language(language, || {
                let lesson = lesson.lesson();
                let name = format!("{} {}", lesson.name, language.tag());
                // Pictures and answers take long, and are the same in both languages.
                let sheet = if language == Language::English {
                    WITH_ANSWERS
                } else {
                    WITHOUT_PICTURES
                };
                let page = written(&lesson, sheet);
                check_page(&page, &name);
                let questions = lesson
                    .steps
                    .iter()
                    .filter(|step| step.question.is_some())
                    .count();
                assert_eq!(
                    page.matches("<div class=\"question\">").count(),
                    questions,
                    "{name}"
                );
                let answers = if sheet.answers { questions } else { 0 };
                assert_eq!(
                    page.matches("<div class=\"answer\">").count(),
                    answers,
                    "{name}"
                );
                let words = in_words(&lesson, 1, false).expect("words");
                check_scene_lines(&lesson, &words, &name);
                assert!(
                    !words.contains("{{") && words.starts_with(&lesson.title),
                    "{name}"
                );
            });
        }
    }
}

/// A lesson with every kind of question, and texts that try to be markup.
const HOSTILE: &str = r#"+++
lesson = 1
name = "hostile"
title = "A & B <script>alert(1)</script>"
topic = "<b>x</b>"
about = "\"><img src=x onerror=alert(1)>"
+++

## Step <img src=x> one

Text <script>alert(1)</script> and <b onclick="x">bold</b>, ![picture](https://x.org/x.png), [bad](javascript:alert(1)), [good](https://x.org/?a=1&b=2).

<script>alert(2)</script>

<div>

| a | b |
|---|---|
| 1 | 2 & 3 |

</div>

Formula `$K_d·(N·L)^n$` and $a<b$, number {{ scene.material.n | 1 }}, `code <x>`.

```step
scene = "sphere"
set = ["camera.eye=[0,0,4]", "image.size=[96,96]", "material.n=20"]
probe = [0.0, 0.0]
line = [-0.3, 0.0, 0.3, 0.0]
overlays = ["vectors", "profile", "normals", "vertices"]
```

```question
kind = "choice"
ask = "Is 1 < 2 <i>here</i>?"
why = "Because *one* < two </div>"
[[option]]
text = "Yes <u>"
right = true
[[option]]
text = "No & no"
right = false
```

## Value

```question
kind = "value"
ask = "cos 60°"
answer = "cos(60)"
tolerance = 0.01
from = 0
to = 1
unit = "<em>m</em>"
why = "A secret."
```

## Point

```question
kind = "point"
ask = "Brightest"
find = "least"
of = "probe.position[0]^2 + probe.position[1]^2"
```

## Curve

```question
kind = "curve"
ask = "cos"
x = [0, 90]
y = [0, 1]
x_name = "<b>$φ$</b>"
y_name = "\"share\""
answer = "cos(x)"
```

## Profile

```question
kind = "curve"
ask = "Profile"
x_name = "t"
y_name = "I"
y = [0, 2]
tolerance = 0.02
profile = "phong"
```

## Settings

```question
kind = "settings"
ask = "Make n 30"
control = "material.n"
reach = "scene.material.n"
equals = "30"
tolerance = 1
```

## Order

```question
kind = "order"
ask = "By n"
by = "scene.material.n"
[[item]]
text = "C <"
set = ["material.n=50"]
[[item]]
text = "A"
set = ["material.n=5"]
[[item]]
text = "B"
set = ["material.n=15"]
```

## Match

```question
kind = "match"
ask = "Find it"
controls = ["material.kd", "material.ks"]
```
"#;

#[test]
fn a_lecturers_text_stays_text() {
    let lesson = Lesson::read(HOSTILE, None).expect("a lesson");
    check(&lesson).expect("sound");
    let page = written(&lesson, WITH_ANSWERS);
    check_page(&page, "hostile");
    for raw in [
        "<script",
        "<img src=x",
        "javascript:",
        "<b onclick",
        "<u>",
        "<em>m",
        "x.org/x.png",
        "<b>",
    ] {
        assert!(!page.contains(raw), "{raw}");
    }
    for there in [
        "<title>A &amp; B &lt;script&gt;",
        "<a href=\"https://x.org/?a=1&amp;b=2\">good</a>",
        "<i>K</i><sub><i>d</i></sub>",
        "number 20.0",
        "<td>2 &amp; 3</td>",
        "A. Yes &lt;u&gt;",
        "0.50 &lt;em&gt;m",
        "<p>B &lt; C &lt; A</p>",
        "specular exponent (n) = 30.00",
        "A secret.",
    ] {
        assert!(page.contains(there), "{there}");
    }
    // Seven pictures of steps and their answers, three of items, two to match.
    assert_eq!(page.matches("<img ").count(), 6 + 1 + 3 + 2);
    let page = written(&lesson, WITHOUT);
    check_page(&page, "hostile");
    assert!(!page.contains("A secret.") && !page.contains("<div class=\"answer\">"));
    // A browser would neither run nor load anything that got through.
    let policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'";
    assert!(page.contains(policy));
    let words = in_words(&lesson, 1, true).expect("words");
    assert!(
        words.contains("bad, [good](https://x.org/?a=1&b=2)") && !words.contains("javascript:")
    );
    // Another seed, another target.
    let other = Worksheet { seed: 2, ..WITHOUT };
    assert_ne!(written(&lesson, other), page);
    assert_eq!(written(&lesson, WITHOUT), page);
}

/// Returns the standard Base64 of bytes (RFC 4648).
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let word = chunk
            .iter()
            .fold(0u32, |word, byte| word << 8 | u32::from(*byte));
        let word = word << (8 * (3 - chunk.len()));
        for place in 0..4 {
            let digit = DIGITS[(word >> (18 - 6 * place)) as usize & 63];
            text.push(if place <= chunk.len() {
                char::from(digit)
            } else {
                '='
            });
        }
    }
    text
}

/// Returns a scene in the size in which lessons draw it.
fn in_lab(mut scene: Scene) -> Scene {
    let shorter = scene.image.size.into_iter().fold(u32::MAX, u32::min);
    if shorter > Lab::SIDE {
        let scaled = |side| side * Lab::SIDE / shorter;
        scene.image.size = scene.image.size.map(scaled);
    }
    scene
}

/// Returns a scene's picture as it is inside a page.
fn printed(scene: &Scene) -> String {
    let frame = Renderer::default().render(scene).clone();
    base64(&picture_bytes(&frame, None).expect("a picture"))
}

/// Returns the parts of a page that have this class, up to the next part that has.
fn parts<'p>(page: &'p str, class: &str) -> Vec<&'p str> {
    let start = format!("<div class=\"{class}\">");
    page.split(&start).skip(1).collect()
}

#[test]
fn no_picture_shows_the_answer_and_the_key_marks_the_picture_of_the_answer() {
    for (name, index) in [
        ("unrepresentative-normals", 0),
        ("shared-vertices", 0),
        ("perspective-distortion", 1),
    ] {
        let lesson = find(name).expect("a lesson").lesson();
        let asked = lesson.steps[..index].iter();
        let before = asked.filter(|step| step.question.is_some()).count();
        let step = &lesson.steps[index];
        let mut staged = step.stage.load(None).expect("a scene");
        staged.scene = in_lab(staged.scene);
        assert!(
            !staged.scene.compare.panes.is_empty(),
            "{name}: panes that stay away"
        );
        let page = written(&lesson, WITH_ANSWERS);
        let (sheet, key) = page
            .split_once("<section class=\"answers\">")
            .expect("a key");
        // The step shows a single picture, and not the one that is asked for.
        let question = step.question.as_ref().expect("a question");
        let answer = staged
            .scene
            .with_overrides(&question.set)
            .expect("settings");
        if step.stage.overlays.is_empty() {
            assert!(sheet.contains(&printed(&staged.scene)), "{name}");
        }
        assert!(
            question.set.is_empty() || !sheet.contains(&printed(&answer)),
            "{name}"
        );
        // The key does, with its marks where the answer lies in it.
        let key = parts(key, "answer")[before];
        assert!(key.contains(&printed(&answer)), "{name}");
        let [width, height] = answer.image.size;
        assert!(
            key.contains(&format!("viewBox=\"0 0 {width} {height}\"")),
            "{name}"
        );
        let lab = Lab::new(&staged);
        let Ok(Solution::Point(places)) = question.solve(lab.place(&staged), 1) else {
            panic!("{name}: places");
        };
        let middle = DVec2::new(width.into(), height.into()) / 2.0;
        let at = middle + places[0] * f64::from(width.min(height));
        let number = |mark: &str, of: &str| -> f64 {
            let (_, rest) = mark.split_once(&format!(" {of}=\"")).expect("a number");
            rest.split_once('"')
                .expect("an end")
                .0
                .parse()
                .expect("a number")
        };
        let mut marks = key.split("<circle").skip(1);
        let near =
            |mark: &str| DVec2::new(number(mark, "cx"), number(mark, "cy")).distance(at) < 0.1;
        assert!(marks.any(near), "{name}: {at}");
    }
}

#[test]
fn pictures_of_an_order_stand_with_the_answers() {
    let lesson = find("diffuse").expect("a lesson").lesson();
    let orders = |step: &Step| {
        let question = step.question.as_ref();
        question.is_some_and(|question| question.kind.name() == "order")
    };
    let questions: Vec<&Step> = lesson
        .steps
        .iter()
        .filter(|step| step.question.is_some())
        .collect();
    let index = questions
        .iter()
        .position(|step| orders(step))
        .expect("an order");
    let page = written(&lesson, WITH_ANSWERS);
    let (sheet, key) = page
        .split_once("<section class=\"answers\">")
        .expect("a key");
    let asked = parts(sheet, "question")[index].split("</section>").next();
    assert!(!asked.expect("a question").contains("<img"));
    let answer = parts(key, "answer")[index];
    assert!(answer.matches("<img").count() >= 3, "{answer:.200}");
}

#[test]
fn edges_lines_and_the_probe_are_drawn_on_paper() {
    for (name, with, without) in [
        ("shadows", "[\"vectors\", \"edges\"]", "[\"vectors\"]"),
        ("tessellation", "[\"edges\"]", "[]"),
        (
            "exponent",
            "[\"vectors\", \"side-view\", \"lobe\"]",
            "[\"vectors\", \"side-view\"]",
        ),
        (
            "vertex-normals",
            "[\"vertices\", \"vertex\"]",
            "[\"vertices\"]",
        ),
        (
            "reflection-vector",
            "[\"vectors\", \"side-view\"]",
            "[\"vectors\"]",
        ),
    ] {
        let source = find(name).expect("a lesson").source(Language::English);
        assert!(source.contains(with), "{name}");
        let page = |source: &str| {
            let lesson = Lesson::read(source, None).expect("a lesson");
            written(&lesson, WITHOUT)
        };
        assert_ne!(page(source), page(&source.replace(with, without)), "{name}");
    }
    // The line that a curve is drawn along, too.
    let source = find("shadows").expect("a lesson").source(Language::English);
    let other = source.replace("line = [-0.27, 0.07,", "line = [-0.27, 0.06,");
    assert_ne!(source, other);
    let [source, other] = [source, &other].map(|source| Lesson::read(source, None));
    let [one, other] = [source, other].map(|lesson| written(&lesson.expect("a lesson"), WITHOUT));
    assert_ne!(one, other);
    // Numbers of the text are taken at the probe: a ring says where.
    let marked = "+++\nlesson = 1\nname = \"probe\"\ntitle = \"Probe\"\n+++\n\n## One\n\nN·L is {{ probe.lights[0].n_dot_l | 2 }}.\n\n```step\nscene = \"sphere\"\nprobe = [0.0, 0.0]\n```\n";
    let plain = marked.replace("probe.lights[0].n_dot_l", "1");
    let scene = shading_lab::document::load_scene(Path::new("sphere"))
        .expect("a scene")
        .scene;
    let scene = in_lab(scene);
    let page = |source: &str| written(&Lesson::read(source, None).expect("a lesson"), WITHOUT);
    assert!(page(&plain).contains(&printed(&scene)));
    assert!(!page(marked).contains(&printed(&scene)));
    // The first of several panes has what a single picture has, and the marks of the scene's own defect.
    let panes = |more: &str| {
        let step = format!("```step\nscene = \"perspective-distortion\"\n{more}```\n");
        page(&format!(
            "+++\nlesson = 1\nname = \"panes\"\ntitle = \"Panes\"\n+++\n\n## One\n\nTwo.\n\n{step}"
        ))
    };
    let none = panes("");
    for more in ["overlays = [\"edges\"]\n", "view = \"defects\"\n"] {
        assert_ne!(panes(more), none, "{more}");
    }
    assert_eq!(panes("view = \"curves\"\n"), none);
    // Where the answer alone is taken at it, too, although it is not printed.
    let asked = format!(
        "{plain}\n```question\nkind = \"value\"\nask = \"N·L?\"\nanswer = \"probe.lights[0].n_dot_l\"\nfrom = 0\nto = 1\ntolerance = 0.1\n```\n"
    );
    assert!(!page(&asked).contains(&printed(&scene)));
    let elsewhere = asked.replace("answer = \"probe.lights[0].n_dot_l\"", "answer = \"0.5\"");
    assert!(page(&elsewhere).contains(&printed(&scene)));
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_shading-lab"));
    let command = command.current_dir(folder).env("LANG", "C");
    command.args(arguments).output().expect("a run")
}

fn folder() -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("worksheet");
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder");
    fs::write(
        path.join("own.md"),
        HOSTILE.split_once("## Value").expect("steps").0,
    )
    .expect("a file");
    path
}

#[test]
fn the_command_lists_prints_and_writes() {
    let folder = folder();
    let list = run(&folder, &["lesson"]);
    assert!(list.status.success());
    assert_eq!(
        String::from_utf8_lossy(&list.stdout).lines().count(),
        LESSONS.len()
    );
    let list = run(&folder, &["lesson", "--json"]);
    let list: serde_json::Value = serde_json::from_slice(&list.stdout).expect("JSON");
    assert_eq!(
        list["lessons"].as_array().map(Vec::len),
        Some(LESSONS.len())
    );

    let words = run(&folder, &["lesson", "own.md"]);
    let words = String::from_utf8_lossy(&words.stdout).into_owned();
    assert!(
        words.contains("number 20.0") && words.contains("Because *one*"),
        "{words}"
    );
    // A lecturer's scene file in another folder, with a path full of characters that a shell treats specially.
    let [text, folder_of_scene] = [HOSTILE, "the lecturer's $HOME"];
    let inner = folder.join(folder_of_scene);
    fs::create_dir_all(&inner).expect("a folder");
    fs::write(inner.join("a b.toml"), "version = 1\n").expect("a file");
    let (before, after) = text.split_once("scene = \"sphere\"").expect("a scene");
    let panes = r#"panes = ["compare.name=It's \"$1\";material.n=5", "shading.mode=flat"]"#;
    let text = format!("{before}scene = \"a b.toml\"\nlights = 3\n{panes}{after}");
    fs::write(inner.join("own.md"), &text).expect("a file");
    let path = inner.join("own.md");
    let own = Lesson::open(&path).expect("a lesson");
    let words = run(&folder, &["lesson", path.to_str().expect("Unicode")]);
    assert!(words.status.success());
    check_scene_lines(&own, &String::from_utf8_lossy(&words.stdout), "own");

    let words = run(&folder, &["lesson", "own.md", "--without-answers"]);
    assert!(!String::from_utf8_lossy(&words.stdout).contains("Because"));

    let written = run(
        &folder,
        &[
            "lesson",
            "own.md",
            "-o",
            "own.html",
            "--language",
            "zh-Hant",
        ],
    );
    assert!(
        written.status.success(),
        "{}",
        String::from_utf8_lossy(&written.stderr)
    );
    let page = fs::read_to_string(folder.join("own.html")).expect("a page");
    check_page(&page, "own.html");
    assert!(page.contains("lang=\"zh-Hant\"") && page.contains("問題 1."));

    let is_lesson = english!("cli-scene-is-lesson", name = "own.md");
    for (arguments, words) in [
        (&["lesson", "no-such"][..], "no-such"),
        (&["lesson", "no-such.md"], "no-such.md"),
        (&["lesson", "own.md", "-o", "own.pdf"], ".html"),
        (&["lesson", "-o", "own.html"], "missing"),
        (&["render", "own.md", "-o", "x.png"], &is_lesson),
        (
            &["probe", "own.md", "--pixel", "1,1"],
            "shading-lab lesson own.md",
        ),
    ] {
        let output = run(&folder, arguments);
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {error}");
        assert!(error.contains(words), "{arguments:?}: {error}");
    }
}
