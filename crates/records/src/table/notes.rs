//! Comment lines, and the three that mean something: `# run: slow`, `# speed: 45 km/h`, `# synthetic: …`.

use super::mapping::ReadOptions;
use super::text::{is_comment, lines};
use crate::{Dimension, Finding, Place, Unit};
use findings::Severity;

/// What the comments of a file say.
pub(super) struct Notes {
    pub name: String,
    pub speed: Option<f64>,
    pub synthetic: Option<String>,
    pub lines: Vec<String>,
}

/// No more comment lines than this are kept.
const MOST: usize = 1000;

pub(super) fn notes(text: &str, options: &ReadOptions, findings: &mut Vec<Finding>) -> Notes {
    let mut notes = Notes { name: options.name.clone(), speed: None, synthetic: None, lines: Vec::new() };
    let mut bad_speed = None;
    for (number, line) in lines(text).filter(|(_, line)| is_comment(line)).take(MOST) {
        let shown = findings::visible::one_line(line);
        let note = shown.trim().trim_start_matches(['#', '%']).trim();
        notes.lines.push(note.to_owned());
        let Some((key, value)) = note.split_once(':') else { continue };
        match key.trim().to_lowercase().as_str() {
            "run" if !value.trim().is_empty() => notes.name = value.trim().to_owned(),
            "synthetic" => notes.synthetic = Some(value.trim().to_owned()),
            "speed" => match speed(value) {
                Some(speed) => notes.speed = Some(speed),
                None => bad_speed = Some((number, value.trim().to_owned())),
            },
            _ => {}
        }
    }
    if let Some((number, value)) = bad_speed {
        let place = Place { run: notes.name.clone(), lines: Some([number; 2]), ..Place::default() };
        let message = format!("`{value}` is no speed; the speed of the run is not known from the file");
        findings.push(Finding::new(Severity::Warning, "R003", place, message, "write `# speed: 45 km/h`"));
    }
    let stated = options.speed.filter(|speed| speed.is_finite() && *speed > 0.0);
    if let (Some(stated), Some(written)) = (stated, notes.speed)
        && (stated - written).abs() > 1e-6 * stated
    {
        let place = Place { run: notes.name.clone(), ..Place::default() };
        let message = format!("the file says {:.2} m/s, but {stated:.2} m/s was asked for and is taken", written);
        findings.push(Finding::new(Severity::Warning, "R003", place, message, "say one speed"));
    }
    notes.speed = stated.or(notes.speed);
    notes
}

fn speed(text: &str) -> Option<f64> {
    let text = text.trim();
    let at = text.find(|c: char| !(c.is_ascii_digit() || c == '.'))?;
    let number: f64 = text[..at].parse().ok()?;
    let unit = Unit::named(&text[at..]).filter(|unit| unit.quantity == Dimension::Speed)?;
    Some(unit.to_si(number)).filter(|speed| speed.is_finite() && *speed > 0.0)
}
