//! Loads, their places, and their dispersal.

use toml::de::DeValue;

use crate::findings::Findings;
use crate::model::{Cover, Dispersal, DispersalRule, Load, LoadKind, LoadingBlock, Plan, Strip};
use crate::tree::{At, Table, shorten, wrong_type};

use super::geometry::Layout;
use super::materials::maybe;
use super::structure::{exclude, need};

pub(super) fn dispersal(file: &Table<'_>, cover: Option<&Cover>, findings: &mut Findings) -> Option<Dispersal> {
    if !file.has("dispersal") {
        if file.has("load") && cover.is_some_and(|cover| cover.depth > 0.0) {
            need(file, "dispersal", findings);
            return None;
        }
        return Some(Dispersal { rule: DispersalRule::None, slope: 1.0 });
    }
    let table = file.table("dispersal", findings)?;
    let rule = table.word("rule", findings);
    let slope = slope(&table, findings);
    let rule = rule?;
    let kind = match rule.value {
        "uniform" => DispersalRule::Uniform,
        "inverse-depth" => DispersalRule::InverseDepth,
        "boussinesq" => DispersalRule::Boussinesq,
        _ => return Some(Dispersal { rule: DispersalRule::None, slope: 1.0 }),
    };
    if kind != DispersalRule::Uniform && cover.is_some_and(|cover| cover.depth == 0.0) {
        findings
            .error(
                "B304",
                rule.range,
                format!("there is no cover for \"{}\" to disperse through", rule.value),
                "needs a depth above the crown",
                "describe the layers with [[cover]], or write rule = \"none\"",
            )
            .because("this rule divides by the depth of the extrados below the surface");
    }
    Some(Dispersal { rule: kind, slope: slope?.value })
}

/// "2:1", vertical to horizontal.
pub(crate) fn slope(table: &Table<'_>, findings: &mut Findings) -> Option<At<f64>> {
    slope_of(table, "slope", findings)
}

/// The same of another key.
pub(crate) fn slope_of(table: &Table<'_>, key: &str, findings: &mut Findings) -> Option<At<f64>> {
    let (field, raw) = table.entry(key)?;
    let DeValue::String(text) = raw.get_ref() else { return wrong_type(field, raw, findings) };
    match read_slope(text).filter(|value| value.is_finite() && field.limits.allow(*value)) {
        Some(value) => Some(At { value, range: raw.span().into() }),
        None => {
            findings.error(
                "B109",
                raw.span().into(),
                format!("\"{}\" is no slope", shorten(text)),
                field.doc,
                "write vertical to horizontal: \"2:1\" spreads by half the depth on each side",
            );
            None
        }
    }
}

/// Vertical over horizontal.
pub(crate) fn read_slope(text: &str) -> Option<f64> {
    let (vertical, horizontal) = text.split_once(':')?;
    Some(decimal(vertical)? / decimal(horizontal)?)
}

fn decimal(text: &str) -> Option<f64> {
    let text = text.trim();
    text.chars().all(|c| c.is_ascii_digit() || c == '.').then(|| text.parse().ok()).flatten()
}

pub(super) fn loads(
    file: &Table<'_>,
    width: Option<f64>,
    layout: Option<&Layout>,
    findings: &mut Findings,
) -> Option<Vec<Load>> {
    let tables = file.tables("load", findings);
    let loads: Vec<Option<Load>> = tables.iter().map(|table| load(table, width, layout, findings)).collect();
    if file.has("load") && loads.is_empty() {
        return None;
    }
    loads.into_iter().collect()
}

fn load(table: &Table<'_>, width: Option<f64>, layout: Option<&Layout>, findings: &mut Findings) -> Option<Load> {
    let name = table.text("name", findings);
    let kind = table.word("kind", findings);
    let shape = shape(table, width, findings);
    let position = position(table, layout, findings);
    let through = table.word("through", findings);
    let block_weight = table.line_load("block_weight", width, findings);
    let block = match maybe(table, "through", through)? {
        Some("block") if table.has("block_weight") => Some(LoadingBlock { weight: block_weight?.value }),
        // Its absence has been reported.
        Some("block") => return None,
        _ => None,
    };
    let kind = kind?.value;
    let name = if table.has("name") { name?.value.to_owned() } else { kind.to_owned() };
    let load = Load { name, kind: shape?, position: position?.value, block };
    if let Some(layout) = layout {
        check_place(table, &load, layout, findings);
    }
    Some(load)
}

fn shape(table: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<LoadKind> {
    let force = table.line_load("force", width, findings);
    let pressure = table.quantity("pressure", findings);
    let length = table.quantity("length", findings);
    let axle_force = table.quantity("axle_force", findings);
    let axle_forces = table.quantities("axle_forces", findings);
    let spacings = table.quantities("axle_spacings", findings);
    let contact_length = table.quantity("contact_length", findings);
    let effective_width = table.quantity("effective_width", findings);
    if let (Some(effective), Some(width)) = (effective_width, width)
        && effective.value > width * (1.0 + 1e-12)
    {
        findings.error(
            "B303",
            effective.range,
            "the effective width of an axle is more than the width of the barrel",
            format!("the barrel is {width} m wide"),
            format!("write \"{width} m\" or less"),
        );
    }
    let kind = match table.entry("kind").map(|(_, raw)| raw.get_ref()) {
        Some(DeValue::String(kind)) => kind.as_ref(),
        _ => return None,
    };
    Some(match kind {
        "knife-edge" => LoadKind::KnifeEdge { force: force?.value, length: length?.value },
        "patch" => LoadKind::Patch { pressure: pressure?.value, length: length?.value },
        "axle" => LoadKind::Axles {
            axles: vec![(axle_force?.value, 0.0)],
            contact_length: contact_length?.value,
            effective_width: effective_width?.value,
        },
        "axles" => {
            let (forces, spacings) = (axle_forces?, spacings?);
            if forces.value.is_empty() || spacings.value.len() + 1 != forces.value.len() {
                findings.error(
                    "B302",
                    spacings.range,
                    format!("{} axles have {} spacings", forces.value.len(), spacings.value.len()),
                    "one spacing between every two adjacent axles",
                    format!("give as many spacings as axles, less one: {}", forces.value.len().saturating_sub(1)),
                );
                return None;
            }
            let mut offset = 0.0;
            let mut axles = vec![(forces.value[0], 0.0)];
            for (force, spacing) in forces.value[1..].iter().zip(&spacings.value) {
                offset += spacing;
                axles.push((*force, offset));
            }
            LoadKind::Axles { axles, contact_length: contact_length?.value, effective_width: effective_width?.value }
        }
        _ => return None,
    })
}

/// Where a load stands: `position`, or `at` a share of a span.
fn position(table: &Table<'_>, layout: Option<&Layout>, findings: &mut Findings) -> Option<At<f64>> {
    let position = table.quantity("position", findings);
    let share = share(table, layout, findings);
    match (table.has("position"), table.has("at")) {
        (true, true) => {
            exclude(table, "at", "`position`", findings);
            None
        }
        (true, false) => position,
        (false, true) => share,
        (false, false) => {
            need(table, "position", findings);
            None
        }
    }
}

/// "1/4 of span 1", "0.25 span", "30% of span 2", "crown of span 1": its distance from the first springing [m].
pub(super) fn share(table: &Table<'_>, layout: Option<&Layout>, findings: &mut Findings) -> Option<At<f64>> {
    let (field, raw) = table.entry("at")?;
    let DeValue::String(text) = raw.get_ref() else { return wrong_type(field, raw, findings) };
    let range = raw.span().into();
    let Some((share, number)) = read_share(text) else {
        findings.error(
            "B109",
            range,
            format!("\"{}\" is no share of a span", shorten(text)),
            field.doc,
            "write \"1/4 of span 1\", \"30% of span 2\" or \"crown of span 1\"",
        );
        return None;
    };
    let layout = layout?;
    let spans = layout.spans.len();
    let index = match number {
        None if spans == 1 => 0,
        Some(number) if (1..=spans).contains(&number) => number - 1,
        None => {
            findings.error(
                "B109",
                range,
                "which span is meant?",
                format!("the bridge has {spans} spans"),
                format!("name the span: \"{} of span 1\"", shorten(text.split(" of").next().unwrap_or(text))),
            );
            return None;
        }
        Some(_) => {
            findings.error(
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
            return None;
        }
    };
    let (start, end) = layout.spans[index];
    Some(At { value: start + share * (end - start), range })
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
pub(super) fn check_blocks(file: &Table<'_>, plan: &Plan, loads: &[Load], on_particles: bool, findings: &mut Findings) {
    let mut unheard = Findings::default();
    for (table, load) in file.tables("load", &mut unheard).iter().zip(loads) {
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
