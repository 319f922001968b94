"""The flights that every importer flies, and how far a result is from that of the Rust library.

A flight is a list of communication points; the inputs of each act until the next. The Rust library flies it without any
FMI: `flexair simulate`.
"""

from dataclasses import dataclass, field

import numpy as np

INCONSISTENT = 3  # of the enumeration `model`
SYMMETRIC = 2  # of the enumeration `mode_family`
ONE_MINUS_COSINE = 2  # of the enumeration `gust.shape`
VON_KARMAN = 3  # of the enumeration `turbulence.spectrum`


@dataclass(frozen=True)
class Flight:
    name: str
    time: np.ndarray
    inputs: dict[str, np.ndarray] = field(default_factory=dict)
    rates: dict[str, np.ndarray] = field(default_factory=dict)
    parameters: dict[str, float | int] = field(default_factory=dict)

    @property
    def steps(self):
        """Index, time and length of each communication step."""
        return zip(range(len(self.time) - 1), self.time.tolist(), np.diff(self.time).tolist())

    def inputs_at(self, point):
        return {name: float(values[point]) for name, values in self.inputs.items()}

    def csv(self):
        """The table that `flexair simulate` takes; all digits."""
        columns = {"time": self.time, **self.inputs}
        columns |= {f"der({name})": values for name, values in self.rates.items()}
        rows = zip(*(column.tolist() for column in columns.values()))
        return "\n".join([",".join(columns), *(",".join(map(repr, row)) for row in rows)]) + "\n"


def regular(duration):
    """Communication points every 10 ms."""
    return np.arange(round(duration / 0.01) + 1) * 0.01


def irregular(duration):
    """Communication points after 30 µs to 20 ms, on and off the 5 ms grid of the integrator."""
    pattern = [3e-5, 1e-3, 0.0123, 0.005, 0.02, 0.0077, 0.01]
    lengths = np.resize(pattern, round(duration / np.mean(pattern)))
    return np.concatenate([[0.0], np.cumsum(lengths)])


def pulses(time, amplitude, start, ends):
    """Alternating pulses, seen through the actuator's lag of 0.05 s."""
    jumps = amplitude * np.array([1, *([-2, 2] * len(ends))][: len(ends)] + [(-1) ** len(ends)])
    return sum(
        jump * np.where(time > at, -np.expm1((at - time) / 0.05), 0.0) for at, jump in zip([start, *ends], jumps)
    )


def everything_moves(time):
    """All surfaces, one engine and the wind; nothing at time 0."""
    return {
        "elevator": -0.03 * np.sin(2.0 * time),
        "aileron": 0.02 * np.sin(1.3 * time),
        "rudder": 0.01 * np.sin(0.9 * time),
        "thrust_left": 1e3 * np.sin(time),
        "wind_down": -2.0 * (1.0 - np.cos(time)),
    }


def _manoeuvre():
    time = regular(15.0)
    elevator = pulses(time, -0.05, 1.0, [2.4, 4.5, 5.2, 5.9])
    return Flight("manoeuvre", time, {"elevator": elevator, "rudder": pulses(time, 0.05, 7.0, [9.0, 11.0])})


STRAIGHT = Flight("straight", regular(5.0))
MANOEUVRE = _manoeuvre()
PARAMETERS = Flight(
    "parameters",
    regular(5.0),
    everything_moves(regular(5.0)),
    parameters={
        "stiffness_scale": 0.3,
        "mode_count": 9,
        "inflow_states": 3,
        "airspeed": 130.0,
        "altitude": 6000.0,
        "heading": 0.4,
        "structural_damping": 0.02,
    },
)
ENUMERATIONS = Flight(
    "enumerations",
    regular(5.0),
    {"elevator": everything_moves(regular(5.0))["elevator"]},
    parameters={"model": INCONSISTENT, "mode_family": SYMMETRIC, "mode_count": 8, "stiffness_scale": 0.1},
)
# A gust with a part to the right and turbulence, both frozen in the air, a changing wind, actuators and sensors that lag.
STORM = Flight(
    "storm",
    regular(5.0),
    {"elevator": everything_moves(regular(5.0))["elevator"], "wind_down": everything_moves(regular(5.0))["wind_down"]},
    parameters={
        "gust.shape": ONE_MINUS_COSINE,
        "gust.gradient": 20.0,
        "gust.peak": 8.0,
        "gust.direction": 0.3,
        "turbulence.spectrum": VON_KARMAN,
        "turbulence.seed": 5,
        "actuator.elevator.frequency": 40.0,
        "actuator.elevator.rate_limit": 0.05,
        "engine.left.time_constant": 0.5,
    },
)
IRREGULAR = Flight("irregular steps", irregular(5.0), everything_moves(irregular(5.0)))


def ramped(flight):
    """The flight with inputs that run straight from point to point instead of in stairs."""
    rates = {
        name: np.append(np.diff(values) / np.diff(flight.time), 0.0) for name, values in flight.inputs.items()
    }
    return Flight(f"{flight.name}, ramped", flight.time, flight.inputs, rates, flight.parameters)


def deviation(history, reference):
    """The largest difference of any signal of the history, in parts of that signal's peak, and the signal's name."""
    found = {}
    for name in history.dtype.names if isinstance(history, np.ndarray) else history:
        expected, values = reference[name], np.asarray(history[name], dtype=float)
        assert values.shape == expected.shape, f"{name}: {values.shape} values instead of {expected.shape}"
        difference, peak = np.abs(values - expected).max(), np.abs(expected).max()
        assert np.isfinite(difference), name
        # Below 1e-6 of its unit a signal is rounding: the sideways motion in a symmetric flight.
        found[name] = difference / max(peak, 1e-6)
    worst = max(found, key=found.get)
    return found[worst], worst
