//! Formulas typed with a keyboard, `kd * max(N·L, 0)`, in the notation of textbooks, `K_d·max(N·L, 0)`.
//!
//! The text is taken apart into names, numbers and signs, and needs not be whole: a formula is set while it is being typed.

use std::iter::Peekable;
use std::slice::Iter;
use std::str::Chars;

/// Names that stand for a Greek letter, alone or with an index.
const GREEK: [(&str, char); 12] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("lambda", 'λ'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("phi", 'φ'),
    ("omega", 'ω'),
    ("Delta", 'Δ'),
    ("pi", 'π'),
];
/// Names whose letter is a capital in textbooks: the coefficients, colours and intensities of the equation.
const CAPITALS: [&str; 8] = ["ka", "kd", "ks", "kt", "od", "os", "ia", "ip"];
/// The letters of vectors.
const VECTORS: &str = "NLVRHST";
/// Exponents that are characters of their own.
const RAISED: [char; 2] = ['²', '³'];
/// The deepest exponent within others that is raised.
const DEPTH: usize = 3;

/// The most brackets and exponents of a formula that is set: they may all lie within one another.
const NESTED: usize = 200;

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Name(String),
    Number(String),
    /// The product of two vectors, which is one term.
    Product(String),
    Sign(char),
}

/// Returns a typed formula as [`Formula::read`](super::Formula::read) takes it.
///
/// ```
/// use shading_lab::figure::{Formula, typed};
///
/// assert_eq!(typed("ks * max(R·V, 0)^(n/2)"), "K_s·max(R·V, 0)^{n/2}");
/// assert!(Formula::read(&typed("kd * (")).is_some(), "while it is typed");
/// ```
pub fn typed(text: &str) -> String {
    let tokens = tokens(text);
    let nests = |token: &&Token| matches!(token, Token::Sign('(' | '^'));
    if tokens.iter().filter(nests).count() > NESTED {
        return text.replace(|c| "$\\{}_^`\n".contains(c), " ");
    }
    let mut out = String::new();
    let mut rest = tokens.iter().peekable();
    set(&mut out, &mut rest, 0);
    out.trim().to_owned()
}

fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut rest = text.chars().peekable();
    while let Some(first) = rest.next() {
        let mut taken = first.to_string();
        let mut take = |fits: fn(char) -> bool| {
            while let Some(next) = rest.next_if(|next| fits(*next)) {
                taken.push(next);
            }
        };
        match first {
            _ if first.is_alphabetic() => {
                take(|c| (c.is_alphanumeric() && !RAISED.contains(&c)) || c == '_');
                tokens.push(Token::Name(taken.chars().map(plain_digit).collect()));
            }
            '0'..='9' | '.' => {
                take(|c| c.is_ascii_digit() || c == '.');
                tokens.push(Token::Number(taken));
            }
            '*' if rest.next_if_eq(&'*').is_some() => tokens.push(Token::Sign('^')),
            '×' => tokens.push(Token::Sign('*')),
            '⋅' | '•' => tokens.push(Token::Sign('·')),
            '-' => tokens.push(Token::Sign('−')),
            '²' | '³' => {
                tokens.push(Token::Sign('^'));
                tokens.push(Token::Number(
                    if first == RAISED[0] { "2" } else { "3" }.to_owned(),
                ));
            }
            '\n' => tokens.push(Token::Sign(';')),
            '#' => skip_line(&mut rest),
            '/' if rest.peek() == Some(&'/') => skip_line(&mut rest),
            // What would be notation, or end the formula.
            '$' | '\\' | '{' | '}' | '_' | '`' => {}
            _ if first.is_whitespace() || first.is_control() => {}
            sign => tokens.push(Token::Sign(sign)),
        }
        join_vectors(&mut tokens);
    }
    tokens
}

/// Skips a comment up to the end of its line.
fn skip_line(rest: &mut Peekable<Chars<'_>>) {
    while rest.next_if(|c| *c != '\n').is_some() {}
}

/// Returns a digit below the line as one on it.
fn plain_digit(c: char) -> char {
    match c {
        '₀'..='₉' => char::from_digit(c as u32 - '₀' as u32, 10).unwrap_or(c),
        _ => c,
    }
}

/// Makes one token of two vectors at the end: `N·L`, `N.L` or `NL`.
fn join_vectors(tokens: &mut Vec<Token>) {
    let vector = |name: &str| name.len() == 1 && VECTORS.contains(name);
    let (a, b, count) = match &tokens[..] {
        [.., Token::Name(a), Token::Sign('·'), Token::Name(b)] => (&**a, &**b, 3),
        [.., Token::Name(a), Token::Number(dot), Token::Name(b)] if dot == "." => (&**a, &**b, 3),
        [.., Token::Name(both)] if both.len() == 2 && both.is_ascii() => {
            let (a, b) = both.split_at(1);
            (a, b, 1)
        }
        _ => return,
    };
    if vector(a) && vector(b) {
        let product = Token::Product(format!("{a}·{b}"));
        tokens.truncate(tokens.len() - count);
        tokens.push(product);
    }
}

/// Sets tokens up to a closing bracket, which is left.
fn set(out: &mut String, rest: &mut Peekable<Iter<'_, Token>>, depth: usize) {
    // Nothing stands before the next sign.
    let mut first = true;
    while let Some(token) = rest.next_if(|token| **token != Token::Sign(')')) {
        let was_first = std::mem::replace(&mut first, false);
        match token {
            Token::Name(name) => out.push_str(&letter(name)),
            Token::Number(number) => out.push_str(number),
            Token::Product(product) => {
                let factor = |sign: &char| "*·/^".contains(*sign);
                let follows = matches!(rest.peek(), Some(Token::Sign(sign)) if factor(sign));
                if follows || out.ends_with(['·', '/']) {
                    out.push_str(&format!("({product})"));
                } else {
                    out.push_str(product);
                }
            }
            Token::Sign('(') => bracket(out, rest, depth),
            Token::Sign('^') => raise(out, rest, depth),
            Token::Sign('*') => out.push('·'),
            Token::Sign(sign @ ('+' | '−')) if was_first => {
                out.push(*sign);
                first = true;
            }
            Token::Sign(sign @ ('·' | '/')) => out.push(*sign),
            Token::Sign(sign @ (',' | ';')) => {
                out.push(*sign);
                out.push(' ');
                first = true;
            }
            Token::Sign(sign) => {
                let joined = "<>=!".contains(*sign) && out.ends_with(['<', '>', '=', '!']);
                if !joined && !out.is_empty() {
                    out.push(' ');
                }
                out.push(*sign);
                let goes_on = matches!(rest.peek(), Some(Token::Sign('=')));
                if !goes_on {
                    out.push(' ');
                }
                first = true;
            }
        }
    }
}

/// Sets the content of brackets, and the closing one if it is there.
fn bracket(out: &mut String, rest: &mut Peekable<Iter<'_, Token>>, depth: usize) {
    out.push('(');
    let mut inside = String::new();
    set(&mut inside, rest, depth);
    out.push_str(&inside);
    if rest.next().is_some() {
        out.push(')');
    }
}

/// Raises the operand of `^`: a name, a number, a call or what stands in brackets, each with its sign, and what is raised above
/// it in turn.
fn raise(out: &mut String, rest: &mut Peekable<Iter<'_, Token>>, depth: usize) {
    let mut high = String::new();
    while let Some(Token::Sign(sign)) =
        rest.next_if(|token| matches!(token, Token::Sign('+' | '−')))
    {
        high.push(*sign);
    }
    let mut bracketed = None;
    match rest.peek() {
        Some(Token::Sign('(')) => {
            rest.next();
            bracketed = Some(high.len());
            bracket(&mut high, rest, depth + 1);
        }
        Some(Token::Name(name)) => {
            high.push_str(&letter(name));
            rest.next();
            if rest.next_if(|token| **token == Token::Sign('(')).is_some() {
                bracket(&mut high, rest, depth + 1);
            }
        }
        Some(Token::Number(text) | Token::Product(text)) => {
            high.push_str(text);
            rest.next();
        }
        _ => {}
    }
    if rest.next_if(|token| **token == Token::Sign('^')).is_some() {
        raise(&mut high, rest, depth + 1);
    } else if bracketed == Some(0) && high.ends_with(')') {
        // Above the line nothing else could belong to it.
        high = high[1..high.len() - 1].to_owned();
    }
    let high = high.trim();
    match high.chars().count() {
        0 => {}
        _ if depth >= DEPTH => {
            out.push_str("**");
            out.push_str(high);
        }
        1 => {
            out.push('^');
            out.push_str(high);
        }
        _ => {
            out.push_str("^{");
            out.push_str(high);
            out.push('}');
        }
    }
}

/// Returns a name as a letter with its index, a function as its sign or its word.
fn letter(name: &str) -> String {
    if name == "sqrt" {
        return "√".to_owned();
    }
    if let Some((base, index)) = name.split_once('_') {
        let greek = greek(base).filter(|(_, rest)| rest.is_empty());
        return indexed(
            &greek.map_or(base.to_owned(), |(letter, _)| letter.to_string()),
            index,
        );
    }
    if let Some((letter, index)) = greek(name) {
        return indexed(&letter.to_string(), index);
    }
    let mut rest = name.chars();
    let Some(first) = rest.next() else {
        return String::new();
    };
    let index = rest.as_str();
    if CAPITALS.contains(&name) {
        return indexed(&first.to_ascii_uppercase().to_string(), index);
    }
    let numbered = index.chars().all(|c| c.is_ascii_digit());
    let of_point = index.len() == 1 && index.starts_with(|c: char| c.is_ascii_uppercase());
    if first.is_ascii_uppercase() || numbered || of_point {
        return indexed(&first.to_string(), index);
    }
    name.to_owned()
}

/// Returns the Greek letter that a name begins with, and its index.
fn greek(name: &str) -> Option<(char, &str)> {
    let mut letters = GREEK.iter();
    letters.find_map(|(word, letter)| {
        let index = name.strip_prefix(word)?;
        let number = index.chars().all(|c| c.is_ascii_digit());
        number.then_some((*letter, index))
    })
}

fn indexed(letter: &str, index: &str) -> String {
    let index: String = index.chars().filter(|c| c.is_alphanumeric()).collect();
    match index.chars().count() {
        0 => letter.to_owned(),
        1 => format!("{letter}_{index}"),
        _ => format!("{letter}_{{{index}}}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Formula;

    #[test]
    fn typed_formulas_are_set_as_in_textbooks() {
        for (text, expected) in [
            ("kd*ip*max(N·L,0)", "K_d·I_p·max(N·L, 0)"),
            ("Kd * Ip * max(0, L·N)", "K_d·I_p·max(0, L·N)"),
            ("K_d * I_p", "K_d·I_p"),
            ("ks*(R·V)^n", "K_s·(R·V)^n"),
            ("R·V^n", "(R·V)^n"),
            ("2*N*N·L - L", "2·N·(N·L) − L"),
            ("kd * N·L", "K_d·(N·L)"),
            ("max(NL, 0) + N.V", "max(N·L, 0) + N·V"),
            ("N·L/N·V", "(N·L)/(N·V)"),
            ("(1-alpha)*I1+α*I2", "(1 − α)·I_1 + α·I_2"),
            ("-x^-2", "−x^{−2}"),
            ("exp(-(tan(a)/m)^2)/cos(a)^4", "exp(−(tan(a)/m)^2)/cos(a)^4"),
            ("x**2 + y²", "x^2 + y^2"),
            ("I₁ + η₂", "I_1 + η_2"),
            ("2^(n+1)^2", "2^{(n + 1)^2}"),
            ("x^(n+1)", "x^{n + 1}"),
            ("x^n^2", "x^{n^2}"),
            ("x^min(n, 3)*2", "x^{min(n, 3)}·2"),
            ("sqrt(1-(N·L)^2)", "√(1 − (N·L)^2)"),
            ("(IQ - IP)/(xQ - xP)", "(I_Q − I_P)/(x_Q − x_P)"),
            ("s0*I + (1 - s0)*Idc", "s_0·I + (1 − s_0)·I_{dc}"),
            ("eta1/eta2*sin(theta)", "η_1/η_2·sin(θ)"),
            ("spot = max(R·V, 0)\nspot^n", "spot = max(R·V, 0); spot^n"),
            ("back - z", "back − z"),
            ("kd # of light\nks // as well", "K_d; K_s"),
            ("a / b", "a/b"),
            ("a <= b", "a <= b"),
            ("max(kd, ", "max(K_d,"),
            ("kd * (", "K_d·("),
            ("$x{}`\\_", "x"),
            ("", ""),
            (&"(".repeat(1000), &"(".repeat(1000)),
        ] {
            assert_eq!(typed(text), expected, "{text}");
        }
    }

    #[test]
    fn whatever_is_typed_can_be_set() {
        let signs = [
            "kd", "N·L", "(", ")", "^", "**", "²", "-", "+", "*", "1.5", "I1", "_", "{", "$",
            "max", ",", "\n",
        ];
        let mut state = 1u64;
        for _ in 0..20_000 {
            let text: String = (0..12)
                .map(|_| {
                    state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(1);
                    signs[(state >> 33) as usize % signs.len()]
                })
                .collect();
            let set = typed(&text);
            assert!(Formula::read(&set).is_some(), "{text}: {set}");
        }
    }
}
