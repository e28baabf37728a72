//! The scene as plain data: camera, object, material, lights and settings.
//!
//! A [`Scene`] is read from a scene file, edited in the window and used by every other part of the program. Lengths
//! are world units, angles degrees, intensities linear with 1 the display's white. The types hold any number; a scene
//! that came through [`Scene::parse`], [`Scene::with_override`] or [`Scene::validate`] is valid (see there).

mod access;
pub mod camera;
mod choice;
pub mod compare;
mod face_material;
mod format;
mod law;
pub mod light;
pub mod material;
mod material_override;
pub mod materials;
mod model_materials;
pub mod object;
mod overrides;
pub mod parameter;
mod place;
mod polygons;
pub mod presets;
mod problem;
mod setting;
pub mod shading;
mod shared;
mod short;
pub mod surroundings;
mod symbol;
mod validation;
mod view;

pub use crate::text::{did_you_mean, nearest};
pub use camera::{
    Camera, Display, Encoding, Framing, Image, Overflow, Projection, SceneDescription, Viewer,
};
pub(crate) use choice::choices;
pub use choice::{Choice, ChoiceOption};
pub use compare::{Compare, CompareView, DifferenceKind, Pane};
pub use face_material::FaceMaterial;
pub use format::Coefficient;
pub use law::{LAW_NUMBERS, LAW_VECTORS};
pub use light::{AreaShape, Attenuation, Light, LightKind};
pub use material::{
    Ambient, AmbientSource, Backfacing, Distribution, Material, MaterialSource, Pattern,
    PatternKind, Reflectance, Reflection, ReflectionModel, Through, Transparency,
};
pub use material_override::MaterialOverride;
pub use object::{NormalSource, Object, ObjectKind, Weighting};
pub use parameter::{GREATEST_INTENSITY, GREATEST_LENGTH, LEAST_LENGTH};
pub(crate) use place::{pixel_to_place, place_to_pixel};
pub use polygons::Polygons;
pub(crate) use polygons::area_vector;
pub use problem::{Cause, Problem, ProblemLocation, SceneError};
pub use setting::setting_words;
pub use shading::{FlatAt, Interpolation, Shading, ShadingMode};
pub use shared::Shared;
pub use surroundings::{Backdrop, CuedBy, DepthCueing, Ground};
pub use symbol::Symbol;
pub use view::View;
pub(crate) use view::direction;

/// Red, green and blue, linear.
pub type Rgb = glam::DVec3;

/// Defines the scene by its tables, in the order of the scene file.
macro_rules! scene {
    ($(#[$about:meta])* pub struct Scene { $($(#[$detail:meta])* $field:ident: $table:ident,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct Scene {
            /// The version of the file format; 1.
            pub version: u32,
            $($(#[$detail])* pub $field: $table,)+
            /// The lights, whose contributions are summed. A file without any `[[light]]` gets the default one; `light = []` means
            /// darkness.
            pub lights: Vec<Light>,
        }

        impl Default for Scene {
            fn default() -> Self {
                Self { version: Self::VERSION, $($field: $table::default(),)+ lights: vec![Light::default()] }
            }
        }

        /// The parameters of each table, in the order of the scene file.
        const TABLES: &[&[&parameter::Parameter]] = &[$($table::PARAMETERS,)+ Pane::PARAMETERS, MaterialOverride::PARAMETERS, Light::PARAMETERS];
    };
}

scene! {
    /// Everything that a picture depends on.
    ///
    /// Fields can be set directly; [`Scene::validate`] then reports what is wrong. [`Scene::parse`], [`Scene::to_toml`] and
    /// [`Scene::with_overrides`] use the keys of [`parameter`].
    ///
    /// ```
    /// use shading_lab::scene::{LightKind, Scene};
    ///
    /// let mut scene = Scene::parse("[material]\nn = 80\n", "mine.toml")?;
    /// scene.lights[0].kind = LightKind::Directional;
    /// let scene = scene.with_override("shading.mode=gouraud")?;
    /// scene.validate()?;
    ///
    /// let again = Scene::parse(&scene.to_toml(), "again.toml")?;
    /// assert_eq!(again, scene);
    ///
    /// let error = Scene::parse("[material]\nm = 80\n", "mine.toml").expect_err("there is no such key");
    /// assert!(error.to_string().starts_with("mine.toml:2"));
    /// # Ok::<(), shading_lab::scene::SceneError>(())
    /// ```
    pub struct Scene {
        /// `[about]`: title, sentence and topic.
        about: SceneDescription,
        /// `[camera]`: the eye and its projection.
        camera: Camera,
        /// `[image]`: its size and background.
        image: Image,
        /// `[display]`: the conversion of intensities to stored values.
        display: Display,
        /// `[object]`: the shape and its polygons.
        object: Object,
        /// `[material]`: the coefficients of the equation.
        material: Material,
        /// `[reflection]`: the specular model, and the policy for the side away from a light.
        reflection: Reflection,
        /// `[ambient]`: the light that arrives from all sides.
        ambient: Ambient,
        /// `[pattern]`: a second colour of the surface.
        pattern: Pattern,
        /// `[transparency]`: light that passes through the surface.
        transparency: Transparency,
        /// `[shading]`: the points where the equation is evaluated, and shadows.
        shading: Shading,
        /// `[ground]`: a level floor.
        ground: Ground,
        /// `[backdrop]`: a patterned wall behind the object.
        backdrop: Backdrop,
        /// `[depth_cueing]`: fading with the depth.
        depth_cueing: DepthCueing,
        /// `[compare]`: panes that differ in some keys.
        compare: Compare,
    }
}
