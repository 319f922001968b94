"""The pitch damper damps as it was designed to, in the whole linear model and in flight, and keeps to the actuator's limits."""

import os
import subprocess
import sys

import control
import numpy as np
import pytest

from conftest import EXAMPLES, ROOT

sys.path.insert(0, str(EXAMPLES))
import pitch_damper  # noqa: E402

PROGRAM = os.environ.get("FLEXAIR", ROOT / "target/release/flexair")
DAMPING = 0.7
RATE = "rate.y"


@pytest.fixture(scope="module")
def model():
    return pitch_damper.linear_model(PROGRAM)


@pytest.fixture(scope="module")
def designed(model):
    """The sampled aircraft and the gain."""
    sampled = pitch_damper.sampled_aircraft(model)
    gain, _, _ = pitch_damper.design(sampled, DAMPING)
    return sampled, gain


@pytest.fixture(scope="module")
def flights(aircraft, model, designed):
    """A function that flies a pulse (rad): flight and prediction without the damper, and with it."""
    sampled, gain = designed
    trim = float(model["u0"][0])

    def flights(angle):
        pilot = pitch_damper.pulse(angle)
        for used in (0.0, gain):
            prediction = pitch_damper.predicted(pitch_damper.closed(sampled, used), pilot)
            yield pitch_damper.flown(aircraft, trim, pilot, used), prediction

    return flights


def test_the_whole_linear_model_has_the_damping_ratio_asked_for(designed, linearise, tmp_path):
    """All 530 states, without sampling. The jet's own is 0.4009, as `flexair linearise` prints it."""
    starts = [f"--set={name}={value}" for name, value in pitch_damper.ACTUATOR.items()]
    linearise(*starts, "--format", "npz", "--output", tmp_path)
    with np.load(tmp_path / "generic-business-jet-linear.npz") as arrays:
        whole = dict(arrays)
    row, column = list(whole["y_names"]).index(RATE), list(whole["u_names"]).index("elevator")
    jet = control.ss(whole["A"], whole["B"][:, [column]], whole["C"][[row]], whole["D"][[row]][:, [column]])
    sampled, gain = designed
    time = pitch_damper.WASHOUT
    washout = control.ss(control.tf([time, 0.0], [time, 1.0]))

    def nearest(poles, root):
        return poles[np.argmin(np.abs(poles - root))]

    near = nearest(jet.poles(), -0.526 + 1.202j)
    assert abs(pitch_damper.damping_ratio(near) - 0.4009) < 1e-3
    assert abs(pitch_damper.short_period(sampled) - near) < 1e-3
    # Followed by itself from gain to gain.
    for used in np.linspace(0.0, gain, 6)[1:]:
        near = nearest(control.feedback(jet, used * washout, sign=1).poles(), near)
    assert abs(pitch_damper.damping_ratio(near) - DAMPING) < 0.02


def test_feedback_and_interconnect_give_the_same_loop(designed):
    sampled, gain = designed
    joined = pitch_damper.roots(pitch_damper.closed(sampled, gain))
    fed_back = pitch_damper.roots(control.feedback(sampled["rate_y", "elevator"], pitch_damper.sampled_law(gain), sign=1))
    for root in joined[np.abs(joined) < 100]:
        assert np.abs(fed_back - root).min() < 1e-6


def test_the_flown_loop_damps_more_and_is_what_was_predicted(flights):
    """A pulse of 0.02 rad, which meets no limit. Found: 0.14 % of the peak of the pitch rate, 0.37 % of the load factor's."""
    (free, of_free), (damped, of_damped) = flights(0.02)
    late = slice(round(3.0 / pitch_damper.STEP), None)
    rms = [np.sqrt(np.mean(flight[RATE][late] ** 2)) for flight in (free, damped)]
    assert rms[1] < 0.5 * rms[0]
    for flight, prediction in ((free, of_free), (damped, of_damped)):
        for name, share in pitch_damper.missed(flight, prediction).items():
            assert share < {"rate.y": 0.005, "load_factor.z": 0.011, "surface.elevator": 0.001}[name], name


def test_the_elevator_keeps_to_its_limits(flights, model):
    """The second pulse is beyond the lower stop."""
    trim, travel = float(model["u0"][0]), pitch_damper.TRAVEL
    for angle, reached in ((0.1, 0.1), (0.5, travel)):
        for flight, _ in flights(angle):
            rate, elevator = flight["actuator.elevator.rate"], flight["surface.elevator"]
            assert np.abs(rate).max() == pytest.approx(pitch_damper.RATE_LIMIT, rel=1e-9)
            assert np.abs(np.diff(elevator)).max() <= pitch_damper.RATE_LIMIT * pitch_damper.STEP * (1 + 1e-9)
            assert np.abs(elevator - trim).max() <= travel * (1 + 1e-12)
            assert np.abs(elevator - trim).max() == pytest.approx(reached, rel=0.05)


def test_the_command_draws_and_tells_the_margins(aircraft, tmp_path):
    picture = tmp_path / "new" / "damper.png"
    command = [sys.executable, EXAMPLES / "pitch_damper.py", "--fmu", aircraft, "--flexair", PROGRAM, "--plot", picture]
    run = subprocess.run([*command, "--damping", "0.6"], check=True, capture_output=True, encoding="utf-8")
    assert "damping ratio 0.401" in run.stdout and "damping ratio 0.600" in run.stdout
    assert "gain margin: a factor of " in run.stdout
    assert picture.read_bytes().startswith(b"\x89PNG")
    refused = subprocess.run([*command, "--damping", "0.2"], capture_output=True, encoding="utf-8")
    assert refused.returncode == 1 and "found a damping ratio of 0.2, allowed is 0.401" in refused.stderr
