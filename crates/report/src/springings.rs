//! Where the resultant lies at springings and feet of piers, and what it presses with.

use crate::numbers::{digits, maybe};
use crate::parts::{OUTSIDE, Part};
use outcome::assessment::Assessment;
use outcome::facts::ThrustFacts;
use outcome::statics::Reaction;

/// Where a resultant lies in its joint.
pub(crate) fn lies(eccentricity: f64, depth: f64, outside: bool) -> &'static str {
    match (outside, eccentricity.abs() <= depth / 6.0) {
        (true, _) => OUTSIDE,
        (false, true) => "in the middle third",
        (false, false) => "in the joint",
    }
}

/// Pressure of a thrust over the part of its joint that is centred on the resultant [MPa], in words.
pub(crate) fn pressure(a: &Assessment, one: &ThrustFacts) -> String {
    let bears = one.depth_m - 2.0 * one.eccentricity_m.abs();
    let feet = a.statics.iter().flat_map(|statics| &statics.reactions);
    let spread = feet.filter(|foot| foot.place == one.place).map(|foot| foot.spread).next().unwrap_or(1.0);
    if bears > 0.0 { digits(1e-3 * one.thrust_kn_per_m / (bears * spread)) } else { "–".to_owned() }
}

/// Where the resultant lies at every springing and foot of a pier, and what it presses with: dead load, and the governing vehicle.
pub(crate) fn springings(a: &Assessment) -> Option<Part> {
    let reactions: &[Reaction] = a.statics.as_ref().map_or(&[], |statics| &statics.reactions);
    let worst = a.facts.vehicles.made().and_then(|facts| facts.worst());
    let thrusts: &[ThrustFacts] = worst.map_or(&[], |one| &one.thrusts);
    let mut part =
        Part { id: Some("springings"), title: "Eccentricity and pressure at springings and piers", ..Part::default() };
    let said = match worst {
        Some(one) if !thrusts.is_empty() => {
            format!("; of vehicles, {} with the rule's factors on loads and weights, at its largest thrust", one.code)
        }
        _ => String::new(),
    };
    part.words.push(format!(
        "Of elastic blocks whose joints open nowhere: dead load without factors{said}. Pressure is over the part of the joint that is centred \
         on the resultant. Outside its joint no resultant is carried without tension: the joint opens before, and hinges form."
    ));
    part.heads = vec![
        "place",
        "depth [m]",
        "dead load: eccentricity [mm]",
        "dead load: pressure [MPa]",
        "dead load: resultant",
        "vehicle: eccentricity [mm]",
        "vehicle: pressure [MPa]",
        "vehicle: resultant",
    ];
    part.numbers = vec![false, true, true, true, false, true, true, false];
    // A bridge of one span names its springings without the span.
    let plain = |place: &str| {
        let place = place.replace(", ", " ");
        place.strip_prefix("span 1 ").map(str::to_owned).unwrap_or(place)
    };
    // Where several rings spring, dead load has one resultant for all of them and no eccentricity.
    let known = reactions.iter().filter(|one| one.eccentricity.is_some());
    let mut places: Vec<String> = known.map(|one| one.place.clone()).collect();
    for one in thrusts {
        if !places.iter().any(|place| plain(place) == plain(&one.place)) {
            places.push(one.place.clone());
        }
    }
    let none = || "–".to_owned();
    part.rows = places
        .into_iter()
        .map(|place| {
            let own = reactions.iter().find(|one| one.place == place);
            let live = thrusts.iter().find(|one| plain(&one.place) == plain(&place));
            let joint = own.and_then(|one| one.eccentricity.zip(one.depth));
            let rest = joint.map_or_else(none, |(eccentricity, depth)| {
                lies(eccentricity, depth, eccentricity.abs() > 0.5 * depth).to_owned()
            });
            vec![
                place,
                maybe(own.and_then(|one| one.depth).or(live.map(|one| one.depth_m))),
                maybe(own.and_then(|one| one.eccentricity).map(|value| 1e3 * value)),
                maybe(own.and_then(|one| one.pressure).map(|value| 1e-6 * value)),
                rest,
                maybe(live.map(|one| 1e3 * one.eccentricity_m)),
                live.map_or_else(none, |one| pressure(a, one)),
                live.map_or_else(none, |one| lies(one.eccentricity_m, one.depth_m, one.outside).to_owned()),
            ]
        })
        .collect();
    if reactions.iter().any(|one| one.eccentricity.is_none()) {
        part.words.push(
            "Where several rings spring, dead load is known for all of them together: see the reactions at rest."
                .into(),
        );
    }
    if thrusts.is_empty() {
        part.heads.truncate(5);
        part.numbers.truncate(5);
        part.rows.iter_mut().for_each(|row| row.truncate(5));
    }
    (!part.rows.is_empty()).then_some(part)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parts::tests::nothing;
    use outcome::statics::{Seat, Statics};

    /// Every springing has a row with both loads, by the names of either, and a resultant outside its joint is marked.
    #[test]
    fn eccentricities_of_dead_load_and_vehicle_stand_at_every_springing() {
        use outcome::assessment::Stage;
        use outcome::facts::{SweptFacts, VehicleFacts};
        let rest = |place: &str, eccentricity: f64| Reaction {
            place: place.into(),
            seat: Seat::Springing,
            vertical: 1e5,
            horizontal: 5e4,
            eccentricity: Some(eccentricity),
            depth: Some(0.6),
            pressure: (eccentricity < 0.3).then_some(2e5),
            spread: 1.0,
        };
        let thrust = |place: &str, eccentricity_m: f64| ThrustFacts {
            place: place.into(),
            thrust_kn_per_m: 400.0,
            eccentricity_m,
            depth_m: 0.6,
            outside: eccentricity_m.abs() > 0.3,
            ..ThrustFacts::default()
        };
        let mut a = nothing();
        let reactions = vec![rest("left springing", 0.05), rest("right springing", 0.4)];
        a.statics = Some(Statics { reactions, ..Statics::default() });
        assert_eq!(springings(&a).map(|part| part.heads.len()), Some(5), "no vehicle");
        let thrusts = vec![thrust("span 1 left springing", -0.15), thrust("span 1 right springing", -0.35)];
        let one = SweptFacts { code: "lorry".into(), thrusts, ..SweptFacts::default() };
        let facts = VehicleFacts { vehicles: vec![one], governing: Some("lorry".into()), ..VehicleFacts::default() };
        a.facts.vehicles = Stage::Made(facts);
        let part = springings(&a).expect("a table");
        assert_eq!(part.rows.len(), 2);
        assert_eq!(
            part.rows[0],
            ["left springing", "0.600", "50.0", "0.200", "in the middle third", "−150", "1.33", "in the joint"]
        );
        assert_eq!(part.rows[1], ["right springing", "0.600", "400", "–", OUTSIDE, "−350", "–", OUTSIDE]);
        assert_eq!(part.cells(&part.rows[1])[7].1, "broken");
    }
}
