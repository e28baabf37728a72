//! The language of the program, from `--language` or the system's locale: it affects only what people read.

use crate::common::program::Folder;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Output;

/// Runs the program in a Taiwanese locale.
fn in_taiwan(folder: &Folder, arguments: &[&str]) -> Output {
    let mut command = folder.command(arguments);
    command.env("LC_ALL", "zh_TW.UTF-8");
    command.output().expect("the program")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn help_and_errors_are_in_the_language_of_the_locale_unless_an_option_says_otherwise() {
    let folder = Folder::new("language");
    let chinese = text(&in_taiwan(&folder, &["--help"]).stdout);
    assert!(
        chinese.contains("用法：") && chinese.contains("列出內建場景"),
        "{chinese}"
    );
    assert_eq!(folder.prints(&["--language", "zh-Hant", "--help"]), chinese);
    let english = folder.prints(&["--help"]);
    assert!(
        english.contains("Usage:") && english.contains("List the built-in scenes"),
        "{english}"
    );
    let asked = in_taiwan(&folder, &["--language", "en", "--help"]);
    assert_eq!(text(&asked.stdout), english);
    let failed = in_taiwan(&folder, &["check", "none.toml"]);
    assert_eq!(failed.status.code(), Some(2));
    assert_eq!(
        text(&failed.stderr),
        "錯誤：none.toml: 找不到檔案，應為場景檔\n"
    );
    // On either side of the command.
    for arguments in [
        &["--language", "zh-Hant", "probe", "sphere", "--pixel", "1"][..],
        &["probe", "sphere", "--pixel", "1", "--language=zh-Hant"],
    ] {
        let refused = folder.run(arguments);
        assert_eq!(refused.status.code(), Some(2));
        assert_eq!(
            text(&refused.stderr),
            "錯誤：--pixel <X,Y> 的值「1」不正確：應為從左上角起算的整數像素 X,Y，例如 100,80\n"
        );
    }
    let unknown = ["scenes", "--language", "fr"];
    folder.refuses(
        &unknown,
        &english!("cli-no-language", first = "en", second = "zh-Hant"),
    );
}

/// Collects all keys and texts of a JSON value.
fn words(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::String(text) => {
            found.insert(text.clone());
        }
        Value::Array(values) => values.iter().for_each(|value| words(value, found)),
        Value::Object(entries) => {
            for (key, value) in entries {
                found.insert(key.clone());
                words(value, found);
            }
        }
        _ => {}
    }
}

/// Checks that output for programs has the same bytes in both languages or, where it contains times, the same words.
#[test]
fn what_programs_read_is_the_same_in_both_languages() {
    let folder = Folder::new("same");
    let small = ["--set", "image.size=[48,48]", "--set", "object.segments=12"];
    let study = [
        "study",
        "--methods=flat,taylor",
        "--segments=8",
        "--interpolation=affine",
        "--repeats=1",
    ];
    let analyses: [(&[&str], bool); 12] = [
        (&["probe", "--pixel", "24,24"], true),
        (&["curves"], true),
        (&["profile", "--from", "2,20", "--to", "46,30"], true),
        (&["scanline"], true),
        (&["normals"], true),
        (&["compare", "--pane", "shading.mode=flat"], true),
        (&["defects"], true),
        (&["conditions"], true),
        (&["stability", "--case", "far-from-the-origin"], true),
        (&["explain", "--frames", "1"], false),
        (&study, false),
        (&["bench", "--frames", "1"], false),
    ];
    for scene in ["three-lights", "checker"] {
        for (arguments, same) in analyses {
            let subject = [&[scene], &small[..]].concat();
            let subject = if arguments[0] == "stability" {
                &[][..]
            } else {
                &subject
            };
            let written = ["en", "zh-Hant"].map(|language| {
                let to = ["--language", language, "--csv", "a.csv", "-o", "a.json"];
                folder.prints(&[arguments, subject, &to].concat());
                ["a.csv", "a.json"].map(|name| fs::read_to_string(folder.0.join(name)).expect(name))
            });
            let [[csv, json], [chinese_csv, chinese_json]] = written;
            if same {
                assert_eq!((csv, json), (chinese_csv, chinese_json), "{arguments:?}");
                continue;
            }
            let [english, chinese] = [json, chinese_json].map(|json| {
                let mut found = BTreeSet::new();
                words(&serde_json::from_str(&json).expect("JSON"), &mut found);
                found
            });
            assert_eq!(english, chinese, "{arguments:?}");
            let head = |csv: &str| csv.lines().next().map(str::to_owned);
            assert_eq!(head(&csv), head(&chinese_csv), "{arguments:?}");
            let chinese = |c: char| ('\u{4E00}'..='\u{9FFF}').contains(&c);
            assert!(!chinese_csv.contains(chinese), "{chinese_csv}");
        }
        // The scene inside the picture is TOML.
        let drawn = ["en", "zh-Hant"].map(|language| {
            let to = ["--language", language, "-o", "a.png"];
            folder.prints(&[&["render", scene][..], &small, &to].concat());
            fs::read(folder.0.join("a.png")).expect("a picture")
        });
        assert!(drawn[0] == drawn[1], "{scene}");
    }
    for list in ["scenes", "materials", "parameters"] {
        let english = folder.prints(&[list, "--json"]);
        let chinese = text(&in_taiwan(&folder, &[list, "--json"]).stdout);
        assert_eq!(english, chinese, "{list}");
    }
    for target in ["c", "c-snippet", "glsl"] {
        let shadows = ["--set", "shading.shadows=true"];
        let code = [&["code", "three-lights", "--target", target][..], &shadows].concat();
        let [english, chinese] = [folder.run(&code), in_taiwan(&folder, &code)];
        assert_eq!(english.stdout, chinese.stdout, "{target}");
        assert_ne!(text(&english.stderr), text(&chinese.stderr), "{target}");
    }
}

/// Reads every text in Chinese: the catalogue and the lessons, each with the name of its file.
fn chinese_texts() -> Vec<(String, String)> {
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    let mut texts = Vec::new();
    for folder in ["text/zh-Hant", "lessons/zh-Hant"] {
        for file in fs::read_dir(assets.join(folder)).expect("a folder") {
            let path = file.expect("a file").path();
            let text = fs::read_to_string(&path).expect("a text");
            texts.push((path.display().to_string(), text));
        }
    }
    texts
}

/// Reads the table of Chinese terms in `docs/contributing.md`: each term with the variants that are not used.
fn chinese_terms() -> Vec<(&'static str, Vec<&'static str>)> {
    let table = include_str!("../../docs/contributing.md");
    let rows = table
        .lines()
        .skip_while(|line| *line != "| English | Chinese | not |");
    let rows = rows.skip(2).take_while(|line| line.starts_with('|'));
    rows.map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [_, term, variants] = cells[..] else {
            panic!("{row}: three cells expected");
        };
        let variants = variants.split('、').filter(|variant| !variant.is_empty());
        (term, variants.collect())
    })
    .collect()
}

/// Lists the lines of a text that have a variant of one of the terms. A variant inside a term is none: 正規化 in 反應正規化.
fn variants_in(text: &str, terms: &[(&str, Vec<&str>)]) -> Vec<String> {
    let mut found = Vec::new();
    for line in text.lines() {
        let rest = terms
            .iter()
            .fold(line.to_owned(), |rest, (term, _)| rest.replace(term, "·"));
        for (term, variants) in terms {
            let used = variants.iter().find(|variant| rest.contains(**variant));
            found.extend(used.map(|variant| format!("{variant} for {term}: {line}")));
        }
    }
    found
}

#[test]
fn chinese_has_one_term_for_one_thing() {
    let (terms, texts) = (chinese_terms(), chinese_texts());
    assert!(terms.len() > 30 && texts.len() > 50);
    let found: Vec<String> = texts
        .iter()
        .flat_map(|(file, text)| {
            let variants = variants_in(text, &terms);
            variants
                .into_iter()
                .map(move |variant| format!("{file}: {variant}"))
        })
        .collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
    // A term that no text has would be a rule for nothing.
    for (term, _) in &terms {
        let used = texts.iter().any(|(_, text)| text.contains(term));
        assert!(used, "{term} is in no text");
    }
}

#[test]
fn a_variant_of_a_chinese_term_is_found() {
    let terms = chinese_terms();
    for (text, expected) in [
        ("這個通道", 1),
        ("反應正規化與正規化", 1),
        ("反應正規化", 0),
        ("以雙精度計算", 0),
        ("以倍精度計算", 1),
        ("微表面的分佈", 2),
    ] {
        assert_eq!(variants_in(text, &terms).len(), expected, "{text}");
    }
}
