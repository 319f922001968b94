"""Input signals as FMPy takes them: the manoeuvres of [5.2] behind the actuator, a first-order lag."""

import numpy as np

LAG = 0.05  # s


def lagged_steps(time, jumps):
    """Answer of 1/(LAG s + 1) to a sum of steps, given as pairs of time and height."""
    return sum(height * np.where(time > at, -np.expm1((at - time) / LAG), 0.0) for at, height in jumps)


def two_three_one_one(time, amplitude, unit=0.7, start=1.0):
    """Pulses of 2, 3, 1 and 1 unit times and alternating sign."""
    ends = start + unit * np.cumsum([0, 2, 3, 1, 1])
    return lagged_steps(time, zip(ends, amplitude * np.array([1, -2, 2, -2, 1])))


def doublet(time, amplitude, duration=2.0, start=1.0):
    """A pulse and its opposite."""
    ends = start + duration * np.arange(3)
    return lagged_steps(time, zip(ends, amplitude * np.array([1, -2, 1])))


def signal(stop_time, **columns):
    """The structured array that FMPy wants, from functions of time by variable name; a value each 10 ms."""
    time = np.linspace(0.0, stop_time, round(stop_time / 0.01) + 1)
    names = ["time", *columns]
    values = np.zeros(len(time), dtype=[(name, np.float64) for name in names])
    values["time"] = time
    for name, value in columns.items():
        values[name] = value(time)
    return values
