//! The questions of the course know what went wrong: right answers get full marks, the answer of each wrong model gets none and is
//! named, and a hand that trembles changes neither.

use crate::common::dice::Dice;
use rayon::prelude::*;
use shading_lab::lesson::{
    Answer, AnswerKey, Kind, LESSONS, Lab, LabPlace, Question, Solution, Staged, Step,
};
use shading_lab::text::{Language, in_language};

/// The standard deviation of a hand, as a fraction of the axis' height, and how often each curve is drawn.
const TREMBLE: f64 = 0.03;
const DRAWN: usize = 300;
/// The least share of drawings that must be graded as they should be.
const GRADED: f64 = 0.99;

/// A question of the course with its answers.
struct SolvedQuestion {
    what: String,
    question: Question,
    staged: Staged,
    lab: Lab,
    key: AnswerKey,
}

impl SolvedQuestion {
    fn place(&self) -> LabPlace<'_> {
        self.lab.place(&self.staged)
    }

    /// Returns whether an answer is right, and the wrong model that it agrees with.
    fn verdict(&self, answer: &Answer) -> (bool, Option<usize>) {
        let grade = self.question.grade(answer, &self.key, self.place());
        let grade = grade.unwrap_or_else(|| panic!("{}: {answer:?} is not graded", self.what));
        let full = if grade.right {
            grade.score > 0.999
        } else {
            grade.score < 1.0
        };
        assert!(full, "{}: {grade:?}", self.what);
        assert!(
            grade.model.is_none() || grade.score == 0.0,
            "{}: {grade:?}",
            self.what
        );
        (grade.right, grade.model)
    }

    /// Returns the answers of the wrong models, each with the model's number.
    fn wrong(&self) -> Vec<(usize, Answer)> {
        if let Kind::Choice(choice) = &self.question.kind {
            let options = choice.options.iter().enumerate();
            let named = options.filter(|(_, option)| !option.says.is_empty());
            return named
                .map(|(index, _)| (index, Answer::Choice(index)))
                .collect();
        }
        let wrong = self.key.wrong.iter().enumerate();
        wrong
            .map(|(index, wrong)| (index, Answer::right(wrong)))
            .collect()
    }
}

/// Solves the questions of the course in a language and looks at each.
fn course<T: Send>(language: Language, look: impl Fn(&SolvedQuestion) -> T + Sync) -> Vec<T> {
    let steps: Vec<(String, Step)> = LESSONS
        .iter()
        .flat_map(|built_in| {
            let steps = built_in.lesson_in(language).steps.into_iter().enumerate();
            steps.map(|(index, step)| (format!("{}/{}", built_in.name, index + 1), step))
        })
        .collect();
    let looked = |(what, step): (String, Step)| {
        let question = step.question?;
        let staged = step.stage.load(None).expect("a scene");
        let lab = Lab::new(&staged);
        let key = question.solve_all(lab.place(&staged), 7);
        let key = key.unwrap_or_else(|error| panic!("{what}: {error}"));
        Some(look(&SolvedQuestion {
            what,
            question,
            staged,
            lab,
            key,
        }))
    };
    // In threads of their own, or the other tests of this program would wait for those.
    let threads = rayon::ThreadPoolBuilder::new().build().expect("threads");
    threads.install(|| steps.into_par_iter().filter_map(looked).collect())
}

#[test]
fn right_answers_get_full_marks_and_wrong_models_none() {
    for language in Language::ALL {
        let looked = course(language, |asked| {
            let right = asked.verdict(&Answer::right(&asked.key.right));
            assert_eq!(right, (true, None), "{}", asked.what);
            for (model, answer) in asked.wrong() {
                let verdict = asked.verdict(&answer);
                assert_eq!(verdict, (false, Some(model)), "{}", asked.what);
                named(asked, language, model, &answer);
            }
            lines(asked);
            let whole = match &asked.question.kind {
                // Each wrong option is a misconception of its own.
                Kind::Choice(choice) => asked.wrong().len() + 1 == choice.options.len(),
                _ => asked.question.knows_wrong(),
            };
            (asked.what.clone(), whole, drawn_by_hand(asked))
        });
        let without = looked.iter().filter(|(_, whole, _)| !whole);
        let without: Vec<&str> = without.map(|(what, ..)| &**what).collect();
        assert!(
            without.is_empty(),
            "{language:?}: without a wrong model: {without:?}"
        );
        let rows: Vec<&(String, bool)> = looked.iter().flat_map(|(.., rows)| rows).collect();
        println!("of {DRAWN} drawings each, graded as they should be:");
        for (row, _) in &rows {
            println!("{row}");
        }
        let failed = rows.iter().filter(|(_, good)| !good);
        let failed: Vec<&str> = failed.map(|(row, _)| &**row).collect();
        assert!(rows.len() >= 21 && failed.is_empty(), "{failed:#?}");
    }
}

/// Checks that the feedback to the answer of a wrong model is what that says.
fn named(asked: &SolvedQuestion, language: Language, model: usize, answer: &Answer) {
    let (question, place) = (&asked.question, asked.place());
    let says = question.says().into_iter();
    let says: Vec<String> = says
        .map(|prose| prose.filled(&place).expect("a sentence"))
        .collect();
    let grade = question.grade(answer, &asked.key, place).expect("a grade");
    let feedback = in_language(language, || question.feedback(&grade, &says, &[]));
    assert_eq!(feedback.as_deref(), Some(&*says[model]), "{}", asked.what);
    assert!(says[model].trim().len() > 10, "{}: {says:?}", asked.what);
}

/// Checks a wrong model of a point that is a line: none of its places is right, unless it lies on the right one as well.
fn lines(asked: &SolvedQuestion) {
    let Solution::Point(right) = &asked.key.right else {
        return;
    };
    for wrong in &asked.key.wrong {
        let Solution::Point(wrong) = wrong else {
            continue;
        };
        for place in wrong {
            let near = right.iter().any(|right| right.distance(*place) < 1e-6);
            let (is_right, _) = asked.verdict(&Answer::Point(place.to_array()));
            assert!(!is_right || near, "{}: {place} is right", asked.what);
        }
    }
}

/// How a hand departs from the curve that it means to draw.
#[derive(Clone, Copy, Debug)]
enum Hand {
    /// Each point on its own.
    Trembles,
    /// Slowly: bows of about a quarter of the width, which are nearly another curve.
    Drifts,
    /// Both, as much in all.
    Both,
}

impl Hand {
    const ALL: [Self; 3] = [Self::Trembles, Self::Drifts, Self::Both];

    /// Draws a curve over axes of the given height.
    fn draw(self, curve: &[f64], [low, high]: [f64; 2], dice: &mut Dice) -> Answer {
        let share = match self {
            Self::Trembles => [1.0, 0.0],
            Self::Drifts => [0.0, 1.0],
            Self::Both => [0.5f64.sqrt(); 2],
        };
        let knots: Vec<f64> = (0..=KNOTS).map(|_| normal(dice)).collect();
        let drawn = curve.iter().enumerate().map(|(index, y)| {
            let along = (index * KNOTS) as f64 / (curve.len() - 1) as f64;
            let (before, rest) = (along.floor() as usize, along.fract());
            let after = (before + 1).min(KNOTS);
            // Weights whose squares add up to 1: the same deviation everywhere.
            let (sin, cos) = (rest * std::f64::consts::FRAC_PI_2).sin_cos();
            let drift = cos * knots[before] + sin * knots[after];
            let off = share[0] * normal(dice) + share[1] * drift;
            Some((y + TREMBLE * (high - low) * off).clamp(low, high))
        });
        Answer::Curve(drawn.collect())
    }
}

/// The bows of a drifting hand.
const KNOTS: usize = 4;

/// Returns a number of the standard normal distribution, by the polar form of Box and Muller.
fn normal(dice: &mut Dice) -> f64 {
    loop {
        let [u, v] = [(); 2].map(|()| 2.0 * dice.unit() - 1.0);
        let square = u * u + v * v;
        if square > 0.0 && square < 1.0 {
            return u * (-2.0 * square.ln() / square).sqrt();
        }
    }
}

/// Draws the right curve and those of the wrong models, and returns for each how often it is graded as it should be, and
/// whether that suffices.
fn drawn_by_hand(asked: &SolvedQuestion) -> Vec<(String, bool)> {
    let Kind::Curve(kind) = &asked.question.kind else {
        return Vec::new();
    };
    let models = std::iter::once(&asked.key.right).chain(&asked.key.wrong);
    let models = models.filter_map(|model| match Answer::right(model) {
        Answer::Curve(points) => Some(points.into_iter().flatten().collect()),
        _ => None,
    });
    let row = |(model, curve): (usize, Vec<f64>)| {
        let mut dice = Dice(model as u64 + 1);
        let shares = Hand::ALL.map(|hand| {
            let good = (0..DRAWN).filter(|_| {
                let answer = hand.draw(&curve, kind.y, &mut dice);
                asked.verdict(&answer).0 == (model == 0)
            });
            good.count() as f64 / DRAWN as f64
        });
        let off = asked.question.grade(
            &Answer::Curve(curve.iter().copied().map(Some).collect()),
            &asked.key,
            asked.place(),
        );
        let off = off.and_then(|grade| grade.off).unwrap_or_default();
        let name = if model == 0 {
            "right".to_owned()
        } else {
            format!("wrong {model}")
        };
        let percent = shares
            .map(|share| format!("{:6.1} %", 100.0 * share))
            .concat();
        let good = shares.iter().all(|share| *share >= GRADED);
        (
            format!("{:28} {name:8} off {off:.3} {percent}", asked.what),
            good,
        )
    };
    models.enumerate().map(row).collect()
}
