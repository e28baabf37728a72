//! The settings of a study, and their measurement by the exact picture and the clock.

use super::historic::{Historic, cannot_draw};
use super::{
    Method, Omission, Setting, Study, StudyQuestion, StudyRow, law_cost, median_and_spread, own_law,
};
use crate::analysis::comparison::{LinearPicture, region_errors};
use crate::analysis::{Subject, Watch};
use crate::geometry::{Mesh, VertexMesh, tessellate};
use crate::illumination::Equation;
use crate::render::{Renderer, Stage};
use crate::scene::{
    Interpolation, Object, ObjectKind, Projection, ReflectionModel, Scene, ShadingMode, View,
};
use std::collections::HashMap;
use std::sync::Arc;

/// N·V of the true surface below which pixels do not count as inside: there polygons have the outline's error.
const INSIDE: f64 = 0.2;

/// Measures a subject. `watch` is called after each frame; when it stops the work, the results so far are returned.
pub fn study(subject: &Subject, request: &StudyQuestion, watch: &dyn Watch<Study>) -> Study {
    let model = subject.model.as_deref();
    let (settings, omitted) = settings(request, &subject.scene, model);
    let repeats = request.repeats.max(1);
    let total = settings.len() as u64 * u64::from(repeats);
    let reference = request.reference(&subject.scene);
    let mut measure = Measure::new(subject, reference);
    let compares = reference != subject.scene.reflection.model;
    let mut study = Study {
        omitted,
        threads: rayon::current_num_threads(),
        reference: compares.then_some(reference),
        own_law: own_law(&subject.scene),
        ..Study::default()
    };
    let mut samples: Vec<Vec<u64>> = vec![Vec::new(); settings.len()];
    let mut done = 0;
    for repeat in 0..repeats {
        for (index, setting) in settings.iter().enumerate() {
            if repeat == 0 {
                study.rows.push(measure.errors(setting));
            }
            let (nanoseconds, evaluations) = measure.time(setting);
            samples[index].push(nanoseconds);
            let row = &mut study.rows[index];
            (row.evaluations, row.samples) = (evaluations, repeat + 1);
            (row.time_ms, row.spread_ms) = median_and_spread(&mut samples[index]);
            done += 1;
            study.conclude();
            watch.found(&study);
            if !watch.progress(done as f32 / total as f32) && done < total {
                return study;
            }
        }
    }
    study.complete = true;
    study
}

/// Returns the settings of `request`, those of one method together from coarse to fine, and the omissions.
/// `model` is the mesh that the scene shows, if it is one of a file.
fn settings(
    request: &StudyQuestion,
    scene: &Scene,
    model: Option<&Mesh>,
) -> (Vec<Setting>, Vec<Omission>) {
    let (mut settings, mut omissions) = (Vec::new(), Vec::new());
    let divisions = divisions(request, scene);
    let exponents = if request.n.is_empty() {
        vec![scene.material.n]
    } else {
        unique(request.n.iter().copied())
    };
    let laws = request.laws(scene);
    let pairs = exponents
        .iter()
        .flat_map(|n| laws.iter().map(|law| (*n, *law)));
    for (n, law) in pairs {
        for method in unique(request.methods.iter().copied()) {
            for interpolation in interpolations(method, request, scene) {
                let mut drawn = scene.clone();
                drawn.shading.interpolation = interpolation.unwrap_or(scene.shading.interpolation);
                drawn.reflection.model = law.unwrap_or(scene.reflection.model);
                if method.is_scalar()
                    && let Some(reason) = cannot_draw(method, &drawn, model)
                {
                    let omission = Omission {
                        method,
                        interpolation,
                        law,
                        reason,
                    };
                    if !omissions.contains(&omission) {
                        omissions.push(omission);
                    }
                    continue;
                }
                let setting = |&[segments, rings]: &[u32; 2]| Setting {
                    method,
                    segments,
                    rings,
                    interpolation,
                    n,
                    law,
                };
                settings.extend(divisions.iter().map(setting));
            }
        }
    }
    (settings, omissions)
}

/// Returns the interpolations that make a difference; where none does, one represents all.
fn interpolations(
    method: Method,
    request: &StudyQuestion,
    scene: &Scene,
) -> Vec<Option<Interpolation>> {
    if matches!(method, Method::Flat | Method::FlatVertexMean) {
        return vec![None];
    }
    let flat = scene.camera.projection == Projection::Orthographic;
    let same = |interpolation: Interpolation| match interpolation {
        Interpolation::Affine if flat => Interpolation::Perspective,
        // The scalar code interpolates over triangles, not along the scan lines of polygons.
        Interpolation::Scanline if method.is_scalar() => Interpolation::Affine,
        other => other,
    };
    let interpolations = request.interpolations.iter();
    unique(interpolations.map(|interpolation| Some(same(*interpolation))))
}

/// Returns the valid tessellations, segments and rings, from coarse to fine.
fn divisions(request: &StudyQuestion, scene: &Scene) -> Vec<[u32; 2]> {
    /// Minimum number of rings for every shape.
    const LEAST_RINGS: u32 = 3;
    let object = &scene.object;
    let own = [object.segments, object.rings];
    if object.kind.is_given() || request.segments.is_empty() {
        return vec![own];
    }
    let per_segment = f64::from(own[1]) / f64::from(own[0].max(1));
    let rings = |segments: u32| {
        ((f64::from(segments) * per_segment).round() as u32).max(LEAST_RINGS.min(own[1]))
    };
    let valid = |[segments, rings]: &[u32; 2]| {
        let mut tried = scene.clone();
        (tried.object.segments, tried.object.rings) = (*segments, *rings);
        tried.validate().is_ok()
    };
    let mut all: Vec<[u32; 2]> = request
        .segments
        .iter()
        .map(|&segments| [segments, rings(segments)])
        .filter(valid)
        .collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Returns the values without repetitions, in their order.
fn unique<T: PartialEq>(values: impl Iterator<Item = T>) -> Vec<T> {
    let mut kept = Vec::new();
    for value in values {
        if !kept.contains(&value) {
            kept.push(value);
        }
    }
    kept
}

struct Measure<'a> {
    subject: &'a Subject,
    /// The law whose exact picture errors are measured against.
    reference: ReflectionModel,
    renderer: Renderer,
    historic: Historic,
    /// The mesh last requested.
    mesh: Option<(Object, VertexMesh)>,
    /// The exact pictures, by the bits of n.
    exact: HashMap<u64, Exact>,
}

struct Exact {
    pixels: Vec<[f32; 4]>,
    /// The pixels that show the object with N·V ≥ [`INSIDE`].
    inside: Vec<bool>,
}

impl<'a> Measure<'a> {
    fn new(subject: &'a Subject, reference: ReflectionModel) -> Self {
        Self {
            subject,
            reference,
            renderer: subject.renderer(),
            historic: Historic::default(),
            mesh: None,
            exact: HashMap::new(),
        }
    }

    fn scene(&self, setting: &Setting) -> Scene {
        let mut scene = self.subject.scene.clone();
        setting.apply(&mut scene);
        scene
    }

    /// Draws a setting; returns its linear picture.
    fn draw(&mut self, setting: &Setting) -> &[[f32; 4]] {
        let scene = self.scene(setting);
        if setting.method.is_scalar() {
            let mesh = mesh_of(&mut self.mesh, self.subject.model.as_ref(), &scene);
            self.historic.draw(setting.method, &scene, mesh);
            return &self.historic.linear;
        }
        self.renderer.keep_linear(true);
        self.renderer.render(&scene);
        self.renderer.linear()
    }

    /// Returns the row of a setting with its errors and the spacing of its vertices, not yet timed.
    fn errors(&mut self, setting: &Setting) -> StudyRow {
        let scene = self.scene(setting);
        let pixels = self.draw(setting).to_vec();
        let with_reference = setting.law.filter(|law| *law != self.reference).map(|_| {
            let law = Some(self.reference);
            self.draw(&Setting { law, ..*setting }).to_vec()
        });
        // The true surface does not depend on the tessellation, and only n differs.
        let renderer = &mut self.renderer;
        let exact = self.exact.entry(setting.n.to_bits()).or_insert_with(|| {
            let mut whole = self.subject.scene.clone();
            (whole.material.n, whole.shading.mode) = (setting.n, ShadingMode::Exact);
            whole.reflection.model = self.reference;
            Exact::new(renderer, &whole)
        });
        let apart = |other: &[[f32; 4]], clamps: bool| {
            let picture = |pixels| LinearPicture {
                width: scene.image.size[0],
                pixels,
                clamps,
            };
            region_errors(picture(&pixels), picture(other), &exact.inside)
        };
        let [errors, shown] = [false, scene.clamps()].map(|clamps| apart(&exact.pixels, clamps));
        let law_rms = with_reference.map(|other| apart(&other, false).interior.rms);
        let mesh = mesh_of(&mut self.mesh, self.subject.model.as_ref(), &scene);
        StudyRow {
            setting: *setting,
            spacing: longest_edge(mesh),
            error_rms: errors.interior.rms,
            error_max: errors.interior.greatest,
            error_p99: errors.percentile_99,
            error_rms_shown: shown.interior.rms,
            error_max_shown: shown.interior.greatest,
            interior_pixels: errors.interior.pixels,
            outline_pixels: errors.outline_pixels,
            outline_rms: errors.outline_rms,
            time_ms: 0.0,
            spread_ms: 0.0,
            samples: 0,
            evaluations: 0,
            pareto: false,
            scalar: setting.method.is_scalar(),
            law_rms,
            operations: law_cost(&scene).map(|law| setting.method.pixel_cost_of(law)),
        }
    }

    /// Measures the time of a frame in nanoseconds without the tessellation, and its evaluations.
    fn time(&mut self, setting: &Setting) -> (u64, u64) {
        let scene = self.scene(setting);
        if setting.method.is_scalar() {
            let mesh = mesh_of(&mut self.mesh, self.subject.model.as_ref(), &scene);
            self.historic.draw(setting.method, &scene, mesh);
            let began = (self.subject.clock)();
            self.historic.draw(setting.method, &scene, mesh);
            let time = (self.subject.clock)().saturating_sub(began);
            return (time, self.historic.evaluations);
        }
        self.renderer.keep_linear(false);
        // One frame for geometry, buffers and caches, which the previous setting has left in its own state.
        self.renderer.render(&scene);
        self.renderer.redraw();
        self.renderer.render(&scene);
        let report = self.renderer.report();
        let stages = report.stages.iter();
        let tessellation = stages.filter(|run| run.stage == Stage::Geometry);
        let tessellation: u64 = tessellation.map(|run| run.nanoseconds).sum();
        let evaluations = report.stages.iter().map(|run| run.evaluations).sum();
        (report.nanoseconds.saturating_sub(tessellation), evaluations)
    }
}

impl Exact {
    /// Draws `scene`, whose mode is exact: in double precision where no rays contribute to a pixel, rounded at the end.
    fn new(renderer: &mut Renderer, scene: &Scene) -> Self {
        renderer.keep_linear(true);
        renderer.render(scene);
        let [width, height] = scene.image.size;
        let mut pixels = renderer.linear().to_vec();
        let mut inside = vec![false; pixels.len()];
        let equations = renderer.for_each_material(scene, Equation::<f64>::new);
        let view = View::new(&scene.camera, scene.image.size);
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        for (index, (x, y)) in places.enumerate() {
            if pixels[index][3] == 0.0 {
                continue;
            }
            let Some(evaluation) = renderer.evaluation(x, y) else {
                continue;
            };
            inside[index] = evaluation.normal.dot(view.towards_eye(evaluation.position)) >= INSIDE;
            if renderer.mixture(x, y).is_none() {
                let [r, g, b] = evaluation.shown(&equations).as_vec3().to_array();
                pixels[index] = [r, g, b, pixels[index][3]];
            }
        }
        Self { pixels, inside }
    }
}

/// Returns the mesh of a scene, rebuilt when the object has changed.
fn mesh_of<'a>(
    kept: &'a mut Option<(Object, VertexMesh)>,
    model: Option<&Arc<Mesh>>,
    scene: &Scene,
) -> &'a VertexMesh {
    let object = &scene.object;
    kept.take_if(|(made, _)| made != object);
    let (_, mesh) = kept.get_or_insert_with(|| {
        let vertices =
            |mesh: &Mesh| mesh.with_vertex_normals(object.normal_source(), object.weighting);
        let mesh = match (object.kind, model) {
            (ObjectKind::Obj, Some(model)) => vertices(model),
            (ObjectKind::Obj, None) => vertices(&Mesh::default()),
            _ => vertices(&tessellate(object)),
        };
        (object.clone(), mesh)
    });
    mesh
}

/// Returns the longest edge of any polygon, world units.
fn longest_edge(mesh: &VertexMesh) -> f64 {
    let place = |vertex: &u32| mesh.positions[*vertex as usize];
    let edges = (0..mesh.face_count()).flat_map(|face| {
        let corners = mesh.face(face);
        corners.iter().zip(corners.iter().cycle().skip(1))
    });
    edges
        .map(|(from, to)| f64::from(place(from).distance(place(to))))
        .fold(0.0, f64::max)
}
