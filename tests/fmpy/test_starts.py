"""Archives with other starts and more stations: `flexair package --set` and `--stations-along`."""

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

    def package(*starts, stations_along=()):
        output = tmp_path_factory.mktemp("starts") / "FlexibleAircraft.fmu"
        settings = [f"--set={start}" for start in starts]
        settings += [f"--stations-along={stations}" for stations in stations_along]
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


def test_stations_along_a_wing_fly_and_bend_the_more_the_farther_out_they_are(package, fmu):
    wing, made = package(stations_along=["wing_right=20"])
    assert made.returncode == 0, made.stderr
    names = [f"deflection.wing_right_{number:02}.up" for number in range(1, 21)]
    known = {variable.name for variable in fmpy.read_model_description(wing).modelVariables}
    assert known >= set(names)
    shared = ["attitude.pitch", "load_factor.z", "deflection.wing_tip_right.up"]
    gust = {"gust.shape": 2, "gust.start": 0.1}
    flown, plain = (
        fmpy.simulate_fmu(str(path), stop_time=1.0, output_interval=0.01, start_values=gust, output=output)
        for path, output in [(wing, shared + names), (fmu, shared)]
    )
    for name in shared:
        assert np.array_equal(flown[name], plain[name])
    up = np.array([flown[name][-1] for name in names])
    assert np.all(np.diff(up[3:]) > 0) and 0 < up[-1] < flown["deflection.wing_tip_right.up"][-1]


def test_stations_along_a_component_are_refused_twice_and_on_none(package):
    for stations, reason in [
        (["wing_right=20", "wing_right=20"], 'found the name "wing_right_01" of a station that there is'),
        (["wing=20"], 'found component "wing", allowed are '),
        (["wing_right=0"], "found 0 stations along wing_right, allowed are 1 to 999"),
    ]:
        output, made = package(stations_along=stations)
        assert made.returncode != 0 and reason in made.stderr, made.stderr
        assert not output.exists()


def test_a_start_that_cannot_be_is_refused_and_nothing_is_written(package):
    for start, reason in [
        ("gust.gradient=0", "--set gust.gradient=0: found `0`, allowed is 0.01 to 1000000 m"),
        ("gust.shap=none", "did you mean `gust.shape`?"),
        ("elevator=0.1", "is an input"),
    ]:
        output, made = package(start)
        assert made.returncode != 0 and reason in made.stderr, made.stderr
        assert not output.exists()
