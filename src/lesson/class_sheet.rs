//! A class on one page: who answered what, and how the answers to each question are spread.

use super::class::{Class, Given, Group, Unreadable};
use super::html::{Element, Html, element};
use super::kinds::Bars;
use super::kinds::kind::Predictions;
use super::page::{blocks, inline, page};
use super::record::how_given;
use crate::text::text;

const STYLE: &str = "\
.class td, .class th { text-align: center; white-space: nowrap; }
.class td:first-child, .class th:first-child { text-align: left; white-space: normal; overflow-wrap: anywhere; max-width: 60mm; }
.right { background: #dcefdc; }
.wrong { background: #f9e0dc; }
.class tfoot td { font-weight: 600; background: #f0f0f0; }
.how { font-size: 8pt; color: #555; }
.scroll { overflow-x: auto; }
.question { break-inside: avoid; border-top: 0.3mm solid #b5b5b5; padding-top: 3mm; margin-top: 5mm; }
.bars td { border: none; padding: 0.4mm 2mm; }
.bars .bar { width: 55mm; }
.bars .bar div { background: #8fb3d9; height: 4mm; min-width: 0.4mm; }
.bars .is-right .bar div { background: #5f9e5f; }
.points { max-width: 110mm; }
@media print { .right, .wrong, .bar div, .class tfoot td { print-color-adjust: exact; } }
";

/// Returns the page of a class as HTML.
pub fn class_sheet(class: &Class) -> String {
    let mut body: Html = class.groups.iter().map(group_part).collect();
    let uncounted: Vec<&Unreadable> = class.set_aside.iter().chain(&class.unreadable).collect();
    if !uncounted.is_empty() {
        let files = uncounted.into_iter();
        let list = files.fold(element("ul").broken(), |list, file| {
            let name = element("code").with(&*file.file);
            list.line(element("li").with(name).with(": ").with(&*file.why))
        });
        let section = element("section")
            .broken()
            .line(element("h2").with(text!("class-unreadable")))
            .line(list);
        body = body.line(section);
    }
    let title = match &class.groups[..] {
        [group] => group.lesson.title.clone(),
        _ => text!("class-sheet").to_owned(),
    };
    page(&title, STYLE, body)
}

fn group_part(group: &Group) -> Html {
    let count = group.students.len();
    let table = element("div").class("scroll").with(group_table(group));
    let section = element("section")
        .broken()
        .line(element("h1").with(&*group.lesson.title))
        .line(quiet(text!("class-students", count = count)))
        .line(table);
    let questions = (0..group.questions.len()).filter_map(|index| question_part(group, index));
    Html::new().line(questions.fold(section, Element::line))
}

/// Returns who answered what, and how many had each question right.
fn group_table(group: &Group) -> Element {
    let questions = group.questions.len();
    let cell = |name: &'static str, words: &str| element(name).with(words);
    let numbers = (1..=questions).map(|number| cell("th", &number.to_string()));
    let head = numbers
        .fold(
            element("tr").with(cell("th", text!("class-name"))),
            Element::with,
        )
        .with(cell("th", text!("class-right")));
    let rows = group.students.iter().map(|student| {
        let name = if student.name.is_empty() {
            &student.file
        } else {
            &student.name
        };
        let name = cell("td", name).attribute("title", &student.file);
        let given = student.given.iter().map(|given| given_cell(given.as_ref()));
        let right = format!("{}/{questions}", student.right());
        given
            .fold(element("tr").with(name), Element::with)
            .with(cell("td", &right))
    });
    let shares = (0..questions).map(|index| {
        let share = 100.0 * group.share_right(index);
        cell("td", &format!("{share:.0}\u{a0}%"))
    });
    let foot = shares
        .fold(
            element("tr").with(cell("td", text!("class-share-right"))),
            Element::with,
        )
        .with(element("td"));
    element("table")
        .class("class")
        .broken()
        .line(element("thead").with(head))
        .line(rows.fold(element("tbody").broken(), Element::line))
        .line(element("tfoot").with(foot))
}

fn quiet(words: String) -> Element {
    element("p").class("quiet").with(words)
}

fn given_cell(given: Option<&Given>) -> Element {
    let Some(given) = given else {
        return element("td").with("–");
    };
    let (class, sign) = match given.grade {
        Some(grade) if grade.right => ("right", "✓"),
        Some(_) => ("wrong", "✗"),
        None => ("", ""),
    };
    let answered = &given.answered;
    let words = format!("{} {sign}", answered.short());
    let how = how_given(answered.tries, answered.looked_up, answered.seconds).join(" · ");
    let cell = element("td").class(class).with(words);
    if how.is_empty() {
        return cell;
    }
    cell.with(element("div").class("how").with(how))
}

fn question_part(group: &Group, index: usize) -> Option<Element> {
    let asked = &group.questions[index];
    let question = asked.question(&group.lesson)?;
    let step = group
        .lesson
        .steps
        .get(asked.step)
        .map_or("", |step| &*step.title);
    let title = Html::from(format!("{}. ", index + 1)).with(inline(step));
    let mut part = element("section")
        .class("question")
        .broken()
        .line(element("h2").with(title))
        .line(element("p").with(inline(&asked.ask)));
    if let Some(failure) = &asked.failure {
        part = part.line(element("p").with(element("strong").with(&**failure)));
    }
    let answered = group.given(index).count();
    let right = group.given(index).filter(|given| given.is_right()).count();
    part = part.line(quiet(text!(
        "class-answered",
        answered = answered,
        right = right
    )));
    let given = group.given(index).map(|given| {
        let grade = given.predicted.unwrap_or_default();
        (&given.answered.prediction, grade)
    });
    part = part.with(question.kind.chart(&Predictions {
        given: given.collect(),
        right: asked.solution(),
        options: &asked.options,
        picture: asked.picture.as_ref(),
    }));
    part = part.with(models_part(group, index));
    if let Some(words) = group.spread_words(index) {
        part = part.line(element("p").with(words));
    }
    if let Some(solution) = asked.solution()
        && !question.kind.asks().chart_tells()
    {
        let right = question.kind.short_solution(solution);
        part = part.line(element("p").with(text!("class-solution", right = right)));
    }
    if !asked.why.is_empty() {
        part = part.line(element("div").class("quiet").with(blocks(&asked.why)));
    }
    Some(part)
}

/// Returns the wrong models that first answers agree with, and how often each does.
fn models_part(group: &Group, index: usize) -> Html {
    let models = group.models(index);
    if models.is_empty() {
        return Html::new();
    }
    let answered = group.given(index).count();
    let heading = element("p").with(element("strong").with(text!("class-models")));
    let bars = Bars::new(answered);
    let bars = models.into_iter().fold(bars, |bars, (model, count)| {
        let says = group.questions[index].says.get(model);
        bars.with(inline(says.map_or("", |says| says)), count, false)
    });
    Html::new().line(heading).with(bars.table())
}
