//! T: where light goes that passes through a surface.

use glam::DVec3;

/// The direction T of a ray that travels along `incident` and passes a surface with normal `n`, by Snell's law
/// `sin θ₁ = η·sin θ₂`; none where it is totally reflected.
///
/// `incident` and `n` are unit vectors, `incident·n` ≤ 0: the ray comes from the side that `n` points to. `eta` is the index
/// of refraction beyond the surface relative to that before it. T is a unit vector (A. S. Glassner, *An Introduction to
/// Ray Tracing*, 1989, 4.3):
/// `T = I/η + (c/η − √(1 − (1 − c²)/η²))·n`, c = −I·n. At η = 1 the ray goes straight on. There is no T where
/// `sin θ₁ > η`, beyond the critical angle arcsin η, for η < 1.
pub fn refract(incident: DVec3, n: DVec3, eta: f64) -> Option<DVec3> {
    let cosine = -incident.dot(n);
    // From the cross product: 1 − cos² would lose what is left of it near the normal.
    let sine_squared = incident.cross(n).length_squared() / (eta * eta);
    let rest = 1.0 - sine_squared;
    (rest >= 0.0).then(|| ((incident + n * cosine) / eta - n * rest.sqrt()).normalize_or(incident))
}

/// The direction of a ray that travels along `incident` and is mirrored at a surface with normal `n`, unit vectors.
pub fn mirror(incident: DVec3, n: DVec3) -> DVec3 {
    incident - 2.0 * incident.dot(n) * n
}

/// The angle of incidence beyond which nothing is transmitted, radians; none for η ≥ 1.
pub fn critical_angle(eta: f64) -> Option<f64> {
    (eta < 1.0).then(|| eta.asin())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn towards(angle: f64) -> DVec3 {
        DVec3::new(angle.sin(), 0.0, -angle.cos())
    }

    #[test]
    fn the_sines_are_as_the_indices() {
        for eta in [0.7, 1.0, 1.33, 1.5, 2.4] {
            for degrees in 0..90_i32 {
                let angle = f64::from(degrees).to_radians();
                let through = refract(towards(angle), DVec3::Z, eta);
                let sine = angle.sin() / eta;
                match through {
                    Some(t) => {
                        assert!((t.length() - 1.0).abs() < 1e-14);
                        assert!((t.x - sine).abs() < 1e-14 && t.y == 0.0 && t.z <= 0.0, "η {eta}, {degrees}°: {t}");
                    }
                    None => assert!(sine > 1.0, "η {eta}, {degrees}°"),
                }
            }
        }
    }

    #[test]
    fn equal_indices_change_nothing_and_the_normal_is_never_bent() {
        for degrees in 0..90_i32 {
            let i = towards(f64::from(degrees).to_radians());
            assert!((refract(i, DVec3::Z, 1.0).expect("no total reflection") - i).length() < 1e-14);
        }
        assert_eq!(refract(-DVec3::Z, DVec3::Z, 0.5), Some(-DVec3::Z));
    }

    #[test]
    fn at_the_critical_angle_the_ray_grazes() {
        let eta = 1.0 / 1.5;
        let critical = critical_angle(eta).expect("η < 1");
        assert!((critical.to_degrees() - 41.810_314_895_778_6).abs() < 1e-12);
        let grazing = refract(towards(critical - 1e-9), DVec3::Z, eta).expect("just before");
        assert!(grazing.z.abs() < 1e-4 && grazing.x > 1.0 - 1e-8);
        assert_eq!(refract(towards(critical + 1e-9), DVec3::Z, eta), None);
        assert_eq!(critical_angle(1.0), None);
    }

    #[test]
    fn there_and_back_again() {
        for degrees in 0..90_i32 {
            let i = towards(f64::from(degrees).to_radians());
            let inside = refract(i, DVec3::Z, 1.5).expect("into glass");
            let outside = refract(inside, DVec3::Z, 1.0 / 1.5).expect("out of it");
            assert!((outside - i).length() < 1e-7, "{degrees}");
        }
    }

    #[test]
    fn a_mirrored_ray_keeps_its_angle() {
        for degrees in 0..=90_i32 {
            let i = towards(f64::from(degrees).to_radians());
            let m = mirror(i, DVec3::Z);
            assert!((m - DVec3::new(i.x, i.y, -i.z)).length() < 1e-15);
        }
    }
}
