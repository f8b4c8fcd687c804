//! Loads in service: the file's train crosses with the axles of each load, and the places that are checked are watched.

use crate::analysis::AnalysisError;
use crate::analysis::passage::{self, PassageError, Scope};
use crate::vehicles::{Refused, Unknown, own_library};
use bridge::Bridge;
use bridge::assess::{Assess, ServiceLoad};
use bridge::passage::{Direction, Face, GAUGE_LENGTH, Sensor, SensorKind, SensorPosition, default_sensors};
use bridge::train::AxleLoads;
use mechanics::watch::Watch;
use outcome::facts::{
    self, AugmentFacts, ChannelFacts, JointFacts, Reading, SectionFacts, ServiceFacts, ServiceLoadFacts,
    SpanAugmentFacts, Watched,
};
use outcome::passage::{Moment, Pair, Passage, PassageStatus, RowKind, SensorRecord};
use structure::discretise::springings::ranges;

/// The coefficients of dynamic augment of the file's rule, span by span: in full, and as a cushion of fill lessens them.
/// Without a rule nothing is added. What stands beside the list of spans is that of the longest. A rule that the library does not have is
/// refused.
fn augment(bridge: &Bridge, asked: &Assess) -> Result<AugmentFacts, Refused> {
    let longest = bridge.spans.iter().map(|span| span.span).fold(0.0, f64::max);
    let length = asked.limits.loaded_length.unwrap_or(longest);
    let cushion = asked.limits.cushion.unwrap_or(bridge.cover.depth).max(0.0);
    let mut facts = AugmentFacts { loaded_length_m: length, cushion_m: cushion, ..AugmentFacts::default() };
    let Some(code) = &asked.limits.rule else {
        facts.source = "none: the file names no rule, and nothing is added to loads at rest".to_owned();
        return Ok(facts);
    };
    let library = own_library()?;
    let rule = library.rule(code).ok_or_else(|| {
        let known: Vec<&str> = library.rules.iter().map(|rule| rule.code.as_str()).collect();
        Unknown::File(format!("there is no rule \"{code}\": write rule in [assess] as one of {}", known.join(", ")))
    })?;
    // The train of a passage is one of its library, or of that kind.
    let Some(impact) = rule.impact_of("trains") else { return Ok(facts) };
    let of = |length: f64| {
        let [all, critical] = impact.factors(length, cushion);
        let design = all * critical - 1.0;
        // Without cover: what the formula gives before anything lessens it.
        let [bare, critical] = impact.factors(length, 0.0);
        [design, impact.total_augment(length).unwrap_or(bare * critical - 1.0)]
    };
    [facts.design, facts.total] = of(length);
    for (k, span) in bridge.spans.iter().enumerate() {
        let loaded_length_m = asked.limits.loaded_length.unwrap_or(span.span);
        let [design, total] = of(loaded_length_m);
        facts.spans.push(SpanAugmentFacts { span: k + 1, loaded_length_m, total, design });
    }
    let say = |source: &rules::Source| format!("{} ({}, {})", source.text, source.date, source.confidence.word());
    let sources: Vec<String> = impact.sources().into_iter().map(say).collect();
    facts.source = format!("{}: {}", rule.title, sources.join("; "));
    Ok(facts)
}

/// The span, from 1, whose loaded length decides what motion adds to an effect on one of them: its own where an axle stands
/// there, else the one among the loaded ones with which motion adds most; its own where none is.
fn loaded(ranges: &[[f64; 2]], augment: &AugmentFacts, own: usize, axles: &[f64]) -> usize {
    let stands = |span: usize| {
        ranges.get(span - 1).is_some_and(|[from, to]| axles.iter().any(|x| (from - 1e-9..=to + 1e-9).contains(x)))
    };
    if stands(own) {
        return own;
    }
    let more = |a: &usize, b: &usize| augment.on(*a)[1].total_cmp(&augment.on(*b)[1]);
    (1..=ranges.len()).filter(|span| stands(*span)).max_by(more).unwrap_or(own)
}

/// A sensor of the assessment's own: where it sits, and what is made of its values.
#[derive(Debug, Clone, PartialEq)]
struct Probe {
    sensor: Sensor,
    place: facts::RingSection,
    /// Span, from 1.
    span: usize,
    /// From the sensor's value [SI] to millimetres or megapascals.
    scale: f64,
}

/// How names of probes begin: no sensor of a file is called so by chance.
const PROBE: &str = "place of the checks ";

/// Why a moment is kept, in words that leave probes out.
fn without_probes(name: &str) -> String {
    let Some(list) = name.strip_prefix("peak of ") else { return name.to_owned() };
    let own: Vec<&str> = list.split(", ").filter(|one| !one.starts_with(PROBE)).collect();
    if own.is_empty() { "peak at a place of the checks".to_owned() } else { format!("peak of {}", own.join(", ")) }
}

/// Most spans that are watched, from the left: those beyond repeat what these do.
const MOST_SPANS: usize = 6;

/// Crowns and springings of the first spans: the crown's deflection, and strains on the stones of both faces at crown and
/// springings. At the free intrados the stress along the ring is E / (1 - nu^2) times the strain, exactly; on the extrados
/// the pressure of the fill adds nu / (1 - nu) of itself, which is left out.
fn probes(bridge: &Bridge) -> Vec<Probe> {
    let modulus = bridge.masonry.elastic_modulus.unwrap_or(0.0);
    let poisson = bridge.masonry.poisson_ratio.unwrap_or(0.0);
    let scale = 1e-6 * modulus / (1.0 - poisson * poisson);
    let last = bridge.spans.len() - 1;
    let mut list = Vec::new();
    for (k, span) in bridge.spans.iter().enumerate().take(MOST_SPANS) {
        let end = |edge: bool| if edge { facts::RingSection::Abutment } else { facts::RingSection::Pier };
        let length = span.intrados().map_or(span.span, |curve| curve.length());
        let stones = span.rings.iter().map(|ring| ring.voussoirs).max().unwrap_or(1).max(1);
        let gauge_length = GAUGE_LENGTH.min(0.8 * length / stones as f64);
        for (place, share) in [(facts::RingSection::Crown, 0.5), (end(k == 0), 0.0), (end(k == last), 1.0)] {
            let mut put = |kind, face, scale| {
                let name = format!("{PROBE}{} {place} {share} {face:?}", k + 1);
                let sensor = Sensor { name, kind, place: SensorPosition::Span { span: k, share }, face };
                list.push(Probe { sensor, place, span: k + 1, scale });
            };
            if place == facts::RingSection::Crown {
                put(SensorKind::Displacement(Direction::Vertical), Face::Intrados, 1e3);
            }
            for face in [Face::Intrados, Face::Extrados] {
                put(SensorKind::Strain { gauge_length }, face, scale);
            }
        }
    }
    list
}

/// The bridge with a load's axles and the probes behind its own sensors.
fn prepared(bridge: &Bridge, load: &ServiceLoad, probes: &[Probe]) -> Result<(Bridge, usize), AnalysisError> {
    let mut own = bridge.clone();
    let spans = own.spans.len();
    let passage = own.passage.as_mut().ok_or(PassageError::NoTrain)?;
    if passage.sensors.is_empty() {
        passage.sensors = default_sensors(spans);
    }
    let sensors = passage.sensors.len();
    passage.sensors.extend(probes.iter().map(|probe| probe.sensor.clone()));
    if let Some(mass) = load.axle_load {
        for vehicle in &mut passage.train.vehicles {
            let axles = match &vehicle.loads {
                AxleLoads::Masses(list) | AxleLoads::Forces(list) => list.len(),
            };
            vehicle.loads = AxleLoads::Masses(vec![mass; axles]);
        }
    }
    Ok((own, sensors))
}

/// Cuts the passage to a stretch about these places of the first axle [m]: what is needed to see one peak again.
pub(super) fn window(bridge: &mut Bridge, at: f64) {
    if let Some(passage) = &mut bridge.passage {
        let step = passage.plan.direction.sign() * passage.plan.speed * passage.plan.time_step;
        passage.plan.from = Some(at - 2.0 * step);
        passage.plan.to = Some(at + 2.0 * step);
    }
}

/// The loads one after the other: facts, and each passage without the probes, for drawing.
///
/// # Errors
/// A rule that the library does not have, or a passage that cannot be set up or solved.
pub fn service(
    bridge: &Bridge,
    asked: &Assess,
    wanted: Scope,
    watch: &mut dyn Watch,
) -> Result<(ServiceFacts, Vec<Passage>), AnalysisError> {
    let probes = probes(bridge);
    let coefficient = augment(bridge, asked)?;
    let ranges = ranges(bridge);
    let alone = [ServiceLoad { name: "train of the file".to_owned(), axle_load: None, source: None }];
    let loads = if asked.service_loads.is_empty() { &alone[..] } else { &asked.service_loads[..] };
    let (mut facts, mut passages) = (ServiceFacts::default(), Vec::new());
    facts.augment = coefficient.clone();
    for load in loads {
        let (own, sensors) = prepared(bridge, load, &probes)?;
        let setup = passage::setup(&own)?;
        let solution = passage::solve(&own, &setup, wanted, &[], watch)?;
        let mut found = passage::report(&own, &setup, solution);
        let gravity = own.gravity;
        let axles = own.passage.as_ref().map(|passage| passage.train.axles(gravity)).unwrap_or_default();
        let heaviest = axles.iter().map(|axle| axle.force).fold(0.0, f64::max) / gravity / 1e3;
        facts.train.clone_from(&found.train);
        facts.loads.push(ServiceLoadFacts {
            name: load.name.clone(),
            heaviest_axle_t: heaviest,
            source: load.source.clone(),
            status: found.status,
            channels: found.channels[..sensors].iter().map(channel).collect(),
            places: places(&found, sensors, &probes, |own, first_axle| {
                let standing: Vec<f64> = axles.iter().map(|axle| first_axle - axle.offset).collect();
                loaded(&ranges, &coefficient, own, &standing)
            }),
            joints: [(Reading::Design, coefficient.design), (Reading::Total, coefficient.total)]
                .map(|(reading, augment)| {
                    joints(&found.moments, reading, augment, |span, moment| {
                        let standing: Vec<f64> = moment.axles.iter().map(|axle| axle.0).collect();
                        coefficient.on(loaded(&ranges, &coefficient, span + 1, &standing))[reading as usize]
                    })
                })
                .to_vec(),
        });
        if facts.assumptions.is_empty() {
            facts.assumptions.clone_from(&found.assumptions);
        }
        for warning in found.warnings.iter().cloned() {
            if !facts.warnings.contains(&warning) {
                facts.warnings.push(warning);
            }
        }
        found.channels.truncate(sensors);
        found.moments.iter_mut().for_each(|moment| moment.name = without_probes(&moment.name));
        if let Some(influence) = &mut found.influence {
            influence.values.truncate(sensors);
        }
        let cancelled = found.status == PassageStatus::Cancelled;
        passages.push(found);
        if cancelled {
            break;
        }
    }
    Ok((facts, passages))
}

fn channel(channel: &SensorRecord) -> ChannelFacts {
    let scale = channel.quantity.scale();
    let [minimum, maximum] = channel.range().map(|value| scale * value);
    ChannelFacts {
        name: channel.name.clone(),
        unit: channel.quantity.unit().to_owned(),
        minimum,
        maximum,
        peak: scale * channel.peak_value(),
        self_weight: scale * channel.self_weight,
    }
}

fn places(
    found: &Passage,
    sensors: usize,
    probes: &[Probe],
    loaded: impl Fn(usize, f64) -> usize,
) -> Vec<SectionFacts> {
    let one = |(probe, channel): (&Probe, &SensorRecord)| {
        let extreme = |better: fn(f64, f64) -> bool| {
            let values = &channel.values;
            (0..values.len()).reduce(|best, k| if better(values[k], values[best]) { k } else { best })
        };
        let (low, high) = (extreme(|a, b| a < b), extreme(|a, b| a > b));
        let value = |k: Option<usize>| k.map_or(0.0, |k| probe.scale * channel.values[k]);
        let at = |k: Option<usize>| k.and_then(|k| found.positions.get(k)).copied().unwrap_or(0.0);
        SectionFacts {
            place: probe.place,
            quantity: match probe.sensor.kind {
                SensorKind::Displacement(_) => Watched::Deflection,
                _ => Watched::Stress,
            },
            about: channel.about.clone(),
            span: probe.span,
            face: probe.sensor.face,
            self_weight: probe.scale * channel.self_weight,
            minimum: value(low),
            minimum_at_m: at(low),
            minimum_span: loaded(probe.span, at(low)),
            maximum: value(high),
            maximum_at_m: at(high),
            maximum_span: loaded(probe.span, at(high)),
        }
    };
    probes.iter().zip(&found.channels[sensors..]).map(one).collect()
}

/// The worst joints over the moments that are kept: those at which a sensor or a probe peaks. The first moment is
/// self-weight alone; what the train adds to its tractions is increased by the coefficient on the joint's span at that moment.
fn joints(moments: &[Moment], reading: Reading, augment: f64, on: impl Fn(usize, &Moment) -> f64) -> JointFacts {
    let mut worst = JointFacts { reading, augment, ..JointFacts::default() };
    let Some((rest, passing)) = moments.split_first() else { return worst };
    for (moment, passes) in passing.iter().map(|moment| (moment, true)).chain([(rest, false)]) {
        for (now, before) in moment.rows.iter().zip(&rest.rows) {
            let RowKind::Joint { span, joint } = now.kind else { continue };
            let added = if passes { on(span, moment) } else { 0.0 };
            let increase = if passes { 1.0 + added } else { 0.0 };
            let pairs: Vec<Pair> = now
                .pairs
                .iter()
                .zip(&before.pairs)
                .map(|(now, own)| Pair {
                    normal: own.normal + increase * (now.normal - own.normal),
                    shear: own.shear + increase * (now.shear - own.shear),
                    ..*now
                })
                .collect();
            let place = format!("joint {joint} of span {}, {}", span + 1, when(moment));
            let shear = pairs.iter().map(|pair| pair.shear.abs()).fold(0.0, f64::max) / 1e6;
            if shear > worst.shear_mpa {
                (worst.shear_mpa, worst.shear_position_m, worst.shear_augment) = (shear, moment.position, added);
                worst.shear_at.clone_from(&place);
            }
            if let Some(eccentricity) = eccentricity(&pairs)
                && eccentricity > worst.eccentricity
            {
                (worst.eccentricity, worst.eccentricity_position_m) = (eccentricity, moment.position);
                worst.eccentricity_augment = added;
                worst.eccentricity_at = place;
            }
        }
    }
    worst
}

fn when(moment: &Moment) -> String {
    match moment.axles.is_empty() {
        true => "under self-weight".to_owned(),
        false => format!("first axle at {:.2} m", moment.position),
    }
}

/// Distance of the thrust from the middle of a joint over the joint's depth; none where it carries no compression.
fn eccentricity(pairs: &[Pair]) -> Option<f64> {
    let depth: f64 = pairs.iter().map(|pair| pair.area).sum();
    let thrust: f64 = pairs.iter().map(|pair| -pair.normal * pair.area).sum();
    let (first, last) = (pairs.first()?, pairs.last()?);
    let along = [last.at[0] - first.at[0], last.at[1] - first.at[1]];
    let length = along[0].hypot(along[1]);
    if !(thrust > 0.0 && depth > 0.0 && length > 0.0) {
        return None;
    }
    let place = |pair: &Pair| ((pair.at[0] - first.at[0]) * along[0] + (pair.at[1] - first.at[1]) * along[1]) / length;
    let middle = pairs.iter().map(|pair| pair.area * place(pair)).sum::<f64>() / depth;
    let centre = pairs.iter().map(|pair| -pair.normal * pair.area * place(pair)).sum::<f64>() / thrust;
    Some((centre - middle).abs() / depth)
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::passage::PairState;

    fn pair(y: f64, normal: f64) -> Pair {
        Pair { at: [0.0, y], area: 0.25, normal, shear: 0.0, opening: 0.0, sliding: 0.0, state: PairState::Closed }
    }

    /// A peak is seen again whichever way the train drives.
    #[test]
    fn a_stretch_about_a_peak_lies_on_the_way() {
        use bridge::passage::Heading;
        for direction in [Heading::Right, Heading::Left] {
            let mut bridge = crate::samples::bridgemill();
            let mut asked = crate::samples::passage();
            asked.plan.direction = direction;
            bridge.passage = Some(asked);
            window(&mut bridge, 3.0);
            let plan = &bridge.passage.as_ref().unwrap().plan;
            let (from, to) = (plan.from.unwrap(), plan.to.unwrap());
            assert!(direction.sign() * (to - from) > 0.0 && (from + to - 6.0).abs() < 1e-12, "{from} {to}");
        }
    }

    /// Motion adds by the span that is loaded: the short one's coefficient does not come from the long one.
    #[test]
    fn augment_is_that_of_the_loaded_span() {
        let mut bridge = crate::samples::bridgemill();
        bridge.spans = [3.0, 12.0].map(|span| bridge::Span { span, ..bridge.spans[0].clone() }).to_vec();
        bridge.piers = vec![bridge::Pier::plain(1.0, 1.0, 3.0, 6)];
        let mut asked = Assess::default();
        asked.limits.rule = Some("irs-bridge-rules".to_owned());
        asked.limits.cushion = Some(0.0);
        let facts = augment(&bridge, &asked).unwrap();
        let total: Vec<f64> = facts.spans.iter().map(|span| span.total).collect();
        assert!((total[0] - 1.0).abs() < 1e-12 && (total[1] - (0.15 + 8.0 / 18.0)).abs() < 1e-12, "{total:?}");
        assert_eq!((facts.on(1)[1], facts.on(2)[1], facts.total), (total[0], total[1], total[1]));
        let ranges = ranges(&bridge);
        assert_eq!(ranges, [[0.0, 3.0], [4.0, 16.0]]);
        let of = |own: usize, axles: &[f64]| loaded(&ranges, &facts, own, axles);
        assert_eq!((of(2, &[1.0, 6.0]), of(2, &[1.0]), of(1, &[6.0]), of(1, &[])), (2, 1, 2, 1));
        // A loaded length of the file's own counts for all spans.
        asked.limits.loaded_length = Some(6.0);
        let facts = augment(&bridge, &asked).unwrap();
        assert_eq!(facts.on(1), facts.on(2));
    }

    #[test]
    fn probes_are_not_spoken_of() {
        let name = format!("peak of crown, {PROBE}1 crown 0.5 Intrados, strain");
        assert_eq!(without_probes(&name), "peak of crown, strain");
        assert_eq!(without_probes(&format!("peak of {PROBE}1 pier")), "peak at a place of the checks");
        assert_eq!(without_probes("self-weight"), "self-weight");
    }

    /// Four springs of a joint a metre deep: an even pressure stands in the middle, a triangle at two thirds of what a
    /// continuous one has, for springs see it at their own places.
    #[test]
    fn eccentricity_is_that_of_the_tractions() {
        let ys = [0.125, 0.375, 0.625, 0.875];
        let even: Vec<Pair> = ys.iter().map(|y| pair(*y, -2e5)).collect();
        assert!(eccentricity(&even).unwrap().abs() < 1e-12);
        let edge: Vec<Pair> = ys.iter().map(|y| pair(*y, if *y > 0.8 { -1e5 } else { 0.0 })).collect();
        assert!((eccentricity(&edge).unwrap() - 0.375).abs() < 1e-12);
        let open: Vec<Pair> = ys.iter().map(|y| pair(*y, 0.0)).collect();
        assert_eq!(eccentricity(&open), None);
    }
}
