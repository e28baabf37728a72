//! Rays: boxes, shadows, light through the object, one bounce, and the surroundings.

mod bounce;
mod bounce_grid;
mod bvh;
mod diffuse;
mod floor;
mod packet;
mod pixels;
mod point_row;
mod primary_hit;
mod proof;
mod shadow;
mod solid;
mod surroundings;
mod transmission;
mod traverse;
mod visibility;

pub use bounce::Gathering;
pub use bvh::Bvh;
pub use diffuse::{DiffuseSurface, LightScratch, any_light, diffuse_scene};
pub use floor::FloorView;
pub use pixels::{Background, Bounced, bounce, see_background, shadow_pixels, shadow_points};
pub use primary_hit::PrimaryHits;
pub use shadow::ShadowCaster;
pub use solid::Solid;
pub use surroundings::Surroundings;
pub use transmission::{Glass, Transmission};
pub use visibility::{BLOCK, Visibility};
