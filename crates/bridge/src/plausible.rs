//! Physical sense: values that are possible but so unusual that they are worth a question, and values that nothing on a bridge can have.

use crate::card::Kind;
use crate::fields::structure::PlacedSpan;
use crate::findings::Findings;
use crate::mixed_units;
use crate::model::{Joint, JointStiffness, Masonry};
use crate::quantity;
use crate::tree::{At, Raw, Table};
use crate::usual::{USUAL, Usual};

/// Reports what is unusual, as far as the file could be read.
pub(crate) fn check(
    file: &Table<'_>,
    spans: Option<&[PlacedSpan]>,
    masonry: Option<&Masonry>,
    joint: Option<&Joint>,
    findings: &mut Findings,
) {
    for usual in USUAL {
        for table in usual.sections.iter().flat_map(|section| every(file, section)) {
            unusual(&table, usual, findings);
        }
    }
    mixed_units::check(file, findings);
    strength(file, masonry, findings);
    fill(file, masonry, findings);
    joints(file, spans, masonry, joint, findings);
    rings(file, spans.unwrap_or_default(), masonry, findings);
    few_voussoirs(file, spans.unwrap_or_default(), findings);
    piers(file, findings);
    settings(file, findings);
    axles(file, findings);
    effective_width(file, findings);
    whole_width(file, findings);
    deep_cover(file, findings);
}

/// The tables of a section, one or many; their mistakes have been reported already.
fn every<'t>(file: &Table<'t>, section: &str) -> Vec<Table<'t>> {
    match file.section.field(section).map(|field| field.kind) {
        Some(Kind::Table(_)) => file.known(section).into_iter().collect(),
        Some(Kind::Tables(_)) => file.tables(section, &mut Findings::default()),
        _ => Vec::new(),
    }
}

/// A value that was read without a mistake [SI].
fn value(table: &Table<'_>, key: &str) -> Option<f64> {
    let written = table.read::<f64>(key, &mut Findings::default()).filter(|_| table.has(key));
    written.filter(|value| value.is_finite())
}

fn unusual(table: &Table<'_>, usual: &Usual, findings: &mut Findings) {
    let Some(value) = value(table, usual.key) else { return };
    if (usual.least..=usual.most).contains(&value) {
        return;
    }
    let help = table.entry(usual.key).and_then(|(_, raw)| other_unit(raw, usual.least, usual.most));
    if !(usual.possible[0]..=usual.possible[1]).contains(&value) {
        findings.error(
            "B107",
            table.place(usual.key),
            format!("`{}` in {} is impossible", usual.key, table.title()),
            usual.says,
            help.unwrap_or_else(|| "check number and unit".to_owned()),
        );
        return;
    }
    findings.warning(
        usual.code,
        table.place(usual.key),
        format!("`{}` in {} is unusual", usual.key, table.title()),
        usual.says,
        help.unwrap_or_else(|| "check number and unit; leave it if the survey says so".to_owned()),
    );
}

/// The same number with another unit, if that makes sense of it.
fn other_unit(raw: Raw<'_>, least: f64, most: f64) -> Option<String> {
    let found = quantity::parse(raw.get_ref().as_str()?).ok()?;
    let same_system = found.unit.dimension.units().filter(|unit| unit.imperial() == found.unit.imperial());
    let mut sensible = same_system.filter(|unit| (least..=most).contains(&(found.number * unit.size)));
    // Weights as forces are rarely meant where they are not written.
    let rare = |unit: &quantity::Unit| ["kgf", "t/m"].iter().any(|word| unit.symbol.contains(word));
    let leap = |unit: &quantity::Unit| (unit.size / found.unit.size).ln().abs();
    let unit = sensible.by_ref().min_by(|a, b| (rare(a).cmp(&rare(b))).then(leap(a).total_cmp(&leap(b))))?;
    Some(format!("did you mean \"{} {}\"?", found.number, unit.symbol))
}

/// No strength: crushing is left out, which must not happen silently.
fn strength(file: &Table<'_>, masonry: Option<&Masonry>, findings: &mut Findings) {
    for table in every(file, "masonry") {
        if masonry.is_some() && !table.has("compressive_strength") {
            findings
                .warning(
                    "P010",
                    table.range,
                    "the masonry has no compressive strength: crushing is not considered",
                    "`compressive_strength` is missing here",
                    "write compressive_strength from tests of this masonry, or compressive_strength = \"unlimited\" to leave crushing out; \
                     masonry usually crushes at 0.5 to 400 MPa",
                )
                .because("hinges that crush carry less; flat and thick rings most of all");
        }
    }
}

/// A fill stiffer than the masonry it lies on.
fn fill(file: &Table<'_>, masonry: Option<&Masonry>, findings: &mut Findings) {
    let Some(modulus) = masonry.and_then(|masonry| masonry.elastic_modulus) else { return };
    let masonry_place = file.place_in("masonry", "elastic_modulus");
    let soils = ["fill", "haunch_fill", "abutment_fill"].into_iter().flat_map(|key| every(file, key));
    for table in every(file, "cover").into_iter().chain(soils) {
        if !value(&table, "elastic_modulus").is_some_and(|layer| layer > modulus) {
            continue;
        }
        let what = if table.section.path == "cover" { "a layer of the cover" } else { "the fill" };
        let help =
            table.entry("elastic_modulus").and_then(|(_, raw)| other_unit(raw, 5e6, 1e9_f64.min(0.999 * modulus)));
        let note = format!("ring masonry is {} GPa (line {})", modulus / 1e9, findings.line(masonry_place));
        findings
            .warning(
                "P012",
                table.place("elastic_modulus"),
                format!("{what} is stiffer than the masonry on which it lies"),
                "granular fills are usually 20 to 200 MPa",
                help.unwrap_or_else(|| "check number and unit".to_owned()),
            )
            .because(note);
    }
}

/// Stiffness, modulus and length are written with three digits or more: together they may be rounded by this share.
const ROUNDED: f64 = 0.015;

/// Joints: stiffer than the blocks, stiffer in shear than in compression, tension beyond what friction allows.
fn joints(
    file: &Table<'_>,
    spans: Option<&[PlacedSpan]>,
    masonry: Option<&Masonry>,
    joint: Option<&Joint>,
    findings: &mut Findings,
) {
    let Some(joint) = joint else { return };
    let Some(table) = every(file, "joint").into_iter().next() else { return };
    let modulus = masonry.and_then(|masonry| masonry.elastic_modulus);
    if let (Some(JointStiffness::Contact(normal)), Some(modulus), Some(spans)) =
        (joint.normal_stiffness, modulus, spans)
        && let Some(length) = longest_voussoir(spans)
        && normal > modulus / length * (1.0 + ROUNDED)
    {
        findings
            .warning(
                "P013",
                table.place("normal_stiffness"),
                "the contact is stiffer than the blocks alone",
                format!("blocks of {length:.3} m alone give {:.4} GPa/m", modulus / length / 1e9),
                "if this is the stiffness of the mortar joint, call it `mortar_normal_stiffness`",
            )
            .because("1/k = 1/k' + l/E: joint and blocks in series give less than either (Rouxinol, Providência and Lemos, eq. 1)");
    }
    let stiffer_in_shear = match (joint.normal_stiffness, joint.shear_stiffness) {
        (Some(JointStiffness::Contact(normal)), Some(JointStiffness::Contact(shear))) => shear > normal,
        (Some(JointStiffness::Series(normal)), Some(JointStiffness::Series(shear))) => shear > normal,
        _ => false,
    };
    if stiffer_in_shear {
        let key = if table.has("shear_stiffness") { "shear_stiffness" } else { "mortar_shear_stiffness" };
        findings.warning(
            "P014",
            table.place(key),
            "the joint is stiffer in shear than in compression",
            "usually a tenth to a half of the normal stiffness",
            "check whether the two stiffnesses are swapped",
        );
    }
    let apex = joint.cohesion / joint.friction_angle.tan();
    if joint.tensile_strength > 0.0 && joint.tensile_strength > apex * (1.0 + 1e-9) {
        findings.warning(
            "P015",
            table.place("tensile_strength"),
            "the tensile strength lies beyond the friction cone",
            format!("cohesion over the tangent of friction is {:.4} MPa", apex / 1e6),
            "give a tensile strength of at most cohesion / tan(friction_angle)",
        );
    }
}

/// The longest voussoir of the bridge at the intrados [m].
fn longest_voussoir(spans: &[PlacedSpan]) -> Option<f64> {
    let lengths = spans.iter().filter_map(|placed| {
        let intrados = placed.span.intrados().ok()?;
        let fewest = placed.span.rings.iter().map(|ring| ring.voussoirs).min()?;
        Some(intrados.length() / fewest as f64)
    });
    lengths.reduce(f64::max)
}

/// The spans as they are described: of those that are repeated the first one.
fn described(spans: &[PlacedSpan]) -> impl Iterator<Item = &PlacedSpan> {
    let first =
        |(index, placed): &(usize, &PlacedSpan)| spans[..*index].iter().all(|other| other.shape != placed.shape);
    spans.iter().enumerate().filter(first).map(|(_, placed)| placed)
}

/// Rings much thinner or thicker than were ever built, flat spans, corners rounded to pebbles.
fn rings(file: &Table<'_>, spans: &[PlacedSpan], masonry: Option<&Masonry>, findings: &mut Findings) {
    for placed in described(spans) {
        let span = &placed.span;
        let Some((thickness_place, _)) = placed.rings.first() else { continue };
        let total: f64 = span.rings.iter().map(|ring| ring.crown_thickness).sum();
        if !(1.0 / 70.0..=0.25).contains(&(total / span.span)) {
            findings.warning(
                "P016",
                *thickness_place,
                "the thickness of the rings is unusual for this span",
                format!("1/{:.0} of the span", span.span / total),
                "rings are usually 1/10 to 1/40 of the span; check number and unit",
            );
        }
        if span.rise < 0.05 * span.span {
            findings.warning(
                "P017",
                placed.shape,
                "the arch is unusually flat",
                format!("the rise is 1/{:.0} of the span", span.span / span.rise),
                "rises are usually 1/2 to 1/12 of the span; check both",
            );
        }
        let thinnest = span
            .rings
            .iter()
            .map(|ring| ring.crown_thickness.min(ring.springing_thickness))
            .fold(f64::INFINITY, f64::min);
        if let Some(masonry) = masonry
            && masonry.rounding > 0.1 * thinnest
        {
            findings.warning(
                "P011",
                file.place_in("masonry", "rounding"),
                "corners are rounded by more than a tenth of the thickness",
                format!("the thinnest ring has {thinnest} m"),
                "give a smaller `rounding` in [masonry]; a hundredth to a fiftieth of the thickness is common",
            );
        }
    }
}

/// Rings of so few voussoirs that hinges have nowhere to form, and joints between rings where there is one.
fn few_voussoirs(file: &Table<'_>, spans: &[PlacedSpan], findings: &mut Findings) {
    for placed in described(spans) {
        let fewest = placed.span.rings.iter().map(|ring| ring.voussoirs).min();
        if let (Some(fewest), Some((place, _))) = (fewest.filter(|fewest| *fewest < FEW), placed.rings.first()) {
            findings
                .warning(
                    "P026",
                    *place,
                    format!("a ring of {fewest} voussoirs has too few joints for hinges"),
                    "four hinges and two springings need at least seven",
                    "give the true number of voussoirs; for a ring of brick 20 and more are enough",
                )
                .because("an arch with fewer joints than the real one is too strong: possible mechanisms are left out");
        }
    }
    if !spans.is_empty() && spans.iter().all(|placed| placed.span.rings.len() == 1) {
        for table in every(file, "ring_joint") {
            findings.warning(
                "P027",
                table.range,
                "joints between rings are described, and every span has one ring",
                "[ring_joint] has no effect",
                "describe the rings of a span in [[span.ring]], or remove [ring_joint]",
            );
        }
    }
}

/// Fewest voussoirs that are taken without a word: with six there is one joint for each of four hinges between two springings.
const FEW: usize = 7;

/// Piers that taper upwards, or are slender as masts.
fn piers(file: &Table<'_>, findings: &mut Findings) {
    for table in every(file, "pier") {
        let (width, base, height) = (value(&table, "width"), value(&table, "base_width"), value(&table, "height"));
        if let (Some(width), Some(base)) = (width, base)
            && base < width
        {
            findings.warning(
                "P018",
                table.place("base_width"),
                "the pier is narrower at its foot than at its top",
                format!("{width} m at the top"),
                "check whether the two widths are swapped",
            );
        }
        if let (Some(width), Some(height)) = (width, height)
            && height > 15.0 * width
        {
            findings.warning(
                "P019",
                table.place("height"),
                "the pier is unusually slender",
                format!("{:.0} times its width", height / width),
                "piers are usually 1 to 12 times as high as wide; check number and unit",
            );
        }
    }
}

/// Numbers of the plan that are allowed but seldom wise.
fn settings(file: &Table<'_>, findings: &mut Findings) {
    for table in every(file, "analysis") {
        if value(&table, "tolerance").is_some_and(|tolerance| tolerance > 1e-3) {
            findings.warning(
                "P020",
                table.place("tolerance"),
                "the tolerance is loose: a bridge that is collapsing may be taken for one at rest",
                "out-of-balance force over acting forces",
                "write 1e-4 or less, and check that a tenth of it changes no load step",
            );
        }
    }
    for table in every(file, "dispersal") {
        let slope = value(&table, "slope");
        if let Some(slope) = slope.filter(|slope| (0.5..1.0).contains(slope)) {
            findings
                .warning(
                    "P025",
                    table.place("slope"),
                    "the load spreads further to the side than it goes down",
                    format!("by {:.2} of the depth on each side", 1.0 / slope),
                    "vertical comes first: write \"2:1\" for one to the side in two of depth, as British practice writes 1:2 or 1H:2V",
                )
                .because("a slope upside down spreads a load over four times the length, and may give several times the collapse load");
        }
        if slope.is_some_and(|slope| !(0.5..=4.0).contains(&slope)) {
            findings.warning(
                "P021",
                table.place("slope"),
                "the slope of the dispersal is unusual",
                "vertical to horizontal",
                "2:1 is common for soil, 4:1 for ballast, 1:1 for concrete; check whether the numbers are swapped",
            );
        }
    }
}

/// Axle loads as no rail and no road has seen them.
fn axles(file: &Table<'_>, findings: &mut Findings) {
    const RAILS: [(&str, f64, f64, &str); 2] = [
        ("axle_loads", 1e3, 45e3, "axles usually carry 1 to 45 t"),
        ("axle_forces", 10e3, 450e3, "axles usually carry 10 to 450 kN"),
    ];
    const ROADS: [(&str, f64, f64, &str); 2] = [
        ("axle_loads", 0.4e3, 25e3, "axles on roads usually carry 0.4 to 25 t"),
        ("axle_forces", 4e3, 250e3, "axles on roads usually carry 4 to 250 kN"),
    ];
    let mut unheard = Findings::default();
    let train = file.known("train").map_or_else(Vec::new, |train| train.tables("vehicle", &mut unheard));
    let on_rails = train.into_iter().map(|table| (table, RAILS));
    for (table, usual) in on_rails.chain(file.known("vehicle").map(|table| (table, ROADS))) {
        for (key, least, most, says) in usual {
            let Some(Some(loads)) = table.read::<Option<At<Vec<f64>>>>(key, &mut unheard) else { continue };
            if loads.value.iter().any(|load| !(least..=most).contains(load)) {
                findings.warning(
                    "P051",
                    loads.range,
                    format!("an axle load of {} is unusual", table.title()),
                    says,
                    "check number and unit; this is the load of an axle, not of the vehicle",
                );
            }
        }
    }
}

/// An axle spreads over its sleepers before anything else.
fn effective_width(file: &Table<'_>, findings: &mut Findings) {
    for table in every(file, "track") {
        let (width, sleeper) = (value(&table, "effective_width"), value(&table, "sleeper_length"));
        if let (Some(width), Some(sleeper)) = (width, sleeper)
            && width < sleeper
        {
            findings.warning(
                "P054",
                table.place("effective_width"),
                "the effective width of an axle is less than the length of its sleepers",
                format!("sleepers are {sleeper} m long"),
                "leave it out for the width of the barrel, or give the width reached at the depth of the ring",
            );
        }
    }
}

/// Between the wheels of an axle [m], and what it spreads beyond them at the surface (CS 454, 7.3).
const TRACK: f64 = 1.8;
const BEYOND: f64 = 1.5;

/// Deepest cover over the crown that is common [m]: below it loads spread until hardly any are left.
const DEEP: f64 = 3.0;

/// Cover so deep that loads hardly matter.
fn deep_cover(file: &Table<'_>, findings: &mut Findings) {
    let layers = every(file, "cover");
    let depth: f64 = layers.iter().filter_map(|table| value(table, "thickness")).sum();
    if let Some(last) = layers.last().filter(|_| depth > DEEP) {
        findings.warning(
            "P034",
            last.place("thickness"),
            format!("{depth:.2} m of cover lie over the crown"),
            format!("arches usually have less than {DEEP} m, and through more loads spread until hardly any are left"),
            "check numbers and units",
        );
    }
}

/// A force given for the whole width, where an axle spreads over less of it: in an assessment, where it stands for an axle.
fn whole_width(file: &Table<'_>, findings: &mut Findings) {
    let width = every(file, "bridge").first().and_then(|table| value(table, "width"));
    let Some(width) = width.filter(|_| file.has("assess")) else { return };
    let depth: f64 = every(file, "cover").iter().filter_map(|table| value(table, "thickness")).sum();
    let spread = TRACK + BEYOND + depth;
    for table in every(file, "load") {
        if value(&table, "effective_width").is_some_and(|carries| carries > spread) {
            findings
                .warning(
                    "P032",
                    table.place("effective_width"),
                    "an axle is shared out over more width than it spreads over",
                    format!(
                        "{TRACK} m between wheels + {BEYOND} m + {depth:.2} m of cover = {spread:.2} m (CS 454, 7.3)"
                    ),
                    "write the width that carries it, at most as wide",
                )
                .because("the load on a metre of the barrel decides; shared out over more width it is too small");
        }
        let Some((_, raw)) = table.entry("force") else { continue };
        let written = raw.get_ref().as_str().and_then(|text| quantity::parse(text).ok());
        let whole = written.is_some_and(|quantity| quantity.unit.dimension == quantity::Dimension::Force);
        if whole && width > spread {
            findings
                .warning(
                    "P032",
                    table.place("force"),
                    "the force is shared out over more width than an axle spreads over",
                    format!("{width} m here; {TRACK} m between wheels + {BEYOND} m + {depth:.2} m of cover = {spread:.2} m (CS 454, 7.3)"),
                    "write kind = \"axle\" with effective_width, or the force per metre of the width that carries it, as \"25 kN/m\"",
                )
                .because("the load on a metre of the barrel decides; shared out over the whole width it is too small");
        }
    }
}
