//! Comment lines, and the three that mean something: `# run: slow`, `# speed: 45 km/h`, `# synthetic: …`.

use super::mapping::ReadOptions;
use super::text::{is_comment, lines};
use crate::{Dimension, Finding, Place, Recording, Unit};
use findings::Severity;

/// No more comment lines than this are kept.
const MOST: usize = 1000;

/// A run of which nothing is known but what the comments of its file say.
pub(super) fn noted(text: &str, options: &ReadOptions, findings: &mut Vec<Finding>) -> Recording {
    let mut run = Recording { name: options.name.clone(), ..Recording::default() };
    let mut bad_speed = None;
    for (number, line) in lines(text).filter(|(_, line)| is_comment(line)).take(MOST) {
        let shown = findings::visible::one_line(line);
        let note = shown.trim().trim_start_matches(['#', '%']).trim();
        run.notes.push(note.to_owned());
        let Some((key, value)) = note.split_once(':') else { continue };
        match key.trim().to_lowercase().as_str() {
            "run" if !value.trim().is_empty() => run.name = value.trim().to_owned(),
            "synthetic" => run.synthetic = Some(value.trim().to_owned()),
            "speed" => match speed(value) {
                Some(speed) => run.speed = Some(speed),
                None => bad_speed = Some((number, value.trim().to_owned())),
            },
            _ => {}
        }
    }
    if let Some((number, value)) = bad_speed {
        let place = Place { run: run.name.clone(), lines: Some([number; 2]), ..Place::default() };
        let message = format!("`{value}` is no speed; the speed of the run is not known from the file");
        findings.push(Finding::new(Severity::Warning, "R003", place, message, "write `# speed: 45 km/h`"));
    }
    let stated = options.speed.filter(|speed| speed.is_finite() && *speed > 0.0);
    if let (Some(stated), Some(written)) = (stated, run.speed)
        && (stated - written).abs() > 1e-6 * stated
    {
        let place = Place { run: run.name.clone(), ..Place::default() };
        let message = format!("the file says {:.2} m/s, but {stated:.2} m/s was asked for and is taken", written);
        findings.push(Finding::new(Severity::Warning, "R003", place, message, "say one speed"));
    }
    run.speed = stated.or(run.speed);
    run
}

fn speed(text: &str) -> Option<f64> {
    let text = text.trim();
    let at = text.find(|c: char| !(c.is_ascii_digit() || c == '.'))?;
    let number: f64 = text[..at].parse().ok()?;
    let unit = Unit::named(&text[at..]).filter(|unit| unit.quantity == Dimension::Speed)?;
    Some(unit.to_si(number)).filter(|speed| speed.is_finite() && *speed > 0.0)
}
