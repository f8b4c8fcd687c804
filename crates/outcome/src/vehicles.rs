//! Vehicles moved over the bridge under the factors of a rule: what was found.

mod across;
mod case;
mod grades;
mod sections;
mod swept;
mod weights;

pub use across::Across;
pub use case::{Case, Direction, EnvelopePoint};
pub use grades::{Grade, Graded};
pub use sections::{Extreme, Of, SectionEnvelope};
pub use swept::{Deformable, PermissibleFactor, Swept};
pub use weights::Weights;

use crate::collapse::{Collapse, Status};
use crate::note::Note;
use crate::published::{Object, list, object, said};
use crate::sweep::Ended;
use crate::warning::Warning;
use crate::wire::published;
use bridge::Method;
use rules::{Rule, Source};
use serde::{Deserialize, Serialize};

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
        /// Vehicles of the weight restrictions that the rule names, lightest first up to the first that is not carried: moved where a vehicle of the plan is not.
        = restrictions?: Option<Vec<Swept>> = Some(found.restrictions.clone()).filter(|all| !all.is_empty()),
        /// The same; empty where none were looked up.
        pub restrictions: Vec<Swept> [kept],
        /// The governing case by discrete elements, where the plan asks for it.
        pub discrete_elements?: Option<ByDiscreteElements>,
        /// The governing case as a collapse analysis.
        pub collapse?: Option<Box<Collapse>>,
        /// What was assumed.
        pub assumptions: Vec<Note>,
        /// What a reader should look at.
        pub warnings: Vec<Warning>,
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

impl VehicleSweep {
    /// How it ended: completed only where every position of every vehicle was answered.
    pub fn status(&self) -> Ended {
        let ended = |status| self.vehicles.iter().any(|v| v.status == status);
        match self.governing {
            _ if ended(Status::Cancelled) || self.restrictions.iter().any(|one| one.status == Status::Cancelled) => {
                Ended::Cancelled
            }
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
