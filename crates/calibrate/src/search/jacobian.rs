//! Derivatives of the residuals with respect to the shares: the model's own where it offers them, else differences inside
//! the ranges.

use crate::parameter::Parameter;

/// Step of a difference, as a share of the range: rounding of the model (1e-10 is common for a solved balance) and
/// curvature (1e-8 relative for central differences) then disturb the derivative by about one part in a million.
pub const STEP: f64 = 1e-4;

/// Places about one share between which a difference is taken, and the factors of the residuals there: central inside, one-sided
/// of the second order at the ends of the range.
fn stencil(share: f64, step: f64) -> Vec<(f64, f64)> {
    if share - step >= 0.0 && share + step <= 1.0 {
        return vec![(share + step, 0.5 / step), (share - step, -0.5 / step)];
    }
    let inward = if share < 0.5 { step } else { -step };
    let there = |k: f64| (share + k * inward).clamp(0.0, 1.0);
    vec![(share, -1.5 / inward), (there(1.0), 2.0 / inward), (there(2.0), -0.5 / inward)]
}

/// Points at which the residuals are needed for differences over a step of each share.
pub fn points(shares: &[f64], step: f64) -> Vec<Vec<f64>> {
    let mut points = Vec::new();
    for (k, share) in shares.iter().enumerate() {
        for (there, _) in stencil(*share, step) {
            let mut point = shares.to_vec();
            point[k] = there;
            points.push(point);
        }
    }
    points
}

/// Columns of the Jacobian, one for each share, by differences of the residuals at [`points`], in their order.
pub fn by_differences(shares: &[f64], step: f64, residuals: impl IntoIterator<Item = Vec<f64>>) -> Vec<Vec<f64>> {
    let mut residuals = residuals.into_iter();
    let column = |share: &f64| {
        let mut column: Vec<f64> = Vec::new();
        for ((_, factor), residuals) in stencil(*share, step).into_iter().zip(&mut residuals) {
            column.resize(residuals.len(), 0.0);
            column.iter_mut().zip(&residuals).for_each(|(sum, r)| *sum += factor * r);
        }
        column
    };
    shares.iter().map(column).collect()
}

/// Turns derivatives with respect to values into such with respect to shares.
pub fn by_shares(parameters: &[Parameter], shares: &[f64], mut columns: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    for (k, column) in columns.iter_mut().enumerate() {
        let slope = parameters[k].slope(shares[k]);
        column.iter_mut().for_each(|value| *value *= slope);
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_of_second_order_everywhere_and_stay_inside() {
        for share in [0.0, 3e-5, 0.4, 1.0 - 3e-5, 1.0] {
            let cube = |x: &[f64]| {
                assert!((0.0..=1.0).contains(&x[0]));
                vec![x[0].powi(3), 2.0 * x[0]]
            };
            let columns = by_differences(&[share], STEP, points(&[share], STEP).iter().map(|x| cube(x)));
            // Error of the one-sided formula: step squared times the third derivative over three, 2e-8, and rounding 1e-12.
            assert!((columns[0][0] - 3.0 * share * share).abs() < 3e-8);
            assert!((columns[0][1] - 2.0).abs() < 1e-10);
        }
    }
}
