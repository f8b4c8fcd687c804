//! What the strips that longitudinal cracks leave of a barrel carry.
//!
//! A crack through the barrel is an edge of it: a wheel loads the strip that it stands on, and what would spread beyond the crack is
//! missing. A wheel over a crack is shared by the width of its tyre on either side. Every place of the vehicles across the bridge is
//! tried; of the strips the one with the largest force per metre of width counts.

use rules::{EffectiveWidth, Rule};

/// Lines of wheels or of rails across the bridge, of all vehicles abreast.
#[derive(Debug, Clone)]
pub(super) struct Lines {
    /// Where each is, from the middle of the first vehicle [m], and its share of the force of that vehicle's axle.
    pub lines: Vec<(f64, f64)>,
    /// Half the width on which one stands [m].
    pub contact: f64,
    /// How far the load of one has spread to either side [m].
    pub overhang: f64,
    /// Most width that all carry together [m].
    pub most: f64,
    /// Least distance of a line from an edge of the barrel [m].
    pub from_edge: f64,
}

/// The strip that is loaded most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Loaded {
    /// From one edge of the barrel [m].
    pub strip: [f64; 2],
    /// Where the middle of the first vehicle stands [m].
    pub middle: f64,
    /// Whether vehicles stand the other way round.
    pub mirrored: bool,
    /// Width that would carry the axle of the first vehicle with the same force per metre [m].
    pub width: f64,
}

/// The strip that is loaded most, and how.
pub(super) fn most_loaded(rule: &Rule, barrel: f64, strips: &[[f64; 2]], lines: &Lines) -> Option<Loaded> {
    let mirrored = Lines { lines: lines.lines.iter().map(|(at, share)| (-at, *share)).collect(), ..lines.clone() };
    let all = [(lines, false), (&mirrored, true)].into_iter().flat_map(|(lines, turned)| {
        let places = places(barrel, strips, lines);
        let of = move |strip: [f64; 2], middle: f64| Loaded {
            strip,
            middle,
            mirrored: turned,
            width: carried(rule, strip, lines, middle),
        };
        strips.iter().flat_map(move |strip| places.clone().into_iter().map(move |middle| of(*strip, middle)))
    });
    all.filter(|one| one.width.is_finite()).min_by(|a, b| a.width.total_cmp(&b.width))
}

/// Places of the first vehicle between which the load of a strip changes evenly: those where a tyre or the middle of a line comes to a border.
fn places(barrel: f64, strips: &[[f64; 2]], lines: &Lines) -> Vec<f64> {
    let edge = lines.from_edge.min(0.5 * barrel);
    let ends = |pick: fn(f64, f64) -> f64, from: f64| lines.lines.iter().map(|line| line.0).fold(from, pick);
    let (low, high) = (edge - ends(f64::min, f64::INFINITY), barrel - edge - ends(f64::max, f64::NEG_INFINITY));
    if low >= high {
        return vec![0.5 * (low + high)];
    }
    let borders: Vec<f64> = strips.iter().flatten().copied().collect();
    let mut places = vec![low, high];
    for (at, _) in &lines.lines {
        for border in &borders {
            let near = [-lines.overhang, -lines.contact, -1e-6, 1e-6, lines.contact, lines.overhang];
            places.extend(near.map(|beside| border - at + beside));
        }
    }
    places.retain(|place| (low..=high).contains(place));
    places
}

/// Width that would carry the first vehicle's axle with the force per metre that the strip has; infinite where nothing stands on it.
fn carried(rule: &Rule, [from, to]: [f64; 2], lines: &Lines, middle: f64) -> f64 {
    let on = |at: f64, half: f64| ((at + half).min(to) - (at - half).max(from)).max(0.0);
    let stand: Vec<(f64, f64)> = lines.lines.iter().map(|(at, share)| (middle + at, *share)).collect();
    let load: f64 = stand.iter().map(|(at, share)| share * on(*at, lines.contact) / (2.0 * lines.contact)).sum();
    if load < 1e-9 {
        return f64::INFINITY;
    }
    let inside = |at: f64| at > from && at < to;
    let some_inside = stand.iter().any(|(at, _)| inside(*at));
    let of_them = stand
        .iter()
        .map(|line| line.0)
        .filter(|at| if some_inside { inside(*at) } else { on(*at, lines.contact) > 0.0 });
    let mut bands: Vec<[f64; 2]> =
        of_them.map(|at| [(at - lines.overhang).max(from), (at + lines.overhang).min(to)]).collect();
    bands.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let zone = match &rule.effective_width {
        EffectiveWidth::Barrel { .. } => to - from,
        EffectiveWidth::Fixed { width_m, .. } => width_m.min(to - from),
        // Strips of rails carry beside one another; wheels of an axle with what lies between them.
        EffectiveWidth::Dispersed { .. } if rule.dispersal.strip_at_most_m.is_some() => union(&bands),
        EffectiveWidth::Dispersed { .. } => bands.last().map_or(0.0, |last| last[1]) - bands[0][0],
    };
    zone.min(lines.most).max(1e-3) / load
}

/// Length that sorted stretches cover together.
fn union(bands: &[[f64; 2]]) -> f64 {
    let mut reached = f64::NEG_INFINITY;
    bands
        .iter()
        .map(|[from, to]| {
            let fresh = (to - from.max(reached)).max(0.0);
            reached = reached.max(*to);
            fresh
        })
        .sum()
}
