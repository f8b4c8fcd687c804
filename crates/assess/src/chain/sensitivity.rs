//! What would change the verdict: the governing utilisation with a tenth less and a tenth more of every quantity that may
//! matter, by the cheapest analysis that shows it.

use super::Scope;
use super::service::{service, window};
use super::ultimate::at_position;
use crate::analysis::parallel;
use crate::analysis::state::{self, Change};
use crate::analysis::vehicles::vehicle_sweep;
use crate::checks::{CHECKS, Check, Probe};
use crate::evidence::Evidence;
use bridge::Bridge;
use bridge::edit::Document;
use bridge::vary::{Spread, Varied, find, known, settle};
use mechanics::watch::{CancelToken, Watch};
use outcome::assessment::Stage;
use outcome::checked::{Checked, Comparison, governing};
use outcome::facts::{ChangeFacts, SensitivityFacts};
use outcome::passage::PassageStatus;

/// Share by which quantities are changed.
const SHARE: f64 = 0.1;
/// Most quantities: what comes first in the file is tried.
const MOST: usize = 18;
/// Cases of the governing vehicle, answered one by one, beyond which no values are tried: some tens of milliseconds each, for every value.
const SLOW: usize = 200;

/// Keys of quantities that may matter to an analysis.
fn matters(probe: Probe, path: &str) -> bool {
    let key = path.rsplit('.').next().unwrap_or_default();
    let section = path.split(['.', '[']).next().unwrap_or_default();
    let body = ["span", "masonry", "joint", "cover", "backing"].contains(&section);
    let soil = ["fill", "haunch_fill", "abutment_fill", "mortar", "track"].contains(&section);
    let of_size = ["thickness", "crown_thickness", "rise"].contains(&key);
    match probe {
        Probe::Collapse | Probe::Vehicle => {
            body && (of_size || ["density", "friction_angle", "compressive_strength", "height"].contains(&key))
        }
        Probe::Itself => body && of_size,
        Probe::Sensors | Probe::Joints | Probe::Whole => {
            let stiffness = ["elastic_modulus", "cohesion", "friction_angle", "effective_width"].contains(&key);
            (soil && stiffness)
                || (body
                    && section != "joint"
                    && ["thickness", "crown_thickness", "density", "elastic_modulus"].contains(&key))
        }
    }
}

/// Makes it for the check that governs. `document` is the text that the assessed bridge was read from.
///
/// # Errors
/// In words: no check that governs, one that takes a whole analysis for every value, or one that gives nothing for the file's own values.
pub fn sensitivity(
    document: &Document,
    own: &Evidence,
    checked: &[Checked],
    watch: &mut dyn Watch,
) -> Result<Option<SensitivityFacts>, String> {
    let nothing = "no check could be made, so that none governs";
    let (check, finding) = governing(checked).ok_or(nothing)?;
    let (check, checked) = (&CHECKS[check], &checked[check]);
    let governing = &checked.outcome.as_ref().map_err(|_| nothing)?[finding];
    let too_dear = || format!("{} takes a whole analysis for every value: make them with extrados vary", check.title);
    let how = match check.probe {
        Probe::Whole => return Err(too_dear()),
        Probe::Vehicle if is_slow(own, &governing.load_model) => return Err(too_dear()),
        Probe::Itself => "the method itself",
        Probe::Vehicle => "limit analysis of the governing vehicle alone",
        Probe::Collapse => "limit analysis with the loads where they govern",
        Probe::Sensors | Probe::Joints => "finite elements, a few positions of the train about the one that governs",
    };
    let probe = Changed { own, check, governing };
    // What is sought stands between bounds that a tenth more may pass.
    let mut plain = document.clone();
    bridge::UPDATE_SECTIONS.iter().chain(&["vary", "expected"]).for_each(|section| plain.remove(section));
    let document = &plain;
    let stage = parallel::Stage { name: "the governing check by itself", steps: 1, shares: [0.0, 0.0] };
    let (base, done) = parallel::each(&[()], &stage, watch, |(), token| probe.utilisation(&own.bridge, token));
    if !done {
        return Ok(None);
    }
    let no_baseline = || format!("the shortened analysis gives no utilisation of {}", check.title);
    let base = base.into_iter().flatten().flatten().next().ok_or_else(no_baseline)?;
    let list: Vec<Varied> = known(document)
        .into_iter()
        .filter(|quantity| matters(check.probe, &quantity.path))
        .filter_map(|quantity| {
            let found = find(document, &quantity.path).ok()?;
            let values = [1.0 - SHARE, 1.0 + SHARE].map(|share| format!("x{share}"));
            settle(&found, &Spread::List(values.map(|value| format!("\"{value}\"")).to_vec())).ok()
        })
        .take(MOST)
        .collect();
    let stage = parallel::Stage { name: "sensitivities", steps: list.len() as u64, shares: [0.0, 1.0] };
    let (found, done) = parallel::each(&list, &stage, watch, |varied, token| {
        let change = probe.change(document, varied, token);
        token.step();
        change
    });
    if !done {
        return Ok(None);
    }
    let mut quantities: Vec<ChangeFacts> = found.into_iter().flatten().collect();
    let told = |change: &ChangeFacts| {
        [change.less, change.more].iter().flatten().map(|value| (value - base).abs()).fold(0.0, f64::max)
    };
    quantities.sort_by(|a, b| told(b).total_cmp(&told(a)).then(a.path.cmp(&b.path)));
    Ok(Some(SensitivityFacts {
        code: check.code.to_owned(),
        utilisation: base,
        how: how.to_owned(),
        share: SHARE,
        quantities,
    }))
}

/// Whether a sweep of a vehicle takes minutes: its cases are answered one by one.
fn is_slow(own: &Evidence, code: &str) -> bool {
    let facts = own.facts.vehicles.made();
    facts.is_some_and(|facts| facts.vehicles.iter().any(|one| one.code == code && one.slow_cases > SLOW))
}

/// The governing check on other bridges.
struct Changed<'a> {
    own: &'a Evidence,
    check: &'a Check,
    governing: &'a Comparison,
}

impl Changed<'_> {
    fn change(&self, document: &Document, varied: &Varied, token: &CancelToken) -> ChangeFacts {
        let value = |k: usize| {
            let mut edited = document.clone();
            edited.set(&varied.path, &varied.values.get(k)?.literal).ok()?;
            let mut bridge = bridge::read(edited.text().as_bytes()).bridge?;
            bridge.take_over(&self.own.bridge);
            self.utilisation(&bridge, token)
        };
        ChangeFacts {
            path: varied.path.to_string(),
            value: varied.own.as_ref().map(|own| own.text.clone()).unwrap_or_default(),
            less: value(0),
            more: value(1),
        }
    }

    /// Largest utilisation of the check by the shortened analysis; none where that gives nothing.
    fn utilisation(&self, bridge: &Bridge, token: &CancelToken) -> Option<f64> {
        let watch = &mut token.clone();
        let mut a = self.own.clone();
        a.bridge = bridge.clone();
        match self.check.probe {
            Probe::Itself => {}
            Probe::Vehicle => {
                let mut alone = state::with(bridge, &[Change::FillAsWeight]);
                let plan = alone.sweep.as_mut()?;
                plan.vehicles = vec![self.governing.load_model.clone()];
                plan.discrete_elements = false;
                let found = vehicle_sweep(&alone, watch).ok()?;
                a.facts.vehicles = Stage::Made(super::vehicle_facts(&alone, &found));
            }
            Probe::Collapse => {
                let parts = self.own.facts.ultimate.made().map_or(&[][..], |facts| &facts.shortened);
                let mut facts = at_position(bridge, self.governing.position?, parts, watch).ok()?;
                facts.load.clone_from(&self.governing.load_model);
                a.facts.ultimate = Stage::Made(facts);
            }
            Probe::Whole => return None,
            Probe::Sensors | Probe::Joints => {
                let mut short = bridge.clone();
                window(&mut short, self.governing.position?);
                let mut asked = self.own.asked.clone();
                asked.service_loads.retain(|load| self.governing.load_model.starts_with(&load.name));
                let wanted = if self.check.probe == Probe::Joints { Scope::Everything } else { Scope::Sensors };
                let (facts, _) = service(&short, &asked, wanted, watch).ok()?;
                if facts.loads.iter().any(|load| load.status != PassageStatus::Completed) {
                    return None;
                }
                a.facts.service = Stage::Made(facts);
            }
        }
        let found = (self.check.run)(&a).ok()?;
        // Compression and tension of one load have limits of opposite signs.
        let same = found.iter().filter(|finding| {
            finding.load_model == self.governing.load_model
                && finding.limit.is_sign_negative() == self.governing.limit.is_sign_negative()
        });
        same.map(|finding| finding.utilisation).reduce(f64::max)
    }
}
