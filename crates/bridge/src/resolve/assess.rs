//! The assessment that a file asks for.

use super::materials::maybe;
use crate::assess::{Assess, Expected, Limits, Mexe, MexeAxles, ServiceLoad};
use crate::findings::Findings;
use crate::quantity;
use crate::tree::Table;

/// Sections of an assessment, which are no part of the bridge.
pub(crate) const SECTIONS: [&str; 4] = ["assess", "service_load", "mexe", "expected"];

/// What the file asks for; a file that says nothing of it asks for what needs no limit.
pub(crate) fn assess(file: &Table<'_>, spans: Option<usize>, findings: &mut Findings) -> Option<Assess> {
    let limits = match file.has("assess") {
        true => file.table("assess", findings).and_then(|table| limits(&table, findings)),
        false => Some(Limits { movement_factor: 1.0, load_factor_included: 1.0, ..Limits::default() }),
    };
    let loads: Vec<Option<ServiceLoad>> =
        file.tables("service_load", findings).iter().map(|table| service_load(table, findings)).collect();
    let mexe = match file.has("mexe") {
        true => file.table("mexe", findings).and_then(|table| mexe(&table, spans, findings)).map(Some),
        false => Some(None),
    };
    let expected: Vec<Option<Expected>> =
        file.tables("expected", findings).iter().map(|table| expected(table, findings)).collect();
    Some(Assess {
        service_loads: loads.into_iter().collect::<Option<_>>()?,
        limits: limits?,
        mexe: mexe?,
        expected: expected.into_iter().collect::<Option<_>>()?,
    })
}

/// A quantity that may be missing.
fn quantity(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<Option<f64>> {
    let value = table.quantity(key, findings);
    maybe(table, key, value)
}

/// A number that may be missing.
fn number(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<Option<f64>> {
    let value = table.number(key, findings);
    maybe(table, key, value)
}

/// A text that may be missing.
fn text(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<Option<String>> {
    let value = table.text(key, findings);
    Some(maybe(table, key, value)?.map(str::to_owned))
}

fn limits(table: &Table<'_>, findings: &mut Findings) -> Option<Limits> {
    let [source, rule, adequacy_source, skew_source] =
        ["source", "rule", "adequacy_source", "skew_source"].map(|key| text(table, key, findings));
    let [loaded_length, cushion, deflection, compression, tension, joint_shear, expected_movement] = [
        "loaded_length",
        "cushion",
        "deflection_limit",
        "compression_limit",
        "tension_limit",
        "joint_shear_limit",
        "expected_movement",
    ]
    .map(|key| quantity(table, key, findings));
    let [adequacy_factor, load_factor_included, model_factor, permissible_share, load_cycles, movement_factor] = [
        "adequacy_factor",
        "load_factor_included",
        "model_factor",
        "permissible_share",
        "load_cycles",
        "movement_factor",
    ]
    .map(|key| number(table, key, findings));
    let zone = table.word("thrust_zone", findings);
    let zone = maybe(table, "thrust_zone", zone)?;
    Some(Limits {
        source: source?,
        rule: rule?,
        loaded_length: loaded_length?,
        cushion: cushion?,
        deflection: deflection?,
        compression: compression?,
        tension: tension?,
        joint_shear: joint_shear?,
        thrust_zone: zone.map(|word| if word == "middle-third" { 1.0 / 3.0 } else { 0.5 }),
        adequacy_factor: adequacy_factor?,
        adequacy_source: adequacy_source?,
        skew_source: skew_source?,
        load_factor_included: load_factor_included?.unwrap_or(1.0),
        model_factor: model_factor?,
        permissible_share: permissible_share?,
        load_cycles: load_cycles?,
        expected_movement: expected_movement?,
        movement_factor: movement_factor?.unwrap_or(1.0),
    })
}

fn service_load(table: &Table<'_>, findings: &mut Findings) -> Option<ServiceLoad> {
    let name = table.text("name", findings);
    let axle_load = quantity(table, "axle_load", findings);
    let source = text(table, "source", findings);
    Some(ServiceLoad { name: name?.value.to_owned(), axle_load: axle_load?, source: source? })
}

fn mexe(table: &Table<'_>, spans: Option<usize>, findings: &mut Findings) -> Option<Mexe> {
    let span = table.count("span", findings);
    let span = maybe(table, "span", span)?.map_or(1, |n| usize::try_from(n).unwrap_or(usize::MAX));
    if spans.is_some_and(|spans| span > spans) {
        let help = format!("write a number from 1 to {}", spans.unwrap_or(1));
        findings.error("B107", table.place("span"), format!("there is no span {span}"), "which span", help);
        return None;
    }
    let mut needed = |key| table.number(key, findings).map(|at| at.value);
    let factors = ["barrel_factor", "fill_factor", "width_factor", "depth_factor", "mortar_factor", "condition_factor"]
        .map(&mut needed);
    let span_rise_factor = number(table, "span_rise_factor", findings);
    let axle_factor = number(table, "axle_factor", findings);
    let axles = table.word("axles", findings);
    let axles = maybe(table, "axles", axles);
    let lift_off = table.flag("lift_off", findings);
    let lift_off = maybe(table, "lift_off", lift_off);
    let [quarter_rise, ring_thickness, fill_depth, axle_load] =
        ["quarter_rise", "ring_thickness", "fill_depth", "axle_load"].map(|key| quantity(table, key, findings));
    let [barrel, fill, width, depth, mortar, condition] = factors;
    Some(Mexe {
        span: span - 1,
        barrel_factor: barrel?,
        fill_factor: fill?,
        width_factor: width?,
        depth_factor: depth?,
        mortar_factor: mortar?,
        condition_factor: condition?,
        span_rise_factor: span_rise_factor?,
        quarter_rise: quarter_rise?,
        ring_thickness: ring_thickness?,
        fill_depth: fill_depth?,
        axle_load: axle_load?,
        axles: match axles? {
            Some("bogie") => MexeAxles::Bogie,
            Some("triple") => MexeAxles::Triple,
            _ => MexeAxles::Single,
        },
        lift_off: lift_off?.unwrap_or(false),
        axle_factor: axle_factor?,
    })
}

fn expected(table: &Table<'_>, findings: &mut Findings) -> Option<Expected> {
    let parameter = table.text("parameter", findings);
    let ends = ["lower", "upper"].map(|key| end(table, key, findings));
    let [source, below, above] = ["source", "below", "above"].map(|key| text(table, key, findings));
    let [lower, upper] = [ends[0]?, ends[1]?];
    if lower >= upper {
        let help = "write the lower end first";
        findings.error("B107", table.place("lower"), "the expected range is empty", "lower end", help);
        return None;
    }
    Some(Expected {
        parameter: parameter?.value.to_owned(),
        lower,
        upper,
        source: source?,
        below: below?,
        above: above?,
    })
}

/// An end of a range: a number with a unit in SI, or a bare number.
fn end(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<f64> {
    let literal = table.value(key, findings)?;
    let number = match literal.trim().trim_matches('"') {
        quoted if literal.trim().starts_with('"') => quantity::parse(quoted).ok().map(|quantity| quantity.si()),
        bare => bare.replace('_', "").parse::<f64>().ok(),
    };
    let number = number.filter(|number| number.is_finite());
    if number.is_none() {
        let help = "write a number, with its unit where the parameter has one: \"1 GPa\"";
        findings.error("B107", table.place(key), format!("{literal} is no end of a range"), "end of the range", help);
    }
    number
}
