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


# Version of FMI and kind, as `flexair package --fmi … --kind …` takes them, and the archive.
ARCHIVES = {
    (2, "co-simulation"): "FlexibleAircraft.fmu",
    (3, "co-simulation"): "FlexibleAircraft.fmi3.fmu",
    (2, "model-exchange"): "FlexibleAircraft.me.fmu",
    (3, "model-exchange"): "FlexibleAircraft.fmi3.me.fmu",
}


@pytest.fixture(scope="session")
def archive(fmu):
    """A function that gives the path of the archive for a version and a kind, beside that of FMI 2.0 for co-simulation."""

    def archive(version, kind):
        path = fmu.with_name(ARCHIVES[version, kind])
        options = "--fmi 2 --fmi 3 --kind co-simulation --kind model-exchange --output target/fmu"
        assert path.is_file(), f"{path} does not exist: run `cargo run --release -- package {options}`"
        return path

    return archive


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
