"""Nonlinear flight dynamics of flexible aircraft: trims, linear models, flights, gusts, flutter, and FMUs for simulation tools.

    import flexair

    model = flexair.linearise("generic-business-jet", inflow="steady")
    flight = flexair.simulate(inputs={"elevator": "2311:-0.05@1:0.7"}, duration=15)
    flexair.package("my-aircraft.toml", output="my-aircraft.fmu")

An aircraft is the path of a file or a name of `flexair.aircraft()`. Functions do what the commands of the same names do, and
raise `flexair.Error` with the message of the command. Other threads run meanwhile; Ctrl-C ends a call.
"""

from ._calls import aircraft, flutter, gust, linearise, package, simulate, trim
from ._native import Error, UsageError
from ._results import Crossing, Flight, Flutter, Gusts, LinearModel, Packaged, Trims

__all__ = [
    "Crossing",
    "Error",
    "Flight",
    "Flutter",
    "Gusts",
    "LinearModel",
    "Packaged",
    "Trims",
    "UsageError",
    "aircraft",
    "flutter",
    "gust",
    "linearise",
    "package",
    "simulate",
    "trim",
]
