"""What all tests of the packaged FMU share. The FMU is the file named by the environment variable FMU."""

import os
from pathlib import Path

import fmpy
import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="session")
def fmu():
    """Path of the packaged FMU."""
    path = Path(os.environ.get("FMU", ROOT / "target/fmu/FlexibleAircraft.fmu"))
    assert path.is_file(), f"{path} does not exist: run `cargo run --release -- package`"
    return path


@pytest.fixture(scope="session")
def model_description(fmu):
    return fmpy.read_model_description(fmu)


@pytest.fixture(scope="session")
def unpacked(fmu, tmp_path_factory):
    """Folder of the unpacked FMU."""
    return fmpy.extract(fmu, tmp_path_factory.mktemp("unpacked"))


@pytest.fixture(scope="session")
def fly(unpacked, model_description):
    """A function that simulates the FMU: parameters, input signals, outputs wanted; 10 ms communication steps."""

    def fly(stop_time, output, parameters=None, input=None):
        return fmpy.simulate_fmu(
            unpacked,
            model_description=model_description,
            stop_time=stop_time,
            step_size=0.01,
            output_interval=0.01,
            start_values=parameters or {},
            input=input,
            output=output,
        )

    return fly
