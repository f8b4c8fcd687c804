//! Figures of model updating, from `Update` alone: histories over one another, sensitivity curves, surfaces of two
//! parameters, what the data leave open, and residuals by channel.

mod bands;
mod correlation;
mod histories;
mod marginals;
mod residuals;
mod sensitivity;
mod style;
mod surface;
mod words;

use outcome::update::{PaperSearch, Update};

/// Kinds of figures of an update: how their names begin, and what stands under them.
pub const UPDATE_FIGURES: [(&str, &str); 6] = [
    ("histories", "Histories as measured, before and after the update."),
    ("residuals", "What is left between records and model, channel by channel."),
    ("sensitivity", "Misfit over each parameter alone."),
    ("surface", "Misfit over two parameters, with the path of the search."),
    ("posterior", "What the records leave open of each parameter."),
    ("correlation", "Correlation of the parameters."),
];

/// Every figure of an update that there is material for, as SVG: name without extension, and drawing.
pub fn update_drawings(update: &Update) -> Vec<(String, String)> {
    let mut drawings: Vec<(String, String)> = Vec::new();
    let mut put = |name: String, svg: Option<String>| drawings.extend(svg.map(|svg| (name, svg)));
    put("histories".into(), histories::histories(update));
    put("residuals".into(), residuals::residuals(update));
    if let Some(paper) = shown(update) {
        for (number, pass) in paper.outcome.passes.iter().enumerate() {
            put(format!("sensitivity-{}", number + 1), sensitivity::sensitivity(update, paper, number));
            for stage in 0..pass.stages.len() {
                put(format!("surface-{}-{}", number + 1, stage + 1), surface::surface(update, paper, number, stage));
            }
        }
    }
    put("posterior".into(), marginals::marginals(update));
    put("correlation".into(), correlation::correlation(update));
    drawings
}

/// Of several searches after the paper, by reading and start, the one that ended best; the first of equals.
fn shown(update: &Update) -> Option<&PaperSearch> {
    let norm = |paper: &PaperSearch| paper.outcome.found.as_ref().map_or(f64::INFINITY, |found| found.norm);
    update.paper.iter().reduce(|best, next| if norm(next) < norm(best) { next } else { best })
}
