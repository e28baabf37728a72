//! One light's two terms: how strongly it arrives, and what the surface makes of it.

use super::notation::{Notation, Vectors};
use super::outline::{AT_PROBE, Line, Opening, Says, fold_ui};
use super::share::{Share, percent};
use super::table::{LEAST_SCALE, Table};
use super::working::working;
use crate::analysis::LightHere;
use crate::analysis::ZeroCause;
use crate::app::palette::Term;
use crate::app::state::AppState;
use crate::app::typeset::{Piece, Place, Run, run_ui, spoken};
use crate::scene::LightKind;
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Layout, RichText, Ui, WidgetInfo};

/// Size of the working's letters, points.
const WORKING: f32 = 15.0;

/// A light's part of the equation.
pub struct Part<'a> {
    pub light: LightHere<'a>,
    pub index: usize,
    pub notation: &'a Notation,
    pub shares: &'a [Share],
}

impl Part<'_> {
    /// The light's line, which unfolds to its terms.
    pub fn ui(&self, ui: &mut Ui, state: &mut AppState, opening: Opening) {
        let terms = self.light.terms;
        let silent = terms.why_nothing_in_short();
        let says = silent.map_or_else(|| Says::sum(terms.diffuse + terms.specular), |why| Says::Words(why.to_owned()));
        let colour = if silent.is_some() { self.notation.weak() } else { self.notation.strong() };
        let name = self.name();
        let line = Line { sign: "+", ..Line::new(&name, says, colour) };
        let sought = state.lit.seek;
        fold_ui(ui, &format!("light {}", self.index), &line, opening, |ui| match terms.why_nothing() {
            Some(why) => {
                ui.label(RichText::new(format!("It adds nothing: {why}.")).weak());
            }
            None => self.terms_ui(ui, state),
        });
        if state.lit.seek != sought {
            // A symbol of this light was clicked: its controls are this light's.
            state.light = self.index;
        }
    }

    fn name(&self) -> String {
        let (number, name) = (self.index + 1, self.light.source.name.trim());
        if name.is_empty() { format!("light {number}") } else { format!("{number} {name}") }
    }

    fn terms_ui(&self, ui: &mut Ui, state: &mut AppState) {
        let vectors = self.vectors();
        let id = ui.scope_id().with(("light at the probe", self.index));
        if let Some(note) = self.note() {
            ui.label(RichText::new(note).weak());
        }
        let lines = working(self.light, &vectors, self.notation);
        working_ui(ui, state, &lines.arriving, Place { id: id.with("arriving"), name: AT_PROBE });
        let terms = self.light.terms;
        let told_by_cosine = terms.specular_zero == ZeroCause::MissesViewer.into();
        let diffuse = (Term::Diffuse, "diffuse", terms.why_no_diffuse(), lines.diffuse, self.light.diffuse());
        let specular = (Term::Specular, "specular", terms.why_no_specular(), lines.specular, self.light.specular());
        for (term, name, zero, lines, product) in [diffuse, specular] {
            let place = Place { id: id.with(name), name: AT_PROBE };
            self.title_ui(ui, term, name);
            if zero.is_none() || told_by_cosine {
                working_ui(ui, state, &lines, Place { id: place.id.with("working"), ..place });
            }
            match zero {
                Some(why) => _ = ui.label(RichText::new(format!("0: {why}.")).weak()),
                None => {
                    let (name, colour) = (format!("{name} {}", self.index + 1), self.notation.term(term));
                    Table::new(&name, &product, self.notation, colour, &vectors).ui(ui, state, place);
                }
            }
        }
    }

    /// A term's name and its share of the pixel.
    fn title_ui(&self, ui: &mut Ui, term: Term, name: &str) {
        let whole: f64 = self.shares.iter().map(|share| share.weight).sum();
        let several = self.light.here.hit.lights.len() > 1;
        let full = if several { format!("{name} {}", self.index + 1) } else { name.to_owned() };
        let share = self.shares.iter().find(|share| share.name == full).and_then(|share| percent(share.weight, whole));
        ui.horizontal(|ui| {
            ui.label(RichText::new(name).color(self.notation.term(term)));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.label(RichText::new(share.unwrap_or_default()).weak());
            });
        });
    }

    /// What the line over a column means, where there is one.
    fn note(&self) -> Option<String> {
        let light = self.light;
        if light.is_one_product() {
            return None;
        }
        let places = if light.here.at_pixel() { None } else { Some(places(light.here.scene)) };
        let points =
            (light.source.kind == LightKind::Area).then(|| format!("{} points of the light", light.source.samples));
        let over = [points, places.map(str::to_owned)].into_iter().flatten().collect::<Vec<_>>().join(" and ");
        Some(format!("Evaluated at {over}; a bar over letters marks the mean."))
    }

    fn vectors(&self) -> Vectors {
        let (terms, hit) = (self.light.terms, self.light.here.hit);
        let exponent = crate::app::row::display(self.light.here.scene.material.n, 2);
        Vectors { n: hit.normal, l: terms.l, r: terms.r, v: hit.view, h: terms.h, exponent }
    }
}

/// Where the equation is evaluated, if not at the pixel.
pub fn places(scene: &crate::scene::Scene) -> &'static str {
    use crate::scene::{FlatAt, ShadingMode};
    match (scene.shading.mode, scene.shading.flat_at) {
        (ShadingMode::Flat, FlatAt::Centre) => "the polygon's centre",
        (ShadingMode::Flat, FlatAt::ProvokingVertex) => "the polygon's first vertex",
        _ => "the polygon's vertices",
    }
}

/// Lines of typeset formulas.
fn working_ui(ui: &mut Ui, state: &mut AppState, lines: &[Vec<Piece>], place: Place<'_>) {
    for (index, line) in lines.iter().enumerate() {
        ui.scope(|ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let width = Run::new(ui, line, WORKING).width();
            let size = WORKING * (ui.available_width() / width).clamp(LEAST_SCALE, 1.0);
            let run = run_ui(ui, state, line, size, Place { id: place.id.with(index), ..place });
            run.widget_info(|| WidgetInfo::labeled(Role::Label, true, spoken(line)));
        });
    }
}
