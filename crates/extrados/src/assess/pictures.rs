//! Which drawings of a stage stand in the report, and what is said under them.

use crate::cases::Cases;
use assess::chain::Ultimate;
use figures::UPDATE_FIGURES;
use findings::words::counted;
use outcome::collapse::Collapse;
use outcome::ground::GroundPlan;
use outcome::passage::Passage;
use outcome::picture::{HingeAt, Picture};
use outcome::update::Update;
use outcome::vehicles::VehicleSweep;
use report::Figure;

/// Most drawings of an update: histories, residuals, then sensitivity curves and surfaces in their order.
const MOST_OF_UPDATE: usize = 12;

fn figure(stage: &str, name: &str, caption: impl Into<String>, svg: Option<String>) -> Option<Figure> {
    Some(Figure { stage: stage.to_owned(), name: name.to_owned(), caption: caption.into(), svg: svg? })
}

/// The bridge as its file describes it: elevation, plan, cross-section.
pub(super) fn built(picture: &Picture, ground: &GroundPlan) -> Vec<Figure> {
    let svg = figures::bridge_as_drawn(picture);
    let all = [
        figure("built", "bridge", "The bridge as its file describes it.", Some(svg)),
        figure("built", "plan", "Plan at the springings.", figures::plan(ground)),
        figure("built", "cross-section", "Cross-section at the crown.", figures::cross_section(ground)),
    ];
    all.into_iter().flatten().collect()
}

/// With more hinges or sliding joints than this their places are in the drawing alone.
const MOST_PLACES: usize = 6;

/// The mechanism in words: how many hinges act and where, and what slides.
fn acts(picture: &Picture) -> String {
    if picture.mechanism.is_none() {
        return "No mechanism was found.".to_owned();
    }
    let listed = |places: Vec<String>| match places.len() {
        1..=MOST_PLACES => format!(" at {}", places.join(", ")),
        _ => String::new(),
    };
    let hinge = |one: &outcome::picture::Hinge| match one.edge {
        HingeAt::Other => format!("{:.2} m", one.point[0]),
        edge => format!("{:.2} m ({edge})", one.point[0]),
    };
    let hinges = listed(picture.hinges.iter().map(hinge).collect());
    let slides = listed(picture.sliding.iter().map(|at| format!("{:.2} m", at[0])).collect());
    let told = match (picture.hinges.len(), picture.sliding.len()) {
        (0, 0) => return "The mechanism has no hinge and no sliding joint of its own.".to_owned(),
        (0, _) => format!("Mechanism of {}{slides}", counted(picture.sliding.len(), "sliding joint")),
        (n, 0) => format!("Mechanism of {}{hinges}; no joint slides", counted(n, "hinge")),
        (n, m) => format!("Mechanism of {}{hinges}, and {}{slides}", counted(n, "hinge"), counted(m, "sliding joint")),
    };
    format!("{told}. Places are measured along the bridge from the left springing of the first span.")
}

/// The load that governs in its place, with what its mechanism does: for the first page of the report.
fn governing(stage: &str, picture: &Picture, ground: &GroundPlan) -> Option<Figure> {
    figure(stage, Figure::GOVERNING, acts(picture), figures::sketch(picture, ground))
}

/// Mechanism, line of thrust, envelope.
pub(super) fn ultimate(found: &Ultimate, ground: &GroundPlan) -> Vec<Figure> {
    let Some(Collapse { picture, .. }) = found.facts.collapse.as_deref() else { return Vec::new() };
    let points = found.sweep.points.iter().map(|p| (p.position, p.load_factor.unwrap_or(f64::NAN))).collect();
    let curve = figures::Sweep { label: "loads of the file, worst run of axles".to_owned(), points };
    let envelope = figures::envelope(&ground.bridge, figures::Ordinate::Factor, &[curve], None);
    let all = [
        governing("ultimate", picture, ground),
        figure(
            "ultimate",
            "mechanism",
            "Mechanism at collapse, loads where they are worst.",
            figures::mechanism(picture),
        ),
        figure("ultimate", "thrust-line", "Line of thrust at collapse.", figures::thrust_line(picture)),
        figure("ultimate", "envelope", "Factor on the loads of the file over their position.", envelope),
    ];
    all.into_iter().flatten().collect()
}

/// Adequacy of every vehicle, that of the governing one over its position, and its mechanism.
pub(super) fn vehicles(found: &VehicleSweep, ground: &GroundPlan) -> Vec<Figure> {
    let caption = |name: &str| match name {
        "adequacy" => "Adequacy factor of every vehicle, worst first; 1 is just enough.",
        _ => "Adequacy factor of the governing vehicle over the position of its first axle.",
    };
    let mut list: Vec<Figure> = figures::vehicles(found)
        .into_iter()
        .filter_map(|(name, svg)| figure("vehicles", name, caption(name), Some(svg)))
        .collect();
    list.extend(found.collapse.as_ref().and_then(|collapse| governing("vehicles", &collapse.picture, ground)));
    let mechanism = found.collapse.as_ref().and_then(|collapse| figures::mechanism(&collapse.picture));
    let caption = "Mechanism under the governing vehicle, loads and weights with their factors.";
    list.extend(figure("vehicles", "mechanism", caption, mechanism));
    if ground.vehicle.is_some() {
        let caption = "Where the governing vehicle stands across the barrel, and the width that carries it.";
        list.extend(figure("vehicles", "across", caption, figures::cross_section(ground)));
        let divided = figures::plan(ground).filter(|_| !ground.cracks.is_empty());
        list.extend(figure("vehicles", "strips", "The strips that cracks leave, and the governing vehicle.", divided));
    }
    list
}

/// Factors of named cases, and the mechanism of the least.
pub(super) fn cases(bridge: &str, found: &Cases) -> Vec<Figure> {
    let bars = figures::case_factors(bridge, &found.factors());
    let mut list: Vec<Figure> =
        figure("cases", "factors", "Factor on the loads of each named case.", bars).into_iter().collect();
    if let Some(least) = found.least() {
        let caption = format!("Mechanism of the case with the least factor, {}.", least.name);
        list.extend(figure("cases", "mechanism", caption, figures::mechanism(&least.collapse.picture)));
    }
    list
}

/// The mechanism of a support that moves.
pub(super) fn movement(picture: &Picture) -> Vec<Figure> {
    let svg = figures::mechanism(picture).or_else(|| figures::thrust_line(picture));
    figure("movement", "mechanism", "The bridge when its support has moved as far as it stands.", svg)
        .into_iter()
        .collect()
}

/// Records of the sensors under every load, and the ring of the last one where its first sensor peaks.
pub(super) fn service(passages: &[Passage], names: &[String]) -> Vec<Figure> {
    let mut list = Vec::new();
    for (k, (passage, name)) in passages.iter().zip(names).enumerate() {
        let caption = format!("Records of the sensors under {name}, at rest, self-weight taken off.");
        list.extend(figure("service", &format!("records-{k}"), caption, figures::passage_records(passage)));
    }
    let last = passages.last().zip(names.last());
    if let Some((passage, name)) = last
        && let Some(peak) = passage.channels.first().and_then(|channel| channel.peak())
        && let Some(at) = passage.positions.get(peak)
    {
        let near = |k: &usize| (passage.moments[*k].position - at).abs();
        let moment = (1..passage.moments.len()).min_by(|a, b| near(a).total_cmp(&near(b)));
        let channel = passage.channels.first().map_or("", |channel| channel.name.as_str());
        let caption = format!(
            "Joints and line of thrust under {name} and self-weight, first axle at {at:.2} m, where {channel} peaks; no dynamic augment."
        );
        list.extend(moment.and_then(|k| figure("service", "ring", caption, figures::passage_ring(passage, k))));
    }
    list
}

/// Histories, residuals, sensitivity curves and surfaces, what the records leave open.
pub(super) fn update(found: &Update) -> Vec<Figure> {
    let drawings = figures::update_drawings(found).into_iter().take(MOST_OF_UPDATE);
    let caption = |name: &str| {
        let kind = UPDATE_FIGURES.iter().find(|(kind, _)| name.starts_with(kind));
        kind.map_or("Model updating.", |(_, caption)| *caption)
    };
    drawings.filter_map(|(name, svg)| figure("update", &name, caption(&name), Some(svg))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::picture::{Hinge, Motion};

    #[test]
    fn a_mechanism_is_told_with_every_hinge_and_its_place() {
        let hinge = |x: f64, edge| Hinge { point: [x, 0.0], edge, between: [0, 1], rotation: 1.0 };
        let mut picture = Picture { mechanism: Some(vec![Motion::default()]), ..Picture::default() };
        picture.hinges = vec![hinge(0.0, HingeAt::Intrados), hinge(1.5, HingeAt::Extrados)];
        assert!(
            acts(&picture)
                .starts_with("Mechanism of 2 hinges at 0.00 m (intrados), 1.50 m (extrados); no joint slides.")
        );
        picture.sliding = vec![[6.0, 0.0]];
        assert!(acts(&picture).contains("(extrados), and 1 sliding joint at 6.00 m."), "{}", acts(&picture));
        picture.hinges = vec![hinge(1.0, HingeAt::Other); 20];
        assert!(acts(&picture).starts_with("Mechanism of 20 hinges, and"), "{}", acts(&picture));
        picture.hinges.clear();
        assert!(acts(&picture).starts_with("Mechanism of 1 sliding joint at 6.00 m."));
        assert_eq!(acts(&Picture::default()), "No mechanism was found.");
    }
}
