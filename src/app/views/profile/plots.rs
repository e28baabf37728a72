//! The plots of a profile in the window.
//!
//! A narrow panel shows them below one another. A wide one shows as many as its height holds, over an axis right under the
//! picture if the line is level.

use crate::analysis::profile::{Abscissa, Compared, Profile, TakenProfile, compared_plots};
use crate::app::session::place::Place;
use crate::app::widgets::drawing::{boxed, colour_of, drawing_ui, plot_style};
use crate::app::widgets::lines;
use crate::figure::{Drawing, Plot, PlotStyle, Text, lay_out_column, short};
use crate::text::{Language, language, text};
use eframe::egui::{Label, Pos2, Rect, RichText, Sense, Stroke, TextStyle, Ui, pos2, vec2};
use glam::DVec2;

/// Maximum ratio of rise to run of a level line.
const LEVEL: f64 = 0.05;
/// Minimum width of the part of a picture that a plot is aligned with, in pixels.
const LEAST_PIXELS: f64 = 16.0;
/// Height of a plot in a narrow panel: a fraction of its width, and a number of letters' heights.
const ASPECT: [f64; 2] = [0.5, 5.5];
/// Minimum height of a plot, in points.
const LEAST: f32 = 96.0;
/// Minimum height of a wide pane whose plots have headings, in points.
const HEADED: f32 = 260.0;
/// Minimum height of a wide pane that holds all plots, in points.
const ALL: f32 = 480.0;
/// Space between two plots, in points.
const GAP: f32 = 8.0;

/// Placement of the plots in the window.
#[derive(Clone, Copy)]
pub struct Room {
    /// Place where the picture was last shown.
    pub picture: Option<Place>,
    pub wide: bool,
}

/// The plots as last laid out.
#[derive(Default)]
pub struct Plots {
    plots: Vec<Plot>,
    drawings: Vec<Drawing>,
    laid_out: Option<Key>,
    /// True if only one plot fits, the `chosen` one.
    single: bool,
    chosen: usize,
}

/// Everything that a layout depends on besides the profile.
#[derive(Clone, Copy, PartialEq)]
struct Key {
    view: Compared,
    style: PlotStyle,
    size: [f32; 2],
    span: Option<[f64; 2]>,
    language: Language,
}

impl Plots {
    /// Discards the layout, because the profile has changed.
    pub fn forget(&mut self) {
        self.laid_out = None;
    }

    /// Shows the plots, with a line across them at `pointed`, a fraction of the profile's line.
    ///
    /// Returns the fraction that the pointer is at, and whether the plots are right under the line.
    pub fn ui(
        &mut self,
        ui: &mut Ui,
        taken: &TakenProfile,
        view: &dyn Fn(Abscissa) -> Compared,
        room: Room,
        pointed: Option<f64>,
    ) -> (Option<f64>, bool) {
        let rect = ui.available_rect_before_wrap();
        let under = room
            .picture
            .filter(|picture| room.wide && is_under(ui.clip_rect(), picture));
        let aligned = under.and_then(|picture| aligned(&picture, rect, &taken.profile));
        let (abscissa, span) = match aligned {
            Some((pixels, span)) => (Abscissa::PictureX(pixels), Some(span)),
            None => (Abscissa::Distance, None),
        };
        let style = plot_style(ui);
        let below = ui.clip_rect().bottom() - ui.cursor().top();
        let all = !room.wide || below >= ALL;
        self.single = !all;
        let heading = ui.text_style_height(&TextStyle::Body) + ui.spacing().item_spacing.y;
        let headed = all || below >= HEADED;
        let width = rect.width();
        let height = if room.wide {
            let count = if all { 3.0 } else { 1.0 };
            let head = if headed { heading } else { 0.0 };
            (below / count - head - GAP).max(LEAST)
        } else {
            width * ASPECT[0] as f32 + (ASPECT[1] * style.text) as f32
        };
        let key = Key {
            view: view(abscissa),
            style,
            size: [width, height],
            span,
            language: language(),
        };
        self.lay_out(taken, key);
        let mut hovered = None;
        for index in 0..self.plots.len() {
            if self.single && index != self.chosen {
                continue;
            }
            if headed {
                heading_ui(ui, &self.plots[index], room.wide);
            }
            let first = self.single || index == 0;
            let at = self.plot_ui(ui, index, &taken.profile, abscissa, (pointed, first));
            hovered = hovered.or(at);
            if all {
                ui.add_space(GAP);
            }
        }
        if !room.wide {
            ui.label(RichText::new(text!("line-phong-bands")).weak());
        }
        (hovered, aligned.is_some())
    }

    /// Shows the choice of the plot if only one fits.
    pub fn choice_ui(&mut self, ui: &mut Ui) {
        if !self.single {
            return;
        }
        ui.spacing_mut().item_spacing.x = 4.0;
        let names = [
            text!("line-plot-intensity"),
            text!("line-plot-slope"),
            text!("line-plot-added"),
        ];
        for (index, name) in names.into_iter().enumerate() {
            let tip = self
                .plots
                .get(index)
                .map(|plot| format!("{}. {}", plot.title, plot.note));
            ui.selectable_value(&mut self.chosen, index, name)
                .on_hover_text(tip.unwrap_or_default());
        }
    }

    fn lay_out(&mut self, taken: &TakenProfile, key: Key) {
        if self.laid_out == Some(key) {
            return;
        }
        self.laid_out = Some(key);
        let TakenProfile { profile, question } = taken;
        self.plots = compared_plots(profile, question, key.view).into();
        let size = DVec2::from_array(key.size.map(f64::from));
        // The note is beside the title.
        let bare = self.plots.iter().map(|plot| Plot {
            note: String::new(),
            ..plot.clone()
        });
        self.drawings = lay_out_column(&bare.collect::<Vec<_>>(), size, key.span, &key.style);
    }

    /// Shows one plot, and the values of all curves at the pointer, on the plot or on the line in the picture.
    ///
    /// Returns the fraction of the line that the pointer is at on the plot.
    fn plot_ui(
        &self,
        ui: &mut Ui,
        index: usize,
        profile: &Profile,
        abscissa: Abscissa,
        (pointed, first): (Option<f64>, bool),
    ) -> Option<f64> {
        let (plot, drawing) = (&self.plots[index], self.drawings.get(index)?);
        let words = || format!("{}; {}; {}", plot.title, plot.y.name, plot.x.name);
        let (response, painter) = drawing_ui(ui, drawing, Sense::hover(), words)?;
        let origin = response.rect.min;
        let pointer = response.hover_pos();
        let x = pointer.and_then(|at| drawing.x_at(lines::exact(at) - lines::exact(origin)));
        let hovered = x.map(|x| abscissa.share(profile, x));
        let share = hovered.or(pointed)?;
        let x = abscissa.at(profile, share);
        if !(plot.x.low..=plot.x.high).contains(&x) {
            return hovered;
        }
        let (_, ends) = drawing.place([x, plot.y.low])?;
        let on_screen = |at: DVec2| origin + vec2(at.x as f32, at.y as f32);
        let stroke = Stroke::new(1.0, ui.visuals().text_color());
        painter.line_segment(ends.map(on_screen), stroke);
        let style = plot_style(ui);
        let here = match abscissa {
            Abscissa::Distance => text!("line-pixels", value = short(x)),
            Abscissa::PictureX(_) => format!("x = {}", short(x)),
        };
        let mut values = vec![Text::new(here, DVec2::ZERO, style.text, style.paper.text)];
        for curve in &plot.curves {
            let Some(y) = curve.at(x) else { continue };
            let words = text!("line-value", name = curve.name.as_str(), value = short(y));
            let colour = style.paper.letters(curve.ink);
            values.push(Text::new(words, DVec2::ZERO, style.text, colour));
            let Some((at, [foot, top])) = drawing.place([x, y]) else {
                continue;
            };
            if (top.y..=foot.y).contains(&at.y) {
                let colour = colour_of(style.paper.line(curve.ink), 1.0);
                painter.circle_filled(on_screen(at), 3.0, colour);
            }
        }
        let beside: Option<Pos2> = if hovered.is_some() {
            pointer
        } else {
            // The values at a position in the picture are shown once.
            first.then(|| {
                let [foot, top] = ends.map(on_screen);
                pos2(foot.x, 0.5 * (foot.y + top.y))
            })
        };
        if let Some(at) = beside {
            boxed(ui, &painter, &values, (response.rect, at));
        }
        hovered
    }
}

/// Shows a plot's title and note, side by side if `wide`.
fn heading_ui(ui: &mut Ui, plot: &Plot, wide: bool) {
    let title = RichText::new(&plot.title).strong();
    let note = RichText::new(&plot.note).weak();
    if wide {
        ui.horizontal(|ui| {
            ui.label(title);
            ui.add(Label::new(note).truncate());
        });
        return;
    }
    ui.label(title);
    if !plot.note.is_empty() {
        ui.label(note);
    }
}

/// Returns whether a pane lies below the picture.
fn is_under(pane: Rect, picture: &Place) -> bool {
    let Place { rect, .. } = picture;
    pane.top() >= rect.bottom() - 1.0 && pane.x_range().intersects(rect.x_range())
}

/// Returns the range of pixels right above a pane, and their positions in the pane, for a level line.
fn aligned(picture: &Place, pane: Rect, profile: &Profile) -> Option<([f64; 2], [f64; 2])> {
    let (from, to) = (profile.samples.first()?, profile.samples.last()?);
    let (run, rise) = ((to.x - from.x).abs(), (to.y - from.y).abs());
    if rise > LEVEL * run {
        return None;
    }
    let sides = [pane.left_top(), pane.right_top()].map(|side| picture.pixel(side).x);
    let low = from.x.min(to.x).max(sides[0]);
    let high = from.x.max(to.x).min(sides[1]);
    let left = f64::from(pane.left());
    let span = [low, high].map(|x| picture.exact_point(DVec2::new(x, 0.0)).x - left);
    (high - low >= LEAST_PIXELS).then_some(([low, high], span))
}
