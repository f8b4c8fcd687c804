//! The formats hold what the interface promises.

use crate::analysis::vehicles::tests::plan;
use crate::analysis::{Places, collapse_by_limit};
use crate::samples::bridgemill;
use bridge::Method;
use mechanics::watch::Unwatched;
use outcome::published::*;

#[test]
fn the_object_of_a_limit_analysis_has_every_promised_key() {
    let mut b = bridgemill();
    b.plan.method = Method::Limit;
    let c = collapse_by_limit(&b, &mut mechanics::watch::Unwatched).unwrap();
    let text = json(&c.object());
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    for key in [
        "schema",
        "status",
        "warnings",
        "method",
        "collapse_load_kn_per_m",
        "last_stable_load_kn_per_m",
        "collapse_load_kn",
        "last_stable_load_kn",
        "load_step_kn_per_m",
        "hinges",
        "sliding_joints",
        "max_compressive_stress_mpa",
        "blocks",
        "particles",
        "contacts",
        "friction",
        "lower_bound_kn_per_m",
        "upper_bound_kn_per_m",
        "thrust_line",
        "seed",
        "tolerance",
    ] {
        assert!(value.get(key).is_some(), "{key}");
    }
    assert!(value.get("path").is_none());
    assert_eq!(value["schema"], "extrados.collapse/1");
    assert_eq!(value["status"], "collapsed");
    assert_eq!(value["hinges"][0]["edge"], "intrados");
    let (per_metre, total) =
        (value["collapse_load_kn_per_m"].as_f64().unwrap(), value["collapse_load_kn"].as_f64().unwrap());
    assert!((total / per_metre - 8.3).abs() < 1e-9);
    assert_eq!(value["warnings"][0]["code"], "A102");
    // Rows and columns of the tables agree with their headers.
    for table in [path(&c), hinges(&c), contacts(&c), thrust_line(&c), blocks(&c)] {
        let widths: Vec<usize> = table.lines().map(|l| l.split(',').count()).collect();
        assert!(widths.iter().all(|w| *w == widths[0]), "{table}");
    }
    assert_eq!(thrust_line(&c).lines().count(), 1 + 63);
}

/// Sweeps on deformable joints name both factors at every position, of loads and of vehicles.
#[test]
fn sweeps_on_joints_that_give_name_both_factors_at_every_position() {
    let mut b = bridgemill();
    b.plan.method = Method::Path;
    let found = crate::analysis::sweep(&b, Places::Between([3.0, 9.0], 3), true, &mut Unwatched).unwrap();
    let loads = found.object("bridge", 4.0);
    b.sweep = Some(bridge::SweepPlan { step: Some(4.0), ..plan(&["cs454-single"]) });
    let vehicles = crate::analysis::vehicle_sweep(&b, &mut Unwatched).unwrap().object();
    let both = |row: &serde_json::Value| row["rigid_factor"].is_number() && row["deformable_factor"].is_number();
    let rows = loads["positions"].as_array().unwrap();
    assert!(rows.len() >= 3 && rows.iter().all(both), "{rows:?}");
    let one = &vehicles["vehicles"][0];
    assert!(both(one) && one["envelope"].as_array().unwrap().iter().any(both), "{one}");
    assert!(one["permissible"][0]["adequacy_factor"].is_number());
}
