//! A rough strip footing pushed into weightless ground: the work on which programs for yielding solids are compared.

use mechanics::fem::law::{Cone, DruckerPrager, Elastic, Material, MohrCoulomb, Plane, Solid, VonMises};
use mechanics::fem::{
    Element, FactorError, Kinematics, Mesh, Model, ModelError, Outcome, Quad, Section, Settings, State, Support,
    Target, Workspace, advance, reactions,
};
use mechanics::ids::{Id, NodeId};
use mechanics::plane::vec2;
use mechanics::watch::Watch;

/// Half of the ground, by symmetry: width and depth [m].
const GROUND: (f64, f64) = (20.0, 10.0);

/// Half width of the footing, and how far it is pushed down [m].
const HALF_WIDTH: f64 = 2.0;
const PUSHED: f64 = 0.02;

/// Elastic modulus [Pa] and Poisson's ratio.
const ELASTIC: Elastic = Elastic { modulus: 170e6, ratio: 0.19 };

/// Undrained strength of the clay [Pa]; cohesion [Pa] and angle of friction [deg] of the soil.
const CLAY: f64 = 100e3;
const COHESION: f64 = 10e3;
const FRICTION_ANGLE: f64 = 30.0;

bridge::choice! {
    /// What the ground is made of.
    pub enum Ground {
        /// Linear
        Elastic = "elastic",
        /// Clay
        VonMises = "von-mises",
        /// Frictional, with associated flow
        DruckerPrager = "drucker-prager",
        /// Frictional, without dilation: an unsymmetric tangent
        NonAssociated = "non-associated",
        /// Frictional, the pyramid in place of the cone, with associated flow
        MohrCoulomb = "mohr-coulomb",
    }
}

/// A mesh with its footing.
#[derive(Debug, Clone)]
pub struct Footing {
    /// Ground, base and sides.
    pub model: Model,
    /// What is asked of it.
    pub target: Target,
    nodes: Vec<NodeId>,
}

/// Ten equal steps, each balanced to `tolerance`.
pub fn settings(tolerance: f64) -> Settings {
    Settings { tolerance, load_steps: 10, ..Settings::default() }
}

/// Bearing capacity of a weightless soil by Prandtl [Pa], which is exact.
pub fn prandtl(ground: Ground) -> Option<f64> {
    match ground {
        Ground::Elastic => None,
        Ground::VonMises => Some((2.0 + std::f64::consts::PI) * CLAY),
        Ground::DruckerPrager | Ground::NonAssociated | Ground::MohrCoulomb => {
            let tangent = FRICTION_ANGLE.to_radians().tan();
            let passive = (45.0 + 0.5 * FRICTION_ANGLE).to_radians().tan().powi(2);
            Some(COHESION * ((std::f64::consts::PI * tangent).exp() * passive - 1.0) / tangent)
        }
    }
}

fn material(ground: Ground) -> Material {
    let angle = FRICTION_ANGLE.to_radians();
    // It collapses in plane strain as the soil of Mohr and Coulomb does, flowing at right angles to it or without any change of volume.
    let cone = |dilatancy| DruckerPrager::matching(ELASTIC, Cone::PlaneStrain, COHESION, angle, dilatancy);
    match ground {
        Ground::Elastic => Material::Elastic(ELASTIC),
        Ground::VonMises => Material::VonMises(VonMises { elastic: ELASTIC, strength: CLAY }),
        Ground::DruckerPrager => Material::DruckerPrager(cone(angle)),
        Ground::NonAssociated => Material::DruckerPrager(cone(0.0)),
        Ground::MohrCoulomb => Material::MohrCoulomb(MohrCoulomb {
            elastic: ELASTIC,
            cohesion: COHESION,
            friction_angle: angle,
            dilatancy_angle: angle,
            tension_cutoff: None,
        }),
    }
}

/// A uniform mesh of `columns` by half as many rows, in plane strain: base fixed, sides smooth, the footing rough.
///
/// # Errors
/// No columns, or ground that is no material.
pub fn footing(columns: usize, ground: Ground, element: Element) -> Result<Footing, ModelError> {
    let rows = columns.div_ceil(2);
    let node = |i: usize, j: usize| NodeId::new(j * (columns + 1) + i);
    let mut mesh = Mesh::default();
    let zone = mesh.zones.push("ground".to_owned());
    let place =
        |i: usize, j: usize| vec2(GROUND.0 * i as f64 / columns as f64, GROUND.1 * (j as f64 / rows as f64 - 1.0));
    for j in 0..=rows {
        for i in 0..=columns {
            mesh.nodes.push(place(i, j));
        }
    }
    for j in 0..rows {
        for i in 0..columns {
            mesh.quads.push(Quad { nodes: [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)], zone });
        }
    }
    let under = |i: &usize| place(*i, rows).x <= HALF_WIDTH + 1e-9;
    let nodes: Vec<NodeId> = (0..=columns).filter(under).map(|i| node(i, rows)).collect();
    let base = (0..=columns).map(|i| Support { node: node(i, 0), held: [true, true] });
    let sides = (1..=rows).flat_map(|j| [0, columns].map(|i| Support { node: node(i, j), held: [true, false] }));
    let rough = nodes.iter().map(|node| Support { node: *node, held: [true, true] });
    let supports: Vec<Support> = base.chain(sides).chain(rough).collect();
    let section = Section { solid: Solid { material: material(ground), plane: Plane::Strain }, element, density: 0.0 };
    let forces = vec![0.0; 2 * mesh.nodes.len()];
    let sections = [section].into_iter().collect();
    let model = Model::new(mesh, sections, Vec::new(), &supports, Kinematics::Small)?;
    let target = Target { forces, imposed: nodes.iter().map(|node| (*node, 1, -PUSHED)).collect() };
    Ok(Footing { model, target, nodes })
}

/// How the push went.
#[derive(Debug, Clone, PartialEq)]
pub struct Pushed {
    /// Status and steps.
    pub outcome: Outcome,
    /// Reaction over the footing's half width [Pa], at the last step that was balanced.
    pub mean_pressure: f64,
    /// Points that flow.
    pub yielding: usize,
}

impl Footing {
    /// Pushes the footing down, from the mesh's pattern to the last step.
    ///
    /// # Errors
    /// A factor that does not fit into memory.
    pub fn push(&self, settings: &Settings, watch: &mut dyn Watch) -> Result<Pushed, FactorError> {
        let mut work = Workspace::new(&self.model)?;
        let mut state = State::new(&self.model);
        let outcome = advance(&self.model, &mut state, &mut work, &self.target, settings, watch);
        let reactions = reactions(&self.model, &mut work, &state);
        let force: f64 = self.nodes.iter().map(|node| reactions[2 * node.index() + 1]).sum();
        Ok(Pushed { outcome, mean_pressure: -force / HALF_WIDTH, yielding: state.yielding() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mechanics::fem::Status;
    use mechanics::watch::Unwatched;

    fn pushed(columns: usize, ground: Ground, element: Element) -> Pushed {
        footing(columns, ground, element).unwrap().push(&settings(1e-6), &mut Unwatched).unwrap()
    }

    /// Three programs agree on 392.4 kPa, printed to four digits.
    #[test]
    fn clay_carries_what_three_programs_found() {
        let pushed = pushed(142, Ground::VonMises, Element::Q4);
        assert_eq!(pushed.outcome.status, Status::Completed);
        assert!((pushed.mean_pressure / 1e3 - 392.4).abs() < 0.05, "{}", pushed.mean_pressure);
    }

    /// Frictional soil with associated flow ends above Prandtl's limit by an error of the mesh that shrinks with it.
    #[test]
    fn friction_nears_the_limit_of_prandtl_from_above() {
        let limit = prandtl(Ground::DruckerPrager).unwrap();
        assert!((limit / 10e3 - 30.1396).abs() < 1e-4, "Nc {}", limit / 10e3);
        let excess = [40, 80, 160].map(|columns| {
            let pushed = pushed(columns, Ground::DruckerPrager, Element::Q4);
            assert_eq!(pushed.outcome.status, Status::Completed, "{columns}");
            pushed.mean_pressure / limit - 1.0
        });
        assert!(excess[0] > excess[1] && excess[1] > excess[2] && excess[2] > 0.0, "{excess:?}");
        assert!(excess[2] < 0.06, "{excess:?}");
    }

    /// Flow without dilation has an unsymmetric tangent: the run ends in an answer or in a name, and what it carries is of the order of
    /// the limit and no more.
    #[test]
    fn flow_that_is_not_associated_ends() {
        let pushed = pushed(30, Ground::NonAssociated, Element::Q4);
        assert!(pushed.outcome.status != Status::Cancelled, "{:?}", pushed.outcome);
        let share = pushed.mean_pressure / prandtl(Ground::NonAssociated).unwrap();
        assert!((0.2..1.5).contains(&share), "{share}");
    }
}
