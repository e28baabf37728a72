//! A curve that is drawn.

use super::kind::{AnyKind, Predictions, Printed, QuestionKind};
use super::shape::{distance, hint, pieces};
use crate::expression::Expression;
use crate::figure::Drawing;
use crate::figure::palette::Rgb8;
use crate::lesson::html::{Html, element};
use crate::lesson::read::keys::{KeyReader, Keys};
use crate::lesson::{CurveAxes, Hint, LabPlace, Prose};
use crate::scene::ShadingMode;
use crate::text::{fixed, text};

/// The number of points of a curve that are compared.
pub const CURVE_POINTS: usize = 65;

/// The largest distance of a right curve from the straight lines between its points, as a fraction of the axis' height, and how
/// often the way between two compared points is halved for it: a jump takes 1/2048 of the axis' width.
const STRAIGHT: f64 = 0.002;
const HALVINGS: u32 = 5;

/// The colours of curves on pages: of the right one, and of those of a class.
const BLACK: Rgb8 = [0; 3];
const RIGHT: Rgb8 = [0x2e, 0x7d, 0x43];
const WRONG: Rgb8 = [0xc2, 0x3a, 0x22];

/// A curve drawn over `x`.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The ends of the horizontal axis.
    pub x: [f64; 2],
    /// The ends of the vertical axis.
    pub y: [f64; 2],
    /// The quantity on the horizontal axis.
    pub x_name: Prose,
    /// The quantity on the vertical axis.
    pub y_name: Prose,
    /// The unit behind abscissae; may be empty.
    pub unit: String,
    /// The right curve.
    pub of: CurveOf,
    /// The largest distance from it that counts as right, in value and shape, as a fraction of `y`.
    pub tolerance: f64,
}

/// The curve that is to be drawn.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CurveOf {
    /// An expression in `x`.
    Expression(Expression),
    /// The intensity along the step's line in this mode.
    Profile(ShadingMode),
}

impl Curve {
    /// Returns whether enough of a curve is drawn: nine tenths of its points.
    pub fn is_whole(drawn: &[Option<f64>]) -> bool {
        10 * drawn.iter().flatten().count() >= 9 * CURVE_POINTS
    }

    /// Returns its axes as HTML with what `draw` draws over them.
    fn plot(&self, draw: impl FnOnce(&mut Drawing)) -> Html {
        let names = [&self.x_name, &self.y_name].map(Prose::plain);
        let axes = CurveAxes::new([self.x, self.y], [&names[0], &names[1]]);
        let mut drawing = axes.on_page();
        draw(&mut drawing);
        Html::made(drawing.to_svg(&axes.words()))
    }

    /// Returns how far a drawn curve is from another one.
    fn difference(&self, given: &[Option<f64>], model: &Vec<[f64; 2]>) -> f64 {
        let model = pieces(&Self::right(model), self.y);
        distance(&pieces(given, self.y), &model)
    }

    /// Evaluates the right curve at the points that are compared, and between them where it is bent.
    fn points(&self, place: LabPlace<'_>) -> Result<Vec<[f64; 2]>, String> {
        match &self.of {
            CurveOf::Expression(of) => self.drawn(&|x| place.over(x).number(of)),
            CurveOf::Profile(mode) => {
                let profile = place.profile(&[*mode])?;
                let (samples, trace) = (&profile.samples, &profile.traces[0].intensity);
                if samples.len() < 2 {
                    return Err(text!("line-error-no-length").to_owned());
                }
                let pairs = samples.iter().zip(trace);
                let taken: Vec<[f64; 2]> = pairs.map(|(sample, y)| [sample.t, *y]).collect();
                let [from, to] = self.x;
                self.drawn(&|x| Ok(ordinate(&taken, (x - from) / (to - from))))
            }
        }
    }

    /// Evaluates a curve at the points that are compared, and between them where it is bent.
    fn drawn(&self, at: &dyn Fn(f64) -> Result<f64, String>) -> Result<Vec<[f64; 2]>, String> {
        let mut curve: Vec<[f64; 2]> = Vec::new();
        for index in 0..CURVE_POINTS {
            let x = abscissa(self.x, index);
            let next = [x, at(x)?];
            match curve.last().copied() {
                None => curve.push(next),
                Some(last) => self.go_on(&mut curve, [last, next], HALVINGS, at),
            }
        }
        Ok(curve)
    }

    /// Draws a curve from one of its points, which is drawn, to another one.
    fn go_on(
        &self,
        curve: &mut Vec<[f64; 2]>,
        [start, end]: [[f64; 2]; 2],
        halvings: u32,
        at: &dyn Fn(f64) -> Result<f64, String>,
    ) {
        let [low, high] = self.y;
        let x = 0.5 * (start[0] + end[0]);
        let straight = 0.5 * (start[1] + end[1]);
        // Where there is no value in between, the straight line stands.
        match at(x) {
            Ok(y) if halvings > 0 && (y - straight).abs() > STRAIGHT * (high - low) => {
                self.go_on(curve, [start, [x, y]], halvings - 1, at);
                self.go_on(curve, [[x, y], end], halvings - 1, at);
            }
            _ => curve.push(end),
        }
    }
}

/// Returns the abscissa of a point that is compared, on an axis with these ends.
pub fn abscissa([from, to]: [f64; 2], index: usize) -> f64 {
    from + (to - from) * index as f64 / (CURVE_POINTS - 1) as f64
}

/// Returns the ordinate at an abscissa of a line through points, of which there is one at least.
pub fn ordinate(points: &[[f64; 2]], x: f64) -> f64 {
    let after = points.partition_point(|[at, _]| *at < x);
    let after = after.clamp(1, points.len().max(2) - 1);
    let [a, b] = [after - 1, after.min(points.len() - 1)].map(|index| points[index]);
    let share = ((x - a[0]) / (b[0] - a[0])).clamp(0.0, 1.0);
    if share.is_nan() {
        return b[1];
    }
    a[1] * (1.0 - share) + b[1] * share
}

impl AnyKind for Curve {
    fn axes(&self) -> Vec<&Prose> {
        vec![&self.x_name, &self.y_name]
    }

    fn is_drawn(&self) -> bool {
        true
    }

    fn follows_line(&self) -> bool {
        matches!(self.of, CurveOf::Profile(_))
    }
}

impl QuestionKind for Curve {
    /// The ordinates at [`CURVE_POINTS`] abscissae, evenly; nothing where none was drawn.
    type Answer = Vec<Option<f64>>;
    /// `[x, y]` at [`CURVE_POINTS`] abscissae, evenly, and between them where the curve is bent.
    type Solution = Vec<[f64; 2]>;

    const MODEL_KEYS: &[&str] = &["answer", "profile"];

    fn read(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Self> {
        let of = match (&keys.profile, &keys.answer) {
            (Some(mode), None) => CurveOf::Profile(reader.mode("profile", mode)?),
            (None, Some(_)) => CurveOf::Expression(reader.expression("answer", &keys.answer)?),
            _ => {
                reader.wrong(text!("lesson-curve-of"));
                return None;
            }
        };
        let own = matches!(of, CurveOf::Profile(_)).then_some([0.0, 1.0]);
        let x = reader.range("x", keys.x.or(own));
        let y = reader.range("y", keys.y.or(own));
        let tolerance = reader.positive("tolerance", keys.tolerance.or(Some(0.1)));
        let (x, y) = (x?, y?);
        Some(Self {
            x,
            y,
            x_name: reader.prose(keys.x_name.as_ref()),
            y_name: reader.prose(keys.y_name.as_ref()),
            unit: keys.unit.clone(),
            of,
            tolerance: tolerance?,
        })
    }

    fn solve(&self, place: LabPlace<'_>, _: u64) -> Result<Vec<[f64; 2]>, String> {
        let curve = self.points(place)?;
        let [low, high] = self.y;
        let inside = |value: f64| value >= low - 1e-9 && value <= high + 1e-9;
        if let Some([_, value]) = curve.iter().find(|[_, value]| !inside(*value)) {
            let value = fixed(*value, 4);
            return Err(text!("lesson-curve-outside", value = value));
        }
        let compared = Self::right(&curve);
        let mean = compared.iter().flatten().sum::<f64>() / CURVE_POINTS as f64;
        let level = vec![Some(mean); CURVE_POINTS];
        if self.difference(&level, &curve) <= self.tolerance {
            return Err(text!("lesson-curve-flat").to_owned());
        }
        Ok(curve)
    }

    /// Evaluates the curve of a wrong model, as far as it can be drawn.
    fn solve_wrong(&self, place: LabPlace<'_>, _: u64) -> Result<Vec<[f64; 2]>, String> {
        let [low, high] = self.y;
        let curve = self.points(place)?.into_iter();
        Ok(curve.map(|[x, y]| [x, y.clamp(low, high)]).collect())
    }

    fn right(right: &Vec<[f64; 2]>) -> Vec<Option<f64>> {
        let (Some(first), Some(last)) = (right.first(), right.last()) else {
            return vec![None; CURVE_POINTS];
        };
        let abscissae = (0..CURVE_POINTS).map(|index| abscissa([first[0], last[0]], index));
        abscissae.map(|x| Some(ordinate(right, x))).collect()
    }

    fn fits(&self, given: &Vec<Option<f64>>) -> bool {
        // The pen can leave the axes a little.
        let [low, high] = self.y;
        let around = low - (high - low)..=high + (high - low);
        let mut drawn = given.iter().flatten();
        given.len() == CURVE_POINTS && drawn.all(|value| around.contains(value))
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Returns the distance of two curves in value and shape; none where too little was drawn.
    fn distance(
        &self,
        given: &Vec<Option<f64>>,
        model: &Vec<[f64; 2]>,
        _: LabPlace<'_>,
    ) -> Option<f64> {
        let comparable = given.len() == CURVE_POINTS && Self::is_whole(given);
        comparable.then(|| self.difference(given, model))
    }

    fn fault(
        &self,
        given: &Vec<Option<f64>>,
        right: &Vec<[f64; 2]>,
        _: LabPlace<'_>,
    ) -> Option<Hint> {
        let right = pieces(&Self::right(right), self.y);
        Some(hint(&pieces(given, self.y), &right, [self.x, self.y]))
    }

    fn short(_: &Vec<Option<f64>>) -> String {
        "∿".to_owned()
    }

    fn words(&self, _: &Vec<Option<f64>>, _: &[String]) -> String {
        text!("course-answers-curve").to_owned()
    }

    fn solution_words(&self, _: &Vec<[f64; 2]>, _: &[String]) -> String {
        String::new()
    }

    fn blank(&self, _: &Printed<'_>, _: Option<&Vec<[f64; 2]>>) -> Result<Html, String> {
        let axes = element("figure").with(self.plot(|_| {}));
        Ok(Html::new().line(axes))
    }

    fn drawing(&self, right: &Vec<[f64; 2]>, _: &Printed<'_>) -> Result<Option<Html>, String> {
        let plot = self.plot(|drawing| {
            drawing.draw_curve(right.iter().copied(), 2.5, BLACK, 1.0);
        });
        Ok(Some(element("figure").with(plot).into()))
    }

    /// Returns every predicted curve, and over them the right one.
    fn chart(&self, class: &Predictions<'_, Vec<Option<f64>>, Vec<[f64; 2]>>) -> Html {
        let plot = self.plot(|drawing| {
            for (given, grade) in &class.given {
                let points = given.iter().enumerate();
                let points =
                    points.map(|(index, y)| [abscissa(self.x, index), y.unwrap_or(f64::NAN)]);
                let colour = if grade.right { RIGHT } else { WRONG };
                drawing.draw_curve(points, 1.4, colour, 0.55);
            }
            if let Some(right) = class.right {
                drawing.draw_curve(right.iter().copied(), 3.0, BLACK, 1.0);
            }
        });
        let caption = element("figcaption").with(text!("class-curves"));
        Html::new().line(element("figure").with(plot).with(caption))
    }
}
