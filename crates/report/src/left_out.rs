//! What was not looked at: in one place, with what to write in the file to have it.

use crate::parts::Part;
use crate::rows::OpenRow;
use outcome::assessment::{Assessment, Facts};

/// Everything that was skipped, not asked for, not given or left out; the checks that were not made, by reason.
pub(crate) fn left_out(a: &Assessment, open: &[OpenRow]) -> Vec<Part> {
    let mut part = Part { id: Some("left-out"), title: "What was not looked at", ..Part::default() };
    part.words.push(
        "What was skipped, not asked for, not given or left out, and what to write in the bridge file to have it."
            .into(),
    );
    part.heads = vec!["what", "why not", "to have it"];
    part.rows = stages(&a.facts).into_iter().map(Vec::from).collect();
    let given = &a.verdict.given;
    if !given.load_cases_left_out.is_empty() {
        let what = format!("load cases of {}", given.name);
        let why = "they apply to these spans and were not moved".to_owned();
        part.rows.push(vec![
            what,
            why,
            format!("name them in vehicles of [sweep]: {}", given.load_cases_left_out.join(", ")),
        ]);
    }
    for words in a.facts.vehicles.made().into_iter().flat_map(|facts| &facts.left_out) {
        part.rows.push(vec!["part of the rule's loads".into(), words.clone(), "another calculation".into()]);
    }
    for one in given.taken.iter().filter(|one| !one.write.is_empty()) {
        part.rows.push(vec![one.what.clone(), one.how.clone(), format!("write {}", one.write)]);
    }
    if part.rows.is_empty() {
        part.heads.clear();
        part.words = vec!["Every analysis was made, and the verdict takes nothing that the file does not give.".into()];
    }
    let mut parts = vec![part];
    if !open.is_empty() {
        let mut checks = Part { title: "Checks that were not made", ..Part::default() };
        checks.words.push("“extrados explain C101” tells what a check is and where it is from.".into());
        checks.heads = vec!["why not", "checks", "to have them"];
        checks.rows = by_reason(open);
        parts.push(checks);
    }
    parts
}

/// Stages without a result: which, why, and what to write.
fn stages(facts: &Facts) -> Vec<[String; 3]> {
    let all = [
        ("update: moduli from measurements", facts.update.why_not(), facts.update.left_out()),
        ("service: deflections and stresses under trains", facts.service.why_not(), facts.service.left_out()),
        ("collapse: the file's own loads", facts.ultimate.why_not(), facts.ultimate.left_out()),
        ("vehicles: load models of a rule", facts.vehicles.why_not(), facts.vehicles.left_out()),
        ("cases: named loads", facts.cases.why_not(), facts.cases.left_out()),
        ("support movement", facts.movement.why_not(), facts.movement.left_out()),
        ("sensitivities: what would change the verdict", facts.sensitivity.why_not(), facts.sensitivity.left_out()),
    ];
    let row = |(what, why, left): (&str, Option<&str>, Option<&str>)| {
        let why = why?;
        let skipped = why.strip_prefix("left out by --skip ").filter(|stage| !stage.contains(' '));
        let remedy = match (left.or(skipped), table(why)) {
            (Some(stage), _) => format!("run without --skip {stage}"),
            (None, Some(table)) => format!("write {table}"),
            (None, None) => "–".to_owned(),
        };
        Some([what.to_owned(), why.to_owned(), remedy])
    };
    all.into_iter().filter_map(row).collect()
}

/// The table of a bridge file that words name: `[records]`, `[[case]]`.
fn table(words: &str) -> Option<&str> {
    let start = words.find('[')?;
    let end = start
        + words[start..]
            .find(|c: char| c != '[' && c != ']' && c != '_' && !c.is_ascii_alphanumeric())
            .unwrap_or(words.len() - start);
    Some(&words[start..end]).filter(|table| table.ends_with(']'))
}

/// Where most limits are from.
const USUAL: &str = ", from the rule that you assess by";

/// Why checks were not made, which, and what to write with the codes that it serves.
type Reason<'a> = (String, Vec<&'a OpenRow>, Vec<(String, Vec<&'a str>)>);

/// Checks that were not made, a row a reason: why, which, and what to write for each.
fn by_reason(open: &[OpenRow]) -> Vec<Vec<String>> {
    let mut rows: Vec<Reason<'_>> = Vec::new();
    for row in open {
        let (why, remedy) = row.why.split_once(": write ").unwrap_or((&row.why, ""));
        let why = if row.failed { format!("an analysis came to no end: {why}") } else { why.to_owned() };
        let at = rows.iter().position(|(known, ..)| *known == why).unwrap_or_else(|| {
            rows.push((why, Vec::new(), Vec::new()));
            rows.len() - 1
        });
        let (_, checks, remedies) = &mut rows[at];
        checks.push(row);
        if !remedy.is_empty() {
            match remedies.iter_mut().find(|(known, _)| known == remedy) {
                Some((_, codes)) => codes.push(&row.code),
                None => remedies.push((remedy.to_owned(), vec![&row.code])),
            }
        }
    }
    rows.sort_by_key(|(_, checks, _)| std::cmp::Reverse(checks.len()));
    let told = |(why, checks, remedies): Reason<'_>| {
        let checks: Vec<String> = checks.iter().map(|row| format!("{} {}", row.code, row.title)).collect();
        let several = remedies.len() > 1;
        // The table that all of them stand in is named once.
        let all_in = several && remedies.iter().all(|(words, _)| words.contains(" in [assess]"));
        let remedy = |(words, codes): &(String, Vec<&str>)| {
            let words = if all_in { words.replace(" in [assess]", "").replace(USUAL, "") } else { words.clone() };
            if several { format!("{}: {words}", codes.join(", ")) } else { format!("write {words}") }
        };
        let head = match (several, all_in) {
            (false, _) => None,
            (true, true) => {
                Some("write in [assess], from the rule that you assess by where nothing else is said:".to_owned())
            }
            (true, false) => Some("write".to_owned()),
        };
        let lines: Vec<String> = head.into_iter().chain(remedies.iter().map(remedy)).collect();
        vec![why, checks.join("\n"), if lines.is_empty() { "–".to_owned() } else { lines.join("\n") }]
    };
    rows.into_iter().map(told).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parts::tests::nothing;

    fn open(code: &str, why: &str) -> OpenRow {
        OpenRow { code: code.into(), title: format!("check {code}"), why: why.into(), failed: false }
    }

    #[test]
    fn what_several_checks_say_is_one_row_with_what_to_write_for_each() {
        let rows = by_reason(&[
            open("C104", "the bridge has no pier"),
            open(
                "C101",
                "the file gives no limit: write deflection_limit = \"… mm\" in [assess], from the rule that you assess by",
            ),
            open("C102", "the file gives no limit: write tension_limit in [assess], from the rule that you assess by"),
            open("C103", "the file gives no limit: write tension_limit in [assess], from the rule that you assess by"),
        ]);
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[0][0], "the file gives no limit");
        assert_eq!(rows[0][1], "C101 check C101\nC102 check C102\nC103 check C103");
        let remedies = "C101: deflection_limit = \"… mm\"\nC102, C103: tension_limit";
        assert!(
            rows[0][2].starts_with("write in [assess], from the rule") && rows[0][2].ends_with(remedies),
            "{}",
            rows[0][2]
        );
        assert_eq!(rows[1], ["the bridge has no pier", "C104 check C104", "–"]);
    }

    #[test]
    fn every_stage_without_a_result_is_there_with_what_to_write() {
        use outcome::assessment::Stage;
        let mut a = nothing();
        a.facts.update = Stage::NotAsked("the file names no [records]".into());
        a.facts.cases = Stage::NotAsked("the file has no [[case]]".into());
        a.facts.service = Stage::LeftOut { stage: "service".into(), why: "left out by --skip service".into() };
        let parts = left_out(&a, &[]);
        let remedies: Vec<&str> = parts[0].rows.iter().map(|row| row[2].as_str()).collect();
        assert_eq!(remedies[..2], ["write [records]", "run without --skip service"]);
        assert!(remedies.contains(&"write [[case]]") && parts[0].rows.len() == 7, "{remedies:?}");
        assert_eq!(table("the file has no [train] that crosses"), Some("[train]"));
        assert_eq!(table("left out"), None);
    }
}
