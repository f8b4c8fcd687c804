//! The calibration of fill particles.

use super::materials::maybe;
use crate::findings::Findings;
use crate::model::{Calibration, Modulus};
use crate::tree::Table;

/// The calibration; every key has a default.
pub(super) fn calibration(file: &Table<'_>, findings: &mut Findings) -> Option<Calibration> {
    let usual = Calibration::default();
    if !file.has("calibration") {
        return Some(usual);
    }
    let table = file.table("calibration", findings)?;
    let mut quantity = |key| {
        let value = table.quantity(key, findings);
        maybe(&table, key, value)
    };
    let wanted_modulus = quantity("wanted_modulus");
    let (sample_size, block_weight, load_step) =
        (quantity("sample_size"), quantity("block_weight"), quantity("load_step"));
    let (wanted_friction_angle, wanted_cohesion) = (quantity("wanted_friction_angle"), quantity("wanted_cohesion"));
    let modulus = table.word("modulus", findings);
    let mut count = |key| {
        let value = table.count(key, findings);
        maybe(&table, key, value)
    };
    let (steps, ignored_steps, seeds) = (count("steps"), count("ignored_steps"), count("seeds"));
    let sheared_samples = count("sheared_samples");
    let mut number = |key| {
        let value = table.number(key, findings);
        maybe(&table, key, value)
    };
    let (tolerance, least_replacement) = (number("tolerance"), number("least_replacement"));
    let multiples = table.numbers("multiples", findings);
    let compare_with = table.quantities("compare_with", findings);
    let confining_pressures = table.quantities("confining_pressures", findings);
    let calibration = Calibration {
        wanted_modulus: wanted_modulus?,
        modulus: match maybe(&table, "modulus", modulus)? {
            Some("secant") => Modulus::Secant,
            _ => Modulus::Tangent,
        },
        sample_size: sample_size?.unwrap_or(usual.sample_size),
        block_weight: block_weight?.unwrap_or(usual.block_weight),
        load_step: load_step?.unwrap_or(usual.load_step),
        steps: steps?.map_or(usual.steps, |n| n as usize),
        ignored_steps: ignored_steps?.map_or(usual.ignored_steps, |n| n as usize),
        multiples: maybe(&table, "multiples", multiples)?.unwrap_or(usual.multiples),
        compare_with: maybe(&table, "compare_with", compare_with)?.unwrap_or_default(),
        seeds: seeds?.unwrap_or(usual.seeds),
        tolerance: tolerance?.unwrap_or(usual.tolerance),
        least_replacement: least_replacement?.unwrap_or(usual.least_replacement),
        wanted_friction_angle: wanted_friction_angle?,
        wanted_cohesion: wanted_cohesion?,
        confining_pressures: maybe(&table, "confining_pressures", confining_pressures)?
            .unwrap_or(usual.confining_pressures),
        sheared_samples: sheared_samples?.map_or(usual.sheared_samples, |n| n as usize),
    };
    let fits = check(&table, &calibration, findings);
    fits.then_some(calibration)
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
