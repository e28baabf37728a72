//! A point: a place in the picture.

use super::extreme::Extreme;
use super::kind::{AnyKind, Predictions, Printed, QuestionKind};
use super::number::short_number;
use crate::analysis::perception::luminance;
use crate::expression::Expression;
use crate::lesson::html::{Element, Html, element};
use crate::lesson::page::{data, picture};
use crate::lesson::read::keys::{KeyReader, Keys};
use crate::lesson::{Hint, LabPlace, Side, Stage};
use crate::render::Frame;
use crate::scene::{Rgb, ShadingMode, pixel_to_place, place_to_pixel};
use crate::text::{fixed, text};
use glam::DVec2;

/// The distance within which a click counts, unless the lesson says so.
const NEAR: f64 = 0.05;
/// The farthest that a place can lie from the picture's middle, in units of its shorter side.
const FAR: f64 = 8.0;
/// Places along the picture's shorter side that are tried.
const TRIED: usize = 49;
/// The number of times that the way between two places on either side of a line is halved: a jump lies within 1/2000 of the shorter side.
const HALVINGS: usize = 6;

/// A place in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The place that is looked for.
    pub find: Find,
    /// The largest distance from it that counts as right, in units of the picture's shorter side.
    pub tolerance: f64,
}

/// The right place of a point.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Find {
    /// The pixel of the largest luminance.
    Brightest,
    /// The pixel of the object of the smallest luminance.
    Darkest,
    /// The place in the picture where this is largest or smallest.
    Extreme(Extreme, Expression),
    /// Anywhere that its sign changes.
    Zero(Expression),
    /// The place on the step's line where the slope jumps most in this mode.
    Corner(ShadingMode),
    /// This place: that of a wrong model.
    At(DVec2),
}

impl AnyKind for Point {
    fn asks_place(&self) -> bool {
        true
    }

    fn uses_picture(&self) -> bool {
        true
    }
}

impl QuestionKind for Point {
    /// The offset from the middle of the picture to the right and down, in units of the shorter side.
    type Answer = [f64; 2];
    /// The right places; the first stands for all of them if only one is shown.
    type Solution = Vec<DVec2>;

    const MODEL_KEYS: &[&str] = &["find", "of", "mode", "at"];

    fn read(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Self> {
        let Some(find) = &keys.find else {
            reader.missing("find");
            return None;
        };
        let tolerance = reader.positive("tolerance", keys.tolerance.or(Some(NEAR)))?;
        if let Some(at) = &keys.at {
            if !at.get_ref().iter().all(|x| x.abs() <= Stage::FARTHEST) {
                reader.wrong_value("at", at, text!("lesson-at"));
                return None;
            }
            let find = Find::At(DVec2::from_array(*at.get_ref()));
            return Some(Self { find, tolerance });
        }
        let mut of = || reader.expression("of", &keys.of);
        let find = match &**find.get_ref() {
            "brightest" => Find::Brightest,
            "darkest" => Find::Darkest,
            "greatest" => Find::Extreme(Extreme::Greatest, of()?),
            "least" => Find::Extreme(Extreme::Least, of()?),
            "zero" => Find::Zero(of()?),
            "corner" => Find::Corner(match &keys.mode {
                Some(mode) => reader.mode("mode", mode)?,
                None => ShadingMode::Gouraud,
            }),
            _ => {
                let words = [
                    "brightest",
                    "darkest",
                    "greatest",
                    "least",
                    "zero",
                    "corner",
                ];
                reader.wrong_word("find", find, &words);
                return None;
            }
        };
        Some(Self { find, tolerance })
    }

    fn solve(&self, place: LabPlace<'_>, _: u64) -> Result<Vec<DVec2>, String> {
        self.find.places(place, self.tolerance)
    }

    fn right(right: &Vec<DVec2>) -> [f64; 2] {
        shown(right).to_array()
    }

    fn fits(&self, given: &[f64; 2]) -> bool {
        given.iter().all(|x| x.abs() <= FAR)
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }

    fn distance(&self, given: &[f64; 2], model: &Vec<DVec2>, _: LabPlace<'_>) -> Option<f64> {
        let given = DVec2::from_array(*given);
        nearest(model, given).map(|place| place.distance(given))
    }

    fn fault(&self, given: &[f64; 2], right: &Vec<DVec2>, place: LabPlace<'_>) -> Option<Hint> {
        let given = DVec2::from_array(*given);
        let right = nearest(right, given)?;
        let there = place.probing(given);
        let share = match &self.find {
            Find::Extreme(Extreme::Greatest, of) => match there.number(of) {
                Ok(value) => Some(value / place.probing(right).number(of).ok()?),
                Err(_) => return Some(Hint::Beside),
            },
            _ => None,
        };
        let share = share.filter(|share| (0.0..1.0).contains(share));
        let side = side_of(given, right);
        Some(Hint::Place { side, share })
    }

    fn short([x, y]: &[f64; 2]) -> String {
        format!("({}, {})", short_number(*x), short_number(*y))
    }

    fn words(&self, given: &[f64; 2], _: &[String]) -> String {
        Self::short(given)
    }

    fn solution_words(&self, right: &Vec<DVec2>, _: &[String]) -> String {
        let place = shown(right);
        format!("({}, {})", fixed(place.x, 2), fixed(place.y, 2))
    }

    fn blank(&self, printed: &Printed<'_>, _: Option<&Vec<DVec2>>) -> Result<Html, String> {
        let words = element("p").class("quiet").with(text!("class-mark"));
        let image = picture(printed.picture, printed.ask);
        Ok(Html::new().line(words).line(image))
    }

    /// Marks the right places in the picture that they are looked for in.
    fn drawing(&self, right: &Vec<DVec2>, printed: &Printed<'_>) -> Result<Option<Html>, String> {
        let picture = &printed.picture_under(printed.set)?;
        let side = f64::from(picture.width.min(picture.height));
        let radius = if right.len() == 1 { 0.03 } else { 0.006 } * side;
        let rings = right.iter().flat_map(|place| {
            [("#000", 0.012), ("#fff", 0.006)].map(|(colour, width)| {
                circle(picture, *place, radius)
                    .attribute("stroke", colour)
                    .length("stroke-width", width * side)
            })
        });
        let svg = rings.fold(svg_over(picture), Element::line);
        Ok(Some(
            Html::new().line(element("figure").class("points").with(svg)),
        ))
    }

    /// Returns every predicted place over the picture, and the right ones.
    fn chart(&self, class: &Predictions<'_, [f64; 2], Vec<DVec2>>) -> Html {
        let Some(picture) = class.picture else {
            return Html::new();
        };
        let side = f64::from(picture.width.min(picture.height));
        let right = class.right.map_or(&[][..], |right| right);
        let right = right.iter().map(|place| match class.right.map(Vec::len) {
            Some(1) => circle(picture, *place, self.tolerance * side)
                .attribute("stroke", "#fff")
                .attribute("stroke-width", 2),
            _ => circle(picture, *place, 0.004 * side).attribute("fill", "#fff"),
        });
        let given = class.given.iter().map(|(given, grade)| {
            circle(picture, DVec2::from_array(**given), 0.012 * side)
                .attribute("fill", if grade.right { "#2e9e4f" } else { "#e0482e" })
                .attribute("fill-opacity", 0.75)
                .attribute("stroke", "#000")
                .attribute("stroke-width", 0.8)
        });
        let svg = right.chain(given).fold(svg_over(picture), Element::line);
        let caption = element("figcaption").with(text!("class-clicks"));
        Html::new().line(element("figure").class("points").line(svg).with(caption))
    }
}

/// Returns the nearest of several places.
fn nearest(places: &[DVec2], to: DVec2) -> Option<DVec2> {
    let off = |place: &DVec2| place.distance_squared(to);
    places
        .iter()
        .copied()
        .min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// Returns to which side of the right place another one lies: outwards or inwards, where that is so, else along an axis.
fn side_of(given: DVec2, right: DVec2) -> Side {
    // Nearer than this to the middle, every direction leads outwards.
    const MIDDLE: f64 = 0.03;
    // cos 30°
    const ALONG: f64 = 0.87;
    let off = given - right;
    let outwards = if right.length() < MIDDLE {
        1.0
    } else {
        off.normalize_or_zero().dot(right.normalize())
    };
    if outwards >= ALONG {
        Side::Out
    } else if outwards <= -ALONG && off.length() < right.length() {
        Side::In
    } else if off.x.abs() >= off.y.abs() {
        if off.x > 0.0 { Side::Right } else { Side::Left }
    } else if off.y > 0.0 {
        Side::Down
    } else {
        Side::Up
    }
}

/// Returns the place that stands for all that are right.
fn shown(right: &[DVec2]) -> DVec2 {
    right.first().copied().unwrap_or_default()
}

/// Returns a drawing in pixels over a picture.
fn svg_over(picture: &Frame) -> Element {
    let (width, height) = (picture.width, picture.height);
    let image = element("image")
        .attribute("href", data(picture))
        .attribute("width", width)
        .attribute("height", height);
    element("svg")
        .attribute("viewBox", format!("0 0 {width} {height}"))
        .attribute("role", "img")
        .attribute("fill", "none")
        .broken()
        .line(image)
}

/// Returns a circle about a place of the picture.
fn circle(picture: &Frame, place: DVec2, radius: f64) -> Element {
    let size = DVec2::new(picture.width.into(), picture.height.into());
    let at = place_to_pixel(place, size);
    element("circle")
        .length("cx", at.x)
        .length("cy", at.y)
        .length("r", radius)
}

impl Find {
    /// Finds the right places; the first stands for all of them where one is shown.
    fn places(&self, place: LabPlace<'_>, tolerance: f64) -> Result<Vec<DVec2>, String> {
        match self {
            Self::Brightest => brightest(place, 1.0, tolerance),
            Self::Darkest => brightest(place, -1.0, tolerance),
            Self::Corner(mode) => corner(place, *mode, tolerance),
            Self::At(place) => Ok(vec![*place]),
            Self::Extreme(extreme, of) => {
                let sign = extreme.sign();
                let mut values = grid(place, of)?;
                // Between the places of the grid the greatest may lie anywhere: a finer look about the best.
                let best = values
                    .iter()
                    .copied()
                    .max_by(|a, b| (sign * a.1).total_cmp(&(sign * b.1)));
                let best = best.ok_or_else(|| text!("lesson-no-object").to_owned())?;
                let step = 1.0 / (TRIED as f64 * 4.0);
                for (x, y) in (-3..=3).flat_map(|y| (-3..=3).map(move |x| (x, y))) {
                    let there = best.0 + step * DVec2::new(f64::from(x), f64::from(y));
                    let value = place.probing(there).number(of);
                    values.extend(value.ok().map(|value| (there, value)));
                }
                single(values, sign, tolerance)
            }
            Self::Zero(of) => {
                let values = grid(place, of)?;
                let step = 1.5 / TRIED as f64;
                let side = |holds: fn(f64) -> bool| values.iter().filter(move |(_, v)| holds(*v));
                let mut places = Vec::new();
                for (a, over) in side(|value| value > 0.0) {
                    for (b, under) in side(|value| value <= 0.0) {
                        if a.distance(*b) < step {
                            places.push(crossing(place, of, [(*a, *over), (*b, *under)]));
                        }
                    }
                }
                if places.is_empty() {
                    return Err(text!("lesson-no-zero").to_owned());
                }
                let near = |p: DVec2| places.iter().any(|place| place.distance(p) <= tolerance);
                let covered = values.iter().filter(|(p, _)| near(*p)).count();
                if 2 * covered > values.len() {
                    return Err(text!("lesson-point-anywhere").to_owned());
                }
                // The one that is shown as the right one is typical: not an end of the curve, at the object's outline.
                let middle = places.iter().sum::<DVec2>() / places.len() as f64;
                let off = |place: &DVec2| place.distance_squared(middle);
                places.sort_by(|a, b| off(a).total_cmp(&off(b)));
                Ok(places)
            }
        }
    }
}

/// Finds where an expression is zero, or jumps over zero, between a place where it is above and one where it is not.
fn crossing(place: LabPlace<'_>, of: &Expression, ends: [(DVec2, f64); 2]) -> DVec2 {
    let [mut over, mut under] = ends;
    for _ in 0..HALVINGS {
        let middle = over.0.midpoint(under.0);
        match place.probing(middle).number(of) {
            Ok(value) if value > 0.0 => over = (middle, value),
            Ok(value) => under = (middle, value),
            // Beside the object.
            Err(_) => break,
        }
    }
    // In so short a way a curve is straight.
    over.0.lerp(under.0, over.1 / (over.1 - under.1))
}

/// Evaluates an expression at places all over the object.
fn grid(place: LabPlace<'_>, of: &Expression) -> Result<Vec<(DVec2, f64)>, String> {
    let size = place.size();
    let half = size / size.min_element() / 2.0;
    let step = 1.0 / TRIED as f64;
    let count = (half / step).ceil();
    let linear = place.linear()?;
    let width = place.scene().image.size[0] as usize;
    let (mut values, mut failure) = (Vec::new(), None);
    for row in -(count.y as i32)..=count.y as i32 {
        for column in -(count.x as i32)..=count.x as i32 {
            let at = step * DVec2::new(f64::from(column), f64::from(row));
            let Some([x, y]) = place.pixel(at) else {
                continue;
            };
            let index = y as usize * width + x as usize;
            if linear.get(index).is_none_or(|pixel| pixel[3] == 0.0) {
                continue;
            }
            match place.probing(at).number(of) {
                Ok(value) => values.push((at, value)),
                Err(words) => failure = Some(words),
            }
        }
    }
    match failure {
        Some(words) if values.is_empty() => Err(words),
        _ if values.is_empty() => Err(text!("lesson-no-object").to_owned()),
        _ => Ok(values),
    }
}

/// Finds the place of the largest value, which no place far away comes near.
fn single(values: Vec<(DVec2, f64)>, sign: f64, tolerance: f64) -> Result<Vec<DVec2>, String> {
    let greatest = values.iter().map(|(_, value)| sign * value);
    let greatest = greatest.fold(f64::NEG_INFINITY, f64::max);
    let least = values.iter().map(|(_, value)| sign * value);
    let least = least.fold(f64::INFINITY, f64::min);
    let best = values.iter().find(|(_, value)| sign * value >= greatest);
    let best = best.ok_or_else(|| text!("lesson-no-object").to_owned())?.0;
    let nearly = greatest - 0.02 * (greatest - least);
    let alike = values
        .iter()
        .any(|(p, value)| sign * value >= nearly && p.distance(best) > 2.0 * tolerance);
    if alike {
        return Err(text!("lesson-point-alike").to_owned());
    }
    Ok(vec![best])
}

/// Finds the pixel of the object with the largest or, with the sign −1, the smallest luminance.
fn brightest(place: LabPlace<'_>, sign: f64, tolerance: f64) -> Result<Vec<DVec2>, String> {
    let width = place.scene().image.size[0] as usize;
    let values = place
        .linear()?
        .iter()
        .enumerate()
        .filter(|(_, pixel)| pixel[3] > 0.0)
        .map(|(index, &[r, g, b, _])| {
            let at = [(index % width) as u32, (index / width) as u32];
            let value = luminance(Rgb::new(r.into(), g.into(), b.into()));
            (place.place_of(at), value)
        })
        .collect();
    single(values, sign, tolerance)
}

/// Finds the place on the line where the slope jumps most.
fn corner(place: LabPlace<'_>, mode: ShadingMode, tolerance: f64) -> Result<Vec<DVec2>, String> {
    let profile = place.profile(&[mode])?;
    let size = place.size();
    let values: Vec<(DVec2, f64)> = profile
        .borders
        .iter()
        .zip(&profile.traces[0].corners)
        .filter(|(border, _)| border.faces.iter().all(Option::is_some))
        .filter_map(|(border, corner)| {
            let at = pixel_to_place(DVec2::new(border.x, border.y), size);
            corner.as_ref().map(|corner| (at, corner.jump.abs()))
        })
        .collect();
    if values.is_empty() {
        return Err(text!("lesson-no-corner").to_owned());
    }
    single(values, 1.0, tolerance)
}
