//! `extrados.collapse/1`.

use super::{Object, kilo, list, not_counted, object, warnings};
use crate::collapse::Collapse;
use crate::note;
use bridge::{Analysis, Method, Strip};

/// The word for a method.
pub(super) fn method(method: Method) -> &'static str {
    match method {
        Method::Dem => "dem",
        Method::Path => "path",
        Method::Limit => "limit",
        Method::Fe => "fe",
    }
}

/// The word for an analysis.
pub(super) fn analysis(analysis: Analysis) -> &'static str {
    match analysis {
        Analysis::Load => "load",
        Analysis::Thickness => "thickness",
        Analysis::SupportMovement => "support-movement",
    }
}

/// The word for a strip.
pub fn strip(strip: Strip) -> &'static str {
    match strip {
        Strip::Fill => "fill",
        Strip::Wall => "wall",
        Strip::Both => "both",
    }
}

/// The result of a collapse analysis. The headline is the load that is carried, by the method that gives least.
pub fn collapse(c: &Collapse) -> Object {
    let per_metre = |load: Option<f64>| load.map(kilo);
    let total = |load: Option<f64>| load.map(|l| kilo(l * c.width));
    // Of both strips the whole width carries the sum.
    let whole = |own: Option<f64>, sum: fn(&crate::collapse::Combination) -> Option<f64>| match &c.combination {
        Some(both) => sum(both).map(kilo),
        None => total(own),
    };
    object! {
        schema: "extrados.collapse/1",
        status: c.status,
        bridge: c.bridge,
        method: method(c.method()),
        analysis: analysis(c.analysis()),
        ..c.headline().map(|headline| object! {
            headline_kn_per_m: kilo(headline.load),
            headline_kn: kilo(headline.whole),
            headline_from: headline.from,
        }),
        last_stable_load_kn_per_m: per_metre(c.last_stable_load),
        last_stable_load_kn: whole(c.last_stable_load, |both| both.last_stable_load),
        collapse_load_kn_per_m: per_metre(c.collapse_load),
        collapse_load_kn: whole(c.collapse_load, |both| both.collapse_load),
        ..not_counted(&c.not_counted),
        stalled_load_kn_per_m?: per_metre(c.stalled_load),
        load_step_kn_per_m: per_metre(c.load_step),
        load_step_kn: total(c.load_step),
        reference_load_kn_per_m: kilo(c.reference_load),
        limit_load_kn_per_m: per_metre(c.limit_load),
        crushing_limit_load_kn_per_m?: per_metre(c.crushing_limit_load),
        width_m: c.width,
        load_factor?: c.load_factor().filter(|_| c.analysis() == Analysis::Load),
        axles?: (!c.asked.is_empty()).then(|| axles(c)),
        hinges: list(&c.hinges, |h| object! {
            x_m: h.point[0],
            y_m: h.point[1],
            edge: h.edge.word(),
            between: c.sides(h).map_or_else(Vec::new, Vec::from),
            rotation: h.rotation,
        }),
        sliding_joints: list(&c.sliding_joints, |p| object! { x_m: p[0], y_m: p[1], }),
        max_compressive_stress_mpa: c.max_compressive_stress.map(|s| s / 1e6),
        blocks: c.blocks,
        particles: c.particles,
        contacts: c.contacts,
        ..c.dem().map(|d| object! {
            path: path(c),
            iterations_total: d.iterations_total,
            time_step_s: d.time_step,
            critical_time_step_s: d.critical_time_step,
            single_mass_time_step_s: d.single_mass_time_step,
            damping: d.damping,
            contact_length: d.contact_length,
            energy_drift: d.energy_drift,
        }),
        ..c.limit().map(|l| object! {
            friction: l.friction,
            lower_bound_kn_per_m: per_metre(l.lower_bound),
            upper_bound_kn_per_m: per_metre(l.upper_bound),
            associated_load_kn_per_m: per_metre(l.associated_load),
            non_associated_load_kn_per_m?: per_metre(l.non_associated_load),
            without_fill_pressure_load_kn_per_m?: per_metre(l.without_fill_pressure_load),
            full_fill_pressure_load_kn_per_m?: per_metre(l.full_fill_pressure_load),
            non_associated_spread_kn_per_m: l.spread.map(|s| s.map(kilo)),
            unlimited_strength_load_kn_per_m: per_metre(l.unlimited_strength_load),
            equilibrium_residual: l.equilibrium_residual,
            yield_violation: l.yield_violation,
            solver_iterations: l.iterations,
            thrust_line: thrust_line(c),
            ..l.continuum.as_ref().map(|s| object! {
                bound_ratio: s.bound_ratio,
                elements: s.elements,
                mobilised_share: s.mobilised_share,
                dilatancy_angle_deg: s.dilatancy_angle.to_degrees(),
                associated_bounds_kn_per_m: s.associated.map(|b| b.map(kilo)),
                iterated_load_kn_per_m: per_metre(s.iterated),
                plane_strain_load_kn_per_m?: per_metre(s.plane_strain),
                wall_gives?: s.wall.map(|wall| if wall.tilts { "tilts" } else { "slides" }),
                wall_gives_at?: s.wall.map(|wall| wall.ends),
                range_shares: s.shares,
                range_kn_per_m: s.range.map(|r| r.map(kilo)),
                permanent_share?: s.permanent_share,
                load_left_out: s.left_out,
                flow_violation: s.flow_violation,
                meshes: list(&s.rounds, |(elements, lower, upper)| object! {
                    elements: *elements,
                    lower_bound_kn_per_m: per_metre(*lower),
                    upper_bound_kn_per_m: per_metre(*upper),
                }),
            }),
        }),
        ..c.along().map(|p| object! {
            peak_load_kn_per_m: per_metre(c.last_stable_load),
            ended: p.ended,
            contact: p.contact,
            path: path(c),
            permissible: list(&p.permissible, |limit| object! {
                criterion: limit.criterion,
                load_kn_per_m: kilo(limit.load),
            }),
            over_stiffness?: c.picture.over_stiffness.as_ref().map(|over| list(&over.points, |[times, load]| object! {
                times: *times,
                last_stable_load_kn_per_m: kilo(*load),
            })),
            snaps: p.snaps,
            equilibrium_residual: p.equilibrium_residual,
            yield_violation: p.yield_violation,
            iterations_total: p.iterations_total,
            without_fill_pressure_load_kn_per_m?: p.fill_pressure.map(|fill| per_metre(fill.without)),
            fill_pressure_mobilised?: p.fill_pressure.map(|fill| fill.mobilised),
            thrust_line: thrust_line(c),
        }),
        ..c.finite().map(|f| object! {
            path: path(c),
            degrees_of_freedom: f.equations,
            springs_per_joint: f.springs_per_joint,
            iterations_total: f.iterations_total,
            softening: f.softening,
            thrust_line: thrust_line(c),
        }),
        ..c.thickness().map(|t| object! {
            minimum_thickness_m: t.crown_thickness,
            minimum_thickness_factor: t.factor[1],
            thickness_factor_that_falls: t.factor[0],
            minimum_thickness_over_mean_radius: t.over_mean_radius,
        }),
        ..c.support().map(|s| object! {
            last_stable_movement_m: s.last_stable,
            collapse_movement_m: s.collapse,
            movement_step_m: s.step,
        }),
        packing?: c.packing.as_ref().map(|p| object! {
            solid_fraction: p.solid_fraction,
            coordination: p.coordination,
            mean_stress_kpa: kilo(p.mean_stress),
            smallest_diameter_m: p.diameters[0],
            largest_diameter_m: p.diameters[1],
            settlement_mm: 1e3 * p.settlement,
            seed: p.seed,
        }),
        combination?: c.combination.as_ref().map(|both| object! {
            components: list(&both.components, component),
            headline_total_kn: both.headline.map(kilo),
            last_stable_total_kn: both.last_stable_load.map(kilo),
            total_kn: both.collapse_load.map(kilo),
            assumptions: note::words(&both.assumptions),
        }),
        wall_strip?: c.wall_strip.as_deref().map(collapse),
        assumptions: note::words(&c.assumptions),
        warnings: warnings(&c.warnings),
        tolerance: c.tolerance,
        seed: c.seed,
    }
}

/// Axles of a load as the file has them, and as they are carried: times the factor with which the loads of the file are.
fn axles(c: &Collapse) -> Vec<Object> {
    let times = |axles: &[f64], factor: f64| axles.iter().map(|axle| kilo(factor * axle)).collect::<Vec<_>>();
    list(&c.asked, |asked| {
        object! {
            name: asked.name,
            axles_kn: times(&asked.axles, 1.0),
            effective_width_m: asked.effective_width,
            carried_kn: c.load_factor().map(|factor| times(&asked.axles, factor)),
        }
    })
}

/// The load path.
fn path(c: &Collapse) -> Vec<Object> {
    let moves = c.analysis() == Analysis::SupportMovement;
    list(&c.picture.path, |s| {
        object! {
            load_kn_per_m?: (!moves).then(|| kilo(s.load)),
            movement_m?: moves.then_some(s.load),
            displacement_mm: 1e3 * s.displacement[0].hypot(s.displacement[1]),
            displacement_x_mm: 1e3 * s.displacement[0],
            displacement_y_mm: 1e3 * s.displacement[1],
            iterations: s.iterations,
            unbalanced_ratio: s.unbalanced_ratio,
            at_rest: s.at_rest,
        }
    })
}

/// Points of all lines of thrust.
fn thrust_line(c: &Collapse) -> Vec<Object> {
    let points = c.picture.thrust_lines.iter().flatten();
    list(points, |t| object! { x_m: t.point[0], y_m: t.point[1], thrust_kn_per_m: kilo(t.thrust), })
}

fn component(part: &crate::collapse::Component) -> Object {
    let total = |load: Option<f64>| load.map(|load| kilo(load * part.width));
    object! {
        strip: strip(part.strip),
        status: part.status,
        headline_kn_per_m: part.headline.map(kilo),
        last_stable_load_kn_per_m: part.last_stable_load.map(kilo),
        collapse_load_kn_per_m: part.collapse_load.map(kilo),
        width_m: part.width,
        headline_kn: total(part.headline),
        last_stable_load_kn: total(part.last_stable_load),
        collapse_load_kn: total(part.collapse_load),
    }
}
