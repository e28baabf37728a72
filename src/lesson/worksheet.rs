//! A lesson in print: its text and pictures, questions with space to write, and the answers on pages of their
//! own.

use super::builtin::topic_name;
use super::class::ClassQuestion;
use super::html::{Element, Html, element};
use super::kinds::kind::Printed;
use super::page::{blank_picture, blocks, inline, page, picture};
use super::{Budget, Lab, LabPlace, Lesson, LessonError, Question, Solution, Staged, Step};
use crate::analysis::comparison::{Captions, comparison_sheet, draw_panes, panes_on_sheet};
use crate::analysis::defects::{defects, draw_defects};
use crate::analysis::normals::{NormalField, draw_normals};
use crate::analysis::overlay::{OverlayLayer, OverlayOptions, free_corners};
use crate::analysis::probe::{draw_overlay, probe};
use crate::analysis::profile::{ProfileQuestion, draw_profile, profile};
use crate::analysis::unwatched;
use crate::figure::{Drawing, Shape};
use crate::render::{Frame, Renderer};
use crate::scene::{Scene, View, place_to_pixel};
use crate::text::text;
use glam::DVec2;
use std::convert::Infallible;
use std::mem;
use tiny_skia::PixmapMut;

/// The contents of a worksheet.
#[derive(Clone, Copy, Debug)]
pub struct Worksheet {
    /// True if the last pages have the answers.
    pub answers: bool,
    /// The seed of what is drawn at random.
    pub seed: u64,
    /// The samples per pixel of the pictures; 0 leaves them blank.
    pub samples: u32,
}

const STYLE: &str = "\
header { border-bottom: 0.5mm solid #1a1a1a; margin-bottom: 5mm; padding-bottom: 2mm; }
.name { display: flex; gap: 8mm; margin: 4mm 0 1mm; }
.name span { flex: 2; border-bottom: 0.3mm solid #777; min-height: 6mm; }
.name span:last-child { flex: 1; }
.step { margin-bottom: 6mm; break-inside: avoid; }
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
.answers { break-before: page; }
.answer { break-inside: avoid; border-top: 0.3mm solid #bbb; padding-top: 2mm; margin-bottom: 4mm; }
.answer img { width: 64mm; }
.answer .items img { width: 36mm; }
.answer .points { max-width: 64mm; }
.answer svg { max-width: 120mm; }
";

/// Returns the lines to write on.
fn rules() -> Element {
    let rule = || element("div").class("rule");
    element("div").class("rules").with(rule()).with(rule())
}

/// Returns the page as HTML; `progress` is called after each step.
///
/// # Errors
/// Returns the problem of the lesson, with its line.
pub fn worksheet(
    lesson: &Lesson,
    sheet: Worksheet,
    progress: &mut dyn FnMut(),
) -> Result<String, LessonError> {
    let about = text!(
        "class-about",
        topic = topic_name(&lesson.topic),
        minutes = lesson.minutes
    );
    let quiet = |name: &'static str, words: &str| element(name).class("quiet").with(words);
    let mut header = element("header")
        .broken()
        .line(element("h1").with(inline(&lesson.title)))
        .line(quiet("p", &about));
    if !lesson.about.is_empty() {
        header = header.line(element("p").with(inline(&lesson.about)));
    }
    let name = element("div")
        .class("name")
        .with(quiet("span", text!("class-name")))
        .with(quiet("span", text!("class-date")));
    let mut body = Html::new().line(header.line(name));
    let heading = text!("class-answers", title = &*lesson.title);
    let mut answers = element("section")
        .class("answers")
        .broken()
        .line(element("h1").with(heading));
    let mut number = 0;
    let budget = Budget::of_file();
    for (index, step) in lesson.steps.iter().enumerate() {
        let part = StepPart::new(lesson, (index, step), sheet, &budget)?;
        let mut section = part.section;
        if let Some(question) = part.question {
            number += 1;
            let heading = element("strong").with(text!("class-question", number = number));
            let ask = Html::from(heading).with(" ").with(inline(&question.ask));
            let asked = |class: &str, inside: Html| {
                let ask = element("p").with(ask.clone());
                element("div").class(class).broken().line(ask).with(inside)
            };
            section = section.line(asked("question", question.blank));
            answers = answers.line(asked("answer", question.answer));
        }
        body = body.line(section);
        progress();
    }
    if sheet.answers && number > 0 {
        body = body.line(answers);
    }
    Ok(page(&lesson.title, STYLE, body))
}

struct StepPart {
    section: Element,
    question: Option<QuestionPart>,
}

struct QuestionPart {
    /// The question, in CommonMark.
    ask: String,
    blank: Html,
    answer: Html,
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
        // Solved for a sheet without answers too, since a probe that only the answer needs is marked.
        let seed = (sheet.answers || sheet.samples > 0).then_some(sheet.seed);
        let filled = FilledStep::new((index, step), &lab, place, seed)?;
        let title = Html::from(format!("{}. ", index + 1)).with(inline(&step.title));
        let mut section = element("section")
            .class("step")
            .broken()
            .line(element("h2").with(title));
        let question = |words: String| step.question_problem(words);
        let frame = stage_picture(&lab, step, &staged, sheet.samples, filled.probed);
        let frame = frame.map_err(|words| LessonError::one(step.line, words))?;
        if !step.asks().is_some_and(|asks| asks.uses_picture()) {
            let single = staged.scene.shown_panes().len() == 1;
            let class = if single && frame.width < 2 * frame.height {
                "picture"
            } else {
                "picture wide"
            };
            let image = picture(&frame, &step.title);
            section = section.line(element("figure").class(class).with(image));
        }
        let mut part = Self {
            section: section.with(blocks(&filled.text)),
            question: None,
        };
        if let (Some(asks), Some(asked)) = (&step.question, filled.asked) {
            let after = step.after.filled(&place)?;
            let told = sheet.answers || asks.kind.asks().shows_target();
            let right = filled.right.filter(|_| told);
            let printed = Printed {
                ask: &asked.ask,
                options: &asked.options,
                set: &asks.set,
                place,
                picture: &frame,
                seed: sheet.seed,
                without_pictures: sheet.samples == 0,
            };
            let blank = asks.kind.blank(&printed, right.as_ref());
            part.question = Some(QuestionPart {
                blank: blank.map_err(question)?.line(rules()),
                answer: answer(&asked, asks, right.as_ref(), &printed)
                    .map_err(question)?
                    .with(blocks(&after)),
                ask: asked.ask.clone(),
            });
        }
        Ok(part)
    }
}

/// A step's texts with their numbers, and what they were taken from.
pub(crate) struct FilledStep {
    pub text: String,
    /// The question's texts.
    pub asked: Option<ClassQuestion>,
    /// The right answer, where it was wanted.
    pub right: Option<Solution>,
    /// Numbers are taken at the probe, and it does not show what is asked for: it is marked in the picture.
    pub probed: bool,
}

impl FilledStep {
    /// Fills in the numbers of a step in its lab; with a `seed` solves its question too.
    pub(crate) fn new(
        (index, step): (usize, &Step),
        lab: &Lab,
        place: LabPlace<'_>,
        seed: Option<u64>,
    ) -> Result<Self, LessonError> {
        let text = step.text.filled(&place)?;
        let (mut asked, mut right) = (None, None);
        if let Some(asks) = &step.question {
            asked = Some(ClassQuestion::filled(index, asks, place)?);
            let solved = seed.map(|seed| asks.solve(place, seed)).transpose();
            right = solved.map_err(|words| step.question_problem(words))?;
        }
        let asks_place = step.asks().is_some_and(|asks| asks.asks_place());
        Ok(Self {
            text,
            asked,
            right,
            probed: lab.probe_measured() && !asks_place,
        })
    }
}

impl Step {
    /// Returns a problem of its question as one of the lesson.
    pub(crate) fn question_problem(&self, words: String) -> LessonError {
        let line = self.question.as_ref().map_or(self.line, |asks| asks.line);
        LessonError::one(line, text!("lesson-question", words = words))
    }
}

/// Returns the right answer and its explanation as HTML.
pub(crate) fn answer(
    asked: &ClassQuestion,
    question: &Question,
    right: Option<&Solution>,
    printed: &Printed<'_>,
) -> Result<Html, String> {
    let Some(right) = right else {
        return Ok(Html::new());
    };
    let out = question.kind.drawing(right, printed)?.unwrap_or_else(|| {
        let words = question.kind.solution_words(right, &asked.options);
        element("p").with(inline(&words)).into()
    });
    if asked.why.is_empty() {
        return Ok(out);
    }
    Ok(out.with(element("div").with(blocks(&asked.why))))
}

/// Draws the picture of a step as the window shows it: with its panes, or with its overlays; with a ring round the
/// probe if numbers are taken there. Leaves out the profile's curve if it would be the answer.
pub(crate) fn stage_picture(
    lab: &Lab,
    step: &Step,
    staged: &Staged,
    samples: u32,
    probed: bool,
) -> Result<Frame, String> {
    if samples == 0 {
        return Ok(blank_picture());
    }
    lab.with_renderer(samples, |renderer, scene| {
        let asks = step.asks();
        let told = asks.is_some_and(|asks| step.stage.hide || asks.is_drawn());
        let over = |frame: &mut Frame, renderer: &mut Renderer, scene: &Scene| {
            draw_over(frame, renderer, scene, step, staged, told);
            if probed && let Some(probe) = staged.shown.probe {
                draw_probe(frame, scene, probe);
            }
        };
        if scene.shown_panes().len() == 1 {
            let mut frame = renderer.render_supersampled(scene, samples, &mut |_| true);
            over(&mut frame, renderer, scene);
            return frame;
        }
        let which = panes_on_sheet(scene);
        // As in the window, the first pane is the active one.
        let mut active = true;
        let over = |frame: &mut Frame, renderer: &mut Renderer, scene: &Scene| {
            if mem::take(&mut active) {
                over(frame, renderer, scene);
            }
            Ok::<(), Infallible>(())
        };
        let captions = if step.stage.hide {
            Captions::Names
        } else {
            Captions::Figures
        };
        match draw_panes(renderer, scene, &which, samples, &mut |_| true, over) {
            Ok(panes) => comparison_sheet(scene, &panes, captions),
        }
    })
}

fn draw_over(
    frame: &mut Frame,
    renderer: &mut Renderer,
    scene: &Scene,
    step: &Step,
    staged: &Staged,
    told: bool,
) {
    let stage = &step.stage;
    let size = DVec2::from_array(scene.image.size.map(f64::from));
    let side = size.min_element();
    let at = |place: DVec2| place_to_pixel(place, size);
    let free_corners = free_corners(frame);
    if stage.overlays.contains(&"edges") {
        draw_edges(frame, renderer, scene);
    }
    let layer = |name: &&str| match *name {
        "vectors" => Some(OverlayLayer::Vectors),
        "side-view" => Some(OverlayLayer::SideView),
        "lobe" => Some(OverlayLayer::Lobe),
        "normals" => Some(OverlayLayer::FaceNormals),
        "vertices" => Some(OverlayLayer::VertexNormals),
        _ => None,
    };
    let options = OverlayOptions {
        layers: stage.overlays.iter().filter_map(layer).collect(),
        side_view_where_needed: true,
        side_view_angles: !told,
        free_corners,
        ..OverlayOptions::default()
    };
    let follows = step.asks().is_some_and(|asks| asks.follows_line());
    let line = staged
        .shown
        .line
        .filter(|_| follows || stage.overlays.contains(&"profile"));
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
                    for trace in &taken.traces {
                        draw_profile(&mut pixmap, &taken, trace, &options);
                    }
                }
            }
            _ => {
                let mut drawing = Drawing::over_picture([0x10; 3], 0.006 * side);
                let line = Shape::line(vec![at(from), at(to)], 0.006 * side, [0xff; 3]);
                drawing.shapes.push(line);
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
    let lit = staged
        .shown
        .probe
        .filter(|_| stage.overlays.contains(&"vertex"));
    if lit.is_some() || options.layers.iter().any(|layer| layer.of_needles()) {
        let vertex = |field: &NormalField| {
            Ok(lit.and_then(|place| {
                field.vertex(field.vertex_next_to(renderer, scene, at(place))?)
            }))
        };
        let Ok(()) = draw_normals::<Infallible>(&mut pixmap, scene, renderer, &options, vertex);
    }
    if stage.view == Some("defects") && !told {
        let middle = scene.image.size.map(|side| side / 2);
        let found = defects(renderer, scene, middle, &unwatched);
        draw_defects(&mut pixmap, &found, Some(&staged.name), &options);
    }
    if options.layers.contains(&OverlayLayer::Vectors)
        && let Some(probed) = probed.filter(|probed| probed.hit.is_some())
    {
        draw_overlay(&mut pixmap, scene, &probed, &options);
    }
}

/// Draws a ring round the probe.
fn draw_probe(frame: &mut Frame, scene: &Scene, probe: DVec2) {
    let size = DVec2::from_array(scene.image.size.map(f64::from));
    let side = size.min_element();
    let mut drawing = Drawing::over_picture([0x10; 3], 0.006 * side);
    let at = place_to_pixel(probe, size);
    let ring = Shape::ring(at, 0.016 * side, 0.005 * side, [0xff; 3]);
    drawing.shapes.push(ring);
    drawing.draw_over(frame);
}

/// Draws the edges of the polygons that face the eye.
fn draw_edges(frame: &mut Frame, renderer: &Renderer, scene: &Scene) {
    let field = NormalField::new(renderer, &scene.object);
    let view = View::new(&scene.camera, scene.image.size);
    let width = 0.0025 * f64::from(scene.image.size[0].min(scene.image.size[1]));
    let mut drawing = Drawing::over_picture([0x10; 3], width);
    for mut outline in field.facing_outlines(&view) {
        outline.extend(outline.first().copied());
        let line = Shape::line(outline, width, [0xff; 3]);
        drawing.shapes.push(line.faded(0.6));
    }
    drawing.draw_over(frame);
}

fn pixmap(frame: &mut Frame) -> Option<PixmapMut<'_>> {
    PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), frame.width, frame.height)
}
