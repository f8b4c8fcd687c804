//! Arch ring profiles: the intrados curve of a span.
//!
//! The origin is the left springing of the span; x runs to the right springing, y up from the springing level.
//! Span and rise are intrados dimensions. Stations are shares of the curve's length, from the left springing.

mod arcs;
mod ellipse;
mod invert;
mod measured;
mod parabola;

use arcs::Arcs;
use ellipse::Ellipse;
use measured::Measured;
use parabola::Parabola;

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
    /// Surveyed intrados points from the left to the right springing, relative to the left springing [m]. The
    /// intrados is a smooth curve through them: between two points a cubic whose tangent at each point is that of
    /// the circle through the point and its two neighbours.
    Measured(Vec<[f64; 2]>),
}

/// Why a profile has no curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Misfit {
    /// A length is not positive and finite.
    NotPositive,
    /// A segment's rise is more than half its span.
    RiseAboveHalfSpan,
    /// A semicircle's rise is not half its span.
    NotHalfSpan,
    /// A three-centred rise is more than half the span.
    ThreeCentredTooHigh,
    /// Haunch circles with a radius of the rise or more leave no circle for the crown.
    HaunchRadiusTooLarge,
    /// A pointed arch whose rise is half the span or less has no point.
    NoPoint,
    /// A measured curve needs three points at least.
    TooFewPoints,
    /// Measured points do not run from left to right; index of the first that does not.
    NotLeftToRight(usize),
    /// The two ends of a measured curve are not level.
    NotLevel,
    /// A measured point between the springings lies at or below them; its index.
    BelowSpringing(usize),
    /// Neighbouring measured points nearly coincide, or the curve turns back between them; index of the second.
    Folded(usize),
}

/// A place on the intrados.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// The point [m].
    pub point: [f64; 2],
    /// Unit normal, outwards to the extrados. At the point of a pointed crown: the bisector, straight up.
    pub normal: [f64; 2],
}

impl Station {
    /// Unit tangent, towards the right springing.
    pub fn tangent(&self) -> [f64; 2] {
        [self.normal[1], -self.normal[0]]
    }

    /// The point this far outwards along the normal [m].
    pub fn offset(&self, distance: f64) -> [f64; 2] {
        [self.point[0] + distance * self.normal[0], self.point[1] + distance * self.normal[1]]
    }
}

impl Profile {
    /// Whether there is such a curve with this span and rise [m].
    pub fn check(&self, span: f64, rise: f64) -> Result<(), Misfit> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        if let Profile::Measured(points) = self {
            return measured::check(points);
        }
        if !positive(span) || !positive(rise) {
            return Err(Misfit::NotPositive);
        }
        let half = 0.5 * span;
        match self {
            Profile::Segmental if rise > half => Err(Misfit::RiseAboveHalfSpan),
            // Half a span that is written in another unit differs by rounding.
            Profile::Semicircular if (rise - half).abs() > 1e-9 * half => Err(Misfit::NotHalfSpan),
            Profile::ThreeCentred { haunch_radius } if !positive(*haunch_radius) => Err(Misfit::NotPositive),
            Profile::ThreeCentred { .. } if rise > half => Err(Misfit::ThreeCentredTooHigh),
            Profile::ThreeCentred { haunch_radius } if *haunch_radius >= rise => Err(Misfit::HaunchRadiusTooLarge),
            Profile::Pointed if rise <= half => Err(Misfit::NoPoint),
            _ => Ok(()),
        }
    }
}

/// The intrados of a span, measured by its arc length.
#[derive(Debug, Clone, PartialEq)]
pub struct Intrados {
    curve: Curve,
    span: f64,
    length: f64,
}

/// Symmetric curves are known by their left half, by distance from the springing; a survey as a whole.
#[derive(Debug, Clone, PartialEq)]
enum Curve {
    Arcs(Arcs),
    Parabola(Parabola),
    Ellipse(Ellipse),
    Measured(Measured),
}

impl Intrados {
    /// The curve of a profile with this span and rise [m]; a measured profile has its own.
    pub fn new(profile: &Profile, span: f64, rise: f64) -> Result<Intrados, Misfit> {
        profile.check(span, rise)?;
        let curve = match profile {
            Profile::Segmental => Curve::Arcs(Arcs::segment(span, rise)),
            Profile::Semicircular => Curve::Arcs(Arcs::segment(span, 0.5 * span)),
            Profile::ThreeCentred { haunch_radius } => Curve::Arcs(Arcs::three_centred(span, rise, *haunch_radius)),
            Profile::Pointed => Curve::Arcs(Arcs::pointed(span, rise)),
            Profile::Parabolic => Curve::Parabola(Parabola::new(span, rise)),
            Profile::Elliptical => Curve::Ellipse(Ellipse::new(span, rise)),
            Profile::Measured(points) => Curve::Measured(Measured::new(points)?),
        };
        let length = match &curve {
            Curve::Arcs(arcs) => 2.0 * arcs.length(),
            Curve::Parabola(parabola) => 2.0 * parabola.length(),
            Curve::Ellipse(ellipse) => 2.0 * ellipse.length(),
            Curve::Measured(measured) => measured.length(),
        };
        let span = if let Profile::Measured(points) = profile { points[points.len() - 1][0] } else { span };
        Ok(Intrados { curve, span, length })
    }

    /// Length of the curve from springing to springing [m].
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The station at this share of the length, from the left springing (0) to the right (1); shares beyond are cut.
    pub fn at(&self, share: f64) -> Station {
        let share = share.clamp(0.0, 1.0);
        if let Curve::Measured(measured) = &self.curve {
            return measured.at(share * self.length);
        }
        // Symmetric to the last bit: the right half mirrors the left.
        let from_springing = share.min(1.0 - share) * self.length;
        let left = match &self.curve {
            Curve::Arcs(arcs) => arcs.at(from_springing),
            Curve::Parabola(parabola) => parabola.at(from_springing),
            Curve::Ellipse(ellipse) => ellipse.at(from_springing),
            Curve::Measured(measured) => measured.at(from_springing),
        };
        if share == 0.5 {
            return Station { point: [0.5 * self.span, left.point[1]], normal: [0.0, 1.0] };
        }
        if share < 0.5 {
            return left;
        }
        Station { point: [self.span - left.point[0], left.point[1]], normal: [-left.normal[0], left.normal[1]] }
    }
}

#[cfg(test)]
mod tests;
