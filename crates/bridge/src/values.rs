//! Values of a table: quantities, numbers, words, each checked against its card.

use toml::de::DeValue;

use crate::diagnostic::TextRange;
use crate::fields::{Field, Kind};
use crate::findings::Findings;
use crate::quantity::{self, Dimension, Quantity, Unreadable};
use crate::tree::{At, Raw, Table, nearest, shorten, wrong_type};

impl<'t> Table<'t> {
    /// Text.
    pub(crate) fn text(&self, key: &str, findings: &mut Findings) -> Option<At<&'t str>> {
        let (field, raw) = self.entry(key)?;
        match raw.get_ref() {
            DeValue::String(text) => Some(At { value: text.as_ref(), range: raw.span().into() }),
            _ => wrong_type(field, raw, findings),
        }
    }

    /// A number with a unit [SI].
    pub(crate) fn quantity(&self, key: &str, findings: &mut Findings) -> Option<At<f64>> {
        let (field, raw) = self.entry(key)?;
        let Kind::Quantity(dimension) = field.kind else { return None };
        measure(field, raw, &[dimension], findings).map(|(quantity, range)| At { value: quantity.si(), range })
    }

    /// A number with a unit [SI], or infinity where the word for none is written.
    pub(crate) fn quantity_or_word(&self, key: &str, findings: &mut Findings) -> Option<At<f64>> {
        let (field, raw) = self.entry(key)?;
        let Kind::QuantityOr(dimension, word) = field.kind else { return None };
        if raw.get_ref().as_str() == Some(word) {
            return Some(At { value: f64::INFINITY, range: raw.span().into() });
        }
        measure(field, raw, &[dimension], findings).map(|(quantity, range)| At { value: quantity.si(), range })
    }

    /// A list of numbers with units [SI].
    pub(crate) fn quantities(&self, key: &str, findings: &mut Findings) -> Option<At<Vec<f64>>> {
        let (field, raw) = self.entry(key)?;
        let Kind::Quantities(dimension) = field.kind else { return None };
        let DeValue::Array(items) = raw.get_ref() else { return wrong_type(field, raw, findings) };
        let values: Vec<Option<f64>> = items
            .iter()
            .map(|item| measure(field, item, &[dimension], findings).map(|(quantity, _)| quantity.si()))
            .collect();
        Some(At { value: values.into_iter().collect::<Option<Vec<f64>>>()?, range: raw.span().into() })
    }

    /// A force per metre of width [N/m], or a force over the whole width.
    pub(crate) fn line_load(&self, key: &str, width: Option<f64>, findings: &mut Findings) -> Option<At<f64>> {
        let (field, raw) = self.entry(key)?;
        let (quantity, range) = measure(field, raw, &[Dimension::LineLoad, Dimension::Force], findings)?;
        let value = match quantity.unit.dimension {
            Dimension::Force => quantity.si() / width?,
            _ => quantity.si(),
        };
        Some(At { value, range })
    }

    /// A bare number.
    pub(crate) fn number(&self, key: &str, findings: &mut Findings) -> Option<At<f64>> {
        let (field, raw) = self.entry(key)?;
        bare(field, raw, findings)
    }

    /// A list of bare numbers.
    pub(crate) fn numbers(&self, key: &str, findings: &mut Findings) -> Option<At<Vec<f64>>> {
        let (field, raw) = self.entry(key)?;
        let DeValue::Array(items) = raw.get_ref() else { return wrong_type(field, raw, findings) };
        let values: Vec<Option<f64>> =
            items.iter().map(|item| bare(field, item, findings).map(|at| at.value)).collect();
        Some(At { value: values.into_iter().collect::<Option<Vec<f64>>>()?, range: raw.span().into() })
    }

    /// A list of rows of `N` bare numbers; the key carries their unit.
    pub(crate) fn rows<const N: usize>(&self, key: &str, findings: &mut Findings) -> Option<At<Vec<[f64; N]>>> {
        let (field, raw) = self.entry(key)?;
        let DeValue::Array(items) = raw.get_ref() else { return wrong_type(field, raw, findings) };
        let rows: Option<Vec<[f64; N]>> = items.iter().map(|item| row(field, item, findings)).collect();
        Some(At { value: rows?, range: raw.span().into() })
    }

    /// A whole number, at most the largest that is exact in double precision.
    pub(crate) fn count(&self, key: &str, findings: &mut Findings) -> Option<At<u64>> {
        let (field, raw) = self.entry(key)?;
        let range: TextRange = raw.span().into();
        let DeValue::Integer(integer) = raw.get_ref() else { return wrong_type(field, raw, findings) };
        let value = whole(integer.as_str(), integer.radix());
        let possible = value.filter(|value| field.limits.allow(*value as f64));
        match possible.and_then(|value| u64::try_from(value).ok()) {
            Some(value) => Some(At { value, range }),
            None => {
                findings.error(
                    "B108",
                    range,
                    format!("`{}` cannot be {}", field.key, shorten(integer.as_str())),
                    field.doc,
                    format!("write a whole number from {} to {}", field.limits.least, field.limits.most),
                );
                None
            }
        }
    }

    /// true or false.
    pub(crate) fn flag(&self, key: &str, findings: &mut Findings) -> Option<At<bool>> {
        let (field, raw) = self.entry(key)?;
        match raw.get_ref() {
            DeValue::Boolean(value) => Some(At { value: *value, range: raw.span().into() }),
            _ => wrong_type(field, raw, findings),
        }
    }

    /// One of the words of the field's card.
    pub(crate) fn word(&self, key: &str, findings: &mut Findings) -> Option<At<&'static str>> {
        let (field, raw) = self.entry(key)?;
        let Kind::Word(choices) = field.kind else { return None };
        let DeValue::String(written) = raw.get_ref() else { return wrong_type(field, raw, findings) };
        let range = raw.span().into();
        if let Some(choice) = choices.iter().find(|choice| choice.word == written.as_ref()) {
            return Some(At { value: choice.word, range });
        }
        let list = choices.iter().map(|choice| format!("\"{}\"", choice.word)).collect::<Vec<_>>().join(", ");
        let help = match nearest(written, choices.iter().map(|choice| choice.word)) {
            Some(near) => format!("did you mean \"{near}\"? Possible are {list}"),
            None => format!("write one of {list}"),
        };
        findings.error("B013", range, format!("`{}` cannot be \"{}\"", field.key, shorten(written)), field.doc, help);
        None
    }
}

/// A row of as many bare numbers; none of them beyond any bridge.
fn row<const N: usize>(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<[f64; N]> {
    let DeValue::Array(items) = raw.get_ref() else { return wrong_type(field, raw, findings) };
    let number = |item: &DeValue<'_>| match item {
        DeValue::Float(float) => float.as_str().replace('_', "").parse::<f64>().ok(),
        DeValue::Integer(integer) => whole(integer.as_str(), integer.radix()).map(|number| number as f64),
        _ => None,
    };
    let numbers: Option<Vec<f64>> = items.iter().map(|item| number(item.get_ref())).collect();
    let Some(row) = numbers.and_then(|numbers| <[f64; N]>::try_from(numbers).ok()) else {
        return wrong_type(field, raw, findings);
    };
    // Drawings may lie in the coordinates of the country.
    if row.iter().all(|value| value.abs() <= 1e6) { Some(row) } else { not_finite(field, raw.span().into(), findings) }
}

impl Table<'_> {
    /// A value of whatever quantity, as TOML has it.
    pub(crate) fn value(&self, key: &str, findings: &mut Findings) -> Option<String> {
        let (field, raw) = self.entry(key)?;
        literal(raw.get_ref()).or_else(|| wrong_type(field, raw, findings))
    }

    /// A list of such values, at least one.
    pub(crate) fn values(&self, key: &str, findings: &mut Findings) -> Option<Vec<String>> {
        let (field, raw) = self.entry(key)?;
        match raw.get_ref() {
            DeValue::Array(items) if items.iter().next().is_some() => {
                let one = |item: Raw<'_>| literal(item.get_ref());
                let list: Option<Vec<String>> = items.iter().map(one).collect();
                list.or_else(|| wrong_type(field, raw, findings))
            }
            _ => wrong_type(field, raw, findings),
        }
    }
}

/// A value as TOML has it; none for dates and tables, which no quantity is.
fn literal(value: &DeValue<'_>) -> Option<String> {
    match value {
        DeValue::String(text) => Some(toml_edit::Value::from(text.as_ref()).to_string()),
        DeValue::Integer(integer) => whole(integer.as_str(), integer.radix()).map(|number| number.to_string()),
        DeValue::Float(float) => Some(float.as_str().to_owned()),
        DeValue::Boolean(flag) => Some(flag.to_string()),
        DeValue::Array(items) => {
            let list: Option<Vec<String>> = items.iter().map(|item| literal(item.get_ref())).collect();
            list.map(|list| format!("[{}]", list.join(", ")))
        }
        DeValue::Datetime(_) | DeValue::Table(_) => None,
    }
}

/// Reads a bare number.
fn bare(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<At<f64>> {
    let range = raw.span().into();
    let value = match raw.get_ref() {
        DeValue::Float(float) => float.as_str().replace('_', "").parse::<f64>().ok(),
        DeValue::Integer(integer) => whole(integer.as_str(), integer.radix()).map(|number| number as f64),
        _ => return wrong_type(field, raw, findings),
    };
    match value {
        Some(value) if value.is_finite() => check_limits(field, value, range, findings).then_some(At { value, range }),
        _ => not_finite(field, range, findings),
    }
}

/// Reads a quantity of one of several dimensions; the first is the one suggested.
pub(crate) fn measure(
    field: &Field,
    raw: Raw<'_>,
    wanted: &[Dimension],
    findings: &mut Findings,
) -> Option<(Quantity, TextRange)> {
    let range = raw.span().into();
    let unit = example_unit(field, wanted[0]);
    match raw.get_ref() {
        DeValue::String(text) => match quantity::parse(text) {
            Ok(quantity) if wanted.contains(&quantity.unit.dimension) => {
                check_size(field, quantity, range, findings).then_some((quantity, range))
            }
            Ok(quantity) => wrong_dimension(field, quantity, wanted, unit, range, findings),
            Err(reason) => unreadable(field, text, reason, unit, range, findings),
        },
        DeValue::Integer(_) | DeValue::Float(_) => {
            let number = match raw.get_ref() {
                DeValue::Integer(integer) => integer.to_string(),
                DeValue::Float(float) => float.to_string(),
                _ => String::new(),
            };
            findings
                .error(
                    "B101",
                    range,
                    format!("`{}` needs a unit", field.key),
                    field.doc,
                    format!("write {} = \"{} {unit}\", if {unit} is meant", field.key, shorten(&number)),
                )
                .because("bare numbers are refused where there is a dimension: slips of unit are the costliest of all");
            None
        }
        _ => wrong_type(field, raw, findings),
    }
}

/// The unit of the field's example, which engineers would use here.
fn example_unit(field: &Field, wanted: Dimension) -> &'static str {
    let usual = field.example.split('"').find_map(|piece| quantity::parse(piece).ok());
    match usual {
        Some(quantity) => quantity.unit.symbol,
        None => wanted.units().next().map_or("", |unit| unit.symbol),
    }
}

/// What a unit measures.
fn dimension_of(symbol: &str) -> Option<Dimension> {
    quantity::UNITS.iter().find(|unit| unit.symbol == symbol).map(|unit| unit.dimension)
}

fn wrong_dimension<T>(
    field: &Field,
    found: Quantity,
    wanted: &[Dimension],
    unit: &str,
    range: TextRange,
    findings: &mut Findings,
) -> Option<T> {
    let names = wanted.iter().map(|dimension| dimension.name()).collect::<Vec<_>>().join(" or ");
    let help = match (found.unit.dimension, wanted[0]) {
        (Dimension::UnitWeight, Dimension::Density) => {
            format!("divide by gravity: write \"{:.0} kg/m^3\"", found.si() / quantity::STANDARD_GRAVITY)
        }
        (Dimension::Mass, Dimension::Force | Dimension::LineLoad) => {
            format!("multiply by gravity: write \"{:.2} kN\"", found.si() * quantity::STANDARD_GRAVITY / 1e3)
        }
        // Feet and pounds of something else: the number means nothing in metric units.
        _ if found.unit.imperial() => format!("write {} in {unit}", wanted[0].name()),
        _ => format!("write \"{} {unit}\", if {unit} is meant", found.number),
    };
    findings.error("B104", range, format!("expected {names}, found {}", found.unit.dimension.name()), field.doc, help);
    None
}

fn unreadable<T>(
    field: &Field,
    text: &str,
    reason: Unreadable,
    unit: &str,
    range: TextRange,
    findings: &mut Findings,
) -> Option<T> {
    match reason {
        Unreadable::NoUnit(number) => {
            findings.error(
                "B102",
                range,
                format!("`{}` has no unit", field.key),
                field.doc,
                format!("write \"{number} {unit}\", if {unit} is meant"),
            );
        }
        Unreadable::UnknownUnit(number, symbol, near) => {
            // A number never goes into another unit as it is.
            let of_kind = |near: &&quantity::Unit| Some(near.dimension) == dimension_of(unit);
            let help = match near.filter(of_kind) {
                Some(near) if near.symbol.eq_ignore_ascii_case(&symbol) => {
                    format!("did you mean \"{number} {}\"?", near.symbol)
                }
                _ if ["ton", "tons"].contains(&symbol.to_lowercase().as_str()) => {
                    "a ton may be \"t\" (1000 kg), the British ton-force \"tonf\" (9.964 kN) or the American one (8.896 kN, 2 kip): write which"
                        .to_owned()
                }
                _ => {
                    let list: Vec<&str> =
                        dimension_of(unit).into_iter().flat_map(Dimension::units).map(|unit| unit.symbol).collect();
                    format!("convert the number into one of these units: {}", list.join(", "))
                }
            };
            let message = format!("`{}` is not a unit that is known here", shorten(&symbol));
            findings.error("B103", range, message, field.doc, help);
        }
        Unreadable::Comma(meant) => {
            findings.error(
                "B105",
                range,
                format!("`{}` is written with a decimal comma", field.key),
                field.doc,
                format!("use a decimal point: \"{}\"", shorten(&meant)),
            );
        }
        Unreadable::NoNumber => {
            findings.error(
                "B105",
                range,
                format!("\"{}\" does not start with a number", shorten(text)),
                field.doc,
                format!("write {}", field.form()),
            );
        }
        Unreadable::Infinite => return not_finite(field, range, findings),
    }
    None
}

fn not_finite<T>(field: &Field, range: TextRange, findings: &mut Findings) -> Option<T> {
    findings.error(
        "B106",
        range,
        format!("`{}` is not a number that can be calculated with", field.key),
        field.doc,
        format!("write {}", field.form()),
    );
    None
}

/// A size that no bridge has is a slip of the pen; one outside the card's limits is impossible.
fn check_size(field: &Field, quantity: Quantity, range: TextRange, findings: &mut Findings) -> bool {
    let value = quantity.si();
    let most = quantity.unit.dimension.most();
    if value.abs() > most {
        findings.error(
            "B106",
            range,
            format!("`{}` is beyond anything that a bridge can have", field.key),
            field.doc,
            "check number and unit".to_owned(),
        );
        return false;
    }
    // A number that vanishes in SI would divide by zero later on.
    if value != 0.0 && value.abs() < 1e-12 * most.min(1.0) {
        findings.error(
            "B106",
            range,
            format!("`{}` is so small that it vanishes", field.key),
            field.doc,
            "check number and unit".to_owned(),
        );
        return false;
    }
    check_limits(field, value, range, findings)
}

fn check_limits(field: &Field, value: f64, range: TextRange, findings: &mut Findings) -> bool {
    if field.limits.allow(value) {
        return true;
    }
    let limits = field.limits;
    let (rule, bound) = match value > limits.most {
        true => ("at most", limits.most),
        false if limits.least_included => ("at least", limits.least),
        false => ("more than", limits.least),
    };
    // In the unit that the example uses, and no more digits than that is worth.
    let bound = match field.example.split('"').find_map(|piece| quantity::parse(piece).ok()) {
        Some(example) => format!("{} {}", (bound / example.unit.size * 1e6).round() / 1e6, example.unit.symbol),
        None => bound.to_string(),
    };
    findings.error(
        "B107",
        range,
        format!("`{}` is out of its possible range", field.key),
        field.doc,
        format!("it must be {rule} {bound}"),
    );
    false
}

/// A whole number that fits, from its digits and radix.
fn whole(digits: &str, radix: u32) -> Option<i64> {
    i64::from_str_radix(&digits.replace('_', ""), radix).ok()
}
