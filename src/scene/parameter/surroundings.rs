//! The ground, the backdrop, depth cueing and the comparison.

use super::super::{Compare, CompareView, CuedBy, Material, Pane, PatternKind, Rgb, Scene};
use super::access::access;
use super::material::{FIELD, no_light};
use super::{Kind, Limits, Parameter, Slider, Symbol};

pub(super) const ALL: &[&Parameter] = &[
    &GROUND_VISIBLE,
    &GROUND_HEIGHT,
    &GROUND_KA,
    &GROUND_KD,
    &GROUND_COLOR,
    &BACKDROP_PATTERN,
    &BACKDROP_COLOR,
    &BACKDROP_SCALE,
    &BACKDROP_DISTANCE,
    &CUED_BY,
    &FRONT,
    &BACK,
    &FRONT_SCALE,
    &BACK_SCALE,
    &CUE_COLOR,
    &COMPARE_VIEW,
    &WIPE,
    &DIFFERENCE,
    &GAIN,
    &PANE_NAME,
    &PANE_SET,
];

pub static GROUND_VISIBLE: Parameter = Parameter::new(
    "ground.visible",
    "Ground",
    Kind::Switch(access!(ground.visible)),
    "Whether there is a level floor, which receives light and shadows and hides no part of the object.",
);

fn no_ground(scene: &Scene) -> Option<&'static str> {
    (!scene.ground.visible).then_some("There is no ground")
}

pub static GROUND_HEIGHT: Parameter = Parameter::new(
    "ground.height",
    "Ground height",
    Kind::Number { at: access!(ground.height), limits: Limits::COORDINATE, slider: Slider::linear(-3.0, 3.0) },
    "The floor's y coordinate.",
)
.label("Height")
.unit("world units")
.idle(|scene, _| no_ground(scene));

const COEFFICIENT: Limits = Limits::new(0.0, Material::MAX_COEFFICIENT);

pub static GROUND_KA: Parameter = Parameter::new(
    "ground.ka",
    "Ground Ka",
    Kind::Number { at: access!(ground.ka), limits: COEFFICIENT, slider: Slider::UNIT },
    "The floor's ambient coefficient.",
)
.label("Ka ambient")
.idle(|scene, _| {
    no_ground(scene).or((scene.ambient.color == Rgb::ZERO).then_some("Ia is black: there is no ambient light"))
});

pub static GROUND_KD: Parameter = Parameter::new(
    "ground.kd",
    "Ground Kd",
    Kind::Number { at: access!(ground.kd), limits: COEFFICIENT, slider: Slider::UNIT },
    "The floor's diffuse coefficient; it has no highlight.",
)
.label("Kd diffuse")
.idle(|scene, _| no_ground(scene).or(no_light(scene)));

pub static GROUND_COLOR: Parameter = Parameter::new(
    "ground.color",
    "Ground colour",
    Kind::Colour { at: access!(ground.color), limits: COEFFICIENT },
    "The floor's own colour Od, linear.",
)
.label("Od colour")
.idle(|scene, _| no_ground(scene));

pub static BACKDROP_PATTERN: Parameter = Parameter::new(
    "backdrop.pattern",
    "Backdrop",
    Kind::Choice(&access!(backdrop.pattern)),
    "The pattern of a wall behind the object, perpendicular to the viewing direction; between its fields the background is seen.",
);

fn no_backdrop(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.backdrop.pattern == PatternKind::None).then_some("There is no backdrop")
}

pub static BACKDROP_COLOR: Parameter = Parameter::new(
    "backdrop.color",
    "Backdrop colour",
    Kind::Colour { at: access!(backdrop.color), limits: Limits::INTENSITY },
    "The linear colour of the backdrop's pattern, which no light changes.",
)
.label("Colour")
.idle(no_backdrop);

pub static BACKDROP_SCALE: Parameter = Parameter::new(
    "backdrop.scale",
    "Backdrop scale",
    Kind::Number { at: access!(backdrop.scale), limits: FIELD, slider: Slider::logarithmic(0.01, 4.0) },
    "The width of one field of the backdrop's pattern.",
)
.label("Field width")
.unit("world units")
.idle(no_backdrop);

pub static BACKDROP_DISTANCE: Parameter = Parameter::new(
    "backdrop.distance",
    "Backdrop distance",
    Kind::Number { at: access!(backdrop.distance), limits: Limits::COORDINATE, slider: Slider::linear(0.0, 10.0) },
    "How far the backdrop is behind the camera's target.",
)
.label("Distance")
.unit("world units")
.idle(no_backdrop);

pub static CUED_BY: Parameter = Parameter::new(
    "depth_cueing.by",
    "Depth cueing",
    Kind::Choice(&access!(depth_cueing.by)),
    "Whether distant parts fade into one colour, and where the fading is evaluated: s0·I + (1 − s0)·Idc is shown.",
)
.symbol(Symbol::Depth);

const fn cueing(parameter: Parameter) -> Parameter {
    parameter
        .symbol(Symbol::Depth)
        .idle(|scene, _| (scene.depth_cueing.by == CuedBy::Off).then_some("Depth cueing is off"))
}

const DEPTHS: Slider = Slider::linear(0.0, 10.0);

pub static FRONT: Parameter = cueing(
    Parameter::new(
        "depth_cueing.front",
        "start of fading",
        Kind::Number { at: access!(depth_cueing.front), limits: Limits::LENGTH, slider: DEPTHS },
        "The depth where fading begins. Depth is the distance from the eye along the viewing direction.",
    )
    .label("begins at")
    .letter("z", Symbol::Depth)
    .unit("world units"),
);

pub static BACK: Parameter = cueing(
    Parameter::new(
        "depth_cueing.back",
        "end of fading",
        Kind::Number { at: access!(depth_cueing.back), limits: Limits::LENGTH, slider: DEPTHS },
        "The depth where fading is complete, greater than the depth where it begins.",
    )
    .label("complete at")
    .letter("z", Symbol::Depth)
    .unit("world units"),
);

pub static FRONT_SCALE: Parameter = cueing(
    Parameter::new(
        "depth_cueing.front_scale",
        "remaining intensity in front",
        Kind::Number { at: access!(depth_cueing.front_scale), limits: Limits::UNIT, slider: Slider::UNIT },
        "The fraction of the intensity that remains where fading begins.",
    )
    .label("in front")
    .letter("s0", Symbol::Depth),
);

pub static BACK_SCALE: Parameter = cueing(
    Parameter::new(
        "depth_cueing.back_scale",
        "remaining intensity at the back",
        Kind::Number { at: access!(depth_cueing.back_scale), limits: Limits::UNIT, slider: Slider::UNIT },
        "The fraction of the intensity that remains where fading is complete.",
    )
    .label("at the back")
    .letter("s0", Symbol::Depth),
);

pub static CUE_COLOR: Parameter = cueing(
    Parameter::new(
        "depth_cueing.color",
        "fading colour",
        Kind::Colour { at: access!(depth_cueing.color), limits: Limits::INTENSITY },
        "The linear colour that the object fades into. With the background's colour it disappears in the distance.",
    )
    .label("colour")
    .letter("Idc", Symbol::Depth),
);

pub static COMPARE_VIEW: Parameter = Parameter::new(
    "compare.view",
    "Comparison",
    Kind::Choice(&access!(compare.view)),
    "How the scene and its panes are shown.",
);

pub static WIPE: Parameter = Parameter::new(
    "compare.wipe",
    "Wipe position",
    Kind::Number { at: access!(compare.wipe), limits: Limits::UNIT, slider: Slider::UNIT },
    "Where the line of a wipe is, from 0 at the left to 1 at the right.",
)
.idle(|scene, _| (scene.compare.view != CompareView::Wipe).then_some("The comparison is not a wipe"));

fn no_difference(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.compare.view != CompareView::Difference).then_some("The comparison shows no difference picture")
}

pub static DIFFERENCE: Parameter = Parameter::new(
    "compare.difference",
    "Difference kind",
    Kind::Choice(&access!(compare.difference)),
    "What the difference picture shows of each pixel's difference d.",
)
.idle(no_difference);

pub static GAIN: Parameter = Parameter::new(
    "compare.gain",
    "Gain",
    Kind::Number {
        at: access!(compare.gain),
        limits: Limits::new(1.0, Compare::MAX_GAIN),
        slider: Slider::logarithmic(1.0, Compare::MAX_GAIN).decimals(1),
    },
    "The factor that the difference is multiplied by before it is shown.",
)
.idle(no_difference);

static PANE_NAME: Parameter = Parameter::new(
    "compare.pane.N.name",
    "Pane name",
    Kind::Text { at: access!(pane: name), longest: Pane::MAX_NAME },
    "What a pane beside the scene is called; without a name it is called by its settings. At most 3 panes.",
);

static PANE_SET: Parameter = Parameter::new(
    "compare.pane.N.set",
    "Pane settings",
    Kind::Other { at: &access!(pane: set), kind: "list of settings", limits: "at most 64" },
    "The keys that differ in a pane, each as `--set` takes it.",
);
