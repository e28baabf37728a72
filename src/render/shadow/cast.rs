//! Rows of sites in, the bits of the sources hidden from them cleared.
//!
//! Sixteen sites are asked about together. What [`super::proof`] cannot decide waits until it fills a packet of rays.

use super::Shadows;
use super::proof::{Balls, Sites, Target, Whole};
use super::site_row::SiteRow;
use crate::render::bvh::{Packet, RAYS};
use crate::scene::LightKind;
use fearless_simd::Simd;
use glam::DVec3;
use std::ops::Range;

struct Lamp {
    sources: Range<usize>,
    /// Whether any of them lies under the floor, and whether above.
    sides: [bool; 2],
    /// Where it is worth to ask about all of them at once.
    whole: Option<Whole>,
}

/// What casts shadows upon rows of sites.
pub(in crate::render) struct Cast<'a> {
    shadows: Shadows<'a>,
    targets: Vec<Target>,
    lamps: Vec<Lamp>,
    balls: Balls,
    middle: DVec3,
    /// Whether the sites lie on the object.
    own: bool,
}

/// Rays that wait for their packet to be full, with the source and the site that they are of.
#[derive(Default)]
pub(in crate::render) struct Waiting {
    packet: Packet,
    marks: [(u32, u32); RAYS],
    count: usize,
}

/// Where the bits of a row go: a source has `stride` words.
struct Sheet<'a> {
    stride: usize,
    words: &'a mut [u64],
    waiting: &'a mut Waiting,
}

impl Sheet<'_> {
    /// Clears bits of a source, `dark`'s lowest that of site `first`.
    #[inline(always)]
    fn darken(&mut self, source: usize, first: usize, dark: u32) {
        self.words[source * self.stride + first / 64] &= !(u64::from(dark) << (first % 64));
    }
}

/// Sixteen sites of a row.
struct Place<'a, S: Simd> {
    row: &'a SiteRow,
    first: usize,
    sites: Sites<S>,
}

impl<'a> Cast<'a> {
    /// `own` says whether the sites lie on the object.
    pub fn new(shadows: Shadows<'a>, own: bool) -> Self {
        let (middle, radius) = shadows.solid.ball();
        let equation = shadows.equation;
        let target = |source: usize| {
            let (place, t_max) = equation.way_to(source, middle);
            let parallel = t_max > 1.0;
            let up = if parallel { place.y } else { shadows.ground.map_or(0.0, |ground| middle.y + place.y - ground) };
            Target::new(place, parallel, up, radius)
        };
        let targets: Vec<Target> = (0..equation.sources.len()).map(target).collect();
        let lamp = |light: usize| {
            let sources = equation.sources_of(light);
            let whole = shadows.lights.get(light).filter(|light| light.kind == LightKind::Area && sources.len() > 1);
            let any = |sign: f32| targets[sources.clone()].iter().any(|target| target.rise * sign > 0.0);
            let sides = [any(-1.0), any(1.0)];
            Lamp { sides, sources, whole: whole.map(|light| Whole::new(light, middle, radius)) }
        };
        Self {
            lamps: (0..equation.light_count()).map(lamp).collect(),
            targets,
            balls: Balls { outer: radius as f32, inner: shadows.solid.inner_radius() as f32 },
            middle,
            shadows,
            own,
        }
    }

    /// Whether it is plain that every source reaches every site: a convex solid shadows nothing on itself that faces a
    /// source, and no floor parts them.
    pub fn reaches_all(&self) -> bool {
        let Shadows { solid, ground, flip, .. } = self.shadows;
        let above =
            |ground: f64| self.shadows.least_height() >= ground && self.targets.iter().all(|target| target.rise > 0.0);
        self.own && !flip && solid.is_convex() && ground.is_none_or(above)
    }

    /// A point of the world as rows hold it.
    pub fn relative(&self, point: DVec3) -> DVec3 {
        point - self.middle
    }

    /// Clears the bits of the sources that are hidden from a row's sites; a source has `stride` words.
    #[inline(always)]
    pub fn mark_row<S: Simd>(&self, simd: S, row: &SiteRow, stride: usize, words: &mut [u64], waiting: &mut Waiting) {
        let mut sheet = Sheet { stride, words, waiting };
        let clearance = self.shadows.solid.clearance();
        let least = if self.own { self.shadows.least_height() } else { f64::NEG_INFINITY };
        let [ground, least] =
            [self.shadows.ground.unwrap_or(f64::NEG_INFINITY), least].map(|height| height - self.middle.y);
        for packet in (0..row.present.len()).filter(|packet| row.present[*packet] != 0) {
            if self.own && self.shadows.flip {
                self.mark_each(row, packet, &mut sheet);
                continue;
            }
            let sites = Sites::load(simd, row, packet, clearance, [ground, least], self.balls);
            let place = Place { row, first: packet * RAYS, sites };
            for lamp in &self.lamps {
                self.mark_lamp(simd, &place, lamp, &mut sheet);
            }
        }
        self.follow(simd, &mut sheet);
    }

    /// Sites that light may reach from either side, one by one.
    fn mark_each(&self, row: &SiteRow, packet: usize, sheet: &mut Sheet<'_>) {
        for site in (packet * RAYS..(packet + 1) * RAYS).filter(|site| row.present[packet] >> (site % RAYS) & 1 == 1) {
            let (start, n) = (row.start_of(site) + self.middle, row.normal_of(site));
            for source in (0..self.targets.len()).filter(|&source| !self.shadows.reaches(source, start, n)) {
                sheet.darken(source, site, 1);
            }
        }
    }

    /// Asks about one light at sixteen sites.
    #[inline(always)]
    fn mark_lamp<S: Simd>(&self, simd: S, place: &Place<'_, S>, lamp: &Lamp, sheet: &mut Sheet<'_>) {
        let Place { row, first, sites } = place;
        let present = row.present[first / RAYS];
        // A convex solid lies behind the tangent plane of each of its points.
        let alone = self.own && self.shadows.solid.is_convex();
        let (hidden, mixed) = match &lamp.whole {
            _ if alone => (0, 0),
            None => (0, present),
            Some(whole) => {
                let hidden = sites.hidden(simd, whole, self.balls) & present;
                (hidden, present & !hidden & !sites.clear(simd, whole, self.balls))
            }
        };
        if hidden | mixed == 0 && !(self.shadows.ground.is_some() && sites.floor_parts(simd, lamp.sides)) {
            return;
        }
        for source in lamp.sources.clone() {
            let target = &self.targets[source];
            let way = sites.way_to(simd, target);
            let facing = if self.shadows.flip { present } else { present & sites.facing(simd, &way) };
            let mut dark = facing & (hidden | sites.beyond_floor(simd, target));
            let unknown = facing & mixed & !dark;
            if unknown != 0 {
                let [open, shut] = sites.decide(simd, &way, target, self.balls);
                dark |= unknown & shut;
                self.wait(simd, place, unknown & !open & !shut, source, sheet);
            }
            sheet.darken(source, *first, dark);
        }
    }

    /// Lets rays wait for their packet.
    #[inline(always)]
    fn wait<S: Simd>(&self, simd: S, place: &Place<'_, S>, mut rays: u32, source: usize, sheet: &mut Sheet<'_>) {
        let Target { place: to, parallel, .. } = self.targets[source];
        let clearance = self.shadows.solid.clearance();
        while rays != 0 {
            let site = place.first + rays.trailing_zeros() as usize;
            rays &= rays - 1;
            let start = place.row.start_of(site) + place.row.normal_of(site) * clearance;
            let (direction, t_max) = if parallel { (to, f64::MAX) } else { (to - start, 1.0) };
            let Waiting { packet, marks, count } = sheet.waiting;
            packet.set(*count, start, direction, t_max);
            marks[*count] = (source as u32, site as u32);
            *count += 1;
            if *count == RAYS {
                self.follow(simd, sheet);
            }
        }
    }

    /// Follows the rays that wait.
    #[inline(always)]
    fn follow<S: Simd>(&self, simd: S, sheet: &mut Sheet<'_>) {
        let count = std::mem::take(&mut sheet.waiting.count);
        if count == 0 {
            return;
        }
        let asked = u32::MAX >> (32 - count);
        let mut blocked = self.shadows.solid.blocked(simd, &sheet.waiting.packet, asked);
        while blocked != 0 {
            let (source, site) = sheet.waiting.marks[blocked.trailing_zeros() as usize];
            blocked &= blocked - 1;
            sheet.darken(source as usize, site as usize, 1);
        }
    }
}
