//! Defects of rings in words and as lines of the drawing.

use super::geometry::point;
use bridge::defect::{Defect, DefectKind, Face};
use bridge::{Bridge, Span};
use outcome::picture::DefectMark;
use structure::discretise::defect_line;

/// Every defect with the number of its span.
fn every(bridge: &Bridge) -> impl Iterator<Item = (usize, &Span, &Defect)> {
    bridge.spans.iter().enumerate().flat_map(|(number, span)| span.defects.iter().map(move |one| (number, span, one)))
}

/// What blocks feel of each defect, for the assumptions of a result.
pub fn told(bridge: &Bridge) -> Vec<String> {
    every(bridge)
        .map(|(number, span, one)| format!("Defect, {}: {}.", place(bridge, number, one), felt(span, one)))
        .collect()
}

/// What a finite element model of stones, joints and fill feels of them.
pub fn told_of_elements(bridge: &Bridge) -> Vec<String> {
    let words = |(number, span, one): (usize, &Span, &Defect)| {
        let place = place(bridge, number, one);
        match one.kind {
            DefectKind::ThinRing { .. } => format!("Defect, {place}: {}.", felt(span, one)),
            _ => format!("Defect, {place}: {} is left out of the finite element model.", what(one)),
        }
    };
    every(bridge).map(words).collect()
}

/// The lines that drawings mark.
pub fn marks(bridge: &Bridge) -> Vec<DefectMark> {
    let mark = |(number, _, one): (usize, &Span, &Defect)| DefectMark {
        words: format!("{}, {}", what(one), place(bridge, number, one)),
        line: defect_line(bridge, number, one).into_iter().map(point).collect(),
    };
    every(bridge).map(mark).collect()
}

fn place(bridge: &Bridge, span: usize, one: &Defect) -> String {
    let [from, to] = one.from_to;
    if let DefectKind::OpenJoint { .. } = one.kind {
        let of = if bridge.spans.len() > 1 { format!("span {}, ", span + 1) } else { String::new() };
        return format!("{of}at {from:.2} m");
    }
    let of = if bridge.spans.len() > 1 { format!("span {}, ", span + 1) } else { String::new() };
    format!("{of}{from:.2} to {to:.2} m")
}

fn side(face: Face) -> &'static str {
    face.word()
}

/// What it is.
fn what(one: &Defect) -> String {
    match one.kind {
        DefectKind::LostMortar { face, depth } => {
            format!("mortar lost to {:.0} mm from the {}", 1e3 * depth, side(face))
        }
        DefectKind::ThinRing { face, depth } => format!("{:.0} mm of stone lost on the {}", 1e3 * depth, side(face)),
        DefectKind::RingSeparation { ring, .. } => format!("rings {} and {} separated", ring + 1, ring + 2),
        DefectKind::WeakMasonry { ring: Some(ring), .. } => format!("weak masonry in ring {}", ring + 1),
        DefectKind::WeakMasonry { ring: None, .. } => "weak masonry".into(),
        DefectKind::MissingStones => "stones of the lowest ring missing".into(),
        DefectKind::OpenJoint { face, depth } => format!("joint open to {:.0} mm from the {}", 1e3 * depth, side(face)),
        DefectKind::DroppedStones { depth } => format!("stones dropped by {:.0} mm", 1e3 * depth),
    }
}

/// What it is, and what it means for blocks.
fn felt(span: &Span, one: &Defect) -> String {
    let degrees = |angle: f64| format!("{:.1} degrees", angle.to_degrees());
    let means = match one.kind {
        DefectKind::LostMortar { .. } => "joints touch from there on".into(),
        DefectKind::ThinRing { .. } => {
            "the ring is that much thinner there, and lighter; over the length of a voussoir beside the stretch it \
                                        comes back to its thickness"
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
                format!(
                    "a compressive strength of at most {:.2} MPa, and cohesion and tension in proportion",
                    strength / 1e6
                )
            });
            let friction = friction_angle.map(|angle| format!("friction of at most {}", degrees(angle)));
            format!(
                "joints at its stones have {}",
                [strength, friction].into_iter().flatten().collect::<Vec<_>>().join(" and ")
            )
        }
        DefectKind::OpenJoint { .. } => {
            "no thrust crosses what is open, also where the load would close it again".into()
        }
        DefectKind::DroppedStones { .. } => {
            "joints beside them bear on what overlaps; the stones weigh what they did, and are drawn where they were"
                .into()
        }
        DefectKind::MissingStones => {
            let count = span.rings[0].voussoirs as f64;
            let stones = ((one.shares[1] - one.shares[0]) * count).round().max(1.0);
            format!("about {stones:.0} of its stones are left out, and the ring above bears alone")
        }
    };
    format!("{}; {means}", what(one))
}
