//! Real roots of a polynomial in an interval.
//!
//! Between two neighbouring roots of its derivative a polynomial is monotone, so one change of sign brackets one root.
//! The derivative's roots are found the same way, down to the quadratic (C. Yuksel, High-Performance Polynomial Root
//! Finding for Graphics, 2022). The coefficients may be anything; a double root may be missed or found, depending on rounding.

/// The roots of a quartic in an interval, ascending.
pub struct Roots {
    values: [f64; 4],
    count: usize,
}

impl Roots {
    const NONE: Self = Self {
        values: [0.0; 4],
        count: 0,
    };

    pub fn as_slice(&self) -> &[f64] {
        &self.values[..self.count]
    }

    fn push(&mut self, root: f64) {
        if self.count < self.values.len() {
            self.values[self.count] = root;
            self.count += 1;
        }
    }
}

/// Returns the roots of x⁴ + c₂x² + c₁x + c₀ with `low` ≤ x ≤ `high`.
pub fn depressed_quartic(c2: f64, c1: f64, c0: f64, low: f64, high: f64) -> Roots {
    let value = |x: f64| ((x * x + c2) * x + c1) * x + c0;
    let slope = |x: f64| (4.0 * x * x + 2.0 * c2) * x + c1;
    let bend = |x: f64| 12.0 * x * x + 2.0 * c2;

    let mut bends = Roots::NONE;
    if c2 < 0.0 {
        let x = (-c2 / 6.0).sqrt();
        [-x, x]
            .into_iter()
            .filter(|x| low < *x && *x < high)
            .for_each(|x| bends.push(x));
    }
    let extrema = monotone_roots(slope, bend, &bends, low, high);
    monotone_roots(value, slope, &extrema, low, high)
}

/// Returns the roots of `f` in an interval that `turns` cut into pieces where it is monotone.
fn monotone_roots(
    f: impl Fn(f64) -> f64,
    df: impl Fn(f64) -> f64,
    turns: &Roots,
    low: f64,
    high: f64,
) -> Roots {
    let mut roots = Roots::NONE;
    let mut from = (low, f(low));
    for to in turns.as_slice().iter().copied().chain([high]) {
        let to = (to, f(to));
        if (from.1 < 0.0) != (to.1 < 0.0) {
            roots.push(bracketed_root(&f, &df, from, to));
        }
        from = to;
    }
    roots
}

/// Returns the root of `f` between two points where its sign differs, to the last digit: by Newton's iteration, halving the
/// bracket whenever that leaves it.
fn bracketed_root(
    f: impl Fn(f64) -> f64,
    df: impl Fn(f64) -> f64,
    from: (f64, f64),
    to: (f64, f64),
) -> f64 {
    /// The number of halvings that bring an interval of length 2 to the rounding of its ends.
    const STEPS: usize = 60;
    let (mut below, mut above) = if from.1 < 0.0 {
        (from.0, to.0)
    } else {
        (to.0, from.0)
    };
    let mut x = 0.5 * (below + above);
    for _ in 0..STEPS {
        let value = f(x);
        if value == 0.0 {
            return x;
        }
        if value < 0.0 {
            below = x;
        } else {
            above = x;
        }
        let newton = x - value / df(x);
        let next = if newton > below.min(above) && newton < below.max(above) {
            newton
        } else {
            0.5 * (below + above)
        };
        if (next - x).abs() <= f64::EPSILON * x.abs() {
            return next;
        }
        x = next;
    }
    x
}
