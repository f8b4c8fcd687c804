//! The strings of a report as data, by the names that its page has for them: for typesetters other than a browser.

use crate::figure::Figure;
use crate::page::{Material, Page, page};
use crate::parts::Part;
use serde_json::{Value, json};

/// Some fields of a row as an object.
macro_rules! object {
    ($row:ident: $($field:ident)+) => {{
        let mut object = serde_json::Map::new();
        $(object.insert(stringify!($field).to_owned(), json!($row.$field));)+
        Value::Object(object)
    }};
}

/// Rows as objects of some of their fields.
macro_rules! objects {
    ($rows:expr => $($field:ident)+) => {
        Value::Array($rows.iter().map(|row| object!(row: $($field)+)).collect())
    };
}

/// Every string of the page, and its drawings as they were made.
pub fn data(material: &Material<'_>) -> Value {
    let page = page(material);
    let mut data = object!(page: bridge status headline whole missing beside qualifications augment limits_source update_words runs loads collapse grades rule factors
        discrete_elements movement changes_words notes findings warnings assumptions no_update no_service no_collapse no_changes);
    let rows = [
        ("checks", objects!(page.checks => code title load value limit unit used bar met governs basis of)),
        ("every", objects!(page.every => code title load value limit unit used bar met governs basis of)),
        ("open", objects!(page.open => code title why failed)),
        ("columns", objects!(page.columns => what cells limit unit place)),
        ("condition", objects!(page.condition => parameter before after interval expected standing class words source)),
        ("fit", objects!(page.fit => name unit measured start updated shape remark)),
        ("channels", objects!(page.channels => load name unit cells)),
        ("vehicles", objects!(page.vehicles => code title adequacy class width factor position case)),
        ("changes", objects!(page.changes => path value less more turns)),
        ("inputs", objects!(page.inputs => section key value remark)),
        ("front", parts(&page.front)),
        ("cases", parts(&page.cases)),
        ("numbers", parts(&page.numbers)),
        ("back", parts(&page.back)),
        ("appendix", appendix(&page)),
        ("figures", drawings(&page)),
    ];
    for (name, value) in rows {
        data[name] = value;
    }
    data
}

/// Sections of words and tables; `opens` tells whether one begins a section of its own.
fn parts(list: &[Part]) -> Value {
    let part = |part: &Part| {
        let mut object = object!(part: title words heads numbers rows);
        object["opens"] = json!(part.id.is_some());
        object
    };
    Value::Array(list.iter().map(part).collect())
}

fn appendix(page: &Page<'_>) -> Value {
    let appendix = page.appendix;
    let mut object = object!(appendix: version program file input command day);
    let stages = appendix
        .stages
        .iter()
        .map(|one| json!({ "name": one.name, "state": one.state.to_string(), "seconds": one.seconds, "key": one.key }));
    object["stages"] = stages.collect();
    object
}

fn drawings(page: &Page<'_>) -> Value {
    let list = |figures: &[&Figure]| objects!(figures => caption svg);
    let all = &page.figures;
    json!({
        "built": list(&all.built),
        "update": list(&all.update),
        "service": list(&all.service),
        "ultimate": list(&all.ultimate),
        "vehicles": list(&all.vehicles),
        "movement": list(&all.movement),
        "cases": list(&all.cases),
    })
}
