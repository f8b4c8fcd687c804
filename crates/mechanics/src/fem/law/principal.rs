//! From a trial stress to its principal stresses and back, tangent included.
//!
//! The laws are isotropic, so stress returns along the trial's own directions. Its tangent has two parts: how principal
//! stresses follow principal strains, and how directions turn (de Souza Neto, Perić, Owen 2008, appendix A).

use super::elastic::Elastic;
use super::response::Four;
use super::three::{Matrix, Three};

/// A trial stress in its principal directions.
pub(super) struct Principal {
    /// Principal stresses [Pa], the greatest first.
    pub(super) stress: Three,
    /// The two in the plane and the one across, `[a, b, z]`.
    own: Three,
    /// Which of `own` stands at each rank.
    rank: [usize; 3],
    /// Cosine and sine of twice the angle from x to `a`.
    double: [f64; 2],
}

impl Principal {
    pub(super) fn of(stress: &Four) -> Principal {
        let middle = 0.5 * (stress[0] + stress[1]);
        let half = 0.5 * (stress[0] - stress[1]);
        let radius = half.hypot(stress[3]);
        let double = if radius > 0.0 { [half / radius, stress[3] / radius] } else { [1.0, 0.0] };
        let own = [middle + radius, middle - radius, stress[2]];
        let rank = if own[2] > own[0] {
            [2, 0, 1]
        } else if own[2] > own[1] {
            [0, 2, 1]
        } else {
            [0, 1, 2]
        };
        Principal { stress: rank.map(|i| own[i]), own, rank, double }
    }

    /// Returned principal stresses and their tangent in the axes of the plane.
    pub(super) fn back(&self, elastic: &Elastic, stress: &Three, tangent: &Matrix) -> (Four, [[f64; 4]; 4]) {
        let mut place = [0; 3];
        for (rank, own) in self.rank.into_iter().enumerate() {
            place[own] = rank;
        }
        let [a, b, z] = place.map(|rank| stress[rank]);
        let [cos, sin] = self.double;
        let (middle, radius) = (0.5 * (a + b), 0.5 * (a - b));
        let returned = [middle + radius * cos, middle - radius * cos, z, radius * sin];

        let own: Matrix = place.map(|i| place.map(|j| tangent[i][j]));
        let size = self.own.iter().fold(0.0, |size: f64, s| size.max(s.abs()));
        let apart = self.own[0] - self.own[1];
        let turn = if apart > 1e-9 * size {
            elastic.shear() * (a - b) / apart
        } else {
            0.25 * (own[0][0] + own[1][1] - own[0][1] - own[1][0])
        };
        (returned, self.turned(&own, turn))
    }

    /// `Rᵀ T R`, where `R` gives the strains in the principal axes from those in the axes of the plane.
    fn turned(&self, own: &Matrix, turn: f64) -> [[f64; 4]; 4] {
        let [cos, sin] = self.double;
        let (cc, ss, half) = (0.5 * (1.0 + cos), 0.5 * (1.0 - cos), 0.5 * sin);
        let r = [[cc, ss, 0.0, half], [ss, cc, 0.0, -half], [0.0, 0.0, 1.0, 0.0], [-sin, sin, 0.0, cos]];
        let mut middle = [[0.0; 4]; 4];
        for i in 0..3 {
            for j in 0..4 {
                middle[i][j] = own[i][0] * r[0][j] + own[i][1] * r[1][j] + own[i][2] * r[2][j];
            }
        }
        middle[3] = r[3].map(|v| turn * v);
        std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| r[k][i] * middle[k][j]).sum()))
    }
}
