//! The bridge file of a survey sheet: every value that nobody gave has a remark.

use super::answers::{Answer, feet};
use std::fmt::Write;

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
    /// Code of a rule, and codes of vehicles; none for all of the rule.
    pub judged: Option<(String, Vec<String>)>,
    pub more: More,
}

/// What a sheet may say beyond the ten numbers.
pub(super) struct More {
    /// Number of the structure; empty where none is said.
    pub number: String,
    /// The word of a shape.
    pub profile: String,
    pub rings: usize,
    pub voussoirs: Option<usize>,
    pub skew: Option<Answer>,
    pub fill_density: Option<Answer>,
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
    let remark = if value.assumed.is_empty() { String::new() } else { format!("  # assumed: {}", value.assumed) };
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
    let more = &sheet.more;
    let mut page = format!(
        "# From a survey sheet. Lines with \"assumed\" are to be replaced by what is known of this bridge.\n\n[bridge]\nname = \"{}\"\n",
        literal(name)
    );
    line(&mut page, "width", &sheet.width);
    for [span, rise, thickness] in &sheet.spans {
        let _ = writeln!(page, "\n[[span]]\nprofile = \"{}\"", literal(&more.profile));
        line(&mut page, "span", span);
        line(&mut page, "rise", rise);
        if let Some(skew) = &more.skew {
            line(&mut page, "skew", skew);
        }
        let stones = arc(span.si, rise.si) / sheet.unit.si.max(1e-3);
        let counted = stones.round().clamp(5.0, MOST[0]) as usize;
        let remark = match more.voussoirs {
            Some(_) => "",
            None if sheet.unit.assumed.is_empty() => "",
            None => "  # assumed: stones of 0.30 m",
        };
        let voussoirs = more.voussoirs.unwrap_or(counted);
        if more.rings == 1 {
            line(&mut page, "thickness", thickness);
            let _ = writeln!(page, "voussoirs = {voussoirs}{remark}");
        }
        for _ in 0..if more.rings > 1 { more.rings } else { 0 } {
            page += "\n[[span.ring]]  # assumed: rings of one thickness\n";
            line(&mut page, "thickness", &thickness.share(more.rings));
            let _ = writeln!(page, "voussoirs = {voussoirs}{remark}");
        }
    }
    for [width, height] in &sheet.piers {
        page += "\n[[pier]]  # on ground that does not give\n";
        line(&mut page, "width", width);
        line(&mut page, "height", height);
        let courses = (height.si / 0.3).round().clamp(1.0, MOST[1]) as u64;
        let _ = writeln!(page, "courses = {courses}  # assumed: courses of 0.30 m");
    }
    if sheet.cover.si != 0.0 {
        page += "\n[[cover]]\nlayer = \"fill\"\n";
        line(&mut page, "thickness", &sheet.cover);
        match (&more.fill_density, &more.surfacing) {
            (Some(density), _) => line(&mut page, "density", density),
            (None, None) => page += "density = \"1900 kg/m^3\"  # assumed: fill and surfacing as one layer\n",
            (None, Some(_)) => page += "density = \"1900 kg/m^3\"  # assumed\n",
        }
    }
    if let Some([depth, density]) = more.surfacing.as_ref().filter(|[depth, _]| depth.si != 0.0) {
        page += "\n[[cover]]  # assumed: above the fill, whose depth was given without it\nlayer = \"surfacing\"\n";
        line(&mut page, "thickness", depth);
        line(&mut page, "density", density);
    }
    if sheet.backing.si != 0.0 {
        page += "\n[backing]  # height above the springings\n";
        line(&mut page, "height", &sheet.backing);
        match &more.backing_density {
            Some(density) => line(&mut page, "density", density),
            None => page += "density = \"2200 kg/m^3\"  # assumed\n",
        }
    }
    page += "\n[masonry]\n";
    line(&mut page, "density", &sheet.density);
    line(&mut page, "compressive_strength", &sheet.strength);
    page += "\n[joint]\n";
    match &more.friction {
        Some(angle) => line(&mut page, "friction_angle", angle),
        None => page += "friction_angle = \"30 deg\"  # assumed\n",
    }
    page += "cohesion = \"0 kPa\"  # assumed: mortar carries no tension\n";
    if more.rings > 1 {
        page += "\n[ring_joint]\n";
        line(&mut page, "friction_angle", &more.ring_friction);
        page += "cohesion = \"0 kPa\"  # assumed: rings may separate\n";
    }
    if let Some([angle, cohesion]) = &more.fill_friction {
        page += "\n[fill_pressure]\n";
        line(&mut page, "friction_angle", angle);
        line(&mut page, "cohesion", cohesion);
    }
    page += "\n\
             [dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n\n\
             [[load]]\nname = \"axle\"\nkind = \"axle\"\n";
    line(&mut page, "axle_force", &sheet.axle);
    // Lengths in the system of the span, so that nobody is asked about a mixture.
    let in_feet = sheet.spans.first().is_some_and(|[span, ..]| span.imperial());
    let length =
        |metres: f64, decimals: usize| if in_feet { feet(metres, 3) } else { format!("{metres:.decimals$} m") };
    let _ = writeln!(
        page,
        "contact_length = \"{}\"  # assumed\n\
         effective_width = \"{}\"  # assumed: a track of 1.8 m, spread 1:2 through the cover, not wider than the barrel\n\
         at = \"1/4 of span 1\"",
        length(0.3, 2),
        length((1.8 + sheet.cover.si.max(0.0)).min(sheet.width.si), 3)
    );
    if let Some((rule, vehicles)) = &sheet.judged {
        let _ = writeln!(page, "\n[sweep]\nrule = \"{rule}\"");
        let vehicles: Vec<String> = vehicles.iter().map(|code| format!("\"{code}\"")).collect();
        page += &match vehicles.is_empty() {
            true => "# every vehicle of the library that goes with the rule\n".to_owned(),
            false => format!("vehicles = [{}]\n", vehicles.join(", ")),
        };
    }
    if !more.number.is_empty() {
        let _ = writeln!(page, "\n[document]\nstructure_number = \"{}\"", literal(&more.number));
    }
    (page + "\n[analysis]\nmethod = \"limit\"\n", lines)
}

/// A text that may stand between quotation marks.
fn literal(text: &str) -> String {
    text.chars().filter(|c| !c.is_control() && *c != '"' && *c != '\\').take(80).collect()
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
