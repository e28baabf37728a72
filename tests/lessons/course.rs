//! The lessons of the course: the engine evaluates everything in them, in both languages, and `docs/course.md` links only to
//! existing steps.

use rayon::prelude::*;
use shading_lab::expression::Expression;
use shading_lab::lesson::{
    Answer, Budget, BuiltIn, Curve, Kind, LESSONS, Lab, Lesson, Match, Question, Solution, Staged,
    Step, check,
};
use shading_lab::text::{Language, in_language};
use std::collections::BTreeSet;

fn lessons() -> Vec<(&'static BuiltIn, Language, Lesson)> {
    let in_language = |language: Language| {
        LESSONS
            .iter()
            .map(move |lesson| (lesson, language, lesson.lesson_in(language)))
    };
    Language::ALL.into_iter().flat_map(in_language).collect()
}

#[test]
fn every_scene_number_and_question_of_every_lesson_is_sound() {
    let wrong: Vec<String> = lessons()
        .into_par_iter()
        .filter_map(|(built_in, language, lesson)| {
            assert_eq!(lesson.name, built_in.name);
            let error = check(&lesson).err()?;
            Some(format!("{} {}:\n{error}", language.tag(), lesson.name))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Returns the drawing work of a step in a worksheet: four samples per pixel of each pane.
fn work_of_pictures(step: &Step, staged: &Staged) -> u64 {
    let lab = Lab::new(staged);
    let pixels = Expression::read("picture.pixels").expect("an expression");
    // A picture without the object counts as well.
    let _ = pixels.value(&lab.place(staged));
    4 * (1 + step.stage.panes.as_ref().map_or(0, Vec::len)) as u64 * lab.work()
}

#[test]
fn no_lesson_takes_a_tenth_of_the_work_that_it_may() {
    let work: Vec<(&str, Vec<u64>)> = LESSONS
        .par_iter()
        .map(|built_in| {
            let lesson = built_in.lesson_in(Language::English);
            let of_step = |step: &Step| {
                let staged = step.stage.load(None).expect("a scene");
                let lab = Lab::new(&staged);
                let place = lab.place(&staged);
                for text in [&step.text, &step.after] {
                    text.filled(&place).expect("a text");
                }
                if let Some(question) = &step.question {
                    question.why.filled(&place).expect("a text");
                    question.solve_all(place, 7).expect("a solution");
                }
                lab.work() + work_of_pictures(step, &staged)
            };
            (built_in.name, lesson.steps.iter().map(of_step).collect())
        })
        .collect();
    let mut over = Vec::new();
    for (name, steps) in &work {
        let (most, all) = (steps.iter().max().unwrap_or(&0), steps.iter().sum::<u64>());
        println!(
            "{name}: {} million, a step {}",
            all / 1_000_000,
            most / 1_000_000
        );
        if 10 * most >= Budget::STEP || 10 * all >= Budget::FILE {
            over.push((name, steps));
        }
    }
    assert!(over.is_empty(), "{over:?}");
    // Work of 0 would satisfy any bound.
    assert!(
        work.iter()
            .flat_map(|(_, steps)| steps)
            .all(|work| *work > 0)
    );
}

/// Returns answers that are wrong.
fn wrong_answers(question: &Question, solution: &Solution, staged: &Staged) -> Vec<Answer> {
    match (&question.kind, solution) {
        (Kind::Choice(kind), Solution::Choice(right)) => (0..kind.options.len())
            .filter(|option| option != right)
            .map(Answer::Choice)
            .collect(),
        (Kind::Value(kind), Solution::Value(right)) => [-2.1, 2.1]
            .map(|times| Answer::Value(right + times * kind.tolerance))
            .to_vec(),
        (Kind::Point(kind), Solution::Point(places)) => (0..400)
            .map(|index| [f64::from(index % 20), f64::from(index / 20)].map(|x| x / 20.0 - 0.475))
            .filter(|point| {
                let far = |place: &glam::DVec2| {
                    place.distance(glam::DVec2::from_array(*point)) > 2.1 * kind.tolerance
                };
                places.iter().all(far)
            })
            .map(Answer::Point)
            .collect(),
        (Kind::Curve(Curve { y, .. }), Solution::Curve(_)) => {
            let Answer::Curve(points) = Answer::right(solution) else {
                unreachable!("a curve");
            };
            let mean = points.iter().flatten().sum::<f64>() / points.len() as f64;
            let upside_down = points.iter().flatten();
            let upside_down = upside_down.map(|value| Some(y[0] + y[1] - value));
            vec![
                Answer::Curve(vec![Some(mean); points.len()]),
                Answer::Curve(upside_down.collect()),
                Answer::Curve(vec![None; points.len()]),
            ]
        }
        (Kind::Settings(_), Solution::Settings(right)) => [0.25, 4.0]
            .map(|times| Answer::Settings(right * times))
            .to_vec(),
        (Kind::Formula(kind), Solution::Formula(right)) => {
            let last = |formula: &str| {
                let lines = right.rsplit_once(';');
                let (lines, value) =
                    lines.map_or(("", right.as_str()), |(lines, value)| (lines, value));
                let separator = if lines.is_empty() { "" } else { "; " };
                format!(
                    "{lines}{separator}{}",
                    formula.replace("ANSWER", &format!("({value})"))
                )
            };
            let mut wrong = vec![last("1.001 * ANSWER"), last("-ANSWER"), last("ANSWER / 2")];
            if !kind.wants_vector() {
                wrong.extend([last("ANSWER + 0.00001"), last("ANSWER ^ 2"), "1".to_owned()]);
            }
            wrong.into_iter().map(Answer::Formula).collect()
        }
        (Kind::Order(_), Solution::Order(right)) => {
            let mut swapped = right.clone();
            swapped.swap(0, 1);
            let reversed = right.iter().rev().copied().collect();
            vec![Answer::Order(swapped), Answer::Order(reversed)]
        }
        (Kind::Match(Match { controls, .. }), Solution::Match(_)) => {
            let parameter = |key: &String| shading_lab::scene::parameter::Parameter::by_word(key);
            let own = |key: &String| {
                let value = parameter(key)?.value(&staged.scene, 0)?;
                let array = value
                    .as_array()
                    .and_then(|values| values.first()?.as_float());
                value.as_float().or(array)
            };
            controls
                .iter()
                .map(own)
                .collect::<Option<Vec<f64>>>()
                .into_iter()
                .map(Answer::Match)
                .collect()
        }
        _ => unreachable!("a solution of the question's kind"),
    }
}

#[test]
fn the_right_answer_scores_full_marks_and_a_wrong_one_does_not() {
    let (mut counts, mut questions) = (std::collections::BTreeMap::new(), 0);
    let lessons: Vec<Lesson> = LESSONS
        .iter()
        .map(|lesson| lesson.lesson_in(Language::English))
        .collect();
    let graded: Vec<(&'static str, usize)> = lessons
        .par_iter()
        .flat_map(|lesson| lesson.steps.par_iter().map(move |step| (lesson, step)))
        .filter_map(|(lesson, step)| {
            let question = step.question.as_ref()?;
            let staged = step.stage.load(None).expect("a scene");
            let lab = Lab::new(&staged);
            let place = lab.place(&staged);
            let key = question.solve_all(place, 7).expect("a solution");
            let what = format!("{}, {}", lesson.name, step.title);
            let right = Answer::right(&key.right);
            assert!(right.fits(&question.kind), "{what}");
            let grade = question.grade(&right, &key, place).expect("a grade");
            assert!(grade.right && grade.score >= 0.999, "{what}: {grade:?}");
            let wrong = wrong_answers(question, &key.right, &staged);
            for answer in &wrong {
                let grade = question.grade(answer, &key, place).unwrap_or_default();
                assert!(
                    !grade.right && grade.score < 1.0,
                    "{what}: {answer:?} counts as right: {key:?}"
                );
            }
            assert!(!wrong.is_empty(), "{what}: every answer is right");
            Some((question.kind.name(), wrong.len()))
        })
        .collect();
    for (kind, wrong) in graded {
        *counts.entry(kind).or_insert(0) += wrong;
        questions += 1;
    }
    assert!(
        questions >= 2 * LESSONS.len() && counts.len() == 8,
        "{questions}, {counts:?}"
    );
}

/// Checks that the question asks for what counts as right: the position on the scan line, not any of the same intensity.
#[test]
fn half_of_the_change_along_the_scan_line_is_in_its_middle() {
    let lesson = shading_lab::lesson::find("scan-line").expect("a lesson");
    let lesson = lesson.lesson_in(Language::English);
    let asked = |step: &&Step| {
        let question = step.question.as_ref();
        question.is_some_and(|question| matches!(question.kind, Kind::Point(_)))
    };
    let step = lesson.steps.iter().find(asked).expect("a click");
    let question = step.question.as_ref().expect("a question");
    let staged = step.stage.load(None).expect("a scene");
    let lab = Lab::new(&staged);
    let place = lab.place(&staged);
    let key = question.solve_all(place, 1).expect("a solution");
    let Solution::Point(places) = &key.right else {
        panic!("places");
    };
    assert!(places[0].length() < 0.01, "{places:?}");
    for (x, y, right) in [
        (0.0, 0.0, true),
        (0.02, -0.02, true),
        (-0.25, -0.08, false),
        (0.0, 0.1, false),
        (0.1, 0.0, false),
    ] {
        let grade = question.grade(&Answer::Point([x, y]), &key, place);
        assert_eq!(grade.map(|grade| grade.right), Some(right), "({x}, {y})");
    }
}

/// Formats a step without its words and its position in the file.
fn without_words(step: &Step) -> String {
    let mut stage = step.stage.clone();
    stage.line_number = 0;
    let question = step.question.as_ref().map(|question| {
        let mut question = question.clone();
        question.line = 0;
        (question.ask, question.why) = Default::default();
        clear_words(&mut question.kind);
        for wrong in &mut question.wrong {
            wrong.line = 0;
            wrong.says = Default::default();
            clear_words(&mut wrong.kind);
        }
        question
    });
    format!("{stage:?} {question:?}")
}

/// Clears the words of a kind of question.
fn clear_words(kind: &mut Kind) {
    match kind {
        Kind::Choice(kind) => {
            for option in &mut kind.options {
                (option.text, option.says) = Default::default();
            }
        }
        Kind::Order(kind) => {
            kind.items
                .iter_mut()
                .for_each(|item| item.text = Default::default());
        }
        Kind::Curve(kind) => (kind.x_name, kind.y_name) = Default::default(),
        Kind::Value(kind) => kind.unit.clear(),
        _ => {}
    }
}

#[test]
fn both_languages_have_the_same_steps_and_questions() {
    for lesson in &LESSONS {
        let [english, chinese] = Language::ALL.map(|language| lesson.lesson_in(language));
        assert_eq!(english.steps.len(), chinese.steps.len(), "{}", lesson.name);
        assert_eq!(english.topic, chinese.topic, "{}", lesson.name);
        assert_eq!(english.minutes, chinese.minutes, "{}", lesson.name);
        assert_ne!(english.title, chinese.title, "{}", lesson.name);
        for (a, b) in english.steps.iter().zip(&chinese.steps) {
            assert_eq!(
                without_words(a),
                without_words(b),
                "{}: {}",
                lesson.name,
                a.title
            );
            assert_ne!(a.text, b.text, "{}: {}", lesson.name, a.title);
        }
    }
}

#[test]
fn every_lesson_asks_before_it_tells() {
    let lessons = LESSONS.iter();
    let lessons = lessons.map(|lesson| lesson.lesson_in(Language::English));
    for lesson in lessons.filter(|lesson| !lesson.test) {
        let questions: Vec<&Question> = lesson
            .steps
            .iter()
            .filter_map(|step| step.question.as_ref())
            .collect();
        let by_hand = |question: &&Question| {
            matches!(
                question.kind,
                Kind::Point(_) | Kind::Curve(_) | Kind::Formula(_)
            )
        };
        assert!(
            questions.len() >= 2 && questions.iter().any(by_hand),
            "{}: {} questions",
            lesson.name,
            questions.len()
        );
        assert!((5..=15).contains(&lesson.minutes), "{}", lesson.name);
        // The last step, or the one before a match that continues it.
        let last = &lesson.steps[lesson.steps.len() - 2..];
        assert!(
            last.iter().any(|step| {
                let staged = step.stage.load(None).expect("a scene");
                let lab = Lab::new(&staged);
                [&step.text, &step.after].into_iter().any(|text| {
                    let text = text.filled(&lab.place(&staged)).expect("a text");
                    text.contains("Find out for yourself")
                })
            }),
            "{} ends without a task",
            lesson.name
        );
    }
}

#[test]
fn a_setting_has_the_unit_of_its_control() {
    let mut seen = 0;
    for (name, step, right) in [("orientation", 3, -45.0), ("light-sources", 4, 29.0)] {
        let lesson = shading_lab::lesson::find(name).expect("a lesson");
        for language in Language::ALL {
            let lesson = lesson.lesson_in(language);
            let question = lesson.steps[step].question.as_ref().expect("a question");
            in_language(language, || {
                let (words, short) = (
                    question.kind.words(&Answer::Settings(right), &[]),
                    question.kind.short_solution(&Solution::Settings(right)),
                );
                assert!(
                    words.ends_with('°') && short.ends_with('°'),
                    "{words}, {short}"
                );
            });
            seen += 1;
        }
    }
    assert_eq!(seen, 4);
}

/// A word, or a picture, that a step has to explain before others may use it.
struct Explained {
    /// What it looks like in a lesson, by language.
    used: [&'static [&'static str]; 2],
    /// What its first step says, by language.
    explained: [&'static str; 2],
}

const EXPLAINED: [Explained; 5] = [
    // The captions of panes have it.
    Explained {
        used: [&["panes", "RMS"], &["panes", "均方根誤差"]],
        explained: ["root mean square", "均方根"],
    },
    Explained {
        used: [&["Gouraud"]; 2],
        explained: ["interpolates the intensities", "內插亮度"],
    },
    Explained {
        used: [&["Phong shading"], &["Phong 著色"]],
        explained: ["at every pixel", "每個像素都計算"],
    },
    Explained {
        used: [&["·H)", " H ", "H 與", "是 H"]; 2],
        explained: ["H = (L + V)/|L + V|"; 2],
    },
    Explained {
        used: [&["Cook"]; 2],
        explained: ["many small mirrors", "許多小鏡子"],
    },
];

/// Returns the words that a student sees of a step, with the names of panes, and `panes` where there are any.
fn words_of(step: &Step, built_in: &BuiltIn, language: Language) -> String {
    let source = built_in.source(language);
    let steps = source.split("\n## ").skip(1);
    let own = steps.into_iter().find(|own| own.starts_with(&step.title));
    let own = own.unwrap_or_else(|| panic!("{}: {}", built_in.name, step.title));
    let staged = step.stage.load(None).expect("a scene");
    let panes = staged.scene.shown_panes().into_iter();
    let panes = panes.map(|pane| in_language(language, || staged.scene.pane_name(pane)));
    let panes: Vec<String> = panes.collect();
    let marked = if panes.len() > 1 {
        format!("panes {}", panes.join("\n"))
    } else {
        String::new()
    };
    // Without settings, which nobody sees.
    let unseen = [
        "set ", "panes ", "scene ", "holds ", "by ", "answer ", "profile ", "mode ", "formula ",
        "names ",
    ];
    let seen = own
        .lines()
        .filter(|line| !unseen.iter().any(|key| line.starts_with(key)));
    let seen: Vec<&str> = seen.collect();
    format!("{}\n{marked}", seen.join("\n"))
}

#[test]
fn no_word_is_used_before_the_step_that_explains_it() {
    for (index, language) in Language::ALL.into_iter().enumerate() {
        let lessons = LESSONS
            .iter()
            .map(|built_in| (built_in, built_in.lesson_in(language)));
        let steps: Vec<(String, String)> = lessons
            .filter(|(_, lesson)| !lesson.test)
            .flat_map(|(built_in, lesson)| {
                let steps = lesson.steps.into_iter().enumerate();
                let words = steps.map(|(number, step)| {
                    let place = format!("{}/{}", built_in.name, number + 1);
                    (place, words_of(&step, built_in, language))
                });
                words.collect::<Vec<_>>()
            })
            .collect();
        for Explained { used, explained } in &EXPLAINED {
            let uses = |words: &String| used[index].iter().any(|use_| words.contains(use_));
            let first = steps.iter().find(|(_, words)| uses(words));
            let (place, words) = first.unwrap_or_else(|| panic!("{used:?} is not used"));
            assert!(
                words.contains(explained[index]),
                "{place} uses {:?} before it is explained:\n{words}",
                used[index]
            );
        }
    }
}

#[test]
fn the_course_covers_every_slide_and_section_by_steps_that_there_are() {
    let table = include_str!("../../docs/course.md");
    let rows = table.lines().filter(|line| line.starts_with("| 00"));
    let mut seen = BTreeSet::new();
    let mut met = BTreeSet::new();
    for row in rows {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [source, title, lesson, step] = cells[..] else {
            panic!("{row}: four cells expected");
        };
        // [one](…), [another](…) | 1–3, 5; 2
        let names: Vec<&str> = lesson
            .split('[')
            .skip(1)
            .filter_map(|link| Some(link.split_once(']')?.0))
            .collect();
        let steps: Vec<&str> = step.split(';').collect();
        assert!(!names.is_empty() && names.len() == steps.len(), "{row}");
        for (name, steps) in names.into_iter().zip(steps) {
            let lesson = LESSONS
                .iter()
                .find(|lesson| lesson.name == name)
                .unwrap_or_else(|| panic!("{row}: no such lesson"));
            let count = lesson.lesson_in(Language::English).steps.len();
            for step in steps.split([',', '–']) {
                let step: usize = step
                    .trim()
                    .parse()
                    .unwrap_or_else(|_| panic!("{row}: no step"));
                assert!((1..=count).contains(&step), "{row}: {count} steps");
            }
            met.insert(name.to_owned());
        }
        assert!(!title.is_empty(), "{row}");
        seen.insert(source.to_owned());
    }
    for slide in 1..=47 {
        let named = format!("002, slide {slide}");
        assert!(seen.contains(&named), "{named} is missing");
    }
    for page in 1..=12 {
        let named = format!("000, page {page}");
        assert!(
            seen.iter().any(|source| *source == named),
            "{named} is missing"
        );
    }
    assert!(
        seen.iter()
            .filter(|source| source.starts_with("003"))
            .count()
            >= 1
    );
    let lessons = LESSONS.iter();
    let lessons = lessons.map(|lesson| lesson.lesson_in(Language::English));
    let all: BTreeSet<String> = lessons
        .filter(|lesson| !lesson.test)
        .map(|lesson| lesson.name)
        .collect();
    assert_eq!(met, all, "every lesson is in the table");
    assert_eq!(all.len(), 34);
}
