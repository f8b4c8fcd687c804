//! Flow that dilates less than by the friction angle, by iteration: an estimate, and no bound.
//!
//! Where soil flows, its strength is that of the stress that acts there; how it flows is another matter. So each corner is given a soil that
//! dilates as it should, by the angle psi, and that is as strong as the true one under the mean stress found before:
//! `R <= k - m P` with `m = sin(psi)` through the true `R` at that `P` (the idea of Gilbert, Casapulla and Ahmed 2006 for joints,
//! and of Krabbenhoft et al. 2012 for soil). The program is that of the lower bound. Once the mean stress no longer changes, the
//! stresses are in equilibrium within the true strength, and what they flow by is psi. There may be several such states, or none that is found.

use super::lower::{Ends, Stresses, check, push, within};
use super::mesh::Mesh;
use super::model::{Contact, Soil};
use super::setting::{Question, Setting};
use super::strengths::Strengths;
use crate::watch::CancelToken;

/// What the iteration came to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flow {
    /// Load factor of the last program.
    pub factor: f64,
    /// By how much the factor changed in the last iteration, relative to it.
    pub change: f64,
    /// Largest force beyond the true strength, relative to all loads.
    pub excess: f64,
    /// Programs that were solved.
    pub rounds: u32,
    /// Whether the factor settled.
    pub settled: bool,
}

/// Change of the factor from one program to the next below which it has settled, when it stays there twice.
const SETTLED: f64 = 4e-3;
/// Most programs.
const ROUNDS: u32 = 30;
/// Share of the mean stress just found that goes into the next strength. At Bridgemill 0.5, 0.7 and 0.85 come to 317, 317 and 315 kN/m after 21,
/// 17 and 21 programs.
const TAKEN: f64 = 0.7;
/// Least cohesion of a corner, as a share of the unit of stress: a fluid could be torn.
const LEAST: f64 = 1e-7;

/// Flow that dilates by an angle [rad], found by iteration on a mesh that is given; none where a program was not solved.
pub fn flow_on(dilatancy: f64, setting: &Setting<'_>, mesh: &Mesh, token: &CancelToken) -> Option<Flow> {
    let whole = Strengths::of(setting, mesh);
    let mut field = within(setting, mesh, &whole.reduced(dilatancy), Question::Factor, token).ok()?;
    let mut means = Means::of(setting, mesh, &field);
    let mut found = Flow { factor: field.factor, change: f64::INFINITY, excess: 0.0, rounds: 1, settled: false };
    let mut calm = 0;
    while found.rounds < ROUNDS && calm < 2 {
        field = within(setting, mesh, &means.strengths(setting, &whole, dilatancy), Question::Factor, token).ok()?;
        found.change = (field.factor / found.factor - 1.0).abs();
        (found.factor, found.rounds) = (field.factor, found.rounds + 1);
        calm = if found.change < SETTLED { calm + 1 } else { 0 };
        means.approach(&Means::of(setting, mesh, &field));
    }
    found.excess = check(setting, mesh, &whole, &field, [1.0, field.factor]).1;
    found.settled = calm >= 2;
    Some(found)
}

/// Effective mean stresses that strengths are taken from [Pa]: the sum of both principal ones at corners, tension positive; the pressure on
/// contacts.
struct Means {
    sums: Vec<[f64; 3]>,
    pressures: Vec<[f64; 2]>,
}

impl Means {
    fn of(setting: &Setting<'_>, mesh: &Mesh, field: &Stresses) -> Means {
        let sums = (field.stresses.iter().enumerate()).map(|(t, stresses)| {
            let corners = mesh.corners(t);
            [0, 1, 2].map(|k| stresses[k][0] + stresses[k][1] + 2.0 * setting.pore(corners[k]))
        });
        let pressures = (0..mesh.edges.len()).map(|e| {
            let (at, t) = (Ends::of(mesh, e), mesh.edges[e].triangle);
            let corners = at.corners(mesh, t);
            [0, 1].map(|k| {
                let pull = push(field.stresses[t][corners[k]], at.normal).dot(at.normal);
                -pull - setting.pore(at.points[k])
            })
        });
        Means { sums: sums.collect(), pressures: pressures.collect() }
    }

    fn approach(&mut self, other: &Means) {
        let towards = |own: &mut f64, other: &f64| *own += TAKEN * (other - *own);
        self.sums.as_flattened_mut().iter_mut().zip(other.sums.as_flattened()).for_each(|(a, b)| towards(a, b));
        self.pressures
            .as_flattened_mut()
            .iter_mut()
            .zip(other.pressures.as_flattened())
            .for_each(|(a, b)| towards(a, b));
    }

    /// Soils and contacts that dilate by an angle and are as strong as the true ones under these stresses.
    fn strengths(&self, setting: &Setting<'_>, whole: &Strengths, dilatancy: f64) -> Strengths {
        let least = LEAST * setting.force;
        let soils = whole.soils.iter().zip(&self.sums);
        let contacts = whole.contacts.iter().zip(&self.pressures);
        Strengths {
            sideways: whole.sideways.clone(),
            soils: soils.map(|(soils, sums)| [0, 1, 2].map(|k| soil(&soils[k], sums[k], dilatancy, least))).collect(),
            contacts: contacts
                .map(|(contacts, pressures)| {
                    contacts.map(|both| [0, 1].map(|k| contact(&both[k], pressures[k], dilatancy)))
                })
                .collect(),
        }
    }
}

/// A soil that dilates by an angle [rad] and is as strong as another under a sum of principal stresses [Pa].
fn soil(whole: &Soil, sum: f64, dilatancy: f64, least: f64) -> Soil {
    let psi = dilatancy.min(whole.friction_angle);
    let (sin, cos) = whole.friction_angle.sin_cos();
    let radius = (2.0 * whole.cohesion * cos - sin * sum).max(0.0);
    let cohesion = (radius + psi.sin() * sum) / (2.0 * psi.cos());
    let tip = if sin > 0.0 { whole.cohesion * cos / sin } else { f64::INFINITY };
    Soil { cohesion: cohesion.max(least), friction_angle: psi, tension: whole.tension.min(tip), ..*whole }
}

/// The same of a contact under a pressure [Pa].
fn contact(whole: &Contact, pressure: f64, dilatancy: f64) -> Contact {
    let friction = whole.friction.min(dilatancy.tan());
    let shear = (whole.cohesion + whole.friction * pressure).max(0.0);
    let tip = if whole.friction > 0.0 { whole.cohesion / whole.friction } else { f64::INFINITY };
    Contact { friction, cohesion: (shear - friction * pressure).max(0.0), tension: whole.tension.min(tip) }
}
