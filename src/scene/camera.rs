//! What a scene is about, the camera, the picture and its display.

use super::choice::choices;
use super::material::no_light;
use super::parameter::{GREATEST_LENGTH, LEAST_LENGTH, Limits, Slider, Unit, table};
use super::symbol::Symbol;
use super::{Rgb, Scene};
use crate::text::text;
use glam::DVec3;
use std::ops::RangeInclusive;

table! {
    /// What a scene shows, for its readers. All of it may be empty.
    pub struct About = [about] in about {
        TITLE title: String = String::new(), Text(80);
        SENTENCE sentence: String = String::new(), Text(300);
        TOPIC topic: String = String::new(), Text(80);
        VIEW view: String = String::new(), Text(80);
    }
}

const ANGLE: Slider = Slider::linear(-180.0, 180.0).decimals(1);
const FIELD_OF_VIEW: Slider = Slider::linear(5.0, 120.0).decimals(1);

table! {
    /// The camera: where the picture is seen from, and where the equation's viewer stands.
    pub struct Camera = [camera] in camera {
        EYE eye: DVec3 = DVec3::new(0.0, 0.0, 4.0), Point.measured_in(Unit::World);
        TARGET target: DVec3 = DVec3::ZERO, Point.measured_in(Unit::World);
        UP up: DVec3 = DVec3::Y, Direction(|_, _| true);
        ROLL roll: f64 = 0.0, Number(Limits::FINITE, ANGLE).measured_in(Unit::Degrees);
        PROJECTION projection: Projection = Projection::Perspective, Choice;
        FOV_Y fov_y: f64 = 40.0, Number(Limits::within(&Camera::FOV_Y), FIELD_OF_VIEW)
            .measured_in(Unit::Degrees).idle(no_perspective);
        HEIGHT height: f64 = 2.5, Number(Limits::new(LEAST_LENGTH, GREATEST_LENGTH), Slider::logarithmic(0.1, 20.0))
            .measured_in(Unit::World).idle(not_orthographic);
        FRAMING framing: Framing = Framing::Height, Choice;
        VIEWER viewer: Viewer = Viewer::Local, Choice.letter("V", Symbol::Viewer).idle(no_viewer);
    }
}

fn no_perspective(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.camera.projection != Projection::Perspective).then(|| text!("idle-not-perspective"))
}

fn not_orthographic(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.camera.projection != Projection::Orthographic).then(|| text!("idle-not-orthographic"))
}

fn no_viewer(scene: &Scene, index: usize) -> Option<&'static str> {
    (scene.material.ks == Rgb::ZERO)
        .then(|| text!("idle-viewer"))
        .or(no_light(scene, index))
}

impl Camera {
    /// Degrees. Below, a pixel is narrower than single precision resolves; above, the picture is all rim.
    pub const FOV_Y: RangeInclusive<f64> = 1e-3..=179.0;

    /// The side of a picture of `width` and `height`, in any unit, that the field of view or the height spans.
    pub fn span(&self, [width, height]: [f64; 2]) -> f64 {
        match self.framing {
            Framing::Height => height,
            Framing::Whole => width.min(height),
        }
    }

    /// Distance from eye to target, world units: the scene's own measure of length.
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
    pub enum Projection = "projection" {
        Perspective = "perspective";
        Orthographic = "orthographic";
    }
}

choices! {
    /// Which side of the picture the field of view or the height spans.
    pub enum Framing = "framing" {
        Height = "height";
        Whole = "whole";
    }
}

choices! {
    /// Where the equation's V points.
    pub enum Viewer = "viewer" {
        Local = "local";
        Infinite = "infinite";
    }
}

table! {
    /// The picture's size and background.
    pub struct Image = [image] in image {
        SIZE size: [u32; 2] = [768, 768], Other("kind-two-whole", picture_sizes).measured_in(Unit::Pixels);
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
    /// The longest side of a picture, in pixels: what the rasterizer's fixed-point coordinates carry.
    pub const MAX_SIDE: u32 = 16_384;

    /// Most pixels in a picture: 16384 × 8192, half a gigabyte as stored.
    pub const MAX_PIXELS: u64 = 1 << 27;
}

table! {
    /// How intensities become what is stored and shown.
    pub struct Display = [display] in display {
        OVERFLOW overflow: Overflow = Overflow::Clamp, Choice.symbol(Symbol::Intensity);
        ENCODING encoding: Encoding = Encoding::Raw, Choice.letter("I", Symbol::Intensity);
    }
}

choices! {
    /// What happens where I > 1.
    pub enum Overflow = "overflow" {
        Clamp = "clamp";
        Scale = "scale";
        Mark = "mark";
    }
}

choices! {
    /// From linear intensity to the stored value.
    pub enum Encoding = "encoding" {
        Raw = "raw";
        Srgb = "srgb";
    }
}
