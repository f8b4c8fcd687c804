//! Four-sided regions: points between four sides, and steps that grow.

use mechanics::plane::Vec2;

/// Points of a region, row by row from the bottom, each from left to right.
pub(super) type Points = Vec<Vec<Vec2>>;

/// Points between four sides by transfinite interpolation (Gordon and Hall). Bottom and top run to the right and have as many
/// points, left and right run up and have as many; corners are on two sides.
pub(super) fn between(bottom: &[Vec2], top: &[Vec2], left: &[Vec2], right: &[Vec2]) -> Points {
    let (columns, rows) = (bottom.len() - 1, left.len() - 1);
    let along = |side: &[Vec2], of: fn(Vec2) -> f64| -> Vec<f64> {
        let (first, last) = (of(side[0]), of(side[side.len() - 1]));
        side.iter().map(|p| (of(*p) - first) / (last - first)).collect()
    };
    let (ub, ut) = (along(bottom, |p| p.x), along(top, |p| p.x));
    let (vl, vr) = (along(left, |p| p.y), along(right, |p| p.y));
    let corners = [bottom[0], bottom[columns], top[0], top[columns]];
    (0..=rows)
        .map(|i| {
            (0..=columns)
                .map(|j| match (i, j) {
                    (0, _) => bottom[j],
                    (_, 0) => left[i],
                    _ if i == rows => top[j],
                    _ if j == columns => right[i],
                    _ => {
                        let v = vl[i] + (vr[i] - vl[i]) * 0.5;
                        let u = ub[j] + (ut[j] - ub[j]) * v;
                        let v = vl[i] + (vr[i] - vl[i]) * u;
                        let sides = bottom[j] * (1.0 - v) + top[j] * v + left[i] * (1.0 - u) + right[i] * u;
                        let [a, b, c, d] = corners;
                        sides - (a * ((1.0 - u) * (1.0 - v)) + b * (u * (1.0 - v)) + c * ((1.0 - u) * v) + d * (u * v))
                    }
                })
                .collect()
        })
        .collect()
}

/// Distances from 0 to `length` in steps that start with about `first` and grow by `growth` up to `most` [m].
pub(super) fn growing(length: f64, first: f64, growth: f64, most: f64) -> Vec<f64> {
    let mut steps: Vec<f64> = Vec::new();
    let (mut sum, mut step) = (0.0, first);
    while sum < length * (1.0 - 1e-9) {
        steps.push(step);
        sum += step;
        step = (step * growth).min(most.max(first));
    }
    // The last step may reach beyond: all shrink a little, or it is left out and all grow a little.
    if let Some(last) = steps.last().copied()
        && steps.len() > 1
        && sum - length > 0.5 * last
    {
        steps.pop();
        sum -= last;
    }
    let scale = length / sum;
    let mut at = 0.0;
    let mut distances = vec![0.0];
    for step in &steps {
        at += step * scale;
        distances.push(at);
    }
    if let Some(last) = distances.last_mut() {
        *last = length;
    }
    distances
}

/// Points at these distances from one point to another; the last distance is that of the other.
pub(super) fn spaced(from: Vec2, to: Vec2, distances: &[f64]) -> Vec<Vec2> {
    let length = distances.last().copied().unwrap_or(1.0);
    distances.iter().map(|d| if *d == length { to } else { from + (to - from) * (d / length) }).collect()
}
