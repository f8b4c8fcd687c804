//! What a kept state belongs to: one number for a model, its loading, the program and the settings.

use super::model::Model;
use super::settings::{Damping, Program, Settings};
use crate::acting::Resultant;
use crate::blocks::Stiffness;
use crate::contact::ContactLength;
use crate::digest::Digest;
use crate::ids::{GroupId, Id};
use crate::plane::Vec2;

impl Digest {
    fn number(&mut self, x: f64) {
        self.word(x.to_bits());
    }
    fn vector(&mut self, v: Vec2) {
        self.number(v.x);
        self.number(v.y);
    }
    fn resultant(&mut self, r: &Resultant) {
        self.vector(r.force);
        self.number(r.cross);
        self.number(r.dot);
    }
    fn stiffness(&mut self, s: Stiffness) {
        let (kind, a, b) = match s {
            Stiffness::Given(k) => (0, k, 0.0),
            Stiffness::Series { joint, body } => (1, joint, body),
        };
        self.word(kind);
        self.number(a);
        self.number(b);
    }
}

/// Digest of all that a run depends on besides its state.
pub(super) fn fingerprint(model: &Model, program: &Program, settings: &Settings) -> u64 {
    let mut d = Digest::new();
    d.word(model.len() as u64);
    for (i, core) in model.cores.iter().enumerate() {
        d.word(core.len() as u64);
        core.vertices.iter().for_each(|&v| d.vector(v));
        d.number(core.radius);
        d.word(model.groups[i].index() as u64);
        d.vector(model.built[i]);
        model.mass[i].iter().chain(&model.inverse_mass[i]).chain(&model.movement[i]).for_each(|&x| d.number(x));
        d.resultant(&model.permanent[i]);
        d.resultant(&model.weight[i]);
        d.resultant(&model.variable[i]);
    }
    model.particles.words(&mut |word| d.word(word));
    let groups = model.laws.groups();
    for a in 0..groups {
        for b in 0..groups {
            let law = model.laws.between(GroupId::new(a), GroupId::new(b));
            d.stiffness(law.normal);
            d.stiffness(law.shear);
            for x in [law.friction, law.cohesion, law.tension, law.crushing, law.least_length] {
                d.number(x);
            }
            d.number(law.fixed_length.unwrap_or(-1.0));
        }
    }
    for x in [program.increment, program.limit, program.resolution.unwrap_or(-1.0)] {
        d.number(x);
    }
    d.word(program.watched.0.index() as u64);
    d.vector(program.watched.1);
    let (kind, share) = match settings.damping {
        Damping::Local(share) => (0, share),
        Damping::Viscous(share) => (1, share),
        Damping::Adaptive => (2, 0.0),
        Damping::None => (3, 0.0),
    };
    d.word(kind);
    d.number(share);
    d.word(match settings.contact_length {
        ContactLength::Fixed => 0,
        ContactLength::Updated => 1,
        ContactLength::Distributed => 2,
    });
    d.number(settings.tolerance);
    d.word(settings.step_limit);
    d.number(settings.time_step_factor);
    d.word(u64::from(settings.scaled_inertia));
    d.value()
}
