//! A finished picture, the report of how it was made, and how coarse it is drawn while something is dragged.

/// A picture as stored: 8 bits a channel, rows from the top.
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
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `[r, g, b, 255]`, row by row, `width * height` of them.
    pub pixels: Vec<[u8; 4]>,
}

impl Frame {
    /// The stored colour of a pixel inside the picture.
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
    /// Vertices to the picture; clipping.
    Transform,
    /// The equation at vertices or faces.
    VertexShading,
    /// Shadow rays, what is seen through the object and past it, and what other surfaces scatter.
    Rays,
    /// Which polygon each pixel sees.
    Coverage,
    /// Normals or intensities carried to the pixels, and what depth cueing leaves of them there.
    Interpolation,
    /// The equation at pixels.
    PixelShading,
    /// Intensities to stored values.
    Display,
}

impl Stage {
    /// In their order.
    const ALL: [Self; 8] = {
        use Stage::{
            Coverage, Display, Geometry, Interpolation, PixelShading, Rays, Transform,
            VertexShading,
        };
        [
            Geometry,
            Transform,
            VertexShading,
            Rays,
            Coverage,
            Interpolation,
            PixelShading,
            Display,
        ]
    };
}

/// One stage of one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct StageRun {
    /// Which stage it is.
    pub stage: Stage,
    /// False where the last output still held.
    pub ran: bool,
    /// Time by the renderer's clock, summed over threads and divided by their number; 0 without a clock.
    pub nanoseconds: u64,
    /// Evaluations of the illumination equation.
    pub evaluations: u64,
}

/// What the last call of `render` did.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Report {
    /// Every stage in its order, those that did not run too.
    pub stages: Vec<StageRun>,
    /// Time of the whole call by the renderer's clock; 0 without a clock.
    pub nanoseconds: u64,
    /// Triangles of the mesh, before culling.
    pub triangles: u64,
    /// Polygons of the mesh.
    pub faces: u64,
    /// Vertices of the mesh: points with one normal.
    pub vertices: u64,
    /// Evaluations at vertices or faces, once for each half of a picture that compares two kinds of ambient light; 0 where
    /// the equation is evaluated at pixels.
    pub points: u64,
    /// Triangles that show their front, or their back where backs are drawn, with a pixel centre in their bounds.
    pub candidates: u64,
    /// Triangles that clipping made of those that cross the near plane or reach far out of the picture.
    pub clipped: u64,
    /// Pixels that triangles cover, those counted that another triangle hides.
    pub drawn: u64,
    /// Pixels that show the object.
    pub covered: u64,
    /// Pixels with a channel above 1 before the display.
    pub overflowing: u64,
    /// What the intensities were divided by where the display scales the picture; otherwise 1.
    pub divisor: f64,
    /// The Ia that stands for one bounce of light between surfaces best, where that is gathered.
    pub ambient_fit: Option<[f64; 3]>,
}

impl Report {
    /// Starts the account of a frame: no stage has run.
    pub(super) fn begin(&mut self) {
        let run = |stage| StageRun {
            stage,
            ran: false,
            nanoseconds: 0,
            evaluations: 0,
        };
        self.stages = Stage::ALL.map(run).to_vec();
    }

    /// Notes that a stage has run, with the time it took and its evaluations of the equation.
    pub(super) fn ran(&mut self, stage: Stage, nanoseconds: u64, evaluations: u64) {
        for run in self.stages.iter_mut().filter(|run| run.stage == stage) {
            run.ran = true;
            run.nanoseconds += nanoseconds;
            run.evaluations += evaluations;
        }
    }
}

/// A frame is to take no longer, nanoseconds: thirty of them in a second, and room for the window round the picture.
const BUDGET: u64 = 26_000_000;
/// No coarser: what is dragged must still be recognised.
pub const COARSEST: u32 = 8;

/// Downscale factor that keeps a frame of this cost within the budget; 1 for none.
pub fn coarseness(nanoseconds: u64) -> u32 {
    (1..COARSEST)
        .find(|coarser| nanoseconds / u64::from(coarser * coarser) <= BUDGET)
        .unwrap_or(COARSEST)
}

/// A picture's size drawn coarser.
pub fn coarser_size(size: [u32; 2], coarser: u32) -> [u32; 2] {
    size.map(|side| side.div_ceil(coarser.max(1)).max(1))
}
