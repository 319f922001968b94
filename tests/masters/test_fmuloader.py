"""fmuloader (PyPI): the C functions through ctypes, without any comfort, as a home-made master calls them."""

import pytest
from fmuloader.fmi2 import Fmi2Error, Fmi2Slave, Fmi2Type

from flights import ENUMERATIONS, IRREGULAR, MANOEUVRE, PARAMETERS, STORM, STRAIGHT, ramped


class Master:
    """One instance, trimmed and ready, that flies along a flight and remembers the outputs."""

    def __init__(self, fmu, description, flight, name="aircraft"):
        self.flight, self.variables, self.outputs = flight, description.variables, description.outputs
        self.history = {"time": [], **{output: [] for output in self.outputs}}
        self.slave = Fmi2Slave(fmu, model_identifier="FlexibleAircraft")
        self.slave.instantiate(name, Fmi2Type.CO_SIMULATION, guid=description.guid)
        self.slave.setup_experiment(start_time=float(flight.time[0]))
        self.slave.enter_initialization_mode()
        for parameter, value in flight.parameters.items():
            variable = self.variables[parameter]
            set_ = self.slave.set_real if variable.type == "Real" else self.slave.set_integer
            set_([variable.reference], [value])
        self.set_inputs(0)
        self.slave.exit_initialization_mode()
        self.record(flight.time[0])

    def set_inputs(self, point):
        if inputs := self.flight.inputs_at(point):
            references = [self.variables[name].reference for name in inputs]
            self.slave.set_real(references, list(inputs.values()))
            if self.flight.rates:
                rates = [float(self.flight.rates[name][point]) for name in inputs]
                self.slave.set_real_input_derivatives(references, [1] * len(rates), rates)

    def record(self, time):
        self.history["time"].append(time)
        for name, value in zip(self.outputs, self.slave.get_real(list(self.outputs.values()))):
            self.history[name].append(value)

    def step(self, index, time, length):
        self.set_inputs(index)
        self.slave.do_step(time, length)
        self.record(time + length)

    def fly(self):
        for step in self.flight.steps:
            self.step(*step)
        return self.history


@pytest.fixture
def master(fmu, description):
    """A function that makes a master; all are freed in the end."""
    masters = []

    def master(flight, name="aircraft"):
        masters.append(Master(fmu, description, flight, name))
        return masters[-1]

    yield master
    for made in masters:
        made.slave.terminate()
        made.slave.free_instance()


FLIGHTS = [STRAIGHT, MANOEUVRE, PARAMETERS, ENUMERATIONS, STORM, IRREGULAR, ramped(PARAMETERS), ramped(IRREGULAR)]


@pytest.mark.parametrize("flight", FLIGHTS, ids=lambda flight: flight.name)
def test_a_flight_is_that_of_the_rust_library(master, agrees, flight):
    agrees("fmuloader", flight, master(flight).fly())


def test_two_instances_of_one_name_fly_beside_each_other(master, agrees):
    """Step by step in turns, one linear and stiff, one exact."""
    flown = [master(PARAMETERS), master(STRAIGHT)]
    for steps in zip(*(aircraft.flight.steps for aircraft in flown), strict=True):
        for aircraft, step in zip(flown, steps):
            aircraft.step(*step)
    for aircraft in flown:
        agrees("fmuloader, two instances", aircraft.flight, aircraft.history)


def test_a_step_that_is_taken_back_leaves_no_trace(master, agrees):
    """Before every step another one, longer and with other inputs, is flown and taken back."""
    aircraft = master(PARAMETERS)
    slave, elevator = aircraft.slave, aircraft.variables["elevator"].reference
    for index, time, length in PARAMETERS.steps:
        state = slave.get_fmu_state()
        slave.set_real([elevator], [0.1])
        slave.do_step(time, 0.037)
        slave.set_fmu_state(state)
        slave.free_fmu_state(state)
        aircraft.step(index, time, length)
    agrees("fmuloader, steps taken back", PARAMETERS, aircraft.history)


def test_a_state_as_bytes_goes_on_in_another_instance(master, agrees):
    first, second = master(PARAMETERS), master(PARAMETERS, "another one")
    steps = list(PARAMETERS.steps)
    middle = len(steps) // 2
    for step in steps[:middle]:
        first.step(*step)
    state = first.slave.get_fmu_state()
    copy = second.slave.deserialize_fmu_state(first.slave.serialize_fmu_state(state))
    second.slave.set_fmu_state(copy)
    first.slave.free_fmu_state(state)
    second.slave.free_fmu_state(copy)
    second.history = first.history
    for step in steps[middle:]:
        second.step(*step)
    agrees("fmuloader, state as bytes", PARAMETERS, second.history)


def test_damaged_bytes_are_refused_and_the_flight_goes_on(master):
    aircraft = master(STRAIGHT)
    slave = aircraft.slave
    state = slave.get_fmu_state()
    good = slave.serialize_fmu_state(state)
    slave.free_fmu_state(state)
    for bad in [good[:-1], good[:-9] + bytes([good[-9] ^ 1]) + good[-8:], bytes(len(good))]:
        with pytest.raises(Fmi2Error):
            slave.deserialize_fmu_state(bad)
    slave.do_step(0.0, 0.01)
