//! A rehearsed class: simulated students, whose errors are those of the lesson's own wrong models.
//!
//! Each student has a probability of being right, and a wrong model otherwise. In a later round who was right mostly stays so, and half of
//! the others are convinced by a neighbour, as in the classes that Mazur (1997) reports.

use super::content::StepContent;
use super::room::{AnswerRequest, Room};
use super::tokens::Token;
use crate::bits::SplitMix64;
use crate::lesson::{Answer, CURVE_POINTS, Kind, Lesson, Pace, Phase};
use crate::text::{in_language, text};
use std::f64::consts::TAU;
use std::sync::{Arc, Weak};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The time between two looks at where the class is.
const TICK: Duration = Duration::from_millis(50);
/// The time until the first students answer, and that within which most others do, in seconds.
const FIRST: f64 = 1.0;
const MOST: f64 = 8.0;
/// The fraction of students who do not answer in a round.
const SILENT: f64 = 0.06;
/// The probabilities that who was right stays so after a talk, and that who was wrong is convinced.
const STAYS: f64 = 0.95;
const CONVINCED: f64 = 0.55;

/// Numbers that look random.
struct Random(SplitMix64);

impl Random {
    /// Returns a number from 0 to 1.
    fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count.saturating_sub(1))
    }

    /// Returns a number from −1 to 1.
    fn around(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }
}

/// A student's belief about a question.
#[derive(Clone, Copy)]
enum Belief {
    Right,
    /// A wrong model, as a fraction of their list in thousandths, or a mistake if there is none.
    Wrong(usize),
}

struct Simulated {
    token: Token,
    /// The probability of being right at first, before the step is known.
    ability: f64,
    belief: Option<(usize, Belief)>,
    /// The time at which the next answer is due; `None` if it is given, or none will be.
    due: Option<Instant>,
}

/// Lets simulated students join a class and answer its questions, until it is over.
pub fn rehearse(room: &Arc<Room>, count: usize, seed: u64) {
    let (weak, language) = (Arc::downgrade(room), room.head().language);
    let random = Random(SplitMix64(seed));
    std::thread::spawn(move || in_language(language, || run(&weak, count, random)));
}

fn run(room: &Weak<Room>, count: usize, mut random: Random) {
    let mut students: Vec<Simulated> = Vec::new();
    // Those of a rehearsal that is gone on with.
    let mut known = room.upgrade().map(|room| room.tokens()).unwrap_or_default();
    known.truncate(count);
    let mut known = known.into_iter();
    let mut at: Option<Pace> = None;
    while let Some(room) = room.upgrade() {
        if students.len() < count {
            let name = text!("live-rehearsed", number = students.len() + 1);
            let token = room.join(known.next(), Some(&name));
            if let Ok(token) = token
                && room.enter(token).is_ok()
            {
                students.push(Simulated {
                    token,
                    ability: random.unit(),
                    belief: None,
                    due: Some(due(&mut random)),
                });
            }
        }
        let now = room.pace();
        if at != Some(now) {
            at = Some(now);
            for student in &mut students {
                let answers = random.unit() >= SILENT;
                student.due = answers.then(|| due(&mut random));
            }
        }
        if let Some(Ok(content)) = room.step(now.step)
            && now.phase == Phase::Ask
        {
            for student in &mut students {
                student.answer(&room, &content, now, &mut random);
            }
        }
        drop(room);
        sleep(TICK);
    }
}

/// Returns the time at which an answer is given: most come soon, some late.
fn due(random: &mut Random) -> Instant {
    let late = FIRST - MOST * (1.0 - random.unit()).max(0.02).ln() / 3.0;
    Instant::now() + Duration::from_secs_f64(late)
}

impl Simulated {
    /// Answers if it is time.
    fn answer(&mut self, room: &Room, content: &StepContent, now: Pace, random: &mut Random) {
        if self.due.is_none_or(|due| due > Instant::now()) {
            return;
        }
        self.due = None;
        let belief = self.believe(now, random);
        let Some(answer) = answer(room.lesson(), content, belief, random) else {
            return;
        };
        let request = AnswerRequest {
            step: now.step,
            round: now.round,
            answer,
            sent: 0,
        };
        // The class may have gone on at this moment.
        drop(room.answer(self.token, request));
    }

    /// Decides what the student believes.
    fn believe(&mut self, now: Pace, random: &mut Random) -> Belief {
        let before = self.belief.filter(|(step, _)| *step == now.step);
        let right = match before {
            None => 0.2 + 0.5 * self.ability,
            Some((_, Belief::Right)) => STAYS,
            Some((_, Belief::Wrong(_))) => CONVINCED,
        };
        let belief = match before {
            _ if random.unit() < right => Belief::Right,
            Some((_, Belief::Wrong(model))) => Belief::Wrong(model),
            // The first models of a lesson are the most frequent ones.
            _ => Belief::Wrong((random.unit() * random.unit() * 1000.0) as usize),
        };
        self.belief = Some((now.step, belief));
        belief
    }
}

/// Returns the answer that a belief leads to; `None` if the step asks nothing.
fn answer(
    lesson: &Lesson,
    content: &StepContent,
    belief: Belief,
    random: &mut Random,
) -> Option<Answer> {
    let asked = content.asked.as_ref()?;
    let (kind, key) = (&asked.question(lesson)?.kind, asked.key.as_ref()?);
    let right = Answer::right(&key.right);
    let models = &key.wrong;
    let (answer, noise) = match (belief, kind, &right) {
        (Belief::Right, ..) => (right.clone(), 0.5),
        // The wrong models of a choice are its options.
        (Belief::Wrong(model), Kind::Choice(choice), Answer::Choice(right)) => {
            let others = choice.options.len().saturating_sub(1).max(1);
            let other = model * others / 1000;
            (Answer::Choice(other + usize::from(other >= *right)), 0.0)
        }
        (Belief::Wrong(model), ..) if !models.is_empty() => {
            let model = model * models.len() / 1000;
            (Answer::right(&models[model.min(models.len() - 1)]), 0.5)
        }
        // A mistake of no kind: several tolerances off.
        (Belief::Wrong(_), ..) => (right.clone(), 5.0),
    };
    let noisy = noisy(answer.clone(), kind, noise, random);
    [noisy, answer, right]
        .into_iter()
        .find(|answer| answer.fits(kind))
}

/// Adds the imprecision of a hand to an answer: `noise` in tolerances.
fn noisy(answer: Answer, kind: &Kind, noise: f64, random: &mut Random) -> Answer {
    match (answer, kind) {
        (Answer::Value(value), Kind::Value(asked)) => {
            Answer::Value(value + noise * asked.tolerance * random.around())
        }
        (Answer::Point(place), Kind::Point(asked)) => {
            Answer::Point(place.map(|x| x + noise * asked.tolerance * random.around() * 0.7))
        }
        (Answer::Curve(points), Kind::Curve(asked)) => {
            let [low, high] = asked.y;
            let size = 0.6 * noise * asked.tolerance * (high - low);
            let (phase, waves) = (random.unit(), 1.0 + 2.0 * random.unit());
            let drawn = points.into_iter().enumerate().map(|(index, y)| {
                let x = index as f64 / (CURVE_POINTS - 1) as f64;
                let wave = (TAU * (phase + waves * x)).sin() + 0.2 * random.around();
                Some((y? + size * wave).clamp(low, high))
            });
            Answer::Curve(drawn.collect())
        }
        (Answer::Order(mut order), _) if noise > 1.0 && order.len() > 1 => {
            let at = random.below(order.len() - 1);
            order.swap(at, at + 1);
            Answer::Order(order)
        }
        (Answer::Settings(value), _) => {
            Answer::Settings(value * (1.0 + 0.02 * noise * random.around()))
        }
        (Answer::Match(values), _) => {
            let near = values
                .into_iter()
                .map(|value| value * (1.0 + 0.02 * noise * random.around()));
            Answer::Match(near.collect())
        }
        (answer, _) => answer,
    }
}
