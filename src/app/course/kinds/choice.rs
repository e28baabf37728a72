//! A choice: a card for each option.

use super::card::{CHOICE, OptionCard};
use super::widget::{Widget, WidgetContext};
use crate::app::widgets::mark::radio_mark;
use crate::lesson::{Answer, Question, Solution};
use crate::scene::Scene;
use eframe::egui::accesskit::Role;
use eframe::egui::{Ui, vec2};

/// The options, with the chosen one.
#[derive(Default)]
pub struct ChoiceWidget {
    chosen: Option<usize>,
}

impl Widget for ChoiceWidget {
    fn take_up(&mut self, given: &Answer) {
        if let Answer::Choice(chosen) = given {
            self.chosen = Some(*chosen);
        }
    }

    fn ui(&mut self, ui: &mut Ui, asked: &mut WidgetContext<'_>) -> bool {
        let right = match asked.right() {
            Some(Solution::Choice(right)) => Some(*right),
            _ => None,
        };
        for (index, words) in asked.names.iter().enumerate() {
            let on = self.chosen == Some(index);
            let card = OptionCard {
                id: ui.scope_id().with(("option", index)),
                words,
                role: Role::RadioButton,
                on,
                right: right.map(|right| right == index),
                enabled: !asked.revealed,
            };
            let response = card.show(ui, asked.markdown, |ui| {
                radio_mark(ui, vec2(16.0, CHOICE), on);
            });
            if response.clicked() {
                (self.chosen, asked.changed) = (Some(index), true);
            }
        }
        false
    }

    fn answer(&self, _: &Question, _: &Scene) -> Option<Answer> {
        self.chosen.map(Answer::Choice)
    }
}
