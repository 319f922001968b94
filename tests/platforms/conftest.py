"""What the tests of the FMU for several platforms share; packaging/build-platforms.sh writes it."""

import os
import subprocess
import sys
import xml.etree.ElementTree
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
C_OPTIONS = ["-std=gnu11", "-Wall", "-Wextra", "-Werror", "-I", ROOT / "fmi-headers"]
AMPLITUDES = {"rad": 0.02, "N": 500.0, "m/s": 1.0, "m/s2": 0.5}


@pytest.fixture(scope="session")
def unpacked(tmp_path_factory):
    """Folder of the unpacked FMU."""
    folder = tmp_path_factory.mktemp("unpacked")
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    zipfile.ZipFile(target / "platforms/FlexibleAircraft.fmu").extractall(folder)
    return folder


@pytest.fixture(scope="session")
def library(unpacked):
    """A function: the library of a platform, or the test is skipped."""

    def library(platform):
        files = list((unpacked / "binaries" / platform).glob("*"))
        if not files:
            pytest.skip(f"the FMU has no library for {platform}")
        [file] = files
        return file

    return library


@pytest.fixture(scope="session")
def flight_arguments(unpacked):
    """A function: what fly.c wants to be told after the library; `root` is how the platform names the root folder."""
    description = xml.etree.ElementTree.parse(unpacked / "modelDescription.xml").getroot()
    inputs, outputs = [], []
    for variable in description.find("ModelVariables"):
        reference = variable.get("valueReference")
        if variable.get("causality") == "input":
            inputs.append(f"{reference}:{AMPLITUDES[variable[0].get('unit')]}")
        elif variable.get("causality") == "output" and variable[0].tag == "Real":
            outputs.append(reference)
        elif variable.get("name") == "model":
            model = reference

    def arguments(root="/"):
        resources = "file:///" + root.lstrip("/") + str(unpacked / "resources").lstrip("/")
        return [description.get("guid"), resources, model, ",".join(inputs), ",".join(outputs)]

    return arguments


def zig_cc(target, source, output):
    """Compiles a C program for any platform."""
    command = [sys.executable, "-m", "ziglang", "cc", "-target", target, *C_OPTIONS, source, "-o", output, "-ldl"]
    subprocess.run(command, check=True)


@pytest.fixture(scope="session")
def linux64_flight(library, flight_arguments, tmp_path_factory):
    """What fly.c prints on linux64."""
    program = tmp_path_factory.mktemp("linux64") / "fly"
    zig_cc("x86_64-linux-gnu.2.17", ROOT / "tests/platforms/fly.c", program)
    return flight_of([program, library("linux64"), *flight_arguments()])


def flight_of(command, **options):
    """The lines that a flight prints."""
    flown = subprocess.run(command, stdout=subprocess.PIPE, text=True, timeout=600, **options)
    assert flown.returncode == 0
    return flown.stdout.splitlines()
