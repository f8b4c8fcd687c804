//! Fill that is modelled as particles.

use super::material::joint;
use crate::card::Section;
use crate::cards::*;
use crate::findings::Findings;
use crate::model::{Cover, Joint, Packing, Particles, Sizes};
use crate::tree::Table;
use crate::values::read;

pub(super) static PARTICLES: Section = Section {
    path: "particles",
    doc: "How layers with `as = \"particles\"` are filled with circular particles: strewn at random between the extrados, \
          the abutments and the road surface, and grown until they press on one another. The same seed ([analysis] seed) \
          gives the same packing.",
    fields: &[
        count("count", "number of particles", "1984")
            .between(10.0, 4e6)
            .optional("the number that follows from `smallest_diameter` and `largest_diameter`"),
        number("size_ratio", "largest over smallest diameter, where `count` is given", "1.5")
            .between(1.0, 20.0)
            .optional("1.5"),
        length("smallest_diameter", "smallest diameter of a particle", "0.12 m")
            .positive()
            .optional("given by `count`"),
        length("largest_diameter", "largest diameter of a particle", "0.18 m").positive().optional("given by `count`"),
        stress(
            "packing_stress",
            "mean stress with which the particles press on one another when they have grown",
            "30 kPa",
        )
        .positive()
        .optional("the weight of the cover at half its mean depth, unless `solid_fraction` is given"),
        number("solid_fraction", "share of the region that the particles cover", "0.84")
            .between(0.5, 0.92)
            .optional("the fraction that follows from `packing_stress`"),
        text("file", "a packing that was saved, in place of a new one", "packing.csv")
            .optional("a new packing is made"),
        stress("elastic_modulus", "modulus of the particles in the series rule", "40 MPa")
            .positive()
            .optional("needed for `mortar_…_stiffness` of [particle_joint]"),
        number("poisson_ratio", "Poisson's ratio in the series rule", "0.2")
            .between(0.0, 0.4999)
            .optional("needed for `mortar_shear_stiffness` of [particle_joint]"),
    ],
};

/// Largest over smallest diameter where the file gives a number of particles only.
const SIZE_RATIO: f64 = 1.5;

/// The particles; `None` inside where no layer is modelled so.
pub(crate) fn particles(file: &Table<'_>, cover: Option<&Cover>, findings: &mut Findings) -> Option<Option<Particles>> {
    let wanted = cover.is_some_and(|cover| cover.layers.iter().any(|layer| layer.particles));
    let written =
        ["particles", "particle_joint", "particle_block_joint", "calibration"].into_iter().filter(|key| file.has(key));
    if !wanted {
        for key in written {
            findings.warning(
                "P022",
                file.known(key).map_or(file.range, |table| table.range),
                "no layer is modelled as particles",
                "not used",
                "write as = \"particles\" in a [[cover]], or remove this",
            );
        }
        return Some(None);
    }
    let table = file.table("particles", findings);
    let contact = joint(file, "particle_joint", findings);
    for key in ["particles", "particle_joint"].into_iter().filter(|key| !file.has(key)) {
        file.need::<()>(key, findings);
    }
    let of_blocks = match file.has("particle_block_joint") {
        true => joint(file, "particle_block_joint", findings),
        false => contact,
    };
    for (key, joint) in [("particle_joint", &contact), ("particle_block_joint", &of_blocks)] {
        no_tension(file, key, joint.as_ref(), findings);
    }
    let table = &table?;
    let sizes = sizes(table, findings);
    let stress: Option<Option<f64>> = table.read("packing_stress", findings);
    let fraction: Option<Option<f64>> = table.read("solid_fraction", findings);
    if table.has("packing_stress") && table.has("solid_fraction") {
        return table.exclude("solid_fraction", "`packing_stress`", findings);
    }
    let particles = read!(
        table,
        findings,
        Particles {
            file,
            elastic_modulus,
            poisson_ratio;
            sizes: sizes?,
            density: match (stress?, fraction?) {
                (Some(stress), _) => Packing::Stress(stress),
                (None, Some(fraction)) => Packing::SolidFraction(fraction),
                (None, None) => Packing::OwnWeight,
            },
            grains: Vec::new(),
            joint: contact?,
            block_joint: of_blocks?,
        }
    )?;
    Some(Some(particles))
}

fn sizes(table: &Table<'_>, findings: &mut Findings) -> Option<Sizes> {
    let count: Option<Option<usize>> = table.read("count", findings);
    let ratio: Option<Option<f64>> = table.read("size_ratio", findings);
    let smallest: Option<Option<f64>> = table.read("smallest_diameter", findings);
    let largest: Option<Option<f64>> = table.read("largest_diameter", findings);
    if table.has("count") {
        if let Some(key) = ["smallest_diameter", "largest_diameter"].into_iter().find(|key| table.has(key)) {
            return table.exclude(key, "`count`", findings);
        }
        return Some(Sizes::Count { count: count??, ratio: ratio?.unwrap_or(SIZE_RATIO) });
    }
    if table.has("size_ratio") {
        return table.exclude("size_ratio", "diameters", findings);
    }
    let missing = ["smallest_diameter", "largest_diameter"].into_iter().filter(|key| !table.has(key));
    match missing.collect::<Vec<_>>()[..] {
        [] => Some(()),
        [one] => table.need(one, findings),
        _ => table.need("count", findings),
    }?;
    let (smallest, largest) = (smallest??, largest??);
    if smallest > largest {
        return findings.refuse(
            "B214",
            table.place("smallest_diameter"),
            "the smallest diameter is larger than the largest",
            "above `largest_diameter`",
            "exchange the two",
        );
    }
    Some(Sizes::Diameters { smallest, largest })
}

fn no_tension(file: &Table<'_>, key: &str, joint: Option<&Joint>, findings: &mut Findings) {
    if joint.is_some_and(|joint| joint.tensile_strength > 0.0) {
        let Some(table) = file.known(key) else { return };
        findings.error(
            "B215",
            table.place("tensile_strength"),
            "contacts of particles have no tensile strength",
            "particles part freely",
            "remove it; cohesion acts while a contact is closed",
        );
    }
}
