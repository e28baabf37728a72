//! An interactive laboratory for local illumination and polygon shading.
//!
//! A [`scene::Scene`] describes what is drawn; a [`render::Renderer`] draws it with a software rasterizer of its own, in any
//! shading mode from flat to exact; [`analysis`] measures the picture, and [`figure`] draws the results over it.
//!
//! # Conventions
//! The world is right-handed with y up; lengths are world units. Angles are degrees in scenes and radians in code.
//! Intensities are linear, 1 is the display's white. Pictures are stored row by row from the top; the centre of pixel
//! (x, y) is (x + 0.5, y + 0.5). Vectors are named as in the textbooks: N the surface normal, L towards the light, R its
//! mirror image at N, V towards the viewer, H half-way between L and V.
//!
//! # Example
//! ```
//! use shading_lab::render::Renderer;
//! use shading_lab::scene::{Scene, ShadingMode};
//!
//! let mut scene = Scene::default();
//! scene.image.size = [64, 64];
//! scene.shading.mode = ShadingMode::Gouraud;
//! let mut renderer = Renderer::default();
//! let picture = renderer.render(&scene);
//! let middle = picture.pixel(32, 32).expect("a pixel inside the picture");
//! assert!(middle[0] > middle[2], "the sphere is red");
//! ```
//!
//! More examples are in `docs/library.md`, and at the items that most programs begin with: [`document::load_scene`],
//! [`scene::Scene`], [`render::Renderer`], [`analysis::probe`](fn@analysis::probe::probe), [`analysis::Question`], [`figure::Plot`], [`geometry::Mesh`],
//! [`picture::write_png`], [`link::read`], [`export::glsl_330`] and [`lesson::Lesson`].

pub mod analysis;
pub mod animation;
// The program's own window, reached by the binary and the tests: no part of the library's interface.
#[cfg(feature = "app")]
#[doc(hidden)]
pub mod app;
mod bits;
#[cfg(all(feature = "class", not(target_arch = "wasm32")))]
pub mod class;
pub mod document;
pub mod export;
pub mod expression;
pub mod figure;
pub mod geometry;
pub mod illumination;
pub mod jobs;
pub mod lesson;
pub mod link;
pub mod picture;
#[cfg(test)]
#[path = "../tests/common/properties.rs"]
mod properties;
pub mod render;
pub mod scene;
pub mod text;

/// The vectors of the public interface.
pub use glam;

/// The page's examples, compiled and run with those of the sources.
#[cfg(doctest)]
#[doc = include_str!("../docs/library.md")]
struct Library;
