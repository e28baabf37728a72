//! The scene's own law in the exports: its text, and the pictures that Mesa draws by it.

use super::mesa::{Edges, compare_glsl, draw_glsl, mesa, small, small_model};
use super::{count, program, scene, snippet};
use crate::common::any_formula::any_formula;
use crate::common::dice::Dice;
use crate::common::tries::tries;
use crate::model_materials;
use glam::DVec3;
use shading_lab::analysis::probe::{LightTerms, probe};
use shading_lab::export::{Limit, glsl_330};
use shading_lab::expression::{Formula, Operator, Term, Typed};
use shading_lab::geometry::tessellate;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    LAW_NUMBERS, Light, LightKind, ObjectKind, PatternKind, Reflection, ReflectionModel, Scene,
};
use std::sync::Arc;

const BLINN: &str =
    "h = normalize(L + V)\nkd * od * max(N·L, 0) + ks * os * max(N·h, 0)^n * (N·L > 0)";

/// Returns the scene with a law of its own.
fn with_law(mut scene: Scene, formula: &str) -> Scene {
    scene.reflection.model = ReflectionModel::Formula;
    scene.reflection.formula = formula.to_owned();
    scene.validate().expect(formula);
    scene
}

/// Returns the shader that evaluates a law.
fn shader(formula: &str) -> String {
    let export = glsl_330(&with_law(scene("sphere", &[]), formula));
    assert_eq!(export.limits, [] as [Limit; 0]);
    export.parts[1].text.clone()
}

#[test]
fn a_law_stands_in_the_shader_as_it_was_typed() {
    let text = shader(Reflection::PHONG);
    for line in [
        "//     I = Ka*Od*Ia + sum over the lights of f*Ip*law, the scene's own law",
        "    // spot = max(R.V, 0)",
        "    float spot = max(dot(R, V), 0.0);",
        "    // kd * od * max(N.L, 0) + ks * os * spot^n * (N.L > 0)",
    ] {
        assert!(text.lines().any(|own| own == line), "{line}\n{text}");
    }
    // Nothing is clamped, and nothing stands there that the law does not need.
    for word in ["NL", "quotient", "float d,", "eta", "angle_of"] {
        assert!(!text.contains(word), "{word}\n{text}");
    }
    let other = shader("1/d + theta");
    assert!(other.contains("float d, ") && other.contains("angle_of_cosine(dot(N, L))"));
    assert!(!other.contains("Kd") && !other.contains("Ks") && !other.contains("power"));
}

#[test]
fn any_law_is_ascii_whatever_its_comments_say() {
    let text = shader("# 漫反射 \\\nα₁ = √(max(N·L, 0)) // ½\n\nkd × α₁² ÷ 2");
    assert!(text.is_ascii());
    assert!(
        text.contains("    // # ??? ?\n    // alpha1 = sqrt(max(N.L, 0)) // ?\n    float alpha1 =")
    );
    assert!(
        text.contains(
            "    // kd * alpha1^2 / 2\n    return Kd[channel] * power(alpha1, 2.0) / 2.0;"
        )
    );
}

#[test]
fn fixed_function_has_no_law() {
    let set = [
        "shading.mode=gouraud",
        "material.n=200",
        "material.reflectance=gold",
        "reflection.backfacing=flip",
    ];
    let own = with_law(scene("sphere", &set), "N·L");
    for export in [program(&own), snippet(&own)] {
        let keys = |key: &str| count(&export, key);
        assert_eq!(keys("export-limit-own-law"), 1);
        // W, n and the turned N are no part of such a law.
        for key in ["shininess", "reflectance", "two-side", "phong-lobe"] {
            assert_eq!(keys(&format!("export-limit-{key}")), 0, "{key}");
        }
        assert!(export.parts[0].text.contains("GL_SHININESS, 128.0f"));
    }
}

/// Draws a scene of a built-in object with its shaders and compares all pixels with ours.
#[track_caller]
fn compare(name: &str, scene: &Scene) {
    let mesh = Arc::new(tessellate(&scene.object));
    compare_glsl(&format!("own-{name}"), scene, Some(&mesh));
}

#[test]
fn own_laws_are_drawn_the_same() {
    if !mesa() {
        return;
    }
    let spot = "light=[{kind=\"spot\", position=[1,2,3], direction=[-1,-2,-3], cone=14, exponent=8, softness=0.4}, \
                {position=[-3,1,2], color=[0.2,0.5,0.3], attenuation=\"light\", k=0.5}, {kind=\"directional\", direction=[1,-1,-1], \
                color=[0.3,0.1,0.1]}]";
    let area = "light=[{kind=\"area\", samples=9, attenuation=\"inverse-square\", color=[9,9,9]}]";
    for (name, preset, set) in [
        ("sphere", "sphere", &[][..]),
        ("teapot", "teapot", &[]),
        ("torus", "torus", &["object.segments=48", "object.rings=24"]),
        (
            "pattern",
            "sphere",
            &["pattern={kind=\"rings\", scale=0.4}"],
        ),
        ("spot", "sphere", &[spot, "camera.viewer=infinite"]),
        ("area", "cube", &[area]),
        (
            "gouraud",
            "torus",
            &[
                "shading.mode=gouraud",
                "object.segments=24",
                "object.rings=12",
            ],
        ),
        (
            "flat",
            "torus",
            &[
                "shading={mode=\"flat\", flat_at=\"provoking-vertex\"}",
                "object.segments=24",
                "object.rings=12",
            ],
        ),
        // N is not turned towards the light.
        (
            "flip",
            "plane",
            &[
                "reflection.backfacing=flip",
                "light.0.position=[0.4,0.7,-0.9]",
            ],
        ),
        ("srgb", "colored-lights", &["display.encoding=srgb"]),
    ] {
        for (law, formula) in [("phong", Reflection::PHONG), ("blinn", BLINN)] {
            compare(
                &format!("{name}-{law}"),
                &with_law(small(preset, set), formula),
            );
        }
    }
    // What is negative takes light away, and the distance is in world units, also that of parallel rays.
    let two = small("sphere", &[spot]);
    compare("unclamped", &with_law(two.clone(), "0.5*N·L + 0.1"));
    compare(
        "distance",
        &with_law(two, "od * max(N·L, 0) * (3 / d)^2 + 0.2 * (d > 1e9)"),
    );
}

#[test]
fn an_own_law_has_the_numbers_of_each_material() {
    if !mesa() {
        return;
    }
    let formula = "ka/8 + kd*od*max(N·L, 0)/eta + ks*os*max(R·V, 0)^n + m/9";
    for (mode, set) in [
        ("phong", &[][..]),
        ("gouraud", &["shading.mode=gouraud"]),
        ("pattern", &["pattern={kind=\"rings\", scale=0.4}"]),
    ] {
        let mesh = model_materials::model(ObjectKind::Torus, 24, |face| (face % 7) as u16);
        let scene = with_law(small_model(set), formula);
        compare_glsl(&format!("own-model-{mode}"), &scene, Some(&mesh));
    }
}

#[test]
fn every_operation_is_drawn_the_same() {
    if !mesa() {
        return;
    }
    let sum = [
        "0.2 + 0.5*atan(phi - theta)/90 + acos(N·L)/900 - asin(N·V)/900",
        "0.3*abs(sin(theta)) + 0.3*cos(theta) + 0.02*tan(theta/3) + 0.1*round(N·V*3)",
        "0.1*exp(N·L) - 0.05*log(2 + N·L) + 0.2*sqrt(N·V) + 0.1*floor(4*N·V)/4 - -N.x/9",
        "mix(0.1, 0.9, N·V)*clamp(N·L, 0.1, 0.8) + step(0.3, N·V)/5 + smoothstep(-0.5, 1.5, N·L)/3",
        "sum(N·V, N·L, 0.1)/4 + mean(N·H, V·H)/5 + min(N·L, N·V, 0.3)/3 + max(0.1, R·V)/4",
        "length(cross(N, L))/3 + dot(normalize(N + L/2 - 2*V), V/d)/2 + length(mix(-N, V, N·L))/9",
        // Comparisons times what is 0 where they turn.
        "(N·L > 0)*N·L/3 + (N·V >= 0.5)*(N·V - 0.5)/3 + (N·L < 0.2)*(0.2 - N·L)/9 + (n == n)/9 + (n != n + 1)/9",
        "(N·H <= 0.9)*(0.9 - N·H) + (N·L > 0 and not (N·V < 0.6) or n < m)*max(N·L, 0)*(N·V - 0.6) + pow(N·V, 2.5)/5",
        "0.1*N·L^3 + 0.2*(N·L)^2 + 0.2",
        // Where an operation has no value.
        "0.2 + 1/(n - n) + sqrt(-N·V) + log(-N·V) + (-N·V)^0.5 + acos(2 + N·V) + asin(-3) + 0^(-N·V)",
        "0.2 + smoothstep(1, 1, N·L)/3 + length(normalize(N - N)) + 0^(n - n)/5 + clamp(N·L, 0.3, 0.1)",
        "0.3 + (-N·V)^3/4 + (-N·V)^(n - n + 2)/4 + (-2)^-1/9",
        // Beyond single precision, infinity by infinity.
        "x = step(0.7, N·V)*1e38\n(0.3 + x*x)/(1 + x*x)",
    ];
    for (place, formula) in sum.into_iter().enumerate() {
        compare(
            &format!("operation-{place}"),
            &with_law(small("sphere", &[]), formula),
        );
    }
}

/// Words that mean something in GLSL, or that the shaders have themselves, and that a formula does not know.
const WORDS: &str = "sample input output in out inout uniform varying attribute flat smooth float int bool vec3 mat4 dvec2 sampler2D \
    image2D struct void return if else for while do switch case default break continue discard true false const precise buffer \
    shared resource texture main law reflected illuminate display channel color R1 Ka Kd Ks Os Od Ia Ip P E I eye position normal \
    pixel intensity quotient power logarithm unit rise fract mod sign ceil radians degrees reflect refract distance inversesqrt \
    exp2 log2 isnan any all gl_Position gl_x a__b a_ trailing__ n N L V R H d theta eta light_0 points_0 material towards_viewer \
    active filter common partition this union enum half fixed superp hvec3 namespace using";

#[test]
fn names_may_collide_with_words_of_glsl() {
    if !mesa() {
        return;
    }
    let words: Vec<&str> = WORDS.split_ascii_whitespace().collect();
    for (place, words) in words.chunks(20).enumerate() {
        let line = |(place, word): (usize, &&str)| {
            format!("{word} = {:.3}*max(N·L, 0)\n", 0.004 * (place + 1) as f64)
        };
        let lines: String = words.iter().enumerate().map(line).collect();
        let formula = format!("{lines}{}", words.join(" + "));
        let scene = small("sphere", &["pattern.kind=checker"]);
        compare(&format!("words-{place}"), &with_law(scene, &formula));
    }
}

/// How far Mesa's arc tangents, which are polynomials, may be off, degrees; measured are 0.00015.
const ANGLE: f64 = 0.0005;

/// How far the components of a direction may be off: OpenGL moves the corners of a triangle to 1/256 of a pixel, and here a
/// pixel is as large as a twentieth of the object.
const DIRECTION: f64 = 4e-4;

/// Angles beyond this have no digits left for the part of a turn in single precision, degrees.
const MANY_TURNS: f64 = 1e6;

/// Numbers beyond this are near the end of single precision.
const LARGE: f64 = 1e30;

/// A point of a picture with what its lights send there.
struct Point {
    pixel: usize,
    n: DVec3,
    v: DVec3,
    lights: Vec<(DVec3, f64, DVec3)>,
    od: DVec3,
    ambient: DVec3,
}

/// Returns the points that the pixels of a scene show, but for those at edges.
fn points(scene: &Scene) -> Vec<Point> {
    let mut renderer = Renderer::default();
    let edges = Edges::of(scene, &tessellate(&scene.object));
    let [width, height] = scene.image.size;
    let mut points = vec![];
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let Some(hit) = probe(&mut renderer, scene, x, y).hit else {
            continue;
        };
        if edges.touch(x as usize, y as usize) {
            continue;
        }
        let light = |(light, own): (&Light, &LightTerms)| {
            let d = if light.kind == LightKind::Directional {
                1e12 * scene.camera.distance()
            } else {
                light.position.distance(hit.position)
            };
            (own.l, d, own.attenuation * own.spot * light.color)
        };
        let patterned = scene.pattern.kind != PatternKind::None;
        points.push(Point {
            pixel: (y * width + x) as usize,
            n: hit.normal,
            v: hit.view,
            lights: scene.lights.iter().zip(&hit.lights).map(light).collect(),
            od: if patterned {
                hit.color
            } else {
                scene.material.color
            },
            ambient: hit.ambient,
        });
    }
    points
}

/// A value of a part of a formula.
#[derive(Clone, Copy)]
enum Value {
    Number(f64),
    Vector(DVec3),
}

impl Value {
    fn number(self) -> f64 {
        match self {
            Self::Number(number) => number,
            Self::Vector(_) => f64::NAN,
        }
    }

    fn vector(self) -> DVec3 {
        match self {
            Self::Vector(vector) => vector,
            Self::Number(_) => DVec3::NAN,
        }
    }
}

/// A formula evaluated as it is read, in double precision, with each number that single precision rounds moved a little by chance.
struct Shaken<'a> {
    dice: Option<&'a mut Dice>,
    given: Vec<Value>,
    lines: Vec<Value>,
    /// True if a number was so large that single precision is no matter of rounding.
    beyond: bool,
}

impl Shaken<'_> {
    fn chance(&mut self) -> f64 {
        self.dice
            .as_mut()
            .map_or(0.0, |dice| dice.between(-1.0, 1.0))
    }

    /// Moves a number by up to a millionth of its size, and one that single precision barely has to 0 or not.
    fn number(&mut self, x: f64) -> f64 {
        self.beyond |= x.abs() > LARGE;
        if self.dice.is_some() && x != 0.0 && x.abs() < 1e-30 && self.chance() > 0.0 {
            return 0.0;
        }
        x * (1.0 + 1e-6 * self.chance())
    }

    fn vector(&mut self, v: DVec3) -> DVec3 {
        DVec3::from_array(v.to_array().map(|x| self.number(x)))
    }

    fn angle(&mut self, degrees: f64) -> f64 {
        degrees + ANGLE * self.chance()
    }

    /// The values of [`LAW_NUMBERS`] and of the vectors.
    fn give(&mut self, scene: &Scene, point: &Point, light: usize, channel: usize) {
        let (l, d, _) = point.lights[light];
        let material = &scene.material;
        let mut unit = |v: DVec3| {
            let off = [0; 3].map(|_| DIRECTION * self.chance());
            v + DVec3::from_array(off)
        };
        let [n, l, v] = [point.n, l, point.v].map(&mut unit);
        let (r, h) = (2.0 * n.dot(l) * n - l, (l + v).normalize_or_zero());
        let angle = |cosine: f64| cosine.clamp(-1.0, 1.0).acos().to_degrees();
        let exact = |x: f64| f64::from(x as f32) == x;
        let numbers = LAW_NUMBERS.map(|name| match name {
            "N·L" => n.dot(l),
            "R·V" => r.dot(v),
            "N·H" => n.dot(h),
            "V·H" => v.dot(h),
            "N·V" => n.dot(v),
            "L·V" => l.dot(v),
            "d" => self.number(d),
            "theta" => self.angle(angle(n.dot(l))),
            "phi" => self.angle(angle(r.dot(v))),
            _ => {
                let x = match name {
                    "ka" => material.ka[channel],
                    "kd" => material.kd[channel],
                    "ks" => material.ks[channel],
                    "od" => point.od[channel],
                    "os" => material.specular_color[channel],
                    "m" => material.roughness,
                    "eta" => material.ior[channel],
                    _ => material.n,
                };
                if exact(x) { x } else { self.number(x) }
            }
        });
        let vectors = [n, l, v, r, h].map(Value::Vector);
        self.given = numbers
            .into_iter()
            .map(Value::Number)
            .chain(vectors)
            .collect();
        self.lines.clear();
    }

    /// Returns the value of the last line; 0 where it is not a number.
    fn law(&mut self, formula: &Formula) -> f64 {
        for line in formula.lines() {
            let value = self.value(&line.value);
            self.lines.push(value);
        }
        let value = self.lines.last().map_or(0.0, |value| value.number());
        if value.is_nan() { 0.0 } else { value }
    }

    fn value(&mut self, part: &Typed) -> Value {
        match &part.term {
            Term::Number(x) if f64::from(*x as f32) == *x => Value::Number(*x),
            Term::Number(x) => Value::Number(self.number(*x)),
            Term::Name(index) => self.given[*index],
            Term::Line(line) => self.lines[*line],
            Term::Call(operator, parts) => {
                let values: Vec<Value> = parts.iter().map(|part| self.value(part)).collect();
                match self.vector_of(*operator, &values) {
                    Some(value) => value,
                    None => {
                        let numbers: Vec<f64> = values.iter().map(|value| value.number()).collect();
                        Value::Number(self.number_of(*operator, &numbers))
                    }
                }
            }
        }
    }

    /// Returns the result of an operation on vectors.
    fn vector_of(&mut self, operator: Operator, values: &[Value]) -> Option<Value> {
        use Operator as Op;
        let [a, b] = [0, 1].map(|place| values.get(place).copied().unwrap_or(Value::Number(0.0)));
        let vector = match (operator, a, b) {
            (Op::Dot, ..) => return Some(Value::Number(self.number(a.vector().dot(b.vector())))),
            (Op::Length, ..) => return Some(Value::Number(self.number(a.vector().length()))),
            (Op::Component(axis), ..) => return Some(Value::Number(a.vector()[axis])),
            (Op::Cross, ..) => {
                // A difference of products, each of which is rounded.
                let [a, b] = [a, b].map(Value::vector);
                let [first, second] = [
                    DVec3::new(a.y * b.z, a.z * b.x, a.x * b.y),
                    DVec3::new(a.z * b.y, a.x * b.z, a.y * b.x),
                ];
                self.vector(first) - self.vector(second)
            }
            (Op::Normalize, ..) => {
                let square = a.vector().length_squared();
                self.beyond |= square > 0.0 && square < 1e-30;
                a.vector() / square.max(1e-36).sqrt()
            }
            (Op::Add, Value::Vector(a), Value::Vector(b)) => a + b,
            (Op::Subtract, Value::Vector(a), Value::Vector(b)) => a - b,
            (Op::Negate, Value::Vector(a), _) => -a,
            (Op::Multiply, Value::Vector(a), b) => a * b.number(),
            (Op::Multiply, a, Value::Vector(b)) => b * a.number(),
            (Op::Divide, Value::Vector(a), b) if b.number() == 0.0 => a * 0.0,
            (Op::Divide, Value::Vector(a), b) => a / b.number(),
            (Op::Mix, Value::Vector(a), Value::Vector(b)) => {
                let t = values[2].number();
                self.vector(a * (1.0 - t)) + self.vector(b * t)
            }
            _ => return None,
        };
        Some(Value::Vector(self.vector(vector)))
    }

    fn number_of(&mut self, operator: Operator, all: &[f64]) -> f64 {
        use Operator as Op;
        let [a, b, c] = [0, 1, 2].map(|place| all.get(place).copied().unwrap_or(0.0));
        let truth = |holds: bool| if holds { 1.0 } else { 0.0 };
        let exact = match operator {
            Op::Negate => -a,
            Op::Abs => a.abs(),
            Op::Min => all.iter().copied().fold(f64::INFINITY, f64::min),
            Op::Max => all.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            Op::Clamp => a.max(b).min(c),
            Op::Floor => a.floor(),
            Op::Round => (a + 0.5).floor(),
            Op::Step => truth(b >= a),
            Op::Less => truth(a < b),
            Op::LessEqual => truth(a <= b),
            Op::Greater => truth(a > b),
            Op::GreaterEqual => truth(a >= b),
            Op::Equal | Op::NotEqual => {
                // Numbers that rounding may make equal or unequal.
                let close = a != b && (a - b).abs() <= 1e-5 * a.abs().max(b.abs());
                let equal = if close { self.chance() > 0.0 } else { a == b };
                truth(equal == (operator == Op::Equal))
            }
            Op::And => a * b,
            Op::Or => a.max(b),
            Op::Not => 1.0 - a,
            _ => return self.rounded(operator, all),
        };
        self.beyond |= exact.abs() > LARGE;
        exact
    }

    /// Returns the result of an operation that single precision rounds.
    fn rounded(&mut self, operator: Operator, all: &[f64]) -> f64 {
        use Operator as Op;
        let [a, b, c] = [0, 1, 2].map(|place| all.get(place).copied().unwrap_or(0.0));
        let quotient = |a: f64, b: f64| if b == 0.0 { 0.0 } else { a / b };
        let sine = |degrees: f64| degrees.to_radians().sin();
        let has_angle = a.abs() <= 1.0 + 1e-6;
        let of_angle = matches!(operator, Op::Sin | Op::Cos | Op::Tan);
        self.beyond |= of_angle && a.abs() > MANY_TURNS;
        let limited = a.clamp(-1.0, 1.0);
        let result = match operator {
            Op::Add => a + b,
            Op::Subtract => a - b,
            Op::Multiply => a * b,
            Op::Divide => quotient(a, b),
            Op::Sum => all.iter().sum(),
            Op::Mean => all.iter().sum::<f64>() / all.len() as f64,
            Op::Sqrt => a.max(0.0).sqrt(),
            Op::Exp => a.exp(),
            Op::Log if a > 0.0 => a.ln() + 1e-6 * self.chance(),
            Op::Power if b == 0.0 => 1.0,
            Op::Power if a == 0.0 => 0.0,
            Op::Power => match a.powf(b) {
                power if power.is_nan() => 0.0,
                power => power,
            },
            // Sines are as exact as the angle in single precision is, of which whole turns are taken.
            Op::Sin => sine(a) + 1e-6 * self.chance(),
            Op::Cos => sine(a + 90.0) + 1e-6 * self.chance(),
            Op::Tan => a.to_radians().tan(),
            Op::Asin if has_angle => return self.angle(limited.asin().to_degrees()),
            Op::Acos if has_angle => return self.angle(limited.acos().to_degrees()),
            Op::Log | Op::Asin | Op::Acos => 0.0,
            Op::Atan => return self.angle(a.atan().to_degrees()),
            Op::Mix => self.number(a * (1.0 - c)) + self.number(b * c),
            Op::Smoothstep => {
                let (way, length) = (self.number(c - a), self.number(b - a));
                let t = quotient(way, length).clamp(0.0, 1.0);
                t * t * (3.0 - 2.0 * t)
            }
            other => panic!("{other:?} is unknown"),
        };
        self.number(result)
    }
}

/// Returns the code values that a pixel of this point may have, the least and the greatest of each channel; none where a number
/// leaves single precision.
fn range(
    scene: &Scene,
    formula: &Formula,
    point: &Point,
    dice: &mut Dice,
) -> Option<[[f64; 2]; 3]> {
    let mut all = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for sample in 0..24 {
        let mut shaken = Shaken {
            dice: (sample > 0).then_some(&mut *dice),
            given: vec![],
            lines: vec![],
            beyond: false,
        };
        for (channel, [least, most]) in all.iter_mut().enumerate() {
            let mut sum = point.ambient[channel];
            for (light, (_, _, strength)) in point.lights.iter().enumerate() {
                shaken.give(scene, point, light, channel);
                sum += shaken.law(formula) * strength[channel];
            }
            let code = 255.0 * sum.clamp(0.0, 1.0);
            (*least, *most) = (least.min(code), most.max(code));
        }
        if shaken.beyond {
            return None;
        }
    }
    Some(all)
}

#[test]
fn random_laws_are_drawn_the_same() {
    if !mesa() {
        return;
    }
    let lights = "light=[{position=[1,2,3], color=[0.5,0.6,0.7]}, {kind=\"spot\", position=[-2,1,3], direction=[2,-1,-3], cone=30, \
                  color=[0.4,0.3,0.2]}]";
    let rays = "light=[{kind=\"directional\", direction=[-1,-2,-1], color=[0.9,0.8,0.7]}]";
    let material = "material={ka=0.1, kd=0.7, ks=0.4, n=12, color=[0.9,0.5,0.25], roughness=0.3}";
    let scenes = [
        ("sphere", &[material][..]),
        ("torus", &[material, lights]),
        ("sphere", &[material, rays, "pattern.kind=checker"]),
    ];
    let scenes = scenes.map(|(name, set)| {
        let mut scene = small(name, set);
        scene.image.size = [36, 32];
        let points = points(&scene);
        assert!(points.len() > 200, "{name}: {}", points.len());
        (scene, points)
    });
    let (mut dice, mut wrong) = (Dice(11), vec![]);
    let (mut compared, mut all, mut varied) = (0, 0, 0u64);
    let tries = tries(200);
    for place in 0..tries as usize {
        let mut text = any_formula(&mut dice);
        if place % 3 != 0 {
            // Every number becomes one that the picture can show.
            let begins = text.rfind(['\n', ';']).map_or(0, |end| end + 1);
            text = format!("{}0.5 + atan({})/200", &text[..begins], &text[begins..]);
        }
        let (scene, points) = &scenes[place % scenes.len()];
        let scene = with_law(scene.clone(), &text);
        let formula = scene.reflection.law().expect("a law");
        let mut renderer = Renderer::default();
        let ours = renderer.render(&scene).clone();
        let theirs = draw_glsl(&format!("random-{place}"), &scene, &ours);
        let (mut least, mut greatest) = ([255; 3], [0; 3]);
        all += points.len();
        for point in points {
            let Some(range) = range(&scene, &formula, point, &mut dice) else {
                continue;
            };
            let stored = [0, 1, 2].map(|channel| ours.pixels[point.pixel][channel]);
            let theirs = theirs[point.pixel];
            for (channel, [low, high]) in range.into_iter().enumerate() {
                if high - low > 1.0 / 3.0 {
                    continue;
                }
                let [a, b] = [stored[channel], theirs[channel]];
                let off = (f64::from(a) - low).abs().max((f64::from(b) - low).abs());
                if a.abs_diff(b) > 1 || off > 1.0 {
                    wrong.push(format!(
                        "{place}: {a} {b} {low:.2} at {} {channel}\n{text}",
                        point.pixel
                    ));
                }
                compared += 1;
                least[channel] = least[channel].min(a);
                greatest[channel] = greatest[channel].max(a);
            }
        }
        varied += u64::from((0..3).any(|channel| least[channel] < greatest[channel]));
    }
    eprintln!(
        "{compared} of {} values compared, {varied} formulas vary",
        3 * all
    );
    assert!(
        wrong.is_empty(),
        "{} values, {}",
        wrong.len(),
        wrong[..wrong.len().min(20)].join("\n")
    );
    assert!(
        compared * 10 > 3 * all * 6 && varied > tries / 2,
        "{compared} of {}, {varied}",
        3 * all
    );
}
