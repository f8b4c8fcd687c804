//! What is usual of masonry, joints and fill.

use bridge::material::materials;

#[test]
fn every_material_has_its_own_name_and_every_value_a_source() {
    let all = materials();
    assert!(all.len() >= 12);
    for (k, one) in all.iter().enumerate() {
        assert!(all[..k].iter().all(|other| other.code != one.code), "{}", one.code);
        assert!(!one.tables.is_empty() && !one.values.is_empty() && !one.title.is_empty(), "{}", one.code);
        for (k, value) in one.values.iter().enumerate() {
            assert!(one.values[..k].iter().all(|other| other.key != value.key), "{} {}", one.code, value.key);
            let (text, date) = (&value.source.text, &value.source.date);
            assert!(text.len() > 8 && date.len() == 4, "{} {}", one.code, value.key);
            // A remark is one line of a bridge file.
            let remark = value.remark(one);
            assert!(!remark.contains(['\n', '#']) && remark.contains(value.source.confidence.word()), "{remark}");
        }
    }
}

/// Materials that the field tests are predicted with have the numbers of their priors; the modulus of sandstone alone is another, that of
/// stones that were measured.
#[test]
fn materials_agree_with_the_priors_of_the_field_tests() {
    let priors: toml::Table = toml::from_str(include_str!("../../../../validation/priors.toml")).unwrap();
    let same = [
        ("sandstone", &["masonry", "sandstone"][..]),
        ("brick-in-lime", &["masonry", "brick-in-lime"]),
        ("rubble", &["masonry", "rubble"]),
        ("old-joints", &["joint"]),
        ("old-fill", &["fill", "old"]),
        ("crushed-stone", &["fill", "crushed-stone"]),
        ("rubble-backing", &["backing_material"]),
    ];
    let all = materials();
    let mut compared = 0;
    for (code, path) in same {
        let table = path.iter().try_fold(&priors, |table, name| table.get(*name)?.as_table()).unwrap();
        for value in &all.iter().find(|one| one.code == code).unwrap().values {
            let Some(prior) = table.get(&value.key).and_then(toml::Value::as_table) else { continue };
            if (code, value.key.as_str()) != ("sandstone", "elastic_modulus") {
                let theirs = ["least", "expected", "most"].map(|end| prior[end].as_str().unwrap());
                assert_eq!([&value.least, &value.usual, &value.most], theirs, "{code} {}", value.key);
                compared += 1;
            }
        }
    }
    assert!(compared >= 14, "{compared}");
}
