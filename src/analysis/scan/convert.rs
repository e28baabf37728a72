//! The conversion itself: the polygon with the values at its corners, the edge table, active edges, crossings, spans
//! and their pixels.

use super::{
    Carried, Crossing, Rule, Scan, ScanCorner, ScanEdge, ScanError, ScanLine, ScanPixel, ScanSpan,
    ScanStep,
};
use crate::illumination::Equation;
use crate::render::{Cued, Renderer, WeightedPoint, stored_pixel};
use crate::scene::{Encoding, Interpolation, Projection, Rgb, Scene, ShadingMode, View};
use glam::{DVec2, DVec3};
use serde::Serialize;
use std::cmp::Ordering;

/// Rows and columns left free on each side of the polygon.
const MARGIN: f64 = 1.0;
/// Bounds of the ratio of width to height; other polygons are stretched along with their pixels, which changes no
/// value.
const SHAPES: [f64; 2] = [0.5, 1.6];
/// Ratio of a polygon's area to the square of its extent below which it is a line up to rounding.
const EDGE_ON: f64 = 1e-10;

/// Scans face `face` of `scene`, drawing the scene first if it is not the picture last drawn, in a grid of `rows`
/// rows.
///
/// Light that rays bring to pixels is omitted: the intensity is the equation's own, at corners with their shadows.
pub fn scan(
    renderer: &mut Renderer,
    scene: &Scene,
    face: u32,
    rows: u32,
) -> Result<Scan, ScanError> {
    renderer.render(scene);
    scan_drawn(renderer, scene, face, rows)
}

/// Scans like [`scan`] in the picture last drawn, which is `scene`'s.
pub(crate) fn scan_drawn(
    renderer: &Renderer,
    scene: &Scene,
    face: u32,
    rows: u32,
) -> Result<Scan, ScanError> {
    if !Scan::ROWS.contains(&rows) {
        return Err(ScanError::Rows { rows });
    }
    let (polygon, shading) = seen(renderer, scene, face)?;
    let grid = Grid::around(&polygon.corners, rows).ok_or(ScanError::EdgeOn { face })?;
    let scan = convert(polygon, &shading, grid);
    let is_pixel = |step: &ScanStep| matches!(step, ScanStep::Pixel { .. });
    if scan.steps.iter().any(is_pixel) {
        Ok(scan)
    } else {
        Err(ScanError::EdgeOn { face })
    }
}

/// Scans like [`scan`] in any grid, which need not be about the face.
pub fn scan_in_grid(
    renderer: &Renderer,
    scene: &Scene,
    face: u32,
    grid: Grid,
) -> Result<Scan, ScanError> {
    let (polygon, shading) = seen(renderer, scene, face)?;
    Ok(convert(polygon, &shading, grid))
}

/// A grid of enlarged pixels: (0, 0) is the top left one, the centre of (x, y) is (x + 0.5, y + 0.5).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Grid {
    /// Number of pixels in a row.
    pub columns: u32,
    /// Number of rows.
    pub rows: u32,
    /// Pixels of the grid per pixel of the picture, across and down; equal unless the polygon is very long.
    pub scale: DVec2,
    /// Position of the grid's corner in the picture, pixels.
    pub origin: DVec2,
}

impl Grid {
    /// Returns a grid of `rows` rows that the polygon fills; none for one that is seen edge-on.
    fn around(corners: &[ScanCorner], rows: u32) -> Option<Self> {
        let places = || corners.iter().map(|corner| corner.place);
        let (min, max) = places().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(a, b), p| {
            (a.min(p), b.max(p))
        });
        let extent = max - min;
        let first = corners.first()?.place;
        let pairs = places().zip(places().skip(1));
        let doubled: f64 = pairs.map(|(a, b)| (a - first).perp_dot(b - first)).sum();
        let area = doubled * 0.5;
        if area.abs() <= EDGE_ON * extent.length_squared() || !extent.is_finite() {
            return None;
        }
        let height = f64::from(rows) - 2.0 * MARGIN;
        let width = height * (extent.x / extent.y).clamp(SHAPES[0], SHAPES[1]);
        let scale = DVec2::new(width, height) / extent;
        let size = DVec2::new((width + 2.0 * MARGIN).ceil(), f64::from(rows));
        let origin = (min + max) * 0.5 - size * 0.5 / scale;
        scale.is_finite().then_some(Self {
            columns: size.x as u32,
            rows,
            scale,
            origin,
        })
    }

    /// Returns the number of columns and rows.
    pub fn size(&self) -> DVec2 {
        DVec2::new(f64::from(self.columns), f64::from(self.rows))
    }

    /// Converts a place of the grid to one of the picture, pixels.
    pub fn to_picture(&self, place: DVec2) -> DVec2 {
        place / self.scale + self.origin
    }

    /// Converts a place of the picture to one of the grid.
    pub fn from_picture(&self, pixel: DVec2) -> DVec2 {
        (pixel - self.origin) * self.scale
    }
}

/// Data for the intensities of the polygon's pixels.
struct Shading {
    /// The corners, world.
    points: Vec<DVec3>,
    /// The colours at the corners that tint Od.
    tints: Vec<Rgb>,
    /// The triangles as which the polygon is drawn, by the numbers of its corners.
    triangles: Vec<[usize; 3]>,
    orthographic: bool,
    equation: Equation<f64>,
    encoding: Encoding,
    /// Divisor of the display for intensities.
    divisor: f64,
}

/// Returns face `face` of `scene`, which was drawn last, before conversion: its corners are in the picture.
fn seen(renderer: &Renderer, scene: &Scene, face: u32) -> Result<(Scan, Shading), ScanError> {
    let polygon = renderer
        .polygon(face)
        .ok_or(match renderer.polygon_count() {
            0 => ScanError::Empty,
            count => ScanError::NoFace { face, count },
        })?;
    if !polygon.before_the_eye {
        return Err(ScanError::BehindTheEye { face });
    }
    let own = renderer.material_of(face);
    let equation = renderer.shining_equations(scene).swap_remove(own);
    let mode = if scene.shading.mode == ShadingMode::Exact {
        ShadingMode::Phong
    } else {
        scene.shading.mode
    };
    let carried = match mode {
        ShadingMode::Flat => Carried::Constant,
        ShadingMode::Interpolated | ShadingMode::Gouraud => Carried::Intensity,
        ShadingMode::Phong | ShadingMode::Exact => Carried::Normal,
    };
    // Intensities at points fade where they are computed.
    let cued = renderer
        .plan()
        .is_some_and(|plan| plan.cued == Cued::AtPoints);
    let evaluated = |at: &WeightedPoint<'_>| {
        let intensity = at.value(&equation);
        if cued {
            intensity * at.scale + scene.depth_cueing.color * (1.0 - at.scale)
        } else {
            intensity
        }
    };
    let constant: Rgb = polygon
        .flat
        .iter()
        .map(|at| evaluated(at) * at.weight)
        .sum();
    let view = View::new(&scene.camera, scene.image.size);
    let corners = polygon.corners.iter().map(|at| {
        let (place, depth) = view.project(at.point)?;
        let value = match carried {
            Carried::Constant => constant,
            Carried::Intensity => evaluated(at),
            Carried::Normal => at.normal,
        };
        Some(ScanCorner {
            place,
            depth,
            value,
        })
    });
    let corners = corners
        .collect::<Option<_>>()
        .ok_or(ScanError::BehindTheEye { face })?;
    let compared = match scene.shading.interpolation {
        Interpolation::Perspective => Rule::Perspective,
        Interpolation::Affine | Interpolation::Scanline => Rule::Affine,
    };
    let scan = Scan {
        face,
        mode,
        carried,
        renormalise: scene.shading.renormalise,
        compared,
        grid: Grid {
            columns: 0,
            rows: 0,
            scale: DVec2::ONE,
            origin: DVec2::ZERO,
        },
        corners,
        edges: Vec::new(),
        lines: Vec::new(),
        steps: Vec::new(),
    };
    let shading = Shading {
        points: polygon.corners.iter().map(|at| at.point).collect(),
        tints: polygon.corners.iter().map(|at| at.tint).collect(),
        triangles: polygon.triangles,
        orthographic: scene.camera.projection == Projection::Orthographic,
        equation,
        encoding: scene.display.encoding,
        divisor: renderer.report().divisor,
    };
    Ok((scan, shading))
}

impl Shading {
    /// Returns the intensity of an interpolated value at a position with its tint.
    fn intensity(&self, scan: &Scan, value: DVec3, (position, tint): (DVec3, Rgb)) -> Rgb {
        if scan.carried != Carried::Normal {
            return value;
        }
        let normal = if scan.renormalise {
            value.normalize_or_zero()
        } else {
            value
        };
        self.equation
            .illuminate_tinted((position, normal), tint, None, None)
    }

    fn stored(&self, intensity: Rgb) -> [u8; 3] {
        let [r, g, b, _] = stored_pixel(intensity / self.divisor, self.encoding);
        [r, g, b]
    }

    /// Returns the point seen at a place of the grid, world, and the value and the tint there by barycentric weights: on the
    /// polygon's triangle that contains the place or, on the border, is least away from it; none for a polygon without
    /// area. Weights in space are those in the picture over the depths, normalised to add up to 1 again (Blinn 1992).
    fn barycentric(&self, scan: &Scan, place: DVec2) -> Option<[DVec3; 3]> {
        let corners = &scan.corners;
        let weighted = self.triangles.iter().filter_map(|&triangle| {
            let [a, b, c] = triangle.map(|i| corners[i].place);
            let area = (b - a).perp_dot(c - a);
            let w1 = (place - a).perp_dot(c - a) / area;
            let w2 = (b - a).perp_dot(place - a) / area;
            (w1.is_finite() && w2.is_finite()).then_some((triangle, [1.0 - w1 - w2, w1, w2]))
        });
        let min_of = |weights: &[f64; 3]| weights.iter().copied().fold(f64::INFINITY, f64::min);
        let (triangle, affine) = weighted.max_by(|a, b| min_of(&a.1).total_cmp(&min_of(&b.1)))?;
        let mut perspective = affine;
        if !self.orthographic {
            let [a, b, c] = [0, 1, 2].map(|i: usize| affine[i] / corners[triangle[i]].depth);
            perspective = [a, b, c].map(|weight| weight / (a + b + c));
        }
        let compared = if scan.compared == Rule::Affine {
            affine
        } else {
            perspective
        };
        let sum = |weights: [f64; 3], of: &dyn Fn(usize) -> DVec3| -> DVec3 {
            triangle
                .iter()
                .zip(weights)
                .map(|(&corner, weight)| of(corner) * weight)
                .sum()
        };
        Some([
            sum(perspective, &|i| self.points[i]),
            sum(compared, &|i| corners[i].value),
            sum(compared, &|i| self.tints[i]),
        ])
    }
}

/// Converts a polygon to the pixels of a grid.
fn convert(mut scan: Scan, shading: &Shading, grid: Grid) -> Scan {
    scan.grid = grid;
    for corner in &mut scan.corners {
        corner.place = grid.from_picture(corner.place);
    }
    scan.edges = edge_table(&scan.corners);
    let tops = scan.edges.iter().map(|edge| edge.y_top);
    let bottoms = scan.edges.iter().map(|edge| edge.y_bottom);
    let top = tops.fold(f64::INFINITY, f64::min);
    let bottom = bottoms.fold(f64::NEG_INFINITY, f64::max);
    let rows = first_centre(top, grid.rows)..first_centre(bottom, grid.rows);
    scan.lines = rows.map(|y| scan_line(&scan, shading, y)).collect();
    for (line, scan_line) in scan.lines.iter().enumerate() {
        scan.steps.push(ScanStep::Line { line });
        for (span, scan_span) in scan_line.spans.iter().enumerate() {
            scan.steps
                .extend([ScanStep::P { line, span }, ScanStep::Q { line, span }]);
            let pixel = |pixel| ScanStep::Pixel { line, span, pixel };
            scan.steps.extend((0..scan_span.pixels.len()).map(pixel));
        }
    }
    scan
}

/// Returns the first of `count` pixels whose centre is not before `place`.
fn first_centre(place: f64, count: u32) -> u32 {
    // The number cast is between 0 and `count`; NaN becomes 0.
    (place - 0.5).ceil().clamp(0.0, f64::from(count)) as u32
}

/// Returns the edges by their upper ends, then from left to right, without the horizontal ones.
fn edge_table(corners: &[ScanCorner]) -> Vec<ScanEdge> {
    let count = corners.len();
    let mut edges: Vec<ScanEdge> = (0..count)
        .filter_map(|i| {
            let (mut upper, mut lower) = (i, (i + 1) % count);
            if corners[lower].place.y < corners[upper].place.y {
                (upper, lower) = (lower, upper);
            }
            let (a, b) = (corners[upper].place, corners[lower].place);
            let dx_dy = (b.x - a.x) / (b.y - a.y);
            (b.y > a.y).then_some(ScanEdge {
                corners: [upper, lower],
                y_top: a.y,
                y_bottom: b.y,
                x_top: a.x,
                dx_dy,
            })
        })
        .collect();
    let order = |edge: &ScanEdge| [edge.y_top, edge.x_top, edge.dx_dy];
    edges.sort_by(|a, b| order(a).partial_cmp(&order(b)).unwrap_or(Ordering::Equal));
    edges
}

/// Returns the scan line of row `y` with its crossings and pixels.
fn scan_line(scan: &Scan, shading: &Shading, y: u32) -> ScanLine {
    let at = f64::from(y) + 0.5;
    let edges = scan
        .edges
        .iter()
        .enumerate()
        .filter(|(_, edge)| edge.y_top <= at && at < edge.y_bottom);
    let mut crossings: Vec<Crossing> = edges
        .map(|(index, edge)| {
            let alpha = (at - edge.y_top) / (edge.y_bottom - edge.y_top);
            let [a, b] = edge.corners.map(|corner| &scan.corners[corner]);
            let x = (1.0 - alpha) * a.place.x + alpha * b.place.x;
            let value = mix(alpha, a.value, b.value, scan.carried);
            let stored = (scan.carried != Carried::Normal).then(|| shading.stored(value));
            Crossing {
                edge: index,
                x,
                alpha,
                value,
                stored,
            }
        })
        .collect();
    crossings.sort_by(|a, b| a.x.total_cmp(&b.x));
    let spans = crossings.as_chunks::<2>().0.iter().map(|&[p, q]| {
        let columns = first_centre(p.x, scan.grid.columns)..first_centre(q.x, scan.grid.columns);
        let pixel = |x: u32| {
            let centre = DVec2::new(f64::from(x) + 0.5, at);
            let alpha = (centre.x - p.x) / (q.x - p.x);
            let value = mix(alpha, p.value, q.value, scan.carried);
            let [position, beside, tint] = shading.barycentric(scan, centre).unwrap_or([
                shading.points[0],
                value,
                shading.tints[0],
            ]);
            let intensity = shading.intensity(scan, value, (position, tint));
            let barycentric = shading.intensity(scan, beside, (position, tint));
            ScanPixel {
                x,
                alpha,
                value,
                intensity,
                stored: shading.stored(intensity),
                barycentric,
            }
        };
        ScanSpan {
            p,
            q,
            pixels: columns.map(pixel).collect(),
        }
    });
    ScanLine {
        y,
        active: crossings.iter().map(|crossing| crossing.edge).collect(),
        spans: spans.collect(),
    }
}

/// Computes `(1 − α)·a + α·b`; a value that is constant is returned unchanged.
fn mix(alpha: f64, a: DVec3, b: DVec3, carried: Carried) -> DVec3 {
    if carried == Carried::Constant {
        a
    } else {
        a * (1.0 - alpha) + b * alpha
    }
}
