//! Fill that is weight and nothing else.

use bridge::{BackingBody, Bridge};

/// The bridge with its fill as weight alone, where it presses or yields as a continuum.
pub fn by_weight_alone(bridge: &Bridge) -> Option<Bridge> {
    let mut own = bridge.clone();
    let yields = own.continuum.take().is_some();
    if yields {
        own.cover.layers.iter_mut().for_each(|layer| layer.continuum = false);
        let backing = own.cover.backing.as_mut().filter(|backing| backing.body == BackingBody::Continuum);
        backing.into_iter().for_each(|backing| backing.body = BackingBody::Weight);
    }
    let presses = own.fill_pressure.as_mut().filter(|fill| fill.applies);
    let presses = presses.map(|fill| fill.applies = false).is_some();
    (yields || presses).then_some(own)
}
