//! What units are made of.

use quick_xml::events::BytesStart;

use super::attributes::number;

/// How a unit is made of SI base units; without, it is known by its name only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BaseUnit {
    /// Of kg, m, s, A, K, mol, cd, rad.
    exponents: [i32; 8],
    factor: f64,
    offset: f64,
}

impl BaseUnit {
    pub(super) fn of(element: &BytesStart<'_>) -> Result<Self, String> {
        let mut exponents = [0; 8];
        for (exponent, name) in exponents.iter_mut().zip(["kg", "m", "s", "A", "K", "mol", "cd", "rad"]) {
            *exponent = number(element, name)?.unwrap_or_default();
        }
        Ok(BaseUnit {
            exponents,
            factor: number(element, "factor")?.unwrap_or(1.0),
            offset: number(element, "offset")?.unwrap_or(0.0),
        })
    }
}
