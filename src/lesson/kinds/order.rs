//! An order: things sorted from the least to the greatest.

use super::extreme::too_near;
use super::kind::{AnyKind, Predictions, Printed, QuestionKind};
use super::lettered::{Bars, letter, lettered, lettered_html};
use crate::expression::Expression;
use crate::lesson::html::{Element, Html, element};
use crate::lesson::page::picture;
use crate::lesson::read::keys::{KeyReader, Keys};
use crate::lesson::{Grade, Hint, LabPlace, Prose};
use crate::render::Frame;
use crate::text::{listed, text};

/// Most orders in the chart of a class.
const CHARTED: usize = 12;

/// Things to be sorted from the least to the greatest.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// The things, three to six.
    pub items: Vec<Item>,
    /// The quantity that they are sorted by, evaluated in the scene of each.
    pub by: Expression,
}

/// One of the things to be sorted.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Its text.
    pub text: Prose,
    /// Settings of its scene.
    pub set: Vec<String>,
}

impl AnyKind for Order {
    fn options(&self) -> Vec<&Prose> {
        self.items.iter().map(|item| &item.text).collect()
    }
}

impl QuestionKind for Order {
    /// The items by their numbers from 0, the least first.
    type Answer = Vec<usize>;
    type Solution = Vec<usize>;

    const MODEL_KEYS: &[&str] = &["by"];

    fn read(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Self> {
        let by = reader.expression("by", &keys.by);
        if !(3..=6).contains(&keys.item.len()) {
            reader.wrong(text!("lesson-items", least = 3, most = 6));
            return None;
        }
        let items = keys.item.iter();
        let items = items.map(|item| Item {
            text: reader.prose(Some(&item.text)),
            set: item.set.clone(),
        });
        Some(Self {
            items: items.collect(),
            by: by?,
        })
    }

    fn solve(&self, place: LabPlace<'_>, _: u64) -> Result<Vec<usize>, String> {
        let value = |item: &Item| place.under(&item.set)?.number(&self.by);
        let values: Result<Vec<f64>, String> = self.items.iter().map(value).collect();
        let values = values?;
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
        let near = |pair: &[usize]| too_near(values[pair[0]], values[pair[1]]);
        if order.windows(2).any(near) {
            return Err(text!("lesson-too-near").to_owned());
        }
        Ok(order)
    }

    fn right(right: &Vec<usize>) -> Vec<usize> {
        right.clone()
    }

    fn fits(&self, given: &Vec<usize>) -> bool {
        let mut sorted = given.clone();
        sorted.sort_unstable();
        sorted.into_iter().eq(0..self.items.len())
    }

    /// No pair may be in the wrong order.
    fn tolerance(&self) -> f64 {
        0.5
    }

    /// Counts the pairs that are in another order.
    fn distance(&self, given: &Vec<usize>, model: &Vec<usize>, _: LabPlace<'_>) -> Option<f64> {
        let rank = |item: &usize| model.iter().position(|known| known == item);
        let ranks: Option<Vec<usize>> = given.iter().map(rank).collect();
        let ranks = ranks.filter(|ranks| ranks.len() == model.len())?;
        let pairs = (0..ranks.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
        let wrong = pairs.filter(|(a, b)| ranks[*a] > ranks[*b]);
        Some(wrong.count() as f64)
    }

    /// Returns the item that is farthest from its place.
    fn fault(&self, given: &Vec<usize>, right: &Vec<usize>, _: LabPlace<'_>) -> Option<Hint> {
        let places = |at: usize, item: &usize| {
            let wanted = right.iter().position(|known| known == item)?;
            Some((*item, at.cast_signed() - wanted.cast_signed()))
        };
        let items = given.iter().enumerate();
        let items = items.filter_map(|(at, item)| places(at, item));
        let (item, places) = items.max_by_key(|(_, places)| places.unsigned_abs())?;
        Some(Hint::Item { item, places })
    }

    /// Grades an order; the score is the fraction of pairs that are in the right order.
    fn grade(
        &self,
        given: &Vec<usize>,
        right: &Vec<usize>,
        wrong: &[&Vec<usize>],
        place: LabPlace<'_>,
    ) -> Option<Grade> {
        let off = self.distance(given, right, place)?;
        let is_right = off == 0.0;
        let model = wrong.iter().position(|model| *model == given);
        let model = model.filter(|_| !is_right);
        let pairs = (right.len() * right.len().saturating_sub(1) / 2).max(1) as f64;
        let named = is_right || model.is_some();
        Some(Grade {
            right: is_right,
            score: if model.is_some() {
                0.0
            } else {
                1.0 - off / pairs
            },
            off: None,
            model,
            hint: self.fault(given, right, place).filter(|_| !named),
        })
    }

    fn short(given: &Vec<usize>) -> String {
        given.iter().map(|item| letter(*item)).collect()
    }

    fn words(&self, given: &Vec<usize>, options: &[String]) -> String {
        let items = given.iter().filter_map(|item| options.get(*item));
        listed(items.map(String::as_str))
    }

    fn solution_words(&self, right: &Vec<usize>, options: &[String]) -> String {
        let items: Vec<String> = right.iter().map(|item| lettered(*item, options)).collect();
        items.join(" < ")
    }

    /// The items have no pictures here: those would show the order.
    fn blank(&self, printed: &Printed<'_>, _: Option<&Vec<usize>>) -> Result<Html, String> {
        let items = printed.options.iter().enumerate();
        let items = items.map(|(index, words)| element("p").with(lettered_html(index, words)));
        let list = items.fold(element("div").class("items").broken(), Element::line);
        let blank = || element("span").class("blank short").into();
        let blanks = separated(self.items.iter().map(|_| blank()), " < ");
        Ok(Html::new().line(list).line(element("p").with(blanks)))
    }

    /// Shows the items in the right order, with their pictures.
    fn drawing(&self, right: &Vec<usize>, printed: &Printed<'_>) -> Result<Option<Html>, String> {
        let mut list = element("div").class("items").broken();
        for index in right {
            let (Some(item), Some(words)) = (self.items.get(*index), printed.options.get(*index))
            else {
                continue;
            };
            let mut figure = element("figure");
            if !item.set.is_empty() {
                let settings: Vec<String> = printed.set.iter().chain(&item.set).cloned().collect();
                let small = thumbnail(&printed.picture_under(&settings)?);
                figure = figure.with(picture(&small, words));
            }
            list = list.line(figure.with(element("p").with(lettered_html(*index, words))));
        }
        let order: Vec<String> = right
            .iter()
            .map(|index| letter(*index).to_string())
            .collect();
        let order = element("p").with(order.join(" < "));
        Ok(Some(Html::new().line(order).line(list)))
    }

    fn chart(&self, class: &Predictions<'_, Vec<usize>, Vec<usize>>) -> Html {
        let orders = class.counted().into_iter().take(CHARTED);
        let bars = orders.fold(Bars::new(class.given.len()), |bars, (order, count)| {
            bars.with(Self::short(order), count, class.right == Some(order))
        });
        let items = class.options.iter().enumerate();
        let items = items.map(|(item, words)| lettered_html(item, words));
        let items = element("p").class("quiet").with(separated(items, " · "));
        bars.table().line(items)
    }
}

/// Returns pieces with a sign between them.
fn separated(pieces: impl Iterator<Item = Html>, sign: &str) -> Html {
    let pieces = pieces.enumerate();
    let behind = |(index, piece): (usize, Html)| {
        let before = if index == 0 { "" } else { sign };
        Html::from(before).with(piece)
    };
    pieces.map(behind).collect()
}

/// Returns every other pixel of every other row.
fn thumbnail(frame: &Frame) -> Frame {
    let (width, height) = (frame.width.div_ceil(2), frame.height.div_ceil(2));
    let row = |y: u32| {
        (0..width).filter_map(move |x| frame.pixels.get((2 * y * frame.width + 2 * x) as usize))
    };
    Frame {
        width,
        height,
        pixels: (0..height).flat_map(row).copied().collect(),
    }
}
