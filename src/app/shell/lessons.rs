//! Lessons in the window: opening, going from step to step, and leaving. A step's scene is opened like any
//! other, so that it is one step of undo.

use super::state::AppState;
use crate::app::course::{Glide, Held, as_target};
use crate::app::session::action::{Action, Turn};
use crate::app::session::appearance::ViewName;
use crate::app::session::document::{CoursePart, Document, Origin};
use crate::app::session::place::{ProbePoint, ProfileLine};
use crate::jobs::Background;
use crate::lesson::{LESSONS, Lesson, OVERLAYS, Staged, are_there, find};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::Context;
use std::sync::Arc;

impl AppState {
    /// Opens a lesson at the step where it was left.
    pub fn open_lesson(&mut self, lesson: Arc<Lesson>, built_in: bool) {
        self.window.end_welcome();
        self.leave_view();
        let step = self.course.begin(lesson, built_in);
        // The step's own controls are beside its text.
        self.window.appearance.controls = false;
        (self.window.picture_alone, self.window.enlarged) = (false, false);
        self.turn_to(step);
    }

    /// Performs a request to the course.
    pub fn turn(&mut self, turn: Turn) {
        let needs_texts = matches!(turn, Turn::Start | Turn::Open(_) | Turn::OpenAt(..));
        if needs_texts && !are_there() {
            // A web page is still loading the lessons.
            self.requests.ask(Action::Course(turn));
            return;
        }
        match turn {
            Turn::Start => match LESSONS.first() {
                Some(first) => self.open_lesson(Arc::new(first.lesson()), true),
                None => self.window.show_view(ViewName::Course),
            },
            Turn::Open(name) => {
                if let Some(lesson) = find(&name) {
                    self.open_lesson(Arc::new(lesson.lesson()), true);
                }
            }
            Turn::OpenAt(name, step) => {
                self.turn(Turn::Open(name));
                self.turn(Turn::To(step));
                let open = self.course.open.as_ref();
                let count = open.map_or(0, |open| open.lesson.steps.len());
                if count > 0 && step >= count {
                    let words = text!("link-no-step", step = step + 1, count = count);
                    self.session.warning = Some(words);
                }
            }
            Turn::Own => {
                if let Some(lesson) = self.course.own.clone() {
                    self.open_lesson(lesson, false);
                }
            }
            Turn::Step(by) => {
                let Some(open) = &self.course.open else {
                    return;
                };
                let count = open.lesson.steps.len();
                let asks = open.lesson.steps.iter().any(|step| step.question.is_some());
                // The page of the results follows the last step of a lesson with questions.
                let step = if open.results.is_some() {
                    count
                } else {
                    open.step
                };
                match step.checked_add_signed(by) {
                    Some(next) if next == count && asks => {
                        self.course.show_results();
                        self.window.show_view(ViewName::Course);
                    }
                    Some(next) if next >= count => self.finish_lesson(),
                    Some(next) => self.turn_to(next),
                    None => self.window.show_view(ViewName::Course),
                }
            }
            Turn::To(step) => self.turn_to(step),
            Turn::Again => {
                let open = self.course.open.as_ref();
                if let Some(staged) = open.and_then(|open| open.staged.clone()) {
                    self.show_stage(&staged, false);
                    self.window.show_view(ViewName::Course);
                }
            }
            Turn::List => self.close_lesson(),
        }
    }

    fn turn_to(&mut self, step: usize) {
        self.course.go(step);
        self.window.show_view(ViewName::Course);
        let Some(open) = &self.course.open else {
            return;
        };
        if open.current().stage.is_file() {
            // Loading a model may take a while.
            self.requests.ask(Action::LoadStage);
            return;
        }
        let staged = open.current().stage.load(open.lesson.folder.as_deref());
        let staged = staged.map(Arc::new).map_err(|error| error.to_string());
        self.stage(open.opening, open.step, staged);
    }

    /// Shows the scene of a step, or the reason why it cannot be shown, if that step is still the current
    /// one.
    pub fn stage(&mut self, opening: u64, step: usize, staged: Result<Arc<Staged>, String>) {
        let Some(open) = &mut self.course.open else {
            return;
        };
        if (open.opening, open.step) != (opening, step) {
            return;
        }
        match staged {
            Ok(staged) => {
                open.staged = Some(Arc::clone(&staged));
                self.show_stage(&staged, true);
            }
            Err(why) => open.failed = Some(why),
        }
    }

    /// Shows a step's scene; if `answered` and the right answer may be seen, with the answer's settings.
    fn show_stage(&mut self, staged: &Staged, answered: bool) {
        let view = (self.window.appearance.views, self.window.appearance.view);
        let before = self.session.document().scene.clone();
        let open = self.course.open.as_ref();
        let lesson = open.map(|open| open.lesson.name.clone());
        let document = Document {
            scene: staged.scene.clone(),
            model: staged.model.clone(),
            origin: match &staged.path {
                Some(path) => Origin::File(path.clone()),
                None => Origin::BuiltIn(staged.name.clone()),
            },
            part: lesson.map_or(CoursePart::None, CoursePart::Step),
        };
        if !self.replace(document) {
            return;
        }
        (self.window.appearance.views, self.window.appearance.view) = view;
        self.window.seek_highlight = false;
        self.window.probe = staged.shown.probe.map_or(self.window.probe, ProbePoint);
        self.window.line = staged.shown.line.map_or(self.window.line, ProfileLine);
        self.show_overlays();
        if answered && self.course.revealed() {
            self.show_answer();
        }
        self.glide_from(&before);
    }

    /// Animates the change from a scene to the one shown now.
    fn glide_from(&mut self, before: &Scene) {
        self.course.gliding = Glide::between(before, &self.session.document().scene);
        // The end is not seen before the way there.
        let start = self.course.gliding.as_ref().and_then(Glide::start);
        if let Some(start) = start {
            self.session.show_scene(start);
        }
    }

    /// Shows the overlays that the step names.
    fn show_overlays(&mut self) {
        let Some(open) = &self.course.open else {
            return;
        };
        let shown = |name: &str| {
            debug_assert!(OVERLAYS.contains(&name));
            open.current().stage.overlays.contains(&name)
        };
        let overlay = &mut self.window.appearance.overlay;
        overlay.vectors = shown("vectors");
        overlay.side_view = shown("side-view");
        overlay.lobe = shown("lobe");
        overlay.angles = open.overlay.angles && !self.course.hides();
        overlay.face_normals = shown("normals");
        overlay.vertex_normals = shown("vertices");
        overlay.vertex = shown("vertex");
    }

    /// Follows a change of the document into the lesson or out of it: everything that a lesson hides, locks and
    /// draws applies to its own scenes only.
    pub fn follow_document(&mut self) {
        let part = &self.session.document().part;
        self.course.follow_hand_in(part);
        let Some(open) = &mut self.course.open else {
            return;
        };
        let in_view = matches!(part, CoursePart::Step(lesson) if *lesson == open.lesson.name);
        if in_view && !open.in_view {
            open.in_view = true;
            open.overlay = self.window.appearance.overlay.clone();
            self.show_overlays();
        } else if !in_view {
            self.leave_view();
        }
    }

    /// Locks the scene while the question of the step in view is open. What the step shows over the picture stays
    /// too: an overlay, the probe or the line could show the answer.
    pub fn follow_lock(&mut self) {
        self.session.lock = self.course.lock();
        self.window.hidden = self.course.hides();
        let Some(open) = &mut self.course.open else {
            return;
        };
        if self.session.lock.is_none() {
            open.held = None;
            return;
        }
        let window = &mut self.window;
        let present = Held {
            overlay: window.appearance.overlay.clone(),
            probe: window.probe,
            line: window.line,
        };
        let held = open.held.get_or_insert_with(|| present.clone());
        if *held != present {
            window.appearance.overlay = held.overlay.clone();
            (window.probe, window.line) = (held.probe, held.line);
            self.session.say_locked();
        }
    }

    /// Restores the overlays from before the lesson came into view.
    fn leave_view(&mut self) {
        if let Some(open) = &mut self.course.open
            && std::mem::take(&mut open.in_view)
        {
            open.held = None;
            self.window.appearance.overlay = open.overlay.clone();
        }
    }

    /// Advances the animation towards the step's scene.
    pub fn glide(&mut self, ctx: &Context) {
        let Some(glide) = &mut self.course.gliding else {
            return;
        };
        let (scene, last) = glide.now(ctx);
        if last {
            self.course.gliding = None;
        } else {
            ctx.request_repaint();
        }
        self.session.show_scene(scene);
    }

    /// Restores the overlay of angles, and shows the settings that the right answer is about, unless the
    /// question has controls of its own.
    pub fn show_answer(&mut self) {
        let Some(open) = &self.course.open else {
            return;
        };
        let (Some(question), Some(staged)) = (open.question(), &open.staged) else {
            return;
        };
        self.window.appearance.overlay.angles = open.overlay.angles;
        if !question.kind.asks().controls().is_empty() {
            return;
        }
        if let Ok(scene) = staged.scene.with_overrides(&question.set) {
            let before = self.session.document().scene.clone();
            self.session.show_scene(scene);
            self.glide_from(&before);
        }
    }

    /// Closes the lesson at its end, and marks it as done.
    fn finish_lesson(&mut self) {
        if let Some(open) = &self.course.open {
            let name = open.lesson.name.clone();
            self.course.kept.left.remove(&name);
            self.course.kept.done.insert(name);
        }
        self.close_lesson();
    }

    fn close_lesson(&mut self) {
        self.leave_view();
        self.course.open = None;
        if let Some(handed_in) = &mut self.course.handed_in {
            handed_in.closed = true;
        }
        self.window.show_view(ViewName::Course);
    }

    /// Translates the lesson into the current language.
    pub fn translate_lesson(&mut self) {
        if let Some(handed_in) = &mut self.course.handed_in {
            // The graded texts are in the previous language.
            handed_in.work = Background::default();
        }
        let Some(open) = &mut self.course.open else {
            return;
        };
        if let Some(lesson) = find(&open.lesson.name).filter(|_| open.built_in) {
            open.lesson = Arc::new(lesson.lesson());
        }
        self.course.openings += 1;
        open.opening = self.course.openings;
        open.prepared.clear();
        if open.results.is_some() {
            self.course.show_results();
        }
    }

    /// Opens a match whose target is the current scene.
    pub fn set_as_target(&mut self) {
        match as_target(&self.session) {
            Some(lesson) => self.open_lesson(Arc::new(lesson), false),
            None => self.session.notice = Some(text!("course-target-file").into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::session::appearance::Appearance;
    use crate::app::shell::commands::SECTIONS;
    use crate::app::shell::terms;
    use crate::lesson::{Answer, Grade};
    use crate::scene::parameter::Parameter;
    use crate::scene::{Choice as _, CompareView, Light, Scene, ShadingMode, presets};

    const SIZE: [u32; 2] = [480, 360];

    /// Opens a lesson of the course at a step.
    fn at(lesson: &str, step: usize) -> AppState {
        let mut state = AppState::default();
        state.turn(Turn::OpenAt(lesson.to_owned(), 0));
        state.session.begin();
        state.turn(Turn::To(step));
        let still = Context::default();
        still.all_styles_mut(|style| style.animation_time = 0.0);
        state.glide(&still);
        state.session.observe(false, 0.0);
        state.follow_lock();
        state
    }

    /// Performs an action as the window does; returns it if it is left to files or dialogs.
    fn perform(state: &mut AppState, action: Action) -> Option<Action> {
        let rest = state.perform(action, SIZE);
        state.session.commit();
        state.follow_lock();
        rest
    }

    /// Changes the document, then the scene of the controls.
    fn edit(state: &mut AppState, change: impl Fn(&mut Scene)) {
        state.session.edit(|scene, _| change(scene));
        change(&mut state.session.shown.scene);
        state.session.commit();
        state.follow_lock();
    }

    /// The part of the window that could show an answer.
    fn shown(state: &AppState) -> (Scene, Held, bool) {
        let window = &state.window;
        let held = Held {
            overlay: window.appearance.overlay.clone(),
            probe: window.probe,
            line: window.line,
        };
        (state.session.document().scene.clone(), held, window.hidden)
    }

    /// Every scene that differs from this one in a single parameter, as far as built-in scenes have other values.
    fn neighbours(scene: &Scene, others: &[Scene]) -> Vec<(String, Scene)> {
        let mut found = Vec::new();
        for parameter in Parameter::all() {
            for index in 0..parameter.count(scene) {
                let changed = others.iter().find_map(|other| {
                    if parameter.agrees(scene, other, index) {
                        return None;
                    }
                    let mut changed = scene.clone();
                    parameter.copy(other, &mut changed, index);
                    let differs = !parameter.agrees(scene, &changed, index);
                    (differs && changed.validate().is_ok()).then_some(changed)
                });
                found.extend(changed.map(|changed| (parameter.key(index), changed)));
            }
        }
        found
    }

    #[test]
    fn no_prediction_of_the_course_can_be_peeked_at() {
        let mut questions = 0;
        let scenes: Vec<Scene> = presets::ALL.iter().map(|preset| preset.scene()).collect();
        for lesson in &LESSONS {
            let Lesson { steps, test, .. } = lesson.lesson();
            let asks = |step: &usize| steps[*step].question.is_some();
            for step in (0..steps.len()).filter(asks) {
                questions += 1;
                let mut state = try_everything(lesson.name, step, &scenes);
                answer(&mut state, test, &format!("{}/{}", lesson.name, step + 1));
            }
        }
        assert!(questions >= 205, "{questions} questions");
    }

    fn try_everything(lesson: &str, step: usize, scenes: &[Scene]) -> AppState {
        let mut state = at(lesson, step);
        let name = |tried: &str| format!("{lesson}/{}: {tried}", step + 1);
        let open = state.course.open.as_ref().expect("a lesson");
        let controls = open.question().expect("a question").kind.asks().controls();
        let controls = controls.to_vec();
        let before = shown(&state);
        assert!(state.session.lock.is_some() && before.2, "{}", name("open"));
        let same =
            |state: &AppState, tried: &str| assert!(shown(state) == before, "{}", name(tried));

        // Commands, whether by key or from a menu; those that lead elsewhere come below.
        let commands = SECTIONS.iter().flat_map(|section| &section.commands);
        let mut actions: Vec<Action> = commands
            .flat_map(|command| command.actions.clone())
            .collect();
        actions.extend(ShadingMode::VALUES.iter().map(|mode| Action::Shade {
            mode: *mode,
            renormalise: false,
        }));
        actions.extend(
            CompareView::VALUES
                .iter()
                .map(|view| Action::Compare(*view)),
        );
        actions.extend([
            Action::AddLight(Light::default()),
            Action::MovePane(0, 1),
            Action::RemovePane(0),
            Action::Reference(0),
            Action::Reference(1),
            Action::SaveAnswer("curves", crate::analysis::Format::Csv),
        ]);
        for action in actions {
            let words = format!("{action:?}");
            // With a question that is answered by controls, these move what is free: the camera and the controls.
            let plays = matches!(
                action,
                Action::Orbit(_)
                    | Action::Pan(_)
                    | Action::Zoom(_)
                    | Action::ResetCamera
                    | Action::Undo
                    | Action::Redo
            );
            if matches!(action, Action::SetTarget) || plays && !controls.is_empty() {
                continue;
            }
            let shows_numbers = matches!(
                action,
                Action::Export | Action::Code | Action::SaveAnswer(..)
            );
            let rest = perform(&mut state, action);
            assert!(!(shows_numbers && rest.is_some()), "{}", name(&words));
            same(&state, &words);
        }
        state.window.appearance = Appearance {
            views: true,
            ..state.window.appearance.reset()
        };
        state.follow_lock();
        same(&state, "reset of the layout");

        // Views, and what they draw over the picture.
        for view in crate::link::VIEWS {
            let view = ViewName::named(view).expect("a view");
            state.window.show_view(view);
            assert!(
                !state.window.shows(view) || view == ViewName::Course,
                "{}",
                name("view")
            );
        }

        // Terms, lights, modes and all other settings, one by one; then whole scenes.
        for (term, key) in ["material.ka", "material.kd", "material.ks"]
            .into_iter()
            .enumerate()
        {
            if controls.iter().any(|control| control == key) {
                continue;
            }
            let AppState {
                session, window, ..
            } = &mut state;
            terms::switch(session, window, term);
            state.session.commit();
            same(&state, "term");
        }
        for (key, scene) in neighbours(&before.0, scenes) {
            let view = key.starts_with("camera.") && !controls.is_empty();
            if !controls.contains(&key) && !view {
                edit(&mut state, |present| present.clone_from(&scene));
                same(&state, &key);
            }
        }
        for pane in 0..before.0.pane_count() {
            state.session.activate(pane);
            let mode = state.session.shown.scene.shading.mode;
            for other in ShadingMode::VALUES.iter().filter(|other| **other != mode) {
                state.session.shown.scene.shading.mode = *other;
                state.session.commit();
                same(&state, "mode of a pane");
            }
        }
        let lock = state.session.lock.clone().unwrap_or_default();
        for scene in scenes {
            edit(&mut state, |present| present.clone_from(scene));
            // With a question that is answered by controls, these and the camera are free.
            let present = &state.session.document().scene;
            if !controls.is_empty() && lock.allows(&before.0, present) {
                edit(&mut state, |present| present.clone_from(&before.0));
            }
            same(&state, &scene.about.title);
        }
        // What is opened elsewhere leaves the lesson, with its locks; undo returns to both.
        state.open_link("?scene=gold");
        state.follow_lock();
        assert!(
            !state.course.shows_step() && state.session.lock.is_none(),
            "{}",
            name("link")
        );
        assert!(!state.window.hidden && state.course.has_left_lesson());
        edit(&mut state, |scene| scene.material.n = 3.0);
        assert_eq!(state.session.document().scene.material.n, 3.0);
        state.turn(Turn::Again);
        state.follow_lock();
        state.course.gliding = None;
        assert!(state.session.lock.is_some(), "{}", name("back"));
        state
    }

    /// Answers rightly. Then everything is open to play, but in a test, which keeps its scene and says nothing.
    fn answer(state: &mut AppState, test: bool, name: &str) {
        let before = state.session.document().scene.clone();
        let right = Grade {
            right: true,
            ..Grade::default()
        };
        state.course.put(Answer::Choice(0), right, 0.0);
        state.follow_lock();
        assert_eq!(state.session.lock.is_some(), test, "{name}: answered");
        assert_eq!(state.window.hidden, test, "{name}: answered");
        assert_eq!(state.course.revealed(), !test, "{name}: answered");
        edit(state, |scene| scene.camera.roll += 1.0);
        let same = state.session.document().scene == before;
        let open = state.course.open.as_ref();
        let question = open.and_then(|open| open.question());
        let has_controls =
            question.is_some_and(|question| !question.kind.asks().controls().is_empty());
        assert_eq!(same, test && !has_controls, "{name}: played with");
    }
}
