//! Vehicles on a road surface, and both ways.

use super::{Scope, Setup, Solution, setup, solve};
use bridge::Bridge;
use bridge::passage::{Direction, Face, Heading, Sensor, SensorKind, SensorPosition, Way};
use mechanics::watch::Unwatched;
use outcome::note::{InPassage, Note};
use outcome::passage::PassageStatus;

/// Two spans of the railway arch with a lorry in place of the train, on a coarse mesh.
pub(super) fn road(more: &str) -> Bridge {
    let read = bridge::read(road_text(more).as_bytes());
    read.bridge.unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

/// The text of its file, with more in [passage].
pub(crate) fn road_text(more: &str) -> String {
    let text = include_str!("../../../../../examples/railway-arch/passage.toml");
    let (bridge, rest) = text.split_once("[train]").unwrap();
    let (_, passage) = rest.split_once("[passage]").unwrap();
    let vehicle = "[vehicle]\naxle_loads = [\"6 t\", \"9.5 t\"]\naxle_spacings = [\"3.6 m\"]\n";
    let whole = format!("{bridge}{vehicle}\n[passage]\n{more}{passage}");
    whole
        .replace("repeat = 4 ", "repeat = 2 ")
        .replace("size = \"0.15 m\"", "size = \"0.30 m\"")
        .replace("layer = \"ballast\"", "layer = \"surfacing\"")
        .replace("time_step = \"0.005 s\"", "time_step = \"0.04 s\"")
}

/// Displacements up and along at the same place of both spans, seen from either end.
pub(super) fn sensors(share: f64) -> Vec<Sensor> {
    let one = |span, share, direction, name: &str| Sensor {
        name: name.into(),
        kind: SensorKind::Displacement(direction),
        place: SensorPosition::Span { span, share },
        face: Face::Intrados,
    };
    let [y, x] = [Direction::Vertical, Direction::Horizontal];
    vec![
        one(0, share, y, "left up"),
        one(1, 1.0 - share, y, "right up"),
        one(0, share, x, "left along"),
        one(1, 1.0 - share, x, "right along"),
    ]
}

pub(super) fn passed(bridge: &Bridge) -> (Setup, Solution) {
    let set = setup(bridge).unwrap();
    let found = solve(bridge, &set, Scope::Sensors, &[], &mut Unwatched).unwrap();
    assert_eq!(found.status, PassageStatus::Completed, "{:?}", found.reason);
    (set, found)
}

/// On fill and masonry that keep no memory a vehicle that drives to the left does to the mirrored place what one that drives to the right does here.
#[test]
fn a_vehicle_the_other_way_gives_mirrored_channels() {
    let driven = |heading| {
        let mut bridge = road("");
        bridge.service.fill.law = bridge::SoilLaw::Elastic;
        let asked = bridge.passage.as_mut().unwrap();
        (asked.plan.direction, asked.sensors) = (heading, sensors(0.4));
        asked.plan.tolerance = 1e-12;
        passed(&bridge)
    };
    let ((right, one), (left, other)) = (driven(Heading::Right), driven(Heading::Left));
    assert_eq!(right.positions.len(), left.positions.len());
    let ends = |set: &Setup| set.positions[0] + set.positions.last().unwrap();
    let surface = &right.meshed.picture().surface;
    let middle = 0.5 * (surface[0][0] + surface.last().unwrap()[0]);
    assert!(
        (right.positions[0] - surface[0][0]).abs() < 1e-9 && left.positions[0] > left.positions[1],
        "{:?}",
        ends(&left)
    );
    for (x, mirrored) in right.positions.iter().zip(&left.positions) {
        assert!((x + mirrored - 2.0 * middle).abs() < 1e-9, "{x} {mirrored}");
    }
    let largest = one.values.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
    assert!(largest > 1e-6, "{largest}");
    for (here, there, sign) in [(0, 1, 1.0), (1, 0, 1.0), (2, 3, -1.0), (3, 2, -1.0)] {
        for (a, b) in one.values[here].iter().zip(&other.values[there]) {
            assert!((a - sign * b).abs() < 1e-9 * largest, "{a} {b} of {largest}");
        }
    }
}

/// What is told of a road vehicle: the width that carries it, and how its wheels press.
#[test]
fn a_road_vehicle_is_spread_by_what_is_modelled() {
    let bridge = road("");
    let set = setup(&bridge).unwrap();
    let Some(Way::Road(wheels)) = bridge.passage.as_ref().map(|asked| &asked.way) else { panic!("a road") };
    assert_eq!(wheels.contact_length, 0.25);
    assert!((set.effective_width - (1.8 + bridge.cover.depth)).abs() < 1e-12, "{}", set.effective_width);
    let told = |note: &Note| matches!(note, Note::InPassage(InPassage::Wheels { pressed }) if *pressed == 0.25);
    assert!(set.assumptions.iter().any(told), "{:?}", set.assumptions);
    // The weight of the lorry in the middle of the bridge, and none of a track.
    let x = set.positions[set.positions.len() / 2];
    let force: f64 = set.loads.forces(x, set.meshed.sets.surface.len()).iter().sum();
    assert!((force * set.effective_width / (15.5e3 * bridge.gravity) - 1.0).abs() < 1e-9, "{force}");
    assert_eq!(set.dead_load.iter().sum::<f64>(), 0.0);
    assert!(!super::super::ground::carries_trains(&bridge), "no track is drawn or weighed");
}

/// A file has either rails or a road, and drives somewhere.
#[test]
fn what_cannot_cross_is_refused() {
    let text = |more: &str| {
        let whole = include_str!("../../../../../examples/railway-arch/passage.toml");
        bridge::read(whole.replace("[passage]\n", &format!("{more}\n[passage]\n")).as_bytes()).diagnostics
    };
    let vehicle = "[vehicle]\naxle_loads = [\"6 t\"]\naxle_spacings = []\n";
    let found = text(vehicle);
    assert!(
        found.iter().any(|one| one.severity == bridge::Severity::Error && one.message.contains("[vehicle]")),
        "{found:?}"
    );
    let back = "direction = \"left\"\nfrom = \"1 m\"\nto = \"9 m\"\n";
    let whole = include_str!("../../../../../examples/railway-arch/passage.toml");
    let found = bridge::read(whole.replace("[passage]\n", &format!("[passage]\n{back}")).as_bytes()).diagnostics;
    assert!(
        found.iter().any(|one| one.code == "B655" && one.help.as_deref().is_some_and(|help| help.contains("smaller"))),
        "{found:?}"
    );
}
