//! States that a bridge should not come to in service, and how far from them it is.

use super::check::{Check, CheckCard, Probe, limit, of};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};
use outcome::collapse::Criterion;

/// The check.
pub(super) struct Onset;

impl Check for Onset {
    fn card(&self) -> CheckCard {
        CheckCard {
            code: "C205",
            keys: ["load", "assess.onset_factor"],
            title: "states in service",
            clause: "factor on loads at which a joint is half open, at half its strength, or the bridge at half its stiffness",
            text: "The least factor on nominal loads (of a vehicle with impact, without the rule's factor on live loads; of \
                   the file as they are) at which a joint is open over half of its depth, is stressed to half of its \
                   strength, or the stone that moves most does so twice as far as at first for a little more load. It is found along \
                   the equilibrium path on deformable joints, at every position, and is compared with onset_factor of \
                   [assess]. It says from which load damage begins, and nothing about collapse. The thrust leaves the middle third \
                   of a joint earlier: that factor stands in the result and is not compared.",
            source: "the permissible limit state of masonry arches: Melbourne, Wang and Tomor, Proc. ICE Bridge Engineering 160 (2007) \
                     [recalled]; the three states and their shares are the program's own",
        }
    }

    fn probe(&self) -> Probe {
        Probe::Whole
    }

    fn run(&self, a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
        let wanted = limit(a.asked.limits.onset_factor, "onset_factor = …", "from the owner of the bridge")?;
        let mut states = of_vehicles(a);
        states.extend(of_the_file(a));
        if states.is_empty() {
            let why = "no such state was met, or joints were taken as rigid: write method = \"path\" in [analysis]";
            return Err(NotMade::because(why));
        }
        Ok(states.into_iter().map(|state| state.compared(wanted)).collect())
    }
}

/// The first state that a load brings about.
struct Onsets {
    load: String,
    criterion: Criterion,
    factor: f64,
    position: Option<f64>,
    what: String,
}

impl Onsets {
    fn compared(self, wanted: f64) -> Comparison {
        Comparison {
            load_model: self.load,
            value: self.factor,
            limit: wanted,
            unit: Unit::Ratio,
            utilisation: if self.factor > 0.0 { wanted / self.factor } else { f64::MAX },
            basis: format!("{} at this multiple of {}", self.criterion.word(), self.what),
            position: self.position,
            columns: None,
            strength: false,
            needed: None,
        }
    }
}

/// Whether a state counts: thrusts leave the middle third of some joint in many sound bridges.
fn counts(criterion: Criterion) -> bool {
    criterion != Criterion::MiddleThird
}

fn of_vehicles(a: &Evidence) -> Vec<Onsets> {
    let Ok(facts) = of(&a.facts.vehicles) else { return Vec::new() };
    let first = |one: &outcome::facts::SweptFacts| {
        let counting = one.permissible.iter().filter(|p| counts(p.criterion));
        let least = counting.min_by(|a, b| a.adequacy.total_cmp(&b.adequacy))?;
        Some(Onsets {
            load: one.code.clone(),
            criterion: least.criterion,
            factor: least.adequacy * facts.safety.live_load,
            position: Some(least.position),
            what: format!("{} with impact, without the factor {} on live loads", one.title, facts.safety.live_load),
        })
    };
    facts.vehicles.iter().filter_map(first).collect()
}

fn of_the_file(a: &Evidence) -> Option<Onsets> {
    let facts = of(&a.facts.ultimate).ok()?;
    let counting = facts.permissible.iter().filter(|p| counts(p.criterion));
    let least = counting.min_by(|a, b| a.load.total_cmp(&b.load))?;
    Some(Onsets {
        load: facts.load.clone(),
        criterion: least.criterion,
        factor: least.load / 1e3 / facts.reference_load_kn_per_m,
        position: facts.position_m,
        what: "the loads of the file, where they govern".to_owned(),
    })
}
