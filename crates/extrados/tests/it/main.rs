//! The door as programs use it.

mod placing;
mod random;
mod turning_back;
mod written;

use ::assess::analysis::passage::sensors::Placed;
use extrados::bridge::passage::PassagePath;
use extrados::bridge::{Analysis, Method};
use extrados::results::collapse::Status;
use extrados::results::passage::{Moment, PassageStatus};
use extrados::results::sweep::Ended;
use extrados::results::update::UpdateStatus;
use extrados::shelf::Remembered;
use extrados::{
    AssessOptions, Blocks, Choice, CollapseOptions, Disk, Means, Memory, Passing, Progress, Project, RespondOptions,
    Stepping, SweepOptions, Swept, Unwatched, UpdateOptions, VaryOptions, Watch, Wish, assess, collapse,
    collapse_of_blocks, respond, settings, sweep, update, vary,
};
use mechanics::ids::Id;

fn memory() -> Memory {
    Memory::default()
        .with("tiny.toml", include_str!("../../../../examples/tiny/bridge.toml"))
        .with("case-1.toml", include_str!("../../../../examples/bridgemill/case-1.toml"))
        .with("vehicles.toml", include_str!("../../../../examples/bridgemill/vehicles.toml"))
        .with("ring.toml", include_str!("../../../../examples/semicircle/ring.toml"))
        .with("train.toml", train(0.05, 24.0))
        .with("few.toml", train(0.1, 16.0))
}

/// The train on the first spans alone, in steps of so much time [s] to a place [m], on a coarse mesh.
fn train(step: f64, to: f64) -> String {
    let text = include_str!("../../../../examples/railway-arch/passage.toml");
    let way = format!("time_step = \"{step} s\"\nfrom = \"2 m\"\nto = \"{to} m\"");
    text.replace("time_step = \"0.005 s\"", &way).replace("size = \"0.15 m\"", "size = \"0.4 m\"")
}

fn project(name: &str) -> Project {
    Project::read(name, &memory()).expect("a project")
}

fn load(project: &Project) -> f64 {
    let found = collapse(project, &CollapseOptions::default(), &mut Unwatched).expect("an analysis");
    found.headline().expect("a load").load
}

#[test]
fn a_varied_project_is_the_file_with_other_values() {
    let own = project("tiny.toml");
    let heavier = own.with(&["masonry.density=x1.1"]).expect("a heavier bridge");
    let told = own.with(&["masonry.density=x1.1"]).expect("the same");
    assert_eq!(heavier.bridge(), told.bridge());
    let density = |project: &Project| project.bridge().expect("a bridge").masonry.density;
    assert!((density(&heavier) / density(&own) - 1.1).abs() < 1e-12);
    assert!(load(&heavier) > load(&own));
    // Every mistake at once, and none of them changes the project.
    let wrong = own.with(&["masonry.colour=3", "joint.friction_angle=20deg,30deg"]).expect_err("two mistakes");
    assert_eq!(wrong.len(), 2, "{wrong:?}");
    assert!(own.with(&["joint.friction_angle=95deg"]).is_err());
}

#[test]
fn a_file_that_is_missing_or_wrong_is_refused_in_words() {
    assert_eq!(Project::read("none.toml", &memory()).expect_err("no file").code, "F101");
    let files = Memory::default().with("a.toml", "[bridge]\nname = 3\n");
    let project = Project::read("a.toml", &files).expect("a file with mistakes is read");
    assert!(!project.findings().is_empty());
    let refusal = collapse(&project, &CollapseOptions::default(), &mut Unwatched).expect_err("no bridge");
    assert!(refusal.message.contains("line 2"), "{refusal}");
}

/// Moved on by odd numbers of steps, a run ends where the undisturbed one does.
#[test]
fn a_collapse_can_be_stepped() {
    let project = project("case-1.toml");
    let choice = Choice { method: Some(extrados::bridge::Method::Dem), ..Choice::default() };
    let whole = collapse(&project, &CollapseOptions { choice, resume: None }, &mut Unwatched).expect("an analysis");
    let mut run = Stepping::new(&project, &choice).expect("a run");
    let mut looks = 0;
    while run.advance(7_001).is_none() {
        looks += 1;
        assert_eq!(run.frame().poses.len(), run.blocks().model.blocks.len());
    }
    assert!(looks > 10, "{looks}");
    let blocks = run.blocks().clone();
    let found = run.finish();
    let last = found.last_stable_factor.map(|factor| blocks.load(factor));
    assert_eq!(last.map(f64::to_bits), whole.last_stable_load.map(f64::to_bits));
    assert_eq!(whole.status, Status::Collapsed);
}

/// Moved on by one, by seven and in one go, with a look at every position or none, a passage is the same to the last bit, by either
/// path; its pictures have the same names, in the same order.
#[test]
fn a_passage_can_be_stepped() {
    let mut pictures = Vec::new();
    for (file, path) in
        [("train.toml", PassagePath::Condensed), ("few.toml", PassagePath::Condensed), ("few.toml", PassagePath::Plain)]
    {
        let project = project(file);
        let options = RespondOptions { path: Some(path), ..RespondOptions::default() };
        let whole = respond(&project, &options, &mut Unwatched).expect("a passage");
        assert_eq!(whole.path, path);
        assert!(whole.positions.len() > 10, "{}", whole.positions.len());
        // The plain path takes long for each place.
        let steps = if path == PassagePath::Plain { &[7][..] } else { &[1, 7] };
        for &step in steps {
            let mut run = Passing::new(&project, &options, &mut Unwatched).expect("a passage");
            assert!(run.place().is_none());
            let rest = run.moment().expect("self-weight");
            while run.advance(step, &mut Unwatched).expect("a position").is_none() {
                let moment = run.moment().expect("a look");
                let (time, place) = run.place().expect("a position");
                assert_eq!((moment.time, moment.position), (time, place));
                // What the sensors read can be read off the displacements, but for rounding.
                let by = |moment: &Moment, sensor: &Placed| {
                    sensor.reading.value(|node| moment.displacements[node.index()], |_| [0.0; 3])
                };
                for ((sensor, value), channel) in run.setup().sensors.iter().zip(run.values()).zip(&whole.channels) {
                    let size = channel.peak_value().abs();
                    let read = by(&moment, sensor) - by(&rest, sensor);
                    assert!((read - value).abs() <= 1e-6 * size, "{} at {place}: {read} {value}", sensor.name);
                }
            }
            let stepped = run.finish(&mut Unwatched).expect("a passage");
            assert_eq!(stepped.status, whole.status);
            for (one, other) in stepped.channels.iter().zip(&whole.channels) {
                let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
                assert_eq!(bits(&one.values), bits(&other.values), "{} by {step}", one.name);
            }
            assert_eq!(stepped, whole, "by {step}");
        }
        pictures.push(whole.moments.iter().map(|m| (m.name.clone(), m.position)).collect::<Vec<_>>());
        // Left before its end, it was cancelled, and what it recorded is part of the whole.
        let mut run = Passing::new(&project, &options, &mut Unwatched).expect("a passage");
        assert_eq!(run.advance(5, &mut Unwatched).expect("positions"), None);
        let left = run.finish(&mut Unwatched).expect("a passage");
        assert_eq!((left.status, left.positions.len()), (PassageStatus::Cancelled, 5));
        assert_eq!(left.channels[0].values[..], whole.channels[0].values[..5]);
    }
    assert_eq!(pictures[1], pictures[2]);
}

/// Stops at the look with this number, and goes on counting.
struct Leaving {
    at: usize,
    looks: usize,
}

impl Watch for Leaving {
    fn look(&mut self, _: &Progress) -> Wish {
        self.looks += 1;
        if self.looks >= self.at { Wish::Stop } else { Wish::GoOn }
    }
}

/// Every analysis ends as cancelled when it is stopped, at once or on the way, and asks next to nothing after the stop: what it asks
/// is asked in every iteration.
#[test]
fn every_analysis_is_left_when_it_is_stopped() {
    type Left<'a> = Box<dyn Fn(&mut dyn Watch) -> bool + 'a>;
    type Run<'a> = (&'a str, usize, Left<'a>);
    let file = project;
    let collapsed = |name: &'static str, choice: Choice| -> Left<'_> {
        Box::new(move |watch| {
            let options = CollapseOptions { choice, resume: None };
            let found = collapse(&file(name), &options, watch).expect("an analysis");
            found.status == Status::Cancelled
        })
    };
    let by = |method| Choice { method: Some(method), ..Choice::default() };
    let thickness = Choice { analysis: Some(Analysis::Thickness), ..Choice::default() };
    let passing = |path| -> Left<'_> {
        Box::new(move |watch| {
            let options = RespondOptions { path: Some(path), ..RespondOptions::default() };
            respond(&file("few.toml"), &options, watch).expect("a passage").status == PassageStatus::Cancelled
        })
    };
    let railway = Project::read("../../examples/railway-arch/update.toml", &extrados::Disk).expect("a file");
    let assessed = Project::read("../../examples/bridgemill/assess.toml", &extrados::Disk).expect("a file");
    let runs: Vec<Run<'_>> = vec![
        ("limit analysis", 1, collapsed("case-1.toml", by(Method::Limit))),
        ("discrete elements", 5, collapsed("case-1.toml", by(Method::Dem))),
        ("thickness by limit analysis", 1, collapsed("ring.toml", Choice { method: Some(Method::Limit), ..thickness })),
        (
            "thickness by discrete elements",
            5,
            collapsed("case-1.toml", Choice { method: Some(Method::Dem), ..thickness }),
        ),
        ("passage, condensed", 60, passing(PassagePath::Condensed)),
        ("passage, plain", 20, passing(PassagePath::Plain)),
        (
            "loads at every position",
            2,
            Box::new(|watch| match sweep(&file("case-1.toml"), &SweepOptions::default(), watch).expect("a sweep") {
                Swept::Loads(found) => !found.whole,
                Swept::Vehicles(_) => false,
            }),
        ),
        (
            "vehicles at every position",
            2,
            Box::new(|watch| match sweep(&file("vehicles.toml"), &SweepOptions::default(), watch).expect("a sweep") {
                Swept::Vehicles(found) => found.status() == Ended::Cancelled,
                Swept::Loads(_) => false,
            }),
        ),
        (
            "an evaluation of an update",
            3,
            Box::new(|watch| {
                let found = update(&railway, &UpdateOptions::default(), &Means::default(), watch).expect("an update");
                found.status == UpdateStatus::Cancelled
            }),
        ),
        (
            "an assessment",
            3,
            Box::new(|watch| {
                assess(&assessed, &AssessOptions::default(), &Means::default(), watch).expect("stages").is_none()
            }),
        ),
    ];
    for (name, later, run) in &runs {
        for at in [1, *later] {
            let mut leaving = Leaving { at, looks: 0 };
            assert!(run(&mut leaving), "{name}, stopped at look {at}, does not say so");
            // Stages that follow are told of the stop, one look each; nothing iterates any more.
            assert!(leaving.looks <= at + 8, "{name} asks {} times after look {at}", leaving.looks - at);
        }
    }
}

/// Stops a run once it has offered its state, and keeps that.
#[derive(Default)]
struct Stopper {
    state: Option<Vec<u8>>,
}

impl Watch for Stopper {
    fn look(&mut self, _: &Progress) -> Wish {
        if self.state.is_some() { Wish::Stop } else { Wish::GoOn }
    }

    fn keep(&mut self, state: &dyn Fn() -> Vec<u8>) {
        self.state = Some(state());
    }
}

#[test]
fn who_looks_on_can_stop_a_run_and_take_it_up() {
    let project = project("case-1.toml");
    let choice = Choice { method: Some(extrados::bridge::Method::Dem), ..Choice::default() };
    let run = |resume, watch: &mut dyn Watch| {
        collapse(&project, &CollapseOptions { choice, resume }, watch).expect("an analysis")
    };
    let mut stopper = Stopper::default();
    assert_eq!(run(None, &mut stopper).status, Status::Cancelled);
    assert!(stopper.state.is_some(), "a state was offered");
    let (resumed, whole) = (run(stopper.state, &mut Unwatched), run(None, &mut Unwatched));
    assert_eq!(resumed.status, Status::Collapsed);
    assert_eq!(resumed.last_stable_load.map(f64::to_bits), whole.last_stable_load.map(f64::to_bits));
}

/// Stops at a look of its number, counted from the first state that was offered.
struct Later {
    looks: u32,
    state: Option<Vec<u8>>,
}

impl Watch for Later {
    fn look(&mut self, _: &Progress) -> Wish {
        if self.state.is_none() {
            return Wish::GoOn;
        }
        self.looks = self.looks.saturating_sub(1);
        if self.looks == 0 { Wish::Stop } else { Wish::GoOn }
    }

    fn keep(&mut self, state: &dyn Fn() -> Vec<u8>) {
        self.state = Some(state());
    }
}

#[test]
fn a_path_is_stopped_and_taken_up_at_any_of_its_states() {
    let project = project("case-1.toml");
    let choice = Choice { method: Some(extrados::bridge::Method::Path), ..Choice::default() };
    let run = |resume, watch: &mut dyn Watch| {
        collapse(&project, &CollapseOptions { choice, resume }, watch).expect("an analysis")
    };
    let whole = format!("{:?}", run(None, &mut Unwatched));
    for looks in [1, 5, 20, 45] {
        let mut later = Later { looks, state: None };
        assert_eq!(run(None, &mut later).status, Status::Cancelled, "{looks} looks");
        let resumed = run(later.state, &mut Unwatched);
        assert!(format!("{resumed:?}") == whole, "stopped after {looks} looks");
    }
}

#[test]
fn finished_runs_of_a_study_are_taken_from_the_shelf() {
    let project = project("tiny.toml");
    let ranges = settings(&project, &["joint.friction_angle=30deg..40deg:3"]).expect("a range");
    let shelf = Remembered::default();
    let means = Means { shelf: &shelf, ..Means::default() };
    let study = || {
        let found = vary(&project, &ranges, &VaryOptions::default(), &means, &mut Unwatched).expect("a study");
        found.study.expect("nobody stopped it")
    };
    let (first, second) = (study(), study());
    assert_eq!(first.rows.iter().filter(|row| row.cached).count(), 0);
    assert_eq!(second.rows.iter().filter(|row| row.cached).count(), second.rows.len());
    let numbers = |study: &extrados::results::study::Study| -> Vec<Option<u64>> {
        study.rows.iter().map(|row| study.number(row).map(f64::to_bits)).collect()
    };
    assert_eq!(numbers(&first), numbers(&second));
}

/// Every name that the crate gives away stands in its page.
#[test]
fn the_page_of_the_library_names_what_there_is() {
    let (page, source) = (include_str!("../../../../docs/api.md"), include_str!("../../src/lib.rs"));
    let given = source.lines().filter_map(|line| line.strip_prefix("pub use "));
    let names = given.flat_map(|line| {
        let last = line.trim_end_matches(';').rsplit("::").next().unwrap_or_default();
        let last = last.rsplit(" as ").next().unwrap_or_default();
        last.trim_matches(['{', '}']).split(", ").map(str::to_owned).collect::<Vec<_>>()
    });
    let names: Vec<String> = names.collect();
    assert!(names.len() > 30, "{names:?}");
    for name in names {
        assert!(page.contains(&format!("`{name}`")), "docs/api.md does not name {name}");
    }
}

/// A sweep of a file that plans another method says that limit analysis answered.
#[test]
fn a_sweep_names_the_method_that_it_uses() {
    use extrados::bridge::Method;
    use extrados::results::note::Moving;
    let project = project("case-1.toml");
    for (method, told) in [(Method::Dem, true), (Method::Fe, true), (Method::Limit, false), (Method::Path, false)] {
        assert_eq!(extrados::sweeps(method), !told);
    }
    let options = SweepOptions { step: Some(5.0), ..SweepOptions::default() };
    let Swept::Loads(found) = sweep(&project, &options, &mut Unwatched).expect("a sweep") else { panic!("no loads") };
    assert!(found.assumptions.contains(&Moving::InsteadOf { method: Method::Dem }.into()), "{:?}", found.assumptions);
}

/// Blocks that are listed: the same load as by the bridge that they are of.
#[test]
fn block_models_come_through_the_door() {
    let text = "[model]\nname = \"Column\"\n[masonry]\ndensity = \"2000 kg/m3\"\n";
    let files = Memory::default().with("blocks.toml", text);
    let blocks = Blocks::read("blocks.toml", &files).expect("a file with mistakes is read");
    assert!(blocks.scene().is_none() && !blocks.findings().is_empty() && blocks.as_built().is_none());
    let refusal = collapse_of_blocks(&blocks, &CollapseOptions::default(), &mut Unwatched).expect_err("no model");
    assert_eq!(refusal.code, "F108");
    let drawn = Blocks::read(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/drawing/bridge.toml"), &Disk);
    let drawn = drawn.expect("the example is read");
    let (place, found) = drawn.drawing().expect("the file names a drawing");
    assert!(place.ends_with("arch.dxf"));
    assert_eq!(found.iter().map(|one| one.code).collect::<Vec<_>>(), ["D206"], "one outline is turned round");
    let choice = Choice { method: Some(extrados::bridge::Method::Limit), ..Choice::default() };
    let found = collapse_of_blocks(&drawn, &CollapseOptions { choice, resume: None }, &mut Unwatched).expect("a load");
    assert_eq!(found.status, Status::Collapsed);
    let missing = Memory::default().with("a/b.toml", drawn.text());
    let missing = Blocks::read("a/b.toml", &missing).expect("a file without its drawing is read");
    assert!(missing.findings().iter().any(|one| one.code == "D101" && one.message.contains("a/arch.dxf")));
}
