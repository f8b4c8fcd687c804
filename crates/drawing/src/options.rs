//! How a drawing is to be read.

/// What to do with an outline that is not convex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Concave {
    /// It is an error.
    Refuse,
    /// It is cut into convex pieces.
    Cut,
}

/// How a drawing is to be read.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Metres in one unit of the drawing, in place of what its header says.
    pub unit: Option<f64>,
    /// How far a chord may lie from its curve [m].
    pub chord_tolerance: f64,
    /// How far apart ends may lie that are meant to meet [m].
    pub gap_tolerance: f64,
    /// What to do with an outline that is not convex.
    pub concave: Concave,
    /// Layers that are passed over, whatever is on them.
    pub ignored: Vec<String>,
}

impl Default for Options {
    /// A millimetre is what a survey of masonry resolves, for curves and for gaps.
    fn default() -> Options {
        Options {
            unit: None,
            chord_tolerance: 1e-3,
            gap_tolerance: 1e-3,
            concave: Concave::Refuse,
            ignored: Vec::new(),
        }
    }
}

/// Whether a layer is passed over. Names of layers do not tell capitals apart.
pub(crate) fn is_ignored(options: &Options, layer: &str) -> bool {
    options.ignored.iter().any(|name| name.to_uppercase() == layer.to_uppercase())
}
