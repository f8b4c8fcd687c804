//! What a bridge file says of its assessment: loads in service, limits, MEXE's factors, expected ranges. No part of the
//! bridge: nothing of it changes what is computed, only what is asked and how it is judged.

use crate::card::{Field, Section};
use crate::cards::*;
use crate::choice::choice;
use crate::findings::Findings;
use crate::quantity;
use crate::tree::Table;
use crate::values::{finite, of_keys};

/// An assessment as a file asks for it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Assess {
    /// Loads in service: the file's train, with these axles; none where only the train itself counts.
    pub service_loads: Vec<ServiceLoad>,
    /// Limits of the checks; a check without its limit cannot be made.
    pub limits: Limits,
    /// MEXE's factors, where the file gives them.
    pub mexe: Option<Mexe>,
    /// Ranges in which identified parameters are expected.
    pub expected: Vec<Expected>,
}

of_keys! {
    /// A load in service.
    #[derive(Debug, Clone, PartialEq)]
    pub struct ServiceLoad {
        pub name: String = text("name in results", "25t HML"),
        pub axle_load: Option<f64> =
            mass("mass on every axle", "25 t").positive().optional("axles as the train has them"),
        pub source: Option<String> = text("where it comes from", "Table 7 of the railway paper")
            .optional("the report says that the file names no source"),
    }
}

of_keys! {
    /// Limits and what they need.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct Limits {
        pub source: Option<String> = text("where the limits come from", "Table 7 of the railway paper")
            .optional("the report says that the file names no source"),
        pub rule: Option<String> = text("rule of the library whose dynamic augment counts", "irs-bridge-rules")
            .optional("no dynamic augment is added, and the report says so"),
        pub loaded_length: Option<f64> = length("loaded length for the coefficient of dynamic augment", "6 m")
            .positive()
            .optional("the longest span"),
        pub cushion: Option<f64> = length("depth between load and ring that reduces the dynamic augment", "0.48 m")
            .at_least(0.0)
            .optional("the cover's depth"),
        pub deflection ("deflection_limit"): Option<f64> =
            length("largest deflection of a crown", "5 mm").positive().optional("deflections are not checked"),
        pub compression ("compression_limit"): Option<f64> =
            stress("largest compression along the ring", "2 MPa").positive().optional("compression is not checked"),
        pub tension ("tension_limit"): Option<f64> =
            stress("largest tension along the ring", "0.2 MPa").at_least(0.0).optional("tension is not checked"),
        pub joint_shear ("joint_shear_limit"): Option<f64> =
            stress("shear strength of joints", "1 MPa").positive().optional("shear in joints is not checked"),
        /// As a part of the ring's thickness: 1/3 or 1/2.
        pub thrust_zone: Option<f64> = word::<ThrustZone>("where the thrust line must stay in service", "middle-half")
            .optional("the thrust line is not checked") => thrust_zone,
        pub adequacy_factor: Option<f64> = number("least factor on loads at ultimate", "1.0")
            .between(1.0, 4.0)
            .optional("factors are listed and not checked"),
        pub adequacy_source: Option<String> =
            text("document and clause that `adequacy_factor` is from", "BS 5400-2, Table 1")
                .optional(
                    "the check against `adequacy_factor` is made, but does not assess strength: no verdict of adequacy \
                 rests on it",
                ),
        pub skew_source: Option<String> = text(
            "document and clause, or test, that confirms the square model for the skew of [carriageway]",
            "finite elements in three dimensions, report 12",
        )
        .optional("with a skew of more than 10 degrees no verdict of adequacy is given"),
        pub load_factor_included: f64 =
            number("factor that the forces of [[load]] already carry", "1.9").between(1.0, 4.0).default("1"),
        /// None where it is that of tests.
        pub model_factor: Option<f64> = number_or_tests(
            "factor for the method of analysis, from `adequacy_source`; \"tests\" brings that of tests to collapse into \
             every check of strength, those by a rule among them",
            "1.1",
        )
        .between(1.0, 4.0)
        .optional(
            "under `adequacy_factor` and in a `rule_file` that of tests to collapse \
             (docs/verification/model-factor.md); the factors of a standard cover its own method",
        ) => finite,
        pub permissible_share: Option<f64> = number("largest share of the ultimate load in service", "0.5")
            .positive_up_to(1.0)
            .optional("the share is not checked"),
        pub onset_factor: Option<f64> =
            number("least factor on loads at which a joint is half open or at half its strength", "1.0")
                .above(0.0)
                .optional("states in service are not checked"),
        pub bearing ("bearing_limit"): Option<f64> = stress(
            "largest pressure on the ground below piers and abutments, with the factors that loads have here",
            "300 kPa",
        )
        .positive()
        .optional("the pressure on the ground is not checked"),
        pub foot_eccentricity ("foot_eccentricity_limit"): Option<f64> = number(
            "largest distance of the resultant at rest from the middle of the foot of a pier or abutment, over its depth",
            "0.1667",
        )
        .positive_up_to(0.5)
        .optional("where the resultant meets the ground is not checked"),
        pub load_cycles: Option<f64> = number("load cycles in the required life", "1e7")
            .between(1.0, 1e12)
            .optional("the range of stress is not checked"),
        pub expected_movement: Option<f64> = length("support movement, expected or measured", "20 mm")
            .at_least(0.0)
            .optional("movements are not checked"),
        pub movement_factor: f64 = number("safety factor on that movement", "2").between(1.0, 10.0).default("1"),
    } and {
        /// Whether the model factor is to be that of tests to collapse, in every check of strength.
        pub model_factor_of_tests: bool => of_tests,
    }
}

of_keys! {
    /// Inputs of MEXE that the rest of the file does not hold.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Mexe {
        /// Here counted from 0.
        pub span: usize = count("which span, counted from 1", "1").between(1.0, 200.0).default("1"),
        pub barrel_factor: f64 = factor("F_b: material of the barrel; 1.5 granite to 0.7 poor masonry", "1.2"),
        pub fill_factor: f64 = factor("F_f: fill; 1.0 concrete to 0.5 weak", "0.7"),
        pub width_factor: f64 = factor("F_w: width of joints; 1.0 up to 6 mm, 0.9 up to 12.5 mm, 0.8 beyond", "0.9"),
        pub depth_factor: f64 =
            factor("F_d: depth of joints without mortar; 1.0 pointed, 0.9 up to 12.5 mm, 0.8 more", "1.0"),
        pub mortar_factor: f64 = factor("F_mo: mortar; 1.0 good, 0.9 loose", "0.9"),
        pub condition_factor: f64 = factor("F_cM: condition of the barrel, as its inspector judges", "0.9"),
        pub span_rise_factor: Option<f64> = factor("F_sr: read off the method's figure", "0.9")
            .optional("1 up to a span of four rises, then the method's curve as recalled, up to eight"),
        pub quarter_rise: Option<f64> =
            length("rise at the quarter points", "1.373 m").positive().optional("that of the profile"),
        pub ring_thickness: Option<f64> =
            length("thickness of the ring that counts", "0.34 m").positive().optional("that of all rings at the crown"),
        pub fill_depth: Option<f64> =
            length("depth of fill at the crown", "0.40 m").at_least(0.0).optional("the cover's depth"),
        pub axle_load: Option<f64> = mass("required mass on each of `axles`", "11.5 t")
            .positive()
            .optional("the allowable axle load is listed and not checked"),
        pub axles: MexeAxles =
            word::<MexeAxles>("axles with that mass on each", "bogie").default(MexeAxles::Single.word()),
        pub lift_off: bool = flag("whether an axle of a bogie may lift off", "true").default("false"),
        pub axle_factor: Option<f64> = factor("A_f: read off the method's figure for `axles` and `lift_off`", "0.9")
            .optional(
                "1 for a bogie without lift-off, which the method is made for, and for a single axle; otherwise the check is not made",
            ),
    }
}

choice! {
    /// Axles that MEXE's load is compared with.
    pub enum MexeAxles {
        /// one axle by itself
        Single = "single",
        /// two axles of a bogie
        Bogie = "bogie",
        /// three axles of a bogie
        Triple = "triple",
    }
}

of_keys! {
    /// A range in which an identified parameter is expected.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Expected {
        pub parameter: String = text("name of a [[parameter]]", "mortar"),
        /// In SI or as a bare number.
        pub lower: f64 = value("lower end", "1 GPa") => end,
        /// Likewise.
        pub upper: f64 = value("upper end", "2 GPa") => end,
        pub source: Option<String> = text("where the range comes from", "Table 2 of the railway paper")
            .optional("the report says that the file names no source"),
        pub below: Option<String> = text("what a lower value means, for the owner", "the mortar has lost stiffness")
            .optional("it is lower than expected"),
        pub above: Option<String> = text("what a higher value means, for the owner", "joints may have been repointed")
            .optional("it is higher than expected"),
    }
}

choice! {
    /// Part of the ring in which the line of thrust must stay.
    enum ThrustZone {
        /// the joint stays closed
        MiddleThird = "middle-third",
        /// the joint stays closed over three quarters of its depth
        MiddleHalf = "middle-half",
    }
}

pub(crate) static ASSESS: Section = Section {
    path: "assess",
    doc: "Limits that `extrados assess` compares with. None has a default: a check whose limit is not given is listed as not made.",
    fields: Limits::CARDS,
};

pub(crate) static SERVICE_LOAD: Section = Section {
    path: "service_load",
    doc: "A load in service: the train of [train] with another mass on all its axles.",
    fields: ServiceLoad::CARDS,
};

const fn factor(key: &'static str, doc: &'static str, example: &'static str) -> Field {
    number(key, doc, example).positive_up_to(2.0)
}

pub(crate) static MEXE: Section = Section {
    path: "mexe",
    doc: "The modified MEXE method: its modifying factors for this bridge. Span, rise, ring and cover are those of the \
          file.",
    fields: Mexe::CARDS,
};

pub(crate) static EXPECTED: Section = Section {
    path: "expected",
    doc: "The expected range of an identified parameter in a sound bridge of this kind, and what a value outside it \
          means.",
    fields: Expected::CARDS,
};

/// What the file asks for; a file that says nothing of it asks for what needs no limit.
pub(crate) fn assess(file: &Table<'_>, spans: Option<usize>, findings: &mut Findings) -> Option<Assess> {
    let limits = file.part("assess", findings, Limits::of);
    let loads = file.all("service_load", findings, ServiceLoad::of);
    let mexe = file.optional("mexe", findings, |table, findings| mexe(table, spans, findings));
    let expected = file.all("expected", findings, expected);
    Some(Assess { service_loads: loads?, limits: limits?, mexe: mexe?, expected: expected? })
}

/// The part of the ring in words as a share of its thickness.
fn thrust_zone(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<Option<f64>> {
    let zone: Option<ThrustZone> = table.read(key, findings)?;
    Some(zone.map(|zone| match zone {
        ThrustZone::MiddleThird => 1.0 / 3.0,
        ThrustZone::MiddleHalf => 0.5,
    }))
}

/// Whether the word for the factor of tests is written; what is wrong with the key is said where its number is read.
fn of_tests(table: &Table<'_>, _: &mut Findings) -> Option<bool> {
    let factor: Option<Option<f64>> = table.read("model_factor", &mut Findings::default());
    Some(factor.flatten().is_some_and(f64::is_infinite))
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
    let expected = Expected::of(table, findings)?;
    if expected.lower >= expected.upper {
        let help = "write the lower end first";
        return findings.refuse("B107", table.place("lower"), "the expected range is empty", "lower end", help);
    }
    Some(expected)
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
