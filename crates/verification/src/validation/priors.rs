//! `priors.toml`: what is known of the materials of a bridge before it is tested, each value with its ends and its source.

use serde::Deserialize;
use std::collections::BTreeMap;

/// A quantity that nobody measured: a number with its unit in quotes, or a plain number.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Prior {
    /// The weak end.
    pub least: toml::Value,
    /// What is expected.
    pub expected: toml::Value,
    /// The strong end.
    pub most: toml::Value,
    /// Where the three are from.
    pub source: String,
}

/// Masonry of one kind.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Masonry {
    /// Mass density.
    pub density: Prior,
    /// Compressive strength of the masonry.
    pub compressive_strength: Prior,
    /// Modulus of its units, from which joints without a stiffness take theirs.
    pub elastic_modulus: Prior,
}

/// Friction between voussoirs, or between rings.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Joints {
    /// Angle of friction.
    pub friction_angle: Prior,
}

/// Fill of one kind.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fill {
    /// Mass density.
    pub density: Prior,
    /// Angle of friction.
    pub friction_angle: Prior,
    /// Cohesion.
    pub cohesion: Prior,
}

/// How far backing goes up.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Backing {
    /// Level of its upper face over the rise of the intrados; zero for none.
    pub height_over_rise: Prior,
}

/// What is stated for a method and is no property of a bridge.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stated {
    /// `[dispersal] rule`.
    pub dispersal_rule: String,
    /// `[dispersal] slope`.
    pub dispersal_slope: String,
    /// `[fill_pressure] mobilisation`.
    pub mobilisation: f64,
    /// `[fill_pressure] half_movement`, where movement mobilises.
    pub half_movement: f64,
    /// Most triangles of a continuum: `[continuum] elements`.
    pub elements: u32,
    /// Particles in the fill.
    pub particles: u32,
    /// Packings of particles whose loads are averaged: seeds from 1.
    pub packings: u64,
    /// Stiffness of the contacts of particles.
    pub particle_normal_stiffness: String,
    /// The same in shear.
    pub particle_shear_stiffness: String,
    /// Where these are from.
    pub source: String,
}

/// The one set of prior values.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Priors {
    /// By kind.
    pub masonry: BTreeMap<String, Masonry>,
    /// Joints between voussoirs.
    pub joint: Joints,
    /// Joints between rings that are separated.
    pub ring_joint: Joints,
    /// By kind.
    pub fill: BTreeMap<String, Fill>,
    /// By what is known of it.
    pub backing: BTreeMap<String, Backing>,
    /// What backing is made of.
    pub backing_material: Fill,
    /// What methods are given.
    pub stated: Stated,
}

impl Priors {
    /// Every prior with its path in the file.
    pub fn all(&self) -> Vec<(String, &Prior)> {
        let mut all = Vec::new();
        let mut put = |path: String, prior| all.push((path, prior));
        for (kind, masonry) in &self.masonry {
            put(format!("masonry.{kind}.density"), &masonry.density);
            put(format!("masonry.{kind}.compressive_strength"), &masonry.compressive_strength);
            put(format!("masonry.{kind}.elastic_modulus"), &masonry.elastic_modulus);
        }
        put("joint.friction_angle".into(), &self.joint.friction_angle);
        put("ring_joint.friction_angle".into(), &self.ring_joint.friction_angle);
        let named = self.fill.iter().map(|(kind, fill)| (format!("fill.{kind}"), fill));
        for (path, fill) in named.chain([("backing_material".to_owned(), &self.backing_material)]) {
            put(format!("{path}.density"), &fill.density);
            put(format!("{path}.friction_angle"), &fill.friction_angle);
            put(format!("{path}.cohesion"), &fill.cohesion);
        }
        for (kind, backing) in &self.backing {
            put(format!("backing.{kind}.height_over_rise"), &backing.height_over_rise);
        }
        all
    }

    /// What is wrong with a prior, by its path: nothing is more than `most` or less than `least`, and every one has a source.
    pub fn wrong(&self) -> Option<String> {
        self.all().into_iter().find_map(|(path, prior)| {
            let numbers = [&prior.least, &prior.expected, &prior.most].map(number);
            let [Some(least), Some(expected), Some(most)] = numbers else {
                return Some(format!("{path}: write least, expected and most as numbers, with their unit in quotes"));
            };
            if !(least <= expected && expected <= most) {
                return Some(format!("{path}: expected lies between least and most, all in one unit"));
            }
            prior.source.trim().is_empty().then(|| format!("{path}: say in source where the values are from"))
        })
    }
}

/// The number of a value, whatever its unit; the three values of a prior have the same one.
pub(super) fn number(value: &toml::Value) -> Option<f64> {
    match value {
        toml::Value::Float(number) => Some(*number),
        toml::Value::Integer(number) => Some(*number as f64),
        toml::Value::String(text) => text.split_whitespace().next()?.parse().ok(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_stands_before_its_unit() {
        assert_eq!(number(&toml::Value::String("2100 kg/m^3".into())), Some(2100.0));
        assert_eq!(number(&toml::Value::Float(0.5)), Some(0.5));
        assert_eq!(number(&toml::Value::String("some".into())), None);
    }
}
