//! What piers and abutments press on the ground with.

use super::check::{Check, Probe, limit, used};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};
use outcome::facts::{SweptFacts, ThrustFacts};
use outcome::statics::{Reaction, Seat, pressure};

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C402",
    keys: ["pier", "assess.bearing_limit"],
    title: "pressure on the ground",
    clause: "pressure below the feet of piers and of abutments that stand on the ground",
    text: "The resultant on a foot, over the part of the foot that is centred on it: depth less twice the eccentricity, and the width \
           across of the foot. It is made at rest under nominal weights, and under each vehicle with the rule's factors on loads and \
           weights; both are compared with bearing_limit of [assess], which must be given for such loads. Resultants are those of \
           elastic blocks on rigid ground whose joints open nowhere. A vehicle loads no more of the foot's width than carries its axle: \
           a stiff pier spreads it further. An abutment that is fixed has no foot: describe it as blocks. Where the limit is not met, \
           look at settlement and at scour, and find the width of the foundation by a trial pit.",
    source: "G. G. Meyerhof, The bearing capacity of foundations under eccentric and inclined loads, 3rd Int. Conf. Soil Mechanics, Zurich \
             1953 [recalled]; the limit is the file's",
    probe: Probe::Whole,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    // A bridge without feet is not asked for a limit that it has no use for.
    let feet = feet(a)?;
    let form = "bearing_limit = \"… kPa\"";
    let limit = limit(a.asked.limits.bearing, form, "from the ground investigation or the owner")?;
    let rest = feet.iter().filter_map(|foot| {
        let (depth, eccentricity) = (foot.depth?, foot.eccentricity?);
        let pascals = pressure(foot.vertical, depth, eccentricity) / foot.spread;
        Some(compared("at rest", pascals, limit, &foot.place, "under nominal weights"))
    });
    let vehicles = a.facts.vehicles.made().map_or(&[][..], |facts| &facts.vehicles);
    let passing = vehicles.iter().filter_map(|one| {
        let worst = feet.iter().filter_map(|foot| Some((foot, under(one, foot)?)));
        let (foot, pascals) = worst.max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(compared(&one.code, pascals, limit, &foot.place, "with the rule's factors on loads and weights"))
    });
    Ok(rest.chain(passing).collect())
}

/// What the feet of piers and abutments carry at rest, or that there are none.
pub(super) fn feet(a: &Evidence) -> Result<Vec<&Reaction>, NotMade> {
    let reactions = a.statics.iter().flat_map(|statics| &statics.reactions);
    let feet: Vec<&Reaction> = reactions.filter(|one| one.seat == Seat::Foot).collect();
    match feet.is_empty() {
        true => Err(NotMade::because("no pier, and no abutment as blocks, stands on the ground with a known reaction")),
        false => Ok(feet),
    }
}

/// Largest pressure of a vehicle on a foot [Pa].
fn under(vehicle: &SweptFacts, foot: &Reaction) -> Option<f64> {
    let at = |thrust: &&ThrustFacts| thrust.place == foot.place;
    vehicle.thrusts.iter().find(at).map(|thrust| 1e3 * thrust.pressure_kpa / foot.spread)
}

fn compared(load: &str, pascals: f64, limit: f64, place: &str, how: &str) -> Comparison {
    Comparison {
        load_model: load.to_owned(),
        value: pascals / 1e6,
        limit: limit / 1e6,
        unit: Unit::Megapascal,
        utilisation: used(pascals, limit),
        basis: format!("{place}, {how}"),
        ..Comparison::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::statics;
    use crate::samples;
    use bridge::assess::{Assess, Limits};
    use outcome::assessment::{Facts, Stage};
    use outcome::facts::VehicleFacts;

    /// Two equal spans of 4 m on a pier of 2.5 m that is 3 m wide at its foot, 10 % wider across than the barrel.
    fn evidence() -> Evidence {
        let one = samples::bridgemill().spans[0].clone();
        let mut b = samples::spans(vec![one.clone(), one], 2.5, 3.0, 4.0, 5);
        b.cover.layers = vec![samples::fill(0.4, 1800.0)];
        b.piers[0].across = Some([1.1 * b.width; 2]);
        let statics = statics(&b).ok();
        let limits = Limits { bearing: Some(0.5e6), ..Limits::default() };
        Evidence {
            bridge: b,
            asked: Assess { limits, ..Assess::default() },
            facts: Facts::default(),
            statics,
            doubts: Vec::new(),
            assumed: Vec::new(),
        }
    }

    /// By hand: the pier carries itself, what lies on it and half of either span, in the middle of its foot of 3 m.
    #[test]
    fn the_ground_carries_the_pier_and_half_of_either_span() {
        let mut a = evidence();
        let weights = &a.statics.as_ref().unwrap().weights;
        let of = |part: &str| weights.iter().filter(|one| one.part.starts_with(part)).map(|one| one.force).sum::<f64>();
        let carried = of("pier 1") + 0.5 * (of("span 1") + of("span 2"));
        let by_hand = carried / (3.0 * 1.1) / 1e6;
        let found = run(&a).unwrap();
        assert_eq!((found.len(), found[0].load_model.as_str()), (1, "at rest"));
        // Rounded corners of the blocks take 2 x 10 mm at most off the foot of 3 m.
        assert!((found[0].value / by_hand - 1.0).abs() < 0.01, "{} {by_hand}", found[0].value);
        assert!((found[0].utilisation - found[0].value / 0.5).abs() < 1e-12);
        a.asked.limits.bearing = None;
        assert!(run(&a).unwrap_err().why.contains("bearing_limit"));
        a.statics = None;
        a.asked.limits.bearing = Some(1.0);
        assert!(run(&a).unwrap_err().why.contains("abutment as blocks"));
    }

    /// 1100 kN/m on a foot 1.1 times as wide as the barrel, 0.25 m off the middle of 3 m: 1100 / 1.1 / 2.5 = 400 kPa. Beyond the edge nothing
    /// bears.
    #[test]
    fn a_vehicle_presses_on_what_is_centred_on_its_resultant() {
        let mut a = evidence();
        let foot = a.statics.as_mut().unwrap().reactions.iter_mut().find(|one| one.place == "foot of pier 1").unwrap();
        foot.spread = 1.1;
        let vehicle = |eccentricity| SweptFacts {
            code: "heavy".into(),
            thrusts: vec![ThrustFacts {
                place: "foot of pier 1".into(),
                pressure_kpa: pressure(1.1e6, 3.0, eccentricity) / 1e3,
                ..ThrustFacts::default()
            }],
            ..SweptFacts::default()
        };
        let mut of = |eccentricity| {
            a.facts.vehicles =
                Stage::Made(VehicleFacts { vehicles: vec![vehicle(eccentricity)], ..VehicleFacts::default() });
            run(&a).unwrap().remove(1)
        };
        let inside = of(0.25);
        assert!((inside.value - 0.4).abs() < 1e-12 && (inside.utilisation - 0.8).abs() < 1e-12 && inside.met());
        assert!(!of(1.6).met());
    }
}
