//! A class on one page: who answered what, and how the answers to each question are spread.

use super::class::{Class, Given, Group, spread};
use super::html::{Html, escaped};
use super::kinds::kind::Predictions;
use super::kinds::{short_answer, short_number};
use super::page::{blocks, inline, page};
use crate::text::text;
use std::fmt::Write as _;

const STYLE: &str = "\
.class td, .class th { text-align: center; white-space: nowrap; }
.class td:first-child, .class th:first-child { text-align: left; white-space: normal; overflow-wrap: anywhere; max-width: 60mm; }
.right { background: #dcefdc; }
.wrong { background: #f9e0dc; }
.class tfoot td { font-weight: 600; background: #f0f0f0; }
.scroll { overflow-x: auto; }
.question { break-inside: avoid; border-top: 0.3mm solid #b5b5b5; padding-top: 3mm; margin-top: 5mm; }
.bars td { border: none; padding: 0.4mm 2mm; }
.bars .bar { width: 55mm; }
.bars .bar div { background: #8fb3d9; height: 4mm; min-width: 0.4mm; }
.bars .is-right .bar div { background: #5f9e5f; }
.points { max-width: 110mm; }
@media print { .right, .wrong, .bar div, .class tfoot td { print-color-adjust: exact; } }
";

/// The page.
pub fn class_sheet(class: &Class) -> String {
    let mut body = String::new();
    for group in &class.groups {
        group_part(group, &mut body);
    }
    if !class.unreadable.is_empty() {
        let _ = write!(
            body,
            "<section>\n<h2>{}</h2>\n<ul>\n",
            escaped(text!("class-unreadable"))
        );
        for file in &class.unreadable {
            let _ = writeln!(
                body,
                "<li><code>{}</code>: {}</li>",
                escaped(&file.file),
                escaped(&file.why)
            );
        }
        body.push_str("</ul>\n</section>\n");
    }
    let title = match &class.groups[..] {
        [group] => group.lesson.title.clone(),
        _ => text!("class-sheet").to_owned(),
    };
    page(&title, STYLE, Html::made(body))
}

fn group_part(group: &Group, body: &mut String) {
    let count = group.students.len();
    let _ = write!(
        body,
        "<section>\n<h1>{}</h1>\n<p class=\"quiet\">{}</p>\n",
        escaped(&group.lesson.title),
        escaped(&text!("class-students", count = count))
    );
    let _ = write!(
        body,
        "<div class=\"scroll\"><table class=\"class\">\n<thead><tr><th>{}</th>",
        escaped(text!("class-name"))
    );
    for number in 1..=group.questions.len() {
        let _ = write!(body, "<th>{number}</th>");
    }
    let _ = write!(
        body,
        "<th>{}</th></tr></thead>\n<tbody>\n",
        escaped(text!("class-right"))
    );
    for student in &group.students {
        let name = if student.name.is_empty() {
            &student.file
        } else {
            &student.name
        };
        let _ = write!(
            body,
            "<tr><td title=\"{}\">{}</td>",
            escaped(&student.file),
            escaped(name)
        );
        for given in &student.given {
            body.push_str(&cell(given.as_ref()));
        }
        let _ = writeln!(
            body,
            "<td>{}/{}</td></tr>",
            student.right(),
            group.questions.len()
        );
    }
    let _ = write!(
        body,
        "</tbody>\n<tfoot><tr><td>{}</td>",
        escaped(text!("class-share-right"))
    );
    for index in 0..group.questions.len() {
        let _ = write!(
            body,
            "<td>{:.0}&#160;%</td>",
            100.0 * group.share_right(index)
        );
    }
    body.push_str("<td></td></tr></tfoot>\n</table></div>\n");
    for index in 0..group.questions.len() {
        question_part(group, index, body);
    }
    body.push_str("</section>\n");
}

fn cell(given: Option<&Given>) -> String {
    let Some(given) = given else {
        return "<td>–</td>".to_owned();
    };
    let (class, sign) = match given.grade {
        Some(grade) if grade.right => ("right", "✓"),
        Some(_) => ("wrong", "✗"),
        None => ("", ""),
    };
    let answer = escaped(&short_answer(&given.answered.answer));
    let looked_up = match given.answered.looked_up {
        0 => String::new(),
        count => format!(
            " title=\"{}\"",
            escaped(&text!("class-looked-up", count = count))
        ),
    };
    format!("<td class=\"{class}\"{looked_up}>{answer} {sign}</td>")
}

fn question_part(group: &Group, index: usize, body: &mut String) {
    let asked = &group.questions[index];
    let Some(question) = asked.question(&group.lesson) else {
        return;
    };
    let step = group
        .lesson
        .steps
        .get(asked.step)
        .map_or("", |step| &*step.title);
    let _ = write!(
        body,
        "<section class=\"question\">\n<h2>{}. {}</h2>\n<p>{}</p>\n",
        index + 1,
        inline(step),
        inline(&asked.ask)
    );
    if let Some(failure) = &asked.failure {
        let _ = writeln!(body, "<p><strong>{}</strong></p>", escaped(failure));
    }
    let answered = group.given(index).count();
    let right = group.given(index).filter(|given| given.is_right()).count();
    let _ = writeln!(
        body,
        "<p class=\"quiet\">{}</p>",
        escaped(&text!("class-answered", answered = answered, right = right))
    );
    let given = group.given(index).map(|given| {
        let right = given.predicted.is_some_and(|grade| grade.right);
        (&given.answered.prediction, right)
    });
    body.push_str(&question.kind.chart(&Predictions {
        given: given.collect(),
        right: asked.solution.as_ref(),
        options: &asked.options,
        picture: asked.picture.as_ref(),
    }));
    if let Some(five) = spread(&group.predicted(index)) {
        let key = if question.kind.asks().predicts_number() {
            "class-predicted"
        } else {
            "class-off"
        };
        let [least, lower, median, upper, greatest] = five.map(short_number);
        let words = text!(
            key,
            least = least,
            lower = lower,
            median = median,
            upper = upper,
            greatest = greatest
        );
        let _ = writeln!(body, "<p>{}</p>", escaped(&words));
    }
    if let Some(solution) = &asked.solution
        && !question.kind.asks().chart_tells()
    {
        let right = question.kind.short_solution(solution);
        let _ = writeln!(
            body,
            "<p>{}</p>",
            escaped(&text!("class-solution", right = right))
        );
    }
    if !asked.why.is_empty() {
        let _ = writeln!(body, "<div class=\"quiet\">{}</div>", blocks(&asked.why));
    }
    body.push_str("</section>\n");
}
