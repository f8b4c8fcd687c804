//! The line of thrust inside the ring.

use crate::discs;
use crate::elevation::{self as draw, INK, Sign, THRUST};
use crate::geometry::{View, as_built};
use crate::mechanism::mark_hinges;
use crate::sheet::place::Room;
use crate::sheet::{Area, Pen, Sheet, Style, THICK};
use crate::{soil, words};
use outcome::picture::{Picture, Point, ThrustPoint};

/// The ring with its line of thrust, hinges, loads, and the size of the thrust at springings and crown. None
/// without a line of thrust.
pub fn thrust_line(picture: &Picture) -> Option<String> {
    if !picture.thrust_lines.iter().any(|line| drawable(&line)) {
        return None;
    }
    let built = as_built(&picture.shapes)?;
    // Discrete elements are in equilibrium at the last stable load; limit analysis at collapse itself.
    let at_rest = picture.last_stable.and_then(|k| picture.snapshots.get(k)).map(|s| s.load);
    let second = match (at_rest, draw::collapse_load(picture)) {
        _ if picture.moves_supports => "Line of thrust".to_string(),
        _ if soil::of(picture).is_some() => "Line of thrust at the lower bound of the load".to_string(),
        (Some(rest), Some(collapse)) if rest < collapse => {
            format!("Line of thrust at the last stable load, {}", words::force(rest))
        }
        (_, Some(load)) => format!("Line of thrust at collapse, {}", words::force(load)),
        _ => "Line of thrust".to_string(),
    };
    let (mut sheet, top) = draw::heading("thrust", picture, &second);
    let extent = soil::around(draw::extent(picture).unwrap_or(built), picture, 0.0);
    let (frame, view) = draw::fit(extent, top + soil::above(picture), draw::TALLEST);
    discs::pale(&mut sheet, &view, picture, None);
    soil::behind(&mut sheet, &view, extent, picture);
    draw::blocks(&mut sheet, &view, &picture.shapes, |k| picture.shapes[k].outline.clone());
    draw::avoid_blocks(&mut sheet, &view, &picture.shapes, |k| picture.shapes[k].outline.clone());
    draw::surface(&mut sheet, &view, picture, draw::FAINT);
    draw::load_arrows(&mut sheet, &view, picture, None);
    soil::plates(&mut sheet, &view, picture, 0.0);
    lines(&mut sheet, &view, picture);

    let room = Room::between(top, frame.bottom + 20.0);
    let middle = [0.5 * (built.low[0] + built.high[0]), 0.5 * (built.low[1] + built.high[1])];
    let hinges: Vec<_> = picture.hinges.iter().map(|h| (*h, h.point)).collect();
    let at_hinge = |p: Point| {
        let (a, d) = (view.spot(p), |b: [f64; 2], a: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]));
        hinges.iter().any(|h| d(view.spot(h.1), a) < 6.0)
    };
    for line in picture.thrust_lines.iter().filter(drawable) {
        for k in told(line) {
            let at = view.spot(line[k].point);
            if !at_hinge(line[k].point) {
                sheet.circle(at, 2.8, Pen::shape(THRUST, INK, 0.6).class("thrust-mark"));
            }
            sheet.avoid(Area::about(at, 5.0));
        }
    }
    mark_hinges(&mut sheet, &picture.shapes, &view, &hinges, middle, room);
    let groups = groups(picture);
    for group in &groups {
        magnitudes(&mut sheet, &view, group, room);
    }

    let mut y = draw::scale_bar(&mut sheet, &view, frame.bottom + 26.0);
    let words = match groups.iter().any(|group| group.len() > 1) {
        true => "line of thrust, with its force where marked, of the upper ring above that of the lower",
        false => "line of thrust, with its force where marked",
    };
    let entries = [
        (Sign::Thrust, words, true),
        (Sign::Hinge, "hinge", !hinges.is_empty()),
        (Sign::Load, "load", soil::any_load(picture)),
    ];
    y = draw::key(&mut sheet, y + 2.0, &entries);
    if !picture.loads.is_empty() && picture.particles.is_empty() {
        y = sheet.caption(y, draw::LOAD_WORDS);
    }
    Some(sheet.finish(y))
}

/// Whether a line has points enough.
fn drawable(line: &&Vec<ThrustPoint>) -> bool {
    line.len() > 1
}

/// The lines of thrust themselves.
pub(crate) fn lines(sheet: &mut Sheet, view: &View, picture: &Picture) {
    sheet.open("thrust-lines");
    for line in picture.thrust_lines.iter().filter(drawable) {
        let points: Vec<Point> =
            line.iter().map(|t| t.point).filter(|p| p[0].is_finite() && p[1].is_finite()).collect();
        let spots = view.spots(&points);
        sheet.polyline(&spots, Pen::line(THRUST, THICK).class("thrust"));
        // Short enough that the rectangles around its parts hug the line.
        spots.windows(2).filter_map(Area::around).for_each(|a| sheet.avoid(a.grown(2.0)));
    }
    sheet.close();
}

/// Lines of thrust of which labels do not keep clear.
pub(crate) fn plain(sheet: &mut Sheet, view: &View, lines: &[Vec<ThrustPoint>], pen: Pen) {
    sheet.open("thrust-lines");
    for line in lines {
        let points: Vec<Point> = line.iter().map(|at| at.point).collect();
        sheet.polyline(&view.spots(&points), pen.class("thrust"));
    }
    sheet.close();
}

/// Whether a line rises more than it runs: that of a pier.
fn upright(line: &[ThrustPoint]) -> bool {
    let (a, b) = (line[0].point, line[line.len() - 1].point);
    (b[1] - a[1]).abs() > (b[0] - a[0]).abs()
}

/// Where the size of the thrust is told: at the first and last joint, and nearest to the middle between them; of a pier at its foot.
fn told(line: &[ThrustPoint]) -> Vec<usize> {
    if upright(line) {
        return vec![0];
    }
    let last = line.len() - 1;
    let middle = 0.5 * (line[0].point[0] + line[last].point[0]);
    let off = |k: usize| (line[k].point[0] - middle).abs();
    let crown = (1..last).min_by(|&a, &b| off(a).total_cmp(&off(b)).then(a.cmp(&b)));
    [Some(0), Some(last), crown].into_iter().flatten().collect()
}

/// Lines of thrust that are told together: those of the rings of one span, the uppermost first.
fn groups(picture: &Picture) -> Vec<Vec<&[ThrustPoint]>> {
    let mut groups: Vec<Vec<&[ThrustPoint]>> = Vec::new();
    for line in picture.thrust_lines.iter().filter(drawable) {
        let beside = |other: &[ThrustPoint]| {
            let ([from, to], [left, right]) = (ends(line), ends(other));
            !upright(line) && !upright(other) && to.min(right) - from.max(left) > 0.5 * (to - from)
        };
        match groups.iter_mut().find(|group| beside(group[0])) {
            Some(group) => group.push(line),
            None => groups.push(vec![line]),
        }
    }
    for group in &mut groups {
        group.sort_by(|a, b| crown(b).total_cmp(&crown(a)));
    }
    groups
}

/// From where to where a line reaches along the bridge [m].
fn ends(line: &[ThrustPoint]) -> [f64; 2] {
    let (a, b) = (line[0].point[0], line[line.len() - 1].point[0]);
    [a.min(b), a.max(b)]
}

/// Level of a line in the middle of its span [m].
fn crown(line: &[ThrustPoint]) -> f64 {
    told(line).last().map_or(f64::NEG_INFINITY, |&k| line[k].point[1])
}

/// Writes the size of the thrust beside its marks: of several rings under one another, beside the mark of the lowest.
fn magnitudes(sheet: &mut Sheet, view: &View, rings: &[&[ThrustPoint]], room: Room) {
    let Some(lowest) = rings.last() else { return };
    for (n, k) in told(lowest).into_iter().enumerate() {
        // Into the opening: below the crown, and from the springings towards the middle of the span.
        let side = match k {
            _ if upright(lowest) => [1.0, 0.0],
            0 => [0.8, 0.6],
            _ if k + 1 == lowest.len() => [-0.8, 0.6],
            _ => [0.0, 1.0],
        };
        let style = Style { colour: THRUST, ..Style::on_drawing() };
        let forces = rings.iter().filter_map(|ring| told(ring).get(n).map(|&k| words::force(ring[k].thrust)));
        let forces: Vec<String> = forces.collect();
        let texts: Vec<&str> = forces.iter().map(String::as_str).collect();
        sheet.labels(view.spot(lowest[k].point), &texts, style, room.towards(side));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arch(from: f64, level: f64, thrust: f64) -> Vec<ThrustPoint> {
        let at = |k: i32| {
            let t = f64::from(k) / 20.0;
            ThrustPoint { point: [from + 6.0 * t, level + 6.0 * t * (1.0 - t)], thrust }
        };
        (0..=20).map(at).collect()
    }

    #[test]
    fn forces_of_the_rings_of_one_span_are_told_under_one_another_and_those_of_the_next_span_apart() {
        let pier = (0..4).map(|k| ThrustPoint { point: [6.7, -f64::from(k)], thrust: 9e3 }).collect();
        let lines = vec![arch(0.0, 0.0, 1e3), arch(0.1, 0.3, 2e3), arch(7.3, 0.0, 3e3), arch(7.2, 0.3, 4e3), pier];
        let picture = Picture { thrust_lines: lines, ..Picture::default() };
        let told: Vec<Vec<f64>> =
            groups(&picture).iter().map(|group| group.iter().map(|line| line[0].thrust / 1e3).collect()).collect();
        assert_eq!(told, [vec![2.0, 1.0], vec![4.0, 3.0], vec![9.0]]);
    }
}
