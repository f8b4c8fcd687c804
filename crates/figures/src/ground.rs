//! A bridge from above, with skew, cracks and lines of wheels; and cut across its crown.

use crate::dimension::tick;
use crate::elevation::{INK, fit, scale_bar};
use crate::geometry::Extent;
use crate::sheet::{Anchor, HAIR, MEDIUM, Pen, Sheet, Spot, Style};
use crate::words::metres;
use outcome::ground::{GroundPlan, SpanInPlan};

const BARREL: &str = "#e9e2d3";
const SUPPORT: &str = "#cfc6b3";
const CRACK: &str = "#c02020";
const WHEEL: &str = "#0b5394";
const STRIP: &str = "#f6c9a8";
/// Tallest drawings.
const TALLEST: [f64; 2] = [330.0, 300.0];
/// Colours of layers, from the extrados up.
const LAYERS: [&str; 4] = ["#d8c9a3", "#c4b48a", "#8d8d8d", "#a7a7a7"];

/// The bridge from above.
pub fn plan(ground: &GroundPlan) -> Option<String> {
    let half = 0.5 * ground.width;
    let (first, last) = (ground.spans.first()?, ground.spans.last()?);
    let lean = |skew: f64, y: f64| y * skew.tan();
    // What an edge of the road shows beyond the springings.
    let beyond = 0.06 * (last.from_to[1] - first.from_to[0]) + 0.15 * ground.width;
    let ends = [
        first.from_to[0] - lean(first.skew, half).abs() - beyond,
        last.from_to[1] + lean(last.skew, half).abs() + beyond,
    ];
    let (mut sheet, top) = Sheet::titled("plan", &ground.bridge, "Plan at the springings");
    let across = ground.piers.iter().flat_map(|pier| &pier.outline).map(|p| p[1]);
    let [lowest, highest] = across.fold([-half, half], |[low, high], y| [low.min(y), high.max(y)]);
    let extent =
        Extent { low: [ends[0], lowest - 0.12 * ground.width], high: [ends[1], highest + 0.06 * ground.width] };
    let (_, view) = fit(extent, top + 6.0, TALLEST[0]);
    let spot = |x: f64, y: f64| view.spot([x, y]);
    // Where a place of the bridge, as if it were square, stands with its skew.
    let skewed = |x: f64, skew: f64, y: f64| spot(x + lean(skew, y), y);
    let strip = |span: &SpanInPlan, [low, high]: [f64; 2]| {
        let [from, to] = span.from_to;
        [(from, low), (to, low), (to, high), (from, high)].map(|(x, y)| skewed(x, span.skew, y))
    };
    sheet.open("supports");
    let whole = [spot(ends[0], -half), spot(ends[1], -half), spot(ends[1], half), spot(ends[0], half)];
    sheet.polygon(&whole, Pen::shape(SUPPORT, "none", 0.0));
    for pier in ground.piers.iter().filter(|pier| pier.cutwaters > 0) {
        let outline: Vec<Spot> = pier.outline.iter().map(|[x, y]| skewed(*x, pier.skew, *y)).collect();
        sheet.polygon(&outline, Pen::shape(SUPPORT, INK, MEDIUM));
    }
    sheet.close();
    sheet.open("spans");
    let carries = ground.vehicle.as_ref().and_then(|vehicle| vehicle.strip);
    for span in &ground.spans {
        sheet.polygon(&strip(span, [-half, half]), Pen::shape(BARREL, "none", 0.0));
        if let Some(carries) = carries {
            sheet.polygon(&strip(span, carries.map(|y| y - half)), Pen::shape(STRIP, "none", 0.0));
        }
        for x in span.from_to {
            sheet.line(skewed(x, span.skew, -half), skewed(x, span.skew, half), Pen::line(INK, MEDIUM));
        }
    }
    sheet.close();
    for y in [-half, half] {
        sheet.line(spot(ends[0], y), spot(ends[1], y), Pen::line(INK, MEDIUM));
    }
    let axis = Pen::line("#666666", HAIR).dashed("12 3 2 3");
    sheet.line(spot(ends[0], 0.0), spot(ends[1], 0.0), axis);
    sheet.open("cracks");
    for crack in &ground.cracks {
        let y = crack - half;
        let ends = [skewed(first.from_to[0], first.skew, y), skewed(last.from_to[1], last.skew, y)];
        sheet.line(ends[0], ends[1], Pen::line(CRACK, 1.8).dashed("6 3"));
    }
    sheet.close();
    sheet.open("wheels");
    for wheel in ground.vehicle.iter().flat_map(|vehicle| &vehicle.wheels) {
        sheet.line(spot(ends[0], wheel - half), spot(ends[1], wheel - half), Pen::line(WHEEL, 1.4));
    }
    sheet.close();
    let mut below = view.spot(extent.low)[1] + 16.0;
    let middle = Style::small().anchored(Anchor::Middle);
    for (k, span) in ground.spans.iter().enumerate() {
        let [a, b] = span.from_to.map(|x| skewed(x, span.skew, -half));
        let y = view.spot(extent.low)[1];
        dimension(&mut sheet, [a[0], y], [b[0], y], a[1]);
        let along = span.from_to[1] - span.from_to[0];
        let words = match ground.spans.len() <= 4 {
            true if span.skew > 1e-6 => {
                format!("{} along the road, {} square", metres(along), metres(along * span.skew.cos()))
            }
            false if k > 0 => String::new(),
            _ => metres(along),
        };
        sheet.text([0.5 * (a[0] + b[0]), y + 14.0], &words, middle);
        if span.skew > 1e-6 && ground.spans.len() <= 6 {
            // The normal of the springings beside the road's axis.
            let centre = spot(0.5 * (span.from_to[0] + span.from_to[1]), 0.0);
            let reach = 0.36 * ground.width * view.scale;
            let (sine, cosine) = span.skew.sin_cos();
            let tip = [centre[0] + reach * cosine, centre[1] + reach * sine];
            sheet.arrow(centre, tip, Pen::line(INK, 1.0));
            let style = Style::on_drawing().anchored(Anchor::Middle);
            let words = format!("skew {:.0}°", span.skew.to_degrees());
            sheet.text([centre[0] + 0.5 * reach, centre[1] - 6.0], &words, style);
        }
        below = y + 24.0;
    }
    let below = scale_bar(&mut sheet, &view, below);
    Some(sheet.end(below, &told(ground)))
}

/// A dimension line between two places, with strokes up to a height.
fn dimension(sheet: &mut Sheet, from: Spot, to: Spot, up: f64) {
    sheet.line(from, to, Pen::line(INK, HAIR));
    for p in [from, to] {
        sheet.line([p[0], up], [p[0], p[1] + 4.0], Pen::line("#777777", HAIR));
        tick(sheet, p);
    }
}

/// What stands under the plan.
fn told(ground: &GroundPlan) -> String {
    let mut told = Vec::new();
    if ground.spans.iter().any(|span| span.skew > 1e-6) {
        told.push(
            "Spans are those along the road; to which side the bridge is skew the file does not say. The arrow is the normal of the springings."
                .to_owned(),
        );
    }
    if ground.piers.iter().any(|pier| pier.cutwaters > 0) {
        let side = if ground.piers.iter().any(|pier| pier.cutwaters == 1) {
            "; a single one beyond the upper edge, for the file does not say where it stands"
        } else {
            ""
        };
        told.push(format!("Piers are drawn with their cutwaters{side}."));
    }
    if !ground.cracks.is_empty() {
        let places: Vec<String> = ground.cracks.iter().map(|at| metres(*at)).collect();
        told.push(format!("Red: longitudinal cracks, {} from the lower edge.", places.join(", ")));
    }
    if let Some(vehicle) = &ground.vehicle {
        let strip = if vehicle.strip.is_some() { " on the coloured strip" } else { "" };
        told.push(format!("Blue: lines of wheels of {} where it loads a metre of width most{strip}.", vehicle.code));
    }
    match (told.is_empty(), ground.skew_given) {
        (true, true) => "The bridge is square.".to_owned(),
        (true, false) => "The file gives no skew: the bridge is taken as square.".to_owned(),
        (false, _) => told.join(" "),
    }
}

/// The barrel cut across the crown of the first span.
pub fn cross_section(ground: &GroundPlan) -> Option<String> {
    let thickness: f64 = ground.rings.iter().sum();
    let depth: f64 = ground.layers.iter().map(|layer| layer.1).sum();
    let parapet: f64 = if ground.wall.is_some() { 0.07 * ground.width } else { 0.0 };
    if !(ground.width > 0.0 && thickness > 0.0) {
        return None;
    }
    let high = thickness + depth + parapet.max(if ground.vehicle.is_some() { 0.06 * ground.width } else { 0.0 });
    let (mut sheet, top) =
        Sheet::titled("cross-section", &ground.bridge, "Cross-section at the crown of the first span");
    // Room beside the barrel for its levels.
    let beside = 0.34 * ground.width;
    let extent = Extent { low: [-0.03 * ground.width, -0.09 * ground.width], high: [ground.width + beside, high] };
    let (_, view) = fit(extent, top + 6.0, TALLEST[1]);
    let spot = |x: f64, y: f64| view.spot([x, y]);
    let slab =
        |from: f64, to: f64, low: f64, high: f64| [spot(from, low), spot(to, low), spot(to, high), spot(from, high)];
    let label = Style::small();
    let mut level = 0.0;
    let mut rows: Vec<(f64, String)> = Vec::new();
    sheet.open("rings");
    for (k, ring) in ground.rings.iter().enumerate() {
        sheet.polygon(&slab(0.0, ground.width, level, level + ring), Pen::shape(BARREL, INK, MEDIUM));
        let name = if ground.rings.len() == 1 { "ring".to_owned() } else { format!("ring {}", k + 1) };
        rows.push((level + 0.5 * ring, format!("{name} {}", metres(*ring))));
        level += ring;
    }
    sheet.close();
    let inner = ground.wall.map_or([0.0, ground.width], |wall| {
        [wall.min(0.5 * ground.width), ground.width - wall.min(0.5 * ground.width)]
    });
    sheet.open("layers");
    for (k, (name, layer)) in ground.layers.iter().enumerate() {
        sheet.polygon(&slab(inner[0], inner[1], level, level + layer), Pen::shape(LAYERS[k % LAYERS.len()], INK, HAIR));
        rows.push((level + 0.5 * layer, format!("{name} {}", metres(*layer))));
        level += layer;
    }
    sheet.close();
    if ground.wall.is_some() {
        for [from, to] in [[0.0, inner[0]], [inner[1], ground.width]] {
            sheet.polygon(&slab(from, to, thickness, level + parapet), Pen::shape(SUPPORT, INK, MEDIUM));
        }
    }
    for crack in &ground.cracks {
        sheet.line(spot(*crack, -0.03 * ground.width), spot(*crack, thickness), Pen::line(CRACK, 2.2));
    }
    if let Some(vehicle) = &ground.vehicle {
        for wheel in &vehicle.wheels {
            let [x, y] = spot(*wheel, level);
            sheet.arrow([x, y - 34.0], [x, y], Pen::line(WHEEL, 2.0));
        }
    }
    // Levels beside the barrel, no closer than a line of text.
    let mut last = f64::INFINITY;
    for (height, words) in &rows {
        let [x, y] = spot(ground.width, *height);
        let place = (y + 4.0).min(last - 15.0);
        sheet.line([x, y], [x + 14.0, place - 4.0], Pen::line("#777777", HAIR));
        sheet.text([x + 17.0, place], words, label);
        last = place;
    }
    let y = spot(0.0, extent.low[1])[1];
    let [a, b] = [spot(0.0, 0.0), spot(ground.width, 0.0)];
    dimension(&mut sheet, [a[0], y], [b[0], y], a[1]);
    sheet.text([0.5 * (a[0] + b[0]), y + 14.0], &metres(ground.width), label.anchored(Anchor::Middle));
    let below = scale_bar(&mut sheet, &view, y + 22.0);
    let words = match &ground.vehicle {
        Some(vehicle) => {
            format!("{} (arrows) is carried by {}: {}.", vehicle.code, metres(vehicle.width), vehicle.derivation)
        }
        None => "The barrel without vehicles.".to_owned(),
    };
    Some(sheet.end(below, &words))
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::ground::{PierInPlan, VehicleAcross};

    fn ground() -> GroundPlan {
        GroundPlan {
            skew_given: true,
            bridge: "Skew".into(),
            width: 8.0,
            spans: vec![SpanInPlan { from_to: [0.0, 9.0], skew: 0.5 }, SpanInPlan { from_to: [10.5, 17.0], skew: 0.3 }],
            piers: vec![PierInPlan {
                outline: vec![[10.5, 4.0], [9.75, 5.2], [9.0, 4.0], [9.0, -4.0], [10.5, -4.0]],
                skew: 0.4,
                cutwaters: 1,
            }],
            cracks: vec![0.9, 7.1],
            rings: vec![0.23, 0.23],
            layers: vec![("fill".into(), 0.4), ("ballast".into(), 0.3)],
            wall: Some(0.45),
            vehicle: Some(VehicleAcross {
                code: "cs454-single".into(),
                wheels: vec![1.3, 3.1],
                strip: Some([0.9, 7.1]),
                width: 2.8,
                derivation: "1.80 m between wheels + 1.50 m + 1.00 x 0.70 m depth".into(),
            }),
        }
    }

    /// Every crack, wheel and springing is drawn, and both lengths of a skew span are told.
    #[test]
    fn plan_and_section_show_what_they_are_made_of() {
        let drawn = plan(&ground()).unwrap();
        assert!(drawn.contains("9 m along the road, 7.898 m square") && drawn.contains("skew 29°"), "{drawn}");
        assert!(drawn.contains("a single one beyond the upper edge"), "{drawn}");
        let outlines =
            |drawn: &str| drawn.split("class=\"spans\"").next().unwrap_or_default().matches("<polygon").count();
        let plain = GroundPlan { piers: Vec::new(), ..ground() };
        assert_eq!(outlines(&drawn), outlines(&plan(&plain).unwrap()) + 1);
        assert_eq!(drawn.matches(CRACK).count(), 2);
        assert_eq!(drawn.matches(WHEEL).count(), 2);
        let cut = cross_section(&ground()).unwrap();
        assert!(cut.contains("ring 2 0.23 m") && cut.contains("ballast 0.3 m"), "{cut}");
        assert!(plan(&GroundPlan::default()).is_none() && cross_section(&GroundPlan::default()).is_none());
    }
}
