//! Rays: boxes, shadows, light through the object, one bounce, and the surroundings.

mod bounce;
mod bvh;
mod light_buffer;
mod packet;
mod proof;
mod shadow;
mod solid;
mod transmission;
mod traverse;
mod world;

pub use bounce::{Bounced, Receivers};
pub use bvh::Bvh;
pub use light_buffer::{LightBuffer, update_light_buffers};
pub use packet::{BLOCK, Visibility};
pub use shadow::ShadowCaster;
pub use solid::{PrimaryHits, Solid};
pub use transmission::Transmission;
pub use world::{DiffuseSurface, LightScratch, World, matt_scene};
