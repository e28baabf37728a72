//! Questions answered by the engine: each kind against closed forms or the output of commands, full marks for the right answer
//! and none for wrong ones.

use crate::common::lessons::EVERY_KIND;
use glam::DVec2;
use shading_lab::lesson::{
    Answer, AnswerKey, CURVE_POINTS, Grade, Lab, Lesson, Question, Solution, Staged, check,
};
use shading_lab::scene::Scene;
use std::process::Command;

struct Room {
    staged: Staged,
    lab: Lab,
    question: Question,
}

impl Room {
    fn of(lesson: &Lesson, step: usize) -> Self {
        let step = &lesson.steps[step];
        let staged = step.stage.load(None).expect("a scene");
        Self {
            lab: Lab::new(&staged),
            staged,
            question: step.question.clone().expect("a question"),
        }
    }

    /// Stages a sphere of radius 1 seen from (0, 0, 4), lit by one light.
    fn new(step: &str, question: &str) -> Self {
        let source = format!(
            "+++\nlesson = 1\nname = \"a\"\ntitle = \"A\"\n+++\n## A\n```step\nscene = \"sphere\"\nset = [\"camera.eye=[0,0,4]\", \"image.size=[192,192]\", \
             \"light.0.kind=directional\", \"light.0.color=[1,1,1]\", \"material.color=[1,1,1]\", {step}\n```\n```question\nask = \"?\"\n{question}\n```\n"
        );
        let lesson =
            Lesson::read(&source, None).unwrap_or_else(|error| panic!("{error}\n{source}"));
        Self::of(&lesson, 0)
    }

    fn solve(&self) -> Solution {
        let place = self.lab.place(&self.staged);
        self.question.solve(place, 1).expect("a solution")
    }

    fn key(&self) -> AnswerKey {
        let place = self.lab.place(&self.staged);
        self.question.solve_all(place, 1).expect("a solution")
    }

    fn refused(&self) -> String {
        let place = self.lab.place(&self.staged);
        self.question.solve(place, 1).expect_err("no solution")
    }

    fn grade(&self, answer: &Answer) -> Grade {
        let place = self.lab.place(&self.staged);
        let grade = self.question.grade(answer, &self.key(), place);
        grade.unwrap_or_else(|| panic!("{answer:?} cannot be graded"))
    }

    /// Checks that the right answer gets full marks and the wrong ones do not.
    fn marks(&self, wrong: &[Answer]) {
        let right = Answer::right(&self.solve());
        assert!(right.fits(&self.question.kind), "{right:?}");
        let grade = self.grade(&right);
        assert!(grade.right && grade.score == 1.0, "{right:?}: {grade:?}");
        for answer in wrong {
            assert!(answer.fits(&self.question.kind), "{answer:?}");
            let grade = self.grade(answer);
            assert!(!grade.right && grade.score < 1.0, "{answer:?}: {grade:?}");
        }
    }
}

#[test]
fn every_kind_is_sound() {
    let lesson = Lesson::read(EVERY_KIND, None).expect("a lesson");
    check(&lesson).expect("sound");
}

#[test]
fn an_answer_of_another_kind_is_not_graded() {
    let lesson = Lesson::read(EVERY_KIND, None).expect("a lesson");
    let rooms: Vec<Room> = (0..lesson.steps.len())
        .map(|step| Room::of(&lesson, step))
        .collect();
    let answers: Vec<Answer> = rooms
        .iter()
        .map(|room| Answer::right(&room.solve()))
        .collect();
    for room in &rooms {
        let place = room.lab.place(&room.staged);
        let key = room.key();
        for answer in &answers {
            let same = std::mem::discriminant(answer)
                == std::mem::discriminant(&Answer::right(&key.right));
            if !same {
                assert!(!answer.fits(&room.question.kind), "{answer:?}");
                assert_eq!(room.question.grade(answer, &key, place), None, "{answer:?}");
            }
        }
    }
}

#[test]
fn the_option_that_holds_is_right() {
    let options = "[[option]]\ntext = \"a\"\nholds = \"probe.lights[0].n_dot_l > 0.9\"\n[[option]]\ntext = \"b\"\nholds = \"probe.lights[0].n_dot_l <= 0.9\"";
    let question = format!("kind = \"choice\"\n{options}");
    // N is (0, 0, 1) at the middle.
    for (z, right) in [(-1.0, 0), (-0.5, 1)] {
        let step = format!("\"light.0.direction=[-0.866,0,{z}]\"]\nprobe = [0, 0]");
        let step = if right == 0 {
            step.replace("-0.866", "0")
        } else {
            step
        };
        let room = Room::new(&step, &question);
        assert_eq!(room.solve(), Solution::Choice(right));
        room.marks(&[Answer::Choice(1 - right)]);
    }
    let both = question.replace("<= 0.9", "> 0");
    let room = Room::new("\"light.0.direction=[0,0,-1]\"]\nprobe = [0, 0]", &both);
    assert!(
        room.refused()
            .contains(&english!("lesson-right-options", count = 2))
    );
}

#[test]
fn the_scene_with_the_greatest_value_is_right() {
    let option = |n: u32| format!("[[option]]\ntext = \"{n}\"\nset = [\"material.n={n}\"]\n");
    let options = [option(50), option(5), option(500)].concat();
    let step = "\"light.0.direction=[0,0,-1]\"]\nprobe = [0, 0]";
    let greatest = Room::new(
        step,
        &format!("kind = \"choice\"\ngreatest = \"half_width\"\n{options}"),
    );
    assert_eq!(greatest.solve(), Solution::Choice(1));
    let least = Room::new(
        step,
        &format!("kind = \"choice\"\nleast = \"half_width\"\n{options}"),
    );
    assert_eq!(least.solve(), Solution::Choice(2));
    least.marks(&[Answer::Choice(0), Answer::Choice(1)]);
    let alike = Room::new(
        step,
        &format!("kind = \"choice\"\ngreatest = \"1 + scene.material.n / 1e6\"\n{options}"),
    );
    assert!(alike.refused().contains("2 %"));
}

#[test]
fn a_value_is_that_of_the_probe() {
    let direction = "light.0.direction=[-0.6,0,-0.8]";
    let step = format!(
        "\"{direction}\", \"material.kd=0.5\", \"material.ks=0\", \"material.ka=0\"]\nprobe = [0.0026, 0.0026]"
    );
    let question =
        "kind = \"value\"\nanswer = \"probe.sum[0]\"\ntolerance = 0.05\nfrom = 0\nto = 2";
    let room = Room::new(&step, question);
    let Solution::Value(value) = room.solve() else {
        panic!("a value");
    };
    // I = Kd (N·L), N nearly (0, 0, 1).
    assert!((value - 0.4).abs() < 0.01, "{value}");
    room.marks(&[
        Answer::Value(value + 0.06),
        Answer::Value(value - 0.06),
        Answer::Value(2.0),
    ]);
    assert!(!Answer::Value(1e300).fits(&room.question.kind));
    assert!(room.grade(&Answer::Value(value + 0.049)).right);
    let half = room.grade(&Answer::Value(value + 0.075));
    assert!(!half.right && (half.score - 0.5).abs() < 1e-6, "{half:?}");

    // The same number as the command prints for the same scene.
    let settings = [
        "camera.eye=[0,0,4]",
        "image.size=[192,192]",
        "light.0.kind=directional",
        "light.0.color=[1,1,1]",
        "material.color=[1,1,1]",
        direction,
        "material.kd=0.5",
        "material.ks=0",
        "material.ka=0",
    ];
    let mut command = Command::new(env!("CARGO_BIN_EXE_shading-lab"));
    command.args(["probe", "sphere", "--pixel", "96,96", "--json"]);
    for setting in settings {
        command.args(["--set", setting]);
    }
    let output = command.output().expect("a run");
    let printed: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(printed["sum"][0].as_f64(), Some(value));

    let outside = Room::new(&step, &question.replace("to = 2", "to = 0.3"));
    assert!(outside.refused().contains("`from`"));
}

#[test]
fn a_place_is_where_the_closed_form_has_it() {
    // The nearest point of the sphere to the light's direction, in perspective: x / (4 − z) · f.
    let question =
        "kind = \"point\"\nfind = \"greatest\"\nof = \"probe.lights[0].n_dot_l\"\ntolerance = 0.06";
    let step = "\"light.0.direction=[-0.6,0,-0.8]\"]";
    let room = Room::new(step, question);
    let Solution::Point(places) = room.solve() else {
        panic!("places");
    };
    let scene: &Scene = &room.staged.scene;
    let half = (scene.camera.fov_y.to_radians() / 2.0).tan();
    let expected = DVec2::new(0.6 / (4.0 - 0.8) / (2.0 * half), 0.0);
    assert!(
        places[0].distance(expected) < 0.02,
        "{places:?}, {expected}"
    );
    let off = |x: f64, y: f64| Answer::Point([places[0].x + x, places[0].y + y]);
    room.marks(&[off(0.07, 0.0), off(0.0, -0.08), off(-0.3, 0.0)]);
    assert!(room.grade(&off(0.02, 0.02)).right);

    // The terminator of light from the right is where x = 0, anywhere.
    let question =
        "kind = \"point\"\nfind = \"zero\"\nof = \"probe.lights[0].n_dot_l\"\ntolerance = 0.03";
    let room = Room::new("\"light.0.direction=[-1,0,0]\"]", question);
    let Solution::Point(places) = room.solve() else {
        panic!("places");
    };
    assert!(
        places[0].length() < 0.02,
        "an end stands for all: {}",
        places[0]
    );
    for y in [-0.2, 0.0, 0.25] {
        assert!(room.grade(&Answer::Point([0.0, y])).right, "{y}");
    }
    room.marks(&[Answer::Point([0.1, 0.0]), Answer::Point([0.0, 0.49])]);

    // Light from the eye: no visible terminator.
    let room = Room::new(
        "\"light.0.direction=[0,0,-1]\"]",
        &question.replace("n_dot_l", "n_dot_l + 1"),
    );
    assert!(!room.refused().is_empty());
}

/// Returns the values of a right curve at the points that are compared.
fn compared(right: &Solution) -> Vec<f64> {
    match Answer::right(right) {
        Answer::Curve(points) => points.into_iter().flatten().collect(),
        _ => panic!("a curve"),
    }
}

#[test]
fn a_right_curve_is_drawn_as_it_is() {
    let curve = |answer: &str| {
        let question = format!("kind = \"curve\"\nx = [0, 90]\ny = [0, 1]\nanswer = \"{answer}\"");
        match Room::new("\"material.n=4\"]", &question).solve() {
            Solution::Curve(drawn) => drawn,
            _ => panic!("a curve"),
        }
    };
    // A jump is upright, wherever it is.
    let jump = curve("0.2 + 0.6*(x > 31.7)");
    let steep = jump.windows(2).filter(|pair| pair[0][1] != pair[1][1]);
    let steep: Vec<f64> = steep.map(|pair| pair[1][0] - pair[0][0]).collect();
    assert!(
        matches!(steep[..], [width] if width < 90.0 / 2000.0),
        "{steep:?}"
    );
    assert!(jump.len() < CURVE_POINTS + 12, "{} points", jump.len());
    // A narrow peak is smooth, and what is straight takes no more points.
    let peak = curve("exp(0 - ((x - 40)/2)^2)");
    for pair in peak.windows(2) {
        let [[a, low], [b, high]] = [pair[0], pair[1]];
        let middle = (-((0.5 * (a + b) - 40.0) / 2.0).powi(2)).exp();
        assert!((0.5 * (low + high) - middle).abs() < 0.004, "{a}");
    }
    assert_eq!(curve("x/90").len(), CURVE_POINTS);
}

#[test]
fn a_line_of_places_is_a_line_where_the_quantity_jumps() {
    let question = "kind = \"point\"\nfind = \"zero\"\nof = \"(probe.position[0]^2 + probe.position[1]^2 < 0.4) - 0.5\"\ntolerance = 0.02";
    let Solution::Point(places) = Room::new("\"material.n=4\"]", question).solve() else {
        panic!("places");
    };
    let radii = places.iter().map(|place| place.length());
    let [least, most] = radii.fold([f64::INFINITY, 0.0f64], |[least, most], radius| {
        [least.min(radius), most.max(radius)]
    });
    // A pixel is 1/192; the places that are tried are 1/49 apart.
    assert!(most - least < 0.012, "{least} to {most}");
}

#[test]
fn a_curve_is_compared_point_by_point() {
    let question = "kind = \"curve\"\nx = [0, 90]\ny = [0, 1]\nanswer = \"max(cos(x), 0)^scene.material.n\"\ntolerance = 0.1";
    let room = Room::new("\"material.n=4\"]", question);
    let solution = room.solve();
    let Solution::Curve(drawn) = &solution else {
        panic!("a curve");
    };
    for [x, y] in drawn {
        assert!((y - x.to_radians().cos().powi(4)).abs() < 1e-12, "{x}");
    }
    let curve = compared(&solution);
    assert_eq!(curve.len(), CURVE_POINTS);
    let moved = |by: f64| Answer::Curve(curve.iter().map(|y| Some(y + by)).collect());
    room.marks(&[
        moved(0.16),
        moved(-0.5),
        Answer::Curve(vec![Some(0.0); CURVE_POINTS]),
        Answer::Curve(vec![Some(1.0); CURVE_POINTS]),
    ]);
    assert!(room.grade(&moved(0.09)).right);
    // Small gaps are accepted; half a curve is not.
    let drawn = |count: usize| {
        let values = curve
            .iter()
            .enumerate()
            .map(|(index, y)| (index < count).then_some(*y));
        Answer::Curve(values.collect())
    };
    assert!(room.grade(&drawn(60)).right);
    let place = room.lab.place(&room.staged);
    assert_eq!(room.question.grade(&drawn(40), &room.key(), place), None);

    let flat = Room::new(
        "\"material.n=4\"]",
        &question.replace("^scene.material.n", "*0.01"),
    );
    assert!(flat.refused().contains(english!("lesson-curve-flat")));
}

#[test]
fn a_profile_is_that_of_the_command() {
    let question = "kind = \"curve\"\ny = [0, 1.5]\nprofile = \"gouraud\"\ntolerance = 0.05";
    let step = "\"light.0.direction=[-0.6,0,-0.8]\"]\nline = [-0.25, 0, 0.25, 0]";
    let room = Room::new(step, question);
    let curve = compared(&room.solve());
    let mut command = Command::new(env!("CARGO_BIN_EXE_shading-lab"));
    command.args([
        "profile", "sphere", "--from", "48,96", "--to", "144,96", "--modes", "gouraud", "--json",
    ]);
    for setting in [
        "camera.eye=[0,0,4]",
        "image.size=[192,192]",
        "light.0.kind=directional",
        "light.0.color=[1,1,1]",
        "material.color=[1,1,1]",
        "light.0.direction=[-0.6,0,-0.8]",
    ] {
        command.args(["--set", setting]);
    }
    let output = command.output().expect("a run");
    let printed: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let samples = printed["samples"].as_array().expect("samples");
    for sample in samples {
        let [t, value] = ["t", "gouraud"].map(|key| sample[key].as_f64().unwrap_or(f64::NAN));
        let at = t * (CURVE_POINTS - 1) as f64;
        let (below, above) = (
            curve[at.floor() as usize],
            curve[(at.ceil() as usize).min(CURVE_POINTS - 1)],
        );
        let expected = below + (above - below) * at.fract();
        assert!((value - expected).abs() < 0.02, "{t}: {value}, {expected}");
    }
}

#[test]
fn a_setting_is_found_where_the_closed_form_has_it() {
    // cosⁿφ = 1/2 at φ = 10°.
    let question = "kind = \"settings\"\ncontrol = \"material.n\"\nreach = \"half_width\"\nequals = \"10\"\ntolerance = 0.5";
    let room = Room::new("\"material.n=5\"]", question);
    let Solution::Settings(n) = room.solve() else {
        panic!("a setting");
    };
    let expected = 0.5f64.ln() / 10f64.to_radians().cos().ln();
    assert!((n - expected).abs() < 0.1, "{n}, {expected}");
    room.marks(&[Answer::Settings(20.0), Answer::Settings(100.0)]);
    assert!(room.grade(&Answer::Settings(45.0)).right);

    // x − x² has its maximum at one half.
    let question = "kind = \"settings\"\ncontrol = \"material.kd\"\nreach = \"scene.material.kd - scene.material.kd^2\"\nmost = true\ntolerance = 0.05";
    let room = Room::new("\"material.kd=0.1\"]", question);
    let Solution::Settings(kd) = room.solve() else {
        panic!("a setting");
    };
    assert!((kd - 0.5).abs() < 1e-3, "{kd}");
    room.marks(&[Answer::Settings(0.44), Answer::Settings(1.0)]);
    let unreachable = Room::new(
        "\"material.kd=0.1\"]",
        "kind = \"settings\"\ncontrol = \"material.kd\"\nreach = \"scene.material.kd\"\nequals = \"7\"\ntolerance = 0.1",
    );
    assert!(
        unreachable
            .refused()
            .contains(&english!("lesson-settings-many", count = 0))
    );
}

#[test]
fn items_are_sorted_by_the_expression() {
    let item = |n: u32| format!("[[item]]\ntext = \"{n}\"\nset = [\"material.n={n}\"]\n");
    let items = [item(50), item(5), item(500), item(15)].concat();
    let room = Room::new(
        "\"material.n=1\"]",
        &format!("kind = \"order\"\nby = \"half_width\"\n{items}"),
    );
    assert_eq!(room.solve(), Solution::Order(vec![2, 0, 3, 1]));
    room.marks(&[
        Answer::Order(vec![1, 3, 0, 2]),
        Answer::Order(vec![0, 2, 3, 1]),
    ]);
    // One of six pairs is the wrong way round.
    let grade = room.grade(&Answer::Order(vec![0, 2, 3, 1]));
    assert!((grade.score - 5.0 / 6.0).abs() < 1e-9, "{grade:?}");
    for unfit in [vec![0, 1, 2], vec![0, 0, 1, 2], vec![0, 1, 2, 9]] {
        assert!(!Answer::Order(unfit).fits(&room.question.kind));
    }
}

#[test]
fn a_target_is_met_by_a_picture_that_looks_the_same() {
    let question = "kind = \"match\"\nset = [\"material.kd=0.3\"]\ncontrols = [\"material.kd\"]\ntolerance = 0.02";
    let room = Room::new(
        "\"light.0.direction=[0,0,-1]\", \"material.kd=0.8\", \"material.ks=0\"]",
        question,
    );
    assert_eq!(room.solve(), Solution::Match(vec![0.3]));
    room.marks(&[Answer::Match(vec![0.8]), Answer::Match(vec![0.1])]);
    assert!(room.grade(&Answer::Match(vec![0.31])).right);
    // The root mean square over the picture is proportional to the difference of Kd.
    let off = |kd: f64| {
        room.grade(&Answer::Match(vec![kd]))
            .off
            .expect("a difference")
    };
    assert!((off(0.5) / off(0.4) - 2.0).abs() < 1e-3);

    let random = Room::new(
        "\"material.kd=0.8\"]",
        "kind = \"match\"\ncontrols = [\"material.kd\", \"material.ks\"]",
    );
    let solved = |seed: u64| {
        random
            .question
            .solve(random.lab.place(&random.staged), seed)
            .expect("a target")
    };
    assert_eq!(solved(3), solved(3));
    assert_ne!(solved(3), solved(4));
}

#[test]
fn a_pane_is_called_as_its_step_says() {
    let step = "\"compare.name=Cook–Torrance\"]\npanes = [\"reflection.model=blinn; compare.name=Blinn, n = 30\", \"shading.mode=flat\"";
    let room = Room::new(
        &format!("{step}]"),
        "kind = \"value\"\nanswer = \"scene.material.n\"\ntolerance = 1\nfrom = 0\nto = 100",
    );
    let names = [0, 1, 2].map(|pane| room.staged.scene.pane_name(pane));
    assert_eq!(names[..2], ["Cook–Torrance", "Blinn, n = 30"]);
    assert!(names[2].starts_with("Flat"), "{names:?}");
    assert_eq!(
        room.staged.scene.compare.panes[0].set,
        ["reflection.model=blinn"]
    );
}

/// Returns the feedback to an answer, with the question's own words.
fn feedback(room: &Room, answer: &Answer) -> String {
    let place = room.lab.place(&room.staged);
    let says = room.question.says().into_iter();
    let says: Vec<String> = says
        .map(|prose| prose.filled(&place).expect("a text"))
        .collect();
    let names = room.question.names().into_iter();
    let names: Vec<String> = names
        .map(|prose| prose.filled(&place).expect("a text"))
        .collect();
    let grade = room.grade(answer);
    room.question
        .feedback(&grade, &says, &names)
        .unwrap_or_default()
}

#[test]
fn an_answer_nearer_to_a_wrong_model_is_not_right() {
    let question = "kind = \"value\"\nanswer = \"1/9\"\ntolerance = 0.1\nfrom = 0\nto = 1\n\
        [[wrong]]\nanswer = \"1/3\"\nsays = \"Linear.\"\n[[wrong]]\nanswer = \"1/27\"\nsays = \"Cubic {{ 1/27 | 2 }}.\"";
    let room = Room::new("\"material.n=4\"]", question);
    let verdict = |value: f64| {
        let grade = room.grade(&Answer::Value(value));
        (grade.right, grade.model)
    };
    assert_eq!(verdict(1.0 / 9.0), (true, None));
    // Within the tolerance, on either side of half-way to 1/27.
    assert_eq!(verdict(0.075), (true, None));
    assert_eq!(verdict(0.073), (false, Some(1)));
    assert_eq!(room.grade(&Answer::Value(0.073)).score, 0.0);
    // Beyond the tolerance of every model, however near to one of them.
    assert_eq!(verdict(0.44), (false, None));
    assert_eq!(feedback(&room, &Answer::Value(0.3)), "Linear.");
    assert_eq!(feedback(&room, &Answer::Value(0.03)), "Cubic 0.04.");
    assert_eq!(
        feedback(&room, &Answer::Value(0.44)),
        english!("lesson-hint-high")
    );
    assert_eq!(feedback(&room, &Answer::Value(1.0 / 9.0)), "");
}

#[test]
fn each_kind_says_where_an_answer_is_off() {
    let angle = "kind = \"curve\"\nx = [0, 90]\ny = [0, 1]\nunit = \"°\"\nanswer = \"cos(x)\"";
    let room = Room::new("\"material.n=4\"]", angle);
    let curve = |of: fn(f64) -> f64| {
        let points = (0..CURVE_POINTS).map(|index| {
            let x = 90.0 * index as f64 / (CURVE_POINTS - 1) as f64;
            Some(of(x))
        });
        Answer::Curve(points.collect())
    };
    let cos = |x: f64| x.to_radians().cos();
    for (of, words) in [
        (
            (|x| 0.5 + 0.5 * x.to_radians().cos()) as fn(f64) -> f64,
            "Too high beyond",
        ),
        (|_| 0.9, "Too high beyond"),
        (|x| x.to_radians().cos() - 0.25, "Too low everywhere"),
        (
            |x| if x < 45.0 { 0.5 } else { x.to_radians().cos() },
            "Too low up to",
        ),
    ] {
        let words_given = feedback(&room, &curve(of));
        assert!(words_given.starts_with(words), "{words}: {words_given}");
        assert!(
            words.ends_with("everywhere") || words_given.ends_with("°."),
            "{words_given}"
        );
    }
    let wave = feedback(
        &room,
        &curve(|x| x.to_radians().cos() + 0.08 * (12.0 * x).to_radians().sin()),
    );
    assert!(wave.contains("slope") || wave.contains("steep"), "{wave}");
    assert!(room.grade(&curve(|x| x.to_radians().cos() + 0.02)).right);
    assert!(
        room.grade(&Answer::Curve(
            (0..CURVE_POINTS)
                .map(|index| Some(cos(90.0 * index as f64 / 64.0)))
                .collect()
        ))
        .right
    );

    let place = "kind = \"point\"\nfind = \"greatest\"\nof = \"1 - length(probe.position)\"\ntolerance = 0.03";
    let place = place.replace(
        "length(probe.position)",
        "abs(probe.position[0]) - abs(probe.position[1])",
    );
    let room = Room::new("\"light.0.direction=[0,0,-1]\"]", &place);
    let far = feedback(&room, &Answer::Point([0.2, 0.0]));
    assert!(far.starts_with(english!("lesson-hint-out")), "{far}");
    assert!(far.contains("of its maximum"), "{far}");
    assert_eq!(
        feedback(&room, &Answer::Point([0.49, 0.49])),
        english!("lesson-hint-beside")
    );

    let line =
        "kind = \"point\"\nfind = \"zero\"\nof = \"probe.position[0] - 0.3\"\ntolerance = 0.03";
    let room = Room::new("\"light.0.direction=[0,0,-1]\"]", line);
    assert_eq!(
        feedback(&room, &Answer::Point([-0.2, 0.2])),
        english!("lesson-hint-left")
    );

    let item = |n: u32| format!("[[item]]\ntext = \"n is {n}\"\nset = [\"material.n={n}\"]\n");
    let items = [item(5), item(50), item(500)].concat();
    let room = Room::new(
        "\"material.n=1\"]",
        &format!("kind = \"order\"\nby = \"scene.material.n\"\n{items}"),
    );
    let moved = feedback(&room, &Answer::Order(vec![1, 2, 0]));
    assert_eq!(
        moved,
        english!("lesson-hint-late", item = "n is 5", places = 2)
    );
    let score = room.grade(&Answer::Order(vec![1, 0, 2])).score;
    assert!((score - 2.0 / 3.0).abs() < 1e-12, "{score}");

    let setting = "kind = \"settings\"\ncontrol = \"material.n\"\nreach = \"half_width\"\nequals = \"10\"\ntolerance = 0.5\n\
        [[wrong]]\nequals = \"5\"\nsays = \"Whole.\"\n[[wrong]]\nanswer = \"10\"\nsays = \"Degrees.\"";
    let room = Room::new("\"material.n=5\"]", setting);
    assert_eq!(feedback(&room, &Answer::Settings(10.0)), "Degrees.");
    assert_eq!(feedback(&room, &Answer::Settings(182.0)), "Whole.");
    assert_eq!(
        feedback(&room, &Answer::Settings(600.0)),
        english!("lesson-hint-control-high", name = "n")
    );
}

#[test]
fn check_refuses_wrong_models_that_cannot_be_told_apart() {
    let lesson = |wrong: &str| {
        let source = format!(
            "+++\nlesson = 1\nname = \"a\"\ntitle = \"A\"\n+++\n## A\n```step\nscene = \"sphere\"\n```\n```question\nask = \"?\"\n\
             kind = \"value\"\nanswer = \"0.5\"\ntolerance = 0.1\nfrom = 0\nto = 1\n{wrong}```\n"
        );
        check(&Lesson::read(&source, None).expect("a lesson"))
    };
    let wrong = |answer: &str| format!("[[wrong]]\nsays = \"No.\"\nanswer = \"{answer}\"\n");
    let remarks = lesson(&wrong("0.7")).expect("sound");
    assert_eq!(remarks.len(), 1);
    assert_eq!(
        (remarks[0].line, &*remarks[0].words),
        (18, &*english!("lesson-apart", number = 1, apart = "2.0"))
    );
    let none = lesson("").expect("sound");
    assert_eq!(none[0].words, english!("lesson-no-wrong"));
    for (wrongs, words) in [
        (
            wrong("0.5"),
            english!("lesson-wrong-near", apart = "0.00", least = "0.5"),
        ),
        (
            wrong("0.54"),
            english!("lesson-wrong-near", apart = "0.40", least = "0.5"),
        ),
        (
            wrong("1.5"),
            english!("lesson-wrong-value-outside", value = "1.5000"),
        ),
        (
            [wrong("0.7"), wrong("0.7")].concat(),
            english!("lesson-wrong-same", other = 1),
        ),
        (wrong("scene.nothing"), "scene.nothing".to_owned()),
        (
            "[[wrong]]\nanswer = \"0.7\"\nsays = \"{{ scene.nothing }}\"\n".to_owned(),
            "scene.nothing".to_owned(),
        ),
    ] {
        let error = lesson(&wrongs).expect_err("refused").to_string();
        assert!(error.contains(&words), "{wrongs}: {error}");
    }
}
