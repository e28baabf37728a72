//! Where a scene's own law loses digits, and the operation that loses them.
//!
//! At each pixel that shows the object the law is evaluated in `f32`, in `f64` and in 106 bits, at the points, normals and
//! lights of the renderer's own evaluation. A pixel is off where the sum of the lights' parts differs by more than half a code
//! value from that of 106 bits; `blame` then finds the operation.

mod blame;
mod report;
mod values;

use super::{HALF_A_CODE_VALUE, MARK};
use crate::expression::{Position, with_parentheses};
use crate::illumination::{BRIGHTEST, Equation, LawOperations, Real, SourcePart};
use crate::render::{Evaluation, Frame, Renderer};
use crate::scene::{Compare, ReflectionModel, Rgb, Scene};
use crate::text::text;
use blame::{Blame, Blamed};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use values::Values;

/// Rows that are examined between two looks at whether to go on.
const ROWS_TOGETHER: u32 = 8;

/// Colour of a pixel where an operation is undefined.
const UNDEFINED: [u8; 4] = [255, 170, 0, 255];

/// The stability of a scene's own law over its picture.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LawStability {
    /// The law.
    pub formula: String,
    /// Number of pixels examined, all that show the object.
    pub pixels: u64,
    /// Errors of the evaluation in `f32`.
    pub single: PrecisionError,
    /// Errors of the evaluation in `f64`.
    pub double: PrecisionError,
    /// Operations that lose digits in `f32`, those with the most pixels first.
    pub losses: Vec<LawOperation>,
    /// Operations that are undefined somewhere and count as 0 there, those with the most pixels first.
    pub undefined: Vec<LawOperation>,
    /// The picture, dimmed: pixels where digits are lost in magenta, pixels where an operation is undefined in orange.
    pub picture: Frame,
}

/// The errors of a number type.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PrecisionError {
    /// Number of pixels that are off by more than half a code value.
    pub off: u64,
    /// Maximum error, code values.
    pub error: f64,
}

/// An operation of the law, with the pixels where it loses digits or is undefined.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LawOperation {
    /// Its text in the law.
    pub operation: String,
    /// Line of the law, from 1.
    pub line: usize,
    /// Character of the line, from 1.
    pub column: usize,
    /// Number of pixels.
    pub pixels: u64,
    /// Maximum error at these pixels, code values; 0 for an undefined operation.
    pub error: f64,
    /// Condition number there: the factor by which the operation multiplies the relative error of an operand. It is infinite
    /// where the result is 0, and 0 for an undefined operation.
    pub condition: f64,
    /// The pixel of that error; the first pixel for an undefined operation.
    pub at: [u32; 2],
}

/// The law with the numbers of one material.
struct OfMaterial {
    operations: LawOperations,
    equation: Equation<f64>,
    /// The equation of the picture.
    single: Equation<f32>,
}

/// A pixel after its examination.
struct Examined {
    pixel: [u32; 2],
    /// Errors in `f32` and in `f64`, code values.
    errors: [f64; 2],
    blamed: Option<(Range<usize>, Blamed)>,
    undefined: Vec<Range<usize>>,
}

/// Examines the law of `scene` in its picture, until `goes_on` returns false for the share of the work done.
///
/// # Errors
/// A sentence, if the scene has no law of its own or its text is wrong.
pub fn law_stability(
    renderer: &mut Renderer,
    scene: &Scene,
    goes_on: &dyn Fn(f32) -> bool,
) -> Result<LawStability, String> {
    if scene.reflection.model != ReflectionModel::Formula {
        return Err(text!("engine-law-none").to_owned());
    }
    let scene = &Scene {
        compare: Compare::default(),
        ..scene.clone()
    };
    let mut picture = renderer.render(scene).clone();
    for pixel in &mut picture.pixels {
        let [r, g, b, a] = *pixel;
        *pixel = [r / 2, g / 2, b / 2, a];
    }
    let equations = renderer.shining_equations(scene);
    // As in the equation, a pattern's colour is a separate factor at each point.
    let has_pattern = equations.first().is_some_and(Equation::has_pattern);
    let operations = renderer.for_each_material(scene, |own| {
        let color = if has_pattern {
            Rgb::ONE
        } else {
            own.material.color
        };
        LawOperations::of(own, color)
    });
    let equations = equations.into_iter().zip(renderer.shining_equations(scene));
    let laws = operations.into_iter().zip(equations);
    let laws = laws.map(|(operations, (equation, single))| {
        operations.map(|operations| OfMaterial {
            operations,
            equation,
            single,
        })
    });
    let laws: Vec<OfMaterial> = laws
        .collect::<Result<_, _>>()
        .map_err(|error| error.to_string())?;
    let mut found = LawStability {
        formula: scene.reflection.formula.clone(),
        picture,
        ..LawStability::default()
    };
    let (renderer, divisor) = (&*renderer, renderer.report().divisor);
    let [width, height] = scene.image.size;
    for first in (0..height).step_by(ROWS_TOGETHER as usize) {
        if !goes_on(first as f32 / height as f32) {
            break;
        }
        let rows = first..height.min(first + ROWS_TOGETHER);
        let examine = |values: &mut Values, y: u32| -> Vec<Examined> {
            let evaluated = (0..width).filter_map(|x| Some(([x, y], renderer.evaluation(x, y)?)));
            evaluated
                .filter_map(|(pixel, evaluation)| {
                    let law = laws.get(evaluation.material)?;
                    Some(law.examine(pixel, &evaluation, divisor, values))
                })
                .collect()
        };
        let rows = rows.into_par_iter().map_init(Values::default, examine);
        let rows: Vec<Vec<Examined>> = rows.collect();
        rows.iter().flatten().for_each(|pixel| found.add(pixel));
    }
    for list in [&mut found.losses, &mut found.undefined] {
        list.sort_by_key(|operation| std::cmp::Reverse(operation.pixels));
    }
    Ok(found)
}

impl LawStability {
    fn add(&mut self, examined: &Examined) {
        let Examined {
            pixel,
            errors,
            blamed,
            undefined,
        } = examined;
        self.pixels += 1;
        for (precision, error) in [&mut self.single, &mut self.double].into_iter().zip(errors) {
            precision.off += u64::from(*error > HALF_A_CODE_VALUE);
            precision.error = precision.error.max(*error);
        }
        let [x, y] = pixel.map(|place| place as usize);
        let stored = y * self.picture.width as usize + x;
        let colour = match () {
            () if errors[0] > HALF_A_CODE_VALUE => Some(MARK),
            () if !undefined.is_empty() => Some(UNDEFINED),
            () => None,
        };
        if let (Some(stored), Some(colour)) = (self.picture.pixels.get_mut(stored), colour) {
            *stored = colour;
        }
        for span in undefined {
            note(&mut self.undefined, &self.formula, span, *pixel).pixels += 1;
        }
        if let Some((span, blamed)) = blamed {
            let operation = note(&mut self.losses, &self.formula, span, *pixel);
            operation.pixels += 1;
            if errors[0] > operation.error {
                operation.error = errors[0];
                operation.condition = blamed.condition;
                operation.at = *pixel;
            }
        }
    }
}

/// Returns the entry of the operation of a part of the formula, a new one at `pixel` if there is none.
fn note<'l>(
    list: &'l mut Vec<LawOperation>,
    formula: &str,
    span: &Range<usize>,
    pixel: [u32; 2],
) -> &'l mut LawOperation {
    let Position { line, column } = Position::of(formula, span.start);
    let operation = with_parentheses(formula, span.clone());
    let same = |known: &LawOperation| {
        (known.line, known.column) == (line, column) && known.operation == operation
    };
    if let Some(known) = list.iter().position(same) {
        return &mut list[known];
    }
    list.push_mut(LawOperation {
        operation: operation.to_owned(),
        line,
        column,
        pixels: 0,
        error: 0.0,
        condition: 0.0,
        at: pixel,
    })
}

/// Returns a factor as the equation takes it: 0 where it is not a number, and finite.
fn taken(factor: f64) -> f64 {
    if factor.is_nan() {
        0.0
    } else {
        factor.clamp(-BRIGHTEST, BRIGHTEST)
    }
}

impl OfMaterial {
    fn examine(
        &self,
        pixel: [u32; 2],
        evaluation: &Evaluation<'_>,
        divisor: f64,
        values: &mut Values,
    ) -> Examined {
        let parts = evaluation.points.iter().flat_map(|at| {
            let parts = self
                .equation
                .source_parts((at.point, at.normal), at.tint, at.reached);
            let share = at.weight / divisor;
            parts.into_iter().map(move |part| SourcePart {
                coefficients: part.coefficients.map(|coefficient| coefficient * share),
                ..part
            })
        });
        let parts: Vec<SourcePart> = parts.collect();
        let mut sums = [[0.0; 3]; 3];
        let mut undefined = vec![];
        for part in &parts {
            let factors = values.evaluate(&self.operations, part, &self.single);
            for (sums, factors) in sums.iter_mut().zip(factors) {
                for (channel, sum) in sums.iter_mut().enumerate() {
                    *sum += taken(factors[channel]) * part.coefficients[channel];
                }
            }
            self.add_undefined(&values.single, &mut undefined);
        }
        // How far a sum is beyond white is not seen.
        let [single, double, exact] = sums.map(|sums| sums.map(|sum| 255.0 * sum.clamp(-1.0, 1.0)));
        let error = |sums: [f64; 3]| {
            let apart = sums.into_iter().zip(exact).map(|(sum, exact)| sum - exact);
            apart.map(f64::abs).fold(0.0, f64::max)
        };
        let errors = [error(single), error(double)];
        let blamed = (errors[0] > HALF_A_CODE_VALUE)
            .then(|| self.blame(&parts, values))
            .flatten();
        Examined {
            pixel,
            errors,
            blamed,
            undefined,
        }
    }

    /// Adds the parts of the formula that have an operation undefined for `values`.
    fn add_undefined(&self, values: &[f32], undefined: &mut Vec<Range<usize>>) {
        for (_, operation) in self.operations.iter() {
            let Some(code) = operation.code else { continue };
            let [a, b, _] = operation.operands.map(|value| value.of(values, 0.0_f32));
            if self.operations.may_be_undefined(operation) && code.undefined(a, b).greater_than(0.0)
            {
                let span = self.operations.span(operation);
                if !undefined.contains(&span) {
                    undefined.push(span);
                }
            }
        }
    }

    /// Returns the part of the formula whose operation loses the most digits, of all sources' parts and channels.
    fn blame(&self, parts: &[SourcePart], values: &mut Values) -> Option<(Range<usize>, Blamed)> {
        let mut blame = Blame::new(&self.operations, parts.len());
        for part in parts {
            let [_, _, exact] = values.evaluate(&self.operations, part, &self.single);
            for (channel, factor) in exact.into_iter().enumerate() {
                let coefficient = 255.0 * part.coefficients[channel];
                // How far a part is beyond white is not seen: its error is measured in parts of its size.
                let size = (taken(factor) * part.coefficients[channel]).abs();
                blame.look(channel, coefficient / size.max(1.0), values);
            }
        }
        blame.result()
    }
}
