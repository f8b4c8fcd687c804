//! Numbers with units, "18.30 m" to SI: the only unit conversion in the system.

/// What a quantity measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Dimension {
    /// Length [m].
    Length,
    /// Angle [rad].
    Angle,
    /// Mass density [kg/m^3].
    Density,
    /// Pressure, stress, strength or modulus [Pa].
    Stress,
    /// Stiffness per unit area of a joint [Pa/m].
    JointStiffness,
    /// Force [N].
    Force,
    /// Force per metre of width [N/m].
    LineLoad,
    /// Acceleration [m/s^2].
    Acceleration,
    /// Rotation per length of movement [rad/m].
    AngleRate,
    /// Bending stiffness of a beam [N m^2].
    BendingStiffness,
    /// Speed [m/s].
    Speed,
    /// Time [s].
    Time,
    /// Frequency [Hz].
    Frequency,
    /// Mass [kg].
    Mass,
    /// Strain [-].
    Strain,
}

/// A unit: how it is written, what it measures, and its size in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// As written in files.
    pub symbol: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    /// Size in the SI unit of the dimension.
    pub size: f64,
}

/// Standard acceleration of gravity [m/s^2]; 3rd General Conference on Weights and Measures, 1901.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Gravity by which a weight per volume stands for a density, and a mass for its weight [m/s^2]: that of a bridge file that states none, so
/// that "22 kN/m^3" weighs 22 kN/m^3 there.
pub const USUAL_GRAVITY: f64 = 9.81;

const DEGREE: f64 = std::f64::consts::PI / 180.0;
/// The yard and pound agreement of 1959, exact.
const INCH: f64 = 0.0254;
const FOOT: f64 = 12.0 * INCH;
const POUND: f64 = 0.453_592_37;
const POUND_FORCE: f64 = POUND * STANDARD_GRAVITY;

impl Unit {
    /// Whether it belongs to feet and pounds.
    pub fn imperial(&self) -> bool {
        const SYMBOLS: [&str; 12] = ["ft", "in", "yd", "lb", "pcf", "psi", "ksi", "psf", "ksf", "pci", "kip", "mph"];
        let first = self.symbol.split('/').next().unwrap_or_default();
        SYMBOLS.contains(&first) || first == "lbf" || first == "tonf"
    }
}

const fn unit(symbol: &'static str, dimension: Dimension, size: f64) -> Unit {
    Unit { symbol, dimension, size }
}

/// Every unit that is understood; the first of a dimension is the one suggested. `tonf` is the British ton of 2240 lbf. Masses stand for their
/// weights, and weights per volume for densities, by [`USUAL_GRAVITY`].
pub const UNITS: &[Unit] = &[
    unit("m", Dimension::Length, 1.0),
    unit("mm", Dimension::Length, 1e-3),
    unit("cm", Dimension::Length, 1e-2),
    unit("ft", Dimension::Length, FOOT),
    unit("in", Dimension::Length, INCH),
    unit("yd", Dimension::Length, 3.0 * FOOT),
    unit("deg", Dimension::Angle, DEGREE),
    unit("°", Dimension::Angle, DEGREE),
    unit("rad", Dimension::Angle, 1.0),
    unit("mrad", Dimension::Angle, 1e-3),
    unit("kg/m^3", Dimension::Density, 1.0),
    unit("t/m^3", Dimension::Density, 1e3),
    unit("g/cm^3", Dimension::Density, 1e3),
    unit("lb/ft^3", Dimension::Density, POUND / (FOOT * FOOT * FOOT)),
    unit("pcf", Dimension::Density, POUND / (FOOT * FOOT * FOOT)),
    unit("kN/m^3", Dimension::Density, 1e3 / USUAL_GRAVITY),
    unit("N/m^3", Dimension::Density, 1.0 / USUAL_GRAVITY),
    unit("MN/m^3", Dimension::Density, 1e6 / USUAL_GRAVITY),
    unit("lbf/ft^3", Dimension::Density, POUND_FORCE / USUAL_GRAVITY / (FOOT * FOOT * FOOT)),
    unit("MPa", Dimension::Stress, 1e6),
    unit("Pa", Dimension::Stress, 1.0),
    unit("kPa", Dimension::Stress, 1e3),
    unit("GPa", Dimension::Stress, 1e9),
    unit("N/m^2", Dimension::Stress, 1.0),
    unit("kN/m^2", Dimension::Stress, 1e3),
    unit("MN/m^2", Dimension::Stress, 1e6),
    unit("N/mm^2", Dimension::Stress, 1e6),
    unit("kN/mm^2", Dimension::Stress, 1e9),
    unit("psi", Dimension::Stress, POUND_FORCE / (INCH * INCH)),
    unit("ksi", Dimension::Stress, 1e3 * POUND_FORCE / (INCH * INCH)),
    unit("lbf/in^2", Dimension::Stress, POUND_FORCE / (INCH * INCH)),
    unit("psf", Dimension::Stress, POUND_FORCE / (FOOT * FOOT)),
    unit("ksf", Dimension::Stress, 1e3 * POUND_FORCE / (FOOT * FOOT)),
    unit("lbf/ft^2", Dimension::Stress, POUND_FORCE / (FOOT * FOOT)),
    unit("tonf/ft^2", Dimension::Stress, 2240.0 * POUND_FORCE / (FOOT * FOOT)),
    unit("t/m^2", Dimension::Stress, 1e3 * USUAL_GRAVITY),
    unit("kg/m^2", Dimension::Stress, USUAL_GRAVITY),
    unit("tonf/in^2", Dimension::Stress, 2240.0 * POUND_FORCE / (INCH * INCH)),
    unit("GPa/m", Dimension::JointStiffness, 1e9),
    unit("Pa/m", Dimension::JointStiffness, 1.0),
    unit("kPa/m", Dimension::JointStiffness, 1e3),
    unit("MPa/m", Dimension::JointStiffness, 1e6),
    unit("MPa/mm", Dimension::JointStiffness, 1e9),
    unit("GPa/mm", Dimension::JointStiffness, 1e12),
    unit("N/mm^3", Dimension::JointStiffness, 1e9),
    unit("pci", Dimension::JointStiffness, POUND_FORCE / (INCH * INCH * INCH)),
    unit("lbf/in^3", Dimension::JointStiffness, POUND_FORCE / (INCH * INCH * INCH)),
    unit("kN", Dimension::Force, 1e3),
    unit("N", Dimension::Force, 1.0),
    unit("MN", Dimension::Force, 1e6),
    unit("lbf", Dimension::Force, POUND_FORCE),
    unit("kip", Dimension::Force, 1e3 * POUND_FORCE),
    unit("tonf", Dimension::Force, 2240.0 * POUND_FORCE),
    unit("kN/m", Dimension::LineLoad, 1e3),
    unit("N/m", Dimension::LineLoad, 1.0),
    unit("MN/m", Dimension::LineLoad, 1e6),
    unit("N/mm", Dimension::LineLoad, 1e3),
    unit("lbf/ft", Dimension::LineLoad, POUND_FORCE / FOOT),
    unit("kip/ft", Dimension::LineLoad, 1e3 * POUND_FORCE / FOOT),
    unit("t/m", Dimension::LineLoad, 1e3 * USUAL_GRAVITY),
    unit("kg/m", Dimension::LineLoad, USUAL_GRAVITY),
    unit("tonf/ft", Dimension::LineLoad, 2240.0 * POUND_FORCE / FOOT),
    unit("m/s^2", Dimension::Acceleration, 1.0),
    unit("rad/m", Dimension::AngleRate, 1.0),
    unit("deg/m", Dimension::AngleRate, DEGREE),
    unit("kg", Dimension::Mass, 1.0),
    unit("t", Dimension::Mass, 1e3),
    unit("tonne", Dimension::Mass, 1e3),
    unit("lb", Dimension::Mass, POUND),
    unit("MNm^2", Dimension::BendingStiffness, 1e6),
    unit("kNm^2", Dimension::BendingStiffness, 1e3),
    unit("Nm^2", Dimension::BendingStiffness, 1.0),
    unit("km/h", Dimension::Speed, 1.0 / 3.6),
    unit("m/s", Dimension::Speed, 1.0),
    unit("mph", Dimension::Speed, 5280.0 * FOOT / 3600.0),
    unit("s", Dimension::Time, 1.0),
    unit("ms", Dimension::Time, 1e-3),
    unit("Hz", Dimension::Frequency, 1.0),
    unit("microstrain", Dimension::Strain, 1e-6),
    unit("µm/m", Dimension::Strain, 1e-6),
    unit("mm/m", Dimension::Strain, 1e-3),
];

/// What a mass is where a force is asked for, its weight, and a force where a mass is.
const WEIGHTS: &[Unit] = &[
    unit("kg", Dimension::Force, USUAL_GRAVITY),
    unit("t", Dimension::Force, 1e3 * USUAL_GRAVITY),
    unit("tonne", Dimension::Force, 1e3 * USUAL_GRAVITY),
    unit("lb", Dimension::Force, POUND_FORCE),
    unit("kN", Dimension::Mass, 1e3 / USUAL_GRAVITY),
    unit("N", Dimension::Mass, 1.0 / USUAL_GRAVITY),
    unit("MN", Dimension::Mass, 1e6 / USUAL_GRAVITY),
    unit("lbf", Dimension::Mass, POUND),
    unit("kip", Dimension::Mass, 1e3 * POUND),
    unit("tonf", Dimension::Mass, 2240.0 * POUND),
];

impl Dimension {
    /// What it is called, and the largest size [SI] that can belong to a bridge.
    const fn facts(self) -> (&'static str, f64) {
        match self {
            Dimension::Length => ("a length", 1e3),
            Dimension::Angle => ("an angle", std::f64::consts::PI),
            Dimension::Density => ("a density", 2.5e4),
            Dimension::Stress => ("a pressure", 1e13),
            Dimension::JointStiffness => ("a stiffness per area", 1e16),
            Dimension::Force => ("a force", 1e11),
            Dimension::LineLoad => ("a force per metre of width", 1e10),
            Dimension::Acceleration => ("an acceleration", 1e3),
            Dimension::AngleRate => ("a rotation per metre", 1e6),
            Dimension::BendingStiffness => ("a bending stiffness", 1e12),
            Dimension::Speed => ("a speed", 200.0),
            Dimension::Time => ("a time", 1e4),
            Dimension::Frequency => ("a frequency", 1e6),
            Dimension::Mass => ("a mass", 1e10),
            Dimension::Strain => ("a strain", 0.1),
        }
    }

    /// "a length", "a pressure": for sentences.
    pub fn name(self) -> &'static str {
        self.facts().0
    }

    /// Units of this dimension, the usual one first.
    pub fn units(self) -> impl Iterator<Item = &'static Unit> {
        UNITS.iter().filter(move |unit| unit.dimension == self)
    }

    /// Units in which a value of this dimension may be given: its own, and those of masses that weigh it or forces that it weighs.
    pub fn accepted(self) -> impl Iterator<Item = &'static Unit> {
        self.units().chain(WEIGHTS.iter().filter(move |unit| unit.dimension == self))
    }

    /// Largest size [SI] that can belong to a bridge; anything beyond is a slip of the pen.
    pub fn most(self) -> f64 {
        self.facts().1
    }
}

/// A number with its unit, as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// The number before the unit.
    pub number: f64,
    /// The unit.
    pub unit: &'static Unit,
}

impl Quantity {
    /// The same in units of the metric system, where it is not: for messages that propose a number.
    pub fn metric(&self) -> Quantity {
        let unit =
            if self.unit.imperial() { self.unit.dimension.units().next().unwrap_or(self.unit) } else { self.unit };
        Quantity { number: self.si() / unit.size, unit }
    }

    /// The same as one of these dimensions: as it is, or a mass by its weight and a force by the mass that weighs it.
    pub fn of(self, wanted: &[Dimension]) -> Option<Quantity> {
        if wanted.contains(&self.unit.dimension) {
            return Some(self);
        }
        let unit = WEIGHTS.iter().find(|unit| unit.symbol == self.unit.symbol && wanted.contains(&unit.dimension))?;
        Some(Quantity { unit, ..self })
    }

    /// Value in SI.
    pub fn si(&self) -> f64 {
        self.number * self.unit.size
    }
}

/// Why a text is no quantity.
#[derive(Debug, Clone, PartialEq)]
pub enum Unreadable {
    /// It does not start with a number.
    NoNumber,
    /// A comma stands where a decimal point belongs; the number as it was probably meant.
    Comma(String),
    /// The number is too large for any machine.
    Infinite,
    /// There is a number but nothing after it.
    NoUnit(f64),
    /// The unit is not known: number, unit as written, nearest known unit.
    UnknownUnit(f64, String, Option<&'static Unit>),
}

/// A number in another unit of the same dimension.
pub fn convert(number: f64, from: &Unit, to: &Unit) -> Option<f64> {
    (from.dimension == to.dimension).then(|| number * from.size / to.size)
}

/// Reads "18.30 m".
///
/// # Errors
/// A text that does not start with a finite number, or goes on with no known unit.
pub fn parse(text: &str) -> Result<Quantity, Unreadable> {
    let text = text.trim();
    let (digits, rest) = text.split_at(number_length(text));
    let number: f64 = digits.parse().map_err(|_| Unreadable::NoNumber)?;
    if !number.is_finite() {
        return Err(Unreadable::Infinite);
    }
    let rest = rest.trim();
    if let Some(quantity) = feet_and_inches(number, rest) {
        return Ok(quantity);
    }
    if let Some(fraction) = rest.strip_prefix(',')
        && fraction.starts_with(|first: char| first.is_ascii_digit())
    {
        return Err(Unreadable::Comma(format!("{digits}.{fraction}")));
    }
    if rest.is_empty() {
        return Err(Unreadable::NoUnit(number));
    }
    match find_unit(rest) {
        Some(unit) => Ok(Quantity { number, unit }),
        None => Err(Unreadable::UnknownUnit(number, rest.chars().take(40).collect(), nearest_unit(rest))),
    }
}

/// "19 ft 8 in", "19' 8 1/2\"", "13 1/2 in": a length in parts, from its first number and what follows. It is given in inches.
fn feet_and_inches(first: f64, rest: &str) -> Option<Quantity> {
    let unit = UNITS.iter().find(|unit| unit.symbol == "in")?;
    let sign = if first.is_sign_negative() { -1.0 } else { 1.0 };
    let feet = ["feet", "foot", "ft.", "ft", "'", "′", "’"].into_iter().find_map(|word| rest.strip_prefix(word));
    let (feet, more, in_feet) = match feet {
        Some(more) if more.trim().is_empty() => return None,
        Some(more) => (12.0 * first, more.trim().trim_start_matches([',', '-']).trim(), true),
        None => (first, rest, false),
    };
    let ending = ["inches", "inch", "in.", "in", "\"", "″", "”"].into_iter().find_map(|word| more.strip_suffix(word));
    let parts: Vec<&str> = ending?.split_whitespace().collect();
    let plain = |text: &str| text.bytes().all(|c| c.is_ascii_digit() || c == b'.').then(|| text.parse::<f64>().ok())?;
    let fraction = |text: &str| {
        let (above, below) = text.split_once('/')?;
        Some(plain(above)? / plain(below)?).filter(|value| value.is_finite() && *value < 1.0)
    };
    let more = match parts[..] {
        [one] if in_feet => plain(one).or_else(|| fraction(one))?,
        [one, two] if in_feet => plain(one)? + fraction(two)?,
        [one] => fraction(one)?,
        _ => return None,
    };
    Some(Quantity { number: feet + sign * more, unit })
}

/// Bytes of the number that a text starts with: sign, digits, point, digits, exponent.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut end = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = digits(end);
    end += whole;
    let mut fraction = 0;
    if bytes.get(end) == Some(&b'.') {
        fraction = digits(end + 1);
        if whole + fraction > 0 {
            end += 1 + fraction;
        }
    }
    if whole + fraction == 0 {
        return 0;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits((end + 1 + sign).min(bytes.len()));
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    end
}

/// Units with their other spellings.
const SPELLINGS: &[(&str, &[&str])] = &[
    ("m", &["metre", "metres", "meter", "meters"]),
    ("mm", &["millimetres", "millimeters"]),
    ("deg", &["degree", "degrees", "deg."]),
    ("ft", &["feet", "foot", "ft.", "'", "′"]),
    ("in", &["inches", "inch", "in.", "\"", "″"]),
    ("kip", &["kips"]),
    ("lb", &["lbs"]),
    ("t", &["te"]),
    ("tonne", &["tonnes"]),
    ("t/m^3", &["te/m^3", "te/m3"]),
    ("t/m", &["te/m"]),
    ("kip/ft", &["kips/ft", "klf"]),
    ("lbf/ft", &["plf"]),
    ("lb/ft^3", &["lb/cuft", "lbs/ft^3", "lbs/ft3"]),
    ("psi", &["lb/in^2", "lb/in2"]),
    ("microstrain", &["microstrains", "µε", "με", "µstrain", "ustrain"]),
    ("µm/m", &["μm/m", "um/m"]),
    ("psf", &["lb/ft^2", "lb/ft2"]),
];

/// One spelling for what keyboards and word processors write differently.
fn plain(symbol: &str) -> String {
    let mut out = symbol.replace('²', "^2").replace('³', "^3").replace([' ', '\u{a0}', '\u{202f}'], "");
    if let Some((unit, _)) = SPELLINGS.iter().find(|(_, others)| others.contains(&out.as_str())) {
        return (*unit).to_owned();
    }
    if ["m2", "m3", "s2", "ft2", "ft3", "in2", "in3"].iter().any(|power| out.ends_with(power)) {
        out.insert(out.len() - 1, '^');
    }
    out
}

fn find_unit(symbol: &str) -> Option<&'static Unit> {
    let symbol = plain(symbol);
    UNITS.iter().find(|unit| plain(unit.symbol) == symbol)
}

/// The known unit that differs only in capitals, or else by one letter.
fn nearest_unit(symbol: &str) -> Option<&'static Unit> {
    let symbol = plain(symbol);
    if symbol.len() > 40 {
        return None;
    }
    let by_case = UNITS.iter().find(|unit| unit.symbol.eq_ignore_ascii_case(&symbol));
    by_case.or_else(|| {
        UNITS
            .iter()
            .map(|unit| (strsim::osa_distance(unit.symbol, &symbol), unit))
            .filter(|(distance, unit)| *distance == 1 && unit.symbol.chars().count() > 2)
            .min_by_key(|(distance, _)| *distance)
            .map(|(_, unit)| unit)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_become_si() {
        let cases = [
            ("18.30 m", Dimension::Length, 18.3),
            ("711mm", Dimension::Length, 0.711),
            ("15 GPa", Dimension::Stress, 15e9),
            ("2100 kg/m3", Dimension::Density, 2100.0),
            ("2.1 t/m³", Dimension::Density, 2100.0),
            ("4.84 GPa/m", Dimension::JointStiffness, 4.84e9),
            ("4.84 N/mm^3", Dimension::JointStiffness, 4.84e9),
            ("1e2 kN", Dimension::Force, 1e5),
            ("-1.5E-1 kN/m", Dimension::LineLoad, -150.0),
            ("180 deg", Dimension::Angle, std::f64::consts::PI),
            (".5 in", Dimension::Length, 0.0127),
            ("500 psi", Dimension::Stress, 500.0 * 4.448_221_615_260_5 / 0.000_645_16),
            ("2 ksi", Dimension::Stress, 2000.0 * 4.448_221_615_260_5 / 0.000_645_16),
            ("140 lb/ft^3", Dimension::Density, 140.0 * 0.453_592_37 / 0.028_316_846_592),
            ("140 pcf", Dimension::Density, 140.0 * 0.453_592_37 / 0.028_316_846_592),
            ("22 kips", Dimension::Force, 22.0 * 4_448.221_615_260_5),
            ("1 tonf", Dimension::Force, 9_964.016_418_183_52),
            ("100 lbf/ft", Dimension::LineLoad, 444.822_161_526_05 / 0.3048),
            ("19 ft 8 in", Dimension::Length, 5.9944),
            ("19' 8\"", Dimension::Length, 5.9944),
            ("19 ft", Dimension::Length, 5.7912),
            ("19 ft 8 1/2 in", Dimension::Length, 6.0071),
            ("13 1/2 in", Dimension::Length, 0.3429),
            ("22 kN/m3", Dimension::Density, 22e3 / 9.81),
            ("22 kN/m³", Dimension::Density, 22e3 / 9.81),
            ("22 kN/m^3", Dimension::Density, 22e3 / 9.81),
            ("140 lbf/ft^3", Dimension::Density, 140.0 * 4.448_221_615_260_5 / 9.81 / 0.028_316_846_592),
            ("8 t/m", Dimension::LineLoad, 8e3 * 9.81),
            ("1.5 t/m2", Dimension::Stress, 1.5e3 * 9.81),
            ("40 mph", Dimension::Speed, 17.8816),
        ];
        for (text, dimension, value) in cases {
            let quantity = parse(text).unwrap_or_else(|reason| panic!("{text}: {reason:?}"));
            assert_eq!(quantity.unit.dimension, dimension, "{text}");
            // A few roundings of products.
            assert!((quantity.si() - value).abs() <= 4.0 * value.abs() * f64::EPSILON, "{text}: {}", quantity.si());
        }
    }

    #[test]
    fn masses_weigh_and_forces_are_weighed() {
        let of = |text: &str, dimension| parse(text).unwrap().of(&[dimension]).map(|found| found.si());
        let close = |a: Option<f64>, b: f64| (a.unwrap() / b - 1.0).abs() < 1e-12;
        for text in ["11.5 t", "11.5 te", "11.5 tonnes", "11500 kg"] {
            assert!(
                close(of(text, Dimension::Force), 11.5e3 * 9.81) && close(of(text, Dimension::Mass), 11.5e3),
                "{text}"
            );
        }
        assert!(close(of("2000 lb", Dimension::Force), 2e3 * 4.448_221_615_260_5));
        assert!(close(of("98.1 kN", Dimension::Mass), 10e3) && close(of("98.1 kN", Dimension::Force), 98.1e3));
        assert_eq!([of("1 t", Dimension::Length), of("1 kN", Dimension::Stress)], [None, None]);
    }

    #[test]
    fn what_is_no_quantity_says_why() {
        assert_eq!(parse("wide"), Err(Unreadable::NoNumber));
        assert_eq!(parse(""), Err(Unreadable::NoNumber));
        assert_eq!(parse("nan m"), Err(Unreadable::NoNumber));
        assert_eq!(parse("inf m"), Err(Unreadable::NoNumber));
        assert_eq!(parse("18,30 m"), Err(Unreadable::Comma("18.30 m".into())));
        assert_eq!(parse("1e999 m"), Err(Unreadable::Infinite));
        assert_eq!(parse("18.30"), Err(Unreadable::NoUnit(18.3)));
        let Err(Unreadable::UnknownUnit(_, _, Some(near))) = parse("15 gpa") else { panic!() };
        assert_eq!(near.symbol, "GPa");
        let Err(Unreadable::UnknownUnit(_, _, none)) = parse("3 furlongs") else { panic!() };
        assert_eq!(none, None);
    }

    #[test]
    fn no_symbol_is_taken_twice() {
        for (index, unit) in UNITS.iter().enumerate() {
            assert!(UNITS[..index].iter().all(|other| other.symbol != unit.symbol), "{}", unit.symbol);
            assert!(unit.size > 0.0);
        }
    }
}
