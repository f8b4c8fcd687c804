//! Trains over random bridges: whatever the file can express ends in an answer or in a named status, and never in a panic.
//!
//! `cargo test --release -p assess --test random_passages` draws the first fifty bridges, `-- --ignored` a thousand. Ground that flows under
//! its own weight takes Newton's method minutes; whoever looks on loses patience then, and being stopped is an ending with a name too.

mod random;

use assess::analysis::passage::passage;
use mechanics::watch::{Progress, Watch, Wish};
use outcome::passage::{Part, Passage, PassageStatus};
use random::{Dice, begin_span, pier, quantities};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// A bridge file with a train.
fn draw(seed: u64) -> String {
    let dice = &mut Dice(seed);
    let mut page = String::new();
    let width = dice.between(2.0, 12.0);
    let _ = writeln!(page, "[bridge]\nname = \"random {seed}\"\nwidth = \"{width:.2} m\"\n");
    let span = dice.usual([2.0, 20.0], [0.6, 80.0]);
    let profile = dice.of(&["segmental", "semicircular", "parabolic", "elliptical", "pointed"]);
    let flattest = if profile == "segmental" { [0.08, 0.5] } else { [0.1, 0.6] };
    let ratio = dice.rise(profile, flattest, 0.9);
    let thickness = span * dice.usual([0.04, 0.15], [0.01, 0.3]);
    let repeat = dice.count(1, 3);
    let voussoirs = dice.count(3, 15);
    begin_span(profile, span, ratio * span, &mut page);
    let _ = writeln!(page, "thickness = \"{thickness:.4} m\"\nvoussoirs = {voussoirs}\nrepeat = {repeat}\n");
    if repeat > 1 {
        let width = 2.0 * thickness + span * dice.usual([0.15, 0.4], [0.05, 1.5]);
        let height = span * dice.usual([0.2, 1.0], [0.02, 4.0]);
        pier(width, height, dice.count(1, 4), &mut page);
    }
    let [top, height] = [0.3, 0.5].map(|share| span * share * dice.usual([0.5, 2.0], [0.1, 6.0]));
    let _ = writeln!(page, "[abutment]\ntop_width = \"{top:.3} m\"\nheight = \"{height:.3} m\"\n");
    let _ = writeln!(
        page,
        "[masonry]\ndensity = \"{:.0} kg/m^3\"\nelastic_modulus = \"{:.6} GPa\"\npoisson_ratio = {:.3}\n\
         compressive_strength = \"unlimited\"\n\n[joint]\nfriction_angle = \"35 deg\"\ncohesion = \"0 kPa\"\n",
        dice.usual([1800.0, 2800.0], [100.0, 8000.0]),
        dice.usual([1.0, 40.0], [1e-3, 1e3]),
        dice.between(0.0, 0.45)
    );
    let _ = writeln!(
        page,
        "[[cover]]\nlayer = \"fill\"\nthickness = \"{:.3} m\"\ndensity = \"{:.0} kg/m^3\"\n",
        dice.usual([0.2, 1.5], [0.05, 10.0]),
        dice.usual([1500.0, 2200.0], [500.0, 4000.0])
    );
    let size = (0.25 * span).min(2.0 * thickness).max(0.02 * span);
    let _ = writeln!(page, "[mesh]\nsize = \"{size:.3} m\"\nring_nodes = {}\n", dice.count(2, 7));
    soil(dice, "fill", &mut page);
    if dice.often(0.3) {
        let _ = writeln!(
            page,
            "[haunch_fill]\nheight = \"{:.3} m\"\nelastic_modulus = \"{:.3} MPa\"\n",
            0.4 * ratio * span,
            dice.usual([100.0, 3000.0], [0.1, 1e5])
        );
    }
    let _ = writeln!(
        page,
        "[mortar]\nelastic_modulus = \"{:.6} GPa\"\nthickness = \"{:.2} mm\"\nlift_off = \"{:.4} kN\"\nshear_strength = \"{:.4} MPa\"\n",
        dice.usual([0.2, 5.0], [1e-3, 1e3]),
        dice.usual([5.0, 20.0], [0.5, 100.0]),
        dice.usual([0.1, 10.0], [1e-6, 1e4]),
        dice.usual([0.3, 3.0], [1e-3, 1e3])
    );
    let roughest = if dice.often(0.8) { 0.8 } else { 2.0 };
    let _ = writeln!(
        page,
        "[fill_contact]\nfriction_coefficient = {:.3}\nseparation = {}\n",
        dice.between(0.0, roughest),
        dice.often(0.4)
    );
    train(dice, span, &mut page);
    page
}

fn soil(dice: &mut Dice, table: &str, page: &mut String) {
    let law = dice.of(&["drucker-prager", "drucker-prager", "mohr-coulomb", "elastic"]);
    let steepest = if dice.often(0.8) { 42.0 } else { 60.0 };
    let friction = dice.between(0.0, steepest);
    let _ = writeln!(
        page,
        "[{table}]\nelastic_modulus = \"{:.4} MPa\"\npoisson_ratio = {:.3}\ndensity = \"{:.0} kg/m^3\"\nfriction_angle = \"{friction:.2} deg\"\n\
         cohesion = \"{:.4} kPa\"\ndilatancy_angle = \"{:.2} deg\"\nlaw = \"{law}\"\ncone = \"{}\"\n",
        dice.usual([20.0, 500.0], [0.1, 1e5]),
        dice.between(0.0, 0.45),
        dice.usual([1500.0, 2200.0], [500.0, 4000.0]),
        dice.usual([1.0, 50.0], [1e-3, 1e4]),
        friction * dice.unit() * f64::from(u8::from(dice.often(0.5))),
        dice.of(&["compression", "extension", "plane-strain", "inner"])
    );
}

fn train(dice: &mut Dice, span: f64, page: &mut String) {
    let axles = dice.count(1, 4);
    let loads = quantities((0..axles).map(|_| dice.usual([5.0, 30.0], [0.01, 1000.0])), 3, "t");
    let spacings = quantities((1..axles).map(|_| dice.usual([1.5, 6.0], [0.3, 30.0])), 3, "m");
    let speed = dice.usual([5.0, 120.0], [0.5, 400.0]);
    // A few positions on the first span.
    let positions = dice.count(3, 6);
    let time_step = span / positions as f64 / (speed / 3.6);
    let _ = writeln!(
        page,
        "[train]\n\n[[train.vehicle]]\naxle_loads = [{loads}]\naxle_spacings = [{spacings}]\nfront_overhang = \"1 m\"\nrear_overhang = \"1 m\"\n\n\
         [track]\nrail_bending_stiffness = \"4.47 MNm^2\"\ntrack_modulus = \"{:.4} MPa\"\nsleeper_spacing = \"0.60 m\"\n\
         sleeper_breadth = \"0.25 m\"\nsleeper_length = \"2.75 m\"\nballast_depth = \"{:.3} m\"\nballast_slope = \"2:1\"\ndead_load = \"1.1 kPa\"\n\n\
         [passage]\nspeed = \"{speed:.3} km/h\"\nfrom = \"0 m\"\nto = \"{:.4} m\"\ntime_step = \"{:.6} s\"\nanalysis = \"{}\"\n\
         damping_ratio = 0.03\ndamping_frequencies = [\"5 Hz\", \"50 Hz\"]\nkinematics = \"{}\"\npath = \"{}\"\nload_steps = 10\n\
         iterations = 100\ntolerance = 1e-6",
        dice.usual([10.0, 50.0], [0.5, 500.0]),
        dice.between(0.0, 0.05),
        span,
        time_step.max(1e-5),
        if dice.often(0.2) { "transient" } else { "static" },
        if dice.often(0.2) { "large" } else { "small" },
        if dice.often(0.5) { "condensed" } else { "plain" },
    );
}

/// An onlooker who stops what takes long.
struct Patience(Instant);

impl Watch for Patience {
    fn look(&mut self, _: &Progress) -> Wish {
        if self.0.elapsed() > Duration::from_secs(2) { Wish::Stop } else { Wish::GoOn }
    }
}

/// How a drawn file ended, in a word; what must not be, in words, together with the file.
fn ending(seed: u64) -> Result<String, String> {
    let text = draw(seed);
    let told = |what: String| format!("seed {seed}: {what}\n\n{text}");
    let run = catch_unwind(AssertUnwindSafe(|| {
        let read = bridge::read(text.as_bytes());
        let Some(bridge) = read.bridge else {
            let errors = read.diagnostics.iter().filter(|d| d.severity == bridge::Severity::Error);
            return Err(format!(
                "refused: {}",
                errors.map(|d| format!("{} {}", d.code, d.message)).collect::<Vec<_>>().join("; ")
            ));
        };
        passage(&bridge, &mut Patience(Instant::now())).map_err(|error| format!("not set up: {error}"))
    }));
    match run {
        Err(_) => Err(told("a panic".into())),
        Ok(Err(refusal)) => Ok(refusal),
        Ok(Ok(found)) => sound(&found).map(|()| found.status.word().to_owned()).map_err(told),
    }
}

/// What an answer claims must hold.
fn sound(found: &Passage) -> Result<(), String> {
    let numbers = found.channels.iter().flat_map(|channel| channel.values.iter().chain([&channel.self_weight]));
    if let Some(bad) = numbers.into_iter().find(|value| !value.is_finite()) {
        return Err(format!("{} and a record holds {bad}", found.status.word()));
    }
    if found.status == PassageStatus::NotConverged && found.reason.as_ref().is_none_or(String::is_empty) {
        return Err("it did not converge and does not say why".into());
    }
    if found.status != PassageStatus::Completed {
        return Ok(());
    }
    // Balance of every position, as the log tells it; what rounding leaves of stiff and slender parts passes for balance too.
    const ROUNDED: f64 = 1e-4;
    let mut last = BTreeMap::new();
    // A step of the self-weight that was cut was not kept.
    for step in found.log.iter().filter(|step| step.stage != Part::SelfWeight || step.cuts == 0) {
        last.insert((step.stage.word(), step.time.to_bits()), step.unbalanced);
    }
    match last.iter().find(|(_, unbalanced)| !(**unbalanced <= ROUNDED)) {
        Some(((stage, _), unbalanced)) => Err(format!("completed, but {stage} is out of balance by {unbalanced:e}")),
        None if found.channels.iter().any(|channel| channel.values.len() != found.positions.len()) => {
            Err("completed, but a record is shorter than the passage".into())
        }
        None => Ok(()),
    }
}

fn all_end(seeds: std::ops::Range<u64>) {
    let (mut endings, mut wrong) = (BTreeMap::<String, usize>::new(), Vec::new());
    let count = seeds.end - seeds.start;
    for seed in seeds {
        match ending(seed) {
            Ok(word) => *endings.entry(word.split(" at ").next().unwrap_or_default().to_owned()).or_default() += 1,
            Err(words) => wrong.push(words),
        }
    }
    assert!(wrong.is_empty(), "{} of {count}:\n{}", wrong.len(), wrong.join("\n----\n"));
    let ended = |word: &str| endings.get(word).copied().unwrap_or(0) as u64;
    let (completed, stopped) = (ended("completed"), ended("cancelled"));
    // Slow machines stop more passages, which therefore do not count.
    assert!(3 * completed >= count - stopped, "only {completed} of {count} passages completed: {endings:?}");
}

#[test]
fn the_first_random_bridges_end_in_an_answer_or_a_named_status() {
    all_end(0..25);
}

#[test]
fn the_next_random_bridges_end_in_an_answer_or_a_named_status() {
    all_end(25..50);
}

#[test]
#[ignore = "a quarter of an hour"]
fn a_thousand_random_bridges_end_in_an_answer_or_a_named_status() {
    all_end(50..1050);
}
