//! An assessment: the facts of every stage, the checks that read them, and the verdict. Reports read nothing else.

use crate::checked::{self, Checked, Verdict};
use crate::collapse::Collapse;
use crate::condition::Condition;
use crate::facts::{CasesFacts, MovementFacts, SensitivityFacts, ServiceFacts, UltimateFacts, VehicleFacts};
use crate::published::assess::{checks, not_made, statics, with_sentences, worst};
use crate::statics::Statics;
use crate::update::Update;
use crate::warning::Warning;
use crate::wire::published;
use crate::words::words;
use serde::{Deserialize, Serialize};
use serde_json::json;

/// What became of a stage.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Stage<T> {
    /// It was made.
    Made(T),
    /// The file does not ask for it, or has not what it needs: in words.
    NotAsked(String),
    /// It was asked for and came to no end: in words.
    Failed(String),
    /// The file asks for it and the command left it out: the stage, and in words.
    LeftOut {
        /// Its name.
        stage: String,
        /// In words.
        why: String,
    },
}

impl<T> Default for Stage<T> {
    fn default() -> Stage<T> {
        Stage::NotAsked("not asked".to_owned())
    }
}

impl<T> Stage<T> {
    /// Its facts.
    pub fn made(&self) -> Option<&T> {
        match self {
            Stage::Made(facts) => Some(facts),
            _ => None,
        }
    }

    /// Why there are none.
    pub fn why_not(&self) -> Option<&str> {
        match self {
            Stage::Made(_) => None,
            Stage::NotAsked(why) | Stage::Failed(why) | Stage::LeftOut { why, .. } => Some(why),
        }
    }

    /// Whether it was asked for and came to no end.
    pub fn failed(&self) -> bool {
        matches!(self, Stage::Failed(_))
    }

    /// Its name where the file asks for it and the command left it out.
    pub fn left_out(&self) -> Option<&str> {
        match self {
            Stage::LeftOut { stage, .. } => Some(stage),
            _ => None,
        }
    }
}

/// The facts of every stage.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Facts {
    /// Model updating.
    pub update: Stage<Update>,
    /// Loads in service.
    pub service: Stage<ServiceFacts>,
    /// The file's loads at collapse.
    pub ultimate: Stage<UltimateFacts>,
    /// Vehicles moved over the bridge.
    pub vehicles: Stage<VehicleFacts>,
    /// Named cases of the file.
    pub cases: Stage<CasesFacts>,
    /// A support that moves.
    pub movement: Stage<MovementFacts>,
    /// What changes the governing utilisation; it can only be made once there is one.
    pub sensitivity: Stage<SensitivityFacts>,
}

impl Facts {
    /// Stages that the file asks for and the command left out.
    pub fn left_out(&self) -> Vec<String> {
        let stages = [
            self.update.left_out(),
            self.service.left_out(),
            self.ultimate.left_out(),
            self.vehicles.left_out(),
            self.cases.left_out(),
            self.movement.left_out(),
        ];
        stages.into_iter().flatten().map(str::to_owned).collect()
    }

    /// The analysis of a support that moves.
    pub fn moved(&self) -> Option<&Collapse> {
        self.movement.made()?.collapse.as_deref()
    }

    /// Warnings of every stage, each with the stage's name.
    pub fn warnings(&self) -> impl Iterator<Item = (&'static str, &Warning)> {
        let lists: [(&str, &[Warning]); 6] = [
            ("update", self.update.made().map_or(&[], |facts| &facts.warnings)),
            ("service", self.service.made().map_or(&[], |facts| &facts.warnings)),
            ("collapse", self.ultimate.made().map_or(&[], |facts| &facts.warnings)),
            ("vehicles", self.vehicles.made().map_or(&[], |facts| &facts.warnings)),
            ("cases", self.cases.made().map_or(&[], |facts| &facts.warnings)),
            ("support movement", self.moved().map_or(&[], |found| &found.warnings)),
        ];
        lists.into_iter().flat_map(|(stage, list)| list.iter().map(move |warning| (stage, warning)))
    }

    /// The same, each once, with the names of all stages that give it.
    pub fn warnings_once(&self) -> Vec<(String, &Warning)> {
        once(self.warnings())
    }
}

/// What several stages say, once, in the order in which it is first said, each with the names of the stages.
pub fn once<'a, T: PartialEq>(said: impl Iterator<Item = (&'static str, &'a T)>) -> Vec<(String, &'a T)> {
    let mut all: Vec<(Vec<&str>, &T)> = Vec::new();
    for (stage, what) in said {
        match all.iter_mut().find(|(_, one)| *one == what) {
            Some((stages, _)) if stages.contains(&stage) => {}
            Some((stages, _)) => stages.push(stage),
            None => all.push((vec![stage], what)),
        }
    }
    all.into_iter().map(|(stages, what)| (stages.join(", "), what)).collect()
}

published! {
    /// A bridge that was judged; the status of its verdict is published as that of the command.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Assessment |all| {
        /// Name of the bridge.
        pub bridge: String,
        /// Where the file has its limits from.
        pub limits_source: Option<String> [kept],
        = ..Verdict = Some(all.verdict.object()),
        /// The verdict.
        pub verdict: Verdict [kept],
        /// Every comparison: `code`, `title`, `value`, `limit`, `unit`, `utilisation`, `met` and so on.
        = checks: Vec<Comparison> = checks(&all.checked),
        /// Checks that could not be made: `code`, `title`, `why`, `analysis_failed`.
        = not_made: Vec<Object> = not_made(&all.checked),
        /// The comparison that uses most of its limit: `code`, `title`, `load_model`, `utilisation`, `met`.
        = governing: Option<Object> = worst(&all.checked),
        /// Its checks.
        pub checked: Vec<Checked> [kept],
        /// What records say of its materials.
        pub condition: Vec<Condition>,
        /// What to do next, by rule.
        pub next: Vec<Step> as next_steps,
        /// What it weighs, and what it hands to the ground at rest; none where it cannot be cut into blocks.
        pub statics?: Option<Statics> = all.statics.as_ref().map(statics),
        /// What changes the governing utilisation.
        = sensitivity?: Option<Value> = all.facts.sensitivity.made().map(|facts| json!(facts)),
        /// Loads in service.
        = service?: Option<Value> =
            all.facts.service.made().map(|facts| with_sentences(facts, &facts.assumptions, &facts.warnings)),
        /// The file's own loads at collapse, where that was analysed.
        = collapse?: Option<Collapse> = all.facts.ultimate.made().and_then(|facts| facts.collapse.as_ref()),
        /// Uniform loads of which a part does more harm than the whole.
        = shortened?: Option<Vec<Object>> = all.facts.ultimate.made().map(|facts| json!(facts.shortened)),
        /// Vehicles moved over the bridge under the factors of a rule.
        = vehicles?: Option<Value> =
            all.facts.vehicles.made().map(|facts| with_sentences(facts, &facts.assumptions, &facts.warnings)),
        /// What the file's named cases carry.
        = cases?: Option<Value> = all.facts.cases.made().map(|facts| with_sentences(facts, &facts.assumptions, &facts.warnings)),
        /// The movement of a support that makes a mechanism.
        = support_movement?: Option<Collapse> = all.facts.moved(),
        /// What updating found.
        = update?: Option<Update> = all.facts.update.made(),
        /// The facts of its stages.
        pub facts: Facts [kept],
    }
}

impl Assessment {
    /// The stage whose check governs: that of the file's loads at collapse or of its vehicles; none where another does.
    pub fn governing_stage(&self) -> Option<&'static str> {
        match checked::worst(&self.checked)?.0.code.as_str() {
            "C201" | "C202" => Some("collapse"),
            "C204" => Some("vehicles"),
            _ => None,
        }
    }
}

words! {
    /// Kinds of steps that follow an assessment.
    pub enum Action {
        /// Loads that are not carried stay off.
        Restrict = "restrict",
        /// Something is measured on site.
        Inspect = "inspect",
        /// Something that can grow is measured again and again.
        Monitor = "monitor",
        /// A finer analysis, or a number confirmed.
        Refine = "refine",
    }
}

published! {
    /// A step that follows from a fact of the assessment by a rule.
    #[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
    pub struct Step {
        /// Its kind.
        pub action: Action,
        /// What to do.
        pub what: String,
        /// The fact.
        pub because: String,
        /// The rule, and where it is from.
        pub rule: String,
    }
}

#[cfg(test)]
mod once_tests {
    use super::once;

    #[test]
    fn what_several_stages_say_is_told_once_with_their_names() {
        let said = [
            ("collapse", &"skew"),
            ("collapse", &"rings"),
            ("vehicles", &"skew"),
            ("vehicles", &"skew"),
            ("cases", &"rings"),
        ];
        let told = once(said.into_iter());
        assert_eq!(told, [("collapse, vehicles".to_owned(), &"skew"), ("collapse, cases".to_owned(), &"rings")]);
    }
}
