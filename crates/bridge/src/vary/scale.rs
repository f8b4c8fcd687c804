//! What the number of a value is counted in, so that values can be ordered, drawn and interpolated.

use toml_edit::Value;

use crate::card::{Field, Kind};
use crate::fields::loading::read_share;
use crate::quantity::{self, Dimension, Unit};
use crate::values::read_slope;

/// What a number is counted in.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Scale {
    /// A unit.
    Unit(&'static Unit),
    /// A bare number.
    Plain,
    /// A whole number.
    Whole,
    /// Vertical to one horizontal.
    Slope,
    /// A share of a span: the words behind it.
    Share(String),
}

/// The number of a TOML value and its scale; none for words, lists and what cannot be read.
pub(super) fn measure(field: &Field, literal: &str) -> Option<(f64, Scale)> {
    let value: Value = literal.trim().parse().ok()?;
    let text = value.as_str();
    match field.kind {
        Kind::Quantity(_) | Kind::QuantityOr(..) | Kind::LineLoad | Kind::Quantities(_) => {
            let written = quantity::parse(text?).ok()?;
            // A mass where a force is asked for is its weight.
            let quantity = match field.kind {
                Kind::Quantity(of) | Kind::QuantityOr(of, _) | Kind::Quantities(of) => written.of(&[of]),
                _ => written.of(&[Dimension::LineLoad, Dimension::Force]),
            };
            let quantity = quantity.unwrap_or(written);
            Some((quantity.number, Scale::Unit(quantity.unit)))
        }
        Kind::Number | Kind::NumberOr(_) => {
            Some((value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))?, Scale::Plain))
        }
        Kind::Count => Some((value.as_integer()? as f64, Scale::Whole)),
        Kind::Slope => Some((read_slope(text?)?, Scale::Slope)),
        Kind::Share => {
            let (share, span) = read_share(text?)?;
            Some((share, Scale::Share(span.map_or(String::new(), |span| format!(" of span {span}")))))
        }
        _ => None,
    }
}

/// The same number on another scale.
pub(super) fn convert(number: f64, from: &Scale, to: &Scale) -> Option<f64> {
    match (from, to) {
        (Scale::Unit(from), Scale::Unit(to)) if from.symbol != to.symbol => {
            quantity::convert(number, from, to).map(tidy)
        }
        _ => (from == to).then_some(number),
    }
}

impl Scale {
    /// A number as the file would have it, in TOML.
    pub(super) fn literal(&self, number: f64) -> String {
        let number = tidy(number);
        match self {
            Scale::Unit(unit) => format!("\"{number} {}\"", unit.symbol),
            Scale::Plain => format!("{number:?}"),
            Scale::Whole => format!("{:.0}", number.round()),
            Scale::Slope => format!("\"{number}:1\""),
            Scale::Share(span) => format!("\"{number}{span}\""),
        }
    }

    /// The unit as it stands beside a number.
    pub(super) fn unit(&self) -> String {
        match self {
            Scale::Unit(unit) => unit.symbol.to_owned(),
            Scale::Plain | Scale::Whole => String::new(),
            Scale::Slope => ":1".to_owned(),
            Scale::Share(span) => format!("share{span}"),
        }
    }
}

/// Twelve significant digits: what steps of a range leave behind the last digit that anybody wrote is rounding.
pub(super) fn tidy(number: f64) -> f64 {
    format!("{number:.11e}").parse().unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::Dimension;

    fn field(kind: Kind) -> Field {
        Field { kind, ..crate::fields::FILE.fields[0] }
    }

    #[test]
    fn numbers_have_a_scale_and_words_have_none() {
        let length = field(Kind::Quantity(Dimension::Length));
        let (number, scale) = measure(&length, "\"711 mm\"").unwrap();
        let Scale::Unit(unit) = scale.clone() else { panic!("{scale:?}") };
        assert_eq!((number, unit.symbol), (711.0, "mm"));
        let (metres, to) = measure(&length, "\"1 m\"").unwrap();
        assert_eq!(convert(metres, &to, &scale), Some(1000.0));
        assert_eq!(measure(&field(Kind::Share), "\"1/4 of span 2\""), Some((0.25, Scale::Share(" of span 2".into()))));
        assert_eq!(measure(&field(Kind::Slope), "\"3:2\""), Some((1.5, Scale::Slope)));
        assert_eq!(measure(&field(Kind::Count), "0x10"), Some((16.0, Scale::Whole)));
        assert_eq!(measure(&field(Kind::Flag), "true"), None);
        assert_eq!(measure(&length, "\"wide\""), None);
    }

    #[test]
    fn written_numbers_are_read_back() {
        let third = 0.1 + 0.2;
        for (kind, literal) in [(Kind::Share, "\"0.3 of span 1\""), (Kind::Slope, "\"0.3:1\""), (Kind::Number, "0.3")] {
            let scale = measure(&field(kind), literal).unwrap().1;
            assert_eq!(scale.literal(third), literal);
        }
        assert_eq!(Scale::Plain.literal(2.0), "2.0");
        assert_eq!(Scale::Plain.literal(1e-5), "1e-5");
    }
}
