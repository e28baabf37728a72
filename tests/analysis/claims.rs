//! The sentences of the probe about random scenes: each claim against an independent evaluation.

use crate::common::any_scene::{AnyScene, any_scene};
use crate::common::reasons::Judge;
use glam::DVec3;
use rayon::prelude::*;
use shading_lab::analysis::lobe::ReflectionLobe;
use shading_lab::analysis::probe::{
    FilledPart, Here, LightHere, LineValue, ProbeHit, ZeroCause, ZeroCauses, probe,
};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Backfacing, CuedBy, FlatAt, Interpolation, LightKind, ObjectKind, Overflow, ReflectionModel,
    Rgb, Scene, ShadingMode, Through, View,
};
use std::collections::BTreeMap;

/// Returns the seeds that the environment names, or `0..4000`.
fn seeds() -> std::ops::Range<u64> {
    let named = std::env::var("ROBUSTNESS_SEEDS").ok();
    let named = named.as_deref().and_then(|text| text.split_once(".."));
    named.map_or(0..4000, |(from, to)| {
        let [from, to] = [from, to].map(|number| number.parse().expect("FROM..TO"));
        from..to
    })
}

/// Returns the short note and the clause that name a cause.
fn words(cause: ZeroCause, c: &str) -> (&'static str, String) {
    let key = match cause {
        ZeroCause::Muted => "point-zero-muted",
        ZeroCause::NotSoloed => "point-zero-not-soloed",
        ZeroCause::Black => "point-zero-black",
        ZeroCause::Coefficient | ZeroCause::NoChannel => "point-zero-not-reflected",
        ZeroCause::FacesAway => "point-zero-behind",
        ZeroCause::OutsideCone => "point-zero-outside-cone",
        ZeroCause::InShadow => "point-zero-in-shadow",
        ZeroCause::MissesViewer => "point-zero-not-to-viewer",
        ZeroCause::LawIsZero => "point-zero-law",
        ZeroCause::OneTerm => "point-zero-one-term",
        ZeroCause::TooFaint => "point-zero-too-faint",
    };
    let part = if cause == ZeroCause::NoChannel {
        "channel"
    } else {
        "why"
    };
    (english!(key), english!(&format!("{key}.{part}"), c = c))
}

fn clauses(causes: ZeroCauses, c: &str) -> String {
    let all: Vec<_> = causes.iter().map(|cause| words(cause, c).1).collect();
    if all.len() == 1 {
        all[0].clone()
    } else {
        let parts: Vec<_> = all
            .iter()
            .map(|clause| english!("point-zero-in-part", clause = &**clause))
            .collect();
        parts.join(english!("point-clause-gap"))
    }
}

/// The number of claims checked, by kind.
type Met = BTreeMap<&'static str, u32>;

struct Checker<'a> {
    scene: &'a Scene,
    judge: Judge<'a>,
    met: Met,
}

impl Checker<'_> {
    fn meet(&mut self, claim: &'static str) {
        *self.met.entry(claim).or_default() += 1;
    }

    fn check(&mut self, hit: &ProbeHit) -> Result<(), String> {
        let here = Here {
            scene: self.scene,
            hit,
        };
        let parts = here.filled();
        for light in here.lights() {
            self.check_reasons(light, &parts)?;
            self.check_geometry(light)?;
        }
        self.check_display(hit, &parts)?;
        self.check_depth(hit, &parts)?;
        self.check_refraction(hit, &parts)
    }

    /// Checks the reasons given for a light or a term that adds nothing.
    fn check_reasons(&mut self, light: LightHere<'_>, parts: &[FilledPart]) -> Result<(), String> {
        let (terms, source) = (light.terms, light.source);
        self.judge.check(light.here.hit, source, terms)?;
        let line = parts.iter().find_map(|part| match part {
            FilledPart::Line(line) if line.light == Some(light.index) => Some(line),
            _ => None,
        });
        let line = line.ok_or("a light without a line")?;
        let notes: Vec<&str> = line
            .parts
            .iter()
            .filter_map(|part| match part {
                FilledPart::Note(note) => Some(note.as_str()),
                _ => None,
            })
            .collect();
        let w = if terms.reflectance == Rgb::ONE {
            "Ks·Os"
        } else {
            "Ks·Os·W"
        };
        let zero = [terms.diffuse, terms.specular].map(|term| term == Rgb::ZERO);
        let reasons = [(terms.diffuse_zero, "Kd·Od"), (terms.specular_zero, w)];
        for ((causes, _), zero) in reasons.iter().zip(zero) {
            same(causes.is_empty(), !zero, "a reason without a need, or none")?;
        }
        let [diffuse, specular] = reasons.map(|(causes, c)| clauses(causes, c));
        let own = terms.law.is_some();
        if zero == [true, true] {
            let whole = if own || diffuse == specular {
                diffuse
            } else {
                english!("point-zero-both", diffuse = diffuse, specular = specular)
            };
            same(
                notes,
                vec![&english!("point-light-adds-nothing", why = whole)[..]],
                "the note",
            )?;
            let LineValue::Words(short) = &line.value else {
                return Err("a value of nothing".into());
            };
            let one = (own || terms.diffuse_zero == terms.specular_zero)
                && terms.diffuse_zero.iter().count() == 1;
            let cause = terms.diffuse_zero.iter().next().filter(|_| one);
            let expected = cause.map_or(english!("point-zero-nothing"), |cause| words(cause, "").0);
            same(short.as_str(), expected, "the short reason")?;
            self.meet("nothing");
            return Ok(());
        }
        same(
            matches!(line.value, LineValue::Channels(_)),
            true,
            "a value",
        )?;
        for (name, zero, clause) in [
            (english!("point-diffuse"), zero[0], diffuse),
            (english!("point-specular"), zero[1], specular),
        ] {
            let note = english!("point-term-adds-nothing", term = name, why = clause);
            let start = english!("point-term-adds-nothing", term = name, why = "|");
            let start = start.split('|').next().unwrap_or_default();
            // A law of one's own is one term, and says nothing of two.
            let zero = zero && !own;
            same(notes.contains(&&note[..]), zero, &note)?;
            let any = notes.iter().any(|text| text.starts_with(start));
            same(any, zero, name)?;
            if zero {
                self.meet("one term is nothing");
            }
        }
        self.check_formulas(light, &line.parts)
    }

    /// Checks where the equation is said to be evaluated, and which way the highlight is said to point.
    fn check_formulas(&mut self, light: LightHere<'_>, parts: &[FilledPart]) -> Result<(), String> {
        let scene = self.scene;
        let own_place = matches!(scene.shading.mode, ShadingMode::Phong | ShadingMode::Exact);
        let place = match (scene.shading.mode, scene.shading.flat_at) {
            _ if own_place => "",
            (ShadingMode::Flat, FlatAt::Centre) => english!("point-over-centre"),
            (ShadingMode::Flat, FlatAt::ProvokingVertex) => english!("point-over-first-vertex"),
            _ => english!("point-over-vertices"),
        };
        let area = light.source.kind == LightKind::Area;
        let points = english!("point-over-samples", count = light.source.samples);
        let over: Vec<&str> = [if area { &points[..] } else { "" }, place]
            .into_iter()
            .filter(|text| !text.is_empty())
            .collect();
        let said = parts.iter().find_map(|part| match part {
            FilledPart::Evaluated(over) => Some(over.clone()),
            _ => None,
        });
        same(
            said.unwrap_or_default(),
            over.join(english!("point-and")),
            "the places",
        )?;
        let away = english!("point-points-away", vector = "|");
        let away = away.split('|').next_back().unwrap_or_default();
        let away = parts
            .iter()
            .any(|part| matches!(part, FilledPart::Formula(formula) if formula.contains(away)));
        if away {
            let cosine = cosine(scene, light);
            if cosine > 1e-9 {
                return Err(format!("the highlight points here: {cosine}"));
            }
            self.meet("points away");
        }
        Ok(())
    }

    /// Checks the angles and the shadows, and whether R is constructed.
    fn check_geometry(&mut self, light: LightHere<'_>) -> Result<(), String> {
        let (hit, terms) = (light.here.hit, light.terms);
        let rows = light.angles();
        let row = |start: &str| {
            let row = rows.iter().find(|(name, _)| name.starts_with(start));
            row.map(|(_, value)| value.clone())
        };
        let degrees = |text: String| {
            text.trim_end_matches('°')
                .parse::<f64>()
                .unwrap_or(f64::NAN)
        };
        if hit.normal.length() > 1e-3 && terms.l.length() > 0.5 {
            let theta = degrees(row("θ, N").ok_or("no θ")?);
            let own = hit.normal.angle_between(terms.l).to_degrees();
            if (theta - own).abs() > 0.006 + 1e-4 {
                return Err(format!("θ is {own} and not {theta}"));
            }
            self.meet("θ");
        }
        let lit = |n_dot_l: f64| {
            n_dot_l > 0.0 || (self.scene.reflection.backfacing == Backfacing::Flip && n_dot_l < 0.0)
        };
        let mirrored = light.construction().len() >= 4;
        if hit.normal != DVec3::ZERO && terms.n_dot_l.abs() > 1e-12 {
            same(mirrored, lit(hit.normal.dot(terms.l)), "R is built")?;
            let lobe = ReflectionLobe::at(self.scene, hit, light.index).is_some();
            if light.source.kind != LightKind::Area {
                // A law of one's own does not turn N towards the light.
                let back = terms.law.is_some() && terms.n_dot_l < 0.0;
                same(lobe, mirrored && !back, "there is a lobe")?;
            }
            self.meet("the side of the light");
        }
        let single = light.source.kind != LightKind::Area
            && matches!(
                self.scene.shading.mode,
                ShadingMode::Phong | ShadingMode::Exact
            );
        if row(english!("point-light-row")).is_some_and(|said| said == english!("point-in-light"))
            && single
            && terms.why_nothing().is_none()
        {
            same(self.scene.shading.shadows, true, "shadows are known")?;
            // A model's own normals may point anywhere, so that the judge does not know its outside.
            let sound = !matches!(
                self.scene.object.kind,
                ObjectKind::Obj | ObjectKind::Polygons
            ) && self.scene.reflection.backfacing == Backfacing::Clamp;
            let smoothed = hit
                .face
                .is_some_and(|face| self.judge.turns_away(light.source, face, hit.position));
            if sound
                && !smoothed
                && self
                    .judge
                    .is_clearly_blocked(light.source, (hit.position, hit.normal))
            {
                return Err("said to be in light, something stands before it".into());
            }
            self.meet("in light");
        }
        Ok(())
    }

    /// Checks the notes about values above 1.
    fn check_display(&mut self, hit: &ProbeHit, parts: &[FilledPart]) -> Result<(), String> {
        let divided = english!("point-divided", divisor = "|");
        let above = (0..3).any(|channel| hit.sum[channel] > 1.0);
        let overflow = self.scene.display.overflow;
        let note = |start: &str| {
            parts.iter().any(|part| match part {
                FilledPart::Note(note) => note.starts_with(start),
                FilledPart::Line(line) => line.name == start,
                _ => false,
            })
        };
        same(
            note(english!("point-clamped")),
            above && overflow == Overflow::Clamp,
            "clamped",
        )?;
        same(
            note(english!("point-hatched")),
            above && overflow == Overflow::Mark,
            "hatched",
        )?;
        same(
            note(divided.split('|').next().unwrap_or_default()),
            hit.divisor > 1.0 && overflow == Overflow::Scale,
            "scaled",
        )?;
        if above {
            self.meet("above 1");
        }
        Ok(())
    }

    /// Checks the attenuation by depth cueing.
    fn check_depth(&mut self, hit: &ProbeHit, parts: &[FilledPart]) -> Result<(), String> {
        let cueing = &self.scene.depth_cueing;
        let said = english!(
            "point-cue-at-pixel",
            front_scale = "|",
            front = "|",
            back_scale = "|",
            back = "|",
            s0 = "|"
        );
        let Some(note) = note_with(parts, &said) else {
            return Ok(());
        };
        same(cueing.by == CuedBy::Off, false, "depth cueing")?;
        let part = ((hit.depth - cueing.front) / (cueing.back - cueing.front)).clamp(0.0, 1.0);
        let s0 = cueing.front_scale + (cueing.back_scale - cueing.front_scale) * part;
        let said = numbers(&note).last().copied().unwrap_or(f64::NAN);
        if (said - s0).abs() > 2e-3 {
            return Err(format!("s0 is {s0}: {note}"));
        }
        self.meet("s0");
        Ok(())
    }

    /// Checks the angles of refraction.
    fn check_refraction(&mut self, hit: &ProbeHit, parts: &[FilledPart]) -> Result<(), String> {
        let view = View::new(&self.scene.camera, self.scene.image.size);
        let sight = view.towards_eye(hit.position);
        let leaves =
            sight.dot(hit.normal) < 0.0 && self.scene.transparency.through == Through::Solid;
        let eta = self.scene.transparency.ior;
        let key = if leaves {
            "point-snell-out"
        } else {
            "point-snell-in"
        };
        let law = english!(key, v = "|", t = "|", eta = "|");
        if let Some(note) = note_with(parts, &law) {
            let found = numbers(&note);
            let sine = |degrees: f64| degrees.to_radians().sin();
            let (left, right) = if leaves {
                (found[0] * sine(found[1]), sine(found[2]))
            } else {
                (sine(found[0]), found[1] * sine(found[2]))
            };
            if (left - right).abs() > 5e-3 * eta.max(1.0) {
                return Err(format!("{left} is not {right}: {note}"));
            }
            self.meet("Snell");
        }
        let total = english!("point-snell-total", v = "|", eta = "|");
        if let Some(note) = note_with(parts, &total) {
            let sine = (1.0 - sight.dot(hit.normal.normalize_or_zero()).powi(2))
                .max(0.0)
                .sqrt();
            let ratio = if leaves { eta } else { 1.0 / eta };
            if ratio * sine < 1.0 - 1e-6 {
                return Err(format!("no total reflection at {sine}: {note}"));
            }
            self.meet("total reflection");
        }
        Ok(())
    }
}

/// Finds a note that contains the pieces of `text` between its bars, whatever the values in their place, nested lines included.
fn note_with(parts: &[FilledPart], text: &str) -> Option<String> {
    parts.iter().find_map(|part| match part {
        FilledPart::Note(note) if text.split('|').all(|part| note.contains(part)) => {
            Some(note.clone())
        }
        FilledPart::Line(line) => note_with(&line.parts, text),
        _ => None,
    })
}

/// Returns the numbers in a text, in order; a digit that follows a letter belongs to a name.
fn numbers(text: &str) -> Vec<f64> {
    let ends = |c: char| !(c.is_ascii_digit() || c == '.' || c == '−' || c.is_alphabetic());
    let words = text
        .split(ends)
        .map(|word| word.trim_end_matches('.').replace('−', "-"));
    words.filter_map(|word| word.parse().ok()).collect()
}

fn same<T: PartialEq + std::fmt::Debug>(said: T, expected: T, what: &str) -> Result<(), String> {
    if said == expected {
        Ok(())
    } else {
        Err(format!("{what}: {said:?}, expected {expected:?}"))
    }
}

/// Returns R·V or N·H at the point, computed from the vectors alone.
fn cosine(scene: &Scene, light: LightHere<'_>) -> f64 {
    let (hit, l) = (light.here.hit, light.terms.l);
    let flips = scene.reflection.backfacing == Backfacing::Flip && hit.normal.dot(l) < 0.0;
    let n = if flips { -hit.normal } else { hit.normal };
    match scene.reflection.model {
        ReflectionModel::Phong | ReflectionModel::Formula => {
            (n * (2.0 * n.dot(l)) - l).dot(hit.view)
        }
        ReflectionModel::Blinn => n.dot((l + hit.view).normalize_or_zero()),
        ReflectionModel::CookTorrance => n
            .dot((l + hit.view).normalize_or_zero())
            .min(n.dot(hit.view) + 0.25),
    }
}

/// Checks the claims about a random scene and counts them.
fn examine(seed: u64) -> Result<Met, String> {
    let AnyScene { mut scene, model } = any_scene(seed);
    // Interpolation along scan lines takes intensities from corners other than a triangle's.
    scene.shading.interpolation = Interpolation::Perspective;
    scene.shading.shadows |= seed.is_multiple_of(2);
    let Ok(model) = model else {
        return Ok(Met::new());
    };
    if scene.validate().is_err() || scene.lights.len() > 10 {
        return Ok(Met::new());
    }
    let mut renderer = Renderer::default().with_model(model.clone());
    let mut checker = Checker {
        scene: &scene,
        judge: Judge::new(&scene, model.as_deref()),
        met: Met::new(),
    };
    let [width, height] = scene.image.size;
    for y in (1..height).step_by(7) {
        for x in (1..width).step_by(5) {
            if let Some(hit) = probe(&mut renderer, &scene, x, y).hit {
                let told = checker.check(&hit);
                told.map_err(|what| {
                    format!("scene {seed} at {x},{y}: {what}\n{}", scene.to_toml())
                })?;
            }
        }
    }
    Ok(checker.met)
}

#[test]
fn every_claim_about_a_point_holds_in_a_thousand_random_scenes() {
    let seeds = seeds();
    let whole = seeds == (0..4000);
    let outcomes: Vec<_> = seeds.into_par_iter().map(examine).collect();
    let wrong: Vec<_> = outcomes
        .iter()
        .filter_map(|outcome| outcome.as_ref().err())
        .collect();
    let (mut counts, mut scenes) = (Met::new(), 0);
    for met in outcomes.iter().flatten().filter(|met| !met.is_empty()) {
        scenes += 1;
        met.iter()
            .for_each(|(claim, count)| *counts.entry(*claim).or_default() += count);
    }
    println!("{scenes} scenes, {counts:?}");
    assert!(
        wrong.is_empty(),
        "{} scenes are wrong, the first: {}",
        wrong.len(),
        wrong
            .iter()
            .map(|what| &what[..])
            .collect::<Vec<_>>()
            .join("\n")
    );
    if whole {
        assert!(
            scenes >= 1000 && counts.len() >= 10,
            "{scenes} scenes, {counts:?}"
        );
    }
}
