//! Typed indices and the table that only accepts its own kind.

use serde::{Deserialize, Serialize};
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

/// An index into one kind of [`Table`].
pub trait Id: Copy + Eq + Ord {
    /// The id of row `index`.
    fn new(index: usize) -> Self;
    /// The row this id names.
    fn index(self) -> usize;
}

macro_rules! ids {
    ($($(#[$meta:meta])* $name:ident),* $(,)?) => {$(
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        pub struct $name(pub u32);

        impl Id for $name {
            fn new(index: usize) -> Self {
                $name(u32::try_from(index).expect("more rows than a 32-bit id can name"))
            }
            fn index(self) -> usize {
                self.0 as usize
            }
        }
    )*};
}

ids! {
    /// A rigid block of a [`BlockModel`](crate::blocks::BlockModel).
    BlockId,
    /// A particle of a [`BlockModel`](crate::blocks::BlockModel).
    ParticleId,
    /// A group of bodies that share the laws of their contacts: voussoirs of one ring, a pier, backing.
    GroupId,
    /// A node of a finite element [`Mesh`](crate::fem::Mesh).
    NodeId,
    /// A quadrilateral of a finite element [`Mesh`](crate::fem::Mesh).
    QuadId,
    /// A row of facing node pairs of a finite element [`Mesh`](crate::fem::Mesh).
    InterfaceId,
    /// A zone of one material of a finite element [`Mesh`](crate::fem::Mesh).
    ZoneId,
}

/// A `Vec<T>` that can only be indexed by its own id.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Table<I, T> {
    rows: Vec<T>,
    kind: PhantomData<I>,
}

impl<I, T> Default for Table<I, T> {
    fn default() -> Self {
        Table { rows: Vec::new(), kind: PhantomData }
    }
}

impl<I: Id, T> Table<I, T> {
    /// Appends a row and returns its id.
    pub fn push(&mut self, row: T) -> I {
        self.rows.push(row);
        I::new(self.rows.len() - 1)
    }
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }
    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
    /// Rows in order of their ids.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.rows.iter()
    }
    /// Rows in order of their ids, to be changed.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.rows.iter_mut()
    }
    /// Ids in order.
    pub fn ids(&self) -> impl Iterator<Item = I> + use<I, T> {
        (0..self.rows.len()).map(I::new)
    }
    /// Ids and rows in order.
    pub fn pairs(&self) -> impl Iterator<Item = (I, &T)> {
        self.rows.iter().enumerate().map(|(i, row)| (I::new(i), row))
    }
    /// The rows as a plain slice.
    pub fn as_slice(&self) -> &[T] {
        &self.rows
    }
}

impl<I, T> FromIterator<T> for Table<I, T> {
    fn from_iter<S: IntoIterator<Item = T>>(rows: S) -> Self {
        Table { rows: rows.into_iter().collect(), kind: PhantomData }
    }
}

impl<I: Id, T> Index<I> for Table<I, T> {
    type Output = T;
    fn index(&self, id: I) -> &T {
        &self.rows[id.index()]
    }
}

impl<I: Id, T> IndexMut<I> for Table<I, T> {
    fn index_mut(&mut self, id: I) -> &mut T {
        &mut self.rows[id.index()]
    }
}
