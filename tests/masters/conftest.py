"""What the tests of the importers share. The FMU is the file named by the environment variable FMU."""

import json
import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from flights import deviation

ROOT = Path(__file__).parents[2]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
# The command line, built already if the environment says so.
FLEXAIR = ["cargo", "run", "--release", "--quiet", "--"]
if "FLEXAIR" in os.environ:
    FLEXAIR = [Path(os.environ["FLEXAIR"]).resolve()]
# Of a signal's peak.
TOLERANCE = 1e-9


@dataclass(frozen=True)
class Variable:
    reference: int
    type: str
    causality: str


@dataclass(frozen=True)
class Description:
    """What a simple importer reads from modelDescription.xml."""

    guid: str
    variables: dict[str, Variable]

    @property
    def outputs(self):
        """Value references by name, of those that are Real: what actuators say in Booleans is 0 while they are off."""
        return {name: v.reference for name, v in self.variables.items() if (v.causality, v.type) == ("output", "Real")}


@pytest.fixture(scope="session")
def fmu():
    """Path of the packaged FMU."""
    path = Path(os.environ.get("FMU", TARGET / "fmu/FlexibleAircraft.fmu")).resolve()
    assert path.is_file(), f"{path} does not exist: run `cargo run --release -- package`"
    return path


def describe(fmu):
    root = ElementTree.fromstring(zipfile.ZipFile(fmu).read("modelDescription.xml"))
    variables = {
        variable.get("name"): Variable(int(variable.get("valueReference")), variable[0].tag, variable.get("causality"))
        for variable in root.find("ModelVariables")
    }
    return Description(root.get("guid"), variables)


@pytest.fixture(scope="session")
def description(fmu):
    return describe(fmu)


@pytest.fixture(scope="session")
def stormy_fmu(tmp_path_factory):
    """An archive whose enumerations start as the storm needs them, for importers that set none."""
    output = tmp_path_factory.mktemp("stormy") / "FlexibleAircraft.fmu"
    starts = ["--set=gust.shape=one_minus_cosine", "--set=turbulence.spectrum=von_karman"]
    subprocess.run([*FLEXAIR, "package", "--no-check", "--output", output, *starts], cwd=ROOT, check=True)
    return output


@pytest.fixture(scope="session")
def fmucontainer(fmu, tmp_path_factory):
    """Written by fmucontainer, of the FMU Manipulation Toolbox."""
    folder = tmp_path_factory.mktemp("fmucontainer")
    content = {"name": "container.fmu", "step_size": 0.01, "auto_parameter": True, "fmu": [fmu.name]}
    (folder / "container.json").write_text(json.dumps(content))
    (folder / fmu.name).symlink_to(fmu)
    tool = Path(sys.executable).with_name("fmucontainer")
    subprocess.run([tool, "-container", "container.json", "-fmu-directory", "."], cwd=folder, check=True)
    return folder / "container.fmu"


@pytest.fixture(scope="session")
def reference(tmp_path_factory):
    """A function that has the Rust library fly a flight: all outputs at all communication points."""
    known = {}

    def reference(flight):
        if flight.name not in known:
            folder = tmp_path_factory.mktemp("reference")
            inputs, outputs = folder / "inputs.csv", folder / "outputs.csv"
            inputs.write_text(flight.csv())
            settings = [f"--set={name}={value!r}" for name, value in flight.parameters.items()]
            command = [*FLEXAIR, "simulate", inputs, "--output", outputs, *settings]
            subprocess.run(command, cwd=ROOT, check=True)
            history = np.genfromtxt(outputs, delimiter=",", names=True, deletechars="", replace_space=" ")
            assert len(history) == len(flight.time)
            known[flight.name] = history
        return known[flight.name]

    return reference


DEVIATIONS = []


@pytest.fixture
def agrees(reference):
    """A function that compares the history of an importer with that of the Rust library, and keeps the result."""

    def agrees(tool, flight, history):
        largest, name = deviation(history, reference(flight))
        DEVIATIONS.append({"tool": tool, "flight": flight.name, "deviation": largest, "signal": name})
        assert largest <= TOLERANCE, f"{tool}, {flight.name}: {name} deviates by {largest:.1e} of its peak"

    return agrees


def pytest_terminal_summary(terminalreporter):
    """The largest deviations, as COMPATIBILITY.md quotes them."""
    if not DEVIATIONS:
        return
    terminalreporter.section("largest deviations from the Rust library, in parts of each signal's peak")
    for found in DEVIATIONS:
        line = "{tool:42} {flight:26} {deviation:8.1e}  {signal}".format(**found)
        terminalreporter.write_line(line)
    path = TARGET / "masters.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(DEVIATIONS, indent=1) + "\n")
