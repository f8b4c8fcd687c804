//! Joints, blocks and their strength.

use super::cards::warnings;
use crate::sentences::kilo;
use findings::words::{counted, verb};

warnings! {
    /// Of joints and blocks, and of how a method takes them.
    Joints {
        ASSOCIATED_SLIDING: Sliding { joints: usize } =>
            "{} in the mechanism and friction is associated: the load is an upper bound", sliding(*joints);
        ASSOCIATED_SLIDING: NotSettled { joints: usize, associated_load [N/m]: Option<f64> } =>
            "{} in the mechanism, and the way without dilation has no end: the associated load{} is only an upper \
             bound",
            sliding(*joints), associated_load.map_or(String::new(), |load| format!(" of {} kN/m", kilo(load)));
        ASSOCIATED_SLIDING: Walls { load [N/m]: Option<f64> } => "walls of blocks: {}", match load {
            Some(load) => format!("with friction without dilation the load is {} kN/m", kilo(*load)),
            None => "no load was found with friction without dilation".to_owned(),
        };
        WITHOUT_FRICTION: WithoutFriction { carried [N/m]: f64 } =>
            "no load without dilation was found; {} kN/m are carried without friction in the joints that slide. No mechanism in which only \
             these joints slide forms below that load; one in which others slide is not excluded",
            kilo(*carried);
        JAMMED: Jammed => "without dilation blocks stand by friction on compressions that self-stress alone brings about: what they carry \
                           depends on how hard they were jammed, and no load is known. Where they were not, they slip";
        /// Joints that are held against sliding by the method alone: from which load; and at the last one how many, by how much and where.
        HELD_AGAINST_SLIDING: Held { from [N/m]: f64, at [N/m]: f64, joints: usize, most: f64, place [m]: f64 } =>
            "joints do not slide in this method, and from {} kN/m on some carry more shear than friction and cohesion hold: at {} kN/m {}",
            kilo(*from), kilo(*at), match joints {
                0 => "none does any more".to_owned(),
                _ => format!("{joints} do, by up to {most:.2} times, at x = {place:.2} m"),
            };
        /// Cohesion and tension of joints of masonry with a compressive strength.
        COHESION_PRESSED: Bond { cohesion [Pa]: f64, tension [Pa]: f64, strength [Pa]: Option<f64> } =>
            "{}", bond(*cohesion, *tension, *strength);
        /// The same, of the limit load beside the result of another method.
        COHESION_PRESSED: BondBeside { cohesion [Pa]: f64, tension [Pa]: f64, strength [Pa]: Option<f64> } =>
            "in the limit load that stands beside this result {}", bond(*cohesion, *tension, *strength);
        RING_JOINT_COPIED: RingJointCopied { cohesion [Pa]: f64 } =>
            "joints between rings have the cohesion of [joint], {:.1} kPa: describe them in [ring_joint]", cohesion / 1e3;
        ONE_PIECE: OnePiece { thickness [m]: f64 } =>
            "a ring of {thickness:.3} m is modelled in one piece: separation of brick rings is not checked";
        RINGS_SHARE: RingsShare => "rings slide on one another: joints that deform take more from them than from one ring; of 41 bridges with two to four rings \
             the equilibrium path gave half of them 0.50 to 0.67 of this load";
        /// Rings that snap to and fro.
        RINGS_SHARE: ComesAndGoes { least [N/m]: f64, most [N/m]: f64 } =>
            "beyond their largest load of {} kN/m rings snap to and fro, down to {} kN/m: a bridge that has moved before may carry no more than that, and the \
             motion that is drawn is one of many", kilo(*most), kilo(*least);
        INSET: Inset { rounding [m]: f64, thickness [m]: f64 } =>
            "contact points lie {:.1} mm inside the edges: {:.4} m of a ring of {thickness:.4} m count", 1e3 * rounding, thickness - 2.0 * rounding;
        INSET: InsetBlocks { rounding [m]: f64 } => "contact points lie up to {:.1} mm inside the edges of the blocks", 1e3 * rounding;
        TWO_POINT_JOINTS: TwoPoints => "each joint bears on two contact points, which make a closed joint three times as stiff in rotation as \
             one that bears over its whole face: loads may be too high (Bridgemill 205 kN/m, with distributed joints of the same stiffness 132)";
        STIFFNESS_TAKEN: StiffnessTaken { normal [Pa/m]: f64, shear [Pa/m]: f64 } =>
            "the file gives no stiffness for some joints: {:.3} GPa/m and in shear {:.3} GPa/m are taken, from a tenth of the modulus of the units \
             over the longest voussoir",
            normal / 1e9, shear / 1e9;
        UNLIMITED_STRENGTH: Unlimited => "compressive strength is unlimited: crushing is left out";
        UNLIMITED_STRENGTH: UnlimitedOf { materials: Vec<String> } =>
            "compressive strength of {} has no limit: crushing is left out there", materials.join(", ");
        ABOVE_STRENGTH: AboveStrength { stress [Pa]: f64, strength [Pa]: f64 } =>
            "largest stress {:.2} MPa, strength {:.2} MPa", stress / 1e6, strength / 1e6;
        /// Contact points do not crush: limit loads of joints that do, and of those that do not.
        CRUSHING_LEFT_OUT: CrushingLeftOut { crushing_limit [N/m]: Option<f64>, limit [N/m]: Option<f64> } =>
            "contact points at the edges leave crushing out of collapse; with joints that crush {}{}",
            crushing_limit.map_or("no load is found".to_owned(), |load| format!("the limit load is {} kN/m", kilo(load))),
            limit.map_or(String::new(), |load| format!(" in place of {} kN/m", kilo(load)));
        /// The same under particles: what crushing takes off the limit load, as a share.
        CRUSHING_LEFT_OUT: CrushingUnderParticles { share: Option<f64> } =>
            "contact points at the edges leave crushing out of collapse; {}",
            share.map_or("how much it takes off could not be found".to_owned(), |share| {
                format!("it takes {:.1} % off the limit load of the same rings under fill as weight", 100.0 * share)
            });
    }
}

/// "1 joint slides", "3 joints slide".
fn sliding(joints: usize) -> String {
    format!("{} {}", counted(joints, "joint"), verb(joints, "slides", "slide"))
}

fn bond(cohesion: f64, tension: f64, strength: Option<f64>) -> String {
    let cohesive = (cohesion > 0.0).then(|| match strength {
        Some(strength) => format!(
            "cohesion of {:.1} kPa acts where joints are compressed, as a friction coefficient that is {:.4} larger",
            cohesion / 1e3,
            cohesion / strength
        ),
        None => format!("cohesion of {:.1} kPa is left out, because joints turn about an edge", cohesion / 1e3),
    });
    let tensile =
        (tension > 0.0).then(|| format!("a tensile strength of {:.1} kPa acts as if it never broke", tension / 1e3));
    cohesive.into_iter().chain(tensile).collect::<Vec<_>>().join("; ")
}
