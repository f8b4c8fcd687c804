//! What defects leave of a voussoir and of its joints.

use bridge::Span;
use bridge::defect::{Defect, DefectKind};
use mechanics::blocks::ContactLaw;

/// The defects of a span, by number, that a voussoir has.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct State {
    /// Those that part it from the ring above.
    separated: Vec<usize>,
    /// Those that make it and its joints weaker.
    weak: Vec<usize>,
    /// Whether it has fallen out.
    pub is_missing: bool,
}

impl State {
    /// That of a voussoir of a ring.
    pub(super) fn of(span: &Span, ring: usize, voussoir: usize) -> State {
        let count = span.rings[ring].voussoirs as f64;
        let own = [voussoir as f64 / count, (voussoir + 1) as f64 / count];
        let touched: Vec<(usize, &Defect)> = span.defects.iter().enumerate().filter(|(_, d)| d.touches(own)).collect();
        let all = |is_one: &dyn Fn(&Defect) -> bool| {
            touched.iter().filter(|(_, defect)| is_one(defect)).map(|(number, _)| *number).collect()
        };
        let is_missing = |defect: &Defect| {
            // Stones whose middle lies in the stretch, and in any case that in which its middle lies.
            let [from, to] = defect.shares;
            let (middle, half) = (0.5 * (own[0] + own[1]), 0.5 * (from + to));
            let inside = from <= middle && middle <= to || own[0] <= half && half < own[1];
            ring == 0 && matches!(defect.kind, DefectKind::MissingStones) && inside
        };
        State {
            separated: all(&|d| matches!(d.kind, DefectKind::RingSeparation { ring: lower, .. } if lower == ring)),
            weak: all(
                &|d| matches!(d.kind, DefectKind::WeakMasonry { ring: of, .. } if of.is_none_or(|of| of == ring)),
            ),
            is_missing: touched.iter().any(|(_, defect)| is_missing(defect)),
        }
    }

    /// What follows the name of its ring.
    pub(super) fn name(&self) -> &'static str {
        match (self.separated.is_empty(), self.weak.is_empty()) {
            (true, true) => "",
            (false, true) => ", separated",
            (true, false) => ", weak",
            (false, false) => ", separated and weak",
        }
    }

    /// The law of the joint to the ring above: where it is separated, nothing but friction.
    pub(super) fn separated(&self, span: &Span, law: ContactLaw) -> ContactLaw {
        self.separated.iter().fold(law, |law, &number| match span.defects[number].kind {
            DefectKind::RingSeparation { friction_angle, .. } => ContactLaw {
                cohesion: 0.0,
                tension: 0.0,
                friction: friction_angle.map_or(law.friction, |angle| law.friction.min(angle.tan())),
                ..law
            },
            _ => law,
        })
    }

    /// A law of its joints with no more than the strength that is left. Cohesion and tension fall in the same proportion: cohesion acts over
    /// the length that the strength leaves compressed, which would grow otherwise and make the joint stronger.
    pub(super) fn weakened(&self, span: &Span, law: ContactLaw) -> ContactLaw {
        self.weak.iter().fold(law, |law, &number| match span.defects[number].kind {
            DefectKind::WeakMasonry { compressive_strength, friction_angle, .. } => {
                let crushing = law.crushing.min(compressive_strength.unwrap_or(f64::INFINITY));
                let left = if crushing < law.crushing { crushing / law.crushing } else { 1.0 };
                ContactLaw {
                    crushing,
                    cohesion: left * law.cohesion,
                    tension: left * law.tension,
                    friction: friction_angle.map_or(law.friction, |angle| law.friction.min(angle.tan())),
                    ..law
                }
            }
            _ => law,
        })
    }
}
