//! Tables of a bridge's numbers, as other programs and spreadsheets have them, become bridge files.

use crate::stage::{Stage, number};

/// A bridge in the words and units of a limit analysis program.
const TABLE: &str = "Bridge name\tMill Lane\nArch shape\tSegmental\nClear span\t6000\tmm\nRise at crown\t1500\tmm\nArch ring thickness\t450\tmm\n\
    Bridge width\t5\tm\nDepth of fill at crown\t0,5\tm\nMasonry unit weight\t22\tkn/m3\nMasonry crushing strength\t5\tN/mm2\n\
    Coefficient of friction (radial)\t0.5774\t-\nBackfill unit weight\t18.639\tkN/m3\nAxle load\t100\tkN\nMortar loss\t20\tmm\nAssessor\tA. N. Other 3\n";

/// The table carries what the same numbers carry that are typed.
#[test]
fn a_table_carries_what_the_same_numbers_carry() {
    let stage = Stage::new("numbers-load");
    stage.write("numbers.txt", TABLE);
    let (answer, ending) = stage.object(&["convert", "numbers.txt", "bridge.toml"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert_eq!(answer["understood"].as_array().map(Vec::len), Some(12), "{answer}");
    let left = answer["not_understood"].as_array().expect("lines");
    assert_eq!(left.iter().map(|left| left["line"].as_u64()).collect::<Vec<_>>(), [Some(13), Some(14)], "{answer}");
    assert!(left[0]["help"].as_str().is_some_and(|help| help.contains("[[defect]]")), "{answer}");
    let told = answer["warnings"].to_string();
    assert!(
        told.contains("F135") && told.contains("kn/m3 is read as kN/m^3") && told.contains("tangent is 0.5774"),
        "{told}"
    );
    let typed = ["new", "typed", "--span", "6", "--rise", "1.5", "--ring", "0.45", "--width", "5", "--cover", "0.5"];
    stage.object(&[&typed[..], &["--density", "22 kN/m3", "--strength", "5 MPa", "--axle", "100 kN"]].concat());
    let load = |file: &str| {
        let (answer, ending) = stage.object(&["collapse", file, "--out", "out"]);
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
        number(&answer, "last_stable_load_kn")
    };
    let (table, typed) = (load("bridge.toml"), load("typed/bridge.toml"));
    // The coefficient 0.5774 is an angle of 30.00 degrees, 18.639 kN/m3 is 1900 kg/m3.
    assert!((table / typed - 1.0).abs() < 1e-9, "{table} kN by the table, {typed} kN typed");
}

/// All that keeps a file from being made is told at its line.
#[test]
fn a_table_that_makes_no_file_says_what_each_line_lacks() {
    let stage = Stage::new("numbers-slips");
    stage.write("numbers.csv", "name,value,unit\nSpan,6000,m\nRise,1.5,m\nRing depth,0.45,m\nWidth,\"1,200\",mm\n");
    let (answer, ending) = stage.object(&["convert", "numbers.csv", "bridge.toml"]);
    assert_eq!(ending.code, Some(2), "{answer}");
    let said = answer["errors"][0].to_string();
    for words in ["width is missing", "cover is missing", "line 5", "thousands", "write cover with its unit"] {
        assert!(said.contains(words), "{words} is not in {said}");
    }
    assert!(stage.names(".").iter().all(|name| !name.ends_with("bridge.toml")), "{:?}", stage.names("."));
    stage.write("numbers.csv", "Span,6000,m\nRise,1.5,m\nRing depth,0.45,m\nWidth,5,m\nCover,0.5,m\n");
    let said = stage.run(&["convert", "numbers.csv", "bridge.toml"]).stderr;
    assert!(said.contains("line 1 (Span)") && said.contains("beyond anything that a bridge can have"), "{said}");
    let drawn = stage.run(&["convert", "numbers.csv", "bridge.svg"]).stderr;
    assert!(drawn.contains("F118") && drawn.contains("bridge.toml"), "{drawn}");
}
