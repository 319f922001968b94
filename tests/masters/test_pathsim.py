"""PathSim-FMI (PyPI): FMUs as blocks of a block diagram in Python."""

import json
import subprocess
import sys

import numpy as np
import pathsim_fmi.blocks
import pytest
from pathsim import Connection, Simulation
from pathsim.blocks import Source
from pathsim_fmi import CoSimulationFMU
from pathsim_fmi.wrapper import FMUWrapper

from flights import ENUMERATIONS, MANOEUVRE, PARAMETERS, STRAIGHT


class RealFMU(FMUWrapper):
    """Without the outputs that are not Real: PathSim reads all as if they were, which the FMU refuses."""

    def _build_variable_maps(self):
        super()._build_variable_maps()
        self.output_refs = {name: ref for name, ref in self.output_refs.items() if self.variable_map[name].type == "Real"}


@pytest.fixture(autouse=True)
def real_outputs(monkeypatch):
    monkeypatch.setattr(pathsim_fmi.blocks, "FMUWrapper", RealFMU)


class Recorded(CoSimulationFMU):
    """The block with its outputs at the start and after every step."""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self.reached, self.rows = [0.0], [self.outputs.to_array()]

    def _step_fmu(self, t):
        super()._step_fmu(t)
        self.reached.append(t + self.dt)
        self.rows.append(self.outputs.to_array())


def fly(fmu, flight, outputs):
    aircraft = Recorded(str(fmu), start_values=flight.parameters, dt=0.01)
    sources = {
        name: Source(lambda t, values=values: float(values[min(round(t / 0.01), len(values) - 1)]))
        for name, values in flight.inputs.items()
    }
    connections = [Connection(source, aircraft[name]) for name, source in sources.items()]
    simulation = Simulation([aircraft, *sources.values()], connections, dt=0.01, log=False)
    simulation.run(flight.time[-1])
    # The event at the end begins one step more.
    points = len(flight.time)
    assert aircraft.reached[:points] == pytest.approx(flight.time.tolist(), rel=1e-9)
    rows = np.array(aircraft.rows[:points])
    return {name: rows[:, column] for column, name in enumerate(outputs)}


@pytest.mark.parametrize("flight", [STRAIGHT, MANOEUVRE, PARAMETERS], ids=lambda flight: flight.name)
def test_a_flight_is_that_of_the_rust_library(fmu, description, agrees, flight):
    agrees("PathSim-FMI", flight, fly(fmu, flight, description.outputs))


def test_pathsim_reads_booleans_as_reals(fmu):
    """A version that reads them as what they are makes this fail, and COMPATIBILITY.md wrong."""
    script = "import sys, pathsim_fmi; pathsim_fmi.CoSimulationFMU(sys.argv[1])"
    run = subprocess.run([sys.executable, "-c", script, str(fmu)], capture_output=True, text=True)
    assert run.returncode != 0 and "_limited" in run.stdout + run.stderr, run.stdout + run.stderr


def test_pathsim_has_no_enumerations(fmu):
    """A version that can set them makes this fail, and COMPATIBILITY.md wrong."""
    # In a process of its own: PathSim ends the instance that it could not set, and FMPy tells that to the logger of the last
    # flight of its own in the process, which is gone.
    script = "import sys, json, pathsim_fmi; pathsim_fmi.CoSimulationFMU(sys.argv[1], start_values=json.loads(sys.argv[2]))"
    command = [sys.executable, "-c", script, str(fmu), json.dumps(ENUMERATIONS.parameters)]
    run = subprocess.run(command, capture_output=True, text=True)
    assert "ValueError: Unsupported variable type: Enumeration" in run.stderr, run.stderr
