//! Work beside the window: a question is answered on a thread of its own, so that the interface never waits.

use eframe::egui::Context;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread;

/// A question that is being answered.
#[derive(Debug)]
pub struct Errand<Q, A> {
    pub question: Q,
    receiver: Receiver<A>,
}

impl<Q, A: Send + 'static> Errand<Q, A> {
    /// Sends `work` for the answer to `question`; the window is drawn again when it comes.
    pub fn new(ctx: &Context, question: Q, work: impl FnOnce() -> A + Send + 'static) -> Self {
        let (sender, receiver) = channel();
        let ctx = ctx.clone();
        thread::spawn(move || {
            // Who no longer listens wants no more of it: that is no error.
            let _ = sender.send(work());
            ctx.request_repaint();
        });
        Self { question, receiver }
    }

    /// Takes the errand out of `slot` when it is over: the question, and the answer unless the work ended without one,
    /// which asking again would not change. Nothing as long as it is under way.
    pub fn take(slot: &mut Option<Self>) -> Option<(Q, Option<A>)> {
        let answer = match slot.as_ref()?.receiver.try_recv() {
            Ok(answer) => Some(answer),
            Err(TryRecvError::Empty) => return None,
            Err(TryRecvError::Disconnected) => None,
        };
        slot.take().map(|errand| (errand.question, answer))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outcome<A: Send + 'static>(work: impl FnOnce() -> A + Send + 'static) -> (u8, Option<A>) {
        let mut slot = Some(Errand::new(&Context::default(), 7_u8, work));
        loop {
            if let Some(over) = Errand::take(&mut slot) {
                assert!(slot.is_none());
                return over;
            }
            thread::yield_now();
        }
    }

    #[test]
    fn an_answer_comes_with_its_question_or_none_if_the_work_fails() {
        assert_eq!(outcome(|| "yes"), (7, Some("yes")));
        assert_eq!(outcome(|| -> u8 { std::panic::panic_any("no answer") }), (7, None));
        assert_eq!(Errand::<u8, u8>::take(&mut None), None);
    }
}
