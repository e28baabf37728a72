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
    Scene::parse(text, name)
        .unwrap_or_else(|error| unreachable!("the tests read every built-in scene: {error}"))
}

/// The built-in scene of that name.
pub fn find(name: &str) -> Option<&'static Preset> {
    ALL.iter().find(|preset| preset.name == name)
}

/// The topics of the built-in scenes, each once, in their order.
pub fn topics() -> Vec<&'static str> {
    let mut topics: Vec<_> = ALL
        .iter()
        .map(|preset| preset.about().topic.as_str())
        .collect();
    topics.dedup();
    topics
}

/// The scene shown when none is named.
pub fn default_scene() -> Scene {
    find(DEFAULT).map(Preset::scene).unwrap_or_default()
}
