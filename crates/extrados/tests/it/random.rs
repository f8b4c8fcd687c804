//! Files with every key, changed at random: none ends in a panic, and each rejection says where, what and what to write instead.

use extrados::bridge::fields::{FILE, Field, Kind, Section};
use extrados::{
    AssessOptions, Choice, CollapseOptions, Means, Memory, Progress, Project, Refusal, RespondOptions, SweepOptions,
    UpdateOptions, VaryOptions, Watch, Wish, assess, cases, collapse, compare, respond, settings, sweep, update, vary,
};

/// Files that can be used, with the keys that describe an old bridge.
const BASES: [&str; 8] = [
    include_str!("../../../bridge/tests/it/files/condition.toml"),
    include_str!("../../../bridge/tests/it/files/cases.toml"),
    include_str!("../../../bridge/tests/it/files/tiny.toml"),
    include_str!("../../../bridge/tests/it/files/road.toml"),
    include_str!("../../../bridge/tests/it/files/defects.toml"),
    include_str!("../../../bridge/tests/it/files/shapes.toml"),
    include_str!("../../../bridge/tests/it/files/viaduct.toml"),
    include_str!("../../../bridge/tests/it/files/walls.toml"),
];

/// Numbers that look random and are the same in every run (splitmix64).
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn below(&mut self, count: usize) -> usize {
        (self.roll() * count as f64) as usize
    }
}

/// A work that ends after some looks.
struct Short(u32);

impl Watch for Short {
    fn look(&mut self, _: &Progress) -> Wish {
        self.0 = self.0.saturating_sub(1);
        if self.0 == 0 { Wish::Stop } else { Wish::GoOn }
    }
}

/// A value of a card: its example, a word of its list, or a number that may be of no bridge.
fn value(field: &Field, dice: &mut Dice) -> String {
    match field.kind {
        Kind::Word(words) => format!("\"{}\"", words[dice.below(words.len())].word),
        Kind::Count => format!("{}", dice.below(6)),
        Kind::Flag => (if dice.roll() < 0.5 { "true" } else { "false" }).to_owned(),
        Kind::Number => format!("{:.3}", 2.0 * dice.roll() - 0.2),
        Kind::Quantity(_) => scaled(&field.example_literal(), dice),
        _ => field.example_literal(),
    }
}

/// The first number of a line, times something about one for the most part.
fn scaled(line: &str, dice: &mut Dice) -> String {
    let Some(from) = line.find(|c: char| c.is_ascii_digit()) else { return line.to_owned() };
    let to = line[from..].find(|c: char| !(c.is_ascii_digit() || c == '.')).map_or(line.len(), |end| from + end);
    let Ok(number) = line[from..to].parse::<f64>() else { return line.to_owned() };
    let factor = match dice.below(24) {
        0 => 1e3,
        1 => 1e-3,
        2 => -1.0,
        _ => 0.6 + 0.8 * dice.roll(),
    };
    format!("{}{:.4}{}", &line[..from], number * factor, &line[to..])
}

/// One change: a line scaled, dropped or doubled, or a table of the file with some of its keys.
fn changed(text: &str, dice: &mut Dice) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let at = dice.below(lines.len());
    match dice.below(14) {
        0 => drop(lines.remove(at)),
        1 => lines.insert(at, lines[at].clone()),
        2..9 => {
            if let Some((key, rest)) = lines[at].clone().split_once('=') {
                lines[at] = format!("{key}={}", scaled(rest, dice));
            }
        }
        _ => lines.extend(section(dice)),
    }
    lines.join("\n") + "\n"
}

/// Tables that say something of an old bridge.
const TABLES: [&str; 17] = [
    "assess",
    "water",
    "mexe",
    "case",
    "span",
    "sweep",
    "document",
    "defect",
    "road",
    "backing",
    "cover",
    "carriageway",
    "fill_pressure",
    "continuum",
    "load",
    "spandrel_wall",
    "support_movement",
];

fn section(dice: &mut Dice) -> Vec<String> {
    let wanted = TABLES[dice.below(TABLES.len())];
    let tables = FILE.fields.iter().filter_map(|field| match field.kind {
        Kind::Table(section) => Some((section, format!("[{}]", section.path))),
        Kind::Tables(section) => Some((section, format!("[[{}]]", section.path))),
        _ => None,
    });
    let found: Option<(&Section, String)> = tables.into_iter().find(|(section, _)| section.path == wanted);
    let Some((section, header)) = found else { return Vec::new() };
    let mut lines = vec![header];
    for field in section.fields.iter().filter(|field| !matches!(field.kind, Kind::Table(_) | Kind::Tables(_))) {
        let needed = field.need == extrados::bridge::fields::Need::Required;
        if dice.roll() < if needed { 0.96 } else { 0.25 } {
            lines.push(format!("{} = {}", field.key, value(field, dice)));
        }
    }
    lines
}

/// Two values of the width.
fn varied(project: &Project) -> Result<(), Refusal> {
    let first = |list: Vec<Refusal>| list.into_iter().next().unwrap_or_else(|| unreachable!("a refusal without one"));
    let requests = settings(project, &["bridge.width=4m..5m:2"]).map_err(first)?;
    let options = VaryOptions { most_runs: 4, ..VaryOptions::default() };
    vary(project, &requests, &options, &Means::default(), &mut Short(20)).map(drop).map_err(first)
}

/// How many files; the environment can ask for more.
fn count() -> u64 {
    std::env::var("EXTRADOS_RANDOM_FILES").ok().and_then(|count| count.parse().ok()).unwrap_or(60)
}

#[test]
fn files_changed_at_random_are_analysed_or_refused_with_place_and_remedy() {
    let (mut analysed, mut refused, mut not_set_up) = (0, 0, 0);
    for seed in 0..count() {
        let mut dice = Dice(seed);
        let mut text = BASES[dice.below(BASES.len())].to_owned();
        for _ in 0..=dice.below(3) {
            text = changed(&text, &mut dice);
        }
        let files = Memory::default().with("bridge.toml", text.clone());
        let project = match Project::read("bridge.toml", &files) {
            Ok(project) => project,
            // A companion that is not there.
            Err(refusal) => {
                assert!(!refusal.message.is_empty() && !refusal.help.is_empty(), "{seed}: {refusal:?}");
                refused += 1;
                continue;
            }
        };
        for finding in project.findings() {
            assert!(finding.range.end <= text.len() && finding.range.start <= finding.range.end, "{seed}: {finding:?}");
            assert!(!finding.message.is_empty() && !finding.code.is_empty(), "{seed}: {finding:?}");
            let is_error = finding.severity == extrados::bridge::Severity::Error;
            assert!(
                !is_error || finding.help.as_ref().is_some_and(|help| !help.is_empty()),
                "{seed}: {finding:?}\n{text}"
            );
        }
        if project.bridge().is_err() {
            refused += 1;
            continue;
        }
        let mut told = |answer: Result<(), extrados::Refusal>| match answer {
            Ok(()) => analysed += 1,
            Err(refusal) => {
                assert!(!refusal.message.is_empty() && !refusal.help.is_empty(), "{seed}: {refusal:?}");
                not_set_up += 1;
            }
        };
        for method in [bridge::Method::Limit, bridge::Method::Path, bridge::Method::Dem, bridge::Method::Fe] {
            let choice = Choice { method: Some(method), ..Choice::default() };
            let options = CollapseOptions { choice, ..CollapseOptions::default() };
            told(collapse(&project, &options, &mut Short(40)).map(drop));
        }
        let options = SweepOptions { step: Some(1.0), ..SweepOptions::default() };
        told(sweep(&project, &options, &mut Short(60)).map(drop));
        told(cases(&project, Choice::default(), &mut Short(40)).map(drop));
        told(respond(&project, &RespondOptions::default(), &mut Short(20)).map(drop));
        told(compare(&project, &project, Choice::default(), &mut Short(20)).map(drop));
        told(update(&project, &UpdateOptions::default(), &Means::default(), &mut Short(10)).map(drop));
        told(assess(&project, &AssessOptions::default(), &Means::default(), &mut Short(30)).map(drop));
        told(varied(&project));
        // As `extrados convert` makes blocks of it; a bridge that cannot be cut into blocks says why.
        match project.bridge().map(|bridge| structure::discretise::discretise(bridge).map(|d| (bridge, d))) {
            Ok(Ok((bridge, d))) => {
                let written = structure::blocks::toml(&structure::blocks::of_bridge(bridge, &d));
                assert!(!written.is_empty(), "{seed}");
            }
            Ok(Err(error)) => assert!(!error.to_string().is_empty(), "{seed}"),
            Err(refusal) => assert!(!refusal.help.is_empty(), "{seed}"),
        }
    }
    assert!(analysed > count() / 4 && refused > count() / 10, "{analysed} {not_set_up} {refused}");
}
