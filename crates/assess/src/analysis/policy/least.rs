//! The least of what the states of a bridge come to: a load, a thickness, a support movement.

use super::super::parallel::Retold;
use super::super::{AnalysisError, notes};
use super::standing::{Standing, hurts, leading, not_counted, warned};
use super::states::{State, states};
use bridge::Bridge;
use mechanics::blocks::ModelError;
use mechanics::kept;
use mechanics::watch::{Progress, Watch};
use outcome::collapse::{By, Collapse, PathPressure, Permissible, Sought, Status};
use outcome::help::{Help, WithHelp};
use outcome::note::Size;
use structure::blocks::Scene;

/// A method: a model, a kept state of its own, an onlooker.
type Method<'a, T> = &'a dyn Fn(&T, Option<&[u8]>, &mut dyn Watch) -> Result<Collapse, AnalysisError>;

/// What a bridge comes to by a method, with what helps it left out.
pub(crate) fn collapse(
    bridge: &Bridge,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
    method: Method<'_, Bridge>,
) -> Result<Collapse, AnalysisError> {
    let states = states(bridge);
    let (mut led, all) = each(&states, resume, watch, method)?;
    pressed(bridge, &states, &all, &mut led);
    Ok(led)
}

/// The same for blocks of a file or a drawing.
pub(crate) fn of_blocks(
    scene: &Scene,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
    method: Method<'_, Scene>,
) -> Result<Collapse, AnalysisError> {
    Ok(each(&super::scene::states(scene), resume, watch, method)?.0)
}

/// Analyses every state: the result that leads, and what every state came to, where there are several and all were made. A kept state starts with
/// the number of the one that was at work; on resuming, those before it are made again, to the same bits.
fn each<T>(
    states: &[State<T>],
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
    method: Method<'_, T>,
) -> Result<(Collapse, Vec<Collapse>), AnalysisError> {
    if let [alone] = states {
        return Ok((method(&alone.bridge, resume, watch)?, Vec::new()));
    }
    let count = states.len();
    let kept = resume.map(kept::split::<usize>).transpose()?;
    if kept.is_some_and(|(at, _)| at >= count) {
        return Err(ModelError::ForeignState.into());
    }
    let mut all = Vec::with_capacity(count);
    for (number, state) in states.iter().enumerate() {
        let own = kept.and_then(|(at, own)| (at == number).then_some(own));
        let what = match &state.helps[..] {
            [] => "without what may come and go".to_owned(),
            helps => format!("with {}", Help::all_told(helps)),
        };
        let told = |progress: &Progress| Progress {
            stage: format!("{what}: {}", progress.stage),
            fraction: progress.fraction.map(|share| (share + number as f64) / count as f64),
            ..progress.clone()
        };
        let found =
            method(&state.bridge, own, &mut Retold { watch, kept: Some(&|state| kept::join(&number, state)), told })?;
        if found.status == Status::Cancelled {
            return Ok((found, Vec::new()));
        }
        all.push(found);
    }
    let standings: Vec<Standing> =
        states.iter().zip(&all).map(|(state, found)| standing(&state.helps, found)).collect();
    let lead = leading(&standings);
    let mut led = all[lead].clone();
    led.not_counted = not_counted(&standings, lead);
    permissible(&all, &mut led);
    let own = size(&standings[lead].numbers);
    led.warnings.extend(warned(&led.not_counted, None, own, size));
    led.assumptions.extend(hurts(&standings, lead, size));
    Ok((led, all))
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
