//! Whether the parts fit together: blocks that vanish or cross, piers too narrow, covers that end below ground.

use crate::findings::Findings;
use crate::model::{Cover, Joint, Masonry, Pier, Span};
use crate::ring::{Intrados, Station};
use crate::road::Road;
use crate::tree::Table;
use findings::words::counted;

use crate::fields::structure::PlacedSpan;

/// Where the spans lie along the bridge [m].
#[derive(Debug, Clone)]
pub(crate) struct Layout {
    /// Left and right springing of each span.
    pub(crate) spans: Vec<(f64, f64)>,
    /// Level of the left springing of each span above that of the first.
    pub(crate) levels: Vec<f64>,
    /// From the first springing to the last.
    pub(crate) length: f64,
}

impl Layout {
    /// Spans and the widths of the piers between them; a single pier stands for all.
    pub(crate) fn new(spans: &[PlacedSpan], piers: &[Pier]) -> Layout {
        let (mut start, mut level) = (0.0, 0.0);
        let (mut placed, mut levels) = (Vec::new(), Vec::new());
        for (index, span) in spans.iter().enumerate() {
            if index > 0 {
                let pier = piers.get(index - 1).or(piers.last());
                start += pier.map_or(0.0, |pier| pier.width);
                level += pier.map_or(0.0, |pier| pier.step);
            }
            placed.push((start, start + span.span.span));
            levels.push(level);
            start += span.span.span;
            level += span.span.right_springing;
        }
        Layout { spans: placed, levels, length: start }
    }
}

pub(super) fn check(
    file: &Table<'_>,
    spans: &[PlacedSpan],
    piers: &[Pier],
    (masonry, joint): (Option<&Masonry>, Option<&Joint>),
    cover: Option<&Cover>,
    findings: &mut Findings,
) {
    let mut seen = Vec::new();
    let mut skewbacks = Vec::new();
    for placed in spans {
        // Spans whose profile has no curve have been reported, and are not here.
        let Ok(intrados) = placed.span.intrados() else { return };
        skewbacks.push([intrados.at(0.0), intrados.at(1.0)]);
        // Repeated spans are checked once.
        if !seen.contains(&placed.shape) {
            seen.push(placed.shape);
            rings(file, placed, &intrados, masonry, joint, findings);
        }
    }
    check_piers(file, spans, piers, &skewbacks, findings);
    check_backing(file, spans, piers, cover, findings);
}

/// Every voussoir must be a block: its two joints must not cross, and rounding must leave a face.
fn rings(
    file: &Table<'_>,
    placed: &PlacedSpan,
    intrados: &Intrados,
    masonry: Option<&Masonry>,
    joint: Option<&Joint>,
    findings: &mut Findings,
) {
    let span = &placed.span;
    let (mut crown, mut springing) = (0.0, 0.0);
    for (ring, (thickness_place, count_place)) in span.rings.iter().zip(&placed.rings) {
        let inside = [springing, crown];
        crown += ring.crown_thickness;
        springing += ring.springing_thickness;
        let thinnest = ring.crown_thickness.min(ring.springing_thickness);
        let thickest = ring.crown_thickness.max(ring.springing_thickness);
        if thickest > 0.5 * span.span {
            findings.error(
                "B205",
                *thickness_place,
                "the ring is thicker than half its span",
                format!("half the span is {} m", 0.5 * span.span),
                "check number and unit; rings are usually a tenth to a thirtieth of the span",
            );
            continue;
        }
        let shortest = shortest_edge(intrados, ring.voussoirs, inside, [springing, crown]);
        if shortest <= 0.0 {
            findings.error(
                "B206",
                *count_place,
                "joints of neighbouring voussoirs cross",
                "the curve bends towards the extrados too sharply for this thickness",
                "use fewer voussoirs or a thinner ring, or check the measured points",
            );
            continue;
        }
        if let Some(masonry) = masonry {
            // Rounded corners at both ends must leave some straight face between them.
            if 2.0 * masonry.rounding >= thinnest {
                findings.error(
                    "B207",
                    file.place_in("masonry", "rounding"),
                    "rounded corners leave nothing of the joint",
                    format!("twice this is no less than the thinnest joint, {thinnest} m"),
                    "give a smaller `rounding` in [masonry]; a fiftieth of the thickness is common",
                );
            } else if 2.0 * masonry.rounding >= shortest {
                findings.error(
                    "B207",
                    file.place_in("masonry", "rounding"),
                    "rounded corners are longer than the voussoirs",
                    format!("twice this is no less than the shortest edge, {shortest:.4} m"),
                    "use fewer voussoirs, or a smaller `rounding` in [masonry]",
                );
            }
        }
        if let Some(length) = joint.and_then(|joint| joint.fixed_length)
            && length > thinnest
        {
            findings.error(
                "B208",
                file.place_in("joint", "fixed_length"),
                "a contact point represents more than the whole joint",
                format!("the thinnest joint has {thinnest} m"),
                "give a `fixed_length` in [joint] of about half the thickness, or leave it out",
            );
        }
        if let Some(length) = joint.and_then(|joint| joint.least_length)
            && length > thinnest
        {
            findings.error(
                "B208",
                file.place_in("joint", "least_length"),
                "the least length of a contact point is more than the whole joint",
                format!("the thinnest joint has {thinnest} m"),
                "give a `least_length` in [joint] of about a tenth of the thickness, or leave it out",
            );
        }
    }
}

/// The shortest edge of any voussoir along the curve; not positive where two joints cross. Thicknesses below and
/// above the ring at springing and crown.
fn shortest_edge(intrados: &Intrados, voussoirs: usize, inside: [f64; 2], outside: [f64; 2]) -> f64 {
    let station = |index: usize| {
        let share = index as f64 / voussoirs as f64;
        let crownward = 1.0 - (2.0 * share - 1.0).abs();
        let at = |ends: [f64; 2]| ends[0] + (ends[1] - ends[0]) * crownward;
        (intrados.at(share), at(inside), at(outside))
    };
    let mut shortest = f64::INFINITY;
    let mut last = station(0);
    for index in 1..=voussoirs {
        let next = station(index);
        shortest =
            shortest.min(advance(&last.0, last.1, &next.0, next.1)).min(advance(&last.0, last.2, &next.0, next.2));
        last = next;
    }
    shortest
}

/// How far the curve at some distance outwards advances from one station to the next, along their mean tangent.
fn advance(from: &Station, out_from: f64, to: &Station, out_to: f64) -> f64 {
    let (a, b) = (from.offset(out_from), to.offset(out_to));
    let tangent = [from.tangent()[0] + to.tangent()[0], from.tangent()[1] + to.tangent()[1]];
    let size = tangent[0].hypot(tangent[1]);
    ((b[0] - a[0]) * tangent[0] + (b[1] - a[1]) * tangent[1]) / size
}

/// As many piers as gaps between spans, each wide enough for the two skewbacks on it.
fn check_piers(
    file: &Table<'_>,
    spans: &[PlacedSpan],
    piers: &[Pier],
    skewbacks: &[[Station; 2]],
    findings: &mut Findings,
) {
    let needed = spans.len() - 1;
    let places = file.tables("pier", &mut Findings::default());
    if piers.len() != needed && !(piers.len() == 1 && needed > 1) {
        let range = places.first().map_or(spans[spans.len() - 1].shape, |table| table.range);
        let help = match needed {
            0 => "remove [[pier]], or describe the second span with [[span]]".to_owned(),
            1 => "describe the pier with one [[pier]] section".to_owned(),
            _ => format!("describe {needed} piers with [[pier]] sections, or one for all"),
        };
        findings.error(
            "B209",
            range,
            format!("{} need {}, found {}", counted(spans.len(), "span"), counted(needed, "pier"), piers.len()),
            "one pier between every two adjacent spans",
            help,
        );
        return;
    }
    for gap in 0..needed {
        let pier = &piers[gap.min(piers.len() - 1)];
        let table = places.get(gap.min(places.len().saturating_sub(1)));
        // A springing's normal leans away from its span, so the extrados reaches over the pier by this much.
        let [left, right] =
            [reach(&spans[gap].span, &skewbacks[gap][1]), reach(&spans[gap + 1].span, &skewbacks[gap + 1][0])];
        let needed_width = left[0].max(0.0) + (-right[0]).max(0.0);
        if pier.width < needed_width * (1.0 - 1e-9) {
            let range = table.map_or(file.range, |table| table.place("width"));
            findings.error(
                "B210",
                range,
                "the rings on both sides of the pier overlap",
                format!("the two skewbacks need {needed_width:.3} m"),
                format!(
                    "write a width of \"{:.3} m\" or more, or thinner rings at the springings",
                    needed_width + 5e-4
                ),
            );
            break;
        }
        if pier.step != 0.0 && !is_convex(pier, left, right) {
            let room = pier.width - needed_width;
            findings.error(
                "B230",
                table.map_or(file.range, |table| table.place("step")),
                "the top of the pier would be a stair between its two springings",
                format!("its uppermost stone would have a notch: the rings leave {room:.3} m between their backs"),
                "give a smaller `step`, a wider pier, or thinner rings at the springings; a stair is described by its blocks",
            );
            break;
        }
    }
}

/// From the intrados of a springing to the extrados [m].
fn reach(span: &Span, springing: &Station) -> [f64; 2] {
    let thickness: f64 = span.rings.iter().map(|ring| ring.springing_thickness).sum();
    springing.normal.map(|part| part * thickness)
}

/// Whether the uppermost stone of a pier, with both skewbacks as its shoulders, is convex.
fn is_convex(pier: &Pier, left: [f64; 2], right: [f64; 2]) -> bool {
    // Skewbacks from the intrados up, and the line between their upper ends; springings at zero and at the step.
    let across = [left[0] - pier.width - right[0], left[1] - pier.step - right[1]];
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    cross(right, across) > 0.0 && cross(across, [-left[0], -left[1]]) > 0.0
}

/// Backing ends below the road.
fn check_backing(
    file: &Table<'_>,
    spans: &[PlacedSpan],
    piers: &[Pier],
    cover: Option<&Cover>,
    findings: &mut Findings,
) {
    let Some(cover) = cover else { return };
    let Some(backing) = cover.backing else { return };
    let levels = Layout::new(spans, piers).levels;
    let crown = |(placed, level): (&PlacedSpan, &f64)| {
        let span = &placed.span;
        let is_level = span.right_springing == 0.0;
        let rise = if is_level { span.rise } else { span.intrados().map_or(span.rise, |intrados| intrados.highest()) };
        level + rise + span.rings.iter().map(|ring| ring.crown_thickness).sum::<f64>()
    };
    let highest = cover.road.as_ref().map(Road::highest);
    let surface = highest.unwrap_or_else(|| spans.iter().zip(&levels).map(crown).fold(0.0, f64::max) + cover.depth);
    let springing = |(placed, level): (&PlacedSpan, &f64)| level + placed.span.right_springing.max(0.0);
    let springings = spans.iter().zip(&levels).map(springing).fold(f64::NEG_INFINITY, f64::max);
    if backing.height + springings > surface {
        findings.error(
            "B211",
            file.place_in("backing", "height"),
            "the backing is higher than the road",
            format!("the surface is {surface:.3} m above the springings"),
            "give a height from the springings, below the surface",
        );
    }
}
