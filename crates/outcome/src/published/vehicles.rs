//! `extrados.vehicle-sweep/1`, and its tables.

use super::{Object, Quoted, collapse, each, from_one, kilo, list, not_counted, object, row, said, warnings};
use crate::note;
use crate::vehicles::{Case, SectionEnvelope, Swept, VehicleSweep, Weights};
use rules::Source;

/// The result of `collapse --sweep` for a file with [sweep].
pub fn vehicle_sweep(found: &VehicleSweep) -> Object {
    let governing = found.governing.and_then(|k| found.vehicles.get(k));
    object! {
        schema: "extrados.vehicle-sweep/1",
        status: found.status(),
        bridge: found.bridge,
        rule: object! {
            code: found.rule.code,
            title: found.rule.title,
            source: source(&found.rule.source),
            factors: list(found.rule.listed(), |(name, factor)| object! {
                name: name,
                value: factor.value,
                source: source(&factor.source),
            }),
        },
        weight_combinations: list(&found.weights, weights),
        step_m: found.step,
        positions_not_converged: found.positions_not_converged(),
        grades?: Some(found.grades()).filter(|all| !all.is_empty()).map(|all| list(&all, |one| object! {
            of: one.of,
            highest: one.highest,
            carried: one.carried,
            not_carried: one.not_carried,
            unanswered: one.unanswered,
        })),
        // The governing position, as in sweeps of the file's own loads, with its vehicle.
        governing: governing.map(|v| object! {
            vehicle: v.code,
            adequacy_factor: found.headline().map(|headline| headline.0),
            adequacy_factor_at_most?: v.adequacy_at_most,
            method: found.headline().map(|headline| super::collapse::method(headline.1)),
            ..not_counted(&v.not_counted),
            ..v.case.as_ref().map(case),
        }),
        vehicles: list(&found.vehicles, vehicle),
        discrete_elements?: found.discrete_elements.as_ref().map(|c| object! {
            method: "dem",
            status: c.status,
            adequacy_factor: c.adequacy,
            limit_adequacy_factor: c.limit,
            step: c.step,
            contact_inset_m: c.inset,
            reason?: c.reason,
        }),
        collapse?: found.collapse.as_deref().map(collapse),
        assumptions: note::words(&found.assumptions),
        warnings: warnings(&found.warnings),
    }
}

fn source(s: &Source) -> Object {
    object! { text: s.text, date: s.date, confidence: s.confidence.word(), note?: said(&s.note), }
}

fn vehicle(v: &Swept) -> Object {
    object! {
        code: v.code,
        title: v.title,
        model: v.model,
        status: v.status,
        adequacy_factor: v.adequacy,
        adequacy_factor_at_most?: v.adequacy_at_most,
        ..not_counted(&v.not_counted),
        rigid_factor?: v.rigid,
        ..v.deformable.as_ref().map(|d| object! {
            deformable_factor: d.adequacy,
            paths_broken_off: d.broken_off,
            deformable_case: d.case.as_ref().map(case),
            permissible: list(&d.permissible, |p| object! {
                criterion: p.criterion,
                adequacy_factor: p.adequacy,
                position_m: p.position,
            }),
            envelope: list(&v.envelope, |p| object! {
                position_m: p.position,
                direction: p.direction,
                arrangement?: said(&p.arrangement),
                adequacy_factor: p.adequacy,
                rigid_factor: p.rigid,
                deformable_factor: p.deformable,
            }),
        }),
        positions: v.envelope.len(),
        positions_not_converged: v.positions_not_converged,
        lower_bound: v.bounds.map(|b| b[0]),
        upper_bound: v.bounds.map(|b| b[1]),
        without_dilation?: v.without_dilation,
        effective_width_m: v.effective_width,
        load_factor: v.load_factors[0],
        load_factor_per_span: v.span_factors,
        critical_axle_factor: v.load_factors[1],
        live_load_factor: v.acting.live_load.value,
        // What motion adds to the loads of a vehicle by the rule.
        impact: object! {
            rule: v.acting.impact.told(),
            sources: list(v.acting.impact.sources(), source),
        },
        vehicles_abreast: v.across.abreast,
        at_edge: v.across.at_edge,
        strip_between_cracks_m: v.across.strip,
        wheel_lines_m: v.across.wheels,
        effective_width_derivation: v.across.derivation,
        source: source(&v.source),
        weight_factors: v.weights.as_ref().map(weights),
        case: v.case.as_ref().map(case),
        sections: list(&v.sections, section),
        cases: v.cases,
        by_interior_point: v.by_interior_point,
    }
}

fn case(c: &Case) -> Object {
    object! {
        position_m: c.position,
        direction: c.direction,
        arrangement?: said(&c.arrangement),
        first_axle: c.axles.map(|a| a[0] + 1),
        last_axle: c.axles.map(|a| a[1] + 1),
        critical_axle?: c.critical_axle.map(|a| a + 1),
        uniform_load_m?: c.uniform,
        horizontal_share: c.horizontal,
        load_kn_per_m: kilo(c.load),
        weight_factors: weights(&c.weights),
    }
}

/// Factors on weights; none where the bridge has no such weight.
fn weights(w: &Weights) -> Object {
    object! { masonry: w.masonry, fill: w.fill, surfacing: w.surfacing, }
}

/// The same as three cells.
fn weight_cells(w: Option<Weights>) -> [Option<f64>; 3] {
    [w.map(|w| w.masonry), w.and_then(|w| w.fill), w.and_then(|w| w.surfacing)]
}

fn section(s: &SectionEnvelope) -> Object {
    object! {
        name: s.name,
        x_m: s.at[0],
        y_m: s.at[1],
        depth_m: s.depth,
        extremes: list(&s.extremes, |e| object! {
            of: e.of,
            thrust_kn_per_m: kilo(e.thrust),
            eccentricity_m: e.eccentricity,
            outside_section: e.outside,
            shear_kn_per_m: kilo(e.shear),
            case: case(&e.case),
        }),
    }
}

/// Vehicles with their adequacy factors.
pub fn vehicles_table(found: &VehicleSweep) -> String {
    let mut csv = String::from(
        "vehicle,model,status,adequacy_factor,adequacy_factor_at_most,positions,positions_not_converged,lower_bound,upper_bound,without_dilation,rigid_factor,deformable_factor,position_m,direction,first_axle,last_axle,\
         critical_axle,uniform_from_m,uniform_to_m,load_kn_per_m,effective_width_m,weight_masonry,\
         weight_fill,weight_surfacing,arrangement\n",
    );
    for v in &found.vehicles {
        let c = v.case.as_ref();
        row!(
            &mut csv,
            v.code,
            v.model,
            v.status.word(),
            [v.adequacy, v.adequacy_at_most],
            [v.envelope.len(), v.positions_not_converged],
            each(v.bounds),
            v.without_dilation,
            [v.rigid, v.deformable.as_ref().and_then(|d| d.adequacy)],
            c.map(|c| c.position),
            c.map(|c| c.direction.word()),
            each(from_one(c.and_then(|c| c.axles))),
            c.and_then(|c| c.critical_axle).map(|k| k + 1),
            each(c.and_then(|c| c.uniform)),
            c.map(|c| kilo(c.load)),
            v.effective_width,
            weight_cells(v.weights),
            Quoted(c.map_or("", |c| &c.arrangement))
        );
    }
    csv
}

/// The least adequacy factor at every position of every vehicle.
pub fn vehicle_envelope_table(found: &VehicleSweep) -> String {
    let mut csv = String::from(
        "vehicle,direction,position_m,converged,adequacy_factor,rigid_factor,deformable_factor,first_axle,last_axle,weight_masonry,weight_fill,\
         weight_surfacing,arrangement\n",
    );
    for v in &found.vehicles {
        for p in &v.envelope {
            let axles = each(from_one(p.axles));
            let weights = weight_cells(p.weights);
            let arrangement = Quoted(&p.arrangement);
            row!(
                &mut csv,
                v.code,
                p.direction.word(),
                p.position,
                p.converged,
                [p.adequacy, p.rigid, p.deformable],
                axles,
                weights,
                arrangement
            );
        }
    }
    csv
}

/// Extremes at critical joints, each with the values and the position that go with it.
pub fn vehicle_sections_table(found: &VehicleSweep) -> String {
    let mut csv = String::from(
        "vehicle,section,x_m,y_m,depth_m,extreme,thrust_kn_per_m,eccentricity_m,outside_section,shear_kn_per_m,position_m,direction,first_axle,last_axle,\
         weight_masonry,weight_fill,weight_surfacing\n",
    );
    for v in &found.vehicles {
        for s in &v.sections {
            for e in &s.extremes {
                let (case, shear) = (&e.case, kilo(e.shear));
                row!(
                    &mut csv,
                    [&v.code, &s.name],
                    s.at,
                    s.depth,
                    e.of.word(),
                    kilo(e.thrust),
                    e.eccentricity,
                    e.outside,
                    shear,
                    case.position,
                    case.direction.word(),
                    each(from_one(case.axles)),
                    weight_cells(Some(case.weights))
                );
            }
        }
    }
    csv
}
