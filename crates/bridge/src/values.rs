//! Values of a table: quantities, numbers, words, each checked against its card.

use ::findings::visible::is_hidden;
use toml::de::DeValue;

use crate::card::{Field, Kind, Need};
use crate::choice::{Choice, Word};
use crate::diagnostic::TextRange;
use crate::findings::Findings;
use crate::quantity::{self, Dimension, Quantity, Unreadable};
use crate::tree::{At, Raw, Table, nearest, shorten, too_many, wrong_type};

/// A type that a key is read as.
pub(crate) trait Value: Sized {
    /// The value that is written, or that a card gives as its default; wrong ones are reported.
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self>;

    /// What it means that neither file nor card gives one.
    fn absent(_: &Field) -> Option<Self> {
        None
    }
}

impl<'t> Table<'t> {
    /// The value of a key, or the default of its card where it is not written. None where it is wrong, or missing where it must be
    /// there, which has been reported then.
    pub(crate) fn read<T: Value>(&self, key: &str, findings: &mut Findings) -> Option<T> {
        if let Some((field, raw)) = self.entry(key) {
            return T::of(field, raw, findings);
        }
        let field = self.section.field(key).filter(|_| !self.has(key))?;
        match field.need {
            Need::Default(text) => {
                let literal = field.literal(text);
                T::of(field, &DeValue::parse(&literal).ok()?, findings)
            }
            _ => match self.under.filter(|under| under.section.field(key).is_some()) {
                // What is wrong with the other table has been reported.
                Some(under) => under.read(key, &mut Findings::default()),
                None => T::absent(field),
            },
        }
    }

    /// A force per metre of width [N/m], or a force over the whole width.
    pub(crate) fn line_load(&self, key: &str, width: Option<f64>, findings: &mut Findings) -> Option<Option<f64>> {
        if !self.has(key) {
            return Some(None);
        }
        let (field, raw) = self.entry(key)?;
        let quantity = measure(field, raw, &[Dimension::LineLoad, Dimension::Force], findings)?;
        Some(Some(match quantity.unit.dimension {
            Dimension::Force => quantity.si() / width?,
            _ => quantity.si(),
        }))
    }
}

/// Reads keys into the fields of the same names; more fields may follow, made from these or otherwise. A key of another name than its
/// field stands behind it.
macro_rules! read {
    ($table:expr, $findings:expr, $name:ident { $($field:ident $(= $key:literal)?),+ $(,)? $(; $($rest:tt)+)? }) => {{
        let table = $table;
        $(let $field = table.read($crate::values::read!(@key $field $($key)?), $findings);)+
        $(let $field = $field?;)+
        Some($name { $($field,)+ $($($rest)+)? })
    }};
    (@key $field:ident) => { stringify!($field) };
    (@key $field:ident $key:literal) => { $key };
}
pub(crate) use read;

/// A struct whose fields are keys of a table, each with its card behind it: what it is, an example, and what else the card says; the
/// documentation of the field is made from it. A key of another name than its field stands in brackets. A function behind an arrow reads what
/// is not the value as it is written. Fields without a card of their own follow after `and`, with the functions that make them from the table.
macro_rules! of_keys {
    ($(#[$meta:meta])* $vis:vis struct $name:ident { $(
        $(#[$about:meta])* $of:vis $field:ident $(($key:literal))?: $type:ty
            = $kind:ident $(::<$choice:ty>)? ($doc:literal, $example:expr $(,)?) $(.$method:ident($($argument:tt)*))*
            $(=> $read:expr)?,
    )+ } $(and { $($(#[$more:meta])* $with:vis $beside:ident: $other:ty => $make:expr,)+ })?) => {
        $(#[$meta])*
        $vis struct $name {
            $(
                #[doc = concat!($doc, $crate::cards::unit_of!($kind), ".")]
                $(#[doc = $crate::values::of_keys!(@about $method $($argument)*)])*
                $(#[$about])*
                $of $field: $type,
            )+
            $($($(#[$more])* $with $beside: $other,)+)?
        }

        impl $name {
            /// Cards of its keys, in the order of the reference.
            pub(crate) const CARDS: &'static [$crate::card::Field] = &[$(
                $kind $(::<$choice>)? ([$($key,)? stringify!($field)][0], $doc, $example) $(.$method($($argument)*))*
            ),+];

            /// What a table says.
            pub(crate) fn of(table: &$crate::tree::Table<'_>, findings: &mut $crate::findings::Findings) -> Option<$name> {
                $(let $field: Option<$type> =
                    $crate::values::of_keys!(@read table, [$($key,)? stringify!($field)][0], findings $(, $read)?);)+
                $($(let $beside: Option<$other> = $make(table, findings);)+)?
                Some($name { $($field: $field?,)+ $($($beside: $beside?,)+)? })
            }
        }
    };
    (@about optional $meaning:literal $(,)?) => { concat!("Where missing: ", $meaning, ".") };
    (@about $method:ident $($argument:tt)*) => { "" };
    (@read $table:ident, $key:expr, $findings:ident) => { $table.read($key, $findings) };
    (@read $table:ident, $key:expr, $findings:ident, $read:expr) => { $read($table, $key, $findings) };
}
pub(crate) use of_keys;

/// A value and its place.
impl<T: Value> Value for At<T> {
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self> {
        T::of(field, raw, findings).map(|value| At { value, range: raw.span().into() })
    }
}

/// A value that may be missing.
impl<T: Value> Value for Option<T> {
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self> {
        T::of(field, raw, findings).map(Some)
    }

    fn absent(_: &Field) -> Option<Self> {
        Some(None)
    }
}

/// A number [SI]; infinity where a word for none is written.
impl Value for f64 {
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self> {
        match field.kind {
            Kind::QuantityOr(_, word) | Kind::NumberOr(word) if raw.get_ref().as_str() == Some(word) => {
                Some(f64::INFINITY)
            }
            Kind::Quantity(dimension) | Kind::QuantityOr(dimension, _) | Kind::Quantities(dimension) => {
                measure(field, raw, &[dimension], findings).map(|quantity| quantity.si())
            }
            Kind::Slope => slope(field, raw, findings),
            _ => bare(field, raw, findings),
        }
    }
}

/// Text, or a value of whatever quantity as TOML has it.
impl Value for String {
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self> {
        let value = match (field.kind, raw.get_ref()) {
            (Kind::Value | Kind::Values, value) => literal(value),
            (_, DeValue::String(text)) => Some(one_line(text)),
            _ => None,
        };
        match value {
            Some(text) => words(field, text, raw.span().into(), findings),
            None => wrong_type(field, raw, findings),
        }
    }
}

/// A text on one line: names and notes stand in tables, titles and on a terminal.
fn one_line(text: &str) -> String {
    text.replace("\r\n", " ").replace(['\n', '\r', '\t'], " ")
}

/// A text that can be read as it stands, and is not longer than its card allows.
fn words(field: &Field, text: String, range: TextRange, findings: &mut Findings) -> Option<String> {
    let (count, most) = (text.chars().count(), field.most_characters());
    if count > most {
        let message = format!("`{}` has {count} characters, more than {most}", field.key);
        return findings.refuse("B110", range, message, field.doc, format!("write {most} characters at most"));
    }
    if let Some(hidden) = text.chars().find(|character| is_hidden(*character)) {
        let message = format!("`{}` holds the character U+{:04X}, which cannot be seen", field.key, u32::from(hidden));
        return findings.refuse("B111", range, message, field.doc, "delete the text and type it again");
    }
    let justifies = field.key.ends_with("source") || field.key.ends_with("reason");
    if justifies && !text.chars().any(char::is_alphanumeric) {
        let message = format!("`{}` names nothing", field.key);
        return findings.refuse("B113", range, message, field.doc, "write what it rests on, or leave the line out");
    }
    Some(text)
}

/// The words of a list, without quotes.
pub(crate) fn bare_words(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<Vec<String>> {
    let list: Vec<String> = table.read(key, findings)?;
    Some(list.into_iter().map(|word| word.trim_matches(['"', '\'']).to_owned()).collect())
}

/// A number; none where a word stands for it.
pub(crate) fn finite(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<Option<f64>> {
    Some(table.read::<Option<f64>>(key, findings)?.filter(|value| value.is_finite()))
}

impl Value for bool {
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self> {
        raw.get_ref().as_bool().or_else(|| wrong_type(field, raw, findings))
    }
}

/// A whole number, at most the largest that is exact in double precision.
impl Value for u64 {
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self> {
        let DeValue::Integer(integer) = raw.get_ref() else { return wrong_type(field, raw, findings) };
        let value = whole(integer.as_str(), integer.radix()).filter(|value| field.limits.allow(*value as f64));
        let value = value.and_then(|value| u64::try_from(value).ok());
        if value.is_none() {
            findings.error(
                "B108",
                raw.span().into(),
                format!("`{}` cannot be {}", field.key, shorten(integer.as_str())),
                field.doc,
                format!("write a whole number from {} to {}", field.limits.least, field.limits.most),
            );
        }
        value
    }
}

impl Value for usize {
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self> {
        u64::of(field, raw, findings).map(|value| usize::try_from(value).unwrap_or(usize::MAX))
    }
}

/// A list; one of values of whatever quantity has at least one.
impl<T: Value> Value for Vec<T> {
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self> {
        match raw.get_ref() {
            DeValue::Array(items) if items.len() > field.most_entries() => {
                too_many(field, items.len(), "entries", raw.span().into(), findings);
                None
            }
            DeValue::Array(items) if !matches!(field.kind, Kind::Values) || items.iter().next().is_some() => {
                let values: Vec<Option<T>> = items.iter().map(|item| T::of(field, item, findings)).collect();
                values.into_iter().collect()
            }
            _ => wrong_type(field, raw, findings),
        }
    }

    /// One that may be left out is empty then.
    fn absent(field: &Field) -> Option<Self> {
        matches!(field.need, Need::Optional(_)).then(Vec::new)
    }
}

/// The value of one of the words of the field's card.
impl<T: Choice> Value for T {
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self> {
        let same = |words: &[Word]| words.iter().map(|w| w.word).eq(T::WORDS.iter().map(|w| w.word));
        debug_assert!(matches!(field.kind, Kind::Word(words) if same(words)), "words of `{}`", field.key);
        let DeValue::String(written) = raw.get_ref() else { return wrong_type(field, raw, findings) };
        let value = T::named(written);
        if value.is_none() {
            let words = || T::WORDS.iter().map(|choice| choice.word);
            let list = words().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ");
            let help = match nearest(written, words()) {
                Some(near) => format!("did you mean \"{near}\"? Possible are {list}"),
                None => format!("write one of {list}"),
            };
            let message = format!("`{}` cannot be \"{}\"", field.key, shorten(written));
            findings.error("B013", raw.span().into(), message, field.doc, help);
        }
        value
    }
}

/// A point, or a row of bare numbers; the key carries their unit.
impl<const N: usize> Value for [f64; N] {
    fn of(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<Self> {
        let Kind::Points = field.kind else { return row(field, raw, findings) };
        let items: Vec<Raw<'_>> = raw.get_ref().as_array().into_iter().flat_map(|items| items.iter()).collect();
        if items.len() != N {
            return findings.refuse(
                "B012",
                raw.span().into(),
                "a point is a pair of lengths",
                "point",
                "write [\"2.0 m\", \"1.1 m\"]: distance from the left springing, height",
            );
        }
        let length = |item| Some(measure(field, item, &[Dimension::Length], findings)?.si());
        let lengths: Vec<Option<f64>> = items.into_iter().map(length).collect();
        lengths.into_iter().collect::<Option<Vec<f64>>>()?.try_into().ok()
    }
}

/// "2:1", vertical to horizontal.
fn slope(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<f64> {
    let DeValue::String(text) = raw.get_ref() else { return wrong_type(field, raw, findings) };
    let Some(value) = read_slope(text).filter(|value| value.is_finite()) else {
        let message = format!("\"{}\" is no slope", shorten(text));
        let help = "write vertical to horizontal: \"2:1\" spreads by half the depth on each side";
        return findings.refuse("B109", raw.span().into(), message, field.doc, help);
    };
    check_limits(field, value, raw.span().into(), findings).then_some(value)
}

/// Vertical over horizontal.
pub(crate) fn read_slope(text: &str) -> Option<f64> {
    let (vertical, horizontal) = text.split_once(':')?;
    Some(decimal(vertical)? / decimal(horizontal)?)
}

/// A number without sign or exponent.
pub(crate) fn decimal(text: &str) -> Option<f64> {
    let text = text.trim();
    text.chars().all(|c| c.is_ascii_digit() || c == '.').then(|| text.parse().ok()).flatten()
}

/// A row of as many bare numbers; none of them beyond any bridge.
fn row<const N: usize>(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<[f64; N]> {
    let DeValue::Array(items) = raw.get_ref() else { return wrong_type(field, raw, findings) };
    let numbers: Option<Vec<f64>> = items.iter().map(|item| number(item.get_ref())).collect();
    let Some(row) = numbers.and_then(|numbers| <[f64; N]>::try_from(numbers).ok()) else {
        return wrong_type(field, raw, findings);
    };
    // Drawings may lie in the coordinates of the country.
    if row.iter().all(|value| value.abs() <= 1e6) { Some(row) } else { not_finite(field, raw.span().into(), findings) }
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

/// A bare number as it is written.
fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Float(float) => float.as_str().replace('_', "").parse().ok(),
        DeValue::Integer(integer) => whole(integer.as_str(), integer.radix()).map(|number| number as f64),
        _ => None,
    }
}

/// Reads a bare number.
fn bare(field: &Field, raw: Raw<'_>, findings: &mut Findings) -> Option<f64> {
    let range = raw.span().into();
    if !matches!(raw.get_ref(), DeValue::Float(_) | DeValue::Integer(_)) {
        return wrong_type(field, raw, findings);
    }
    match number(raw.get_ref()) {
        Some(value) if value.is_finite() => check_limits(field, value, range, findings).then_some(value),
        _ => not_finite(field, range, findings),
    }
}

/// Reads a quantity of one of several dimensions; the first is the one suggested.
pub(crate) fn measure(field: &Field, raw: Raw<'_>, wanted: &[Dimension], findings: &mut Findings) -> Option<Quantity> {
    let range = raw.span().into();
    let unit = field.example_quantity().map(|quantity| quantity.unit).or(wanted[0].units().next());
    let unit = unit.map_or("", |unit| unit.symbol);
    match raw.get_ref() {
        DeValue::String(text) => match quantity::parse(text) {
            Ok(quantity) => match quantity.of(wanted) {
                Some(quantity) => check_size(field, quantity, range, findings).then_some(quantity),
                None => wrong_dimension(field, quantity, wanted, unit, range, findings),
            },
            Err(reason) => unreadable(field, text, reason, unit, range, findings),
        },
        DeValue::Integer(_) | DeValue::Float(_) => {
            let number = match raw.get_ref() {
                DeValue::Integer(integer) => integer.to_string(),
                DeValue::Float(float) => float.to_string(),
                _ => String::new(),
            };
            let help = number.parse().ok().and_then(|number| with_unit(field, number, unit)).unwrap_or_else(|| {
                format!("write {} = \"{} {unit}\", if {unit} is meant", field.key, shorten(&number))
            });
            findings
                .error("B101", range, format!("`{}` needs a unit", field.key), field.doc, help)
                .because("bare numbers are refused where there is a dimension: slips of unit are the costliest of all");
            None
        }
        _ => wrong_type(field, raw, findings),
    }
}

/// The quantity that a bare number of the trade stands for: a coefficient of friction is the tangent of an angle.
fn with_unit(field: &Field, number: f64, unit: &str) -> Option<String> {
    // A number of millimetres is no number of metres.
    if unit == "m" && number >= 50.0 && field.limits.most < number {
        return Some(format!("write \"{number} mm\", if millimetres are meant"));
    }
    let coefficient = field.key.contains("friction_angle") && unit == "deg" && number > 0.0 && number < 2.0;
    coefficient.then(|| {
        format!(
            "write \"{:.1} deg\", the arctangent of a coefficient of friction of {number}",
            number.atan().to_degrees()
        )
    })
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
    // Feet and pounds of something else: the number means nothing in metric units.
    let help = match found.unit.imperial() {
        true => format!("write {} in {unit}", wanted[0].name()),
        false => format!("write \"{} {unit}\", if {unit} is meant", found.number),
    };
    findings.refuse("B104", range, format!("expected {names}, found {}", found.unit.dimension.name()), field.doc, help)
}

fn unreadable<T>(
    field: &Field,
    text: &str,
    reason: Unreadable,
    unit: &str,
    range: TextRange,
    findings: &mut Findings,
) -> Option<T> {
    let (code, message, help) = match reason {
        Unreadable::NoUnit(number) => {
            let help = with_unit(field, number, unit)
                .unwrap_or_else(|| format!("write \"{number} {unit}\", if {unit} is meant"));
            ("B102", format!("`{}` has no unit", field.key), help)
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
            ("B103", format!("`{}` is not a unit that is known here", shorten(&symbol)), help)
        }
        Unreadable::Comma(meant) => {
            let message = format!("`{}` is written with a decimal comma", field.key);
            ("B105", message, format!("use a decimal point: \"{}\"", shorten(&meant)))
        }
        Unreadable::NoNumber => {
            let message = format!("\"{}\" does not start with a number", shorten(text));
            ("B105", message, format!("write {}", field.form()))
        }
        Unreadable::Infinite => return not_finite(field, range, findings),
    };
    findings.refuse(code, range, message, field.doc, help)
}

fn not_finite<T>(field: &Field, range: TextRange, findings: &mut Findings) -> Option<T> {
    findings.refuse(
        "B106",
        range,
        format!("`{}` is not a number that can be calculated with", field.key),
        field.doc,
        format!("write {}", field.form()),
    )
}

/// A size that no bridge has is a slip of the pen; one outside the card's limits is impossible.
fn check_size(field: &Field, quantity: Quantity, range: TextRange, findings: &mut Findings) -> bool {
    let value = quantity.si();
    let most = quantity.unit.dimension.most();
    let slip = match value.abs() {
        size if size > most => "is beyond anything that a bridge can have",
        // A number that vanishes in SI would divide by zero later on.
        size if size != 0.0 && size < 1e-12 * most.min(1.0) => "is so small that it vanishes",
        _ => return check_limits(field, value, range, findings),
    };
    findings.error("B106", range, format!("`{}` {slip}", field.key), field.doc, "check number and unit");
    false
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
    let bound = match field.example_quantity() {
        Some(example) => format!("{} {}", (bound / example.unit.size * 1e6).round() / 1e6, example.unit.symbol),
        None if matches!(field.kind, Kind::Slope) && bound > 0.0 && bound < 1.0 => {
            format!("1:{}", (1.0 / bound).round())
        }
        None if matches!(field.kind, Kind::Slope) => format!("{bound}:1"),
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
