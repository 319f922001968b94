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


def options(**values: object) -> list[str]:
    """Options by their names: a truth value is a switch, a mapping an option that is repeated, None none."""
    written: list[str] = []
    for name, value in values.items():
        option = "--" + name.strip("_").replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            written.append(option)
        elif isinstance(value, Mapping):
            written += [f"{option}={key}={text(item)}" for key, item in value.items()]
        else:
            written.append(f"{option}={text(value)}")
    return written


def table(columns: Mapping[str, npt.ArrayLike]) -> bytes:
    """A table of inputs as the command reads it, of arrays by their names, the time first."""
    if "time" not in columns:
        raise UsageError(f"inputs: found {', '.join(columns)} without time (s), which arrays of inputs need")
    names = ["time", *(name for name in columns if name != "time")]
    arrays = [np.atleast_1d(np.asarray(columns[name], dtype=float)) for name in names]
    for name, array in zip(names, arrays):
        if array.shape != arrays[0].shape or array.ndim != 1:
            expected = f"one dimension and as many numbers as time has, {arrays[0].size}"
            raise UsageError(f"inputs, {name}: found an array of shape {array.shape}, allowed is {expected}")
    lines = [",".join(names), *(",".join(map(repr, row)) for row in np.column_stack(arrays).tolist())]
    return ("\n".join(lines) + "\n").encode()
