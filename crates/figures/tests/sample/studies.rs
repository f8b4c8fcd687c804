//! Studies with everything that their figures must cope with.

use bridge::path::Path;
use bridge::vary::{Setting, Varied};
use bridge::{Analysis, Method};
use outcome::study::{Command, Design, Outcome, Row, Study, runs};

/// A value as the file would have it.
pub(crate) fn setting(text: &str, number: Option<f64>) -> Setting {
    Setting { literal: format!("\"{text}\""), text: text.to_owned(), number }
}

fn quantity(path: &str, unit: &str, own: Option<f64>, values: &[f64]) -> Varied {
    let one = |number: f64| setting(&format!("{number} {unit}"), Some(number));
    Varied {
        path: Path::parse(path).unwrap(),
        unit: unit.to_owned(),
        own: own.map(one),
        values: values.iter().copied().map(one).collect(),
    }
}

fn words(path: &str, own: &str, values: &[&str]) -> Varied {
    Varied {
        path: Path::parse(path).unwrap(),
        unit: String::new(),
        own: Some(setting(own, None)),
        values: values.iter().map(|value| setting(value, None)).collect(),
    }
}

/// A study of these quantities: `answer` gives status and collapse load from the value of each.
fn study(design: Design, quantities: Vec<Varied>, answer: impl Fn(&[&str]) -> (&'static str, f64)) -> Study {
    let counts: Vec<usize> = quantities.iter().map(|varied| varied.values.len()).collect();
    let mut study = Study {
        bridge: "A bridge with a fairly long name, so that its title needs all the width there is and a little more"
            .into(),
        command: Command::Collapse,
        analysis: Analysis::Load,
        method: Method::Limit,
        design,
        outcome: "collapse_load_kn_per_m".into(),
        resolution: 0.0,
        quantities,
        rows: Vec::new(),
    };
    for run in runs(design, &counts) {
        let mut row = Row { run, outcome: Outcome::default(), seconds: 0.0, cached: false };
        let values: Vec<String> = (0..study.quantities.len())
            .map(|at| study.setting(&row, at).map_or(String::new(), |setting| setting.text.clone()))
            .collect();
        let (status, load) = answer(&values.iter().map(String::as_str).collect::<Vec<_>>());
        row.outcome.status = status.to_owned();
        if !load.is_nan() {
            row.outcome.numbers.push(("collapse_load_kn_per_m".to_owned(), load));
        }
        study.rows.push(row);
    }
    study
}

fn number(text: &str) -> f64 {
    text.split(' ').next().and_then(|digits| digits.parse().ok()).unwrap_or(f64::NAN)
}

/// One at a time: rising, falling, flat, words, a quantity that the file does not give, runs that failed.
pub(crate) fn usual() -> Study {
    let quantities = vec![
        quantity("joint.friction_angle", "deg", Some(35.6), &[5.0, 10.0, 20.0, 30.0, 40.0]),
        quantity("span[1].ring[2].springing_thickness", "m", Some(0.7), &[0.1, 0.65, 0.75]),
        words("analysis.damping", "local", &["viscous", "adaptive"]),
        quantity("analysis.seed", "", Some(1.0), &[2.0, 3.0]),
        quantity("joint.tensile_strength", "kPa", None, &[10.0, 50.0, 90.0]),
        quantity("masonry.density", "kg/m^3", Some(2100.0), &[2000.0, 2300.0]),
    ];
    study(Design::OneAtATime, quantities, |v| {
        if number(v[0]) < 8.0 {
            return ("not-converged", f64::NAN);
        }
        if number(v[1]) < 0.2 {
            return ("unstable-under-self-weight", f64::NAN);
        }
        let damped = if v[2] == "viscous" { 1.02 } else { 1.0 };
        let bonded = if v[4].is_empty() { 0.0 } else { number(v[4]) };
        let status = if v[2] == "adaptive" { "stalled" } else { "collapsed" };
        (status, 200.0 * damped * (number(v[0]) / 35.6).powf(0.1) * (number(v[1]) / 0.7).powi(3) + bonded)
    })
}

/// One at a time, and nothing matters.
pub(crate) fn flat() -> Study {
    study(Design::OneAtATime, vec![quantity("analysis.seed", "", Some(1.0), &[2.0, 3.0, 4.0])], |_| {
        ("collapsed", 150.0)
    })
}

/// No run has an answer.
pub(crate) fn without_answer() -> Study {
    study(Design::OneAtATime, vec![quantity("analysis.seed", "", Some(1.0), &[2.0])], |_| ("not-converged", f64::NAN))
}

/// A grid of a number against words, with runs that failed.
pub(crate) fn grid() -> Study {
    let quantities = vec![
        quantity("span[1].thickness", "m", Some(0.7), &[0.8, 0.7, 0.6, 0.1]),
        words("dispersal.rule", "uniform", &["uniform", "boussinesq", "inverse-depth"]),
    ];
    study(Design::Grid, quantities, |v| match number(v[0]) < 0.2 {
        true => ("unstable-under-self-weight", f64::NAN),
        false => ("collapsed", 300.0 * number(v[0]).powi(2) + v[1].len() as f64),
    })
}

/// A grid with more cells than numbers can be read in.
pub(crate) fn fine_grid() -> Study {
    let steps: Vec<f64> = (0..30).map(|k| 20.0 + f64::from(k)).collect();
    let quantities = vec![
        quantity("joint.friction_angle", "deg", Some(35.0), &steps),
        quantity("masonry.density", "kg/m^3", Some(2100.0), &steps),
    ];
    study(Design::Grid, quantities, |v| ("collapsed", number(v[0]) * number(v[1])))
}

pub(crate) fn every() -> Vec<(&'static str, Study)> {
    vec![("usual", usual()), ("flat", flat()), ("grid", grid()), ("fine grid", fine_grid())]
}
