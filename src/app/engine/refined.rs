//! Antialiased edges: pictures with several samples per pixel, drawn in the background when nothing has changed for a
//! while.

use crate::analysis::Watch;
use crate::analysis::codec::{Codec, from_bytes, to_bytes};
use crate::app::widgets::background::{PICTURES, wake};
use crate::geometry::Mesh;
use crate::jobs::{Job, News, Work, model_from_bytes, model_to_bytes, nanoseconds};
use crate::render::Renderer;
use crate::scene::Scene;
use eframe::egui::{ColorImage, Context, TextureHandle, TextureOptions};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::time::Duration;

/// Time without changes before the pictures are refined, seconds.
const REST: f64 = 0.2;
/// Samples per pixel of the successive pictures.
const SAMPLES: [u32; 2] = [4, 16];
/// Maximum expected time for pictures with all of their samples, nanoseconds; slower ones are not refined.
const MOST: u64 = 2_000_000_000;
/// Maximum time for one sample of the pictures, nanoseconds, including the one-time cost of the first picture; slower
/// ones are not refined.
const MOST_ONCE: u64 = MOST / 4;

/// Maximum number of triangles in all pictures; larger ones are not refined, since the work has meshes of its own
/// besides those of the panes.
const MOST_TRIANGLES: u64 = 600_000;

/// The refined pictures of the panes shown.
#[derive(Default)]
pub struct Refined {
    /// The time of the last change of the pictures, seconds.
    since: Option<f64>,
    job: Option<Job<Supersampled>>,
    /// True if there is nothing left to draw.
    over: bool,
    textures: Vec<(usize, TextureHandle)>,
    /// Samples per pixel of the pictures shown; 0 before there are any.
    pub samples: u32,
    /// Shared with the work in progress. Cancelled work continues to the end of its sample; no other begins until then,
    /// so that at most one more renderer is in memory.
    alive: Arc<()>,
}

/// Panes by their indices, to be drawn with several samples per pixel.
#[derive(Serialize, Deserialize)]
pub struct Supersampled {
    pub panes: Vec<(usize, Scene)>,
    #[serde(
        serialize_with = "model_to_bytes",
        deserialize_with = "model_from_bytes"
    )]
    pub model: Option<Arc<Mesh>>,
    #[serde(skip)]
    #[expect(dead_code, reason = "held as long as the work is")]
    pub alive: Arc<()>,
}

/// The pictures in the order of the panes, and their samples per pixel.
#[derive(Clone)]
pub struct Pictures {
    samples: u32,
    images: Vec<(usize, Arc<ColorImage>)>,
}

const CODEC: Codec<Pictures> = Codec {
    to_bytes: |Pictures { samples, images }| {
        let (panes, images): (Vec<usize>, Vec<_>) = images.iter().cloned().unzip();
        let images = images.into_iter().map(Arc::unwrap_or_clone).collect();
        to_bytes(&(samples, panes, (PICTURES.to_bytes)(&images)))
    },
    from_bytes: |bytes| {
        let (samples, panes, images): (_, Vec<usize>, Vec<u8>) = from_bytes(bytes)?;
        let images = (PICTURES.from_bytes)(&images)?.into_iter().map(Arc::new);
        Some(Pictures {
            samples,
            images: panes.into_iter().zip(images).collect(),
        })
    },
};

impl Work for Supersampled {
    type Answer = Pictures;

    const CODECS: Option<(Codec<Self>, Codec<Pictures>)> = Some((Codec::plain(), CODEC));

    fn run(&self, watch: &dyn Watch<Pictures>) -> Result<Pictures, String> {
        let mut renderer = Renderer::default().with_model(self.model.clone());
        let mut pictures = None;
        let all = SAMPLES.iter().sum::<u32>() * self.panes.len() as u32;
        let (mut done, mut before) = (0, nanoseconds());
        for samples in SAMPLES {
            let mut images = Vec::new();
            for (pane, scene) in &self.panes {
                let mut goes_on = true;
                let frame = renderer.render_supersampled(scene, samples, &mut |n| {
                    let now = nanoseconds();
                    let took = now - std::mem::replace(&mut before, now);
                    // The time of the very first sample includes making the mesh.
                    let affordable = done + n < 2 || took.saturating_mul(u64::from(all)) <= MOST;
                    goes_on = affordable && watch.progress((done + n) as f32 / all as f32);
                    goes_on
                });
                if !goes_on {
                    // Nobody reads the message.
                    return Err(String::new());
                }
                done += samples;
                images.push((*pane, Arc::new(super::image_of(&frame))));
            }
            let found = Pictures { samples, images };
            watch.found(&found);
            pictures = Some(found);
            // Telling what was found is no part of a sample's time.
            before = nanoseconds();
        }
        pictures.ok_or_else(String::new)
    }
}

impl Refined {
    /// Returns whether pictures may be refined if one sample takes `cost` nanoseconds and they have this many triangles
    /// in all.
    pub fn affords(cost: u64, triangles: u64) -> bool {
        cost <= MOST_ONCE && triangles <= MOST_TRIANGLES
    }

    /// Returns to one sample per pixel.
    pub fn forget(&mut self) {
        *self = Self {
            alive: self.alive.clone(),
            ..Self::default()
        };
    }

    /// Starts to refine the pictures when nothing has changed for long enough, and takes those that have been drawn.
    pub fn update(&mut self, ctx: &Context, work: impl FnOnce(Arc<()>) -> Supersampled) {
        if let Some(job) = &self.job {
            let news = job.news();
            if let Some(News::Over(_)) = &news {
                (self.job, self.over) = (None, true);
            }
            if let Some(News::SoFar(pictures) | News::Over(Ok(pictures))) = news {
                self.take(ctx, pictures);
            }
            return;
        }
        if self.over {
            return;
        }
        let now = ctx.input(|input| input.time);
        let left = REST - (now - *self.since.get_or_insert(now));
        if left > 0.0 {
            ctx.request_repaint_after(Duration::from_secs_f64(left));
        } else if Arc::strong_count(&self.alive) > 1 {
            ctx.request_repaint_after(Duration::from_secs_f64(REST));
        } else {
            self.job = Some(Job::start(work(self.alive.clone()), wake(ctx)));
        }
    }

    fn take(&mut self, ctx: &Context, pictures: Pictures) {
        self.samples = pictures.samples;
        let options = TextureOptions::NEAREST;
        let images = pictures.images.into_iter();
        self.textures = images
            .map(|(pane, image)| (pane, ctx.load_texture("refined", image, options)))
            .collect();
    }

    /// Returns the refined picture of a pane, if there is one.
    pub fn picture(&self, pane: usize) -> Option<&TextureHandle> {
        self.textures
            .iter()
            .find(|(number, _)| *number == pane)
            .map(|(_, texture)| texture)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::unwatched;

    #[test]
    fn the_last_picture_has_sixteen_samples_a_pixel() {
        let mut scene = Scene::default();
        scene.image.size = [24, 20];
        let expected = Renderer::default().render_supersampled(&scene, 16, &mut |_| true);
        let work = Supersampled {
            panes: vec![(3, scene)],
            model: None,
            alive: Arc::default(),
        };
        let found = work.run(&unwatched).expect("pictures");
        assert_eq!(found.samples, 16);
        let (pane, image) = &found.images[0];
        assert_eq!((*pane, image.as_raw()), (3, expected.pixels.as_flattened()));
        assert!(work.run(&|share| share < 0.5).is_err());
    }
}
