"""The aircraft in flight, by FMPy."""

import fmpy
import numpy as np
import pytest

from signals import doublet, signal, two_three_one_one

EXACT, CONSISTENTLY_LINEARISED, INCONSISTENT, RUTHLESSLY_LINEARISED, RIGID = range(1, 6)
SYMMETRIC = 2  # of the enumeration mode_family


def test_fmpy_simulates_the_default_experiment(fmu):
    result = fmpy.simulate_fmu(str(fmu))
    assert result["time"][-1] == pytest.approx(15.0)
    assert np.ptp(result["attitude.pitch"]) < 1e-6


def test_without_inputs_it_stays_trimmed_for_a_minute(fly):
    outputs = ["attitude.pitch", "position.down", "position.east", "trim.pitch"]
    result = fly(60.0, outputs)
    assert np.abs(result["attitude.pitch"] - result["trim.pitch"]).max() < 1e-6
    assert np.abs(result["position.down"] + 7620.0).max() < 0.01
    assert np.abs(result["position.east"]).max() < 1e-6


def test_a_2_3_1_1_of_the_elevator_moves_it_as_it_should(fly):
    """Nose-up first: 0.05 rad for 1.4 s pitch the jet (short period 1.2 rad/s) by a few degrees."""
    outputs = ["attitude.pitch", "load_factor.z", "deflection.wing_tip_right.up", "deflection.wing_tip_left.up"]
    result = fly(15.0, outputs, input=signal(15.0, elevator=lambda t: two_three_one_one(t, -0.05)))
    time = result["time"]
    pitch = result["attitude.pitch"] - result["attitude.pitch"][0]
    first_pulse, second_pulse = (time > 1) & (time < 2.4), (time > 3) & (time < 4.5)
    assert np.abs(pitch[time < 1]).max() < 1e-6
    assert 0.005 < pitch[first_pulse].max() < 0.1
    # Along −z of the body, which leans back by the pitch angle.
    assert result["load_factor.z"][0] == pytest.approx(np.cos(result["attitude.pitch"][0]), abs=1e-6)
    assert 1.02 < result["load_factor.z"][first_pulse].max() < 1.5
    assert 0.5 < result["load_factor.z"][second_pulse].min() < 0.98
    tip = result["deflection.wing_tip_right.up"]
    assert tip[first_pulse].max() > tip[0] + 0.01 and tip.max() < 1.0
    assert np.abs(tip - result["deflection.wing_tip_left.up"]).max() < 1e-9


EVEN = ["position.north", "position.down", "attitude.pitch", "velocity.x", "velocity.z", "rate.y", "load_factor.z"]
ODD = ["position.east", "attitude.roll", "attitude.yaw", "velocity.y", "rate.x", "rate.z", "load_factor.y"]


def test_a_mirrored_rudder_gives_the_mirrored_flight(fly):
    tips = ["deflection.wing_tip_right.up", "deflection.wing_tip_left.up"]

    def flight(amplitude):
        return fly(15.0, EVEN + ODD + tips, input=signal(15.0, rudder=lambda t: doublet(t, amplitude)))

    right, left = flight(0.05), flight(-0.05)
    assert np.abs(right["attitude.yaw"]).max() > 1e-3
    for name in EVEN:
        assert np.abs(right[name] - left[name]).max() <= 1e-9 * max(1.0, np.abs(right[name]).max()), name
    for name in ODD:
        assert np.abs(right[name] + left[name]).max() <= 1e-9 * max(1.0, np.abs(right[name]).max()), name
    assert np.abs(right[tips[0]] - left[tips[1]]).max() <= 1e-9


# [theory: thesis-runs.trims]: trims at 127 m/s, 7620 m, one tenth of the stiffness, 8 symmetric modes, of this
# aircraft. Wing tip and h-tail tip up in m, pitch and elevator in rad.
TRIMS = {
    EXACT: (2.831, 0.1597, 0.13632, -0.1786),
    CONSISTENTLY_LINEARISED: (4.992, 0.2908, 0.15806, -0.2735),
    INCONSISTENT: (4.986, 0.2883, 0.15812, -0.2793),
    RUTHLESSLY_LINEARISED: (5.009, 0.2497, 0.15932, -0.3709),
}


def trim(fly, **parameters):
    outputs = ["deflection.wing_tip_right.up", "deflection.htail_tip_right.up", "trim.pitch", "trim.elevator"]
    result = fly(0.01, outputs, {"mode_family": SYMMETRIC, "mode_count": 8, **parameters})
    return [result[name][0] for name in outputs]


@pytest.mark.parametrize("model", TRIMS)
def test_one_tenth_of_the_stiffness_trims_as_recorded(fly, model):
    assert trim(fly, model=model, stiffness_scale=0.1) == pytest.approx(TRIMS[model], rel=2e-4, abs=6e-5)


def test_nominal_stiffness_trims_as_recorded(fly):
    assert trim(fly) == pytest.approx([0.5577, 0.0244, 0.13818, -0.2343], rel=1e-3, abs=6e-5)


def test_the_rigid_aircraft_does_not_deflect(fly):
    wing_tip, htail_tip, pitch, _ = trim(fly, model=RIGID)
    assert wing_tip == htail_tip == 0.0
    assert 0.1 < pitch < 0.2
