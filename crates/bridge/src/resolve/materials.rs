//! Masonry and joints.

use crate::findings::Findings;
use crate::model::{Joint, JointStiffness, Masonry};
use crate::tree::{At, Table};

/// A value that may be missing: `None` inside where it is not written; `None` outside where it is wrong.
pub(super) fn maybe<T>(table: &Table<'_>, key: &str, value: Option<At<T>>) -> Option<Option<T>> {
    if !table.has(key) {
        return Some(None);
    }
    value.map(|at| Some(at.value))
}

pub(super) fn masonry(file: &Table<'_>, findings: &mut Findings) -> Option<Masonry> {
    let table = file.table("masonry", findings)?;
    masonry_of(&table, findings)
}

/// The material that a table describes.
pub(super) fn masonry_of(table: &Table<'_>, findings: &mut Findings) -> Option<Masonry> {
    let density = table.quantity("density", findings);
    let elastic_modulus = table.quantity("elastic_modulus", findings);
    let poisson_ratio = table.number("poisson_ratio", findings);
    let compressive_strength = table.quantity_or_word("compressive_strength", findings);
    let rounding = table.quantity("rounding", findings);
    Some(Masonry {
        density: density?.value,
        elastic_modulus: maybe(table, "elastic_modulus", elastic_modulus)?,
        poisson_ratio: maybe(table, "poisson_ratio", poisson_ratio)?,
        compressive_strength: maybe(table, "compressive_strength", compressive_strength)?
            .filter(|value| value.is_finite()),
        rounding: maybe(table, "rounding", rounding)?.unwrap_or(0.0),
    })
}

pub(super) fn joint(file: &Table<'_>, name: &str, findings: &mut Findings) -> Option<Joint> {
    let table = file.table(name, findings)?;
    joint_of(&table, findings)
}

/// The joint that a table describes.
pub(super) fn joint_of(table: &Table<'_>, findings: &mut Findings) -> Option<Joint> {
    let normal_stiffness = stiffness(table, "normal_stiffness", "mortar_normal_stiffness", findings);
    let shear_stiffness = stiffness(table, "shear_stiffness", "mortar_shear_stiffness", findings);
    let friction_angle = table.quantity("friction_angle", findings);
    let cohesion = table.quantity("cohesion", findings);
    let tensile_strength = table.quantity("tensile_strength", findings);
    let fixed_length = table.quantity("fixed_length", findings);
    let least_length = table.quantity("least_length", findings);
    Some(Joint {
        normal_stiffness: normal_stiffness?,
        shear_stiffness: shear_stiffness?,
        friction_angle: friction_angle?.value,
        cohesion: cohesion?.value,
        tensile_strength: maybe(table, "tensile_strength", tensile_strength)?.unwrap_or(0.0),
        fixed_length: maybe(table, "fixed_length", fixed_length)?,
        least_length: maybe(table, "least_length", least_length)?,
    })
}

/// The stiffness of the contact, or that of the mortar with the blocks in series.
fn stiffness(
    table: &Table<'_>,
    contact: &str,
    mortar: &str,
    findings: &mut Findings,
) -> Option<Option<JointStiffness>> {
    let whole = table.quantity(contact, findings);
    let alone = table.quantity(mortar, findings);
    if table.has(contact) && table.has(mortar) {
        super::structure::exclude(table, mortar, &format!("`{contact}`"), findings);
        return None;
    }
    if table.has(mortar) {
        return alone.map(|at| Some(JointStiffness::Series(at.value)));
    }
    maybe(table, contact, whole).map(|value| value.map(JointStiffness::Contact))
}
