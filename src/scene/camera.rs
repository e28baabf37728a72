//! The scene's description, the camera, the picture and its display.

use super::Rgb;
use super::choice::choices;
use super::material::{NO_LIGHT, unused};
use super::parameter::{GREATEST_LENGTH, LEAST_LENGTH, Limits, Reason, Slider, Unit, table};
use super::symbol::Symbol;
use crate::text::text;
use glam::DVec3;
use std::ops::RangeInclusive;

table! {
    /// The description of a scene for its readers. All of it may be empty.
    pub struct SceneDescription = [about] in about {
        /// The scene's title; one line of at most 80 characters.
        TITLE title: String = String::new(), Text(80);
        /// A sentence on what to look at and what to try; one line of at most 300 characters.
        SENTENCE sentence: String = String::new(), Text(300);
        /// The chapter that it belongs to; one line of at most 80 characters.
        TOPIC topic: String = String::new(), Text(80);
        /// The window's view that opens with it, one of [`VIEWS`](crate::link::VIEWS).
        VIEW view: String = String::new(), Text(80);
    }
}

const ANGLE: Slider = Slider::linear(-180.0, 180.0).decimals(1);
const FIELD_OF_VIEW: Slider = Slider::linear(5.0, 120.0).decimals(1);

table! {
    /// The camera: the point from which the picture is seen, and the position of the equation's viewer.
    pub struct Camera = [camera] in camera {
        /// Position of the eye, world.
        EYE eye: DVec3 = DVec3::new(0.0, 0.0, 4.0), Point.measured_in(Unit::World);
        /// The point at the picture's centre, world; not the eye.
        TARGET target: DVec3 = DVec3::ZERO, Point.measured_in(Unit::World);
        /// The direction that points upwards in the picture; of any length but zero, not parallel to the viewing direction.
        UP up: DVec3 = DVec3::Y, Direction(|_, _| true);
        /// Turn of the picture about its centre, degrees counter-clockwise.
        ROLL roll: f64 = 0.0, Number(Limits::FINITE, ANGLE).measured_in(Unit::Degrees);
        /// Perspective or orthographic.
        PROJECTION projection: Projection = Projection::Perspective, Choice;
        /// Angle of view in perspective projection, degrees, 0.001 to 179, across the side that `framing` names.
        FOV_Y fov_y: f64 = 40.0, Number(Limits::within(&Camera::FOV_Y), FIELD_OF_VIEW)
            .measured_in(Unit::Degrees).idle_if(&[NOT_PERSPECTIVE]);
        /// Size of the visible region in orthographic projection, world units, across the side that `framing` names.
        HEIGHT height: f64 = 2.5, Number(Limits::new(LEAST_LENGTH, GREATEST_LENGTH), Slider::logarithmic(0.1, 20.0))
            .measured_in(Unit::World).idle_if(&[NOT_ORTHOGRAPHIC]);
        /// The side of the picture that `fov_y` and `height` span.
        FRAMING framing: Framing = Framing::Height, Choice;
        /// The point or direction that the equation's V points to.
        VIEWER viewer: Viewer = Viewer::Local, Choice.letter("V", Symbol::Viewer).idle_if(&[NO_VIEWER, NO_LIGHT, UNUSED_VIEWER]);
    }
}

const NOT_PERSPECTIVE: Reason = (
    |scene, _| scene.camera.projection != Projection::Perspective,
    "idle-not-perspective",
);
const NOT_ORTHOGRAPHIC: Reason = (
    |scene, _| scene.camera.projection != Projection::Orthographic,
    "idle-not-orthographic",
);
const NO_VIEWER: Reason = (
    |scene, _| scene.material.ks == Rgb::ZERO && !scene.reflection.is_own_law(),
    "idle-viewer",
);
const UNUSED_VIEWER: Reason = unused!("V", "H", "R·V", "N·H", "V·H", "N·V", "L·V", "phi");

impl Camera {
    /// The range of the field of view, degrees. Below it a pixel is narrower than single precision resolves; above it the
    /// picture is nearly all rim.
    pub const FOV_Y: RangeInclusive<f64> = 1e-3..=179.0;

    /// Returns the side of a picture of `width` and `height`, in any unit, that the field of view or the height spans.
    pub fn span(&self, [width, height]: [f64; 2]) -> f64 {
        match self.framing {
            Framing::Height => height,
            Framing::Whole => width.min(height),
        }
    }

    /// Returns the distance from eye to target, world units: the scene's own measure of length.
    pub fn distance(&self) -> f64 {
        let span = self.eye - self.target;
        let largest = span.abs().max_element();
        if largest > 0.0 {
            (span / largest).length() * largest
        } else {
            1.0
        }
    }
}

choices! {
    /// The projection of points onto the picture plane.
    pub enum Projection = "projection" {
        /// The view of an eye: farther objects appear smaller.
        Perspective = "perspective";
        /// Parallel rays: no foreshortening.
        Orthographic = "orthographic";
    }
}

choices! {
    /// The side of the picture that the field of view or the height spans.
    pub enum Framing = "framing" {
        /// The height, from bottom to top: a narrow picture shows less.
        Height = "height";
        /// The shorter side: a picture of any shape shows all that a square one does.
        Whole = "whole";
    }
}

choices! {
    /// The point or direction that the equation's V points to.
    pub enum Viewer = "viewer" {
        /// The direction from each point to the eye.
        Local = "local";
        /// The direction from the target to the eye, the same at every point.
        Infinite = "infinite";
    }
}

table! {
    /// The picture's size and background.
    pub struct Image = [image] in image {
        /// Width and height in pixels, each 1 to 16384, with at most [`Self::MAX_PIXELS`] together.
        SIZE size: [u32; 2] = [768, 768], Other("kind-two-whole", picture_sizes).measured_in(Unit::Pixels);
        /// Linear colour where nothing is visible, 0 to 10³⁰.
        BACKGROUND background: Rgb = Rgb::ZERO, Colour(Limits::INTENSITY);
    }
}

fn picture_sizes() -> String {
    text!(
        "range-size",
        side = Image::MAX_SIDE,
        pixels = Image::MAX_PIXELS
    )
}

impl Image {
    /// The longest side of a picture, in pixels: the range of the rasterizer's fixed-point coordinates.
    pub const MAX_SIDE: u32 = 16_384;

    /// The most pixels in a picture: 16384 × 8192, half a gigabyte as stored.
    pub const MAX_PIXELS: u64 = 1 << 27;
}

table! {
    /// The conversion of intensities to stored and displayed values.
    pub struct Display = [display] in display {
        /// The treatment of intensities above 1.
        OVERFLOW overflow: Overflow = Overflow::Clamp, Choice.symbol(Symbol::Intensity);
        /// The conversion of linear intensity to the stored value.
        ENCODING encoding: Encoding = Encoding::Raw, Choice.letter("I", Symbol::Intensity);
    }
}

choices! {
    /// The treatment of I > 1.
    pub enum Overflow = "overflow" {
        /// Values above 1 are stored as 1.
        Clamp = "clamp";
        /// The whole picture is divided by its largest value.
        Scale = "scale";
        /// Pixels with a channel above 1, or without a value of the scene's own law, are hatched.
        Mark = "mark";
    }
}

choices! {
    /// The conversion of linear intensity to the stored value.
    pub enum Encoding = "encoding" {
        /// Value × 255, rounded.
        Raw = "raw";
        /// The transfer function of IEC 61966-2-1, × 255, rounded.
        Srgb = "srgb";
    }
}
