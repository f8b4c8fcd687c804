//! The bridge file of a survey sheet: every value that nobody gave has a remark.

use super::answers::{Answer, feet, plain};
use std::fmt::Write;

/// The line by which a file is known to be made from a survey.
pub(super) const HEAD: &str =
    "# From a survey sheet. Lines with \"assumed\" are to be replaced by what is known of this bridge.";
/// The line below it, where something was looked for and is not there.
pub(super) const NOT_THERE: &str = "# Looked for and not there: ";

/// What a sheet says, and what is assumed where it does not.
pub(super) struct Sheet {
    /// Clear span, rise and thickness of the ring of each span.
    pub spans: Vec<[Answer; 3]>,
    /// Width and height of each pier.
    pub piers: Vec<[Answer; 2]>,
    pub width: Answer,
    pub cover: Answer,
    pub unit: Answer,
    pub backing: Answer,
    pub density: Answer,
    pub strength: Answer,
    pub axle: Answer,
    pub barrel: Barrel,
    pub others: Others,
    /// Code of a rule, and codes of vehicles; none for all of the rule.
    pub judged: Option<(String, Vec<String>)>,
    /// What was looked for and is not there.
    pub nothing: Vec<&'static str>,
}

/// What all spans share.
pub(super) struct Barrel {
    pub rings: usize,
    /// Cohesion between rings.
    pub bond: Answer,
    pub skew: Option<Answer>,
    /// Depth of joints without mortar.
    pub lost_mortar: Answer,
    /// Code of a material of the library.
    pub fill: Option<String>,
    pub fill_density: Answer,
    /// Number of the structure.
    pub reference: Option<String>,
    /// What an inspection found, in words.
    pub condition: Option<String>,
}

/// What tables of other programs may say beyond that.
pub(super) struct Others {
    /// The word of a shape.
    pub profile: String,
    pub voussoirs: Option<usize>,
    /// Its depth and density.
    pub surfacing: Option<[Answer; 2]>,
    pub backing_density: Option<Answer>,
    pub friction: Option<Answer>,
    pub ring_friction: Answer,
    /// Angle of friction and cohesion.
    pub fill_friction: Option<[Answer; 2]>,
}

/// Most voussoirs of a ring, and most courses of a pier, that a file made here has.
const MOST: [f64; 2] = [400.0, 100.0];

/// A key with its value, and the remark of one that nobody gave.
fn line(page: &mut String, key: &str, value: &Answer) {
    let remark = match (&value.remark[..], &value.assumed[..]) {
        ("", "") => String::new(),
        ("", assumed) => format!("  # assumed: {assumed}"),
        (remark, _) => format!("  # {remark}"),
    };
    let _ = writeln!(page, "{key} = \"{}\"{remark}", value.text);
}

/// The answers that were written, each with the number of its line, from 0.
pub(super) type Lines = Vec<(usize, Answer)>;

/// The text of the file, and where its answers stand.
pub(super) fn written(name: &str, sheet: &Sheet) -> (String, Lines) {
    let mut lines = Lines::new();
    let mut line = |page: &mut String, key: &str, value: &Answer| {
        lines.push((page.lines().count(), value.clone()));
        line(page, key, value);
    };
    let (barrel, others) = (&sheet.barrel, &sheet.others);
    // Lengths in the system of the span, so that nobody is asked about a mixture.
    let in_feet = sheet.spans.first().is_some_and(|[span, ..]| span.imperial());
    let length =
        |metres: f64, decimals: usize| if in_feet { feet(metres, 3) } else { format!("{metres:.decimals$} m") };
    let assumed = if sheet.unit.assumed.is_empty() { "" } else { "assumed: " };
    let stone = &sheet.unit.text;
    let nothing =
        if sheet.nothing.is_empty() { String::new() } else { format!("{NOT_THERE}{}.\n", sheet.nothing.join(", ")) };
    let mut page = format!("{HEAD}\n{nothing}\n[bridge]\nname = \"{}\"\n", plain(name, 80));
    line(&mut page, "width", &sheet.width);
    for [span, rise, thickness] in &sheet.spans {
        let _ = writeln!(page, "\n[[span]]\nprofile = \"{}\"", others.profile);
        line(&mut page, "span", span);
        line(&mut page, "rise", rise);
        let stones = (arc(span.si, rise.si) / sheet.unit.si.max(1e-3)).round().clamp(5.0, MOST[0]) as u64;
        let voussoirs = match others.voussoirs {
            Some(count) => format!("voussoirs = {count}\n"),
            None => format!("voussoirs = {stones}  # {assumed}stones of {stone}\n"),
        };
        if barrel.rings == 1 {
            line(&mut page, "thickness", thickness);
            page += &voussoirs;
            continue;
        }
        for _ in 0..barrel.rings {
            page += "\n[[span.ring]]\n";
            let whole = if thickness.assumed.is_empty() { "" } else { "assumed: " };
            let as_first =
                if thickness.assumed.is_empty() { String::new() } else { format!(", {}", thickness.assumed) };
            let remark = format!("{whole}1/{} of {}{as_first}", barrel.rings, thickness.text);
            line(&mut page, "thickness", &Answer { text: thickness.over(barrel.rings), remark, ..thickness.clone() });
            page += &voussoirs;
        }
    }
    for [width, height] in &sheet.piers {
        page += "\n[[pier]]  # on ground that does not give\n";
        line(&mut page, "width", width);
        line(&mut page, "height", height);
        let courses = (height.si / 0.3).round().clamp(1.0, MOST[1]) as u64;
        let _ = writeln!(page, "courses = {courses}  # assumed: courses of {}", length(0.3, 2));
    }
    if sheet.cover.si != 0.0 {
        page += "\n[[cover]]\nlayer = \"fill\"\n";
        line(&mut page, "thickness", &sheet.cover);
        if let Some(code) = &barrel.fill {
            let _ = writeln!(page, "material = \"{code}\"  # of the library, not measured");
        }
        // A material has its own density, which nobody measured either.
        if barrel.fill.is_none() || barrel.fill_density.assumed.is_empty() {
            let assumed =
                if others.surfacing.is_some() { "the survey says nothing" } else { "fill and surfacing as one layer" };
            let assumed = if barrel.fill_density.assumed.is_empty() { "" } else { assumed };
            let density = Answer { assumed: assumed.to_owned(), ..barrel.fill_density.clone() };
            line(&mut page, "density", &density);
        }
    }
    if let Some([depth, density]) = others.surfacing.as_ref().filter(|[depth, _]| depth.si != 0.0) {
        page += "\n[[cover]]  # assumed: above the fill, whose depth was given without it\nlayer = \"surfacing\"\n";
        line(&mut page, "thickness", depth);
        line(&mut page, "density", density);
    }
    if sheet.backing.si != 0.0 {
        page += "\n[backing]  # height above the springings\n";
        line(&mut page, "height", &sheet.backing);
        match &others.backing_density {
            Some(density) => line(&mut page, "density", density),
            None => page += "density = \"2200 kg/m^3\"  # assumed\n",
        }
    }
    if barrel.lost_mortar.si != 0.0 {
        for k in 1..=sheet.spans.len() {
            let _ = writeln!(page, "\n[[defect]]\nkind = \"lost-mortar\"\nspan = {k}");
            line(&mut page, "depth", &barrel.lost_mortar);
        }
    }
    page += "\n[masonry]\n";
    line(&mut page, "density", &sheet.density);
    line(&mut page, "compressive_strength", &sheet.strength);
    page += "\n[joint]\n";
    match &others.friction {
        Some(angle) => line(&mut page, "friction_angle", angle),
        None => page += "friction_angle = \"30 deg\"  # assumed\n",
    }
    page += "cohesion = \"0 kPa\"  # assumed: mortar carries no tension\n";
    if barrel.rings > 1 {
        page += "\n[ring_joint]\n";
        line(&mut page, "friction_angle", &others.ring_friction);
        line(&mut page, "cohesion", &barrel.bond);
    }
    if let Some([angle, cohesion]) = &others.fill_friction {
        page += "\n[fill_pressure]\n";
        line(&mut page, "friction_angle", angle);
        line(&mut page, "cohesion", cohesion);
    }
    if let Some(skew) = &barrel.skew {
        page += "\n[carriageway]\n";
        line(&mut page, "skew", skew);
    }
    page += "\n[dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n\n\
             [[load]]\nname = \"axle\"\nkind = \"axle\"\n";
    line(&mut page, "axle_force", &sheet.axle);
    let _ = writeln!(
        page,
        "contact_length = \"{}\"  # assumed\n\
         effective_width = \"{}\"  # assumed: a track of {}, spread 1:2 through the cover, not wider than the barrel\n\
         at = \"1/4 of span 1\"",
        length(0.3, 2),
        length((1.8 + sheet.cover.si.max(0.0)).min(sheet.width.si), 3),
        length(1.8, 1)
    );
    if let Some((rule, vehicles)) = &sheet.judged {
        let _ = writeln!(page, "\n[sweep]\nrule = \"{rule}\"");
        let vehicles: Vec<String> = vehicles.iter().map(|code| format!("\"{code}\"")).collect();
        page += &match vehicles.is_empty() {
            true => "# every vehicle of the library that goes with the rule; vehicles = [\"…\"] asks for some alone, such as the grade of a line or road: extrados \
                     vehicles lists them\n"
                .to_owned(),
            false => format!("vehicles = [{}]\n", vehicles.join(", ")),
        };
    }
    if let Some(reference) = &barrel.reference {
        let _ = writeln!(page, "\n[document]\nstructure_number = \"{reference}\"");
    }
    if let Some(condition) = &barrel.condition {
        let _ = writeln!(page, "\n[[document.inspection]]\npart = \"barrel\"\nfinding = \"{condition}\"");
    }
    (page + "\n[analysis]\nmethod = \"limit\"\n", lines)
}

/// Length of a segmental arc [m].
pub(super) fn arc(span: f64, rise: f64) -> f64 {
    if !(span > 0.0 && rise > 0.0) {
        return span.abs();
    }
    let radius = 0.5 * (0.25 * span * span / rise + rise);
    let half = (0.5 * span / radius).min(1.0).asin();
    let half = if rise > radius { std::f64::consts::PI - half } else { half };
    2.0 * radius * half
}

#[cfg(test)]
mod tests {
    use super::arc;

    #[test]
    fn stones_are_counted_along_the_arc() {
        assert!((arc(2.0, 1.0) - std::f64::consts::PI).abs() < 1e-12);
        assert!((arc(10.0, 1e-6) - 10.0).abs() < 1e-6);
    }
}
