//! The functions for scripts besides that of the picture shown: `shadingLab.link(text)`, `.render(link, width, height)`
//! and `.bench(link, width, height, frames)`. Errors are thrown, in a sentence.

use crate::analysis::bench::BenchQuestion;
use crate::analysis::{Answer, Question, ReportContext, Subject, unwatched};
use crate::document::picture_bytes;
use crate::jobs::nanoseconds;
use crate::link::{Link, read, write};
use crate::render::Renderer;
use crate::scene::{CompareView, Scene};
use js_sys::{Reflect, Uint8Array};
use wasm_bindgen::JsValue;
use wasm_bindgen::closure::Closure;

/// Maximum side of a picture drawn for a script, pixels.
const LONGEST: u32 = 4096;

fn say(problem: impl ToString) -> JsValue {
    js_sys::Error::new(&problem.to_string()).into()
}

/// Gives the functions to scripts, as properties of `own`.
pub fn offer(own: &JsValue) {
    let link =
        Closure::<dyn Fn(String) -> Result<String, JsValue>>::new(|text: String| again(&text));
    let render = Closure::<dyn Fn(String, u32, u32) -> Result<Uint8Array, JsValue>>::new(
        |link: String, width, height| drawn(&link, [width, height]),
    );
    let bench = Closure::<dyn Fn(String, u32, u32, u32) -> Result<String, JsValue>>::new(
        |link: String, width, height, frames| timed(&link, [width, height], frames),
    );
    for (name, function) in [
        ("link", link.into_js_value()),
        ("render", render.into_js_value()),
        ("bench", bench.into_js_value()),
    ] {
        // A page that refuses a property goes without it.
        let _ = Reflect::set(own, &name.into(), &function);
    }
}

/// Returns the shortest link that opens the same as `text`.
fn again(text: &str) -> Result<String, JsValue> {
    let Link { scene, name, shown } = read(text).map_err(say)?;
    let written = write("", &scene, Some(&name), &shown).map_err(say)?;
    Ok(written.link)
}

/// Returns the scene of a link alone, without other panes, in a picture of `size` pixels, clamped to [`LONGEST`].
fn scene(link: &str, size: [u32; 2]) -> Result<Scene, JsValue> {
    let mut scene = read(link).map_err(say)?.scene;
    scene.compare.view = CompareView::Single;
    scene.image.size = size.map(|side| side.clamp(1, LONGEST));
    Ok(scene)
}

/// Returns the picture of a link as a PNG.
fn drawn(link: &str, size: [u32; 2]) -> Result<Uint8Array, JsValue> {
    let scene = scene(link, size)?;
    let mut renderer = Renderer::default();
    let frame = renderer.render(&scene);
    let bytes = picture_bytes(frame, None).map_err(say)?;
    Ok(Uint8Array::from(&*bytes))
}

/// Returns the output of `bench` as JSON.
fn timed(link: &str, size: [u32; 2], frames: u32) -> Result<String, JsValue> {
    let subject = Subject {
        scene: scene(link, size)?,
        model: None,
        clock: nanoseconds,
    };
    let question = BenchQuestion {
        frames: frames.max(1),
        growth: false,
        simd: None,
    };
    let bench = question.answer(&subject, &unwatched).map_err(say)?;
    let about = ReportContext {
        name: "",
        scene: &subject.scene,
    };
    Ok(bench.object(&about).to_string())
}
