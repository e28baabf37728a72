//! The symbols of the equation, and what each means.

/// A symbol of the equation that something in the window controls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Symbol {
    /// I, the intensity and its way to the display.
    Intensity,
    Ka,
    Od,
    Ia,
    /// Σ, the lights.
    Lights,
    /// f, attenuation.
    Attenuation,
    Ip,
    Kd,
    /// N, the normal.
    Normal,
    /// L, where a light is.
    Light,
    Ks,
    /// R, or H: the model of reflection.
    Reflected,
    /// V, the viewer.
    Viewer,
    /// n, the specular exponent.
    Exponent,
    /// Os, the colour of the highlight.
    Os,
    /// W(θ), by the angle of incidence.
    Reflectance,
    /// D, the microfacets that mirror the light.
    Facets,
    /// G, those of them that are lit and seen.
    Masking,
    Kt,
    /// It, the transmitted light.
    Transmitted,
    /// Whether a light reaches the point.
    Shadows,
    /// What Ia stands for.
    Bounce,
    /// s0 and Idc, depth cueing.
    Depth,
}

impl Symbol {
    /// What the symbol stands for, in a phrase.
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Intensity => "I: the intensity of a pixel, red, green and blue; 1 is the display's white",
            Self::Ka => "Ka: how much of the ambient light the surface returns",
            Self::Od => "Od: the surface's own colour, which multiplies the ambient and the diffuse light",
            Self::Ia => "Ia: the ambient light, which comes from everywhere alike",
            Self::Lights => "Σ: the contributions of all lights are added",
            Self::Attenuation => "f: how a light weakens with distance",
            Self::Ip => "Ip: the intensity of a light source, red, green and blue",
            Self::Kd => "Kd: how much light the surface scatters evenly to all sides (Lambert)",
            Self::Normal => "N: the unit vector at right angles to the surface",
            Self::Light => "L: the unit vector from the surface to the light",
            Self::Ks => "Ks: how much light the surface returns about the mirror direction",
            Self::Reflected => {
                "R: L mirrored at N; Blinn's model measures H, half-way between L and V, against N instead"
            }
            Self::Viewer => "V: the unit vector from the surface to the viewer",
            Self::Exponent => "n: the specular exponent; the greater, the smaller and sharper the highlight",
            Self::Os => "Os: the colour of the highlight, which multiplies Ks",
            Self::Reflectance => "W(θ): the part of the light that is reflected at the angle of incidence θ (Fresnel)",
            Self::Facets => "D: how many microfacets mirror the light to the viewer; m is their roughness",
            Self::Masking => "G: how many of these microfacets are lit and seen, and not hidden by others",
            Self::Kt => "Kt: the part of the light that comes through the surface",
            Self::Transmitted => "It: the light from behind, bent by Snell's law",
            Self::Shadows => "Whether what stands between keeps a light away",
            Self::Bounce => "What the ambient light stands for",
            Self::Depth => {
                "s0: what is left of the intensity at its depth; the rest is Idc, the colour that the object fades into"
            }
        }
    }

    /// What its numbers are measured in.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Intensity | Self::Ia | Self::Ip | Self::Transmitted | Self::Bounce | Self::Lights => {
                "linear intensity, 1 is white"
            }
            Self::Normal | Self::Light | Self::Reflected | Self::Viewer => "a unit vector, world",
            Self::Attenuation => "no unit; distances are world units",
            _ => "no unit",
        }
    }
}
