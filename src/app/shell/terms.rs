//! Switches for the terms of the equation, with which a lecture builds up the sum term by term. A term is off
//! while its coefficient is 0; the previous value is kept for switching it on again.

use crate::analysis::probe::{Tone, specular_vector};
use crate::app::session::Session;
use crate::app::session::window::WindowState;
use crate::app::widgets::palette::tone_text;
use crate::figure::palette::Vector;
use crate::geometry::built_in;
use crate::scene::{Material, Rgb, Scene};
use crate::text::text;
use eframe::egui::{Checkbox, RichText, Ui};

/// The previous coefficients of the terms that are off.
#[derive(Debug, Default)]
struct SwitchedOff([Option<Rgb>; 3]);

fn coefficients(material: &mut Material) -> [&mut Rgb; 3] {
    [&mut material.ka, &mut material.kd, &mut material.ks]
}

/// Switches a term, given by its index, off or on again; in all of a model's materials, which get their opened values back.
pub fn switch(session: &mut Session, window: &mut WindowState, term: usize) {
    let opened = *coefficients(&mut session.opened().material.clone())[term];
    let usual = *coefficients(&mut Material::default())[term];
    let mut kept: SwitchedOff = window.own.take();
    let value = &mut coefficients(&mut session.shown.scene.material)[term];
    if **value == Rgb::ZERO {
        let known = kept.0[term]
            .take()
            .or(Some(opened).filter(|value| *value != Rgb::ZERO));
        **value = known.unwrap_or(usual);
    } else {
        kept.0[term] = Some(**value);
        **value = Rgb::ZERO;
    }
    let off = **value == Rgb::ZERO;
    window.own.put(kept);
    let Session { shown, initial, .. } = session;
    let object = &mut shown.scene.object;
    let model = built_in(object.kind).or(shown.model.as_ref());
    for material in model.iter().flat_map(|model| &model.materials) {
        let (name, own) = (&material.name, material.face_material());
        let mut wanted = object.material(name, &own);
        let mut opened = initial.object.material(name, &own);
        let restored = *coefficients(&mut opened.material)[term];
        *coefficients(&mut wanted.material)[term] = if off { Rgb::ZERO } else { restored };
        object.change_material(name, &own, &wanted);
    }
}

/// Shows a switch for each term, in the term's colour; in a `wide` window from right to left, with full
/// names.
pub fn switches_ui(ui: &mut Ui, session: &mut Session, window: &mut WindowState, wide: bool) {
    let Scene {
        material,
        reflection,
        ..
    } = &session.shown.scene;
    let mut terms = [
        (
            0,
            ["term-ambient", "term-ambient.short"],
            Tone::Plain,
            material.ka,
        ),
        (
            1,
            ["term-diffuse", "term-diffuse.short"],
            Tone::Of(Vector::L),
            material.kd,
        ),
        (
            2,
            ["term-specular", "term-specular.short"],
            Tone::Of(specular_vector(reflection.model)),
            material.ks,
        ),
    ];
    if wide {
        terms.reverse();
    }
    for (term, name, tone, value) in terms {
        let mut on = value != Rgb::ZERO;
        let name = text!(name[usize::from(!wide)]);
        let name = RichText::new(name).color(tone_text(ui.visuals(), tone));
        if ui
            .add_enabled(session.lock.is_none(), Checkbox::new(&mut on, name))
            .on_disabled_hover_text(text!("course-after-answer"))
            .on_hover_text(text!("term-tip"))
            .clicked()
        {
            switch(session, window, term);
        }
    }
}
