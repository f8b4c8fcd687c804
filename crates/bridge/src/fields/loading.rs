//! Loads, their places, and their dispersal.

use crate::card::{Field, Kind, Section};
use crate::cards::*;
use crate::choice::choice;
use crate::findings::Findings;
use crate::model::{Cover, Dispersal, DispersalRule, Load, LoadKind, LoadingBlock, Plan, Strip};
use crate::resolve::Layout;
use crate::tree::{At, Table, shorten, wrong_type};
use crate::values::decimal;
use findings::words::counted;
use toml::de::DeValue;

choice! {
    /// Shape of a load.
    enum Shape {
        /// a strip across the whole width
        KnifeEdge = "knife-edge",
        /// a pressure across the whole width
        Patch = "patch",
        /// one axle
        Axle = "axle",
        /// a pattern of axles, travelling to the right
        Axles = "axles",
    }
}

pub(super) static LOAD: Section = Section {
    path: "load",
    doc: "A load on the surface, downwards. Place it by `position` or `at`. A file that plans a passage and has no [analysis] needs none.",
    fields: &[
        text("name", "name of the load", "knife edge at the quarter point").optional("named after its kind"),
        word::<Shape>("kind", "shape of the load", "knife-edge"),
        line_load("force", "force of the strip, per metre of width or over the whole width", "1 kN/m")
            .positive()
            .only("kind", &["knife-edge"]),
        stress("pressure", "pressure on the surface", "10 kPa").positive().only("kind", &["patch"]),
        length("length", "length of the loaded strip along the bridge", "0.750 m")
            .positive()
            .only("kind", &["knife-edge", "patch"]),
        flag(
            "whole_length",
            "whether the strip acts over its whole length, as a stack of material; otherwise an assessment shortens it where that does \
             more harm",
            "true",
        )
        .only("kind", &["patch"])
        .default("false"),
        force("axle_force", "force of the axle", "100 kN").positive().only("kind", &["axle"]),
        forces("axle_forces", "forces of the axles, from the first (rightmost) back", "[\"75 kN\", \"115 kN\"]")
            .positive()
            .only("kind", &["axles"]),
        lengths("axle_spacings", "distances between the axles, one fewer than the axles", "[\"3.0 m\"]")
            .positive()
            .only("kind", &["axles"]),
        length("contact_length", "length of a wheel's footprint along the bridge", "0.30 m")
            .positive()
            .only("kind", &["axle", "axles"]),
        length("effective_width", "width of the barrel that carries one axle", "2.5 m")
            .positive()
            .only("kind", &["axle", "axles"]),
        length("position", "middle of the strip or first axle, from the left springing of the first span", "4.575 m")
            .optional("given by `at`"),
        Field::new("at", Kind::Share, "middle of the strip or first axle, as a share of a span", "1/4 of span 1")
            .optional("given by `position`"),
        number(
            "horizontal",
            "force along the bridge as a share of the load, to the right positive: braking, traction",
            "0.25",
        )
        .between(-2.0, 2.0)
        .default("0"),
        word::<Bearer>("through", "how a knife edge reaches the bridge", "block")
            .only("kind", &["knife-edge"])
            .default(Bearer::Cover.word()),
        line_load(
            "block_weight",
            "weight of the loading block, per metre of width or over the whole width; counted in the load",
            "17.72 kN/m",
        )
        .positive()
        .only("through", &["block"]),
    ],
};

choice! {
    /// How a knife edge reaches the bridge.
    enum Bearer {
        /// as a pressure that spreads through the cover, or as forces on the bricks of a wall
        Cover = "cover",
        /// through a rigid block that stands on a wall and cannot rotate
        Block = "block",
    }
}

pub(super) static DISPERSAL: Section = Section {
    path: "dispersal",
    doc: "How loads spread through the cover from the surface to the extrados.",
    fields: &[
        word::<DispersalRule>("rule", "rule of the pressure on the extrados", "inverse-depth"),
        slope("slope", "vertical to horizontal slope on each side", "2:1")
            .between(0.1, 1000.0)
            .only("rule", &["uniform", "inverse-depth", "boussinesq"]),
    ],
};

pub(crate) fn dispersal(file: &Table<'_>, cover: Option<&Cover>, findings: &mut Findings) -> Option<Dispersal> {
    if !file.has("dispersal") {
        if file.has("load") && cover.is_some_and(|cover| cover.depth > 0.0) {
            return file.need("dispersal", findings);
        }
        return Some(Dispersal { rule: DispersalRule::None, slope: 1.0 });
    }
    let table = file.table("dispersal", findings)?;
    let rule: Option<At<DispersalRule>> = table.read("rule", findings);
    let slope: Option<f64> = table.read("slope", findings);
    let At { value: rule, range } = rule?;
    let divides = match rule {
        DispersalRule::None => return Some(Dispersal { rule, slope: 1.0 }),
        DispersalRule::Uniform => false,
        DispersalRule::InverseDepth | DispersalRule::Boussinesq => true,
    };
    if divides && cover.is_some_and(|cover| cover.depth == 0.0) {
        findings
            .error(
                "B304",
                range,
                format!("there is no cover for \"{}\" to disperse through", rule.word()),
                "needs a depth above the crown",
                "describe the layers with [[cover]], or write rule = \"none\"",
            )
            .because("this rule divides by the depth of the extrados below the surface");
    }
    Some(Dispersal { rule, slope: slope? })
}

/// Widths that loads are read with [m].
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Widths {
    /// Of the barrel.
    pub(crate) barrel: Option<f64>,
    /// Of its widest strip between longitudinal cracks; the barrel's where it has none.
    pub(crate) strip: Option<f64>,
}

pub(crate) fn load(table: &Table<'_>, width: Widths, layout: Option<&Layout>, findings: &mut Findings) -> Option<Load> {
    let name: Option<Option<String>> = table.read("name", findings);
    let shape: Option<Shape> = table.read("kind", findings);
    let kind = kind(table, shape, width, findings);
    let position = position(table, layout, findings);
    let through = table.read("through", findings);
    let block_weight = table.line_load("block_weight", width.barrel, findings);
    let block = match through? {
        Bearer::Cover => None,
        // Its absence has been reported.
        Bearer::Block => Some(LoadingBlock { weight: block_weight?? }),
    };
    let whole_length: Option<bool> = table.read("whole_length", findings);
    let horizontal: Option<At<f64>> = table.read("horizontal", findings);
    if let Some(At { value, .. }) = horizontal
        && value != 0.0
        && block.is_some()
    {
        table.exclude::<()>("horizontal", "`through = \"block\"`, a block that is held sideways", findings);
    }
    let name = name?.unwrap_or_else(|| shape.map_or("", Shape::word).to_owned());
    let (horizontal, whole_length) = (horizontal?.value, whole_length?);
    let load = Load { name, kind: kind?, position: position?, block, horizontal, whole_length };
    if let Some(layout) = layout {
        check_place(table, &load, layout, findings);
    }
    Some(load)
}

fn kind(table: &Table<'_>, shape: Option<Shape>, width: Widths, findings: &mut Findings) -> Option<LoadKind> {
    let force = table.line_load("force", width.barrel, findings);
    let mut quantity = |key| table.read::<Option<f64>>(key, findings);
    let (pressure, length, axle_force) = (quantity("pressure"), quantity("length"), quantity("axle_force"));
    let contact_length = quantity("contact_length");
    let axle_forces: Option<Vec<f64>> = table.read("axle_forces", findings);
    let spacings: Option<At<Vec<f64>>> = table.read("axle_spacings", findings);
    let effective_width: Option<At<f64>> = table.read("effective_width", findings);
    if let (Some(effective), Some(strip)) = (effective_width, width.strip)
        && effective.value > strip * (1.0 + 1e-12)
    {
        let (of, label) = match width.barrel {
            Some(barrel) if strip < barrel => {
                ("the widest strip between longitudinal cracks", format!("the widest strip has {strip} m"))
            }
            _ => ("the barrel", format!("the barrel is {strip} m wide")),
        };
        let message = format!("the effective width of an axle is more than the width of {of}");
        findings.error("B303", effective.range, message, label, format!("write \"{strip} m\" or less"));
    }
    Some(match shape? {
        Shape::KnifeEdge => LoadKind::KnifeEdge { force: force??, length: length?? },
        Shape::Patch => LoadKind::Patch { pressure: pressure??, length: length?? },
        Shape::Axle => LoadKind::Axles {
            axles: vec![(axle_force??, 0.0)],
            contact_length: contact_length??,
            effective_width: effective_width?.value,
        },
        Shape::Axles => {
            let (forces, spacings) = (axle_forces?, spacings?);
            if forces.is_empty() || spacings.value.len() + 1 != forces.len() {
                return findings.refuse(
                    "B302",
                    spacings.range,
                    format!("{} and {}", counted(forces.len(), "axle"), counted(spacings.value.len(), "spacing")),
                    "one spacing between every two adjacent axles",
                    format!("give as many spacings as axles, less one: {}", forces.len().saturating_sub(1)),
                );
            }
            let mut offset = 0.0;
            let mut axles = vec![(forces[0], 0.0)];
            for (force, spacing) in forces[1..].iter().zip(&spacings.value) {
                offset += spacing;
                axles.push((*force, offset));
            }
            LoadKind::Axles { axles, contact_length: contact_length??, effective_width: effective_width?.value }
        }
    })
}

/// Where a load stands: `position`, or `at` a share of a span.
fn position(table: &Table<'_>, layout: Option<&Layout>, findings: &mut Findings) -> Option<f64> {
    let position: Option<Option<f64>> = table.read("position", findings);
    let share = share(table, layout, findings);
    match (table.has("position"), table.has("at")) {
        (true, true) => table.exclude("at", "`position`", findings),
        (true, false) => position?,
        (false, true) => share,
        (false, false) => table.need("position", findings),
    }
}

/// "1/4 of span 1", "0.25 span", "30% of span 2", "crown of span 1": its distance from the first springing [m].
pub(crate) fn share(table: &Table<'_>, layout: Option<&Layout>, findings: &mut Findings) -> Option<f64> {
    let (field, raw) = table.entry("at")?;
    let DeValue::String(text) = raw.get_ref() else { return wrong_type(field, raw, findings) };
    let range = raw.span().into();
    let Some((share, number)) = read_share(text) else {
        return findings.refuse(
            "B109",
            range,
            format!("\"{}\" is no share of a span", shorten(text)),
            field.doc,
            match crate::quantity::parse(text) {
                Ok(_) if table.section.field("position").is_some() => {
                    format!("a distance from the first springing is written position = \"{}\"; a share, at = \"1/4 of span 1\"", shorten(text))
                }
                Ok(_) => "a distance is written as x and y; a share, \"1/4 of span 1\"".to_owned(),
                Err(_) => "write \"1/4 of span 1\", \"30% of span 2\" or \"crown of span 1\"".to_owned(),
            },
        );
    };
    let layout = layout?;
    let spans = layout.spans.len();
    let index = match number {
        None if spans == 1 => 0,
        Some(number) if (1..=spans).contains(&number) => number - 1,
        None => {
            return findings.refuse(
                "B109",
                range,
                "which span is meant?",
                format!("the bridge has {spans} spans"),
                format!("name the span: \"{} of span 1\"", shorten(text.split(" of").next().unwrap_or(text))),
            );
        }
        Some(_) => {
            return findings.refuse(
                "B301",
                range,
                "there is no such span",
                format!("the bridge has {spans}"),
                if spans == 1 {
                    "write \"1/4 of span 1\"".to_owned()
                } else {
                    format!("name a span from 1 to {spans}, counted from the left")
                },
            );
        }
    };
    let (start, end) = layout.spans[index];
    Some(start + share * (end - start))
}

/// Share and number of the span, where one is named.
pub(crate) fn read_share(text: &str) -> Option<(f64, Option<usize>)> {
    let text = text.trim();
    let (share, span) = match text.find("span") {
        Some(at) => (text[..at].trim(), text[at + 4..].trim()),
        None => (text, ""),
    };
    let share = share.strip_suffix("of").unwrap_or(share).trim();
    let value = if share == "crown" {
        0.5
    } else if let Some(percent) = share.strip_suffix('%') {
        decimal(percent)? / 100.0
    } else if let Some((part, whole)) = share.split_once('/') {
        decimal(part)? / decimal(whole)?
    } else {
        decimal(share)?
    };
    let number = if span.is_empty() { None } else { Some(span.parse().ok()?) };
    (0.0..=1.0).contains(&value).then_some((value, number))
}

/// A loading block stands on something: cover that is weight alone cannot carry it.
pub(crate) fn check_blocks(file: &Table<'_>, plan: &Plan, loads: &[Load], on_particles: bool, findings: &mut Findings) {
    for (table, load) in file.tables("load", &mut Findings::default()).iter().zip(loads) {
        if load.block.is_some() && plan.strip != Strip::Wall && !on_particles {
            findings
                .error(
                    "B305",
                    table.place("through"),
                    "there is nothing for the loading block to stand on",
                    "a block cannot stand on cover that is weight alone",
                    "write through = \"cover\", write as = \"particles\" in [[cover]], or describe a [spandrel_wall] and write strip = \"wall\" in [analysis]",
                )
                .because("cover acts by its weight and as a path for loads; it has no surface that carries a block");
        }
    }
}

/// A load stands on the bridge, at least in part.
fn check_place(table: &Table<'_>, load: &Load, layout: &Layout, findings: &mut Findings) {
    let range = table.place(if table.has("position") { "position" } else { "at" });
    let end = layout.length;
    let strips: Vec<(f64, f64)> = match &load.kind {
        LoadKind::KnifeEdge { length, .. } | LoadKind::Patch { length, .. } => vec![(load.position, *length)],
        LoadKind::Axles { axles, contact_length, .. } => {
            axles.iter().map(|(_, offset)| (load.position - offset, *contact_length)).collect()
        }
    };
    if strips.iter().all(|(middle, _)| *middle < 0.0 || *middle > end) {
        findings.error(
            "B301",
            range,
            "the load is off the bridge",
            format!("the bridge runs from 0 m to {end} m"),
            format!("give a position from \"0 m\" to \"{end} m\", measured from the left springing of the first span"),
        );
    } else if strips.iter().any(|(middle, length)| middle - 0.5 * length < 0.0 || middle + 0.5 * length > end) {
        findings
            .warning(
                "P009",
                range,
                "part of the load is beside the bridge",
                format!("the bridge runs from 0 m to {end} m"),
                "move the load onto the bridge if all of it is meant to act",
            )
            .because("load behind the springings does not act on the rings");
    }
}
