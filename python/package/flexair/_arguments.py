"""Arguments of a call as options of a command line: what they mean and allow is said there, once."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Union

import numpy as np
import numpy.typing as npt

from ._native import UsageError

File = Union[str, "os.PathLike[str]"]
Number = Union[int, float, np.integer, np.floating]
#: One number, several, or a text as the command takes it, such as "110:180:8".
Numbers = Union[Number, str, Sequence[Number], npt.NDArray[np.floating]]
#: Values of parameters of the FMU by their names, such as {"model": "rigid", "airspeed": 150}.
Parameters = Mapping[str, Union[Number, bool, str]]


#: What arguments may be by their names, in the units of the command; others are texts and paths.
ALLOWED = {
    "speed": "a number (m/s), several, or a text such as '110:180:8'",
    "altitude": "a number (m), several, or a text such as '0:9000:4'",
    "temperature_offset": "a number (K)",
    "gradients": "a number (m), several, or a text such as '10:100:10'",
    "load_factor": "a number, several, or a text such as '1:2:3'",
    "direction": "a number (degrees) or several",
    "weights": "three numbers of one unit: maximum take-off, landing and zero-fuel weight",
    "bank_angle": "a number (degrees)",
    "climb_angle": "a number (degrees)",
    "sideslip": "a number (degrees)",
    "from_": "a number (m/s)",
    "to": "a number (m/s)",
    "peak": "a number (m/s)",
    "duration": "a number (s)",
    "step": "a number (s)",
    "stiffness_scale": "a number",
    "structural_damping": "a number",
    "modes": "a whole number",
    "points": "a whole number",
    "gust_stations": "a whole number",
    "inflow_states": "a whole number",
    "output_names": "a text or several, at least one and none empty",
    "stations_along": "a mapping of components to whole numbers",
    "parameters": "a mapping of names to values",
    "binary": "a mapping of platforms to files",
}
TEXT = "a text or a path, not empty"
MAPPINGS = {"parameters", "stations_along", "binary"}
SWITCHES = {"turn", "pull_up", "ignore_limits", "load_modes", "all_states", "continuous", "no_scene", "no_check"}
#: Options that are called otherwise than their arguments.
ARGUMENTS = {"set": "parameters", "input": "inputs"}


class ArgumentTypeError(UsageError, TypeError):
    """An argument of a kind that is not allowed."""


class ArgumentValueError(UsageError, ValueError):
    """An argument that holds nothing where something is needed."""


def _is_truth(value: object) -> bool:
    if isinstance(value, np.ndarray):
        return bool(value.dtype == np.bool_)
    return isinstance(value, (bool, np.bool_))


def _refuse_truths(argument: str, value: object) -> None:
    """Refuse truth values where numbers or texts are needed, one or among several: to Python they are the numbers 1 and 0."""
    if _is_truth(value) or isinstance(value, list) and any(_is_truth(item) for item in value):
        raise ArgumentTypeError(f"{argument}: found {value!r}, allowed is {ALLOWED.get(argument, TEXT)}")


def _refuse_nothing(argument: str, value: object) -> None:
    """Refuse an empty text, or an empty list or one of empty texts."""
    if isinstance(value, list):
        is_empty = not value or any(isinstance(item, str) and not item.strip() for item in value)
    elif isinstance(value, np.ndarray):
        is_empty = value.size == 0
    else:
        is_empty = isinstance(value, (str, os.PathLike)) and not os.fspath(value).strip()
    if is_empty:
        raise ArgumentValueError(f"{argument}: found {value!r}, allowed is {ALLOWED.get(argument, TEXT)}")


def text(value: object) -> str:
    """A value as a command line has it; numbers with all their digits."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, (bool, np.bool_)):
        return str(bool(value)).lower()
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, Iterable):
        return ",".join(text(item) for item in value)
    raise UsageError(f"found {value!r}, allowed is a number, a text, a path, or several of them")


def path(argument: str, value: object) -> str:
    """The path or name that an argument is."""
    if not isinstance(value, (str, os.PathLike)):
        raise ArgumentTypeError(f"{argument}: found {value!r}, allowed is {TEXT}")
    _refuse_nothing(argument, value)
    return os.fspath(value)


def options(**values: object) -> list[str]:
    """Options by their names: a truth value is a switch, a mapping an option that is repeated, None none."""
    written: list[str] = []
    for name, value in values.items():
        option, argument = "--" + name.strip("_").replace("_", "-"), ARGUMENTS.get(name, name)
        if value is None:
            continue
        if name in SWITCHES:
            if not isinstance(value, (bool, np.bool_)):
                raise ArgumentTypeError(f"{argument}: found {value!r}, allowed is True or False")
            written += [option] if value else []
        elif isinstance(value, Mapping):
            written += [f"{option}={key}={_of_mapping(name, argument, key, item)}" for key, item in value.items()]
        elif argument in MAPPINGS:
            raise ArgumentTypeError(f"{argument}: found {value!r}, allowed is {ALLOWED.get(argument, TEXT)}")
        else:
            if isinstance(value, Iterable) and not isinstance(value, (str, np.ndarray)):
                value = list(value)
            _refuse_truths(argument, value)
            _refuse_nothing(argument, value)
            written.append(f"{option}={text(value)}")
    return written


def _of_mapping(name: str, argument: str, key: object, item: object) -> str:
    """A value of a mapping; parameters may be truth values, and say themselves what they allow."""
    if name != "set" and _is_truth(item):
        allowed = "a whole number" if argument == "stations_along" else TEXT
        raise ArgumentTypeError(f"{argument}, {key}: found {item!r}, allowed is {allowed}")
    return text(item)


def table(columns: Mapping[str, npt.ArrayLike]) -> bytes:
    """A table of inputs as the command reads it, of arrays by their names, the time first."""
    if "time" not in columns:
        raise UsageError(f"inputs: found {', '.join(columns)} without time (s), which arrays of inputs need")
    names = ["time", *(name for name in columns if name != "time")]
    arrays = [_column(name, columns[name]) for name in names]
    for name, array in zip(names, arrays):
        if array.shape != arrays[0].shape or array.ndim != 1:
            expected = f"one dimension and as many numbers as time has, {arrays[0].size}"
            raise UsageError(f"inputs, {name}: found an array of shape {array.shape}, allowed is {expected}")
    lines = [",".join(names), *(",".join(map(repr, row)) for row in np.column_stack(arrays).tolist())]
    return ("\n".join(lines) + "\n").encode()


def _column(name: str, given: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """The numbers of an input over time."""
    several: Iterable[object] = given if isinstance(given, Sequence) else ()
    if _is_truth(given) or any(_is_truth(item) for item in several):
        raise ArgumentTypeError(f"inputs, {name}: found truth values, allowed are numbers")
    array = np.atleast_1d(np.asarray(given, dtype=float))
    if array.size == 0:
        raise ArgumentValueError(f"inputs, {name}: found no numbers, allowed are one or more")
    return array
