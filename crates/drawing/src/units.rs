//! Units of drawings: the number of the header variable `$INSUNITS`, and the size in metres.

/// A unit that a drawing may be drawn in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unit {
    /// Value of `$INSUNITS`.
    pub(crate) number: i16,
    /// Symbol.
    pub(crate) symbol: &'static str,
    /// Metres in one unit.
    pub(crate) metres: f64,
}

const fn unit(number: i16, symbol: &'static str, metres: f64) -> Unit {
    Unit { number, symbol, metres }
}

/// Units that bridges are drawn in; Autodesk, DXF Reference, header variable $INSUNITS.
pub(crate) const UNITS: &[Unit] = &[
    unit(1, "in", 0.0254),
    unit(2, "ft", 0.3048),
    unit(4, "mm", 1e-3),
    unit(5, "cm", 1e-2),
    unit(6, "m", 1.0),
    unit(7, "km", 1e3),
    unit(10, "yd", 0.9144),
    unit(14, "dm", 0.1),
    // 1200/3937 m: NIST Special Publication 447.
    unit(21, "US survey ft", 1200.0 / 3937.0),
];

/// What the header of a drawing says of units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Header {
    /// `$INSUNITS`, the unit of the drawing.
    pub(crate) unit: Option<i16>,
    /// `$MEASUREMENT`, which patterns and line types are used: 0 English, 1 metric.
    pub(crate) measurement: Option<i16>,
    /// `$LUNITS`, how lengths are shown: 3 and 4 in feet and inches, of drawings in inches.
    pub(crate) format: Option<i16>,
}

impl Header {
    /// What contradicts the unit that the header names.
    pub(crate) fn contradiction(&self) -> Option<&'static str> {
        let unit = self.unit.and_then(numbered)?;
        let is_metric = !matches!(unit.symbol, "in" | "ft" | "yd" | "US survey ft");
        match (self.measurement, self.format) {
            (Some(1), _) if !is_metric => Some("$MEASUREMENT metric"),
            (Some(0), _) if is_metric => Some("$MEASUREMENT English"),
            (_, Some(3 | 4)) if unit.symbol != "in" => Some("$LUNITS feet and inches"),
            _ => None,
        }
    }
}

/// The unit of a header's number.
pub(crate) fn numbered(number: i16) -> Option<&'static Unit> {
    UNITS.iter().find(|unit| unit.number == number)
}
