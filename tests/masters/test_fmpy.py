"""FMPy (PyPI): its own master with its own interpolation of inputs, its command line, its logger."""

import subprocess
import sys

import fmpy
import numpy as np
import pytest

from flights import ENUMERATIONS, MANOEUVRE, PARAMETERS, STRAIGHT

FLIGHTS = [STRAIGHT, MANOEUVRE, PARAMETERS, ENUMERATIONS]


def signals(flight):
    """The structured array that FMPy wants."""
    if not flight.inputs:
        return None
    columns = {"time": flight.time, **flight.inputs}
    table = np.zeros(len(flight.time), dtype=[(name, float) for name in columns])
    for name, values in columns.items():
        table[name] = values
    return table


@pytest.mark.parametrize("flight", FLIGHTS, ids=lambda flight: flight.name)
def test_a_flight_is_that_of_the_rust_library(fmu, description, agrees, flight):
    history = fmpy.simulate_fmu(
        str(fmu),
        validate=True,
        stop_time=flight.time[-1],
        output_interval=0.01,
        start_values=flight.parameters,
        input=signals(flight),
        output=list(description.outputs),
    )
    agrees("FMPy", flight, history)


def test_the_command_line_simulates_from_a_file(fmu, description, agrees, tmp_path):
    inputs, outputs = tmp_path / "inputs.csv", tmp_path / "outputs.csv"
    inputs.write_text(PARAMETERS.csv())
    values = [text for name, value in PARAMETERS.parameters.items() for text in (name, repr(value))]
    command = [sys.executable, "-m", "fmpy", "simulate", fmu, "--validate", "--stop-time", "5"]
    command += ["--output-interval", "0.01", "--input-file", inputs, "--output-file", outputs]
    command += ["--start-values", *values, "--output-variables", *description.outputs]
    subprocess.run(command, check=True)
    history = np.genfromtxt(outputs, delimiter=",", names=True, deletechars="")
    agrees("FMPy, command line", PARAMETERS, history)
