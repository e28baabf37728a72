//! Controls found by name, for figures on other pages and for steps of lessons.

use super::law::law_ui;
use super::row::{RowOptions, parameter_with};
use crate::app::session::Session;
use crate::scene::parameter::{Kind, Parameter};
use crate::scene::{LightKind, light};
use crate::text::text;
use eframe::egui::{RichText, Ui};

/// Minimum width of a column of controls, in points, and the maximum number of columns.
const COLUMN: f32 = 290.0;
const MOST_COLUMNS: usize = 3;

/// A control that a word names.
#[derive(Clone, Copy, Debug)]
pub enum Named {
    /// The row of a parameter, for the light with the given index or the chosen one.
    Row(&'static Parameter, Option<usize>),
    /// The position of the chosen light, or its direction.
    Light,
}

impl PartialEq for Named {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Row(a, _), Self::Row(b, _)) => a.key == b.key,
            (Self::Light, Self::Light) => true,
            _ => false,
        }
    }
}

impl Named {
    /// Finds the control of a parameter by its key, such as `material.n`, or by the key's last word, such as `n`.
    ///
    /// `light` stands for the position or direction of the chosen light.
    pub fn find(word: &str) -> Option<Self> {
        if word == "light" {
            return Some(Self::Light);
        }
        Parameter::of_key(word)
            .or_else(|| Some((Parameter::by_word(word)?, None)))
            .map(|(parameter, index)| Self::Row(parameter, index))
    }
}

/// Shows a row for each control, in several columns if the width allows. A row that waits for the answer to the open question
/// says so. If `wide`, there is one column, and a slider has a line of its own.
pub fn rows_ui(ui: &mut Ui, session: &mut Session, controls: &[Named], wide: bool) {
    let count = ((ui.available_width() / COLUMN) as usize)
        .min(if wide { 1 } else { controls.len() })
        .clamp(1, MOST_COLUMNS);
    ui.columns(count, |columns| {
        for (index, control) in controls.iter().enumerate() {
            row_ui(&mut columns[index % count], session, *control, wide);
        }
    });
}

fn row_ui(ui: &mut Ui, session: &mut Session, control: Named, wide: bool) {
    let lights = &session.shown.scene.lights;
    let last = lights.len().saturating_sub(1);
    let chosen = session.light.min(last);
    let kind = lights.get(chosen).map(|light| light.kind);
    let (parameter, index) = match control {
        Named::Row(parameter, index) => (parameter, index.unwrap_or(chosen).min(last)),
        Named::Light if kind == Some(LightKind::Directional) => (&light::DIRECTION, chosen),
        Named::Light => (&light::POSITION, chosen),
    };
    let options = RowOptions {
        index,
        wide,
        numbered: last > 0 && matches!(control, Named::Row(_, Some(_))),
        // Away from the ground's other rows, only the full label says whose coefficient it is.
        in_full: parameter.section() == "ground",
        ..RowOptions::default()
    };
    let lock = session.lock.as_ref();
    let free = lock.is_none_or(|lock| lock.frees(parameter, index));
    ui.add_enabled_ui(free, |ui| {
        if let Kind::Lines(..) = parameter.kind {
            law_ui(ui, session);
        } else {
            let Session { initial, shown, .. } = session;
            parameter_with(ui, initial, &mut shown.scene, parameter, &options);
        }
    });
    if !free {
        ui.label(RichText::new(text!("course-after-answer")).weak().small());
    }
}
