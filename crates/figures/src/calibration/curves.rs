//! Stress over strain at each multiple of the stiffness.

use super::STYLES;
use crate::chart::{Axis, Chart, Entry, Panel, PanelPoint};
use crate::sheet::{HAIR, Pen};
use crate::ticks::Ticks;
use outcome::calibration::{CalibrationReport, Measured};

/// Mean curves of the table's multiples with a band of one standard deviation of the strain to either side.
pub(super) fn stress_strain(report: &CalibrationReport) -> Option<String> {
    let rows: Vec<&Measured> = report.table.iter().filter(|m| m.curve.len() > 1).collect();
    let points = || rows.iter().flat_map(|m| m.curve.iter());
    let strain = points().map(|(p, deviation)| p.strain + deviation).fold(0.0_f64, f64::max);
    let stress = points().map(|(p, _)| p.stress).fold(0.0_f64, f64::max);
    if !(strain > 0.0 && strain.is_finite() && stress > 0.0) {
        return None;
    }
    let x = Axis::round("strain since the block rested by itself [per mille]", Ticks::over(0.0, 1e3 * strain, 7));
    let y = Axis::round("mean stress under the block [kPa]", Ticks::over(0.0, 1e-3 * stress, 6));
    let styles = || rows.iter().zip(STYLES.iter().cycle());
    let pales: Vec<String> = styles().map(|(_, (colour, _))| pale(colour)).collect();
    // The curve, moved by so many standard deviations of its strain.
    let line = |m: &Measured, by: f64| -> Vec<PanelPoint> {
        m.curve.iter().map(|(p, deviation)| [1e3 * (p.strain + by * deviation), 1e-3 * p.stress]).collect()
    };
    let mut panel = Panel::new(x, y);
    panel.clip("bands", "plane");
    for (m, pale) in rows.iter().zip(&pales) {
        let band: Vec<PanelPoint> = line(m, 1.0).into_iter().chain(line(m, -1.0).into_iter().rev()).collect();
        panel.area(band, Pen::shape(pale, "none", 0.0).class("band"));
    }
    // Bands lie over one another: their edges show through.
    for (m, (colour, _)) in styles() {
        for by in [-1.0, 1.0] {
            panel.line(line(m, by), Pen::line(colour, HAIR).class("edge"));
        }
    }
    panel.close();
    panel.clip("curves", "plane-curves");
    for (m, (colour, dashes)) in styles() {
        panel.line(line(m, 0.0), Pen::line(colour, 1.8).dashed(dashes).class("curve"));
        panel.circles(line(m, 0.0), 2.2, Pen::shape(colour, "none", 0.0));
    }
    panel.close();
    let mut chart = Chart::of(panel, 380.0);
    chart.key = styles().map(|(m, style)| Entry::line(*style, label(report, m))).collect();
    let second = format!(
        "Stress over strain of confined squares of fill; mean of {} squares and one standard deviation",
        report.squares
    );
    Some(chart.draw("stress-strain", &report.bridge, &second))
}

fn label(report: &CalibrationReport, m: &Measured) -> String {
    format!("{} × ({:.3} GPa/m)", crate::words::three_digits(m.multiple), m.multiple * report.stiffness[0] / 1e9)
}

/// A colour mixed with much white: bands lie over one another.
fn pale(colour: &str) -> String {
    let part = |k: usize| u8::from_str_radix(colour.get(k..k + 2).unwrap_or("00"), 16).unwrap_or(0);
    let mix = |c: u8| (f64::from(c) * 0.18 + 255.0 * 0.82).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(part(1)), mix(part(3)), mix(part(5)))
}
