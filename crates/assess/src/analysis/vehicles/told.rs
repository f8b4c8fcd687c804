//! The governing case in words, for drawings: which vehicle, how often, which way, and where its axles stand.

use bridge::{Bridge, Load, LoadKind};
use outcome::vehicles::{Case, Direction, Swept};

/// Vehicle, adequacy factor, direction and the places of what stands on the bridge `loaded` with the case.
pub fn case(swept: &Swept, case: &Case, loaded: &Bridge) -> String {
    let factor = swept.adequacy.map_or(String::new(), |a| format!(" \u{d7} {a:.3}"));
    let way = match case.direction {
        Direction::Right => "travelling to the right",
        Direction::Left => "travelling to the left",
    };
    let mut parts = vec![format!("{}{factor}, {way}", swept.title)];
    parts.extend(case.axles.map(|[first, last]| axles(first, last, &loaded.loads)));
    parts.extend(case.uniform.map(|[from, to]| format!("uniform load from {from:.2} m to {to:.2} m")));
    format!("{}. Positions are measured from the left springing of the first span.", parts.join("; "))
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
