//! The profile along the line in the picture: the curves compared, the viewing conditions, and the plots.
//!
//! The view is in a side panel or, if it is wide, under the picture, where each point of the plot is right below its point in the
//! picture.

mod over;
mod plots;

pub use over::{paint, watch};

use super::report::export_ui;
use crate::analysis::codec::Codec;
use crate::analysis::perception::{Perception, ResponseModel, Viewing};
use crate::analysis::profile::{
    Compared, PERCEIVED_WIDTH, Profile, ProfileQuestion, TakenProfile, mode_dash, perceived_picture,
};
use crate::analysis::{Answer, Watch};
use crate::app::controls::row::{About, NumberRow, SliderRange, number};
use crate::app::engine::{Engine, image_of, upload};
use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::appearance::ViewName;
use crate::app::session::appearance::profile::ProfileAppearance;
use crate::app::session::document::Document;
use crate::app::session::place::Place;
use crate::app::session::window::WindowState;
use crate::app::widgets::background::wake;
use crate::app::widgets::drawing::{colour_of, plot_style};
use crate::app::widgets::focus::switch_named;
use crate::app::widgets::lines;
use crate::figure::{Dash, Ink, dashes};
use crate::jobs::{Background, Request, Work};
use crate::render::Frame;
use crate::scene::{Choice, Scene, ShadingMode};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Atom, Button, Context, Layout, Popup, PopupCloseBehavior, RichText, Stroke,
    TextureHandle, TextureOptions, Ui, vec2,
};
use glam::DVec2;
use plots::{Plots, Room};
use serde::{Deserialize, Serialize};

/// Width from which the controls are in a row above the plots, in points.
const WIDE: f32 = 620.0;
/// Height below which a narrow panel has the switches of the curves in a pop-up, in points.
const LOW: f32 = 420.0;
/// Length and height of the sample of a curve in its switch, and width of the controls in a pop-up, in points.
const SAMPLE: [f32; 2] = [24.0, 10.0];
const POPUP: f32 = 330.0;
/// Opacity of a sample whose curve is not shown.
const OFF: f32 = 0.45;

/// Shows the view of the profile.
pub fn profile_ui(
    ui: &mut Ui,
    profiles: &mut Profiles,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let own = session.shown.scene.shading.mode;
    window.appearance.profile.follow(own);
    let wide = ui.available_width() >= WIDE;
    // In a low panel the plots have the space.
    let low = !wide && ui.clip_rect().bottom() - ui.cursor().top() < LOW;
    if !low {
        if !wide {
            ui.label(text!("line-drag-ends"));
        }
        switches_ui(ui, own, window);
    }
    if wide {
        ui.horizontal(|ui| {
            profiles.plots.choice_ui(ui);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                popup_ui(ui, text!("line-save"), |ui| {
                    profiles.export_ui(ui, session, window, requests);
                });
                popup_ui(ui, text!("line-viewing"), |ui| eye_ui(ui, window));
                perceived_ui(ui, &mut window.appearance.profile);
            });
        });
    } else {
        ui.horizontal_wrapped(|ui| {
            if low {
                popup_ui(ui, text!("line-curves"), |ui| switches_ui(ui, own, window));
            } else {
                perceived_ui(ui, &mut window.appearance.profile);
            }
            popup_ui(ui, text!("line-viewing"), |ui| {
                if low {
                    perceived_ui(ui, &mut window.appearance.profile);
                }
                eye_ui(ui, window);
            });
            popup_ui(ui, text!("line-save"), |ui| {
                profiles.export_ui(ui, session, window, requests);
            });
        });
    }
    let size = engine.size;
    if size.contains(&0) {
        return;
    }
    let question = window
        .appearance
        .profile
        .request(window.line.pixels(size), own);
    if window.appearance.profile.perceived {
        profiles.ask_perceived(ui.ctx(), &session.shown, size, &question);
        if let Some(Err(why)) = profiles.seen.known() {
            ui.label(RichText::new(why).weak());
        }
    }
    profiles.ask(ui.ctx(), &session.shown, size, &question);
    profiles.plots_ui(ui, &window.appearance.profile, own, wide);
}

/// The profile last taken with its plots, and the picture as it is perceived.
#[derive(Default)]
pub struct Profiles {
    taken: Background<Request<ProfileQuestion>>,
    plots: Plots,
    seen: Background<Perceived>,
    /// The whole picture as it is perceived.
    pub perceived: Option<TextureHandle>,
    /// Place where the picture was last shown.
    picture: Option<Place>,
    /// True if the plots are right under the line.
    aligned: bool,
    /// Fraction of the line that the pointer is at: in a plot, and in the picture.
    pointed: [Option<f64>; 2],
}

#[derive(Serialize, Deserialize)]
pub struct Perceived(Request<ProfileQuestion>);

impl Work for Perceived {
    type Answer = Frame;

    const CODECS: Option<(Codec<Self>, Codec<Frame>)> = Some((Codec::plain(), Codec::plain()));

    fn run(&self, _: &dyn Watch<Frame>) -> Result<Frame, String> {
        let ProfileQuestion {
            viewing,
            perception,
            ..
        } = &self.0.question;
        let [_, widest] = perception.widths(viewing.pixels_per_degree());
        if widest > PERCEIVED_WIDTH {
            return Err(text!(
                "line-error-surround",
                width = format!("{widest:.0}"),
                most = PERCEIVED_WIDTH.to_string()
            ));
        }
        let subject = self.0.subject();
        Ok(perceived_picture(
            &mut subject.renderer(),
            &subject.scene,
            viewing,
            perception,
        ))
    }
}

impl Profiles {
    /// Takes the profile in the background. Until it is ready, the last one is shown.
    fn ask(
        &mut self,
        ctx: &Context,
        document: &Document,
        size: [u32; 2],
        question: &ProfileQuestion,
    ) {
        let (scene, model) = (&document.scene, document.model.as_ref());
        let same = |asked: &Request<ProfileQuestion>| asked.is(question, scene, model, size);
        let new = self.taken.ask(wake(ctx), same, || {
            Request::new(question.clone(), scene, model, size)
        });
        if new {
            self.plots.forget();
        }
    }

    /// Computes the perceived picture in the background. Until it is ready, the last one is shown.
    fn ask_perceived(
        &mut self,
        ctx: &Context,
        document: &Document,
        size: [u32; 2],
        question: &ProfileQuestion,
    ) {
        // The whole picture does not depend on the line.
        let question = ProfileQuestion {
            from: DVec2::ZERO,
            to: DVec2::ZERO,
            modes: vec![],
            ..question.clone()
        };
        let (scene, model) = (&document.scene, document.model.as_ref());
        let same = |seen: &Perceived| seen.0.is(&question, scene, model, size);
        let work = || Perceived(Request::new(question.clone(), scene, model, size));
        if self.seen.ask(wake(ctx), same, work) {
            match self.seen.answer().map(image_of) {
                Some(image) => {
                    let options = TextureOptions::NEAREST;
                    upload(ctx, &mut self.perceived, "perceived", image, options);
                }
                None => self.perceived = None,
            }
            ctx.request_repaint();
        }
    }

    /// Returns whether the perceived picture is being computed.
    pub fn is_perceiving(&self) -> bool {
        self.seen.progress().is_some()
    }

    /// Returns the profile last taken.
    pub fn profile(&self) -> Option<&Profile> {
        self.taken.answer().map(|taken| &taken.profile)
    }

    /// Returns the fraction of the line that the pointer is at, in a plot or in the picture.
    pub fn pointed(&self) -> Option<f64> {
        self.pointed[0].or(self.pointed[1])
    }

    fn latest(&self) -> Option<(Box<dyn Answer>, Scene)> {
        let answer = self.taken.answer()?.clone();
        Some((Box::new(answer), self.taken.answered()?.subject().scene))
    }

    fn export_ui(
        &self,
        ui: &mut Ui,
        session: &mut Session,
        window: &mut WindowState,
        requests: &mut Requests,
    ) {
        if export_ui(ui, session, window, requests, "profile", || self.latest()) {
            ui.close();
        }
    }

    fn plots_ui(
        &mut self,
        ui: &mut Ui,
        appearance: &ProfileAppearance,
        own: ShadingMode,
        wide: bool,
    ) {
        let taken: &TakenProfile = match self.taken.known() {
            Some(Ok(taken)) => taken,
            Some(Err(why)) => {
                ui.label(why);
                return;
            }
            None => {
                ui.label(text!("line-working"));
                return;
            }
        };
        let view = |abscissa| Compared {
            own,
            abscissa,
            edges: appearance.edges,
            perceived: appearance.brightness,
        };
        let room = Room {
            picture: self.picture,
            wide,
        };
        let before = self.pointed[0];
        let pointed = self.pointed();
        (self.pointed[0], self.aligned) = self.plots.ui(ui, taken, &view, room, pointed);
        // The picture may have been painted before the plots.
        if self.pointed[0] != before {
            ui.ctx().request_repaint();
        }
    }
}

/// Shows a switch for each curve and for the marks of edges. The switches are the plots' legend.
fn switches_ui(ui: &mut Ui, own: ShadingMode, window: &mut WindowState) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let appearance = &mut window.appearance.profile;
        for &mode in ShadingMode::VALUES {
            let (is_own, added) = (mode == own, appearance.added.contains(&mode));
            let tip = if is_own {
                text!("line-mode-own")
            } else {
                text!("line-mode-added")
            };
            let sample = Sample {
                ink: Ink::Shading(mode),
                dash: mode_dash(mode, is_own),
                width: if is_own { 2.6 } else { 1.7 },
            };
            let clicked = switch_ui(ui, mode.label(), tip, is_own || added, sample);
            if clicked && !is_own {
                if added {
                    appearance.added.retain(|other| *other != mode);
                } else {
                    appearance.added.push(mode);
                }
            }
        }
        let perceived = Sample {
            ink: Ink::Perceived,
            dash: Dash::Dashed,
            width: 1.7,
        };
        let name = text!("line-perceived-switch");
        let tip = text!("line-perceived-switch.tip");
        appearance.brightness ^= switch_ui(ui, name, tip, appearance.brightness, perceived);
        let edges = Sample {
            ink: Ink::Reference,
            dash: Dash::Dashed,
            width: 1.2,
        };
        let tip = text!("line-edges-switch.tip");
        appearance.edges ^= switch_ui(ui, text!("line-edges-switch"), tip, appearance.edges, edges);
    });
}

/// Style of a curve's sample.
struct Sample {
    ink: Ink,
    dash: Dash,
    width: f32,
}

/// Shows a switch with the sample of a curve, and returns whether it was clicked.
fn switch_ui(ui: &mut Ui, name: &str, tip: &str, on: bool, sample: Sample) -> bool {
    let paper = plot_style(ui).paper;
    let strength = if on { 1.0 } else { OFF };
    let colour = colour_of(paper.line(sample.ink), f64::from(strength));
    let (width, dash) = (sample.width, dashes(sample.dash));
    let line = Atom::paint(vec2(SAMPLE[0], SAMPLE[1]), move |ui, place| {
        let ends = [place.rect.left_center(), place.rect.right_center()];
        let dash: Vec<f32> = dash.iter().map(|length| length * width).collect();
        let stroke = Stroke::new(width, colour);
        lines::line(ui.painter(), ends.map(lines::exact), stroke, &dash);
    });
    let visuals = ui.visuals();
    let (text, outline) = if on {
        (visuals.strong_text_color(), visuals.weak_text_color())
    } else {
        (visuals.weak_text_color(), visuals.window_stroke.color)
    };
    let button = Button::new((line, RichText::new(name).color(text)))
        .fill(visuals.panel_fill)
        .stroke(Stroke::new(1.0, outline));
    let response = ui.add(button).on_hover_text(tip);
    switch_named(response, Role::CheckBox, on, name).clicked()
}

fn perceived_ui(ui: &mut Ui, appearance: &mut ProfileAppearance) {
    ui.checkbox(&mut appearance.perceived, text!("line-picture-perceived"))
        .on_hover_text(text!("line-picture-perceived.tip"));
}

/// Shows a button that opens controls.
fn popup_ui(ui: &mut Ui, name: &str, controls: impl FnOnce(&mut Ui)) {
    let button = ui.button(format!("{name} ▾"));
    Popup::menu(&button)
        .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| {
            ui.set_width(POPUP);
            controls(ui);
        });
}

/// Shows the distance and resolution of the screen, and the parameters of the eye.
fn eye_ui(ui: &mut Ui, window: &mut WindowState) {
    let profile = &mut window.appearance.profile;
    let (viewing, perception) = (&mut profile.viewing, &mut profile.perception);
    ui.horizontal_wrapped(|ui| {
        let names = [
            text!("line-model-inhibition"),
            text!("line-model-normalisation"),
        ];
        for (model, name) in ResponseModel::ALL.into_iter().zip(names) {
            ui.selectable_value(&mut perception.model, model, name);
        }
    });
    let (usual, eye) = (Viewing::default(), Perception::default());
    row_ui(
        ui,
        [text!("line-distance"), text!("line-distance.tip")],
        Viewing::DISTANCE,
        usual.distance,
        &mut viewing.distance,
    );
    row_ui(
        ui,
        [text!("line-density"), text!("line-density.tip")],
        Viewing::DENSITY,
        usual.density,
        &mut viewing.density,
    );
    row_ui(
        ui,
        [text!("line-centre"), text!("line-centre.tip")],
        Perception::WIDTH,
        eye.centre,
        &mut perception.centre,
    );
    row_ui(
        ui,
        [text!("line-surround"), text!("line-surround.tip")],
        Perception::WIDTH,
        eye.surround,
        &mut perception.surround,
    );
    row_ui(
        ui,
        [text!("line-strength"), text!("line-strength.tip")],
        [0.01, Perception::WEIGHT[1]],
        eye.weight,
        &mut perception.weight,
    );
}

fn row_ui(
    ui: &mut Ui,
    [label, tip]: [&str; 2],
    [low, high]: [f64; 2],
    default: f64,
    value: &mut f64,
) {
    let about = About {
        label,
        tip,
        ..About::default()
    };
    let range = SliderRange {
        limits: low..=high,
        ..SliderRange::logarithmic(low..=high)
    };
    let row = NumberRow {
        about,
        range,
        default,
    };
    number(ui, &row, value);
}

/// Returns whether the picture is to be shown as it is perceived.
pub fn shows_perceived(window: &WindowState) -> bool {
    window.shows(ViewName::Profile) && window.appearance.profile.perceived
}
