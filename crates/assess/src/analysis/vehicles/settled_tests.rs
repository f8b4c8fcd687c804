//! Positions at which a case found no largest factor, and which cannot govern.

use super::vehicle_sweep;
use bridge::Bridge;
use mechanics::watch::Unwatched;
use outcome::sweep::Ended;

/// Two spans on a pier as wide as a span. Over it, with one axle beside it, the interior-point method rests before it has an answer.
const FILE: &str = r#"
[bridge]
name = "t"
width = "6 m"
[[span]]
profile = "segmental"
span = "6.0 m"
rise = "1.5 m"
thickness = "0.4 m"
voussoirs = 30
[[span]]
profile = "segmental"
span = "6.0 m"
rise = "1.5 m"
thickness = "0.4 m"
voussoirs = 30
[[pier]]
width = "10 m"
height = "0.5 m"
courses = 1
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
friction_angle = "35 deg"
cohesion = "0 kPa"
[dispersal]
rule = "uniform"
slope = "2:1"
[[load]]
kind = "knife-edge"
force = "1 kN/m"
length = "0.3 m"
position = "1.5 m"
[analysis]
method = "limit"
[sweep]
rule = "characteristic"
vehicles = ["v"]
vehicle_files = ["v.toml"]
step = "0.1 m"
"#;

const VEHICLE: &str = r#"
code = "v"
title = "v"
ways = "road"
source = { text = "own", date = "2024", confidence = "read" }
[[vehicle]]
code = "v"
title = "two axles"
axle_loads_kn = [80.0, 100.0]
spacings_m = [5.6]
axles_may_be_dropped = true
wheel_track_m = 1.80
contact_length_m = 0.30
[[under]]
rule = "characteristic"
live_load = { value = 1.0, source = { text = "own", date = "2020", confidence = "read" } }
[under.impact]
kind = "all-axles"
factor = { value = 1.0, source = { text = "own", date = "2001", confidence = "read" } }
"#;

fn wide() -> Bridge {
    let mut bridge = bridge::read(FILE.as_bytes()).bridge.unwrap();
    bridge.sweep.as_mut().unwrap().texts = vec![("v.toml".to_owned(), VEHICLE.to_owned())];
    bridge
}

#[test]
fn a_place_without_an_answer_that_cannot_govern_settles_nothing_less() {
    let found = vehicle_sweep(&wide(), &mut Unwatched).unwrap();
    assert_eq!(found.status(), Ended::Completed);
    let one = &found.vehicles[0];
    assert_eq!((one.positions_not_converged, one.adequacy_at_most), (0, None));
    let adequacy = one.adequacy.unwrap();
    assert!((adequacy - 4.258).abs() < 2e-3, "{adequacy}");
    let least = one.envelope.iter().filter_map(|point| point.adequacy).fold(f64::INFINITY, f64::min);
    assert!((least / adequacy - 1.0).abs() < 1e-6, "{least} {adequacy}");
}
