//! Results with their published form: a struct says once what it holds, and under which key and in which unit others read it.

use crate::published::Object;
use serde_json::{Value, json};

/// A unit of published numbers.
#[derive(Clone, Copy)]
pub struct Unit {
    /// What it adds to a key: `_kn_per_m`.
    pub suffix: &'static str,
    /// As tables have it: kN/m.
    pub symbol: &'static str,
    /// A number in it, of one in the SI unit.
    pub of: fn(f64) -> f64,
}

/// A key of a published object.
#[derive(Debug, Clone)]
pub struct Key {
    /// Its name, with the unit at the end.
    pub name: String,
    /// Whether it stands only where there is something to tell.
    pub optional: bool,
    /// Type of its value, as Rust has it.
    pub of: &'static str,
    /// Unit of its value; empty where it has none.
    pub unit: &'static str,
    /// What it means.
    pub about: &'static str,
}

/// A struct and its published object, key by key in their order. A line is one of
///
/// - `pub name: Type,` a field that is published under its name;
/// - `pub name: Type [kN/m] as key,` the same in a unit, which ends its key, or under another name;
/// - `pub name?: Option<Type>,` left out where there is nothing;
/// - `pub name: Type = value,` the same with another value in place of its own;
/// - `pub name: Type [kept],` a field that is not published;
/// - `= key: Type [unit] = value,` and `= key?: Type = option,` what is published and no field: the unit is that of the key, the value SI;
/// - `= ..Type = objects,` all keys of the objects of another struct, where there are any.
///
/// After its name the struct may have `|name|` for itself in these values, and what else they need: `|point, width: f64|`.
macro_rules! published {
    () => {};
    ($(#[$meta:meta])* pub struct $Name:ident { $($line:tt)* } $($more:tt)*) => {
        crate::wire::published!($(#[$meta])* pub struct $Name |this| { $($line)* } $($more)*);
    };
    ($(#[$meta:meta])* pub struct $Name:ident |$this:ident| { $($line:tt)* } $($more:tt)*) => {
        crate::wire::published!(@ $this to [$(#[$meta])* $Name ()] [] [] [] $($line)*);

        impl crate::wire::Wire for $Name {
            fn wire(&self, _: crate::wire::Unit) -> serde_json::Value {
                self.object().into()
            }
        }

        crate::wire::published!($($more)*);
    };
    ($(#[$meta:meta])* pub struct $Name:ident |$this:ident, $($with:ident : $With:ty),+| { $($line:tt)* } $($more:tt)*) => {
        crate::wire::published!(@ $this to [$(#[$meta])* $Name ($($with: $With),+)] [] [] [] $($line)*);
        crate::wire::published!($($more)*);
    };

    // A field goes to the struct, and on as what is published of it.
    (@ $this:ident $to:ident $head:tt [$($field:tt)*] $write:tt $told:tt
        $(#[$($about:tt)*])* pub $name:ident : $Type:ty [kept], $($rest:tt)*) => {
        crate::wire::published!(@ $this $to $head [$($field)* $(#[$($about)*])* pub $name: $Type,] $write $told $($rest)*);
    };
    (@ $this:ident $to:ident $head:tt [$($field:tt)*] $write:tt $told:tt
        $(#[$($about:tt)*])* pub $name:ident : $Type:ty $([$($unit:tt)+])? $(as $key:ident)? $(= $value:expr)?, $($rest:tt)*) => {
        crate::wire::published!(@ $this $to $head [$($field)* $(#[$($about)*])* pub $name: $Type,] $write $told
            $(#[$($about)*])* = $name $($key)?: $Type $([$($unit)+])? = crate::wire::value!(&$this.$name $(, $value)?), $($rest)*);
    };
    (@ $this:ident $to:ident $head:tt [$($field:tt)*] $write:tt $told:tt
        $(#[$($about:tt)*])* pub $name:ident ? : $Type:ty $([$($unit:tt)+])? $(as $key:ident)? $(= $value:expr)?, $($rest:tt)*) => {
        crate::wire::published!(@ $this $to $head [$($field)* $(#[$($about)*])* pub $name: $Type,] $write $told
            $(#[$($about)*])* = $name $($key)? ?: $Type $([$($unit)+])? = crate::wire::value!($this.$name.as_ref() $(, $value)?), $($rest)*);
    };
    // What is published: the last of its names is its key.
    (@ $this:ident $to:ident $head:tt $field:tt [$($write:tt)*] [$($told:tt)*]
        $(#[$($about:tt)*])* = $($key:ident)+ : $Type:ty $([$($unit:tt)+])? = $value:expr, $($rest:tt)*) => {
        crate::wire::published!(@ $this $to $head $field
            [$($write)* crate::wire::put($to, crate::wire::key!($($key)+), crate::wire::unit!($($($unit)+)?), $value);]
            [$($told)* crate::wire::key!($to, false, $($key)+, [$($($unit)+)?], $Type, $(#[$($about)*])*);]
            $($rest)*);
    };
    (@ $this:ident $to:ident $head:tt $field:tt [$($write:tt)*] [$($told:tt)*]
        $(#[$($about:tt)*])* = $($key:ident)+ ? : $Type:ty $([$($unit:tt)+])? = $value:expr, $($rest:tt)*) => {
        crate::wire::published!(@ $this $to $head $field
            [$($write)* crate::wire::put_some($to, crate::wire::key!($($key)+), crate::wire::unit!($($($unit)+)?), $value);]
            [$($told)* crate::wire::key!($to, true, $($key)+, [$($($unit)+)?], $Type, $(#[$($about)*])*);]
            $($rest)*);
    };
    (@ $this:ident $to:ident $head:tt $field:tt [$($write:tt)*] [$($told:tt)*] = .. $Type:ident = $value:expr, $($rest:tt)*) => {
        crate::wire::published!(@ $this $to $head $field
            [$($write)* $to.extend($value.into_iter().flatten());]
            [$($told)* crate::wire::some($to, $Type::keys);]
            $($rest)*);
    };
    (@ $this:ident $to:ident [$(#[$meta:meta])* $Name:ident ($($with:ident : $With:ty),*)] [$($field:tt)*] [$($write:tt)*] [$($told:tt)*]) => {
        $(#[$meta])*
        pub struct $Name { $($field)* }

        impl $Name {
            /// As others read it.
            pub fn object(&self $(, $with: $With)*) -> crate::published::Object {
                let ($this, mut object) = (self, crate::published::Object::new());
                let $to = &mut object;
                $($write)*
                object
            }

            /// Adds the keys of that object.
            pub fn keys($to: &mut Vec<crate::wire::Key>) {
                $($told)*
            }
        }
    };
}

/// A key: its own name, or the other one where it has one; and what is told of it.
macro_rules! key {
    ($name:ident) => { stringify!($name) };
    ($name:ident $key:ident) => { stringify!($key) };
    ($to:ident, $optional:literal, $($name:ident)+, [$($unit:tt)*], $Type:ty, $(#[$($about:tt)*])*) => {
        crate::wire::tell($to, crate::wire::key!($($name)+), crate::wire::unit!($($unit)*), $optional,
            [stringify!($Type), crate::wire::about!($(#[$($about)*])*)])
    };
}

/// A field's own value, or the other one where it has one.
macro_rules! value {
    ($own:expr) => {
        $own
    };
    ($own:expr, $value:expr) => {
        $value
    };
}

/// The text of the documentation among attributes.
macro_rules! about {
    () => { "" };
    (#[doc = $text:literal] $($rest:tt)*) => { concat!($text, crate::wire::about!($($rest)*)) };
    (#[$($other:tt)*] $($rest:tt)*) => { crate::wire::about!($($rest)*) };
}

/// Makes `unit`: what stands in brackets, what a unit adds to keys, its symbol, and a number in it of an SI one.
macro_rules! units { ($([$($unit:tt)*] $suffix:literal, $symbol:literal, $of:expr;)*) => {
    /// A unit of published numbers.
    macro_rules! unit { $(($($unit)*) => { crate::wire::Unit { suffix: $suffix, symbol: $symbol, of: $of } };)* }
} }

units! {
    [] "", "", |x| x;
    [m] "_m", "m", |x| x;
    [mm] "_mm", "mm", |x| 1e3 * x;
    [s] "_s", "s", |x| x;
    [deg] "_deg", "°", f64::to_degrees;
    [km/h] "_km_per_h", "km/h", |x| 3.6 * x;
    [kN] "_kn", "kN", |x| x / 1e3;
    [kN/m] "_kn_per_m", "kN/m", |x| x / 1e3;
    [kPa] "_kpa", "kPa", |x| x / 1e3;
    [MPa] "_mpa", "MPa", |x| x / 1e6;
    [GPa/m] "_gpa_per_m", "GPa/m", |x| x / 1e9;
}

pub(crate) use {about, key, published, unit, value};

/// A value as it stands in an object, its numbers in a unit.
pub(crate) trait Wire {
    fn wire(&self, unit: Unit) -> Value;
}

impl Wire for f64 {
    fn wire(&self, unit: Unit) -> Value {
        json!((unit.of)(*self))
    }
}

impl<T: Wire> Wire for Option<T> {
    fn wire(&self, unit: Unit) -> Value {
        self.as_ref().map_or(Value::Null, |one| one.wire(unit))
    }
}

impl<T: Wire> Wire for [T] {
    fn wire(&self, unit: Unit) -> Value {
        self.iter().map(|one| one.wire(unit)).collect()
    }
}

/// What holds another value is published as that.
macro_rules! holds { ($([$($of:tt)*] $Holder:ty),*) => { $(impl<$($of)*> Wire for $Holder {
    fn wire(&self, unit: Unit) -> Value {
        (**self).wire(unit)
    }
})* } }

holds!([T: Wire + ?Sized] &T, [T: Wire] Box<T>, [T: Wire] Vec<T>);

impl<T: Wire, const N: usize> Wire for [T; N] {
    fn wire(&self, unit: Unit) -> Value {
        self.as_slice().wire(unit)
    }
}

/// Kinds whose published form is that of files.
macro_rules! plain { ($($Kind:ty),* $(,)?) => { $(impl crate::wire::Wire for $Kind {
    fn wire(&self, _: crate::wire::Unit) -> serde_json::Value {
        serde_json::json!(self)
    }
})* } }

pub(crate) use plain;

plain!(bool, u32, u64, usize, str, String, Value, Object);
plain!(bridge::Analysis, bridge::ContactLength, bridge::JointContact, bridge::Method, bridge::Strip);
plain!(bridge::passage::PassageAnalysis, bridge::passage::PassageKinematics, bridge::passage::PassagePath);

pub(crate) fn put(to: &mut Object, name: &str, unit: Unit, value: impl Wire) {
    to.insert(format!("{name}{}", unit.suffix), value.wire(unit));
}

pub(crate) fn put_some(to: &mut Object, name: &str, unit: Unit, value: Option<impl Wire>) {
    if let Some(value) = value {
        put(to, name, unit, value);
    }
}

pub(crate) fn tell(to: &mut Vec<Key>, name: &str, unit: Unit, optional: bool, [of, about]: [&'static str; 2]) {
    to.push(Key { name: format!("{name}{}", unit.suffix), optional, of, unit: unit.symbol, about: about.trim_ascii() });
}

/// Keys that stand only where there is something to tell.
pub(crate) fn some(to: &mut Vec<Key>, keys: fn(&mut Vec<Key>)) {
    let from = to.len();
    keys(to);
    to[from..].iter_mut().for_each(|key| key.optional = true);
}
