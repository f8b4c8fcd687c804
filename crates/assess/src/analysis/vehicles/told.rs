//! In words: the governing case, for drawings (which vehicle, how often, which way, where its axles stand), and what joints that
//! give assume and leave open.

use bridge::{Bridge, Load, LoadKind};
use outcome::note;
use outcome::vehicles::{Case, Direction, Swept};
use outcome::warning::{self, BrokenPath, Warning};

/// Vehicle, adequacy factor, direction and the places of what stands on the bridge `loaded` with the case.
pub(super) fn case(swept: &Swept, case: &Case, loaded: &Bridge) -> String {
    let factor = swept.adequacy.map_or(String::new(), |a| format!(" \u{d7} {a:.3}"));
    let way = match case.direction {
        Direction::Right => "travelling to the right",
        Direction::Left => "travelling to the left",
    };
    let mut parts = vec![format!("{}{factor}, {way}", swept.title)];
    parts.extend(case.axles.map(|[first, last]| axles(first, last, &loaded.loads)));
    parts.extend(case.uniform.map(|[from, to]| format!("uniform load from {from:.2} m to {to:.2} m")));
    parts.extend(along(case.horizontal));
    format!("{}. Positions are measured from the left springing of the first span.", parts.join("; "))
}

/// Braking or traction of a case, in words.
pub(super) fn along(horizontal: f64) -> Option<String> {
    let way = if horizontal > 0.0 { "right" } else { "left" };
    (horizontal != 0.0)
        .then(|| format!("{:.0} % of the loads act along the bridge, to the {way}", 100.0 * horizontal.abs()))
}

/// "axles 2 to 5 of it on the bridge, at 8.39, 6.87, 5.34 and 3.82 m".
fn axles(first: usize, last: usize, loads: &[Load]) -> String {
    let is_axle = |l: &&Load| matches!(l.kind, LoadKind::Axles { .. });
    let places: Vec<String> = loads.iter().filter(is_axle).map(|l| format!("{:.2}", l.position)).collect();
    let at = match &places[..] {
        [but_last @ .., end] if !but_last.is_empty() => format!("{} and {end}", but_last.join(", ")),
        _ => places.join(""),
    };
    if first == last {
        format!("axle {} alone on the bridge, at {at} m", first + 1)
    } else {
        format!("axles {} to {} on the bridge, at {at} m", first + 1, last + 1)
    }
}

/// What is to be said of paths that broke off, and of a self-weight that was not found.
pub(super) fn broken_off(all: &[Swept]) -> Option<Warning> {
    let told = |one: &Swept| {
        let own = one.deformable.as_ref()?;
        let path = match (own.stands, own.broken_off) {
            (false, _) if own.falls => BrokenPath::Falls,
            (false, _) => BrokenPath::NotFound,
            (true, 0) => return None,
            (true, open) => BrokenPath::Positions { open, of: one.envelope.len() },
        };
        Some((one.code.clone(), path))
    };
    let vehicles: Vec<_> = all.iter().filter_map(told).collect();
    (!vehicles.is_empty()).then(|| warning::Vehicles::PathsBrokenOff { vehicles }.into())
}

/// What following deformable joints assumes, or that they were not followed.
pub(super) fn assumed(all: &[Swept]) -> note::Moving {
    match all.iter().all(|one| one.deformable.is_none()) {
        true => note::Moving::RigidAlone,
        false => note::Moving::DeformableJointsOfVehicles,
    }
}
