//! Links: copying the link to the current view, opening one, and showing it to an audience as a QR code.

use super::dialog::{Dialog, LinkCode, PageForm};
use crate::app::session::action::{Action, Requests, Turn};
use crate::app::session::appearance::ViewName;
use crate::app::session::document::{Document, Origin};
use crate::app::session::place::{ProbePoint, ProfileLine};
use crate::app::shell::state::AppState;
use crate::app::system;
use crate::app::widgets::code::{code_side, qr_code_ui};
use crate::app::widgets::dialog::Choice;
use crate::app::widgets::focus::{heading, named, take_if_free};
use crate::app::widgets::theme::text_field;
use crate::figure::QrCode;
use crate::lesson::may_open;
use crate::link::{Link, Shown, VIEWS, WriteError, Written, page, read, write};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat, TextWrapping};
use eframe::egui::{
    Align, Area, Color32, Context, Event, FontId, Galley, Id, Key, OpenUrl, Order, OutputCommand,
    Painter, Rect, Sense, Ui, UiBuilder, Vec2, pos2,
};
use std::sync::Arc;

/// The divisor that yields the size of the letters below a QR code from the window's height. [`COLUMNS`] is
/// the one for its width, and [`LETTERS`] the bounds of the size, in points.
const LINES: f32 = 30.0;
const COLUMNS: f32 = 24.0;
const LETTERS: [f32; 2] = [12.0, 32.0];
/// The maximum number of lines of a link below its code; a longer one is cut.
const ROWS: usize = 3;
/// The distance between the code, its text and the window's edge, in points.
const GAP: f32 = 10.0;
/// The colour of the text below a code, with a contrast of 7:1 against white.
const GREY: Color32 = Color32::from_gray(88);

impl AppState {
    /// Returns the state of the window that goes into a link.
    fn shown_in_links(&self) -> Shown {
        let name = serde_json::to_value(self.window.appearance.view);
        let is_open = |view: &&str| name.as_ref().is_ok_and(|name| name == view);
        let view = VIEWS.into_iter().find(|view| is_open(view));
        // A lecturer's own lesson is a file, which a link cannot contain.
        let lesson = self.course.open.as_ref().filter(|open| open.built_in);
        let lesson = lesson.filter(|open| open.in_view && self.window.shows(ViewName::Course));
        Shown {
            view: view.filter(|_| self.window.appearance.views),
            probe: Some(self.window.probe.0),
            line: self
                .window
                .shows(ViewName::Profile)
                .then_some(self.window.line.0),
            lesson: lesson.map(|open| open.lesson.name.clone()),
            step: lesson.map(|open| open.step as u32 + 1),
            ..Shown::default()
        }
    }

    /// Returns the link to the current view.
    pub fn link(&self) -> Result<Written, WriteError> {
        let origin = match &self.session.document().origin {
            Origin::BuiltIn(name) => Some(name.as_str()),
            Origin::New | Origin::File(_) => None,
        };
        write(
            &self.window.appearance.page,
            &self.session.document().scene,
            origin,
            &self.shown_in_links(),
        )
    }

    /// Returns the place in a browser's history: the lesson with its step, and what is open in the drawer of a narrow window.
    pub fn place(&self) -> String {
        let open = self.course.open.as_ref().filter(|open| open.in_view);
        let step = open.map_or_else(String::new, |open| {
            format!("{} {}", open.lesson.name, open.step)
        });
        let appearance = &self.window.appearance;
        let drawer = [appearance.controls, appearance.views];
        match drawer.iter().position(|open| *open) {
            Some(panel) if self.window.drawer => format!("{step}|{panel}"),
            _ => format!("{step}|"),
        }
    }

    /// Returns to a place that a browser has kept, with its link: closes the drawer, turns the lesson's step, or opens the
    /// scene.
    pub fn go_back(&mut self, link: &str, place: &str) {
        let step_of = |place: &str| place.split('|').next().unwrap_or_default().to_owned();
        if step_of(&self.place()) != step_of(place)
            && let Ok(Link { scene, name, shown }) = read(link)
        {
            if shown.lesson.is_none() {
                self.turn(Turn::List);
                self.open(Document::named(scene, name));
            }
            self.show(&shown);
        }
        if self.window.drawer {
            let open = place
                .rsplit('|')
                .next()
                .and_then(|panel| panel.parse().ok());
            let appearance = &mut self.window.appearance;
            (appearance.controls, appearance.views) = (open == Some(0), open == Some(1));
        }
    }

    /// Shows the state contained in a link.
    pub fn show(&mut self, shown: &Shown) {
        if let Some(view) = shown.view.and_then(ViewName::named) {
            self.window.show_view(view);
        }
        self.window.probe = shown.probe.map_or(self.window.probe, ProbePoint);
        self.window.line = shown.line.map_or(self.window.line, ProfileLine);
        if let Some(lesson) = &shown.lesson {
            match crate::lesson::find(lesson) {
                Some(found) => {
                    let step = shown.step.unwrap_or(1).saturating_sub(1);
                    self.turn(Turn::OpenAt(found.name.to_owned(), step as usize));
                }
                None => {
                    let words = text!("link-no-lesson", name = lesson.as_str());
                    self.dialog = Some(Dialog::message(text!("link-not-opened"), words));
                }
            }
        }
    }

    /// Opens a link. For a wrong link, shows the error and leaves the document open.
    pub fn open_link(&mut self, text: &str) {
        match read(text) {
            Ok(Link { scene, name, shown }) => {
                if self.open(Document::named(scene, name)) {
                    self.window.seek_highlight = shown.probe.is_none();
                    self.show(&shown);
                    self.session.notice = Some(text!("link-opened").into());
                }
            }
            Err(error) => {
                self.dialog = Some(Dialog::message(text!("link-not-opened"), error.to_string()));
            }
        }
    }

    /// Copies the link to the current view to the clipboard, and says what it leaves out.
    pub fn copy_link(&mut self, ctx: &Context) {
        match self.link() {
            Ok(Written { link, left_out }) => {
                ctx.copy_text(link);
                self.session.notice = Some(match left_out {
                    None if self.window.appearance.page.is_empty() => {
                        text!("link-copied-text").into()
                    }
                    None => text!("link-copied").into(),
                    Some(path) => text!("link-copied-model", path = name_of(&path)).into(),
                });
            }
            Err(error) => self.no_link(&error.to_string()),
        }
    }

    /// Opens the current view in a page of its own.
    pub fn open_page(&mut self, ctx: &Context) {
        match self.link() {
            Ok(Written { link, .. }) => ctx.open_url(OpenUrl::new_tab(link)),
            Err(error) => self.no_link(&error.to_string()),
        }
    }

    /// Shows the link as a QR code; if the page for phones is unknown, asks for it first.
    pub fn show_code(&mut self) {
        if self.window.appearance.page.is_empty() {
            return self.ask_page(true);
        }
        let Written { link, left_out } = match self.link() {
            Ok(written) => written,
            Err(error) => return self.no_link(&error.to_string()),
        };
        match QrCode::new(&link) {
            Some(code) => {
                let left_out = left_out.map(|path| name_of(&path));
                self.dialog = Some(Dialog::LinkCode(LinkCode {
                    link,
                    code,
                    left_out,
                }));
            }
            None => self.no_link(&text!("link-too-long-for-code", length = link.len())),
        }
    }

    /// Asks for the address of the page that links begin with.
    pub fn ask_page(&mut self, then_code: bool) {
        self.dialog = Some(Dialog::Page(PageForm {
            address: self.window.appearance.page.clone(),
            wrong: None,
            then_code,
        }));
    }

    /// Takes over the address, or shows the error in it.
    pub fn set_page(&mut self, form: PageForm) {
        let address = match form.address.trim() {
            // Links then begin with their question mark.
            "" if !form.then_code => Ok(String::new()),
            address => page(address),
        };
        match address {
            Ok(address) => {
                self.window.appearance.page = address;
                if form.then_code {
                    self.requests.ask(Action::ShowCode);
                }
            }
            Err(wrong) => {
                let wrong = Some(wrong);
                self.dialog = Some(Dialog::Page(PageForm { wrong, ..form }));
            }
        }
    }

    fn no_link(&mut self, why: &str) {
        self.dialog = Some(Dialog::message(text!("link-not-made"), why.to_owned()));
    }
}

/// Opens the addresses requested in this frame, if [`may_open`] allows them. The requests of all widgets go
/// through here, so that no text of a lesson reaches the desktop or the browser in another way.
pub fn open_addresses(ctx: &Context) {
    let mut addresses = Vec::new();
    ctx.output_mut(|output| {
        output.commands.retain(|command| match command {
            OutputCommand::OpenUrl(open) => {
                addresses.push(open.url.clone());
                false
            }
            _ => true,
        });
    });
    for address in addresses.iter().filter(|address| may_open(address)) {
        system::open_address(ctx, address);
    }
}

fn name_of(path: &std::path::Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}

/// Shows the question for the page's address.
pub fn page_ui(ui: &mut Ui, form: &mut PageForm, requests: &mut Requests) -> Choice {
    let mut choice = Choice::Stay;
    heading(ui, text!("link-page"));
    ui.add_space(8.0);
    if form.then_code {
        // Sharing works at once, without any page.
        ui.label(text!("link-share-text"));
        ui.horizontal_wrapped(|ui| {
            for (name, action) in [
                (text!("link-copy-text"), Action::CopyLink),
                (text!("controls-command-save-as"), Action::SaveAs),
                (text!("controls-command-export"), Action::Export),
            ] {
                if ui.button(name).clicked() {
                    requests.ask(action);
                    choice = Choice::Leave;
                }
            }
        });
        ui.add_space(12.0);
    }
    ui.label(text!("link-page.sentence"));
    ui.add_space(8.0);
    let field = text_field(&mut form.address)
        .hint_text("https://example.org/shading-lab/")
        .desired_width(f32::INFINITY);
    let field = named(ui.add(field), Role::TextInput, text!("link-page"));
    if field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
        choice = Choice::Accept;
    } else {
        take_if_free(&field);
    }
    // The line is there before there is an error, so that nothing moves.
    let wrong = form.wrong.as_deref().unwrap_or(" ");
    ui.colored_label(ui.visuals().error_fg_color, wrong);
    ui.add_space(12.0);
    ui.horizontal(|ui| {
        let verb = if form.then_code {
            text!("link-show-code")
        } else {
            text!("save")
        };
        if ui.button(verb).clicked() {
            choice = Choice::Accept;
        }
        if ui.button(text!("cancel")).clicked() {
            choice = Choice::Leave;
        }
    });
    choice
}

/// Shows a QR code over the whole window, black on white in either theme for the sake of readers and
/// projectors. Any key or click closes it. Returns whether it stays open.
pub fn code_ui(ctx: &Context, shown: &LinkCode) -> bool {
    let room = ctx.content_rect();
    Area::new(Id::unique("link-code"))
        .order(Order::Foreground)
        .fixed_pos(room.min)
        .show(ctx, |ui| {
            let response = ui.allocate_rect(room, Sense::click());
            let name = text!("link-code-of", link = shown.link.as_str());
            named(response, Role::Image, &name);
            paint(ui, room, shown);
        });
    let closes = |event: &Event| match event {
        Event::Key {
            pressed, repeat, ..
        } => *pressed && !repeat,
        Event::PointerButton { pressed, .. } => *pressed,
        _ => false,
    };
    !ctx.input(|input| input.events.iter().any(closes))
}

fn paint(ui: &mut Ui, room: Rect, shown: &LinkCode) {
    ui.painter().rect_filled(room, 0.0, Color32::WHITE);
    let inner = room.shrink(GAP);
    let letters = (room.height() / LINES).min(room.width() / COLUMNS);
    let letters = letters.clamp(LETTERS[0], LETTERS[1]);
    let text = |text: String, size: f32, colour: Color32, rows: usize| {
        lines(ui.painter(), text, size, colour, rows, inner.width())
    };
    let short = shown
        .link
        .split_once("://")
        .map_or(&*shown.link, |(_, rest)| rest);
    let mut texts = vec![text(short.to_owned(), letters, Color32::BLACK, ROWS)];
    let small = (0.7 * letters).max(LETTERS[0]);
    if let Some(path) = &shown.left_out {
        let stays = text!("link-model-stays", path = path.as_str());
        texts.push(text(stays, small, GREY, ROWS));
    }
    texts.push(text(text!("link-code-closes").to_owned(), small, GREY, 1));
    let below: f32 = texts.iter().map(|text| text.size().y + 0.5 * GAP).sum();
    let side = inner.width().min(inner.height() - below);
    let size = code_side(&shown.code, side, ui.ctx().pixels_per_point());
    let left = inner.center().x - 0.5 * size;
    let top = inner.top() + 0.5 * (inner.height() - below - size).max(0.0);
    let place = Rect::from_min_size(pos2(left, top), Vec2::splat(size));
    let mut child = ui.new_child(UiBuilder::new().max_rect(place));
    qr_code_ui(&mut child, &shown.code, side);
    let mut y = top + size;
    for text in texts {
        let (height, colour) = (text.size().y, Color32::BLACK);
        ui.painter().galley(pos2(inner.center().x, y), text, colour);
        y += height + 0.5 * GAP;
    }
}

/// Lays out centred lines; text beyond the available space is cut.
fn lines(
    painter: &Painter,
    text: String,
    size: f32,
    colour: Color32,
    rows: usize,
    width: f32,
) -> Arc<Galley> {
    let format = TextFormat::simple(FontId::proportional(size), colour);
    let mut job = LayoutJob::single_section(text, format);
    job.wrap = TextWrapping {
        max_width: width.max(size),
        max_rows: rows,
        break_anywhere: true,
        ..TextWrapping::default()
    };
    job.halign = Align::Center;
    painter.layout_job(job)
}
