//! Where the resultant at rest meets the ground below piers and abutments.

use super::bearing::feet;
use super::check::{Check, Probe, limit, used};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade, Unit};

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C403",
    keys: ["pier", "assess.foot_eccentricity_limit"],
    title: "resultant on the foot",
    clause: "resultant at rest within the core of the feet of piers and of abutments that stand on the ground",
    text: "The distance of the resultant from the middle of a foot over the foot's depth, at rest under nominal weights. Within the middle \
           third (0.167) the whole foot bears; within the middle two thirds (0.333) half of it does or more. A load that is always there \
           and stands off the middle tilts a pier or an abutment slowly, whatever the arches carry. The resultant is that of elastic \
           blocks on rigid ground whose joints open nowhere; beyond half of the depth it lies outside the foot. Vehicles are left out: \
           the pressure under them is C402, and whether the bridge turns over with them is for the checks at ultimate. Where the limit \
           is not met, measure how far the pier or the abutment leans and its levels over some years, and find its foundation by a trial \
           pit: a footing that is not in the file widens the foot. An abutment that is fixed has no foot: describe it as \
           blocks.",
    source: "DIN 1054 (2010), A 6.6.5: no gap below the foot under permanent actions, a sixth of its depth [recalled]; EN 1997-1, 6.5.4: \
             special precautions beyond a third [recalled]; the limit is the file's",
    probe: Probe::Whole,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    // A bridge without feet is not asked for a limit that it has no use for.
    let feet = feet(a)?;
    let form = "foot_eccentricity_limit = …";
    let limit = limit(a.asked.limits.foot_eccentricity, form, "from the rule that you assess by")?;
    let found = feet.into_iter().filter_map(|foot| {
        let (depth, eccentricity) = (foot.depth?, foot.eccentricity?.abs());
        let value = eccentricity / depth;
        let outside = if value > 0.5 { ", outside the foot" } else { "" };
        Some(Comparison {
            load_model: "at rest".to_owned(),
            value,
            limit,
            unit: Unit::OfTheDepth,
            utilisation: used(value, limit),
            basis: format!("{}, {eccentricity:.3} m from the middle of {depth:.3} m{outside}", foot.place),
            ..Comparison::default()
        })
    });
    Ok(found.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::statics;
    use crate::samples;
    use bridge::Bridge;
    use bridge::assess::{Assess, Limits};
    use outcome::assessment::Facts;
    use outcome::statics::Reaction;

    /// Two spans of Bridgemill's form, without cover, on a pier of 2.5 m that is 4 m high; the middle of its foot lies `offset` to the right
    /// of the middle of its head [m].
    fn twin(offset: f64) -> Bridge {
        let one = samples::bridgemill().spans[0].clone();
        let mut b = samples::spans(vec![one.clone(), one], 2.5, 2.5, 4.0, 5);
        b.piers[0].base_offset = offset;
        b.masonry.rounding = 0.0;
        b
    }

    fn evidence(bridge: Bridge) -> Evidence {
        let statics = statics(&bridge).ok();
        let limits = Limits { foot_eccentricity: Some(1.0 / 6.0), ..Limits::default() };
        let asked = Assess { limits, ..Assess::default() };
        Evidence { bridge, asked, facts: Facts::default(), statics, doubts: Vec::new(), assumed: Vec::new() }
    }

    fn compared(bridge: Bridge) -> Comparison {
        let found = run(&evidence(bridge)).unwrap();
        assert_eq!(found.len(), 1, "{found:?}");
        found[0].clone()
    }

    /// By hand: 0.25 m of 3 m is half of a sixth; 1.6 m lies outside.
    #[test]
    fn the_distance_from_the_middle_is_a_share_of_the_depth() {
        let mut a = evidence(twin(0.0));
        let mut at = |eccentricity: f64| {
            let feet = a.statics.as_mut().unwrap().reactions.iter_mut();
            let foot = feet.filter(|one| one.place == "foot of pier 1").last().unwrap();
            (foot.eccentricity, foot.depth) = (Some(eccentricity), Some(3.0));
            run(&a).unwrap().remove(0)
        };
        for one in [at(0.25), at(-0.25)] {
            assert!((one.value - 1.0 / 12.0).abs() < 1e-12 && (one.utilisation - 0.5).abs() < 1e-12 && one.met());
            assert_eq!(one.basis, "foot of pier 1, 0.250 m from the middle of 3.000 m");
        }
        let beyond = at(1.6);
        assert!(!beyond.met() && beyond.basis.ends_with("outside the foot"), "{}", beyond.basis);
    }

    /// Balance of the pier about the middle of its foot: what both springings hand to it where the table of reactions says, and its own
    /// weight, a parallelogram below its springings and the rest in the middle of its head.
    #[test]
    fn a_leaning_pier_is_in_balance_about_the_middle_of_its_foot() {
        let (offset, [width, height]) = (0.6, [2.5, 4.0]);
        let bridge = twin(offset);
        let found = statics(&bridge).unwrap();
        let springing = |place: &str| found.reactions.iter().find(|one| one.place == place).unwrap();
        let [half, rise, thickness]: [f64; 3] = [0.5 * 18.30, 2.85, 0.711];
        let sine = half / ((half * half + rise * rise) / (2.0 * rise));
        let up = (1.0 - sine * sine).sqrt();
        // Moment of what a springing hands over, anticlockwise; `side` is -1 on the left of the pier. Eccentricities count towards the extrados.
        let moment = |one: &Reaction, side: f64| {
            let along = 0.5 * thickness + one.eccentricity.unwrap();
            let [x, y] = [-offset + side * (0.5 * width - along * sine), height + along * up];
            -x * one.vertical + y * side * one.horizontal
        };
        let own = found.weights.iter().find(|one| one.part == "pier 1: masonry").unwrap().force;
        let shaft = width * height * bridge.masonry.density * bridge.gravity;
        let of_springings =
            moment(springing("span 1, right springing"), -1.0) + moment(springing("span 2, left springing"), 1.0);
        let whole = of_springings + 0.5 * offset * shaft + offset * (own - shaft);
        let vertical = springing("foot of pier 1").vertical;
        let by_hand = (whole / vertical).abs() / width;
        let value = compared(bridge).value;
        assert!((value - by_hand).abs() < 1e-6 && value > 0.01, "{value} {by_hand} {:?}", found.reactions);
    }

    /// Two equal spans push a plumb pier from both sides alike, and a pier that leans left is one that leans right seen from behind.
    #[test]
    fn a_symmetric_bridge_stands_on_the_middle_of_its_pier() {
        assert!(compared(twin(0.0)).value < 1e-9);
        assert!((compared(twin(0.6)).value - compared(twin(-0.6)).value).abs() < 1e-9);
    }

    /// A check that no sound bridge meets would say nothing: the piers of the examples stand well within a sixth.
    #[test]
    fn piers_of_the_examples_meet_a_sixth() {
        let files = [
            include_str!("../../../../examples/two-span/bridge.toml"),
            include_str!("../../../../examples/viaduct/bridge.toml"),
            include_str!("../../../../examples/gradient/bridge.toml"),
            include_str!("../../../../examples/skew-railway/bridge.toml"),
            include_str!("../../../../examples/railway-arch/assess.toml"),
        ];
        let found = files.map(|file| {
            let bridge = bridge::read(file.as_bytes()).bridge.expect("the example is sound");
            run(&evidence(bridge)).unwrap()
        });
        assert!(found.iter().all(|list| !list.is_empty() && list.iter().all(Comparison::met)), "{found:#?}");
    }

    #[test]
    fn a_bridge_without_feet_is_not_asked_for_a_limit() {
        let why = run(&evidence(samples::bridgemill())).unwrap_err().why;
        assert!(why.contains("abutment as blocks") && !why.contains("foot_eccentricity_limit"), "{why}");
        let mut a = evidence(twin(0.0));
        a.asked.limits.foot_eccentricity = None;
        assert!(run(&a).unwrap_err().why.contains("write foot_eccentricity_limit = …"));
    }
}
