//! Derivatives at the initialisation by parameters, against trims found anew and closed forms.

use std::f64::consts::PI;

use super::endurance::{typical_section, wing};
use super::*;
use crate::devices::Noise;
use crate::structure::ReducedModel;
use crate::variables::{OutputSlot, ParameterSlot, Unit};

/// An aircraft in initialisation mode, and how to make another one.
struct Initialisation {
    model: ReducedModel,
    table: VariableTable,
    levels: &'static [(&'static str, c_int)],
    values: Vec<(&'static str, f64)>,
}

impl Initialisation {
    fn new(
        model: &ReducedModel,
        levels: &'static [(&'static str, c_int)],
        values: &[(&'static str, f64)],
    ) -> Self {
        let (model, table) = (model.clone(), VariableTable::new(model));
        Initialisation { model, table, levels, values: values.to_vec() }
    }

    fn reference(&self, name: &str) -> u32 {
        self.table.reference(name).unwrap()
    }

    /// With the values, some of them replaced.
    fn fmu(&self, unpacked: &Unpacked, replaced: &[(&str, f64)]) -> Fmu {
        let fmu = wing(unpacked, &guid(&self.model));
        for (name, value) in self.levels {
            // SAFETY: the component is alive, the arrays have one element.
            assert_eq!(unsafe { fmi2SetInteger(fmu.component, &self.reference(name), 1, value) }, Status::Ok);
        }
        for (name, value) in self.values.iter().chain(replaced) {
            assert_eq!(fmu.set_references(&[self.reference(name)], &[*value]), Status::Ok);
        }
        assert_eq!([fmu.set_up(None, 0.0, None), fmu.enter()], [Status::Ok; 2]);
        fmu
    }

    /// Compares the derivatives of all outputs by all real parameters with differences of trims.
    fn check(&self) {
        let unpacked = Unpacked::of(&self.model.to_bytes(), "wing");
        let fmu = self.fmu(&unpacked, &[]);
        let outputs: Vec<(u32, OutputSlot, Option<Unit>)> = self
            .table
            .iter()
            .filter_map(|(reference, variable)| match variable.slot {
                Slot::Output(slot) if variable.kind == Type::Real => Some((reference, slot, variable.unit)),
                _ => None,
            })
            .collect();
        let references: Vec<u32> = outputs.iter().map(|(reference, ..)| *reference).collect();
        let parameters = self.table.iter().filter_map(|(reference, variable)| match variable.slot {
            Slot::Parameter(slot) if variable.kind == Type::Real => Some((reference, slot, &variable.name)),
            _ => None,
        });
        for (parameter, slot, name) in parameters {
            if matches!(slot, ParameterSlot::Condition(_)) {
                // Which flight is trimmed is a choice: there is no small one.
                assert!(fmu.derivatives(&references, &[parameter], &[1.0]).is_err(), "{name}");
                continue;
            }
            let derivatives = fmu.derivatives(&references, &[parameter], &[1.0]).unwrap();
            let at = fmu.get_references(&[parameter]).unwrap()[0];
            let step = match slot {
                ParameterSlot::Altitude => 20.0,
                ParameterSlot::TemperatureOffset => 1.0,
                ParameterSlot::Heading => 0.02,
                // Switched off.
                ParameterSlot::Actuator { .. }
                | ParameterSlot::Engine { .. }
                | ParameterSlot::Sensor(_)
                | ParameterSlot::Turbulence(_) => 0.0,
                ParameterSlot::Gust(_) if !self.levels.iter().any(|(name, _)| *name == "gust.shape") => 0.0,
                _ => 5e-3 * at,
            };
            let trimmed = |steps: f64| {
                let other = self.fmu(&unpacked, &[(name.as_str(), at + steps * step)]);
                other.get_references(&references).unwrap()
            };
            if step == 0.0 {
                assert_eq!(derivatives, vec![0.0; references.len()], "{name}");
                continue;
            }
            let [far_behind, behind, ahead, far_ahead] = [-2.0, -1.0, 1.0, 2.0].map(trimmed);
            let expected: Vec<f64> = (0..references.len())
                .map(|i| (8.0 * (ahead[i] - behind[i]) - (far_ahead[i] - far_behind[i])) / (12.0 * step))
                .collect();
            for (place, (reference, slot, unit)) in outputs.iter().enumerate() {
                let alike = outputs.iter().zip(&expected).filter(|((_, _, other), _)| other == unit);
                let largest = alike.fold(0.0_f64, |largest, (_, expected)| largest.max(expected.abs()));
                let magnitude = ahead[place].abs().max(1.0) / step;
                let scale = expected[place].abs().max(1e-3 * largest).max(1e-6 * magnitude);
                let error = (derivatives[place] - expected[place]).abs() / scale;
                let output = &self.table.get(*reference).unwrap().name;
                assert!(
                    error < 1e-6,
                    "d {output}/d {name}: {} {} ({error:.1e})",
                    derivatives[place],
                    expected[place]
                );
                let known = self.table.initial_dependencies(*slot).contains(&parameter);
                assert!(
                    known || derivatives[place].abs() <= 1e-9 * magnitude,
                    "d {output}/d {name} is not declared"
                );
            }
        }
    }
}

/// Differences of trims over 0.5 % of airspeed and stiffness, 20 m and 0.02 rad: their own error is below 1e-7.
#[test]
fn derivatives_at_the_initialisation_by_every_parameter_are_differences_of_trims() {
    let one_sided =
        [("aileron", 0.01), ("rudder", -0.02), ("wind_east", 3.0), ("wind_down", -1.0), ("heading", 1.0)];
    let soft = [("stiffness_scale", 0.1), ("elevator", 0.01)];
    Initialisation::new(jet(), &[], &[]).check();
    Initialisation::new(jet(), &[], &one_sided).check();
    Initialisation::new(jet(), &[("model", 2)], &soft).check();
    Initialisation::new(jet(), &[("input_reference", 2), ("model", 4)], &soft).check();
    Initialisation::new(jet(), &[("model", 5)], &one_sided).check();
    const BY_CRITERION: [(&str, c_int); 3] = [("model", 5), ("gust.shape", 2), ("gust.criterion", 2)];
    let cold = [("gust.alleviation", 0.8), ("temperature_offset", -30.0)];
    Initialisation::new(jet(), &BY_CRITERION, &cold).check();
    Initialisation::new(jet(), &[("model", 5), ("gust.shape", 2)], &[("gust.alleviation", 0.8)]).check();
    // In a turn to the right, in a pull-up, with the left engine out.
    Initialisation::new(jet(), &[("condition.manoeuvre", 2)], &[("condition.bank_angle", 0.3)]).check();
    Initialisation::new(jet(), &[("condition.manoeuvre", 3)], &[("condition.load_factor", 1.3)]).check();
    const ENGINE_OUT: [(&str, c_int); 2] = [("condition.failed_engine", 1), ("input_reference", 2)];
    Initialisation::new(jet(), &ENGINE_OUT, &[]).check();
    Initialisation::new(
        &typical_section(),
        &[],
        &[("airspeed", 20.0), ("altitude", 0.0), ("wind_down", -0.5)],
    )
    .check();
}

#[test]
fn heading_airspeed_and_altitude_are_passed_on_one_to_one_also_where_the_yaw_angle_jumps() {
    for heading in [0.0, 1.0, PI - 1e-4, -PI, 7.0] {
        let fmu = Fmu::initialising();
        assert_eq!(fmu.set(&[("heading", heading)]), Status::Ok);
        let derivatives = [
            fmu.by("heading", &["attitude.yaw"])[0],
            fmu.by("airspeed", &["air.speed"])[0],
            -fmu.by("altitude", &["position.down"])[0],
        ];
        for derivative in derivatives {
            assert!((derivative - 1.0).abs() < 1e-9, "{heading}: {derivatives:?}");
        }
        assert_eq!(fmu.by("heading", &["attitude.pitch", "trim.thrust"]), [0.0, 0.0]);
        // Noise number 0 of this channel: mirrored and sampled, the sensor jumps where its angle does.
        let noise = Noise::new(1, "sensor.attitude.yaw").number(0);
        for (sampled, by_rms) in [(0, 0.0), (1, noise)] {
            assert_eq!(fmu.set_boolean("sensor.enabled", sampled), Status::Ok);
            let by = |known| fmu.by(known, &["sensor.attitude.yaw"])[0];
            let found = [by("heading") - 1.0, by("sensor.noise.attitude") - by_rms];
            assert!(found.iter().all(|apart| apart.abs() < 1e-9), "{heading} {sampled}: {found:?}");
        }
    }
    // Troposphere: d ln ρ/dh = (L − g₀/R)/T with L = 6.5 mK/m.
    let fmu = Fmu::initialising();
    let expected = (0.0065 - 9.80665 / 287.05287) / (288.15 - 0.0065 * 7620.0) * fmu.get("air.density");
    let derivative = fmu.by("altitude", &["air.density"])[0];
    assert!((derivative / expected - 1.0).abs() < 1e-9, "{derivative} {expected}");
    // At one pressure ρT does not change.
    let found = fmu.by("temperature_offset", &["air.density", "air.temperature", "air.pressure"]);
    let expected = -fmu.get("air.density") / fmu.get("air.temperature");
    assert!((found[0] / expected - 1.0).abs() < 1e-9 && (found[1] - 1.0).abs() < 1e-9, "{found:?}");
    assert_eq!(found[2], 0.0);
}

#[test]
fn in_still_air_derivatives_by_the_airspeed_are_those_of_more_of_it() {
    let model = typical_section();
    let table = VariableTable::new(&model);
    let fmu = wing(&Unpacked::of(&model.to_bytes(), "wing"), &guid(&model));
    let [airspeed, speed, pressure] =
        ["airspeed", "air.speed", "air.dynamic_pressure"].map(|name| table.reference(name).unwrap());
    assert_eq!(fmu.set_references(&[airspeed], &[0.0]), Status::Ok);
    assert_eq!([fmu.set_up(None, 0.0, None), fmu.enter()], [Status::Ok; 2]);
    let found = fmu.derivatives(&[speed, pressure], &[airspeed], &[1.0]).unwrap();
    // Of the dynamic pressure ρV at the width of the change, 1 mm/s.
    assert!((found[0] - 1.0).abs() < 1e-9 && found[1] > 0.0 && found[1] < 2e-3, "{found:?}");
}
