//! The file's version, the camera, the picture and its display.

use super::super::{Camera, GREATEST_LENGTH, Image, LEAST_LENGTH, Rgb};
use super::access::access;
use super::{Kind, Limits, Parameter, Slider, Symbol};
use crate::scene::Projection;

pub(super) const ALL: &[&Parameter] = &[
    &VERSION,
    &TITLE,
    &SENTENCE,
    &TOPIC,
    &VIEW,
    &EYE,
    &TARGET,
    &UP,
    &ROLL,
    &PROJECTION,
    &FOV_Y,
    &HEIGHT,
    &VIEWER,
    &SIZE,
    &BACKGROUND,
    &OVERFLOW,
    &ENCODING,
];

static VERSION: Parameter = Parameter::new(
    "version",
    "version",
    Kind::Other { at: &access!(version), kind: "whole number", limits: "1" },
    "The version of the scene file's format.",
);

static TITLE: Parameter = Parameter::new(
    "about.title",
    "Title",
    Kind::Text { at: access!(about.title), longest: 80 },
    "What the scene is called.",
);

static SENTENCE: Parameter = Parameter::new(
    "about.sentence",
    "Sentence",
    Kind::Text { at: access!(about.sentence), longest: 300 },
    "What there is to see, in a sentence.",
);

static TOPIC: Parameter = Parameter::new(
    "about.topic",
    "Topic",
    Kind::Text { at: access!(about.topic), longest: 80 },
    "The chapter that the scene belongs to.",
);

static VIEW: Parameter = Parameter::new(
    "about.view",
    "View",
    Kind::Text { at: access!(about.view), longest: 80 },
    "The tab of the window that shows the scene's point, for example `profile`; it opens with the scene.",
);

pub static EYE: Parameter =
    Parameter::new("camera.eye", "Eye", Kind::Point(access!(camera.eye)), "The point that the scene is seen from.")
        .unit("world units");

pub static TARGET: Parameter = Parameter::new(
    "camera.target",
    "Target",
    Kind::Point(access!(camera.target)),
    "The point that the camera looks at, in the middle of the picture. It differs from the eye.",
)
.unit("world units");

pub static UP: Parameter = Parameter::new(
    "camera.up",
    "Up",
    Kind::Direction { at: access!(camera.up), needed: |_, _| true },
    "The direction that appears upwards. It is not parallel to the viewing direction.",
);

pub static ROLL: Parameter = Parameter::new(
    "camera.roll",
    "Roll",
    Kind::Number {
        at: access!(camera.roll),
        limits: Limits::FINITE,
        slider: Slider::linear(-180.0, 180.0).decimals(1),
    },
    "The angle by which the picture is turned about its middle, counter-clockwise.",
)
.unit("degrees");

pub static PROJECTION: Parameter = Parameter::new(
    "camera.projection",
    "Projection",
    Kind::Choice(&access!(camera.projection)),
    "How points are projected onto the picture.",
);

pub static FOV_Y: Parameter = Parameter::new(
    "camera.fov_y",
    "Field of view",
    Kind::Number {
        at: access!(camera.fov_y),
        limits: Limits::new(*Camera::FOV_Y.start(), *Camera::FOV_Y.end()),
        slider: Slider::linear(5.0, 120.0).decimals(1),
    },
    "The angle that the picture spans from bottom to top in perspective projection.",
)
.unit("degrees")
.idle(|scene, _| {
    (scene.camera.projection != Projection::Perspective).then_some("The projection is orthographic: see Height")
});

pub static HEIGHT: Parameter = Parameter::new(
    "camera.height",
    "Height",
    Kind::Number {
        at: access!(camera.height),
        limits: Limits::new(LEAST_LENGTH, GREATEST_LENGTH),
        slider: Slider::logarithmic(0.1, 20.0),
    },
    "The length that the picture spans from bottom to top in orthographic projection.",
)
.unit("world units")
.idle(|scene, _| {
    (scene.camera.projection != Projection::Orthographic).then_some("The projection is perspective: see Field of view")
});

pub static VIEWER: Parameter = Parameter::new(
    "camera.viewer",
    "viewer",
    Kind::Choice(&access!(camera.viewer)),
    "Where V points: to the eye from each point, or in one constant direction, as if the viewer were infinitely far away.",
)
.letter("V", Symbol::Viewer)
.idle(|scene, _| {
    (scene.material.ks == Rgb::ZERO)
        .then_some("Ks is 0: only the specular term depends on the viewer")
        .or(super::material::no_light(scene))
});

static SIZE: Parameter = Parameter::new(
    "image.size",
    "Size",
    Kind::Other {
        at: &access!(image.size),
        kind: "two whole numbers",
        limits: "1 to 16384 each, 134217728 pixels in all",
    },
    "Width and height of the picture.",
)
.unit("pixels");

pub static BACKGROUND: Parameter = Parameter::new(
    "image.background",
    "Background",
    Kind::Colour { at: access!(image.background), limits: Limits::INTENSITY },
    "The linear colour where no surface is seen.",
);

pub static OVERFLOW: Parameter = Parameter::new(
    "display.overflow",
    "Overflow",
    Kind::Choice(&access!(display.overflow)),
    "What happens to intensities above 1, which a display cannot show.",
)
.symbol(Symbol::Intensity);

pub static ENCODING: Parameter = Parameter::new(
    "display.encoding",
    "encoding",
    Kind::Choice(&access!(display.encoding)),
    "How linear intensity becomes the stored value.",
)
.letter("I", Symbol::Intensity);

const _: () = assert!(Image::MAX_SIDE == 16_384 && Image::MAX_PIXELS == 134_217_728, "as SIZE says");
