//! Guarantees of the library's types to programs that use it.

mod security;

use shading_lab::analysis::Subject;
use shading_lab::analysis::probe::Probe;
use shading_lab::analysis::profile::{ProfileError, ProfileQuestion};
use shading_lab::analysis::scan::ScanError;
use shading_lab::animation::SweepError;
use shading_lab::document::{LoadError, Loaded, SaveError, load_scene};
use shading_lab::export::{Export, ExportError};
use shading_lab::figure::{Drawing, Plot};
use shading_lab::geometry::{Mesh, ObjError};
use shading_lab::lesson::{HandInError, Lesson, LessonError, OpenError};
use shading_lab::link::{Link, LinkError, WriteError};
use shading_lab::picture::PictureError;
use shading_lab::render::{Frame, FrameReport, Renderer};
use shading_lab::scene::{Polygons, Scene, SceneError, ShadingMode, Shared};
use std::error::Error;
use std::fmt::Debug;
use std::path::Path;

/// Requires what callers do with errors: `?` into a box, sending between threads, downcasting.
fn error<E: Error + Send + Sync + 'static>() {}

/// Requires what callers do with data.
fn data<T: Clone + Debug + PartialEq + Send + Sync + 'static>() {}

#[test]
fn every_error_can_be_boxed_and_sent() {
    error::<SceneError>();
    error::<LoadError>();
    error::<SaveError>();
    error::<LinkError>();
    error::<WriteError>();
    error::<ObjError>();
    error::<PictureError>();
    error::<ExportError>();
    error::<LessonError>();
    error::<OpenError>();
    error::<HandInError>();
    error::<ProfileError>();
    error::<ScanError>();
    error::<SweepError>();
}

#[test]
fn data_can_be_copied_compared_printed_and_sent() {
    data::<Scene>();
    data::<Loaded>();
    data::<Frame>();
    data::<FrameReport>();
    data::<Mesh>();
    data::<Polygons>();
    data::<Shared<u32>>();
    data::<Probe>();
    data::<ProfileQuestion>();
    data::<Plot>();
    data::<Drawing>();
    data::<Lesson>();
    data::<Link>();
    data::<Export>();
    data::<ShadingMode>();
}

#[test]
fn a_renderer_and_a_question_s_subject_move_to_another_thread() {
    fn sent<T: Debug + Send + 'static>() {}
    sent::<Renderer>();
    sent::<Subject>();
}

#[test]
fn an_error_is_downcast_from_a_box_to_its_cause() {
    let boxed: Box<dyn Error + Send + Sync> = load_scene(Path::new("?set=material.n=x"))
        .expect_err("x is no number")
        .into();
    let error = boxed.downcast_ref::<LoadError>();
    let Some(LoadError::Link(link)) = error else {
        panic!("{error:?} is no error of a link");
    };
    assert_eq!(link.problems[0].key, "material.n");
}
