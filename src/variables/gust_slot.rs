//! Where the parameters of gusts and turbulence live.

use crate::air::{
    GustCriterion, GustSettings, GustShape, Spectrum, TurbulenceComponents, TurbulenceSettings,
};

use super::value::Value;

/// A parameter of the single gust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the quantities are documented in GustSettings")]
pub enum GustSetting {
    Shape,
    Gradient,
    Peak,
    Direction,
    Inclination,
    Start,
    Criterion,
    Alleviation,
    MaximumOperatingAltitude,
}

/// A parameter of the turbulence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the quantities are documented in TurbulenceSettings")]
pub enum TurbulenceSetting {
    Spectrum,
    Intensity,
    Scale,
    Seed,
    Components,
    Start,
}

/// All items of the enumerations, in the order of their numbers from 1.
const SHAPES: [GustShape; 2] = [GustShape::None, GustShape::OneMinusCosine];
const CRITERIA: [GustCriterion; 3] = [GustCriterion::Peak, GustCriterion::Cs25Vc, GustCriterion::Cs25Vd];
const SPECTRA: [Spectrum; 3] = [Spectrum::None, Spectrum::Dryden, Spectrum::VonKarman];
const COMPONENTS: [TurbulenceComponents; 3] =
    [TurbulenceComponents::All, TurbulenceComponents::Vertical, TurbulenceComponents::Lateral];

/// The item with a number; `present` where there is none.
fn item<T: Copy>(items: &[T], number: i32, present: T) -> T {
    let place = usize::try_from(number).ok().and_then(|number| number.checked_sub(1));
    place.and_then(|place| items.get(place)).copied().unwrap_or(present)
}

impl GustSetting {
    pub(super) fn get(self, gust: &GustSettings) -> Value {
        match self {
            GustSetting::Shape => Value::Integer(gust.shape as i32 + 1),
            GustSetting::Gradient => Value::Real(gust.gradient),
            GustSetting::Peak => Value::Real(gust.peak),
            GustSetting::Direction => Value::Real(gust.direction),
            GustSetting::Inclination => Value::Real(gust.inclination),
            GustSetting::Start => Value::Real(gust.start),
            GustSetting::Criterion => Value::Integer(gust.criterion as i32 + 1),
            GustSetting::Alleviation => Value::Real(gust.alleviation),
            GustSetting::MaximumOperatingAltitude => Value::Real(gust.maximum_operating_altitude),
        }
    }

    /// A value of the wrong type or outside an enumeration changes nothing.
    pub(super) fn set(self, gust: &mut GustSettings, value: Value) {
        match (self, value) {
            (GustSetting::Shape, Value::Integer(i)) => gust.shape = item(&SHAPES, i, gust.shape),
            (GustSetting::Criterion, Value::Integer(i)) => {
                gust.criterion = item(&CRITERIA, i, gust.criterion);
            }
            (GustSetting::Gradient, Value::Real(x)) => gust.gradient = x,
            (GustSetting::Peak, Value::Real(x)) => gust.peak = x,
            (GustSetting::Direction, Value::Real(x)) => gust.direction = x,
            (GustSetting::Inclination, Value::Real(x)) => gust.inclination = x,
            (GustSetting::Start, Value::Real(x)) => gust.start = x,
            (GustSetting::Alleviation, Value::Real(x)) => gust.alleviation = x,
            (GustSetting::MaximumOperatingAltitude, Value::Real(x)) => gust.maximum_operating_altitude = x,
            _ => {}
        }
    }
}

impl TurbulenceSetting {
    pub(super) fn get(self, turbulence: &TurbulenceSettings) -> Value {
        match self {
            TurbulenceSetting::Spectrum => Value::Integer(turbulence.spectrum as i32 + 1),
            TurbulenceSetting::Intensity => Value::Real(turbulence.intensity),
            TurbulenceSetting::Scale => Value::Real(turbulence.scale),
            TurbulenceSetting::Seed => Value::Integer(turbulence.seed),
            TurbulenceSetting::Components => Value::Integer(turbulence.components as i32 + 1),
            TurbulenceSetting::Start => Value::Real(turbulence.start),
        }
    }

    /// A value of the wrong type or outside an enumeration changes nothing.
    pub(super) fn set(self, turbulence: &mut TurbulenceSettings, value: Value) {
        match (self, value) {
            (TurbulenceSetting::Spectrum, Value::Integer(i)) => {
                turbulence.spectrum = item(&SPECTRA, i, turbulence.spectrum);
            }
            (TurbulenceSetting::Components, Value::Integer(i)) => {
                turbulence.components = item(&COMPONENTS, i, turbulence.components);
            }
            (TurbulenceSetting::Seed, Value::Integer(i)) => turbulence.seed = i,
            (TurbulenceSetting::Intensity, Value::Real(x)) => turbulence.intensity = x,
            (TurbulenceSetting::Scale, Value::Real(x)) => turbulence.scale = x,
            (TurbulenceSetting::Start, Value::Real(x)) => turbulence.start = x,
            _ => {}
        }
    }
}
