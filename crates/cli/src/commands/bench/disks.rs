//! `extrados bench disks`: steps of particles in a second.

use crate::args::Bench;
use crate::clock::Clock;
use crate::commands::Desk;
use crate::failure::Failure;
use crate::report::Report;
use crate::status::Status;
use crate::watcher::{Spectator, asked_to_stop};
use assess::disks::{Disks, SOLID_FRACTION, disks, mean_radius, settings};
use mechanics::dem::{State, Workspace, step};

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
pub fn run(desk: &Desk, arguments: &Bench) -> Result<Report, Failure> {
    let count = arguments.count.unwrap_or(DISCS).max(LEAST) as usize;
    let mut onlooker = Spectator::new(desk.screen.quiet || desk.screen.json);
    let built = disks(count, &mut onlooker).map(|disks| disks.settled(&mut onlooker).map(|state| (disks, state)));
    onlooker.finish();
    let (disks, (mut state, mut work)) = match built {
        Ok(Some(built)) => built,
        _ if asked_to_stop() => return Ok(Report::new(Status::Cancelled)),
        Ok(None) => return Ok(Report::new(Status::Cancelled)),
        Err(error) => return Err(Failure::input("F108", error.to_string(), "extrados explain F108 tells more")),
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
        let clock = Clock::start();
        stepped = run_steps(&disks, (&mut state, &mut work), steps);
        alone.push(clock.seconds());
        if !copies.is_empty() {
            together.push(side_by_side(&disks, &mut copies, steps)?);
        }
    }
    let rate = |seconds: &mut Vec<f64>, boxes: usize| {
        seconds.sort_by(f64::total_cmp);
        let done = (boxes * count) as f64 * steps as f64;
        (done / seconds[0], done / seconds[seconds.len() / 2])
    };
    let (best, middle) = rate(&mut alone, 1);
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
        "disks: {:.2} million particle steps a second (median {:.2} of {}), {count} discs, {threads} thread{}\n\
         {steps} steps in {:.3} s with {} searches; {:.2} contacts a disc, coordination {:.2}, {bytes:.0} bytes a disc, {moved:.0e} \
         of a radius in a step at most\n",
        best / 1e6,
        middle / 1e6,
        arguments.repeats,
        if threads == 1 { "" } else { "s" },
        alone[0],
        stepped.searches,
        touching.contacts_per_particle,
        touching.coordination,
    );
    if !copies.is_empty() {
        let (of_copies, _) = rate(&mut together, copies.len());
        report = report
            .with("copies", copies.len())
            .with("copies_particle_steps_per_second", of_copies)
            .with("share_of_copies", best / of_copies);
        words += &format!(
            "{} copies on one thread each: {:.2} million together; {threads} thread{} on one box reach {:.0} % of that\n",
            copies.len(),
            of_copies / 1e6,
            if threads == 1 { "" } else { "s" },
            100.0 * best / of_copies,
        );
    }
    Ok(report.saying(words))
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
fn side_by_side(disks: &Disks, copies: &mut [(State, Workspace)], steps: u64) -> Result<f64, Failure> {
    let no_thread =
        |error: rayon::ThreadPoolBuildError| Failure::input("F108", error.to_string(), "ask for fewer copies");
    let pool = |_| rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(no_thread);
    let pools: Vec<rayon::ThreadPool> = (0..copies.len()).map(pool).collect::<Result<_, _>>()?;
    let clock = Clock::start();
    std::thread::scope(|scope| {
        for (pool, (state, work)) in pools.iter().zip(copies) {
            scope.spawn(move || pool.install(|| run_steps(disks, (state, work), steps)));
        }
    });
    Ok(clock.seconds())
}
