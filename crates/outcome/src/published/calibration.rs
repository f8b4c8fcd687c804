//! Tables of `extrados.calibrate-fill/1`.

use super::rows::{each, row};
use crate::calibration::CalibrationReport;

/// Every load step of every sample: those of the table, of the multiple found, and of the check.
pub fn calibration_curves(report: &CalibrationReport) -> String {
    let mut csv = String::from("multiple,seed,square,step,stress_kpa,strain,displacement_mm\n");
    for m in report.measured() {
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
        let spreads = [m.tangent, m.least_squares, m.secant, m.late_secant].map(|spread| {
            each(spread.map(|s| [s.mean, s.standard_deviation, s.standard_error].map(|value| value / 1e6)))
        });
        row!(&mut csv, m.multiple, stiffness, spreads, m.samples.len() - m.left_out, m.left_out, packings);
    }
    csv
}
