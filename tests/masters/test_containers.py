"""The aircraft inside of an FMU that another tool writes around it: importers in C and C++ that FMPy flies."""

import copy

import fmpy
import pytest
from fmpy.container_fmu.cli import create_container_fmu
from fmpy.container_fmu.config import Component, Configuration
from fmpy.model_description import ModelVariable

from flights import ENUMERATIONS, MANOEUVRE, PARAMETERS, STRAIGHT
from test_fmpy import signals

FLIGHTS = [STRAIGHT, MANOEUVRE, PARAMETERS, ENUMERATIONS]


def fly(container, description, flight, prefix=""):
    return fmpy.simulate_fmu(
        str(container),
        stop_time=flight.time[-1],
        output_interval=0.01,
        start_values={f"{prefix}{name}": value for name, value in flight.parameters.items()},
        input=signals(flight),
        output=list(description.outputs),
    )


@pytest.mark.parametrize("flight", FLIGHTS, ids=lambda flight: flight.name)
def test_it_flies_in_a_container_of_the_fmu_manipulation_toolbox(fmucontainer, description, agrees, flight):
    history = fly(fmucontainer, description, flight, prefix="flexibleaircraft.")
    agrees("FMU Manipulation Toolbox, container", flight, history)


@pytest.fixture(scope="session")
def fmpy_container(fmu, tmp_path_factory):
    """Written by FMPy; its importer has no enumerations, but their numbers pass as integers."""
    folder = tmp_path_factory.mktemp("fmpy_container")
    inside = fmpy.read_model_description(fmu)
    outside = copy.deepcopy(inside)
    outside.coSimulation.fixedInternalStepSize = 0.01
    for variable in outside.modelVariables:
        if variable.type == "Enumeration":
            variable.type, variable.declaredType = "Integer", None
    aircraft = Component("aircraft", fmu, inside)
    pairs = zip(outside.modelVariables, inside.modelVariables, strict=True)
    mappings = {outer: [(aircraft, inner)] for outer, inner in pairs}
    # The container's own time has the value reference 0.
    outside.modelVariables.insert(0, ModelVariable("time", 0, type="Real", causality="independent"))
    container = Configuration(False, outside, [aircraft], [], mappings)
    (folder / "unzipped").mkdir()
    create_container_fmu(container, folder / "unzipped", folder / "container.fmu")
    return folder / "container.fmu"


@pytest.mark.parametrize("flight", FLIGHTS, ids=lambda flight: flight.name)
def test_it_flies_in_a_container_of_fmpy(fmpy_container, description, agrees, flight):
    agrees("FMPy, container", flight, fly(fmpy_container, description, flight))
