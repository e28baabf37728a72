//! Formulas as people type them: grammar, types, errors, and their values.

use super::common::any_formula::any_formula;
use super::common::dice::Dice;
use shading_lab::expression::{Formula, FormulaError, Names};
use shading_lab::illumination::{Domain, FormulaFunction};
use shading_lab::scene::Reflection;
use std::hint::black_box;
use std::time::{Duration, Instant};

fn names() -> Names {
    Names::new(
        &["n", "kd", "ks", "theta", "alpha", "I1"],
        &["N", "L", "V", "R", "H"],
    )
}

/// Returns where and why a formula is refused.
fn refusal(text: &str) -> (usize, usize, String) {
    let error = Formula::read(text, &names()).expect_err(text);
    (
        error.position.line,
        error.position.column,
        error.message.clone(),
    )
}

/// Returns the value of a formula over numbers.
fn value(text: &str, values: &[(&str, f64)]) -> f64 {
    let (words, numbers): (Vec<&str>, Vec<f64>) = values.iter().copied().unzip();
    let function = FormulaFunction::read(text, &Names::new(&words, &[]));
    function
        .unwrap_or_else(|error| panic!("{text}: {error}"))
        .at(&numbers)
        .value
}

#[test]
fn a_middle_dot_between_vectors_is_their_dot_product() {
    for text in [
        "N·L",
        "N · L",
        "L·N",
        "NL",
        "LN",
        "N.L",
        "dot(N, L)",
        "N⋅L",
        "(N)·(L)",
        "N·(L)",
        "a = N\na·L",
        "kd * N·L",
        "N·L / N·V",
        "(N·L)^n",
        "N·L^2",
        "H = L + V\nN·H",
        "N.x * L.x",
        "max(R·V, 0)^n",
        "2*(N·L)*N·V - L·V",
        "r = 2*(N·L)*N - L\nmax(r·V, 0)",
        "normalize(L+V)·N",
        "length(cross(N, L))",
        "length(mix(N, L, 0.5)) + length(-N/2)",
    ] {
        if let Err(error) = Formula::read(text, &names()) {
            panic!("{text}: {error}");
        }
    }
    for text in [
        "N",
        "N * L",
        "N + 1",
        "max(N, 0)",
        "N^2",
        "1/N",
        "dot(N, kd)",
        "cross(N, L)",
        "normalize(kd)",
        "N < L",
        "length(3)",
        "N·kd·L·V",
        "sqrt(N)",
    ] {
        assert!(Formula::read(text, &names()).is_err(), "{text}");
    }
}

#[test]
fn a_number_called_by_a_product_is_found_in_every_spelling() {
    let names = Names::new(&["kd", "N·L", "α", "I_1"], &[]);
    for text in ["N·L", "L·N", "NL", "N.L", "dot(N, L)", "dot(L,N)", "N · L"] {
        let function = FormulaFunction::read(&format!("kd * max({text}, 0)"), &names).expect(text);
        assert_eq!(function.at(&[0.5, 0.5]).value, 0.25, "{text}");
    }
    for text in ["(1 − α)·I_1", "(1-alpha) * I₁", "(1 - α) × i1"] {
        let function = FormulaFunction::read(text, &names).expect(text);
        assert_eq!(function.at(&[0.0, 0.0, 0.25, 4.0]).value, 3.0, "{text}");
    }
    assert!(FormulaFunction::read("N·V", &names).is_err());
    assert!(FormulaFunction::read("N", &names).is_err());
}

#[test]
fn lines_are_values_that_later_lines_use() {
    let x = [("x", 3.0)];
    for (text, expected) in [
        ("a = x + 1\nb = a*a\nb - a", 12.0),
        ("a = 1; a = a + x; a", 4.0),
        ("# a comment\n\na = x  // another\n\n a", 3.0),
        ("x\n + 1", 4.0),
        ("max(x,\n 5)", 5.0),
        ("a = 2 *\n x\na", 6.0),
        ("x = 7\nx", 7.0),
        ("a = x == 3\na + 1", 2.0),
        ("x² + x³ + x**2 + x^2", 54.0),
        ("-x^2", -9.0),
        ("2·x/3·2", 4.0),
    ] {
        assert_eq!(value(text, &x), expected, "{text}");
    }
}

#[test]
fn an_error_says_where_what_was_expected_and_the_nearest_name() {
    for (text, line, column, words) in [
        (
            "max(N, 0)",
            1,
            5,
            "a vector where a number is expected: “max(N, 0)” (did you mean N·L?)",
        ),
        (
            "a = kd\nks * N",
            2,
            1,
            "the value is a vector, expected a number",
        ),
        (
            "kd *\n  (kd + )",
            2,
            9,
            "unexpected “)”, expected a number, a name or “(”",
        ),
        (
            "kd * (ks + 1",
            1,
            13,
            "the formula ends too early, expected “)”",
        ),
        (
            "kd ks",
            1,
            4,
            "unexpected “k”, expected an operator, or a new line",
        ),
        (
            "a = kd\nb = thetas\nb",
            2,
            5,
            "there is no “thetas” here (did you mean theta?)",
        ),
        (
            "mx(kd, 0)",
            1,
            1,
            "there is no “mx” here (did you mean max?)",
        ),
        ("clamp(kd, 0)", 1, 1, "“clamp” has 2 values, expected 3"),
        (
            "a = kd",
            1,
            7,
            "the last line gives the value and has no “name =”",
        ),
        (
            "kd\nks",
            1,
            1,
            "only the last line gives the value; the lines before it begin with “name =”",
        ),
        (
            "max = 1\nmax",
            1,
            1,
            "“max” cannot be the name of a line, it belongs to the language of formulas",
        ),
        ("", 1, 1, "nothing is written yet, expected a formula"),
        (
            "N * L",
            1,
            1,
            "two vectors are multiplied by “·” (dot product) or cross(a, b): “N * L”",
        ),
        ("N + kd", 1, 1, "a number and a vector do not add: “N + kd”"),
        (
            "kd and ks",
            1,
            1,
            "a comparison such as a < b is expected: “kd and ks”",
        ),
        (
            "dot(N, kd)",
            1,
            8,
            "a number where a vector is expected: “dot(N, kd)”",
        ),
        (
            "kd = ks =",
            1,
            9,
            "unexpected “=”, expected an operator, or a new line",
        ),
    ] {
        assert_eq!(refusal(text), (line, column, words.to_owned()), "{text}");
    }
}

#[test]
fn long_formulas_are_refused() {
    let many = |count: usize| vec!["kd"; count].join("+");
    assert!(Formula::read(&many(257), &names()).is_ok());
    assert!(refusal(&many(258)).2.contains("256"));
    assert!(refusal(&"kd".repeat(1001)).2.contains("2000"));
    let deep = |count: usize| format!("{}kd{}", "(".repeat(count), ")".repeat(count));
    assert!(Formula::read(&deep(60), &names()).is_ok());
    assert!(Formula::read(&deep(900), &names()).is_err());
}

#[test]
fn small_powers_of_numbers_are_exact() {
    for (base, exponent) in
        (2..40_u32).flat_map(|base| (2..=4).map(move |exponent| (base, exponent)))
    {
        let power = value(&format!("floor({base}^{exponent})"), &[("x", 1.0)]);
        assert_eq!(power, f64::from(base.pow(exponent)), "{base}^{exponent}");
    }
}

#[test]
fn values_agree_with_rust() {
    let (x, y) = (0.3_f64, -1.7_f64);
    for (text, expected) in [
        ("x + 2*y - x/y", x + 2.0 * y - x / y),
        ("clamp(y, -1, x)", -1.0),
        ("mix(x, y, 0.25)", 0.75 * x + 0.25 * y),
        ("step(x, y) + step(y, x)", 1.0),
        ("smoothstep(0, 1, x)", x * x * (3.0 - 2.0 * x)),
        ("floor(y) + round(x)", -2.0),
        ("exp(x) + log(x)", x.exp() + x.ln()),
        (
            "pow(x, y) + x^3 + y^3 + y^4",
            x.powf(y) + x.powi(3) + y.powi(3) + y.powi(4),
        ),
        ("abs(y) + sqrt(x)", -y + x.sqrt()),
        ("sin(30) + cos(60) + tan(45)", 2.0),
        ("asin(x) + acos(x)", 90.0),
        ("atan(1)", 45.0),
        ("min(x, y, 1) + max(x, y, 1)", y + 1.0),
        ("sum(x, y) + mean(x, y)", 1.5 * (x + y)),
        ("(x > y) + (x < y) + (x >= x) + (x != y) + (x == y)", 3.0),
        ("not (x > y or x < y)", 0.0),
        ("(x > y and x > 0) * 5", 5.0),
        ("y^-2", y.powi(-2)),
        ("(-2)^3 + 2^-1", -7.5),
    ] {
        let found = value(text, &[("x", x), ("y", y)]);
        assert!(
            (found - expected).abs() < 1e-12,
            "{text}: {found}, expected {expected}"
        );
    }
}

#[test]
fn what_has_no_value_is_0_and_noted() {
    let names = Names::new(&["x"], &[]);
    for (text, x) in [
        ("1/x", 0.0),
        ("sqrt(x)", -1.0),
        ("log(x)", 0.0),
        ("x^0.5", -2.0),
        ("x^-1", 0.0),
        ("acos(x)", 1.5),
        ("x/(x - x)", 2.0),
        ("x^x", -0.5),
    ] {
        let outcome = FormulaFunction::read(text, &names).expect(text).at(&[x]);
        assert!(
            outcome.undefined && outcome.value == 0.0,
            "{text}: {outcome:?}"
        );
    }
    for (text, x) in [
        ("1/x", 2.0),
        ("sqrt(x)", 0.0),
        ("x^0.5", 4.0),
        ("x^3", -2.0),
        ("acos(x)", 1.0),
    ] {
        let outcome = FormulaFunction::read(text, &names).expect(text).at(&[x]);
        assert!(!outcome.undefined, "{text}: {outcome:?}");
    }
}

#[test]
fn formulas_are_compared_by_meaning() {
    let names = Names::new(&["kd", "ip", "N·L"], &[]);
    let read = |text: &str| FormulaFunction::read(text, &names).expect(text);
    let domain = Domain::new([[0.0, 1.0], [0.0, 2.0], [-1.0, 1.0]]);
    assert_eq!(domain.points().len(), Domain::POINTS);
    let right = read("kd * ip * max(N·L, 0)");
    for same in [
        "ip*kd*max(0, L·N)",
        "kd*ip*clamp(NL, 0, 1)",
        "kd*ip*(NL + abs(NL))/2",
        "(NL > 0) * kd * ip * N·L",
        "c = N·L\nkd*ip*c*step(0, c)",
    ] {
        assert_eq!(domain.difference(&right, &read(same), 1e-9), None, "{same}");
    }
    for other in [
        "kd*ip*N·L",
        "kd*ip*abs(N·L)",
        "kd*max(N·L,0)",
        "kd*ip*max(N·L, 0.001)",
        "kd*ip*max(N·L,0)^1.01",
    ] {
        let found = domain.difference(&right, &read(other), 1e-9).expect(other);
        let [a, b] = found.results;
        assert_eq!(
            (right.at(&found.values), read(other).at(&found.values)),
            (a, b),
            "{other}"
        );
        assert!((a.value - b.value).abs() > 1e-9, "{other}: {found:?}");
    }
}

#[test]
fn shared_parts_are_computed_once_and_constants_before() {
    let names = Names::new(&["x", "y"], &[]);
    for (text, operations) in [
        ("2*3 + sqrt(16)", 0),
        ("x*y + x*y", 2),
        ("a = x*y\nb = y*x\na*b + 0*x", 2),
        ("unused = exp(x)\ny*1 + 0", 0),
        ("x*y + 1", 1),
        ("x^2 + y^4", 3),
        ("max(abs(x), 0)", 1),
    ] {
        let function = FormulaFunction::read(text, &names).expect(text);
        assert_eq!(function.operations(), operations, "{text}");
    }
}

/// Far more than it takes to refuse any text, 2 ms optimised: on a machine that does something else as well.
const PATIENCE: Duration = Duration::from_millis(200);

const PIECES: [&str; 52] = [
    "N·L",
    "R·V",
    "a·b",
    "d",
    "phi",
    "eta",
    "mix(",
    "clamp(",
    "smoothstep(",
    "b = a*a\n",
    ".x",
    ";",
    "N",
    "L",
    "V",
    "R",
    "H",
    "kd",
    "n",
    "theta",
    "·",
    "+",
    "-",
    "*",
    "/",
    "^",
    "(",
    ")",
    ",",
    "\n",
    " ",
    "= ",
    "a = ",
    "max(",
    "dot(",
    "normalize(",
    "cross(",
    "0",
    "1.5",
    "1e999",
    ".",
    "[",
    "]",
    "with(\"",
    "at(",
    "not ",
    "and",
    "==",
    "#",
    "√",
    "²",
    "𝒩",
];

/// Reads a text, and returns the time that it takes: the shortest of three, since the machine may do something else meanwhile.
fn read_in(text: &str, names: &Names) -> (Result<Formula, FormulaError>, Duration) {
    let time = |_| {
        let began = Instant::now();
        let _ = black_box(Formula::read(text, names));
        began.elapsed()
    };
    let shortest = (0..3).map(time).min();
    (Formula::read(text, names), shortest.unwrap_or_default())
}

#[test]
fn no_random_text_is_slow_or_panics() {
    let mut dice = Dice(36);
    let mut longest = Duration::ZERO;
    let mut refused = 0;
    let names = [names(), Reflection::law_names()];
    for round in 0..2000 {
        let mut text = String::new();
        while text.chars().count() < 2000 {
            if round % 2 == 0 {
                text += PIECES[(dice.unit() * PIECES.len() as f64) as usize];
            } else {
                text.extend(char::from_u32(32 + (dice.unit() * 1000.0) as u32));
            }
            if round % 3 == 0 && text.len() > 40 {
                break;
            }
        }
        let text: String = text.chars().take(2000).collect();
        let (read, took) = read_in(&text, &names[round / 6 % 2]);
        longest = longest.max(took);
        if let Err(error) = read {
            refused += 1;
            let lines = 1 + text.matches('\n').count();
            assert!((1..=lines).contains(&error.position.line), "{text}");
            assert!(!error.message.is_empty());
        }
    }
    assert!(refused > 1500, "{refused}");
    println!("the longest took {longest:?}");
    assert!(longest < PATIENCE, "{longest:?}");
}

#[test]
fn a_long_text_that_is_wrong_at_its_end_is_refused_at_once() {
    let names = Reflection::law_names();
    let mut longest = Duration::ZERO;
    for piece in [
        "(",
        "-",
        "not ",
        "max(",
        "kd^",
        "√(",
        "[",
        "N·",
        "N.",
        "\n",
        ";",
        "k",
        "·",
        "#\n",
        "kd,",
        "a=kd\n",
        "kd+",
        "(kd)*",
        "a=a+kd;",
        "b=cross(N,L)\n",
        "c=N\n",
        "kd*kd+kd^kd+",
        "max(kd,kd)+",
        "1e",
        "kd<",
        "dot(N,",
        "a=normalize(H+",
    ] {
        let mut text = piece.repeat(2000 / piece.chars().count());
        text.extend(
            ["?"; 2]
                .iter()
                .take(2000 - text.chars().count().min(2000))
                .copied(),
        );
        let (read, took) = read_in(&text, &names);
        longest = longest.max(took);
        let error = read.expect_err(piece);
        assert!(
            !error.message.is_empty() && error.message.chars().count() < 300,
            "{error}"
        );
    }
    println!("the longest took {longest:?}");
    assert!(longest < PATIENCE, "{longest:?}");
}

#[test]
fn random_formulas_are_formulas_and_use_the_whole_grammar() {
    let mut dice = Dice(3);
    let mut all = String::new();
    for _ in 0..2000 {
        let text = any_formula(&mut dice);
        let read = Formula::read(&text, &Reflection::law_names());
        assert!(read.is_ok(), "{text}: {}", read.unwrap_err());
        all += &format!("{:?}", read.map(|formula| formula.lines().to_vec()));
    }
    for operator in [
        "Negate",
        "Add",
        "Subtract",
        "Multiply",
        "Divide",
        "Power",
        "Min",
        "Max",
        "Sum",
        "Mean",
        "Abs",
        "Sqrt",
        "Exp",
        "Log",
        "Floor",
        "Round",
        "Sin",
        "Cos",
        "Tan",
        "Asin",
        "Acos",
        "Atan",
        "Clamp",
        "Mix",
        "Step",
        "Smoothstep",
        "Dot",
        "Cross",
        "Length",
        "Normalize",
        "Component(2)",
        "Less",
        "LessEqual",
        "Greater",
        "GreaterEqual",
        "Equal",
        "NotEqual",
        "And",
        "Or",
        "Not",
    ] {
        assert!(all.contains(&format!("Call({operator}, ")), "{operator}");
    }
    for name in 0..Reflection::law_names().len() {
        assert!(all.contains(&format!("Name({name})")), "{name}");
    }
}
