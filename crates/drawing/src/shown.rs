//! What a drawing does not show: entities on layers that are off or frozen, entities that are marked invisible, and paper space.
//! Autodesk, DXF Reference (2018): table LAYER, groups 62 and 70; common groups 60 and 67 of entities.

use crate::finding::{Findings, Place};
use crate::options::{Options, is_ignored};
use findings::words::counted;
use std::collections::BTreeMap;

/// Why an entity is not shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Hidden {
    /// Its layer is off: the colour is negative. What a block reference on it draws on other layers is shown.
    Off,
    /// Its layer is frozen, and with it all that a block reference on it draws.
    Frozen,
    /// It is marked invisible itself.
    Invisible,
    /// It lies in paper space: frames and titles of a sheet.
    PaperSpace,
}

/// Layers that are not shown, by name in capitals.
#[derive(Debug, Clone, Default)]
pub(crate) struct HiddenLayers(BTreeMap<String, Hidden>);

impl HiddenLayers {
    /// An entry of the table of layers.
    pub(crate) fn add(&mut self, name: &str, flags: i16, colour: i16) {
        let hidden = if flags & 1 != 0 {
            Hidden::Frozen
        } else if colour < 0 {
            Hidden::Off
        } else {
            return;
        };
        self.0.insert(name.to_uppercase(), hidden);
    }

    /// Whether a layer hides an entity of a kind on it.
    pub(crate) fn hide(&self, layer: &str, kind: &str) -> Option<Hidden> {
        let hidden = self.0.get(&layer.to_uppercase()).copied();
        hidden.filter(|hidden| kind != "INSERT" || *hidden != Hidden::Off)
    }
}

/// Entities that were left out, counted by layer and reason.
pub(crate) type LeftOut = BTreeMap<(String, Hidden), usize>;

/// Says what was left out, but for layers that the reader was told to pass over.
pub(crate) fn tell(left_out: LeftOut, options: &Options, findings: &mut Findings) {
    for ((layer, hidden), count) in left_out {
        if is_ignored(options, &layer) {
            continue;
        }
        let entities = counted(count, "entity");
        let place = Place { layer: layer.clone(), ..Place::default() };
        let on_hidden = |state: &str| format!("the layer {layer} is {state}: {entities} on it left out");
        let hidden_on = |state: &str| format!("{entities} on the layer {layer} left out: {state}");
        let (message, what) = match hidden {
            Hidden::Off => (on_hidden("off"), "switch the layer on in the drawing if it is"),
            Hidden::Frozen => (on_hidden("frozen"), "thaw the layer in the drawing if it is"),
            Hidden::Invisible => (hidden_on("marked invisible"), "show the objects in the drawing if they are"),
            Hidden::PaperSpace => {
                findings.note("D109", place, hidden_on("in paper space"));
                continue;
            }
        };
        findings.warning("D109", place, message, &format!("{what} part of the bridge"));
    }
}
