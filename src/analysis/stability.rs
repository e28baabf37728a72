//! Stiff and extreme cases: the naive renderer, the engine and a reference on the same scene, and their results; and where a
//! scene's own law loses digits.
//!
//! Values are compared as code values, 255·min(I, 1) before rounding, at pixels of the reference that belong to no
//! outline. NaN counts as an error of the whole range.

mod cases;
mod law;
mod naive;
mod precise;
mod reference;
mod report;

pub use law::{LawOperation, LawStability, PrecisionError, law_stability};
pub use report::{Catalogue, StabilityQuestion};

use crate::figure::magnitude;
use crate::render::{Frame, Renderer};
use crate::scene::{Scene, choices};
use crate::text::{Message, text};
use reference::Truth;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::fmt;

/// Tolerance for the engine, code values: rounding to a stored pixel takes as much anyway.
pub const HALF_A_CODE_VALUE: f64 = 0.5;

choices! {
    /// Topic of a case.
    pub enum Topic = "stability-topic" {
        /// The power and the microfacets.
        Highlight = "highlight";
        /// Light in the plane of the surface or behind it.
        Cosines = "cosines";
        /// Vectors without a direction, or whose square overflows.
        Vectors = "vectors";
        /// Extreme positions and intensities.
        Lights = "lights";
        /// Extreme eyes, vertices and polygons.
        Geometry = "geometry";
    }
}

choices! {
    /// Verdict on the two renderers.
    pub enum Verdict = "verdict" {
        /// The engine is within half a code value, the naive renderer is not.
        RobustHolds = "robust-holds";
        /// Both are within half a code value.
        BothHold = "both-hold";
        /// The engine is off by more than half a code value.
        Fails = "fails";
    }
}

/// Amplification of a relative error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Condition {
    /// The factor.
    pub value: f64,
    /// The input and the output to which it applies.
    pub of: Message,
}

impl fmt::Display for Condition {
    /// Formats the number, as in “6.6×10⁵”.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&magnitude(self.value))
    }
}

/// A case of the catalogue.
#[derive(Debug)]
pub struct Case {
    /// Name in lower case, joined by hyphens.
    pub name: &'static str,
    /// Topic of the case.
    pub topic: Topic,
    /// Condition of the exact problem, if known.
    pub condition: Option<Condition>,
    /// Constructor of the scene that all three draw, and a change applied to it.
    make: fn() -> Scene,
    change: fn(&mut Scene),
    /// Function that draws the pictures, if that is done in some other way.
    pictures: Option<fn(&mut Renderer) -> Pictures>,
}

/// Returns a case of which only the name and topic are known yet.
const fn case(name: &'static str, topic: Topic) -> Case {
    let change: fn(&mut Scene) = |_| ();
    Case {
        name,
        topic,
        condition: None,
        make: Scene::default,
        change,
        pictures: None,
    }
}

impl Case {
    /// Returns its title, a few words.
    pub fn title(&self) -> &'static str {
        text!(&format!("engine-case-{}", self.name))
    }

    /// Describes the failure of the naive renderer.
    pub fn naive(&self) -> &'static str {
        text!(&format!("engine-case-{}.naive", self.name))
    }

    /// Describes the method of this engine.
    pub fn engine(&self) -> &'static str {
        text!(&format!("engine-case-{}.engine", self.name))
    }

    const fn condition(mut self, value: f64, of: &'static str) -> Self {
        self.condition = Some(Condition {
            value,
            of: Message(of),
        });
        self
    }

    const fn draws(mut self, make: fn() -> Scene) -> Self {
        self.make = make;
        self
    }

    const fn with(mut self, change: fn(&mut Scene)) -> Self {
        self.change = change;
        self
    }

    const fn pictures(mut self, make: fn(&mut Renderer) -> Pictures) -> Self {
        self.pictures = Some(make);
        self
    }

    /// Returns the case as a scene, if it is one.
    pub fn scene(&self) -> Option<Scene> {
        let mut scene = (self.make)();
        (self.change)(&mut scene);
        self.pictures.is_none().then_some(scene)
    }
}

/// Serializes a case by its name.
impl Serialize for Case {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name)
    }
}

impl<'de> Deserialize<'de> for &'static Case {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        stability_cases()
            .find(|case| case.name == name)
            .ok_or_else(|| de::Error::custom(name))
    }
}

/// Linear intensities of the three pictures, row by row from the top.
struct Pictures {
    naive: Vec<[f64; 3]>,
    engine: Vec<[f64; 3]>,
    truth: Vec<Truth>,
    scene: Option<Scene>,
}

/// The result of a case.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CaseResult {
    /// The case.
    pub case: &'static Case,
    /// Maximum error of the naive renderer, code values, 0 to 255.
    pub naive_error: f64,
    /// Maximum error of the engine, code values.
    pub robust_error: f64,
    /// Verdict on the two renderers.
    pub verdict: Verdict,
    /// Number of pixels compared.
    pub pixels: u64,
    /// Number of pixels at which the naive renderer is off by more than half a code value.
    pub naive_off: u64,
    /// Number of pixels of the naive renderer that are infinite or NaN, compared or not.
    pub naive_not_finite: u64,
    /// Number of pixels of the engine that are infinite or NaN: zero.
    pub robust_not_finite: u64,
    /// Stored pictures: the naive renderer's with non-finite pixels in magenta, the engine's, the reference's.
    pub pictures: [Frame; 3],
    /// The case as a scene, if it is one.
    pub scene: Option<Scene>,
}

/// Returns the names of the pictures of a [`CaseResult`].
pub fn case_pictures() -> [&'static str; 3] {
    [
        text!("engine-naive"),
        text!("engine-this"),
        text!("engine-reference"),
    ]
}

/// Returns the catalogue, by topic.
pub fn stability_cases() -> impl Iterator<Item = &'static Case> {
    cases::CASES.iter()
}

/// Draws a case with all three renderers.
pub fn stability(renderer: &mut Renderer, case: &'static Case) -> CaseResult {
    let pictures = match case.pictures {
        Some(make) => make(renderer),
        None => {
            let scene = case.scene().unwrap_or_default();
            let naive = naive::draw(&scene).into_iter();
            Pictures {
                naive: naive.map(|color| color.map(f64::from)).collect(),
                engine: engine_picture(renderer, &scene),
                truth: reference::draw(&scene),
                scene: Some(scene),
            }
        }
    };
    let truth: Vec<[f64; 3]> = pictures.truth.iter().map(|truth| truth.color).collect();
    let mut result = CaseResult {
        case,
        naive_error: 0.0,
        robust_error: 0.0,
        verdict: Verdict::Fails,
        pixels: 0,
        naive_off: 0,
        naive_not_finite: not_finite(&pictures.naive),
        robust_not_finite: not_finite(&pictures.engine),
        pictures: [
            frame(&pictures.naive, wrapped),
            frame(&pictures.engine, clamped),
            frame(&truth, clamped),
        ],
        scene: pictures.scene,
    };
    let compared = pictures
        .truth
        .iter()
        .zip(pictures.naive.iter().zip(&pictures.engine));
    for (truth, (naive, engine)) in compared.filter(|(truth, _)| truth.clear) {
        let truth = truth.color.map(clamped);
        let naive = greatest(truth, naive.map(wrapped));
        result.naive_error = result.naive_error.max(naive);
        let engine = greatest(truth, engine.map(clamped));
        result.robust_error = result.robust_error.max(engine);
        result.naive_off += u64::from(naive > HALF_A_CODE_VALUE);
        result.pixels += 1;
    }
    let holds = |error: f64| error <= HALF_A_CODE_VALUE;
    result.verdict = match (
        holds(result.robust_error),
        holds(result.naive_error) && result.naive_not_finite == 0,
    ) {
        (false, _) => Verdict::Fails,
        (true, false) => Verdict::RobustHolds,
        (true, true) => Verdict::BothHold,
    };
    result
}

/// Draws a scene with the engine; returns its linear intensities.
fn engine_picture(renderer: &mut Renderer, scene: &Scene) -> Vec<[f64; 3]> {
    renderer.keep_linear(true);
    renderer.render(scene);
    let pixels = renderer
        .linear()
        .iter()
        .map(|&[r, g, b, _]| [r, g, b].map(f64::from))
        .collect();
    renderer.keep_linear(false);
    pixels
}

/// Counts the pixels that are infinite or NaN.
fn not_finite(pixels: &[[f64; 3]]) -> u64 {
    let is_lost = |pixel: &&[f64; 3]| !pixel.iter().all(|v| v.is_finite());
    pixels.iter().filter(is_lost).count() as u64
}

/// Returns the maximum difference of code values in any channel; NaN is off by the whole range.
fn greatest(truth: [f64; 3], value: [f64; 3]) -> f64 {
    let of = |(a, b): (f64, f64)| if b.is_finite() { (a - b).abs() } else { 255.0 };
    truth.into_iter().zip(value).map(of).fold(0.0, f64::max)
}

/// Returns an intensity in code values, clamped.
fn clamped(intensity: f64) -> f64 {
    if intensity.is_nan() {
        f64::NAN
    } else {
        255.0 * intensity.clamp(0.0, 1.0)
    }
}

/// Returns an intensity times 255 after a cast to a byte: its lowest 8 bits.
fn wrapped(intensity: f64) -> f64 {
    let value = 255.0 * intensity;
    if value < 256.0 {
        value
    } else {
        value.rem_euclid(256.0)
    }
}

/// Colour of a pixel that is not finite, or where a law loses digits.
const MARK: [u8; 4] = [255, 0, 255, 255];

fn frame(pixels: &[[f64; 3]], code: fn(f64) -> f64) -> Frame {
    let pixel = |pixel: &[f64; 3]| {
        if !pixel.iter().all(|v| v.is_finite()) {
            return MARK;
        }
        let [r, g, b] = pixel.map(|v| code(v).round().clamp(0.0, 255.0) as u8);
        [r, g, b, 255]
    };
    Frame {
        width: cases::SIDE,
        height: cases::SIDE,
        pixels: pixels.iter().map(pixel).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::ReflectionModel;

    /// Returns the largest difference of two pictures, intensities.
    fn apart(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
        let pairs = a.as_flattened().iter().zip(b.as_flattened());
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    fn naive(scene: &Scene) -> Vec<[f64; 3]> {
        let pixels = naive::draw(scene).into_iter();
        pixels.map(|color| color.map(f64::from)).collect()
    }

    fn reference(scene: &Scene) -> Vec<[f64; 3]> {
        reference::draw(scene)
            .iter()
            .map(|truth| truth.color)
            .collect()
    }

    #[test]
    fn a_typed_law_is_drawn_in_both_precisions_as_typed() {
        let case = stability_cases().find(|case| case.name == "far-from-the-origin");
        let mut scene = case.and_then(Case::scene).expect("a scene");
        scene.image.size = [32, 32];
        let built_in = [naive(&scene), reference(&scene)];
        scene.reflection.model = ReflectionModel::Formula;
        let formulas = [
            ("kd*od*max(N·L, 0) + ks*os*max(R·V, 0)^n * (N·L > 0)", true),
            ("kd*od*max(N·L, 0) + ks*os*max(N·H, 0)^n * (N·L > 0)", false),
        ];
        for (formula, same) in formulas {
            scene.reflection.formula = formula.to_owned();
            let typed = [naive(&scene), reference(&scene)];
            for ((typed, built_in), most) in typed.iter().zip(&built_in).zip([1e-5, 1e-14]) {
                let apart = apart(typed, built_in);
                assert_eq!(apart <= most, same, "{formula}: {apart}");
            }
        }
    }
}
