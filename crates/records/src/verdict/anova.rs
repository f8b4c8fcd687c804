//! Analysis of variance: of one way with repeats, and of blocks without.

use serde::{Deserialize, Serialize};
use statrs::distribution::{ContinuousCDF, FisherSnedecor, StudentsT};

/// An F test.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Test {
    /// Variance between groups over variance within.
    pub f: f64,
    /// Degrees of freedom, between and within.
    pub freedom: [f64; 2],
    /// Chance of such an F, or a larger one, where groups do not differ.
    pub p: f64,
    /// Standard deviation within groups, in the unit of the values.
    pub scatter: f64,
}

impl Test {
    fn new(between: f64, within: f64, freedom: [f64; 2]) -> Option<Test> {
        let distribution = FisherSnedecor::new(freedom[0], freedom[1]).ok()?;
        let f = if between == 0.0 { 0.0 } else { between / within };
        let p = if f.is_finite() { distribution.sf(f) } else { 0.0 };
        Some(Test { f, freedom, p, scatter: within.sqrt() })
    }

    /// In words: "F(2, 10) = 0.10, p = 0.91".
    pub fn words(&self) -> String {
        format!("F({:.0}, {:.0}) = {:.2}, p = {:.3}", self.freedom[0], self.freedom[1], self.f, self.p)
    }
}

/// One-way test of groups; None where no group has a repeat or there is but one group. Scatter is never taken smaller than
/// `floor`, the deviation that rounding alone makes: peaks that agree by rounding prove no precision.
pub(super) fn one_way(groups: &[Vec<f64>], floor: f64) -> Option<Test> {
    let groups: Vec<&Vec<f64>> = groups.iter().filter(|group| !group.is_empty()).collect();
    let count = groups.iter().map(|group| group.len()).sum::<usize>() as f64;
    let freedom = [groups.len() as f64 - 1.0, count - groups.len() as f64];
    if freedom[0] < 1.0 || freedom[1] < 1.0 {
        return None;
    }
    let grand = groups.iter().copied().flatten().sum::<f64>() / count;
    let (mut between, mut within) = (0.0, 0.0);
    for group in groups {
        let mean = mean(group);
        between += group.len() as f64 * (mean - grand).powi(2);
        within += group.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
    }
    Test::new(between / freedom[0], (within / freedom[1]).max(floor * floor), freedom)
}

/// Test of treatments (columns) in blocks (rows) with one value each; what is left after both is the scatter. None where
/// there are fewer than two of either.
pub(super) fn blocks(rows: &[Vec<f64>], floor: f64) -> Option<Test> {
    let (r, c) = (rows.len(), rows.first()?.len());
    if r < 2 || c < 2 || rows.iter().any(|row| row.len() != c) {
        return None;
    }
    let columns = columns(rows);
    let grand = mean(&columns);
    let between = r as f64 * columns.iter().map(|mean| (mean - grand).powi(2)).sum::<f64>();
    let rest = |row: &Vec<f64>| -> f64 {
        let own = mean(row);
        row.iter().zip(&columns).map(|(value, column)| (value - own - column + grand).powi(2)).sum()
    };
    let within: f64 = rows.iter().map(rest).sum();
    let freedom = [c as f64 - 1.0, ((r - 1) * (c - 1)) as f64];
    Test::new(between / freedom[0], (within / freedom[1]).max(floor * floor), freedom)
}

/// Half-width of an interval for a difference, from its standard error: the one that two one-sided tests at `level` use.
pub(super) fn half_width(error: f64, freedom: f64, level: f64) -> f64 {
    StudentsT::new(0.0, 1.0, freedom).map_or(f64::INFINITY, |t| t.inverse_cdf(1.0 - level)) * error
}

/// Mean of each column of some rows; none without a row.
pub(super) fn columns(rows: &[impl AsRef<[f64]>]) -> Vec<f64> {
    let count = rows.first().map_or(0, |row| row.as_ref().len());
    (0..count).map(|k| rows.iter().map(|row| row.as_ref()[k]).sum::<f64>() / rows.len() as f64).collect()
}

pub(super) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_way_as_in_the_textbook() {
        // Box, Hunter and Hunter, Statistics for Experimenters (1978), table 6.1: coagulation times of blood for four diets;
        // between 228/3, within 112/20, F = 13.6.
        let groups = [
            vec![62.0, 60.0, 63.0, 59.0],
            vec![63.0, 67.0, 71.0, 64.0, 65.0, 66.0],
            vec![68.0, 66.0, 71.0, 67.0, 68.0, 68.0],
            vec![56.0, 62.0, 60.0, 61.0, 63.0, 64.0, 63.0, 59.0],
        ];
        let test = one_way(&groups, 0.0).unwrap();
        assert_eq!(test.freedom, [3.0, 20.0]);
        assert!((test.f - 76.0 / 5.6).abs() < 1e-9);
        assert!((test.p - 4.658e-5).abs() < 1e-7, "{}", test.p);
    }

    #[test]
    fn blocks_of_two_columns_are_the_paired_t_test() {
        // F of two columns is the square of the paired t; its p is the two-sided one: checked by the t distribution.
        let rows = [vec![1.0, 1.5], vec![2.0, 2.1], vec![4.0, 4.9], vec![3.0, 3.2]];
        let test = blocks(&rows, 0.0).unwrap();
        let differences: Vec<f64> = rows.iter().map(|row| row[1] - row[0]).collect();
        let m = mean(&differences);
        let s = (differences.iter().map(|d| (d - m).powi(2)).sum::<f64>() / 3.0).sqrt();
        let t = m / (s / 2.0);
        assert!((test.f - t * t).abs() < 1e-9);
        let p = 2.0 * StudentsT::new(0.0, 1.0, 3.0).unwrap().sf(t);
        assert!((test.p - p).abs() < 1e-9);
    }

    #[test]
    fn quantiles_and_levels_of_printed_tables() {
        // t(10) at 0.95 is 1.8125, F(2, 10) at 0.95 is 4.1028.
        assert!((half_width(1.0, 10.0, 0.05) - 1.8125).abs() < 1e-4);
        let at = FisherSnedecor::new(2.0, 10.0).unwrap().sf(4.1028);
        assert!((at - 0.05).abs() < 1e-5);
    }

    #[test]
    fn too_few_values_are_no_test() {
        assert_eq!(one_way(&[vec![1.0], vec![2.0]], 0.0), None);
        assert_eq!(one_way(&[vec![1.0, 2.0]], 0.0), None);
        assert_eq!(blocks(&[vec![1.0, 2.0]], 0.0), None);
        // Repeats that agree to the last digit have the scatter of rounding.
        let test = one_way(&[vec![1.0, 1.0], vec![1.1, 1.1]], 0.1).unwrap();
        assert!((test.f - 1.0).abs() < 1e-9);
    }
}
