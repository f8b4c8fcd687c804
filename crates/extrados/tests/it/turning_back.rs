//! A stepped collapse that is left and come back to goes on to the same bits.

use extrados::bridge::Method;
use extrados::{Choice, Memory, Project, Stepping, Unwatched, collapse};

fn project() -> Project {
    let text = include_str!("../../../../examples/bridgemill/case-1.toml");
    Project::read("bridge.toml", &Memory::default().with("bridge.toml", text)).expect("a bridge")
}

#[test]
fn a_run_that_is_taken_back_goes_on_to_the_same_bits() {
    let choice = Choice { method: Some(Method::Dem), ..Choice::default() };
    let mut run = Stepping::with_fill(&project(), &choice, &mut Unwatched).expect("a run").expect("nobody stopped it");
    run.advance(3000);
    let (early, frame) = (run.state(), run.frame());
    run.advance(2000);
    let later = run.frame();
    assert_ne!(frame, later);
    assert_eq!(run.progress().0, 5000);
    run.take_up(&early).expect("a state of this run");
    assert_eq!(run.frame(), frame);
    run.advance(2000);
    assert_eq!(run.frame(), later);
    let mut other = Stepping::new(&project(), &choice).expect("a run");
    other.take_up(&early).expect("the same project");
    other.advance(2000);
    assert_eq!(other.frame(), later);
    assert!(run.take_up(&early[..early.len() - 1]).is_err());
    assert_eq!(run.picture().shapes.len(), run.frame().poses.len());
}

#[test]
fn loads_and_steps_are_those_of_the_whole_analysis() {
    let choice = Choice { method: Some(Method::Dem), ..Choice::default() };
    let options = extrados::CollapseOptions { choice, resume: None };
    let whole = collapse(&project(), &options, &mut Unwatched).expect("a collapse");
    let mut run = Stepping::with_fill(&project(), &choice, &mut Unwatched).expect("a run").expect("nobody stopped it");
    let ended = loop {
        if let Some(status) = run.advance(10_000) {
            break Stepping::ended(status);
        }
    };
    assert_eq!(ended, whole.status);
    let path: Vec<(f64, u64)> = run.path().map(|(load, point)| (load, point.iterations)).collect();
    let theirs: Vec<(f64, u64)> = whole.picture.path.iter().map(|step| (step.load, step.iterations)).collect();
    assert_eq!(path, theirs);
}
