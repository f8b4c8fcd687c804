//! The passage by the whole system: every unknown at every position, at rest or in motion.

use super::moment::moment;
use super::{AtRest, Solution, end, of_step, read, with_train};
use crate::analysis::AnalysisError;
use crate::analysis::passage::PassageError;
use bridge::passage::PassageAnalysis;
use mechanics::fem::condensed::open_interfaces;
use mechanics::fem::{
    Damping, Integration, Motion, Outcome, Settings, State, Status, Target, Workspace, advance, transient,
};
use mechanics::watch::{Progress, Unwatched, Watch, Wish};
use outcome::passage::Part;
use outcome::passage::StepLog;

pub fn pass(
    rest: &AtRest<'_>,
    mut state: State,
    mut work: Workspace,
    solution: &mut Solution,
    watch: &mut dyn Watch,
) -> Result<(), AnalysisError> {
    let (setup, model) = (rest.setup, rest.model);
    let plan = &setup.plan;
    let settings = Settings {
        tolerance: plan.tolerance,
        load_steps: 1,
        iteration_limit: plan.iterations as u32,
        ..Settings::default()
    };
    let motion = match plan.analysis {
        PassageAnalysis::Static => None,
        PassageAnalysis::Transient => Some(motion(rest, &mut work)?),
    };
    let count = setup.positions.len();
    let pictures: Vec<usize> = pictures(&setup.plan.pictures, &setup.positions);
    // Where the file names no positions, the bridge is kept at each channel's largest value so far.
    let mut peaks: Vec<Option<(usize, State)>> = vec![None; setup.sensors.len()];
    for (k, (&position, &time)) in setup.positions.iter().zip(&setup.times).enumerate() {
        let progress = Progress {
            stage: format!("position {} of {count}", k + 1),
            fraction: Some(k as f64 / count as f64),
            steps: k as u64,
        };
        if watch.look(&progress) == Wish::Stop {
            solution.status = super::PassageStatus::Cancelled;
            return Ok(());
        }
        let forces = with_train(rest, position);
        let outcome: Outcome = match &motion {
            None => {
                let target = Target { forces, imposed: Vec::new() };
                advance(model, &mut state, &mut work, &target, &settings, &mut Unwatched)
            }
            Some(motion) => {
                let (mut given, mut unseen) = (|_| forces.clone(), |_: u64, _: &State, _: &Workspace| {});
                transient(model, &mut state, &mut work, motion, 1, &mut given, &mut unseen, &settings, &mut Unwatched)
            }
        };
        if let Some(step) = outcome.steps.last() {
            let cuts = outcome.steps.iter().filter(|step| !step.kept).count();
            let iterations = outcome.iterations as usize;
            let open_joints = open_interfaces(model, state.bonds.iter());
            solution.log.push(StepLog {
                stage: Part::Passage,
                time,
                position,
                cuts,
                iterations,
                open_joints,
                ..of_step(step)
            });
        }
        if outcome.status != Status::Completed {
            end(solution, &outcome, &format!("with the first axle at {position:.3} m"));
            break;
        }
        for (s, sensor) in setup.sensors.iter().enumerate() {
            let value = read(&sensor.reading, &state) - solution.self_weight[s];
            let largest = solution.values[s].iter().fold(0.0_f64, |most, v| most.max(v.abs()));
            solution.values[s].push(value);
            if setup.plan.pictures.is_empty() && value.abs() > largest {
                peaks[s] = Some((k, state.clone()));
            }
        }
        if pictures.contains(&k) {
            let name = format!("first axle at {position:.2} m");
            solution.moments.push(moment(setup, model, &state, &name, Some((time, position))));
        }
    }
    for (sensor, (k, state)) in setup.sensors.iter().zip(&peaks).filter_map(|(s, p)| Some((s, p.as_ref()?))) {
        let name = format!("peak of {}", sensor.name);
        solution.moments.push(moment(setup, model, state, &name, Some((setup.times[*k], setup.positions[*k]))));
    }
    Ok(())
}

fn pictures(wanted: &[f64], positions: &[f64]) -> Vec<usize> {
    let nearest = |x: &f64| {
        let near = |k: &usize| (positions[*k] - x).abs();
        (0..positions.len()).min_by(|a, b| near(a).total_cmp(&near(b)))
    };
    wanted.iter().filter_map(nearest).collect()
}

/// Masses, damping and scheme.
fn motion(rest: &AtRest<'_>, work: &mut Workspace) -> Result<Motion, AnalysisError> {
    let plan = &rest.setup.plan;
    let damping = plan.damping.map_or(Damping::default(), |rayleigh| {
        Damping::of(rayleigh.ratio, rayleigh.frequencies.map(|f| 2.0 * std::f64::consts::PI * f))
    });
    let integration = Integration::hilber_hughes_taylor(-plan.numerical_damping);
    Ok(Motion::new(rest.model, work, integration, damping, plan.time_step).map_err(PassageError::from)?)
}
