//! What a survey's file says of each question, whoever wrote it there: the survey itself, a form, a hand.

use super::answers::NOTHING;
use super::page::{HEAD, NOT_THERE};
use crate::edit::{Document, count};
use crate::path::Path;
use crate::quantity;
use std::collections::BTreeMap;

/// The name of a bridge whose sheet gives none.
pub(super) const NO_NAME: &str = "A bridge";

/// Whether a file was made from a survey.
pub fn is_survey(text: &str) -> bool {
    text.starts_with(HEAD)
}

/// The answers that stand in a survey's file: all that nobody assumed, by their keys. None where the text is not TOML.
pub fn answers(text: &str) -> Option<BTreeMap<String, String>> {
    let file = Kept(Document::parse(text)?);
    let mut found = BTreeMap::new();
    let mut put = |key: &str, value: Option<String>| value.map(|value| found.insert(key.to_owned(), value));
    for line in text.lines().filter_map(|line| line.strip_prefix(NOT_THERE)) {
        let none = |words: &str| NOTHING.iter().find(|one| one.2 == words.trim().trim_end_matches('.'));
        for (key, value, _) in line.split(',').filter_map(none) {
            put(key, Some(value.to_string()));
        }
    }
    put("name", file.said("bridge.name").filter(|name| name != NO_NAME));
    put("width", file.said("bridge.width"));
    let spans = file.count("span");
    for k in 1..=spans {
        let own = |key: &str| if k == 1 { key.to_owned() } else { format!("{key}_{k}") };
        put(&own("span"), file.said(&format!("span[{k}].span")));
        put(&own("rise"), file.said(&format!("span[{k}].rise")));
        put(&own("thickness"), file.thickness(k));
    }
    put("spans", (spans > 1).then(|| spans.to_string()));
    put("rings", Some(file.rings(1)).filter(|rings| *rings > 1).map(|rings| rings.to_string()));
    put("unit", file.stones());
    put("voussoirs", file.counted());
    // Other shapes have no rise, and are written by hand.
    let asked = |shape: &String| ["parabolic", "elliptical", "pointed"].contains(&&shape[..]);
    put("profile", file.said("span[1].profile").filter(asked));
    for k in 1..=file.count("pier") {
        let own = |key: &str| if k == 1 { key.to_owned() } else { format!("{key}_{k}") };
        put(&own("pier_width"), file.said(&format!("pier[{k}].width")));
        put(&own("pier_height"), file.said(&format!("pier[{k}].height")));
    }
    for (key, path) in PLACES {
        put(key, file.said(path));
    }
    put("vehicles", file.list("sweep.vehicles"));
    Some(found)
}

/// Where the answers stand that every file has once.
const PLACES: [(&str, &str); 20] = [
    ("cover", "cover[1].thickness"),
    ("fill", "cover[1].material"),
    ("fill_density", "cover[1].density"),
    ("backing", "backing.height"),
    ("lost_mortar", "defect[1].depth"),
    ("density", "masonry.density"),
    ("strength", "masonry.compressive_strength"),
    ("bond", "ring_joint.cohesion"),
    ("skew", "carriageway.skew"),
    ("axle", "load[1].axle_force"),
    ("rule", "sweep.rule"),
    ("reference", "document.structure_number"),
    ("condition", "document.inspection[1].finding"),
    ("surfacing", "cover[2].thickness"),
    ("surfacing_density", "cover[2].density"),
    ("backing_density", "backing.density"),
    ("friction", "joint.friction_angle"),
    ("ring_friction", "ring_joint.friction_angle"),
    ("fill_friction", "fill_pressure.friction_angle"),
    ("fill_cohesion", "fill_pressure.cohesion"),
];

struct Kept(Document);

impl Kept {
    /// The value at a path that is no assumption.
    fn said(&self, path: &str) -> Option<String> {
        self.written(path).filter(|(_, remark)| !remark.starts_with("assumed")).map(|(value, _)| value)
    }

    fn written(&self, path: &str) -> Option<(String, String)> {
        self.0.said(&Path::parse(path)?)
    }

    fn count(&self, section: &str) -> usize {
        self.0.root().get(section).map_or(0, count)
    }

    fn rings(&self, span: usize) -> usize {
        let ring = |k: usize| self.written(&format!("span[{span}].ring[{k}].thickness")).is_some();
        (1..).take_while(|k| ring(*k)).count().max(1)
    }

    /// That of all rings of a span: as it was measured where the shares still make it.
    fn thickness(&self, span: usize) -> Option<String> {
        let rings = self.rings(span);
        if let Some(whole) = self.said(&format!("span[{span}].thickness")) {
            return Some(whole);
        }
        let (share, remark) = self.written(&format!("span[{span}].ring[1].thickness"))?;
        if remark.starts_with("assumed") {
            return None;
        }
        let share = quantity::parse(&share).ok()?;
        let measured = remark.split_once(" of ").map(|(_, whole)| whole.trim());
        let same = |whole: &&str| {
            quantity::parse(whole).is_ok_and(|whole| (whole.si() - rings as f64 * share.si()).abs() < 1e-3 * whole.si())
        };
        let product = (share.number * rings as f64 * 1e6).round() / 1e6;
        Some(measured.filter(same).map_or_else(|| format!("{product} {}", share.unit.symbol), str::to_owned))
    }

    /// The length of a stone, by the remark beside their number.
    fn stones(&self) -> Option<String> {
        let alone = self.written("span[1].voussoirs");
        let (_, remark) = alone.or_else(|| self.written("span[1].ring[1].voussoirs"))?;
        remark.strip_prefix("stones of ").map(|length| length.trim().to_owned())
    }

    /// The number of stones, where it is not counted with their length.
    fn counted(&self) -> Option<String> {
        let alone = self.written("span[1].voussoirs");
        let (count, remark) = alone.or_else(|| self.written("span[1].ring[1].voussoirs"))?;
        (!remark.contains("stones of ")).then_some(count)
    }

    fn list(&self, path: &str) -> Option<String> {
        let listed = self.0.list(&Path::parse(path)?);
        (!listed.is_empty()).then(|| listed.join(","))
    }
}
