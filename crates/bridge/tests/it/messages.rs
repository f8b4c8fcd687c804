//! What the engineer sees.

use bridge::read;

use crate::files::{CASE_1, TINY, VIADUCT, show_all};

#[test]
fn a_pressure_where_a_length_belongs() {
    let file = CASE_1.replace("rise = \"2.85 m\"", "rise = \"2.85 GPa\"");
    assert_eq!(
        show_all(&file),
        "error[B104]: expected a length, found a pressure\n  \
           8:8\n  \
           | rise = \"2.85 GPa\"\n  \
           |        ^^^^^^^^^^ rise is measured from springing to crown, on the intrados\n  \
           help: write \"2.85 m\", if m is meant\n\n"
    );
}

#[test]
fn a_fill_stiffer_than_masonry() {
    let file = VIADUCT.replace("elastic_modulus = \"60 MPa\"", "elastic_modulus = \"60 GPa\"");
    assert_eq!(
        show_all(&file),
        "warning[P012]: a layer of the cover is stiffer than the masonry on which it lies\n  \
           73:19\n  \
           | elastic_modulus = \"60 GPa\"\n  \
           |                   ^^^^^^^^ granular fills are usually 20 to 200 MPa\n  \
           note: ring masonry is 10 GPa (line 48)\n  \
           help: did you mean \"60 MPa\"?\n\n"
    );
    assert!(read(file.as_bytes()).bridge.is_some(), "a warning is no refusal");
}

/// Ten mistakes deserve ten carets.
#[test]
fn ten_mistakes_are_reported_at_once() {
    let mistakes = [
        ("width = \"8.30 m\"", "width = 8.30", "B101"),
        ("profile = \"segmental\"", "profile = \"segment\"", "B013"),
        ("thickness = \"0.711 m\"", "thicknes = \"0.711 m\"", "B010"),
        ("voussoirs = 62", "voussoirs = 1000000000", "B108"),
        ("density = \"2100 kg/m^3\"", "density = \"21 kN/m^2\"", "B104"),
        ("poisson_ratio = 0.2", "poisson_ratio = 2.0", "B107"),
        ("friction_angle = \"35.6 deg\"\n", "", "B011"),
        ("rounding = \"10 mm\"", "rounding = \"10\"", "B102"),
        ("slope = \"2:1\"", "slope = \"2\"", "B109"),
        ("weighs = false", "weighs = \"no\"", "B012"),
    ];
    let mut file = CASE_1.to_owned();
    for (right, wrong, _) in mistakes {
        assert!(file.contains(right));
        file = file.replacen(right, wrong, 1);
    }
    let found: Vec<&str> = read(file.as_bytes()).diagnostics.iter().map(|finding| finding.code).collect();
    let mut expected: Vec<&str> = mistakes.iter().map(|(_, _, code)| *code).collect();
    let mut sorted = found.clone();
    sorted.sort_unstable();
    expected.sort_unstable();
    assert_eq!(sorted, expected, "{}", show_all(&file));
}

#[test]
fn a_weight_is_a_density_and_a_mass_a_force() {
    let weighed = read(TINY.replace("density = \"2200 kg/m^3\"", "density = \"21.582 kN/m^3\"").as_bytes());
    let plain = read(TINY.as_bytes());
    assert_eq!(weighed.diagnostics, plain.diagnostics);
    let (weighed, plain) = (weighed.bridge.unwrap(), plain.bridge.unwrap());
    assert!((weighed.masonry.density - 2200.0).abs() < 1e-9 && plain.masonry.density == 2200.0);
    // 22 t/m^3 of a file whose writer meant a weight.
    let shown = show_all(&TINY.replace("density = \"2200 kg/m^3\"", "density = \"22 t/m^3\""));
    assert!(shown.contains("did you mean \"22 kN/m^3\"?"), "{shown}");
    // A strength a thousand times too high is one in kPa, not a weight over an area.
    let shown = show_all(&TINY.replace("10 MPa", "5000 MPa"));
    assert!(shown.contains("did you mean \"5000 kPa\"?"), "{shown}");
}

#[test]
fn an_unquoted_quantity_is_put_in_quotes() {
    let shown = show_all(&CASE_1.replace("\"8.30 m\"", "8.30 m"));
    assert!(shown.contains("help: put it in quotes: \"8.30 m\""), "{shown}");
    // A line that cannot be read does not make others seem missing.
    assert_eq!(shown.matches("error[").count(), 1, "{shown}");
}

#[test]
fn an_empty_file_lacks_everything_and_says_so() {
    let shown = show_all("");
    for section in ["[bridge]", "[[span]]", "[masonry]", "[joint]"] {
        assert!(shown.contains(&format!("the file has no {section}")), "{shown}");
    }
}

#[test]
fn a_key_in_the_wrong_section_is_sent_home() {
    let shown = show_all(&CASE_1.replace("[masonry]\n", "[masonry]\ncohesion = \"0 kPa\"\n"));
    assert!(shown.contains("a key of [joint], not of [masonry]"), "{shown}");
}

#[test]
fn a_misspelt_key_is_not_missing_as_well() {
    let shown = show_all(&CASE_1.replace("friction_angle", "friction_angel"));
    assert!(shown.contains("did you mean `friction_angle`?") && !shown.contains("B011"), "{shown}");
}

#[test]
fn paths_of_equilibrium_take_a_stiffness_from_the_modulus_of_the_units() {
    let path = CASE_1
        .replace("normal_stiffness", "# ")
        .replace("shear_stiffness", "# ")
        .replace("method = \"dem\"", "method = \"path\"");
    assert!(path.contains("method = \"path\"") && path.contains("elastic_modulus"), "{path}");
    let shown = show_all(&path);
    assert!(!shown.contains("B401"), "{shown}");
    let unknown = show_all(&path.replace("elastic_modulus", "# "));
    assert_eq!(unknown.matches("error[B401]").count(), 2, "{unknown}");
}

#[test]
fn the_discrete_element_method_asks_for_stiffness() {
    let shown = show_all(&format!("{TINY}analysis = {{ method = \"dem\" }}\n"));
    assert_eq!(shown.matches("error[B401]").count(), 3, "{shown}");
}

#[test]
fn the_road_must_say_how_loads_spread() {
    let shown =
        show_all(&format!("{TINY}cover = {{ layer = \"fill\", thickness = \"0.2 m\", density = \"1900 kg/m^3\" }}\n"));
    assert!(shown.contains("error[B011]: the file has no [dispersal]"), "{shown}");
}

#[test]
fn ring_joints_deform_as_well() {
    let shown = show_all(&VIADUCT.replace("normal_stiffness = \"10 GPa/m\"\n", ""));
    assert!(shown.contains("to [ring_joint], or choose"), "{shown}");
}

/// Warnings do not hide an error, and a list that is too long is refused by its most.
#[test]
fn an_error_outranks_warnings() {
    let layer = "[[cover]]\nlayer = \"ballast\"\nthickness = \"1 mm\"\ndensity = \"100 kg/m^3\"\n";
    let with = |count: usize| CASE_1.replace("[dispersal]\n", &(layer.repeat(count) + "[dispersal]\n"));
    let file = with(40);
    assert!(read(file.as_bytes()).diagnostics.len() >= 40 && read(file.as_bytes()).bridge.is_some());
    let file = file.replace("load_step = \"100 kN\"", "load_limit = \"1 kN\"\nload_step = \"100 kN\"");
    assert!(show_all(&file).contains("error[B405]"));
    assert!(read(file.as_bytes()).bridge.is_none());
    assert!(show_all(&with(60)).contains("more than 50"));
}

#[test]
fn other_systems_write_other_line_ends_and_marks() {
    assert_eq!(show_all(&CASE_1.replace('\n', "\r\n")), "");
    assert_eq!(show_all(&format!("\u{feff}{CASE_1}")), "");
}

#[test]
fn bounds_are_told_in_the_engineers_unit() {
    let shown = show_all(&CASE_1.replace("35.6 deg", "95 deg"));
    assert!(shown.contains("it must be at most 89 deg"), "{shown}");
}

#[test]
fn what_is_left_of_a_broken_line_means_nothing() {
    let shown = show_all(&CASE_1.replace("rise = \"2.85 m\"", "rise = 2.85 m\""));
    assert!(shown.contains("error[B002]") && shown.matches("error[").count() == 1, "{shown}");
}

#[test]
fn a_contact_as_stiff_as_its_blocks_but_for_rounding_is_no_doubt() {
    // Blocks of 0.314 m with 15 GPa alone give 47.79 GPa/m.
    let with = |stiffness: &str| show_all(&CASE_1.replace("\"4.84 GPa/m\"", &format!("\"{stiffness}\"")));
    for rounded in ["47.8 GPa/m", "47.85 GPa/m", "48 GPa/m"] {
        assert_eq!(with(rounded), "", "{rounded}");
    }
    assert!(with("50 GPa/m").contains("P013"));
}
