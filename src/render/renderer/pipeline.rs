//! The renderer: a picture in nine steps, each of which runs only when what it reads has changed.

use super::account::{Account, Term};
use super::bands::{BandPainter, Canvas, Interpolated, Stale};
use super::compose::compose;
use super::cue::{Cue, CueKey, CueLayer, Found, fade_pixels};
use super::display::{Linear, display};
use super::frame::{Frame, Report, Stage};
use super::keys::{CoverageKey, InterpolationKey, MeshKey, ModelKey, PictureKey, PlacedKey, PointsKey};
use super::mesh_source::MeshSource;
use super::plan::{Cued, Facts, Per, Plan};
use super::points::{PointShading, face_points};
use super::ray_nodes::{RayInputs, RayNodes};
use crate::geometry::{Mesh, Surface};
use crate::illumination::Equation;
use crate::render::lens::Lens;
use crate::render::memory::{Holds, Memory, room, room_of_planes};
use crate::render::model::{Model, Planes};
use crate::render::node::Node;
use crate::render::raster::{Band, Coverage, PlacedTriangles, Triangles};
use crate::scene::{AmbientSource, NormalSource, Object, ObjectKind, Scene, Weighting};
use fearless_simd::Level;
use glam::DVec2;
use std::sync::Arc;

/// Draws scenes, keeping each step's output for the next call.
pub struct Renderer {
    pub(super) level: Level,
    clock: fn() -> u64,
    /// What an object of kind `obj` shows, and how often that has changed.
    given: (Option<Arc<Mesh>>, u64),
    pub(super) mesh: Node<MeshKey, MeshSource>,
    pub(super) model: Node<ModelKey, Model>,
    pub(super) surface: Node<Object, Option<Surface>>,
    pub(super) placed: Node<PlacedKey, PlacedTriangles>,
    /// The middles and the normals of the faces, where these are shaded.
    faces: Node<u64, [Planes; 2]>,
    /// Intensities at vertices or faces.
    points: Node<PointsKey, Planes>,
    bands: Node<CoverageKey, Vec<Band>>,
    interpolated: Node<InterpolationKey, Interpolated>,
    pub(super) rays: RayNodes,
    cue: Node<CueKey, CueLayer>,
    pub(super) picture: Node<PictureKey, Picture>,
    /// Steps of the present frame that the bands have yet to go through.
    stale: Stale,
    /// Whether the present frame is shaded anew.
    shaded: bool,
    pub(super) keeps_linear: bool,
    leaves_nothing_out: bool,
    pub(super) drawn: Option<Drawn>,
    pub(super) report: Report,
}

#[derive(Default)]
pub(super) struct Picture {
    pub frame: Frame,
    /// Before the display; empty where nobody needs it.
    pub linear: Vec<Linear>,
}

/// What the last picture was drawn from.
pub(super) struct Drawn {
    pub scene: Scene,
    pub plan: Plan,
    pub lens: Lens,
}

/// Which samples a picture shows.
#[derive(Clone, Copy)]
pub(super) struct Samples {
    /// Pixels of the whole picture, of which what is drawn may be a part.
    pub size: [u32; 2],
    /// Where the samples lie relative to the centres of the whole picture's pixels.
    pub offset: DVec2,
    /// Whether the whole picture is kept before the display.
    pub linear: bool,
}

/// What the steps of a frame read.
struct Job<'a> {
    scene: &'a Scene,
    plan: Plan,
    lens: Lens,
    equation: Equation<f32>,
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
            given: (None, 0),
            mesh: Node::default(),
            model: Node::default(),
            surface: Node::default(),
            placed: Node::default(),
            faces: Node::default(),
            points: Node::default(),
            bands: Node::default(),
            interpolated: Node::default(),
            rays: RayNodes::default(),
            cue: Node::default(),
            picture: Node::default(),
            stale: Stale::default(),
            shaded: false,
            keeps_linear: false,
            leaves_nothing_out: false,
            drawn: None,
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
        let same = match (&self.given.0, &model) {
            (Some(old), Some(new)) => Arc::ptr_eq(old, new),
            (None, None) => true,
            _ => false,
        };
        if !same {
            self.given = (model, self.given.1 + 1);
        }
    }

    /// Forgets every output, so that the next picture is drawn from nothing. Buffers are kept.
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
        self.points.forget();
        self.bands.forget();
        self.interpolated.forget();
        self.rays.forget();
        self.cue.forget();
        self.picture.forget();
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

    /// Draws a scene that [`Scene::validate`] accepts. What has not changed since the last call is not done again.
    pub fn render(&mut self, scene: &Scene) -> &Frame {
        self.draw(scene, Samples { size: scene.image.size, offset: DVec2::ZERO, linear: false })
    }

    /// The same with other samples than those at the pixels' centres.
    pub(super) fn draw(&mut self, scene: &Scene, samples: Samples) -> &Frame {
        let began = (self.clock)();
        self.mesh(scene);
        let job = self.plan_frame(scene, samples);
        self.place(&job);
        self.points(&job);
        // Coverage and interpolation wait for the rays or the shading: a band goes through all at once.
        self.cover(&job);
        self.interpolate(&job);
        self.rays(&job);
        self.shade(&job);
        self.display(&job);
        self.drawn = Some(Drawn { scene: scene.clone(), plan: job.plan, lens: job.lens });
        self.report.nanoseconds = self.since(began);
        &self.picture.output.frame
    }

    /// The polygons, with their vertex normals; the true surface, if that is shown.
    fn mesh(&mut self, scene: &Scene) {
        let began = (self.clock)();
        self.report.begin();
        let object = &scene.object;
        let shows_model = object.kind == ObjectKind::Obj;
        let key = MeshKey {
            kind: object.kind,
            segments: object.segments,
            rings: object.rings,
            given: if shows_model { self.given.1 } else { 0 },
            polygons: (object.kind == ObjectKind::Polygons).then(|| object.polygons()),
        };
        let mut ran = self.mesh.update(key, |mesh| {
            *mesh = if shows_model {
                MeshSource::of_model(self.given.0.clone().unwrap_or_default())
            } else {
                MeshSource::of_shape(object.clone())
            };
        });
        let normals = Plan::normals(scene);
        let averages = matches!(normals, NormalSource::Averaged | NormalSource::File);
        let weighting = if averages { object.weighting } else { Weighting::Equal };
        let key = ModelKey { mesh: self.mesh.stamp(), normals, weighting };
        ran |= self.model.update(key, |model| {
            *model = Model::new(self.mesh.output.mesh().with_vertex_normals(normals, weighting));
            self.mesh.output.release();
        });
        if Plan::shows_surface(scene) {
            let key = Object { path: None, ..object.clone() };
            ran |= self.surface.update(key, |surface| *surface = Surface::of(object));
        }
        self.note(Stage::Geometry, ran, began, 0);
        let (model, report) = (&self.model.output, &mut self.report);
        report.triangles = model.triangles.len() as u64;
        report.faces = model.face_count() as u64;
        report.vertices = model.vertex_count as u64;
    }

    /// What is done where, and what is left out.
    fn plan_frame<'a>(&mut self, scene: &'a Scene, samples: Samples) -> Job<'a> {
        let facts = self.facts();
        let mut plan = Plan::for_scene(scene, &facts);
        if self.leaves_nothing_out {
            plan.leave_nothing_out(scene);
        }
        plan.whole_picture |= self.keeps_linear || samples.linear;
        if !(plan.shadows || plan.composes) {
            self.report.stages.retain(|run| run.stage != Stage::Rays);
        }
        let lens = Lens::new(&scene.camera, samples.size, samples.offset, facts.unit(&scene.camera));
        let mut equation = Equation::<f32>::in_units(scene, lens.unit);
        equation.retain_lights(|light| plan.lights[light]);
        if plan.leaves_out {
            equation.leave_out_faint();
        } else {
            equation.leave_nothing_out(scene);
        }
        Job { scene, plan, lens, equation }
    }

    /// The triangles to where they lie in the picture, clipped and sorted into bands of rows.
    fn place(&mut self, job: &Job<'_>) {
        let began = (self.clock)();
        if job.plan.true_surface {
            (self.report.candidates, self.report.clipped) = (0, 0);
            return;
        }
        let (size, cull) = (job.scene.image.size, job.plan.cull);
        let key = PlacedKey { model: self.model.stamp(), lens: job.lens, size, cull };
        let (level, model) = (self.level, &self.model.output);
        let ran = self.placed.update(key, |placed| placed.run(level, &job.lens, model, size, cull));
        let PlacedTriangles { clipped, bins, .. } = &self.placed.output;
        (self.report.candidates, self.report.clipped) = (bins.candidates, clipped.triangles.len() as u64);
        self.note(Stage::Transform, ran, began, 0);
    }

    /// The equation at vertices or faces, where the mode evaluates it there.
    fn points(&mut self, job: &Job<'_>) {
        let Job { scene, plan, lens, equation } = job;
        self.report.points = 0;
        if plan.per == Per::Pixel {
            return;
        }
        let at_faces = plan.per == Per::Face;
        let count = if at_faces { self.model.output.face_count() } else { self.model.output.vertex_count };
        if plan.shadows {
            let began = (self.clock)();
            let triangles = self.placed.output.triangles(&self.model.output);
            let object = self.model.stamp();
            let inputs = RayInputs { level: self.level, scene, plan, lens, triangles, surface: None, object };
            let ran = self.rays.shadow_points(&inputs, count);
            self.note(Stage::Rays, ran, began, 0);
        }
        let began = (self.clock)();
        let (level, model) = (self.level, &self.model.output);
        if at_faces {
            self.faces.update(self.model.stamp(), |faces| *faces = face_points(model));
        }
        let [centre, facing] = &self.faces.output;
        let (position, normal) = if at_faces { (centre, facing) } else { (&model.position, &model.normal) };
        let key = PointsKey {
            model: self.model.stamp(),
            equation: equation.clone(),
            per: plan.per,
            double: plan.double,
            visibility: plan.shadows.then(|| self.rays.stamps()[0]),
            cue: Cue::for_plan(scene, plan, lens).filter(|_| plan.cued == Cued::AtPoints),
        };
        let (cue, visibility) = (key.cue, self.rays.visibility(plan));
        let ran = self.points.update(key, |intensity| {
            let shading =
                PointShading { level, equation, lens, model, position, normal, intensity: &mut *intensity, visibility };
            if plan.double {
                let mut equation = Equation::<f64>::in_units(scene, lens.unit);
                equation.retain_lights(|light| plan.lights[light]);
                shading.run_in_double(&equation);
            } else {
                equation.form().dispatch(shading);
            }
            if let Some(cue) = cue {
                cue.fade_points(model.origin, position, intensity);
            }
        });
        self.report.points = count as u64;
        self.note(Stage::VertexShading, ran, began, count as u64);
    }

    /// Which triangle each pixel sees.
    fn cover(&mut self, Job { scene, plan, lens, .. }: &Job<'_>) {
        self.stale.coverage = self.bands.outdate(CoverageKey {
            size: scene.image.size,
            source: if plan.true_surface { self.surface.stamp() } else { self.placed.stamp() },
            lens: plan.true_surface.then_some(*lens),
            depth_test: plan.depth_test,
        });
    }

    /// What is carried to each pixel.
    fn interpolate(&mut self, Job { scene, plan, .. }: &Job<'_>) {
        let carried = if plan.per == Per::Pixel { self.model.stamp() } else { self.points.stamp() };
        self.stale.interpolation = self.interpolated.outdate(InterpolationKey {
            coverage: self.bands.stamp(),
            source: if plan.true_surface { 0 } else { carried },
            per: plan.per,
            carries: plan.interpolates(),
            perspective: plan.perspective,
            scanline: plan.scanline,
            flat_at: (!plan.carries).then_some(scene.shading.flat_at),
        });
    }

    /// Rays that start from what the pixels see.
    fn rays(&mut self, job: &Job<'_>) {
        let Job { scene, plan, lens, .. } = job;
        if !plan.follows_rays() {
            return;
        }
        if self.stale.interpolation {
            self.paint(job, false);
        }
        let began = (self.clock)();
        let object = if plan.true_surface { self.surface.stamp() } else { self.model.stamp() };
        let (triangles, surface) = (self.placed.output.triangles(&self.model.output), self.surface.output.as_ref());
        let inputs = RayInputs { level: self.level, scene, plan, lens, triangles, surface, object };
        let (bands, fragments) = (&*self.bands.output, &*self.interpolated.output.fragments);
        let coverage = Coverage { size: scene.image.size, bands, fragments };
        let ran = self.rays.follow(&inputs, coverage, self.bands.stamp());
        self.note(Stage::Rays, ran, began, 0);
    }

    /// The equation at pixels, or the colours that were carried to them; s0 at the pixels where intensities fade there.
    fn shade(&mut self, job: &Job<'_>) {
        let Job { scene, plan, lens, equation } = job;
        let cue = Cue::for_plan(scene, plan, lens).filter(|_| plan.cues_pixels()).map(|cue| CueKey {
            cue,
            cued: plan.cued,
            lens: *lens,
            size: scene.image.size,
            model: self.model.stamp(),
            coverage: self.bands.stamp(),
            perspective: plan.perspective,
            scanline: plan.scanline,
            keeps_fragments: plan.keeps_fragments(),
            flat_at: (!plan.carries).then_some(scene.shading.flat_at),
        });
        self.shaded = self.picture.outdate(PictureKey {
            interpolation: self.interpolated.stamp(),
            equation: (plan.per == Per::Pixel).then(|| equation.clone()),
            background: scene.image.background.to_array(),
            display: scene.display.clone(),
            whole_picture: plan.whole_picture,
            renormalise: plan.renormalise,
            double: plan.double,
            shadows: plan.shadows,
            rays: plan.follows_rays().then(|| self.rays.stamps()),
            composition: plan.composes.then_some((scene.transparency.kt, scene.ambient.source)),
            cue: cue.clone(),
        });
        if self.shaded {
            self.paint(job, true);
        }
        let Some(cue) = cue else { return };
        let began = (self.clock)();
        let (bands, fragments) = (&*self.bands.output, &*self.interpolated.output.fragments);
        let found = Found {
            level: self.level,
            coverage: Coverage { size: scene.image.size, bands, fragments },
            triangles: self.placed.output.triangles(&self.model.output),
            middles: &self.faces.output[0],
        };
        let ran = self.cue.update(cue.clone(), |layer| layer.run(&cue, &found));
        self.note(Stage::Interpolation, ran, began, 0);
    }

    /// What needs to see the whole picture: what is mixed in, fading, and the display's policy.
    fn display(&mut self, Job { scene, plan, .. }: &Job<'_>) {
        let report = &mut self.report;
        let fit = self.rays.fit().filter(|_| scene.ambient.source != AmbientSource::Constant);
        report.ambient_fit = fit.map(|fit| fit.to_array());
        if !self.shaded {
            return;
        }
        let began = (self.clock)();
        let Picture { frame, linear } = &mut self.picture.output;
        let layer = &self.cue.output;
        if plan.composes {
            let faded = (plan.cued == Cued::AtPoints).then_some(&*layer.scales);
            report.overflowing = compose(scene, self.rays.layers(scene), faded, linear);
        }
        if matches!(plan.cued, Cued::AtVertices | Cued::AtPixels) {
            report.overflowing = fade_pixels(layer, scene.depth_cueing.color.as_vec3(), plan.composes, linear);
        }
        report.divisor = 1.0;
        if plan.whole_picture {
            let width = frame.width as usize;
            report.divisor = display(self.level, linear, width, &scene.display, &mut frame.pixels);
        }
        self.note(Stage::Display, true, began, 0);
    }

    /// Takes every band through what is stale, and through shading if the frame is to be shaded.
    fn paint(&mut self, job: &Job<'_>, shades: bool) {
        let Job { scene, plan, lens, equation } = job;
        let stale = std::mem::take(&mut self.stale);
        let painter = BandPainter {
            level: self.level,
            clock: self.clock,
            scene,
            plan,
            lens,
            equation,
            surface: self.surface.output.as_ref(),
            triangles: self.placed.output.triangles(&self.model.output),
            bins: &self.placed.output.bins,
            intensity: &self.points.output,
            visibility: self.rays.visibility(plan).filter(|_| plan.per == Per::Pixel),
            stale,
            shades,
        };
        let canvas =
            if shades { self.picture.output.canvas(scene.image.size, plan.whole_picture) } else { Canvas::default() };
        let interpolates = painter.interpolates();
        let tally = painter.run(&mut self.bands.output, &mut self.interpolated.output, canvas);
        let [covering, interpolating, shading] = tally.nanoseconds;
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
            report.overflowing = tally.overflowing;
            let at_pixels = plan.per == Per::Pixel;
            let (stage, evaluations) =
                if at_pixels { (Stage::PixelShading, report.covered) } else { (Stage::Display, 0) };
            report.ran(stage, shading, evaluations);
        }
    }

    fn note(&mut self, stage: Stage, ran: bool, began: u64, evaluations: u64) {
        if ran {
            self.report.ran(stage, self.since(began), evaluations);
        }
    }

    fn since(&self, began: u64) -> u64 {
        (self.clock)().saturating_sub(began)
    }

    pub(super) fn facts(&self) -> Facts {
        let model = &self.model.output;
        Facts { closed: model.closed, convex: model.convex, centre: model.origin, radius: model.radius }
    }

    /// The triangles of the last picture where they lie in it.
    pub(super) fn triangles(&self) -> Triangles<'_> {
        self.placed.output.triangles(&self.model.output)
    }

    /// Which triangle each pixel of the last picture sees.
    pub(super) fn coverage(&self) -> Coverage<'_> {
        let Frame { width, height, .. } = self.picture.output.frame;
        Coverage { size: [width, height], bands: &self.bands.output, fragments: &self.interpolated.output.fragments }
    }

    /// The terms and steps of the last picture: how often each is evaluated, or why it is left out.
    pub fn terms(&self) -> Vec<Term> {
        self.drawn.as_ref().map_or_else(Vec::new, |Drawn { scene, plan, .. }| {
            let culled = plan.cull || plan.true_surface;
            let triangles = self.triangles();
            let backs = if culled { 0 } else { self.placed.output.bins.backs(|index| triangles.corners(index)) };
            let inks = if plan.carries { 0 } else { self.bands.output.iter().map(Band::ink_count).sum() };
            Account { scene, plan, facts: &self.facts(), report: &self.report, backs, inks }.terms()
        })
    }

    /// The memory that is held for the next picture. A model's polygons, which its owner shares, count as well.
    pub fn memory(&self) -> Memory {
        let per = self.plan().map_or(Per::Pixel, |plan| plan.per);
        let [centres, normals] = &self.faces.output;
        let intensity = room_of_planes(&self.points.output);
        let Picture { frame, linear } = &self.picture.output;
        let parts = [
            self.mesh.output.memory(),
            self.model.output.memory(),
            self.placed.output.memory(),
            Memory::of_triangles(room_of_planes(centres) + room_of_planes(normals)),
            if per == Per::Face { Memory::of_triangles(intensity) } else { Memory::of_vertices(intensity) },
            // Each run has a pixel of its own at least, so that runs grow with the pixels.
            Memory::of_pixels(self.bands.output.iter().map(|band| room(&band.runs) + room(&band.extents)).sum()),
            self.interpolated.output.memory(),
            self.cue.output.memory(),
            self.rays.memory(per),
            Memory::of_pixels(room(&frame.pixels) + room(linear)),
        ];
        parts.into_iter().sum()
    }
}

impl Picture {
    /// Gives the buffers their size; the room of a linear picture that is not wanted is let go.
    fn canvas(&mut self, [width, height]: [u32; 2], whole: bool) -> Canvas<'_> {
        let Self { frame, linear } = self;
        let pixels = width as usize * height as usize;
        (frame.width, frame.height) = (width, height);
        frame.pixels.resize(pixels, [0; 4]);
        if !whole {
            *linear = Vec::new();
        }
        linear.resize(if whole { pixels } else { 0 }, [0.0; 4]);
        Canvas { pixels: &mut frame.pixels, linear }
    }
}
