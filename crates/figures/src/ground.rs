//! A bridge from above, with skew, cracks and lines of wheels.

use crate::dimension::tick;
use crate::elevation::{INK, fit, scale_bar};
use crate::geometry::Extent;
use crate::sheet::{Anchor, HAIR, MEDIUM, Pen, Sheet, Spot, Style};
use crate::words::metres;
use outcome::ground::{GroundPlan, SpanInPlan};

pub(crate) const BARREL: &str = "#e9e2d3";
pub(crate) const SUPPORT: &str = "#cfc6b3";
pub(crate) const CRACK: &str = "#c02020";
pub(crate) const WHEEL: &str = "#0b5394";
const STRIP: &str = "#f6c9a8";
/// Tallest drawing.
const TALLEST: f64 = 330.0;

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
    let (_, view) = fit(extent, top + 6.0, TALLEST);
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
pub(crate) fn dimension(sheet: &mut Sheet, from: Spot, to: Spot, up: f64) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::across::cross_section;
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
            edges: Default::default(),
            defects: Vec::new(),
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
