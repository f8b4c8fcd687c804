//! One arrangement of a vehicle, in SI units.

/// An axle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axle {
    /// Force [N].
    pub force: f64,
    /// Distance behind the first axle [m].
    pub offset: f64,
}

/// A uniform load over a stretch that moves with the axles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Force along the bridge [N/m].
    pub force: f64,
    /// Where it begins, behind the first axle [m]; minus infinity where it has no beginning.
    pub from: f64,
    /// Where it ends [m]; infinite where it has no end.
    pub to: f64,
    /// Whether it may be left out where it helps.
    pub may_be_dropped: bool,
}

/// One arrangement of a vehicle: every axle at its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Pattern {
    /// What tells it from the other arrangements of its vehicle; empty where there is only one.
    pub label: String,
    /// From the first axle back.
    pub axles: Vec<Axle>,
    /// Uniform loads.
    pub stretches: Vec<Stretch>,
}

impl Pattern {
    /// Distance from the first to the last axle, or to the end of the last uniform load that has one [m].
    pub fn length(&self) -> f64 {
        let ends = self.stretches.iter().map(|stretch| stretch.to).filter(|to| to.is_finite());
        ends.fold(self.axles.last().map_or(0.0, |axle| axle.offset), f64::max)
    }

    /// Sum of the axle forces [N].
    pub fn force(&self) -> f64 {
        self.axles.iter().map(|axle| axle.force).sum()
    }

    /// The same driving the other way: the last axle first.
    pub fn reversed(&self) -> Pattern {
        let length = self.length();
        Pattern {
            label: self.label.clone(),
            axles: self.axles.iter().rev().map(|a| Axle { force: a.force, offset: length - a.offset }).collect(),
            stretches: self
                .stretches
                .iter()
                .rev()
                .map(|s| Stretch { from: length - s.to, to: length - s.from, ..*s })
                .collect(),
        }
    }

    /// Whether its loads are so many times those of another at the same places, to twelve digits.
    pub fn is_multiple(&self, of: &Pattern, times: f64) -> bool {
        let close = |a: f64, b: f64| (a - b * times).abs() <= 1e-12 * a.abs().max((b * times).abs());
        times.is_finite()
            && times > 0.0
            && self.label == of.label
            && (self.axles.len(), self.stretches.len()) == (of.axles.len(), of.stretches.len())
            && self.axles.iter().zip(&of.axles).all(|(a, b)| a.offset == b.offset && close(a.force, b.force))
            && self
                .stretches
                .iter()
                .zip(&of.stretches)
                .all(|(a, b)| Stretch { force: b.force, ..*a } == *b && close(a.force, b.force))
    }

    /// Whether it is the same driving the other way, to a millimetre and a newton.
    pub fn is_symmetric(&self) -> bool {
        let other = self.reversed();
        let close = |a: f64, b: f64, by: f64| a == b || (a - b).abs() <= by;
        self.axles
            .iter()
            .zip(&other.axles)
            .all(|(a, b)| close(a.force, b.force, 1.0) && close(a.offset, b.offset, 1e-3))
            && self
                .stretches
                .iter()
                .zip(&other.stretches)
                .all(|(a, b)| close(a.force, b.force, 1.0) && close(a.from, b.from, 1e-3) && close(a.to, b.to, 1e-3))
    }
}
