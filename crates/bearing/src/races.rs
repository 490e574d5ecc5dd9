//! Inner and outer: one type for all that a bearing has twice.

use serde::{Deserialize, Serialize};
use std::ops::{Index, IndexMut};

/// Which ring a race, a contact or a land belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Side {
    /// The inner ring.
    Inner,
    /// The outer ring.
    Outer,
}

impl Side {
    /// Both, inner first: the order of all tables and sums.
    pub const BOTH: [Self; 2] = [Self::Inner, Self::Outer];

    /// Its name as part of the names of quantities.
    pub fn name(self) -> &'static str {
        match self {
            Self::Inner => "inner",
            Self::Outer => "outer",
        }
    }
}

/// One value for each race, indexed by [`Side`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Races<T> {
    /// Of the inner race.
    pub inner: T,
    /// Of the outer race.
    pub outer: T,
}

impl<T> Races<T> {
    /// A value for each side, inner first.
    #[inline]
    pub fn from_fn(mut of: impl FnMut(Side) -> T) -> Self {
        Self { inner: of(Side::Inner), outer: of(Side::Outer) }
    }

    /// [`Self::from_fn`] that may fail.
    ///
    /// # Errors
    /// The first one.
    pub fn try_from_fn<E>(mut of: impl FnMut(Side) -> Result<T, E>) -> Result<Self, E> {
        Ok(Self { inner: of(Side::Inner)?, outer: of(Side::Outer)? })
    }

    /// References to both.
    #[inline]
    pub fn each_ref(&self) -> Races<&T> {
        Races { inner: &self.inner, outer: &self.outer }
    }

    /// Each value changed by a function.
    #[inline]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Races<U> {
        Races { inner: f(self.inner), outer: f(self.outer) }
    }

    /// Both values with their sides, inner first.
    pub fn iter(&self) -> impl Iterator<Item = (Side, &T)> {
        [(Side::Inner, &self.inner), (Side::Outer, &self.outer)].into_iter()
    }
}

impl<T> From<[T; 2]> for Races<T> {
    fn from([inner, outer]: [T; 2]) -> Self {
        Self { inner, outer }
    }
}

impl<T> Index<Side> for Races<T> {
    type Output = T;

    #[inline(always)]
    fn index(&self, side: Side) -> &T {
        match side {
            Side::Inner => &self.inner,
            Side::Outer => &self.outer,
        }
    }
}

impl<T> IndexMut<Side> for Races<T> {
    #[inline(always)]
    fn index_mut(&mut self, side: Side) -> &mut T {
        match side {
            Side::Inner => &mut self.inner,
            Side::Outer => &mut self.outer,
        }
    }
}
