"""Masters make of the closed loops what the Rust program makes of them."""

import sys

import fmpy.ssp.simulation
import numpy as np
import pytest
from fmpy.ssp.ssd import Parameter, ParameterSet

from conftest import EXAMPLES, LAWS

sys.path.insert(0, str(EXAMPLES))
import closed_loop  # noqa: E402

OUTPUTS = [
    "attitude.pitch",
    "rate.y",
    "load_factor.z",
    "air.speed",
    "deflection.wing_tip_right.up",
    "station.wing_tip_right.specific_force.z",
    "surface.elevator",
    "surface.aileron_symmetric",
]


def libcosim(system, law):
    """Histories from time 0 on."""
    history = closed_loop.fly(system, [f"aircraft.{name}" for name in OUTPUTS], closed=True)
    return {name.removeprefix("aircraft."): values for name, values in history.items()}


def fmpy_ssp(system, law):
    """Histories from the end of the first step on. FMPy does not read the parameters that an SSP brings along."""
    duration = LAWS[law][1]
    parameters = [Parameter(name="gust.duration", type="Real", value=str(duration))] if duration else []
    start = ParameterSet(name="start", parameters=parameters)
    rows = fmpy.ssp.simulation.simulate_ssp(str(system), stop_time=15.0, step_size=0.01, parameter_set=start)
    return {"time": rows["time"] + 0.01} | {name: rows[f"aircraft.{name}"] for name in OUTPUTS}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("master, kind", [(libcosim, "ssp"), (libcosim, "osp"), (fmpy_ssp, "ssp")])
def test_the_closed_loop_is_that_of_rust(system, in_rust, law, master, kind):
    ssp, osp = system(law)
    found, expected = master(ssp if kind == "ssp" else osp, law), in_rust(law)
    first = round(found["time"][0] / 0.01)
    samples = min(len(found["time"]), len(expected["time"]) - first)
    assert samples >= 1500
    np.testing.assert_allclose(found["time"][:samples], expected["time"][first:][:samples], atol=1e-9)
    for name in OUTPUTS:
        difference = np.abs(found[name][:samples] - expected[name][first:][:samples]).max()
        assert difference <= 1e-9 * np.abs(expected[name]).max(), name


GAINS = {
    "pitch_attitude_hold": {"pitch_gain": 8.0, "integral_gain": 0.8, "rate_gain": 4.0},
    "gust_load_alleviation": {"gain": 0.05},
}


@pytest.mark.parametrize("law", LAWS)
def test_twice_the_gain_is_still_stable(write_system, tmp_path, law):
    """What moves after the gust has died down by 12 s."""
    settings = [f"law.{name}={value}" for name, value in GAINS[law].items()]
    history = libcosim(write_system(law, tmp_path, settings)[0], law)
    late = history["time"] > 12.0
    for surface in ["surface.elevator", "surface.aileron_symmetric"]:
        assert np.ptp(history[surface][late]) < 0.02, surface


def test_the_hold_keeps_the_pitch_angle(in_rust):
    """Within 1.5 degrees through a gust that pitches the free aircraft by 4, and back within 0.05."""
    free, held = (in_rust("pitch_attitude_hold", *how)["attitude.pitch"] for how in (["open"], []))
    deviation = lambda pitch: np.abs(np.degrees(pitch - pitch[0]))
    assert deviation(free).max() > 4.0
    assert deviation(held).max() < 1.5
    assert deviation(held)[-1] < 0.05


def test_the_alleviation_takes_load_off_the_wing(in_rust):
    """An eighth off the peak of the wing tip's deflection from trim, a seventh off that of its acceleration."""
    free, alleviated = (in_rust("gust_load_alleviation", *how) for how in (["open"], []))
    for name, share in [("deflection.wing_tip_right.up", 0.88), ("station.wing_tip_right.specific_force.z", 0.85)]:
        peak = lambda flight: np.abs(flight[name] - flight[name][0]).max()
        assert peak(alleviated) < share * peak(free), name
    late = alleviated["time"] > 12.0
    assert np.ptp(alleviated["surface.aileron_symmetric"][late]) < 0.01
