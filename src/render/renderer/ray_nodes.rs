//! The steps that follow rays, each run only when its inputs have changed: the hierarchy of boxes, the visibility of
//! lights, the view past the object, and light from other surfaces.

use super::parts::{Part, bouncing, with_ambient};
use super::plan::{Inputs, Per, Plan};
use crate::illumination::{Equation, lights_backs};
use crate::render::face_materials::{any_transmits, for_each_material};
use crate::render::lens::pixel_centre;
use crate::render::node::{Memory, Node, capacity};
use crate::render::raster::Coverage;
use crate::render::rays::{
    Bounced, Bvh, DiffuseSurface, LightBuffer, LightScratch, PrimaryHits, Receivers, ShadowCaster,
    Solid, Transmission, Visibility, World, matt_scene, update_light_buffers,
};
use crate::scene::{
    Ambient, AmbientSource, FaceMaterial, Light, Material, Pattern, PatternKind, Reflection, Rgb,
    Scene, ShadingMode, Through,
};
use glam::Vec3;

/// The stored outputs of the steps that follow rays.
#[derive(Default)]
pub struct RayNodes {
    boxes: Node<Bvh>,
    buffers: Node<Vec<Option<LightBuffer>>>,
    visibility: Node<Visibility>,
    background: Node<Vec<Vec3>>,
    receivers: Node<Receivers>,
    bounced: Node<Bounced>,
}

/// The things that rays are tested against: the boxes, and the triangles as lights see them, where that is known.
#[derive(Clone, Copy)]
struct Searched<'a> {
    bvh: &'a Bvh,
    buffers: &'a [Option<LightBuffer>],
}

impl<'a> Searched<'a> {
    fn boxes(bvh: &'a Bvh) -> Self {
        Self { bvh, buffers: &[] }
    }
}

/// The light mixed into the equation's value at a pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mixture {
    /// The transmitted ray, where light passes through the surface.
    pub transmission: Option<Transmission>,
    /// The light from other surfaces that the surface scatters, which replaces the constant ambient term.
    pub bounced: Option<Rgb>,
}

impl<'a> Inputs<'a> {
    fn smooth(&self) -> bool {
        !matches!(
            self.scene.shading.mode,
            ShadingMode::Flat | ShadingMode::Interpolated
        )
    }

    fn hits<'b>(&self, Searched { bvh, buffers }: Searched<'b>) -> PrimaryHits<'b>
    where
        'a: 'b,
    {
        let surface = self.surface.filter(|_| self.plan.true_surface);
        let solid = Solid {
            level: self.level,
            model: self.triangles.model,
            bvh,
            buffers,
            surface,
            smooth: self.smooth(),
        };
        PrimaryHits {
            lens: self.lens,
            triangles: self.triangles,
            solid,
        }
    }

    fn caster<'b>(&self, searched: Searched<'b>) -> ShadowCaster<'b>
    where
        'a: 'b,
    {
        ShadowCaster::new(
            self.scene,
            self.hits(searched).solid,
            &self.equations()[0],
            true,
        )
    }

    /// Returns the inputs of the shadow bits besides the object and the coverage: the lights' positions, not their intensities.
    fn shadow_key(&self) -> (Per, bool, Option<f64>, bool, Vec<Light>, Vec<bool>) {
        let scene = self.scene;
        (
            self.plan.per,
            self.smooth(),
            scene.ground.visible.then_some(scene.ground.height),
            lights_backs(&scene.reflection),
            scene.lights.iter().map(place).collect(),
            self.plan.lights.clone(),
        )
    }

    /// Returns whether the object's shadow is visible on the floor.
    fn shades_floor(&self) -> bool {
        self.scene.ground.visible && self.shades()
    }

    fn shades(&self) -> bool {
        let soloing = self.scene.soloing();
        let shines = |light: &Light| light.shines(soloing) && light.color != Rgb::ZERO;
        self.scene.shading.shadows && self.scene.lights.iter().any(shines)
    }

    /// Returns what rays past and through the object meet; where light bounces, without constant ambient light.
    fn world<'b>(&'b self, searched: Searched<'b>, bounces: bool) -> World<'b> {
        let (scene, materials) = (self.scene, self.materials);
        let hits = self.hits(searched);
        let ka = if bounces { 0.0 } else { scene.ground.ka };
        let mut world = World::new((scene, materials), hits, ka, self.shades_floor());
        if self.sees_others() {
            let equations = for_each_material(scene, materials, |scene| {
                Equation::in_units(scene, self.lens.unit)
            });
            let equations = with_ambient(equations, !bounces);
            let others = DiffuseSurface::of_materials(scene, equations, hits.solid, self.shades());
            world.object = Some(others);
        }
        world
    }

    /// Returns whether rays through the object may meet surfaces of another of its materials.
    fn sees_others(&self) -> bool {
        self.materials.len() > 1 && any_transmits(self.materials)
    }

    /// Returns the inputs of the view through the object besides the object and the coverage; `None` where it is opaque. Of
    /// one material, Kt is not among them.
    fn glass_key(&self) -> Option<Glass> {
        let (scene, materials) = (self.scene, self.materials);
        any_transmits(materials).then(|| Glass {
            through: scene.transparency.through,
            relative_ior: materials.iter().map(|own| own.relative_ior).collect(),
            others: self.sees_others().then(|| SeenThrough {
                materials: materials.to_vec(),
                pattern: scene.pattern.clone(),
                reflection: scene.reflection.clone(),
                lights: scene.lights.clone(),
                ambient: scene.ambient.clone(),
                shadows: self.shades(),
            }),
        })
    }
}

/// The inputs of the view through the object.
#[derive(Clone, PartialEq)]
struct Glass {
    through: Through,
    relative_ior: Vec<f64>,
    /// Those of the surfaces of other materials, where there are any.
    others: Option<SeenThrough>,
}

/// The inputs of surfaces that are seen through others.
#[derive(Clone, PartialEq)]
struct SeenThrough {
    materials: Vec<FaceMaterial>,
    pattern: Pattern,
    reflection: Reflection,
    lights: Vec<Light>,
    ambient: Ambient,
    shadows: bool,
}

/// Returns a light without all that moves no shadow.
fn place(light: &Light) -> Light {
    Light {
        kind: light.kind,
        position: light.position,
        direction: light.direction,
        shape: light.shape,
        extent: light.extent,
        radius: light.radius,
        samples: light.samples,
        ..Light::default()
    }
}

impl RayNodes {
    /// Makes the next picture trace every ray anew.
    pub fn forget(&mut self) {
        self.boxes.forget();
        self.buffers.forget();
        self.visibility.forget();
        self.background.forget();
        self.receivers.forget();
        self.bounced.forget();
    }

    /// Frees the memory of outputs that this plan does not need.
    pub fn release_unused(&mut self, scene: &Scene, plan: &Plan) {
        let bounces = scene.ambient.source != AmbientSource::Constant;
        if !plan.shadows {
            self.visibility.release();
        }
        if !plan.composes {
            self.background.release();
        }
        if !bounces {
            self.receivers.release();
            self.bounced.release();
        }
        if !(plan.shadows || plan.follows_rays()) {
            self.boxes.release();
            self.buffers.release();
        }
    }

    /// Adds the memory held; shadow bits are stored per vertex, face or pixel.
    pub fn count(&self, per: Per, memory: &mut Memory) {
        let bits = match per {
            Per::Vertex => &mut memory.vertices,
            Per::Face => &mut memory.triangles,
            _ => &mut memory.pixels,
        };
        *bits += capacity(&self.visibility.output.words);
        memory.pixels += capacity(&self.background.output);
        self.boxes.output.count(memory);
        self.buffers
            .output
            .iter()
            .flatten()
            .for_each(|buffer| buffer.count(memory));
        self.receivers.output.count(memory);
        self.bounced.output.count(memory);
    }

    /// Builds the boxes, unless the true surface replaces them. `object` is the run that made the object.
    fn build(&mut self, inputs: &Inputs<'_>, object: u64) {
        if !inputs.plan.true_surface {
            self.boxes
                .update(object, |boxes| *boxes = Bvh::new(inputs.triangles.model));
        }
    }

    /// Finds the sources visible from the `count` vertices or faces where the equation is evaluated.
    pub fn shadow_points(&mut self, inputs: &Inputs<'_>, object: u64, count: usize) -> bool {
        self.build(inputs, object);
        let Self {
            boxes, visibility, ..
        } = self;
        visibility.update((object, inputs.shadow_key()), |visibility| {
            let model = inputs.triangles.model;
            let point = |index: usize| match inputs.plan.per {
                Per::Face => (
                    model.face_centre(index as u32),
                    model.face_normal(index as u32),
                ),
                _ => (model.position(index as u32), model.normal(index as u32)),
            };
            inputs
                .caster(Searched::boxes(&boxes.output))
                .mark_points(count, point, visibility);
        })
    }

    /// Follows the rays of covered pixels; returns whether any had to be followed. `covered` is the run of the coverage.
    pub fn follow(
        &mut self,
        inputs: &Inputs<'_>,
        coverage: Coverage<'_>,
        parts: &[Part],
        [object, covered]: [u64; 2],
    ) -> bool {
        let Inputs {
            scene,
            plan,
            lens,
            materials,
            ..
        } = *inputs;
        let (ground, backdrop, ambient) = (&scene.ground, &scene.backdrop, &scene.ambient);
        let at_pixels = plan.shadows && plan.per == Per::Pixel;
        let bounces = ambient.source != AmbientSource::Constant;
        if at_pixels
            || bounces
            || (plan.composes && (any_transmits(materials) || scene.shading.shadows))
        {
            self.build(inputs, object);
        }
        let casts = at_pixels || plan.composes && inputs.shades_floor();
        if casts && plan.leaves_out && !plan.true_surface {
            let soloing = scene.soloing();
            let shining = |light: &Light| light.shines(soloing).then(|| place(light));
            let lights: Vec<Option<Light>> = scene.lights.iter().map(shining).collect();
            self.buffers.update((object, lights.clone()), |buffers| {
                update_light_buffers(buffers, inputs.level, inputs.triangles.model, &lights);
            });
        } else {
            self.buffers.release();
        }
        let Self {
            boxes,
            buffers,
            visibility,
            background,
            receivers,
            bounced,
        } = self;
        let searched = Searched {
            bvh: &boxes.output,
            buffers: &buffers.output,
        };
        let smooth = inputs.smooth();
        let mut ran = false;
        if at_pixels {
            ran |= visibility.update((object, covered, inputs.shadow_key()), |visibility| {
                inputs
                    .caster(searched)
                    .mark_pixels(coverage, &inputs.hits(searched), visibility);
            });
        }
        if plan.composes {
            let shadows = inputs.shades_floor();
            let glass = inputs.glass_key();
            let solid = (shadows || glass.is_some()).then_some(object);
            // The light that reaches the floor.
            let lights = ground
                .visible
                .then(|| (scene.lights.clone(), ambient.clone()));
            let behind = (scene.image.background, ground.clone(), backdrop.clone());
            ran |= background.update(
                (
                    solid, covered, smooth, *lens, behind, glass, lights, shadows,
                ),
                |seen| {
                    for part in parts {
                        let world = inputs.world(searched, part.bounces);
                        world.see_background(coverage, &part.columns, seen);
                    }
                },
            );
        }
        if bounces {
            let wall = (backdrop.pattern != PatternKind::None).then_some(backdrop.distance);
            // Highlights are not scattered further.
            let surface: Vec<_> = materials
                .iter()
                .map(|FaceMaterial { material: own, .. }| (own.ka, own.kd, own.color))
                .collect();
            let world = || World::new((scene, materials), inputs.hits(searched), 0.0, true);
            let height = ground.visible.then_some(ground.height);
            ran |= receivers.update(
                (object, covered, smooth, *lens, height, wall, plan.coarser),
                |receivers| receivers.run(&world(), coverage, plan.coarser),
            );
            ran |= bounced.update(
                (
                    receivers.stamp,
                    ground.clone(),
                    surface,
                    scene.pattern.clone(),
                    scene.reflection.backfacing,
                    scene.lights.clone(),
                ),
                |bounced| {
                    let world = world();
                    let matt = |scene: &Scene| {
                        let Material { kd, color, .. } = scene.material;
                        matt_scene(scene, [Rgb::ZERO, kd, color], scene.pattern.clone())
                    };
                    let equations = for_each_material(scene, materials, |scene| {
                        Equation::in_units(&matt(scene), lens.unit)
                    });
                    let (solid, matt) = (world.hits.solid, matt(scene));
                    let object = DiffuseSurface::of_materials(&matt, equations, solid, true);
                    bounced.run(&world, (&object, materials), &receivers.output);
                },
            );
        }
        ran
    }

    pub fn visibility(&self, plan: &Plan) -> Option<&Visibility> {
        plan.shadows.then_some(&self.visibility.output)
    }

    /// Returns the layers of the picture: the view beyond, and the light that other surfaces scatter.
    pub fn layers(&self, scene: &Scene) -> [&[Vec3]; 2] {
        let bounces = scene.ambient.source != AmbientSource::Constant;
        [
            &self.background.output,
            if bounces {
                &self.bounced.output.scattered
            } else {
                &[]
            },
        ]
    }

    /// Returns the constant that best approximates one bounce.
    pub fn fit(&self) -> Option<Rgb> {
        self.bounced.output.fit
    }

    /// Returns the runs that made the outputs, that of the shadow bits first.
    pub fn stamps(&self) -> [u64; 3] {
        [
            self.visibility.stamp,
            self.background.stamp,
            self.bounced.stamp,
        ]
    }

    /// Returns the light mixed into the equation's value at a pixel that shows the object.
    pub fn mixture_at(
        &self,
        inputs: &Inputs<'_>,
        coverage: Coverage<'_>,
        [x, y]: [u32; 2],
    ) -> Option<Mixture> {
        let scene = inputs.scene;
        let hits = inputs.hits(Searched::boxes(&self.boxes.output));
        let place = pixel_centre(x as usize, y as usize);
        let hit = if inputs.plan.true_surface {
            hits.of_fragment(place, coverage.fragment_at([x, y])?)
        } else {
            hits.of_triangle(coverage.triangle_at([x, y])?, place)
        };
        let bounces = bouncing(scene).contains(&(x as usize));
        let mut transmission = None;
        if inputs.materials[hit.material].kt > 0.0 {
            let ray = [(0, hit, inputs.lens.ray(place).1.normalize())];
            let world = inputs.world(Searched::boxes(&self.boxes.output), bounces);
            world.transmit(&ray, &mut LightScratch::default(), |_, told| {
                transmission = Some(told);
            });
        }
        let width = scene.image.size[0] as usize;
        let [_, scattered] = self.layers(scene);
        let bounced = scattered
            .get(y as usize * width + x as usize)
            .filter(|_| bounces)
            .map(|light| light.as_dvec3());
        Some(Mixture {
            transmission,
            bounced,
        })
    }
}
