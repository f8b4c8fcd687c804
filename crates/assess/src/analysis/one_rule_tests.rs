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

/// Of a sweep the governing place, and of places through the bridge what is dragged there, against the load by itself.
fn agree(bridge: &Bridge, count: usize, apart: f64) {
    let length = structure::discretise::bridge_length(bridge);
    let found = sweep(bridge, Places::Between([0.1 * length, 0.9 * length], count), true, &mut Unwatched).unwrap();
    assert_eq!(found.ended(), Ended::Completed);
    let worst = found.worst().unwrap();
    let alone = |position: f64| {
        let mut own = bridge.clone();
        own.loads[0].position = position;
        let alone = collapse(&own, None, &mut Unwatched).unwrap();
        assert_eq!(alone.status, Status::Collapsed);
        alone.load_factor().unwrap()
    };
    let held = |what: &str, position: f64, found: f64| {
        let alone = alone(position);
        assert!((found / alone - 1.0).abs() < apart, "{position:.3} m: alone {alone:.4}, {what} {found:.4}");
    };
    held("swept", worst.position, worst.load_factor.unwrap());
    let mut placing = Placing::loads(bridge).unwrap();
    for place in [worst.position, 0.35 * length, 0.56 * length] {
        held("dragged", place, placing.carried(place).factor.unwrap());
        held("put", place, placing.put(place).factor.unwrap());
    }
}

#[test]
fn a_ring_between_backing_that_slides_carries_the_same_alone_swept_and_dragged() {
    agree(&of(ONE_RING, 30.0, 1.0), 13, 2e-3);
}

#[test]
fn the_same_with_more_backing_and_less_friction() {
    agree(&of(ONE_RING, 25.0, 2.0), 9, 2e-3);
}

#[test]
fn the_same_where_nothing_slides() {
    agree(&of(SEGMENT, 35.0, 0.0), 21, 1e-6);
}

#[test]
fn the_same_on_two_rings() {
    agree(&of(TWO_RINGS, 32.0, 0.0), 7, 5e-3);
}
