//! The animation's part of the export form: the animated value, its beginning and its end.

use crate::animation::{
    Course, FilmFormat, MOST_FRAMES, Sweep, USUAL_FRAMES, USUAL_RATE, is_number,
};
use crate::app::widgets::focus::named;
use crate::app::widgets::theme::text_field;
use crate::scene::Scene;
use crate::scene::parameter::{Parameter, Slider};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{ComboBox, DragValue, Grid, Ui};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The width of the labels, as in the form above, in points.
const LABELS: f32 = 109.0;

/// The maximum duration that the form offers, in seconds.
const LONGEST: f64 = 600.0;

/// The settings of an animation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FilmForm {
    pub key: String,
    /// The initial value, written as in scene files, like the final one in [`Self::to`].
    pub from: String,
    pub to: String,
    pub frames: u32,
    pub seconds: f64,
    pub logarithmic: bool,
    pub back_and_forth: bool,
}

impl FilmForm {
    /// Creates the form for the specular exponent, from its current value to the end of its slider, but at
    /// most ten times the value.
    pub fn new(scene: &Scene) -> Self {
        let mut form = Self {
            key: String::new(),
            from: String::new(),
            to: String::new(),
            frames: USUAL_FRAMES,
            seconds: f64::from(USUAL_FRAMES) / USUAL_RATE,
            logarithmic: false,
            back_and_forth: false,
        };
        if let Some((parameter, index)) = values(scene).find(|(found, _)| found.key == "material.n")
        {
            form.choose(scene, parameter, index);
        }
        form
    }

    fn choose(&mut self, scene: &Scene, parameter: &'static Parameter, index: usize) {
        self.key = parameter.key(index);
        let value = parameter.short_setting(scene, index).unwrap_or_default();
        let slider = parameter.slider().filter(|_| !value.contains(','));
        let end = |slider: Slider| match value.parse::<f64>() {
            // The whole range of such a slider is too much for a few seconds.
            Ok(value) if slider.logarithmic && value > 0.0 => (10.0 * value).min(slider.to),
            _ => slider.to,
        };
        self.to = slider.map_or_else(|| value.clone(), |slider| end(slider).to_string());
        self.from = value;
        self.logarithmic = slider.is_some_and(|slider| slider.logarithmic);
    }

    /// Returns the sweep that the form requests of a scene, and the film's format by the name of its file.
    ///
    /// # Errors
    /// Returns the error in the form, as a sentence.
    pub fn sweep(&self, scene: &Scene, path: &Path) -> Result<(Sweep, FilmFormat), String> {
        let course = Course {
            frames: self.frames,
            logarithmic: self.logarithmic,
            back_and_forth: self.back_and_forth,
        };
        let setting = |value: &String| [format!("{}={}", self.key, value.trim())];
        let (from, to) = (setting(&self.from), setting(&self.to));
        let sweep = Sweep::new(scene, &from, &to, course).map_err(|error| error.to_string())?;
        let format = FilmFormat::from_path(path).unwrap_or(FilmFormat::Apng);
        let sound = format.check_seconds(sweep.count(), self.seconds);
        sound.map_err(|error| error.to_string())?;
        Ok((sweep, format))
    }
}

/// Returns the numbers of a scene that have an effect, each with the index of its light.
fn values(scene: &Scene) -> impl Iterator<Item = (&'static Parameter, usize)> {
    Parameter::all()
        .filter(|parameter| is_number(parameter))
        .flat_map(|parameter| (0..parameter.count(scene)).map(move |index| (parameter, index)))
        .filter(|(parameter, index)| parameter.idle(scene, *index).is_none())
}

/// Shows the switch and the settings of the animation; `path` gets the extension of its format.
pub fn film_ui(ui: &mut Ui, form: &mut Option<FilmForm>, scene: &Scene, path: &mut String) {
    let mut on = form.is_some();
    let switch = ui.checkbox(&mut on, text!("animation"));
    if switch.on_hover_text(text!("animation-tip")).changed() {
        *form = on.then(|| FilmForm::new(scene));
        set_ending(path, "png");
    }
    let Some(form) = form else {
        return;
    };
    ui.add_space(4.0);
    Grid::new("animation")
        .num_columns(2)
        .min_col_width(LABELS)
        .spacing([16.0, 8.0])
        .show(ui, |ui| {
            ui.label(text!("animation-key"));
            value_ui(ui, form, scene);
            ui.end_row();
            for (name, value) in [
                (text!("animation-from"), &mut form.from),
                (text!("animation-to"), &mut form.to),
            ] {
                ui.label(name);
                let field = text_field(value).desired_width(ui.available_width().min(260.0));
                named(ui.add(field), Role::TextInput, name);
                ui.end_row();
            }
            ui.label(text!("animation-scale"));
            ui.horizontal(|ui| {
                ui.selectable_value(&mut form.logarithmic, false, text!("animation-linear"));
                ui.selectable_value(&mut form.logarithmic, true, text!("animation-logarithmic"));
            });
            ui.end_row();
            let name = text!("animation-frame-count");
            ui.label(name);
            let field = DragValue::new(&mut form.frames).range(2..=MOST_FRAMES);
            named(ui.add(field), Role::SpinButton, name);
            ui.end_row();
            let name = text!("animation-duration");
            ui.label(name);
            ui.horizontal(|ui| {
                let field = DragValue::new(&mut form.seconds)
                    .range(0.01..=LONGEST)
                    .speed(0.1);
                named(ui.add(field), Role::SpinButton, name);
                ui.checkbox(&mut form.back_and_forth, text!("animation-back"));
            });
            ui.end_row();
            ui.label(text!("animation-format"));
            ui.horizontal(|ui| {
                let chosen = FilmFormat::from_path(Path::new(path));
                for (format, name, ending, tip) in [
                    (FilmFormat::Apng, "PNG", "png", text!("animation-apng-tip")),
                    (FilmFormat::Gif, "GIF", "gif", text!("animation-gif-tip")),
                ] {
                    let button = ui.selectable_label(chosen == Some(format), name);
                    if button.on_hover_text(tip).clicked() {
                        set_ending(path, ending);
                    }
                }
            });
            ui.end_row();
        });
}

fn value_ui(ui: &mut Ui, form: &mut FilmForm, scene: &Scene) {
    let all: Vec<_> = values(scene).collect();
    let chosen = all
        .iter()
        .find(|(parameter, index)| parameter.key(*index) == form.key)
        .map(|(parameter, index)| parameter.full_name(*index));
    let list = ComboBox::from_id_salt("animated")
        .width(ui.available_width().min(260.0))
        .selected_text(chosen.unwrap_or_else(|| form.key.clone()))
        .show_ui(ui, |ui| {
            for (parameter, index) in all {
                let key = parameter.key(index);
                let row = ui.selectable_label(key == form.key, parameter.full_name(index));
                if row.on_hover_text(key).clicked() {
                    form.choose(scene, parameter, index);
                }
            }
        });
    named(list.response, Role::ComboBox, text!("animation-key"));
}

/// Replaces a picture's extension by `ending`; a name without one stays as it is.
fn set_ending(path: &mut String, ending: &str) {
    let there = Path::new(path.as_str());
    if FilmFormat::from_path(there).is_some() {
        *path = there.with_extension(ending).display().to_string();
    }
}
