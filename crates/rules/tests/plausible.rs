//! What is doubtful and what is refused in files of vehicles and rules, and what they change of the library.

use rules::{
    ChangedFactor, Doubt, Required, Rule, based_on, changed_for, doubts_of_rule, doubts_of_vehicles, library,
    read_load_model, read_rule,
};

/// Every factor of a rule that differs from another's.
fn changed_factors(own: &Rule, base: &Rule) -> Vec<ChangedFactor> {
    changed_for(own, base, &own.models())
}

const RULE: &str = include_str!("../data/rules/cs-454.toml");

fn lorry(changes: &[(&str, &str)]) -> String {
    let text = "code = \"lorry\"\ntitle = \"Lorry\"\nways = \"road\"\n\
        source = { text = \"C&U\", date = \"1986\", confidence = \"read\" }\n\
        [[vehicle]]\ncode = \"our-lorry\"\ntitle = \"Lorry 44 t\"\n\
        axle_loads_kn = [68.7, 103.0, 57.0, 67.7, 67.7, 67.7]\nspacings_m = [3.0, 1.3, 5.0, 1.35, 1.35]\n\
        axles_may_be_dropped = true\nwheel_track_m = 1.80\ncontact_length_m = 0.30\n\
        uniform = [{ load_kn_per_m = 5.0, place = \"behind\", width_m = 2.5, may_be_dropped = true }]\n\
        [[under]]\nrule = \"cs-454\"\nlive_load = { value = 1.9, source = { text = \"x\", date = \"2020\", confidence = \"recalled\" } }\n\
        [under.impact]\nkind = \"included\"\nsource = { text = \"x\", date = \"2020\", confidence = \"recalled\" }\n";
    changes.iter().fold(text.to_owned(), |text, (old, new)| {
        assert!(text.contains(old), "{old}");
        text.replacen(old, new, 1)
    })
}

fn doubts(changes: &[(&str, &str)]) -> Vec<Doubt> {
    doubts_of_vehicles(&read_load_model("lorry.toml", &lorry(changes)).unwrap_or_else(|wrong| panic!("{wrong:?}")))
}

/// Tonnes as kilonewtons, and slips of the other sizes: a doubt each, with its card.
#[test]
fn vehicles_that_were_never_built_are_doubted_and_impossible_ones_refused() {
    assert_eq!(doubts(&[]), []);
    for (old, new, code) in [
        ("[68.7, 103.0, 57.0, 67.7, 67.7, 67.7]", "[7.0, 10.5, 5.8, 6.9, 6.9, 6.9]", "P080"),
        ("68.7,", "1100.0,", "P080"),
        ("wheel_track_m = 1.80", "wheel_track_m = 0.18", "P081"),
        ("wheel_track_m = 1.80", "wheel_track_m = 5.9", "P081"),
        ("[3.0, 1.3", "[3.0, 0.13", "P082"),
        ("[3.0, 1.3", "[39.0, 1.3", "P082"),
        ("contact_length_m = 0.30", "contact_length_m = 3.0", "P083"),
        ("load_kn_per_m = 5.0", "load_kn_per_m = 0.5", "P083"),
        ("width_m = 2.5", "width_m = 8.2", "P083"),
        ("value = 1.9", "value = 2.7", "P084"),
    ] {
        let found = doubts(&[(old, new)]);
        assert_eq!(found.iter().map(|doubt| doubt.code).collect::<Vec<_>>(), [code], "{new}: {found:?}");
        assert!(found[0].at.contains("our-lorry") || code == "P084", "{found:?}");
    }
    for (old, new, key) in [
        ("68.7,", "0.07,", "axle_loads_kn"),
        ("68.7,", "68700.0,", "axle_loads_kn"),
        ("wheel_track_m = 1.80", "wheel_track_m = 1800", "wheel_track_m"),
        ("[3.0, 1.3", "[3000.0, 1.3", "spacings_m"),
        ("contact_length_m = 0.30", "contact_length_m = 300", "contact_length_m"),
        ("load_kn_per_m = 5.0", "load_kn_per_m = 5000", "uniform[0].load_kn_per_m"),
        ("width_m = 2.5", "width_m = 2500", "uniform[0].width_m"),
        ("value = 1.9", "value = 0.9", "under[0].live_load"),
        ("value = 1.9", "value = 4.5", "under[0].live_load"),
    ] {
        let wrong = read_load_model("lorry.toml", &lorry(&[(old, new)])).unwrap_err();
        assert!(wrong.len() == 1 && wrong[0].key.ends_with(key) && wrong[0].line > 0, "{new}: {wrong:?}");
        assert!(wrong[0].message.contains("impossible"), "{wrong:?}");
    }
}

/// A factor on the wrong side of 1 would make a bridge stronger than it is.
#[test]
fn rules_with_impossible_factors_are_refused() {
    let with = |section: &str, value: f64| {
        let at = RULE.find(section).unwrap();
        let (head, tail) = RULE.split_at(at);
        let from = tail.find("value = ").unwrap();
        let to = from + tail[from..].find('\n').unwrap();
        format!("{head}{}value = {value}{}", &tail[..from], &tail[to..])
    };
    for (section, bad, odd) in [
        ("[factors.condition]", 2.0, 0.2),
        ("[factors.model]", 0.9, 3.5),
        ("[factors.live_load]", 0.5, 3.4),
        ("[factors.live_load]", 5.0, 2.6),
        ("[factors.masonry_weight]", 0.9, 2.5),
        ("[factors.weight_favourable]", 1.1, 0.5),
        ("[factors.masonry_strength]", 0.5, 5.0),
        ("[factors.friction]", 0.9, 5.0),
        ("[factors.fill_pressure]", 0.9, 5.0),
        ("[loads.impact.factor]", 0.9, 3.4),
    ] {
        let wrong = read_rule("own.toml", &with(section, bad)).unwrap_err();
        // The factor on strength is that on cohesion as well, where the rule has none of its own.
        let keys = if section.contains("masonry_strength") { 2 } else { 1 };
        assert!(wrong.len() == keys && wrong[0].message.contains("impossible"), "{section} {bad}: {wrong:?}");
        let rule = read_rule("own.toml", &with(section, odd)).unwrap_or_else(|wrong| panic!("{section}: {wrong:?}"));
        let found = doubts_of_rule(&rule);
        assert!(found.len() == keys && found[0].code == "P084", "{section} {odd}: {found:?}");
    }
    for (old, new) in
        [("length_per_depth = 1.0", "length_per_depth = 5.0"), ("width_base_m = 1.5", "width_base_m = 1500")]
    {
        assert!(read_rule("own.toml", &RULE.replacen(old, new, 1)).is_err(), "{new}");
    }
}

/// No rule and no vehicle of the library is doubted: a warning on every bridge would be noise.
#[test]
fn the_library_is_not_doubted() {
    let library = library().unwrap();
    for rule in &library.rules {
        assert_eq!(doubts_of_rule(rule), [], "{}", rule.code);
    }
    for model in library.models.iter().filter(|model| model.code != "gb-restrictions") {
        assert_eq!(doubts_of_vehicles(model), [], "{}", model.code);
    }
    // A van of 3 t has an axle of 1 t.
    assert_eq!(doubts_of_vehicles(library.model("gb-restrictions").unwrap()).len(), 1);
}

/// Every factor that differs from the library's rule is listed, whatever the file calls itself.
#[test]
fn what_a_rule_file_changes_is_listed() {
    let library = library().unwrap();
    let own = |changes: &[(&str, &str)]| {
        let text = changes.iter().fold(RULE.to_owned(), |text, (old, new)| {
            assert!(text.contains(old), "{old}");
            text.replacen(old, new, 1)
        });
        read_rule("own.toml", &text).unwrap()
    };
    let renamed = ("code = \"cs-454\"", "code = \"our-rule\"");
    let same = own(&[renamed]);
    let base = based_on(&same, &library).unwrap();
    assert_eq!((base.rule.code.as_str(), base.named), ("cs-454", true), "by its title");
    assert_eq!(changed_factors(&same, base.rule), []);
    // Without any word of the standard: the nearest rule for the same ways, and not named.
    let bare = [
        renamed,
        ("title = \"CS 454, masonry arches at ultimate limit state\"", "title = \"Our rule\""),
        ("text = \"CS 454, Assessment of highway bridges and structures, section 7\"", "text = \"our office\""),
    ];
    let base = based_on(&own(&bare), &library).unwrap();
    assert_eq!((base.rule.code.as_str(), base.named), ("cs-454", false));
    let named = own(&[("code = \"cs-454\"", "code = \"our-rule\"\nbased_on = \"en-1991-2\"")]);
    assert_eq!(based_on(&named, &library).map(|base| base.rule.code.as_str()), Some("en-1991-2"));
    for (old, new, factor, file) in [
        ("[factors.live_load]\nvalue = 1.9", "[factors.live_load]\nvalue = 1.2", "live load", "1.2"),
        (
            "[loads.impact.factor]\nvalue = 1.8",
            "[loads.impact.factor]\nvalue = 1.0",
            "impact on cs-454",
            "1 on the critical axle",
        ),
        ("width_per_depth = 1.0", "width_per_depth = 2.0", "dispersal: width per depth", "2"),
        ("kind = \"dispersed\"", "kind = \"barrel\"", "effective width", "the whole barrel"),
        (
            "overload = { critical = 1.2, others = 1.1",
            "overload = { critical = 1.0, others = 1.0",
            "overload on sv",
            "1 and 1",
        ),
        ("share = 0.867", "share = 0.1", "lanes beside on hb", "0.1 of cs-454"),
        ("[factors.condition]\nvalue = 1.0", "[factors.condition]\nvalue = 0.9", "condition", "0.9"),
    ] {
        let changed = changed_factors(&own(&[renamed, (old, new)]), library.rule("cs-454").unwrap());
        assert!(
            changed.iter().any(|one| one.factor == factor && one.file == file && one.library != file),
            "{factor}: {changed:?}"
        );
        // What acts on several load models is listed for each.
        assert!(changed.len() == 1 || factor == "live load" || factor == "impact on cs-454", "{changed:?}");
    }
}

/// A factor that a file calls read, where the library recalls it, has the engineer's source.
#[test]
fn a_factor_that_is_only_called_surer_is_listed_too() {
    let library = library().unwrap();
    let base = library.rule("cs-454").unwrap();
    let at = RULE.find("[factors.model]").unwrap();
    let (head, tail) = RULE.split_at(at);
    let surer = head.to_owned() + &tail.replacen("confidence = \"recalled\"", "confidence = \"read\"", 1);
    let changed = changed_factors(&read_rule("own.toml", &surer).unwrap(), base);
    assert_eq!(changed.len(), 1, "{changed:?}");
    assert_eq!((changed[0].library.as_str(), changed[0].file.as_str()), ("1 (recalled)", "1 (read)"));
}

/// Every rule with safety says what it asks for; those of railways ask for braking.
#[test]
fn rules_say_what_they_ask_for() {
    let library = library().unwrap();
    for rule in library.rules.iter().filter(|rule| rule.code != "characteristic") {
        let asks = |what: Required| rule.requires.iter().any(|one| one.what == what);
        assert!(asks(Required::Strength) && asks(Required::Dispersal) && asks(Required::Skew), "{}", rule.code);
        assert_eq!(asks(Required::Braking), rule.ways.contains(&rules::Ways::Rail), "{}", rule.code);
    }
}
