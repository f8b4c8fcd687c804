//! What only the finite element model reads: mesh, soils, mortar, contact of fill with masonry.

use crate::card::{Field, Section, each_optional, joined};
use crate::cards::*;
use crate::findings::Findings;
use crate::model::Cover;
use crate::service::{AbutmentFill, Cone, FillContact, HaunchFill, MeshPlan, Mortar, Service, Soil, SoilLaw, Springs};
use crate::tree::Table;
use crate::values::read;

pub(super) static MESH: Section = Section {
    path: "mesh",
    doc: "How fine the finite element mesh is and how far it reaches.",
    fields: &[
        length(
            "size",
            "length of an element near the rings and the surface; elements grow towards the boundaries",
            "0.20 m",
        )
        .between(0.005, 10.0)
        .optional("half the thickness of the thinnest ring"),
        count("ring_nodes", "nodes across the depth of a ring, and springs across a joint", "7")
            .between(2.0, 100.0)
            .default("7"),
        length("side_distance", "distance from the back of an abutment to the side boundary", "15 m")
            .positive_up_to(1000.0)
            .optional("twice the height from the lowest foundation to the surface"),
    ],
};

/// Keys of a soil, each left out as its card says.
const SOIL: [Field; 9] = [
    stress("elastic_modulus", "Young's modulus of the fill", "110 MPa")
        .positive()
        .optional("unknown; `respond` needs it"),
    number("poisson_ratio", "Poisson's ratio of the fill", "0.19")
        .between(0.0, 0.4999)
        .optional("unknown; `respond` needs it"),
    density("density", "mass density of the fill", "1800 kg/m^3")
        .positive()
        .optional("that of the lowest layer of [[cover]]"),
    angle("friction_angle", "angle of friction of the fill", "30 deg")
        .between(0.0, 1.2)
        .optional("unknown; `respond` needs it unless the fill is elastic"),
    stress("cohesion", "cohesion of the fill", "10 kPa")
        .at_least(0.0)
        .optional("unknown; `respond` needs it unless the fill is elastic"),
    angle("dilatancy_angle", "angle of dilatancy of the fill", "0 deg").between(0.0, 1.2).default("0 deg"),
    stress("tension_cutoff", "largest tension in the fill", "0 kPa")
        .at_least(0.0)
        .optional("no limit except the apex of cone or pyramid"),
    word::<Cone>("cone", "how the Drucker-Prager cone is matched to Mohr-Coulomb", "inner")
        .default(Cone::PlaneStrain.word()),
    word::<SoilLaw>("law", "yield criterion of the fill", "mohr-coulomb").default(SoilLaw::DruckerPrager.word()),
];

/// Those of another soil, which are as [fill] says where they are left out.
const OTHER_SOIL: &[Field] = &each_optional(SOIL, "as [fill] says");

pub(super) static FILL: Section = Section {
    path: "fill",
    doc: "Fill between the rings and the surface, in the finite element model.",
    fields: &SOIL,
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
    fields: &joined::<10>(&[
        &[length("extent", "how far it reaches behind the abutment's back", "6 m")
            .positive_up_to(1000.0)
            .optional("to the side boundary")],
        OTHER_SOIL,
    ]),
};

pub(super) static MORTAR: Section = Section {
    path: "mortar",
    doc: "Mortar between voussoirs and at the springings, in the finite element model.",
    fields: &[
        stress("elastic_modulus", "Young's modulus of the mortar", "1.25 GPa")
            .positive()
            .optional("unknown; `respond` needs it"),
        length("thickness", "thickness of a joint", "12.5 mm")
            .positive_up_to(1.0)
            .optional("unknown; `respond` needs it"),
        force("lift_off", "tension at which a spring lifts off, in a strip one metre wide", "1 kN")
            .at_least(0.0)
            .default("0 kN"),
        stress("shear_strength", "shear strength of the mortar", "1 MPa")
            .at_least(0.0)
            .optional("friction and cohesion of [joint]"),
        word::<Springs>("springs", "how the stress across a joint is summed", "interface")
            .default(Springs::Equal.word()),
    ],
};

pub(super) static FILL_CONTACT: Section = Section {
    path: "fill_contact",
    doc: "Contact of fill with rings, piers and abutments, in the finite element model.",
    fields: &[
        number("friction_coefficient", "coefficient of friction", "0.4")
            .between(0.0, 10.0)
            .optional("unknown; `respond` needs it"),
        flag("separation", "whether fill and masonry may separate", "false").default("true"),
        joint_stiffness("stiffness", "normal stiffness per area of the contact", "1 GPa/m")
            .positive()
            .optional("from the fill's modulus and the size of its elements"),
    ],
};

/// Everything; a file that says nothing of it has the defaults.
pub(crate) fn service(file: &Table<'_>, cover: Option<&Cover>, findings: &mut Findings) -> Option<Service> {
    let mesh = file.part("mesh", findings, |t, f| read!(t, f, MeshPlan { size, ring_nodes, side_distance }));
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
    let mortar = file.part("mortar", findings, |table, findings| {
        read!(table, findings, Mortar { elastic_modulus, thickness, lift_off, shear_strength, springs })
    });
    let fill_contact = file.part("fill_contact", findings, |table, findings| {
        read!(table, findings, FillContact { friction_coefficient, separation, stiffness })
    });
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
