"""Archives whose parameters start elsewhere: `flexair package --set`."""

import os
import subprocess
from pathlib import Path

import fmpy
import numpy as np
import pytest

ROOT = Path(__file__).parents[2]
FLEXAIR = ["cargo", "run", "--release", "--quiet", "--"]
if "FLEXAIR" in os.environ:
    FLEXAIR = [Path(os.environ["FLEXAIR"]).resolve()]


@pytest.fixture(scope="session")
def package(tmp_path_factory):
    """A function that packages the jet with parameters that start elsewhere."""

    def package(*starts):
        output = tmp_path_factory.mktemp("starts") / "FlexibleAircraft.fmu"
        settings = [f"--set={start}" for start in starts]
        return output, subprocess.run(
            [*FLEXAIR, "package", "--no-check", "--output", output, *settings], cwd=ROOT, capture_output=True, text=True
        )

    return package


def test_a_tolerance_is_that_of_the_default_experiment_too(package, fmu):
    """Importers hand over the default experiment's tolerance unasked; the tighter of it and the parameter counts."""
    loose, made = package("tolerance=1e-3")
    assert made.returncode == 0, made.stderr
    outputs = ["tolerance", "attitude.pitch"]
    assert fmpy.read_model_description(loose).defaultExperiment.tolerance == "0.001"
    for path, tolerance in [(loose, 1e-3), (fmu, 1e-5)]:
        flown = fmpy.simulate_fmu(str(path), stop_time=0.1, output=outputs)
        assert flown["tolerance"][-1] == tolerance


def test_a_gust_that_starts_switched_on_flies_without_being_set(package, fmu):
    gusty, made = package("gust.shape=one_minus_cosine", "gust.peak=8", "gust.start=0.2")
    assert made.returncode == 0, made.stderr
    output = ["load_factor.z", "gust.peak_velocity"]
    as_packaged = fmpy.simulate_fmu(str(gusty), stop_time=1.5, output_interval=0.01, output=output)
    set_ = {"gust.shape": 2, "gust.peak": 8.0, "gust.start": 0.2}
    as_set = fmpy.simulate_fmu(str(fmu), stop_time=1.5, output_interval=0.01, start_values=set_, output=output)
    assert np.array_equal(as_packaged, as_set)
    assert as_set["gust.peak_velocity"][0] == 8.0 and np.ptp(as_set["load_factor.z"]) > 0.3


def test_a_start_that_cannot_be_is_refused_and_nothing_is_written(package):
    for start, reason in [
        ("gust.gradient=0", "--set gust.gradient=0: found `0`, allowed is 0.01 m and above"),
        ("gust.shap=none", "did you mean `gust.shape`?"),
        ("elevator=0.1", "is an input"),
    ]:
        output, made = package(start)
        assert made.returncode != 0 and reason in made.stderr, made.stderr
        assert not output.exists()
