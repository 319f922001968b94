//! A Boolean parameter: whether load modes take part.

use super::surface::Saved;
use super::*;
use crate::aircraft::Aircraft;
use crate::structure::ReducedModel;

/// A cantilever wing of three natural modes, with load modes or without.
fn goland(load_modes: bool) -> ReducedModel {
    let text = include_str!("../../../aircraft/goland-wing.toml");
    let aircraft = Aircraft::parse(text, "goland-wing.toml").unwrap();
    ReducedModel::new(&Aircraft { load_modes, ..aircraft }, 3).unwrap()
}

/// An instance of such a wing, first in initialisation mode, and its variables.
struct Wing {
    fmu: Fmu,
    table: VariableTable,
}

impl Wing {
    fn new(load_modes: bool) -> Self {
        let model = goland(load_modes);
        let (unpacked, guid) = (Unpacked::of(&model.to_bytes(), "wing"), guid(&model));
        let fmu = endurance::wing(&unpacked, &guid);
        assert!(!fmu.component.is_null(), "{:?}", fmu.log);
        assert_eq!([fmu.set_up(None, 0.0, None), fmu.enter()], [Status::Ok; 2]);
        Wing { fmu, table: VariableTable::new(&model) }
    }

    fn load_modes(&self) -> u32 {
        self.table.reference("load_modes").unwrap()
    }

    fn set(&self, reference: u32, flag: c_int) -> Status {
        // SAFETY: the component is alive, the arrays have one element.
        unsafe { fmi2SetBoolean(self.fmu.component, &reference, 1, &flag) }
    }

    fn get(&self, reference: u32) -> Result<c_int, Status> {
        let mut flag = -1;
        // SAFETY: the component is alive, the arrays have one element.
        let status = unsafe { fmi2GetBoolean(self.fmu.component, &reference, 1, &mut flag) };
        if status == Status::Ok { Ok(flag) } else { Err(status) }
    }

    /// To the first communication point, then on in a wind from below.
    fn fly(&self) {
        let fmu = &self.fmu;
        assert_eq!(fmu.exit(), Status::Ok, "{:?}", fmu.log);
        let wind = self.table.reference("wind_down").unwrap();
        assert_eq!(fmu.set_references(&[wind], &[-5.0]), Status::Ok);
        assert_eq!(fmu.step(0.0, 0.05), Status::Ok);
    }

    /// All outputs that a wing of three modes has, bit for bit.
    fn outputs(&self) -> Vec<u64> {
        let is_common =
            |name: &str| !name.starts_with("modal.") || ["1]", "2]", "3]"].iter().any(|n| name.ends_with(n));
        let mut references = outputs_of(&self.table, Type::Real);
        references.retain(|reference| is_common(&self.table.get(*reference).unwrap().name));
        self.fmu.get_references(&references).unwrap().into_iter().map(f64::to_bits).collect()
    }
}

#[test]
fn load_modes_start_as_packaged_and_switched_off_leave_the_bits_of_an_fmu_without() {
    let [on, off, without] = [Wing::new(true), Wing::new(true), Wing::new(false)];
    assert_eq!(on.get(on.load_modes()), Ok(1));
    assert_eq!(off.set(off.load_modes(), 0), Status::Ok);
    assert_eq!(off.get(off.load_modes()), Ok(0));
    [&on, &off, &without].into_iter().for_each(Wing::fly);
    assert_eq!(off.outputs(), without.outputs());
    assert_ne!(on.outputs(), without.outputs());
    assert!(without.table.named("load_modes").is_none());
}

#[test]
fn whatever_is_not_zero_is_true_and_reads_as_one() {
    let wing = Wing::new(true);
    for (flag, read) in [(0, 0), (7, 1), (0, 0), (-1, 1)] {
        assert_eq!((wing.set(wing.load_modes(), flag), wing.get(wing.load_modes())), (Status::Ok, Ok(read)));
    }
}

#[test]
fn saved_states_keep_whether_load_modes_take_part() {
    let (wing, flown) = (Wing::new(true), Wing::new(true));
    assert_eq!(wing.set(wing.load_modes(), 0), Status::Ok);
    let before = Saved::of(&wing.fmu);
    assert_eq!((wing.set(wing.load_modes(), 1), wing.get(wing.load_modes())), (Status::Ok, Ok(1)));
    assert_eq!((before.restore(), wing.get(wing.load_modes())), (Status::Ok, Ok(0)));
    drop(before);
    wing.fly();
    let bytes = Saved::of(&wing.fmu).bytes();
    let saved = Saved::from_bytes(&flown.fmu, &bytes).unwrap();
    assert_eq!((saved.restore(), flown.get(flown.load_modes())), (Status::Ok, Ok(0)));
    drop(saved);
    for wing in [&wing, &flown] {
        assert_eq!(wing.fmu.step(0.05, 0.05), Status::Ok);
    }
    assert_eq!(wing.outputs(), flown.outputs());
}

#[test]
fn a_boolean_is_no_number_no_number_a_boolean_and_in_flight_it_is_fixed() {
    let wing = Wing::new(true);
    let reference = wing.load_modes();
    assert_eq!(wing.fmu.get_references(&[reference]), Err(Status::Error));
    wing.fmu.assert_refused(&["`load_modes` is a Boolean, not a Real"]);
    // SAFETY: the component is alive, the arrays have one element.
    assert_eq!(unsafe { fmi2SetInteger(wing.fmu.component, &reference, 1, &1) }, Status::Error);
    wing.fmu.assert_refused(&["`load_modes` is a Boolean, not an Integer"]);
    for (number, variable) in wing.table.iter().filter(|(_, variable)| variable.kind != Type::Boolean) {
        assert_eq!((wing.get(number), wing.set(number, 1)), (Err(Status::Error), Status::Error));
        wing.fmu.assert_refused(&[&format!("`{}`", variable.name), "not a Boolean"]);
    }
    wing.fly();
    assert_eq!((wing.set(reference, 1), wing.set(reference, 0)), (Status::Ok, Status::Error));
    wing.fmu.assert_refused(&["`load_modes`", "fixed"]);
}
