"""FMPy (PyPI): its own master with its own interpolation of inputs, its command line, its logger."""

import shutil
import subprocess
import sys
from ctypes import byref

import fmpy
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException, calloc, free
from fmpy.fmi2 import (
    FMU2Slave,
    defaultCallbacks,
    fmi2CallbackAllocateMemoryTYPE,
    fmi2CallbackFreeMemoryTYPE,
    fmi2CallbackFunctions,
    fmi2CallbackLoggerTYPE,
    fmi2Error,
    printLogMessage,
)
from fmpy.logging import addLoggerProxy

from flights import ENUMERATIONS, MANOEUVRE, PARAMETERS, STORM, STRAIGHT

FLIGHTS = [STRAIGHT, MANOEUVRE, PARAMETERS, ENUMERATIONS, STORM]


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


class Log:
    """An instance whose messages are kept, through a callback of ctypes that takes no variadic arguments."""

    def __init__(self, fmu, name, logging_on):
        self.messages = []
        self.folder = fmpy.extract(str(fmu))
        guid = fmpy.read_model_description(str(fmu)).guid
        self.slave = FMU2Slave(
            instanceName=name, guid=guid, modelIdentifier="FlexibleAircraft", unzipDirectory=self.folder
        )
        self.callbacks = fmi2CallbackFunctions()
        self.callbacks.logger = fmi2CallbackLoggerTYPE(self.log)
        self.callbacks.allocateMemory = fmi2CallbackAllocateMemoryTYPE(calloc)
        self.callbacks.freeMemory = fmi2CallbackFreeMemoryTYPE(free)
        self.slave.instantiate(callbacks=self.callbacks, loggingOn=logging_on)

    def log(self, environment, instance, status, category, message):
        self.messages.append((instance.decode(), status, category.decode(), message.decode()))

    def fly(self):
        self.slave.setupExperiment()
        self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()
        self.slave.doStep(0.0, 0.01)

    def close(self):
        self.slave.freeInstance()
        shutil.rmtree(self.folder)


@pytest.fixture
def log(fmu):
    logs = []

    def log(name="aircraft", logging_on=True):
        logs.append(Log(fmu, name, logging_on))
        return logs[-1]

    yield log
    for made in logs:
        made.close()


@pytest.fixture
def proxy():
    """FMPy's native proxy, of which a process has one: it goes back to FMPy's own logger, for it keeps the address of the latest."""
    yield addLoggerProxy
    defaultCallbacks.logger = fmi2CallbackLoggerTYPE(printLogMessage)
    addLoggerProxy(byref(defaultCallbacks))


def test_messages_arrive_as_finished_text(log, description):
    listener = log(name="100 %s/%n of C:\\aircraft")
    listener.fly()
    with pytest.raises(FMICallException):
        listener.slave.setReal([description.variables["elevator"].reference], [float("nan")])
    assert {instance for instance, *_ in listener.messages} == {"100 %s/%n of C:\\aircraft"}
    texts = [message for *_, message in listener.messages]
    assert texts[0].startswith("instantiated the aircraft `")
    assert any(text.startswith("trimmed: pitch 0.14") for text in texts)
    assert listener.messages[-1][1:3] == (fmi2Error, "logStatusError")
    assert "elevator" in texts[-1] and "NaN" in texts[-1]
    # Nothing is left for the callback to put in: a single % would take an argument that is not there.
    assert all("%" not in text.replace("%%", "") for text in texts)


def test_user_text_with_percent_signs_is_shown_and_harmless(log, proxy):
    """The guid comes back in a message; FMPy's native proxy, printf's kind, has the last word on it."""
    listener = log()
    slave = listener.slave
    with pytest.raises(Exception, match="Failed to instantiate"):
        wrong = FMU2Slave(
            instanceName="wrong", guid="%n%s%s", modelIdentifier="FlexibleAircraft", unzipDirectory=slave.unzipDirectory
        )
        wrong.instantiate(callbacks=listener.callbacks)
    assert "%%n%%s%%s" in listener.messages[-1][3]
    proxy(byref(listener.callbacks))
    with pytest.raises(Exception, match="Failed to instantiate"):
        wrong.instantiate(callbacks=listener.callbacks)
    assert "`%n%s%s`" in listener.messages[-1][3]


def test_categories_are_honoured(log, fmu):
    declared = [category.name for category in fmpy.read_model_description(str(fmu)).logCategories]
    assert declared == ["logEvents", "logStatusWarning", "logStatusError", "logStatusFatal", "logAll"]
    silent, errors_only = log(logging_on=False), log()
    errors_only.slave.setDebugLogging(True, ["logStatusError"])
    before = len(errors_only.messages)
    silent.fly()
    errors_only.fly()
    assert silent.messages == [] and len(errors_only.messages) == before
    for listener in [silent, errors_only]:
        with pytest.raises(FMICallException):
            listener.slave.doStep(5.0, 0.01)
        # Errors are told even when logging is off: the reason is needed most by who did not expect it.
        assert listener.messages[-1][2] == "logStatusError"
