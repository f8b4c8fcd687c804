//! What may stand on the bridge with the first axle at a place: its effects, and each case in words.

use super::super::moving::{Key, Stands, runs};
use super::cases::{Drive, borders, range};
use super::factored::{Footprint, clipped};
use bridge::Bridge;
use mechanics::limit::{Effect, Sweeper};
use outcome::vehicles::Case;
use outcome::vehicles::Weights;
use structure::discretise::Discretised;
use structure::discretise::cover::Surface;
use structure::discretise::dispersal::{Strip, spread};
use structure::discretise::extrados::Extrados;

/// Vehicles on a bridge.
pub(in crate::analysis) struct Standing {
    /// The road and the backs of the rings; they are the same under all weights.
    surface: Surface,
    extrados: Extrados,
    /// Combinations of factors on weights.
    pub(super) weights: Vec<Weights>,
    /// How axles stand, for each vehicle.
    pub(super) feet: Vec<Footprint>,
    /// Every drive.
    pub(super) drives: Vec<Drive>,
    /// Places of the first axle at which something may stand over the arches [m].
    pub range: [f64; 2],
    /// Borders of pieces with uniform loads [m].
    borders: Vec<f64>,
}

impl Stands for Standing {
    fn cases(&self, sweeper: &mut Sweeper<'_>, index: usize, position: f64) -> Vec<(Key, Effect)> {
        let drive = &self.drives[index];
        let foot = &self.feet[drive.vehicle];
        // Axles that reach the arches; they are neighbours, for axles follow one another.
        let mut axles: Vec<(usize, Effect)> = Vec::new();
        for (k, axle) in drive.pattern.axles.iter().enumerate() {
            let middle = drive.axle_at(position, k);
            let strip = Strip {
                middle,
                length: foot.length,
                force: axle.force * foot.axle_at(middle) / foot.across.axles,
                horizontal: foot.horizontal,
                is_pressure: false,
            };
            if let Some(effect) = self.effect(sweeper, foot, strip) {
                axles.push((k, effect));
            }
        }
        let uniform = self.uniform(sweeper, index, position);
        let mut cases = Vec::new();
        let none: [usize; 2] = [0, 0];
        let runs_of_axles = runs(axles.len(), drive.subsets);
        let with_none = std::iter::once((None, none)).filter(|_| axles.is_empty() || drive.subsets);
        let mut stands = sweeper.nothing();
        for (run, [a, b]) in runs_of_axles.into_iter().map(|r| (Some(r), r)).chain(with_none) {
            // A run that has one axle more than the one before only adds it.
            match run {
                Some(_) if a == b || !drive.subsets => {
                    stands = axles[a].1.clone();
                    axles[a + 1..=b].iter().for_each(|(_, effect)| stands.add(effect, 1.0));
                }
                Some(_) => stands.add(&axles[b].1, 1.0),
                None => stands = sweeper.nothing(),
            }
            let criticals: Vec<Option<usize>> = match run {
                Some(_) if foot.critical != 1.0 => (a..=b).map(Some).collect(),
                _ => vec![None],
            };
            for critical in criticals {
                let mut with_critical = stands.clone();
                if let Some(k) = critical {
                    with_critical.add(&axles[k].1, foot.critical - 1.0);
                }
                for (pieces, effect) in &uniform {
                    if run.is_none() && pieces.is_none() {
                        continue;
                    }
                    let mut whole = with_critical.clone();
                    if let Some(effect) = effect {
                        whole.add(effect, 1.0);
                    }
                    let key = Key {
                        drive: index,
                        weights: 0,
                        position,
                        axles: run.map(|[a, b]| [axles[a].0, axles[b].0]),
                        critical: critical.map(|k| axles[k].0),
                        uniform: *pieces,
                    };
                    cases.push((key, whole));
                }
            }
        }
        cases
    }
}

impl Standing {
    /// Drives of vehicles over a bridge and its blocks.
    pub(super) fn new(
        (bridge, d): (&Bridge, &Discretised),
        weights: &[Weights],
        feet: Vec<Footprint>,
        drives: Vec<Drive>,
    ) -> Standing {
        let range = range(d, &feet);
        let (surface, extrados, borders) = (d.surface.clone(), d.extrados.clone(), borders(bridge, range));
        Standing { surface, extrados, weights: weights.to_vec(), feet, drives, range, borders }
    }

    /// Uniform loads: none, and every run of half spans; all of them where they may not be left out.
    fn uniform(&self, sweeper: &mut Sweeper, index: usize, position: f64) -> Vec<(Option<[usize; 2]>, Option<Effect>)> {
        let drive = &self.drives[index];
        if drive.pattern.stretches.is_empty() {
            return vec![(None, None)];
        }
        let droppable = drive.pattern.stretches.iter().all(|s| s.may_be_dropped);
        let pieces: Vec<Option<Effect>> =
            self.borders.windows(2).map(|pair| self.piece(sweeper, index, position, [pair[0], pair[1]])).collect();
        let count = pieces.len();
        let mut found = if droppable { vec![(None, None)] } else { Vec::new() };
        for [a, b] in runs(count, droppable) {
            // Runs that begin or end with nothing are the same as shorter ones.
            if droppable && (pieces[a].is_none() || pieces[b].is_none()) {
                continue;
            }
            let mut whole = sweeper.nothing();
            pieces[a..=b].iter().flatten().for_each(|effect| whole.add(effect, 1.0));
            found.push((Some([a, b]), Some(whole)));
        }
        found
    }

    fn piece(&self, sweeper: &mut Sweeper, index: usize, position: f64, range: [f64; 2]) -> Option<Effect> {
        let drive = &self.drives[index];
        let foot = &self.feet[drive.vehicle];
        let mut sum: Option<Effect> = None;
        let case = self.bare(index, position);
        for (from, to, pressure) in clipped(&drive.pattern, foot, &case, range) {
            let strip = Strip {
                middle: 0.5 * (from + to),
                length: to - from,
                force: pressure * (to - from),
                horizontal: foot.horizontal,
                is_pressure: true,
            };
            if let Some(effect) = self.effect(sweeper, foot, strip) {
                match &mut sum {
                    Some(sum) => sum.add(&effect, 1.0),
                    None => sum = Some(effect),
                }
            }
        }
        sum
    }

    fn effect(&self, sweeper: &mut Sweeper, foot: &Footprint, strip: Strip) -> Option<Effect> {
        let spread = spread(strip, foot.dispersal, &self.surface, &self.extrados);
        (!spread.forces.is_empty()).then(|| sweeper.effect(&spread.forces))
    }

    fn bare(&self, index: usize, position: f64) -> Case {
        let drive = &self.drives[index];
        Case {
            position,
            direction: drive.direction,
            arrangement: drive.pattern.label.clone(),
            axles: None,
            critical_axle: None,
            uniform: None,
            weights: self.weights[0],
            horizontal: self.feet[drive.vehicle].horizontal,
            load: 0.0,
        }
    }

    /// A case by its places, without its load.
    pub(super) fn placed(&self, key: &Key) -> Case {
        let (axles, critical_axle, weights) = (key.axles, key.critical, self.weights[key.weights]);
        let uniform = key.uniform.map(|[a, b]| [self.borders[a], self.borders[b + 1]]);
        Case { axles, critical_axle, weights, uniform, ..self.bare(key.drive, key.position) }
    }

    /// A case in words.
    pub(super) fn told(&self, key: &Key) -> Case {
        let drive = &self.drives[key.drive];
        let foot = &self.feet[drive.vehicle];
        let mut case = self.placed(key);
        if let Some([first, last]) = key.axles {
            for (k, axle) in drive.pattern.axles.iter().enumerate().take(last + 1).skip(first) {
                let critical = if key.critical == Some(k) { foot.critical } else { 1.0 };
                case.load += axle.force * critical * foot.axle_at(drive.axle_at(key.position, k)) / foot.across.axles;
            }
        }
        if let Some(range) = case.uniform {
            let parts = clipped(&drive.pattern, foot, &case, range);
            case.load += parts.iter().map(|(from, to, pressure)| pressure * (to - from)).sum::<f64>();
        }
        case
    }
}
