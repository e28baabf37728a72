//! Formulas as people type them.

use shading_lab::figure::{Base, Formula, Item, is_italic};

/// The tree, written with a bracket about each part.
fn tree(text: &str) -> String {
    fn row(formula: &Formula) -> String {
        let items = formula.items.iter().map(|Item { base, low, high }| {
            let base = match base {
                Base::Name(name) => name.clone(),
                Base::Signs(signs) => format!("'{signs}'"),
                Base::Group(inside) => format!("({})", row(inside)),
            };
            let script = |sign: &str, script: &Formula| match script.is_empty() {
                true => String::new(),
                false => format!("{sign}[{}]", row(script)),
            };
            base + &script("_", low) + &script("^", high)
        });
        items.collect::<Vec<_>>().join(" ")
    }
    Formula::read(text).map_or_else(|| "refused".to_owned(), |formula| row(&formula))
}

#[test]
fn scripts_take_one_character_or_a_group_as_in_tex() {
    for (text, expected) in [
        ("x^12", "x^['1'] '2'"),
        ("x^{12}", "x^['12']"),
        ("x^-1", "x^['−'] '1'"),
        ("K_d·cos^2 θ", "K_[d] '·' cos^['2'] ' ' θ"),
        ("N_ab", "N_[a] b"),
        ("I_{refl}", "I_[refl]"),
        ("z_0^2", "z_['0']^['2']"),
        ("z^2_0", "z_['0']^['2']"),
        ("a_{b_{c}}", "a_[b_[c]]"),
        ("x^\\theta2", "x^[θ] '2'"),
        ("^2", "''^['2']"),
        ("(R·V)^n]", "'(' R '·' V ')'^[n] ']'"),
    ] {
        assert_eq!(tree(text), expected, "{text}");
    }
}

#[test]
fn names_are_words_greek_letters_and_commands() {
    for (text, expected) in [
        ("ΔI", "Δ I"),
        ("2sin θφ", "'2' sin ' ' θ φ"),
        (r"\cos\theta \le 2-1", "cos θ ' ≤ 2−1'"),
        ("{Ka}{Ia} = {=0.5}", "(Ka) (Ia) ' = ' ('=0.5')"),
        ("{s0}", "(s '0')"),
        (" 亮度 I'", "' 亮度 ' I '''"),
        ("", ""),
    ] {
        assert_eq!(tree(text), expected, "{text}");
    }
    let italic = ["I", "θ", "Σ", "Δ", "cos", "2", ""].map(is_italic);
    assert_eq!(italic, [true, true, false, false, false, false, false]);
}

#[test]
fn what_is_left_open_or_said_twice_is_refused() {
    for text in [
        "x^",
        "x_ 1",
        "x^{12",
        "x}",
        "}",
        "{",
        "x^}",
        "x^^2",
        "x_1_2",
        "x^2^3",
        "x^{}",
        "x^_",
        r"\",
        r"2\ ",
        "a_{b_{c_{d_{e_{f}}}}}",
    ] {
        assert_eq!(tree(text), "refused", "{text}");
        assert_eq!(Formula::read_or_verbatim(text).to_string(), text);
    }
}

#[test]
fn plain_text_keeps_what_is_raised_apart() {
    for (text, expected) in [
        ("cos^4 α", "cos^4 α"),
        ("K_a·I_a", "Ka·Ia"),
        ("0.5^{1/n}", "0.5^1/n"),
        (r"\theta \le 90", "θ ≤ 90"),
    ] {
        assert_eq!(Formula::read_or_verbatim(text).to_string(), expected);
    }
}
