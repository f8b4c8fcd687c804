//! Load against displacement.

use crate::chart::{Axes, Axis, Entry, Mark, key};
use crate::elevation::INK;
use crate::figure::Figure;
use crate::sheet::place::Room;
use crate::sheet::{Pen, Sheet, Spot, Style};
use crate::ticks::Ticks;
use crate::words;
use outcome::picture::{Picture, Step};

/// See [`Figure`].
pub(crate) const FIGURE: Figure = Figure {
    name: "load-displacement",
    caption: "Load over displacement of the watched point.",
    draw: load_displacement,
};

const CURVE: &str = "#0b5394";
const HEIGHT: f64 = 360.0;

/// Load over the vertical displacement of the watched point, down positive; the last stable load marked, steps
/// that did not come to rest hollow. Nothing without a load path.
pub fn load_displacement(picture: &Picture) -> Option<String> {
    let finite = |s: &&Step| s.load.is_finite() && s.displacement[1].is_finite();
    let steps: Vec<&Step> = picture.path.iter().filter(finite).collect();
    if steps.is_empty() {
        return None;
    }
    let load = |s: &Step| if picture.moves_supports { s.load * 1e3 } else { s.load / 1e3 };
    let sink = |s: &Step| -1e3 * s.displacement[1];
    let range =
        |values: &mut dyn Iterator<Item = f64>| values.fold([0.0_f64, 0.0_f64], |r, v| [r[0].min(v), r[1].max(v)]);
    // A run that falls sinks for metres in its last step: the axis then ends at twice what the stable steps need,
    // and the last step is drawn as an arrow that leaves the chart.
    let settled = range(&mut steps.iter().filter(|s| s.at_rest).map(|s| sink(s)));
    let all = range(&mut steps.iter().map(|s| sink(s)));
    let reach = 2.0 * (settled[1] - settled[0]);
    let cut = reach > 0.0 && (all[1] > reach.max(settled[1]) * 2.0 || all[0] < -2.0 * reach);
    let shown = if cut { [settled[0], reach.max(settled[1])] } else { all };
    let x = Ticks::over(shown[0], shown[1], 6);
    let loads = range(&mut steps.iter().map(|s| load(s)));
    let y = Ticks::over(loads[0], loads[1] + 0.04 * (loads[1] - loads[0]), 6);

    let mut sheet = Sheet::new("load");
    let second =
        if picture.moves_supports { "Support movement against displacement" } else { "Load against displacement" };
    let top = sheet.title(&picture.title, second);
    let x_name = "vertical displacement of the watched point, down positive [mm]";
    let y_name = if picture.moves_supports { "support movement [mm]" } else { "load [kN/m]" };
    let (axes, y_below) = Axes::draw(&mut sheet, top, HEIGHT, &Axis::round(x_name, x), &Axis::round(y_name, y));

    let spots: Vec<Spot> = steps.iter().map(|s| axes.spot(sink(s), load(s))).collect();
    let inside = |p: &Spot| p[0] >= axes.area.left - 0.5 && p[0] <= axes.area.right + 0.5;
    let stay: Vec<Spot> = spots.iter().copied().take_while(inside).collect();
    let mut leaving = None;
    sheet.open("curve");
    sheet.polyline(&stay, Pen::line(CURVE, 1.8).class("path"));
    let leaves = stay.len() < spots.len();
    if leaves && let Some(&last) = stay.last() {
        let out = spots[stay.len()];
        let edge = if out[0] > axes.area.right { axes.area.right } else { axes.area.left };
        let share = (edge - last[0]) / (out[0] - last[0]);
        let tip = [edge, last[1] + share * (out[1] - last[1])];
        sheet.arrow(last, tip, Pen::line(CURVE, 1.8).dashed("6 4").class("leaves"));
        sheet.avoid_line(&[last, tip]);
        leaving = Some(([0.5 * (last[0] + tip[0]), 0.5 * (last[1] + tip[1])], steps[stay.len()]));
    }
    sheet.close();
    sheet.avoid_line(&stay);

    let last_stable = last_stable(&steps);
    if let Some(k) = last_stable.filter(|&k| inside(&spots[k])) {
        let at = spots[k];
        sheet.line([axes.area.left, at[1]], at, Pen::line(INK, 0.9).dashed("5 4").class("last-stable"));
        sheet.avoid_line(&[[axes.area.left, at[1]], at]);
        Mark::Ring.draw(&mut sheet, at, CURVE);
    }
    for (step, &at) in steps.iter().zip(&spots).filter(|(_, p)| inside(p)) {
        let mark = if step.at_rest { Mark::Full } else { Mark::Hollow };
        mark.draw(&mut sheet, at, CURVE);
    }
    if let Some(k) = last_stable.filter(|&k| inside(&spots[k])) {
        let size = if picture.moves_supports { words::metres(steps[k].load) } else { words::force(steps[k].load) };
        let room = Room { area: axes.area.grown(-5.0), towards: [0.7, 0.7], clear: 13.0 };
        sheet.label(spots[k], &format!("last stable: {size}"), Style::on_drawing(), room);
    }
    if let Some((at, step)) = leaving {
        let size = if picture.moves_supports { words::metres(step.load) } else { words::force(step.load) };
        let text = if step.at_rest { size } else { format!("{size}: did not come to rest") };
        let room = Room { area: axes.area.grown(-5.0), towards: [0.0, -1.0], clear: 6.0 };
        sheet.label(at, &text, Style::on_drawing(), room);
    }

    let mut entries = vec![Entry { line: Some((CURVE, "")), mark: Some((Mark::Full, CURVE)), text: "in balance" }];
    if steps.iter().zip(&spots).any(|(s, p)| !s.at_rest && inside(p)) {
        entries.push(Entry { line: None, mark: Some((Mark::Hollow, CURVE)), text: "did not come to rest" });
    }
    if last_stable.is_some() {
        entries.push(Entry { line: None, mark: Some((Mark::Ring, INK)), text: "last stable" });
    }
    let mut bottom = key(&mut sheet, y_below, &entries);
    if leaves {
        let far =
            steps[stay.len()..].iter().map(|s| sink(s)).fold(0.0_f64, |a, b| if b.abs() > a.abs() { b } else { a });
        let text = format!(
            "The arrow leads to steps that left the chart: displacement up to {} mm when the run was stopped.",
            words::four_digits(far)
        );
        bottom = sheet.caption(bottom, &text);
    }
    Some(sheet.finish(bottom))
}

/// The last step that came to rest before the first one that did not.
fn last_stable(steps: &[&Step]) -> Option<usize> {
    let failed = steps.iter().position(|s| !s.at_rest)?;
    failed.checked_sub(1)
}
