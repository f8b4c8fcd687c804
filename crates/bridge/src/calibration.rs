//! The calibration of fill particles.

use crate::card::Section;
use crate::cards::*;
use crate::choice::choice;
use crate::findings::Findings;
use crate::tree::Table;
use crate::values::of_keys;
use serde::{Deserialize, Serialize};

of_keys! {
    /// How the contact stiffness of particles is found from a wanted modulus of the fill: squares are cut out of the fill at
    /// rest, held below and at both sides, and pressed by a block. Rouxinol, Providência and Lemos, section 3.1.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Calibration {
        pub wanted_modulus: Option<f64> = stress("modulus that the fill is to have", "40 MPa")
            .positive()
            .optional("the moduli of `multiples` are measured, without a search"),
        pub modulus: Modulus = word::<Modulus>("which modulus is compared with `wanted_modulus`", "tangent")
            .default(Modulus::Tangent.word()),
        pub sample_size: f64 = length("side of the square samples", "1 m").positive().default("1 m"),
        pub block_weight: f64 =
            load_per_metre("weight of the block that presses, per metre", "2.6 kN/m").positive().default("2.6 kN/m"),
        pub load_step: f64 =
            load_per_metre("load increment on that block, per metre", "25 kN/m").positive().default("25 kN/m"),
        pub steps: usize = count("number of load steps", "10").between(2.0, 1000.0).default("10"),
        pub ignored_steps: usize =
            count("first load steps that the later secant leaves out", "4").between(0.0, 999.0).default("4"),
        pub multiples: Vec<f64> =
            numbers("multiples of the stiffness of [particle_joint] at which moduli are measured", "[1, 2, 4, 6, 8]")
                .between(0.01, 1000.0)
                .default("[1, 2, 4, 6, 8]"),
        pub compare_with: Vec<f64> = stresses(
            "moduli from another source, one for each of `multiples`, drawn for comparison",
            r#"["22 MPa", "28 MPa", "34 MPa", "42 MPa", "48 MPa"]"#,
        )
        .positive()
        .optional("there is nothing to compare with"),
        pub seeds: u64 = count("packings from which samples are cut, and as many again for the check", "16")
            .between(1.0, 1000.0)
            .default("16"),
        pub tolerance: f64 =
            number("the wanted modulus is met within this share", "0.01").between(1e-4, 0.5).default("0.01"),
        pub least_replacement: f64 =
            number("smallest particle that replaces one on the cut, over the smallest of the packing", "0.5")
                .between(0.1, 1.0)
                .default("0.5"),
        pub wanted_friction_angle: Option<f64> = angle("friction angle that the fill is to have", "22 deg")
            .between(0.02, 1.0)
            .optional("the friction of [particle_joint] stays"),
        pub wanted_cohesion: Option<f64> = stress("cohesion that the fill is to have", "5 kPa")
            .at_least(0.0)
            .optional("the cohesion of [particle_joint] stays"),
        pub confining_pressures: Vec<f64> =
            stresses("pressures on the sides of samples that are sheared", r#"["50 kPa", "100 kPa", "200 kPa"]"#)
                .positive()
                .default(r#"["50 kPa", "100 kPa", "200 kPa"]"#),
        pub sheared_samples: usize =
            count("squares that are sheared, at each pressure", "32").between(1.0, 10000.0).default("32"),
    }
}

choice! {
    /// A modulus of a stress-strain curve.
    pub enum Modulus {
        /// mean of the slopes of all load steps
        Tangent = "tangent",
        /// slope from the first result to the last
        Secant = "secant",
    }
}

pub(crate) static CALIBRATION: Section = Section {
    path: "calibration",
    doc: "How `extrados calibrate-fill` finds the contact stiffness of fill particles: squares are cut out of the fill at rest, \
          held below and at both sides, and pressed by a block in steps. Rouxinol, Providência and Lemos, section 3.1. With a wanted \
          friction angle or cohesion, squares are sheared between smooth walls too, and friction and cohesion of the contacts are found.",
    fields: Calibration::CARDS,
};

/// The calibration; every key has a default.
pub(crate) fn calibration(file: &Table<'_>, findings: &mut Findings) -> Option<Calibration> {
    file.part("calibration", findings, |table, findings| {
        let calibration = Calibration::of(table, findings)?;
        check(table, &calibration, findings).then_some(calibration)
    })
}

/// Whether the numbers go together.
fn check(table: &Table<'_>, calibration: &Calibration, findings: &mut Findings) -> bool {
    let mut fits = true;
    let mut refuse = |key, message: String, label, help: String| {
        findings.error("B107", table.place(key), message, label, help);
        fits = false;
    };
    let Calibration { steps, ignored_steps, multiples, compare_with, .. } = calibration;
    if ignored_steps + 2 > *steps {
        refuse(
            if table.has("ignored_steps") { "ignored_steps" } else { "steps" },
            format!("of {steps} load steps {ignored_steps} are ignored, which leaves fewer than two"),
            "a secant needs two steps",
            format!("write ignored_steps = {} or fewer", steps.saturating_sub(2)),
        );
    }
    if multiples.is_empty() {
        let help = "write multiples = [1, 2, 4, 6, 8]".to_owned();
        refuse("multiples", "there is no multiple to measure a modulus at".into(), "give one at least", help);
    }
    if !compare_with.is_empty() && compare_with.len() != multiples.len() {
        refuse(
            "compare_with",
            format!("`compare_with` has {} moduli for {} multiples", compare_with.len(), multiples.len()),
            "one for each of `multiples`, in their order",
            format!("give {} moduli, or none", multiples.len()),
        );
    }
    let pressures = &calibration.confining_pressures;
    let [low, high] = [f64::min, f64::max].map(|of| pressures.iter().copied().reduce(of).unwrap_or(0.0));
    if !(high > 1.5 * low) {
        refuse(
            "confining_pressures",
            "the confining pressures lie too close together to tell friction from cohesion".into(),
            "the largest is to be more than 1.5 times the smallest",
            "write confining_pressures = [\"50 kPa\", \"100 kPa\", \"200 kPa\"]".into(),
        );
    }
    fits
}
