//! Bishop and Weimer, "Fast Phong Shading", SIGGRAPH 1986.
//!
//! N·L and the highlight's cosine are functions of the picture's x and y over a triangle; their Taylor expansions of the second
//! order about its centre are evaluated by forward differences, two additions per pixel each. The error is of the third order
//! in the triangle's size, and where two triangles meet their expansions do not.

use super::kernel::{Kernel, ScreenVertex, Shade, Span, carried, linear};
use crate::analysis::study::jet::Jet;
use crate::illumination::V3;
use crate::scene::{Backfacing, ReflectionModel, Rgb};
use glam::{DVec2, DVec3};

/// Taylor's expansion of the cosines over a triangle, by forward differences.
pub struct Taylor<'a> {
    shade: &'a Shade,
    perspective: bool,
    model: ReflectionModel,
    flips: bool,
    n: f64,
    /// The triangle's centre in the picture, about which the expansions are.
    centre: DVec2,
    /// N·L, the highlight's cosine, and f with a spot light's factor, for each source.
    expansions: Vec<[Jet; 3]>,
    /// Values and first differences at this pixel, and second differences.
    state: Vec<[[f64; 3]; 3]>,
}

impl<'a> Taylor<'a> {
    pub fn new(shade: &'a Shade) -> Self {
        Self {
            shade,
            perspective: shade.carried_in_perspective,
            model: shade.reflection.model,
            flips: shade.reflection.backfacing == Backfacing::Flip,
            n: shade.n,
            centre: DVec2::ZERO,
            expansions: Vec::new(),
            state: Vec::new(),
        }
    }
}

impl<'a> Kernel<'a> for Taylor<'a> {
    const PER_PIXEL: bool = false;

    fn shade(&self) -> &'a Shade {
        self.shade
    }

    fn begin_triangle(&mut self, triangle: &[ScreenVertex; 3]) {
        self.centre = triangle.iter().map(|corner| corner.at).sum::<DVec2>() / 3.0;
        let (normals, keys) = (
            carried(triangle, self.perspective),
            linear(triangle, |corner| corner.key),
        );
        let middle = normals.at(self.centre);
        let [x, y, z] =
            [0, 1, 2].map(|axis| Jet::linear(middle[axis], normals.x[axis], normals.y[axis]));
        let n = V3::new(x, y, z).normalised();
        let offset = self.centre - self.shade.view.centre;
        let place = [
            Jet::linear(offset.x, 1.0, 0.0),
            Jet::linear(offset.y, 0.0, 1.0),
        ];
        let position = self
            .shade
            .position(place, Jet::linear(keys.at(self.centre), keys.x, keys.y));
        let equation = &self.shade.equation;
        let site = equation.site(position, n);
        self.expansions.clear();
        for source in &equation.sources {
            let (l, f, _) = source.reach(site.position, site.inverse_distance);
            let n_dot_l = n.dot(l);
            let cosine = match self.model {
                ReflectionModel::Blinn => n.dot((l + site.view).normalised()),
                _ => n_dot_l * n.dot(site.view) * 2.0 - l.dot(site.view),
            };
            self.expansions.push([n_dot_l, cosine, f * source.spot(l)]);
        }
    }

    fn begin_span(&mut self, span: &Span) {
        let from = span.first - self.centre;
        self.state.clear();
        self.state.extend(
            self.expansions
                .iter()
                .map(|jets| jets.map(|jet| jet.differences(from))),
        );
    }

    fn pixel(&self, _: DVec2, _: f64) -> Rgb {
        let mut sum = Rgb::from_array(self.shade.equation.ambient);
        for (source, [[n_dot_l, ..], [cosine, ..], [strength, ..]]) in
            self.shade.equation.sources.iter().zip(&self.state)
        {
            let (n_dot_l, cosine) = if self.flips && *n_dot_l < 0.0 {
                (
                    -n_dot_l,
                    if self.model == ReflectionModel::Blinn {
                        -cosine
                    } else {
                        *cosine
                    },
                )
            } else {
                (*n_dot_l, *cosine)
            };
            if n_dot_l > 0.0 {
                // Beyond 1 a cosine is the expansion's error.
                let specular =
                    DVec3::from_array(source.specular) * cosine.clamp(0.0, 1.0).powf(self.n);
                sum += (DVec3::from_array(source.diffuse) * n_dot_l + specular) * *strength;
            }
        }
        sum
    }

    fn step(&mut self) {
        for [value, first, second] in self.state.iter_mut().flatten() {
            *value += *first;
            *first += *second;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::study::historic::kernel::Crossing;
    use crate::scene::{Light, LightKind, Projection, Scene, View};

    /// Compares the kernel's expansion with the closed form. Seen directly without perspective, N = (x, 0, 1)/√(1 +
    /// x²) and a light along the view give N·L = 1/√(1 + x²), whose expansion about c is known; the remainder is
    /// f‴·dx³/6.
    #[test]
    fn taylors_expansion_is_the_closed_form() {
        let mut scene = Scene::default();
        scene.camera.projection = Projection::Orthographic;
        (scene.material.ka, scene.material.ks) = (Rgb::ZERO, Rgb::ZERO);
        (scene.material.kd, scene.material.color) = (Rgb::ONE, Rgb::ONE);
        let view = View::new(&scene.camera, scene.image.size);
        scene.lights = vec![Light {
            kind: LightKind::Directional,
            direction: view.forward,
            ..Light::default()
        }];
        let shade = Shade::new(&scene);
        let mut kernel = Taylor::new(&shade);
        let slope = 0.01;
        let tilt = |x: f64| view.right * (slope * x) - view.forward;
        let corner = |x: f64, y: f64| ScreenVertex {
            at: DVec2::new(x, y),
            key: -4.0,
            normal: tilt(x),
        };
        kernel.begin_triangle(&[corner(0.0, 0.0), corner(30.0, 0.0), corner(0.0, 30.0)]);
        let edge = |x: f64| Crossing {
            x,
            from: 0,
            to: 1,
            alpha: 0.0,
        };
        kernel.begin_span(&Span {
            first: DVec2::new(0.5, 4.0),
            ends: [edge(0.0), edge(26.0)],
        });
        // f = (1+u²)^−½ with u = slope·x, about x = 10.
        let u = slope * 10.0;
        let w = 1.0 + u * u;
        let (f0, f1, f2) = (
            w.powf(-0.5),
            -u * w.powf(-1.5),
            (2.0 * u * u - 1.0) * w.powf(-2.5),
        );
        for pixel in 0..26 {
            let dx = f64::from(pixel) + 0.5 - 10.0;
            let du = slope * dx;
            let expected = f0 + f1 * du + 0.5 * f2 * du * du;
            let got = kernel.pixel(DVec2::ZERO, 0.0).x;
            assert!((got - expected).abs() < 1e-12, "{got} is not {expected}");
            let x = u + du;
            let exact = (1.0 + x * x).powf(-0.5);
            // |f‴| = |u(9 − 6u²)|·w^(−7/2), at most 9·(u + |du|) here.
            let bound = 9.0 * (u + du.abs()) * du.abs().powi(3) / 6.0 + 1e-12;
            assert!(
                (got - exact).abs() <= bound,
                "{got} is not within {bound} of {exact}"
            );
            kernel.step();
        }
    }
}
