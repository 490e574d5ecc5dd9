//! Setting of a sweep: a place of the case with its values.

use super::values;
use tribodyn::Change;

/// Values for one place of the case: `PATH=VALUES`.
#[derive(Debug, Clone)]
pub struct Setting {
    /// Stands before the setting in messages.
    prefix: &'static str,
    pub(crate) path: String,
    pub(crate) values: Vec<String>,
}

impl Setting {
    /// Reads `PATH=VALUES`, such as `ring.z.Force=kN(10..60 by 5)`.
    ///
    /// # Errors
    /// A text that says what is wrong and what is allowed.
    pub fn parse(text: &str) -> Result<Self, String> {
        match text.split_once('=') {
            Some((path, list)) if !path.trim().is_empty() && !list.trim().is_empty() => {
                Ok(Self { prefix: "", path: path.trim().to_owned(), values: values::expand(list)? })
            }
            _ => {
                Err("allowed is PATH=VALUES, such as ring.z.Force=kN(10),kN(20) or ring.z.Force=kN(10..60 by 5)"
                    .to_owned())
            }
        }
    }

    /// Values one by one, each as a case file has it.
    pub fn of(path: &str, values: Vec<String>) -> Self {
        Self { prefix: "", path: path.to_owned(), values }
    }

    /// Number of values.
    pub fn count(&self) -> usize {
        self.values.len()
    }

    /// With a text that stands before the setting in messages, such as the name of an option.
    pub fn prefixed(self, prefix: &'static str) -> Self {
        Self { prefix, ..self }
    }

    pub(crate) fn change(&self, index: usize) -> Change {
        Change::new(format!("{}{}={}", self.prefix, self.path, self.values[index]), &self.path, &self.values[index])
    }
}
