//! Stress over strain at each multiple of the stiffness.

use super::STYLES;
use crate::chart::{Axes, Axis, Entry, key};
use crate::sheet::{HAIR, Pen, Sheet, Spot};
use crate::ticks::Ticks;
use outcome::calibration::{CalibrationReport, Measured};

const HEIGHT: f64 = 380.0;

/// Mean curves of the table's multiples with a band of one standard deviation of the strain to either side.
pub fn stress_strain(report: &CalibrationReport) -> Option<String> {
    let rows: Vec<&Measured> = report.table.iter().filter(|m| m.curve.len() > 1).collect();
    let points = || rows.iter().flat_map(|m| m.curve.iter());
    let strain = points().map(|(p, deviation)| p.strain + deviation).fold(0.0_f64, f64::max);
    let stress = points().map(|(p, _)| p.stress).fold(0.0_f64, f64::max);
    if !(strain > 0.0 && strain.is_finite() && stress > 0.0) {
        return None;
    }
    let mut sheet = Sheet::new("stress-strain");
    let second = format!(
        "Stress over strain of confined squares of fill; mean of {} squares and one standard deviation",
        report.squares
    );
    let top = sheet.title(&report.bridge, &second);
    let x = Axis::round("strain since the block rested by itself [per mille]", Ticks::over(0.0, 1e3 * strain, 7));
    let y = Axis::round("mean stress under the block [kPa]", Ticks::over(0.0, 1e-3 * stress, 6));
    let (axes, mut bottom) = Axes::draw(&mut sheet, top, HEIGHT, &x, &y);
    let spot = |strain: f64, stress: f64| axes.spot(1e3 * strain, 1e-3 * stress);
    sheet.open_clipped("bands", "plane", axes.area);
    for (k, m) in rows.iter().enumerate() {
        let (colour, _) = STYLES[k % STYLES.len()];
        let side = |sign: f64| m.curve.iter().map(move |(p, d)| (p.strain + sign * d, p.stress));
        let band: Vec<Spot> = side(1.0).chain(side(-1.0).rev()).map(|(strain, stress)| spot(strain, stress)).collect();
        sheet.polygon(&band, Pen::shape(&pale(colour), "none", 0.0).class("band"));
    }
    // Bands lie over one another: their edges show through.
    for (k, m) in rows.iter().enumerate() {
        for sign in [-1.0, 1.0] {
            let edge: Vec<Spot> = m.curve.iter().map(|(p, d)| spot(p.strain + sign * d, p.stress)).collect();
            sheet.polyline(&edge, Pen::line(STYLES[k % STYLES.len()].0, HAIR).class("edge"));
        }
    }
    sheet.close();
    sheet.open_clipped("curves", "plane-curves", axes.area);
    for (k, m) in rows.iter().enumerate() {
        let (colour, dashes) = STYLES[k % STYLES.len()];
        let line: Vec<Spot> = m.curve.iter().map(|(p, _)| spot(p.strain, p.stress)).collect();
        sheet.polyline(&line, Pen::line(colour, 1.8).dashed(dashes).class("curve"));
        for &at in &line {
            sheet.circle(at, 2.2, Pen::shape(colour, "none", 0.0));
        }
    }
    sheet.close();
    let words: Vec<String> = rows.iter().map(|m| label(report, m)).collect();
    let entry = |k: usize| Entry { line: Some(STYLES[k % STYLES.len()]), mark: None, text: &words[k] };
    let entries: Vec<Entry> = (0..rows.len()).map(entry).collect();
    bottom = key(&mut sheet, bottom, &entries);
    Some(sheet.finish(bottom))
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
