//! Arch ring profiles: the intrados curve of a span.

/// Shape of an intrados.
#[derive(Debug, Clone, PartialEq)]
pub enum Profile {
    /// Circular segment from span and rise.
    Segmental,
    /// Half circle; the rise is half the span.
    Semicircular,
    /// Parabola through springings and crown.
    Parabolic,
    /// Half ellipse.
    Elliptical,
    /// Two small circles at the haunches, one large at the crown [m].
    ThreeCentred {
        /// Radius of the haunch circles [m].
        haunch_radius: f64,
    },
    /// Two circular arcs that meet at a point in the crown.
    Pointed,
    /// Surveyed intrados points from the left to the right springing, relative to the left springing [m].
    Measured(Vec<[f64; 2]>),
}
