//! What each engine and each question knows. From this one table come refusals, the table of `docs/theory/methods.md` and what a page offers.

use bridge::{Analysis, Bridge, Method, Strip};
use std::fmt;
use structure::discretise::continuum;

/// What a bridge or a question may ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feature {
    /// Analysis "thickness".
    Thickness,
    /// Analysis "support-movement".
    SupportMovement,
    /// Loads that are moved over the bridge.
    LoadSweep,
    /// Vehicles under a rule.
    Vehicles,
    /// Blocks of a file or a drawing in place of a bridge.
    DrawnBlocks,
    /// A spandrel wall.
    Walls,
    /// Layers of fill as particles.
    Particles,
    /// Fill or backing as a continuum that yields.
    Continuum,
    /// Fill that presses on the backs of rings.
    FillPressure,
    /// Defects of rings.
    Defects,
    /// A support that moved before the loads came.
    MovedBefore,
    /// Loads along the bridge.
    Along,
    /// Rings on one another.
    Rings,
    /// Spans on piers.
    Spans,
    /// Abutments that may slide and tilt.
    MovableAbutments,
    /// Blocks that bring a load onto the surface.
    LoadingBlocks,
    /// Bodies beside the stones of one ring, such as backing that is blocks.
    OtherBodies,
}

/// How something is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Knows {
    /// As itself.
    Yes,
    /// As weight, which the result says.
    AsWeight,
    /// By limit analysis in its place, which the result says.
    ByLimit,
    /// Not at all: refused.
    No,
}

/// Every feature in the order of the table, which is that of their enumeration: what it is called, and what to leave out of a file that has it.
const WORDS: [(Feature, &str, Option<&str>); 17] = [
    (Feature::Thickness, "the least thickness", None),
    (Feature::SupportMovement, "support movements", None),
    (Feature::LoadSweep, "loads that move", None),
    (Feature::Vehicles, "vehicles under a rule", None),
    (Feature::DrawnBlocks, "blocks of a drawing", None),
    (Feature::Walls, "spandrel walls", Some("strip = \"wall\"")),
    (Feature::Particles, "fill as particles", Some("as = \"particles\"")),
    (Feature::Continuum, "fill or backing as a continuum", Some("as = \"continuum\"")),
    (Feature::FillPressure, "fill that presses on the rings", Some("[fill_pressure]")),
    (Feature::Defects, "defects", Some("[[defect]]")),
    (Feature::MovedBefore, "supports that moved before the loads", Some("`before` of [support_movement]")),
    (Feature::Along, "loads along the bridge", Some("`horizontal`")),
    (Feature::Rings, "rings on one another", None),
    (Feature::Spans, "several spans", None),
    (Feature::MovableAbutments, "abutments that may move", Some("the body of [[abutment]]")),
    (Feature::LoadingBlocks, "loading blocks", Some("through = \"block\" of [[load]]")),
    (Feature::OtherBodies, "bodies beside the stones of one ring", None),
];

/// What a method knows of something.
#[must_use]
pub const fn knows(method: Method, feature: Feature) -> Knows {
    use Feature as F;
    use Knows::{AsWeight, ByLimit, No, Yes};
    match (method, feature) {
        (Method::Limit | Method::Path | Method::Fe, F::Particles) => AsWeight,
        (Method::Limit, _) => Yes,
        (Method::Path, F::Thickness | F::SupportMovement | F::DrawnBlocks) => No,
        (Method::Path | Method::Dem | Method::Fe, F::Continuum) => AsWeight,
        (Method::Dem | Method::Fe, F::FillPressure) => AsWeight,
        (Method::Dem | Method::Fe, F::LoadSweep | F::Vehicles) => ByLimit,
        (Method::Path | Method::Dem, _) => Yes,
        // One ring between fixed abutments, under loads that grow.
        (Method::Fe, _) => No,
    }
}

/// Whether a question takes something into account, by whatever method.
#[must_use]
pub const fn answers(question: Analysis, feature: Feature) -> Knows {
    use Feature as F;
    match (question, feature) {
        (Analysis::Thickness, F::Defects | F::MovedBefore) => Knows::No,
        (Analysis::Thickness | Analysis::SupportMovement, F::Continuum) => Knows::No,
        (Analysis::Thickness | Analysis::SupportMovement, F::Particles | F::FillPressure) => Knows::AsWeight,
        _ => Knows::Yes,
    }
}

/// What a bridge and its plan ask for.
#[must_use]
pub fn asked(bridge: &Bridge) -> Vec<Feature> {
    let plan = &bridge.plan;
    let is_load = plan.analysis == Analysis::Load;
    let fill = plan.strip == Strip::Fill;
    let has = |feature: &Feature| match feature {
        Feature::Thickness => plan.analysis == Analysis::Thickness,
        Feature::SupportMovement => plan.analysis == Analysis::SupportMovement,
        Feature::Walls => !fill && bridge.spandrel_wall.is_some(),
        Feature::Particles => fill && bridge.particles.is_some(),
        Feature::Continuum => continuum::wanted(bridge).is_some(),
        Feature::FillPressure => bridge.fill_pressure.is_some_and(|fill| fill.applies),
        Feature::Defects => bridge.spans.iter().any(|span| !span.defects.is_empty()),
        Feature::MovedBefore => plan.support_movement.is_some_and(|movement| movement.before.is_some()),
        Feature::Along => is_load && bridge.loads.iter().any(|load| load.horizontal != 0.0),
        Feature::Rings => bridge.spans.iter().any(|span| span.rings.len() > 1),
        Feature::Spans => bridge.spans.len() > 1,
        Feature::MovableAbutments => bridge.abutments.iter().any(|abutment| abutment.body.is_some()),
        Feature::LoadingBlocks => is_load && bridge.loads.iter().any(|load| load.block.is_some()),
        // Asked elsewhere, or seen when the bridge is cut into blocks.
        Feature::LoadSweep | Feature::Vehicles | Feature::DrawnBlocks | Feature::OtherBodies => false,
    };
    WORDS.map(|(feature, ..)| feature).into_iter().filter(has).collect()
}

/// What a method or a question does not know of a bridge.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cannot {
    method: Method,
    question: Analysis,
    /// What the method does not know.
    of_method: Vec<Feature>,
    /// What the question does not take into account.
    of_question: Vec<Feature>,
    /// Everything that is asked.
    asked: Vec<Feature>,
}

impl Cannot {
    /// Of a method by itself.
    #[must_use]
    pub fn of(method: Method, feature: Feature) -> Cannot {
        let features = vec![feature];
        Cannot {
            method,
            question: Analysis::Load,
            of_method: features.clone(),
            of_question: Vec::new(),
            asked: features,
        }
    }
}

impl fmt::Display for Cannot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let listed = |features: &[Feature], word: &str| {
            let all: Vec<&str> = features.iter().map(|feature| WORDS[*feature as usize].1).collect();
            all.join(&format!(" {word} "))
        };
        let left_out = |features: &[Feature]| {
            let all: Option<Vec<&str>> = features.iter().map(|feature| WORDS[*feature as usize].2).collect();
            all.filter(|all| !all.is_empty()).map(|all| format!("leave {} out", all.join(" and ")))
        };
        let mut sentences = Vec::new();
        if !self.of_method.is_empty() {
            let who = of_method(self.method);
            let others: Vec<String> = Method::ALL
                .iter()
                .filter(|other| self.asked.iter().all(|feature| knows(**other, *feature) != Knows::No))
                .map(|other| format!("method = \"{}\"", other.word()))
                .collect();
            let instead = (!others.is_empty()).then(|| format!("write {}", others.join(" or ")));
            let remedy: Vec<String> = instead.into_iter().chain(left_out(&self.of_method)).collect();
            sentences.push(format!("{who} not know {}: {}", listed(&self.of_method, "or"), remedy.join(", or ")));
        }
        if !self.of_question.is_empty() {
            let (what, knows) = match self.question {
                Analysis::Load => ("a collapse load", "does"),
                Analysis::Thickness => ("the least thickness", "does"),
                Analysis::SupportMovement => ("support movements", "do"),
            };
            let remedy = left_out(&self.of_question).map_or_else(String::new, |words| format!(", or {words}"));
            sentences.push(format!(
                "{what} {knows} not take {} into account: write analysis = \"load\"{remedy}",
                listed(&self.of_question, "or")
            ));
        }
        f.write_str(&sentences.join("; "))
    }
}

impl std::error::Error for Cannot {}

/// A method with its verb.
const fn of_method(method: Method) -> &'static str {
    match method {
        Method::Limit => "limit analysis does",
        Method::Path => "the equilibrium path does",
        Method::Dem => "discrete elements do",
        Method::Fe => "finite elements of one ring do",
    }
}

/// Refuses what the method or the question of a bridge's plan does not know, all of it at once.
///
/// # Errors
/// What is not known, with what to write instead.
pub fn refused(bridge: &Bridge) -> Result<(), Cannot> {
    let (method, question, asked) = (bridge.plan.method, bridge.plan.analysis, asked(bridge));
    let of_method: Vec<Feature> =
        asked.iter().copied().filter(|feature| knows(method, *feature) == Knows::No).collect();
    let of_question: Vec<Feature> =
        asked.iter().copied().filter(|feature| answers(question, *feature) == Knows::No).collect();
    match of_method.is_empty() && of_question.is_empty() {
        true => Ok(()),
        false => Err(Cannot { method, question, of_method, of_question, asked }),
    }
}

/// The table for readers, in Markdown.
#[must_use]
pub fn table() -> String {
    let heads: Vec<String> = Method::ALL.iter().map(|method| format!("`{}`", method.word())).collect();
    let mut text = format!("| | {} | `thickness` | `support-movement` |\n", heads.join(" | "));
    text += &format!("|---|{}---|---|\n", "---|".repeat(heads.len()));
    for (feature, name, _) in WORDS {
        let word = |known: Knows| match known {
            Knows::Yes => "yes",
            Knows::AsWeight => "as weight",
            Knows::ByLimit => "by limit analysis",
            Knows::No => "no",
        };
        let is_question = matches!(
            feature,
            Feature::Thickness
                | Feature::SupportMovement
                | Feature::LoadSweep
                | Feature::Vehicles
                | Feature::DrawnBlocks
        );
        let by_question = |question: Analysis| if is_question { "" } else { word(answers(question, feature)) };
        let cells: Vec<&str> = Method::ALL.iter().map(|method| word(knows(*method, feature))).collect();
        let questions = [Analysis::Thickness, Analysis::SupportMovement].map(by_question);
        text += &format!("| {name} | {} | {} |\n", cells.join(" | "), questions.join(" | "));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn a_refusal_names_all_that_is_not_known_and_what_knows_it() {
        let mut b = samples::bridgemill();
        b.plan.method = Method::Fe;
        b.spans = vec![b.spans[0].clone(); 2];
        b.loads[0].horizontal = 0.1;
        let words = refused(&b).unwrap_err().to_string();
        let all = "finite elements of one ring do not know loads along the bridge or several spans: write method = \"dem\" or method = \"limit\" or \
                   method = \"path\"";
        assert_eq!(words, all);
        b.plan.method = Method::Path;
        assert_eq!(refused(&b), Ok(()));
    }

    #[test]
    fn every_feature_is_known_by_some_method() {
        for (feature, ..) in WORDS {
            assert!(Method::ALL.iter().any(|method| knows(*method, feature) == Knows::Yes), "{feature:?}");
        }
    }

    /// Written anew with `EXTRADOS_WRITE_DOCS=1`.
    #[test]
    fn the_page_has_the_table() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/theory/methods.md");
        let page = std::fs::read_to_string(path).expect("the page");
        let (head, rest) = page.split_once("| | ").expect("a table");
        let after = rest.split_once("\n\n").expect("what follows it").1;
        let whole = format!("{head}{}\n{after}", table());
        if std::env::var_os("EXTRADOS_WRITE_DOCS").is_some() {
            std::fs::write(path, &whole).expect("the page is written");
        }
        assert!(page == whole, "docs/theory/methods.md is not as the table has it: EXTRADOS_WRITE_DOCS=1 writes it");
    }
}
