//! What the data can tell of each parameter, from the sensitivities at one point: which parameters hardly show, which
//! show together, how many combinations are seen at all.
//!
//! Collinearity after Brun, Reichert and Künsch (2001, Water Resources Research 37(4), 1015-1030).

use faer::Mat;

use crate::basis::{Basis, Halt, answer};
use crate::evaluator::Evaluator;
use crate::forward::Response;
use crate::misfit::{residual_derivatives, residuals};
use crate::parameter::{shares, values};
use crate::search::jacobian::{by_differences, by_shares, points};
use serde::{Deserialize, Serialize};

/// Parameters taken together with their collinearity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Collinearity {
    /// The parameters.
    pub parameters: Vec<usize>,
    /// The index: one over the least singular value of their columns, each of length one. 1 where all act differently;
    /// at 10, a change of one can be compensated by the others down to a tenth.
    pub index: f64,
}

/// What the data can tell at a point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Identifiability {
    /// Derivatives of the residuals with respect to shares of the ranges, by parameter.
    pub sensitivities: Vec<Vec<f64>>,
    /// How many combinations of parameters are seen: singular values above a millionth of the largest, which is what
    /// differences resolve.
    pub rank: usize,
    /// Largest singular value over the least; infinite where there are fewer residuals than parameters.
    pub condition: f64,
    /// Collinearity of every set of two and more parameters, worst first.
    pub collinearities: Vec<Collinearity>,
    /// Whether a parameter is identifiable: it is not at a bound, it shows, and it is in no collinear pair.
    pub identifiable: Vec<bool>,
    /// All of it in words, one sentence each.
    pub words: Vec<String>,
}

/// Index from which a set of parameters is called collinear (Brun et al. give 10 to 15).
pub const COLLINEAR: f64 = 10.0;
/// Strength below which a parameter hardly shows: over its whole range it would move the norm by less than a hundredth.
pub const HARDLY_SHOWS: f64 = 0.01;
/// Relative singular value below which a combination is not seen.
const UNSEEN: f64 = 1e-6;
/// Sets of more parameters than these are not looked at one by one.
const SETS: usize = 10;

/// Looks at one point. Evaluates derivatives there, by differences over this step where the model offers none.
///
/// # Errors
/// A stop by the onlooker, or a model without an answer at the point or beside it.
pub fn identify(evaluator: &mut Evaluator, basis: &Basis, point: &[f64], step: f64) -> Result<Identifiability, Halt> {
    evaluator.stage = "sensitivities".into();
    let sensitivities = sensitivities(evaluator, basis, point, step)?;
    let names: Vec<String> = evaluator.problem.parameters().iter().map(|p| p.name.clone()).collect();
    let at_bound: Vec<bool> = evaluator.problem.parameters().iter().zip(point).map(|(p, v)| p.at_bound(*v)).collect();
    Ok(judge(sensitivities, at_bound, &names))
}

/// Derivatives of the residuals with respect to shares, by parameter, in the order of [`residuals`].
///
/// # Errors
/// A stop by the onlooker, or a model without an answer at the point or beside it.
pub fn sensitivities(
    evaluator: &mut Evaluator,
    basis: &Basis,
    point: &[f64],
    step: f64,
) -> Result<Vec<Vec<f64>>, Halt> {
    let problem = evaluator.problem;
    let values = |response: &Response| residuals(problem, &basis.held, response);
    let own = |response: &Response| residual_derivatives(problem, &basis.held, response);
    columns(evaluator, basis, (&shares(problem.parameters(), point), point), step, &values, &own)
}

/// Derivatives of any numbers of a response with respect to shares, by parameter, at shares and their point: from the model's own where it
/// offers them (`own`), else by differences of the numbers.
pub(crate) fn columns(
    evaluator: &mut Evaluator,
    basis: &Basis,
    (at, point): (&[f64], &[f64]),
    step: f64,
    numbers: &dyn Fn(&Response) -> Vec<f64>,
    own: &dyn Fn(&Response) -> Vec<Vec<f64>>,
) -> Result<Vec<Vec<f64>>, Halt> {
    let problem = evaluator.problem;
    if evaluator.forward.has_sensitivities(&basis.samples) {
        let response = answer(evaluator, point, &basis.request(true))?;
        return Ok(by_shares(problem.parameters(), at, own(&response)));
    }
    let wanted: Vec<Vec<f64>> = points(at, step).iter().map(|at| values(problem.parameters(), at)).collect();
    let answers = evaluator.respond(&wanted, &basis.request(false))?;
    let found = answers.iter().map(|answer| match answer.as_ref() {
        Ok(response) => Ok(numbers(response)),
        Err(failure) => Err(Halt::Failed(failure.clone())),
    });
    Ok(by_differences(at, step, found.collect::<Result<Vec<_>, _>>()?))
}

/// Judges columns of sensitivities, one for each of `names`.
pub fn judge(sensitivities: Vec<Vec<f64>>, at_bound: Vec<bool>, names: &[String]) -> Identifiability {
    let n = sensitivities.len();
    let length = |column: &Vec<f64>| column.iter().map(|value| value * value).sum::<f64>().sqrt();
    // Change of the residuals when a parameter moves over its range, at the rate found here.
    let strengths: Vec<f64> = sensitivities.iter().map(length).collect();
    let mut singular_values = singular_values(&sensitivities);
    singular_values.resize(n, 0.0);
    let largest = singular_values.first().copied().unwrap_or(0.0);
    let rank = singular_values.iter().filter(|value| **value > UNSEEN * largest).count();
    let least = singular_values.last().copied().unwrap_or(0.0);
    let condition = if least > 0.0 { largest / least } else { f64::INFINITY };
    let collinearities = collinearities(&sensitivities, &strengths);
    let shows = |k: usize| strengths[k] >= HARDLY_SHOWS;
    let paired = |k: usize| {
        let pairs = collinearities.iter().filter(|set| set.parameters.len() == 2 && set.index >= COLLINEAR);
        pairs.flat_map(|set| &set.parameters).any(|parameter| *parameter == k)
    };
    let identifiable: Vec<bool> = (0..n).map(|k| !at_bound[k] && shows(k) && !paired(k)).collect();
    let words = words(rank, &strengths, &at_bound, &collinearities, names);
    Identifiability { sensitivities, rank, condition, collinearities, identifiable, words }
}

/// Singular values of a matrix given by columns, largest first; none where it is empty or not finite.
fn singular_values(columns: &[Vec<f64>]) -> Vec<f64> {
    let rows = columns.first().map_or(0, Vec::len);
    let sound = rows > 0 && columns.iter().all(|column| column.len() == rows && column.iter().all(|v| v.is_finite()));
    if !sound {
        return Vec::new();
    }
    let matrix = Mat::from_fn(rows, columns.len(), |i, j| columns[j][i]);
    matrix.singular_values().unwrap_or_default()
}

fn collinearities(columns: &[Vec<f64>], strengths: &[f64]) -> Vec<Collinearity> {
    let n = columns.len();
    let sets: Vec<Vec<usize>> = if n <= SETS {
        (1_u32..1 << n)
            .filter(|set| set.count_ones() > 1)
            .map(|set| (0..n).filter(|k| set >> k & 1 == 1).collect())
            .collect()
    } else {
        (0..n).flat_map(|a| (a + 1..n).map(move |b| vec![a, b])).collect()
    };
    let index = |parameters: Vec<usize>| {
        // A column of zeros has no direction: its set is told by its strength.
        if parameters.iter().any(|k| !(strengths[*k] > 0.0)) {
            return None;
        }
        let unit: Vec<Vec<f64>> =
            parameters.iter().map(|k| columns[*k].iter().map(|value| value / strengths[*k]).collect()).collect();
        let values = singular_values(&unit);
        let least = if values.len() < parameters.len() { 0.0 } else { values.last().copied().unwrap_or(0.0) };
        Some(Collinearity { parameters, index: 1.0 / least })
    };
    let mut all: Vec<Collinearity> = sets.into_iter().filter_map(index).collect();
    all.sort_by(|a, b| b.index.total_cmp(&a.index));
    all
}

fn words(
    rank: usize,
    strengths: &[f64],
    at_bound: &[bool],
    collinearities: &[Collinearity],
    names: &[String],
) -> Vec<String> {
    let mut words = Vec::new();
    let n = names.len();
    for k in 0..n {
        if at_bound[k] {
            words.push(format!("{} stands on a bound of its range and has not converged.", names[k]));
        }
        if !(strengths[k] >= HARDLY_SHOWS) {
            let strength = 100.0 * strengths[k];
            words.push(format!(
                "{} hardly shows: over its whole range, at the rate found here, it moves the residuals by {strength:.2} %.",
                names[k]
            ));
        }
    }
    for set in collinearities.iter().filter(|set| set.parameters.len() == 2 && set.index >= COLLINEAR) {
        let [a, b] = [set.parameters[0], set.parameters[1]].map(|k| &names[k]);
        words.push(format!(
            "{a} and {b} act alike (collinearity {:.0}): the data determine a combination of them and neither alone.",
            set.index
        ));
    }
    if rank < n {
        words.push(format!("The data determine {rank} of {n} combinations of the parameters."));
    }
    let all = collinearities.iter().find(|set| set.parameters.len() == n && n > 2 && set.index >= COLLINEAR);
    if let Some(all) = all.filter(|_| rank == n) {
        words.push(format!(
            "Taken all together the parameters are collinear ({:.0}): changes of some can be compensated by others.",
            all.index
        ));
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(n: usize) -> Vec<String> {
        (0..n).map(|k| format!("p{k}")).collect()
    }

    #[test]
    fn independent_and_collinear_columns_are_told_apart() {
        let columns = vec![vec![1.0, 0.0, 0.0], vec![0.0, 2.0, 0.0], vec![0.0, 2.0, 0.01]];
        let found = judge(columns, vec![false; 3], &names(3));
        assert_eq!(found.rank, 3);
        let worst = &found.collinearities[0];
        // Two unit vectors at an angle a: the least singular value is sqrt(1 - cos a); here a = atan(0.005).
        let by_hand = 1.0 / (1.0 - (0.005_f64).atan().cos()).sqrt();
        let pair = found.collinearities.iter().find(|set| set.parameters == [1, 2]).unwrap();
        assert!((pair.index / by_hand - 1.0).abs() < 1e-6, "cancellation of 1e-5 in double precision");
        assert!(worst.index >= pair.index);
        assert_eq!(found.identifiable, [true, false, false]);
        assert!(found.words.iter().any(|line| line.contains("p1 and p2 act alike")));
    }

    #[test]
    fn fewer_residuals_than_parameters_and_silent_ones_are_said() {
        let found = judge(vec![vec![1.0], vec![0.5], vec![0.0]], vec![false, true, false], &names(3));
        assert_eq!((found.rank, found.condition), (1, f64::INFINITY));
        assert!(found.words.iter().any(|line| line.starts_with("The data determine 1 of 3")));
        assert!(found.words.iter().any(|line| line.starts_with("p2 hardly shows")));
        assert!(found.words.iter().any(|line| line.starts_with("p1 stands on a bound")));
    }
}
