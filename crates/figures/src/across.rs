//! A bridge cut across the crown of its first span: rings, cover, walls, parapets, kerbs, tracks, cracks and defects.

use crate::edges::{PARAPET, RAIL_HEIGHT, SLEEPER};
use crate::elevation::{INK, fit, scale_bar};
use crate::geometry::{Extent, View};
use crate::ground::{BARREL, CRACK, SUPPORT, WHEEL, dimension};
use crate::sheet::{Anchor, Area, HAIR, MEDIUM, Pen, Sheet, Spot, Style};
use crate::words::metres;
use outcome::ground::GroundPlan;

/// Tallest drawing.
const TALLEST: f64 = 300.0;
/// Colours of layers, from the extrados up.
const LAYERS: [&str; 4] = ["#d8c9a3", "#c4b48a", "#8d8d8d", "#a7a7a7"];
const KERB: &str = "#b9b9b9";
/// Length of a sleeper over the distance of its rails.
const SLEEPER_LENGTH: f64 = 1.75;

/// The barrel cut across the crown of the first span.
pub fn cross_section(ground: &GroundPlan) -> Option<String> {
    let extent = extent(ground)?;
    let (mut sheet, top) =
        Sheet::titled("cross-section", &ground.bridge, "Cross-section at the crown of the first span");
    let (_, view) = fit(extent, top + 6.0, TALLEST);
    let y = draw(&mut sheet, &view, ground, extent);
    let below = scale_bar(&mut sheet, &view, y + 22.0);
    let words = match &ground.vehicle {
        Some(vehicle) => {
            format!("{} (arrows) is carried by {}: {}.", vehicle.code, metres(vehicle.width), vehicle.derivation)
        }
        None => "The barrel without vehicles.".to_owned(),
    };
    Some(sheet.end(below, &words))
}

/// Depth of rings and cover over the crown [m].
fn depths(ground: &GroundPlan) -> [f64; 2] {
    [ground.rings.iter().sum(), ground.layers.iter().map(|layer| layer.1).sum()]
}

/// What the cross-section takes, with room beside the barrel for its levels [m]; none without a barrel.
pub(crate) fn extent(ground: &GroundPlan) -> Option<Extent> {
    let [thickness, depth] = depths(ground);
    if !(ground.width > 0.0 && thickness > 0.0) {
        return None;
    }
    let edges = &ground.edges;
    let above = [
        edges.parapet.map_or(0.0, |parapet| parapet[0]),
        edges.kerb.map_or(0.0, |kerb| kerb[1]),
        if edges.tracks.is_empty() { 0.0 } else { SLEEPER + RAIL_HEIGHT },
        if ground.vehicle.is_some() { 0.06 * ground.width } else { 0.0 },
    ];
    let high = thickness + depth + above.into_iter().fold(0.0, f64::max);
    let beside = 0.34 * ground.width;
    Some(Extent { low: [-0.03 * ground.width, -0.09 * ground.width], high: [ground.width + beside, high] })
}

/// Draws it into a view of its extent; returns the y of its dimension.
pub(crate) fn draw(sheet: &mut Sheet, view: &View, ground: &GroundPlan, extent: Extent) -> f64 {
    let spot = |x: f64, y: f64| view.spot([x, y]);
    let slab =
        |from: f64, to: f64, low: f64, high: f64| [spot(from, low), spot(to, low), spot(to, high), spot(from, high)];
    let (width, label) = (ground.width, Style::small());
    let mut level = 0.0;
    let mut rows: Vec<(f64, String)> = Vec::new();
    sheet.open("rings");
    for (k, ring) in ground.rings.iter().enumerate() {
        sheet.polygon(&slab(0.0, width, level, level + ring), Pen::shape(BARREL, INK, MEDIUM));
        let name = if ground.rings.len() == 1 { "ring".to_owned() } else { format!("ring {}", k + 1) };
        rows.push((level + 0.5 * ring, format!("{name} {}", metres(*ring))));
        level += ring;
    }
    sheet.close();
    let thickness = level;
    let inner = ground.wall.map_or([0.0, width], |wall| [wall.min(0.5 * width), width - wall.min(0.5 * width)]);
    sheet.open("layers");
    for (k, (name, layer)) in ground.layers.iter().enumerate() {
        sheet.polygon(&slab(inner[0], inner[1], level, level + layer), Pen::shape(LAYERS[k % LAYERS.len()], INK, HAIR));
        rows.push((level + 0.5 * layer, format!("{name} {}", metres(*layer))));
        level += layer;
    }
    sheet.close();
    if let Some(wall) = ground.wall {
        sheet.open("walls");
        for [from, to] in [[0.0, inner[0]], [inner[1], width]] {
            sheet.polygon(&slab(from, to, thickness, level), Pen::shape(SUPPORT, INK, MEDIUM));
        }
        sheet.close();
        let words = format!("spandrel walls {}", metres(wall));
        rows.push((level, words));
    }
    rows.extend(edges(sheet, view, ground, level));
    sheet.open("defects");
    for defect in &ground.defects {
        let [low, high] = defect.heights;
        match high > low {
            true => sheet.polygon(&slab(0.0, width, low, high), Pen::line(CRACK, MEDIUM).dashed("5 3")),
            false => sheet.line(spot(0.0, low), spot(width, low), Pen::line(CRACK, 2.2)),
        }
        rows.push((0.5 * (low + high), defect.what.clone()));
    }
    for crack in &ground.cracks {
        sheet.line(spot(*crack, -0.03 * width), spot(*crack, thickness), Pen::line(CRACK, 2.2));
    }
    sheet.close();
    let wheels = level + if ground.edges.tracks.is_empty() { 0.0 } else { SLEEPER + RAIL_HEIGHT };
    for wheel in ground.vehicle.iter().flat_map(|vehicle| &vehicle.wheels) {
        let [x, y] = spot(*wheel, wheels);
        sheet.arrow([x, y - 34.0], [x, y], Pen::line(WHEEL, 2.0));
    }
    levels(sheet, view, width, rows);
    let y = spot(0.0, extent.low[1])[1];
    let [a, b] = [spot(0.0, 0.0), spot(width, 0.0)];
    dimension(sheet, [a[0], y], [b[0], y], a[1]);
    sheet.text([0.5 * (a[0] + b[0]), y + 14.0], &metres(width), label.anchored(Anchor::Middle));
    y
}

/// Levels beside the barrel from the lowest up, no closer than a line of text.
fn levels(sheet: &mut Sheet, view: &View, width: f64, mut rows: Vec<(f64, String)>) {
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut last = f64::INFINITY;
    for (height, words) in &rows {
        let [x, y] = view.spot([width, *height]);
        let place = (y + 4.0).min(last - 15.0);
        sheet.line([x, y], [x + 14.0, place - 4.0], Pen::line("#777777", HAIR));
        sheet.text([x + 17.0, place], words, Style::small());
        last = place;
    }
}

/// Parapets, kerbs and tracks on a level; what they are, with their heights [m].
fn edges(sheet: &mut Sheet, view: &View, ground: &GroundPlan, level: f64) -> Vec<(f64, String)> {
    let edges = &ground.edges;
    let mut rows = Vec::new();
    // Both ends of the width, from the edge inwards.
    let mut both = |from: f64, to: f64, high: f64, pen: Pen| {
        for mirror in [false, true] {
            let x = |at: f64| if mirror { ground.width - at } else { at };
            let corners: [Spot; 4] = [[x(from), level], [x(to), level], [x(to), level + high], [x(from), level + high]]
                .map(|at| view.spot(at));
            sheet.polygon(&corners, pen);
        }
    };
    let behind = edges.parapet.map_or(0.0, |parapet| parapet[1]);
    if let Some([distance, upstand]) = edges.kerb.filter(|kerb| kerb[0] > behind) {
        both(behind, distance, upstand, Pen::shape(KERB, INK, HAIR).class("kerb"));
        rows.push((level + 0.5 * upstand, format!("kerb {}, {} from the edge", metres(upstand), metres(distance))));
    }
    if let Some([height, thick]) = edges.parapet {
        both(0.0, thick, height, Pen::shape(PARAPET, INK, MEDIUM).class("parapet"));
        rows.push((level + 0.5 * height, format!("parapet {} by {}", metres(height), metres(thick))));
    }
    sheet.open("tracks");
    for middle in &edges.tracks {
        let half = 0.5 * SLEEPER_LENGTH * edges.gauge;
        let [low, high] = [view.spot([middle - half, level]), view.spot([middle + half, level + SLEEPER])];
        let sleeper = Area { left: low[0], right: high[0], top: high[1], bottom: low[1] };
        sheet.rectangle(sleeper, Pen::shape("#9a9a9a", INK, HAIR));
        for rail in [middle - 0.5 * edges.gauge, middle + 0.5 * edges.gauge] {
            let [foot, head] = [level + SLEEPER, level + SLEEPER + RAIL_HEIGHT].map(|y| view.spot([rail, y]));
            sheet.line(foot, head, Pen::line(INK, 2.2));
        }
    }
    sheet.close();
    if !edges.tracks.is_empty() {
        rows.push((level + SLEEPER, format!("track, rails {} apart", metres(edges.gauge))));
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::ground::{CrownDefect, Edges};

    #[test]
    fn what_stands_at_the_edges_is_drawn_with_its_sizes() {
        let ground = GroundPlan {
            bridge: "Edges".into(),
            width: 8.0,
            rings: vec![0.3, 0.3],
            layers: vec![("fill".into(), 0.4)],
            edges: Edges { parapet: Some([1.1, 0.35]), kerb: Some([0.9, 0.1]), tracks: vec![2.3, 5.7], gauge: 1.5 },
            defects: vec![CrownDefect { what: "rings separated".into(), heights: [0.3, 0.3] }],
            ..GroundPlan::default()
        };
        let drawn = cross_section(&ground).unwrap();
        for words in [
            "parapet 1.1 m by 0.35 m",
            "kerb 0.1 m, 0.9 m from the edge",
            "track, rails 1.5 m apart",
            "rings separated",
        ] {
            assert!(drawn.contains(words), "{words}: {drawn}");
        }
        for (class, count) in [("class=\"parapet\"", 2), ("class=\"kerb\"", 2)] {
            assert_eq!(drawn.matches(class).count(), count, "{class}");
        }
        let tracks = &drawn[drawn.find("class=\"tracks\"").unwrap()..];
        let tracks = &tracks[..tracks.find("</g>").unwrap()];
        assert_eq!([tracks.matches("<polygon").count(), tracks.matches("<polyline").count()], [2, 4], "{tracks}");
    }
}
