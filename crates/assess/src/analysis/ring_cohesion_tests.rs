//! Cohesion between rings helps, and comes and goes: the load without it leads, below that of rigid blocks, and the load with it stands beside it and is no less.

use super::*;
use mechanics::watch::Unwatched;
use outcome::help::Help;

fn rings(cohesion: f64) -> Bridge {
    let text = format!(
        r#"
[bridge]
name = "t"
width = "3.0 m"
[[span]]
profile = "segmental"
span = "6.0 m"
rise = "1.5 m"
[[span.ring]]
thickness = "0.2 m"
voussoirs = 24
[[span.ring]]
thickness = "0.2 m"
voussoirs = 24
[[cover]]
layer = "fill"
thickness = "0.4 m"
density = "1900 kg/m^3"
[masonry]
density = "2200 kg/m^3"
compressive_strength = "8.0 MPa"
[joint]
normal_stiffness = "10 GPa/m"
shear_stiffness = "4.0 GPa/m"
friction_angle = "35 deg"
cohesion = "0 kPa"
[ring_joint]
normal_stiffness = "10 GPa/m"
shear_stiffness = "4.0 GPa/m"
friction_angle = "28 deg"
cohesion = "{cohesion} kPa"
[dispersal]
rule = "uniform"
slope = "2:1"
[[load]]
kind = "knife-edge"
force = "1 kN/m"
length = "0.3 m"
position = "1.5 m"
[analysis]
method = "path"
"#
    );
    let read = ::bridge::read(text.as_bytes());
    read.bridge.unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

/// Joints whose cohesion holds much shear on little of their length have tangents that are far from symmetric: that is no reason to say that they fall.
#[test]
fn rings_with_cohesion_carry_no_less_and_the_load_without_it_leads() {
    let bare = collapse(&rings(0.0), None, &mut Unwatched).unwrap().last_stable_load.unwrap();
    let limit = collapse_by_limit(&rings(0.0), &mut Unwatched).unwrap().collapse_load.unwrap();
    let mut before = bare;
    for cohesion in [5.0, 20.0, 50.0, 100.0] {
        let found = collapse(&rings(cohesion), None, &mut Unwatched).unwrap();
        assert_eq!(found.last_stable_load, Some(bare), "{cohesion} kPa: the load without it leads");
        assert!(bare < limit);
        let with = found.not_counted.with(Help::Cohesion).unwrap_or_else(|| panic!("{cohesion} kPa adds something"));
        let load = with.headline.unwrap();
        // Loads of rings that slide hang on the steps by half a percent (docs/theory/path.md), and two of them are compared.
        assert!(load > 0.98 * before, "{cohesion} kPa: {load} after {before}");
        before = load;
    }
    assert!(before > 1.2 * bare, "{before}");
}
