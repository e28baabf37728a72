//! Maps against rays: of random meshes and lights, every point that a map decides is asked of the boxes too.

use super::*;
use crate::geometry::tessellate;
use crate::render::model::Model;
use crate::render::rays::Bvh;
use crate::render::rays::packet::{Packet, PointRow, RAYS};
use crate::render::rays::proof::Balls;
use crate::scene::{NormalSource, Object, ObjectKind, Shared, Weighting};
use fearless_simd::{Level, dispatch};
use std::env::var;

/// Numbers that look random (Steele, Lea and Flood 2014, SplitMix64).
struct Dice(u64);

impl Dice {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.unit() * choices.len() as f64) as usize]
    }

    fn vector(&mut self, reach: f64) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| reach * (2.0 * self.unit() - 1.0)))
    }
}

/// A shape, a band with half turns, a sheet of bumps or of folds, or triangles between any corners.
fn object(dice: &mut Dice) -> Object {
    let kind = dice.of(&[
        ObjectKind::Sphere,
        ObjectKind::Torus,
        ObjectKind::Teapot,
        ObjectKind::Cube,
        ObjectKind::Plane,
        ObjectKind::Polygons,
        ObjectKind::Polygons,
        ObjectKind::Polygons,
    ]);
    let mut object = Object {
        kind,
        segments: dice.of(&[6, 12, 24, 48, 96]),
        rings: dice.of(&[4, 8, 24, 48]),
        normals: dice.of(&[
            NormalSource::Exact,
            NormalSource::Averaged,
            NormalSource::Facet,
        ]),
        ..Object::default()
    };
    if kind == ObjectKind::Polygons {
        let count = dice.of(&[5, 12, 40]);
        let half_turns = dice.of(&[0.0, 1.0, 2.0, 3.0]);
        let [first, second] = dice.of(&[[0.0, 0.0], [0.3, 0.0], [0.0, 0.5], [0.05, 2.0]]);
        let corner = |k: u32, dice: &mut Dice| {
            let angle = std::f64::consts::TAU * f64::from(k / 2) / f64::from(count);
            let side = if k.is_multiple_of(2) { -0.4 } else { 0.4 };
            let (sine, cosine) = (0.5 * half_turns * angle).sin_cos();
            let out = 0.9 + side * cosine + second * (3.0 * angle).sin();
            let ring = DVec3::new(out * angle.cos(), side * sine, out * angle.sin());
            ring + dice.vector(first)
        };
        object.vertices = (0..2 * count).map(|k| corner(k, dice)).collect();
        let strip = |k: u32| [k, k + 1, k + 2].map(|k| k % (2 * count));
        let soup = dice.unit() < 0.3;
        let any = |dice: &mut Dice| (dice.unit() * 2.0 * f64::from(count)) as u32;
        object.faces = (0..2 * count)
            .map(|k| match (soup, strip(k)) {
                (true, _) => [(); 3].map(|()| any(dice)),
                (false, [a, b, c]) if k.is_multiple_of(2) => [a, b, c],
                (false, [a, b, c]) => [a, c, b],
            })
            .map(|face| Shared::from(face.to_vec()))
            .collect();
    }
    object
}

/// Points that a map decided: the object's own that are lit, others that are lit, and the floor's in shadow.
type Decided = [u32; 3];

fn compare(seed: u64) -> Decided {
    let mut dice = Dice(seed.wrapping_mul(0xd134_2543_de82_ef95));
    let mesh = tessellate(&object(&mut dice));
    let model = Model::new(mesh.with_vertex_normals(NormalSource::Averaged, Weighting::Equal));
    let bvh = Bvh::new(&model);
    let solid = Solid {
        level: Level::new(),
        model: &model,
        bvh: &bvh,
        surface: None,
        smooth: true,
    };
    let (middle, radius) = solid.ball();
    let axis = dice.of(&[DVec3::X, DVec3::Y, DVec3::NEG_Z]);
    let towards = if dice.unit() < 0.2 {
        axis
    } else {
        dice.vector(1.0)
    };
    let parallel = dice.unit() < 0.3;
    let far = dice.of(&[0.9, 1.51, 2.0, 4.0, 1e3, 1e8]) * radius;
    let place = towards.normalize() * if parallel { 1.0 } else { far };
    let ground = dice.of(&[0.0, 0.0, 1e-7, 0.1, 0.5]);
    let ground = middle.y + bvh.lowest() - ground * radius;
    let target = Target::new(
        place,
        parallel,
        middle.y + place.y - ground * f64::from(u8::from(!parallel)),
        radius,
    );
    let mut decided = [0; 3];
    for own in [true, false] {
        let Some(map) = LightMap::new(&solid, &target, Some(ground), own) else {
            continue;
        };
        for _ in 0..200 {
            let row = if own {
                own_points(&solid, &mut dice)
            } else {
                other_points(ground - middle.y, radius, &mut dice)
            };
            let [lit, dark] = check(&solid, &map, &target, &row, ground - middle.y, own);
            decided[usize::from(!own)] += lit;
            decided[2] += dark;
        }
    }
    decided
}

fn own_points(solid: &Solid<'_>, dice: &mut Dice) -> PointRow {
    let model = solid.model;
    let mut row = PointRow::default();
    row.clear(RAYS);
    for index in 0..RAYS {
        let triangle = (dice.unit() * model.triangles.len() as f64) as usize;
        let vertices = model.triangles[triangle];
        let mut share = DVec3::from_array([(); 3].map(|()| dice.unit().powi(4)));
        // On an edge or very near it, too.
        share[index % 3] *= dice.of(&[1.0, 1.0, 0.0, 1e-7]);
        share /= share.element_sum();
        let mean = |of: [DVec3; 3]| of[0] * share.x + of[1] * share.y + of[2] * share.z;
        let corners = vertices.map(|vertex| model.place(vertex).as_dvec3());
        let normals = vertices.map(|vertex| model.normal(vertex));
        let point = mean(corners);
        let mut start = point;
        for k in 0..3 {
            let above = corners.map(|corner| (corner - corners[k]).dot(normals[k]));
            let below = DVec3::from_array(above).dot(share).min(0.0);
            start -= normals[k] * (below * share[k]);
        }
        let near = start.distance(point) < LIFT * model.radius;
        row.set_own(index, start, mean(normals).normalize_or_zero(), near);
    }
    row
}

/// Points of the floor, and some anywhere.
fn other_points(ground: f64, radius: f64, dice: &mut Dice) -> PointRow {
    let mut row = PointRow::default();
    row.clear(RAYS);
    for index in 0..RAYS {
        let reach = radius * dice.of(&[1.0, 3.0, 30.0]);
        let mut point = dice.vector(reach);
        if index > 3 {
            point.y = ground;
        }
        row.set(index, point, DVec3::Y);
    }
    row
}

/// How many points the map says to be lit, and in shadow.
fn check(
    solid: &Solid<'_>,
    map: &LightMap,
    target: &Target,
    row: &PointRow,
    ground: f64,
    own: bool,
) -> [u32; 2] {
    let balls = Balls {
        outer: solid.ball().1 as f32,
        inner: 0.0,
    };
    let clearance = solid.clearance();
    let [lit, dark, facing] = dispatch!(solid.level, simd => {
        let heights = [ground, f64::NEG_INFINITY];
        let points = Points::load(simd, row, 0, [1.0, clearance], heights, balls);
        let facing = points.facing(simd, &points.way_to(simd, target));
        let [lit, dark] = map.decide(simd, &points, if own { facing & row.on_triangle[0] } else { 0xffff });
        [lit, dark, facing]
    });
    let mut packet = Packet::default();
    for index in 0..RAYS {
        let start = row.lifted(index, clearance);
        let (direction, t_max) = if target.parallel {
            (target.place, f64::MAX)
        } else {
            (target.place - start, 1.0)
        };
        packet.set(index, start, direction, t_max);
    }
    let blocked = dispatch!(solid.level, simd => solid.blocked(simd, &packet, 0xffff));
    assert_eq!(lit & blocked, 0, "lit and hidden, own: {own}");
    // A floor is in shadow only of lights above it.
    assert_eq!(
        dark & facing & !blocked,
        0,
        "dark and not hidden, own: {own}"
    );
    [lit.count_ones(), (dark & facing).count_ones()]
}

#[test]
fn what_maps_decide_is_what_rays_find() {
    let count = var("SHADING_LAB_MAPS").map_or(150, |count| count.parse().expect("a number"));
    let mut decided = [0; 3];
    for seed in 0..count {
        let of_scene = std::panic::catch_unwind(|| compare(seed));
        let of_scene = of_scene.unwrap_or_else(|_| panic!("scene {seed}"));
        for (sum, points) in decided.iter_mut().zip(of_scene) {
            *sum += u64::from(points);
        }
    }
    assert!(
        decided.iter().all(|points| *points > 100 * count),
        "{decided:?}"
    );
}

#[test]
fn edges_that_miss_the_view_or_are_no_numbers_mark_only_cells_of_the_map() {
    for corners in [
        [DVec2::splat(-1e9), DVec2::splat(1e300)],
        [DVec2::NAN, DVec2::new(3.0, f64::INFINITY)],
        [DVec2::new(5.0, 7.5), DVec2::new(9.0, 7.5)],
    ] {
        spans(&corners, 1, |range| {
            assert!(range.start < range.end && range.end <= SIDE * SIDE);
            assert_eq!(range.start / SIDE, (range.end - 1) / SIDE);
        });
        let draft = Draft {
            outline: false,
            sheets: [0; 2],
        };
        wind(corners, false, &mut vec![draft; SIDE * SIDE]);
    }
    let mut rows = Vec::new();
    spans(&[DVec2::new(5.0, 7.5), DVec2::new(9.0, 7.5)], 1, |range| {
        rows.push((range.start / SIDE, range.start % SIDE, range.len()));
    });
    assert_eq!(rows, [(6, 4, 7), (7, 4, 7), (8, 4, 7)]);
}
