//! Vehicles answered on rigid blocks: what the search over everything that may stand at every position says of each.

use super::super::engine::rigid;
use super::super::moving::{Found, Key, Line, Place, Scene, Watched, WithoutDilation, search, watched};
use super::super::parallel;
use super::AnalysisError;
use super::cases::{asked_apart, drives, reach};
use super::factored::Footprint;
use super::seeds::seeds;
use super::standing::Standing;
use super::traffic::Traffic;
use crate::vehicles::Chosen;
use mechanics::limit::{self, Ground};
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::vehicles::Weights;
use outcome::vehicles::{Case, EnvelopePoint, Swept};

/// Answers every case of every vehicle under every combination of factors on weights, with or without cases left out by a `screen`.
/// Where the onlooker wishes to stop, vehicles that were not finished say so.
pub(super) fn all(
    traffic: &Traffic<'_>,
    (step, screen): (f64, bool),
    watch: &mut dyn Watch,
) -> Result<Vec<Swept>, AnalysisError> {
    let Traffic { vehicles, weights, feet, twins, .. } = traffic;
    let (bridge, d) = (&traffic.bridges[0], &traffic.built[0]);
    let settings = limit::Settings { friction: limit::Friction::Associated, ..rigid::settings(bridge) };
    let mut grounds = Vec::with_capacity(traffic.built.len());
    for d in &traffic.built {
        grounds.push(Ground::new(&d.model, &d.loading, &settings)?);
    }
    if let Some(falls) = grounds.iter().position(|ground| !ground.stands()) {
        return Ok(vehicles.iter().zip(feet).map(|(v, foot)| fallen(v, foot, weights[falls])).collect());
    }
    let watched = watched(bridge, d, &grounds[0]);
    let own = |(k, foot): (usize, &Footprint)| drives(k, &vehicles[k].vehicle, traffic.plan, reach(d, foot), step);
    let all_drives = feet.iter().enumerate().flat_map(own).collect();
    let seeds = match screen && !grounds[0].is_fast() {
        true => parallel::alone("mechanisms to begin with", false, watch, |token| {
            seeds(bridge, d, &grounds[0], &feet[0], token)
        }),
        false => Vec::new(),
    };
    let standing = Standing::new((bridge, d), weights, feet.clone(), all_drives);
    let (seeds, without_dilation) = (&seeds[..], WithoutDilation::InTurn(asked_apart(bridge, step)));
    let scene = Scene { stands: &standing, grounds: &grounds, watched: &watched, screen, seeds, without_dilation };
    let lines = standing.drives.iter().map(|drive| {
        let (vehicle, positions) = (drive.vehicle, &drive.positions[..]);
        Line { vehicle, positions, alike: twins[vehicle].is_some() }
    });
    let lines: Vec<Line<'_>> = lines.collect();
    let found = search(&scene, (&lines, vehicles.len()), step, watch);
    let telling = Telling { standing: &standing, watched: &watched, capacity: traffic.rule.capacity_factor() };
    let mut swept: Vec<Swept> = Vec::with_capacity(vehicles.len());
    for (k, found) in found.into_iter().enumerate() {
        let own = match twins[k] {
            Some(twin) => telling.like(&swept[twin.of], twin.times, &vehicles[k], &feet[k], found),
            None => telling.swept(&vehicles[k], &feet[k], found),
        };
        swept.push(own);
    }
    Ok(swept)
}

/// What was found of vehicles, with the factor on what a bridge carries.
struct Telling<'a> {
    standing: &'a Standing,
    watched: &'a [Watched],
    capacity: f64,
}

impl Telling<'_> {
    /// What came of a vehicle. An adequacy factor stands only where every position was answered and the worst one sought.
    fn swept(&self, chosen: &Chosen, foot: &Footprint, found: Found) -> Swept {
        let mut swept = blank(chosen, foot);
        swept.envelope = found.places.iter().map(|place| self.answered(place)).collect();
        (swept.cases, swept.by_interior_point) = (found.cases, found.slow);
        swept.sections = found.extremes.told(self.watched, |key| self.standing.told(key));
        swept.bounds = found.worst.map(|worst| [worst.factor, worst.upper].map(|f| f * self.capacity));
        let mut least = found.worst.map(|worst| (worst.factor * self.capacity, worst.key));
        for (key, factor) in found.level {
            let level = factor.map(|level| level * self.capacity);
            swept.slides_at(&self.point(&key), level);
            if let Some(adequacy) = level {
                swept.without_dilation = Some(swept.without_dilation.map_or(adequacy, |old| old.min(adequacy)));
                if least.is_none_or(|(least, _)| adequacy < least) {
                    least = Some((adequacy, key));
                }
            }
        }
        swept.weights = least.map(|(_, governing)| self.standing.weights[governing.weights]);
        swept.case = least.map(|(_, governing)| self.standing.told(&governing));
        swept.end(found.whole, least.map(|(least, _)| least));
        swept
    }

    /// A vehicle whose loads are so many times those of one that was answered: the same cases govern, by factors that are so many
    /// times smaller. What its loads do to the watched joints is its own.
    fn like(&self, of: &Swept, times: f64, chosen: &Chosen, foot: &Footprint, found: Found) -> Swept {
        let less = |factor: Option<f64>| factor.map(|factor| factor / times);
        Swept {
            status: if found.whole { of.status } else { Status::Cancelled },
            adequacy: less(of.adequacy).filter(|_| found.whole),
            adequacy_at_most: less(of.adequacy_at_most.or(of.adequacy.filter(|_| !found.whole))),
            positions_not_converged: of.positions_not_converged,
            bounds: of.bounds.map(|both| both.map(|bound| bound / times)),
            without_dilation: less(of.without_dilation),
            case: of.case.clone().map(|case| Case { load: case.load * times, ..case }),
            weights: of.weights,
            envelope: of
                .envelope
                .iter()
                .map(|point| EnvelopePoint { adequacy: less(point.adequacy), ..point.clone() })
                .collect(),
            sections: found.extremes.told(self.watched, |key| self.standing.told(key)),
            by_interior_point: of.by_interior_point,
            ..blank(chosen, foot)
        }
    }

    /// A place in the envelope. One with cases without an answer is answered by what is proven to be carried, where that does not govern.
    fn answered(&self, place: &Place) -> EnvelopePoint {
        let least = place.least.filter(|_| place.open.is_empty()).map(|least| least.factor);
        let governs = place.least.map_or(place.at, |least| least.key);
        EnvelopePoint {
            converged: place.open.is_empty() || place.settled.is_some(),
            adequacy: least.or(place.settled).map(|factor| factor * self.capacity),
            weights: place.least.map(|least| self.standing.weights[least.key.weights]),
            ..self.point(&governs)
        }
    }

    /// A case's place in the envelope, without its factor.
    fn point(&self, key: &Key) -> EnvelopePoint {
        EnvelopePoint::at(self.standing.placed(key))
    }
}

/// A vehicle of which nothing is known yet.
fn blank(chosen: &Chosen, foot: &Footprint) -> Swept {
    Swept {
        code: chosen.vehicle.code.clone(),
        title: chosen.vehicle.title.clone(),
        model: chosen.model.clone(),
        grade: chosen.grade.clone(),
        status: Status::Locks,
        adequacy: None,
        adequacy_at_most: None,
        positions_not_converged: 0,
        bounds: None,
        without_dilation: None,
        case: None,
        weights: None,
        envelope: Vec::new(),
        sections: Vec::new(),
        effective_width: foot.across.axles,
        across: foot.across.clone(),
        load_factors: [foot.all(), foot.critical],
        span_factors: foot.spans.iter().map(|span| span.axles).collect(),
        acting: chosen.acting.clone(),
        source: chosen.source.clone(),
        cases: 0,
        by_interior_point: 0,
        rigid: None,
        deformable: None,
        not_counted: Default::default(),
    }
}

/// A vehicle over a bridge that does not carry its own weight with these factors.
fn fallen(chosen: &Chosen, foot: &Footprint, weights: Weights) -> Swept {
    Swept { status: Status::UnstableUnderSelfWeight, weights: Some(weights), ..blank(chosen, foot) }
}
