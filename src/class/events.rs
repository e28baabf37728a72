//! The stream of events of a phone.

use super::patient::PATIENCE;
use super::refusal::{OwnPace, Refusal};
use super::room::Room;
use super::tokens::Token;
use hyper::body::{Body, Bytes, Frame};
use std::convert::Infallible;
use std::pin::Pin;
use std::sync::{Arc, Weak};
use std::task::{Context, Poll};
use std::time::Duration;
use tokio::sync::mpsc;
use tokio::time::{sleep, timeout};

/// The time between two signs of life.
const HEARTBEAT: Duration = Duration::from_secs(15);

/// The body of a stream of events.
pub struct Events(mpsc::Receiver<Bytes>);

impl Body for Events {
    type Data = Bytes;
    type Error = Infallible;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, Infallible>>> {
        let next = self.0.poll_recv(context);
        next.map(|bytes| Some(Ok(Frame::data(bytes?))))
    }
}

/// Leaves the room when the stream ends, however it does.
struct Entered {
    room: Weak<Room>,
    token: Token,
}

impl Drop for Entered {
    fn drop(&mut self) {
        if let Some(room) = self.room.upgrade() {
            room.leave(self.token);
        }
    }
}

/// Opens a stream of events for a student.
///
/// # Errors
/// No student of this class.
pub fn events(room: &Arc<Room>, token: Token) -> Result<Events, Refusal> {
    let (number, mut own) = room.enter(token)?;
    let entered = Entered {
        room: Arc::downgrade(room),
        token,
    };
    let mut paces = room.paces();
    let (sender, receiver) = mpsc::channel(2);
    tokio::spawn(async move {
        let mut last = None;
        loop {
            own.mark_unchanged();
            paces.mark_unchanged();
            let now = entered.room.upgrade().map(|room| room.own_pace(token));
            let Some(Ok(now)) = now.filter(|_| own.borrow().keeps(number)) else {
                return;
            };
            let message = if last.as_ref() == Some(&now) {
                Bytes::from_static(b"event: alive\ndata: 1\n\n")
            } else {
                event(&now)
            };
            last = Some(now);
            // A phone that takes nothing is given up.
            if !matches!(timeout(PATIENCE, sender.send(message)).await, Ok(Ok(()))) {
                return;
            }
            tokio::select! {
                () = sender.closed() => return,
                () = sleep(HEARTBEAT) => {}
                changed = own.changed() => if changed.is_err() { return },
                changed = paces.changed() => if changed.is_err() { return },
            }
        }
    });
    Ok(Events(receiver))
}

fn event(pace: &OwnPace) -> Bytes {
    // Numbers, words and an answer of finite numbers can always be written.
    let data = serde_json::to_string(pace).unwrap_or_default();
    format!("event: pace\ndata: {data}\n\n").into()
}
