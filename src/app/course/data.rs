//! The course's state: the open lesson, and the answers given so far.

use super::glide::Glide;
use super::kinds::{Widget, widget_of};
use super::marking::HandedIn;
#[cfg(feature = "class")]
use super::teaching::Teaching;
use super::work::{Prepare, Prepared};
use crate::app::session::appearance::Overlays;
use crate::app::session::document::CoursePart;
use crate::app::session::lock::Lock;
use crate::app::session::place::{ProbePoint, ProfileLine};
use crate::jobs::Background;
use crate::lesson::{
    Answer, Answered, Grade, HandIn, LESSONS, Lab, Lesson, Question, Record, Solution, Staged,
    Step, are_there, find,
};
use crate::scene::Scene;
use crate::text::{Language, language, text};
use egui_commonmark::CommonMarkCache;
use glam::DVec2;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The maximum number of lessons whose answers are stored.
const RECORDS: usize = 200;

/// The state of the course in the window.
pub struct Course {
    /// The open lesson.
    pub open: Option<Open>,
    /// The lesson from a file, which is first in the list.
    pub own: Option<Arc<Lesson>>,
    /// The answers handed in with the document.
    pub handed_in: Option<HandedIn>,
    /// The progress stored between two runs.
    pub kept: SavedProgress,
    /// The seed of what is drawn at random.
    pub seed: u64,
    /// The program's lessons as the list shows them, with the language of their texts.
    pub list: Option<(Language, Vec<Listed>)>,
    /// The number of lessons opened so far.
    pub openings: u64,
    /// The animation towards a step's scene.
    pub gliding: Option<Glide>,
    /// The live class that is going on.
    #[cfg(feature = "class")]
    pub class: Option<Teaching>,
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
            #[cfg(feature = "class")]
            class: None,
        }
    }
}

/// The progress stored between two runs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedProgress {
    /// The answers, one record per lesson, the most recent last.
    pub records: Vec<Record>,
    /// The names of the completed lessons.
    pub done: BTreeSet<String>,
    /// The name under which answers were last handed in.
    pub name: String,
    /// The step at which each lesson was left, by the lesson's name.
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
    /// The number of questions.
    pub questions: usize,
    /// True for a test, whose answers are not marked.
    pub test: bool,
}

impl Listed {
    pub fn of(lesson: &Lesson) -> Self {
        Self {
            name: lesson.name.clone(),
            title: lesson.title.clone(),
            topic: lesson.topic.clone(),
            minutes: lesson.minutes,
            about: lesson.about.clone(),
            questions: lesson
                .steps
                .iter()
                .filter(|step| step.question.is_some())
                .count(),
            test: lesson.test,
        }
    }
}

/// An open lesson.
pub struct Open {
    pub lesson: Arc<Lesson>,
    /// True if the lesson comes with the program.
    pub built_in: bool,
    pub opening: u64,
    pub step: usize,
    pub staged: Option<Arc<Staged>>,
    /// The reason why the step's scene could not be loaded.
    pub failed: Option<String>,
    pub work: Background<Prepare>,
    /// The results of preparing steps, by the step's index.
    pub prepared: BTreeMap<usize, Result<Prepared, String>>,
    pub draft: Draft,
    pub markdown: CommonMarkCache,
    /// True if one of the lesson's scenes is displayed, and not another one that was opened since.
    pub in_view: bool,
    /// The overlays of the picture from before the lesson came into view.
    pub overlay: Overlays,
    /// The drawing over the picture while the question is open; `None` while it is not.
    pub held: Option<Held>,
    /// The answers to all questions, while the lesson's last page shows them.
    pub results: Option<HandedIn>,
}

/// The drawing of a step over the picture, which stays until its question is answered.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    pub overlay: Overlays,
    pub probe: ProbePoint,
    pub line: ProfileLine,
}

/// An answer in the making.
#[derive(Default)]
pub struct Draft {
    /// The question's widget, with the answer; `None` if the step has no question.
    pub widget: Option<Box<dyn Widget>>,
    /// True if the student has touched the widget or the picture; until then a test keeps nothing.
    pub touched: bool,
    /// The grade of the last check; cleared when the answer changes.
    pub grade: Option<Grade>,
    /// The time when the question was first seen, in seconds.
    pub seen: Option<f64>,
    /// True if the step is to be scrolled to its beginning.
    pub fresh: bool,
    /// The top of the question, in points from the top of the window.
    pub top: Option<f32>,
    /// True if the question is to be scrolled into view.
    pub seek: bool,
    /// True if the feedback is to be scrolled into view.
    pub told: bool,
    /// True if the button of the next step is to take the focus, since the widget that had it disappeared
    /// with the right answer.
    pub onward: bool,
}

impl Draft {
    /// Creates the draft for a question from the previous answer, if there is one.
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

    /// Returns whether the answer to the step's question is a point in the picture.
    fn asks_place(&self) -> bool {
        self.current().asks().is_some_and(|asks| asks.asks_place())
    }

    /// Returns whether another scene was opened in place of the step's.
    pub fn is_left(&self) -> bool {
        self.staged.is_some() && !self.in_view
    }

    /// Returns the step's texts, once they are known.
    pub fn known(&self) -> Option<&Result<Prepared, String>> {
        self.prepared.get(&self.step)
    }

    pub fn solution(&self) -> Option<&Solution> {
        self.known()?.as_ref().ok()?.right()
    }

    /// Returns the answer if it is complete; `scene` is the scene of the window.
    pub fn answer(&self, scene: &Scene) -> Option<Answer> {
        let question = self.question()?;
        let answer = self.draft.widget.as_ref()?.answer(question, scene)?;
        answer.fits(&question.kind).then_some(answer)
    }

    /// Grades an answer, once the scene and the solution are known.
    pub fn grade(&self, answer: &Answer) -> Option<Grade> {
        let staged = self.staged.as_ref()?;
        let key = self.known()?.as_ref().ok()?.key()?;
        let lab = Lab::new(staged);
        self.question()?.grade(answer, key, lab.place(staged))
    }
}

impl SavedProgress {
    /// Returns the record of the lesson with the given name.
    pub fn record(&self, lesson: &str) -> Option<&Record> {
        self.records.iter().find(|record| record.lesson == lesson)
    }

    /// Returns the record of a lesson and makes it the most recent one.
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
    /// Creates a course with stored progress.
    pub fn with(kept: SavedProgress) -> Self {
        Self {
            kept,
            ..Self::default()
        }
    }

    /// Opens a lesson at the step where it was left, and returns that step.
    pub fn begin(&mut self, lesson: Arc<Lesson>, built_in: bool) -> usize {
        if !built_in {
            self.own = Some(Arc::clone(&lesson));
        }
        self.openings += 1;
        let mut records = self.kept.records.iter_mut();
        if let Some(record) = records.find(|record| record.lesson == lesson.name) {
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
            held: None,
            results: None,
        });
        left
    }

    /// Goes to a step and restores its answer.
    pub fn go(&mut self, step: usize) {
        let Some(open) = &mut self.open else { return };
        open.step = step.min(open.lesson.steps.len() - 1);
        (open.staged, open.failed, open.held, open.results) = (None, None, None, None);
        self.kept.left.insert(open.lesson.name.clone(), open.step);
        let record = self.kept.record(&open.lesson.name);
        let answered = record.and_then(|record| record.answer(open.step));
        open.draft = Draft::new(open.question(), answered, self.seed);
    }

    /// Returns the answer given to the step's question.
    pub fn answered(&self) -> Option<&Answered> {
        let open = self.open.as_ref()?;
        self.kept.record(&open.lesson.name)?.answer(open.step)
    }

    /// Returns whether the open lesson is a test.
    pub fn is_test(&self) -> bool {
        self.open.as_ref().is_some_and(|open| open.lesson.test)
    }

    /// Returns whether the right answer is shown: in a test never.
    pub fn revealed(&self) -> bool {
        let shown = |answered: &Answered| answered.grade.right || answered.looked_up > 0;
        let answered = !self.is_test() && self.answered().is_some_and(shown);
        answered || self.is_explained()
    }

    /// Returns whether a live class is going on.
    pub fn teaches(&self) -> bool {
        #[cfg(feature = "class")]
        let teaches = self.class.is_some();
        #[cfg(not(feature = "class"))]
        let teaches = false;
        teaches
    }

    /// Returns whether the step is explained to a class that is going on.
    #[cfg(feature = "class")]
    fn is_explained(&self) -> bool {
        let pair = self.class.as_ref().zip(self.open.as_ref());
        pair.is_some_and(|(class, open)| class.explains(&open.lesson.name, open.step))
    }

    #[cfg(not(feature = "class"))]
    fn is_explained(&self) -> bool {
        false
    }

    /// Keeps the answer of a test once the student has given one. It has no grade, so that the file in which it is kept does not
    /// tell whether it is right.
    pub fn keep(&mut self, scene: &Scene, now: f64) {
        let Some(open) = self.open.as_ref().filter(|open| open.lesson.test) else {
            return;
        };
        let answer = open.answer(scene);
        // Of a control the answer is in the scene.
        let moved = open
            .staged
            .as_ref()
            .is_some_and(|staged| open.answer(&staged.scene) != answer);
        let known = self.answered().map(|answered| &answered.answer);
        if let Some(answer) = answer
            && (open.draft.touched || moved)
            && known != Some(&answer)
        {
            self.put(answer, Grade::default(), now);
        }
    }

    /// Records an answer with its grade; `now` is in seconds. A test says nothing about an answer, so the next one is a prediction,
    /// too, and replaces it.
    pub fn put(&mut self, answer: Answer, grade: Grade, now: f64) {
        let before = self.answered().cloned();
        let test = self.is_test();
        let seed = self.seed;
        let Some(open) = &mut self.open else { return };
        (open.draft.grade, open.draft.told) = (Some(grade), true);
        let since = open.draft.seen.replace(now).unwrap_or(now);
        let mut answered = before.unwrap_or_else(|| Answered {
            step: open.step,
            prediction: answer.clone(),
            answer: answer.clone(),
            grade,
            looked_up: 0,
            tries: 0,
            seconds: 0.0,
        });
        if test {
            answered.prediction.clone_from(&answer);
            (answered.tries, answered.looked_up) = (0, 0);
        }
        (answered.answer, answered.grade) = (answer, grade);
        answered.tries += 1;
        answered.seconds += (now - since).max(0.0);
        let name = open.lesson.name.clone();
        self.kept.record_mut(&name, seed).put(answered);
    }

    /// Counts a look at the right answer, if an answer has been given.
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

    /// Shows the last page of the open lesson, with the answers to all questions.
    pub fn show_results(&mut self) {
        let Some(open) = &mut self.open else { return };
        let lesson = &open.lesson;
        let none = || Record::new(&lesson.name, self.seed);
        let record = self.kept.record(&lesson.name).cloned();
        let record = record.unwrap_or_else(none);
        let answers = HandIn::new(lesson, &record, &self.kept.name);
        open.results = Some(HandedIn::with(Arc::new(Ok(answers))));
    }

    /// Takes over the answers handed in with another document.
    pub fn follow_hand_in(&mut self, part: &CoursePart) {
        let known = self.handed_in.take();
        let known = known.filter(|known| known.is_of(part));
        self.handed_in = known.or_else(|| HandedIn::of(part));
    }

    /// Returns the answers handed in, if they are shown beside their picture.
    pub fn shown_hand_in(&self) -> Option<&HandedIn> {
        let shown = |handed_in: &&HandedIn| !handed_in.closed;
        self.handed_in.as_ref().filter(shown)
    }

    /// Returns the heading of the course's panel; `None` for the list of lessons.
    pub fn heading(&self) -> Option<&str> {
        let lesson = || self.open.as_ref().map(|open| &*open.lesson.title);
        let handed_in = self.shown_hand_in().map(|_| text!("course-answers"));
        handed_in.or_else(lesson)
    }

    /// Returns the open lesson, if one of its scenes is displayed.
    pub fn in_view(&self) -> Option<&Open> {
        self.open.as_ref().filter(|open| open.in_view)
    }

    /// Returns whether the picture shows a lesson's step.
    pub fn shows_step(&self) -> bool {
        self.in_view().is_some()
    }

    /// Returns whether a lesson is open while another scene is displayed.
    pub fn has_left_lesson(&self) -> bool {
        self.open.as_ref().is_some_and(Open::is_left)
    }

    /// Returns the lock of the step's question, while it is open.
    pub fn lock(&self) -> Option<Lock> {
        let open = self.in_view().filter(|open| open.staged.is_some())?;
        let question = open.question().filter(|_| !self.revealed())?;
        Some(Lock::new(question.kind.asks().controls()))
    }

    /// Returns whether numbers are hidden until the question is answered.
    pub fn hides(&self) -> bool {
        let hides = |open: &Open| open.current().stage.hide && open.question().is_some();
        self.in_view().is_some_and(hides) && !self.revealed()
    }

    /// Returns whether a click in the picture answers a question.
    pub fn asks_point(&self) -> bool {
        let asks = |open: &Open| open.staged.is_some() && open.asks_place();
        self.in_view().is_some_and(asks) && !self.revealed()
    }

    /// Returns the point that the student has marked in the picture.
    pub fn mark(&self) -> Option<DVec2> {
        let open = self.in_view()?;
        open.draft.widget.as_ref()?.mark()
    }

    /// Marks a point in the picture.
    pub fn put_mark(&mut self, place: DVec2) {
        if let Some(open) = &mut self.open
            && let Some(widget) = &mut open.draft.widget
        {
            widget.put_mark(place);
            (open.draft.grade, open.draft.touched) = (None, true);
        }
    }

    /// Returns the right points, once they are shown.
    pub fn right_places(&self) -> &[DVec2] {
        let solution = self.in_view().and_then(Open::solution);
        match solution {
            Some(Solution::Point(places)) if self.revealed() => places,
            _ => &[],
        }
    }

    /// Returns the step's line, if it is shown, and the position on it under the pointer.
    pub fn line(&self) -> Option<([DVec2; 2], Option<f64>)> {
        let open = self.in_view()?;
        let line = open.staged.as_ref()?.shown.line?;
        let step = open.current();
        let drawn = step.asks().is_some_and(|asks| asks.follows_line());
        let named = step.stage.overlays.contains(&"profile");
        let along = open.draft.widget.as_ref().and_then(|widget| widget.along());
        (drawn || named).then_some((line, along))
    }

    /// Returns whether the picture shows the edges of polygons.
    pub fn shows_edges(&self) -> bool {
        let shows = |open: &Open| open.current().stage.overlays.contains(&"edges");
        self.in_view().is_some_and(shows)
    }

    /// Returns whether the probe is marked without vectors too, since the step's numbers or its answer are
    /// taken there. If the question asks for a point, returns false: the mark would look like an answer.
    pub fn shows_probe(&self) -> bool {
        let at_probe = |open: &Open| matches!(open.known(), Some(Ok(known)) if known.at_probe);
        self.in_view()
            .is_some_and(|open| at_probe(open) && !open.asks_place())
    }

    /// Returns the open lesson, or else the one answered last, with its answers, if there are any.
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

    /// Returns the program's lessons in the current language; none until they are loaded.
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
