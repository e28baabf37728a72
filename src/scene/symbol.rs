//! The symbols of the equation and their meanings.

use crate::text::text;

/// Defines the symbols, each with the messages of its meaning and of its numbers' unit.
macro_rules! symbols {
    ($($(#[$detail:meta])* $name:ident = $meaning:literal, $unit:literal;)+) => {
        /// A symbol of the equation that something in the window controls.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Symbol {
            $($(#[$detail])* $name,)+
        }

        impl Symbol {
            /// Returns the meaning, in a phrase.
            pub fn meaning(self) -> &'static str {
                match self {
                    $(Self::$name => text!($meaning),)+
                }
            }

            /// Returns the unit of its numbers.
            pub fn unit(self) -> &'static str {
                match self {
                    $(Self::$name => text!($unit),)+
                }
            }
        }
    };
}

symbols! {
    /// I, a pixel's intensity before the display.
    Intensity = "symbol-intensity", "measure-intensity";
    /// Ka, the ambient coefficient.
    Ka = "symbol-ka", "measure-none";
    /// Od, the colour of the surface.
    Od = "symbol-od", "measure-none";
    /// Ia, the ambient light.
    Ia = "symbol-ia", "measure-intensity";
    /// Σ, the sum over the lights.
    Lights = "symbol-lights", "measure-intensity";
    /// f, the attenuation by distance.
    Attenuation = "symbol-attenuation", "measure-distances";
    /// Ip, the intensity of a light.
    Ip = "symbol-ip", "measure-intensity";
    /// Kd, the diffuse coefficient.
    Kd = "symbol-kd", "measure-none";
    /// N, the surface normal.
    Normal = "symbol-normal", "measure-vector";
    /// L, the direction to the light.
    Light = "symbol-light", "measure-vector";
    /// Ks, the specular coefficient.
    Ks = "symbol-ks", "measure-none";
    /// R or H, the axis of the highlight.
    Reflected = "symbol-reflected", "measure-vector";
    /// V, the direction to the viewer.
    Viewer = "symbol-viewer", "measure-vector";
    /// n, the specular exponent.
    Exponent = "symbol-exponent", "measure-none";
    /// Os, the colour of the highlight.
    Os = "symbol-os", "measure-none";
    /// W, the reflectance by angle.
    Reflectance = "symbol-reflectance", "measure-none";
    /// D of microfacets, and their roughness m.
    Facets = "symbol-facets", "measure-none";
    /// G of microfacets.
    Masking = "symbol-masking", "measure-none";
    /// Kt, the transparency.
    Kt = "symbol-kt", "measure-none";
    /// It, the light transmitted through the surface.
    Transmitted = "symbol-transmitted", "measure-intensity";
    /// S, the visibility of a light.
    Shadows = "symbol-shadows", "measure-none";
    /// Light that other surfaces have scattered once.
    Bounce = "symbol-bounce", "measure-intensity";
    /// s0, the fraction that depth cueing leaves.
    Depth = "symbol-depth", "measure-none";
}
