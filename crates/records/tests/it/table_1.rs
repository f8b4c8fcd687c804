//! The railway paper's Table 1: site-recorded peaks at three speeds, and what it concludes from them: "The site data shows
//! insignificant dynamic effects".

use records::{Answer, Dimension, Peak, PeakTable, Unit, dynamics, plane_strain};

/// Channels with peaks at crawling (5 km/h), slow (20 km/h) and design speed (65 km/h), in mm and microstrain.
const TABLE_1: [(&str, Dimension, [f64; 3]); 6] = [
    ("crown displacement", Dimension::Length, [-0.30, -0.27, -0.34]),
    ("pier displacement", Dimension::Length, [0.24, 0.27, 0.24]),
    ("abutment displacement", Dimension::Length, [-0.04, -0.04, -0.04]),
    ("crown strain", Dimension::Strain, [22.1, 21.4, 19.4]),
    ("pier strain", Dimension::Strain, [-24.62, -24.83, -25.68]),
    ("abutment strain", Dimension::Strain, [-24.0, -22.2, -23.2]),
];
const SPEEDS: [f64; 3] = [5.0, 20.0, 65.0];

/// The table, every peak of the fastest run by a factor.
fn table(fastest: f64) -> PeakTable {
    let of = |(name, quantity, peaks): &(&str, Dimension, [f64; 3])| -> Vec<Peak> {
        let unit = Unit::usual(*quantity);
        let one = |k: usize| Peak {
            run: format!("{} km/h", SPEEDS[k]),
            speed: Some(SPEEDS[k] / 3.6),
            name: (*name).to_owned(),
            line: "centre".to_owned(),
            unit,
            value: unit.to_si(peaks[k]) * if k == 2 { fastest } else { 1.0 },
            time: 0.0,
            file_line: 0,
            least_count: unit.to_si(if *quantity == Dimension::Length { 0.01 } else { 0.05 }),
            synthetic: false,
        };
        (0..3).map(one).collect()
    };
    PeakTable { peaks: TABLE_1.iter().flat_map(of).collect() }
}

#[test]
fn no_dynamic_effect_is_seen_and_one_of_a_tenth_is_excluded() {
    let verdict = dynamics(&table(1.0));
    assert_eq!(verdict.answer, Answer::NotSeen, "{}", verdict.words);
    // By hand from the table: means of logarithms 0.60454, 0.58967, 0.60506; scatter 0.06945; F(2, 10) = 0.095.
    let common = verdict.common.unwrap();
    assert_eq!(common.freedom, [2.0, 10.0]);
    assert!((common.f - 0.09502).abs() < 1e-4 && (common.scatter - 0.069449).abs() < 1e-5, "{common:?}");
    // The upper tail of F(2, m) is (1 + 2 F / m)^(-m/2).
    assert!((common.p - (1.0 + 2.0 * common.f / 10.0).powf(-5.0)).abs() < 1e-9);
    assert!((verdict.factors[1][0] - 0.98524).abs() < 1e-4 && (verdict.factors[2][0] - 1.00052).abs() < 1e-4);
    // One run at each speed: no channel can be judged by itself, and it says so.
    assert!(verdict.channels.iter().all(|channel| channel.answer == Answer::CannotTell && channel.test.is_none()));
    assert!(verdict.words.starts_with("no dynamic effect is seen"), "{}", verdict.words);
}

#[test]
fn a_dynamic_effect_of_a_quarter_would_have_been_seen_in_the_same_scatter() {
    let verdict = dynamics(&table(1.25));
    assert_eq!(verdict.answer, Answer::Seen, "{}", verdict.words);
    // A twentieth lies within what this scatter can hide, but so does a tenth: the answer is not "not seen".
    let small = dynamics(&table(1.05));
    assert_eq!(small.answer, Answer::CannotTell, "{}", small.words);
}

#[test]
fn one_line_says_nothing_of_plane_strain() {
    assert_eq!(plane_strain(&table(1.0), None).answer, Answer::CannotTell);
}
