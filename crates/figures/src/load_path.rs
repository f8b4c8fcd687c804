//! Load against displacement.

use crate::chart::{Axis, Chart, Entry, Mark, Panel, PanelPoint};
use crate::elevation::INK;
use crate::sheet::Pen;
use crate::ticks::Ticks;
use crate::words;
use outcome::picture::{Picture, Step};

const CURVE: &str = "#0b5394";

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
    let x = Axis::round(
        "vertical displacement of the watched point, down positive [mm]",
        Ticks::over(shown[0], shown[1], 6),
    );
    let loads = range(&mut steps.iter().map(|s| load(s)));
    let y = Ticks::over(loads[0], loads[1] + 0.04 * (loads[1] - loads[0]), 6);
    let (second, y_name) = match picture.moves_supports {
        true => ("Support movement against displacement", "support movement [mm]"),
        false => ("Load against displacement", "load [kN/m]"),
    };
    let size = |s: &Step| if picture.moves_supports { words::metres(s.load) } else { words::force(s.load) };

    let [first, end] = x.range;
    let hair = 7e-4 * (end - first);
    let inside = |place: &PanelPoint| place[0] >= first - hair && place[0] <= end + hair;
    let places: Vec<PanelPoint> = steps.iter().map(|s| [sink(s), load(s)]).collect();
    let stay: Vec<PanelPoint> = places.iter().copied().take_while(inside).collect();
    let mut panel = Panel::new(x, Axis::round(y_name, y));
    let mut leaving = None;
    panel.open("curve");
    panel.curve(&stay[..], Pen::line(CURVE, 1.8).class("path"));
    let out = places.get(stay.len()).copied();
    if let (Some(out), Some(&last)) = (out, stay.last()) {
        let edge = if out[0] > end { end } else { first };
        let share = (edge - last[0]) / (out[0] - last[0]);
        let tip = [edge, last[1] + share * (out[1] - last[1])];
        panel.add(move |sheet, axes| {
            let (tail, tip) = (axes.spot(last), axes.spot(tip));
            sheet.arrow(tail, tip, Pen::line(CURVE, 1.8).dashed("6 4").class("leaves"));
            sheet.avoid_line(&[tail, tip]);
        });
        leaving = Some(([0.5 * (last[0] + tip[0]), 0.5 * (last[1] + tip[1])], steps[stay.len()]));
    }
    panel.close();

    // The last step that came to rest before the first one that did not.
    let last_stable = steps.iter().position(|s| !s.at_rest).and_then(|failed| failed.checked_sub(1));
    let shown_stable = last_stable.filter(|&k| inside(&places[k]));
    if let Some(at) = shown_stable.map(|k| places[k]) {
        panel.curve([[first, at[1]], at], Pen::line(INK, 0.9).dashed("5 4").class("last-stable"));
        panel.mark(at, Mark::Ring, CURVE);
    }
    for (step, &at) in steps.iter().zip(&places).filter(|(_, place)| inside(place)) {
        panel.mark(at, if step.at_rest { Mark::Full } else { Mark::Hollow }, CURVE);
    }
    if let Some(k) = shown_stable {
        panel.label(places[k], format!("last stable: {}", size(steps[k])), [0.7, 0.7], 13.0);
    }
    if let Some((at, step)) = leaving {
        let rest = if step.at_rest { "" } else { ": did not come to rest" };
        panel.label(at, format!("{}{rest}", size(step)), [0.0, -1.0], 6.0);
    }

    let mut chart = Chart::of(panel, 360.0);
    let unrest = steps.iter().zip(&places).any(|(s, place)| !s.at_rest && inside(place));
    chart.key = vec![
        Entry::line((CURVE, ""), "in balance").marked(Mark::Full, CURVE),
        Entry::mark(Mark::Hollow, CURVE, "did not come to rest").when(unrest),
        Entry::mark(Mark::Ring, INK, "last stable").when(last_stable.is_some()),
    ];
    if out.is_some() {
        let far = places[stay.len()..].iter().fold(0.0_f64, |a, b| if b[0].abs() > a.abs() { b[0] } else { a });
        chart.words.push(format!(
            "The arrow leads to steps that left the chart: displacement up to {} mm when the run was stopped.",
            words::four_digits(far)
        ));
    }
    Some(chart.draw("load", &picture.title, second))
}
