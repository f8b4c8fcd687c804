//! The least of what the states of a bridge come to: a load, a thickness, a support movement.

use super::super::notes;
use super::standing::{Standing, hurts, leading, not_counted, warned};
use super::states::State;
use bridge::Bridge;
use outcome::collapse::{By, Collapse, PathPressure, Permissible, Sought, Status};
use outcome::help::{Help, WithHelp};
use outcome::note::Size;

/// What leads of what every state of a bridge came to, with what the others came to beside it.
pub(in crate::analysis) fn least(bridge: &Bridge, states: &[State<Bridge>], all: &[Collapse]) -> Collapse {
    let mut led = least_of(states, all);
    if all.len() == states.len() {
        pressed(bridge, states, all, &mut led);
    }
    led
}

/// The same for blocks of a file or a drawing. The last one leads where it was cancelled.
pub(in crate::analysis) fn least_of<T>(states: &[State<T>], all: &[Collapse]) -> Collapse {
    if let [.., last] = all
        && (states.len() == 1 || last.is_cancelled())
    {
        return last.clone();
    }
    let standings: Vec<Standing> = states.iter().zip(all).map(|(state, found)| standing(&state.helps, found)).collect();
    let lead = leading(&standings);
    let mut led = all[lead].clone();
    led.not_counted = not_counted(&standings, lead);
    permissible(all, &mut led);
    let own = size(&standings[lead].numbers);
    led.warnings.extend(warned(&led.not_counted, None, own, size));
    led.assumptions.extend(hurts(&standings, lead, size));
    led
}

/// What a state comes to. What is not known is least; what nothing makes fall is most.
fn standing(helps: &[Help], found: &Collapse) -> Standing {
    let carried = found.carried();
    let mut numbers = WithHelp { helps: helps.to_vec(), status: found.status, ..WithHelp::default() };
    let known = match found.sought {
        Sought::Load => {
            (numbers.last_stable_load, numbers.headline) = (found.last_stable_load, carried);
            numbers.factor = found.load_factor();
            carried
        }
        Sought::Thickness(report) => {
            numbers.thickness_factor = report.map(|report| report.factor[1]);
            numbers.thickness_factor.map(|factor| -factor)
        }
        Sought::SupportMovement(report) => {
            numbers.movement = report.last_stable;
            report.last_stable
        }
    };
    let stands = match found.sought {
        Sought::Thickness(_) => found.status == Status::StableToLastLoad,
        Sought::Load | Sought::SupportMovement(_) => found.status == Status::Locks,
    };
    let size = known.unwrap_or(if stands { f64::INFINITY } else { f64::NEG_INFINITY });
    Standing { size, numbers }
}

/// The number of a state.
fn size(of: &WithHelp) -> Size {
    match (of.headline, of.thickness_factor, of.movement) {
        (Some(load), ..) => Size::Load(load),
        (_, Some(factor), _) => Size::Thickness(factor),
        (.., Some(movement)) => Size::Movement(movement),
        _ => Size::NoLoad(of.status),
    }
}

/// A state that should not be met in service is met at the least load of any.
fn permissible(all: &[Collapse], led: &mut Collapse) {
    let mut least: Vec<Permissible> = Vec::new();
    for one in all.iter().filter_map(Collapse::along).flat_map(|path| &path.permissible) {
        match least.iter_mut().find(|known| known.criterion == one.criterion) {
            Some(known) => known.load = known.load.min(one.load),
            None => least.push(*one),
        }
    }
    if let By::Path(path) = &mut led.by {
        path.permissible = least;
    }
}

/// With fill that presses, the load by weight alone and that with pressure stand beside one another in every result.
fn pressed(bridge: &Bridge, states: &[State<Bridge>], all: &[Collapse], led: &mut Collapse) {
    let presses = |state: &State<Bridge>| state.helps.contains(&Help::FillPressure);
    let Some((_, with)) = states.iter().zip(all).rfind(|(state, _)| presses(state)) else { return };
    let size = |found: &Collapse| found.carried().unwrap_or(f64::NEG_INFINITY);
    let bare = states.iter().zip(all).filter(|(state, _)| !presses(state)).map(|(_, found)| found);
    let Some(bare) = bare.min_by(|a, b| size(a).total_cmp(&size(b))) else { return };
    match (&mut led.by, &with.by) {
        (By::Limit(own), By::Limit(with)) => {
            own.without_fill_pressure_load = bare.collapse_load;
            own.full_fill_pressure_load = with.full_fill_pressure_load;
        }
        (By::Path(own), By::Path(with)) => {
            let mobilised = with.fill_pressure.map_or(0.0, |fill| fill.mobilised);
            own.fill_pressure = Some(PathPressure { without: bare.last_stable_load, mobilised });
        }
        _ => {}
    }
    led.warnings.extend(notes::pressure_range(bridge, bare, with));
}
