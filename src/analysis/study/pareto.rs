//! Which points nothing else beats in both error and time.

/// For each pair (time, error) whether no other is at least as small in both and smaller in one: the front of Pareto.
/// Pairs with a value that is no number are not on it; of equal ones all are.
pub fn pareto_front(points: &[[f64; 2]]) -> Vec<bool> {
    let mut order: Vec<usize> =
        (0..points.len()).filter(|&i| points[i].iter().all(|value| value.is_finite())).collect();
    order.sort_by(|&a, &b| points[a][0].total_cmp(&points[b][0]).then(points[a][1].total_cmp(&points[b][1])));
    let mut front = vec![false; points.len()];
    let mut last = [f64::NAN, f64::INFINITY];
    for index in order {
        let point = points[index];
        if point[1] < last[1] || point == last {
            front[index] = true;
            last = point;
        }
    }
    front
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_what_nothing_beats() {
        let points =
            [[1.0, 9.0], [2.0, 5.0], [2.0, 6.0], [3.0, 5.0], [4.0, 1.0], [4.0, 1.0], [9.0, 2.0], [0.1, f64::NAN]];
        assert_eq!(pareto_front(&points), [true, true, false, false, true, true, false, false]);
        assert!(pareto_front(&[]).is_empty());
    }
}
