//! A run written in the format that is read.

use crate::{Channel, Dimension, Recording, Unit};
use std::fmt::Write as _;

/// The run as a table: comment lines with its name and speed and, first of all, that it is synthetic where it is; headings with
/// units; a row for every sample. Channels that are left out are written too, and a comment says why they are.
pub fn write(run: &Recording) -> String {
    let mut text = String::new();
    let line = findings::visible::harmless_line;
    if let Some(how) = &run.synthetic {
        text += &format!("# synthetic: {}\n", line(how));
    }
    if !run.name.is_empty() {
        text += &format!("# run: {}\n", line(&run.name));
    }
    if let Some(speed) = run.speed {
        text += &format!("# speed: {} km/h\n", shortest(&Unit::usual(Dimension::Speed), speed));
    }
    for channel in run.channels.iter().filter(|channel| !channel.used()) {
        let why = channel.left_out.as_deref().unwrap_or_default();
        text += &format!("# left out, {}; {}\n", line(&channel.title()), line(why));
    }
    let headings = run
        .channels
        .iter()
        .map(|channel| findings::visible::cell(&format!("{} [{}]", channel.title(), channel.unit.symbol)));
    let headings: Vec<String> = std::iter::once("time [s]".to_owned()).chain(headings).collect();
    text += &headings.join(",");
    text.push('\n');
    for (k, time) in run.times.iter().enumerate() {
        // Writing to a string does not fail.
        let _ = write!(text, "{time}");
        for channel in &run.channels {
            text.push(',');
            cell(&mut text, channel, channel.values.get(k).copied().unwrap_or(f64::NAN));
        }
        text.push('\n');
    }
    text
}

fn cell(text: &mut String, channel: &Channel, value: f64) {
    if !value.is_finite() {
        return;
    }
    let number = channel.unit.of_si(value);
    // With the decimals that its cells were printed with, if that is all there is to the value.
    if let Some(digits) = channel.decimals {
        let start = text.len();
        let _ = write!(text, "{number:.digits$}");
        if text[start..].parse::<f64>().is_ok_and(|read| channel.unit.to_si(read) == value) {
            return;
        }
        text.truncate(start);
    }
    text.push_str(&shortest(&channel.unit, value));
}

/// The shortest cell that reads back as the value: its number in the unit, or a neighbour of it.
fn shortest(unit: &Unit, value: f64) -> String {
    let number = unit.of_si(value);
    let candidates = [number, number.next_up(), number.next_down()];
    let back = candidates.into_iter().filter(|number| unit.to_si(*number) == value);
    let printed = back.map(|number| number.to_string()).min_by_key(String::len);
    printed.unwrap_or_else(|| number.to_string())
}
