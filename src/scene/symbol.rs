//! The symbols of the equation, and what each means.

const INTENSITY: &str = "linear intensity, 1 is white";
const UNIT_VECTOR: &str = "a unit vector, world";
const NO_UNIT: &str = "no unit";

/// Defines the symbols, each with its meaning and what its numbers are measured in.
macro_rules! symbols {
    ($($name:ident = $meaning:literal, $unit:expr;)+) => {
        /// A symbol of the equation that something in the window controls.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Symbol {
            $(#[doc = $meaning] $name,)+
        }

        impl Symbol {
            /// What the symbol stands for, in a phrase.
            pub const fn meaning(self) -> &'static str {
                match self {
                    $(Self::$name => $meaning,)+
                }
            }

            /// What its numbers are measured in.
            pub const fn unit(self) -> &'static str {
                match self {
                    $(Self::$name => $unit,)+
                }
            }
        }
    };
}

symbols! {
    Intensity = "I: the intensity of a pixel, red, green and blue; 1 is the display's white", INTENSITY;
    Ka = "Ka: how much of the ambient light the surface returns", NO_UNIT;
    Od = "Od: the surface's own colour, which multiplies the ambient and the diffuse light", NO_UNIT;
    Ia = "Ia: the ambient light, which comes from everywhere alike", INTENSITY;
    Lights = "Σ: the contributions of all lights are added", INTENSITY;
    Attenuation = "f: how a light weakens with distance", "no unit; distances are world units";
    Ip = "Ip: the intensity of a light source, red, green and blue", INTENSITY;
    Kd = "Kd: how much light the surface scatters evenly to all sides (Lambert)", NO_UNIT;
    Normal = "N: the unit vector at right angles to the surface", UNIT_VECTOR;
    Light = "L: the unit vector from the surface to the light", UNIT_VECTOR;
    Ks = "Ks: how much light the surface returns about the mirror direction", NO_UNIT;
    Reflected = "R: L mirrored at N; Blinn's model measures H, half-way between L and V, against N instead", UNIT_VECTOR;
    Viewer = "V: the unit vector from the surface to the viewer", UNIT_VECTOR;
    Exponent = "n: the specular exponent; the greater, the smaller and sharper the highlight", NO_UNIT;
    Os = "Os: the colour of the highlight, which multiplies Ks", NO_UNIT;
    Reflectance = "W(θ): the part of the light that is reflected at the angle of incidence θ (Fresnel)", NO_UNIT;
    Facets = "D: how many microfacets mirror the light to the viewer; m is their roughness", NO_UNIT;
    Masking = "G: how many of these microfacets are lit and seen, and not hidden by others", NO_UNIT;
    Kt = "Kt: the part of the light that comes through the surface", NO_UNIT;
    Transmitted = "It: the light from behind, bent by Snell's law", INTENSITY;
    Shadows = "Whether what stands between keeps a light away", NO_UNIT;
    Bounce = "What the ambient light stands for", INTENSITY;
    Depth = "s0: what is left of the intensity at its depth; the rest is Idc, the colour that the object fades into", NO_UNIT;
}
