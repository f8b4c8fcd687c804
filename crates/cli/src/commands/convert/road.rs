//! A road or rail profile of a LandXML file becomes the `[road]` of a bridge file.

use super::{Report, folder, guard};
use crate::args::Convert;
use crate::commands::source::read_file;
use crate::desk::Desk;
use crate::failure;
use crate::quantities;
use crate::status::Status;
use drawing::landxml::{RoadLine, road_lines};
use extrados::Refusal;
use extrados::files::LONGEST;
use findings::words::counted;
use std::fmt::Write;

/// How far the surface is written to the left and to the right of the left springing [m].
const REACH: [f64; 2] = [-100.0, 900.0];

/// Reads the profiles and writes the one that was asked for.
pub(super) fn run(desk: &mut Desk, arguments: &Convert) -> Result<Report, Refusal> {
    let from = arguments.from.display().to_string();
    if arguments.unit.is_some() || arguments.gap_tolerance.is_some() || arguments.cut_concave {
        let message =
            "--unit, --gap-tolerance and --cut-concave are not for road profiles, which have their unit in the file";
        return Err(Refusal::new("F107", message, "leave them out"));
    }
    let tolerance = match &arguments.chord_tolerance {
        Some(text) => quantities::length("--chord-tolerance", text)?,
        None => drawing::Options::default().chord_tolerance,
    };
    let bytes = bridge::as_utf8(read_file(&arguments.from, LONGEST)?);
    let found = road_lines(&String::from_utf8_lossy(&bytes), tolerance).map_err(|error| {
        Refusal::new("F137", format!("{from}: {error}"), "export the alignment with its profile as LandXML 1.0 to 2.0")
    })?;
    let line = chosen(&from, &found, arguments.profile.as_deref())?;
    let Some(station) = &arguments.station else {
        let message = format!("{from}: where on the profile the bridge stands is not said; it has {}", listed(&[line]));
        return Err(Refusal::new(
            "F137",
            message,
            "write --station \"1234.5 m\": the station of the left springing of the first span",
        ));
    };
    let station = quantities::place("--station", station)?;
    let ends = [line.points[0][0], line.points[line.points.len() - 1][0]];
    if !(ends[0]..=ends[1]).contains(&station) {
        let message = format!("{from}: the station {station} m lies beside the profile, {}", listed(&[line]));
        return Err(Refusal::new("F137", message, "write a --station on it; stations are counted in metres here"));
    }
    let springing =
        arguments.springing_level.as_ref().map(|text| quantities::place("--springing-level", text)).transpose()?;
    let levels = around(line, station);
    let text = table(&from, line, station, springing, &levels);
    guard(arguments, &[&arguments.from])?;
    folder::write_whole(&arguments.to, text.as_bytes()).map_err(|error| failure::unwritable(&arguments.to, &error))?;
    let mut report = Report::new(Status::Completed);
    if levels.first().is_some_and(|first| first[0] > -1.0) {
        let message = format!(
            "{from}: the profile begins {:.2} m before the springing; the road is level beyond its ends",
            -levels[0][0]
        );
        report.warn(&mut desk.screen, "F137", &message);
    }
    let shown = arguments.to.display().to_string();
    let level = line.level(station);
    let mut summary = format!(
        "{from}: {}, {}, {}\n\n  level at station {station} m  {:.3} m\n",
        line.title(),
        counted(line.points.len(), "point"),
        counted(line.curves, "vertical curve"),
        level.unwrap_or_default()
    );
    let _ = writeln!(summary, "\nwritten to {shown}: paste it into the bridge file");
    if springing.is_none() {
        summary += "fill in springing_level, the level of the left springing in the same datum, first\n";
    }
    Ok(report
        .with("profile", line.title())
        .with("level_m", level)
        .with("points", levels.len())
        .with("written", shown)
        .saying(summary))
}

/// The only profile, or the one of this name.
fn chosen<'a>(from: &str, found: &'a [RoadLine], name: Option<&str>) -> Result<&'a RoadLine, Refusal> {
    let of_name =
        |line: &&RoadLine| name.is_none_or(|name| [line.name.as_str(), &line.alignment, &line.title()].contains(&name));
    let fitting: Vec<&RoadLine> = found.iter().filter(of_name).collect();
    match (&fitting[..], name) {
        ([one], _) => Ok(one),
        ([], _) => {
            let all: Vec<&RoadLine> = found.iter().collect();
            let message = format!("{from} has no profile called {}; it has {}", name.unwrap_or_default(), listed(&all));
            Err(Refusal::new("F137", message, format!("write --profile \"{}\"", all[0].title())))
        }
        _ => {
            let message = format!("{from} has several profiles: {}", listed(&fitting));
            Err(Refusal::new("F137", message, format!("say which one: --profile \"{}\"", fitting[0].title())))
        }
    }
}

/// Profiles with their stations.
fn listed(lines: &[&RoadLine]) -> String {
    let one = |line: &&RoadLine| {
        let ends = [line.points[0][0], line.points[line.points.len() - 1][0]];
        format!("\"{}\" from station {:.3} to {:.3} m", line.title(), ends[0], ends[1])
    };
    lines.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// Distances from the springing and levels within reach [m].
fn around(line: &RoadLine, station: f64) -> Vec<[f64; 2]> {
    let [from, to] = REACH.map(|reach| station + reach);
    let end = |at: f64| line.level(at).map(|level| [at, level]);
    let inside = line.points.iter().copied().filter(|point| from < point[0] && point[0] < to);
    end(from).into_iter().chain(inside).chain(end(to)).map(|[at, level]| [at - station, level]).collect()
}

/// The table of the bridge file, to a tenth of a millimetre.
fn table(from: &str, line: &RoadLine, station: f64, springing: Option<f64>, levels: &[[f64; 2]]) -> String {
    let plain = |text: &str| text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect::<String>();
    let mut text = format!(
        "# [road] of a bridge file, from {}: profile {}.\n# Distances from station {station} m, where the left springing of the first span stands; level beyond the ends.\n\
         [road]\nlevels = [\n",
        plain(from),
        plain(&line.title())
    );
    let rounded = |value: f64| (1e4 * value).round() / 1e4 + 0.0;
    for [at, level] in levels {
        let _ = writeln!(text, "  [\"{} m\", \"{} m\"],", rounded(*at), rounded(*level));
    }
    text += "]\n";
    match springing {
        Some(level) => text += &format!("springing_level = \"{level} m\"\n"),
        None => text += "springing_level = \"TO FILL IN m\"  # of the left springing, in the same datum\n",
    }
    text
}
