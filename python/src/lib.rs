//! The native part of the Python package `flexair`: the command, and its commands as calls that answer with arrays.
//!
//! What calls are for people, with names and types, is written in Python beside it.

use std::ffi::OsString;
use std::panic::resume_unwind;
use std::path::PathBuf;
use std::time::Duration;

use flexair::answer::Answer;
use flexair::calls::{self, Failure};
use flexair::home::Home;
use flexair::progress::Audience;
use num_complex::Complex64;
use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::exceptions::{PyException, PyKeyboardInterrupt};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyList, PyString};

pyo3::create_exception!(
    flexair,
    Error,
    PyException,
    "What was asked for cannot be done; the message is that of the command."
);
pyo3::create_exception!(
    flexair,
    UsageError,
    Error,
    "The arguments are not right; the message is that of the command line."
);

/// Between two looks at whether Ctrl-C was pressed.
const PERIOD: Duration = Duration::from_millis(5);

/// The program: does what a command line asks for, the program's name first, and returns what it should end with.
#[pyfunction]
fn command(py: Python<'_>, arguments: Vec<OsString>, data: PathBuf) -> u8 {
    py.detach(|| flexair::command(arguments, &Home::with_data(data)))
}

/// What a command finds, by names. Other threads of Python run meanwhile; Ctrl-C ends the work at its next step.
#[pyfunction]
fn call<'py>(
    py: Python<'py>,
    arguments: Vec<OsString>,
    table: Option<Vec<u8>>,
    data: PathBuf,
    progress: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let audience = Audience::new(progress);
    let worker = {
        let audience = audience.clone();
        std::thread::spawn(move || {
            calls::call(&arguments, table.as_deref(), &Home::with_data(data), &audience)
        })
    };
    let mut signal = Ok(());
    while signal.is_ok() && !worker.is_finished() {
        py.detach(|| std::thread::sleep(PERIOD));
        signal = py.check_signals();
    }
    if signal.is_err() {
        audience.leave();
    }
    let answer = py.detach(|| worker.join());
    signal?;
    match answer {
        Ok(Ok(answer)) => python(py, answer),
        Ok(Err(Failure::Usage(message))) => Err(UsageError::new_err(message)),
        Ok(Err(Failure::Command(message))) => Err(Error::new_err(message)),
        Ok(Err(failure @ Failure::Left)) => Err(PyKeyboardInterrupt::new_err(failure.to_string())),
        Err(panic) => resume_unwind(panic),
    }
}

/// The names of the aircraft that come with the package, and their files.
#[pyfunction]
fn aircraft(data: PathBuf) -> Vec<(String, PathBuf)> {
    let home = Home::with_data(data);
    let file = |name: String| {
        let file = home.aircraft_file(&name);
        (name, file)
    };
    home.aircraft_names().into_iter().map(file).collect()
}

/// An answer as Python has it: arrays of NumPy, texts and lists of texts, dictionaries.
fn python(py: Python<'_>, answer: Answer) -> PyResult<Bound<'_, PyAny>> {
    Ok(match answer {
        Answer::Text(text) => PyString::new(py, &text).into_any(),
        Answer::Number(number) => PyFloat::new(py, number).into_any(),
        Answer::Texts(texts) => PyList::new(py, texts)?.into_any(),
        Answer::Truths(truths) => PyArray1::from_vec(py, truths).into_any(),
        Answer::Counts(counts) => {
            PyArray1::from_iter(py, counts.into_iter().map(|count| count as i64)).into_any()
        }
        Answer::Numbers(numbers) => PyArray1::from_vec(py, numbers).into_any(),
        Answer::Matrix { rows, columns, values } => matrix(py, [rows, columns], values)?,
        Answer::Complex { rows, columns, values } => {
            let values = values.into_iter().map(|[re, im]| Complex64::new(re, im)).collect();
            matrix(py, [rows, columns], values)?
        }
        Answer::Members(members) => {
            let dictionary = PyDict::new(py);
            for (name, value) in members {
                dictionary.set_item(name, python(py, value)?)?;
            }
            dictionary.into_any()
        }
    })
}

/// Numbers, row by row.
fn matrix<T: Element>(py: Python<'_>, shape: [usize; 2], values: Vec<T>) -> PyResult<Bound<'_, PyAny>> {
    Ok(PyArray1::from_vec(py, values).reshape(shape)?.into_any())
}

/// What Python imports.
#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(command, module)?)?;
    module.add_function(wrap_pyfunction!(call, module)?)?;
    module.add_function(wrap_pyfunction!(aircraft, module)?)?;
    module.add("Error", module.py().get_type::<Error>())?;
    module.add("UsageError", module.py().get_type::<UsageError>())
}
