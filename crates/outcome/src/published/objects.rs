//! JSON objects, each key written once, and their text.

use findings::visible::is_hidden;
use serde::Serialize;
use serde_json::Value;

/// A JSON object, its keys in the order in which they were written.
pub type Object = serde_json::Map<String, Value>;

/// An [`Object`], each key written once: `key: value`; `key?: option`, left out where there is nothing; `..object`, whose keys
/// stand here, none where there is no object.
macro_rules! object {
    (@ $to:ident) => {};
    (@ $to:ident .. $group:expr, $($rest:tt)*) => {
        $to.extend($group.into_iter().flatten());
        object!(@ $to $($rest)*);
    };
    (@ $to:ident $key:ident ? : $value:expr, $($rest:tt)*) => {
        if let Some(value) = &$value {
            $to.insert(stringify!($key).to_owned(), serde_json::json!(value));
        }
        object!(@ $to $($rest)*);
    };
    (@ $to:ident $key:ident : $value:expr, $($rest:tt)*) => {
        $to.insert(stringify!($key).to_owned(), serde_json::json!($value));
        object!(@ $to $($rest)*);
    };
    ($($entries:tt)*) => {{
        let mut to = crate::published::Object::new();
        object!(@ to $($entries)*);
        to
    }};
}

pub(crate) use object;

/// One object for each.
pub(crate) fn list<T>(of: impl IntoIterator<Item = T>, one: impl FnMut(T) -> Object) -> Vec<Object> {
    of.into_iter().map(one).collect()
}

/// A number of an object by its key, or how many a list has; none where there is neither.
pub fn number(object: &Object, key: &str) -> Option<f64> {
    match object.get(key)? {
        Value::Array(list) => Some(list.len() as f64),
        value => value.as_f64(),
    }
}

/// Any object as JSON text, with a newline at its end. Characters that act instead of being seen stand as their numbers: it is the same
/// object to every reader, and does nothing to a terminal.
pub fn json<T: Serialize>(object: &T) -> String {
    let text = serde_json::to_string_pretty(object).expect("numbers and strings always have a JSON form");
    let mut out = String::with_capacity(text.len() + 1);
    for character in text.chars() {
        if is_hidden(character) && character != '\n' {
            let mut units = [0; 2];
            character.encode_utf16(&mut units).iter().for_each(|unit| out += &format!("\\u{unit:04x}"));
        } else {
            out.push(character);
        }
    }
    out.push('\n');
    out
}

/// N/m in kN/m, or N in kN.
pub(crate) fn kilo(value: f64) -> f64 {
    value / 1e3
}

/// Text, where there is some.
pub(crate) fn said(text: &str) -> Option<&str> {
    (!text.is_empty()).then_some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_holds_nothing_that_acts_and_is_the_same_to_its_readers() {
        let object = serde_json::json!({ "name": "a\u{202e}b\u{9b}\u{1b}\u{7f}橋" });
        let text = json(&object);
        assert!(!text.chars().any(|one| is_hidden(one) && one != '\n'), "{text:?}");
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), object);
    }
}
