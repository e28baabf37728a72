//! The conversion itself: edge table, active edges, crossings, spans and their pixels.

use super::barycentric::weights;
use super::corners::Shaded;
use super::{Carried, Crossing, Grid, Rule, Scan, ScanEdge, ScanLine, ScanPixel, ScanSpan, ScanStep};
use glam::{DVec2, DVec3};

/// Scans the polygon in `grid`.
pub fn convert(shaded: &Shaded, grid: Grid) -> Scan {
    let mut scan = shaded.empty_scan(grid);
    scan.edges = edge_table(&scan);
    let top = scan.edges.iter().map(|edge| edge.y_top).fold(f64::INFINITY, f64::min);
    let bottom = scan.edges.iter().map(|edge| edge.y_bottom).fold(f64::NEG_INFINITY, f64::max);
    for y in first_centre(top, grid.rows)..first_centre(bottom, grid.rows) {
        let line = scan_line(&scan, shaded, y);
        scan.lines.push(line);
    }
    scan.steps = steps(&scan.lines);
    scan
}

/// The first of `count` pixels whose centre is not before `place`.
fn first_centre(place: f64, count: u32) -> u32 {
    // The cast is of a number within 0 and `count`; what is none becomes 0.
    (place - 0.5).ceil().clamp(0.0, f64::from(count)) as u32
}

/// Edges by their upper ends, those of one height from left to right. Level ones are not among them: no scan line crosses
/// them.
fn edge_table(scan: &Scan) -> Vec<ScanEdge> {
    let count = scan.corners.len();
    let mut edges: Vec<ScanEdge> = (0..count)
        .filter_map(|i| {
            let (mut upper, mut lower) = (i, (i + 1) % count);
            if scan.corners[lower].place.y < scan.corners[upper].place.y {
                (upper, lower) = (lower, upper);
            }
            let (a, b) = (scan.corners[upper].place, scan.corners[lower].place);
            let dx_dy = (b.x - a.x) / (b.y - a.y);
            (b.y > a.y).then_some(ScanEdge { corners: [upper, lower], y_top: a.y, y_bottom: b.y, x_top: a.x, dx_dy })
        })
        .collect();
    let order = |edge: &ScanEdge| [edge.y_top, edge.x_top, edge.dx_dy];
    edges.sort_by(|a, b| order(a).partial_cmp(&order(b)).unwrap_or(std::cmp::Ordering::Equal));
    edges
}

fn scan_line(scan: &Scan, shaded: &Shaded, y: u32) -> ScanLine {
    let at = f64::from(y) + 0.5;
    let crosses = |edge: &ScanEdge| edge.y_top <= at && at < edge.y_bottom;
    let edges = scan.edges.iter().enumerate().filter(|(_, edge)| crosses(edge));
    let mut crossings: Vec<Crossing> = edges.map(|(index, edge)| cross(scan, shaded, index, edge, at)).collect();
    crossings.sort_by(|a, b| a.x.total_cmp(&b.x));
    let spans = crossings.as_chunks::<2>().0.iter().map(|[p, q]| ScanSpan {
        p: *p,
        q: *q,
        pixels: (first_centre(p.x, scan.grid.columns)..first_centre(q.x, scan.grid.columns))
            .map(|x| pixel(scan, shaded, [p, q], DVec2::new(f64::from(x) + 0.5, at), x))
            .collect(),
    });
    ScanLine { y, active: crossings.iter().map(|crossing| crossing.edge).collect(), spans: spans.collect() }
}

fn cross(scan: &Scan, shaded: &Shaded, index: usize, edge: &ScanEdge, at: f64) -> Crossing {
    let alpha = (at - edge.y_top) / (edge.y_bottom - edge.y_top);
    let [a, b] = edge.corners.map(|corner| &scan.corners[corner]);
    let x = (1.0 - alpha) * a.place.x + alpha * b.place.x;
    let value = mix(alpha, a.value, b.value, scan.carried);
    let stored = (scan.carried != Carried::Normal).then(|| shaded.stored(value));
    Crossing { edge: index, x, alpha, value, stored }
}

fn pixel(scan: &Scan, shaded: &Shaded, [p, q]: [&Crossing; 2], centre: DVec2, x: u32) -> ScanPixel {
    let alpha = (centre.x - p.x) / (q.x - p.x);
    let value = mix(alpha, p.value, q.value, scan.carried);
    let (mut position, mut beside) = (shaded.corners[0].point, value);
    if let Some(weights) = weights(&scan.corners, centre, shaded.orthographic) {
        let by = |rule| match rule {
            Rule::Affine => weights.affine,
            Rule::Perspective => weights.perspective,
        };
        let sum = |rule, of: &dyn Fn(usize) -> DVec3| -> DVec3 {
            weights.corners.iter().zip(by(rule)).map(|(&corner, weight)| of(corner) * weight).sum()
        };
        position = sum(Rule::Perspective, &|corner| shaded.corners[corner].point);
        beside = sum(scan.compared, &|corner| scan.corners[corner].value);
    }
    let intensity = shaded.intensity(value, position);
    let barycentric = shaded.intensity(beside, position);
    ScanPixel { x, alpha, value, intensity, stored: shaded.stored(intensity), barycentric }
}

/// `(1 − α)·a + α·b`; of what is the same everywhere just that.
fn mix(alpha: f64, a: DVec3, b: DVec3, carried: Carried) -> DVec3 {
    if carried == Carried::Constant { a } else { a * (1.0 - alpha) + b * alpha }
}

fn steps(lines: &[ScanLine]) -> Vec<ScanStep> {
    let mut steps = Vec::new();
    for (line, scan_line) in lines.iter().enumerate() {
        steps.push(ScanStep::Line { line });
        for (span, scan_span) in scan_line.spans.iter().enumerate() {
            steps.extend([ScanStep::P { line, span }, ScanStep::Q { line, span }]);
            steps.extend((0..scan_span.pixels.len()).map(|pixel| ScanStep::Pixel { line, span, pixel }));
        }
    }
    steps
}
