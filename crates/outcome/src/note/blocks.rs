//! Blocks and joints, by the method.

use crate::sentences::{kilo, notes};
use serde::{Deserialize, Serialize};

/// What crushing takes from a load [N/m], where it takes anything: rings that slide may carry more by chance.
fn lowered(load: f64, without: f64) -> String {
    let share = 100.0 * (1.0 - load / without);
    if share > 0.05 {
        return format!(", which lowers the load by {share:.1} % from the {} kN/m without crushing", kilo(without));
    }
    format!("; without crushing {} kN/m are carried", kilo(without))
}

notes! {
    /// What a method assumes of blocks and joints.
    Blocks {
        Rigid => "Rigid blocks as built: joints have no deformability and displacements before collapse are neglected.";
        RigidAsMoved => "Rigid blocks that follow the support as a mechanism; displacements are large.";
        FrictionAssociated => "Friction is associated; no joint slides in the mechanism, so it forms without dilation too.";
        FrictionNonAssociated { associated_load [N/m]: Option<f64> } =>
            "Sliding does not dilate: blocks between stiff joints are followed from rest to their collapse{}.",
            associated_load.map_or(String::new(), |load| format!("; the associated load is {} kN/m", kilo(load)));
        NoBound => "Where joints slide without dilation the load is that of the self-stress which weight and load bring about, and no bound: other \
                    states may carry less.";
        Crushing { strength [Pa]: f64, load [N/m]: f64, without [N/m]: f64 } =>
            "Joints crush at {:.1} MPa{}.", strength / 1e6, lowered(*load, *without);
        DiscreteElements { distributed: bool } =>
            "Rigid blocks in deformable {} contact; loads follow their blocks and keep their direction; displacements are large.",
            if *distributed { "distributed" } else { "point" };
        LoadSteps => "collapse_load is the first load step that collapsed; last_stable_load is the last that came to rest.";
        Springs { in_a_joint: usize, own_strips: bool, stones: FiniteStones } =>
            "Each joint has {in_a_joint} springs from edge to edge, without tension{}, which shear elastically and do not slide; displacements \
             are large. {stones}",
            if *own_strips { " and each for a strip of its own" } else { "" };
        LoadsTried => "collapse_load is the smallest load tried without equilibrium; last_stable_load is the largest with equilibrium.";
        TensionLeftOut => "The tensile strength of the joints is left out.";
        DeformableJoints { bond: Bond } => "Rigid blocks on deformable joints{}; displacements are large.",
            match bond {
                Bond::AtPoints => " at two points, without tension",
                Bond::Distributed { tension: false } => {
                    ": the pressure grows with the overlap over the compressed part of a joint, without tension"
                }
                Bond::Distributed { tension: true } => {
                    ": the pressure grows with the overlap over the compressed part of a joint, and so does the tension up to the strength \
                     of the bond, which breaks there for good"
                }
            };
        ContactsAsBuilt => "The blocks that touch as built are those that press: a contact that only forms during the motion is left out.";
        CrushingKept => "Joints whose pressure is at the compressive strength keep it, and open again elastically.";
        /// Rigid blocks stand, deformable ones fall.
        FallOnDeformableJoints => "Rigid blocks carry their own weight. On deformable joints these do not: let go, they move until they fall.";
        LoadsOnBlocks => "The loads act on the blocks as the file says; nothing spreads them.";
        Thinned => "Rings are thinned on the same intrados; the loads of the file rest on them.";
        WeightsAlone => "The loads of the file do not act; the support moves slowly against the weights alone.";
        FirstFall => "Collapse is the first movement at which a small increment has no equilibrium near by; blocks that jump there may come to \
                      rest again farther on.";
    }
}

/// How deformable joints bear.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Bond {
    /// At their two contact points.
    AtPoints,
    /// Over their compressed part.
    Distributed {
        /// Whether they carry tension.
        tension: bool,
    },
}

notes! {
    /// What stones and joints of finite elements deform.
    FiniteStones {
        /// Both do: modulus of stones, stiffness of joints along the normal and the tangent.
        Deform { modulus [Pa]: f64, joints [Pa/m]: [f64; 2] } =>
            "Stones deform with {:.1} GPa; joints take the rest of the contacts' stiffness: {:.3} and {:.3} GPa/m.",
            modulus / 1e9, joints[0] / 1e9, joints[1] / 1e9;
        /// Joints alone do, beside stones that are so many times as stiff.
        Stiff { joints [Pa/m]: [f64; 2], times: f64 } =>
            "Joints of {:.3} and {:.3} GPa/m do the deforming; stones are {times} times as stiff.", joints[0] / 1e9, joints[1] / 1e9;
    }
}
