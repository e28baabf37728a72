//! Random scenes whose numbers are everyday ones, the ends of their ranges, or ones that no scene may hold.

use super::any_formula::any_formula;
use super::dice;
mod model;

use dice::Dice;
use glam::DVec3;
use shading_lab::geometry::Mesh;
use shading_lab::scene::{
    Ambient, AmbientSource, AreaShape, Attenuation, Backdrop, Backfacing, Camera, Choice, Compare,
    CompareView, CuedBy, DepthCueing, DifferenceKind, Display, Distribution, Encoding, FlatAt,
    Framing, GREATEST_INTENSITY, GREATEST_LENGTH, Ground, Image, Interpolation, LEAST_LENGTH,
    Light, LightKind, Material, NormalSource, Object, ObjectKind, Overflow, Pane, Pattern,
    PatternKind, Projection, Reflectance, Reflection, ReflectionModel, Rgb, Scene, Shading,
    ShadingMode, Shared, Through, Transparency, Viewer, Weighting,
};
use std::ops::RangeInclusive;
use std::sync::Arc;

/// Numbers that most keys refuse.
const SPECIAL: [f64; 16] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    1e300,
    -1e300,
    1.1e30,
    1e40,
    -1.0,
    -1e-320,
    -1e-30,
    -0.0,
    1e-320,
    f64::MIN_POSITIVE,
    1e-300,
];

/// A scene with its model: a mesh if the scene is of kind `obj`, or the reason why it cannot be read.
pub struct AnyScene {
    pub scene: Scene,
    pub model: Result<Option<Arc<Mesh>>, String>,
}

/// Returns the scene with this seed.
pub fn any_scene(seed: u64) -> AnyScene {
    let mut dice = Dice(seed.wrapping_mul(0xd134_2543_de82_ef95));
    let extreme = dice.of(&[0.0, 0.0, 0.01, 0.03, 0.1, 0.3, 0.6]);
    let special = dice.of(&[0.0, 0.0, 0.0, 0.0, 0.002, 0.02]);
    let lean = if dice.unit() < 0.5 {
        Some((dice.unit() * 3.0) as usize)
    } else {
        None
    };
    let scale = if dice.unit() < 0.7 {
        1.0
    } else {
        10_f64.powf(dice.between(-30.0, 30.0))
    };
    Author {
        dice,
        extreme,
        lean,
        special,
        scale,
        points: Vec::new(),
    }
    .scene()
}

/// Returns the scene with this seed, with everyday numbers only: no extreme makes single precision fall short.
pub fn everyday_scene(seed: u64) -> AnyScene {
    let dice = Dice(seed.wrapping_mul(0xd134_2543_de82_ef95));
    Author {
        dice,
        extreme: 0.0,
        lean: None,
        special: 0.0,
        scale: 1.0,
        points: Vec::new(),
    }
    .scene()
}

/// A source of the random numbers of one scene.
struct Author {
    dice: Dice,
    /// Probability that a number is at an end of its range, or anywhere in it.
    extreme: f64,
    /// Index of the preferred end: the minimum, the maximum, or the smallest magnitude.
    lean: Option<usize>,
    /// Probability that a number is one of [`SPECIAL`].
    special: f64,
    /// Scale of everyday lengths.
    scale: f64,
    /// Points of the scene so far, for others to coincide with.
    points: Vec<DVec3>,
}

impl Author {
    fn chance(&mut self, probability: f64) -> bool {
        self.dice.unit() < probability
    }

    fn number(&mut self, everyday: RangeInclusive<f64>, allowed: RangeInclusive<f64>) -> f64 {
        if self.chance(self.special) {
            self.dice.of(&SPECIAL)
        } else if self.chance(self.extreme) {
            let magnitude = 10_f64.powf(self.dice.between(-31.0, 31.0));
            let (low, high) = (*allowed.start(), *allowed.end());
            let any = [
                low,
                high,
                1e-320,
                low.next_up(),
                high.next_down(),
                0.0,
                -0.0,
                magnitude,
                -magnitude,
                1.0,
            ];
            let lean = self.lean.filter(|_| self.chance(0.7));
            lean.map_or_else(|| self.dice.of(&any), |lean| any[lean])
                .clamp(low, high)
        } else {
            self.dice.between(*everyday.start(), *everyday.end())
        }
    }

    fn part(&mut self) -> f64 {
        self.number(0.0..=1.0, 0.0..=1.0)
    }

    fn length(&mut self, everyday: RangeInclusive<f64>, allowed: RangeInclusive<f64>) -> f64 {
        let (low, high) = (everyday.start() * self.scale, everyday.end() * self.scale);
        self.number(low..=high, allowed)
    }

    fn coordinate(&mut self, reach: f64) -> f64 {
        self.length(-reach..=reach, -GREATEST_LENGTH..=GREATEST_LENGTH)
    }

    /// Returns a point within `reach` of the origin; at times an earlier point, or one next to it.
    fn point(&mut self, reach: f64) -> DVec3 {
        let mut point = DVec3::new(
            self.coordinate(reach),
            self.coordinate(reach),
            self.coordinate(reach),
        );
        if !self.points.is_empty() && self.chance(0.05) {
            let points = self.points.clone();
            point = self.dice.of(&points);
            if self.chance(0.5) {
                let axis = (self.dice.unit() * 3.0) as usize;
                point[axis] = self.dice.of(&[
                    point[axis].next_up(),
                    point[axis] * (1.0 + 1e-9),
                    point[axis] + 1e-7,
                ]);
            }
        }
        self.points.push(point);
        point
    }

    fn direction(&mut self) -> DVec3 {
        if self.chance(0.1) {
            return self
                .dice
                .of(&[DVec3::X, DVec3::NEG_Y, DVec3::Y, DVec3::NEG_Z, DVec3::Z]);
        }
        if self.points.len() > 1 && self.chance(0.1) {
            let points = self.points.clone();
            return self.dice.of(&points) - self.dice.of(&points);
        }
        self.point(1.0)
    }

    fn color(&mut self, greatest: f64) -> Rgb {
        if self.chance(0.15) {
            return self.dice.of(&[Rgb::ZERO, Rgb::ONE]);
        }
        let mut channel = || self.number(0.0..=1.0, 0.0..=greatest);
        Rgb::new(channel(), channel(), channel())
    }

    fn count(&mut self, everyday: &[u32]) -> u32 {
        if self.chance(self.special) {
            return self.dice.of(&[0, 1, 2, 4097, u32::MAX]);
        }
        self.dice.of(everyday)
    }

    fn scene(mut self) -> AnyScene {
        let camera = self.camera();
        let image = self.image();
        let object = self.object();
        let mut scene = Scene {
            camera,
            image,
            material: self.material(),
            pattern: self.pattern(),
            transparency: self.transparency(),
            reflection: self.reflection(),
            shading: self.shading(),
            display: self.display(),
            ground: self.ground(),
            backdrop: self.backdrop(),
            depth_cueing: self.depth_cueing(),
            ambient: Ambient {
                color: self.color(GREATEST_INTENSITY),
                source: self.dice.of(&[
                    AmbientSource::Constant,
                    AmbientSource::Constant,
                    AmbientSource::Constant,
                    AmbientSource::Bounce,
                    AmbientSource::Split,
                ]),
            },
            lights: self.lights(),
            object,
            ..Scene::default()
        };
        scene.compare = self.compare();
        let model = if scene.object.kind == ObjectKind::Obj {
            self.model(scene.object.fit)
                .map(|mesh| Some(Arc::new(mesh)))
        } else {
            Ok(None)
        };
        AnyScene { scene, model }
    }

    fn camera(&mut self) -> Camera {
        let target = self.point(0.5);
        let eye = if self.chance(0.1) {
            self.point(1.5)
        } else {
            target + self.point(4.0)
        };
        self.points.push(eye);
        let up = if self.chance(0.7) {
            DVec3::Y
        } else {
            self.direction()
        };
        Camera {
            eye,
            target,
            up,
            roll: if self.chance(0.8) {
                0.0
            } else {
                self.number(-400.0..=400.0, -1e300..=1e300)
            },
            projection: self.dice.of(&[
                Projection::Perspective,
                Projection::Perspective,
                Projection::Orthographic,
            ]),
            fov_y: self.number(10.0..=120.0, Camera::FOV_Y),
            height: self.length(0.5..=6.0, LEAST_LENGTH..=GREATEST_LENGTH),
            // Without drawing a random number, which would change all later ones.
            framing: if eye.x > target.x {
                Framing::Whole
            } else {
                Framing::Height
            },
            viewer: self.dice.of(Viewer::VALUES),
        }
    }

    fn image(&mut self) -> Image {
        let mut size = [16, 16];
        if self.chance(0.1) {
            size = self
                .dice
                .of(&[[1, 1], [16, 1], [1, 16], [17, 15], [33, 8], [2, 40]]);
        } else if self.chance(self.special) {
            size = self.dice.of(&[
                [0, 16],
                [16, 0],
                [16_385, 1],
                [16_384, 16_384],
                [u32::MAX, u32::MAX],
            ]);
        }
        Image {
            size,
            background: self.color(GREATEST_INTENSITY),
        }
    }

    fn object(&mut self) -> Object {
        let shapes = ObjectKind::VALUES
            .iter()
            .filter(|kind| kind.has_surface() && **kind != ObjectKind::Teapot);
        let kinds: Vec<_> = shapes
            .copied()
            .chain([ObjectKind::Polygons; 3])
            .chain([ObjectKind::Obj; 2])
            .collect();
        let kind = self.dice.of(&kinds);
        let kind = if self.chance(0.01) {
            ObjectKind::Teapot
        } else {
            kind
        };
        let mut object = Object {
            kind,
            segments: self.count(&[3, 4, 5, 7, 12]),
            rings: self.count(&[3, 3, 4, 7]),
            normals: self.dice.of(NormalSource::VALUES),
            weighting: self.dice.of(Weighting::VALUES),
            fit: self.chance(0.5),
            ..Object::default()
        };
        if kind == ObjectKind::Teapot {
            (object.segments, object.rings) = (4, 2);
        }
        if kind == ObjectKind::Obj && !self.chance(self.special) {
            object.path = Some("model.obj".into());
        }
        if kind == ObjectKind::Polygons && !self.chance(0.1) {
            self.polygons(&mut object);
        }
        object
    }

    /// Adds vertices about a point and polygons over them; neighbours share some vertices.
    fn polygons(&mut self, object: &mut Object) {
        let middle = if self.chance(0.8) {
            DVec3::ZERO
        } else {
            self.point(2.0)
        };
        let count = 3 + (self.dice.unit() * 5.0) as u32;
        let mut vertices: Vec<DVec3> = (0..count).map(|_| middle + self.point(1.5)).collect();
        if self.chance(0.5) {
            // In a ring, so that a polygon over all of them is simple.
            for (k, vertex) in vertices.iter_mut().enumerate() {
                let (sine, cosine) =
                    (std::f64::consts::TAU * k as f64 / f64::from(count)).sin_cos();
                *vertex = *vertex * 0.2 + DVec3::new(cosine, sine, 0.0) * self.scale;
            }
        }
        let mut faces: Vec<Vec<u32>> = match self.dice.of(&[0, 1, 2]) {
            0 => vec![(0..count).collect()],
            1 => (2..count).map(|k| vec![0, k - 1, k]).collect(),
            _ => (2..count).map(|k| vec![k - 2, k - 1, k]).collect(),
        };
        if self.chance(0.3) {
            faces.push(vec![0, 2, 1]);
        }
        if self.chance(self.special) {
            faces.push(
                self.dice
                    .of(&[[0, 1, 1], [0, 1, 99], [0, 1, u32::MAX]])
                    .to_vec(),
            );
        }
        if self.chance(0.3) {
            object.vertex_normals = (0..count).map(|_| self.direction()).collect();
        }
        object.vertices = vertices.into();
        object.faces = faces.into_iter().map(Shared::from).collect();
    }

    fn material(&mut self) -> Material {
        let n = match self.chance(0.3) {
            true => self.dice.of(&[
                0.0,
                1e-320,
                0.3,
                1.0,
                64.0,
                64_f64.next_down(),
                1e6,
                1e7,
                1e7_f64.next_up(),
                1e12,
                1e30,
                f64::MAX,
                f64::INFINITY,
            ]),
            false => self.number(0.0..=300.0, 0.0..=f64::INFINITY),
        };
        let coefficient = Material::MAX_COEFFICIENT;
        let index = |author: &mut Self| author.number(0.2..=3.0, Material::IOR);
        Material {
            ka: self.color(coefficient),
            kd: self.color(coefficient),
            ks: self.color(coefficient),
            n,
            roughness: self.number(0.05..=1.0, Material::ROUGHNESS),
            color: self.color(coefficient),
            specular_color: self.color(coefficient),
            reflectance: self.dice.of(&[
                Reflectance::Constant,
                Reflectance::Constant,
                Reflectance::Glass,
                Reflectance::Silver,
                Reflectance::Gold,
                Reflectance::Custom,
            ]),
            ior: Rgb::new(index(self), index(self), index(self)),
            extinction: self.color(*Material::IOR.end()),
            source: shading_lab::scene::MaterialSource::Model,
        }
    }

    fn kind_of_pattern(&mut self) -> PatternKind {
        self.dice.of(&[
            PatternKind::None,
            PatternKind::None,
            PatternKind::None,
            PatternKind::Checker,
            PatternKind::Stripes,
            PatternKind::Rings,
        ])
    }

    fn pattern(&mut self) -> Pattern {
        let kind = self.kind_of_pattern();
        let color = self.color(Material::MAX_COEFFICIENT);
        Pattern {
            kind,
            color,
            scale: self.number(0.1..=1.0, Pattern::SCALE),
        }
    }

    fn transparency(&mut self) -> Transparency {
        let kt = if self.chance(0.6) { 0.0 } else { self.part() };
        let ior = self.number(0.5..=2.0, Transparency::IOR);
        Transparency {
            kt,
            ior,
            through: self.dice.of(Through::VALUES),
        }
    }

    fn reflection(&mut self) -> Reflection {
        Reflection {
            // Without drawing random numbers, which would change all later ones.
            formula: any_formula(&mut Dice(self.dice.0)),
            model: self.dice.of(ReflectionModel::VALUES),
            distribution: self.dice.of(Distribution::VALUES),
            backfacing: self.dice.of(Backfacing::VALUES),
        }
    }

    fn shading(&mut self) -> Shading {
        Shading {
            mode: self.dice.of(ShadingMode::VALUES),
            flat_at: self.dice.of(FlatAt::VALUES),
            interpolation: self.dice.of(Interpolation::VALUES),
            renormalise: self.chance(0.7),
            shadows: self.chance(0.3),
        }
    }

    fn display(&mut self) -> Display {
        Display {
            overflow: self.dice.of(Overflow::VALUES),
            encoding: self.dice.of(Encoding::VALUES),
        }
    }

    fn ground(&mut self) -> Ground {
        let coefficient = Material::MAX_COEFFICIENT;
        Ground {
            visible: self.chance(0.3),
            height: self.coordinate(1.5),
            ka: self.number(0.0..=1.0, 0.0..=coefficient),
            kd: self.number(0.0..=1.0, 0.0..=coefficient),
            color: self.color(coefficient),
        }
    }

    fn backdrop(&mut self) -> Backdrop {
        Backdrop {
            pattern: self.kind_of_pattern(),
            color: self.color(GREATEST_INTENSITY),
            scale: self.number(0.1..=1.0, Pattern::SCALE),
            distance: self.coordinate(3.0),
        }
    }

    fn depth_cueing(&mut self) -> DepthCueing {
        let front = self.length(0.0..=4.0, 0.0..=GREATEST_LENGTH.next_down());
        let back = if self.chance(0.1) {
            front.next_up()
        } else {
            front + self.length(0.1..=4.0, 0.0..=GREATEST_LENGTH)
        };
        let back = if self.chance(self.special) {
            front
        } else {
            back.min(GREATEST_LENGTH)
        };
        DepthCueing {
            by: self.dice.of(CuedBy::VALUES),
            front,
            back,
            front_scale: self.part(),
            back_scale: self.part(),
            color: self.color(GREATEST_INTENSITY),
        }
    }

    fn lights(&mut self) -> Vec<Light> {
        let count = self.dice.of(&[0, 1, 1, 1, 1, 2, 2, 3, 5]);
        if self.chance(0.0005) {
            let light = Light {
                samples: 4,
                ..self.light()
            };
            let count =
                self.dice
                    .of(&[Scene::MAX_LIGHTS, Scene::MAX_LIGHTS, Scene::MAX_LIGHTS + 1]);
            return vec![light; count];
        }
        (0..count).map(|_| self.light()).collect()
    }

    fn light(&mut self) -> Light {
        Light {
            kind: self.dice.of(LightKind::VALUES),
            mute: self.chance(0.03),
            solo: self.chance(0.03),
            position: self.point(3.0),
            direction: self.direction(),
            color: self.color(GREATEST_INTENSITY),
            cone: self.number(5.0..=90.0, Light::CONE),
            exponent: self.number(0.0..=50.0, 0.0..=Light::MAX_EXPONENT),
            softness: self.part(),
            shape: self.dice.of(AreaShape::VALUES),
            extent: [(); 2].map(|()| self.length(0.0..=2.0, 0.0..=GREATEST_LENGTH)),
            radius: self.length(0.0..=1.0, 0.0..=GREATEST_LENGTH),
            samples: self.count(&[1, 2, 3, 6]),
            attenuation: self.dice.of(Attenuation::VALUES),
            k: self.length(0.0..=2.0, 0.0..=GREATEST_LENGTH),
            c1: self.number(0.0..=1.0, 0.0..=GREATEST_LENGTH),
            c2: self.number(0.0..=1.0, 0.0..=GREATEST_LENGTH),
            c3: self.number(0.0..=1.0, 0.0..=GREATEST_LENGTH),
            ..Light::default()
        }
    }

    fn compare(&mut self) -> Compare {
        const SETTINGS: [&str; 14] = [
            "shading.mode=flat",
            "shading.mode=exact",
            "shading.mode=gouraud",
            "shading.renormalise=false",
            "material.n=inf",
            "material.n=1e8",
            "material.ks=1e6",
            "object.kind=cube",
            "object.normals=facet",
            "display.overflow=scale",
            "transparency.kt=0.5",
            "ground.visible=true",
            "ambient.source=bounce",
            "shading.shadows=true",
        ];
        const REFUSED: [&str; 4] = [
            "material.n=nan",
            "camera.fov_y=10",
            "nothing=1",
            "object.segments=-1",
        ];
        let panes = if self.chance(0.9) {
            0
        } else {
            self.dice.of(&[1, 1, 2, 3])
        };
        let mut panes: Vec<Pane> = (0..panes)
            .map(|_| Pane::of(&[self.dice.of(&SETTINGS), self.dice.of(&SETTINGS)]))
            .collect();
        if self.chance(self.special) {
            panes.push(Pane::of(&[self.dice.of(&REFUSED)]));
        }
        let views = [
            CompareView::Panes,
            CompareView::Wipe,
            CompareView::Difference,
        ];
        Compare {
            view: if panes.is_empty() {
                CompareView::Single
            } else {
                self.dice.of(&views)
            },
            wipe: self.part(),
            difference: self.dice.of(DifferenceKind::VALUES),
            gain: self.number(1.0..=16.0, 1.0..=Compare::MAX_GAIN),
            name: if panes.len() == 2 { "A" } else { "" }.to_owned(),
            reference: panes.len() as u32 / 2,
            panes,
        }
    }
}
