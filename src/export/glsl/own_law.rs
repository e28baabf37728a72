//! The scene's own law as a function in GLSL, line by line as its author wrote it.
//!
//! A formula is written for one channel, as the scene has it: numbers of the material have a component for each, and `law` is called
//! three times. Comparisons are `bool`s, which become 1 and 0 where a number is expected. Where an operation of GLSL has no value
//! for operands for which the program has one, a function of a few lines stands for it.

use crate::export::text::{ascii, filled, float};
use crate::expression::{Formula, Operator, Term, Type, Typed};
use crate::scene::{LAW_NUMBERS, LAW_VECTORS, Scene};
use std::collections::BTreeSet;

/// Functions that a law may call, each after those that it calls itself.
const FUNCTIONS: [(&str, &str); 7] = [
    ("quotient", include_str!("own_law/quotient.glsl")),
    ("power", include_str!("own_law/power.glsl")),
    ("logarithm", include_str!("own_law/logarithm.glsl")),
    ("angle_of_sine", include_str!("own_law/angle_of_sine.glsl")),
    (
        "angle_of_cosine",
        include_str!("own_law/angle_of_cosine.glsl"),
    ),
    ("unit", include_str!("own_law/unit.glsl")),
    ("rise", include_str!("own_law/rise.glsl")),
];

/// Letters that a law declares where it needs them.
const LETTERS: [(&str, &str); 4] = [
    ("R", "vec3 R = 2.0 * dot(N, L) * N - L;"),
    ("H", "vec3 H = unit(L + V);"),
    ("theta", "float theta = angle_of_cosine(dot(N, L));"),
    ("phi", "float phi = angle_of_cosine(dot(R, V));"),
];

/// Words that a line of a law cannot be called: those of GLSL, of this version and of later ones, and those that a law uses itself.
const WORDS: &str = "active asm atomic_uint attribute bool break buffer case cast centroid class coherent common const continue \
    default discard do double else enum extern external false filter fixed flat float for goto half highp if in inline inout input \
    int interface invariant layout long lowp main mediump namespace noinline noperspective out output packed partition patch \
    precise precision public readonly resource restrict return row_major sample shared short sizeof smooth static struct \
    subroutine superp switch template this true typedef uint uniform union unsigned using varying void volatile while writeonly \
    channel N L V R H d color theta phi Ka Kd Ks Os n m eta law degrees radians \
    mod quotient power logarithm angle_of_sine angle_of_cosine unit rise";

/// The scene's own law.
pub struct OwnLaw {
    text: String,
    used: BTreeSet<&'static str>,
}

impl OwnLaw {
    /// Writes the law of `scene`; none if its model is another one.
    pub fn of(scene: &Scene) -> Option<Self> {
        if !scene.reflection.is_own_law() {
            return None;
        }
        let mut writer = Writer::default();
        let lines = match scene.reflection.law() {
            Ok(formula) => writer.lines(&formula),
            // Such a law has no value.
            Err(_) => "    return 0.0;\n".to_owned(),
        };
        let mut used = writer.used;
        let needs: [(&str, &[&'static str]); 6] = [
            ("phi", &["R", "angle_of_cosine"]),
            ("theta", &["angle_of_cosine"]),
            ("R·V", &["R"]),
            ("N·H", &["H"]),
            ("V·H", &["H"]),
            ("rise", &["quotient"]),
        ];
        for (name, others) in needs {
            if used.contains(name) {
                used.extend(others.iter().copied());
            }
        }
        if used.contains("H") {
            used.insert("unit");
        }
        let own = |(name, _): &&(&'static str, &'static str)| used.contains(name);
        let functions: Vec<&str> = FUNCTIONS
            .iter()
            .filter(own)
            .map(|(_, text)| *text)
            .collect();
        let letters: String = (LETTERS.iter().filter(own))
            .map(|(_, text)| format!("    {text}\n"))
            .collect();
        let mut law = Self {
            text: String::new(),
            used,
        };
        let d = if law.uses("d") { "float d, " } else { "" };
        let means = if law.uses("d") {
            " d is the light's distance."
        } else {
            ""
        };
        let values: [(&str, &str); 5] = [
            ("means", means),
            ("d", d),
            ("given", law.distance()),
            ("letters", &letters),
            ("lines", &lines),
        ];
        law.text = functions.join("\n")
            + if functions.is_empty() { "" } else { "\n" }
            + &filled(include_str!("own_law/law.glsl"), &values)
            + &filled(include_str!("own_law/reflected.glsl"), &values);
        Some(law)
    }

    /// Returns the function `law` with those that it calls, and `reflected`, which calls it.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns whether the law uses a name of [`LAW_NUMBERS`].
    pub fn uses(&self, name: &str) -> bool {
        self.used.contains(name)
    }

    /// Returns how the distance to the light is passed on, if the law uses it.
    pub fn distance(&self) -> &'static str {
        if self.uses("d") { "d, " } else { "" }
    }
}

/// The precedence of an operator, the lowest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    Or,
    And,
    Equality,
    Relation,
    Sum,
    Product,
    Sign,
    Value,
}

impl Rank {
    /// Returns the rank that the right operand of an operator of this rank needs.
    fn tighter(self) -> Self {
        match self {
            Self::Or => Self::And,
            Self::And => Self::Equality,
            Self::Equality => Self::Relation,
            Self::Relation => Self::Sum,
            Self::Sum => Self::Product,
            Self::Product => Self::Sign,
            Self::Sign | Self::Value => Self::Value,
        }
    }
}

/// An expression in GLSL.
struct Code {
    text: String,
    rank: Rank,
}

impl Code {
    fn value(text: impl Into<String>) -> Self {
        let (text, rank) = (text.into(), Rank::Value);
        Self { text, rank }
    }

    /// Returns the text as an operand that binds as closely as `rank`.
    fn within(self, rank: Rank) -> String {
        if self.rank < rank {
            format!("({})", self.text)
        } else {
            self.text
        }
    }

    /// Joins operands by an operator, from the left.
    fn joined(operands: Vec<Self>, sign: &str, rank: Rank) -> Self {
        let joined = operands.into_iter().reduce(|all, next| {
            let (left, right) = (all.within(rank), next.within(rank.tighter()));
            let text = format!("{left} {sign} {right}");
            Self { text, rank }
        });
        joined.unwrap_or_else(|| Self::value("0.0"))
    }
}

/// The text of a law as far as it is written.
#[derive(Default)]
struct Writer {
    /// The names of the formula and of [`FUNCTIONS`] that are used.
    used: BTreeSet<&'static str>,
    /// The names of the lines.
    names: Vec<String>,
}

impl Writer {
    /// Writes a statement for each line, below the text that it was read from.
    fn lines(&mut self, formula: &Formula) -> String {
        let (mut all, mut rest) = (String::new(), formula.text());
        for line in formula.lines() {
            let begins = formula.text().len() - rest.len();
            let inside = line.value.span.end.saturating_sub(begins);
            let end = (rest.get(inside..)).map_or(rest.len(), |after| {
                inside + after.find('\n').unwrap_or(after.len())
            });
            // A second statement of a line of text has nothing left to stand below.
            if line.value.span.end > begins {
                let (above, below) = rest.split_at(end);
                let comments = above.lines().filter(|line| !line.trim().is_empty());
                all.extend(comments.map(|line| format!("    // {}\n", ascii(line.trim()))));
                rest = below;
            }
            let statement = match &line.name {
                None => format!("return {}", self.number(&line.value).text),
                Some(name) => {
                    let kind = match line.value.kind {
                        Type::Number => "float",
                        Type::Truth => "bool",
                        Type::Vector => "vec3",
                    };
                    let value = self.code(&line.value).text;
                    let name = self.own_name(name);
                    let statement = format!("{kind} {name} = {value}");
                    self.names.push(name);
                    statement
                }
            };
            all += &format!("    {statement};\n");
        }
        all
    }

    /// Returns a line's name, changed if it means something else in GLSL or is that of a line above.
    fn own_name(&self, name: &str) -> String {
        let mut base = name.to_owned();
        while base.contains("__") {
            base = base.replace("__", "_");
        }
        let base = base.trim_end_matches('_');
        let base = match base.strip_prefix("gl_") {
            Some(rest) => format!("own_gl_{rest}"),
            None => base.to_owned(),
        };
        let free = |name: &String| !is_word(name) && !self.names.contains(name);
        let numbered = (2..).map(|number| format!("{base}_{number}"));
        let mut all = std::iter::once(base.clone()).chain(numbered);
        all.find(free).unwrap_or_default()
    }

    /// Writes the call of one of [`FUNCTIONS`].
    fn call(&mut self, name: &'static str, parts: &[Typed]) -> Code {
        self.used.insert(name);
        self.built_in(name, parts)
    }

    /// Writes a part whose truth counts as a number.
    fn number(&mut self, part: &Typed) -> Code {
        let code = self.code(part);
        match part.kind {
            Type::Truth => Code::value(format!("float({})", code.text)),
            _ => code,
        }
    }

    fn code(&mut self, part: &Typed) -> Code {
        match &part.term {
            Term::Number(number) => Code::value(float(*number)),
            Term::Line(line) => Code::value(self.names.get(*line).cloned().unwrap_or_default()),
            Term::Name(index) => Code::value(self.name(*index)),
            Term::Call(operator, parts) => self.operation(*operator, parts),
        }
    }

    /// Returns what the names of a law are in GLSL.
    fn name(&mut self, index: usize) -> &'static str {
        let all = LAW_NUMBERS.iter().chain(&LAW_VECTORS);
        let name = all.copied().nth(index).unwrap_or_default();
        self.used.insert(name);
        match name {
            "N·L" => "dot(N, L)",
            "R·V" => "dot(R, V)",
            "N·H" => "dot(N, H)",
            "V·H" => "dot(V, H)",
            "N·V" => "dot(N, V)",
            "L·V" => "dot(L, V)",
            "ka" => "Ka[channel]",
            "kd" => "Kd[channel]",
            "ks" => "Ks[channel]",
            "od" => "color[channel]",
            "os" => "Os[channel]",
            "eta" => "eta[channel]",
            name => name,
        }
    }

    fn joined(&mut self, parts: &[Typed], sign: &str, rank: Rank) -> Code {
        let parts = parts.iter().map(|part| self.number(part)).collect();
        Code::joined(parts, sign, rank)
    }

    /// Applies a function of two numbers to any number of them.
    fn folded(&mut self, name: &str, parts: &[Typed]) -> Code {
        let all = parts.iter().map(|part| self.number(part));
        let both =
            |all: Code, next: Code| Code::value(format!("{name}({}, {})", all.text, next.text));
        all.reduce(both).unwrap_or_else(|| Code::value("0.0"))
    }

    /// Writes the call of one of GLSL's own functions.
    fn built_in(&mut self, name: &str, parts: &[Typed]) -> Code {
        let parts: Vec<String> = parts.iter().map(|part| self.number(part).text).collect();
        Code::value(format!("{name}({})", parts.join(", ")))
    }

    /// Writes an operation; the types guarantee as many parts as it has.
    fn operation(&mut self, operator: Operator, parts: &[Typed]) -> Code {
        use Operator as Op;
        match operator {
            Op::Negate => {
                let text = self.joined(parts, "", Rank::Sign).within(Rank::Value);
                Code {
                    text: format!("-{text}"),
                    rank: Rank::Sign,
                }
            }
            Op::Add | Op::Sum => self.joined(parts, "+", Rank::Sum),
            Op::Subtract => self.joined(parts, "-", Rank::Sum),
            Op::Multiply => self.joined(parts, "*", Rank::Product),
            Op::Mean => {
                let sum = self.joined(parts, "+", Rank::Sum);
                let count = Code::value(float(parts.len() as f64));
                Code::joined(vec![sum, count], "/", Rank::Product)
            }
            Op::Divide => self.quotient(parts),
            Op::Power => self.call("power", parts),
            Op::Min => self.folded("min", parts),
            Op::Max => self.folded("max", parts),
            Op::Abs => self.built_in("abs", parts),
            Op::Exp => self.built_in("exp", parts),
            Op::Floor => self.built_in("floor", parts),
            Op::Step => self.built_in("step", parts),
            Op::Mix => self.built_in("mix", parts),
            Op::Dot => self.built_in("dot", parts),
            Op::Cross => self.built_in("cross", parts),
            Op::Length => self.built_in("length", parts),
            Op::Log => self.call("logarithm", parts),
            Op::Asin => self.call("angle_of_sine", parts),
            Op::Acos => self.call("angle_of_cosine", parts),
            Op::Normalize => self.call("unit", parts),
            Op::Smoothstep => self.call("rise", parts),
            Op::Sqrt => self.around("sqrt(max(", parts, ", 0.0))"),
            Op::Sin => self.around("sin(radians(mod(", parts, ", 360.0)))"),
            Op::Cos => self.around("cos(radians(mod(", parts, ", 360.0)))"),
            Op::Tan => self.around("tan(radians(mod(", parts, ", 360.0)))"),
            Op::Atan => self.around("degrees(atan(", parts, "))"),
            Op::Round => {
                let sum = self.joined(parts, "+", Rank::Sum).within(Rank::Sum);
                Code::value(format!("floor({sum} + 0.5)"))
            }
            // GLSL's own clamp says nothing of limits in the wrong order.
            Op::Clamp => match parts {
                [x, least, most] => {
                    let [x, least, most] = [x, least, most].map(|part| self.number(part).text);
                    Code::value(format!("min(max({x}, {least}), {most})"))
                }
                _ => Code::value("0.0"),
            },
            Op::Component(axis) => {
                let axis = ["x", "y", "z"].get(axis).copied().unwrap_or("x");
                let text = self.joined(parts, "", Rank::Value).within(Rank::Value);
                Code::value(format!("{text}.{axis}"))
            }
            Op::Less => self.joined(parts, "<", Rank::Relation),
            Op::LessEqual => self.joined(parts, "<=", Rank::Relation),
            Op::Greater => self.joined(parts, ">", Rank::Relation),
            Op::GreaterEqual => self.joined(parts, ">=", Rank::Relation),
            Op::Equal => self.joined(parts, "==", Rank::Equality),
            Op::NotEqual => self.joined(parts, "!=", Rank::Equality),
            Op::And => self.truths(parts, "&&", Rank::And),
            Op::Or => self.truths(parts, "||", Rank::Or),
            Op::Not => {
                let text = self.truths(parts, "", Rank::Value).within(Rank::Value);
                Code {
                    text: format!("!{text}"),
                    rank: Rank::Sign,
                }
            }
        }
    }

    fn truths(&mut self, parts: &[Typed], sign: &str, rank: Rank) -> Code {
        let parts = parts.iter().map(|part| self.code(part)).collect();
        Code::joined(parts, sign, rank)
    }

    fn around(&mut self, before: &str, parts: &[Typed], after: &str) -> Code {
        let parts: String = parts.iter().map(|part| self.number(part).text).collect();
        Code::value(format!("{before}{parts}{after}"))
    }

    /// Writes a division: by a number other than 0 as such, and of a vector by the inverse.
    fn quotient(&mut self, parts: &[Typed]) -> Code {
        let [a, b] = parts else {
            return Code::value("0.0");
        };
        if matches!(b.term, Term::Number(number) if float(number) != "0.0") {
            return self.joined(parts, "/", Rank::Product);
        }
        if a.kind != Type::Vector {
            return self.call("quotient", parts);
        }
        self.used.insert("quotient");
        let (v, b) = (self.code(a), self.number(b).text);
        let inverse = Code::value(format!("quotient(1.0, {b})"));
        Code::joined(vec![v, inverse], "*", Rank::Product)
    }
}

/// Returns whether a word means something else where a law is written. No word ends in `_` and a number.
fn is_word(name: &str) -> bool {
    let sized = |rest: &str| rest.starts_with(|c: char| c.is_ascii_digit());
    let has_size = |stem: &str| name.split(stem).skip(1).any(sized);
    let is_type = ["vec", "mat"].into_iter().any(has_size)
        || ["sampler", "image"]
            .into_iter()
            .any(|stem| name.contains(stem));
    (is_type && !name.contains('_')) || WORDS.split_ascii_whitespace().any(|word| word == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Reflection;

    /// Returns the lines of a law's function.
    fn written(text: &str) -> Vec<String> {
        let formula = Formula::read(text, &Reflection::law_names()).expect("a law");
        let all = Writer::default().lines(&formula);
        all.lines().map(|line| line.trim().to_owned()).collect()
    }

    /// Returns the value of a law without its text.
    fn value(text: &str) -> String {
        let all = written(text);
        let value = all.last().and_then(|line| line.strip_prefix("return "));
        value.unwrap_or_default().trim_end_matches(';').to_owned()
    }

    #[test]
    fn lines_keep_their_names_below_their_own_text() {
        let text = "# \u{6f2b}: Lambert\nα₁ = max(N·L, 0)²; lit = α₁ > 0\n\nkd * α₁ # times\n  + ks*\n  lit\n# end";
        assert_eq!(
            written(text),
            [
                "// # ?: Lambert",
                "// alpha1 = max(N.L, 0)^2; lit = alpha1 > 0",
                "float alpha1 = power(max(dot(N, L), 0.0), 2.0);",
                "bool lit = alpha1 > 0.0;",
                "// kd * alpha1 # times",
                "// + ks*",
                "// lit",
                "return Kd[channel] * alpha1 + Ks[channel] * float(lit);",
            ]
        );
    }

    #[test]
    fn names_that_mean_something_else_are_numbered() {
        let text = "n = 2*n\nN = N·L*N\nfloat = n\nfloat = float + 1\ngl_x = n\na__b_ = 1\nvec3 = N\n\
                    float*dot(N, vec3)*gl_x*a__b_";
        let statements = written(text);
        let statements: Vec<&String> = (statements.iter())
            .filter(|line| !line.starts_with("//"))
            .collect();
        assert_eq!(
            statements,
            [
                "float n_2 = 2.0 * n;",
                "vec3 N_2 = dot(N, L) * N;",
                "float float_2 = n_2;",
                "float float_3 = float_2 + 1.0;",
                "float own_gl_x = n_2;",
                "float a_b = 1.0;",
                "vec3 vec3_2 = N_2;",
                "return float_3 * dot(N_2, vec3_2) * own_gl_x * a_b;",
            ]
        );
    }

    #[test]
    fn operations_bind_as_they_do_in_the_formula() {
        for (formula, glsl) in [
            ("n - (m - d)", "n - (m - d)"),
            ("n - m - d", "n - m - d"),
            ("(n + m)*d", "(n + m) * d"),
            ("-(-n) - -m", "-(-n) - -m"),
            ("-n^2", "-power(n, 2.0)"),
            ("(-n)^2", "power(-n, 2.0)"),
            ("n/2/(m/4)", "quotient(n / 2.0, m / 4.0)"),
            ("n/0", "quotient(n, 0.0)"),
            ("n/(m*d)", "quotient(n, m * d)"),
            ("length(N/d)", "length(N * quotient(1.0, d))"),
            ("length(N/2)", "length(N / 2.0)"),
            ("n*(m < d)", "n * float(m < d)"),
            ("not (n < m)", "float(!(n < m))"),
            (
                "(n < m or n > d) and not (m == d)",
                "float((n < m || n > d) && !(m == d))",
            ),
            ("(n < m) == (m < d)", "float(float(n < m) == float(m < d))"),
            ("mean(n, m, -d)", "(n + m + -d) / 3.0"),
            ("max(n)", "n"),
            ("m*max(n - d)", "m * (n - d)"),
            ("m*mean(n + d)", "m * ((n + d) / 1.0)"),
            ("clamp(n, m, d)", "min(max(n, m), d)"),
            ("N.x + round(n - m)", "N.x + floor(n - m + 0.5)"),
        ] {
            assert_eq!(value(formula), glsl, "{formula}");
        }
    }
}
