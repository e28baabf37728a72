//! Work on a web page: sent to workers, which load the same program, or done on the page itself, between frames.

use super::MessageKind;
use crate::text::{Language, chinese_font, chinese_text, language};
use js_sys::{Array, Object, Reflect, Uint8Array};
use std::cell::RefCell;
use std::collections::VecDeque;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{ErrorEvent, MessageEvent, Worker, WorkerOptions, WorkerType};

/// Maximum number of workers at a time: each has memory of its own.
const MOST: usize = 4;
/// The script of a worker, beside the page, and its first message: the program as compiled by the page.
const SCRIPT: &str = "worker.js";
const OF_PAGE: [&str; 2] = ["shadingLab", "module"];

/// A message from a worker about its work. The last three end it.
pub enum WorkerMessage<'a> {
    /// Progress, from 0 to 1.
    At(f32),
    /// The part of the answer known so far.
    SoFar(&'a [u8]),
    Over(&'a [u8]),
    Failed(String),
    /// The work was stopped, or has stopped.
    Stopped,
}

/// A receiver of a worker's messages.
type OnMessage = Box<dyn FnMut(WorkerMessage<'_>)>;

/// Work that waits for a worker.
struct Order {
    number: u64,
    message: JsValue,
    on_message: OnMessage,
}

/// A worker with its work.
struct Busy {
    worker: Worker,
    number: u64,
    on_message: OnMessage,
}

#[derive(Default)]
struct Pool {
    idle: Vec<Worker>,
    busy: Vec<Busy>,
    orders: VecDeque<Order>,
    sent: u64,
}

thread_local! {
    static POOL: RefCell<Pool> = RefCell::default();
}

/// Runs work on the page after the current frame is shown.
pub fn later(work: impl FnOnce() + 'static) {
    let work = Closure::once_into_js(work);
    if let Some(window) = web_sys::window() {
        // A window always accepts it.
        let _ = window.set_timeout_with_callback(work.unchecked_ref());
    }
}

/// Sends work of this name to a worker; `on_message` receives its messages.
pub fn send(
    name: &str,
    content: Vec<u8>,
    on_message: impl FnMut(WorkerMessage<'_>) + 'static,
) -> u64 {
    let place = Language::ALL.iter().position(|known| *known == language());
    let message = Array::of5(
        &name.into(),
        &(place.unwrap_or(0) as u32).into(),
        &Uint8Array::from(&*content),
        &Uint8Array::from(chinese_font()),
        &chinese_text().into(),
    );
    let number = POOL.with_borrow_mut(|pool| {
        pool.sent += 1;
        pool.orders.push_back(Order {
            number: pool.sent,
            message: message.into(),
            on_message: Box::new(on_message),
        });
        pool.sent
    });
    begin();
    number
}

/// Cancels work that was sent, if it is still running.
pub fn cancel(number: u64) {
    let on_message = POOL.with_borrow_mut(|pool| {
        let waiting = pool.orders.iter().position(|order| order.number == number);
        if let Some(order) = waiting.and_then(|place| pool.orders.remove(place)) {
            return Some(order.on_message);
        }
        let place = pool.busy.iter().position(|busy| busy.number == number)?;
        let busy = pool.busy.swap_remove(place);
        busy.worker.terminate();
        Some(busy.on_message)
    });
    if let Some(mut on_message) = on_message {
        on_message(WorkerMessage::Stopped);
        begin();
    }
}

/// Assigns waiting work to workers, as far as there are any.
fn begin() {
    let refused = POOL.with_borrow_mut(|pool| {
        while pool.busy.len() < MOST
            && let Some(order) = pool.orders.pop_front()
        {
            let worker = pool.idle.pop().map_or_else(worker, Ok);
            let Order {
                number,
                message,
                on_message,
            } = order;
            match worker.and_then(|worker| worker.post_message(&message).map(|()| worker)) {
                Ok(worker) => pool.busy.push(Busy {
                    worker,
                    number,
                    on_message,
                }),
                Err(_) => return Some(on_message),
            }
        }
        None
    });
    if let Some(mut on_message) = refused {
        on_message(WorkerMessage::Stopped);
    }
}

/// Starts a worker, and gives it the program.
fn worker() -> Result<Worker, JsValue> {
    let options = WorkerOptions::new();
    options.set_type(WorkerType::Module);
    let worker = Worker::new_with_options(SCRIPT, &options)?;
    let mut program: JsValue = js_sys::global().into();
    for name in OF_PAGE {
        program = Reflect::get(&program, &name.into())?;
    }
    worker.post_message(&program)?;
    let of = worker.clone();
    let heard = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        handle_message(&of, &event.data());
    });
    worker.set_onmessage(Some(heard.into_js_value().unchecked_ref()));
    let of = worker.clone();
    let failed = Closure::<dyn FnMut(ErrorEvent)>::new(move |_| handle_failure(&of));
    worker.set_onerror(Some(failed.into_js_value().unchecked_ref()));
    Ok(worker)
}

fn is(one: &Worker, other: &Worker) -> bool {
    Object::is(one, other)
}

/// Handles a message: its kind, and its content.
fn handle_message(worker: &Worker, message: &JsValue) {
    let message: &Array = message.unchecked_ref();
    let kind = message.get(0).as_f64().unwrap_or(0.0) as u32;
    let is_kind = |known: MessageKind| kind == known as u32;
    let content = message.get(1);
    let bytes = content
        .dyn_ref::<Uint8Array>()
        .map(Uint8Array::to_vec)
        .unwrap_or_default();
    let message = if is_kind(MessageKind::Share) {
        WorkerMessage::At(content.as_f64().unwrap_or(0.0) as f32)
    } else if is_kind(MessageKind::SoFar) {
        WorkerMessage::SoFar(&bytes)
    } else if is_kind(MessageKind::Answer) {
        WorkerMessage::Over(&bytes)
    } else {
        WorkerMessage::Failed(content.as_string().unwrap_or_default())
    };
    let place = |pool: &Pool| pool.busy.iter().position(|busy| is(&busy.worker, worker));
    let Some(mut busy) =
        POOL.with_borrow_mut(|pool| place(pool).map(|place| pool.busy.swap_remove(place)))
    else {
        return;
    };
    let goes_on = matches!(message, WorkerMessage::At(_) | WorkerMessage::SoFar(_));
    (busy.on_message)(message);
    POOL.with_borrow_mut(|pool| {
        if goes_on {
            pool.busy.push(busy);
        } else {
            pool.idle.push(busy.worker);
        }
    });
    begin();
}

/// Handles the failure of a worker.
fn handle_failure(worker: &Worker) {
    let number = POOL.with_borrow(|pool| {
        let busy = pool.busy.iter().find(|busy| is(&busy.worker, worker));
        busy.map(|busy| busy.number)
    });
    number.into_iter().for_each(cancel);
}
