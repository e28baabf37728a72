//! A live class led from the window: started about the open lesson, whose steps the picture shows as the class goes on.

use super::dialog::Dialog;
use super::state::AppState;
use crate::app::course::Teaching;
use crate::app::session::action::{ClassAction, Turn};
use crate::app::session::appearance::ViewName;
use crate::app::widgets::background::wake;
use crate::class::{Command, Live, LiveOptions, ServerOptions};
use crate::lesson::{Lesson, find};
use crate::text::text;
use core::net::{IpAddr, Ipv4Addr};
use eframe::egui::Context;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// The minimum time between two frames that answers of the class request.
const REST: Duration = Duration::from_millis(30);

impl AppState {
    /// Returns the file that the answers of a class about the open lesson are kept in, unless another is chosen; none where a class is
    /// going on or no lesson is open, which the view then says.
    pub fn class_file(&mut self) -> Option<PathBuf> {
        self.window.show_view(ViewName::Class);
        let open = self.course.open.as_ref()?;
        let file = PathBuf::from(format!("{}.jsonl", open.lesson.name));
        let file = std::path::absolute(&file).unwrap_or(file);
        self.course.class.is_none().then_some(file)
    }

    /// Does what the lecturer asks for.
    pub fn lead_class(&mut self, ctx: &Context, action: ClassAction) {
        match action {
            ClassAction::Teach => self.window.show_view(ViewName::Class),
            ClassAction::Start(record) => self.start_class(ctx, &record),
            ClassAction::Begin => {
                if let Some(class) = &mut self.course.class {
                    class.joining = false;
                }
                self.window.show_view(ViewName::Class);
            }
            ClassAction::Onward => {
                let seen = self.course.class.as_ref().map(Teaching::seen);
                if let Some(seen) = seen {
                    self.perform_in_class(Teaching::onward(&seen));
                }
            }
            ClassAction::Perform(command) => self.perform_in_class(command),
            ClassAction::End => self.course.class = None,
        }
        ctx.request_repaint();
    }

    fn start_class(&mut self, ctx: &Context, record: &Path) {
        let Some(open) = self.course.open.as_ref() else {
            return;
        };
        let options = LiveOptions {
            record: record.to_owned(),
            server: ServerOptions {
                bind: IpAddr::from(Ipv4Addr::UNSPECIFIED),
                port: None,
                page: crate::class::page_folder(),
            },
            url: None,
            own_pace: false,
            rehearse: 0,
            seed: self.course.seed,
        };
        match Live::start(Lesson::clone(&open.lesson), &options) {
            Ok(live) => self.teach(ctx, live),
            Err(words) => self.dialog = Some(Dialog::message(text!("wall-not-started"), words)),
        }
    }

    /// Shows a class that has been started.
    pub fn teach(&mut self, ctx: &Context, live: Live) {
        // A frame is asked for when something has changed, and not before.
        let wake = wake(ctx);
        live.room().on_change(move || wake(REST));
        let step = live.room().pace().step - 1;
        self.course.class = Some(Teaching::new(live));
        self.follow_class(step);
    }

    fn perform_in_class(&mut self, command: Command) {
        let Some(class) = &mut self.course.class else {
            return;
        };
        match class.perform(command) {
            Some(step) => self.follow_class(step),
            None if command == Command::Explain => self.show_answer(),
            None => {}
        }
        self.window.show_view(ViewName::Class);
    }

    /// Goes to the step of the class, from 0, in its lesson.
    fn follow_class(&mut self, step: usize) {
        let Some(class) = &self.course.class else {
            return;
        };
        let lesson = class.live.room().lesson();
        let open = self.course.open.as_ref();
        if !open.is_some_and(|open| open.in_view && open.lesson.name == lesson.name) {
            let built_in = lesson.folder.is_none() && find(&lesson.name).is_some();
            self.open_lesson(Arc::new(lesson.clone()), built_in);
        }
        self.turn(Turn::To(step));
        self.window.show_view(ViewName::Class);
    }
}
