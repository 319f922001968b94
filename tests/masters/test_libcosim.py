"""libcosimpy (PyPI): libcosim, the C++ master of the Open Simulation Platform."""

from dataclasses import replace

import pytest
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimManipulator import CosimManipulator
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

from conftest import describe
from flights import ENUMERATIONS, MANOEUVRE, PARAMETERS, STORM, STRAIGHT

STEP = 10_000_000  # ns


class Execution:
    """One aircraft under libcosim's fixed-step algorithm."""

    def __init__(self, fmu, description, flight):
        self.flight, self.variables, self.outputs = flight, description.variables, description.outputs
        self.execution = CosimExecution.from_step_size(STEP)
        # libcosim does not keep the slave alive.
        self.slave = CosimLocalSlave(str(fmu), "aircraft")
        self.index = self.execution.add_local_slave(self.slave)
        assert self.index == 0
        self.observer = CosimObserver.create_last_value()
        self.manipulator = CosimManipulator.create_override()
        assert self.execution.add_observer(self.observer)
        assert self.execution.add_manipulator(self.manipulator)
        for parameter, value in flight.parameters.items():
            variable = self.variables[parameter]
            is_real = variable.type == "Real"
            set_ = self.execution.real_initial_value if is_real else self.execution.integer_initial_value
            assert set_(self.index, variable.reference, value)

    def fly(self):
        history = {"time": [0.0]} | {name: [] for name in self.outputs}
        # libcosim initialises in its first step; the outputs at time 0 are not to be had.
        for point, time, length in self.flight.steps:
            for name, value in self.flight.inputs_at(point).items():
                reference = self.variables[name].reference
                assert self.manipulator.slave_real_values(self.index, [reference], [value])
            assert self.execution.step()
            history["time"].append(time + length)
            values = self.observer.last_real_values(self.index, list(self.outputs.values()))
            for name, value in zip(self.outputs, values):
                history[name].append(value)
        assert self.execution.status().current_time == round(1e9 * self.flight.time[-1])
        return history


def without_start(history, reference):
    """The history with the first values of the reference, which libcosim does not give."""
    return {name: [reference[name][0], *values] if name != "time" else values for name, values in history.items()}


@pytest.mark.parametrize("flight", [STRAIGHT, MANOEUVRE, PARAMETERS], ids=lambda flight: flight.name)
def test_a_flight_is_that_of_the_rust_library(fmu, description, reference, agrees, flight):
    history = Execution(fmu, description, flight).fly()
    agrees("libcosimpy", flight, without_start(history, reference(flight)))


def test_enumerations_that_start_as_needed_let_it_fly_through_a_storm(stormy_fmu, reference, agrees):
    description = describe(stormy_fmu)
    is_set = {
        name: value for name, value in STORM.parameters.items() if description.variables[name].type != "Enumeration"
    }
    history = Execution(stormy_fmu, description, replace(STORM, parameters=is_set)).fly()
    agrees("libcosimpy, package --set", STORM, without_start(history, reference(STORM)))


def test_libcosim_has_no_enumerations(fmu, description):
    """It leaves them at their starts; a version that can set them makes this fail, and COMPATIBILITY.md wrong."""
    execution = Execution(fmu, description, STRAIGHT)
    for name, value in ENUMERATIONS.parameters.items():
        variable = description.variables[name]
        if variable.type == "Enumeration":
            assert not execution.execution.integer_initial_value(execution.index, variable.reference, value)


def test_libcosim_sets_enumerations_as_integers_of_a_container(fmucontainer, reference, agrees):
    """Of the FMU Manipulation Toolbox."""
    parameters = {f"flexibleaircraft.{name}": value for name, value in ENUMERATIONS.parameters.items()}
    execution = Execution(fmucontainer, describe(fmucontainer), replace(ENUMERATIONS, parameters=parameters))
    history = without_start(execution.fly(), reference(ENUMERATIONS))
    agrees("libcosimpy, FMU Manipulation Toolbox", ENUMERATIONS, history)
