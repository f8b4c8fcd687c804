//! Intrados made of circular arcs: segmental, semicircular, three-centred, pointed. The left half only where both springings are level.

use super::{Curve, Form, Station};
use std::f64::consts::FRAC_PI_2;

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
    /// The right springing, where the arcs reach it [m].
    pub(super) end: Option<[f64; 2]>,
}

impl Arcs {
    /// One circle through both springings, `rise` above the middle of the line between them: its centre lies on the perpendicular there.
    pub(super) fn through(span: f64, rise: f64, right: f64) -> Arcs {
        let half_chord = 0.5 * span.hypot(right);
        let upright = 0.5 * span / half_chord;
        let off = (rise * rise - half_chord * half_chord) / (2.0 * rise * upright);
        let centre = [0.5 * span - off * 0.5 * right / half_chord, 0.5 * right + off * upright];
        Arcs::circle_to(span, right, centre, half_chord.hypot(off))
    }

    /// A circle that rises upright from the lower springing and is cut at the higher one.
    pub(super) fn cut_semicircle(span: f64, right: f64, radius: f64) -> Arcs {
        let centre = if right > 0.0 { [radius, 0.0] } else { [span - radius, right] };
        let mut arcs = Arcs::circle_to(span, right, centre, radius);
        // Upright to the last bit.
        if right > 0.0 {
            arcs.arcs[0].start = -FRAC_PI_2;
        } else {
            arcs.arcs[0].end = FRAC_PI_2;
        }
        arcs
    }

    /// The arc of a circle from the left springing to the right one.
    fn circle_to(span: f64, right: f64, centre: [f64; 2], radius: f64) -> Arcs {
        let angle = |x: f64, y: f64| (x - centre[0]).atan2(y - centre[1]);
        let arc = Arc { centre, radius, start: angle(0.0, 0.0), end: angle(span, right) };
        Arcs { arcs: vec![arc], circle: Some(radius), end: Some([span, right]) }
    }

    /// Haunch circles that rise upright from both springings, and a crown circle that touches both from inside and passes `rise` above
    /// the middle of the line between the springings; none where there is no such circle.
    pub(super) fn three_centred_sloping(span: f64, rise: f64, right: f64, haunch_radius: f64) -> Option<Arcs> {
        let h = haunch_radius;
        let [left_haunch, right_haunch] = [[h, 0.0], [span - h, right]];
        let apart = (span - 2.0 * h).hypot(right);
        let upright = (span - 2.0 * h) / apart;
        // The centre lies `s` below the middle of the line between the haunch centres, square to it: the crown radius is both the
        // distance to a haunch centre plus h and the distance to the point above the middle, which is quadratic in s.
        let (a, b) = (rise * rise - h * h - 0.25 * apart * apart, 2.0 * rise * upright);
        let (square, linear, constant) = (b * b - 4.0 * h * h, 2.0 * a * b, a * a - h * h * apart * apart);
        let root = (linear * linear - 4.0 * square * constant).sqrt();
        let crown = |s: f64| {
            let centre = [0.5 * span + s * right / apart, 0.5 * right - s * upright];
            let junction = |haunch: [f64; 2]| (haunch[0] - centre[0]).atan2(haunch[1] - centre[1]);
            let [from, to] = [left_haunch, right_haunch].map(junction);
            let inside = -FRAC_PI_2 < from && from < to && to < FRAC_PI_2;
            (s.is_finite() && a + b * s >= 0.0 && inside).then_some((s.hypot(0.5 * apart) + h, centre, from, to))
        };
        let both = [(root - linear) / (2.0 * square), -(root + linear) / (2.0 * square)];
        // Of two circles the flatter one is that of level springings.
        let (radius, centre, from, to) =
            both.into_iter().filter_map(crown).max_by(|one, other| one.0.total_cmp(&other.0))?;
        if !(h > 0.0 && span > 2.0 * h) {
            return None;
        }
        let arcs = vec![
            Arc { centre: left_haunch, radius: h, start: -FRAC_PI_2, end: from },
            Arc { centre, radius, start: from, end: to },
            Arc { centre: right_haunch, radius: h, start: to, end: FRAC_PI_2 },
        ];
        Some(Arcs { arcs, circle: None, end: Some([span, right]) })
    }

    /// Whether it turns back below a springing.
    pub(super) fn leans_back(&self) -> bool {
        let (first, last) = (&self.arcs[0], &self.arcs[self.arcs.len() - 1]);
        first.start < -FRAC_PI_2 * (1.0 + 1e-12) || last.end > FRAC_PI_2 * (1.0 + 1e-12)
    }

    /// As a curve from springing to springing.
    pub(super) fn whole(self) -> Form {
        let over = |arc: &&Arc| arc.start <= 0.0 && arc.end >= 0.0;
        let crown = self.arcs.iter().find(over).map_or(0.0, |arc| arc.centre[0]);
        Form::Whole { curve: std::sync::Arc::new(self), crown }
    }

    /// A segment of a circle: radius (half span² + rise²) / (2 rise).
    pub(super) fn segment(span: f64, rise: f64) -> Arcs {
        let half = 0.5 * span;
        let radius = (half * half + rise * rise) / (2.0 * rise);
        let half_angle = 2.0 * (rise / half).atan();
        Arcs {
            arcs: vec![Arc { centre: [half, rise - radius], radius, start: -half_angle, end: 0.0 }],
            circle: Some(radius),
            end: None,
        }
    }

    /// Haunch circles that rise vertically from the springings and touch the crown circle from inside.
    pub(super) fn three_centred(span: f64, rise: f64, haunch_radius: f64) -> Arcs {
        let half = 0.5 * span;
        let reach = half - haunch_radius;
        let crown_radius =
            (reach * reach + rise * rise - haunch_radius * haunch_radius) / (2.0 * (rise - haunch_radius));
        let junction = -reach.atan2(crown_radius - rise);
        let haunch = Arc { centre: [haunch_radius, 0.0], radius: haunch_radius, start: -FRAC_PI_2, end: junction };
        let crown = Arc { centre: [half, rise - crown_radius], radius: crown_radius, start: junction, end: 0.0 };
        Arcs { arcs: vec![haunch, crown], circle: None, end: None }
    }

    /// Two arcs with centres on the springing line: radius (half span² + rise²) / span.
    pub(super) fn pointed(span: f64, rise: f64) -> Arcs {
        let half = 0.5 * span;
        let radius = (half * half + rise * rise) / span;
        let crown = -(radius - half).atan2(rise);
        let left = Arc { centre: [radius, 0.0], radius, start: -FRAC_PI_2, end: crown };
        Arcs { arcs: vec![left], circle: None, end: None }
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
                let at_end = self.end.filter(|_| index == last && rest >= length);
                let point = at_end.unwrap_or(point);
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
