//! `extrados bench disks`: steps of particles in a second.

use super::repeated::least_and_middle;
use crate::args::Bench;
use crate::checkpoint::Checkpoint;
use crate::folder::{Folder, Purpose};
use crate::report::Report;
use crate::status::Status;
use crate::watcher::{asked_to_stop, watched};
use extrados::{Looking, Refusal};
use findings::words::counted;
use mechanics::dem::{State, Workspace, begin, step};
use mechanics::kept::digest;
use mechanics::watch::{Progress, Watch, Wish};
use std::time::Instant;
use verification::disks::{Disks, SOLID_FRACTION, disks, mean_radius, settings};

/// Steps of one repeat: at least as many as there may be between two searches for neighbours, and enough for a clock.
const STEPS: u64 = 1_000;
const PARTICLE_STEPS: u64 = 10_000_000;

/// How many discs where `--count` does not say, and the fewest that make a box.
const DISCS: u32 = 2_000;
const LEAST: u32 = 100;

/// What some steps of one box told.
#[derive(Debug, Clone, Copy, Default)]
struct Stepped {
    searches: u64,
    moved: f64,
}

/// One repeat after the other: the box on all threads and, where it is wanted, copies of it side by side.
pub(super) fn run(quiet: bool, arguments: &Bench) -> Result<Report, Refusal> {
    let count = arguments.count.unwrap_or(DISCS).max(LEAST) as usize;
    if let Some(steps) = arguments.steps {
        return watched(quiet, |onlooker| from_the_packing(&mut Looking(onlooker), arguments, count, u64::from(steps)));
    }
    let built = watched(quiet, |onlooker| {
        let onlooker = &mut Looking(onlooker);
        disks(count, onlooker).map(|disks| disks.settled(onlooker).map(|state| (disks, state)))
    });
    let (disks, (mut state, mut work)) = match built {
        Ok(Some(built)) => built,
        _ if asked_to_stop() => return Ok(Report::new(Status::Cancelled)),
        Ok(None) => return Ok(Report::new(Status::Cancelled)),
        Err(error) => return Err(Refusal::new("F108", error.to_string(), "extrados explain F108 tells more")),
    };
    let mut copies: Vec<(State, Workspace)> =
        (0..arguments.copies.unwrap_or(0)).map(|_| (state.clone(), work.clone())).collect();
    let steps = STEPS.max(PARTICLE_STEPS / count as u64);
    let (mut alone, mut together) = (Vec::new(), Vec::new());
    let mut stepped = Stepped::default();
    for _ in 0..arguments.repeats {
        if asked_to_stop() {
            return Ok(Report::new(Status::Cancelled));
        }
        let clock = Instant::now();
        stepped = run_steps(&disks, (&mut state, &mut work), steps);
        alone.push(clock.elapsed().as_secs_f64());
        if !copies.is_empty() {
            together.push(side_by_side(&disks, &mut copies, steps)?);
        }
    }
    let rate = |seconds: &mut [f64], boxes: usize| {
        let done = (boxes * count) as f64 * steps as f64;
        least_and_middle(seconds).map(|seconds| done / seconds)
    };
    let [best, middle] = rate(&mut alone, 1);
    let touching = disks.touching(&state);
    let bytes = state.particle_bytes(&disks.model, &work) as f64 / count as f64;
    let threads = rayon::current_num_threads();
    let moved = stepped.moved / mean_radius();
    let mut report = Report::new(Status::Completed)
        .with("name", "disks")
        .with("size", count)
        .with("repeats", arguments.repeats)
        .with("particle_steps_per_second", best)
        .with("particle_steps_per_second_median", middle)
        .with("contacts_per_particle", touching.contacts_per_particle)
        .with("coordination", touching.coordination)
        .with("bytes_per_particle", bytes)
        .with("solid_fraction", SOLID_FRACTION)
        .with("steps", steps)
        .with("seconds", alone[0])
        .with("searches", stepped.searches)
        .with("largest_move_per_step_radii", moved)
        .with("tiles", disks.tiles);
    let mut words = format!(
        "disks: {:.2} million particle steps a second (median {:.2} of {}), {count} discs, {}\n\
         {steps} steps in {:.3} s with {} searches; {:.2} contacts a disc, coordination {:.2}, {bytes:.0} bytes a disc, {moved:.0e} \
         of a radius in a step at most\n",
        best / 1e6,
        middle / 1e6,
        arguments.repeats,
        counted(threads, "thread"),
        alone[0],
        stepped.searches,
        touching.contacts_per_particle,
        touching.coordination,
    );
    if !copies.is_empty() {
        let [of_copies, _] = rate(&mut together, copies.len());
        report = report
            .with("copies", copies.len())
            .with("copies_particle_steps_per_second", of_copies)
            .with("share_of_copies", best / of_copies);
        words += &format!(
            "{} copies on one thread each: {:.2} million together; {} on one box reach {:.0} % of that\n",
            copies.len(),
            of_copies / 1e6,
            counted(threads, "thread"),
            100.0 * best / of_copies,
        );
    }
    Ok(report.saying(words))
}

/// So many steps from the expanded packing on, while friction and gravity bring it to rest.
fn from_the_packing(onlooker: &mut dyn Watch, arguments: &Bench, count: usize, steps: u64) -> Result<Report, Refusal> {
    const LOOK: u64 = 20;
    const KEEP_EVERY: f64 = 30.0;
    let disks = match disks(count, onlooker) {
        Ok(disks) => disks,
        Err(_) if asked_to_stop() => return Ok(Report::new(Status::Cancelled)),
        Err(error) => return Err(Refusal::new("F108", error.to_string(), "extrados explain F108 tells more")),
    };
    let (mut state, mut work, mut searches) = (begin(&disks.model, &settings()), Workspace::default(), 0);
    // An empty folder goes when it is let go of.
    let folder = arguments.checkpoint.as_deref();
    let folder = folder.map(|path| Folder::prepare(path, Purpose::new("bench", path, &[]))).transpose()?;
    let checkpoint = folder.as_ref().map(|folder| Checkpoint::of(&("disks", count, steps), folder));
    if let Some(kept) = checkpoint.as_ref().map(Checkpoint::take_up).transpose()?.flatten() {
        let foreign = |_| Refusal::new("F110", "the checkpoint is of another box of discs", "name another folder");
        state = State::from_bytes(&disks.model, &kept).map_err(foreign)?;
    }
    let resumed = state.steps;
    let (mut keeping, mut kept, mut keeps) = (0.0, Instant::now(), 0);
    let clock = Instant::now();
    while state.steps < steps {
        if let Some(checkpoint) = checkpoint.as_ref().filter(|_| kept.elapsed().as_secs_f64() > KEEP_EVERY) {
            let clock = Instant::now();
            checkpoint.keep(&state.bytes())?;
            keeping += clock.elapsed().as_secs_f64();
            (kept, keeps) = (Instant::now(), keeps + 1);
        }
        let next = LOOK.min(steps - state.steps);
        let stepped = run_steps(&disks, (&mut state, &mut work), next);
        searches += stepped.searches;
        let (fraction, moved) = (Some(state.steps as f64 / steps as f64), stepped.moved / mean_radius());
        let stage = format!("from the packing to rest, {moved:.0e} of a radius a step");
        if onlooker.look(&Progress { stage, fraction, steps: state.steps }) == Wish::Stop {
            return Ok(Report::new(Status::Cancelled));
        }
    }
    let seconds = clock.elapsed().as_secs_f64() - keeping;
    if let Some(checkpoint) = checkpoint {
        checkpoint.remove();
    }
    let rate = count as f64 * (steps - resumed) as f64 / seconds;
    let touching = disks.touching(&state);
    let bytes = state.particle_bytes(&disks.model, &work) as f64 / count as f64;
    Ok(Report::new(Status::Completed)
        .with("name", "disks")
        .with("size", count)
        .with("repeats", 1)
        .with("particle_steps_per_second", rate)
        .with("contacts_per_particle", touching.contacts_per_particle)
        .with("coordination", touching.coordination)
        .with("bytes_per_particle", bytes)
        .with("solid_fraction", SOLID_FRACTION)
        .with("steps", steps)
        .with("seconds", seconds)
        .with("searches", searches)
        .with("tiles", disks.tiles)
        .with("resumed_at_step", resumed)
        .with("checkpoints", keeps)
        .with("seconds_of_checkpoints", keeping)
        .with("fingerprint_of_state", format!("{:016x}", digest(&state.bytes())))
        .saying(format!(
            "disks: {:.2} million particle steps a second, {count} discs, steps {resumed} to {steps} from the expanded packing on in \
             {seconds:.1} s with {searches} searches; coordination {:.2}, {bytes:.0} bytes a disc\n{keeps} checkpoints in {keeping:.1} s\n",
            rate / 1e6,
            touching.coordination,
        )))
}

fn run_steps(disks: &Disks, (state, work): (&mut State, &mut Workspace), steps: u64) -> Stepped {
    let settings = settings();
    let mut stepped = Stepped::default();
    for _ in 0..steps {
        let report = step(&disks.model, state, work, &settings);
        stepped.searches += u64::from(report.searched);
        stepped.moved = stepped.moved.max(report.particles_moved);
    }
    stepped
}

/// Seconds until the last of the copies has made its steps, each on a thread of its own.
fn side_by_side(disks: &Disks, copies: &mut [(State, Workspace)], steps: u64) -> Result<f64, Refusal> {
    let no_thread =
        |error: rayon::ThreadPoolBuildError| Refusal::new("F108", error.to_string(), "ask for fewer copies");
    let pool = |_| rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(no_thread);
    let pools: Vec<rayon::ThreadPool> = (0..copies.len()).map(pool).collect::<Result<_, _>>()?;
    let clock = Instant::now();
    std::thread::scope(|scope| {
        for (pool, (state, work)) in pools.iter().zip(copies) {
            scope.spawn(move || pool.install(|| run_steps(disks, (state, work), steps)));
        }
    });
    Ok(clock.elapsed().as_secs_f64())
}
