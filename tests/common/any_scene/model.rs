//! Models of any quality, as a file may hold them.

use super::Author;
use shading_lab::geometry::{Mesh, read_obj};
use std::fmt::Write;

impl Author {
    /// Reads a random model: valid, flat, folded, without area, duplicated, tiny, or huge. `fit` centres and scales it into
    /// the unit sphere.
    pub(super) fn model(&mut self, fit: bool) -> Result<Mesh, String> {
        let text = self.model_text();
        let mesh = read_obj(text.as_bytes(), &mut |_| {}).map_err(|error| error.to_string())?;
        Ok(if fit { mesh.fitted() } else { mesh })
    }

    fn model_text(&mut self) -> String {
        let mut text = String::new();
        if self.chance(0.3) {
            self.tetrahedron(&mut text);
        }
        let count = 3 + (self.dice.unit() * 6.0) as usize;
        let mut last = [0.0; 3];
        for _ in 0..count {
            let point = match self.dice.of(&[0, 0, 0, 0, 1, 2, 3]) {
                // A repeated point; one next to it; one in line with it.
                1 => last,
                2 => last.map(|x| x * (1.0 + 1e-7) + 1e-9),
                3 => [last[0], last[1], last[2] + 1.0],
                _ => [(); 3].map(|()| self.model_coordinate()),
            };
            let [x, y, z] = point;
            let _ = writeln!(text, "v {x:e} {y:e} {z:e}");
            last = point;
        }
        let normals = if self.chance(0.3) { 3 } else { 0 };
        for _ in 0..normals {
            let [x, y, z] = [(); 3].map(|()| self.number(-1.0..=1.0, -1e300..=1e300));
            let _ = writeln!(text, "vn {x:e} {y:e} {z:e}");
        }
        for _ in 0..1 + (self.dice.unit() * 5.0) as usize {
            let corners = self.dice.of(&[3, 3, 3, 4, 5]);
            text.push('f');
            for _ in 0..corners {
                let vertex = 1 + (self.dice.unit() * count as f64) as usize;
                let _ = match normals {
                    0 => write!(text, " -{vertex}"),
                    _ => write!(text, " -{vertex}//{}", self.dice.of(&[1, 2, 3])),
                };
            }
            text.push('\n');
        }
        text
    }

    /// Returns a coordinate that a file may hold: single precision reaches to 3·10³⁸.
    fn model_coordinate(&mut self) -> f64 {
        let greatest = f64::from(f32::MAX);
        self.length(-1.5..=1.5, -greatest..=greatest)
    }

    /// Appends a closed solid, which may lie far out.
    fn tetrahedron(&mut self, text: &mut String) {
        let [x, y, z] = [(); 3].map(|()| {
            if self.chance(0.8) {
                0.0
            } else {
                self.model_coordinate()
            }
        });
        let s = self.scale;
        for [u, v, w] in [[0.0, 0.0, 0.0], [s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, s]] {
            let _ = writeln!(text, "v {:e} {:e} {:e}", x + u, y + v, z + w);
        }
        text.push_str("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    }
}
