//! A rail on its sleepers: an endless beam on equal springs, solved exactly.
//!
//! Between sleepers the rail is a beam without load of its own, so that its deflection is a cubic and a beam element from
//! sleeper to sleeper is exact; a wheel between two sleepers acts through the cubic's shape functions (R. D. Cook and others,
//! Concepts and Applications of Finite Element Analysis: consistent nodal loads of a beam). The beam is cut off where the
//! deflection has died away; it ends free, so that the sleepers' reactions add up to the load and to its moment.
//! Springs carry tension as well: the rail's uplift beside a wheel is less than the weight of the track.

use bridge::passage::Track;

/// Reactions of sleepers to a unit force anywhere on the rail.
#[derive(Debug, Clone, PartialEq)]
pub struct Rail {
    /// Distance between sleepers [m].
    spacing: f64,
    /// How many sleepers to each side take part.
    reach: usize,
    /// Reaction of the sleeper at each distance to a unit force on a sleeper.
    force: Vec<f64>,
    /// The same to a unit moment over the spacing.
    moment: Vec<f64>,
}

/// Characteristic lengths after which a deflection has died away: exp(-36) is less than a double's last digit.
const LENGTHS: f64 = 36.0;

/// On stiff springs a limp rail's moments fall by 2 - sqrt(3) from one sleeper to the next: 28 times is less than a double's
/// last digit.
const LEAST_REACH: usize = 28;

impl Rail {
    /// The rail of a track.
    pub fn new(track: &Track) -> Rail {
        let spacing = track.sleeper_spacing;
        let characteristic = (4.0 * track.rail_bending_stiffness / track.track_modulus).sqrt().sqrt();
        let reach = ((LENGTHS * characteristic / spacing).ceil() as usize).clamp(LEAST_REACH, 20_000);
        // Everything divided by the spring's stiffness, rotations multiplied by the spacing.
        let beam = track.rail_bending_stiffness / (spacing.powi(3) * track.track_modulus * spacing);
        let stiffness = factored(2 * reach + 1, beam);
        let middle = 2 * reach;
        let unit = |at: usize| {
            let mut load = vec![0.0; 2 * (2 * reach + 1)];
            load[at] = 1.0;
            solve(&stiffness, &mut load);
            load.iter().step_by(2).copied().collect()
        };
        Rail { spacing, reach, force: unit(middle), moment: unit(middle + 1) }
    }

    /// Sleepers that a unit force at `x` reaches, and their shares: the first one's number, counted from the sleeper at 0, and
    /// the shares from there on to the right.
    pub fn shares(&self, x: f64) -> (i64, Vec<f64>) {
        let cell = (x / self.spacing).floor();
        let xi = x / self.spacing - cell;
        let (left, right) = (1.0 - xi, xi);
        let shape =
            [left * left * (1.0 + 2.0 * xi), left * left * xi, right * right * (3.0 - 2.0 * xi), -right * right * left];
        let at = |of: &[f64], k: usize| of.get(k).copied().unwrap_or(0.0);
        let before = |of: &[f64], k: usize| k.checked_sub(1).map_or(0.0, |k| at(of, k));
        let shares = (0..2 * self.reach + 2)
            .map(|k| {
                shape[0] * at(&self.force, k)
                    + shape[1] * at(&self.moment, k)
                    + shape[2] * before(&self.force, k)
                    + shape[3] * before(&self.moment, k)
            })
            .collect();
        (cell as i64 - self.reach as i64, shares)
    }
}

/// Half the width of the band below the diagonal.
const BAND: usize = 3;

/// Cholesky's factor of the stiffness of a free beam on `sleepers` unit springs, row by row: the diagonal last.
fn factored(sleepers: usize, beam: f64) -> Vec<[f64; BAND + 1]> {
    let size = 2 * sleepers;
    let mut rows = vec![[0.0; BAND + 1]; size];
    let element = [[12.0, 6.0, -12.0, 6.0], [6.0, 4.0, -6.0, 2.0], [-12.0, -6.0, 12.0, -6.0], [6.0, 2.0, -6.0, 4.0]];
    for first in (0..size - 2).step_by(2) {
        for (i, row) in element.iter().enumerate() {
            for (j, value) in row.iter().enumerate().take(i + 1) {
                rows[first + i][BAND + j - i] += beam * value;
            }
        }
    }
    for sleeper in 0..sleepers {
        rows[2 * sleeper][BAND] += 1.0;
    }
    for i in 0..size {
        for j in i.saturating_sub(BAND)..=i {
            let mut sum = rows[i][BAND + j - i];
            for k in i.saturating_sub(BAND)..j {
                if k + BAND >= j {
                    sum -= rows[i][BAND + k - i] * rows[j][BAND + k - j];
                }
            }
            rows[i][BAND + j - i] = if i == j { sum.sqrt() } else { sum / rows[j][BAND] };
        }
    }
    rows
}

fn solve(rows: &[[f64; BAND + 1]], load: &mut [f64]) {
    for i in 0..load.len() {
        let mut sum = load[i];
        for k in i.saturating_sub(BAND)..i {
            sum -= rows[i][BAND + k - i] * load[k];
        }
        load[i] = sum / rows[i][BAND];
    }
    for i in (0..load.len()).rev() {
        let value = load[i] / rows[i][BAND];
        load[i] = value;
        for k in i.saturating_sub(BAND)..i {
            load[k] -= rows[i][BAND + k - i] * value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn track(rail: f64, modulus: f64, spacing: f64) -> Track {
        Track {
            rail_bending_stiffness: rail,
            track_modulus: modulus,
            sleeper_spacing: spacing,
            sleeper_breadth: 0.1,
            sleeper_length: 2.75,
            ballast_depth: 0.25,
            ballast_slope: 2.0,
            dead_load: 8e3,
            effective_width: None,
        }
    }

    #[test]
    fn reactions_balance_the_wheel_and_its_moment() {
        for (rail, modulus, spacing) in [(4.47e6, 30e6, 0.6), (0.5e6, 200e6, 0.8), (10e6, 5e6, 0.4), (1e4, 1e9, 1.0)] {
            let on = Rail::new(&track(rail, modulus, spacing));
            for x in [0.0, 0.1, 0.3, 0.59, -7.13, 12.34] {
                let (first, shares) = on.shares(x);
                let sum: f64 = shares.iter().sum();
                let moment: f64 = shares.iter().enumerate().map(|(k, r)| r * spacing * (first + k as i64) as f64).sum();
                // Rounding of a solution whose condition number is below 1e6.
                assert!((sum - 1.0).abs() < 1e-10, "{sum}");
                assert!((moment - x).abs() < 1e-9 * (1.0 + x.abs()), "{moment} {x}");
            }
        }
    }

    /// Sleepers close together are Zimmermann's continuous bed: p(x) = exp(-x/L) (cos x/L + sin x/L) / 2 L.
    #[test]
    fn close_sleepers_are_a_continuous_bed() {
        let spacing = 0.02;
        let on = Rail::new(&track(4.47e6, 30e6, spacing));
        let length = (4.0 * 4.47e6 / 30e6_f64).powf(0.25);
        let (first, shares) = on.shares(0.0);
        for (k, share) in shares.iter().enumerate() {
            let x = (spacing * (first + k as i64) as f64).abs() / length;
            let exact = spacing / (2.0 * length) * (-x).exp() * (x.cos() + x.sin());
            // The difference falls with the square of spacing over length: 5e-4 here.
            assert!((share - exact).abs() < 1e-3 * spacing / (2.0 * length), "{x} {share} {exact}");
        }
    }

    /// A limp rail is a continuous beam on rigid supports. Clapeyron's three moments with the load in the middle of a span:
    /// M = -3/8 / (5 - r) P s over the two supports beside it, less by r = 2 - sqrt(3) and of the other sign from each support to the next.
    #[test]
    fn a_limp_rail_lies_on_rigid_supports() {
        let on = Rail::new(&track(1.0, 1e9, 1.0));
        let (first, shares) = on.shares(0.5);
        let at = |n: i64| shares[(n - first) as usize];
        let r = 2.0 - 3f64.sqrt();
        let moment = 0.375 / (5.0 - r);
        // Springs give way by EI / k s^4 = 1e-9 of the span's bending.
        assert!((at(0) - (0.5 + moment * (1.0 + r))).abs() < 1e-6, "{}", at(0));
        assert!((at(1) - at(0)).abs() < 1e-9);
        assert!((at(2) + moment * (1.0 + r) * (1.0 + r)).abs() < 1e-6, "{}", at(2));
        assert!((at(3) - r * moment * (1.0 + r) * (1.0 + r)).abs() < 1e-6, "{}", at(3));
    }

    /// A wheel that moves on by a spacing moves the reactions on by one sleeper.
    #[test]
    fn the_track_is_the_same_everywhere() {
        let on = Rail::new(&track(4.47e6, 30e6, 0.6));
        let (first, shares) = on.shares(0.2);
        let (next, later) = on.shares(0.2 + 0.6);
        assert_eq!(next, first + 1);
        // Rounding of the position alone.
        assert!(shares.iter().zip(&later).all(|(a, b)| (a - b).abs() < 1e-12));
        // And it is its own mirror image.
        let (first, mirrored) = on.shares(-0.2);
        let (own, _) = on.shares(0.2);
        let of = |n: i64| shares.get((n - own) as usize).copied().unwrap_or(0.0);
        assert!(mirrored.iter().enumerate().all(|(k, r)| (r - of(-(first + k as i64))).abs() < 1e-12));
    }
}
