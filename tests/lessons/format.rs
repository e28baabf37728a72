//! Lessons as files: every kind of question is read, and every error has its line.

use crate::common::lessons::EVERY_KIND;
use shading_lab::lesson::{
    Choice, Curve, CurveOf, Extreme, Find, Goal, Kind, Lesson, LessonError, Match, MatchValues,
    Order, Point, Settings, Term, Value, check,
};
use shading_lab::scene::ShadingMode;

fn kinds() -> Vec<Kind> {
    let lesson = Lesson::read(EVERY_KIND, None).expect("a lesson");
    let questions = lesson.steps.into_iter().filter_map(|step| step.question);
    questions.map(|question| question.kind).collect()
}

#[test]
fn text_behind_the_question_comes_after_its_answer() {
    let question = "```question\nkind = \"choice\"\nask = \"?\"\n[[option]]\ntext = \"A\"\nright = true\n[[option]]\ntext = \"B\"\n```\n";
    let step = "```step\nscene = \"sphere\"\n```\n";
    let head = "+++\nlesson = 1\nname = \"after\"\ntitle = \"After\"\n+++\n\n## One\n\nBefore.\n\n";
    let source = format!("{head}{question}\nThe reason.\n\n{step}\nMore {{{{ 1 + 1 | 0 }}}}.\n");
    let lesson = Lesson::read(&source, None).expect("a lesson");
    let step_read = &lesson.steps[0];
    assert_eq!(step_read.text.plain().trim(), "Before.");
    let after = step_read.after.plain();
    assert!(
        after.contains("The reason.") && after.contains("More ."),
        "{after}"
    );
    assert!(!after.contains("Before"));
    // The order of the blocks alone decides: without a question all text is shown.
    let plain = Lesson::read(&format!("{head}{step}\nThe reason.\n"), None).expect("a lesson");
    assert!(plain.steps[0].text.plain().contains("The reason."));
    assert!(plain.steps[0].after.is_empty());
    // A mistake there has its line.
    let wrong = source.replace("1 + 1", "1 +");
    let error = Lesson::read(&wrong, None).expect_err("a mistake");
    let line = wrong
        .lines()
        .position(|line| line.contains("1 +"))
        .expect("a line") as u64
        + 1;
    assert_eq!(error.problems[0].line, line);
}

#[test]
fn every_kind_of_question_is_read() {
    let lesson = Lesson::read(EVERY_KIND, None).expect("a lesson");
    assert_eq!(
        (&*lesson.name, &*lesson.title, lesson.minutes),
        ("every-kind", "Every kind", 7)
    );
    assert_eq!((&*lesson.topic, &*lesson.about), ("light", "For tests."));
    let first = &lesson.steps[0];
    assert_eq!((&*first.title, first.line), ("Choice", 10));
    assert_eq!(
        (&*first.stage.scene, first.stage.view),
        ("sphere", Some("equation"))
    );
    assert_eq!(first.stage.overlays, ["vectors"]);
    // Numbers are hidden while a question is open, unless the step says otherwise.
    let hides = |index: usize| lesson.steps[index].stage.hide;
    assert!(hides(0) && hides(1));
    let shown = EVERY_KIND.replace("hide = true", "hide = false");
    let shown = Lesson::read(&shown, None).expect("a lesson");
    assert!(!shown.steps[0].stage.hide && shown.steps[1].stage.hide);
    assert_eq!(
        first.question.as_ref().map(|question| question.term),
        Some(Some(Term::Specular))
    );
    // A step inherits what it leaves open, and its settings are added.
    let second = &lesson.steps[1];
    assert_eq!(second.stage.scene, "sphere");
    assert_eq!(
        second.stage.set,
        ["camera.eye=[0,0,4]", "image.size=[96,96]", "material.n=20"]
    );
    assert_eq!(second.stage.line, first.stage.line);

    let kinds = kinds();
    let names: Vec<&str> = kinds.iter().map(Kind::name).collect();
    assert_eq!(
        names,
        [
            "choice", "choice", "value", "point", "point", "curve", "curve", "settings",
            "settings", "order", "match", "match", "formula"
        ]
    );
    assert!(matches!(&kinds[0], Kind::Choice(Choice { options, by: None }) if options.len() == 2));
    assert!(
        matches!(&kinds[1], Kind::Choice(Choice { by: Some((Extreme::Greatest, _)), options }) if options[1].set == ["material.kd=0.9"])
    );
    assert!(
        matches!(&kinds[2], Kind::Value(Value { tolerance, from, to, unit, .. }) if (*tolerance, *from, *to, &**unit) == (0.02, -1.0, 1.0, "m"))
    );
    assert!(
        matches!(&kinds[3], Kind::Point(Point { find: Find::Extreme(Extreme::Least, _), tolerance }) if *tolerance == 0.06)
    );
    assert!(matches!(
        &kinds[4],
        Kind::Point(Point {
            find: Find::Zero(_),
            ..
        })
    ));
    assert!(
        matches!(&kinds[5], Kind::Curve(Curve { x, y, of: CurveOf::Expression(_), .. }) if (*x, *y) == ([0.0, 90.0], [0.0, 1.0]))
    );
    assert!(matches!(
        &kinds[6],
        Kind::Curve(Curve {
            of: CurveOf::Profile(ShadingMode::Phong),
            ..
        })
    ));
    assert!(
        matches!(&kinds[7], Kind::Settings(Settings { control, goal: Goal::Equals(_), .. }) if control == "material.n")
    );
    assert!(matches!(
        &kinds[8],
        Kind::Settings(Settings {
            goal: Goal::Extreme(Extreme::Greatest),
            ..
        })
    ));
    assert!(matches!(&kinds[9], Kind::Order(Order { items, .. }) if items.len() == 3));
    assert!(
        matches!(&kinds[10], Kind::Match(Match { values: MatchValues::Given, controls, .. }) if controls == &["material.kd"])
    );
    assert!(matches!(
        &kinds[11],
        Kind::Match(Match {
            values: MatchValues::Random,
            ..
        })
    ));
}

/// Returns the problems of the lesson with one text replaced by another.
fn problems(from: &str, to: &str) -> LessonError {
    assert!(EVERY_KIND.contains(from), "{from}");
    let changed = EVERY_KIND.replacen(from, to, 1);
    match Lesson::read(&changed, None) {
        Err(error) => error,
        Ok(_) => panic!("{from} → {to} is read"),
    }
}

#[test]
fn a_range_is_one_that_an_axis_can_have() {
    for (from, to) in [
        ("x = [0, 90]", "x = [0, 5e-324]"),
        ("x = [0, 90]", "x = [0, inf]"),
        ("x = [0, 90]", "x = [0, nan]"),
        ("x = [0, 90]", "x = [90, 0]"),
        ("y = [0, 2]", "y = [1, 1.0000000000000002]"),
        ("y = [0, 2]", "y = [-1.7e308, 1.7e308]"),
        ("from = -1", "from = 1"),
        ("from = -1\nto = 1", "from = 1e16\nto = 10000000000000002"),
    ] {
        let error = problems(from, to).to_string();
        assert!(error.contains(english!("lesson-range")), "{to}: {error}");
    }
    for (from, to) in [
        ("x = [0, 90]", "x = [0, 1e-280]"),
        ("x = [0, 90]", "x = [-1e300, 1e300]"),
        ("x = [0, 90]", "x = [1000000, 1000001]"),
    ] {
        let changed = EVERY_KIND.replacen(from, to, 1);
        assert!(Lesson::read(&changed, None).is_ok(), "{to}");
    }
}

#[test]
fn every_error_has_its_line() {
    for (from, to, words) in [
        ("lesson = 1", "lesson = 2", "`lesson`"),
        ("name = \"every-kind\"", "name = \"Every Kind\"", "`name`"),
        ("minutes = 7", "minutes = -7", "invalid value"),
        ("minutes = 7", "length = 7", "unknown field"),
        ("view = \"equation\"", "view = \"equations\"", "`view`"),
        (
            "overlays = [\"vectors\"]",
            "overlays = [\"arrows\"]",
            "`overlays`",
        ),
        ("probe = [0.1, 0.1]", "probe = [0.1]", "invalid length"),
        (
            "{{ scene.material.n | 1 }}",
            "{{ scene.material.n | 12 }}",
            english!("lesson-number-digits"),
        ),
        (
            "{{ scene.material.n | 1 }}",
            "{{ 1 + }}",
            english!("lesson-number", words = "").trim_end(),
        ),
        ("kind = \"value\"", "kind = \"values\"", "`kind`"),
        ("answer = \"cos(60)\"", "answer = \"cos(60\"", "`answer`"),
        ("find = \"least\"", "find = \"lowest\"", "`find`"),
        ("profile = \"phong\"", "profile = \"smooth\"", "`profile`"),
        (
            "control = \"material.n\"",
            "control = \"material.m\"",
            "material.m",
        ),
        ("ask = \"Value\"", "asks = \"Value\"", "unknown field"),
        (
            "by = \"scene.material.n\"",
            "by = \"scene.material.\"",
            "`by`",
        ),
        ("holds = \"1 < 2\"", "holds = \"1 <\"", "`holds`"),
    ] {
        let error = problems(from, to);
        let line = 1 + EVERY_KIND[..EVERY_KIND.find(from).expect("there")]
            .matches('\n')
            .count() as u64;
        assert_eq!(error.problems[0].line, line, "{from} → {to}: {error}");
        assert!(
            error.problems[0].words.contains(words),
            "{from} → {to}: {error}"
        );
    }
}

#[test]
fn a_mistake_is_one_line_and_none_is_silent() {
    for (from, to, words) in [
        // What a block that is not read would have had is not missing as well.
        ("[0,0,4]\", \"image", "[0,0,4]\" \"image", "missing comma"),
        (
            "control = \"material.n\"",
            "control = \"light.0.position\"",
            "slider",
        ),
        ("```question", "```quiz", "“quiz”"),
    ] {
        let error = problems(from, to);
        assert_eq!(error.problems.len(), 1, "{from} → {to}: {error}");
        let told = &error.problems[0].words;
        assert!(told.contains(words), "{from} → {to}: {error}");
        // A key without a slider is no way out.
        assert!(!told.contains("light.N.position"), "{error}");
    }
    // What is to be shown is no mistake.
    let shown = EVERY_KIND.replacen("```question", "```toml", 1);
    assert!(Lesson::read(&shown, None).is_ok());
    let outside = EVERY_KIND.replacen("probe = [0.1, 0.1]", "probe = [0.9, 0.1]", 1);
    let outside = Lesson::read(&outside, None).expect("a lesson");
    let error = check(&outside).expect_err("a problem");
    let told = &error.problems[0];
    assert_eq!(
        (told.line, &*told.words),
        (15, english!("lesson-probe-outside"))
    );
}

#[test]
fn an_error_about_a_block_is_in_the_block() {
    for (from, to, words) in [
        ("tolerance = 0.02", "", "`tolerance`"),
        ("tolerance = 0.02", "tolerance = 0.0", "`tolerance`"),
        ("from = -1", "from = 2", "`from`"),
        ("ask = \"Value\"", "", "`ask`"),
        ("answer = \"cos(x)\"", "", "`answer`"),
        ("y = [0, 1]", "y = [1, 0]", "`y`"),
        ("equals = \"30\"", "", "`equals`"),
        (
            "equals = \"30\"",
            "equals = \"30\"\nmost = true",
            "`equals`",
        ),
        (
            "greatest = \"probe.sum[0]\"",
            "",
            english!("lesson-option-neither"),
        ),
        (
            "[[item]]\ntext = \"A\"\nset = [\"material.n=5\"]\n",
            "",
            &english!("lesson-items", least = 3, most = 6),
        ),
        (
            "[[option]]\ntext = \"No\"\nholds = \"1 > 2\"\n",
            "",
            &english!("lesson-options", least = 2, most = 8),
        ),
        (
            "holds = \"1 < 2\"",
            "holds = \"1 < 2\"\nright = true",
            english!("lesson-option-both"),
        ),
        (
            "controls = [\"material.kd\"]",
            "controls = []",
            "`controls`",
        ),
        (
            "probe = [0.1, 0.1]",
            "probe = [9.0, 0.1]",
            english!("lesson-far"),
        ),
        (
            "probe = [0.1, 0.1]",
            "probe = [0.1, 0.1]\nlights = 10000",
            "`lights`",
        ),
    ] {
        let error = problems(from, to);
        let changed = EVERY_KIND.replacen(from, to, 1);
        let at = EVERY_KIND.find(from).expect("there");
        let step = changed[..at].rfind("\n## ").expect("a step") + 1;
        let first = 1 + changed[..step].matches('\n').count() as u64;
        let length = changed[step + 3..].find("\n## ").map_or(99, |end| {
            changed[step..step + 3 + end].matches('\n').count()
        });
        let line = error.problems[0].line;
        assert!(
            (first..=first + length as u64).contains(&line),
            "{from} → {to}: {error}"
        );
        assert!(error.to_string().contains(words), "{from} → {to}: {error}");
    }
}

#[test]
fn files_that_are_no_lessons_are_refused() {
    let head = "+++\nlesson = 1\nname = \"a\"\ntitle = \"A\"\n+++\n";
    for (source, words) in [
        (String::new(), english!("lesson-no-head")),
        ("# A lesson".to_owned(), english!("lesson-no-head")),
        ("+++\nlesson = 1\n".to_owned(), english!("lesson-no-head")),
        (head.to_owned(), english!("lesson-no-steps")),
        (format!("{head}text\n"), english!("lesson-no-steps")),
        (
            format!("{head}```step\nscene = \"sphere\"\n```\n## A\n"),
            english!("lesson-block-outside"),
        ),
        (format!("{head}## A\n"), "`scene`"),
        (
            format!("{head}## A\n```step\nscene = \"sphere\"\n```\n```step\n```\n"),
            "`step`",
        ),
        (
            format!("{head}{}", "## A\n\n".repeat(Lesson::MAX_STEPS + 1)),
            "100",
        ),
        ("x".repeat(Lesson::MAX_TEXT + 1), "MiB"),
        (
            format!("{head}## A\n{{{{ 1 }}\n```step\nscene = \"sphere\"\n```\n"),
            english!("lesson-number-open"),
        ),
    ] {
        let error = Lesson::read(&source, None).expect_err("an error");
        assert!(error.to_string().contains(words), "{source:.60}: {error}");
    }
    // A byte order mark, carriage returns and blank lines before the head do no harm.
    let source = format!("\u{feff}\r\n{}", EVERY_KIND.replace('\n', "\r\n"));
    let read = Lesson::read(&source, None).expect("a lesson");
    assert_eq!(read.steps.len(), 13);
    assert_eq!(read.steps[0].line, 11);
}

#[test]
fn a_wrong_model_is_the_question_with_other_keys() {
    let source = [
        ("to = 1\nunit = \"m\"", "answer = \"1\""),
        (
            "find = \"least\"\nof = \"probe.position[0]^2 + probe.position[1]^2\"\ntolerance = 0.06",
            "at = [0.25, -0.5]",
        ),
        (
            "find = \"zero\"\nof = \"probe.position[0]\"\ntolerance = 0.04",
            "of = \"probe.position[1]\"",
        ),
        ("answer = \"cos(x)\"", "profile = \"flat\""),
        (
            "tolerance = 0.02\nprofile = \"phong\"",
            "set = [\"material.n=1\"]",
        ),
        ("equals = \"30\"\ntolerance = 1", "answer = \"15\""),
        ("most = true\ntolerance = 0.05", "least = true"),
        (
            "set = [\"material.kd=0.2\"]\ncontrols = [\"material.kd\"]",
            "set = [\"material.kd=0.7\"]",
        ),
        (
            "controls = [\"material.kd\", \"material.ks\"]",
            "set = [\"material.kd=0.1\"]",
        ),
    ];
    let source = source
        .iter()
        .fold(EVERY_KIND.to_owned(), |text, (after, key)| {
            assert!(text.contains(after), "{after}");
            let wrong = format!("{after}\n[[wrong]]\nsays = \"No: {{{{ 1 | 0 }}}}.\"\n{key}");
            text.replacen(after, &wrong, 1)
        });
    let source = source.replacen("text = \"No\"", "text = \"No\"\nsays = \"1 < 2.\"", 1);
    let lesson = Lesson::read(&source, None).unwrap_or_else(|error| panic!("{error}\n{source}"));
    let questions: Vec<_> = lesson
        .steps
        .iter()
        .filter_map(|step| step.question.as_ref())
        .collect();
    let wrong: Vec<_> = questions
        .iter()
        .flat_map(|question| &question.wrong)
        .collect();
    assert_eq!(wrong.len(), 9);
    let lines = source
        .lines()
        .enumerate()
        .filter(|(_, line)| line.contains("No: {{"));
    let lines: Vec<u64> = lines.map(|(index, _)| index as u64 + 1).collect();
    assert_eq!(
        wrong.iter().map(|wrong| wrong.line).collect::<Vec<_>>(),
        lines
    );
    assert!(
        matches!(&wrong[1].kind, Kind::Point(Point { find: Find::At(at), .. }) if at.to_array() == [0.25, -0.5])
    );
    // What is not given is that of the question.
    assert!(
        matches!(&wrong[2].kind, Kind::Point(Point { find: Find::Zero(_), tolerance }) if *tolerance == 0.04)
    );
    assert!(matches!(
        &wrong[3].kind,
        Kind::Curve(Curve {
            of: CurveOf::Profile(ShadingMode::Flat),
            ..
        })
    ));
    assert!(matches!(
        &wrong[4].kind,
        Kind::Curve(Curve {
            of: CurveOf::Profile(ShadingMode::Phong),
            ..
        })
    ));
    assert_eq!(wrong[4].set, ["material.n=1"]);
    assert!(matches!(
        &wrong[5].kind,
        Kind::Settings(Settings {
            goal: Goal::Value(_),
            ..
        })
    ));
    assert!(matches!(
        &wrong[6].kind,
        Kind::Settings(Settings {
            goal: Goal::Extreme(Extreme::Least),
            ..
        })
    ));
    assert_eq!(wrong[7].set, ["material.kd=0.2", "material.kd=0.7"]);
    assert!(matches!(
        &wrong[8].kind,
        Kind::Match(Match {
            values: MatchValues::Given,
            ..
        })
    ));
    let says = questions[0].says();
    assert_eq!([says[0].is_empty(), says[1].is_empty()], [true, false]);
    let without: Vec<usize> = (0..questions.len())
        .filter(|index| !questions[*index].knows_wrong())
        .collect();
    assert_eq!(
        without,
        [1, 9, 12],
        "choice by scenes, order and the formula have none"
    );
}

#[test]
fn a_wrong_model_that_is_none_is_refused_with_its_line() {
    let value = "to = 1\nunit = \"m\"";
    let point = "of = \"probe.position[0]\"\ntolerance = 0.04";
    let wrong = |key: &str| format!("[[wrong]]\nsays = \"No.\"\n{key}");
    let keys = |kind: &str| english!("lesson-wrong-keys", words = kind);
    for (after, added, words) in [
        (
            value,
            "[[wrong]]\nanswer = \"1\"".to_owned(),
            "says".to_owned(),
        ),
        (value, wrong(""), keys("answer, set")),
        (value, wrong("profile = \"flat\""), keys("answer, set")),
        (value, wrong("answers = \"1\""), "unknown field".to_owned()),
        (value, wrong("answer = \"1 +\""), "`answer`".to_owned()),
        (
            value,
            "[[wrong]]\nsays = \" \"\nanswer = \"1\"".to_owned(),
            "`says`".to_owned(),
        ),
        (
            value,
            "[[wrong]]\nsays = \"{{ 1\"\nanswer = \"1\"".to_owned(),
            english!("lesson-number-open").to_owned(),
        ),
        (
            point,
            wrong("at = [0, 9]"),
            english!("lesson-at").to_owned(),
        ),
        (
            point,
            wrong("at = [nan, 0]"),
            english!("lesson-at").to_owned(),
        ),
        (point, wrong("find = \"lowest\""), "`find`".to_owned()),
        (
            point,
            wrong("equals = \"1\""),
            keys("find, of, mode, at, set"),
        ),
        (
            "tolerance = 0.02\nprofile = \"phong\"",
            wrong("profile = \"smooth\""),
            "`profile`".to_owned(),
        ),
        (
            "equals = \"30\"\ntolerance = 1",
            wrong("most = true\nleast = true"),
            "`equals`".to_owned(),
        ),
        (
            "text = \"No\"\nholds = \"1 > 2\"",
            wrong("answer = \"1\""),
            english!("lesson-wrong-choice").to_owned(),
        ),
    ] {
        let error = problems(after, &format!("{after}\n{added}"));
        let first = 1 + EVERY_KIND[..EVERY_KIND.find(after).expect("there")]
            .matches('\n')
            .count();
        let first = first + after.matches('\n').count() + 1;
        let span = first as u64..=(first + added.matches('\n').count()) as u64;
        assert!(span.contains(&error.problems[0].line), "{added}: {error}");
        assert!(error.to_string().contains(&words), "{added}: {error}");
        assert_eq!(error.problems.len(), 1, "{added}: {error}");
    }
    let many = format!("{value}\n{}", wrong("answer = \"1\"\n").repeat(9));
    let error = problems(value, &many).to_string();
    assert!(
        error.contains(&english!("lesson-many-wrong", most = 8)),
        "{error}"
    );
}
