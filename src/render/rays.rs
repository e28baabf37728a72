//! Rays: boxes, shadows, light through the object, one bounce, and the surroundings.

mod bounce;
mod bvh;
mod floor;
mod packet;
mod primary_hit;
mod proof;
mod shadow;
mod solid;
mod transmission;
mod traverse;
mod world;

pub use bounce::Bounced;
pub use bvh::Bvh;
pub use packet::{BLOCK, Visibility};
pub use primary_hit::PrimaryHits;
pub use shadow::ShadowCaster;
pub use solid::Solid;
pub use transmission::Transmission;
pub use world::{DiffuseSurface, LightScratch, World, matt_scene};
