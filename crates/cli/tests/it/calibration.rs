//! Calibration of fill as its users meet it, on fewer and larger particles than the example has.

use crate::stage::{Stage, number, numbers, object};
use std::process::{Command, Stdio};
use std::time::Duration;

/// The example with a coarse fill and few load steps: some seconds.
fn coarse(name: &str) -> Stage {
    let stage = Stage::with_example(name, "bridgemill");
    let text = stage.read("bridge/calibration.toml");
    let (start, end) = (text.find("compare_with").expect("moduli"), text.find("[masonry]").expect("masonry"));
    let coarse = "multiples = [1, 4]\nsteps = 3\nignored_steps = 1\nseeds = 2\ntolerance = 0.05\n\n";
    let text = format!("{}{coarse}{}", &text[..start], &text[end..]).replace("count = 1984", "count = 400");
    stage.write("fill.toml", text);
    stage
}

#[test]
fn a_wanted_modulus_gives_a_stiffness_and_its_check() {
    let stage = coarse("calibration-found");
    let (answer, ending) = stage.object(&["calibrate-fill", "fill.toml", "--out", "o"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert_eq!((&answer["schema"], &answer["status"]), (&"extrados.calibrate-fill/1".into(), &"completed".into()));
    // Within the tolerance of the file, or at a jump of the modulus: fifteen squares of few particles jump.
    assert!((number(&answer, "tangent_modulus_mpa") / 40.0 - 1.0).abs() < 0.1);
    let (normal, shear) =
        (number(&answer, "contact_normal_stiffness_gpa_per_m"), number(&answer, "contact_shear_stiffness_gpa_per_m"));
    let first = number(&answer, "first_normal_stiffness_gpa_per_m");
    assert!((normal / (first * number(&answer, "multiple")) - 1.0).abs() < 1e-12);
    // Both are scaled alike: their ratio is that of the file, about 1 / 2.4.
    assert!((shear / normal * 2.4 - 1.0).abs() < 0.01, "{normal} {shear}");
    assert!(number(&answer, "secant_modulus_mpa") <= number(&answer, "tangent_modulus_mpa"));
    assert!(number(&answer, "check_modulus_mpa") > 20.0 && number(&answer, "check_standard_error_mpa") > 0.0);
    assert_eq!(answer["seeds"], serde_json::json!([1, 2]));
    assert_eq!(answer["check_seeds"], serde_json::json!([3, 4]));
    assert_eq!(answer["curve"].as_array().map(Vec::len), Some(4));
    assert!(answer["particles"].as_u64() > Some(100));
    let names = stage.names("o");
    for name in ["curve.csv", "moduli.csv", "moduli.png", "result.json", "sample.svg", "stress-strain.svg"] {
        assert!(names.contains(&name.to_owned()), "{name} in {names:?}");
    }
    let header = stage.read("o/curve.csv").lines().next().map(str::to_owned);
    assert_eq!(header.as_deref(), Some("multiple,seed,square,step,stress_kpa,strain,displacement_mm"));
}

#[test]
fn threads_change_no_bit_of_a_calibration() {
    let stage = coarse("calibration-threads");
    let with = |threads: &str| {
        let words = ["calibrate-fill", "fill.toml", "--seeds", "1", "--threads", threads, "--out", threads];
        let (answer, ending) = stage.object(&words);
        assert!(matches!(ending.code, Some(0 | 3)), "{}", ending.stderr);
        numbers(answer)
    };
    assert_eq!(with("1"), with("2"));
    assert_eq!(stage.read("1/curve.csv"), stage.read("2/curve.csv"));
}

#[test]
fn a_modulus_that_stiffness_cannot_give_is_an_answer() {
    let stage = coarse("calibration-reach");
    let words = ["calibrate-fill", "fill.toml", "--seeds", "1", "--modulus", "1 MPa"];
    let (answer, ending) = stage.object(&words);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(3), Some("undetermined")), "{}", ending.stderr);
    let warned = answer["warnings"].as_array().is_some_and(|list| list.iter().any(|one| one["code"] == "A120"));
    assert!(warned, "{answer}");
    let [low, high] = [0, 1].map(|k| answer["reach"][k]["modulus_mpa"].as_f64());
    assert!(low > Some(1.0) && high > low, "{answer}");
    let (answer, _) = stage.object(&["calibrate-fill", "bridge/case-1.toml"]);
    assert_eq!(answer["errors"][0]["code"], "F108");
}

#[cfg(unix)]
#[test]
fn an_interrupted_calibration_says_so() {
    let stage = Stage::with_example("calibration-signal", "bridgemill");
    let words = ["calibrate-fill", "bridge/calibration.toml", "--out", "o", "--json", "--quiet"];
    let child =
        stage.command(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
    std::thread::sleep(Duration::from_secs(1));
    let told = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
    assert!(told.success());
    let output = child.wait_with_output().expect("it ends");
    let answer = object(&String::from_utf8_lossy(&output.stdout));
    assert_eq!((output.status.code(), answer["status"].as_str()), (Some(130), Some("cancelled")));
    assert!(stage.names("o").is_empty(), "nothing half-written");
}
