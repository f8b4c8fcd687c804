//! `extrados.calibrate-fill/1`, and its tables.

use super::{Object, each, kilo, list, object, row};
use crate::calibration::{At, CalibrationReport, Measured, Sheared, Spread};

/// The result of a calibration of fill; its status is that of the command. The stiffness is that with the wanted modulus, and
/// that of the file where none is wanted.
pub fn calibration(report: &CalibrationReport) -> Object {
    let shown = report.shown();
    let stiffness = |k: usize| shown.map(|m| m.multiple * report.stiffness[k] / 1e9);
    let spread = |of: fn(&Measured) -> Option<Spread>| shown.and_then(of).map(mega);
    let (tangent, secant) = (spread(|m| m.tangent), spread(|m| m.secant));
    let check = report.check.as_ref().and_then(|check| report.compared(&check.measured)).map(mega);
    let [mean, error] = [|s: Spread| s.mean, |s: Spread| s.standard_error];
    let reach = |at: At| object! { multiple: at.multiple, modulus_mpa: at.modulus / 1e6, };
    let all = report.table.iter().chain(report.found_beside_the_table());
    let checked = report.check.iter().map(|check| &check.measured);
    object! {
        bridge: report.bridge,
        contact_normal_stiffness_gpa_per_m: stiffness(0),
        contact_shear_stiffness_gpa_per_m: stiffness(1),
        multiple: shown.map(|m| m.multiple),
        multiple_standard_error: report.multiple_error(),
        wanted_modulus_mpa: report.plan.wanted_modulus.map(|m| m / 1e6),
        matched: report.matched(),
        tangent_modulus_mpa: tangent.map(mean),
        tangent_standard_error_mpa: tangent.map(error),
        secant_modulus_mpa: secant.map(mean),
        secant_standard_error_mpa: secant.map(error),
        check_modulus_mpa: check.map(mean),
        check_standard_error_mpa: check.map(error),
        check_seeds: report.check.as_ref().map_or(&[][..], |check| &check.seeds),
        reach: report.reach.map(|both| both.map(reach)),
        curve: shown.map_or_else(Vec::new, |m| list(&m.curve, |(p, deviation)| object! {
            stress_kpa: p.stress / 1e3,
            strain: p.strain,
            strain_standard_deviation: deviation,
            displacement_mm: p.displacement * 1e3,
        })),
        particles: report.particles,
        samples: report.squares,
        seeds: report.seeds,
        mean_diameter_m: report.mean_diameter,
        solid_fraction: report.solid_fraction,
        cut_particles: report.cut,
        replaced_particles: report.replaced,
        first_normal_stiffness_gpa_per_m: report.stiffness[0] / 1e9,
        first_shear_stiffness_gpa_per_m: report.stiffness[1] / 1e9,
        moduli: list(report.table.iter().enumerate(), |(k, m)| object! {
            multiple: m.multiple,
            contact_normal_stiffness_gpa_per_m: m.multiple * report.stiffness[0] / 1e9,
            contact_shear_stiffness_gpa_per_m: m.multiple * report.stiffness[1] / 1e9,
            tangent_mpa: m.tangent.map(mega).map(scatter),
            least_squares_mpa: m.least_squares.map(mega).map(scatter),
            secant_mpa: m.secant.map(mega).map(scatter),
            late_secant_mpa: m.late_secant.map(mega).map(scatter),
            compare_with_mpa: report.plan.compare_with.get(k).map(|m| m / 1e6),
            samples_left_out: m.left_out,
        }),
        strength: report.strength.as_ref().map(strength),
        iterations_total: all.chain(checked).map(|m| m.iterations).sum::<u64>(),
    }
}

/// Contacts for a wanted strength of the fill, and the strength of the fill with them.
fn strength(sheared: &Sheared) -> Object {
    let Sheared { wanted, found, reached, check } = sheared;
    let degrees = |s: Spread| scatter(over(s, std::f64::consts::PI / 180.0));
    let kilos = |s: Spread| scatter(over(s, 1e3));
    object! {
        wanted_friction_angle_deg: wanted.friction_angle.map(f64::to_degrees),
        wanted_cohesion_kpa: wanted.cohesion.map(kilo),
        reached: reached,
        contact_friction_angle_deg: found.contact.friction_angle.to_degrees(),
        contact_cohesion_kpa: kilo(found.contact.cohesion),
        friction_angle_deg: degrees(found.friction_angle),
        cohesion_kpa: kilos(found.cohesion),
        check_friction_angle_deg: check.as_ref().map(|s| degrees(s.friction_angle)),
        check_cohesion_kpa: check.as_ref().map(|s| kilos(s.cohesion)),
        peaks: list(&found.peaks, |[pressure, peak]| object! {
            confining_pressure_kpa: pressure / 1e3,
            peak_stress_kpa: peak / 1e3,
        }),
        samples_left_out: found.left_out,
    }
}

fn scatter(s: Spread) -> Object {
    object! {
        mean: s.mean,
        standard_deviation: s.standard_deviation,
        standard_error: s.standard_error,
        samples: s.count,
    }
}

/// Pa in MPa.
fn mega(s: Spread) -> Spread {
    over(s, 1e6)
}

fn over(s: Spread, unit: f64) -> Spread {
    Spread {
        mean: s.mean / unit,
        standard_deviation: s.standard_deviation / unit,
        standard_error: s.standard_error / unit,
        ..s
    }
}

/// Every load step of every sample: those of the table, of the multiple found, and of the check.
pub fn calibration_curves(report: &CalibrationReport) -> String {
    let mut csv = String::from("multiple,seed,square,step,stress_kpa,strain,displacement_mm\n");
    let checked = report.check.iter().map(|check| &check.measured);
    for m in report.table.iter().chain(report.found_beside_the_table()).chain(checked) {
        for (seed, square, curve) in &m.samples {
            for (step, p) in curve.points.iter().enumerate() {
                row!(&mut csv, m.multiple, seed, square, step, p.stress / 1e3, p.strain, p.displacement * 1e3);
            }
        }
    }
    csv
}

/// Means and scatter at every multiple.
pub fn calibration_moduli(report: &CalibrationReport) -> String {
    let mut csv = String::from("multiple,normal_stiffness_gpa_per_m,shear_stiffness_gpa_per_m");
    for kind in ["tangent", "least_squares", "secant", "late_secant"] {
        csv += &format!(",{kind}_mpa,{kind}_standard_deviation_mpa,{kind}_standard_error_mpa");
    }
    csv += ",samples,samples_left_out,packings\n";
    let own = report.table.iter().chain(report.found_beside_the_table()).map(|m| (m, "own"));
    for (m, packings) in own.chain(report.check.iter().map(|check| (&check.measured, "check"))) {
        let stiffness = report.stiffness.map(|k| m.multiple * k / 1e9);
        let spreads = [m.tangent, m.least_squares, m.secant, m.late_secant]
            .map(|spread| each(spread.map(mega).map(|s| [s.mean, s.standard_deviation, s.standard_error])));
        row!(&mut csv, m.multiple, stiffness, spreads, m.samples.len() - m.left_out, m.left_out, packings);
    }
    csv
}
