//! Quantities on the command line, with units as in files.

use bridge::quantity::{self, Dimension};
use extrados::Refusal;

/// A load per metre of width [N/m]; one over the whole width is divided by it [m].
pub(crate) fn line_load(option: &str, text: &str, width: f64) -> Result<f64, Refusal> {
    let example = "1 kN/m";
    let quantity = read(option, text, &[Dimension::LineLoad, Dimension::Force], example)?;
    let load = match quantity.unit.dimension {
        Dimension::Force => quantity.si() / width,
        _ => quantity.si(),
    };
    match positive(option, text, load, example)? {
        load if load >= LEAST_LOAD => Ok(load),
        _ => Err(refused(format!("{option} \"{text}\" is less than 0.001 kN/m"), option, example)),
    }
}

/// Least load [N/m], as in files: finer steps tell nothing and never end.
const LEAST_LOAD: f64 = 1.0;

/// A length [m].
pub(crate) fn length(option: &str, text: &str) -> Result<f64, Refusal> {
    above_zero(option, text, Dimension::Length, "0.25 m")
}

/// A station or a level [m], of either sign.
pub(crate) fn place(option: &str, text: &str) -> Result<f64, Refusal> {
    Ok(read(option, text, &[Dimension::Length], "1234.5 m")?.si())
}

/// A stress or modulus [Pa].
pub(crate) fn stress(option: &str, text: &str) -> Result<f64, Refusal> {
    above_zero(option, text, Dimension::Stress, "40 MPa")
}

/// A speed [m/s].
pub(crate) fn speed(option: &str, text: &str) -> Result<f64, Refusal> {
    let example = "45 km/h";
    let speed = above_zero(option, text, Dimension::Speed, example)?;
    match (LEAST_SPEED..=Dimension::Speed.most()).contains(&speed) {
        true => Ok(speed),
        false => Err(refused(format!("{option} \"{text}\" is no speed of a train"), option, example)),
    }
}

/// A sampling rate [Hz].
pub(crate) fn frequency(option: &str, text: &str) -> Result<f64, Refusal> {
    let example = "200 Hz";
    let rate = above_zero(option, text, Dimension::Frequency, example)?;
    if (LEAST_RATE..=MOST_RATE).contains(&rate) {
        return Ok(rate);
    }
    let message = format!("{option} \"{text}\" is no rate of a logger: {LEAST_RATE} Hz to {MOST_RATE} Hz");
    Err(refused(message, option, example))
}

/// Rates of loggers [Hz]: a sample in ten seconds shows no train, and a train's minutes at the most make tables of a hundred million
/// rows.
const LEAST_RATE: f64 = 0.1;
const MOST_RATE: f64 = 1e5;

/// A size of displacements or of strains in a unit of records, and which of the two it is; none of them is below zero [SI].
pub(crate) fn of_records(option: &str, text: &str) -> Result<(records::Dimension, f64), Refusal> {
    let help = || format!("write {option} \"0.01 mm\" or {option} \"0.05 microstrain\"");
    let refuse = |why: &str| Refusal::new("F107", format!("{option} \"{text}\" {why}"), help());
    let start = text.find(|c: char| c.is_alphabetic() && c != 'e' && c != 'E').unwrap_or(text.len());
    let (number, unit) = text.split_at(start);
    let number: f64 = number.trim().parse().map_err(|_| refuse("is no number with a unit"))?;
    let unit = records::Unit::named(unit).ok_or_else(|| refuse("has no unit of displacements or strains"))?;
    if !matches!(unit.quantity, records::Dimension::Length | records::Dimension::Strain) {
        return Err(refuse("is neither a displacement nor a strain"));
    }
    if !(0.0..=MOST_OF_RECORDS).contains(&unit.to_si(number)) {
        return Err(refuse("is no size of a reading"));
    }
    Ok((unit.quantity, unit.to_si(number)))
}

/// Largest least count or deviation [m] or [-]: no bridge moves by as much.
const MOST_OF_RECORDS: f64 = 1.0;

/// The least speed [m/s], as in files.
const LEAST_SPEED: f64 = 0.01;

fn read(option: &str, text: &str, wanted: &[Dimension], example: &str) -> Result<quantity::Quantity, Refusal> {
    let names = || wanted.iter().map(|dimension| dimension.name()).collect::<Vec<_>>().join(" or ");
    let quantity = quantity::parse(text)
        .map_err(|_| refused(format!("{option} \"{text}\" is not {}", names()), option, example))?;
    quantity.of(wanted).ok_or_else(|| {
        let found = quantity.unit.dimension.name();
        refused(format!("{option} \"{text}\": expected {}, found {found}", names()), option, example)
    })
}

/// A quantity of one kind that is above zero [SI].
fn above_zero(option: &str, text: &str, wanted: Dimension, example: &str) -> Result<f64, Refusal> {
    positive(option, text, read(option, text, &[wanted], example)?.si(), example)
}

fn positive(option: &str, text: &str, value: f64, example: &str) -> Result<f64, Refusal> {
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(refused(format!("{option} \"{text}\" is not above zero"), option, example)),
    }
}

fn refused(message: String, option: &str, example: &str) -> Refusal {
    Refusal::new("F107", message, format!("write {option} \"{example}\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_are_per_metre_or_over_the_width() {
        assert_eq!(line_load("--resolution", "1 kN/m", 8.3), Ok(1000.0));
        assert_eq!(line_load("--resolution", "83 kN", 8.3), Ok(83e3 / 8.3));
    }

    #[test]
    fn slips_are_named() {
        let message = |text| line_load("--resolution", text, 8.3).unwrap_err().message;
        assert!(message("2 m").contains("a length"), "{}", message("2 m"));
        assert!(message("5").contains("is not"));
        assert!(message("-1 kN/m").contains("not above zero"));
        assert!(message("1e-12 kN/m").contains("less than 0.001 kN/m"));
        assert_eq!(frequency("--rate", "200 Hz"), Ok(200.0));
        for wrong in ["200", "0 Hz", "1e9 Hz", "5 s"] {
            assert_eq!(frequency("--rate", wrong).unwrap_err().code, "F107", "{wrong}");
        }
        let size = |text| of_records("--deviation", text);
        assert_eq!(size("0.05 microstrain"), Ok((records::Dimension::Strain, 0.05 / 1e6)));
        assert_eq!(size("1e-2mm"), Ok((records::Dimension::Length, 0.01 / 1e3)));
        for wrong in ["0.01", "mm", "-1 mm", "nan mm", "1 kN", "1 furlong", "5 m", ""] {
            assert_eq!(size(wrong).unwrap_err().code, "F107", "{wrong}");
        }
        assert!(length("--sweep-step", "0.5 m").is_ok());
        assert_eq!(stress("--modulus", "40 MPa"), Ok(40e6));
        assert!(stress("--modulus", "40 GPa/m").unwrap_err().message.contains("a pressure"));
    }
}
