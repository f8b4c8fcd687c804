//! Figures of an analysis repeated over ranges: what matters most, how the answer follows each quantity, and the plane
//! of two.

mod heat_map;
mod response;
mod tornado;

pub use heat_map::heat_map;
pub use response::response;
pub use tornado::tornado;

use crate::words;
use outcome::study::{Design, Study};

/// Every figure of a study that there is material for, as SVG: name without extension, and drawing.
pub fn study_drawings(study: &Study) -> Vec<(String, String)> {
    let mut drawings = Vec::new();
    match study.design {
        Design::OneAtATime => {
            drawings.extend(tornado(study).map(|svg| ("tornado".to_owned(), svg)));
            for (number, varied) in study.quantities.iter().enumerate() {
                let name = format!("curve-{}", file_name(&varied.path.to_string()));
                drawings.extend(response(study, number).map(|svg| (name, svg)));
            }
        }
        Design::Grid => drawings.extend(heat_map(study).map(|svg| ("heat-map".to_owned(), svg))),
    }
    drawings
}

/// The path of a quantity as part of a file's name.
fn file_name(path: &str) -> String {
    let plain = path.replace(['.', '['], "-");
    plain.chars().filter(|c| c.is_ascii_alphanumeric() || "-_".contains(*c)).collect()
}

/// Units that names of numbers end in.
const UNITS: [(&str, &str); 7] =
    [("_kn_per_m", "kN/m"), ("_kn", "kN"), ("_mpa", "MPa"), ("_mm", "mm"), ("_m", "m"), ("_s", "s"), ("_percent", "%")];

/// A number's name as people say it, and its unit: `collapse_load_kn_per_m` is the collapse load in kN/m.
pub fn name_and_unit(name: &str) -> (String, &'static str) {
    if name == outcome::study::CARRIED {
        return ("load carried".to_owned(), "kN/m");
    }
    let found = UNITS.iter().find_map(|(ending, unit)| Some((name.strip_suffix(ending)?, *unit)));
    let (words, unit) = found.unwrap_or((name, ""));
    (words.replace('_', " "), unit)
}

/// A number's name with its unit in brackets.
fn axis_name(name: &str) -> String {
    let (words, unit) = name_and_unit(name);
    words::named(&words, unit)
}

fn with_unit(number: f64, name: &str) -> String {
    words::with_unit(words::four_digits(number), name_and_unit(name).1)
}

/// A range wide enough that noise does not look like a finding: a tenth of the size of the numbers in it at least.
fn honest(low: f64, high: f64) -> [f64; 2] {
    let least = 0.1 * low.abs().max(high.abs()).max(1e-12);
    let short = (least - (high - low)).max(0.0);
    [low - 0.5 * short, high + 0.5 * short]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_their_unit() {
        assert_eq!(name_and_unit("collapse_load_kn_per_m"), ("collapse load".to_owned(), "kN/m"));
        assert_eq!(name_and_unit(outcome::study::CARRIED), ("load carried".to_owned(), "kN/m"));
        assert_eq!(name_and_unit("minimum_thickness_m"), ("minimum thickness".to_owned(), "m"));
        assert_eq!(name_and_unit("hinges"), ("hinges".to_owned(), ""));
        assert_eq!(file_name("span[1].ring[2].thickness"), "span-1-ring-2-thickness");
    }

    #[test]
    fn small_changes_look_small() {
        assert_eq!(honest(99.0, 101.0), [95.0 - 0.05, 105.0 + 0.05]);
        assert_eq!(honest(10.0, 100.0), [10.0, 100.0]);
    }
}
