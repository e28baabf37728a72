//! What a frame will do, decided before a pixel is touched: how often each term is evaluated and what is left out.
//!
//! Leaving out never changes a stored pixel. The renderer executes the plan, and the same plan is what is shown to the reader.

use super::surroundings::Surroundings;
use crate::illumination::SpecularForm;
use crate::scene::{
    AmbientSource, Attenuation, Backfacing, Camera, Encoding, FlatAt, Interpolation, Light, LightKind, NormalSource,
    ObjectKind, Overflow, PatternKind, Projection, Rgb, Scene, ShadingMode, Viewer,
};
use glam::DVec3;
use serde::Serialize;

/// How often something is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Per {
    Frame,
    Face,
    Vertex,
    Pixel,
    /// Not at all.
    None,
}

/// One term or step of the plan.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Term {
    pub name: String,
    pub per: Per,
    /// Why it is left out.
    pub omitted: Option<String>,
}

/// Facts about the geometry that the plan depends on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Facts {
    /// Every edge has two faces and they face outwards.
    pub closed: bool,
    pub convex: bool,
    /// A ball that holds the model, world.
    pub centre: DVec3,
    pub radius: f64,
}

/// The plan of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Where the equation is evaluated.
    pub per: Per,
    /// What the equation is evaluated with, or its result, varies over a face.
    pub carries: bool,
    /// The normals that the vertices are given.
    pub normals: NormalSource,
    /// Whether pixels meet the true surface instead of polygons.
    pub true_surface: bool,
    /// Whether pixels are evaluated in double precision.
    pub double: bool,
    /// Back faces are dropped.
    pub cull: bool,
    /// The nearest of several faces is searched.
    pub depth_test: bool,
    /// Interpolation is perspective-correct.
    pub perspective: bool,
    pub scanline: bool,
    pub renormalise: bool,
    pub form: SpecularForm,
    /// For each light of the scene whether it can add anything.
    pub lights: Vec<bool>,
    /// Rays find out which lights reach what is evaluated.
    pub shadows: bool,
    /// Something besides the equation makes up the picture: a floor, a wall, what is seen through the object, light from
    /// other surfaces.
    pub composes: bool,
    /// The display needs to see the whole picture before it can store a pixel.
    pub whole_picture: bool,
    /// Everything above, for the reader.
    pub terms: Vec<Term>,
}

impl Plan {
    /// The plan of `scene` on geometry with `facts`.
    pub fn of(scene: &Scene, facts: &Facts) -> Self {
        let mode = scene.shading.mode;
        let per = match mode {
            ShadingMode::Flat => Per::Face,
            ShadingMode::Interpolated | ShadingMode::Gouraud => Per::Vertex,
            ShadingMode::Phong | ShadingMode::Exact => Per::Pixel,
        };
        let from_file = scene.object.kind == ObjectKind::Obj;
        let true_surface = mode == ShadingMode::Exact && !from_file;
        let outside = !sees_inside(&scene.camera, facts);
        let interpolation =
            if mode == ShadingMode::Exact { Interpolation::Perspective } else { scene.shading.interpolation };
        let composes =
            Surroundings::any(scene) || scene.transparency.kt > 0.0 || scene.ambient.source != AmbientSource::Constant;
        let mut plan = Self {
            per: if mode == ShadingMode::Flat && scene.shading.flat_at != FlatAt::Centre { Per::Vertex } else { per },
            carries: mode != ShadingMode::Flat,
            normals: normals(scene),
            true_surface,
            double: mode == ShadingMode::Exact && from_file,
            cull: facts.closed && outside,
            depth_test: !(facts.convex && facts.closed && outside),
            perspective: interpolation == Interpolation::Perspective
                && scene.camera.projection == Projection::Perspective,
            scanline: interpolation == Interpolation::Scanline && per != Per::Face,
            renormalise: scene.shading.renormalise || mode != ShadingMode::Phong,
            form: SpecularForm::of(scene),
            lights: lights(scene),
            shadows: false,
            composes,
            whole_picture: scene.display.overflow != Overflow::Clamp || composes,
            terms: Vec::new(),
        };
        plan.shadows = casts_shadows(scene, facts, &plan.lights).is_none();
        plan.terms = terms(scene, facts, &plan);
        plan
    }

    /// Whether values are carried from vertices to pixels.
    pub fn interpolates(&self) -> bool {
        self.carries && !self.true_surface && !self.double
    }

    /// Whether rays start from what the pixels see.
    pub(super) fn follows_rays(&self) -> bool {
        self.composes || (self.shadows && self.per == Per::Pixel)
    }

    /// Whether every pixel is brought a normal or an intensity of its own.
    pub(super) fn keeps_fragments(&self) -> bool {
        self.carries && !self.double
    }

    /// The terms that are left out.
    pub fn omissions(&self) -> impl Iterator<Item = &Term> {
        self.terms.iter().filter(|term| term.omitted.is_some())
    }
}

/// The eye may be inside the model, or so near that the near plane opens it.
fn sees_inside(camera: &Camera, facts: &Facts) -> bool {
    let reach = facts.radius * (1.0 + 1e-5) + super::lens::NEAR * camera.distance() * 2.0;
    (camera.eye - facts.centre).length() <= reach
}

fn normals(scene: &Scene) -> NormalSource {
    match scene.shading.mode {
        ShadingMode::Interpolated => NormalSource::Facet,
        _ => scene.object.normals,
    }
}

/// A light without any intensity, or whose light the material takes no part of, adds nothing.
fn lights(scene: &Scene) -> Vec<bool> {
    let material = &scene.material;
    let color = if scene.pattern.kind == PatternKind::None { Rgb::ZERO } else { scene.pattern.color } + material.color;
    let reflects = material.kd * color + material.ks * material.specular_color;
    let soloing = scene.soloing();
    scene.lights.iter().map(|light| light.shines(soloing) && light.color * reflects != Rgb::ZERO).collect()
}

/// Why nothing lies in the shadow of the object.
fn casts_shadows(scene: &Scene, facts: &Facts, lights: &[bool]) -> Option<&'static str> {
    if !scene.shading.shadows {
        return Some("switched off");
    }
    if !lights.contains(&true) {
        return Some("no light shines");
    }
    let alone = facts.convex && facts.closed && !scene.ground.visible;
    alone.then_some("a convex solid casts no shadow on itself")
}

/// Why a light adds nothing.
fn silent(light: &Light, soloing: bool) -> &'static str {
    match light {
        Light { mute: true, .. } => "it is muted",
        light if !light.shines(soloing) => "another light is soloed",
        _ => "it adds nothing: black, or all its light is absorbed",
    }
}

fn term(name: impl Into<String>, per: Per, omitted: Option<&str>) -> Term {
    let per = if omitted.is_some() { Per::None } else { per };
    Term { name: name.into(), per, omitted: omitted.map(str::to_owned) }
}

fn terms(scene: &Scene, facts: &Facts, plan: &Plan) -> Vec<Term> {
    let material = &scene.material;
    let per = plan.per;
    let shining = plan.lights.iter().any(|&kept| kept);
    let ambient = (material.ka * material.color * scene.ambient.color == Rgb::ZERO).then_some("Ka·Ia is 0");
    let diffuse = (material.kd * material.color == Rgb::ZERO).then_some("Kd is 0");
    let specular = (plan.form == SpecularForm::None).then_some("Ks is 0");
    let soloing = scene.soloing();
    let dark = (!shining).then_some("no light shines");
    let mut terms = vec![
        term("ambient", Per::Frame, ambient),
        term("diffuse", per, dark.or(diffuse)),
        term("specular", per, dark.or(specular)),
    ];
    for (index, light) in scene.lights.iter().enumerate() {
        let black = (!plan.lights[index]).then(|| silent(light, soloing));
        terms.push(term(format!("light {index}"), per, black));
        let direction = if light.kind == LightKind::Directional { Per::Frame } else { per };
        terms.push(term(format!("L of light {index}"), direction, black));
        let attenuates = light.attenuation == Attenuation::Viewer
            || (light.attenuation != Attenuation::None && light.kind.has_position());
        let unattenuated = (!attenuates).then_some("its f is 1");
        terms.push(term(format!("attenuation of light {index}"), per, black.or(unattenuated)));
    }
    terms.push(term("shadows", per, casts_shadows(scene, facts, &plan.lights)));
    let opaque = (scene.transparency.kt == 0.0).then_some("Kt is 0");
    terms.push(term("transmission", Per::Pixel, opaque));
    let nothing = (!Surroundings::any(scene)).then_some("the background is plain");
    terms.push(term("surroundings", Per::Pixel, nothing));
    let constant = (scene.ambient.source == AmbientSource::Constant).then_some("Ia is constant");
    terms.push(term("one bounce", Per::Pixel, constant));
    let unused_view = dark.or(specular);
    let view = if scene.camera.viewer == Viewer::Infinite { Per::Frame } else { per };
    terms.push(term("V", view, unused_view));
    terms.push(term("normal flipping", per, (scene.reflection.backfacing == Backfacing::Clamp).then_some("clamped")));
    let evaluated_at_pixels = matches!(scene.shading.mode, ShadingMode::Phong);
    let unit = (!evaluated_at_pixels).then_some("the normals are unit vectors by construction");
    let forgotten = (!scene.shading.renormalise).then_some("switched off");
    terms.push(term("renormalisation", Per::Pixel, unit.or(forgotten)));
    terms.push(term("back faces", Per::Face, plan.cull.then_some("a closed solid hides them")));
    terms.push(term("depth test", Per::Pixel, (!plan.depth_test).then_some("a convex solid shows one layer")));
    let linear = (scene.display.encoding == Encoding::Raw).then_some("raw: value × 255");
    terms.push(term("sRGB encoding", Per::Pixel, linear));
    terms
}
