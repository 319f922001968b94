//! Model exchange: an importer that integrates and linearises through the C functions.

mod dependencies;
mod flights;
mod jacobian;
mod refusals;

use super::*;
use crate::aircraft::Aircraft;
use crate::plant::PlantSettings;
use crate::variables::{ArchiveTable, Place};

const EXCHANGE: Interface = Interface { version: Version::V2, kind: Kind::ModelExchange };

/// An instance whose every call succeeds.
pub(crate) struct Exchange {
    pub(super) fmu: Fmu,
    pub table: ArchiveTable,
}

/// A wing in a wind tunnel.
pub(super) fn goland() -> ReducedModel {
    let text = include_str!("../../../../aircraft/goland-wing.toml");
    ReducedModel::new(&Aircraft::parse(text, "goland-wing.toml").unwrap(), 4).unwrap()
}

impl Exchange {
    /// Of an aircraft, in the state instantiated.
    pub fn new(model: &ReducedModel) -> Self {
        let starts = starts::usual(EXCHANGE, model);
        let unpacked = Unpacked::of(&model.to_bytes(), "m");
        let request = Request {
            name: Some("m"),
            kind: 0,
            guid: Some(&description::token(EXCHANGE, model, &starts)),
            uri: Some(&unpacked.uri("m")),
            logging_on: false,
        };
        let fmu = Fmu::request(&request);
        assert!(!fmu.component.is_null(), "{:?}", fmu.log);
        Exchange { fmu, table: ArchiveTable::new(model, &starts, EXCHANGE.extent()) }
    }

    /// With these values, ready to be integrated from 0 s on.
    pub fn flying(model: &ReducedModel, values: &[(&str, f64)]) -> Self {
        let exchange = Exchange::new(model);
        exchange.set(values);
        let fmu = &exchange.fmu;
        let statuses = [fmu.set_up(None, 0.0, Some(100.0)), fmu.enter(), fmu.exit()];
        assert_eq!(statuses, [Status::Ok; 3], "{:?}", fmu.log);
        // SAFETY: the component is alive.
        assert_eq!(unsafe { fmi2EnterContinuousTimeMode(fmu.component) }, Status::Ok);
        exchange
    }

    pub fn reference(&self, name: &str) -> u32 {
        let found = self.table.iter().find(|(_, row)| row.name == name);
        found.unwrap_or_else(|| panic!("no variable `{name}`")).0
    }

    pub fn name(&self, reference: u32) -> &str {
        &self.table.get(reference).unwrap().name
    }

    /// Sets variables of any type.
    pub fn set(&self, values: &[(&str, f64)]) {
        for (name, value) in values {
            let (reference, c) = (self.reference(name), self.fmu.component);
            let integer = *value as c_int;
            // SAFETY: the component is alive, the arrays have one element.
            let status = unsafe {
                match self.table.get(reference).unwrap().kind {
                    Type::Real => fmi2SetReal(c, &reference, 1, value),
                    Type::Integer | Type::Enumeration(_) => fmi2SetInteger(c, &reference, 1, &integer),
                    Type::Boolean => fmi2SetBoolean(c, &reference, 1, &integer),
                }
            };
            assert_eq!(status, Status::Ok, "{name}: {:?}", self.fmu.log);
        }
    }

    pub fn get(&self, names: &[&str]) -> Vec<f64> {
        let references: Vec<u32> = names.iter().map(|name| self.reference(name)).collect();
        self.fmu.get_references(&references).unwrap_or_else(|status| panic!("{status:?}: {:?}", self.fmu.log))
    }

    pub fn states(&self) -> Vec<f64> {
        let mut x = vec![0.0; self.table.states().len()];
        // SAFETY: the component is alive, the array is as long as said.
        let status = unsafe { fmi2GetContinuousStates(self.fmu.component, x.as_mut_ptr(), x.len()) };
        assert_eq!(status, Status::Ok, "{:?}", self.fmu.log);
        x
    }

    /// At a time, s.
    pub fn set_states(&self, time: f64, x: &[f64]) {
        // SAFETY: the component is alive, the array is as long as said.
        let statuses = unsafe {
            [
                fmi2SetTime(self.fmu.component, time),
                fmi2SetContinuousStates(self.fmu.component, x.as_ptr(), x.len()),
            ]
        };
        assert_eq!(statuses, [Status::Ok; 2], "{:?}", self.fmu.log);
    }

    pub fn rates(&self) -> Vec<f64> {
        let mut rates = vec![0.0; self.table.states().len()];
        // SAFETY: the component is alive, the array is as long as said.
        let status = unsafe { fmi2GetDerivatives(self.fmu.component, rates.as_mut_ptr(), rates.len()) };
        assert_eq!(status, Status::Ok, "{:?}", self.fmu.log);
        rates
    }

    /// A step of a size (s) by the classical method of fourth order.
    pub fn step(&self, time: f64, size: f64) {
        let x = self.states();
        let at = |share: f64, slope: &[f64]| {
            let moved: Vec<f64> = x.iter().zip(slope).map(|(x, slope)| x + share * size * slope).collect();
            self.set_states(time + share * size, &moved);
            self.rates()
        };
        let one = self.rates();
        let two = at(0.5, &one);
        let three = at(0.5, &two);
        let four = at(1.0, &three);
        let mean = |i: usize| (one[i] + 2.0 * (two[i] + three[i]) + four[i]) / 6.0;
        let end: Vec<f64> = (0..x.len()).map(|i| x[i] + size * mean(i)).collect();
        self.set_states(time + size, &end);
    }

    /// The changes of unknowns along the direction of one known.
    pub fn derivatives(&self, unknowns: &[u32], known: u32) -> Vec<f64> {
        let mut changes = vec![0.0; unknowns.len()];
        // SAFETY: the component is alive, the arrays are as long as said.
        let status = unsafe {
            fmi2GetDirectionalDerivative(
                self.fmu.component,
                unknowns.as_ptr(),
                unknowns.len(),
                &known,
                1,
                &1.0,
                changes.as_mut_ptr(),
            )
        };
        assert_eq!(status, Status::Ok, "{}: {:?}", self.name(known), self.fmu.log);
        changes
    }

    /// References of Reals that are wanted.
    pub fn reals(&self, wanted: impl Fn(Place) -> bool) -> Vec<u32> {
        let rows = self.table.iter().filter(|(_, row)| row.kind == Type::Real && wanted(row.slot));
        rows.map(|(reference, _)| reference).collect()
    }
}

#[test]
fn the_trim_is_at_rest_but_for_its_way() {
    for (model, values) in [
        (jet().clone(), vec![]),
        (jet().clone(), vec![("heading", 1.0), ("model", 6.0), ("airspeed", 140.0)]),
        (goland(), vec![]),
    ] {
        let exchange = Exchange::flying(&model, &values);
        let rates = exchange.rates();
        for (rate, (state, reference)) in rates.iter().zip(exchange.table.states()) {
            use crate::flight::ContinuousState::{Drift, Position};
            if !matches!(state, Position(_) | Drift(_)) {
                assert!(rate.abs() < 1e-8, "{}: {rate}", exchange.name(*reference));
            }
        }
        if model.name == jet().name {
            let speed: f64 = rates[..3].iter().map(|rate| rate * rate).sum();
            let airspeed = exchange.get(&["airspeed"])[0];
            assert!((libm::sqrt(speed) - airspeed).abs() < 1e-9);
            let (north, east) = (rates[0], rates[1]);
            let heading = exchange.get(&["heading"])[0];
            assert!((libm::atan2(east, north) - heading).abs() < 1e-9);
        }
    }
}

#[test]
fn states_are_the_outputs_of_their_names_and_those_not_in_use_rest() {
    let exchange = Exchange::flying(jet(), &[("mode_count", 2.0), ("inflow_states", 0.0)]);
    let x: Vec<f64> =
        exchange.states().iter().enumerate().map(|(i, x)| x + 1e-3 * (1.0 + i as f64 / 600.0)).collect();
    exchange.set_states(0.5, &x);
    let references: Vec<u32> = exchange.table.states().iter().map(|(_, reference)| *reference).collect();
    let read = exchange.fmu.get_references(&references).unwrap();
    let rates = exchange.rates();
    for (place, (state, reference)) in exchange.table.states().iter().enumerate() {
        use crate::flight::ContinuousState as S;
        let rests = match *state {
            S::Coordinate(mode) | S::CoordinateRate(mode) => !is_in_use(mode),
            S::Inflow { .. } | S::SurfaceRate(_) => true,
            _ => false,
        };
        let expected = if rests { 0.0 } else { x[place] };
        assert_eq!(read[place].to_bits(), expected.to_bits(), "{}", exchange.name(*reference));
        let is_still = rests || matches!(state, S::SurfaceAngle(_) | S::LaggedThrust(_));
        assert!(!is_still || rates[place] == 0.0, "{}", exchange.name(*reference));
    }
}

/// Whether a mode is one of the two lowest.
fn is_in_use(mode: usize) -> bool {
    let settings = PlantSettings { mode_count: 2, ..PlantSettings::of(jet()) };
    let modes = settings.choose_modes(jet()).unwrap();
    (0..modes.len()).any(|coordinate| modes.packaged(coordinate) == Some(mode))
}

#[test]
fn nominals_are_those_of_the_description() {
    let exchange = Exchange::new(jet());
    let mut nominals = vec![0.0; exchange.table.states().len()];
    // SAFETY: the component is alive, the array is as long as said.
    let status = unsafe {
        fmi2GetNominalsOfContinuousStates(exchange.fmu.component, nominals.as_mut_ptr(), nominals.len())
    };
    assert_eq!(status, Status::Ok);
    for (nominal, (_, reference)) in nominals.iter().zip(exchange.table.states()) {
        assert_eq!(exchange.table.get(*reference).unwrap().nominal, Some(*nominal));
    }
    let of = |name: &str| {
        let place = exchange.table.states().iter().position(|(_, r)| *r == exchange.reference(name));
        nominals[place.unwrap()]
    };
    assert_eq!((of("position.north"), of("rate.y"), of("velocity.x")), (1000.0, 0.1, 10.0));
    assert_eq!(
        (of("inflow[1,1]"), of("drift.east"), of("engine.left.lagged_thrust")),
        (1.0, 1000.0, 10_000.0)
    );
    assert_eq!((of("actuator.elevator.position"), of("actuator.elevator.rate")), (0.1, 1.0));
    assert!((of("modal.q_dot[3]") - of("modal.q[3]") * jet().airspeed).abs() < 1e-9);
}

#[test]
fn integrating_allocates_nothing() {
    let exchange = Exchange::flying(jet(), &[("gust.shape", 2.0), ("actuator.elevator.frequency", 20.0)]);
    let (mut x, mut rates) = (exchange.states(), exchange.rates());
    let cut = exchange.table.iter().find(|(_, row)| row.name == "loads.wing_root_right.bending");
    let outputs = [exchange.reference("load_factor.z"), exchange.reference("air.calibrated"), cut.unwrap().0];
    let mut values = [0.0; 3];
    let elevator = exchange.reference("elevator");
    let c = exchange.fmu.component;
    let before = allocation::allocations();
    for step in 0..20 {
        x[7] += 1e-4;
        let angle = 1e-3 * f64::from(step);
        // SAFETY: the component is alive, the arrays are as long as said.
        let statuses = unsafe {
            [
                fmi2SetTime(c, 0.01 * f64::from(step)),
                fmi2SetContinuousStates(c, x.as_ptr(), x.len()),
                fmi2SetReal(c, &elevator, 1, &angle),
                fmi2GetDerivatives(c, rates.as_mut_ptr(), rates.len()),
                fmi2GetReal(c, outputs.as_ptr(), 3, values.as_mut_ptr()),
            ]
        };
        assert_eq!(statuses, [Status::Ok; 5]);
    }
    assert_eq!(allocation::allocations(), before);
}

#[test]
fn a_saved_state_goes_on_with_the_same_bits_and_is_of_its_kind() {
    let values = [("actuator.elevator.frequency", 20.0), ("heading", 0.3)];
    let exchange = Exchange::flying(jet(), &values);
    exchange.set(&[("elevator", 0.02), ("wind_east", 3.0)]);
    exchange.step(0.0, 1e-3);
    let c = exchange.fmu.component;
    let (mut state, mut size) = (null_mut(), 0);
    let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    // SAFETY: the component is alive, the places are there, the state is of the component.
    let mut bytes = unsafe {
        assert_eq!(fmi2GetFMUstate(c, &mut state), Status::Ok);
        assert_eq!(fmi2SerializedFMUstateSize(c, state, &mut size), Status::Ok);
        let mut bytes: Vec<c_char> = vec![0; size];
        assert_eq!(fmi2SerializeFMUstate(c, state, bytes.as_mut_ptr(), size), Status::Ok);
        bytes
    };
    exchange.step(1e-3, 1e-3);
    let after = (bits(exchange.states()), bits(exchange.rates()));
    // In another instance with other parameters, too.
    let other = Exchange::flying(jet(), &[]);
    for target in [&exchange, &other] {
        let mut copy = null_mut();
        // SAFETY: as above.
        unsafe {
            let c = target.fmu.component;
            assert_eq!(fmi2DeSerializeFMUstate(c, bytes.as_ptr(), size, &mut copy), Status::Ok);
            assert_eq!(fmi2SetFMUstate(c, copy), Status::Ok, "{:?}", target.fmu.log);
            assert_eq!(fmi2FreeFMUstate(c, &mut copy), Status::Ok);
        }
        target.step(1e-3, 1e-3);
        assert_eq!((bits(target.states()), bits(target.rates())), after);
    }
    let flight = Fmu::flying();
    let mut copy = null_mut();
    // SAFETY: as above.
    unsafe {
        let status = fmi2DeSerializeFMUstate(flight.component, bytes.as_mut_ptr(), size, &mut copy);
        assert_eq!(status, Status::Error);
        assert_eq!(fmi2FreeFMUstate(c, &mut state), Status::Ok);
    }
    flight.assert_refused(&["it is of a model exchange FMU, and this is one for co-simulation"]);
}
