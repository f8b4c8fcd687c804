//! Loose lines, arcs and open polylines chained into closed outlines, where their ends meet within the gap tolerance.

use crate::Point;
use crate::entities::Strand;
use crate::finding::{Findings, Place};
use crate::options::Options;
use crate::outline::COINCIDE;
use findings::words::counted;
use std::collections::{BTreeMap, BTreeSet};

/// One end of a strand: its number, and whether it is the last point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct End {
    strand: usize,
    last: bool,
}

/// Area between an open line and its chord over the square of its length below which it is a line, as of a level or an arrow, and no outline that lacks
/// a side: of a block ten times as long as thick it is 0.023.
const ENCLOSES: f64 = 0.02;
/// Ends of lines nearer than this many tolerances, and than this share of the shorter line, are meant to meet.
const MEANT_TO_MEET: (f64, f64) = (10.0, 0.1);
/// Most open lines of a layer that are looked at in pairs.
const MOST: usize = 1000;

/// What drawn lines are: outlines, and layers of lines that are none, as those of loads and levels.
#[derive(Debug, Default)]
pub(crate) struct Closed {
    pub(crate) outlines: Vec<Strand>,
    pub(crate) lines: BTreeSet<String>,
}

/// A chain of lines with an open end.
struct Open {
    ends: [Point; 2],
    length: f64,
    /// Between it and its chord.
    area: f64,
    place: Place,
}

/// Closed strands: those that are closed already, and what the open ones chain into. An open end is an error, but on a layer of single lines beside
/// a drawing of blocks.
pub(crate) fn close(strands: Vec<Strand>, options: &Options, findings: &mut Findings) -> Closed {
    let (mut outlines, loose): (Vec<Strand>, Vec<Strand>) = strands.into_iter().partition(|s| s.closed);
    let loose: Vec<Strand> = loose.into_iter().filter(|strand| has_length(strand, findings)).collect();
    let partners = partners(&loose, options.gap_tolerance.max(COINCIDE), findings);
    let mut used = vec![false; loose.len()];
    let mut open: BTreeMap<String, Vec<Open>> = BTreeMap::new();
    for first in 0..loose.len() {
        if used[first] {
            continue;
        }
        match follow(first, &loose, &partners, &mut used, findings) {
            Ok(outline) => outlines.extend(outline),
            Err(chain) => open.entry(chain.place.layer.clone()).or_default().push(chain),
        }
    }
    let mut lines = BTreeSet::new();
    for (layer, chains) in open {
        let is_beside = !outlines.is_empty() && outlines.iter().all(|outline| outline.place.layer != layer);
        if is_beside && are_lines(&chains, options) {
            let place = Place { layer: layer.clone(), ..Place::default() };
            let message =
                format!("{} of this layer left out: none encloses anything", counted(chains.len(), "open line"));
            findings.warning("D104", place, message, "draw what is meant to be a block as a closed polyline");
            lines.insert(layer);
        } else {
            chains.into_iter().for_each(|chain| chain.refuse(findings));
        }
    }
    Closed { outlines, lines }
}

/// Whether these go from somewhere to somewhere else, and none was meant to meet another.
fn are_lines(chains: &[Open], options: &Options) -> bool {
    let near = |(k, one): (usize, &Open)| {
        chains[..k].iter().any(|other| {
            let room = (MEANT_TO_MEET.0 * options.gap_tolerance).min(MEANT_TO_MEET.1 * one.length.min(other.length));
            one.ends.iter().any(|a| other.ends.iter().any(|b| distance(*a, *b) < room))
        })
    };
    chains.len() <= MOST
        && chains.iter().all(|chain| chain.area.abs() < ENCLOSES * chain.length.powi(2))
        && !chains.iter().enumerate().any(near)
}

impl Open {
    fn refuse(self, findings: &mut Findings) {
        let [from, to] = self.ends;
        let message = format!(
            "the outline is not closed: it starts at ({:.4}, {:.4}) m and ends here, {:.4} m away",
            from[0],
            from[1],
            distance(from, to)
        );
        let help =
            "close it, or state a larger gap_tolerance; an intrados is drawn as one open line, alone in its drawing";
        findings.error("D301", self.place, message, help);
    }
}

/// Whether these make up one open line, and nothing else.
pub(crate) fn is_one_line(strands: &[Strand], options: &Options) -> bool {
    let partners = partners(strands, options.gap_tolerance.max(COINCIDE), &mut Findings::default());
    !strands.is_empty() && strands.iter().all(|strand| !strand.closed) && 2 * strands.len() == partners.len() + 2
}

/// A line of no length is a duplicate point.
fn has_length(strand: &Strand, findings: &mut Findings) -> bool {
    let first = strand.points[0];
    let long = strand.points.iter().any(|&p| distance(p, first) > COINCIDE);
    if !long {
        findings.note("D201", strand.place.clone(), "a line without length left out");
    }
    long
}

fn point(strands: &[Strand], end: End) -> Point {
    let points = &strands[end.strand].points;
    if end.last { points[points.len() - 1] } else { points[0] }
}

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// For each end the one other end that it meets. Where three and more ends of a layer meet, none has a partner.
fn partners(strands: &[Strand], gap: f64, findings: &mut Findings) -> BTreeMap<End, End> {
    let mut cells: BTreeMap<(&str, i64, i64), Vec<End>> = BTreeMap::new();
    let cell = |p: Point| ((p[0] / gap).floor() as i64, (p[1] / gap).floor() as i64);
    let ends = || (0..strands.len()).flat_map(|strand| [false, true].map(|last| End { strand, last }));
    for end in ends() {
        let (i, j) = cell(point(strands, end));
        cells.entry((&strands[end.strand].place.layer, i, j)).or_default().push(end);
    }
    let mut nearest: BTreeMap<End, End> = BTreeMap::new();
    let mut crowded = Vec::new();
    for end in ends() {
        let at = point(strands, end);
        let (i, j) = cell(at);
        let layer = strands[end.strand].place.layer.as_str();
        let around = (-1..=1).flat_map(|di| (-1..=1).map(move |dj| (di, dj)));
        let mut near: Vec<End> = Vec::new();
        for (di, dj) in around {
            let Some(list) = cells.get(&(layer, i + di, j + dj)) else { continue };
            // More than a few is crowded, however many they are.
            near.extend(list.iter().filter(|&&e| e != end && distance(point(strands, e), at) <= gap).take(4));
        }
        // Ends that coincide go before ends that almost meet.
        let coincides = |e: &End| near.len() == 1 || distance(point(strands, *e), at) <= COINCIDE;
        let nearer: Vec<End> = near.iter().copied().filter(coincides).collect();
        match nearer[..] {
            [one] => drop(nearest.insert(end, one)),
            _ if near.is_empty() => {}
            _ => crowded.push((end, near.len() + 1)),
        }
    }
    let mut said: Vec<Point> = Vec::new();
    for (end, count) in crowded {
        let at = point(strands, end);
        if said.iter().rev().take(64).all(|&p| distance(p, at) > gap) {
            said.push(at);
            let message = format!("{count} or more ends meet here: which belong to one outline cannot be told");
            let help = "draw each block as a closed polyline of its own";
            findings.error("D301", strands[end.strand].place.at(at), message, help);
        }
    }
    let mutual = |(&end, &other): (&End, &End)| (nearest.get(&other) == Some(&end)).then_some((end, other));
    nearest.iter().filter_map(mutual).collect()
}

/// Points of a strand in the direction in which a chain passes it.
fn along(points: &[Point], backwards: bool) -> impl Iterator<Item = Point> {
    let count = points.len();
    (0..count).map(move |k| points[if backwards { count - 1 - k } else { k }])
}

fn length_and_area(points: &[Point]) -> (f64, f64) {
    let start = points[0];
    points.windows(2).fold((0.0, 0.0), |(length, area), pair| {
        let [a, b] = [pair[0], pair[1]].map(|p| [p[0] - start[0], p[1] - start[1]]);
        (length + distance(a, b), area + 0.5 * (a[0] * b[1] - a[1] * b[0]))
    })
}

/// The closed outline that starts with a strand.
///
/// # Errors
/// The chain, where an end stays open.
fn follow(
    first: usize,
    strands: &[Strand],
    partners: &BTreeMap<End, End>,
    used: &mut [bool],
    findings: &mut Findings,
) -> Result<Option<Strand>, Open> {
    // Forwards from the last point; where that ends open, backwards from the first, so that the whole chain is known.
    let mut chain = vec![(first, false)];
    used[first] = true;
    let mut is_closed = false;
    let mut end = End { strand: first, last: true };
    while let Some(&next) = partners.get(&end) {
        if next.strand == first {
            is_closed = true;
            break;
        }
        if used[next.strand] {
            break;
        }
        used[next.strand] = true;
        chain.push((next.strand, next.last));
        end = End { strand: next.strand, last: !next.last };
    }
    if !is_closed {
        let mut start = End { strand: first, last: false };
        while let Some(&before) = partners.get(&start).filter(|before| !used[before.strand]) {
            used[before.strand] = true;
            chain.insert(0, (before.strand, !before.last));
            start = End { strand: before.strand, last: !before.last };
        }
        let ends = [start, end].map(|end| point(strands, end));
        let points = chain.iter().flat_map(|&(number, backwards)| along(&strands[number].points, backwards));
        let (length, area) = length_and_area(&points.collect::<Vec<_>>());
        return Err(Open { ends, length, area, place: strands[end.strand].place.at(ends[1]) });
    }
    let mut outline: Vec<Point> = Vec::new();
    let mut flattened = false;
    for &(number, backwards) in &chain {
        let strand = &strands[number];
        flattened |= strand.flattened;
        let mut points = strand.points.clone();
        if backwards {
            points.reverse();
        }
        join(&mut outline, &points, strand, findings);
    }
    let Some(tail) = outline.pop() else { return Ok(None) };
    let head = outline[0];
    let gap = distance(head, tail);
    if gap > 0.0 {
        outline[0] = middle(head, tail);
        closed_gap(gap, &strands[first], outline[0], findings);
    }
    let place = strands[first].place.clone();
    if chain.len() > 1 {
        findings.note("D205", place.clone(), format!("{} lines and arcs chained into one outline", chain.len()));
    }
    Ok(Some(Strand { place, points: outline, closed: true, flattened }))
}

/// Appends points whose first is the last of the outline so far, or almost.
fn join(outline: &mut Vec<Point>, points: &[Point], strand: &Strand, findings: &mut Findings) {
    let Some(last) = outline.last_mut() else { return outline.extend(points) };
    let gap = distance(*last, points[0]);
    if gap > 0.0 {
        *last = middle(*last, points[0]);
        closed_gap(gap, strand, *last, findings);
    }
    outline.extend(&points[1..]);
}

fn middle(a: Point, b: Point) -> Point {
    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
}

/// Round-off is no gap.
fn closed_gap(gap: f64, strand: &Strand, at: Point, findings: &mut Findings) {
    if gap > COINCIDE {
        let message = format!("a gap of {:.3} mm closed in its middle", 1e3 * gap);
        findings.warning("D204", strand.place.at(at), message, "let the ends meet in the drawing");
    }
}
