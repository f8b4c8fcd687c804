//! Figures of a calibration of fill.

use assess::analysis::calibrate::CalibrationReport;

/// All figures that the report has material for: name without extension, and drawing.
pub fn calibration(_report: &CalibrationReport) -> Vec<(String, String)> {
    Vec::new()
}
