//! The vertices of a scene's own polygons, moved by dragging or by numbers.

use crate::app::session::place::tidy;
use crate::scene::{GREATEST_LENGTH, Object};
use glam::DVec3;

/// Maximum number of vertices that have handles. More handles would hide the picture.
pub const MOST_HANDLES: usize = 64;

/// Number of halvings on the way to a position that cannot be reached.
const HALVINGS: u32 = 12;

/// Moves a vertex to `to`, or as far towards it as its polygons allow.
///
/// Positions on the way are kept to the digits of `unit`.
pub fn move_vertex(object: &mut Object, v: u32, to: DVec3, unit: f64) {
    let polygons = object.polygons();
    let Some(from) = polygons.vertices.get(v as usize).copied() else {
        return;
    };
    let allowed = |to: DVec3| {
        let mut moved = polygons.clone();
        moved.vertices.make_mut()[v as usize] = to;
        to.is_finite() && to.abs().max_element() <= GREATEST_LENGTH && moved.spoilt_by(v).is_none()
    };
    let mut reached = to;
    if !allowed(to) {
        let (mut near, mut far) = (0.0, 1.0);
        reached = from;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (near + far);
            let between = tidy(from.lerp(to, middle), unit);
            if allowed(between) {
                (near, reached) = (middle, between);
            } else {
                far = middle;
            }
        }
    }
    if reached != from {
        object.vertices_mut()[v as usize] = reached;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::ObjectKind;

    fn square() -> Object {
        Object {
            kind: ObjectKind::Polygons,
            vertices: [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
                .map(|[x, y]| DVec3::new(x, y, 0.0))
                .to_vec()
                .into(),
            faces: vec![vec![0, 1, 2, 3].into()].into(),
            ..Object::default()
        }
    }

    #[test]
    fn a_vertex_goes_as_far_as_its_polygons_let_it() {
        let mut object = square();
        move_vertex(&mut object, 0, DVec3::new(0.3, 0.2, 0.0), 1e-3);
        assert_eq!(object.vertices[0], DVec3::new(0.3, 0.2, 0.0));
        // Beyond the opposite corner the edges would cross: the vertex stops before the end of the diagonal.
        move_vertex(&mut object, 0, DVec3::new(0.3, 1.7, 0.0), 1e-3);
        let stopped = object.vertices[0];
        assert!(
            stopped.x == 0.3 && (0.9..1.0).contains(&stopped.y),
            "{stopped}"
        );
        assert!(object.polygons().spoilt_by(0).is_none());
        move_vertex(&mut object, 0, DVec3::NAN, 1e-3);
        move_vertex(&mut object, 0, DVec3::splat(1e300), 1e-3);
        move_vertex(&mut object, 7, DVec3::ZERO, 1e-3);
        assert!(object.vertices.iter().all(|vertex| vertex.length() < 1e30));
        // A free position beyond an obstacle is reached.
        move_vertex(&mut object, 0, DVec3::new(-1.0, -1.0, 0.5), 1e-3);
        assert_eq!(object.vertices[0], DVec3::new(-1.0, -1.0, 0.5));
    }

    #[test]
    fn a_quadrilateral_that_is_not_written_down_becomes_so() {
        let mut object = Object {
            kind: ObjectKind::Polygons,
            ..Object::default()
        };
        move_vertex(&mut object, 2, DVec3::new(1.0, 1.0, 0.0), 1e-3);
        assert_eq!(
            (object.vertices.len(), object.vertices[2]),
            (4, DVec3::new(1.0, 1.0, 0.0))
        );
    }
}
