//! Functions of which this FMU has no use: importers look for them, the life cycle refuses them with its reason.

use libc::{c_int, size_t};

use crate::fmi::operation::Operation;
use crate::fmi::pointers::on;
use crate::fmi3::types::{Clock, Instance, Status, ValueReference};

/// Functions that are refused in all states.
macro_rules! refused {
    ($($function:ident $operation:ident ($($argument:ident: $type:ty),*);)*) => {$(
        /// Refused, as the life cycle says.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(instance: Instance, $($argument: $type),*) -> Status {
            // SAFETY: instances as the module says.
            unsafe { on(instance, Operation::$operation, |_| Ok(())) }
        }
    )*};
}

refused! {
    fmi3EnterConfigurationMode EnterConfigurationMode ();
    fmi3ExitConfigurationMode ExitConfigurationMode ();
    fmi3EnterStepMode EnterStepMode ();
    fmi3GetOutputDerivatives GetRealOutputDerivatives (
        _references: *const ValueReference, _count: size_t, _orders: *const i32, _values: *mut f64, _value_count: size_t
    );
    fmi3GetAdjointDerivative GetAdjointDerivative (
        _unknowns: *const ValueReference, _unknown_count: size_t, _knowns: *const ValueReference, _known_count: size_t,
        _seed: *const f64, _seed_count: size_t, _sensitivity: *mut f64, _sensitivity_count: size_t
    );
    fmi3GetNumberOfVariableDependencies GetNumberOfVariableDependencies (
        _reference: ValueReference, _count: *mut size_t
    );
    fmi3GetVariableDependencies GetVariableDependencies (
        _dependent: ValueReference, _elements_of_dependent: *mut size_t, _independents: *mut ValueReference,
        _elements_of_independents: *mut size_t, _kinds: *mut c_int, _count: size_t
    );
    fmi3GetClock GetClock (_references: *const ValueReference, _count: size_t, _values: *mut Clock);
    fmi3SetClock SetClock (_references: *const ValueReference, _count: size_t, _values: *const Clock);
    fmi3GetIntervalDecimal GetIntervalDecimal (
        _references: *const ValueReference, _count: size_t, _intervals: *mut f64, _qualifiers: *mut c_int
    );
    fmi3GetIntervalFraction GetIntervalFraction (
        _references: *const ValueReference, _count: size_t, _counters: *mut u64, _resolutions: *mut u64,
        _qualifiers: *mut c_int
    );
    fmi3GetShiftDecimal GetShiftDecimal (_references: *const ValueReference, _count: size_t, _shifts: *mut f64);
    fmi3GetShiftFraction GetShiftFraction (
        _references: *const ValueReference, _count: size_t, _counters: *mut u64, _resolutions: *mut u64
    );
    fmi3SetIntervalDecimal SetIntervalDecimal (
        _references: *const ValueReference, _count: size_t, _intervals: *const f64
    );
    fmi3SetIntervalFraction SetIntervalFraction (
        _references: *const ValueReference, _count: size_t, _counters: *const u64, _resolutions: *const u64
    );
    fmi3SetShiftDecimal SetShiftDecimal (
        _references: *const ValueReference, _count: size_t, _shifts: *const f64
    );
    fmi3SetShiftFraction SetShiftFraction (
        _references: *const ValueReference, _count: size_t, _counters: *const u64, _resolutions: *const u64
    );
    fmi3ActivateModelPartition ActivateModelPartition (_clock: ValueReference, _time: f64);
}
