"""ecospy (PyPI): Ecos, a C++ master; in its own process and with the aircraft in a process apart."""

import ctypes
import sys
from pathlib import Path

import pytest

# Ecos is linked against oneTBB, which its wheel does not bring and the wheel `tbb` does.
ctypes.CDLL(Path(sys.prefix) / "lib/libtbb.so.12")
import ecospy
from ecospy import EcosSimulation, EcosSimulationStructure

from flights import ENUMERATIONS, MANOEUVRE, PARAMETERS, STRAIGHT

BINARIES = Path(ecospy.__file__).parent / "binaries"


def fly(location, outputs, flight):
    with EcosSimulationStructure() as structure:
        structure.add_model("aircraft", location)
        parameters = {f"aircraft::{name}": value for name, value in flight.parameters.items()}
        structure.add_parameter_set("flight", parameters)
        with EcosSimulation(step_size=0.01, structure=structure) as simulation:
            assert simulation.init(0, "flight")
            history = {"time": []} | {name: [] for name in outputs}

            def record(time):
                history["time"].append(time)
                for name in outputs:
                    history[name].append(simulation.get_real(f"aircraft::{name}"))

            record(0.0)
            for point, time, length in flight.steps:
                for name, value in flight.inputs_at(point).items():
                    simulation.set_real(f"aircraft::{name}", value)
                assert simulation.step() == pytest.approx(time + length, rel=1e-9)
                record(time + length)
            simulation.terminate()
    return history


@pytest.mark.parametrize("flight", [STRAIGHT, MANOEUVRE, PARAMETERS], ids=lambda flight: flight.name)
def test_a_flight_is_that_of_the_rust_library(fmu, description, agrees, flight):
    agrees("ecospy", flight, fly(str(fmu), description.outputs, flight))


def test_the_aircraft_flies_in_a_process_apart(fmu, agrees, tmp_path, monkeypatch):
    """With few outputs: proxyfmu of Ecos 0.7.2 sometimes takes its client down when 80 and more are read."""
    # The wheel unpacks it without the right to be executed.
    (BINARIES / "proxyfmu").chmod(0o755)
    # It writes a log into the working directory.
    monkeypatch.chdir(tmp_path)
    location = f"proxyfmu://localhost?file={fmu}"
    outputs = ["attitude.pitch", "attitude.roll", "load_factor.z", "deflection.wing_tip_right.up", "modal.q[3]"]
    agrees("ecospy, proxyfmu", PARAMETERS, fly(location, outputs, PARAMETERS))


def test_ecos_has_no_enumerations(fmu):
    """It leaves them at their starts; a version that can set them makes this fail, and COMPATIBILITY.md wrong."""
    with EcosSimulationStructure() as structure:
        structure.add_model("aircraft", str(fmu))
        with EcosSimulation(step_size=0.01, structure=structure) as simulation:
            assert simulation.init(0)
            assert simulation.get_integer("aircraft::mode_count") == 12
            for name in ENUMERATIONS.parameters.keys() & {"model", "mode_family"}:
                with pytest.raises(Exception, match=f"No int property aircraft::{name} found"):
                    simulation.get_integer(f"aircraft::{name}")
