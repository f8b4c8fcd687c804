//! Arch ring profiles: the intrados curve of a span.
//!
//! The origin is the left springing of the span; x runs to the right springing, y up from the springing level.
//! Span and rise are intrados dimensions. Stations are shares of the curve's length, from the left springing.
//!
//! A profile is a file of this folder and a line of the list below. Its file says which of `span` and `rise` a file gives for it
//! (`NEEDS`), the cards of keys that belong to it alone (`KEYS`), how its span and rise follow from what is written (`size`), and its
//! curve, or why there is none (`curve`).

mod arcs;
mod ellipse;
mod invert;
mod measured;
mod parabola;
mod pointed;
mod quadrature;
mod segmental;
mod semicircular;
mod skew;
mod three_centred;

use std::fmt;
use std::sync::Arc;

use crate::card::Field;
use crate::choice::choice;
use crate::findings::Findings;
use crate::tree::Table;

/// The list of profiles: what the reference says of each, its word, its file, and keys of its own with the values they leave.
macro_rules! profiles {
    ($($(#[doc = $doc:literal])+ $name:ident $({ $(#[$meta:meta])* $key:ident: $type:ty })? = $word:literal in $file:ident,)+) => {
        choice! {
            /// Words of the profiles.
            pub(crate) enum Shape { $($(#[doc = $doc])+ $name = $word,)+ }
        }

        /// Shape of an intrados.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Profile { $($(#[doc = $doc])+ $name $({ $(#[$meta])* $key: $type })?,)+ }

        /// Whether files give span and rise.
        const NEEDS: &[(&str, [bool; 2])] = &[$(($word, $file::NEEDS)),+];

        /// Cards of the keys that belong to one profile.
        pub(crate) const OWN_KEYS: &[&[Field]] = &[$($file::KEYS),+];

        impl Profile {
            /// The word in bridge files.
            pub fn word(&self) -> &'static str {
                match self { $(Profile::$name { .. } => $word),+ }
            }

            /// Whether its rise is a length of its own; else it follows from the span or from points.
            pub fn has_rise(&self) -> bool {
                self.needs()[1]
            }

            /// Whether span and rise are lengths of their own.
            fn needs(&self) -> [bool; 2] {
                match self { $(Profile::$name { .. } => $file::NEEDS),+ }
            }

            /// The curve between level springings.
            fn form(&self, span: f64, rise: f64) -> Result<Form, Misfit> {
                match self { $(Profile::$name $({ $key })? => $file::curve(span, rise $(, $key)?)),+ }
            }

            /// The curve to a right springing that lies this much higher than the left one [m].
            fn sloping(&self, span: f64, rise: f64, right: f64) -> Result<Form, Misfit> {
                match self { $(Profile::$name $({ $key })? => $file::sloping(span, rise, right $(, $key)?)),+ }
            }
        }

        /// The profile of a span's table along the road, with its size; what is wrong has been reported.
        pub(crate) fn read(table: &Table<'_>, findings: &mut Findings) -> Option<(Profile, Size)> {
            let shape: Option<Shape> = table.read("profile", findings);
            let (span, stretch) = skew::span(table, shape, findings).unzip();
            let span = span.flatten();
            let rise = table.read::<Option<f64>>("rise", findings).flatten();
            let right: Option<f64> = table.read("right_springing", findings);
            let (profile, span, rise) = match shape? {
                $(Shape::$name => {
                    $(let mut $key: $type = table.read(stringify!($key), findings)?;)?
                    let (span, rise) = $file::size(span, rise $(, &mut $key)?)?;
                    (Profile::$name $({ $key })?, span, rise)
                })+
            };
            let size = sized(&profile, span, rise, right?);
            match stretch? {
                None => Some((profile, size)),
                Some(stretch) => skew::along_the_road(table, &profile, size, stretch, findings),
            }
        }
    };
}

profiles! {
    /// one circular arc, rise at most half the span
    Segmental = "segmental" in segmental,
    /// half a circle, rise half the span
    Semicircular = "semicircular" in semicircular,
    /// a parabola with its vertex in the crown
    Parabolic = "parabolic" in parabola,
    /// half an ellipse, vertical at the springings
    Elliptical = "elliptical" in ellipse,
    /// two small circles at the haunches, a large one at the crown
    ThreeCentred {
        /// Radius of the haunch circles [m].
        haunch_radius: f64
    } = "three-centred" in three_centred,
    /// two circular arcs centred on the springing line that meet in the crown
    Pointed = "pointed" in pointed,
    /// a smooth curve through surveyed points
    Measured {
        /// From the left to the right springing, relative to the left springing [m].
        points: Vec<[f64; 2]>
    } = "measured" in measured,
}

/// Span, rise and level of the right springing [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Size {
    pub(crate) span: f64,
    pub(crate) rise: f64,
    /// Above the left springing.
    pub(crate) right: f64,
}

/// The size of a profile: that of a survey is what its points make it, and the rise of a semicircle follows from its span.
fn sized(profile: &Profile, span: f64, rise: f64, right: f64) -> Size {
    match profile {
        Profile::Measured { points } => Size { span, rise, right: points.last().map_or(0.0, |last| last[1]) },
        Profile::Semicircular if right != 0.0 => Size { span, rise: semicircular::sloping_rise(span, right), right },
        _ => Size { span, rise, right },
    }
}

/// Words of the profiles for which files give a span, and a rise.
pub(crate) const WITH_SPAN: [&str; with(0)] = words_with(0);
pub(crate) const WITH_RISE: [&str; with(1)] = words_with(1);

const fn with(size: usize) -> usize {
    let (mut count, mut k) = (0, 0);
    while k < NEEDS.len() {
        count += NEEDS[k].1[size] as usize;
        k += 1;
    }
    count
}

const fn words_with<const N: usize>(size: usize) -> [&'static str; N] {
    let (mut words, mut count, mut k) = ([""; N], 0, 0);
    while k < NEEDS.len() {
        if NEEDS[k].1[size] {
            words[count] = NEEDS[k].0;
            count += 1;
        }
        k += 1;
    }
    words
}

/// Why a profile has no curve: a finding of the file, but for its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Misfit {
    /// Its code.
    pub code: &'static str,
    /// The key that is wrong.
    pub key: &'static str,
    /// Which entry of its list, from 0, where it is one of them.
    pub entry: Option<usize>,
    /// What is wrong.
    pub message: Box<str>,
    /// Words under the caret.
    pub label: Box<str>,
    /// What to do.
    pub help: &'static str,
}

impl Misfit {
    fn new(
        code: &'static str,
        key: &'static str,
        message: impl Into<Box<str>>,
        label: impl Into<Box<str>>,
        help: &'static str,
    ) -> Misfit {
        Misfit { code, key, entry: None, message: message.into(), label: label.into(), help }
    }
}

impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
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

/// A curve by the distance from its left springing.
trait Curve: fmt::Debug + Send + Sync {
    /// Its length [m].
    fn length(&self) -> f64;

    /// The station at a distance [m].
    fn at(&self, distance: f64) -> Station;

    /// Radius of the circle that the whole intrados lies on [m], where it does.
    fn circle(&self) -> Option<f64> {
        None
    }
}

/// Symmetric curves are known by their left half, others as a whole, with the place of their crown [m].
#[derive(Debug, Clone)]
enum Form {
    Half(Arc<dyn Curve>),
    Whole { curve: Arc<dyn Curve>, crown: f64 },
}

impl Form {
    fn half(curve: impl Curve + 'static) -> Result<Form, Misfit> {
        Ok(Form::Half(Arc::new(curve)))
    }
}

/// The intrados of a span, measured by its arc length.
#[derive(Debug, Clone)]
pub struct Intrados {
    form: Form,
    span: f64,
    length: f64,
}

impl Intrados {
    /// The curve of a profile with this span and rise to a right springing that lies `right` above the left one [m]. The rise is that of
    /// the middle of the span above the straight line between the springings, measured upright; points of a survey have theirs.
    ///
    /// # Errors
    /// A profile that has no curve of this size, or springings that differ by more than the span.
    pub fn between(profile: &Profile, span: f64, rise: f64, right: f64) -> Result<Intrados, Misfit> {
        // Those of a survey are what its points make them.
        if profile.needs()[0] && ![span, rise].iter().all(|length| *length > 0.0 && length.is_finite()) {
            let help = "give positive lengths";
            return Err(Misfit::new("B204", "span", "span and rise must be positive", "not a shape", help));
        }
        if !(right.abs() <= span) && profile.needs()[0] {
            return Err(Misfit::new(
                "B229",
                "right_springing",
                "the springings differ by more than the span",
                format!("steeper than 45 degrees over a span of {span} m"),
                "check number and unit: the level of the right springing above the left one",
            ));
        }
        let form = if right == 0.0 { profile.form(span, rise)? } else { profile.sloping(span, rise, right)? };
        let length = match &form {
            Form::Half(curve) => 2.0 * curve.length(),
            Form::Whole { curve, .. } => curve.length(),
        };
        let intrados = Intrados { form, span, length };
        if right != 0.0 {
            intrados.rises_from_both(profile)?;
        }
        Ok(intrados)
    }

    /// Skewbacks lean away from the span, or stand upright: a ring that falls from a springing has no abutment there that it could push.
    fn rises_from_both(&self, profile: &Profile) -> Result<(), Misfit> {
        let leans = [-self.at(0.0).normal[0], self.at(1.0).normal[0]];
        let Some(side) = leans.iter().position(|lean| *lean < -1e-9) else { return Ok(()) };
        let key = if profile.needs()[0] { "right_springing" } else { "points" };
        Err(Misfit::new(
            "B229",
            key,
            format!("the intrados falls from its {} springing", ["left", "right"][side]),
            "its highest point is that springing",
            "give more rise or less difference of the springings; a strut or a ramp that falls from one end is described by its blocks",
        ))
    }

    /// Level of its highest point above the left springing [m].
    pub fn highest(&self) -> f64 {
        match &self.form {
            Form::Half(_) => self.at(0.5).point[1],
            Form::Whole { crown, .. } => self.level(*crown),
        }
    }

    /// Its level at a distance from the left springing [m], above it.
    pub fn level(&self, x: f64) -> f64 {
        // The curve is told by its length; x grows with it.
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.at(middle).point[0] < x { low = middle } else { high = middle }
        }
        self.at(0.5 * (low + high)).point[1]
    }

    /// Length of the curve from springing to springing [m].
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Distance of the crown from the left springing [m].
    pub fn crown(&self) -> f64 {
        match self.form {
            Form::Half(_) => 0.5 * self.span,
            Form::Whole { crown, .. } => crown,
        }
    }

    /// Radius of the circle that all of it lies on [m], where it does.
    pub fn circle(&self) -> Option<f64> {
        let (Form::Half(curve) | Form::Whole { curve, .. }) = &self.form;
        curve.circle()
    }

    /// The station at this share of the length, from the left springing (0) to the right (1); shares beyond are cut.
    pub fn at(&self, share: f64) -> Station {
        let share = share.clamp(0.0, 1.0);
        let half = match &self.form {
            Form::Half(half) => half,
            Form::Whole { curve, .. } => return curve.at(share * self.length),
        };
        // Symmetric to the last bit: the right half mirrors the left.
        let left = half.at(share.min(1.0 - share) * self.length);
        if share == 0.5 {
            return Station { point: [0.5 * self.span, left.point[1]], normal: [0.0, 1.0] };
        }
        if share < 0.5 {
            return left;
        }
        Station { point: [self.span - left.point[0], left.point[1]], normal: [-left.normal[0], left.normal[1]] }
    }
}

/// The size of most profiles: as written.
fn as_written(span: Option<f64>, rise: Option<f64>) -> Option<(f64, f64)> {
    span.zip(rise)
}

#[cfg(test)]
mod tests;
