//! Layers above the rings, and backing.

use crate::diagnostic::TextRange;
use crate::findings::Findings;
use crate::model::{Backing, BackingBody, Cover, Layer, LayerKind};
use crate::tree::Table;

use super::materials::maybe;
use super::structure::need;

pub(super) fn cover(file: &Table<'_>, findings: &mut Findings) -> Option<Cover> {
    let tables = file.tables("cover", findings);
    let layers: Vec<Option<Layer>> = tables.iter().map(|table| layer(table, findings)).collect();
    let backing = if file.has("backing") { backing(file, findings).map(Some) } else { Some(None) };
    let layers = layers.into_iter().collect::<Option<Vec<Layer>>>()?;
    if !layers.iter().any(|layer| layer.particles) {
        let slabs =
            tables.iter().zip(&layers).filter(|(_, layer)| layer.slabs.is_some()).map(|(table, _)| table.place("as"));
        slabs.for_each(|place| bodies_without_particles(place, findings));
        if let Some(Some(Backing { body: BackingBody::Particles, .. })) = backing
            && let Some(table) = file.table("backing", &mut Findings::default())
        {
            bodies_without_particles(table.place("as"), findings);
        }
    }
    if file.has("cover") && layers.is_empty() {
        return None;
    }
    // From zero on, for an empty sum is minus zero.
    let depth = layers.iter().fold(0.0, |sum, layer| sum + layer.thickness);
    Some(Cover { depth, layers, backing: backing? })
}

fn bodies_without_particles(place: TextRange, findings: &mut Findings) {
    findings.error(
        "B216",
        place,
        "no layer of the cover is modelled as particles, which this needs around it",
        "it would carry nothing",
        "write as = \"weight\", or as = \"particles\" in a [[cover]]",
    );
}

fn layer(table: &Table<'_>, findings: &mut Findings) -> Option<Layer> {
    let name = table.word("layer", findings);
    let thickness = table.quantity("thickness", findings);
    let weighs = table.flag("weighs", findings);
    let density = table.quantity("density", findings);
    let elastic_modulus = table.quantity("elastic_modulus", findings);
    let body = table.word("as", findings);
    let friction_angle = table.quantity("friction_angle", findings);
    let cohesion = table.quantity("cohesion", findings);
    let body = maybe(table, "as", body)?;
    let particles = body == Some("particles");
    let slab = table.quantity("block_length", findings);
    let slabs = if body == Some("blocks") {
        if !table.has("block_length") {
            need(table, "block_length", findings);
        }
        Some(slab?.value)
    } else {
        None
    };
    let weighs = maybe(table, "weighs", weighs)?.unwrap_or(body != Some("nothing"));
    if weighs && !table.has("density") {
        need(table, "density", findings);
        return None;
    }
    Some(Layer {
        name: match name?.value {
            "sub-base" => LayerKind::SubBase,
            "surfacing" => LayerKind::Surfacing,
            "ballast" => LayerKind::Ballast,
            _ => LayerKind::Fill,
        },
        thickness: thickness?.value,
        density: maybe(table, "density", density)?.unwrap_or(0.0),
        weighs: weighs && !particles && slabs.is_none(),
        particles,
        slabs,
        friction_angle: maybe(table, "friction_angle", friction_angle)?,
        cohesion: maybe(table, "cohesion", cohesion)?,
        elastic_modulus: maybe(table, "elastic_modulus", elastic_modulus)?,
    })
}

fn backing(file: &Table<'_>, findings: &mut Findings) -> Option<Backing> {
    let table = file.table("backing", findings)?;
    let height = table.quantity("height", findings);
    let density = table.quantity("density", findings);
    let elastic_modulus = table.quantity("elastic_modulus", findings);
    let poisson_ratio = table.number("poisson_ratio", findings);
    let body = table.word("as", findings);
    let friction_angle = table.quantity("friction_angle", findings);
    let cohesion = table.quantity("cohesion", findings);
    Some(Backing {
        height: height?.value,
        density: density?.value,
        elastic_modulus: maybe(&table, "elastic_modulus", elastic_modulus)?,
        poisson_ratio: maybe(&table, "poisson_ratio", poisson_ratio)?,
        body: match maybe(&table, "as", body)? {
            Some("particles") => BackingBody::Particles,
            Some("blocks") => BackingBody::Blocks,
            _ => BackingBody::Weight,
        },
        friction_angle: maybe(&table, "friction_angle", friction_angle)?,
        cohesion: maybe(&table, "cohesion", cohesion)?,
    })
}
