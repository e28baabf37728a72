//! The statistics of a test of right and wrong answers, before a course and after it: how hard each item is, how well it
//! tells the strong from the weak, how reliable the test is, and how much a class has gained.
//!
//! Only shares and sums are computed; no name is needed.

use super::class::{Given, Group};

/// The statistics of one test.
#[derive(Clone, Debug, PartialEq)]
pub struct TestStatistics {
    /// The number of students.
    pub students: usize,
    /// The mean fraction of right answers, from 0 to 1.
    pub mean: f64,
    /// The standard deviation of the fraction of right answers, over all students: with n in the denominator.
    pub deviation: f64,
    /// The reliability by formula 20 of Kuder and Richardson (1937), at most 1; none of fewer than two items, or where all
    /// students have the same score.
    pub kr20: Option<f64>,
    /// The items, in their order.
    pub items: Vec<ItemStatistics>,
}

/// The statistics of an item.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ItemStatistics {
    /// The fraction of right answers, from 0 (hard) to 1 (easy).
    pub difficulty: f64,
    /// The point-biserial correlation of the item with the score, the item included, from −1 to 1; none where all answers
    /// or all scores are alike.
    pub discrimination: Option<f64>,
}

impl TestStatistics {
    /// Computes the statistics from each student's items, true for a right answer.
    ///
    /// With p the fraction of right answers to an item, q = 1 − p, k items and σ² the variance of the scores,
    /// KR-20 = k/(k − 1)·(1 − Σpq/σ²), and r = (M₁ − M₀)/σ·√(pq), where M₁ and M₀ are the mean scores of those whose answer
    /// to the item is right or wrong.
    pub fn of(students: &[Vec<bool>]) -> Self {
        let items = students.iter().map(Vec::len).max().unwrap_or(0);
        let right = |student: &Vec<bool>, item: usize| student.get(item).copied().unwrap_or(false);
        let scores: Vec<f64> = students
            .iter()
            .map(|student| student.iter().filter(|right| **right).count() as f64)
            .collect();
        let mean = mean(&scores);
        let squares: Vec<f64> = scores.iter().map(|score| (score - mean).powi(2)).collect();
        let variance = self::mean(&squares);
        let item = |item: usize| {
            let of = |wanted: bool| -> Vec<f64> {
                let pairs = students.iter().zip(&scores);
                let chosen = pairs.filter(|(student, _)| right(student, item) == wanted);
                chosen.map(|(_, score)| *score).collect()
            };
            let [wrong, right] = [of(false), of(true)];
            let p = right.len() as f64 / students.len().max(1) as f64;
            let sound = !wrong.is_empty() && !right.is_empty() && variance > 0.0;
            let apart = self::mean(&right) - self::mean(&wrong);
            ItemStatistics {
                difficulty: p,
                discrimination: sound.then(|| apart / variance.sqrt() * (p * (1.0 - p)).sqrt()),
            }
        };
        let statistics: Vec<ItemStatistics> = (0..items).map(item).collect();
        let pq = |item: &ItemStatistics| item.difficulty * (1.0 - item.difficulty);
        let pq: f64 = statistics.iter().map(pq).sum();
        let k = items as f64;
        Self {
            students: students.len(),
            mean: mean / k.max(1.0),
            deviation: variance.sqrt() / k.max(1.0),
            kr20: (items > 1 && variance > 0.0).then(|| k / (k - 1.0) * (1.0 - pq / variance)),
            items: statistics,
        }
    }

    /// Computes the statistics of the first answers of a class: what a student knew before anything was shown. An answer
    /// that is missing is not right.
    pub fn of_group(group: &Group) -> Self {
        let right = |given: &Option<Given>| {
            let first = given.as_ref().and_then(|given| given.predicted);
            first.is_some_and(|grade| grade.right)
        };
        let students = group.students.iter();
        let rows: Vec<Vec<bool>> = students
            .map(|student| student.given.iter().map(right).collect())
            .collect();
        Self::of(&rows)
    }
}

/// Returns the average normalised gain of a class (Hake 1998), the part of what could be gained that was gained:
/// ⟨g⟩ = (post − pre)/(1 − pre), from the mean fractions of right answers; none if everything was right before.
pub fn normalised_gain(pre: f64, post: f64) -> Option<f64> {
    (pre < 1.0).then(|| (post - pre) / (1.0 - pre))
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reads a row of a printed table of ones and zeros.
    fn row(ones: &str) -> Vec<bool> {
        ones.bytes().map(|byte| byte == b'1').collect()
    }

    /// Rounds as printed with so many decimals.
    fn printed(value: f64, decimals: usize) -> String {
        format!("{value:.decimals$}")
    }

    /// K. Wuensch, East Carolina University, "The Kuder-Richardson 20" (core.ecu.edu/wuenschk/StatHelp/KR20.txt): ten
    /// students, ten items.
    const QUIZ: [&str; 10] = [
        "1111110110",
        "1011011101",
        "1111011001",
        "0010001000",
        "0000010010",
        "1110111111",
        "1101110111",
        "1111111101",
        "0101111101",
        "1101101110",
    ];

    #[test]
    fn reliability_is_that_of_a_published_quiz() {
        let rows: Vec<Vec<bool>> = QUIZ.into_iter().map(row).collect();
        let found = TestStatistics::of(&rows);
        let p: Vec<String> = found
            .items
            .iter()
            .map(|item| printed(item.difficulty, 1))
            .collect();
        let expected = [
            "0.7", "0.7", "0.6", "0.7", "0.6", "0.8", "0.7", "0.7", "0.5", "0.6",
        ];
        assert_eq!(p, expected);
        // The variance of the scores, 5.84, and the sum of p·q, 2.18, are printed there.
        assert_eq!(printed((10.0 * found.deviation).powi(2), 2), "5.84");
        let pq = found
            .items
            .iter()
            .map(|item| item.difficulty * (1.0 - item.difficulty));
        assert_eq!(printed(pq.sum(), 2), "2.18");
        let kr20 = found.kr20.expect("a reliability");
        assert!((kr20 - 10.0 / 9.0 * (1.0 - 2.18 / 5.84)).abs() < 1e-12);
        assert_eq!(printed(10.0 * found.mean, 1), "6.6");
    }

    /// C. Zaiontz, "Kuder and Richardson Formula 20", example 1 (real-statistics.com/reliability): twelve students, eleven
    /// questions, with the variance over all students; 0.738 is printed.
    #[test]
    fn reliability_is_that_of_a_published_example() {
        let rows = [
            "11111111111",
            "11111111010",
            "10111111100",
            "11101101100",
            "11111000100",
            "01101111000",
            "11110010000",
            "11111000000",
            "01011000010",
            "10010100000",
            "11100000000",
            "10010000000",
        ];
        let found = TestStatistics::of(&rows.map(row));
        let kr20 = found.kr20.expect("a reliability");
        assert_eq!(printed(kr20, 3), "0.738");
    }

    #[test]
    fn reliability_is_cronbachs_alpha_by_covariances() {
        // α = k/(k − 1)·(1 − Σσᵢᵢ/Σσᵢⱼ), with the covariances of all pairs of items.
        let rows: Vec<Vec<bool>> = QUIZ.into_iter().map(row).collect();
        let at = |student: usize, item: usize| f64::from(u8::from(rows[student][item]));
        let mean = |item: usize| (0..10).map(|student| at(student, item)).sum::<f64>() / 10.0;
        let covariance = |a: usize, b: usize| {
            let product = |student| (at(student, a) - mean(a)) * (at(student, b) - mean(b));
            (0..10).map(product).sum::<f64>() / 10.0
        };
        let own: f64 = (0..10).map(|item| covariance(item, item)).sum();
        let all: f64 = (0..100).map(|pair| covariance(pair / 10, pair % 10)).sum();
        let alpha = 10.0 / 9.0 * (1.0 - own / all);
        let kr20 = TestStatistics::of(&rows).kr20.expect("a reliability");
        assert!((kr20 - alpha).abs() < 1e-12, "{kr20} and {alpha}");
    }

    /// Returns a test in which the first item is answered as `item` says and the scores are these.
    fn with_scores(item: &[bool], scores: &[usize]) -> Vec<Vec<bool>> {
        let most = scores.iter().max().copied().unwrap_or(0);
        let pairs = item.iter().zip(scores);
        pairs
            .map(|(right, score)| {
                let further = score - usize::from(*right);
                let further = (0..most).map(|index| index < further);
                std::iter::once(*right).chain(further).collect()
            })
            .collect()
    }

    /// The documentation of `scipy.stats.pointbiserialr`: 0.8660254037844386 for 0, 0, 0, 1, 1, 1, 1 and the scores 0 to 6.
    #[test]
    fn discrimination_is_that_of_a_published_calculation() {
        let found = TestStatistics::of(&with_scores(&row("0001111"), &[0, 1, 2, 3, 4, 5, 6]));
        let r = found.items[0].discrimination.expect("a correlation");
        assert_eq!(printed(r, 15), "0.866025403784439");
    }

    /// Z. Bobbitt, "How to calculate point-biserial correlation in Python"
    /// (statology.org/point-biserial-correlation-python): 0.21816 is printed.
    #[test]
    fn discrimination_is_that_of_a_published_example() {
        let scores = [12, 14, 17, 17, 11, 22, 23, 11, 19, 8, 12];
        let found = TestStatistics::of(&with_scores(&row("01100010110"), &scores));
        let r = found.items[0].discrimination.expect("a correlation");
        assert_eq!(printed(r, 5), "0.21816");
    }

    /// J. D. Brown, "Point-biserial correlation coefficients", Shiken: JALT Testing & Evaluation SIG Newsletter 5(3), 2001,
    /// table 2: the mean 37.50, the standard deviation 8.29 and, with the rounded deviation, r = .91 and −.91.
    #[test]
    fn discrimination_is_that_of_a_published_table() {
        let scores = [50, 45, 45, 40, 35, 30, 30, 25];
        for (item, expected) in [("11110000", 0.91), ("00001111", -0.91)] {
            let found = TestStatistics::of(&with_scores(&row(item), &scores));
            let k = found.items.len() as f64;
            assert_eq!(printed(k * found.mean, 2), "37.50");
            assert_eq!(printed(k * found.deviation, 2), "8.29");
            let r = found.items[0].discrimination.expect("a correlation");
            assert!((r - expected).abs() < 0.01, "{r}");
        }
        let alike = TestStatistics::of(&with_scores(&row("11111111"), &scores));
        assert_eq!(alike.items[0].discrimination, None);
    }

    /// R. R. Hake, "Interactive-engagement versus traditional methods", Am. J. Phys. 66 (1998) 64–74, defines
    /// ⟨g⟩ = (%post − %pre)/(100 − %pre). The pretest of 9 of 29 and posttest of 17 of 29 that Savinainen and Scott discuss
    /// gain 8 of the 20 that were missing, 40 %.
    #[test]
    fn the_gain_is_the_part_of_what_was_missing() {
        let gain = normalised_gain(9.0 / 29.0, 17.0 / 29.0).expect("a gain");
        assert_eq!(printed(100.0 * gain, 0), "40");
        assert_eq!(normalised_gain(0.5, 0.25), Some(-0.5));
        assert_eq!(normalised_gain(1.0, 1.0), None);
    }

    #[test]
    fn nothing_is_claimed_where_nothing_can_be_known() {
        for rows in [
            vec![],
            vec![row("101")],
            vec![row("11"), row("11")],
            vec![row("1"), row("0")],
        ] {
            let found = TestStatistics::of(&rows);
            let one_item = rows.first().is_some_and(|row| row.len() == 1);
            assert_eq!(found.kr20, None, "{rows:?}");
            assert!(found.mean.is_finite() && found.deviation.is_finite());
            let alike = |item: &ItemStatistics| item.discrimination.is_none();
            assert_eq!(found.items.iter().all(alike), !one_item, "{rows:?}");
        }
    }
}
