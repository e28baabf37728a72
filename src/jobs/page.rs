//! Work on a web page: done in turn, a piece after each frame.

use std::cell::RefCell;
use std::collections::VecDeque;

type Work = Box<dyn FnOnce()>;

thread_local! {
    static WAITING: RefCell<VecDeque<Work>> = const { RefCell::new(VecDeque::new()) };
}

/// Does this after a frame.
pub fn later(work: impl FnOnce() + 'static) {
    WAITING.with_borrow_mut(|waiting| waiting.push_back(Box::new(work)));
}

/// Does the next piece of work, if there is any.
pub fn step() {
    let next = WAITING.with_borrow_mut(VecDeque::pop_front);
    if let Some(work) = next {
        work();
    }
}
