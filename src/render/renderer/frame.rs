//! A finished picture, the report of how it was made, and the coarser size drawn while something is dragged.

/// A picture as stored: 8 bits per channel, rows from the top.
///
/// ```
/// use shading_lab::render::Renderer;
/// use shading_lab::scene::Scene;
///
/// let mut scene = Scene::default();
/// scene.image.size = [48, 32];
/// let frame = Renderer::default().render(&scene).clone();
/// assert_eq!(frame.pixels.len(), 48 * 32);
/// assert_eq!(frame.pixel(0, 0), Some([0, 0, 0]), "the background");
/// assert_eq!(frame.pixel(48, 0), None, "outside");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Frame {
    /// The pixels in a row.
    pub width: u32,
    /// The number of rows.
    pub height: u32,
    /// The pixels as `[r, g, b, 255]`, row by row, `width * height` of them.
    pub pixels: Vec<[u8; 4]>,
}

impl Frame {
    /// Returns the stored colour of a pixel inside the picture.
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 3]> {
        let index = y as usize * self.width as usize + x as usize;
        let [r, g, b, _] = *self.pixels.get(index).filter(|_| x < self.width)?;
        Some([r, g, b])
    }
}

/// The stages of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Stage {
    /// Tessellation, or the model as loaded, with its vertex normals.
    Geometry,
    /// The projection of vertices to the picture; clipping.
    Transform,
    /// The equation at vertices or faces.
    VertexShading,
    /// Shadow rays, the view through the object and past it, and light scattered by other surfaces.
    Rays,
    /// The polygon that each pixel shows.
    Coverage,
    /// The interpolation of normals or intensities to the pixels, and depth cueing there.
    Interpolation,
    /// The equation at pixels.
    PixelShading,
    /// The conversion of intensities to stored values.
    Display,
}

impl Stage {
    /// The stages in their order.
    const ALL: [Self; 8] = [
        Self::Geometry,
        Self::Transform,
        Self::VertexShading,
        Self::Rays,
        Self::Coverage,
        Self::Interpolation,
        Self::PixelShading,
        Self::Display,
    ];
}

/// One stage of one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct StageRun {
    /// The stage.
    pub stage: Stage,
    /// True if it ran, false if the last output was still valid.
    pub ran: bool,
    /// The time by the renderer's clock, summed over threads and divided by their number; 0 without a clock.
    pub nanoseconds: u64,
    /// The evaluations of the illumination equation.
    pub evaluations: u64,
}

/// The report of the last call of `render`.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct FrameReport {
    /// Every stage in its order, those that did not run included.
    pub stages: Vec<StageRun>,
    /// The time of the whole call by the renderer's clock; 0 without a clock.
    pub nanoseconds: u64,
    /// The triangles of the mesh, before culling.
    pub triangles: u64,
    /// The polygons of the mesh.
    pub faces: u64,
    /// The vertices of the mesh: points with one normal.
    pub vertices: u64,
    /// The evaluations at vertices or faces, once for each half of a picture that compares two kinds of ambient light; 0
    /// where the equation is evaluated at pixels.
    pub points: u64,
    /// The triangles that show their front, or their back where backs are drawn, with a pixel centre in their bounds.
    pub candidates: u64,
    /// The triangles into which clipping cut those that cross the near plane or reach far out of the picture.
    pub clipped: u64,
    /// The pixels that triangles cover, including those hidden by another triangle.
    pub drawn: u64,
    /// The pixels that show the object.
    pub covered: u64,
    /// The pixels with a channel above 1 before the display, or where the scene's own law is undefined.
    pub overflowing: u64,
    /// The divisor of the intensities where the display scales the picture; otherwise 1.
    pub divisor: f64,
    /// The Ia that best approximates one bounce of light between surfaces, where that is gathered.
    pub ambient_fit: Option<[f64; 3]>,
}

impl FrameReport {
    pub(super) fn begin(&mut self) {
        let run = |stage| StageRun {
            stage,
            ran: false,
            nanoseconds: 0,
            evaluations: 0,
        };
        self.stages = Stage::ALL.map(run).to_vec();
    }

    /// Records that a stage has run, with the time it took and its evaluations of the equation.
    pub(super) fn ran(&mut self, stage: Stage, nanoseconds: u64, evaluations: u64) {
        for run in self.stages.iter_mut().filter(|run| run.stage == stage) {
            run.ran = true;
            run.nanoseconds += nanoseconds;
            run.evaluations += evaluations;
        }
    }
}

/// The time of a picture while something is dragged, nanoseconds: what the rest of the window leaves of a sixtieth of a second.
const BUDGET: u64 = 8_000_000;
/// The largest downscale factor: a dragged object must remain recognisable.
pub const COARSEST: u32 = 8;

/// The time to draw a picture, nanoseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DrawTime {
    /// At full resolution.
    pub whole: u64,
    /// The part of it that does not depend on the resolution.
    pub fixed: u64,
}

impl DrawTime {
    /// Learns from a picture drawn coarser by a factor, at least 2, in that many nanoseconds.
    #[must_use]
    pub fn after(self, coarser: u32, nanoseconds: u64) -> Self {
        let pixels = u64::from(coarser * coarser);
        let fixed = (pixels * nanoseconds).saturating_sub(self.whole) / (pixels - 1);
        let whole = self.whole.max(nanoseconds);
        Self {
            whole,
            fixed: fixed.min(whole),
        }
    }

    /// Returns the downscale factor that keeps a picture within the time that there is; 1 for none. Where no factor does, a
    /// picture is drawn no coarser than helps.
    pub fn coarseness(self) -> u32 {
        let enough = |coarser: &u32| {
            let scaled = (self.whole - self.fixed) / u64::from(coarser * coarser);
            self.fixed + scaled <= BUDGET || scaled <= self.fixed / 4
        };
        (1..COARSEST).find(enough).unwrap_or(COARSEST)
    }
}

impl std::ops::Add for DrawTime {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            whole: self.whole + other.whole,
            fixed: self.fixed + other.fixed,
        }
    }
}

/// Returns a picture's size when drawn coarser.
pub fn coarser_size(size: [u32; 2], coarser: u32) -> [u32; 2] {
    size.map(|side| side.div_ceil(coarser.max(1)).max(1))
}
