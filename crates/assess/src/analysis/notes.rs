//! What a reader of a result must know: warnings with numbers, and what was assumed.

use super::by_fe::Sliding;
use bridge::{BackingBody, Bridge, ContactPoints, DispersalRule, JointContact, Plan};
use mechanics::limit;
use outcome::collapse::By;
use outcome::collapse::FlowRule;
use outcome::collapse::{Collapse, Sought, Status};
use outcome::note::{self, Bond, FiniteStones, Note};
use outcome::warning::{self, Warning};
use structure::discretise::{Discretised, Origin, pressure};

mod continuum;
pub(super) mod joints;
mod shape;

pub use continuum::continuum;

/// Discrete elements usually lie up to this share below the limit load of the same blocks.
const USUAL_GAP: f64 = 0.15;
/// Both bounds of limit analysis must agree to this.
const BOUNDS: f64 = 1e-6;

/// "1 joint slides", "3 joints slide".
pub(super) fn sliding(joints: usize) -> String {
    format!("{} {}", findings::words::counted(joints, "joint"), findings::words::verb(joints, "slides", "slide"))
}

/// Notes on a limit analysis.
pub fn limit(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    common(bridge, d, c);
    let Some(report) = c.limit() else { return };
    let (mut warnings, mut assumptions) = (Vec::new(), Vec::new());
    assumptions.push(match c.sought {
        Sought::SupportMovement(_) => note::Blocks::RigidAsMoved,
        _ => note::Blocks::Rigid,
    });
    match (report.friction, report.associated_load) {
        (FlowRule::Associated, _) if !c.sliding_joints.is_empty() => warnings.push(Warning::new(
            warning::ASSOCIATED_SLIDING,
            format!(
                "{} in the mechanism and friction is associated: the load is an upper bound",
                sliding(c.sliding_joints.len())
            ),
        )),
        (FlowRule::NonAssociated, _) if report.jammed => warnings.push(joints::jammed()),
        (FlowRule::NonAssociated, bound) if c.status == Status::NotConverged => {
            let bound = bound.map_or(String::new(), |load| format!(" of {:.2} kN/m", load / 1e3));
            warnings.push(Warning::new(
                warning::ASSOCIATED_SLIDING,
                format!(
                    "{} in the mechanism, and the iteration for friction without dilation did not \
                     converge: the associated load{bound} is only an upper bound",
                    sliding(c.sliding_joints.len())
                ),
            ));
        }
        (FlowRule::Associated, _) => assumptions.push(note::Blocks::FrictionAssociated),
        (FlowRule::NonAssociated, associated_load) => {
            assumptions.push(note::Blocks::FrictionNonAssociated { associated_load });
        }
    }
    warnings.extend(joints::cohesive(bridge));
    if let (Status::NotConverged, FlowRule::NonAssociated, Some(carried)) =
        (c.status, report.friction, report.lower_bound)
    {
        warnings.push(Warning::new(
            warning::WITHOUT_FRICTION,
            format!(
                "no load without dilation was found; {:.2} kN/m are carried without friction in the joints that slide. \
                 No mechanism in which only these joints slide forms below that load; one in which others slide is not \
                 excluded",
                carried / 1e3
            ),
        ));
    }
    if bridge.plan.contact_points == ContactPoints::Rounded && bridge.masonry.rounding > 0.0 {
        warnings.push(inset(bridge));
    }
    if let (Some(lower), Some(upper), FlowRule::Associated) = (report.lower_bound, report.upper_bound, report.friction)
        && (upper - lower).abs() > BOUNDS * upper.abs()
    {
        warnings.push(Warning::new(
            warning::BOUNDS_APART,
            format!("lower bound {:.4} kN/m, upper bound {:.4} kN/m", lower / 1e3, upper / 1e3),
        ));
    }
    c.warnings.extend(warnings);
    c.assumptions.extend(assumptions.into_iter().map(Note::from));
}

/// The range of loads with fill that presses: by weight alone, as described, and with all that could be there.
pub fn pressure_range(bridge: &Bridge, bare: &Collapse, with: &Collapse) -> Option<Warning> {
    let fill = bridge.fill_pressure?;
    let told = |load: Option<f64>| load.map_or("no load".to_owned(), |load| format!("{:.2} kN/m", load / 1e3));
    let message = match &with.by {
        By::Limit(report) => format!(
            "{} by weight alone, {} with {:.0} % of the passive pressure, {} with all of it; a verdict uses the lower end",
            told(bare.collapse_load),
            told(with.collapse_load),
            100.0 * fill.mobilisation,
            told(report.full_fill_pressure_load)
        ),
        By::Path(_) => format!(
            "{} by weight alone, {} with the pressure that the ring's own movement mobilises, {} on rigid blocks, where all of the \
             file's share acts at once",
            told(bare.last_stable_load),
            told(with.last_stable_load),
            told(with.limit_load)
        ),
        By::Dem(_) | By::Fe(_) => return None,
    };
    Some(Warning::new(warning::PRESSURE_RANGE, message))
}

/// Notes on fill that presses against movement.
pub fn pressed(bridge: &Bridge, c: &mut Collapse) {
    let Some(fill) = &bridge.fill_pressure else { return };
    let k = pressure::coefficients(fill);
    let mut told = vec![note::Fill::Presses {
        least: k.least,
        most: k.most,
        cohesion: k.cohesion,
        mobilised: fill.mobilisation,
        friction_angle: fill.friction_angle,
        cohesion_mobilised: fill.cohesion_mobilisation,
    }];
    if bridge.spans.len() > 1 {
        told.push(note::Fill::PressesBetweenSpans);
    }
    if bridge.cover.backing.is_some_and(|b| b.body == BackingBody::Weight) {
        told.push(note::Fill::BackingPresses);
    }
    c.assumptions.extend(told.into_iter().map(Note::from));
}

/// Notes on fill that presses the more the further backs move against it.
fn moved_against(bridge: &Bridge, c: &mut Collapse) {
    let (Some(fill), Some(found)) = (&bridge.fill_pressure, c.along().and_then(|path| path.fill_pressure)) else {
        return;
    };
    let k = pressure::coefficients(fill);
    let told = note::Fill::PressesWithMovement {
        least: k.least,
        most: k.most,
        cohesion: k.cohesion,
        half_movement: fill.half_movement,
        mobilised: found.mobilised,
    };
    c.assumptions.push(told.into());
}

/// What is assumed of backing that is blocks, and of the ground behind it.
fn backed(bridge: &Bridge, d: &Discretised) -> Option<Note> {
    bridge.cover.backing.filter(|b| b.body == BackingBody::Blocks)?;
    let pieces = d.origins.iter().filter(|o| matches!(o, Origin::Backing { .. })).count();
    let over_abutments = bridge.abutments.map(|a| a.top_width);
    Some(note::Fill::BackingBlocks { pieces, over_abutments, pressed: !d.loading.restraints.is_empty() }.into())
}

/// Notes on a discrete element run.
pub fn dem(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    common(bridge, d, c);
    if bridge.fill_pressure.is_some_and(|fill| fill.applies) && d.fill.is_none() {
        c.assumptions.push(note::Fill::DoesNotPress.into());
    }
    discrete_elements(&bridge.plan, c);
    if bridge.masonry.rounding > 0.0 {
        c.warnings.push(inset(bridge));
    }
    if c.status == Status::Stalled {
        let at = c.stalled_load.map_or("a step".to_owned(), |load| format!("the load step of {:.2} kN/m", load / 1e3));
        let message = format!("{at} neither came to rest nor collapsed: no collapse load was found");
        c.warnings.push(Warning::new(warning::STALLED, message));
    }
    if c.status == Status::Collapsed && bridge.dispersal.rule == DispersalRule::InverseDepth && d.road.is_none() {
        c.warnings.push(Warning::new(
            warning::PUBLISHED_STEP,
            "Rouxinol, Providência and Lemos print the last stable step as collapse load of cases like this one",
        ));
    }
    if let Some((block, step)) = c.dem().and_then(|r| r.broken_at.clone()) {
        c.warnings.push(Warning::new(warning::BROKEN, format!("the run broke off at {block}, iteration {step}")));
    }
    if let (Some(stress), Some(strength)) = (c.max_compressive_stress, bridge.masonry.compressive_strength)
        && stress > strength
    {
        let message = format!("largest stress {:.2} MPa, strength {:.2} MPa", stress / 1e6, strength / 1e6);
        c.warnings.push(Warning::new(warning::ABOVE_STRENGTH, message));
    }
    if let (Some(stable), Some(bound)) = (c.last_stable_load, c.limit_load) {
        let share = stable / bound;
        let next = c.collapse_load.unwrap_or(stable) / bound;
        let message = format!(
            "last stable load {:.2} kN/m, limit load of the same blocks {:.2} kN/m ({:.0} %)",
            stable / 1e3,
            bound / 1e3,
            100.0 * share
        );
        if share > 1.0 {
            c.warnings.push(Warning::new(warning::ABOVE_LIMIT, message));
        } else if c.collapse_load.is_some() && next < 1.0 - USUAL_GAP {
            c.warnings.push(Warning::new(warning::FAR_BELOW_LIMIT, message));
        }
    }
}

/// Notes on a run by finite elements of these stones.
pub fn finite(bridge: &Bridge, d: &Discretised, stones: FiniteStones, sliding: Option<Sliding>, c: &mut Collapse) {
    common(bridge, d, c);
    let in_a_joint = c.finite().map_or(0, |finite| finite.springs_per_joint);
    let own_strips = bridge.plan.contact == Some(JointContact::Distributed);
    c.assumptions.push(note::Blocks::Springs { in_a_joint, own_strips, stones }.into());
    c.assumptions.push(note::Blocks::LoadsTried.into());
    if bridge.joint.tensile_strength > 0.0 {
        c.assumptions.push(note::Blocks::TensionLeftOut.into());
    }
    c.warnings.extend(sliding.map(joints::would_slide));
    if let (Some(stable), Some(bound)) = (c.last_stable_load, c.limit_load)
        && stable > bound
    {
        let message = format!(
            "last stable load {:.2} kN/m, limit load of the same blocks {:.2} kN/m: the smaller is the headline",
            stable / 1e3,
            bound / 1e3
        );
        c.warnings.push(Warning::new(warning::ABOVE_LIMIT, message));
    }
    c.warnings.extend(joints::cohesive(bridge).map(|warning| {
        let message = format!("in the limit load that stands beside this result {}", warning.message);
        Warning::new(warning.code, message)
    }));
    if let (Some(stress), Some(strength)) = (c.max_compressive_stress, bridge.masonry.compressive_strength)
        && stress > strength
    {
        let message = format!("largest stress {:.2} MPa, strength {:.2} MPa", stress / 1e6, strength / 1e6);
        c.warnings.push(Warning::new(warning::ABOVE_STRENGTH, message));
    }
}

/// Notes on the equilibrium path.
pub fn path(bridge: &Bridge, d: &Discretised, distributed: bool, c: &mut Collapse) {
    common(bridge, d, c);
    moved_against(bridge, c);
    let tension = strongest(bridge) > 0.0;
    let bond = if distributed { Bond::Distributed { tension } } else { Bond::AtPoints };
    c.assumptions.push(note::Blocks::DeformableJoints { bond }.into());
    c.assumptions.push(note::Blocks::ContactsAsBuilt.into());
    if tension && !distributed {
        c.assumptions.push(note::Blocks::TensionLeftOut.into());
    }
    if bridge.masonry.compressive_strength.is_some() && distributed {
        c.assumptions.push(note::Blocks::CrushingKept.into());
    }
    if bridge.masonry.rounding > 0.0 {
        c.warnings.push(inset(bridge));
    }
}

/// Largest tensile strength of a kind of joint that the file has [Pa].
fn strongest(bridge: &Bridge) -> f64 {
    let rings = bridge.spans.iter().any(|span| span.rings.len() > 1).then_some(&bridge.ring_joint);
    let walls = bridge.spandrel_wall.as_ref().map(|wall| &wall.joint);
    let joints = [Some(&bridge.joint), rings, walls];
    joints.into_iter().flatten().map(|joint| joint.tensile_strength).fold(0.0, f64::max)
}

/// Notes on fill that is particles.
pub fn filled(bridge: &Bridge, c: &mut Collapse) {
    c.assumptions.push(note::Fill::Particles.into());
    if let Some(p) = &c.packing {
        let (solid_fraction, coordination, mean_stress) = (p.solid_fraction, p.coordination, p.mean_stress);
        let told = note::Fill::Packing { seed: p.seed, solid_fraction, coordination, mean_stress };
        c.assumptions.push(told.into());
        if let Some(message) = wedged(p.diameters[1], bridge.cover.depth) {
            c.warnings.push(Warning::new(warning::COARSE_PARTICLES, message));
        }
    }
}

/// What is to be said where the largest particle [m] is larger than the cover is deep at its shallowest [m].
fn wedged(largest: f64, depth: f64) -> Option<String> {
    let message =
        || format!("the largest particle is {largest:.3} m across, the cover over the crown {depth:.3} m deep");
    (largest > depth).then(message)
}

/// What a run of discrete elements assumes, and what two contact points a joint mean for its loads where joints have them.
pub fn discrete_elements(plan: &Plan, c: &mut Collapse) {
    let distributed = plan.contact == Some(JointContact::Distributed);
    c.assumptions.push(note::Blocks::DiscreteElements { distributed }.into());
    c.assumptions.push(note::Blocks::LoadSteps.into());
    if !distributed {
        c.warnings.push(of_two_points());
    }
}

/// What two contact points a joint mean for every load that they give.
pub fn of_two_points() -> Warning {
    Warning::new(
        warning::TWO_POINT_JOINTS,
        "each joint bears on two contact points, which make a closed joint three times as stiff in rotation as one that bears over its \
         whole face: loads may be too high (Bridgemill 205 kN/m, with distributed joints of the same stiffness 132)",
    )
}

/// Says so where discrete elements carry loads on blocks that do not stand as rigid ones.
pub fn apart(rigid: limit::Status, c: &mut Collapse) {
    if rigid == limit::Status::NoEquilibrium && c.last_stable_load.is_some() {
        c.warnings.push(Warning::new(
            warning::METHODS_APART,
            "limit analysis finds no equilibrium of the same blocks under their own weight: no load counts as carried",
        ));
        c.limit_load = Some(0.0);
    }
}

/// Says that contact points leave crushing out of collapse, and what limit analysis with crushing joints carries.
pub fn crushed(c: &mut Collapse) {
    let crushing = c
        .crushing_limit_load
        .map_or("no load is found".to_owned(), |load| format!("the limit load is {:.2} kN/m", load / 1e3));
    let rigid = c.limit_load.map_or(String::new(), |load| format!(" in place of {:.2} kN/m", load / 1e3));
    c.warnings.push(Warning::new(
        warning::CRUSHING_LEFT_OUT,
        format!("contact points at the edges leave crushing out of collapse; with joints that crush {crushing}{rigid}"),
    ));
    if let (Some(stable), Some(crushing)) = (c.last_stable_load, c.crushing_limit_load)
        && stable > crushing
    {
        let message = format!(
            "last stable load {:.2} kN/m, limit load of joints that crush at their edges {:.2} kN/m: the smaller is the headline",
            stable / 1e3,
            crushing / 1e3
        );
        c.warnings.push(Warning::new(warning::ABOVE_LIMIT, message));
    }
}

/// Says what crushing takes off rings under particles: a share of their limit load under the same fill as weight.
pub fn crushed_under_particles(bridge: &Bridge, share: Option<f64>, c: &mut Collapse) {
    if bridge.masonry.compressive_strength.is_none() {
        return;
    }
    let takes = share.map_or("how much it takes off could not be found".to_owned(), |share| {
        format!("it takes {:.1} % off the limit load of the same rings under fill as weight", 100.0 * share)
    });
    let message = format!("contact points at the edges leave crushing out of collapse; {takes}");
    c.warnings.push(Warning::new(warning::CRUSHING_LEFT_OUT, message));
}

/// Puts the non-associated load of a wall beside the associated one [N/m].
pub fn corrected(c: &mut Collapse, load: Option<f64>) {
    if let By::Limit(report) = &mut c.by {
        report.non_associated_load = load;
    }
    let message = match load {
        Some(load) => format!("walls of blocks: with friction without dilation the load is {:.2} kN/m", load / 1e3),
        None => "walls of blocks: no load was found with friction without dilation".into(),
    };
    c.warnings.push(Warning::new(warning::ASSOCIATED_SLIDING, message));
}

/// What stands on the rings of a wall's strip, and how it is loaded.
fn walled(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    let (Some(wall), Some(road)) = (&bridge.spandrel_wall, &d.road) else { return };
    let pieces = d.origins.iter().filter(|o| matches!(o, Origin::Brick { .. })).count();
    if pieces == 0 {
        return;
    }
    let told = note::Barrel::WallStrip {
        pieces,
        brick: [wall.brick_length, wall.brick_height],
        ends: [road.line[0].x, road.line[1].x],
        height: d.surface.highest() - d.extrados.crown(),
        end_walls: wall.end_walls,
    };
    c.assumptions.push(told.into());
    c.assumptions.push(match d.counted_weight > 0.0 {
        true => note::Barrel::WallLoadedByBlock.into(),
        false => note::Barrel::WallLoadedOnBricks { bricks: wall.loaded_bricks }.into(),
    });
}

fn inset(bridge: &Bridge) -> Warning {
    let thickness: f64 = bridge.spans[0].rings.iter().map(|r| r.crown_thickness).sum();
    let r = bridge.masonry.rounding;
    Warning::new(
        warning::INSET,
        format!(
            "contact points lie {:.1} mm inside the edges: {:.4} m of a ring of {:.4} m count",
            1e3 * r,
            thickness - 2.0 * r,
            thickness
        ),
    )
}

/// Notes that do not depend on the method.
fn common(bridge: &Bridge, d: &Discretised, c: &mut Collapse) {
    super::caveats::add(bridge, d, c);
    c.assumptions.extend(super::defects::told(bridge));
    let soil = c.limit().is_some_and(|l| l.continuum.is_some());
    for s in d.spreads.iter().filter(|_| !soil) {
        // A millimetre is what a survey resolves.
        if s.shift.abs() > 1e-3 && s.to_ground.abs() < 1e-9 * s.strip.force.abs() {
            c.warnings.push(Warning::new(
                warning::SHIFTED_LOAD,
                format!("the resultant of the load at {:.3} m moves by {:+.1} mm", s.strip.middle, 1e3 * s.shift),
            ));
        }
        if s.to_ground > 1e-9 * s.strip.force {
            let percent = 100.0 * s.to_ground / s.strip.force;
            c.warnings.push(Warning::new(
                warning::GROUND_LOAD,
                format!("{percent:.1} % of the load at {:.3} m reaches the ground beside the rings", s.strip.middle),
            ));
        }
    }
    if bridge.masonry.compressive_strength.is_none() {
        c.warnings
            .push(Warning::new(warning::UNLIMITED_STRENGTH, "compressive strength is unlimited: crushing is left out"));
    }
    c.warnings.extend(joints::between_rings(bridge));
    let unlimited = c.limit().and_then(|l| l.unlimited_strength_load);
    if let (Some(load), Some(without), Some(strength)) =
        (c.collapse_load, unlimited, bridge.masonry.compressive_strength)
    {
        c.assumptions.push(note::Blocks::Crushing { strength, load, without }.into());
    }
    c.assumptions.push(note::Barrel::Plane.into());
    c.warnings.extend(shape::warnings(bridge, d.road.is_none()));
    c.assumptions.extend(shape::assumptions(bridge).into_iter().map(Note::from));
    if d.road.is_some() {
        walled(bridge, d, c);
        return;
    }
    c.assumptions.extend(backed(bridge, d).filter(|_| d.fill.is_none()));
    let weighs = bridge.cover.layers.iter().any(|l| l.weighs) || bridge.cover.backing.is_some();
    if weighs && d.loading.restraints.is_empty() && !soil {
        c.warnings.push(Warning::new(
            warning::FILL_AS_WEIGHT,
            format!(
                "{} alone: its resistance is left out, and so are effects that make rings weaker than rigid blocks{}",
                match bridge.cover.backing.map(|b| b.body) {
                    Some(BackingBody::Blocks) => "fill acts by its weight",
                    _ => "fill and backing act by their weight",
                },
                crate::record::record().map_or_else(String::new, |record| format!("; {}", record.words()))
            ),
        ));
    }
    if !soil {
        c.assumptions.extend(continuum::as_weight(bridge));
    }
    if bridge.cover.road.is_some() {
        c.assumptions.push(note::Fill::Road { cover: bridge.cover.depth }.into());
    }
    let weightless = bridge.cover.layers.iter().filter(|l| !l.weighs);
    let layers: Vec<String> = weightless.map(|l| l.name.word().to_owned()).collect();
    if !layers.is_empty() {
        c.assumptions.push(note::Fill::Weightless { layers }.into());
    }
    if soil {
        return;
    }
    c.assumptions.push(note::Fill::Dispersal { rule: bridge.dispersal.rule, slope: bridge.dispersal.slope }.into());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_particle_larger_than_the_cover_is_deep_is_told() {
        assert_eq!(wedged(0.40, 0.478), None);
        let said = wedged(0.5, 0.478).unwrap();
        assert!(said.contains("0.500") && said.contains("0.478"), "{said}");
    }
}
