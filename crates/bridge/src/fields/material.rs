//! Masonry and joints.

use crate::card::{Field, Section, joined};
use crate::cards::*;
use crate::findings::Findings;
use crate::library::material;
use crate::model::{Joint, JointContact, JointStiffness, Masonry};
use crate::tree::Table;
use crate::values::read;

/// Friction angles end below the vertical [rad]: 89 degrees.
const STEEPEST: f64 = 89.0 / 180.0 * std::f64::consts::PI;

pub(super) static MASONRY: Section = Section {
    path: "masonry",
    doc: "Masonry of rings and piers.",
    fields: &joined::<6>(&[Masonry::CARDS, &[material("sandstone")]]),
};

pub(super) const JOINT_FIELDS: &[Field] = &[
    joint_stiffness(
        "normal_stiffness",
        "normal stiffness per area of the whole contact, joint and blocks together",
        "4.84 GPa/m",
    )
    .positive()
    .optional(
        "given by `mortar_normal_stiffness`; without both, equilibrium paths take a tenth of `elastic_modulus` over the longest \
         voussoir, and the discrete element method refuses",
    ),
    joint_stiffness(
        "mortar_normal_stiffness",
        "normal stiffness per area of the joint alone; the blocks come in by the series rule",
        "5.4 GPa/m",
    )
    .positive()
    .optional("given by `normal_stiffness`"),
    joint_stiffness(
        "shear_stiffness",
        "shear stiffness per area of the whole contact, joint and blocks together",
        "0.573 GPa/m",
    )
    .positive()
    .optional("given by `mortar_shear_stiffness`; the discrete element method needs one of them"),
    joint_stiffness(
        "mortar_shear_stiffness",
        "shear stiffness per area of the joint alone; the blocks come in by the series rule",
        "0.59 GPa/m",
    )
    .positive()
    .optional("given by `shear_stiffness`"),
    angle("friction_angle", "angle of friction in the joint", "35.6 deg").between(0.0, STEEPEST),
    stress("cohesion", "cohesion in the joint", "0 kPa").at_least(0.0),
    stress("tensile_strength", "tensile strength of the joint", "0 kPa")
        .at_least(0.0)
        .optional("the joint opens freely"),
    length("fixed_length", "length of joint that one contact point represents when it is kept fixed", "0.3455 m")
        .positive()
        .optional("half the distance between the contact points of the joint"),
    length("least_length", "least length of a contact point when it is updated", "0.0711 m")
        .positive()
        .optional("a tenth of the ring's thickness"),
];

pub(super) static JOINT: Section = Section {
    path: "joint",
    doc: "Joints between voussoirs, at springings and between the courses of piers. Stiffness is that of the contact as a \
          whole (`normal_stiffness`), or of the mortar joint alone (`mortar_normal_stiffness`), to which the deformation \
          of the blocks is added by 1/k = 1/k' + l/E (Rouxinol, Providência and Lemos, eq. 1).",
    fields: &joined::<11>(&[
        JOINT_FIELDS,
        &[
            material("old-joints"),
            word::<JointContact>("contact", "where all joints of the bridge carry what presses them", "distributed")
                .optional("\"points\" with methods \"dem\" and \"fe\", \"distributed\" with method \"path\""),
        ],
    ]),
};

pub(super) static WALL_JOINT: Section = Section {
    path: "wall_joint",
    doc: "Joints between the bricks of spandrel walls, and between bricks and rings, with the same keys as [joint].",
    fields: JOINT_FIELDS,
};

pub(super) static PARTICLE_JOINT: Section = Section {
    path: "particle_joint",
    doc: "Contacts between particles, with the keys of [joint]: without tensile strength; `fixed_length` is the mean of the \
          two diameters where it is not given.",
    fields: JOINT_FIELDS,
};

pub(super) static PARTICLE_BLOCK_JOINT: Section = Section {
    path: "particle_block_joint",
    doc: "Contacts of particles with voussoirs, abutments and loading blocks, with the keys of [joint]: without tensile \
          strength; `fixed_length` is the particle's diameter where it is not given.",
    fields: JOINT_FIELDS,
};

pub(super) static RING_JOINT: Section = Section {
    path: "ring_joint",
    doc: "Joints between the rings of a span, with the same keys as [joint].",
    fields: &joined::<10>(&[JOINT_FIELDS, &[material("old-joints")]]),
};

pub(crate) fn joint(file: &Table<'_>, name: &str, findings: &mut Findings) -> Option<Joint> {
    joint_of(&file.table(name, findings)?, findings)
}

/// The joint that a table describes.
pub(crate) fn joint_of(table: &Table<'_>, findings: &mut Findings) -> Option<Joint> {
    let normal_stiffness = stiffness(table, "normal_stiffness", "mortar_normal_stiffness", findings);
    let shear_stiffness = stiffness(table, "shear_stiffness", "mortar_shear_stiffness", findings);
    let tensile_strength: Option<Option<f64>> = table.read("tensile_strength", findings);
    read!(
        table,
        findings,
        Joint {
            friction_angle,
            cohesion,
            fixed_length,
            least_length;
            normal_stiffness: normal_stiffness?,
            shear_stiffness: shear_stiffness?,
            tensile_strength: tensile_strength?.unwrap_or(0.0),
        }
    )
}

/// The stiffness of the contact, or that of the mortar with the blocks in series.
fn stiffness(
    table: &Table<'_>,
    contact: &str,
    mortar: &str,
    findings: &mut Findings,
) -> Option<Option<JointStiffness>> {
    let whole: Option<Option<f64>> = table.read(contact, findings);
    let alone: Option<Option<f64>> = table.read(mortar, findings);
    if table.has(contact) && table.has(mortar) {
        return table.exclude(mortar, &format!("`{contact}`"), findings);
    }
    let alone = alone?.map(JointStiffness::Series);
    Some(alone.or(whole?.map(JointStiffness::Contact)))
}
