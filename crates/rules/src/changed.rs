//! What an engineer's own rule changes of the library's rule that it builds on.

use crate::{Acting, Confidence, EffectiveWidth, FillReduction, Impact, Library, Loads, Rule, Ways};
use serde::{Deserialize, Serialize};

/// A factor that differs from that of the library's rule.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct ChangedFactor {
    /// Which factor, in words: "live load", "impact on cs-454".
    pub factor: String,
    /// What the library has, in words.
    pub library: String,
    /// What acts, in words.
    pub file: String,
    /// The source that the file names.
    pub source: String,
}

/// How the library's rule was found that another one builds on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Base<'a> {
    /// The rule of the library.
    pub rule: &'a Rule,
    /// Whether the file names it, by `based_on`, its code, its title or its source; the nearest one otherwise.
    pub named: bool,
}

/// The rule of the library that an own rule builds on: the one that it names, else the one for the same ways that fewest factors tell it
/// from. None where the library has no rule for its ways.
pub fn based_on<'a>(own: &Rule, library: &'a Library) -> Option<Base<'a>> {
    let of_code = |code: &str| library.rule(code).map(|rule| Base { rule, named: true });
    if let Some(base) = of_code(&own.based_on).or_else(|| of_code(&own.code)) {
        return Some(base);
    }
    let said: Vec<String> = [&own.code, &own.title, &own.source.text].map(|text| letters(text)).to_vec();
    let standard = |rule: &&Rule| rule.code != WITHOUT_SAFETY;
    let is_named = |rule: &&Rule| {
        let names = [letters(&rule.code), letters(rule.title.split(',').next().unwrap_or_default())];
        names.iter().any(|name| said.iter().any(|said| said.contains(name.as_str())))
    };
    let nearest =
        |rules: Vec<&'a Rule>| rules.into_iter().min_by_key(|rule| changed_for(own, rule, &own.models()).len());
    let rules = || library.rules.iter().filter(standard);
    let named = nearest(rules().filter(is_named).collect()).map(|rule| Base { rule, named: true });
    let for_ways = |rule: &&Rule| rule.ways.iter().any(|way: &Ways| own.ways.contains(way));
    named.or_else(|| nearest(rules().filter(for_ways).collect()).map(|rule| Base { rule, named: false }))
}

/// The rule that holds no safety: no standard to build on.
const WITHOUT_SAFETY: &str = "characteristic";

/// A text's letters and digits, small.
fn letters(text: &str) -> String {
    text.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// Every factor of a rule that differs from another's, of those on load models the ones of these models alone. A factor of the same value that
/// the file calls surer than the library does differs too: its source is the engineer's.
pub fn changed_for(own: &Rule, base: &Rule, models: &[&str]) -> Vec<ChangedFactor> {
    let mut list = Vec::new();
    for ((name, factor), (_, of_base)) in own.listed().into_iter().zip(base.listed()) {
        put(&mut list, name, of_base.value, factor.value, &factor.source.text);
        let [library, file] = [of_base, factor].map(|factor| factor.source.confidence);
        if factor.value == of_base.value && file < library {
            let words = |confidence: Confidence| format!("{} ({})", factor.value, confidence.word());
            told(&mut list, name, &words(library), &words(file), &factor.source.text);
        }
    }
    let (d, b) = (&own.dispersal, &base.dispersal);
    for (name, of_base, value) in [
        ("dispersal: length at the surface [m]", b.length_base_m, d.length_base_m),
        ("dispersal: length per depth", b.length_per_depth, d.length_per_depth),
        ("dispersal: width at the surface [m]", b.width_base_m, d.width_base_m),
        ("dispersal: width per depth", b.width_per_depth, d.width_per_depth),
        ("dispersal: least depth [m]", b.least_depth_m, d.least_depth_m),
        ("dispersal: widest strip [m]", most(b.strip_at_most_m), most(d.strip_at_most_m)),
    ] {
        put(&mut list, name, of_base, value, &d.source.text);
    }
    let pressure = format!("{:?}", d.pressure);
    told(&mut list, "dispersal: pressure", &format!("{:?}", b.pressure), &pressure, &d.source.text);
    let (width, source) = width(&own.effective_width);
    told(&mut list, "effective width", &self::width(&base.effective_width).0, &width, source);
    for loads in &own.loads {
        for model in loads.models.iter().filter(|model| models.contains(&model.as_str())) {
            let name = |what: &str| format!("{what} on {model}");
            let of_base = base.loads.iter().find(|other| other.models.contains(model));
            let first = of_base.or(base.loads.first());
            let live = |rule: &Rule, loads: Option<&Loads>| {
                loads.and_then(|l| l.live_load.clone()).unwrap_or_else(|| rule.factors.live_load.clone())
            };
            let (own_live, base_live) = (live(own, Some(loads)), live(base, of_base));
            put(&mut list, &name("live load"), base_live.value, own_live.value, &own_live.source.text);
            let impact = of_base.map(|l| &l.impact).or(base.impact.as_ref()).or(first.map(|l| &l.impact));
            told(&mut list, &name("impact"), &motion(impact), &motion(Some(&loads.impact)), &from(&loads.impact));
            let Some(of_base) = of_base else { continue };
            let source = &own.source.text;
            let lanes = |l: &Loads| if l.presence.is_empty() { "1".to_owned() } else { joined(&l.presence) };
            told(&mut list, &name("multiple presence"), &lanes(of_base), &lanes(loads), source);
            let uniform = |l: &Loads| if l.impact_on_uniform { "yes" } else { "no" }.to_owned();
            told(&mut list, &name("impact on uniform loads"), &uniform(of_base), &uniform(loads), source);
            let heavier = |l: &Loads| {
                l.overload.as_ref().map_or("none".to_owned(), |o| format!("{} and {}", o.critical, o.others))
            };
            told(&mut list, &name("overload"), &heavier(of_base), &heavier(loads), source);
            let beside = |l: &Loads| {
                l.beside.as_ref().map_or("nothing".to_owned(), |b| format!("{} of {}", b.share, b.vehicles.join(", ")))
            };
            told(&mut list, &name("lanes beside"), &beside(of_base), &beside(loads), source);
        }
    }
    if let Some(impact) = own.impact.as_ref().filter(|own| base.impact.as_ref() != Some(*own)) {
        let of_base = base.impact.as_ref().or(base.loads.first().map(|loads| &loads.impact));
        told(&mut list, "impact on other models", &motion(of_base), &motion(Some(impact)), &from(impact));
    }
    list
}

/// What the file of a load model changes by its `[[under]]` of what the rule does with other loads.
pub fn changed_by_vehicles(rule: &Rule, model: &str, acting: &Acting) -> Vec<ChangedFactor> {
    let mut list = Vec::new();
    if !acting.of_vehicle_file {
        return list;
    }
    let live = (rule.factors.live_load.value, acting.live_load.value);
    put(&mut list, &format!("live load on {model}"), live.0, live.1, &acting.live_load.source.text);
    let impact = rule.impact.as_ref().or(rule.loads.first().map(|loads| &loads.impact));
    let name = format!("impact on {model}");
    told(&mut list, &name, &motion(impact), &motion(Some(&acting.impact)), &from(&acting.impact));
    list
}

/// The largest width of a strip; without limit where the rule has none.
fn most(width: Option<f64>) -> f64 {
    width.unwrap_or(f64::INFINITY)
}

fn joined(list: &[f64]) -> String {
    list.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// What motion adds, in words that tell every number of it.
fn motion(impact: Option<&Impact>) -> String {
    let Some(impact) = impact else { return "none".to_owned() };
    let fill = |fill: &FillReduction| format!(", fill {}, {}, {}", fill.depth_m, fill.share, fill.vanishing_m);
    let more = match impact {
        Impact::Augment { fill: Some(own), .. } | Impact::AllAxles { fill: Some(own), .. } => fill(own),
        Impact::Root { least, cover, .. } => {
            let less = cover.as_ref().map(|cover| format!(", cover {}, {}", cover.from_m, cover.per_m));
            format!(", at least {least}{}", less.unwrap_or_default())
        }
        _ => String::new(),
    };
    impact.told() + &more
}

fn from(impact: &Impact) -> String {
    impact.sources().first().map_or_else(String::new, |source| source.text.clone())
}

/// An effective width in words, and where it is from.
fn width(width: &EffectiveWidth) -> (String, &str) {
    match width {
        EffectiveWidth::Dispersed { source } => ("as the load spreads".to_owned(), &source.text),
        EffectiveWidth::Barrel { source } => ("the whole barrel".to_owned(), &source.text),
        EffectiveWidth::Fixed { width_m, source } => (format!("{width_m} m"), &source.text),
    }
}

/// Lists a number that differs.
fn put(list: &mut Vec<ChangedFactor>, factor: &str, library: f64, file: f64, source: &str) {
    told(list, factor, &library.to_string(), &file.to_string(), source);
}

/// Lists words that differ.
fn told(list: &mut Vec<ChangedFactor>, factor: &str, library: &str, file: &str, source: &str) {
    if library != file {
        let [factor, library, file, source] = [factor, library, file, source].map(str::to_owned);
        list.push(ChangedFactor { factor, library, file, source });
    }
}
