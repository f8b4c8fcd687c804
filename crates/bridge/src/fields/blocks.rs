//! Cards of the block model file: bodies that are drawn or listed, instead of a bridge that is described.

use super::material::JOINT_FIELDS;
use super::{Field, Kind, Section, Word, material, plan};
use crate::quantity::Dimension::{Acceleration, Length};

const ROLES: &[Word] = &[
    Word { word: "block", doc: "closed outlines are free blocks" },
    Word { word: "support", doc: "closed outlines are blocks that do not move" },
    Word { word: "particles", doc: "circles are particles" },
    Word { word: "ignore", doc: "the layer is not read" },
];

const BLOCK_ROLES: &[Word] =
    &[Word { word: "block", doc: "free to move" }, Word { word: "support", doc: "does not move" }];

/// Units that drawings are made in; [`crate::quantity`] knows their size.
const UNITS: &[Word] = &[
    Word { word: "m", doc: "metres" },
    Word { word: "cm", doc: "centimetres" },
    Word { word: "mm", doc: "millimetres" },
    Word { word: "ft", doc: "feet" },
    Word { word: "in", doc: "inches" },
];

const CONCAVE: &[Word] = &[
    Word { word: "refuse", doc: "an error that names the concave corner" },
    Word { word: "cut", doc: "convex pieces, each a block of its own; a warning says so" },
];

static MODEL: Section = Section {
    path: "model",
    doc: "The model as a whole.",
    fields: &[
        Field::new("name", Kind::Text, "name of the model, for titles", "Arch of the old mill"),
        Field::new("width", Kind::Quantity(Length), "width that forces over the whole width are spread over", "8.30 m")
            .positive()
            .at_most(100.0)
            .default("1 m"),
        Field::new("gravity", Kind::Quantity(Acceleration), "acceleration of gravity", "9.81 m/s^2")
            .positive()
            .at_most(30.0)
            .default("9.81 m/s^2"),
    ],
};

static LAYER: Section = Section {
    path: "drawing.layer",
    doc: "What is on a layer of the drawing. Every layer with outlines or circles needs one.",
    fields: &[
        Field::new("name", Kind::Text, "name of the layer in the drawing; capitals do not count", "RING"),
        Field::new("role", Kind::Word(ROLES), "what is on the layer", "block"),
        Field::new("material", Kind::Text, "name of the material of what is on the layer", "sandstone")
            .only("role", &["block", "support", "particles"]),
    ],
};

static DRAWING: Section = Section {
    path: "drawing",
    doc: "A drawing (DXF with text, R12 or later) whose closed outlines are blocks and whose circles are particles.",
    fields: &[
        Field::new("file", Kind::Text, "path of the drawing, relative to this file", "bridge.dxf"),
        Field::new("unit", Kind::Word(UNITS), "unit of the drawing, in place of what its header says", "mm")
            .optional("the unit in the header of the drawing; an error asks for it if there is none"),
        Field::new("chord_tolerance", Kind::Quantity(Length), "how far a chord may lie from its curve", "1 mm")
            .positive()
            .at_most(1.0)
            .default("1 mm"),
        Field::new("gap_tolerance", Kind::Quantity(Length), "largest distance of ends that are meant to meet", "1 mm")
            .positive()
            .at_most(1.0)
            .default("1 mm"),
        Field::new("concave", Kind::Word(CONCAVE), "how an outline that is not convex is treated", "refuse")
            .default("refuse"),
        Field::new("layer", Kind::Tables(&LAYER), "What is on its layers.", ""),
    ],
};

static MATERIAL: Section = Section {
    path: "material",
    doc: "A material of blocks or particles.",
    fields: &[
        Field::new("name", Kind::Text, "name that layers, blocks and joints use", "sandstone"),
        material::MASONRY.fields[0],
        material::MASONRY.fields[1],
        material::MASONRY.fields[2],
        material::MASONRY.fields[3],
        material::MASONRY.fields[4],
    ],
};

static JOINT: Section = Section {
    path: "joint",
    doc: "Joints between two materials; without `first` and `second`, between all pairs that no other [[joint]] names. The \
          other keys are those of [joint] in a bridge file.",
    fields: &[
        Field::new("first", Kind::Text, "name of the material on one side", "sandstone")
            .optional("all pairs of materials that no other [[joint]] names"),
        Field::new("second", Kind::Text, "name of the material on the other side", "granite")
            .optional("the same material as `first`"),
        JOINT_FIELDS[0],
        JOINT_FIELDS[1],
        JOINT_FIELDS[2],
        JOINT_FIELDS[3],
        JOINT_FIELDS[4],
        JOINT_FIELDS[5],
        JOINT_FIELDS[6],
        JOINT_FIELDS[7],
        Field::new(
            "least_length",
            Kind::Quantity(Length),
            "least length of a contact point when it is updated",
            "0.0711 m",
        )
        .positive()
        .optional("a tenth of the side of the smallest block, as if it were square"),
    ],
};

static BLOCK: Section = Section {
    path: "block",
    doc: "A block listed in the file, beside or in place of a drawing.",
    fields: &[
        Field::new("name", Kind::Text, "name that loads and tables use", "keystone")
            .optional("named after its layer, counted from 1"),
        Field::new("layer", Kind::Text, "layer that it is drawn on", "RING").default("BLOCKS"),
        Field::new("material", Kind::Text, "name of its material", "sandstone"),
        Field::new("role", Kind::Word(BLOCK_ROLES), "whether it may move", "block").default("block"),
        Field::new(
            "outline_m",
            Kind::Rows(2),
            "corners of the convex outline, x and y in metres",
            "[[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.0, 0.5]]",
        ),
    ],
};

static PARTICLES: Section = Section {
    path: "particles",
    doc: "Circular particles listed in the file, beside or in place of a drawing.",
    fields: &[
        Field::new("layer", Kind::Text, "layer that they are drawn on", "FILL").default("PARTICLES"),
        Field::new("material", Kind::Text, "name of their material", "gravel"),
        Field::new("circles_m", Kind::Rows(3), "centre and radius of each, x, y and r in metres", "[[2.0, 3.1, 0.05]]"),
    ],
};

static LOAD: Section = Section {
    path: "load",
    doc: "A force on one block, or on all free blocks of a layer. The loads that are not permanent grow together to \
          collapse. Each follows its block and keeps its direction.",
    fields: &[
        Field::new("name", Kind::Text, "name of the load", "knife edge").optional("numbered"),
        Field::new("x", Kind::Quantity(Length), "where the force acts, to the right", "4.575 m")
            .optional("with `block` or `layer`"),
        Field::new("y", Kind::Quantity(Length), "where the force acts, up", "3.10 m")
            .optional("with `block` or `layer`"),
        Field::new("block", Kind::Text, "name of the block on whose centroid it acts", "keystone")
            .optional("with a point or `layer`"),
        Field::new("layer", Kind::Text, "layer whose free blocks share it in proportion to their mass", "RING")
            .optional("with a point or `block`"),
        Field::new("down", Kind::LineLoad, "force downwards, per metre of width or over the whole width", "1 kN/m")
            .optional("no vertical part"),
        Field::new(
            "right",
            Kind::LineLoad,
            "force to the right, per metre of width or over the whole width",
            "0.2 kN/m",
        )
        .optional("no horizontal part"),
        Field::new("permanent", Kind::Flag, "whether it is there from the start, and does not grow", "false")
            .default("false"),
    ],
};

/// The whole block model file.
pub static FILE: Section = Section {
    path: "",
    doc: "Blocks and particles, listed or drawn, and what to analyse. Quantities are text with a unit; coordinates of \
          outlines are bare numbers in metres, as their keys say.",
    fields: &[
        Field::new("model", Kind::Table(&MODEL), "The model as a whole.", ""),
        Field::new("drawing", Kind::Table(&DRAWING), "A drawing of the blocks.", "").optional("all blocks are listed"),
        Field::new("material", Kind::Tables(&MATERIAL), "Materials of blocks and particles.", ""),
        Field::new("joint", Kind::Tables(&JOINT), "Joints by pairs of materials.", ""),
        Field::new("block", Kind::Tables(&BLOCK), "Blocks listed in the file.", "").optional("all blocks are drawn"),
        Field::new("particles", Kind::Tables(&PARTICLES), "Particles listed in the file.", "")
            .optional("all particles are drawn"),
        Field::new("load", Kind::Tables(&LOAD), "Forces on the blocks.", "").optional("possible only for `check`"),
        Field::new("analysis", Kind::Table(&plan::ANALYSIS), "What to analyse, and how exactly.", "")
            .optional("limit analysis of the load, with the defaults"),
    ],
};
