//! Defects of rings.

use crate::sentences::notes;
use bridge::defect::{Defect, DefectKind};

notes! {
    /// What an analysis makes of a defect. Spans count from 0, and are named where there are several.
    DefectNote {
        /// What blocks feel of it, on a ring of so many stones.
        Felt { span: Option<usize>, defect: Defect, stones: usize } =>
            "Defect, {}: {}; {}.", place_of_defect(*span, defect), words_of_defect(defect), means(defect, *stones);
        LeftOut { span: Option<usize>, defect: Defect } =>
            "Defect, {}: {} is left out of the finite element model.", place_of_defect(*span, defect), words_of_defect(defect);
    }
}

/// Where a defect is: "span 2, 0.10 to 0.90 m".
pub fn place_of_defect(span: Option<usize>, one: &Defect) -> String {
    let [from, to] = one.from_to;
    let of = span.map_or(String::new(), |span| format!("span {}, ", span + 1));
    match one.kind {
        DefectKind::OpenJoint { .. } => format!("{of}at {from:.2} m"),
        _ => format!("{of}{from:.2} to {to:.2} m"),
    }
}

/// What a defect is: "weak masonry in ring 2".
pub fn words_of_defect(one: &Defect) -> String {
    match one.kind {
        DefectKind::LostMortar { face, depth } => format!("mortar lost to {:.0} mm from the {face}", 1e3 * depth),
        DefectKind::ThinRing { face, depth } => format!("{:.0} mm of stone lost on the {face}", 1e3 * depth),
        DefectKind::RingSeparation { ring, .. } => format!("rings {} and {} separated", ring + 1, ring + 2),
        DefectKind::WeakMasonry { ring: Some(ring), .. } => format!("weak masonry in ring {}", ring + 1),
        DefectKind::WeakMasonry { ring: None, .. } => "weak masonry".into(),
        DefectKind::MissingStones => "stones of the lowest ring missing".into(),
        DefectKind::OpenJoint { face, depth } => format!("joint open to {:.0} mm from the {face}", 1e3 * depth),
        DefectKind::DroppedStones { depth } => format!("stones dropped by {:.0} mm", 1e3 * depth),
    }
}

/// What it means for blocks.
fn means(one: &Defect, stones: usize) -> String {
    let degrees = |angle: f64| format!("{:.1} degrees", angle.to_degrees());
    match one.kind {
        DefectKind::LostMortar { .. } => "joints touch from there on".into(),
        DefectKind::ThinRing { .. } => {
            "the ring is that much thinner there, and lighter; over the length of a voussoir beside the stretch it comes back to its thickness"
                .into()
        }
        DefectKind::RingSeparation { friction_angle: Some(angle), .. } => {
            format!("between them friction of at most {} is left, without cohesion and tension", degrees(angle))
        }
        DefectKind::RingSeparation { friction_angle: None, .. } => {
            "between them the friction of their joint is left, without cohesion and tension".into()
        }
        DefectKind::WeakMasonry { compressive_strength, friction_angle, .. } => {
            let strength = compressive_strength.map(|strength| {
                format!("a compressive strength of at most {:.2} MPa, and cohesion and tension in proportion", strength / 1e6)
            });
            let friction = friction_angle.map(|angle| format!("friction of at most {}", degrees(angle)));
            let both: Vec<String> = [strength, friction].into_iter().flatten().collect();
            format!("joints at its stones have {}", both.join(" and "))
        }
        DefectKind::OpenJoint { .. } => "no thrust crosses what is open, also where the load would close it again".into(),
        DefectKind::DroppedStones { .. } => {
            "joints beside them bear on what overlaps; the stones weigh what they did, and are drawn where they were".into()
        }
        DefectKind::MissingStones => {
            let missing = ((one.shares[1] - one.shares[0]) * stones as f64).round().max(1.0);
            format!("about {missing:.0} of its stones are left out, and the ring above bears alone")
        }
    }
}
