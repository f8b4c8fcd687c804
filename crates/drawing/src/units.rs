//! Units of drawings: the number of the header variable `$INSUNITS`, and the size in metres.

/// Units that bridges are drawn in: value of `$INSUNITS`, symbol, metres in one; Autodesk, DXF Reference, header variable $INSUNITS.
const UNITS: [(i16, &str, f64); 9] = [
    (1, "in", 0.0254),
    (2, "ft", 0.3048),
    (4, "mm", 1e-3),
    (5, "cm", 1e-2),
    (6, "m", 1.0),
    (7, "km", 1e3),
    (10, "yd", 0.9144),
    (14, "dm", 0.1),
    // 1200/3937 m: NIST Special Publication 447.
    (21, "US survey ft", 1200.0 / 3937.0),
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
        let (symbol, _) = self.unit.and_then(numbered)?;
        let is_metric = !matches!(symbol, "in" | "ft" | "yd" | "US survey ft");
        match (self.measurement, self.format) {
            (Some(1), _) if !is_metric => Some("$MEASUREMENT metric"),
            (Some(0), _) if is_metric => Some("$MEASUREMENT English"),
            (_, Some(3 | 4)) if symbol != "in" => Some("$LUNITS feet and inches"),
            _ => None,
        }
    }
}

/// Units of length of LandXML, by their names there, and metres in one.
pub(crate) const LANDXML: [(&str, f64); 8] = [
    ("meter", 1.0),
    ("millimeter", 1e-3),
    ("centimeter", 1e-2),
    ("kilometer", 1e3),
    ("foot", 0.3048),
    ("USSurveyFoot", 1200.0 / 3937.0),
    ("inch", 0.0254),
    ("mile", 1609.344),
];

/// The unit of a header's number: its symbol, and metres in one.
pub(crate) fn numbered(number: i16) -> Option<(&'static str, f64)> {
    UNITS.into_iter().find(|unit| unit.0 == number).map(|(_, symbol, metres)| (symbol, metres))
}
