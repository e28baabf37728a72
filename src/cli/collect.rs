//! `collect`: the answers of a class, as a table for people, as JSON, CSV and a page.

use super::handed::{note_set_aside, read};
use super::input::output_file;
use super::inventory::compare;
use super::output::{Failure, columns, print, print_json, write_text};
use clap::Args;
use serde_json::{Value, json};
use shading_lab::analysis::report::{Cell, Column, Table};
use shading_lab::document::check_target;
use shading_lab::lesson::{
    Class, ClassQuestion, Given, Grade, Group, SameFormula, Student, Unreadable, answer_parts,
    class_sheet, short_answer, spread, without_marks,
};
use shading_lab::text::{escaped, excerpt, text};
use std::path::{Path, PathBuf};

#[derive(Args)]
pub struct Collect {
    #[arg(value_name = "FILE.png", required_unless_present = "pre")]
    files: Vec<PathBuf>,
    #[arg(long, value_name = "FILE.png", num_args = 1.., requires = "post", conflicts_with_all = ["files", "lesson", "output"])]
    pre: Vec<PathBuf>,
    #[arg(long, value_name = "FILE.png", num_args = 1.., requires = "pre")]
    post: Vec<PathBuf>,
    #[arg(long, value_name = "FILE.md")]
    lesson: Option<PathBuf>,
    #[arg(long)]
    json: bool,
    #[arg(long, value_name = "FILE.csv", value_parser = output_file())]
    csv: Option<PathBuf>,
    #[arg(short, long, value_name = "FILE.html", value_parser = super::lesson::page_name())]
    output: Option<PathBuf>,
}

impl Collect {
    pub fn run(self) -> Result<(), Failure> {
        for target in [&self.csv, &self.output].into_iter().flatten() {
            check_target(target)?;
        }
        if !self.pre.is_empty() {
            return compare(&self.pre, &self.post, self.csv.as_deref(), self.json);
        }
        let lesson = self.lesson.as_deref().map(super::lesson::open_file);
        let lesson = lesson.transpose()?;
        let class = read(&self.files, lesson.as_ref(), self.output.is_some())?;
        if let Some(target) = &self.csv {
            write_text(target, &csv(&class))?;
        }
        if let Some(target) = &self.output {
            write_text(target, &class_sheet(&class))?;
        }
        if self.json {
            print_json(&format!("{:#}\n", object(&class)))?;
        } else if self.csv.is_none() && self.output.is_none() {
            print(&class.groups.iter().map(table).collect::<String>())?;
        }
        note_set_aside(&class);
        let failures: Vec<String> = class
            .groups
            .iter()
            .flat_map(|group| failures(group, self.lesson.as_deref()))
            .chain(
                class
                    .unreadable
                    .iter()
                    .flat_map(|Unreadable { file, why, .. }| {
                        why.lines().map(move |line| format!("{file}: {line}"))
                    }),
            )
            .collect();
        if failures.is_empty() {
            Ok(())
        } else {
            Err(Failure::Input(failures.join("\n")))
        }
    }
}

/// Returns the questions without a correct answer, each with its line in the lesson's file, or in the first picture
/// with that lesson inside.
fn failures(group: &Group, lesson: Option<&Path>) -> impl Iterator<Item = String> {
    let line = |class_question: &ClassQuestion| {
        let step = group.lesson.steps.get(class_question.step);
        step.map_or(0, |step| step.line)
    };
    let told = move |line: u64, failure: &str| match (lesson, group.students.first()) {
        (Some(path), _) => format!("{}:{line}: {failure}", path.display()),
        (None, Some(first)) if group.foreign() => {
            let error = format!("{line}: {failure}");
            format!(
                "{}: {}",
                first.file,
                text!("class-bad-lesson", error = error)
            )
        }
        _ => format!("{}:{line}: {failure}", group.lesson.name),
    };
    let failed = group.questions.iter();
    let failed = failed.filter_map(move |class_question| {
        Some((line(class_question), class_question.failure.as_ref()?))
    });
    failed.flat_map(move |(line, failure)| {
        let lines = failure.lines().map(|words| told(line, words));
        lines.collect::<Vec<_>>()
    })
}

/// Returns every hand-in with its group, in the order of the files.
fn in_order(class: &Class) -> Vec<(&Group, &Student)> {
    let with_group = |group| move |student| (group, student);
    let mut all: Vec<(&Group, &Student)> = class
        .groups
        .iter()
        .flat_map(|group| group.students.iter().map(with_group(group)))
        .collect();
    all.sort_by_key(|(_, student)| student.index);
    all
}

fn object(class: &Class) -> Value {
    let answer = |group: &Group, question: usize, given: Option<&Given>| {
        let class_question = &group.questions[question];
        let kind = class_question
            .question(&group.lesson)
            .map(|question| question.kind.name());
        let value = |answer| answer_parts(answer).1;
        json!({
            "question": question + 1,
            "step": class_question.step + 1,
            "kind": kind,
            "given": given.map(|given| value(&given.answered.answer)),
            "right": match (&class_question.failure, given) {
                (Some(_), _) => None,
                (None, given) => Some(given.is_some_and(Given::is_right)),
            },
            "score": given.and_then(|given| Some(given.grade?.score)),
            "model": given.and_then(|given| given.grade?.model),
            "prediction": given.map(|given| value(&given.answered.prediction)),
            "prediction_right": given.and_then(|given| Some(given.predicted?.right)),
            "prediction_model": given.and_then(|given| given.predicted?.model),
            "looked_up": given.map(|given| given.answered.looked_up),
            "tries": given.map(|given| given.answered.tries),
            "seconds": given.map(|given| given.answered.seconds),
        })
    };
    let row = |(group, student): &(&Group, &Student)| {
        let answers = student.given.iter().enumerate();
        let answers: Vec<Value> = answers
            .map(|(question, given)| answer(group, question, given.as_ref()))
            .collect();
        json!({
            "file": student.file, "name": student.name, "lesson": group.lesson.name, "answers": answers,
        })
    };
    let question = |group: &Group, question: usize| {
        let predicted = group.predicted(question);
        json!({
            "lesson": group.lesson.name,
            "question": question + 1,
            "answered": group.given(question).count(),
            "share_right": group.share_right(question),
            "solution": group.questions[question].solution(),
            "spread": spread(&predicted),
            "models": models(group, question),
            "formulas": formulas(group, question),
        })
    };
    let questions: Vec<Value> = class
        .groups
        .iter()
        .flat_map(|group| (0..group.questions.len()).map(move |index| question(group, index)))
        .collect();
    let files = |files: &[Unreadable]| -> Vec<Value> {
        let one = |file: &Unreadable| json!({ "file": file.file, "why": file.english });
        files.iter().map(one).collect()
    };
    let rows: Vec<Value> = in_order(class).iter().map(row).collect();
    json!({
        "rows": rows,
        "unreadable": files(&class.unreadable),
        "set_aside": files(&class.set_aside),
        "questions": questions,
    })
}

/// Returns the wrong models of a question, with how many first answers agree with each.
fn models(group: &Group, question: usize) -> Vec<Value> {
    let counted = group.models(question);
    let answered = group.given(question).count().max(1);
    let says = group.questions[question].says.iter().enumerate();
    let named = says.filter(|(_, says)| !says.trim().is_empty());
    let row = |(model, says): (usize, &String)| {
        let found = counted.iter().find(|(known, _)| *known == model);
        let count = found.map_or(0, |(_, count)| *count);
        json!({
            "model": model, "says": says, "count": count, "share": count as f64 / answered as f64,
        })
    };
    named.map(row).collect()
}

/// Returns the formulas of a question by their meaning; nothing for other questions.
fn formulas(group: &Group, question: usize) -> Option<Vec<Value>> {
    let rows = group.formulas(question).into_iter().map(|same| {
        let spellings = same.spellings.iter();
        let spellings: Vec<Value> = spellings
            .map(|(text, count)| json!({ "text": text, "count": count }))
            .collect();
        json!({
            "model": same.model, "right": same.right, "count": same.count(), "spellings": spellings,
        })
    });
    let rows: Vec<Value> = rows.collect();
    (!rows.is_empty()).then_some(rows)
}

fn csv(class: &Class) -> String {
    let heads = [
        "file",
        "name",
        "lesson",
        "right",
        "questions",
        "share_right",
    ];
    let most = class.groups.iter().map(|group| group.questions.len()).max();
    let endings = [
        "",
        "_right",
        "_model",
        "_first",
        "_first_right",
        "_first_model",
        "_tries",
        "_looked_up",
        "_seconds",
    ];
    let questions = (1..=most.unwrap_or(0)).flat_map(|n| endings.map(|of| format!("q{n}{of}")));
    let columns = heads.into_iter().map(str::to_owned).chain(questions);
    let mut table = Table::new(columns.map(Column::key));
    for (group, student) in in_order(class) {
        let (right, questions) = (student.right(), group.questions.len());
        let share = right as f64 / questions.max(1) as f64;
        let mut row: Vec<Cell> = vec![
            student.file.as_str().into(),
            student.name.as_str().into(),
            group.lesson.name.as_str().into(),
            right.into(),
            questions.into(),
            format!("{share:.3}").into(),
        ];
        for given in &student.given {
            let given = given.as_ref();
            let answered = given.map(|given| &given.answered);
            let [last, first] = [|given: &Given| given.grade, |given: &Given| given.predicted]
                .map(|grade| given.and_then(grade));
            let model = |grade: Option<Grade>| {
                let model = grade.and_then(|grade| grade.model);
                model.map(|model| model.to_string())
            };
            row.extend([
                answered.map(|answered| cell(&answered.answer)).into(),
                u64::from(last.is_some_and(|grade| grade.right)).into(),
                model(last).into(),
                answered.map(|answered| cell(&answered.prediction)).into(),
                u64::from(first.is_some_and(|grade| grade.right)).into(),
                model(first).into(),
                answered.map(|answered| u64::from(answered.tries)).into(),
                answered
                    .map(|answered| u64::from(answered.looked_up))
                    .into(),
                answered
                    .map(|answered| format!("{:.1}", answered.seconds))
                    .into(),
            ]);
        }
        row.resize(table.columns.len(), Cell::Empty);
        table.rows.push(row);
    }
    table.to_csv()
}

fn cell(answer: &shading_lab::lesson::Answer) -> String {
    let list = |value: &Value| {
        let entries = value.as_array()?.iter();
        let entries: Vec<String> = entries.map(|entry| entry.to_string()).collect();
        Some(entries.join(" ").replace("null", "-"))
    };
    match answer_parts(answer) {
        (kind, _) if kind == "choice" || kind == "order" => short_answer(answer),
        (_, Value::String(text)) => text,
        (_, value) => list(&value).unwrap_or_else(|| value.to_string()),
    }
}

fn table(group: &Group) -> String {
    let mut rows = vec![vec![text!("class-name").to_owned()]];
    rows[0].extend((1..=group.questions.len()).map(|number| number.to_string()));
    rows[0].push(text!("class-right").to_owned());
    for student in &group.students {
        let name = if student.name.is_empty() {
            let file = Path::new(&student.file).file_name();
            file.map_or_else(
                || student.file.clone(),
                |file| file.to_string_lossy().into_owned(),
            )
        } else {
            student.name.clone()
        };
        let mut row = vec![one_line(&name)];
        row.extend(student.given.iter().map(|given| match given {
            Some(given) => {
                let sign = if given.is_right() { '✓' } else { '✗' };
                format!("{} {sign}", given.answered.short())
            }
            None => "–".to_owned(),
        }));
        row.push(format!("{}/{}", student.right(), group.questions.len()));
        rows.push(row);
    }
    let mut right = vec![text!("class-share-right").to_owned()];
    let count = group.questions.len();
    right.extend((0..count).map(|index| format!("{:.0} %", 100.0 * group.share_right(index))));
    rows.push(right);
    let widths: Vec<usize> = (0..count + 2)
        .map(|column| {
            let cells = rows.iter().filter_map(|row| row.get(column));
            cells.map(|cell| columns(cell)).max().unwrap_or(0)
        })
        .collect();
    let title = text!(
        "class-title",
        title = one_line(&group.lesson.title),
        students = group.students.len()
    );
    let mut out = format!("{title}\n\n");
    for row in &rows {
        let mut line = String::new();
        for (cell, most) in row.iter().zip(&widths) {
            line.push_str(cell);
            line.extend(std::iter::repeat_n(' ', most + 2 - columns(cell)));
        }
        out.push_str(line.trim_end());
        out.push('\n');
    }
    out.push('\n');
    for index in 0..count {
        out.push_str(&question_line(group, index));
    }
    out.push('\n');
    out
}

/// Formats the predictions of the class and the correct answer.
fn question_line(group: &Group, index: usize) -> String {
    let class_question = &group.questions[index];
    let Some(question) = class_question.question(&group.lesson) else {
        return String::new();
    };
    let number = index + 1;
    let mut line = format!(
        "{number}  {}",
        one_line(&without_marks(&class_question.ask))
    );
    let counted = group.counted(index);
    let formulas = group.formulas(index);
    if !formulas.is_empty() {
        line.extend(formulas.iter().map(formula_line));
    } else if let Some(words) = group.spread_words(index) {
        line += &format!("\n   {words}");
    } else if !counted.is_empty() {
        let counts: Vec<String> = counted
            .iter()
            .take(8)
            .map(|(answer, count)| format!("{} {count}×", short_answer(answer)))
            .collect();
        line += &format!("\n   {}", counts.join(", "));
    }
    for (model, count) in group.models(index) {
        let says = class_question.says.get(model).map_or("", |says| says);
        let share = 100.0 * count as f64 / group.given(index).count() as f64;
        let says = one_line(&without_marks(says));
        line += &format!("\n   {count}× ({share:.0} %) {says}");
    }
    if let Some(solution) = class_question.solution()
        && !question.kind.asks().is_drawn()
    {
        let right = question.kind.short_solution(solution);
        line += &format!("\n   {}", text!("class-solution", right = right));
    }
    line + "\n"
}

/// Formats answers that are one function: their most frequent spelling, and how many others there are.
fn formula_line(same: &SameFormula) -> String {
    let (text, _) = &same.spellings[0];
    let sign = if same.right { '✓' } else { '✗' };
    let mut line = format!("\n   {}× {} {sign}", same.count(), one_line(text));
    if same.spellings.len() > 1 {
        line += text!("comma");
        line += &text!("class-formula-more", count = same.spellings.len() - 1);
    }
    line
}

/// Returns arbitrary text as one line, as wide as the terminal shows it.
fn one_line(text: &str) -> String {
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    escaped(&excerpt(&words))
}
