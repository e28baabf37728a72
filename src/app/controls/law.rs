//! The editor of a scene's own law: a field of several lines, its names and signs as buttons, the formula as textbooks set it,
//! and what is wrong with it.
//!
//! The scene holds only formulas that can be read. A text with an error is a draft: it stays in the editor, and the picture stays
//! as it was. Whatever else brings the scene another formula, or another scene, replaces the draft.

use super::row::{About, row};
use crate::app::session::Session;
use crate::app::system;
use crate::app::widgets::focus::{named, one_stop, resets};
use crate::app::widgets::formula_field::{FormulaField, set_ui, wants_signs};
use crate::app::widgets::typeset::letter;
use crate::expression::{Formula, FormulaError};
use crate::lesson::FORMULA_SIGNS;
use crate::scene::material::{COLOR, FORMULA, IOR, KA, KD, KS, N, ROUGHNESS, SPECULAR_COLOR};
use crate::scene::parameter::Parameter;
use crate::scene::{Compare, LAW_NUMBERS, LAW_VECTORS, Reflection};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, Key, KeyboardShortcut, Label, Modifiers, RichText, Ui, Visuals};

/// Lines of an empty editor.
const LINES: usize = 3;
/// Most characters of the formula in the row of a scene with another model.
const PREVIEW: usize = 18;
/// Signs that lines with names need besides those of a question.
const MORE_SIGNS: [&str; 2] = ["=", ","];
/// The material's numbers in a formula.
static NUMBERS: [(&str, &Parameter); 8] = [
    ("ka", &KA),
    ("kd", &KD),
    ("ks", &KS),
    ("od", &COLOR),
    ("os", &SPECULAR_COLOR),
    ("n", &N),
    ("m", &ROUGHNESS),
    ("eta", &IOR),
];

/// The text in an editor.
#[derive(Clone, Debug, Default)]
struct Draft {
    text: String,
    /// The scene's formula when it last agreed with the text or replaced it.
    of: String,
    /// The scene that the text belongs to: how many it has replaced, and the pane.
    scene: Option<(u64, usize)>,
}

impl Draft {
    /// Takes over the formula of a scene that is another, or has got another formula, than when the text was typed. Returns
    /// whether it did.
    fn follow(&mut self, session: &Session) -> bool {
        let reflection = &session.shown.scene.reflection;
        let scene = Some((session.replacements(), session.panes.active));
        // The draft of a formula that is not in use is dropped.
        let same = self.scene == scene && self.of == reflection.formula;
        if same && reflection.is_own_law() {
            return false;
        }
        self.text.clone_from(&reflection.formula);
        self.of.clone_from(&reflection.formula);
        self.scene = scene;
        true
    }

    /// Reads the text.
    fn read(&self) -> Result<Formula, FormulaError> {
        Formula::read(&self.text, &Reflection::law_names())
    }

    /// Gives the scene the text, if it can be read.
    fn put(&mut self, session: &mut Session) {
        if self.text != self.of && self.read().is_ok() {
            self.of.clone_from(&self.text);
            let reflection = &mut session.shown.scene.reflection;
            reflection.formula.clone_from(&self.text);
        }
    }
}

/// Shows the row of the formula, and the editor below it where the formula is in use.
pub fn law_ui(ui: &mut Ui, session: &mut Session) {
    let scene = &session.shown.scene;
    let (idle, own) = (FORMULA.idle(scene, 0), scene.reflection.is_own_law());
    let field = FormulaField {
        id: ui.scope_id().with("law"),
        name: FORMULA.name(),
        hint: text!("controls-law-hint"),
        rows: LINES,
        longest: Reflection::MOST_CHARACTERS,
        new_line: KeyboardShortcut::new(Modifiers::NONE, Key::Enter),
    };
    let id = field.id.with("draft");
    let mut draft: Draft = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    if draft.follow(session) {
        field.forget_typed(ui.ctx());
    }
    let opened = session.initial.reflection.formula.clone();
    let about = About {
        label: FORMULA.label(),
        name: FORMULA.name(),
        tip: FORMULA.help(),
        symbol: FORMULA.symbol,
        parameter: Some(&FORMULA),
        idle,
        ..About::default()
    };
    let mut reset = row(ui, &about, draft.text != opened, |ui| {
        if !own {
            ui.add(Label::new(RichText::new(preview(&draft.text)).monospace()));
        }
    });
    if own {
        let body = ui.add_enabled_ui(idle.is_none(), |ui| {
            editor_ui(ui, &field, &mut draft);
            beside_ui(ui, session);
        });
        reset |= resets(ui, body.response.rect);
    }
    if reset {
        draft.text = opened;
    }
    draft.put(session);
    ui.data_mut(|data| data.insert_temp(id, draft));
}

/// Returns the beginning of a formula.
fn preview(formula: &str) -> String {
    let line = formula.lines().next().unwrap_or_default();
    let start: String = line.chars().take(PREVIEW).collect();
    if start.len() < formula.len() {
        start + "…"
    } else {
        start
    }
}

/// Shows the field and what belongs to its text.
fn editor_ui(ui: &mut Ui, field: &FormulaField<'_>, draft: &mut Draft) {
    let response = field.ui(ui, &mut draft.text);
    if response.changed() {
        let kept = |c: char| !c.is_control() || matches!(c, '\n' | '\t');
        draft.text.retain(kept);
    }
    // With fingers, what keyboards hide stands next to the field, and the names below what is said of the text.
    let hand = wants_signs(ui.ctx(), system::fingers(ui.ctx()));
    if hand {
        let signs = FORMULA_SIGNS.into_iter().chain(MORE_SIGNS);
        keys_ui(ui, field, draft, LAW_VECTORS.into_iter().chain(signs));
    } else {
        keys_ui(ui, field, draft, LAW_NUMBERS.into_iter().chain(LAW_VECTORS));
    }
    let error = draft.read().err();
    let empty = draft.text.trim().is_empty();
    set_ui(ui, &draft.text, error.as_ref().filter(|_| !empty));
    if error.is_some() {
        let words = RichText::new(text!("controls-law-kept")).weak();
        ui.add(Label::new(words).wrap());
    }
    if hand {
        keys_ui(ui, field, draft, LAW_NUMBERS.into_iter());
    }
}

/// Shows buttons that put a name or a sign into the field, as one stop of Tab.
fn keys_ui(
    ui: &mut Ui,
    field: &FormulaField<'_>,
    draft: &mut Draft,
    keys: impl Iterator<Item = &'static str>,
) {
    let visuals = ui.visuals().clone();
    let row = ui.horizontal_wrapped(|ui| {
        let spacing = ui.spacing_mut();
        spacing.item_spacing.x = 4.0;
        spacing.button_padding.x = if spacing.interact_size.y > 30.0 {
            10.0
        } else {
            4.0
        };
        field.keys_ui(ui, &mut draft.text, keys, &|key| meaning(&visuals, key))
    });
    one_stop(ui, row.response.rect);
}

/// Returns the meaning of a name in a law, or an empty text for a sign.
fn meaning(visuals: &Visuals, name: &str) -> String {
    if let Some((_, parameter)) = NUMBERS.iter().find(|(number, _)| *number == name) {
        return parameter.full_name(0);
    }
    if let Some((a, b)) = name.split_once('·').filter(|(a, _)| !a.is_empty()) {
        return text!("controls-law-product", a = a, b = b);
    }
    match name {
        "d" => text!("controls-law-distance").to_owned(),
        "theta" => text!("controls-law-theta").to_owned(),
        "phi" => text!("controls-law-phi").to_owned(),
        _ if LAW_VECTORS.contains(&name) => letter(visuals, name)
            .and_then(|piece| piece.symbol)
            .map_or_else(String::new, |symbol| symbol.meaning().to_owned()),
        _ => String::new(),
    }
}

/// Shows the button that compares the law with Phong's.
fn beside_ui(ui: &mut Ui, session: &mut Session) {
    let full = session.document().scene.compare.panes.len() >= Compare::MAX_PANES;
    let button = ui.add_enabled(!full, Button::new(text!("controls-law-beside")));
    let most = text!("picture-panes-full", count = Compare::MAX_PANES + 1);
    let button = button
        .on_hover_text(text!("controls-law-beside.tip"))
        .on_disabled_hover_text(most);
    if named(button, Role::Button, text!("controls-law-beside")).clicked() {
        session.compare_with_phong();
    }
}
