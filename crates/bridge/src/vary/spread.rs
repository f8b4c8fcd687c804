//! The values of a varied quantity: listed, or spread over a range, absolute or relative to its own value.

use toml_edit::Value;

use super::scale::{Scale, convert, measure, tidy};
use super::{Slip, Variable};
use crate::card::{Field, Kind};
use crate::edit::literal;
use crate::path::Path;
use crate::quantity;
use crate::tree::shorten;
use serde::{Deserialize, Serialize};

/// Values as they were asked for, in TOML.
#[derive(Debug, Clone, PartialEq)]
pub enum Spread {
    /// One after the other.
    List(Vec<String>),
    /// A range, both ends included.
    Range {
        /// First value.
        from: String,
        /// Last value.
        to: String,
        /// How many.
        points: u64,
        /// Equal ratios instead of equal differences.
        geometric: bool,
    },
}

/// A quantity with its values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Varied {
    /// Path in the file.
    pub path: Path,
    /// Unit of the numbers; empty for bare numbers and words.
    pub unit: String,
    /// Its own value; none where the file says nothing.
    pub own: Option<Setting>,
    /// Its values, in the order asked for.
    pub values: Vec<Setting>,
}

/// One value of a quantity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// As TOML has it.
    pub literal: String,
    /// As people write it, without quotes.
    pub text: String,
    /// Its number in the unit of the quantity; none for words.
    pub number: Option<f64>,
}

/// Works out the values of a quantity.
///
/// # Errors
/// Values that cannot be read or that the quantity does not take (B503).
pub fn settle(quantity: &Variable, spread: &Spread) -> Result<Varied, Slip> {
    let own = quantity.own.as_deref().and_then(|own| measure(quantity.field, own));
    let literals: Vec<String> = match spread {
        Spread::List(list) => {
            list.iter().map(|value| absolute(quantity, own.as_ref(), value)).collect::<Result<_, _>>()?
        }
        Spread::Range { from, to, points, geometric } => {
            let ends = [absolute(quantity, own.as_ref(), from)?, absolute(quantity, own.as_ref(), to)?];
            range(quantity.field, &ends, *points, *geometric)?
        }
    };
    let scale = own.as_ref().map(|(_, scale)| scale.clone());
    let scale = scale.or_else(|| literals.iter().find_map(|value| Some(measure(quantity.field, value)?.1)));
    let setting = |literal: &str, text: String| {
        let number = measure(quantity.field, literal);
        let number = number.zip(scale.as_ref()).and_then(|((number, from), to)| convert(number, &from, to));
        Setting { literal: literal.to_owned(), text, number }
    };
    let texts = texts(quantity.field, spread, &literals);
    Ok(Varied {
        path: quantity.path.clone(),
        unit: scale.as_ref().map(Scale::unit).unwrap_or_default(),
        own: quantity.own.as_deref().map(|own| setting(own, text_of(own))),
        values: literals.iter().zip(texts).map(|(literal, text)| setting(literal, text)).collect(),
    })
}

/// Values as people write them: what somebody wrote as it stands, what was worked out with the digits that tell one value from the
/// next. Runs take the value itself.
fn texts(field: &Field, spread: &Spread, literals: &[String]) -> Vec<String> {
    let number = |literal: &String| measure(field, literal).map(|(number, _)| number);
    let last = literals.len().saturating_sub(1);
    let one = |(k, literal): (usize, &String)| {
        let given = match spread {
            Spread::List(list) => list.get(k),
            Spread::Range { from, .. } if k == 0 => Some(from),
            Spread::Range { to, .. } if k == last => Some(to),
            Spread::Range { .. } => None,
        };
        let Some((value, scale)) = measure(field, literal) else { return text_of(literal) };
        let step = match given {
            Some(written) if factor_of(written).is_none() => return text_of(literal),
            Some(_) => value.abs() / 1e3,
            None => {
                let next = [k.wrapping_sub(1), k + 1].map(|k| literals.get(k).and_then(number));
                let steps = next.into_iter().flatten().map(|next| (next - value).abs());
                steps.filter(|step| *step > 0.0).fold(f64::INFINITY, f64::min)
            }
        };
        text_of(&scale.literal(rounded(value, step)))
    };
    literals.iter().enumerate().map(one).collect()
}

/// The factor of a relative value, as TOML has it.
fn factor_of(written: &str) -> Option<f64> {
    written.trim().parse::<Value>().ok()?.as_str().and_then(factor)
}

/// A number to a hundredth of the power of ten below a step.
fn rounded(number: f64, step: f64) -> f64 {
    let digits = 2.0 - step.log10().floor();
    if !(0.0..=12.0).contains(&digits) || !number.is_finite() {
        return tidy(number);
    }
    format!("{number:.0$}", digits as usize).parse().unwrap_or(number)
}

/// A value without quotes, with a blank before its unit.
fn text_of(literal: &str) -> String {
    let value: Option<Value> = literal.parse().ok();
    let Some(text) = value.as_ref().and_then(Value::as_str) else { return literal.to_owned() };
    let text = text.trim();
    match quantity::parse(text) {
        Ok(read) if !text.contains(' ') => format!("{} {}", read.number, read.unit.symbol),
        _ => text.to_owned(),
    }
}

/// A value as the file would have it: relative ones times the quantity's own.
fn absolute(quantity: &Variable, own: Option<&(f64, Scale)>, written: &str) -> Result<String, Slip> {
    let value: Value = written
        .trim()
        .parse()
        .map_err(|_| of_values(format!("`{}` is no value", shorten(written)), "write it as the file would"))?;
    let numeric = !matches!(quantity.field.kind, Kind::Text | Kind::Word(_) | Kind::Flag | Kind::Support);
    let Some(factor) = value.as_str().and_then(factor).filter(|_| numeric) else { return Ok(literal(&value)) };
    let Some((number, scale)) = own else {
        let message = format!("\"{}\" is relative, but `{}` has no number", text_of(written), quantity.path);
        return Err(of_values(message, "write the value itself, as the file would"));
    };
    Ok(scale.literal(number * factor))
}

/// The factor of a relative value: "x0.5", "-5 %", "+5%".
fn factor(text: &str) -> Option<f64> {
    let text = text.trim();
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|number| number.is_finite());
    if let Some(times) = text.strip_prefix(['x', '×']) {
        return number(times);
    }
    let change = text.strip_suffix('%').filter(|text| text.starts_with(['+', '-', '−']))?;
    number(&change.replace('−', "-")).map(|percent| 1.0 + percent / 100.0)
}

/// Values from one end to the other; the ends are those written, to the last digit.
fn range(field: &Field, ends: &[String; 2], points: u64, geometric: bool) -> Result<Vec<String>, Slip> {
    let [first, last] = [measure(field, &ends[0]), measure(field, &ends[1])];
    let (Some((from, scale)), Some((to, other))) = (first, last) else {
        let words = ends.iter().map(|end| text_of(end)).collect::<Vec<_>>().join("\" to \"");
        return Err(of_values(
            format!("\"{words}\" is no range of numbers"),
            &format!("write both ends as the file writes {}", field.form()),
        ));
    };
    let Some(to) = convert(to, &other, &scale) else {
        let message = format!("\"{}\" and \"{}\" measure different things", text_of(&ends[0]), text_of(&ends[1]));
        return Err(of_values(message, &format!("write both as the file writes {}", field.form())));
    };
    if geometric && !(from * to > 0.0) {
        let message = format!("\"{}\" to \"{}\" has no equal ratios", text_of(&ends[0]), text_of(&ends[1]));
        return Err(of_values(message, "both ends of a geometric range have the same sign and are not zero"));
    }
    let last = points.max(2) - 1;
    let inner = |step: u64| {
        let share = step as f64 / last as f64;
        let number = if geometric { from * (to / from).powf(share) } else { from + (to - from) * share };
        scale.literal(tidy(number))
    };
    let middle = (1..last).map(inner);
    Ok(std::iter::once(ends[0].clone()).chain(middle).chain(std::iter::once(ends[1].clone())).collect())
}

pub(super) fn of_values(message: String, help: &str) -> Slip {
    Slip {
        code: "B503",
        message,
        label: "values that cannot be worked out".to_owned(),
        help: help.to_owned(),
        of_values: true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::Document;
    use crate::vary::find;

    const FILE: &str = "[[span]]\nthickness = \"0.711 m\"\nvoussoirs = 62\n[joint]\nfriction_angle = \"35.6 deg\"\ncohesion = \"0 kPa\"\n\
                        [[load]]\nat = \"1/4 of span 1\"\n[analysis]\ndamping = \"local\"\n";

    fn texts(path: &str, spread: &Spread) -> Vec<String> {
        let quantity = find(&Document::parse(FILE).unwrap(), path).unwrap();
        settle(&quantity, spread).unwrap().values.into_iter().map(|setting| setting.text).collect()
    }

    fn range(from: &str, to: &str, points: u64, geometric: bool) -> Spread {
        let quoted = |text: &str| format!("\"{text}\"");
        Spread::Range { from: quoted(from), to: quoted(to), points, geometric }
    }

    #[test]
    fn ranges_are_round_and_end_where_they_say() {
        assert_eq!(
            texts("joint.friction_angle", &range("30 deg", "40 deg", 5, false)).join(" "),
            "30 deg 32.5 deg 35 deg 37.5 deg 40 deg"
        );
        assert_eq!(texts("span.thickness", &range("0.7 m", "720 mm", 3, false)), ["0.7 m", "0.71 m", "720 mm"]);
        assert_eq!(texts("span.thickness", &range("x0.5", "x2", 3, true)), ["0.3555 m", "0.711 m", "1.422 m"]);
        assert_eq!(texts("load[1].at", &range("1/10 of span 1", "1/2 of span 1", 3, false))[1], "0.3 of span 1");
        assert_eq!(texts("analysis.seed", &Spread::List(vec!["1".into(), "2".into()])), ["1", "2"]);
        assert_eq!(texts("analysis.damping", &Spread::List(vec!["\"adaptive\"".into()])), ["adaptive"]);
    }

    #[test]
    fn values_that_were_worked_out_have_the_digits_people_write() {
        assert_eq!(
            texts("span.thickness", &range("0.267 m", "0.8 m", 4, false)),
            ["0.267 m", "0.445 m", "0.622 m", "0.8 m"]
        );
        let thirds = find(&Document::parse(FILE).unwrap(), "span.thickness").unwrap();
        let varied = settle(&thirds, &range("0.267 m", "0.8 m", 4, false)).unwrap();
        assert_eq!(varied.values[1].number, Some(0.444666666667), "runs take the value itself");
        let close = texts("span.thickness", &range("0.711 m", "0.7113 m", 4, false));
        assert!(close.windows(2).all(|pair| pair[0] != pair[1]), "{close:?}");
        let list = Spread::List(vec!["\"0.444666666667 m\"".into()]);
        assert_eq!(texts("span.thickness", &list), ["0.444666666667 m"], "what somebody wrote stands");
    }

    #[test]
    fn relative_values_are_those_of_the_file() {
        let list = |values: &[&str]| Spread::List(values.iter().map(|value| format!("\"{value}\"")).collect());
        assert_eq!(texts("span.thickness", &list(&["-5 %", "+5%", "x2"])), ["0.67545 m", "0.74655 m", "1.422 m"]);
        assert_eq!(texts("span.voussoirs", &list(&["x0.5", "+5 %"])), ["31", "65"]);
        assert_eq!(texts("analysis.damping_share", &list(&["-50 %"])), ["0.4"]);
    }

    #[test]
    fn numbers_stand_in_the_unit_of_the_file() {
        let quantity = find(&Document::parse(FILE).unwrap(), "span[1].thickness").unwrap();
        let varied = settle(&quantity, &Spread::List(vec!["\"700 mm\"".into()])).unwrap();
        assert_eq!((varied.unit.as_str(), varied.values[0].number), ("m", Some(0.7)));
        assert_eq!(varied.own.and_then(|own| own.number), Some(0.711));
    }

    #[test]
    fn ranges_that_cannot_be_are_refused() {
        let slip = |path: &str, spread: &Spread| {
            let quantity = find(&Document::parse(FILE).unwrap(), path).unwrap();
            settle(&quantity, spread).unwrap_err().code
        };
        assert_eq!(slip("joint.friction_angle", &range("30 deg", "40 kN", 3, false)), "B503");
        assert_eq!(slip("joint.friction_angle", &range("low", "high", 3, false)), "B503");
        assert_eq!(slip("joint.cohesion", &range("0 kPa", "40 kPa", 3, true)), "B503");
        assert_eq!(slip("joint.tensile_strength", &range("x0.5", "x2", 3, false)), "B503");
        assert_eq!(slip("joint.cohesion", &Spread::List(vec!["40 kPa".into()])), "B503");
    }
}
