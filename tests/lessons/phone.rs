//! The page of a class on phones: every step of every lesson fits, and tells nothing of its answer.

use shading_lab::class::page::{FIRST_VIEW, SCRIPT, STYLE, StepPage, shell, step_page};
use shading_lab::lesson::{LESSONS, Lesson, find};
use shading_lab::text::{Language, in_language};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

const SEED: u64 = 1;

fn pages(lesson: &Lesson) -> Vec<Result<StepPage, String>> {
    let steps = 0..lesson.steps.len();
    let page = |step| step_page(lesson, step, SEED).map_err(|error| error.to_string());
    steps.map(page).collect()
}

/// Does something with each lesson of the course, on two threads.
fn with_each(work: impl Fn(Lesson) + Sync) {
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(lesson) = LESSONS.get(next.fetch_add(1, Ordering::Relaxed)) {
                    work(lesson.lesson_in(Language::English));
                }
            });
        }
    });
}

/// Words that stand in a lesson in place of what explains its answers.
const SECRET: &str = "SECRET";

/// Returns the lesson with other right answers, other reasons and no wrong models: what is asked is the same.
fn with_other_answers(lesson: &Lesson) -> Lesson {
    let (mut out, mut rest) = (String::new(), &*lesson.source);
    while let Some((before, after)) = rest.split_once("```question\n") {
        let (block, behind) = after.split_once("\n```").expect("a block that ends");
        let explained = behind.find("\n## ").unwrap_or(behind.len());
        out += &format!(
            "{before}```question\n{}\n```\n\n{SECRET}\n",
            other_answer(block)
        );
        rest = &behind[explained..];
    }
    out += rest;
    Lesson::read(&out, None).unwrap_or_else(|error| panic!("{}: {error}\n{out}", lesson.name))
}

/// Returns the quotation mark of a key's value, and what is inside.
fn quoted(line: &str) -> (char, &str) {
    let (_, value) = line.split_once("= ").expect("a key with its value");
    let mark = value.chars().next().expect("a quotation mark");
    (mark, &value[1..value.len() - 1])
}

/// Returns a question's page without its picture: whether the probe is marked can depend on which expressions are evaluated, as far as
/// they are.
fn without_picture(html: &str) -> String {
    let (before, after) = html.split_once("<figure>").unwrap_or((html, ""));
    let (_, behind) = after.split_once("</figure>").unwrap_or(("", after));
    format!("{before}{behind}")
}

fn other_answer(block: &str) -> String {
    let (own, wrong) = block.split_at(block.find("[[wrong]]").unwrap_or(block.len()));
    let key = |line: &'_ str| line.split(' ').next().unwrap_or_default().to_owned();
    let value = |name: &str| {
        let line = own.lines().find(|line| key(line) == name)?;
        Some(line.split_once("= ")?.1.trim_matches('"').to_owned())
    };
    let ends = |low: Option<String>, high: Option<String>| Some((low?, high?));
    let of_curve = value("y").and_then(|y| {
        let (low, high) = y.trim_matches(['[', ']']).split_once(',')?;
        Some((low.to_owned(), high.to_owned()))
    });
    let range = ends(value("from"), value("to")).or(of_curve);
    let decides = |line: &&str| ["holds", "right"].contains(&&*key(line));
    let mut decisions: Vec<&str> = own.lines().filter(decides).collect();
    // Only where each option has a decision do they change places.
    let options = own.matches("[[option]]").count();
    if decisions.len() == options && options > 0 {
        decisions.rotate_left(1);
    }
    let mut decisions = decisions.into_iter();
    let line = |line: &str| match (&*key(line), &range) {
        ("why" | "says", _) => marked(line),
        ("answer", Some((low, high))) => {
            let old = quoted(line);
            format!(
                "answer = {0}0.5 * ({1}) + 0.25 * ({low} + {high}){0}",
                old.0, old.1
            )
        }
        ("by", _) => format!("by = {0}-({1}){0}", quoted(line).0, quoted(line).1),
        ("find", _) => {
            let pairs = [("brightest", "darkest"), ("greatest", "least")];
            let swap = |line: String, (a, b)| match line.contains(a) {
                true => line.replace(a, b),
                false => line.replace(b, a),
            };
            pairs.into_iter().fold(line.to_owned(), swap)
        }
        ("holds" | "right", _) => decisions.next().unwrap_or_default().to_owned(),
        _ => line.to_owned(),
    };
    let own = own.lines().map(line);
    // Numbers in what is said stay: they decide whether the probe is marked.
    let wrong = wrong.lines().map(|line| match &*key(line) {
        "says" => marked(line),
        _ => line.to_owned(),
    });
    own.chain(wrong).collect::<Vec<_>>().join("\n")
}

/// Returns a key with other words in its value.
fn marked(line: &str) -> String {
    let (mark, words) = quoted(line);
    let (name, _) = line.split_once(" = ").expect("a key with its value");
    format!("{name} = {mark}{SECRET} {words}{mark}")
}

#[test]
fn every_step_fits_into_80_kb_and_shows_the_same_whatever_its_answer_is() {
    let (same, told) = (AtomicUsize::new(0), AtomicUsize::new(0));
    with_each(|lesson| {
        let others = pages(&with_other_answers(&lesson));
        for ((index, page), other) in pages(&lesson).into_iter().enumerate().zip(others) {
            let name = format!("{}, step {}", lesson.name, index + 1);
            let page = page.unwrap_or_else(|error| panic!("{name}: {error}"));
            let pictures: usize = page.pictures.iter().map(Vec::len).sum();
            let whole = shell(&lesson, &page, true).len() + STYLE.len() + SCRIPT.len() + pictures;
            assert!(whole <= FIRST_VIEW, "{name}: {whole} bytes");
            let asks = lesson.steps[index].question.is_some();
            assert_eq!(page.explanation.is_empty(), !asks, "{name}");
            assert!(
                !page.html.contains("<script") && !page.html.contains(" style="),
                "{name}"
            );
            let words = page.html.to_lowercase() + &page.explanation.to_lowercase();
            assert!(!words.contains("click"), "{name}: fingers tap");
            // Some questions have no other answer of this kind.
            let Ok(other) = other else { continue };
            if page.html.contains("data-kind=\"choice\"") {
                assert_eq!(
                    without_picture(&page.html),
                    without_picture(&other.html),
                    "{name}"
                );
            } else {
                assert_eq!(page.html, other.html, "{name}");
                assert!(page.pictures == other.pictures, "{name}: other pictures");
            }
            assert!(!other.html.contains(SECRET), "{name}");
            if asks {
                assert!(
                    other.explanation.contains(SECRET),
                    "{name}: {}",
                    other.explanation
                );
                same.fetch_add(1, Ordering::Relaxed);
                told.fetch_add(
                    usize::from(page.explanation != other.explanation),
                    Ordering::Relaxed,
                );
            }
        }
    });
    let (same, told) = (same.into_inner(), told.into_inner());
    assert!(
        same >= 150 && told == same,
        "{same} questions compared, {told} of them explained otherwise"
    );
}

#[test]
fn the_page_is_in_the_language_of_the_class() {
    let lesson = find("mach-bands").expect("a lesson");
    let page = |language| {
        in_language(language, || {
            let lesson = lesson.lesson_in(language);
            let page = step_page(&lesson, 1, SEED).expect("a page");
            (shell(&lesson, &page, false), page.explanation)
        })
    };
    let [(english, why), (chinese, reason)] = Language::ALL.map(page);
    assert!(english.contains("<html lang=\"en\">") && english.contains(">Send<"));
    assert!(chinese.contains("<html lang=\"zh-Hant\">") && chinese.contains(">送出<"));
    assert!(why.contains("The right answer") && reason.contains("正確答案"));
    assert!(english.contains("noLab") && english.contains("not on the lecturer’s computer"));
}

/// The style sheet has another colour for each that the axes are drawn in.
#[test]
fn the_axes_are_drawn_anew_on_a_dark_page() {
    let lesson = find("mach-bands")
        .expect("a lesson")
        .lesson_in(Language::English);
    let page = step_page(&lesson, 1, SEED).expect("a page");
    let (_, dark) = STYLE
        .rsplit_once("prefers-color-scheme: dark")
        .expect("a dark page");
    let mut colours = 0;
    for html in [&page.html, &page.explanation] {
        let (_, svg) = html.split_once("<svg").expect("axes");
        for attribute in ["fill", "stroke"] {
            for piece in svg.split(&format!("{attribute}=\"#")).skip(1) {
                let rule = format!("[{attribute}=\"#{}\"]", &piece[..6]);
                assert!(dark.contains(&rule), "no rule for {rule}");
                colours += 1;
            }
        }
    }
    assert!(colours > 10, "{colours} colours");
}
