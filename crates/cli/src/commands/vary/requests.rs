//! What is asked to vary: the command line's words, another file's tables, or the bridge file's own.

use super::super::{Desk, Source, read_file};
use super::{Arguments, Refusals};
use crate::failure::Failure;
use crate::render::{self, Paint};
use crate::report::Report;
use bridge::edit::Document;
use bridge::vary::{Request, Slip, Varied, find, parse_setting, settle, twice};

/// The file's text as a tree that can be edited, without its own ranges.
pub fn document(source: &Source) -> Result<Document, Failure> {
    let text = std::str::from_utf8(&source.text).unwrap_or_default();
    let mut document = Document::parse(text).ok_or_else(|| {
        Failure::input("F114", format!("{} cannot be edited", source.name), "check it with extrados check")
    })?;
    document.remove("vary");
    Ok(document)
}

/// The quantities and their values, or everything that is wrong with them. Findings about another file of ranges are
/// shown with their places and stand in the report.
pub fn gather(
    desk: &mut Desk,
    arguments: &Arguments,
    source: &Source,
    document: &Document,
    report: &mut Report,
) -> Result<Result<Vec<Varied>, Refusals>, Failure> {
    let mut refusals = Vec::new();
    let requests = match &arguments.ranges {
        Some(path) => {
            let text = read_file(path)?;
            let (requests, findings) = bridge::read_ranges(&text, document);
            let name = path.display().to_string();
            desk.screen.remark(&render::findings(&name, &text, &findings, &Paint::for_stderr()));
            report.add_findings(&name, &text, &findings);
            if !findings.is_empty() {
                return Ok(Err(refusals));
            }
            requests
        }
        None if !arguments.set.is_empty() => {
            let read = arguments.set.iter().map(|text| parse_setting(document, text));
            read.filter_map(|request| request.map_err(|slip| refusals.push(refusal(slip))).ok()).collect()
        }
        None => source.read.vary.clone(),
    };
    if requests.is_empty() && refusals.is_empty() {
        let help = "add [[vary]] tables, or say --set joint.friction_angle=30deg..40deg:5; --list shows what there is";
        refusals.push(Failure::input("F113", format!("{} says nothing of what to vary", source.name), help));
    }
    let varied = settled(document, &requests, &mut refusals);
    Ok(if refusals.is_empty() { Ok(varied) } else { Err(refusals) })
}

fn settled(document: &Document, requests: &[Request], refusals: &mut Refusals) -> Vec<Varied> {
    let mut varied = Vec::new();
    for request in requests {
        let found = find(document, &request.quantity).and_then(|quantity| settle(&quantity, &request.spread));
        match found {
            Ok(one) => varied.push(one),
            Err(slip) => refusals.push(refusal(slip)),
        }
    }
    let paths: Vec<(usize, String)> = varied.iter().enumerate().map(|(at, one)| (at, one.path.to_string())).collect();
    refusals.extend(twice(&paths).into_iter().map(|(_, slip)| refusal(slip)));
    varied
}

/// A slip as the command tells it, without a place to point at.
fn refusal(slip: Slip) -> Failure {
    let message = match slip.label.as_str() {
        "" => slip.message,
        label => format!("{}: {label}", slip.message),
    };
    Failure::input(slip.code, message, slip.help)
}
