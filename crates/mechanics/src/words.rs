//! Data as plain 64-bit words, to the last bit: what a run is kept as, so that it goes on as if nothing had happened.

use crate::ids::{BlockId, Id, Table};
use crate::plane::{Pose, Rotation, Vec2};

/// Something that can be written as words and read back.
pub(crate) trait Words: Sized {
    fn put(&self, to: &mut Vec<u64>);
    fn take(from: &mut &[u64]) -> Option<Self>;
}

impl Words for u64 {
    fn put(&self, to: &mut Vec<u64>) {
        to.push(*self);
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        let (&first, rest) = from.split_first()?;
        *from = rest;
        Some(first)
    }
}

impl Words for f64 {
    fn put(&self, to: &mut Vec<u64>) {
        to.push(self.to_bits());
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        u64::take(from).map(f64::from_bits)
    }
}

impl Words for u32 {
    fn put(&self, to: &mut Vec<u64>) {
        to.push(u64::from(*self));
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        u64::take(from)?.try_into().ok()
    }
}

impl Words for bool {
    fn put(&self, to: &mut Vec<u64>) {
        to.push(u64::from(*self));
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        match u64::take(from)? {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }
}

impl<T: Words> Words for Option<T> {
    fn put(&self, to: &mut Vec<u64>) {
        self.is_some().put(to);
        if let Some(value) = self {
            value.put(to);
        }
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        Some(if bool::take(from)? { Some(T::take(from)?) } else { None })
    }
}

impl<T: Words> Words for Vec<T> {
    fn put(&self, to: &mut Vec<u64>) {
        (self.len() as u64).put(to);
        self.iter().for_each(|v| v.put(to));
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        let count = u64::take(from)?;
        // Every element takes at least one word: a damaged count must not ask for the machine's memory.
        if count > from.len() as u64 {
            return None;
        }
        (0..count).map(|_| T::take(from)).collect()
    }
}

impl<T: Words + Copy + Default, const N: usize> Words for [T; N] {
    fn put(&self, to: &mut Vec<u64>) {
        self.iter().for_each(|v| v.put(to));
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        let mut values = [T::default(); N];
        for v in &mut values {
            *v = T::take(from)?;
        }
        Some(values)
    }
}

impl<A: Words, B: Words> Words for (A, B) {
    fn put(&self, to: &mut Vec<u64>) {
        self.0.put(to);
        self.1.put(to);
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        Some((A::take(from)?, B::take(from)?))
    }
}

impl<I: Id, T: Words> Words for Table<I, T> {
    fn put(&self, to: &mut Vec<u64>) {
        (self.len() as u64).put(to);
        self.iter().for_each(|v| v.put(to));
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        Vec::take(from).map(|rows| rows.into_iter().collect())
    }
}

macro_rules! fields {
    ($($name:ident { $($field:ident),+ $(,)? })+) => {$(
        impl $crate::words::Words for $name {
            fn put(&self, to: &mut Vec<u64>) {
                $($crate::words::Words::put(&self.$field, to);)+
            }
            fn take(from: &mut &[u64]) -> Option<Self> {
                Some($name { $($field: $crate::words::Words::take(from)?),+ })
            }
        }
    )+};
}
pub(crate) use fields;

fields! {
    Vec2 { x, y }
    Rotation { cos, sin }
    Pose { position, rotation }
}

impl Words for BlockId {
    fn put(&self, to: &mut Vec<u64>) {
        self.0.put(to);
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        u32::take(from).map(BlockId)
    }
}

impl Words for usize {
    fn put(&self, to: &mut Vec<u64>) {
        to.push(*self as u64);
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        u64::take(from)?.try_into().ok()
    }
}

/// A sign: -1, 0 or 1.
impl Words for i8 {
    fn put(&self, to: &mut Vec<u64>) {
        to.push(*self as u64);
    }
    fn take(from: &mut &[u64]) -> Option<Self> {
        (u64::take(from)? as i64).try_into().ok()
    }
}
