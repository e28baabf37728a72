//! The page around the steps, which a phone opens first. Style and script are files of their own, whose addresses
//! change with their content, so that they are kept for as long as they are the same.

use super::StepPage;
use crate::lesson::{Html, Lesson, digest, element, inline, without_marks};
use crate::text::{language, text};
use serde_json::json;

/// The script of the page.
pub const SCRIPT: &str = include_str!("../../../assets/class/class.js");
/// The style sheet of the page.
pub const STYLE: &str = include_str!("../../../assets/class/class.css");

/// Returns the page of a class for phones, with the step that the class is at; its script goes on from there. `lab` says whether
/// the program's own page can be opened.
pub fn shell(lesson: &Lesson, step: &StepPage, lab: bool) -> String {
    let meta = |name: &str, content: &str| {
        element("meta")
            .attribute("name", name)
            .attribute("content", content)
    };
    let link = |rel: &str, address: &str| {
        element("link")
            .attribute("rel", rel)
            .attribute("href", address)
    };
    let status = |id: &str| element("p").attribute("id", id).attribute("role", "status");
    let address = |name: &str, content: &str| format!("{name}?{}", digest([content]));
    let head = element("head")
        .broken()
        .line(element("meta").attribute("charset", "utf-8"))
        .line(meta("viewport", "width=device-width, initial-scale=1"))
        .line(meta("color-scheme", "light dark"))
        .line(element("title").with(without_marks(&lesson.title)))
        .line(link("icon", "data:,"))
        .line(link("stylesheet", &address("class.css", STYLE)))
        .line(
            element("script")
                .attribute("src", address("class.js", SCRIPT))
                .attribute("defer", ""),
        );
    let body = element("body")
        .attribute("data-texts", texts(lab))
        .broken()
        .line(element("header").with(element("h1").with(inline(&lesson.title))))
        .line(status("connection"))
        .line(status("news"))
        .line(
            element("main")
                .attribute("id", "step")
                .with(Html::made(step.html.clone())),
        )
        .line(pager())
        .line(element("noscript").with(text!("phone-no-script")))
        .line(name_form());
    let page = element("html")
        .attribute("lang", language().tag())
        .broken()
        .line(head)
        .line(body);
    format!("<!DOCTYPE html>\n{}\n", Html::from(page))
}

/// Returns the buttons to other steps, hidden until the script shows them where students go at their own pace.
fn pager() -> Html {
    let button = |name: &str, words: &str| {
        element("button")
            .attribute("id", name)
            .attribute("type", "button")
            .with(words)
    };
    let nav = element("nav")
        .attribute("id", "pager")
        .attribute("hidden", "")
        .with(button("pager-back", text!("phone-back")))
        .with(element("span").class("quiet"))
        .with(button("pager-next", text!("phone-next")));
    Html::new().line(nav)
}

/// Returns the form for a nickname, which nobody has to give.
fn name_form() -> Html {
    let label = element("label")
        .attribute("for", "nickname")
        .with(text!("phone-name"));
    let input = element("input")
        .attribute("id", "nickname")
        .attribute("type", "text")
        .attribute("maxlength", 40)
        .attribute("autocomplete", "nickname");
    let row = element("p")
        .class("row")
        .with(input)
        .with(element("button").with(text!("phone-name-save")));
    let about = element("p").class("quiet").with(text!("phone-name-about"));
    let told = element("p").class("quiet").attribute("role", "status");
    let form = element("form")
        .attribute("id", "name")
        .broken()
        .line(element("p").with(label))
        .line(row)
        .line(about)
        .line(told);
    Html::new().line(element("footer").with(form))
}

/// Returns the sentences that the script says, as JSON.
fn texts(lab: bool) -> String {
    let (step, steps) = ("{step}", "{steps}");
    json!({
        "ownStep": text!("phone-own-step", step = step, steps = steps),
        "lecturerStep": text!("phone-lecturer-step", step = step, steps = steps, lecturer = "{lecturer}"),
        "noLab": (!lab).then(|| text!("phone-no-lab")),
        "lost": text!("phone-lost"),
        "sending": text!("phone-sending"),
        "saved": text!("phone-saved"),
        "changed": text!("phone-changed"),
        "waiting": text!("phone-waiting"),
        "again": text!("phone-again"),
        "closed": text!("phone-closed"),
        "spread": text!("phone-spread"),
        "missing": text!("phone-missing"),
        "named": text!("phone-named"),
        "refused": text!("phone-refused"),
    })
    .to_string()
}
