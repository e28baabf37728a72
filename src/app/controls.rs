//! The panel of controls: sections of rows, in the order of the equation.
//!
//! A row belongs to a parameter or is a control of its own.

mod law;
mod lights;
pub mod materials;
mod model;
pub mod named;
mod object;
pub mod row;
pub mod sampling;
pub mod scenes;
pub mod vertices;

use super::engine::Engine;
use crate::analysis::report::grouped;
use crate::app::controls::materials::{gallery_ui, matching_ui};
use crate::app::controls::row::{About, RowOptions, parameter_with, row};
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::appearance::ViewName;
use crate::app::session::window::WindowState;
use crate::app::widgets::focus::{keep_in_sight, named};
use crate::app::widgets::symbol::{self, Sought, Symbol};
use crate::scene::parameter::{Parameter, Slider};
use crate::scene::{
    AmbientSource, Camera, Choice, CuedBy, DepthCueing, Display, GREATEST_LENGTH, Light, Object,
    ObjectKind, PatternKind, Reflectance, ReflectionModel, Rgb, Scene, Shading, ShadingMode,
    camera, material, shading, surroundings,
};
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::collapsing_header::CollapsingState;
use eframe::egui::{
    Button, CollapsingHeader, Id, Label, Popup, PopupAnchor, PopupCloseBehavior, Rect, RichText,
    ScrollArea, Tooltip, Ui,
};

/// Width of a column of sections, in points. A wide panel has several columns.
const COLUMN: f32 = 320.0;
const MOST_COLUMNS: usize = 3;
/// Width of the slider below a letter of the equation, in points.
const CONTROL: f32 = 300.0;
/// Field of view above which perspective distorts, in degrees.
const WIDE: f64 = 60.0;

/// A part of a section.
enum Item {
    Rows(&'static [&'static Parameter]),
    /// Rows shown only while they have an effect.
    Used(&'static [&'static Parameter]),
    /// Rows shown only while the condition holds.
    While(fn(&Scene) -> bool, &'static [&'static Parameter]),
    Own(fn(&mut Ui, &mut Session, &mut WindowState, &mut Requests, &Engine)),
    /// Items that edit the chosen material, which may be a model's.
    Chosen(&'static [Item]),
}

use Item::{Chosen, Own, Rows, Used, While};

/// A foldable part of the panel.
struct Section {
    /// Key of the title.
    title: &'static str,
    /// Predicate for the scenes that the section is about.
    about: fn(&Scene) -> bool,
    /// Rule for opening the section with a scene.
    open: Open,
    /// Symbols of the equation that open the section.
    symbols: &'static [Symbol],
    /// Tables of the scene file whose keys all belong to the section.
    tables: &'static [&'static str],
    items: &'static [Item],
}

impl Section {
    /// Returns whether the section has this control.
    fn has(&self, sought: Sought) -> bool {
        match sought {
            Sought::Symbol(symbol) => self.symbols.contains(&symbol),
            Sought::Parameter(key) => {
                let table = key.split('.').next().unwrap_or_default();
                self.tables.contains(&table) || self.items.iter().any(|item| item.has(key))
            }
        }
    }
}

impl Item {
    /// Returns whether the item is a row of the parameter with this key.
    fn has(&self, key: &str) -> bool {
        match self {
            Rows(rows) | Used(rows) | While(_, rows) => {
                rows.iter().any(|parameter| parameter.key == key)
            }
            Chosen(items) => items.iter().any(|item| item.has(key)),
            Own(_) => false,
        }
    }
}

/// Rule that decides whether a section is open when a scene is opened.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Open {
    Always,
    /// Open if no special section is open, or if the scene is about it.
    Usually,
    /// Open if the scene is about it.
    WhenAbout,
    /// Open if the scene is about it. It then folds the sections that are open [`Usually`](Self::Usually).
    Special,
}

/// The sections in the order of the equation.
static SECTIONS: [Section; 8] = [
    Section {
        title: "controls-material",
        about: |_| true,
        open: Open::Always,
        symbols: &[
            Symbol::Ka,
            Symbol::Kd,
            Symbol::Ks,
            Symbol::Exponent,
            Symbol::Od,
            Symbol::Os,
            Symbol::Facets,
            Symbol::Masking,
            Symbol::Reflectance,
            Symbol::Reflected,
        ],
        tables: &["reflection"],
        items: &[
            Own(|ui, session, window, _, engine| model::list_ui(ui, session, window, engine)),
            Chosen(&[
                Own(|ui, session, window, _, _| {
                    let material = &mut session.shown.scene.material;
                    let initial = &session.initial.material;
                    window
                        .own
                        .change(|gallery| gallery_ui(ui, initial, gallery, material));
                }),
                Rows(&[&material::KA, &material::KD, &material::KS]),
                While(
                    |scene| has_facets(scene) || scene.reflection.law_uses(&["m"]),
                    &[&material::ROUGHNESS],
                ),
                While(|scene| !has_facets(scene), &[&material::N]),
            ]),
            Rows(&[&material::MODEL]),
            Own(|ui, session, _, _, _| law::law_ui(ui, session)),
            While(has_facets, &[&material::DISTRIBUTION]),
            Chosen(&[
                Own(|ui, session, _, _, _| matching_ui(ui, &mut session.shown.scene)),
                Rows(&[
                    &material::COLOR,
                    &material::SPECULAR_COLOR,
                    &material::PATTERN_KIND,
                ]),
                While(
                    |scene| scene.pattern.kind != PatternKind::None,
                    &[&material::PATTERN_COLOR, &material::PATTERN_SCALE],
                ),
                Rows(&[&material::REFLECTANCE]),
                While(
                    |scene| has_own_index(scene) || scene.reflection.law_uses(&["eta"]),
                    &[&material::IOR],
                ),
                While(has_own_index, &[&material::EXTINCTION]),
            ]),
            Rows(&[&material::BACKFACING]),
        ],
    },
    Section {
        title: "controls-lights",
        about: special_lights,
        open: Open::Usually,
        symbols: &[
            Symbol::Ia,
            Symbol::Lights,
            Symbol::Attenuation,
            Symbol::Ip,
            Symbol::Light,
            Symbol::Shadows,
        ],
        tables: &["light"],
        items: &[
            Rows(&[&material::AMBIENT_COLOR, &shading::SHADOWS]),
            Own(|ui, session, window, requests, _| {
                lights::lights_ui(ui, session, window, requests);
            }),
        ],
    },
    Section {
        title: "controls-shading",
        about: special_shading,
        open: Open::Usually,
        symbols: &[],
        tables: &[],
        items: &[
            Rows(&[&shading::MODE]),
            Own(|ui, session, _, _, _| mode_ui(ui, &session.shown.scene)),
            Used(&[
                &shading::FLAT_AT,
                &shading::INTERPOLATION,
                &shading::RENORMALISE,
            ]),
            Own(|ui, _, _, requests, _| {
                if ui.link(text!("controls-command-defects")).clicked() {
                    requests.ask(Action::View(ViewName::Defects));
                }
            }),
        ],
    },
    Section {
        title: "controls-object",
        about: special_object,
        open: Open::WhenAbout,
        symbols: &[Symbol::Normal],
        tables: &["object"],
        items: &[Own(|ui, session, _, requests, engine| {
            object::object_ui(ui, session, requests, engine);
        })],
    },
    Section {
        title: "controls-surroundings",
        about: |scene| {
            let bounces = scene.ambient.source != AmbientSource::Constant;
            scene.ground.visible || bounces || scene.depth_cueing.by != CuedBy::Off
        },
        open: Open::Special,
        symbols: &[Symbol::Bounce, Symbol::Depth],
        tables: &["depth_cueing"],
        items: &[
            Rows(&[&surroundings::CUED_BY]),
            Own(|ui, session, _, _, _| depths_ui(ui, session)),
            Used(&[
                &surroundings::FRONT_SCALE,
                &surroundings::BACK_SCALE,
                &surroundings::CUE_COLOR,
            ]),
            Rows(&[&material::AMBIENT_SOURCE]),
            Own(|ui, session, _, _, engine| fit_ui(ui, &mut session.shown.scene, engine)),
            Rows(&[&surroundings::GROUND_VISIBLE]),
            While(
                |scene| scene.ground.visible,
                &[
                    &surroundings::GROUND_HEIGHT,
                    &surroundings::GROUND_KA,
                    &surroundings::GROUND_KD,
                    &surroundings::GROUND_COLOR,
                ],
            ),
            Rows(&[&surroundings::BACKDROP_PATTERN]),
            Used(&[
                &surroundings::BACKDROP_COLOR,
                &surroundings::BACKDROP_SCALE,
                &surroundings::BACKDROP_DISTANCE,
            ]),
        ],
    },
    Section {
        title: "controls-transparency",
        about: |scene| scene.transparency.kt > 0.0,
        open: Open::Special,
        symbols: &[Symbol::Kt, Symbol::Transmitted],
        tables: &[],
        items: &[
            Chosen(&[Rows(&[&material::KT, &material::TRANSPARENCY_IOR])]),
            Rows(&[&material::THROUGH]),
        ],
    },
    Section {
        title: "controls-camera",
        about: special_camera,
        open: Open::Special,
        symbols: &[Symbol::Viewer],
        tables: &[],
        items: &[
            Rows(&[&camera::VIEWER, &camera::PROJECTION]),
            Used(&[&camera::FOV_Y, &camera::HEIGHT]),
            Rows(&[&camera::FRAMING]),
            Rows(&[&camera::ROLL, &camera::EYE, &camera::TARGET]),
            Own(|ui, _, _, requests, _| {
                let tip = text!("controls-reset-camera.tip");
                let button = ui.button(text!("controls-reset-camera"));
                if button.on_hover_text(tip).clicked() {
                    requests.ask(Action::ResetCamera);
                }
            }),
        ],
    },
    Section {
        title: "controls-display",
        about: |scene| {
            let Display { overflow, encoding } = Display::default();
            scene.display.overflow != overflow || scene.display.encoding != encoding
        },
        open: Open::Special,
        symbols: &[Symbol::Intensity],
        tables: &[],
        items: &[
            Rows(&[&camera::OVERFLOW]),
            Own(|ui, session, _, _, engine| overflow_ui(ui, &session.shown.scene, engine)),
            Rows(&[&camera::ENCODING, &camera::BACKGROUND]),
        ],
    },
];

fn special_lights(scene: &Scene) -> bool {
    let usual = Light::default();
    let special = scene.lights.iter().any(|light| {
        light.kind != usual.kind
            || light.attenuation != usual.attenuation
            || light.mute
            || light.solo
    });
    special || scene.shading.shadows
}

fn special_shading(scene: &Scene) -> bool {
    let Shading { mode, shadows, .. } = scene.shading;
    let usual = Shading::default();
    scene.shading
        != Shading {
            mode,
            shadows,
            ..usual
        }
}

fn special_object(scene: &Scene) -> bool {
    let (object, usual) = (&scene.object, Object::default());
    object.kind == ObjectKind::Polygons
        || object.segments < usual.segments
        || object.weighting != usual.weighting
}

fn special_camera(scene: &Scene) -> bool {
    let (camera, usual) = (&scene.camera, Camera::default());
    camera.viewer != usual.viewer
        || camera.projection != usual.projection
        || camera.roll != usual.roll
        || camera.fov_y > WIDE
}

/// Returns for each section whether it is open when `scene` is opened, which depends on what the scene is about.
fn open_in(scene: &Scene) -> [bool; SECTIONS.len()] {
    let is_special = |section: &Section| section.open == Open::Special && (section.about)(scene);
    let special = SECTIONS.iter().any(is_special);
    SECTIONS.each_ref().map(|section| match section.open {
        Open::Always => true,
        Open::Usually => !special || (section.about)(scene),
        Open::WhenAbout | Open::Special => (section.about)(scene),
    })
}

fn has_facets(scene: &Scene) -> bool {
    scene.reflection.model == ReflectionModel::CookTorrance
}

fn has_own_index(scene: &Scene) -> bool {
    scene.material.reflectance == Reflectance::Custom
}

/// The sections that were opened or folded by hand: other scenes leave them so, until the window closes.
#[derive(Debug, Default)]
struct FoldedByHand([Option<bool>; SECTIONS.len()]);

/// Shows the controls of the quantities in the equation.
///
/// A scene that has just been opened is shown from the top, with the sections open that it is about.
pub fn controls_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let opened = session.take_just_opened();
    let mut opens = open_in(&session.initial);
    if let Some(FoldedByHand(folded)) = window.own.get() {
        let folded = opens.iter_mut().zip(folded);
        folded.for_each(|(opens, by_hand)| *opens = by_hand.unwrap_or(*opens));
    }
    let mut area = ScrollArea::vertical().auto_shrink(false);
    if opened {
        area = area.vertical_scroll_offset(0.0);
    }
    area.show(ui, |ui| {
        let columns = ((ui.available_width() / COLUMN) as usize).clamp(1, MOST_COLUMNS);
        ui.columns(columns, |columns| {
            let count = columns.len();
            for (place, section) in SECTIONS.iter().enumerate() {
                let ui = &mut columns[place * count / SECTIONS.len()];
                let fold = (opens[place], opened);
                let by_hand = section_ui(ui, session, window, requests, engine, section, fold);
                if by_hand.is_some() {
                    window
                        .own
                        .change(|folded: &mut FoldedByHand| folded.0[place] = by_hand);
                }
            }
        });
        ui.add_space(12.0);
        keep_in_sight(ui);
    });
}

/// Returns whether the panel has a row for the parameter with this key.
pub fn has_row(key: &'static str) -> bool {
    let sought = Sought::Parameter(key);
    SECTIONS.iter().any(|section| section.has(sought))
}

/// Changes the number whose letter is dragged in a formula, and shows it beside the pointer.
pub fn pull_ui(ui: &Ui, session: &mut Session, window: &WindowState) {
    let Some((symbol, points)) = symbol::pulled(ui.ctx()) else {
        return;
    };
    let (mut pulled, number) = (None, model::chosen(session, window));
    model::with_chosen(session, number, &mut |session| {
        let (scene, light) = (&mut session.shown.scene, session.light);
        pulled = row::pull(scene, symbol, light, points);
    });
    let Some((parameter, value)) = pulled else {
        return;
    };
    Tooltip::always_open(
        ui.ctx().clone(),
        ui.layer_id(),
        Id::unique("pulled"),
        PopupAnchor::Pointer,
    )
    .show(|ui| ui.label(format!("{} = {value}", parameter.letter)));
    session.commit();
}

/// A parameter whose slider is shown below a letter of the equation, and the letter's rectangle.
struct BelowLetter(&'static Parameter, Rect);

/// Answers a click on a letter of the equation: in the panel of controls, if it is open, and else with the letter's
/// slider below it, so that nothing covers the picture.
pub fn letter_ui(ui: &Ui, session: &mut Session, window: &mut WindowState) {
    let ctx = ui.ctx();
    if let Some((symbol, rect)) = symbol::take_clicked(ctx) {
        match row::of_letter(&session.shown.scene, symbol, session.light) {
            // Of a model's materials, the panel shows which one is chosen.
            Some(parameter) if !(window.appearance.controls || model::has_several(session)) => {
                window.own.put(Some(BelowLetter(parameter, rect)));
            }
            _ => symbol::seek(ctx, Sought::Symbol(symbol)),
        }
    }
    let Some(BelowLetter(parameter, rect)) = window.own.take::<Option<BelowLetter>>() else {
        return;
    };
    let mut open = true;
    Popup::new(Id::unique("below-letter"), ctx.clone(), rect, ui.layer_id())
        .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
        .width(CONTROL)
        .open_bool(&mut open)
        .show(|ui| {
            ui.add_enabled_ui(session.lock.is_none(), |ui| {
                let view = RowOptions {
                    index: session.light,
                    channels: window.appearance.channels,
                    ..RowOptions::default()
                };
                let scene = &mut session.shown.scene;
                parameter_with(ui, &session.initial, scene, parameter, &view);
            });
            if session.lock.is_some() {
                ui.weak(text!("course-after-answer"));
            } else if ui.link(text!("controls-all")).clicked() {
                symbol::seek(ui.ctx(), Sought::Parameter(parameter.key));
                ui.close();
            }
        });
    window.own.put(open.then_some(BelowLetter(parameter, rect)));
    session.commit();
}

/// Shows a section; opening another scene opens or folds it anew. Returns whether it is open if it was just opened or folded
/// by hand.
fn section_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
    section: &Section,
    (opens, anew): (bool, bool),
) -> Option<bool> {
    let sought = symbol::sought(ui.ctx()).is_some_and(|sought| section.has(sought));
    let title = RichText::new(text!(section.title)).strong();
    let header = CollapsingHeader::new(title).id_salt(section.title);
    let open = if sought {
        Some(true)
    } else {
        anew.then_some(opens)
    };
    let shown = header
        .default_open(opens)
        .open(open)
        .show_unindented(ui, |ui| {
            ui.add_space(2.0);
            if session.lock.is_some() {
                ui.weak(text!("course-after-answer"));
                ui.disable();
            }
            let items = section.items.iter();
            items.for_each(|item| item_ui(ui, session, window, requests, engine, item));
            ui.add_space(8.0);
        });
    let header = shown.header_response;
    let state = CollapsingState::load(&header.ctx, header.id).filter(|_| header.clicked());
    state.map(|state| state.is_open())
}

fn item_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
    item: &Item,
) {
    let scene = &mut session.shown.scene;
    let rows = match item {
        Rows(rows) | Used(rows) => *rows,
        While(holds, rows) if holds(scene) => *rows,
        While(..) => &[],
        Own(control) => return control(ui, session, window, requests, engine),
        Chosen(items) => {
            let number = model::chosen(session, window);
            return model::with_chosen(session, number, &mut |session| {
                for item in *items {
                    item_ui(ui, session, window, requests, engine, item);
                }
            });
        }
    };
    let view = RowOptions {
        channels: window.appearance.channels,
        ..RowOptions::default()
    };
    for row in rows {
        if !matches!(item, Used(_)) || row.idle(scene, 0).is_none() {
            parameter_with(ui, &session.initial, scene, row, &view);
        }
    }
}

/// Explains the shading mode.
fn mode_ui(ui: &mut Ui, scene: &Scene) {
    let mode = scene.shading.mode;
    let what = if mode == ShadingMode::Exact && !scene.object.kind.has_surface() {
        text!("controls-exact-without-surface")
    } else {
        mode.help()
    };
    ui.weak(what);
}

/// Shows the number of pixels that the overflow policy affects.
fn overflow_ui(ui: &mut Ui, scene: &Scene, engine: &Engine) {
    let count = engine.report().overflowing;
    let number = grouped(count);
    let text = if scene.reflection.model == ReflectionModel::Formula {
        text!(
            "controls-overflowing-or-undefined",
            count = count,
            number = number
        )
    } else {
        text!("controls-overflowing", count = count, number = number)
    };
    ui.weak(text);
}

/// Shows the constant that best approximates the drawn bounce, and a button that applies it.
fn fit_ui(ui: &mut Ui, scene: &mut Scene, engine: &Engine) {
    let ambient = &mut scene.ambient;
    if ambient.source == AmbientSource::Constant {
        return;
    }
    if ambient.source == AmbientSource::Split {
        ui.weak(text!("controls-halves"));
    }
    let fit = engine.report().ambient_fit;
    let about = About {
        letter: "Ia",
        label: text!("controls-fit.label"),
        name: text!("controls-fit"),
        tip: text!("controls-fit.tip"),
        symbol: Some(Symbol::Ia),
        idle: fit.is_none().then(|| text!("controls-fit.idle")),
        ..About::default()
    };
    row(ui, &about, false, |ui| {
        let Some(fit) = fit.map(Rgb::from_array) else {
            return;
        };
        let [r, g, b] = fit.to_array().map(|channel| format!("{channel:.3}"));
        let taken = (ambient.color - fit).abs().max_element() < 5e-4;
        let button = Button::new(text!("controls-fit-take.label"));
        let button = ui.add_enabled(!taken, button);
        let button = named(button, Role::Button, text!("controls-fit-take"));
        let tip = text!("controls-fit-take.tip");
        if button.on_hover_text(tip).clicked() {
            ambient.color = (fit * 1e3).round() / 1e3;
        }
        let numbers = format!("{r} {g} {b}");
        let small = RichText::new(&numbers).monospace().small();
        ui.add(Label::new(small).truncate()).on_hover_text(&numbers);
    });
}

/// Shows the depths at which fading begins and ends.
///
/// The sliders reach as far behind the camera's target as the target is from the eye.
fn depths_ui(ui: &mut Ui, session: &mut Session) {
    let Session { shown, initial, .. } = session;
    let scene = &mut shown.scene;
    if scene.depth_cueing.by == CuedBy::Off {
        return;
    }
    if scene.depth_cueing.by == CuedBy::Vertex && scene.shading.mode == ShadingMode::Exact {
        ui.weak(text!("controls-depth-exact"));
    }
    let (before, reach) = (scene.depth_cueing.front, 2.0 * scene.camera.distance());
    for row in [&surroundings::FRONT, &surroundings::BACK] {
        let view = RowOptions {
            slider: Some(Slider::linear(0.0, reach)),
            ..RowOptions::default()
        };
        parameter_with(ui, initial, scene, row, &view);
    }
    let front_moved = scene.depth_cueing.front.to_bits() != before.to_bits();
    part(&mut scene.depth_cueing, front_moved, reach);
}

/// Keeps the front before the back. The one that moved pushes the other.
fn part(cueing: &mut DepthCueing, front_moved: bool, reach: f64) {
    let gap = (0.005 * reach).max(1e-9 * cueing.front.max(cueing.back));
    if cueing.front < cueing.back {
        return;
    }
    if front_moved {
        cueing.front = cueing.front.min(GREATEST_LENGTH - gap);
        cueing.back = cueing.front + gap;
    } else {
        cueing.back = cueing.back.max(gap);
        cueing.front = (cueing.back - gap).max(0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_stays_before_the_back() {
        for (front, back) in [
            (7.0, 5.0),
            (0.0, 0.0),
            (1e30, 3.0),
            (3.0, 0.0),
            (1e-30, 1e-30),
        ] {
            for front_moved in [true, false] {
                for reach in [8.0, 1e-20, 1e20] {
                    let mut scene = Scene::default();
                    (scene.depth_cueing.front, scene.depth_cueing.back) = (front, back);
                    part(&mut scene.depth_cueing, front_moved, reach);
                    assert_eq!(
                        scene.validate(),
                        Ok(()),
                        "{front} {back} {front_moved} {reach}"
                    );
                }
            }
        }
    }
}
