//! Every link and picture of the pages leads somewhere, to the heading that it names; every page is in the book, and every picture on a page.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Component, Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(page: &str) -> String {
    fs::read_to_string(root().join(page)).unwrap_or_else(|error| panic!("{page}: {error}"))
}

/// Files below a folder whose name ends so, from the root of the repository.
fn files(folder: &str, ending: &str) -> Vec<String> {
    let entries = fs::read_dir(root().join(folder)).unwrap_or_else(|error| panic!("{folder}: {error}"));
    let mut found = Vec::new();
    for entry in entries.flatten() {
        let place = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            found.extend(files(&place, ending));
        } else if place.ends_with(ending) {
            found.push(place);
        }
    }
    found.sort();
    found
}

/// The pages whose links are followed.
fn pages() -> Vec<String> {
    let others = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "verification/README.md", "validation/README.md"];
    others.map(str::to_owned).into_iter().chain(files("docs", ".md")).collect()
}

/// A page without its code: fenced blocks, and words between backticks where these close on the same line.
fn prose(page: &str) -> String {
    let mut fenced = false;
    let mut text = String::new();
    for line in page.lines() {
        let fence = line.trim_start().starts_with("```");
        if !fenced && !fence {
            let parts: Vec<&str> = line.split('`').collect();
            let closed = parts.len() % 2 == 1;
            for (place, part) in parts.iter().enumerate() {
                text += if closed && place % 2 == 1 { "`" } else { part };
            }
        }
        fenced ^= fence;
        text.push('\n');
    }
    text
}

/// Where the links of a page lead, with their lines.
fn links(page: &str) -> Vec<(usize, String)> {
    let text = prose(page);
    let starts = text.match_indices("](").map(|(start, _)| start + 2);
    let target = |start: usize| text[start..].split([')', ' ', '\n']).next().unwrap_or_default().to_owned();
    starts.map(|start| (text[..start].matches('\n').count() + 1, target(start))).collect()
}

/// The anchors of a page, as the book and the sites that show repositories make them of headings.
fn anchors(page: &str) -> Vec<String> {
    let mut fenced = false;
    let mut seen = BTreeMap::new();
    let mut found = Vec::new();
    for line in page.lines() {
        fenced ^= line.trim_start().starts_with("```");
        let title = line.trim_start_matches('#');
        if fenced || title.len() == line.len() || !title.starts_with(' ') {
            continue;
        }
        // A heading that is a link is named after its words.
        let words: String = title.trim().split('[').map(|part| part.split("](").next().unwrap_or_default()).collect();
        let anchor: String = words
            .to_lowercase()
            .chars()
            .filter(|letter| letter.is_alphanumeric() || [' ', '-', '_'].contains(letter))
            .map(|letter| if letter == ' ' { '-' } else { letter })
            .collect();
        let before = seen.entry(anchor.clone()).or_insert(0);
        found.push(if *before == 0 { anchor } else { format!("{anchor}-{before}") });
        *before += 1;
    }
    found
}

/// A path without `..`.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => {
                plain.pop();
            }
            other => plain.push(other),
        }
    }
    plain
}

#[test]
fn every_link_leads_to_a_file_and_every_anchor_to_a_heading() {
    let (mut followed, mut headings, mut wrong) = (0, 0, Vec::new());
    for page in pages() {
        let text = read(&page);
        for (line, target) in links(&text) {
            let elsewhere = ["http:", "https:", "mailto:"].iter().any(|scheme| target.starts_with(scheme));
            if elsewhere {
                continue;
            }
            followed += 1;
            let (path, anchor) = target.split_once('#').unwrap_or((&target, ""));
            let folder = Path::new(&page).parent().expect("a page is in a folder");
            let there = if path.is_empty() { PathBuf::from(&page) } else { plain(&folder.join(path)) };
            if !root().join(&there).exists() {
                wrong.push(format!("{page}:{line}: {target} leads nowhere"));
            } else if !anchor.is_empty() {
                headings += 1;
                let other = read(&there.to_string_lossy());
                if !anchors(&other).iter().any(|one| one == anchor) {
                    wrong.push(format!("{page}:{line}: {target} leads to no heading"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(followed > 300 && headings > 50, "{followed} links, {headings} to headings");
}

#[test]
fn every_page_is_in_the_book_and_every_picture_on_a_page() {
    let summary = read("docs/SUMMARY.md");
    let listed: Vec<String> = links(&summary).into_iter().map(|(_, target)| format!("docs/{target}")).collect();
    for page in files("docs", ".md").iter().filter(|page| *page != "docs/SUMMARY.md") {
        assert_eq!(listed.iter().filter(|one| *one == page).count(), 1, "{page} is in docs/SUMMARY.md once");
    }
    let shown: Vec<PathBuf> = pages()
        .iter()
        .flat_map(|page| {
            let folder = Path::new(page).parent().expect("a page is in a folder").to_owned();
            links(&read(page)).into_iter().map(move |(_, target)| plain(&folder.join(target)))
        })
        .collect();
    for picture in files("docs/images", "") {
        assert!(shown.contains(&PathBuf::from(&picture)), "{picture} is on no page");
    }
}

#[test]
fn anchors_are_those_of_headings() {
    let page = "# One: two, three\n\n## `load` and *more*\n\n```\n# no heading\n```\n\n## [A link](to.md#there)\n\n## One: two, three\n#no";
    assert_eq!(anchors(page), ["one-two-three", "load-and-more", "a-link", "one-two-three-1"]);
    assert_eq!(
        links("see [this](a.md#b), `[not](that)`\n```\n[nor](this)\n```\n![p](p.svg)"),
        [(1, "a.md#b".to_owned()), (5, "p.svg".to_owned())]
    );
}
