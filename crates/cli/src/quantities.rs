//! Quantities on the command line, with units as in files.

use crate::failure::Failure;
use bridge::quantity::{self, Dimension};

/// A load per metre of width [N/m]; one over the whole width is divided by it [m].
pub fn line_load(option: &str, text: &str, width: f64) -> Result<f64, Failure> {
    let example = "1 kN/m";
    let quantity = read(option, text, &[Dimension::LineLoad, Dimension::Force], example)?;
    let load = match quantity.unit.dimension {
        Dimension::Force => quantity.si() / width,
        _ => quantity.si(),
    };
    positive(option, text, load, example)
}

/// A length [m].
pub fn length(option: &str, text: &str) -> Result<f64, Failure> {
    let example = "0.25 m";
    positive(option, text, read(option, text, &[Dimension::Length], example)?.si(), example)
}

/// A stress or modulus [Pa].
pub fn stress(option: &str, text: &str) -> Result<f64, Failure> {
    let example = "40 MPa";
    positive(option, text, read(option, text, &[Dimension::Stress], example)?.si(), example)
}

/// A speed [m/s].
pub fn speed(option: &str, text: &str) -> Result<f64, Failure> {
    let example = "45 km/h";
    let speed = positive(option, text, read(option, text, &[Dimension::Speed], example)?.si(), example)?;
    if (LEAST_SPEED..=Dimension::Speed.most()).contains(&speed) {
        return Ok(speed);
    }
    let message = format!("{option} \"{text}\" is no speed of a train");
    Err(Failure::input("F107", message, format!("write {option} \"{example}\"")))
}

/// The least speed [m/s], as in files.
const LEAST_SPEED: f64 = 0.01;

fn read(option: &str, text: &str, wanted: &[Dimension], example: &str) -> Result<quantity::Quantity, Failure> {
    let help = format!("write {option} \"{example}\"");
    let names = || wanted.iter().map(|dimension| dimension.name()).collect::<Vec<_>>().join(" or ");
    match quantity::parse(text) {
        Ok(quantity) if wanted.contains(&quantity.unit.dimension) => Ok(quantity),
        Ok(quantity) => {
            let found = quantity.unit.dimension.name();
            Err(Failure::input("F107", format!("{option} \"{text}\": expected {}, found {found}", names()), help))
        }
        Err(_) => Err(Failure::input("F107", format!("{option} \"{text}\" is not {}", names()), help)),
    }
}

fn positive(option: &str, text: &str, value: f64, example: &str) -> Result<f64, Failure> {
    if value > 0.0 && value.is_finite() {
        return Ok(value);
    }
    let help = format!("write {option} \"{example}\"");
    Err(Failure::input("F107", format!("{option} \"{text}\" is not above zero"), help))
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
        assert!(length("--sweep-step", "0.5 m").is_ok());
        assert_eq!(stress("--modulus", "40 MPa"), Ok(40e6));
        assert!(stress("--modulus", "40 GPa/m").unwrap_err().message.contains("a pressure"));
    }
}
