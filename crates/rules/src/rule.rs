//! A rule of assessment: every factor between a vehicle's axle and the number that is compared with a limit.

use crate::shape::{forms, table, words};
use crate::{Dispersal, Factor, Impact, LoadModel, Source, Ways};
use serde::{Deserialize, Serialize};

table! {
    /// A rule of assessment.
    pub struct Rule = "a file of a rule" {
        must code: String, "name of the rule";
        must title: String, "its name in reports";
        must ways: Vec<Ways>, "for what it is made";
        must source: Source, "where it is from";
        must dispersal: Dispersal, "how loads spread";
        must effective_width: EffectiveWidth, "which width of the barrel carries an axle";
        may impact: Option<Impact>, "what motion adds to loads of models that [[loads]] does not name; without it they are refused";
        may[default] loads: Vec<Loads>, "load models that the rule is made for, with the factors of each";
        must factors: Factors, "partial factors";
        may[default] based_on: String,
            "code of the rule of the library that it builds on: factors that differ from it stand beside a verdict; the nearest rule where not written";
        may restrictions: Option<String>,
            "load model of the grades that are looked up, as a weight limit, where a vehicle is not carried on which it acts as on them";
        may[default] requires: Vec<Requirement>, "what must be given before a bridge is adequate by the rule";
    }
}

table! {
    /// Something that must be given before a bridge is adequate by a rule.
    #[derive(Eq)]
    pub struct Requirement = "requires" {
        must what: Required, "what must be given before a bridge is adequate by the rule";
        must source: Source, "where the rule asks for it";
    }
}

words! {
    /// What a rule may ask for.
    #[derive(PartialOrd, Ord)]
    pub enum Required {
        /// Braking and traction, be it 0 with a reason.
        Braking = "braking",
        /// The compressive strength of the masonry.
        Strength = "strength",
        /// Loads that spread as the rule says.
        Dispersal = "dispersal",
        /// The angle of skew.
        Skew = "skew",
    }
}

table! {
    /// Load models that a rule is made for, and what it does with their loads.
    pub struct Loads = "loads" {
        must models: Vec<String>, "codes of load models that the rule is made for";
        may live_load: Option<Factor>, "factor on their loads; that of [factors] where it is not written";
        must impact: Impact, "what motion adds to them";
        may[default = "yes"] impact_on_uniform: bool, "whether motion adds to uniform loads as well; true where it is not written";
        may[default] presence: Vec<f64>, "factors of multiple presence with one lane loaded, two, three; 1 where they are not written";
        may overload: Option<Overload>, "how much heavier than their nominal loads axles may be";
        may beside: Option<Beside>, "what stands in the lanes beside a vehicle of these models";
        may[default] left_out: Vec<String>, "what the rule asks of these loads and the program leaves out: a verdict names it";
    }
}

table! {
    /// How much heavier than their nominal loads axles may be: one factor on the axle where it harms most, one on the others.
    pub struct Overload = "overload" {
        must critical: f64, "factor on the axle where it harms most";
        must others: f64, "factor on every other axle";
        must source: Source, "where both are from";
    }
}

table! {
    /// Normal traffic in the lanes beside an abnormal vehicle.
    pub struct Beside = "beside" {
        must vehicles: Vec<String>,
            "codes of load models or vehicles, the worst of which stands there with the rule's factors on it";
        must share: f64, "share of their factored loads";
        must source: Source, "where that is from";
    }
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

table! {
    /// Partial factors.
    pub struct Factors = "factors" {
        must masonry_weight: Factor, "on the weight of masonry where it is adverse";
        must fill_weight: Factor, "on the weight of fill, backing and sub-base where it is adverse";
        must surfacing_weight: Factor, "on the weight of surfacing and ballast where it is adverse";
        must weight_favourable: Factor, "on any weight where it helps";
        must live_load: Factor, "on live loads";
        must masonry_strength: Factor, "on the strength of masonry: it divides";
        must friction: Factor, "on the friction of joints: it divides";
        may cohesion: Option<Factor>, "on cohesion and tensile strength of joints: it divides; as masonry_strength where not written";
        must fill_pressure: Factor, "on the fill's horizontal pressure: it divides";
        must model: Factor, "for the method of analysis: it divides the capacity";
        must condition: Factor, "for the condition of the bridge: it multiplies the capacity";
    }
}

forms! {
    /// Which width of the barrel carries an axle.
    pub enum EffectiveWidth {
        /// As wide as the load has spread at the crown's extrados, at most as the barrel.
        Dispersed = "dispersed" {
            must source: Source, "as wide as the load has spread at the crown: where that is from";
        }
        /// The whole barrel.
        Barrel = "barrel" {
            must source: Source, "the whole barrel: where that is from";
        }
        /// This width, at most the barrel.
        Fixed = "fixed" {
            must width_m: f64, "width that carries an axle, at most the barrel [m]";
            must source: Source, "where it is from";
        }
    }
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
        let plain = |live_load: &Factor, impact: &Impact| Acting {
            live_load: live_load.clone(),
            impact: impact.clone(),
            impact_on_uniform: true,
            presence: Vec::new(),
            overload: None,
            beside: None,
            left_out: model.left_out.clone(),
            of_vehicle_file: false,
        };
        let own = &self.factors.live_load;
        if let Some(loads) = self.loads.iter().find(|loads| loads.models.contains(&model.code)) {
            return Some(Acting {
                impact_on_uniform: loads.impact_on_uniform,
                presence: loads.presence.clone(),
                overload: loads.overload.clone(),
                beside: loads.beside.clone(),
                left_out: loads.left_out.iter().chain(&model.left_out).cloned().collect(),
                ..plain(loads.live_load.as_ref().unwrap_or(own), &loads.impact)
            });
        }
        if let Some(under) = model.under.iter().find(|under| under.rule.eq_ignore_ascii_case(&self.code)) {
            return Some(Acting {
                impact_on_uniform: under.impact_on_uniform,
                presence: under.presence.clone(),
                of_vehicle_file: true,
                ..plain(&under.live_load, &under.impact)
            });
        }
        self.impact.as_ref().filter(|_| self.ways.contains(&model.ways)).map(|general| plain(own, general))
    }

    /// Whether the loads of two models have the same factors.
    pub fn acts_alike(&self, one: &str, other: &str) -> bool {
        let has = |loads: &Loads, code: &str| loads.models.iter().any(|model| model == code);
        one == other || self.loads.iter().any(|loads| has(loads, one) && has(loads, other))
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
