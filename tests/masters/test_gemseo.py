"""GEMSEO-FMU (PyPI): FMUs as disciplines of a multidisciplinary process. It writes parameters again before every step."""

import json
import os
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from conftest import TARGET
from flights import MANOEUVRE, PARAMETERS, STRAIGHT

# It pins an older FMPy than the other importers.
# Not resolved: the interpreter of an environment is a link out of it.
PYTHON = Path(os.environ.get("GEMSEO_PYTHON", TARGET / "venv-gemseo/bin/python")).absolute()
MISSING = "no GEMSEO-FMU: `bash tests/run.sh` installs tests/masters/requirements-gemseo.txt"
pytestmark = pytest.mark.skipif(not PYTHON.is_file(), reason=MISSING)


def fly(fmu, flight, outputs, folder):
    """The history after the first step on: GEMSEO gives no outputs before."""
    description, history = folder / "flight.json", folder / "history.json"
    inputs = {name: values.tolist() for name, values in flight.inputs.items()}
    content = {"time": flight.time.tolist(), "inputs": inputs, "parameters": flight.parameters, "outputs": outputs}
    description.write_text(json.dumps(content))
    script = Path(__file__).with_name("gemseo_flight.py")
    run = subprocess.run([PYTHON, script, fmu, description, history], capture_output=True, text=True, cwd=folder)
    assert run.returncode == 0, run.stderr
    return json.loads(history.read_text())


# It sets every variable as a Real, so that integers and enumerations stay at their starts.
REALS = {name: value for name, value in PARAMETERS.parameters.items() if isinstance(value, float)}
REAL_PARAMETERS = replace(PARAMETERS, name="real parameters", parameters=REALS)


@pytest.mark.parametrize("flight", [STRAIGHT, MANOEUVRE, REAL_PARAMETERS], ids=lambda flight: flight.name)
def test_a_flight_is_that_of_the_rust_library(fmu, description, reference, agrees, flight, tmp_path):
    flown = fly(fmu, flight, list(description.outputs), tmp_path)
    start = reference(flight)
    agrees("GEMSEO-FMU", flight, {name: [start[name][0], *values] for name, values in flown.items()})
