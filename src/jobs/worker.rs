//! The worker's side: does work that the page has sent, and reports on it.

use super::{MessageKind, Work, nanoseconds};
use crate::analysis::Watch;
use crate::text::{Language, set_chinese_font, set_chinese_text, set_language};
use js_sys::{Array, Reflect, Uint8Array};
use std::any::type_name;
use std::marker::PhantomData;
use std::sync::atomic::{AtomicU64, Ordering};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::DedicatedWorkerGlobalScope;

/// Minimum interval between reports of progress, and between reports of intermediate answers, nanoseconds.
const PAUSE: u64 = 50_000_000;
/// Name of the function that the worker's script calls with a message.
const SERVE: &str = "serve";

/// A kind of work done in workers: its name, and its function.
pub type Served = (&'static str, fn(&[u8]));

/// Returns the entry for work of this type.
pub fn served<W: Work>() -> Served {
    (type_name::<W>(), work::<W>)
}

/// Serves the page, if this is a worker; returns whether it is.
pub fn serve(kinds: Vec<Served>) -> bool {
    let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() else {
        return false;
    };
    let serve = Closure::<dyn Fn(Array)>::new(move |message: Array| {
        let (name, place) = (message.get(0).as_string(), message.get(1).as_f64());
        let [content, font] = [2, 3].map(|at| Uint8Array::new(&message.get(at)).to_vec());
        if !font.is_empty() {
            set_chinese_font(font);
        }
        let text = message.get(4).as_string();
        text.filter(|text| !text.is_empty())
            .into_iter()
            .for_each(set_chinese_text);
        let language = Language::ALL.get(place.unwrap_or(0.0) as usize);
        language.copied().into_iter().for_each(set_language);
        let kind = kinds
            .iter()
            .find(|(known, _)| name.as_deref() == Some(*known));
        match kind {
            Some((_, work)) => work(&content),
            None => post(MessageKind::Failure, &JsValue::NULL),
        }
    });
    // If this fails, the script reports it itself.
    let _ = Reflect::set(&scope, &SERVE.into(), &serve.into_js_value());
    true
}

/// Sends a message to the page.
fn post(kind: MessageKind, content: &JsValue) {
    let scope: DedicatedWorkerGlobalScope = js_sys::global().unchecked_into();
    // A closed page receives nothing.
    let _ = scope.post_message(&Array::of2(&(kind as u32).into(), content));
}

fn post_bytes(kind: MessageKind, content: &[u8]) {
    post(kind, &Uint8Array::from(content));
}

/// Does work that arrives as bytes, and sends its answer.
fn work<W: Work>(content: &[u8]) {
    let decoded =
        W::CODECS.and_then(|(codec, answers)| Some(((codec.from_bytes)(content)?, answers)));
    let Some((work, answers)) = decoded else {
        return post(MessageKind::Failure, &JsValue::NULL);
    };
    let reporter = Reporter::<W> {
        reported: [AtomicU64::new(0), AtomicU64::new(0)],
        work: PhantomData,
    };
    match work.run(&reporter) {
        Ok(answer) => post_bytes(MessageKind::Answer, &(answers.to_bytes)(&answer)),
        Err(why) => post(MessageKind::Failure, &why.into()),
    }
}

struct Reporter<W> {
    /// Times of the last reports of progress and of intermediate answers, nanoseconds.
    reported: [AtomicU64; 2],
    work: PhantomData<fn(W)>,
}

impl<W> Reporter<W> {
    fn is_due(&self, what: usize) -> bool {
        let (now, last) = (nanoseconds(), &self.reported[what]);
        let due = now >= last.load(Ordering::Relaxed) + PAUSE;
        if due {
            last.store(now, Ordering::Relaxed);
        }
        due
    }
}

impl<W: Work> Watch<W::Answer> for Reporter<W> {
    /// Always continues: the page ends the worker to cancel.
    fn progress(&self, share: f32) -> bool {
        if self.is_due(0) {
            post(MessageKind::Share, &share.into());
        }
        true
    }

    fn found(&self, so_far: &W::Answer) {
        if self.is_due(1)
            && let Some((_, answers)) = W::CODECS
        {
            post_bytes(MessageKind::SoFar, &(answers.to_bytes)(so_far));
        }
    }
}
