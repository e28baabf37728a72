//! The stages that follow rays, each run only when what it reads has changed: the hierarchy of boxes, which light reaches
//! what, what is seen beyond, and light from other surfaces.

use super::beyond::{Bounced, Prospect, bounce, bounces_at, eye_ray, reach_pixels, reach_points, seen_beyond};
use super::bounce::Gathering;
use super::bvh::Bvh;
use super::floor::FloorView;
use super::fragments::Fragment;
use super::interpolate::Sources;
use super::lens::Lens;
use super::memory::{Holds, Memory, room};
use super::painting::Bands;
use super::plan::{Per, Plan};
use super::points::CHUNK;
use super::shadow::{Cast, Reach, Shadows};
use super::sites::Sights;
use super::solid::Solid;
use super::stage::Kept;
use super::surroundings::{Surroundings, any_light, diffuse_scene, ground_equation};
use super::transmission::{Glass, Transmission};
use crate::geometry::Surface;
use crate::illumination::Equation;
use crate::scene::{
    Ambient, AmbientSource, Backdrop, Ground, Light, Pattern, PatternKind, Rgb, Scene, ShadingMode, Transparency,
};
use fearless_simd::Level;
use glam::{DVec2, DVec3, Vec3};

/// The outputs that are kept.
#[derive(Default)]
pub(super) struct RayStages {
    bvh: Kept<u64, Bvh>,
    reach: Kept<ReachInputs, Reach>,
    seen: Kept<SeenInputs, Vec<Vec3>>,
    bounced: Kept<BouncedInputs, Bounced>,
}

/// What the rays of a frame read.
#[derive(Clone, Copy)]
pub(super) struct RayInputs<'a> {
    pub level: Level,
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    pub lens: &'a Lens,
    pub sources: Sources<'a>,
    pub surface: Option<&'a Surface>,
    /// Which run the object is of: the model's, or the true surface's.
    pub object: u64,
}

/// Which bits are wanted.
#[derive(PartialEq)]
struct ReachInputs {
    object: u64,
    /// The pixels', or the points'.
    sites: u64,
    per: Per,
    smooth: bool,
    ground: Option<f64>,
    flip: bool,
    lights: Vec<Light>,
    kept: Vec<bool>,
}

#[derive(PartialEq)]
struct SeenInputs {
    object: Option<u64>,
    bands: u64,
    smooth: bool,
    lens: Lens,
    background: Rgb,
    ground: Ground,
    backdrop: Backdrop,
    glass: Option<Transparency>,
    /// What the floor is lit by.
    lights: Option<(Vec<Light>, Ambient)>,
    shadows: bool,
}

#[derive(PartialEq)]
struct BouncedInputs {
    object: u64,
    bands: u64,
    smooth: bool,
    lens: Lens,
    ground: Ground,
    /// Where a wall hides the ground.
    wall: Option<f64>,
    /// Ia, as far as the equation has it.
    ambient: Rgb,
    lights: Vec<Light>,
    /// ka, kd and Od of the object: highlights are not scattered on.
    surface: [Rgb; 3],
    pattern: Pattern,
}

impl<'a> RayInputs<'a> {
    fn smooth(&self) -> bool {
        !matches!(self.scene.shading.mode, ShadingMode::Flat | ShadingMode::Interpolated)
    }

    fn solid<'b>(&self, bvh: &'b Bvh) -> Solid<'b>
    where
        'a: 'b,
    {
        let surface = self.surface.filter(|_| self.plan.true_surface);
        Solid { model: self.sources.model, bvh, surface, smooth: self.smooth() }
    }

    /// The lights as far as rays go: where they stand, not how they shine.
    fn places(&self) -> Vec<Light> {
        let place = |light: &Light| Light {
            kind: light.kind,
            position: light.position,
            direction: light.direction,
            shape: light.shape,
            extent: light.extent,
            radius: light.radius,
            samples: light.samples,
            ..Light::default()
        };
        self.scene.lights.iter().map(place).collect()
    }

    /// The equation in double precision with the sources that the picture is shaded with.
    fn equation(&self) -> Equation<f64> {
        let mut equation = Equation::in_units(self.scene, self.lens.unit);
        equation.retain_lights(|light| self.plan.lights[light]);
        equation
    }

    fn sights<'b>(&self, bvh: &'b Bvh) -> Sights<'b>
    where
        'a: 'b,
    {
        Sights { lens: self.lens, sources: self.sources, solid: self.solid(bvh) }
    }
}

impl RayStages {
    /// The next picture traces every ray anew.
    pub fn forget(&mut self) {
        self.bvh.forget();
        self.reach.forget();
        self.seen.forget();
        self.bounced.forget();
    }

    /// The memory held, where the bits are those of sites of which there is one `per` something.
    pub fn memory(&self, per: Per) -> Memory {
        let bits = room(&self.reach.output.words);
        let bits = match per {
            Per::Vertex => Memory::of_vertices(bits),
            Per::Face => Memory::of_triangles(bits),
            _ => Memory::of_pixels(bits),
        };
        let seen = Memory::of_pixels(room(&self.seen.output));
        self.bvh.output.memory() + bits + seen + self.bounced.output.memory()
    }

    /// Builds the boxes, unless the true surface takes their place.
    fn build(&mut self, inputs: &RayInputs<'_>) {
        if !inputs.plan.true_surface {
            self.bvh.update(inputs.object, |_, bvh| *bvh = Bvh::new(inputs.sources.model));
        }
    }

    fn reach_inputs(inputs: &RayInputs<'_>, sites: u64) -> ReachInputs {
        let scene = inputs.scene;
        ReachInputs {
            object: inputs.object,
            sites,
            per: inputs.plan.per,
            smooth: inputs.smooth(),
            ground: scene.ground.visible.then_some(scene.ground.height),
            flip: scene.reflection.backfacing == crate::scene::Backfacing::Flip,
            lights: inputs.places(),
            kept: inputs.plan.lights.clone(),
        }
    }

    /// Finds out which sources reach the `count` points where the equation is evaluated, vertices or faces.
    pub fn reach_points(
        &mut self,
        inputs: &RayInputs<'_>,
        count: usize,
        point: impl Fn(usize) -> (DVec3, DVec3) + Sync,
    ) -> bool {
        if !inputs.plan.shadows || inputs.plan.per == Per::Pixel {
            return false;
        }
        self.build(inputs);
        let Self { bvh, reach, .. } = self;
        reach.update(Self::reach_inputs(inputs, 0), |_, reach| {
            let equation = inputs.equation();
            let shadows = Shadows::new(inputs.scene, inputs.solid(&bvh.output), &equation);
            reach_points(inputs.level, count, CHUNK, point, &shadows, reach);
        })
    }

    /// Follows the rays of the pixels that the bands cover; tells whether any had to be followed.
    pub fn follow(&mut self, inputs: &RayInputs<'_>, bands: &Bands) -> bool {
        let (scene, plan) = (inputs.scene, inputs.plan);
        let mut ran = false;
        let at_pixels = plan.shadows && plan.per == Per::Pixel;
        let bounces = scene.ambient.source != AmbientSource::Constant;
        if at_pixels || bounces || (plan.composes && (scene.transparency.kt > 0.0 || scene.shading.shadows)) {
            self.build(inputs);
        }
        if at_pixels {
            let Self { bvh, reach, .. } = self;
            ran |= reach.update(Self::reach_inputs(inputs, bands.coverage_stamp()), |_, reach| {
                let equation = inputs.equation();
                let sights = inputs.sights(&bvh.output);
                let shadows = Shadows::new(scene, sights.solid, &equation);
                reach_pixels(inputs.level, bands, &sights, &shadows, scene.image.size, reach);
            });
        }
        if plan.composes {
            ran |= self.see(inputs, bands);
        }
        if bounces {
            ran |= self.bounce(inputs, bands);
        }
        ran
    }

    fn see(&mut self, inputs: &RayInputs<'_>, bands: &Bands) -> bool {
        let scene = inputs.scene;
        let casts = scene.shading.shadows && scene.ground.visible && any_light(scene);
        let glass = (scene.transparency.kt > 0.0).then(|| Transparency { kt: 1.0, ..scene.transparency.clone() });
        let keys = SeenInputs {
            object: (casts || glass.is_some()).then_some(inputs.object),
            bands: bands.coverage_stamp(),
            smooth: inputs.smooth(),
            lens: *inputs.lens,
            background: scene.image.background,
            ground: scene.ground.clone(),
            backdrop: scene.backdrop.clone(),
            glass,
            lights: scene.ground.visible.then(|| (scene.lights.clone(), scene.ambient.clone())),
            shadows: casts,
        };
        let Self { bvh, seen, .. } = self;
        seen.update(keys, |keys, seen| {
            let scenery = Scenery::new(inputs, &bvh.output);
            let surroundings = scenery.surroundings(keys.shadows);
            let glass = keys.glass.as_ref().map(|glass| scenery.glass(glass, &surroundings));
            let floor = scenery.floor_view(&surroundings, keys.shadows);
            let prospect = Prospect {
                sights: &scenery.sights,
                surroundings: &surroundings,
                floor: floor.as_ref(),
                glass: glass.as_ref(),
            };
            seen_beyond(inputs.level, bands, scene.image.size, &prospect, seen);
        })
    }

    fn bounce(&mut self, inputs: &RayInputs<'_>, bands: &Bands) -> bool {
        let scene = inputs.scene;
        let keys = BouncedInputs {
            object: inputs.object,
            bands: bands.coverage_stamp(),
            smooth: inputs.smooth(),
            lens: *inputs.lens,
            ground: scene.ground.clone(),
            wall: (scene.backdrop.pattern != PatternKind::None).then_some(scene.backdrop.distance),
            ambient: scene.ambient.constant(),
            lights: scene.lights.clone(),
            surface: [scene.material.ka, scene.material.kd, scene.material.color],
            pattern: scene.pattern.clone(),
        };
        let Self { bvh, bounced, .. } = self;
        bounced.update(keys, |_, bounced| {
            let scenery = Scenery::new(inputs, &bvh.output);
            let surroundings = scenery.surroundings(true);
            // The object without highlights and without the ambient light that the bounce takes the place of.
            let material = &scene.material;
            let matt = diffuse_scene(scene, Rgb::ZERO, material.kd, material.color);
            let matt = Scene { pattern: scene.pattern.clone(), ..matt };
            let dark = Scene { ground: Ground { ka: 0.0, ..scene.ground.clone() }, ..scene.clone() };
            let (object, floor) =
                (Equation::in_units(&matt, inputs.lens.unit), ground_equation(&dark, inputs.lens.unit));
            let floor_view = scenery.floor_view(&surroundings, false);
            let gathering = Gathering {
                floor_view: floor_view.as_ref(),
                shadows: Shadows::new(scene, scenery.sights.solid, &scenery.floor),
                surroundings: &surroundings,
                object: &object,
                floor: &floor,
            };
            bounce(inputs.level, bands, &scenery.sights, scene, &gathering, &object, bounced);
        })
    }

    /// The bits, where there are shadows.
    pub fn reach(&self, plan: &Plan) -> Option<&Reach> {
        plan.shadows.then_some(&self.reach.output)
    }

    /// What composes the picture: what is seen beyond, and what other surfaces scatter.
    pub fn layers(&self, scene: &Scene) -> [&[Vec3]; 2] {
        let bounces = scene.ambient.source != AmbientSource::Constant;
        [&self.seen.output, if bounces { &self.bounced.output.difference } else { &[] }]
    }

    /// The constant that stands for one bounce best.
    pub fn fit(&self) -> Option<Rgb> {
        self.bounced.output.fit
    }

    /// Which runs the outputs are of.
    pub fn stamps(&self) -> [u64; 3] {
        [self.reach.stamp(), self.seen.stamp(), self.bounced.stamp()]
    }

    /// What the transmitted ray of a pixel does that sees `triangle`, or the true surface in `fragment`.
    pub fn transmission_at(&self, inputs: &RayInputs<'_>, [x, y]: [u32; 2], seen: SeenAt) -> Transmission {
        let scenery = Scenery::new(inputs, &self.bvh.output);
        let surroundings = scenery.surroundings(inputs.scene.shading.shadows);
        let glass = scenery.glass(&inputs.scene.transparency, &surroundings);
        let place = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let sight = match seen {
            SeenAt::Triangle(triangle) => scenery.sights.of_triangle(triangle, place),
            SeenAt::Surface(fragment) => scenery.sights.of_fragment(place, fragment),
        };
        let (_, incident) = eye_ray(inputs.lens, x as usize, y as usize);
        glass.transmit(sight.point, sight.normal, incident, &mut Vec::new())
    }

    /// What one bounce puts in the place of the constant ambient term at a pixel, as the difference between the two.
    pub fn bounced_at(&self, scene: &Scene, x: u32, y: u32) -> Option<Rgb> {
        let width = scene.image.size[0] as usize;
        let index = y as usize * width + x as usize;
        let [_, difference] = self.layers(scene);
        let here = bounces_at(scene.ambient.source, x as usize, width);
        difference.get(index).filter(|_| here).map(|difference| difference.as_dvec3())
    }
}

/// What a pixel sees of the object.
pub(super) enum SeenAt {
    /// One of the model's triangles, or of the clipper's.
    Triangle(u32),
    Surface(Fragment),
}

/// What rays are followed through.
pub(super) struct Scenery<'a> {
    inputs: RayInputs<'a>,
    floor: Equation<f64>,
    pub sights: Sights<'a>,
}

impl<'a> Scenery<'a> {
    pub fn new(inputs: &RayInputs<'a>, bvh: &'a Bvh) -> Self {
        Self { inputs: *inputs, floor: ground_equation(inputs.scene, inputs.lens.unit), sights: inputs.sights(bvh) }
    }

    /// The surroundings, with the object's shadow on them.
    pub fn surroundings(&self, shadows: bool) -> Surroundings<'_> {
        let RayInputs { scene, lens, .. } = self.inputs;
        let shadows = shadows.then(|| Shadows::new(scene, self.sights.solid, &self.floor));
        Surroundings::new(scene, lens, &self.floor, shadows)
    }

    /// The floor, if there is one, as rows of pixels see it.
    fn floor_view(&self, surroundings: &Surroundings<'_>, shadows: bool) -> Option<FloorView<'_>> {
        let RayInputs { scene, lens, .. } = self.inputs;
        let cast = shadows.then(|| Cast::new(Shadows::new(scene, self.sights.solid, &self.floor), false));
        let (middle, _) = self.sights.solid.ball();
        let view = || FloorView {
            lens,
            height: scene.ground.height,
            wall_depth: surroundings.wall_depth(lens),
            equation: ground_equation(scene, lens.unit),
            cast,
            middle,
        };
        scene.ground.visible.then(view)
    }

    pub fn glass<'b>(&'b self, glass: &Transparency, surroundings: &'b Surroundings<'b>) -> Glass<'b> {
        Glass { solid: self.sights.solid, surroundings, eta: glass.ior, through: glass.through }
    }
}
