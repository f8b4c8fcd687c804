//! Intrados made of circular arcs: segmental, semicircular, three-centred, pointed. The left half only.

use super::{Curve, Station};

/// A circular arc, run through clockwise. Angles are measured from the vertical, to the right positive [rad].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arc {
    centre: [f64; 2],
    radius: f64,
    start: f64,
    end: f64,
}

impl Arc {
    fn length(&self) -> f64 {
        self.radius * (self.end - self.start)
    }
}

/// Arcs from the left springing to the crown, one behind the other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Arcs {
    pub(super) arcs: Vec<Arc>,
    /// Radius of the circle that both halves lie on [m], where they do.
    pub(super) circle: Option<f64>,
}

impl Arcs {
    /// A segment of a circle: radius (half span² + rise²) / (2 rise).
    pub(super) fn segment(span: f64, rise: f64) -> Arcs {
        let half = 0.5 * span;
        let radius = (half * half + rise * rise) / (2.0 * rise);
        let half_angle = 2.0 * (rise / half).atan();
        Arcs {
            arcs: vec![Arc { centre: [half, rise - radius], radius, start: -half_angle, end: 0.0 }],
            circle: Some(radius),
        }
    }

    /// Haunch circles that rise vertically from the springings and touch the crown circle from inside.
    pub(super) fn three_centred(span: f64, rise: f64, haunch_radius: f64) -> Arcs {
        let half = 0.5 * span;
        let reach = half - haunch_radius;
        let crown_radius =
            (reach * reach + rise * rise - haunch_radius * haunch_radius) / (2.0 * (rise - haunch_radius));
        let junction = -reach.atan2(crown_radius - rise);
        let haunch = Arc {
            centre: [haunch_radius, 0.0],
            radius: haunch_radius,
            start: -std::f64::consts::FRAC_PI_2,
            end: junction,
        };
        let crown = Arc { centre: [half, rise - crown_radius], radius: crown_radius, start: junction, end: 0.0 };
        Arcs { arcs: vec![haunch, crown], circle: None }
    }

    /// Two arcs with centres on the springing line: radius (half span² + rise²) / span.
    pub(super) fn pointed(span: f64, rise: f64) -> Arcs {
        let half = 0.5 * span;
        let radius = (half * half + rise * rise) / span;
        let crown = -(radius - half).atan2(rise);
        let left = Arc { centre: [radius, 0.0], radius, start: -std::f64::consts::FRAC_PI_2, end: crown };
        Arcs { arcs: vec![left], circle: None }
    }
}

impl Curve for Arcs {
    fn length(&self) -> f64 {
        self.arcs.iter().map(Arc::length).sum()
    }

    fn at(&self, distance: f64) -> Station {
        let mut rest = distance;
        let last = self.arcs.len() - 1;
        for (index, arc) in self.arcs.iter().enumerate() {
            let length = arc.length();
            if rest <= length || index == last {
                let angle = (arc.start + rest / arc.radius).min(arc.end);
                let (sine, cosine) = angle.sin_cos();
                let point = [arc.centre[0] + arc.radius * sine, arc.centre[1] + arc.radius * cosine];
                // The springing is where the file puts it, to the last bit.
                let point = if distance == 0.0 { [0.0, 0.0] } else { point };
                return Station { point, normal: [sine, cosine] };
            }
            rest -= length;
        }
        Station { point: [0.0, 0.0], normal: [0.0, 1.0] }
    }
    fn circle(&self) -> Option<f64> {
        self.circle
    }
}
