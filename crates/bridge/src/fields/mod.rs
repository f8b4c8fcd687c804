//! Field cards: one table of everything a bridge file may say (`card.rs` has what a card is). Accessors, error messages, the JSON Schema and the
//! input reference are all made from it, so that they cannot disagree.

pub mod blocks;
pub(crate) mod case;
pub(crate) mod continuum;
pub(crate) mod cover;
pub(crate) mod defect;
pub(crate) mod edge;
pub(crate) mod load_test;
pub(crate) mod loading;
pub(crate) mod material;
pub(crate) mod particles;
pub(crate) mod passage;
pub(crate) mod plan;
pub(crate) mod road;
pub(crate) mod service;
pub(crate) mod spandrel;
pub(crate) mod structure;
pub(crate) mod support;
pub(crate) mod sweep;
pub(crate) mod train;
pub(crate) mod vary;
pub(crate) mod vehicle;
pub(crate) mod wall;

pub use crate::card::*;
use crate::cards::*;
use crate::findings::Findings;
use crate::model::{Calibration, Cover};
use crate::service::Service;
use crate::tree::Table;

/// The whole file.
pub static FILE: Section = Section {
    path: "",
    doc: "A masonry arch bridge and what to analyse. Quantities are text with a unit: \"18.30 m\", \"15 GPa\".",
    fields: &[
        table("bridge", &structure::BRIDGE, "The bridge as a whole."),
        tables("span", &structure::SPAN, "The spans, from left to right.").at_most(200.0),
        tables("pier", &support::PIER, "The piers between the spans, from left to right; a single one describes all.")
            .at_most(200.0)
            .optional("a bridge of one span has none"),
        table("abutment", &support::ABUTMENT, "What holds the outer springings.")
            .optional("fixed, and drawn with its defaults"),
        table("masonry", &material::MASONRY, "Masonry of rings and piers."),
        table("joint", &material::JOINT, "Joints between voussoirs, at springings and between the courses of piers."),
        table("ring_joint", &material::RING_JOINT, "Joints between the rings of a span.")
            .optional("rings are joined as voussoirs are"),
        table("spandrel_wall", &wall::SPANDREL_WALL, "Spandrel walls that stand on the rings.").optional("no walls"),
        table("wall_joint", &material::WALL_JOINT, "Joints of the spandrel walls.")
            .optional("bricks are joined as voussoirs are; each contact point represents half its own joint"),
        table("parapet", &edge::PARAPET, "Parapets at both edges.").optional("drawn and weighed without parapets"),
        table("kerb", &edge::KERB, "Kerbs at both edges.").optional("drawn and weighed without kerbs"),
        table("particles", &particles::PARTICLES, "Fill as particles.").optional("no layer is modelled as particles"),
        table("particle_joint", &material::PARTICLE_JOINT, "Contacts between particles.")
            .optional("no layer is modelled as particles"),
        table("particle_block_joint", &material::PARTICLE_BLOCK_JOINT, "Contacts of particles with blocks.")
            .optional("as contacts between particles"),
        table("calibration", &crate::calibration::CALIBRATION, "How the contact stiffness of particles is found.")
            .optional("the defaults"),
        tables("cover", &cover::COVER, "Layers above the rings, from the extrados up.")
            .at_most(50.0)
            .optional("nothing lies on the extrados"),
        table("road", &road::ROAD, "Levels of the surface, where it is not level.").optional("the surface is level"),
        table("water", &cover::WATER, "Water in the pores of the fill.").optional("the fill is drained"),
        table("backing", &cover::BACKING, "Solid backing above the haunches.").optional("no backing"),
        table("internal_walls", &spandrel::INTERNAL_WALLS, "Walls between the outer spandrel walls.").optional("none"),
        tables("void", &spandrel::VOID, "Voids in the spandrels, and what carries their roofs.")
            .at_most(200.0)
            .optional("the spandrels are filled"),
        tables("defect", &defect::DEFECT, "What is wrong with the rings, and where.")
            .at_most(200.0)
            .optional("the rings are sound"),
        table("continuum", &continuum::CONTINUUM, "How layers and backing that are a continuum are modelled.")
            .optional("the defaults"),
        table("dispersal", &loading::DISPERSAL, "How loads spread through the cover.")
            .optional("possible only where there is no cover or no load"),
        table(
            "fill_pressure",
            &sweep::FILL_PRESSURE,
            "Horizontal pressure of the fill against movement, in limit analysis.",
        )
        .optional("fill has weight and spreads loads, but does not press sideways"),
        table("carriageway", &sweep::CARRIAGEWAY, "Possible positions of vehicles of [sweep] across the bridge.")
            .optional("one vehicle in the middle; on roads two abreast where they fit"),
        table("sweep", &sweep::SWEEP, "Vehicles that `extrados collapse --sweep` moves over the bridge.")
            .optional("`--sweep` moves the loads of the file"),
        tables("load", &loading::LOAD, "Loads on the surface; together they form the pattern that grows to collapse.")
            .at_most(200.0)
            .optional("possible only for analyses without a load"),
        tables("case", &case::CASE, "Named cases that `extrados cases` compares.")
            .optional("the loads of the file act together, once"),
        table("support_movement", &plan::SUPPORT_MOVEMENT, "A movement of one support.")
            .optional("supports do not move"),
        table("analysis", &plan::ANALYSIS, "What to analyse, and how exactly.")
            .optional("limit analysis of the load, with the defaults"),
        table("mesh", &service::MESH, "The finite element mesh.").optional("the defaults"),
        table("fill", &service::FILL, "Fill above the rings, in the finite element model.")
            .optional("not needed for collapse"),
        table("haunch_fill", &service::HAUNCH_FILL, "Fill of the haunches.")
            .optional("the haunches have the same fill as the rest"),
        table("abutment_fill", &service::ABUTMENT_FILL, "Fill behind the abutments.")
            .optional("as the rest of the fill"),
        table("mortar", &service::MORTAR, "Mortar of the joints, in the finite element model.")
            .optional("not needed for collapse"),
        table("fill_contact", &service::FILL_CONTACT, "Contact of fill with masonry.")
            .optional("not needed for collapse"),
        table("train", &train::TRAIN, "The train that crosses in `extrados respond`.").optional("no train crosses"),
        table("track", &train::TRACK, "How axles reach the fill: rails, sleepers, ballast.")
            .optional("possible only where no train crosses"),
        table(
            "vehicle",
            &vehicle::VEHICLE,
            "The road vehicle that crosses in `extrados respond`, in place of [train] and [track].",
        )
        .optional("no road vehicle crosses"),
        table("passage", &passage::PASSAGE, "How the train or the vehicle crosses, and how that is analysed.")
            .optional("possible only where nothing crosses"),
        tables("sensor", &crate::sensor::SENSOR, "What is measured while the train or the vehicle crosses.").optional(
            "crown, pier springing and abutment springing of the first span: displacement and strain of each",
        ),
        table("load_test", &load_test::LOAD_TEST, "Loads at rest on the bridge, and what was read.")
            .optional("no load stands still on the bridge"),
        tables("vary", &vary::VARY, "What `extrados vary` changes, and over which values.")
            .optional("nothing is varied"),
        table("records", &crate::update::RECORDS, "Records that `extrados update` compares with.")
            .optional("possible only without parameters"),
        tables("channel", &crate::update::CHANNEL, "What is known of the records' channels.")
            .optional("all sensors are compared, by their names"),
        tables("parameter", &crate::update::PARAMETER, "What `extrados update` searches for.")
            .optional("there is no search"),
        table("update", &crate::update::UPDATE, "How `extrados update` searches for it.").optional("the defaults"),
        table("assess", &crate::assess::ASSESS, "Limits that `extrados assess` compares with.")
            .optional("checks that need a limit are not made"),
        tables("service_load", &crate::assess::SERVICE_LOAD, "Loads in service.").optional("the train as it is"),
        table("mexe", &crate::assess::MEXE, "Factors of the modified MEXE method.")
            .optional("the MEXE check is not made"),
        tables("expected", &crate::assess::EXPECTED, "Where identified parameters are expected.")
            .optional("identified parameters are listed without a verdict"),
        table("document", &crate::document::DOCUMENT, "Identification, revisions and signatures of the report.")
            .optional("the report has blank fields to fill in"),
    ],
};

/// A file of ranges alone.
pub(crate) static RANGES: Section = Section {
    path: "",
    doc: "Quantities of a bridge file and their values.",
    fields: &[tables("vary", &vary::VARY, "What `extrados vary` changes, and over which values.")],
};

/// What a part is of which a file says nothing, for which every key needs a default on its card.
pub(crate) fn by_cards<T>(read: impl FnOnce(&Table<'_>, &mut Findings) -> Option<T>) -> T {
    read(&Table::absent(&FILE), &mut Findings::default()).expect("cards with defaults")
}

impl Default for Calibration {
    fn default() -> Calibration {
        by_cards(crate::calibration::calibration)
    }
}

impl Default for Service {
    fn default() -> Service {
        by_cards(|file, findings| service::service(file, None, findings))
    }
}

impl Service {
    /// What a file with this cover means that says nothing of the finite element model.
    pub fn of_cover(cover: &Cover) -> Service {
        by_cards(|file, findings| service::service(file, Some(cover), findings))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A card cannot name a word that its selector does not have, nor a default that cannot be read.
    #[test]
    fn words_and_defaults_of_cards_can_be_read() {
        for section in [&FILE, &blocks::FILE].into_iter().flat_map(sections_of) {
            let absent = Table::absent(section);
            for field in section.fields {
                let words = |field: &Field| match field.kind {
                    Kind::Word(words) => words.iter().map(|word| word.word).collect::<Vec<_>>(),
                    _ => Vec::new(),
                };
                if let Some((key, wanted)) = field.only {
                    let known = section.field(key).map(words).unwrap_or_default();
                    assert!(wanted.iter().all(|word| known.contains(word)), "{}.{}", section.path, field.key);
                }
                let Need::Default(value) = field.need else { continue };
                let mut findings = Findings::default();
                let read = match field.kind {
                    Kind::Word(_) => words(field).contains(&value),
                    Kind::Flag => absent.read::<bool>(field.key, &mut findings).is_some(),
                    Kind::Count => absent.read::<u64>(field.key, &mut findings).is_some(),
                    Kind::Text => absent.read::<String>(field.key, &mut findings).is_some(),
                    Kind::Numbers | Kind::Quantities(_) => absent.read::<Vec<f64>>(field.key, &mut findings).is_some(),
                    _ => absent.read::<f64>(field.key, &mut findings).is_some(),
                };
                assert!(read, "{}.{} = {value}", section.path, field.key);
            }
        }
    }

    #[test]
    fn a_gauge_is_as_long_by_its_card_as_by_the_default_sensors() {
        let absent = Table::absent(&crate::sensor::SENSOR);
        let length: Option<f64> = absent.read("gauge_length", &mut Findings::default());
        assert_eq!(length, Some(crate::passage::GAUGE_LENGTH));
    }
}
