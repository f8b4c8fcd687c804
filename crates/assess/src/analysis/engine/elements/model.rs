//! What stones and joints are made of: together as stiff as the contacts of discrete elements.

use crate::analysis::AnalysisError;
use bridge::Bridge;
use mechanics::blocks::Stiffness;
use mechanics::fem::joint::{JointLaw, LiftOff, Mortar, Shear};
use mechanics::fem::law::{Elastic, Material, Plane, Solid};
use mechanics::fem::{Element, Kinematics, Model, Section};
use outcome::note::FiniteStones;
use structure::discretise::Discretised;
use structure::discretise::laws;
use structure::discretise::ring_mesh::RingMesh;

/// Stiffness of stones over that of the joints, where the file gives the stones no share in the deformation: what they add to it, one
/// percent, is less than any joint's stiffness is known to.
const RIGID: f64 = 100.0;

/// The model of a ring: plane stress, as contact stiffness over a modulus is; large displacements, as in discrete elements. Joints and stones are
/// from the file's contact law; a stiffness of joint and blocks together leaves the joint what the stones do not take. And what of them deforms.
pub(super) fn model(bridge: &Bridge, d: &Discretised, ring: &RingMesh) -> Result<(Model, FiniteStones), AnalysisError> {
    let law = laws::law(bridge, &bridge.joint);
    let length = spacing(d);
    let ratio = bridge.masonry.poisson_ratio.unwrap_or(0.0);
    let own = |whole: Stiffness, modulus: Option<f64>| match (whole, modulus) {
        (Stiffness::Series { joint, .. }, _) => Some(joint).filter(|joint| joint.is_finite()),
        (Stiffness::Given(k), Some(modulus)) if length / modulus < 1.0 / k => Some(1.0 / (1.0 / k - length / modulus)),
        (Stiffness::Given(_), _) => None,
    };
    let modulus = bridge.masonry.elastic_modulus;
    let shear = modulus.map(|modulus| modulus / (2.0 * (1.0 + ratio)));
    let split = (modulus, own(law.normal, modulus), own(law.shear, shear));
    let (stone, normal, tangential, deform) = match split {
        (Some(modulus), Some(normal), Some(tangential)) => {
            let deform = FiniteStones::Deform { modulus, joints: [normal, tangential] };
            (Elastic { modulus, ratio }, normal, tangential, deform)
        }
        _ => {
            let (normal, tangential) = (law.normal.at(length), law.shear.at(length));
            let deform = FiniteStones::Stiff { joints: [normal, tangential], times: RIGID };
            (Elastic { modulus: RIGID * length * normal.max(tangential), ratio }, normal, tangential, deform)
        }
    };
    let joint = Mortar {
        normal,
        tangential,
        lift_off: LiftOff::Stress(0.0),
        compressive_strength: None,
        // The comparison with rigid blocks asks for joints that cannot slide; the assumptions of the result say so.
        shear: Shear::Panel { strength: f64::MAX, when_open: true },
    };
    let solid = Solid { material: Material::Elastic(stone), plane: Plane::Stress };
    let section = Section { solid, element: Element::QM6, density: bridge.masonry.density };
    let sections = (0..ring.mesh.zones.len()).map(|_| section).collect();
    let model =
        Model::new(ring.mesh.clone(), sections, vec![JointLaw::Mortar(joint)], &ring.supports, Kinematics::Large);
    Ok((model.map_err(AnalysisError::Elements)?, deform))
}

/// Distance between neighbouring voussoirs' centres, in the mean [m].
fn spacing(d: &Discretised) -> f64 {
    let free: Vec<_> =
        d.model.blocks.iter().filter(|block| !block.held.is_fixed()).map(|b| b.outline.centroid()).collect();
    let way: f64 = free.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
    match free.len() {
        0 | 1 => d.model.blocks.iter().map(|block| block.outline.area().sqrt()).fold(f64::INFINITY, f64::min),
        count => way / (count - 1) as f64,
    }
}
