//! What a calibration found.

use super::press::Pressed;
use super::sample::Sample;
use bridge::Calibration;
use mechanics::dem;
use outcome::calibration::moduli::{Moduli, scatter};
use outcome::calibration::{CalibrationReport, Curve, CurvePoint, Drawn, Measured, Spread};

/// What presses of all samples amount to.
pub(super) fn measured(multiple: f64, samples: &[Sample], pressed: &[Pressed], plan: &Calibration) -> Measured {
    let curves: Vec<Curve> = pressed.iter().map(|p| Curve::new(&p.path, p.height)).collect();
    let whole = |k: &usize| {
        let rests = pressed[*k].status == dem::Status::StableToLastLoad && curves[*k].points.len() == plan.steps + 1;
        rests.then(|| curves[*k].moduli(plan.ignored_steps)).flatten().map(|moduli| (*k, moduli))
    };
    let counted: Vec<(usize, Moduli)> = (0..samples.len()).filter_map(|k| whole(&k)).collect();
    let spread = |of: fn(&Moduli) -> f64| {
        let values: Vec<(u64, f64)> = counted.iter().map(|(k, m)| (samples[*k].seed, of(m))).collect();
        Spread::of(&values)
    };
    let mean = |step: usize| {
        let strains = counted.iter().map(|(k, _)| curves[*k].points[step].strain);
        let sinkings = counted.iter().map(|(k, _)| curves[*k].points[step].displacement);
        let stress = curves[counted[0].0].points[step].stress;
        let (strain, deviation) = scatter(strains).unwrap_or_default();
        (CurvePoint { stress, strain, displacement: scatter(sinkings).unwrap_or_default().0 }, deviation)
    };
    let steps = if counted.is_empty() { 0 } else { plan.steps + 1 };
    Measured {
        multiple,
        tangent: spread(|m| m.tangent),
        least_squares: spread(|m| m.least_squares),
        secant: spread(|m| m.secant),
        late_secant: spread(|m| m.late_secant),
        left_out: samples.len() - counted.len(),
        curve: (0..steps).map(mean).collect(),
        samples: samples.iter().zip(curves.iter()).map(|(s, c)| (s.seed, s.square, c.clone())).collect(),
        iterations: pressed.iter().map(|p| p.iterations).sum(),
        drawn: counted.first().map(|(k, _)| (*k, pressed[*k].moments.clone())),
    }
}

fn drawn(measured: &Measured, samples: &[Sample]) -> Option<Drawn> {
    let (k, moments) = measured.drawn.as_ref()?;
    let [first, last] = &moments[..] else { return None };
    let sample = &samples[*k];
    let points = &measured.samples[*k].2.points;
    Some(Drawn {
        name: (sample.seed, sample.square),
        size: sample.size,
        cuts: sample.cuts.clone(),
        particles: sample.particles.iter().map(|p| [p.centre.x, p.centre.y, p.radius]).collect(),
        pressed: [(first.clone(), points.first()?.stress), (last.clone(), points.last()?.stress)],
    })
}

/// Says what the samples are.
pub(super) fn describe(report: &mut CalibrationReport, samples: &[Sample]) {
    report.squares = samples.len();
    report.particles = samples.iter().map(|s| s.particles.len()).sum();
    report.solid_fraction = scatter(samples.iter().map(Sample::solid_fraction)).unwrap_or_default().0;
    report.cut = samples.iter().map(|s| s.cuts.len()).sum();
    report.replaced = samples.iter().map(|s| s.cuts.iter().filter(|cut| cut.replaced).count()).sum();
}

/// Takes in the moduli at the multiples of the file, and a sample to draw.
pub(super) fn tabulate(report: &mut CalibrationReport, table: Vec<Measured>, samples: &[Sample]) {
    for measured in &table {
        report.leave_out(measured);
    }
    report.drawn = table.iter().find_map(|measured| drawn(measured, samples));
    report.table = table;
}
