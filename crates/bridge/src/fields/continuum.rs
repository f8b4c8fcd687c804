//! Fill and backing that yield as a continuum, and whether layers and backing fit together then.

use crate::card::Section;
use crate::diagnostic::TextRange;
use crate::findings::Findings;
use crate::model::{Backing, BackingBody, Confinement, ContinuumPlan, Cover, Layer};
use crate::tree::Table;

/// Least depth of a continuum over the crown [m]: loads stand on it.
const LEAST_DEPTH: f64 = 0.01;

pub(super) static CONTINUUM: Section = Section {
    path: "continuum",
    doc: "How layers and backing that are a continuum (as = \"continuum\") are modelled: soil in plane strain that yields by \
          Mohr-Coulomb's law, in limit analysis of strip \"fill\". Loads act on its upper face and do not disperse: the soil \
          carries them to the rings.",
    fields: ContinuumPlan::CARDS,
};

/// How the continuum is modelled; none inside where no layer is one.
pub(crate) fn continuum(
    file: &Table<'_>,
    cover: Option<&Cover>,
    findings: &mut Findings,
) -> Option<Option<ContinuumPlan>> {
    let mut plan = file.part("continuum", findings, ContinuumPlan::of);
    // What is wrong with the cover has been reported.
    let wanted = cover.is_none_or(|cover| cover.layers.iter().any(|layer| layer.continuum));
    if !wanted && let Some(table) = file.known("continuum") {
        findings.warning(
            "P031",
            table.range,
            "a continuum is described, and no layer of the cover is one",
            "[continuum] has no effect",
            "write as = \"continuum\" in the lowest [[cover]], or remove [continuum]",
        );
    }
    if let (Some(plan), Some(water)) = (&mut plan, cover.and_then(|cover| cover.water)) {
        if let Some(table) = file.known("continuum")
            && table.has("water_level")
        {
            findings.error(
                "B240",
                table.place("water_level"),
                "the level of the water is given twice",
                "[water] gives it, with the saturated density",
                "remove `water_level` of [continuum]",
            );
        }
        plan.water_level = Some(water.level);
    }
    if let Some(plan) = &plan
        && plan.confinement == Confinement::SpandrelWalls
        && !file.has("spandrel_wall")
        && let Some(table) = file.known("continuum")
    {
        findings.error(
            "B223",
            table.place("confinement"),
            "the fill is held by spandrel walls, and the file has none",
            "what a wall holds follows from its thickness, its weight and its friction",
            "describe the walls with [spandrel_wall], or write confinement = \"plane-strain\"",
        );
    }
    plan.map(|plan| Some(plan).filter(|_| wanted))
}

/// Layers that are a continuum lie on the rings, have strength, and have depth over the crown.
pub(super) fn check_layers(tables: &[Table<'_>], layers: &[Layer], findings: &mut Findings) {
    let placed = || tables.iter().zip(layers);
    let first_other = layers.iter().position(|layer| !layer.continuum).unwrap_or(layers.len());
    for (table, _) in placed().skip(first_other).filter(|(_, layer)| layer.continuum) {
        findings.error(
            "B219",
            table.place("as"),
            "a continuum lies on a layer that is none",
            "what lies below cannot carry it",
            "write as = \"continuum\" in every [[cover]] below this one, or as = \"weight\" here",
        );
    }
    let body = |layer: &&Layer| layer.particles || layer.slabs.is_some();
    if first_other > 0 {
        for (table, _) in placed().filter(|(_, layer)| body(layer)) {
            findings.error(
                "B219",
                table.place("as"),
                "a layer of bodies lies on a continuum",
                "a continuum carries weight and loads, and no particles or blocks",
                "write as = \"weight\" here, or model no layer as a continuum",
            );
        }
    }
    for (table, layer) in placed().filter(|(_, layer)| layer.continuum) {
        strength(table, layer.friction_angle, layer.cohesion, findings);
    }
    let depth: f64 = layers.iter().take(first_other).map(|layer| layer.thickness).sum();
    // Under a road with levels the depth is not known yet.
    if first_other > 0 && depth < LEAST_DEPTH && tables[0].has("thickness") {
        findings.error(
            "B222",
            tables[0].place("thickness"),
            "the continuum has no depth over the crown",
            "loads would stand on the ring",
            format!("write a thickness of at least \"{} mm\", or as = \"weight\"", 1e3 * LEAST_DEPTH),
        );
    }
}

/// Backing that is a continuum lies under one; under a continuum, backing that is weight alone would leave a hole.
pub(super) fn check_backing(table: &Table<'_>, backing: &Backing, under: bool, findings: &mut Findings) {
    let place = if table.has("as") { table.place("as") } else { table.range };
    match backing.body {
        BackingBody::Continuum => {
            strength(table, backing.friction_angle, backing.cohesion, findings);
            if !under {
                misfit(
                    place,
                    "the backing is a continuum, and the cover above it is none",
                    "write as = \"continuum\" in the lowest [[cover]], or as = \"weight\" or \"blocks\" in [backing]",
                    findings,
                );
            }
        }
        BackingBody::Weight if under => misfit(
            place,
            "the backing is weight alone, and the cover above it is a continuum",
            "write as = \"continuum\" or as = \"blocks\" in [backing]",
            findings,
        ),
        // Particles without a layer of them are refused for that.
        BackingBody::Weight | BackingBody::Particles | BackingBody::Blocks => {}
    }
}

fn misfit(place: TextRange, message: &str, help: &str, findings: &mut Findings) {
    findings.error("B220", place, message, "backing and cover do not fit together", help);
}

/// A soil without friction and cohesion is a fluid.
fn strength(table: &Table<'_>, friction_angle: Option<f64>, cohesion: Option<f64>, findings: &mut Findings) {
    if friction_angle == Some(0.0) && cohesion == Some(0.0) {
        findings.error(
            "B221",
            table.place("cohesion"),
            format!("{} describes a soil without strength", table.title()),
            "a fluid: it has neither friction nor cohesion",
            "give a friction angle or a cohesion",
        );
    }
}
