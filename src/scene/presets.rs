//! The built-in scenes: one of each shape, and one for each thing to look at.

mod beyond;
mod defects;
mod light;
mod reflection;
mod shading;
mod shapes;
mod studio;

use super::Scene;

/// A scene that comes with the program.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// What the command line calls it: lower-case words with hyphens.
    pub name: &'static str,
    /// A heading.
    pub title: &'static str,
    /// What it belongs to.
    pub topic: &'static str,
    /// What there is to see, in a sentence.
    pub description: &'static str,
    /// Makes the scene.
    pub build: fn() -> Scene,
}

/// The name of the scene shown when none is named.
pub const DEFAULT: &str = "teapot";

/// Every built-in scene, by topic.
pub const ALL: &[Preset] = &[
    Preset {
        name: "sphere",
        title: "Sphere",
        topic: "Shapes",
        description: "The simplest curved surface: every normal is a radius, every term shows its own shape.",
        build: shapes::sphere,
    },
    Preset {
        name: "torus",
        title: "Torus",
        topic: "Shapes",
        description: "A ring with two highlights: one on the outside, one where it is hollow.",
        build: shapes::torus,
    },
    Preset {
        name: "cylinder",
        title: "Cylinder",
        topic: "Shapes",
        description: "Curved in one direction only: the highlight becomes a stripe.",
        build: shapes::cylinder,
    },
    Preset {
        name: "cone",
        title: "Cone",
        topic: "Shapes",
        description: "The apex has no normal of its own: the highlight runs into it and ends.",
        build: shapes::cone,
    },
    Preset {
        name: "cube",
        title: "Cube",
        topic: "Shapes",
        description: "Flat faces and sharp edges: here each polygon's own normal is the right one.",
        build: shapes::cube,
    },
    Preset {
        name: "plane",
        title: "Plane",
        topic: "Shapes",
        description: "One normal everywhere: all that varies are the directions to the light and to the viewer.",
        build: shapes::plane,
    },
    Preset {
        name: "teapot",
        title: "Teapot",
        topic: "Shapes",
        description: "Newell's teapot, 32 bicubic patches, glazed, under a warm lamp and a cool window.",
        build: shapes::teapot,
    },
    Preset {
        name: "highlight",
        title: "A highlight inside a polygon",
        topic: "Shading",
        description: "One large square with a lamp before its middle: Gouraud's method loses the highlight.",
        build: shading::highlight,
    },
    Preset {
        name: "flat-facets",
        title: "Facets",
        topic: "Shading",
        description: "A coarse sphere, one shade a polygon: at every edge Mach bands make the lighter side look lighter, the darker side darker.",
        build: shading::flat_facets,
    },
    Preset {
        name: "mach-bands",
        title: "Mach bands",
        topic: "Shading",
        description: "A column of 16 sides under Gouraud shading: the slope of the light jumps at each edge, and the eye sees bright and dark stripes.",
        build: shading::mach_bands,
    },
    Preset {
        name: "silhouette",
        title: "The outline stays polygonal",
        topic: "Shading",
        description: "A ball of 9 by 6 polygons: smooth inside under Gouraud or Phong shading, angular at its rim.",
        build: defects::silhouette,
    },
    Preset {
        name: "perspective-distortion",
        title: "Perspective distortion",
        topic: "Shading",
        description: "Stripes of light on a receding floor, interpolated in the picture: half-way there is not half-way on the floor, and they bend at every diagonal.",
        build: defects::perspective_distortion,
    },
    Preset {
        name: "orientation",
        title: "Dependence on orientation",
        topic: "Shading",
        description: "A square lit at two corners, interpolated along scan lines: turn camera.roll, and its shades change.",
        build: defects::orientation,
    },
    Preset {
        name: "shared-vertices",
        title: "A vertex that is not shared",
        topic: "Shading",
        description: "A lamp before a wall of three polygons: two have a vertex under it, the third does not, and the light jumps at their edge.",
        build: defects::shared_vertices,
    },
    Preset {
        name: "vertex-normals",
        title: "Unrepresentative vertex normals",
        topic: "Shading",
        description: "A sheet folded to and fro: the averaged normals at its folds are all alike, and it looks flat; more rings bring the folds back.",
        build: defects::vertex_normals,
    },
    Preset {
        name: "depth-cueing",
        title: "Mist",
        topic: "Shading",
        description: "One long polygon runs into mist: cued at its corners it fades from end to end, cued by pixel only where the mist lies.",
        build: shading::depth_cueing,
    },
    Preset {
        name: "ambient-only",
        title: "Ambient light alone",
        topic: "Light",
        description: "The same light from everywhere: one shade all over, and the shape is gone.",
        build: light::ambient_only,
    },
    Preset {
        name: "sun",
        title: "Parallel rays",
        topic: "Light",
        description: "A directional light: every shadow has the same direction, and a plane has one diffuse shade.",
        build: light::sun,
    },
    Preset {
        name: "spotlight",
        title: "A spotlight",
        topic: "Light",
        description: "A cone of light with a soft edge, brightest along its axis; its handles turn it and open it.",
        build: light::spotlight,
    },
    Preset {
        name: "soft-shadow",
        title: "A light with an area",
        topic: "Light",
        description: "A window of 64 point samples: half of it hidden is half a shadow.",
        build: light::soft_shadow,
    },
    Preset {
        name: "three-lights",
        title: "Key, fill and rim",
        topic: "Light",
        description: "A photographer's three lights on a ring: their contributions are added.",
        build: light::three_lights,
    },
    Preset {
        name: "colored-lights",
        title: "Red, green and blue lamps",
        topic: "Light",
        description: "A white sphere under three primary colours: each channel is an equation of its own.",
        build: light::colored_lights,
    },
    Preset {
        name: "attenuation",
        title: "Light that falls off",
        topic: "Light",
        description: "A lamp close above a plane, weaker with the square of the distance.",
        build: light::attenuation,
    },
    Preset {
        name: "attenuation-quadratic",
        title: "Fall-off by three constants",
        topic: "Light",
        description: "A long floor under min(1, 1/(c1 + c2·d + c3·d²)): never brighter than the lamp itself, however near.",
        build: light::quadratic,
    },
    Preset {
        name: "attenuation-viewer",
        title: "Fall-off to the viewer",
        topic: "Light",
        description: "The older textbooks weaken light by the distance to the eye: 1/(r + k) makes what is near brighter.",
        build: light::to_the_viewer,
    },
    Preset {
        name: "infinite",
        title: "Light and viewer at infinity",
        topic: "Light",
        description: "L and V are constant, as the textbooks assume: a plane would have one shade.",
        build: light::infinite,
    },
    Preset {
        name: "matt",
        title: "Lambert's law alone",
        topic: "Reflection",
        description: "Diffuse light only: brightness is the cosine between N and L, from wherever it is seen.",
        build: reflection::matt,
    },
    Preset {
        name: "blinn",
        title: "The half-way vector",
        topic: "Reflection",
        description: "Blinn's (N·H)^n at a grazing angle: a streak towards the viewer, where Phong's highlight stays round.",
        build: reflection::blinn,
    },
    Preset {
        name: "tinted-highlight",
        title: "A coloured highlight",
        topic: "Reflection",
        description: "Os gives the highlight a colour of its own: that is what tells metal from plastic.",
        build: reflection::tinted_highlight,
    },
    Preset {
        name: "mirror-like",
        title: "Nearly a mirror",
        topic: "Reflection",
        description: "n = 1005: the highlights shrink to images of the lamps.",
        build: reflection::mirror_like,
    },
    Preset {
        name: "gold",
        title: "Gold",
        topic: "Reflection",
        description: "W(θ) by Fresnel from the measured index of gold: yellow at the front, white at grazing angles.",
        build: reflection::gold,
    },
    Preset {
        name: "glass-rim",
        title: "A glass ball, its reflection only",
        topic: "Reflection",
        description: "W(θ) of glass: 4 % of the light that falls straight on, nearly all of what grazes.",
        build: reflection::glass_rim,
    },
    Preset {
        name: "microfacets",
        title: "Microfacets",
        topic: "Reflection",
        description: "Cook and Torrance's model: rough copper, with a highlight that grows towards the rim.",
        build: reflection::microfacets,
    },
    Preset {
        name: "two-sided",
        title: "A surface with two sides",
        topic: "Reflection",
        description: "The square is seen from behind: only with N turned about is it lit at all.",
        build: reflection::two_sided,
    },
    Preset {
        name: "overflow",
        title: "Too much light",
        topic: "Reflection",
        description: "Two bright lamps: what is above 1 is hatched, not clipped in silence.",
        build: reflection::overflow,
    },
    Preset {
        name: "brass",
        title: "Brass",
        topic: "Reflection",
        description: "The numbers that OpenGL's programmers have used for brass since 1993.",
        build: reflection::brass,
    },
    Preset {
        name: "opengl",
        title: "As OpenGL would",
        topic: "Reflection",
        description: "Gouraud shading with (N·H)^n at a polygon's vertices: what glLight and glMaterial say, drawn alike.",
        build: reflection::opengl,
    },
    Preset {
        name: "checker",
        title: "A pattern",
        topic: "Reflection",
        description: "Od changes from field to field, the highlight does not: it has the light's colour.",
        build: reflection::checker,
    },
    Preset {
        name: "rings",
        title: "Rings",
        topic: "Reflection",
        description: "Coloured shells about the axis, cut by the surface.",
        build: reflection::rings,
    },
    Preset {
        name: "shadows",
        title: "Shadows",
        topic: "Between surfaces",
        description: "A ring over a floor: what the illumination equation leaves out, put in.",
        build: beyond::shadows,
    },
    Preset {
        name: "glass-ball",
        title: "A glass ball",
        topic: "Between surfaces",
        description: "Refracted twice, the pattern behind stands on its head, squeezed together towards the rim: a ray that enters a ball always leaves it.",
        build: beyond::glass_ball,
    },
    Preset {
        name: "one-surface",
        title: "One surface of glass",
        topic: "Between surfaces",
        description: "The ray is bent once: what lies behind is inside the glass as well.",
        build: beyond::one_surface,
    },
    Preset {
        name: "under-water",
        title: "From under water",
        topic: "Between surfaces",
        description: "η = 1/1.33, seen from below: the world above fits in a circle; beyond 48.8° from the normal all light is reflected, and the surface mirrors the dark water.",
        build: beyond::under_water,
    },
    Preset {
        name: "one-bounce",
        title: "What Ia stands for",
        topic: "Between surfaces",
        description: "Left the constant ambient term, right the light that ball and floor really throw at each other.",
        build: beyond::one_bounce,
    },
];

/// The built-in scene of that name.
pub fn find(name: &str) -> Option<&'static Preset> {
    ALL.iter().find(|preset| preset.name == name)
}

/// What the built-in scenes are about, each once, in their order.
pub fn topics() -> Vec<&'static str> {
    let mut topics: Vec<_> = ALL.iter().map(|preset| preset.topic).collect();
    topics.dedup();
    topics
}

/// The scene shown when none is named.
pub fn default_scene() -> Scene {
    shapes::teapot()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::ObjectKind;

    #[test]
    fn every_scene_is_sound_and_survives_its_file() {
        for preset in ALL {
            let scene = (preset.build)();
            assert_eq!(scene.validate(), Ok(()), "{}", preset.name);
            assert_eq!(Scene::parse(&scene.to_toml(), preset.name), Ok(scene), "{}", preset.name);
        }
    }

    #[test]
    fn every_name_is_its_own_and_typed_easily() {
        for preset in ALL {
            assert!(preset.name.chars().all(|c| c.is_ascii_lowercase() || c == '-'), "{}", preset.name);
            assert_eq!(find(preset.name).map(|found| found.title), Some(preset.title));
            assert!(!preset.title.is_empty() && preset.description.ends_with('.'), "{}", preset.name);
        }
        let mut sorted = topics();
        sorted.sort_unstable();
        sorted.dedup();
        assert_eq!(sorted.len(), topics().len(), "scenes of a topic stand together");
    }

    #[test]
    fn the_default_is_one_of_them_and_so_is_every_shape_without_a_file() {
        assert_eq!(find(DEFAULT).map(|preset| (preset.build)()), Some(default_scene()));
        let shapes: Vec<_> = ALL.iter().map(|preset| (preset.build)().object.kind).collect();
        use ObjectKind::{Cone, Corrugated, Cube, Cylinder, Plane, Polygons, Sphere, Teapot, Torus};
        for kind in [Sphere, Torus, Cylinder, Cone, Cube, Plane, Teapot, Corrugated, Polygons] {
            assert!(shapes.contains(&kind), "{kind:?}");
        }
    }
}
