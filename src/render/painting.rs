//! Coverage, interpolation and shading, band by band: a band goes through all three while it is in a core's cache.

use super::bins::{BAND, Bins};
use super::cover::{Band, BandPlace, DepthScratch};
use super::display::{Linear, stored_pixel};
use super::exact::meet_band;
use super::fragments::{Block, Fragment, fragment, is_seen};
use super::interpolate::{CarriedValues, Rule, Sources, interpolate};
use super::lens::Lens;
use super::memory::{Holds, Memory, room};
use super::plan::{Per, Plan};
use super::points::Planes;
use super::reference::{Evaluation, Reference};
use super::shade::{Carried, Evaluated, Stored, Target, Unstored, shade};
use super::shadow::Reach;
use crate::geometry::Surface;
use crate::illumination::{Equation, FormTask, Specular};
use crate::scene::{FlatAt, Rgb, Scene};
use fearless_simd::{Level, Simd, dispatch};
use glam::DVec2;
use rayon::prelude::*;
use std::cell::RefCell;
use std::sync::atomic::{AtomicU64, Ordering};

/// What coverage and interpolation keep between frames.
#[derive(Default)]
pub(super) struct Bands {
    bands: Vec<Band>,
    /// What each vertex carries to the pixels.
    carried: Vec<Fragment>,
    /// What each pixel was brought.
    fragments: Vec<Block>,
    coverage: Option<CoverageInputs>,
    interpolation: Option<InterpolationInputs>,
    stamp: u64,
    /// Counts the runs of the coverage alone.
    covered: u64,
    width: u32,
}

/// What coverage reads.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CoverageInputs {
    pub size: [u32; 2],
    /// The stamp of the stage before: the placed triangles', or the true surface's.
    pub source: u64,
    /// Rays of the true surface depend on the lens; placed triangles have taken it in.
    pub lens: Option<Lens>,
    pub depth_test: bool,
}

/// What interpolation reads besides the coverage.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct InterpolationInputs {
    /// The stamp of what the vertices carry.
    pub source: u64,
    pub per: Per,
    /// Pixels that are evaluated in double precision are brought nothing.
    pub carries: bool,
    pub perspective: bool,
    pub scanline: bool,
    pub flat_at: Option<FlatAt>,
}

/// Which of the bands' stages have to run again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stale {
    pub coverage: bool,
    pub interpolation: bool,
}

impl Stale {
    pub const NOTHING: Self = Self { coverage: false, interpolation: false };

    pub fn any(self) -> bool {
        self.coverage || self.interpolation
    }
}

impl Bands {
    /// Rows of a band.
    pub const ROWS: usize = BAND as usize;

    /// The bands of a picture of `size` pixels with their fragments, from the top.
    pub fn parts(
        &self,
        [width, height]: [u32; 2],
    ) -> impl IndexedParallelIterator<Item = (BandPlace, &Band, &[Block])> {
        let share = Self::ROWS * Block::count(width);
        self.bands.par_iter().enumerate().map(move |(index, band)| {
            let first_row = index as u32 * BAND;
            let fragments = &self.fragments[(index * share).min(self.fragments.len())..];
            let place = BandPlace { first_row, rows: BAND.min(height.saturating_sub(first_row)), width };
            (place, band, &fragments[..share.min(fragments.len())])
        })
    }

    /// The fragment of a pixel, where the bands keep any.
    pub fn fragment_at(&self, x: u32, y: u32) -> Option<Fragment> {
        let count = Block::count(self.width);
        let line = self.fragments.get(y as usize * count..(y as usize + 1) * count)?;
        (x < self.width).then(|| fragment(line, x as usize))
    }

    /// Compares the inputs with the last ones and takes them over.
    pub fn stale(&mut self, coverage: CoverageInputs, interpolation: InterpolationInputs) -> Stale {
        let covers = self.coverage.as_ref() != Some(&coverage);
        let interpolates = covers || self.interpolation.as_ref() != Some(&interpolation);
        self.width = coverage.size[0];
        self.coverage = Some(coverage);
        self.interpolation = Some(interpolation);
        self.stamp += u64::from(interpolates);
        self.covered += u64::from(covers);
        Stale { coverage: covers, interpolation: interpolates }
    }

    /// Counts the runs.
    pub fn stamp(&self) -> u64 {
        self.stamp
    }

    /// Counts the runs of the coverage alone.
    pub fn coverage_stamp(&self) -> u64 {
        self.covered
    }

    /// The next picture is covered anew.
    pub fn forget(&mut self) {
        self.coverage = None;
    }

    /// Triangles that are seen, counted again in each band and where another comes between.
    pub fn ink_count(&self) -> u64 {
        let of = |band: &Band| band.runs.chunk_by(|a, b| a.triangle == b.triangle).count() as u64;
        self.bands.iter().map(of).sum()
    }

    /// The triangle that a pixel sees.
    pub fn triangle_at(&self, x: u32, y: u32) -> Option<u32> {
        let band = self.bands.get((y / BAND) as usize)?;
        let run = band
            .runs
            .iter()
            .find(|run| u32::from(run.row) == y % BAND && u32::from(run.x0) <= x && x < u32::from(run.x1))?;
        Some(run.triangle)
    }
}

impl Holds for Bands {
    fn memory(&self) -> Memory {
        // Each run has a pixel of its own at least, so that runs grow with the pixels however many triangles there are.
        let seen: u64 = self.bands.iter().map(|band| room(&band.runs) + room(&band.extents)).sum();
        Memory { vertices: room(&self.carried), triangles: 0, pixels: room(&self.fragments) + seen }
    }
}

/// Where a picture goes.
pub(super) struct Canvas<'a> {
    pub pixels: &'a mut [[u8; 4]],
    /// Filled instead of `pixels` where the display needs to see the whole picture first; otherwise empty.
    pub linear: &'a mut [Linear],
}

/// Figures of one painting.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Painted {
    pub covered: u64,
    /// Pixels that triangles cover, those counted that another hides.
    pub drawn: u64,
    pub overflowing: u64,
    /// Evaluations of the equation at pixels.
    pub evaluations: u64,
    /// Whether anything was carried to the pixels.
    pub carried: bool,
    /// Nanoseconds of coverage, interpolation and shading, summed over the threads and divided by their number.
    pub nanoseconds: [u64; 3],
}

impl Painted {
    /// The figures of covering and of colouring, done one after the other.
    pub fn and(self, coloured: Self) -> Self {
        let [covering, interpolating, first] = self.nanoseconds;
        let [cover, interpolate, shading] = coloured.nanoseconds;
        let nanoseconds = [covering + cover, interpolating + interpolate, first + shading];
        Self { nanoseconds, carried: self.carried || coloured.carried, ..coloured }
    }

    /// With s0 brought to the pixels besides, if that was done, in so many nanoseconds.
    pub fn and_cued(mut self, (done, nanoseconds): (bool, u64)) -> Self {
        self.carried |= done;
        self.nanoseconds[1] += nanoseconds;
        self
    }
}

/// What painting reads.
#[derive(Clone, Copy)]
pub(super) struct Painting<'a> {
    pub level: Level,
    pub clock: fn() -> u64,
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    pub lens: &'a Lens,
    pub equation: &'a Equation<f32>,
    pub surface: Option<&'a Surface>,
    pub sources: Sources<'a>,
    pub bins: &'a Bins,
    pub intensity: &'a Planes,
    /// Which sources reach which pixels, where there are shadows.
    pub reach: Option<&'a Reach>,
    /// Whether the bands are coloured, or covered and interpolated only.
    pub colours: bool,
}

/// One band's share of the buffers.
struct Job<'a> {
    place: BandPlace,
    index: usize,
    band: &'a mut Band,
    fragments: &'a mut [Block],
    pixels: &'a mut [[u8; 4]],
    linear: &'a mut [Linear],
}

#[derive(Default)]
struct Counters {
    covered: AtomicU64,
    drawn: AtomicU64,
    overflowing: AtomicU64,
    nanoseconds: [AtomicU64; 3],
}

thread_local! {
    static DEPTH: RefCell<DepthScratch> = RefCell::default();
    /// The fragments of a band that are not kept.
    static FRAGMENTS: RefCell<Vec<Block>> = RefCell::default();
}

impl Painting<'_> {
    /// Paints what is stale.
    pub fn run(self, bands: &mut Bands, stale: Stale, canvas: Canvas<'_>) -> Painted {
        let began = (self.clock)();
        let [width, height] = self.scene.image.size;
        bands.bands.resize_with(height.div_ceil(BAND) as usize, Band::default);
        let blocks = if self.plan.keeps_fragments() { Block::count(width) * height as usize } else { 0 };
        bands.fragments.resize(blocks, Block::GAP);
        if stale.interpolation && self.plan.interpolates() {
            self.carry(&mut bands.carried);
        }
        let painting = Painting { sources: Sources { carried: &bands.carried, ..self.sources }, ..self };
        let carrying = (self.clock)().saturating_sub(began);
        let counters = Counters::default();
        jobs(&mut bands.bands, &mut bands.fragments, canvas, [width, height])
            .into_par_iter()
            .for_each(|job| painting.paint(job, stale, &counters));
        let threads = rayon::current_num_threads().max(1) as u64;
        let mut nanoseconds = counters.nanoseconds.map(|counter| counter.into_inner() / threads);
        nanoseconds[1] += carrying;
        let [covered, drawn, overflowing] =
            [counters.covered, counters.drawn, counters.overflowing].map(AtomicU64::into_inner);
        let evaluates = self.colours && self.plan.per == Per::Pixel;
        let (evaluations, carried) = (if evaluates { covered } else { 0 }, self.interpolates(stale));
        Painted { covered, drawn, overflowing, evaluations, carried, nanoseconds }
    }

    /// Readies what vertices carry to the pixels.
    fn carry(&self, carried: &mut Vec<Fragment>) {
        let planes = if self.plan.per == Per::Pixel { &self.sources.model.normal } else { self.intensity };
        let by_key = self.plan.carries && self.plan.perspective;
        let values = CarriedValues { planes: planes.each_ref().map(Vec::as_slice), by_key };
        values.carry(self.level, carried, self.sources.placed, self.sources.clipped);
    }

    /// Whether fragments are to be made: those that are kept are as good as what they are made from.
    fn interpolates(&self, stale: Stale) -> bool {
        self.plan.interpolates() && if self.plan.keeps_fragments() { stale.interpolation } else { self.colours }
    }

    fn paint(&self, job: Job<'_>, stale: Stale, counters: &Counters) {
        if self.plan.has_fragments() && !self.plan.keeps_fragments() {
            FRAGMENTS.with_borrow_mut(|fragments| {
                fragments.resize(Bands::ROWS * Block::count(job.place.width), Block::GAP);
                self.paint_with(Job { fragments, ..job }, stale, counters);
            });
        } else {
            self.paint_with(job, stale, counters);
        }
    }

    fn paint_with(&self, mut job: Job<'_>, stale: Stale, counters: &Counters) {
        let mut last = (self.clock)();
        let mut lap = |stage: usize| {
            let now = (self.clock)();
            counters.nanoseconds[stage].fetch_add(now.saturating_sub(last), Ordering::Relaxed);
            last = now;
        };
        if stale.coverage {
            self.cover(&mut job);
            lap(0);
        }
        if self.interpolates(stale) {
            let Job { place, band, fragments, .. } = &mut job;
            let rule = if self.plan.scanline { Rule::Scanline } else { Rule::Steps };
            dispatch!(self.level, simd => interpolate(simd, *place, band, self.sources, rule, fragments));
        }
        if self.plan.interpolates() {
            lap(1);
        }
        let over = if self.colours { self.colour(&mut job) } else { 0 };
        lap(2);
        counters.covered.fetch_add(job.band.covered, Ordering::Relaxed);
        counters.drawn.fetch_add(job.band.drawn, Ordering::Relaxed);
        counters.overflowing.fetch_add(over, Ordering::Relaxed);
    }

    fn cover(&self, job: &mut Job<'_>) {
        let Job { place, index, band, fragments, .. } = job;
        if self.plan.true_surface {
            if let Some(surface) = self.surface {
                meet_band(self.lens, surface, *place, band, fragments);
            }
            return;
        }
        let triangles = self.bins.band(*index);
        let sources = &self.sources;
        if self.plan.depth_test {
            DEPTH.with_borrow_mut(|scratch| {
                dispatch!(self.level, simd => vectorised(simd, #[inline(always)] || {
                    band.cover_nearest(*place, sources, triangles, scratch);
                }));
            });
        } else {
            dispatch!(self.level, simd => vectorised(simd, #[inline(always)] || {
                band.cover_directly(*place, sources, triangles);
            }));
        }
    }

    /// Colours a band; returns how many pixels overflow.
    fn colour(&self, job: &mut Job<'_>) -> u64 {
        let display = &self.scene.display;
        let background = self.scene.image.background;
        let Job { place, band, fragments, .. } = job;
        let covered = Covered { place: *place, band, fragments };
        if job.linear.is_empty() {
            let background = stored_pixel(background, display.encoding);
            let encoding = display.encoding;
            let target = Stored { pixels: &mut *job.pixels, background, encoding };
            self.colour_into(covered, target)
        } else {
            let [r, g, b] = background.as_vec3().to_array();
            let target = Unstored { pixels: &mut *job.linear, background: [r, g, b, 0.0] };
            self.colour_into(covered, target)
        }
    }

    fn colour_into(&self, covered: Covered<'_>, mut target: impl Target) -> u64 {
        let Covered { place, band, fragments } = covered;
        if self.plan.pixels_in_double() {
            return self.colour_in_double_precision(place, band, fragments, target);
        }
        if !self.plan.has_fragments() {
            return dispatch!(self.level, simd => self.colour_faces(simd, place, band, target));
        }
        if self.plan.per != Per::Pixel {
            let carried = Carried { by_key: self.plan.carries && self.plan.perspective };
            return dispatch!(self.level, simd => shade(simd, place, &band.extents, fragments, carried, &mut target));
        }
        self.equation.form().dispatch(ShadePixels { painting: self, covered, target })
    }

    fn evaluated<F: Specular>(&self, form: F) -> Evaluated<'_, F> {
        let by_key = self.plan.perspective && !self.plan.true_surface;
        Evaluated::new(form, self.equation, self.lens, by_key, self.plan.renormalise, self.reach)
    }

    /// Flat shading: each run in its face's colour.
    #[inline(always)]
    fn colour_faces<S: Simd>(&self, simd: S, place: BandPlace, band: &Band, mut target: impl Target) -> u64 {
        let width = place.width as usize;
        for (row, extent) in band.extents.iter().enumerate() {
            let line = row * width..(row + 1) * width;
            // Runs that are not sorted leave no gaps between them.
            if band.sorted || extent.is_empty() {
                target.clear(line);
            } else {
                target.clear(line.start..line.start + extent.start as usize);
                target.clear(line.start + extent.end as usize..line.end);
            }
        }
        let mut over = 0;
        let mut last = (u32::MAX, target.ink(simd, [0.0; 3]));
        for run in &band.runs {
            if last.0 != run.triangle {
                last = (run.triangle, target.ink(simd, self.face_intensity(run.triangle)));
            }
            let row = usize::from(run.row) * width;
            over += target.fill(row + usize::from(run.x0)..row + usize::from(run.x1), last.1);
        }
        over
    }

    #[inline(always)]
    fn face_intensity(&self, triangle: u32) -> [f32; 3] {
        let at = |point: u32| self.intensity.each_ref().map(|plane| plane[point as usize]);
        let face = self.sources.face(triangle);
        let corners = self.sources.model.face(face);
        match self.scene.shading.flat_at {
            FlatAt::Centre => at(face),
            FlatAt::ProvokingVertex => at(self.sources.provoking_vertex(triangle)),
            FlatAt::VertexMean => {
                #[expect(clippy::cast_precision_loss, reason = "a face has few corners")]
                let share = 1.0 / corners.len().max(1) as f32;
                let sum = corners.iter().map(|&v| at(v)).fold([0.0; 3], |a, b| [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
                sum.map(|v| v * share)
            }
        }
    }

    /// Pixels one by one in `f64`.
    fn colour_in_double_precision(
        &self,
        place: BandPlace,
        band: &Band,
        fragments: &[Block],
        mut target: impl Target,
    ) -> u64 {
        let mut equation = Equation::<f64>::in_units(self.scene, self.lens.unit);
        equation.retain_lights(|light| self.plan.lights[light]);
        let Self { scene, plan, lens, .. } = *self;
        let reference =
            Reference { scene, plan, lens, sources: self.sources, surface: self.surface, reach: self.reach, cue: None };
        let width = place.width as usize;
        target.clear(0..place.rows as usize * width);
        let mut over = 0;
        let mut put = |x: usize, row: usize, evaluation: Evaluation<'_>| {
            let color: Rgb = evaluation.intensity(&equation);
            let at = row * width + x;
            let ink = dispatch!(self.level, simd => target.ink(simd, color.as_vec3().to_array()));
            over += target.fill(at..at + 1, ink);
        };
        let centre = |x: usize, row: usize| DVec2::new(x as f64 + 0.5, f64::from(place.first_row) + row as f64 + 0.5);
        if plan.true_surface {
            for (row, line) in fragments.chunks(Block::count(place.width)).enumerate() {
                for x in (0..width).filter(|x| is_seen(fragment(line, *x))) {
                    if let Some(evaluation) = reference.of_surface(centre(x, row)) {
                        put(x, row, evaluation);
                    }
                }
            }
        }
        for run in &band.runs {
            for x in run.x0..run.x1 {
                let (x, row) = (usize::from(x), usize::from(run.row));
                put(x, row, reference.of_triangle(run.triangle, centre(x, row)));
            }
        }
        over
    }
}

/// What a band's pixels are coloured from.
struct Covered<'a> {
    place: BandPlace,
    band: &'a Band,
    fragments: &'a [Block],
}

/// Shading at pixels, compiled for each specular form.
struct ShadePixels<'a, T> {
    painting: &'a Painting<'a>,
    covered: Covered<'a>,
    target: T,
}

impl<T: Target> FormTask for ShadePixels<'_, T> {
    type Output = u64;

    fn run<F: Specular>(mut self, form: F) -> u64 {
        let Covered { place, band, fragments } = self.covered;
        let evaluated = self.painting.evaluated(form);
        dispatch!(self.painting.level, simd => shade(simd, place, &band.extents, fragments, evaluated, &mut self.target))
    }
}

/// Lets what is inlined into `work` use the level's instructions.
#[inline(always)]
fn vectorised<S: Simd>(_: S, work: impl FnOnce()) {
    work();
}

/// Splits the buffers into bands.
fn jobs<'a>(
    bands: &'a mut [Band],
    fragments: &'a mut [Block],
    canvas: Canvas<'a>,
    [width, height]: [u32; 2],
) -> Vec<Job<'a>> {
    let share = (BAND * width) as usize;
    let mut fragments = fragments.chunks_mut(Bands::ROWS * Block::count(width));
    let mut linear = canvas.linear.chunks_mut(share);
    bands
        .iter_mut()
        .zip(canvas.pixels.chunks_mut(share))
        .zip((0..height).step_by(BAND as usize))
        .enumerate()
        .map(|(index, ((band, pixels), first_row))| Job {
            place: BandPlace { first_row, rows: BAND.min(height - first_row), width },
            index,
            band,
            fragments: fragments.next().unwrap_or_default(),
            pixels,
            linear: linear.next().unwrap_or_default(),
        })
        .collect()
}
