"""An importer in C of FMI 3.0 (tests/c/importer3.c), compiled against the official headers of FMPy's package."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import fmpy
import pytest
from fmpy.fmi3 import FMU3Slave

from conftest import ROOT

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the C importer loads with dlopen and reads /proc")

OUTPUTS = ["position.north", "attitude.pitch", "load_factor.z", "deflection.wing_tip_right.up", "modal.q[1]"]

class Archive:
    """One of FMI 3.0, unpacked."""

    def __init__(self, path, folder):
        self.description = fmpy.read_model_description(path)
        self.folder = Path(fmpy.extract(path, folder))
        self.references = {v.name: v.valueReference for v in self.description.modelVariables}

    @property
    def library(self):
        return self.folder / "binaries" / fmpy.platform_tuple / f"FlexibleAircraft{fmpy.sharedLibraryExtension}"


@pytest.fixture(scope="module")
def co_simulation(archive, tmp_path_factory):
    return Archive(archive(3, "co-simulation"), tmp_path_factory.mktemp("cs"))


@pytest.fixture(scope="module")
def model_exchange(archive, tmp_path_factory):
    return Archive(archive(3, "model-exchange"), tmp_path_factory.mktemp("me"))


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    program = tmp_path_factory.mktemp("c") / "importer3"
    official = Path(fmpy.__file__).parent / "c-code"
    compile_ = ["cc", "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-Wall", "-Wextra", "-Werror", "-g", "-I", official]
    subprocess.run([*compile_, ROOT / "tests/c/importer3.c", "-ldl", "-lm", "-o", program], check=True)
    return program


@pytest.fixture
def importer(program, tmp_path):
    """A function that runs the program in a folder of its own: what it prints, line by line."""

    def importer(command, archive, under=(), **environment):
        arguments = [archive.library, archive.description.instantiationToken, archive.folder / "resources"]
        arguments += [str(archive.references[name]) for name in ["elevator", *OUTPUTS]]
        run = subprocess.run(
            [*under, program, command, *arguments],
            cwd=tmp_path,
            env={**os.environ, "LC_ALL": "C", **environment},
            capture_output=True,
            text=True,
        )
        assert run.returncode == 0, run.stderr
        return [line.split()[0] for line in run.stdout.splitlines()]

    return importer


def numbers(bits):
    return [memoryview(bytes.fromhex(word)[::-1]).cast("d")[0] for word in bits]


def test_a_second_process_goes_on_from_the_bytes_of_the_first_bit_for_bit(importer, co_simulation):
    first = importer("fly", co_simulation)
    assert len(first) == len(OUTPUTS)
    assert importer("go-on", co_simulation) == first
    assert importer("fly", co_simulation) == first


def test_the_flight_has_the_bits_that_it_has_in_fmi_2(importer, co_simulation, unpacked, model_description, tmp_path):
    references = {v.name: v.valueReference for v in model_description.modelVariables}
    two = fmpy.instantiate_fmu(unpacked, model_description, "CoSimulation")
    two.setupExperiment(startTime=0.0)
    two.enterInitializationMode()
    two.exitInitializationMode()
    for i in range(40):
        two.setReal([references["elevator"]], [0.01 * (i % 5)])
        two.doStep(0.013 * i, 0.013)
    flown = two.getReal([references[name] for name in OUTPUTS])
    two.terminate()
    two.freeInstance()
    assert numbers(importer("fly", co_simulation)) == flown


def test_what_the_importer_integrates_is_what_the_fmu_flies(importer, co_simulation, model_exchange):
    description = co_simulation.description
    flight = FMU3Slave(
        guid=description.guid,
        unzipDirectory=str(co_simulation.folder),
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="beside",
    )
    references = [co_simulation.references[name] for name in OUTPUTS]
    flight.instantiate()
    flight.enterInitializationMode(startTime=0.0)
    flight.exitInitializationMode()
    peaks = [0.0] * len(references)
    for i in range(5):
        flight.setFloat64([co_simulation.references["elevator"]], [0.01 * (i % 5)])
        flight.doStep(0.01 * i, 0.01)
        flown = list(flight.getFloat64(references))
        peaks = [max(abs(x), peak) for x, peak in zip(flown, peaks)]
    # As after the last step of the importer: at the end of the stretch, with the input that acted in it.
    flight.terminate()
    flight.freeInstance()
    integrated = numbers(importer("integrate", model_exchange))
    for name, found, expected, peak in zip(OUTPUTS, integrated, flown, peaks):
        assert found == pytest.approx(expected, abs=1e-5 * peak), name


def test_instances_and_steps_take_no_memory(importer, co_simulation):
    importer("endure", co_simulation)


def test_valgrind_finds_neither_errors_nor_leaks(importer, co_simulation, model_exchange):
    if not shutil.which("valgrind"):
        pytest.skip("NOT TESTED: valgrind is not installed")
    valgrind = ["valgrind", "--error-exitcode=9", "--leak-check=full", "--errors-for-leak-kinds=definite,possible"]
    importer("fly", co_simulation, under=valgrind)
    importer("go-on", co_simulation, under=valgrind)
    importer("integrate", model_exchange, under=valgrind)
