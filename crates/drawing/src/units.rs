//! Units of drawings: the number of the header variable `$INSUNITS`, and the size in metres.

/// A unit that a drawing may be drawn in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Value of `$INSUNITS`.
    pub number: i16,
    /// Symbol.
    pub symbol: &'static str,
    /// Metres in one unit.
    pub metres: f64,
}

const fn unit(number: i16, symbol: &'static str, metres: f64) -> Unit {
    Unit { number, symbol, metres }
}

/// Units that bridges are drawn in; Autodesk, DXF Reference, header variable $INSUNITS.
pub const UNITS: &[Unit] = &[
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

/// The unit of a header's number.
pub(crate) fn numbered(number: i16) -> Option<&'static Unit> {
    UNITS.iter().find(|unit| unit.number == number)
}
