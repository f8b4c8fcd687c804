//! Arguments of calls: words and quantities with units, each refused by its name.

use crate::errors;
use bridge::choice::Choice as Words;
use bridge::quantity::{self, Dimension};
use extrados::{Choice, StageName};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Options of a call as Python gives them.
pub(crate) type Given<'a, 'py> = &'a Bound<'py, PyDict>;

/// Who is told how far the work of a call is.
pub(crate) type Listener<'a, 'py> = Option<&'a Bound<'py, PyAny>>;

/// Arguments by name, each taken once; what nobody takes is refused.
pub(crate) struct Options<'py> {
    given: Bound<'py, PyDict>,
}

impl<'py> Options<'py> {
    /// What is taken of a dictionary; entries of `None` are as if they were not there, and what is left is refused.
    pub(crate) fn read<T>(given: &Bound<'py, PyDict>, take: impl FnOnce(&Self) -> PyResult<T>) -> PyResult<T> {
        let own = Options { given: PyDict::new(given.py()) };
        for (key, value) in given.iter().filter(|(_, value)| !value.is_none()) {
            own.given.set_item(key, value)?;
        }
        let taken = take(&own)?;
        own.end()?;
        Ok(taken)
    }

    fn take(&self, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
        let value = self.given.get_item(name)?;
        if value.is_some() {
            self.given.del_item(name)?;
        }
        Ok(value)
    }

    fn wrong(&self, name: &str, value: &Bound<'py, PyAny>, wanted: &str) -> PyErr {
        let shown = value.repr().map_or_else(|_| "its value".to_owned(), |words| words.to_string());
        let shown: String = shown.chars().take(80).collect();
        errors::argument(self.given.py(), format!("{name} = {shown} cannot be used"), wanted)
    }

    /// What is read of a value where it is given; what cannot be read is refused with what is wanted.
    fn read_as<T>(
        &self,
        name: &str,
        wanted: impl FnOnce() -> String,
        read: impl FnOnce(&Bound<'py, PyAny>) -> Option<T>,
    ) -> PyResult<Option<T>> {
        let Some(value) = self.take(name)? else { return Ok(None) };
        read(&value).map(Some).ok_or_else(|| self.wrong(name, &value, &wanted()))
    }

    /// A text.
    pub(crate) fn text(&self, name: &str, wanted: &str) -> PyResult<Option<String>> {
        self.read_as(name, || wanted.to_owned(), |value| value.extract().ok())
    }

    /// A word of a list.
    pub(crate) fn word<T: Words>(&self, name: &str) -> PyResult<Option<T>> {
        self.read_as(name, || format!("write {}", known::<T>()), |value| T::named(&value.extract::<String>().ok()?))
    }

    /// A quantity above zero in one of these dimensions, with its unit.
    fn quantity(&self, name: &str, of: &[Dimension], example: &str) -> PyResult<Option<quantity::Quantity>> {
        let wanted = || {
            let names: Vec<&str> = of.iter().map(|dimension| dimension.name()).collect();
            format!("write {} above zero with its unit: \"{example}\"", names.join(" or "))
        };
        self.read_as(name, wanted, |value| {
            let read = quantity::parse(&value.extract::<String>().ok()?).ok()?.of(of)?;
            Some(read).filter(|read| read.si() > 0.0 && read.si().is_finite())
        })
    }

    /// A length [m].
    pub(crate) fn length(&self, name: &str) -> PyResult<Option<f64>> {
        Ok(self.quantity(name, &[Dimension::Length], "0.25 m")?.map(|read| read.si()))
    }

    /// A speed [m/s].
    pub(crate) fn speed(&self, name: &str) -> PyResult<Option<f64>> {
        Ok(self.quantity(name, &[Dimension::Speed], "45 km/h")?.map(|read| read.si()))
    }

    /// A count of at least one.
    pub(crate) fn count(&self, name: &str) -> PyResult<Option<u64>> {
        let wanted = || "write a whole number of at least 1".to_owned();
        self.read_as(name, wanted, |value| value.extract().ok().filter(|count| *count > 0))
    }

    /// True or false.
    pub(crate) fn flag(&self, name: &str) -> PyResult<bool> {
        Ok(self.read_as(name, || "write True or False".to_owned(), |value| value.extract().ok())?.unwrap_or(false))
    }

    /// Texts of a list.
    pub(crate) fn texts(&self, name: &str, wanted: &str) -> PyResult<Vec<String>> {
        Ok(self.read_as(name, || wanted.to_owned(), |value| value.extract().ok())?.unwrap_or_default())
    }

    /// What takes the place of the file's plan, for a bridge of this width [m].
    pub(crate) fn choice(&self, width: f64) -> PyResult<Choice> {
        let resolution = self.quantity("resolution", &[Dimension::LineLoad, Dimension::Force], "1 kN/m")?;
        let damping = || "write \"local:0.8\", \"viscous:0.8\" or \"adaptive\"".to_owned();
        let tolerance = || "write a ratio above 0 and up to 0.1, such as 1e-5".to_owned();
        Ok(Choice {
            analysis: self.word("analysis")?,
            method: self.word("method")?,
            resolution: resolution.map(|read| match read.unit.dimension {
                Dimension::Force => read.si() / width,
                _ => read.si(),
            }),
            damping: self.read_as("damping", damping, |value| {
                extrados::damping(&value.extract::<String>().unwrap_or_default()).ok()
            })?,
            contact: self.word("contact")?,
            contact_length: self.word("contact_length")?,
            friction: self.word("friction")?,
            contact_points: self.word("contact_points")?,
            tolerance: self.read_as("tolerance", tolerance, |value| {
                value.extract().ok().filter(|ratio| *ratio > 0.0 && *ratio <= 0.1)
            })?,
            step_limit: self.count("step_limit")?,
        })
    }

    /// Stages that an assessment leaves out.
    pub(crate) fn stages(&self, name: &str) -> PyResult<Vec<StageName>> {
        let wanted = || format!("write a list of {}", known::<StageName>());
        let stages = self.read_as(name, wanted, |value| {
            value.extract::<Vec<String>>().ok()?.iter().map(|word| StageName::named(word)).collect()
        });
        Ok(stages?.unwrap_or_default())
    }

    /// Refuses what is left.
    fn end(&self) -> PyResult<()> {
        let left: Vec<String> = self.given.keys().iter().map(|key| key.to_string()).collect();
        if left.is_empty() {
            return Ok(());
        }
        let message = format!("there is no argument {}", left.join(", "));
        Err(errors::argument(self.given.py(), message, "the documentation of the call lists its arguments"))
    }
}

/// Every word of a key, in quotes.
fn known<T: Words>() -> String {
    T::WORDS.iter().map(|one| format!("\"{}\"", one.word)).collect::<Vec<_>>().join(", ")
}

/// Files that are given as bytes beside those of the disk.
pub(crate) fn files(given: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<(std::path::PathBuf, Vec<u8>)>> {
    let Some(given) = given else { return Ok(Vec::new()) };
    let all = given.iter().map(|(path, bytes)| Ok((path.extract()?, bytes.extract::<Vec<u8>>()?)));
    all.collect()
}
