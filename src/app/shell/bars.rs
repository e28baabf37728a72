//! The bars. The top one has the menus and the shading modes side by side; the bottom one shows which stages
//! the last change ran, their cost, and the number of steps skipped.

use super::commands::{MENUS, SECTIONS};
use super::equation;
use super::menu::{appearance_ui, commands_ui, scrolled};
use super::notice::said_ui;
use super::terms;
use crate::analysis::plan_words::stage_words;
use crate::analysis::report::grouped;
use crate::app::course::{Course, back_ui};
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::appearance::ViewName;
use crate::app::session::window::WindowState;
use crate::app::system;
use crate::app::views::compare::VIEWS;
use crate::app::views::plan::left_out;
use crate::app::widgets::focus::{named, one_stop};
use crate::app::widgets::letter::text_width;
use crate::render::{FrameReport, StageRun};
use crate::scene::{Choice, ReflectionModel, Scene, ShadingMode};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::containers::menu::is_in_menu;
use eframe::egui::{
    Align, Button, ComboBox, EventFilter, Id, Key, Label, Layout, MenuBar, Modifiers, Popup,
    RadioButton, Response, RichText, Sense, TextWrapMode, Ui, vec2,
};

/// The window width below which the menus fold into one, and the modes into a list, in points.
const NARROW: f32 = 860.0;

/// Shows menus at the left, modes beside them, and in a `low` window the scene's title too.
pub fn menus_ui(
    ui: &mut Ui,
    session: &Session,
    window: &mut WindowState,
    course: &Course,
    requests: &mut Requests,
    low: bool,
) {
    ui.add_space(3.0);
    let narrow = ui.available_width() < NARROW;
    MenuBar::new().ui(ui, |ui| {
        if narrow {
            ui.menu_button(text!("menu"), |ui| {
                each_menu_ui(ui, session, window, requests);
            });
            mode_list_ui(ui, session, requests);
        } else {
            let menus = ui.horizontal(|ui| each_menu_ui(ui, session, window, requests));
            one_stop(ui, menus.response.rect);
            ui.separator();
            let modes = ui.horizontal(|ui| modes_ui(ui, session, requests));
            one_stop(ui, modes.response.rect);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let name = if low {
                scene_buttons_ui(ui, window, course, requests);
                session.document().title()
            } else {
                session.document().origin.name()
            };
            let text = if session.modified() {
                format!("{name} *")
            } else {
                name
            };
            ui.add(Label::new(RichText::new(text).weak()).truncate());
        });
    });
    ui.add_space(3.0);
}

fn each_menu_ui(ui: &mut Ui, session: &Session, window: &mut WindowState, requests: &mut Requests) {
    for section in MENUS
        .iter()
        .filter_map(|menu| SECTIONS.iter().find(|section| section.key == *menu))
    {
        let shown = ui.menu_button(section.title(), |ui| {
            scrolled(ui, |ui| menu_ui(ui, session, window, requests, section.key));
        });
        opens_by_arrow(&shown.response);
        // Within the one menu of a narrow window these are menus of another kind, which a click opens anyway.
        if !is_in_menu(ui) {
            stays_open(&shown.response);
        }
    }
}

/// Keeps a menu open that pointing at its button has opened, if that button is then clicked.
fn stays_open(button: &Response) {
    let (ctx, menu) = (&button.ctx, Popup::default_response_id(button));
    let key = Id::unique("menu-clicked");
    let by_click = ctx.data(|data| data.get_temp(key)) == Some(menu);
    let open = Popup::is_id_open(ctx, menu);
    if button.clicked() {
        ctx.data_mut(|data| data.insert_temp(key, menu));
        if !open && !by_click {
            Popup::open_id(ctx, menu);
        }
    } else if button.hovered() && open && !by_click {
        ctx.data_mut(|data| data.remove::<Id>(key));
    }
}

/// Opens the menu of the focused button when the arrow key down is pressed.
fn opens_by_arrow(button: &Response) {
    let (ctx, menu) = (&button.ctx, Popup::default_response_id(button));
    if !button.has_focus() || Popup::is_id_open(ctx, menu) {
        return;
    }
    let filter = EventFilter {
        vertical_arrows: true,
        ..EventFilter::default()
    };
    ctx.memory_mut(|memory| memory.set_focus_lock_filter(button.id, filter));
    if ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::ArrowDown)) {
        Popup::open_id(ctx, menu);
    }
}

/// Shows the items of a menu.
fn menu_ui(
    ui: &mut Ui,
    session: &Session,
    window: &mut WindowState,
    requests: &mut Requests,
    menu: &str,
) {
    commands_ui(ui, session, window, requests, menu);
    if menu == "file" && !system::PAGE {
        ui.separator();
        ui.add_enabled_ui(!window.appearance.recent.is_empty(), |ui| {
            ui.menu_button(text!("recent"), |ui| recent_ui(ui, window, requests));
        });
    }
    if menu != "view" {
        return;
    }
    ui.separator();
    ui.menu_button(text!("controls-group-compare"), |ui| {
        for (view, name, tip) in VIEWS {
            let present = session.document().scene.compare.view == view;
            let radio = RadioButton::new(present, text!(name));
            let radio = ui.add_enabled(session.lock.is_none(), radio);
            let radio = radio.on_disabled_hover_text(text!("course-after-answer"));
            if radio.on_hover_text(text!(tip)).clicked() {
                requests.ask(Action::Compare(view));
                ui.close();
            }
        }
        ui.separator();
        commands_ui(ui, session, window, requests, "compare");
    });
    appearance_ui(ui, window, requests, "controls-theme");
    appearance_ui(ui, window, requests, "language");
}

/// Shows the equation, and a switch for each of its terms.
pub fn equation_ui(ui: &mut Ui, session: &mut Session, window: &mut WindowState) {
    ui.add_space(4.0);
    let wide = ui.available_width() > 640.0;
    if wide {
        ui.horizontal(|ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                terms::switches_ui(ui, session, window, true);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    equation::equation_ui(ui, session);
                });
            });
        });
    } else {
        equation::equation_ui(ui, session);
        ui.horizontal_wrapped(|ui| terms::switches_ui(ui, session, window, false));
    }
    one_stop(ui, ui.min_rect());
    ui.add_space(3.0);
}

/// Shows the scene's title and sentence, with buttons for the previous scene, the next one, and the list of
/// all.
pub fn title_ui(
    ui: &mut Ui,
    session: &Session,
    window: &WindowState,
    course: &Course,
    requests: &mut Requests,
) {
    ui.add_space(2.0);
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            scene_buttons_ui(ui, window, course, requests);
            ui.with_layout(Layout::top_down(Align::Min), |ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                let title = RichText::new(session.document().title()).strong();
                ui.add(Label::new(title).truncate());
                let sentence = session.document().sentence();
                if !sentence.is_empty() {
                    ui.add(Label::new(RichText::new(sentence).weak()).wrap());
                }
            });
        });
    });
    ui.add_space(2.0);
}

/// Shows the buttons of the scenes, from right to left: all scenes, the next one, the previous one.
fn scene_buttons_ui(ui: &mut Ui, window: &WindowState, course: &Course, requests: &mut Requests) {
    let all = if ui.available_width() < 480.0 {
        "▦".to_owned()
    } else {
        format!("▦ {}", text!("scenes"))
    };
    let side = ui.spacing().interact_size.y;
    let button = ui.add(Button::new(all).min_size(vec2(side, side)));
    let button = named(button, Role::Button, text!("scenes"));
    if button.on_hover_text(text!("scenes.tip")).clicked() {
        requests.ask(Action::Scenes);
    }
    for (sign, step, name) in [
        ("▶", 1, text!("scenes-next")),
        ("◀", -1, text!("scenes-previous")),
    ] {
        let button = ui.add(Button::new(sign).min_size(vec2(side, side)));
        let button = named(button, Role::Button, name);
        if button.on_hover_text(name).clicked() {
            requests.ask(Action::NextScene(step));
        }
    }
    // The course's own view has this button too.
    if course.has_left_lesson() && !window.shows(ViewName::Course) {
        back_ui(ui, requests);
    }
}

/// Shows the most recently opened or saved files.
fn recent_ui(ui: &mut Ui, window: &mut WindowState, requests: &mut Requests) {
    for path in window.appearance.recent.clone() {
        let name = path.file_name().unwrap_or(path.as_os_str());
        let button = ui.button(name.to_string_lossy());
        if button.on_hover_text(path.display().to_string()).clicked() {
            requests.ask(Action::OpenFile(path));
            ui.close();
        }
    }
    ui.separator();
    if ui.button(text!("recent-clear")).clicked() {
        window.appearance.recent.clear();
        ui.close();
    }
}

/// Shows the shading modes, one button each.
fn modes_ui(ui: &mut Ui, session: &Session, requests: &mut Requests) {
    let present = session.shown.scene.shading.mode;
    for (index, mode) in ShadingMode::VALUES.iter().enumerate() {
        let name = format!("{} {}", index + 1, mode.label());
        let button = Button::selectable(present == *mode, name);
        let button = ui.add_enabled(session.lock.is_none(), button);
        let button = button.on_disabled_hover_text(text!("course-after-answer"));
        if button.on_hover_text(mode.help()).clicked() {
            shade(requests, *mode);
        }
    }
}

/// Shows the shading modes as a list.
fn mode_list_ui(ui: &mut Ui, session: &Session, requests: &mut Requests) {
    let present = session.shown.scene.shading.mode;
    if session.lock.is_some() {
        ui.disable();
    }
    let list = ComboBox::from_id_salt("modes")
        .selected_text(present.label())
        .show_ui(ui, |ui| {
            for mode in ShadingMode::VALUES {
                let entry = ui.selectable_label(present == *mode, mode.label());
                if entry.on_hover_text(mode.help()).clicked() {
                    shade(requests, *mode);
                }
            }
        });
    named(list.response, Role::ComboBox, text!("modes"));
}

fn shade(requests: &mut Requests, mode: ShadingMode) {
    requests.ask(Action::Shade {
        mode,
        renormalise: true,
    });
}

/// Shows the bar of stages.
pub fn stages_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    course: &Course,
    requests: &mut Requests,
    engine: &Engine,
) {
    ui.add_space(2.0);
    if course.hides() {
        // As high as with numbers, so that the picture keeps its size. Other views say themselves that
        // numbers are hidden.
        ui.horizontal(|ui| {
            if window.shows(ViewName::Course) {
                ui.weak(text!("course-hidden"));
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                said_ui(ui, session, requests, TextWrapMode::Truncate);
            });
        });
        ui.add_space(2.0);
        return;
    }
    ui.horizontal(|ui| {
        let report = engine.report();
        for run in &report.stages {
            stage_ui(ui, run);
        }
        ui.separator();
        let ms = engine.nanoseconds() as f64 / 1e6;
        ui.monospace(format!("{ms:.1} ms"));
        if engine.coarser() > 1 {
            let text = text!("coarser", share = engine.coarser());
            ui.label(text).on_hover_text(text!("coarser-tip"));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let omitted = left_out(engine, &window.appearance);
            let link = ui.link(text!("left-out", count = omitted));
            if link.on_hover_text(text!("left-out-tip")).clicked() {
                window.show_view(ViewName::Plan);
            }
            said_ui(ui, session, requests, TextWrapMode::Truncate);
            // A notice leaves no space for the counts.
            if session.said().is_none() {
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    counts_ui(ui, &session.shown.scene, report);
                });
            }
        });
    });
    ui.add_space(2.0);
}

/// Shows those counts of the last change that have room.
fn counts_ui(ui: &mut Ui, scene: &Scene, report: &FrameReport) {
    let evaluations: u64 = report.stages.iter().map(|run| run.evaluations).sum();
    let shown = grouped(evaluations);
    let overflowing = match grouped(report.overflowing) {
        _ if report.overflowing == 0 => String::new(),
        count if scene.reflection.model == ReflectionModel::Formula => {
            text!("overflowing-or-undefined", count = count)
        }
        count => text!("overflowing", count = count),
    };
    // In their order on the screen, each with its rank: what comes last gives way first.
    let counts = [
        (
            0,
            text!("evaluations", count = evaluations, shown = shown),
            text!("evaluations-tip"),
        ),
        (2, text!("triangles", count = grouped(report.triangles)), ""),
        (1, overflowing, text!("overflowing-tip")),
    ];
    let width = |words: &str| text_width(ui, words) + ui.spacing().item_spacing.x;
    let widths = counts
        .each_ref()
        .map(|(rank, words, _)| (*rank, width(words)));
    let room = ui.available_width();
    for (rank, words, tip) in counts {
        let before = widths.iter().filter(|(other, _)| *other <= rank);
        if words.is_empty() || before.map(|(_, width)| width).sum::<f32>() > room {
            continue;
        }
        if tip.is_empty() {
            ui.weak(words);
        } else {
            ui.label(words).on_hover_text(tip);
        }
    }
}

fn stage_ui(ui: &mut Ui, run: &StageRun) {
    let (name, what) = stage_words(run.stage);
    let (text, time) = if run.ran {
        let ms = format!("{:.2}", run.nanoseconds as f64 / 1e6);
        let evaluations = grouped(run.evaluations);
        let time = text!("stage-ran", ms = ms, evaluations = evaluations);
        (RichText::new(format!("■ {name}")).strong(), time)
    } else {
        let time = text!("stage-kept").to_owned();
        (RichText::new(format!("□ {name}")).weak(), time)
    };
    ui.add(Label::new(text).sense(Sense::hover()))
        .on_hover_text(format!("{what}\n{time}"));
}
