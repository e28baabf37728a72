//! The form in which a question is answered on a phone, of each kind: by finger, by keyboard and by names alone. The script
//! (`assets/class/class.js`) makes of it an answer as hand-ins have it.

use super::lab::LabLink;
use super::picture::Pictures;
use super::plot::CurvePlot;
use crate::lesson::{
    ClassQuestion, Element, FORMULA_SIGNS, Formula, Html, Kind, Question, control_unit, element,
    inline, letter, lettered_html, long_control_name, short_number, slider, without_marks,
};
use crate::text::text;

/// Returns the form of a question.
pub fn form(
    question: &Question,
    asked: &ClassQuestion,
    pictures: &Pictures,
    index: usize,
    link: &LabLink,
) -> Element {
    let inside = match &question.kind {
        Kind::Choice(_) => choice(asked),
        Kind::Value(value) => {
            let label = text!("course-answer").into();
            let range = [value.from, value.to];
            Html::new().line(number_field(0, label, range, &value.unit))
        }
        Kind::Point(_) => point(asked, pictures, index),
        Kind::Curve(curve) => {
            let plot = CurvePlot::new(curve);
            let clear = element("button")
                .attribute("type", "button")
                .class("clear")
                .with(text!("course-curve-clear"));
            Html::new()
                .line(hint(text!("phone-curve")))
                .line(plot.html(None))
                .line(clear)
                .line(plot.fields())
        }
        Kind::Formula(formula) => formula_field(formula),
        Kind::Order(_) => order(asked),
        Kind::Settings(settings) => {
            let controls = std::slice::from_ref(&settings.control);
            Html::new()
                .line(hint(text!("phone-settings")))
                .line(link.html())
                .with(fields(controls))
        }
        Kind::Match(asked) => {
            let figure = |number: usize, words: &str| {
                let caption = element("figcaption").with(words);
                pictures.figure(index, number, words).with(caption)
            };
            let pair = element("div")
                .class("pair")
                .with(figure(0, text!("class-start")))
                .with(figure(1, text!("phone-target")));
            Html::new()
                .line(pair)
                .line(hint(text!("phone-match")))
                .line(link.html())
                .with(fields(&asked.controls))
        }
    };
    let legend = element("legend").with(inline(&asked.ask));
    let fieldset = element("fieldset").broken().line(legend).with(inside);
    let send = element("button").class("send").with(text!("phone-send"));
    let problem = match &question.kind {
        Kind::Choice(_) => text!("phone-choose"),
        Kind::Point(_) => text!("phone-no-place"),
        Kind::Curve(_) => text!("course-curve-whole"),
        Kind::Formula(_) => text!("phone-formula"),
        // Each field has its own.
        Kind::Value(_) | Kind::Settings(_) | Kind::Match(_) | Kind::Order(_) => "",
    };
    element("form")
        .attribute("data-kind", question.kind.name())
        .attribute("data-problem", problem)
        .attribute("novalidate", "")
        .broken()
        .line(fieldset)
        .line(element("p").class("problem").attribute("role", "alert"))
        .line(send)
        .line(element("p").class("sent").attribute("role", "status"))
}

fn hint(words: &str) -> Element {
    element("p").class("quiet").with(words)
}

/// Returns the options as radio buttons.
fn choice(asked: &ClassQuestion) -> Html {
    let options = asked.options.iter().enumerate();
    let option = |(index, words): (usize, &String)| {
        let button = element("input")
            .attribute("type", "radio")
            .attribute("name", "choice")
            .attribute("value", index);
        let words = element("span").with(lettered_html(index, words));
        element("label").class("option").with(button).with(words)
    };
    options.map(option).fold(Html::new(), Html::line)
}

/// Returns a field for each control.
fn fields(controls: &[String]) -> Html {
    let field = |(place, key): (usize, &String)| {
        let range = slider(key).map_or([f64::MIN, f64::MAX], |(.., slider)| {
            [slider.from, slider.to]
        });
        let label = long_control_name(key).into();
        number_field(place, label, range, control_unit(key))
    };
    controls
        .iter()
        .enumerate()
        .map(field)
        .fold(Html::new(), Html::line)
}

/// Returns a field for a number with its unit and its range.
fn number_field(place: usize, label: Html, [from, to]: [f64; 2], unit: &str) -> Element {
    let (id, about) = (format!("number-{place}"), format!("range-{place}"));
    let [low, high] = [from, to].map(short_number);
    let range = text!(
        "class-range",
        from = low.as_str(),
        to = high.as_str(),
        unit = unit
    );
    // The keyboard of digits of some phones has no minus.
    let keyboard = if from < 0.0 { "text" } else { "decimal" };
    let input = element("input")
        .attribute("id", &id)
        .attribute("type", "text")
        .attribute("inputmode", keyboard)
        .attribute("autocomplete", "off")
        .attribute("data-from", from)
        .attribute("data-to", to)
        .attribute("data-problem", text!("phone-number", from = low, to = high))
        .attribute("aria-describedby", &about);
    element("p")
        .class("number")
        .with(element("label").attribute("for", id).with(label))
        .with(input)
        .with(element("span").class("unit").with(unit))
        .with(
            element("span")
                .class("quiet")
                .attribute("id", about)
                .with(range.trim_end()),
        )
}

/// Returns the field of a formula, with a button for each name and for the signs that keyboards hide.
fn formula_field(formula: &Formula) -> Html {
    let field = element("textarea")
        .attribute("rows", 2)
        .attribute("maxlength", Formula::MOST_CHARACTERS)
        .attribute("autocapitalize", "none")
        .attribute("autocomplete", "off")
        .attribute("spellcheck", "false")
        .attribute("aria-label", text!("course-answer"));
    let names = formula.names.iter().map(|name| &*name.name);
    let key = |key: &str| {
        element("button")
            .attribute("type", "button")
            .attribute("aria-label", text!("course-formula-put", key = key))
            .with(key)
    };
    let keys = element("p").class("keys");
    let keys = names.map(key).fold(keys, Element::with);
    let keys = FORMULA_SIGNS.into_iter().map(key).fold(keys, Element::with);
    let inside = element("div").class("formula").broken();
    Html::new().line(inside.line(field).line(keys))
}

/// Returns the picture with a cross that is put to a place.
fn point(asked: &ClassQuestion, pictures: &Pictures, index: usize) -> Html {
    let frame = pictures.frame();
    let (width, height) = (frame.width, frame.height);
    let image = element("image")
        .attribute("href", pictures.address(index, 0))
        .attribute("width", width)
        .attribute("height", height);
    let name = text!("phone-picture", ask = without_marks(&asked.ask));
    let svg = element("svg")
        .attribute("viewBox", format!("0 0 {width} {height}"))
        .attribute("role", "application")
        .attribute("tabindex", 0)
        .attribute("aria-label", name)
        .attribute("aria-describedby", "place")
        .broken()
        .line(image);
    let place = element("p")
        .class("quiet")
        .attribute("id", "place")
        .attribute("role", "status")
        .attribute("data-place", text!("phone-place", x = "{x}", y = "{y}"));
    Html::new()
        .line(hint(text!("phone-point")))
        .line(element("div").class("place").with(svg))
        .line(place)
}

/// Returns the items with buttons that move them, in reverse order, so that they are not sent as the lesson has them.
fn order(asked: &ClassQuestion) -> Html {
    let items = asked.options.iter().enumerate().rev();
    let move_button = |class: &str, sign: &str, words: String| {
        element("button")
            .attribute("type", "button")
            .class(class)
            .attribute("aria-label", words)
            .with(sign)
    };
    let item = |(index, words): (usize, &String)| {
        let name = format!("{}. {}", letter(index), without_marks(words));
        let name = name.as_str();
        let moved = text!("phone-moved", item = name, place = "{place}");
        let grip = element("span").class("grip");
        let label = element("span").class("words");
        element("li")
            .attribute("data-item", index)
            .attribute("data-moved", moved)
            .with(grip.attribute("aria-hidden", "true").with("≡"))
            .with(label.with(lettered_html(index, words)))
            .with(move_button("up", "▲", text!("course-up", item = name)))
            .with(move_button("down", "▼", text!("course-down", item = name)))
    };
    let list = items
        .map(item)
        .fold(element("ol").class("order").broken(), Element::line);
    Html::new().line(hint(text!("phone-order"))).line(list)
}
