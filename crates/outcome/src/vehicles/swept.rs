//! What was found for one vehicle, by rigid blocks, on deformable joints and where fill yields.

use super::across::Across;
use super::case::{Case, EnvelopePoint};
use super::grades::Grade;
use super::sections::SectionEnvelope;
use super::source;
use super::weights::Weights;
use crate::collapse::{Collapse, Criterion, Status};
use crate::help::NotCounted;
use crate::published::{list, object};
use crate::wire::published;
use rules::{Acting, Source};
use serde::{Deserialize, Serialize};

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
                    *point = EnvelopePoint { adequacy: Some(factor), ..EnvelopePoint::at(case.clone()) };
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
