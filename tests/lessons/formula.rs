//! Questions answered by a formula: every spelling of the right function is right, a near miss is wrong with a counterexample
//! that other code confirms, and the formulas of a class are sorted by their meaning.

mod class;
mod faults;

use shading_lab::analysis::probe::probe;
use shading_lab::lesson::{
    Answer, AnswerKey, Formula, Grade, Hint, Kind, Lab, Lesson, Question, Solution, Staged,
};
use shading_lab::render::Renderer;
use shading_lab::scene::{LightKind, Rgb, Scene, presets};

/// A question with its scene.
struct SolvedQuestion {
    staged: Staged,
    question: Question,
    key: AnswerKey,
}

impl SolvedQuestion {
    fn new(keys: &str) -> Self {
        let source = lesson(keys);
        let lesson =
            Lesson::read(&source, None).unwrap_or_else(|error| panic!("{error}\n{source}"));
        Self::of(&lesson, 0)
    }

    fn of(lesson: &Lesson, step: usize) -> Self {
        let step = &lesson.steps[step];
        let staged = step.stage.load(None).expect("a scene");
        let question = step.question.clone().expect("a question");
        let key = question.solve_all(Lab::new(&staged).place(&staged), 1);
        Self {
            key: key.unwrap_or_else(|why| panic!("{}: {why}", step.title)),
            staged,
            question,
        }
    }

    fn kind(&self) -> &Formula {
        match &self.question.kind {
            Kind::Formula(formula) => formula,
            other => panic!("{other:?}"),
        }
    }

    fn right(&self) -> &str {
        match &self.key.right {
            Solution::Formula(right) => right,
            other => panic!("{other:?}"),
        }
    }

    /// Grades an answer; none of one that cannot be read.
    fn grade(&self, text: &str) -> Option<Grade> {
        let answer = Answer::Formula(text.to_owned());
        let lab = Lab::new(&self.staged);
        self.question
            .grade(&answer, &self.key, lab.place(&self.staged))
    }

    fn is_right(&self, text: &str) -> bool {
        let grade = self.grade(text);
        grade
            .unwrap_or_else(|| panic!("{text:?}: {:?}", self.kind().function(text)))
            .right
    }

    /// Returns the counterexample of a wrong answer: the values of the names, what the answer gives, and what is expected.
    fn counterexample(&self, text: &str) -> (Vec<f64>, Option<f64>, Option<f64>) {
        let grade = self.grade(text).expect("a formula");
        assert!(!grade.right && grade.score == 0.0, "{text} counts as right");
        let Some(Hint::Formula {
            point,
            given,
            expected,
        }) = grade.hint
        else {
            panic!("{text}: {grade:?}");
        };
        let point = self.kind().point(point).expect("a point");
        let values = point.iter().map(|value| value.components()[0]).collect();
        (values, given.map(|[x, ..]| x), expected.map(|[x, ..]| x))
    }

    fn feedback(&self, text: &str) -> String {
        let grade = self.grade(text).expect("a formula");
        let lab = Lab::new(&self.staged);
        let says = self.question.says().into_iter();
        let says: Vec<String> = says
            .map(|says| says.filled(&lab.place(&self.staged)).expect("a text"))
            .collect();
        self.question
            .feedback(&grade, &says, &[])
            .unwrap_or_default()
    }
}

/// Returns a lesson with one question.
fn lesson(keys: &str) -> String {
    format!(
        "+++\nlesson = 1\nname = \"a\"\ntitle = \"A\"\n+++\n## A\n```step\nscene = \"sphere\"\nset = [\"image.size=[64,64]\", \"material.color=[1,1,1]\"]\n```\n\
         ```question\nkind = \"formula\"\nask = \"?\"\n{keys}\n```\n"
    )
}

const DIFFUSE: &str = "names = [\"kd\", \"ip\", \"N·L\"]\nterm = \"diffuse\"";
const SPECULAR: &str = "names = [\"ks\", \"ip\", \"R·V\", \"n\"]\nterm = \"specular\"";
const MEAN: &str = "names = [\"alpha\", \"I1\", \"I2\"]\nanswer = \"(1 - alpha)*I1 + alpha*I2\"";
const SNELL: &str =
    "names = [{ \"N·V\" = [0, 1] }, \"eta\"]\nanswer = \"sqrt(1 - (1 - N·V^2)/eta^2)\"";
const MIRROR: &str = "names = [\"N\", \"L\"]\nanswer = \"2*(N·L)*N - L\"";

/// Returns every order of three factors.
fn orders([a, b, c]: [&str; 3]) -> Vec<String> {
    [
        [a, b, c],
        [a, c, b],
        [b, a, c],
        [b, c, a],
        [c, a, b],
        [c, b, a],
    ]
    .map(|factors| factors.join(" * "))
    .to_vec()
}

#[test]
fn every_spelling_of_the_right_function_is_right() {
    let cosines = [
        "max(N·L, 0)",
        "max(0, L·N)",
        "max(NL, 0)",
        "max(dot(N, L), 0)",
        "clamp(N·L, 0, 1)",
        "(N·L + abs(N·L))/2",
        "N·L * (N·L > 0)",
        "step(0, N·L) * N·L",
        "-min(-N·L, 0)",
        "sqrt(max(N·L, 0)^2)",
    ];
    let diffuse = cosines
        .iter()
        .flat_map(|cosine| orders(["kd", "ip", cosine]));
    let mut diffuse: Vec<String> = diffuse.collect();
    diffuse.extend(
        [
            "Kd*Ip*max(N·L,0)",
            "K_d × I_p × max(N⋅L, 0.0)",
            "c = max(N·L, 0)\nkd * ip * c",
            "c = N·L; kd*ip*max(c, 0)",
            "kd * max(ip * N·L, 0)",
            "max(kd*ip*N·L, 0)",
            "kd * ip * cos(min(acos(N·L), 90))",
            "ip * (kd * max(0, N·L)) + 0",
            "kd*ip*max(N·L, 0) // Lambert",
        ]
        .map(str::to_owned),
    );
    assert!(diffuse.len() >= 50);
    let cosines = [
        "max(R·V, 0)",
        "max(0, V·R)",
        "clamp(RV, 0, 1)",
        "((R·V + abs(R·V))/2)",
    ];
    let powers = cosines.iter().flat_map(|cosine| {
        [
            format!("{cosine}^n"),
            format!("({cosine})**n"),
            format!("pow({cosine}, n)"),
            format!("{cosine} * ({cosine})^(n - 1)"),
            format!("(({cosine})^2)^(n/2)"),
            format!("exp(n*log({cosine}))"),
        ]
    });
    // A name of its own keeps the precedence of its parts.
    let specular = powers.flat_map(|power| {
        [
            format!("p = {power}; ks*ip*p"),
            format!("p = {power}\nip * p * ks"),
        ]
    });
    let mut specular: Vec<String> = specular.collect();
    specular
        .extend(["ks*ip*max(R·V,0)^n", "ks * ip * cos(min(acos(R·V), 90))^n"].map(str::to_owned));
    let mean = [
        "(1-α)·I1 + α·I2",
        "I1 + alpha*(I2 - I1)",
        "mix(I1, I2, alpha)",
        "I1 - I1*alpha + I2*alpha",
        "I2 + (1 - alpha)*(I1 - I2)",
        "mean((1-alpha)*I1, alpha*I2)*2",
        "sum(I1, alpha*I2, -alpha*I1)",
        "a = 1 - alpha; a*I1 + alpha*I2",
        "I₁ + α·(I₂ − I₁)",
        "-(alpha - 1)*I1 - (-alpha)*I2",
    ];
    let snell = [
        "sqrt(1 - (1 - (N·V)^2)/eta^2)",
        "(1 - (1 - N·V²)/η²)^0.5",
        "√(η^2 − 1 + (N·V)^2)/η",
        "cos(asin(sin(acos(N·V))/eta))",
        "s = sqrt(1 - N·V^2)/eta; sqrt(1 - s*s)",
        "sqrt((1 - sqrt(1 - N·V^2)/eta)*(1 + sqrt(1 - N·V^2)/eta))",
    ];
    let mirror = [
        "2*N·L*N - L",
        "2*N*(N·L) - L",
        "-L + N*dot(L, N)*2",
        "s = (N·L)*N - L; (N·L)*N + s",
        "2*(L·N)*N − L",
        "N*(2*N·L) - L",
        "-(L - 2*dot(N,L)*N)",
    ];
    let short = |all: &[&str]| {
        all.iter()
            .map(|text| (*text).to_owned())
            .collect::<Vec<_>>()
    };
    let mut count = 0;
    for (keys, spellings) in [
        (DIFFUSE, diffuse),
        (SPECULAR, specular),
        (MEAN, short(&mean)),
        (SNELL, short(&snell)),
        (MIRROR, short(&mirror)),
    ] {
        let asked = SolvedQuestion::new(keys);
        for text in &spellings {
            assert!(asked.is_right(text), "{text}: {}", asked.feedback(text));
        }
        count += spellings.len();
    }
    assert!(count >= 130, "{count}");
}

/// A formula that is nearly right, and what it computes, written once more.
type Miss = (&'static str, fn(&[f64]) -> f64);

fn lambert(x: &[f64]) -> f64 {
    x[0] * x[1] * x[2].max(0.0)
}

const DIFFUSE_MISSES: [Miss; 20] = [
    ("kd * ip * N·L", |x| x[0] * x[1] * x[2]),
    ("kd * ip * abs(N·L)", |x| x[0] * x[1] * x[2].abs()),
    ("kd * max(N·L, 0)", |x| x[0] * x[2].max(0.0)),
    ("ip * max(N·L, 0)", |x| x[1] * x[2].max(0.0)),
    ("kd * ip * max(N·L, 0.001)", |x| {
        x[0] * x[1] * x[2].max(0.001)
    }),
    ("kd * ip * max(N·L, 0)^1.001", |x| {
        x[0] * x[1] * x[2].max(0.0).powf(1.001)
    }),
    ("kd + ip * max(N·L, 0)", |x| x[0] + x[1] * x[2].max(0.0)),
    ("(kd + ip) * max(N·L, 0)", |x| {
        (x[0] + x[1]) * x[2].max(0.0)
    }),
    ("kd * ip * (N·L)^2", |x| x[0] * x[1] * x[2] * x[2]),
    ("kd * ip * max(N·L, 0) + 0.0001", |x| lambert(x) + 0.0001),
    ("0.9999 * kd * ip * max(N·L, 0)", |x| 0.9999 * lambert(x)),
    ("kd * ip * min(N·L, 0)", |x| x[0] * x[1] * x[2].min(0.0)),
    ("kd * ip * step(0, N·L)", |x| {
        x[0] * x[1] * f64::from(u8::from(x[2] >= 0.0))
    }),
    ("kd * ip * smoothstep(0, 1, N·L)", |x| {
        let t = x[2].clamp(0.0, 1.0);
        x[0] * x[1] * t * t * (3.0 - 2.0 * t)
    }),
    ("kd * ip * (1 + N·L)/2", |x| {
        x[0] * x[1] * (1.0 + x[2]) / 2.0
    }),
    ("kd * ip * sin(max(N·L, 0)*90)", |x| {
        x[0] * x[1] * (x[2].max(0.0) * 90.0).to_radians().sin()
    }),
    ("kd * ip^2 * max(N·L, 0)", |x| {
        x[0] * x[1] * x[1] * x[2].max(0.0)
    }),
    ("kd * max(ip - N·L, 0)", |x| x[0] * (x[1] - x[2]).max(0.0)),
    ("-kd * ip * max(N·L, 0)", |x| -lambert(x)),
    ("kd * ip * floor(1 + N·L)", |x| {
        x[0] * x[1] * (1.0 + x[2]).floor()
    }),
];

const SPECULAR_MISSES: [Miss; 17] = [
    ("ks*ip*max(R·V, 0)^(n + 1)", |x| {
        x[0] * x[1] * x[2].max(0.0).powf(x[3] + 1.0)
    }),
    ("ks*ip*max(R·V, 0)^(1.01*n)", |x| {
        x[0] * x[1] * x[2].max(0.0).powf(1.01 * x[3])
    }),
    ("ks*ip*n*max(R·V, 0)", |x| {
        x[0] * x[1] * x[3] * x[2].max(0.0)
    }),
    ("(ks*ip*max(R·V, 0))^n", |x| {
        (x[0] * x[1] * x[2].max(0.0)).powf(x[3])
    }),
    ("(ks*max(R·V, 0))^n*ip", |x| {
        (x[0] * x[2].max(0.0)).powf(x[3]) * x[1]
    }),
    ("ks*ip*abs(R·V)^n", |x| x[0] * x[1] * x[2].abs().powf(x[3])),
    ("ks*max(R·V, 0)^n", |x| x[0] * x[2].max(0.0).powf(x[3])),
    ("ks*ip*max(R·V, 0)^(n/2)", |x| {
        x[0] * x[1] * x[2].max(0.0).powf(x[3] / 2.0)
    }),
    ("ks*ip*max(R·V, 0)/n", |x| {
        x[0] * x[1] * x[2].max(0.0) / x[3]
    }),
    ("ks*ip*(max(R·V, 0)^n + max(-R·V, 0)^n)", |x| {
        x[0] * x[1] * (x[2].max(0.0).powf(x[3]) + (-x[2]).max(0.0).powf(x[3]))
    }),
    (
        "ks*ip*max(R·V, 0)/(n - n*max(R·V, 0) + max(R·V, 0))",
        |x| {
            let t = x[2].max(0.0);
            x[0] * x[1] * t / (x[3] - x[3] * t + t)
        },
    ),
    ("ks*ip*max(R·V, 0)^n + 0.001*(R·V < -0.99)", |x| {
        x[0] * x[1] * x[2].max(0.0).powf(x[3]) + 0.001 * f64::from(u8::from(x[2] < -0.99))
    }),
    ("ks*ip*max(R·V, 0.5)^n", |x| {
        x[0] * x[1] * x[2].max(0.5).powf(x[3])
    }),
    ("ks*ip*exp(-n*(1 - R·V))", |x| {
        x[0] * x[1] * (-x[3] * (1.0 - x[2])).exp()
    }),
    ("ks*ip*2^(-n)", |x| x[0] * x[1] * 2f64.powf(-x[3])),
    ("ks*ip^n*max(R·V, 0)^n", |x| {
        x[0] * x[1].powf(x[3]) * x[2].max(0.0).powf(x[3])
    }),
    ("min(ks, ip)*max(R·V, 0)^n", |x| {
        x[0].min(x[1]) * x[2].max(0.0).powf(x[3])
    }),
];

const MEAN_MISSES: [Miss; 14] = [
    ("alpha*I1 + (1 - alpha)*I2", |x| {
        x[0] * x[1] + (1.0 - x[0]) * x[2]
    }),
    ("(I1 + I2)/2", |x| (x[1] + x[2]) / 2.0),
    ("I1 + alpha*I2", |x| x[1] + x[0] * x[2]),
    ("I1 - alpha*(I2 - I1)", |x| x[1] - x[0] * (x[2] - x[1])),
    ("1 - alpha*I1 + alpha*I2", |x| {
        1.0 - x[0] * x[1] + x[0] * x[2]
    }),
    ("(1 - alpha)*(I1 + I2)", |x| (1.0 - x[0]) * (x[1] + x[2])),
    ("sqrt((1 - alpha)*I1^2 + alpha*I2^2)", |x| {
        ((1.0 - x[0]) * x[1] * x[1] + x[0] * x[2] * x[2]).sqrt()
    }),
    ("I1^(1 - alpha) * I2^alpha", |x| {
        x[1].powf(1.0 - x[0]) * x[2].powf(x[0])
    }),
    ("mix(I1, I2, alpha^2)", |x| {
        x[1] + (x[2] - x[1]) * x[0] * x[0]
    }),
    ("mix(I1, I2, smoothstep(0, 1, alpha))", |x| {
        x[1] + (x[2] - x[1]) * x[0] * x[0] * (3.0 - 2.0 * x[0])
    }),
    ("max((1 - alpha)*I1, alpha*I2)", |x| {
        ((1.0 - x[0]) * x[1]).max(x[0] * x[2])
    }),
    ("mix(I1, I2, floor(alpha + 0.5))", |x| {
        if x[0] >= 0.5 { x[2] } else { x[1] }
    }),
    (
        "(1 - alpha)*I1 + alpha*I2 + alpha*(1 - alpha)*0.0001",
        |x| (1.0 - x[0]) * x[1] + x[0] * x[2] + x[0] * (1.0 - x[0]) * 0.0001,
    ),
    ("(1 - alpha)*I1 + alpha*I2*0.99999", |x| {
        (1.0 - x[0]) * x[1] + x[0] * x[2] * 0.99999
    }),
];

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs()).max(1.0)
}

/// Reads the numbers after `=`, `gives` and `is` of a counterexample in English.
fn numbers(sentence: &str) -> Vec<f64> {
    let plain = sentence.replace('−', "-").replace("·10⁻", "e-");
    let superscripts = ["⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"];
    let plain = superscripts
        .iter()
        .enumerate()
        .fold(plain, |text, (digit, sign)| {
            text.replace(sign, &digit.to_string())
        });
    let after = |start: &str| {
        plain
            .match_indices(start)
            .map(|(at, _)| at + start.len())
            .collect::<Vec<_>>()
    };
    let starts = [after(" = "), after("gives "), after("expected is ")].concat();
    let read = |at: usize| {
        let end = plain[at..].find(|c: char| !"0123456789.e-".contains(c));
        let text = &plain[at..end.map_or(plain.len(), |end| at + end)];
        text.trim_end_matches('.')
            .parse::<f64>()
            .unwrap_or(f64::NAN)
    };
    starts.into_iter().map(read).collect()
}

#[test]
fn a_near_miss_is_wrong_with_a_true_counterexample() {
    let right: [fn(&[f64]) -> f64; 3] = [
        lambert,
        |x| x[0] * x[1] * x[2].max(0.0).powf(x[3]),
        |x| (1.0 - x[0]) * x[1] + x[0] * x[2],
    ];
    let questions = [
        (DIFFUSE, &DIFFUSE_MISSES[..]),
        (SPECULAR, &SPECULAR_MISSES[..]),
        (MEAN, &MEAN_MISSES[..]),
    ];
    let mut count = 0;
    for ((keys, misses), right) in questions.into_iter().zip(right) {
        let asked = SolvedQuestion::new(keys);
        for (text, miss) in misses {
            let (values, given, expected) = asked.counterexample(text);
            let (given, expected) = (given.expect("a value"), expected.expect("a value"));
            assert!(close(given, miss(&values)), "{text} at {values:?}: {given}");
            assert!(
                close(expected, right(&values)),
                "{text} at {values:?}: {expected}"
            );
            assert!(
                (given - expected).abs() > 1e-6,
                "{text}: {given}, {expected}"
            );
            // The sentence has the same numbers, as far as it has digits.
            let sentence = asked.feedback(text);
            let told = numbers(&sentence);
            let (names, results) = told.split_at(values.len());
            assert_eq!(names, values, "{sentence}");
            for (told, known) in results.iter().zip([given, expected]) {
                assert!(
                    (told - known).abs() <= 0.01 * known.abs() + 1e-12,
                    "{sentence}"
                );
            }
            assert_ne!(results[0], results[1], "{sentence}");
            count += 1;
        }
    }
    assert!(count >= 50, "{count}");
}

/// Returns the diffuse term that the probe of a plane measures.
fn probed(kd: f64, ip: f64, n_dot_l: f64) -> f64 {
    let mut scene: Scene = presets::find("plane").expect("a scene").scene();
    scene.lights.truncate(1);
    scene.camera.eye = glam::DVec3::new(0.0, 0.0, 4.0);
    scene.material.kd = Rgb::splat(kd);
    scene.material.color = Rgb::ONE;
    let light = &mut scene.lights[0];
    light.kind = LightKind::Directional;
    light.color = Rgb::splat(ip);
    light.direction = -glam::DVec3::new((1.0 - n_dot_l * n_dot_l).sqrt(), 0.0, n_dot_l);
    let mut renderer = Renderer::default();
    renderer.render(&scene);
    let [width, height] = scene.image.size;
    let probed = probe(&mut renderer, &scene, width / 2, height / 2);
    probed.hit.expect("the plane").lights[0].diffuse.to_array()[0]
}

#[test]
fn the_probe_confirms_the_counterexamples_of_a_term_of_the_engine() {
    let asked = SolvedQuestion::new(DIFFUSE);
    for (text, _) in &DIFFUSE_MISSES {
        let (values, _, expected) = asked.counterexample(text);
        let probed = probed(values[0], values[1], values[2]);
        let expected = expected.expect("a value");
        assert!(
            (probed - expected).abs() < 1e-6,
            "{text} at {values:?}: {probed}, {expected}"
        );
    }
}

#[test]
fn the_engines_terms_are_asked_for_in_the_scenes_own_form() {
    let term = |keys: &str, settings: &str| {
        let source = lesson(keys).replace("\"image.size", &format!("{settings}\"image.size"));
        let lesson = Lesson::read(&source, None).expect("a lesson");
        SolvedQuestion::of(&lesson, 0).right().to_owned()
    };
    assert_eq!(term(DIFFUSE, ""), "kd * ip * max(N·L, 0)");
    assert_eq!(
        term(DIFFUSE, "\"reflection.backfacing=flip\", "),
        "kd * ip * abs(N·L)"
    );
    assert_eq!(term(SPECULAR, ""), "ks * ip * max(R·V, 0)^n");
    let blinn = SPECULAR.replace("R·V", "N·H");
    assert_eq!(
        term(&blinn, "\"reflection.model=blinn\", "),
        "ks * ip * max(N·H, 0)^n"
    );
    let gated = SPECULAR.replace("\"n\"", "\"n\", \"N·L\"");
    assert_eq!(term(&gated, ""), "(N·L > 0) * ks * ip * max(R·V, 0)^n");
    let ambient = "names = [\"ka\", \"od\", \"ia\"]\nterm = \"ambient\"";
    assert_eq!(term(ambient, ""), "ka * od * ia");
    let attenuation = "names = [\"c1\", \"c2\", \"c3\", \"d\"]\nterm = \"attenuation\"";
    assert_eq!(term(attenuation, ""), "min(1, 1/(c1 + c2*d + c3*d^2))");
}

#[test]
fn a_gap_that_its_neighbours_fill_is_no_difference() {
    let asked =
        SolvedQuestion::new("names = [{ x = [-1, 1] }, { y = [-1, 1] }]\nanswer = \"x + y\"");
    for text in [
        "(x^2 - y^2)/(x - y) + 0*x",
        "x*x/x + y",
        "x*y/y + y",
        "x*sin(x)/sin(x) + y",
    ] {
        assert!(asked.is_right(text), "{text}: {}", asked.feedback(text));
    }
    for text in [
        "x + y + 0*sqrt(x)",
        "x + y + 0*log(abs(y) - 0.5)",
        "x + y + 0/floor(x)",
        "(x + y)/(x > 0)",
    ] {
        let (values, given, expected) = asked.counterexample(text);
        assert_eq!(given, None, "{text} at {values:?}");
        assert!(close(expected.expect("a value"), values[0] + values[1]));
        assert!(asked.feedback(text).contains("no value"));
    }
}

#[test]
fn points_without_a_right_value_do_not_count() {
    let asked = SolvedQuestion::new("names = [{ x = [-1, 2] }]\nanswer = \"sqrt(x)\"");
    for right in ["x^0.5", "sqrt(abs(x))", "sqrt(max(x, 0))", "x/sqrt(x)"] {
        assert!(asked.is_right(right), "{right}");
    }
    assert!(!asked.is_right("sqrt(-x)"));
    assert!(!asked.is_right("sqrt(x + 0.001)"));
}

#[test]
fn rounding_and_typed_constants_are_no_difference() {
    let asked = SolvedQuestion::new(
        "names = [\"theta\", { d = [100, 1000] }]\nanswer = \"pi*sin(theta)/d^2\"",
    );
    assert!(asked.is_right("3.1415927*sin(theta)/d/d"));
    assert!(asked.is_right("pi/d^2*cos(90 - theta)"));
    // As small as the values are, their differences count.
    assert!(!asked.is_right("3.1415*sin(theta)/d^2"));
    assert!(!asked.is_right("pi*sin(theta)/d^2 + 0.0000001"));
}

#[test]
fn vectors_are_asked_for_in_vectors() {
    let asked = SolvedQuestion::new(MIRROR);
    let refused = |text: &str| asked.kind().function(text).expect_err("refused").message;
    assert_eq!(refused("N·L"), english!("lesson-formula-vector-expected"));
    let feedback = asked.feedback("(N·L)*N - L");
    assert!(feedback.starts_with("With $N$ = ("), "{feedback}");
    let number = SolvedQuestion::new(
        DIFFUSE
            .replace("\"N·L\"", "\"N\", \"L\"")
            .replace("term = \"diffuse\"", "answer = \"kd*ip*max(N·L, 0)\"")
            .as_str(),
    );
    let refused = number.kind().function("kd*ip*N").expect_err("refused");
    assert_eq!(refused.message, english!("lesson-formula-number-expected"));
    assert_eq!((refused.position.line, refused.position.column), (1, 8));
}

/// Returns a number below `most` from a sequence.
fn below(state: &mut u64, most: usize) -> usize {
    *state = state
        .wrapping_mul(0x5851_f42d_4c95_7f2d)
        .wrapping_add(0x1405_7b7e_f767_814f);
    (*state >> 33) as usize % most
}

#[test]
fn whatever_is_typed_is_graded_or_refused() {
    const PIECES: [&str; 34] = [
        "kd", "ip", "N·L", "N", "L", "(", ")", "(", ")", "*", "/", "+", "-", "^", "²", ",", "max(",
        "sqrt(", "0", "1", "1e999", "0.5", "=", ";", "\n", "#", "≤", "and", "not ", "x = ", "·",
        "kd.x", "王", "\u{202e}",
    ];
    let asked = SolvedQuestion::new(DIFFUSE);
    let (mut state, mut read) = (7, 0);
    for _ in 0..4000 {
        let length = 1 + below(&mut state, 9);
        let text: String = (0..length)
            .map(|_| PIECES[below(&mut state, PIECES.len())])
            .collect();
        let answer = Answer::Formula(text.clone());
        let grade = asked.grade(&text);
        assert_eq!(grade.is_some(), answer.fits(&asked.question.kind), "{text}");
        if grade.is_some() {
            read += 1;
            let _ = asked.feedback(&text);
        }
        let _ = asked.question.kind.words(&answer, &[]);
    }
    assert!(read > 100, "{read}");
    // The longest formula that may be handed in, and one character more.
    let long = format!("kd{}", " ".repeat(Formula::MOST_CHARACTERS - 2));
    assert!(Answer::Formula(long.clone()).fits(&asked.question.kind));
    assert!(!Answer::Formula(long + " ").fits(&asked.question.kind));
    let deep = format!("{}kd{}", "(".repeat(990), ")".repeat(990));
    assert!(!Answer::Formula(deep).fits(&asked.question.kind));
}

#[test]
fn errors_say_where_and_what_was_meant() {
    let asked = SolvedQuestion::new(DIFFUSE);
    let error = |text: &str| asked.kind().function(text).expect_err("refused");
    let unknown = error("kd * jp * N·L");
    assert_eq!((unknown.position.line, unknown.position.column), (1, 6));
    assert!(unknown.message.contains("ip"), "{}", unknown.message);
    let open = error("kd * max(N·L, 0");
    assert_eq!(open.position.column, 16);
    assert!(open.message.contains(')'), "{}", open.message);
    assert!(asked.grade("kd * jp").is_none(), "an error is no answer");
}
