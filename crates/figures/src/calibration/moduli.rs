//! Moduli over the multiple of the stiffness.

use super::STYLES;
use crate::chart::{Axis, Chart, Entry, Mark, Panel, PanelPoint};
use crate::elevation::INK;
use crate::sheet::{MEDIUM, Pen};
use crate::ticks::Ticks;
use crate::words;
use outcome::calibration::{At, CalibrationReport, Measured, Spread};

/// Mean moduli with bars of two standard errors to either side, moduli from elsewhere, the wanted modulus and what was
/// found for it.
pub(super) fn moduli(report: &CalibrationReport) -> Option<String> {
    let mut rows: Vec<&Measured> = report.table.iter().chain(report.found_beside_the_table()).collect();
    rows.sort_by(|a, b| a.multiple.total_cmp(&b.multiple));
    type Kind = (&'static str, fn(&Measured) -> Option<Spread>);
    let kinds: [Kind; 3] = [
        ("mean tangent", |m| m.tangent),
        ("secant", |m| m.secant),
        ("secant without the first steps", |m| m.late_secant),
    ];
    let compared: Vec<At> = report
        .table
        .iter()
        .zip(&report.plan.compare_with)
        .map(|(m, &modulus)| At { multiple: m.multiple, modulus })
        .collect();
    let upper = |m: &Measured| {
        kinds.iter().filter_map(|k| (k.1)(m)).map(|s| s.mean + 2.0 * s.standard_error).fold(0.0, f64::max)
    };
    let high = rows.iter().map(|m| upper(m)).chain(compared.iter().map(|at| at.modulus)).fold(0.0, f64::max);
    let wide = rows.iter().map(|m| m.multiple).fold(0.0, f64::max);
    if !(high > 0.0 && high.is_finite() && wide > 0.0) {
        return None;
    }
    let high = high.max(report.plan.wanted_modulus.unwrap_or(0.0));
    let x_name =
        format!("multiple of the contact stiffness of the file, {:.3} GPa/m normal", report.stiffness[0] / 1e9);
    let x = Axis::round(&x_name, Ticks::over(0.0, 1.04 * wide, 8));
    let mut panel = Panel::new(x, Axis::round("modulus [MPa]", Ticks::over(0.0, high / 1e6, 7)));
    let mut entries: Vec<Entry> = Vec::new();
    panel.clip("moduli", "plane");
    for (k, (name, of)) in kinds.iter().enumerate() {
        let (colour, dashes) = STYLES[k];
        let points: Vec<(f64, Spread)> = rows.iter().filter_map(|m| Some((m.multiple, of(m)?))).collect();
        let line: Vec<PanelPoint> = points.iter().map(|(m, s)| [*m, s.mean / 1e6]).collect();
        panel.curve(line, Pen::line(colour, 1.8).dashed(dashes).class("modulus"));
        panel.add(move |sheet, axes| {
            for (multiple, s) in &points {
                let end = |sign: f64| {
                    let [at, y] = axes.spot([*multiple, (s.mean + sign * 2.0 * s.standard_error) / 1e6]);
                    // Bars of different kinds stand beside one another.
                    [at + 3.0 * (k as f64 - 1.0), y]
                };
                sheet.line(end(-1.0), end(1.0), Pen::line(colour, MEDIUM).class("error"));
            }
        });
        entries.push(Entry::line(STYLES[k], *name));
    }
    panel.close();
    for at in &compared {
        panel.mark([at.multiple, at.modulus / 1e6], Mark::Hollow, INK);
    }
    let which = format!("{}, given for comparison", report.plan.modulus.word());
    entries.push(Entry::mark(Mark::Hollow, INK, which).when(!compared.is_empty()));
    let found = report.found.as_ref().and_then(|m| m.at(report.plan.modulus));
    if let (Some(wanted), Some(at)) = (report.plan.wanted_modulus, found) {
        let pen = Pen::line(INK, 0.9).dashed("5 4").class("wanted");
        panel.curve([0.0, at.multiple].map(|multiple| [multiple, wanted / 1e6]), pen);
        panel.line([wanted / 1e6, 0.0].map(|modulus| [at.multiple, modulus]), pen);
        let place = [at.multiple, at.modulus / 1e6];
        panel.mark(place, Mark::Ring, INK);
        let normal = at.multiple * report.stiffness[0] / 1e9;
        let text = format!("{:.0} MPa at {} times, {normal:.3} GPa/m", wanted / 1e6, words::three_digits(at.multiple));
        panel.label(place, text, [0.9, 0.4], 13.0);
    }
    let mut chart = Chart::of(panel, 380.0);
    chart.key = entries;
    chart.words.push(format!(
        "Bars: two standard errors of the mean to either side, {} squares out of {}.",
        report.squares,
        report.packings()
    ));
    Some(chart.draw("moduli", &report.bridge, "Modulus of confined fill over the stiffness of its contacts"))
}
