//! A sample as it was cut out, and in the press.

use crate::elevation::{INK, LOAD};
use crate::geometry::{Extent, View};
use crate::sheet::{Anchor, HAIR, MARGIN, MEDIUM, Pen, Sheet, Style, THIN, WIDTH};
use outcome::calibration::{AtRest, CalibrationReport, Drawn};

/// Colour of particles, and of those that replace others.
const GRAIN: &str = "#ece0c8";
const REPLACEMENT: &str = "#9fc3e6";
const GONE: &str = "#a8a8a8";
const WALL: &str = "#c9c9c9";

/// Three panels: the square with the particles that the cut went through, the press under its block alone, and after the
/// last load step.
pub(super) fn sample(report: &CalibrationReport) -> Option<String> {
    let drawn = report.drawn.as_ref()?;
    let (seed, square) = drawn.name;
    let second =
        format!("A square of {:.2} m out of the fill: packing of seed {seed}, square {}", drawn.size, square + 1);
    let (mut sheet, top) = Sheet::titled("sample", &report.bridge, &second);
    let panel = (WIDTH - 2.0 * MARGIN) / 3.0;
    // Each panel shows the square with a fifth of its side around it, and the block above.
    let scale = panel / (1.44 * drawn.size);
    let floor = top + 26.0 + scale * 1.42 * drawn.size;
    let head = Style::small().anchored(Anchor::Middle);
    let titles = [
        "as cut".to_owned(),
        format!("{:.1} kPa, the block alone", drawn.pressed[0].1 / 1e3),
        format!("{:.0} kPa", drawn.pressed[1].1 / 1e3),
    ];
    let kept = drawn.particles.len() - drawn.cuts.iter().filter(|cut| cut.replaced).count();
    for (k, title) in titles.iter().enumerate() {
        let left = MARGIN + k as f64 * panel + 0.22 * scale * drawn.size;
        let view = View { scale, origin: [left, floor] };
        sheet.text([left + 0.5 * scale * drawn.size, top + 14.0], title, head);
        sheet.open("panel");
        match k.checked_sub(1) {
            None => cut(&mut sheet, &view, drawn, kept),
            Some(state) => pressed(&mut sheet, &view, drawn.size, &drawn.pressed[state], kept),
        }
        sheet.close();
    }
    let bottom = floor + 0.24 * scale * drawn.size + 4.0;
    let replaced = drawn.cuts.iter().filter(|cut| cut.replaced).count();
    let caption = format!(
        "{kept} particles lie inside. The cut goes through {} (dashed), {replaced} of which smaller ones (blue) replace.",
        drawn.cuts.len()
    );
    Some(sheet.end(bottom, &caption))
}

fn grains(sheet: &mut Sheet, view: &View, particles: &[[f64; 3]], kept: usize) {
    for (k, &[x, y, radius]) in particles.iter().enumerate() {
        let fill = if k < kept { GRAIN } else { REPLACEMENT };
        sheet.circle(view.spot([x, y]), view.scale * radius, Pen::shape(fill, INK, THIN).class("grain"));
    }
}

fn cut(sheet: &mut Sheet, view: &View, drawn: &Drawn, kept: usize) {
    for cut in &drawn.cuts {
        let pen = Pen::line(GONE, HAIR).dashed("3 2").class("cut");
        sheet.circle(view.spot(cut.centre), view.scale * cut.radius, pen);
    }
    grains(sheet, view, &drawn.particles, kept);
    sheet.rectangle(view.area(Extent { low: [0.0; 2], high: [drawn.size; 2] }), Pen::line(LOAD, MEDIUM));
}

fn pressed(sheet: &mut Sheet, view: &View, size: f64, (state, stress): &(AtRest, f64), kept: usize) {
    let (thick, side) = (0.1 * size, 1.2 * size);
    let walls = [
        Extent { low: [0.0, -thick], high: [size, 0.0] },
        Extent { low: [-thick, -thick], high: [0.0, side] },
        Extent { low: [size, -thick], high: [size + thick, side] },
    ];
    for wall in walls {
        sheet.rectangle(view.area(wall), Pen::shape(WALL, INK, THIN).class("support"));
    }
    grains(sheet, view, &state.particles, kept);
    let block = Extent { low: [0.005 * size, state.block], high: [0.995 * size, state.block + 0.15 * size] };
    sheet.rectangle(view.area(block), Pen::shape("#f2e8d5", INK, THIN).class("block"));
    let [x, y] = view.spot([0.5 * size, state.block + 0.15 * size]);
    let long = 0.12 * size * view.scale;
    if *stress > 1e4 {
        for k in [-2.0, -1.0, 0.0, 1.0, 2.0] {
            let at = x + 0.19 * k * size * view.scale;
            sheet.arrow([at, y - long], [at, y - 1.0], Pen::line(LOAD, MEDIUM).class("load"));
        }
    }
}
