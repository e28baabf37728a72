//! A point, marked by a click in the picture.

use super::widget::{Widget, WidgetContext};
use crate::app::session::Session;
use crate::app::system;
use crate::app::widgets::focus::picture_id;
use crate::lesson::{Answer, Question, Solution};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::{Key, Label, RichText, Ui};
use glam::DVec2;

/// The point marked in the picture.
#[derive(Default)]
pub struct PointWidget {
    /// The offset from the picture's centre, in units of its shorter side.
    mark: Option<DVec2>,
}

impl Widget for PointWidget {
    fn take_up(&mut self, given: &Answer) {
        if let Answer::Point(place) = given {
            self.mark = Some(DVec2::from_array(*place));
        }
    }

    fn ui(&mut self, ui: &mut Ui, asked: &mut WidgetContext<'_>) -> bool {
        if asked.revealed {
            return false;
        }
        let words = match (self.mark.is_some(), system::fingers(ui.ctx())) {
            (true, false) => text!("course-point-set"),
            (true, true) => text!("course-point-set.touch"),
            (false, false) => text!("course-point"),
            (false, true) => text!("course-point.touch"),
        };
        ui.add(Label::new(RichText::new(words).weak()).wrap());
        ui.memory(|memory| memory.has_focus(picture_id()))
            && ui.input(|input| input.key_pressed(Key::Enter))
    }

    fn answer(&self, _: &Question, _: &Scene) -> Option<Answer> {
        self.mark.map(|place| Answer::Point(place.to_array()))
    }

    fn right_ui(&self, ui: &mut Ui, _: &Question, right: &Solution, _: &Answer, _: &mut Session) {
        let words = match right {
            Solution::Point(places) if places.len() > 1 => text!("course-places"),
            _ => text!("course-place"),
        };
        ui.add(Label::new(words).wrap());
    }

    fn mark(&self) -> Option<DVec2> {
        self.mark
    }

    fn put_mark(&mut self, place: DVec2) {
        self.mark = Some(place);
    }
}
