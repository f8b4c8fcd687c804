//! Contact stiffness of fill particles for a wanted modulus of the fill, as Rouxinol, Providência and Lemos find it
//! (section 3.1): squares are cut out of the fill at rest, held below and at both sides, and pressed in steps; the slope
//! of stress over strain is the modulus. What is found on some packings is checked on others.

mod biaxial;
mod crowd;
mod press;
mod report;
mod sample;
mod search;
mod settled;
mod squares;
mod strength;
#[cfg(test)]
mod tests;

use super::engine::joints::require_stiffness;
use super::{AnalysisError, LEAST_SAMPLE};
use biaxial::contacts;
use bridge::{Bridge, Particles, Sizes, Strip};
use crowd::{Crowd, Halt};
use mechanics::watch::Watch;
use outcome::calibration::{CalibrationReport, Check, Contact, Measured, Strength, TargetStrength};
use outcome::sweep::Ended;
use press::Rig;
use sample::Sample;
use search::search;
use std::f64::consts::PI;
use strength::fit;

/// Share of the work of one sample's press that one packing takes, for the estimate of the time left.
const PACKING_WORK: f64 = 30.0;

/// Measures the moduli of the fill at the multiples of the file, finds the multiple with the wanted modulus, and checks
/// it on packings of other seeds.
///
/// # Errors
/// Those of [`planned`], and fill that cannot be packed or does not come to rest.
pub fn calibrate_fill(bridge: &Bridge, watch: &mut dyn Watch) -> Result<CalibrationReport, AnalysisError> {
    require_stiffness(bridge)?;
    let (bridge, particles) = prepared(bridge)?;
    let seeds: Vec<u64> = (0..bridge.calibration.seeds).map(|k| bridge.plan.seed.wrapping_add(k)).collect();
    let mut report = CalibrationReport::blank(&bridge, &seeds);
    match calibrated(&bridge, particles, &mut report, watch) {
        Ok(()) => Ok(report),
        Err(Halt::Stopped) => Ok(CalibrationReport { verdict: Ended::Cancelled, ..report }),
        Err(Halt::Failed(error)) => Err(error),
    }
}

/// The same of a bridge and its particles, into a report of which nothing is known but the seeds.
fn calibrated(
    bridge: &Bridge,
    mut particles: Particles,
    report: &mut CalibrationReport,
    watch: &mut dyn Watch,
) -> Result<(), Halt> {
    let plan = &bridge.calibration;
    let wanted_strength = TargetStrength { friction_angle: plan.wanted_friction_angle, cohesion: plan.wanted_cohesion };
    let sheared = wanted_strength.friction_angle.is_some() || wanted_strength.cohesion.is_some();
    let others: Vec<u64> = (0..plan.seeds).map(|k| bridge.plan.seed.wrapping_add(plan.seeds + k)).collect();
    let rounds = plan.multiples.len() as f64 + if plan.wanted_modulus.is_some() { EXPECTED_ROUNDS } else { 0.0 };
    let packings = if plan.wanted_modulus.is_some() || sheared { 2 } else { 1 } * plan.seeds;
    let shears = if sheared { SHEARS * (plan.sheared_samples * plan.confining_pressures.len()) as f64 } else { 0.0 };
    let mut crowd = Crowd::new(watch, packings as f64 * (PACKING_WORK + rounds * EXPECTED_SQUARES) + shears);

    let mut samples = self::samples(bridge, &report.seeds, &mut crowd)?;
    crowd.plan(packings as f64 * PACKING_WORK + samples.len() as f64 * rounds + shears);
    report::describe(report, &samples);
    report.mean_diameter = samples.iter().map(|s| s.mean_diameter).sum::<f64>() / samples.len() as f64;
    if sheared {
        let few = spaced(&samples, plan.sheared_samples);
        let fitted =
            fit(wanted_strength, contact_of(&particles), &mut |contact| shear(bridge, &few, contact, &mut crowd))?;
        let Some(contact) = report.sheared(wanted_strength, fitted) else { return Ok(()) };
        samples.iter_mut().for_each(|sample| sample.laws = contacts(&sample.laws, contact));
        (particles.joint.friction_angle, particles.joint.cohesion) = (contact.friction_angle, contact.cohesion);
    }
    // Other packings come to rest with the contacts that were found.
    let found = Bridge { particles: Some(particles.clone()), ..bridge.clone() };
    let rig = Rig::new(bridge, &samples[0].laws);
    report.stiffness = rig.stiffness(1.0, report.mean_diameter);
    let table = measure(&rig, &samples, &plan.multiples, &mut crowd)?;
    report::tabulate(report, table, &samples);
    if let Some(wanted) = plan.wanted_modulus {
        let mut press = |multiple: f64| measure(&rig, &samples, &[multiple], &mut crowd).map(|mut one| one.remove(0));
        match search(wanted, plan.tolerance, plan.modulus, &report.table, &mut press)? {
            Ok(measured) => {
                if !report.table.iter().any(|known| known.multiple == measured.multiple) {
                    report.leave_out(&measured);
                }
                report.found = Some(measured);
            }
            Err(reach) => {
                report.out_of_reach(wanted, reach);
                return Ok(());
            }
        }
    } else if !sheared {
        return Ok(());
    }
    let fresh = self::samples(&found, &others, &mut crowd)?;
    if plan.wanted_modulus.is_some() {
        let multiple = report.found.as_ref().map_or(1.0, |found| found.multiple);
        let rig = Rig::new(bridge, &fresh[0].laws);
        let measured = measure(&rig, &fresh, &[multiple], &mut crowd)?.remove(0);
        report.check = Some(Check { seeds: others, measured });
    }
    if sheared {
        let few = spaced(&fresh, plan.sheared_samples);
        report.strength_checked(shear(bridge, &few, contact_of(&particles), &mut crowd)?);
    }
    if let Some(wanted) = plan.wanted_modulus {
        report.judged(wanted);
    }
    Ok(())
}

fn contact_of(particles: &Particles) -> Contact {
    Contact { friction_angle: particles.joint.friction_angle, cohesion: particles.joint.cohesion }
}

/// So many of the samples, spaced evenly, so that all packings have their share.
fn spaced(samples: &[Sample], most: usize) -> Vec<Sample> {
    let count = most.min(samples.len());
    (0..count).map(|k| samples[k * samples.len() / count].clone()).collect()
}

/// Shears every sample at every confining pressure. None where no sample gave way.
fn shear(
    bridge: &Bridge,
    samples: &[Sample],
    contact: Contact,
    crowd: &mut Crowd<'_>,
) -> Result<Option<Strength>, Halt> {
    let Some(first) = samples.first() else { return Ok(None) };
    let rig = Rig::new(bridge, &first.laws);
    let pressures = &bridge.calibration.confining_pressures;
    let jobs: Vec<(&Sample, f64)> =
        samples.iter().flat_map(|sample| pressures.iter().map(move |pressure| (sample, *pressure))).collect();
    let peak = |&(sample, pressure): &(&Sample, f64), watch: &mut dyn Watch| rig.peak(sample, contact, pressure, watch);
    let peaks = crowd.each("shearing", 1.0, &jobs, peak)?;
    Ok(biaxial::strength(contact, samples, pressures, &peaks))
}

/// Presses that a search and its check take, about.
const EXPECTED_ROUNDS: f64 = 5.0;

/// Times that every sheared sample is sheared at every pressure, about, its check among them.
const SHEARS: f64 = 8.0;

/// Squares in one packing, until it is known.
const EXPECTED_SQUARES: f64 = 12.0;

/// Refuses what calibration refuses before it packs: fill without particles, a saved packing, a square that the fill cannot hold, or that
/// holds too few particles of the mean size that the fill leaves them.
///
/// # Errors
/// What is refused, joints without stiffness, or a bridge that cannot be cut into blocks.
pub fn planned(bridge: &Bridge) -> Result<(), AnalysisError> {
    let (bridge, particles) = prepared(bridge)?;
    require_stiffness(&bridge)?;
    let d = structure::discretise::discretise(&bridge)?;
    let Some(region) = &d.fill else { return Err(AnalysisError::NoParticles) };
    let size = bridge.calibration.sample_size;
    let diameter = match particles.sizes {
        Sizes::Diameters { smallest, .. } => smallest,
        // Discs that fill the region wholly; packed ones are a little smaller.
        Sizes::Count { count, .. } => PACKED * (4.0 * region.area / (PI * count.max(1) as f64)).sqrt(),
    };
    if size < LEAST_SAMPLE * diameter {
        return Err(AnalysisError::SmallSample { size, diameter });
    }
    if squares::squares(region, size, diameter).is_empty() {
        return Err(AnalysisError::NoSample { size });
    }
    Ok(())
}

/// Mean diameter of packed discs over that of discs which fill the region wholly, at the least: a solid fraction of 0.75 and spread sizes.
const PACKED: f64 = 0.75;

/// The bridge with the plan that calibration needs, and its particles.
fn prepared(bridge: &Bridge) -> Result<(Bridge, Particles), AnalysisError> {
    let Some(particles) = bridge.particles.clone() else { return Err(AnalysisError::NoParticles) };
    if particles.file.is_some() || !particles.grains.is_empty() {
        return Err(AnalysisError::SavedPacking);
    }
    let mut bridge = bridge.clone();
    bridge.plan.method = bridge::Method::Dem;
    bridge.plan.analysis = bridge::Analysis::Load;
    bridge.plan.strip = Strip::Fill;
    bridge.loads.clear();
    let plan = &bridge.calibration;
    if plan.wanted_friction_angle.is_some() || plan.wanted_cohesion.is_some() {
        // One fill: layers with contacts of their own would mix two.
        bridge.cover.layers.iter_mut().for_each(|layer| (layer.friction_angle, layer.cohesion) = (None, None));
        if let Some(backing) = &mut bridge.cover.backing {
            (backing.friction_angle, backing.cohesion) = (None, None);
        }
    }
    Ok((bridge, particles))
}

/// Packs the fill once for each seed, lets it come to rest, and cuts the squares out.
fn samples(bridge: &Bridge, seeds: &[u64], crowd: &mut Crowd<'_>) -> Result<Vec<Sample>, Halt> {
    let size = bridge.calibration.sample_size;
    let packed = crowd.each("packing", PACKING_WORK, seeds, |&seed, watch| {
        let fill = settled::settled(bridge, seed, watch)?;
        let diameter = fill.mean_diameter();
        if size < LEAST_SAMPLE * diameter {
            return Err(AnalysisError::SmallSample { size, diameter }.into());
        }
        Ok::<_, Halt>(fill)
    })?;
    let mut samples = Vec::new();
    for (fill, &seed) in packed.into_iter().zip(seeds) {
        let squares = squares::squares(&fill.region, size, 2.0 * fill.largest());
        samples
            .extend(squares.into_iter().enumerate().map(|(k, corner)| Sample::cut(bridge, &fill, (seed, k), corner)));
    }
    if samples.is_empty() {
        return Err(AnalysisError::NoSample { size }.into());
    }
    Ok(samples)
}

/// Presses every sample at every multiple.
fn measure(rig: &Rig, samples: &[Sample], multiples: &[f64], crowd: &mut Crowd<'_>) -> Result<Vec<Measured>, Halt> {
    let jobs: Vec<(f64, usize)> =
        multiples.iter().flat_map(|&multiple| (0..samples.len()).map(move |k| (multiple, k))).collect();
    let pressed =
        crowd.each("pressing", 1.0, &jobs, |&(multiple, k), watch| rig.press(&samples[k], multiple, watch))?;
    let of = |(k, &multiple): (usize, &f64)| {
        let own = &pressed[k * samples.len()..(k + 1) * samples.len()];
        report::measured(multiple, samples, own, &rig.plan)
    };
    Ok(multiples.iter().enumerate().map(of).collect())
}
