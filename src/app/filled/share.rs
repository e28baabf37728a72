//! What each term has in the pixel's brightness, as one bar.

use super::notation::Notation;
use crate::analysis::{Here, luminance};
use crate::app::palette::Term;
use eframe::egui::accesskit::Role;
use eframe::egui::{Color32, CornerRadius, FontId, Rect, Sense, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2};

/// Height of the bar, points.
const HEIGHT: f32 = 22.0;
/// Space between two parts, points: terms of one kind have one colour.
const GAP: f32 = 1.5;

/// One term's part.
#[derive(Clone, Debug)]
pub struct Share {
    /// In full.
    pub name: String,
    /// Where the full name does not fit.
    pub short: String,
    pub colour: Color32,
    /// Luminance, as it enters the pixel.
    pub weight: f64,
}

/// The parts of the pixel, in the order of the equation.
pub fn shares(here: Here<'_>, notation: &Notation) -> Vec<Share> {
    let hit = here.hit;
    // What fades at vertices has no s0 of its own for each term: all have that of their sum.
    let left = hit.cue.map_or(1.0, |cue| luminance(cue.kept) / luminance(hit.intensity).max(f64::MIN_POSITIVE));
    let opaque = left * if hit.transmission.is_some() { 1.0 - here.scene.transparency.kt } else { 1.0 };
    let part = |name: String, short: String, colour, value| Share {
        name,
        short,
        colour,
        weight: (opaque * luminance(value)).max(0.0),
    };
    let ambient = if hit.bounced { "one bounce" } else { "ambient" };
    let mut parts = vec![part(ambient.to_owned(), "a".to_owned(), notation.term(Term::Ambient), hit.ambient)];
    let several = hit.lights.len() > 1;
    for (index, light) in hit.lights.iter().enumerate() {
        let number = if several { format!(" {}", index + 1) } else { String::new() };
        let short = |letter| format!("{letter}{}", number.trim());
        parts.push(part(format!("diffuse{number}"), short("d"), notation.term(Term::Diffuse), light.diffuse));
        parts.push(part(format!("specular{number}"), short("s"), notation.term(Term::Specular), light.specular));
    }
    if let Some(through) = hit.transmission {
        let weight = left * here.scene.transparency.kt * luminance(through.seen);
        parts.push(Share { weight, ..part("through".into(), "t".into(), notation.through(), through.seen) });
    }
    if let Some(cue) = hit.cue {
        let weight = luminance(cue.veil);
        parts.push(Share { name: "fog".into(), short: "f".into(), colour: notation.weak(), weight });
    }
    parts
}

/// What `part` is of the whole, in words; nothing where there is no light.
pub fn percent(part: f64, whole: f64) -> Option<String> {
    if whole <= 0.0 {
        return None;
    }
    let share = 100.0 * part / whole;
    Some(if share > 0.0 && share < 0.1 { "< 0.1 %".to_owned() } else { format!("{share:.1} %") })
}

/// The bar. Each part is as long as its term is bright.
pub fn bar_ui(ui: &mut Ui, shares: &[Share]) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT), Sense::hover());
    let whole: f64 = shares.iter().map(|share| share.weight).sum();
    let seen: Vec<_> = shares.iter().filter(|share| share.weight > 0.0).collect();
    if seen.is_empty() {
        ui.painter().rect_stroke(rect, 4.0, Stroke::new(1.0, ui.visuals().weak_text_color()), StrokeKind::Inside);
        return;
    }
    let mut x = rect.min.x;
    for (index, share) in seen.iter().enumerate() {
        let width = (share.weight / whole) as f32 * rect.width();
        let space = if index + 1 < seen.len() { GAP.min(width * 0.5) } else { 0.0 };
        let place = Rect::from_min_max(pos2(x, rect.min.y), pos2(x + width - space, rect.max.y));
        part_ui(ui, share, place, whole);
        x += width;
    }
}

fn part_ui(ui: &Ui, share: &Share, place: Rect, whole: f64) {
    let text = format!("{}: {}", share.name, percent(share.weight, whole).unwrap_or_default());
    let response = ui.interact(place, ui.scope_id().with(("share", &share.name)), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
    ui.painter().rect_filled(place, CornerRadius::same(3), share.colour);
    let dark = ui.visuals().panel_fill;
    for name in [&share.name, &share.short] {
        let galley = ui.painter().layout_no_wrap(name.clone(), FontId::proportional(13.0), dark);
        if galley.size().x + 6.0 <= place.width() {
            ui.painter().galley(place.center() - galley.size() / 2.0, galley, dark);
            break;
        }
    }
    if response.hovered() {
        let stroke = Stroke::new(2.0, ui.visuals().strong_text_color());
        ui.painter().rect_stroke(place, CornerRadius::same(3), stroke, StrokeKind::Inside);
    }
    response.on_hover_text(format!("{text} of the pixel's luminance (Rec. 709)"));
}
