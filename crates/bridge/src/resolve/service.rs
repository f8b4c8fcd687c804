//! What only the finite element model reads.

use super::materials::maybe;
use crate::findings::Findings;
use crate::model::Cover;
use crate::service::{AbutmentFill, Cone, FillContact, HaunchFill, MeshPlan, Mortar, Service, Soil, SoilLaw, Springs};
use crate::tree::Table;

/// Everything; a file that says nothing of it has the defaults.
pub(super) fn service(file: &Table<'_>, cover: Option<&Cover>, findings: &mut Findings) -> Option<Service> {
    let mesh = part(file, "mesh", MeshPlan::default(), mesh, findings);
    let start = cover.map_or_else(Soil::default, |cover| Service::of_cover(cover).fill);
    let fill = part(file, "fill", start, |table, findings| soil(table, start, findings), findings);
    // What another table leaves out is as the fill is; what is wrong with the fill has been said.
    let usual = fill.unwrap_or(start);
    let haunch_fill = part(file, "haunch_fill", None, |table, findings| haunch(table, usual, findings), findings);
    let behind = AbutmentFill { extent: None, soil: usual };
    let abutment_fill =
        part(file, "abutment_fill", behind, |table, findings| abutment(table, usual, findings), findings);
    let mortar = part(file, "mortar", Mortar::default(), mortar, findings);
    let fill_contact = part(file, "fill_contact", FillContact::default(), contact, findings);
    Some(Service {
        mesh: mesh?,
        fill: fill?,
        haunch_fill: haunch_fill?,
        abutment_fill: abutment_fill?,
        mortar: mortar?,
        fill_contact: fill_contact?,
    })
}

/// A table that may be missing.
fn part<T>(
    file: &Table<'_>,
    key: &str,
    missing: T,
    read: impl FnOnce(&Table<'_>, &mut Findings) -> Option<T>,
    findings: &mut Findings,
) -> Option<T> {
    match file.has(key) {
        true => read(&file.table(key, findings)?, findings),
        false => Some(missing),
    }
}

/// A quantity that may be missing.
fn quantity(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<Option<f64>> {
    let value = table.quantity(key, findings);
    maybe(table, key, value)
}

fn mesh(table: &Table<'_>, findings: &mut Findings) -> Option<MeshPlan> {
    let size = quantity(table, "size", findings);
    let nodes = table.count("ring_nodes", findings);
    let side_distance = quantity(table, "side_distance", findings);
    Some(MeshPlan {
        size: size?,
        ring_nodes: maybe(table, "ring_nodes", nodes)?
            .map_or(MeshPlan::default().ring_nodes, |n| usize::try_from(n).unwrap_or(usize::MAX)),
        side_distance: side_distance?,
    })
}

/// A soil; what the table leaves out is as `otherwise`.
fn soil(table: &Table<'_>, otherwise: Soil, findings: &mut Findings) -> Option<Soil> {
    let elastic_modulus = quantity(table, "elastic_modulus", findings);
    let poisson = table.number("poisson_ratio", findings);
    let density = quantity(table, "density", findings);
    let friction_angle = quantity(table, "friction_angle", findings);
    let cohesion = quantity(table, "cohesion", findings);
    let dilatancy_angle = quantity(table, "dilatancy_angle", findings);
    let tension_cutoff = quantity(table, "tension_cutoff", findings);
    let cone = table.word("cone", findings);
    let law = table.word("law", findings);
    let soil = Soil {
        elastic_modulus: elastic_modulus?.or(otherwise.elastic_modulus),
        poisson_ratio: maybe(table, "poisson_ratio", poisson)?.or(otherwise.poisson_ratio),
        density: density?.or(otherwise.density),
        friction_angle: friction_angle?.or(otherwise.friction_angle),
        cohesion: cohesion?.or(otherwise.cohesion),
        dilatancy_angle: dilatancy_angle?.unwrap_or(otherwise.dilatancy_angle),
        tension_cutoff: tension_cutoff?.or(otherwise.tension_cutoff),
        cone: maybe(table, "cone", cone)?.map_or(otherwise.cone, |word| match word {
            "extension" => Cone::Extension,
            "compression" => Cone::Compression,
            "inner" => Cone::Inner,
            _ => Cone::PlaneStrain,
        }),
        law: maybe(table, "law", law)?.map_or(otherwise.law, |word| match word {
            "mohr-coulomb" => SoilLaw::MohrCoulomb,
            "elastic" => SoilLaw::Elastic,
            _ => SoilLaw::DruckerPrager,
        }),
    };
    outer_cone(table, &soil, findings);
    dilates_as_it_rubs(table, &soil, findings).then_some(soil)
}

/// A cone that makes the soil stronger than the file says it is.
fn outer_cone(table: &Table<'_>, soil: &Soil, findings: &mut Findings) {
    let (Some([acts, cohesion]), Some(friction)) =
        (soil.acts_with().filter(|_| table.has("cone")), soil.friction_angle)
    else {
        return;
    };
    let times = soil
        .cohesion
        .filter(|own| *own > 0.0)
        .map_or(String::new(), |own| format!(", and its cohesion {:.2} times as much", cohesion / own));
    findings.warning(
        "P070",
        table.place("cone"),
        "the cone of triaxial compression makes the fill stronger than its friction angle",
        format!("in plane strain {:.1} deg act as {:.1} deg{times}", friction.to_degrees(), acts.to_degrees()),
        "leave `cone` out for the cone that gives the soil's own failure load in plane strain",
    );
}

/// A soil that dilated by more than its friction would give work away for nothing.
fn dilates_as_it_rubs(table: &Table<'_>, soil: &Soil, findings: &mut Findings) -> bool {
    let Some(friction) = soil.friction_angle.filter(|friction| soil.dilatancy_angle > friction * (1.0 + 1e-9)) else {
        return true;
    };
    findings.error(
        "B107",
        table.place(if table.has("dilatancy_angle") { "dilatancy_angle" } else { "friction_angle" }),
        "the fill dilates by more than its angle of friction",
        format!("the angle of friction is {:.1} deg", friction.to_degrees()),
        "give a dilatancy angle of at most the angle of friction; 0 deg is common for fill",
    );
    false
}

fn haunch(table: &Table<'_>, usual: Soil, findings: &mut Findings) -> Option<Option<HaunchFill>> {
    let height = table.quantity("height", findings);
    let soil = soil(table, usual, findings);
    Some(Some(HaunchFill { height: height?.value, soil: soil? }))
}

fn abutment(table: &Table<'_>, usual: Soil, findings: &mut Findings) -> Option<AbutmentFill> {
    let extent = quantity(table, "extent", findings);
    let soil = soil(table, usual, findings);
    Some(AbutmentFill { extent: extent?, soil: soil? })
}

fn mortar(table: &Table<'_>, findings: &mut Findings) -> Option<Mortar> {
    let elastic_modulus = quantity(table, "elastic_modulus", findings);
    let thickness = quantity(table, "thickness", findings);
    let lift_off = quantity(table, "lift_off", findings);
    let shear_strength = quantity(table, "shear_strength", findings);
    let springs = table.word("springs", findings);
    Some(Mortar {
        elastic_modulus: elastic_modulus?,
        thickness: thickness?,
        lift_off: lift_off?.unwrap_or(0.0),
        shear_strength: shear_strength?,
        springs: match maybe(table, "springs", springs)? {
            Some("nodal") => Springs::Nodal,
            Some("interface") => Springs::Interface,
            _ => Springs::Equal,
        },
    })
}

fn contact(table: &Table<'_>, findings: &mut Findings) -> Option<FillContact> {
    let friction = table.number("friction_coefficient", findings);
    let separation = table.flag("separation", findings);
    let stiffness = quantity(table, "stiffness", findings);
    Some(FillContact {
        friction_coefficient: maybe(table, "friction_coefficient", friction)?,
        separation: maybe(table, "separation", separation)?.unwrap_or(true),
        stiffness: stiffness?,
    })
}
