//! The formats hold what the interface promises.

use crate::analysis::collapse_by_limit;
use crate::samples::bridgemill;
use bridge::Method;
use outcome::published::*;

#[test]
fn the_object_of_a_limit_analysis_has_every_promised_key() {
    let mut b = bridgemill();
    b.plan.method = Method::Limit;
    let c = collapse_by_limit(&b, &mut mechanics::watch::Unwatched).unwrap();
    let text = json(&collapse(&c));
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
