//! What a model description says of a variable.

use std::fmt;

use quick_xml::events::BytesStart;

use super::attributes::{number, optional, required, text};

/// The types of both versions of FMI, called as there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum VariableType {
    #[default]
    Real,
    Integer,
    Boolean,
    String,
    Enumeration,
    Float64,
    Float32,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Binary,
    Clock,
}

/// A size of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dimension {
    /// It is this.
    Size(u64),
    /// It is the value of the variable with this reference.
    By(u32),
}

/// A variable; texts are empty where the file says nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Variable {
    pub name: String,
    pub value_reference: u32,
    pub causality: String,
    pub description: String,
    pub kind: VariableType,
    pub unit: String,
    pub start: String,
    /// Smallest value.
    pub min: String,
    /// Largest value.
    pub max: String,
    /// Of an enumeration: names and values, in the order of the file.
    pub items: Vec<(String, String)>,
    /// Of an array.
    pub(super) dimensions: Vec<Dimension>,
}

/// A type that variables are declared with; texts are empty where the file says nothing.
#[derive(Clone, Debug, Default)]
pub(super) struct DeclaredType {
    pub name: String,
    unit: String,
    min: String,
    max: String,
    pub items: Vec<(String, String)>,
}

impl VariableType {
    /// The types of FMI 2.0.
    const SECOND: [VariableType; 5] = [
        VariableType::Real,
        VariableType::Integer,
        VariableType::Boolean,
        VariableType::String,
        VariableType::Enumeration,
    ];

    /// The types of FMI 3.0.
    const THIRD: [VariableType; 15] = [
        VariableType::Float64,
        VariableType::Float32,
        VariableType::Int8,
        VariableType::UInt8,
        VariableType::Int16,
        VariableType::UInt16,
        VariableType::Int32,
        VariableType::UInt32,
        VariableType::Int64,
        VariableType::UInt64,
        VariableType::Boolean,
        VariableType::String,
        VariableType::Binary,
        VariableType::Enumeration,
        VariableType::Clock,
    ];

    /// The type of FMI 2.0 that is called like an element.
    pub(super) fn of_second(element: &str) -> Option<Self> {
        Self::SECOND.into_iter().find(|kind| kind.to_string() == element)
    }

    /// The type of FMI 3.0 that is called like an element.
    pub(super) fn of_third(element: &str) -> Option<Self> {
        Self::THIRD.into_iter().find(|kind| kind.to_string() == element)
    }

    /// Whether values of both are the same numbers, texts or items: those of FMI 2.0 have two names in FMI 3.0.
    pub fn holds_the_same_as(self, other: Self) -> bool {
        let of_third = |kind| match kind {
            VariableType::Real => VariableType::Float64,
            VariableType::Integer => VariableType::Int32,
            kind => kind,
        };
        of_third(self) == of_third(other)
    }

    /// The limits of an integer, and how many bits it has.
    pub fn integers(self) -> Option<([i128; 2], u32)> {
        let (is_signed, bits) = match self {
            VariableType::Int8 => (true, 8),
            VariableType::UInt8 => (false, 8),
            VariableType::Int16 => (true, 16),
            VariableType::UInt16 => (false, 16),
            VariableType::Integer | VariableType::Int32 => (true, 32),
            VariableType::UInt32 => (false, 32),
            VariableType::Int64 => (true, 64),
            VariableType::UInt64 => (false, 64),
            _ => return None,
        };
        let half = 1_i128 << (bits - 1);
        Some((if is_signed { [-half, half - 1] } else { [0, 2 * half - 1] }, bits))
    }
}

impl fmt::Display for VariableType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

impl DeclaredType {
    /// One whose limits are said later.
    pub(super) fn named(element: &BytesStart<'_>) -> Result<Self, String> {
        Ok(DeclaredType { name: required(element, "name")?, ..DeclaredType::default() })
    }

    /// Takes what an element says of values.
    pub(super) fn complete(&mut self, element: &BytesStart<'_>) -> Result<(), String> {
        self.unit = text(element, "unit")?;
        (self.min, self.max) = (text(element, "min")?, text(element, "max")?);
        Ok(())
    }
}

impl Variable {
    /// One of whose values an element says nothing.
    pub(super) fn named(element: &BytesStart<'_>) -> Result<Self, String> {
        let name = required(element, "name")?;
        let reference = required(element, "valueReference")?;
        Ok(Variable {
            value_reference: reference
                .parse()
                .map_err(|_| format!("{name}: valueReference `{reference}`"))?,
            causality: text(element, "causality")?,
            description: text(element, "description")?,
            name,
            ..Variable::default()
        })
    }

    /// Takes what an element says of values; unit and limits may come from the declared type.
    pub(super) fn complete(
        &mut self,
        kind: VariableType,
        element: &BytesStart<'_>,
        types: &[DeclaredType],
    ) -> Result<(), String> {
        let declared = optional(element, "declaredType")?;
        let declared = declared.and_then(|name| types.iter().find(|known| known.name == name)).cloned();
        let DeclaredType { unit, min, max, items, .. } = declared.unwrap_or_default();
        self.kind = kind;
        self.unit = optional(element, "unit")?.unwrap_or(unit);
        self.min = optional(element, "min")?.unwrap_or(min);
        self.max = optional(element, "max")?.unwrap_or(max);
        self.items = items;
        self.start = text(element, "start")?;
        Ok(())
    }

    /// The same by another name.
    pub(super) fn alias(&self, element: &BytesStart<'_>) -> Result<Self, String> {
        let description = optional(element, "description")?.unwrap_or_else(|| self.description.clone());
        Ok(Variable { name: required(element, "name")?, description, ..self.clone() })
    }
}

impl Dimension {
    pub(super) fn of(element: &BytesStart<'_>) -> Result<Self, String> {
        match (number(element, "start")?, number(element, "valueReference")?) {
            (Some(size), _) => Ok(Dimension::Size(size)),
            (None, Some(reference)) => Ok(Dimension::By(reference)),
            (None, None) => Err("<Dimension> has neither an attribute start nor valueReference".to_owned()),
        }
    }
}
