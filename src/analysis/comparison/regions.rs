//! The errors of a picture inside the outline, and those of the outline itself.

use super::{ErrorFigures, LinearPicture, error_figures_where};

/// How far a picture is from another, apart where both show the object and where one alone does. Linear intensity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RegionErrors {
    /// Over the pixels inside.
    pub interior: ErrorFigures,
    /// What 99 % of the pixels inside do not exceed, by the greatest |d| of their channels (nearest rank).
    pub percentile_99: f64,
    /// Pixels that show the object in one of the pictures only.
    pub outline_pixels: u64,
    /// Root of the mean of d² over them.
    pub outline_rms: f64,
}

/// The errors of `picture` against `reference`, which is as large. What is inside is what `inside` says, as far as both show
/// the object there.
pub fn region_errors(picture: LinearPicture<'_>, reference: LinearPicture<'_>, inside: &[bool]) -> RegionErrors {
    let count = picture.pixels.len().min(reference.pixels.len()).min(inside.len());
    let shows = |which: LinearPicture<'_>, index: usize| which.pixels[index][3] != 0.0;
    let interior = |index: usize| index < count && inside[index] && shows(picture, index) && shows(reference, index);
    let outline = error_figures_where(picture, reference, |index| shows(picture, index) != shows(reference, index));
    let differences = (0..count).filter(|index| interior(*index)).map(|index| {
        let pairs = picture.color(index).into_iter().zip(reference.color(index));
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    });
    RegionErrors {
        interior: error_figures_where(picture, reference, interior),
        percentile_99: percentile(differences.collect(), 0.99),
        outline_pixels: outline.pixels,
        outline_rms: outline.rms,
    }
}

/// The least of `values` that `share` of them do not exceed; 0 of none.
fn percentile(mut values: Vec<f64>, share: f64) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "far fewer pixels than 2⁵³")]
    let rank = (share * values.len() as f64).ceil() as usize;
    let index = rank.saturating_sub(1);
    if index >= values.len() {
        return 0.0;
    }
    *values.select_nth_unstable_by(index, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_percentile_is_of_nearest_rank() {
        let values: Vec<f64> = (1..=200).rev().map(f64::from).collect();
        assert_eq!(percentile(values.clone(), 0.99), 198.0);
        assert_eq!(percentile(values, 0.5), 100.0);
        assert_eq!((percentile(vec![7.0], 0.99), percentile(vec![], 0.99)), (7.0, 0.0));
    }

    #[test]
    fn inside_and_outline_are_told_apart() {
        let grey = |value: f32, seen: f32| [value, value, value, seen];
        let a = [grey(0.5, 1.0), grey(0.5, 1.0), grey(0.0, 0.0), grey(0.4, 1.0)];
        let b = [grey(0.25, 1.0), grey(0.0, 1.0), grey(0.5, 1.0), grey(0.0, 0.0)];
        let picture = |pixels| LinearPicture { width: 4, pixels, clamps: false };
        let errors = region_errors(picture(&a), picture(&b), &[true, false, true, true]);
        assert_eq!((errors.interior.pixels, errors.interior.rms, errors.percentile_99), (1, 0.25, 0.25));
        assert_eq!(errors.outline_pixels, 2);
        let expected = ((0.25 + f64::from(0.4_f32).powi(2)) / 2.0).sqrt();
        assert!((errors.outline_rms - expected).abs() < 1e-12);
    }
}
