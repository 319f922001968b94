"""What calls return: arrays of NumPy with their names and units, in SI units and radians."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Packaged:
    """An FMU that was written."""

    path: Path
    #: Bytes.
    size: int
    #: What a short flight of it showed; empty where none was asked for.
    flight: str
    #: What importers take it as, such as "FMI 2.0 co-simulation".
    interface: str
    #: Those written beside it, where several were asked for.
    others: tuple[Packaged, ...] = ()


@dataclass(frozen=True)
class Trims:
    """Trims, a point after another: load factor after load factor, in each altitude after altitude, in each speed after speed."""

    #: Of each point the axes and what its trim consists of, by names; NaN where there is no trim.
    columns: dict[str, Array]
    #: The units of the columns.
    units: dict[str, str]
    #: Of each point "ok", "beyond_limits" or "no_trim".
    status: list[str]
    #: Of each point why it is not trimmed; empty where it is.
    messages: list[str]
    #: Of each point what it is beyond and stands all the same.
    warnings: list[str]

    def __getitem__(self, name: str) -> Array:
        """A column."""
        return self.columns[name]


@dataclass(frozen=True)
class Modes:
    """The modes of an aircraft in flight by their names, slowest first, and its flying qualities (NaN where there are none).

    They are those of the aircraft itself, before any reduction, without actuators and engines that lag.
    """

    #: "phugoid", "short period", "Dutch roll", "roll", "spiral", "altitude", "elastic 1", …
    names: list[str]
    #: "symmetric", "antisymmetric", or nothing where a mode is both.
    families: list[str]
    #: 1/s; of a pair the upper one.
    eigenvalues: npt.NDArray[np.complex128]
    #: Of critical damping; NaN of real roots.
    damping_ratios: Array
    #: Of each mode whether its eigenvalue is that of an inflow that follows at once, for with its own it is lost among the wake's.
    quasi_steady: npt.NDArray[np.bool_]
    #: n/alpha of the control for pitch, 1/rad.
    load_factor_per_alpha: float
    #: Squared frequency of the short period by n/alpha, 1/s².
    control_anticipation: float
    #: s.
    roll_time_constant: float

    def __getitem__(self, name: str) -> complex:
        """The eigenvalue of a mode."""
        return complex(self.eigenvalues[self.names.index(name)])


@dataclass(frozen=True)
class RootLocus:
    """The modes of an aircraft over airspeed: a row for each mode at each airspeed."""

    #: m/s.
    airspeed: Array
    #: Names, followed over airspeed.
    mode: list[str]
    #: "symmetric", "antisymmetric", or nothing where a mode is both.
    family: list[str]
    #: 1/s; of a pair the upper one.
    eigenvalue: npt.NDArray[np.complex128]
    quasi_steady: npt.NDArray[np.bool_]


@dataclass(frozen=True)
class LinearModel:
    """x' = A x + B u + Bd u' and y = C x + D u + Dd u' for departures from x0, u0 and y0.

    Bd and Dd are those of the wind alone, whose rate acts on the apparent mass. Labels are the names in letters, digits
    and underscores, each once among inputs and outputs, for tools that need words, as python-control does.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    Bd: Array
    Dd: Array
    x0: Array
    u0: Array
    y0: Array
    x_names: list[str]
    x_units: list[str]
    u_names: list[str]
    u_units: list[str]
    y_names: list[str]
    y_units: list[str]
    x_labels: list[str]
    u_labels: list[str]
    y_labels: list[str]
    modes: Modes
    #: Where the planes of `gust_stations` are, m ahead of O.
    gust_planes: Array | None = None
    #: Of a reduced model: by how much its outputs are wrong at most, parts of their scales for inputs of theirs.
    error_bound: float | None = None


class Flight(dict[str, Array]):
    """A flight: `time` (s) and every output of the FMU over it, by names."""

    def __init__(self, outputs: dict[str, Array], units: dict[str, str]) -> None:
        super().__init__(outputs)
        #: The units of the outputs.
        self.units = units


@dataclass(frozen=True)
class Gusts:
    """What gusts did to outputs. Matrices have a row for each gust and a column for each output."""

    #: The outputs.
    names: list[str]
    units: list[str]
    #: Each output before any gust.
    trim: Array
    #: Of each gust: gradient (m), direction (degrees, 0 upwards, 90 to the right) and peak (m/s of true airspeed).
    gradient: Array
    direction: Array
    peak: Array
    #: The least and the greatest of each output in each gust, and when (s).
    least: Array
    least_time: Array
    greatest: Array
    greatest_time: Array
    #: Gusts that could not be flown to the end, with the reason; they have no row.
    failures: list[str]


@dataclass(frozen=True)
class Turbulence:
    """What continuous turbulence does to outputs. Matrices have a row for each direction and a column for each output."""

    #: The outputs.
    names: list[str]
    units: list[str]
    #: Each output in still air.
    trim: Array
    #: Degrees, 0 upwards, 90 to the right.
    direction: Array
    #: Root mean squares by that of the turbulence, per m/s.
    rms: Array
    #: How often each output crosses its mean upwards, Hz.
    crossings: Array
    #: U_sigma of CS 25.341(b), m/s of true airspeed.
    velocity: float
    #: Limits: the trim less and more U_sigma times the root mean square.
    least: Array
    greatest: Array
    #: Of what makes the numbers doubtful: a trim beyond a limit, an unstable aircraft, sums that are not exact.
    warnings: list[str]


@dataclass(frozen=True)
class Crossing:
    """Where a root crosses the imaginary axis."""

    #: m/s.
    airspeed: float
    #: rad/s; 0 of a divergence.
    frequency: float
    #: "flutter" or "divergence".
    kind: str
    #: Whether the root is unstable above, not below.
    is_onset: bool
    #: Its row among the eigenvalues.
    root: int
    #: The motions that make it up.
    motion: str


@dataclass(frozen=True)
class Flutter:
    """The roots of the linearised motion over airspeed."""

    #: Those analysed, m/s.
    airspeeds: Array
    #: What each root begins as.
    roots: list[str]
    #: 1/s; a row for each root, a column for each airspeed, NaN where the root is not. Of a pair the upper one.
    eigenvalues: npt.NDArray[np.complex128]
    #: By airspeed.
    crossings: list[Crossing]
    #: Airspeeds without a trim, m/s, and why.
    skipped: Array
    skipped_because: list[str]
    #: Trims that stand beyond a limit.
    warnings: list[str]
    #: As the command prints it.
    report: str
