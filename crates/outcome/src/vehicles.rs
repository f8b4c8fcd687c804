//! Vehicles moved over the bridge under the factors of a rule: what was found.

mod across;
mod weights;

pub use across::Across;
pub use weights::Weights;

use crate::collapse::{Collapse, Criterion, Status};
use crate::help::NotCounted;
use crate::note::Note;
use crate::published::{Object, list, object, said};
use crate::sweep::Ended;
use crate::warning::Warning;
use crate::wire::published;
use crate::words::words;
use bridge::Method;
use rules::{Acting, Rule, Source};
use serde::{Deserialize, Serialize};

words! {
    /// Which way a vehicle drives.
    pub enum Direction {
        /// To the right.
        Right = "right",
        /// To the left.
        Left = "left",
    }
}

published! {
    /// What stands where.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Case |case| {
        /// Position of the vehicle's first axle, from the left springing of the first span [m].
        pub position: f64 [m],
        /// Which way it drives.
        pub direction: Direction,
        /// Which arrangement: distances and lift-off; empty where there is only one.
        pub arrangement?: String = said(&case.arrangement),
        /// First axle that stands on the bridge, counted from 1 from the front of the vehicle; none where uniform loads stand alone.
        = first_axle: Option<usize> = case.axles.map(|axles| axles[0] + 1),
        /// Last axle that stands on the bridge.
        = last_axle: Option<usize> = case.axles.map(|axles| axles[1] + 1),
        /// First and last axle that stands on the bridge, counted from 0 from the front of the vehicle; none where uniform
        /// loads stand alone.
        pub axles: Option<[usize; 2]> [kept],
        /// The axle with the rule's factor for the critical one.
        pub critical_axle?: Option<usize> = case.critical_axle.map(|axle| axle + 1),
        /// From where to where uniform loads stand [m].
        pub uniform?: Option<[f64; 2]> [m] as uniform_load,
        /// Force along the bridge as a share of all loads, to the right positive: braking or traction.
        #[serde(default)]
        pub horizontal: f64 as horizontal_share,
        /// Sum of the loads with their factors on the effective width [N/m].
        pub load: f64 [kN/m],
        /// Factors on the weights of the bridge meanwhile.
        pub weights: Weights as weight_factors,
    }

    /// The least adequacy factor with a vehicle at a place.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct EnvelopePoint |point| {
        /// Position of the vehicle's first axle [m].
        pub position: f64 [m],
        /// Which way it drives.
        pub direction: Direction,
        /// Which arrangement; empty where there is only one.
        pub arrangement?: String = said(&point.arrangement),
        /// Whether every case there was answered.
        pub converged: bool [kept],
        /// Least adequacy factor over what may stand there; none where a case was not answered or nothing collapses.
        pub adequacy: Option<f64> as adequacy_factor,
        /// First and last axle of what governs.
        pub axles: Option<[usize; 2]> [kept],
        /// The axle of it with the rule's factor for the critical one.
        pub critical_axle: Option<usize> [kept],
        /// From where to where its uniform loads stand [m].
        pub uniform: Option<[f64; 2]> [kept],
        /// Factors on the weights of what governs.
        pub weights: Option<Weights> [kept],
        /// Least adequacy factor of rigid blocks, where deformable joints were followed too: the adequacy factor is the smaller one then.
        pub rigid: Option<f64> as rigid_factor,
        /// Adequacy factor in balance on deformable joints.
        pub deformable: Option<f64> as deformable_factor,
    }
}

impl EnvelopePoint {
    /// A point that is answered by one case, without its factor.
    pub fn at(case: &Case) -> EnvelopePoint {
        EnvelopePoint {
            arrangement: case.arrangement.clone(),
            direction: case.direction,
            position: case.position,
            converged: true,
            adequacy: None,
            axles: case.axles,
            critical_axle: case.critical_axle,
            uniform: case.uniform,
            weights: Some(case.weights),
            rigid: None,
            deformable: None,
        }
    }

    /// Whether it is of the same arrangement that drives the same way, at the same place.
    fn stands_at(&self, other: &EnvelopePoint) -> bool {
        self.position == other.position && self.direction == other.direction && self.arrangement == other.arrangement
    }

    /// Takes the factor of a case on deformable joints: where it is the smaller one, it counts, unless a case was not answered.
    pub fn deforms(&mut self, factor: f64, case: &Case) {
        self.deformable = Some(factor);
        if self.converged && self.adequacy.is_none_or(|rigid| factor < rigid) {
            self.adequacy = Some(factor);
            (self.axles, self.critical_axle) = (case.axles, case.critical_axle);
            (self.uniform, self.weights) = (case.uniform, Some(case.weights));
        }
    }
}

published! {
    /// What a vehicle comes to on deformable joints.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct Deformable |deformable, envelope: &[EnvelopePoint]| {
        /// Whether the state under self-weight was found with all factors on weights.
        pub stands: bool [kept],
        /// Whether the blocks were seen to fall under their own weight with some of them.
        pub falls: bool [kept],
        /// Least adequacy factor in balance over all cases that were followed.
        pub adequacy: Option<f64> as deformable_factor,
        /// At how many positions the path broke off: the last state in balance counts there.
        pub broken_off: usize as paths_broken_off,
        /// The case that has it.
        pub case: Option<Case> as deformable_case,
        /// Adequacy factors at which states are first reached that a bridge should not come to in service, of likely cases (what governs for
        /// rigid blocks, and all that may stand there), each at its worst position; none that is met beyond the least factor of rigid blocks.
        pub permissible: Vec<PermissibleFactor>,
        /// Worst case at every position.
        = envelope: Vec<EnvelopePoint> = envelope,
    }

    /// The adequacy factor at which a state is first reached.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    pub struct PermissibleFactor {
        /// Which state.
        pub criterion: Criterion,
        /// The factor; zero where the self-weight alone brings it about.
        pub adequacy: f64 as adequacy_factor,
        /// Position of the first axle there [m].
        pub position: f64 [m],
    }
}

/// A grade of bridges: that of one which carries a certain vehicle.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Grade {
    /// What it is of: "Route Availability".
    pub of: String,
    /// Its name: "RA8".
    pub name: String,
    /// Its place among all of them, from the lightest up.
    pub rank: usize,
}

published! {
    /// What was found for one vehicle.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Swept |swept| {
        /// Its code.
        pub code: String,
        /// Its name.
        pub title: String,
        /// Code of its load model.
        pub model: String,
        /// The grade of a bridge that carries it, where its load model has grades.
        #[serde(default)]
        pub grade: Option<Grade> [kept],
        /// How the governing case ended.
        pub status: Status,
        /// What all its axle loads may be multiplied by; 1 is just enough. None where nothing makes a mechanism, and where a position was
        /// not answered.
        pub adequacy: Option<f64> as adequacy_factor,
        /// Where positions were not answered: the least factor that the others leave. It bounds the adequacy factor from above and is no
        /// answer.
        pub adequacy_at_most?: Option<f64> as adequacy_factor_at_most,
        = ..NotCounted = swept.not_counted.told(),
        /// What may help the bridge and is not counted.
        #[serde(default)]
        pub not_counted: NotCounted [kept],
        /// Adequacy factor of rigid blocks, or what bounds it from above, where deformable joints were followed too.
        pub rigid?: Option<f64> as rigid_factor,
        = ..Deformable = swept.deformable.as_ref().map(|deformable| deformable.object(&swept.envelope)),
        /// What came of deformable joints; `adequacy` is the smaller factor then.
        pub deformable: Option<Deformable> [kept],
        /// Positions that were tried.
        = positions: usize = swept.envelope.len(),
        /// Worst case at every position.
        pub envelope: Vec<EnvelopePoint> [kept],
        /// At how many positions a case was not answered.
        pub positions_not_converged: usize,
        /// Lower bound of the governing case with dilatant friction.
        = lower_bound: Option<f64> = swept.bounds.map(|bounds| bounds[0]),
        /// Upper bound of the governing case with dilatant friction.
        = upper_bound: Option<f64> = swept.bounds.map(|bounds| bounds[1]),
        /// Bounds of the governing case with dilatant friction.
        pub bounds: Option<[f64; 2]> [kept],
        /// Adequacy factor without dilation, of the worst cases in which joints slide; none where none does.
        pub without_dilation?: Option<f64>,
        /// Width of the barrel that carries an axle [m].
        pub effective_width: f64 [m],
        /// Factor on axles: live load and impact, the largest of all spans.
        = load_factor: f64 = swept.load_factors[0],
        /// The same span by span: motion adds by the length of the loaded span.
        pub span_factors: Vec<f64> as load_factor_per_span,
        /// What the critical axle has besides.
        = critical_axle_factor: f64 = swept.load_factors[1],
        /// Factor on axles: live load and impact, the largest of all spans; and what the critical axle has besides.
        pub load_factors: [f64; 2] [kept],
        /// Factor on live loads, without what motion adds.
        = live_load_factor: f64 = swept.acting.live_load.value,
        /// What motion adds to the loads of a vehicle by the rule: `rule`, `sources`.
        = impact: Object = object! {
            rule: swept.acting.impact.told(),
            sources: list(swept.acting.impact.sources(), source),
        },
        /// What the rule does with its loads.
        pub acting: Acting [kept],
        = ..Across = Some(swept.across.object()),
        /// How vehicles stand across the bridge.
        pub across: Across [kept],
        /// Where the vehicle is from: `text`, `date`, `confidence`, `note`.
        pub source: Source = source(&swept.source),
        /// Factors on weights with which it governs, or with which the bridge does not stand.
        pub weights: Option<Weights> as weight_factors,
        /// The governing case.
        pub case: Option<Case>,
        /// What critical joints carry under the vehicle, as elastic ones.
        pub sections: Vec<SectionEnvelope>,
        /// How many cases were answered.
        pub cases: usize,
        /// How many of them had to be left to the interior-point method.
        pub by_interior_point: usize,
    }
}

impl Swept {
    /// A position at which joints slide, answered again without dilation: the smaller factor counts, and where every load was carried with
    /// dilation, this one.
    pub fn slides_at(&mut self, at: &EnvelopePoint, level: Option<f64>) {
        for point in self.envelope.iter_mut().filter(|p| p.stands_at(at)) {
            point.converged &= level.is_some();
            let smaller = |level: f64| point.adequacy.map_or(level, |old| old.min(level));
            point.adequacy = level.filter(|_| point.converged).map(smaller);
        }
    }

    /// Takes points of the envelope at which cases found no answer as answered: this factor is proven to be carried there by all of them,
    /// and does not govern.
    pub fn is_settled(&mut self, at: &EnvelopePoint, carried: f64) {
        for point in self.envelope.iter_mut().filter(|p| p.stands_at(at) && !p.converged) {
            (point.converged, point.adequacy) = (true, Some(carried));
        }
    }

    /// Says how it ended, with the least factor of what was answered: an adequacy factor only where everything was.
    pub fn end(&mut self, whole: bool, least: Option<f64>) {
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

    /// Says that it was stopped before all of it was answered.
    pub fn cancel(&mut self) {
        let least = self.factor();
        self.end(false, least);
    }

    /// Takes the result of the governing case by itself: where it carries less, the smaller factor counts, and where it
    /// found none, nothing is settled.
    pub fn governed_by(&mut self, run: &Collapse, capacity: f64) {
        // What is carried where no load was found bounds nothing from above; a state in balance is carried.
        let answered = run.status == Status::Collapsed || run.along().is_some();
        let by_itself = run.carried().filter(|_| answered).map(|load| load / run.reference_load * capacity);
        self.counts(by_itself);
    }

    /// Takes the adequacy factor of the governing case by another method: the smaller one counts, and where there is none, nothing is
    /// settled.
    pub fn counts(&mut self, by_itself: Option<f64>) {
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

    /// Takes what came of a case at a point of the envelope where fill yields as a continuum: the smaller factor counts. Loads that nothing
    /// makes fail there count for nothing; where no answer was found, nothing is settled.
    pub fn yields(&mut self, point: usize, case: &Case, (status, factor): (Status, Option<f64>)) {
        let least = self.factor();
        let point = &mut self.envelope[point];
        match (status, factor) {
            (Status::Locks, _) => {}
            (Status::UnstableUnderSelfWeight, _) => {
                (self.adequacy, self.adequacy_at_most) = (None, None);
                (self.status, self.case, self.weights) = (status, None, Some(case.weights));
            }
            _ if self.status == Status::UnstableUnderSelfWeight => {}
            (Status::Collapsed, Some(factor)) => {
                if point.converged && point.adequacy.is_none_or(|weight| factor < weight) {
                    let own = EnvelopePoint { rigid: point.rigid, ..EnvelopePoint::at(case) };
                    *point = EnvelopePoint { adequacy: Some(factor), ..own };
                }
                if least.is_none_or(|before| factor < before) {
                    (self.case, self.weights) = (Some(case.clone()), Some(case.weights));
                    self.end(true, Some(factor));
                }
            }
            _ => {
                (point.converged, point.adequacy) = (false, None);
                self.end(true, least);
            }
        }
    }

    /// Takes what came of a vehicle whose loads are so many times smaller, where fill yields as a continuum.
    pub fn yields_like(&mut self, of: &Swept, times: f64) {
        let less = |factor: Option<f64>| factor.map(|factor| factor / times);
        (self.adequacy, self.adequacy_at_most) = (less(of.adequacy), less(of.adequacy_at_most));
        (self.status, self.weights) = (of.status, of.weights);
        self.positions_not_converged = of.positions_not_converged;
        self.case = of.case.clone().map(|case| Case { load: case.load * times, ..case });
        let points = of.envelope.iter().map(|p| EnvelopePoint { adequacy: less(p.adequacy), ..p.clone() });
        self.envelope = points.collect();
    }

    /// Takes what came of deformable joints. The smaller factor counts; where the state under self-weight was not found, nothing is
    /// settled.
    pub fn judged_with(&mut self, deformable: Deformable) {
        self.rigid = self.factor();
        if deformable.falls {
            (self.adequacy, self.adequacy_at_most) = (None, None);
            (self.status, self.case) = (Status::UnstableUnderSelfWeight, None);
        } else if !deformable.stands {
            (self.adequacy, self.adequacy_at_most) = (None, self.factor());
            self.positions_not_converged = self.envelope.len();
            self.status = Status::NotConverged;
        } else if let Some(factor) = deformable.adequacy.filter(|factor| self.rigid.is_none_or(|rigid| *factor < rigid))
        {
            self.case.clone_from(&deformable.case);
            self.weights = self.case.as_ref().map(|case| case.weights);
            match self.status {
                Status::Collapsed | Status::Locks => {
                    (self.adequacy, self.status) = (Some(factor), Status::Collapsed);
                }
                _ => self.adequacy_at_most = Some(factor),
            }
        }
        self.deformable = Some(deformable);
    }

    /// Takes what came of deformable joints from a vehicle whose loads are so many times smaller.
    pub fn deforms_like(&mut self, of: &Swept, times: f64) {
        let less = |factor: Option<f64>| factor.map(|factor| factor / times);
        let points = of.envelope.iter().map(|p| EnvelopePoint {
            adequacy: less(p.adequacy),
            rigid: less(p.rigid),
            deformable: less(p.deformable),
            ..p.clone()
        });
        self.envelope = points.collect();
        let Some(of) = &of.deformable else { return };
        let case = of.case.clone().map(|case| Case { load: case.load * times, ..case });
        let permissible = of.permissible.iter().map(|p| PermissibleFactor { adequacy: p.adequacy / times, ..*p });
        let deformable =
            Deformable { adequacy: less(of.adequacy), case, permissible: permissible.collect(), ..of.clone() };
        self.judged_with(deformable);
    }

    /// Whether deformable joints carry less than rigid blocks.
    pub fn is_deformable_governing(&self) -> bool {
        let own = self.deformable.as_ref().and_then(|deformable| deformable.adequacy);
        own.is_some_and(|own| self.rigid.is_none_or(|rigid| own < rigid))
    }

    /// Whether it is carried under the factors of the rule; none where nothing is settled.
    pub fn is_carried(&self) -> Option<bool> {
        match (self.status, self.adequacy, self.adequacy_at_most) {
            (Status::Locks, ..) => Some(true),
            (Status::UnstableUnderSelfWeight, ..) => Some(false),
            (_, Some(factor), _) => Some(factor >= 1.0),
            (_, None, Some(most)) if most < 1.0 => Some(false),
            _ => None,
        }
    }

    /// The size by which runs of a vehicle are compared: one without an answer comes first, since its factor may be the least.
    pub fn size(&self) -> f64 {
        match self.factor() {
            Some(factor) => factor,
            None if self.status == Status::Locks => f64::INFINITY,
            None => f64::NEG_INFINITY,
        }
    }

    /// The adequacy factor, or what bounds it from above.
    pub fn factor(&self) -> Option<f64> {
        self.adequacy.or(self.adequacy_at_most)
    }
}

/// The sweep and a case by itself agree to this: both bounds of either do.
const SAME: f64 = 1e-6;

published! {
    /// What was found for all vehicles.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct VehicleSweep |found| {
        = schema: String = "extrados.vehicle-sweep/1",
        = status: String = found.status(),
        /// Name of the bridge.
        pub bridge: String,
        /// The rule with its factors and their sources: `code`, `title`, `source`, `factors`.
        pub rule: Rule = object! {
            code: found.rule.code,
            title: found.rule.title,
            source: source(&found.rule.source),
            factors: list(found.rule.listed(), |(name, factor)| object! {
                name: name,
                value: factor.value,
                source: source(&factor.source),
            }),
        },
        /// The combinations of factors on weights that were tried.
        pub weights: Vec<Weights> as weight_combinations,
        /// Distance between positions [m].
        pub step: f64 [m],
        /// At how many positions a case was not answered, over all vehicles.
        = positions_not_converged: usize = found.positions_not_converged(),
        /// What the bridge is worth in the grades of the load models that have them.
        = grades?: Option<Vec<Graded>> = Some(found.grades()).filter(|all| !all.is_empty()),
        /// The governing position, as in sweeps of the file's own loads, with its vehicle and its `adequacy_factor`.
        = governing: Option<Object> = found.worst(),
        /// The vehicle with the least adequacy factor, or the least bound on it.
        pub governing: Option<usize> [kept],
        /// Every vehicle, in the order of the plan.
        pub vehicles: Vec<Swept>,
        /// The governing case by discrete elements, where the plan asks for it.
        pub discrete_elements?: Option<ByDiscreteElements>,
        /// The governing case as a collapse analysis.
        pub collapse?: Option<Box<Collapse>>,
        /// What was assumed.
        pub assumptions: Vec<Note>,
        /// What a reader should look at.
        pub warnings: Vec<Warning>,
    }

    /// What a bridge is worth in the grades of a load model, lightest first: those of the vehicles that were asked for.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct Graded {
        /// What the grades are of: "Route Availability".
        pub of: String,
        /// The last grade up to which every one is carried with an adequacy factor of 1 or more.
        pub highest: Option<String>,
        /// Those that are carried.
        pub carried: Vec<String>,
        /// Those that are not.
        pub not_carried: Vec<String>,
        /// Those for which nothing is settled.
        pub unanswered: Vec<String>,
    }
}

impl Graded {
    /// Every grade in words: what is carried, what is not, what is not settled.
    pub fn all_told(&self) -> String {
        let lists = [("carried", &self.carried), ("not carried", &self.not_carried), ("not settled", &self.unanswered)];
        let told = lists.iter().filter(|(_, grades)| !grades.is_empty());
        told.map(|(words, grades)| format!("{words}: {}", grades.join(", "))).collect::<Vec<_>>().join("; ")
    }

    /// The highest grade in words.
    pub fn told(&self) -> String {
        match (&self.highest, self.not_carried.first().or(self.unanswered.first())) {
            (Some(highest), _) => highest.clone(),
            (None, Some(first)) => format!("less than {first}"),
            (None, None) => "nothing is settled".to_owned(),
        }
    }
}

impl VehicleSweep {
    /// The grades of the bridge, one list for each load model that has them.
    pub fn grades(&self) -> Vec<Graded> {
        let mut vehicles: Vec<(&Grade, &Swept)> =
            self.vehicles.iter().filter_map(|one| Some((one.grade.as_ref()?, one))).collect();
        vehicles.sort_by_key(|(grade, _)| grade.rank);
        let mut found: Vec<Graded> = Vec::new();
        for (Grade { of, name, .. }, one) in vehicles {
            let at = found.iter().position(|graded| graded.of == *of).unwrap_or_else(|| {
                found.push(Graded { of: of.clone(), ..Graded::default() });
                found.len() - 1
            });
            let graded = &mut found[at];
            let list = match one.is_carried() {
                Some(true) => &mut graded.carried,
                Some(false) => &mut graded.not_carried,
                None => &mut graded.unanswered,
            };
            list.push(name.clone());
            if graded.not_carried.is_empty() && graded.unanswered.is_empty() {
                graded.highest = Some(name.clone());
            }
        }
        found
    }

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

    /// The governing position as others read it.
    fn worst(&self) -> Option<Object> {
        let (swept, headline) = (self.vehicles.get(self.governing?)?, self.headline());
        Some(object! {
            vehicle: swept.code,
            adequacy_factor: headline.map(|headline| headline.0),
            adequacy_factor_at_most?: swept.adequacy_at_most,
            method: headline.map(|headline| headline.1),
            ..swept.not_counted.told(),
            ..swept.case.as_ref().map(|case| case.object()),
        })
    }

    /// The headline: the governing vehicle's factor by the method that gives less, and that method. None where it is not known.
    pub fn headline(&self) -> Option<(f64, Method)> {
        let governing = self.vehicles.get(self.governing?)?;
        let own = governing.adequacy?;
        let second = self.discrete_elements.as_ref().and_then(|second| second.adequacy);
        Some(match second {
            Some(second) if second < own => (second, Method::Dem),
            _ if governing.is_deformable_governing() => (own, Method::Path),
            _ => (own, Method::Limit),
        })
    }
}

fn source(of: &Source) -> Object {
    object! { text: of.text, date: of.date, confidence: of.confidence, note?: said(&of.note), }
}

words! {
    /// What is extreme.
    pub enum Of {
        /// Largest compression.
        LargestThrust = "largest thrust",
        /// Smallest compression.
        SmallestThrust = "smallest thrust",
        /// Thrust farthest outwards.
        OutermostThrust = "outermost thrust",
        /// Thrust farthest inwards.
        InnermostThrust = "innermost thrust",
        /// Largest shear.
        LargestShear = "largest shear",
    }
}

published! {
    /// An extreme and what goes with it.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Extreme {
        /// Of what.
        pub of: Of,
        /// Compression [N/m].
        pub thrust: f64 [kN/m],
        /// Distance of the thrust from the middle of the joint [m], outwards positive; on piers to the left.
        pub eccentricity: f64 [m],
        /// Whether that lies outside the joint: no ring without tension carries it so; joints open and hinges form.
        pub outside: bool as outside_section,
        /// Shear [N/m].
        pub shear: f64 [kN/m],
        /// The case.
        pub case: Case,
    }

    /// A critical joint.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct SectionEnvelope |section| {
        /// Where: "span 1 left springing".
        pub name: String,
        = x: f64 [m] = section.at[0],
        = y: f64 [m] = section.at[1],
        /// Middle of the joint [m].
        pub at: [f64; 2] [kept],
        /// Length of the joint between its contact points [m].
        pub depth: f64 [m],
        /// Extremes over all cases.
        pub extremes: Vec<Extreme>,
    }

    /// The governing case by discrete elements.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct ByDiscreteElements {
        = method: Method = Method::Dem,
        /// How it ended; none where it could not be made.
        pub status: Option<Status>,
        /// Adequacy factor of the last load step that was carried.
        pub adequacy: Option<f64> as adequacy_factor,
        /// The same by limit analysis.
        pub limit: Option<f64> as limit_adequacy_factor,
        /// Load step, as an adequacy factor.
        pub step: f64,
        /// How far inside the edges contact points were put for crushing [m], beyond the file's own rounding; none where masonry does
        /// not crush or blocks are too small for it.
        pub inset: Option<f64> [m] as contact_inset,
        /// Why it could not be made.
        pub reason?: Option<String>,
    }
}
