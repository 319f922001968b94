//! Which variables random calls ask for: mostly those of which the function knows something.

use proptest::prelude::*;
use proptest::sample::select;
use proptest::strategy::Union;

use crate::fmi::Interface;
use crate::fmi::operation::Operation;
use crate::fmi2::tests::*;
use crate::variables::{ArchiveTable, Place};

/// The value references of one aircraft, by what can be asked of their variables.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pools {
    inputs: Vec<u32>,
    parameters: Vec<u32>,
    outputs: Vec<u32>,
    states: Vec<u32>,
    rates: Vec<u32>,
    times: Vec<u32>,
    integers: Vec<u32>,
    enumerations: Vec<u32>,
    booleans: Vec<u32>,
}

impl Pools {
    pub fn of(interface: Interface, model: &ReducedModel) -> Self {
        let table = ArchiveTable::new(model, &starts::usual(interface, model), interface.extent());
        let states = table.states().iter().map(|(_, reference)| *reference).collect();
        let mut pools = Pools { states, rates: table.rates().collect(), ..Pools::default() };
        for (reference, row) in table.iter() {
            let pool = match (row.kind, row.slot) {
                (Type::Integer, _) => &mut pools.integers,
                (Type::Enumeration(_), _) => &mut pools.enumerations,
                (Type::Boolean, _) => &mut pools.booleans,
                (Type::Real, Place::Common(Slot::Input(_))) => &mut pools.inputs,
                (Type::Real, Place::Common(Slot::Parameter(_))) => &mut pools.parameters,
                (Type::Real, Place::Common(Slot::Output(_))) => &mut pools.outputs,
                (Type::Real, Place::Time) => &mut pools.times,
                (Type::Real, Place::State(_) | Place::Rate(_)) => continue,
            };
            pool.push(reference);
        }
        pools
    }

    /// For a function that reads or writes variables.
    pub fn wanted_by(&self, function: Operation) -> BoxedStrategy<u32> {
        use Operation as O;
        match function {
            O::SetReal | O::SetRealInputDerivatives => {
                self.mixed(&[(120, &self.inputs), (6, &self.parameters), (6, &self.states), (1, &self.times)])
            }
            O::GetReal => self.mixed(&[
                (60, &self.outputs),
                (15, &self.inputs),
                (15, &self.parameters),
                (15, &self.states),
                (15, &self.rates),
                (5, &self.times),
            ]),
            O::GetDirectionalDerivative => {
                self.mixed(&[(90, &self.outputs), (30, &self.rates), (1, &self.inputs)])
            }
            O::GetInteger | O::SetInteger => self.mixed(&[(60, &self.integers), (6, &self.enumerations)]),
            O::GetInt64 | O::SetInt64 => self.mixed(&[(60, &self.enumerations), (3, &self.integers)]),
            O::GetBoolean | O::SetBoolean => self.mixed(&[(60, &self.booleans)]),
            _ => self.all(),
        }
    }

    /// What derivatives are by.
    pub fn knowns(&self) -> BoxedStrategy<u32> {
        self.mixed(&[(90, &self.inputs), (30, &self.states), (3, &self.parameters)])
    }

    /// Whatever there is.
    pub fn all(&self) -> BoxedStrategy<u32> {
        self.mixed(&[
            (9, &self.inputs),
            (3, &self.parameters),
            (9, &self.outputs),
            (3, &self.states),
            (3, &self.rates),
            (1, &self.integers),
            (1, &self.enumerations),
            (1, &self.booleans),
            (1, &self.times),
        ])
    }

    /// Of some pools, so often as their weights say, and some that hardly exist.
    fn mixed(&self, pools: &[(u32, &Vec<u32>)]) -> BoxedStrategy<u32> {
        let stray = prop_oneof![
            any::<u32>(),
            0..400_u32,
            1_000_000..1_000_003_u32,
            2_000_000..2_001_000_u32,
            3_000_000..3_001_000_u32
        ];
        let some = pools.iter().filter(|(_, pool)| !pool.is_empty());
        let arms = some.map(|(weight, pool)| (*weight, select((*pool).clone()).boxed()));
        Union::new_weighted(arms.chain([(1, stray.boxed())]).collect()).boxed()
    }
}
