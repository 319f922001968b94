"""fmi-sim (crates.io), which is slow to build: flown if tests/masters/rust-importers.sh has been run."""

import subprocess

import numpy as np
import pytest

from conftest import TARGET
from flights import MANOEUVRE, STRAIGHT

FMI_SIM = TARGET / "masters/fmi-sim-0.7.0/bin/fmi-sim"
MISSING = "no fmi-sim: `bash tests/masters/rust-importers.sh` builds it, which takes minutes"


@pytest.mark.skipif(not FMI_SIM.is_file(), reason=MISSING)
@pytest.mark.parametrize("flight", [STRAIGHT, MANOEUVRE], ids=lambda flight: flight.name)
def test_fmi_sim_flies_as_the_rust_library(fmu, agrees, flight, tmp_path):
    """It cannot set parameters from its command line."""
    inputs, outputs = tmp_path / "inputs.csv", tmp_path / "outputs.csv"
    inputs.write_text(flight.csv())
    command = [FMI_SIM, "--model", fmu, "--output-file", outputs, *(["--input-file", inputs] if flight.inputs else [])]
    experiment = ["co-simulation", "--output-interval", "0.01", "-f", str(flight.time[-1])]
    subprocess.run([*command, *experiment], check=True, stdout=subprocess.DEVNULL)
    history = np.genfromtxt(outputs, delimiter=",", names=True, deletechars="")
    agrees("fmi-sim", flight, history)
