//! The built-in scenes: the scene files of `assets/scenes`, compiled in and read when first asked for.

use super::{About, Scene};
use std::sync::LazyLock;

/// A scene that comes with the program.
#[derive(Debug)]
pub struct Preset {
    /// What the command line calls it: lower-case words with hyphens.
    pub name: &'static str,
    scene: LazyLock<Scene>,
}

impl Preset {
    pub fn scene(&self) -> Scene {
        self.scene.clone()
    }

    /// Title, sentence, topic and view.
    pub fn about(&self) -> &About {
        &self.scene.about
    }
}

/// The name of the scene shown when none is named.
pub const DEFAULT: &str = "teapot";

macro_rules! scenes {
    ($($name:literal)+) => {
        [$(Preset { name: $name, scene: LazyLock::new(|| read($name, include_str!(concat!("../../assets/scenes/", $name, ".toml")))) }),+]
    };
}

/// Every built-in scene, by topic.
pub static ALL: &[Preset] = &SCENES;

static SCENES: [Preset; 44] = scenes! {
    "sphere" "torus" "cylinder" "cone" "cube" "plane" "teapot"
    "highlight" "flat-facets" "mach-bands" "silhouette" "perspective-distortion" "orientation" "shared-vertices"
    "vertex-normals" "depth-cueing"
    "ambient-only" "sun" "spotlight" "soft-shadow" "three-lights" "colored-lights" "attenuation"
    "attenuation-quadratic" "attenuation-viewer" "infinite"
    "matt" "blinn" "tinted-highlight" "mirror-like" "gold" "glass-rim" "microfacets" "two-sided" "overflow" "brass"
    "opengl" "checker" "rings"
    "shadows" "glass-ball" "one-surface" "under-water" "one-bounce"
};

fn read(name: &str, text: &str) -> Scene {
    Scene::parse(text, name).unwrap_or_else(|error| unreachable!("the tests read every built-in scene: {error}"))
}

/// The built-in scene of that name.
pub fn find(name: &str) -> Option<&'static Preset> {
    ALL.iter().find(|preset| preset.name == name)
}

/// The topics of the built-in scenes, each once, in their order.
pub fn topics() -> Vec<&'static str> {
    let mut topics: Vec<_> = ALL.iter().map(|preset| preset.about().topic.as_str()).collect();
    topics.dedup();
    topics
}

/// The scene shown when none is named.
pub fn default_scene() -> Scene {
    find(DEFAULT).map(Preset::scene).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::ObjectKind;

    #[test]
    fn every_scene_is_read_and_survives_its_file() {
        for preset in ALL {
            let scene = preset.scene();
            assert_eq!(Scene::parse(&scene.to_toml(), preset.name), Ok(scene), "{}", preset.name);
        }
    }

    #[test]
    fn every_name_is_its_own_and_every_scene_says_what_it_is_about() {
        let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes")).expect("a folder");
        assert_eq!(files.count(), ALL.len(), "every file is listed");
        for preset in ALL {
            assert!(preset.name.chars().all(|c| c.is_ascii_lowercase() || c == '-'), "{}", preset.name);
            let About { title, sentence, topic, view } = preset.about();
            assert!(std::ptr::eq(find(preset.name).expect("listed"), preset));
            assert!(!title.is_empty() && sentence.ends_with('.') && !topic.is_empty(), "{}", preset.name);
            assert_eq!(view.is_empty(), preset.name == DEFAULT, "{}", preset.name);
        }
        let mut sorted = topics();
        sorted.sort_unstable();
        sorted.dedup();
        assert_eq!(sorted.len(), topics().len(), "scenes of a topic stand together");
    }

    #[test]
    fn every_shape_without_a_file_is_shown() {
        let shapes: Vec<_> = ALL.iter().map(|preset| preset.scene().object.kind).collect();
        use ObjectKind::{Cone, Corrugated, Cube, Cylinder, Plane, Polygons, Sphere, Teapot, Torus};
        for kind in [Sphere, Torus, Cylinder, Cone, Cube, Plane, Teapot, Corrugated, Polygons] {
            assert!(shapes.contains(&kind), "{kind:?}");
        }
    }
}
