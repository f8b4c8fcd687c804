//! A bridge file of a test, made of its geometry and of prior values at one of their ends.

use super::corpus::Test;
use super::priors::{Fill, Prior, Priors, number};
use crate::case::{Changes, change};
use crate::measure::said;
use assess::analysis::stiffened;
use bridge::{Bridge, Joint, JointStiffness};
use outcome::validation::Predictor;
use toml::{Table, Value};

/// Which of its three values every prior has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// The weak end.
    Least,
    /// What is expected.
    Expected,
    /// The strong end.
    Most,
}

/// Which end of their intervals remembered dimensions have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Less load.
    Weak,
    /// More load.
    Strong,
}

impl Level {
    /// The value of a prior.
    fn of(self, prior: &Prior) -> Value {
        match self {
            Level::Least => &prior.least,
            Level::Expected => &prior.expected,
            Level::Most => &prior.most,
        }
        .clone()
    }
}

/// Knife edges on particles stand on a block of this weight, which the load counts.
const BLOCK_WEIGHT: &str = "1 kN/m";

/// The bridge file of a test for a method, with priors and remembered dimensions as said.
pub(super) fn document(
    test: &Test,
    priors: &Priors,
    by: Predictor,
    (level, side): (Level, Option<Side>),
) -> Result<Table, String> {
    let mut file = test.bridge.clone();
    change(&mut file, &dimensions(test, side)?)?;
    let masonry = &priors.masonry[&test.field.masonry];
    let fill = &priors.fill[&test.field.fill];
    file.insert(
        "masonry".into(),
        table([
            ("density", level.of(&masonry.density)),
            ("compressive_strength", level.of(&masonry.compressive_strength)),
            ("elastic_modulus", level.of(&masonry.elastic_modulus)),
        ]),
    );
    let joint = |angle: &Prior| table([("friction_angle", level.of(angle)), ("cohesion", "0 kPa".into())]);
    file.insert("joint".into(), joint(&priors.joint.friction_angle));
    if file
        .get("span")
        .and_then(Value::as_array)
        .is_some_and(|spans| spans.iter().any(|span| span.get("ring").is_some()))
    {
        file.insert("ring_joint".into(), joint(&priors.ring_joint.friction_angle));
    }
    let stated = &priors.stated;
    let dispersal =
        [("rule", stated.dispersal_rule.as_str().into()), ("slope", stated.dispersal_slope.as_str().into())];
    file.insert("dispersal".into(), table(dispersal));
    let method = match by {
        Predictor::Weight | Predictor::Pressure | Predictor::Continuum => "limit",
        Predictor::Path | Predictor::Movement => "path",
        Predictor::Particles => "dem",
    };
    file.insert("analysis".into(), table([("method", method.into())]));
    let layers = file.get_mut("cover").and_then(Value::as_array_mut).ok_or("there is no [[cover]]")?;
    for layer in layers.iter_mut().filter_map(Value::as_table_mut) {
        layer.insert("density".into(), level.of(&fill.density));
        modelled(layer, by, fill, level);
    }
    backed(&mut file, test, priors, by, level)?;
    match by {
        Predictor::Pressure => {
            let mut pressure = strength(fill, level);
            pressure.push(("mobilisation", Value::Float(stated.mobilisation)));
            file.insert("fill_pressure".into(), table(pressure));
        }
        Predictor::Particles => {
            stiff(&mut file)?;
            particles(&mut file, priors, fill, level);
        }
        Predictor::Path => stiff(&mut file)?,
        // All of the passive pressure: how much of it is there is for the movement to say.
        Predictor::Movement => {
            stiff(&mut file)?;
            let mut pressure = strength(fill, level);
            pressure.push(("mobilisation", Value::Float(1.0)));
            pressure.push(("half_movement", Value::Float(stated.half_movement)));
            file.insert("fill_pressure".into(), table(pressure));
        }
        Predictor::Continuum => {
            file.insert("continuum".into(), table([("elements", Value::Integer(i64::from(stated.elements)))]));
        }
        Predictor::Weight => {}
    }
    Ok(file)
}

/// A document as a bridge; what is wrong with it in one line.
pub(super) fn bridge_of(document: &Table) -> Result<Bridge, String> {
    let text = toml::to_string(document).map_err(|error| error.to_string())?;
    let read = bridge::read(text.as_bytes());
    read.bridge.ok_or_else(|| said(&read.diagnostics))
}

fn table<'a>(entries: impl IntoIterator<Item = (&'a str, Value)>) -> Value {
    Value::Table(entries.into_iter().map(|(key, value)| (key.to_owned(), value)).collect())
}

/// Remembered dimensions at an end of their intervals; every dimension must be one of the bridge file.
pub(super) fn dimensions(test: &Test, side: Option<Side>) -> Result<Changes, String> {
    let mut changes = Changes::new();
    for one in &test.field.dimension {
        let own = find(&test.bridge, &one.key);
        let own = own.ok_or_else(|| format!("dimension {}: the bridge file has no such key", one.key))?;
        let end = match side {
            None => None,
            Some(Side::Weak) => one.weak.as_ref(),
            Some(Side::Strong) => one.strong.as_ref(),
        };
        // A word, such as that of a profile, has no ends.
        if !one.mark.is_read() && one.weak.is_none() && number(own).is_some() {
            return Err(format!("dimension {}: what was not read needs an interval; write weak and strong", one.key));
        }
        if let (Some(weak), Some(strong)) = (&one.weak, &one.strong) {
            let [own, weak, strong] = [own, weak, strong].map(number);
            let between = weak.zip(strong).zip(own).is_some_and(|((a, b), own)| a.min(b) <= own && own <= a.max(b));
            if !between {
                return Err(format!("dimension {}: its value lies between weak and strong, all in one unit", one.key));
            }
        }
        if let Some(end) = end {
            changes.insert(one.key.clone(), end.clone());
        }
    }
    Ok(changes)
}

/// A value of a document: keys joined by points, rows by number.
fn find<'a>(document: &'a Table, key: &str) -> Option<&'a Value> {
    let (first, rest) = key.split_once('.').map_or((key, None), |(first, rest)| (first, Some(rest)));
    let mut at = document.get(first)?;
    for part in rest.into_iter().flat_map(|rest| rest.split('.')) {
        at = match at {
            Value::Array(rows) => rows.get(part.parse::<usize>().ok()?)?,
            other => other.get(part)?,
        };
    }
    Some(at)
}

fn strength(of: &Fill, level: Level) -> Vec<(&'static str, Value)> {
    vec![("friction_angle", level.of(&of.friction_angle)), ("cohesion", level.of(&of.cohesion))]
}

/// How a layer or backing takes part.
fn modelled(layer: &mut Table, by: Predictor, of: &Fill, level: Level) {
    let word = match by {
        Predictor::Weight | Predictor::Pressure | Predictor::Path | Predictor::Movement => return,
        Predictor::Continuum => "continuum",
        Predictor::Particles => "particles",
    };
    layer.insert("as".into(), word.into());
    layer.extend(strength(of, level).into_iter().map(|(key, value)| (key.to_owned(), value)));
}

/// Backing up to its share of the rise, where there is any.
fn backed(file: &mut Table, test: &Test, priors: &Priors, by: Predictor, level: Level) -> Result<(), String> {
    let share = number(&level.of(&priors.backing[&test.field.backing].height_over_rise)).unwrap_or(0.0);
    if share <= 0.0 {
        return Ok(());
    }
    let height = share * bridge_of(&weight_alone(file))?.spans[0].rise;
    let material = &priors.backing_material;
    let mut backing = Table::new();
    backing.insert("height".into(), format!("{height:.4} m").into());
    backing.insert("density".into(), level.of(&material.density));
    modelled(&mut backing, by, material, level);
    file.insert("backing".into(), Value::Table(backing));
    Ok(())
}

/// The same bridge with its layers as weight, which needs no more to be read.
fn weight_alone(file: &Table) -> Table {
    let mut plain = file.clone();
    let strip = |layer: &mut Table| layer.retain(|key, _| !["as", "friction_angle", "cohesion"].contains(&key));
    let layers = plain.get_mut("cover").and_then(Value::as_array_mut).into_iter().flatten();
    layers.filter_map(Value::as_table_mut).for_each(strip);
    plain.get_mut("backing").and_then(Value::as_table_mut).into_iter().for_each(strip);
    plain.insert("analysis".into(), table([("method", "limit".into())]));
    plain
}

/// Joints with the stiffness that equilibrium paths take where a file gives none, from the modulus of the units.
fn stiff(file: &mut Table) -> Result<(), String> {
    let bridge = stiffened(&bridge_of(&weight_alone(file))?);
    let mut put = |section: &str, joint: &Joint| {
        let Some(joint_of_file) = file.get_mut(section).and_then(Value::as_table_mut) else { return };
        for (key, stiffness) in
            [("normal_stiffness", joint.normal_stiffness), ("shear_stiffness", joint.shear_stiffness)]
        {
            if let Some(JointStiffness::Contact(stiffness)) = stiffness {
                joint_of_file.insert(key.into(), format!("{:.6} GPa/m", stiffness / 1e9).into());
            }
        }
    };
    put("joint", &bridge.joint);
    put("ring_joint", &bridge.ring_joint);
    Ok(())
}

/// What discrete elements need beside; the load step is put in before the run.
fn particles(file: &mut Table, priors: &Priors, fill: &Fill, level: Level) {
    let stated = &priors.stated;
    let contact = || {
        let mut entries = strength(fill, level);
        entries.push(("normal_stiffness", stated.particle_normal_stiffness.as_str().into()));
        entries.push(("shear_stiffness", stated.particle_shear_stiffness.as_str().into()));
        table(entries)
    };
    file.insert("particle_joint".into(), contact());
    file.insert("particle_block_joint".into(), contact());
    let count = Value::Integer(i64::from(stated.particles));
    file.insert("particles".into(), table([("count", count), ("size_ratio", Value::Float(1.5))]));
    let plan = [
        ("method", "dem".into()),
        ("strip", "fill".into()),
        ("load_step", "1 kN/m".into()),
        ("load_limit", "1000 kN/m".into()),
        ("tolerance", Value::Float(3e-4)),
        ("damping", "local".into()),
        ("damping_share", Value::Float(0.2)),
        ("seed", Value::Integer(1)),
    ];
    file.insert("analysis".into(), table(plan));
    for load in file.get_mut("load").and_then(Value::as_array_mut).into_iter().flatten() {
        if let Some(load) = load.as_table_mut() {
            load.insert("through".into(), "block".into());
            load.insert("block_weight".into(), BLOCK_WEIGHT.into());
        }
    }
}
