//! Fill as particles.

use super::materials::{joint, maybe};
use super::structure::{exclude, need};
use crate::findings::Findings;
use crate::model::{Cover, Joint, Packing, Particles, Sizes};
use crate::tree::Table;

/// Largest over smallest diameter where the file gives a number of particles only.
const SIZE_RATIO: f64 = 1.5;

/// The particles; `None` inside where no layer is modelled so.
pub(super) fn particles(file: &Table<'_>, cover: Option<&Cover>, findings: &mut Findings) -> Option<Option<Particles>> {
    let wanted = cover.is_some_and(|cover| cover.layers.iter().any(|layer| layer.particles));
    let written =
        ["particles", "particle_joint", "particle_block_joint", "calibration"].into_iter().filter(|key| file.has(key));
    if !wanted {
        for key in written {
            let mut unheard = Findings::default();
            let range = file.table(key, &mut unheard).map_or(file.range, |table| table.range);
            findings.warning(
                "P022",
                range,
                "no layer is modelled as particles",
                "not used",
                "write as = \"particles\" in a [[cover]], or remove this",
            );
        }
        return Some(None);
    }
    let table =
        if file.has("particles") { file.table("particles", findings) } else { need_table(file, "particles", findings) };
    let contact = if file.has("particle_joint") {
        joint(file, "particle_joint", findings)
    } else {
        need_table(file, "particle_joint", findings)
    };
    let of_blocks =
        if file.has("particle_block_joint") { joint(file, "particle_block_joint", findings) } else { contact };
    for (key, joint) in [("particle_joint", &contact), ("particle_block_joint", &of_blocks)] {
        no_tension(file, key, joint.as_ref(), findings);
    }
    let table = table?;
    let sizes = sizes(&table, findings);
    let stress = table.quantity("packing_stress", findings);
    let fraction = table.number("solid_fraction", findings);
    let name = table.text("file", findings);
    let elastic_modulus = table.quantity("elastic_modulus", findings);
    let poisson_ratio = table.number("poisson_ratio", findings);
    if table.has("packing_stress") && table.has("solid_fraction") {
        exclude(&table, "solid_fraction", "`packing_stress`", findings);
        return None;
    }
    let density = match (maybe(&table, "packing_stress", stress)?, maybe(&table, "solid_fraction", fraction)?) {
        (Some(stress), _) => Packing::Stress(stress),
        (None, Some(fraction)) => Packing::SolidFraction(fraction),
        (None, None) => Packing::OwnWeight,
    };
    Some(Some(Particles {
        sizes: sizes?,
        density,
        file: maybe(&table, "file", name)?.map(str::to_string),
        grains: Vec::new(),
        elastic_modulus: maybe(&table, "elastic_modulus", elastic_modulus)?,
        poisson_ratio: maybe(&table, "poisson_ratio", poisson_ratio)?,
        joint: contact?,
        block_joint: of_blocks?,
    }))
}

fn need_table<T>(file: &Table<'_>, key: &str, findings: &mut Findings) -> Option<T> {
    need(file, key, findings);
    None
}

fn sizes(table: &Table<'_>, findings: &mut Findings) -> Option<Sizes> {
    let count = table.count("count", findings);
    let ratio = table.number("size_ratio", findings);
    let smallest = table.quantity("smallest_diameter", findings);
    let largest = table.quantity("largest_diameter", findings);
    if table.has("count") {
        if let Some(key) = ["smallest_diameter", "largest_diameter"].into_iter().find(|key| table.has(key)) {
            exclude(table, key, "`count`", findings);
            return None;
        }
        let ratio = maybe(table, "size_ratio", ratio)?.unwrap_or(SIZE_RATIO);
        return Some(Sizes::Count { count: count?.value as usize, ratio });
    }
    if table.has("size_ratio") {
        exclude(table, "size_ratio", "diameters", findings);
        return None;
    }
    if !(table.has("smallest_diameter") && table.has("largest_diameter")) {
        let missing = ["smallest_diameter", "largest_diameter"].into_iter().find(|key| !table.has(key));
        need(
            table,
            if table.has("smallest_diameter") || table.has("largest_diameter") { missing? } else { "count" },
            findings,
        );
        return None;
    }
    let (smallest, largest) = (smallest?, largest?);
    if smallest.value > largest.value {
        findings.error(
            "B214",
            smallest.range,
            "the smallest diameter is larger than the largest",
            "above `largest_diameter`",
            "exchange the two",
        );
        return None;
    }
    Some(Sizes::Diameters { smallest: smallest.value, largest: largest.value })
}

fn no_tension(file: &Table<'_>, key: &str, joint: Option<&Joint>, findings: &mut Findings) {
    if joint.is_some_and(|joint| joint.tensile_strength > 0.0) {
        let mut unheard = Findings::default();
        let Some(table) = file.table(key, &mut unheard) else { return };
        findings.error(
            "B215",
            table.place("tensile_strength"),
            "contacts of particles have no tensile strength",
            "particles part freely",
            "remove it; cohesion acts while a contact is closed",
        );
    }
}
