//! The symbols of the equation, and what each means.

use crate::text::text;

/// Defines the symbols, each with the messages of its meaning and of what its numbers are measured in.
macro_rules! symbols {
    ($($name:ident = $meaning:literal, $unit:literal;)+) => {
        /// A symbol of the equation that something in the window controls.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Symbol {
            $($name,)+
        }

        impl Symbol {
            /// What the symbol stands for, in a phrase.
            pub fn meaning(self) -> &'static str {
                match self {
                    $(Self::$name => text!($meaning),)+
                }
            }

            /// What its numbers are measured in.
            pub fn unit(self) -> &'static str {
                match self {
                    $(Self::$name => text!($unit),)+
                }
            }
        }
    };
}

symbols! {
    Intensity = "symbol-intensity", "measure-intensity";
    Ka = "symbol-ka", "measure-none";
    Od = "symbol-od", "measure-none";
    Ia = "symbol-ia", "measure-intensity";
    Lights = "symbol-lights", "measure-intensity";
    Attenuation = "symbol-attenuation", "measure-distances";
    Ip = "symbol-ip", "measure-intensity";
    Kd = "symbol-kd", "measure-none";
    Normal = "symbol-normal", "measure-vector";
    Light = "symbol-light", "measure-vector";
    Ks = "symbol-ks", "measure-none";
    Reflected = "symbol-reflected", "measure-vector";
    Viewer = "symbol-viewer", "measure-vector";
    Exponent = "symbol-exponent", "measure-none";
    Os = "symbol-os", "measure-none";
    Reflectance = "symbol-reflectance", "measure-none";
    Facets = "symbol-facets", "measure-none";
    Masking = "symbol-masking", "measure-none";
    Kt = "symbol-kt", "measure-none";
    Transmitted = "symbol-transmitted", "measure-intensity";
    Shadows = "symbol-shadows", "measure-none";
    Bounce = "symbol-bounce", "measure-intensity";
    Depth = "symbol-depth", "measure-none";
}
