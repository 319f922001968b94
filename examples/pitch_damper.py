"""A pitch damper: designed on the linear model with python-control, flown in the FMU, and both drawn.

    pip install control scipy fmpy matplotlib
    python examples/pitch_damper.py --flexair target/release/flexair --plot docs/pitch-damper.png

elevator = pilot + gain · washout(q), washout(s) = T s / (T s + 1): a positive elevator is nose-down. The gain is the smallest
that gives the short period the damping ratio asked for. The law is sampled every 10 ms, its elevator held in between and
moved by an actuator of 40 rad/s, which is in the linear model; limits of its rate and angle are in the flight alone.

The linear model comes from the Python package `flexair` where it is installed, otherwise from the command.
"""

import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import control
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from scipy.optimize import brentq

STEP, STEPS = 0.01, 1200  # s: the grid of the aircraft's own integrator, 12 s of it
WASHOUT = 2.0  # s: leaves slow manoeuvres alone; a longer one costs damping of the phugoid, at 0.1 rad/s
ACTUATOR = {"actuator.elevator.frequency": 40.0, "actuator.elevator.damping": 0.7}
RATE_LIMIT = 0.7  # rad/s
TRAVEL = 0.35  # rad, either way from the trim
OUTPUTS = ["rate.y", "load_factor.z", "surface.elevator", "actuator.elevator.rate"]
DRAWN = OUTPUTS[:3]


def linear_model(program):
    """The jet's model in level flight, reduced to 64 states: arrays by name, in SI units and radians."""
    options = {"inflow": "balanced:64", "inputs": "controls"}
    if program is None:
        try:
            import flexair
        except ImportError:
            program = shutil.which("flexair") or sys.exit("there is no flexair: name the command with --flexair")
        else:
            return vars(flexair.linearise(**options, parameters=ACTUATOR))
    written = [f"--{name}={value}" for name, value in options.items()]
    written += [f"--set={name}={value}" for name, value in ACTUATOR.items()]
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "linearise", *written, "--format=npz", "--output", folder]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        [file] = Path(folder).glob("*.npz")
        with np.load(file) as arrays:
            return dict(arrays)


def sampled_aircraft(model):
    """From `elevator` to OUTPUTS, about the trim, from sample to sample."""
    rows = [list(model["y_names"]).index(name) for name in OUTPUTS]
    column = [list(model["u_names"]).index("elevator")]
    matrices = model["A"], model["B"][:, column], model["C"][rows], model["D"][np.ix_(rows, column)]
    # Signals of python-control are called without dots.
    names = [name.replace(".", "_") for name in OUTPUTS]
    aircraft = control.ss(*matrices, inputs=["elevator"], outputs=names, name="aircraft")
    return control.sample_system(aircraft, STEP, "zoh", name="aircraft")


def sampled_law(gain):
    """From `rate_y` to `damper`, by Tustin's rule."""
    washout = control.tf([gain * WASHOUT, 0.0], [WASHOUT, 1.0])
    law = control.ss(washout, inputs=["rate_y"], outputs=["damper"], name="law")
    return control.sample_system(law, STEP, "tustin", name="law")


def closed(aircraft, gain):
    """From `pilot` to OUTPUTS with the law in between."""
    elevator = control.summing_junction(["pilot", "damper"], "elevator", name="elevator")
    parts = [aircraft, sampled_law(gain), control.ss(elevator, dt=STEP)]
    return control.interconnect(parts, inputs=["pilot"], outputs=aircraft.output_labels)


def broken(aircraft, gain):
    """The loop broken at the elevator, as for negative feedback."""
    return -sampled_law(gain) * aircraft["rate_y", "elevator"]


def damping_ratio(root):
    return -root.real / abs(root)


def roots(system):
    """Of the motion between the samples too, 1/s."""
    poles = system.poles()
    return np.log(poles[np.abs(poles) > 1e-6].astype(complex)) / STEP


def short_period(aircraft):
    """The oscillation between 0.3 and 10 rad/s that the elevator puts most of into the pitch rate: not the Dutch roll."""
    poles, shapes = np.linalg.eig(aircraft.A)
    share = np.abs((aircraft.C[0] @ shapes) * np.linalg.solve(shapes, aircraft.B[:, 0]))
    found = np.log(poles.astype(complex)) / STEP
    share[(found.imag <= 0) | (np.abs(found) < 0.3) | (np.abs(found) > 10)] = 0
    return found[np.argmax(share)]


def design(aircraft, damping):
    """The smallest gain (s) for a damping ratio of the short period, and the short periods without and with it."""

    def moved(gain, near):
        of_loop = roots(control.feedback(aircraft["rate_y", "elevator"], sampled_law(gain), sign=1))
        return of_loop[np.argmin(np.abs(of_loop - near))]

    free = root = short_period(aircraft)
    if not damping_ratio(free) < damping < 0.95:
        sys.exit(f"found a damping ratio of {damping}, allowed is {damping_ratio(free):.3f}, that of the open loop, to 0.95")
    # In small steps, so that the root that is nearest is the same root.
    gains = np.arange(0.05, 10.0, 0.05)
    for gain in gains:
        before, root = root, moved(gain, root)
        if damping_ratio(root) > damping:
            gain = brentq(lambda gain: damping_ratio(moved(gain, before)) - damping, gain - 0.05, gain)
            return gain, free, moved(gain, before)
    sys.exit(f"found no gain up to {gains[-1]:.1f} s that gives a damping ratio of {damping}")


def said_of_margins(aircraft, gain):
    """Margins of gain and phase, and where they are the least."""
    frequencies = np.geomspace(0.01, np.pi / STEP, 20000, endpoint=False)
    response = control.frequency_response(broken(aircraft, gain), frequencies)
    # By the response, since polynomials of order 64 have no digits left.
    sampled = control.FRD(response.frdata, frequencies, smooth=True)
    of_gain, of_phase, _, at_gain, at_phase, _ = control.stability_margins(sampled)
    yield f"gain margin: a factor of {of_gain:.2f} ({20 * np.log10(of_gain):.1f} dB) at {at_gain:.2f} rad/s"
    if np.isfinite(of_phase):
        yield f"phase margin: {of_phase:.0f} degrees at {at_phase:.2f} rad/s"
    else:
        yield f"phase margin: any phase, for the gain of the broken loop is {np.abs(response.frdata).max():.2f} at most"


def pulse(angle):
    """What the pilot adds to the elevator: nose-up from 1 to 2 s."""
    time = STEP * (np.arange(STEPS) + 0.5)
    return np.where((time > 1.0) & (time < 2.0), -angle, 0.0)


def predicted(system, pilot):
    """Departures of OUTPUTS from the trim, at the beginning and after each step."""
    time = STEP * np.arange(STEPS + 1)
    found = control.forced_response(system, time, np.append(pilot, pilot[-1])).outputs
    return dict(zip(OUTPUTS, np.asarray(found).reshape(len(OUTPUTS), -1)))


def flown(fmu, trim, pilot, gain):
    """OUTPUTS of the FMU at the beginning and after each step, with the law in the loop. `trim`: the elevator's, rad."""
    description = read_model_description(fmu)
    number = {variable.name: variable.valueReference for variable in description.modelVariables}
    limits = {
        "actuator.elevator.rate_limit": RATE_LIMIT,
        # Of the surface, trim included; a trim beyond them would be refused.
        "actuator.elevator.minimum": trim - TRAVEL,
        "actuator.elevator.maximum": trim + TRAVEL,
    }
    starts = ACTUATOR | limits
    law = sampled_law(gain)
    state = np.zeros(law.nstates)
    folder = extract(fmu)
    aircraft = FMU2Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="jet",
    )
    aircraft.instantiate()
    try:
        aircraft.setupExperiment(startTime=0.0)
        aircraft.setReal([number[name] for name in starts], list(starts.values()))
        aircraft.enterInitializationMode()
        aircraft.exitInitializationMode()
        [found] = aircraft.getReal([number["trim.elevator"]])
        if abs(found - trim) > 1e-6:
            sys.exit(f"{fmu}: found an elevator of {found} rad in trim, that of the linear model is {trim}: another aircraft")
        history = [aircraft.getReal([number[name] for name in OUTPUTS])]
        for step in range(STEPS):
            rate = history[-1][OUTPUTS.index("rate.y")]
            [damper] = law.C @ state + law.D[:, 0] * rate
            state = law.A @ state + law.B[:, 0] * rate
            aircraft.setReal([number["elevator"]], [pilot[step] + damper])
            aircraft.doStep(currentCommunicationPoint=STEP * step, communicationStepSize=STEP)
            history.append(aircraft.getReal([number[name] for name in OUTPUTS]))
        aircraft.terminate()
    finally:
        aircraft.freeInstance()
        shutil.rmtree(folder, ignore_errors=True)
    return dict(zip(OUTPUTS, np.array(history).T))


def missed(flight, prediction):
    """By how much the prediction of each output is wrong, in parts of the largest departure from the trim in flight."""
    departed = {name: values - values[0] for name, values in flight.items()}
    return {name: np.abs(departed[name] - prediction[name]).max() / np.abs(departed[name]).max() for name in DRAWN}


def draw(flights, predictions, picture):
    """Open and closed loop, as flown and as predicted; large letters, for small pictures."""
    plt.rcParams.update({"font.size": 14, "lines.linewidth": 2.5})
    scales = [("pitch rate (°/s)", np.degrees), ("load factor (1)", np.asarray), ("elevator (°)", np.degrees)]
    panels = dict(zip(DRAWN, scales))
    figure, axes = plt.subplots(len(panels), sharex=True, figsize=(7, 7.5), layout="constrained")
    time = STEP * np.arange(STEPS + 1)
    for (loop, flight), colour in zip(flights.items(), ("tab:orange", "tab:blue")):
        for axis, (name, (label, convert)) in zip(axes, panels.items()):
            axis.plot(time, convert(flight[name]), color=colour, label=f"{loop}, flown")
            axis.plot(time, convert(flight[name][0] + predictions[loop][name]), "k--", linewidth=1.2, label="linear")
            axis.set_ylabel(label)
            axis.grid(alpha=0.3)
    axes[-1].set_xlabel("time (s)")
    axes[-1].set_xlim(0, time[-1])
    lines, labels = axes[0].get_legend_handles_labels()
    for several in (lines, labels):
        del several[1]  # the same dashes
    figure.legend(lines, labels, loc="outside upper center", ncols=3, handlelength=1.2, columnspacing=1)
    picture.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(picture, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fmu", type=Path, default=Path("target/fmu/FlexibleAircraft.fmu"), help="of the jet")
    parser.add_argument("--flexair", metavar="PROGRAM", help="the command, where the Python package is not to be asked")
    parser.add_argument("--damping", type=float, default=0.7, help="ratio that the short period is to have")
    parser.add_argument("--pulse", type=float, default=0.1, help="elevator of the pilot from 1 to 2 s, rad, nose-up")
    parser.add_argument("--plot", type=Path, default=Path("target/pitch-damper.png"), help="the picture, .png, .svg or .pdf")
    options = parser.parse_args()
    if not options.fmu.is_file():
        sys.exit(f"{options.fmu} does not exist: run `flexair package`")

    model = linear_model(options.flexair)
    aircraft = sampled_aircraft(model)
    gain, free, damped = design(aircraft, options.damping)
    print(f"gain of {gain:.3f} s, washout of {WASHOUT:g} s")
    print(f"short period: {abs(free):.2f} rad/s, damping ratio {damping_ratio(free):.3f}")
    print(f"   in the loop: {abs(damped):.2f} rad/s, damping ratio {damping_ratio(damped):.3f}")
    print(*said_of_margins(aircraft, gain), sep="\n")

    trim = float(model["u0"][list(model["u_names"]).index("elevator")])
    pilot = pulse(options.pulse)
    gains = {"open": 0.0, "closed": gain}
    flights = {loop: flown(options.fmu, trim, pilot, gain) for loop, gain in gains.items()}
    predictions = {loop: predicted(closed(aircraft, gain), pilot) for loop, gain in gains.items()}
    for loop, flight in flights.items():
        fastest = np.abs(flight["actuator.elevator.rate"]).max()
        print(f"{loop} loop flown, elevator at up to {fastest:.3f} rad/s; the linear prediction misses, in parts of the peak:")
        print("   " + ", ".join(f"{name} {share:.1%}" for name, share in missed(flight, predictions[loop]).items()))
    draw(flights, predictions, options.plot)
    print(options.plot)


if __name__ == "__main__":
    main()
