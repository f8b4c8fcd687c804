//! A sample as it was cut out, and in the press.

use crate::elevation::{INK, LOAD};
use crate::sheet::{Anchor, Area, HAIR, MARGIN, MEDIUM, Pen, SMALL, Sheet, Spot, Style, THIN, WIDTH};
use outcome::calibration::{CalibrationReport, Confined};

/// Colour of particles, and of those that replace others.
const GRAIN: &str = "#ece0c8";
const REPLACEMENT: &str = "#9fc3e6";
const GONE: &str = "#a8a8a8";
const WALL: &str = "#c9c9c9";

/// Three panels: the square with the particles that the cut went through, the press under its block alone, and after the
/// last load step.
pub fn sample(report: &CalibrationReport) -> Option<String> {
    let drawn = report.drawn.as_ref()?;
    let mut sheet = Sheet::new("sample");
    let (seed, square) = drawn.name;
    let second =
        format!("A square of {:.2} m out of the fill: packing of seed {seed}, square {}", drawn.size, square + 1);
    let top = sheet.title(&report.bridge, &second);
    let panel = (WIDTH - 2.0 * MARGIN) / 3.0;
    // Each panel shows the square with a fifth of its side around it, and the block above.
    let scale = panel / (1.44 * drawn.size);
    let floor = top + 26.0 + scale * 1.42 * drawn.size;
    let head = Style { size: SMALL, ..Style::default() }.anchored(Anchor::Middle);
    let titles = [
        "as cut".to_owned(),
        format!("{:.1} kPa, the block alone", drawn.pressed[0].stress / 1e3),
        format!("{:.0} kPa", drawn.pressed[1].stress / 1e3),
    ];
    let kept = drawn.particles.len() - drawn.cuts.iter().filter(|cut| cut.replaced).count();
    for (k, title) in titles.iter().enumerate() {
        let left = MARGIN + k as f64 * panel + 0.22 * scale * drawn.size;
        let place = Viewport { left, floor, scale };
        sheet.text([left + 0.5 * scale * drawn.size, top + 14.0], title, head);
        sheet.open("panel");
        match k.checked_sub(1) {
            None => cut(&mut sheet, &place, report, kept),
            Some(state) => pressed(&mut sheet, &place, drawn.size, &drawn.pressed[state], kept),
        }
        sheet.close();
    }
    let bottom = floor + 0.24 * scale * drawn.size + 4.0;
    let replaced = drawn.cuts.iter().filter(|cut| cut.replaced).count();
    let caption = format!(
        "{kept} particles lie inside. The cut goes through {} (dashed), {replaced} of which smaller ones (blue) replace.",
        drawn.cuts.len()
    );
    Some({
        let bottom = sheet.caption(bottom, &caption);
        sheet.finish(bottom)
    })
}

/// Where a panel's square stands on the sheet.
struct Viewport {
    left: f64,
    floor: f64,
    scale: f64,
}

impl Viewport {
    fn spot(&self, x: f64, y: f64) -> Spot {
        [self.left + self.scale * x, self.floor - self.scale * y]
    }
    fn area(&self, low: [f64; 2], high: [f64; 2]) -> Area {
        let ([left, bottom], [right, top]) = (self.spot(low[0], low[1]), self.spot(high[0], high[1]));
        Area { left, top, right, bottom }
    }
}

fn grains(sheet: &mut Sheet, place: &Viewport, particles: &[[f64; 3]], kept: usize) {
    for (k, &[x, y, radius]) in particles.iter().enumerate() {
        let fill = if k < kept { GRAIN } else { REPLACEMENT };
        sheet.circle(place.spot(x, y), place.scale * radius, Pen::shape(fill, INK, THIN).class("grain"));
    }
}

fn cut(sheet: &mut Sheet, place: &Viewport, report: &CalibrationReport, kept: usize) {
    let Some(drawn) = &report.drawn else { return };
    for cut in &drawn.cuts {
        let pen = Pen::line(GONE, HAIR).dashed("3 2").class("cut");
        sheet.circle(place.spot(cut.centre[0], cut.centre[1]), place.scale * cut.radius, pen);
    }
    grains(sheet, place, &drawn.particles, kept);
    sheet.rectangle(place.area([0.0, 0.0], [drawn.size, drawn.size]), Pen::line(LOAD, MEDIUM));
}

fn pressed(sheet: &mut Sheet, place: &Viewport, size: f64, state: &Confined, kept: usize) {
    let (thick, side) = (0.1 * size, 1.2 * size);
    let walls = [
        place.area([0.0, -thick], [size, 0.0]),
        place.area([-thick, -thick], [0.0, side]),
        place.area([size, -thick], [size + thick, side]),
    ];
    for wall in walls {
        sheet.rectangle(wall, Pen::shape(WALL, INK, THIN).class("support"));
    }
    grains(sheet, place, &state.particles, kept);
    let block = place.area([0.005 * size, state.block], [0.995 * size, state.block + 0.15 * size]);
    sheet.rectangle(block, Pen::shape("#f2e8d5", INK, THIN).class("block"));
    let [x, y] = place.spot(0.5 * size, state.block + 0.15 * size);
    let long = 0.12 * size * place.scale;
    if state.stress > 1e4 {
        for k in [-2.0, -1.0, 0.0, 1.0, 2.0] {
            let at = x + 0.19 * k * size * place.scale;
            sheet.arrow([at, y - long], [at, y - 1.0], Pen::line(LOAD, MEDIUM).class("load"));
        }
    }
}
