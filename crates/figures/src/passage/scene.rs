//! What pictures of the bridge at one moment share: where it is drawn, its outlines, the axles above it.

use crate::elevation::{INK, LOAD};
use crate::geometry::{Extent, View, sides};
use crate::sheet::{Anchor, HAIR, MEDIUM, Pen, Sheet, Spot, Style};
use crate::words;
use outcome::mesh::MeshPicture;
use outcome::passage::{Moment, Passage};
use outcome::picture::Point;
use std::collections::BTreeMap;

/// Room above the surface for the axles [0.2 mm].
pub(super) const AXLES: f64 = 44.0;

/// The part of the mesh that is drawn: masonry from end to end and the fill above it.
pub(super) fn extent(mesh: &MeshPicture) -> Option<Extent> {
    let masonry = |zone: &usize| {
        let name = mesh.zones.get(*zone).map_or("", |zone| zone.name.as_str());
        ["voussoirs", "pier", "abutment left", "abutment right", "backing"].iter().any(|kind| name.starts_with(kind))
    };
    let quads = mesh.quads.iter().zip(&mesh.zone_of).filter(|(_, zone)| masonry(zone));
    let of_masonry = Extent::of(quads.flat_map(|(quad, _)| quad.map(|node| mesh.nodes[node])));
    let whole = Extent::of(mesh.nodes.iter().copied())?;
    let shown = of_masonry.unwrap_or(whole);
    let top = Extent::of(mesh.surface.iter().copied()).map_or(shown.high[1], |surface| surface.high[1]);
    let beside = 0.03 * shown.size()[0];
    let low = [shown.low[0] - beside, shown.low[1]];
    Some(Extent { low, high: [shown.high[0] + beside, top.max(shown.high[1])] }.within(whole))
}

/// What the train alone has moved [m]: self-weight, the first moment, taken off.
pub(super) fn by_train(passage: &Passage, moment: &Moment) -> Vec<Point> {
    let rest = passage.moments.first();
    let before = |k: usize| rest.and_then(|rest| rest.displacements.get(k)).copied().unwrap_or([0.0; 2]);
    let minus = |(k, moved): (usize, &Point)| {
        let before = before(k);
        [moved[0] - before[0], moved[1] - before[1]]
    };
    moment.displacements.iter().enumerate().map(minus).collect()
}

/// Nodes with their displacements drawn `times` as large [m].
pub(super) fn moved(mesh: &MeshPicture, displacements: &[Point], times: f64) -> Vec<Point> {
    let add = |(at, by): (&Point, &Point)| [at[0] + times * by[0], at[1] + times * by[1]];
    mesh.nodes.iter().zip(displacements).map(add).collect()
}

/// Edges where one zone or one stone ends.
pub(super) fn outlines(mesh: &MeshPicture) -> Vec<[usize; 2]> {
    // The zone of the elements at each edge: inside where two of one zone share it.
    let mut edges: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
    for (quad, zone) in mesh.quads.iter().zip(&mesh.zone_of) {
        for [a, b] in sides(quad) {
            edges.entry([a.min(b), a.max(b)]).or_default().push(*zone);
        }
    }
    let outer = |zones: &[usize]| zones.len() < 2 || zones.iter().any(|zone| *zone != zones[0]);
    edges.into_iter().filter(|(_, zones)| outer(zones)).map(|(edge, _)| edge).collect()
}

/// The outlines as thin lines.
pub(super) fn draw_outlines(sheet: &mut Sheet, view: &View, nodes: &[Point], edges: &[[usize; 2]], width: f64) {
    let lines: Vec<[Spot; 2]> = edges.iter().map(|edge| edge.map(|node| view.spot(nodes[node]))).collect();
    sheet.open_drawn("outlines", Pen::line(INK, width));
    sheet.strokes(&lines, width);
    sheet.close();
}

/// The axles above the surface: wheels, and their forces in words.
pub(super) fn draw_axles(sheet: &mut Sheet, view: &View, moment: &Moment, mesh: &MeshPicture, from: f64, to: f64) {
    let level = mesh.surface.iter().map(|point| point[1]).fold(f64::NEG_INFINITY, f64::max);
    let mut shown: Vec<(f64, f64)> = moment.axles.iter().copied().filter(|(x, _)| (from..=to).contains(x)).collect();
    shown.sort_by(|a, b| a.0.total_cmp(&b.0));
    sheet.open("axles");
    let wheel = 5.0;
    for (x, _) in &shown {
        let [at, rail] = view.spot([*x, level]);
        sheet.circle([at, rail - wheel - 2.0], wheel, Pen::shape("white", LOAD, MEDIUM).class("wheel"));
        sheet.arrow([at, rail - 3.0 * wheel - 12.0], [at, rail - 2.0 * wheel - 3.0], Pen::line(LOAD, 1.0));
    }
    let ends = [view.spot([from, level]), view.spot([to, level])];
    sheet.line([ends[0][0], ends[0][1] - 1.0], [ends[1][0], ends[1][1] - 1.0], Pen::line(INK, HAIR));
    // One word for each run of equal axles.
    let style = Style { colour: LOAD, ..Style::small() }.anchored(Anchor::Middle);
    let mut start = 0;
    let mut last_end = f64::NEG_INFINITY;
    while start < shown.len() {
        let same = shown[start..].iter().take_while(|axle| (axle.1 - shown[start].1).abs() < 1e-6 * axle.1).count();
        let run = &shown[start..start + same.max(1)];
        let middle = 0.5 * (view.spot([run[0].0, level])[0] + view.spot([run[run.len() - 1].0, level])[0]);
        let kilo = words::three_digits(run[0].1 / 1e3);
        let text = if run.len() > 1 { format!("{} axles of {kilo} kN", run.len()) } else { format!("{kilo} kN") };
        let half = 0.5 * style.width(&text);
        let middle = middle.clamp(ends[0][0] + half, (ends[1][0] - half).max(ends[0][0] + half));
        // Where words would run into one another, the later ones are left out; the table of axles has them.
        if middle - half > last_end + 6.0 {
            sheet.text([middle, ends[0][1] - 3.0 * wheel - 17.0], &text, style);
            last_end = middle + half;
        }
        start += run.len();
    }
    sheet.close();
}

/// The moment in words.
pub(super) fn second_line(passage: &Passage, moment: &Moment, what: &str) -> String {
    if moment.axles.is_empty() && moment.time == 0.0 && moment.name == "self-weight" {
        return format!("{what}, self-weight alone");
    }
    let place = format!("{:.2}", moment.position).replace('-', "−");
    format!("{what}, {}: {} with its first axle at {place} m, {:.3} s", moment.name, passage.train, moment.time)
}
