"""What `flexair linearise` writes: the same in all formats, read by NumPy, SciPy and python-control, flown by the FMU.

The FMU, the command: as in conftest.py.
"""

import csv
import functools
import json

import control
import fmpy
import numpy as np
import pytest
import scipy.io

MATRICES = ["A", "B", "C", "D", "Bd", "Dd"]
VECTORS = ["x0", "u0", "y0"]
TEXTS = [f"{signal}_{kind}" for signal in "xuy" for kind in ("names", "units", "labels")]
# Names that `ss` of MATLAB takes, and the keys of the same texts.
FOR_SS = {
    "StateName": "x_names",
    "InputName": "u_names",
    "OutputName": "y_names",
    "StateUnit": "x_units",
    "InputUnit": "u_units",
    "OutputUnit": "y_units",
}


@pytest.fixture(scope="session")
def linearised(linearise, tmp_path_factory):
    """A function that gives the folder with all formats of the jet's model under some options, written once."""

    @functools.cache
    def linearised(*options):
        folder = tmp_path_factory.mktemp("linear")
        linearise(*options, "--format", "json,csv,npz,mat", "--output", folder)
        return folder

    return linearised


@pytest.fixture(scope="session")
def read(linearised):
    """A function that gives the arrays by their keys."""

    @functools.cache
    def read(*options):
        with np.load(linearised(*options) / "generic-business-jet-linear.npz") as arrays:
            return dict(arrays)

    return read


@pytest.fixture(scope="session")
def system(read):
    """A function that gives a system of python-control, with labels for names."""

    @functools.cache
    def system(*options):
        model = read(*options)
        names = {"states": "x_labels", "inputs": "u_labels", "outputs": "y_labels"}
        names = {kind: list(map(str, model[key])) for kind, key in names.items()}
        return control.ss(*(model[key] for key in "ABCD"), **names, name="aircraft")

    return system


def place(model, signal, name):
    return list(model[f"{signal}_names"]).index(name)


def response(model, frequencies):
    """By frequency, output and input, by the eigenvalues; the rate of the wind acts too."""
    roots, shapes = np.linalg.eig(model["A"])
    at = 1j * np.asarray(frequencies)[:, None, None]
    inputs = np.linalg.solve(shapes, model["B"]) + at * np.linalg.solve(shapes, model["Bd"])
    amplitudes = inputs / (at - roots[:, None])
    return (model["C"] @ shapes) @ amplitudes + model["D"] + at * model["Dd"]


SMALL = ("--modes", "2", "--set", "inflow_states=1")


@pytest.mark.parametrize("options", [SMALL, (*SMALL, "--inflow", "balanced:30"), (*SMALL, "--all-states")])
def test_all_formats_hold_the_same_bits(linearised, read, options):
    folder, expected = linearised(*options), read(*options)
    bound = {"error_bound"} if "--inflow" in options else set()
    assert set(expected) == {*MATRICES, *VECTORS, *TEXTS, *bound}
    prefix = folder / "generic-business-jet"

    matlab = scipy.io.loadmat(f"{prefix}-linear.mat")
    of_json = json.loads((folder / "generic-business-jet-linear.json").read_text(encoding="utf-8"))
    assert set(of_json) == set(expected) | {"modes", "flying_qualities"}
    for key in MATRICES:
        assert expected[key].dtype == np.float64
        np.testing.assert_array_equal(matlab[key], expected[key], strict=True)
        np.testing.assert_array_equal(np.array(of_json[key]), expected[key], strict=True)
    for key in VECTORS:
        np.testing.assert_array_equal(matlab[key][:, 0], expected[key], strict=True)
        np.testing.assert_array_equal(np.array(of_json[key]), expected[key], strict=True)

    def cells(key):
        assert matlab[key].shape[1] == 1
        return [str(cell[0]) for cell in matlab[key][:, 0]]

    for key in TEXTS:
        assert of_json[key] == list(expected[key]) == cells(key)
    for name, key in FOR_SS.items():
        assert cells(name) == list(expected[key])

    def table(name):
        with open(f"{prefix}-{name}.csv", newline="", encoding="utf-8") as file:
            return list(csv.reader(file))

    sides = {"A": "xx", "B": "xu", "C": "yx", "D": "yu", "Bd": "xu", "Dd": "yu"}
    for key, (rows, columns) in sides.items():
        head, *body = table(key)
        assert head == ["", *expected[f"{columns}_names"]]
        assert [row[0] for row in body] == list(expected[f"{rows}_names"])
        np.testing.assert_array_equal(np.array([row[1:] for row in body], dtype=float), expected[key])
    for signal in "xuy":
        head, *body = table(signal)
        assert head == ["name", "label", "unit", "value"]
        columns = list(zip(*body))
        for column, key in zip(columns, ("names", "labels", "units")):
            assert list(column) == list(expected[f"{signal}_{key}"])
        np.testing.assert_array_equal(np.array(columns[3], dtype=float), expected[f"{signal}0"])


# Input, output, gain at 1 rad/s as an independent prototype in numpy prints it.
GAINS = [
    ("elevator", "load_factor_z", -1.6280 + 2.5013j, 1e-4),
    ("elevator", "rate_y", -0.47283 - 0.045226j, 1e-5),
    ("aileron", "rate_x", 1.7891 - 0.70466j, 1e-4),
    ("rudder", "air_beta", -0.20418 + 0.040225j, 1e-5),
]


@pytest.mark.parametrize("inflow", [(), ("--inflow", "balanced:44", "--inputs", "controls")])
def test_python_control_has_the_gains_of_the_independent_computation(system, inflow):
    aircraft = system(*inflow)
    for source, output, gain, digit in GAINS:
        # Half of the last digit, and of the reduced model what it is wrong by.
        exact = 0.6 * digit
        tolerance = exact if not inflow else exact + 1e-4 * abs(gain)
        found = aircraft[output, source](1j)
        assert abs((found - gain).real) <= tolerance and abs((found - gain).imag) <= tolerance, (source, output, found)


def test_an_interconnection_by_names_is_the_loop_closed_by_hand(system, read):
    aircraft, model = system(), read()
    gain = -0.2
    law = control.ss([], [], [], [[gain]], inputs=["rate_y"], outputs=["law_elevator"], name="law")
    sum_of = control.summing_junction(["law_elevator", "pilot"], "elevator", name="sum")
    # Labels are there once among inputs and outputs: `wind_down` is the input, `wind_down_out` what blows.
    closed = control.interconnect(
        [aircraft, law, sum_of],
        inputs=["pilot", "wind_down"],
        outputs=["rate_y", "load_factor_z", "wind_down_out"],
        check_unused=False,
    )
    assert closed.nstates == aircraft.nstates and closed.state_labels[:1] == ["aircraft_position_down"]
    frequency = 1.3
    opened = response(model | {"Bd": 0 * model["Bd"], "Dd": 0 * model["Dd"]}, [frequency])[0]
    row = {name: place(model, "y", name) for name in ("rate.y", "load_factor.z", "wind.down")}
    elevator, wind = place(model, "u", "elevator"), place(model, "u", "wind_down")
    back = gain / (1.0 - gain * opened[row["rate.y"], elevator])
    found = closed(1j * frequency)
    for line, name in enumerate(row):
        by_elevator = opened[row[name], elevator]
        for column, source in enumerate((elevator, wind)):
            expected = opened[row[name], source] + by_elevator * back * opened[row["rate.y"], source]
            assert abs(found[line, column] - expected) <= 1e-9 * (1.0 + abs(expected)), (name, column)
    assert abs(found[2, 1] - 1.0) < 1e-9


MAIN = ("attitude", "velocity", "rate", "load_factor", "air", "loads")

# What counts as one of an input.
OF_INPUTS = {"rad": 0.1, "m/s": 10.0, "N": 1e4}

# States, inputs, what outputs are wrong by at most, of the largest gain of each from 0.1 to 60 rad/s: the main ones,
# then all. An independent prototype in numpy gives 2.5e-3 and 7e-5 for controls and thrust, 6e-2 and 2.2e-3 with the
# wind, for outputs of its own choice. These files: 2.50e-3 and 4.67e-3; 7.09e-5; 0.0997; 1.49e-3 and 2.66e-3.
REDUCED = [
    (36, "controls", 2.6e-3, 5e-3),
    (44, "controls", 7.5e-5, 7.5e-5),
    (36, "all", 0.12, 0.12),
    (44, "all", 2.2e-3, 3e-3),
]


@pytest.fixture(scope="module")
def in_frequency(read):
    """Frequencies from 0.1 to 60 rad/s, among them those where lightly damped modes peak; the whole model's response."""
    roots = np.linalg.eigvals(read()["A"])
    light = [root for root in roots if root.imag > 0 and -root.real < 0.1 * abs(root)]
    near = [root.imag + root.real * share for root in light for share in np.linspace(-3, 3, 7)]
    frequencies = [*np.geomspace(0.1, 60.0, 60), *(f for f in near if 0.1 <= f <= 60.0)]
    return frequencies, response(read(), frequencies)


@pytest.mark.parametrize("states, inputs, of_main, of_all", REDUCED)
def test_reduced_models_respond_as_the_whole_one(read, in_frequency, states, inputs, of_main, of_all):
    whole, reduced = read(), read("--inflow", f"balanced:{states}", "--inputs", inputs)
    assert reduced["A"].shape == (states, states) and list(reduced["x_names"][:1]) == ["reduced[1]"]
    assert np.all(reduced["Bd"] == 0.0) and np.all(reduced["x0"] == 0.0)
    for key in ("y0", "y_names", "y_units"):
        np.testing.assert_array_equal(reduced[key], whole[key])
    frequencies, expected = in_frequency
    count = len(reduced["u_names"])
    assert list(reduced["u_names"]) == list(whole["u_names"][:count])
    scales = np.array([OF_INPUTS[unit] for unit in reduced["u_units"]])
    expected = expected[:, :, :count] * scales
    wrong = np.abs(response(reduced, frequencies) * scales - expected).max(axis=(0, 2))
    largest = np.abs(expected).max(axis=(0, 2))
    moved = largest > 1e-6
    main = np.array([name.split(".")[0] in MAIN for name in whole["y_names"]])
    assert (main & moved).sum() > 60 and moved.sum() > 200
    assert (wrong / np.maximum(largest, 1e-6))[main & moved].max() <= of_main
    assert (wrong / np.maximum(largest, 1e-6))[moved].max() <= of_all


FLOWN = {
    "elevator": [
        "load_factor.z",
        "rate.y",
        "attitude.pitch",
        "air.alpha",
        "position.north",
        "loads.wing_root_right.bending",
    ],
    "aileron": ["rate.x", "attitude.roll", "attitude.yaw", "air.beta", "position.east", "loads.wing_mid_right.torsion"],
}


@pytest.fixture(scope="session")
def step(aircraft):
    """A function that gives what a step of an input changes in outputs: half the difference of a step up and a step
    down, in which nothing quadratic is left."""

    @functools.cache
    def step(source, jump):
        def fly(change):
            return fmpy.simulate_fmu(
                str(aircraft),
                stop_time=5.0,
                step_size=0.01,
                output_interval=0.01,
                start_values={source: change},
                output=FLOWN[source],
            )

        up, down = fly(jump), fly(-jump)
        return np.asarray(up["time"]), {name: 0.5 * (up[name] - down[name]) for name in FLOWN[source]}

    return step


@pytest.mark.parametrize("reduction", [(), ("--inflow", "balanced:64", "--inputs", "controls")])
@pytest.mark.parametrize("source", FLOWN)
def test_steps_of_the_fmu_are_those_of_the_file(step, system, read, source, reduction):
    """Steps of 1e-3 rad, 5 s: within 1e-3 of the peak."""
    jump, options = 1e-3, (*reduction, "--all-states")
    times, flown = step(source, jump)
    labels = [str(read(*options)["y_labels"][place(read(*options), "y", name)]) for name in flown]
    part = system(*options)[labels, [source]]
    linear = control.forced_response(part, times, np.full((1, len(times)), jump)).outputs
    for (name, found), expected in zip(flown.items(), np.reshape(np.asarray(linear), (len(flown), -1))):
        apart = np.abs(found - expected).max() / np.abs(expected).max()
        assert apart <= 1e-3, (name, apart)
