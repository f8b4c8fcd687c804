//! `extrados.calibrate-fill/1`, and its tables.

use super::tables::row;
use crate::calibration::{At, CalibrationReport, Measured, Sheared, Spread};
use serde::Serialize;

/// The result of a calibration of fill. Status, warnings and times are those of the command.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CalibrationObject {
    bridge: String,
    /// Stiffness with the wanted modulus; that of the file where none is wanted.
    contact_normal_stiffness_gpa_per_m: Option<f64>,
    contact_shear_stiffness_gpa_per_m: Option<f64>,
    multiple: Option<f64>,
    multiple_standard_error: Option<f64>,
    wanted_modulus_mpa: Option<f64>,
    matched: &'static str,
    tangent_modulus_mpa: Option<f64>,
    tangent_standard_error_mpa: Option<f64>,
    secant_modulus_mpa: Option<f64>,
    secant_standard_error_mpa: Option<f64>,
    check_modulus_mpa: Option<f64>,
    check_standard_error_mpa: Option<f64>,
    check_seeds: Vec<u64>,
    reach: Option<[Reach; 2]>,
    curve: Vec<Point>,
    particles: usize,
    samples: usize,
    seeds: Vec<u64>,
    mean_diameter_m: f64,
    solid_fraction: f64,
    cut_particles: usize,
    replaced_particles: usize,
    first_normal_stiffness_gpa_per_m: f64,
    first_shear_stiffness_gpa_per_m: f64,
    moduli: Vec<Row>,
    strength: Option<StrengthObject>,
    iterations_total: u64,
}

/// Contacts for a wanted strength of the fill, and the strength of the fill with them.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct StrengthObject {
    wanted_friction_angle_deg: Option<f64>,
    wanted_cohesion_kpa: Option<f64>,
    reached: bool,
    contact_friction_angle_deg: f64,
    contact_cohesion_kpa: f64,
    friction_angle_deg: Scatter,
    cohesion_kpa: Scatter,
    check_friction_angle_deg: Option<Scatter>,
    check_cohesion_kpa: Option<Scatter>,
    peaks: Vec<Peak>,
    samples_left_out: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Peak {
    confining_pressure_kpa: f64,
    peak_stress_kpa: f64,
}

impl StrengthObject {
    fn new(sheared: &Sheared) -> StrengthObject {
        let Sheared { wanted, found, reached, check } = sheared;
        let degrees = |s: &Spread| times(*s, std::f64::consts::PI / 180.0);
        let kilo = |s: &Spread| times(*s, 1e3);
        StrengthObject {
            wanted_friction_angle_deg: wanted.friction_angle.map(f64::to_degrees),
            wanted_cohesion_kpa: wanted.cohesion.map(|c| c / 1e3),
            reached: *reached,
            contact_friction_angle_deg: found.contact.friction_angle.to_degrees(),
            contact_cohesion_kpa: found.contact.cohesion / 1e3,
            friction_angle_deg: degrees(&found.friction_angle),
            cohesion_kpa: kilo(&found.cohesion),
            check_friction_angle_deg: check.as_ref().map(|s| degrees(&s.friction_angle)),
            check_cohesion_kpa: check.as_ref().map(|s| kilo(&s.cohesion)),
            peaks: found
                .peaks
                .iter()
                .map(|[pressure, peak]| Peak { confining_pressure_kpa: pressure / 1e3, peak_stress_kpa: peak / 1e3 })
                .collect(),
            samples_left_out: found.left_out,
        }
    }
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Reach {
    multiple: f64,
    modulus_mpa: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Point {
    stress_kpa: f64,
    strain: f64,
    strain_standard_deviation: f64,
    displacement_mm: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Row {
    multiple: f64,
    contact_normal_stiffness_gpa_per_m: f64,
    contact_shear_stiffness_gpa_per_m: f64,
    tangent_mpa: Option<Scatter>,
    least_squares_mpa: Option<Scatter>,
    secant_mpa: Option<Scatter>,
    late_secant_mpa: Option<Scatter>,
    compare_with_mpa: Option<f64>,
    samples_left_out: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Scatter {
    mean: f64,
    standard_deviation: f64,
    standard_error: f64,
    samples: usize,
}

impl CalibrationObject {
    /// The object for a report.
    pub fn new(report: &CalibrationReport) -> CalibrationObject {
        let shown = report.shown();
        let stiffness = |k: usize, multiple: f64| multiple * report.stiffness[k] / 1e9;
        let spread = |of: fn(&Measured) -> Option<Spread>| shown.and_then(of).map(mega);
        let (tangent, secant) = (spread(|m| m.tangent), spread(|m| m.secant));
        let check = report.check.as_ref().and_then(|check| report.compared(&check.measured)).map(mega);
        let reach = |at: &At| Reach { multiple: at.multiple, modulus_mpa: at.modulus / 1e6 };
        let all = report.table.iter().chain(report.found_beside_the_table());
        let checked = report.check.iter().map(|check| &check.measured);
        CalibrationObject {
            bridge: report.bridge.clone(),
            contact_normal_stiffness_gpa_per_m: shown.map(|m| stiffness(0, m.multiple)),
            contact_shear_stiffness_gpa_per_m: shown.map(|m| stiffness(1, m.multiple)),
            multiple: shown.map(|m| m.multiple),
            multiple_standard_error: report.multiple_error(),
            wanted_modulus_mpa: report.plan.wanted_modulus.map(|m| m / 1e6),
            matched: report.matched(),
            tangent_modulus_mpa: tangent.as_ref().map(|s| s.mean),
            tangent_standard_error_mpa: tangent.as_ref().map(|s| s.standard_error),
            secant_modulus_mpa: secant.as_ref().map(|s| s.mean),
            secant_standard_error_mpa: secant.as_ref().map(|s| s.standard_error),
            check_modulus_mpa: check.as_ref().map(|s| s.mean),
            check_standard_error_mpa: check.as_ref().map(|s| s.standard_error),
            check_seeds: report.check.iter().flat_map(|check| check.seeds.iter().copied()).collect(),
            reach: report.reach.as_ref().map(|both| [reach(&both[0]), reach(&both[1])]),
            curve: shown.map(curve).unwrap_or_default(),
            particles: report.particles,
            samples: report.squares,
            seeds: report.seeds.clone(),
            mean_diameter_m: report.mean_diameter,
            solid_fraction: report.solid_fraction,
            cut_particles: report.cut,
            replaced_particles: report.replaced,
            first_normal_stiffness_gpa_per_m: report.stiffness[0] / 1e9,
            first_shear_stiffness_gpa_per_m: report.stiffness[1] / 1e9,
            moduli: report.table.iter().enumerate().map(|(k, m)| modulus_row(report, k, m)).collect(),
            strength: report.strength.as_ref().map(StrengthObject::new),
            iterations_total: all.chain(checked).map(|m| m.iterations).sum(),
        }
    }
}

fn modulus_row(report: &CalibrationReport, k: usize, m: &Measured) -> Row {
    Row {
        multiple: m.multiple,
        contact_normal_stiffness_gpa_per_m: m.multiple * report.stiffness[0] / 1e9,
        contact_shear_stiffness_gpa_per_m: m.multiple * report.stiffness[1] / 1e9,
        tangent_mpa: m.tangent.map(mega),
        least_squares_mpa: m.least_squares.map(mega),
        secant_mpa: m.secant.map(mega),
        late_secant_mpa: m.late_secant.map(mega),
        compare_with_mpa: report.plan.compare_with.get(k).map(|m| m / 1e6),
        samples_left_out: m.left_out,
    }
}

fn curve(m: &Measured) -> Vec<Point> {
    let point = |(p, deviation): &(crate::calibration::CurvePoint, f64)| Point {
        stress_kpa: p.stress / 1e3,
        strain: p.strain,
        strain_standard_deviation: *deviation,
        displacement_mm: p.displacement * 1e3,
    };
    m.curve.iter().map(point).collect()
}

/// Pa in MPa.
fn mega(s: Spread) -> Scatter {
    times(s, 1e6)
}

fn times(s: Spread, unit: f64) -> Scatter {
    Scatter {
        mean: s.mean / unit,
        standard_deviation: s.standard_deviation / unit,
        standard_error: s.standard_error / unit,
        samples: s.count,
    }
}

/// Every load step of every sample: those of the table, of the multiple found, and of the check.
pub fn calibration_curves(report: &CalibrationReport) -> String {
    let mut csv = String::from("multiple,seed,square,step,stress_kpa,strain,displacement_mm\n");
    let checked = report.check.iter().map(|check| &check.measured);
    for m in report.table.iter().chain(report.found_beside_the_table()).chain(checked) {
        for (seed, square, curve) in &m.samples {
            for (step, p) in curve.points.iter().enumerate() {
                let (stress, sunk) = (p.stress / 1e3, p.displacement * 1e3);
                row(&mut csv, format_args!("{},{seed},{square},{step},{stress},{},{sunk}", m.multiple, p.strain));
            }
        }
    }
    csv
}

/// Means and scatter at every multiple.
pub fn calibration_moduli(report: &CalibrationReport) -> String {
    let kinds = ["tangent", "least_squares", "secant", "late_secant"];
    let mut csv = String::from("multiple,normal_stiffness_gpa_per_m,shear_stiffness_gpa_per_m");
    for kind in kinds {
        csv += &format!(",{kind}_mpa,{kind}_standard_deviation_mpa,{kind}_standard_error_mpa");
    }
    csv += ",samples,samples_left_out,packings\n";
    let own = report.table.iter().chain(report.found_beside_the_table()).map(|m| (m, "own"));
    for (m, packings) in own.chain(report.check.iter().map(|check| (&check.measured, "check"))) {
        let mut line = format!(
            "{},{},{}",
            m.multiple,
            m.multiple * report.stiffness[0] / 1e9,
            m.multiple * report.stiffness[1] / 1e9
        );
        for spread in [m.tangent, m.least_squares, m.secant, m.late_secant] {
            line += &spread.map_or(",,,".to_owned(), |s| {
                let s = mega(s);
                format!(",{},{},{}", s.mean, s.standard_deviation, s.standard_error)
            });
        }
        row(&mut csv, format_args!("{line},{},{},{packings}", m.samples.len() - m.left_out, m.left_out));
    }
    csv
}
