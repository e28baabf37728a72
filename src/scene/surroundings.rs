//! The surroundings of the object: the ground under it, the wall behind it, and the fog before it.

use super::Rgb;
use super::choice::choices;
use super::material::{COEFFICIENT, FIELD, FIELD_SLIDER, NO_AMBIENT, NO_LIGHT, PatternKind};
use super::parameter::{Limits, Reason, Slider, Unit, table};
use super::symbol::Symbol;

table! {
    /// A horizontal floor that receives light and shadows. It is visible from above, behind the object, and in front of the
    /// parts of the wall that are farther away.
    pub struct Ground = [ground] in ground {
        /// A switch that shows the floor.
        GROUND_VISIBLE visible: bool = false, Switch;
        /// The floor's y, world units.
        GROUND_HEIGHT height: f64 = -1.0, Number(Limits::COORDINATE, Slider::linear(-3.0, 3.0))
            .measured_in(Unit::World).idle_if(&[NO_GROUND]);
        /// The floor's ambient coefficient Ka, 0 to 10⁶.
        GROUND_KA ka: f64 = 0.1, Number(COEFFICIENT, Slider::UNIT)
            .idle_if(&[NO_GROUND, NO_AMBIENT]);
        /// The floor's diffuse coefficient Kd, 0 to 10⁶.
        GROUND_KD kd: f64 = 0.7, Number(COEFFICIENT, Slider::UNIT)
            .idle_if(&[NO_GROUND, NO_LIGHT]);
        /// The floor's colour Od, linear.
        GROUND_COLOR color: Rgb = Rgb::new(0.8, 0.8, 0.8), Colour(COEFFICIENT).idle_if(&[NO_GROUND]);
    }
}

const NO_GROUND: Reason = (|scene, _| !scene.ground.visible, "idle-no-ground");

table! {
    /// A patterned wall behind the object, perpendicular to the viewing direction and without end. Between the pattern it
    /// has the background's colour; it hides the parts of the ground beyond it.
    pub struct Backdrop = [backdrop] in backdrop {
        /// The pattern; without one there is no wall.
        BACKDROP_PATTERN pattern: PatternKind = PatternKind::None, Choice;
        /// Colour of the pattern, linear: displayed as it is, not lit.
        BACKDROP_COLOR color: Rgb = Rgb::new(0.85, 0.83, 0.78), Colour(Limits::INTENSITY).idle_if(&[NO_BACKDROP]);
        /// Width of a field, world units.
        BACKDROP_SCALE scale: f64 = 0.4, Number(FIELD, FIELD_SLIDER).measured_in(Unit::World).idle_if(&[NO_BACKDROP]);
        /// Distance behind the target along the viewing direction, world units.
        BACKDROP_DISTANCE distance: f64 = 2.0, Number(Limits::COORDINATE, Slider::linear(0.0, 10.0))
            .measured_in(Unit::World).idle_if(&[NO_BACKDROP]);
    }
}

const NO_BACKDROP: Reason = (
    |scene, _| scene.backdrop.pattern == PatternKind::None,
    "idle-no-backdrop",
);
const DEPTHS: Slider = Slider::linear(0.0, 10.0);

table! {
    /// Depth cueing after Foley, van Dam, Feiner and Hughes 1990, section 16.1.4: `I' = s0·I + (1 − s0)·Idc`.
    ///
    /// s0 depends on the depth z, the distance from the eye along the viewing direction: it is [`Self::front_scale`] up to
    /// [`Self::front`], [`Self::back_scale`] from [`Self::back`] on, and linear between the two. Only the object fades;
    /// ground, backdrop and background keep their colours.
    #[derive(Copy)]
    pub struct DepthCueing = [depth_cueing] in depth_cueing {
        /// The points where s0 is evaluated, or no fading.
        CUED_BY by: CuedBy = CuedBy::Off, Choice.symbol(Symbol::Depth);
        /// Depth at which fading begins, world units.
        FRONT front: f64 = 3.0, Number(Limits::LENGTH, DEPTHS)
            .letter("z", Symbol::Depth).measured_in(Unit::World).idle_if(&[NO_CUEING]);
        /// Depth at which fading ends, world units.
        BACK back: f64 = 5.0, Number(Limits::LENGTH, DEPTHS)
            .letter("z", Symbol::Depth).measured_in(Unit::World).idle_if(&[NO_CUEING]);
        /// s0 up to [`Self::front`], 0 to 1.
        FRONT_SCALE front_scale: f64 = 1.0, Number(Limits::UNIT, Slider::UNIT).letter("s0", Symbol::Depth).idle_if(&[NO_CUEING]);
        /// s0 from [`Self::back`] on, 0 to 1.
        BACK_SCALE back_scale: f64 = 0.0, Number(Limits::UNIT, Slider::UNIT).letter("s0", Symbol::Depth).idle_if(&[NO_CUEING]);
        /// The colour Idc to which the object fades, linear.
        CUE_COLOR color: Rgb = Rgb::ZERO, Colour(Limits::INTENSITY).letter("Idc", Symbol::Depth).idle_if(&[NO_CUEING]);
    }
}

const NO_CUEING: Reason = (
    |scene, _| scene.depth_cueing.by == CuedBy::Off,
    "idle-no-cueing",
);

impl DepthCueing {
    /// Returns s0 at `depth`: the fraction of the intensity that remains there.
    pub fn scale_at(&self, depth: f64) -> f64 {
        // 1 at the front, 0 at the back.
        let nearness = ((self.back - depth) / (self.back - self.front)).clamp(0.0, 1.0);
        nearness * self.front_scale + (1.0 - nearness) * self.back_scale
    }
}

choices! {
    /// The points where s0 is evaluated.
    pub enum CuedBy = "depth-cueing" {
        /// No fading.
        Off = "off";
        /// Fading where intensities are known, at vertices or faces, before they are interpolated; in Phong shading s0
        /// itself is interpolated between the vertices. Exact shading has no vertices and uses each pixel's depth.
        Vertex = "vertex";
        /// Fading by the depth of each pixel.
        Pixel = "pixel";
    }
}
