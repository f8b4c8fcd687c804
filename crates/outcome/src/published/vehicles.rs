//! The objects of a sweep of vehicles.

use super::collapse::CollapseObject;
use super::tables::row;
use super::{Run, WarningObject, kilo};
use crate::vehicles::{ByDiscreteElements, Case, Extreme, SectionEnvelope, Swept, VehicleSweep, Weights};
use rules::{Factor, Source};
use serde::Serialize;

/// What `collapse --sweep` prints for a file with [sweep].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct VehicleSweepObject {
    schema: &'static str,
    status: &'static str,
    bridge: String,
    rule: RuleObject,
    weight_combinations: Vec<WeightsObject>,
    step_m: f64,
    positions_not_converged: usize,
    governing: Option<GoverningObject>,
    vehicles: Vec<VehicleObject>,
    #[serde(skip_serializing_if = "Option::is_none")]
    discrete_elements: Option<SecondObject>,
    #[serde(skip_serializing_if = "Option::is_none")]
    collapse: Option<CollapseObject>,
    assumptions: Vec<String>,
    warnings: Vec<WarningObject>,
    #[serde(skip_serializing_if = "Option::is_none")]
    threads: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    wall_seconds: Option<f64>,
}

/// The governing position, as in sweeps of the file's own loads, with its vehicle.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct GoverningObject {
    vehicle: String,
    adequacy_factor: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    adequacy_factor_at_most: Option<f64>,
    method: Option<&'static str>,
    #[serde(flatten)]
    case: Option<CaseObject>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct RuleObject {
    code: String,
    title: String,
    source: SourceObject,
    factors: Vec<FactorObject>,
}

/// Factors on weights; none where the bridge has no such weight.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct WeightsObject {
    masonry: f64,
    fill: Option<f64>,
    surfacing: Option<f64>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct FactorObject {
    name: String,
    value: f64,
    source: SourceObject,
}

/// What motion adds to the loads of a vehicle by the rule.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct ImpactObject {
    rule: String,
    sources: Vec<SourceObject>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct SourceObject {
    text: String,
    date: String,
    confidence: &'static str,
    #[serde(skip_serializing_if = "String::is_empty")]
    note: String,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct VehicleObject {
    code: String,
    title: String,
    model: String,
    status: &'static str,
    adequacy_factor: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    adequacy_factor_at_most: Option<f64>,
    positions: usize,
    positions_not_converged: usize,
    lower_bound: Option<f64>,
    upper_bound: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    without_dilation: Option<f64>,
    effective_width_m: f64,
    load_factor: f64,
    load_factor_per_span: Vec<f64>,
    critical_axle_factor: f64,
    live_load_factor: f64,
    impact: ImpactObject,
    vehicles_abreast: usize,
    at_edge: bool,
    source: SourceObject,
    weight_factors: Option<WeightsObject>,
    case: Option<CaseObject>,
    sections: Vec<SectionObject>,
    cases: usize,
    by_interior_point: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct CaseObject {
    position_m: f64,
    direction: &'static str,
    #[serde(skip_serializing_if = "String::is_empty")]
    arrangement: String,
    first_axle: Option<usize>,
    last_axle: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    critical_axle: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    uniform_load_m: Option<[f64; 2]>,
    load_kn_per_m: f64,
    weight_factors: WeightsObject,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct SectionObject {
    name: String,
    x_m: f64,
    y_m: f64,
    depth_m: f64,
    extremes: Vec<ExtremeObject>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct ExtremeObject {
    of: &'static str,
    thrust_kn_per_m: f64,
    eccentricity_m: f64,
    outside_section: bool,
    shear_kn_per_m: f64,
    case: CaseObject,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct SecondObject {
    method: &'static str,
    status: Option<&'static str>,
    adequacy_factor: Option<f64>,
    limit_adequacy_factor: Option<f64>,
    step: f64,
    contact_inset_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

impl VehicleSweepObject {
    /// The object of a sweep.
    pub fn new(found: &VehicleSweep, run: &Run) -> VehicleSweepObject {
        let governing = found.governing.and_then(|k| found.vehicles.get(k));
        VehicleSweepObject {
            schema: "extrados.vehicle-sweep/1",
            status: found.status().word(),
            bridge: found.bridge.clone(),
            rule: RuleObject {
                code: found.rule.code.clone(),
                title: found.rule.title.clone(),
                source: source(&found.rule.source),
                factors: found.rule.listed().into_iter().map(factor).collect(),
            },
            weight_combinations: found.weights.iter().map(weights).collect(),
            step_m: found.step,
            positions_not_converged: found.positions_not_converged(),
            governing: governing.map(|v| GoverningObject {
                vehicle: v.code.clone(),
                adequacy_factor: found.headline().map(|headline| headline.0),
                adequacy_factor_at_most: v.adequacy_at_most,
                method: found.headline().map(|headline| super::collapse::method(headline.1)),
                case: v.case.as_ref().map(case),
            }),
            vehicles: found.vehicles.iter().map(vehicle).collect(),
            discrete_elements: found.discrete_elements.as_ref().map(second),
            collapse: found.collapse.as_ref().map(|c| CollapseObject::new(c, &Run::default())),
            assumptions: found.assumptions.clone(),
            warnings: run.file_warnings.iter().cloned().chain(found.warnings.iter().map(WarningObject::from)).collect(),
            threads: (run.threads > 0).then_some(run.threads),
            wall_seconds: (run.threads > 0).then_some(run.wall_seconds),
        }
    }
}

fn source(s: &Source) -> SourceObject {
    let (text, date, note) = (s.text.clone(), s.date.clone(), s.note.clone());
    SourceObject { text, date, confidence: s.confidence.word(), note }
}

fn factor((name, f): (&'static str, &Factor)) -> FactorObject {
    FactorObject { name: name.to_owned(), value: f.value, source: source(&f.source) }
}

fn vehicle(v: &Swept) -> VehicleObject {
    VehicleObject {
        code: v.code.clone(),
        title: v.title.clone(),
        model: v.model.clone(),
        status: v.status.word(),
        adequacy_factor: v.adequacy,
        adequacy_factor_at_most: v.adequacy_at_most,
        positions: v.envelope.len(),
        positions_not_converged: v.positions_not_converged,
        lower_bound: v.bounds.map(|b| b[0]),
        upper_bound: v.bounds.map(|b| b[1]),
        without_dilation: v.without_dilation,
        effective_width_m: v.effective_width,
        load_factor: v.load_factors[0],
        load_factor_per_span: v.span_factors.clone(),
        critical_axle_factor: v.load_factors[1],
        live_load_factor: v.acting.live_load.value,
        impact: ImpactObject {
            rule: v.acting.impact.told(),
            sources: v.acting.impact.sources().into_iter().map(source).collect(),
        },
        vehicles_abreast: v.across.abreast,
        at_edge: v.across.at_edge,
        source: source(&v.source),
        weight_factors: v.weights.as_ref().map(weights),
        case: v.case.as_ref().map(case),
        sections: v.sections.iter().map(section).collect(),
        cases: v.cases,
        by_interior_point: v.by_interior_point,
    }
}

fn case(c: &Case) -> CaseObject {
    CaseObject {
        position_m: c.position,
        direction: c.direction.word(),
        arrangement: c.arrangement.clone(),
        first_axle: c.axles.map(|a| a[0] + 1),
        last_axle: c.axles.map(|a| a[1] + 1),
        critical_axle: c.critical_axle.map(|a| a + 1),
        uniform_load_m: c.uniform,
        load_kn_per_m: kilo(c.load),
        weight_factors: weights(&c.weights),
    }
}

fn weights(w: &Weights) -> WeightsObject {
    WeightsObject { masonry: w.masonry, fill: w.fill, surfacing: w.surfacing }
}

/// The same as three cells.
fn weight_cells(w: Option<Weights>) -> String {
    let cells = [w.map(|w| w.masonry), w.and_then(|w| w.fill), w.and_then(|w| w.surfacing)];
    cells.map(number).join(",")
}

fn section(s: &SectionEnvelope) -> SectionObject {
    SectionObject {
        name: s.name.clone(),
        x_m: s.at[0],
        y_m: s.at[1],
        depth_m: s.depth,
        extremes: s.extremes.iter().map(extreme).collect(),
    }
}

fn extreme(e: &Extreme) -> ExtremeObject {
    ExtremeObject {
        of: e.of.word(),
        thrust_kn_per_m: kilo(e.thrust),
        eccentricity_m: e.eccentricity,
        outside_section: e.outside,
        shear_kn_per_m: kilo(e.shear),
        case: case(&e.case),
    }
}

fn second(c: &ByDiscreteElements) -> SecondObject {
    SecondObject {
        method: "dem",
        status: c.status.map(|s| s.word()),
        adequacy_factor: c.adequacy,
        limit_adequacy_factor: c.limit,
        step: c.step,
        contact_inset_m: c.inset,
        reason: c.reason.clone(),
    }
}

fn number(v: Option<f64>) -> String {
    v.map_or(String::new(), |v| v.to_string())
}

/// Vehicles with their adequacy factors.
pub fn vehicles_table(found: &VehicleSweep) -> String {
    let mut csv = String::from(
        "vehicle,model,status,adequacy_factor,adequacy_factor_at_most,positions,positions_not_converged,lower_bound,upper_bound,without_dilation,position_m,direction,first_axle,last_axle,\
         critical_axle,uniform_from_m,uniform_to_m,load_kn_per_m,effective_width_m,weight_masonry,\
         weight_fill,weight_surfacing,arrangement\n",
    );
    for v in &found.vehicles {
        let c = v.case.as_ref();
        let axle = |k: Option<usize>| k.map_or(String::new(), |k| (k + 1).to_string());
        row(
            &mut csv,
            format_args!(
                "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},\"{}\"",
                v.code,
                v.model,
                v.status.word(),
                number(v.adequacy),
                number(v.adequacy_at_most),
                v.envelope.len(),
                v.positions_not_converged,
                number(v.bounds.map(|b| b[0])),
                number(v.bounds.map(|b| b[1])),
                number(v.without_dilation),
                number(c.map(|c| c.position)),
                c.map_or("", |c| c.direction.word()),
                axle(c.and_then(|c| c.axles).map(|a| a[0])),
                axle(c.and_then(|c| c.axles).map(|a| a[1])),
                axle(c.and_then(|c| c.critical_axle)),
                number(c.and_then(|c| c.uniform).map(|u| u[0])),
                number(c.and_then(|c| c.uniform).map(|u| u[1])),
                number(c.map(|c| kilo(c.load))),
                v.effective_width,
                weight_cells(v.weights),
                c.map_or("", |c| &c.arrangement),
            ),
        );
    }
    csv
}

/// The least adequacy factor at every position of every vehicle.
pub fn vehicle_envelope_table(found: &VehicleSweep) -> String {
    let mut csv = String::from(
        "vehicle,direction,position_m,converged,adequacy_factor,first_axle,last_axle,weight_masonry,weight_fill,\
         weight_surfacing,arrangement\n",
    );
    for v in &found.vehicles {
        for p in &v.envelope {
            let axle = |k: usize| p.axles.map_or(String::new(), |a| (a[k] + 1).to_string());
            row(
                &mut csv,
                format_args!(
                    "{},{},{},{},{},{},{},{},\"{}\"",
                    v.code,
                    p.direction.word(),
                    p.position,
                    p.converged,
                    number(p.adequacy),
                    axle(0),
                    axle(1),
                    weight_cells(p.weights),
                    p.arrangement
                ),
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
                let axle = |k: usize| e.case.axles.map_or(String::new(), |a| (a[k] + 1).to_string());
                row(
                    &mut csv,
                    format_args!(
                        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
                        v.code,
                        s.name,
                        s.at[0],
                        s.at[1],
                        s.depth,
                        e.of,
                        kilo(e.thrust),
                        e.eccentricity,
                        e.outside,
                        kilo(e.shear),
                        e.case.position,
                        e.case.direction.word(),
                        axle(0),
                        axle(1),
                        weight_cells(Some(e.case.weights))
                    ),
                );
            }
        }
    }
    csv
}
