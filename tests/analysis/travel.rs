//! Messages between a web page and its workers: nothing is lost on the way.

use shading_lab::analysis::bench::BenchQuestion;
use shading_lab::analysis::defects::DefectsQuestion;
use shading_lab::analysis::profile::ProfileQuestion;
use shading_lab::analysis::stability::StabilityQuestion;
use shading_lab::analysis::study::{Method, StudyQuestion};
use shading_lab::analysis::{Question, unwatched};
use shading_lab::geometry::tessellate;
use shading_lab::jobs::{Request, Work};
use shading_lab::scene::{Interpolation, ReflectionModel, Scene, ShadingMode};
use std::fmt::Debug;
use std::sync::Arc;

/// Formats a value without the addresses of functions: one function may have several.
fn text(value: &impl Debug) -> String {
    let words = format!("{value:?}");
    let mut parts = words.split("0x");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| {
        text + part.trim_start_matches(|c: char| c.is_ascii_hexdigit())
    })
}

/// Sends a question about a scene and its answer back, and checks that both arrive unchanged.
fn travels<Q: Question>(question: Q, scene: &Scene) -> Q::Answer {
    let asked = Request::new(question, scene, None, [40, 30]);
    let (questions, answers) = <Request<Q> as Work>::CODECS.expect("it travels");
    let arrived = (questions.from_bytes)(&(questions.to_bytes)(&asked)).expect("the question");
    assert_eq!(text(&arrived), text(&asked));
    let answer = arrived.run(&unwatched).expect("an answer");
    let back = (answers.from_bytes)(&(answers.to_bytes)(&answer)).expect("the answer");
    assert_eq!(text(&back), text(&answer));
    back
}

fn scene() -> Scene {
    let mut scene = Scene::default();
    scene.shading.mode = ShadingMode::Gouraud;
    (scene.object.segments, scene.object.rings) = (8, 4);
    scene.material.n = f64::INFINITY;
    scene.lights[0].name = "a “name”".to_owned();
    scene.validate().expect("a sound scene");
    scene
}

#[test]
fn questions_and_answers_travel_whole() {
    let scene = scene();
    let line = ProfileQuestion::new([1.0, 2.0].into(), [30.5, 20.25].into());
    travels(line, &scene);
    let defects = travels(DefectsQuestion::default(), &scene).defects;
    assert!(defects.silhouette.is_ok(), "something is measured");
    // A value that was not measured has the key of its reason.
    let mut flat = scene.clone();
    flat.shading.mode = ShadingMode::Flat;
    let defects = travels(DefectsQuestion::default(), &flat).defects;
    assert_eq!(defects.perspective, Err("picture-missing-flat"));
    let cases = travels(
        StabilityQuestion {
            cases: vec!["exponent-1e9".to_owned()],
            law: false,
        },
        &scene,
    );
    assert!(cases.results.iter().all(|case| case.pictures[0].width > 0));
    let mut own = scene.clone();
    own.reflection.model = ReflectionModel::Formula;
    own.reflection.formula = "1/(N·L > 0)".to_owned();
    let law = StabilityQuestion {
        law: true,
        ..StabilityQuestion::default()
    };
    let law = travels(law, &own).law.expect("a law");
    assert!(law.pixels > 0 && law.undefined.len() == 1);
    travels(
        BenchQuestion {
            frames: 1,
            growth: false,
            simd: None,
        },
        &scene,
    );
}

#[test]
fn a_study_travels_whole() {
    let study = StudyQuestion {
        methods: vec![Method::Gouraud, Method::Taylor],
        segments: vec![8, 12, 16],
        interpolations: vec![Interpolation::Perspective],
        n: vec![5.0],
        repeats: 1,
        reference: None,
    };
    let mut scene = scene();
    scene.shading.shadows = true;
    let found = travels(study, &scene);
    assert!(!found.rows.is_empty(), "something is measured");
}

#[test]
fn a_model_travels_with_the_question() {
    let mut scene = scene();
    scene.object.segments = 5;
    let model = Arc::new(tessellate(&scene.object));
    let asked = Request::new(DefectsQuestion::default(), &scene, Some(&model), [8, 8]);
    let (questions, _) = <Request<DefectsQuestion> as Work>::CODECS.expect("it travels");
    let arrived = (questions.from_bytes)(&(questions.to_bytes)(&asked)).expect("the question");
    let mesh = arrived.model.expect("the model");
    assert_eq!(text(&mesh), text(&model));
    assert!((questions.from_bytes)(b"nonsense").is_none());
}
