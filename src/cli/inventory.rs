//! `collect --pre --post`: a test before a course compared with one after it.

use super::handed::{note_set_aside, read};
use super::output::{Failure, print, print_json, write_text};
use serde_json::{Value, json};
use shading_lab::analysis::report::{Column, Table, as_it_is, fixed};
use shading_lab::lesson::{TestStatistics, Unreadable, normalised_gain};
use shading_lab::text::text;
use std::path::{Path, PathBuf};

/// Compares the answers to a test before a course with those after it, for people, as CSV or as JSON.
pub fn compare(
    pre: &[PathBuf],
    post: &[PathBuf],
    csv: Option<&Path>,
    json: bool,
) -> Result<(), Failure> {
    let mut unreadable = Vec::new();
    let (before, titles) = statistics(pre, &mut unreadable)?;
    let (after, _) = statistics(post, &mut unreadable)?;
    let tests = [before, after];
    let [pre, post] = tests.each_ref().map(|test| test.items.len());
    if pre != post {
        let words = text!("inventory-items", pre = pre, post = post);
        return Err(Failure::Input(words));
    }
    if let Some(target) = csv {
        write_text(target, &table(&tests, &titles).to_csv())?;
    }
    if json {
        print_json(&format!("{:#}\n", object(&tests, &titles)))?;
    } else if csv.is_none() {
        print(&words(&tests, &titles))?;
    }
    if unreadable.is_empty() {
        Ok(())
    } else {
        Err(Failure::Input(unreadable.join("\n")))
    }
}

/// Grades the answers to one test, and returns the titles of its items with it. Files that cannot be read are noted.
fn statistics(
    files: &[PathBuf],
    unreadable: &mut Vec<String>,
) -> Result<(TestStatistics, Vec<String>), Failure> {
    let class = read(files, None, false)?;
    note_set_aside(&class);
    let told = |file: &Unreadable| format!("{}: {}", file.file, file.why);
    unreadable.extend(class.unreadable.iter().map(told));
    if let [group] = &class.groups[..] {
        let steps = group.questions.iter().map(|asked| asked.step);
        let titles = steps.map(|step| group.lesson.steps[step].title.clone());
        return Ok((TestStatistics::of_group(group), titles.collect()));
    }
    let groups = class.groups.iter();
    let names: Vec<&str> = groups.map(|group| &*group.lesson.name).collect();
    unreadable.push(text!("inventory-one-test", found = names.join(", ")));
    Err(Failure::Input(unreadable.join("\n")))
}

/// Returns the table of the items of a test, before and after, with their gain.
fn table(tests: &[TestStatistics; 2], titles: &[String]) -> Table {
    let [pre, post] = tests;
    let share = fixed::<2>;
    let mut table = Table::new([
        Column::both("item", text!("inventory-item"), as_it_is),
        Column::both("title", text!("inventory-title"), as_it_is),
        Column::both("pre_difficulty", text!("inventory-pre"), share),
        Column::both("post_difficulty", text!("inventory-post"), share),
        Column::both("gain", text!("inventory-gain"), share),
        Column::both("pre_discrimination", text!("inventory-pre-r"), share),
        Column::both("post_discrimination", text!("inventory-post-r"), share),
    ]);
    for (index, (a, b)) in pre.items.iter().zip(&post.items).enumerate() {
        table.rows.push(vec![
            (index + 1).into(),
            titles[index].as_str().into(),
            a.difficulty.into(),
            b.difficulty.into(),
            normalised_gain(a.difficulty, b.difficulty).into(),
            a.discrimination.into(),
            b.discrimination.into(),
        ]);
    }
    table
}

fn words(tests: &[TestStatistics; 2], titles: &[String]) -> String {
    let number = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), fixed::<2>);
    let line = |key: &str, test: &TestStatistics| {
        let words = text!(
            key,
            students = test.students,
            mean = fixed::<1>(100.0 * test.mean),
            deviation = fixed::<1>(100.0 * test.deviation),
            reliability = number(test.kr20)
        );
        words + "\n"
    };
    let [pre, post] = tests;
    let gain = number(normalised_gain(pre.mean, post.mean));
    let gain = text!("inventory-class-gain", gain = gain);
    let summary = [line("inventory-before", pre), line("inventory-after", post)].concat();
    format!("{summary}{gain}\n\n{}", table(tests, titles).text())
}

fn object(tests: &[TestStatistics; 2], titles: &[String]) -> Value {
    let one = |test: &TestStatistics| {
        let items = test.items.iter().enumerate();
        let items: Vec<Value> = items
            .map(|(index, item)| {
                json!({
                    "item": index + 1,
                    "title": titles[index],
                    "difficulty": item.difficulty,
                    "discrimination": item.discrimination,
                })
            })
            .collect();
        json!({
            "students": test.students, "mean": test.mean, "deviation": test.deviation, "kr20": test.kr20, "items": items,
        })
    };
    let [pre, post] = tests;
    json!({ "pre": one(pre), "post": one(post), "gain": normalised_gain(pre.mean, post.mean) })
}
