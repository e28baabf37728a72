//! The views: ways of reading the picture, in groups on the rail at the right.

#[cfg(feature = "class")]
mod class;
pub mod compare;
pub mod curves;
pub mod defects;
pub mod plan;
pub mod point;
pub mod profile;
pub mod report;
pub mod scan;
pub mod stability;
pub mod study;

use super::course::{course_ui, head_ui, hidden_ui};
use super::engine::Engine;
use crate::app::course::Course;
use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::appearance::ViewName;
use crate::app::session::window::WindowState;
#[cfg(feature = "class")]
use crate::app::views::class::class_ui;
use crate::app::views::compare::compare_ui;
use crate::app::views::curves::curves_ui;
use crate::app::views::defects::defects_ui;
use crate::app::views::plan::plan_ui;
use crate::app::views::point::point_ui;
use crate::app::views::profile::profile_ui;
use crate::app::views::scan::scan_ui;
use crate::app::views::stability::stability_ui;
use crate::app::views::study::study_ui;
use crate::app::widgets::focus::{keep_in_sight, one_stop, switch_named};
use crate::app::widgets::sign::{Sign, sign_button};
use crate::app::widgets::tile::sign_tile;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Button, Layout, ScrollArea, Ui, UiBuilder, Vec2, vec2};

/// A way of reading the picture.
#[derive(Clone, Copy)]
pub struct View {
    pub key: ViewName,
    /// Key of the name in the catalogue.
    name: &'static str,
    /// Key of its other names, for the search.
    words: &'static str,
    show: fn(&mut Ui, &mut Parts<'_>),
}

impl View {
    pub fn title(&self) -> &'static str {
        text!(self.name)
    }

    /// Returns other names under which the search finds the view.
    pub fn words(&self) -> &'static str {
        text!(self.words)
    }
}

/// Views that belong together, under one icon on the rail.
pub struct Group {
    pub sign: Sign,
    name: &'static str,
    /// True if the views need more width than a panel beside the picture has. They then open below the picture.
    wide: bool,
    pub views: &'static [View],
}

impl Group {
    pub fn title(&self) -> &'static str {
        text!(self.name)
    }

    pub fn has(&self, key: ViewName) -> bool {
        self.views.iter().any(|view| view.key == key)
    }
}

/// Every view, in the order in which they are shown.
pub static GROUPS: [Group; 5] = [
    Group {
        sign: Sign::Point,
        name: "view-point",
        wide: false,
        views: &[
            View {
                key: ViewName::Equation,
                name: "view-equation",
                words: "view-equation.words",
                show: |ui, p| point_ui(ui, p.session, p.window, p.requests, p.engine),
            },
            View {
                key: ViewName::Curves,
                name: "view-curves",
                words: "view-curves.words",
                show: |ui, p| p.with(ui, curves_ui),
            },
        ],
    },
    Group {
        sign: Sign::Line,
        name: "view-line",
        wide: true,
        views: &[
            View {
                key: ViewName::Profile,
                name: "view-profile",
                words: "view-profile.words",
                show: |ui, p| p.with(ui, profile_ui),
            },
            View {
                key: ViewName::ScanLine,
                name: "view-scan-line",
                words: "view-scan-line.words",
                show: |ui, p| p.with(ui, scan_ui),
            },
        ],
    },
    Group {
        sign: Sign::Picture,
        name: "view-picture",
        wide: false,
        views: &[
            View {
                key: ViewName::Compare,
                name: "view-compare",
                words: "view-compare.words",
                show: |ui, p| p.with(ui, compare_ui),
            },
            View {
                key: ViewName::Defects,
                name: "view-defects",
                words: "view-defects.words",
                show: |ui, p| p.with(ui, defects_ui),
            },
        ],
    },
    Group {
        sign: Sign::Engine,
        name: "view-engine",
        wide: false,
        views: &[
            View {
                key: ViewName::Plan,
                name: "view-plan",
                words: "view-plan.words",
                show: |ui, p| p.with(ui, plan_ui),
            },
            View {
                key: ViewName::Study,
                name: "view-study",
                words: "view-study.words",
                show: |ui, p| p.with(ui, study_ui),
            },
            View {
                key: ViewName::Stability,
                name: "view-stability",
                words: "view-stability.words",
                show: |ui, p| p.with(ui, stability_ui),
            },
        ],
    },
    Group {
        sign: Sign::Course,
        name: "course",
        wide: false,
        views: &[
            View {
                key: ViewName::Course,
                name: "course",
                words: "course.words",
                show: |ui, p| course_ui(ui, p.session, p.window, p.course, p.requests),
            },
            #[cfg(feature = "class")]
            View {
                key: ViewName::Class,
                name: "view-class",
                words: "view-class.words",
                show: |ui, p| {
                    let mut own = p.window.own.take();
                    class_ui(ui, &mut own, p.window, p.course, p.requests);
                    p.window.own.put(own);
                },
            },
        ],
    },
];

/// Parts of the window that a view may show or change; each view takes those that it needs.
struct Parts<'a> {
    session: &'a mut Session,
    window: &'a mut WindowState,
    course: &'a mut Course,
    requests: &'a mut Requests,
    engine: &'a Engine,
}

/// Shows a view that has a state of its own.
type ShowWithState<T> = fn(&mut Ui, &mut T, &mut Session, &mut WindowState, &mut Requests, &Engine);

impl Parts<'_> {
    fn with<T: Default + 'static>(&mut self, ui: &mut Ui, show: ShowWithState<T>) {
        let mut own = self.window.own.take();
        show(
            ui,
            &mut own,
            self.session,
            self.window,
            self.requests,
            self.engine,
        );
        self.window.own.put(own);
    }
}

fn group_index(key: ViewName) -> usize {
    GROUPS.iter().position(|group| group.has(key)).unwrap_or(0)
}

fn view(key: ViewName) -> &'static View {
    let views = GROUPS[group_index(key)].views;
    views
        .iter()
        .find(|view| view.key == key)
        .unwrap_or(&views[0])
}

/// Returns the view after this one. The first view follows the last one of the last group.
pub fn after(key: ViewName) -> ViewName {
    let all: Vec<_> = GROUPS.iter().flat_map(|group| group.views).collect();
    let place = all.iter().position(|view| view.key == key).unwrap_or(0);
    all[(place + 1) % all.len()].key
}

/// The view last shown in each group, and the groups that were moved, until the window closes.
#[derive(Debug, Default)]
struct Habits {
    last: [Option<ViewName>; GROUPS.len()],
    /// True for groups that were moved from their default place, below the picture or beside it.
    moved: [bool; GROUPS.len()],
}

/// Returns whether the present view is below the picture, in a window with space both there and beside it. All views of a
/// group have the same place.
pub fn stands_below(window: &WindowState) -> bool {
    let index = group_index(window.appearance.view);
    let habits = window.own.get::<Habits>();
    GROUPS[index].wide != habits.is_some_and(|habits| habits.moved[index])
}

/// Shows the view that was last shown in the group, or closes it if it is visible.
fn choose(window: &mut WindowState, index: usize) {
    let group = &GROUPS[index];
    if group.has(window.appearance.view) && window.appearance.views {
        window.appearance.views = false;
        return;
    }
    let last = window
        .own
        .get()
        .and_then(|habits: &Habits| habits.last[index]);
    let present = group
        .has(window.appearance.view)
        .then_some(window.appearance.view);
    window.show_view(present.or(last).unwrap_or(group.views[0].key));
}

/// Shows the rail: a button for the controls and one for each group, of which a narrow window shows one at a time.
pub fn rail_ui(ui: &mut Ui, window: &mut WindowState, narrow: bool, size: Vec2) {
    let between = if size.y < 52.0 { 0.0 } else { 4.0 };
    ui.spacing_mut().item_spacing = vec2(2.0, between);
    let controls = window.appearance.controls;
    if sign_ui(ui, Sign::Controls, text!("view-controls"), controls, size) {
        window.appearance.controls = !controls;
        window.appearance.views &= !narrow;
    }
    for (index, group) in GROUPS.iter().enumerate() {
        let shown = window.appearance.views && group.has(window.appearance.view);
        if sign_ui(ui, group.sign, group.title(), shown, size) {
            choose(window, index);
            window.appearance.controls &= !narrow;
        }
    }
    one_stop(ui, ui.min_rect());
}

/// Shows a sign over its name, and returns whether it was clicked.
fn sign_ui(ui: &mut Ui, sign: Sign, name: &str, on: bool, size: Vec2) -> bool {
    switch_named(sign_tile(ui, sign, name, size, on), Role::Button, on, name).clicked()
}

/// Shows the open view under the names of its group.
pub fn view_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    course: &mut Course,
    requests: &mut Requests,
    engine: &Engine,
    narrow: bool,
) {
    let index = group_index(window.appearance.view);
    let group = &GROUPS[index];
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        // A lesson has its own heading.
        if window.appearance.view == ViewName::Course && course.heading().is_some() {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                place_ui(ui, window, narrow);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    head_ui(ui, course, requests);
                });
            });
            return;
        }
        for view in group.views {
            let on = view.key == window.appearance.view;
            let button = ui.add(Button::selectable(on, view.title()));
            if switch_named(button, Role::Tab, on, view.title()).clicked() {
                window.appearance.view = view.key;
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            place_ui(ui, window, narrow);
        });
    });
    let name = window.appearance.view;
    window
        .own
        .change(|habits: &mut Habits| habits.last[index] = Some(name));
    ui.add_space(2.0);
    let view = view(name);
    // A scroll bar that appears must not widen the panel for a frame: the picture would be drawn again.
    let rect = ui.available_rect_before_wrap();
    let mut inside = ui.new_child(UiBuilder::new().max_rect(rect));
    ui.advance_cursor_after_rect(rect);
    let hidden = course.hides();
    let mut parts = Parts {
        session,
        window,
        course,
        requests,
        engine,
    };
    if matches!(name, ViewName::Course | ViewName::Class) {
        // Their buttons stay visible.
        return (view.show)(&mut inside, &mut parts);
    }
    let show = if hidden {
        |ui: &mut Ui, parts: &mut Parts<'_>| hidden_ui(ui, parts.window)
    } else {
        view.show
    };
    ScrollArea::vertical()
        .id_salt(view.name)
        .auto_shrink(false)
        .show(&mut inside, |ui| {
            show(ui, &mut parts);
            keep_in_sight(ui);
        });
}

/// Shows the buttons that close, enlarge or move the view.
fn place_ui(ui: &mut Ui, window: &mut WindowState, narrow: bool) {
    ui.spacing_mut().item_spacing.x = 2.0;
    if sign_button(ui, Sign::Close, text!("view-close")) {
        (window.appearance.views, window.enlarged) = (false, false);
    }
    let (sign, name) = if window.enlarged {
        (Sign::Shrink, text!("view-shrink"))
    } else {
        (Sign::Enlarge, text!("view-enlarge"))
    };
    if sign_button(ui, sign, name) {
        window.enlarged = !window.enlarged;
    }
    if narrow || window.enlarged {
        return;
    }
    let (sign, name) = if stands_below(window) {
        (Sign::Beside, text!("view-beside"))
    } else {
        (Sign::Below, text!("view-below"))
    };
    if sign_button(ui, sign, name) {
        let index = group_index(window.appearance.view);
        window
            .own
            .change(|habits: &mut Habits| habits.moved[index] ^= true);
    }
}

/// Width of the rail, and its height at the bottom of the window, in points.
pub const RAIL: f32 = 60.0;

/// Returns the size of a button on the rail at the bottom of a window of this width.
pub fn narrow_size(width: f32) -> Vec2 {
    vec2(
        (width / (GROUPS.len() + 1) as f32 - 4.0).clamp(44.0, 110.0),
        48.0,
    )
}

/// Returns the size of a button on the rail at the side, `height` high. All buttons fit into a low window.
pub fn wide_size(height: f32) -> Vec2 {
    let count = (GROUPS.len() + 1) as f32;
    let room = height / count;
    // Fingers need 44 points, which a room's letters may not leave; in a low window there is no space between two buttons.
    let high = if room >= 56.0 {
        52.0
    } else {
        room.clamp(36.0, 51.0)
    };
    vec2(RAIL - 12.0, high)
}
