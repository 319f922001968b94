"""The examples print what FMPy flies with the packaged FMU, to all digits that they print."""

import os
import re
import subprocess
import sys
from math import cos, pi, sin
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Slave

from conftest import ROOT

STEP = 0.01
WING_TIP = "deflection.wing_tip_right.up"
PULSE = ("attitude.pitch", "load_factor.z", WING_TIP)


def example(name, *arguments):
    """What an example in Rust prints; the folder named by the environment variable EXAMPLES has it."""
    program = Path(os.environ.get("EXAMPLES", ROOT / "target/checked/examples")).absolute() / name
    assert program.is_file(), f"{program} does not exist: run `cargo build --release --examples`"
    command = [program, *map(str, arguments)]
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout


def numbers(text):
    return [float(number) for number in re.findall(r"(?<![\w.])[+-]?\d+\.\d+", text)]


class Aircraft:
    """The FMU in FMPy, by names of variables, stepped by 10 ms; Reals alone."""

    def __init__(self, unpacked, description, **parameters):
        self.number = {variable.name: variable.valueReference for variable in description.modelVariables}
        identifier = description.coSimulation.modelIdentifier
        self.fmu = FMU2Slave(
            guid=description.guid, unzipDirectory=unpacked, modelIdentifier=identifier, instanceName="jet"
        )
        self.fmu.instantiate()
        self.fmu.setupExperiment(startTime=0.0)
        self.set(**parameters)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()
        self.steps = 0

    def set(self, **values):
        self.fmu.setReal([self.number[name] for name in values], list(values.values()))

    def get(self, *names):
        return self.fmu.getReal([self.number[name] for name in names])

    def step(self):
        self.fmu.doStep(currentCommunicationPoint=STEP * self.steps, communicationStepSize=STEP)
        self.steps += 1

    def end(self):
        self.fmu.terminate()
        self.fmu.freeInstance()


@pytest.fixture
def fly_fmu(unpacked, model_description):
    """A function that begins a flight of the FMU with some parameters."""
    flights = []

    def fly_fmu(**parameters):
        flights.append(Aircraft(unpacked, model_description, **parameters))
        return flights[-1]

    yield fly_fmu
    for flight in flights:
        flight.end()


def pulse(aircraft):
    """The elevator pulse that the short examples fly: outputs every half second for 4 s."""
    rows = []
    for step in range(400):
        aircraft.set(elevator=-0.02 if step < 150 else 0.0)
        aircraft.step()
        if step % 50 == 49:
            rows.append(aircraft.get(*PULSE))
    return np.array(rows)


def test_fly_by_names(fly_fmu):
    printed = example("fly")
    fmu = fly_fmu(airspeed=140.0, stiffness_scale=0.3)
    at_trim = ("trim.pitch", "trim.elevator", "trim.thrust", WING_TIP)
    expected = [("trim", at_trim, fmu.get(*at_trim))]
    expected += [(f"after {0.5 * (i + 1):g} s", PULSE, row) for i, row in enumerate(pulse(fmu))]
    sections = re.split(r"\n(?=after)", printed)
    assert len(sections) == len(expected) == 9
    for section, (head, names, values) in zip(sections, expected):
        assert head == "trim" or section.splitlines()[0] == head
        for name, value in zip(names, values):
            [found] = re.findall(rf"^ *{re.escape(name)} +([+-]?[\d.]+) ", section, re.MULTILINE)
            assert float(found) == pytest.approx(value, abs=1e-6), f"{name} {head}"
    assert re.search(r"attitude\.pitch +\S+ rad +3-2-1 Euler angle pitch", printed)
    assert int(printed.split()[0]) == len(fmu.number)


@pytest.mark.skipif(sys.platform != "linux", reason="a library is linked otherwise elsewhere")
def test_fly_in_c(fly_fmu, unpacked, tmp_path):
    source, library = ROOT / "examples/fly.c", Path(unpacked) / "binaries/linux64/FlexibleAircraft.so"
    flags = ["-std=c11", "-Wall", "-Wextra", "-Werror", "-I", ROOT / "fmi-headers"]
    subprocess.run(["cc", *flags, source, library, "-o", tmp_path / "fly"], check=True)
    run = subprocess.run([tmp_path / "fly", unpacked], check=True, capture_output=True, text=True)
    assert_prints_the_pulse(run.stdout, fly_fmu())
    refused = subprocess.run([tmp_path / "fly", tmp_path], capture_output=True, text=True)
    assert refused.returncode == 1 and "absolute path" in refused.stderr


def test_fly_in_python_without_a_master(fly_fmu, fmu):
    # Isolated: without the packages of this environment's user, and without the folder of the tests.
    command = [sys.executable, "-I", "-S", ROOT / "examples/fly_without_master.py", fmu]
    run = subprocess.run(command, check=True, capture_output=True, text=True)
    assert_prints_the_pulse(run.stdout, fly_fmu())


def test_fly_in_python_without_an_fmu_says_how_it_is_called():
    command = [sys.executable, "-I", "-S", ROOT / "examples/fly_without_master.py"]
    for arguments in ([], [ROOT / "README.md"]):
        run = subprocess.run([*command, *arguments], capture_output=True, text=True)
        assert run.returncode == 1 and run.stderr.startswith("usage: fly_without_master.py FMU"), run.stderr


def assert_prints_the_pulse(printed, aircraft):
    rows = [numbers(line) for line in printed.splitlines()]
    assert [row[0] for row in rows] == [0.5 * (i + 1) for i in range(8)]
    assert np.array(rows)[:, 1:] == pytest.approx(pulse(aircraft), abs=1e-6)
    assert re.fullmatch(r"0\.5 s  pitch \S+ rad  load factor \S+  wing tip \S+ m up", printed.splitlines()[0])


def test_a_control_law_in_a_loop(fly_fmu):
    printed = [numbers(line) for line in example("control_law").splitlines()[1:]]
    open_, held = fly_fmu(), fly_fmu()
    [trim] = held.get("attitude.pitch")
    expected = []
    for step in range(1000):
        time = STEP * step
        angle = 2 * pi * min(max((time - 1) / 2, 0), 1)
        gust = {"wind_down": -5 * (1 - cos(angle)), "wind_rate_down": -10 * pi / 2 * sin(angle)}
        pitch, rate = held.get("attitude.pitch", "rate.y")
        elevator = 4 * (pitch - trim) + 2 * rate
        held.set(elevator=elevator, **gust)
        open_.set(**gust)
        open_.step()
        held.step()
        if step % 100 == 99:
            departures = [flight.get("attitude.pitch")[0] - trim for flight in (open_, held)]
            expected.append([time + STEP, *departures, elevator])
    assert np.array(printed) == pytest.approx(np.array(expected), abs=1e-6)
    largest_open, largest_held = np.abs(printed).max(axis=0)[1:3]
    assert largest_held < 0.5 * largest_open


def random_numbers(seed):
    """SplitMix64, as numbers from 0 to 1."""
    mask = (1 << 64) - 1
    while True:
        seed = (seed + 0x9E3779B97F4A7C15) & mask
        mixed = ((seed ^ (seed >> 30)) * 0xBF58476D1CE4E5B9) & mask
        mixed = ((mixed ^ (mixed >> 27)) * 0x94D049BB133111EB) & mask
        yield ((mixed ^ (mixed >> 31)) >> 11) / 2**53


def test_many_gusts_from_one_snapshot_are_flights_from_the_beginning_whatever_the_threads(fly_fmu):
    runs = 8
    printed = example("monte_carlo", runs, 1)
    assert example("monte_carlo", runs, 3) == example("monte_carlo", runs, 100) == printed
    watched = ("load_factor.z", WING_TIP)
    extremes = []
    for run in range(runs):
        random = random_numbers(run)
        peak, length = -15 + 30 * next(random), 2 * (9 + 98 * next(random))
        duration, history, fmu = length / 127.0, [], fly_fmu()
        for step in range(400):
            angle = 2 * pi * min(STEP * step / duration, 1)
            fmu.set(wind_down=0.5 * peak * (1 - cos(angle)), wind_rate_down=peak * pi / duration * sin(angle))
            fmu.step()
            history.append(fmu.get(*watched))
        extremes.append([np.min(history, axis=0), np.max(history, axis=0)])
    # By variable, then lowest and highest.
    values = np.sort(np.array(extremes), axis=0).transpose(2, 1, 0).reshape(4, runs)
    places = [int((runs - 1) * part + 0.5) for part in (0.05, 0.5, 0.95)]
    rows = [numbers(line) for line in printed.splitlines()[2:]]
    assert np.array(rows) == pytest.approx(values[:, places], abs=1e-5)
    assert [line.split()[0] for line in printed.splitlines()[2:]] == [name for name in watched for _ in range(2)]
    assert [line.split()[-1] for line in printed.splitlines()[2:]] == ["1", "1", "m", "m"]
