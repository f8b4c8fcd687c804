//! From the tree of a block model file to its meaning.

use crate::blocks::{
    BlockFile, BodyLoad, DrawingPart, ListedBlock, ListedParticles, MappedLayer, Material, MaterialJoint, Role, Target,
};
use crate::findings::Findings;
use crate::model::{Analysis, JointStiffness, Method};
use crate::quantity;
use crate::tree::{At, Table, nearest};

use super::materials::{self, maybe};
use super::plan;

/// Gravity in bridge practice; the default of the field's card.
const GRAVITY: f64 = 9.81;

/// Reads the whole file. There is a value only if nothing is missing.
pub(crate) fn resolve(file: &Table<'_>, findings: &mut Findings) -> Option<BlockFile> {
    let general = general(file, findings);
    let materials = materials(file, findings);
    let names: Vec<String> = materials.iter().flatten().map(|material| material.name.clone()).collect();
    let width = general.as_ref().map(|(_, width, _)| *width);
    let drawing = drawing(file, &names, findings);
    let joints = joints(file, &names, materials.as_deref(), findings);
    let blocks = all(file.tables("block", findings).iter().map(|t| block(t, &names, findings)).collect());
    let particles = all(file.tables("particles", findings).iter().map(|t| particles(t, &names, findings)).collect());
    let tables = file.tables("load", findings);
    let loads = all(tables.iter().enumerate().map(|(k, t)| load(k, t, width, findings)).collect());
    let plan = plan::plan(file, width, None, findings);
    if !file.has("drawing") && !file.has("block") && !file.has("particles") {
        let help = "add a [drawing] section with file = \"bridge.dxf\", or [[block]] sections";
        findings.error("B011", file.range, "the file has neither a drawing nor blocks", "no body", help);
    }
    if let Some(plan) = &plan
        && plan.analysis != Analysis::Load
    {
        let range = file.table("analysis", &mut Findings::default()).map_or(file.range, |t| t.place("analysis"));
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
    silent(
        file,
        [
            drawing.as_ref().map(|part| part.as_ref().is_some_and(supported)),
            blocks.as_ref().map(|b| b.iter().any(|b| b.held)),
        ],
        findings,
    );
    let (name, width, gravity) = general?;
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

/// Whether a layer of the drawing holds supports.
fn supported(part: &DrawingPart) -> bool {
    part.layers.iter().any(|layer| layer.role == Role::Support)
}

/// What the file leaves out and the analysis would take in silence: width, supports, loads.
fn silent(file: &Table<'_>, supports: [Option<bool>; 2], findings: &mut Findings) {
    let model = file.table("model", &mut Findings::default());
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

/// All of them, or nothing where one could not be read.
fn all<T>(rows: Vec<Option<T>>) -> Option<Vec<T>> {
    rows.into_iter().collect()
}

fn general(file: &Table<'_>, findings: &mut Findings) -> Option<(String, f64, f64)> {
    let table = file.table("model", findings)?;
    let name = table.text("name", findings);
    let width = table.quantity("width", findings);
    let gravity = table.quantity("gravity", findings);
    let width = maybe(&table, "width", width)?.unwrap_or(1.0);
    let gravity = maybe(&table, "gravity", gravity)?.unwrap_or(GRAVITY);
    Some((name?.value.to_owned(), width, gravity))
}

fn materials(file: &Table<'_>, findings: &mut Findings) -> Option<Vec<Material>> {
    let mut rows: Vec<Option<Material>> = Vec::new();
    for table in file.tables("material", findings) {
        let name = table.text("name", findings);
        let masonry = materials::masonry_of(&table, findings);
        if let Some(name) = name
            && rows.iter().flatten().any(|known| known.name == name.value)
        {
            let help = "give each material a name of its own";
            findings.error("D405", name.range, "two materials of this name", "named before", help);
        }
        rows.push(name.zip(masonry).map(|(name, masonry)| Material { name: name.value.to_owned(), masonry }));
    }
    all(rows)
}

/// The material of this name.
fn material(name: At<&str>, names: &[String], findings: &mut Findings) -> Option<usize> {
    let found = names.iter().position(|known| known == name.value);
    if found.is_none() && !names.is_empty() {
        let list = names.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", ");
        let help = match nearest(name.value, names.iter().map(String::as_str)) {
            Some(near) => format!("did you mean \"{near}\"? The materials are {list}"),
            None => format!("add a [[material]] of this name; there are {list}"),
        };
        findings.error("B013", name.range, "there is no such material", "name of a [[material]]", help);
    }
    found
}

fn drawing(file: &Table<'_>, names: &[String], findings: &mut Findings) -> Option<Option<DrawingPart>> {
    if !file.has("drawing") {
        return Some(None);
    }
    let table = file.table("drawing", findings)?;
    let path = table.text("file", findings);
    let unit = table.word("unit", findings);
    let chord = table.quantity("chord_tolerance", findings);
    let gap = table.quantity("gap_tolerance", findings);
    let concave = table.word("concave", findings);
    let layers = all(table.tables("layer", findings).iter().map(|t| layer(t, names, findings)).collect());
    let metres = |word: &str| quantity::UNITS.iter().find(|unit| unit.symbol == word).map(|unit| unit.size);
    let path = path?;
    Some(Some(DrawingPart {
        file: path.value.to_owned(),
        range: path.range,
        unit: maybe(&table, "unit", unit)?.and_then(metres),
        chord_tolerance: maybe(&table, "chord_tolerance", chord)?.unwrap_or(1e-3),
        gap_tolerance: maybe(&table, "gap_tolerance", gap)?.unwrap_or(1e-3),
        cut_concave: maybe(&table, "concave", concave)? == Some("cut"),
        layers: layers?,
    }))
}

fn layer(table: &Table<'_>, names: &[String], findings: &mut Findings) -> Option<MappedLayer> {
    let name = table.text("name", findings);
    let role = table.word("role", findings);
    let of = table.text("material", findings);
    let material = of.and_then(|of| material(of, names, findings));
    let role = match role?.value {
        "support" => Role::Support,
        "particles" => Role::Particles,
        "ignore" => Role::Ignore,
        _ => Role::Block,
    };
    if role != Role::Ignore {
        material?;
    }
    let name = name?;
    Some(MappedLayer { name: name.value.to_owned(), range: name.range, role, material })
}

fn joints(
    file: &Table<'_>,
    names: &[String],
    materials: Option<&[Material]>,
    findings: &mut Findings,
) -> Option<Vec<MaterialJoint>> {
    let mut rows: Vec<Option<MaterialJoint>> = Vec::new();
    for table in file.tables("joint", findings) {
        let joint = materials::joint_of(&table, findings);
        let first = table.text("first", findings).and_then(|name| material(name, names, findings));
        let second = table.text("second", findings).and_then(|name| material(name, names, findings));
        let between = match (table.has("first"), table.has("second")) {
            (false, false) => Some(None),
            (true, false) => first.map(|a| Some([a, a])),
            (true, true) => first.zip(second).map(|(a, b)| Some([a.min(b), a.max(b)])),
            (false, true) => {
                let help = "write the material of the other side as `first`";
                findings.error(
                    "B011",
                    table.place("second"),
                    "`first` is missing in [[joint]]",
                    "one side alone",
                    help,
                );
                None
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
    all(rows)
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
    let name = table.text("name", findings);
    let layer = table.text("layer", findings);
    let of = table.text("material", findings);
    let role = table.word("role", findings);
    let outline = table.rows::<2>("outline_m", findings);
    let material = of.and_then(|of| material(of, names, findings));
    Some(ListedBlock {
        name: maybe(table, "name", name)?.map(str::to_owned),
        layer: maybe(table, "layer", layer)?.unwrap_or("BLOCKS").to_owned(),
        range: table.range,
        material: material?,
        held: maybe(table, "role", role)? == Some("support"),
        outline: outline?.value,
    })
}

fn particles(table: &Table<'_>, names: &[String], findings: &mut Findings) -> Option<ListedParticles> {
    let layer = table.text("layer", findings);
    let of = table.text("material", findings);
    let circles = table.rows::<3>("circles_m", findings);
    let material = of.and_then(|of| material(of, names, findings));
    let circles = circles?;
    if circles.value.iter().any(|circle| circle[2] <= 0.0) {
        let help = "write each particle as [x, y, radius] in metres";
        findings.error("B107", circles.range, "a particle needs a positive radius", "x, y and radius", help);
        return None;
    }
    Some(ListedParticles {
        range: table.range,
        layer: maybe(table, "layer", layer)?.unwrap_or("PARTICLES").to_owned(),
        material: material?,
        circles: circles.value,
    })
}

fn load(number: usize, table: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<BodyLoad> {
    let name = table.text("name", findings);
    let (x, y) = (table.quantity("x", findings), table.quantity("y", findings));
    let (block, layer) = (table.text("block", findings), table.text("layer", findings));
    let (down, right) = (table.line_load("down", width, findings), table.line_load("right", width, findings));
    let permanent = table.flag("permanent", findings);
    let has = |key| table.has(key);
    let target = match (has("x") || has("y"), has("block"), has("layer")) {
        (true, false, false) => {
            for key in ["x", "y"].into_iter().filter(|key| !has(key)) {
                let help = format!("add a line like {key} = \"3.10 m\"");
                let message = format!("`{key}` is missing in [[load]]");
                findings.error("B011", table.range, message, "a point has two coordinates", help);
            }
            x.zip(y).map(|(x, y)| Target::Point([x.value, y.value]))
        }
        (false, true, false) => block.map(|at| Target::Block(at.value.to_owned())),
        (false, false, true) => layer.map(|at| Target::Layer(at.value.to_owned())),
        (false, false, false) => {
            let help = "add x = \"4.575 m\" and y = \"3.10 m\", or block = \"…\", or layer = \"…\"";
            findings.error("B011", table.range, "the load does not say where it acts", "no place", help);
            None
        }
        _ => {
            let help = "keep the point, `block` or `layer`";
            findings.error("B016", table.range, "a load acts at one kind of place", "more than one is given", help);
            None
        }
    };
    let (down, right) = (maybe(table, "down", down)?, maybe(table, "right", right)?);
    let force = [right.unwrap_or(0.0), -down.unwrap_or(0.0)];
    if force == [0.0, 0.0] {
        let help = "add a line like down = \"1 kN/m\"";
        findings.error("B011", table.range, "the load has no force", "neither `down` nor `right`", help);
        return None;
    }
    Some(BodyLoad {
        name: maybe(table, "name", name)?.map_or_else(|| format!("load {}", number + 1), str::to_owned),
        range: table.range,
        target: target?,
        // Zero has no sign.
        force: force.map(|component| component + 0.0),
        permanent: maybe(table, "permanent", permanent)?.unwrap_or(false),
    })
}
