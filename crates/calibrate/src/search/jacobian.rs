//! Derivatives of the residuals with respect to the shares: the model's own where it offers them, else differences inside
//! the ranges.

use crate::parameter::Parameter;

/// Step of a difference, as a share of the range: rounding of the model (1e-10 is common for a solved balance) and
/// curvature (1e-8 relative for central differences) then disturb the derivative by about one part in a million.
pub const STEP: f64 = 1e-4;

/// Points about one share at which a difference is taken, and the factors of the residuals there; `None` is the point
/// itself.
type Stencil = Vec<(Option<f64>, f64)>;

/// Central inside, one-sided of the second order at the ends of the range.
fn stencil(share: f64, step: f64) -> Stencil {
    if share - step >= 0.0 && share + step <= 1.0 {
        return vec![(Some(share + step), 0.5 / step), (Some(share - step), -0.5 / step)];
    }
    let inward = if share < 0.5 { step } else { -step };
    let there = |k: f64| Some((share + k * inward).clamp(0.0, 1.0));
    vec![(None, -1.5 / inward), (there(1.0), 2.0 / inward), (there(2.0), -0.5 / inward)]
}

/// Columns of the Jacobian, one for each share, by differences over a step of that share. `residuals` gives the residuals at
/// shares, or an error that ends it; all points are asked for before the first error is returned, so that whoever collects them learns of all.
///
/// # Errors
/// The first error of `residuals`.
pub fn by_differences<E>(
    shares: &[f64],
    step: f64,
    residuals: impl Fn(&[f64]) -> Result<Vec<f64>, E>,
) -> Result<Vec<Vec<f64>>, E> {
    let column = |parameter: usize| -> Vec<(f64, Result<Vec<f64>, E>)> {
        let at = |share: Option<f64>| {
            let mut point = shares.to_vec();
            point[parameter] = share.unwrap_or(shares[parameter]);
            residuals(&point)
        };
        stencil(shares[parameter], step).into_iter().map(|(share, factor)| (factor, at(share))).collect()
    };
    let terms: Vec<_> = (0..shares.len()).map(column).collect();
    let sum = |terms: Vec<(f64, Result<Vec<f64>, E>)>| {
        let mut column: Vec<f64> = Vec::new();
        for (factor, residuals) in terms {
            let residuals = residuals?;
            column.resize(residuals.len(), 0.0);
            column.iter_mut().zip(&residuals).for_each(|(sum, r)| *sum += factor * r);
        }
        Ok(column)
    };
    terms.into_iter().map(sum).collect()
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
                Ok::<_, ()>(vec![x[0].powi(3), 2.0 * x[0]])
            };
            let columns = by_differences(&[share], STEP, cube).unwrap();
            // Error of the one-sided formula: step squared times the third derivative over three, 2e-8, and rounding 1e-12.
            assert!((columns[0][0] - 3.0 * share * share).abs() < 3e-8);
            assert!((columns[0][1] - 2.0).abs() < 1e-10);
        }
    }
}
