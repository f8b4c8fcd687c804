//! The same load at the same place is the same number: by itself, in a sweep, and dragged.

use super::placing::Placing;
use super::sweep::Places;
use super::{collapse, sweep};
use bridge::Bridge;
use mechanics::watch::Unwatched;
use outcome::collapse::Status;
use outcome::sweep::Ended;

/// A span with a knife edge, and what follows its ring.
fn of(span: &str, friction: f64, backing: f64) -> Bridge {
    let backing = match backing > 0.0 {
        true => format!("[backing]\nheight = \"{backing} m\"\ndensity = \"2200 kg/m^3\"\nas = \"blocks\"\n"),
        false => String::new(),
    };
    let text = format!(
        r#"
[bridge]
name = "t"
width = "3.0 m"
[[span]]
{span}
[abutment]
top_width = "2.0 m"
height = "2.0 m"
[[cover]]
layer = "fill"
thickness = "0.4 m"
density = "1900 kg/m^3"
[masonry]
density = "2200 kg/m^3"
compressive_strength = "8.0 MPa"
[joint]
friction_angle = "{friction} deg"
cohesion = "0 kPa"
[ring_joint]
friction_angle = "{friction} deg"
cohesion = "0 kPa"
[dispersal]
rule = "uniform"
slope = "2:1"
[[load]]
kind = "knife-edge"
force = "1 kN/m"
length = "0.3 m"
position = "2.5 m"
[analysis]
method = "limit"
{backing}"#
    );
    let read = bridge::read(text.as_bytes());
    read.bridge.unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

const ONE_RING: &str = "profile = \"semicircular\"\nspan = \"10.0 m\"\nthickness = \"0.5 m\"\nvoussoirs = 30";
const SEGMENT: &str =
    "profile = \"segmental\"\nspan = \"6.0 m\"\nrise = \"1.5 m\"\nthickness = \"0.4 m\"\nvoussoirs = 20";
const TWO_RINGS: &str = "profile = \"segmental\"\nspan = \"5.0 m\"\nrise = \"1.25 m\"\n[[span.ring]]\nthickness = \"0.22 m\"\nvoussoirs = 13\n\
                         [[span.ring]]\nthickness = \"0.22 m\"\nvoussoirs = 14";

/// The factor of the load at a place by itself.
fn alone(bridge: &Bridge, position: f64) -> f64 {
    let mut own = bridge.clone();
    own.loads[0].position = position;
    let alone = collapse(&own, None, &mut Unwatched).unwrap();
    assert_eq!(alone.status, Status::Collapsed);
    alone.load_factor().unwrap()
}

/// Places through a bridge as shares of its length.
const THROUGHOUT: [f64; 5] = [0.23, 0.35, 0.47, 0.56, 0.71];

/// The place that governs a sweep, and places at these shares of the length, each by itself, in a sweep of that place, and dragged there.
fn agree(bridge: &Bridge, count: usize, shares: &[f64]) {
    let length = structure::discretise::bridge_length(bridge);
    let swept = |places| sweep(bridge, places, true, &mut Unwatched).unwrap();
    let found = swept(Places::Between([0.1 * length, 0.9 * length], count));
    assert_eq!(found.ended(), Ended::Completed);
    let worst = found.worst().unwrap();
    let mut placing = Placing::loads(bridge).unwrap();
    for place in std::iter::once(worst.position).chain(shares.iter().map(|share| share * length)) {
        let alone = alone(bridge, place);
        let held = |what: &str, found: Option<f64>, within: f64| {
            let found = found.unwrap();
            assert!((found / alone - 1.0).abs() < within, "{place:.3} m: alone {alone:.6}, {what} {found:.6}");
        };
        if place == worst.position {
            held("governs the sweep", worst.load_factor, SAME);
        }
        held("swept", swept(Places::At(place)).points[0].load_factor, SAME);
        held("dragged", placing.carried(place).factor, SAME);
        held("put", placing.put(place).factor, SAME);
    }
}

/// To this loads agree whose forces on the blocks differ in their last bits.
const SAME: f64 = 1e-6;

#[test]
fn a_ring_between_backing_that_slides_carries_the_same_alone_swept_and_dragged() {
    agree(&of(ONE_RING, 30.0, 1.0), 13, &THROUGHOUT);
}

#[test]
fn the_same_with_more_backing_and_less_friction() {
    agree(&of(ONE_RING, 25.0, 2.0), 9, &THROUGHOUT);
}

#[test]
fn the_same_where_nothing_slides() {
    agree(&of(SEGMENT, 35.0, 0.0), 21, &THROUGHOUT);
}

#[test]
fn the_same_on_two_rings() {
    agree(&of(TWO_RINGS, 32.0, 0.0), 7, &[0.35, 0.56]);
}

/// An iteration from neighbour to neighbour had ended at 79.94 in the second quarter and at 72.34 in the first.
#[test]
fn a_sweep_answers_both_quarters_of_a_symmetric_bridge_alike() {
    let bridge = of(ONE_RING, 30.0, 1.0);
    let found = sweep(&bridge, Places::Between([1.0, 9.0], 13), true, &mut Unwatched).unwrap();
    let at = |place: f64| found.points.iter().find(|point| (point.position - place).abs() < 1e-9).unwrap();
    for place in [1.0 + 4.0 * 8.0 / 12.0, 1.0 + 8.0 * 8.0 / 12.0] {
        let (swept, alone) = (at(place).load_factor.unwrap(), alone(&bridge, place));
        assert!((swept / alone - 1.0).abs() < SAME, "{place:.3} m: alone {alone:.4}, swept {swept:.4}");
        assert!((alone - 72.3309).abs() < 1e-3, "{alone}");
    }
}

/// An arch that stands by most of its friction, under two axles.
fn standing_by_friction() -> Bridge {
    let shape =
        "profile = \"elliptical\"\nspan = \"5.457 m\"\nrise = \"0.855 m\"\nthickness = \"0.5348 m\"\nvoussoirs = 12";
    let mut bridge = of(shape, 39.3, 0.0);
    bridge.masonry.compressive_strength = None;
    let axles = vec![(116e3, 0.0), (167e3, 2.14)];
    bridge.loads[0].kind = bridge::LoadKind::Axles { axles, contact_length: 0.3, effective_width: 3.0 };
    bridge
}

/// An axle at the end of a bridge locks such an arch: that it depends on how the stones were put together leaves no sweep without an answer,
/// where the stones are seen to carry it.
#[test]
fn loads_that_lock_at_the_ends_leave_no_sweep_without_an_answer() {
    let found = sweep(&standing_by_friction(), Places::Between([0.0, 7.6], 13), true, &mut Unwatched).unwrap();
    assert_eq!((found.ended(), found.positions_not_converged()), (Ended::Completed, 0));
    let factor = found.worst().unwrap().load_factor.unwrap();
    assert!(found.points.iter().all(|point| point.load_factor.is_some_and(|here| here >= factor)));
}

/// On deformable joints its stones slip at the first touch of a load and come to rest: that is not all that they carry.
#[test]
fn stones_that_slip_at_the_first_touch_carry_what_they_come_to_rest_under() {
    let mut bridge = standing_by_friction();
    bridge.plan.method = bridge::Method::Path;
    bridge.joint.normal_stiffness = Some(bridge::JointStiffness::Contact(7.7e9));
    bridge.joint.shear_stiffness = Some(bridge::JointStiffness::Contact(3.08e9));
    for place in [2.5323, 3.1654, 3.7985] {
        let found = sweep(&bridge, Places::At(place), false, &mut Unwatched).unwrap();
        let (swept, alone) = (found.points[0].load_factor.unwrap(), alone(&bridge, place));
        // Where joints slide, paths of other steps end within a hundredth of one another (`path_forks`).
        assert!((swept / alone - 1.0).abs() < 0.01, "{place}: {swept} {alone}");
    }
}
