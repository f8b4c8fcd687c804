//! Cards of errors in text, keys and quantities.

use super::FileCard;

/// The cards, in the order of their codes.
pub(super) const CARDS: &[FileCard] = &[
    FileCard {
        code: "B001",
        title: "the file is not UTF-8 text",
        meaning: "Every byte of the file must belong to UTF-8 text.",
        why: "Some editors save text in other encodings; a degree sign or an accent then turns into another character.",
        wrong: r#"name = "Pont de Pal\xe9"   # saved as Latin-1"#,
        right: r#"name = "Pont de Palé"      # saved as UTF-8"#,
        source: "TOML 1.1, Spec",
    },
    FileCard {
        code: "B002",
        title: "a line is not TOML",
        meaning: "The file is read as TOML: [section] headers and key = value lines.",
        why: "The content of such a line is unknown. The rest of the file is still read, but nothing is reported as \
              missing.",
        wrong: "width = 8.30 m",
        right: r#"width = "8.30 m""#,
        source: "TOML 1.1",
    },
    FileCard {
        code: "B003",
        title: "the file is too long",
        meaning: "A bridge file has a few kilobytes; a file of more than a megabyte is not a bridge file.",
        why: "Reading must end quickly, even if a wrong file was named by mistake.",
        wrong: "extrados check photograph.jpg",
        right: "extrados check bridge.toml",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B010",
        title: "unknown key",
        meaning: "Every key must be one that the section knows. The nearest known key is named.",
        why: "If a misspelt key were ignored, its value would be left out without notice.",
        wrong: r#"friction_angel = "35.6 deg""#,
        right: r#"friction_angle = "35.6 deg""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B011",
        title: "something is missing",
        meaning: "A section lacks a required key, or the file lacks a required section.",
        why: "The properties of the bridge are never assumed; only numerical settings have defaults.",
        wrong: r#"[masonry]
"#,
        right: r#"[masonry]
density = "2100 kg/m^3"
"#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B012",
        title: "wrong type of value",
        meaning: "A key takes one type of value: text, a number, a list, a table.",
        why: "The meaning of a value of another type would be a guess.",
        wrong: r#"poisson_ratio = "0.2""#,
        right: "poisson_ratio = 0.2",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B013",
        title: "unknown word",
        meaning: "Some keys take one of a few words. The nearest is named, and all are listed.",
        why: "An unknown word has no meaning for the program.",
        wrong: r#"profile = "segmentel""#,
        right: r#"profile = "segmental""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B015",
        title: "a key without effect here",
        meaning: "Some keys apply only to one choice of another key: `haunch_radius` applies only to a three-centred \
                  profile.",
        why: "A value that is ignored may have been meant to act.",
        wrong: r#"rule = "none"
slope = "2:1""#,
        right: r#"rule = "inverse-depth"
slope = "2:1""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B016",
        title: "two keys that exclude one another",
        meaning: "Some quantities can be given in two ways; a file must use only one of them.",
        why: "Two statements may contradict one another.",
        wrong: r#"thickness = "0.711 m"
crown_thickness = "0.60 m""#,
        right: r#"thickness = "0.711 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B101",
        title: "a number without a unit where a quantity is expected",
        meaning: "A value that has a dimension is written with its unit, in quotes.",
        why: "Errors of unit are the costliest of all. The fill of a published model of Bridgemill has 40 GPa in the \
              text and 0.040 GPa in the table.",
        wrong: "rise = 2.85",
        right: r#"rise = "2.85 m""#,
        source: "Rouxinol, Providência and Lemos, section 3.1 and Table 1",
    },
    FileCard {
        code: "B102",
        title: "a quantity without unit",
        meaning: "There is a number in quotes, but no unit after it.",
        why: "As for B101.",
        wrong: r#"rise = "2.85""#,
        right: r#"rise = "2.85 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B103",
        title: "unknown unit",
        meaning: "The program does not know this unit. Capitals matter: MPa is a million pascals, mPa would be a \
                  thousandth of one.",
        why: "A guess at a unit can be wrong by powers of ten.",
        wrong: r#"elastic_modulus = "15 gpa""#,
        right: r#"elastic_modulus = "15 GPa""#,
        source: "BIPM, The International System of Units, chapter 3",
    },
    FileCard {
        code: "B104",
        title: "wrong dimension",
        meaning: "The unit has another dimension: a pressure where a length is expected. A weight per volume (kN/m^3) is read \
                  as a density, and a mass (t) where a force is asked for as its weight, with gravity at 9.81 m/s^2.",
        why: "The number is then almost certainly wrong.",
        wrong: r#"rise = "2.85 GPa""#,
        right: r#"rise = "2.85 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B105",
        title: "not a number",
        meaning: "A quantity starts with a number with a decimal point.",
        why: "A decimal comma may also be a separator of thousands.",
        wrong: r#"span = "18,30 m""#,
        right: r#"span = "18.30 m""#,
        source: "BIPM, The International System of Units, 5.4.4",
    },
    FileCard {
        code: "B106",
        title: "a number too large or too small for any bridge",
        meaning: "The number is infinite, zero where it must not be, or larger than any value of a bridge.",
        why: "Such a number is a typing error, and calculations with it overflow.",
        wrong: r#"span = "1e300 m""#,
        right: r#"span = "18.30 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B107",
        title: "a number outside its possible range",
        meaning: "Lengths, densities and stiffnesses are positive, Poisson's ratio lies between 0 and 0.5, a friction angle below 90 degrees.",
        why: "No material or shape has a value outside the range.",
        wrong: r#"rise = "-2.85 m""#,
        right: r#"rise = "2.85 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B108",
        title: "an impossible count",
        meaning: "Numbers of voussoirs, courses or iterations are whole, positive and not too large.",
        why: "A thousand million voussoirs would be as small as grains of sand and would not fit in memory.",
        wrong: "voussoirs = 1_000_000_000",
        right: "voussoirs = 62",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B109",
        title: "an unreadable slope or share",
        meaning: r#"A slope is written "2:1", vertical to horizontal; a position on a span "1/4 of span 1", "30% of span 2" or "crown of span 1"."#,
        why: "A slope read upside down spreads a load four times as far.",
        wrong: r#"slope = "63 deg""#,
        right: r#"slope = "2:1""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B110",
        title: "a text that is too long",
        meaning: "A name has 200 characters at most, any other text 2000. The message gives both numbers.",
        why: "Names stand in titles, tables and drawings, which have no room for more.",
        wrong: r#"name = "Bridge 12, which was built in … and since then …""#,
        right: r#"name = "Bridge 12""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B111",
        title: "a character that cannot be seen",
        meaning: "Texts hold no control characters, and none that turn the direction of reading (U+202A to U+202E, U+2066 to U+2069). \
                  Ends of lines and tabs become spaces.",
        why: "A terminal obeys such characters, and they can make a name look like another word. They often come along when text is \
              copied from a page.",
        wrong: r#"name = "Mill \u001b[2JLane""#,
        right: r#"name = "Mill Lane""#,
        source: "Unicode Standard Annex 9; the format of bridge files",
    },
    FileCard {
        code: "B112",
        title: "a list that is too long",
        meaning: "Lists have a most: 50 layers of cover, 20 rings in a span, 200 loads, 200 cases, 10,000 points of a line. The message gives both numbers.",
        why: "Each entry is drawn and listed; a longer list is a slip, or a task for several files.",
        wrong: "2000 [[load]] tables",
        right: r#"kind = "axles" for the axles of one vehicle"#,
        source: "the format of bridge files",
    },
];
