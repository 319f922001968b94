"""Nonlinear flight dynamics of flexible aircraft: trims, linear models, flights, gusts, turbulence, flutter, and FMUs for simulation tools.

    import flexair

    model = flexair.linearise("generic-business-jet", inflow="steady")
    flight = flexair.simulate(inputs={"elevator": "2311:-0.05@1:0.7"}, duration=15)
    flexair.package("my-aircraft.toml", output="my-aircraft.fmu")

An aircraft is the path of a file or a name of `flexair.aircraft()`. Functions do what the commands of the same names do, and
raise `flexair.Error` with the message of the command; a truth value for a number, or nothing where something is needed, is a `TypeError`
or `ValueError` too. Other threads run meanwhile; Ctrl-C ends a call.
"""

from ._calls import aircraft, describe, flutter, gust, linearise, package, root_locus, simulate, trim, turbulence
from ._native import Error, UsageError
from ._results import (
    Crossing,
    Flight,
    Flutter,
    Gusts,
    LinearModel,
    Modes,
    Packaged,
    RootLocus,
    Trims,
    Turbulence,
)

__all__ = [
    "Crossing",
    "Error",
    "Flight",
    "Flutter",
    "Gusts",
    "LinearModel",
    "Modes",
    "Packaged",
    "RootLocus",
    "Trims",
    "Turbulence",
    "UsageError",
    "aircraft",
    "describe",
    "flutter",
    "gust",
    "linearise",
    "package",
    "root_locus",
    "simulate",
    "trim",
    "turbulence",
]
