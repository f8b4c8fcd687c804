//! Courses of bricks on a line of segments.
//!
//! A bed joint runs only where a piece of the least thickness finds room below it; elsewhere the bricks above reach down
//! to the line. Such bricks are cut by plumb joints at every corner of the line that would make them concave, and head
//! joints that fall close to such a cut are left out in its favour. Every piece then holds a square of the least
//! thickness.

use super::{Layout, Piece, Seat, WallError, outline};
use mechanics::plane::{Vec2, vec2};

/// Where a cut may as well be left out, it keeps this multiple of the least thickness from the next one: pieces of the
/// least thickness are left only where corners of the line demand them.
const COMFORT: f64 = 2.0;

/// A stretch of the line on which a course, or a bed, runs.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stretch {
    segment: usize,
    from: f64,
    to: f64,
}

/// What lies below a part of a course.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Below {
    from: f64,
    to: f64,
    /// The segment it reaches down to; none where it lies on a bed.
    segment: Option<usize>,
}

/// The pieces of every course.
pub(super) fn cut(line: &[Seat], layout: &Layout) -> Result<Vec<Piece>, WallError> {
    let mut here: Vec<Stretch> =
        line.iter().enumerate().map(|(segment, s)| Stretch { segment, from: s.left.x, to: s.right.x }).collect();
    let corners = line.iter().flat_map(|s| [s.left, s.right]);
    if let Some(highest) = corners.max_by(|a, b| a.y.total_cmp(&b.y))
        && layout.top - highest.y < layout.least
    {
        return Err(WallError::Low { x: highest.x, height: layout.top - highest.y, least: layout.least });
    }
    let mut pieces = Vec::new();
    for (course, &top) in layout.beds.iter().enumerate() {
        let bed = layout.beds.get(course + 1).copied().unwrap_or(f64::NEG_INFINITY);
        let next = with_room(line, &here, bed, layout.least);
        for run in runs(&here, line) {
            course_pieces(line, [&run, &next], [bed, top], course, layout, &mut pieces)?;
        }
        if next.is_empty() {
            break;
        }
        here = next;
    }
    Ok(pieces)
}

/// Parts of `above` where the least piece finds room between the bed at `level` and the line.
fn with_room(line: &[Seat], above: &[Stretch], level: f64, least: f64) -> Vec<Stretch> {
    let mut found: Vec<Stretch> = Vec::new();
    for stretch in above {
        let segment = &line[stretch.segment];
        let room = |x: f64| level - segment.at(x) - least;
        let (left, right) = (room(stretch.from), room(stretch.to));
        let kept = match (left >= 0.0, right >= 0.0) {
            (true, true) => *stretch,
            (false, false) => continue,
            // What is left beside the end must be wide enough for a piece of the course above.
            (true, false) => {
                let end = stretch.from + (stretch.to - stretch.from) * left / (left - right);
                Stretch { to: end.min(stretch.to - COMFORT * least), ..*stretch }
            }
            (false, true) => {
                let end = stretch.to - (stretch.to - stretch.from) * right / (right - left);
                Stretch { from: end.max(stretch.from + COMFORT * least), ..*stretch }
            }
        };
        if kept.to - kept.from >= COMFORT * least || (left >= 0.0 && right >= 0.0) {
            found.push(kept);
        }
    }
    // Pits too narrow for a piece are filled from above.
    let narrow: Vec<Vec<Stretch>> = runs(&found, line);
    narrow.into_iter().filter(|run| run[run.len() - 1].to - run[0].from >= least).flatten().collect()
}

/// Stretches that follow one another without a gap.
fn runs(stretches: &[Stretch], line: &[Seat]) -> Vec<Vec<Stretch>> {
    let whole = |a: &Stretch, b: &Stretch| {
        b.segment == a.segment + 1 && a.to == line[a.segment].right.x && b.from == line[b.segment].left.x
    };
    stretches.chunk_by(whole).map(<[Stretch]>::to_vec).collect()
}

/// What lies below a run of a course: its own bed where there is a course below, the line elsewhere.
fn below(run: &[Stretch], next: &[Stretch]) -> Vec<Below> {
    let mut parts: Vec<Below> = Vec::new();
    for stretch in run {
        let bed = next.iter().find(|n| n.segment == stretch.segment && n.from >= stretch.from && n.to <= stretch.to);
        let (from, to) = bed.map_or((stretch.to, stretch.to), |bed| (bed.from, bed.to));
        for (from, to, segment) in
            [(stretch.from, from, Some(stretch.segment)), (from, to, None), (to, stretch.to, Some(stretch.segment))]
        {
            if to <= from {
                continue;
            }
            match parts.last_mut() {
                Some(last) if last.segment.is_none() && segment.is_none() => last.to = to,
                _ => parts.push(Below { from, to, segment }),
            }
        }
    }
    parts
}

/// Whether a piece may not reach across the border between two parts.
fn divides(a: &Below, b: &Below, line: &[Seat]) -> bool {
    match (a.segment, b.segment) {
        (Some(i), Some(j)) => {
            let jump = (line[i].at(a.to) - line[j].at(b.from)).abs() > 1e-9;
            // A corner that points up makes a piece above it concave.
            jump || line[j].slope() < line[i].slope() - 1e-12
        }
        _ => true,
    }
}

fn course_pieces(
    line: &[Seat],
    [run, next]: [&[Stretch]; 2],
    [bed, top]: [f64; 2],
    course: usize,
    layout: &Layout,
    pieces: &mut Vec<Piece>,
) -> Result<(), WallError> {
    let parts = below(run, next);
    let mut cuts = vec![parts[0].from];
    cuts.extend(parts.windows(2).filter(|p| divides(&p[0], &p[1], line)).map(|p| p[0].to));
    cuts.push(parts[parts.len() - 1].to);
    if let Some(pair) = cuts.windows(2).find(|pair| pair[1] - pair[0] < layout.least * (1.0 - 1e-9)) {
        let (x, width) = (0.5 * (pair[0] + pair[1]), pair[1] - pair[0]);
        return Err(WallError::Sliver { x, y: top, width, least: layout.least });
    }
    head_joints(&mut cuts, course, layout);
    for pair in cuts.windows(2) {
        let mut corners = Vec::new();
        for part in parts.iter().filter(|p| p.to > pair[0] + 1e-12 && p.from < pair[1] - 1e-12) {
            for x in [part.from.max(pair[0]), part.to.min(pair[1])] {
                corners.push(vec2(x, part.segment.map_or(bed, |k| line[k].at(x))));
            }
        }
        corners.extend([vec2(pair[1], top), vec2(pair[0], top)] as [Vec2; 2]);
        pieces.push(Piece { outline: outline(corners)?, course: Some(course) });
    }
    Ok(())
}

/// Adds the head joints of a course that keep their distance from every other cut.
fn head_joints(cuts: &mut Vec<f64>, course: usize, layout: &Layout) {
    let shift = if course % 2 == 1 { layout.bond } else { 0.0 };
    let origin = layout.head_joint + shift * layout.length;
    let (first, last) = (cuts[0], cuts[cuts.len() - 1]);
    let mut k = ((first - origin) / layout.length).floor();
    while origin + k * layout.length < last {
        let x = origin + k * layout.length;
        let at = cuts.partition_point(|&c| c < x);
        if at > 0
            && at < cuts.len()
            && x - cuts[at - 1] >= COMFORT * layout.least
            && cuts[at] - x >= COMFORT * layout.least
        {
            cuts.insert(at, x);
        }
        k += 1.0;
    }
}
