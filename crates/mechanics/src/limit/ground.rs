//! What many loads on one model have in common: joints, permanent loads, states of self-stress.

use super::bedded::Bedded;
use super::collapse::{Carried, carried};
use super::compliance::Stiffness;
use super::equilibrium::Equilibrium;
use super::reduced::{Row, rows, self_stress};
use super::rows::Rows;
use super::settings::Settings;
use super::simplex::{Member, Start};
use crate::blocks::{BlockModel, Interface, Loading, ModelError, PointForce};

/// What all loads have in common.
pub struct Ground {
    pub(super) model: BlockModel,
    /// The joints, in the order of all forces.
    pub interfaces: Vec<Interface>,
    pub(super) equilibrium: Equilibrium,
    pub(super) stands: Carried,
    pub(super) reduced: Option<Reduced>,
    /// Forces of elastic joints under the permanent loads, scaled.
    resting: Option<Vec<f64>>,
    /// What makes them those of joints that are elastic along their depth.
    pub(super) bedded: Option<Bedded>,
}

/// What a joint carries, as an elastic one that opens nowhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Compression of the whole joint [N/m].
    pub compression: f64,
    /// Shear [N/m], positive when the force on the second block acts along `normal.left()`.
    pub shear: f64,
    /// Where the compression acts, from the middle of the joint along `normal.left()` [m].
    pub eccentricity: f64,
}

/// The linear program of few unknowns.
#[derive(Clone)]
pub(super) struct Reduced {
    /// A state that balances the permanent loads.
    pub(super) start: Vec<f64>,
    /// States of self-stress.
    pub(super) states: Vec<Vec<f64>>,
    /// What strength asks: rows that every load has, then tangents at forces that lay outside a joint's parabola.
    pub(super) limits: Vec<Row>,
    /// How many rows every load has.
    pub(super) standing: usize,
    /// The same in terms of the unknowns.
    pub(super) rows: Rows,
}

impl Reduced {
    fn new(elastic: &mut Stiffness, stands: &Carried) -> Option<Reduced> {
        let limits = rows(elastic.equilibrium);
        let states = self_stress(elastic)?;
        let mut start = stands.solution.forces.clone();
        // What the proof leaves out of balance is taken out.
        let left = elastic.equilibrium.residual(&start, 0.0);
        for (f, d) in start.iter_mut().zip(elastic.balance(&left)?) {
            *f += d;
        }
        let mut this =
            Reduced { start, rows: Rows::new(states.len()), states, limits: Vec::new(), standing: limits.len() };
        this.extend(limits);
        Some(this)
    }

    pub(super) fn extend(&mut self, limits: Vec<Row>) {
        for row in limits {
            let a = self.states.iter().map(|state| -row.of(state));
            self.rows.push(a, row.of(&self.start) + row.constant);
            self.limits.push(row);
        }
    }

    /// The last column of the rows from this one on, for a load of this size.
    pub(super) fn lasts(&self, from: usize, effect: &Effect, size: f64) -> Vec<f64> {
        self.limits[from..].iter().map(|row| -row.of(&effect.forces) / size).collect()
    }

    /// A basis with the tangents from `first` on in the place of those that it has to the same parabolas, as Newton's method
    /// would have it; itself where that is no basis, or where one parabola has several.
    pub(super) fn sharpened(&self, start: Start, first: usize, last: &[f64]) -> Start {
        let old = |row: usize| {
            let same = |member: &Member| match *member {
                Member::Row(k) => k >= self.standing && self.limits[k].is_beside(&self.limits[row]),
                _ => false,
            };
            let mut places = (0..start.members.len()).filter(|place| same(&start.members[*place]));
            let only = places.next()?;
            places.next().is_none().then_some((only, row))
        };
        let swaps: Vec<(usize, usize)> = (first..self.limits.len()).filter_map(old).collect();
        start.with(&swaps, &self.rows, last).unwrap_or(start)
    }

    /// Drops the tangents that are not wanted; gives every row's new place.
    pub(super) fn keep(&mut self, wanted: impl Fn(usize) -> bool) -> Vec<Option<usize>> {
        let mut places: Vec<Option<usize>> = (0..self.limits.len()).map(|k| (k < self.standing).then_some(k)).collect();
        let mut next = self.standing;
        for (k, place) in places.iter_mut().enumerate().skip(self.standing).filter(|(k, _)| wanted(*k)) {
            *place = Some(next);
            self.limits.swap(k, next);
            self.rows.put(k, next);
            next += 1;
        }
        self.limits.truncate(next);
        self.rows.truncate(next);
        places
    }

    /// Joint forces at a corner `z`, whose last unknown counts `scale` times the load [scaled].
    pub(super) fn forces(&self, effect: &Effect, z: &[f64], scale: f64) -> Vec<f64> {
        let (x, factor) = z.split_at(self.states.len());
        let mut forces: Vec<f64> =
            self.start.iter().zip(&effect.forces).map(|(f0, p)| f0 + factor[0] * scale * p).collect();
        for (state, x) in self.states.iter().zip(x) {
            for (f, s) in forces.iter_mut().zip(state) {
                *f += x * s;
            }
        }
        forces
    }
}

/// What a load does to the joints. Effects of loads add up.
#[derive(Debug, Clone, PartialEq)]
pub struct Effect {
    pub(super) load: Vec<f64>,
    pub(super) forces: Vec<f64>,
    /// The same of joints that are elastic along their depth.
    pub(super) elastic: Vec<f64>,
    /// Whether the forces balance the load. Where round-off spoils them, the interior-point method answers.
    pub(super) balanced: bool,
}

impl Effect {
    /// Adds so many times another effect.
    pub fn add(&mut self, other: &Effect, times: f64) {
        let (own, others) =
            ([&mut self.load, &mut self.forces, &mut self.elastic], [&other.load, &other.forces, &other.elastic]);
        for (own, other) in own.into_iter().zip(others) {
            own.iter_mut().zip(other).for_each(|(a, b)| *a += times * b);
        }
        self.balanced &= other.balanced;
    }
}

impl Ground {
    /// Sets up the joints and the permanent loads of a model. The variable loads of `loading` take no part.
    ///
    /// # Errors
    /// Nothing that is free to move, particles, or a block whose rounding leaves nothing of an edge.
    pub fn new(model: &BlockModel, loading: &Loading, settings: &Settings) -> Result<Ground, ModelError> {
        let permanent = Loading { variable: Vec::new(), ..loading.clone() };
        let (interfaces, equilibrium) = Equilibrium::of_free(model, &permanent, settings)?;
        let stands = carried(&equilibrium);
        let mut elastic = Stiffness::alike(&equilibrium);
        let resting = elastic.as_mut().and_then(|elastic| elastic.balance(&equilibrium.permanent));
        let reduced = elastic.as_mut().filter(|_| stands.is_carried());
        let reduced = reduced.and_then(|elastic| Reduced::new(elastic, &stands));
        let bedded = reduced.as_ref().and_then(|reduced| Bedded::new(model, &equilibrium, &reduced.states));
        let resting = resting.map(|forces| bedded.as_ref().map_or(forces.clone(), |bedded| bedded.relaxed(&forces)));
        Ok(Ground { model: model.clone(), interfaces, equilibrium, stands, reduced, resting, bedded })
    }

    /// Whether the permanent loads by themselves are carried.
    pub fn stands(&self) -> bool {
        self.stands.is_carried()
    }

    /// An effect that another ground of the same blocks and joints found, whose weights differ.
    pub fn taken(&self, effect: &Effect, from: &Ground) -> Effect {
        let ratio = from.equilibrium.force / self.equilibrium.force;
        let scaled = |values: &[f64]| values.iter().map(|v| v * ratio).collect();
        Effect {
            load: scaled(&effect.load),
            forces: scaled(&effect.forces),
            elastic: scaled(&effect.elastic),
            balanced: effect.balanced,
        }
    }

    /// A load in the equations' units of force.
    pub(super) fn scaled(&self, load: &[PointForce]) -> Vec<f64> {
        let loads = self.equilibrium.of_loads(load.iter().copied());
        loads.iter().map(|p| p / self.equilibrium.force).collect()
    }

    /// What a joint carries under the permanent loads and so many times a load, if blocks were elastic, all of one modulus, and
    /// joints opened nowhere: compression varies in a straight line along each. None for joints of one point and where nothing is compressed.
    pub fn section(&self, effect: &Effect, factor: f64, joint: usize) -> Option<Section> {
        self.section_under(joint, |k| factor * effect.elastic[k])
    }

    /// The same under the permanent loads alone.
    pub fn resting_section(&self, joint: usize) -> Option<Section> {
        self.section_under(joint, |_| 0.0)
    }

    fn section_under(&self, joint: usize, more: impl Fn(usize) -> f64) -> Option<Section> {
        let (resting, of) = (self.resting.as_ref()?, self.equilibrium.joints.get(joint)?);
        let force = |k: usize| (resting[of.column + k] + more(of.column + k)) * self.equilibrium.force;
        let [a, b] = [force(0), force(1)];
        let compression = a + b;
        (of.points.len() == 2 && compression > 0.0).then(|| Section {
            compression,
            shear: force(2),
            eccentricity: 0.5 * of.length * (b - a) / compression,
        })
    }

    /// Whether loads are answered by the fast method; where not, by the interior-point method one by one.
    pub fn is_fast(&self) -> bool {
        self.reduced.is_some()
    }
}

/// Sum of sizes.
pub(super) fn sum_of_sizes(values: &[f64]) -> f64 {
    values.iter().map(|v| v.abs()).sum()
}
