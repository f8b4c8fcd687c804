//! Moduli of a stress-strain curve, and their scatter over samples.

use crate::wire::{Unit, Wire, published};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// One sample's curve. Its first point is the first result: the block at rest under its own weight.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// Points in the order of the load.
    pub points: Vec<CurvePoint>,
}

/// One load step at rest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CurvePoint {
    /// Mean stress under the block [Pa], compression positive.
    pub stress: f64,
    /// Sinking over the height at the first result.
    pub strain: f64,
    /// Sinking since the first result [m].
    pub displacement: f64,
}

/// Mean and scatter over samples.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Mean.
    pub mean: f64,
    /// Standard deviation of one sample; zero for one sample alone.
    pub standard_deviation: f64,
    /// Standard error of the mean: over packings where there are several, for squares of one packing are neighbours;
    /// otherwise over squares.
    pub standard_error: f64,
    /// Samples.
    pub count: usize,
}

impl Wire for Spread {
    fn wire(&self, unit: Unit) -> Value {
        let [mean, deviation, error] = [self.mean, self.standard_deviation, self.standard_error].map(unit.of);
        json!({ "mean": mean, "standard_deviation": deviation, "standard_error": error, "samples": self.count })
    }
}

published! {
    /// A multiple of the file's stiffness and the modulus there.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    pub struct At {
        /// Multiple.
        pub multiple: f64,
        /// Modulus [Pa].
        pub modulus: f64 [MPa],
    }
}

/// Moduli of one curve [Pa].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moduli {
    /// Mean of the slopes of the load steps.
    pub tangent: f64,
    /// Slope of the line of least squares, strain over stress.
    pub least_squares: f64,
    /// Slope from the first result to the last; the harmonic mean of the slopes of equal load steps.
    pub secant: f64,
    /// The same without the first load steps.
    pub late_secant: f64,
}

impl Curve {
    /// From stress [Pa] and sinking [m], over a height [m].
    pub fn new(path: &[[f64; 2]], height: f64) -> Curve {
        let point =
            |&[stress, displacement]: &[f64; 2]| CurvePoint { stress, strain: displacement / height, displacement };
        Curve { points: path.iter().map(point).collect() }
    }

    /// Its moduli; the later secant leaves out the first `ignored` steps. None where the sample does not get shorter in
    /// every step, or has fewer than two.
    pub fn moduli(&self, ignored: usize) -> Option<Moduli> {
        let slope = |a: &CurvePoint, b: &CurvePoint| (b.stress - a.stress) / (b.strain - a.strain);
        let slopes: Vec<f64> = self.points.windows(2).map(|pair| slope(&pair[0], &pair[1])).collect();
        if slopes.len() < 2 || slopes.iter().any(|s| !(*s > 0.0 && s.is_finite())) {
            return None;
        }
        let (first, last) = (self.points.first()?, self.points.last()?);
        let later = self.points.get(ignored).filter(|_| ignored < slopes.len())?;
        Some(Moduli {
            tangent: slopes.iter().sum::<f64>() / slopes.len() as f64,
            least_squares: self.least_squares(),
            secant: slope(first, last),
            late_secant: slope(later, last),
        })
    }

    /// Strain is what scatters, so its deviations are made least: the slope is that of strain over stress, turned over.
    fn least_squares(&self) -> f64 {
        let n = self.points.len() as f64;
        let mean = |of: fn(&CurvePoint) -> f64| self.points.iter().map(of).sum::<f64>() / n;
        let (stress, strain) = (mean(|p| p.stress), mean(|p| p.strain));
        let mixed: f64 = self.points.iter().map(|p| (p.stress - stress) * (p.strain - strain)).sum();
        let square: f64 = self.points.iter().map(|p| (p.stress - stress).powi(2)).sum();
        square / mixed
    }
}

impl Spread {
    /// Of values, each with the seed of its packing; seeds stand together.
    pub fn of(values: &[(u64, f64)]) -> Option<Spread> {
        let (mean, standard_deviation) = scatter(values.iter().map(|v| v.1))?;
        let of_squares = standard_deviation / (values.len() as f64).sqrt();
        let packings: Vec<f64> = values
            .chunk_by(|a, b| a.0 == b.0)
            .filter_map(|group| scatter(group.iter().map(|v| v.1)).map(|(mean, _)| mean))
            .collect();
        // Fewer than four packings say too little about their own scatter.
        let of_packings = scatter(packings.iter().copied()).filter(|_| packings.len() >= 4);
        let of_packings = of_packings.map_or(0.0, |(_, deviation)| deviation / (packings.len() as f64).sqrt());
        Some(Spread { mean, standard_deviation, standard_error: of_squares.max(of_packings), count: values.len() })
    }
}

/// Mean and standard deviation.
pub fn scatter(values: impl Iterator<Item = f64> + Clone) -> Option<(f64, f64)> {
    let count = values.clone().count();
    if count == 0 {
        return None;
    }
    let mean = values.clone().sum::<f64>() / count as f64;
    let squares: f64 = values.map(|v| (v - mean).powi(2)).sum();
    Some((mean, if count > 1 { (squares / (count - 1) as f64).sqrt() } else { 0.0 }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_has_one_modulus() {
        let path: Vec<[f64; 2]> = (0..=10).map(|k| [2.6e3 + 25e3 * f64::from(k), 1e-3 * f64::from(k)]).collect();
        let m = Curve::new(&path, 0.9).moduli(4).unwrap();
        for modulus in [m.tangent, m.least_squares, m.secant, m.late_secant] {
            assert!((modulus / (25e3 * 0.9 / 1e-3) - 1.0).abs() < 1e-12, "{m:?}");
        }
    }

    #[test]
    fn a_curve_that_stiffens() {
        // Steps of 10 kPa with strains 4, 2 and 1 thousandths: slopes 2.5, 5 and 10 MPa.
        let m = Curve::new(&[[0.0, 0.0], [1e4, 4e-3], [2e4, 6e-3], [3e4, 7e-3]], 1.0).moduli(1).unwrap();
        assert!((m.tangent / (17.5e6 / 3.0) - 1.0).abs() < 1e-12);
        assert!((m.secant / (30e3 / 7e-3) - 1.0).abs() < 1e-12);
        assert!((m.late_secant / (20e3 / 3e-3) - 1.0).abs() < 1e-12);
        assert!(m.secant < m.tangent);
        // A step in which nothing moves has no slope, and a curve of one step no average.
        assert_eq!(Curve::new(&[[0.0, 0.0], [1e4, 4e-3], [2e4, 4e-3]], 1.0).moduli(0), None);
        assert_eq!(Curve::new(&[[0.0, 0.0], [1e4, 4e-3]], 1.0).moduli(0), None);
    }

    #[test]
    fn scatter_of_samples_and_of_packings() {
        let s = Spread::of(&[(1, 1.0), (1, 3.0)]).unwrap();
        assert_eq!((s.mean, s.count), (2.0, 2));
        assert!((s.standard_deviation - 2f64.sqrt()).abs() < 1e-15 && (s.standard_error - 1.0).abs() < 1e-15);
        // Squares of one packing that agree with one another are no independent samples.
        let four: Vec<(u64, f64)> = (0..4).flat_map(|seed| (0..9).map(move |_| (seed, seed as f64))).collect();
        let s = Spread::of(&four).unwrap();
        assert!((s.standard_error - (5.0 / 3.0_f64).sqrt() / 2.0).abs() < 1e-12, "{s:?}");
        assert_eq!(Spread::of(&[]), None);
    }
}
