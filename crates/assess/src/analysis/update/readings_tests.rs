//! Moduli from a lorry at rest: a twin whose readings were computed, with noise.

use super::{Means, RecordFile, Task, Threads, judge, update};
use crate::analysis::passage::road_tests::road_text;
use crate::analysis::passage::{WantedSlices, at_rest, passage, record};
use bridge::edit::Document;
use calibrate::{Log, Unwatched};
use mechanics::watch::Unwatched as Unseen;
use outcome::passage::Measurand;
use outcome::update::{Update, UpdateStatus};
use std::fmt::Write;

/// First axles of the lorry in its six places [m].
const FRONTS: [f64; 6] = [1.0, 2.2, 3.4, 4.6, 7.6, 9.4];
/// Moduli of the truth: of the fill [MPa] and of the masonry [GPa].
pub(super) const TRUTH: [f64; 2] = [160.0, 11.0];
/// Standard deviation of a reading [mm, microstrain].
const NOISE: [f64; 2] = [0.002, 0.25];

/// The road without anything that crosses, its lorry in six places; `readings` of each, if any.
fn text(more: &str, readings: &[String]) -> String {
    text_of(more, &FRONTS, readings)
}

/// The same with its first axle in these places [m].
pub(super) fn text_of(more: &str, fronts: &[f64], readings: &[String]) -> String {
    let whole = road_text("");
    let (before, rest) = whole.split_once("[passage]").unwrap();
    let (_, sensors) = rest.split_once("[[sensor]]").unwrap();
    let before = before.replace("[\"6 t\", \"9.5 t\"]", "[\"8 t\", \"18 t\"]");
    let mut text = format!("{before}\n[load_test]\n{more}\n");
    for (k, front) in fronts.iter().enumerate() {
        let _ = writeln!(text, "[[load_test.position]]\nname = \"P{k}\"\nvehicle = {{ front_axle = \"{front} m\" }}");
        if let Some(readings) = readings.get(k) {
            let _ = writeln!(text, "readings = {{ {readings} }}");
        }
    }
    text + "[[sensor]]" + sensors
}

/// The same with the moduli of the truth in place of those of the start.
pub(super) fn truth(text: &str) -> String {
    let (fill, masonry) = ("elastic_modulus = \"110 MPa\"", "elastic_modulus = \"16 GPa\"");
    assert!(text.contains(fill) && text.contains(masonry), "{text}");
    let [of_fill, of_masonry] = TRUTH;
    text.replace(fill, &format!("elastic_modulus = \"{of_fill} MPa\""))
        .replace(masonry, &format!("elastic_modulus = \"{of_masonry} GPa\""))
}

/// Normal noise from a seed (Box and Muller 1958; SplitMix64).
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    let mut even = move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) as f64 + 1.0) / 2.0_f64.powi(64)
    };
    move || (-2.0 * even().ln()).sqrt() * (2.0 * std::f64::consts::PI * even()).cos()
}

/// What the sensors of the truth read in each position, with noise of so many standard deviations.
fn read(by: f64, seed: u64) -> Vec<String> {
    read_in("", by, seed)
}

/// The same of a test that goes on in another way.
fn read_in(sequence: &str, by: f64, seed: u64) -> Vec<String> {
    read_of(&truth(&text(sequence, &[])), by, seed)
}

/// The same of a bridge as its file has it.
pub(super) fn read_of(text: &str, by: f64, seed: u64) -> Vec<String> {
    let bridge = bridge::read(text.as_bytes()).bridge.unwrap();
    let test = at_rest::setup(&bridge).unwrap();
    let found = test.solve(&bridge, WantedSlices::default(), &mut Unseen).unwrap();
    let mut noise = noise(seed);
    let mut reading = |k: usize, position: usize| {
        let sensor = &test.setup.sensors[k];
        let deviation = NOISE[usize::from(sensor.quantity == Measurand::Strain)];
        let value = sensor.quantity.scale() * found.values[k][position] + by * deviation * noise();
        format!("\"{}\" = \"{value} {}\"", sensor.name, sensor.quantity.unit())
    };
    (0..test.names.len())
        .map(|p| (0..test.setup.sensors.len()).map(|k| reading(k, p)).collect::<Vec<_>>().join(", "))
        .collect()
}

pub(super) const SOUGHT: &str = r#"
[[parameter]]
quantity = "fill.elastic_modulus"
name = "fill"
lower = "40 MPa"
upper = "400 MPa"
spacing = "logarithmic"

[[parameter]]
quantity = "masonry.elastic_modulus"
name = "masonry"
lower = "5 GPa"
upper = "30 GPa"
spacing = "logarithmic"

[update]
starts = 1
model_error = 0.0
common_gain_deviation = 0.0
"#;

pub(super) fn uncertainty() -> String {
    let [mm, micro] = NOISE;
    let of = |name: &str| format!("\"{name} displacement\" = \"{mm} mm\", \"{name} strain\" = \"{micro} microstrain\"");
    format!("uncertainty = {{ {} }}", ["crown", "pier springing", "abutment springing"].map(of).join(", "))
}

pub(super) fn with<T>(text: &str, files: &[RecordFile], run: impl FnOnce(&Task<'_>, Means<'_>) -> T) -> T {
    let read = bridge::read(text.as_bytes());
    let bridge = read.bridge.unwrap_or_else(|| panic!("{:?}", read.diagnostics));
    let asked = read.update.unwrap();
    let mut document = Document::parse(text).unwrap();
    bridge::UPDATE_SECTIONS.iter().for_each(|section| document.remove(section));
    let task = Task { bridge: &bridge, document: &document, asked: &asked, files };
    run(&task, Means { map: &Threads, watch: &mut Unwatched, clock: &|| 0.0 })
}

pub(super) fn updated(text: &str, files: &[RecordFile]) -> Update {
    with(text, files, |task, means| update(task, Log::new(&task.identity()), means).unwrap())
}

/// Whether the interval of each parameter holds the truth.
fn covered(found: &Update) -> [bool; 2] {
    std::array::from_fn(|k| {
        let [low, high] = found.summary(k).unwrap().interval_95;
        (low..=high).contains(&TRUTH[k])
    })
}

/// Without noise the truth is found, from readings alone; with noise its intervals hold it, and the norm is that of the noise.
#[test]
fn moduli_are_found_by_a_lorry_in_six_places() {
    let exact = updated(&(text(&uncertainty(), &read(0.0, 1)) + SOUGHT), &[]);
    assert_eq!(exact.status, UpdateStatus::Completed, "{:?}", exact.reason);
    let best = exact.found().unwrap();
    for (found, wanted) in best.point().iter().zip(TRUTH) {
        assert!((found / wanted - 1.0).abs() < 1e-3, "{:?}", best.point());
    }
    assert!(best.norm < 0.02 && exact.basis.as_ref().unwrap().start.norm > 3.0, "{} {:?}", best.norm, exact.basis);
    assert!(exact.times.is_empty() && exact.channels.is_empty() && exact.records.runs.is_empty());

    let noisy = updated(&(text(&uncertainty(), &read(1.0, 7)) + SOUGHT), &[]);
    assert!(covered(&noisy) == [true, true], "{:?}", (noisy.summary(0), noisy.summary(1)));
    let norm = noisy.found().unwrap().norm;
    // 36 readings with noise of one, two parameters.
    assert!((0.7..1.3).contains(&norm), "{norm}");
    let object = noisy.object();
    assert_eq!(object["channels"][0]["name"], "crown displacement (load test)");
    let crown = &object["positions"][1]["channels"]["crown displacement"];
    let number = |key: &str| crown[key].as_f64().unwrap();
    assert!((number("updated") - number("measured")).abs() < 4.0 * NOISE[0], "{crown}");
    assert_eq!(outcome::published::readings_table(&noisy).lines().count(), 1 + FRONTS.len());
}

/// A sensor that is left out or reversed, one that was not read everywhere, and one without an uncertainty.
#[test]
fn what_is_said_of_channels_holds_for_readings() {
    let mut readings = read(1.0, 3);
    for reading in &mut readings {
        // Turned round, and turned back below.
        *reading = reading.replace("\"crown displacement\" = \"-", "\"crown displacement\" = \"+");
    }
    readings[2] = readings[2].split(", ").next().unwrap().to_owned();
    let said = "[[channel]]\nsensor = \"crown displacement\"\nreversed = true\nuncertainty = 0.002\n\
                [[channel]]\nsensor = \"pier springing strain\"\nleave_out = \"a loose gauge\"\n";
    let text = text("", &readings) + said + SOUGHT;
    let found = updated(&text, &[]);
    let channels = found.problem.channels();
    assert_eq!((channels.len(), channels[0].history.as_ref().unwrap().len()), (6, 6));
    assert!(
        channels[0].history.as_ref().unwrap().iter().any(|value| *value < 0.0)
            && channels[0].uncertainty == Some(0.002)
    );
    assert_eq!(channels[1].history.as_ref().unwrap().len(), 5, "not read in one position");
    assert_eq!(channels[4].left_out.as_deref(), Some("a loose gauge"));
    let silent = "No uncertainty is stated for the readings of pier springing displacement (load test), abutment springing displacement";
    assert!(found.assumptions.iter().any(|note| note.to_string().starts_with(silent)), "{:?}", found.assumptions);
    for (found, wanted) in found.found().unwrap().point().iter().zip(TRUTH) {
        assert!((found / wanted - 1.0).abs() < 0.2, "{found} {wanted}");
    }
    let judged = with(&text, &[], |task, means| judge(task, means).unwrap());
    assert!(judged.found().is_none() && judged.read_at_rest[0].start.len() == 6);
}

/// In order, with what yielding leaves behind, the search goes by differences and comes to the same truth.
#[test]
fn positions_in_order_are_updated_too() {
    let order = "sequence = \"in-order\"\n";
    let readings = read_in(order, 0.0, 1);
    assert_ne!(readings, read(0.0, 1));
    let found = updated(&(text(&format!("{order}{}", uncertainty()), &readings) + SOUGHT), &[]);
    assert_eq!(found.status, UpdateStatus::Completed, "{:?} {:?}", found.reason, found.searches);
    for (found, wanted) in found.found().unwrap().point().iter().zip(TRUTH) {
        assert!((found / wanted - 1.0).abs() < 5e-3, "{found} {wanted}");
    }
}

/// A crossing and a load test in one problem: both are compared in multiples of their uncertainty, and tell more together.
#[test]
fn records_and_readings_are_compared_together() {
    let passing = "[passage]\nspeed = \"5 km/h\"\ntime_step = \"0.4 s\"\n";
    let crossed = bridge::read(truth(&(text("", &[]) + passing)).as_bytes()).bridge.unwrap();
    let crossed = passage(&crossed, &mut Unseen).unwrap();
    let run = record(&crossed, "twin", "a test", &record::Logger::NONE);
    let files = [RecordFile { name: "twin.csv".into(), bytes: records::write(&run).into_bytes() }];
    let [mm, micro] = NOISE;
    let mut said = String::new();
    for name in ["crown", "pier springing", "abutment springing"] {
        for (what, deviation) in [("displacement", mm), ("strain", micro)] {
            let _ = writeln!(said, "[[channel]]\nsensor = \"{name} {what}\"\nuncertainty = {deviation}");
        }
    }
    let records = "[records]\nplace = \"twin.csv\"\n";
    let both = text("", &read(1.0, 5)) + passing + records + &said + SOUGHT;
    let found = updated(&both, &files);
    assert_eq!(found.status, UpdateStatus::Completed, "{:?}", found.reason);
    assert_eq!((found.problem.channels().len(), found.channels.len(), found.read_at_rest.len()), (12, 6, 6));
    let weights = &found.basis.as_ref().unwrap().held.weights;
    assert!(weights[..6].iter().all(|weight| *weight <= 1.0) && weights[6..] == [6.0; 6], "{weights:?}");
    let alone = updated(&(text(&uncertainty(), &read(1.0, 5)) + SOUGHT), &[]);
    for k in 0..2 {
        let [both, alone] = [&found, &alone].map(|found| found.summary(k).unwrap().standard_deviation);
        assert!(both < alone, "{both} {alone}");
        assert!((found.found().unwrap().point()[k] / TRUTH[k] - 1.0).abs() < 0.05);
    }
    // A record without an uncertainty cannot be weighed against readings.
    let silent = text("", &read(1.0, 5)) + passing + records + SOUGHT;
    let refused = with(&silent, &files, |task, means| update(task, Log::new(&task.identity()), means).unwrap_err());
    assert!(refused.to_string().contains("it has no uncertainty above zero"), "{refused}");
}

/// Intervals of 95 % hold the truth in at least 45 of 50 load tests.
#[test]
#[ignore = "fifty updates, minutes"]
fn intervals_hold_the_truth_as_often_as_they_say() {
    let mut held = [0; 2];
    for seed in 100..150 {
        let found = updated(&(text(&uncertainty(), &read(1.0, seed)) + SOUGHT), &[]);
        covered(&found).iter().zip(&mut held).for_each(|(held, count)| *count += usize::from(*held));
    }
    assert!(held.iter().all(|held| *held >= 45), "{held:?} of 50");
}
