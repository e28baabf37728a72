//! A class on one page: who answered what, and how the answers to each question are spread.

use super::axes::CurveAxes;
use super::class::{
    Class, ClassQuestion, Given, Group, letter, short_answer, short_solution, spread,
};
use super::html::{Html, escaped};
use super::page::{blocks, data, inline, page};
use super::{Answer, CURVE_POINTS, Kind, Question, Solution};
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
    match &question.kind {
        Kind::Choice { .. } | Kind::Order { .. } => counts(group, index, asked, body),
        Kind::Point { tolerance, .. } => clicks(group, index, asked, *tolerance, body),
        Kind::Curve { x, y, .. } => curves(group, index, asked, question, [*x, *y], body),
        Kind::Value {
            from,
            to,
            tolerance,
            ..
        } => {
            numbers(group, index, asked, Some([*from, *to]), *tolerance, body);
        }
        Kind::Settings { tolerance, .. } => numbers(group, index, asked, None, *tolerance, body),
        Kind::Match { .. } => {}
    }
    if let Some(five) = spread(&group.predicted(index)) {
        let key = if question.kind.predicts_number() {
            "class-predicted"
        } else {
            "class-off"
        };
        let [least, lower, median, upper, greatest] =
            five.map(|value| short_answer(&Answer::Value(value)));
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
        && !question.kind.is_drawn()
        && !matches!(question.kind, Kind::Choice { .. })
    {
        let right = short_solution(question, solution);
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

/// How often each option or order was predicted.
fn counts(group: &Group, index: usize, asked: &ClassQuestion, body: &mut String) {
    let counted = group.counted(index);
    let total = counted.iter().map(|(_, count)| count).sum::<usize>().max(1);
    let right = asked.solution.as_ref().map(Answer::right);
    let bar = |label: &str, answer: &Answer, count: usize| {
        let class = if right.as_ref() == Some(answer) {
            " class=\"is-right\""
        } else {
            ""
        };
        let share = 100.0 * count as f64 / total as f64;
        format!(
            "<tr{class}><td>{label}</td><td class=\"bar\"><div style=\"width:{share:.1}%\"></div></td><td>{count}</td></tr>\n"
        )
    };
    body.push_str("<table class=\"bars\">\n");
    if let Some(Answer::Choice(_)) = counted.first().map(|(answer, _)| answer) {
        for (option, words) in asked.options.iter().enumerate() {
            let answer = Answer::Choice(option);
            let count = counted.iter().find(|(counted, _)| *counted == answer);
            let sign = if right.as_ref() == Some(&answer) {
                " ✓"
            } else {
                ""
            };
            let label = format!("{} {}{sign}", letter(option), inline(words));
            body.push_str(&bar(&label, &answer, count.map_or(0, |(_, count)| *count)));
        }
    } else {
        for (answer, count) in counted.iter().take(12) {
            let sign = if right.as_ref() == Some(answer) {
                " ✓"
            } else {
                ""
            };
            let label = format!("{}{sign}", escaped(&short_answer(answer)));
            body.push_str(&bar(&label, answer, *count));
        }
    }
    body.push_str("</table>\n");
    if asked
        .question(&group.lesson)
        .is_some_and(|question| matches!(question.kind, Kind::Order { .. }))
    {
        let items = asked.options.iter().enumerate();
        let items: Vec<String> = items
            .map(|(item, words)| format!("{} {}", letter(item), inline(words)))
            .collect();
        let _ = writeln!(body, "<p class=\"quiet\">{}</p>", items.join(" · "));
    }
}

/// Every predicted place over the picture, and the right ones.
fn clicks(group: &Group, index: usize, asked: &ClassQuestion, tolerance: f64, body: &mut String) {
    let Some(frame) = &asked.picture else {
        return;
    };
    let [width, height] = [frame.width, frame.height].map(f64::from);
    let side = width.min(height);
    let place = |[x, y]: [f64; 2]| [width / 2.0 + x * side, height / 2.0 + y * side];
    let mut svg = format!(
        "<figure class=\"points\"><svg viewBox=\"0 0 {width} {height}\" role=\"img\" fill=\"none\">\n<image href=\"{}\" width=\"{width}\" height=\"{height}\"/>\n",
        data(frame)
    );
    if let Some(Solution::Places(places)) = &asked.solution {
        let single = places.len() == 1;
        for right in places {
            let [x, y] = place(right.to_array());
            let radius = if single {
                tolerance * side
            } else {
                0.004 * side
            };
            let paint = if single {
                "stroke=\"#fff\" stroke-width=\"2\""
            } else {
                "fill=\"#fff\""
            };
            let _ = writeln!(
                svg,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius:.1}\" {paint}/>"
            );
        }
    }
    for given in group.given(index) {
        if let Answer::Point(at) = given.answered.prediction {
            let [x, y] = place(at);
            let colour = match given.predicted {
                Some(grade) if grade.right => "#2e9e4f",
                _ => "#e0482e",
            };
            let _ = writeln!(
                svg,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{:.1}\" fill=\"{colour}\" fill-opacity=\"0.75\" stroke=\"#000\" stroke-width=\"0.8\"/>",
                0.012 * side
            );
        }
    }
    let _ = write!(
        body,
        "{svg}</svg>\n<figcaption>{}</figcaption></figure>\n",
        escaped(text!("class-clicks"))
    );
}

/// Every predicted curve, and over them the right one.
fn curves(
    group: &Group,
    index: usize,
    asked: &ClassQuestion,
    question: &Question,
    [x, y]: [[f64; 2]; 2],
    body: &mut String,
) {
    let Kind::Curve { x_name, y_name, .. } = &question.kind else {
        return;
    };
    let axes = CurveAxes::new([x, y], [&x_name.plain(), &y_name.plain()]);
    let mut drawing = axes.on_page();
    let at = |index: usize| x[0] + (x[1] - x[0]) * index as f64 / (CURVE_POINTS - 1) as f64;
    for given in group.given(index) {
        if let Answer::Curve(values) = &given.answered.prediction {
            let points = values.iter().enumerate();
            let points = points.map(|(index, value)| [at(index), value.unwrap_or(f64::NAN)]);
            let colour = match given.predicted {
                Some(grade) if grade.right => [0x2e, 0x7d, 0x43],
                _ => [0xc2, 0x3a, 0x22],
            };
            drawing.draw_curve(points, 1.4, colour, 0.55);
        }
    }
    if let Some(Solution::Curve(right)) = &asked.solution {
        drawing.draw_curve(right.iter().copied(), 3.0, [0; 3], 1.0);
    }
    let _ = writeln!(
        body,
        "<figure>{}<figcaption>{}</figcaption></figure>",
        drawing.to_svg(&axes.words()),
        escaped(text!("class-curves"))
    );
}

/// Predicted numbers as dots over their axis, one over the other, with the band that counts as right.
fn numbers(
    group: &Group,
    index: usize,
    asked: &ClassQuestion,
    range: Option<[f64; 2]>,
    tolerance: f64,
    body: &mut String,
) {
    const COLUMNS: usize = 60;
    const DOT: f64 = 4.0;
    let predicted = group.predicted(index);
    let right = asked.solution.as_ref().map(Answer::right);
    let right = match right {
        Some(Answer::Value(right) | Answer::Settings(right)) => Some(right),
        _ => None,
    };
    let all = || predicted.iter().copied().chain(right);
    let least = all().fold(f64::INFINITY, f64::min);
    let greatest = all().fold(f64::NEG_INFINITY, f64::max);
    if !(least.is_finite() && greatest.is_finite()) {
        return;
    }
    let margin = 0.05 * (greatest - least).max(2.0 * tolerance);
    let x = range.unwrap_or([least - margin, greatest + margin]);
    let mut columns = vec![0usize; COLUMNS];
    let (mut dots, width) = (String::new(), 520.0);
    let share = |value: f64| ((value - x[0]) / (x[1] - x[0])).clamp(0.0, 1.0);
    let highest = |columns: &[usize]| {
        columns.iter().copied().max().unwrap_or(0).max(4) as f64 * 2.0 * DOT + 6.0
    };
    let places: Vec<(usize, usize)> = predicted
        .iter()
        .map(|value| {
            let column = ((share(*value) * COLUMNS as f64) as usize).min(COLUMNS - 1);
            columns[column] += 1;
            (column, columns[column])
        })
        .collect();
    let height = highest(&columns);
    // Large classes get smaller steps, not a higher drawing.
    let step = (2.0 * DOT).min(200.0 / columns.iter().copied().max().unwrap_or(1).max(1) as f64);
    let height = height.min(210.0);
    for (column, row) in places {
        let cx = (column as f64 + 0.5) / COLUMNS as f64 * width;
        let cy = height - (row as f64 - 0.5) * step;
        let _ = writeln!(
            dots,
            "<circle cx=\"{cx:.1}\" cy=\"{cy:.1}\" r=\"{:.1}\" fill=\"#3d73a8\"/>",
            DOT.min(step)
        );
    }
    let mut svg = format!(
        "<figure><svg viewBox=\"-30 -4 580 {:.0}\" width=\"580\" role=\"img\">\n",
        height + 28.0
    );
    if let Some(right) = right {
        let at = |value: f64| share(value) * width;
        let band = if range.is_some() {
            [at(right - tolerance), at(right + tolerance)]
        } else {
            [at(right); 2]
        };
        let _ = writeln!(
            svg,
            "<rect x=\"{:.1}\" width=\"{:.1}\" height=\"{height:.1}\" fill=\"#dcefdc\"/><path d=\"M{:.1} 0V{height:.1}\" stroke=\"#2e7d43\" stroke-width=\"2\"/>",
            band[0],
            band[1] - band[0],
            at(right)
        );
    }
    let _ = writeln!(svg, "<path d=\"M0 {height:.1}H{width}\" stroke=\"#555\"/>");
    for index in 0..=4 {
        let value = x[0] + (x[1] - x[0]) * f64::from(index) / 4.0;
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"13\" text-anchor=\"middle\">{}</text>",
            share(value) * width,
            height + 18.0,
            escaped(&short_answer(&Answer::Value(value)))
        );
    }
    let _ = write!(
        body,
        "{svg}{dots}</svg>\n<figcaption>{}</figcaption></figure>\n",
        escaped(text!("class-numbers"))
    );
}
