//! What both programs have in common: units, blocks with their joints, loads; and where a contact acts on its block.

use super::conic::{Affine, Conic};
use super::mesh::Mesh;
use super::model::{Bears, Contact, Continuum, Soil};
use crate::blocks::{BlockModel, Interface, Loading, ModelError, PointForce};
use crate::ids::BlockId;
use crate::limit::equilibrium::Equilibrium;
use crate::limit::settings::Settings;
use crate::plane::{Vec2, area, vec2};

/// Blocks, soil, loads and units: what bounds are asked of, the same for every mesh.
pub struct Setting<'a> {
    pub(super) model: &'a BlockModel,
    pub(super) loading: &'a Loading,
    pub(super) soil: &'a Continuum,
    pub(super) interfaces: Vec<Interface>,
    pub(super) equilibrium: Equilibrium,
    /// Unit of force [N/m]; that of stress is this over 1 m.
    pub(super) force: f64,
    /// The scaled factor is the factor divided by this.
    pub(super) factor_scale: f64,
    /// Sum of the sizes of all permanent and of all variable loads [N/m].
    pub(super) loads: [f64; 2],
}

/// Where the factor and the forces of the joints stand among the variables of a program. The equations of the blocks are the first ones.
pub(super) struct Base {
    pub factor: usize,
    /// What permanent and variable loads are multiplied by, in the units of the program.
    pub loads: [Affine; 2],
    pub forces: Vec<usize>,
}

/// What multiplies the loads of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Question {
    /// How often the variable loads are carried beside the permanent ones.
    Factor,
    /// Which share of the permanent loads is carried, up to all.
    Share,
}

impl<'a> Setting<'a> {
    /// Finds the joints of the blocks and sets up their equations.
    ///
    /// # Errors
    /// Particles, or a block whose rounding leaves nothing of an edge.
    pub fn new(
        model: &'a BlockModel,
        loading: &'a Loading,
        settings: &Settings,
        soil: &'a Continuum,
    ) -> Result<Setting<'a>, ModelError> {
        let (interfaces, equilibrium) = Equilibrium::new(model, loading, settings)?;
        let size = |of: &dyn Fn(&Soil) -> Vec2| -> f64 {
            soil.regions.iter().map(|r| area(&r.outline) * of(&r.soil).norm()).sum()
        };
        let on_sides = |of: &dyn Fn(Vec2, Vec2) -> Vec2| -> f64 {
            let each = soil.sides.iter().map(|s| match s.bears {
                Bears::Load { permanent, variable } => (s.ends[1] - s.ends[0]).norm() * of(permanent, variable).norm(),
                Bears::Body { .. } => 0.0,
            });
            each.sum()
        };
        let on_blocks = |loads: &[f64], unit: f64| loads.iter().map(|l| l.abs()).sum::<f64>() * unit;
        let unit = equilibrium.force;
        let permanent =
            on_blocks(&equilibrium.permanent, unit) + size(&|s| s.weight) + on_sides(&|permanent, _| permanent);
        let variable = on_blocks(&equilibrium.variable, unit / equilibrium.factor_scale)
            + size(&|s| s.variable_weight)
            + on_sides(&|_, variable| variable);
        let strongest = soil.regions.iter().map(|r| r.soil.cohesion).fold(0.0, f64::max);
        let force = [permanent, strongest, variable].into_iter().find(|f| *f > 0.0).unwrap_or(1.0);
        // Strengths of hundreds of units leave the solver no digits: a trapdoor in clay under a load of a thousandth of its cohesion.
        let area: f64 = soil.regions.iter().map(|region| area(&region.outline)).sum();
        let force = force.max(strongest * area.abs().sqrt());
        Ok(Setting {
            model,
            loading,
            soil,
            interfaces,
            equilibrium,
            force,
            factor_scale: if variable > 0.0 { force / variable } else { 1.0 },
            loads: [permanent, variable],
        })
    }

    /// The factor, the equations of the blocks, the forces of their joints within strength.
    pub(super) fn begin(&self, program: &mut Conic, question: Question) -> Base {
        let eq = &self.equilibrium;
        for _ in 0..eq.rows {
            program.equation(0.0);
        }
        let factor = match question {
            Question::Factor => program.free(),
            Question::Share => {
                let share = program.positive();
                program.at_least_zero(&Affine { terms: vec![(share, -1.0)], constant: 1.0 });
                share
            }
        };
        program.cost(factor, -1.0);
        let times = |share: f64| Affine { terms: vec![(factor, share)], constant: 0.0 };
        let loads = match question {
            Question::Factor => {
                let permanent = Affine { terms: Vec::new(), constant: 1.0 / self.force };
                [permanent, times(self.factor_scale / self.force)]
            }
            Question::Share => [times(1.0 / self.force), Affine::default()],
        };
        for i in 0..eq.rows {
            program.add(i, eq.permanent[i] * eq.force, &loads[0]);
            program.add(i, eq.variable[i] * eq.force / eq.factor_scale, &loads[1]);
        }
        let mut forces = Vec::with_capacity(eq.columns.len());
        for joint in &eq.joints {
            let first = forces.len();
            let (c, n, strength) = (joint.column, joint.points.len(), &joint.strength);
            let curvature = strength.curvature(n) * self.force;
            let (tension, cohesion) = (strength.tension / self.force, strength.cohesion / self.force);
            for _ in 0..n {
                forces.push(if tension == 0.0 && curvature == 0.0 { program.positive() } else { program.free() });
            }
            forces.push(program.free());
            let of = |k: usize| Affine::of(forces[first + k]);
            let mut total = Affine::default();
            (0..n).for_each(|k| of(k).add_to(&mut total, 1.0));
            if curvature > 0.0 {
                for k in 0..n {
                    let cone = program.cone();
                    let mut shifted = of(k);
                    shifted.constant += tension;
                    for (j, constant) in [curvature, -curvature].into_iter().enumerate() {
                        let member = Affine { terms: vec![(cone + j, -1.0)], constant };
                        program.zero(&Affine::sum(&[(1.0, &shifted), (1.0, &member)]));
                    }
                    let mut wide = total.clone();
                    wide.constant += 2.0 * tension;
                    program.zero(&Affine::sum(&[(2.0 * curvature, &wide), (-1.0, &Affine::of(cone + 2))]));
                }
            } else if tension > 0.0 {
                for k in 0..n {
                    program.at_least_zero(&Affine { terms: of(k).terms, constant: tension });
                }
            }
            if strength.friction.is_finite() {
                for sign in [1.0, -1.0] {
                    let mut room = Affine::sum(&[(sign, &of(n)), (strength.friction, &total)]);
                    room.constant += cohesion;
                    program.at_least_zero(&room);
                }
            }
            for k in 0..=n {
                for &(row, v) in &eq.columns[c + k] {
                    program.add(row, v, &of(k));
                }
            }
        }
        Base { factor, loads, forces }
    }

    /// The equations of a block that a force (1, 0), (0, 1) at a point takes part in, with its coefficients.
    pub(super) fn rows_of(&self, block: BlockId, at: Vec2) -> [Vec<(usize, f64)>; 2] {
        [vec2(1.0, 0.0), vec2(0.0, 1.0)].map(|force| self.equilibrium.act(PointForce { block, at, force }).collect())
    }

    /// The velocity of a point of a block, of what multiplies its equations.
    pub(super) fn velocity(&self, block: Option<BlockId>, at: Vec2, velocities: &[f64]) -> Vec2 {
        let Some(block) = block else { return Vec2::ZERO };
        let [x, y] = self.rows_of(block, at).map(|rows| rows.iter().map(|&(i, v)| v * velocities[i]).sum::<f64>());
        vec2(x, y)
    }

    /// The soil of a triangle.
    pub(super) fn soil_of(&self, mesh: &Mesh, triangle: usize) -> Soil {
        self.soil.regions[mesh.regions[triangle]].soil
    }

    /// Pore pressure at a point [Pa].
    pub(super) fn pore(&self, at: Vec2) -> f64 {
        self.soil.water.map_or(0.0, |w| w.pressure(at))
    }

    /// The body that an edge of the boundary touches.
    pub(super) fn body(&self, mesh: &Mesh, edge: usize) -> Option<(Option<BlockId>, Contact)> {
        match self.soil.sides[mesh.edges[edge].side?].bears {
            Bears::Body { block, contact } => Some((block, contact)),
            Bears::Load { .. } => None,
        }
    }

    /// Tractions on an edge of the boundary that touches nothing [Pa]: permanent and variable.
    pub(super) fn tractions(&self, mesh: &Mesh, edge: usize) -> [Vec2; 2] {
        match mesh.edges[edge].side.map(|s| self.soil.sides[s].bears) {
            Some(Bears::Load { permanent, variable }) => [permanent, variable],
            _ => [Vec2::ZERO; 2],
        }
    }
}
