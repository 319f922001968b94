//! Reduced models of an aircraft with other stiffnesses and masses, each made once for the points that share it.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use flexible_aircraft::aircraft::{Aircraft, Factor, FactorOutOfRange};
use flexible_aircraft::structure::{ModeCount, ReducedModel, StructureError};

/// So many are kept for points to come: with 120 modes one takes 100 MB.
const KEPT: usize = 8;

/// Why there is no such model.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Factor(#[from] FactorOutOfRange),
    #[error(transparent)]
    Structure(#[from] StructureError),
    #[error("the structure has {found} modes, that of the aircraft file {expected}")]
    OtherModes { found: usize, expected: usize },
}

/// What tells models apart: the bits of the factors.
pub type Key = Vec<u64>;

/// The models of an aircraft.
pub struct Models {
    aircraft: Aircraft,
    count: ModeCount,
    /// What is multiplied, in the order of the numbers.
    factors: Vec<Factor>,
    /// Without factors.
    pub plain: Arc<ReducedModel>,
    /// The latest last.
    kept: Mutex<VecDeque<(Key, Arc<ReducedModel>)>>,
}

impl Models {
    /// Those of an aircraft, which has been reduced, when some factors vary.
    pub fn new(aircraft: Aircraft, count: ModeCount, plain: Arc<ReducedModel>, factors: Vec<Factor>) -> Self {
        Models { aircraft, count, factors, plain, kept: Mutex::new(VecDeque::new()) }
    }

    /// The model with these numbers for the factors.
    ///
    /// # Errors
    /// When there is none.
    pub fn of(&self, numbers: &[f64]) -> Result<Arc<ReducedModel>, Error> {
        if self.factors.is_empty() {
            return Ok(Arc::clone(&self.plain));
        }
        let key = key(numbers);
        let of_before = || {
            let kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
            kept.iter().find(|(other, _)| *other == key).map(|(_, model)| Arc::clone(model))
        };
        if let Some(model) = of_before() {
            return Ok(model);
        }
        let model = Arc::new(self.reduce(numbers)?);
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if kept.len() == KEPT {
            kept.pop_front();
        }
        kept.push_back((key, Arc::clone(&model)));
        Ok(model)
    }

    fn reduce(&self, numbers: &[f64]) -> Result<ReducedModel, Error> {
        let mut aircraft = self.aircraft.clone();
        for (factor, number) in self.factors.iter().zip(numbers) {
            aircraft.multiply(factor, *number)?;
        }
        let model = ReducedModel::new(&aircraft, self.count)?;
        let [found, expected] = [&model, &*self.plain].map(|model| model.modes.len());
        if found == expected { Ok(model) } else { Err(Error::OtherModes { found, expected }) }
    }
}

/// Of these numbers.
pub fn key(numbers: &[f64]) -> Key {
    numbers.iter().map(|number| number.to_bits()).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn models() -> Models {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../aircraft/goland-wing.toml");
        let aircraft = Aircraft::read(&path).unwrap();
        let plain = Arc::new(ReducedModel::new(&aircraft, 2).unwrap());
        let named = |name: &str| aircraft.factors().into_iter().find(|factor| factor.name == name).unwrap();
        let factors = vec![named("component.wing.stiffness"), named("mass.wing")];
        Models::new(aircraft, 2.into(), plain, factors)
    }

    #[test]
    fn frequencies_go_with_the_roots_of_stiffness_and_mass() {
        let models = models();
        let first = |numbers: [f64; 2]| models.of(&numbers).unwrap().modes[0].angular_frequency;
        let plain = models.plain.modes[0].angular_frequency;
        assert_eq!(first([1.0, 1.0]), plain);
        assert!((first([4.0, 1.0]) / plain - 2.0).abs() < 1e-9);
        assert!((first([1.0, 4.0]) / plain - 0.5).abs() < 1e-9);
    }

    #[test]
    fn the_same_numbers_share_one_model() {
        let models = models();
        let [one, other, third] =
            [[0.5, 1.0], [0.5, 1.0], [0.6, 1.0]].map(|numbers| models.of(&numbers).unwrap());
        assert!(Arc::ptr_eq(&one, &other) && !Arc::ptr_eq(&one, &third));
        let refused = models.of(&[0.0, 1.0]).unwrap_err().to_string();
        assert_eq!(refused, "component.wing.stiffness: found the factor 0, allowed is 0.000001 to 1000000");
    }
}
