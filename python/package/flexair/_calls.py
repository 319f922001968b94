"""The commands as functions. What their arguments mean is what the options of the same names do: `flexair trim --help`."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal, Union

import numpy.typing as npt

from . import _native
from ._arguments import File, Number, Numbers, Parameters, options, path, table
from ._data import DATA
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

#: Versions of FMI.
Fmi = Literal[2, 3]
#: Kinds of FMUs.
Kind = Literal["co-simulation", "model-exchange"]

#: The aircraft of all calls: the generic business jet.
JET = "generic-business-jet"


def _call(
    command: str, written: list[str], positional: Mapping[str, File], progress: bool, rows: bytes | None = None
) -> dict[str, Any]:
    arguments = [command, *written]
    if positional:
        arguments += ["--", *(path(argument, given) for argument, given in positional.items())]
    return _native.call(arguments, rows, DATA, progress)


def aircraft() -> dict[str, Path]:
    """The aircraft that come with the package, by the names that every call takes, and their files."""
    return dict(_native.aircraft(DATA))


def package(
    aircraft: File = JET,
    *,
    output: File | None = None,
    fmi: Fmi | Sequence[Fmi] = 2,
    kind: Kind | Sequence[Kind] = "co-simulation",
    modes: int | None = None,
    load_modes: bool = False,
    parameters: Parameters | None = None,
    stations_along: Mapping[str, int] | None = None,
    binary: Mapping[str, File] | None = None,
    scene: bool = True,
    check: bool = True,
    progress: bool = False,
) -> Packaged:
    """Write an aircraft as an FMU (`FlexibleAircraft.fmu`) with the libraries of all platforms, and prove by a flight that it works.

    `fmi` is the version of FMI, `kind` who integrates: the FMU ("co-simulation") or its importer ("model-exchange"). Of several, such
    as `fmi=[2, 3]`, there is an FMU for each pair: `output` is a folder then, and all are written or none. They are called
    `FlexibleAircraft.fmi3.fmu`, `FlexibleAircraft.me.fmu` and `FlexibleAircraft.fmi3.me.fmu`; the result is the first, with the `others`.

    `parameters` are where parameters of the FMU start, `stations_along` further stations (component: count), `binary` libraries
    in place of those that come with the package (platform: file). Without `scene` the documentation has no page on which the
    aircraft is seen in its trim and its modes, a quarter of a megabyte.
    """
    written = options(
        aircraft=aircraft,
        output=output,
        fmi=fmi,
        kind=kind,
        modes=modes,
        load_modes=load_modes,
        set=parameters,
        stations_along=stations_along,
        binary=binary,
        no_scene=not scene,
        no_check=not check,
    )
    answer = _call("package", written, {}, progress)
    rows = zip(answer["paths"], answer["sizes"], answer["flights"], answer["interfaces"])
    first, *others = (Packaged(Path(path), int(size), flight, interface) for path, size, flight, interface in rows)
    return replace(first, others=tuple(others))


def trim(
    aircraft: File = JET,
    *,
    speed: Numbers | None = None,
    altitude: Numbers | None = None,
    load_factor: Numbers | None = None,
    turn: bool = False,
    pull_up: bool = False,
    bank_angle: Number | None = None,
    climb_angle: Number | None = None,
    sideslip: Number | None = None,
    failed_engine: str | None = None,
    ignore_limits: bool = False,
    modes: int | None = None,
    load_modes: bool = False,
    parameters: Parameters | None = None,
    progress: bool = False,
) -> Trims:
    """Trim an aircraft in steady flight, at all combinations of speeds (m/s), altitudes (m) and load factors.

    Angles are degrees here, as on the command line, and rad in the result. Raises `Error` where nothing can be trimmed.
    """
    written = options(
        speed=speed,
        altitude=altitude,
        load_factor=load_factor,
        turn=turn,
        pull_up=pull_up,
        bank_angle=bank_angle,
        climb_angle=climb_angle,
        sideslip=sideslip,
        failed_engine=failed_engine,
        ignore_limits=ignore_limits,
        modes=modes,
        load_modes=load_modes,
        set=parameters,
    )
    return Trims(**_call("trim", written, {"aircraft": aircraft}, progress))


def describe(
    aircraft: File = JET,
    *,
    modes: int | None = None,
    load_modes: bool = False,
    parameters: Parameters | None = None,
) -> dict[str, Any]:
    """What an aircraft file describes: mass, balance, static margin, natural modes, and what is unusual, as the command writes it in JSON."""
    written = options(modes=modes, load_modes=load_modes, set=parameters)
    return dict(json.loads(_call("describe", written, {"aircraft": aircraft}, progress=False)["json"]))


def linearise(
    aircraft: File = JET,
    *,
    inflow: str = "keep",
    inputs: Literal["all", "controls"] = "all",
    all_states: bool = False,
    gust_stations: int | None = None,
    modes: int | None = None,
    load_modes: bool = False,
    parameters: Parameters | None = None,
) -> LinearModel:
    """A linear model about the trim with which a flight begins, for control laws, and its modes.

    `inflow` is "keep", "steady", which leaves the states of the wake out, or "balanced:N", which leaves N states of all;
    `gust_stations` are planes from nose to tail at which a gust is an input.
    """
    written = options(
        inflow=inflow,
        inputs=inputs,
        all_states=all_states,
        gust_stations=gust_stations,
        modes=modes,
        load_modes=load_modes,
        set=parameters,
    )
    answer = _call("linearise", written, {"aircraft": aircraft}, progress=False)
    found = answer.pop("modes")
    found["eigenvalues"] = found["eigenvalues"].ravel()
    if "error_bound" in answer:
        [answer["error_bound"]] = answer["error_bound"].tolist()
    return LinearModel(modes=Modes(**found), **answer)


def root_locus(
    aircraft: File = JET,
    *,
    speed: Numbers,
    inflow: Literal["keep", "steady"] = "keep",
    modes: int | None = None,
    load_modes: bool = False,
    parameters: Parameters | None = None,
    progress: bool = False,
) -> RootLocus:
    """The modes of an aircraft by their names, followed over airspeeds (m/s)."""
    written = options(speed=speed, inflow=inflow, modes=modes, load_modes=load_modes, set=parameters)
    answer = _call("linearise", written, {"aircraft": aircraft}, progress)
    answer["eigenvalue"] = answer["eigenvalue"].ravel()
    return RootLocus(**answer)


def simulate(
    aircraft: File = JET,
    *,
    inputs: File | Mapping[str, Union[str, npt.ArrayLike]] | None = None,
    duration: Number | None = None,
    step: Number | None = None,
    modes: int | None = None,
    load_modes: bool = False,
    parameters: Parameters | None = None,
    progress: bool = False,
) -> Flight:
    """Fly an aircraft: all outputs of the FMU over time.

    `inputs` are those of the FMU by their names: arrays over an array `time`, each number acting until the next, or shapes that
    are built in, such as {"elevator": "2311:-0.05@1:0.7"}; or the file of a table. Without a table it flies for `duration` (10 s),
    and every `step` (0.01 s) is a row.
    """
    positional: dict[str, File] = {}
    shapes: dict[str, str] = {}
    rows = None
    if isinstance(inputs, Mapping):
        shapes = {name: given for name, given in inputs.items() if isinstance(given, str)}
        arrays = {name: given for name, given in inputs.items() if not isinstance(given, str)}
        if arrays:
            rows, positional = table(arrays), {"inputs": "inputs"}
    elif inputs is not None:
        positional = {"inputs": inputs}
    written = options(
        aircraft=aircraft,
        input=shapes,
        duration=duration,
        step=step,
        modes=modes,
        load_modes=load_modes,
        set=parameters,
    )
    answer = _call("simulate", written, positional, progress, rows)
    names: list[str] = answer["names"]
    # Each over a memory of its own: whoever keeps one output keeps no more.
    outputs = {name: answer["values"][:, column].copy() for column, name in enumerate(names)}
    return Flight(outputs, dict(zip(names, answer["units"])))


def gust(
    aircraft: File = JET,
    *,
    gradients: Numbers | None = None,
    criterion: Literal["cs25_vc", "cs25_vd"] | None = None,
    peak: Number | None = None,
    direction: Numbers | None = None,
    weights: Sequence[Number] | None = None,
    output_names: Sequence[str] | None = None,
    duration: Number | None = None,
    step: Number | None = None,
    modes: int | None = None,
    load_modes: bool = False,
    parameters: Parameters | None = None,
    progress: bool = False,
) -> Gusts:
    """Fly an aircraft through one 1-cosine gust after the other, each in both senses.

    `gradients` are m (those of CS-25 unless given), `peak` m/s of true airspeed in place of a criterion, `direction` degrees,
    `weights` the maximum take-off, landing and zero-fuel weight, `output_names` outputs or the first parts of their names.
    """
    written = options(
        gradients=gradients,
        criterion=criterion,
        peak=peak,
        direction=direction,
        weights=weights,
        output_names=output_names,
        duration=duration,
        step=step,
        modes=modes,
        load_modes=load_modes,
        set=parameters,
    )
    return Gusts(**_call("gust", written, {"aircraft": aircraft}, progress))


def turbulence(
    aircraft: File = JET,
    *,
    direction: Numbers | None = None,
    criterion: Literal["cs25_vc", "cs25_vd"] | None = None,
    weights: Sequence[Number] | None = None,
    output_names: Sequence[str] | None = None,
    modes: int | None = None,
    load_modes: bool = False,
    parameters: Parameters | None = None,
) -> Turbulence:
    """What continuous turbulence does to an aircraft, by its linear model: root mean squares, and limits by CS 25.341(b).

    `direction` is degrees, 0 upwards, 90 to the right, and from 0 to less than 180 in the result: opposite ones are one; spectrum and scale are `parameters` (turbulence.spectrum, turbulence.scale).
    """
    written = options(
        continuous=True,
        direction=direction,
        criterion=criterion,
        weights=weights,
        output_names=output_names,
        modes=modes,
        load_modes=load_modes,
        set=parameters,
    )
    return Turbulence(**_call("gust", written, {"aircraft": aircraft}, progress=False))


def flutter(
    aircraft: File = JET,
    *,
    from_: Number,
    to: Number,
    points: int | None = None,
    altitude: Number | None = None,
    temperature_offset: Number | None = None,
    stiffness_scale: Number | None = None,
    structural_damping: Number | None = None,
    model: str | None = None,
    mode_family: Literal["all", "symmetric"] | None = None,
    inflow_states: int | None = None,
    modes: int | None = None,
    load_modes: bool = False,
    progress: bool = False,
) -> Flutter:
    """Find the airspeeds (m/s) from one to another at which an aircraft flutters or diverges, and its roots there."""
    written = options(
        from_=from_,
        to=to,
        points=points,
        altitude=altitude,
        temperature_offset=temperature_offset,
        stiffness_scale=stiffness_scale,
        structural_damping=structural_damping,
        model=model,
        mode_family=mode_family,
        inflow_states=inflow_states,
        modes=modes,
        load_modes=load_modes,
    )
    answer = _call("flutter", written, {"aircraft": aircraft}, progress)
    found = answer.pop("crossings")
    names = list(found)
    values = zip(*(column if isinstance(column, list) else column.tolist() for column in found.values()))
    return Flutter(crossings=[Crossing(**dict(zip(names, row))) for row in values], **answer)
