//! What a sound scene is: every number in its range, and no two that contradict each other.

use super::compare;
use super::problem::{Cause, Place, Problem, SceneError};
use super::{
    AmbientSource, Attenuation, Backdrop, Camera, Compare, DepthCueing, Ground, Image, Light, Material, Object,
    ObjectKind, Pattern, PatternKind, Rgb, Scene, Transparency,
};
use glam::DVec3;
use std::ops::RangeInclusive;

/// Greatest coordinate and greatest length, world units: its square stays far below the greatest `f64`, and so do the
/// squares' sums.
pub const GREATEST_LENGTH: f64 = 1e30;

/// Shortest length that counts as one, world units: its square is still a normal number.
pub const LEAST_LENGTH: f64 = 1e-30;

/// Greatest intensity of a light or of the background, in units of the display's white.
pub const GREATEST_INTENSITY: f64 = 1e30;

/// Greatest ambient term in a picture that shows one bounce in its right half in place of it: the bounce is added as a difference,
/// in single precision.
const GREATEST_SPLIT: f64 = 1e4;

/// Eye and target are two points when they are further apart than this part of their distance from the origin: of the
/// 16 digits of an `f64`, 6 are left for the viewing direction.
const LEAST_SEPARATION: f64 = 1e-10;

/// Sine of the smallest angle between the viewing direction and the direction that appears upwards.
const LEAST_TILT: f64 = 1e-6;

impl Scene {
    /// Most lights in a scene. Each adds a term to every pixel.
    pub const MAX_LIGHTS: usize = 1000;

    /// Most points that all lights together are replaced by.
    pub const MAX_LIGHT_SAMPLES: u64 = 4096;

    /// Most pixels times light samples of a picture with shadows: a gigabyte of bits.
    pub const MAX_SHADOW_BITS: u64 = 1 << 33;

    /// Checks every number and what they are together.
    ///
    /// # Guarantees
    /// `Ok` says that every number is finite (`material.n` may be infinite) and in the range that its section documents,
    /// that eye and target are different points and `up` points across the line between them, that directions are not
    /// zero, that a model has a path, in Unicode, and that polygons are over known vertices and do not cross
    /// themselves.
    ///
    /// # Errors
    /// Every number that is out of range and every contradiction, with its key.
    pub fn validate(&self) -> Result<(), SceneError> {
        let problem = |(key, cause)| Problem { place: Place::Scene, key, cause };
        SceneError::check(self.range_problems().into_iter().map(problem).collect())
    }

    /// What [`Scene::validate`] reports, as keys and causes.
    pub(super) fn range_problems(&self) -> Vec<(String, Cause)> {
        let mut checks = Checks::default();
        if self.version != Self::VERSION {
            checks.found("version", Cause::Version { found: self.version.to_string() });
        }
        self.camera.check(&mut checks);
        self.image.check(&mut checks);
        self.object.check(&mut checks);
        self.material.check(&mut checks);
        self.pattern.check(&mut checks);
        self.transparency.check(&mut checks);
        self.ground.check(&mut checks);
        self.backdrop.check(&mut checks);
        self.depth_cueing.check(&mut checks);
        checks.colour("ambient.color", self.ambient.color, GREATEST_INTENSITY);
        if self.ambient.source == AmbientSource::Split && self.greatest_ambient() > GREATEST_SPLIT {
            let is = "is so bright that beside the ambient term one bounce is lost to rounding";
            let expected = "an ambient term of at most 10000, or `ambient.source` \"constant\" or \"bounce\"";
            checks.found("ambient.color", Cause::Conflict { is, expected });
        }
        if self.lights.len() > Self::MAX_LIGHTS {
            checks.value("light", format!("a list of {}", self.lights.len()), format!("at most {}", Self::MAX_LIGHTS));
        }
        for (i, light) in self.lights.iter().take(Self::MAX_LIGHTS).enumerate() {
            light.check(&mut checks, &format!("light.{i}"));
        }
        let samples: u64 = self.lights.iter().map(|light| u64::from(light.sample_count())).sum();
        if samples > Self::MAX_LIGHT_SAMPLES {
            let expected = format!("at most {}", Self::MAX_LIGHT_SAMPLES);
            checks.value("light", format!("{samples} samples in all"), expected);
        }
        let pixels: u64 = self.image.size.iter().map(|side| u64::from(*side)).product();
        let bits = samples.saturating_mul(pixels);
        if self.shading.shadows && bits > Self::MAX_SHADOW_BITS {
            let expected = "a smaller picture, fewer samples of area lights, or no shadows";
            checks.found("image.size", Cause::Conflict { is: "has too many pixels for so many shadows", expected });
        }
        let &Compare { view: _, wipe, difference: _, gain, panes: _ } = &self.compare;
        checks.number("compare.wipe", wipe, 0.0..=1.0, "");
        checks.number("compare.gain", gain, 1.0..=Compare::MAX_GAIN, "");
        if checks.problems.is_empty() {
            checks.problems = compare::problems(self);
        }
        checks.problems
    }

    /// The greatest constant ambient term of the object and the ground, in any channel.
    fn greatest_ambient(&self) -> f64 {
        let Self { material, pattern, ground, ambient, .. } = self;
        let patterned = if pattern.kind == PatternKind::None { Rgb::ZERO } else { pattern.color };
        let object = material.ka * material.color.max(patterned);
        let floor = if ground.visible { ground.color * ground.ka } else { Rgb::ZERO };
        (object.max(floor) * ambient.color).max_element()
    }
}

impl Camera {
    /// Degrees. Below, a pixel is narrower than single precision resolves; above, the picture is all rim.
    pub const FOV_Y: RangeInclusive<f64> = 1e-3..=179.0;

    fn check(&self, checks: &mut Checks) {
        let &Self { eye, target, up, roll, projection: _, fov_y, height, viewer: _ } = self;
        checks.number("camera.fov_y", fov_y, Self::FOV_Y, " degrees");
        checks.number("camera.height", height, LEAST_LENGTH..=GREATEST_LENGTH, "");
        if !roll.is_finite() {
            checks.value("camera.roll", number(roll), "a finite number of degrees");
        }
        let points = checks.point("camera.eye", eye) & checks.point("camera.target", target);
        let upright = checks.direction("camera.up", up);
        if !points {
            return;
        }
        let scale = eye.length().max(target.length());
        let forward = target - eye;
        if forward.length() <= (LEAST_SEPARATION * scale).max(LEAST_LENGTH) {
            let cause =
                Cause::Conflict { is: "is the same point as `camera.target`", expected: "two different points" };
            checks.found("camera.eye", cause);
        } else if upright && forward.normalize().cross(up.normalize()).length() < LEAST_TILT {
            let is = "is parallel to the viewing direction";
            checks.found("camera.up", Cause::Conflict { is, expected: "a direction across it" });
        }
    }
}

impl Image {
    /// Most pixels in a picture: 16384 × 8192, half a gigabyte as stored.
    pub const MAX_PIXELS: u64 = 1 << 27;

    fn check(&self, checks: &mut Checks) {
        let Self { size, background } = self;
        let [width, height] = *size;
        if [width, height].iter().any(|side| !(1..=Self::MAX_SIDE).contains(side)) {
            let expected = format!("sides of 1 to {} pixels", Self::MAX_SIDE);
            checks.value("image.size", format!("[{width}, {height}]"), expected);
        } else if u64::from(width) * u64::from(height) > Self::MAX_PIXELS {
            let expected = format!("at most {} pixels in all", Self::MAX_PIXELS);
            checks.value("image.size", format!("[{width}, {height}]"), expected);
        }
        checks.colour("image.background", *background, GREATEST_INTENSITY);
    }
}

impl Object {
    /// Fewest polygons round the axis: fewer than three enclose nothing. A plane's are counted across it, and so are a corrugated sheet's slopes, at
    /// least one up and one down.
    pub fn min_segments(&self) -> u32 {
        match self.kind {
            ObjectKind::Plane => 1,
            ObjectKind::Corrugated => 2,
            _ => 3,
        }
    }

    /// Fewest polygons along the axis: a sphere needs both of its caps, the tube of a torus encloses something.
    pub fn min_rings(&self) -> u32 {
        match self.kind {
            ObjectKind::Sphere => 2,
            ObjectKind::Torus => 3,
            _ => 1,
        }
    }

    fn check(&self, checks: &mut Checks) {
        let Self { kind, segments, rings, path, .. } = self;
        checks.count("object.segments", *segments, self.min_segments()..=Self::MAX_DIVISIONS);
        checks.count("object.rings", *rings, self.min_rings()..=Self::MAX_DIVISIONS);
        match path {
            Some(path) if path.to_str().is_none() => {
                let found = format!("{:?}", path.to_string_lossy());
                checks.value("object.path", found, "a path in Unicode, as a scene file can hold it");
            }
            Some(path) if path.as_os_str().is_empty() => checks.value("object.path", "empty", "the path of a model"),
            None if *kind == ObjectKind::Obj => {
                let expected = "the path of a model since `object.kind` is \"obj\"";
                checks.found("object.path", Cause::Conflict { is: "is missing", expected });
            }
            _ => {}
        }
        self.check_polygons(checks);
    }
}

impl Material {
    /// Greatest reflection coefficient. Above 1 a surface sends out more than it receives, which is no physics but
    /// shows what overflows; the bound keeps every product far from the end of single precision.
    pub const MAX_COEFFICIENT: f64 = 1e6;

    /// Below, the highlight is narrower than single precision tells directions apart; above, slopes pass 45° mostly.
    pub const ROUGHNESS: RangeInclusive<f64> = 1e-3..=1.0;

    /// Indices of refraction: no material known lies outside.
    pub const IOR: RangeInclusive<f64> = 0.01..=100.0;

    fn check(&self, checks: &mut Checks) {
        let &Self { ka, kd, ks, n, roughness, color, specular_color, reflectance: _, ior, extinction } = self;
        for (key, value) in [
            ("material.ka", ka),
            ("material.kd", kd),
            ("material.ks", ks),
            ("material.color", color),
            ("material.specular_color", specular_color),
        ] {
            checks.colour(key, value, Self::MAX_COEFFICIENT);
        }
        checks.number("material.roughness", roughness, Self::ROUGHNESS, "");
        if !ior.to_array().iter().all(|channel| Self::IOR.contains(channel)) {
            let (least, greatest) = (number(*Self::IOR.start()), number(*Self::IOR.end()));
            checks.value("material.ior", triple(ior), format!("{least} to {greatest} in each channel"));
        }
        checks.colour("material.extinction", extinction, *Self::IOR.end());
        if n.is_nan() || n < 0.0 {
            checks.value("material.n", number(n), "0 or more (inf: a mirror)");
        }
    }
}

impl Light {
    /// Degrees from a spot light's axis to the edge of its cone.
    pub const CONE: RangeInclusive<f64> = 0.1..=90.0;

    /// Greatest exponent of a spot light: its beam is then 4° wide.
    pub const MAX_EXPONENT: f64 = 1e3;

    /// Most characters of a light's name.
    pub const MAX_NAME: usize = 64;

    fn check(&self, checks: &mut Checks, key: &str) {
        let &Self { position, direction, color, attenuation, k, c1, c2, c3, .. } = self;
        let inside = |name: &str| format!("{key}.{name}");
        checks.point(&inside("position"), position);
        if self.name.chars().count() > Self::MAX_NAME || self.name.chars().any(char::is_control) {
            let expected = format!("at most {} characters in one line", Self::MAX_NAME);
            checks.value(&inside("name"), format!("{:?}", self.name.chars().take(20).collect::<String>()), expected);
        }
        checks.number(&inside("cone"), self.cone, Self::CONE, " degrees");
        checks.number(&inside("exponent"), self.exponent, 0.0..=Self::MAX_EXPONENT, "");
        checks.number(&inside("softness"), self.softness, 0.0..=1.0, "");
        let [width, height] = self.extent;
        for side in [width, height] {
            checks.number(&inside("extent"), side, 0.0..=GREATEST_LENGTH, "");
        }
        checks.number(&inside("radius"), self.radius, 0.0..=GREATEST_LENGTH, "");
        checks.count(&inside("samples"), self.samples, 1..=Self::MAX_SAMPLES);
        if self.has_direction() {
            checks.direction(&inside("direction"), direction);
        } else {
            checks.point(&inside("direction"), direction);
        }
        checks.colour(&inside("color"), color, GREATEST_INTENSITY);
        let mut sound = true;
        for (name, value) in [("k", k), ("c1", c1), ("c2", c2), ("c3", c3)] {
            sound &= checks.number(&inside(name), value, 0.0..=GREATEST_LENGTH, "");
        }
        if sound && attenuation == Attenuation::Quadratic && c1 + c2 + c3 == 0.0 {
            let expected = "one of c1, c2, c3 above 0";
            checks.found(&inside("c1"), Cause::Conflict { is: "is 0 like `c2` and `c3`", expected });
        }
    }
}

impl Pattern {
    fn check(&self, checks: &mut Checks) {
        let &Self { kind: _, color, scale } = self;
        checks.colour("pattern.color", color, Material::MAX_COEFFICIENT);
        checks.number("pattern.scale", scale, Self::SCALE, "");
    }

    /// World units. Fields narrower than the least are not told apart in single precision.
    pub const SCALE: RangeInclusive<f64> = 1e-4..=1e4;
}

impl Transparency {
    /// Indices of refraction, either way through the surface.
    pub const IOR: RangeInclusive<f64> = 0.1..=10.0;

    fn check(&self, checks: &mut Checks) {
        let &Self { kt, ior, through: _ } = self;
        checks.number("transparency.kt", kt, 0.0..=1.0, "");
        checks.number("transparency.ior", ior, Self::IOR, "");
    }
}

impl Ground {
    fn check(&self, checks: &mut Checks) {
        let &Self { visible: _, height, ka, kd, color } = self;
        checks.number("ground.height", height, -GREATEST_LENGTH..=GREATEST_LENGTH, "");
        checks.number("ground.ka", ka, 0.0..=Material::MAX_COEFFICIENT, "");
        checks.number("ground.kd", kd, 0.0..=Material::MAX_COEFFICIENT, "");
        checks.colour("ground.color", color, Material::MAX_COEFFICIENT);
    }
}

impl Backdrop {
    fn check(&self, checks: &mut Checks) {
        let &Self { pattern: _, color, scale, distance } = self;
        checks.colour("backdrop.color", color, GREATEST_INTENSITY);
        checks.number("backdrop.scale", scale, Pattern::SCALE, "");
        checks.number("backdrop.distance", distance, -GREATEST_LENGTH..=GREATEST_LENGTH, "");
    }
}

impl DepthCueing {
    fn check(&self, checks: &mut Checks) {
        let &Self { by: _, front, back, front_scale, back_scale, color } = self;
        let range = 0.0..=GREATEST_LENGTH;
        let depths = checks.number("depth_cueing.front", front, range.clone(), "")
            & checks.number("depth_cueing.back", back, range, "");
        if depths && front >= back {
            let expected = "a greater one";
            checks.found("depth_cueing.back", Cause::Conflict { is: "is not beyond `depth_cueing.front`", expected });
        }
        checks.number("depth_cueing.front_scale", front_scale, 0.0..=1.0, "");
        checks.number("depth_cueing.back_scale", back_scale, 0.0..=1.0, "");
        checks.colour("depth_cueing.color", color, GREATEST_INTENSITY);
    }
}

/// The problems found so far. The checks return whether they found none.
#[derive(Default)]
pub(super) struct Checks {
    problems: Vec<(String, Cause)>,
}

impl Checks {
    pub(super) fn found(&mut self, key: &str, cause: Cause) {
        self.problems.push((key.to_owned(), cause));
    }

    pub(super) fn value(&mut self, key: &str, found: impl Into<String>, expected: impl Into<String>) {
        self.found(key, Cause::Value { found: found.into(), expected: expected.into() });
    }

    fn number(&mut self, key: &str, value: f64, range: RangeInclusive<f64>, unit: &str) -> bool {
        let sound = range.contains(&value);
        if !sound {
            self.value(key, number(value), format!("{} to {}{unit}", number(*range.start()), number(*range.end())));
        }
        sound
    }

    fn count(&mut self, key: &str, value: u32, range: RangeInclusive<u32>) {
        if !range.contains(&value) {
            self.value(key, value.to_string(), format!("{} to {}", range.start(), range.end()));
        }
    }

    fn colour(&mut self, key: &str, value: Rgb, greatest: f64) {
        if !value.to_array().iter().all(|channel| (0.0..=greatest).contains(channel)) {
            self.value(key, triple(value), format!("0 to {} in each channel", number(greatest)));
        }
    }

    pub(super) fn point(&mut self, key: &str, value: DVec3) -> bool {
        let sound = value.to_array().iter().all(|x| x.abs() <= GREATEST_LENGTH);
        if !sound {
            self.value(key, triple(value), format!("coordinates up to {}", number(GREATEST_LENGTH)));
        }
        sound
    }

    pub(super) fn direction(&mut self, key: &str, value: DVec3) -> bool {
        let point = self.point(key, value);
        let sound = point && value.length() >= LEAST_LENGTH;
        if point && !sound {
            self.value(key, triple(value), format!("a direction, of length {} or more", number(LEAST_LENGTH)));
        }
        sound
    }
}

fn triple(value: DVec3) -> String {
    format!("[{}, {}, {}]", number(value.x), number(value.y), number(value.z))
}

/// A number as a scene's author would write it.
fn number(value: f64) -> String {
    if value.is_nan() {
        return "nan".to_owned();
    }
    if value != 0.0 && !(1e-6..1e9).contains(&value.abs()) { format!("{value:e}") } else { value.to_string() }
}
