//! A bridge with a help that its file does not describe, and the same bridge from its other side: made here, by none of the code that leaves helps
//! out.

use super::asked::Question;
use bridge::defect::{Defect, DefectKind, Face};
use bridge::ring::Profile;
use bridge::{Bridge, FillPressure, Joint, LeastPressure, LoadKind, Method, PoreWater, Strip, SupportMovement, Void};
use outcome::help::Help;
use structure::discretise::bridge_length;

/// The bridge by a method.
pub(crate) fn by(bridge: &Bridge, method: Method) -> Bridge {
    let mut own = bridge.clone();
    if own.plan.method != method {
        (own.plan.load_step, own.plan.load_limit) = (None, None);
    }
    own.plan.method = method;
    if own.plan.strip == Strip::Both {
        own.plan.strip = Strip::Fill;
    }
    // Discrete elements answer to a load step, which has to be the same with help and without it.
    if method == Method::Dem {
        own.plan.load_step = Some(20e3);
        own.plan.load_limit = None;
    }
    own
}

/// The bridge with a help, or none where it has it already or cannot have it.
pub(crate) fn helped(bridge: &Bridge, help: Help, question: Question) -> Option<Bridge> {
    let mut own = bridge.clone();
    match help {
        Help::Water => {
            let lowest = own.cover.layers.first().filter(|_| own.cover.water.is_none() && own.continuum.is_none())?;
            let saturated_density = lowest.density + 150.0;
            let rise = own.spans.iter().map(|span| span.rise).fold(0.0, f64::max);
            own.cover.water = Some(PoreWater { level: 0.8 * rise + 0.2, saturated_density });
        }
        Help::Movement => {
            if own.plan.support_movement.is_some() || question == Question::Movement {
                return None;
            }
            let support = own.spans.len();
            let moved = SupportMovement {
                support,
                horizontal: 1.0,
                vertical: 0.0,
                rotation: 0.0,
                before: Some(0.01),
                increment: None,
                limit: None,
            };
            own.plan.support_movement = Some(moved);
        }
        Help::FillPressure => {
            let is_free = own.fill_pressure.is_none() && own.continuum.is_none() && own.particles.is_none();
            if !is_free || own.cover.layers.is_empty() || own.plan.strip != Strip::Fill {
                return None;
            }
            own.fill_pressure = Some(FillPressure {
                applies: true,
                friction_angle: 0.6,
                cohesion: 3e3,
                mobilisation: 0.8,
                cohesion_mobilisation: 0.2,
                least: LeastPressure::AtRest,
                half_movement: 0.02,
            });
        }
        Help::Parapets => {
            let wall = own.spandrel_wall.as_mut().filter(|wall| wall.top.is_none() && own.plan.strip != Strip::Fill)?;
            wall.top = Some(own.cover.depth + 0.9);
        }
        Help::LostStone => {
            let span = own.spans.first_mut().filter(|span| span.defects.is_empty())?;
            let depth = 0.2 * span.rings.first()?.crown_thickness;
            let shares = [0.12, 0.26];
            let kind = DefectKind::ThinRing { face: Face::Intrados, depth };
            span.defects.push(Defect { kind, from_to: shares.map(|share| share * span.span), shares });
        }
        Help::Tension => each_joint(&mut own, |joint| joint.tensile_strength += 100e3),
        Help::Cohesion => each_joint(&mut own, |joint| joint.cohesion += 300e3),
    }
    Some(own)
}

fn each_joint(bridge: &mut Bridge, change: impl Fn(&mut Joint)) {
    [&mut bridge.joint, &mut bridge.ring_joint].into_iter().for_each(change);
}

/// The bridge seen from its other side; none where what it has is not mirrored here.
pub(crate) fn mirrored(bridge: &Bridge) -> Option<Bridge> {
    let is_level = bridge.spans.iter().all(|span| span.right_springing == 0.0);
    let has_other = bridge.cover.road.is_some()
        || bridge.particles.is_some()
        || bridge.continuum.is_some()
        || bridge.plan.strip != Strip::Fill;
    if !is_level || has_other {
        return None;
    }
    let length = bridge_length(bridge);
    let mut own = bridge.clone();
    own.spans.reverse();
    own.piers.reverse();
    own.abutments.reverse();
    for span in &mut own.spans {
        if let Profile::Measured { points } = &mut span.profile {
            points.reverse();
            points.iter_mut().for_each(|[x, _]| *x = span.span - *x);
        }
        for defect in &mut span.defects {
            let [from, to] = defect.from_to;
            (defect.from_to, defect.shares) =
                ([span.span - to, span.span - from], [1.0 - defect.shares[1], 1.0 - defect.shares[0]]);
        }
    }
    own.piers.iter_mut().for_each(|pier| pier.base_offset = -pier.base_offset);
    for void in &mut own.cover.voids {
        let [left, right] = void.carried_to;
        let turned = |[from, to]: [f64; 2]| [length - to, length - from];
        *void = Void { range: turned(void.range), levels: void.levels, carried_to: [length - right, length - left] };
    }
    for load in &mut own.loads {
        load.position = length - load.position;
        load.horizontal = -load.horizontal;
        if let LoadKind::Axles { axles, .. } = &mut load.kind {
            axles.iter_mut().for_each(|(_, behind)| *behind = -*behind);
        }
    }
    if let Some(moved) = &mut own.plan.support_movement {
        moved.support = own.spans.len() - moved.support;
        (moved.horizontal, moved.rotation) = (-moved.horizontal, -moved.rotation);
    }
    Some(own)
}

/// The bridge with one axle more behind the last of its loads that has axles: an axle may help, and is left out where it does.
pub(crate) fn with_an_axle_more(bridge: &Bridge, question: Question) -> Option<Bridge> {
    if question != Question::Sweep {
        return None;
    }
    let mut own = bridge.clone();
    let last = own.loads.last_mut()?;
    let LoadKind::Axles { axles, .. } = &mut last.kind else { return None };
    let &(force, behind) = axles.last()?;
    axles.push((force, behind + 2.0));
    Some(own)
}
