//! Background work for the window, which is redrawn when an answer arrives.

use crate::analysis::Watch;
use crate::analysis::codec::{Codec, from_bytes, to_bytes};
use crate::jobs::{Background, Work};
use crate::text::text;
use eframe::egui::{ColorImage, Context, ProgressBar, TextureHandle, TextureOptions, Ui};
use std::time::Duration;

/// Returns a function that requests a repaint of the window after a duration.
pub fn wake(ctx: &Context) -> impl Fn(Duration) + Send + Sync + use<> {
    let ctx = ctx.clone();
    move |after| ctx.request_repaint_after(after)
}

/// Minimum duration of long work: a frame of 60 a second, which would be slower if it ran beside one.
const LONG: Duration = Duration::from_millis(16);

/// Asks for work as [`Background::ask`] does, but for long work only once nothing is dragged: until then its latest answer
/// stays.
pub fn ask<W: Work>(
    background: &mut Background<W>,
    ctx: &Context,
    same: impl Fn(&W) -> bool,
    work: impl FnOnce() -> W,
) -> bool {
    if background.took() > LONG && ctx.input(|input| input.pointer.any_down()) {
        background.take()
    } else {
        background.ask(wake(ctx), same, work)
    }
}

/// Background work given as a function.
pub struct Task<A>(Box<Run<A>>);

type Run<A> = dyn Fn(&dyn Watch<A>) -> Result<A, String> + Send + Sync;

impl<A> Task<A> {
    pub fn new(run: impl Fn(&dyn Watch<A>) -> Result<A, String> + Send + Sync + 'static) -> Self {
        Self(Box::new(run))
    }
}

impl<A: Clone + Send + Sync + 'static> Work for Task<A> {
    type Answer = A;

    fn run(&self, watch: &dyn Watch<A>) -> Result<A, String> {
        (self.0)(watch)
    }
}

/// The codec for pictures in messages between the page and its workers.
pub const PICTURES: Codec<Vec<ColorImage>> = Codec {
    to_bytes: |pictures| {
        let plain = |picture: &ColorImage| (picture.size, picture.as_raw().to_vec());
        to_bytes(&pictures.iter().map(plain).collect::<Vec<_>>())
    },
    from_bytes: |bytes| {
        let pictures: Vec<([usize; 2], Vec<u8>)> = from_bytes(bytes)?;
        let picture = |(size, pixels): ([usize; 2], Vec<u8>)| {
            let whole = pixels.len() == 4 * size[0] * size[1];
            whole.then(|| ColorImage::from_rgba_premultiplied(size, &pixels))
        };
        pictures.into_iter().map(picture).collect()
    },
};

/// Small pictures drawn in the background and uploaded to the graphics card as they arrive.
pub struct Pictures<W: Work> {
    /// The textures that have arrived, in order.
    pub textures: Vec<TextureHandle>,
    wanted: Option<W>,
    work: Background<W>,
}

impl<W: Work> Default for Pictures<W> {
    fn default() -> Self {
        Self {
            textures: Vec::new(),
            wanted: None,
            work: Background::default(),
        }
    }
}

impl<W: Work<Answer = Vec<ColorImage>> + Clone + PartialEq> Pictures<W> {
    /// Starts drawing the `count` pictures that are `wanted`, or takes those that have arrived. Once all have arrived,
    /// only the graphics card holds them.
    pub fn prepare(&mut self, ctx: &Context, wanted: &W, count: usize) {
        if self.wanted.as_ref() != Some(wanted) {
            *self = Self::default();
            self.wanted = Some(wanted.clone());
        }
        if self.textures.len() == count {
            return;
        }
        self.work.ask(wake(ctx), |_| true, || wanted.clone());
        let pictures = self.work.answer().map_or(&[][..], Vec::as_slice);
        for image in pictures.iter().skip(self.textures.len()) {
            let options = TextureOptions::LINEAR;
            let texture = ctx.load_texture("picture", image.clone(), options);
            self.textures.push(texture);
        }
        if self.textures.len() == count {
            self.work = Background::default();
        }
    }

    /// Drops the pictures if they are still being drawn, since they are no longer in view.
    pub fn leave(&mut self) {
        if self.work.progress().is_some() {
            *self = Self::default();
        }
    }
}

/// Shows the progress of the work with a button that stops it. Returns whether any work is running.
pub fn progress_ui<W: Work>(ui: &mut Ui, background: &Background<W>, tip: &str) -> bool {
    let Some(share) = background.progress() else {
        return false;
    };
    ui.horizontal(|ui| {
        if ui.button(text!("report-stop")).on_hover_text(tip).clicked() {
            background.stop();
        }
        let bar = ProgressBar::new(share).show_percentage();
        ui.add(bar.desired_width(ui.available_width()));
    });
    true
}

#[cfg(test)]
mod tests {
    use super::{LONG, Task, ask};
    use crate::jobs::Background;
    use eframe::egui::{Context, Event, Modifiers, PointerButton, Pos2, RawInput};
    use std::thread;
    use std::time::Duration;

    #[test]
    fn long_work_waits_until_nothing_is_dragged_and_short_work_does_not() {
        let ctx = Context::default();
        // Asks in one frame for work of that duration; returns whether it runs.
        let asked = |background: &mut Background<Task<()>>, events, duration| {
            let input = RawInput {
                events,
                ..RawInput::default()
            };
            let work = || {
                Task::new(move |_| {
                    thread::sleep(duration);
                    Ok(())
                })
            };
            let mut output = ctx.run_ui(input, |ui| {
                ask(background, ui.ctx(), |_| false, work);
            });
            output.textures_delta.clear();
            background.progress().is_some()
        };
        let button = |pressed| Event::PointerButton {
            pos: Pos2::ZERO,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::default(),
        };
        for (duration, waits) in [
            (LONG + Duration::from_millis(20), true),
            (Duration::ZERO, false),
        ] {
            let mut background = Background::default();
            let pressed = vec![Event::PointerMoved(Pos2::ZERO), button(true)];
            assert!(asked(&mut background, pressed, duration), "the first time");
            while !background.take() {
                thread::yield_now();
            }
            assert_eq!(asked(&mut background, vec![], duration), !waits);
            assert!(asked(&mut background, vec![button(false)], duration));
        }
    }
}
