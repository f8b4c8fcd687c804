//! Counts in words.

/// How many of something: "1 vehicle", "2 vehicles", "1 entity", "3 entities". What stands before the last word stays as it is.
pub fn counted(count: usize, one: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {}", several(one)) }
}

/// The plural of a word, by the rules of English.
pub fn several(one: &str) -> String {
    let after_consonant = |stem: &str| !stem.ends_with(['a', 'e', 'i', 'o', 'u']);
    match one.strip_suffix('y') {
        Some(stem) if after_consonant(stem) => format!("{stem}ies"),
        _ if ["s", "x", "ch", "sh"].iter().any(|end| one.ends_with(end)) => format!("{one}es"),
        _ => format!("{one}s"),
    }
}

/// The verb that goes with a count: "is" of one, "are" of several.
pub fn verb<'a>(count: usize, one: &'a str, several: &'a str) -> &'a str {
    if count == 1 { one } else { several }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_is_one_and_none_are_several() {
        let words =
            [(0, "vehicle"), (1, "vehicle"), (2, "vehicle"), (1, "entity"), (2, "entity"), (2, "box"), (3, "free way")];
        let said: Vec<String> = words.iter().map(|(count, one)| counted(*count, one)).collect();
        assert_eq!(said, ["0 vehicles", "1 vehicle", "2 vehicles", "1 entity", "2 entities", "2 boxes", "3 free ways"]);
        assert_eq!([verb(1, "is", "are"), verb(2, "is", "are")], ["is", "are"]);
    }
}
