//! The least thickness of a semicircular ring under its own weight.

use crate::limit_models::Ring;
use mechanics::blocks::{BlockModel, Loading};
use mechanics::limit::{LeastThickness, Settings, ThicknessStatus, minimum_thickness};
use mechanics::plane::Vec2;
use mechanics::watch::CancelToken;

/// Friction at which nothing slides.
const ROUGH: f64 = 2.0;

/// True sectors: the weight and centroid of curved voussoirs, not of their chords.
fn sectors(voussoirs: usize, friction: f64) -> impl Fn(f64) -> (BlockModel, Loading) {
    move |thickness| {
        let ring = Ring::semicircle(voussoirs, thickness, friction);
        let model = BlockModel { gravity: Vec2::ZERO, ..ring.model() };
        (model, Loading { permanent: ring.sector_weights(), ..Loading::default() })
    }
}

fn least(make: impl Fn(f64) -> (BlockModel, Loading)) -> LeastThickness {
    minimum_thickness([0.05, 0.3], 1e-7, 0.0, &Settings::default(), &CancelToken::default(), make).unwrap()
}

#[test]
fn equal_sectors_as_calculated_by_others() {
    for (voussoirs, expected) in [(27, 0.106776), (54, 0.107377), (108, 0.107458), (216, 0.10747)] {
        let found = least(sectors(voussoirs, ROUGH));
        assert_eq!(found.status, ThicknessStatus::Found);
        // Six decimals are given, of four figures certain: 1e-5 of the table itself.
        assert!((found.stands.unwrap() - expected).abs() < 1e-5);
    }
}

#[test]
fn friction_decides_below_tan_21_6_degrees() {
    let table = [(0.6, 0.10746), (0.396, 0.10746), (0.39, 0.11221), (0.36, 0.14138), (0.33, 0.17392), (0.31, 0.19764)];
    for (friction, expected) in table {
        let found = least(sectors(120, friction));
        assert!((found.stands.unwrap() - expected).abs() < 2e-4);
    }
    assert_eq!(least(sectors(120, 0.30)).status, ThicknessStatus::FallsAtThickest);
}

#[test]
fn two_hundred_flat_blocks_come_within_a_fifth_of_a_percent() {
    let found = least(|thickness| (Ring::semicircle(200, thickness, ROUGH).model(), Loading::default()));
    assert!((found.stands.unwrap() / 0.1075 - 1.0).abs() < 2e-3);
    // Crown extrados, haunch intrados near the 54.5 degrees of the continuous ring, springing extrados. The angle is
    // flat in the thickness: one joint further, 0.9 degrees, changes it by less than a tenth of a percent.
    let mechanism = found.mechanism.unwrap();
    let angles: Vec<f64> = mechanism.hinges.iter().map(|h| h.at.x.atan2(h.at.y).to_degrees()).collect();
    assert_eq!(angles.len(), 5, "{angles:?}");
    for (angle, expected) in angles.iter().zip([-90.0, -54.5, 0.0, 54.5, 90.0]) {
        assert!((angle - expected).abs() < 0.9, "{angles:?}");
    }
    let at_extrados: Vec<bool> = mechanism.hinges.iter().map(|h| h.point == 1).collect();
    assert_eq!(at_extrados, [true, false, true, false, true]);
}
