//! A rule of assessment: every factor between a vehicle's axle and the number that is compared with a limit.

use crate::{Dispersal, Factor, Impact, Source, Ways};
use serde::Deserialize;

/// A rule of assessment.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rule {
    /// Its name in bridge files: `cs-454`.
    pub code: String,
    /// Its name in reports.
    pub title: String,
    /// For what it is made.
    pub ways: Vec<Ways>,
    /// Where it is from.
    pub source: Source,
    /// How loads spread.
    pub dispersal: Dispersal,
    /// Which width of the barrel carries an axle.
    pub effective_width: EffectiveWidth,
    /// What motion adds to loads.
    pub impact: Impact,
    /// Partial factors.
    pub factors: Factors,
}

/// Partial factors. All must be given.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Factors {
    /// On the weight of masonry where it is adverse.
    pub masonry_weight: Factor,
    /// On the weight of fill, backing and sub-base where it is adverse.
    pub fill_weight: Factor,
    /// On the weight of surfacing and ballast where it is adverse.
    pub surfacing_weight: Factor,
    /// On any weight where it helps.
    pub weight_favourable: Factor,
    /// On live loads.
    pub live_load: Factor,
    /// On the strength of masonry: it divides.
    pub masonry_strength: Factor,
    /// On the friction of joints: it divides the coefficient.
    pub friction: Factor,
    /// On the fill's horizontal pressure where it helps: it divides.
    pub fill_pressure: Factor,
    /// For the method of analysis: it divides the capacity.
    pub model: Factor,
    /// For the condition of the bridge: it multiplies the capacity. Inspection sets it.
    pub condition: Factor,
}

/// Which width of the barrel carries an axle.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum EffectiveWidth {
    /// As wide as the load has spread at the crown's extrados, at most as the barrel.
    Dispersed {
        /// Where it is from.
        source: Source,
    },
    /// The whole barrel.
    Barrel {
        /// Where it is from.
        source: Source,
    },
    /// This width, at most the barrel.
    Fixed {
        /// Width [m].
        width_m: f64,
        /// Where it is from.
        source: Source,
    },
}

impl Rule {
    /// Width that carries an axle [m]: wheels so far apart, cover of a depth above the crown, a barrel so wide [m].
    pub fn effective_width(&self, wheel_track: f64, depth: f64, barrel: f64) -> f64 {
        match &self.effective_width {
            EffectiveWidth::Dispersed { .. } => self.dispersal.width_at(depth, wheel_track).min(barrel),
            EffectiveWidth::Barrel { .. } => barrel,
            EffectiveWidth::Fixed { width_m, .. } => width_m.min(barrel),
        }
    }

    /// By what an axle's force on the effective width is multiplied, over a loaded length under cover of a depth [m]: live
    /// load factor and impact on every axle, and what the critical axle has besides.
    pub fn load_factors(&self, length: f64, depth: f64) -> [f64; 2] {
        let [all, critical] = self.impact.factors(length, depth);
        [self.factors.live_load.value * all, critical]
    }

    /// By what the load factor of an analysis is multiplied: condition over model factor.
    pub fn capacity_factor(&self) -> f64 {
        self.factors.condition.value / self.factors.model.value
    }

    /// Every factor with its name, for reports.
    pub fn listed(&self) -> Vec<(&'static str, &Factor)> {
        let f = &self.factors;
        let mut list = vec![
            ("weight of masonry, adverse", &f.masonry_weight),
            ("weight of fill, adverse", &f.fill_weight),
            ("weight of surfacing, adverse", &f.surfacing_weight),
            ("weight that helps", &f.weight_favourable),
            ("live load", &f.live_load),
            ("strength of masonry", &f.masonry_strength),
            ("friction of joints", &f.friction),
            ("fill pressure", &f.fill_pressure),
            ("model", &f.model),
            ("condition", &f.condition),
        ];
        match &self.impact {
            Impact::AllAxles { factor } => list.push(("impact", factor)),
            Impact::CriticalAxle { factor } => list.push(("impact on the critical axle", factor)),
            Impact::Augment { .. } => {}
        }
        list
    }
}
