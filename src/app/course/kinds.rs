//! The widgets of questions, one file per kind.

mod card;
mod choice;
mod curve;
mod formula;
mod matching;
mod order;
mod point;
mod settings;
mod value;
mod widget;

#[cfg(target_arch = "wasm32")]
pub use matching::{Likeness, Target};
pub use widget::{Widget, WidgetContext};

use crate::lesson::{Answer, Kind};

/// Creates the widget of a question, with the previous answer; `seed` decides what is drawn at random.
pub fn widget_of(kind: &Kind, given: Option<&Answer>, seed: u64) -> Box<dyn Widget> {
    let mut widget: Box<dyn Widget> = match kind {
        Kind::Choice(_) => Box::new(choice::ChoiceWidget::default()),
        Kind::Value(_) => Box::new(value::ValueWidget::default()),
        Kind::Point(_) => Box::new(point::PointWidget::default()),
        Kind::Curve(_) => Box::new(curve::CurveWidget::default()),
        Kind::Settings(_) => Box::new(settings::SettingsWidget),
        Kind::Order(order) => Box::new(order::OrderWidget::new(order.items.len(), seed)),
        Kind::Formula(_) => Box::new(formula::FormulaWidget::default()),
        Kind::Match(_) => Box::new(matching::MatchWidget),
    };
    if let Some(given) = given {
        widget.take_up(given);
    }
    widget
}
