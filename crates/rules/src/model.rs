//! A load model: vehicles, and what was published of them.

use crate::{Factor, Impact, Source, Vehicle};
use serde::{Deserialize, Serialize};

/// Vehicles of one standard, and the tables that were published for them.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct LoadModel {
    /// Its name: `25t-2008`.
    pub code: String,
    /// Its name in reports.
    pub title: String,
    /// On what it drives.
    pub ways: Ways,
    /// Where it is from.
    pub source: Source,
    /// What its vehicles are grades of, where they are, from the lightest up: "Route Availability".
    #[serde(default)]
    pub grades: String,
    /// Its vehicles.
    #[serde(default, rename = "vehicle")]
    pub vehicles: Vec<Vehicle>,
    /// Numbers that somebody published.
    #[serde(default)]
    pub published: Vec<Published>,
    /// Numbers that were worked out by hand from the loads of this file.
    #[serde(default)]
    pub checked: Vec<Published>,
    /// The longest span that the model may be used for, where it is known to fall short on longer ones.
    #[serde(default)]
    pub span_limit: Option<SpanLimit>,
    /// Shares of its axle loads in the first lane or track, the second and so on, when vehicles stand abreast; the whole in
    /// every lane where none are given.
    #[serde(default)]
    pub abreast: Vec<f64>,
    /// Whether its vehicles are taken only where they, or the model, are named, and not among all that a rule is made for.
    #[serde(default)]
    pub only_by_name: bool,
    /// Factors under rules that do not name this model, where its file gives them.
    #[serde(default)]
    pub under: Vec<Under>,
    /// What the loading has and the vehicles of this file leave out, in words.
    #[serde(default)]
    pub left_out: Vec<String>,
    /// The loading whose cases its vehicles are, all of which a bridge must carry: every vehicle of every model with the same name
    /// belongs to it. Empty where a vehicle stands for itself.
    #[serde(default)]
    pub loading: String,
}

/// The longest span that a load model may be used for.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct SpanLimit {
    /// Span [m].
    pub longest_m: f64,
    /// Why not longer ones.
    pub reason: String,
    /// Where that is from.
    pub source: Source,
}

/// What a rule does with the loads of a model, in the model's own file.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Under {
    /// Code of the rule.
    pub rule: String,
    /// Factor on the loads.
    pub live_load: Factor,
    /// What motion adds.
    pub impact: Impact,
    /// Whether motion adds to uniform loads as well.
    #[serde(default = "crate::rule::yes")]
    pub impact_on_uniform: bool,
    /// Factors of multiple presence: with one lane loaded, two, three.
    #[serde(default)]
    pub presence: Vec<f64>,
}

/// On what vehicles drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ways {
    /// On rails; loads are those of one track.
    Rail,
    /// On a road; loads are those of one lane.
    Road,
}

/// A table of numbers over spans that were published, or worked out by hand.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Published {
    /// The vehicle.
    pub vehicle: String,
    /// What the numbers are.
    pub quantity: PublishedQuantity,
    /// Whether the vehicle's uniform loads take part.
    pub with_uniform: bool,
    /// Spans [m].
    pub spans_m: Vec<f64>,
    /// The numbers, in the unit of the quantity.
    pub values: Vec<f64>,
    /// How far the vehicle may be from them, relative.
    pub tolerance: f64,
    /// How far above them the vehicle may be, where it covers them and does not meet them.
    #[serde(default)]
    pub above: f64,
    /// Where along the span bending moments are compared, as a share of it; at the worst section where none is given.
    #[serde(default)]
    pub section: Option<f64>,
    /// Why this tolerance.
    pub reason: String,
    /// Why the vehicle alone does not give these numbers, where it does not; they are then read and not checked.
    #[serde(default)]
    pub not_from_vehicle: String,
    /// Where they are from.
    pub source: Source,
}

/// What published numbers are: all of a simply supported span.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PublishedQuantity {
    /// Uniform load with the same greatest bending moment, as a total [kN].
    EudlBending,
    /// Uniform load with the same greatest shear, as a total [kN].
    EudlShear,
    /// Greatest bending moment [kN m].
    Bending,
    /// Greatest shear, at a support [kN].
    Shear,
    /// Coefficient of dynamic augment of the rule that goes with the model.
    DynamicAugment,
}

impl LoadModel {
    /// The vehicle of this code, in whatever case it is written.
    pub fn vehicle(&self, code: &str) -> Option<&Vehicle> {
        self.vehicles.iter().find(|vehicle| vehicle.code.eq_ignore_ascii_case(code))
    }

    /// Every table that its vehicles are compared with: what was published, then what was worked out by hand.
    pub fn tables(&self) -> impl Iterator<Item = &Published> {
        self.published.iter().chain(&self.checked)
    }

    /// Where a vehicle of the model is from: its own source, or the model's.
    pub fn source_of<'a>(&'a self, vehicle: &'a Vehicle) -> &'a Source {
        vehicle.source.as_ref().unwrap_or(&self.source)
    }

    /// The published number at a span [m], linear between the spans of the table; none outside of it.
    pub fn published(&self, quantity: PublishedQuantity, span: f64) -> Option<f64> {
        let mut rows: Vec<(f64, f64)> = self
            .published
            .iter()
            .filter(|table| table.quantity == quantity)
            .flat_map(|table| table.spans_m.iter().copied().zip(table.values.iter().copied()))
            .collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        if let Some(row) = rows.iter().find(|row| row.0 == span) {
            return Some(row.1);
        }
        rows.windows(2)
            .find(|pair| pair[0].0 < span && span < pair[1].0)
            .map(|pair| pair[0].1 + (pair[1].1 - pair[0].1) * (span - pair[0].0) / (pair[1].0 - pair[0].0))
    }
}
