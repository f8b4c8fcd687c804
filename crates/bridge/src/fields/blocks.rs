//! The block model file: bodies that are drawn or listed, instead of a bridge that is described.

use super::material::JOINT_FIELDS;
use super::structure::General;
use super::{material, plan};
use crate::blocks::{
    BlockFile, BodyLoad, DrawingPart, ListedBlock, ListedParticles, MappedLayer, Material, MaterialJoint, Role, Target,
};
use crate::card::{Field, Kind, Section, joined};
use crate::cards::*;
use crate::choice::choice;
use crate::findings::Findings;
use crate::model::{Analysis, JointStiffness, Masonry, Method};
use crate::quantity;
use crate::tree::{At, Table, nearest};
use crate::values::read;

choice! {
    /// Whether a listed block may move.
    enum BlockRole {
        /// free to move
        Block = "block",
        /// does not move
        Support = "support",
    }
}

choice! {
    /// Units that drawings are made in; [`crate::quantity`] knows their size.
    enum DrawingUnit {
        /// metres
        Metre = "m",
        /// centimetres
        Centimetre = "cm",
        /// millimetres
        Millimetre = "mm",
        /// feet
        Foot = "ft",
        /// inches
        Inch = "in",
    }
}

choice! {
    /// What becomes of an outline that is not convex.
    enum Concave {
        /// an error that names the concave corner
        Refuse = "refuse",
        /// convex pieces, each a block of its own; a warning says so
        Cut = "cut",
    }
}

static MODEL: Section = Section {
    path: "model",
    doc: "The model as a whole.",
    fields: &[
        text("name", "name of the model, for titles", "Arch of the old mill"),
        length("width", "width that forces over the whole width are spread over", "8.30 m")
            .positive_up_to(100.0)
            .default("1 m"),
        acceleration("gravity", "acceleration of gravity", "9.81 m/s^2").positive_up_to(30.0).default("9.81 m/s^2"),
    ],
};

static LAYER: Section = Section {
    path: "drawing.layer",
    doc: "What is on a layer of the drawing. Every layer with outlines or circles needs one.",
    fields: &[
        text("name", "name of the layer in the drawing; capitals do not count", "RING"),
        word::<Role>("role", "what is on the layer", "block"),
        text("material", "name of the material of what is on the layer", "sandstone")
            .only("role", &["block", "support", "particles"]),
    ],
};

static DRAWING: Section = Section {
    path: "drawing",
    doc: "A drawing (DXF with text, R12 or later) whose closed outlines are blocks and whose circles are particles.",
    fields: &[
        text("file", "path of the drawing, relative to this file", "bridge.dxf"),
        word::<DrawingUnit>("unit", "unit of the drawing, in place of what its header says", "mm")
            .optional("the unit in the header of the drawing; an error asks for it if there is none"),
        length("chord_tolerance", "how far a chord may lie from its curve", "1 mm").positive_up_to(1.0).default("1 mm"),
        length("gap_tolerance", "largest distance of ends that are meant to meet", "1 mm")
            .positive_up_to(1.0)
            .default("1 mm"),
        word::<Concave>("concave", "how an outline that is not convex is treated", "refuse")
            .default(Concave::Refuse.word()),
        tables("layer", &LAYER, "What is on its layers."),
    ],
};

static MATERIAL: Section = Section {
    path: "material",
    doc: "A material of blocks or particles.",
    fields: &joined::<6>(&[&[text("name", "name that layers, blocks and joints use", "sandstone")], Masonry::CARDS]),
};

static JOINT: Section = Section {
    path: "joint",
    doc: "Joints between two materials; without `first` and `second`, between all pairs that no other [[joint]] names. The \
          other keys are those of [joint] in a bridge file.",
    fields: &joined::<11>(&[
        &[
            text("first", "name of the material on one side", "sandstone")
                .optional("all pairs of materials that no other [[joint]] names"),
            text("second", "name of the material on the other side", "granite")
                .optional("the same material as `first`"),
        ],
        JOINT_FIELDS.split_at(8).0,
        &[JOINT_FIELDS[8].optional("a tenth of the side of the smallest block, as if it were square")],
    ]),
};

static BLOCK: Section = Section {
    path: "block",
    doc: "A block listed in the file, beside or in place of a drawing.",
    fields: &[
        text("name", "name that loads and tables use", "keystone").optional("named after its layer, counted from 1"),
        text("layer", "layer that it is drawn on", "RING").default("BLOCKS"),
        text("material", "name of its material", "sandstone"),
        word::<BlockRole>("role", "whether it may move", "block").default(BlockRole::Block.word()),
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
        text("layer", "layer that they are drawn on", "FILL").default("PARTICLES"),
        text("material", "name of their material", "gravel"),
        Field::new("circles_m", Kind::Rows(3), "centre and radius of each, x, y and r in metres", "[[2.0, 3.1, 0.05]]"),
    ],
};

static LOAD: Section = Section {
    path: "load",
    doc: "A force on one block, or on all free blocks of a layer. The loads that are not permanent grow together to \
          collapse. Each follows its block and keeps its direction.",
    fields: &[
        text("name", "name of the load", "knife edge").optional("numbered"),
        length("x", "where the force acts, to the right", "4.575 m").optional("with `block` or `layer`"),
        length("y", "where the force acts, up", "3.10 m").optional("with `block` or `layer`"),
        text("block", "name of the block on whose centroid it acts", "keystone").optional("with a point or `layer`"),
        text("layer", "layer whose free blocks share it in proportion to their mass", "RING")
            .optional("with a point or `block`"),
        line_load("down", "force downwards, per metre of width or over the whole width", "1 kN/m")
            .optional("no vertical part"),
        line_load("right", "force to the right, per metre of width or over the whole width", "0.2 kN/m")
            .optional("no horizontal part"),
        flag("permanent", "whether it is there from the start, and does not grow", "false").default("false"),
    ],
};

/// The whole block model file.
pub static FILE: Section = Section {
    path: "",
    doc: "Blocks and particles, listed or drawn, and what to analyse. Quantities are text with a unit; coordinates of \
          outlines are bare numbers in metres, as their keys say.",
    fields: &[
        table("model", &MODEL, "The model as a whole."),
        table("drawing", &DRAWING, "A drawing of the blocks.").optional("all blocks are listed"),
        tables("material", &MATERIAL, "Materials of blocks and particles."),
        tables("joint", &JOINT, "Joints by pairs of materials."),
        tables("block", &BLOCK, "Blocks listed in the file.").at_most(100_000.0).optional("all blocks are drawn"),
        tables("particles", &PARTICLES, "Particles listed in the file.")
            .at_most(100_000.0)
            .optional("all particles are drawn"),
        tables("load", &LOAD, "Forces on the blocks.").optional("possible only for `check`"),
        table("analysis", &plan::ANALYSIS, "What to analyse, and how exactly.")
            .optional("limit analysis of the load, with the defaults"),
    ],
};

/// Reads the whole file. There is a value only if nothing is missing.
pub(crate) fn resolve(file: &Table<'_>, findings: &mut Findings) -> Option<BlockFile> {
    let general =
        file.part("model", findings, |table, findings| read!(table, findings, General { name, width, gravity }));
    let materials = materials(file, findings);
    let names: Vec<String> = materials.iter().flatten().map(|material| material.name.clone()).collect();
    let width = general.as_ref().map(|general| general.width);
    let drawing = file.optional("drawing", findings, |table, findings| drawing(table, &names, findings));
    let joints = joints(file, &names, materials.as_deref(), findings);
    let blocks = file.all("block", findings, |table, findings| block(table, &names, findings));
    let particles = file.all("particles", findings, |table, findings| particles(table, &names, findings));
    let mut number = 0;
    let loads = file.all("load", findings, |table, findings| {
        number += 1;
        load(number, table, width, findings)
    });
    let plan = plan::plan(file, width, None, findings);
    if !file.has("drawing") && !file.has("block") && !file.has("particles") {
        let help = "add a [drawing] section with file = \"bridge.dxf\", or [[block]] sections";
        findings.error("B011", file.range, "the file has neither a drawing nor blocks", "no body", help);
    }
    if let Some(plan) = &plan
        && plan.analysis != Analysis::Load
    {
        let range = file.place_in("analysis", "analysis");
        let help = "write analysis = \"load\", or describe the arch in a bridge file";
        findings.error("D405", range, "this analysis needs an arch", "blocks without a bridge have no ring", help);
    }
    if let (Some(plan), Some(joints)) = (&plan, &joints)
        && plan.method == Method::Dem
    {
        plan::steps(file, plan, findings);
        let tables = file.tables("joint", &mut Findings::default());
        for (table, joint) in tables.iter().zip(joints) {
            stiffness(table, joint, findings);
        }
    }
    let drawn = |part: &DrawingPart| part.layers.iter().any(|layer| layer.role == Role::Support);
    let supports = [
        drawing.as_ref().map(|part| part.as_ref().is_some_and(drawn)),
        blocks.as_ref().map(|blocks| blocks.iter().any(|block| block.held)),
    ];
    silent(file, supports, findings);
    let General { name, width, gravity } = general?;
    Some(BlockFile {
        name,
        width,
        gravity,
        drawing: drawing?,
        materials: materials?,
        joints: joints?,
        blocks: blocks?,
        particles: particles?,
        loads: loads?,
        plan: plan?,
    })
}

/// What the file leaves out and the analysis would take in silence: width, supports, loads.
fn silent(file: &Table<'_>, supports: [Option<bool>; 2], findings: &mut Findings) {
    let model = file.known("model");
    if let Some(model) = model.filter(|model| !model.has("width")) {
        findings.warning(
            "P028",
            model.range,
            "the model has no width: 1 m is taken",
            "loads in kN and results for the whole bridge go with it",
            "write width = \"… m\" in [model]",
        );
    }
    if supports == [Some(false), Some(false)] {
        findings.warning(
            "P029",
            file.range,
            "no body is a support: the model falls under its own weight",
            "no layer and no [[block]] has role = \"support\"",
            "give the layer of the abutments role = \"support\" in [[drawing.layer]]",
        );
    }
    if !file.has("load") {
        findings.warning(
            "P030",
            file.range,
            "the model has no load: there is no load factor to look for",
            "no [[load]]",
            "add a [[load]] with the layer or block on which it acts",
        );
    }
}

fn materials(file: &Table<'_>, findings: &mut Findings) -> Option<Vec<Material>> {
    let mut rows: Vec<Option<Material>> = Vec::new();
    for table in file.tables("material", findings) {
        let name: Option<At<String>> = table.read("name", findings);
        let masonry = Masonry::of(&table, findings);
        if let Some(name) = &name
            && rows.iter().flatten().any(|known| known.name == name.value)
        {
            let help = "give each material a name of its own";
            findings.error("D405", name.range, "two materials of this name", "named before", help);
        }
        rows.push(name.zip(masonry).map(|(name, masonry)| Material { name: name.value, masonry }));
    }
    rows.into_iter().collect()
}

/// The material of this name; none inside where the key is left out.
fn material_of(table: &Table<'_>, key: &str, names: &[String], findings: &mut Findings) -> Option<Option<usize>> {
    let Some(name) = table.read::<Option<At<String>>>(key, findings)? else { return Some(None) };
    let found = names.iter().position(|known| *known == name.value);
    if found.is_none() && !names.is_empty() {
        let list = names.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", ");
        let help = match nearest(&name.value, names.iter().map(String::as_str)) {
            Some(near) => format!("did you mean \"{near}\"? The materials are {list}"),
            None => format!("add a [[material]] of this name; there are {list}"),
        };
        findings.error("B013", name.range, "there is no such material", "name of a [[material]]", help);
    }
    found.map(Some)
}

fn drawing(table: &Table<'_>, names: &[String], findings: &mut Findings) -> Option<DrawingPart> {
    let file: Option<At<String>> = table.read("file", findings);
    let unit: Option<Option<DrawingUnit>> = table.read("unit", findings);
    let concave = table.read("concave", findings);
    let layers = table.all("layer", findings, |table, findings| layer(table, names, findings));
    let metres = |unit: DrawingUnit| quantity::UNITS.iter().find(|known| known.symbol == unit.word());
    let At { value: file, range } = file?;
    read!(
        table,
        findings,
        DrawingPart {
            chord_tolerance,
            gap_tolerance;
            file,
            range,
            unit: unit?.and_then(metres).map(|unit| unit.size),
            cut_concave: match concave? {
                Concave::Refuse => false,
                Concave::Cut => true,
            },
            layers: layers?,
        }
    )
}

fn layer(table: &Table<'_>, names: &[String], findings: &mut Findings) -> Option<MappedLayer> {
    let name: Option<At<String>> = table.read("name", findings);
    let role = table.read("role", findings);
    let material = material_of(table, "material", names, findings);
    let (role, At { value: name, range }) = (role?, name?);
    // Only what is read is made of something.
    let material = match role {
        Role::Ignore => None,
        Role::Block | Role::Support | Role::Particles => Some(material??),
    };
    Some(MappedLayer { name, range, role, material })
}

fn joints(
    file: &Table<'_>,
    names: &[String],
    materials: Option<&[Material]>,
    findings: &mut Findings,
) -> Option<Vec<MaterialJoint>> {
    let mut rows: Vec<Option<MaterialJoint>> = Vec::new();
    for table in file.tables("joint", findings) {
        let joint = material::joint_of(&table, findings);
        let [first, second] = ["first", "second"].map(|key| material_of(&table, key, names, findings).flatten());
        let between = match (table.has("first"), table.has("second")) {
            (false, false) => Some(None),
            (true, false) => first.map(|a| Some([a, a])),
            (true, true) => first.zip(second).map(|(a, b)| Some([a.min(b), a.max(b)])),
            (false, true) => {
                let help = "write the material of the other side as `first`";
                findings.refuse(
                    "B011",
                    table.place("second"),
                    "`first` is missing in [[joint]]",
                    "one side alone",
                    help,
                )
            }
        };
        if let Some(between) = between
            && rows.iter().flatten().any(|known| known.between == between)
        {
            let what = if between.is_none() { "all other pairs" } else { "this pair" };
            let message = format!("two joints for {what} of materials");
            findings.error("D405", table.range, message, "described before", "keep one of the two");
        }
        if let (Some(joint), Some(materials)) = (&joint, materials) {
            series(&table, joint, materials, findings);
        }
        rows.push(joint.zip(between).map(|(joint, between)| MaterialJoint { range: table.range, between, joint }));
    }
    rows.into_iter().collect()
}

/// The series rule needs the moduli of every material.
fn series(table: &Table<'_>, joint: &crate::model::Joint, materials: &[Material], findings: &mut Findings) {
    let is_series = |stiffness: Option<JointStiffness>| matches!(stiffness, Some(JointStiffness::Series(_)));
    let keys = [
        (
            "mortar_normal_stiffness",
            is_series(joint.normal_stiffness),
            "elastic_modulus",
            "elastic_modulus = \"15 GPa\"",
        ),
        ("mortar_shear_stiffness", is_series(joint.shear_stiffness), "poisson_ratio", "poisson_ratio = 0.2"),
    ];
    for (key, used, what, line) in keys {
        let lacks = |m: &&Material| {
            m.masonry.elastic_modulus.is_none() || (what == "poisson_ratio" && m.masonry.poisson_ratio.is_none())
        };
        if let Some(bare) = materials.iter().find(lacks).filter(|_| used) {
            let message = format!("the series rule needs the {} of {}", what.replace('_', " "), bare.name);
            let help =
                format!("add a line like {line} to that [[material]], or give the stiffness of the whole contact");
            findings.error("B401", table.place(key), message, "stiffness of the mortar joint alone", help);
        }
    }
}

/// The discrete element method cannot do without a stiffness of its joints.
fn stiffness(table: &Table<'_>, joint: &MaterialJoint, findings: &mut Findings) {
    let wanted = [
        (joint.joint.normal_stiffness, "normal", "normal_stiffness = \"4.84 GPa/m\""),
        (joint.joint.shear_stiffness, "shear", "shear_stiffness = \"0.573 GPa/m\""),
    ];
    for (given, word, line) in wanted {
        if given.is_none() {
            let message = format!("the discrete element method needs the {word} stiffness of the joint");
            let help = format!("add a line like {line}, or choose method = \"limit\"");
            findings.error("B401", table.range, message, "missing here", help);
        }
    }
}

fn block(table: &Table<'_>, names: &[String], findings: &mut Findings) -> Option<ListedBlock> {
    let role = table.read("role", findings);
    let material = material_of(table, "material", names, findings);
    read!(
        table,
        findings,
        ListedBlock {
            name,
            layer,
            outline = "outline_m";
            range: table.range,
            material: material??,
            held: match role? {
                BlockRole::Block => false,
                BlockRole::Support => true,
            },
        }
    )
}

fn particles(table: &Table<'_>, names: &[String], findings: &mut Findings) -> Option<ListedParticles> {
    let material = material_of(table, "material", names, findings);
    let found = read!(
        table,
        findings,
        ListedParticles { layer, circles = "circles_m"; range: table.range, material: material.flatten().unwrap_or(0) }
    )?;
    if found.circles.iter().any(|circle| circle[2] <= 0.0) {
        let help = "write each particle as [x, y, radius] in metres";
        let place = table.place("circles_m");
        return findings.refuse("B107", place, "a particle needs a positive radius", "x, y and radius", help);
    }
    material?.map(|_| found)
}

fn load(number: usize, table: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<BodyLoad> {
    let [name, block, layer] = ["name", "block", "layer"].map(|key| table.read::<Option<String>>(key, findings));
    let [x, y] = ["x", "y"].map(|key| table.read::<Option<f64>>(key, findings).flatten());
    let [down, right] = ["down", "right"].map(|key| table.line_load(key, width, findings));
    let permanent = table.read("permanent", findings);
    let has = |key| table.has(key);
    let target = match (has("x") || has("y"), has("block"), has("layer")) {
        (true, false, false) => {
            for key in ["x", "y"].into_iter().filter(|key| !has(key)) {
                let help = format!("add a line like {key} = \"3.10 m\"");
                let message = format!("`{key}` is missing in [[load]]");
                findings.error("B011", table.range, message, "a point has two coordinates", help);
            }
            x.zip(y).map(|(x, y)| Target::Point([x, y]))
        }
        (false, true, false) => block?.map(Target::Block),
        (false, false, true) => layer?.map(Target::Layer),
        (false, false, false) => {
            let help = "add x = \"4.575 m\" and y = \"3.10 m\", or block = \"…\", or layer = \"…\"";
            findings.refuse("B011", table.range, "the load does not say where it acts", "no place", help)
        }
        _ => {
            let help = "keep the point, `block` or `layer`";
            findings.refuse("B016", table.range, "a load acts at one kind of place", "more than one is given", help)
        }
    };
    let force = [right?.unwrap_or(0.0), -down?.unwrap_or(0.0)];
    if force == [0.0, 0.0] {
        let help = "add a line like down = \"1 kN/m\"";
        return findings.refuse("B011", table.range, "the load has no force", "neither `down` nor `right`", help);
    }
    Some(BodyLoad {
        name: name?.unwrap_or_else(|| format!("load {number}")),
        range: table.range,
        target: target?,
        // Zero has no sign.
        force: force.map(|component| component + 0.0),
        permanent: permanent?,
    })
}
