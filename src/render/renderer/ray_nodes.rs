//! The steps that follow rays, each run only when what it reads has changed: the hierarchy of boxes, which light is seen
//! from where, what is seen past the object, and light from other surfaces.

use super::compose::bounces_at;
use super::plan::{Per, Plan};
use crate::geometry::Surface;
use crate::illumination::Equation;
use crate::render::lens::Lens;
use crate::render::memory::{Holds, Memory, room};
use crate::render::node::Node;
use crate::render::raster::{Coverage, Fragment, Triangles};
use crate::render::rays::{
    Background, Bounced, Bvh, DiffuseSurface, FloorView, Gathering, Glass, LightScratch, PrimaryHits, ShadowCaster,
    Solid, Surroundings, Transmission, Visibility, any_light, bounce, diffuse_scene, see_background, shadow_pixels,
    shadow_points,
};
use crate::scene::{
    Ambient, AmbientSource, Backdrop, Backfacing, Ground, Light, Pattern, PatternKind, Rgb, Scene, ShadingMode,
    Transparency,
};
use fearless_simd::Level;
use glam::{DVec2, Vec3};

/// The outputs that are kept.
#[derive(Default)]
pub struct RayNodes {
    boxes: Node<u64, Bvh>,
    visibility: Node<VisibilityKey, Visibility>,
    background: Node<BackgroundKey, Vec<Vec3>>,
    bounced: Node<BouncedKey, Bounced>,
}

/// What the rays of a frame read.
#[derive(Clone, Copy)]
pub struct RayInputs<'a> {
    pub level: Level,
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    pub lens: &'a Lens,
    pub triangles: Triangles<'a>,
    pub surface: Option<&'a Surface>,
    /// Which run the object is of: the model's, or the true surface's.
    pub object: u64,
}

#[derive(PartialEq)]
struct VisibilityKey {
    object: u64,
    /// The run of the coverage where rays start from pixels.
    coverage: Option<u64>,
    per: Per,
    smooth: bool,
    ground: Option<f64>,
    flip: bool,
    lights: Vec<Light>,
    kept: Vec<bool>,
}

#[derive(PartialEq)]
struct BackgroundKey {
    object: Option<u64>,
    coverage: u64,
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
struct BouncedKey {
    object: u64,
    coverage: u64,
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

/// What a pixel sees of the object.
pub enum SeenAt {
    /// One of the model's triangles, or of the clipper's.
    Triangle(u32),
    Surface(Fragment),
}

impl<'a> RayInputs<'a> {
    fn smooth(&self) -> bool {
        !matches!(self.scene.shading.mode, ShadingMode::Flat | ShadingMode::Interpolated)
    }

    fn hits<'b>(&self, bvh: &'b Bvh) -> PrimaryHits<'b>
    where
        'a: 'b,
    {
        let surface = self.surface.filter(|_| self.plan.true_surface);
        let solid = Solid { model: self.triangles.model, bvh, surface, smooth: self.smooth() };
        PrimaryHits { lens: self.lens, triangles: self.triangles, solid }
    }

    /// The lights as far as rays go: where they stand, not how they shine.
    fn light_places(&self) -> Vec<Light> {
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

    fn visibility_key(&self, coverage: Option<u64>) -> VisibilityKey {
        VisibilityKey {
            object: self.object,
            coverage,
            per: self.plan.per,
            smooth: self.smooth(),
            ground: self.scene.ground.visible.then_some(self.scene.ground.height),
            flip: self.scene.reflection.backfacing == Backfacing::Flip,
            lights: self.light_places(),
            kept: self.plan.lights.clone(),
        }
    }

    /// The equation in double precision with the sources that the picture is shaded with.
    fn equation(&self) -> Equation<f64> {
        let mut equation = Equation::in_units(self.scene, self.lens.unit);
        equation.retain_lights(|light| self.plan.lights[light]);
        equation
    }

    /// The scene whose material is the floor's: a diffuse surface under the same lights.
    fn floor_scene(&self) -> Scene {
        let Ground { ka, kd, color, .. } = self.scene.ground;
        diffuse_scene(self.scene, Rgb::splat(ka), Rgb::splat(kd), color)
    }

    /// The surface of a diffuse scene, in the shadow of `solid` if that casts any.
    fn diffuse<'b>(&self, scene: &Scene, solid: Solid<'b>, shadows: bool) -> DiffuseSurface<'b> {
        let equation = Equation::in_units(scene, self.lens.unit);
        let caster = shadows.then(|| ShadowCaster::new(scene, solid, &equation, false));
        DiffuseSurface { equation, caster }
    }

    /// The floor, if there is one, as rows of pixels see it.
    fn floor_view<'b>(
        &self,
        floor: &Scene,
        surroundings: &Surroundings,
        solid: Solid<'_>,
        caster: Option<&'b ShadowCaster<'b>>,
    ) -> Option<FloorView<'b>>
    where
        'a: 'b,
    {
        floor.ground.visible.then(|| FloorView {
            lens: self.lens,
            height: floor.ground.height,
            wall_depth: surroundings.wall_depth(self.lens),
            equation: Equation::in_units(floor, self.lens.unit),
            caster,
            middle: solid.ball().0,
        })
    }
}

impl RayNodes {
    /// The next picture traces every ray anew.
    pub fn forget(&mut self) {
        self.boxes.forget();
        self.visibility.forget();
        self.background.forget();
        self.bounced.forget();
    }

    /// The memory held; shadow bits are stored per vertex, face or pixel.
    pub fn memory(&self, per: Per) -> Memory {
        let bits = room(&self.visibility.output.words);
        let bits = match per {
            Per::Vertex => Memory::of_vertices(bits),
            Per::Face => Memory::of_triangles(bits),
            _ => Memory::of_pixels(bits),
        };
        let background = Memory::of_pixels(room(&self.background.output));
        self.boxes.output.memory() + bits + background + self.bounced.output.memory()
    }

    /// Builds the boxes, unless the true surface takes their place.
    fn build(&mut self, inputs: &RayInputs<'_>) {
        if !inputs.plan.true_surface {
            self.boxes.update(inputs.object, |boxes| *boxes = Bvh::new(inputs.triangles.model));
        }
    }

    /// Finds out which sources are seen from the `count` vertices or faces where the equation is evaluated.
    pub fn shadow_points(&mut self, inputs: &RayInputs<'_>, count: usize) -> bool {
        self.build(inputs);
        let Self { boxes, visibility, .. } = self;
        visibility.update(inputs.visibility_key(None), |visibility| {
            let (equation, model) = (inputs.equation(), inputs.triangles.model);
            let caster = ShadowCaster::new(inputs.scene, inputs.hits(&boxes.output).solid, &equation, true);
            let point = |index: usize| match inputs.plan.per {
                Per::Face => (model.face_centre(index as u32), model.face_normal(index as u32)),
                _ => (model.position(index as u32), model.normal(index as u32)),
            };
            shadow_points(inputs.level, count, point, &caster, equation.sources.len(), visibility);
        })
    }

    /// Follows the rays of covered pixels; tells whether any had to be followed. `stamp` is the run of the coverage.
    pub fn follow(&mut self, inputs: &RayInputs<'_>, coverage: Coverage<'_>, stamp: u64) -> bool {
        let RayInputs { scene, plan, .. } = *inputs;
        let mut ran = false;
        let at_pixels = plan.shadows && plan.per == Per::Pixel;
        let bounces = scene.ambient.source != AmbientSource::Constant;
        if at_pixels || bounces || (plan.composes && (scene.transparency.kt > 0.0 || scene.shading.shadows)) {
            self.build(inputs);
        }
        if at_pixels {
            let Self { boxes, visibility, .. } = self;
            ran |= visibility.update(inputs.visibility_key(Some(stamp)), |visibility| {
                let (equation, hits) = (inputs.equation(), inputs.hits(&boxes.output));
                let caster = ShadowCaster::new(scene, hits.solid, &equation, true);
                shadow_pixels(inputs.level, coverage, &hits, &caster, equation.sources.len(), visibility);
            });
        }
        let casts = scene.shading.shadows && scene.ground.visible && any_light(scene);
        let see = plan.composes && self.background.outdate(background_key(inputs, stamp, casts));
        let bounce = bounces && self.bounced.outdate(bounced_key(inputs, stamp));
        if see || bounce {
            let mut floor = inputs.floor_scene();
            if see {
                self.see(inputs, coverage, &floor, casts);
            }
            if bounce {
                self.bounce(inputs, coverage, &mut floor);
            }
        }
        ran || see || bounce
    }

    fn see(&mut self, inputs: &RayInputs<'_>, coverage: Coverage<'_>, floor_scene: &Scene, casts: bool) {
        let RayInputs { scene, lens, .. } = *inputs;
        let hits = inputs.hits(&self.boxes.output);
        let surroundings = Surroundings::new(scene, lens);
        let floor = inputs.diffuse(floor_scene, hits.solid, casts);
        let glass = Glass::new(scene, hits.solid, &surroundings, &floor);
        let floor_view = inputs.floor_view(floor_scene, &surroundings, hits.solid, floor.caster.as_ref());
        let background = Background {
            hits: &hits,
            surroundings: &surroundings,
            floor: &floor,
            floor_view: floor_view.as_ref(),
            glass: (scene.transparency.kt > 0.0).then_some(&glass),
        };
        see_background(inputs.level, coverage, &background, &mut self.background.output);
    }

    fn bounce(&mut self, inputs: &RayInputs<'_>, coverage: Coverage<'_>, floor_scene: &mut Scene) {
        let RayInputs { scene, lens, .. } = *inputs;
        let hits = inputs.hits(&self.boxes.output);
        let surroundings = Surroundings::new(scene, lens);
        let floor_view = inputs.floor_view(floor_scene, &surroundings, hits.solid, None);
        // Surfaces without the ambient light that the bounce takes the place of, and the object without highlights.
        floor_scene.material.ka = Rgb::ZERO;
        let floor = inputs.diffuse(floor_scene, hits.solid, true);
        (floor_scene.material.kd, floor_scene.material.color) = (scene.material.kd, scene.material.color);
        floor_scene.pattern = scene.pattern.clone();
        let object = inputs.diffuse(floor_scene, hits.solid, true);
        let gathering = Gathering { solid: hits.solid, surroundings: &surroundings, object: &object, floor: &floor };
        let bounced = &mut self.bounced.output;
        bounce(inputs.level, coverage, &hits, scene, (&gathering, floor_view.as_ref()), &object.equation, bounced);
    }

    /// The shadow bits, where there are shadows.
    pub fn visibility(&self, plan: &Plan) -> Option<&Visibility> {
        plan.shadows.then_some(&self.visibility.output)
    }

    /// What composes the picture: what is seen beyond, and what other surfaces scatter.
    pub fn layers(&self, scene: &Scene) -> [&[Vec3]; 2] {
        let bounces = scene.ambient.source != AmbientSource::Constant;
        [&self.background.output, if bounces { &self.bounced.output.difference } else { &[] }]
    }

    /// The constant that stands for one bounce best.
    pub fn fit(&self) -> Option<Rgb> {
        self.bounced.output.fit
    }

    /// Which runs the outputs are of: the shadow bits first.
    pub fn stamps(&self) -> [u64; 3] {
        [self.visibility.stamp(), self.background.stamp(), self.bounced.stamp()]
    }

    /// What the transmitted ray does of the pixel whose sample lies at `place`.
    pub fn transmission_at(&self, inputs: &RayInputs<'_>, place: DVec2, seen: SeenAt) -> Option<Transmission> {
        let RayInputs { scene, lens, level, .. } = *inputs;
        let hits = inputs.hits(&self.boxes.output);
        let surroundings = Surroundings::new(scene, lens);
        let floor = inputs.diffuse(&inputs.floor_scene(), hits.solid, scene.shading.shadows);
        let glass = Glass::new(scene, hits.solid, &surroundings, &floor);
        let hit = match seen {
            SeenAt::Triangle(triangle) => hits.of_triangle(triangle, place),
            SeenAt::Surface(fragment) => hits.of_fragment(place, fragment),
        };
        let ray = [(hit, lens.ray(place).1.normalize())];
        let mut told = None;
        glass.transmit(level, &ray, &mut LightScratch::default(), |_, transmission| told = Some(transmission));
        told
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

fn background_key(inputs: &RayInputs<'_>, coverage: u64, shadows: bool) -> BackgroundKey {
    let scene = inputs.scene;
    let glass = (scene.transparency.kt > 0.0).then(|| Transparency { kt: 1.0, ..scene.transparency.clone() });
    BackgroundKey {
        object: (shadows || glass.is_some()).then_some(inputs.object),
        coverage,
        smooth: inputs.smooth(),
        lens: *inputs.lens,
        background: scene.image.background,
        ground: scene.ground.clone(),
        backdrop: scene.backdrop.clone(),
        glass,
        lights: scene.ground.visible.then(|| (scene.lights.clone(), scene.ambient.clone())),
        shadows,
    }
}

fn bounced_key(inputs: &RayInputs<'_>, coverage: u64) -> BouncedKey {
    let scene = inputs.scene;
    BouncedKey {
        object: inputs.object,
        coverage,
        smooth: inputs.smooth(),
        lens: *inputs.lens,
        ground: scene.ground.clone(),
        wall: (scene.backdrop.pattern != PatternKind::None).then_some(scene.backdrop.distance),
        ambient: scene.ambient.constant(),
        lights: scene.lights.clone(),
        surface: [scene.material.ka, scene.material.kd, scene.material.color],
        pattern: scene.pattern.clone(),
    }
}
