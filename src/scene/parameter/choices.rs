//! The values of every choice: what each is called and what it means.

use super::super::*;
use super::Options;

impl Options for Projection {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Perspective, "perspective", "As an eye or a camera sees"),
        (Self::Orthographic, "orthographic", "Parallel rays: no foreshortening"),
    ];
}

impl Options for Viewer {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Local, "at the eye", "V points to the eye from each point"),
        (Self::Infinite, "at infinity", "V is constant, from target to eye"),
    ];
}

impl Options for Overflow {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Clamp, "clamp", "Shown as 1"),
        (Self::Scale, "scale the picture", "The whole picture is divided by its greatest value"),
        (Self::Mark, "mark", "Hatched where a channel is above 1"),
    ];
}

impl Options for Encoding {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Raw, "value × 255", "As in the textbooks: value × 255, rounded"),
        (Self::Srgb, "sRGB", "The transfer function of IEC 61966-2-1: light on the screen is proportional to I"),
    ];
}

impl Options for ObjectKind {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Sphere, "sphere", ""),
        (Self::Torus, "torus", ""),
        (Self::Cylinder, "cylinder", ""),
        (Self::Cone, "cone", ""),
        (Self::Cube, "cube", ""),
        (Self::Plane, "plane", ""),
        (Self::Teapot, "teapot", "Martin Newell's, made of 32 patches"),
        (Self::Corrugated, "corrugated sheet", "Folded to and fro: undivided slopes average to one normal"),
        (Self::Polygons, "polygons", "The scene's own; their vertices can be dragged in the picture"),
        (Self::Obj, "model from a file", "A Wavefront OBJ file"),
    ];
}

impl Options for NormalSource {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Averaged, "averaged", "The mean of the polygons that meet at the vertex"),
        (Self::Exact, "true surface's", "Those of the surface that the polygons approximate"),
        (Self::File, "from the file", "As the model or the scene file gives them; averaged where it gives none"),
        (Self::Facet, "each polygon's own", "No smoothing"),
    ];
}

impl Options for Weighting {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Equal, "equal", "The same for each polygon (Gouraud 1971)"),
        (Self::Area, "by area", "The larger the polygon, the more"),
        (Self::Angle, "by angle", "By the polygon's angle at the vertex (Thürmer and Wüthrich 1998)"),
    ];
}

impl Options for Reflectance {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Constant, "constant", "1 at every angle, as in Phong's model"),
        (Self::Glass, "glass", "Crown glass N-BK7, by Fresnel's formulas"),
        (Self::Silver, "silver", "By the index of Johnson and Christy 1972"),
        (Self::Gold, "gold", "By the index of Johnson and Christy 1972"),
        (Self::Custom, "custom η and k", "A complex index of refraction of your own"),
    ];
}

impl Options for ReflectionModel {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Phong, "Phong  (R·V)^n", "R is L reflected about N"),
        (Self::Blinn, "Blinn  (N·H)^n", "H is half-way between L and V"),
        (
            Self::CookTorrance,
            "Cook–Torrance  D·G",
            "Microfacets: D is the fraction that mirrors the light, G the fraction of those that is lit and seen",
        ),
    ];
}

impl Options for Distribution {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Beckmann, "Beckmann", "Normally distributed slopes, with V-shaped cavities"),
        (Self::Ggx, "GGX", "A longer tail about the highlight (Walter et al. 2007), with Smith's G"),
    ];
}

impl Options for Backfacing {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Clamp, "clamp to 0", "The light contributes nothing"),
        (Self::Flip, "flip N", "The normal is turned towards the light: a two-sided surface"),
    ];
}

impl Options for AmbientSource {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Constant, "constant", "Ia everywhere"),
        (Self::Bounce, "one bounce", "Light that other surfaces of the scene have scattered once"),
        (Self::Split, "compare halves", "The constant in the left half of the picture, one bounce in the right half"),
    ];
}

impl Options for PatternKind {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::None, "none", ""),
        (Self::Checker, "checker", "Cubes, every other one coloured"),
        (Self::Stripes, "stripes", "Level layers"),
        (Self::Rings, "rings", "Shells about the axis"),
    ];
}

impl Options for Through {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Surface, "one surface", "Refracted once: what lies behind is inside the material as well"),
        (Self::Solid, "solid", "Refracted on its way in and out, and reflected inside where it cannot leave"),
    ];
}

impl Options for ShadingMode {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Flat, "Flat", "The equation once per polygon"),
        (
            Self::Interpolated,
            "Interpolated",
            "The equation at each polygon's vertices with the polygon's own normal; the intensity is interpolated",
        ),
        (
            Self::Gouraud,
            "Gouraud",
            "The equation at the vertices with the vertex normals; the intensity is interpolated (Gouraud 1971)",
        ),
        (Self::Phong, "Phong", "The equation at every pixel with the interpolated normal (Phong 1975)"),
        (Self::Exact, "Exact", "The equation at every pixel of the true surface, with its own normal and outline"),
    ];
}

impl Options for FlatAt {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Centre, "the centre", "The mean of the vertices, with the polygon's own normal"),
        (
            Self::VertexMean,
            "vertices, averaged",
            "The mean of the intensities at the vertices, with the vertex normals",
        ),
        (Self::ProvokingVertex, "the first vertex", "The intensity at the first vertex, as OpenGL may do"),
    ];
}

impl Options for Interpolation {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Perspective, "perspective-correct", "Linear on the polygon in space"),
        (Self::Affine, "affine", "Linear on the triangle in the picture"),
        (Self::Scanline, "scan line", "Linear along the edges, then along the scan line, in the picture"),
    ];
}

impl Options for CuedBy {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Off, "off", ""),
        (Self::Vertex, "at vertices", "Intensities fade at the vertices; in Phong shading s0 is interpolated"),
        (Self::Pixel, "at pixels", "By each pixel's own depth"),
    ];
}

impl Options for LightKind {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Point, "point", "Shines from a point in all directions"),
        (Self::Directional, "directional", "Parallel rays, like sunlight"),
        (Self::Spot, "spot", "Shines from a point into a cone"),
        (Self::Area, "area", "A rectangle or a sphere, represented by points spread evenly over it"),
    ];
}

impl Options for AreaShape {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Rectangle, "rectangle", "A window or a panel; its points shine in all directions"),
        (Self::Sphere, "sphere", "A globe"),
    ];
}

impl Options for Attenuation {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::None, "none", "f = 1"),
        (Self::Viewer, "1/(r+k), r to the viewer", "As in older textbooks"),
        (Self::Light, "1/(r+k), r to the light", ""),
        (Self::InverseSquare, "1/d²", "As light weakens in empty space"),
        (Self::Quadratic, "1/(c1+c2·d+c3·d²)", "At most 1"),
    ];
}

impl Options for CompareView {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Single, "single", "The scene alone"),
        (Self::Panes, "panes", "The scene and its panes side by side"),
        (Self::Wipe, "wipe", "The scene and the last pane on either side of a line"),
        (Self::Difference, "difference", "The scene minus the last pane"),
    ];
}

impl Options for DifferenceKind {
    const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Signed, "signed", "gain·d of the luminance, from blue (darker) through white to orange (brighter)"),
        (Self::Absolute, "absolute", "gain·|d| of each channel"),
        (Self::FalseColor, "false colour", "gain·|d| of the channel that differs most, from dark blue to yellow"),
    ];
}
