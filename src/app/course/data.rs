//! What the window remembers of the course: the lesson that is open, and what was answered.

use super::glide::Glide;
use super::kinds::{Widget, widget_of};
use super::marking::HandedIn;
use super::work::{Prepare, Prepared};
use crate::app::session::appearance::Overlays;
use crate::app::session::document::CoursePart;
use crate::jobs::Background;
use crate::lesson::{
    Answer, Answered, Grade, LESSONS, Lab, Lesson, Question, Record, Solution, Staged, Step,
    are_there, find,
};
use crate::scene::Scene;
use crate::text::{Language, language, text};
use egui_commonmark::CommonMarkCache;
use glam::DVec2;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Most lessons whose answers are kept.
const RECORDS: usize = 200;

/// The course in the window.
pub struct Course {
    /// The lesson that is open.
    pub open: Option<Open>,
    /// A lesson from a file, first in the list.
    pub own: Option<Arc<Lesson>>,
    /// The answers that the document was handed in with.
    pub handed_in: Option<HandedIn>,
    /// What is kept between two sessions.
    pub kept: SavedProgress,
    /// Decides what is drawn at random.
    pub seed: u64,
    /// The lessons of the program as the list shows them.
    pub list: Option<(Language, Vec<Listed>)>,
    /// How many lessons were opened so far.
    pub openings: u64,
    /// The way to the scene of a step.
    pub gliding: Option<Glide>,
}

impl Default for Course {
    fn default() -> Self {
        Self {
            open: None,
            own: None,
            handed_in: None,
            kept: SavedProgress::default(),
            seed: 1,
            list: None,
            openings: 0,
            gliding: None,
        }
    }
}

/// What is kept between two sessions.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedProgress {
    /// The answers, a record a lesson, the latest last.
    pub records: Vec<Record>,
    /// The lessons that were gone through to their ends.
    pub done: BTreeSet<String>,
    /// By whom answers were last handed in.
    pub name: String,
    /// The step that each was left at.
    pub left: BTreeMap<String, usize>,
}

/// A lesson in the list.
#[derive(Clone, Debug)]
pub struct Listed {
    pub name: String,
    pub title: String,
    pub topic: String,
    pub minutes: u32,
    pub about: String,
}

impl Listed {
    pub fn of(lesson: &Lesson) -> Self {
        Self {
            name: lesson.name.clone(),
            title: lesson.title.clone(),
            topic: lesson.topic.clone(),
            minutes: lesson.minutes,
            about: lesson.about.clone(),
        }
    }
}

/// A lesson that is open.
pub struct Open {
    pub lesson: Arc<Lesson>,
    /// Whether it comes with the program.
    pub built_in: bool,
    pub opening: u64,
    pub step: usize,
    pub staged: Option<Arc<Staged>>,
    /// Why the step's scene could not be loaded.
    pub failed: Option<String>,
    pub work: Background<Prepare>,
    /// The steps that are prepared.
    pub prepared: BTreeMap<usize, Result<Prepared, String>>,
    pub draft: Draft,
    pub markdown: CommonMarkCache,
    /// Whether what is shown is one of its scenes, and not another that was opened meanwhile.
    pub in_view: bool,
    /// What was drawn over the picture before it came into view.
    pub overlay: Overlays,
}

/// An answer that is being made.
#[derive(Default)]
pub struct Draft {
    /// The question's widget, with the answer; none where nothing is asked.
    pub widget: Option<Box<dyn Widget>>,
    /// What the last check said; gone once the answer changes.
    pub grade: Option<Grade>,
    /// When the question was first seen, seconds.
    pub seen: Option<f64>,
    /// Whether the step is to be scrolled to its begin.
    pub fresh: bool,
    /// Where the question begins, points from the top of the window.
    pub top: Option<f32>,
    /// Whether the question is to be scrolled into sight.
    pub seek: bool,
    /// Whether what is said of the answer is to be scrolled into sight.
    pub told: bool,
    /// Whether the way to the next step is to have the focus: what had it went away with the right answer.
    pub onward: bool,
}

impl Draft {
    /// The draft for a question, from the answer that was given before.
    fn new(question: Option<&Question>, answered: Option<&Answered>, seed: u64) -> Self {
        let given = answered.map(|answered| &answered.answer);
        Self {
            widget: question.map(|question| widget_of(&question.kind, given, seed)),
            fresh: true,
            ..Self::default()
        }
    }
}

impl Open {
    pub fn current(&self) -> &Step {
        &self.lesson.steps[self.step]
    }

    pub fn question(&self) -> Option<&Question> {
        self.current().question.as_ref()
    }

    /// Returns whether the answer to its question is a place in the picture.
    fn asks_place(&self) -> bool {
        self.question()
            .is_some_and(|question| question.kind.asks().asks_place())
    }

    /// Whether another scene was opened in place of the step's.
    pub fn is_left(&self) -> bool {
        self.staged.is_some() && !self.in_view
    }

    /// The step's texts, once they are known.
    pub fn known(&self) -> Option<&Result<Prepared, String>> {
        self.prepared.get(&self.step)
    }

    pub fn solution(&self) -> Option<&Solution> {
        self.known()?.as_ref().ok()?.right()
    }

    /// Returns the answer, where there is a whole one; `scene` is that of the window.
    pub fn answer(&self, scene: &Scene) -> Option<Answer> {
        let question = self.question()?;
        let answer = self.draft.widget.as_ref()?.answer(question, scene)?;
        answer.fits(&question.kind).then_some(answer)
    }

    /// How right an answer is.
    pub fn grade(&self, answer: &Answer) -> Option<Grade> {
        let staged = self.staged.as_ref()?;
        let lab = Lab::new(staged);
        self.question()?
            .grade(answer, self.solution()?, lab.place(staged))
    }
}

impl SavedProgress {
    /// The answers to the lesson of that name.
    pub fn record(&self, lesson: &str) -> Option<&Record> {
        self.records.iter().find(|record| record.lesson == lesson)
    }

    /// The record of a lesson, which becomes the latest.
    fn record_mut(&mut self, lesson: &str, seed: u64) -> &mut Record {
        let place = self.records.iter().position(|one| one.lesson == lesson);
        let record = place.map(|place| self.records.remove(place));
        if self.records.len() >= RECORDS {
            self.records.remove(0);
        }
        self.records
            .push(record.unwrap_or_else(|| Record::new(lesson, seed)));
        let last = self.records.len() - 1;
        &mut self.records[last]
    }
}

impl Course {
    /// With what was kept.
    pub fn with(kept: SavedProgress) -> Self {
        Self {
            kept,
            ..Self::default()
        }
    }

    /// Opens a lesson at the step that it was left at.
    pub fn begin(&mut self, lesson: Arc<Lesson>, built_in: bool) -> usize {
        if !built_in {
            self.own = Some(Arc::clone(&lesson));
        }
        self.openings += 1;
        if let Some(record) = self
            .kept
            .records
            .iter_mut()
            .find(|record| record.lesson == lesson.name)
        {
            record.fit(&lesson);
        }
        let left = self.kept.left.get(&lesson.name).copied().unwrap_or(0);
        let left = left.min(lesson.steps.len() - 1);
        self.open = Some(Open {
            lesson,
            built_in,
            opening: self.openings,
            step: left,
            staged: None,
            failed: None,
            work: Background::default(),
            prepared: BTreeMap::new(),
            draft: Draft::default(),
            markdown: CommonMarkCache::default(),
            in_view: false,
            overlay: Overlays::default(),
        });
        left
    }

    /// Goes to a step: its answer so far is taken up again.
    pub fn go(&mut self, step: usize) {
        let Some(open) = &mut self.open else { return };
        open.step = step.min(open.lesson.steps.len() - 1);
        (open.staged, open.failed) = (None, None);
        self.kept.left.insert(open.lesson.name.clone(), open.step);
        let record = self.kept.record(&open.lesson.name);
        let answered = record.and_then(|record| record.answer(open.step));
        open.draft = Draft::new(open.question(), answered, self.seed);
    }

    /// The answer that was given to the step's question.
    pub fn answered(&self) -> Option<&Answered> {
        let open = self.open.as_ref()?;
        self.kept.record(&open.lesson.name)?.answer(open.step)
    }

    /// Whether the right answer is shown.
    pub fn revealed(&self) -> bool {
        self.answered()
            .is_some_and(|answered| answered.grade.right || answered.looked_up > 0)
    }

    /// Puts an answer with its grade on record; `now` is in seconds.
    pub fn put(&mut self, answer: Answer, grade: Grade, now: f64) {
        let before = self.answered().cloned();
        let seed = self.seed;
        let Some(open) = &mut self.open else { return };
        (open.draft.grade, open.draft.told) = (Some(grade), true);
        let since = open.draft.seen.replace(now).unwrap_or(now);
        let (prediction, tries, looked_up, seconds) = match before {
            Some(before) => (
                before.prediction,
                before.tries,
                before.looked_up,
                before.seconds,
            ),
            None => (answer.clone(), 0, 0, 0.0),
        };
        let answered = Answered {
            step: open.step,
            prediction,
            answer,
            grade,
            looked_up,
            tries: tries + 1,
            seconds: seconds + (now - since).max(0.0),
        };
        let name = open.lesson.name.clone();
        self.kept.record_mut(&name, seed).put(answered);
    }

    /// Counts that the right answer was asked for, after one was given.
    pub fn look_up(&mut self) {
        let Some(mut answered) = self.answered().cloned() else {
            return;
        };
        answered.looked_up += 1;
        let seed = self.seed;
        if let Some(open) = &mut self.open {
            open.draft.told = true;
            let name = open.lesson.name.clone();
            self.kept.record_mut(&name, seed).put(answered);
        }
    }

    /// Takes over the answers that another document was handed in with.
    pub fn follow_hand_in(&mut self, part: &CoursePart) {
        let known = self.handed_in.take();
        let known = known.filter(|known| known.is_of(part));
        self.handed_in = known.or_else(|| HandedIn::of(part));
    }

    /// The answers that are shown beside their picture.
    pub fn shown_hand_in(&self) -> Option<&HandedIn> {
        let shown = |handed_in: &&HandedIn| !handed_in.closed;
        self.handed_in.as_ref().filter(shown)
    }

    /// What heads the panel of the course, where that is not the list of lessons.
    pub fn heading(&self) -> Option<&str> {
        let lesson = || self.open.as_ref().map(|open| &*open.lesson.title);
        let handed_in = self.shown_hand_in().map(|_| text!("course-answers"));
        handed_in.or_else(lesson)
    }

    /// The lesson that is open, if what is shown is one of its scenes.
    pub fn in_view(&self) -> Option<&Open> {
        self.open.as_ref().filter(|open| open.in_view)
    }

    /// Whether the picture is that of a lesson's step.
    pub fn shows_step(&self) -> bool {
        self.in_view().is_some()
    }

    /// Whether a lesson is open whose step is not what is shown.
    pub fn has_left_lesson(&self) -> bool {
        self.open.as_ref().is_some_and(Open::is_left)
    }

    /// Whether numbers are hidden until the question is answered.
    pub fn hides(&self) -> bool {
        let hides = |open: &Open| open.current().stage.hide && open.question().is_some();
        self.in_view().is_some_and(hides) && !self.revealed()
    }

    /// Whether a click in the picture is the answer to a question.
    pub fn asks_point(&self) -> bool {
        let asks = |open: &Open| open.staged.is_some() && open.asks_place();
        self.in_view().is_some_and(asks) && !self.revealed()
    }

    /// The place that the student has marked in the picture.
    pub fn mark(&self) -> Option<DVec2> {
        let open = self.in_view()?;
        open.draft.widget.as_ref()?.mark()
    }

    /// Marks a place in the picture.
    pub fn put_mark(&mut self, place: DVec2) {
        if let Some(open) = &mut self.open
            && let Some(widget) = &mut open.draft.widget
        {
            widget.put_mark(place);
            open.draft.grade = None;
        }
    }

    /// The right places, once they are shown.
    pub fn right_places(&self) -> &[DVec2] {
        let solution = self.in_view().and_then(Open::solution);
        match solution {
            Some(Solution::Point(places)) if self.revealed() => places,
            _ => &[],
        }
    }

    /// The step's line, where one is shown, and the place on it that is pointed at.
    pub fn line(&self) -> Option<([DVec2; 2], Option<f64>)> {
        let open = self.in_view()?;
        let line = open.staged.as_ref()?.shown.line?;
        let drawn = open
            .question()
            .is_some_and(|question| question.kind.asks().follows_line());
        let named = open.current().stage.overlays.contains(&"profile");
        (drawn || named).then_some((
            line,
            open.draft.widget.as_ref().and_then(|widget| widget.along()),
        ))
    }

    /// Whether the edges of polygons are drawn over the picture.
    pub fn shows_edges(&self) -> bool {
        let shows = |open: &Open| open.current().stage.overlays.contains(&"edges");
        self.in_view().is_some_and(shows)
    }

    /// Returns whether the step's numbers or its answer are taken at the probe, so that its place is marked without vectors too. Where
    /// a place is asked for, a mark would look like an answer.
    pub fn shows_probe(&self) -> bool {
        let at_probe = |open: &Open| matches!(open.known(), Some(Ok(known)) if known.at_probe);
        self.in_view()
            .is_some_and(|open| at_probe(open) && !open.asks_place())
    }

    /// The lesson that is open, or that was answered last, with its answers, where there are any.
    pub fn to_hand_in(&self) -> Option<(Arc<Lesson>, Record)> {
        let open = self.open.as_ref().map(|open| Arc::clone(&open.lesson));
        let last = || {
            let name = &self.kept.records.last()?.lesson;
            let own = self.own.clone().filter(|own| own.name == *name);
            own.or_else(|| Some(Arc::new(find(name).filter(|_| are_there())?.lesson())))
        };
        let lesson = open.or_else(last)?;
        let record = self.kept.record(&lesson.name)?.clone();
        (!record.answers.is_empty()).then_some((lesson, record))
    }

    /// The lessons of the program, in the present language.
    pub fn listed(&mut self) -> &[Listed] {
        if !are_there() {
            return &[];
        }
        if self
            .list
            .as_ref()
            .is_none_or(|(known, _)| *known != language())
        {
            let listed = LESSONS.iter().map(|lesson| Listed::of(&lesson.lesson()));
            self.list = Some((language(), listed.collect()));
        }
        self.list.as_ref().map_or(&[], |(_, list)| list)
    }
}
