//! The records of `examples/railway-arch/table-1/`: shapes of the start model of `update.toml`, scaled channel by channel to the peaks
//! that the railway paper prints. `EXTRADOS_WRITE_RECORDS=1` writes them anew.

use crate::stage::{Stage, number};
use std::fmt::Write;
use std::path::Path;

/// Run, speed [km/h] and peaks in the order of the sensors [mm, microstrain]: Table 1 of the paper.
const TABLE_1: [(&str, f64, [f64; 6]); 3] = [
    ("crawling", 5.0, [-0.30, 0.24, -0.04, 22.1, -24.62, -24.0]),
    ("slow", 20.0, [-0.27, 0.27, -0.04, 21.4, -24.83, -22.2]),
    ("design", 65.0, [-0.34, 0.24, -0.04, 19.4, -25.68, -23.2]),
];
/// Speed of the passage whose shapes they are [km/h].
const SPEED: f64 = 45.0;

/// The record of one run: times at its own speed, every channel scaled to its peak.
fn record(channels: &str, (run, speed, peaks): (&str, f64, [f64; 6])) -> String {
    let rows: Vec<Vec<f64>> = channels
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    let largest =
        |column: usize| rows.iter().map(|row| row[column]).fold(0.0_f64, |a, b| if b.abs() > a.abs() { b } else { a });
    let names = ["crown displacement [mm]", "pier springing displacement [mm]", "abutment springing displacement [mm]"];
    let strains = ["crown strain", "pier springing strain", "abutment springing strain"]
        .map(|name| format!("{name} [microstrain]"));
    let mut text = "# synthetic: shapes computed by this tool (update.toml, start values), scaled channel by channel to the peaks \
                    of the railway paper's Table 1\n"
        .to_owned();
    let _ = writeln!(text, "# run: {run}\n# speed: {speed} km/h\ntime [s],{},{}", names.join(","), strains.join(","));
    let scales: Vec<f64> = (0..6).map(|k| peaks[k] / largest(k + 1)).collect();
    for row in &rows {
        let _ = write!(text, "{:.6}", row[0] * SPEED / speed);
        for (value, scale) in row[1..].iter().zip(&scales) {
            let _ = write!(text, ",{:.6}", value * scale);
        }
        text.push('\n');
    }
    text
}

fn cells(text: &str) -> Vec<Vec<f64>> {
    let data = text.lines().filter(|line| !line.starts_with(['#', 't']));
    data.map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect()).collect()
}

#[test]
#[ignore = "a whole passage; .ci/slow"]
fn records_scaled_to_table_1_are_those_of_the_start_model() {
    let stage = Stage::with_example("table-1", "railway-arch");
    let (answer, ending) = stage.object(&["respond", "bridge/update.toml", "--out", "shapes", "--quiet"]);
    assert_eq!(ending.code, Some(0), "{answer}");
    let channels = stage.read("shapes/channels.csv");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/railway-arch/table-1");
    for run in TABLE_1 {
        let path = folder.join(format!("{}.csv", run.0));
        let text = record(&channels, run);
        if std::env::var_os("EXTRADOS_WRITE_RECORDS").is_some() {
            std::fs::write(&path, &text).expect("the example can be written");
        }
        let kept = std::fs::read_to_string(&path).expect("a record");
        assert!(kept.starts_with("# synthetic: "), "{}", path.display());
        // Printed with six decimals.
        for (one, two) in cells(&text).iter().zip(&cells(&kept)) {
            let near = one.iter().zip(two).all(|(a, b)| (a - b).abs() <= 2e-6 * b.abs().max(1.0));
            assert!(near, "{}: {one:?} {two:?}", path.display());
        }
        assert_eq!(text.lines().count(), kept.lines().count());
    }
}

#[test]
fn records_scaled_to_table_1_are_judged_like_the_table() {
    let stage = Stage::with_example("table-1-judged", "railway-arch");
    // A tenth of the positions is enough for peaks and for the judgement.
    let text = stage.read("bridge/update-table-1.toml").replace("time_step = \"0.04 s\"", "time_step = \"0.4 s\"");
    stage.write("bridge/update-table-1.toml", text);
    let (answer, ending) = stage.object(&["update", "bridge/update-table-1.toml", "--records-only", "--quiet"]);
    assert_eq!(ending.code, Some(0), "{answer}");
    assert_eq!(
        answer["records"]["peaks"].as_array().map(Vec::len),
        Some(12),
        "two channels of six are left out: {answer}"
    );
    // "The site data shows insignificant dynamic effects" (section 3.2): six channels tell so (crates/records/tests/it/table_1.rs), four
    // leave the tenth that would matter within the interval.
    assert_eq!(answer["records"]["dynamics"]["answer"], "cannot-tell", "{}", answer["records"]["dynamics"]);
    // The shapes stand 5 m further along than this model has the bridge: clocks are laid on the axles, 0.40 s at 45 km/h.
    let done = answer["records"]["done"].to_string();
    let shifts: Vec<f64> =
        done.split("clock shifted by ").skip(1).filter_map(|rest| rest.split(' ').next()?.parse().ok()).collect();
    for (shift, speed) in shifts.iter().zip([5.0, 65.0, 20.0]) {
        assert!((shift * speed / SPEED - 0.40).abs() < 0.01, "{done}");
    }
    assert_eq!(shifts.len(), 3, "{done}");
    let measured = |k: usize| number(&answer["channels"][k], "measured_peak");
    // Means over the three speeds.
    assert!((measured(0) + 0.91 / 3.0).abs() < 1e-4 && (measured(4) + 75.13 / 3.0).abs() < 1e-3, "{answer}");
    // The record's -0.04 mm is to the paper's axis; the sensor's is away from the span.
    assert!((measured(2) - 0.04).abs() < 1e-4, "{answer}");
    for (k, left) in [false, false, true, true, false, false].into_iter().enumerate() {
        assert_eq!(answer["channels"][k]["left_out"].is_string(), left, "{answer}");
    }
}
