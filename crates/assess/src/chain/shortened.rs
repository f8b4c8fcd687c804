//! Uniform loads that may be shorter are shortened: of every length, and of every part of the strip, the one with the least factor counts.
//!
//! Standards put a uniform load on the adverse parts of a bridge alone (EN 1991-2, 4.3.2; BS 5400-2, 6.2.1): an arch is held by what stands
//! on its far side. Parts are sought on rigid blocks, with all positions; the one that is found goes the way of the file's own loads.

use crate::analysis::state::{self, Change};
use crate::analysis::{self, AnalysisError, Places};
use bridge::{Bridge, LoadKind, Method};
use mechanics::watch::Watch;
use outcome::facts::ShortenedFacts;

/// Lengths that are tried over the shortest span, and positions over it meanwhile.
const LENGTHS: f64 = 24.0;
const POSITIONS: f64 = 30.0;
/// Most lengths, and most cuts of a strip beside other loads.
const MOST: usize = 48;
const CUTS: usize = 8;
/// A part counts where it takes so much off the factor: less is the search's own step.
const TELLS: f64 = 1e-3;

/// A part of a strip: how far its middle lies to the right of the strip's, and its length [m].
type Part = (f64, f64);

/// The bridge with a part of a strip as its load.
fn with(bridge: &Bridge, load: usize, (shift, length): Part) -> Bridge {
    let mut own = bridge.clone();
    let one = &mut own.loads[load];
    one.position += shift;
    if let LoadKind::Patch { length: own, .. } = &mut one.kind {
        *own = length;
    }
    own
}

/// The bridge with its strips as they were shortened.
pub(super) fn as_shortened(bridge: &Bridge, parts: &[ShortenedFacts]) -> Bridge {
    let known = |part: &&ShortenedFacts| bridge.loads.get(part.load).is_some_and(|load| !load.whole_length);
    let one = |own: Bridge, part: &ShortenedFacts| with(&own, part.load, (part.shift_m, part.length_m));
    parts.iter().filter(known).fold(bridge.clone(), one)
}

/// Parts of a strip that are tried: shorter ones about its middle where it moves over the bridge by itself, and every run of pieces where
/// other loads keep their distance from it.
fn parts(length: f64, span: f64, alone: bool) -> Vec<Part> {
    if alone {
        let count = (length / span * LENGTHS).ceil().clamp(1.0, MOST as f64) as usize;
        // Strips longer than a few spans: the lengths that tell are those near a span.
        let longest = length.min(2.0 * span);
        return (1..=count).map(|k| (0.0, longest * k as f64 / count as f64)).collect();
    }
    let piece = length / CUTS as f64;
    let runs = (0..CUTS).flat_map(|a| (a + 1..=CUTS).map(move |b| (a as f64, b as f64)));
    runs.map(|(a, b)| (0.5 * (a + b) * piece - 0.5 * length, (b - a) * piece)).collect()
}

/// The least factor over all positions; none where a position was not answered or the work stopped.
fn least(bridge: &Bridge, span: f64, watch: &mut dyn Watch) -> Result<Option<f64>, AnalysisError> {
    let sweep = analysis::sweep(bridge, Places::Every(span / POSITIONS), true, watch)?;
    Ok(sweep.worst().filter(|_| sweep.whole).and_then(|worst| worst.bound()))
}

/// The parts of the bridge's strips that do most harm, where they do more than the whole strips.
pub(super) fn shortened(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Vec<ShortenedFacts>, AnalysisError> {
    let mut own = state::with(bridge, &[Change::FillAsWeight, Change::Method(Method::Limit)]);
    let span = own.spans.iter().map(|span| span.span).fold(f64::INFINITY, f64::min);
    let mut found = Vec::new();
    for load in 0..own.loads.len() {
        let LoadKind::Patch { length, .. } = own.loads[load].kind else { continue };
        if own.loads[load].whole_length {
            continue;
        }
        let Some(whole) = least(&own, span, watch)? else { return Ok(found) };
        let alone = own.loads.len() == 1;
        let mut best: (f64, Part) = (whole, (0.0, length));
        let mut tried = parts(length, span, alone);
        // Between the lengths beside the best one, once more.
        for refined in [false, true] {
            if refined {
                let step = tried.first().map_or(length, |part| part.1);
                let around = [-0.5, -0.25, 0.25, 0.5].map(|share| (best.1.0, best.1.1 + share * step));
                tried = around.into_iter().filter(|part| alone && part.1 > 0.0 && part.1 < length).collect();
            }
            for part in &tried {
                match least(&with(&own, load, *part), span, watch)? {
                    Some(factor) if factor < best.0 => best = (factor, *part),
                    Some(_) => {}
                    None => return Ok(found),
                }
            }
        }
        if best.0 < whole * (1.0 - TELLS) {
            own = with(&own, load, best.1);
            let name = own.loads[load].name.clone();
            found.push(ShortenedFacts { load, name, of_m: length, length_m: best.1.1, shift_m: best.1.0 });
        }
    }
    Ok(found)
}
