//! The built-in scenes: one of each shape, and one for each thing to look at.

use super::{
    Ambient, Attenuation, Camera, FlatAt, Image, Light, LightKind, Material, NormalSource, Object, ObjectKind,
    Reflection, ReflectionModel, Rgb, Scene, Shading, ShadingMode, Viewer,
};
use glam::DVec3;

/// A scene that comes with the program.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// What the command line calls it: lower-case words with hyphens.
    pub name: &'static str,
    /// A heading.
    pub title: &'static str,
    /// What there is to see, in a sentence.
    pub description: &'static str,
    /// Makes the scene.
    pub build: fn() -> Scene,
}

/// The name of the scene shown when none is named.
pub const DEFAULT: &str = "teapot";

/// Every built-in scene: the shapes first.
pub const ALL: &[Preset] = &[
    Preset {
        name: "sphere",
        title: "Sphere",
        description: "The simplest curved surface: every normal is a radius, every term shows its own shape.",
        build: sphere,
    },
    Preset {
        name: "torus",
        title: "Torus",
        description: "A ring with two highlights: one on the outside, one where it is hollow.",
        build: torus,
    },
    Preset {
        name: "cylinder",
        title: "Cylinder",
        description: "Curved in one direction only: the highlight becomes a stripe.",
        build: cylinder,
    },
    Preset {
        name: "cone",
        title: "Cone",
        description: "The apex has no normal of its own: the highlight runs into it and ends.",
        build: cone,
    },
    Preset {
        name: "cube",
        title: "Cube",
        description: "Flat faces and sharp edges: here each polygon's own normal is the right one.",
        build: cube,
    },
    Preset {
        name: "plane",
        title: "Plane",
        description: "One normal everywhere: all that varies comes from the light's and the viewer's distance.",
        build: plane,
    },
    Preset {
        name: "teapot",
        title: "Teapot",
        description: "Newell's teapot, 32 bicubic patches, glazed, under a warm lamp and a cool window.",
        build: teapot,
    },
    Preset {
        name: "highlight",
        title: "A highlight inside a polygon",
        description: "One large square with a lamp before its middle: Gouraud's method loses the highlight.",
        build: highlight,
    },
    Preset {
        name: "flat-facets",
        title: "Facets",
        description: "A coarse sphere, one shade a polygon: Mach bands make every edge look brighter than it is.",
        build: flat_facets,
    },
    Preset {
        name: "mirror-like",
        title: "Nearly a mirror",
        description: "n = 1005: the highlights shrink to images of the lamps.",
        build: mirror_like,
    },
    Preset {
        name: "three-lights",
        title: "Key, fill and rim",
        description: "A photographer's three lights on a ring: their contributions are added.",
        build: three_lights,
    },
    Preset {
        name: "colored-lights",
        title: "Red, green and blue lamps",
        description: "A white sphere under three primary colours: each channel is an equation of its own.",
        build: colored_lights,
    },
    Preset {
        name: "attenuation",
        title: "Light that falls off",
        description: "A lamp close above a plane, weaker with the square of the distance.",
        build: attenuation,
    },
    Preset {
        name: "blinn",
        title: "The half-way vector",
        description: "Blinn's (N·H)^n at a grazing angle: a streak towards the viewer, where Phong's highlight stays round.",
        build: blinn,
    },
    Preset {
        name: "infinite",
        title: "Light and viewer at infinity",
        description: "L and V are constant, as the textbooks assume: a plane would have one shade.",
        build: infinite,
    },
];

/// The built-in scene of that name.
pub fn find(name: &str) -> Option<&'static Preset> {
    ALL.iter().find(|preset| preset.name == name)
}

/// The scene shown when none is named.
pub fn default_scene() -> Scene {
    teapot()
}

/// Night blue, dark enough for a highlight and bright enough for an unlit outline.
const BACKGROUND: Rgb = Rgb::new(0.07, 0.08, 0.10);
const WARM: Rgb = Rgb::new(1.0, 0.95, 0.86);
const COOL: Rgb = Rgb::new(0.62, 0.74, 1.0);

/// The studio: a camera slightly above, a warm lamp to the upper right.
fn studio(kind: ObjectKind, segments: u32, rings: u32) -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 1.1, 3.9)),
        image: Image { background: BACKGROUND, ..Image::default() },
        object: Object { kind, segments, rings, normals: NormalSource::Exact, ..Object::default() },
        lights: vec![lamp([2.4, 3.0, 3.2], WARM)],
        ..Scene::default()
    }
}

fn seen_from(eye: DVec3) -> Camera {
    Camera { eye, fov_y: 36.0, ..Camera::default() }
}

fn lamp(position: [f64; 3], color: Rgb) -> Light {
    Light { position: DVec3::from_array(position), color, ..Light::default() }
}

/// A distant light whose rays travel along `direction`.
fn rays(direction: [f64; 3], color: Rgb) -> Light {
    Light { kind: LightKind::Directional, direction: DVec3::from_array(direction), color, ..Light::default() }
}

fn surface(color: [f64; 3], kd: f64, ks: f64, n: f64) -> Material {
    let grey = Rgb::splat;
    Material { ka: grey(0.12), kd: grey(kd), ks: grey(ks), n, color: Rgb::from_array(color), ..Material::default() }
}

fn sphere() -> Scene {
    Scene { material: surface([0.91, 0.33, 0.20], 0.75, 0.45, 40.0), ..studio(ObjectKind::Sphere, 192, 96) }
}

fn torus() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 2.2, 3.0)),
        material: surface([0.16, 0.62, 0.60], 0.75, 0.55, 60.0),
        ..studio(ObjectKind::Torus, 256, 96)
    }
}

fn cylinder() -> Scene {
    Scene {
        material: surface([0.93, 0.67, 0.22], 0.75, 0.45, 50.0),
        // Low enough to be mirrored to the eye by an upright wall, with a window above for the cap.
        lights: vec![lamp([2.2, -0.2, 3.0], WARM), lamp([-1.6, 3.4, 1.4], COOL * 0.5)],
        ..studio(ObjectKind::Cylinder, 192, 48)
    }
}

fn cone() -> Scene {
    Scene { material: surface([0.52, 0.40, 0.85], 0.78, 0.45, 40.0), ..studio(ObjectKind::Cone, 192, 64) }
}

fn cube() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(2.0, 1.7, 3.0)),
        material: surface([0.38, 0.64, 0.96], 0.88, 0.30, 30.0),
        lights: vec![lamp([1.6, 3.8, 2.6], WARM)],
        ..studio(ObjectKind::Cube, 24, 24)
    }
}

fn plane() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.6, 0.9, 3.8)),
        material: surface([0.36, 0.66, 0.42], 0.70, 0.50, 60.0),
        lights: vec![lamp([0.4, 0.7, 0.9], WARM)],
        ..studio(ObjectKind::Plane, 48, 48)
    }
}

fn teapot() -> Scene {
    Scene {
        camera: Camera { fov_y: 30.0, target: DVec3::new(0.0, -0.05, 0.0), ..seen_from(DVec3::new(0.8, 1.5, 3.6)) },
        material: surface([0.28, 0.58, 0.86], 0.78, 0.80, 85.0),
        lights: vec![lamp([1.6, 2.2, 3.4], WARM), lamp([-3.4, 1.4, 1.2], COOL * 0.45)],
        ..studio(ObjectKind::Teapot, 64, 64)
    }
}

fn highlight() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 0.35, 3.9)),
        material: surface([0.80, 0.42, 0.30], 0.55, 0.70, 40.0),
        shading: Shading { mode: ShadingMode::Gouraud, ..Shading::default() },
        lights: vec![lamp([0.0, 0.1, 1.3], WARM)],
        ..studio(ObjectKind::Plane, 1, 1)
    }
}

fn flat_facets() -> Scene {
    let studio = studio(ObjectKind::Sphere, 24, 12);
    Scene {
        object: Object { normals: NormalSource::Averaged, ..studio.object },
        material: surface([0.85, 0.83, 0.80], 0.85, 0.0, 20.0),
        shading: Shading { mode: ShadingMode::Flat, flat_at: FlatAt::Centre, ..Shading::default() },
        ..studio
    }
}

fn mirror_like() -> Scene {
    Scene {
        material: surface([0.20, 0.22, 0.26], 0.60, 1.0, 1005.0),
        lights: vec![
            lamp([2.4, 3.0, 3.2], WARM),
            lamp([-2.8, 1.6, 2.6], COOL),
            lamp([-0.6, -2.2, 3.4], Rgb::new(1.0, 0.55, 0.35)),
        ],
        ..studio(ObjectKind::Sphere, 256, 128)
    }
}

fn three_lights() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 2.0, 3.2)),
        material: surface([0.82, 0.80, 0.78], 0.70, 0.50, 50.0),
        lights: vec![
            lamp([2.6, 2.6, 2.8], WARM * 0.75),
            lamp([-3.2, 1.2, 2.2], COOL * 0.35),
            lamp([-0.8, 2.4, -3.4], Rgb::new(1.0, 0.72, 0.50) * 0.8),
        ],
        ..studio(ObjectKind::Torus, 256, 96)
    }
}

fn colored_lights() -> Scene {
    Scene {
        material: surface([0.95, 0.95, 0.95], 0.75, 0.35, 40.0),
        ambient: Ambient { color: Rgb::splat(0.5), ..Ambient::default() },
        lights: vec![
            lamp([0.0, 3.4, 2.6], Rgb::new(1.0, 0.12, 0.10)),
            lamp([-3.0, -1.4, 2.8], Rgb::new(0.10, 0.95, 0.20)),
            lamp([3.0, -1.4, 2.8], Rgb::new(0.15, 0.25, 1.0)),
        ],
        ..studio(ObjectKind::Sphere, 192, 96)
    }
}

fn attenuation() -> Scene {
    let lamp = lamp([0.0, 0.15, 0.55], WARM * 0.45);
    Scene {
        camera: seen_from(DVec3::new(1.5, 1.2, 3.2)),
        material: surface([0.75, 0.62, 0.45], 0.85, 0.25, 20.0),
        lights: vec![Light { attenuation: Attenuation::InverseSquare, ..lamp }],
        ..studio(ObjectKind::Plane, 96, 96)
    }
}

fn blinn() -> Scene {
    Scene {
        // Z is up here, so that the plane is a floor, lit from beyond.
        camera: Camera { up: DVec3::Z, target: DVec3::new(0.0, -0.2, 0.0), ..seen_from(DVec3::new(0.0, -3.7, 1.7)) },
        material: surface([0.70, 0.26, 0.32], 0.60, 0.75, 90.0),
        reflection: Reflection { model: ReflectionModel::Blinn, ..Reflection::default() },
        lights: vec![lamp([0.2, 2.6, 1.2], WARM)],
        ..studio(ObjectKind::Plane, 96, 96)
    }
}

fn infinite() -> Scene {
    let studio = studio(ObjectKind::Sphere, 192, 96);
    Scene {
        camera: Camera { viewer: Viewer::Infinite, ..studio.camera },
        material: surface([0.35, 0.65, 0.80], 0.75, 0.50, 40.0),
        lights: vec![rays([-2.4, -3.0, -3.2], WARM)],
        ..studio
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
    }

    #[test]
    fn the_default_is_one_of_them_and_so_is_every_shape_without_a_file() {
        assert_eq!(find(DEFAULT).map(|preset| (preset.build)()), Some(default_scene()));
        let shapes: Vec<_> = ALL.iter().map(|preset| (preset.build)().object.kind).collect();
        use ObjectKind::{Cone, Cube, Cylinder, Plane, Sphere, Teapot, Torus};
        for kind in [Sphere, Torus, Cylinder, Cone, Cube, Plane, Teapot] {
            assert!(shapes.contains(&kind), "{kind:?}");
        }
    }
}
