//! Loads at rest: what a file and a table beside it mean, and what is said of wrong ones.

use bridge::load_test::{PatchForce, Sequence};
use bridge::passage::Heading;
use bridge::read;

use crate::files::{LOAD_TABLE, LOAD_TEST, LORRY, show_all};

#[test]
fn a_load_test_is_what_its_file_says() {
    let found = read(LOAD_TEST.as_bytes());
    let bridge = found.bridge.unwrap_or_else(|| panic!("{}", show_all(LOAD_TEST)));
    assert!(bridge.passage.is_none(), "nothing crosses, and no [passage] is missed");
    let test = bridge.load_test.unwrap();
    assert_eq!((test.sequence, test.positions.len(), test.sensors.len()), (Sequence::InOrder, 3, 2));
    let first = &test.positions[0].vehicles[0];
    assert_eq!((first.vehicle.as_deref(), first.front_axle, first.direction), (None, 1.25, Heading::Left));
    assert_eq!(test.positions[1].vehicles[1].vehicle.as_deref(), Some("cs454-rfv"));
    let forces: Vec<PatchForce> = test.positions[2].forces.iter().map(|patch| patch.force).collect();
    assert_eq!(forces, [PatchForce::Whole(120e3), PatchForce::PerWidth(50e3)]);
    let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
    let crown: Vec<(usize, f64)> = test.readings.of(0).collect();
    assert!(crown.len() == 2 && crown[1].0 == 1 && close(crown[1].1, -0.31e-3), "{crown:?}");
    assert!(test.readings.of(1).all(|(k, value)| k == 0 && close(value, -9e-6)));
    assert!(close(test.readings.uncertainty[1].unwrap(), 2e-6));
    // Readings alone are enough to seek parameters by.
    let update = found.update.unwrap();
    assert!(update.records.is_none() && update.parameters.len() == 1);
    // A crossing of the same vehicle shares it, and its sensors.
    let both = LORRY.to_owned() + "[load_test]\nposition = { name = \"a\", vehicle = { front_axle = \"1 m\" } }\n";
    let both = read(both.as_bytes()).bridge.unwrap();
    let (passage, test) = (both.passage.unwrap(), both.load_test.unwrap());
    assert!(passage.plan == test.plan && test.train == Some(passage.train) && test.sensors.len() == 6);
}

#[test]
fn a_table_is_pasted_from_a_spreadsheet() {
    let mut test = read(LOAD_TABLE.as_bytes()).bridge.unwrap().load_test.unwrap();
    let names: Vec<String> = test.sensors.iter().map(|sensor| sensor.name.clone()).collect();
    let (crown, strain) = (&names[0], &names[3]);
    let close = |found: Option<f64>, wanted: f64| found.is_some_and(|found| (found / wanted - 1.0).abs() < 1e-12);
    // Tabs and decimal commas of one spreadsheet, points of another, and the headings of a table of this program.
    for table in [
        format!("position\t{crown} [mm]\tTemperature (°C)\t{strain} (µε)\nP2\t−0,31\t12,5\t-24\nP1\t-0,2\t12\t\n"),
        format!(
            "\u{feff}# synthetic: a test\nPosition,{crown} [m],{strain} [mm/m]\nP2,-0.00031,-0.024\n\nP1,-0.0002,-\n"
        ),
        format!(
            "position;{}_mm;{}_microstrain\np2;-0.31;-24\nP1;-0.20\n",
            crown.replace(' ', "_"),
            strain.replace(' ', "_")
        ),
    ] {
        test.readings.values.clear();
        test.take_table(&table).unwrap_or_else(|wrong| panic!("{wrong:?}"));
        assert_eq!(test.readings.synthetic.as_deref(), table.contains('#').then_some("a test"));
        let values = &test.readings.values;
        assert!(close(values[0][0], -0.2e-3) && close(values[0][1], -0.31e-3), "{values:?}");
        assert!(close(values[3][1], -24e-6) && values[3][0].is_none() && values[1][0].is_none(), "{values:?}");
    }
}

#[test]
fn a_table_with_slips_is_refused_line_by_line() {
    let mut test = read(LOAD_TABLE.as_bytes()).bridge.unwrap().load_test.unwrap();
    let mut said = |table: &str| test.take_table(table).unwrap_err().join("\n");
    for (table, words) in [
        ("", "no line"),
        ("position,crown displacement [mm]\n", "no reading"),
        (
            "position,crown displacement\nP1,-0.3\n",
            "line 1: write the column of crown displacement with the unit of a length",
        ),
        ("position,crown displacement [microstrain]\nP1,-0.3\n", "crown displacement [mm]"),
        ("position,crwn [mm]\nP1,-0.3\n", "line 1: \"crwn [mm]\" is no sensor; the sensors are crown displacement"),
        ("position,crown displacement [mm],crown displacement [m]\nP1,1,1\n", "two columns"),
        (
            "position,crown displacement [mm]\nP3,-0.3\n",
            "line 2: there is no position \"P3\"; the positions are P1, P2",
        ),
        ("position,crown displacement [mm]\nP1,-0.3\nP1,-0.3\n", "line 3: position \"P1\" is there twice"),
        ("position,crown displacement [mm]\nP1,none\n", "line 2, crown displacement: \"none\" is no number"),
        ("position,crown displacement [mm]\nP1,-0,31\n", "line 2: 3 cells below a heading of 2"),
        ("position,crown displacement [mm]\nP1,1e300\n", "beyond anything"),
        ("position,crown displacement [mm]\nP1,nan\n", "is no number"),
    ] {
        assert!(said(table).contains(words), "{table}: {}", said(table));
    }
}

/// The lorry of that file.
const LORRY_HERE: &str =
    "[vehicle]\nname = \"test lorry\"\naxle_loads = [\"6.1 t\", \"9.5 t\"]\naxle_spacings = [\"3.6 m\"]\n";

#[test]
fn slips_of_a_load_test_have_a_place_and_a_remedy() {
    for (right, wrong, words) in [
        ("front_axle = \"1.25 m\", ", "", "`front_axle` is missing in [[load_test.position.vehicle]]"),
        ("front_axle = \"1.25 m\"", "axle = \"1.25 m\"", "unknown key `axle`"),
        (
            "\"crown strain\" = \"-9 microstrain\"",
            "\"crown strian\" = \"-9 microstrain\"",
            "did you mean \"crown strain\"?",
        ),
        (
            "\"crown strain\" = \"-9 microstrain\"",
            "\"crown strain\" = -9",
            "a number with its unit in quotes: \"… microstrain\"",
        ),
        ("\"crown strain\" = \"2 microstrain\"", "\"crown strain\" = \"0 microstrain\"", "is not above zero"),
        ("name = \"jack\"", "name = \"quarter point\"", "error[B680]: two positions have the same name"),
        ("width = \"0.60 m\"", "width = \"6 m\"", "error[B303]"),
        ("length = \"0.30 m\", width", "width", "`length` is missing in [[load_test.position.force]]"),
        (LORRY_HERE, "", "error[B681]: the file describes no vehicle that could stand here"),
        ("sequence = \"in-order\"", "sequence = \"in-order\"\nreadings = \"test.csv\"", "exclude one another"),
        ("[load_test]\n", "[load_test]\nload = 1\n", "unknown key `load`"),
        ("direction = \"left\" }", "direction = \"back\" }", "`direction` cannot be \"back\""),
    ] {
        let file = LOAD_TEST.replacen(right, wrong, 1);
        assert_ne!(file, LOAD_TEST, "{right}");
        let shown = show_all(&file);
        assert!(shown.contains(words) && shown.contains("help: "), "{words}:\n{shown}");
        assert!(read(file.as_bytes()).bridge.is_none(), "{shown}");
    }
    // Nothing was read yet: the test can be planned.
    let bare: String =
        LOAD_TEST.lines().filter(|line| !line.starts_with("readings")).map(|line| format!("{line}\n")).collect();
    let planned = read(bare.as_bytes());
    let nothing = planned.bridge.unwrap().load_test.unwrap().readings;
    assert!(planned.update.is_some() && !nothing.any(), "{}", show_all(&bare));
}
