//! The door as programs use it.

mod written;

use extrados::results::collapse::Status;
use extrados::shelf::Remembered;
use extrados::{
    Blocks, Choice, CollapseOptions, Disk, Means, Memory, Progress, Project, Stepping, Unwatched, VaryOptions, Watch,
    Wish, collapse, collapse_of_blocks, settings, vary,
};

fn memory() -> Memory {
    Memory::default()
        .with("tiny.toml", include_str!("../../../../examples/tiny/bridge.toml"))
        .with("case-1.toml", include_str!("../../../../examples/bridgemill/case-1.toml"))
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

/// Stops a run at its third look, and keeps its state.
#[derive(Default)]
struct Stopper {
    looks: usize,
    state: Option<Vec<u64>>,
}

impl Watch for Stopper {
    fn look(&mut self, _: &Progress) -> Wish {
        self.looks += 1;
        if self.looks == 3 { Wish::Stop } else { Wish::GoOn }
    }

    fn keep(&mut self, state: &dyn Fn() -> Vec<u64>) {
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
    assert!(drawn.drawing().is_some_and(|(place, found)| place.ends_with("arch.dxf") && found.is_empty()));
    let choice = Choice { method: Some(extrados::bridge::Method::Limit), ..Choice::default() };
    let found = collapse_of_blocks(&drawn, &CollapseOptions { choice, resume: None }, &mut Unwatched).expect("a load");
    assert_eq!(found.status, Status::Collapsed);
    let missing = Memory::default().with("a/b.toml", drawn.text());
    let missing = Blocks::read("a/b.toml", &missing).expect("a file without its drawing is read");
    assert!(missing.findings().iter().any(|one| one.code == "D101" && one.message.contains("a/arch.dxf")));
}
