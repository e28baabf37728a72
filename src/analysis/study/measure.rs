//! Draws settings and measures them.

use super::Setting;
use super::exact::Exact;
use super::historic::Historic;
use crate::analysis::{LinearPicture, RegionErrors, region_errors};
use crate::geometry::{Mesh, VertexMesh, tessellate};
use crate::render::{Renderer, Report, Stage};
use crate::scene::{Object, ObjectKind, Scene};
use std::collections::HashMap;
use std::sync::Arc;

/// Draws the settings of one scene.
pub struct Bench {
    scene: Scene,
    model: Option<Arc<Mesh>>,
    clock: fn() -> u64,
    renderer: Renderer,
    historic: Historic,
    /// The mesh of the last scalar method.
    mesh: Option<(Object, VertexMesh)>,
    /// The exact pictures, by the bits of n.
    exact: HashMap<u64, Exact>,
}

impl Bench {
    pub fn new(scene: &Scene, model: Option<Arc<Mesh>>, clock: fn() -> u64) -> Self {
        let mut renderer = Renderer::with_clock(clock);
        renderer.set_model(model.clone());
        let (historic, exact) = (Historic::default(), HashMap::new());
        Self { scene: scene.clone(), model, clock, renderer, historic, mesh: None, exact }
    }

    fn scene(&self, setting: &Setting) -> Scene {
        let mut scene = self.scene.clone();
        setting.apply(&mut scene);
        scene
    }

    /// The errors of a setting before the display and as shown, and its spacing of vertices in world units.
    pub fn errors(&mut self, setting: &Setting) -> ([RegionErrors; 2], f64) {
        let scene = self.scene(setting);
        let renderer = &mut self.renderer;
        let exact = self.exact.entry(setting.n.to_bits()).or_insert_with(|| {
            // The true surface is the scene's own whatever it is cut into, and n is all that differs.
            let mut whole = self.scene.clone();
            whole.material.n = setting.n;
            Exact::new(renderer, &whole)
        });
        renderer.keep_linear(true);
        let pixels = if setting.method.is_scalar() {
            let mesh = mesh_of(&mut self.mesh, self.model.as_ref(), &scene);
            self.historic.draw(setting.method, &scene, mesh);
            &self.historic.linear
        } else {
            renderer.render(&scene);
            renderer.linear()
        };
        let errors = [false, scene.clamps()].map(|clamps| {
            let picture = LinearPicture { width: scene.image.size[0], pixels, clamps };
            region_errors(picture, LinearPicture { clamps, ..exact.picture() }, &exact.inside)
        });
        (errors, longest_edge(mesh_of(&mut self.mesh, self.model.as_ref(), &scene)))
    }

    /// The time of a frame in nanoseconds without the tessellation, and its evaluations.
    pub fn time(&mut self, setting: &Setting) -> (u64, u64) {
        let scene = self.scene(setting);
        if setting.method.is_scalar() {
            let mesh = mesh_of(&mut self.mesh, self.model.as_ref(), &scene);
            self.historic.draw(setting.method, &scene, mesh);
            let began = (self.clock)();
            self.historic.draw(setting.method, &scene, mesh);
            return ((self.clock)().saturating_sub(began), self.historic.evaluations);
        }
        self.renderer.keep_linear(false);
        // Once for geometry, buffers and caches, which the setting before has left as it needed them.
        self.renderer.render(&scene);
        self.renderer.redraw();
        self.renderer.render(&scene);
        counted(self.renderer.report())
    }
}

fn counted(report: &Report) -> (u64, u64) {
    let geometry: u64 =
        report.stages.iter().filter(|run| run.stage == Stage::Geometry).map(|run| run.nanoseconds).sum();
    let evaluations = report.stages.iter().map(|run| run.evaluations).sum();
    (report.nanoseconds.saturating_sub(geometry), evaluations)
}

/// The mesh of a scene, made anew when the object has changed.
fn mesh_of<'a>(kept: &'a mut Option<(Object, VertexMesh)>, model: Option<&Arc<Mesh>>, scene: &Scene) -> &'a VertexMesh {
    let object = &scene.object;
    if kept.as_ref().is_some_and(|(made, _)| made != object) {
        *kept = None;
    }
    let (_, mesh) = kept.get_or_insert_with(|| {
        let vertices = |mesh: &Mesh| mesh.with_vertex_normals(object.normals, object.weighting);
        let mesh = match (object.kind, model) {
            (ObjectKind::Obj, Some(model)) => vertices(model),
            (ObjectKind::Obj, None) => vertices(&Mesh::default()),
            _ => vertices(&tessellate(object)),
        };
        (object.clone(), mesh)
    });
    mesh
}

/// The longest edge of any polygon, world units.
fn longest_edge(mesh: &VertexMesh) -> f64 {
    let mut longest = 0.0_f64;
    for face in 0..mesh.face_count() {
        let corners = mesh.face(face);
        for (index, &from) in corners.iter().enumerate() {
            let to = corners[(index + 1) % corners.len()];
            let edge = mesh.positions[from as usize].distance(mesh.positions[to as usize]);
            longest = longest.max(edge.into());
        }
    }
    longest
}
