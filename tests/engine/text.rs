//! Text for people: languages, numbers, settings in words, and text from others.

use shading_lab::scene::parameter::Parameter;
use shading_lab::scene::setting_words;
use shading_lab::text::{
    Language, escaped, escaped_json, excerpt, fixed, in_language, language, text, turns,
};

#[test]
fn a_message_is_in_the_language_chosen() {
    assert_eq!(text!("language-system"), "System");
    in_language(Language::TraditionalChinese, || {
        assert_eq!(text!("language-system"), "系統");
    });
    assert_eq!(language(), Language::English);
    assert_eq!(text!("no-such-key"), "no-such-key");
}

#[test]
fn chinese_locales_are_chinese() {
    for (locale, language) in [
        ("zh_TW.UTF-8", Language::TraditionalChinese),
        ("zh-Hant-HK", Language::TraditionalChinese),
        ("zh", Language::TraditionalChinese),
        ("en_GB", Language::English),
        ("C", Language::English),
        ("", Language::English),
    ] {
        assert_eq!(Language::from_locale(locale), language, "{locale}");
    }
}

#[test]
fn nothing_of_what_a_terminal_acts_on_is_left() {
    let all: String = ('\0'..='\u{ffff}').collect();
    let acts = |c: char| (c.is_control() && c != '\n' && c != '\t') || turns(c);
    for text in [escaped(&all), escaped_json(&all)] {
        assert!(!text.contains(acts));
    }
    assert!(escaped(&all).contains("\\u{9b}") && escaped(&all).contains("\\u{202e}"));
    // Harmless characters are unchanged.
    let plain = "θ = 30°, “中文” é 👩‍🔬\n\tn\\x";
    assert_eq!(escaped(plain), plain);
}

#[test]
fn escaped_json_says_the_same() {
    let value = serde_json::json!({ "a\u{9b}": "\u{7f}\u{1b}[31m\u{202e}\"\\" });
    let json = escaped_json(&value.to_string());
    assert!(!json.contains(['\u{9b}', '\u{7f}', '\u{202e}']));
    assert_eq!(
        serde_json::from_str::<serde_json::Value>(&json).ok(),
        Some(value)
    );
}

#[test]
fn a_long_text_is_cut() {
    assert_eq!(excerpt("é".repeat(200).as_str()), "é".repeat(200));
    assert_eq!(excerpt("é".repeat(201).as_str()), "é".repeat(200) + "…");
}

#[test]
fn a_number_has_a_minus_sign_but_not_before_zero() {
    for (value, text) in [
        (-1.25, "−1.250"),
        (-0.0, "0.000"),
        (-0.0004, "0.000"),
        (0.0006, "0.001"),
        (f64::NEG_INFINITY, "−∞"),
        (f64::NAN, "NaN"),
    ] {
        assert_eq!(fixed(value, 3), text);
    }
}

#[test]
fn no_key_of_a_setting_is_left() {
    for (setting, words) in [
        ("shading.shadows=true", "on"),
        ("light.0.exponent=-2", "−2"),
        ("material.n = inf", "∞"),
    ] {
        let shown = setting_words(setting);
        assert!(
            shown.ends_with(words) && !shown.contains(['=', '.']),
            "{setting}: {shown}"
        );
    }
    for parameter in Parameter::all().filter(|parameter| parameter.key != "version") {
        let shown = setting_words(&format!("{}=1", parameter.key(0)));
        assert!(!shown.contains(parameter.key), "{}: {shown}", parameter.key);
    }
    assert_eq!(setting_words("no setting"), "no setting");
}
