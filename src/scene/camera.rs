//! What a scene is about, the camera, the picture and its display.

use super::choice::choices;
use super::material::no_light;
use super::parameter::{GREATEST_LENGTH, LEAST_LENGTH, Limits, Slider, table};
use super::symbol::Symbol;
use super::{Rgb, Scene};
use glam::DVec3;
use std::ops::RangeInclusive;

table! {
    /// What a scene shows, for its readers. All of it may be empty.
    pub struct About = "about" in about {
        TITLE title: String = String::new(), Text(80), "Title", "What the scene is called.";
        SENTENCE sentence: String = String::new(), Text(300), "Sentence", "What there is to see, in a sentence.";
        TOPIC topic: String = String::new(), Text(80), "Topic", "The chapter that the scene belongs to.";
        VIEW view: String = String::new(), Text(80), "View",
            "The tab of the window that shows the scene's point, for example `profile`; it opens with the scene.";
    }
}

const ANGLE: Slider = Slider::linear(-180.0, 180.0).decimals(1);
const FIELD_OF_VIEW: Slider = Slider::linear(5.0, 120.0).decimals(1);

table! {
    /// The camera: where the picture is seen from, and where the equation's viewer stands.
    pub struct Camera = "camera" in camera {
        EYE eye: DVec3 = DVec3::new(0.0, 0.0, 4.0), Point, "Eye",
            "The point that the scene is seen from.".unit("world units");
        TARGET target: DVec3 = DVec3::ZERO, Point, "Target",
            "The point that the camera looks at, in the middle of the picture. It differs from the eye."
            .unit("world units");
        UP up: DVec3 = DVec3::Y, Direction(|_, _| true), "Up",
            "The direction that appears upwards. It is not parallel to the viewing direction.";
        ROLL roll: f64 = 0.0, Number(Limits::FINITE, ANGLE), "Roll",
            "The angle by which the picture is turned about its middle, counter-clockwise.".unit("degrees");
        PROJECTION projection: Projection = Projection::Perspective, Choice, "Projection",
            "How points are projected onto the picture.";
        FOV_Y fov_y: f64 = 40.0, Number(Limits::within(&Camera::FOV_Y), FIELD_OF_VIEW), "Field of view",
            "The angle that the picture spans in perspective projection: from bottom to top, or as `camera.framing` says."
            .unit("degrees").idle(no_perspective);
        HEIGHT height: f64 = 2.5, Number(Limits::new(LEAST_LENGTH, GREATEST_LENGTH), Slider::logarithmic(0.1, 20.0)), "Height",
            "The length that the picture spans in orthographic projection: from bottom to top, or as `camera.framing` says."
            .unit("world units").idle(not_orthographic);
        FRAMING framing: Framing = Framing::Height, Choice, "Framing",
            "Which side of the picture the field of view or the height spans.";
        VIEWER viewer: Viewer = Viewer::Local, Choice, "viewer",
            "Where V points: to the eye from each point, or in one constant direction, as if the viewer were infinitely far away."
            .letter("V", Symbol::Viewer).idle(no_viewer);
    }
}

fn no_perspective(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.camera.projection != Projection::Perspective)
        .then_some("The projection is orthographic: see Height")
}

fn not_orthographic(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.camera.projection != Projection::Orthographic)
        .then_some("The projection is perspective: see Field of view")
}

fn no_viewer(scene: &Scene, index: usize) -> Option<&'static str> {
    (scene.material.ks == Rgb::ZERO)
        .then_some("Ks is 0: only the specular term depends on the viewer")
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
    pub enum Projection {
        Perspective = "perspective", "perspective", "As an eye or a camera sees";
        Orthographic = "orthographic", "orthographic", "Parallel rays: no foreshortening";
    }
}

choices! {
    /// Which side of the picture the field of view or the height spans.
    pub enum Framing {
        Height = "height", "picture height", "From bottom to top, whatever the width: a narrow picture shows less";
        Whole = "whole", "shorter side", "The shorter side: whatever a square picture shows stays in sight in any shape";
    }
}

choices! {
    /// Where the equation's V points.
    pub enum Viewer {
        Local = "local", "at the eye", "V points to the eye from each point";
        Infinite = "infinite", "at infinity", "V is constant, from target to eye";
    }
}

table! {
    /// The picture's size and background.
    pub struct Image = "image" in image {
        SIZE size: [u32; 2] = [768, 768], Other("two whole numbers", "1 to 16384 each, 134217728 pixels in all"), "Size",
            "Width and height of the picture.".unit("pixels");
        BACKGROUND background: Rgb = Rgb::ZERO, Colour(Limits::INTENSITY), "Background",
            "The linear colour where no surface is seen.";
    }
}

impl Image {
    /// The longest side of a picture, in pixels: what the rasterizer's fixed-point coordinates carry.
    pub const MAX_SIDE: u32 = 16_384;

    /// Most pixels in a picture: 16384 × 8192, half a gigabyte as stored.
    pub const MAX_PIXELS: u64 = 1 << 27;
}

const _: () = assert!(
    Image::MAX_SIDE == 16_384 && Image::MAX_PIXELS == 134_217_728,
    "as SIZE says"
);

table! {
    /// How intensities become what is stored and shown.
    pub struct Display = "display" in display {
        OVERFLOW overflow: Overflow = Overflow::Clamp, Choice, "Overflow",
            "What happens to intensities above 1, which a display cannot show.".symbol(Symbol::Intensity);
        ENCODING encoding: Encoding = Encoding::Raw, Choice, "encoding",
            "How linear intensity becomes the stored value.".letter("I", Symbol::Intensity);
    }
}

choices! {
    /// What happens where I > 1.
    pub enum Overflow {
        Clamp = "clamp", "clamp", "Shown as 1";
        Scale = "scale", "scale the picture", "The whole picture is divided by its greatest value";
        Mark = "mark", "mark", "Hatched where a channel is above 1";
    }
}

choices! {
    /// From linear intensity to the stored value.
    pub enum Encoding {
        Raw = "raw", "value × 255", "As in the textbooks: value × 255, rounded";
        Srgb = "srgb", "sRGB", "The transfer function of IEC 61966-2-1: light on the screen is proportional to I";
    }
}
