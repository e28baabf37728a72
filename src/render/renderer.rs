//! The renderer: runs the plan's stages, each only when what it reads has changed.

mod held;
mod inputs;
mod intensities;
mod samples;

pub use self::samples::{TooLarge, check_memory};

use self::inputs::{CanvasInputs, IntensityInputs, MeshInputs, ModelInputs, PlacedInputs};
use super::account::{Account, Term};
use super::beyond::compose;
use super::bins::Bins;
use super::clip::Clipped;
use super::cue::{Cue, Found, Layer, LayerInputs, fade_pixels};
use super::display::{Linear, display};
use super::interpolate::Sources;
use super::lens::Lens;
use super::mesh_source::MeshSource;
use super::model::Model;
use super::painting::{Bands, Canvas, CoverageInputs, InterpolationInputs, Painted, Painting, Stale};
use super::plan::{Cued, Facts, Per, Plan};
use super::points::Planes;
use super::rays::{RayInputs, RayStages, SeenAt};
use super::reference::{Evaluation, Reference};
use super::stage::Kept;
use super::transform::{Placed, UNPLACED};
use super::transmission::Transmission;
use super::{Frame, Report, Stage, StageRun};
use crate::geometry::{Mesh, Surface};
use crate::illumination::Equation;
use crate::scene::{AmbientSource, NormalSource, Object, ObjectKind, Rgb, Scene, Weighting};
use fearless_simd::Level;
use glam::DVec2;
use std::sync::Arc;

/// Draws scenes, keeping each stage's output for the next call.
pub struct Renderer {
    level: Level,
    clock: fn() -> u64,
    given: Option<Arc<Mesh>>,
    given_stamp: u64,
    mesh: Kept<MeshInputs, MeshSource>,
    model: Kept<ModelInputs, Model>,
    faces: Kept<u64, (Planes, Planes)>,
    surface: Kept<Object, Option<Surface>>,
    placed: Kept<PlacedInputs, (Placed, Clipped, Bins)>,
    intensity: Kept<IntensityInputs, Planes>,
    bands: Bands,
    rays: RayStages,
    /// Whether rays to vertices or faces were followed for this frame, and for how long.
    traced: (bool, u64),
    cue: Kept<LayerInputs, Layer>,
    canvas: Kept<CanvasInputs, ()>,
    drawn: Option<Drawn>,
    linear: Vec<Linear>,
    /// Whether the picture before the display is asked for.
    keeps_linear: bool,
    leaves_nothing_out: bool,
    frame: Frame,
    report: Report,
}

/// What is mixed into the equation's value at a pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mixture {
    /// Where light passes through the surface.
    pub transmission: Option<Transmission>,
    /// What light from other surfaces has in excess of the constant ambient term that it takes the place of.
    pub bounced: Option<Rgb>,
}

/// What the last picture was drawn from.
struct Drawn {
    scene: Scene,
    plan: Plan,
    lens: Lens,
    facts: Facts,
}

impl Default for Renderer {
    fn default() -> Self {
        Self::with_clock(|| 0)
    }
}

impl Renderer {
    /// A renderer that measures its stages by `clock`, which gives nanoseconds from any fixed moment.
    pub fn with_clock(clock: fn() -> u64) -> Self {
        Self {
            level: Level::new(),
            clock,
            given: None,
            given_stamp: 0,
            mesh: Kept::default(),
            model: Kept::default(),
            faces: Kept::default(),
            surface: Kept::default(),
            placed: Kept::default(),
            intensity: Kept::default(),
            bands: Bands::default(),
            rays: RayStages::default(),
            traced: (false, 0),
            cue: Kept::default(),
            canvas: Kept::default(),
            drawn: None,
            linear: Vec::new(),
            keeps_linear: false,
            leaves_nothing_out: false,
            frame: Frame::default(),
            report: Report::default(),
        }
    }

    /// The same renderer on another SIMD level than the machine's best.
    #[must_use]
    pub fn with_level(mut self, level: Level) -> Self {
        self.level = level;
        self
    }

    /// The mesh that an object of kind `obj` shows; none shows nothing. Another `Arc` is another model.
    pub fn set_model(&mut self, model: Option<Arc<Mesh>>) {
        let same = match (&self.given, &model) {
            (Some(old), Some(new)) => Arc::ptr_eq(old, new),
            (None, None) => true,
            _ => false,
        };
        if !same {
            self.given = model;
            self.given_stamp += 1;
        }
    }

    /// Forgets every stage's output, so that the next picture is drawn from nothing. Buffers are kept.
    pub fn invalidate(&mut self) {
        self.mesh.forget();
        self.model.forget();
        self.faces.forget();
        self.surface.forget();
        self.redraw();
    }

    /// Forgets every output but the geometry's: the next picture is transformed, covered and shaded anew.
    pub fn redraw(&mut self) {
        self.placed.forget();
        self.intensity.forget();
        self.bands.forget();
        self.rays.forget();
        self.cue.forget();
        self.canvas.forget();
    }

    /// Draws a scene that [`Scene::validate`] accepts. What has not changed since the last call is not done again.
    pub fn render(&mut self, scene: &Scene) -> &Frame {
        let began = (self.clock)();
        self.report.stages.clear();
        let plan = self.plan_of(scene);
        self.draw(scene, plan, scene.image.size, DVec2::ZERO);
        self.report.nanoseconds = (self.clock)().saturating_sub(began);
        &self.frame
    }

    /// The last picture.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// What the last call of [`Renderer::render`] did.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// The plan of the last picture.
    pub fn plan(&self) -> Option<&Plan> {
        self.drawn.as_ref().map(|drawn| &drawn.plan)
    }

    /// The equation of `scene`, whose picture is the last one, in double precision.
    pub(crate) fn equation(&self, scene: &Scene) -> Equation<f64> {
        Equation::in_units(scene, self.facts().unit(&scene.camera))
    }

    /// The same with the lights that the picture is shaded with.
    pub(crate) fn shining_equation(&self, scene: &Scene) -> Equation<f64> {
        let mut equation = self.equation(scene);
        if let Some(plan) = self.plan() {
            equation.retain_lights(|light| plan.lights[light]);
        }
        equation
    }

    /// Where the equation is evaluated for a pixel of the last picture; nothing where the background is seen.
    pub(crate) fn evaluation(&self, x: u32, y: u32) -> Option<Evaluation<'_>> {
        let reference = self.reference()?;
        let place = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        if reference.plan.true_surface {
            reference.of_surface(place)
        } else {
            Some(reference.of_triangle(self.bands.triangle_at(x, y)?, place))
        }
    }

    /// Where the equation is evaluated for any place of the last picture, on the polygon that its pixel sees.
    pub(crate) fn evaluation_seen(&self, place: DVec2) -> Option<Evaluation<'_>> {
        let reference = self.reference()?;
        if reference.plan.true_surface {
            return reference.of_surface(place);
        }
        Some(reference.of_triangle(self.bands.triangle_at(place.x as u32, place.y as u32)?, place))
    }

    /// The model's triangle that a pixel of the last picture sees.
    pub(crate) fn triangle_at(&self, [x, y]: [u32; 2]) -> Option<u32> {
        let triangle = self.bands.triangle_at(x, y)?;
        let piece = (triangle as usize).checked_sub(self.model.output.triangles.len());
        Some(piece.map_or(triangle, |piece| self.placed.output.1.parents[piece]))
    }

    /// I where `triangle` is seen at `place` in the picture of `scene`, which casts no shadows and has the last picture's
    /// model: only its vertices are placed anew. Nothing where the triangle would have to be clipped.
    pub(crate) fn intensity_turned(
        &self,
        scene: &Scene,
        equation: &Equation<f64>,
        triangle: u32,
        place: DVec2,
    ) -> Option<Rgb> {
        let (facts, model, size) = (self.facts(), &self.model.output, scene.image.size);
        let plan = Plan::of(scene, &facts);
        let lens = Lens::new(&scene.camera, size, DVec2::ZERO, facts.unit(&scene.camera));
        let (mut placed, clipped) = (Placed::default(), Clipped::default());
        placed.run(self.level, &lens, model, size[1]);
        let sources = Sources { model, clipped: &clipped, placed: &placed, carried: &[] };
        let whole = sources.vertices(triangle).iter().all(|v| placed.places[*v as usize][0] != UNPLACED);
        let drawn = Reference { scene, plan: &plan, lens: &lens, sources, surface: None, reach: None, cue: None };
        whole.then(|| drawn.of_triangle(triangle, place).intensity(equation))
    }

    /// The polygons of the last picture, before they were given vertex normals.
    pub(crate) fn mesh(&self) -> &Mesh {
        self.shared_mesh()
    }

    /// The same, shared: to be kept, and to be known again.
    pub(crate) fn shared_mesh(&self) -> &Arc<Mesh> {
        self.mesh.output.mesh()
    }

    /// Draws `scene`, which is exact, and says whether the picture shows a surface beyond its polygons.
    pub(crate) fn shows_surface(&mut self, scene: &Scene) -> bool {
        self.render(scene);
        self.drawn.as_ref().is_some_and(|drawn| drawn.plan.true_surface)
    }

    /// What evaluations of the last picture read.
    pub(super) fn reference(&self) -> Option<Reference<'_>> {
        let drawn = self.drawn.as_ref()?;
        let (placed, clipped, _) = &self.placed.output;
        Some(Reference {
            scene: &drawn.scene,
            plan: &drawn.plan,
            lens: &drawn.lens,
            sources: Sources { model: &self.model.output, clipped, placed, carried: &[] },
            surface: self.surface.output.as_ref(),
            reach: self.rays.reach(&drawn.plan),
            cue: Cue::of(&drawn.scene, &drawn.plan, &drawn.lens),
        })
    }

    /// The triangles of the last picture where they lie in it.
    pub(super) fn placed_triangles(&self) -> Option<(Sources<'_>, &Plan)> {
        let (placed, clipped, _) = &self.placed.output;
        let plan = &self.drawn.as_ref()?.plan;
        Some((Sources { model: &self.model.output, clipped, placed, carried: &[] }, plan))
    }

    /// Draws a scene as far as the display, which is given the whole picture.
    pub(super) fn draw_linear(&mut self, scene: &Scene) -> Vec<Linear> {
        let mut plan = self.plan_of(scene);
        plan.whole_picture = true;
        self.report.stages.clear();
        self.draw(scene, plan, scene.image.size, DVec2::ZERO);
        self.linear.clone()
    }

    /// What is mixed into the equation's value at a pixel of the last picture that shows the object.
    pub(crate) fn mixture(&self, x: u32, y: u32) -> Option<Mixture> {
        let Drawn { scene, plan, lens, .. } = self.drawn.as_ref()?;
        if !plan.composes {
            return None;
        }
        let (placed, clipped, _) = &self.placed.output;
        let sources = Sources { model: &self.model.output, clipped, placed, carried: &[] };
        let surface = self.surface.output.as_ref();
        let inputs = RayInputs { level: self.level, scene, plan, lens, sources, surface, object: 0 };
        let seen = if plan.true_surface {
            SeenAt::Surface(self.bands.fragment_at(x, y)?)
        } else {
            SeenAt::Triangle(self.bands.triangle_at(x, y)?)
        };
        let transmission = (scene.transparency.kt > 0.0).then(|| self.rays.transmission_at(&inputs, [x, y], seen));
        Some(Mixture { transmission, bounced: self.rays.bounced_at(scene, x, y) })
    }

    /// Has the picture before the display kept from the next call on, for [`Renderer::linear`].
    pub fn keep_linear(&mut self, keep: bool) {
        self.keeps_linear = keep;
    }

    /// Has everything evaluated from the next call on that the plan leaves out and that can be kept in: lights and terms that
    /// add nothing, an f of 1, back faces, the depth test, rays to lights that nothing hides. The stored pixels are the same:
    /// this is for tests, and for measuring the work that is saved.
    pub fn leave_nothing_out(&mut self, nothing: bool) {
        if self.leaves_nothing_out != nothing {
            self.leaves_nothing_out = nothing;
            self.redraw();
        }
    }

    /// The terms and steps of the last picture: how often each is evaluated, or why it is left out.
    pub fn terms(&self) -> Vec<Term> {
        self.drawn.as_ref().map_or_else(Vec::new, |Drawn { scene, plan, facts, .. }| {
            let (placed, clipped, bins) = &self.placed.output;
            let sources = Sources { model: &self.model.output, clipped, placed, carried: &[] };
            let culled = plan.cull || plan.true_surface;
            let backs = if culled { 0 } else { bins.backs(|index| placed.corners(sources.vertices(index))) };
            let inks = if plan.carries { 0 } else { self.bands.ink_count() };
            Account { scene, plan, facts, report: &self.report, backs, inks }.terms()
        })
    }

    /// The last picture before the display, row by row: linear red, green, blue, and the part of the pixel that shows the
    /// object. Empty unless [`Renderer::keep_linear`] asked for it or the display needed all of it.
    pub fn linear(&self) -> &[[f32; 4]] {
        &self.linear
    }

    /// Runs the geometry stages and plans the rest.
    fn plan_of(&mut self, scene: &Scene) -> Plan {
        let began = (self.clock)();
        let object = &scene.object;
        let given = if object.kind == ObjectKind::Obj { self.given_stamp } else { 0 };
        let source = self.given.clone();
        let polygons = (object.kind == ObjectKind::Polygons).then(|| object.polygons());
        let inputs = MeshInputs { kind: object.kind, segments: object.segments, rings: object.rings, given, polygons };
        let mut ran = self.mesh.update(inputs, |_, mesh| {
            *mesh = match object.kind {
                ObjectKind::Obj => MeshSource::of_model(source.unwrap_or_default()),
                _ => MeshSource::of_shape(object.clone()),
            };
        });
        let preview = Plan::of(scene, &Facts::default());
        let weighting = if preview.normals == NormalSource::Averaged || preview.normals == NormalSource::File {
            object.weighting
        } else {
            Weighting::Equal
        };
        let inputs = ModelInputs { mesh: self.mesh.stamp(), normals: preview.normals, weighting };
        let source = &mut self.mesh.output;
        ran |= self.model.update(inputs, |inputs, model| {
            *model = Model::new(source.mesh().with_vertex_normals(inputs.normals, inputs.weighting));
            source.release();
        });
        if preview.true_surface {
            let key = Object { path: None, ..object.clone() };
            ran |= self.surface.update(key, |object, surface| *surface = Surface::of(object));
        }
        self.note(Stage::Geometry, ran, began, 0);
        let model = &self.model.output;
        self.report.triangles = model.triangles.len() as u64;
        self.report.faces = model.face_count() as u64;
        self.report.vertices = model.vertex_count as u64;
        let mut plan = Plan::of(scene, &self.facts());
        if self.leaves_nothing_out {
            plan.leave_nothing_out(scene);
        }
        plan.whole_picture |= self.keeps_linear;
        plan
    }

    fn facts(&self) -> Facts {
        let model = &self.model.output;
        Facts { closed: model.closed, convex: model.convex, centre: model.origin, radius: model.radius }
    }

    /// Runs the stages from the transform on.
    ///
    /// The picture's samples lie `offset` pixels from the centres of a picture of `size` pixels, of which it may be a part.
    fn draw(&mut self, scene: &Scene, plan: Plan, size: [u32; 2], offset: DVec2) {
        let lens = Lens::new(&scene.camera, size, offset, self.facts().unit(&scene.camera));
        let mut equation = Equation::<f32>::in_units(scene, lens.unit);
        equation.retain_lights(|light| plan.lights[light]);
        if plan.leaves_out {
            equation.leave_out_faint();
        } else {
            equation.leave_nothing_out(scene);
        }
        self.place(&plan, &lens, scene.image.size);
        self.shade_points(scene, &plan, &lens, &equation);
        self.paint(scene, &plan, &lens, equation);
        let facts = self.facts();
        self.drawn = Some(Drawn { scene: scene.clone(), plan, lens, facts });
    }

    fn place(&mut self, plan: &Plan, lens: &Lens, size: [u32; 2]) {
        let began = (self.clock)();
        let mut ran = false;
        if !plan.true_surface {
            let inputs = PlacedInputs { model: self.model.stamp(), lens: *lens, size, cull: plan.cull };
            let model = &self.model.output;
            let level = self.level;
            ran = self.placed.update(inputs, |inputs, (placed, clipped, bins)| {
                placed.run(level, &inputs.lens, model, size[1]);
                bins.run(model, &inputs.lens, size, inputs.cull, placed, clipped);
            });
        }
        if plan.true_surface {
            (self.report.candidates, self.report.clipped) = (0, 0);
        } else {
            let (_, clipped, bins) = &self.placed.output;
            self.report.candidates = bins.candidates;
            self.report.clipped = clipped.triangles.len() as u64;
        }
        self.note(Stage::Transform, ran, began, 0);
    }

    /// Coverage, interpolation, shading and display, band by band.
    fn paint(&mut self, scene: &Scene, plan: &Plan, lens: &Lens, equation: Equation<f32>) {
        self.fit_frame(scene.image.size);
        let stale = self.stale(scene, plan, lens);
        let pixels = self.frame.pixels.len();
        let linear = if plan.whole_picture { pixels } else { 0 };
        let (placed, clipped, bins) = &self.placed.output;
        let sources = Sources { model: &self.model.output, clipped, placed, carried: &[] };
        let mut painting = Painting {
            level: self.level,
            clock: self.clock,
            scene,
            plan,
            lens,
            equation: &equation,
            surface: self.surface.output.as_ref(),
            sources,
            bins,
            intensity: &self.intensity.output,
            reach: None,
            colours: true,
        };
        let mut painted = Painted::default();
        let mut still_stale = stale;
        if plan.follows_rays() {
            // Rays start from what the pixels see, so that is found first.
            if stale.any() {
                fit_linear(&mut self.linear, linear);
                let canvas = Canvas { pixels: &mut self.frame.pixels, linear: &mut self.linear };
                painted = Painting { colours: false, ..painting }.run(&mut self.bands, stale, canvas);
                still_stale = Stale::NOTHING;
            }
            let began = (self.clock)();
            let object = if plan.true_surface { self.surface.stamp() } else { self.model.stamp() };
            let inputs = RayInputs { level: self.level, scene, plan, lens, sources, surface: painting.surface, object };
            if self.rays.follow(&inputs, &self.bands) {
                self.traced = (true, self.traced.1 + (self.clock)().saturating_sub(began));
            }
            painting.reach = self.rays.reach(plan).filter(|_| plan.per == Per::Pixel);
        }
        let cue = self.layer_inputs(scene, plan, lens);
        let inputs = CanvasInputs {
            cue: cue.clone(),
            ..CanvasInputs::new(scene, plan, &equation, (self.bands.stamp(), self.rays.stamps()))
        };
        let repaint = self.canvas.update(inputs, |_, ()| {});
        let shaded = repaint || stale.any();
        if shaded {
            fit_linear(&mut self.linear, linear);
            let canvas = Canvas { pixels: &mut self.frame.pixels, linear: &mut self.linear };
            painted = painted.and(painting.run(&mut self.bands, still_stale, canvas));
            (self.report.covered, self.report.drawn) = (painted.covered, painted.drawn);
            self.report.overflowing = painted.overflowing;
        }
        painted = painted.and_cued(self.cue_pixels(cue));
        let whole = if shaded { self.compose_and_display(scene, plan) } else { 0 };
        let fit = self.rays.fit().filter(|_| scene.ambient.source != AmbientSource::Constant);
        self.report.ambient_fit = fit.map(|fit| fit.to_array());
        self.account(plan, stale, shaded, painted, whole);
    }

    /// What s0 at the pixels is made from, where it is wanted.
    fn layer_inputs(&self, scene: &Scene, plan: &Plan, lens: &Lens) -> Option<LayerInputs> {
        let cue = Cue::of(scene, plan, lens).filter(|_| plan.cues_pixels())?;
        Some(LayerInputs {
            cue,
            cued: plan.cued,
            lens: *lens,
            size: scene.image.size,
            model: self.model.stamp(),
            coverage: self.bands.coverage_stamp(),
            perspective: plan.perspective,
            scanline: plan.scanline,
            keeps_fragments: plan.keeps_fragments(),
            flat_at: (!plan.carries).then_some(scene.shading.flat_at),
        })
    }

    /// Finds s0 at the pixels, where it is wanted. Returns whether it had to be, and the time it took.
    fn cue_pixels(&mut self, inputs: Option<LayerInputs>) -> (bool, u64) {
        let Some(inputs) = inputs else { return (false, 0) };
        let began = (self.clock)();
        let (placed, clipped, _) = &self.placed.output;
        let found = Found {
            level: self.level,
            bands: &self.bands,
            sources: Sources { model: &self.model.output, clipped, placed, carried: &[] },
            middles: &self.faces.output.0,
        };
        let ran = self.cue.update(inputs, |inputs, layer| layer.run(inputs, &found));
        (ran, if ran { (self.clock)().saturating_sub(began) } else { 0 })
    }

    /// Gives the frame its size; one of another size is drawn anew.
    fn fit_frame(&mut self, [width, height]: [u32; 2]) {
        let pixels = width as usize * height as usize;
        self.frame.width = width;
        self.frame.height = height;
        if self.frame.pixels.len() != pixels {
            self.frame.pixels.clear();
            self.frame.pixels.resize(pixels, [0; 4]);
            self.canvas.forget();
        }
    }

    /// Which of the bands' stages have to run again.
    fn stale(&mut self, scene: &Scene, plan: &Plan, lens: &Lens) -> Stale {
        let coverage = CoverageInputs {
            size: scene.image.size,
            source: if plan.true_surface { self.surface.stamp() } else { self.placed.stamp() },
            lens: plan.true_surface.then_some(*lens),
            depth_test: plan.depth_test,
        };
        let carried = if plan.per == Per::Pixel { self.model.stamp() } else { self.intensity.stamp() };
        let interpolation = InterpolationInputs {
            source: if plan.true_surface { 0 } else { carried },
            per: plan.per,
            carries: plan.interpolates(),
            perspective: plan.perspective,
            scanline: plan.scanline,
            flat_at: (!plan.carries).then_some(scene.shading.flat_at),
        };
        self.bands.stale(coverage, interpolation)
    }

    /// What needs to see the whole picture; returns the time it took.
    fn compose_and_display(&mut self, scene: &Scene, plan: &Plan) -> u64 {
        let began = (self.clock)();
        if plan.composes {
            let [seen, bounced] = self.rays.layers(scene);
            let faded = (plan.cued == Cued::AtPoints).then_some(&*self.cue.output.scales);
            self.report.overflowing = compose(scene, seen, bounced, faded, &mut self.linear);
        }
        if matches!(plan.cued, Cued::AtVertices | Cued::AtPixels) {
            let color = scene.depth_cueing.color.as_vec3();
            self.report.overflowing = fade_pixels(&self.cue.output, color, plan.composes, &mut self.linear);
        }
        if plan.whole_picture {
            let width = self.frame.width as usize;
            self.report.divisor = display(self.level, &self.linear, width, &scene.display, &mut self.frame.pixels);
        } else {
            self.report.divisor = 1.0;
        }
        (self.clock)().saturating_sub(began)
    }

    /// Accounts for the stages from the rays on.
    fn account(&mut self, plan: &Plan, stale: Stale, shaded: bool, painted: Painted, whole: u64) {
        let at_pixels = plan.per == Per::Pixel;
        let [covering, interpolating, shading] = painted.nanoseconds;
        let (shading, displaying) = if at_pixels { (shading, 0) } else { (0, shading) };
        if plan.shadows || plan.composes {
            let (traced, tracing) = self.traced;
            self.push(Stage::Rays, traced, tracing, 0);
        }
        self.push(Stage::Coverage, stale.coverage, covering, 0);
        self.push(Stage::Interpolation, painted.carried, interpolating, 0);
        self.push(Stage::PixelShading, shaded && at_pixels, shading, painted.evaluations);
        self.push(Stage::Display, shaded, displaying + whole, 0);
    }

    fn note(&mut self, stage: Stage, ran: bool, began: u64, evaluations: u64) {
        let nanoseconds = if ran { (self.clock)().saturating_sub(began) } else { 0 };
        self.push(stage, ran, nanoseconds, evaluations);
    }

    fn push(&mut self, stage: Stage, ran: bool, nanoseconds: u64, evaluations: u64) {
        self.report.stages.push(StageRun { stage, ran, nanoseconds, evaluations });
    }
}

/// Gives the picture before the display its size; the room of one that is not wanted is let go.
fn fit_linear(buffer: &mut Vec<Linear>, pixels: usize) {
    if pixels == 0 {
        *buffer = Vec::new();
    }
    buffer.resize(pixels, [0.0; 4]);
}

/// Place of sample `index` of `count` relative to the pixel's centre: a lattice of rank 1 with the golden section.
fn sample_offset(index: u32, count: u32) -> DVec2 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let x = (f64::from(index) + 0.5) / f64::from(count);
    let y = (f64::from(index) * GOLDEN + 0.5).fract();
    DVec2::new(x - 0.5, y - 0.5)
}
