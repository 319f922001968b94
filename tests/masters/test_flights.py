"""The comparison itself: it must see what it is for."""

import numpy as np
import pytest

from flights import MANOEUVRE, STRAIGHT, deviation, irregular, ramped


def test_a_difference_is_told_in_parts_of_its_signals_peak():
    reference = {"pitch": np.array([0.1, 0.2]), "down": np.array([-7620.0, -7600.0])}
    assert deviation(reference, reference)[0] == 0.0
    changed = {**reference, "down": reference["down"] + [0.0, 0.00762]}
    largest, name = deviation(changed, reference)
    assert name == "down" and largest == pytest.approx(1e-6)


def test_a_missing_row_or_a_nan_is_no_agreement():
    reference = {"pitch": np.array([0.1, 0.2])}
    for history in [{"pitch": [0.1]}, {"pitch": [0.1, float("nan")]}]:
        with pytest.raises(AssertionError):
            deviation(history, reference)


def test_the_manoeuvre_moves_the_controls_and_the_straight_flight_does_not():
    assert STRAIGHT.inputs == {}
    assert MANOEUVRE.inputs["elevator"].min() == pytest.approx(-0.05, rel=1e-3)
    assert np.abs(MANOEUVRE.inputs["rudder"]).max() == pytest.approx(0.05, rel=1e-3)
    assert abs(MANOEUVRE.inputs["elevator"][-1]) < 1e-9


def test_irregular_steps_are_uneven_and_ramps_meet():
    assert np.unique(np.diff(irregular(5.0)).round(9)).size == 7
    flight = ramped(MANOEUVRE)
    reached = flight.inputs["elevator"][:-1] + flight.rates["elevator"][:-1] * np.diff(flight.time)
    assert np.abs(reached - flight.inputs["elevator"][1:]).max() < 1e-15
