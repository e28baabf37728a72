//! A lesson on paper: its text and pictures, questions with room to write, and the answers on a page of their own.

use super::axes::CurveAxes;
use super::builtin::topic_name;
use super::class::{ClassQuestion, letter};
use super::html::{Html, escaped};
use super::page::{blocks, data, inline, page, picture};
use super::{
    Budget, Kind, Lab, LabPlace, Lesson, LessonError, Question, Solution, Stage, Staged, Step,
};
use crate::analysis::{
    NormalField, OverlayLayer, OverlayOptions, ProfileQuestion, VertexNormal, comparison_sheet,
    draw_normals, draw_overlay, draw_panes, draw_profile, panes_on_sheet, probe, profile,
};
use crate::figure::{Drawing, Shape};
use crate::render::{Frame, Renderer};
use crate::scene::parameter::Parameter;
use crate::scene::{CompareView, Scene};
use crate::text::{fixed, text};
use glam::DVec2;
use std::convert::Infallible;
use std::fmt::Write as _;
use tiny_skia::PixmapMut;

/// What a worksheet has.
#[derive(Clone, Copy, Debug)]
pub struct Worksheet {
    /// Whether the answers are on the last pages.
    pub answers: bool,
    /// Decides what is drawn at random.
    pub seed: u64,
    /// A pixel of its pictures; 0 leaves them blank.
    pub samples: u32,
}

const STYLE: &str = "\
header { border-bottom: 0.5mm solid #1a1a1a; margin-bottom: 5mm; padding-bottom: 2mm; }
.name { display: flex; gap: 8mm; margin: 4mm 0 1mm; }
.name span { flex: 2; border-bottom: 0.3mm solid #777; min-height: 6mm; }
.name span:last-child { flex: 1; }
.step { margin-bottom: 6mm; }
.step::after { content: ''; display: block; clear: both; }
figure.picture { float: right; width: 64mm; margin: 1mm 0 3mm 6mm; }
figure.wide { float: none; width: 100%; max-width: 150mm; margin: 1mm 0 3mm; }
figure img { width: 100%; height: auto; display: block; }
.question { clear: both; break-inside: avoid; border: 0.3mm solid #888; border-radius: 1.5mm; padding: 3mm 4mm 2mm; margin: 3mm 0; }
.question img { width: 96mm; max-width: 100%; height: auto; display: block; margin: 2mm 0; }
.question svg { max-width: 150mm; margin: 2mm 0; }
.options { list-style: none; padding: 0; }
.options li { margin-bottom: 1.4mm; }
.box { display: inline-block; width: 3.6mm; height: 3.6mm; border: 0.3mm solid #444; margin-right: 2mm; vertical-align: -0.4mm; }
.blank { display: inline-block; min-width: 34mm; border-bottom: 0.3mm solid #777; }
.short { min-width: 14mm; }
.rule { border-bottom: 0.3mm solid #bbb; height: 8mm; }
.rules { margin-bottom: 2mm; }
.pair { display: flex; flex-wrap: wrap; gap: 6mm; }
.pair figure { width: 60mm; }
.pair img { width: 60mm; }
.items { display: flex; flex-wrap: wrap; gap: 4mm; }
.items figure { width: 36mm; }
.items img { width: 36mm; }
.answers { break-before: page; }
.answer { break-inside: avoid; border-top: 0.3mm solid #bbb; padding-top: 2mm; margin-bottom: 4mm; }
.answer img { width: 64mm; }
.answer .points { max-width: 64mm; }
.answer svg { max-width: 120mm; }
";

/// The page; `progress` is told of each step that is done.
///
/// # Errors
/// What is wrong with the lesson, with its line.
pub fn worksheet(
    lesson: &Lesson,
    sheet: Worksheet,
    progress: &mut dyn FnMut(),
) -> Result<String, LessonError> {
    let title = inline(&lesson.title);
    let about = text!(
        "class-about",
        topic = topic_name(&lesson.topic),
        minutes = lesson.minutes
    );
    let mut body = format!(
        "<header>\n<h1>{title}</h1>\n<p class=\"quiet\">{}</p>\n",
        escaped(&about)
    );
    if !lesson.about.is_empty() {
        let _ = writeln!(body, "<p>{}</p>", inline(&lesson.about));
    }
    let (name, date) = (escaped(text!("class-name")), escaped(text!("class-date")));
    let _ = write!(
        body,
        "<div class=\"name\"><span class=\"quiet\">{name}</span><span class=\"quiet\">{date}</span></div>\n</header>\n"
    );
    let mut answers = String::new();
    let mut number = 0;
    let budget = Budget::of_file();
    for (index, step) in lesson.steps.iter().enumerate() {
        let part = StepPart::new(lesson, (index, step), sheet, &budget)?;
        body.push_str(&part.body);
        if let Some(question) = part.question {
            number += 1;
            let _ = write!(
                body,
                "<div class=\"question\">\n<p><strong>{}</strong> {}</p>\n{}</div>\n",
                escaped(&text!("class-question", number = number)),
                question.ask,
                question.room
            );
            let _ = write!(
                answers,
                "<div class=\"answer\">\n<p><strong>{}</strong> {}</p>\n{}</div>\n",
                escaped(&text!("class-question", number = number)),
                question.ask,
                question.answer
            );
        }
        body.push_str("</section>\n");
        progress();
    }
    if sheet.answers && number > 0 {
        let heading = escaped(&text!("class-answers", title = &*lesson.title));
        let _ = write!(
            body,
            "<section class=\"answers\">\n<h1>{heading}</h1>\n{answers}</section>\n"
        );
    }
    Ok(page(&lesson.title, STYLE, Html::made(body)))
}

struct StepPart {
    body: String,
    question: Option<QuestionPart>,
}

/// As HTML.
struct QuestionPart {
    ask: String,
    room: String,
    answer: String,
}

impl StepPart {
    fn new(
        lesson: &Lesson,
        (index, step): (usize, &Step),
        sheet: Worksheet,
        budget: &Budget,
    ) -> Result<Self, LessonError> {
        let staged = step.stage.load(lesson.folder.as_deref())?;
        let lab = Lab::within(&staged, budget);
        let place = lab.place(&staged);
        let wrong = |(line, words): (u64, String)| LessonError::one(line, words);
        let text = step.text.filled(&place).map_err(wrong)?;
        let title = inline(&step.title);
        let own_picture =
            |question: &Question| matches!(question.kind, Kind::Point { .. } | Kind::Match { .. });
        let mut body = format!(
            "<section class=\"step\">\n<h2>{}. {title}</h2>\n",
            index + 1
        );
        let question = |words: String| {
            let line = step
                .question
                .as_ref()
                .map_or(step.line, |question| question.line);
            wrong((line, text!("lesson-question", words = words)))
        };
        let frame = stage_picture(&lab, step, &staged, sheet.samples);
        let frame = frame.map_err(|words| wrong((step.line, words)))?;
        if !step.question.as_ref().is_some_and(own_picture) {
            let panes = staged.scene.compare.panes.is_empty();
            let class = if panes && frame.width < 2 * frame.height {
                "picture"
            } else {
                "picture wide"
            };
            let image = picture(&frame, &step.title);
            let _ = writeln!(body, "<figure class=\"{class}\">{image}</figure>");
        }
        body.push_str(&blocks(&text).to_string());
        let mut part = Self {
            body,
            question: None,
        };
        if let Some(asks) = &step.question {
            let mut asked = ClassQuestion::filled(index, asks, place).map_err(wrong)?;
            let target = matches!(asks.kind, Kind::Match { .. });
            if sheet.answers || target && sheet.samples > 0 {
                let solution = asks.solve(place, sheet.seed);
                asked.solution = Some(solution.map_err(question)?);
            }
            part.question = Some(QuestionPart {
                room: room(&asked, asks, place, &frame, sheet).map_err(question)?,
                answer: answer(&asked, asks, &frame),
                ask: inline(&asked.ask).to_string(),
            });
        }
        Ok(part)
    }
}

/// Where the student answers.
fn room(
    asked: &ClassQuestion,
    question: &Question,
    place: LabPlace<'_>,
    frame: &Frame,
    sheet: Worksheet,
) -> Result<String, String> {
    let line = "<span class=\"blank\"></span>";
    let mut out = String::new();
    match &question.kind {
        Kind::Choice { .. } => {
            out.push_str("<ul class=\"options\">\n");
            for (index, words) in asked.options.iter().enumerate() {
                let _ = writeln!(
                    out,
                    "<li><span class=\"box\"></span>{} {}</li>",
                    letter(index),
                    inline(words)
                );
            }
            out.push_str("</ul>\n");
        }
        Kind::Value { unit, .. } => {
            let _ = writeln!(
                out,
                "<p>{} {line} {}</p>",
                escaped(text!("class-answer")),
                escaped(unit)
            );
        }
        Kind::Point { .. } => {
            let _ = writeln!(
                out,
                "<p class=\"quiet\">{}</p>\n{}",
                escaped(text!("class-mark")),
                picture(frame, &asked.ask)
            );
        }
        Kind::Curve {
            x,
            y,
            x_name,
            y_name,
            ..
        } => {
            let axes = CurveAxes::new([*x, *y], [&x_name.plain(), &y_name.plain()]);
            let _ = writeln!(
                out,
                "<figure>{}</figure>",
                axes.on_page().to_svg(&axes.words())
            );
        }
        Kind::Settings { control, .. } => {
            let _ = writeln!(out, "<p>{} = {line}</p>", control_name(control));
        }
        Kind::Order { items, .. } => {
            let small = |set: &[String]| match sheet.samples {
                0 => Ok(blank()),
                _ => place.under(set)?.counted_picture(),
            };
            out.push_str("<div class=\"items\">\n");
            for (index, (item, words)) in items.iter().zip(&asked.options).enumerate() {
                let image = if item.set.is_empty() {
                    String::new()
                } else {
                    picture(&thumbnail(&small(&item.set)?), words).to_string()
                };
                let _ = writeln!(
                    out,
                    "<figure>{image}<p>{} {}</p></figure>",
                    letter(index),
                    inline(words)
                );
            }
            let blanks = vec!["<span class=\"blank short\"></span>"; items.len()].join(" &lt; ");
            let _ = writeln!(out, "</div>\n<p>{blanks}</p>");
        }
        Kind::Match { controls, .. } => {
            let target = match &asked.solution {
                Some(Solution::Match(values)) => {
                    let settings = super::solve::matched_settings(controls, values);
                    let target = place.under(&question.set)?.under(&settings)?;
                    Some(target.counted_picture()?)
                }
                _ => None,
            };
            let caption = |words: &str| format!("<figcaption>{}</figcaption>", escaped(words));
            let _ = write!(
                out,
                "<div class=\"pair\"><figure>{}{}</figure>",
                picture(frame, ""),
                caption(text!("class-start"))
            );
            if let Some(target) = target {
                let words = text!("class-target", seed = sheet.seed.to_string());
                let _ = write!(
                    out,
                    "<figure>{}{}</figure>",
                    picture(&target, ""),
                    caption(&words)
                );
            }
            out.push_str("</div>\n");
            for control in controls {
                let _ = writeln!(out, "<p>{} = {line}</p>", control_name(control));
            }
        }
    }
    out.push_str(
        "<div class=\"rules\"><div class=\"rule\"></div><div class=\"rule\"></div></div>\n",
    );
    Ok(out)
}

/// The right answer, and why.
fn answer(asked: &ClassQuestion, question: &Question, frame: &Frame) -> String {
    let Some(solution) = &asked.solution else {
        return String::new();
    };
    let mut out = match (solution, &question.kind) {
        (Solution::Places(places), _) => marked_places(frame, places),
        (
            Solution::Curve(curve),
            Kind::Curve {
                x,
                y,
                x_name,
                y_name,
                ..
            },
        ) => {
            let axes = CurveAxes::new([*x, *y], [&x_name.plain(), &y_name.plain()]);
            let mut drawing = axes.on_page();
            drawing.draw_curve(curve.iter().copied(), 2.5, [0; 3], 1.0);
            format!("<figure>{}</figure>", drawing.to_svg(&axes.words()))
        }
        _ => format!(
            "<p>{}</p>",
            inline(&answer_words(asked, question, solution))
        ),
    };
    if !asked.why.is_empty() {
        let _ = write!(out, "<div>{}</div>", blocks(&asked.why));
    }
    out
}

/// The right answer in words; none of a drawing.
pub(super) fn answer_words(
    asked: &ClassQuestion,
    question: &Question,
    solution: &Solution,
) -> String {
    let named = |index: &usize| {
        let words = asked.options.get(*index).map_or("", |words| &**words);
        format!("{} {words}", letter(*index))
    };
    match (solution, &question.kind) {
        (Solution::Choice(right), _) => named(right),
        (
            Solution::Value(right),
            Kind::Value {
                tolerance, unit, ..
            },
        ) => {
            let digits = digits(*tolerance);
            let unit = if unit.is_empty() || unit == "°" {
                unit.clone()
            } else {
                format!(" {unit}")
            };
            format!("{}{unit}", fixed(*right, digits))
        }
        (Solution::Setting(right), Kind::Settings { control, .. }) => {
            format!("{} = {}", plain_control_name(control), fixed(*right, 2))
        }
        (Solution::Order(right), _) => right.iter().map(named).collect::<Vec<_>>().join(" < "),
        (Solution::Match(values), Kind::Match { controls, .. }) => {
            let pairs = controls.iter().zip(values);
            let pairs: Vec<String> = pairs
                .map(|(control, value)| {
                    format!("{} = {}", plain_control_name(control), fixed(*value, 2))
                })
                .collect();
            pairs.join(text!("comma"))
        }
        (Solution::Places(places), _) => {
            let place = places.first().copied().unwrap_or_default();
            format!("({}, {})", fixed(place.x, 2), fixed(place.y, 2))
        }
        _ => String::new(),
    }
}

/// Digits after the point that show a difference of the tolerance.
fn digits(tolerance: f64) -> usize {
    (0..6)
        .find(|digits| 0.1f64.powi(*digits) <= tolerance * 1.01)
        .unwrap_or(6) as usize
}

fn plain_control_name(key: &str) -> String {
    match Parameter::of_key(key).map(|(parameter, _)| parameter) {
        Some(parameter) if !parameter.letter.is_empty() => {
            format!("{} ({})", parameter.name(), parameter.letter)
        }
        Some(parameter) => parameter.name().to_owned(),
        None => key.to_owned(),
    }
}

fn control_name(key: &str) -> String {
    escaped(&plain_control_name(key))
}

fn marked_places(frame: &Frame, places: &[DVec2]) -> String {
    let size = DVec2::new(frame.width.into(), frame.height.into());
    let side = size.min_element();
    let mut svg = format!(
        "<figure class=\"points\"><svg viewBox=\"0 0 {} {}\" role=\"img\" fill=\"none\">\n<image href=\"{}\" width=\"{0}\" height=\"{1}\"/>\n",
        size.x,
        size.y,
        data(frame)
    );
    let radius = if places.len() == 1 { 0.03 } else { 0.006 } * side;
    for place in places {
        let at = size / 2.0 + *place * side;
        for (colour, width) in [("#000", 0.012), ("#fff", 0.006)] {
            let _ = writeln!(
                svg,
                "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"{radius:.1}\" stroke=\"{colour}\" stroke-width=\"{:.1}\"/>",
                at.x,
                at.y,
                width * side
            );
        }
    }
    svg + "</svg></figure>\n"
}

/// In place of a picture.
fn blank() -> Frame {
    Frame {
        width: 1,
        height: 1,
        pixels: vec![[0xff; 4]],
    }
}

/// Every other pixel of every other row.
fn thumbnail(frame: &Frame) -> Frame {
    let (width, height) = (frame.width.div_ceil(2), frame.height.div_ceil(2));
    let row = |y: u32| {
        (0..width).filter_map(move |x| frame.pixels.get((2 * y * frame.width + 2 * x) as usize))
    };
    Frame {
        width,
        height,
        pixels: (0..height).flat_map(row).copied().collect(),
    }
}

/// What the window shows of a step: the picture or its panes, with what is drawn over it. The profile's curve is left out
/// where it would be the answer.
fn stage_picture(lab: &Lab, step: &Step, staged: &Staged, samples: u32) -> Result<Frame, String> {
    if samples == 0 {
        return Ok(blank());
    }
    lab.with_renderer(samples, |renderer, scene| {
        let told =
            step.stage.hide || matches!(&step.question, Some(question) if question.kind.is_drawn());
        let mut scene = scene.clone();
        if scene.compare.panes.is_empty() {
            let mut frame = renderer.render_supersampled(&scene, samples, &mut |_| true);
            draw_over(&mut frame, renderer, &scene, &step.stage, staged, told);
            return frame;
        }
        if scene.compare.view == CompareView::Single {
            scene.compare.view = CompareView::Panes;
        }
        let which = panes_on_sheet(&scene);
        let over = |_: &mut Frame, _: &mut Renderer, _: &Scene| Ok::<(), Infallible>(());
        match draw_panes(renderer, &scene, &which, samples, &mut |_| true, over) {
            // Captions have numbers in them.
            Ok(panes) => comparison_sheet(&scene, &panes, !step.stage.hide),
        }
    })
}

fn draw_over(
    frame: &mut Frame,
    renderer: &mut Renderer,
    scene: &Scene,
    stage: &Stage,
    staged: &Staged,
    told: bool,
) {
    let size = DVec2::from_array(scene.image.size.map(f64::from));
    let side = size.min_element();
    let at = |place: DVec2| size / 2.0 + place * side;
    let layer = |name: &&str| match *name {
        "vectors" => Some(OverlayLayer::Vectors),
        "normals" => Some(OverlayLayer::FaceNormals),
        "vertices" => Some(OverlayLayer::VertexNormals),
        _ => None,
    };
    let options = OverlayOptions {
        layers: stage.overlays.iter().filter_map(layer).collect(),
        ..OverlayOptions::default()
    };
    let line = staged
        .shown
        .line
        .filter(|_| stage.overlays.contains(&"profile"));
    if let Some([from, to]) = line {
        let question = ProfileQuestion {
            modes: vec![scene.shading.mode],
            ..ProfileQuestion::new(
                at(from).clamp(DVec2::ZERO, size),
                at(to).clamp(DVec2::ZERO, size),
            )
        };
        match profile(renderer, scene, &question) {
            Ok(taken) if !told => {
                if let Some(mut pixmap) = pixmap(frame) {
                    taken
                        .traces
                        .iter()
                        .for_each(|trace| draw_profile(&mut pixmap, &taken, trace, &options));
                }
            }
            _ => {
                let mut drawing = Drawing::over_picture([0x10; 3], 0.006 * side);
                drawing
                    .shapes
                    .push(Shape::line(vec![at(from), at(to)], 0.006 * side, [0xff; 3]));
                drawing.draw_over(frame);
            }
        }
    }
    let probed = staged
        .shown
        .probe
        .map(at)
        .filter(|p| p.cmpge(DVec2::ZERO).all() && p.cmplt(size).all());
    let probed = probed.map(|pixel| probe(renderer, scene, pixel.x as u32, pixel.y as u32));
    let Some(mut pixmap) = pixmap(frame) else {
        return;
    };
    let none = |_: &NormalField| Ok::<Option<VertexNormal>, Infallible>(None);
    match draw_normals(&mut pixmap, scene, renderer, &options, none) {
        Ok(()) => {}
    }
    if options.layers.contains(&OverlayLayer::Vectors)
        && let Some(probed) = probed.filter(|probed| probed.hit.is_some())
    {
        draw_overlay(&mut pixmap, scene, &probed, &options);
    }
}

fn pixmap(frame: &mut Frame) -> Option<PixmapMut<'_>> {
    PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), frame.width, frame.height)
}
