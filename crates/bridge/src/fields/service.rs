//! What only the finite element model reads: mesh, soils, mortar, contact of fill with masonry.

use crate::card::{Field, Section, each_optional, joined};
use crate::cards::*;
use crate::findings::Findings;
use crate::library::material;
use crate::model::Cover;
use crate::service::{AbutmentFill, FillContact, HaunchFill, MeshPlan, Mortar, Service, Soil};
use crate::tree::Table;
use crate::values::read;

pub(super) static MESH: Section = Section {
    path: "mesh",
    doc: "How fine the finite element mesh is and how far it reaches.",
    fields: MeshPlan::CARDS,
};

/// Those of another soil, which are as [fill] says where they are left out.
const OTHER_SOIL: &[Field] = &each_optional::<9>(Soil::CARDS, "as [fill] says");

pub(super) static FILL: Section = Section {
    path: "fill",
    doc: "Fill between the rings and the surface, in the finite element model.",
    fields: &joined::<10>(&[Soil::CARDS, &[material("old-fill")]]),
};

pub(super) static HAUNCH_FILL: Section = Section {
    path: "haunch_fill",
    doc: "Fill of the haunches up to a level, over piers and abutments, where it differs from [fill].",
    fields: &joined::<10>(&[
        &[length("height", "level of its upper face above the springings", "1.0 m").positive_up_to(200.0)],
        OTHER_SOIL,
    ]),
};

pub(super) static ABUTMENT_FILL: Section = Section {
    path: "abutment_fill",
    doc: "Fill behind the abutments, from their foundation to the surface, where it differs from [fill].",
    fields: &joined::<11>(&[
        &[length("extent", "how far it reaches behind the abutment's back", "6 m")
            .positive_up_to(1000.0)
            .optional("to the side boundary")],
        OTHER_SOIL,
        &[material("old-fill")],
    ]),
};

pub(super) static MORTAR: Section = Section {
    path: "mortar",
    doc: "Mortar between voussoirs and at the springings, in the finite element model.",
    fields: &joined::<6>(&[Mortar::CARDS, &[material("weak-mortar")]]),
};

pub(super) static FILL_CONTACT: Section = Section {
    path: "fill_contact",
    doc: "Contact of fill with rings, piers and abutments, in the finite element model.",
    fields: FillContact::CARDS,
};

/// Everything; a file that says nothing of it has the defaults.
pub(crate) fn service(file: &Table<'_>, cover: Option<&Cover>, findings: &mut Findings) -> Option<Service> {
    let mesh = file.part("mesh", findings, MeshPlan::of);
    let lowest = cover.and_then(|cover| cover.layers.first()).map(|layer| layer.density);
    let density = lowest.filter(|density| *density > 0.0);
    let fill = file.part("fill", findings, |t, f| soil(t, density, f));
    // What another table leaves out is as the fill is; what is wrong with the fill has been said.
    let usual = file.known("fill").unwrap_or(file.without(&FILL));
    let haunch_fill = file.optional("haunch_fill", findings, |table, findings| {
        let soil = soil(&table.over(&usual), density, findings);
        read!(table, findings, HaunchFill { height; soil: soil? })
    });
    let abutment_fill = file.part("abutment_fill", findings, |table, findings| {
        let soil = soil(&table.over(&usual), density, findings);
        read!(table, findings, AbutmentFill { extent; soil: soil? })
    });
    let mortar = file.part("mortar", findings, Mortar::of);
    let fill_contact = file.part("fill_contact", findings, FillContact::of);
    Some(Service {
        mesh: mesh?,
        fill: fill?,
        haunch_fill: haunch_fill?,
        abutment_fill: abutment_fill?,
        mortar: mortar?,
        fill_contact: fill_contact?,
    })
}

/// A soil; of this density where no table gives one.
fn soil(table: &Table<'_>, density: Option<f64>, findings: &mut Findings) -> Option<Soil> {
    let mut soil = Soil::of(table, findings)?;
    soil.density = soil.density.or(density);
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
