//! The layout of the window, which depends on its size.
//!
//! ```text
//!   wide                                        tall          flat
//!   ┌──────────── menus, modes ────────────┐    ┌─ menus ─┐   ┌──── menus ────────┬────┐
//!   │ equation                             │    │ equation│   │ equation          │    │
//!   ├─────────┬──── title ────┬───────┬────┤    │ title   │   ├────────────┬──────┤rail│
//!   │controls │    picture    │ view  │rail│    │ picture │   │ picture    │drawer│    │
//!   │         ├───────────────┤       │    │    ├─────────┤   │            │      │    │
//!   │         │ a wide view   │       │    │    │ drawer  │   │               │      │
//!   └─────────┴───────────────┴───────┴────┘    └─ rail ──┘   └────────────┴──────┴────┘
//! ```
//!
//! The picture keeps nearly half of the window's width. If there is no space for both panels, the one opened last is
//! shown. The drawer of a narrow window holds the controls or a view.

use super::{bars, welcome};
use crate::app::controls;
use crate::app::course::Course;
use crate::app::engine::Engine;
use crate::app::picture::{self, Room};
use crate::app::session::appearance::ViewName;
use crate::app::session::window::WindowState;
use crate::app::shell::state::AppState;
use crate::app::views::{self, RAIL};
use crate::app::widgets::symbol;
use eframe::egui::{CentralPanel, Frame as Margins, Panel, Rect, Ui, Vec2};

/// The window width below which panels become a drawer, in points.
pub const NARROW: f32 = 900.0;
/// The minimum width of a panel, and of the controls, whose sliders need it, in points.
const PANEL: f32 = 288.0;
const CONTROLS: f32 = 320.0;
/// The minimum side of the picture in a narrow window, in points.
const PICTURE: f32 = 300.0;
/// The minimum side of the picture beside a drawer in a narrow window, and above a lesson, whose text and question need the
/// space, in points; [`DRAWER`] is the drawer's own width.
const LEAST: f32 = 176.0;
const DRAWER: f32 = 250.0;
/// The default fraction of the height that a wide view takes below the picture.
const BELOW: f32 = 0.46;
/// The window height below which only the essentials are above the picture, in points.
const LOW: f32 = 520.0;
/// The window height below which even the equation is hidden, in points: half of a phone's screen may be a
/// keyboard.
const LOWEST: f32 = 380.0;

/// The layout's memory of the last frame.
#[derive(Debug, Default)]
pub struct Layout {
    /// True if the controls were open in the last frame, and the view that was; `None` before the first.
    open: Option<(bool, Option<ViewName>)>,
    /// True if the window is higher than wide. Unchanged while text is edited, so that a field keeps its
    /// place when a phone's keyboard makes the window lower.
    tall: bool,
    /// The panel that was closed because there was no space for both: the controls, or a view.
    closed: Option<ClosedPanel>,
    /// True if a live class was shown in a low window in the last frame.
    wall: bool,
    /// The last rectangle of the picture, in points.
    pub picture: Option<Rect>,
}

/// A panel that was closed because there was no space for both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ClosedPanel {
    Controls,
    View,
}

impl Layout {
    /// Shows everything but dialogs. Returns the size available to the picture, if it is visible.
    pub fn ui(&mut self, ui: &mut Ui, state: &mut AppState, engine: &mut Engine) -> Option<Room> {
        let size = ui.available_size();
        let AppState {
            session,
            window,
            course,
            requests,
            ..
        } = state;
        controls::pull_ui(ui, session, window);
        window.appearance.controls |= symbol::opens_controls(ui.ctx());
        if window.picture_alone {
            return Some(self.picture_ui(ui, state, engine));
        }
        let (narrow, low) = (size.x < NARROW, size.y < LOW);
        window.drawer = narrow;
        // In the size for a projector, a class has the whole window: else its answers would have no room.
        let wall = low && course.teaches() && window.shows(ViewName::Class);
        window.enlarged |= wall && !self.wall;
        self.wall = wall;
        if !ui.ctx().text_edit_focused() {
            self.tall = size.y > size.x;
        }
        Panel::top("menus").show(ui, |ui| {
            bars::menus_ui(ui, session, window, course, requests, low);
        });
        if window.enlarged && window.appearance.views {
            CentralPanel::default().show(ui, |ui| {
                views::view_ui(ui, session, window, course, requests, engine, narrow);
            });
            session.commit();
            return None;
        }
        window.enlarged = false;
        self.make_room(window, course, size);
        // A narrow window with a lesson has space for picture and question only.
        let reads = narrow && reads_lesson(window, course);
        if window.appearance.equation && size.y >= LOWEST && !reads {
            Panel::top("equation").show(ui, |ui| bars::equation_ui(ui, session, window));
        }
        controls::letter_ui(ui, session, window);
        window.appearance.controls |= symbol::opens_controls(ui.ctx());
        // The welcome leaves no space for a drawer.
        if narrow && window.welcome {
            (window.appearance.controls, window.appearance.views) = (false, false);
        }
        if narrow {
            drawer_ui(ui, state, engine, size, self.tall);
        } else {
            panels_ui(ui, state, engine, size);
        }
        let AppState {
            session,
            window,
            course,
            requests,
            ..
        } = state;
        // A scene that a scene file would refuse is not drawn.
        session.commit();
        // A lesson explains its scenes; their own sentences, meant for other uses, would mislead.
        let reads = narrow && reads_lesson(window, course);
        if !(low || reads || course.shows_step()) {
            Panel::top("title").show(ui, |ui| {
                bars::title_ui(ui, session, window, course, requests);
            });
        }
        welcome::welcome_ui(ui, window, requests, low);
        Some(self.picture_ui(ui, state, engine))
    }

    fn picture_ui(&mut self, ui: &mut Ui, state: &mut AppState, engine: &mut Engine) -> Room {
        let AppState {
            session,
            window,
            course,
            requests,
            ..
        } = state;
        let shown = CentralPanel::default().frame(Margins::NONE).show(ui, |ui| {
            picture::picture_ui(ui, session, window, course, requests, engine)
        });
        self.picture = Some(shown.response.rect);
        shown.inner
    }

    /// Closes a panel if there is no space for both: the one opened first, or at once the controls beside a
    /// lesson or answers handed in. It opens again when there is space.
    fn make_room(&mut self, window: &mut WindowState, course: &Course, size: Vec2) {
        let open = [window.appearance.controls, window.appearance.views];
        let view = |window: &WindowState| {
            let appearance = &window.appearance;
            appearance.views.then_some(appearance.view)
        };
        // The welcome makes way for what is opened.
        let opened =
            |(controls, last): (bool, _)| open[0] && !controls || open[1] && view(window) != last;
        if self.open.is_some_and(opened) {
            window.end_welcome();
        }
        let beside = size.x < NARROW || !views::stands_below(window);
        if open == [true, true] && beside && panel_room(size) < CONTROLS + PANEL {
            let reads = window.shows(ViewName::Course) && course.heading().is_some();
            let controls_first = match self.open {
                Some((true, None)) => true,
                Some((false, Some(_))) => false,
                _ => reads,
            };
            (window.appearance.controls, window.appearance.views) =
                (!controls_first, controls_first);
            self.closed = Some(if controls_first {
                ClosedPanel::Controls
            } else {
                ClosedPanel::View
            });
        } else if panel_room(size) >= CONTROLS + PANEL {
            match self.closed.take() {
                Some(ClosedPanel::Controls) if open[1] => window.appearance.controls = true,
                Some(ClosedPanel::View) if open[0] => window.appearance.views = true,
                _ => {}
            }
        }
        self.open = Some((window.appearance.controls, view(window)));
    }
}

/// Returns whether a lesson is open and visible.
fn reads_lesson(window: &WindowState, course: &Course) -> bool {
    window.shows(ViewName::Course) && course.open.is_some()
}

/// Returns the width available to panels, in points: nearly half of the window is the picture's. A narrow window has
/// one panel.
fn panel_room(size: Vec2) -> f32 {
    if size.x < NARROW {
        PANEL
    } else {
        0.53 * size.x - RAIL
    }
}

/// Shows the controls at the left, the view at the right or below the picture, and the rail.
fn panels_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine, size: Vec2) {
    let AppState {
        session,
        window,
        course,
        requests,
        ..
    } = state;
    if window.appearance.stages {
        Panel::bottom("stages").show(ui, |ui| {
            bars::stages_ui(ui, session, window, course, requests, engine);
        });
    }
    Panel::right("rail")
        .resizable(false)
        .exact_size(RAIL)
        .show(ui, |ui| {
            ui.add_space(4.0);
            let size = views::wide_size(ui.available_height());
            views::rail_ui(ui, window, false, size);
        });
    let room = panel_room(size);
    let below = window.appearance.views && views::stands_below(window);
    let beside = window.appearance.views && !below;
    let mut left = room;
    if window.appearance.controls {
        let most = if beside { room - PANEL } else { room };
        let panel = Panel::left("controls")
            .resizable(true)
            .default_size(CONTROLS.max(0.26 * size.x).min(360.0))
            .size_range(CONTROLS..=most.clamp(CONTROLS, 560.0));
        let shown = panel.show(ui, |ui| {
            controls::controls_ui(ui, session, window, requests, engine);
        });
        left -= shown.response.rect.width();
        session.commit();
    }
    if beside {
        // Wider for a lesson, which is read and has questions to answer.
        let lesson = matches!(window.appearance.view, ViewName::Course | ViewName::Class);
        let (name, share, most) = if lesson {
            ("course", 0.34, 520.0)
        } else {
            ("view", 0.26, 380.0)
        };
        Panel::right(name)
            .resizable(true)
            .default_size(PANEL.max(share * size.x).min(most))
            .size_range(PANEL..=left.clamp(PANEL, 720.0))
            .show(ui, |ui| {
                views::view_ui(ui, session, window, course, requests, engine, false);
            });
    }
    if below {
        let height = ui.available_height();
        Panel::bottom("wide-view")
            .resizable(true)
            .default_size(BELOW * height)
            .size_range(140.0..=(height - PICTURE).max(140.0))
            .show(ui, |ui| {
                views::view_ui(ui, session, window, course, requests, engine, false);
            });
    }
}

/// Shows the rail at the bottom or side, and a drawer for what it opens: below a tall window's picture or beside a
/// flat one's, which is fitted into what is left.
fn drawer_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine, size: Vec2, tall: bool) {
    let AppState {
        session,
        window,
        course,
        requests,
        ..
    } = state;
    if tall {
        Panel::bottom("rail-below").show(ui, |ui| {
            ui.horizontal(|ui| views::rail_ui(ui, window, true, views::narrow_size(size.x)));
        });
    } else {
        Panel::right("rail")
            .resizable(false)
            .exact_size(RAIL)
            .show(ui, |ui| {
                let size = views::wide_size(ui.available_height());
                views::rail_ui(ui, window, true, size);
            });
    }
    let controls = window.appearance.controls;
    if !controls && !window.appearance.views {
        return;
    }
    let lesson = !controls && reads_lesson(window, course);
    let show = |ui: &mut Ui| {
        if controls {
            controls::controls_ui(ui, session, window, requests, engine);
        } else {
            views::view_ui(ui, session, window, course, requests, engine, true);
        }
    };
    let height = ui.available_height();
    if tall {
        let (name, share, picture) = if lesson {
            ("lesson", 0.6, LEAST)
        } else {
            ("drawer", 0.45, PICTURE)
        };
        Panel::bottom(name)
            .resizable(true)
            .default_size(share * height)
            .size_range(160.0..=(height - picture).max(160.0))
            .show(ui, show);
    } else {
        let (name, share) = if lesson {
            ("lesson-beside", 0.5)
        } else {
            ("drawer-beside", 0.45)
        };
        let most = (ui.available_width() - LEAST).max(DRAWER);
        Panel::right(name)
            .resizable(true)
            .default_size((share * size.x).max(PANEL).clamp(DRAWER, most))
            .size_range(DRAWER..=most)
            .show(ui, show);
    }
}
