//! Coverage, interpolation and shading, band by band: a band goes through all three while it is in a core's cache.

mod colours;

use super::display::{Linear, stored_pixel};
use super::parts::Part;
use super::plan::{Inputs, Per};
use super::points::PointIntensities;
use super::reference::Evaluation;
use super::shade::{Carried, Evaluated, shade, start_of_row};
use super::target::{Stored, Target, Unstored};
use crate::illumination::{Equation, LANES, Reached, SpecularForm};
use crate::render::lens::pixel_centre;
use crate::render::model::Planes;
use crate::render::node::{Memory, capacity};
use crate::render::raster::{
    BAND, Band, BandExtent, Block, DepthScratch, Fragment, PlacedTriangles, ROWS, Run, carry,
    fragment, interpolate, is_seen, meet_band, put,
};
use fearless_simd::{Simd, dispatch};
use rayon::prelude::*;
use std::cell::RefCell;
use std::ops::Range;

/// The data that interpolation keeps between frames.
#[derive(Default)]
pub struct Interpolated {
    /// The values that each vertex carries to the pixels: its normal, or its intensity in each part of the picture.
    carried: Vec<Vec<Fragment>>,
    pub fragments: Vec<Block>,
    /// The colours that tint Od at each pixel, of a model that has any.
    tints: Vec<Block>,
}

impl Interpolated {
    pub fn count(&self, memory: &mut Memory) {
        memory.vertices += self.carried.iter().map(capacity).sum::<u64>();
        memory.pixels += capacity(&self.fragments) + capacity(&self.tints);
    }
}

/// The steps of the bands that have to run again.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stale {
    pub coverage: bool,
    pub interpolation: bool,
}

/// Nanoseconds of coverage, interpolation and shading, and the number of overflowing pixels.
pub type Tally = [u64; 4];

/// The inputs from which the bands are drawn.
#[derive(Clone, Copy)]
pub struct BandPainter<'a> {
    pub inputs: Inputs<'a>,
    pub clock: Option<fn() -> u64>,
    pub parts: &'a [Part],
    pub placed: &'a PlacedTriangles,
    /// The intensities at vertices or faces, for each part; empty where the equation is evaluated at pixels.
    pub intensity: &'a [PointIntensities],
    pub stale: Stale,
    /// True if the bands are shaded, false if they are only covered and interpolated.
    pub shades: bool,
    /// The time after which no further band is shaded, in the clock's nanoseconds.
    pub deadline: u64,
}

/// A picture to be filled.
#[derive(Default)]
pub struct Canvas<'a> {
    pub pixels: &'a mut [[u8; 4]],
    /// Filled in place of the stored pixels if it is not empty.
    pub linear: &'a mut [Linear],
    /// True for each band that is yet to be shaded.
    pub pending: &'a mut [bool],
}

/// Pixels of one material, in the rows of a band, or gathered from them into one row.
struct Pixels<'a> {
    band: &'a Band,
    fragments: &'a [Block],
    tints: &'a [Block],
    columns: &'a Range<usize>,
    places: Option<&'a [Block]>,
    reached: Option<Reached<'a>>,
}

/// The pixels of a band in one row, those of each material together: their numbers in the band, their fragments, and the start
/// of the ray and the column of each. The pixels of a material begin a block.
#[derive(Default)]
struct GatheredPixels {
    pixels: Vec<u32>,
    fragments: Vec<Block>,
    /// The colours that tint Od, if there are any.
    tints: Vec<Block>,
    places: Vec<Block>,
    /// The material of each of the band's runs.
    materials: Vec<u16>,
}

impl GatheredPixels {
    /// Makes place for `count` pixels, whole blocks of gaps.
    fn clear(&mut self, count: usize, tinted: bool) {
        let blocks = count / LANES;
        self.pixels.resize(count, 0);
        for (planes, blocks) in [
            (&mut self.fragments, blocks),
            (&mut self.places, blocks),
            (&mut self.tints, if tinted { blocks } else { 0 }),
        ] {
            planes.clear();
            planes.resize(blocks, Block::GAP);
        }
    }

    /// Puts the columns `shown` of a row that begins with pixel `first` from `place` on; `start` is the ray through its column 0.
    fn put(
        &mut self,
        mut place: usize,
        [line, tints]: [&[Block]; 2],
        first: usize,
        shown: Range<usize>,
        [x, y, z]: [f32; 3],
    ) {
        for column in shown {
            self.pixels[place] = (first + column) as u32;
            put(&mut self.fragments, place, fragment(line, column));
            put(&mut self.places, place, [x, y, z, column as f32]);
            if !tints.is_empty() {
                put(&mut self.tints, place, fragment(tints, column));
            }
            place += 1;
        }
    }
}

struct BandTask<'a> {
    index: usize,
    band: &'a mut Band,
    fragments: &'a mut [Block],
    tints: &'a mut [Block],
    pixels: &'a mut [[u8; 4]],
    linear: &'a mut [Linear],
    pending: Option<&'a mut bool>,
    /// True for the first band that is pending, which is shaded in any case.
    first: bool,
}

thread_local! {
    static DEPTH: RefCell<DepthScratch> = RefCell::default();
    /// The fragments of a band, where they are not kept.
    static FRAGMENTS: RefCell<Vec<Block>> = RefCell::default();
    /// The pixels of a band that show one material.
    static GATHERED: RefCell<GatheredPixels> = RefCell::default();
}

impl BandPainter<'_> {
    /// Runs the steps that are out of date; times are means over the threads. At least
    /// one of the pending bands is shaded.
    pub fn run(
        &self,
        bands: &mut Vec<Band>,
        interpolated: &mut Interpolated,
        canvas: Canvas<'_>,
    ) -> Tally {
        let began = self.now();
        let Inputs {
            level,
            plan,
            triangles,
            ..
        } = self.inputs;
        let [width, height] = self.inputs.scene.image.size;
        let Interpolated {
            carried,
            fragments,
            tints,
        } = interpolated;
        bands.resize_with(height.div_ceil(BAND) as usize, Band::default);
        let blocks = if plan.keeps_fragments() {
            Block::count(width) * height as usize
        } else {
            0
        };
        fragments.resize(blocks, Block::GAP);
        let tinted = triangles.model.is_tinted() && plan.interpolates();
        tints.resize(if tinted { blocks } else { 0 }, Block::GAP);
        if self.stale.interpolation && plan.interpolates() {
            let model = triangles.model;
            let sources: Vec<&Planes> = match plan.per {
                Per::Pixel if tinted => vec![&model.normal, &model.tint],
                Per::Pixel => vec![&model.normal],
                _ => self.intensity.iter().map(|own| &own.planes).collect(),
            };
            let by_key = plan.carries && plan.perspective;
            carried.resize_with(sources.len(), Vec::new);
            for (planes, carried) in sources.into_iter().zip(carried.iter_mut()) {
                let planes = planes.each_ref().map(Vec::as_slice);
                carry(level, planes, by_key, &triangles, carried);
            }
        }
        let carrying = self.now().saturating_sub(began);
        let kept = [&mut **fragments, &mut **tints];
        let tasks = band_tasks(bands, kept, canvas, [width, height]).into_par_iter();
        let sum = |a: Tally, b: Tally| std::array::from_fn(|k| a[k] + b[k]);
        let [covering, interpolating, shading, overflowing] = tasks
            .map(|task| self.paint(task, carried))
            .reduce(Tally::default, sum);
        let threads = rayon::current_num_threads().max(1) as u64;
        [
            covering / threads,
            interpolating / threads + carrying,
            shading / threads,
            overflowing,
        ]
    }

    fn now(&self) -> u64 {
        self.clock.map_or(0, |clock| clock())
    }

    /// Returns whether fragments are to be made: kept ones replace those they were made from.
    pub fn interpolates(&self) -> bool {
        let plan = self.inputs.plan;
        plan.interpolates()
            && if plan.keeps_fragments() {
                self.stale.interpolation
            } else {
                self.shades
            }
    }

    fn paint(&self, task: BandTask<'_>, carried: &[Vec<Fragment>]) -> Tally {
        if !self.inputs.plan.has_fragments() || self.inputs.plan.keeps_fragments() {
            return self.paint_with(task, carried);
        }
        FRAGMENTS.with_borrow_mut(|fragments| {
            fragments.resize(ROWS * Block::count(task.band.place.width), Block::GAP);
            self.paint_with(BandTask { fragments, ..task }, carried)
        })
    }

    fn paint_with(&self, mut task: BandTask<'_>, carried: &[Vec<Fragment>]) -> Tally {
        let mut tally = Tally::default();
        let mut last = self.now();
        let mut lap = |step: usize| {
            let now = self.now();
            tally[step] += now.saturating_sub(last);
            last = now;
        };
        if self.stale.coverage {
            self.cover(&mut task);
            lap(0);
        }
        let (interpolates, kept) = (self.interpolates(), self.inputs.plan.keeps_fragments());
        if interpolates && kept {
            self.interpolate(task.band, task.fragments, &carried[0]);
            if !task.tints.is_empty() {
                self.interpolate(task.band, task.tints, &carried[1]);
            }
            lap(1);
        }
        let Some(pending) = task.pending.take() else {
            return tally;
        };
        if !*pending || !task.first && self.now() > self.deadline {
            return tally;
        }
        *pending = false;
        let mut overflowing = 0;
        // From the right, since the lanes of a part's first pixels may reach into the part before it.
        for (index, part) in self.parts.iter().enumerate().rev() {
            if interpolates && !kept {
                self.interpolate(task.band, task.fragments, &carried[index]);
                lap(1);
            }
            overflowing += self.shade(&mut task, part, self.intensity.get(index));
            lap(2);
        }
        tally[3] = overflowing;
        tally
    }

    fn interpolate(&self, band: &Band, fragments: &mut [Block], carried: &[Fragment]) {
        let (sources, scanline) = ((self.inputs.triangles, carried), self.inputs.plan.scanline);
        dispatch!(self.inputs.level, simd => interpolate(simd, band, sources, scanline, fragments));
    }

    fn cover(&self, task: &mut BandTask<'_>) {
        let BandTask {
            index,
            band,
            fragments,
            ..
        } = task;
        let Inputs {
            level,
            plan,
            lens,
            triangles,
            surface,
            ..
        } = self.inputs;
        if plan.true_surface {
            if let Some(surface) = surface {
                meet_band(level, lens, surface, band, fragments);
            }
            return;
        }
        let list = self.placed.band(*index);
        if plan.depth_test {
            DEPTH.with_borrow_mut(|scratch| {
                dispatch!(level, simd => vectorised(simd, #[inline(always)] || {
                    band.cover_nearest(&triangles, list, scratch);
                }));
            });
        } else {
            dispatch!(level, simd => vectorised(simd, #[inline(always)] || {
                band.cover_directly(&triangles, list);
            }));
        }
    }

    /// Shades a part of a band; returns the number of overflowing pixels.
    fn shade(
        &self,
        task: &mut BandTask<'_>,
        part: &Part,
        intensity: Option<&PointIntensities>,
    ) -> u64 {
        let encoding = self.inputs.scene.display.encoding;
        let background = self.inputs.scene.image.background;
        if task.linear.is_empty() {
            let target = Stored {
                pixels: &mut *task.pixels,
                background: stored_pixel(background, encoding),
                encoding,
            };
            self.shade_into(
                (task.band, [task.fragments, task.tints]),
                part,
                intensity,
                target,
            )
        } else {
            let [r, g, b] = background.as_vec3().to_array();
            let target = Unstored {
                pixels: &mut *task.linear,
                background: [r, g, b, 0.0],
            };
            self.shade_into(
                (task.band, [task.fragments, task.tints]),
                part,
                intensity,
                target,
            )
        }
    }

    fn shade_into(
        &self,
        (band, [fragments, tints]): (&Band, [&[Block]; 2]),
        part: &Part,
        intensity: Option<&PointIntensities>,
        mut target: impl Target,
    ) -> u64 {
        let Inputs {
            level,
            plan,
            triangles,
            ..
        } = self.inputs;
        let columns = &part.columns;
        if plan.pixels_in_double() {
            return self.shade_in_double(band, fragments, part, target);
        }
        if let (false, Some(intensity)) = (plan.has_fragments(), intensity) {
            return dispatch!(level, simd => self.fill_faces(simd, band, columns, intensity, target));
        }
        if plan.per != Per::Pixel {
            let carried = Carried {
                by_key: plan.carries && plan.perspective,
            };
            let over = dispatch!(level, simd => shade(simd, band, fragments, columns, carried, &mut target));
            let mark = |own| self.mark((band, fragments), columns, carried, own, &mut target);
            return over + intensity.map_or(0, mark);
        }
        if !triangles.model.face_materials.faces.is_empty() {
            return GATHERED.with_borrow_mut(|batch| {
                self.shade_by_material((band, [fragments, tints]), part, &mut target, batch)
            });
        }
        let pixels = Pixels {
            band,
            fragments,
            tints,
            columns,
            places: None,
            reached: None,
        };
        self.shade_pixels(&part.equations[0], &pixels, &mut target)
    }

    /// Evaluates a material's equation at pixels.
    fn shade_pixels(
        &self,
        equation: &Equation<f32>,
        pixels: &Pixels<'_>,
        target: &mut impl Target,
    ) -> u64 {
        let Pixels {
            band,
            fragments,
            tints,
            columns,
            places,
            reached,
        } = *pixels;
        let evaluated = |form| {
            let colour = Evaluated::new(&self.inputs, equation, form);
            colour.at_places(places, reached).tinted(tints)
        };
        dispatch!(self.inputs.level, simd => match equation.form() {
            // The usual form has a kernel of its own: the choice among all takes a tenth of the time.
            SpecularForm::PhongCosine => {
                let colour = evaluated(SpecularForm::PhongCosine);
                shade(simd, band, fragments, columns, colour, target)
            }
            form => shade(simd, band, fragments, columns, evaluated(form), target),
        })
    }

    /// Shades the pixels of a part of a band that show several materials: those of each are gathered and shaded together.
    fn shade_by_material(
        &self,
        (band, kept): (&Band, [&[Block]; 2]),
        part: &Part,
        target: &mut impl Target,
        batch: &mut GatheredPixels,
    ) -> u64 {
        let (columns, width) = (&part.columns, band.place.width as usize);
        for row in 0..band.place.rows as usize {
            target.clear(row * width + columns.start..row * width + columns.end);
        }
        let groups = self.gather((band, kept), part, batch);
        let first_row = band.place.first_row as usize;
        let (mut over, mut colors) = (0, vec![]);
        for (material, group) in groups {
            let equation = &part.equations[material];
            let (pixels, count) = (&batch.pixels[group.clone()], group.len());
            let blocks = group.start / LANES..group.end.div_ceil(LANES);
            let bits = pixels.iter().map(|pixel| {
                let (row, column) = (*pixel as usize / width, *pixel as usize % width);
                let visibility = self.inputs.visibility;
                (
                    visibility.and_then(|bits| bits.at(first_row + row, 0)),
                    column,
                )
            });
            let (words, stride) = Reached::gathered(bits, equation.sources.len());
            let gathered = Pixels {
                band: &Band::of_one_row(count as u32),
                fragments: &batch.fragments[blocks.clone()],
                tints: batch.tints.get(blocks.clone()).unwrap_or_default(),
                columns: &(0..count),
                places: Some(&batch.places[blocks]),
                reached: (!words.is_empty()).then_some(Reached {
                    words: &words,
                    stride,
                    first: 0,
                }),
            };
            let (_, background) = target.pixels();
            colors.clear();
            colors.resize(count, background);
            over += self.shade_pixels(equation, &gathered, &mut target.over(&mut colors));
            let (all, _) = target.pixels();
            for (pixel, color) in pixels.iter().zip(&colors) {
                all[*pixel as usize] = *color;
            }
        }
        over
    }

    /// Gathers the pixels of a part of a band; returns each material that it shows, with the place of its pixels.
    ///
    /// The runs are read in their order, so that a fragment is met once, in the cache.
    fn gather(
        &self,
        (band, [fragments, tints]): (&Band, [&[Block]; 2]),
        part: &Part,
        batch: &mut GatheredPixels,
    ) -> Vec<(usize, Range<usize>)> {
        let Inputs {
            lens, triangles, ..
        } = self.inputs;
        let (columns, place) = (&part.columns, band.place);
        let own = |run: &Run| {
            let face = triangles.face(run.triangle);
            triangles.model.face_materials.of_face(face) as u16
        };
        batch.materials.clear();
        batch.materials.extend(band.runs.iter().map(own));
        let shown = |run: &Run| {
            let start = usize::from(run.x0).max(columns.start);
            start..usize::from(run.x1).min(columns.end).max(start)
        };
        // The number of each material's pixels, then the place of the next of them.
        let mut next = vec![0; part.equations.len()];
        for (run, material) in band.runs.iter().zip(&batch.materials) {
            next[usize::from(*material)] += shown(run).len();
        }
        let (mut groups, mut end) = (vec![], 0);
        for (material, count) in next.iter_mut().enumerate().filter(|(_, count)| **count > 0) {
            groups.push((material, end..end + *count));
            end += std::mem::replace(count, end).next_multiple_of(LANES);
        }
        batch.clear(end, !tints.is_empty());
        let starts: Vec<[f32; 3]> = (0..place.rows as usize)
            .map(|row| start_of_row(lens, place.first_row as usize + row))
            .collect();
        for (index, run) in band.runs.iter().enumerate() {
            let (row, shown) = (usize::from(run.row), shown(run));
            let next = &mut next[usize::from(batch.materials[index])];
            let first = std::mem::replace(next, *next + shown.len());
            let lines = [fragments, tints].map(|all| {
                all.get(row * Block::count(place.width)..)
                    .unwrap_or_default()
            });
            let pixel = row * place.width as usize;
            batch.put(first, lines, pixel, shown, starts[row]);
        }
        groups
    }

    fn shade_in_double(
        &self,
        band: &Band,
        fragments: &[Block],
        part: &Part,
        mut target: impl Target,
    ) -> u64 {
        let (inputs, columns, place) = (&self.inputs, &part.columns, band.place);
        let (equations, width) = (part.in_double(inputs), place.width as usize);
        for row in 0..place.rows as usize {
            target.clear(row * width + columns.start..row * width + columns.end);
        }
        let mut over = 0;
        let mut put = |x: usize, row: usize, evaluation: Evaluation<'_>| {
            let color = evaluation.intensity(&equations).as_vec3().to_array();
            let undefined = evaluation.is_undefined(&equations);
            let at = row * width + x;
            let ink = dispatch!(inputs.level, simd => target.ink(simd, color, undefined));
            over += target.fill(at..at + 1, ink);
        };
        let centre = |x: usize, row: usize| pixel_centre(x, place.first_row as usize + row);
        if inputs.plan.true_surface {
            for (row, line) in fragments.chunks(Block::count(place.width)).enumerate() {
                for x in columns.clone().filter(|x| is_seen(fragment(line, *x))) {
                    if let Some(evaluation) = inputs.of_surface(centre(x, row)) {
                        put(x, row, evaluation);
                    }
                }
            }
        }
        for run in &band.runs {
            let seen = usize::from(run.x0).max(columns.start)..usize::from(run.x1).min(columns.end);
            for x in seen {
                let row = usize::from(run.row);
                put(x, row, inputs.of_triangle(run.triangle, centre(x, row)));
            }
        }
        over
    }
}

/// Compiles what is inlined into `work` for the level's instructions.
#[inline(always)]
fn vectorised<S: Simd>(_: S, work: impl FnOnce()) {
    work();
}

fn band_tasks<'a>(
    bands: &'a mut [Band],
    [fragments, tints]: [&'a mut [Block]; 2],
    canvas: Canvas<'a>,
    [width, height]: [u32; 2],
) -> Vec<BandTask<'a>> {
    let share = (BAND * width) as usize;
    let blocks = ROWS * Block::count(width);
    let (mut fragments, mut tints) = (fragments.chunks_mut(blocks), tints.chunks_mut(blocks));
    let mut pixels = canvas.pixels.chunks_mut(share);
    let mut linear = canvas.linear.chunks_mut(share);
    let first = canvas.pending.iter().position(|own| *own);
    let mut pending = canvas.pending.iter_mut();
    let bands = bands.iter_mut().zip((0..height).step_by(ROWS)).enumerate();
    let task = |(index, (band, first_row)): (usize, (&'a mut Band, u32))| {
        band.place = BandExtent {
            first_row,
            rows: BAND.min(height - first_row),
            width,
        };
        BandTask {
            index,
            band,
            fragments: fragments.next().unwrap_or_default(),
            tints: tints.next().unwrap_or_default(),
            pixels: pixels.next().unwrap_or_default(),
            linear: linear.next().unwrap_or_default(),
            pending: pending.next(),
            first: Some(index) == first,
        }
    };
    bands.map(task).collect()
}
