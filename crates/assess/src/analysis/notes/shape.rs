//! What a result must say of springings, piers, abutments and hollow spandrels.

use bridge::Bridge;
use outcome::note;
use outcome::warning;
use structure::discretise::springings::are_level;

/// Whether the spandrels between the walls are what is analysed, and not a wall.
pub(super) fn warnings(bridge: &Bridge, is_fill: bool) -> Vec<warning::Cover> {
    let mut found = Vec::new();
    let cover = &bridge.cover;
    if is_fill {
        found.extend(cover.voids.iter().enumerate().map(|(number, void)| warning::Cover::Void {
            number,
            range: void.range,
            carried_to: void.carried_to,
        }));
        let walls = cover.internal_walls.map(|of| (true, of.share, of.density));
        let backing = cover.backing.filter(|of| of.width_share < 1.0).map(|of| (false, of.width_share, of.density));
        let mean = |(walls, share, density)| warning::Cover::MeanOverWidth { walls, share, density };
        found.extend(walls.into_iter().chain(backing).map(mean));
    }
    for (right, abutment) in [false, true].into_iter().zip(&bridge.abutments) {
        let Some(body) = &abutment.body else { continue };
        let (friction_angle, earth_coefficient) = (body.ground_friction_angle, body.earth_coefficient);
        found.push(warning::Cover::Movable { right, friction_angle, earth_coefficient });
    }
    found
}

/// What was assumed of supports.
pub(super) fn assumptions(bridge: &Bridge) -> Vec<note::Barrel> {
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
        let codes =
            |b: &Bridge, is_fill| -> Vec<&str> { warnings(b, is_fill).iter().map(warning::Cover::code).collect() };
        assert_eq!(codes(&b, true), [warning::VOIDS, warning::MEAN_OVER_WIDTH, warning::MOVABLE_ABUTMENT]);
        assert_eq!(codes(&b, false), [warning::MOVABLE_ABUTMENT]);
        assert!(matches!(warnings(&b, false)[0], warning::Cover::Movable { right: true, .. }));
        let span = b.spans[0].clone();
        (b.spans, b.piers) = (vec![span.clone(), span], vec![bridge::Pier::plain(2.0, 2.0, 3.0, 3)]);
        assert_eq!(assumptions(&b), [note::Barrel::Springings { level: true }]);
        (b.piers[0].step, b.piers[0].across) = (0.1, Some([10.0; 2]));
        assert_eq!(assumptions(&b), [note::Barrel::Springings { level: false }, note::Barrel::PiersAcross]);
    }
}
