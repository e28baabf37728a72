//! Input from other people: scenes, models, pictures, links, lessons and handed-in answers, mutated at random with knowledge of
//! their structure. Each is read or refused, in bounded time and memory, and whatever is read survives being written.

use crate::common::fuzz::{Format, is_small, lessons_of_every_kind, text};
use shading_lab::geometry::{read_model, read_obj};
use shading_lab::lesson::{
    Answer, Answered, Grade, Handed, LESSONS, Lab, Lesson, Record, Worksheet, check, class_sheet,
    collect, hand_in_bytes, in_words, read_hand_in, worksheet,
};
use shading_lab::link;
use shading_lab::picture::{read_scene_text, write_png};
use shading_lab::render::{Frame, Renderer};
use shading_lab::scene::{ObjectKind, Scene, presets};
use shading_lab::text::Language;
use std::io::Cursor;
use std::path::PathBuf;

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

/// Draws a small picture of the scene, with large numbers reduced.
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
    let tower = include_bytes!("../data/obj/tower.obj").to_vec();
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
fn material_libraries() {
    const MODEL: &[u8] =
        b"mtllib a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b c\nf 3 2 1\n";
    let plain =
        b"newmtl a\nKa 0.1 0.1 0.1\nKd 0.5 0 1\nKs 0.5\nNs 20\nillum 2\nnewmtl b c\nd 0.5\n"
            .to_vec();
    let maps =
        b"# x\r\nnewmtl a\r\nnewmtl b c\r\n\tmap_Kd -s 1 1 1 -clamp on a b.png\r\n\tTr 0.5\r\n"
            .to_vec();
    let format = Format {
        name: "material libraries",
        sound: vec![plain, maps],
        words: &[
            "newmtl a\n",
            "newmtl ",
            "Kd ",
            "Ks spectral a.rfl 1\n",
            "Ka xyz 1 1 1\n",
            "d -halo 0.5\n",
            "Tr 1\n",
            "map_Kd -type sphere ",
            "-mm 0 1 ",
            "# Meshlab\n",
            "1e999",
            "-1",
            "\\\n",
        ],
        read: |bytes| {
            let read = read_model(MODEL, &mut |_| {}, &mut |_| Ok(bytes.to_vec()));
            read.is_ok_and(|mesh| mesh.remarks.is_empty())
        },
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
            .chain([include_bytes!("../data/lessons/kinds.md").to_vec()])
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
            "[[wrong]]\n",
            "says = \"No.\"\n",
            "at = [0.1, 9e99]\n",
            "profile = \"flat\"\n",
            "by = \"x\"\n",
            "most = true\n",
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
const SMALL: &str = include_str!("../data/lessons/kinds.md");

/// A sheet with small pictures and all answers.
const SHEET: Worksheet = Worksheet {
    answers: true,
    seed: 7,
    samples: 1,
};

#[test]
fn lessons_through_to_their_pages() {
    let format = lessons_of_every_kind("lessons through to their pages", |bytes| {
        let Ok(lesson) = Lesson::read(&text(bytes), None) else {
            return false;
        };
        if !is_small(&lesson) {
            return true;
        }
        // Each call returns, whether the lesson is valid or not; a lesson valid for `check` is valid for the others.
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
    });
    format.fuzz();
}

/// Hands in the right answers to a lesson, as far as there are any, then collects and writes them.
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
    let (counted, not) = (
        class.groups.len(),
        class.unreadable.len() + class.set_aside.len(),
    );
    assert_eq!(counted + not, 1);
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
