"""The functions of the package: arrays with names, the same numbers as the command's files, errors as exceptions."""

import csv
import json
import signal
import subprocess
import sys
import threading
import time
import zipfile
from pathlib import Path

import control
import numpy as np
import pytest

import flexair


def test_a_linear_model_goes_into_python_control_with_its_names_and_steps_as_the_aircraft_does():
    model = flexair.linearise(inflow="steady")
    system = control.ss(
        model.A, model.B, model.C, model.D, inputs=model.u_labels, outputs=model.y_labels, states=model.x_labels
    )
    assert system.nstates == 33 and system.input_labels[0] == "elevator"
    # A step of the elevator so small that the aircraft is linear, from 0 on, without the wake.
    step, times = 1e-4, np.linspace(0.0, 1.0, 101)
    inputs = {"time": times, "elevator": np.full(101, step)}
    flight = flexair.simulate(inputs=inputs, parameters={"inflow_states": 0})
    [pitch] = [number for number, name in enumerate(model.y_names) if name == "attitude.pitch"]
    response = control.forced_response(system, times, np.outer(np.array(model.u_names) == "elevator", inputs["elevator"]))
    found = flight["attitude.pitch"] - flight["attitude.pitch"][0]
    expected = response.outputs[pitch]
    assert np.abs(found - expected).max() < 1e-3 * np.abs(expected).max()


def test_trims_are_those_of_the_commands_table(run, tmp_path):
    trims = flexair.trim(speed=[120.0, 150.0], altitude=np.array([0.0, 2000.0]), modes=4)
    assert run("trim", "--speed", "120,150", "--altitude", "0,2000", "--modes", 4, "--csv", "t.csv").returncode == 0
    rows = list(csv.DictReader((tmp_path / "t.csv").read_text().splitlines()))
    assert len(rows) == 4 and trims.status == [row["status"] for row in rows] == ["ok"] * 4
    for name, values in trims.columns.items():
        assert values.dtype == np.float64 and values.tolist() == [float(row[name]) for row in rows]
    assert trims.units["elevator"] == "rad" and trims["elevator"] is trims.columns["elevator"]


def test_a_linear_model_is_that_of_the_commands_file(run, tmp_path):
    model = flexair.linearise("goland-wing", modes=2)
    assert run("linearise", "goland-wing", "--modes", 2).returncode == 0
    written = json.loads((tmp_path / "flexair-out/linearise/goland-wing-linear.json").read_text())
    modes, qualities = written.pop("modes"), written.pop("flying_qualities")
    assert model.modes.names == [mode["name"] for mode in modes] and model.modes.names[0] == "elastic 1"
    assert [[root.real, root.imag] for root in model.modes.eigenvalues] == [mode["eigenvalue"] for mode in modes]
    assert qualities["load_factor_per_alpha"] is None and np.isnan(model.modes.load_factor_per_alpha)
    for key, values in written.items():
        found = getattr(model, key)
        assert (found.tolist() if isinstance(found, np.ndarray) else found) == values, key


def test_modes_are_followed_over_airspeed_and_a_reduced_model_has_those_of_the_whole(run, tmp_path):
    locus = flexair.root_locus(speed=[120.0, 130.0], modes=2, inflow="steady")
    phugoid = [root for name, root in zip(locus.mode, locus.eigenvalue) if name == "phugoid"]
    assert len(phugoid) == 2 and phugoid[0].imag > phugoid[1].imag > 0.1
    families = {family for name, family in zip(locus.mode, locus.family) if name == "phugoid"}
    assert families == {"symmetric"} and len(locus.family) == len(locus.mode)
    model = flexair.linearise(inflow="balanced:36", inputs="controls", gust_stations=0)
    assert model.A.shape == (36, 36) and model.u_names == ["elevator", "aileron", "aileron_symmetric", "rudder", "thrust_left", "thrust_right"]
    assert 0.0 < model.error_bound < 1.0 and flexair.linearise(inflow="steady").error_bound is None
    roots = np.linalg.eigvals(model.A)
    for name in ["phugoid", "spiral"]:
        assert np.abs(roots - model.modes[name]).min() < 1e-6 * abs(model.modes[name])
    assert np.abs(roots - model.modes["short period"]).min() < 1e-2


def test_what_a_file_describes_and_turbulence_are_those_of_the_commands_files(run, tmp_path):
    described = flexair.describe("generic-business-jet", modes=4)
    assert run("describe", "--modes", 4, "--json", "d.json").returncode == 0
    assert described == json.loads((tmp_path / "d.json").read_text())
    turbulence = flexair.turbulence(output_names=["load_factor.z"], modes=2)
    assert run("gust", "--continuous", "--output-names", "load_factor.z", "--modes", 2).returncode == 0
    rows = (tmp_path / "flexair-out/gust/generic-business-jet-continuous.csv").read_text().splitlines()
    assert turbulence.names == ["load_factor.z"] and 0.02 < turbulence.rms[0, 0] < 0.06
    assert repr(float(turbulence.rms[0, 0])) in rows[1] and turbulence.warnings == []
    slow = flexair.turbulence(direction=270, output_names=["load_factor.z"], modes=2, parameters={"airspeed": 70})
    assert slow.direction.tolist() == [90.0]
    assert slow.warnings[0].startswith("the trim at 70 m/s and 7620 m stands, but ")


def test_a_flight_with_a_shape_and_with_arrays_is_that_of_the_commands_table(run, tmp_path):
    flight = flexair.simulate(inputs={"elevator": "2311:-0.05@0.1:0.2"}, duration=1, modes=4)
    command = ["simulate", "--input", "elevator=2311:-0.05@0.1:0.2", "--duration", 1, "--modes", 4, "--output", "f.csv"]
    assert run(*command).returncode == 0
    with (tmp_path / "f.csv").open() as file:
        names = next(csv.reader(file))
        rows = np.loadtxt(file, delimiter=",")
    assert list(flight) == names and flight["time"].shape == (101,) and flight.units["load_factor.z"] == "1"
    assert all(np.array_equal(flight[name], rows[:, column]) for column, name in enumerate(names))

    (tmp_path / "i.csv").write_text("time,elevator,wind_down\n0,0,0.5\n0.25,-0.01,0\n0.5,0,0\n")
    columns = {"elevator": [0, -0.01, 0], "time": np.array([0, 0.25, 0.5]), "wind_down": (0.5, 0, 0)}
    of_arrays, of_file = (
        flexair.simulate(inputs=inputs, modes=4, step=0.05) for inputs in (columns, tmp_path / "i.csv")
    )
    assert of_arrays["time"].size == 11 and all(np.array_equal(of_arrays[name], of_file[name]) for name in names)


def test_gusts_are_rows_and_outputs_are_columns():
    gusts = flexair.gust(gradients=[30, 60], duration=2, modes=4, output_names=["load_factor.lift", "loads.wing_root_right"])
    assert gusts.least.shape == gusts.greatest.shape == (4, 7) == (gusts.gradient.size, len(gusts.names))
    assert gusts.gradient.tolist() == [30, 60, 30, 60] and gusts.direction.tolist() == [0, 0, 180, 180]
    assert (gusts.least <= gusts.trim).all() and (gusts.greatest >= gusts.trim).all() and gusts.failures == []


def test_the_goland_wing_flutters_where_goland_has_it():
    # 137.3 m/s and 70.1 rad/s in the literature, see the head of the aircraft file.
    flutter = flexair.flutter("goland-wing", from_=120, to=150, points=7)
    [onset] = [crossing for crossing in flutter.crossings if crossing.kind == "flutter" and crossing.is_onset]
    assert onset.airspeed == pytest.approx(137.3, rel=0.01) and onset.frequency == pytest.approx(70.1, rel=0.01)
    assert flutter.eigenvalues.shape == (len(flutter.roots), 7) and flutter.airspeeds[0] == 120
    growing = flutter.eigenvalues[onset.root].real > 0
    assert (growing == (flutter.airspeeds > onset.airspeed)).all() and "137." in flutter.report


def test_packaging_returns_the_path_and_what_the_flight_showed(own_aircraft, tmp_path):
    packaged = flexair.package(own_aircraft, output=tmp_path / "own.fmu", modes=2, parameters={"model": "rigid"})
    assert packaged.path.stat().st_size == packaged.size and "faster than real time" in packaged.flight
    assert packaged.interface == "FMI 2.0 co-simulation" and packaged.others == ()


def test_the_documentation_shows_the_aircraft_unless_it_should_not(own_aircraft, tmp_path):
    for scene in [True, False]:
        packaged = flexair.package(own_aircraft, output=tmp_path / "own.fmu", modes=2, scene=scene, check=False)
        assert ("documentation/scene.html" in zipfile.ZipFile(packaged.path).namelist()) == scene


def test_packaging_as_several_things_returns_all_of_them(own_aircraft, tmp_path):
    kinds = ["co-simulation", "model-exchange"]
    packaged = flexair.package(own_aircraft, output=tmp_path / "fmus", fmi=[2, 3], kind=kinds, modes=2, check=False)
    written = {archive.path.name: archive.interface for archive in [packaged, *packaged.others]}
    assert written == {
        "FlexibleAircraft.fmu": "FMI 2.0 co-simulation",
        "FlexibleAircraft.fmi3.fmu": "FMI 3.0 co-simulation",
        "FlexibleAircraft.me.fmu": "FMI 2.0 model exchange",
        "FlexibleAircraft.fmi3.me.fmu": "FMI 3.0 model exchange",
    }
    with pytest.raises(flexair.Error, match="--output FILE takes one archive; 2 were asked for"):
        flexair.package(own_aircraft, output=tmp_path / "own.fmu", fmi=[2, 3], modes=2)


def test_shipped_aircraft_have_files():
    shipped = flexair.aircraft()
    assert {"generic-business-jet", "goland-wing"} <= set(shipped) and all(path.is_file() for path in shipped.values())


@pytest.mark.parametrize(
    ("call", "kind", "message"),
    [
        (lambda: flexair.trim("no/such.toml"), flexair.Error, "no/such.toml: cannot read the aircraft file: "),
        (lambda: flexair.trim("jett"), flexair.UsageError, "no aircraft of this name comes with flexair"),
        (lambda: flexair.trim(failed_engine="middle"), flexair.Error, "--failed-engine: found middle, allowed is "),
        (lambda: flexair.trim(bank_angle=90), flexair.UsageError, "allowed are -84 to 84 degrees"),
        (lambda: flexair.trim(speed=object()), flexair.UsageError, "allowed is a number, a text, a path"),
        (lambda: flexair.linearise(parameters={"modell": 1}), flexair.Error, "did you mean `model`?"),
        (lambda: flexair.simulate(inputs={"time": [0, 1], "elevatr": [0, 0]}), flexair.Error, "inputs: line 1"),
        (lambda: flexair.simulate(inputs={"time": [0, 1], "elevator": [0]}), flexair.UsageError, "shape (1,)"),
        (lambda: flexair.simulate(inputs={"elevator": [0]}), flexair.UsageError, "without time (s)"),
    ],
)
def test_what_is_wrong_is_raised_with_the_commands_message(call, kind, message):
    with pytest.raises(kind) as raised:
        call()
    assert type(raised.value) is kind and message in str(raised.value) and "Usage:" not in str(raised.value)


@pytest.mark.parametrize(
    ("call", "kind", "message"),
    [
        (lambda: flexair.trim(speed=True), TypeError, "speed: found True, allowed is a number (m/s), several, or a text"),
        (lambda: flexair.trim(speed=[120, False]), TypeError, "speed: found [120, False], allowed is a number (m/s)"),
        (lambda: flexair.trim(altitude=np.array([True])), TypeError, "altitude: found array([ True]), allowed is a number (m)"),
        (lambda: flexair.trim(modes=False), TypeError, "modes: found False, allowed is a whole number"),
        (lambda: flexair.trim(turn=1), TypeError, "turn: found 1, allowed is True or False"),
        (lambda: flexair.trim(parameters="airspeed=1"), TypeError, "parameters: found 'airspeed=1', allowed is a mapping"),
        (lambda: flexair.package(stations_along={"wing_right": True}), TypeError, "stations_along, wing_right: found True"),
        (lambda: flexair.flutter(from_=True, to=150), TypeError, "from_: found True, allowed is a number (m/s)"),
        (lambda: flexair.simulate(inputs={"time": [0, 1], "elevator": [True, 0.1]}), TypeError, "inputs, elevator: found"),
        (lambda: flexair.trim(True), TypeError, "aircraft: found True, allowed is a text or a path"),
        (lambda: flexair.trim(""), ValueError, "aircraft: found '', allowed is a text or a path, not empty"),
        (lambda: flexair.trim(speed=[]), ValueError, "speed: found [], allowed is a number (m/s)"),
        (lambda: flexair.trim(speed=" "), ValueError, "speed: found ' ', allowed is a number (m/s)"),
        (lambda: flexair.trim(altitude=np.array([])), ValueError, "altitude: found array([], dtype=float64)"),
        (lambda: flexair.trim(failed_engine=""), ValueError, "failed_engine: found '', allowed is a text"),
        (lambda: flexair.gust(output_names=[]), ValueError, "output_names: found [], allowed is a text or several"),
        (lambda: flexair.turbulence(output_names=["loads", ""]), ValueError, "output_names: found ['loads', '']"),
        (lambda: flexair.simulate(inputs=""), ValueError, "inputs: found ''"),
        (lambda: flexair.simulate(inputs={"time": [], "elevator": []}), ValueError, "inputs, time: found no numbers"),
    ],
)
def test_truth_values_are_no_numbers_and_nothing_is_no_argument(call, kind, message):
    with pytest.raises(flexair.UsageError) as raised:
        call()
    assert isinstance(raised.value, kind) and message in str(raised.value)


def test_switches_and_numbers_of_numpy_are_switches_and_numbers():
    trims = flexair.trim(speed=(speed for speed in np.array([130, 140])), turn=np.bool_(False), modes=np.int64(2))
    assert trims.columns["airspeed"].tolist() == [130.0, 140.0]


def test_other_threads_run_while_a_call_computes():
    # A thread that counts: were the lock held, it would stand still.
    counts, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counts[0] += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    before = counts[0]
    flexair.simulate(duration=30)
    after = counts[0]
    done.set()
    counter.join()
    assert after - before > 10


def test_ctrl_c_raises_keyboard_interrupt_at_the_next_step():
    script = """
import flexair, signal, threading, time
threading.Timer(2.0, signal.raise_signal, [signal.SIGINT]).start()
begun = time.monotonic()
try:
    flexair.simulate(duration=90000)
except KeyboardInterrupt:
    print(time.monotonic() - begun)
"""
    interrupted = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=300)
    assert interrupted.returncode == 0, interrupted.stderr
    assert 2.0 <= float(interrupted.stdout) < 20.0


def test_the_package_is_typed(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(
        "import flexair\n"
        "reveal_type(flexair.linearise().A)\n"
        "reveal_type(flexair.simulate()['time'])\n"
        "flexair.trim(sped=1)\n"
    )
    checked = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", script], cwd=tmp_path, capture_output=True, text=True
    )
    assert checked.stdout.count('Revealed type is "numpy.ndarray') == 2, checked.stdout
    assert 'Unexpected keyword argument "sped"' in checked.stdout and "Found 1 error" in checked.stdout
    whole = [sys.executable, "-m", "mypy", "--strict", "-p", "flexair"]
    checked = subprocess.run(whole, cwd=tmp_path, capture_output=True, text=True)
    assert checked.returncode == 0, checked.stdout


def test_examples_of_the_help_text_do_what_they_say(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert flexair.__doc__ is not None and signal.getsignal(signal.SIGINT) is signal.default_int_handler
    for line in flexair.__doc__.splitlines():
        if line.startswith("    ") and "my-aircraft" not in line:
            exec(line.strip(), {"flexair": flexair})
    assert Path(flexair.__file__).with_name("py.typed").is_file()
