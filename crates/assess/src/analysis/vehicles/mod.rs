//! Vehicles moved over a bridge by limit analysis: every position, both ways, every run of neighbouring axles, under the
//! factors of a rule.
//!
//! Read in the order of the method: `weights` lists the combinations of factors on dead load, `factored` gives loads and
//! strengths their factors, `cases` lists places, `standing` what stands there, `search` answers every case, `sections` keeps
//! what joints carry meanwhile, `discrete` makes the governing case by discrete elements.

mod across;
mod cases;
mod discrete;
mod factored;
mod limits;
#[cfg(test)]
mod screened;
mod search;
mod sections;
mod seeds;
mod standing;
#[cfg(test)]
mod tests;
mod told;
mod twins;
mod weights;

pub use across::Across;
pub use discrete::ByDiscreteElements;
pub(super) use search::{DILATANCY, REFINEMENTS};
pub use sections::{Extreme, SectionEnvelope};
pub use weights::Weights;

use super::AnalysisError;
use super::report::{Collapse, Status};
use crate::vehicles::{Chosen, chosen, left_out};
use crate::warning::{self, Warning};
use bridge::{Bridge, Method};
use mechanics::watch::Watch;
use rules::{Acting, Confidence, Rule, Source};

/// Which way a vehicle drives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// To the right.
    Right,
    /// To the left.
    Left,
}

impl Direction {
    /// The word in results.
    pub fn word(self) -> &'static str {
        match self {
            Direction::Right => "right",
            Direction::Left => "left",
        }
    }
}

/// What stands where.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Place of the vehicle's first axle, from the left springing of the first span [m].
    pub position: f64,
    /// Which way it drives.
    pub direction: Direction,
    /// Which arrangement: distances and lift-off; empty where there is only one.
    pub arrangement: String,
    /// First and last axle that stands on the bridge, counted from 0 from the front of the vehicle; none where uniform
    /// loads stand alone.
    pub axles: Option<[usize; 2]>,
    /// The axle with the rule's factor for the critical one.
    pub critical_axle: Option<usize>,
    /// Factors on the weights of the bridge meanwhile.
    pub weights: Weights,
    /// From where to where uniform loads stand [m].
    pub uniform: Option<[f64; 2]>,
    /// Sum of the loads with their factors on the effective width [N/m].
    pub load: f64,
}

/// The least adequacy factor with a vehicle at a place.
#[derive(Debug, Clone, PartialEq)]
pub struct EnvelopePoint {
    /// Which arrangement.
    pub arrangement: String,
    /// Which way it drives.
    pub direction: Direction,
    /// Place of the vehicle's first axle [m].
    pub position: f64,
    /// Whether every case there was answered.
    pub converged: bool,
    /// Least adequacy factor over what may stand there; none where a case was not answered or nothing collapses.
    pub adequacy: Option<f64>,
    /// First and last axle of what governs.
    pub axles: Option<[usize; 2]>,
    /// Factors on the weights of what governs.
    pub weights: Option<Weights>,
}

/// What was found for one vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct Swept {
    /// Its code.
    pub code: String,
    /// Its name.
    pub title: String,
    /// Code of its load model.
    pub model: String,
    /// How the governing case ended.
    pub status: Status,
    /// Adequacy factor: what all its axle loads may be multiplied by; 1 is just enough. None where nothing makes a mechanism, and
    /// where a position was not answered.
    pub adequacy: Option<f64>,
    /// Where positions were not answered: the least factor that the others leave. It bounds the adequacy factor from above and is no
    /// answer.
    pub adequacy_at_most: Option<f64>,
    /// At how many positions a case was not answered.
    pub positions_not_converged: usize,
    /// Bounds of the governing case with dilatant friction.
    pub bounds: Option<[f64; 2]>,
    /// Adequacy factor without dilation, of the worst cases in which joints slide; none where none does.
    pub without_dilation: Option<f64>,
    /// The governing case.
    pub case: Option<Case>,
    /// Factors on weights with which it governs, or with which the bridge does not stand.
    pub weights: Option<Weights>,
    /// Worst case at every position.
    pub envelope: Vec<EnvelopePoint>,
    /// What critical joints carry under the vehicle, as elastic ones.
    pub sections: Vec<SectionEnvelope>,
    /// Width of the barrel that carries an axle [m].
    pub effective_width: f64,
    /// How vehicles stand across the bridge.
    pub across: Across,
    /// Factor on axles: live load and impact, the largest of all spans; and what the critical axle has besides.
    pub load_factors: [f64; 2],
    /// The first of these span by span: motion adds by the length of the loaded span.
    pub span_factors: Vec<f64>,
    /// What the rule does with its loads.
    pub acting: Acting,
    /// Where the vehicle is from.
    pub source: Source,
    /// How many cases were answered.
    pub cases: usize,
    /// How many of them had to be left to the interior-point method.
    pub by_interior_point: usize,
}

impl Swept {
    /// A position at which joints slide, answered again without dilation.
    fn slides_at(&mut self, at: &EnvelopePoint, level: Option<f64>) {
        let same = |p: &&mut EnvelopePoint| {
            p.position == at.position && p.direction == at.direction && p.arrangement == at.arrangement
        };
        for point in self.envelope.iter_mut().filter(|p| same(p)) {
            point.converged &= level.is_some();
            point.adequacy = point.adequacy.zip(level).map(|(old, level)| old.min(level));
        }
    }

    /// Says how it ended, with the least factor of what was answered: an adequacy factor only where everything was.
    fn end(&mut self, whole: bool, least: Option<f64>) {
        self.positions_not_converged = self.envelope.iter().filter(|p| !p.converged).count();
        self.status = match (whole, self.positions_not_converged, least) {
            (false, _, _) => Status::Cancelled,
            (true, 1.., _) => Status::NotConverged,
            (true, 0, Some(_)) => Status::Collapsed,
            (true, 0, None) => Status::Locks,
        };
        let answered = self.status == Status::Collapsed;
        (self.adequacy, self.adequacy_at_most) = if answered { (least, None) } else { (None, least) };
    }

    /// Takes the result of the governing case by itself: where it carries less, the smaller factor counts, and where it
    /// found none, nothing is settled.
    fn governed_by(&mut self, run: &Collapse, capacity: f64) {
        // What is carried where no load was found bounds nothing from above.
        let answered = run.status == Status::Collapsed;
        let by_itself = run.carried().filter(|_| answered).map(|load| load / run.reference_load * capacity);
        match by_itself {
            Some(factor) => {
                let smaller = |found: f64| if factor < found * (1.0 - SAME) { factor } else { found };
                self.adequacy = self.adequacy.map(smaller);
                self.adequacy_at_most = self.adequacy_at_most.map(smaller);
            }
            None if self.adequacy.is_some() => {
                self.adequacy_at_most = self.adequacy.take();
                self.status = Status::NotConverged;
                self.positions_not_converged = self.positions_not_converged.max(1);
            }
            None => {}
        }
    }

    /// The adequacy factor, or what bounds it from above.
    pub fn factor(&self) -> Option<f64> {
        self.adequacy.or(self.adequacy_at_most)
    }
}

/// The sweep and a case by itself agree to this: both bounds of either do.
const SAME: f64 = 1e-6;

/// What was found for all vehicles.
#[derive(Debug, Clone, PartialEq)]
pub struct VehicleSweep {
    /// Name of the bridge.
    pub bridge: String,
    /// The rule.
    pub rule: Rule,
    /// The combinations of factors on weights that were tried.
    pub weights: Vec<Weights>,
    /// Every vehicle, in the order of the plan.
    pub vehicles: Vec<Swept>,
    /// The vehicle with the least adequacy factor, or the least bound on it.
    pub governing: Option<usize>,
    /// The governing case as a collapse analysis with its picture.
    pub collapse: Option<Box<Collapse>>,
    /// The governing case by discrete elements, where the plan asks for it.
    pub discrete_elements: Option<ByDiscreteElements>,
    /// Distance between positions [m].
    pub step: f64,
    /// What a reader should look at.
    pub warnings: Vec<Warning>,
    /// What was assumed.
    pub assumptions: Vec<String>,
}

impl VehicleSweep {
    /// How it ended: completed only where every position of every vehicle was answered.
    pub fn status(&self) -> Ended {
        let ended = |status| self.vehicles.iter().any(|v| v.status == status);
        match self.governing {
            _ if ended(Status::Cancelled) => Ended::Cancelled,
            _ if ended(Status::NotConverged) => Ended::Undetermined,
            None => Ended::Undetermined,
            Some(_) => Ended::Completed,
        }
    }

    /// At how many positions a case was not answered, over all vehicles.
    pub fn positions_not_converged(&self) -> usize {
        self.vehicles.iter().map(|v| v.positions_not_converged).sum()
    }

    /// The headline: the governing vehicle's factor by the method that gives less, and that method. None where it is not known.
    pub fn headline(&self) -> Option<(f64, Method)> {
        let by_limit = self.vehicles.get(self.governing?)?.adequacy?;
        let second = self.discrete_elements.as_ref().and_then(|second| second.adequacy);
        Some(match second {
            Some(second) if second < by_limit => (second, Method::Dem),
            _ => (by_limit, Method::Limit),
        })
    }
}

/// How a sweep ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// Every position was answered.
    Completed,
    /// A position was not answered, or no position makes a mechanism.
    Undetermined,
    /// Stopped by its onlooker; what was done is there.
    Cancelled,
}

impl Ended {
    /// The word in results.
    pub fn word(self) -> &'static str {
        match self {
            Ended::Completed => "completed",
            Ended::Undetermined => "undetermined",
            Ended::Cancelled => "cancelled",
        }
    }
}

/// Moves the vehicles of the bridge's plan over it. Where the onlooker wishes to stop, what is done by then is returned.
pub fn vehicle_sweep(bridge: &Bridge, watch: &mut dyn Watch) -> Result<VehicleSweep, AnalysisError> {
    let plan = bridge.sweep.as_ref().ok_or(AnalysisError::Missing {
        what: "[sweep]",
        why: "it says which vehicles are moved, and by which rule",
    })?;
    let (rule, vehicles) = chosen(bridge, plan)?;
    let shortest = bridge.spans.iter().map(|s| s.span).fold(f64::INFINITY, f64::min);
    let step = plan.step.unwrap_or(shortest / 60.0);
    let weights = weights::combinations(bridge, &rule);
    let swept = search::all(bridge, &rule, plan, &vehicles, &weights, step, watch)?;
    let governing = swept
        .iter()
        .enumerate()
        .filter_map(|(k, s)| s.factor().map(|a| (k, a)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(k, _)| k);
    let mut found = VehicleSweep {
        bridge: bridge.name.clone(),
        rule,
        weights,
        vehicles: swept,
        governing,
        collapse: None,
        discrete_elements: None,
        step,
        warnings: Vec::new(),
        assumptions: Vec::new(),
    };
    if let Some((k, case)) = governing.and_then(|k| found.vehicles[k].case.clone().map(|case| (k, case)))
        && found.status() != Ended::Cancelled
    {
        let factored = factored::bridge(bridge, &found.rule, &case.weights);
        let one = factored::with_case(&factored, plan, &found.rule, &vehicles[k], &case);
        let mut by_limit = super::collapse_by_limit(&one)?;
        found.vehicles[k].governed_by(&by_limit, found.rule.capacity_factor());
        by_limit.picture.case = Some(told::case(&found.vehicles[k], &case, &one));
        if plan.discrete_elements {
            let limit = found.vehicles[k].factor();
            found.discrete_elements = Some(discrete::carried(&one, &by_limit, &found.rule, limit, watch));
        }
        found.collapse = Some(Box::new(by_limit));
    }
    notes(bridge, &vehicles, &mut found);
    Ok(found)
}

fn notes(bridge: &Bridge, vehicles: &[Chosen], found: &mut VehicleSweep) {
    let rule = &found.rule;
    let uncertain = uncertain(rule, &found.vehicles);
    if !uncertain.is_empty() {
        found.warnings.push(Warning::new(
            warning::RECALLED_FACTOR,
            format!(
                "factors of rule \"{}\" that must be confirmed in their source: {}",
                rule.code,
                uncertain.join(", ")
            ),
        ));
    }
    for chosen in vehicles.iter().filter(|chosen| !rule.ways.contains(&chosen.ways)) {
        found.warnings.push(Warning::new(
            warning::RULE_FOR_OTHER_WAYS,
            format!("rule \"{}\" is not made for vehicle \"{}\"", rule.code, chosen.vehicle.code),
        ));
    }
    found.warnings.extend(not_converged(&found.vehicles));
    // What is to be said of the governing case is to be said of the sweep.
    let of_case = found.collapse.iter().flat_map(|collapse| &collapse.warnings).cloned();
    found.warnings.extend(of_case.collect::<Vec<_>>());
    let beyond = bridge.sweep.as_ref().map_or(Vec::new(), |plan| left_out(bridge, plan));
    found.warnings.extend(limits::of_vehicles(bridge, vehicles, found, &beyond));
    found.warnings.extend(near_the_limit(found));
    let slides = found.vehicles.iter().filter(|v| v.without_dilation.is_some()).count();
    found.assumptions = vec![
        "The adequacy factor multiplies all loads of the vehicle together; weights stay as they are.".into(),
        of_weights(found),
        format!(
            "Positions lie {:.3} m apart; the worst one is then sought to a hundredth of that. Between positions the factor changes \
             steadily.",
            found.step
        ),
        "Uniform loads that may be left out stand on any run of half spans; those of a lane spread over its width, others over that of \
         an axle."
            .into(),
        "Across the bridge vehicles stand where they load a metre of its width most: ".to_owned() + &limits::across(found),
        "Concurrent values at critical joints are those of elastic blocks whose joints open nowhere, under the vehicle with its factors."
            .to_owned()
            + &sections::outside(found.vehicles.iter().flat_map(|v| &v.sections)),
    ];
    if found.vehicles.iter().any(|v| v.by_interior_point > 0) {
        found.assumptions.push(format!(
            "Where cases had to be left to the slower method, those were not answered whose upper bound, by the mechanisms met before, lies \
             more than {} times above the least factor at the position, and as many times more as such bounds lay too high at the position \
             before.",
            search::FAR_ABOVE
        ));
    }
    if slides > 0 {
        found.assumptions.push(format!(
            "For {slides} vehicles joints slide in cases up to twice the least factor: the three worst of these were answered again \
             without dilation, and the least factor counts."
        ));
    }
    if found.discrete_elements.is_some() {
        found.warnings.push(super::notes::of_two_points());
    }
    if let Some(inset) = found.discrete_elements.as_ref().and_then(|c| c.inset) {
        found.assumptions.push(format!(
            "Discrete elements bear on contact points {:.0} mm inside the edges of the blocks, where the thrusts of limit analysis at \
             its hinges would crush the masonry.",
            1e3 * inset
        ));
    }
    if bridge.fill_pressure.is_some_and(|fill| fill.applies) {
        found.assumptions.push("Fill presses against movement as [fill_pressure] says.".into());
    }
    let mut factors: Vec<String> = rule.listed().iter().map(|(name, f)| format!("{name} {}", f.value)).collect();
    for (models, acting) in by_acting(&found.vehicles) {
        factors.push(format!(
            "on loads of {models}: live load {}, impact {}",
            acting.live_load.value,
            acting.impact.told()
        ));
    }
    found.assumptions.push(format!("Rule \"{}\": {}.", rule.code, factors.join(", ")));
}

/// What is to be said of vehicles with positions that were not answered.
fn not_converged(all: &[Swept]) -> Option<Warning> {
    let told = |of: &Swept| {
        let bound = of.adequacy_at_most.map_or(String::new(), |most| format!(", its factor at most {most:.3}"));
        format!("{} ({} of {}{bound})", of.code, of.positions_not_converged, of.envelope.len())
    };
    let open: Vec<String> = all.iter().filter(|of| of.positions_not_converged > 0).map(told).collect();
    (!open.is_empty()).then(|| {
        let message =
            format!("positions were not answered, and adequacy factors are not known: of {}", open.join(", "));
        Warning::new(warning::POSITIONS_NOT_CONVERGED, message)
    })
}

/// Factors that are recalled and not read, each with its value: the rule's, then those on the loads of the vehicles.
fn uncertain(rule: &Rule, vehicles: &[Swept]) -> Vec<String> {
    let recalled = |source: &Source| source.confidence == Confidence::Recalled;
    let own = rule.listed().into_iter().filter(|(name, f)| *name != "live load" && recalled(&f.source));
    let mut list: Vec<String> = own.map(|(name, f)| format!("{name} {}", f.value)).collect();
    for (models, acting) in by_acting(vehicles) {
        if recalled(&acting.live_load.source) {
            list.push(format!("live load {} ({models})", acting.live_load.value));
        }
        if acting.impact.sources().into_iter().any(recalled) {
            list.push(format!("impact {} ({models})", acting.impact.told()));
        }
    }
    list
}

/// What the rule does with loads, and the load models that it does it with.
pub fn by_acting(vehicles: &[Swept]) -> Vec<(String, &Acting)> {
    let mut list: Vec<(Vec<&str>, &Acting)> = Vec::new();
    for v in vehicles {
        match list.iter_mut().find(|(_, acting)| **acting == v.acting) {
            Some((models, _)) if !models.contains(&v.model.as_str()) => models.push(&v.model),
            Some(_) => {}
            None => list.push((vec![&v.model], &v.acting)),
        }
    }
    list.into_iter().map(|(models, acting)| (models.join(", "), acting)).collect()
}

/// Vehicles that would not be met if discrete elements took as much off them as off the governing one.
fn near_the_limit(found: &VehicleSweep) -> Option<Warning> {
    let governing = &found.vehicles.get(found.governing?)?.code;
    let second = found.discrete_elements.as_ref()?;
    let share = second.adequacy? / second.limit?;
    let near: Vec<String> = found
        .vehicles
        .iter()
        .filter_map(|v| Some((v, v.adequacy?)))
        .filter(|(v, adequacy)| v.code != *governing && *adequacy >= 1.0 && adequacy * share < 1.0)
        .map(|(v, adequacy)| format!("{} ({adequacy:.2}, then {:.2})", v.code, adequacy * share))
        .collect();
    (!near.is_empty()).then(|| {
        let message = format!(
            "discrete elements carry {share:.2} of the limit load of {governing}; with that share these would not be met: {}",
            near.join(", ")
        );
        Warning::new(warning::NEAR_THE_LIMIT, message)
    })
}

/// Which factors on weights were tried, and which govern.
fn of_weights(found: &VehicleSweep) -> String {
    let [first, ..] = &found.weights[..] else { return String::new() };
    if found.weights.len() == 1 {
        return format!("Dead load has one set of factors, also where it helps: {}.", first.told());
    }
    let least = found.governing.and_then(|k| found.vehicles.get(k)).or(found.vehicles.first());
    let governs = match least.and_then(|v| v.weights.map(|w| (v, w))) {
        Some((v, w)) if v.adequacy.is_some() => format!("{} governs with {}", v.code, w.told()),
        Some((_, w)) => format!("with {} the bridge does not stand", w.told()),
        None => "no combination governs".to_owned(),
    };
    format!(
        "Weights that help have the rule's favourable factor: each of {} combinations of adverse and favourable factors on masonry, fill and \
         surfacing was tried at every position, and the least adequacy factor counts ({governs}).",
        found.weights.len()
    )
}
