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

/// Names that are numbered in a row as "ra1 to ra15", from three of them on, the others one by one.
pub fn in_rows<S: AsRef<str>>(names: &[S]) -> String {
    let numbered = |name: &str| {
        let stem = name.trim_end_matches(|letter: char| letter.is_ascii_digit());
        Some((stem.to_owned(), name[stem.len()..].parse::<u64>().ok()?))
    };
    let mut told: Vec<String> = Vec::new();
    let mut rest = names;
    while let [first, others @ ..] = rest {
        let follows = |k: usize, name: &S| {
            numbered(first.as_ref())
                .zip(numbered(name.as_ref()))
                .is_some_and(|((a, n), (b, m))| a == b && m == n + k as u64 + 1)
        };
        let more = others.iter().enumerate().take_while(|(k, name)| follows(*k, name)).count();
        let taken = if more >= 2 { more } else { 0 };
        told.push(match taken {
            0 => first.as_ref().to_owned(),
            _ => format!("{} to {}", first.as_ref(), others[taken - 1].as_ref()),
        });
        rest = &others[taken..];
    }
    told.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_a_row_are_told_by_their_ends() {
        let ra: Vec<String> = (1..=15).map(|k| format!("ra{k}")).collect();
        assert_eq!(in_rows(&ra), "ra1 to ra15");
        assert_eq!(in_rows(&["ra1", "ra2", "ra4", "lm71", "ra5", "ra6", "ra7"]), "ra1, ra2, ra4, lm71, ra5 to ra7");
        assert_eq!(in_rows::<&str>(&[]), "");
    }

    #[test]
    fn one_is_one_and_none_are_several() {
        let words =
            [(0, "vehicle"), (1, "vehicle"), (2, "vehicle"), (1, "entity"), (2, "entity"), (2, "box"), (3, "free way")];
        let said: Vec<String> = words.iter().map(|(count, one)| counted(*count, one)).collect();
        assert_eq!(said, ["0 vehicles", "1 vehicle", "2 vehicles", "1 entity", "2 entities", "2 boxes", "3 free ways"]);
        assert_eq!([verb(1, "is", "are"), verb(2, "is", "are")], ["is", "are"]);
    }
}
