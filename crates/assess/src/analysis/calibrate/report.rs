//! What a calibration found.

use super::biaxial::{Contact, Strength};
use super::moduli::{Curve, CurvePoint, Moduli, Spread, scatter};
use super::press::{Moment, Pressed};
use super::sample::{Cut, Sample};
use super::strength::{Fitted, Wanted};
use crate::warning::{self, Warning};
use bridge::{Bridge, Calibration, Modulus};
use mechanics::dem;

/// How a calibration ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Everything that was asked for was found.
    Completed,
    /// The wanted modulus is out of reach, or could not be checked.
    Undetermined,
    /// The onlooker stopped it.
    Cancelled,
}

impl Verdict {
    /// Its word in results.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Completed => "completed",
            Verdict::Undetermined => "undetermined",
            Verdict::Cancelled => "cancelled",
        }
    }
}

/// A multiple of the file's stiffness and the modulus there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct At {
    /// Multiple.
    pub multiple: f64,
    /// Modulus [Pa].
    pub modulus: f64,
}

/// What a calibration found.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationReport {
    /// How it ended.
    pub verdict: Verdict,
    /// Name of the bridge.
    pub bridge: String,
    /// Which modulus is compared with the wanted one.
    pub modulus: Modulus,
    /// The plan.
    pub plan: Calibration,
    /// Stiffness [Pa/m] of contacts between particles in the file, normal and shear, for particles of mean size.
    pub stiffness: [f64; 2],
    /// Seeds of the packings.
    pub seeds: Vec<u64>,
    /// How many squares were cut out of them.
    pub squares: usize,
    /// How many particles they hold.
    pub particles: usize,
    /// Mean diameter of the particles [m].
    pub mean_diameter: f64,
    /// Mean share of the squares that particles cover.
    pub solid_fraction: f64,
    /// Particles that the cuts went through, and how many of them were replaced.
    pub cut: usize,
    /// See `cut`.
    pub replaced: usize,
    /// Moduli at the multiples of the file, in its order.
    pub table: Vec<Measured>,
    /// Where the fill has the wanted modulus.
    pub found: Option<Measured>,
    /// Lowest and highest modulus within reach, where the wanted one is not.
    pub reach: Option<[At; 2]>,
    /// The same on other packings.
    pub check: Option<Check>,
    /// Friction and cohesion of contacts for a wanted strength.
    pub strength: Option<Sheared>,
    /// A sample for drawings.
    pub drawn: Option<Drawn>,
    /// What to look at.
    pub warnings: Vec<Warning>,
}

/// The stiffness that was found, on other packings.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Their seeds.
    pub seeds: Vec<u64>,
    /// What they have.
    pub measured: Measured,
}

/// What was found for a wanted strength.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheared {
    /// What was wanted.
    pub wanted: Wanted,
    /// What was found: the nearest where it is out of reach.
    pub found: Strength,
    /// Whether what is wanted is within reach.
    pub reached: bool,
    /// The same on other packings.
    pub check: Option<Strength>,
}

/// All samples at one multiple.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Multiple of the file's stiffness.
    pub multiple: f64,
    /// Mean of the step slopes [Pa].
    pub tangent: Option<Spread>,
    /// Slope of least squares [Pa].
    pub least_squares: Option<Spread>,
    /// Secant from the first result to the last [Pa].
    pub secant: Option<Spread>,
    /// The same without the first steps [Pa].
    pub late_secant: Option<Spread>,
    /// Samples that did not come to rest, or did not get shorter in every step.
    pub left_out: usize,
    /// Mean curve of the samples that count, and the standard deviation of its strain.
    pub curve: Vec<(CurvePoint, f64)>,
    /// Every sample: seed, square, curve.
    pub samples: Vec<(u64, usize, Curve)>,
    /// Iterations in all.
    pub iterations: u64,
    /// The first sample that counts: its index, and its particles before and after.
    drawn: Option<(usize, Vec<Moment>)>,
}

/// Particles in the press.
#[derive(Debug, Clone, PartialEq)]
pub struct Confined {
    /// Centres and radii [m], from the lower left corner of the square.
    pub particles: Vec<[f64; 3]>,
    /// Level of the block's underside [m].
    pub block: f64,
    /// Mean stress under it [Pa].
    pub stress: f64,
}

/// A sample for drawings.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// Seed and square.
    pub name: (u64, usize),
    /// Side [m].
    pub size: f64,
    /// Particles that the cut went through.
    pub cuts: Vec<Cut>,
    /// The particles as cut, the replacements last.
    pub particles: Vec<[f64; 3]>,
    /// Under the block alone, and after the last load step.
    pub pressed: [Confined; 2],
}

impl Measured {
    /// What presses of all samples amount to.
    pub fn new(multiple: f64, samples: &[Sample], pressed: &[Pressed], plan: &Calibration) -> Measured {
        let curves: Vec<Curve> = pressed.iter().map(|p| Curve::new(&p.path, p.height)).collect();
        let whole = |k: &usize| {
            let rests =
                pressed[*k].status == dem::Status::StableToLastLoad && curves[*k].points.len() == plan.steps + 1;
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

    /// The modulus that is compared, where samples have one.
    pub fn at(&self, modulus: Modulus) -> Option<At> {
        let spread = if modulus == Modulus::Tangent { self.tangent } else { self.secant };
        spread.map(|spread| At { multiple: self.multiple, modulus: spread.mean })
    }

    /// Nothing but a modulus, for tests of the search.
    #[cfg(test)]
    pub fn bare(multiple: f64, modulus: f64) -> Measured {
        let spread = Spread::of(&[(0, modulus)]);
        Measured {
            multiple,
            tangent: spread,
            least_squares: spread,
            secant: spread,
            late_secant: spread,
            left_out: 0,
            curve: Vec::new(),
            samples: Vec::new(),
            iterations: 0,
            drawn: None,
        }
    }
}

impl CalibrationReport {
    /// Nothing found yet.
    pub fn blank(bridge: &Bridge, seeds: &[u64]) -> CalibrationReport {
        CalibrationReport {
            verdict: Verdict::Completed,
            bridge: bridge.name.clone(),
            modulus: bridge.calibration.modulus,
            plan: bridge.calibration.clone(),
            stiffness: [0.0; 2],
            seeds: seeds.to_vec(),
            squares: 0,
            particles: 0,
            mean_diameter: 0.0,
            solid_fraction: 0.0,
            cut: 0,
            replaced: 0,
            table: Vec::new(),
            found: None,
            reach: None,
            check: None,
            strength: None,
            drawn: None,
            warnings: Vec::new(),
        }
    }

    /// Stopped by the onlooker.
    pub fn cancelled(mut self) -> CalibrationReport {
        self.verdict = Verdict::Cancelled;
        self
    }

    /// The table was all that was wanted.
    pub fn without_search(self) -> CalibrationReport {
        self
    }

    /// Takes in how the search for a strength ended; the contacts to go on with, where there are any.
    pub fn sheared(&mut self, wanted: Wanted, fitted: Fitted) -> Option<Contact> {
        let (found, reached) = match fitted {
            Fitted::Contacts(found) => (found, true),
            Fitted::OutOfReach(found) => (found, false),
            Fitted::Untested | Fitted::Stopped => {
                self.verdict = Verdict::Undetermined;
                let message = "no sample rested and gave way under every confining pressure";
                self.warnings.push(Warning::new(warning::NOT_SHEARED, message));
                return None;
            }
        };
        if found.left_out > 0 {
            let message = format!("{} samples do not count in the strength", found.left_out);
            self.warnings.push(Warning::new(warning::NOT_SHEARED, message));
        }
        if !reached || !wanted.met_by(&found) {
            self.verdict = Verdict::Undetermined;
            let message = format!(
                "with contacts of {:.1} degrees and {:.1} kPa the fill has {:.1} degrees and {:.1} kPa, which is the nearest to what is \
                 wanted",
                found.contact.friction_angle.to_degrees(),
                found.contact.cohesion / 1e3,
                found.friction_angle.mean.to_degrees(),
                found.cohesion.mean / 1e3
            );
            self.warnings.push(Warning::new(warning::STRENGTH_OUT_OF_REACH, message));
        }
        let contact = found.contact;
        self.strength = Some(Sheared { wanted, found, reached, check: None });
        Some(contact)
    }

    /// Takes in the strength of other packings.
    pub fn strength_checked(mut self, again: Option<Strength>) -> CalibrationReport {
        let Some(sheared) = &mut self.strength else { return self };
        let apart = match (&again, sheared.reached) {
            (None, _) => Some("no sample of the other seeds could be sheared".to_owned()),
            (Some(again), true) if !sheared.wanted.checked_by(again) => Some(format!(
                "other packings have {:.1} degrees (standard error {:.1}) and {:.1} kPa (standard error {:.1})",
                again.friction_angle.mean.to_degrees(),
                again.friction_angle.standard_error.to_degrees(),
                again.cohesion.mean / 1e3,
                again.cohesion.standard_error / 1e3
            )),
            _ => None,
        };
        sheared.check = again;
        if let Some(message) = apart {
            self.verdict = Verdict::Undetermined;
            self.warnings.push(Warning::new(warning::STRENGTH_CHECK_APART, message));
        }
        self
    }

    /// What the samples are.
    pub fn describe(&mut self, samples: &[Sample]) {
        self.squares = samples.len();
        self.particles = samples.iter().map(|s| s.particles.len()).sum();
        self.solid_fraction = scatter(samples.iter().map(Sample::solid_fraction)).unwrap_or_default().0;
        self.cut = samples.iter().map(|s| s.cuts.len()).sum();
        self.replaced = samples.iter().map(|s| s.cuts.iter().filter(|cut| cut.replaced).count()).sum();
    }

    /// The moduli at the multiples of the file, and a sample to draw.
    pub fn tabulate(&mut self, table: Vec<Measured>, samples: &[Sample]) {
        for measured in &table {
            self.leave_out(measured);
        }
        self.drawn = table.iter().find_map(|measured| drawn(measured, samples));
        self.table = table;
    }

    /// Warns of samples that do not count.
    pub fn leave_out(&mut self, measured: &Measured) {
        if measured.left_out > 0 {
            let (out, all) = (measured.left_out, measured.samples.len());
            let message = format!(
                "{out} of {all} samples do not count at {:.4} times the stiffness of the file",
                measured.multiple
            );
            self.warnings.push(Warning::new(warning::LEFT_OUT, message));
        }
    }
}

fn drawn(measured: &Measured, samples: &[Sample]) -> Option<Drawn> {
    let (k, moments) = measured.drawn.as_ref()?;
    let [first, last] = &moments[..] else { return None };
    let sample = &samples[*k];
    let points = &measured.samples[*k].2.points;
    let confined =
        |moment: &Moment, stress| Confined { particles: moment.particles.clone(), block: moment.block, stress };
    Some(Drawn {
        name: (sample.seed, sample.square),
        size: sample.size,
        cuts: sample.cuts.clone(),
        particles: sample.particles.iter().map(|p| [p.centre.x, p.centre.y, p.radius]).collect(),
        pressed: [confined(first, points.first()?.stress), confined(last, points.last()?.stress)],
    })
}
