//! The plan of a frame, made before a pixel is touched: where the equation is evaluated and what is left out; and the
//! inputs of its steps.
//!
//! Leaving out never changes a stored pixel (`tests/engine/omissions.rs`). The renderer executes the plan; `account.rs`
//! explains it to the reader, term by term.

use crate::geometry::Surface;
use crate::illumination::{Equation, Scalar, SpecularForm, lights_backs};
use crate::render::face_materials::{any_transmits, for_each_material};
use crate::render::lens::{Lens, NEAR};
use crate::render::model::Model;
use crate::render::raster::Triangles;
use crate::render::rays::{Visibility, World};
use crate::scene::{
    AmbientSource, Camera, CuedBy, FaceMaterial, FlatAt, Interpolation, Light, LightKind,
    NormalSource, Overflow, PatternKind, Projection, Rgb, Scene, ShadingMode,
};
use crate::text::Message;
use fearless_simd::Level;
use glam::DVec3;
use serde::Serialize;

/// The frequency of an evaluation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Per {
    /// Once for each picture.
    Frame,
    /// Once for each light.
    Light,
    /// Once for each face.
    Face,
    /// Once for each vertex.
    Vertex,
    /// Once for each pixel that shows the object.
    Pixel,
    /// No evaluation at all.
    None,
}

/// The points where the intensity fades with the depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Cued {
    /// No fading: depth cueing is off, or changes nothing.
    Nowhere,
    /// The points where the equation is evaluated, at vertices or faces: the intensity fades before it is carried to the pixels.
    AtPoints,
    /// The pixels, with s0 found at the vertices and carried to the pixels.
    AtVertices,
    /// The pixels, with s0 found at each of them.
    AtPixels,
}

/// The plan of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The points where the equation is evaluated.
    pub per: Per,
    /// True if the equation's input, or its result, varies over a face.
    pub carries: bool,
    /// True if pixels show the true surface instead of polygons.
    pub true_surface: bool,
    /// True if the equation is evaluated in double precision.
    pub double: bool,
    /// True if back faces are dropped.
    pub cull: bool,
    /// True if the nearest of several faces is searched for.
    pub depth_test: bool,
    /// True if interpolation is perspective-correct.
    pub perspective: bool,
    /// True if interpolation goes along the edges and then along the rows, as in Gouraud 1971.
    pub scanline: bool,
    /// True if interpolated normals are scaled to unit length before the equation is evaluated.
    pub renormalise: bool,
    /// For each light of the scene, true if it can add anything.
    pub lights: Vec<bool>,
    /// True if rays determine which lights reach the shading points.
    pub shadows: bool,
    /// True if a floor, a wall, the view through the object or light from other surfaces is mixed with the equation's value.
    pub composes: bool,
    /// The points where depth cueing applies.
    pub cued: Cued,
    /// True if the display needs the whole picture before it can store a pixel.
    pub whole_picture: bool,
    /// True if work that cannot change a stored pixel is left out.
    pub leaves_out: bool,
    /// The pixels of a side of the picture that this one stands for, over its own.
    pub coarser: u32,
}

impl Plan {
    /// Creates the plan of `scene` on the geometry of `model`.
    pub fn for_scene(scene: &Scene, model: &Model) -> Self {
        let mode = scene.shading.mode;
        let per = match mode {
            ShadingMode::Flat if scene.shading.flat_at == FlatAt::Centre => Per::Face,
            ShadingMode::Flat | ShadingMode::Interpolated | ShadingMode::Gouraud => Per::Vertex,
            ShadingMode::Phong | ShadingMode::Exact => Per::Pixel,
        };
        let true_surface = Self::shows_surface(scene);
        let outside = !sees_inside(&scene.camera, model);
        let interpolation = if mode == ShadingMode::Exact {
            Interpolation::Perspective
        } else {
            scene.shading.interpolation
        };
        let composes = World::has_surroundings(scene)
            || any_transmits(&model.face_materials.materials(scene))
            || scene.ambient.source != AmbientSource::Constant;
        let mut plan = Self {
            per,
            carries: mode != ShadingMode::Flat,
            true_surface,
            double: (mode == ShadingMode::Exact && !true_surface) || stiff(scene, model).is_some(),
            cull: model.closed && outside,
            depth_test: !(model.convex && model.closed && outside),
            perspective: interpolation == Interpolation::Perspective
                && scene.camera.projection == Projection::Perspective,
            scanline: interpolation == Interpolation::Scanline && mode != ShadingMode::Flat,
            renormalise: scene.shading.renormalise || mode != ShadingMode::Phong,
            lights: silences(scene, model).iter().map(Option::is_none).collect(),
            shadows: false,
            composes,
            cued: Cued::Nowhere,
            whole_picture: scene.display.overflow != Overflow::Clamp || composes,
            leaves_out: true,
            coarser: 1,
        };
        plan.shadows = casts_shadows(scene, model, &plan.lights).is_none();
        if not_cued(scene, model).is_none() {
            plan.cued = cued(scene, per);
        }
        plan.whole_picture |= matches!(plan.cued, Cued::AtVertices | Cued::AtPixels);
        plan
    }

    /// Returns the source of the vertices' normals.
    pub fn normals(scene: &Scene) -> NormalSource {
        match scene.shading.mode {
            ShadingMode::Interpolated => NormalSource::Facet,
            _ => scene.object.normal_source(),
        }
    }

    /// Returns whether pixels show the true surface instead of polygons.
    pub fn shows_surface(scene: &Scene) -> bool {
        scene.shading.mode == ShadingMode::Exact && scene.object.kind.has_surface()
    }

    /// Restores lights that add nothing, back faces, the depth test, and rays to lights that nothing can hide.
    pub fn leave_nothing_out(&mut self, scene: &Scene) {
        self.lights.fill(true);
        (self.cull, self.depth_test) = (false, true);
        self.shadows = scene.shading.shadows && !scene.lights.is_empty();
        self.leaves_out = false;
    }

    /// Returns whether pixels are evaluated one by one in double precision.
    pub fn pixels_in_double(&self) -> bool {
        self.double && self.per == Per::Pixel
    }

    /// Returns whether values are carried from vertices to pixels.
    pub fn interpolates(&self) -> bool {
        self.carries && !self.true_surface && !self.pixels_in_double()
    }

    /// Returns whether rays start from the points that pixels show.
    pub fn follows_rays(&self) -> bool {
        self.composes || (self.shadows && self.per == Per::Pixel)
    }

    /// Returns whether s0 is needed at each pixel.
    pub fn cues_pixels(&self) -> bool {
        match self.cued {
            Cued::Nowhere => false,
            Cued::AtPoints => self.composes,
            Cued::AtVertices | Cued::AtPixels => true,
        }
    }

    /// Returns whether every pixel gets a normal or an intensity of its own.
    pub fn has_fragments(&self) -> bool {
        self.carries && (self.true_surface || !self.pixels_in_double())
    }

    /// Returns whether the fragments are kept: normals can be reused when only the equation's numbers change; intensities
    /// change with them.
    pub fn keeps_fragments(&self) -> bool {
        self.has_fragments() && self.per == Per::Pixel
    }
}

/// The inputs of a frame's steps, and of later evaluations of its pixels.
#[derive(Clone, Copy)]
pub struct Inputs<'a> {
    pub level: Level,
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    pub lens: &'a Lens,
    /// The materials, in the order of the model's [`FaceMaterials`](crate::render::FaceMaterials).
    pub materials: &'a [FaceMaterial],
    pub triangles: Triangles<'a>,
    pub surface: Option<&'a Surface>,
    /// The visibility of sources from pixels, faces or vertices, where there are shadows.
    pub visibility: Option<&'a Visibility>,
}

impl Inputs<'_> {
    /// Returns the equation of each material in double precision with the lights that the picture is shaded with.
    pub fn equations(&self) -> Vec<Equation<f64>> {
        equations(
            self.scene,
            self.materials,
            self.lens.unit,
            &self.plan.lights,
        )
    }

    /// Returns the number of the points where the equation is evaluated, faces or vertices.
    pub fn point_count(&self) -> usize {
        let model = self.triangles.model;
        if self.plan.per == Per::Face {
            model.face_count()
        } else {
            model.vertex_count
        }
    }

    /// Returns the material of each point where the equation is evaluated, a face or a vertex; empty where there is one.
    pub fn point_materials(&self) -> &[u16] {
        let model = self.triangles.model;
        if self.plan.per == Per::Face {
            &model.face_materials.faces
        } else {
            &model.vertex_materials
        }
    }

    /// Returns s0 at a point, world; 1 where nothing fades.
    pub fn scale(&self, point: DVec3) -> f64 {
        if self.plan.cued == Cued::Nowhere {
            return 1.0;
        }
        self.scene
            .depth_cueing
            .scale_at((point - self.lens.eye).dot(self.lens.forward))
    }
}

/// Returns the equation of each material, lengths in units of `unit`, with the lights that `kept` names.
pub fn equations<T: Scalar>(
    scene: &Scene,
    materials: &[FaceMaterial],
    unit: f64,
    kept: &[bool],
) -> Vec<Equation<T>> {
    for_each_material(scene, materials, |scene| {
        let mut equation = Equation::in_units(scene, unit);
        equation.retain_lights(|light| kept[light]);
        equation
    })
}

/// The reason why work that needs lights is left out.
pub const NO_LIGHT: Message = Message("render-why-no-light");

/// The n beyond which the rounding of unit vectors in single precision is visible in the highlight.
const STIFF_FROM: f64 = 1e7;
/// The eye's distance, in radii, from which positions relative to it have fewer digits than the model needs.
const FAR_FROM: f64 = 1e4;

/// Tells why single precision is not enough for the equation, if it is not.
pub fn stiff(scene: &Scene, model: &Model) -> Option<Message> {
    let too_large = for_each_material(scene, &model.face_materials.materials(scene), |scene| {
        let powers = matches!(
            SpecularForm::of(scene),
            SpecularForm::PhongCosine
                | SpecularForm::PhongChord
                | SpecularForm::BlinnCosine
                | SpecularForm::BlinnChord
        );
        (powers || scene.reflection.is_own_law()) && scene.material.n > STIFF_FROM
    });
    if too_large.contains(&true) {
        return Some(Message("render-why-n-too-large"));
    }
    let far = model.radius > 0.0 && scene.camera.distance() > FAR_FROM * model.radius;
    far.then_some(Message("render-why-eye-far"))
}

/// Returns whether the eye may be inside the model, or so near that the near plane opens it.
fn sees_inside(camera: &Camera, model: &Model) -> bool {
    let reach = model.radius * (1.0 + 1e-5) + NEAR * model.unit(camera) * 2.0;
    (camera.eye - model.origin).length() <= reach
}

/// Tells why each light adds nothing, if it adds nothing.
pub fn silences(scene: &Scene, model: &Model) -> Vec<Option<Message>> {
    let (soloing, pattern) = (scene.soloing(), &scene.pattern);
    let other = if pattern.kind == PatternKind::None {
        Rgb::ZERO
    } else {
        pattern.color
    };
    // The largest part of a light that any material reflects, diffuse and specular together.
    let reflected = model
        .face_materials
        .materials(scene)
        .iter()
        .map(|FaceMaterial { material: own, .. }| {
            if scene.reflection.is_own_law() {
                // A law of one's own may reflect light whatever these numbers are.
                return Rgb::ONE;
            }
            own.kd * (own.color + other) + own.ks * own.specular_color
        })
        .fold(Rgb::ZERO, Rgb::max);
    let silence = |light: &Light| match light {
        Light { mute: true, .. } => Some(Message("render-why-muted")),
        _ if !light.shines(soloing) => Some(Message("render-why-not-soloed")),
        _ if light.color == Rgb::ZERO => Some(Message("render-why-black-light")),
        _ if light.color * reflected == Rgb::ZERO => Some(Message("render-why-not-reflected")),
        _ => misses(scene, model, light).then_some(Message("render-why-cone-misses")),
    };
    scene.lights.iter().map(silence).collect()
}

/// The angle, radians, by which a cone must miss the model, and the part of the distances that single precision has to
/// represent by which its light must be away from it: no rounding of L, which is then below 10⁻³, reaches that far.
const CONE_MARGIN: f64 = 0.01;
const NEAREST_CONE: f64 = 1e-3;

/// Returns whether the whole model lies outside a spot light's cone.
fn misses(scene: &Scene, model: &Model, light: &Light) -> bool {
    let polygons = scene.shading.mode != ShadingMode::Exact
        && scene.shading.interpolation == Interpolation::Perspective;
    // The true surface bulges out of its polygons, and other interpolations take points off them.
    let radius = model.radius * if polygons { 1.0 + 1e-5 } else { 3.0 };
    let way = model.origin - light.position;
    let from_eye = (light.position - scene.camera.eye).length();
    let (distance, axis) = (way.length(), light.direction.normalize_or_zero());
    let spread = from_eye + distance + radius;
    if light.kind != LightKind::Spot || axis == DVec3::ZERO || !spread.is_finite() {
        return false;
    }
    // Lights farther than this may be treated as parallel.
    let near = from_eye < 1e8 * scene.camera.distance();
    let clear = distance - radius > NEAREST_CONE * spread;
    let between = (axis.dot(way) / distance).clamp(-1.0, 1.0).acos();
    near && clear && between - (radius / distance).asin() > light.cone.to_radians() + CONE_MARGIN
}

/// Tells why nothing lies in the shadow of the object.
pub fn casts_shadows(scene: &Scene, model: &Model, lights: &[bool]) -> Option<Message> {
    if !scene.shading.shadows {
        return Some(Message("render-why-switched-off"));
    }
    if !lights.contains(&true) {
        return Some(NO_LIGHT);
    }
    // Where surfaces turned away are lit all the same, the solid stands between them and the light.
    let clamped = !lights_backs(&scene.reflection);
    let alone = model.convex && model.closed && !scene.ground.visible && clamped;
    alone.then_some(Message("render-why-convex-no-shadow"))
}

/// Tells why nothing fades with the depth.
pub fn not_cued(scene: &Scene, model: &Model) -> Option<Message> {
    let cueing = &scene.depth_cueing;
    if cueing.by == CuedBy::Off {
        return Some(Message("render-why-switched-off"));
    }
    if cueing.front_scale == 1.0 && cueing.back_scale == 1.0 {
        return Some(Message("render-why-cue-without-effect"));
    }
    let forward = (scene.camera.target - scene.camera.eye).normalize_or_zero();
    let middle = (model.origin - scene.camera.eye).dot(forward);
    // The ball holds the model but for a rounding.
    let farthest = middle + model.radius * (1.0 + 1e-5);
    let near = cueing.front_scale == 1.0 && farthest + middle.abs() * 1e-9 < cueing.front;
    near.then_some(Message("render-why-cue-beyond"))
}

/// Returns the points where s0 is evaluated, for an equation evaluated at the frequency `per`.
fn cued(scene: &Scene, per: Per) -> Cued {
    match (scene.depth_cueing.by, scene.shading.mode) {
        (CuedBy::Off, _) => Cued::Nowhere,
        (CuedBy::Pixel, _) | (_, ShadingMode::Exact) => Cued::AtPixels,
        (CuedBy::Vertex, _) if per == Per::Pixel => Cued::AtVertices,
        (CuedBy::Vertex, _) => Cued::AtPoints,
    }
}
