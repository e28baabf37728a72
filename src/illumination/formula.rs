//! Formulas as straight-line code over any [`Real`].
//!
//! A typed [`Formula`] becomes a list of scalar operations. While the list is made, constants are folded, parts that occur
//! twice are shared, and each operation is noted with where its inputs change: what is known before a point
//! is looked at is evaluated at once. What nothing uses is dropped. The code then runs
//! over several groups of points at a time, operation by operation.

mod builder;
mod code;
mod compare;
mod function;
mod law;
mod lower;
mod operations;
mod program;
mod rate;

pub(crate) use builder::{Operation, Value};
pub(crate) use code::Code;
pub use compare::{Counterexample, Domain};
pub use function::{FormulaFunction, Outcome};
pub(super) use law::{Constancy, Law};
pub(crate) use law::{Incidence, LawPoint, LawScratch, lights_backs};
pub use law::{LawLine, LawLines, LawPart, LawValues, LineNumbers, Unneeded, law_operations};
pub(crate) use operations::{LawOperations, LawSite};
pub(crate) use program::GROUPS_TOGETHER;
pub use rate::Rate;

#[cfg(test)]
mod tests {
    use super::builder::{Builder, Value};
    use super::lower::{Inputs, Lowered, lower};
    use super::program::schedule;
    use super::rate::Rate;
    use crate::expression::{Formula, Names};

    /// A number x and a vector v, each a new input wherever it appears.
    struct Varying;

    impl Inputs for Varying {
        fn name(&mut self, builder: &mut Builder, index: usize) -> Lowered {
            let mut input = || builder.input(Rate::PointLight);
            match index {
                0 => Lowered::Number(input()),
                _ => Lowered::Vector([input(), input(), input()]),
            }
        }
    }

    /// Returns the number of scalar operations and of registers of a formula.
    fn size(text: &str) -> (usize, usize) {
        let names = Names::new(&["x"], &["v"]);
        let formula = Formula::read(text, &names).expect("a formula");
        let mut builder = Builder::default();
        let lines = lower(&mut builder, &formula, &mut Varying);
        let value = lines.last().and_then(Lowered::number);
        let program = schedule(&builder, &[vec![value.unwrap_or(Value::ZERO)]], &|_| {
            Some(0)
        });
        (program.sections[0].len(), program.registers)
    }

    #[test]
    fn each_of_256_operations_is_at_most_nine_scalar_ones_and_lines_do_not_multiply_them() {
        let lines = |first: &str, line: &str, last: &str| {
            // As many as 2000 characters and 256 operations allow.
            let count = (1900 / (line.len() + 3)).min(254);
            format!("a={first}\n{}{last}", format!("a={line}\n").repeat(count))
        };
        for text in [
            lines("x + x", "a*a", "a"),
            lines("x + x", "x^a", "a"),
            lines("x + x", "a != x", "a + 0"),
            lines("x + x", "tan(a)", "a"),
            lines("cross(v, v)", "cross(a, v)", "a.x"),
            lines("v + v", "mix(a, v, x)", "a.x"),
            lines("v + v", "normalize(a)", "a.x"),
            lines("x + x", "mix(a, x, a)", "a"),
            // Whether a root may be undefined depends on all lines before it.
            format!("a=abs(x)\n{}√(a)", "a=a*(a*abs(x))\n".repeat(84)),
            format!("a = x + x\n{}a", "a=smoothstep(x,a,a)\n".repeat(94)),
        ] {
            let lines = text.matches('\n').count();
            let (scalar, registers) = size(&text);
            assert!(
                (lines - 1..=9 * lines).contains(&scalar),
                "{scalar}: {text}"
            );
            // A value that no later line needs gives its register to another.
            assert!(registers <= 3 * 256 + 16, "{registers}: {text}");
        }
        // One call of many values is an operation for each of them.
        let many = format!("sum({}x)", "x,".repeat(995));
        assert_eq!(size(&many).0, 995);
    }

    #[test]
    fn a_value_less_itself_is_nothing() {
        assert_eq!(size("a = x*x\na - a").0, 0);
        assert_eq!(size("a = x*x\nx + (a - a)").0, 0);
        assert_eq!(size("a = cross(v, v)\na.x").0, 2);
        assert_eq!(size("a = 2*v\nb = cross(a, a)\nb.x").0, 0);
    }
}
