//! Figures of a calibration of fill: curves, moduli, and a sample in the press.

mod curves;
mod moduli;
mod sample;

use outcome::calibration::CalibrationReport;

/// All figures that the report has material for: name without extension, and drawing.
pub fn calibration(report: &CalibrationReport) -> Vec<(String, String)> {
    let optional = [
        ("stress-strain", curves::stress_strain(report)),
        ("moduli", moduli::moduli(report)),
        ("sample", sample::sample(report)),
    ];
    optional.into_iter().filter_map(|(name, svg)| Some((name.to_string(), svg?))).collect()
}

/// Line colours and dashes, told apart in grey print by their dashes.
const STYLES: [(&str, &str); 6] = [
    ("#0b5394", ""),
    ("#a02020", "9 4"),
    ("#2e6b2e", "2.5 3"),
    ("#7a6a00", "10 3 2 3"),
    ("#6a3d8a", "5 3"),
    ("#3d3d3d", "14 4"),
];
