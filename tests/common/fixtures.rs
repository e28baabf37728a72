//! Helpers shared by several tests.

use glam::Vec3;
use shading_lab::geometry::{Corner, Mesh, NO_NORMAL};

/// Returns a message of the catalogue in English, whatever the language of the window beside it. It takes the arguments of
/// `text!`.
#[allow(unused_macros, reason = "each program takes what it needs")]
macro_rules! english {
    ($($message:tt)+) => {
        shading_lab::text::in_language(shading_lab::text::Language::English, || {
            shading_lab::text!($($message)+)
        })
    };
}

pub mod alone;
pub mod any_formula;
pub mod any_scene;
pub mod dice;
pub mod fuzz;
pub mod golden;
#[cfg(feature = "app")]
pub mod hands;
pub mod lessons;
#[cfg(feature = "app")]
pub mod monkey;
#[cfg(feature = "cli")]
pub mod program;
pub mod properties;
pub mod reasons;
pub mod screen;
pub mod simd;
pub mod textbook;
pub mod tries;

/// Returns a mesh without normals of its own; `faces` have indices into `positions`.
pub fn mesh(positions: &[[f32; 3]], faces: &[&[u32]]) -> Mesh {
    let mut mesh = Mesh {
        starts: vec![0],
        ..Mesh::default()
    };
    mesh.positions = positions.iter().copied().map(Vec3::from).collect();
    for face in faces {
        mesh.corners.extend(face.iter().map(|&position| Corner {
            position,
            normal: NO_NORMAL,
        }));
        mesh.starts.push(mesh.corners.len() as u32);
    }
    mesh
}

/// Returns the message about an invalid value of a scene.
pub fn value(place: &str, found: &str, expected: &str) -> String {
    let words = english!("problem-value", found = found, expected = expected);
    format!("{place} {words}")
}
