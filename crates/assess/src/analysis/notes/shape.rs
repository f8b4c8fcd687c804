//! What a result must say of springings, piers, abutments and hollow spandrels.

use bridge::Bridge;
use outcome::note;
use outcome::warning::{self, Warning};
use structure::discretise::springings::are_level;

/// Whether the spandrels between the walls are what is analysed, and not a wall.
pub fn warnings(bridge: &Bridge, is_fill: bool) -> Vec<Warning> {
    let mut found = Vec::new();
    let cover = &bridge.cover;
    for (k, void) in cover.voids.iter().enumerate().filter(|_| is_fill) {
        let ([from, to], [left, right]) = (void.range, void.carried_to);
        found.push(Warning::new(
            warning::VOIDS,
            format!(
                "void {} from {from:.2} m to {to:.2} m: what lies over it is carried to {left:.2} m and {right:.2} m; its roof is not checked",
                k + 1
            ),
        ));
    }
    let shares = cover.internal_walls.map(|walls| ("internal walls", walls.share, walls.density));
    let backing = cover.backing.filter(|backing| backing.width_share < 1.0);
    let shares = shares.into_iter().chain(backing.map(|backing| ("backing", backing.width_share, backing.density)));
    found.extend(shares.filter(|_| is_fill).map(|(what, share, density)| {
        let message = format!(
            "{what} over {:.0} % of the width: {density:.0} kg/m³ on the mean of every metre of the barrel",
            100.0 * share
        );
        Warning::new(warning::MEAN_OVER_WIDTH, message)
    }));
    for (side, abutment) in ["left", "right"].iter().zip(&bridge.abutments) {
        let Some(body) = &abutment.body else { continue };
        let message = format!(
            "the {side} abutment stands on the ground with friction at {:.1} degrees; soil behind it presses with {:.2} of its vertical \
             stress, and no passive pressure is counted",
            body.ground_friction_angle.to_degrees(),
            body.earth_coefficient
        );
        found.push(Warning::new(warning::MOVABLE_ABUTMENT, message));
    }
    found
}

/// What was assumed of supports.
pub fn assumptions(bridge: &Bridge) -> Vec<note::Barrel> {
    let level = are_level(bridge);
    let mut list = Vec::new();
    if bridge.spans.len() > 1 {
        list.push(note::Barrel::Springings { level });
    } else if !level {
        list.push(note::Barrel::SpringingsOfOneSpan);
    }
    if bridge.piers.iter().any(|pier| pier.across.is_some() || pier.footings.iter().any(|step| step.across.is_some())) {
        list.push(note::Barrel::PiersAcross);
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn hollow_and_movable_bridges_say_what_they_leave_out() {
        let mut b = samples::case_two();
        assert!(warnings(&b, true).is_empty() && assumptions(&b).is_empty());
        b.cover.internal_walls = Some(bridge::InternalWalls { height: 1.0, density: 800.0, share: 0.25 });
        b.cover.voids = vec![bridge::Void { range: [1.0, 2.0], levels: [1.5, 2.5], carried_to: [0.8, 2.2] }];
        b.abutments[1].body = Some(bridge::AbutmentBody {
            base_width: None,
            courses: 1,
            ground_friction_angle: 0.5,
            earth_coefficient: 0.33,
            earth_density: None,
        });
        let codes = |b: &Bridge, is_fill| -> Vec<&str> { warnings(b, is_fill).iter().map(|one| one.code).collect() };
        assert_eq!(codes(&b, true), [warning::VOIDS, warning::MEAN_OVER_WIDTH, warning::MOVABLE_ABUTMENT]);
        assert_eq!(codes(&b, false), [warning::MOVABLE_ABUTMENT]);
        assert!(warnings(&b, false)[0].message.contains("the right abutment"));
        let span = b.spans[0].clone();
        (b.spans, b.piers) = (vec![span.clone(), span], vec![bridge::Pier::plain(2.0, 2.0, 3.0, 3)]);
        assert_eq!(assumptions(&b), [note::Barrel::Springings { level: true }]);
        (b.piers[0].step, b.piers[0].across) = (0.1, Some([10.0; 2]));
        assert_eq!(assumptions(&b), [note::Barrel::Springings { level: false }, note::Barrel::PiersAcross]);
    }
}
