//! A locomotive over one span, as bell-shaped influence lines: the shapes are made up, the peaks are those of the railway
//! paper's Table 1 at 20 km/h.

use records::{Dimension, Exact, Noise, Recording, Unit, synthesise};

/// Channels: name, quantity, peak in mm or microstrain, place of the sensor [m], half-width of its influence line [m], and share
/// of the negative lobe behind it.
const CHANNELS: [(&str, Dimension, f64, f64, f64, f64); 4] = [
    ("crown displacement", Dimension::Length, -0.27, 3.0, 1.6, 0.0),
    ("pier displacement", Dimension::Length, 0.27, 1.0, 2.0, 0.3),
    ("crown strain", Dimension::Strain, 21.4, 3.0, 1.1, 0.2),
    ("pier strain", Dimension::Strain, -24.83, 0.3, 1.4, 0.1),
];
/// Distances of the axles behind the first [m].
pub(crate) const AXLES: [f64; 6] = [0.0, 1.8, 3.7, 11.0, 12.9, 14.7];
/// Distances of the axles of a goods train behind the first [m]: the locomotive and seven bogies more.
pub(crate) const LONG: [f64; 20] = [
    0.0, 1.8, 3.7, 11.0, 12.9, 14.7, 20.2, 22.2, 29.0, 31.0, 34.7, 36.7, 43.5, 45.5, 49.2, 51.2, 58.0, 60.0, 63.7, 65.7,
];
/// Time at which the first axle stands at the springing [s]: the record starts when it is 12 m away, and 1.5 s before.
pub(crate) fn arrival(speed: f64) -> f64 {
    1.5_f64.max(12.0 / speed)
}

fn influence(x: f64, width: f64, lobe: f64) -> f64 {
    let bell = |u: f64| (-0.5 * u * u).exp();
    bell(x / width) - lobe * bell((x + 2.5 * width) / width)
}

/// Exact values of a channel at times, scaled to its peak [SI].
fn values(index: usize, speed: f64, times: &[f64], axles: &[f64]) -> Vec<f64> {
    let (_, quantity, peak, place, width, lobe) = CHANNELS[index];
    let at = |time: &f64| -> f64 {
        let first = speed * (time - arrival(speed));
        axles.iter().map(|axle| influence(first - axle - place, width, lobe)).sum()
    };
    let raw: Vec<f64> = times.iter().map(at).collect();
    let largest = raw.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let si = Unit::usual(quantity).to_si(peak);
    raw.iter().map(|value| si * value / largest).collect()
}

/// Exact times: until the locomotive has left and the start's quiet has come back.
pub(crate) fn times(speed: f64, rate: f64) -> Vec<f64> {
    let end = 2.0 * arrival(speed) + 24.0 / speed;
    (0..=(end * rate) as usize).map(|k| k as f64 / rate).collect()
}

/// Exact histories on lines across the barrel, rounded to 0.01 mm and 0.05 microstrain.
pub(crate) fn exact(speed: f64, times: &[f64], lines: &[&str], factor: impl Fn(&str, &str) -> f64) -> Vec<Exact> {
    exact_of(&AXLES, speed, times, lines, factor)
}

fn exact_of(
    axles: &[f64],
    speed: f64,
    times: &[f64],
    lines: &[&str],
    factor: impl Fn(&str, &str) -> f64,
) -> Vec<Exact> {
    let mut all = Vec::new();
    for (index, (name, quantity, ..)) in CHANNELS.iter().enumerate() {
        for line in lines {
            let unit = Unit::usual(*quantity);
            let scale = factor(name, line);
            all.push(Exact {
                name: (*name).to_owned(),
                line: (*line).to_owned(),
                unit,
                values: values(index, speed, times, axles).iter().map(|value| scale * value).collect(),
                least_count: unit.to_si(if *quantity == Dimension::Length { 0.01 } else { 0.05 }),
                deviation: unit.to_si(if *quantity == Dimension::Length { 0.001 } else { 0.05 }),
            });
        }
    }
    all
}

/// A run at a speed [km/h], sampled at 100 Hz.
pub(crate) fn run(name: &str, kmh: f64, lines: &[&str], seed: u64, factor: impl Fn(&str, &str) -> f64) -> Recording {
    let speed = kmh / 3.6;
    let times = times(speed, 400.0);
    let noise = Noise { rate: Some(100.0), seed, origin: "bell-shaped influence lines".to_owned() };
    synthesise(name, Some(speed), &times, &exact(speed, &times, lines, factor), &noise)
}

/// The same of the goods train.
pub(crate) fn goods(name: &str, kmh: f64, lines: &[&str], seed: u64) -> Recording {
    let speed = kmh / 3.6;
    let end = 2.0 * arrival(speed) + 75.0 / speed;
    let times: Vec<f64> = (0..=(end * 400.0) as usize).map(|k| k as f64 / 400.0).collect();
    let noise = Noise { rate: Some(100.0), seed, origin: "bell-shaped influence lines".to_owned() };
    synthesise(name, Some(speed), &times, &exact_of(&LONG, speed, &times, lines, |_, _| 1.0), &noise)
}

/// The good run of the tests.
pub(crate) fn good() -> Recording {
    run("slow", 20.0, &[""], 1, |_, _| 1.0)
}
