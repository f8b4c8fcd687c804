//! Displacement and stress of the bridge at one moment, by colour, on the bridge as it has moved.

use super::scene;
use crate::bar::{Scale, quantile};
use crate::colour::{blue_for_much, red_for_much};
use crate::elevation as draw;
use crate::geometry::{View, round_down};
use crate::sheet::{MARGIN, Sheet, Spot, WIDTH};
use crate::stress::most_compressive;
use crate::words;
use outcome::passage::{Moment, Passage};
use outcome::picture::Point;

/// Shades along a scale: neighbours differ by less than the eye sees.
const SHADES: usize = 48;
/// Largest displacement on the sheet, as a share of the drawing's width.
const LARGEST: f64 = 0.012;
/// Share of the elements whose stress is below the end of the scale: corners of stones would stretch it.
const COVERED: f64 = 0.995;

/// How far every point has moved by the train alone (by self-weight in the first moment).
pub(super) fn displacement(passage: &Passage, index: usize) -> Option<String> {
    let moment = passage.moments.get(index)?;
    let mesh = &passage.mesh;
    if moment.displacements.len() != mesh.nodes.len() {
        return None;
    }
    let moved = movement(passage, index, moment);
    let size: Vec<f64> = moved.iter().map(|by| by[0].hypot(by[1])).collect();
    let of_quad = |quad: &[usize; 4]| 1e3 * quad.iter().map(|node| size[*node]).sum::<f64>() / 4.0;
    let values: Vec<f64> = mesh.quads.iter().map(of_quad).collect();
    let what = if index == 0 { "displacement by self-weight [mm]" } else { "displacement by the train [mm]" };
    let largest = values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
    let scale = Scale::upto(what, [largest.max(1e-9), 0.0], 6, blue_for_much);
    drawn(passage, index, ["displacement", "Displacement"], &moved, &values, &scale)
}

/// The largest compression at every point, self-weight included.
pub(super) fn stress(passage: &Passage, index: usize) -> Option<String> {
    let moment = passage.moments.get(index)?;
    let mesh = &passage.mesh;
    if moment.stresses.len() != mesh.quads.len() || moment.displacements.len() != mesh.nodes.len() {
        return None;
    }
    let values: Vec<f64> = moment
        .stresses
        .iter()
        .map(|stress| 1e-6 * most_compressive([stress[0], stress[1], stress[2]]).max(0.0))
        .collect();
    let end = quantile(values.iter().copied(), COVERED).max(1e-6);
    let largest = values.iter().copied().fold(0.0, f64::max);
    let scale = Scale::upto("largest compression, self-weight included [MPa]", [end, largest], 6, red_for_much);
    let moved = movement(passage, index, moment);
    drawn(passage, index, ["stress", "Compression"], &moved, &values, &scale)
}

fn movement(passage: &Passage, index: usize, moment: &Moment) -> Vec<Point> {
    if index == 0 { moment.displacements.clone() } else { scene::by_train(passage, moment) }
}

fn drawn(
    passage: &Passage,
    index: usize,
    [name, what]: [&str; 2],
    displacements: &[Point],
    values: &[f64],
    scale: &Scale,
) -> Option<String> {
    let (mesh, moment) = (&passage.mesh, &passage.moments[index]);
    let extent = scene::extent(mesh)?;
    let largest = displacements.iter().map(|by| by[0].hypot(by[1])).filter(|size| size.is_finite()).fold(0.0, f64::max);
    let times = if largest > 0.0 { round_down(LARGEST * extent.size()[0] / largest).max(1.0) } else { 1.0 };
    let second = scene::second_line(passage, moment, what);
    let (mut sheet, top) = Sheet::titled(&format!("moment-{index}-{name}"), &passage.bridge, &second);
    let (_, view) = draw::fit(extent, top + scene::AXLES, draw::TALLEST);
    let nodes = scene::moved(mesh, displacements, times);
    let window = view.area(extent).taller(4.0);
    sheet.open_clipped("field", "window", window);
    fill(&mut sheet, &view, &nodes, &mesh.quads, values, scale);
    scene::draw_outlines(&mut sheet, &view, &nodes, &scene::outlines(mesh), 0.25);
    sheet.close();
    scene::draw_axles(&mut sheet, &view, moment, mesh, extent.low[0], extent.high[0]);
    let y = draw::scale_bar(&mut sheet, &view, window.bottom + 6.0) + 6.0;
    let y = scale.draw(&mut sheet, MARGIN, 0.6 * WIDTH, y);
    let yielding = moment.yielding.iter().filter(|yields| **yields).count();
    let mut caption = format!("Displacements are drawn {} as large.", words::times(times));
    if yielding > 0 {
        let yields = if yielding == 1 { "yields" } else { "yield" };
        caption += &format!(" Of {} elements {yielding} {yields}.", mesh.quads.len());
    }
    Some(sheet.end(y + 2.0, &caption))
}

/// Elements by shade, one path each.
fn fill(sheet: &mut Sheet, view: &View, nodes: &[Point], quads: &[[usize; 4]], values: &[f64], scale: &Scale) {
    let mut shades: Vec<Vec<[Spot; 4]>> = vec![Vec::new(); SHADES + 1];
    for (quad, value) in quads.iter().zip(values) {
        let share = scale.axis.share(*value).clamp(0.0, 1.0);
        let shade = if share.is_nan() { SHADES } else { ((share * SHADES as f64) as usize).min(SHADES - 1) };
        shades[shade].push(quad.map(|node| view.spot(nodes[node])));
    }
    for (shade, list) in shades.iter().enumerate() {
        let share = if shade == SHADES { f64::NAN } else { (shade as f64 + 0.5) / SHADES as f64 };
        sheet.areas(list, &(scale.colour)(share));
    }
}
