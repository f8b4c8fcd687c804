//! Squares of fill sheared to their peak: a smooth box whose right side and lid are pressed alike, then the lid until the sample
//! gives way. Peaks at several confining pressures lie on a line; its slope is the friction angle, its height the cohesion.

use super::press::Rig;
use super::sample::{Part, Sample};
use super::settled::Laws;
use crate::analysis::AnalysisError;
use mechanics::blocks::{BlockModel, ContactLaw, Held, Loading, PointForce};
use mechanics::dem;
use mechanics::ids::BlockId;
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Watch;
use outcome::calibration::Spread;
use outcome::calibration::moduli::scatter;
use outcome::calibration::{Contact, Strength};

/// Increment of the stress on the lid over the confining pressure.
const INCREMENT: f64 = 0.1;
/// Stress difference over confining pressure at which the test ends: a friction angle of 51 degrees.
const LIMIT: f64 = 7.0;
/// Sinking of the lid, as a share of the height at rest, beyond which the sample has given way: a guided block that sinks into discs
/// may come to rest again deeper down, which is no strength of the sample as it was.
const GIVEN_WAY: f64 = 0.05;
/// Gap between the lid and the side that moves, as a share of the smallest radius: no particle passes, and the side does not reach
/// the lid as the sample is confined.
const GAP: f64 = 0.5;

impl Rig {
    /// The stress on the lid [Pa] that one sample still carries under a confining pressure [Pa]; none where it does not
    /// rest, or carries all that is tried.
    pub(super) fn peak(
        &self,
        sample: &Sample,
        contact: Contact,
        pressure: f64,
        watch: &mut dyn Watch,
    ) -> Result<Option<f64>, AnalysisError> {
        let (model, loading, watched) = self.boxed(sample, contact, pressure)?;
        let program = dem::Program { increment: INCREMENT, limit: LIMIT, resolution: None, watched };
        let outcome = dem::collapse(&model, &loading, &program, &self.settings, None, watch)?;
        let rested: Vec<&dem::PathPoint> = outcome.path.iter().take_while(|point| point.at_rest).collect();
        let Some(first) = rested.first() else { return Ok(None) };
        let deepest = GIVEN_WAY * (watched.1.y + first.displacement.y);
        let sunk = |point: &dem::PathPoint| first.displacement.y - point.displacement.y;
        let held = rested.iter().take_while(|point| sunk(point) <= deepest).count();
        // Every step was carried: the peak is not known.
        if held == rested.len() && outcome.status == dem::Status::StableToLastLoad {
            return Ok(None);
        }
        Ok(Some(pressure * (1.0 + rested[held - 1].factor)))
    }

    fn boxed(
        &self,
        sample: &Sample,
        contact: Contact,
        pressure: f64,
    ) -> Result<(BlockModel, Loading, (BlockId, Vec2)), AnalysisError> {
        let size = sample.size;
        let (thickness, gap) = (0.2 * size, GAP * sample.smallest);
        let density = sample.particles.first().map_or(1.0, |p| p.density);
        let block = |low: Vec2, width: f64, height: f64, held: Held| Part { low, width, height, density, held };
        let (top, side) = (sample.top(), 1.5 * size);
        let sliding = Held { x: false, y: true, rotation: true };
        let sinking = Held { x: true, y: false, rotation: true };
        let parts = [
            block(vec2(0.0, -thickness), 1.5 * size, thickness, Held::FIXED),
            block(vec2(-thickness, -thickness), thickness, side + thickness, Held::FIXED),
            block(vec2(size, 0.1 * gap), thickness, side, sliding),
            block(vec2(0.1 * gap, top), size - 1.1 * gap, thickness, sinking),
        ];
        let (model, [_, _, (right, beside), (lid, above)]) = sample.among(parts, self.smooth(contact))?;
        let force = |block, at, force| PointForce { block, at, force };
        let down = vec2(0.0, -pressure * size);
        let loading = Loading {
            permanent: vec![force(right, beside, vec2(-pressure * top, 0.0)), force(lid, above, down)],
            variable: vec![force(lid, above, down)],
            ..Loading::default()
        };
        Ok((model, loading, (lid, vec2(0.5 * size, top))))
    }

    /// The laws with other contacts between particles, and walls that resist no sliding.
    fn smooth(&self, contact: Contact) -> Laws {
        // Weight would add to the confining pressure from top to bottom.
        let mut laws = Laws { gravity: Vec2::ZERO, ..contacts(&self.laws, contact) };
        for group in self.laws.groups.ids() {
            let law = *laws.table.between(laws.walls, group);
            laws.table.set(laws.walls, group, ContactLaw { friction: 0.0, cohesion: 0.0, ..law });
        }
        laws
    }
}

/// The laws with other contacts between particles.
pub(super) fn contacts(laws: &Laws, contact: Contact) -> Laws {
    let (friction, cohesion) = (contact.friction_angle.tan(), contact.cohesion);
    laws.with_contacts(|law| ContactLaw { friction, cohesion, ..law })
}

/// What peaks [Pa] of all samples amount to, test by test of each sample; none where fewer than one sample has all.
pub(super) fn strength(
    contact: Contact,
    samples: &[Sample],
    pressures: &[f64],
    peaks: &[Option<f64>],
) -> Option<Strength> {
    let whole: Vec<(u64, Vec<f64>)> = samples
        .iter()
        .zip(peaks.chunks(pressures.len()))
        .filter_map(|(sample, own)| Some((sample.seed, own.iter().copied().collect::<Option<Vec<f64>>>()?)))
        .collect();
    let lines: Vec<(u64, f64, f64)> =
        whole.iter().filter_map(|(seed, own)| line(pressures, own).map(|(phi, c)| (*seed, phi, c))).collect();
    let mean = |test: usize| scatter(whole.iter().map(|w| w.1[test])).map(|(mean, _)| mean);
    Some(Strength {
        contact,
        friction_angle: Spread::of(&lines.iter().map(|l| (l.0, l.1)).collect::<Vec<_>>())?,
        cohesion: Spread::of(&lines.iter().map(|l| (l.0, l.2)).collect::<Vec<_>>())?,
        peaks: pressures.iter().enumerate().filter_map(|(k, &p)| Some([p, mean(k)?])).collect(),
        left_out: samples.len() - lines.len(),
    })
}

/// Friction angle [rad] and cohesion [Pa] of the line of least squares through peaks over confining pressures: with
/// `peak = a + b pressure`, `sin phi = (b - 1)/(b + 1)` and `c = a / (2 sqrt b)`.
fn line(pressures: &[f64], peaks: &[f64]) -> Option<(f64, f64)> {
    let n = pressures.len() as f64;
    let (x, y) = (pressures.iter().sum::<f64>() / n, peaks.iter().sum::<f64>() / n);
    let mixed: f64 = pressures.iter().zip(peaks).map(|(p, q)| (p - x) * (q - y)).sum();
    let square: f64 = pressures.iter().map(|p| (p - x).powi(2)).sum();
    let b = mixed / square;
    if !(b > 0.0 && b.is_finite()) {
        return None;
    }
    Some((((b - 1.0) / (b + 1.0)).asin(), (y - b * x) / (2.0 * b.sqrt())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_peaks_has_its_angle_and_cohesion() {
        let (phi, c) = (35f64.to_radians(), 12e3);
        let passive = (1.0 + phi.sin()) / (1.0 - phi.sin());
        let pressures = [50e3, 100e3, 200e3];
        let peaks = pressures.map(|p| passive * p + 2.0 * c * passive.sqrt());
        let (found, cohesion) = line(&pressures, &peaks).unwrap();
        assert!((found - phi).abs() < 1e-12 && (cohesion / c - 1.0).abs() < 1e-9, "{found} {cohesion}");
    }
}
