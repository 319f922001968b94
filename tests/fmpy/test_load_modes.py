"""An FMU packaged with load modes: it has a Boolean that switches them off."""

import subprocess

import fmpy
import numpy as np
import pytest
from fmpy.validation import validate_fmu

from conftest import ROOT


def package(folder, *options):
    output = folder / "wing.fmu"
    command = ["cargo", "run", "--release", "--quiet", "--", "package", "--modes", "3", "--no-check"]
    aircraft = ["--aircraft", ROOT / "aircraft/goland-wing.toml", "--output", output]
    subprocess.run([*command, *aircraft, *options], cwd=ROOT, check=True)
    return output


@pytest.fixture(scope="module")
def with_load_modes(tmp_path_factory):
    return package(tmp_path_factory.mktemp("with"), "--load-modes")


@pytest.fixture(scope="module")
def without(tmp_path_factory):
    return package(tmp_path_factory.mktemp("without"))


def test_the_parameter_is_a_boolean_that_starts_as_packaged(with_load_modes, without):
    variables = {v.name: v for v in fmpy.read_model_description(with_load_modes).modelVariables}
    switch = variables["load_modes"]
    assert (switch.type, switch.causality, switch.variability, switch.start) == ("Boolean", "parameter", "fixed", "true")
    assert variables["mode_count"].max == variables["mode_count"].start == "3"
    assert "a load mode" in variables["modal.q[4]"].description
    assert "load_modes" not in {v.name for v in fmpy.read_model_description(without).modelVariables}
    assert validate_fmu(str(with_load_modes)) == []


def test_switched_off_it_flies_the_bits_of_the_fmu_without(with_load_modes, without):
    wind = np.array([(0.0, 0.0), (0.1, -5.0)], dtype=[("time", float), ("wind_down", float)])

    def fly(fmu, parameters):
        outputs = ["modal.q[1]", "modal.q[3]"]
        flight = fmpy.simulate_fmu(
            str(fmu), stop_time=0.2, step_size=0.01, output_interval=0.01,
            start_values={"airspeed": 60.0, **parameters}, input=wind, output=outputs,
        )  # fmt: skip
        return [flight[name].tolist() for name in outputs]

    plain = fly(without, {})
    assert fly(with_load_modes, {"load_modes": False}) == plain
    assert fly(with_load_modes, {"load_modes": True}) == fly(with_load_modes, {}) != plain
