//! What lies above the rings: layers and backing.

use super::{continuum, spandrel};
use crate::card::{Section, joined};
use crate::cards::*;
use crate::choice::choice;
use crate::diagnostic::TextRange;
use crate::findings::Findings;
use crate::library::material;
use crate::model::{Backing, BackingBody, Cover, Layer, LayerKind, PoreWater};
use crate::tree::Table;
use crate::values::read;

choice! {
    /// How a layer is modelled.
    enum LayerBody {
        /// weight on the extrados; loads disperse through it
        Weight = "weight",
        /// soil that yields, method "limit", strip "fill"; in other methods weight through which loads disperse
        Continuum = "continuum",
        /// circular particles that carry and press; strip "fill", method "dem"
        Particles = "particles",
        /// slabs of `block_length` that lie on particles
        Blocks = "blocks",
        /// a depth through which loads disperse, without weight
        Nothing = "nothing",
    }
}

pub(super) static COVER: Section = Section {
    path: "cover",
    doc: "A layer above the rings, from the extrados up; the lowest fills the haunches. Loads disperse through all layers.",
    fields: &[
        word::<LayerKind>("layer", "what the layer is", "fill"),
        length("thickness", "thickness above the crown of the highest extrados", "0.203 m")
            .between(0.0, 100.0)
            .optional("that of the lowest layer, where [road] has the levels of the surface"),
        flag("weighs", "whether its weight acts on the ring; loads disperse through it either way", "true")
            .only("as", &["weight"])
            .default("true"),
        word::<LayerBody>(
            "as",
            "how the layer is modelled by methods that know it so; by others it is weight",
            "particles",
        )
        .default(LayerBody::Weight.word()),
        angle(
            "friction_angle",
            "angle of friction between the layer's particles, or of the soil that yields",
            "35.6 deg",
        )
        .between(0.0, 1.5)
        .only("as", &["particles", "continuum"])
        .optional("particles: as [particle_joint] says; a continuum needs it"),
        stress("cohesion", "cohesion between the layer's particles, or of the soil that yields", "10 kPa")
            .at_least(0.0)
            .only("as", &["particles", "continuum"])
            .optional("particles: as [particle_joint] says; a continuum needs it"),
        stress("tensile_strength", "tensile strength of the soil that yields", "0 kPa")
            .at_least(0.0)
            .only("as", &["continuum"])
            .optional("soil carries no tension"),
        length("block_length", "length of a slab along the bridge", "0.60 m").positive().only("as", &["blocks"]),
        density("density", "mass density of the layer", "1890 kg/m^3")
            .positive()
            .optional("possible only where `weighs = false`"),
        stress("elastic_modulus", "Young's modulus of the layer", "40 MPa")
            .positive()
            .optional("not needed for collapse"),
        material("old-fill"),
    ],
};

pub(super) static BACKING: Section = Section {
    path: "backing",
    doc: "Solid backing above the haunches, up to a level.",
    fields: &joined::<12>(&[
        Backing::CARDS.split_at(3).0,
        &[density(
            "between_density",
            "mass density of what fills the rest of the width beside it; 0 for voids",
            "0 kg/m^3",
        )
        .at_least(0.0)
        .optional("as the lowest layer of the cover")],
        Backing::CARDS.split_at(3).1,
        &[material("rubble-backing")],
    ]),
};

pub(crate) fn cover(file: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<Cover> {
    let tables = file.tables("cover", findings);
    let surveyed = file.has("road");
    let layers: Vec<Option<Layer>> =
        tables.iter().enumerate().map(|(k, table)| layer(table, k == 0 && surveyed, findings)).collect();
    let below = layers.first().and_then(Option::as_ref).map_or(0.0, |lowest| lowest.density);
    let backing = file.optional("backing", findings, |table, findings| backing(table, below, findings));
    let internal_walls =
        file.optional("internal_walls", findings, |table, findings| spandrel::internal_walls(table, width, findings));
    let voids = spandrel::voids(file, findings);
    let layers = layers.into_iter().collect::<Option<Vec<Layer>>>()?;
    if !layers.iter().any(|layer| layer.particles) {
        let slabs =
            tables.iter().zip(&layers).filter(|(_, layer)| layer.slabs.is_some()).map(|(table, _)| table.place("as"));
        slabs.for_each(|place| bodies_without_particles(place, findings));
        if let Some(Some(Backing { body: BackingBody::Particles, .. })) = backing
            && let Some(table) = file.known("backing")
        {
            bodies_without_particles(table.place("as"), findings);
        }
    }
    if file.has("cover") && layers.is_empty() {
        return None;
    }
    continuum::check_layers(&tables, &layers, findings);
    if let Some(Some(backing)) = &backing
        && let Some(table) = file.known("backing")
    {
        continuum::check_backing(&table, backing, layers.first().is_some_and(|lowest| lowest.continuum), findings);
    }
    // From zero on, for an empty sum is minus zero.
    let depth = layers.iter().fold(0.0, |sum, layer| sum + layer.thickness);
    let water = file.optional("water", findings, |table, findings| water(table, &layers, findings));
    Some(Cover {
        depth,
        layers,
        backing: backing?,
        internal_walls: internal_walls?,
        voids: voids?,
        road: None,
        water: water?,
    })
}

pub(super) static WATER: Section = Section {
    path: "water",
    doc: "Water that stands in the pores of the lowest layer of [[cover]]. Below its level the layer has its saturated density, and the water \
          presses on the backs of the rings as well; grains press with what is left of the weight. docs/theory/water.md.",
    fields: PoreWater::CARDS,
};

/// Water in the pores of the lowest layer.
fn water(table: &Table<'_>, layers: &[Layer], findings: &mut Findings) -> Option<PoreWater> {
    let water = PoreWater::of(table, findings)?;
    let saturated_density = water.saturated_density;
    let (key, message, help) = match layers.first() {
        None => {
            let message = "there is no cover whose pores could hold water".to_owned();
            ("level", message, "describe the fill with a [[cover]]")
        }
        Some(lowest) if lowest.particles || !lowest.weighs => (
            "level",
            "the lowest layer is particles or weighs nothing, and water in its pores is not modelled".to_owned(),
            "write as = \"weight\" or as = \"continuum\" in the lowest [[cover]], or remove [water]",
        ),
        Some(lowest) if saturated_density < lowest.density => (
            "saturated_density",
            format!("saturated fill of {saturated_density} kg/m^3 is lighter than the fill above the water"),
            "write the density with pores full: no less than `density` of the lowest [[cover]]",
        ),
        Some(_) => return Some(water),
    };
    findings.refuse("B240", table.place(key), message, "water stands in the pores of the lowest layer", help)
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

/// `below` is the density of the lowest layer of the cover [kg/m^3].
fn backing(table: &Table<'_>, below: f64, findings: &mut Findings) -> Option<Backing> {
    let between: Option<Option<f64>> = table.read("between_density", findings);
    let backing = Backing::of(table, findings)?;
    if backing.body == BackingBody::Continuum && !needs(table, &STRENGTH, findings) {
        return None;
    }
    let share = backing.width_share;
    if share == 1.0 {
        if table.has("between_density") && !table.has("width_share") {
            table.need::<()>("width_share", findings);
        }
        between?;
        return Some(backing);
    }
    if matches!(backing.body, BackingBody::Continuum | BackingBody::Particles) {
        return findings.refuse(
            "B232",
            table.place("width_share"),
            "backing over a share of the width is weight or blocks",
            "a body of soil fills the whole width of a plane model",
            "write as = \"weight\" or as = \"blocks\", or give density and strength as means over the width and leave `width_share` out",
        );
    }
    let density = share * backing.density + (1.0 - share) * between?.unwrap_or(below);
    Some(Backing { density, elastic_modulus: backing.elastic_modulus.map(|modulus| share * modulus), ..backing })
}

/// What a continuum cannot do without.
const STRENGTH: [&str; 2] = ["friction_angle", "cohesion"];

/// Whether all of these keys are written; those that are missing are reported.
fn needs(table: &Table<'_>, keys: &[&str], findings: &mut Findings) -> bool {
    let missing: Vec<&&str> = keys.iter().filter(|key| !table.has(key)).collect();
    for key in &missing {
        table.need::<()>(key, findings);
    }
    missing.is_empty()
}

/// A layer. The thickness of one `under_road` is what is left below the levels of the road.
fn layer(table: &Table<'_>, under_road: bool, findings: &mut Findings) -> Option<Layer> {
    let thickness: Option<Option<f64>> = table.read("thickness", findings);
    match (table.has("thickness"), under_road) {
        (false, false) => table.need::<()>("thickness", findings),
        (true, true) => table.exclude("thickness", "[road]", findings),
        _ => None,
    };
    let body = table.read("as", findings);
    let weighs: Option<bool> = table.read("weighs", findings);
    let [density, slab] = ["density", "block_length"].map(|key| table.read::<Option<f64>>(key, findings));
    let layer = read!(
        table,
        findings,
        Layer {
            name = "layer",
            friction_angle,
            cohesion,
            tensile_strength,
            elastic_modulus;
            thickness: thickness?.unwrap_or(0.0),
            density: density?.unwrap_or(0.0),
            weighs: weighs?,
            particles: false,
            continuum: false,
            slabs: None,
        }
    );
    let body = body?;
    if !table.has("thickness") && !under_road {
        return None;
    }
    if body == LayerBody::Blocks && !table.has("block_length") {
        return table.need("block_length", findings);
    }
    if body != LayerBody::Nothing && weighs? && !table.has("density") {
        return table.need("density", findings);
    }
    if body == LayerBody::Continuum && !needs(table, &STRENGTH, findings) {
        return None;
    }
    let layer = layer?;
    Some(match body {
        LayerBody::Weight => layer,
        // It weighs: in a method that knows no continuum it is weight alone.
        LayerBody::Continuum => Layer { weighs: true, continuum: true, ..layer },
        // So do these: where nothing is particles they are weight alone.
        LayerBody::Particles => Layer { weighs: true, particles: true, ..layer },
        LayerBody::Blocks => Layer { weighs: true, slabs: slab?, ..layer },
        LayerBody::Nothing => Layer { weighs: false, ..layer },
    })
}
