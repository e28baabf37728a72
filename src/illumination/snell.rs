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
