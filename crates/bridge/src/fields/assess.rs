//! An assessment: limits, loads in service, MEXE, expected ranges.

use crate::assess::{Assess, Expected, Limits, Mexe, MexeAxles, ServiceLoad};
use crate::card::{Field, Kind, Section};
use crate::cards::*;
use crate::choice::choice;
use crate::findings::Findings;
use crate::quantity;
use crate::tree::Table;
use crate::values::read;

choice! {
    /// Part of the ring in which the line of thrust must stay.
    enum ThrustZone {
        /// the joint stays closed
        MiddleThird = "middle-third",
        /// the joint stays closed over three quarters of its depth
        MiddleHalf = "middle-half",
    }
}

pub(super) static ASSESS: Section = Section {
    path: "assess",
    doc: "Limits that `extrados assess` compares with. None has a default: a check whose limit is not given is listed as not made.",
    fields: &[
        text("source", "where the limits come from", "Table 7 of the railway paper")
            .optional("the report says that the file names no source"),
        text("rule", "rule of the library whose dynamic augment counts", "irs-bridge-rules")
            .optional("no dynamic augment is added, and the report says so"),
        length("loaded_length", "loaded length for the coefficient of dynamic augment", "6 m")
            .positive()
            .optional("the longest span"),
        length("cushion", "depth between load and ring that reduces the dynamic augment", "0.48 m")
            .at_least(0.0)
            .optional("the cover's depth"),
        length("deflection_limit", "largest deflection of a crown", "5 mm")
            .positive()
            .optional("deflections are not checked"),
        stress("compression_limit", "largest compression along the ring", "2 MPa")
            .positive()
            .optional("compression is not checked"),
        stress("tension_limit", "largest tension along the ring", "0.2 MPa")
            .at_least(0.0)
            .optional("tension is not checked"),
        stress("joint_shear_limit", "shear strength of joints", "1 MPa")
            .positive()
            .optional("shear in joints is not checked"),
        word::<ThrustZone>("thrust_zone", "where the thrust line must stay in service", "middle-half")
            .optional("the thrust line is not checked"),
        number("adequacy_factor", "least factor on loads at ultimate", "1.0")
            .between(1.0, 4.0)
            .optional("factors are listed and not checked"),
        text("adequacy_source", "document and clause that `adequacy_factor` is from", "BS 5400-2, Table 1")
            .optional(
                "the check against `adequacy_factor` is made, but does not assess strength: no verdict of adequacy \
                 rests on it",
            ),
        text(
            "skew_source",
            "document and clause, or test, that confirms the square model for the skew of [carriageway]",
            "finite elements in three dimensions, report 12",
        )
        .optional("with a skew of more than 10 degrees no verdict of adequacy is given"),
        number("load_factor_included", "factor that the forces of [[load]] already carry", "1.9")
            .between(1.0, 4.0)
            .default("1"),
        Field::new(
            "model_factor",
            Kind::NumberOr("tests"),
            "factor for the method of analysis, from `adequacy_source`; \"tests\" brings that of tests to collapse into \
             every check of strength, those by a rule among them",
            "1.1",
        )
        .between(1.0, 4.0)
        .optional(
            "under `adequacy_factor` and in a `rule_file` that of tests to collapse \
             (docs/verification/model-factor.md); the factors of a standard cover its own method",
        ),
        number("permissible_share", "largest share of the ultimate load in service", "0.5")
            .positive_up_to(1.0)
            .optional("the share is not checked"),
        number("onset_factor", "least factor on loads at which a joint is half open or at half its strength", "1.0")
            .above(0.0)
            .optional("states in service are not checked"),
        stress(
            "bearing_limit",
            "largest pressure on the ground below piers and abutments, with the factors that loads have here",
            "300 kPa",
        )
        .positive()
        .optional("the pressure on the ground is not checked"),
        number(
            "foot_eccentricity_limit",
            "largest distance of the resultant at rest from the middle of the foot of a pier or abutment, over its depth",
            "0.1667",
        )
        .positive_up_to(0.5)
        .optional("where the resultant meets the ground is not checked"),
        number("load_cycles", "load cycles in the required life", "1e7")
            .between(1.0, 1e12)
            .optional("the range of stress is not checked"),
        length("expected_movement", "support movement, expected or measured", "20 mm")
            .at_least(0.0)
            .optional("movements are not checked"),
        number("movement_factor", "safety factor on that movement", "2").between(1.0, 10.0).default("1"),
    ],
};

pub(super) static SERVICE_LOAD: Section = Section {
    path: "service_load",
    doc: "A load in service: the train of [train] with another mass on all its axles.",
    fields: &[
        text("name", "name in results", "25t HML"),
        mass("axle_load", "mass on every axle", "25 t").positive().optional("axles as the train has them"),
        text("source", "where it comes from", "Table 7 of the railway paper")
            .optional("the report says that the file names no source"),
    ],
};

const fn factor(key: &'static str, doc: &'static str, example: &'static str) -> Field {
    number(key, doc, example).positive_up_to(2.0)
}

pub(super) static MEXE: Section = Section {
    path: "mexe",
    doc: "The modified MEXE method: its modifying factors for this bridge. Span, rise, ring and cover are those of the \
          file.",
    fields: &[
        count("span", "which span, counted from 1", "1").between(1.0, 200.0).default("1"),
        factor("barrel_factor", "F_b: material of the barrel; 1.5 granite to 0.7 poor masonry", "1.2"),
        factor("fill_factor", "F_f: fill; 1.0 concrete to 0.5 weak", "0.7"),
        factor("width_factor", "F_w: width of joints; 1.0 up to 6 mm, 0.9 up to 12.5 mm, 0.8 beyond", "0.9"),
        factor("depth_factor", "F_d: depth of joints without mortar; 1.0 pointed, 0.9 up to 12.5 mm, 0.8 more", "1.0"),
        factor("mortar_factor", "F_mo: mortar; 1.0 good, 0.9 loose", "0.9"),
        factor("condition_factor", "F_cM: condition of the barrel, as its inspector judges", "0.9"),
        factor("span_rise_factor", "F_sr: read off the method's figure", "0.9")
            .optional("1 up to a span of four rises, then the method's curve as recalled, up to eight"),
        length("quarter_rise", "rise at the quarter points", "1.373 m").positive().optional("that of the profile"),
        length("ring_thickness", "thickness of the ring that counts", "0.34 m")
            .positive()
            .optional("that of all rings at the crown"),
        length("fill_depth", "depth of fill at the crown", "0.40 m").at_least(0.0).optional("the cover's depth"),
        mass("axle_load", "required mass on each of `axles`", "11.5 t")
            .positive()
            .optional("the allowable axle load is listed and not checked"),
        word::<MexeAxles>("axles", "axles with that mass on each", "bogie").default(MexeAxles::Single.word()),
        flag("lift_off", "whether an axle of a bogie may lift off", "true").default("false"),
        factor("axle_factor", "A_f: read off the method's figure for `axles` and `lift_off`", "0.9")
            .optional(
                "1 for a bogie without lift-off, which the method is made for, and for a single axle; otherwise the check is not made",
            ),
    ],
};

pub(super) static EXPECTED: Section = Section {
    path: "expected",
    doc: "The expected range of an identified parameter in a sound bridge of this kind, and what a value outside it \
          means.",
    fields: &[
        text("parameter", "name of a [[parameter]]", "mortar"),
        value("lower", "lower end", "1 GPa"),
        value("upper", "upper end", "2 GPa"),
        text("source", "where the range comes from", "Table 2 of the railway paper")
            .optional("the report says that the file names no source"),
        text("below", "what a lower value means, for the owner", "the mortar has lost stiffness")
            .optional("it is lower than expected"),
        text("above", "what a higher value means, for the owner", "joints may have been repointed")
            .optional("it is higher than expected"),
    ],
};

/// What the file asks for; a file that says nothing of it asks for what needs no limit.
pub(crate) fn assess(file: &Table<'_>, spans: Option<usize>, findings: &mut Findings) -> Option<Assess> {
    let limits = file.part("assess", findings, limits);
    let loads = file.all("service_load", findings, |t, f| read!(t, f, ServiceLoad { name, axle_load, source }));
    let mexe = file.optional("mexe", findings, |table, findings| mexe(table, spans, findings));
    let expected = file.all("expected", findings, expected);
    Some(Assess { service_loads: loads?, limits: limits?, mexe: mexe?, expected: expected? })
}

fn limits(table: &Table<'_>, findings: &mut Findings) -> Option<Limits> {
    let zone: Option<Option<ThrustZone>> = table.read("thrust_zone", findings);
    let model: Option<Option<f64>> = table.read("model_factor", findings);
    let of_tests = model.flatten().is_some_and(f64::is_infinite);
    read!(
        table,
        findings,
        Limits {
            source,
            rule,
            loaded_length,
            cushion,
            deflection = "deflection_limit",
            compression = "compression_limit",
            tension = "tension_limit",
            joint_shear = "joint_shear_limit",
            adequacy_factor,
            adequacy_source,
            skew_source,
            load_factor_included,
            permissible_share,
            onset_factor,
            bearing = "bearing_limit",
            foot_eccentricity = "foot_eccentricity_limit",
            load_cycles,
            expected_movement,
            movement_factor;
            model_factor: model?.filter(|value| value.is_finite()),
            model_factor_of_tests: of_tests,
            thrust_zone: zone?.map(|zone| match zone {
                ThrustZone::MiddleThird => 1.0 / 3.0,
                ThrustZone::MiddleHalf => 0.5,
            }),
        }
    )
}

fn mexe(table: &Table<'_>, spans: Option<usize>, findings: &mut Findings) -> Option<Mexe> {
    let mexe = Mexe::of(table, findings)?;
    let span = mexe.span;
    if spans.is_some_and(|spans| span > spans) {
        let help = format!("write a number from 1 to {}", spans.unwrap_or(1));
        return findings.refuse("B107", table.place("span"), format!("there is no span {span}"), "which span", help);
    }
    Some(Mexe { span: span - 1, ..mexe })
}

fn expected(table: &Table<'_>, findings: &mut Findings) -> Option<Expected> {
    let ends = ["lower", "upper"].map(|key| end(table, key, findings));
    let [lower, upper] = [ends[0]?, ends[1]?];
    if lower >= upper {
        let help = "write the lower end first";
        return findings.refuse("B107", table.place("lower"), "the expected range is empty", "lower end", help);
    }
    read!(table, findings, Expected { parameter, source, below, above; lower, upper })
}

/// An end of a range: a number with a unit in SI, or a bare number.
fn end(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<f64> {
    let literal: String = table.read(key, findings)?;
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
