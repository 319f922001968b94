"""The archive of FMI 3.0 for co-simulation in the importers that speak it, and containers that they write around it."""

import json
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
import zipfile
from dataclasses import dataclass
from pathlib import Path

import fmpy
import pytest
from fmuloader.fmi3 import Fmi3Error, Fmi3Slave

from flights import ENUMERATIONS, IRREGULAR, MANOEUVRE, PARAMETERS, STORM, STRAIGHT
from test_fmpy import signals

FLIGHTS = [STRAIGHT, MANOEUVRE, PARAMETERS, ENUMERATIONS, STORM]


@dataclass(frozen=True)
class Description:
    token: str
    references: dict[str, int]
    types: dict[str, str]
    outputs: dict[str, int]


@pytest.fixture(scope="module")
def fmu3(fmu):
    """Path of the archive."""
    path = fmu.with_name("FlexibleAircraft.fmi3.fmu")
    options = "--fmi 2 --fmi 3 --kind co-simulation --kind model-exchange --output target/fmu"
    assert path.is_file(), f"{path} does not exist: run `cargo run --release -- package {options}`"
    return path


@pytest.fixture(scope="module")
def description3(fmu3):
    root = ElementTree.fromstring(zipfile.ZipFile(fmu3).read("modelDescription.xml"))
    rows = list(root.find("ModelVariables"))
    references = {row.get("name"): int(row.get("valueReference")) for row in rows}
    types = {row.get("name"): row.tag for row in rows}
    is_output = [row.get("name") for row in rows if (row.tag, row.get("causality")) == ("Float64", "output")]
    return Description(root.get("instantiationToken"), references, types, {n: references[n] for n in is_output})


@pytest.mark.parametrize("flight", FLIGHTS, ids=lambda flight: flight.name)
def test_fmpy_flies_fmi_3_as_the_rust_library(fmu3, description3, agrees, flight):
    history = fmpy.simulate_fmu(
        str(fmu3),
        stop_time=flight.time[-1],
        output_interval=0.01,
        start_values=flight.parameters,
        input=signals(flight),
        output=list(description3.outputs),
    )
    agrees("FMPy, FMI 3.0", flight, history)


@pytest.fixture(scope="module", params=["2", "3"])
def container(request, fmu3, tmp_path_factory):
    """Written by fmucontainer around the archive, itself of FMI 2.0 or of 3.0."""
    folder = tmp_path_factory.mktemp(f"fmucontainer-{request.param}")
    content = {"name": "container.fmu", "step_size": 0.01, "auto_parameter": True, "fmu": ["FlexibleAircraft.fmu"]}
    (folder / "container.json").write_text(json.dumps(content))
    (folder / "FlexibleAircraft.fmu").symlink_to(fmu3)
    tool = Path(sys.executable).with_name("fmucontainer")
    options = ["-container", "container.json", "-fmu-directory", ".", "-fmi", request.param]
    subprocess.run([tool, *options], cwd=folder, check=True)
    return folder / "container.fmu"


@pytest.mark.parametrize("flight", [STRAIGHT, MANOEUVRE, PARAMETERS], ids=lambda flight: flight.name)
def test_it_flies_in_containers_of_the_fmu_manipulation_toolbox(container, description3, agrees, flight):
    history = fmpy.simulate_fmu(
        str(container),
        stop_time=flight.time[-1],
        output_interval=0.01,
        start_values={f"flexibleaircraft.{name}": value for name, value in flight.parameters.items()},
        input=signals(flight),
        output=list(description3.outputs),
    )
    agrees("FMU Manipulation Toolbox, container of FMI 3.0", flight, history)


class Master:
    """One instance that flies along a flight and remembers the outputs."""

    def __init__(self, fmu3, description, flight):
        self.description, self.flight = description, flight
        self.history = {"time": [], **{output: [] for output in description.outputs}}
        self.slave = Fmi3Slave(fmu3, model_identifier="FlexibleAircraft")
        self.slave.instantiate_co_simulation("aircraft", instantiation_token=description.token)
        self.slave.enter_initialization_mode(start_time=float(flight.time[0]))
        setters = {"Float64": "set_float64", "Int32": "set_int32", "Enumeration": "set_int64", "Boolean": "set_boolean"}
        for name, value in flight.parameters.items():
            set_ = getattr(self.slave, setters[description.types[name]])
            set_([description.references[name]], [value])
        self.set_inputs(0)
        self.slave.exit_initialization_mode()
        self.record(flight.time[0])

    def set_inputs(self, point):
        if inputs := self.flight.inputs_at(point):
            self.slave.set_float64([self.description.references[name] for name in inputs], list(inputs.values()))

    def record(self, time):
        self.history["time"].append(time)
        values = self.slave.get_float64(list(self.description.outputs.values()))
        for name, value in zip(self.description.outputs, values):
            self.history[name].append(value)

    def step(self, index, time, length):
        self.set_inputs(index)
        self.slave.do_step(time, length)
        self.record(time + length)

    def end(self):
        self.slave.terminate()
        self.slave.free_instance()


@pytest.fixture
def master(fmu3, description3):
    masters = []

    def master(flight):
        masters.append(Master(fmu3, description3, flight))
        return masters[-1]

    yield master
    for made in masters:
        made.end()


@pytest.mark.parametrize("flight", [*FLIGHTS, IRREGULAR], ids=lambda flight: flight.name)
def test_fmuloader_flies_fmi_3_as_the_rust_library(master, agrees, flight):
    aircraft = master(flight)
    for step in flight.steps:
        aircraft.step(*step)
    agrees("fmuloader, FMI 3.0", flight, aircraft.history)


def test_a_step_that_is_taken_back_leaves_no_trace(master, agrees):
    aircraft = master(PARAMETERS)
    slave, elevator = aircraft.slave, aircraft.description.references["elevator"]
    for index, time, length in PARAMETERS.steps:
        state = slave.get_fmu_state()
        slave.set_float64([elevator], [0.1])
        slave.do_step(time, 0.037)
        slave.set_fmu_state(state)
        slave.free_fmu_state(state)
        aircraft.step(index, time, length)
    agrees("fmuloader, FMI 3.0, steps taken back", PARAMETERS, aircraft.history)


def test_what_has_no_meaning_is_refused_and_a_saved_state_leads_back(master):
    aircraft = master(STRAIGHT)
    slave = aircraft.slave
    state = slave.get_fmu_state()
    for refused in [slave.enter_step_mode, slave.enter_event_mode, slave.enter_configuration_mode]:
        with pytest.raises(Fmi3Error):
            refused()
        slave.set_fmu_state(state)
    slave.free_fmu_state(state)
    slave.do_step(0.0, 0.01)
