//! Collapse by finite elements: the ring of elastic stones on joints that open and slide, loaded until it has no balance left.
//!
//! The third road beside discrete elements and limit analysis, over the same blocks, loads and joints (`docs/theory/finite-elements.md`).

mod draw;
mod model;
mod slides;

use crate::analysis::engine::can::{Cannot, Feature};
use crate::analysis::engine::joints::require_stiffness;
use crate::analysis::engine::steps::{bound, program};
use crate::analysis::engine::{Engine, rigid};
use crate::analysis::{AnalysisError, notes, template};
use bridge::{Bridge, JointContact, Method};
use mechanics::blocks::PointForce;
use mechanics::dem::Program;
use mechanics::fem::{self, Model, Outcome, Settings, State, Target, Workspace, advance};
use mechanics::ids::Id;
use mechanics::limit;
use mechanics::plane::vec2;
use mechanics::watch::{Progress, Watch, Wish};
use outcome::collapse::By;
use outcome::collapse::{Collapse, FiniteReport, Status};
use outcome::picture::{Motion, Snapshot, Step};
use outcome::warning::Warning;
use structure::discretise::ring_mesh::{RingMesh, ring_mesh};
use structure::discretise::{Discretised, discretise};

/// Out-of-balance force over acting force. Joints a thousand times stiffer than mortar leave a tenth of it as rounding.
const TOLERANCE: f64 = 1e-6;

/// How often a load step is halved before the load counts as not carried: to a thousandth of the step.
const CUTS: u32 = 10;

/// A ring whose load moves so many times as far, for a little more of it, as it did at the start is about to become a mechanism: three
/// hinges make a ring several times as soft, the fourth makes it a mechanism.
const SOFT: f64 = 10.0;

/// Finite elements of one ring.
pub(crate) struct Elements;

impl Engine for Elements {
    fn method(&self) -> Method {
        Method::Fe
    }

    fn joints(&self, bridge: &Bridge) -> Result<(), AnalysisError> {
        require_stiffness(bridge)
    }

    fn ready(&self, bridge: &Bridge) -> Result<(), AnalysisError> {
        self.joints(bridge)?;
        let d = rigid::loaded(rigid::prepared(bridge)?)?;
        mesh(bridge, &d, false).map(|_| ())
    }

    fn load(&self, bridge: &Bridge, _: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
        until_it_fails(bridge, watch)
    }
}

/// The mesh of the bridge's one ring.
fn mesh(bridge: &Bridge, d: &Discretised, spread: bool) -> Result<RingMesh, AnalysisError> {
    let of_ring = ring_mesh(d, bridge.service.mesh.ring_nodes, spread);
    of_ring.ok_or_else(|| Cannot::of(Method::Fe, Feature::OtherBodies).into())
}

/// Raises the loads of the file in steps until the ring finds no balance.
fn until_it_fails(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    require_stiffness(bridge)?;
    let mut d = rigid::loaded(discretise(bridge)?)?;
    d.loading.movements.clear();
    let spread = bridge.plan.contact == Some(JointContact::Distributed);
    let ring = mesh(bridge, &d, spread)?;
    // The same joints, anywhere in the full ring: the outermost springs stand at its edges.
    let rigid = limit::Settings {
        crushing: false,
        contact_points: limit::ContactPoints::FullRing,
        ..rigid::single(bridge, &d)
    };
    let rigid = rigid::watched(&d, &rigid, watch)?;
    if rigid.status == limit::Status::Cancelled {
        return Ok(rigid::cancelled(bridge, &d, By::Fe(FiniteReport::default())));
    }
    let mut chosen = Vec::new();
    let (program, load_step) = program(&bridge.plan, &d, bound(&rigid, &d), &mut chosen)?;
    let (model, deform) = model::model(bridge, &d, &ring)?;
    let settings = settings(program.resolution.map(|resolution| program.increment / resolution));
    let mut run = Run::new(&d, &ring, &model)?;
    let status = run.load(&program, rigid.status != limit::Status::NoEquilibrium, &settings, watch);
    let sliding = slides::sliding(&d.model, &run.shown);
    let mut c = run.report(bridge, status);
    c.load_step = Some(load_step);
    c.limit_load = rigid.factor.map(|factor| d.load(factor));
    c.warnings.extend(chosen.into_iter().map(Warning::from));
    notes::finite(bridge, &d, deform, sliding, &mut c);
    Ok(c)
}

/// Halvings of a load step down to the resolution of the plan, which is a share of the step.
fn settings(steps_in_step: Option<f64>) -> Settings {
    let cuts = steps_in_step.map_or(CUTS, |count| count.max(1.0).log2().ceil().min(40.0) as u32);
    Settings { tolerance: TOLERANCE, load_steps: 1, cut_limit: cuts, ..Settings::default() }
}

/// A ring under growing load.
struct Run<'a> {
    d: &'a Discretised,
    ring: &'a RingMesh,
    model: &'a Model,
    state: State,
    work: Workspace,
    /// Nodal forces of weight and permanent loads, and of the variable ones [N/m].
    rest: Vec<f64>,
    drive: Vec<f64>,
    path: Vec<Step>,
    shown: Vec<Snapshot>,
    /// Load factor that is carried, and the smallest one that is not.
    carried: Option<f64>,
    failed: Option<f64>,
    /// How far the load moves for a little more of it [J/m], at rest and at the end.
    flexibility: [Option<f64>; 2],
    /// Displacements per load factor at the end.
    onset: Option<Vec<Motion>>,
    iterations: u64,
}

impl<'a> Run<'a> {
    fn new(d: &'a Discretised, ring: &'a RingMesh, model: &'a Model) -> Result<Run<'a>, AnalysisError> {
        let mut rest = model.weight(d.model.gravity);
        spread(ring, &d.loading.permanent, &mut rest);
        let mut drive = vec![0.0; rest.len()];
        spread(ring, &d.loading.variable, &mut drive);
        Ok(Run {
            d,
            ring,
            model,
            state: State::new(model),
            work: Workspace::new(model).map_err(AnalysisError::Equations)?,
            rest,
            drive,
            path: Vec::new(),
            shown: Vec::new(),
            carried: None,
            failed: None,
            flexibility: [None; 2],
            onset: None,
            iterations: 0,
        })
    }

    /// Weight first, then the loads in steps, each cut back where it fails.
    fn load(&mut self, program: &Program, stands: bool, settings: &Settings, watch: &mut dyn Watch) -> Status {
        let slowly = Settings { load_steps: Settings::default().load_steps, ..*settings };
        let outcome = self.step(0.0, &slowly, watch);
        match outcome.status {
            fem::Status::Completed => self.keep(0.0, &outcome),
            fem::Status::Cancelled => return Status::Cancelled,
            // Only what rigid blocks do not carry either is told as a fall; all else is Newton's method that did not get there.
            _ if !stands => return Status::UnstableUnderSelfWeight,
            _ => return Status::NotConverged,
        }
        self.flexibility[0] = self.onset().map(|(soft, _)| soft);
        let mut reached = 0.0;
        while reached < program.limit {
            let next = (reached + program.increment).min(program.limit);
            let stage = format!("load {:.1} kN/m", self.d.load(next) / 1e3);
            let fraction = (program.limit > 0.0).then_some(reached / program.limit);
            if watch.look(&Progress { stage, fraction, steps: self.iterations }) == Wish::Stop {
                return Status::Cancelled;
            }
            let outcome = self.step(next, settings, watch);
            let now = reached + outcome.reached * (next - reached);
            if outcome.reached > 0.0 {
                self.keep(now, &outcome);
            }
            match outcome.status {
                fem::Status::Completed => reached = now,
                fem::Status::Cancelled => return Status::Cancelled,
                ended => {
                    let tried = outcome.steps.last().map_or(1.0, |step| step.reached);
                    self.failed = Some(reached + tried * (next - reached));
                    return self.end(ended);
                }
            }
        }
        Status::StableToLastLoad
    }

    fn step(&mut self, factor: f64, settings: &Settings, watch: &mut dyn Watch) -> Outcome {
        let forces = self.rest.iter().zip(&self.drive).map(|(rest, drive)| rest + factor * drive).collect();
        let target = Target { forces, imposed: Vec::new() };
        let outcome = advance(self.model, &mut self.state, &mut self.work, &target, settings, watch);
        self.iterations += outcome.iterations;
        outcome
    }

    /// Notes the state at which a step ended in balance.
    fn keep(&mut self, factor: f64, outcome: &Outcome) {
        let (block, at) = self.d.watched;
        let watched = self.ring.stones.iter().find(|stone| stone.block == block);
        let moved = watched.map_or(vec2(0.0, 0.0), |stone| {
            stone.shares(at).iter().fold(vec2(0.0, 0.0), |sum, &(node, share)| {
                let k = 2 * node.index();
                sum + vec2(self.state.displacements[k], self.state.displacements[k + 1]) * share
            })
        });
        let last = outcome.steps.iter().rfind(|step| step.kept);
        self.path.push(Step {
            load: self.d.load(factor),
            displacement: [moved.x, moved.y],
            iterations: outcome.iterations,
            unbalanced_ratio: last.map_or(0.0, |step| step.unbalanced),
            at_rest: true,
        });
        self.shown.push(draw::show(self.d, self.ring, self.model, &self.state, factor));
        self.carried = Some(factor);
    }

    /// Whether what ended the run is a mechanism: no inverse, or next to none, at the last state in balance.
    fn end(&mut self, ended: fem::Status) -> Status {
        let found = self.onset();
        self.flexibility[1] = found.as_ref().map(|(soft, _)| *soft);
        self.onset = found.map(|(_, motions)| motions);
        let soft = match self.flexibility {
            [Some(start), Some(end)] => !(end > 0.0 && end < SOFT * start),
            _ => false,
        };
        if soft || ended == fem::Status::Singular { Status::Collapsed } else { Status::NotConverged }
    }

    /// What a little more load would do: its work on its own displacements, and how the blocks move [per load factor], the way in which it
    /// does work: past a limit point the tangent's own answer runs backwards.
    fn onset(&mut self) -> Option<(f64, Vec<Motion>)> {
        self.work.stiffness(self.model, &self.state).ok()?;
        self.work.factorise().ok()?;
        let right: Vec<f64> = self.model.free().iter().map(|&component| self.drive[component as usize]).collect();
        let moved = self.work.solve(&right, 1e-8).ok()?;
        let work: f64 = right.iter().zip(&moved).map(|(force, moved)| force * moved).sum();
        let onward = if work < 0.0 { -1.0 } else { 1.0 };
        let mut all = vec![0.0; self.drive.len()];
        self.model.free().iter().zip(&moved).for_each(|(&component, moved)| all[component as usize] = onward * moved);
        Some((work, draw::motions(self.d, self.ring, self.model, &all)))
    }

    fn report(self, bridge: &Bridge, status: Status) -> Collapse {
        let load = |factor: f64| self.d.load(factor);
        let report = FiniteReport {
            equations: self.model.equations(),
            springs_per_joint: self.ring.springs,
            iterations_total: self.iterations,
            softening: match self.flexibility {
                [Some(start), Some(end)] if start > 0.0 => Some(end / start),
                _ => None,
            },
        };
        let mut c = template::of_bridge(bridge, self.d, By::Fe(report), "finite elements");
        let mechanism = self.onset.as_deref().filter(|_| status == Status::Collapsed);
        draw::draw(self.d, &self.shown, mechanism, &mut c.picture);
        c.picture.path = self.path;
        c.status = status;
        c.last_stable_load = self.carried.map(load);
        c.collapse_load = self.failed.filter(|_| status == Status::Collapsed).map(load);
        c.tolerance = TOLERANCE;
        let last = self.shown.last();
        c.contacts = last.map_or(0, |shown| shown.contacts.len());
        c.max_compressive_stress = last.map(|shown| shown.contacts.iter().map(|c| c.stress).fold(0.0, f64::max));
        c
    }
}

/// Adds forces on stones to the forces on nodes.
fn spread(ring: &RingMesh, forces: &[PointForce], onto: &mut [f64]) {
    for force in forces {
        let Some(stone) = ring.stones.iter().find(|stone| stone.block == force.block) else { continue };
        for (node, share) in stone.shares(force.at) {
            onto[2 * node.index()] += share * force.force.x;
            onto[2 * node.index() + 1] += share * force.force.y;
        }
    }
}
