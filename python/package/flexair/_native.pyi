"""The native part: see python/src/lib.rs."""

import os
from pathlib import Path
from typing import Any

class Error(Exception):
    """What was asked for cannot be done; the message is that of the command."""

class UsageError(Error):
    """The arguments are not right; the message is that of the command line."""

def command(arguments: list[str], data: str | os.PathLike[str]) -> int:
    """Do what a command line asks for, the program's name first, and return what it should end with."""

def call(
    arguments: list[str], table: bytes | None, data: str | os.PathLike[str], progress: bool
) -> dict[str, Any]:
    """What a command finds, by names."""

def aircraft(data: str | os.PathLike[str]) -> list[tuple[str, Path]]:
    """The names of the aircraft that come with the package, and their files."""
