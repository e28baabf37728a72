//! The built-in scenes: the scene files of `assets/scenes`, compiled in and read at first use. Their texts for people are
//! in the catalogue: `scene-NAME` with its `.sentence`, and `topic-TOPIC`.

use super::{Scene, SceneDescription};
use crate::text::{Language, in_language, text};
use std::sync::LazyLock;

/// A scene that comes with the program.
#[derive(Debug)]
pub struct Preset {
    /// The name on the command line: lower-case words with hyphens.
    pub name: &'static str,
    /// The chapter that it belongs to, one of [`topics`].
    pub topic: &'static str,
    scene: LazyLock<Scene>,
}

impl Preset {
    /// Returns the scene with its description in English, as scene files have it whatever the language.
    pub fn scene(&self) -> Scene {
        Scene {
            about: in_language(Language::English, || self.about()),
            ..self.scene.clone()
        }
    }

    /// Returns the scene's title in the current language.
    pub fn title(&self) -> &'static str {
        text!(&format!("scene-{}", self.name))
    }

    /// Returns the sentence on what to look at and what to try.
    pub fn sentence(&self) -> &'static str {
        text!(&format!("scene-{}.sentence", self.name))
    }

    /// Returns the title of its chapter.
    pub fn topic_title(&self) -> &'static str {
        text!(&format!("topic-{}", self.topic))
    }

    /// Returns the view of the window that opens with it; may be empty.
    pub fn view(&self) -> &str {
        &self.scene.about.view
    }

    /// Returns title, sentence, topic and view in the current language.
    pub fn about(&self) -> SceneDescription {
        SceneDescription {
            title: self.title().to_owned(),
            sentence: self.sentence().to_owned(),
            topic: self.topic_title().to_owned(),
            view: self.view().to_owned(),
        }
    }
}

/// The name of the scene shown when none is named.
pub const DEFAULT: &str = "shading-modes";

/// The name of the scene that a link without a name changes. Links stay what they are: this never changes.
pub const LINK_BASE: &str = "teapot";

macro_rules! scenes {
    ($($topic:literal: $($name:literal)+;)+) => {
        [$($(Preset {
            name: $name,
            topic: $topic,
            scene: LazyLock::new(|| read($name, include_str!(concat!("../../assets/scenes/", $name, ".toml")))),
        }),+),+]
    };
}

/// Every built-in scene, by topic.
pub static ALL: &[Preset] = &SCENES;

static SCENES: [Preset; 54] = scenes! {
    "shapes": "sphere" "torus" "cylinder" "cone" "cube" "plane" "teapot" "balls";
    "shading": "shading-modes" "highlight" "flat-facets" "mach-bands" "silhouette" "perspective-distortion" "orientation" "shared-vertices"
        "vertex-normals" "depth-cueing";
    "light": "ambient-only" "sun" "spotlight" "soft-shadow" "three-lights" "colored-lights" "attenuation"
        "attenuation-quadratic" "attenuation-viewer" "infinite";
    "reflection": "matt" "blinn" "tinted-highlight" "mirror-like" "gold" "glass-rim" "microfacets" "two-sided" "overflow"
        "brass" "opengl" "checker" "rings";
    "laws": "lommel-seeliger" "minnaert" "oren-nayar" "half-lambert" "schlick" "ward" "gooch" "toon";
    "surfaces": "shadows" "glass-ball" "one-surface" "under-water" "one-bounce";
};

fn read(name: &str, text: &str) -> Scene {
    Scene::parse(text, name)
        .unwrap_or_else(|error| unreachable!("the tests read every built-in scene: {error}"))
}

/// Finds the built-in scene of that name.
pub fn find(name: &str) -> Option<&'static Preset> {
    ALL.iter().find(|preset| preset.name == name)
}

/// Returns the topics of the built-in scenes, each once, in their order.
pub fn topics() -> Vec<&'static str> {
    let mut topics: Vec<_> = ALL.iter().map(|preset| preset.topic).collect();
    topics.dedup();
    topics
}

/// Returns the title of a topic; empty where there is none.
pub fn topic_title(topic: &str) -> &'static str {
    let preset = ALL.iter().find(|preset| preset.topic == topic);
    preset.map_or("", Preset::topic_title)
}

/// Returns the scene shown when none is named.
pub fn default_scene() -> Scene {
    find(DEFAULT).map(Preset::scene).unwrap_or_default()
}

/// Returns the scene that a link without a name changes.
pub fn link_base() -> Scene {
    find(LINK_BASE).map(Preset::scene).unwrap_or_default()
}
