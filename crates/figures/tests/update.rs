//! Figures of model updating, from updates whose model is a formula.

mod sample;

use outcome::update::Update;
use roxmltree::Document;
use sample::updates::{hard, twin};

fn drawing(update: &Update, name: &str) -> String {
    let all = figures::update_drawings(update);
    let names: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
    let found = all.iter().find(|(other, _)| other == name);
    found.unwrap_or_else(|| panic!("{name} is not in {names:?}")).1.clone()
}

fn classed(svg: &str, class: &str) -> usize {
    let document = Document::parse(svg).unwrap();
    document.descendants().filter(|node| node.attribute("class") == Some(class)).count()
}

fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).unwrap();
    document.descendants().filter(|n| n.has_tag_name("text")).map(|n| n.text().unwrap_or_default().to_owned()).collect()
}

#[test]
fn every_channel_has_its_three_histories_and_synthetic_records_say_so() {
    let update = twin();
    let svg = drawing(&update, "histories");
    assert_eq!(["measured", "start", "updated"].map(|class| classed(&svg, class)), [6, 6, 6]);
    for (name, svg) in figures::update_drawings(&update) {
        assert!(texts(&svg).concat().contains("synthetic"), "{name} hides that records are synthetic");
    }
    let measured = drawing(&hard(), "histories");
    assert!(!texts(&measured).concat().contains("synthetic"));
    assert_eq!(classed(&measured, "measured"), 7, "the record of one channel has a gap");
}

#[test]
fn a_sweep_has_a_row_for_each_parameter_and_a_curve_for_each_channel_that_counts() {
    let update = twin();
    let svg = drawing(&update, "sensitivity-1");
    let rows = update.paper[0].outcome.passes[0].sweeps.len() + update.paper[0].outcome.passes[0].last.len();
    assert_eq!(classed(&svg, "norm"), rows);
    assert_eq!(classed(&svg, "error"), 5 * rows, "one of six channels is left out");
    let first = update.paper[0].outcome.passes[0].ranking[0];
    let name = format!("1. {}", update.problem.parameters()[first].name);
    assert!(texts(&svg).contains(&name), "{name} leads");
}

#[test]
fn a_surface_shows_every_point_the_path_and_the_least() {
    let update = twin();
    for (number, pass) in update.paper[0].outcome.passes.iter().enumerate() {
        for (place, stage) in pass.stages.iter().enumerate() {
            let svg = drawing(&update, &format!("surface-{}-{}", number + 1, place + 1));
            assert_eq!(classed(&svg, "asked"), stage.surface.norms.len());
            assert_eq!(classed(&svg, "failed"), 0);
            assert!(texts(&svg).iter().any(|text| text.starts_with("least norm ")));
        }
    }
    let update = hard();
    let surfaces = update.paper[0].outcome.passes.iter().flat_map(|pass| &pass.stages);
    let holes: usize = surfaces.map(|stage| stage.surface.norms.iter().filter(|norm| norm.is_none()).count()).sum();
    assert!(holes > 0, "the sample's model fails somewhere");
    let drawings = figures::update_drawings(&update);
    let crosses: usize = drawings.iter().map(|(_, svg)| classed(svg, "failed")).sum();
    assert_eq!(crosses, 2 * holes, "two strokes each");
}

#[test]
fn residuals_stand_before_and_after_for_every_channel() {
    let svg = drawing(&twin(), "residuals");
    assert_eq!(["before", "after"].map(|class| classed(&svg, class)), [6, 6]);
}

#[test]
fn the_posterior_has_a_panel_for_each_parameter_and_a_correlation_for_each_pair() {
    let update = twin();
    let svg = drawing(&update, "posterior");
    assert_eq!(["interval", "prior", "answer"].map(|class| classed(&svg, class)), [5, 5, 5]);
    assert!(texts(&svg).concat().contains("not brought to its end"), "the sample's sampling is short");
    let svg = drawing(&update, "correlation");
    assert_eq!(["correlation", "cloud"].map(|class| classed(&svg, class)), [10, 10]);
    assert!(figures::update_drawings(&hard()).iter().all(|(name, _)| name != "posterior" && name != "correlation"));
}

/// An update that broke off at once still has its files.
#[test]
fn without_material_nothing_is_drawn_and_nothing_fails() {
    let mut update = twin();
    update.times.clear();
    update.positions.clear();
    update.basis = None;
    update.answer = None;
    update.searches.clear();
    update.paper.clear();
    update.posterior = None;
    assert!(figures::update_drawings(&update).is_empty());
}
