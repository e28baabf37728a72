//! The renderer: a picture in nine steps, each of which runs only when its inputs have changed.

mod kept;
mod point_shading;

use super::bands::{BandPainter, Canvas, Interpolated, Stale};
use super::cue::{CueLayer, fade_pixels};
use super::display::{Linear, compose, display};
use super::frame::{Frame, FrameReport, Stage};
use super::parts::Part;
use super::plan::{Cued, Inputs, Per, Plan};
use super::points::PointIntensities;
use super::ray_nodes::RayNodes;
use crate::geometry::{Mesh, Surface};
use crate::illumination::Equation;
use crate::render::face_materials::for_each_material;
use crate::render::lens::Lens;
use crate::render::model::{MeshSource, Model, Planes};
use crate::render::node::Node;
use crate::render::raster::{Band, Coverage, PlacedTriangles};
use crate::scene::{
    AmbientSource, FaceMaterial, MaterialSource, Object, ObjectKind, Scene, Weighting,
};
use fearless_simd::Level;
use glam::DVec2;
use std::fmt;
use std::mem::take;
use std::sync::Arc;

/// Draws scenes, keeping each step's output for the next call.
///
/// ```
/// use shading_lab::render::{Renderer, Stage};
/// use shading_lab::scene::Scene;
///
/// let mut scene = Scene::default();
/// scene.image.size = [64, 64];
/// let mut renderer = Renderer::default();
/// renderer.render(&scene);
///
/// // Another n shades the same pixels again: nothing is tessellated, transformed or covered.
/// scene.material.n = 200.0;
/// renderer.render(&scene);
/// let ran: Vec<Stage> = renderer.report().stages.iter().filter(|run| run.ran).map(|run| run.stage).collect();
/// assert!(ran.contains(&Stage::PixelShading) && !ran.contains(&Stage::Transform));
/// ```
#[derive(Default)]
pub struct Renderer {
    /// The SIMD level; `None` for the machine's best.
    level: Option<Level>,
    /// The clock; without one, all times are 0.
    clock: Option<fn() -> u64>,
    /// The mesh of an object of kind `obj`, and the number of its changes.
    given: (Option<Arc<Mesh>>, u64),
    mesh: Node<MeshSource>,
    pub(super) model: Node<Model>,
    surface: Node<Option<Surface>>,
    pub(super) placed: Node<PlacedTriangles>,
    /// The middles, the normals and the tints of the faces, where these are shaded.
    faces: Node<[Planes; 3]>,
    /// The intensities at vertices or faces, for each part of the picture.
    points: Node<Vec<PointIntensities>>,
    pub(super) bands: Node<Vec<Band>>,
    interpolated: Node<Interpolated>,
    pub(super) rays: RayNodes,
    cue: Node<CueLayer>,
    pub(super) picture: Node<Picture>,
    /// The steps of the current frame that the bands have yet to go through.
    stale: Stale,
    pub(super) keeps_linear: bool,
    leaves_nothing_out: bool,
    /// As in [`Plan::coarser`]; 0 before it is set.
    coarser: u32,
    /// The time for which pixels are shaded, nanoseconds; `None` for as long as it takes.
    shading_time: Option<u64>,
    /// The inputs of the last picture.
    pub(super) drawn: Option<PlannedFrame>,
    report: FrameReport,
}

impl fmt::Debug for Renderer {
    /// Prints the report only; the data kept for the next picture is too large.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Renderer")
            .field("report", &self.report)
            .finish_non_exhaustive()
    }
}

#[derive(Default)]
pub(super) struct Picture {
    pub frame: Frame,
    /// The picture before the display; empty if it is not needed.
    pub linear: Vec<Linear>,
    /// True for each band that is yet to be shaded.
    pub pending: Vec<bool>,
    /// The nanoseconds of shading and the number of overflowing pixels so far.
    tally: [u64; 2],
}

/// A frame with its plan, its camera and the equation of each part.
pub(super) struct PlannedFrame {
    pub scene: Scene,
    pub plan: Plan,
    pub lens: Lens,
    pub materials: Vec<FaceMaterial>,
    pub parts: Vec<Part>,
}

impl Renderer {
    /// Creates a renderer that measures its stages by `clock`, which gives nanoseconds from any fixed moment.
    pub fn with_clock(clock: fn() -> u64) -> Self {
        Self {
            clock: Some(clock),
            ..Self::default()
        }
    }

    /// Sets a SIMD level other than the machine's best.
    #[must_use]
    pub fn with_level(mut self, level: Level) -> Self {
        self.level = Some(level);
        self
    }

    /// Gives a new renderer its [model](Self::set_model).
    #[must_use]
    pub fn with_model(mut self, model: Option<Arc<Mesh>>) -> Self {
        self.set_model(model);
        self
    }

    /// Sets the mesh that an object of kind `obj` shows; `None` shows nothing. Another `Arc` is another model.
    pub fn set_model(&mut self, model: Option<Arc<Mesh>>) {
        if self.given.0.as_ref().map(Arc::as_ptr) != model.as_ref().map(Arc::as_ptr) {
            self.given = (model, self.given.1 + 1);
        }
    }

    /// Keeps the picture before the display from the next call on, for [`Renderer::linear`].
    pub fn keep_linear(&mut self, keep: bool) {
        self.keeps_linear = keep;
    }

    /// Evaluates, from the next call on, the work that the plan leaves out and that can be kept in, such as lights and
    /// terms that add nothing, an f of 1, back faces and the depth test. The stored pixels are the same: for tests, and to
    /// measure the work saved.
    pub fn leave_nothing_out(&mut self, nothing: bool) {
        if self.leaves_nothing_out != nothing {
            self.leaves_nothing_out = nothing;
            self.redraw();
        }
    }

    /// Makes the next pictures stand for others whose sides have `coarser` times as many pixels, as while something is dragged: light
    /// from other surfaces is then gathered at fewer points.
    pub fn stand_in(&mut self, coarser: u32) {
        self.coarser = coarser;
    }

    /// Draws a scene that [`Scene::validate`] accepts. Steps whose inputs have not changed since the last call do not run again.
    pub fn render(&mut self, scene: &Scene) -> &Frame {
        self.draw(scene, scene.image.size, DVec2::ZERO, false)
    }

    /// Draws a scene as [`Self::render`] does, but begins no further rows, or chunks of vertices or faces, once these have been shaded for
    /// some `nanoseconds` by the renderer's clock. Returns whether the picture [is finished](Self::is_finished); if not, the next call
    /// with the same scene goes on with it, and one with another scene gives it up. Rows that are not yet shaded show what they
    /// showed before, or nothing if the picture had another size.
    pub fn render_for(&mut self, scene: &Scene, nanoseconds: u64) -> bool {
        self.shading_time = Some(nanoseconds);
        self.render(scene);
        self.shading_time = None;
        self.is_finished()
    }

    /// Returns whether every row of the last picture is shaded.
    pub fn is_finished(&self) -> bool {
        !self.picture.output.is_pending()
    }

    /// Draws a part of a picture of `size` pixels whose samples lie `offset` pixels from the centres; `linear` says whether
    /// all of it is kept before the display.
    pub(super) fn draw(
        &mut self,
        scene: &Scene,
        size: [u32; 2],
        offset: DVec2,
        linear: bool,
    ) -> &Frame {
        let began = self.now();
        let before = self.extent();
        self.mesh(scene);
        self.give_back_unused(before, size);
        let planned = self.plan_frame(scene, size, offset, linear);
        self.place(&planned);
        let has_points = self.points(&planned);
        // Coverage and interpolation wait for the rays or the shading: a band goes through all at once.
        self.cover(&planned);
        if has_points {
            self.interpolate(&planned);
            self.rays(&planned);
            if self.shade(&planned) {
                self.display(&planned);
            }
        } else {
            self.wait(&planned);
        }
        self.drawn = Some(planned);
        self.report.nanoseconds = self.since(began);
        &self.picture.output.frame
    }

    /// Makes the polygons, with their vertex normals, and the true surface, if that is shown.
    fn mesh(&mut self, scene: &Scene) {
        let began = self.now();
        self.report.begin();
        let object = &scene.object;
        let shows_model = object.kind == ObjectKind::Obj;
        let given = if shows_model { self.given.1 } else { 0 };
        let polygons = (object.kind == ObjectKind::Polygons).then(|| object.polygons());
        let mut ran = self.mesh.update(
            (object.kind, object.segments, object.rings, given, polygons),
            |mesh| {
                *mesh = if shows_model {
                    MeshSource {
                        mesh: self.given.0.clone().unwrap_or_default().into(),
                        shape: None,
                    }
                } else {
                    MeshSource {
                        shape: Some(object.clone()),
                        ..MeshSource::default()
                    }
                };
            },
        );
        let normals = Plan::normals(scene);
        let weighting = if object.averages(normals) {
            object.weighting
        } else {
            Weighting::Equal
        };
        let own = scene.material.source == MaterialSource::Model;
        ran |= self
            .model
            .update((self.mesh.stamp, normals, weighting, own), |model| {
                let mesh = self.mesh.output.mesh();
                let mut vertices = mesh.with_vertex_normals(normals, weighting);
                if !own {
                    vertices.drop_materials();
                }
                *model = Model::new(vertices);
                self.mesh.output.release();
            });
        if Plan::shows_surface(scene) {
            let shape = Object {
                path: None,
                ..object.clone()
            };
            ran |= self
                .surface
                .update(shape, |surface| *surface = Surface::of(object));
        } else if ran {
            self.surface.release();
        }
        self.note(Stage::Geometry, ran, began, 0);
        let (model, report) = (&self.model.output, &mut self.report);
        report.triangles = model.triangles.len() as u64;
        report.faces = model.face_count() as u64;
        report.vertices = model.vertex_count as u64;
    }

    /// Plans the frame: the points where the equation is evaluated, and the work left out.
    fn plan_frame(
        &mut self,
        scene: &Scene,
        size: [u32; 2],
        offset: DVec2,
        linear: bool,
    ) -> PlannedFrame {
        let mut plan = Plan::for_scene(scene, &self.model.output);
        if self.leaves_nothing_out {
            plan.leave_nothing_out(scene);
        }
        plan.whole_picture |= self.keeps_linear || linear;
        plan.coarser = self.coarser.max(1);
        if !(plan.shadows || plan.composes) {
            self.report.stages.retain(|run| run.stage != Stage::Rays);
        }
        let lens = Lens::new(
            &scene.camera,
            size,
            offset,
            self.model.output.unit(&scene.camera),
        );
        let materials = self.model.output.face_materials.materials(scene);
        let equations = for_each_material(scene, &materials, |scene| {
            let mut equation = Equation::<f32>::in_units(scene, lens.unit);
            equation.retain_lights(|light| plan.lights[light]);
            if plan.leaves_out {
                equation.leave_out_faint();
            } else {
                equation.leave_nothing_out(scene);
            }
            equation
        });
        PlannedFrame {
            scene: scene.clone(),
            plan,
            lens,
            materials,
            parts: Part::all(scene, &equations),
        }
    }

    /// Places the triangles in the picture, clipped and sorted into bands of rows.
    fn place(&mut self, planned: &PlannedFrame) {
        let began = self.now();
        if planned.plan.true_surface {
            (self.report.candidates, self.report.clipped) = (0, 0);
            return;
        }
        let (size, cull) = (planned.scene.image.size, planned.plan.cull);
        let key = (self.model.stamp, planned.lens, size, cull);
        let (level, model) = (self.level(), &self.model.output);
        let ran = self.placed.update(key, |placed| {
            placed.run(level, &planned.lens, model, size, cull);
        });
        let placed = &self.placed.output;
        self.report.candidates = placed.candidates;
        self.report.clipped = placed.clipped.triangles.len() as u64;
        self.note(Stage::Transform, ran, began, 0);
    }

    /// Covers the picture, and leaves the rest to the next call: not all points are shaded.
    fn wait(&mut self, planned: &PlannedFrame) {
        if self.stale.coverage {
            self.paint(planned, false);
        }
        self.picture.forget();
        let (picture, size) = (&mut self.picture.output, planned.scene.image.size);
        picture.begin(size);
        picture.canvas(size, planned.plan.whole_picture);
    }

    /// Finds the triangle that each pixel shows.
    fn cover(
        &mut self,
        PlannedFrame {
            scene, plan, lens, ..
        }: &PlannedFrame,
    ) {
        let source = if plan.true_surface {
            self.surface.stamp
        } else {
            self.placed.stamp
        };
        // Rays to the true surface depend on the lens; placed triangles already include it.
        let lens = plan.true_surface.then_some(*lens);
        self.stale.coverage = self
            .bands
            .outdate((scene.image.size, source, lens, plan.depth_test));
        // Coverage of another object or view that this one does not need.
        if self.stale.coverage {
            self.rays.release_unused(scene, plan);
            if plan.per == Per::Pixel {
                self.points.release();
            }
            if plan.per != Per::Face {
                self.faces.release();
            }
            if !plan.cues_pixels() {
                self.cue.release();
            }
        }
    }

    /// Interpolates the carried values at each pixel.
    fn interpolate(&mut self, PlannedFrame { scene, plan, .. }: &PlannedFrame) {
        let source = match plan.per {
            _ if plan.true_surface => 0,
            Per::Pixel => self.model.stamp,
            _ => self.points.stamp,
        };
        let rule = (plan.interpolates(), plan.perspective, plan.scanline);
        let flat_at = (!plan.carries).then_some(scene.shading.flat_at);
        self.stale.interpolation =
            self.interpolated
                .outdate((self.bands.stamp, source, plan.per, rule, flat_at));
    }

    /// Follows the rays that start from the points shown.
    fn rays(&mut self, planned: &PlannedFrame) {
        if !planned.plan.follows_rays() {
            return;
        }
        if self.stale.interpolation {
            self.paint(planned, false);
        }
        let began = self.now();
        let object = if planned.plan.true_surface {
            self.surface.stamp
        } else {
            self.model.stamp
        };
        let mut rays = take(&mut self.rays);
        let ran = rays.follow(
            &self.inputs(planned),
            self.coverage(&planned.scene),
            &planned.parts,
            [object, self.bands.stamp],
        );
        self.rays = rays;
        self.note(Stage::Rays, ran, began, 0);
    }

    /// Evaluates the equation at pixels, or takes the colours carried to them, with s0 where pixels fade. Returns whether
    /// that has changed the picture and finished it.
    fn shade(&mut self, planned: &PlannedFrame) -> bool {
        let PlannedFrame {
            scene,
            plan,
            lens,
            parts,
            materials,
        } = planned;
        let flat_at = (!plan.carries).then_some(scene.shading.flat_at);
        let cue = plan.cues_pixels().then(|| {
            let rule = (
                plan.perspective,
                plan.scanline,
                plan.keeps_fragments(),
                flat_at,
            );
            (
                scene.depth_cueing,
                plan.cued,
                *lens,
                scene.image.size,
                self.model.stamp,
                self.bands.stamp,
                rule,
            )
        });
        let begins = self.picture.outdate((
            self.interpolated.stamp,
            (plan.per == Per::Pixel).then(|| parts.clone()),
            scene.image.background.to_array(),
            scene.display.clone(),
            plan.whole_picture,
            plan.renormalise,
            plan.double,
            // Shadow bits are kept while shadows are off.
            plan.shadows,
            plan.follows_rays().then(|| self.rays.stamps()),
            // The way in which the view beyond is mixed in.
            plan.composes
                .then(|| (kts(materials), scene.ambient.source)),
            cue,
        ));
        if begins {
            self.picture.output.begin(scene.image.size);
        }
        let shaded = self.picture.output.is_pending();
        if shaded {
            self.paint(planned, true);
        }
        if let Some(key) = cue {
            let began = self.now();
            let mut cue = take(&mut self.cue);
            let run = |layer: &mut CueLayer| {
                layer.run(
                    &self.inputs(planned),
                    self.coverage(scene),
                    &self.faces.output[0],
                );
            };
            let ran = cue.update(key, run);
            self.cue = cue;
            self.note(Stage::Interpolation, ran, began, 0);
        }
        shaded && !self.picture.output.is_pending()
    }

    /// Runs the steps that need the whole picture: composing, fading, and the display's policy.
    fn display(&mut self, planned: &PlannedFrame) {
        let (began, level) = (self.now(), self.level());
        let PlannedFrame { scene, plan, .. } = planned;
        let each_kt = if plan.composes {
            self.transparencies(planned)
        } else {
            vec![]
        };
        let kt = (planned.materials[0].kt, &each_kt[..]);
        let report = &mut self.report;
        let fit = self
            .rays
            .fit()
            .filter(|_| scene.ambient.source != AmbientSource::Constant);
        report.ambient_fit = fit.map(|fit| fit.to_array());
        let Picture { frame, linear, .. } = &mut self.picture.output;
        let layer = &self.cue.output;
        if plan.composes {
            let faded = (plan.cued == Cued::AtPoints).then_some(&*layer.scales);
            report.overflowing = compose(scene, kt, self.rays.layers(scene), faded, linear);
        }
        if matches!(plan.cued, Cued::AtVertices | Cued::AtPixels) {
            report.overflowing = fade_pixels(
                layer,
                scene.depth_cueing.color.as_vec3(),
                plan.composes,
                linear,
            );
        }
        report.divisor = 1.0;
        if plan.whole_picture {
            let width = frame.width as usize;
            report.divisor = display(level, linear, width, &scene.display, &mut frame.pixels);
        }
        self.note(Stage::Display, true, began, 0);
    }

    /// Takes every band through the steps that are out of date, and through shading if the frame is to be shaded.
    fn paint(&mut self, planned: &PlannedFrame, shades: bool) {
        let (plan, stale) = (&planned.plan, take(&mut self.stale));
        let mut bands = take(&mut self.bands);
        let mut interpolated = take(&mut self.interpolated);
        let mut picture = take(&mut self.picture);
        let painter = BandPainter {
            inputs: self.inputs(planned),
            clock: self.clock,
            parts: &planned.parts,
            placed: &self.placed.output,
            intensity: &self.points.output,
            stale,
            shades,
            deadline: self.deadline(),
        };
        let canvas = if shades {
            picture
                .output
                .canvas(planned.scene.image.size, plan.whole_picture)
        } else {
            Canvas::default()
        };
        let interpolates = painter.interpolates();
        let tally = painter.run(&mut bands.output, &mut interpolated.output, canvas);
        (self.bands, self.interpolated, self.picture) = (bands, interpolated, picture);
        let [covering, interpolating, shading, overflowing] = tally;
        let (bands, report) = (&self.bands.output, &mut self.report);
        report.covered = bands.iter().map(|band| band.covered).sum();
        report.drawn = bands.iter().map(|band| band.drawn).sum();
        if stale.coverage {
            report.ran(Stage::Coverage, covering, 0);
        }
        if interpolates {
            report.ran(Stage::Interpolation, interpolating, 0);
        }
        if shades {
            let before = &mut self.picture.output.tally;
            *before = [before[0] + shading, before[1] + overflowing];
            let [shading, overflowing] = *before;
            report.overflowing = overflowing;
            let at_pixels = plan.per == Per::Pixel;
            let (stage, evaluations) = if at_pixels {
                (Stage::PixelShading, report.covered)
            } else {
                (Stage::Display, 0)
            };
            report.ran(stage, shading, evaluations);
        }
    }

    /// Returns the time of the clock from which on no further rows or points are begun.
    fn deadline(&self) -> u64 {
        let time = self.shading_time;
        time.map_or(u64::MAX, |time| self.now().saturating_add(time))
    }

    fn note(&mut self, stage: Stage, ran: bool, began: u64, evaluations: u64) {
        if ran {
            self.report.ran(stage, self.since(began), evaluations);
        }
    }

    fn now(&self) -> u64 {
        self.clock.map_or(0, |clock| clock())
    }

    fn since(&self, began: u64) -> u64 {
        self.now().saturating_sub(began)
    }

    pub(super) fn level(&self) -> Level {
        self.level.unwrap_or_else(Level::new)
    }

    pub(super) fn inputs<'a>(&'a self, planned: &'a PlannedFrame) -> Inputs<'a> {
        Inputs {
            level: self.level(),
            scene: &planned.scene,
            plan: &planned.plan,
            lens: &planned.lens,
            materials: &planned.materials,
            triangles: self.placed.output.triangles(&self.model.output),
            surface: self.surface.output.as_ref(),
            visibility: self.rays.visibility(&planned.plan),
        }
    }

    /// Returns the triangle of each pixel of a picture, once it is covered.
    pub(super) fn coverage(&self, scene: &Scene) -> Coverage<'_> {
        Coverage {
            size: scene.image.size,
            bands: &self.bands.output,
            fragments: &self.interpolated.output.fragments,
        }
    }

    /// Returns the polygons of the last picture, before they were given vertex normals; shared, so that they can be kept
    /// and recognised.
    pub(crate) fn mesh_shown(&self) -> &Arc<Mesh> {
        self.mesh.output.mesh()
    }

    /// Returns the report of the last call of [`Renderer::render`].
    pub fn report(&self) -> &FrameReport {
        &self.report
    }
}

/// Returns Kt of each material.
fn kts(materials: &[FaceMaterial]) -> Vec<f64> {
    materials.iter().map(|own| own.kt).collect()
}
