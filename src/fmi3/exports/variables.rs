//! Getting and setting variables, and derivatives of some by others.

use std::mem::MaybeUninit;

use libc::size_t;

use super::check_count;
use crate::fmi::instance;
use crate::fmi::operation::Operation;
use crate::fmi::pointers::{Outcome, array, array_to_fill, on};
use crate::fmi::values::Numbers;
use crate::fmi3::types::{Binary, Boolean, CString, FALSE, Instance, Status, ValueReference};
use crate::variables::Value;

/// Reads variables.
///
/// # Safety
/// Instances and arrays as the module says.
unsafe fn get<T: Copy>(
    instance: Instance,
    (operation, numbers): (Operation, Numbers),
    (references, count): (*const ValueReference, size_t),
    (values, value_count): (*mut T, size_t),
    number: impl Fn(Value) -> Option<T>,
) -> Status {
    let body = |instance: &mut instance::Instance| {
        check_count(value_count, count, "nValues")?;
        // SAFETY: arrays by the caller.
        let (references, places): (_, &mut [MaybeUninit<T>]) = unsafe {
            (array(references, count, "valueReferences")?, array_to_fill(values, value_count, "values")?)
        };
        instance.get(numbers, references, |i, value| {
            if let Some(number) = number(value) {
                places[i].write(number);
            }
        })
    };
    // SAFETY: instances by the caller.
    unsafe { on(instance, operation, body) }
}

/// Sets variables.
///
/// # Safety
/// Instances and arrays as the module says.
unsafe fn set<T: Copy>(
    instance: Instance,
    (operation, numbers): (Operation, Numbers),
    (references, count): (*const ValueReference, size_t),
    (values, value_count): (*const T, size_t),
    value: impl Fn(T) -> Value + Clone,
) -> Status {
    let body = |instance: &mut instance::Instance| {
        check_count(value_count, count, "nValues")?;
        // SAFETY: arrays by the caller.
        let (references, values) =
            unsafe { (array(references, count, "valueReferences")?, array(values, value_count, "values")?) };
        instance.set(numbers, references, values.iter().map(|number| value(*number)))
    };
    // SAFETY: instances by the caller.
    unsafe { on(instance, operation, body) }
}

/// Values of Float64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFloat64(
    instance: Instance,
    references: *const ValueReference,
    count: size_t,
    values: *mut f64,
    value_count: size_t,
) -> Status {
    let number = |value| if let Value::Real(x) = value { Some(x) } else { None };
    let asked = (Operation::GetReal, Numbers::Real);
    // SAFETY: instances and arrays as the module says.
    unsafe { get(instance, asked, (references, count), (values, value_count), number) }
}

/// Values of Int32.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetInt32(
    instance: Instance,
    references: *const ValueReference,
    count: size_t,
    values: *mut i32,
    value_count: size_t,
) -> Status {
    let number = |value| if let Value::Integer(i) = value { Some(i) } else { None };
    let asked = (Operation::GetInteger, Numbers::Integer);
    // SAFETY: instances and arrays as the module says.
    unsafe { get(instance, asked, (references, count), (values, value_count), number) }
}

/// Values of Enumerations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetInt64(
    instance: Instance,
    references: *const ValueReference,
    count: size_t,
    values: *mut i64,
    value_count: size_t,
) -> Status {
    let number = |value| if let Value::Integer(i) = value { Some(i64::from(i)) } else { None };
    let asked = (Operation::GetInt64, Numbers::Enumeration);
    // SAFETY: instances and arrays as the module says.
    unsafe { get(instance, asked, (references, count), (values, value_count), number) }
}

/// Values of Booleans.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetBoolean(
    instance: Instance,
    references: *const ValueReference,
    count: size_t,
    values: *mut Boolean,
    value_count: size_t,
) -> Status {
    let number = |value| if let Value::Boolean(flag) = value { Some(Boolean::from(flag)) } else { None };
    let asked = (Operation::GetBoolean, Numbers::Boolean);
    // SAFETY: instances and arrays as the module says.
    unsafe { get(instance, asked, (references, count), (values, value_count), number) }
}

/// Sets Float64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFloat64(
    instance: Instance,
    references: *const ValueReference,
    count: size_t,
    values: *const f64,
    value_count: size_t,
) -> Status {
    let asked = (Operation::SetReal, Numbers::Real);
    // SAFETY: instances and arrays as the module says.
    unsafe { set(instance, asked, (references, count), (values, value_count), Value::Real) }
}

/// Sets Int32.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetInt32(
    instance: Instance,
    references: *const ValueReference,
    count: size_t,
    values: *const i32,
    value_count: size_t,
) -> Status {
    let asked = (Operation::SetInteger, Numbers::Integer);
    // SAFETY: instances and arrays as the module says.
    unsafe { set(instance, asked, (references, count), (values, value_count), Value::Integer) }
}

/// Sets Enumerations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetInt64(
    instance: Instance,
    references: *const ValueReference,
    count: size_t,
    values: *const i64,
    value_count: size_t,
) -> Status {
    // An item beyond all numbers is none, and is refused as any other that is not there.
    let item = |i: i64| Value::Integer(i32::try_from(i).unwrap_or(if i < 0 { i32::MIN } else { i32::MAX }));
    let asked = (Operation::SetInt64, Numbers::Enumeration);
    // SAFETY: instances and arrays as the module says.
    unsafe { set(instance, asked, (references, count), (values, value_count), item) }
}

/// Sets Booleans; whatever is not 0 is true.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetBoolean(
    instance: Instance,
    references: *const ValueReference,
    count: size_t,
    values: *const Boolean,
    value_count: size_t,
) -> Status {
    let flag = |flag: Boolean| Value::Boolean(flag != FALSE);
    let asked = (Operation::SetBoolean, Numbers::Boolean);
    // SAFETY: instances and arrays as the module says.
    unsafe { set(instance, asked, (references, count), (values, value_count), flag) }
}

/// Refuses all variables, for none has the type.
///
/// # Safety
/// Instances and arrays as the module says.
unsafe fn none_of(
    instance: Instance,
    (operation, name): (Operation, &'static str),
    (references, count): (*const ValueReference, size_t),
) -> Status {
    let body = |instance: &mut instance::Instance| -> Outcome {
        // SAFETY: arrays by the caller.
        let references = unsafe { array(references, count, "valueReferences") }?;
        instance.get(Numbers::OfNone(name), references, |_, _| {})
    };
    // SAFETY: instances by the caller.
    unsafe { on(instance, operation, body) }
}

/// Getting and setting of a type that no variable has.
macro_rules! of_none {
    ($($get:ident $set:ident $getting:ident $setting:ident $type:ty, $name:literal;)*) => {$(
        /// No variable has this type.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get(
            instance: Instance,
            references: *const ValueReference,
            count: size_t,
            _values: *mut $type,
            _value_count: size_t,
        ) -> Status {
            // SAFETY: instances and arrays as the module says.
            unsafe { none_of(instance, (Operation::$getting, $name), (references, count)) }
        }

        /// No variable has this type.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set(
            instance: Instance,
            references: *const ValueReference,
            count: size_t,
            _values: *const $type,
            _value_count: size_t,
        ) -> Status {
            // SAFETY: instances and arrays as the module says.
            unsafe { none_of(instance, (Operation::$setting, $name), (references, count)) }
        }
    )*};
}

of_none! {
    fmi3GetFloat32 fmi3SetFloat32 GetFloat32 SetFloat32 f32, "a Float32";
    fmi3GetInt8 fmi3SetInt8 GetInt8 SetInt8 i8, "an Int8";
    fmi3GetUInt8 fmi3SetUInt8 GetUInt8 SetUInt8 u8, "a UInt8";
    fmi3GetInt16 fmi3SetInt16 GetInt16 SetInt16 i16, "an Int16";
    fmi3GetUInt16 fmi3SetUInt16 GetUInt16 SetUInt16 u16, "a UInt16";
    fmi3GetUInt32 fmi3SetUInt32 GetUInt32 SetUInt32 u32, "a UInt32";
    fmi3GetUInt64 fmi3SetUInt64 GetUInt64 SetUInt64 u64, "a UInt64";
    fmi3GetString fmi3SetString GetString SetString CString, "a String";
}

/// No variable is a Binary.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetBinary(
    instance: Instance,
    references: *const ValueReference,
    count: size_t,
    _value_sizes: *mut size_t,
    _values: *mut Binary,
    _value_count: size_t,
) -> Status {
    // SAFETY: instances and arrays as the module says.
    unsafe { none_of(instance, (Operation::GetBinary, "a Binary"), (references, count)) }
}

/// No variable is a Binary.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetBinary(
    instance: Instance,
    references: *const ValueReference,
    count: size_t,
    _value_sizes: *const size_t,
    _values: *const Binary,
    _value_count: size_t,
) -> Status {
    // SAFETY: instances and arrays as the module says.
    unsafe { none_of(instance, (Operation::SetBinary, "a Binary"), (references, count)) }
}

/// How unknowns change along a direction of knowns.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetDirectionalDerivative(
    instance: Instance,
    unknowns: *const ValueReference,
    unknown_count: size_t,
    knowns: *const ValueReference,
    known_count: size_t,
    seed: *const f64,
    seed_count: size_t,
    sensitivity: *mut f64,
    sensitivity_count: size_t,
) -> Status {
    let body = |instance: &mut instance::Instance| {
        check_count(seed_count, known_count, "nSeed")?;
        check_count(sensitivity_count, unknown_count, "nSensitivity")?;
        // SAFETY: arrays as the module says.
        let (unknowns, knowns, seed, places) = unsafe {
            (
                array(unknowns, unknown_count, "unknowns")?,
                array(knowns, known_count, "knowns")?,
                array(seed, seed_count, "seed")?,
                array_to_fill(sensitivity, sensitivity_count, "sensitivity")?,
            )
        };
        for (place, derivative) in places.iter_mut().zip(instance.derivatives(unknowns, knowns, seed)?) {
            place.write(derivative);
        }
        Ok(())
    };
    // SAFETY: instances as the module says.
    unsafe { on(instance, Operation::GetDirectionalDerivative, body) }
}
