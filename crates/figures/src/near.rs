//! Means over what lies near: stresses of single particles are too uneven to be read.

use outcome::picture::Point;
use std::collections::BTreeMap;

/// A square cell of the plane.
type Cell = (i64, i64);

fn cell(p: Point, size: f64) -> Cell {
    ((p[0] / size).floor() as i64, (p[1] / size).floor() as i64)
}

/// Items by the square cells in which their points lie; points that are not finite are left out.
pub(crate) fn cells(points: &[Point], size: f64) -> BTreeMap<Cell, Vec<usize>> {
    let mut cells: BTreeMap<Cell, Vec<usize>> = BTreeMap::new();
    for (k, p) in points.iter().enumerate().filter(|(_, p)| p[0].is_finite() && p[1].is_finite()) {
        cells.entry(cell(*p, size)).or_default().push(k);
    }
    cells
}

/// For each point the weighted mean of the values at all points within `radius` of it, itself included.
pub(crate) fn means(points: &[Point], weights: &[f64], values: &[[f64; 3]], radius: f64) -> Vec<[f64; 3]> {
    let cells = cells(points, radius);
    let mean = |p: &Point| {
        let (mut sum, mut total) = ([0.0; 3], 0.0);
        let (i, j) = cell(*p, radius);
        let around = (-1..=1).flat_map(|di| (-1..=1).map(move |dj| (i.saturating_add(di), j.saturating_add(dj))));
        for k in around.filter_map(|c| cells.get(&c)).flatten().copied() {
            if (points[k][0] - p[0]).hypot(points[k][1] - p[1]) <= radius {
                total += weights[k];
                (0..3).for_each(|c| sum[c] += weights[k] * values[k][c]);
            }
        }
        sum.map(|s| s / total)
    };
    points.iter().map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_those_of_all_pairs() {
        let points: Vec<Point> =
            (0..200).map(|k| [(f64::from(k) * 0.37).sin() * 3.0, (f64::from(k) * 1.7).cos()]).collect();
        let weights: Vec<f64> = (0..200).map(|k| 1.0 + f64::from(k % 7)).collect();
        let values: Vec<[f64; 3]> = (0..200).map(|k| [f64::from(k), 1.0, -f64::from(k)]).collect();
        let found = means(&points, &weights, &values, 0.4);
        for (p, mean) in points.iter().zip(&found) {
            let near = (0..200).filter(|&k| (points[k][0] - p[0]).hypot(points[k][1] - p[1]) <= 0.4);
            let (sum, total) = near.fold((0.0, 0.0), |(s, t), k| (s + weights[k] * values[k][0], t + weights[k]));
            // The same numbers added in another order.
            assert!((mean[0] - sum / total).abs() < 1e-9 && (mean[1] - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn far_and_impossible_points_do_no_harm() {
        let points = [[0.0, 0.0], [1e300, 0.0], [f64::NAN, 0.0]];
        let found = means(&points, &[1.0; 3], &[[1.0; 3]; 3], 0.1);
        assert_eq!(found[0], [1.0; 3]);
    }
}
