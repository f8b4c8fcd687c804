//! A rule of assessment: every factor between a vehicle's axle and the number that is compared with a limit.

use crate::{Dispersal, Factor, Impact, LoadModel, Source, Ways};
use serde::{Deserialize, Serialize};

/// A rule of assessment.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
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
    /// What motion adds to the loads of every model that `loads` does not name. A rule without it refuses those models.
    #[serde(default)]
    pub impact: Option<Impact>,
    /// The load models that the rule is made for, with the factors of each.
    #[serde(default)]
    pub loads: Vec<Loads>,
    /// Partial factors.
    pub factors: Factors,
    /// The rule of the library that an engineer's own rule builds on, by its code; empty where its file names none.
    #[serde(default)]
    pub based_on: String,
    /// What must be given before something is adequate by the rule.
    #[serde(default)]
    pub requires: Vec<Requirement>,
}

/// Something that must be given before a bridge is adequate by a rule.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Requirement {
    /// What.
    pub what: Required,
    /// Where the rule asks for it.
    pub source: Source,
}

/// What a rule may ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Required {
    /// Braking and traction, be it 0 with a reason.
    Braking,
    /// The compressive strength of the masonry.
    Strength,
    /// Loads that spread as the rule says.
    Dispersal,
    /// The angle of skew.
    Skew,
}

impl Required {
    /// The word in files and results.
    pub fn word(self) -> &'static str {
        match self {
            Required::Braking => "braking",
            Required::Strength => "strength",
            Required::Dispersal => "dispersal",
            Required::Skew => "skew",
        }
    }
}

/// Load models that a rule is made for, and what it does with their loads.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Loads {
    /// Codes of load models.
    pub models: Vec<String>,
    /// Factor on their loads; the rule's own where none is given.
    #[serde(default)]
    pub live_load: Option<Factor>,
    /// What motion adds to them.
    pub impact: Impact,
    /// Whether motion adds to uniform loads as well.
    #[serde(default = "yes")]
    pub impact_on_uniform: bool,
    /// Factors of multiple presence: with one lane loaded, two, three; 1 for those that are not listed.
    #[serde(default)]
    pub presence: Vec<f64>,
    /// How much heavier than their nominal loads axles may be.
    #[serde(default)]
    pub overload: Option<Overload>,
    /// What stands in the lanes beside a vehicle of these models.
    #[serde(default)]
    pub beside: Option<Beside>,
    /// What the rule asks of these loads and the program leaves out, in words.
    #[serde(default)]
    pub left_out: Vec<String>,
}

/// How much heavier than their nominal loads axles may be: one factor on the axle where it harms most, one on the others.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Overload {
    /// On the critical axle.
    pub critical: f64,
    /// On every other axle.
    pub others: f64,
    /// Where both are from.
    pub source: Source,
}

/// Normal traffic in the lanes beside an abnormal vehicle.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Beside {
    /// Codes of load models or vehicles, the worst of which stands there with the rule's factors on it.
    pub vehicles: Vec<String>,
    /// Share of their factored loads.
    pub share: f64,
    /// Where that is from.
    pub source: Source,
}

/// The default of flags that are usually set.
pub(crate) fn yes() -> bool {
    true
}

/// What a rule does with the loads of one load model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Acting {
    /// Factor on loads.
    pub live_load: Factor,
    /// What motion adds.
    pub impact: Impact,
    /// Whether motion adds to uniform loads as well.
    pub impact_on_uniform: bool,
    /// Factors of multiple presence, from one lane on.
    pub presence: Vec<f64>,
    /// How much heavier than nominal axles may be.
    #[serde(default)]
    pub overload: Option<Overload>,
    /// What stands in the lanes beside.
    #[serde(default)]
    pub beside: Option<Beside>,
    /// What the program leaves out of these loads, in words.
    #[serde(default)]
    pub left_out: Vec<String>,
    /// Whether the factors are those of the vehicles' own file, `[[under]]`, and not the rule's.
    #[serde(default)]
    pub of_vehicle_file: bool,
}

impl Acting {
    /// By what an axle's force is multiplied over a loaded length under cover of a depth [m]: live load factor and impact
    /// on every axle, and what the critical axle has besides.
    pub fn axle_factors(&self, length: f64, depth: f64) -> [f64; 2] {
        let [all, critical] = self.impact.factors(length, depth);
        let [others, more] = self.overload.as_ref().map_or([1.0; 2], |o| [o.others, o.critical / o.others]);
        [self.live_load.value * all * others, critical * more]
    }

    /// The same for uniform loads.
    pub fn uniform_factor(&self, length: f64, depth: f64) -> f64 {
        let all = if self.impact_on_uniform { self.impact.factors(length, depth)[0] } else { 1.0 };
        self.live_load.value * all
    }

    /// What motion, and axles heavier than nominal, add, in words.
    pub fn told(&self) -> String {
        let heavier = self
            .overload
            .as_ref()
            .map(|o| format!(", overload {} on the critical axle, {} on others", o.critical, o.others));
        self.impact.told() + &heavier.unwrap_or_default()
    }

    /// Where all of that is from.
    pub fn sources(&self) -> Vec<&Source> {
        self.impact.sources().into_iter().chain(self.overload.as_ref().map(|overload| &overload.source)).collect()
    }

    /// The factor of multiple presence with so many lanes loaded.
    pub fn presence(&self, lanes: usize) -> f64 {
        self.presence.get(lanes.wrapping_sub(1)).copied().unwrap_or(1.0)
    }
}

/// Partial factors. All must be given.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
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
    /// On the cohesion and the tensile strength of joints: it divides. The factor on the strength of masonry where none is
    /// given.
    #[serde(default)]
    pub cohesion: Option<Factor>,
    /// On the fill's horizontal pressure where it helps: it divides.
    pub fill_pressure: Factor,
    /// For the method of analysis: it divides the capacity.
    pub model: Factor,
    /// For the condition of the bridge: it multiplies the capacity. Inspection sets it.
    pub condition: Factor,
}

/// Which width of the barrel carries an axle.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
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

    /// What the rule does with the loads of a model: as `loads` says, as the model's own file says, or by the rule's general
    /// impact. None where the rule is not made for the model.
    pub fn acting(&self, model: &LoadModel) -> Option<Acting> {
        if let Some(loads) = self.loads.iter().find(|loads| loads.models.contains(&model.code)) {
            return Some(Acting {
                live_load: loads.live_load.clone().unwrap_or_else(|| self.factors.live_load.clone()),
                impact: loads.impact.clone(),
                impact_on_uniform: loads.impact_on_uniform,
                presence: loads.presence.clone(),
                overload: loads.overload.clone(),
                beside: loads.beside.clone(),
                left_out: loads.left_out.iter().chain(&model.left_out).cloned().collect(),
                of_vehicle_file: false,
            });
        }
        if let Some(under) = model.under.iter().find(|under| under.rule.eq_ignore_ascii_case(&self.code)) {
            return Some(Acting {
                live_load: under.live_load.clone(),
                impact: under.impact.clone(),
                impact_on_uniform: under.impact_on_uniform,
                presence: under.presence.clone(),
                overload: None,
                beside: None,
                left_out: model.left_out.clone(),
                of_vehicle_file: true,
            });
        }
        let general = self.impact.as_ref().filter(|_| self.ways.contains(&model.ways))?;
        Some(Acting {
            live_load: self.factors.live_load.clone(),
            impact: general.clone(),
            impact_on_uniform: true,
            presence: Vec::new(),
            overload: None,
            beside: None,
            left_out: model.left_out.clone(),
            of_vehicle_file: false,
        })
    }

    /// Codes of the load models that the rule is made for.
    pub fn models(&self) -> Vec<&str> {
        self.loads.iter().flat_map(|loads| loads.models.iter().map(String::as_str)).collect()
    }

    /// What motion adds to the loads of a model named by its code; else the rule's general impact; else the first that is
    /// listed.
    pub fn impact_of(&self, model: &str) -> Option<&Impact> {
        let listed = self.loads.iter().find(|loads| loads.models.iter().any(|code| code == model));
        listed.map(|loads| &loads.impact).or(self.impact.as_ref()).or(self.loads.first().map(|loads| &loads.impact))
    }

    /// The factor that divides cohesion and tensile strength of joints.
    pub fn cohesion(&self) -> &Factor {
        self.factors.cohesion.as_ref().unwrap_or(&self.factors.masonry_strength)
    }

    /// By what the load factor of an analysis is multiplied: condition over model factor.
    pub fn capacity_factor(&self) -> f64 {
        self.factors.condition.value / self.factors.model.value
    }

    /// Every factor with its name, for reports.
    pub fn listed(&self) -> Vec<(&'static str, &Factor)> {
        let f = &self.factors;
        vec![
            ("weight of masonry, adverse", &f.masonry_weight),
            ("weight of fill, adverse", &f.fill_weight),
            ("weight of surfacing, adverse", &f.surfacing_weight),
            ("favourable weight", &f.weight_favourable),
            ("live load", &f.live_load),
            ("strength of masonry", &f.masonry_strength),
            ("friction of joints", &f.friction),
            ("cohesion and tension of joints", self.cohesion()),
            ("fill pressure", &f.fill_pressure),
            ("model", &f.model),
            ("condition", &f.condition),
        ]
    }
}
